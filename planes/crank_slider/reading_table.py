"""Values of one table with their checks, and the indicator diagram."""

from __future__ import annotations

from collections.abc import Callable
from types import MappingProxyType
from typing import TypeVar

from planes.crank_slider.given import (
    FOUR_STROKE_STAGES,
    PASCALS_BY_UNIT,
    TWO_STROKE_STAGES,
    Indicator,
    Points,
    required_stage_span,
)
from planes.scene.packs import PACKS
from planes.scene.reader import Fields
from planes.scene.source import Items, Node
from planes.words import Phrase, Told
from planes.words.names import NameTuple

Part = TypeVar("Part")
KEYS_BY_TABLE = PACKS["crank_slider"].schema["keys"]
"""The keys of the section and of its tables, by the name of the table."""


class Values(Fields):
    """Reads the keys of one table within their bounds."""

    def part(self, key: str, read: Callable[[Values], Part]) -> Part | None:
        """The part read from the table under a key, None if it is missing."""
        if self.optional_node(key) is None:
            return None
        return read(self.inner_fields(key, KEYS_BY_TABLE[key]))

    def above(self, key: str, usual: float | None = None) -> float:
        """A number above zero."""
        value = self.read_number(key, usual)
        if value <= 0.0:
            raise self.error_by_key("cs_positive", key, what=self.phrase_of_key(key), value=value)
        return value

    def between(self, key: str, low: float, high: float, usual: float | None = None) -> float:
        """A number from ``low`` to ``high``."""
        value = self.read_number(key, usual)
        if not low <= value <= high:
            raise self.error_by_key("cs_range", key, what=self.phrase_of_key(key), low=low, high=high, value=value)
        return value

    def pair(self, key: str) -> tuple[float, float] | None:
        """Two numbers, None where they are not given."""
        if self.optional_node(key) is None:
            return None
        both = self.read_place(key)
        return both.real, both.imag


def read_indicator(top: Values) -> Indicator:
    """The diagram with all required stages, each over its whole stroke, joined to the next."""
    table = top.inner_fields("indicator", KEYS_BY_TABLE["indicator"])
    over = table.read_word("over", ("path", "angle"))
    unit = table.read_word("unit", tuple(PASCALS_BY_UNIT))
    names = FOUR_STROKE_STAGES if "intake" in table or "exhaust" in table else TWO_STROKE_STAGES
    missing = next((name for name in names if name not in table), None)
    if missing:
        raise table.error_by_key("cs_stages", stage=missing)
    stages = {name: _read_stage(table, name, over, names) for name in names}
    for one, two in zip(names, (*names[1:], names[0]), strict=True):
        first = stages[one][-1][1]
        second = stages[two][0][1]
        if abs(first - second) > 1e-6 * max(abs(first), abs(second)):
            raise table.error_by_key("cs_joint", two, one=one, two=two, first=first, second=second)
    return Indicator(over, unit, MappingProxyType(stages))


def _read_stage(table: Values, name: str, over: str, names: NameTuple) -> Points:
    what = table.phrase_of_key(name)
    variable = "s/S" if over == "path" else "φ"
    items = table.reader.read_list(table.required_node(name), what)
    points = tuple(_read_point(table, item, what, variable) for item in items)
    if len(points) < 2:
        raise table.error_by_key("cs_two_points", name, what=what, variable=variable)
    start, end = required_stage_span(name, over, names)
    if abs(points[0][0] - start) > 1e-9 or abs(points[-1][0] - end) > 1e-9:
        ends = {"start": start, "end": end, "one": points[0][0], "two": points[-1][0]}
        raise table.error_by_key("cs_ends", name, what=what, variable=variable, **ends)
    for (one, _), (two, _), item in zip(points, points[1:], items[1:], strict=False):
        if (two - one) * (end - start) <= 0.0:
            words = Phrase("cs_order", what=what, variable=variable, start=start, end=end, one=one, two=two)
            raise table.reader.error(words, item)
    return points


def _read_point(table: Values, item: Node, what: Told, variable: str) -> tuple[float, float]:
    if not isinstance(item, Items) or len(item.items) != 2:
        raise table.reader.error_by_key("cs_point", item, what=what, variable=variable)
    x, p = (table.reader.read_number(node, what) for node in item.items)
    if p < 0.0:
        raise table.reader.error_by_key("cs_pressure", item, what=what, value=p)
    return x, p
