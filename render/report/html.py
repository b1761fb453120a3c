"""A document as one HTML page without external files: styles, formulas and figures are inside."""

import re
from collections.abc import Sequence
from html import escape

from planes.solving.document import Block, Cover, DocumentTable, Figure, Formula, Heading, Paragraph
from planes.words.naming import Naming
from render.page import web_page
from render.report.figures import DocumentSetter
from render.report.mathml import formula_as_mathml


def write(blocks: Sequence[Block], naming: Naming) -> bytes:
    """The page, UTF-8."""
    title = next((b.text for b in blocks if isinstance(b, Cover | Heading)), "")
    body = "\n".join(map(_HtmlPage(blocks, naming).block_html, blocks))
    return web_page.fill_web_page(title, naming.lang, ("report.css",), body).encode()


class _HtmlPage(DocumentSetter):
    def __init__(self, blocks: Sequence[Block], naming: Naming) -> None:
        super().__init__(naming)
        self.chapters = [b for b in blocks if isinstance(b, Heading) and b.level == 1]

    def block_html(self, block: Block) -> str:
        """One block as HTML."""
        match block:
            case Cover():
                return self.cover_html(block) + self.contents_html()
            case Heading():
                return self.heading_html(block)
            case Paragraph():
                kind = ' class="why"' if block.why else ' class="mistake" role="note"' if block.mistake else ""
                count = f'<span class="count">{block.number}.</span>' if block.number else ""
                return f"<p{kind}>{count}{self.text(block.text, block.plan)}</p>"
            case Formula(pieces, number):
                tail = f'<span class="number">({escape(number)})</span>' if number else ""
                parts = "".join(map(formula_as_mathml, pieces))
                return f'<div class="formula"><span class="parts">{parts}</span>{tail}</div>'
            case DocumentTable(caption, rows):
                return self.table_html(caption, rows)
            case Figure():
                pictures, caption = self.shown(block)
                beneath = f"<figcaption>{self.text(caption)}</figcaption>" if caption else ""
                shown = "".join(p.inline_svg(caption) for p in pictures)
                return f"<figure>{shown}{beneath}</figure>" if pictures else ""

    def cover_html(self, cover: Cover) -> str:
        """The head of the page."""
        lines = "".join(f"<p>{escape(line)}</p>" for line in cover.above)
        beneath = "".join(f"<p>{escape(line)}</p>" for line in (*cover.people, cover.foot) if line)
        mechanism = f"<br><small>{escape(cover.of)}</small>" if cover.of else ""
        return f'<header class="cover">{lines}<h1>{escape(cover.kind)}{mechanism}</h1>{beneath}</header>'

    def heading_html(self, heading: Heading) -> str:
        """The title with the list of contents, a chapter, which the list links to, or a section."""
        text = self.text(heading.text) if heading.level else escape(heading.text)  # the title may come from anybody
        tag = f"h{heading.level + 1}"
        if heading.level == 1:
            place = next(n for n, one in enumerate(self.chapters, 1) if one is heading)
            return f'<{tag} id="c{place}">{text}</{tag}>'
        return f"<{tag}>{text}</{tag}>" + ("" if heading.level else self.contents_html())

    def contents_html(self) -> str:
        """The list of chapters."""
        links = "".join(f'<li><a href="#c{n}">{self.text(c.text)}</a></li>' for n, c in enumerate(self.chapters, 1))
        return f"\n<nav><ul>{links}</ul></nav>" if links else ""

    def table_html(self, caption: str, rows: Sequence[Sequence[str]]) -> str:
        """A table that scrolls separately on a narrow screen."""
        head = "".join(f'<th scope="col">{self.text(cell)}</th>' for cell in rows[0])
        body = "".join("<tr>" + "".join(map(self.cell_html, row)) + "</tr>" for row in rows[1:])
        parts = f"<caption>{self.text(caption)}</caption><thead><tr>{head}</tr></thead><tbody>{body}</tbody>"
        return f'<div class="wide"><table>{parts}</table></div>'

    def cell_html(self, cell: str) -> str:
        """A cell of a table."""
        kind = "" if is_number(cell) else ' class="word"'
        return f"<td{kind}>{self.text(cell)}</td>"


def is_number(text: str) -> bool:
    """Whether a cell holds a number, to be aligned right."""
    return bool(re.match(r"^[−-]?[\d∞…—]", text))
