"""What of a sheet's ink a drawing accounts for: its lines cut into short steps, its arrowheads, a bit for each.

A way from one place to another takes the steps it runs along and the head at its end; what no way takes was drawn for
some other reason. What hangs together with the pole, or with a line that is taken, is the drawing's, and what lies
among it; a table, a name or another plan that stands apart asks for no reason.
"""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import reduce
from operator import or_

import numpy

from planes.check.vision.marks.handwritten import HandWords
from planes.check.vision.marks.places import HEADED_MM, Seen
from planes.check.vision.strokes.hanging import hanging
from planes.check.vision.strokes.rubbed_out import GHOST
from planes.geometry.arrays import Array, Booleans, Complexes, Indices
from planes.words.frozen import frozen

STEP_MM = 0.5
ROUTE_MM = 0.9  # ink farther than this from a vector is not its own
PER_MM, OVERSHOT = 0.5, 0.1  # what a millimetre of ink costs that no vector runs along, and of a line drawn too far
OVER_MM, FAINT, TORN_OFF_MM = 30.0, 0.8, 6.0  # how far a construction line runs on, how dark to its vector; a gap in it
NO_HEAD, OTHER_HEAD = 2.9, 3.0  # what a longer vector costs that shows no head, and a head that is no vector's
CROSS_MM = 3.0  # what is nearer to the pole is its printed cross
SIGN_MM = (-6.0 - 8.4j, -1.4 - 1.6j)  # where its letter is printed on a blank, from the pole
TIP_NEAR_MM, TIP_STRAIGHT = 1.6, 0.94  # how far a head's tip may be from a vector's end; the cosine of its turn
UPON_MM = 0.6  # lines whose heads are farther aside are two vectors
FEW = 0.3  # heads for a line, at the least, for a missing one to mean anything
COVERED, STRANGE_MM = 0.75, 10.0  # the share of a vector that must be drawn; of its end, what tells a strange one


@frozen
class InkPart:
    """Lines that hang together: their steps and heads as bits, how many of them are long, and how long all are, mm."""

    steps: int
    heads: int
    long: int
    length: float


