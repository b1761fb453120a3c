"""Marks -> PDF by reportlab, in true size; text as pen strokes with invisible real text for searching.

A PNG is the page of the PDF as a picture, with its physical size in the file.  The same marks give the same bytes.
"""

from __future__ import annotations

import cmath
import io
import math
import re
import struct
import zlib
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from planes.scene.carried import PNG, chunk
from render.files.tags import Tags
from render.files.writer import Lines, Writer, dashes_of
from render.paper.ink import arc_dashes, by_layer, checked, is_circle
from render.paper.marks import Arc, Mark, Text
from render.paper.outlines import dejavu
from render.paper.photo import Photo
from render.paper.style import BLACK, CAPITALS, PAPER, pen
from render.paper.typeset import LaidText, layout

if TYPE_CHECKING:
    from reportlab.pdfgen.canvas import Canvas
    from reportlab.pdfgen.pathobject import PDFPathObject

POINTS_PER_MM = 72 / 25.4
FONT = "DejaVuSans"
PACKED = 3  # of 9: a fifth more bytes than 6 in half the time
FROM_ABOVE = 2  # filter of a PNG's row
COLOURED = re.compile(rb"/Subtype /Image|^(\S+) (?!\1 \1 )\S+ \S+ (?:rg|RG)$", re.M)
"""A picture, or a colour of a line or a fill, in a page that is not compressed."""
_INVISIBLE, _ROUND, _BUTT, _NON_ZERO = 3, 1, 0, 1

PdfPage = tuple[Iterable[Mark], tuple[float, float]]


def write(
    marks: Iterable[Mark], size_mm: tuple[float, float], title: str, *, lang: str = "ru", under: Photo | None = None
) -> bytes:
    """The sheet as a PDF file with one page, with a picture ``under`` it."""
    return write_pages([(marks, size_mm)], title, lang, under)


def write_pages(
    pages: Iterable[PdfPage], title: str, lang: str = "ru", under: Photo | None = None, words: bool = True
) -> bytes:
    """Several sheets (marks and width × height in mm) as one PDF file; without ``words``, with their strokes alone."""
    from reportlab.lib.utils import ImageReader
    from reportlab.pdfgen.canvas import Canvas

    font = registered(FONT, dejavu()) if words else None
    canvas = Canvas("", invariant=1, pageCompression=int(words), lang=lang, initialFontName=font)
    canvas.setTitle(title)
    canvas.setSubject(title)
    canvas.setCreator("planes")
    canvas.setAuthor("")
    tags = Tags(canvas, title) if words else None
    for marks, size_mm in pages:
        held = checked(marks, size_mm)
        canvas.setPageSize(tuple(POINTS_PER_MM * side for side in size_mm))
        canvas.scale(POINTS_PER_MM, POINTS_PER_MM)
        if tags:
            tags.draw(False)
        if under:
            x0, y0, x1, y1 = under.box
            canvas.drawImage(ImageReader(io.BytesIO(under.data)), x0, y0, x1 - x0, y1 - y0)
        draw_marks(canvas, held, words, tags)
        if tags:
            tags.end_page()
        else:
            canvas.showPage()
    if tags:
        tags.end()
    made: bytes = canvas.getpdfdata()
    return made


def draw_marks(canvas: Canvas, marks: Iterable[Mark], words: bool = True, tags: Tags | None = None) -> None:
    """Marks on a canvas with the unit of one millimetre, with their words for text search, and their ``tags``."""
    canvas.setLineJoin(_ROUND)
    page = _Page(canvas, words, tags)
    for _, held in by_layer(marks):
        page.all(held)


def registered(name: str, file: Path) -> str:
    """The name of an embedded font, registered on first use."""
    from reportlab.pdfbase import pdfmetrics
    from reportlab.pdfbase.ttfonts import TTFont

    if name not in pdfmetrics.getRegisteredFontNames():
        pdfmetrics.registerFont(TTFont(name, str(file)))
    return name


