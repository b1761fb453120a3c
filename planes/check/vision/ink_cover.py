"""What of a sheet's ink a drawing accounts for: its lines cut into short steps, its arrowheads, a bit for each.

A way from one place to another takes the steps it runs along and the head at its end; what no way takes was drawn for
some other reason.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from functools import reduce
from operator import or_

import numpy

from planes.check.grading.handwork import Miss
from planes.check.vision.places import HEADED_MM, Seen
from planes.geometry.arrays import Complexes

STEP_MM = 0.5
ROUTE_MM = 0.9  # ink farther than this from a vector is not its own
PER_MM = 0.5  # what a millimetre of ink costs that no vector runs along
NO_HEAD, OTHER_HEAD = 2.9, 3.0  # what a longer vector costs that shows no head, and a head that is no vector's
CROSS_MM = 3.0  # what is nearer to the pole is its printed cross
TIP_NEAR_MM, TIP_STRAIGHT = 1.6, 0.94  # how far a head's tip may be from a vector's end; the cosine of its turn
FEW = 0.3  # heads for a line, at the least, for a missing one to mean anything
GATE = 4.5  # σ of drafting and reading within which a mark is looked for
NO_MARK, NO_END, NO_LINE = 9.0, 3.0, 5.0  # what a mark costs that is nowhere, where nothing ends, where no line leads
WRONG, SLIP, ANYWHERE = 0.5, 2.0, 11.0  # the odds of a mistake; the least one of the catalogue costs; a mark anywhere
VAGUE = 3.0  # what a place costs that is known to a millimetre
DOUBTFUL = 3.0  # what a place costs whose line is better known to end elsewhere
COVERED = 0.75  # the share of a vector that must be drawn


def slip(count: int) -> float:
    """What each of some mistakes of the catalogue costs: that it is just this one that was made."""
    return max(math.log(max(count, 1) / WRONG), SLIP)


def sigmas_of(off: complex, miss: Miss, sigma: float) -> float:
    """How far off a place is, in σ of drawing and of reading."""
    return replace(miss.blurred(sigma), off=off).sigmas


@dataclass
class InkCover:
    """The steps of a sheet's lines about a pole, and its arrowheads; ways are remembered."""

    seen: Seen
    pole: complex
    arrows: bool = True  # whether its lines are vectors
    steps: Complexes = field(init=False)
    tips: list[tuple[complex, complex]] = field(default_factory=list)  # and the unit way they point
    known: dict[tuple[complex, complex], tuple[int, int]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        found = [z for z in self.seen.patches if abs(z - self.pole) >= CROSS_MM]
        for line in self.seen.lines:
            if max(abs(z - self.pole) for z in line.ends) >= CROSS_MM:
                count = max(2, round(line.length / STEP_MM))
                found += [line.at(line.low + line.length * (k + 0.5) / count) for k in range(count)]
        steps = numpy.array(found, complex)
        self.steps = steps[~self.seen.ink.lettered(steps)]
        for line in self.seen.lines:
            for head in line.heads:
                tip, way = head.z, line.direction(head.s) * head.sign
                near = (w for t, w in self.tips if abs(tip - t) < TIP_NEAR_MM)
                if not any((way * w.conjugate()).real > TIP_STRAIGHT for w in near):
                    self.tips.append((tip, way))

    @property
    def headed(self) -> bool:
        """Whether the vectors of this drawing have heads at all."""
        return self.arrows and len(self.tips) > FEW * sum(x.length > 2 * HEADED_MM for x in self.seen.lines)

    def along(self, a: complex, b: complex) -> tuple[int, int]:
        """The steps a way from a to b runs along, and the heads at its end, as bits."""
        if (a, b) not in self.known:
            self.known[a, b] = self._steps(a, b), self._heads(a, b)
        return self.known[a, b]

    def _steps(self, a: complex, b: complex) -> int:
        length = abs(b - a)
        if not length or not len(self.steps):
            return 0
        local = (self.steps - a) * ((b - a).conjugate() / length)
        on = (abs(local.imag) < ROUTE_MM) & (local.real > -1) & (local.real < length + 1)
        return int.from_bytes(numpy.packbits(on).tobytes(), "big")

    def _heads(self, a: complex, b: complex) -> int:
        near = abs(b - a) * TIP_STRAIGHT
        return sum(
            1 << k
            for k, (tip, way) in enumerate(self.tips)
            if near and abs(tip - b) < TIP_NEAR_MM and ((b - a) * way.conjugate()).real > near
        )

    def bare(self, a: complex, b: complex) -> float:
        """What it costs to believe in a vector from a to b for want of a head."""
        surely = min((abs(b - a) - HEADED_MM) / HEADED_MM, 1.0)
        return NO_HEAD * surely if self.headed and surely > 0 and not self.pointed(a, b) else 0.0

    def pointed(self, a: complex, b: complex) -> bool:
        """Whether a vector from a to b has a head at its end."""
        return bool(self.along(a, b)[1] or self.seen.closer(a, b))

    def left(self, steps: int) -> float:
        """How many mm of ink are not among the steps."""
        return STEP_MM * (len(self.steps) - steps.bit_count())

    def explained(self, steps: int) -> float:
        """The share of the lines' ink that the steps are."""
        return 1 - self.left(steps) / max(sum(x.length for x in self.seen.lines), 1.0)

    def over(self, steps: int, heads: int) -> float:
        """What the ink and the heads cost that are not among these."""
        lost = len(self.tips) - heads.bit_count() if self.headed else 0
        return PER_MM * self.left(steps) + OTHER_HEAD * lost

    def price(self, routes: Iterable[tuple[complex, complex]]) -> float:
        """What vectors cost for want of heads, and what they leave over."""
        taken = [(self.along(a, b), self.bare(a, b)) for a, b in routes]
        steps, heads = (reduce(or_, (bits[k] for bits, _ in taken), 0) for k in (0, 1))
        return self.over(steps, heads) + sum(bare for _, bare in taken)
