"""Judges misses: finds the first wrong mark and the mistake of the catalogue that explains it.

Every mistake is a hypothesis with the likelihood of the drawing under it, every mark given those before it; "correct
but for noise" and "wrong there for some other cause" are hypotheses, too. A mistake is named if it beats them and the
runner-up. If all marks are within limits, close calls are examined again for a mistake that explains them.

Marks share errors: a slight skew of a scheme appears in a force of inertia, and again in the reaction computed from the
moment of that force. The part of such an error shown by one mark is expected in the next, and is no new evidence there.
"""

import math
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy

from planes.check.grading.evidence import (
    SLIP_PROBABILITY,
    any_mark_log_density,
    chance_wrong,
    log_density_anywhere,
    log_prob_no_slips,
    log_sum,
    logistic,
    misread_log_density,
    right_mark_log_density,
)
from planes.check.grading.handwork import LEAST_MARK_ERROR_MM, Hand, Miss, Misses
from planes.check.grading.variants import Variant
from planes.drafting.steps import LayOff, Step
from planes.drafting.steps.reckoning import Calculate
from planes.words.frozen import frozen
from planes.words.names import Mark

FALSE_ALARM_SHARE = 0.02  # share of right drawings with the assumed unsteadiness of hand that would be rejected
WARNING_SIGMAS = 2.486  # as rare in two dimensions as 2σ in one
OTHER_CAUSE_WEIGHT = 0.1  # weight of "some other cause" against a named mistake
UNDRAWN_MARK_WEIGHT = 0.1  # weight of "drawn wrongly" against "left out", for a mark missing in the drawing
LEAST_LEAD_LOG_ODDS = 0.7  # minimum logarithm of a mistake's odds over the runner-up
LEAST_LOG_ODDS_OVER_CHANCE = math.log(20)  # minimum logarithm of a mistake's odds over chance, for marks within limits
# a mark this many σ off may show a mistake whose odds over a drawing error (a logarithm) reach this value
CLOSE_CALL_SIGMAS, RIVAL_MISTAKE_LOG_ODDS = 1.8, math.log(8)


@dataclass
class Judgement:
    """The findings: misses of every mark, the wrong ones in order of drawing, and the explanation of the first."""

    limit: float
    misses: Misses
    wrong: list[Mark] = field(default_factory=list)
    named: Variant | None = None
    runner_up: Variant | None = None
    as_well: Variant | None = None  # for marks within limits, the mistake that explains them as well as a drawing error
    explained: Misses = field(default_factory=dict)  # misses of marks under the mistake
    score: float = 0.0  # log likelihood of the drawing, with the named mistake or without any
    chance_wrong: float = 0.0  # probability that some mark is wrong
    cause: float = 1.0  # probability of the named mistake among all causes, once a mark is wrong

    @property
    def first_wrong(self) -> str | None:
        """The label of the mark where the drawing goes wrong."""
        if self.named:
            return self.named.blames
        return self.wrong[0].label if self.wrong else None

    def miss_for_verdict(self, mark: Mark, verdict: str) -> Miss | None:
        """The miss of a mark from its step's result; from the named mistake's result, if it follows from that."""
        own = self.misses.get(mark)
        return self.explained.get(mark, own) if verdict == "follows" else own


def judge(
    hand: Hand, marks: Sequence[Mark], variants: Iterable[Variant], extent_mm: float, absent: Collection[str] = ()
) -> Judgement:
    """Grades marks in order of drawing and names the first mistake; ``absent`` marks are missing."""
    weighing = _Weighing(hand, marks, log_density_anywhere(extent_mm))
    judgement = Judgement(weighing.limit, weighing.misses)
    judgement.wrong = [m for m, miss in judgement.misses.items() if not miss.sigmas <= judgement.limit]
    judgement.score = sum(weighing.mark_log_density(m, miss) for m, miss in judgement.misses.items())
    drawn = {m.label for m in judgement.misses} - set(absent)
    suspects = judgement.wrong[:1] or [m for m, miss in judgement.misses.items() if miss.sigmas > CLOSE_CALL_SIGMAS]
    close = any(judgement.misses[m].sigmas > WARNING_SIGMAS for m in suspects)
    ranked = weighing.rank_mistakes(variants, drawn, suspects) if suspects else []
    if ranked and judgement.wrong:  # does the likeliest mistake explain the first wrong mark well enough?
        _name_likeliest_mistake(judgement, ranked, max(0.0, weighing.unknown_cause_score(judgement.wrong[0])))
    elif (
        ranked and close and ranked[0].score >= LEAST_LOG_ODDS_OVER_CHANCE
    ):  # it explains close calls too well for chance
        judgement.wrong = [m for m in judgement.misses if m.label == ranked[0].variant.blames]
        _name_likeliest_mistake(judgement, ranked, 0.0)
    elif ranked and ranked[0].score >= RIVAL_MISTAKE_LOG_ODDS:
        judgement.as_well = ranked[0].variant
    suspect = next((m for m in judgement.wrong[:1] if weighing.doubts[m]), None)
    right = weighing.log_prob_all_right(suspect)
    otherwise = weighing.log_prob_misread_mark(suspect) if suspect else -math.inf
    judgement.chance_wrong = chance_wrong(right, otherwise, (one.score for one in ranked))
    return judgement


