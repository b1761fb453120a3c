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

from planes.scene.carried import PNG_SIGNATURE, png_chunk
from render.files.tags import Tags
from render.files.writer import Lines, Writer, fitted_dashes
from render.paper.ink import arc_dashes, group_by_layer, is_circle, require_finite_marks
from render.paper.marks import Arc, Mark, Size, Text
from render.paper.outlines import dejavu_file
from render.paper.photo import Photo
from render.paper.style import BLACK_COLOUR, CAPITALS_HEIGHT_RATIO, PAPER_COLOUR, pen_of_style
from render.paper.typeset import LaidText, lay_out_text

if TYPE_CHECKING:
    from reportlab.pdfgen.canvas import Canvas
    from reportlab.pdfgen.pathobject import PDFPathObject

POINTS_PER_MM = 72 / 25.4
FONT_NAME = "DejaVuSans"
COMPRESSION_LEVEL = 3  # of 9: a fifth more bytes than 6 in half the time
PNG_UP_FILTER = 2  # filter of a PNG's row
COLOURED_PAGE_PATTERN = re.compile(rb"/Subtype /Image|^(\S+) (?!\1 \1 )\S+ \S+ (?:rg|RG)$", re.M)
"""A picture, or a colour of a line or a fill, in a page that is not compressed."""
_INVISIBLE_TEXT_MODE = 3
_ROUND_CAP_OR_JOIN = 1
_BUTT_CAP = 0
_NON_ZERO_FILL = 1

PdfPage = tuple[Iterable[Mark], Size]


def write(marks: Iterable[Mark], size_mm: Size, title: str, *, lang: str = "ru", under: Photo | None = None) -> bytes:
    """The sheet as a PDF file with one page, with a picture ``under`` it."""
    return write_pages([(marks, size_mm)], title, lang, under)


def write_pages(
    pages: Iterable[PdfPage], title: str, lang: str = "ru", under: Photo | None = None, words: bool = True
) -> bytes:
    """Several sheets (marks and width × height in mm) as one PDF file; without ``words``, with their strokes alone."""
    from reportlab.lib.utils import ImageReader
    from reportlab.pdfgen.canvas import Canvas

    font = register_font(FONT_NAME, dejavu_file()) if words else None
    canvas = Canvas("", invariant=1, pageCompression=int(words), lang=lang, initialFontName=font)
    canvas.setTitle(title)
    canvas.setSubject(title)
    canvas.setCreator("planes")
    canvas.setAuthor("")
    tags = Tags(canvas, title) if words else None
    for marks, size_mm in pages:
        held = require_finite_marks(marks, size_mm)
        canvas.setPageSize(tuple(POINTS_PER_MM * side for side in size_mm))
        canvas.scale(POINTS_PER_MM, POINTS_PER_MM)
        if tags:
            tags.begin_piece(False)
        if under:
            x0, y0, x1, y1 = under.box
            canvas.drawImage(ImageReader(io.BytesIO(under.data)), x0, y0, x1 - x0, y1 - y0)
        draw_marks(canvas, held, words, tags)
        if tags:
            tags.end_page()
        else:
            canvas.showPage()
    if tags:
        tags.end_document()
    made: bytes = canvas.getpdfdata()
    return made


def draw_marks(canvas: Canvas, marks: Iterable[Mark], words: bool = True, tags: Tags | None = None) -> None:
    """Marks on a canvas with the unit of one millimetre, with their words for text search, and their ``tags``."""
    canvas.setLineJoin(_ROUND_CAP_OR_JOIN)
    page = _Page(canvas, words, tags)
    for _, held in group_by_layer(marks):
        page.write_marks(held)


def register_font(name: str, file: Path) -> str:
    """The name of an embedded font, registered on first use."""
    from reportlab.pdfbase import pdfmetrics
    from reportlab.pdfbase.ttfonts import TTFont

    if name not in pdfmetrics.getRegisteredFontNames():
        pdfmetrics.registerFont(TTFont(name, str(file)))
    return name


