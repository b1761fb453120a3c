"""Where the vectors of a motion plan have their arrowheads on a drawing of lines."""

from planes.check.grading.paper import ReadPaper
from planes.check.grading.prepared_plan import PreparedPlan
from planes.check.grading.sign_faults import Head, Vector
from planes.check.reading.strokes import ReadDrawing
from planes.words.names import kind_of

JOINED_MM = 0.7  # a vector ends no farther from its mark
LEAST_MM = 8.0  # a shorter vector may have no head


def heads_between(sketch: ReadDrawing, paper: ReadPaper, bench: PreparedPlan) -> dict[Vector, Head]:
    """By vector the end its head is at, of those that are drawn as one line from mark to mark."""
    if kind_of(bench.asked.plan) in ("position", "force") or not sketch.ways:
        return {}
    names = {n: s.place for s in paper.spots if (n := bench.names.find(s.name))}
    found: dict[Vector, Head] = {}
    for start, end in bench.vectors:
        if {start, end} <= names.keys() and abs(names[end] - names[start]) > LEAST_MM:
            heads = _heads(sketch, names[start], names[end])
            if heads:
                found[start, end] = "end" if 1 in heads else "start" if -1 in heads else "none"
    return found


def _heads(sketch: ReadDrawing, a: complex, b: complex) -> set[int]:
    """Which ends of the lines from one place to another have heads: +1 at the second, -1 at the first, 0 none."""
    found = set[int]()
    for k, (c, d) in enumerate(sketch.strokes):
        for sign, (one, two) in ((1, (c, d)), (-1, (d, c))):
            if max(abs(one - a), abs(two - b)) < JOINED_MM:
                found.add(sign * sketch.way(k))
    return found
