"""JSON Schema of the files people write: a scene, a course, a table for ``planes check``.

The keys are those of the readers, so a new key without a description stops the schema from being made. The meaning of
each key is in the words, for an editor to show.
"""

from collections.abc import Iterable, Mapping

from planes.check.grading.paper import COLUMNS, TABLES
from planes.course import DOCUMENTS, FORMATS
from planes.course.reading import DRAW_KEYS, STUDENT_KEYS
from planes.course.reading import KEYS as COURSE_KEYS
from planes.crank_slider.given import FOUR, UNITS
from planes.crank_slider.parts import STEELS
from planes.crank_slider.reading import KEYS as CRANK_SLIDER_KEYS
from planes.crank_slider.reading_table import INDICATOR
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
TEXT: Json = {"type": "string"}
NAME: Json = {"type": ["string", "integer"]}
NUMBER: Json = {"type": ["number", "string"]}
WHOLE: Json = {"type": "integer", "minimum": 1}
BOOLEAN: Json = {"type": "boolean"}
EMPTY: Json = {"type": "null"}


def schema(kind: str, lang: Lang) -> Json:
    """The schema of "scene", "course" or "table", in a language."""
    return {"$schema": DIALECT, "title": say(f"schema_{kind}", lang), **_KINDS[kind](Schemas(lang))}


def one_of(*forms: Json) -> Json:
    """Any of several forms."""
    return {"anyOf": list(forms)}


def words_of(words: Iterable[object]) -> Json:
    """One of a few words."""
    return {"enum": list(words)}


def many(form: Json, least: int = 1) -> Json:
    """A list."""
    return {"type": "array", "items": form, "minItems": least}


def named(form: Json) -> Json:
    """A table whose keys are names chosen by the user."""
    return {"type": "object", "additionalProperties": form}


PAIR = {**many(NUMBER, 2), "maxItems": 2}
WORDS = one_of(TEXT, {"type": "object", "properties": dict.fromkeys(langs(), TEXT), "additionalProperties": False})


