"""Signs of a scheme on a picture: the small circles of hinges and the dots of other points, by their middles."""

from collections.abc import Iterator

import numpy

from planes.check.vision.image.picture import cv
from planes.check.vision.strokes.ink import EDGE, Ink
from planes.geometry.arrays import Array, Greys

PX_PER_MM = 4.0
RADII_MM = (0.8, 0.95, 1.1, 1.25, 1.4, 1.6, 1.8, 2.1, 2.4)  # of a hinge's circle
RIM_MM = 0.2  # half the width of its line
CLEAR_MM = 0.75  # what is looked at around it
ROUND, HOLLOW = 0.62, 0.38  # the share of the rim that is ink, and how much more than within
ALONE = 0.5  # the most ink around it
DOT_MM, FULL, AROUND_MM = 0.5, 0.96, (1.1, 1.5)
HOLE = 0.45  # of the darkest ink near it, what is no ink
APART_MM = 1.6  # signs nearer than this are one
CIRCLE_SIGMA, DOT_SIGMA = 0.15, 0.2


def signs(ink: Ink) -> list[tuple[complex, float]]:
    """Middles of circles and dots in mm, each with its σ, the clearest first."""
    found = [*_circles(ink), *_dots(ink)]
    kept: list[tuple[float, complex, float]] = []
    for one in sorted(found, key=lambda f: -f[0]):
        if all(abs(one[1] - k[1]) > APART_MM for k in kept):
            kept.append(one)
    return [(z, sigma) for _, z, sigma in kept]


def _circles(ink: Ink) -> Iterator[tuple[float, complex, float]]:
    mask, k = _smaller(ink, ink.even)
    for radius in RADII_MM:
        rim = _mean(mask, k * (radius - RIM_MM), k * (radius + RIM_MM))
        within = _mean(mask, 0.0, k * max(radius - RIM_MM - 0.2, 0.3))
        around = _mean(mask, k * (radius + RIM_MM + 0.2), k * (radius + CLEAR_MM))
        score = numpy.where((rim > ROUND) & (around < ALONE), rim - within, 0.0)
        yield from _peaks(ink, score, HOLLOW, k, CIRCLE_SIGMA)


def _dots(ink: Ink) -> Iterator[tuple[float, complex, float]]:
    mask, k = _smaller(ink, ink.whole)
    full = _mean(mask, 0.0, k * DOT_MM)
    around = _mean(mask, k * AROUND_MM[0], k * AROUND_MM[1])
    score = numpy.where((full > FULL) & (around < ALONE), _mean(mask, 0.0, k * (DOT_MM + 0.2)) - 0.5 * around, 0.0)
    yield from _peaks(ink, score, 0.3, k, DOT_SIGMA)


def _smaller(ink: Ink, even: Greys) -> tuple[Array, float]:
    """The share of ink in the pixels of a smaller picture, and how many of these there are to a mm."""
    cv2, dark = cv(), ink.dark
    darkest = cv2.dilate(dark, numpy.ones((round(2 * DOT_MM * ink.flat.scale) | 1,) * 2, numpy.uint8))
    mask = ((even < EDGE) & (dark > HOLE * darkest)).astype(numpy.float32)  # a faint line's ink fills what is beside it
    factor = min(1.0, PX_PER_MM / ink.flat.scale)
    return cv2.resize(mask, None, fx=factor, fy=factor, interpolation=cv2.INTER_AREA), ink.flat.scale * factor


def _mean(mask: Array, inner: float, outer: float) -> Array:
    """The share of ink between two circles about every pixel."""
    reach = int(outer + 1.5)
    y, x = numpy.mgrid[-reach : reach + 1, -reach : reach + 1]
    r = numpy.hypot(x, y)
    kernel = numpy.clip(outer + 0.5 - r, 0, 1) - (numpy.clip(inner + 0.5 - r, 0, 1) if inner > 0 else 0)
    mean: Array = cv().filter2D(mask, -1, (kernel / kernel.sum()).astype(numpy.float32))
    return mean


def _peaks(ink: Ink, score: Array, least: float, k: float, sigma: float) -> Iterator[tuple[float, complex, float]]:
    """The highest places, each where the score about it has its middle."""
    high = cv().dilate(score, numpy.ones((5, 5), numpy.uint8))
    for y, x in zip(*numpy.nonzero((score >= high) & (score > least)), strict=True):
        top, left = max(y - 1, 0), max(x - 1, 0)
        part = score[top : y + 2, left : x + 2]
        weight = numpy.clip(part - 0.7 * score[y, x], 0, None)
        rows, columns = numpy.mgrid[top : top + part.shape[0], left : left + part.shape[1]]
        middle_x, middle_y = (float((weight * v).sum() / weight.sum()) + 0.5 for v in (columns, rows))
        scale = ink.flat.scale / k
        yield float(score[y, x]), ink.flat.mm(middle_x * scale, middle_y * scale), sigma
