"""Whether enough was read, and reliably enough, for a verdict; otherwise, a sentence about the missing parts."""

from collections.abc import Collection

from planes.check.grading.evidence import (
    LEAST_UNASKED_PROBABILITY,
    MOST_CHANCE_OF_RANDOM_MARKS,
    SMALLEST_DRAWING_SIGMAS,
    marks_extent_mm,
)
from planes.check.grading.grading import Grading
from planes.check.grading.judging import WARNING_SIGMAS
from planes.check.grading.paper import ReadPaper
from planes.check.grading.prepared_plan import PreparedPlan, known_plans, mark_names
from planes.check.grading.remedies import phrase_with_remedy
from planes.drafting.steps import Same
from planes.drafting.steps.crossings import Cross, CrossArc, CrossArcs
from planes.words import Phrase, Written
from planes.words.lettering import plan_phrase
from planes.words.names import NO_PLAN, Mark

LEAST_READ_SHARE = 0.5  # share of a plan's intersections that must be read
MOST_MARKS_ASKED = 3  # maximum number of marks in a question


def key_marks(grading: Grading) -> list[Mark]:
    """The marks needed to judge a plan: its intersections, or all that are drawn."""
    steps = grading.hand.program.steps_by_result
    key = [m for m in grading.marks if isinstance(steps[m], Cross | CrossArc | CrossArcs)]
    return key or [m for m in grading.marks if not isinstance(steps[m], Same)]


def unreadable_reason(grading: Grading, named: Collection[str] = ()) -> Phrase | None:
    """None if enough was read to judge, if only the names of some marks; otherwise what is missing, as a sentence."""
    key = key_marks(grading)
    read_marks = [m for m in key if m in grading.judgement.misses or m.label in named]
    if len(read_marks) < LEAST_READ_SHARE * len(key):
        missing = ", ".join(m.label for m in key if m not in read_marks)
        steps = grading.hand.program.steps_by_result
        drawn = [m for m in grading.marks if not isinstance(steps[m], Same)]  # of coincident marks only one may be key
        read = sum(m in grading.judgement.misses for m in drawn)
        return phrase_with_remedy("check_too_little", found=read, count=len(drawn), names=missing)
    reach = marks_extent_mm(grading.hand, grading.marks)
    count = len(grading.judgement.misses)
    size = Written(f"{reach:.1f}")
    if (
        reach < SMALLEST_DRAWING_SIGMAS * grading.hand.tool.skill.point_mm
    ):  # all lies within the pencil error of the pole
        return phrase_with_remedy("check_nothing_drawn", size=size)
    if not grading.fault and grading.random_match_probability > MOST_CHANCE_OF_RANDOM_MARKS:
        return Phrase("check_by_chance", size=size, count=count)
    wrong = [m for m, v in grading.verdicts.items() if v == "wrong"]
    if grading.judgement.named is None and count >= 3 and len(wrong) > 0.7 * count:
        return Phrase("check_other_drawing", count=count, wrong=len(wrong))
    return None


def _unsure_marks(grading: Grading) -> list[Mark]:
    """Marks to ask a person about: possible misreadings, too uncertain for a verdict."""
    judgement = grading.judgement
    wrong = grading.chance_wrong if grading.fault else 1 - grading.chance_wrong
    doubted = [m for m in judgement.misses if grading.hand.taken[m].doubt]
    loose = judgement.named is None and any(grading.hand.taken[m].doubt > LEAST_UNASKED_PROBABILITY for m in doubted)
    if (wrong > LEAST_UNASKED_PROBABILITY and not (loose and grading.fault)) or not doubted:
        return []  # a mark of lines without visible ends is not called wrong for an individual cause
    odd = sorted(doubted, key=lambda m: (m not in judgement.wrong[:1], -judgement.misses[m].sigmas))
    return [m for m in odd if m in judgement.wrong or judgement.misses[m].sigmas > WARNING_SIGMAS][
        :MOST_MARKS_ASKED
    ] or odd[:1]


def doubtful_marks_question(grading: Grading) -> Phrase | None:
    """Whether some marks were read correctly, and how to tell; None if certain enough."""
    marks = _unsure_marks(grading)
    if not marks or grading.rebuilt:
        return phrase_with_remedy("check_force_unsure") if marks else None
    places = [(m.label, grading.hand.taken[m].place) for m in marks]
    mark_list = ", ".join(f"{n} ({z.real:.1f}; {z.imag:.1f})" for n, z in places)
    return phrase_with_remedy("check_ask", "mark", marks=Written(mark_list), mark=places[0][0])


def other_plan_message(bench: PreparedPlan, paper: ReadPaper) -> Phrase | None:
    """The message that a table is of another plan: all its mark names belong there, and not here."""
    written = [s.name for s in paper.spots]
    if paper.picture or all(map(bench.written_mark_names.find_exact_name, written)):
        return None
    others = (other for other in known_plans(bench.plans) if other.kind != bench.kind)
    fits = (o for o in others if all(map(mark_names(bench.plans, o, bench.naming).find_exact_name, written)))
    other = next(fits, NO_PLAN)
    if not other:
        return None
    return Phrase("check_of_another_plan", other=plan_phrase(other), plan=plan_phrase(bench.plan), option=other)
