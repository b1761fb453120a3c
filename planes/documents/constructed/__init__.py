"""A plan as a live construction in another program: the steps of its program in the words of that program.

A module of this folder is a format, named by the suffix of its file: it has ``written``, and is found here.
"""

import pkgutil
from collections.abc import Iterator
from functools import cached_property
from importlib import import_module
from pathlib import Path

from planes.documents.sheets import DrawnPosition, DrivePositions
from planes.drafting.program import Program
from planes.drafting.steps import MarkStep
from planes.plans import Plans
from planes.scene import Scene
from planes.scene.files import save_file_or_refuse
from planes.solving import Position
from planes.words import Lang, Phrase
from planes.words.errors import PlanesError
from planes.words.frozen import frozen, replace
from planes.words.names import POLE_LABEL, SCHEME_PLAN, Mark, MarkPair, NameTuple, PlanId, PlanTuple, scheme_mark
from planes.words.naming import Naming
from render.sheet.composer import Composer, drawn_plans
from render.sheet.single import plan_view_name
from render.sheet.sizes import Sizes
from render.views.plotted import plot_position

FIGURE_GAP_MM = 30.0  # mm between figures


@frozen
class Stretch:
    """A vector of a plan, or a side of a link: its end marks and its name."""

    start: Mark
    end: Mark
    text: str = ""


@frozen
class LiveFigure:
    """The figure: the scheme, if any, and some plans of a position, side by side."""

    position: Position
    plans: PlanTuple
    naming: Naming
    titles: NameTuple
    title: str
    lang: Lang

    @property
    def stated_plans(self) -> Plans:
        """The plans as they are stated."""
        return self.position.plans

    @cached_property
    def shown_marks(self) -> list[Mark]:
        """The marks shown, by their full names."""
        made = [
            s for s in self.stated_plans.program.steps if isinstance(s, MarkStep) and s.makes in self.position.drawing
        ]
        shown = {end for s in self.stated_plans.segments for end in s.ends}
        own = (s.makes for s in made if s.makes in shown or not (s.is_outside_plan or s.is_auxiliary_mark))
        return [name for name in own if name.plan in self.plans and name not in self.stated_plans.program.trial_marks]

    @cached_property
    def shown_program(self) -> Program:
        """The steps that these marks need."""
        return Program(self.stated_plans.program.cut_to_names(self.shown_marks).steps)

    def place_on_plan(self, mark: Mark) -> complex:
        """The place of a mark on its plan, mm from the pole."""
        return complex(self.position.drawing[mark])

    @cached_property
    def pole_places(self) -> dict[PlanId, complex]:
        """The places of each plan's pole, and of the scheme's origin, on the whole picture."""
        poles = {}
        right = 0.0
        for k, plan in enumerate(self.plans):
            xs = [self.place_on_plan(m).real for m in self.shown_marks if m.plan == plan]
            poles[plan] = complex(right + FIGURE_GAP_MM - min(0.0, *xs) if k else 0.0)
            right = poles[plan].real + max(0.0, *xs)
        return {**poles, **{s.plan: 0j for s in self.shown_program.steps if s.plan not in poles}}

    def place_on_picture(self, mark: Mark) -> complex:
        """The place of a mark on the whole picture."""
        return self.pole_places[mark.plan] + self.place_on_plan(mark)

    def mark_lettering(self, mark: Mark) -> str:
        """The lettering of a mark on a sheet, "" for a mark whose vectors are named instead."""
        plan = mark.plan
        label = mark.label
        if plan == SCHEME_PLAN:
            if label == POLE_LABEL:
                return ""
            return self.naming.lettered_point(label)
        if not plan.is_force:
            return self.naming.mark(label, plan)
        return ""

    @cached_property
    def plan_vectors(self) -> list[Stretch]:
        """The vectors of the plans, each once."""
        names: dict[MarkPair, str] = {}
        for s in (s for plan in self.plans for s in self.stated_plans.segments_on(plan)):
            if s.start != s.end and {*s.ends} <= {*self.shown_marks}:
                names.setdefault(s.ends, self.naming.lettered_vector(s.name))
        return [Stretch(*ends, text) for ends, text in names.items()]

    @cached_property
    def link_sides(self) -> list[Stretch]:
        """The links of the scheme: the sides of each."""
        return [*self._each_link_side()] if SCHEME_PLAN in self.plans else []

    def _each_link_side(self) -> Iterator[Stretch]:
        for link in self.stated_plans.mechanism.links.values():
            own = [
                m
                for p in self.stated_plans.mechanism.points_without_guide_centre(link)
                if (m := scheme_mark(p)) in self.shown_marks
            ]
            sides = list(zip(own, own[1:] + own[:1] if len(own) > 2 else own[1:], strict=False))
            yield from (Stretch(*side) for side in sides)


def format_suffixes() -> NameTuple:
    """The suffixes of the available formats."""
    return tuple(f".{m.name}" for m in pkgutil.iter_modules(__path__) if m.name[0] != "_")


def live_figure(scene: Scene, view: str | None, values: DrivePositions, lang: Lang) -> LiveFigure:
    """The scheme with the plan named by a view, or with all."""
    drawn = DrawnPosition(replace(scene, find=None), values, lang)
    position = drawn.position_at_sizes(Sizes())
    composer = Composer(scene, lang, drawn.plans_and_wanted[0])
    scheme = (SCHEME_PLAN,) if position.plans.has_mechanism else ()
    plotted = plot_position(position)
    known = {plan_view_name(p): p for p in drawn_plans(plotted, position)} | dict.fromkeys(scheme, SCHEME_PLAN)
    if view and view not in known:
        raise PlanesError(Phrase("bad_view", view=view, known=tuple(known)))
    wanted = [known[view]] if view else [p for p in known.values() if p != SCHEME_PLAN]
    plans = (*scheme, *(p for p in wanted if p != SCHEME_PLAN))
    names = {p: f"{composer.plan_name(p)}, {composer.title_mu(plotted, p)}" for p in plans if p != SCHEME_PLAN}
    titles = tuple(names.get(p) or composer.title_with_mu(position, "scheme") for p in plans)
    return LiveFigure(position, plans, composer.naming, titles, scene.title.get(lang, ""), lang)


def draw_constructed(scene: Scene, view: str | None, values: DrivePositions, output: str, lang: Lang) -> NameTuple:
    """Write the construction into a file of its format; returns sentences about its limitations."""
    suffix = Path(output).suffix.lower()
    format_ = import_module(f"{__name__}.{suffix[1:]}")
    data, said = format_.file_and_limitations(live_figure(scene, view, values, lang))
    save_file_or_refuse(data, output)
    return tuple(said)
