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
PLAIN, FIRM, FAINTEST = 0.4, 0.28, 0.06  # of a usual line: what is plainly drawn, and what is none wherever it is
ALONE, BLOT = 0.5, 0.7
LONG_MM = 7.5  # lines that tell how dark is usual
FEW, USUAL = 60, 65.0  # places that tell it at the least; a firm pencil's response
PEAK = 1.35  # how much darker a line's middle is than its response
FILLED_MM = 1.2  # of a line, over which it is made even
STROKE_MM, FOREMOST, HELD, MOST = 5.0, 0.9, 0.4, 1.3  # of what is plainly drawn at an angle: its length; of the response at any other
TAIL_MM, NEAR_MM = 7.0, 1.0
AMONG_MM, AMONG = 1.5, 0.5
BESIDE_MM = 0.5  # how far from a line's middle its ink is its own

Place = tuple[slice, slice]


class Inked(NamedTuple):
    """Darkness by that of the line it is of (1: in the middle of a line), and where lines are followed."""

    shares: Array
    followed: Booleans


def inked(dark: Array, scale: float) -> Inked:
    """What the darkness of a picture's pixels is by the lines they are of."""
    cv2 = cv()
    small = cv2.resize(dark, None, fx=PX_PER_MM / scale, fy=PX_PER_MM / scale, interpolation=cv2.INTER_AREA)
    angles = [_felt(small, k) for k in range(ANGLES)]
    most, darkest = (numpy.max([one[k] for one in angles], axis=0) for k in (1, 0))
    paper = ABOVE * _usual_on_paper(most)
    foremost = [felt > FOREMOST * _rival(angles, k) for k, (_, felt, _) in enumerate(angles)]
    nearby = cv2.dilate(most, numpy.ones((2 * round(AMONG_MM * PX_PER_MM) + 1,) * 2, numpy.uint8))
    own = [
        numpy.where(ahead & (alone > ALONE * along) & (alone > AMONG * nearby), alone, 0)
        for (along, _, alone), ahead in zip(angles, foremost, strict=True)
    ]
    usual = _usual(own, paper)
    least = max(min(paper, 0.5 * PLAIN * usual), FAINTEST * usual)
    strength, even = numpy.zeros_like(most), dark.copy()
    for k, (_, felt, _) in enumerate(angles):
        plain = _long(own[k] > PLAIN * usual, STROKE_MM)
        for place, of_it in _followed(felt, least, FIRM * usual, plain):
            part, mine = strength[place], of_it & foremost[k][place]
            near = cv2.dilate(mine.astype(numpy.uint8), _disk(NEAR_MM)) > 0
            numpy.maximum(part, numpy.where(of_it & near, felt[place], 0), out=part)
            _smooth_along(dark, even, place, mine, k, scale)
    lines, all_ink = _about(numpy.minimum(strength, MOST * usual)), _about(darkest)
    local = numpy.where(lines > 0, lines, numpy.maximum(usual, BLOT * all_ink)).astype(numpy.float32)
    size = dark.shape[::-1]
    local = cv2.resize(cv2.GaussianBlur(local, (0, 0), 0.7), size, interpolation=cv2.INTER_LINEAR)
    shares = even / (PEAK * local)
    followed = cv2.resize(strength, size, interpolation=cv2.INTER_NEAREST) > 0
    return Inked(shares, followed & (shares > HELD))


def _rival(angles: Sequence[tuple[Array, ...]], k: int) -> Array:
    """The most that lines at other angles are felt; a line between two angles is felt at both."""
    rival: Array = numpy.max([angles[(k + turn) % ANGLES][1] for turn in range(2, ANGLES - 1)], axis=0)
    return rival


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
    most: Array = cv().dilate(strength, _disk(BESIDE_MM))
    return most


def _disk(reach_mm: float) -> Array:
    """The places within reach."""
    side = 2 * round(reach_mm * PX_PER_MM) + 1
    disk: Array = cv().getStructuringElement(cv().MORPH_ELLIPSE, (side, side))
    return disk


def _followed(felt: Array, least: float, firm: float, plain: Booleans) -> Iterator[tuple[Place, Booleans]]:
    """Lines at an angle as far as they hang together with strokes plainly drawn at it: the box of each, its places.

    What is faint ends a stroke soon or leads from one to another; else it was rubbed out.
    """
    cv2 = cv()
    _, labels, stats, _ = cv2.connectedComponentsWithStats((felt > least).astype(numpy.uint8), connectivity=8)
    for k in numpy.unique(labels[plain]).tolist():
        x, y, w, h, _ = stats[k].tolist()
        place = slice(y, y + h), slice(x, x + w)
        whole = labels[place] == k
        faint = whole & (felt[place] <= firm)
        _, strokes = cv2.connectedComponents((whole & ~faint).astype(numpy.uint8), connectivity=8)
        drawn = numpy.unique(strokes[plain[place] & whole])
        _, parts, sizes, _ = cv2.connectedComponentsWithStats(faint.astype(numpy.uint8), connectivity=8)
        for n, (left, top, wide, high, _) in enumerate(sizes.tolist()):
            if n and max(wide, high) > TAIL_MM * PX_PER_MM:
                box = slice(max(top - 1, 0), top + high + 1), slice(max(left - 1, 0), left + wide + 1)
                about = cv2.dilate((parts[box] == n).astype(numpy.uint8), numpy.ones((3, 3), numpy.uint8)) > 0
                if numpy.isin(numpy.unique(strokes[box][about]), drawn).sum() < 2:
                    whole[box] &= parts[box] != n
        yield place, whole


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
