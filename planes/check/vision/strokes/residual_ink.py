"""What ink is left that is on no line: pieces that may be short strokes, or letters, or another line's."""

from collections.abc import Iterator, Sequence

import numpy

from planes.check.vision.image.picture import cv
from planes.check.vision.strokes.ink import LETTER_MM, Ink
from planes.check.vision.strokes.line_fitting import Fitted
from planes.geometry.arrays import Complexes

RIM_MM = 0.35  # of an arrowhead beside its line
LEAST_MM, MOST_MM = 1.2, 12.0  # of what is left: less is nothing, more is letters that touch
THICK_MM = 0.2  # on the average
STRAIGHT_MM = 0.3  # how far a stroke's ink is from its middle line
LARGE_MM, CELL_MM = 2.5, 0.5
Edge = tuple[complex, complex]  # the ink is to the right


def left_over(ink: Ink, lines: Sequence[Fitted]) -> Iterator[Complexes]:
    """Separate pieces of ink on no line: the places of each, mm."""
    cv2, flat, mask = cv(), ink.flat, ink.mask
    for line in lines:
        s = numpy.linspace(line.low - 0.5, line.high + 0.5, 9)
        path = numpy.array([flat.px(line.at(float(x))) for x in s]).round().astype(numpy.int32)
        cv2.polylines(mask, [path], False, 0, max(1, round((line.width + 2 * RIM_MM) * flat.scale)))
    _, labels, stats, _ = cv2.connectedComponentsWithStats(mask, connectivity=8)
    least, most = LEAST_MM * flat.scale, MOST_MM * flat.scale
    for k, (x, y, w, h, area) in enumerate(stats.tolist()):
        if k and least < max(w, h) < most and area > THICK_MM * LEAST_MM * flat.scale**2:
            down, across = numpy.nonzero(labels[y : y + h, x : x + w] == k)
            yield numpy.asarray(flat.mm(x, y) + (across - 1j * down) / flat.scale, complex)


def straight_through(part: Complexes) -> tuple[Edge, float]:
    """The ends of the straight line that runs best through places, and how far they usually are off it."""
    middle = complex(part.mean())
    u = numpy.exp(0.5j * numpy.angle(((part - middle) ** 2).sum()))
    local = (part - middle) * u.conjugate()
    return (complex(middle + u * local.real.min()), complex(middle + u * local.real.max())), float(local.imag.std())


def patches(ink: Ink, lines: Sequence[Fitted]) -> list[complex]:
    """Places half a millimetre apart in larger pieces of ink that are on no line, and no letters."""
    found: list[complex] = []
    for part in left_over(ink, lines):
        size = max(numpy.ptp(part.real), numpy.ptp(part.imag))
        if size > LARGE_MM and (size > LETTER_MM or straight_through(part)[1] < STRAIGHT_MM):
            cells = numpy.unique(numpy.round(part.real / CELL_MM) + 1j * numpy.round(part.imag / CELL_MM))
            found += (cells * CELL_MM).tolist()
    return found
