"""The drawings of a class as one page: how many are right, which mistakes whose, and a row for each, sorted at will."""

from __future__ import annotations

import html
from collections.abc import Sequence

from render.page import web_page

STYLE = """td, th, thead th { text-align: left; vertical-align: top; } td:last-child { max-width: 44rem; }
tbody th { font: inherit; } tbody tr[class] td:last-child::before { content: none; }
thead button { border: 0; background: none; padding: 0; min-height: 0; color: inherit; font: inherit;
  white-space: nowrap; }
thead button::after { content: " ↕"; opacity: .45; }
th[aria-sort=ascending] button::after { content: " ↓"; opacity: 1; }
th[aria-sort=descending] button::after { content: " ↑"; opacity: 1; } li { margin: .15rem 0; }
@media print { thead button::after { content: ""; } tr { break-inside: avoid; } }
tr.right td:first-of-type::before { content: "✓ "; } tr.wrong td:first-of-type::before { content: "✗ "; }
h2 { font-size: 1.05rem; margin: .8rem 0 .2rem; } ol { margin: .2rem 0; } td:first-of-type { white-space: nowrap; }
tr.unreadable > * { color: var(--soft); } .counts span { margin-right: 1.6rem; } .counts b { font-size: 1.3rem; }"""

Whose = Sequence[tuple[str, str]]
SCRIPT = (
    "for (const th of document.querySelectorAll('thead th')) th.firstChild.onclick = () => {"
    " const down = th.ariaSort === 'ascending', body = document.querySelector('tbody');"
    " const key = row => row.children[th.cellIndex].textContent;"
    " const rows = [...body.rows].sort((a, b) => (key(a) === '') - (key(b) === '')"
    " || key(a).localeCompare(key(b), document.documentElement.lang, { numeric: true }) * (down ? -1 : 1));"
    " for (const one of th.parentNode.children) one.removeAttribute('aria-sort');"
    " th.ariaSort = down ? 'descending' : 'ascending'; body.append(...rows); };"
)


def page(
    title: str,
    counts: Sequence[tuple[str, int]],
    common: Sequence[tuple[str, Whose]],
    head: Sequence[str],
    rows: Sequence[tuple[str, str, Sequence[str]]],
    words: dict[str, str],
    lang: str,
) -> str:
    """The page. ``rows`` are verdict, link ("" for none) and the cells; ``common`` sentences with whose: name, link."""
    e = html.escape
    cells = "".join(f'<th scope="col"><button type="button">{e(h)}</button></th>' for h in head)
    whose = (", ".join(_linked(e(name), link) for name, link in names) for _, names in common)
    often = "".join(
        f"<li>{e(said)} — <b>{len(names)}</b>: {told}</li>" for (said, names), told in zip(common, whose, strict=True)
    )
    body = f"""<h1>{e(title)}</h1>
<p class="counts">{"".join(f"<span>{e(name)} <b>{count}</b></span>" for name, count in counts)}</p>
{f"<h2>{e(words['common'])}</h2><ol>{often}</ol>" if often else ""}
<table><thead><tr>{cells}</tr></thead><tbody>
{"".join(_row(*row) for row in rows)}</tbody></table>"""
    return web_page.page(title, lang, web_page.part("check.css") + STYLE, body, code=SCRIPT)


def _row(verdict: str, link: str, cells: Sequence[str]) -> str:
    name, *rest = (html.escape(c) for c in cells)
    told = "".join(f"<td>{c}</td>" for c in rest)
    return f'<tr class="{verdict}"><th scope="row">{_linked(name, link)}</th>{told}</tr>\n'


def _linked(name: str, link: str) -> str:
    return f'<a href="{html.escape(link, quote=True)}">{name}</a>' if link else name
