"""A document as a PDF by reportlab: A4, embedded fonts, vector figures, numbered pages, headings in the outline."""

from __future__ import annotations

import io
import json
import re
from collections.abc import Sequence
from functools import cache
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING

from reportlab.lib.styles import ParagraphStyle
from reportlab.lib.units import mm
from reportlab.pdfbase import pdfmetrics
from reportlab.platypus import Flowable, PageBreak, SimpleDocTemplate, Spacer
from reportlab.platypus import Paragraph as Words
from reportlab.platypus import Table as Grid
from reportlab.platypus.tableofcontents import TableOfContents

from planes.solving.document import Block, Cover, DocumentTable, Figure, Formula, Heading, Paragraph
from planes.words.naming import Naming
from planes.words.records import Json
from render.files.pdf import register_font
from render.paper.outlines import dejavu_file
from render.report.figures import DocumentSetter, Shown
from render.report.floats import Filled, PagePiece, float_figures, join_kept_together
from render.report.html import is_number
from render.report.math_line import MathLine, break_formula

if TYPE_CHECKING:
    from reportlab.pdfgen.canvas import Canvas

LEFT_MARGIN_PT = 25 * mm
RIGHT_MARGIN_PT = 10 * mm
TOP_BOTTOM_MARGIN_PT = 20 * mm
PAGE_SIZE_PT = (210 * mm, 297 * mm)
TEXT_WIDTH_PT = PAGE_SIZE_PT[0] - LEFT_MARGIN_PT - RIGHT_MARGIN_PT
MOST_FIGURE_HEIGHT_PT = 170 * mm  # of a figure
FRAME_PADDING_PT = 12.0  # on both sides together, of reportlab's frame
FILE_OF_FONT = {"Note": "DejaVuSerif.ttf", "NoteBold": "DejaVuSerif-Bold.ttf", "NoteItalic": "DejaVuSerif-Italic.ttf"}
LETTER_SIZE_PT = 10.5
PDF_STYLES: Json = json.loads(Path(__file__).with_name("pdf_styles.json").read_text("utf-8"))
"""Styles of paragraphs, each with the one it begins as, and of tables."""
MOST_ROOMY_LETTERS = 85  # letters across a table; one with more has smaller type


@cache
def paragraph_styles() -> dict[str, ParagraphStyle]:
    """The styles of paragraphs by name."""
    made: dict[str, ParagraphStyle] = {}
    for name, (parent, looks) in PDF_STYLES["paragraphs"].items():
        made[name] = ParagraphStyle(name, made.get(parent), **looks)
    return made


def write(blocks: Sequence[Block], naming: Naming) -> bytes:
    """The PDF; the same document gives the same bytes."""
    for name, file in FILE_OF_FONT.items():  # registered on first use; they come with matplotlib
        register_font(name, dejavu_file().parent / file)
    pdfmetrics.registerFontFamily("Note", normal="Note", bold="NoteBold", italic="NoteItalic", boldItalic="NoteBold")
    data = io.BytesIO()
    title = next((b.text for b in blocks if isinstance(b, Cover | Heading)), "")
    margins = {
        "leftMargin": LEFT_MARGIN_PT,
        "rightMargin": RIGHT_MARGIN_PT,
        "topMargin": TOP_BOTTOM_MARGIN_PT,
        "bottomMargin": TOP_BOTTOM_MARGIN_PT,
    }
    metadata = {"title": title, "author": "", "creator": "planes", "lang": naming.lang}
    paper = _Paper(data, pagesize=PAGE_SIZE_PT, invariant=1, initialFontName="Note", **margins, **metadata)
    setter = _Setter(naming)
    first = [part for block in blocks if isinstance(block, Cover) for part in setter.block_flowables(block)]
    rest = (block for block in blocks if not isinstance(block, Cover))
    pieces = join_kept_together(
        PagePiece(setter.block_flowables(b), isinstance(b, Figure) and bool(b.caption)) for b in rest
    )
    story = float_figures(
        pieces, Filled(TEXT_WIDTH_PT - FRAME_PADDING_PT, PAGE_SIZE_PT[1] - 2 * TOP_BOTTOM_MARGIN_PT - FRAME_PADDING_PT)
    )
    paper.multiBuild(
        first + story, onFirstPage=_leave_title_page_blank if first else _draw_page_number, onLaterPages=_draw_page_head
    )
    return data.getvalue()


def _leave_title_page_blank(*_: object) -> None:
    """A title page has no number."""


def _draw_page_number(canvas: Canvas, paper: SimpleDocTemplate) -> None:
    canvas.setFont("Note", 10)
    canvas.drawCentredString(PAGE_SIZE_PT[0] / 2, 10 * mm, str(paper.page))


def _draw_page_head(canvas: Canvas, paper: SimpleDocTemplate) -> None:
    """The page number, and the document's title."""
    _draw_page_number(canvas, paper)
    canvas.setFont("Note", 8)
    canvas.setFillColor("#555555")
    canvas.drawString(LEFT_MARGIN_PT, PAGE_SIZE_PT[1] - 13 * mm, paper.title[:100])


