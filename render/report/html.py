"""The report as one HTML page that needs nothing beside it: styles, formulas and figures stand inside."""

from __future__ import annotations

import re
from collections.abc import Sequence

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
from render.charts.strokes import Picture, escaped
from render.files import svg
from render.page import web_page
from render.report.figures import Figure, shown
from render.report.mathematics import formula

CSS = """
body{font:16px/1.5 "PT Serif","DejaVu Serif",Georgia,"Times New Roman",serif;color:#111;background:#fff;max-width:46rem;
 margin:2rem auto;padding:0 1rem}
h1{font-size:1.7rem;line-height:1.25}h2{font-size:1.35rem;margin-top:2.4rem;border-bottom:1px solid #999}
h3{font-size:1.1rem;margin-top:1.6rem}
.formula{display:flex;align-items:center;margin:.55rem 0;overflow-x:auto}
.parts{display:flex;flex-wrap:wrap;align-items:center;gap:.3rem 1.1rem}.parts svg{max-width:100%;height:auto}
.formula .number{white-space:nowrap;margin-left:auto;padding-left:1rem;color:#444}
.mistake{border:1px solid #a33;border-left:5px solid #a33;padding:.5rem .8rem;margin:1rem 0;background:#fdf4f2}
figure{margin:1.4rem 0;overflow-x:auto}figure svg{max-width:100%;height:auto;display:block;margin:0 auto}
figcaption,caption{font-size:.92rem;color:#333;padding:.4rem 0;text-align:left}figcaption{text-align:center}
.wide{overflow-x:auto;margin:1.2rem 0}table{border-collapse:collapse;font-size:.85rem;width:100%}
th,td{border:1px solid #bbb;padding:.15rem .4rem;text-align:right;white-space:nowrap}
th{background:#f2f2f2;text-align:center}td.word{text-align:left;white-space:normal}
.mu{white-space:nowrap}sub,sup{font-size:.72em;line-height:0}nav{font-size:.95rem}nav a{color:#124}
@media print{body{max-width:none;margin:0}figure,table,.formula,.mistake{break-inside:avoid}h2,h3{break-after:avoid}}
"""


def write(document: Document) -> bytes:
    """The page, UTF-8."""
    made = _Page(document)
    body = "\n".join(made.block(b) for b in document.blocks)
    links = "".join(f'<li><a href="#c{n}">{text}</a></li>' for n, text in made.chapters)
    whole = f"<h1>{escaped(document.title)}</h1>\n<nav><ul>{links}</ul></nav>\n<main>\n{body}\n</main>"
    return web_page.page(document.title, document.lang, CSS, whole).encode()


def rich(text: str) -> str:
    """_{…} and ^{…} as lower and upper indices."""
    text = re.sub(r"(μ_\{\w\} = [^;,]+(?:,\d[^;,]*)?)", r'<span class="mu">\1</span>', escaped(text))
    text = re.sub(r"_\{([^}]*)\}", r"<sub>\1</sub>", text)
    return re.sub(r"\^\{([^}]*)\}", r"<sup>\1</sup>", text)


class _Page:
    def __init__(self, document: Document) -> None:
        self.document = document
        self.chapters: list[tuple[int, str]] = []

    def block(self, block: Block) -> str:
        """One block as HTML."""
        match block:
            case Heading(text, level):
                return self.heading(text, level)
            case Paragraph(text):
                return f"<p>{rich(text)}</p>"
            case Mistake(text):
                return f'<p class="mistake" role="note">{rich(text)}</p>'
            case Formula(tex, number):
                tail = f'<span class="number">({number})</span>' if number else ""
                parts = "".join(formula(t).svg(plain(t), 1.15) for t in tex.split(r"\quad"))
                return f'<div class="formula"><span class="parts">{parts}</span>{tail}</div>'
            case TableBlock():
                return self.table(block)
            case Chart() | Drawn() | Sketch():
                return self.figure(*shown(block, self.document.lang))

    def heading(self, text: str, level: int) -> str:
        """A chapter, which the list of contents links to, or a section."""
        if level > 1:
            return f"<h3>{rich(text)}</h3>"
        self.chapters.append((len(self.chapters) + 1, rich(text)))
        return f'<h2 id="c{len(self.chapters)}">{rich(text)}</h2>'

    def table(self, block: TableBlock) -> str:
        """A table that scrolls by itself on a narrow screen."""
        head = "".join(f'<th scope="col">{rich(cell)}</th>' for cell in block.head)
        rows = "".join("<tr>" + "".join(_cell(cell) for cell in row) + "</tr>" for row in block.rows)
        return (f'<div class="wide"><table><caption>{rich(block.title)}</caption><thead><tr>{head}</tr></thead>'
                f"<tbody>{rows}</tbody></table></div>")  # fmt: skip

    def figure(self, pictures: Sequence[Picture | Figure], title: str) -> str:
        """A figure with its title beneath."""
        drawn = "".join(p.svg(title, 1.05) if isinstance(p, Picture) else self.marks(p, title) for p in pictures)
        return f"<figure>{drawn}<figcaption>{rich(title)}</figcaption></figure>"

    def marks(self, figure: Figure, title: str) -> str:
        """Marks as inline SVG; groups lose their ids, for a page may hold many drawings."""
        text = svg.write(figure.marks, figure.size, title, lang=self.document.lang).decode()
        text = re.sub(r"^<\?xml[^>]*>\s*", "", text)
        return re.sub(r' id="[^"]*"', "", text)


def is_number(text: str) -> bool:
    """Whether a cell holds a number, so that it stands on the right."""
    return bool(re.match(r"^[−-]?[\d∞…—]", text))


def _cell(text: str) -> str:
    return f"<td>{rich(text)}</td>" if is_number(text) else f'<td class="word">{rich(text)}</td>'


def plain(tex: str) -> str:
    """A formula as words for those who hear the page."""
    text = re.sub(r"\\(?:mathrm|left|right|quad|,|;|\s)", " ", tex)
    return re.sub(r"\s+", " ", re.sub(r"[\\{}]", " ", text)).strip()
