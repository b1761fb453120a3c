"""The module of a sheet: a field divided into units, at whose edges its views begin; all in mm."""

import math
from functools import cached_property

import numpy
from numpy.typing import NDArray

from planes.geometry.arrays import Array
from planes.words.frozen import frozen
from render.labels.footprints import Bounds

Indices = NDArray[numpy.intp]

VIEW_GAP_MM = 7.0  # least distance between views, and from the frame
LEAST_RIGHT_GAP_MM = 3.5  # distance of the widest views from the right edge of the frame
MODULE_WIDTH_MM = 185.0  # the width of the title block, with a column of tables over it
# units per module, modules in the widest column, unless a view is wider
UNITS_PER_MODULE = 12
MOST_MODULES_PER_COLUMN = 2


@frozen
class Module:
    """The units of a field: the inside of a frame, the areas already taken, and the widest of the coming views."""

    inside: Bounds
    taken: tuple[Bounds, ...]
    wide: float = 0.0

    @property
    def field_height(self) -> float:
        """The height of the field."""
        return self.inside[3] - self.inside[1]

    @property
    def free_area(self) -> float:
        """Its free area, mm²."""
        taken = sum((right - left) * (top - low) for left, low, right, top in self.taken)
        return (self.inside[2] - self.inside[0]) * self.field_height - taken

    @cached_property
    def unit_count(self) -> int:
        """The number of units: as many as leave a margin at the right of the frame."""
        return math.floor((self.inside[2] - self.inside[0] - LEAST_RIGHT_GAP_MM) / self.unit_pitch + 1e-9)

    @property
    def most_span(self) -> int:
        """The largest span of a column."""
        return min(max(MOST_MODULES_PER_COLUMN * UNITS_PER_MODULE, self.span_of_width(self.wide)), self.unit_count)

    @cached_property
    def unit_pitch(self) -> float:
        """The distance of units: such that one begins over the left edge of the title block."""
        wide = self.inside[2] - self.inside[0]
        usual = (wide - VIEW_GAP_MM) / (UNITS_PER_MODULE * max(1, round(wide / MODULE_WIDTH_MM)))
        count = round(self._distance_to_title_block / usual)
        return self._distance_to_title_block / count if count else usual

    @property
    def title_block_unit(self) -> int:
        """The unit that begins over the left edge of the title block; 0 where none does."""
        return round(self._distance_to_title_block / self.unit_pitch)

    @property
    def _distance_to_title_block(self) -> float:
        """The distance from the first unit to the title block."""
        if self.taken:
            return max(0.0, self.taken[0][0] - self.inside[0] - VIEW_GAP_MM)
        return 0.0

    def left(self, unit: int) -> float:
        """The left edge of a unit."""
        return self.inside[0] + VIEW_GAP_MM + unit * self.unit_pitch

    def span_of_width(self, width: float) -> int:
        """The number of units a view needs."""
        return math.ceil((width + VIEW_GAP_MM) / self.unit_pitch - 1e-9)

    def free_height_interval(self, unit: int, end: int) -> tuple[float, float]:
        """The free interval of height for a column of some units."""
        x0 = self.left(unit) - VIEW_GAP_MM
        x1 = self.left(end)
        low = self.inside[1]
        top = self.inside[3]
        for left, lower, right, upper in self.taken:
            if left < x1 - 1e-6 and x0 < right:
                low, top = (upper, top) if lower <= low else (low, min(top, lower))
        return top - VIEW_GAP_MM, low + VIEW_GAP_MM

    @cached_property
    def column_starts(self) -> Indices:
        """The start of a column, by its end and its span; 0 where there is none."""
        return numpy.maximum(numpy.subtract.outer(numpy.arange(self.unit_count + 1), self.possible_spans), 0)

    @cached_property
    def starting_costs(self) -> Array:
        """The cost without any column yet, by the unit where the first one begins: at the edge of the field."""
        return numpy.where(numpy.arange(self.unit_count + 1) == 0, 0.0, numpy.inf)

    @cached_property
    def possible_spans(self) -> Indices:
        """Possible spans of a column."""
        return numpy.arange(self.most_span + 1)

    @cached_property
    def span_shares(self) -> Array:
        """The spans relative to the module; 1 for none, where there is no column."""
        return numpy.where(self.possible_spans > 0, self.possible_spans, UNITS_PER_MODULE) / UNITS_PER_MODULE

    @cached_property
    def column_heights(self) -> Array:
        """The height of a column, by its end and its span, relative to the field's height; negative where it would
        begin outside."""
        shares = numpy.full(self.column_starts.shape, -numpy.inf)
        for end in range(self.unit_count + 1):
            for span in range(1, min(end, self.most_span) + 1):
                top, low = self.free_height_interval(end - span, end)
                shares[end, span] = (top - low) / self.field_height
        return shares
