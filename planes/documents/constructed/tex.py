"""A plan for TikZ: a complete document in which every mark is a named coordinate under the sentence of its step."""

import re
from collections.abc import Iterator

from planes.documents.constructed import LiveFigure
from planes.drafting.steps.crossings import Cross
from planes.geometry.plane import bounding_corners
from planes.lesson import Teller, slot_value
from planes.lesson.formulas import fill_slots
from planes.words.lettering import without_index_markup
from planes.words.names import POLE_LABEL, SCHEME_PLAN, Mark, PlanId
from render.files.tikz import latex_math, latex_text, tikz_document
from render.views.plotted import group_names_by_place

NAME_PATTERN = re.compile(r"⟨([^⟩]*)⟩")


def file_and_limitations(figure: LiveFigure) -> tuple[bytes, list[str]]:
    """The file; it has no limitations to report."""
    lines = [*coordinate_lines(figure), "", *draw_commands(figure), "", *lettering_commands(figure)]
    return tikz_document(lines, figure.title, figure.lang).encode(), []


def coordinate_name(mark: Mark) -> str:
    """The name of a coordinate: velocity-b3 of velocity:b3, force-2-3-F_21t of force:2-3:F_21t."""
    primes = {"'": "p", "′": "p"}
    plan = "-".join(filter(None, (mark.plan.kind, *mark.plan.links)))
    return f"{plan}-" + "".join(primes.get(c, c if c.isalnum() or c in "_-" else "q") for c in mark.label)


def coordinate_lines(figure: LiveFigure) -> Iterator[str]:
    """Every mark on the plans shown, each under the sentence of its step."""
    drawing, left = figure.position.drawing, _drawn_marks(figure)
    teller = Teller(figure.stated_plans, drawing)
    names = dict(zip(figure.plans, figure.titles, strict=True))
    for plan in figure.plans:
        yield f"% {without_index_markup(names[plan])}"
        for frame in (f for f in teller.lesson_frames() if f.plan == plan):
            text = fill_slots(
                frame.words_with_rows[figure.lang], lambda n: float(slot_value(n, teller, drawing)), figure.lang
            )
            own = [m for m in frame.makes if m in left]
            if own:
                yield f"% {' '.join(_plain_sentence(figure, text, plan).split())}"
            yield from (_coordinate_line(figure, left.pop(left.index(m))) for m in own)
        yield from (_coordinate_line(figure, m) for m in left if m.plan == plan)


def _drawn_marks(figure: LiveFigure) -> list[Mark]:
    """The marks of the plans shown that are drawn."""
    made = (s.makes for plan in figure.plans for s in figure.shown_program.mark_steps_on(plan))
    return [m for m in made if figure.place_on_plan(m) == figure.place_on_plan(m)]  # a failed trial is not a number


def _plain_sentence(figure: LiveFigure, text: str, plan: PlanId) -> str:
    """A sentence in plain letters."""
    return NAME_PATTERN.sub(lambda m: without_index_markup(figure.naming.lettered_name(m[1], plan)), text)


def _coordinate_line(figure: LiveFigure, mark: Mark) -> str:
    z = figure.place_on_picture(mark)
    return rf"\coordinate ({coordinate_name(mark)}) at ({_mm_text(z.real)}, {_mm_text(z.imag)});"


def _mm_text(value: float) -> str:
    return f"{value + 0.0:.9f}".rstrip("0").rstrip(".")


def draw_commands(figure: LiveFigure) -> Iterator[str]:
    """Links, lines of action, vectors."""
    for bar in figure.link_sides:
        yield rf"\draw[link] ({coordinate_name(bar.start)}) -- ({coordinate_name(bar.end)});"
    for step in figure.shown_program.steps:
        if isinstance(step, Cross) and step.makes in figure.shown_marks and step.plan != SCHEME_PLAN:
            for start in (m for m in (step.start, step.other) if _are_apart(figure, m, step.makes)):
                yield rf"\draw[action] ({coordinate_name(start)}) -- ({coordinate_name(step.makes)});"
    for s in (s for s in figure.plan_vectors if _are_apart(figure, s.start, s.end)):
        style = "whole" if s.start.label == POLE_LABEL else "part"
        named = f"node[midway, sloped, above, font=\\scriptsize] {{${latex_math(s.text)}$}} "
        yield rf"\draw[{style}] ({coordinate_name(s.start)}) -- {named}({coordinate_name(s.end)});"


def _are_apart(figure: LiveFigure, one: Mark, two: Mark) -> bool:
    return abs(figure.place_on_picture(one) - figure.place_on_picture(two)) > 0.05


def lettering_commands(figure: LiveFigure) -> Iterator[str]:
    """Points with their letters, and the title of each figure."""
    for plan, title in zip(figure.plans, figure.titles, strict=True):
        named = [
            (m, figure.place_on_picture(m)) for m in figure.shown_marks if m.plan == plan and figure.mark_lettering(m)
        ]
        dot = "hinge" if plan == SCHEME_PLAN else "dot"
        for _, marks in group_names_by_place(named):
            text = ", ".join(dict.fromkeys(map(figure.mark_lettering, marks)))
            label = f"{{above right:{{${latex_math(text)}$}}}}"
            yield rf"\node[{dot}, label={label}] at ({coordinate_name(marks[0])}) {{}};"
        own = [figure.place_on_picture(m) for m in figure.shown_marks if m.plan == plan]
        low, high = bounding_corners(own)
        yield rf"\node[anchor=west] at ({_mm_text(low.real)}, {_mm_text(high.imag + 14)}) {{{latex_text(title)}}};"
