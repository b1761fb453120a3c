"""The one message of the studio, and its answers: a carrier delivers plain data and takes back plain data.

``{id, ask, text, lang, …}`` → ``{id, …, problems}``: ``ask`` is "lesson" (frames, tape, scheme; ``all``: its practice
too), "practice" (the slow part of a lesson: the catalogue of mistakes, and a tape with their places), "numbers" (some
were changed by hand), "sketch" (a mechanism as drawn), "drawn" (a sketch has changed), "rename" (a point or a link),
"put", "append", "leave out" (a part of the text).
"""

from collections.abc import Callable
from difflib import SequenceMatcher
from typing import Any

from planes.lesson.data import lesson_data, practice_data
from planes.scene import loads
from planes.studio.message_shapes import checked_message
from planes.studio.numbers_back import text_with_numbers
from planes.studio.renaming import text_with_renamed_part
from planes.studio.sketch_texts import Unfinished, assembly_offers, text_of_changed_sketch
from planes.studio.sketches import sketch_of
from planes.studio.text_edits import SCENE_FILE_NAME, Edited
from planes.words import Lang, Phrase, available_languages, say
from planes.words.errors import PlanesError, SceneError
from planes.words.records import Json

MOST_SCENE_LETTERS = 200_000  # longest scene, in letters
MISSING_PART_SENTENCES = ("part_missing", "part_empty")
TOOLS_BY_MISSING_PART = {"frame": "fix", "links": "link", "drive": "drive"}
"""Sentences about what a mechanism lacks, and the tool of the canvas that draws it."""


def answer_to_message(message: Json) -> Json:
    """The answer to a message; errors of the text are in its ``problems``."""
    text = str(message.get("text", ""))[:MOST_SCENE_LETTERS]
    lang = message_lang(message)
    act = ANSWERS_BY_MESSAGE_KIND.get(str(message.get("ask")))
    own: Json = {"id": message.get("id"), "ask": message.get("ask"), "problems": []}
    if act is None:
        return {**own, "problems": [_plain_problem("studio_unknown", lang)]}
    try:
        return {**own, **act(text, checked_message(message))}
    except PlanesError as error:
        more = {"text": error.text} if isinstance(error, Unfinished) else {}
        return {**own, **more, "problems": [problem_report(error, more.get("text", text), lang)]}
    except ImportError as error:
        return {**own, "problems": [_plain_problem("studio_needs", lang, name=error.name)]}


def _plain_problem(key: str, lang: Lang, **parts: object) -> Json:
    return {"line": 1, "said": say(key, lang, **parts), "help": []}


def message_lang(message: Json) -> Lang:
    """The language of a message; English where it names none."""
    said = message.get("lang")
    if isinstance(said, str) and said in available_languages():
        return said
    return "en"


def problem_report(error: PlanesError, text: str, lang: Lang) -> Json:
    """An error: its line and column, the sentence, and the corrections, each as a part to be put into the text."""
    line = getattr(error, "line", None) or 1
    said = error.phrase.told(lang) if isinstance(error.phrase, Phrase) else str(error.phrase)
    report: Json = {"line": line, "column": 1, "said": said, "help": []}
    parts = error.phrase_parts
    row = "".join(text.splitlines()[line - 1 : line])
    valid = _valid_names(parts)
    quoted = [str(part) for part in parts.values() if isinstance(part, str) and part and part in row]
    if quoted:
        meant = max(quoted, key=lambda part: max((name_similarity(part, name) for name in valid), default=0.0))
        report["column"] = row.rindex(meant) + 1
        report["help"] = [{"label": name, "from": meant, "to": name} for name in valid]
    if (
        isinstance(error.phrase, Phrase)
        and error.phrase.key in MISSING_PART_SENTENCES
        and (act := TOOLS_BY_MISSING_PART.get(str(parts.get("key", ""))))
    ):
        report["help"].append({"label": say(f"studio_add_{act}", lang), "act": act})
    if isinstance(error, SceneError):
        report["help"] += [_assembly_offer(text, path, value) for path, value in assembly_offers(error)]
    return report


def name_similarity(one: str, other: str) -> float:
    """The similarity of two names, 0 to 1."""
    return SequenceMatcher(None, one, other).ratio()


def _valid_names(parts: dict[str, object]) -> list[str]:
    """The valid names, the nearest first."""
    valid = parts.get("valid")
    offered = valid.parts if isinstance(valid, Phrase) else {}
    near = [one.parts["name"] for one in (offered.get("near"),) if isinstance(one, Phrase)]
    names = offered.get("names")
    return [*dict.fromkeys(map(str, (*near, *(names if isinstance(names, tuple) else ()))))][:6]


def _assembly_offer(text: str, path: tuple[str, ...], value: str) -> Json:
    """One of several assemblies, with its picture."""
    own: Json = {"label": f"{path[-1]}: {value}", "path": path, "value": value}
    try:
        return {**own, "sketch": sketch_of(loads(Edited(text).with_value(path, value).text))}
    except PlanesError:
        return own


def _lesson_answer(text: str, message: Json) -> Json:
    scene = loads(text, SCENE_FILE_NAME)
    lang = message_lang(message)
    plain: Json = {"column": 1, "help": [], "doubt": True}
    doubts = [{**plain, "line": d.line, "said": d.phrase.told(lang)} for d in scene.doubts]
    return {"data": lesson_data(scene, practice=bool(message.get("all"))), "problems": doubts}


def _edited_answer(edited: Edited) -> Json:
    return {"text": edited.text, "lines": edited.lines}


def _drawn_answer(edited: Edited) -> Json:
    """A text for a changed sketch, and the sketch with the numbers that were written."""
    return {**_edited_answer(edited), "sketch": sketch_of(loads(edited.text, SCENE_FILE_NAME))}


def _message_path(message: Json) -> tuple[str, ...]:
    return tuple(map(str, message["path"]))


ANSWERS_BY_MESSAGE_KIND: dict[str, Callable[[str, Json], dict[str, Any]]] = {
    "lesson": _lesson_answer,
    "numbers": lambda text, m: _edited_answer(text_with_numbers(text, m["numbers"], m.get("said") or {})),
    "practice": lambda text, _: {"data": practice_data(loads(text, SCENE_FILE_NAME))},
    "sketch": lambda text, _: {"sketch": sketch_of(loads(text, SCENE_FILE_NAME))},
    "drawn": lambda text, m: _drawn_answer(text_of_changed_sketch(text, m["sketch"], m.get("was"))),
    "rename": lambda text, m: _edited_answer(text_with_renamed_part(text, m["path"][0], m["path"][-1], m["value"])),
    "put": lambda text, m: _edited_answer(Edited(text).with_value(_message_path(m), str(m["value"]))),
    "append": lambda text, m: _edited_answer(Edited(text).with_item(_message_path(m), str(m["value"]))),
    "leave out": lambda text, m: _edited_answer(Edited(text).without_key(_message_path(m))),
}
"""The kinds of messages, by name."""
