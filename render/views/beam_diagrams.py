"""Diagrams of shear force and bending moment, one beneath the other: along the beam, hatched, with their values."""

from dataclasses import dataclass
from itertools import pairwise

from planes.diagrams.beams import BeamOutlines, Outline
from planes.words import say
from planes.words.naming import Naming
from planes.words.read_off import read_off_text
from render.labels import Label
from render.paper.marks import Line, Mark, Text
from render.paper.style import figure_letter_height
from render.paper.symbols import Marks
from render.views.senses import marks_with_labels

LARGEST_ORDINATE_MM = 20.0  # of the largest ordinate
DIAGRAM_GAP_MM = 13.0  # between both diagrams
HATCH_SPACING_MM = 3.0
NAME_LETTER_MM, POINT_LETTER_MM = 3.5, 5.0
ZERO_RATIO = 1e-9  # of the largest: below this it is zero
LEAST_STEP_RATIO = 1e-3  # of the largest: a smaller step is not a step


@dataclass
class BeamDiagrams:
    """Both diagrams under construction, at a scale of lengths."""

    found: BeamOutlines
    naming: Naming
    mu: float  # mm per m

    def drawn_marks(self) -> Marks:
        """The beam with its letters, and the diagrams beneath it."""
        marks = list[Mark]()
        named = []
        y = -8.0
        stops = {p: self.mu * x for p, x in self.found.stops.items()}
        left = min(stops.values())
        right = max(stops.values())
        marks.append(Line((complex(left), complex(right)), "thick"))
        named += [
            Label(self.naming.lettered_point(p), complex(self.mu * x), POINT_LETTER_MM, 1j, 0.8, name=p)
            for p, x in self.found.stops.items()
        ]
        for title, unit, outline in (("Q", "N", self.found.shears), ("M", "N·m", self.found.moments)):
            most = max((abs(v) for _, v in outline), default=0.0) or 1.0
            up, down = (max(0.0, *(k * v for _, v in outline)) / most * LARGEST_ORDINATE_MM for k in (1, -1))
            y -= up + 4.0
            text = f"{title}, {say(unit, self.naming.lang)}"
            marks.append(
                Text(
                    text,
                    complex(left - 4.0, y - figure_letter_height(NAME_LETTER_MM) / 2),
                    figure_letter_height(NAME_LETTER_MM),
                    "end",
                    name=title,
                )
            )
            marks += self.diagram_marks(outline, y, most)
            named += self.value_labels(outline, y, most)
            y -= down + DIAGRAM_GAP_MM
        marks += [
            Line((complex(self.mu * x), complex(self.mu * x, y + DIAGRAM_GAP_MM)), "thin", "construction")
            for x in self.found.stops.values()
        ]
        return marks_with_labels(named, marks)

    def ordinate_end(self, x: float, v: float, y: float, most: float) -> complex:
        """The end of an ordinate on the paper."""
        return complex(self.mu * x, y + v / most * LARGEST_ORDINATE_MM)

    def diagram_marks(self, outline: Outline, y: float, most: float) -> list[Mark]:
        """The line of zero, the outline, and the hatching between."""
        spots = [self.ordinate_end(x, v, y, most) for x, v in outline]
        left = spots[0].real
        right = spots[-1].real
        marks: list[Mark] = [Line((complex(left, y), complex(right, y)), "vector")]
        marks.append(Line(tuple(spots), "result", "result"))
        count = int((right - left) / HATCH_SPACING_MM)
        for k in range(1, count):
            x = left + k * (right - left) / count
            for a, b in pairwise(spots):
                if a.real < x <= b.real:
                    top = a.imag + (x - a.real) / (b.real - a.real) * (b.imag - a.imag)
                    if abs(top - y) > 0.5:
                        marks.append(Line((complex(x, y), complex(x, top)), "thin", "construction"))
        return marks

    def value_labels(self, outline: Outline, y: float, most: float) -> list[Label]:
        """The values where the outline bends or jumps, and the greatest."""
        stops = set(self.found.stops.values())
        shown = dict[tuple[float, float], None]()
        extreme = max(outline, key=lambda one: abs(one[1]))
        for x, v in outline:
            if (any(abs(x - s) < ZERO_RATIO * max(stops) for s in stops) or (x, v) == extreme) and abs(
                v
            ) > LEAST_STEP_RATIO * most:
                near = (
                    one
                    for one in shown
                    if abs(one[0] - x) < ZERO_RATIO * max(stops) and abs(one[1] - v) < LEAST_STEP_RATIO * most
                )
                if next(near, None) is None:
                    shown[x, v] = None
        value_labels = []
        for x, v in shown:
            z = self.ordinate_end(x, v, y, most)
            text = read_off_text(abs(v), self.naming.lang)
            value_labels.append(Label(text, z, NAME_LETTER_MM, 1j if v > 0 else -1j, 0.6, name=f"value {text}"))
        return value_labels
