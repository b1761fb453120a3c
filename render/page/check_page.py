"""The report of a checked drawing as one page: layers, a table of steps, marks to move and judge anew; no network."""

from __future__ import annotations

import html
from collections.abc import Mapping, Sequence

from planes.words.records import Json
from render.page import web_page
from render.paper.letters import written

SCRIPTS = ("figure", "tape", "judge", "check")
LAYERS = ("own", "next", "truth", "picture")


def page(data: Json, words: Mapping[str, str], lang: str) -> str:
    """The page of what :func:`planes.check.report.page_data` exports; ``words`` are its labels in the language."""
    drawn, e = "page" in data, html.escape
    parts = {
        "title": e(data["title"]),
        "sentence": e(data["sentence"]),
        "drawing": _drawing(data, words) if drawn else "",
        "tables": _table("marks", words["steps"], data["head"], data["rows"])
        + _table("numbers", words["numbers"], data["number_head"], data["numbers"]),
        "notes": "".join(f"<p>{e(n)}</p>" for n in data["notes"]),
        "noscript": f"<noscript><p>{e(words['noscript'])}</p></noscript>" if drawn else "",
    }
    body, style = web_page.filled(web_page.part("check.html"), parts), web_page.part("check.css")
    code = web_page.part(*(f"{name}.js" for name in SCRIPTS)) if drawn else ""
    held = {"data": data["page"], "letters": _letters(data)} if drawn else None
    return web_page.page(data["title"], lang, style, body, code=code, data=held, kind=data["verdict"])


def _letters(data: Json) -> Mapping[str, object]:
    """The names of marks and vectors as a sheet has them."""
    page = data["page"]
    rows = (row[1] for row in (*data["rows"], *data["numbers"]))
    sides = (name for key in ("rows", "order") for name, *_ in page[key])
    return written((*rows, *sides, *page["truth"], *(m["name"] for m in page["marks"])), page["lettering"])


def _drawing(data: Json, words: Mapping[str, str]) -> str:
    """The figure, its layers and what can be done with it."""
    e = html.escape
    under = data["page"]["picture"] or data["page"]["strokes"]
    layers = "".join(
        f'<label><input type="checkbox" data-layer="{n}" checked><i class="{n}"></i>{e(words[n])}</label>'
        for n in LAYERS
        if n != "picture" or under
    )
    return (
        f'<div class="layers">{layers}</div>\n'
        f'<figure><svg id="sheet" role="group" aria-label="{e(data["title"])}"></svg></figure>\n'
        f'<p id="moved" hidden>{e(words["moved"])} <button id="reset" type="button">{e(words["reset"])}</button></p>\n'
        f'<p class="hint">{e(words["drag"])} <code>{e(data["command"])}</code> '
        f'<button id="save" type="button">{e(words["save"])}</button></p>'
    )


def _table(key: str, caption: str, head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table of rows that begin with their verdict and their name."""
    if not rows:
        return ""
    cells = "".join(f'<th scope="col">{html.escape(h)}</th>' for h in head)
    body = ""
    for verdict, name, *row in rows:
        safe = html.escape(name, quote=True)
        told = "".join(f"<td>{html.escape(c)}</td>" for c in row)
        body += f'<tr class="{html.escape(verdict)}" data-mark="{safe}"><th scope="row">{safe}</th>{told}</tr>\n'
    return (
        f'<table id="{key}"><caption>{html.escape(caption)}</caption><thead><tr>{cells}</tr></thead>'
        f"<tbody>{body}</tbody></table>"
    )
