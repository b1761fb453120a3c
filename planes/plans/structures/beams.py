"""Shear forces and bending moments of a straight beam from its string polygon: every ordinate between the strings and
the closing line is a bending moment over the pole distance, and the rays divide the force polygon into shear forces."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from planes.plans.force.loads import Force
from planes.plans.structures.free_body import FreeBody, Meeting
from planes.plans.structures.strings import STRING_POLE_LETTER, StringPolygon
from planes.scene.structures import Framework
from planes.words.names import POLE_LABEL, Mark, Meaning, NamePair, NameTriple, scheme_mark

Moment = NamePair
Shear = NameTriple
MOST_SQUARE_LOAD_COSINE = 1e-9  # the cosine of the angle between a beam and its loads


@dataclass
class StraightBeam:
    """A body on a hinge and a support with a line, all points on one line, with only transverse forces."""

    body: FreeBody
    framework: Framework
    places: dict[str, complex]  # lengths of its loads, m

    @property
    def axis_vector(self) -> complex:
        """The vector from the hinge to the point of the other support."""
        anchor = self.body.hinge_or_clamp
        (line,) = self.body.supports_with_known_lines
        assert anchor
        return self.framework.points[line.point] - self.framework.points[anchor.point]

    def relative_distance_along(self, z: complex) -> float:
        """The distance of a place along the beam from the hinge, relative to the span."""
        anchor = self.body.hinge_or_clamp
        assert anchor
        return ((z - self.framework.points[anchor.point]) / self.axis_vector).real

    def load_distance_along(self, load: tuple[Force, complex]) -> float:
        """The distance of a load along the beam."""
        return self.relative_distance_along(self.places[load[0].name])

    def is_straight_beam(self, ways: list[complex]) -> bool:
        """Whether it is a beam: its points on one line, and all forces, by their ``ways``, across it."""
        anchor = self.body.hinge_or_clamp
        points = self.framework.points
        assert anchor
        own = [points[p] - points[anchor.point] for p in self.framework.bodies[self.body.name]]
        level = all(abs((z / self.axis_vector).imag) <= MOST_SQUARE_LOAD_COSINE for z in own)
        return level and all(
            abs((w / self.axis_vector).real) <= MOST_SQUARE_LOAD_COSINE * abs(w / self.axis_vector) for w in ways
        )

    def measure_moments_and_shears(
        self, polygon: StringPolygon, closing: str, x: str
    ) -> tuple[list[Moment], list[Shear]]:
        """Bending moments by points, and shear forces by pairs of points."""
        b = self.body
        d = b.draft
        anchor = b.hinge_or_clamp
        assert anchor
        axis = d.direction_between_marks(anchor.point, b.supports_with_known_lines[0].point)
        knots = polygon.knots
        ends = [POLE_LABEL, *(t.end for t in b.chain)]
        bases = [
            (POLE_LABEL, polygon.rays[0], knots[0]),
            (x, closing, knots[0]),
            (ends[len(b.forces)], polygon.rays[-1], knots[-1]),
        ]
        own = self.framework.bodies[b.name]
        stops = sorted(own, key=lambda p: self.relative_distance_along(self.framework.points[p]))
        moments = [
            (p, self.bending_moment_at_point(p, polygon, bases, axis))
            for p in stops
            if not self.is_inside_distributed_load(p)
        ]
        shears = []
        for one, other in pairwise(stops):
            if not self.has_distributed_load_between(one, other):
                middle = self.middle_distance_along(one, other)
                base = bases[self.beam_part_at(middle)][0]
                end = ends[self.loads_before_place(middle)]
                name = f"Q_{one}{other}"
                shears.append(
                    (one, other, d.measure_segment(name, *b.plan.marks(base, end), d.draw_perpendicular(axis)))
                )
        return moments, shears

    def bending_moment_at_point(
        self, point: str, polygon: StringPolygon, bases: Sequence[tuple[str, str, Mark]], axis: str
    ) -> str:
        """The bending moment at a point: the pole distance times the ordinate between base and string."""
        b = self.body
        d = b.draft
        where = self.relative_distance_along(self.framework.points[point])
        pole = d.measure_segment("N_H", b.plan.mark(STRING_POLE_LETTER), b.plan.pole, axis)
        across = d.draw_perpendicular(axis)
        _, ray, knot = bases[self.beam_part_at(where)]
        passed = self.loads_before_place(where)
        spot = scheme_mark(point)
        marks = []
        for k, through, line in (("·", knot, ray), ("··", polygon.knots[passed], polygon.rays[passed])):
            mark = b.unused_mark(f"{point}{k}")
            marks.append(d.draw_mark(Meeting(mark, spot, across, through, line, means=Meaning("foot"))))
        height = d.measure_segment(f"y_{point}", marks[0], marks[1], across)
        sign = 1.0 if (self.axis_vector.real, self.axis_vector.imag) > (0.0, 0.0) else -1.0
        return d.add_product(f"M_{point}", sign, **{pole: 1, height: 1})

    def beam_part_at(self, where: float) -> int:
        """The part of the beam: before both supports, between them, or after them."""
        if where < -MOST_SQUARE_LOAD_COSINE:
            return 0
        if where <= 1.0 + MOST_SQUARE_LOAD_COSINE:
            return 1
        return 2

    def loads_before_place(self, where: float) -> int:
        """The number of loads before a place."""
        return sum(
            self.relative_distance_along(self.places[f.name]) < where - MOST_SQUARE_LOAD_COSINE
            for f in self.body.forces
        )

    def is_inside_distributed_load(self, point: str) -> bool:
        """Whether a point lies inside a distributed load, whose resultant gives no moment there."""
        return any(self.is_between_points(load.spread, point) for load in self.framework.loads if load.spread)

    def is_between_points(self, spread: NamePair, point: str) -> bool:
        """Whether a point is between two others."""
        one, place, other = (
            self.relative_distance_along(self.framework.points[p]) for p in (spread[0], point, spread[1])
        )
        return min(one, other) + MOST_SQUARE_LOAD_COSINE < place < max(one, other) - MOST_SQUARE_LOAD_COSINE

    def middle_distance_along(self, one: str, other: str) -> float:
        """The distance of the middle of two points along the beam."""
        return (
            self.relative_distance_along(self.framework.points[one])
            + self.relative_distance_along(self.framework.points[other])
        ) / 2

    def has_distributed_load_between(self, one: str, other: str) -> bool:
        """Whether a distributed load lies between two points."""
        middle = self.middle_distance_along(one, other)
        ends = [
            sorted(self.relative_distance_along(self.framework.points[p]) for p in x.spread)
            for x in self.framework.loads
            if x.spread
        ]
        return any(low < middle < high for low, high in ends)
