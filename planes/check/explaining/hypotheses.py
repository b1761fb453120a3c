"""Possible drawings: the mistakes of the catalogue, each step with a free size, the whole plan transformed."""

import math
from collections.abc import Iterator

import numpy

from planes.check.explaining.plan_lines import Hypothesis, PlanLines
from planes.check.explaining.weights import (
    ANOTHER,
    COSTS,
    GRID_MM,
    LEAST_MM,
    LONG_MM,
    LONGER,
    LONGEST_MM,
    REACH_MM,
    SHORT_MM,
    SHORTER_MM,
    STEP_MM,
)
from planes.words.frozen import replace
from planes.words.names import POLE

Free = tuple[str, str, complex]
"""A free size: kind, mark, and displacement of the mark (mm)."""
SMALLEST_PLAN_MM, SHEET_MM = 30.0, 420.0  # a larger plan is weighed no more finely than one on an A3 sheet
SCALES = 1.7, 1.2  # of a whole plan: logarithm of the largest, steps in mm at its rim
PRINTERS = 0.9, 1.06  # a plan within this range of sizes may be due to its printer
WAYS_DIFFER = 0.17  # sine of the angle between different directions


def catalogue(plan: PlanLines) -> list[Hypothesis]:
    """The mistakes of the catalogue."""
    return [
        Hypothesis(v.mistake, v.blames, COSTS["catalogue"] - 0.5 * math.log(v.weight), v) for v in plan.bench.mistakes
    ]


def wholes(plan: PlanLines) -> list[Hypothesis]:
    """The whole plan mirrored, turned, or at a scale that no printer produces."""
    if plan.kind == "position":
        return []
    reach = min(max(SMALLEST_PLAN_MM, *map(abs, plan.true.values())), SHEET_MM)
    small = STEP_MM * numpy.arange(3, 40) / reach
    top, step = SCALES
    sizes = [k for k in numpy.exp(numpy.arange(-top, top, step / reach)).tolist() if not PRINTERS[0] < k < PRINTERS[1]]
    turns = [complex(t) for t in (1j, -1, -1j, *numpy.exp(1j * small), *numpy.exp(-1j * small))]
    free = not plan.held and _of_many_ways(plan)  # with one direction, whole plan and first length are the same
    scaled = [] if not free else [Hypothesis("scaled", "", COSTS["whole"], turn=k + 0j) for k in sizes]
    turned = [] if not free else [Hypothesis("turned_whole", "", COSTS["whole"], turn=t) for t in turns]
    mirrors = [Hypothesis("mirrored", "", COSTS["whole"], turn=t, mirrored=True) for t in (1 + 0j, -1 + 0j)]
    return [*mirrors, *turned, *scaled]


def _of_many_ways(plan: PlanLines) -> bool:
    """Whether the longer lines of a plan have more than one direction."""
    a, b = plan.ends_of(plan.true)
    ways = (b - a)[plan.needed]
    ways = ways[abs(ways) > LONG_MM]
    return bool(len(ways)) and bool((abs((ways / ways[0]).imag) > WAYS_DIFFER * abs(ways / ways[0])).any())


def free_sizes(plan: PlanLines, base: Hypothesis) -> list[Free]:
    """Every mark of a drawing with a wrong length or angle, or anywhere near."""
    if (drawn := plan.drawn(base)) is None:
        return []
    places = dict(zip(plan.names, drawn[0].tolist(), strict=True))
    fixed = plan.bench.plans.mechanism.frame.points if plan.kind == "position" else ()
    return [one for mark in plan.names[:-1] if mark not in fixed for one in _of_mark(plan, places, mark)]


def _of_mark(plan: PlanLines, places: dict[str, complex], mark: str) -> Iterator[Free]:
    starts = [s for s, e in plan.lines if e == mark]
    starts += [e for s, e in plan.lines if s == mark and plan.kind == "position"]
    for start in dict.fromkeys(starts):
        v = places[mark] - places[start]
        if abs(v) < SHORT_MM or (start != POLE and plan.names.index(start) > plan.names.index(mark)):
            continue
        low, high = min(LONGER * abs(v), SHORTER_MM), min(LONGER * abs(v) + LEAST_MM * 5, LONGEST_MM)
        along = numpy.arange(-low, high, STEP_MM)
        yield from (("length", mark, z) for z in (along[abs(along) > LEAST_MM] * v / abs(v)).tolist())
        arc = numpy.arange(LEAST_MM / abs(v), math.pi, STEP_MM / min(abs(v), SHEET_MM))
        yield from (("turned", mark, z) for z in (v * (numpy.exp(1j * numpy.r_[arc, -arc]) - 1)).tolist())
    grid = numpy.arange(-REACH_MM, REACH_MM + 1, GRID_MM)
    around = (grid[:, None] + 1j * grid).ravel()
    yield from (("anywhere", mark, z) for z in around[(abs(around) > LEAST_MM) & (abs(around) < REACH_MM)].tolist())


def with_size(plan: PlanLines, base: Hypothesis, size: Free) -> Hypothesis:
    """A hypothesis with one mark moved; of two mistakes the earlier one is blamed."""
    kind, mark, moved = size
    nudges, cost = {**base.nudges, mark: base.nudges.get(mark, 0j) + moved}, base.cost + COSTS[kind]
    if base.right:
        return replace(base, kind=kind, mark=mark, cost=cost, nudges=nudges)
    first = min((m for m in (base.mark, mark) if m), key=plan.names.index)
    return replace(base, kind=f"{base.kind}+{kind}", mark=first, cost=cost + ANOTHER, nudges=nudges)
