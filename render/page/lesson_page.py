"""The lesson as one self-contained page: the exported drawings, a painter of lines between marks, no network."""

from __future__ import annotations

import html
from typing import Any

from planes.words import TABLE
from planes.words.pages import PAGES
from render.page import web_page

SHARED = {"scheme": "scheme", "formula": "formula", "shifted": "shifted"} | {
    key: f"lesson_{key}" for key in ("ccw", "cw", "still")
}
"""Words of the page that stand in other tables."""
SCRIPTS = ("figure", "scheme", "plan", "lesson", "practice")
NOSCRIPT = (
    "Страница рисует план сама: включите JavaScript. / The page draws the plans itself: please enable JavaScript."
)


def page(data: dict[str, Any], lang: str) -> str:
    """The whole page; ``data`` is what :func:`planes.lesson.data.lesson_data` exports."""
    keys = {key.removeprefix("page_"): key for key in PAGES} | SHARED
    words = {key: dict(zip(("ru", "en"), TABLE[name], strict=True)) for key, name in keys.items()}
    title = data["title"].get(lang, "")
    parts = {
        "title": html.escape(title),
        "formula": html.escape(data["formula"]),
        "frames": str(len(data["frames"])),
        "last": str(len(data["drive"]["values"]) - 1),
        "at": str(data["drive"]["at"]),
        "noscript": NOSCRIPT,
    }
    body = web_page.filled(web_page.part("lesson.html"), parts)
    code = web_page.part(*(f"{name}.js" for name in SCRIPTS))
    return web_page.page(title, lang, web_page.part("lesson.css"), body, code=code, data={"words": words, "data": data})
