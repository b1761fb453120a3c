"""The report as a PDF by reportlab: A4, embedded DejaVu Sans, vector figures, numbered pages, a list of contents."""

from __future__ import annotations

import io
import re
from typing import Any

from reportlab.lib.colors import HexColor
from reportlab.lib.enums import TA_CENTER
from reportlab.lib.pagesizes import A4
from reportlab.lib.styles import ParagraphStyle
from reportlab.lib.units import mm
from reportlab.pdfbase import pdfmetrics
from reportlab.pdfbase.ttfonts import TTFont
from reportlab.platypus import BaseDocTemplate, Flowable, Frame, KeepTogether, PageTemplate, Spacer, Table, TableStyle
from reportlab.platypus import Paragraph as Words

from planes.crank_slider.pages import (
    Block,
    Chart,
    Document,
    Drawn,
    Formula,
    Heading,
    Mistake,
    Paragraph,
    Sketch,
    TableBlock,
)
from planes.words import Lang
from render.charts.strokes import Picture, escaped
from render.files.pdf import POINTS_PER_MM, draw_marks
from render.paper.outlines import dejavu
from render.report.figures import Figure, shown
from render.report.html import is_number
from render.report.mathematics import formula

FONT, BOLD = "DejaVuSans", "DejaVuSans-Bold"
WIDTH = A4[0] - 40 * mm
BODY = ParagraphStyle("body", fontName=FONT, fontSize=9.5, leading=13.5, spaceBefore=5, spaceAfter=5)
LEADING = ParagraphStyle("leading", parent=BODY, keepWithNext=1)
TITLE = ParagraphStyle("title", parent=BODY, fontName=BOLD, fontSize=16, leading=20, spaceAfter=10)
HEADS = {
    1: ParagraphStyle(
        "h1", parent=BODY, fontName=BOLD, fontSize=13, leading=17, spaceBefore=12, spaceAfter=6, keepWithNext=1
    ),
    2: ParagraphStyle(
        "h2", parent=BODY, fontName=BOLD, fontSize=10.5, leading=14, spaceBefore=8, spaceAfter=4, keepWithNext=1
    ),
}
MISTAKE = ParagraphStyle("mistake", parent=BODY, borderColor=HexColor("#aa3333"), borderWidth=0.8, borderPadding=5,
                         backColor=HexColor("#fdf4f2"), spaceBefore=12, spaceAfter=14,
                         leftIndent=6, rightIndent=6)  # fmt: skip
CAPTION = ParagraphStyle("caption", parent=BODY, fontSize=8.5, leading=11, alignment=TA_CENTER, spaceAfter=8)
ABOVE = ParagraphStyle("above", parent=BODY, fontSize=8.5, leading=11, spaceBefore=6, spaceAfter=2, keepWithNext=1)


def write(document: Document) -> bytes:
    """The PDF; the same document gives the same bytes."""
    for name in (FONT, BOLD):
        if name not in pdfmetrics.getRegisteredFontNames():
            pdfmetrics.registerFont(TTFont(name, str(dejavu().with_name(f"{name}.ttf"))))
    pdfmetrics.registerFontFamily(FONT, normal=FONT, bold=BOLD, italic=FONT, boldItalic=BOLD)
    data = io.BytesIO()
    made = _Template(data, document)
    story: list[Any] = [Words(escaped(document.title), TITLE)]
    for block in document.blocks:
        story += _block(block, document.lang)
    made.build(story)
    return data.getvalue()


def rich(text: str) -> str:
    """_{…} and ^{…} as lower and upper indices."""
    text = re.sub(r"_\{([^}]*)\}", r'<sub rise="2" size="6.5">\1</sub>', escaped(text))
    return re.sub(r"\^\{([^}]*)\}", r'<super rise="3.5" size="6.5">\1</super>', text)


class _Template(BaseDocTemplate):  # type: ignore[misc]
    def __init__(self, data: io.BytesIO, document: Document) -> None:
        super().__init__(
            data, pagesize=A4, leftMargin=20 * mm, rightMargin=20 * mm, topMargin=18 * mm, bottomMargin=18 * mm,
            title=document.title, author="", creator="planes", invariant=1, lang=document.lang, initialFontName=FONT,
        )  # fmt: skip
        self.heading = document.title
        frame = Frame(self.leftMargin, self.bottomMargin, self.width, self.height, 0, 0, 0, 0)
        self.addPageTemplates([PageTemplate("page", [frame], onPage=self.foot)])

    def foot(self, canvas: Any, _: Any) -> None:
        """The number of the page and what it belongs to."""
        canvas.setFont(FONT, 8)
        canvas.setFillColor(HexColor("#555555"))
        canvas.drawString(20 * mm, 10 * mm, self.heading[:100])
        canvas.drawRightString(A4[0] - 20 * mm, 10 * mm, str(canvas.getPageNumber()))

    def afterFlowable(self, flowable: Any) -> None:
        """Headings stand in the PDF's outline."""
        style = getattr(getattr(flowable, "style", None), "name", "")
        if style in ("h1", "h2"):
            text = flowable.getPlainText()
            key = f"{style}-{self.seq.nextf(style)}"
            self.canv.bookmarkPage(key)
            self.canv.addOutlineEntry(text, key, level=int(style[1]) - 1, closed=style == "h1")


