"""How much a drawing shows: what marks put down anywhere would pass for by chance is not judged right."""

from __future__ import annotations

import math
from collections.abc import Iterable

from planes.check.grading.handwork import Hand, Miss
from planes.drafting.steps import Same

SURE = 0.02  # how likely marks put anywhere on the drawing may be to pass: one vector of 50 mm at a scale of its own
SURE_LENGTHS = 0.05  # the same of lengths, each of which shows half of what a mark does
SMALLEST = 10.0  # a drawing this many times the error of a mark shows nothing


def nothing_drawn(hand: Hand, marks: Iterable[str]) -> bool:
    """Whether all that was read lies within the error of a pencil from the pole."""
    return size_of(hand, marks) < SMALLEST * hand.tool.skill.point_mm


def size_of(hand: Hand, marks: Iterable[str]) -> float:
    """How far the person's own marks reach from the pole, mm."""
    return max((abs(hand.taken[m].place) for m in marks if m in hand.taken), default=0.0)


def by_chance(hand: Hand, misses: dict[str, Miss], limit: float, free: bool, gap_mm: float | None = None) -> float:
    """How likely marks put anywhere on a drawing of this size are to be as right; ``free``: so is the scale.

    A mark that stands where another does (or the pole) is not seen by itself; a polygon that closes within ``gap_mm``
    shows as much as a mark does.
    """
    size = size_of(hand, misses)
    steps = {s.makes: s for s in hand.program.steps}
    shares, stand = [] if gap_mm is None else [min(gap_mm / size, 1.0) ** 2], [0j]
    for mark, miss in misses.items():
        place, reach = hand.taken[mark].place, limit * miss.mean
        if not isinstance(steps[mark], Same) and all(abs(place - z) > reach for z in stand):
            shares.append(min(reach / size, 1.0) ** 2)
        stand.append(place)
    if not free or not shares:
        return math.prod(shares)
    surest = min(shares)  # what the scale is taken from, of which the direction alone is left
    return math.prod(shares) / surest * min(math.sqrt(surest) / math.pi, 1.0)


def lengths_by_chance(shares: Iterable[float], free: bool) -> float:
    """The same for lengths, by the share of the longest that each may be wrong by."""
    found = [min(s, 1.0) for s in shares]
    return math.prod(found) / (min(found) if free else 1.0)
