"""The writer of a report: fills a document in one language from the table of words."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

import numpy as np

from planes.geometry.arrays import Array
from planes.solving.document import (
    Block,
    Chart,
    DocumentTable,
    DrawnViews,
    Figure,
    Formula,
    Heading,
    Paragraph,
    PlottedLine,
    ShaftSketch,
)
from planes.words import Lang, decimal, say
from planes.words.units import quantity

UNITS = ("m/s²", "m/s", "rad/s²", "rad/s", "MPa", "N·m", "N", "kgm2", "kg", "J", "m", "kW")
"""Units of formulas, written [kW]."""


@dataclass
class ChapterWriter:
    """Fills a document in one language from the table of words."""

    lang: Lang
    blocks: list[Block] = field(default_factory=list)
    charts: int = 0
    tables: int = 0

    def say(self, key: str, **parts: object) -> str:
        """The words of a key."""
        told = {k: self.number(v) if isinstance(v, float) else str(v) for k, v in parts.items()}
        return say(key, self.lang, **told)

    def number(self, value: float, digits: int = 4, near: float = 0.0) -> str:
        """A number as it stands in a text; rounding noise of numbers ``near`` that large is zero."""
        value = 0.0 if abs(value) < 1e-12 * near else value
        return decimal(quantity(float(value), digits=digits, true_minus=True), self.lang)

    def tex(self, value: float) -> str:
        """A number as it stands in a formula."""
        text = quantity(float(value), digits=4)
        mantissa, times, power = text.partition("·10")
        if times:
            plain = power.translate(str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789"))
            text = f"{mantissa}\\cdot10^{{{plain}}}"
        return text.replace(".", "{,}") if self.lang == "ru" else text

    def bracketed(self, value: float) -> str:
        """The same, in brackets if it is negative."""
        return f"({self.tex(value)})" if value < 0 else self.tex(value)

    def head(self, key: str, level: int = 2) -> None:
        self.blocks.append(Heading(self.say(key), level))

    def text(self, key: str, **parts: object) -> None:
        self.blocks.append(Paragraph(self.say(key, **parts)))

    def mistake(self, key: str, **parts: object) -> None:
        self.blocks.append(Paragraph(self.say(key, **parts), mistake=True))

    def formula(self, tex: str, number: str = "") -> None:
        """A formula; ``§key§`` in it is a subscript of the table."""
        tex = re.sub("§(\\w+)§", lambda place: f"\\mathrm{{{self.say(f'sub_{place[1]}')}}}", tex)
        for unit in UNITS:
            tex = tex.replace(f"[{unit}]", f"\\ \\mathrm{{{say(unit, self.lang)}}}")
        tex = tex.replace(r"\frac", r"\dfrac").replace(r"\tan", r"\,\mathrm{tg}\," if self.lang == "ru" else r"\,\tan ")
        tex = re.sub(r"\\(sin|cos)(?=[^a-z]|$)", r"\\,\\\1\\,", tex).replace(r"\,^", "^")
        self.blocks.append(Formula(tex, number))

    def formulas(self, group: str) -> None:
        """A group of the text's formulas, which have no numbers put in."""
        for tex, *number in _formulas()[group]:
            self.formula(tex, *number)

    def table(self, key: str, head: Sequence[str], rows: Sequence[Sequence[str]], **parts: object) -> None:
        self.tables += 1
        title = f"{self.say('table')} {self.tables}. {self.say(key, **parts)}"
        self.blocks.append(DocumentTable(title, (tuple(head), *map(tuple, rows))))

    def figure(self, key: str, of: Chart | DrawnViews | ShaftSketch, **parts: object) -> None:
        self.charts += 1
        self.blocks.append(Figure(of, f"{self.say('figure')} {self.charts}. {self.say(key, **parts)}"))

    def chart(
        self, key: str, x: str, y: str, curves: Sequence[PlottedLine], *, ticks: float = 0.0, height_mm: float = 62.0
    ) -> None:
        self.figure(key, Chart(self.say(x), self.say(y), tuple(curves), ticks=ticks, height_mm=height_mm))

    def over_cycle(self, key: str, steps: range, columns: Mapping[str, Array]) -> None:
        """A table of numbers at some steps of the cycle."""
        noise = [float(np.max(np.abs(x))) for x in columns.values()]
        rows = [[self.number(x[i], near=n) for x, n in zip(columns.values(), noise, strict=True)] for i in steps]
        self.table(key, list(columns), rows)


@cache
def _formulas() -> dict[str, list[list[str]]]:
    """Groups of formulas, each with its number in the text if it has one."""
    groups: dict[str, list[list[str]]] = json.loads(Path(__file__).with_name("formulas.json").read_text("utf-8"))
    return groups


def lines(x: Array, named: Mapping[str, Array]) -> list[PlottedLine]:
    """Curves over the same x, each in the next look."""
    return [PlottedLine(x, y, name, k) for k, (name, y) in enumerate(named.items())]
