"""Diagrams of shear force and bending moment, one beneath the other: along the beam, hatched, with their values."""

from dataclasses import dataclass
from itertools import pairwise

from planes.diagrams.beams import BeamOutlines, Outline
from planes.words import say
from planes.words.naming import Naming
from planes.words.read_off import measured
from render.labels import Label
from render.paper.marks import Line, Mark, Text
from render.paper.style import tall
from render.paper.symbols import Marks
from render.views.senses import labelled

HIGH_MM = 20.0  # of the largest ordinate
APART_MM = 13.0  # between both diagrams
HATCH_MM = 3.0
NAME_MM, LETTER_MM = 3.5, 5.0
NOTHING = 1e-9  # of the largest: below this it is zero
JUMP = 1e-3  # of the largest: a smaller step is not a step


@dataclass
class BeamDiagrams:
    """Both diagrams under construction, at a scale of lengths."""

    found: BeamOutlines
    naming: Naming
    mu: float  # mm per m

    def drawn(self) -> Marks:
        """The beam with its letters, and the diagrams beneath it."""
        marks, named, y = list[Mark](), list[Label](), -8.0
        stops = {p: self.mu * x for p, x in self.found.stops.items()}
        left, right = min(stops.values()), max(stops.values())
        marks.append(Line((complex(left), complex(right)), "thick"))
        named += [
            Label(self.naming.point(p), complex(self.mu * x), LETTER_MM, 1j, 0.8, name=p)
            for p, x in self.found.stops.items()
        ]
        for title, unit, outline in (("Q", "N", self.found.shears), ("M", "N·m", self.found.moments)):
            most = max((abs(v) for _, v in outline), default=0.0) or 1.0
            up, down = (max(0.0, *(k * v for _, v in outline)) / most * HIGH_MM for k in (1, -1))
            y -= up + 4.0
            text = f"{title}, {say(unit, self.naming.lang)}"
            marks.append(Text(text, complex(left - 4.0, y - tall(NAME_MM) / 2), tall(NAME_MM), "end", name=title))
            marks += self.diagram(outline, y, most)
            named += self.values(outline, y, most)
            y -= down + APART_MM
        marks += [
            Line((complex(self.mu * x), complex(self.mu * x, y + APART_MM)), "thin", "construction")
            for x in self.found.stops.values()
        ]
        return labelled(named, marks)

    def place(self, x: float, v: float, y: float, most: float) -> complex:
        """The end of an ordinate on the paper."""
        return complex(self.mu * x, y + v / most * HIGH_MM)

    def diagram(self, outline: Outline, y: float, most: float) -> list[Mark]:
        """The line of zero, the outline, and the hatching between."""
        spots = [self.place(x, v, y, most) for x, v in outline]
        left, right = spots[0].real, spots[-1].real
        marks: list[Mark] = [Line((complex(left, y), complex(right, y)), "vector")]
        marks.append(Line(tuple(spots), "result", "result"))
        count = int((right - left) / HATCH_MM)
        for k in range(1, count):
            x = left + k * (right - left) / count
            for a, b in pairwise(spots):
                if a.real < x <= b.real:
                    top = a.imag + (x - a.real) / (b.real - a.real) * (b.imag - a.imag)
                    if abs(top - y) > 0.5:
                        marks.append(Line((complex(x, y), complex(x, top)), "thin", "construction"))
        return marks

    def values(self, outline: Outline, y: float, most: float) -> list[Label]:
        """The values where the outline bends or jumps, and the greatest."""
        stops, shown = set(self.found.stops.values()), dict[tuple[float, float], None]()
        extreme = max(outline, key=lambda one: abs(one[1]))
        for x, v in outline:
            if (any(abs(x - s) < NOTHING * max(stops) for s in stops) or (x, v) == extreme) and abs(v) > JUMP * most:
                near = (
                    one for one in shown if abs(one[0] - x) < NOTHING * max(stops) and abs(one[1] - v) < JUMP * most
                )
                if next(near, None) is None:
                    shown[x, v] = None
        value_labels = []
        for x, v in shown:
            z = self.place(x, v, y, most)
            text = measured(abs(v), self.naming.lang)
            value_labels.append(Label(text, z, NAME_MM, 1j if v > 0 else -1j, 0.6, name=f"value {text}"))
        return value_labels
