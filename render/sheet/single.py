"""A single view, or a drawing without its mechanism: a page cut to its ink with a margin around it."""

import cmath
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import partial
from types import MappingProxyType

from planes.drafting.drawing import Drawing
from planes.plans.measuring import say_plan
from planes.solving import Position
from planes.words import Lang, Phrase, say
from planes.words.errors import PlanesError
from planes.words.names import POLE, kind_of, label_of, links_of, plan_of
from planes.words.naming import Naming
from render.files import Page
from render.labels import Label, place
from render.paper.marks import Line
from render.paper.symbols import dot
from render.sheet import unseen
from render.sheet.composer import Composer, drawn_plans
from render.sheet.force_sheet import ForceSheet
from render.sheet.project import Project
from render.views import View, stacked, view
from render.views.plotted import of_position, with_links_apart

MARGIN_MM = 5.0
LETTER_MM = 3.5  # letter height of tables; equations are a step larger

Makers = Mapping[str, Callable[[], View | None]]
"""The available views, by name, each made on request."""


def page(makers: Makers, name: str | None, composer: Composer) -> Page:
    """The page of one view (by default the first); a missing or empty one is an error in a sentence."""
    name = name or next(iter(makers))
    if name not in makers:
        raise PlanesError(Phrase("bad_view", view=name, known=tuple(makers)))
    one = makers[name]()
    if one is None:
        raise PlanesError(Phrase("empty_view", view=name))
    title = ": ".join(filter(None, (composer.scene.title.get(composer.lang, ""), name)))
    return cut_to(one, title, composer.lang, unseen(one, composer.lang))


def cut_to(one: View, title: str, lang: Lang, said: Iterable[str] = ()) -> Page:
    """A page as large as a view with a margin around it."""
    size = (one.width + 2 * MARGIN_MM, one.height + 2 * MARGIN_MM)
    return Page(one.placed(MARGIN_MM, MARGIN_MM + one.height), size, title, lang, tuple(said))


def of_mechanism(
    position: Position, composer: Composer, project: Callable[[], Project], more: Makers = MappingProxyType({})
) -> Makers:
    """The views of a mechanism in one position; ``project`` turns its driver once around, where a view needs that.

    ``more`` are views that do not belong to a position: constructions over the cycle, the self-aligning variant.
    """
    plotted, links_apart = with_links_apart(position)
    bare, loaded, tables = Project(composer), ForceSheet(composer), composer.tables(position, LETTER_MM)
    shown = drawn_plans(plotted, position)
    rates, forces = (tuple(p for p in shown if (kind_of(p) == "force") is of_forces) for of_forces in (False, True))
    makers: dict[str, Callable[[], View | None]] = {
        "position": lambda: composer.scheme(position),
        "positions": lambda: project().many(position),
        "structure": lambda: bare.groups(position, LETTER_MM),
        **{f"{rate}-plan": partial(composer.plan, plotted, rate) for rate in rates},
        "equations": lambda: composer.formulas(plotted, rates, LETTER_MM, say("equations", composer.lang)),
        "diagrams": lambda: project().diagrams(position),
        "hodographs": lambda: project().hodographs(),
        "loads": lambda: loaded.loaded(position),
    }
    for plan in forces:
        own = links_of(plan)
        links = "-".join(own)
        makers[f"group-{links}"] = partial(loaded.group, position, plan, own)
        if len(own) > 1:
            makers[f"links-{links}"] = partial(loaded.apart, position, own)
        makers[f"force-{links}"] = partial(composer.plan, plotted, plan)
        for one in links_apart[plan]:
            if one.polygon and plotted.has(one.plan, POLE):
                makers[f"force-{one.link}"] = partial(composer.plan, plotted, one.plan)
    balance = say("balance_equations", composer.lang)
    return makers | {
        "force-equations": lambda: composer.formulas(plotted, forces, LETTER_MM, balance),
        "moments": lambda: composer.moments(position, LETTER_MM),
        "lever": lambda: loaded.lever(position, LETTER_MM),
        "given": tables.given,
        "velocities": lambda: tables.plan("velocity"),
        "accelerations": lambda: tables.plan("acceleration"),
        "links": tables.links,
        "reactions": tables.reactions,
        "check": tables.check,
        **more,
    }


def of_vectors(position: Position, composer: Composer) -> Makers:
    """The views of a scene of vectors alone."""
    plotted, tables = of_position(position), composer.tables(position, LETTER_MM)
    shown = tuple(drawn_plans(plotted, position))
    own: Makers = {
        "space": partial(composer.space, position),
        "beam": partial(composer.beam, position),
        "members": tables.members,
    }
    space: Makers = own if position.plans.figure else {}
    return {
        **space,
        **{name_of_view(plan): partial(composer.plan, plotted, plan) for plan in shown},
        "equations": partial(composer.formulas, plotted, shown, LETTER_MM, say("equations", composer.lang)),
        "asked": partial(composer.formulas, plotted, shown, LETTER_MM, "", True),
        "given": tables.given,
        "measured": tables.vectors,
        "values": tables.values,
    }


def name_of_view(plan: str) -> str:
    """The name of a plan's view."""
    return plan.replace(":", "-") if kind_of(plan) in ("force", "vectors") else f"{plan}-plan"


def traced(drawing: Drawing, lang: Lang = "ru") -> Page | None:
    """The plans of one drawing, one beneath another, in mm; None without a plan, or for many drawings at once."""
    plans = dict.fromkeys(plan_of(s.makes) for s in drawing.program.steps if s.kind == "mark" and s.makes in drawing)
    figures = [v for plan in plans if (v := _plan(drawing, plan, lang))]
    if not figures:
        return None
    return cut_to(stacked("traces", figures, 8.0), say("vectors", lang), lang)


def _plan(drawing: Drawing, plan: str, lang: Lang) -> View | None:
    """One plan: a dot and a letter at every mark, a line from its construction marks."""
    places = dict(_places(drawing, plan))
    steps = [s for s in drawing.program.steps if s.makes in places]
    ways = ((name, s.makes) for s in steps for name, _ in s.reads() if name in places and name != s.makes)
    lines = [Line((places[a], places[b]), "thin", "plan") for a, b in ways]
    if not lines:
        return None
    dots = [d for z in dict.fromkeys(places.values()) for d in dot(z, 0.7, "plan")]
    labels = [Label(Naming(lang).mark(label_of(s.makes), plan), places[s.makes], 3.5) for s in steps if not s.helper]
    marks = (*lines, *dots)
    return view(f"traces {plan}", say_plan(plan, lang), (*marks, *place(labels, marks).marks))


def _places(drawing: Drawing, plan: str) -> Iterator[tuple[str, complex]]:
    """The drawn marks of a plan."""
    for step in drawing.program.marks.get(plan, ()):
        if step.makes not in drawing.program.trials:
            z = drawing.things.get(step.makes)
            if isinstance(z, complex) and cmath.isfinite(z):
                yield step.makes, z
