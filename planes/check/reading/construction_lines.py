"""Distinguishes construction lines from the vectors on them, without arrowheads: they run on to where nothing ends."""

from collections.abc import Sequence

from shapely import buffer, dwithin, union_all

from planes.check.reading.strokes import (
    FARTHEST_JOINED_ENDS_MM,
    MOST_STROKES_FOR_CROSSINGS,
    SNAPPED_ENDS_MM,
    ReadDrawing,
    as_lines,
    strokes_with_heads,
)
from planes.check.reading.written import Stroke, Strokes, vector_of
from planes.geometry.plane import direction_between, distance_to_nearest, sine_between

ON_LINE_TOLERANCE_MM = 0.1  # a vector is drawn on its line
TOUCH_MM = 0.01  # a line ends on another
MOST_PARALLEL_ANGLE_RAD = 0.02  # maximum angle between parallel lines, radians
LEAST_MEETING_SHARE = 0.5  # share of ends that meet others, for lines drawn from end to end
MOST_STROKE_OFFSET_MM, ASLANT = 0.9, 0.06  # maximum offset and slope of a stroke along a segment
MOST_NAME_TO_END_MM = 6.0  # maximum distance of a word from the end it names
MISREAD_SHARE = 0.05  # share of a drawing's marks that are misread
MISREAD_SHARE_OF_MEETING = 0.0005  # the same for marks of such lines without heads
MISREAD_SHARE_OF_OVERRUNNING = 0.9  # the same for lines that overrun each other, or three and more on top of each other
MOST_OVERRUN_MM = 20.0  # maximum overrun of lines
LEAST_OVERRUNNING_ENDS = 2  # number of ends that prove it
StrokeEnds = Sequence[tuple[int, complex]]  # the number of each end's stroke, and its place


def misread_mark_share(sketch: ReadDrawing) -> float:
    """The share of misread marks in a vector drawing: hardly any with arrowheads.

    Without heads, and with lines that overrun or lie in rows, it is so high that a single mark proves nothing.
    """
    if any(sketch.ways):
        return 0.0
    ends = [(k, z) for k in vector_strokes(sketch) or range(len(sketch.strokes)) for z in sketch.strokes[k]]
    met = share_of_meeting_ends(sketch.strokes, ends) >= LEAST_MEETING_SHARE
    if len(ends) < MOST_STROKES_FOR_CROSSINGS and (
        _has_rows_of_strokes(sketch.strokes) or count_overrunning_ends(sketch.strokes, ends) >= LEAST_OVERRUNNING_ENDS
    ):
        return MISREAD_SHARE_OF_OVERRUNNING
    return MISREAD_SHARE_OF_MEETING if met else MISREAD_SHARE


def share_of_meeting_ends(strokes: Strokes, ends: StrokeEnds) -> float:
    """The share of the ends of strokes that meet others."""
    if len(ends) >= MOST_STROKES_FOR_CROSSINGS:
        return 0.0
    met = sum(_is_met_by_another(strokes, z, (k,), FARTHEST_JOINED_ENDS_MM) for k, z in ends)
    return met / max(len(ends), 1)


def count_overrunning_ends(strokes: Strokes, ends: StrokeEnds) -> int:
    """The number of ends slightly beyond a crossing with another stroke, or its end on theirs, that meet none."""
    return sum(_crossed(strokes, k, z) for k, z in ends if not _is_met_by_another(strokes, z, (k,)))


def _crossed(strokes: Strokes, k: int, z: complex) -> bool:
    """Whether others cross a stroke, or end on it, not far from one of its ends."""
    other = next(w for w in strokes[k] if w != z)
    u = direction_between(z, other)
    far = min(abs(other - z) - SNAPPED_ENDS_MM, MOST_OVERRUN_MM)
    rest = [s for i, s in enumerate(strokes) if i != k and not _is_parallel(s, strokes[k])]
    return bool(dwithin(as_lines(rest), as_lines([(z + SNAPPED_ENDS_MM * u, z + far * u)])[0], TOUCH_MM).any())


def _has_rows_of_strokes(strokes: Strokes) -> bool:
    """Whether three or more strokes lie on a longer one, so that the vectors among them are unknown."""
    few = len(strokes) < MOST_STROKES_FOR_CROSSINGS
    return few and any(
        sum(lies_on_longer_stroke(one, line) for one in strokes if one is not line) > 2 for line in strokes
    )


