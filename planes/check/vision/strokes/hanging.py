"""Which lines of a sheet hang together: a drawing, and what stands apart from it."""

from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import combinations, product

import numpy

from planes.check.vision.image.picture import cv
from planes.check.vision.strokes.line_fitting import Fitted
from planes.check.vision.strokes.meeting import crossing, on
from planes.geometry.arrays import Complexes, Indices

JOINED_MM = 6.0  # lines no farther apart hang together
TORN_MM, ASIDE_MM = 12.0, 1.2  # a line may be so far torn, and go on so far aside
CELLS = 2  # of a millimetre, by which it is seen what hangs together
ALONE = 2  # lines that are no drawing of their own
SQUARE, CELL_LINES = 0.04, 3  # the cosine of what is nearly a right angle; lines of a table that each of them meets


def hanging(
    lines: Sequence[Fitted], pole: complex, room: Sequence[complex] = (), more: Sequence[complex] = ()
) -> list[int]:
    """Of which part each line is, and what else stands at some places (-1: of none): lines near each other hang
    together, but for a table's; 0 is what does with the pole, and what lies alone among a plan's marks."""
    cv2, among, ruled = cv(), [pole, *(pole + z for z in room)], tabled(lines)
    drawn = [x for k, x in enumerate(lines) if k not in ruled]
    whole = numpy.array([*among, *more, *(z for x in lines for z in x.ends)], complex)
    low = complex(whole.real.min(), whole.imag.min()) - JOINED_MM * (1 + 1j)

    def px(places: Sequence[complex] | Complexes) -> Indices:
        cells = (numpy.array(places, complex) - low) * CELLS
        return numpy.stack([cells.real, cells.imag], axis=1).round().astype(numpy.int32)

    page, inside = numpy.zeros((2, *(px(whole) + round(JOINED_MM * CELLS)).max(axis=0)[::-1]), numpy.uint8)
    cv2.polylines(page, [px([pole, pole]), *(px(x.ends) for x in drawn)], True, 1, round(JOINED_MM * CELLS))
    cv2.polylines(page, [px(gap) for pair in combinations(drawn, 2) for gap in _torn(*pair)], True, 1, 1)
    cv2.fillConvexPoly(inside, cv2.convexHull(px(among)), 1)
    _, labels = cv2.connectedComponents(page)
    cells = px([pole, *(x.at((x.low + x.high) / 2) for x in lines), *more]).tolist()
    own, *found = [0 if k - 1 in ruled else int(labels[y, x]) for k, (x, y) in enumerate(cells)]
    count, order = Counter(found[: len(lines)]), {0: -1, own: 0}
    torn = {k for k, (x, y) in zip(found, cells[1:], strict=True) if k and inside[y, x] and count[k] <= ALONE}
    return [0 if k in torn else order.setdefault(k, len(order) - 1) for k in found]


def tabled(lines: Sequence[Fitted]) -> set[int]:
    """Which lines are a table's: each meets three of its others, at the least, at right angles."""
    met = {k: set[int]() for k in range(len(lines))}
    for (i, one), (k, two) in combinations(enumerate(lines), 2):
        z = crossing(one, two) if abs((one.along * two.along.conjugate()).real) < SQUARE else None
        if z is not None and all(on(x, z, ASIDE_MM, ASIDE_MM) for x in (one, two)):
            met[i].add(k)
            met[k].add(i)
    found = set(met)
    while loose := {k for k in found if len(met[k] & found) < CELL_LINES}:
        found -= loose
    return found


def _torn(one: Fitted, two: Fitted) -> Iterator[tuple[complex, complex]]:
    """The gaps between ends of two lines that go on with each other."""
    for z, w in product(one.ends, two.ends):
        if abs(w - z) < TORN_MM and on(one, w, ASIDE_MM, TORN_MM) and on(two, z, ASIDE_MM, TORN_MM):
            yield z, w
