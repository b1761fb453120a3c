"""The module of a sheet: a field divided into units, at whose edges its views begin; all in mm."""

import math
from functools import cached_property

import numpy
from numpy.typing import NDArray

from planes.geometry.arrays import Array
from planes.words.frozen import frozen
from render.labels.footprints import Bounds

Indices = NDArray[numpy.intp]

GAP_MM = 7.0  # least distance between views, and from the frame
LEAST_GAP_MM = 3.5  # distance of the widest views from the right edge of the frame
MODULE_MM = 185.0  # the width of the title block, with a column of tables over it
UNITS, WIDEST = 12, 2  # units per module, modules in the widest column, unless a view is wider


@frozen
class Module:
    """The units of a field: the inside of a frame, the areas already taken, and the widest of the coming views."""

    inside: Bounds
    taken: tuple[Bounds, ...]
    wide: float = 0.0

    @property
    def height(self) -> float:
        """The height of the field."""
        return self.inside[3] - self.inside[1]

    @property
    def area(self) -> float:
        """Its free area, mm²."""
        taken = sum((right - left) * (top - low) for left, low, right, top in self.taken)
        return (self.inside[2] - self.inside[0]) * self.height - taken

    @cached_property
    def units(self) -> int:
        """The number of units: as many as leave a margin at the right of the frame."""
        return math.floor((self.inside[2] - self.inside[0] - LEAST_GAP_MM) / self.pitch + 1e-9)

    @property
    def widest(self) -> int:
        """The largest span of a column."""
        return min(max(WIDEST * UNITS, self.span(self.wide)), self.units)

    @cached_property
    def pitch(self) -> float:
        """The distance of units: such that one begins over the left edge of the title block."""
        wide = self.inside[2] - self.inside[0]
        usual = (wide - GAP_MM) / (UNITS * max(1, round(wide / MODULE_MM)))
        count = round(self._before / usual)
        return self._before / count if count else usual

    @property
    def block(self) -> int:
        """The unit that begins over the left edge of the title block; 0 where none does."""
        return round(self._before / self.pitch)

    @property
    def _before(self) -> float:
        """The distance from the first unit to the title block."""
        return max(0.0, self.taken[0][0] - self.inside[0] - GAP_MM) if self.taken else 0.0

    def left(self, unit: int) -> float:
        """The left edge of a unit."""
        return self.inside[0] + GAP_MM + unit * self.pitch

    def span(self, width: float) -> int:
        """The number of units a view needs."""
        return math.ceil((width + GAP_MM) / self.pitch - 1e-9)

    def free(self, unit: int, end: int) -> tuple[float, float]:
        """The free interval of height for a column of some units."""
        x0, x1 = self.left(unit) - GAP_MM, self.left(end)
        low, top = self.inside[1], self.inside[3]
        for left, lower, right, upper in self.taken:
            if left < x1 - 1e-6 and x0 < right:
                low, top = (upper, top) if lower <= low else (low, min(top, lower))
        return top - GAP_MM, low + GAP_MM

    @cached_property
    def starts(self) -> Indices:
        """The start of a column, by its end and its span; 0 where there is none."""
        return numpy.maximum(numpy.subtract.outer(numpy.arange(self.units + 1), self.spans), 0)

    @cached_property
    def begun(self) -> Array:
        """The cost without any column yet, by the unit where the first one begins: at the edge of the field."""
        return numpy.where(numpy.arange(self.units + 1) == 0, 0.0, numpy.inf)

    @cached_property
    def spans(self) -> Indices:
        """Possible spans of a column."""
        return numpy.arange(self.widest + 1)

    @cached_property
    def shares(self) -> Array:
        """The spans relative to the module; 1 for none, where there is no column."""
        return numpy.where(self.spans > 0, self.spans, UNITS) / UNITS

    @cached_property
    def heights(self) -> Array:
        """The height of a column, by its end and its span, relative to the field's height; negative where it would
        begin outside."""
        shares = numpy.full(self.starts.shape, -numpy.inf)
        for end in range(self.units + 1):
            for span in range(1, min(end, self.widest) + 1):
                top, low = self.free(end - span, end)
                shares[end, span] = (top - low) / self.height
        return shares
