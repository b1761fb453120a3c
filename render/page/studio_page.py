"""The page of the studio, and the carrier of its messages: the answers of ``planes.studio`` with the lettering to show
them.

Needs neither numpy nor the paper drawing code: a browser's worker runs it unchanged.
"""

import json

from planes.studio.answers import answer
from planes.words import langs, stand_ins, table, under
from planes.words.records import Json
from render.page import packer, web_page
from render.page.lesson_page import NOSCRIPT, letters_of, living_page

ALLOWED = "connect-src 'self'; frame-src 'self' blob:; worker-src 'self'; font-src data:; "
"""The studio's other requests: its server or folder, the lesson in a frame, the worker."""


FILES = {
    "sheet.pdf": ("sheet",),
    "sheet.svg": ("sheet",),
    "sheet.dxf": ("sheet",),
    "sheet.png": ("sheet",),
    "lesson.html": ("lesson",),
    "note.pdf": ("note",),
    "note.docx": ("note",),
    "blank.pdf": ("blank", "--plan", "velocity"),
    "cycle.csv": ("cycle",),
    "turn.svg": ("cycle", "--film"),
    "plan.ggb": ("sheet",),
    "plan.tex": ("sheet",),
}
"""The downloads, each with its command: those of ``cycle`` are for a mechanism only."""


def answered(message: Json) -> Json:
    """The answer to one message; a lesson includes the lettering of its names."""
    reply = answer(message)
    return {**reply, "letters": letters_of(reply["data"])} if "data" in reply else reply


def written(message: Json) -> str:
    """The answer to one message, as JSON."""
    return web_page.compact_json(answered(message))


def carried(text: str) -> str:
    """A message and its answer, both as JSON: the interface of a worker."""
    return written(json.loads(text))


def studio_page(lang: str, way: Json, first: str = "") -> str:
    """The page; ``way`` says who answers: ``{"kind": "server" | "worker" | "none", "address": …, "native": …}``,
    ``first`` is the text of the first scene."""
    words = {
        tongue: {**under("studio_", tongue, "studio"), "language": table(tongue)["language_name"]}
        for tongue in langs("studio")
    }
    lang = next(one for one in stand_ins(lang) if one in words)
    body = web_page.filled("studio.html", {"noscript": NOSCRIPT})
    data = {"words": words, "way": way, "first": first, "takeaway": FILES}
    style = "lesson.css", "studio.css"
    return web_page.page("planes", lang, style, body, code=packer.packed("studio"), data=data, allowed=ALLOWED)


def files_of(lang: str, way: Json, first: str = "") -> dict[str, bytes]:
    """The files of the studio, by name."""
    pages = {"index.html": studio_page(lang, way, first), "lesson.html": living_page(lang)}
    return {name: text.encode() for name, text in (pages | {"worker.js": packer.packed("worker")}).items()}
