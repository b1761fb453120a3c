"""Lines of a sheet and the places where they end, meet and cross: each with how surely it is known."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

from planes.check.ink import Ink
from planes.check.line_fitting import Fitted, fitted
from planes.check.picture import cv

END_MM = 2.2  # a line that stops nearer than this to a crossing may end there
CLEAR_MM, DIM_MM = 0.2, 1.2  # σ along a line of an end that stands free, of one within other ink
TIP_MM, TIP_REACH_MM = 0.4, 1.5  # σ of an arrowhead's tip along its line; how far it may be from a line's end
HIDDEN_MM = 9.0  # the most of a line's end that is hidden in another line's ink
PASSING_MM = 0.3  # σ of what was put on a line, off it
SAME_MM = 0.4  # places nearer than this are one
ROUTE_MM = 0.9  # ink farther than this from a vector is not its own
RIM_MM = 0.35  # of an arrowhead beside its line
LEAST_MM, SHORT_MM = 1.2, 7.0  # of strokes looked for in what is left of the ink
OWN = 0.22  # the share of a line that must be its own and not another's


@dataclass
class Place:
    """A place in mm, its σ in the worst direction, and the lines that end there: (number, side 0 or 1)."""

    z: complex
    sigma: float
    ended: frozenset[tuple[int, int]]
    tip: bool = False
    doubtful: bool = False  # the line that ends here is better known to end elsewhere


@dataclass
class Seen:
    """What is seen on a sheet."""

    ink: Ink
    lines: list[Fitted]
    places: list[Place] = field(default_factory=list)
    spots: Any = None  # the places as an array

    def within(self, z: complex, reach: float) -> list[Place]:
        """Places no farther than ``reach``."""
        import numpy

        if self.spots is None:
            self.spots = numpy.array([p.z for p in self.places], complex)
        return [self.places[i] for i in numpy.flatnonzero(numpy.abs(self.spots - z) <= reach)]

    @property
    def ink_mm(self) -> float:
        """The length of all lines."""
        return sum(x.length for x in self.lines)


    def left(self, routes: Sequence[tuple[complex, complex]], pole: complex) -> float:
        """How many mm of ink run along none of the routes; a printed cross at the pole aside."""
        import numpy

        total = 0.0
        a, b = (numpy.array([r[k] for r in routes] or [1e6 + 1e6j * k], complex) for k in (0, 1))
        way = numpy.abs(b - a)
        for line in self.lines:
            if max(abs(z - pole) for z in line.ends) < 3:
                continue
            count = max(2, int(line.length / 1.5))
            steps = [line.at(line.low + line.length * (k + 0.5) / count) for k in range(count)]
            local = (numpy.array(steps)[:, None] - a) * ((b - a).conjugate() / way)
            on = (abs(local.imag) < ROUTE_MM) & (local.real > -1) & (local.real < way + 1)
            total += line.length * float(1 - on.any(axis=1).mean())
        return total


def seen(ink: Ink, rough: Iterable[tuple[complex, complex]]) -> Seen:
    """Fit the rough lines to the ink, leave out what is another's, and find the places."""
    found = [f for f in (fitted(ink, a, b) for a, b in rough if abs(b - a) > 1.2) if f]
    for _ in range(2):  # now that more of each line is known
        found = [f for f in (fitted(ink, *x.ends) for x in found) if f]
    kept = own(found)
    short = [f for f in (fitted(ink, a, b) for a, b in _missed(ink, kept)) if f and f.length < SHORT_MM]
    out = Seen(ink, own([*kept, *short]))
    out.places = places_of(out.lines)
    return out


def _missed(ink: Ink, lines: Sequence[Fitted]) -> Iterator[tuple[complex, complex]]:
    """Short strokes of ink that no line runs along, by their ends: a small vector between two large ones."""
    import numpy

    cv2, flat, mask = cv(), ink.flat, ink.mask
    for line in lines:
        s = numpy.linspace(line.low - 0.5, line.high + 0.5, 9)
        path = numpy.array([flat.px(line.at(float(x))) for x in s]).round().astype(numpy.int32)
        cv2.polylines(mask, [path], False, 0, max(1, round((line.width + 2 * RIM_MM) * flat.scale)))
    _, labels, stats, _ = cv2.connectedComponentsWithStats(mask, connectivity=8)
    for k, (x, y, w, h, area) in enumerate(stats.tolist()):
        if k and LEAST_MM * flat.scale < max(w, h) < SHORT_MM * flat.scale and area > 0.2 * LEAST_MM * flat.scale**2:
            down, across = numpy.nonzero(labels[y : y + h, x : x + w] == k)
            z = (across + x) + 1j * (down + y)
            middle = complex(z.mean())
            z = z - middle
            u = numpy.exp(0.5j * numpy.angle((z * z).sum()))
            local = z * u.conjugate()
            if local.imag.std() < 0.25 * flat.scale:
                ends = [middle + u * t for t in (local.real.min(), local.real.max())]
                yield flat.mm(ends[0].real, ends[0].imag), flat.mm(ends[1].real, ends[1].imag)


def own(lines: Iterable[Fitted]) -> list[Fitted]:
    """The lines that are not, for the most part, on longer ones."""
    kept: list[Fitted] = []
    for line in sorted(lines, key=lambda x: -x.length):
        steps = max(4, int(line.length / 0.4))
        alone = 0
        for k in range(steps):
            z = line.at(line.low + line.length * (k + 0.5) / steps)
            alone += not any(_on(other, z) for other in kept)
        if alone > OWN * steps and alone * line.length / steps > 1.0:
            kept.append(line)
    return kept


