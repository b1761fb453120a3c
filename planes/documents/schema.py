"""JSON Schema of the files people write: a scene, a course, a table for ``planes check``.

The keys are those of the readers, so a new key without a description stops the schema from being made. The form of
each value is in ``schema_forms.json``, its meaning in the words, for an editor to show.

In that file a form is a JSON Schema, the name of another form, or short for one: ``any`` of several forms, a ``list``,
a table whose keys are names chosen by the user (``by_name``), a ``table`` with the keys of a reader, one of a few
``words``. Keys of a table that it does not mention have the form ``*``, a number by default.
"""

import json
from collections.abc import Iterable, Mapping
from pathlib import Path

from planes.check.grading.paper import COLUMNS, TABLES
from planes.course import DOCUMENTS, FORMATS
from planes.course.reading import DRAW_KEYS, STUDENT_KEYS
from planes.course.reading import KEYS as COURSE_KEYS
from planes.crank_slider.given import UNITS
from planes.crank_slider.parts import STEELS
from planes.crank_slider.reading_table import INDICATOR
from planes.crank_slider.reading_table import KEYS as CRANK_SLIDER_KEYS
from planes.scene.friction import PIN_KEYS
from planes.scene.links import FRAME_KEYS, GUIDE_KEYS, LINK_KEYS, SLIDE_KEYS
from planes.scene.load_laws import LAW_KEYS, STROKE_KEYS
from planes.scene.motion import BALANCE_KEYS, DRIVE_KEYS, LOAD_KEYS, ORDERS
from planes.scene.outline import KEYS, NEEDED
from planes.scene.settings import SHEET_KEYS, SHEET_LISTS, SHEET_NUMBERS, SHEET_WORDS, YES_OR_NO
from planes.scene.structures import METHODS, POLE_KEYS, STATIC_LOAD_KEYS, SUPPORT_KEYS, SUPPORT_KINDS
from planes.scene.vectors import VECTOR_KEYS
from planes.words import Lang, langs, say, under
from planes.words.records import Json
from planes.words.units import PLANS

DIALECT = "https://json-schema.org/draft/2020-12/schema"
KINDS = ("scene", "course", "table")
_WRITTEN: Json = json.loads(Path(__file__).with_name("schema_forms.json").read_text("utf-8"))
_TABLES: dict[str, Json] = _WRITTEN["tables"]
_READ: Mapping[str, Iterable[str]] = {
    **CRANK_SLIDER_KEYS,
    "indicator": INDICATOR,
    "scene": KEYS,
    "frame": FRAME_KEYS,
    "guide": GUIDE_KEYS,
    "link": LINK_KEYS,
    "slide": SLIDE_KEYS,
    "drive": DRIVE_KEYS,
    "balance": BALANCE_KEYS,
    "load": LOAD_KEYS,
    "law": LAW_KEYS,
    "stroke": STROKE_KEYS,
    "pin": PIN_KEYS,
    "plans": PLANS,
    "vector": VECTOR_KEYS,
    "support": SUPPORT_KEYS,
    "static_load": STATIC_LOAD_KEYS,
    "pole": POLE_KEYS,
    "sheet": SHEET_KEYS,
    "course": COURSE_KEYS,
    "student": STUDENT_KEYS,
    "draw": DRAW_KEYS,
    "table": COLUMNS,
}
"""The keys of tables; those of the others are in ``schema_forms.json`` alone."""
_WORDS: Mapping[str, Iterable[object]] = {
    **SHEET_WORDS,
    "orders": ORDERS,
    "strokes": ORDERS[2:],
    "supports": SUPPORT_KINDS,
    "methods": METHODS,
    "units": UNITS,
    "steels": (*STEELS, *(int(s) for s in STEELS if s.isdigit())),
    "langs": langs(),
    "documents": DOCUMENTS,
    "formats": FORMATS,
    "plans": PLANS,
}
_EITHER = {"scene": NEEDED.values(), "table": TABLES}
"""Sets of keys, one of which a table needs."""
_WORDS_IN_LANGUAGES: Json = {
    "type": "object",
    "properties": {lang: {"type": "string"} for lang in langs()},
    "additionalProperties": False,
}
_FORMS: Json = {**_WRITTEN["forms"], "words": {"any": ["text", _WORDS_IN_LANGUAGES]}}
_SHEET: Json = {
    **{key: {"words": key} for key in SHEET_WORDS},
    "positions": {"enum": [True, False, 12]},
    **dict.fromkeys(YES_OR_NO, "boolean"),
    **dict.fromkeys(SHEET_LISTS, "entries"),
    **dict.fromkeys(SHEET_NUMBERS, "number"),
    **_TABLES["sheet"],
}


def schema(kind: str, lang: Lang) -> Json:
    """The schema of "scene", "course" or "table", in a language."""
    form: Json = {"list": {"table": "table"}} if kind == "table" else {"table": kind}
    made = _Forms(under("schema_", lang, "schema")).form(form)
    return {"$schema": DIALECT, "title": say(f"schema_{kind}", lang), **made}


class _Forms:
    """Forms in which every key of a table has a description in a language."""

    def __init__(self, meanings: Mapping[str, str]) -> None:
        self.meanings = meanings

    def form(self, written: str | Json) -> Json:
        """A form in full."""
        match written:
            case str():
                return self.form(_FORMS[written])
            case {"any": forms}:
                return {"anyOf": [*map(self.form, forms)]}
            case {"list": form}:
                most = {"maxItems": written["most"]} if "most" in written else {}
                return {"type": "array", "items": self.form(form), "minItems": written.get("least", 1), **most}
            case {"by_name": form}:
                return {"type": "object", "additionalProperties": self.form(form)}
            case {"table": name}:
                return self.table(name)
            case {"words": name}:
                return {"enum": [*_WORDS[name]]}
        return written

    def table(self, name: str) -> Json:
        """A table with the keys of a reader."""
        forms: Json = _SHEET if name == "sheet" else _TABLES.get(name, {})
        keys, required = _READ.get(name, forms), _WRITTEN["required"].get(name, ())
        meant = "law" if name == "stroke" else name
        usual: str | Json = forms.get("*", "number")
        own = {key: self.key(f"{meant}_{key}", forms.get(key, usual)) for key in keys}
        made = {"type": "object", "additionalProperties": False, "properties": own}
        made["required"] = [*(keys if required == "*" else required)]
        return made | ({"anyOf": [{"required": [*either]} for either in _EITHER[name]]} if name in _EITHER else {})

    def key(self, meaning: str, written: str | Json) -> Json:
        """One key with its description; it may be left empty."""
        form = self.form(written)
        kind = form.get("type")
        kinds = {"type": [*([kind] if isinstance(kind, str) else kind), "null"]} if kind else {}
        return {**form, **kinds, "description": self.meanings[meaning]}
