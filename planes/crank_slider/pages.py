"""The writer of a report: fills a document in one language from ``report.txt`` and the table of words.

A line of ``report.txt`` is a heading (``#``, ``##``), a formula (``$ … № number``), an error of the source text (``!``)
or a sentence, by its key and the values of its placeholders; ``?name`` before it: only where that value is present,
``?!name``: where it is not. In a formula ‹name› is a value, ‹(name)› one in brackets if it is negative.
"""

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from operator import attrgetter
from pathlib import Path
from typing import Any

from planes.crank_slider.kinematics import largest_magnitude
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
from planes.words import Lang, say, with_decimal_sign
from planes.words.units import number_in_tex, number_text, significant_digits_text

KILONEWTONS_PER_NEWTON = 1e-3
FORMULA_UNITS = ("m/s²", "m/s", "rad/s²", "rad/s", "MPa", "N·m", "N", "kgm2", "kg", "J", "m", "kW")
"""Units of formulas, written [kW]."""
_PLACEHOLDER_PATTERN = re.compile("‹([^›]+)›")


@dataclass
class ChapterWriter:
    """Fills a document in one language from the table of words."""

    lang: Lang
    blocks: list[Block] = field(default_factory=list)
    charts: int = 0
    tables: int = 0

    def say(self, key: str, **parts: object) -> str:
        """The words of a key."""
        shown = {k: self.number(v) if isinstance(v, float) else str(v) for k, v in parts.items()}
        return say(key, self.lang, **shown)

    def number(self, value: float, digits: int = 4, near: float = 0.0) -> str:
        """A number for a text; rounding noise of numbers ``near`` that large is zero."""
        return number_text(0.0 if abs(value) < 1e-12 * near else float(value), self.lang, digits)

    def tex(self, value: float) -> str:
        """A number for a formula."""
        return number_in_tex(with_decimal_sign(significant_digits_text(float(value)), self.lang))

    def write(self, part: str, values: object) -> None:
        """A part of ``report.txt``: its headings, sentences and formulas, with ``values`` for their placeholders."""
        for line in _report_parts()[part]:
            flag, line = line.split(" ", 1) if line[0] == "?" else ("", line)
            if not flag or bool(_value_at_path(flag.strip("?!"), values)) != flag.startswith("?!"):
                self._line(line, values)

    def _line(self, line: str, values: object) -> None:
        mark, _, content = line.partition(" ")
        if mark == "$":
            tex, _, number = content.partition(" № ")
            self.formula(_PLACEHOLDER_PATTERN.sub(lambda place: self._placed(place[1], values), tex), number)
        elif mark in ("#", "##"):
            self.blocks.append(Heading(self.say(content), len(mark)))
        else:
            key, *given = line.removeprefix("! ").split()
            parts = {name: _value_at_path(path, values) for name, _, path in (one.partition("=") for one in given)}
            self.blocks.append(Paragraph(self.say(key, **parts), mistake=mark == "!"))

    def _placed(self, path: str, values: object) -> str:
        """The text for a placeholder of a formula."""
        value = _value_at_path(path.strip("()"), values)
        text = value if isinstance(value, str) else self.tex(value)
        return f"({text})" if path[0] == "(" and value < 0 else text

    def formula(self, tex: str, number: str = "") -> None:
        """A formula; ``§key§`` in it is a subscript of the table."""
        tex = re.sub("§(\\w+)§", lambda place: f"\\mathrm{{{self.say(f'sub_{place[1]}')}}}", tex)
        for unit in FORMULA_UNITS:
            tex = tex.replace(f"[{unit}]", f"\\ \\mathrm{{{say(unit, self.lang)}}}")
        tex = tex.replace(r"\frac", r"\dfrac").replace(r"\tan", rf"\,\mathrm{{{say('tangent', self.lang)}}}\,")
        tex = re.sub(r"\\(sin|cos)(?=[^a-z]|$)", r"\\,\\\1\\,", tex).replace(r"\,^", "^")
        self.blocks.append(Formula(tuple(re.split(r"(?=\\quad)", tex)), number))

    def words(self, *keys: str) -> tuple[str, ...]:
        """The words of several keys."""
        return tuple(map(self.say, keys))

    def table(self, key: str, head: Sequence[str], rows: Iterable[Sequence[str | float]]) -> None:
        """A table with its number; numbers in it are written as in a text."""
        self.tables += 1
        title = f"{self.say('table')} {self.tables}. {self.say(key)}"
        cells = (tuple(x if isinstance(x, str) else self.number(x) for x in row) for row in rows)
        self.blocks.append(DocumentTable(title, (tuple(head), *cells)))

    def sizes(self, part: str, values: object) -> list[tuple[str, str, str]]:
        """Rows of a table of ``report.txt``: the name, the symbol, the value with the unit."""
        rows = ([cell.strip() for cell in line.split("|")] for line in _report_parts()[part])
        sizes = ((key, sign, self.number(_value_at_path(path, values)), unit) for key, sign, path, unit in rows)
        return [(self.say(key), sign, f"{x} {self.say(unit)}" if unit else x) for key, sign, x, unit in sizes]

    def figure(self, key: str, picture: Chart | DrawnViews | ShaftSketch, **parts: object) -> None:
        self.charts += 1
        self.blocks.append(Figure(picture, f"{self.say('figure')} {self.charts}. {self.say(key, **parts)}"))

    def chart(
        self, key: str, x: str, y: str, curves: Sequence[PlottedLine], *, ticks: float = 0.0, height_mm: float = 62.0
    ) -> None:
        self.figure(key, Chart(self.say(x), self.say(y), tuple(curves), ticks=ticks, height_mm=height_mm))

    def over_cycle(self, key: str, steps: range, columns: Mapping[str, Array]) -> None:
        """A table of numbers at some steps of the cycle."""
        noise = [(x, largest_magnitude(x)) for x in columns.values()]
        rows = [[self.number(x[i], near=n) for x, n in noise] for i in steps]
        self.table(key, list(columns), rows)


@cache
def _report_parts() -> dict[str, list[str]]:
    """The lines of every part of the report by its name."""
    text = Path(__file__).with_name("report.txt").read_text("utf-8")
    named = (part.partition("]\n") for part in text.removeprefix("[").split("\n["))
    return {name: body.rstrip().split("\n") for name, _, body in named}


def _value_at_path(path: str, values: object) -> Any:
    """The value at a path: ``-`` before a reversed one, ``|`` around one of which the magnitude is meant."""
    value = attrgetter(path.strip("|-"))(values)
    if path[0] == "|":
        return abs(value)
    if path[0] == "-":
        return -value
    return value


def plotted_lines(x: Array, named: Mapping[str, Array]) -> list[PlottedLine]:
    """Curves over the same x, each in the next style."""
    return [PlottedLine(x, y, name, k) for k, (name, y) in enumerate(named.items())]