def vector_strokes(sketch: ReadDrawing, closed: bool = False) -> list[int]:
    """The strokes that are vectors: those with heads, otherwise those that are no construction line of another.

    None if there is no evidence. In a ``closed`` figure a vector begins and ends where others do.
    """
    strokes = sketch.strokes
    if with_heads := strokes_with_heads(sketch):
        return with_heads
    if len(strokes) > MOST_STROKES_FOR_CROSSINGS:
        return []
    named = [] if closed else _named_ends(sketch)
    lines = {k for k in range(len(strokes)) if _is_construction_line(strokes, k, closed, named)}
    return [k for k in range(len(strokes)) if k not in lines] if lines else []


def _named_ends(sketch: ReadDrawing) -> list[complex]:
    """Ends of strokes that are the only ones beside a word."""
    ends_named = []
    ends = [z for stroke in sketch.strokes for z in stroke]
    for word in sketch.words:
        near = [z for z in ends if word.distance(z) < MOST_NAME_TO_END_MM]
        if near and all(abs(z - near[0]) < SNAPPED_ENDS_MM for z in near):
            ends_named.append(near[0])
    return ends_named


def _is_construction_line(strokes: Strokes, k: int, closed: bool, named: Sequence[complex]) -> bool:
    """Whether a stroke extends a shorter one on it to an unnamed point where no other begins or ends.

    Other lines along it do not count; ``named`` are the named points.
    """
    for i, vector in enumerate(strokes):
        if i == k or not lies_on_longer_stroke(vector, strokes[k]):
            continue
        beyond = [z for z in strokes[k] if distance_to_nearest(z, vector) > SNAPPED_ENDS_MM]
        inner = [w for w in vector if distance_to_nearest(w, strokes[k]) > SNAPPED_ENDS_MM]
        ends = any(
            _is_end_of_other_direction(strokes, z, strokes[k]) or distance_to_nearest(z, named) < SNAPPED_ENDS_MM
            for z in beyond
        )
        if beyond and not ends:
            return not closed or all(_is_met_by_another(strokes, w, (i, k)) for w in inner)
    return False


def _is_end_of_other_direction(strokes: Strokes, z: complex, line: Stroke) -> bool:
    """Whether a stroke in another direction than a line begins or ends at a point."""
    return any(
        distance_to_nearest(z, stroke) < SNAPPED_ENDS_MM and not _is_parallel(stroke, line) for stroke in strokes
    )


def _is_parallel(one: Stroke, line: Stroke) -> bool:
    """Whether a stroke is parallel to a line, in either direction."""
    return sine_between(vector_of(one), vector_of(line)) < MOST_PARALLEL_ANGLE_RAD


def lies_on_longer_stroke(one: Stroke, line: Stroke) -> bool:
    """Whether a stroke lies on a longer one."""
    a, b = line
    local = [(z - a) / direction_between(a, b) for z in one]
    return abs(vector_of(one)) < abs(b - a) - SNAPPED_ENDS_MM and all(
        abs(z.imag) < ON_LINE_TOLERANCE_MM and -SNAPPED_ENDS_MM < z.real < abs(b - a) + SNAPPED_ENDS_MM for z in local
    )


def _is_met_by_another(strokes: Strokes, z: complex, but: Sequence[int], near: float = SNAPPED_ENDS_MM) -> bool:
    """Whether another stroke begins or ends at a point."""
    return any(distance_to_nearest(z, stroke) < near for i, stroke in enumerate(strokes) if i not in but)


def covered_share(strokes: Strokes, a: complex, b: complex) -> float:
    """The share of the segment from ``a`` to ``b`` with a stroke along it."""
    if abs(b - a) < 2 * MOST_STROKE_OFFSET_MM:
        return 1.0
    aside = ((b - a).conjugate() / abs(b - a) * (d - c) for c, d in strokes)
    beside = [
        s for s, way in zip(strokes, aside, strict=True) if abs(way.imag) < MOST_STROKE_OFFSET_MM + ASLANT * abs(way)
    ]
    line = as_lines([(a, b)])[0]
    bands = union_all(buffer(as_lines(beside), MOST_STROKE_OFFSET_MM, cap_style="flat"))
    return float(line.intersection(bands).length / line.length)
