"""Marks -> PDF by reportlab, in true size; text as pen strokes with invisible real text for searching.

The same marks give the same bytes.
"""

from __future__ import annotations

import cmath
import io
import math
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

from planes.scene.files import save
from render.paper.ink import arc_dashes, arrow_parts, by_layer, checked, hatch_strokes, is_circle, length_mm
from render.paper.marks import Arc, Arrow, Hatch, Line, Mark, Shape, Text
from render.paper.outlines import dejavu
from render.paper.photo import Photo
from render.paper.style import BLACK, CAPITALS, PAPER, fitted, pen
from render.paper.typeset import LaidText, layout

POINTS_PER_MM = 72 / 25.4
FONT = "DejaVuSans"
_INVISIBLE, _ROUND, _BUTT, _NON_ZERO = 3, 1, 0, 1

Page = tuple[Iterable[Mark], tuple[float, float]]


def write(
    marks: Iterable[Mark],
    size_mm: tuple[float, float],
    title: str,
    path: str | Path | None = None,
    *,
    description: str = "",
    lang: str = "ru",
    under: Photo | None = None,
) -> bytes:
    """The sheet as a PDF file of one page, ``under`` it a picture; also written to ``path`` if one is given."""
    return write_pages([(marks, size_mm)], title, path, description=description, lang=lang, under=under)


def write_pages(
    pages: Iterable[Page],
    title: str,
    path: str | Path | None = None,
    *,
    description: str = "",
    lang: str = "ru",
    under: Photo | None = None,
) -> bytes:
    """Several sheets (marks and width × height in mm) as one PDF file."""
    from reportlab.pdfgen.canvas import Canvas

    data = io.BytesIO()
    canvas = Canvas(data, invariant=1, pageCompression=1, lang=lang, initialFontName=_font())
    canvas.setTitle(title)
    canvas.setSubject(description or title)
    canvas.setCreator("planes")
    canvas.setAuthor("")
    for marks, size_mm in pages:
        held = checked(marks, size_mm)
        canvas.setPageSize(tuple(POINTS_PER_MM * side for side in size_mm))
        canvas.scale(POINTS_PER_MM, POINTS_PER_MM)
        canvas.setLineJoin(_ROUND)
        _lay(canvas, under)
        _Page(canvas).draw(held)
        canvas.showPage()
    canvas.save()
    return save(data.getvalue(), path)


def draw_marks(canvas: Any, marks: Iterable[Mark]) -> None:
    """Marks on a canvas whose unit is one millimetre."""
    _font()
    canvas.setLineJoin(_ROUND)
    _Page(canvas).draw(marks)


def _lay(canvas: Any, photo: Photo | None) -> None:
    """A picture on the empty page."""
    if photo:
        from reportlab.lib.utils import ImageReader

        x0, y0, x1, y1 = photo.box
        canvas.drawImage(ImageReader(io.BytesIO(photo.data)), x0, y0, x1 - x0, y1 - y0)


def _font() -> str:
    """The name of the embedded font, registered on first use."""
    from reportlab.pdfbase import pdfmetrics
    from reportlab.pdfbase.ttfonts import TTFont

    if FONT not in pdfmetrics.getRegisteredFontNames():
        pdfmetrics.registerFont(TTFont(FONT, str(dejavu())))
    return FONT


class _Page:
    """Draws marks on a reportlab canvas whose unit is one millimetre."""

    def __init__(self, canvas: Any) -> None:
        self.canvas = canvas

    def draw(self, marks: Iterable[Mark]) -> None:
        for _, held in by_layer(marks):
            for mark in held:
                self._mark(mark)

    def _mark(self, mark: Mark) -> None:
        if isinstance(mark, Line):
            dashes = fitted(pen(mark.style).pattern, length_mm(mark.points, mark.closed), mark.closed)
            self._stroke([mark.points], mark.style, dashes, mark.closed)
        elif isinstance(mark, Arc):
            self._arc(mark)
        elif isinstance(mark, Arrow):
            shaft, head = arrow_parts(mark)
            self._stroke([shaft], mark.style, fitted(pen(mark.style).pattern, length_mm(shaft)))
            if head:
                self._fill(head, pen(mark.style).colour)
        elif isinstance(mark, Shape):
            self._fill(mark.points, PAPER if mark.fill == "paper" else BLACK)
        elif isinstance(mark, Hatch):
            self._stroke(hatch_strokes(mark), "thin")
        else:
            self._text(mark)

    def _path(self, lines: Iterable[Sequence[complex]], closed: bool = False) -> Any:
        path = self.canvas.beginPath()
        for first, *rest in lines:
            path.moveTo(first.real, first.imag)
            for z in rest:
                path.lineTo(z.real, z.imag)
            if closed:
                path.close()
        return path

    def _set(self, width: float, colour: str, dashes: Sequence[float] = ()) -> None:
        self.canvas.setLineWidth(width)
        self.canvas.setStrokeColor(colour)
        self.canvas.setDash(list(dashes))
        self.canvas.setLineCap(_BUTT if dashes else _ROUND)

    def _stroke(
        self, lines: Iterable[Sequence[complex]], style: str, dashes: Sequence[float] = (), closed: bool = False
    ) -> None:
        self._set(pen(style).width, pen(style).colour, dashes)
        self.canvas.drawPath(self._path(lines, closed), stroke=1, fill=0)

    def _fill(self, points: Sequence[complex], colour: str) -> None:
        self.canvas.setFillColor(colour)
        self.canvas.drawPath(self._path([points], closed=True), stroke=0, fill=1)

    def _arc(self, arc: Arc) -> None:
        self._set(pen(arc.style).width, pen(arc.style).colour, arc_dashes(arc))
        self.canvas.setFillColor(PAPER if arc.fill == "paper" else BLACK)
        path, c, r = self.canvas.beginPath(), arc.centre, arc.radius
        if is_circle(arc):
            path.circle(c.real, c.imag, r)
        else:
            corners = (c.real - r, c.imag - r, c.real + r, c.imag + r)
            path.arc(*corners, arc.start_deg, arc.end_deg - arc.start_deg)
        self.canvas.drawPath(path, stroke=1, fill=int(arc.fill != "none"))

    def _text(self, text: Text) -> None:
        laid = layout(text)
        for width, lines in laid.by_pen():
            self._set(width, BLACK)
            self.canvas.setFillColor(BLACK)
            self.canvas.drawPath(self._path(lines), stroke=not laid.filled, fill=laid.filled, fillMode=_NON_ZERO)
        if laid.plain:
            self._words(laid.plain, laid, text.height)

    def _words(self, words: str, laid: LaidText, height: float) -> None:
        """The whole text invisibly on its base line, as one piece: indices are read where they belong."""
        size, turn = height / CAPITALS, cmath.rect(1, math.radians(laid.turn_deg))
        run = self.canvas.beginText()
        run.setTextRenderMode(_INVISIBLE)
        run.setFont(_font(), size)
        run.setHorizScale(100 * laid.width / self.canvas.stringWidth(words, FONT, size))
        run.setTextTransform(turn.real, turn.imag, -turn.imag, turn.real, laid.origin.real, laid.origin.imag)
        run.textOut(words)
        self.canvas.drawText(run)
