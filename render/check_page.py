"""The report of a checked drawing as one page: layers, a table of steps, marks to move and judge anew; no network."""

from __future__ import annotations

import html
import json
from collections.abc import Mapping, Sequence
from importlib.resources import files
from typing import Any

SCRIPTS = ("figure", "tape", "judge", "check")
LAYERS = ("own", "next", "truth", "picture")


def page(data: Mapping[str, Any], words: Mapping[str, str], lang: str) -> str:
    """The page of what :func:`planes.check.report.page_data` exports; ``words`` are its labels in the language."""
    folder = files("render") / "page"
    parts = {
        "lang": lang, "title": html.escape(data["title"]), "verdict": data["verdict"],
        "sentence": html.escape(data["sentence"]),
        "css": (folder / "check.css").read_text("utf-8"),
        "tables": _table("marks", words["steps"], data["head"], data["rows"])
        + _table("numbers", words["numbers"], data["number_head"], data["numbers"]),
        "notes": "".join(f"<p>{html.escape(n)}</p>" for n in data["notes"]),
        "drawing": _drawing(data, words) if "page" in data else "",
    }  # fmt: skip
    text = (folder / "check.html").read_text("utf-8")
    for key, value in parts.items():
        text = text.replace("{" + key + "}", value)
    return text if "page" not in data else text.replace("</body>", _scripts(data["page"], words) + "</body>")


def _scripts(data: Mapping[str, Any], words: Mapping[str, str]) -> str:
    folder = files("render") / "page"
    code = "".join((folder / f"{name}.js").read_text("utf-8") for name in SCRIPTS)
    return (
        f"<noscript><p>{html.escape(words['noscript'])}</p></noscript>"
        f'<script type="application/json" id="data">{embedded(data)}</script><script>{code}</script>\n'
    )


def embedded(thing: object) -> str:
    """JSON that cannot end its script element."""
    return json.dumps(thing, ensure_ascii=False, separators=(",", ":"), allow_nan=False).replace("</", "<\\/")


def _drawing(data: Mapping[str, Any], words: Mapping[str, str]) -> str:
    """The figure, its layers and what can be done with it."""
    e = html.escape
    under = data["page"]["picture"] or data["page"]["strokes"]
    layers = "".join(
        f'<label><input type="checkbox" data-layer="{n}" checked><i class="{n}"></i>{e(words[n])}</label>'
        for n in LAYERS if n != "picture" or under
    )  # fmt: skip
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
