"""Where the method works again: the drive's position nearest to one at which it fails."""

import math
from decimal import Decimal
from importlib.util import find_spec

from planes.geometry.arrays import Array
from planes.plans import Plans
from planes.plans.scales import drawn_in_si
from planes.words.errors import PlanFailure

# steps to either side, an eighth of a degree each; a sliding driver covers four of its longest lengths
SEARCH_STEPS_EACH_SIDE = 1440
# how often, and into how many parts, a step with a possible narrow range is divided
MOST_STEP_DIVISIONS = 12
PARTS_PER_DIVISION = 16
EDGE_HALVINGS = 60
SMALLEST_POSITIVE_NUMBER = 5e-324  # more than nothing
ISOLATED_FAILURE_STEP_SHARE = 0.08  # of a step: the distance moved from an isolated failure, where both sides work
DEGREE_DECIMALS = 4  # of degrees; two more of metres. More decimals only where the range is too narrow for these


def can_be_drawn(plans: Plans, value: float) -> bool:
    """Whether every step can be drawn at a position of the drive."""
    try:
        drawn_in_si(plans, value)
    except (PlanFailure, OverflowError, ZeroDivisionError):
        return False
    return True


def nearest_working_position(plans: Plans, value: float) -> float | None:
    """The nearest working position, with few decimals, and working when typed so; None if there is none."""
    return Nearest(plans).nearest_to_position(value)


class Nearest:
    """The nearest working position for a series of failed ones; the results of each search are kept for the next."""

    def __init__(self, plans: Plans) -> None:
        self.plans = plans
        self.gaps: list[tuple[float, float, tuple[float, ...]]] = []  # nothing works between these, and their ends do

    def nearest_to_position(self, value: float) -> float | None:
        """The nearest to this one, with few decimals, and working when typed so; None if there is none, or without
        numpy, which tests a thousand positions at once."""
        if not find_spec("numpy"):
            return None
        turning = self.plans.drive.rotates
        for low, high, ends in self.gaps:
            turns = (value - low) // 360.0 if turning else 0.0
            at = value - 360.0 * turns
            near = min((end for end in ends if low < at < high), key=lambda end: abs(end - at), default=None)
            known = near is not None and abs(near - at) <= min(at - low, high - at)
            if near is not None and known and can_be_drawn(self.plans, nearest := _turned_position(near, turns)):
                return nearest
        sides = [_Side(self.plans, value, side) for side in (1.0, -1.0)]
        ends = tuple(x for x in (side.first_working_position() for side in sides) if x is not None)
        low = value - SEARCH_STEPS_EACH_SIDE * sides[0].step
        high = value + SEARCH_STEPS_EACH_SIDE * sides[0].step
        gap = max([low, *(x for x in ends if x < value)]), min([high, *(x for x in ends if x > value)])
        self.gaps.append((*gap, ends))
        return min(ends, key=lambda x: abs(x - value), default=None)


def _turned_position(value: float, turns: float) -> float:
    """A position some turns further, with the same decimals."""
    return float(Decimal(repr(value)) + 360 * int(turns))


class _Side:
    """One side of a failed position."""

    def __init__(self, plans: Plans, value: float, side: float) -> None:
        self.plans = plans
        self.value = value
        self.side = side
        self.turning = plans.drive.rotates
        self.step = (180.0 if self.turning else 4 * plans.longest_link_length) / SEARCH_STEPS_EACH_SIDE

    def first_working_position(self) -> float | None:
        """The first working position on this side."""
        import numpy

        offsets = numpy.arange(SEARCH_STEPS_EACH_SIDE + 1, dtype=float) * self.step
        missing = self.distance_from_working(offsets)
        missing[0] = missing[0] or math.inf  # fails in a single drawing, whatever it does among many
        good = numpy.flatnonzero(missing == 0)
        end = int(good[0]) if len(good) else SEARCH_STEPS_EACH_SIDE
        dips = 1 + numpy.flatnonzero((missing[1:end] <= missing[: end - 1]) & (missing[1:end] <= missing[2 : end + 1]))
        near = [k for k in [*dips.tolist(), *good[:1].tolist()] if missing[k] < math.inf]
        low, high = ([offsets[min(k + by, SEARCH_STEPS_EACH_SIDE)] for k in near] for by in (-1, 1))
        edge = self.find_working_edge(numpy.array(low), numpy.array(high)) if near else None
        return self.round_position_past_edge(edge) if edge else None

    def distance_from_working(self, offsets: Array) -> Array:
        """How far the mechanism is from working: 0 where it works, infinite where that is unknown."""
        import numpy

        drawing = drawn_in_si(self.plans, self.value + self.side * offsets)
        missing = numpy.zeros(len(offsets))
        for _, _, ok, numbers in drawing.tool.failures:
            miss = numbers.get("miss_mm", math.inf)
            miss = numpy.where(numpy.isfinite(miss), numpy.maximum(miss, SMALLEST_POSITIVE_NUMBER), math.inf)
            missing = numpy.where((missing == 0) & ~ok, miss, missing)
        return missing

    def find_working_edge(self, low: Array, high: Array) -> tuple[float, float] | None:
        """The last failing offset and the first working one, within the first pair of ends that brackets both.

        All pairs are divided together: where lengths are beyond comparison every step is a dip.
        """
        import numpy

        edges: dict[int, tuple[float, float]] = {}
        for _ in range(MOST_STEP_DIVISIONS):
            offsets = numpy.linspace(low, high, PARTS_PER_DIVISION + 1, axis=1)
            missing = self.distance_from_working(offsets.ravel()).reshape(offsets.shape)
            works = missing[:, 1:] == 0
            for row in numpy.flatnonzero(works.any(axis=1)).tolist():
                k = int(works[row].argmax())
                edges.setdefault(row, (float(offsets[row, k]), float(offsets[row, k + 1])))
            rows = numpy.arange(len(low))
            k = missing.argmin(axis=1)
            low = offsets[rows, numpy.maximum(k - 1, 0)]
            high = offsets[rows, numpy.minimum(k + 1, PARTS_PER_DIVISION)]
            first = min(edges, default=len(low))
            if first == 0:
                break
            low, high = low[:first], high[:first]  # offsets beyond it are not examined
        return self.narrow_working_edge(*edges[min(edges)]) if edges else None

    def narrow_working_edge(self, bad: float, good: float) -> tuple[float, float]:
        """The same, as close as floats can be."""
        for _ in range(EDGE_HALVINGS):
            middle = (bad + good) / 2
            if can_be_drawn(self.plans, self.value + self.side * middle):
                good = middle
            else:
                bad = middle
        return bad, good

    def round_position_past_edge(self, edge: tuple[float, float]) -> float:
        """The first position of few decimals beyond the edge, if it works; otherwise one with more decimals."""
        least = DEGREE_DECIMALS if self.turning else DEGREE_DECIMALS + 2
        if edge[1] < 10.0**-least and can_be_drawn(
            self.plans, beside := self.value + self.side * ISOLATED_FAILURE_STEP_SHARE * self.step
        ):
            return round(beside, least)
        exact = self.value + self.side * edge[1]
        for decimals in range(least, 16):
            rounded = (math.ceil if self.side > 0 else math.floor)(exact * 10.0**decimals) / 10.0**decimals
            if can_be_drawn(self.plans, rounded):
                return rounded
        return exact
