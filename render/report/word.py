"""A document as a Word file with the margins, type and spacing of ГОСТ 7.32-2017 (6.1), contents and page numbers;
formulas are Word's own equations."""

import io
from collections.abc import Sequence

from docx import Document
from docx.document import Document as WordFile
from docx.enum.text import WD_BREAK as Break
from docx.enum.text import WD_PARAGRAPH_ALIGNMENT as Side
from docx.enum.text import WD_TAB_ALIGNMENT as Tab
from docx.oxml import OxmlElement
from docx.oxml.ns import qn
from docx.shared import Mm, Pt, RGBColor
from docx.styles.style import ParagraphStyle
from docx.text.paragraph import Paragraph as Words

from planes.solving.document import Block, Cover, DocumentTable, Figure, Formula, Heading, Paragraph
from planes.words.names import NO_PLAN, PlanId
from planes.words.naming import Naming
from render.paper.letters import lettered_pieces
from render.report.figures import DocumentSetter, Shown, png_of_picture
from render.report.html import is_number
from render.report.omml import word_equation

COLUMN_WIDTH_MM = 165.0  # width of text, between margins of 30 and 15 mm
MOST_FIGURE_WIDTH_PT = COLUMN_WIDTH_MM * 72 / 25.4  # of a figure, points
MOST_FIGURE_HEIGHT_PT = 540.0
TEXT_SIZE_PT = 14  # of text, points
TABLE_TEXT_SIZE_PT = 12  # of tables, points
FIRST_LINE_INDENT_MM = 12.5


def write(blocks: Sequence[Block], naming: Naming) -> bytes:
    """The whole file."""
    paper = Document()
    page = paper.sections[0]
    page.page_width = Mm(210)
    page.page_height = Mm(297)
    page.left_margin = Mm(30)
    page.right_margin = Mm(15)
    page.top_margin = Mm(20)
    page.bottom_margin = Mm(20)
    for name in ("Normal", "Title", "Heading 1", "Heading 2", "Heading 3", "Intense Quote"):
        set_font_and_spacing(paper.styles[name], name.startswith("Heading"))
    chapters = [one.text for one in blocks if isinstance(one, Heading) and one.level]
    writer = _Writer(paper, naming, chapters)
    writer.add_field(page.footer.paragraphs[0], "PAGE").alignment = Side.CENTER
    for block in blocks:
        writer.write_block(block)
    paper.save(data := io.BytesIO())
    return data.getvalue()


def set_font_and_spacing(style: ParagraphStyle, heading: bool) -> None:
    """Times New Roman in black, line spacing 1.5; a heading in bold."""
    style.font.name = "Times New Roman"
    style.font.size = Pt(TEXT_SIZE_PT)
    style.font.color.rgb = RGBColor(0, 0, 0)
    fonts = style.element.rPr.rFonts
    for key in [key for key in fonts.attrib if key.endswith("Theme")]:
        del fonts.attrib[key]
    fonts.set(qn("w:cs"), "Times New Roman")
    shape = style.paragraph_format
    for line in style.element.iterdescendants(qn("w:bottom")):  # beneath a set-off paragraph
        line.set(qn("w:color"), "000000")
    shape.line_spacing = 1.5
    shape.space_before = Pt(12 * heading)
    shape.space_after = Pt(6 * heading)
    shape.first_line_indent = Mm(0 if style.name == "Title" else FIRST_LINE_INDENT_MM)
    style.font.bold = heading or style.name == "Title"
    shape.keep_with_next = heading


