"""Checks a person's drawing of one plan: aligns it, finds its scale, grades every mark, names the first mistake."""

import math
from dataclasses import dataclass, field
from functools import cached_property

from planes.check.grading.evidence import (
    SURE_VERDICT_PROBABILITY,
    candidate_scales,
    chance_of_random_marks,
    chance_wrong,
    log_density_anywhere,
    log_prob_no_slips,
)
from planes.check.grading.followers import Showing, determining_mark_sets, source_marks_of_elements
from planes.check.grading.handwork import Hand, Miss, Misses
from planes.check.grading.judging import Judgement, judge, mark_verdicts
from planes.check.grading.off_vectors import wrong_vector_phrase
from planes.check.grading.paper import ReadPaper, TakenMarks
from planes.check.grading.polygons import Rebuilt, align_marks, marks_of_earlier_plans
from planes.check.grading.prepared_plan import PreparedPlan, mistake_variants
from planes.drafting.drawing import Drawing, draw_program
from planes.drafting.skill import TOLERANCE_SIGMAS
from planes.drafting.steps import LayOff, Same, Step
from planes.geometry.plane import distance_to_nearest
from planes.plans.extents import plan_extent
from planes.plans.scales import ZERO_VECTOR_MM
from planes.words import Phrase, Written
from planes.words.names import NO_MARK, Mark, letter_of

OWN_SCALE_LOG_ODDS = -3.0  # logarithm of the prior odds of a scale other than the stated one
SHORTEST_SEEN_VECTOR_MM = 3.0  # a shorter vector shows no scale, and may be invisible
MOST_MISREADING_MM = 3.0  # an error this large is no misreading
LEAST_FITTING_SHARE = 0.9  # share of the other marks that must be seen and right before a single one is blamed


