"""How dark ink is by the line it is of: a hard pencil's, a fading stroke's and a pen's lines come out alike.

How strongly a line runs through a place is told by the ink along it against the paper to either side, at every angle.
What covers much of the sheet so is its paper, with a grid. Lines that are plainly drawn are followed, at their angle,
as far as they can be told from paper; all other ink is held against the lines that are usual on the sheet.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import cache
from typing import NamedTuple

import numpy

from planes.check.vision.picture import cv
from planes.geometry.arrays import Array, Booleans

PX_PER_MM = 3.0  # of the smaller picture on which lines are felt
ANGLES = 12
ALONG_MM, ACROSS_MM, ASIDE_MM = 3.0, 0.2, 0.85  # how much of a line is felt: its length, σ of its width, paper beside it
TILE_MM, COVERED, ABOVE = 20.0, 0.93, 1.6  # of the paper's own response: which share is less in most parts of a sheet
PLAIN, FAINTEST = 0.4, 0.06  # of a usual line: what is plainly drawn, and what is none wherever it is
ALONE, BLOT = 0.5, 0.7
LONG_MM = 7.5  # lines that tell how dark is usual
FEW, USUAL = 60, 65.0  # places that tell it at the least; a firm pencil's response
PEAK = 1.35  # how much darker a line's middle is than its response
FILLED_MM = 1.2  # of a line, over which it is made even
STROKE_MM, FOREMOST = 6.0, 0.85  # of what is plainly drawn at an angle: its length; of the response at any other
BESIDE_MM = 0.5  # how far from a line's middle its ink is its own

Place = tuple[slice, slice]


def shares(dark: Array, scale: float) -> Array:
    """Darkness by that of the line it is of (1: in the middle of a line), from the darkness of a picture's pixels."""
    cv2 = cv()
    small = cv2.resize(dark, None, fx=PX_PER_MM / scale, fy=PX_PER_MM / scale, interpolation=cv2.INTER_AREA)
    angles = [_felt(small, k) for k in range(ANGLES)]
    most, dark_most = (numpy.max([one[k] for one in angles], axis=0) for k in (1, 0))
    paper = ABOVE * _usual_on_paper(most)
    own = [numpy.where((felt > FOREMOST * most) & (alone > ALONE * along), alone, 0) for along, felt, alone in angles]
    usual = _usual(own, paper)
    import os
    if os.environ.get("DBG"): print("paper", paper, "usual", usual)
    least = max(min(paper, 0.5 * PLAIN * usual), FAINTEST * usual)
    strength, even = numpy.zeros_like(most), dark.copy()
    for k, (_, felt, _) in enumerate(angles):
        foremost = felt > FOREMOST * most
        for place, of_it in _followed(felt > least, foremost, own[k] > PLAIN * usual):
            part = strength[place]
            numpy.maximum(part, numpy.where(of_it, felt[place], 0), out=part)
            _smooth_along(dark, even, place, of_it, k, scale)
    strength, other = (_about(one) for one in (strength, dark_most))
    strength = numpy.where(strength > 0, strength, numpy.maximum(usual, BLOT * other)).astype(numpy.float32)
    strength = cv2.resize(cv2.GaussianBlur(strength, (0, 0), 0.7), dark.shape[::-1], interpolation=cv2.INTER_LINEAR)
    found: Array = even / (PEAK * strength)
    return found


def _felt(small: Array, angle: int) -> tuple[Array, Array, Array]:
    """The ink along lines at an angle, less that of the paper to both sides of them, and less that of the darker side.

    At the foot of a row of letters one side is dark.
    """
    along = cv().filter2D(small, -1, _kernel(angle))
    across = ASIDE_MM * PX_PER_MM * numpy.exp(1j * math.pi * (angle / ANGLES + 0.5))
    shift = round(float(across.imag)), round(float(across.real))
    one, other = (numpy.roll(along, (sign * shift[0], sign * shift[1]), (0, 1)) for sign in (1, -1))
    return along, along - (one + other) / 2, along - numpy.maximum(one, other)