class _Writer(DocumentSetter):
    def __init__(self, paper: WordFile, naming: Naming, chapters: Sequence[str]) -> None:
        super().__init__(naming)
        self.paper = paper
        self.chapters = chapters

    def write_block(self, block: Block) -> None:
        """One block at the end of the paper."""
        match block:
            case Cover():
                self.write_cover(block)
            case Heading(text, level):
                title = self.paper.add_heading("" if level else text, level)
                self.add_runs(title, text if level else "").alignment = Side.LEFT if level else Side.CENTER
                if not level:
                    self.write_contents()
            case Paragraph():
                style = "Intense Quote" if block.mistake else None
                count = f"{block.number}. " if block.number else ""
                self.add_runs(self.paper.add_paragraph(count, style), block.text, block.plan, block.why)
            case Formula(number=number):
                line = self.add_line("\t")
                for place, side in ((COLUMN_WIDTH_MM / 2, Tab.CENTER), (COLUMN_WIDTH_MM, Tab.RIGHT)):
                    line.paragraph_format.tab_stops.add_tab_stop(Mm(place), side)
                line._p.append(word_equation(block.tex_source))
                line.add_run(f"\t({number})" if number else "")
            case DocumentTable(caption, rows):
                self.write_table(caption, rows)
            case Figure():
                pictures, caption = self.shown(block)
                for picture in pictures:
                    self.write_picture(picture).alignment = Side.CENTER
                if pictures and caption:
                    self.add_runs(self.add_line(), caption).alignment = Side.CENTER

    def write_cover(self, cover: Cover) -> None:
        """The title page."""
        for text in cover.above:
            self.add_line(text).alignment = Side.CENTER
        title = self.paper.add_heading(cover.kind, 0)
        title.alignment = Side.CENTER
        title.paragraph_format.space_before = Pt(180)
        title.paragraph_format.space_after = Pt(12)
        self.add_line(cover.of).alignment = Side.CENTER
        for k, text in enumerate(cover.people):
            line = self.add_line(text)
            line.alignment = Side.RIGHT
            line.paragraph_format.space_before = Pt(0 if k else 120)
        foot = self.add_line(cover.foot)
        foot.alignment = Side.CENTER
        foot.paragraph_format.space_before = Pt(120)
        self.break_page()
        self.add_line(cover.contents).runs[0].bold = True
        self.write_contents()
        self.break_page()
        self.paper.sections[0].different_first_page_header_footer = True

    def write_contents(self) -> None:
        """The list of chapters."""
        self.add_field(self.add_line(), r"TOC \o 1-2 \h \z", "\n".join(self.chapters))

    def break_page(self) -> None:
        """What follows begins a page."""
        self.add_line().add_run().add_break(Break.PAGE)

    def add_line(self, text: str = "") -> Words:
        """A paragraph that begins at the left edge of the column."""
        paragraph = self.paper.add_paragraph(text)
        paragraph.paragraph_format.first_line_indent = Mm(0)
        return paragraph

    def add_field(self, paragraph: Words, code: str, shown: str = "") -> Words:
        """A field that Word updates, and its text until then."""
        made = OxmlElement("w:fldSimple")
        made.set(qn("w:instr"), code)
        run = paragraph.add_run(shown)
        made.append(run._r)
        paragraph._p.append(made)
        return paragraph

    def add_runs(self, paragraph: Words, text: str, plan: PlanId = NO_PLAN, italic: bool = False) -> Words:
        """Text at the end of a paragraph."""
        for piece in lettered_pieces(text, self.naming, plan):
            run = paragraph.add_run(piece.text)
            run.italic = piece.name != italic
            if piece.shift:  # the two share one property: setting either to None clears the other
                setattr(run.font, {"sub": "subscript", "sup": "superscript"}[piece.shift], True)
        return paragraph

    def write_table(self, caption: str, rows: tuple[tuple[str, ...], ...]) -> None:
        """A table with its caption above."""
        self.add_runs(self.add_line(), caption).paragraph_format.keep_with_next = True
        table = self.paper.add_table(rows=0, cols=len(rows[0]), style="Table Grid")
        for row in rows:
            for cell, text in zip(table.add_row().cells, row, strict=True):
                line = self.add_runs(cell.paragraphs[0], text)
                line.alignment = Side.RIGHT if is_number(text) else Side.LEFT
                line.paragraph_format.first_line_indent = Mm(0)
                line.paragraph_format.line_spacing = 1.0
                for run in line.runs:
                    run.font.size = Pt(TABLE_TEXT_SIZE_PT)
        self.add_line()

    def write_picture(self, picture: Shown) -> Words:
        """A paragraph with a picture, reduced if it is wider than the column."""
        scale = min(1.0, MOST_FIGURE_WIDTH_PT / picture.width, MOST_FIGURE_HEIGHT_PT / picture.height)
        paragraph = self.add_line()
        paragraph.add_run().add_picture(io.BytesIO(png_of_picture(picture)), width=Pt(picture.width * scale))
        return paragraph
