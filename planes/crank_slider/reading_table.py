"""Values of one table with their checks, and the indicator diagram."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from types import MappingProxyType
from typing import TypeVar

from planes.crank_slider.given import FOUR, TWO, UNITS, Indicator, Points, span
from planes.scene.reader import Reader, part
from planes.scene.source import Items, Node, SourceTable
from planes.words import Phrase, Told
from planes.words.errors import SceneError

Part = TypeVar("Part")
INDICATOR = ("over", "unit", *FOUR)


class Values:
    """Reads the keys of one table."""

    def __init__(self, reader: Reader, table: SourceTable, what: Told) -> None:
        self.reader, self.table, self.what = reader, table, what

    def error(self, phrase: Told, key: str) -> SceneError:
        """A refusal at a key."""
        return self.reader.error(phrase, self.table.lines.get(key, self.table.line))

    def named(self, key: str) -> Told:
        """The key as a sentence says it."""
        return part(key, self.what)

    def inner(self, key: str, keys: Sequence[str] | None = None) -> Values | None:
        """The table under a key, None if it is not there."""
        node = self.reader.optional(self.table, key)
        if node is None:
            return None
        return Values(self.reader, self.reader.table(node, self.named(key), keys), self.named(key))

    def part(self, key: str, keys: Sequence[str], read: Callable[[Values], Part]) -> Part | None:
        """What is read from the table under a key, None if it is not there."""
        table = self.inner(key, keys)
        return None if table is None else read(table)

    def needed(self, key: str, keys: Sequence[str]) -> Values:
        """The table under a key that must be there."""
        self.reader.required(self.table, key, self.what)
        inner_table = self.inner(key, keys)
        assert inner_table is not None
        return inner_table

    def number(self, key: str, usual: float | None = None) -> float:
        """A number; ``usual`` where it is not given."""
        node = self.reader.optional(self.table, key)
        if node is None and usual is not None:
            return usual
        return self.reader.number(self.reader.required(self.table, key, self.what), self.named(key))

    def above(self, key: str, usual: float | None = None) -> float:
        """A number above zero."""
        value = self.number(key, usual)
        if value <= 0.0:
            raise self.error(Phrase("cs_positive", what=self.named(key), value=value), key)
        return value

    def not_negative(self, key: str, usual: float | None = None) -> float:
        """A number that is not negative."""
        value = self.number(key, usual)
        if value < 0.0:
            raise self.error(Phrase("negative", what=self.named(key), value=value), key)
        return value

    def between(self, key: str, low: float, high: float, usual: float | None = None) -> float:
        """A number from ``low`` to ``high``."""
        value = self.number(key, usual)
        if not low <= value <= high:
            raise self.error(Phrase("cs_range", what=self.named(key), low=low, high=high, value=value), key)
        return value

    def pair(self, key: str) -> tuple[float, float] | None:
        """Two numbers, None where they are not given."""
        if (node := self.reader.optional(self.table, key)) is None:
            return None
        both = self.reader.place(node, self.named(key))
        return both.real, both.imag


def read_indicator(top: Values) -> Indicator:
    """The diagram with every stage it needs, each over the whole of its stroke, joined to the next."""
    table = top.needed("indicator", INDICATOR)
    reader = top.reader
    over = reader.word(reader.required(table.table, "over", table.what), table.named("over"), ("path", "angle"))
    unit = reader.word(reader.required(table.table, "unit", table.what), table.named("unit"), tuple(UNITS))
    names = FOUR if {"intake", "exhaust"} & set(table.table.entries) else TWO
    missing = next((name for name in names if name not in table.table.entries), None)
    if missing:
        raise reader.error(Phrase("cs_stages", stage=missing), table.table.line)
    stages = {name: _stage(table, name, over, names) for name in names}
    for one, two in zip(names, (*names[1:], names[0]), strict=True):
        first, second = stages[one][-1][1], stages[two][0][1]
        if abs(first - second) > 1e-6 * max(abs(first), abs(second)):
            raise table.error(Phrase("cs_joint", one=one, two=two, first=first, second=second), two)
    return Indicator(over, unit, MappingProxyType(stages))


def _stage(table: Values, name: str, over: str, names: tuple[str, ...]) -> Points:
    what, variable = table.named(name), "s/S" if over == "path" else "φ"
    items = table.reader.items(table.reader.required(table.table, name, table.what), what)
    points = tuple(_point(table, item, what, variable) for item in items)
    if len(points) < 2:
        raise table.error(Phrase("cs_two_points", what=what, variable=variable), name)
    start, end = span(name, over, names)
    if abs(points[0][0] - start) > 1e-9 or abs(points[-1][0] - end) > 1e-9:
        ends = {"start": start, "end": end, "one": points[0][0], "two": points[-1][0]}
        raise table.error(Phrase("cs_ends", what=what, variable=variable, **ends), name)
    for (one, _), (two, _), item in zip(points, points[1:], items[1:], strict=False):
        if (two - one) * (end - start) <= 0.0:
            words = Phrase("cs_order", what=what, variable=variable, start=start, end=end, one=one, two=two)
            raise table.reader.error(words, item)
    return points


def _point(table: Values, item: Node, what: Told, variable: str) -> tuple[float, float]:
    if not isinstance(item, Items) or len(item.items) != 2:
        raise table.reader.error(Phrase("cs_point", what=what, variable=variable), item)
    x, p = (table.reader.number(node, what) for node in item.items)
    if p < 0.0:
        raise table.reader.error(Phrase("cs_pressure", what=what, value=p), item)
    return x, p