@frozen
class ScoredHypothesis:
    """A hypothesis with its logarithmic score against "correct but for noise", and the misses under it."""

    score: float
    variant: Variant
    under: Misses


class _Weighing:
    """Weighs hypotheses about the marks of a hand against each other."""

    def __init__(self, hand: Hand, marks: Sequence[Mark], broad: float) -> None:
        self.hand = hand
        self.broad = broad
        self.order = judging_order(hand.program.steps, marks)
        self.plain = hand.misses(marks)
        # limit of a miss in σ: 3σ for a single mark, more where many could each be the unlucky one
        self.limit = math.sqrt(-2 * math.log(FALSE_ALARM_SHARE / max(len(self.plain), 4)))
        self.misses = misses_given_earlier(self.plain, self.order, self.limit)
        self.doubts = {m: hand.taken[m].doubt for m in self.plain}

    def mark_log_density(self, mark: Mark, miss: Miss) -> float:
        """Logarithm of the density of a mark's miss."""
        return any_mark_log_density(miss, self.broad, self.doubts[mark])

    def unknown_cause_score(self, mark: Mark) -> float:
        """The score a mistake needs to explain a mark better than "some other cause" or a misreading."""
        miss = self.misses[mark]
        taken = misread_log_density(miss.off, self.broad, self.doubts[mark]) - math.log(SLIP_PROBABILITY)
        return log_sum(
            math.log(OTHER_CAUSE_WEIGHT) + self._unknown_cause_log_density(mark), taken
        ) - self.mark_log_density(mark, miss)

    def _unknown_cause_log_density(self, mark: Mark) -> float:
        """Log density of a mark that is wrong for no known cause: anywhere, or anywhere on a line of its step."""
        step = self.hand.program.steps_by_result[mark]
        every = [self.broad]
        for start, along in (("start", "along"), ("other", "across")):
            if hasattr(step, along):
                origin, way = (complex(self.hand.value_without_errors(getattr(step, name))) for name in (start, along))
                aside = way.conjugate() / abs(way)
                spread = float(((self.misses[mark].change * aside).imag ** 2).sum()) + LEAST_MARK_ERROR_MM**2
                off = ((self.hand.taken[mark].place - origin) * aside).imag
                every.append(-0.5 * (off**2 / spread + math.log(2 * math.pi * spread) - self.broad))
        return log_sum(*every) - math.log(len(every))

    def log_likelihood_gain(self, misses: Misses) -> float:
        """The log likelihood ratio of misses to those of the original steps."""
        return sum(
            self.mark_log_density(m, miss) - self.mark_log_density(m, self.misses[m]) for m, miss in misses.items()
        )

    def log_prob_all_right(self, suspect: Mark | None) -> float:
        """Log probability that no mark slipped and a suspected one was read correctly."""
        share = log_prob_no_slips(self.misses, self.broad, self.doubts)
        if suspect is None or not math.isfinite(self.misses[suspect].sigmas):
            return share
        miss = self.misses[suspect]
        misread = right_mark_log_density(miss, self.broad, self.doubts[suspect])
        return share + right_mark_log_density(miss, self.broad, 0.0) - misread

    def log_prob_misread_mark(self, mark: Mark) -> float:
        """The same with another point misread as the suspected mark, located instead by the marks drawn from it."""
        hand = self.hand
        own = hand.taken[mark]
        left = {m: t for m, t in hand.taken.items() if m != mark}
        other = Hand(hand.program, hand.given, hand.tool.skill, left, hand.unsure)
        plain = other.misses([m for m in self.plain if m != mark])
        misses = misses_given_earlier(plain, self.order, self.limit)
        own_miss = self.mark_log_density(mark, self.misses[mark])
        off = misread_log_density(own.place - complex(other.value_without_errors(mark)), self.broad, self.doubts[mark])
        return self.log_likelihood_gain(misses) + off - own_miss + log_prob_no_slips(misses, self.broad, self.doubts)

    def rank_mistakes(
        self, variants: Iterable[Variant], drawn: set[str], suspects: Collection[Mark]
    ) -> list[ScoredHypothesis]:
        """The mistakes that affect a suspected mark, the likeliest first."""
        scored = []
        for variant in variants:
            touched = self.hand.misses(list(self.plain), self.hand.redraw_with_variant(variant))
            suspected = any(m in touched and math.isfinite(touched[m].sigmas) for m in suspects)
            if not suspected or not self._is_visible_mistake(variant, touched):
                continue
            under = misses_given_earlier({**self.plain, **touched}, self.order, self.limit)
            if any(m.label == variant.blames and miss.sigmas >= self.misses[m].sigmas for m, miss in under.items()):
                continue  # its mark is nearer to its right position than to the one under the mistake
            # a mark missing in the drawing was most likely left out, another was not
            unlike = (variant.blames in drawn) == variant.omits
            score = self.log_likelihood_gain(under) + math.log(
                variant.weight * (UNDRAWN_MARK_WEIGHT if unlike else 1.0)
            )
            scored.append(ScoredHypothesis(score, variant, under))
        return _best_variant_per_mistake(scored)

    def _is_visible_mistake(self, variant: Variant, touched: Misses) -> bool:
        """Whether a mistake moves its mark beyond the drawing error, given the others (if unread: moves some mark).

        A mark left out shows by its absence.
        """
        own = [m for m in touched if m.label == variant.blames] or touched
        apart = (replace(self.misses[m], off=touched[m].off - self.plain[m].off) for m in own)
        return variant.omits or any(not miss.sigmas <= self.limit for miss in apart)


