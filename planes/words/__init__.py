"""The one table of words: every sentence and label meant for people, in Russian and in English.

Labels stand here, everything else in the files beside it.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from string import Formatter
from typing import Any, Literal

from planes.words.check import CHECK
from planes.words.course import COURSE
from planes.words.course_summary import SUMMARY
from planes.words.crank_slider import CRANK_SLIDER
from planes.words.crank_slider_balance import BALANCE
from planes.words.crank_slider_forces import FORCES
from planes.words.crank_slider_report import GENERAL, KINEMATICS
from planes.words.crank_slider_rod import ROD
from planes.words.crank_slider_strength import STRENGTH
from planes.words.cycle import CYCLE
from planes.words.diagrams import DIAGRAMS
from planes.words.expressions import TEXT
from planes.words.failures import FAILURES
from planes.words.lesson import LESSON
from planes.words.mechanism import LINKS
from planes.words.note import NOTE
from planes.words.pages import PAGES
from planes.words.scene import SCENE
from planes.words.sheets import SHEETS
from planes.words.structure import METHOD
from planes.words.system import in_russian
from planes.words.usage import USAGE
from planes.words.why import WHY

Lang = Literal["ru", "en"]

WORDS: dict[str, tuple[str, str]] = {
    # warnings
    "standstill": (
        "{makes}: скорость равна нулю, сила или трение, зависящие от её направления, приняты равными нулю",
        "{makes}: the speed is zero, so the load or friction that depends on its sense is taken as zero",
    ),
    "faint": (
        "{makes}: нуль с точностью до округления, верных цифр нет",
        "{makes}: zero to within rounding, no digit of it is certain",
    ),
    "doubtful": (
        "{makes}: округление оставляет меньше трёх верных цифр (оценку погрешности даст --errors)",
        "{makes}: rounding leaves less than three correct digits (--errors tells how far off they may be)",
    ),
    "blunt": (
        "{makes}: линии встречаются под углом {angle_deg}° (меньше 15°), чертёж здесь неточен",
        "{makes}: the lines meet at {angle_deg}° (less than 15°), a drawing is inaccurate here",
    ),
    "plan_position": ("план положения", "position plan"),
    "plan_velocity": ("план скоростей", "velocity plan"),
    "plan_motion": ("план аналогов скоростей", "velocity plan of a unit drive"),
    "plan_acceleration": ("план ускорений", "acceleration plan"),
    "plan_force": ("план сил звеньев {links}", "force plan of links {links}"),
    "plan_vectors": ("план векторов", "plan of vectors"),
    "plan_lever": ("рычаг Жуковского", "Zhukovsky's lever"),
    # tables
    "points": ("Точки", "Points"),
    "links": ("Звенья", "Links"),
    "slides": ("Ползуны относительно направляющих", "Sliders against their guides"),
    "guide": ("направл.", "guide"),
    "segment": ("отрезок", "segment"),
    "reactions": ("Реакции", "Reactions"),
    "arm": ("плечо", "arm"),
    "balancing_moment": ("Уравновешивающий момент", "Balancing moment"),
    "balancing_force": ("Уравновешивающая сила", "Balancing force"),
    "by_lever": ("По рычагу Жуковского", "By Zhukovsky's lever"),
    "difference": ("Расхождение", "Difference"),
    "group": ("Группа", "Group"),
    "class_kind": ("класс II, вид {kind} ({name})", "class II, kind {kind} ({name})"),
    "m": ("м", "m"),
    "mm": ("мм", "mm"),
    "m/s": ("м/с", "m/s"),
    "m/s²": ("м/с²", "m/s²"),
    "rad/s": ("рад/с", "rad/s"),
    "rad/s²": ("рад/с²", "rad/s²"),
    "N": ("Н", "N"),
    "N·m": ("Н·м", "N·m"),
    "units": ("ед.", "units"),
    "in_m": ("{value} м", "{value} m"),
    "nearest": ("; ближайшее рабочее положение: {name} = {value}", "; the nearest that works: {name} = {value}"),
    "at": ("при {name} = {value}: {why}{nearest}", "at {name} = {value}: {why}{nearest}"),
}


class Phrase:
    """A sentence, or a part of one, not yet told in a language: a key of the table, its names and numbers.

    A part may be a phrase itself, or a tuple of them; a tuple is told with what stands after the colon of its
    place between its members: ``{offers: or }``. A Russian noun of two forms, "звено 2|звена 2", takes the
    second where its place is ``{what:of}``.
    """

    __slots__ = ("key", "parts")

    def __init__(self, key: str, /, **parts: object) -> None:
        self.key, self.parts = key, parts

    def told(self, lang: Lang = "en", form: str = "") -> str:
        """The words in a language."""
        forms = TABLE[self.key][0 if lang == "ru" else 1].split("|")
        return _Teller(lang).vformat(forms[-1 if form else 0], (), self.parts)

    __str__ = told

    def __repr__(self) -> str:
        return f"Phrase({self.key!r}, {self.parts!r})"


class Written:
    """A printed number, or a quantity with its unit in both languages, told with the decimal sign of the language."""

    __slots__ = ("en", "ru")

    def __init__(self, en: str, ru: str | None = None) -> None:
        self.en, self.ru = en, decimal(en if ru is None else ru, "ru")

    def told(self, lang: Lang = "en", form: str = "") -> str:
        """The number in a language."""
        return self.ru if lang == "ru" else self.en

    __str__ = told


Told = Phrase | str
"""A phrase, or words that are the same in both languages: a name, a number, a key of the file."""

TABLE = {
    **WORDS,
    **FAILURES,
    **TEXT,
    **SCENE,
    **LINKS,
    **METHOD,
    **CRANK_SLIDER,
    **CHECK,
    **CYCLE,
    **DIAGRAMS,
    **COURSE,
    **SUMMARY,
    **SHEETS,
    **USAGE,
    **NOTE,
    **LESSON,
    **WHY,
    **GENERAL,
    **KINEMATICS,
    **FORCES,
    **BALANCE,
    **STRENGTH,
    **ROD,
    **PAGES,
}


class _Teller(Formatter):
    index = re.compile(r"([_^])\{([^{}]*)\}")  # _{…} and ^{…} in a sentence are no places to fill

    def __init__(self, lang: Lang) -> None:
        self.lang = lang

    def parse(self, format_string: Any) -> Iterable[Any]:
        return super().parse(self.index.sub(r"\1{{\2}}", format_string))

    def format_field(self, value: object, format_spec: str) -> str:
        if isinstance(value, Phrase | Written):
            return value.told(self.lang, format_spec)
        if isinstance(value, tuple):
            return (format_spec or ", ").join(self.format_field(v, "") for v in value)
        if isinstance(value, str):
            return in_russian(value) if self.lang == "ru" else value
        return format(value, format_spec or (".4g" if isinstance(value, float) else ""))


def decimal(number: str, lang: Lang) -> str:
    """A printed number with the decimal sign of the language."""
    return number.replace(".", ",") if lang == "ru" else number


def say(key: str, lang: Lang = "en", **numbers: object) -> str:
    """The sentence ``key`` in a language, with its names and numbers filled in."""
    return Phrase(key, **numbers).told(lang)
