"""Sketches of a crankshaft as a cranked bar: bearings, webs, pin, counterweights, with masses, forces, dimensions."""

import cmath
import math
from collections.abc import Iterator

from planes.solving.document import ShaftSketch
from render.labels.footprints import box_around_marks
from render.paper.marks import Anchor, Arc, Arrow, Line, Mark, Text
from render.views import View

SPAN_LENGTH_MM = 92.0  # length of the span
FORCE_LENGTH_MM = 15.0  # forces are not to scale
FORCE_DIRECTIONS = {"up": 1j, "down": -1j, "across": cmath.rect(0.9, math.radians(35.0))}
"""The symbol of a force: in the plane of the crank, or perpendicular to the paper, which is drawn obliquely."""
COUNTERWEIGHT_RADIUS_MM = 3.0
MASS_RADIUS_MM = 1.6
BEARING_RADIUS_MM = 1.5
NAME_LETTER_MM = 3.5


class ShaftDrawing:
    """A crankshaft being drawn, the first bearing at the origin."""

    def __init__(self, block: ShaftSketch) -> None:
        self.block = block
        self.scale = SPAN_LENGTH_MM / block.span
        self.end, self.left, self.pin = (self.scale * x for x in (block.span, block.webs, block.pin))
        self.right = self.end - self.left
        self.up = self.scale * block.r
        self.down = -self.scale * block.radius
        self.places = {
            "A": 0j,
            "B": complex(self.end, 0),
            "pin": complex(self.pin, self.up),
            "web_0": complex(self.left, self.up),
            "web_1": complex(self.right, self.up),
            "weight_0": complex(self.left, self.down),
            "weight_1": complex(self.right, self.down),
        }

    def drawn_marks(self) -> Iterator[Mark]:
        """All marks."""
        at = self.places
        web = (complex(self.left, 0), complex(self.right, 0))
        yield Line((-12 + 0j, self.end + 12 + 0j), "axis", "axis")
        yield Line((0j, web[0], at["web_0"], at["web_1"], web[1], at["B"]))
        for k, foot in enumerate(web):
            yield Line((foot, at[f"weight_{k}"]), "thin")
            yield Arc(at[f"weight_{k}"], COUNTERWEIGHT_RADIUS_MM, fill="paper")
        for name, aside in (("A", -9), ("B", 6)):
            z = at[name]
            yield Line((z - 5 - 8j, z, z + 5 - 8j), closed=True)
            yield Arc(z, BEARING_RADIUS_MM, fill="paper")
            yield Text(name, z + aside - 9j, 5)
        for place, name in self.block.masses.items():
            if place == "pin":
                yield Arc(at[place], MASS_RADIUS_MM, fill="ink")
            yield self.name_beside(place, at[place] + (2.8j if place == "pin" else -6j), name)
        for (place, way), name in self.block.forces.items():
            yield from self.force_marks(place, way, name)
        yield from self.dimension_marks()

    def force_marks(self, place: str, way: str, name: str) -> Iterator[Mark]:
        """A force that begins at its place, or acts against a bearing, with its name beside its far end."""
        near = self.places[place] + (
            COUNTERWEIGHT_RADIUS_MM * FORCE_DIRECTIONS[way] if place.startswith("weight") else 0j
        )
        far = near + FORCE_LENGTH_MM * FORCE_DIRECTIONS[way]
        yield Arrow(far, near, name=name) if place in "AB" else Arrow(near, far, name=name)
        if way == "across":
            yield Text(name, far + 1.5 - 1j, NAME_LETTER_MM)
        else:
            yield self.name_beside(place, far - 3.5 * FORCE_DIRECTIONS[way] - 1j, name)

    def name_beside(self, place: str, z: complex, name: str) -> Text:
        """A name beside a place, on the free side."""
        outside = place in ("web_1", "weight_1")
        anchor: Anchor = "start" if outside else "end"
        return Text(name, z + (1 if outside else -1) * (COUNTERWEIGHT_RADIUS_MM + 1.5), NAME_LETTER_MM, anchor)

    def dimension_marks(self) -> Iterator[Mark]:
        """The requested dimensions: along the shaft in rows beneath it, radii beside it."""
        left = self.left
        pin = self.pin
        right = self.right
        end = self.end
        row = (0.0, left, "m"), (right, end, "m"), (left, pin, "a"), (pin, right, "b")
        rows = row, ((pin, end, "n"),), ((0.0, end, "L"),)
        low = self.down - 14 - (FORCE_LENGTH_MM if any(way == "down" for _, way in self.block.forces) else 0)
        shown = [[size for size in row if size[2] in self.block.sizes] for row in rows]
        for k, asked in enumerate(filter(None, shown)):
            for a, b, name in asked:
                yield from _dimension_line(complex(a, low - 9 * k), complex(b, low - 9 * k), name, 1j)
        aside = self.left - 16.0
        for name, far in (("r", self.up), ("R", self.down)):
            if name in self.block.sizes:
                yield Line((complex(self.left, far), complex(aside - 2, far)), "thin", "dimension")
                yield from _dimension_line(complex(aside, 0), complex(aside, far), self.block.sizes[name], -1)


def shaft_view(block: ShaftSketch) -> View:
    """The sketch as a view."""
    marks = tuple(ShaftDrawing(block).drawn_marks())
    return View("shaft", "", marks, box_around_marks(marks))


def _dimension_line(a: complex, b: complex, name: str, side: complex) -> Iterator[Mark]:
    """A dimension between two places, its name on one side of it."""
    middle = (a + b) / 2
    for z in (a, b):
        yield Line((z - 2 * side, z + 3 * side), "thin", "dimension")
        yield Arrow(middle, z, "thin", "dimension")
    yield Text(name, middle + (1j if side == 1j else -1.5 - 1.2j), NAME_LETTER_MM, "middle" if side == 1j else "end")