def _about(strength: Array) -> Array:
    """The most there is within half a line's reach."""
    reach = 2 * round(BESIDE_MM * PX_PER_MM) + 1
    most: Array = cv().dilate(strength, cv().getStructuringElement(cv().MORPH_ELLIPSE, (reach, reach)))
    return most


def _followed(felt: Booleans, foremost: Booleans, plain: Booleans) -> Iterator[tuple[Place, Booleans]]:
    """Lines at an angle as far as they hang together with a stroke plainly drawn at it: the box of each, its places."""
    _, labels, stats, _ = cv().connectedComponentsWithStats(felt.astype(numpy.uint8), connectivity=8)
    for k in numpy.unique(labels[_long(plain, STROKE_MM)]).tolist():
        x, y, w, h, _ = stats[k].tolist()
        place = slice(y, y + h), slice(x, x + w)
        yield place, (labels[place] == k) & foremost[place]


def _smooth_along(dark: Array, even: Array, place: Place, of_it: Booleans, angle: int, scale: float) -> None:
    """Fill the pits that a paper's grain leaves in a line."""
    cv2, (rows, columns) = cv(), place
    top, left = (int(side.start * scale / PX_PER_MM) for side in place)
    here = slice(top, int(rows.stop * scale / PX_PER_MM)), slice(left, int(columns.stop * scale / PX_PER_MM))
    part, reach = dark[here], max(int(FILLED_MM / 2 * scale + 0.5), 1)
    y, x = numpy.mgrid[-reach : reach + 1, -reach : reach + 1]
    local = (x + 1j * y) * numpy.exp(-1j * math.pi * angle / ANGLES)
    kernel = numpy.clip(1 - numpy.abs(local.imag), 0, 1) * (numpy.abs(local.real) <= reach)
    smooth = cv2.filter2D(part, -1, (kernel / kernel.sum()).astype(numpy.float32))
    inside = cv2.resize(of_it.astype(numpy.uint8), part.shape[::-1], interpolation=cv2.INTER_NEAREST) > 0
    even[here] = numpy.where(inside, numpy.maximum(even[here], smooth), even[here])


def _usual_on_paper(felt: Array) -> float:
    """The response of paper: what is more covers little of most parts of the sheet."""
    side = int(TILE_MM * PX_PER_MM)
    (h, w), parts = felt.shape, list[float]()
    for top in range(0, max(h - side // 2, 1), side):
        for left in range(0, max(w - side // 2, 1), side):
            parts.append(float(numpy.quantile(felt[top : top + side, left : left + side], COVERED)))
    return float(numpy.median(parts))


def _usual(own: Sequence[Array], paper: float) -> float:
    """The response of the long lines of a sheet."""
    strong = numpy.concatenate([one[_long(one > 2 * paper, LONG_MM)] for one in own])
    return float(numpy.median(strong)) if len(strong) > FEW else USUAL


def _long(places: Booleans, least_mm: float) -> Booleans:
    """The places that hang together over a length."""
    _, labels, stats, _ = cv().connectedComponentsWithStats(places.astype(numpy.uint8), connectivity=8)
    long = numpy.maximum(stats[:, 2], stats[:, 3]) >= least_mm * PX_PER_MM
    long[0] = False
    found: Booleans = long[labels]
    return found


@cache
def _kernel(angle: int) -> Array:
    """The mean of the ink along a line."""
    reach = math.ceil((ALONG_MM / 2 + ACROSS_MM) * PX_PER_MM)
    y, x = numpy.mgrid[-reach : reach + 1, -reach : reach + 1] / PX_PER_MM
    local = (x + 1j * y) * numpy.exp(-1j * math.pi * angle / ANGLES)
    ends = numpy.clip((ALONG_MM / 2 - numpy.abs(local.real)) * PX_PER_MM + 0.5, 0, 1)
    kernel = ends * numpy.exp(-(local.imag**2) / (2 * ACROSS_MM**2))
    mean: Array = (kernel / kernel.sum()).astype(numpy.float32)
    return mean
