"""Hatching told from the lines of a plan: strokes side by side, equally far apart, that join nothing to anything."""

import cmath
import math
from collections import defaultdict
from collections.abc import Iterator, Sequence

from planes.check.reading.strokes import ReadDrawing, Stroke

FEWEST = 4  # rows of strokes that make hatching
WIDEST_MM, EVEN_MM = 6.0, 0.15  # how far apart the rows may be, and how much less or more than the rest
PARALLEL_DEG = 0.5
ROW_MM = 0.1  # strokes no farther off are pieces of one row, cut around a letter
FREE_MM = 0.3  # an end is free where no other line ends so near


def without_hatching(sketch: ReadDrawing) -> ReadDrawing:
    """The drawing without its hatching: it has no heads, and nothing of a plan begins or ends where it does."""
    ends: dict[tuple[int, int], list[complex]] = defaultdict(list)
    for z in (z for stroke in sketch.strokes for z in stroke):
        ends[_cell(z)].append(z)
    loose = [k for k, stroke in enumerate(sketch.strokes) if not sketch.way(k) and all(_free(z, ends) for z in stroke)]
    gone: set[int] = set()
    for alike in _parallel(sketch.strokes, loose):
        gone.update(_even_rows(sketch.strokes, alike))
    return sketch.only(k for k in range(len(sketch.strokes)) if k not in gone) if gone else sketch


def _cell(z: complex) -> tuple[int, int]:
    return math.floor(z.real / FREE_MM), math.floor(z.imag / FREE_MM)


def _free(z: complex, ends: dict[tuple[int, int], list[complex]]) -> bool:
    """Whether no end but its own is where a stroke ends."""
    x, y = _cell(z)
    around = (w for i in (x - 1, x, x + 1) for j in (y - 1, y, y + 1) for w in ends.get((i, j), ()))
    return sum(abs(z - w) < FREE_MM for w in around) < 2


def _parallel(strokes: Sequence[Stroke], held: Sequence[int]) -> Iterator[list[int]]:
    """Strokes of one direction each."""
    angles = {k: math.degrees(cmath.phase(strokes[k][1] - strokes[k][0])) % 180 for k in held}
    group: list[int] = []
    for k in sorted(held, key=lambda k: angles[k]):
        if group and angles[k] - angles[group[-1]] > PARALLEL_DEG:
            yield group
            group = []
        group.append(k)
    yield group


def _even_rows(strokes: Sequence[Stroke], held: Sequence[int]) -> Iterator[int]:
    """Those of parallel strokes that lie in enough rows equally far apart."""
    if len(held) < FEWEST:
        return
    a, b = strokes[held[0]]
    across = ((b - a) / abs(b - a)).conjugate()
    rows: list[tuple[float, list[int]]] = []
    for off, k in sorted((((strokes[k][0] + strokes[k][1]) / 2 * across).imag, k) for k in held):
        if rows and off - rows[-1][0] < ROW_MM:
            rows[-1][1].append(k)
        else:
            rows.append((off, [k]))
    start = 0
    for i in range(1, len(rows) + 1):
        gap = rows[start + 1][0] - rows[start][0] if start + 1 < len(rows) else 0.0
        if i < len(rows) and gap < WIDEST_MM and abs(rows[i][0] - rows[i - 1][0] - gap) < EVEN_MM:
            continue
        if i - start >= FEWEST:
            yield from (k for _, row in rows[start:i] for k in row)
        start = i - 1 if i - start > 1 else i
