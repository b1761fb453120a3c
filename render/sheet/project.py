"""The first sheet of a course project, structure and kinematics, as a list of views."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

from planes.plans.assur.alignment import self_aligning_variant
from planes.plans.measuring import counted_structure_numbers
from planes.solving import Position
from planes.solving.structure_text import class_lowering_drivers_text
from planes.words import say
from planes.words.errors import PlanesError
from planes.words.names import NameTuple
from render.labels.footprints import box_around_marks
from render.paper.marks import Text
from render.paper.style import NEXT_LARGER_LETTER_MM
from render.paper.typeset import plain_text
from render.sheet.composer import Composer, Together, drawn_plans
from render.sheet.module import MODULE_WIDTH_MM, VIEW_GAP_MM
from render.views import View, make_view, put_views_in_row, remark_texts, stack_views
from render.views.alignment import alignment_text_view
from render.views.diagrams import DiagramCurve, Diagrams, section_width_mm
from render.views.dimensions import draw_dimensions, driver_angle, frame_dimensions
from render.views.directions import Directions
from render.views.hodographs import Hodograph, hodograph_view
from render.views.many import ManyPositions, Numbered, PlacedMechanism
from render.views.plotted import plot_position, scheme_mu
from render.views.scheme import Scheme
from render.views.special_points import special_point_marks

REDUCED_SCHEME_SIZES_MM = (105.0, 75.0)
"""The size of the scheme at whose μ the groups are drawn, and the size for groups that would otherwise be too wide."""


@dataclass
class Project:
    """The views of sheet 1. ``values`` are the driver's positions over its range (``whole``: a turn) and ``turn`` the
    places there; ``numbered`` are the positions of the scheme; ``curves`` and ``loops`` are the diagrams (by default of
    the driven link) and hodographs, ``paths`` the points with paths; ``reduced`` draws the position with its scheme
    reduced to so many mm."""

    composer: Composer
    values: Sequence[float] = ()
    turn: Sequence[PlacedMechanism | None] = ()
    numbered: Sequence[Numbered] = ()
    whole: bool = True
    curves: Sequence[DiagramCurve] = ()
    loops: Sequence[Hodograph] = ()
    paths: Sequence[str] = ()
    reduced: Callable[[float], Position] | None = None
    known: dict[float, ManyPositions] = field(default_factory=dict, repr=False)

    def kinematics_views(self, position: Position, size: float, letter: float, together: Together) -> list[View]:
        """Sheet 1: scheme in many positions, groups, velocity and acceleration plans, tables, diagrams."""
        c = self.composer
        plotted = plot_position(position)
        rates = [p for p in drawn_plans(plotted, position) if not p.is_force]
        t = c.make_tables(position, letter)
        plans = c.plan_views(plotted, rates, letter, together.equations)
        for k, (plan, v) in enumerate(zip(rates, plans, strict=False)):
            if v:
                plans[k] = replace(v, block="rates", plumb=v.inked[0] - c.plan(plotted, plan).inked[0])  # of its pole
        motion = [
            v and replace(v, block="motion")
            for v in (self.many_positions_view(position), self.diagrams_view(position, size))
        ]
        steps = {
            "motion": (*motion, self.hodographs_view()),
            "rates": (
                *plans,
                *t.rate_tables(together.rates),
                t.links(),
                self.directions_view(position),
                t.transfers_table(),
            ),
            "structure": (
                self.groups_view(position, letter),
                self.self_aligning_view(position, letter),
                t.given_table(),
                *c.note_views(letter),
            ),
        }
        return [replace(v, step=step) for step, views in steps.items() for v in views if v]

    def many_positions_view(self, position: Position) -> View | None:
        """The scheme, in the calculated position thick, in twelve others thin."""
        c, mu = self.composer, scheme_mu(position)
        if not self.numbered:
            return c.scheme_view(position)

        def make() -> View:
            many = self.many_positions(position, mu)
            title = c.title_with_mu(position, "scheme")
            scheme = Scheme(position, c.naming)
            thin = many.marks
            angle, named = driver_angle(scheme.places, c.naming)
            strokes = many.stroke_dimensions(c.lang)
            frame = frame_dimensions(scheme.places, mu, box_around_marks([*thin, *draw_dimensions(strokes)]), c.lang)
            crossed, letters = special_point_marks(position, c.naming)
            sizes = draw_dimensions([*strokes, *frame], [*thin, *scheme.ground_marks])
            marks = [*thin, *angle, *sizes, *crossed]
            drawn = scheme.drawn_marks(True, marks, [*named, *many.position_labels(), *letters])
            for text in (unseen := many.missing_position_remarks(c.lang)):
                drawn = (*drawn, *remark_texts(f"({text})", drawn))
            said = (say("in_view", c.lang, view=plain_text(title), text=text) for text in unseen)
            return make_view("scheme", title, drawn, True, said)

        return c.cached_view(("many", mu), make)

    def many_positions(self, position: Position, mu: float) -> ManyPositions:
        """The numbered positions at a μ, computed only once."""
        if mu not in self.known:
            self.known[mu] = ManyPositions(position.plans, self.numbered, self.turn, mu, self.paths)
        return self.known[mu]

    def directions_view(self, position: Position) -> View | None:
        """The small figures of directions."""
        c = self.composer
        return c.cached_view(
            ("directions",), lambda: Directions(position, c.naming).directions_view(say("directions", c.lang))
        )

    def groups_view(self, position: Position, letter: float) -> View | None:
        """The structure: its figures have no μ, and are smaller than the scheme, still smaller if they are wider than
        the title block."""
        c = self.composer

        def make() -> View:
            figure = self.structure_view(position, position, letter)
            for k, mm in enumerate(REDUCED_SCHEME_SIZES_MM):
                if self.reduced and (not k or figure.width > MODULE_WIDTH_MM - VIEW_GAP_MM):
                    primary, groups = self.reduced(REDUCED_SCHEME_SIZES_MM[0]), self.reduced(mm)
                    tried = self.structure_view(primary, groups, letter)
                    figure = min(figure, tried, key=lambda v: v.width * v.height)
            return figure

        return c.cached_view(("groups", scheme_mu(position), letter), make)

    def structure_view(self, primary: Position, position: Position, letter: float) -> View:
        """The primary mechanism, often with the shortest link and so reduced less, and the Assur groups separately,
        with W, q and the structural formula."""
        c = self.composer
        structure = position.plans.structure
        parts = [self.links_view(primary, (structure.driver,), say("primary", c.lang), True, letter)]
        for g in structure.groups:
            text = say(
                "group_named",
                c.lang,
                links="–".join(map(c.naming.link_number, g.all_links)),
                said=g.short_group_description,
            )
            parts.append(self.links_view(position, g.all_links, text, False, letter))
        lines = [
            ";  ".join(counted_structure_numbers(structure)),
            structure.formula_with_frame_number(c.naming.frame, True),
        ]
        lines += class_lowering_drivers_text(structure, c.lang, c.naming.frame, True)
        passive = ", ".join(map(c.naming.link_number, structure.passive))
        lines += [say("passive_link", c.lang, links=passive)] if passive else []
        high = NEXT_LARGER_LETTER_MM[letter]
        marks = [Text(t, complex(0, -1.9 * high * k), high, "middle") for k, t in enumerate(lines)]
        stack = stack_views("structure", [put_views_in_row(parts), make_view("formula", "", marks)], 5.0)
        return make_view("structure", say("structure", c.lang), stack.marks, figure=True)

    def self_aligning_view(self, position: Position, letter: float) -> View | None:
        """The variant without redundant constraints: its count, and the signs of its pairs. It is left out only where
        the scene names a format without room for it."""
        c = self.composer

        def make() -> View | None:
            try:
                variant = self_aligning_variant(position.plans, c.scene.file)
            except PlanesError:
                return None
            picture = alignment_text_view(variant, c.naming, say("self_aligning", c.lang), letter)
            return replace(picture, extra=c.scene.sheet.get("format", "auto") != "auto")

        return c.cached_text_view(("self-aligning", letter), make)

    def links_view(self, position: Position, links: NameTuple, text: str, framed: bool, letter: float) -> View:
        """Some links by themselves, with words beneath."""
        c = self.composer
        mu = scheme_mu(position)
        drawer = Scheme(position, c.naming, links, framed)
        drawn = c.cached_view(("part", links, mu), lambda: make_view("part", "", drawer.drawn_marks(False)))
        return stack_views("part", [drawn, make_view("part", "", [Text(text, 0j, letter, "middle")])], 3.0, True)

    def diagrams_view(self, position: Position, size: float = 1.0) -> View | None:
        """Diagrams of motion over the driver's range."""
        if sum(r is not None for r in self.turn) < 3:
            return None
        c = self.composer
        section = section_width_mm(size)
        drawer = Diagrams(position.plans, self.values, [[c] for c in self.curves], c.naming, section, self.whole)
        return c.cached_view(("diagrams", section), lambda: make_view("diagrams", drawer.title, drawer.drawn_marks()))

    def hodographs_view(self) -> View | None:
        """The hodographs named in the scene."""
        c = self.composer
        if self.loops:
            return c.cached_view(("hodographs",), lambda: hodograph_view(self.loops, c.naming))
        return None
