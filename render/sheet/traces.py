"""A drawing shown by itself, without its mechanism: every plan's marks and the lines they were found by."""

from __future__ import annotations

import cmath
from collections.abc import Iterator

from planes.drafting.drawing import Drawing
from planes.plans.measuring import say_plan
from planes.words import Lang, say
from planes.words.lettering import Naming
from planes.words.names import label_of, plan_of
from render.labels import Label, place
from render.paper import symbols
from render.paper.marks import Line, Mark
from render.sheet.single import MARGIN_MM, Page
from render.views import View, stacked, view


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