@dataclass
class Grading:
    """A drawing graded at one scale."""

    hand: Hand
    truth: Drawing
    marks: list[Mark]
    mu: float
    judgement: Judgement
    free: Misses
    loose: Hand  # the plan without the person's own marks
    said_mu: bool
    rebuilt: Rebuilt | None
    notes: list[Phrase] = field(default_factory=list)
    unknown: list[str] = field(default_factory=list)  # names of marks that the plan lacks

    @property
    def closing_error(self) -> complex:
        """The closing error of a force polygon, mm."""
        if self.rebuilt and self.rebuilt.gap:
            return self.rebuilt.gap.place
        return 0j

    @property
    def wrong_closing_error_mm(self) -> float | None:
        """The size of the closing error, where drawing errors and short unseen forces do not account for it."""
        if self._closing_error_excess_mm > sum(self._short_unseen_forces_mm.values()):
            return abs(self.closing_error)
        return None

    @property
    def _closing_error_excess_mm(self) -> float:
        if self.closing_error_sigma_mm:
            return abs(self.closing_error) - self.judgement.limit * self.closing_error_sigma_mm
        return 0.0

    @property
    def _short_unseen_forces_mm(self) -> dict[str, float]:
        """Lengths of the short unseen forces, by their marks."""
        absent = [m for m in self.marks if self.rebuilt and m.label in self.rebuilt.absent]
        lengths = {m.label: self.laid_off_length_mm(m) for m in absent}
        return {m: mm for m, mm in lengths.items() if ZERO_VECTOR_MM <= mm <= SHORTEST_SEEN_VECTOR_MM}

    def laid_off_length_mm(self, mark: Mark) -> float:
        """The length of a vector that is laid off; 0 for other constructions."""
        step = self.hand.program.steps_by_result[mark]
        if isinstance(step, LayOff):
            return float(abs(self.truth[mark] - self.truth[step.start]))
        return 0.0

    @property
    def closing_error_sigma_mm(self) -> float | None:
        """The drawing error at the closure of a polygon, mm; None if there is no closure."""
        gap = self.rebuilt.gap if self.rebuilt else None
        if gap:
            return math.sqrt(2 * self.hand.tool.skill.point_mm**2 + 2 * gap.error_mm**2)
        return None

    @property
    def chance_wrong(self) -> float:
        """The probability of an error: in a mark, a force left out, a polygon that does not close."""
        if self._may_be_confused_vectors():
            return 0.5
        if self.missing_force:
            return 1.0
        if not (self.wrong_closing_error_mm and self.closing_error_sigma_mm):
            return self.judgement.chance_wrong
        broad = log_density_anywhere(plan_extent(self.truth, self.marks[0].plan))
        closed = log_prob_no_slips(
            {NO_MARK: Miss(self.closing_error, (self.closing_error_sigma_mm**2, 0.0, self.closing_error_sigma_mm**2))},
            broad,
            {NO_MARK: 0.0},
        )
        return max(self.judgement.chance_wrong, chance_wrong(closed, -math.inf, ()))

    def _may_be_confused_vectors(self) -> bool:
        """Whether the fault of a polygon may only be a confusion of its vectors."""
        named = self.judgement.named
        missing = named.blames if named and named.omits else self.missing_force
        if self.rebuilt is None or not (missing or (self.judgement.wrong and not named)):
            return False
        made = (self.hand.program.steps_by_result[m] for m in self.marks if m.label == missing)
        step = next((s for s in made if isinstance(s, LayOff)), None)
        return self.rebuilt.may_be_confused_vectors(
            complex(self.truth[step.makes] - self.truth[step.start]) if step else None
        )

    @property
    def missing_force(self) -> str | None:
        """A known force that is missing in the polygon, with no read mark drawn from it."""
        if self.rebuilt is None or self.judgement.wrong:
            return None
        roots = source_marks_of_elements(self.hand.program)
        used = set[str]().union(*(roots[m] for m in self.judgement.misses))
        for mark in self.marks:
            step = self.hand.program.steps_by_result[mark]
            if (
                isinstance(step, LayOff) and self.laid_off_length_mm(mark) > SHORTEST_SEEN_VECTOR_MM
            ):  # a short one may be there, unseen
                miss = self.hand.miss(self.hand.things[mark], self.hand.value_without_errors(step.start))
                if mark.label in self.rebuilt.absent or (mark not in used and miss.sigmas > self.judgement.limit):
                    return mark.label
        return None

    @property
    def polygon_fault(self) -> Phrase | None:
        """An error though no mark is wrong: a missing force, a polygon that does not close."""
        if left := self.missing_force:
            return Phrase(f"mistake_{'weight' if letter_of(left) == 'G' else 'force'}_missing", mark=left)
        gap = self.wrong_closing_error_mm
        if gap and self.rebuilt:
            return Phrase("mistake_not_closed", mark=self.rebuilt.closing, gap=Written(f"{gap:.1f}"))
        return None

    @property
    def fault(self) -> Phrase | None:
        """The first error and its correction."""
        named = self.judgement.named
        wrong = self.judgement.wrong
        if named:
            return named.sentence
        if not wrong:
            return self.polygon_fault
        off = self.judgement.misses[wrong[0]].off
        if math.isfinite(abs(off)):
            return wrong_vector_phrase(self.hand, wrong[0], off)
        return Phrase("check_undrawable", mark=wrong[0].label)

    @property
    def unverified_marks(self) -> list[str]:
        """Unread marks not determined by others, short forces needed for a polygon to close, and unknown names.

        A mark counts, too, if a mistake explains it as well as a drawing error.
        """
        read = self.judgement.misses.keys()
        hidden = [m.label for m, ways in self.determining_marks.items() if not any(read >= {*way} for way in ways)]
        doubted = [self.judgement.as_well.blames] if self.judgement.as_well else []
        return [
            *hidden,
            *(self._short_unseen_forces_mm if self._closing_error_excess_mm > 0 else ()),
            *doubted,
            *self.unknown,
        ]

    @cached_property
    def determining_marks(self) -> dict[Mark, Showing]:
        """For each mark the evidence of its position: itself, or marks drawn from it; coincident marks need none."""
        there = [m for m in self.marks if not self._coincides_with_another(self.hand.program.steps_by_result[m])]
        absent = self.rebuilt.absent if self.rebuilt else ()
        return {m: determining_mark_sets(self.truth, m, self.marks) for m in there if m.label not in absent}

    def _coincides_with_another(self, step: Step) -> bool:
        """Whether a mark coincides with another, or its laid-off length is within the drawing error."""
        return isinstance(step, Same) or (
            isinstance(step, LayOff)
            and self.laid_off_length_mm(step.makes) < TOLERANCE_SIGMAS * self.hand.tool.skill.point_mm
        )

    @property
    def first_wrong(self) -> str | None:
        """The mark of the first error: drawn wrongly, left out, or where a polygon should close."""
        return str(self.fault.parts["mark"]) if self.fault else None

    @property
    def runner_up(self) -> str | None:
        """The second most likely mistake."""
        judgement = self.judgement
        if judgement.runner_up and judgement.first_wrong:
            return judgement.runner_up.mistake
        return None

    @property
    def random_match_probability(self) -> float:
        """The probability that random marks on the drawing would be as right."""
        j = self.judgement
        sigma = self.closing_error_sigma_mm
        return chance_of_random_marks(
            self.hand, j.misses, j.limit, not self.said_mu, j.limit * sigma if sigma else None
        )

    @property
    def is_certain_without_pole(self) -> bool:
        """Whether marks read without a named pole prove themselves rightly identified.

        There are several; the wrong ones are far off, while nearly all others were seen and are right.
        """
        judgement = self.judgement
        apart = [0j]
        for place in (self.hand.taken[m].place for m in judgement.misses):
            if distance_to_nearest(place, apart) > MOST_MISREADING_MM:
                apart.append(place)
        if len(apart) < 3 or not self.fault:
            return len(apart) > 2
        off = max((abs(judgement.misses[m].off) for m in judgement.wrong), default=0.0)
        fitting = judgement.explained.keys() if judgement.named else judgement.misses.keys() - judgement.wrong
        others = [m for m in self.determining_marks if m.label != judgement.first_wrong]
        return off > MOST_MISREADING_MM and sum(m in fitting for m in others) >= LEAST_FITTING_SHARE * len(others)

    @property
    def verdicts(self) -> dict[Mark, str]:
        """right, wrong, follows or unread for every mark of the plan."""
        return mark_verdicts(
            self.judgement, self.marks, {m: x.sigmas > self.judgement.limit for m, x in self.free.items()}
        )


