"""Tracing paper as one page: the right plans, to lay over a picture that is opened in the page and sent nowhere."""

from __future__ import annotations

import html
from collections.abc import Mapping

from planes.words.records import Json
from render.page import web_page
from render.paper.letters import written

SAID = ("pole", "turned", "scale", "not_picture")


def page(data: Json, words: Mapping[str, str], lang: str) -> str:
    """The page of what :func:`planes.check.report.tracing_paper.tracing_data` exports; ``words`` are its labels."""
    parts = {k: html.escape(text) for k, text in {**words, "title": data["title"]}.items()}
    body = web_page.filled(web_page.part("trace.html"), parts)
    style, code = web_page.part("check.css", "trace.css"), web_page.part("figure.js", "trace.js")
    names = (name for plan in data["plans"] for name in (*plan["marks"], *(name for name, *_ in plan["names"])))
    held = {"data": {**data, "words": {k: words[k] for k in SAID}}, "letters": written(names, data["lettering"])}
    return web_page.page(data["title"], lang, style, body, code=code, data=held)
