"""JSON Schema of the files people write: a scene, a course, a table for ``planes check``.

The keys are those of the readers, so a new key without a description stops the schema from being made. The form of
each value is in ``schema_forms.json``, its meaning in the words, for an editor to show.

In that file a form is a JSON Schema, the name of another form, or short for one: ``any`` of several forms, a ``list``,
a table whose keys are names chosen by the user (``by_name``), a ``table`` with the keys of a reader, one of a few
``words``. Keys of a table that it does not mention have the form ``*``, a number by default. Packs add their own.
"""

import json
from collections.abc import Iterable
from importlib import import_module
from pathlib import Path

from planes.check.grading.paper import COLUMN_SPELLINGS, REQUIRED_COLUMNS
from planes.course import DOCUMENTS, FORMATS
from planes.course.reading import COURSE_KEYS as COURSE_KEYS
from planes.course.reading import DRAW_KEYS, STUDENT_KEYS
from planes.scene.friction import PIN_KEYS
from planes.scene.links import FRAME_KEYS, GUIDE_KEYS, LINK_KEYS, SLIDE_KEYS
from planes.scene.load_laws import LAW_KEYS, STROKE_KEYS
from planes.scene.mechanism import LOAD_KEYS, LOAD_POINT_KEYS
from planes.scene.motion import ASSEMBLY_ORDERS, BALANCE_KEYS, DRIVE_KEYS
from planes.scene.outline import ALL_SCENE_KEYS, REQUIRED_KEYS
from planes.scene.packs import PACKS
from planes.scene.settings import SHEET_KEYS, SHEET_LIST_KEYS, SHEET_NUMBER_KEYS, SHEET_WORD_CHOICES, YES_OR_NO_KEYS
from planes.scene.vectors import VECTOR_KEYS
from planes.words import Lang, available_languages, say, sentences_with_prefix
from planes.words.names import NamesByName
from planes.words.records import Json
from planes.words.units import PLANS_WITH_MU

SCHEMA_DIALECT = "https://json-schema.org/draft/2020-12/schema"
SCHEMA_KINDS = ("scene", "course", "table")


def _forms_with_packs() -> Json:
    """The forms of ``schema_forms.json`` and of packs; a key of a scene that both have takes either form."""
    forms: Json = json.loads(Path(__file__).with_name("schema_forms.json").read_text("utf-8"))
    scene = forms["tables"]["scene"]
    for pack in PACKS.values():
        for key, form in pack.schema["tables"]["scene"].items():
            scene[key] = {"any": [scene[key], form]} if key in scene else form
        for part in ("forms", "tables", "required"):
            forms[part] = {**pack.schema[part], **forms[part]}
    return forms


_FORMS_FILE = _forms_with_packs()
_TABLE_FORMS: dict[str, Json] = _FORMS_FILE["tables"]
_TABLE_FORMS["load"] |= dict.fromkeys(LOAD_POINT_KEYS, "text")
_KEYS_OF_TABLES: dict[str, Iterable[str]] = {
    "scene": ALL_SCENE_KEYS,
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
    "plans": PLANS_WITH_MU,
    "vector": VECTOR_KEYS,
    "sheet": SHEET_KEYS,
    "course": COURSE_KEYS,
    "student": STUDENT_KEYS,
    "draw": DRAW_KEYS,
    "table": COLUMN_SPELLINGS,
}
"""The keys of tables; those of the others are in ``schema_forms.json`` alone."""
_WORDS_BY_LIST: dict[str, Iterable[object]] = {
    **SHEET_WORD_CHOICES,
    "orders": ASSEMBLY_ORDERS,
    "strokes": ASSEMBLY_ORDERS[2:],
    "langs": available_languages(),
    "documents": DOCUMENTS,
    "formats": FORMATS,
    "plans": PLANS_WITH_MU,
}
for _pack in PACKS.values():
    _KEYS_OF_TABLES |= _pack.schema["keys"]
    _WORDS_BY_LIST |= import_module(_pack.reader).WORDS_BY_LIST
_ALTERNATIVE_KEY_SETS = {"scene": REQUIRED_KEYS.values(), "table": REQUIRED_COLUMNS}
"""Sets of keys, one of which a table needs."""
_WORDS_IN_LANGUAGES: Json = {
    "type": "object",
    "properties": {lang: {"type": "string"} for lang in available_languages()},
    "additionalProperties": False,
}
_FORMS: Json = {**_FORMS_FILE["forms"], "words": {"any": ["text", _WORDS_IN_LANGUAGES]}}
_SHEET_KEY_FORMS: Json = {
    **{key: {"words": key} for key in SHEET_WORD_CHOICES},
    "positions": {"enum": [True, False, 12]},
    **dict.fromkeys(YES_OR_NO_KEYS, "boolean"),
    **dict.fromkeys(SHEET_LIST_KEYS, "entries"),
    **dict.fromkeys(SHEET_NUMBER_KEYS, "number"),
    **_TABLE_FORMS["sheet"],
}


def json_schema(kind: str, lang: Lang) -> Json:
    """The schema of "scene", "course" or "table", in a language."""
    form: Json = {"list": {"table": "table"}} if kind == "table" else {"table": kind}
    made = _Forms(sentences_with_prefix("schema_", lang, "schema")).full_form(form)
    return {"$schema": SCHEMA_DIALECT, "title": say(f"schema_{kind}", lang), **made}


class _Forms:
    """Forms in which every key of a table has a description in a language."""

    def __init__(self, meanings: NamesByName) -> None:
        self.meanings = meanings

    def full_form(self, written: str | Json) -> Json:
        """A form in full."""
        match written:
            case str():
                return self.full_form(_FORMS[written])
            case {"any": forms}:
                return {"anyOf": [*map(self.full_form, forms)]}
            case {"list": form}:
                most = {"maxItems": written["most"]} if "most" in written else {}
                return {"type": "array", "items": self.full_form(form), "minItems": written.get("least", 1), **most}
            case {"by_name": form}:
                return {"type": "object", "additionalProperties": self.full_form(form)}
            case {"table": name}:
                return self.table_schema(name)
            case {"words": name}:
                return {"enum": [*_WORDS_BY_LIST[name]]}
        return written

    def table_schema(self, name: str) -> Json:
        """A table with the keys of a reader."""
        forms: Json = _SHEET_KEY_FORMS if name == "sheet" else _TABLE_FORMS.get(name, {})
        keys = _KEYS_OF_TABLES.get(name, forms)
        required = _FORMS_FILE["required"].get(name, ())
        meant = "law" if name == "stroke" else name
        usual: str | Json = forms.get("*", "number")
        own = {key: self.key_schema(f"{meant}_{key}", forms.get(key, usual)) for key in keys}
        made = {"type": "object", "additionalProperties": False, "properties": own}
        made["required"] = [*(keys if required == "*" else required)]
        return made | (
            {"anyOf": [{"required": [*either]} for either in _ALTERNATIVE_KEY_SETS[name]]}
            if name in _ALTERNATIVE_KEY_SETS
            else {}
        )

    def key_schema(self, meaning: str, written: str | Json) -> Json:
        """One key with its description; it may be left empty."""
        form = self.full_form(written)
        kind = form.get("type")
        kinds = {"type": [*([kind] if isinstance(kind, str) else kind), "null"]} if kind else {}
        return {**form, **kinds, "description": self.meanings[meaning]}
