"""How well what was read of a drawing agrees with its plan."""

from planes.check.grading.grading import Grading, grade
from planes.check.grading.paper import ReadPaper
from planes.check.grading.prepared_plan import PreparedPlan
from planes.check.grading.readable import readable
from planes.words.errors import PlanesError

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


def worth(bench: PreparedPlan, paper: ReadPaper) -> float:
    """How many marks of a paper are where their steps lead, less those that are not."""
    bench = bench.at(paper.mu, fixed=True) if paper.mu else bench
    grading = _graded(bench, paper) if paper.spots else None
    if grading is None:
        return -len(bench.marks)
    judged = grading.judgement
    return len(judged.misses) - 2.0 * len(judged.wrong) - OPEN * bool(grading.gap_wrong) + NAMED * bool(judged.named)
