"""A pen that records the outlines of a font's glyph as polylines."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from fontTools.pens.basePen import BasePen

if TYPE_CHECKING:
    from fontTools.ttLib.ttGlyphSet import _TTGlyphSet

Point = tuple[float, float]


class Flattened(BasePen):  # type: ignore[misc]
    """Closed polylines of a glyph in ``lines``, within ``error`` of its curves, in the font's units."""

    def __init__(self, glyphs: _TTGlyphSet, error: float) -> None:
        super().__init__(glyphs)
        self.error = error
        self.lines: list[list[complex]] = []

    def _moveTo(self, pt: Point) -> None:
        self.lines.append([complex(*pt)])

    def _lineTo(self, pt: Point) -> None:
        self.lines[-1].append(complex(*pt))

    def _curveToOne(self, pt1: Point, pt2: Point, pt3: Point) -> None:
        a, b, c, d = self.lines[-1][-1], complex(*pt1), complex(*pt2), complex(*pt3)
        bend = max(abs(a - 2 * b + c), abs(b - 2 * c + d))
        count = max(2, math.ceil(math.sqrt(0.75 * bend / self.error)))
        for k in range(1, count + 1):
            t = k / count
            u = 1 - t
            self.lines[-1].append(u**3 * a + 3 * u * u * t * b + 3 * u * t * t * c + t**3 * d)

    def _closePath(self) -> None:
        line = self.lines[-1]
        if abs(line[-1] - line[0]) > 0:
            line.append(line[0])

    def _endPath(self) -> None:
        self._closePath()
