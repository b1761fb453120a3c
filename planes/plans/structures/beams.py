"""Shear forces and bending moments of a straight beam from its string polygon: every ordinate between the strings and
the closing line is a bending moment over the pole distance, and the rays divide the force polygon into shear forces."""

from dataclasses import dataclass
from itertools import pairwise

from planes.plans.force.loads import Force
from planes.plans.position.bodies import SCHEME
from planes.plans.structures.free_body import FreeBody, Meeting
from planes.plans.structures.strings import O, StringPolygon
from planes.scene.structures import Framework
from planes.words.names import POLE, Meaning, at

Moment = tuple[str, str]
Shear = tuple[str, str, str]
SQUARE = 1e-9  # the cosine of the angle between a beam and its loads


@dataclass
class StraightBeam:
    """A body on a hinge and a support with a line, all points on one line, with only transverse forces."""

    body: FreeBody
    framework: Framework
    places: dict[str, complex]  # lengths of its loads, m

    @property
    def axis(self) -> complex:
        """The vector from the hinge to the point of the other support."""
        anchor, (line,) = self.body.anchor, self.body.lines
        assert anchor
        return self.framework.points[line.point] - self.framework.points[anchor.point]

    def along(self, z: complex) -> float:
        """The distance of a place along the beam from the hinge, relative to the span."""
        anchor = self.body.anchor
        assert anchor
        return ((z - self.framework.points[anchor.point]) / self.axis).real

    def load_along(self, load: tuple[Force, complex]) -> float:
        """The distance of a load along the beam."""
        return self.along(self.places[load[0].name])

    def straight(self, ways: list[complex]) -> bool:
        """Whether it is a beam: its points on one line, and all forces, by their ``ways``, across it."""
        anchor, points = self.body.anchor, self.framework.points
        assert anchor
        own = [points[p] - points[anchor.point] for p in self.framework.bodies[self.body.name]]
        level = all(abs((z / self.axis).imag) <= SQUARE for z in own)
        return level and all(abs((w / self.axis).real) <= SQUARE * abs(w / self.axis) for w in ways)

    def measure(self, polygon: StringPolygon, closing: str, x: str) -> tuple[list[Moment], list[Shear]]:
        """Bending moments by points, and shear forces by pairs of points."""
        b, d, anchor = self.body, self.body.draft, self.body.anchor
        assert anchor
        axis = d.ray(SCHEME, anchor.point, b.lines[0].point)
        knots, ends = polygon.knots, [POLE, *(t.end for t in b.chain)]
        bases = [
            (POLE, polygon.rays[0], knots[0]),
            (x, closing, knots[0]),
            (ends[len(b.forces)], polygon.rays[-1], knots[-1]),
        ]
        own = self.framework.bodies[b.name]
        stops = sorted(own, key=lambda p: self.along(self.framework.points[p]))
        moments = [(p, self.moment(p, polygon, bases, axis)) for p in stops if not self.within(p)]
        shears = list[Shear]()
        for one, other in pairwise(stops):
            if not self.spread(one, other):
                middle = self.middle(one, other)
                base, end = bases[self.part(middle)][0], ends[self.passed(middle)]
                name = f"Q_{one}{other}"
                shears.append((one, other, d.measure(name, at(b.plan, base), at(b.plan, end), d.square(axis))))
        return moments, shears

    def moment(self, point: str, polygon: StringPolygon, bases: list[Shear], axis: str) -> str:
        """The bending moment at a point: the pole distance times the ordinate between base and string."""
        b, d, where = self.body, self.body.draft, self.along(self.framework.points[point])
        pole, across = d.measure("N_H", at(b.plan, O), at(b.plan, POLE), axis), d.square(axis)
        _, ray, knot = bases[self.part(where)]
        passed, spot = self.passed(where), at(SCHEME, point)
        marks = []
        for k, through, line in (("·", knot, ray), ("··", polygon.knots[passed], polygon.rays[passed])):
            mark = b.fresh(f"{point}{k}")
            marks.append(d.step(Meeting(mark, spot, across, through, line, means=Meaning("foot"))))
        height = d.measure(f"y_{point}", marks[0], marks[1], across)
        sign = 1.0 if (self.axis.real, self.axis.imag) > (0.0, 0.0) else -1.0
        return d.product(f"M_{point}", sign, **{pole: 1, height: 1})

    def part(self, where: float) -> int:
        """The part of the beam: before both supports, between them, or after them."""
        return 0 if where < -SQUARE else 1 if where <= 1.0 + SQUARE else 2

    def passed(self, where: float) -> int:
        """The number of loads before a place."""
        return sum(self.along(self.places[f.name]) < where - SQUARE for f in self.body.forces)

    def within(self, point: str) -> bool:
        """Whether a point lies inside a distributed load, whose resultant gives no moment there."""
        return any(self.covers(load.spread, point) for load in self.framework.loads if load.spread)

    def covers(self, spread: tuple[str, str], point: str) -> bool:
        """Whether a point is between two others."""
        one, place, other = (self.along(self.framework.points[p]) for p in (spread[0], point, spread[1]))
        return min(one, other) + SQUARE < place < max(one, other) - SQUARE

    def middle(self, one: str, other: str) -> float:
        """The distance of the middle of two points along the beam."""
        return (self.along(self.framework.points[one]) + self.along(self.framework.points[other])) / 2

    def spread(self, one: str, other: str) -> bool:
        """Whether a distributed load lies between two points."""
        middle = self.middle(one, other)
        ends = [
            sorted(self.along(self.framework.points[p]) for p in x.spread) for x in self.framework.loads if x.spread
        ]
        return any(low < middle < high for low, high in ends)
