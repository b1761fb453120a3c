"""Ink across a line, row by row: where the line's own middle is, though others may run close beside it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy

from planes.geometry.arrays import Array, Booleans

CELL_MM = 0.1  # of a row across the line
UPON_MM = 0.15  # lines nearer than this are in the same place


def nearest(off: Array) -> tuple[Array, Array, Booleans]:
    """How far the nearest other line is on the left and on the right, and whether one is in the very same place."""
    left = numpy.where(off > 0, off, numpy.inf).min(axis=0)
    right = numpy.where(off < 0, -off, numpy.inf).min(axis=0)
    return left, right, numpy.asarray((numpy.abs(off) < UPON_MM).any(axis=0))


@dataclass
class Rows:
    """Ink across a line, a row every step: what is nearer to the line than to any beside it."""

    dark: Array
    t: Array
    middle: Array
    left: Array  # how far another line is
    right: Array
    upon: Booleans
    reach: float

    def __post_init__(self) -> None:
        self.off = self.t[None, :] - self.middle[:, None]
        own = (self.off < self.left[:, None] / 2) & (self.off > -self.right[:, None] / 2)
        near, far = numpy.abs(self.off) < self.reach, numpy.abs(self.off) < self.reach + 0.3
        ink = self.dark * (own & near)
        self.mass = ink.sum(axis=1) * CELL_MM
        self.rim = (self.dark * (own & far & ~near)).sum(axis=1) * CELL_MM
        self.centroid = self.middle + (ink * self.off).sum(axis=1) * CELL_MM / numpy.maximum(self.mass, 1e-6)

    def middles(self, width: float) -> tuple[Booleans, Array]:
        """Which rows tell where the line's middle is, and where: by all of its ink, or by its free edge."""
        apart = width + 0.1
        lone = (self.left > apart) & (self.right > apart)
        good = lone & (self.mass > 0.4 * width) & (self.mass < 1.45 * width) & (self.rim < 0.04) & ~self.upon
        found = self.centroid
        for sign, covered, free in ((-1, self.left, self.right), (1, self.right, self.left)):
            edge, seen = self._edge(sign)
            one_sided = (covered <= apart) & (free > apart) & ~self.upon & seen
            found = numpy.where(one_sided, edge - sign * width / 2, found)
            good = good | one_sided
        return good, found

    def _edge(self, sign: int) -> tuple[Array, Booleans]:
        """Where the ink ends to the left (1) or to the right (-1) of the middle, and where that is near."""
        dark, t = self.dark[:, ::sign], self.t[::sign]
        beyond = (dark < 0.5) & (sign * self.off[:, ::sign] > 0)
        k = numpy.argmax(beyond, axis=1)
        i, rows = numpy.maximum(k, 1), numpy.arange(len(dark))
        inner, outer = dark[rows, i - 1], dark[rows, i]
        share = (inner - 0.5) / numpy.maximum(inner - outer, 1e-6)
        edge = t[i - 1] + sign * CELL_MM * share
        far = sign * (edge - self.middle)
        return edge, (k > 0) & (inner >= 0.5) & (far > 0.05) & (far < 0.7)
