"""Arrowheads as a program prints them: filled triangles of known size, told to 0.1 mm by their bases."""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy

from planes.check.vision.ink import Ink
from planes.check.vision.line_fitting import Fitted
from planes.geometry.arrays import Array, Complexes

STEP_MM = 0.05
HEADLESS_MM = 1.2  # a shorter vector has no head
INSIDE_MM, OUTSIDE_MM = 0.15, 0.3  # how far from a head's edge its ink is surely seen, and paper is
FULL, BARE = 0.93, 0.8  # the least shares of a head's places that are ink, of those outside of a side that are paper
HEAD, BOTH_SIDES = 0.79, 1.8  # how clear a head is of which one side is seen, or both are
HIDDEN = 0.1  # how clear a head is within other ink
DOUBTFUL = 1.5  # how clear a head is at the most whose tip and shaft are not seen to be narrow
SHAFT_MM = 1.0  # of a shaft, that tells its pen: another line that crosses a thick one looks like a thin head's base
SAME_MM, ALONG = 0.7, 0.98  # heads whose tips, or bases, are nearer than this and that point one way are one
CLEARER = 0.1  # by which another one may be there
TURNED = 0.995  # the least cosine of a head's turn from its vector


class HeadShape(NamedTuple):
    """A head on a line of a pen, mm."""

    long: float
    wide: float
    pen: float


THICK, THIN = HeadShape(4.0, 1.6, 0.6), HeadShape(3.0, 1.0, 0.25)


class PrintedHead(NamedTuple):
    """A head: its tip, the unit way it points, and how clear it is: near 2 where both of its sides are seen."""

    tip: complex
    way: complex
    clear: float


def shapes(length_mm: float) -> list[HeadShape]:
    """The heads a vector of that length may have: on a short one half as long as it."""
    found = []
    for long, wide, pen in (THICK, THIN) if length_mm >= HEADLESS_MM else ():
        shrink = min(1.0, 0.5 * length_mm / long)
        found.append(HeadShape(long * shrink, max(wide * shrink, min(wide, 1.7 * pen)), pen))
    return found


def clearness(ink: Ink, tips: Complexes, ways: Complexes, shape: HeadShape) -> Array:
    """How clear a head is at each of some tips: nearly 1 for each of its sides that is seen, 0 where it has no ink."""
    long, wide, pen = shape

    def dark(along: Array, aside: Array) -> Array:
        return ink.at(tips[:, None] + ways[:, None] * (along + 1j * aside)[None, :])

    within = numpy.linspace(INSIDE_MM - long, -0.3 * long, 6)
    half = numpy.maximum(-within * wide / (2 * long) - INSIDE_MM, 0)
    inside = numpy.concatenate([dark(within, k * half) for k in (-1, 0, 1)], axis=1)
    shaft = dark(numpy.array([-long - 0.15, -long - 0.4]), numpy.zeros(2))
    beside = numpy.linspace(0.1 - long, -0.25 * long, 6)
    base = numpy.linspace(pen / 2 + 0.25, max(wide / 2, pen / 2 + 0.3), 3)
    found, narrow = numpy.zeros(len(tips)), numpy.ones(len(tips), bool)
    for k in (-1, 1):
        shaft_side = dark(numpy.linspace(-long - SHAFT_MM, -long - 0.25, 5), numpy.full(5, k * (pen / 2 + 0.075)))
        narrow &= (shaft_side < 0.5).mean(axis=1) > 0.5
        narrow &= dark(numpy.array([-0.1 * long]), numpy.array([k * (0.05 * wide + 0.2)]))[:, 0] < 0.5
        out = dark(beside, k * (OUTSIDE_MM - beside * wide / (2 * long)))
        behind, front = (dark(numpy.full(3, z - long), k * (base - a)) for z, a in ((-0.25, 0.0), (0.25, 0.1)))
        seen = ((out < 0.5).mean(axis=1) > BARE) & (behind < 0.5).all(axis=1)
        found += numpy.where(seen, 0.5 + (front.mean(axis=1) - behind.mean(axis=1)) / 2, 0.0)
    found = numpy.maximum(numpy.where(narrow, found, numpy.minimum(found, DOUBTFUL)), HIDDEN)
    clear: Array = numpy.where(((inside > 0.5).mean(axis=1) > FULL) & (shaft > 0.5).all(axis=1), found, 0.0)
    return clear


def heads_along(
    ink: Ink, a: complex, b: complex, length_mm: float, aside: Sequence[float] = (0.0,), least: float = HEAD
) -> list[PrintedHead]:
    """The heads of vectors of a length whose tips are on the way from a to b, or so far to the left of it."""
    way, found = (b - a) / abs(b - a), list[tuple[PrintedHead, complex]]()
    on = numpy.linspace(a, b, max(2, round(abs(b - a) / STEP_MM)))
    tips = (on[None, :] + 1j * way * numpy.array(aside)[:, None]).ravel()
    for shape in shapes(length_mm):  # the ink of a thick head holds a thin one
        clear = clearness(ink, tips, numpy.full(len(tips), way), shape)
        for k in numpy.argsort(-clear)[: int((clear >= least).sum())]:
            tip = complex(tips[k])
            base = tip - shape.long * way
            better = clear[k] - CLEARER
            if all(min(abs(tip - h.tip), abs(base - z)) > SAME_MM or h.clear < better for h, z in found):
                found.append((PrintedHead(tip, way, float(clear[k])), base))
    return [head for head, _ in found]


def heads_on(ink: Ink, lines: Sequence[Fitted]) -> list[PrintedHead]:
    """The heads of long vectors along lines."""
    found = []
    for a, b in (line.ends for line in lines):
        u = (b - a) / abs(b - a)
        found += [h for way in ((a - u, b + u), (b + u, a - u)) for h in heads_along(ink, *way, math.inf)]
    kept: list[PrintedHead] = []
    for one in sorted(found, key=lambda h: -h.clear):
        if all(abs(one.tip - k.tip) > SAME_MM or (one.way / k.way).real < ALONG for k in kept):
            kept.append(one)
    return kept
