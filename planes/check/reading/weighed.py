"""How well what was read of a drawing agrees with its plan; which of two readings is the better."""

from dataclasses import replace
from itertools import combinations, pairwise

from planes.check.grading.grading import Grading, grade
from planes.check.grading.paper import ReadPaper
from planes.check.grading.prepared_plan import PreparedPlan
from planes.check.grading.readable import readable
from planes.check.reading.chains import SURELY_MM, WIDE, ahead_of, back_and_forth, true_vectors
from planes.check.reading.construction_lines import apart
from planes.check.reading.parts import NEAR_WORD_MM
from planes.check.reading.strokes import ReadDrawing
from planes.words.errors import PlanesError
from planes.words.names import POLE

FARTHEST_MM = 2 * NEAR_WORD_MM  # where marks crowd their names stand farther off
OPEN, NAMED = 2.0, 0.5  # what it costs a force polygon not to close, and what a known mistake explains, in marks


def _graded(bench: PreparedPlan, paper: ReadPaper) -> Grading | None:
    """A paper's grading; none where it cannot be graded."""
    try:
        return grade(bench, paper)
    except PlanesError:
        return None


def is_right(bench: PreparedPlan, paper: ReadPaper) -> bool:
    """Whether a paper is right."""
    grading = _graded(bench, paper)
    return grading is not None and not grading.fault and readable(grading) is None


def told_apart(sketch: ReadDrawing, bench: PreparedPlan, paper: ReadPaper) -> ReadPaper:
    """Of two vectors there and back that the words do not tell apart, each by the name it has if all is right, then by
    the one that a mistake explains; which of the two may be so is told, unless they stand in the plan's order."""
    order = list(true_vectors(bench))
    names = bench.naming.names(order)
    words = [(names.find(w.text), w) for w in sketch.words]
    strokes = {k: (one.place, two.place) for k, (one, two) in enumerate(pairwise(paper.spots), 1) if two.name != POLE}

    def word(name: str, k: int) -> float:
        return min((w.beside(strokes[k]) for n, w in words if n == name), default=FARTHEST_MM)

    def ahead(k: int) -> float:
        return max((ahead_of(w, strokes[k]) for n, w in words if n == paper.spots[k].name), default=0.0)

    for i, j in combinations(strokes, 2):
        one, two = paper.spots[i].name, paper.spots[j].name
        doubt = abs(word(one, i) + word(two, j) - word(one, j) - word(two, i)) < SURELY_MM
        if not doubt or not back_and_forth(*strokes[i], *strokes[j], WIDE):
            continue
        spots = list(paper.spots)
        spots[i], spots[j] = replace(spots[i], name=two), replace(spots[j], name=one)
        other, right = replace(paper, spots=spots), is_right(bench, paper)
        in_order = {one, two} <= {*order} and order.index(two) < order.index(one)
        silent = not ahead(i) and not ahead(j)
        if not right and (silent or in_order) and is_right(bench, other):
            paper = replace(other, untold=[] if silent and in_order else [one, two])
        elif not right and not is_right(bench, other) and worth(bench, other) > worth(bench, paper):
            paper = other
    return paper


def vague(sketch: ReadDrawing, bench: PreparedPlan, paper: ReadPaper) -> bool:
    """Whether it is only guessed what is which of a wrong polygon: its vectors have no names, or nothing shows where
    they end, or, as none has an arrowhead, it may as well have been drawn the other way round."""
    if is_right(bench, paper):
        return False
    names = bench.naming.names(true_vectors(bench))
    has_names = any((names.find(w.text) or POLE) != POLE for w in sketch.words)
    return (
        not has_names or apart(sketch) or (not any(sketch.ways) and worth(bench, _turned(paper)) >= worth(bench, paper))
    )


def _turned(paper: ReadPaper) -> ReadPaper:
    """A polygon drawn the other way round."""
    ends = [one.place for one in reversed(paper.spots)]
    back = [replace(one, place=z) for one, z in zip(paper.spots[:0:-1], ends[1:], strict=True)]
    return replace(paper, spots=[replace(paper.spots[0], place=ends[0]), *back])


def worth(bench: PreparedPlan, paper: ReadPaper) -> float:
    """How many marks of a paper are where their steps lead, less those that are not."""
    bench = bench.at(paper.mu, fixed=True) if paper.mu else bench
    grading = _graded(bench, paper) if paper.spots else None
    if grading is None:
        return -len(bench.marks)
    judged = grading.judgement
    return len(judged.misses) - 2.0 * len(judged.wrong) - OPEN * bool(grading.gap_wrong) + NAMED * bool(judged.named)
