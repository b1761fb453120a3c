"""From a drawing to the views of its sheet: scheme, plans with their equations, tables; each made once."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from typing import Any, NamedTuple, TypeVar

from planes.diagrams.beams import beam_outlines
from planes.plans import Plans
from planes.plans.measuring import scene_lettering
from planes.scene import Scene
from planes.solving import Position
from planes.words import Lang, say, text_in
from planes.words.lettering import with_index_markup
from planes.words.names import CREMONA_PLAN, LEVER_PLAN, SCHEME_PLAN, NameTuple, PlanId, PlanTuple
from planes.words.naming import Naming
from render.labels import is_rough_placement
from render.paper.style import NEXT_LARGER_LETTER_MM, is_large_format
from render.sheet.module import MODULE_WIDTH_MM, VIEW_GAP_MM
from render.views import REMARK_LETTER_MM, View, make_view, paragraph_view, stack_views
from render.views.beam_diagrams import BeamDiagrams
from render.views.cremona import Cremona
from render.views.formulas import Formulas
from render.views.moments import MomentLines
from render.views.plotted import Plotted, plot_position, scheme_mu
from render.views.polygon import Polygon
from render.views.scheme import Scheme
from render.views.space_diagram import SpaceDiagram
from render.views.special_points import special_point_marks
from render.views.tables import Tables

PLAN_KIND_ORDER = {"contour": 0, "vectors": 0, "velocity": 0, "acceleration": 0, "force": 1, "cremona": 2}
"""Kinds of plans shown beside the scheme: velocities and accelerations first."""
MU_INDEX_OF_PLAN_KIND = {
    "position": "l",
    "contour": "l",
    "velocity": "v",
    "acceleration": "a",
    "force": "F",
    "cremona": "F",
    "motion": "q",
}
"""The index of μ by the kind of plan; velocities of a unit drive have a q."""
NOTE_WIDTHS_MM = tuple(share * MODULE_WIDTH_MM - VIEW_GAP_MM for share in (1.0, 1.5, 2.0, 0.6, 0.4))
"""Line widths of a note, the preferred shape first."""


Key = tuple[object, ...]
"""What a view depends on."""
Shown = TypeVar("Shown", bound=View | None)


class Together(NamedTuple):
    """Views combined on a sheet: ``equations`` with their plans, ``rates`` of both plans in one table."""

    equations: bool = True
    rates: bool = True


@dataclass
class Composer:
    """Makes the views of a scene; the same view at the same scale is made only once."""

    scene: Scene
    lang: Lang
    stated: Plans | None = None  # of a mechanism: the meanings of its names
    made: dict[Key, Any] = field(default_factory=dict)
    details: dict[tuple[str, float], int] = field(default_factory=dict)  # the number of details in a plan at its μ

    @cached_property
    def naming(self) -> Naming:
        """The lettering of this sheet."""
        return Naming(self.lang, **scene_lettering(self.scene, self.stated))

    def cached_view(self, key: Key, make: Callable[[], Shown]) -> Shown:
        """The view with that key, made on first request."""
        key = (is_large_format(), *key)
        if is_rough_placement() and key not in self.made:
            key = ("roughly", *key)
        if key not in self.made:
            self.made[key] = make()
        return self.made[key]  # type: ignore[no-any-return]

    def cached_text_view(self, key: Key, make: Callable[[], Shown]) -> Shown:
        """The same for a view without label placement: its rough version is already final."""
        key = (is_large_format(), *key)
        if key not in self.made:
            self.made[key] = make()
        return self.made[key]  # type: ignore[no-any-return]

    def stack_existing_views(self, key: str, *views: View | None, gap: float = 6.0) -> View:
        """Views of this composer one beneath another, those that exist."""
        there = [v for v in views if v]
        return self.cached_view(("stack", key, *map(id, there)), lambda: stack_views(key, there, gap))

    def all_views(self, position: Position, letter: float, together: Together) -> list[View]:
        """Every view of one position, in reading order."""
        plotted = plot_position(position)
        every_view = [self.scheme_view(position) if position.plans.has_mechanism else self.space_diagram_view(position)]
        every_view += self.plan_views(plotted, drawn_plans(plotted, position), letter, together.equations)
        every_view.append(self.beam_view(position))
        every_view += [*self.make_tables(position, letter).all_tables(together.rates), *self.note_views(letter)]
        return [v for v in every_view if v]

    def note_views(self, letter: float) -> list[View]:
        """The scene's notes, if there is room: as wide as the title block, or in another shape."""
        text = with_index_markup(text_in(self.lang, self.scene.note))
        high, title = max(0.7 * letter, REMARK_LETTER_MM), say("sheet_note", self.lang)

        def made(key: str, width: float) -> View:
            return replace(paragraph_view(key, title, text, width, high), extra=True)

        shapes = enumerate(NOTE_WIDTHS_MM if text else ())
        return [self.cached_text_view((f"note {k}", high), partial(made, f"note {k}", wide)) for k, wide in shapes]

    def make_tables(self, position: Position, letter: float) -> Tables:
        """The tables of one position."""
        own = self.scene.equations, self.scene.file
        return Tables(position, self.naming, letter, self.scene.used, self.cached_text_view, own)

    def plan_views(self, plotted: Plotted, plans: list[PlanId], letter: float, beneath: bool) -> list[View | None]:
        """Plans with their equations: ``beneath`` each, or all of one kind in one view."""
        drawn = [self.plan(plotted, plan) for plan in plans]
        if beneath:
            written = [self.equations_view(plotted, (plan,), letter, "") for plan in plans]
            return [self.stack_existing_views(d.key, d, w) for d, w in zip(drawn, written, strict=True)]
        forces = tuple(p for p in plans if p.is_force)
        others = tuple(p for p in plans if p not in forces)
        titled = ((others, "equations"), (forces, "balance_equations"))
        return [*drawn, *(self.equations_view(plotted, some, letter, say(x, self.lang)) for some, x in titled if some)]

    def title_mu(self, plotted: Plotted, plan: PlanId) -> str:
        """μ of a plan as in titles: "μ_{v} = 30 мм/(м·с⁻¹)"."""
        kind = plan.kind
        letter = MU_INDEX_OF_PLAN_KIND.get(kind, "")
        unit = kind
        if kind == "motion" and self.stated:
            unit = "position" if self.stated.mechanism.drive.rotates else "vectors"
        return f"μ{letter and f'_{{{letter}}}'} = {self.naming.mu_with_unit(plotted.plan_mu(plan), unit)}"

    def scheme_view(self, position: Position) -> View | None:
        """The scheme in the calculated position."""
        title, drawer = self.title_with_mu(position, "scheme"), Scheme(position, self.naming)
        key = ("scheme", scheme_mu(position))

        def make() -> View:
            drawn = drawer.drawn_marks(True, *special_point_marks(position, self.naming))
            return make_view("scheme", title, drawn, True)

        return self.cached_view(key, make)

    def space_diagram_view(self, position: Position, asked: bool = False) -> View | None:
        """The space diagram of bodies in equilibrium, or the part of it that is ``asked``; none for vectors alone."""
        if not position.plans.figure:
            return None
        title, drawer = self.title_with_mu(position, "space_diagram"), SpaceDiagram(position, self.naming, asked)
        key = ("space", asked, scheme_mu(position))
        return self.cached_view(key, lambda: make_view("space", title, drawer.drawn_marks(), True))

    def beam_view(self, position: Position) -> View | None:
        """Shear force and bending moment of a straight beam; none for other scenes."""
        if not (outlines := beam_outlines(position)):
            return None
        mu = scheme_mu(position)
        drawn = BeamDiagrams(outlines, self.naming, mu)
        return self.cached_view(
            ("beam", mu), lambda: make_view("beam", say("beam_diagrams", self.lang), drawn.drawn_marks(), True)
        )

    def title_with_mu(self, position: Position, key: str, **names: str) -> str:
        """The title of a scheme, with its μ."""
        return f"{say(key, self.lang, **names)}, {self.title_mu(plot_position(position), SCHEME_PLAN)}"

    def plan(self, plotted: Plotted, plan: PlanId) -> View:
        """A velocity, acceleration or force plan."""
        title = f"{self.plan_name(plan)}, {self.title_mu(plotted, plan)}"
        if plan == CREMONA_PLAN:
            drawer = Cremona(plotted, self.naming)
            return self.cached_view(
                ("plan", plan, plotted.plan_mu(plan)), lambda: make_view(plan, title, drawer.drawn_marks(), True)
            )
        polygon = Polygon(plotted, plan, self.naming, counted=self.details, valued=bool(self.scene.sheet.get("values")))
        key = (
            "plan",
            plan,
            plotted.plan_mu(plan),
            *polygon.free_detail_letters()[:1],
        )  # letters of details continue those before
        return self.cached_view(
            key, lambda: make_view(plan, title, polygon.drawn_marks(), True, polygon.too_short_remarks(title))
        )

    def plan_name(self, plan: PlanId) -> str:
        """The name of a plan in its title."""
        if not plan.is_force:
            return say(plan, self.lang)
        numbers = [self.naming.link_number(x) for x in plan.links if x]
        driver = self.scene.mechanism and plan.links == (self.scene.mechanism.drive.link,)
        alone = "force_driver" if driver else "force_link" if self.scene.mechanism else "force_body"
        key = "force_group" if len(numbers) > 1 else alone
        return say(key if numbers else "force_any", self.lang, links="–".join(numbers))

    def equations_view(
        self, plotted: Plotted, plans: PlanTuple, letter: float, title: str, asked: bool = False
    ) -> View | None:
        """The vector equations of some plans; without numbers if so ``asked``."""

        def make() -> View | None:
            marks = Formulas(plotted, self.naming, NEXT_LARGER_LETTER_MM[letter], asked).drawn_marks(plans)
            return make_view("equations", title, marks) if marks else None

        return self.cached_text_view(("formulas", plans, letter, title, asked), make)

    def moments_view(self, position: Position, letter: float, links: NameTuple | None = None) -> View | None:
        """The moment equations with their numbers: under a title, or those of some links alone."""

        def make() -> View | None:
            marks = MomentLines(position, self.naming, NEXT_LARGER_LETTER_MM[letter]).drawn_marks(links)
            if marks:
                return make_view("moments", "" if links else say("moments", self.lang), marks)
            return None

        mus = tuple(position.scales.get(plan.mu_name) for plan in (SCHEME_PLAN, LEVER_PLAN))
        return self.cached_text_view(("moments", letter, links, mus), make)


def drawn_plans(plotted: Plotted, position: Position) -> list[PlanId]:
    """The plans shown: velocities and accelerations if anything moves, and all force plans."""
    drawn = [p for p in position.plans.plan_names if p.kind in PLAN_KIND_ORDER and not plotted.has_only_pole(p)]
    return sorted(drawn, key=lambda p: PLAN_KIND_ORDER[p.kind])
