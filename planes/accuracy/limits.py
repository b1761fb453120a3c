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
from planes.accuracy.variation import alterable
from planes.drafting.drawing import Drawing, run
from planes.geometry.arithmetic import Real
from planes.geometry.arrays import Array, Booleans
from planes.words.errors import PlanFailure
from planes.words.frozen import frozen

Kind = Literal["end", "change", "infinite"]
FINE = Digits(50)
HALVINGS, NARROWINGS = 170, 180
NEARER = 1000  # times: this much closer to a predicted limit than the positions around it
BLUNT = 0.3  # openness below which a closer look pays
ROUGH, NONE = 1e-4, 1e-18  # openness that a closer look must reach, and the openness of a missing place
FAR = 1e4  # reaches: a point this far away goes to infinity
BESIDE = 1e-7
QUICK = 10.0  # times the drive's speed at the mechanism's reach: half open
WIDEST = 6.0  # largest factor by which a length is changed


@frozen
class MovedGiven:
    """One varied given (``name``); the drive is held at ``held`` unless it is the drive itself."""

    bench: Comparison
    name: str
    held: float | None = None

    @property
    def unit(self) -> Literal["rad", "m", "1"]:
        """The unit of distances; "1": for a length, relative."""
        if self.held is not None:
            return "1" if self.name in self.bench.plans.lengths else "rad"
        return "rad" if self.bench.plans.drive.rotates else "m"

    @property
    def here(self) -> float:
        """The value in the scene."""
        return float(self.bench.cycle.given[self.name])

    @property
    def values(self) -> Array:
        """Values to search, from end to end."""
        if self.unit == "1":
            return self.here * np.exp(np.linspace(-1, 1, 601) * math.log(WIDEST))
        if self.unit == "m":
            return self.here + np.linspace(-3, 3, 1201) * self.bench.plans.reach
        return self.here + np.linspace(-180, 180, 721) / (1 if self.held is None else 2)

    def away(self, value: Real) -> float:
        """The distance of a value from the scene's; for a length the logarithm of their ratio."""
        if self.unit == "1":
            return abs(math.log(value / self.here))
        return abs(float(value) - self.here) * (math.radians(1) if self.unit == "rad" else 1.0)

    def draw(self, value: Real, instrument: Digits | None = None) -> Drawing:
        """The drawing at a value, or at many."""
        held = {} if self.held is None else {self.bench.plans.drive_given: self.held}
        return run(self.bench.cycle.program, {**self.bench.cycle.given, **held, self.name: value}, instrument)

    def openness(self, values: Array) -> Array:
        """From 1 down to 0 where the mechanism cannot be drawn."""
        drawing = self.draw(np.asarray(values, float))
        with np.errstate(all="ignore"):
            sharpness = self._open(drawing)
        return np.where(np.isfinite(sharpness) & ~np.asarray(drawing.failed()), sharpness, 0.0) + np.zeros(len(values))

    def fine(self, value: Real) -> Real:
        """The same for one value, at 50 digits."""
        try:
            return self._open(self.draw(value, FINE))
        except PlanFailure:
            return 0

    def _open(self, drawing: Drawing) -> Real:
        """The least sharpness, or the speed of the fastest point relative to the drive, if that is less."""
        ar, drive = drawing.tool.ar, self.bench.plans.drive
        least: Real = reduce(ar.minimum, drawing.sharpness.values(), 1.0)
        slow = QUICK * abs(drive.velocity) * (self.bench.plans.reach if drive.rotates else 1.0)
        if slow:
            least = ar.minimum(least, slow / (slow + self._largest(drawing, "v")))
        return least

    def _largest(self, drawing: Drawing, letter: str) -> Real:
        taken = zip(self.bench.letters, self.bench.taken(drawing), strict=True)
        return reduce(drawing.tool.ar.maximum, (abs(x) for kind, x in taken if kind == letter), 0.0)

    def far(self, value: Real) -> bool:
        """Whether a point is far beyond the mechanism's reach."""
        return bool(self._largest(self.draw(value, FINE), "r") > FAR * self.bench.plans.reach)


@frozen
class Limit:
    """The ``value`` (50 digits) at which a path ends; positions exist on its ``side`` (+1: above)."""

    way: MovedGiven
    value: Real
    side: int
    kind: Kind

    @property
    def unit(self) -> Real:
        """The unit of distances: a radian (in degrees), a metre, or the length at the limit."""
        return {"rad": 180 / self.value.context.pi, "m": 1, "1": self.value}[self.way.unit]