class _Page(Writer):
    """Draws marks on a reportlab canvas with the unit of one millimetre."""

    def __init__(self, canvas: Canvas, words: bool, tags: Tags | None) -> None:
        self.canvas, self.words, self.tags = canvas, words, tags

    def mark(self, mark: Mark) -> None:
        """One mark, as a text or a part of the figure."""
        if self.tags:
            self.tags.draw(isinstance(mark, Text))
        super().mark(mark)

    def _path(self, lines: Iterable[Sequence[complex]], closed: bool = False) -> PDFPathObject:
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

    def strokes(self, lines: Lines, style: str, layer: str, closed: bool = False) -> None:
        """Polylines as one path."""
        self._set(pen(style).width, pen(style).colour, dashes_of(lines, style, closed))
        self.canvas.drawPath(self._path(lines, closed), stroke=1, fill=0)

    def filled(self, points: Sequence[complex], colour: str, layer: str) -> None:
        """A filled polygon."""
        self.canvas.setFillColor(colour)
        self.canvas.drawPath(self._path([points], closed=True), stroke=0, fill=1)

    def arc(self, arc: Arc) -> None:
        """A circle, an arc, or a filled disc."""
        self._set(pen(arc.style).width, pen(arc.style).colour, arc_dashes(arc))
        self.canvas.setFillColor(PAPER if arc.fill == "paper" else BLACK)
        path, c, r = self.canvas.beginPath(), arc.centre, arc.radius
        if is_circle(arc):
            path.circle(c.real, c.imag, r)
        else:
            corners = (c.real - r, c.imag - r, c.real + r, c.imag + r)
            path.arc(*corners, arc.start_deg, arc.end_deg - arc.start_deg)
        self.canvas.drawPath(path, stroke=1, fill=int(arc.fill != "none"))

    def text(self, text: Text) -> None:
        """Strokes, with the text itself over them, invisible."""
        laid = layout(text)
        for width, lines in laid.by_pen():
            self._set(width, BLACK)
            self.canvas.setFillColor(BLACK)
            self.canvas.drawPath(self._path(lines), stroke=not laid.filled, fill=laid.filled, fillMode=_NON_ZERO)
        if laid.plain and self.words:
            self._words(laid.plain, laid, text.height)

    def _words(self, words: str, laid: LaidText, height: float) -> None:
        """The whole text, invisible, on its base line, in one piece, so that indices are read in order."""
        size, turn = height / CAPITALS, cmath.rect(1, math.radians(laid.turn_deg))
        run = self.canvas.beginText()
        run.setTextRenderMode(_INVISIBLE)
        run.setFont(registered(FONT, dejavu()), size)
        run.setHorizScale(100 * laid.width / self.canvas.stringWidth(words, FONT, size))
        run.setTextTransform(turn.real, turn.imag, -turn.imag, turn.real, laid.origin.real, laid.origin.imag)
        run.textOut(words)
        self.canvas.drawText(run)


def write_png(
    marks: Iterable[Mark], size_mm: tuple[float, float], title: str, *, dpi: float = 200, under: Photo | None = None
) -> bytes:
    """The sheet as a PNG file at ``dpi`` pixels per inch, with a picture ``under`` it."""
    return png_of(write_pages([(marks, size_mm)], title, under=under, words=False), dpi)


def png_of(data: bytes, dpi: float) -> bytes:
    """The first page of an uncompressed PDF file as a PNG file: in grey if it has no colour, a third of the data.

    Written here, each row as its difference from the row above: as small as by Pillow in a third of the time.
    """
    import numpy as np
    import pypdfium2

    grey = not COLOURED.search(data)
    with pypdfium2.PdfDocument(data) as document:
        page = document[0].render(scale=dpi / 72, grayscale=grey, rev_byteorder=True).to_numpy()
    height, width = page.shape[:2]
    rows = np.diff(page, axis=0, prepend=np.uint8(0)).reshape(height, -1)
    head = struct.pack(">2I5B", width, height, 8, 0 if grey else 2, 0, 0, 0)
    size = struct.pack(">2IB", *[round(dpi / 0.0254)] * 2, 1)
    pixels = zlib.compress(np.insert(rows, 0, FROM_ABOVE, axis=1), PACKED)
    return PNG + chunk(b"IHDR", head) + chunk(b"pHYs", size) + chunk(b"IDAT", pixels) + chunk(b"IEND", b"")
