"""What the cells of the title block say, from the ``sheet`` section of a scene."""

from __future__ import annotations

from planes.scene import Scene
from planes.words import Lang, say
from render.paper.form1 import BESIDE
from render.paper.numbers import decimal

_PEOPLE = ("teacher", "tech", "person", "checked", "approved")
_SAME = (
    *("student", "role", "material", "mass", "copied", *_PEOPLE),
    *(f"{person}_date" for person in _PEOPLE),
    *BESIDE,
)
"""Keys of the scene that are names of cells."""


def cells(scene: Scene, lang: Lang, number: int | None = None) -> dict[str, str]:
    """Texts of the cells of form 1 by name; ``number`` is that of a sheet of a project of two."""
    given = scene.sheet
    said = {key: _text(value, lang) for key, value in given.items()}
    found = {key: said[key] for key in _SAME if key in said}
    found["student_date"] = said.get("date", "")
    found["title"] = said.get("title") or scene.title.get(lang, "")
    if number and "title" not in said:
        found["title"] += f". {say(f'sheet_{number}', lang)}"
    found["designation"] = said.get("designation") or said.get("number", "")
    company = [said.get(key, "") for key in ("company", "university", "department", "group")]
    found["company"] = " ".join(text for text in company if text)
    found["scale"] = said.get("scale_note", "")
    found["sheet"] = said.get("sheet", str(number or ""))
    found["sheets"] = said.get("sheets", "2" if number else "1")
    return {**found, **_letters(given.get("letter"), lang), **_revisions(given.get("revisions"), lang)}


def _text(value: object, lang: Lang) -> str:
    return decimal(f"{value:g}", lang) if isinstance(value, float) else str(value)


def _letters(given: object, lang: Lang) -> dict[str, str]:
    """Graph 4, filled from its left cell on."""
    letters = given if isinstance(given, list) else str(given or "").split()
    return {f"letter_{k + 1}": _text(letter, lang) for k, letter in enumerate(letters)}


def _revisions(given: object, lang: Lang) -> dict[str, str]:
    """Graphs 14–18, from the lowest row up."""
    found: dict[str, str] = {}
    for k, row in enumerate(given if isinstance(given, list) else ()):
        found |= {f"revision_{k + 1}_{column}": _text(text, lang) for column, text in row.items()}
    return found