def find(bench: Comparison) -> Limit | None:
    """The limit nearest to the scene along the drive; otherwise along the given that needs the least change, with the
    drive held."""
    along = next(_limits(MovedGiven(bench, bench.plans.drive_given)), None)
    if along:
        return along
    held = bluntest(bench)
    if len(bench.plans.structure.dyads) < len(bench.plans.structure.groups):
        return None  # an assembly is followed along the drive: turning curves show what ends with a changed length
    names = alterable(bench.plans, bench.cycle.program.givens)
    limits = [next(_limits(MovedGiven(bench, name, held)), None) for name in names]
    return min((x for x in limits if x), key=lambda x: x.way.away(x.value), default=None)


def like(limit: Limit, way: MovedGiven) -> Limit | None:
    """The nearest limit of another path, if it is of the same sort."""
    other = next(_limits(way), None)
    return other if other and (other.kind, other.side) == (limit.kind, limit.side) else None


def bluntest(bench: Comparison) -> float:
    """The drive's position with the bluntest crossings."""
    way = MovedGiven(bench, bench.plans.drive_given)
    values, openness = way.values, way.openness(way.values)
    return float(values[np.argmin(np.where(openness > 0, openness, 2.0))])


def _limits(way: MovedGiven) -> Iterator[Limit]:
    """Limits, the nearest first."""
    values, openness = way.values, way.openness(way.values)
    works = openness > 0
    edges = np.flatnonzero(works[1:] != works[:-1])
    before, middle, after = openness[:-2], openness[1:-1], openness[2:]
    blunt = (middle <= BLUNT) & (middle <= before) & (middle <= after)
    dips = 1 + np.flatnonzero(blunt & works[:-2] & works[1:-1] & works[2:])
    spots = [(way.away(values[k]), k, k + 1) for k in edges] + [(way.away(values[k]), k - 1, k + 1) for k in dips]
    for _, low, high in sorted(spots):
        limit = _between(way, values, works, int(low), int(high))
        if limit:
            yield limit


def _between(way: MovedGiven, values: Array, works: Booleans, low: int, high: int) -> Limit | None:
    if works[low] and works[high]:
        return _dip(way, values[low], values[high])
    good, bad = (low, high) if works[low] else (high, low)
    if way.fine(float(values[bad])):  # can be drawn with more digits
        return _dip(way, values[max(bad - 1, 0)], values[min(bad + 1, len(values) - 1)])
    return _edge(way, float(values[good]), float(values[bad]))


def _edge(way: MovedGiven, good: float, bad: float) -> Limit:
    """The limit, narrowed down to 50 digits. Near it the openness varies as the root of the distance, as the distance,
    or as its square: a line through two working positions predicts its end, which is tried slightly to either side,
    then the middle is tried."""
    step = abs(bad - good)
    one, two = (FINE.tool(False).given(x) for x in (good, bad))
    end, powers, (past, past_open), one_open = abs(two - one) / 2**HALVINGS, [2, 1, 0.5], (two, 0), way.fine(one)
    while (wide := abs(two - one)) > end and (one + two) / 2 not in (one, two):
        opening, before = one_open ** powers[0], past_open ** powers[0]
        estimate = one - opening * (one - past) / (opening - before) if opening != before else one
        for place in (estimate + (one - estimate) / NEARER, estimate + (two - estimate) / NEARER, (one + two) / 2):
            if not min(one, two) < place < max(one, two):
                continue
            if is_open := way.fine(place):
                past, past_open, one, one_open = one, one_open, place, is_open
            else:
                two = place
        if abs(two - one) > wide / 8:
            powers.append(powers.pop(0))
    side = 1 if good > bad else -1
    return Limit(way, one, side, _single(way, one, step) if way.fine(one - side * BESIDE * step) else "end")


def _dip(way: MovedGiven, low: float, high: float) -> Limit | None:
    """A point between working positions that cannot be drawn, if there is one."""
    step = abs(high - low)
    one, two = (FINE.tool(False).given(x) for x in (low, high))
    for k in range(NARROWINGS):
        third = (two - one) / 3
        left, right = way.fine(one + third), way.fine(two - third)
        one, two = (one, two - third) if left < right else (one + third, two)
        if k == NARROWINGS // 4 and min(left, right) > ROUGH:
            return None
    value = (one + two) / 2
    if way.fine(value) > NONE:
        return None
    return Limit(way, value, 1 if way.here > value else -1, _single(way, value, step))


def _single(way: MovedGiven, value: Real, step: float) -> Kind:
    """The kind of a single point between working positions."""
    return "infinite" if way.far(value + BESIDE * step) else "change"
