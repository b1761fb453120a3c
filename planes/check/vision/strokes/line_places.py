"""The places where lines end, meet and cross: each with how surely it is known, and the lines that end there."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import combinations

import numpy

from planes.check.vision.strokes.ink import Ink
from planes.check.vision.strokes.line_fitting import Fitted, Tip
from planes.check.vision.strokes.meeting import crossing, on

END_MM = 2.2  # a line that stops nearer than this to a crossing may end there
CLEAR_MM, DIM_MM = 0.2, 1.2  # σ along a line of an end that stands free, of one within other ink
HEAD_MM, TIP_REACH_MM = 1.0, 1.5  # how far an arrowhead's tip may be from where it belongs, and from its line's end
HIDDEN_MM = 9.0  # the most of a line's end that is hidden in another line's ink
PASSING_MM = 0.3  # σ of what was put on a line, off it
SAME_MM = 0.4  # places nearer than this are one
BARE, INKED = 0.25, 0.5  # of a line's darkness: where none is, and where one is
ASLANT, APART = 0.2, 3.0  # the sine between lines that run one way; how many σ their ends are apart, if they are two
WOBBLE_MM = 0.2  # what a hand's wobble does to any mark
LOOKED_FOR = 1.7  # how much less sure a person's mark is than the tip it was told by


@dataclass
class Place:
    """A place in mm, its σ in the worst direction, and the lines that end there: (number, side 0 or 1)."""

    z: complex
    sigma: float
    ended: frozenset[tuple[int, int]]
    tip: bool = False
    doubtful: bool = False  # the line that ends here is better known to end elsewhere

    @property
    def error_mm(self) -> float:
        """σ of a person's mark that is read here."""
        return math.hypot(self.sigma * (LOOKED_FOR if self.tip and not self.ended else 1.0), WOBBLE_MM)


@dataclass
class Normal:
    """Equations for a place: lines it lies on, a row each of its unit normal, its distance and its weight."""

    rows: list[tuple[float, float, float, float]] = field(default_factory=list)

    def add(self, z: complex, n: complex, sigma: float) -> None:
        """The place is on the line through z across n, within sigma."""
        self.rows.append((n.real, n.imag, (z * n.conjugate()).real, sigma**-2))

    def solved(self) -> tuple[complex, float]:
        """The place and its σ in the worst direction."""
        sums = ((0, 0), (0, 1), (1, 1), (0, 2), (1, 2))
        xx, xy, yy, x, y = (sum(row[3] * row[i] * row[j] for row in self.rows) for i, j in sums)
        z = complex(yy * x - xy * y, xx * y - xy * x) / (xx * yy - xy**2)
        least = (xx + yy) / 2 - math.hypot((xx - yy) / 2, xy)
        return z, least**-0.5 if least > 0 else math.inf


def places_of(lines: Sequence[Fitted], ink: Ink) -> list[Place]:
    """All places, the surest of those that are one."""
    starts: list[tuple[complex, frozenset[int]]] = []  # with the lines that end near by, but not there
    parted: dict[int, set[int]] = {}
    for i, one in enumerate(lines):
        for j, two in enumerate(lines[:i]):
            z = crossing(one, two)
            if z is None or not all(x.low - END_MM < x.local(z)[0] < x.high + END_MM for x in (one, two)):
                continue
            if _parted(ink, one, two, z):
                parted.setdefault(i, set()).add(j)
                parted.setdefault(j, set()).add(i)
            else:
                starts.append((z, frozenset()))
    for i, one in enumerate(lines):
        starts += [(z, frozenset(parted.get(i, ()))) for z in one.ends]
    found = [_place(lines, z, without) for z, without in starts]
    found += [Place(h.z, h.sigma, frozenset(), True) for x in lines for h in x.heads]
    kept: list[Place] = []
    for one_place in sorted(found, key=lambda p: (p.tip, -len(p.ended), p.sigma)):
        if all(abs(one_place.z - k.z) > (SAME_MM if not one_place.tip else 2 * SAME_MM) for k in kept):
            sharper = (k for k in kept if k.ended & one_place.ended and k.sigma < 0.5 * one_place.sigma)
            one_place.doubtful = any(abs(k.z - one_place.z) < 1.5 * END_MM for k in sharper)
            kept.append(one_place)
    return kept


