"""Assur's special points on a scheme: where the lines of two leads of a basic link cross."""

from planes.drafting.steps.crossings import Cross
from planes.solving import Position
from planes.words.names import scheme_mark
from planes.words.naming import Naming
from render.labels import Label, Labelled
from render.paper.marks import Line, Mark
from render.paper.symbols import dot
from render.views.scheme import POINT_LETTER_MM

MOST_SPECIAL_POINT_DISTANCE_MM = 60.0  # a special point farther from every point of the mechanism is not shown


def special_point_marks(position: Position, naming: Naming) -> Labelled:
    """The lines of leads extended to their special points, with the letters of these."""
    marks = list[Mark]()
    named = []
    drawing = position.drawing
    points = [complex(drawing[m]) for p in position.plans.points if (m := scheme_mark(p)) in drawing]
    for step in drawing.program.steps:
        if isinstance(step, Cross) and step.quantity_represented == "special" and step.makes in drawing:
            place = complex(drawing[step.makes])
            if min(abs(place - z) for z in points) <= MOST_SPECIAL_POINT_DISTANCE_MM:
                leads = (step.start, step.other)
                marks += [Line((complex(drawing[m]), place), "thin", "construction") for m in leads]
                marks += dot(place)
                named.append(
                    Label(naming.lettered_point(step.label), place, POINT_LETTER_MM, clear=0.8, name="special")
                )
    return marks, named
