"""A document as a Word file, for a department's own template: headings, text, tables, figures, formulas as pictures."""

import io
from collections.abc import Sequence

from docx import Document
from docx.document import Document as WordFile
from docx.enum.text import WD_PARAGRAPH_ALIGNMENT as Side
from docx.shared import Mm, Pt
from docx.text.paragraph import Paragraph as Words

from planes.solving.document import Block, DocumentTable, Figure, Formula, Heading, Paragraph
from planes.words.naming import Naming
from render.charts.strokes import formula
from render.paper.letters import pieces
from render.report.figures import Shown, Studio, raster
from render.report.html import is_number

WIDTH, HEIGHT = 480.0, 540.0  # of a figure, points
LETTER = 13


def write(blocks: Sequence[Block], naming: Naming) -> bytes:
    """The whole file."""
    paper = Document()
    page = paper.sections[0]
    page.page_width, page.page_height = Mm(210), Mm(297)
    page.left_margin, page.right_margin, page.top_margin, page.bottom_margin = Mm(25), Mm(10), Mm(20), Mm(20)
    style = paper.styles["Normal"]
    style.font.name, style.font.size = "Times New Roman", Pt(LETTER)
    writer = _Writer(paper, naming)
    for block in blocks:
        writer.put(block)
    paper.save(data := io.BytesIO())
    return data.getvalue()


class _Writer:
    def __init__(self, paper: WordFile, naming: Naming) -> None:
        self.paper, self.naming, self.studio = paper, naming, Studio(naming.lang)

    def put(self, block: Block) -> None:
        """One block at the end of the paper."""
        match block:
            case Heading(text, level):
                self.runs(self.paper.add_heading("" if level else text, level), text if level else "")
            case Paragraph():
                style = "Intense Quote" if block.mistake else None
                count = f"{block.number}. " if block.number else ""
                self.runs(self.paper.add_paragraph(count, style), block.text, block.plan)
                if block.why:
                    self.runs(self.paper.add_paragraph(), block.why, block.plan, italic=True)
            case Formula(tex, number):
                line = self.picture(formula(tex, LETTER))
                if number:
                    line.add_run(f"  ({number})")
            case DocumentTable(caption, rows):
                self.table(caption, rows)
            case Figure():
                pictures, caption = self.studio.shown(block)
                for picture in pictures:
                    self.picture(picture).alignment = Side.CENTER
                if pictures and caption:
                    self.runs(self.paper.add_paragraph(), caption).alignment = Side.CENTER

    def runs(self, paragraph: Words, text: str, plan: str = "", italic: bool = False) -> Words:
        """Text at the end of a paragraph."""
        for piece in pieces(text, self.naming, plan):
            run = paragraph.add_run(piece.text)
            run.italic = piece.name != italic
            if piece.shift:  # the two share one property: setting either to None clears the other
                setattr(run.font, {"sub": "subscript", "sup": "superscript"}[piece.shift], True)
        return paragraph

    def table(self, caption: str, rows: tuple[tuple[str, ...], ...]) -> None:
        """A table with its caption above."""
        self.runs(self.paper.add_paragraph(), caption)
        table = self.paper.add_table(rows=0, cols=len(rows[0]), style="Table Grid")
        for row in rows:
            for cell, text in zip(table.add_row().cells, row, strict=True):
                self.runs(cell.paragraphs[0], text).alignment = Side.RIGHT if is_number(text) else Side.LEFT
        self.paper.add_paragraph()

    def picture(self, picture: Shown) -> Words:
        """A paragraph that holds a picture, made smaller if it is larger than the column."""
        scale = min(1.0, WIDTH / picture.width, HEIGHT / picture.height)
        self.paper.add_picture(io.BytesIO(raster(picture)), width=Pt(picture.width * scale))
        return self.paper.paragraphs[-1]
