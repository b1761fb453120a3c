"""The thin lines of statics on a plan: strings and their rays, closing lines, extended lines of action."""

from planes.drafting.drawing import Drawing
from planes.plans.structures.figure import StaticsFigure
from planes.words.names import PlanId
from render.labels import Label, Labelled
from render.paper.marks import Line, Mark
from render.views.plotted import SAME_PLACE_MM

STRING_LETTER_MM = 3.5  # letters of strings and rays
STRING_LINE_STYLES = {
    "string": "thin",
    "ray": "thin",
    "closing": "dash",
    "culmann": "dash",
    "action": "construction",
    "trial": "dash",
}


def string_and_ray_lines(drawing: Drawing, figure: StaticsFigure | None, plan: PlanId) -> Labelled:
    """The lines of a plan, with the letters of strings and rays; on a force plan the pole has its letter, too."""
    marks = list[Mark]()
    named = []
    poles = {}
    for s in figure.strokes if figure else ():
        if s.plan == plan and s.start in drawing and s.end in drawing:
            start = complex(drawing[s.start])
            end = complex(drawing[s.end])
            if abs(end - start) > SAME_PLACE_MM:
                marks.append(Line((start, end), STRING_LINE_STYLES[s.kind], "construction"))
                named += [Label(s.name, (start, end), STRING_LETTER_MM, name=f"{s.kind} {s.name}")] if s.name else []
            if s.kind == "ray":
                poles[start] = Label("O", start, 5.0, clear=0.7, priority=1, name="O")
    return marks, [*named, *poles.values()]
