"""Places of views on a sheet: in the order of the calculation, down one column after the other; all in mm.

A module divides the field: as many columns as title blocks stand side by side, each of some units. Every view begins at
the edge of a unit. Where columns end is chosen as Knuth and Plass break a paragraph into lines (Software: Practice and
Experience 11, 1981): for all of them together, so that least white is left, and no step of the calculation is torn that
need not be.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy

from planes.geometry.arrays import Array
from render.sheet.module import GAP_MM, UNITS, Indices
from render.sheet.stacking import Piece, Spot, Stacking

MOST_GAP_MM = 29.0  # of rows of a column between which its white is shared out
FULLEST = 0.8  # no field can hold more in columns
TORN = 0.1  # what it costs to end a column amid a step, as a column of white squared
ASTRAY = 0.05  # what it costs that a table stands one place from where it would be read
OVER, OVERFULL = 100.0, 0.3  # what it costs that a column holds too much; how much, of its height, is tried at all


@dataclass(frozen=True)
class Item:
    """A view to be placed: its size, the step of the calculation it belongs to, and whether it is a table, which may
    stand earlier or later than it would be read."""

    width: float
    height: float
    step: str = ""
    loose: bool = False


Column = tuple[Piece, int, int]
"""Views, and the units in which they stand: the first, and the one after the last."""


@dataclass
class Columns:
    """Views broken into columns; what is known of their pieces is shared with other orders of them."""

    items: Sequence[Item]
    stacking: Stacking
    prices: dict[Piece, Array] = field(default_factory=dict, repr=False)

    def arranged(self, order: Sequence[int] = ()) -> tuple[list[int], Columns]:
        """The order in which the views fill the columns best, and these; tables are moved about, one after another."""
        now = list(order or range(len(self.items)))
        best = self.ordered(now)
        needed = sum((i.width + GAP_MM) * (i.height + GAP_MM) for i in self.items)
        hopeful = needed < FULLEST * self.stacking.module.area
        for k in (k for k, item in enumerate(self.items) if item.loose and hopeful):
            rest = [i for i in now if i != k]
            for tried in ([*rest[:at], k, *rest[at:]] for at in range(len(now))):
                columns = self.ordered(tried)
                if columns.cost + _astray(tried) < best.cost + _astray(now) - 1e-9:
                    best, now = columns, tried
        return now, best

    def ordered(self, order: Sequence[int]) -> Columns:
        """The same views in another order."""
        return Columns([self.items[k] for k in order], self.stacking, self.prices)

    @property
    def cost(self) -> float:
        """How far they are from being filled well; less than ``OVER`` where every view has room."""
        return float(self._ended.min())

    @cached_property
    def spots(self) -> list[Spot]:
        """Where every view stands."""
        spaced, high, free = self._spaced(), self.stacking.high, self.stacking.module.free
        room = all(high(piece)[end - x] <= free(x, end)[0] - free(x, end)[1] + 1e-9 for piece, x, end in spaced)
        return [spot for column in (spaced if room else self._columns) for spot in self._placed(*column)]

    @cached_property
    def piece(self) -> Piece:
        """All views."""
        return self.stacking.piece([(i.width, i.height) for i in self.items])

    @cached_property
    def _columns(self) -> list[Column]:
        """The columns, over all units."""
        (last, end), found = (len(self.items), int(self._ended.argmin())), list[Column]()
        while last:
            first, unit = map(int, self._broken[1][last, end])
            found.insert(0, (self.piece[first:last], unit, end))
            last, end = first, unit
        return found

    @cached_property
    def _ended(self) -> Array:
        """What all columns cost, by the unit where they end: those after it are white."""
        found: Array = self._broken[0][-1] + numpy.arange(self.stacking.module.units, -1, -1) / UNITS
        return found

    def _spaced(self) -> list[Column]:
        """The columns no wider than they need to be, with the units they do not need between them."""
        highs = [self.stacking.high(piece)[: end - unit + 1] for piece, unit, end in self._columns]
        needs = [int((high > high[-1] + 1e-9).sum()) for high in highs]
        spare, gaps = self.stacking.module.units - sum(needs), max(len(needs) - 1, 1)
        lefts = [sum(needs[:k]) + spare * k // gaps for k in range(len(needs))]
        return [(piece, x, x + n) for (piece, _, _), x, n in zip(self._columns, lefts, needs, strict=True)]

    @cached_property
    def _broken(self) -> tuple[Array, Indices]:
        """The cheapest way to have the first views in the first units: its cost, and where its last column starts."""
        count, module = len(self.items), self.stacking.module
        costs = numpy.full((count + 1, module.units + 1), numpy.inf)
        starts, every = numpy.zeros((*costs.shape, 2), numpy.intp), numpy.arange(module.units + 1)
        costs[0, 0] = 0.0
        for first in range(count):
            before = costs[first][module.starts]
            for last in range(first + 1, count + 1):
                if self.stacking.high(self.piece[first:last])[-1] > (1 + OVERFULL) * module.height:
                    break
                total = before + self.price(self.piece[first:last]) + TORN * self._torn(last)
                span = total.argmin(axis=1)
                better = total[every, span] < costs[last]
                costs[last] = numpy.where(better, total[every, span], costs[last])
                starts[last, better, 0], starts[last, better, 1] = first, (every - span)[better]
        return costs, starts

    def price(self, piece: Piece) -> Array:
        """What a column of some views costs, by its end and its span: its white, or what is too much in it."""
        if piece not in self.prices:
            module = self.stacking.module
            white = module.heights - self.stacking.high(piece) / module.height
            tried = white > -OVERFULL
            fair = module.spans / UNITS * numpy.where(tried, white, 0.0) ** 2 + OVER * (white < -1e-9)
            self.prices[piece] = numpy.where(tried, fair, numpy.inf)
        return self.prices[piece]

    def _torn(self, k: int) -> bool:
        """Whether a view and the one before it are of one step."""
        return k < len(self.items) and self.items[k].step == self.items[k - 1].step != ""

    def _placed(self, piece: Piece, unit: int, end: int) -> Iterator[Spot]:
        """The views of a column, its white shared out between its rows."""
        (top, low), span = self.stacking.module.free(unit, end), end - unit
        rows = self.stacking.rows(piece, span)
        spare = (top - low - sum(self.stacking.high(row)[span] for row in rows)) / max(len(rows) - 1, 1)
        return self.stacking.placed(rows, unit, span, top, min(spare, MOST_GAP_MM))


def _astray(order: Sequence[int]) -> float:
    return ASTRAY * sum(abs(k - place) for place, k in enumerate(order))
