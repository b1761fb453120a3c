"""What a report is made of, and the writer that fills it: headings, paragraphs, formulas, tables, charts, plans."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from planes.scene import Scene
from planes.solving import Position
from planes.words import Lang, decimal
from planes.words.units import quantity

Words = Mapping[str, tuple[str, str]]
_PLACE = re.compile(r"(?<![_^])\{(\w+)\}")

SUBSCRIPTS: dict[str, tuple[str, str]] = {
    "cw": ("пр", "cw"), "rod": ("ш", "rod"), "eq": ("экв", "eq"), "b": ("и", "b"), "t": ("кр", "t"), "p": ("п", "p"),
    "fr": ("тр", "fr"), "m": ("ср", "m"), "gas": ("г", "g"), "fly": ("м", "fl"), "max": ("наиб", "max"),
    "min": ("наим", "min"), "cr": ("кр", "cr"), "Y": ("т", "y"), "B": ("в", "u"), "bush": ("вт", "bush"),
    "boss": ("б", "boss"), "tr": ("пост", "tr"), "c": ("сж", "c"), "tens": ("р", "t"),
}  # fmt: skip
"""Subscripts of formulas, written §cw§, in both languages."""

UNITS: dict[str, tuple[str, str]] = {
    "m/s^2": ("м/с²", "m/s²"), "m/s": ("м/с", "m/s"), "rad/s^2": ("рад/с²", "rad/s²"), "rad/s": ("рад/с", "rad/s"),
    "MPa": ("МПа", "MPa"), "Nm": ("Н·м", "N·m"), "N": ("Н", "N"), "kgm2": ("кг·м²", "kg·m²"), "kg": ("кг", "kg"),
    "J": ("Дж", "J"), "m": ("м", "m"), "kW": ("кВт", "kW"),
}  # fmt: skip
"""Units of formulas, written [kW], in both languages."""


@dataclass(frozen=True)
class Heading:
    text: str
    level: int


@dataclass(frozen=True)
class Paragraph:
    """Text with _{…} and ^{…} for indices."""

    text: str


@dataclass(frozen=True)
class Mistake:
    """Where the source text is wrong: what it prints, what is right."""

    text: str


@dataclass(frozen=True)
class Formula:
    """A line of mathematics (mathtext), its number in the source text."""

    tex: str
    number: str = ""


@dataclass(frozen=True)
class TableBlock:
    title: str
    head: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


@dataclass(frozen=True)
class Curve:
    """``style`` is the number of its look (colour and dashes); ``label`` "" keeps it out of the legend."""

    x: Any
    y: Any
    label: str
    style: int = 0


@dataclass(frozen=True)
class Note:
    """A word beside a point of a chart."""

    x: float
    y: float
    text: str


@dataclass(frozen=True)
class Chart:
    """Curves over x. ``equal``: both axes to one scale; ``ticks``: spacing of the marks on x, 0 for the usual."""

    title: str
    x: str
    y: str
    curves: tuple[Curve, ...]
    notes: tuple[Note, ...] = ()
    equal: bool = False
    ticks: float = 0.0
    height_mm: float = 62.0


@dataclass(frozen=True)
class Drawn:
    """Plans of one position, drawn at their scales: "scheme", "velocity", "force:2-3"…"""

    title: str
    scene: Scene
    position: Position
    views: tuple[str, ...]
    equations: bool = True


@dataclass(frozen=True)
class Sketch:
    """The crankshaft on its bearings; numbers in metres."""

    title: str
    span: float
    pin: float
    webs: float
    r: float
    radius: float
    labels: Mapping[str, str]


Block = Heading | Paragraph | Mistake | Formula | TableBlock | Chart | Drawn | Sketch


@dataclass(frozen=True)
class Document:
    title: str
    lang: Lang
    blocks: tuple[Block, ...]


@dataclass
class Writer:
    """Fills a document in one language from tables of words."""

    lang: Lang
    words: Words
    blocks: list[Block] = field(default_factory=list)
    charts: int = 0
    tables: int = 0

    def say(self, key: str, **parts: object) -> str:
        """The words of a key; {name} stands for a part, _{…} and ^{…} are indices."""
        told = {k: self.number(v) if isinstance(v, float) else str(v) for k, v in parts.items()}
        return _PLACE.sub(lambda found: told[found[1]], self.words[key][0 if self.lang == "ru" else 1])

    def number(self, value: float, digits: int = 4, near: float = 0.0) -> str:
        """A number as it stands in a text; rounding noise of numbers ``near`` that large is zero."""
        value = 0.0 if abs(value) < 1e-12 * near else value
        return decimal(quantity(float(value), digits=digits, true_minus=True), self.lang)

    def tex(self, value: float, digits: int = 4, bracket: bool = False) -> str:
        """A number as it stands in a formula, in brackets if it is negative and ``bracket`` asks so."""
        text = quantity(float(value), digits=digits)
        mantissa, times, power = text.partition("·10")
        if times:
            plain = power.translate(str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789"))
            text = f"{mantissa}\\cdot10^{{{plain}}}"
        text = text.replace(".", "{,}") if self.lang == "ru" else text
        return f"({text})" if bracket and value < 0 else text

    def head(self, key: str, level: int = 2) -> None:
        self.blocks.append(Heading(self.say(key), level))

    def text(self, key: str, **parts: object) -> None:
        self.blocks.append(Paragraph(self.say(key, **parts)))

    def mistake(self, key: str, **parts: object) -> None:
        self.blocks.append(Mistake(self.say(key, **parts)))

    def formula(self, tex: str, number: str = "") -> None:
        """A formula; ``§key§`` in it is a subscript of the table."""
        for key, pair in SUBSCRIPTS.items():
            tex = tex.replace(f"§{key}§", f"\\mathrm{{{pair[0 if self.lang == 'ru' else 1]}}}")
        for unit, pair in UNITS.items():
            tex = tex.replace(f"[{unit}]", f"\\ \\mathrm{{{pair[0 if self.lang == 'ru' else 1]}}}")
        tex = tex.replace(r"\frac", r"\dfrac").replace(r"\tan", r"\,\mathrm{tg}\," if self.lang == "ru" else r"\,\tan ")
        tex = re.sub(r"\\(sin|cos)(?=[^a-z]|$)", r"\\,\\\1\\,", tex).replace(r"\,^", "^")
        self.blocks.append(Formula(tex, number))

    def table(self, key: str, head: Sequence[str], rows: Sequence[Sequence[str]], **parts: object) -> None:
        self.tables += 1
        title = f"{self.say('table')} {self.tables}. {self.say(key, **parts)}"
        self.blocks.append(TableBlock(title, tuple(head), tuple(tuple(row) for row in rows)))

    def figure(self, key: str, **parts: object) -> str:
        """The title of the next figure."""
        self.charts += 1
        return f"{self.say('figure')} {self.charts}. {self.say(key, **parts)}"

    def chart(self, key: str, x: str, y: str, curves: Sequence[Curve], **more: Any) -> None:
        self.blocks.append(Chart(self.figure(key), self.say(x), self.say(y), tuple(curves), **more))
