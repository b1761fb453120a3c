"""The space diagram of bodies in equilibrium: bodies or members, supports, loads, strings and lines of action."""

import math
from collections.abc import Iterator
from dataclasses import dataclass

from planes.geometry.plane import toward
from planes.plans.position.bodies import SCHEME
from planes.plans.structures.figure import StaticsFigure, strains
from planes.scene.mechanism import Link
from planes.scene.structures import ALONE, StaticLoad, Support
from planes.solving import Position
from planes.words.names import at, label_of
from planes.words.naming import Naming
from render.labels import Label
from render.paper import symbols
from render.paper.marks import Arrow, Line, Mark
from render.paper.symbols import Marks
from render.views.loading import Loading
from render.views.plotted import NEAR_MM, degrees, scheme_mu
from render.views.scheme import Scheme
from render.views.strings import STRING_MM, drawn_strokes

REGION_MM = 5.0  # letters of regions
SPREAD_MM, SPREAD_GAP_MM = 9.0, 9.0  # height of a distributed load, and distance of its arrows


class BodyScheme(Scheme):
    """The scheme of bodies: bars from point to point as the file has them, numbered only where there are several."""

    def link(self, link: Link) -> None:
        """A body, a rod or a member."""
        joints = [self.places.at(p) for p in link.points]
        self.bars += symbols.bar(*joints)
        self.number(link, joints)
        for k, p in enumerate(link.points):
            self.ways.setdefault(p, []).extend(z - joints[k] for z in joints[max(k - 1, 0) : k + 2])

    def number(self, link: Link, outline: list[complex]) -> None:
        """The number of one body of several."""
        figure = self.position.plans.figure
        if figure and link.name in figure.numbered:
            super().number(link, outline)


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

    def drawn(self) -> Marks:
        """All marks with their letters."""
        strokes, named = drawn_strokes(self.position.drawing, None if self.asked else self.figure, SCHEME)
        signs = [m for s in self.figure.supports for m in self.sign(s)]
        members = [] if self.asked else list(self.members())
        loading = self.loads()
        scheme = self.scheme
        more = [*strokes, *members, *signs, *loading.marks]
        more += [m for x in self.figure.spread for m in self.spread(x)]
        return scheme.drawn(False, more, [*named, *loading.named, *([] if self.asked else self.knots())])

    def at(self, mark: str) -> complex:
        """The place of a mark on the paper, or a direction."""
        return complex(self.position.drawing[mark])

    def loads(self) -> Loading:
        """Loads, reactions towards their points, and resultants of composition."""
        plans = self.position.plans
        loading = Loading(self.position, self.naming, () if self.figure.members else tuple(plans.mechanism.links))
        loading.loads(False, from_outside=True)
        for f in plans.acting.forces.get(ALONE, ()):
            if f.spot and self.figure.members:
                way = self.at(f.along) * math.copysign(1.0, float(self.position.drawing[f.size]))
                loading.force(f.name, self.at(f.point), way, from_outside=True)
        for s in () if self.asked else self.figure.supports:
            start, end = (self.at(x) for x in plans.vectors[s.name])
            if abs(end - start) > NEAR_MM and not s.to:
                loading.force(s.name, self.places.at(s.point), toward(start, end))
        for name, mark, along in () if self.asked else self.figure.results:
            loading.force(name, self.at(mark), self.at(along))
        return loading

    def knots(self) -> Iterator[Label]:
        """Letters of the points where lines of action meet, and of regions."""
        mu = scheme_mu(self.position)
        for text, z in self.figure.letters.items():
            yield Label(text, z * mu, REGION_MM, name=f"region {text}")
        for mark in self.figure.knots:
            yield Label(self.naming.point(label_of(mark)), self.at(mark), STRING_MM, clear=0.8, name=mark)

    def members(self) -> Iterator[Mark]:
        """The members of a truss, by tension and compression."""
        senses = strains(self.figure, self.position.drawing)
        for name, one, other in self.figure.members:
            sense = senses.get(name, "idle")
            style = "thin" if sense == "idle" else "thick"
            yield Line((self.at(at(SCHEME, one)), self.at(at(SCHEME, other))), style, name=f"{sense} {name}")

    # signs

    def sign(self, s: Support) -> Marks:
        """A roller on its base, a clamp's wall; hinges are drawn with the bodies."""
        z = self.places.at(s.point)
        if s.kind == "roller":
            return symbols.roller(z, s.normal_deg - 90.0)
        return self.wall(z, s.point) if s.kind == "clamp" else ()

    def wall(self, z: complex, point: str) -> Marks:
        """The wall of a clamp: across the body there, hatched on the far side."""
        points = next(x.points for x in self.position.plans.mechanism.links.values() if point in x.points)
        others = [self.places.at(p) - z for p in points if p != point]
        way = min(others, key=abs, default=1 + 0j)
        return symbols.wall(z, degrees(way))

    def spread(self, load: StaticLoad) -> Iterator[Mark]:
        """A distributed load: arrows beneath one line, as high as its intensities."""
        assert load.spread
        start, end = (self.places.at(p) for p in load.spread)
        way = symbols.unit(load.steady_deg)
        high = [SPREAD_MM * abs(q) / max(map(abs, load.intensity)) for q in load.intensity]
        count = max(2, round(abs(end - start) / SPREAD_GAP_MM))
        tops = [start - high[0] * way, end - high[1] * way]
        yield Line((tops[0], tops[1]), "thin", "force")
        for k in range(count + 1):
            share = k / count
            foot, top = start + share * (end - start), tops[0] + share * (tops[1] - tops[0])
            if abs(foot - top) > 2.0:
                yield Arrow(top, foot, "thin", "force")
