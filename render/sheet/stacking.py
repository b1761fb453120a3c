"""Views that follow each other in one column: beneath each other, or beside each other where that is lower.

Parts of them are put together in the same way, so that a tall view has two small ones beside it. How high views are at
the least is known for every number of units they may span.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import lru_cache

import numpy

from planes.geometry.arrays import Array
from render.sheet.module import GAP_MM, Indices, Module

Piece = tuple[int, ...]
"""Views that follow each other: each as the number of its size."""
Size = tuple[float, float]


@dataclass(frozen=True)
class Spot:
    """Where a view stands: its left and upper edges."""

    x: float
    top: float


@dataclass
class Stacking:
    """Pieces in the units of a module, and what is known of columns of them: what one costs, and what the first ones
    do."""

    module: Module
    sizes: dict[Size, int] = field(default_factory=dict)
    highs: dict[Piece, Array] = field(default_factory=dict, repr=False)
    prices: dict[Piece, Array] = field(default_factory=dict, repr=False)
    broken: dict[tuple[Piece, tuple[float, ...]], Array] = field(default_factory=dict, repr=False)

    def piece(self, sizes: Sequence[Size]) -> Piece:
        """Views of these sizes."""
        for size in sizes:
            if size not in self.sizes:
                self.sizes[size] = len(self.sizes)
                fits = self.module.spans >= self.module.span(size[0])
                self.highs[(self.sizes[size],)] = numpy.where(fits, size[1], numpy.inf)
        return tuple(self.sizes[size] for size in sizes)

    def high(self, piece: Piece) -> Array:
        """How high views are at the least, by the units they may span: two parts beneath or beside each other."""
        found = self.highs.get(piece)
        if found is None:
            first = numpy.stack([self.high(piece[:k]) for k in range(1, len(piece))])
            second = numpy.stack([self.high(piece[k:]) for k in range(1, len(piece))])
            whole, part = _shares(first.shape[1])
            beside = numpy.maximum(first[:, part], second[:, whole]).min(axis=2)
            found = self.highs[piece] = numpy.minimum(first + GAP_MM + second, beside).min(axis=0)
        return found

    def rows(self, piece: Piece, span: int) -> list[Piece]:
        """The parts of a piece that stand beneath each other."""
        for k in range(1, len(piece)):
            parts = piece[:k], piece[k:]
            if sum(self.high(part)[span] for part in parts) + GAP_MM <= self.high(piece)[span] + 1e-9:
                return [row for part in parts for row in self.rows(part, span)]
        return [piece]

    def placed(self, rows: Sequence[Piece], unit: int, span: int, top: float, gap: float = GAP_MM) -> Iterator[Spot]:
        """The views of rows that stand beneath each other."""
        for row in rows:
            yield from self._beside(row, unit, span, top)
            top -= float(self.high(row)[span]) + gap

    def _beside(self, row: Piece, unit: int, span: int, top: float) -> Iterator[Spot]:
        """The views of a row: one, or two parts beside each other."""
        if len(row) == 1:
            yield Spot(self.module.left(unit), top)
            return
        ways = ((k, share) for share in range(1, span) for k in range(1, len(row)))
        k, share = min(ways, key=lambda w: max(self.high(row[: w[0]])[w[1]], self.high(row[w[0] :])[span - w[1]]))
        for part, start, wide in ((row[:k], unit, share), (row[k:], unit + share, span - share)):
            yield from self.placed(self.rows(part, wide), start, wide, top)


@lru_cache
def _shares(count: int) -> tuple[Indices, Indices]:
    """The two shares into which each number of units can be parted, the last of them repeated."""
    whole, part = numpy.mgrid[:count, :count]
    return numpy.maximum(whole - part, 0), numpy.minimum(part, whole)
