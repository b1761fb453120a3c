"""Where a mechanism can no longer be drawn: a limit of assembly, a change point, a crossing at infinity.

The search goes along the drive; if there is no limit, along a length or a guide's angle, with the drive held where its
crossings are bluntest. A limit is known to 50 digits.
"""

import math
from collections.abc import Iterator
from functools import reduce
from typing import Literal

import numpy as np

from planes.accuracy.comparison import Comparison
from planes.accuracy.digits import Digits
from planes.accuracy.variation import alterable_given_names
from planes.drafting.drawing import Drawing, draw_program
from planes.geometry.arithmetic import Real
from planes.geometry.arrays import Array, Booleans
from planes.words.errors import PlanFailure
from planes.words.frozen import frozen

Kind = Literal["end", "change", "infinite"]
FIFTY_DIGITS = Digits(50)
EDGE_HALVINGS = 170
MOST_NARROWING_ROUNDS = 180
LIMIT_CLOSENESS_FACTOR = 1000  # times: this much closer to a predicted limit than the positions around it
BLUNT_OPENNESS = 0.3  # openness below which a closer look pays
# openness that a closer look must reach, and the openness of a missing place
ROUGH_OPENNESS = 1e-4
MISSING_PLACE_OPENNESS = 1e-18
FAR_AWAY_REACHES = 1e4  # reaches: a point this far away goes to infinity
LIMIT_NEIGHBOUR_OFFSET = 1e-7
HALF_OPEN_SPEED_RATIO = 10.0  # times the drive's speed at the mechanism's reach: half open
LARGEST_LENGTH_FACTOR = 6.0  # largest factor by which a length is changed


@frozen
class MovedGiven:
    """One varied given (``name``); the drive is held at ``held`` unless it is the drive itself."""

    bench: Comparison
    name: str
    held: float | None = None

    @property
    def unit_of_distances(self) -> Literal["rad", "m", "1"]:
        """The unit of distances; "1": for a length, relative."""
        if self.held is not None:
            return "1" if self.name in self.bench.plans.link_lengths else "rad"
        return "rad" if self.bench.plans.drive.rotates else "m"

    @property
    def value_in_scene(self) -> float:
        """The value in the scene."""
        return float(self.bench.cycle.given[self.name])

    @property
    def values_to_search(self) -> Array:
        """Values to search, from end to end."""
        if self.unit_of_distances == "1":
            return self.value_in_scene * np.exp(np.linspace(-1, 1, 601) * math.log(LARGEST_LENGTH_FACTOR))
        if self.unit_of_distances == "m":
            return self.value_in_scene + np.linspace(-3, 3, 1201) * self.bench.plans.longest_link_length
        return self.value_in_scene + np.linspace(-180, 180, 721) / (1 if self.held is None else 2)

    def distance_from_scene_value(self, value: Real) -> float:
        """The distance of a value from the scene's; for a length the logarithm of their ratio."""
        if self.unit_of_distances == "1":
            return abs(math.log(value / self.value_in_scene))
        return abs(float(value) - self.value_in_scene) * (math.radians(1) if self.unit_of_distances == "rad" else 1.0)

    def draw_at_value(self, value: Real, instrument: Digits | None = None) -> Drawing:
        """The drawing at a value, or at many."""
        held = {} if self.held is None else {self.bench.plans.drive_given_name: self.held}
        return draw_program(self.bench.cycle.program, {**self.bench.cycle.given, **held, self.name: value}, instrument)

    def openness_of_values(self, values: Array) -> Array:
        """From 1 down to 0 where the mechanism cannot be drawn."""
        drawing = self.draw_at_value(np.asarray(values, float))
        with np.errstate(all="ignore"):
            sharpness = self._openness_of_drawing(drawing)
        return np.where(np.isfinite(sharpness) & ~np.asarray(drawing.failed_mask()), sharpness, 0.0) + np.zeros(
            len(values)
        )

    def openness_at_50_digits(self, value: Real) -> Real:
        """The same for one value, at 50 digits."""
        try:
            return self._openness_of_drawing(self.draw_at_value(value, FIFTY_DIGITS))
        except PlanFailure:
            return 0

    def _openness_of_drawing(self, drawing: Drawing) -> Real:
        """The least sharpness, or the speed of the fastest point relative to the drive, if that is less."""
        ar = drawing.tool.ar
        drive = self.bench.plans.drive
        least: Real = reduce(ar.minimum, drawing.crossing_sharpness.values(), 1.0)
        slow = (
            HALF_OPEN_SPEED_RATIO
            * abs(drive.velocity)
            * (self.bench.plans.longest_link_length if drive.rotates else 1.0)
        )
        if slow:
            least = ar.minimum(least, slow / (slow + self._largest_magnitude(drawing, "v")))
        return least

    def _largest_magnitude(self, drawing: Drawing, letter: str) -> Real:
        taken = zip(self.bench.letters, self.bench.columns_of_drawing(drawing), strict=True)
        return reduce(drawing.tool.ar.maximum, (abs(x) for kind, x in taken if kind == letter), 0.0)

    def has_point_far_away(self, value: Real) -> bool:
        """Whether a point is far beyond the mechanism's reach."""
        return bool(
            self._largest_magnitude(self.draw_at_value(value, FIFTY_DIGITS), "r")
            > FAR_AWAY_REACHES * self.bench.plans.longest_link_length
        )


@frozen
class Limit:
    """The ``value`` (50 digits) at which a path ends; positions exist on its ``side`` (+1: above)."""

    way: MovedGiven
    value: Real
    side: int
    kind: Kind

    @property
    def distance_unit_value(self) -> Real:
        """The unit of distances: a radian (in degrees), a metre, or the length at the limit."""
        return {"rad": 180 / self.value.context.pi, "m": 1, "1": self.value}[self.way.unit_of_distances]


