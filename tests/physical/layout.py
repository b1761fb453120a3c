"""The layout of a sheet: occupied and free areas."""

from __future__ import annotations

import random
from collections.abc import Iterable
from dataclasses import dataclass, field

from tests.physical.letters import Writer
from tests.physical.paper import Paper
from tests.physical.strokes import Hand
from tests.picture_corpus import Drawn

Box = tuple[complex, complex]
ROOM: Box = (26 + 11j, 288 + 200j)
GAP_MM = 9.0


@dataclass
class Page:
    """A sheet of paper, the hand that draws on it, its pole, and the occupied boxes."""

    paper: Paper
    hand: Hand
    writer: Writer
    rng: random.Random
    pole: complex
    taken: list[Box] = field(default_factory=list)
    seen: Box = ROOM  # the drawing, and the text around it

    def free(self, size: complex) -> complex | None:
        """A lower left corner for a box of this size that touches no other; None if none is found."""
        low, high = ROOM[0], ROOM[1] - size
        if high.real < low.real or high.imag < low.imag:
            return None
        for _ in range(200):
            z = complex(self.rng.uniform(low.real, high.real), self.rng.uniform(low.imag, high.imag))
            if not any(_touch((z, z + size), box) for box in self.taken):
                return z
        return None

    def lines(self, strokes: Iterable[tuple[complex, complex]], width: float = 1.0) -> None:
        for a, b in strokes:
            self.hand.line(a, b, 0.9, width)


def _touch(one: Box, two: Box) -> bool:
    apart = (one[0] - two[1], two[0] - one[1])
    return not any(z.real > GAP_MM or z.imag > GAP_MM for z in apart)


def extent(one: Drawn) -> Box:
    """The box of a drawing and its letters, from the pole."""
    ends = [0j, *(z for s in one.strokes for z in s)]
    ends += [z + d for text, z in one.words for d in (0, complex(2.5 * len(text), 3.5))]
    xs, ys = [z.real for z in ends], [z.imag for z in ends]
    return complex(min(xs), min(ys)), complex(max(xs), max(ys))
