"""Whether the numbers of a drawing are clear of rounding: no lines so blunt, no distance so short, that a few of them
together leave nothing of a result. It is a cheap look, made at every position; where it finds anything the running
bound of ``batch.error_bounds`` says of which results digits are left.
"""

import math
from collections.abc import Iterable, Mapping
from functools import reduce

from planes.drafting.program import Program
from planes.drafting.steps import Through
from planes.drafting.steps.crossings import Touch
from planes.drafting.steps.reckoning import Sense
from planes.drafting.steps.tracks import CutTrack
from planes.drafting.tools import Thing, Tool
from planes.geometry.arithmetic import Real, Truth
from planes.geometry.plane import square
from planes.words.names import Meaning, kind_of, plan_of

BLUNT, CLEAR = 0.1, 0.01
"""A sharpness of ``BLUNT`` takes nothing away; all together may leave no less than ``CLEAR`` of it. An acceleration
errs by some 5e-15 over the third power of a sharpness: where lines of one group meet at 1e-3, by less than 1e-5."""
NOTHING = 4e-15  # beside the largest of a plan: what rounding may have made of nothing, or nothing of
CERTAIN = 1e-12  # beside the largest speed: which way a slower thing goes rounding may have made
FAR = 1e6  # lengths as many times longer than the shortest: digits go where no line is blunt
_AGAIN = ("velocity", "motion", "acceleration", "lever")  # plans whose lines are those of the scheme


def clear(program: Program, things: Mapping[str, Thing], tool: Tool, sides: Iterable[tuple[str, str]] = ()) -> Truth:
    """Whether a drawing is clear: of one position, of many, or on a tape; and no force of ``sides`` (start, end) is
    nothing beside the largest of its plan."""
    ar, scheme, forces = tool.ar, 1.0, 1.0
    for name, sharpness in _apart(program, tool).items():
        plan = kind_of(plan_of(name))
        if plan == "force" and name not in program.trials:
            forces = ar.minimum(forces, sharpness)
        elif plan not in (*_AGAIN, "force"):
            scheme = scheme * ar.minimum(1.0, sharpness / BLUNT)
    ok: Truth = (scheme >= CLEAR) & (forces >= BLUNT * CLEAR)
    rays = (s for s in program.steps if isinstance(s, Touch | Through) and s.makes not in program.vanishing)
    for step in rays:
        if kind_of(plan_of(step.start)) not in _AGAIN:
            one, two = things[step.start], things[step.end]
            apart, size = square(two - one), square(one) + square(two)
            ok = ok & ((apart >= (BLUNT * CLEAR) ** 2 * size) | (apart == 0))
    for sense in (s for s in program.steps if isinstance(s, Sense)):
        length, largest = sense.weighed(things, ar)
        ok = ok & ((abs(length) > CERTAIN * largest) | (abs(length) <= tool.still * largest))
    return ok & _none_faint(program, things, tool, sides)


def _apart(program: Program, tool: Tool) -> dict[str, Real]:
    """The sharpness of every mark, once of those that are cut by the same settled link."""
    cut = {s.makes: s.holds for s in program.steps if isinstance(s, CutTrack)}
    first = {holds: name for name, holds in reversed(cut.items())}
    return {n: sharp for n, sharp in tool.sharpness.items() if n not in cut or first[cut[n]] == n}


def _none_faint(program: Program, things: Mapping[str, Thing], tool: Tool, sides: Iterable[tuple[str, str]]) -> Truth:
    """Whether no force is nothing, or next to nothing, beside others."""
    ar, ok, largest = tool.ar, True, dict[str, Real]()
    for start, end in sides:
        plan = plan_of(start)
        if plan not in largest:
            largest[plan] = reduce(ar.maximum, (ar.size(things[s.makes]) for s in program.marks.get(plan, ())), 0.0)
        size = ar.size(things[end] - things[start])
        ok = ok & ((size > NOTHING * largest[plan]) | (largest[plan] == 0))
    return ok


def far_apart(given: Mapping[str, Thing], means: Mapping[str, Meaning]) -> bool:
    """Whether given lengths of a mechanism are of such different sizes that no position is clear."""
    sizes = [(means[n].quantity, abs(v)) for n, v in given.items() if n in means]
    longest = max((size for what, size in sizes if what in ("length", "offset", "place")), default=0.0)
    return longest > FAR * min((size for what, size in sizes if what == "length" and size), default=math.inf)
