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
from planes.studio.message_shapes import checked
from planes.studio.numbers_back import with_numbers
from planes.studio.renaming import renamed
from planes.studio.sketch_texts import Unfinished, drawn, offers_of
from planes.studio.sketches import sketch_of
from planes.studio.text_edits import FILE, Edited
from planes.words import Lang, Phrase, langs, say
from planes.words.errors import PlanesError, SceneError
from planes.words.records import Json

LONGEST = 200_000  # longest scene, in letters
LACKS, TOOLS = ("part_missing", "part_empty"), {"frame": "fix", "links": "link", "drive": "drive"}
"""Sentences about what a mechanism lacks, and the tool of the canvas that draws it."""


def answer(message: Json) -> Json:
    """The answer to a message; errors of the text are in its ``problems``."""
    text, lang = str(message.get("text", ""))[:LONGEST], lang_of(message)
    act = ACTS.get(str(message.get("ask")))
    own: Json = {"id": message.get("id"), "ask": message.get("ask"), "problems": []}
    if act is None:
        return {**own, "problems": [_plain("studio_unknown", lang)]}
    try:
        return {**own, **act(text, checked(message))}
    except PlanesError as error:
        more = {"text": error.text} if isinstance(error, Unfinished) else {}
        return {**own, **more, "problems": [problem(error, more.get("text", text), lang)]}
    except ImportError as error:
        return {**own, "problems": [_plain("studio_needs", lang, name=error.name)]}


def _plain(key: str, lang: Lang, **parts: object) -> Json:
    return {"line": 1, "said": say(key, lang, **parts), "help": []}


def lang_of(message: Json) -> Lang:
    """The language of a message; English where it names none."""
    said = message.get("lang")
    return said if isinstance(said, str) and said in langs() else "en"


def problem(error: PlanesError, text: str, lang: Lang) -> Json:
    """An error: its line and column, the sentence, and the corrections, each as a part to be put into the text."""
    line = getattr(error, "line", None) or 1
    said = error.phrase.told(lang) if isinstance(error.phrase, Phrase) else str(error.phrase)
    report: Json = {"line": line, "column": 1, "said": said, "help": []}
    parts = error.parts
    row = "".join(text.splitlines()[line - 1 : line])
    valid = _valid(parts)
    quoted = [str(part) for part in parts.values() if isinstance(part, str) and part and part in row]
    if quoted:
        meant = max(quoted, key=lambda part: max((alike(part, name) for name in valid), default=0.0))
        report["column"] = row.rindex(meant) + 1
        report["help"] = [{"label": name, "from": meant, "to": name} for name in valid]
    if isinstance(error.phrase, Phrase) and error.phrase.key in LACKS and (act := TOOLS.get(str(parts.get("key", "")))):
        report["help"].append({"label": say(f"studio_add_{act}", lang), "act": act})
    if isinstance(error, SceneError):
        report["help"] += [_offer(text, path, value) for path, value in offers_of(error)]
    return report


def alike(one: str, other: str) -> float:
    """The similarity of two names, 0 to 1."""
    return SequenceMatcher(None, one, other).ratio()


def _valid(parts: dict[str, object]) -> list[str]:
    """The valid names, the nearest first."""
    valid = parts.get("valid")
    offered = valid.parts if isinstance(valid, Phrase) else {}
    near = [one.parts["name"] for one in (offered.get("near"),) if isinstance(one, Phrase)]
    names = offered.get("names")
    return [*dict.fromkeys(map(str, (*near, *(names if isinstance(names, tuple) else ()))))][:6]


def _offer(text: str, path: tuple[str, ...], value: str) -> Json:
    """One of several assemblies, with its picture."""
    own: Json = {"label": f"{path[-1]}: {value}", "path": path, "value": value}
    try:
        return {**own, "sketch": sketch_of(loads(Edited(text).put(path, value).text))}
    except PlanesError:
        return own


def _lesson(text: str, message: Json) -> Json:
    scene = loads(text, FILE)
    lang = lang_of(message)
    plain: Json = {"column": 1, "help": [], "doubt": True}
    doubts = [{**plain, "line": d.line, "said": d.phrase.told(lang)} for d in scene.doubts]
    return {"data": lesson_data(scene, practice=bool(message.get("all"))), "problems": doubts}


def _edited(edited: Edited) -> Json:
    return {"text": edited.text, "lines": edited.lines}


def _drawn(edited: Edited) -> Json:
    """A text for a changed sketch, and the sketch with the numbers that were written."""
    return {**_edited(edited), "sketch": sketch_of(loads(edited.text, FILE))}


def _path(message: Json) -> tuple[str, ...]:
    return tuple(map(str, message["path"]))


ACTS: dict[str, Callable[[str, Json], dict[str, Any]]] = {
    "lesson": _lesson,
    "numbers": lambda text, m: _edited(with_numbers(text, m["numbers"], m.get("said") or {})),
    "practice": lambda text, _: {"data": practice_data(loads(text, FILE))},
    "sketch": lambda text, _: {"sketch": sketch_of(loads(text, FILE))},
    "drawn": lambda text, m: _drawn(drawn(text, m["sketch"], m.get("was"))),
    "rename": lambda text, m: _edited(renamed(text, m["path"][0], m["path"][-1], m["value"])),
    "put": lambda text, m: _edited(Edited(text).put(_path(m), str(m["value"]))),
    "append": lambda text, m: _edited(Edited(text).appended(_path(m), str(m["value"]))),
    "leave out": lambda text, m: _edited(Edited(text).without(_path(m))),
}
"""The kinds of messages, by name."""
