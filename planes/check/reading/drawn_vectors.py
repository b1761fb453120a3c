"""How the vectors of a motion plan are drawn in a file of lines: from mark to mark, past it, with which head, or not.

A mark is read where lines meet, and a vector may be wrong though others meet at its end rightly.
"""

import math

from planes.check.grading.paper import ReadPaper
from planes.check.grading.prepared_plan import PreparedPlan
from planes.check.grading.sign_faults import DrawnVector, Vector
from planes.check.reading.construction_lines import covered
from planes.check.reading.strokes import ReadDrawing, Stroke, reach_of
from planes.drafting.skill import SIGMAS
from planes.words.names import kind_of

ALONG = 0.7  # the share of a vector without a head that must be drawn
HALF = 0.51  # of its length: what is farther off is no attempt at a vector
LEAST_MM = 8.0  # a shorter vector may have no head, or be all head


def vectors_drawn(sketch: ReadDrawing, paper: ReadPaper, bench: PreparedPlan) -> dict[Vector, DrawnVector]:
    """Every longer vector whose two marks are read; where none has a head, any line along it will do."""
    heads = [k for k, way in enumerate(sketch.ways) if way]
    if kind_of(bench.asked.plan) in ("position", "force"):
        return {}
    marks = {n: s.place for s in paper.spots if (n := bench.names.find(s.name))}
    ends = {v: (marks[v[0]], marks[v[1]]) for v in bench.vectors if {*v} <= marks.keys()}
    ends = {v: (a, b) for v, (a, b) in ends.items() if abs(b - a) > LEAST_MM}
    if not heads:
        drawn = {v: covered(sketch.strokes, a, b) >= ALONG for v, (a, b) in ends.items()}
        return {v: DrawnVector("none" if there else "missing") for v, there in drawn.items()}
    near = SIGMAS * math.sqrt(2) * bench.asked.skill.point_mm + reach_of(sketch.strokes, heads)
    arrows = [sketch.strokes[k] if sketch.ways[k] > 0 else sketch.strokes[k][::-1] for k in heads]
    at_marks = {arrow: [any(abs(z - w) < near for w in marks.values()) for z in arrow] for arrow in arrows}
    tied = [arrow for arrow in arrows if all(at_marks[arrow])]
    found = {v: one for v, way in ends.items() if (one := _from_end_to_end(sketch, tied, way, near))}
    for arrow in (one for one in arrows if one not in tied):
        off = {v: max(abs(arrow[0] - a), abs(arrow[1] - b)) for v, (a, b) in ends.items()}
        off = off if any(at_marks[arrow]) else {v: mm for v, mm in off.items() if v not in found}
        nearest = min(off, key=lambda v: off[v], default=None)
        others = [z for one in arrows if one != arrow for z in one]
        loose = (z for z, there in zip(arrow, at_marks[arrow], strict=True) if not there)
        alone = all(abs(z - w) > near for z in loose for w in others)  # where others end too, a mark was misread
        if nearest and off[nearest] <= HALF * abs(ends[nearest][1] - ends[nearest][0]):
            found[nearest] = DrawnVector("astray", off[nearest]) if alone else DrawnVector("missing")
    return {v: found.get(v, DrawnVector("missing")) for v in ends}


def _from_end_to_end(sketch: ReadDrawing, tied: list[Stroke], way: Stroke, near: float) -> DrawnVector | None:
    """How a vector is drawn that reaches from its one end to the other, by one line or by several arrows that are
    ``tied`` to marks and of which the last ends at its end; None if nothing does."""
    a, b = way
    lines = {
        sign * sketch.way(k)
        for k, (c, d) in enumerate(sketch.strokes)
        for sign, (one, two) in ((1, (c, d)), (-1, (d, c)))
        if max(abs(one - a), abs(two - b)) < near
    }
    last = any(abs(d - b) < near and covered([(a, b)], c, d) * abs(d - c) > abs(d - c) - near for c, d in tied)
    if lines:
        return DrawnVector("end" if 1 in lines else "start" if -1 in lines else "none")
    return DrawnVector("end") if last and covered(tied, a, b) * abs(b - a) > abs(b - a) - near else None
