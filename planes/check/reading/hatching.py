"""Distinguishes hatching from the lines of a plan: parallel, evenly spaced strokes that connect nothing."""

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence, Set
from itertools import pairwise

import numpy
from shapely import STRtree, points

from planes.check.reading.strokes import ReadDrawing
from planes.check.reading.written import Strokes, vector_of
from planes.geometry.plane import direction_between

LEAST_HATCH_ROWS = 4  # minimum number of rows in hatching
# maximum distance between rows, and tolerance of their spacing
MOST_ROW_SPACING_MM = 6.0
ROW_SPACING_TOLERANCE_MM = 0.15
PARALLEL_TOLERANCE_DEG = 0.5
SAME_ROW_DISTANCE_MM = 0.1  # strokes closer than this are pieces of one row, cut around a letter
FREE_END_DISTANCE_MM = 0.3  # an end is free if no other line ends this close
MOST_ENDS_AT_ONCE = 250  # ends in one search for neighbours: all of a scribble may be neighbours


def without_hatching(sketch: ReadDrawing) -> ReadDrawing:
    """The drawing without its hatching, which has no heads and shares no ends with the plan.

    One end of a few of its strokes may be close to something by chance.
    """
    free = _free_end_counts(sketch.strokes)
    gone = set[int]()
    bare = {k: ends for k, ends in enumerate(free) if ends and not sketch.end_with_head(k)}
    loose = {k for k, ends in bare.items() if ends == 2}
    for held in (loose, {*bare}):
        for alike in _parallel_groups(sketch.strokes, sorted(held)):
            gone.update(_strokes_in_even_rows(sketch.strokes, alike, loose))
    if gone:
        return sketch.with_some_strokes(k for k in range(len(sketch.strokes)) if k not in gone)
    return sketch


def _free_end_counts(strokes: Strokes) -> list[int]:
    """The number of ends of each stroke without other ends close by, except those of other pieces of its row."""
    places = numpy.array(strokes, complex).ravel()
    ways = numpy.repeat([cmath.rect(1.0, cmath.phase(vector_of(s))) for s in strokes], 2)
    ends = points(places.real, places.imag)
    tree = STRtree(ends)
    joined = numpy.zeros(len(ends), bool)
    for part in numpy.array_split(numpy.arange(len(ends)), 1 + len(ends) // MOST_ENDS_AT_ONCE):
        i, other = tree.query(ends[part], predicate="dwithin", distance=FREE_END_DISTANCE_MM)
        own = part[i]
        turned = abs((ways[own] * ways[other].conj()).imag)
        aside = abs(((places[other] - places[own]) * ways[own].conj()).imag)
        pieces = (turned < math.radians(PARALLEL_TOLERANCE_DEG)) & (aside < SAME_ROW_DISTANCE_MM)
        joined[own[(own != other) & ~pieces]] = True
    free: list[int] = (~joined.reshape(-1, 2)).sum(axis=1).tolist()
    return free


def _parallel_groups(strokes: Strokes, held: Sequence[int]) -> list[list[int]]:
    """Groups of parallel strokes."""
    angles = {k: math.degrees(cmath.phase(vector_of(strokes[k]))) % 180 for k in held}
    groups = _together(angles, PARALLEL_TOLERANCE_DEG)
    if len(groups) > 1 and angles[groups[0][0]] + 180 - angles[groups[-1][-1]] <= PARALLEL_TOLERANCE_DEG:
        groups[0] += groups.pop()  # horizontal strokes, some of them slightly below 180°
    return groups


def _together(values: Mapping[int, float], gap: float) -> list[list[int]]:
    """Keys in the order of their values, apart where these leave a gap."""
    order = sorted(values, key=lambda k: values[k])
    cuts = [i for i, (j, k) in enumerate(pairwise(order), 1) if values[k] - values[j] > gap]
    return [order[i:j] for i, j in pairwise([0, *cuts, len(order)])]


def _strokes_in_even_rows(strokes: Strokes, held: Sequence[int], loose: Set[int]) -> Iterator[int]:
    """Those of parallel strokes that lie in evenly spaced rows, enough of which begin and end freely."""
    if len(held) < LEAST_HATCH_ROWS:
        return
    across = direction_between(*strokes[held[0]]).conjugate()
    off = {k: (sum(strokes[k]) / 2 * across).imag for k in held}
    rows = _together(off, SAME_ROW_DISTANCE_MM)
    gaps = [off[below[0]] - off[row[0]] for row, below in pairwise(rows)]
    start = 0
    for i in range(1, len(rows) + 1):
        if (
            i < len(rows)
            and gaps[start] < MOST_ROW_SPACING_MM
            and abs(gaps[i - 1] - gaps[start]) < ROW_SPACING_TOLERANCE_MM
        ):
            continue
        if sum(not loose.isdisjoint(row) for row in rows[start:i]) >= LEAST_HATCH_ROWS:
            own = [k for row in rows[start:i] for k in row]
            along = {k: sorted((z * across).real for z in strokes[k]) for k in own}
            beside = [along[k] for k in own if k in loose]
            yield from (k for k in own if k in loose or any(_is_half_beside(along[k], other) for other in beside))
        start = i - 1 if i - start > 1 else i


def _is_half_beside(own: Sequence[float], other: Sequence[float]) -> bool:
    """Whether half of a stroke lies beside another one, by their ends along their direction."""
    return min(own[1], other[1]) - max(own[0], other[0]) > (own[1] - own[0]) / 2
