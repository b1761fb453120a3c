"""Possible drawings: the mistakes of the catalogue, each step with a free size, the whole plan transformed."""

import math
from collections.abc import Iterator

import numpy

from planes.check.explaining.plan_lines import Hypothesis, PlanLines
from planes.check.explaining.weights import (
    DISPLACEMENT_GRID_MM,
    DISPLACEMENT_STEP_MM,
    HYPOTHESIS_COSTS,
    LEAST_DISPLACEMENT_MM,
    MOST_DISPLACEMENT_MM,
    MOST_LENGTH_ERROR_SHARE,
    MOST_LENGTHENING_MM,
    MOST_SHORTENING_MM,
    SECOND_MISTAKE_COST,
    SHORTEST_LINE_MM,
    VISIBLE_LINE_MM,
)
from planes.check.grading.paper import MarkPlaces
from planes.words.frozen import replace
from planes.words.names import POLE_LABEL

Free = tuple[str, str, complex]
"""A free size: kind, mark, and displacement of the mark (mm)."""
LEAST_PLAN_REACH_MM, MOST_PLAN_REACH_MM = 30.0, 420.0  # a larger plan is weighed no more finely than one on an A3 sheet
PLAN_SCALE_LOG_AND_STEP_MM = 1.7, 1.2  # of a whole plan: logarithm of the largest, steps in mm at its rim
PRINTER_SCALE_RANGE = 0.9, 1.06  # a plan within this range of sizes may be due to its printer
LEAST_DIRECTION_SINE = 0.17  # sine of the angle between different directions


def catalogue_hypotheses(plan: PlanLines) -> list[Hypothesis]:
    """The mistakes of the catalogue."""
    return [
        Hypothesis(v.mistake, v.blames, HYPOTHESIS_COSTS["catalogue"] - 0.5 * math.log(v.weight), v)
        for v in plan.bench.mistakes
    ]


def transformed_plan_hypotheses(plan: PlanLines) -> list[Hypothesis]:
    """The whole plan mirrored, turned, or at a scale that no printer produces."""
    if plan.kind == "position":
        return []
    reach = min(max(LEAST_PLAN_REACH_MM, *map(abs, plan.true.values())), MOST_PLAN_REACH_MM)
    small = DISPLACEMENT_STEP_MM * numpy.arange(3, 40) / reach
    top, step = PLAN_SCALE_LOG_AND_STEP_MM
    sizes = [
        k
        for k in numpy.exp(numpy.arange(-top, top, step / reach)).tolist()
        if not PRINTER_SCALE_RANGE[0] < k < PRINTER_SCALE_RANGE[1]
    ]
    turns = [complex(t) for t in (1j, -1, -1j, *numpy.exp(1j * small), *numpy.exp(-1j * small))]
    free = not plan.held and _has_several_directions(
        plan
    )  # with one direction, whole plan and first length are the same
    scaled = [] if not free else [Hypothesis("scaled", "", HYPOTHESIS_COSTS["whole"], turn=k + 0j) for k in sizes]
    turned = [] if not free else [Hypothesis("turned_whole", "", HYPOTHESIS_COSTS["whole"], turn=t) for t in turns]
    mirrors = [Hypothesis("mirrored", "", HYPOTHESIS_COSTS["whole"], turn=t, mirrored=True) for t in (1 + 0j, -1 + 0j)]
    return [*mirrors, *turned, *scaled]


def _has_several_directions(plan: PlanLines) -> bool:
    """Whether the longer lines of a plan have more than one direction."""
    a, b = plan.ends_of(plan.true)
    ways = (b - a)[plan.needed]
    ways = ways[abs(ways) > VISIBLE_LINE_MM]
    return bool(len(ways)) and bool((abs((ways / ways[0]).imag) > LEAST_DIRECTION_SINE * abs(ways / ways[0])).any())


def trial_displacements(plan: PlanLines, base: Hypothesis) -> list[Free]:
    """Every mark of a drawing with a wrong length or angle, or anywhere near."""
    if (drawn := plan.drawn(base)) is None:
        return []
    places = dict(zip(plan.names, drawn[0].tolist(), strict=True))
    fixed = plan.bench.plans.mechanism.frame.points if plan.kind == "position" else ()
    return [one for mark in plan.names[:-1] if mark not in fixed for one in _trial_displacements_of(plan, places, mark)]


def _trial_displacements_of(plan: PlanLines, places: MarkPlaces, mark: str) -> Iterator[Free]:
    starts = [s for s, e in plan.lines if e == mark]
    starts += [e for s, e in plan.lines if s == mark and plan.kind == "position"]
    for start in dict.fromkeys(starts):
        v = places[mark] - places[start]
        if abs(v) < SHORTEST_LINE_MM or (start != POLE_LABEL and plan.names.index(start) > plan.names.index(mark)):
            continue
        low = min(MOST_LENGTH_ERROR_SHARE * abs(v), MOST_SHORTENING_MM)
        high = min(MOST_LENGTH_ERROR_SHARE * abs(v) + LEAST_DISPLACEMENT_MM * 5, MOST_LENGTHENING_MM)
        along = numpy.arange(-low, high, DISPLACEMENT_STEP_MM)
        yield from (("length", mark, z) for z in (along[abs(along) > LEAST_DISPLACEMENT_MM] * v / abs(v)).tolist())
        arc = numpy.arange(
            LEAST_DISPLACEMENT_MM / abs(v), math.pi, DISPLACEMENT_STEP_MM / min(abs(v), MOST_PLAN_REACH_MM)
        )
        yield from (("turned", mark, z) for z in (v * (numpy.exp(1j * numpy.r_[arc, -arc]) - 1)).tolist())
    grid = numpy.arange(-MOST_DISPLACEMENT_MM, MOST_DISPLACEMENT_MM + 1, DISPLACEMENT_GRID_MM)
    around = (grid[:, None] + 1j * grid).ravel()
    yield from (
        ("anywhere", mark, z)
        for z in around[(abs(around) > LEAST_DISPLACEMENT_MM) & (abs(around) < MOST_DISPLACEMENT_MM)].tolist()
    )


def with_mark_displaced(plan: PlanLines, base: Hypothesis, size: Free) -> Hypothesis:
    """A hypothesis with one mark moved; of two mistakes the earlier one is blamed."""
    kind, mark, moved = size
    nudges = {**base.nudges, mark: base.nudges.get(mark, 0j) + moved}
    cost = base.cost + HYPOTHESIS_COSTS[kind]
    if base.is_right:
        return replace(base, kind=kind, mark=mark, cost=cost, nudges=nudges)
    first = min((m for m in (base.mark, mark) if m), key=plan.names.index)
    return replace(base, kind=f"{base.kind}+{kind}", mark=first, cost=cost + SECOND_MISTAKE_COST, nudges=nudges)