def grade(bench: PreparedPlan, paper: ReadPaper) -> Grading | None:
    """Grades a paper of marks at the scale that explains it best; None if no mark of the plan was read."""
    spots, rebuilt, unknown = align_marks(bench, bench.plan, paper)
    if not spots:
        return None
    taken = {bench.plan.mark(n): s for n, s in spots.items()} | marks_of_earlier_plans(bench)
    tried = []
    for mu, share in candidate_scales(bench, taken):
        grading = _grade_at_scale(bench, mu, share, taken, rebuilt)
        tried.append((round(grading.judgement.score, 9) + OWN_SCALE_LOG_ODDS * (not grading.said_mu), grading))
        if grading.said_mu and not _may_be_rescaled(grading):
            break
    best = max(tried, key=lambda one: one[0])[1]
    best.unknown = unknown
    if unknown:
        best.notes.append(Phrase("check_unknown", names=", ".join(unknown)))
    return best


def _may_be_rescaled(grading: Grading) -> bool:
    """Whether another scale may cause the wrong marks: in a force plan all forces would be wrong, not one."""
    if not grading.judgement.wrong or not grading.marks[0].plan.is_force:
        return bool(grading.judgement.wrong)
    laid = [m for m in grading.judgement.misses if grading.laid_off_length_mm(m) > SHORTEST_SEEN_VECTOR_MM]
    return len(laid) < 2 or sum(m in grading.judgement.wrong for m in laid) > 1


def _grade_at_scale(
    bench: PreparedPlan, mu: float, share: float, taken: TakenMarks, rebuilt: Rebuilt | None = None
) -> Grading:
    """Grades at one scale."""
    skill = bench.asked.skill
    name = bench.plan.mu_name
    given = {**bench.given, name: mu}
    unsure = {name: share} if share and name in bench.program.given_names else {}
    hand = Hand(bench.program, given, skill, taken, unsure)
    truth = draw_program(bench.program, given)
    free = Hand(bench.program, given, skill, {m: t for m, t in taken.items() if m not in bench.marks}, unsure)
    own = {m: taken[m] for m in bench.marks if m in taken}  # the largest error from drafting alone
    apart = {m: free.miss(free.things[m], t.place).with_reading_error(t.error_mm) for m, t in own.items()}
    absent = rebuilt.absent if rebuilt else ()
    judgement = judge(
        hand, bench.marks, mistake_variants(bench, hand.taken, mu), plan_extent(truth, bench.plan), absent
    )
    wrong = judgement.wrong
    at_home = {m for m, miss in apart.items() if miss.sigmas <= judgement.limit}
    judgement.wrong = wrong[:1] + [m for m in wrong[1:] if m not in at_home]  # off a wrong mark, but in the right place
    doubtful = (
        any(t.doubt for t in own.values())
        and judgement.chance_wrong < 1 - SURE_VERDICT_PROBABILITY
        and at_home >= apart.keys()
    )
    if doubtful and not judgement.named and all(apart[m].sigmas < 1 for m in judgement.wrong):
        judgement.wrong = []  # all are in the right place: the base of the first was misread slightly
    return Grading(hand, truth, bench.marks, mu, judgement, apart, free, mu == bench.said_mu, rebuilt)


def grading_without_marks(bench: PreparedPlan) -> Grading:
    """The grading of a drawing before any mark is read, at the stated scale."""
    return _grade_at_scale(bench, bench.said_mu, 0.0, marks_of_earlier_plans(bench))
