"""Whether the numbers of a drawing are clear of rounding: no lines that cross so bluntly, no distance so short, that a
few of them together destroy a result. It is a cheap check, made at every position; where it fails, the running bound of
``batch.error_bounds`` shows which results have digits left."""

import math
from collections.abc import Iterable, Mapping
from functools import reduce

from planes.drafting.program import Program
from planes.drafting.steps import Through
from planes.drafting.steps.crossings import Touch
from planes.drafting.steps.reckoning import Sense
from planes.drafting.steps.tracks import TrackStep
from planes.drafting.tools import Things, Tool
from planes.geometry.arithmetic import Real, Truth
from planes.geometry.plane import squared_length
from planes.words.names import MarkPair, Meaning, plan_of

BLUNT_SHARPNESS = 0.1
LEAST_CLEAR_SHARPNESS = 0.01
"""A sharpness of ``BLUNT`` or more costs no digits; the product of all must be at least ``CLEAR`` of that. The error of
an acceleration is about 5e-15 over the third power of a sharpness: where lines of one group meet at 1e-3, less than
1e-5."""
# of the largest on a plan: below this, rounding may turn zero into a value or a value into zero
ZERO_FORCE_RATIO = 4e-15
LEAST_CERTAIN_SPEED_RATIO = 1e-12  # of the largest speed: below this, rounding may reverse the sense of a slower motion
# ratio of the longest length to the shortest: above it digits are lost although no line is blunt
MOST_LENGTH_RATIO = 1e6
# plans with the same lines as the scheme
_PLANS_REPEATING_SCHEME_LINES = ("velocity", "motion", "acceleration", "lever")


def is_clear_drawing(program: Program, things: Things, tool: Tool, sides: Iterable[MarkPair] = ()) -> Truth:
    """Whether a drawing is clear, for one position, for many, or on a tape; and no force of ``sides`` (start, end)
    vanishes beside the largest of its plan."""
    ar = tool.ar
    scheme = 1.0
    forces = 1.0
    for name, sharpness in _sharpness_of_marks(program, tool).items():
        plan = plan_of(name).kind
        if plan == "force" and name not in program.trial_marks:
            forces = ar.minimum(forces, sharpness)
        elif plan not in (*_PLANS_REPEATING_SCHEME_LINES, "force"):
            scheme = scheme * ar.minimum(1.0, sharpness / BLUNT_SHARPNESS)
    ok: Truth = (scheme >= LEAST_CLEAR_SHARPNESS) & (forces >= BLUNT_SHARPNESS * LEAST_CLEAR_SHARPNESS)
    rays = (s for s in program.steps if isinstance(s, Touch | Through) and s.makes not in program.vanishing_directions)
    for step in rays:
        if step.start.plan.kind not in _PLANS_REPEATING_SCHEME_LINES:
            one = things[step.start]
            two = things[step.end]
            apart = squared_length(two - one)
            size = squared_length(one) + squared_length(two)
            ok = ok & ((apart >= (BLUNT_SHARPNESS * LEAST_CLEAR_SHARPNESS) ** 2 * size) | (apart == 0))
    for sense in (s for s in program.steps if isinstance(s, Sense)):
        length, largest = sense.length_and_farthest_distance(things, ar)
        ok = ok & ((abs(length) > LEAST_CERTAIN_SPEED_RATIO * largest) | (abs(length) <= tool.still * largest))
    return ok & _no_force_vanishes(program, things, tool, sides)


def _sharpness_of_marks(program: Program, tool: Tool) -> dict[str, Real]:
    """The sharpness of every mark; marks cut by the same settled link count once."""
    cut = {s.makes: s.holds for s in program.steps if isinstance(s, TrackStep)}
    first = {holds: name for name, holds in reversed(cut.items())}
    return {n: sharp for n, sharp in tool.sharpness.items() if n not in cut or first[cut[n]] == n}


def _no_force_vanishes(program: Program, things: Things, tool: Tool, sides: Iterable[MarkPair]) -> Truth:
    """Whether no force vanishes, or nearly so, beside others."""
    ar = tool.ar
    ok = True
    largest = {}
    for start, end in sides:
        plan = start.plan
        if plan not in largest:
            largest[plan] = reduce(ar.maximum, (ar.size(things[s.makes]) for s in program.mark_steps_on(plan)), 0.0)
        size = ar.size(things[end] - things[start])
        ok = ok & ((size > ZERO_FORCE_RATIO * largest[plan]) | (largest[plan] == 0))
    return ok


def has_wide_length_range(given: Things, means: Mapping[str, Meaning]) -> bool:
    """Whether the given lengths of a mechanism differ so much that no position is clear."""
    sizes = [(means[n].quantity, abs(v)) for n, v in given.items() if n in means]
    longest = max((size for what, size in sizes if what in ("length", "offset", "place")), default=0.0)
    return longest > MOST_LENGTH_RATIO * min(
        (size for what, size in sizes if what == "length" and size), default=math.inf
    )
