"""The space diagram of bodies in equilibrium: bodies or members, supports, loads, strings and lines of action."""

import math
from collections.abc import Iterator
from dataclasses import dataclass

from planes.geometry.plane import direction_between
from planes.plans.structures.figure import StaticsFigure, member_strains
from planes.scene.mechanism import Link
from planes.scene.structures import ONLY_BODY_NAME, StaticLoad, Support
from planes.solving import Position
from planes.words.names import SCHEME_PLAN, scheme_mark
from planes.words.naming import Naming
from render.labels import Label
from render.paper import symbols
from render.paper.marks import Arrow, Line, Mark
from render.paper.symbols import Marks
from render.views.loading import Loading
from render.views.plotted import SAME_PLACE_MM, direction_deg, scheme_mu
from render.views.scheme import Scheme
from render.views.strings import STRING_LETTER_MM, string_and_ray_lines

REGION_LETTER_MM = 5.0  # letters of regions
# height of a distributed load, and distance of its arrows
DISTRIBUTED_LOAD_HEIGHT_MM = 9.0
DISTRIBUTED_ARROW_GAP_MM = 9.0


class BodyScheme(Scheme):
    """The scheme of bodies: bars from point to point as the file has them, numbered only where there are several."""

    def add_link(self, link: Link) -> None:
        """A body, a rod or a member."""
        joints = [self.places.point_place(p) for p in link.points]
        self.bars += symbols.bar(*joints)
        self.add_link_number(link, joints)
        for k, p in enumerate(link.points):
            self.ways.setdefault(p, []).extend(z - joints[k] for z in joints[max(k - 1, 0) : k + 2])

    def add_link_number(self, link: Link, outline: list[complex]) -> None:
        """The number of one body of several."""
        figure = self.position.plans.figure
        if figure and link.name in figure.numbered:
            super().add_link_number(link, outline)


@dataclass
class SpaceDiagram:
    """The diagram being drawn."""

    position: Position
    naming: Naming
    asked: bool = False  # of a task: bodies, supports and loads, without results

    def __post_init__(self) -> None:
        plans = self.position.plans
        assert plans.figure
        self.figure: StaticsFigure = plans.figure
        self.scheme = BodyScheme(self.position, self.naming)
        self.places = self.scheme.places

    def drawn_marks(self) -> Marks:
        """All marks with their letters."""
        strokes, named = string_and_ray_lines(self.position.drawing, None if self.asked else self.figure, SCHEME_PLAN)
        signs = [m for s in self.figure.supports for m in self.support_sign_marks(s)]
        members = [] if self.asked else list(self.member_lines())
        loading = self.loads_and_reactions()
        scheme = self.scheme
        more = [*strokes, *members, *signs, *loading.marks]
        more += [m for x in self.figure.spread for m in self.distributed_load_marks(x)]
        return scheme.drawn_marks(
            False, more, [*named, *loading.named, *([] if self.asked else self.crossing_and_region_letters())]
        )

    def mark_place(self, mark: str) -> complex:
        """The place of a mark on the paper, or a direction."""
        return complex(self.position.drawing[mark])

    def loads_and_reactions(self) -> Loading:
        """Loads, reactions towards their points, and resultants of composition."""
        plans = self.position.plans
        loading = Loading(self.position, self.naming, () if self.figure.members else tuple(plans.mechanism.links))
        loading.draw_loads(False, from_outside=True)
        for f in plans.acting.forces.get(ONLY_BODY_NAME, ()):
            if f.spot and self.figure.members:
                way = self.mark_place(f.along) * math.copysign(1.0, float(self.position.drawing[f.size]))
                loading.draw_force(f.name, self.mark_place(f.point), way, from_outside=True)
        for s in () if self.asked else self.figure.supports:
            start, end = (self.mark_place(x) for x in plans.vectors[s.name])
            if abs(end - start) > SAME_PLACE_MM and not s.to:
                loading.draw_force(s.name, self.places.point_place(s.point), direction_between(start, end))
        for name, mark, along in () if self.asked else self.figure.results:
            loading.draw_force(name, self.mark_place(mark), self.mark_place(along))
        return loading

    def crossing_and_region_letters(self) -> Iterator[Label]:
        """Letters of the points where lines of action meet, and of regions."""
        mu = scheme_mu(self.position)
        for text, z in self.figure.letters.items():
            yield Label(text, z * mu, REGION_LETTER_MM, name=f"region {text}")
        for mark in self.figure.knots:
            yield Label(
                self.naming.lettered_point(mark.label), self.mark_place(mark), STRING_LETTER_MM, clear=0.8, name=mark
            )

    def member_lines(self) -> Iterator[Mark]:
        """The members of a truss, by tension and compression."""
        senses = member_strains(self.figure, self.position.drawing)
        for name, one, other in self.figure.members:
            sense = senses.get(name, "idle")
            style = "thin" if sense == "idle" else "thick"
            yield Line(
                (self.mark_place(scheme_mark(one)), self.mark_place(scheme_mark(other))), style, name=f"{sense} {name}"
            )

    # signs

    def support_sign_marks(self, s: Support) -> Marks:
        """A roller on its base, a clamp's wall; hinges are drawn with the bodies."""
        z = self.places.point_place(s.point)
        if s.kind == "roller":
            return symbols.roller(z, s.normal_deg - 90.0)
        return self.clamp_wall_marks(z, s.point) if s.kind == "clamp" else ()

    def clamp_wall_marks(self, z: complex, point: str) -> Marks:
        """The wall of a clamp: across the body there, hatched on the far side."""
        points = next(x.points for x in self.position.plans.mechanism.links.values() if point in x.points)
        others = [self.places.point_place(p) - z for p in points if p != point]
        way = min(others, key=abs, default=1 + 0j)
        return symbols.clamp_wall(z, direction_deg(way))

    def distributed_load_marks(self, load: StaticLoad) -> Iterator[Mark]:
        """A distributed load: arrows beneath one line, as high as its intensities."""
        assert load.spread
        start, end = (self.places.point_place(p) for p in load.spread)
        way = symbols.unit_vector(load.constant_direction_deg)
        high = [DISTRIBUTED_LOAD_HEIGHT_MM * abs(q) / max(map(abs, load.intensity)) for q in load.intensity]
        count = max(2, round(abs(end - start) / DISTRIBUTED_ARROW_GAP_MM))
        tops = [start - high[0] * way, end - high[1] * way]
        yield Line((tops[0], tops[1]), "thin", "force")
        for k in range(count + 1):
            share = k / count
            foot = start + share * (end - start)
            top = tops[0] + share * (tops[1] - tops[0])
            if abs(foot - top) > 2.0:
                yield Arrow(top, foot, "thin", "force")