@dataclass
class InkCover:
    """The steps of a sheet's lines about a pole, and its arrowheads; ways are remembered."""

    seen: Seen
    pole: complex
    room: Sequence[complex]  # the marks of the right plan, mm from the pole
    arrows: bool = True  # whether its lines are vectors
    words: HandWords = field(default_factory=HandWords)  # by them
    steps: Complexes = field(init=False)
    dark: Array = field(init=False)  # how dark the picture is at every step
    parts: list[InkPart] = field(default_factory=list)  # what hangs together, the pole's own first
    tips: list[tuple[complex, complex]] = field(default_factory=list)  # and the unit way they point
    known: dict[tuple[complex, complex], tuple[int, int]] = field(default_factory=dict)
    overshot: dict[tuple[complex, complex], int] = field(default_factory=dict)
    _bare: dict[tuple[complex, complex], float] = field(default_factory=dict)
    _faint: dict[tuple[complex, complex], bool] = field(default_factory=dict)

    def __post_init__(self) -> None:
        lines = self.seen.lines
        numbers = hanging(lines, self.pole, self.room, self.seen.patches)
        steps, parts = self._stepped(numbers)
        dark = self.seen.ink.darkest(steps)
        kept = ~self.seen.ink.lettered(steps) & (parts >= 0) & ~self.on_sign(steps)
        kept &= dark > GHOST * numpy.median(dark[kept]) if kept.any() else True
        self.steps, parts, self.dark = steps[kept], parts[kept], dark[kept]
        heads = [0] * (max([0, *numbers]) + 2)  # the last are of no part
        for line, number in zip(lines, numbers, strict=False):
            for head in line.heads:
                crossed = abs(head.z - self.pole) < CROSS_MM  # its tip is not told from the printed cross
                tip, way = self.pole if crossed else head.z, line.direction(head.s) * head.sign
                if (
                    not any(_one_head(tip, way, other) for other in self.tips)
                    and not self.on_sign(numpy.array([tip]))[0]
                ):
                    heads[number] |= 1 << len(self.tips)
                    self.tips.append((tip, way))
        for k, bits in enumerate(heads):
            lengths = [x.length for x, n in zip(lines, numbers, strict=False) if n == k]
            self.parts.append(InkPart(_bits(parts == k), bits, sum(mm > 2 * HEADED_MM for mm in lengths), sum(lengths)))

    def _stepped(self, numbers: Sequence[int]) -> tuple[Complexes, Indices]:
        """Steps of all lines, and of what is on no line; and of which part each is."""
        found: list[complex] = []
        parts: list[int] = []
        lines = self.seen.lines
        for line, number in zip(lines, numbers, strict=False):
            if max(abs(z - self.pole) for z in line.ends) >= CROSS_MM:
                count = max(2, round(line.length / STEP_MM))
                found += [line.at(line.low + line.length * (k + 0.5) / count) for k in range(count)]
                parts += [number] * count
        for z, number in zip(self.seen.patches, numbers[len(lines) :], strict=True):
            if abs(z - self.pole) >= CROSS_MM:
                found.append(z)
                parts.append(number)
        return numpy.array(found, complex), numpy.array(parts, numpy.intp)

    def on_sign(self, z: Complexes) -> Booleans:
        """Whether places lie where a blank has its pole's letter: what is drawn over it, nobody can tell."""
        (low, high), off = SIGN_MM, z - self.pole
        inside = (off.real > low.real) & (off.real < high.real) & (off.imag > low.imag) & (off.imag < high.imag)
        found: Booleans = inside & (self.seen.ink.flat.by == "marks")
        return found

    @property
    def headed(self) -> bool:
        """Whether the vectors of this drawing have heads at all."""
        return self.arrows and self.parts[0].heads.bit_count() > FEW * self.parts[0].long

    def along(self, a: complex, b: complex) -> tuple[int, int]:
        """The steps a way from a to b runs along, and the heads at its end, as bits."""
        if (a, b) not in self.known:
            self.known[a, b] = self._steps(a, b), self._heads(a, b)
        return self.known[a, b]

    def _steps(self, a: complex, b: complex) -> int:
        if a == b or not len(self.steps):
            return 0
        s = self.far_along(a, b)
        return _bits((s > -1) & (s < abs(b - a) + 1))

    def far_along(self, a: complex, b: complex) -> Array:
        """How far along the way from a to b every step is; infinitely far what is not near it."""
        local = (self.steps - a) * ((b - a).conjugate() / abs(b - a))
        return numpy.where(abs(local.imag) < ROUTE_MM, local.real, math.inf)

    def beyond(self, routes: Iterable[tuple[complex, complex]]) -> int:
        """The steps of construction lines that run on past the ends of ways."""
        found = 0
        for a, b in routes if self.headed else ():
            if (a, b) not in self.overshot:
                self.overshot[a, b] = self._beyond(a, b) | self._beyond(b, a)
            found |= self.overshot[a, b]
        return found

    def _beyond(self, a: complex, b: complex) -> int:
        """The steps of a fainter line that runs straight on past b."""
        length, a = abs(b - a), self._straightened(a, b)
        if a == b or not len(self.steps):
            return 0
        s = self.far_along(a, b)
        own, further = (s > 0) & (s < length), numpy.flatnonzero((s > length) & (s < length + OVER_MM))
        further = further[numpy.argsort(s[further])]
        run = further[~numpy.logical_or.accumulate(numpy.diff(s[further], prepend=length) > TORN_OFF_MM)]
        fainter = self.dark[run] < FAINT * numpy.median(self.dark[own]) if own.any() else False
        run = run[fainter | self._plainly_past(b, self.steps[run])]
        return _bits(numpy.isin(numpy.arange(len(s)), run))

    def _plainly_past(self, b: complex, steps: Complexes) -> Booleans:
        """Which steps run on from where a vector has its head, or from the pole, if none of them shows a head."""
        marked = any(abs(tip - b) < TIP_NEAR_MM for tip in (self.pole, *(tip for tip, _ in self.tips)))
        further = (tip for tip, _ in self.tips if abs(tip - b) > 2 * TIP_NEAR_MM)
        headed = any((abs(steps - tip) < STEP_MM).any() for tip in further)
        return numpy.full(len(steps), marked and not headed)

    def _straightened(self, a: complex, b: complex) -> complex:
        """Where a vector begins: a short one by the line it is drawn upon, at its end b where it is on none."""
        if abs(b - a) > HEADED_MM:
            return a
        line = self.seen.line_upon(a, b) if abs(b - a) > 1 else None
        way = line.direction(line.local(b)[0]) if line else 0j
        return b - abs(b - a) * (way if ((b - a) * way.conjugate()).real > 0 else -way)

    def _heads(self, a: complex, b: complex) -> int:
        """The head nearest to b among those that point from a to b there: a vector has but one."""
        if a == b:
            return 0
        own = (b - a) / abs(b - a)
        near = [k for k, (tip, way) in enumerate(self.tips) if abs(tip - b) < TIP_NEAR_MM and _alike(own, way)]
        return 1 << min(near, key=lambda k: abs(self.tips[k][0] - b)) if near else 0

    def bare(self, a: complex, b: complex) -> float:
        """What it costs to believe in a vector from a to b for want of a head (remembered)."""
        if (a, b) not in self._bare:
            surely = min((abs(b - a) - HEADED_MM) / HEADED_MM, 1.0)
            self._bare[a, b] = NO_HEAD * surely if self.headed and surely > 0 and not self.pointed(a, b) else 0.0
        return self._bare[a, b]

    def pointed(self, a: complex, b: complex) -> bool:
        """Whether a vector from a to b has a head at its end."""
        return bool(self.along(a, b)[1] or self.seen.closer(a, b))

    def runs_out(self, a: complex, b: complex) -> bool:
        """Whether what seems a vector has no head and grows faint towards b: its end may be its construction line's
        (remembered)."""
        if (a, b) not in self._faint:
            self._faint[a, b] = self._runs_out(a, b)
        return self._faint[a, b]

    def _runs_out(self, a: complex, b: complex) -> bool:
        length = abs(b - a)
        if not self.headed or length < 2 * HEADED_MM or self.pointed(a, b):
            return False
        s = self.far_along(a, b)
        own, last = ((s > low) & (s < length) for low in (0, length - HEADED_MM))
        return bool(last.any()) and float(numpy.median(self.dark[last])) < FAINT * float(numpy.median(self.dark[own]))

    def taken(self, steps: int) -> list[InkPart]:
        """What is the drawing's own: what hangs together with the pole or with any of the steps."""
        return [self.parts[0], *(part for part in self.parts[1:] if part.steps & steps)]

    def explained(self, routes: Sequence[tuple[complex, complex]]) -> float:
        """The share of the drawing's ink that runs along some ways, or on past their ends."""
        steps = reduce(or_, (self.along(a, b)[0] for a, b in routes), 0)
        length = sum(part.length for part in self.taken(steps))
        return 1 - self._left(steps | self.beyond(routes)) / max(length, 1.0) if length else 0.0

    def _left(self, steps: int) -> float:
        """How much of the drawing's ink is not these steps, mm."""
        return STEP_MM * sum((part.steps & ~steps).bit_count() for part in self.taken(steps))

    def strangers(self, routes: Sequence[tuple[complex, complex]]) -> list[complex]:
        """Tips of the drawing's vectors that are none of these."""
        steps, heads = (reduce(or_, (self.along(a, b)[k] for a, b in routes), 0) for k in (0, 1))
        explained, drawn = steps | self.beyond(routes), reduce(or_, (part.heads for part in self.taken(steps)))
        left = [z for k, z in enumerate(self.tips) if self.headed and (drawn & ~heads) >> k & 1]
        own = ((tip, self.along(tip - STRANGE_MM * way, tip)[0] & ~explained) for tip, way in left)
        return [tip for tip, bits in own if STEP_MM * bits.bit_count() > COVERED * STRANGE_MM]

    def over(self, steps: int, heads: int, routes: Iterable[tuple[complex, complex]]) -> float:
        """What the drawing's ink and heads cost that are not among these, of the vectors that lead so."""
        left, apart = self._left(steps), self._left(steps | self.beyond(routes))
        lost = sum((part.heads & ~heads).bit_count() for part in self.taken(steps)) if self.headed else 0
        return PER_MM * apart + OVERSHOT * (left - apart) + OTHER_HEAD * lost

    def price(self, routes: Sequence[tuple[complex, complex]]) -> float:
        """What vectors cost for want of heads, and what they leave over."""
        taken = [(self.along(a, b), self.bare(a, b)) for a, b in routes]
        steps, heads = (reduce(or_, (bits[k] for bits, _ in taken), 0) for k in (0, 1))
        return self.over(steps, heads, routes) + sum(bare for _, bare in taken)


def _alike(way: complex, other: complex) -> bool:
    """Whether two unit ways are nearly one."""
    return (way * other.conjugate()).real > TIP_STRAIGHT


def _one_head(tip: complex, way: complex, other: tuple[complex, complex]) -> bool:
    """Whether two tips are seen of one head, by lines upon each other."""
    off = (tip - other[0]) * other[1].conjugate()
    return abs(off) < TIP_NEAR_MM and abs(off.imag) < UPON_MM and _alike(way, other[1])


def _bits(on: Booleans) -> int:
    return int.from_bytes(numpy.packbits(on).tobytes(), "big")
