"""A pen that records the outlines of a font's glyph as polylines."""

from __future__ import annotations

from typing import TYPE_CHECKING

from fontTools.pens.basePen import BasePen

from render.paper.lettering import bezier_points

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
        line = self.lines[-1]
        line += bezier_points(line[-1], complex(*pt1), complex(*pt2), complex(*pt3), self.error)

    def _closePath(self) -> None:
        line = self.lines[-1]
        if abs(line[-1] - line[0]) > 0:
            line.append(line[0])

    def _endPath(self) -> None:
        self._closePath()
