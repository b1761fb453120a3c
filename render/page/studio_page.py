"""The page of the studio, and the carrier of its messages: the answers of ``planes.studio`` with the lettering to show
them.

Needs neither numpy nor the paper drawing code: a browser's worker runs it unchanged.
"""

import json

from planes.studio.answers import answer_to_message
from planes.words import available_languages, fallback_languages, sentence_table, sentences_with_prefix
from planes.words.records import Json
from render.page import packer, web_page
from render.page.lesson_page import NOSCRIPT_TEXT, hosted_lesson_page, lesson_lettering

STUDIO_PERMISSIONS = "connect-src 'self'; frame-src 'self' blob:; worker-src 'self'; font-src data:; "
"""The studio's other requests: its server or folder, the lesson in a frame, the worker."""


COMMAND_OF_DOWNLOAD = {
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


def answer_message(message: Json) -> Json:
    """The answer to one message; a lesson includes the lettering of its names."""
    reply = answer_to_message(message)
    if "data" in reply:
        return {**reply, "letters": lesson_lettering(reply["data"])}
    return reply


def answer_as_json(message: Json) -> str:
    """The answer to one message, as JSON."""
    return web_page.compact_json(answer_message(message))


def carried(text: str) -> str:
    """A message and its answer, both as JSON: the interface of a worker."""
    return answer_as_json(json.loads(text))


def studio_page(lang: str, way: Json, first: str = "") -> str:
    """The page; ``way`` says who answers: ``{"kind": "server" | "worker" | "none", "address": …, "native": …}``,
    ``first`` is the text of the first scene."""
    words = {
        tongue: {
            **sentences_with_prefix("studio_", tongue, "studio"),
            "language": sentence_table(tongue)["language_name"],
        }
        for tongue in available_languages("studio")
    }
    lang = next(one for one in fallback_languages(lang) if one in words)
    body = web_page.fill_template("studio.html", {"noscript": NOSCRIPT_TEXT})
    data = {"words": words, "way": way, "first": first, "takeaway": COMMAND_OF_DOWNLOAD}
    style = "lesson.css", "studio.css"
    return web_page.fill_web_page(
        "planes", lang, style, body, code=packer.pack_modules("studio"), data=data, allowed=STUDIO_PERMISSIONS
    )


def studio_files(lang: str, way: Json, first: str = "") -> dict[str, bytes]:
    """The files of the studio, by name."""
    pages = {"index.html": studio_page(lang, way, first), "lesson.html": hosted_lesson_page(lang)}
    return {name: text.encode() for name, text in (pages | {"worker.js": packer.pack_modules("worker")}).items()}
