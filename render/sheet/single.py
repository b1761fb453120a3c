"""A single view, or a drawing without its mechanism: a page cut to its ink with a margin around it."""

import cmath
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import partial
from types import MappingProxyType

from planes.drafting.drawing import Drawing
from planes.plans.measuring import plan_name_in_words
from planes.solving import Position
from planes.words import Lang, Phrase, say
from planes.words.errors import PlanesError
from planes.words.names import ACCELERATION_PLAN, POLE_LABEL, VELOCITY_PLAN, PlanId
from planes.words.naming import Naming
from render.files import Page
from render.labels import Label, place_labels
from render.paper.marks import Line
from render.paper.symbols import dot
from render.sheet import legibility_warnings
from render.sheet.composer import Composer, drawn_plans
from render.sheet.force_sheet import ForceSheet
from render.sheet.project import Project
from render.views import View, make_view, stack_views
from render.views.plotted import plot_position, plot_with_single_links

PAGE_MARGIN_MM = 5.0
TABLE_LETTER_MM = 3.5  # letter height of tables; equations are a step larger

Makers = Mapping[str, Callable[[], View | None]]
"""The available views, by name, each made on request."""


def view_page(makers: Makers, name: str | None, composer: Composer) -> Page:
    """The page of one view (by default the first); a missing or empty one is an error in a sentence."""
    name = name or next(iter(makers))
    if name not in makers:
        raise PlanesError(Phrase("bad_view", view=name, known=tuple(makers)))
    one = makers[name]()
    if one is None:
        raise PlanesError(Phrase("empty_view", view=name))
    title = ": ".join(filter(None, (composer.scene.title.get(composer.lang, ""), name)))
    return page_cut_to_view(one, title, composer.lang, legibility_warnings(one, composer.lang))


def page_cut_to_view(one: View, title: str, lang: Lang, said: Iterable[str] = ()) -> Page:
    """A page as large as a view with a margin around it."""
    size = (one.width + 2 * PAGE_MARGIN_MM, one.height + 2 * PAGE_MARGIN_MM)
    return Page(one.marks_placed_at(PAGE_MARGIN_MM, PAGE_MARGIN_MM + one.height), size, title, lang, tuple(said))


def mechanism_view_makers(
    position: Position, composer: Composer, project: Callable[[], Project], more: Makers = MappingProxyType({})
) -> Makers:
    """The views of a mechanism in one position; ``project`` turns its driver once around, where a view needs that.

    ``more`` are views that do not belong to a position: constructions over the cycle, the self-aligning variant.
    """
    plotted, links_apart = plot_with_single_links(position)
    bare, loaded, tables = Project(composer), ForceSheet(composer), composer.make_tables(position, TABLE_LETTER_MM)
    shown = drawn_plans(plotted, position)
    rates, forces = (tuple(p for p in shown if p.is_force is of_forces) for of_forces in (False, True))
    makers: dict[str, Callable[[], View | None]] = {
        "position": lambda: composer.scheme_view(position),
        "positions": lambda: project().many_positions_view(position),
        "structure": lambda: bare.groups_view(position, TABLE_LETTER_MM),
        **{f"{rate}-plan": partial(composer.plan, plotted, rate) for rate in rates},
        "equations": lambda: composer.equations_view(plotted, rates, TABLE_LETTER_MM, say("equations", composer.lang)),
        "diagrams": lambda: project().diagrams_view(position),
        "hodographs": lambda: project().hodographs_view(),
        "loads": lambda: loaded.loaded_scheme_view(position),
    }
    for plan in forces:
        own = plan.links
        links = "-".join(own)
        makers[f"group-{links}"] = partial(loaded.group_view, position, plan, own)
        if len(own) > 1:
            makers[f"links-{links}"] = partial(loaded.single_links_view, position, own)
        makers[f"force-{links}"] = partial(composer.plan, plotted, plan)
        for one in links_apart[plan]:
            if one.polygon and plotted.has_marks(one.plan, POLE_LABEL):
                makers[f"force-{one.link}"] = partial(composer.plan, plotted, one.plan)
    balance = say("balance_equations", composer.lang)
    return makers | {
        "force-equations": lambda: composer.equations_view(plotted, forces, TABLE_LETTER_MM, balance),
        "moments": lambda: composer.moments_view(position, TABLE_LETTER_MM),
        "lever": lambda: loaded.lever_view(position, TABLE_LETTER_MM),
        "given": tables.given_table,
        "velocities": lambda: tables.plan(VELOCITY_PLAN),
        "accelerations": lambda: tables.plan(ACCELERATION_PLAN),
        "links": tables.links,
        "reactions": tables.reactions_table,
        "check": tables.check_table,
        **more,
    }


def vector_view_makers(position: Position, composer: Composer) -> Makers:
    """The views of a scene of vectors alone."""
    plotted = plot_position(position)
    tables = composer.make_tables(position, TABLE_LETTER_MM)
    shown = tuple(drawn_plans(plotted, position))
    own: Makers = {
        "space": partial(composer.space_diagram_view, position),
        "beam": partial(composer.beam_view, position),
        "members": tables.members_table,
    }
    space: Makers = own if position.plans.figure else {}
    return {
        **space,
        **{plan_view_name(plan): partial(composer.plan, plotted, plan) for plan in shown},
        "equations": partial(composer.equations_view, plotted, shown, TABLE_LETTER_MM, say("equations", composer.lang)),
        "asked": partial(composer.equations_view, plotted, shown, TABLE_LETTER_MM, "", True),
        "given": tables.given_table,
        "measured": tables.vectors_table,
        "values": tables.values_table,
    }


def plan_view_name(plan: PlanId) -> str:
    """The name of a plan's view."""
    if plan.kind in ("force", "vectors"):
        return plan.replace(":", "-")
    return f"{plan}-plan"


def traced_plans_page(drawing: Drawing, lang: Lang = "ru") -> Page | None:
    """The plans of one drawing, one beneath another, in mm; None without a plan, or for many drawings at once."""
    plans = dict.fromkeys(s.plan for s in drawing.program.steps if s.plan and s.makes in drawing)
    figures = [v for plan in plans if (v := _traced_plan_view(drawing, plan, lang))]
    if not figures:
        return None
    return page_cut_to_view(stack_views("traces", figures, 8.0), say("vectors", lang), lang)


def _traced_plan_view(drawing: Drawing, plan: PlanId, lang: Lang) -> View | None:
    """One plan: a dot and a letter at every mark, a line from its construction marks."""
    places = dict(_mark_places(drawing, plan))
    steps = [s for s in drawing.program.steps if s.makes in places]
    ways = ((name, s.makes) for s in steps for name, _ in s.input_names() if name in places and name != s.makes)
    lines = [Line((places[a], places[b]), "thin", "plan") for a, b in ways]
    if not lines:
        return None
    dots = [d for z in dict.fromkeys(places.values()) for d in dot(z, 0.7, "plan")]
    labels = [Label(Naming(lang).mark(s.label, plan), places[s.makes], 3.5) for s in steps if not s.is_auxiliary_mark]
    marks = (*lines, *dots)
    return make_view(f"traces {plan}", plan_name_in_words(plan, lang), (*marks, *place_labels(labels, marks).marks))


def _mark_places(drawing: Drawing, plan: PlanId) -> Iterator[tuple[str, complex]]:
    """The drawn marks of a plan."""
    for step in drawing.program.mark_steps_on(plan):
        if step.makes not in drawing.program.trial_marks:
            z = drawing.things.get(step.makes)
            if isinstance(z, complex) and cmath.isfinite(z):
                yield step.makes, z
