"""The sheets of a course project, each a list of views; the first, structure and kinematics, is made here."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from planes.solving import Position
from planes.words import say
from planes.words.names import kind_of, mu_of
from render.paper.letters import decimal
from render.paper.marks import Mark, Text
from render.sheet.composer import LARGER, Composer, drawn_plans
from render.sheet.forces import Drawer, ForceSheet, extents
from render.sheet.sizes import Sizes
from render.views import View, beside, stacked, view
from render.views.diagrams import SECTIONS, DiagramCurve, Diagrams, Hodograph, hodograph_view, section_mm
from render.views.many import ManyPositions, Numbered, PlacedMechanism
from render.views.plotted import of_position
from render.views.scheme import Scheme


@dataclass
class Project:
    """Both sheets of a scene. ``values`` are the driver's places over its range (``whole``: a turn) and ``turn`` the
    places there; ``numbered`` are the positions of the scheme; ``curves`` and ``loops`` are the diagrams (of the
    driven link, if the scene asks for no others) and hodographs."""

    composer: Composer
    values: Sequence[float] = ()
    turn: Sequence[PlacedMechanism | None] = ()
    numbered: Sequence[Numbered] = ()
    whole: bool = True
    curves: Sequence[DiagramCurve] = ()
    loops: Sequence[Hodograph] = ()

    def sheet(self, number: int, at: Drawer, sizes: Sizes, letter: float, together: bool) -> list[View]:
        """The views of sheet 1 or 2."""
        if number == 2:
            return ForceSheet(self.composer).views(at, sizes, letter)
        return [v for v in self.kinematics(at(sizes), sizes.of("diagrams"), letter, together) if v]

    def extents(self, number: int, at: Drawer, sizes: Sizes, plans: Mapping[str, float]) -> dict[str, float]:
        """Sizes in mm of what may grow: the plans; on sheet 1 the diagrams, on sheet 2 the groups apart."""
        found = dict(plans)
        if number == 1 and self.turn:
            found["diagrams"] = section_mm(sizes.of("diagrams")) * SECTIONS
        if number == 2 and "position" in plans:
            found |= extents(at, sizes)
        return found

    @staticmethod
    def shows(number: int) -> Callable[[str], bool]:
        """Whether a kind of plans is on that sheet; the lever is drawn like the velocity plan."""
        kinds = ("position", "velocity", "acceleration") if number == 1 else ("position", "velocity", "motion", "force")
        return lambda kind: kind in kinds

    # sheet 1

    def kinematics(self, position: Position, size: float, letter: float, together: bool) -> list[View | None]:
        """Scheme in many positions, groups, plans of rates, tables, diagrams."""
        c, plotted = self.composer, of_position(position)
        rates = [p for p in drawn_plans(plotted, position) if kind_of(p) != "force"]
        tables = c.tables(position, letter)
        found = [self.many(position), *c.plans(plotted, rates, letter, together), self.groups(position, letter)]
        found += [tables.given(), tables.plan("velocity"), tables.plan("acceleration"), tables.links()]
        return [*found, self.diagrams(position, size), self.hodographs()]

    def many(self, position: Position) -> View | None:
        """The scheme, in the calculated position thick, in twelve more thin."""
        c, mu = self.composer, position.scales[mu_of("position")]
        if not self.numbered:
            return c.scheme(position)
        title = f"{say('scheme', c.lang)}, {c.mu(of_position(position), 'position')}"

        def make() -> View:
            many = ManyPositions(position.plans, self.numbered, self.turn, mu)
            drawn = Scheme(position, c.naming).drawn(True, many.marks(), many.labels())
            return view("scheme", title, drawn, True, many.unseen(title, c.lang), "position")

        return c.once(("many", mu), make)

    def groups(self, position: Position, letter: float) -> View | None:
        """The primary mechanism and the groups of Assur apart, with W, q and the formula of structure."""
        c, structure = self.composer, position.plans.structure

        def make() -> View:
            parts = [self.part(position, (structure.driver,), say("primary", c.lang), True, letter)]
            for g in structure.groups:
                links = "–".join(c.naming.link(x) for x in g.links)
                text = say("group_of_kind", c.lang, links=links, kind=g.kind)
                parts.append(self.part(position, g.links, text, False, letter))
            row = beside(parts)
            w, q = decimal(str(structure.W), c.lang), decimal(str(structure.q), c.lang)
            lines = [f"W = 3n − 2p_{{1}} = {w};  q = W − 6n + 5p_{{1}} = {q}", self.formula(position)]
            high = LARGER[letter]
            marks: list[Mark] = [Text(t, complex(0, -1.9 * high * k), high, "middle") for k, t in enumerate(lines)]
            return stacked("structure", [row, view("formula", "", marks)])

        key = ("groups", position.scales[mu_of("position")], letter)
        titled = c.once(key, make)
        assert titled
        return c.once((*key, "title"), lambda: view("structure", say("structure", c.lang), titled.marks, figure=True))

    def formula(self, position: Position) -> str:
        """The formula of structure with the numbers of this sheet: I(0;1) → II(2;3)."""
        c, s = self.composer, position.plans.structure
        parts = [f"I({c.naming.link('0')};{c.naming.link(s.driver)})"]
        parts += [f"II_{{{g.kind}}}({';'.join(c.naming.link(x) for x in g.links)})" for g in s.groups]
        return " → ".join(parts)

    def part(self, position: Position, links: tuple[str, ...], text: str, framed: bool, letter: float) -> View:
        """Some links by themselves, with words beneath."""
        drawn = view("part", "", Scheme(position, self.composer.naming, links, framed).drawn(False))
        words = view("part", "", [Text(text, 0j, LARGER[letter] * 0.7, "middle")])
        return stacked("part", [drawn, words], 3.0)

    def diagrams(self, position: Position, size: float = 1.0) -> View | None:
        """Diagrams of motion over the driver's range."""
        if sum(r is not None for r in self.turn) < 3:
            return None
        c, section = self.composer, section_mm(size)
        found = Diagrams(position.plans, self.values, self.curves, c.naming, section, self.whole)
        return c.once(("diagrams", section), lambda: view("diagrams", found.title, found.drawn(), figure=True))

    def hodographs(self) -> View | None:
        """The hodographs the scene asks for."""
        c = self.composer
        return c.once(("hodographs",), lambda: hodograph_view(self.loops, c.naming)) if self.loops else None
