"""Consecutive views in one column: beneath each other, or beside each other where that is lower.

Parts of them are combined in the same way, so that a tall view has two small ones beside it. The least height of views
is known for every span in units.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import takewhile

import numpy

from planes.geometry.arrays import Array
from planes.words.frozen import frozen
from render.sheet.module import VIEW_GAP_MM, Indices, Module

Piece = tuple[int, ...]
"""Consecutive views: each as the index of its size."""
Size = tuple[float, float]
HEIGHT_EXCESS_TOLERANCE = 1e-9  # of the field's height: largest excess of a column


@frozen
class Spot:
    """The place of a view: its left and upper edges."""

    x: float
    top: float


@dataclass
class Stacking:
    """Pieces in the units of a module, and the results for columns of them: the cost of one, and those of the first
    ones together."""

    module: Module
    sizes: dict[Size, int] = field(default_factory=dict)
    numbers: dict[Piece, int] = field(default_factory=dict, repr=False)
    highs: Array = field(default_factory=lambda: numpy.empty((0, 0)), repr=False)
    least: list[int] = field(default_factory=list, repr=False)
    prices: dict[Piece, Array] = field(default_factory=dict, repr=False)
    broken: dict[tuple[Piece, tuple[float, ...]], tuple[Array, Array]] = field(default_factory=dict, repr=False)
    nexts: dict[Piece, list[int]] = field(default_factory=dict, repr=False)
    lasts: dict[Piece, int] = field(default_factory=lambda: {(): 0}, repr=False)

    def piece_of_sizes(self, sizes: Sequence[Size]) -> Piece:
        """Views of these sizes as a piece."""
        for size in sizes:
            if size not in self.sizes:
                self.sizes[size] = len(self.sizes)
                least = self.module.span_of_width(size[0])
                fits = self.module.possible_spans >= least
                self._store_heights((self.sizes[size],), numpy.where(fits, size[1], numpy.inf), least)
        return tuple(self.sizes[size] for size in sizes)

    def least_heights(self, piece: Piece) -> Array:
        """The least height of views, by their span in units: two parts beneath or beside each other."""
        number = self._row_number(piece)  # may add rows to ``highs``
        heights: Array = self.highs[number]
        return heights

    def _row_number(self, piece: Piece) -> int:
        """The row of ``highs`` of a piece, once its heights are known."""
        if piece in self.numbers:
            return self.numbers[piece]
        return self._compute_heights(piece)

    def _compute_heights(self, piece: Piece) -> int:
        """The results for more than one view."""
        above = [self._row_number(piece[:k]) for k in range(1, len(piece))]
        below = [self._row_number(piece[k:]) for k in range(1, len(piece))]
        first = self.highs[above]
        second = self.highs[below]
        high = numpy.minimum.reduce(first + VIEW_GAP_MM + second)
        if any(self.least[a] + self.least[b] < len(high) for a, b in zip(above, below, strict=True)):
            left, right, begun = _unit_divisions(len(high))
            beside = numpy.minimum.reduce(numpy.maximum(first.take(left, 1), second.take(right, 1)))
            numpy.minimum(high[2:], numpy.minimum.reduceat(beside, begun), out=high[2:])
        return self._store_heights(piece, high, max(self.least[above[0]], self.least[below[0]]))

    def _store_heights(self, piece: Piece, high: Array, least: int) -> int:
        """Store the heights of a piece, and the least units it needs."""
        number = self.numbers[piece] = len(self.least)
        self.least.append(least)
        if number >= len(self.highs):
            more = numpy.empty((max(64, number), len(high)))
            self.highs = numpy.concatenate([self.highs.reshape(-1, len(high)), more])
        self.highs[number] = high
        return number

    def white_space(self, piece: Piece) -> Array:
        """The white space in a column of some views, by its end and its span, relative to the field's height."""
        return self.module.column_heights - self.least_heights(piece) / self.module.field_height

    def least_unit_for_columns(self, piece: Piece) -> int:
        """The least unit before which views have room in columns, with any spare units between them; one more than
        exist, if they have none. If views are removed, the remaining ones never need more."""
        if piece not in self.lasts:
            nowhere = self.module.unit_count + 1
            parts = takewhile(
                lambda k: self.least_ends_of_column(piece[k:])[0] < nowhere, range(len(piece) - 1, -1, -1)
            )
            self.lasts[piece] = min(
                (self.least_ends_of_column(piece[k:])[self.least_unit_for_columns(piece[:k])] for k in parts),
                default=nowhere,
            )
        return self.lasts[piece]

    def least_ends_of_column(self, piece: Piece) -> list[int]:
        """The least unit where a column of some views may end, by the one before which it may not begin."""
        if piece not in self.nexts:
            ends, spans = numpy.nonzero(self.white_space(piece) >= -HEIGHT_EXCESS_TOLERANCE)
            least = numpy.full(self.module.unit_count + 2, self.module.unit_count + 1)
            numpy.minimum.at(least, ends - spans, ends)
            self.nexts[piece] = numpy.minimum.accumulate(least[::-1])[::-1].tolist()
        return self.nexts[piece]

    def rows_of_piece(self, piece: Piece, span: int) -> list[Piece]:
        """The parts of a piece that are beneath each other."""
        for k in range(1, len(piece)):
            parts = piece[:k], piece[k:]
            if (
                sum(self.least_heights(part)[span] for part in parts) + VIEW_GAP_MM
                <= self.least_heights(piece)[span] + 1e-9
            ):
                return [row for part in parts for row in self.rows_of_piece(part, span)]
        return [piece]

    def row_spots(
        self, rows: Sequence[Piece], unit: int, span: int, top: float, gap: float = VIEW_GAP_MM
    ) -> Iterator[Spot]:
        """The views of rows beneath each other."""
        for row in rows:
            yield from self._spots_in_row(row, unit, span, top)
            top -= float(self.least_heights(row)[span]) + gap

    def _spots_in_row(self, row: Piece, unit: int, span: int, top: float) -> Iterator[Spot]:
        """The views of a row: one, or two parts beside each other."""
        if len(row) == 1:
            yield Spot(self.module.left(unit), top)
            return
        ways = ((k, share) for share in range(1, span) for k in range(1, len(row)))
        k, share = min(
            ways, key=lambda w: max(self.least_heights(row[: w[0]])[w[1]], self.least_heights(row[w[0] :])[span - w[1]])
        )
        for part, start, wide in ((row[:k], unit, share), (row[k:], unit + share, span - share)):
            yield from self.row_spots(self.rows_of_piece(part, wide), start, wide, top)


@lru_cache
def _unit_divisions(count: int) -> tuple[Indices, Indices, Indices]:
    """The two shares into which each number of units from 2 can be divided, all in a row; the start of each number."""
    every = [(share, total - share) for total in range(2, count) for share in range(1, total)]
    left, right = numpy.array(every, dtype=numpy.intp).reshape(-1, 2).T
    return left, right, numpy.cumsum([0, *range(1, count - 2)])
