"""Lines of a sheet and the places where they end, meet and cross: each with how surely it is known."""

import math
import statistics
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy

from planes.check.fiducials import within
from planes.check.vision.arrow_tips import ABOUT_MM, USUAL_MM, head_about, line_on_to
from planes.check.vision.drawn_lines import crossing, lines_of, on
from planes.check.vision.heads import head_at
from planes.check.vision.ink import Ink, ink_of
from planes.check.vision.line_fitting import Fitted
from planes.check.vision.lone_heads import LoneHeads
from planes.check.vision.picture import Flat
from planes.check.vision.residual_ink import left_over, patches
from planes.check.vision.rubbed_out import remaining
from planes.geometry.arrays import Complexes

END_MM = 2.2  # a line that stops nearer than this to a crossing may end there
CLEAR_MM, DIM_MM = 0.2, 1.2  # σ along a line of an end that stands free, of one within other ink
HEAD_MM, TIP_REACH_MM = 1.0, 1.5  # how far an arrowhead's tip may be from where it belongs, and from its line's end
HIDDEN_MM = 9.0  # the most of a line's end that is hidden in another line's ink
PASSING_MM = 0.3  # σ of what was put on a line, off it
TIP_MM, DIM_TIP_MM, CLOSER_MM = 0.3, 0.5, 2.0  # σ of a tip that was only looked for, or dimly seen; how far astray
HEADED_MM, HEADS = 4.5, 3  # shorter vectors have no head, twice as long ones surely do; so many tell how long all are
BEYOND_MM, LONGER = 4.0, 0.4  # how far past its end a line is looked for, and the share of ink by which it goes on
SAME_MM = 0.4  # places nearer than this are one
POLE_MM, WOBBLE_MM = 0.06, 0.2  # σ of where a line from the pole begins, of what a hand's wobble does to any mark
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
class Seen:
    """What is seen on a sheet."""

    ink: Ink
    lines: list[Fitted]
    places: list[Place] = field(default_factory=list)
    patches: list[complex] = field(default_factory=list)  # places of ink that is on no line
    spots: Complexes | None = None  # the places as an array
    looked: dict[tuple[complex, complex], Place | None] = field(default_factory=dict)
    fits: dict[tuple[int, float, int], complex | None] = field(default_factory=dict)  # heads on lines

    def within(self, z: complex, reach: float) -> list[Place]:
        """Places no farther than ``reach``."""
        if self.spots is None:
            self.spots = numpy.array([p.z for p in self.places], complex)
        return [self.places[i] for i in numpy.flatnonzero(numpy.abs(self.spots - z) <= reach)]

    def closer(self, start: complex, end: complex) -> Place | None:
        """The tip of the head a vector from start to end has about its end, looked for along it (remembered)."""
        key = rounded(start), rounded(end)
        if key not in self.looked:
            drawn = abs(end - start) > HEADED_MM and not self.all_ink.bare(end, CLOSER_MM)
            found, sigma = self._headed(start, end) if drawn else (None, TIP_MM)
            self.looked[key] = Place(found, sigma, frozenset(), True, self._short(start, found)) if found else None
        return self.looked[key]

    def _headed(self, start: complex, end: complex) -> tuple[complex | None, float]:
        """The tip of a vector's head, by the ink it explains about where its sides show it, or about the vector's end;
        and its σ."""
        shown = head_at(self.ink, start, end, CLOSER_MM, self.head_mm)
        fit = self._fitted(start, shown or end)
        lone = None if fit or shown else self.lone_heads.tip(start, end)
        return fit or shown or lone, TIP_MM if shown else DIM_TIP_MM

    def _fitted(self, start: complex, end: complex) -> complex | None:
        """The tip of a vector's head on a longer line, by the ink it explains there (remembered)."""
        on_line = line_on_to(self.lines, start, end)
        if on_line is None:
            return None
        key = id(on_line[0]), *on_line[1:]
        if key not in self.fits:
            self.fits[key] = head_about(self.ink, self.lines, *on_line, self.head_mm or USUAL_MM)
        tip = self.fits[key]
        return tip if tip is not None and abs(tip - end) < ABOUT_MM else None

    def torn(self, place: Place) -> bool:
        """Whether a line that ends at a place runs under what is printed, or has ink beyond that is no line's (what is
        torn off may be as small as letters are): it was not seen to its end."""
        for k, side in ((k, side) for k, side in place.ended if k >= 0):
            line, end = self.lines[k], self.lines[k].ends[side]
            way = BEYOND_MM * (2 * side - 1) * line.direction(line.high if side else line.low)
            others = (x for x in self.lines if x is not line)
            if self.all_ink.covered(end, end + way) > LONGER and not any(on(x, end + way / 2) for x in others):
                return True
        return any(within(place.z, square, END_MM) for square in self.ink.printed)

    @cached_property
    def all_ink(self) -> Ink:
        """The sheet's ink with its letters."""
        return replace(self.ink, even=self.ink.whole, letters=None)

    @cached_property
    def lone_heads(self) -> LoneHeads:
        """Heads that stand by themselves, among its letters, or that no line leads to."""
        return LoneHeads(self.all_ink, self.head_mm or USUAL_MM, [*left_over(self.ink, self.lines)])

    @cached_property
    def head_mm(self) -> float | None:
        """How long heads are; None where too few are seen."""
        found = [head.length for line in self.lines for head in line.heads]
        return statistics.median(found) if len(found) >= HEADS else None

    def _short(self, start: complex, tip: complex) -> bool:
        """Whether a line is better known to end but a little beyond the tip of a vector from start."""
        way = (tip - start) / abs(tip - start)
        near = (p.z - tip for p in self.within(tip, TIP_REACH_MM) if p.ended and p.sigma < TIP_MM)
        beyond = (off * way.conjugate() for off in near)
        return any(z.real > HEAD_MM / 2 and abs(z.imag) < HEAD_MM / 2 for z in beyond)


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