def _name_likeliest_mistake(judgement: Judgement, ranked: Sequence[ScoredHypothesis], unknown: float) -> None:
    """Names the likeliest mistake if it is well ahead of the next and no less likely than an unknown cause."""
    best = ranked[0]
    rest = ranked[1:]
    if best.score < unknown or (rest and best.score - rest[0].score < LEAST_LEAD_LOG_ODDS):
        judgement.runner_up = best.variant
        return
    judgement.named = best.variant
    judgement.runner_up = rest[0].variant if rest else None
    judgement.cause = logistic(best.score - log_sum(unknown, *(one.score for one in rest)))
    judgement.explained = {m: miss for m, miss in best.under.items() if miss.sigmas <= judgement.limit}
    judgement.score += best.score + math.log(SLIP_PROBABILITY)


def _best_variant_per_mistake(scored: Sequence[ScoredHypothesis]) -> list[ScoredHypothesis]:
    """The best variant of every mistake, the best mistake first, with the likelihoods of its variants added up."""
    groups: dict[str, list[ScoredHypothesis]] = {}
    for one in scored:
        groups.setdefault(one.variant.mistake, []).append(one)
    merged = []
    for group in groups.values():
        best = max(group, key=lambda n: n.score)
        total = best.score + math.log(sum(math.exp(n.score - best.score) for n in group))
        merged.append(replace(best, score=total))
    return sorted(merged, key=lambda n: -n.score)


def mark_verdicts(judgement: Judgement, order: Sequence[Mark], strayed: Mapping[Mark, bool]) -> dict[Mark, str]:
    """right, wrong, follows or unread for every mark; ``strayed`` says which are off the true plan."""
    out = {}
    upset = False
    for mark in order:
        label = mark.label
        upset = upset or label == judgement.first_wrong
        if mark not in judgement.misses:
            out[mark] = "unread"
        elif mark in judgement.wrong and not (mark in judgement.explained and label != judgement.first_wrong):
            out[mark] = "wrong"
            upset = True
        else:
            out[mark] = "follows" if (upset or mark in judgement.wrong) and strayed.get(mark) else "right"
    return out


def misses_given_earlier(misses: Misses, order: Sequence[Mark], limit: float) -> Misses:
    """Every miss given those before it; a mark off by more than ``limit`` σ is no evidence about others."""
    names = [m for m in order if m in misses]
    if not names:
        return {}
    changes = numpy.array([misses[m].change for m in names])
    rows = numpy.stack([changes.real, changes.imag], axis=1).reshape(2 * len(names), -1)
    cov = rows @ rows.T + LEAST_MARK_ERROR_MM**2 * numpy.eye(len(rows))
    off = numpy.array([misses[m].off for m in names]).view(float)
    known_before = {}
    for i, name in enumerate(names):
        x = 2 * i
        y = 2 * i + 1
        left = float(cov[x, x]), float(cov[x, y]), float(cov[y, y])
        known_before[name] = Miss(complex(off[x], off[y]), left, misses[name].change)
        if known_before[name].sigmas <= limit:
            for k in (x, y):
                gain = cov[k] / cov[k, k]
                off = off - gain * off[k]
                cov = cov - numpy.outer(gain, cov[k])
    return {m: known_before[m] for m in misses}


def judging_order(steps: Iterable[Step], marks: Sequence[Mark]) -> list[Mark]:
    """Marks in order of drawing, except that a force computed from others (F^t, from moments) comes after them."""
    made = {s.makes: s for s in steps}
    laid = {m: s.length for m in marks if isinstance(s := made[m], LayOff)}
    late = []
    for k, mark in enumerate(laid):
        formula = made.get(laid[mark])
        parts = {n for n, _ in formula.input_names()} if isinstance(formula, Calculate) else set()
        if parts & set(list(laid.values())[k + 1 :]):
            late.append(mark)
    last = marks.index([*laid][-1]) + 1 if laid else 0
    return [*(m for m in marks[:last] if m not in late), *late, *marks[last:]]
