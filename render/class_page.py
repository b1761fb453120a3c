"""The drawings of a class as one page: how many are right, which mistakes are common, and a row for each."""

from __future__ import annotations

import html
from collections.abc import Sequence
from importlib.resources import files

STYLE = """td, th, thead th { text-align: left; vertical-align: top; } td:last-child { max-width: 44rem; }
tbody th { font: inherit; } tbody tr td:last-child::before { content: none; }
tr.right td:first-of-type::before { content: "✓ "; } tr.wrong td:first-of-type::before { content: "✗ "; }
h2 { font-size: 1.05rem; margin: .8rem 0 .2rem; } ol { margin: .2rem 0; } td:first-of-type { white-space: nowrap; }
tr.unreadable > * { color: var(--soft); } .counts span { margin-right: 1.6rem; } .counts b { font-size: 1.3rem; }"""


def page(
    title: str, counts: Sequence[tuple[str, int]], common: Sequence[tuple[str, int]], head: Sequence[str],
    rows: Sequence[tuple[str, str, Sequence[str]]], words: dict[str, str], lang: str,
) -> str:  # fmt: skip
    """The page. ``rows`` are verdict, link ("" for none) and the cells; ``common`` sentences with their numbers."""
    e = html.escape
    css = (files("render") / "page" / "check.css").read_text("utf-8")
    cells = "".join(f'<th scope="col">{e(h)}</th>' for h in head)
    often = "".join(f"<li>{e(said)} — {count}</li>" for said, count in common)
    return f"""<!doctype html>
<html lang="{lang}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{e(title)}</title>
<style>{css}{STYLE}</style>
</head>
<body>
<h1>{e(title)}</h1>
<p class="counts">{"".join(f"<span>{e(name)} <b>{count}</b></span>" for name, count in counts)}</p>
{f"<h2>{e(words['common'])}</h2><ol>{often}</ol>" if often else ""}
<table><thead><tr>{cells}</tr></thead><tbody>
{"".join(_row(*row) for row in rows)}</tbody></table>
</body>
</html>
"""


def _row(verdict: str, link: str, cells: Sequence[str]) -> str:
    name, *rest = (html.escape(c) for c in cells)
    name = f'<a href="{html.escape(link, quote=True)}">{name}</a>' if link else name
    return f'<tr class="{verdict}"><th scope="row">{name}</th>' + "".join(f"<td>{c}</td>" for c in rest) + "</tr>\n"
