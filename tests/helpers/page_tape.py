"""Reads an exported tape without the engine: the numbers of a page, in plain floats."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence

from planes.batch.plain_tape import DIGIT_LETTERS
from planes.words.records import Json

READ: Mapping[str, Callable[..., float]] = {
    "add": lambda a, b: a + b,
    "sub": lambda a, b: a - b,
    "mul": lambda a, b: a * b,
    "inv": lambda a: 1 / a if a else math.copysign(math.inf, a),
    "neg": lambda a: -a,
    "abs": abs,
    "sqrt": lambda a: math.sqrt(max(a, 0.0)) if a == a else a,
    "hypot": math.hypot,
    "sin": math.sin,
    "cos": math.cos,
    "atan2": math.atan2,
    "floor": lambda a: float(math.floor(a)) if math.isfinite(a) else a,
    "max": lambda a, b: a if a >= b or a != a else b,
    "min": lambda a, b: a if a <= b or a != a else b,
    "sel": lambda ok, a, b: a if ok else b,
    "lt": lambda a, b: a < b,
    "le": lambda a, b: a <= b,
    "eq": lambda a, b: a == b,
    "and": lambda a, b: bool(a and b),
    "or": lambda a, b: bool(a or b),
    "not": lambda a: not a,
}


def operations(tape: Json) -> Iterator[tuple[str, list[int]]]:
    """Each operation with the positions of its arguments, from the letters of a tape."""
    digits, names = map(DIGIT_LETTERS.index, tape["ops"]), [*tape["names"].items()]
    for place, first in enumerate(digits):
        name, count = names[first]
        yield name, [place - _number(digits) for _ in range(count)]


def _number(digits: Iterator[int]) -> int:
    digit = next(digits)
    return digit if digit < 32 else digit - 32 + 32 * _number(digits)


class PageTape:
    """The export of ``lesson_data``, at one value of the drive and with other given numbers."""

    def __init__(self, exported: Json, drive: float | None = None, given: Mapping[str, float] | None = None) -> None:
        self.exported, tape = exported, exported["tape"]
        at = exported["drive"]["at"] if drive is None else drive
        own = {**exported["home"], **(given or {}), exported["drive"]["given"]: at}
        places = {place: own[name] for name, place in tape["givens"].items()}
        places |= {place: math.nan if x is None else x for place, x in tape["consts"].items()}
        self.numbers: list[float] = []
        for place, (op, args) in enumerate(operations(tape)):
            made = READ.get(op)
            self.numbers.append(made(*(self.numbers[a] for a in args)) if made else places[place])

    def mark(self, name: str) -> complex:
        """A mark, mm."""
        return self.pair(self.exported["marks"][name])

    def pair(self, places: Sequence[int]) -> complex:
        """Two numbers of the tape."""
        x, y = places
        return complex(self.numbers[x], self.numbers[y])

    def value(self, name: str) -> float:
        """A value, SI."""
        return float(self.numbers[self.exported["values"][name]])

    @property
    def failed(self) -> Json | None:
        """The message of the first condition that fails."""
        return next((h["said"] for h in self.exported["holds"] if not self.numbers[h["at"]]), None)

    def worst(self, others: Mapping[str, complex]) -> float:
        """The largest distance of its marks from those of a drawing, mm."""
        off = [abs(self.mark(name) - others[name]) for name in self.exported["marks"] if name in others]
        return math.nan if any(map(math.isnan, off)) else max(off)