class _Paper(SimpleDocTemplate):  # type: ignore[misc]
    def afterFlowable(self, flowable: Flowable) -> None:
        """Headings appear in the PDF's outline."""
        style = getattr(getattr(flowable, "style", None), "name", "")
        if style in ("h1", "h2"):
            key = f"{style}-{self.seq.nextf(style)}"
            self.canv.bookmarkPage(key)
            text = flowable.getPlainText()
            self.canv.addOutlineEntry(text, key, level=int(style[1]) - 1, closed=style == "h1")
            self.notify("TOCEntry", (int(style[1]) - 1, text, self.page, key))


class _Setter(DocumentSetter):
    """Turns blocks into reportlab flowables."""

    def block_flowables(self, block: Block) -> list[Flowable]:
        """The flowables of a block."""
        match block:
            case Cover():
                return self.cover_flowables(block)
            case Heading(text, level):
                return [Words(self.text(text) if level else escape(text), paragraph_styles()[f"h{level}"])]
            case Paragraph():
                return [self.paragraph_flowable(block)]
            case Formula(parts, number):
                *lines, last = break_formula(parts, LETTER_SIZE_PT - 0.5, TEXT_WIDTH_PT - 14 * mm)
                return [*(_Picture(line, left=True, keep=True) for line in lines), _Picture(last, number, left=True)]
            case DocumentTable(caption, rows):
                return [Words(self.text(caption), paragraph_styles()["above"]), self.table_flowable(rows)]
            case Figure():
                pictures, caption = self.shown(block)
                beneath = [Words(self.text(caption), paragraph_styles()["small"])] if caption and pictures else []
                return [*(_Picture(p, keep=bool(beneath)) for p in pictures), *beneath]

    def cover_flowables(self, cover: Cover) -> list[Flowable]:
        """The title page, and the contents on another."""
        looks = paragraph_styles()
        contents = TableOfContents(levelStyles=[looks["contents"]] * 2)
        contents.dotsMinLevel = 0
        return [
            *(Words(escape(line), looks["middle"]) for line in cover.above),
            Spacer(0, 70 * mm),
            Words(escape(cover.kind), looks["title"]),
            Words(escape(cover.of), looks["middle"]),
            Spacer(0, 50 * mm),
            *(Words(escape(line), looks["right"]) for line in cover.people),
            Spacer(0, 50 * mm),
            Words(escape(cover.foot), looks["middle"]),
            PageBreak(),
            Words(escape(cover.contents), looks["contents head"]),
            contents,
            PageBreak(),
        ]

    def paragraph_flowable(self, block: Paragraph) -> Flowable:
        """A paragraph in its style."""
        count = f"{block.number}. " if block.number else ""
        style = "leading" if block.text[-1:] == ":" else "plain"
        style = "why" if block.why else "mistake" if block.mistake else style
        return Words(count + self.text(block.text, block.plan), paragraph_styles()[style])

    def table_flowable(self, rows: Sequence[Sequence[str]]) -> Flowable:
        """A grid with columns as wide as their contents, in smaller type if there is much."""
        longest = [max(len(re.sub(r"[_^{}⟨⟩]", "", cell)) for cell in column) + 2 for column in zip(*rows, strict=True)]
        size = 9.5 if sum(longest) <= MOST_ROOMY_LETTERS else 7.5
        face = {"fontName": "Note", "fontSize": size, "leading": 1.27 * size}
        styles = [ParagraphStyle("cell", alignment=a, **face) for a in (0, 1, 2)]
        cells = [[Words(self.text(c), styles[1]) for c in rows[0]]]
        cells += [[Words(self.text(c), styles[2 if is_number(c) else 0]) for c in row] for row in rows[1:]]
        widths = [TEXT_WIDTH_PT * n / max(sum(longest), 60) for n in longest]
        return Grid(cells, widths, style=PDF_STYLES["grid"], repeatRows=1, hAlign="LEFT", spaceAfter=6)


class _Picture(Flowable):  # type: ignore[misc]
    """A picture in the middle of the column or at its left, reduced if necessary, with its number on the right."""

    def __init__(self, picture: Shown | MathLine, number: str = "", left: bool = False, keep: bool = False) -> None:
        super().__init__()
        self.keepWithNext = int(keep)
        self.picture = picture
        self.number = number
        self.scale = min(
            1.0, (TEXT_WIDTH_PT - (14 * mm if left else 0)) / picture.width, MOST_FIGURE_HEIGHT_PT / picture.height
        )
        self.left = 4.0 if left else (TEXT_WIDTH_PT - picture.width * self.scale) / 2

    def wrap(self, *_: float) -> tuple[float, float]:
        """Its size."""
        return TEXT_WIDTH_PT, self.picture.height * self.scale + 4

    def draw(self) -> None:
        """Draw it."""
        if self.number:
            self.canv.setFont("Note", 9)
            self.canv.drawRightString(TEXT_WIDTH_PT, self.picture.height * self.scale / 2 - 2, f"({self.number})")
        self.canv.translate(self.left, 2)
        self.canv.scale(self.scale, self.scale)
        self.picture.draw(self.canv)
