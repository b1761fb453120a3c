"""The lesson as one self-contained page: the exported drawings, a painter of lines between marks, no network."""

from __future__ import annotations

import html
import json
from importlib.resources import files
from typing import Any

WORDS: dict[str, tuple[str, str]] = {
    "scheme": ("Схема механизма", "Scheme of the mechanism"),
    "back": ("Назад", "Back"),
    "next": ("Вперёд", "Next"),
    "play": ("Показать подряд", "Play"),
    "step": ("Шаг построения", "Step of the construction"),
    "crank": ("Ведущее звено", "Driver"),
    "home": ("Заданное положение", "Given position"),
    "moved": (
        "Числа в предложении — для заданного положения; чертёж показан для выбранного.",
        "The numbers of the sentence are for the given position; the drawing is shown for the chosen one.",
    ),
}
NOSCRIPT = (
    "Страница рисует план сама: включите JavaScript. / The page draws the plans itself: please enable JavaScript."
)


def page(data: dict[str, Any], lang: str) -> str:
    """The whole page; ``data`` is what :func:`planes.lesson_data.lesson_data` exports."""
    words = {key: {"ru": ru, "en": en} for key, (ru, en) in WORDS.items()}
    folder = files("render") / "page"
    parts = {
        "lang": lang,
        "title": html.escape(data["title"].get(lang, "")),
        "formula": html.escape(data["formula"]),
        "css": (folder / "lesson.css").read_text("utf-8"),
        "js": (folder / "figure.js").read_text("utf-8") + (folder / "lesson.js").read_text("utf-8"),
        "frames": str(len(data["frames"])),
        "last": str(len(data["drive"]["values"]) - 1),
        "at": str(data["drive"]["at"]),
        "noscript": NOSCRIPT,
        "words": _embedded(words),
        "data": _embedded(data),
    }
    text = (folder / "lesson.html").read_text("utf-8")
    for key, value in parts.items():
        text = text.replace("{" + key + "}", value)
    return text


def _embedded(thing: object) -> str:
    """JSON that cannot end its script element."""
    return json.dumps(thing, ensure_ascii=False, separators=(",", ":"), allow_nan=False).replace("</", "<\\/")
