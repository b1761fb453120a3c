"""The note as a Word document, for a department's own template: headings, text, tables and figures."""

from __future__ import annotations

import io
from collections.abc import Mapping, Sequence
from typing import Any

from planes.lesson.note import Block, Figure, Heading, Prose, Table
from render.files import png
from render.paper.letters import pieces
from render.paper.names import Naming
from render.views import View

WIDTH_MM, HEIGHT_MM = 170.0, 190.0
DPI = 220


def write(blocks: Sequence[Block], figures: Mapping[str, View], naming: Naming) -> bytes:
    """The whole file. :class:`ImportError` where python-docx is not installed."""
    from docx import Document
    from docx.shared import Mm, Pt

    paper = Document()
    page = paper.sections[0]
    page.page_width, page.page_height = Mm(210), Mm(297)
    page.left_margin, page.right_margin, page.top_margin, page.bottom_margin = Mm(25), Mm(10), Mm(20), Mm(20)
    style: Any = paper.styles["Normal"]
    style.font.name, style.font.size = "Times New Roman", Pt(13)
    for block in blocks:
        _put(paper, block, figures, naming)
    data = io.BytesIO()
    paper.save(data)
    return data.getvalue()


def _put(paper: Any, block: Block, figures: Mapping[str, View], naming: Naming) -> None:
    match block:
        case Heading():
            paper.add_heading(block.text, block.level)
        case Prose():
            _runs(paper.add_paragraph(f"{block.number}. " if block.number else ""), block.text, naming, block.plan)
            if block.why:
                _runs(paper.add_paragraph(), block.why, naming, block.plan, italic=True)
        case Table():
            _table(paper, block, naming)
        case Figure():
            view = figures.get(block.key)
            if view is not None:
                _figure(paper, view, block.caption)


def _runs(paragraph: Any, text: str, naming: Naming, plan: str, italic: bool = False) -> None:
    for piece in pieces(text, naming, plan):
        run = paragraph.add_run(piece.text)
        run.italic = piece.name != italic
        if piece.shift:  # the two share one property: setting either to None clears the other
            setattr(run.font, {"sub": "subscript", "sup": "superscript"}[piece.shift], True)


def _table(paper: Any, block: Table, naming: Naming) -> None:
    paper.add_paragraph(block.caption)
    table = paper.add_table(rows=0, cols=len(block.rows[0]), style="Table Grid")
    for row in block.rows:
        for cell, text in zip(table.add_row().cells, row, strict=True):
            _runs(cell.paragraphs[0], text, naming, "")
    paper.add_paragraph()


def _figure(paper: Any, view: View, caption: str) -> None:
    from docx.shared import Mm

    size = view.width + 4, view.height + 4
    data = png.write(view.placed(2, size[1] - 2), size, caption, dpi=DPI)
    scale = min(1.0, WIDTH_MM / size[0], HEIGHT_MM / size[1])
    paper.add_picture(io.BytesIO(data), width=Mm(size[0] * scale))
    paper.paragraphs[-1].alignment = 1
    if caption:
        paper.add_paragraph(caption).alignment = 1