def _parted(ink: Ink, one: Fitted, two: Fitted, z: complex) -> bool:
    """Whether two lines end before they would meet, where a short stroke leads from one end to the other."""
    a, b = (min(x.ends, key=lambda end: abs(end - z)) for x in (one, two))
    if not (SAME_MM < abs(a - b) < END_MM and all(SAME_MM < abs(end - z) < END_MM for end in (a, b))):
        return False
    return bool(ink.at(numpy.array([z]))[0] < BARE and (ink.at(numpy.linspace(a, b, 5, dtype=complex)) > INKED).all())


def _place(lines: Sequence[Fitted], start: complex, without: frozenset[int] = frozenset()) -> Place:
    """The place near ``start`` where the lines there meet best, ``without`` some."""
    z, sigma, ended = start, 0.3, frozenset[tuple[int, int]]()
    for reach in (0.8, 0.45):
        eqs, ended_now = Normal(), set[tuple[int, int]]()
        near = [k for k, x in enumerate(lines) if k not in without and on(x, z, reach, END_MM)]
        elsewhere = _elsewhere(lines, near, z)
        for k in near:
            line = lines[k]
            s, _ = line.local(z)
            side = nearer_end(line, s)
            may_end = k not in elsewhere
            if may_end and abs(s - (line.low, line.high)[side]) < END_MM:
                ended_now.add((k, side))
                _add_end(eqs, line, side)
            elif may_end and any(_hidden(line, side, s, lines[j]) for j in near if j != k):
                ended_now.add((k, side))
            heads = [h for h in line.heads if abs(h.s - s) < HEAD_MM and (k, side) not in ended_now]
            for head in heads:  # a vector ends here, and another goes on
                eqs.add(head.z, line.direction(s), head.sigma)
            lateral = line.sigma if (k, side) in ended_now else math.hypot(line.sigma, PASSING_MM)
            eqs.add(heads[0].z if heads else line.at(s), 1j * line.direction(s), lateral)
        eqs.add(start, 1 + 0j, 30.0)
        eqs.add(start, 1j, 30.0)
        z, sigma = eqs.solved()
        ended = frozenset(ended_now)
        if abs(z - start) > 1.5:
            return Place(start, 0.5, frozenset())
    return Place(z, min(sigma, 2.0), ended)


def _elsewhere(lines: Sequence[Fitted], near: Sequence[int], z: complex) -> set[int]:
    """Which of the lines near a place plainly end elsewhere: of two that come one way and end apart, the farther."""
    ends, found = list[tuple[int, complex, float, complex]](), set[int]()
    for k in near:
        line, (s, _) = lines[k], lines[k].local(z)
        side = nearer_end(line, s)
        if abs(s - (line.low, line.high)[side]) < END_MM:
            ends.append((k, *_told(line, side), line.along * (2 * side - 1)))
    for (k, one, sigma, way), (j, other, vague, along) in combinations(sorted(ends, key=lambda e: abs(e[1] - z)), 2):
        turn = way * along.conjugate()
        if turn.real > 0 and abs(turn.imag) < ASLANT and abs(one - other) > APART * math.hypot(sigma, vague):
            found |= {j} if k not in found else set[int]()
    return found


def nearer_end(line: Fitted, s: float) -> int:
    """Which of a line's ends, 0 or 1, a place along it is nearer to."""
    return 0 if abs(s - line.low) < abs(s - line.high) else 1


def _told(line: Fitted, side: int) -> tuple[complex, float]:
    """Where a line ends, by the tip of its head or by its ink, and the σ of that."""
    s = (line.low, line.high)[side]
    tip = min(_tips(line, side), key=lambda h: h.sigma, default=None)
    return (line.at(tip.s), tip.sigma) if tip else (line.at(s), CLEAR_MM if line.clear[side] else DIM_MM)


def _tips(line: Fitted, side: int) -> list[Tip]:
    """The tips of heads that tell where a line ends; none where its ink does."""
    s = (line.low, line.high)[side]
    return [h for h in line.heads if h.sign == 2 * side - 1 and abs(h.s - s) < TIP_REACH_MM and not line.clear[side]]


def _add_end(eqs: Normal, line: Fitted, side: int) -> None:
    """That a line ends here, by its ink and by its arrowhead."""
    s = (line.low, line.high)[side]
    eqs.add(line.at(s), line.direction(s), CLEAR_MM if line.clear[side] else DIM_MM)
    for head in _tips(line, side):
        eqs.add(line.at(head.s), line.direction(s), head.sigma)


def _hidden(line: Fitted, side: int, s: float, other: Fitted) -> bool:
    """Whether what is left of a line beyond s lies within another line's ink, so that it may well end at s."""
    end = (line.low, line.high)[side]
    return abs(end - s) < HIDDEN_MM and not line.clear[side] and abs(other.local(line.at(end))[1]) < 0.8
