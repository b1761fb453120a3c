"""The lines of a file, asked as a sheet's ink is: where they end, their heads and texts are known, not felt."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

import numpy

from planes.check.evidence.line_words import LineWords, words_of
from planes.check.evidence.sheet_ink import PX_PER_MM, WAYS, SheetInk
from planes.check.reading.strokes import ReadDrawing, headed
from planes.geometry.arrays import Array, Booleans, Complexes, Greys
from planes.words.naming import Names

RIM_MM = 30.0  # of paper about the lines
FELT = (0.45, 0.5), (0.25, 1.0)  # turned by so many radians from a way a line is felt so much
HEADLESS = 0.5  # how much a line without a head is a vector, where vectors have heads
HEAD_RANGE = -2.5, 2.5  # what speaks against a head that is not there, and for one that is
TIP_MM, ALONG = 1.2, 0.97  # a head is no farther from the end of its line, and points along it (the cosine)
FEW, LEAST_TURN = 60, 0.1  # lines of which crossings are looked for; sine of their angle
STRANGE_MM = 12.0  # a vector that is none of the plan's counts for no more: there may be others beside it
WHOLE = 0.9  # the share of a vector that must be explained for all of it to be
SHORT_MM = 1.5  # of a line whose head tells nothing


class LineInk(SheetInk):
    """The lines of a drawing."""

    def __init__(self, sketch: ReadDrawing, names: Names) -> None:
        self.sketch, self.names, self.source = sketch, names, None
        self.lines: Complexes = numpy.array(sketch.strokes, complex).reshape(-1, 2)
        rim = RIM_MM * (1 + 1j)
        low = complex(self.lines.real.min(), self.lines.imag.min()) - rim
        size = complex(self.lines.real.max(), self.lines.imag.max()) + rim - low
        self.corner, self.top, self.reach_mm = low, (low + size).imag, abs(size)
        self.height, self.width = (math.ceil(mm * PX_PER_MM) for mm in (size.imag, size.real))
        v: Complexes = self.lines[:, 1] - self.lines[:, 0]
        length: Array = numpy.abs(v)
        self.u: Complexes = v / length
        self.way = numpy.array([sketch.way(k) for k in range(len(v))])
        self.headed = bool(headed(sketch))
        self.shares = self._felt()
        self.points, self.ways, self.mm = self._pieces(length)
        free = self.lines if self.headed else self.lines.ravel()
        back, ahead = self.way < 0, self.way > 0
        self.tips: Complexes = numpy.r_[free[ahead, 1], free[back, 0]] if self.headed else free
        self.tip_ways: Complexes = (
            numpy.r_[self.u[ahead], -self.u[back]] if self.headed else numpy.stack([-self.u, self.u], axis=1).ravel()
        )
        if not self.headed and len(self.lines) < FEW:  # lines may run on past where vectors end
            k, j = numpy.triu_indices(len(self.lines), 1)
            met, crossed = crossings(self.lines[k], self.lines[j])
            ways = numpy.stack([self.u[k], -self.u[k], self.u[j], -self.u[j]])[:, crossed]
            self.tips = numpy.r_[self.tips, numpy.tile(met[crossed], 4)]
            self.tip_ways = numpy.r_[self.tip_ways, ways.ravel()]
        self.rounds: Complexes = numpy.array([z for z, _ in sketch.rounds], complex)

    def _felt(self) -> tuple[Array, ...]:
        """What share of a line is there, as of a sheet's ink; lines without heads first, under the vectors."""
        planes = numpy.zeros((WAYS, self.height, self.width), numpy.uint8)
        turn = numpy.angle(self.u)
        for k in range(WAYS):
            off = abs(numpy.angle(numpy.exp(2j * (turn + math.pi * k / WAYS)))) / 2
            share = numpy.select([off < within for within, _ in FELT[::-1]], [share for _, share in FELT[::-1]])
            grey = (255 * share * numpy.where((self.way == 0) & self.headed, HEADLESS, 1.0)).astype(numpy.uint8)
            for n in numpy.argsort(grey)[(grey == 0).sum() :].tolist():  # the plainest last
                a, b = ((self.lines[n] - self.corner) * PX_PER_MM).tolist()
                z = a + (b - a) * numpy.linspace(0.0, 1.0, 2 + math.ceil(2 * abs(b - a)))
                planes[k, self.height - 1 - z.imag.astype(int), z.real.astype(int)] = grey[n]
        wider: list[Array] = [_wider(planes, n).ravel() for n in (2, 3, 5)]
        return tuple(wider)

    def _pieces(self, length: Array) -> tuple[Complexes, Complexes, Array]:
        """Pieces of the lines by their middles, with their ways and how long they are; of lines without heads, where
        vectors have them, nothing is to be explained."""
        counts = numpy.ceil(length * PX_PER_MM).astype(int).clip(1)
        line_of = numpy.repeat(numpy.arange(len(length)), counts)
        at = numpy.concatenate([(numpy.arange(n) + 0.5) / n for n in counts.tolist()])
        mm = numpy.where(self.headed & (self.way == 0), 0.0, length / counts)
        self.line_of = line_of
        return self.lines[line_of, 0] + at * (length * self.u)[line_of], self.u[line_of], mm[line_of]

    def _left(self, mm: Array, mine: Booleans, running: Booleans, kept: Booleans) -> float:
        """A vector is explained from end to end or not at all."""
        if not self.headed:
            return super()._left(mm, mine, running, kept)
        every, own = (numpy.bincount(self.line_of[kept], held, len(self.lines)) for held in (mm, mm * mine))
        return float(every[own < WHOLE * every].clip(max=STRANGE_MM).sum())

    def head(self, a: Complexes, b: Complexes) -> Array:
        """How much speaks for a line's ending at b: a tip there or, where no line has a head, an end."""
        length = abs(b - a)
        u = (b - a) / numpy.maximum(length, 1e-9)
        aside = (u[..., None] * self.tip_ways.conj()).real < ALONG
        off = (abs(b[..., None] - self.tips) + TIP_MM * aside).min(axis=-1, initial=TIP_MM)
        return numpy.where(length > SHORT_MM, _told(off), 0.0)

    def point(self, z: Complexes) -> Array:
        """How much speaks for a point's being at each place: a small circle there."""
        if not self.rounds.size:
            return super().point(z)
        return _told(abs(z[..., None] - self.rounds).min(axis=-1))

    def words(self, a: Complexes, b: Complexes, with_heads: bool, names: Iterable[str]) -> LineWords:
        """The texts that are some names."""
        return words_of(self.sketch, self.names, names)


def _wider(planes: Greys, n: int) -> Any:
    """The most within n pixels about each, both ways."""
    for axis in (1, 2):
        planes = numpy.max([numpy.roll(planes, k, axis) for k in range(-((n - 1) // 2), n // 2 + 1)], axis=0)
    return planes


def crossings(one: Complexes, two: Complexes) -> tuple[Complexes, Booleans]:
    """Where lines cross, row by row, and whether they do, well inside of both."""
    v, u, off = one[:, 1] - one[:, 0], two[:, 1] - two[:, 0], two[:, 0] - one[:, 0]
    turn = (v.conj() * u).imag
    with numpy.errstate(all="ignore"):
        s, t = (off.conj() * u).imag / turn, (off.conj() * v).imag / turn
        crossed = (abs(turn) > LEAST_TURN * abs(v * u)) & (s > 0) & (s < 1) & (t > 0) & (t < 1)
    return one[:, 0] + numpy.where(crossed, s, 0.0) * v, crossed


def _told(off: Array) -> Array:
    """How much a sign tells that is so far off."""
    low, high = HEAD_RANGE
    said: Array = high - (high - low) * numpy.minimum(off / TIP_MM, 1.0)
    return said