class Schemas:
    """Schemas in which every key has a description in a language."""

    def __init__(self, lang: Lang) -> None:
        self.told = under("schema_", lang, "schema")

    def of(self, what: str, keys: Iterable[str], forms: Mapping[str, Json], required: Iterable[str] = ()) -> Json:
        """A table with these keys of a reader, each with its form: a number by default."""
        own = {key: self.key(what, key, forms.get(key, NUMBER)) for key in keys}
        return {"type": "object", "additionalProperties": False, "properties": own, "required": list(required)}

    def key(self, what: str, key: str, form: Json) -> Json:
        """One key with its description; it may be left empty."""
        form = form if "type" not in form else {**form, "type": _with_null(form["type"])}
        return {**form, "description": self.told[f"{what}_{key}"]}

    def scene(self) -> Json:
        """The scene: a mechanism, vectors, or bodies in equilibrium."""
        mechanism, statics = self.mechanism(), self.statics()
        loads = one_of(mechanism["loads"], statics["loads"])
        forms = self.common() | mechanism | self.vectors() | statics | {"loads": loads}
        needs = [{"required": [*keys]} for keys in NEEDED.values()]
        return {**self.of("scene", KEYS, forms, ("planes",)), "anyOf": needs}

    def common(self) -> Json:
        """The keys common to all scenes."""
        numbers = named(NUMBER)
        return {
            **dict.fromkeys(("title", "note", "text", "missing"), WORDS),
            "planes": {"const": 1},
            "parameters": numbers,
            "variants": named(one_of(numbers, EMPTY)),
            "find": one_of(TEXT, many(TEXT)),
            "sheet": self.sheet(),
        }

    def mechanism(self) -> Json:
        """The parts of a mechanism."""
        points, guides = named(self.place()), named(self.guide())
        slides = one_of(TEXT, self.of("slide", SLIDE_KEYS, {"guide": TEXT}, ("guide",)))
        link = self.of(
            "link",
            LINK_KEYS,
            {"points": points, "guides": guides, "slides": slides, "centre": TEXT, "bearings": PAIR},
            ("points",),
        )
        near = self.of("assembly", ("near",), {"near": self.place()}, ("near",))
        mu = one_of(TEXT, self.of("plan", ("mu",), {"mu": TEXT}))
        return {
            "frame": self.of("frame", FRAME_KEYS, {"points": points, "guides": guides, "number": NAME}),
            "links": named(link),
            "assembly": named(one_of(words_of(ORDERS), near)),
            "drive": self.of("drive", DRIVE_KEYS, {"link": NAME, "balance": self.balance()}, ()),
            "loads": many(self.load(), 0),
            "friction": named(one_of(NUMBER, self.of("pin", PIN_KEYS, {}, PIN_KEYS))),
            "plans": self.of("plans", PLANS, dict.fromkeys(PLANS, mu)),
            "crank_slider": self.crank_slider(),
        }

    def place(self) -> Json:
        """A point: along the link's axis, by two coordinates, or by radius and angle."""
        return one_of(NUMBER, PAIR, self.of("place", ("r", "angle"), {}, ("r",)))

    def guide(self) -> Json:
        """A guide, straight or circular."""
        forms = {"through": one_of(NAME, self.place()), "mark": TEXT, "centre": one_of(NAME, self.place())}
        return self.of("guide", GUIDE_KEYS, forms)

    def balance(self) -> Json:
        """The point and the line of a balancing force."""
        return self.of("balance", BALANCE_KEYS, {"point": NAME}, ("point",))

    def law(self) -> Json:
        """A number, an expression, or a table over one."""
        return one_of(NUMBER, self.of("law", LAW_KEYS, {"table": many(PAIR, 2)}, LAW_KEYS))

    def load(self) -> Json:
        """A force or a couple."""
        law = self.law()
        table = law["anyOf"][1]
        forms = {"working": law, "idle": law, "stroke": words_of(ORDERS[2:]), "slider": NAME}
        size = one_of(NUMBER, table, self.of("law", STROKE_KEYS, forms, ("working", "idle")))
        angle = one_of(NUMBER, self.of("direction", ("link", "angle"), {"link": NAME, "angle": law}, ("link", "angle")))
        motion = words_of(["motion"])
        sides = {"direction": one_of(angle, table), "along": motion, "against": motion}
        return self.of(
            "load", LOAD_KEYS, {"link": NAME, "point": TEXT, "force": size, "moment": size, **sides}, ("link",)
        )

    def vectors(self) -> Json:
        """The parts of a scene of vectors."""
        turning = dict.fromkeys(("value", "direction"), self.law())
        vector = one_of(self.of("vector", VECTOR_KEYS, {"similar": TEXT, "as": many(TEXT, 2), **turning}), EMPTY)
        return {
            "vectors": named(vector),
            "equations": one_of(TEXT, many(one_of(TEXT, named(TEXT)))),
            "values": named(NUMBER),
            "mu": TEXT,
        }

    def statics(self) -> Json:
        """The parts of a scene of bodies in equilibrium."""
        support = one_of(words_of(SUPPORT_KINDS), self.of("support", SUPPORT_KEYS, {"rod": NAME, "rope": NAME}))
        load = dict.fromkeys(("point", "from", "to", "body"), NAME) | {"intensity": one_of(NUMBER, PAIR)}
        load |= dict.fromkeys(("force", "moment", "direction"), self.law())
        return {
            "points": named(one_of(PAIR, self.place())),
            "bodies": named(many(NAME)),
            "members": many(one_of(TEXT, many(NAME, 2))),
            "supports": named(one_of(support, many(support))),
            "loads": many(self.of("static_load", STATIC_LOAD_KEYS, load), 0),
            "method": words_of(METHODS),
            "pole": one_of(self.place(), self.of("pole", POLE_KEYS, {"through": many(NAME, 2)}, POLE_KEYS)),
        }

    def sheet(self) -> Json:
        """The texts on the sheet."""
        forms = {key: {"type": ["string", "number"]} for key in SHEET_KEYS}
        forms |= {key: words_of(words) for key, words in SHEET_WORDS.items()}
        forms |= {"positions": words_of([True, False, 12]), **dict.fromkeys(YES_OR_NO, BOOLEAN)}
        forms |= {key: one_of(TEXT, many({})) for key in SHEET_LISTS} | dict.fromkeys(SHEET_NUMBERS, NUMBER)
        return self.of(
            "sheet", SHEET_KEYS, forms | {"format": {"type": "string", "pattern": r"^(auto|[AaАа][0-4].*)$"}}
        )

    def crank_slider(self) -> Json:
        """The section of the integrated calculation."""
        keys = CRANK_SLIDER_KEYS
        tables = {name: self.of(name, own, {}) for name, own in keys.items() if name not in ("fatigue", "materials")}
        words = {"over": words_of(("path", "angle")), "unit": words_of(UNITS)}
        indicator = words | dict.fromkeys(FOUR, many(PAIR, 2))
        bored, material = tables["round"], {"name": NAME, "alloyed": words_of(["yes", "no", True, False])}
        steel = one_of(
            words_of([*STEELS, *(int(s) for s in STEELS if s.isdigit())]),
            self.of("material", keys["material"], material),
        )
        parts = {"journal": bored, "crankpin": bored, "web": tables["web"], "masses": tables["masses"]}
        own = {
            "indicator": self.of("indicator", INDICATOR, indicator, ("over", "unit")),
            "positions": many(NUMBER, 0),
            "shaft": self.of("shaft", keys["shaft"], parts),
            "counterweights": self.of("counterweights", keys["counterweights"], {"masses": PAIR}),
            "materials": self.of("materials", keys["materials"], dict.fromkeys(keys["materials"], steel)),
            "fatigue": self.of("fatigue", keys["fatigue"], dict.fromkeys(keys["fatigue"], tables["concentration"])),
            "limits": self.of("limits", keys["limits"], {"fatigue": PAIR}),
        }
        return self.of("crank_slider", keys["crank_slider"], tables | own, ("bore", "indicator"))

    def course(self) -> Json:
        """A course."""
        student = one_of(TEXT, self.of("student", STUDENT_KEYS, dict.fromkeys(STUDENT_KEYS, NAME), ("name",)))
        drawn = one_of({"type": "string", "pattern": "%$"}, many(NUMBER), self.of("draw", DRAW_KEYS, {}, DRAW_KEYS))
        some = {"documents": DOCUMENTS, "formats": FORMATS, "plans": PLANS}
        forms = {
            "course": {"const": 1},
            "title": WORDS,
            "lang": words_of(langs()),
            "sheet": self.sheet(),
            "students": one_of(TEXT, many(student)),
            "assignments": one_of(TEXT, many(TEXT)),
            "each": WHOLE,
            "variants": words_of(("given", "drawn")),
            "draw": named(drawn),
            **{key: one_of(words_of(words), many(words_of(words))) for key, words in some.items()},
            "seed": {"type": "integer", "minimum": 0},
        }
        return self.of("course", COURSE_KEYS, forms, ("course",))

    def table(self) -> Json:
        """The rows of a table, with the heads of its columns."""
        row = self.of("table", COLUMNS, {"mark": TEXT, "segment": TEXT, "result": TEXT, "unit": TEXT})
        return many({**row, "anyOf": [{"required": list(columns)} for columns in TABLES]})


_KINDS = {"scene": Schemas.scene, "course": Schemas.course, "table": Schemas.table}
KINDS = tuple(_KINDS)


def _with_null(kind: str | list[str]) -> list[str]:
    return [*([kind] if isinstance(kind, str) else kind), "null"]
