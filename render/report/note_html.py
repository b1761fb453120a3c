"""The note as one self-contained page that prints to A4."""

from __future__ import annotations

import html
import re
from collections.abc import Mapping, Sequence

from planes.lesson.note import Block, Figure, Heading, Prose, Table
from render.files import svg
from render.page import web_page
from render.paper.letters import pieces
from render.paper.names import Naming
from render.views import View

STYLE = """
body { max-width: 46rem; margin: 2rem auto; padding: 0 1rem; color: #14171c; }
body { font: 17px/1.5 "PT Serif", Georgia, "DejaVu Serif", serif; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.2rem; margin: 2rem 0 .5rem; border-bottom: 1px solid #bbb; }
p { margin: .5rem 0; } .why { color: #555; font-style: italic; margin-top: 0; }
.number { color: #777; margin-right: .4em; }
figure { margin: 1rem 0; text-align: center; } figure svg { max-width: 100%; height: auto; }
figcaption { font-size: .92rem; }
table { border-collapse: collapse; margin: .3rem 0 1rem; } caption { text-align: left; padding: .3rem 0; }
th, td { border: 1px solid #999; padding: .15rem .6rem; text-align: right; }
th:first-child, td:first-child { text-align: left; }
sub, sup { line-height: 0; } i { white-space: nowrap; }
@media print {
  @page { size: A4; margin: 20mm 10mm 20mm 25mm; }
  body { margin: 0; max-width: none; font-size: 11pt; }
  figure, table { break-inside: avoid; } h2 { break-after: avoid; }
}
"""


def write(blocks: Sequence[Block], figures: Mapping[str, View], naming: Naming) -> bytes:
    """The whole page."""
    title = next((b.text for b in blocks if isinstance(b, Heading)), "")
    body = "\n".join(_block(b, figures, naming) for b in blocks)
    return web_page.page(title, naming.lang, STYLE, body).encode()


def _block(block: Block, figures: Mapping[str, View], naming: Naming) -> str:
    match block:
        case Heading():
            return f"<h{block.level + 1}>{html.escape(block.text)}</h{block.level + 1}>"
        case Prose():
            count = f'<span class="number">{block.number}.</span>' if block.number else ""
            why = f'<p class="why">{_text(block.why, naming, block.plan)}</p>' if block.why else ""
            return f"<p>{count}{_text(block.text, naming, block.plan)}</p>{why}"
        case Table():
            return _table(block, naming)
        case Figure():
            return _figure(block, figures, naming)


def _table(block: Table, naming: Naming) -> str:
    head, *rows = block.rows
    top = "".join(f"<th>{_text(c, naming)}</th>" for c in head)
    body = "".join("<tr>" + "".join(f"<td>{_text(c, naming)}</td>" for c in row) + "</tr>" for row in rows)
    return f"<table><caption>{html.escape(block.caption)}</caption><tr>{top}</tr>{body}</table>"


def _figure(block: Figure, figures: Mapping[str, View], naming: Naming) -> str:
    view = figures.get(block.key)
    if view is None:
        return ""
    width, height = view.width + 4, view.height + 4
    text = svg.write(view.placed(2, height - 2), (width, height), block.caption, lang=naming.lang).decode()
    text = text.replace('<?xml version="1.0" encoding="UTF-8"?>', "").strip()
    key = re.sub(r"\W", "-", block.key)
    text = re.sub(r'\bid="', f'id="{key}-', text)
    caption = f"<figcaption>{html.escape(block.caption)}</figcaption>" if block.caption else ""
    return f"<figure>{text}{caption}</figure>"


def _text(text: str, naming: Naming, plan: str = "") -> str:
    found = ""
    for piece in pieces(text, naming, plan):
        inner = html.escape(piece.text)
        inner = f"<{piece.shift}>{inner}</{piece.shift}>" if piece.shift else inner
        found += f"<i>{inner}</i>" if piece.name else inner
    return found
