"""The first sheet of a course project, structure and kinematics, as a list of views."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

from planes.plans.assur.alignment import aligned
from planes.plans.measuring import counted
from planes.solving import Position
from planes.solving.structure_text import ways_told
from planes.words import say
from planes.words.errors import PlanesError
from planes.words.names import kind_of
from render.labels.footprints import bounds
from render.paper.marks import Text
from render.paper.style import LARGER
from render.paper.typeset import plain
from render.sheet.composer import Composer, Together, drawn_plans
from render.sheet.module import GAP_MM, MODULE_MM
from render.views import View, beside, remark, stacked, view
from render.views.alignment import alignment_told
from render.views.diagrams import DiagramCurve, Diagrams, section_mm
from render.views.dimensions import driver_angle, frame_sizes, sizes_drawn
from render.views.directions import Directions
from render.views.hodographs import Hodograph, hodograph_view
from render.views.many import ManyPositions, Numbered, PlacedMechanism
from render.views.plotted import of_position, scheme_mu
from render.views.scheme import Scheme
from render.views.special_points import special_points

REDUCED_MM = (105.0, 75.0)
"""The size of the scheme at whose μ the groups are drawn, and the size for groups that would otherwise be too wide."""


@dataclass
class Project:
    """The views of sheet 1. ``values`` are the driver's positions over its range (``whole``: a turn) and ``turn`` the
    places there; ``numbered`` are the positions of the scheme; ``curves`` and ``loops`` are the diagrams (by default of
    the driven link) and hodographs; ``reduced`` draws the position with its scheme reduced to so many mm."""

    composer: Composer
    values: Sequence[float] = ()
    turn: Sequence[PlacedMechanism | None] = ()
    numbered: Sequence[Numbered] = ()
    whole: bool = True
    curves: Sequence[DiagramCurve] = ()
    loops: Sequence[Hodograph] = ()
    reduced: Callable[[float], Position] | None = None
    known: dict[float, ManyPositions] = field(default_factory=dict, repr=False)

    def kinematics(self, position: Position, size: float, letter: float, together: Together) -> list[View]:
        """Sheet 1: scheme in many positions, groups, velocity and acceleration plans, tables, diagrams."""
        c, plotted = self.composer, of_position(position)
        rates = [p for p in drawn_plans(plotted, position) if kind_of(p) != "force"]
        t, plans = c.tables(position, letter), c.plans(plotted, rates, letter, together.equations)
        for k, (plan, v) in enumerate(zip(rates, plans, strict=False)):
            if v:
                plans[k] = replace(v, block="rates", plumb=v.inked[0] - c.plan(plotted, plan).inked[0])  # of its pole
        motion = [v and replace(v, block="motion") for v in (self.many(position), self.diagrams(position, size))]
        steps = {
            "motion": (*motion, self.hodographs()),
            "rates": (*plans, *t.rates(together.rates), t.links(), self.directions(position), t.transfers()),
            "structure": (
                self.groups(position, letter),
                self.self_aligning(position, letter),
                t.given(),
                *c.notes(letter),
            ),
        }
        return [replace(v, step=step) for step, views in steps.items() for v in views if v]

    def many(self, position: Position) -> View | None:
        """The scheme, in the calculated position thick, in twelve others thin."""
        c, mu = self.composer, scheme_mu(position)
        if not self.numbered:
            return c.scheme(position)

        def make() -> View:
            many, title = self.positions(position, mu), c.titled(position, "scheme")
            scheme, thin = Scheme(position, c.naming), many.marks
            angle, named = driver_angle(scheme.places, c.naming)
            strokes = many.strokes(c.lang)
            frame = frame_sizes(scheme.places, mu, bounds([*thin, *sizes_drawn(strokes)]), c.lang)
            crossed, letters = special_points(position, c.naming)
            sizes = sizes_drawn([*strokes, *frame], [*thin, *scheme.strokes])
            marks = [*thin, *angle, *sizes, *crossed]
            drawn = scheme.drawn(True, marks, [*named, *many.labels(), *letters])
            for text in (unseen := many.unseen(c.lang)):
                drawn = (*drawn, *remark(f"({text})", drawn))
            said = (say("in_view", c.lang, view=plain(title), text=text) for text in unseen)
            return view("scheme", title, drawn, True, said)

        return c.once(("many", mu), make)

    def positions(self, position: Position, mu: float) -> ManyPositions:
        """The numbered positions at a μ, computed only once."""
        if mu not in self.known:
            self.known[mu] = ManyPositions(position.plans, self.numbered, self.turn, mu)
        return self.known[mu]

    def directions(self, position: Position) -> View | None:
        """The small figures of directions."""
        c = self.composer
        return c.once(("directions",), lambda: Directions(position, c.naming).view(say("directions", c.lang)))

    def groups(self, position: Position, letter: float) -> View | None:
        """The structure: its figures have no μ, and are smaller than the scheme, still smaller if they are wider than
        the title block."""
        c = self.composer

        def make() -> View:
            figure = self.structure(position, letter)
            for k, mm in enumerate(REDUCED_MM):
                if self.reduced and (not k or figure.width > MODULE_MM - GAP_MM):
                    figure = min(figure, self.structure(self.reduced(mm), letter), key=lambda v: v.width * v.height)
            return figure

        return c.once(("groups", scheme_mu(position), letter), make)

    def structure(self, position: Position, letter: float) -> View:
        """The primary mechanism and the Assur groups separately, with W, q and the structural formula."""
        c, structure = self.composer, position.plans.structure
        parts = [self.part(position, (structure.driver,), say("primary", c.lang), True, letter)]
        for g in structure.groups:
            text = say("group_named", c.lang, links="–".join(map(c.naming.link, g.whole)), said=g.brief)
            parts.append(self.part(position, g.whole, text, False, letter))
        lines = [";  ".join(counted(structure)), structure.formula_as(c.naming.frame, True)]
        lines += ways_told(structure, c.lang, c.naming.frame, True)
        passive = ", ".join(map(c.naming.link, structure.passive))
        lines += [say("passive_link", c.lang, links=passive)] if passive else []
        high = LARGER[letter]
        marks = [Text(t, complex(0, -1.9 * high * k), high, "middle") for k, t in enumerate(lines)]
        stack = stacked("structure", [beside(parts), view("formula", "", marks)], 5.0)
        return view("structure", say("structure", c.lang), stack.marks, figure=True)

    def self_aligning(self, position: Position, letter: float) -> View | None:
        """The variant without redundant constraints: its count, and the signs of its pairs. It is left out only where
        the scene names a format without room for it."""
        c = self.composer

        def make() -> View | None:
            try:
                variant = aligned(position.plans, c.scene.file)
            except PlanesError:
                return None
            picture = alignment_told(variant, c.naming, say("self_aligning", c.lang), letter)
            return replace(picture, extra=c.scene.sheet.get("format", "auto") != "auto")

        return c.written(("self-aligning", letter), make)

    def part(self, position: Position, links: tuple[str, ...], text: str, framed: bool, letter: float) -> View:
        """Some links by themselves, with words beneath."""
        c, mu = self.composer, scheme_mu(position)
        drawer = Scheme(position, c.naming, links, framed)
        drawn = c.once(("part", links, mu), lambda: view("part", "", drawer.drawn(False)))
        return stacked("part", [drawn, view("part", "", [Text(text, 0j, letter, "middle")])], 3.0, True)

    def diagrams(self, position: Position, size: float = 1.0) -> View | None:
        """Diagrams of motion over the driver's range."""
        if sum(r is not None for r in self.turn) < 3:
            return None
        c, section = self.composer, section_mm(size)
        drawer = Diagrams(position.plans, self.values, [[c] for c in self.curves], c.naming, section, self.whole)
        return c.once(("diagrams", section), lambda: view("diagrams", drawer.title, drawer.drawn()))

    def hodographs(self) -> View | None:
        """The hodographs named in the scene."""
        c = self.composer
        return c.once(("hodographs",), lambda: hodograph_view(self.loops, c.naming)) if self.loops else None
