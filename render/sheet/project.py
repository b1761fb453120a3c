"""The sheets of a course project, each a list of views.

The first: structure and kinematics. The second, forces: every group apart with its loads, its plan and its links; the
driver; the lever.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from planes.plans.alignment import aligned
from planes.plans.measuring import counted, formula_of
from planes.solving import Position
from planes.words import say
from planes.words.errors import PlanesError
from planes.words.names import POLE, at, kind_of, links_of, mu_of
from render.labels.footprints import bounds
from render.paper.marks import Mark, Text
from render.sheet.composer import LARGER, Composer, drawn_plans
from render.views import View, beside, stacked, view
from render.views.alignment import alignment_told
from render.views.diagrams import DiagramCurve, Diagrams, section_mm
from render.views.dimensions import driver_angle, frame_sizes, sizes_drawn
from render.views.directions import Directions
from render.views.hodographs import Hodograph, hodograph_view
from render.views.loading import Loading
from render.views.many import ManyPositions, Numbered, PlacedMechanism
from render.views.moments import Lever
from render.views.plotted import Places, of_position
from render.views.scheme import Scheme
from render.views.special_points import special_points


@dataclass
class Project:
    """The views of sheet 1. ``values`` are the driver's places over its range (``whole``: a turn) and ``turn`` the
    places there; ``numbered`` are the positions of the scheme; ``curves`` and ``loops`` are the diagrams (of the
    driven link, if the scene asks for no others) and hodographs."""

    composer: Composer
    values: Sequence[float] = ()
    turn: Sequence[PlacedMechanism | None] = ()
    numbered: Sequence[Numbered] = ()
    whole: bool = True
    curves: Sequence[DiagramCurve] = ()
    loops: Sequence[Hodograph] = ()

    def kinematics(self, position: Position, size: float, letter: float, together: bool) -> list[View]:
        """Sheet 1: scheme in many positions, groups, plans of rates, tables, diagrams."""
        c, plotted = self.composer, of_position(position)
        rates = [p for p in drawn_plans(plotted, position) if kind_of(p) != "force"]
        t, plans = c.tables(position, letter), c.plans(plotted, rates, letter, together)
        for k, (plan, v) in enumerate(zip(rates, plans, strict=False)):
            if v:
                plans[k] = replace(v, block="rates", plumb=v.inked[0] - c.plan(plotted, plan).inked[0])  # of its pole
        motion = [v and replace(v, block="motion") for v in (self.many(position), self.diagrams(position, size))]
        steps = {
            "motion": (*motion, self.hodographs()),
            "rates": (
                *plans,
                t.plan("velocity"),
                t.plan("acceleration"),
                t.links(),
                self.directions(position),
                t.transfers(),
            ),
            "structure": (
                self.groups(position, letter),
                self.self_aligning(position, letter),
                t.given(),
                c.note(letter),
            ),
        }
        return [replace(v, step=step) for step, views in steps.items() for v in views if v]

    def many(self, position: Position) -> View | None:
        """The scheme, in the calculated position thick, in twelve more thin."""
        c, mu = self.composer, position.scales[mu_of("position")]
        if not self.numbered:
            return c.scheme(position)

        def make() -> View:
            many, title = ManyPositions(position.plans, self.numbered, self.turn, mu), c.titled(position, "scheme")
            scheme, thin = Scheme(position, c.naming), many.marks()
            angle, named = driver_angle(scheme.places, c.naming)
            strokes = many.strokes(c.lang)
            frame = frame_sizes(scheme.places, mu, bounds([*thin, *sizes_drawn(strokes)]), c.lang)
            crossed, letters = special_points(position, c.naming)
            marks = [*thin, *angle, *sizes_drawn([*strokes, *frame]), *crossed]
            drawn = scheme.drawn(True, marks, [*named, *many.labels(), *letters])
            return view("scheme", title, drawn, True, many.unseen(title, c.lang), "position")

        return c.once(("many", mu), make)

    def directions(self, position: Position) -> View | None:
        """The small figures of directions."""
        c = self.composer
        return c.once(("directions",), lambda: Directions(position, c.naming).view(say("directions", c.lang)))

    def groups(self, position: Position, letter: float) -> View | None:
        """The primary mechanism and the groups of Assur apart, with W, q and the formula of structure."""
        c, structure = self.composer, position.plans.structure

        def make() -> View:
            parts = [self.part(position, (structure.driver,), say("primary", c.lang), True, letter)]
            for g in structure.groups:
                text = say("group_named", c.lang, links="–".join(map(c.naming.link, g.whole)), said=g.brief)
                parts.append(self.part(position, g.whole, text, False, letter))
            lines = [";  ".join(counted(structure)), formula_of(structure, c.naming.frame, True)]
            passive = ", ".join(map(c.naming.link, structure.passive))
            lines += [say("passive_link", c.lang, links=passive)] if passive else []
            high = LARGER[letter]
            marks: list[Mark] = [Text(t, complex(0, -1.9 * high * k), high, "middle") for k, t in enumerate(lines)]
            whole = stacked("structure", [beside(parts), view("formula", "", marks)])
            return view("structure", say("structure", c.lang), whole.marks, figure=True)

        return c.once(("groups", position.scales[mu_of("position")], letter), make)

    def self_aligning(self, position: Position, letter: float) -> View | None:
        """The variant without redundant constraints: its count, and the signs of its pairs."""
        c = self.composer

        def make() -> View | None:
            try:
                found = aligned(position.plans, c.scene.file)
            except PlanesError:
                return None
            return replace(alignment_told(found, c.naming, say("self_aligning", c.lang), letter), extra=True)

        return c.once(("self-aligning", letter), make)

    def part(self, position: Position, links: tuple[str, ...], text: str, framed: bool, letter: float) -> View:
        """Some links by themselves, with words beneath."""
        drawn = view("part", "", Scheme(position, self.composer.naming, links, framed).drawn(False))
        return stacked("part", [drawn, view("part", "", [Text(text, 0j, LARGER[letter] * 0.7, "middle")])], 3.0, True)

    def diagrams(self, position: Position, size: float = 1.0) -> View | None:
        """Diagrams of motion over the driver's range."""
        if sum(r is not None for r in self.turn) < 3:
            return None
        c, section = self.composer, section_mm(size)
        found = Diagrams(position.plans, self.values, [[c] for c in self.curves], c.naming, section, self.whole)
        return c.once(("diagrams", section), lambda: view("diagrams", found.title, found.drawn()))

    def hodographs(self) -> View | None:
        """The hodographs the scene asks for."""
        c = self.composer
        return c.once(("hodographs",), lambda: hodograph_view(self.loops, c.naming)) if self.loops else None


