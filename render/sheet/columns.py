"""Places of views on a sheet: in the order of the calculation, down one column after the other; all in mm.

A module divides the field: as many columns as there are title blocks side by side, each of several units. Every view
begins at the edge of a unit. The ends of columns are chosen as Knuth and Plass break a paragraph into lines (Software:
Practice and Experience 11, 1981): for all of them together, with the least white space and without unnecessary breaks
within a step of the calculation.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, reduce
from itertools import combinations, pairwise

import numpy

from planes.geometry.arrays import Array
from planes.words.frozen import frozen
from render.sheet.module import UNITS_PER_MODULE, VIEW_GAP_MM
from render.sheet.stacking import HEIGHT_EXCESS_TOLERANCE, Piece, Spot, Stacking

MOST_ROW_GAP_MM = 29.0  # of rows of a column between which its white space is shared
MOST_FILLED_SHARE = 0.8  # no field can hold more in columns
STEP_BREAK_COST = 0.1  # cost of ending a column within a step, as the square of a column's white space
MOVED_TABLE_COST = 0.05  # cost of a table one place away from its place in reading order
TABLE_INVERSION_COST = 0.1  # cost of a table before one that is read earlier
# cost of an overfull column; largest excess, of its height, that is tried at all
OVERFULL_COLUMN_COST = 100.0
MOST_TRIED_EXCESS = 0.3


@frozen
class Item:
    """A view to be placed: its size, its step of the calculation, and whether it is a table, which may move away from
    its place in reading order."""

    width: float
    height: float
    step: str = ""
    loose: bool = False


Column = tuple[Piece, int, int]
"""Views, and their units: the first, and the one after the last."""


@dataclass
class Columns:
    """Views broken into columns."""

    items: Sequence[Item]
    stacking: Stacking

    def best_arrangement(self, order: Sequence[int] = (), enough: float = 0.0) -> "tuple[list[int], Columns]":
        """The order in which the views fill the columns best, and these columns; tables are moved, one after another,
        but none before the first view, and only until the cost is less than ``enough``."""
        now = list(order or range(len(self.items)))
        best = self.reordered_columns(now)
        needed = sum((i.width + VIEW_GAP_MM) * (i.height + VIEW_GAP_MM) for i in self.items)
        hopeful = needed < MOST_FILLED_SHARE * self.stacking.module.free_area and self._field_is_large_enough
        hopeful = hopeful and (best.total_cost < OVERFULL_COLUMN_COST or not self.has_no_arrangement)
        for k in (k for k, item in enumerate(self.items) if k and item.loose and hopeful):
            rest = [i for i in now if i != k]
            for tried in ([*rest[:at], k, *rest[at:]] for at in range(1, len(now))):
                if best.total_cost < enough:
                    return now, best
                worst = best.total_cost + self._table_order_cost(now) - self._table_order_cost(tried) - 1e-9
                columns = self.reordered_columns(tried)
                if worst > 0 and columns.total_cost < worst:
                    best = columns
                    now = tried
        return now, best

    def reordered_columns(self, order: Sequence[int]) -> "Columns":
        """The same views in another order."""
        return Columns([self.items[k] for k in order], self.stacking)

    @cached_property
    def total_cost(self) -> float:
        """The cost of these columns; less than ``OVER`` where every view has room."""
        if self._field_is_large_enough:
            return float(self._costs_by_end_unit.min())
        return math.inf

    @cached_property
    def has_no_arrangement(self) -> bool:
        """Whether the views have no room wherever the movable tables are: the others have none by themselves, or none
        with some table among them."""
        moved = [k for k, item in enumerate(self.items) if k and item.loose]
        piece = self.all_views_piece
        last = self.stacking.least_unit_for_columns
        units = self.stacking.module.unit_count
        fixed = tuple(size for k, size in enumerate(piece) if k not in moved)
        among = (((*fixed[:at], piece[k], *fixed[at:]) for at in range(1, len(fixed) + 1)) for k in moved)
        return last(fixed) > units or any(all(last(some) > units for some in ways) for ways in among)

    @property
    def _field_is_large_enough(self) -> bool:
        """Whether the field is at least as large as all views together, each with its gap and as wide as its units."""
        module = self.stacking.module
        return (
            sum(module.span_of_width(i.width) * module.unit_pitch * (i.height + VIEW_GAP_MM) for i in self.items)
            <= module.free_area
        )

    @cached_property
    def view_spots(self) -> list[Spot]:
        """The place of every view; all columns begin at one level, if there is room beneath it."""
        free = self.stacking.module.free_height_interval
        ways = (*map(self._columns_spread_out, (True, False)), self._cheapest_columns)
        columns = next((way for way in ways if self._fit_beneath_level(way)), self._cheapest_columns)
        level = min(free(x, end)[0] for _, x, end in columns)
        level = level if self._fit_beneath_level(columns, level) else math.inf
        return [spot for column in columns for spot in self._column_spots(*column, level)]

    def _fit_beneath_level(self, columns: Sequence[Column], level: float = math.inf) -> bool:
        """Whether columns have room beneath a level."""
        free = self.stacking.module.free_height_interval
        high = self.stacking.least_heights
        room = ((piece, end - x, *free(x, end)) for piece, x, end in columns)
        return all(high(piece)[span] <= min(top, level) - low + 1e-9 for piece, span, top, low in room)

    @cached_property
    def all_views_piece(self) -> Piece:
        """All views."""
        return self.stacking.piece_of_sizes([(i.width, i.height) for i in self.items])

    @cached_property
    def break_costs(self) -> tuple[float, ...]:
        """The cost of beginning a column with each view: that of a view that continues the step before it."""
        pairs = pairwise(["", *(item.step for item in self.items)])
        return tuple(STEP_BREAK_COST * (step == before != "") for before, step in pairs)

    @cached_property
    def _cheapest_columns(self) -> list[Column]:
        """The columns, over all units."""
        last = len(self.items)
        end = int(self._costs_by_end_unit.argmin())
        columns = list[Column]()
        while last:
            ways = numpy.stack([way[end] for way in self._costs_by_last_column(last)])
            back, span = map(int, numpy.unravel_index(ways.argmin(), ways.shape))
            columns.insert(0, (self.all_views_piece[last - 1 - back : last], end - span, end))
            last = last - 1 - back
            end = end - span
        return columns

    @cached_property
    def _costs_by_end_unit(self) -> Array:
        """The cost of all columns, by the unit where they end: later units are white."""
        units = self.stacking.module.unit_count
        return self._least_costs(len(self.items))[0] + numpy.arange(units, -1, -1) / UNITS_PER_MODULE

    def _columns_spread_out(self, flush: bool) -> list[Column]:
        """The columns reduced to their necessary width, with the spare units between them; the last one is to be
        ``flush`` over the title block, if it is no wider."""
        highs = [self.stacking.least_heights(piece)[: end - unit + 1] for piece, unit, end in self._cheapest_columns]
        needs = [int((high > high[-1] + 1e-9).sum()) for high in highs]
        block = self.stacking.module.title_block_unit
        units = self.stacking.module.unit_count
        last = block if flush and sum(needs[:-1]) <= block and needs[-1] <= units - block else units - needs[-1]
        spare = last - sum(needs[:-1])
        gaps = max(len(needs) - 1, 1)
        lefts = [sum(needs[:k]) + spare * k // gaps for k in range(len(needs))]
        return [(piece, x, x + n) for (piece, _, _), x, n in zip(self._cheapest_columns, lefts, needs, strict=True)]

    def _least_costs(self, last: int) -> tuple[Array, Array]:
        """The lowest costs of the first views in the first units; and the cost before a column begins, by its end and
        its span."""
        known = self.stacking.broken
        key = (self.all_views_piece[:last], self.break_costs[:last])
        module = self.stacking.module
        if key not in known:
            costs = (
                reduce(numpy.minimum, self._costs_by_last_column(last)).min(axis=1) if last else module.starting_costs
            )
            known[key] = costs, costs[module.column_starts]
        return known[key]

    def _costs_by_last_column(self, last: int) -> Iterator[Array]:
        """The costs of the first views, by the number in their last column but one: by the unit where it ends, and by
        its span."""
        stacking = self.stacking
        most = (1 + MOST_TRIED_EXCESS) * stacking.module.field_height
        for k in range(last - 1, -1, -1):
            part = self.all_views_piece[k:last]
            if k < last - 1 and stacking.least_heights(part)[-1] > most:
                break
            begun = self._least_costs(k)[1]
            torn = self.break_costs[k]
            yield (begun + torn if torn else begun) + self.column_costs(part)

    def column_costs(self, piece: Piece) -> Array:
        """The cost of a column of some views, by its end and its span: its white space, or its excess."""
        prices = self.stacking.prices
        if piece not in prices:
            white = self.stacking.white_space(piece)
            fair = prices[piece] = self.stacking.module.span_shares * (white * white)
            fair += OVERFULL_COLUMN_COST * (white < -HEIGHT_EXCESS_TOLERANCE)
            numpy.copyto(fair, numpy.inf, where=white <= -MOST_TRIED_EXCESS)
        return prices[piece]

    def _column_spots(self, piece: Piece, unit: int, end: int, level: float) -> Iterator[Spot]:
        """The views of a column from a level downwards, its white space shared between its rows."""
        free, low = self.stacking.module.free_height_interval(unit, end)
        span = end - unit
        top = min(free, level)
        rows = self.stacking.rows_of_piece(piece, span)
        spare = (top - low - sum(self.stacking.least_heights(row)[span] for row in rows)) / max(len(rows) - 1, 1)
        return self.stacking.row_spots(rows, unit, span, top, min(spare, MOST_ROW_GAP_MM))

    def _table_order_cost(self, order: Sequence[int]) -> float:
        """The cost of tables away from their places in reading order, above all of one before an earlier one."""
        tables = [k for k in order if self.items[k].loose]
        turned = sum(k > j for k, j in combinations(tables, 2))
        return MOVED_TABLE_COST * sum(abs(k - place) for place, k in enumerate(order)) + TABLE_INVERSION_COST * turned
