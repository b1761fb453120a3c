"""Tracing paper as one page: the right plans, to lay over a picture that is opened in the page and sent nowhere."""

from __future__ import annotations

import html
from collections.abc import Mapping
from importlib.resources import files
from typing import Any

from render.check_page import embedded

SAID = ("pole", "turned", "scale", "not_picture")


def page(data: Mapping[str, Any], words: Mapping[str, str], lang: str) -> str:
    """The page of what :func:`planes.check.tracing_paper.tracing_data` exports; ``words`` are its labels."""
    folder = files("render") / "page"
    said = {k: words[k] for k in SAID}
    parts = {
        **{k: html.escape(text) for k, text in words.items()},
        "lang": lang, "title": html.escape(data["title"]),
        "css": "".join((folder / f"{name}.css").read_text("utf-8") for name in ("check", "trace")),
        "js": "".join((folder / f"{name}.js").read_text("utf-8") for name in ("figure", "trace")),
        "data": embedded({**data, "words": said}),
    }  # fmt: skip
    text = (folder / "trace.html").read_text("utf-8")
    for key, value in parts.items():
        text = text.replace("{" + key + "}", value)
    return text
