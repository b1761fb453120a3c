"""The agreement of the reading of a drawing with its plan."""

from planes.check.grading.grading import Grading, grade
from planes.check.grading.paper import ReadPaper
from planes.check.grading.prepared_plan import PreparedPlan
from planes.check.grading.readable import unreadable_reason
from planes.words.errors import PlanesError

# cost of an open force polygon, and of a known mistake as its cause, in marks
OPEN_POLYGON_COST = 2.0
NAMED_MISTAKE_CREDIT = 0.5


def _grading_or_none(bench: PreparedPlan, paper: ReadPaper) -> Grading | None:
    """A paper's grading; None if it cannot be graded."""
    try:
        return grade(bench, paper)
    except PlanesError:
        return None


def is_right_paper(bench: PreparedPlan, paper: ReadPaper) -> bool:
    """Whether a paper is right."""
    grading = _grading_or_none(bench, paper)
    return grading is not None and not grading.fault and unreadable_reason(grading) is None


def agreement_score(bench: PreparedPlan, paper: ReadPaper) -> float:
    """The number of a paper's marks at their constructed points, minus the number of others."""
    bench = bench.at_scale(paper.mu)
    grading = _grading_or_none(bench, paper) if paper.spots else None
    if grading is None:
        return -len(bench.marks)
    judged = grading.judgement
    return (
        len(judged.misses)
        - 2.0 * len(judged.wrong)
        - OPEN_POLYGON_COST * bool(grading.wrong_closing_error_mm)
        + NAMED_MISTAKE_CREDIT * bool(judged.named)
    )
