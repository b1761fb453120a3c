"""The note as a PDF of A4 pages, figures in true size where they fit."""

from __future__ import annotations

import io
from collections.abc import Mapping, Sequence
from html import escape
from typing import Any

from planes.lesson.note import Block, Figure, Heading, Prose, Table
from render.files.pdf import POINTS_PER_MM, draw_marks
from render.paper.letters import pieces
from render.paper.names import Naming
from render.paper.outlines import dejavu
from render.views import View

MARGINS_MM = (25.0, 10.0, 20.0, 20.0)  # left, right, top, bottom
WIDTH_MM = 210.0 - MARGINS_MM[0] - MARGINS_MM[1]
HEIGHT_MM = 170.0  # of a figure
FACES = {"Note": "DejaVuSerif.ttf", "NoteBold": "DejaVuSerif-Bold.ttf", "NoteItalic": "DejaVuSerif-Italic.ttf"}


def write(blocks: Sequence[Block], figures: Mapping[str, View], naming: Naming) -> bytes:
    """The whole file; the same note gives the same bytes."""
    from reportlab.platypus import SimpleDocTemplate

    data = io.BytesIO()
    left, right, top, bottom = (POINTS_PER_MM * m for m in MARGINS_MM)
    title = next((b.text for b in blocks if isinstance(b, Heading)), "")
    page = (210 * POINTS_PER_MM, 297 * POINTS_PER_MM)
    paper = SimpleDocTemplate(
        data, pagesize=page, leftMargin=left, rightMargin=right, topMargin=top, bottomMargin=bottom, title=title,
        author="", creator="planes", lang=naming.lang, invariant=1, initialFontName=_fonts(),
    )  # fmt: skip
    setter = _Setter(naming, figures)
    paper.build([f for b in blocks for f in setter.flow(b)], onFirstPage=_number, onLaterPages=_number)
    return data.getvalue()


def _fonts() -> str:
    """The faces of the note, registered on first use; they come with matplotlib."""
    from reportlab.pdfbase import pdfmetrics
    from reportlab.pdfbase.ttfonts import TTFont

    for name, file in FACES.items():
        if name not in pdfmetrics.getRegisteredFontNames():
            pdfmetrics.registerFont(TTFont(name, str(dejavu().parent / file)))
    pdfmetrics.registerFontFamily("Note", normal="Note", bold="NoteBold", italic="NoteItalic", boldItalic="NoteBold")
    return "Note"


def _number(canvas: Any, paper: Any) -> None:
    canvas.setFont("Note", 10)
    canvas.drawCentredString(paper.pagesize[0] / 2, 10 * POINTS_PER_MM, str(paper.page))


class _Setter:
    """Turns blocks into what reportlab sets."""

    def __init__(self, naming: Naming, figures: Mapping[str, View]) -> None:
        from reportlab.lib.styles import ParagraphStyle

        self.naming, self.figures = naming, figures
        one = {"fontName": "Note", "fontSize": 10.5, "leading": 15, "spaceBefore": 4, "firstLineIndent": 28}
        self.plain = ParagraphStyle("plain", **one)
        small = {"fontName": "NoteItalic", "fontSize": 9.5, "leading": 13, "textColor": "#444444"}
        self.why = ParagraphStyle("why", self.plain, **small)
        self.small = ParagraphStyle("small", self.plain, firstLineIndent=0, alignment=1, spaceBefore=2, spaceAfter=8)
        self.left = ParagraphStyle("left", self.small, alignment=0)
        self.cell = ParagraphStyle("cell", self.small, fontSize=9.5, leading=12, spaceBefore=0, spaceAfter=0)
        self.heads = [
            ParagraphStyle(
                f"h{k}", fontName="NoteBold", fontSize=s, leading=s * 1.3, spaceBefore=b, spaceAfter=6, keepWithNext=1
            )
            for k, (s, b) in enumerate(((15, 0), (12.5, 14)))
        ]  # fmt: skip

    def flow(self, block: Block) -> list[Any]:
        from reportlab.platypus import KeepTogether, Paragraph

        match block:
            case Heading():
                return [Paragraph(escape(block.text), self.heads[block.level])]
            case Prose():
                count = f"{block.number}. " if block.number else ""
                said = [Paragraph(count + self.text(block.text, block.plan), self.plain)]
                return [*said, Paragraph(self.text(block.why, block.plan), self.why)] if block.why else said
            case Table():
                return [KeepTogether([Paragraph(escape(block.caption), self.left), self.table(block)])]
            case Figure():
                view = self.figures.get(block.key)
                if view is None:
                    return []
                caption = [Paragraph(escape(block.caption), self.small)] if block.caption else []
                return [KeepTogether([_drawn(view), *caption])]

    def table(self, block: Table) -> Any:
        from reportlab.platypus import Paragraph
        from reportlab.platypus import Table as Grid

        rows = [[Paragraph(self.text(c), self.cell) for c in row] for row in block.rows]
        grid = [("GRID", (0, 0), (-1, -1), 0.5, "#777777"), ("VALIGN", (0, 0), (-1, -1), "MIDDLE")]
        return Grid(rows, style=grid, repeatRows=1, hAlign="LEFT")

    def text(self, text: str, plan: str = "") -> str:
        """Running text with names in italics, indices lowered and raised."""
        found = ""
        for piece in pieces(text, self.naming, plan):
            inner = escape(piece.text)
            tag = {"sub": "sub", "sup": "super"}.get(piece.shift)
            inner = f"<{tag}>{inner}</{tag}>" if tag else inner
            found += f"<i>{inner}</i>" if piece.name else inner
        return found


def _drawn(view: View) -> Any:
    """A view as something that takes room in the text."""
    from reportlab.platypus import Flowable

    class Drawn(Flowable):  # type: ignore[misc]
        def __init__(self) -> None:
            super().__init__()
            self.k = min(1.0, WIDTH_MM / view.width, HEIGHT_MM / view.height)
            self.width, self.height = (POINTS_PER_MM * self.k * s for s in (view.width, view.height + 4))
            self.hAlign = "CENTER"

        def draw(self) -> None:
            self.canv.scale(POINTS_PER_MM * self.k, POINTS_PER_MM * self.k)
            draw_marks(self.canv, view.placed(0.0, view.height + 2))

    return Drawn()
