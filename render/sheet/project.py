"""The two sheets of a course project: 1, structure and kinematics; 2, forces. Each is a list of views."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from planes.naming import mu_of
from planes.solving import Position
from render.marks import Mark, Text
from render.sheet.composer import LARGER, Composer, drawn_plans
from render.views import View, stacked, view
from render.views.diagrams import Diagrams
from render.views.lever import Lever
from render.views.loading import Loading
from render.views.many import Many
from render.views.moments import MomentLines
from render.views.plotted import of_position
from render.views.scheme import Scheme
from render.views.tables import Tables
from render.words import decimal, say


@dataclass
class Project:
    """Both sheets of a scene. ``angles`` and ``turn`` are a whole turn of the driver, ``twelve`` its positions."""

    composer: Composer
    angles: Sequence[float] = ()
    turn: Sequence[dict[str, Any] | None] = ()
    twelve: Sequence[dict[str, Any] | None] = field(default_factory=tuple)

    def sheet(self, number: int, position: Position, letter: float, together: bool) -> list[View]:
        """The views of sheet 1 or 2."""
        found = self.kinematics(position, letter, together) if number == 1 else self.forces(position, letter)
        return [v for v in found if v]

    # sheet 1

    def kinematics(self, position: Position, letter: float, together: bool) -> list[View | None]:
        """Scheme in many positions, groups, plans of rates, tables, diagrams."""
        c, plotted = self.composer, of_position(position)
        rates = [p for p in drawn_plans(plotted, position) if not p.startswith("force")]
        tables = Tables(position, c.naming, letter)
        found = [self.many(position), *c.plans(plotted, rates, letter, together), self.groups(position, letter)]
        found += [tables.given(), tables.plan("velocity"), tables.plan("acceleration"), tables.links()]
        return [*found, self.diagrams(position)]

    def many(self, position: Position) -> View | None:
        """The scheme, in the calculated position thick, in twelve more thin."""
        c, mu = self.composer, position.scales[mu_of("position")]
        if not self.twelve:
            return c.scheme(position)
        title = f"{say('scheme', c.lang)}, {c.mu(of_position(position), 'position')}"

        def make() -> View:
            many = Many(position.plans, self.twelve, self.turn, mu)
            drawn = Scheme(position, c.naming).drawn(True, many.marks(), many.labels())
            return view("scheme", title, drawn, figure=True)

        return c.once(("many", mu), make)

    def groups(self, position: Position, letter: float) -> View | None:
        """The primary mechanism and the groups of Assur apart, with W, q and the formula of structure."""
        c, structure = self.composer, position.plans.structure

        def make() -> View:
            parts = [self.part(position, (structure.driver,), say("primary", c.lang), True, letter)]
            for g in structure.groups:
                links = "–".join(c.naming.link(x) for x in g.links)
                text = say("group", c.lang, links=links, kind=g.kind)
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

    def diagrams(self, position: Position) -> View | None:
        """Diagrams of motion over the turn."""
        if sum(r is not None for r in self.turn) < 3:
            return None
        found = Diagrams(position.plans, self.angles, self.turn, self.composer.naming)
        return self.composer.once(("diagrams",), lambda: view("diagrams", found.title, found.drawn(), figure=True))

    # sheet 2

    def forces(self, position: Position, letter: float) -> list[View | None]:
        """Scheme with loads, every group with its forces and its plan, the driver, the lever, tables."""
        c, plotted = self.composer, of_position(position)
        found: list[View | None] = [self.loaded(position)]
        for plan in (p for p in position.plans.drawn if p.startswith("force")):
            links = tuple(plan.partition(":")[2].split("-"))
            apart = self.group(position, plan, links)
            moments = self.moments(position, links, letter)
            drawn = c.plan(plotted, plan)
            written = c.formulas(plotted, (plan,), letter, "")
            found.append(stacked("group", [v for v in (apart, moments) if v], 5.0))
            found.append(stacked(plan, [v for v in (drawn, written) if v]))
        found.append(self.lever(position, letter))
        tables = Tables(position, c.naming, letter)
        return [*found, tables.reactions(), tables.check()]

    def loaded(self, position: Position) -> View | None:
        """The scheme with all outer loads."""
        c = self.composer

        def make() -> View:
            loading = Loading(position, c.naming, tuple(position.plans.mechanism.links))
            loading.loads(carried=False)
            drawn = Scheme(position, c.naming).drawn(True, loading.marks, loading.named)
            title = f"{say('loaded', c.lang)}, {c.mu(of_position(position), 'position')}"
            return view("loaded", title, drawn, figure=True)

        return c.once(("loaded", position.scales[mu_of("position")]), make)

    def group(self, position: Position, plan: str, links: tuple[str, ...]) -> View | None:
        """A group apart with its forces, reactions and arms."""
        c = self.composer

        def make() -> View:
            loading = Loading(position, c.naming, links)
            loading.loads(carried=True)
            loading.reactions(plan)
            if position.plans.structure.driver in links:
                loading.balancing()
            loading.arms([m for m in position.plans.moments if set(m.links) <= set(links)])
            drawn = Scheme(position, c.naming, links, False).drawn(False, loading.marks, loading.named)
            numbers = "–".join(c.naming.link(x) for x in links)
            key = "loaded_group" if len(links) > 1 else "loaded_driver"
            title = f"{say(key, c.lang, links=numbers)}, {c.mu(of_position(position), 'position')}"
            return view("group", title, drawn, figure=True)

        return c.once(("loaded", links, position.scales[mu_of("position")]), make)

    def moments(self, position: Position, links: tuple[str, ...], letter: float) -> View | None:
        """The moment equations of some links."""
        c = self.composer

        def make() -> View | None:
            lines = MomentLines(position, c.naming, LARGER[letter])
            marks = lines.drawn(links)
            return view("moments", "", marks) if marks else None

        return c.once(("moments of", links, letter), make)

    def lever(self, position: Position, letter: float) -> View | None:
        """Zhukovsky's lever with its moment equation."""
        c, found = self.composer, Lever(position, self.composer.naming)
        if not found.there:
            return None
        kind = "motion" if position.plans.at_rest else "velocity"
        key, title = ("lever", position.scales[mu_of(kind)]), say("lever", c.lang)
        drawn = c.once(key, lambda: view("lever", title, found.drawn(), figure=True))
        written = self.moments(position, ("lever",), letter)
        return stacked("lever", [v for v in (drawn, written) if v])


def beside(views: Sequence[View], gap: float = 8.0) -> View:
    """Views one beside the other, their lower edges in one line, as one view."""
    marks: list[Mark] = []
    x, low, high = 0.0, 0.0, 0.0
    for one in views:
        marks += one.placed(x, one.height)
        x, high = x + one.width + gap, max(high, one.height)
    return View("row", "", tuple(marks), (0.0, low, x - gap, high))