class _Page(Writer):
    """Draws marks on a reportlab canvas with the unit of one millimetre."""

    def __init__(self, canvas: Canvas, words: bool, tags: Tags | None) -> None:
        self.canvas = canvas
        self.words = words
        self.tags = tags

    def mark(self, mark: Mark) -> None:
        """One mark, as a text or a part of the figure."""
        if self.tags:
            self.tags.begin_piece(isinstance(mark, Text))
        super().mark(mark)

    def _make_path(self, lines: Iterable[Sequence[complex]], closed: bool = False) -> PDFPathObject:
        path = self.canvas.beginPath()
        for first, *rest in lines:
            path.moveTo(first.real, first.imag)
            for z in rest:
                path.lineTo(z.real, z.imag)
            if closed:
                path.close()
        return path

    def _set_pen(self, width: float, colour: str, dashes: Sequence[float] = ()) -> None:
        self.canvas.setLineWidth(width)
        self.canvas.setStrokeColor(colour)
        self.canvas.setDash(list(dashes))
        self.canvas.setLineCap(_BUTT_CAP if dashes else _ROUND_CAP_OR_JOIN)

    def write_strokes(self, lines: Lines, style: str, layer: str, closed: bool = False) -> None:
        """Polylines as one path."""
        self._set_pen(pen_of_style(style).width, pen_of_style(style).colour, fitted_dashes(lines, style, closed))
        self.canvas.drawPath(self._make_path(lines, closed), stroke=1, fill=0)

    def write_filled_polygon(self, points: Sequence[complex], colour: str, layer: str) -> None:
        """A filled polygon."""
        self.canvas.setFillColor(colour)
        self.canvas.drawPath(self._make_path([points], closed=True), stroke=0, fill=1)

    def write_arc(self, arc: Arc) -> None:
        """A circle, an arc, or a filled disc."""
        self._set_pen(pen_of_style(arc.style).width, pen_of_style(arc.style).colour, arc_dashes(arc))
        self.canvas.setFillColor(PAPER_COLOUR if arc.fill == "paper" else BLACK_COLOUR)
        path = self.canvas.beginPath()
        c = arc.centre
        r = arc.radius
        if is_circle(arc):
            path.circle(c.real, c.imag, r)
        else:
            corners = (c.real - r, c.imag - r, c.real + r, c.imag + r)
            path.arc(*corners, arc.start_deg, arc.end_deg - arc.start_deg)
        self.canvas.drawPath(path, stroke=1, fill=int(arc.fill != "none"))

    def draw_text(self, text: Text) -> None:
        """Strokes, with the text itself over them, invisible."""
        laid = lay_out_text(text)
        for width, lines in laid.strokes_by_pen_width():
            self._set_pen(width, BLACK_COLOUR)
            self.canvas.setFillColor(BLACK_COLOUR)
            self.canvas.drawPath(
                self._make_path(lines), stroke=not laid.filled, fill=laid.filled, fillMode=_NON_ZERO_FILL
            )
        if laid.plain_text and self.words:
            self._write_invisible_words(laid.plain_text, laid, text.height)

    def _write_invisible_words(self, words: str, laid: LaidText, height: float) -> None:
        """The whole text, invisible, on its base line, in one piece, so that indices are read in order."""
        size = height / CAPITALS_HEIGHT_RATIO
        turn = cmath.rect(1, math.radians(laid.turn_deg))
        run = self.canvas.beginText()
        run.setTextRenderMode(_INVISIBLE_TEXT_MODE)
        run.setFont(register_font(FONT_NAME, dejavu_file()), size)
        run.setHorizScale(100 * laid.width / self.canvas.stringWidth(words, FONT_NAME, size))
        run.setTextTransform(turn.real, turn.imag, -turn.imag, turn.real, laid.origin.real, laid.origin.imag)
        run.textOut(words)
        self.canvas.drawText(run)


def write_png(
    marks: Iterable[Mark], size_mm: Size, title: str, *, dpi: float = 200, under: Photo | None = None
) -> bytes:
    """The sheet as a PNG file at ``dpi`` pixels per inch, with a picture ``under`` it."""
    return png_of_pdf(write_pages([(marks, size_mm)], title, under=under, words=False), dpi)


def png_of_pdf(data: bytes, dpi: float) -> bytes:
    """The first page of an uncompressed PDF file as a PNG file: in grey if it has no colour, a third of the data.

    Written here, each row as its difference from the row above: as small as by Pillow in a third of the time.
    """
    import numpy as np
    import pypdfium2

    grey = not COLOURED_PAGE_PATTERN.search(data)
    with pypdfium2.PdfDocument(data) as document:
        page = document[0].render(scale=dpi / 72, grayscale=grey, rev_byteorder=True).to_numpy()
    height, width = page.shape[:2]
    rows = np.diff(page, axis=0, prepend=np.uint8(0)).reshape(height, -1)
    head = struct.pack(">2I5B", width, height, 8, 0 if grey else 2, 0, 0, 0)
    size = struct.pack(">2IB", *[round(dpi / 0.0254)] * 2, 1)
    pixels = zlib.compress(np.insert(rows, 0, PNG_UP_FILTER, axis=1), COMPRESSION_LEVEL)
    return (
        PNG_SIGNATURE
        + png_chunk(b"IHDR", head)
        + png_chunk(b"pHYs", size)
        + png_chunk(b"IDAT", pixels)
        + png_chunk(b"IEND", b"")
    )
