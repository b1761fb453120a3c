"""The lesson as one self-contained page: the exported drawings, a painter of lines between marks, no network."""

import html
import json
from collections.abc import Iterator

from planes.lesson.frame import LANGS, in_both
from planes.words import langs, stand_ins, table, under
from planes.words.names import lettered
from planes.words.records import Json
from render.page import web_page
from render.paper.letters import NAME, written

SHARED = {key: key for key in ("scheme", "formula", "shifted", "nearest")} | {
    key: f"lesson_{key}" for key in ("ccw", "cw", "still", "zone_bad")
}
"""Words of the page that stand in other tables."""
SCRIPTS = ("tape", "figure", "scheme", "plan", "live", "words", "handout", "lesson", "hands", "practice")
MARKS = "⟨⟩⟦⟧¦"
"""What stands about names and numbers in sentences."""
NOSCRIPT = (
    "Страница рисует план сама: включите JavaScript. / The page draws the plans itself: please enable JavaScript."
)


def page(data: Json, lang: str, scored: bool = False) -> str:
    """The whole page; one that is ``scored`` tells a platform its score.

    ``data`` is what :func:`planes.lesson.data.lesson_data` exports.
    """
    told = in_both(lambda of: under("page_", of, "pages") | {key: table(of)[name] for key, name in SHARED.items()})
    words = {key: {of: one[key] for of, one in told.items()} for key in told["en"]}
    lang = next(one for one in stand_ins(lang) if one in langs("lesson"))
    title = data["title"].get(lang, "")
    parts = {
        "title": html.escape(title),
        "formula": html.escape(data["formula"]),
        "frames": str(len(data["frames"])),
        **{key: str(data["drive"][key]) for key in ("from", "to", "at")},
        "by": str((data["drive"]["to"] - data["drive"]["from"]) / 360),
        "noscript": NOSCRIPT,
    }
    body = web_page.filled(web_page.part("lesson.html"), parts)
    code = web_page.part(*(f"{name}.js" for name in (*SCRIPTS, *(("scorm",) if scored else ()))))
    once = {'""': 0}
    held = {"words": words, "data": _once(data, once), "letters": written(_names(data), data["lettering"])}
    held["sentences"] = _short(list(once))
    return web_page.page(title, lang, web_page.part("lesson.css"), body, code=code, data=held)


def _short(sentences: list[str]) -> list[object]:
    """The sentences, with the marks of names and numbers, three bytes each, written by signs of one byte that no
    sentence has; the first is these signs."""
    free = [sign for sign in "~@$#`^?;|" if not any(sign in text for text in sentences)]
    signs = "".join(free[: len(MARKS)]) if len(free) >= len(MARKS) else MARKS
    return [signs, *(json.loads(text.translate(str.maketrans(MARKS, signs))) for text in sentences[1:])]


def _once(thing: object, told: dict[str, int]) -> object:
    """The same with every sentence in all languages but once, in ``told``: its place there stands for it."""
    if isinstance(thing, dict):
        if set(thing) == {*LANGS} and any(thing.values()):
            return {"=": told.setdefault(json.dumps(thing, ensure_ascii=False), len(told))}
        return {key: _once(inside, told) for key, inside in thing.items()}
    return [_once(inside, told) for inside in thing] if isinstance(thing, (list, tuple)) else thing


def _names(thing: object, key: str = "") -> Iterator[str]:
    """Every name the page may letter: of marks, of vectors and values, and all that stand in its sentences."""
    if isinstance(thing, dict):
        yield from (lettered(n) for n in thing if key == "marks")
        for one, inside in thing.items():
            yield from _names(inside, one)
    elif isinstance(thing, str):
        yield from NAME.findall(thing)
        if key in ("name", "names", "terms", "action", "fixed", "of"):
            yield thing.lstrip("+-" if key == "action" else "")
    elif isinstance(thing, (list, tuple)) and key not in ("marks", "turned", "values"):
        for inside in thing:
            yield from _names(inside, key)
