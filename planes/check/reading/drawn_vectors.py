"""How a vector drawing shows the vectors of a motion plan: from mark to mark, past it, with which head, or not.

A mark is read where lines meet, and a vector may be wrong though others meet correctly at its end.
"""

import math
from collections.abc import Sequence

from planes.check.grading.paper import ReadPaper
from planes.check.grading.prepared_plan import PreparedPlan
from planes.check.grading.sign_faults import DrawnVector, Vector
from planes.check.reading.construction_lines import covered_share
from planes.check.reading.strokes import ReadDrawing, coincident_ends_distance_mm
from planes.check.reading.written import Stroke, Strokes, vector_of
from planes.drafting.skill import TOLERANCE_SIGMAS
from planes.geometry.plane import distance_to_nearest

LEAST_DRAWN_SHARE = 0.7  # minimum drawn share of a vector without a head
MOST_ASTRAY_SHARE = 0.51  # of its length: anything farther off is no attempt at a vector
SHORTEST_VECTOR_WITH_HEAD_MM = 8.0  # a shorter vector may have no head, or consist of its head only
Line = tuple[Stroke, bool]
"""A stroke and whether it has a head, which then is at its end."""


def drawn_motion_vectors(sketch: ReadDrawing, paper: ReadPaper, bench: PreparedPlan) -> dict[Vector, DrawnVector]:
    """Every longer vector with both marks read; where none has a head, any line along it counts."""
    if bench.kind in ("position", "force"):
        return {}
    marks = bench.marks_by_label({s.name: s.place for s in paper.spots})
    pairs = {v: (marks[v[0]], marks[v[1]]) for v in bench.vector_names if {*v} <= marks.keys()}
    vectors = {v: (a, b) for v, (a, b) in pairs.items() if abs(b - a) > SHORTEST_VECTOR_WITH_HEAD_MM}
    heads = [k for k, way in enumerate(sketch.ways) if way]
    if not heads:
        drawn = {v: covered_share(sketch.strokes, a, b) >= LEAST_DRAWN_SHARE for v, (a, b) in vectors.items()}
        return {v: DrawnVector("none" if there else "missing") for v, there in drawn.items()}
    near = TOLERANCE_SIGMAS * math.sqrt(2) * bench.asked.skill.point_mm + coincident_ends_distance_mm(
        sketch.strokes, heads
    )
    lines = [(s[::-1] if way < 0 else s, bool(way)) for s, way in zip(sketch.strokes, sketch.ways, strict=True)]
    arrows = [line for line, headed in lines if headed]

    def at_mark(z: complex) -> bool:
        return distance_to_nearest(z, marks.values()) < near

    joined = [(line, headed) for line, headed in lines if all(map(at_mark, line))]
    drawn_as = {v: one for v, way in vectors.items() if (one := _vector_drawn_end_to_end(joined, way, near))}
    for arrow in arrows:
        free = [z for z in arrow if not at_mark(z)]
        aims = [v for v in vectors if len(free) == 1 or v not in drawn_as]
        aim = min(aims, key=lambda v: _largest_end_distance(arrow, vectors[v]), default=None) if free else None
        if aim and (off := _largest_end_distance(arrow, vectors[aim])) <= MOST_ASTRAY_SHARE * abs(
            vector_of(vectors[aim])
        ):
            others = [w for other in arrows if other != arrow for w in other]
            misread = any(distance_to_nearest(z, others) <= near for z in free)  # a mark at which others end, too
            drawn_as[aim] = DrawnVector("missing") if misread else DrawnVector("astray", off)
    return {v: drawn_as.get(v, DrawnVector("missing")) for v in vectors}


def _vector_drawn_end_to_end(joined: Sequence[Line], way: Stroke, near: float) -> DrawnVector | None:
    """How a vector is drawn from end to end: by a line among those ``joined`` to marks, or by several.

    The last of several has its head at its end; None if nothing reaches from end to end.
    """
    tied = [line for line, headed in joined if headed]
    if any(_largest_end_distance(line, way) < near for line in tied):
        return DrawnVector("end")
    if any(_largest_end_distance(line, way[::-1]) < near for line in tied):
        return DrawnVector("start")
    if any(min(_largest_end_distance(line, way), _largest_end_distance(line, way[::-1])) < near for line, _ in joined):
        return DrawnVector("none")
    last = any(abs(line[1] - way[1]) < near and _is_covered_by(line, [way], near) for line in tied)
    if last and _is_covered_by(way, tied, near):
        return DrawnVector("end")
    return None


def _largest_end_distance(line: Stroke, way: Stroke) -> float:
    """The distance of a line's ends from their right positions."""
    return max(abs(z - w) for z, w in zip(line, way, strict=True))


def _is_covered_by(line: Stroke, others: Strokes, near: float) -> bool:
    """Whether others run along all of a line."""
    length = abs(vector_of(line))
    return covered_share(others, *line) * length > length - near
