"""Which lines of a sheet hang together: a drawing, and what stands apart from it."""

from collections import Counter
from collections.abc import Sequence

import numpy

from planes.check.vision.image.picture import cv
from planes.check.vision.strokes.line_fitting import Fitted
from planes.geometry.arrays import Complexes, Indices

JOINED_MM = 6.0  # lines no farther apart hang together
TORN_MM, CELLS = 12.0, 2  # a line may be so far torn; cells of a millimetre by which it is seen what hangs together
ALONE = 2  # lines that are no drawing of their own


def hanging(
    lines: Sequence[Fitted], pole: complex, room: Sequence[complex] = (), more: Sequence[complex] = ()
) -> list[int]:
    """Of which part each line is, and what else stands at some places (-1: of none): lines near each other hang
    together; 0 is what does with the pole, and what lies alone among a plan's marks."""
    cv2, among = cv(), [pole, *(pole + z for z in room)]
    ends = [(x.ends[0] - TORN_MM / 2 * x.along, x.ends[1] + TORN_MM / 2 * x.along) for x in lines]
    whole = numpy.array([*among, *more, *(z for pair in ends for z in pair)], complex)
    low = complex(whole.real.min(), whole.imag.min()) - JOINED_MM * (1 + 1j)

    def px(places: Sequence[complex] | Complexes) -> Indices:
        cells = (numpy.array(places, complex) - low) * CELLS
        return numpy.stack([cells.real, cells.imag], axis=1).round().astype(numpy.int32)

    page, inside = numpy.zeros((2, *(px(whole) + round(JOINED_MM * CELLS)).max(axis=0)[::-1]), numpy.uint8)
    cv2.polylines(page, [px([pole, pole]), *(px(x.ends) for x in lines)], True, 1, round(JOINED_MM * CELLS))
    cv2.polylines(page, [px(pair) for pair in ends], True, 1, 1)
    cv2.fillConvexPoly(inside, cv2.convexHull(px(among)), 1)
    _, labels = cv2.connectedComponents(page)
    cells = px([pole, *(x.at((x.low + x.high) / 2) for x in lines), *more]).tolist()
    own, *found = [int(labels[y, x]) for x, y in cells]
    count, order = Counter(found[: len(lines)]), {0: -1, own: 0}
    torn = {k for k, (x, y) in zip(found, cells[1:], strict=True) if k and inside[y, x] and count[k] <= ALONE}
    return [0 if k in torn else order.setdefault(k, len(order) - 1) for k in found]
