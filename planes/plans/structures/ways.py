"""The method for a body's reactions: as given in the scene, else the simplest that its loads and supports allow."""

import cmath
import math
from collections.abc import Iterator, Mapping
from itertools import combinations, permutations

from planes.geometry.plane import sine
from planes.plans.assur.alignment import determinant
from planes.plans.position.bodies import SCHEME
from planes.plans.structures.beams import StraightBeam
from planes.plans.structures.free_body import FreeBody
from planes.plans.structures.strings import (
    StringPolygon,
    by_composition,
    by_strings,
    chosen_pole,
    lay_pole,
    pole_through,
)
from planes.scene import Scene
from planes.scene.mechanism import LoadLaw
from planes.scene.structures import Framework, Support
from planes.words import Phrase
from planes.words.errors import SceneError
from planes.words.names import at, label_of

BLUNT = 1e-9  # the sine of the angle below which lines are parallel; arms relative to the size of a body
SLIGHT = 0.05  # a crossing sharper than this can be drawn


class WayFinder:
    """Chooses a method by the numbers of a scene, and draws; ``sizes`` are the known forces, N: where loads are
    ``turning``, those at the drive's position in the file."""

    def __init__(
        self, scene: Scene, framework: Framework, body: FreeBody, sizes: Mapping[str, complex], turning: bool
    ) -> None:
        self.scene, self.framework, self.body, self.turning = scene, framework, body, turning
        self.forces = [sizes[f.name] for f in body.forces]
        self.places = {x.name: x.place for x in framework.loads}
        self.places |= {f.name: framework.points[label_of(f.point)] for f in body.forces if f.name not in self.places}
        self.size = max((abs(a - b) for a, b in combinations(framework.points.values(), 2)), default=1.0)

    def refusal(self, key: str, **details: object) -> SceneError:
        """Why this method cannot be used."""
        where = self.scene.where
        line = where.get(("method",), where.get(("supports",), where.get(("points",))))
        return SceneError(Phrase(key, **details), self.scene.file, line)

    def draw(self) -> None:
        """Find all reactions of the body."""
        self.check()
        ways = {
            "moments": self.by_moments,
            "string": self.strings,
            "three-forces": self.single,
            "composition": self.composed,
            "culmann": self.single,
        }
        ways[self.framework.method or self.plainest()]()

    def plainest(self) -> str:
        """A suitable method."""
        b = self.body
        idle = self.turning or not any(self.forces) or bool(b.couples)
        if self.framework.members or idle or (b.anchor and b.anchor.kind == "clamp"):
            return "moments"
        if len(b.forces) == 1 and b.supports:
            line = b.lines[0] if b.lines else None
            meets = line is not None and sine(self.forces[0], self.way(line)) > SLIGHT
            return ("three-forces" if meets else "string") if b.anchor else "culmann"
        return "string"

    def by_moments(self) -> None:
        """By moments; of three lines, about where two meet that are not parallel."""
        b = self.body
        if not b.anchor and b.lines and sine(*map(self.way, b.lines[1:])) <= SLIGHT:
            b.supports = [*max(permutations(b.lines), key=lambda order: sine(*map(self.way, order[1:])))]
        b.by_moments()

    def way(self, s: Support) -> complex:
        """The direction of a reaction's line."""
        points = self.framework.points
        return points[s.to] - points[s.point] if s.to else cmath.rect(1.0, math.radians(s.normal_deg))

    def check(self) -> None:
        """Refuse supports that do not hold: a line through the hinge, three lines through one point or all parallel."""
        b, points = self.body, self.framework.points
        if b.anchor and b.lines:
            line = b.lines[0]
            lever = points[line.point] - points[b.anchor.point]
            if sine(lever, self.way(line)) <= BLUNT:
                raise self.refusal("line_through_hinge", name=line.name, point=b.anchor.point)
        elif not b.anchor and b.lines:
            rows = [self.row(s) for s in b.lines]
            if abs(determinant(rows)) <= BLUNT:
                raise self.refusal("lines_concurrent", names=tuple(s.name for s in b.lines))

    def row(self, s: Support) -> list[float]:
        """Both components of a unit reaction and its moment relative to the size of the scheme."""
        points, way = self.framework.points, self.way(s) / abs(self.way(s))
        place = points[s.point] - next(iter(points.values()))
        return [way.real, way.imag, (place.conjugate() * way).imag / self.size]

    def suits(self, method: str) -> None:
        """Refuse bodies that a method by lines of action cannot solve."""
        b = self.body
        if b.couples:
            raise self.refusal("method_couples", method=method, name=b.couples[0].name)
        if not any(self.forces):
            raise self.refusal("method_forces", method=method)
        if b.anchor and b.anchor.kind == "clamp":
            raise self.refusal("method_clamp", method=method, point=b.anchor.point)

    def strings(self) -> None:
        """By the string polygon: its closing line, or the resultant from it."""
        b = self.body
        self.suits("string")
        steady = not any(isinstance(x.direction_deg, LoadLaw) for x in self.framework.loads)
        beam = StraightBeam(b, self.framework, self.places) if b.anchor and steady else None
        if beam and beam.straight([*self.forces, self.way(b.lines[0])]):
            pairs = sorted(zip(b.forces, self.forces, strict=True), key=beam.load_along)
            b.forces, self.forces = [f for f, _ in pairs], [z for _, z in pairs]
        else:
            beam = None
        b.lay()
        if b.anchor:
            self.pole(b.lines[0])
            drawn = by_strings(b)
            if beam and len(self.framework.bodies) == 1:
                b.figure.moments, b.figure.shears = beam.measure(*drawn)
        else:
            self.by_resultant(*self.resultant())

    def resultant(self) -> tuple[str, str]:
        """The line of the loads' resultant by their string polygon."""
        b, through = self.body, self.framework.through
        if abs(sum(self.forces)) <= BLUNT * max(map(abs, self.forces)):
            raise self.refusal("forces_couple")
        self.pole(None)
        polygon = StringPolygon(b)
        polygon.draw(at(SCHEME, through[0]) if through else b.forces[0].point)
        if through:
            last = str(len(polygon.rays) - 1)
            b.figure.stroke(SCHEME, "string", last, polygon.knots[-1], at(SCHEME, through[-1]))
        return polygon.resultant()

    def pole(self, line: Support | None) -> None:
        """Draw the given pole, one for strings through given points, or a suitable one."""
        b, f = self.body, self.framework
        pole = f.pole or chosen_pole(self.forces, self.way(line) if line else None, self.forces)
        if not f.through:
            lay_pole(b, pole)
            return
        if b.anchor and b.anchor.point != f.through[0]:
            raise self.refusal("through_first", point=b.anchor.point)
        start, way = f.points[f.through[0]], f.points[f.through[-1]] - f.points[f.through[0]]
        along = [((self.places[x.name] - start) * way.conjugate()).real for x in b.forces]
        middle = ((f.points[f.through[1]] - start) * way.conjugate()).real
        before = sum(x < middle for x in along)
        if along != sorted(along) or (len(f.through) == 3 and not 0 < before < len(along)):
            raise self.refusal("through_order", names=f.through)
        pole_through(b, pole, f.through, before)

    def composed(self) -> None:
        """By the resultant of loads composed one after another."""
        self.suits("composition")
        self.body.lay()
        self.by_resultant(*by_composition(self.body))

    def single(self) -> None:
        """One load, or the resultant of all by its string polygon."""
        b = self.body
        method = "culmann" if b.supports and not b.anchor else "three-forces"
        self.suits(self.framework.method or method)
        if self.framework.method not in (None, method):
            raise self.refusal("method_supports", method=self.framework.method)
        b.lay()
        if len(b.forces) == 1:
            self.by_resultant(b.forces[0].point, b.forces[0].along)
            return
        self.by_resultant(*self.resultant())

    def by_resultant(self, point: str, along: str) -> None:
        """The reactions to one force along a line; none where the body has no supports."""
        b, load = self.body, sum(self.forces)
        if not b.supports:
            return
        if b.anchor:
            if sine(load, self.way(b.lines[0])) <= BLUNT:
                raise self.refusal("load_parallel", name=b.lines[0].name)
            b.three_forces(point, along)
        else:
            one, two, three = max(permutations(b.lines), key=lambda order: min(self.sharp(load, order)))
            b.culmann(point, along, (one, two, three))

    def sharp(self, load: complex, order: tuple[Support, ...]) -> Iterator[float]:
        """The sines of the angles at which Culmann's lines meet in a given order."""
        one, two, three = map(self.way, order)
        yield from (round(sine(load, one), 3), round(sine(two, three), 3))
