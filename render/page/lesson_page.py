"""The lesson as one self-contained page: the exported drawings, a painter of lines between marks, no network."""

import html
from collections.abc import Iterator

from planes.lesson.formulas import in_lesson_languages
from planes.words import available_languages, fallback_languages, sentence_table, sentences_with_prefix
from planes.words.names import NameTuple, name_without_plan
from planes.words.records import Json
from render.page import packer, web_page
from render.paper.letters import BRACKETED_NAME_PATTERN, names_for_script

SHARED_WORD_KEYS = {key: key for key in ("scheme", "space_diagram", "formula", "nearest")} | {
    key: f"lesson_{key}"
    for key in ("ccw", "cw", "still", "zone_bad", "still_velocity", "still_acceleration", "still_special")
}
"""Words of the page from other tables."""
NOSCRIPT_TEXT = (
    "Страница рисует план сама: включите JavaScript. / The page draws the plans itself: please enable JavaScript."
)


def whole_lesson_page(data: Json, lang: str, given: str = "") -> str:
    """The whole page; for a platform with the ``given`` data (HTML), and a report of its score.

    ``data`` is the result of :func:`planes.lesson.data.lesson_data`.
    """
    section = given and f'<section id="given">{given}</section>\n'
    return _fill_page(data, lang, "lesson", ("lesson", *["scorm"] * bool(given)), section)


def hosted_lesson_page(lang: str) -> str:
    """The page without a lesson: it shows the lesson of its host page, ``planes.lesson``."""
    return _fill_page(None, lang, "lesson", ("lesson",))


def lesson_lettering(data: Json) -> Json:
    """The lettering of every name in a lesson, by language."""
    return names_for_script(_names_to_letter(data), data["lettering"])


def essay_page(data: Json, lang: str) -> str:
    """A page of the essay, from the data of :func:`planes.lesson.essay.data_of_essay_pages`."""
    return _fill_page(data, lang, "essay", ("essay",))


def _fill_page(data: Json | None, lang: str, name: str, modules: NameTuple, given: str = "") -> str:
    """A page with the template of its name, its data and its modules."""
    modules += ("centres",) * bool((data or {}).get("centres"))
    page_words = in_lesson_languages(
        lambda tongue: (
            sentences_with_prefix("page_", tongue, "pages")
            | {key: sentence_table(tongue)[name] for key, name in SHARED_WORD_KEYS.items()}
        )
    )
    lang = next(one for one in fallback_languages(lang) if one in available_languages("lesson"))
    title = data["title"].get(lang, "") if data else ""
    parts = {"given": given, "title": html.escape(title), "noscript": NOSCRIPT_TEXT}
    body = web_page.fill_template(f"{name}.html", parts)
    sheets = {"lesson": ("practice.css", "lesson.css"), "essay": ("lesson.css", "essay.css")}
    held = {"brought": [page_words, data], "letters": data and lesson_lettering(data)}
    return web_page.fill_web_page(
        title, lang, sheets[name], body, code=packer.pack_modules(*modules), data=held, small=True
    )


def _names_to_letter(thing: object, key: str = "") -> Iterator[str]:
    """Every name the page may letter: of marks, of vectors and values, and all in its sentences."""
    if isinstance(thing, dict):
        yield from (name_without_plan(n) for n in thing if key == "marks")
        for one, inside in thing.items():
            yield from _names_to_letter(inside, one)
    elif isinstance(thing, str):
        yield from BRACKETED_NAME_PATTERN.findall(thing)
        if key in ("name", "names", "terms", "action", "fixed", "of", "arm"):
            yield thing.lstrip("+-" if key == "action" else "")
    elif isinstance(thing, (list, tuple)) and key not in ("marks", "turned", "values"):
        for inside in thing:
            yield from _names_to_letter(inside, key)