def rounded(z: complex) -> complex:
    """A place to a tenth of a millimetre, by which what was found there is remembered."""
    return complex(round(z.real, 1), round(z.imag, 1))


def sheet_of(flat: Flat, cross: complex | None = None) -> Seen | None:
    """What is seen on a flat picture with a cross printed at a place; None if more lines than a plan can have."""
    ink = ink_of(flat, cross)
    lines = lines_of(ink)
    drawn = remaining(flat, lines or [])
    return None if lines is None else Seen(ink, drawn, places_of(drawn), patches(ink, lines))


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
    found += [Place(h.z, h.sigma, frozenset(), True) for x in lines for h in x.heads]
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
        near = [k for k, x in enumerate(lines) if on(x, z, reach, END_MM)]
        for k in near:
            line = lines[k]
            s, _ = line.local(z)
            side = 0 if abs(s - line.low) < abs(s - line.high) else 1
            if abs(s - (line.low, line.high)[side]) < END_MM:
                ended_now.add((k, side))
                _add_end(eqs, line, side)
            elif any(_hidden(line, side, s, lines[j]) for j in near if j != k):
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


def _add_end(eqs: Normal, line: Fitted, side: int) -> None:
    """That a line ends here, by its ink and by its arrowhead."""
    s = (line.low, line.high)[side]
    eqs.add(line.at(s), line.direction(s), CLEAR_MM if line.clear[side] else DIM_MM)
    for head in () if line.clear[side] else line.heads:
        if head.sign == 2 * side - 1 and abs(head.s - s) < TIP_REACH_MM:
            eqs.add(line.at(head.s), line.direction(s), head.sigma)


def _hidden(line: Fitted, side: int, s: float, other: Fitted) -> bool:
    """Whether what is left of a line beyond s lies within another line's ink, so that it may well end at s."""
    end = (line.low, line.high)[side]
    return abs(end - s) < HIDDEN_MM and not line.clear[side] and abs(other.local(line.at(end))[1]) < 0.8


def pole_on(seen: Seen, near: complex, reach: float = 2.0) -> Place:
    """The pole: where it is printed (or was named), and where the lines drawn from it meet."""
    eqs, ended = Normal(), set[tuple[int, int]]()
    eqs.add(near, 1 + 0j, POLE_MM)
    eqs.add(near, 1j, POLE_MM)
    for k, line in enumerate(seen.lines):
        s, off = line.local(near)
        side = 0 if abs(s - line.low) < abs(s - line.high) else 1
        if abs(off) < 0.8 and abs(line.ends[side] - near) < reach and line.length > 2 * reach:
            eqs.add(line.at(s), 1j * line.direction(s), 2 * line.sigma)
            ended.add((k, side))
    z, sigma = eqs.solved()
    return Place(z, sigma, frozenset(ended))