def find_nearest_limit(bench: Comparison) -> Limit | None:
    """The limit nearest to the scene along the drive; otherwise along the given that needs the least change, with the
    drive held."""
    along = next(_limits_by_distance(MovedGiven(bench, bench.plans.drive_given_name)), None)
    if along:
        return along
    held = bluntest_drive_position(bench)
    if len(bench.plans.structure.class_two_groups) < len(bench.plans.structure.groups):
        return None  # an assembly is followed along the drive: turning curves show what ends with a changed length
    names = alterable_given_names(bench.plans, bench.cycle.program.given_names)
    limits = [next(_limits_by_distance(MovedGiven(bench, name, held)), None) for name in names]
    return min((x for x in limits if x), key=lambda x: x.way.distance_from_scene_value(x.value), default=None)


def similar_limit_of_path(limit: Limit, way: MovedGiven) -> Limit | None:
    """The nearest limit of another path, if it is of the same sort."""
    other = next(_limits_by_distance(way), None)
    if other and (other.kind, other.side) == (limit.kind, limit.side):
        return other
    return None


def bluntest_drive_position(bench: Comparison) -> float:
    """The drive's position with the bluntest crossings."""
    way = MovedGiven(bench, bench.plans.drive_given_name)
    values = way.values_to_search
    openness = way.openness_of_values(values)
    return float(values[np.argmin(np.where(openness > 0, openness, 2.0))])


def _limits_by_distance(way: MovedGiven) -> Iterator[Limit]:
    """Limits, the nearest first."""
    values = way.values_to_search
    openness = way.openness_of_values(values)
    works = openness > 0
    edges = np.flatnonzero(works[1:] != works[:-1])
    before = openness[:-2]
    middle = openness[1:-1]
    after = openness[2:]
    blunt = (middle <= BLUNT_OPENNESS) & (middle <= before) & (middle <= after)
    dips = 1 + np.flatnonzero(blunt & works[:-2] & works[1:-1] & works[2:])
    spots = [(way.distance_from_scene_value(values[k]), k, k + 1) for k in edges] + [
        (way.distance_from_scene_value(values[k]), k - 1, k + 1) for k in dips
    ]
    for _, low, high in sorted(spots):
        limit = _limit_between(way, values, works, int(low), int(high))
        if limit:
            yield limit


def _limit_between(way: MovedGiven, values: Array, works: Booleans, low: int, high: int) -> Limit | None:
    if works[low] and works[high]:
        return _undrawable_point_between(way, values[low], values[high])
    good, bad = (low, high) if works[low] else (high, low)
    if way.openness_at_50_digits(float(values[bad])):  # can be drawn with more digits
        return _undrawable_point_between(way, values[max(bad - 1, 0)], values[min(bad + 1, len(values) - 1)])
    return _narrow_down_limit(way, float(values[good]), float(values[bad]))


def _narrow_down_limit(way: MovedGiven, good: float, bad: float) -> Limit:
    """The limit, narrowed down to 50 digits. Near it the openness varies as the root of the distance, as the distance,
    or as its square: a line through two working positions predicts its end, which is tried slightly to either side,
    then the middle is tried."""
    step = abs(bad - good)
    one, two = (FIFTY_DIGITS.tool(False).given_in_tool_type(x) for x in (good, bad))
    end = abs(two - one) / 2**EDGE_HALVINGS
    powers = [2, 1, 0.5]
    past = two
    past_open = 0
    one_open = way.openness_at_50_digits(one)
    while (wide := abs(two - one)) > end and (one + two) / 2 not in (one, two):
        opening = one_open ** powers[0]
        before = past_open ** powers[0]
        estimate = one - opening * (one - past) / (opening - before) if opening != before else one
        for place in (
            estimate + (one - estimate) / LIMIT_CLOSENESS_FACTOR,
            estimate + (two - estimate) / LIMIT_CLOSENESS_FACTOR,
            (one + two) / 2,
        ):
            if not min(one, two) < place < max(one, two):
                continue
            if is_open := way.openness_at_50_digits(place):
                past = one
                past_open = one_open
                one = place
                one_open = is_open
            else:
                two = place
        if abs(two - one) > wide / 8:
            powers.append(powers.pop(0))
    side = 1 if good > bad else -1
    return Limit(
        way,
        one,
        side,
        _kind_of_single_point(way, one, step)
        if way.openness_at_50_digits(one - side * LIMIT_NEIGHBOUR_OFFSET * step)
        else "end",
    )


def _undrawable_point_between(way: MovedGiven, low: float, high: float) -> Limit | None:
    """A point between working positions that cannot be drawn, if there is one."""
    step = abs(high - low)
    one, two = (FIFTY_DIGITS.tool(False).given_in_tool_type(x) for x in (low, high))
    for k in range(MOST_NARROWING_ROUNDS):
        third = (two - one) / 3
        left = way.openness_at_50_digits(one + third)
        right = way.openness_at_50_digits(two - third)
        one, two = (one, two - third) if left < right else (one + third, two)
        if k == MOST_NARROWING_ROUNDS // 4 and min(left, right) > ROUGH_OPENNESS:
            return None
    value = (one + two) / 2
    if way.openness_at_50_digits(value) > MISSING_PLACE_OPENNESS:
        return None
    return Limit(way, value, 1 if way.value_in_scene > value else -1, _kind_of_single_point(way, value, step))


def _kind_of_single_point(way: MovedGiven, value: Real, step: float) -> Kind:
    """The kind of a single point between working positions."""
    if way.has_point_far_away(value + LIMIT_NEIGHBOUR_OFFSET * step):
        return "infinite"
    return "change"
