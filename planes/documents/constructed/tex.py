"""A plan for TikZ: a complete document in which every mark is a named coordinate under the sentence of its step."""

import re
from collections.abc import Iterator

from planes.documents.constructed import SCHEME, LiveFigure
from planes.drafting.steps.crossings import Cross
from planes.geometry.plane import corners
from planes.lesson import Teller, value_of
from planes.lesson.formulas import fill
from planes.words.lettering import flat
from planes.words.names import POLE, kind_of, label_of, links_of, plan_of
from render.files.tikz import document, in_math, in_text
from render.views.plotted import gathered

NAME = re.compile(r"⟨([^⟩]*)⟩")


def written(figure: LiveFigure) -> tuple[bytes, list[str]]:
    """The file; it has no limitations to report."""
    lines = [*coordinates(figure), "", *strokes(figure), "", *letters(figure)]
    return document(lines, figure.title, figure.lang).encode(), []


def name_of(mark: str) -> str:
    """The name of a coordinate: velocity-b3 of velocity:b3, force-2-3-F_21t of force:2-3:F_21t."""
    primes = {"'": "p", "′": "p"}
    plan = "-".join(filter(None, (kind_of(mark), *links_of(plan_of(mark)))))
    return f"{plan}-" + "".join(primes.get(c, c if c.isalnum() or c in "_-" else "q") for c in label_of(mark))


def coordinates(figure: LiveFigure) -> Iterator[str]:
    """Every mark on the plans shown, each under the sentence of its step."""
    drawing, left = figure.position.drawing, _drawn(figure)
    teller = Teller(figure.stated, drawing)
    names = dict(zip(figure.plans, figure.titles, strict=True))
    for plan in figure.plans:
        yield f"% {flat(names[plan])}"
        for frame in (f for f in teller.frames() if f.plan == plan):
            text = fill(frame.said[figure.lang], lambda n: float(value_of(n, teller, drawing)), figure.lang)
            own = [m for m in frame.makes if m in left]
            if own:
                yield f"% {' '.join(_told(figure, text, plan).split())}"
            yield from (_coordinate(figure, left.pop(left.index(m))) for m in own)
        yield from (_coordinate(figure, m) for m in left if plan_of(m) == plan)


def _drawn(figure: LiveFigure) -> list[str]:
    """The marks of the plans shown that are drawn."""
    made = (s.makes for s in figure.program.steps if s.kind == "mark" and plan_of(s.makes) in figure.plans)
    return [m for m in made if figure.place(m) == figure.place(m)]  # a failed trial is not a number


def _told(figure: LiveFigure, text: str, plan: str) -> str:
    """A sentence in plain letters."""
    return NAME.sub(lambda m: flat(figure.naming.named(m[1], plan)), text)


def _coordinate(figure: LiveFigure, mark: str) -> str:
    z = figure.at(mark)
    return rf"\coordinate ({name_of(mark)}) at ({_mm(z.real)}, {_mm(z.imag)});"


def _mm(value: float) -> str:
    return f"{value + 0.0:.9f}".rstrip("0").rstrip(".")


def strokes(figure: LiveFigure) -> Iterator[str]:
    """Links, lines of action, vectors."""
    for bar in figure.bars:
        yield rf"\draw[link] ({name_of(bar.start)}) -- ({name_of(bar.end)});"
    for step in figure.program.steps:
        if isinstance(step, Cross) and step.makes in figure.marks and plan_of(step.makes) != SCHEME:
            for start in (m for m in (step.start, step.other) if _apart(figure, m, step.makes)):
                yield rf"\draw[action] ({name_of(start)}) -- ({name_of(step.makes)});"
    for s in (s for s in figure.shafts if _apart(figure, s.start, s.end)):
        style = "whole" if label_of(s.start) == POLE else "part"
        named = f"node[midway, sloped, above, font=\\scriptsize] {{${in_math(s.text)}$}} "
        yield rf"\draw[{style}] ({name_of(s.start)}) -- {named}({name_of(s.end)});"


def _apart(figure: LiveFigure, one: str, two: str) -> bool:
    return abs(figure.at(one) - figure.at(two)) > 0.05


def letters(figure: LiveFigure) -> Iterator[str]:
    """Points with their letters, and the title of each figure."""
    for plan, title in zip(figure.plans, figure.titles, strict=True):
        named = [(m, figure.at(m)) for m in figure.marks if plan_of(m) == plan and figure.text(m)]
        dot = "hinge" if plan == SCHEME else "dot"
        for _, marks in gathered(named):
            text = ", ".join(dict.fromkeys(map(figure.text, marks)))
            yield rf"\node[{dot}, label={{above right:{{${in_math(text)}$}}}}] at ({name_of(marks[0])}) {{}};"
        own = [figure.at(m) for m in figure.marks if plan_of(m) == plan]
        low, high = corners(own)
        yield rf"\node[anchor=west] at ({_mm(low.real)}, {_mm(high.imag + 14)}) {{{in_text(title)}}};"