def _on(line: Fitted, z: complex, reach: float = 0.5, beyond: float = 0.5) -> bool:
    s, off = line.local(z)
    return abs(off) < reach and line.low - beyond < s < line.high + beyond


@dataclass
class Normal:
    """Equations for a place: lines it lies on with their weights, summed up."""

    xx: float = 0.0
    xy: float = 0.0
    yy: float = 0.0
    x: float = 0.0
    y: float = 0.0

    def add(self, z: complex, n: complex, sigma: float) -> None:
        """The place is on the line through z across n, within sigma."""
        w, d = sigma**-2, (z * n.conjugate()).real
        self.xx += w * n.real * n.real
        self.xy += w * n.real * n.imag
        self.yy += w * n.imag * n.imag
        self.x += w * n.real * d
        self.y += w * n.imag * d

    def solved(self) -> tuple[complex, float]:
        """The place and its σ in the worst direction."""
        det = self.xx * self.yy - self.xy**2
        z = complex(self.yy * self.x - self.xy * self.y, self.xx * self.y - self.xy * self.x) / det
        least = (self.xx + self.yy) / 2 - math.hypot((self.xx - self.yy) / 2, self.xy)
        return z, least**-0.5 if least > 0 else math.inf


def crossing(one: Fitted, two: Fitted) -> complex | None:
    """Where two lines cross; None where they are nearly parallel."""
    s = (one.low + one.high) / 2
    r = (two.low + two.high) / 2
    for _ in range(3):
        a, u, b, w = one.at(s), one.direction(s), two.at(r), two.direction(r)
        turn = (u.conjugate() * w).imag
        if abs(turn) < 0.06:
            return None
        z = a + u * ((b - a).conjugate() * w).imag / turn
        s = min(max(one.local(z)[0], one.low - 3), one.high + 3)
        r = min(max(two.local(z)[0], two.low - 3), two.high + 3)
    return z


def places_of(lines: Sequence[Fitted]) -> list[Place]:
    """All places, the surest of those that are one."""
    starts: list[complex] = []
    for i, one in enumerate(lines):
        starts += one.ends
        for two in lines[:i]:
            z = crossing(one, two)
            if z is not None and all(x.low - END_MM < x.local(z)[0] < x.high + END_MM for x in (one, two)):
                starts.append(z)
    found = [_place(lines, z) for z in starts]
    found += [Place(x.at(s), TIP_MM, frozenset(), True) for x in lines for s, _ in x.tips]
    kept: list[Place] = []
    for one_place in sorted(found, key=lambda p: (p.tip, -len(p.ended), p.sigma)):
        if all(abs(one_place.z - k.z) > (SAME_MM if not one_place.tip else 2 * SAME_MM) for k in kept):
            sharper = (k for k in kept if k.ended & one_place.ended and k.sigma < 0.5 * one_place.sigma)
            one_place.doubtful = any(abs(k.z - one_place.z) < 1.5 * END_MM for k in sharper)
            kept.append(one_place)
    return kept


def _place(lines: Sequence[Fitted], start: complex) -> Place:
    """The place near ``start`` where the lines there meet best."""
    z, sigma, ended = start, 0.3, frozenset[tuple[int, int]]()
    for reach in (0.8, 0.45):
        eqs, ended_now = Normal(), set[tuple[int, int]]()
        near = [k for k, x in enumerate(lines) if _on(x, z, reach, END_MM)]
        for k in near:
            line = lines[k]
            s, _ = line.local(z)
            side = 0 if abs(s - line.low) < abs(s - line.high) else 1
            if abs(s - (line.low, line.high)[side]) < END_MM:
                ended_now.add((k, side))
                _add_end(eqs, line, side)
            elif any(_hidden(line, side, s, lines[j]) for j in near if j != k):
                ended_now.add((k, side))
            lateral = line.sigma if (k, side) in ended_now else math.hypot(line.sigma, PASSING_MM)
            eqs.add(line.at(s), 1j * line.direction(s), lateral)
        eqs.add(start, 1 + 0j, 30.0)
        eqs.add(start, 1j, 30.0)
        z, sigma = eqs.solved()
        ended = frozenset(ended_now)
        if abs(z - start) > 1.5:
            return Place(start, 0.5, frozenset())
    return Place(z, min(sigma, 2.0), ended)


def _add_end(eqs: Normal, line: Fitted, side: int) -> None:
    """That a line ends here, by its ink and by its arrowhead."""
    s = (line.low, line.high)[side]
    eqs.add(line.at(s), line.direction(s), CLEAR_MM if line.clear[side] else DIM_MM)
    for tip, sign in line.tips:
        if sign == 2 * side - 1 and abs(tip - s) < TIP_REACH_MM:
            eqs.add(line.at(tip), line.direction(s), TIP_MM)


def _hidden(line: Fitted, side: int, s: float, other: Fitted) -> bool:
    """Whether what is left of a line beyond s lies within another line's ink, so that it may well end at s."""
    end = (line.low, line.high)[side]
    return abs(end - s) < HIDDEN_MM and not line.clear[side] and abs(other.local(line.at(end))[1]) < 0.8
