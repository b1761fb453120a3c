"""The lesson as one self-contained page: the exported drawings, a painter of lines between marks, no network."""

from __future__ import annotations

import html
from collections.abc import Iterator
from typing import Any

from planes.words.names import label_of
from render.page import web_page
from render.paper.letters import NAME, written

WORDS: dict[str, tuple[str, str]] = {
    "scheme": ("Схема механизма", "Scheme of the mechanism"),
    "formula": ("Формула строения", "Formula of structure"),
    "back": ("Назад", "Back"),
    "next": ("Вперёд", "Next"),
    "play": ("Показать подряд", "Play"),
    "spin": ("Вращать ведущее звено", "Turn the driver"),
    "step": ("Шаг построения", "Step of the construction"),
    "crank": ("Положение ведущего звена", "Position of the driver"),
    "home": ("Заданное положение", "Given position"),
    "ccw": ("против часовой стрелки", "counter-clockwise"),
    "cw": ("по часовой стрелке", "clockwise"),
    "still": ("звено не вращается", "the link does not turn"),
    "shifted": ("векторы одной прямой раздвинуты", "vectors of one line are drawn side by side"),
    "practise": ("Практика", "Practice"),
    "score": ("Верно с первого раза", "Right at once"),
    "over": ("Построение закончено. Верно с первого раза:", "The drawing is done. Right at once:"),
    "again": ("Сначала", "Again"),
    "right": ("Верно.", "Right."),
    "shown": ("Верный ответ построен, идём дальше.", "The right answer is drawn; on we go."),
    "or_else": ("или", "or"),
    "check": ("Проверить", "Check"),
    "list": ("Выбрать из отмеченных мест", "Choose among marked places"),
    "millimetres": ("мм", "mm"),
    "ask_known": (
        "Что известно о каждом векторе? Нажимайте: две черты — всё, одна — направление или величина, ни одной — "
        "ничего.",
        "What is known of each vector? Press: two lines — all, one — direction or length, none — nothing.",
    ),
    "ask_direction": ("Куда направлен {name} от {start}?", "Which way does {name} run from {start}?"),
    "ask_length": ("Сколько миллиметров откладываем для {name}?", "How many millimetres are laid off for {name}?"),
    "ask_line": (
        "Ищем {mark}. Какую прямую проводим через {through}?",
        "We look for {mark}. Which line goes through {through}?",
    ),
    "ask_place": ("Где {mark}? Нажмите на чертеже.", "Where is {mark}? Click on the drawing."),
    "ask_similar": (
        "Где {mark} по подобию? Нажмите на чертеже.",
        "Where is {mark} by similarity? Click on the drawing.",
    ),
    "why_known": (
        "Две черты — построенные раньше и вычисленные векторы (нормальные, кориолисовы); одна — те, у которых "
        "известна только линия действия; полный искомый вектор не подчёркивают.",
        "Two lines: vectors drawn before and calculated ones (normal, Coriolis); one line: those of which only the "
        "line of action is known; the sought whole vector has none.",
    ),
}
SCRIPTS = ("figure", "scheme", "plan", "lesson", "practice")
NOSCRIPT = (
    "Страница рисует план сама: включите JavaScript. / The page draws the plans itself: please enable JavaScript."
)


def page(data: dict[str, Any], lang: str) -> str:
    """The whole page; ``data`` is what :func:`planes.lesson.data.lesson_data` exports."""
    words = {key: {"ru": ru, "en": en} for key, (ru, en) in WORDS.items()}
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
    held = {"words": words, "data": data, "letters": written(_names(data), data["lettering"])}
    return web_page.page(title, lang, web_page.part("lesson.css"), body, code=code, data=held)


def _names(thing: Any, key: str = "") -> Iterator[str]:
    """Every name the page may letter: of marks, of vectors and values, and all that stand in its sentences."""
    if isinstance(thing, dict):
        yield from (label_of(n).lstrip("°") for n in thing if key == "marks")
        for one, inside in thing.items():
            yield from _names(inside, one)
    elif isinstance(thing, str):
        yield from NAME.findall(thing)
        if key in ("name", "names", "terms", "action", "fixed"):
            yield thing.lstrip("+-" if key == "action" else "")
    elif isinstance(thing, (list, tuple)) and key not in ("marks", "turned", "values"):
        for inside in thing:
            yield from _names(inside, key)
