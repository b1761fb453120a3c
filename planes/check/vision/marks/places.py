"""What is seen on a sheet: its ink, its lines and the places where they end, meet and cross."""

import statistics
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy

from planes.check.fiducials import within
from planes.check.vision.image.picture import Flat
from planes.check.vision.strokes.arrow_tips import ABOUT_MM, USUAL_MM, head_about
from planes.check.vision.strokes.drawn_lines import lines_of
from planes.check.vision.strokes.drawn_over import OVER_MM, ends_upon
from planes.check.vision.strokes.heads import PENCIL_MM, head_at
from planes.check.vision.strokes.ink import Ink, ink_of
from planes.check.vision.strokes.line_fitting import Fitted, Tip
from planes.check.vision.strokes.line_places import END_MM, HEAD_MM, TIP_REACH_MM, Normal, Place, nearer_end, places_of
from planes.check.vision.strokes.lone_heads import LoneHeads
from planes.check.vision.strokes.meeting import line_on_to, on
from planes.check.vision.strokes.residual_ink import left_over, patches
from planes.check.vision.strokes.rubbed_out import remaining
from planes.check.vision.strokes.tip_edges import SIGMA_MM, ending
from planes.geometry.arrays import Complexes

TIP_MM, DIM_TIP_MM, CLOSER_MM = 0.3, 0.5, 2.0  # σ of a tip that was only looked for, or dimly seen; how far astray
HEADED_MM, HEADS = 4.5, 3  # shorter vectors have no head, twice as long ones surely do; so many tell how long all are
BEYOND_MM, LONGER = 4.0, 0.4  # how far past its end a line is looked for, and the share of ink by which it goes on
UPON_MM = 0.4  # how far off a line the vector may be that is drawn as it
STRAIGHT = 0.94  # the cosine between ways that are nearly one
POLE_MM = 0.06  # σ of where a line from the pole begins


@dataclass
class Seen:
    """What is seen on a sheet."""

    ink: Ink
    lines: list[Fitted]
    places: list[Place] = field(default_factory=list)
    patches: list[complex] = field(default_factory=list)  # places of ink that is on no line
    spots: Complexes | None = None  # the places as an array
    looked: dict[tuple[complex, complex], Place | None] = field(default_factory=dict)
    inked: dict[tuple[complex, complex], float] = field(default_factory=dict)  # ways between places
    fits: dict[tuple[int, float, int], Tip | None] = field(default_factory=dict)  # heads on lines
    upon: dict[int, list[tuple[float, int]]] = field(default_factory=dict)  # where vectors end on lines, without heads
    read: dict[tuple[str, ...], Any] = field(default_factory=dict)  # words, by the names they may be

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
            if found and (edge := ending(self.ink, found, (found - start) / abs(found - start), PENCIL_MM)):
                found, sigma = edge, SIGMA_MM
            if found is None and drawn and self.head_mm is None:
                found, sigma = self._upon(start, end), OVER_MM
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
        if tip is None or abs(tip.z - end) > ABOUT_MM or self._against(tip, (end - start) / abs(end - start)):
            return None
        return tip.z

    def _upon(self, start: complex, end: complex) -> complex | None:
        """Where a vector without a head ends upon a line that goes on at its end, as that is lighter from there on."""
        on_line = line_on_to(self.lines, start, end)
        if on_line is None:
            return None
        line, _, sign = on_line
        if id(line) not in self.upon:
            self.upon[id(line)] = ends_upon(self.ink, line)
        near = [line.at(s) for s, way in self.upon[id(line)] if way == sign]
        return min((z for z in near if abs(z - end) < CLOSER_MM), key=lambda z: abs(z - end), default=None)

    def _against(self, tip: Tip, way: complex) -> bool:
        """Whether the ink of a head that points a way is that of one seen to point back, which it shows better."""
        size = self.head_mm or USUAL_MM
        heads = ((h.z, x.direction(h.s) * h.sign) for x in self.lines for h in x.heads if h.gain > tip.gain)
        back = ((z - tip.z) / way for z, own in heads if (own / way).real < -STRAIGHT)
        return any(abs(off.imag) < HEAD_MM and abs(off.real + size) < size - UPON_MM for off in back)

    def line_upon(self, a: complex, b: complex) -> Fitted | None:
        """The longest line that runs by two places."""
        upon = (x for x in self.lines if all(on(x, z, UPON_MM, UPON_MM) for z in (a, b)))
        return max(upon, key=lambda x: x.length, default=None)

    def covered(self, a: complex, b: complex) -> float:
        """The share of the way from ``a`` to ``b`` along which there is ink; all of it where a bent line runs
        (remembered)."""
        if (a, b) not in self.inked:
            self.inked[a, b] = 1.0 if self.line_upon(a, b) else self.ink.covered(a, b)
        return self.inked[a, b]

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
        return LoneHeads(self.all_ink, self.head_mm or USUAL_MM, [*left_over(self.all_ink, self.lines)])

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


def rounded(z: complex) -> complex:
    """A place to a tenth of a millimetre, by which what was found there is remembered."""
    return complex(round(z.real, 1), round(z.imag, 1))


def sheet_of(flat: Flat, cross: complex | None = None) -> Seen | None:
    """What is seen on a flat picture with a cross printed at a place; None if more lines than a plan can have."""
    ink = ink_of(flat, cross)
    lines = lines_of(ink)
    drawn = remaining(flat, lines or [])
    return None if lines is None else Seen(ink, drawn, places_of(drawn, ink), patches(ink, lines))


def pole_on(seen: Seen, near: complex, reach: float = 2.0) -> Place:
    """The pole: where it is printed (or was named), and where the lines drawn from it meet."""
    eqs, ended = Normal(), set[tuple[int, int]]()
    eqs.add(near, 1 + 0j, POLE_MM)
    eqs.add(near, 1j, POLE_MM)
    for k, line in enumerate(seen.lines):
        s, off = line.local(near)
        side = nearer_end(line, s)
        if abs(off) < 0.8 and abs(line.ends[side] - near) < reach and line.length > 2 * reach:
            eqs.add(line.at(s), 1j * line.direction(s), 2 * line.sigma)
            ended.add((k, side))
    z, sigma = eqs.solved()
    return Place(z, sigma, frozenset(ended))
