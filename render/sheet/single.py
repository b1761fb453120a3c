"""One view by itself, for a textbook, a slide or a notebook: a page cut to its ink with a margin around it."""

from __future__ import annotations

import cmath
from collections.abc import Callable, Iterator, Mapping
from types import MappingProxyType

from planes.drafting.drawing import Drawing
from planes.plans.measuring import say_plan
from planes.solving import Position
from planes.solving.vectors import PLAN, VectorResults
from planes.words import Lang, Phrase, say
from planes.words.errors import PlanesError
from planes.words.lettering import Naming
from planes.words.names import kind_of, label_of, links_of, plan_of
from render.files import Page
from render.labels import Label, place
from render.paper import symbols
from render.paper.marks import Line, Mark
from render.sheet import unseen
from render.sheet.composer import Composer
from render.sheet.forces import ForceSheet
from render.sheet.project import Project
from render.views import View, stacked, view
from render.views.plotted import of_position, of_vectors
from render.views.tables import Tables

MARGIN_MM = 5.0
LETTER_MM = 3.5  # letter height of tables; equations are a step larger

Makers = Mapping[str, Callable[[], View | None]]
"""The views that can be asked for, by name, each made when it is asked for."""


def page(makers: Makers, name: str, composer: Composer) -> Page:
    """The page of one view; a view that does not exist, or is empty, is a sentence."""
    if name not in makers:
        raise PlanesError(Phrase("bad_view", view=name, known=tuple(makers)))
    one = makers[name]()
    if one is None:
        raise PlanesError(Phrase("empty_view", view=name))
    marks = one.placed(MARGIN_MM, MARGIN_MM + one.height)
    title = composer.scene.title.get(composer.lang, "")
    size = (one.width + 2 * MARGIN_MM, one.height + 2 * MARGIN_MM)
    return Page(marks, size, ": ".join(t for t in (title, name) if t), composer.lang, tuple(unseen(one, composer.lang)))


def of_mechanism(
    position: Position, composer: Composer, project: Callable[[], Project], more: Makers = MappingProxyType({})
) -> Makers:
    """The views of a mechanism in one position; ``project`` turns its driver once around, where a view needs that.

    ``more`` are views of what is not seen in a position: constructions over the cycle, the self-aligning variant.
    """
    plotted, plans = of_position(position), position.plans
    bare, loaded, tables = Project(composer), ForceSheet(composer), composer.tables(position, LETTER_MM)
    rates = tuple(p for p in plans.drawn if p in ("velocity", "acceleration") and not plotted.still(p))
    forces = tuple(p for p in plans.drawn if kind_of(p) == "force" and not plotted.still(p))
    found: dict[str, Callable[[], View | None]] = {"position": lambda: composer.scheme(position)}
    found["positions"] = lambda: project().many(position)
    found["structure"] = lambda: bare.groups(position, LETTER_MM)
    for rate in rates:
        found[f"{rate}-plan"] = lambda plan=rate: composer.plan(plotted, plan)  # type: ignore[misc]
    found["equations"] = lambda: composer.formulas(plotted, rates, LETTER_MM, say("equations", composer.lang))
    found["diagrams"] = lambda: project().diagrams(position)
    found["hodographs"] = lambda: project().hodographs()
    found["loads"] = lambda: loaded.loaded(position)
    for force in forces:
        own = links_of(force)
        links = "-".join(own)
        found[f"group-{links}"] = lambda plan=force, of=own: loaded.group(position, plan, of)  # type: ignore[misc]
        if len(own) > 1:
            found[f"links-{links}"] = lambda of=own: loaded.apart(position, of)  # type: ignore[misc]
        found[f"force-{links}"] = lambda plan=force: composer.plan(plotted, plan)  # type: ignore[misc]
    balance = say("balance_equations", composer.lang)
    found["force-equations"] = lambda: composer.formulas(plotted, forces, LETTER_MM, balance)
    found["moments"] = lambda: composer.moments(position, LETTER_MM)
    found["lever"] = lambda: loaded.lever(position, LETTER_MM)
    found |= {
        "given": tables.given,
        "velocities": lambda: tables.plan("velocity"),
        "accelerations": lambda: tables.plan("acceleration"),
        "links": tables.links,
        "reactions": tables.reactions,
        "check": tables.check,
        **more,
    }
    return found


def of_scene_of_vectors(results: VectorResults, composer: Composer) -> Makers:
    """The views of a scene of vectors alone."""
    plotted = of_vectors(results)
    written = say("equations", composer.lang)
    return {
        "vectors": lambda: composer.plan(plotted, PLAN),
        "equations": lambda: composer.formulas(plotted, (PLAN,), LETTER_MM, written),
        "measured": lambda: Tables.of_vectors(results, composer.naming, LETTER_MM),
    }


def traced(drawing: Drawing, lang: Lang = "ru") -> Page | None:
    """The plans of one drawing, one beneath the other, in mm; None where there is no plan, or many drawings at once."""
    plans = dict.fromkeys(plan_of(s.makes) for s in drawing.program.steps if s.kind == "mark" and s.makes in drawing)
    found = [v for plan in plans if (v := _plan(drawing, plan, lang))]
    if not found:
        return None
    whole = stacked("traces", found, 8.0)
    size = (whole.width + 2 * MARGIN_MM, whole.height + 2 * MARGIN_MM)
    return Page(whole.placed(MARGIN_MM, MARGIN_MM + whole.height), size, say("vectors", lang), lang)


def _plan(drawing: Drawing, plan: str, lang: Lang) -> View | None:
    """One plan: a dot and a letter at every mark, a line from the marks it was drawn from."""
    places = dict(_places(drawing, plan))
    lines = [Line((places[a], places[b]), "thin", "plan") for a, b in _ways(drawing, places)]
    if not lines:
        return None
    dots: list[Mark] = [d for z in dict.fromkeys(places.values()) for d in symbols.dot(z, 0.7, "plan")]
    shown = [s.makes for s in drawing.program.steps if s.makes in places and not s.helper]
    labels = [Label(Naming(lang).mark(label_of(m), plan), places[m], 3.5) for m in shown]
    marks = (*lines, *dots)
    return view(f"traces {plan}", say_plan(plan, lang), (*marks, *place(labels, marks).marks))


def _places(drawing: Drawing, plan: str) -> Iterator[tuple[str, complex]]:
    """The marks of a plan that could be drawn."""
    for step in drawing.program.steps:
        if step.kind == "mark" and plan_of(step.makes) == plan and step.makes not in drawing.program.trials:
            z = drawing.things.get(step.makes)
            if isinstance(z, complex) and cmath.isfinite(z):
                yield step.makes, z


def _ways(drawing: Drawing, places: dict[str, complex]) -> Iterator[tuple[str, str]]:
    """From which marks of the plan each mark was found."""
    for step in drawing.program.steps:
        if step.makes in places:
            yield from ((name, step.makes) for name, _ in step.reads() if name in places and name != step.makes)
