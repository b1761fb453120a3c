"""How a picture sees a sheet that has no print of ours: told by its squares, else its ruled lines, else its edges.

Squares give all of it, millimetres too. Equally spaced lines give the horizon of the sheet's plane; what that leaves
open is how long the lens is, and telephones' are nearly alike. Edges give a rectangle, its shape the paper's format.
"""

import math
from dataclasses import dataclass

import numpy

from planes.check.vision.image.bend import Bend, through
from planes.check.vision.image.frame import shape_of
from planes.check.vision.image.lens import FOCAL, MOST_TILT_DEG, level
from planes.check.vision.image.picture import cv
from planes.check.vision.image.ruling import CLEAR, LEAST, Wave, waves_of
from planes.check.vision.image.sheet_edges import edges_of
from planes.geometry.arrays import Array, Complexes, Greys

SQUARE_MM, LINES_MM = 5.0, 8.0
AGREEING, OFF = 0.6, 0.12  # the share of clear windows that agree, within that share of a line's distance
LENSES = numpy.linspace(-0.08, 0.08, 17)
A_SHAPE, NEAR_SHAPE, A4_MM = math.sqrt(2), 0.03, (297.0, 210.0)


@dataclass(frozen=True)
class SheetView:
    """How pixels of a picture lie on its sheet, mm (y down, any origin), and by what that is told."""

    bend: Bend
    by: str  # "squares", "lines", "edges"; the "plan" itself, whose scale is unknown
    tilt_deg: float  # of the camera from straight above


def sheet_view(grey: Greys, px_per_mm: float, scanned: bool) -> SheetView | None:
    """How a sheet is seen, by the surest of what tells it; pixels to a millimetre are known but roughly."""
    across, down = waves_of(grey, px_per_mm * SQUARE_MM)
    if across and down and (found := _by_squares(grey, across, down)):
        return found
    _, down = waves_of(grey, px_per_mm * LINES_MM)
    if down and (found := _by_lines(grey, down)):
        return found
    return None if scanned else _by_edges(grey)


def _by_squares(grey: Greys, across: Wave, down: Wave) -> SheetView | None:
    """By squares that are counted; the lens makes their lines straightest."""
    clear = (across.clear > CLEAR) & (down.clear > CLEAR)
    if clear.sum() < LEAST:
        return None
    seen, true = across.places[clear], numpy.empty(int(clear.sum()), numpy.complex128)
    true.real, true.imag = SQUARE_MM * across.counts[clear], SQUARE_MM * down.counts[clear]
    warp, agree = cv().findHomography(_pairs(seen), _pairs(true), cv().RANSAC, OFF * SQUARE_MM)
    good = agree.ravel() > 0
    if warp is None or good.sum() < max(LEAST, AGREEING * len(good)):
        return None

    def fitted(lens: float) -> tuple[float, Bend]:
        bend = Bend.about(grey.shape, lens)
        bend.view, _ = cv().findHomography(_pairs(bend.straight(seen[good])), _pairs(true[good]))
        return float((abs(bend.flat(seen[good]) - true[good]) ** 2).mean()), bend

    return _viewed(min((fitted(k) for k in LENSES.tolist()), key=lambda one: one[0])[1], "squares")


def _by_lines(grey: Greys, down: Wave) -> SheetView | None:
    """By the horizon of equally spaced lines, through the lens that makes them straightest."""
    clear = down.clear > CLEAR
    seen, counts, bend = down.places[clear], down.counts[clear], Bend.about(grey.shape)
    unit = max(grey.shape)

    def horizon(lens: float) -> tuple[float, complex, Array]:
        bend.lens = lens, 0.0
        there = (bend.straight(seen) - bend.middle) / unit
        tilt, off = _horizon(there, counts)
        return float(numpy.minimum(abs(off), OFF).mean()), tilt, off

    _, tilt, off, bend.lens = min(((*horizon(k), (k, 0.0)) for k in LENSES.tolist()), key=lambda one: one[0])
    good, plain = abs(off) < OFF, level(bend.middle, FOCAL * unit, tilt * FOCAL)
    if plain is None or good.sum() < max(LEAST, AGREEING * len(good)):
        return None
    there = through(plain, bend.straight(seen[good]))
    base = numpy.stack([there.real, there.imag, numpy.ones(len(there))], axis=1)
    gx, gy, _ = numpy.linalg.lstsq(base, counts[good], rcond=None)[0].tolist()
    turn = complex(gx, gy) / 1j * LINES_MM  # lines to one of its pixels, downwards
    bend.view = similar(turn.conjugate()) @ plain
    return _viewed(bend, "lines")


def _horizon(places: Complexes, counts: Array) -> tuple[complex, Array]:
    """Lines are counted by a fraction whose denominator is nought at the horizon: its slopes (where it is 1 in the
    picture's middle), and how far off each count is."""
    x, y, one, weight = places.real, places.imag, numpy.ones(len(places)), numpy.ones(len(places))
    for _ in range(12):
        rows = numpy.stack([x, y, one, -counts * x, -counts * y], axis=1) * weight[:, None]
        a, b, c, d, e = numpy.linalg.lstsq(rows, counts * weight, rcond=None)[0].tolist()
        off: Array = (a * x + b * y + c) / (d * x + e * y + 1) - counts
        weight = 1 / (1 + (off / (0.5 * OFF)) ** 2)
    return complex(d, e), off


def _by_edges(grey: Greys) -> SheetView | None:
    """By a sheet of A4 all of which is seen."""
    found = edges_of(grey)
    if found is None:
        return None
    corners, lens = found
    ratio = shape_of(corners, grey.shape)[0]
    if abs(abs(math.log(ratio)) - math.log(A_SHAPE)) > NEAR_SHAPE:
        return None
    w, h = A4_MM if ratio > 1 else A4_MM[::-1]
    goal = numpy.array([(0, h), (w, h), (w, 0), (0, 0)], numpy.float32)
    bend = Bend.about(grey.shape, lens)
    bend.view = cv().getPerspectiveTransform(corners.astype(numpy.float32), goal)
    return _viewed(bend, "edges")


def similar(turn: complex, move: complex = 0j) -> Array:
    """Places times a complex number, then moved, as a homography."""
    return numpy.array([[turn.real, -turn.imag, move.real], [turn.imag, turn.real, move.imag], [0, 0, 1.0]])


def _pairs(z: Complexes) -> Array:
    return numpy.stack([z.real, z.imag], axis=1)


def by_tilt(grey: Greys, tilt: complex) -> SheetView | None:
    """The view of a camera tilted by so much (slopes to the right and down), its scale unknown."""
    bend = Bend.about(grey.shape)
    plain = level(bend.middle, FOCAL * max(grey.shape), tilt)
    if plain is None:
        return None
    bend.view = plain
    return _viewed(bend, "plan")


def _viewed(bend: Bend, by: str) -> SheetView | None:
    """The view, with how far the camera is tilted; None where no camera is held so."""
    focal = FOCAL * 2 * max(bend.middle.real, bend.middle.imag)
    a, b, c = bend.view[2].tolist()
    slope = abs(complex(a, b)) * focal / abs(a * bend.middle.real + b * bend.middle.imag + c)
    tilt = math.degrees(math.atan(slope))
    return SheetView(bend, by, tilt) if tilt < MOST_TILT_DEG else None
