"""The lines beside the marks of a plan of statics: strings, rays, lines of action, and the symbols of supports."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Literal

from planes.drafting.drawing import Drawing
from planes.scene.mechanism import FRAME, Drive, Link, Mechanism
from planes.scene.structures import Framework, StaticLoad, Support
from planes.words import Phrase
from planes.words.frozen import frozen
from planes.words.names import Mark, NamePair, NameTriple, PlanId

LineKind = Literal["string", "ray", "closing", "action", "culmann", "trial"]


@frozen
class FigureLine:
    """A thin line of a plan from mark to mark, with its letter."""

    plan: PlanId
    kind: LineKind
    name: str
    start: str
    end: str


@dataclass
class StaticsFigure:
    """The data of the framework; then the drawing: the lines of all plans, and resultants from composition by their
    mark and direction."""

    supports: tuple[Support, ...] = ()
    points: Mapping[str, complex] = field(default_factory=dict)  # by name, m
    spread: tuple[StaticLoad, ...] = ()
    members: tuple[NameTriple, ...] = ()  # of a truss, by the names of their forces
    numbered: frozenset[str] = frozenset()  # bodies, where there are several
    pole: complex | None = None  # the pole of its string polygon in the scene, N
    strokes: list[FigureLine] = field(default_factory=list)
    results: list[NameTriple] = field(default_factory=list)
    moments: list[NamePair] = field(default_factory=list)  # of a beam: points with bending moments by name
    shears: list[NameTriple] = field(default_factory=list)  # and shear forces between two points
    knots: list[Mark] = field(default_factory=list)  # lettered points where lines of action meet
    said: dict[str, str] = field(default_factory=dict)  # reasons for the places of marks: keys of words
    poles: list[str] = field(default_factory=list)  # start marks of rays, which are not vectors of a plan
    counted: tuple[Phrase, ...] = ()  # why it is statically determinate
    letters: Mapping[str, complex] = field(default_factory=dict)  # of regions (Bow), by places on the scheme, m

    @classmethod
    def undrawn_figure(cls, f: Framework) -> "StaticsFigure":
        """The figure of a framework, with nothing drawn yet."""
        members = tuple((f"S_{a}{b}", a, b) for a, b in f.members)
        spread = tuple(load for load in f.loads if load.spread)
        numbered = frozenset(f.bodies if len(f.bodies) > 1 else ())
        return cls(f.supports, f.points, spread, members, numbered, f.pole)

    def add_line(self, plan: PlanId, kind: LineKind, name: str, start: str, end: str) -> None:
        """Add a line, unless it has no length."""
        if start != end:
            self.strokes.append(FigureLine(plan, kind, name, start, end))


def framework_as_mechanism(f: Framework, drive: Drive) -> Mechanism:
    """The bodies, rods and hinges as links, for the drawing of the scheme."""
    hinged = [s.point for s in f.supports if s.kind == "hinge"]
    frame = Link(FRAME, MappingProxyType({p: f.points[p] for p in dict.fromkeys((*hinged, *sorted(f.fixed)))}))
    links = {name: Link(name, MappingProxyType(dict(points))) for name, points in _framework_links(f)}
    return Mechanism(frame, MappingProxyType(links), drive)


def _framework_links(f: Framework) -> Iterator[tuple[str, dict[str, complex]]]:
    if f.members:
        yield from (("".join(ends), {p: f.points[p] for p in ends}) for ends in f.members)
    else:
        yield from ((name, {p: f.points[p] for p in points}) for name, points in f.bodies.items())
    yield from ((s.point + s.to, {p: f.points[p] for p in (s.point, s.to)}) for s in f.supports if s.to)


Strain = Literal["tension", "compression", "idle"]
ZERO_FORCE_RATIO = 1e-9  # of the largest force: below this it is zero


def member_strains(figure: StaticsFigure | None, drawing: Drawing) -> dict[str, Strain]:
    """The state of every drawn member, tension, compression or zero, by the name of its force."""
    forces = {n: float(drawing[n]) for n, _, _ in figure.members if n in drawing} if figure else {}
    most = max(map(abs, forces.values()), default=0.0)
    return {
        n: "idle" if abs(v) <= ZERO_FORCE_RATIO * most else "tension" if v > 0 else "compression"
        for n, v in forces.items()
    }