def _block(block: Block, lang: Lang) -> list[Any]:
    match block:
        case Heading(text, level):
            return [Words(rich(text), HEADS[level])]
        case Paragraph(text):
            return [Words(rich(text), LEADING if text.endswith(":") else BODY)]
        case Mistake(text):
            return [KeepTogether([Words(rich(text), MISTAKE)])]
        case Formula(tex, number):
            return [_Line(formula(tex, 9.5), number)]
        case TableBlock():
            return _table(block)
        case Chart() | Drawn() | Sketch():
            pictures, title = shown(block, lang)
            drawn = (_Drawing(p, True) if isinstance(p, Picture) else _Marks(p) for p in pictures)
            return [*drawn, Words(rich(title), CAPTION)]


def _table(block: TableBlock) -> list[Any]:
    cell = ParagraphStyle("cell", parent=BODY, fontSize=7.5, leading=9.5, spaceAfter=0)
    right = ParagraphStyle("right", parent=cell, alignment=2)
    head = ParagraphStyle("head", parent=cell, alignment=TA_CENTER)
    longest = [max(_length(row[k]) for row in (block.head, *block.rows)) + 2 for k in range(len(block.head))]
    total = max(sum(longest), 60)
    widths = [WIDTH * n / total for n in longest]
    rows = [[Words(rich(c), head) for c in block.head]]
    rows += [[Words(rich(c), right if is_number(c) else cell) for c in row] for row in block.rows]
    table = Table(rows, widths, repeatRows=1, hAlign="LEFT")
    table.setStyle(TableStyle([
        ("GRID", (0, 0), (-1, -1), 0.4, HexColor("#999999")), ("BACKGROUND", (0, 0), (-1, 0), HexColor("#f2f2f2")),
        ("TOPPADDING", (0, 0), (-1, -1), 1.5), ("BOTTOMPADDING", (0, 0), (-1, -1), 2),
        ("VALIGN", (0, 0), (-1, -1), "MIDDLE"),
        ("LEFTPADDING", (0, 0), (-1, -1), 3), ("RIGHTPADDING", (0, 0), (-1, -1), 3),
    ]))  # fmt: skip
    return [Words(rich(block.title), ABOVE), table, Spacer(1, 6)]


def _length(text: str) -> int:
    return len(re.sub(r"[_^{}]", "", text))


class _Drawing(Flowable):  # type: ignore[misc]
    """A picture of strokes in the middle of the column, made smaller if it is wider."""

    def __init__(self, picture: Picture, with_next: bool = False) -> None:
        super().__init__()
        self.picture = picture
        self.keepWithNext = int(with_next)
        self.scale = min(1.0, WIDTH / picture.width)

    def wrap(self, *_: float) -> tuple[float, float]:
        """Its size."""
        return WIDTH, self.picture.height * self.scale + 4

    def draw(self) -> None:
        """Draw it."""
        self.canv.translate((WIDTH - self.picture.width * self.scale) / 2, 2)
        self.canv.scale(self.scale, self.scale)
        self.picture.draw(self.canv)


class _Line(_Drawing):
    """A formula from the left, its number on the right."""

    def __init__(self, picture: Picture, number: str) -> None:
        super().__init__(picture)
        self.number = number
        self.scale = min(1.0, (WIDTH - 14 * mm) / picture.width)

    def draw(self) -> None:
        """Draw both."""
        if self.number:
            self.canv.setFont(FONT, 9)
            self.canv.drawRightString(WIDTH, self.picture.height * self.scale / 2 - 2, f"({self.number})")
        self.canv.translate(4, 2)
        self.canv.scale(self.scale, self.scale)
        self.picture.draw(self.canv)


class _Marks(Flowable):  # type: ignore[misc]
    """Marks in true size, smaller only where the column is narrower."""

    def __init__(self, figure: Figure) -> None:
        super().__init__()
        self.figure = figure
        self.keepWithNext = 1
        self.scale = POINTS_PER_MM * min(1.0, WIDTH / (figure.size[0] * POINTS_PER_MM), 230 / figure.size[1])

    def wrap(self, *_: float) -> tuple[float, float]:
        """Its size."""
        return WIDTH, self.figure.size[1] * self.scale + 4

    def draw(self) -> None:
        """Draw it."""
        self.canv.translate((WIDTH - self.figure.size[0] * self.scale) / 2, 2)
        self.canv.scale(self.scale, self.scale)
        draw_marks(self.canv, self.figure.marks)
