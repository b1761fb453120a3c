"""The position a scheme is shown in where it must not give the answer away: one that reads well, not the one asked."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import combinations

from planes.drafting.drawing import Drawing, run
from planes.plans import Plans
from planes.plans.scales import unit_scales
from planes.words.errors import PlanFailure

STEP_DEG, APART_DEG = 15, 30.0
FAR = 4.0  # points a quarter of the mechanism apart read as well as links at a right angle


def clearest(plans: Plans, value: float) -> float:
    """The driver's angle (degrees), well away from ``value``, at which points and links stand best apart.

    A sliding driver stays where it is.
    """
    if plans.mechanism.drive.kind != "phi":
        return value
    scores = dict(_scores(plans, value))
    return max(scores, key=lambda v: round(scores[v], 3), default=value)


def _scores(plans: Plans, value: float) -> Iterator[tuple[float, float]]:
    """Every position that can be drawn, and how well it reads, from 0 to 1."""
    for phi in range(0, 360, STEP_DEG):
        if abs((phi - value + 180) % 360 - 180) >= APART_DEG:
            try:
                drawing = run(plans.program, {**plans.given, **unit_scales(plans), plans.drive_given: float(phi)})
            except PlanFailure:
                continue
            yield float(phi), min(_points_apart(plans, drawing), _links_apart(plans, drawing))


def _points_apart(plans: Plans, drawing: Drawing) -> float:
    """How far the two nearest hinges are apart, against the whole."""
    hinges = dict.fromkeys(pair.point for pair in plans.structure.pairs if pair.kind == "R")
    spots = [complex(drawing[plans.points[name].position]) for name in hinges]
    gaps = [abs(a - b) for a, b in combinations(spots, 2)]
    gaps = [gap for gap in gaps if gap > 1e-6 * max(gaps)]
    return FAR * min(gaps) / max(gaps) if gaps else 1.0


def _links_apart(plans: Plans, drawing: Drawing) -> float:
    """The sine of the least angle between two links joined by a hinge."""
    found = [1.0]
    for pair in plans.structure.pairs:
        one, two = (plans.links[name].angle for name in (pair.link, pair.other))
        if one and two and pair.kind == "R":
            found.append(abs(math.sin(math.radians(drawing[one] - drawing[two]))))
    return min(found)