GROUPS = "groups"
"""The name under which all groups apart grow: they have one μ, which is not that of the scheme."""


def group_size(position: Position) -> float:
    """The size in mm of the largest group apart."""
    places, forces = Places(position), (p for p in position.plans.drawn if kind_of(p) == "force")
    return max((places.size(links_of(plan)) for plan in forces), default=0.0)


@dataclass
class ForceSheet:
    """The views of sheet 2."""

    composer: Composer

    def views(self, position: Position, larger: Position, letter: float) -> list[View]:
        """Scheme with loads, every group with its forces and its plan, the driver, the lever, tables; groups apart as
        on a ``larger`` scheme."""
        c, plotted = self.composer, of_position(position)
        found: list[View | None] = [self.loaded(position)]
        for plan in (p for p in position.plans.drawn if kind_of(p) == "force"):
            links = links_of(plan)
            moments = c.moments(larger, letter, links)
            step = [
                c.stack("group", self.group(larger, plan, links), moments, gap=5.0),
                c.stack(plan, c.plan(plotted, plan), c.formulas(plotted, (plan,), letter, "")),
                self.apart(larger, links),
            ]
            found += [replace(v, step=plan) for v in step if v]
        found.append(self.lever(position, letter))
        tables = c.tables(position, letter)
        return [
            v for v in (*found, tables.given(loading=True), tables.reactions(), tables.check(), c.note(letter)) if v
        ]

    def loaded(self, position: Position) -> View:
        """The scheme with all outer loads."""
        c = self.composer

        def make() -> View:
            loading = Loading(position, c.naming, tuple(position.plans.mechanism.links))
            loading.loads(carried=False)
            drawn = Scheme(position, c.naming).drawn(True, loading.marks, loading.named)
            return view("loaded", c.titled(position, "loaded"), drawn, True, plan="position")

        return c.once(("loaded", position.scales[mu_of("position")]), make)

    def group(self, position: Position, plan: str, links: tuple[str, ...]) -> View | None:
        """A group apart with its forces, reactions and arms."""
        c = self.composer

        def make() -> View:
            loading = Loading(position, c.naming, links)
            loading.loads(carried=True)
            loading.reactions(plan)
            if links == (position.plans.structure.driver,):
                loading.balancing(*links)
            loading.arms(position.plans.moments_of(links))
            drawn = Scheme(position, c.naming, links, False).drawn(False, loading.marks, loading.named)
            key = "loaded_group" if len(links) > 1 else "loaded_driver"
            title = c.titled(position, key, links="–".join(map(c.naming.link, links)))
            return view("group", title, drawn, True, plan=GROUPS)

        return c.once(("loaded", links, position.scales[mu_of("position")]), make)

    def apart(self, position: Position, links: tuple[str, ...]) -> View | None:
        """The links of a group one by one, each with its loads and all reactions on it, the inner ones too."""
        if len(links) < 2:
            return None
        c = self.composer

        def make() -> View:
            title = c.titled(position, "links_apart", links=", ".join(map(c.naming.link, links)))
            return view("apart", title, beside([self.alone(position, x) for x in links]).marks, True, plan=GROUPS)

        return c.once(("apart", links, position.scales[mu_of("position")]), make)

    def alone(self, position: Position, link: str) -> View:
        """A link with its loads and all reactions on it."""
        loading = Loading(position, self.composer.naming, (link,))
        loading.loads(carried=False)
        loading.whole_reactions()
        if position.plans.structure.drive_pair.joins(link):
            loading.balancing(link)
        scheme = Scheme(position, self.composer.naming, (link,), False)
        return view("part", "", scheme.drawn(False, loading.marks, loading.named))

    def lever(self, position: Position, letter: float) -> View | None:
        """Zhukovsky's lever with its moment equation."""
        c, found = self.composer, Lever(position, self.composer.naming)
        if at("lever", POLE) not in position.drawing:
            return None
        kind, title = "motion" if position.plans.at_rest else "velocity", say("lever", c.lang)
        if kind == "velocity":
            title += f", {c.mu(of_position(position), 'velocity')}"
        key = ("lever", position.scales[mu_of(kind)])
        drawn = c.once(key, lambda: view("lever", title, found.drawn(), True, plan=kind))
        return c.stack("lever", drawn, c.moments(position, letter, ("lever",)))
