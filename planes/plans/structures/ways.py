"""The method for a body's reactions: as given in the scene, else the simplest that its loads and supports allow."""

import cmath
import math
from collections.abc import Iterator, Mapping
from itertools import combinations, permutations

from planes.geometry.plane import sine_between
from planes.plans.assur.alignment import matrix_determinant
from planes.plans.structures.beams import StraightBeam
from planes.plans.structures.free_body import FreeBody
from planes.plans.structures.strings import (
    StringPolygon,
    choose_sharp_pole,
    lay_off_pole,
    pole_for_strings_through,
    reactions_by_string_polygon,
    resultant_by_composition,
)
from planes.scene import Scene
from planes.scene.mechanism import LoadLaw
from planes.scene.structures import Framework, Support
from planes.words import Phrase
from planes.words.errors import SceneError
from planes.words.names import SCHEME_PLAN, Mark, scheme_mark

PARALLEL_LINES_SINE = 1e-9  # the sine of the angle below which lines are parallel; arms relative to the size of a body
LEAST_DRAWABLE_CROSSING_SINE = 0.05  # a crossing sharper than this can be drawn


class WayFinder:
    """Chooses a method by the numbers of a scene, and draws; ``sizes`` are the known forces, N: where loads are
    ``turning``, those at the drive's position in the file."""

    def __init__(
        self, scene: Scene, framework: Framework, body: FreeBody, sizes: Mapping[str, complex], turning: bool
    ) -> None:
        self.scene = scene
        self.framework = framework
        self.body = body
        self.turning = turning
        self.forces = [sizes[f.name] for f in body.forces]
        self.places = {x.name: x.place for x in framework.loads}
        self.places |= {f.name: framework.points[f.point.label] for f in body.forces if f.name not in self.places}
        self.size = max((abs(a - b) for a, b in combinations(framework.points.values(), 2)), default=1.0)

    def method_refusal(self, key: str, **details: object) -> SceneError:
        """Why this method cannot be used."""
        where = self.scene.where
        line = where.get(("method",), where.get(("supports",), where.get(("points",))))
        return SceneError(Phrase(key, **details), self.scene.file, line)

    def find_all_reactions(self) -> None:
        """Find all reactions of the body."""
        self.refuse_loose_supports()
        ways = {
            "moments": self.solve_by_moments,
            "string": self.solve_by_string_polygon,
            "three-forces": self.solve_by_single_load,
            "composition": self.solve_by_composition,
            "culmann": self.solve_by_single_load,
        }
        ways[self.framework.method or self.plainest_method()]()

    def plainest_method(self) -> str:
        """A suitable method."""
        b = self.body
        idle = self.turning or not any(self.forces) or bool(b.couples)
        if self.framework.members or idle or (b.hinge_or_clamp and b.hinge_or_clamp.kind == "clamp"):
            return "moments"
        if len(b.forces) == 1 and b.supports:
            line = b.supports_with_known_lines[0] if b.supports_with_known_lines else None
            meets = (
                line is not None
                and sine_between(self.forces[0], self.reaction_line_direction(line)) > LEAST_DRAWABLE_CROSSING_SINE
            )
            if b.hinge_or_clamp:
                return "three-forces" if meets else "string"
            return "culmann"
        return "string"

    def solve_by_moments(self) -> None:
        """By moments; of three lines, about where two meet that are not parallel."""
        b = self.body
        if (
            not b.hinge_or_clamp
            and b.supports_with_known_lines
            and sine_between(*map(self.reaction_line_direction, b.supports_with_known_lines[1:]))
            <= LEAST_DRAWABLE_CROSSING_SINE
        ):
            b.supports = [
                *max(
                    permutations(b.supports_with_known_lines),
                    key=lambda order: sine_between(*map(self.reaction_line_direction, order[1:])),
                )
            ]
        b.solve_reactions_by_moments()

    def reaction_line_direction(self, s: Support) -> complex:
        """The direction of a reaction's line."""
        points = self.framework.points
        if s.to:
            return points[s.to] - points[s.point]
        return cmath.rect(1.0, math.radians(s.normal_deg))

    def refuse_loose_supports(self) -> None:
        """Refuse supports that do not hold: a line through the hinge, three lines through one point or all parallel."""
        b = self.body
        points = self.framework.points
        if b.hinge_or_clamp and b.supports_with_known_lines:
            line = b.supports_with_known_lines[0]
            lever = points[line.point] - points[b.hinge_or_clamp.point]
            if sine_between(lever, self.reaction_line_direction(line)) <= PARALLEL_LINES_SINE:
                raise self.method_refusal("line_through_hinge", name=line.name, point=b.hinge_or_clamp.point)
        elif not b.hinge_or_clamp and b.supports_with_known_lines:
            rows = [self.unit_reaction_equation_row(s) for s in b.supports_with_known_lines]
            if abs(matrix_determinant(rows)) <= PARALLEL_LINES_SINE:
                raise self.method_refusal("lines_concurrent", names=tuple(s.name for s in b.supports_with_known_lines))

    def unit_reaction_equation_row(self, s: Support) -> list[float]:
        """Both components of a unit reaction and its moment relative to the size of the scheme."""
        points = self.framework.points
        way = self.reaction_line_direction(s) / abs(self.reaction_line_direction(s))
        place = points[s.point] - next(iter(points.values()))
        return [way.real, way.imag, (place.conjugate() * way).imag / self.size]

    def refuse_unsuitable_method(self, method: str) -> None:
        """Refuse bodies that a method by lines of action cannot solve."""
        b = self.body
        if b.couples:
            raise self.method_refusal("method_couples", method=method, name=b.couples[0].name)
        if not any(self.forces):
            raise self.method_refusal("method_forces", method=method)
        if b.hinge_or_clamp and b.hinge_or_clamp.kind == "clamp":
            raise self.method_refusal("method_clamp", method=method, point=b.hinge_or_clamp.point)

    def solve_by_string_polygon(self) -> None:
        """By the string polygon: its closing line, or the resultant from it."""
        b = self.body
        self.refuse_unsuitable_method("string")
        steady = not any(isinstance(x.direction_deg, LoadLaw) for x in self.framework.loads)
        beam = StraightBeam(b, self.framework, self.places) if b.hinge_or_clamp and steady else None
        if beam and beam.is_straight_beam([*self.forces, self.reaction_line_direction(b.supports_with_known_lines[0])]):
            pairs = sorted(zip(b.forces, self.forces, strict=True), key=beam.load_distance_along)
            b.forces = [f for f, _ in pairs]
            self.forces = [z for _, z in pairs]
        else:
            beam = None
        b.lay_off_loads()
        if b.hinge_or_clamp:
            self.draw_string_pole(b.supports_with_known_lines[0])
            drawn = reactions_by_string_polygon(b)
            if beam and len(self.framework.bodies) == 1:
                b.figure.moments, b.figure.shears = beam.measure_moments_and_shears(*drawn)
        else:
            self.solve_by_resultant(*self.resultant_line_of_loads())

    def resultant_line_of_loads(self) -> tuple[Mark, str]:
        """The line of the loads' resultant by their string polygon."""
        b = self.body
        through = self.framework.through
        if abs(sum(self.forces)) <= PARALLEL_LINES_SINE * max(map(abs, self.forces)):
            raise self.method_refusal("forces_couple")
        self.draw_string_pole(None)
        polygon = StringPolygon(b)
        polygon.draw_rays_and_strings(scheme_mark(through[0]) if through else b.forces[0].point)
        if through:
            last = str(len(polygon.rays) - 1)
            b.figure.add_line(SCHEME_PLAN, "string", last, polygon.knots[-1], scheme_mark(through[-1]))
        return polygon.resultant_mark_and_direction()

    def draw_string_pole(self, line: Support | None) -> None:
        """Draw the given pole, one for strings through given points, or a suitable one."""
        b = self.body
        f = self.framework
        pole = f.pole or choose_sharp_pole(
            self.forces, self.reaction_line_direction(line) if line else None, self.forces
        )
        if not f.through:
            lay_off_pole(b, pole)
            return
        if b.hinge_or_clamp and b.hinge_or_clamp.point != f.through[0]:
            raise self.method_refusal("through_first", point=b.hinge_or_clamp.point)
        start = f.points[f.through[0]]
        way = f.points[f.through[-1]] - start
        along = [((self.places[x.name] - start) * way.conjugate()).real for x in b.forces]
        middle = ((f.points[f.through[1]] - start) * way.conjugate()).real
        before = sum(x < middle for x in along)
        if along != sorted(along) or (len(f.through) == 3 and not 0 < before < len(along)):
            raise self.method_refusal("through_order", names=f.through)
        pole_for_strings_through(b, pole, f.through, before)

    def solve_by_composition(self) -> None:
        """By the resultant of loads composed one after another."""
        self.refuse_unsuitable_method("composition")
        self.body.lay_off_loads()
        self.solve_by_resultant(*resultant_by_composition(self.body))

    def solve_by_single_load(self) -> None:
        """One load, or the resultant of all by its string polygon."""
        b = self.body
        method = "culmann" if b.supports and not b.hinge_or_clamp else "three-forces"
        self.refuse_unsuitable_method(self.framework.method or method)
        if self.framework.method not in (None, method):
            raise self.method_refusal("method_supports", method=self.framework.method)
        b.lay_off_loads()
        if len(b.forces) == 1:
            self.solve_by_resultant(b.forces[0].point, b.forces[0].along)
            return
        self.solve_by_resultant(*self.resultant_line_of_loads())

    def solve_by_resultant(self, point: Mark, along: str) -> None:
        """The reactions to one force along a line; none where the body has no supports."""
        b = self.body
        load = sum(self.forces)
        if not b.supports:
            return
        if b.hinge_or_clamp:
            if sine_between(load, self.reaction_line_direction(b.supports_with_known_lines[0])) <= PARALLEL_LINES_SINE:
                raise self.method_refusal("load_parallel", name=b.supports_with_known_lines[0].name)
            b.solve_by_three_forces(point, along)
        else:
            one, two, three = max(
                permutations(b.supports_with_known_lines),
                key=lambda order: min(self.culmann_crossing_sines(load, order)),
            )
            b.solve_by_culmann(point, along, (one, two, three))

    def culmann_crossing_sines(self, load: complex, order: tuple[Support, ...]) -> Iterator[float]:
        """The sines of the angles at which Culmann's lines meet in a given order."""
        one, two, three = map(self.reaction_line_direction, order)
        yield from (round(sine_between(load, one), 3), round(sine_between(two, three), 3))
