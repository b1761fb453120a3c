"""The lesson as one self-contained page: the exported drawings, a painter of lines between marks, no network."""

import html
from collections.abc import Iterator

from planes.lesson.formulas import in_both
from planes.words import langs, stand_ins, table, under
from planes.words.names import lettered
from planes.words.records import Json
from render.page import packer, web_page
from render.paper.letters import NAME, written

SHARED = {key: key for key in ("scheme", "space_diagram", "formula", "nearest")} | {
    key: f"lesson_{key}"
    for key in ("ccw", "cw", "still", "zone_bad", "still_velocity", "still_acceleration", "still_special")
}
"""Words of the page from other tables."""
NOSCRIPT = (
    "Страница рисует план сама: включите JavaScript. / The page draws the plans itself: please enable JavaScript."
)


def page(data: Json, lang: str, given: str = "") -> str:
    """The whole page; for a platform with the ``given`` data (HTML), and a report of its score.

    ``data`` is the result of :func:`planes.lesson.data.lesson_data`.
    """
    section = given and f'<section id="given">{given}</section>\n'
    return _whole(data, lang, "lesson", ("lesson", *["scorm"] * bool(given)), section)


def living_page(lang: str) -> str:
    """The page without a lesson: it shows the lesson of its host page, ``planes.lesson``."""
    return _whole(None, lang, "lesson", ("lesson",))


def letters_of(data: Json) -> Json:
    """The lettering of every name in a lesson, by language."""
    return written(_names(data), data["lettering"])


def essay_page(data: Json, lang: str) -> str:
    """A page of the essay, from the data of :func:`planes.lesson.essay.essay_data`."""
    return _whole(data, lang, "essay", ("essay",))


def _whole(data: Json | None, lang: str, name: str, modules: tuple[str, ...], given: str = "") -> str:
    """A page with the template of its name, its data and its modules."""
    modules += ("centres",) * bool((data or {}).get("centres"))
    page_words = in_both(
        lambda tongue: under("page_", tongue, "pages") | {key: table(tongue)[name] for key, name in SHARED.items()}
    )
    lang = next(one for one in stand_ins(lang) if one in langs("lesson"))
    title = data["title"].get(lang, "") if data else ""
    parts = {"given": given, "title": html.escape(title), "noscript": NOSCRIPT}
    body = web_page.filled(f"{name}.html", parts)
    sheets = {"lesson": ("practice.css", "lesson.css"), "essay": ("lesson.css", "essay.css")}
    held = {"brought": [page_words, data], "letters": data and letters_of(data)}
    return web_page.page(title, lang, sheets[name], body, code=packer.packed(*modules), data=held, small=True)


def _names(thing: object, key: str = "") -> Iterator[str]:
    """Every name the page may letter: of marks, of vectors and values, and all in its sentences."""
    if isinstance(thing, dict):
        yield from (lettered(n) for n in thing if key == "marks")
        for one, inside in thing.items():
            yield from _names(inside, one)
    elif isinstance(thing, str):
        yield from NAME.findall(thing)
        if key in ("name", "names", "terms", "action", "fixed", "of", "arm"):
            yield thing.lstrip("+-" if key == "action" else "")
    elif isinstance(thing, (list, tuple)) and key not in ("marks", "turned", "values"):
        for inside in thing:
            yield from _names(inside, key)
