"""Texts of a drawing with their boxes, as names of marks and vectors: several in a row, with numbers of ends."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence

from planes.words.frozen import frozen, replace
from planes.words.names import NamePair

Stroke = tuple[complex, complex]
Strokes = Sequence[Stroke]
LONGEST_NAME_LIST = 40  # letters of names in a row
_END_NUMBERS = re.compile(r"\((\d+)–(\d+)\)")


def vector_of(stroke: Stroke) -> complex:
    """The vector from the first to the second end."""
    return stroke[1] - stroke[0]


@frozen
class Words:
    """A piece of text: its lower left corner, direction, height and width, mm."""

    text: str
    place: complex
    height: float = 3.5
    width: float = 0.0
    along: complex = 1 + 0j
    ends: NamePair | None = None  # numbers at the ends of the vectors it names

    def split_names(self) -> list[Words]:
        """One for each of several names in a row: p, a, d, or F = R; with numbers of ends, G (1–2).

        In F = −R the second is reversed.
        """
        if len(self.text) > LONGEST_NAME_LIST:
            return [self]
        ends = (match[1], match[2]) if (match := _END_NUMBERS.search(self.text)) else None
        names = [t.strip() for t in re.split("[,=]", _END_NUMBERS.sub("", self.text)) if t.strip()]
        ways = ((t.lstrip("−"), ends and (ends[::-1] if t[0] == "−" else ends)) for t in names)
        return [replace(self, text=t, ends=way) for t, way in ways] or [self]

    def agrees_with_end_numbers(self, stroke: Stroke, words: Iterable[Words]) -> bool:
        """Whether a vector may run as the numbers at its ends say, those that are there."""
        at = {
            w.text: w for w in sorted(words, key=lambda w: -w.distance_to_vector(stroke)) if w.text in (self.ends or ())
        }

        def off(way: Stroke) -> float:
            return sum(at[n].distance(z) for n, z in zip(self.ends or (), way, strict=False) if n in at)

        return off(stroke) <= off(stroke[::-1])

    @property
    def middle(self) -> complex:
        """The middle of the text's box."""
        return self.place + self.along * complex(self.width or self.height, self.height) / 2

    def distance(self, z: complex, below: float = 0.0) -> float:
        """The distance from a point to the text's box, extended by ``below`` downwards."""
        local = (z - self.place) * self.along.conjugate()
        width = self.width or 0.7 * self.height * max(len(self.text), 1)
        aside = max(-local.real, 0.0, local.real - width)
        above = local.imag - self.height
        return math.hypot(aside, max(-local.imag - below, 0.0, above))

    def distance_to_vector(self, stroke: Stroke) -> float:
        """Its distance from the middle part of a vector."""
        return min(self.distance(stroke[0] + vector_of(stroke) * t / 8) for t in range(1, 8))
