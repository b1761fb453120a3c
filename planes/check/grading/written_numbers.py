"""Written numbers, lengths of segments or results, compared with those of the plans, mistakes and slips."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import partial

from planes.check.grading.evidence import chance_number_wrong, log_sum, logistic
from planes.check.grading.figures import WrittenNumber, value_without_error_columns
from planes.check.grading.handwork import Hand
from planes.check.grading.judging import LEAST_LEAD_LOG_ODDS, OTHER_CAUSE_WEIGHT
from planes.check.grading.slips import NUMBER_TOLERANCE_SHARE, NumberSlip, drawing_value, slip_behind_number
from planes.check.grading.variants import Variant
from planes.drafting.skill import TOLERANCE_SIGMAS, is_near_dead_point
from planes.words import Phrase, Written
from planes.words.units import number_text

ROUNDING_ERROR_SHARE = 0.005  # of a number calculated with three digits
LEAST_NUMBER_SHARE = 0.1  # of the true value: smaller numbers are not written more precisely
PRIOR_NUMBERS = 4  # weight of the prior: a careful draughtsman has half of a pupil's errors
LEAST_LOG_LIKELIHOOD = -4.5  # log likelihood limit: a number 3σ off


@dataclass
class Scored:
    """A judged figure: true value, its standard deviation, right, wrong or follows, and whether it is a close call."""

    figure: WrittenNumber
    true: float
    sigma: float
    verdict: str
    close: bool = False
    mine: float | None = None  # the value from the person's own drawing
    slip: NumberSlip | None = None  # the calculation slip that gives the number
    error_scale: float = 1.0  # the person's errors relative to a pupil's

    @property
    def error(self) -> float:
        """Standard deviation of the number as measured and written by a pupil."""
        return max(self.sigma, NUMBER_TOLERANCE_SHARE * abs(self.true) / 3)

    @property
    def tolerance(self) -> float:
        """How far from the true value it may be."""
        return max(3 * self.sigma, NUMBER_TOLERANCE_SHARE * abs(self.true))

    @property
    def deviation_from_true(self) -> float:
        """Its difference from the true value."""
        return _figure_deviation(self.figure, self.true)

    @property
    def chance_wrong(self) -> float:
        """The probability that the number is wrong, not only badly measured."""
        if self.slip:
            return 1.0
        return chance_number_wrong(self.deviation_from_true, self.error_scale * self.error, abs(self.true))


@dataclass
class Account:
    """All figures of a table, judged."""

    scored: list[Scored]
    lengths: bool  # of the drawing, not results
    named: Variant | None = None
    runner_up: str | None = None
    cause: float = 1.0  # the probability of the named cause, once the number is wrong

    @property
    def first_wrong_figure(self) -> Scored | None:
        """The first figure that is not right."""
        return next((s for s in self.scored if s.verdict == "wrong"), None)

    @property
    def first_wrong(self) -> str | None:
        """Its name, or the mark of a mistake identified by its lengths."""
        if self.named and self.lengths:
            return self.named.blames
        if self.first_wrong_figure:
            return self.first_wrong_figure.figure.name
        return None

    @property
    def fault(self) -> Phrase | None:
        """The first error and its correction."""
        if self.named or not (s := self.first_wrong_figure):
            return self.named.sentence if self.named else None
        if s.slip:
            return s.slip.said
        given, true = (Written(partial(number_text, value)) for value in (s.figure.given, s.true))
        return Phrase("check_number_unclear", mark=s.figure.name, given=given, true=true)


def judge_figures(
    figures: Sequence[WrittenNumber], free: Hand, own: Hand | None, variants: Iterable[Variant], ruler_mm: float = 0.0
) -> Account:
    """Judges figures against the true plan; names the mistake of the first wrong one."""
    own_account = Account([_judge_figure(f, free, own, ruler_mm) for f in figures], ruler_mm > 0)
    for s in own_account.scored:
        if s.verdict == "wrong":
            s.slip = slip_behind_number(s.figure, s.true, s.sigma, free)
            if s.slip is None and own is not None and s.mine:  # a slip made with the person's own segments
                s.slip = slip_behind_number(s.figure, s.mine, s.sigma, own)
        s.error_scale = relative_error_scale(own_account.scored)
    wrong = sum(s.verdict == "wrong" for s in own_account.scored)
    if own_account.first_wrong_figure and (own_account.lengths or len(own_account.scored) > 1):
        _name_mistake(
            own_account, free, variants, (True,) if own_account.lengths else (True, False) if wrong > 1 else (False,)
        )
    return own_account


def relative_error_scale(scored: Iterable[Scored]) -> float:
    """The person's errors relative to a pupil's, estimated from the right numbers of the table.

    So a number far off among exact ones is wrong, rather than badly measured.
    """
    squares = [(s.deviation_from_true / s.error) ** 2 for s in scored if s.verdict == "right" and s.error]
    return math.sqrt((PRIOR_NUMBERS + sum(squares)) / (PRIOR_NUMBERS + len(squares)))


def _judge_figure(f: WrittenNumber, free: Hand, own: Hand | None, ruler_mm: float) -> Scored:
    true, sigma = true_value_and_sigma(f, free, ruler_mm)
    off = _figure_deviation(f, true)
    farthest = free.tool.skill.far * TOLERANCE_SIGMAS * sigma
    if not ruler_mm and is_near_dead_point(true, sigma) and NUMBER_TOLERANCE_SHARE * abs(true) < off <= farthest:
        return _judge_by_own_marks(f, own, true, sigma)
    right = Scored(f, true, sigma, "right", off > max(2 * sigma, NUMBER_TOLERANCE_SHARE * abs(true)))
    if off <= right.tolerance + 1e-9 * abs(true):
        return right
    if own is None:
        return Scored(f, true, sigma, "wrong")
    mine = value_without_error_columns(f.read(own.things))
    follows = _figure_deviation(f, mine) <= max(
        3 * own.sigma_of_value(f.read(own.things)), NUMBER_TOLERANCE_SHARE * abs(mine)
    )
    return Scored(f, true, sigma, "follows" if follows else "wrong", mine=mine)


def _judge_by_own_marks(f: WrittenNumber, own: Hand | None, true: float, sigma: float) -> Scored:
    """A number of a plan near a dead point, which the person's own marks may still determine."""
    mine, spread = true_value_and_sigma(f, own) if own else (true, sigma)
    if own is None or is_near_dead_point(mine, spread):
        return Scored(f, true, sigma, "too_near")
    fits = _figure_deviation(f, mine) <= max(TOLERANCE_SIGMAS * spread, NUMBER_TOLERANCE_SHARE * abs(mine))
    verdict = "right" if abs(mine - true) <= TOLERANCE_SIGMAS * sigma else "follows"
    return Scored(f, true, sigma, verdict if fits else "wrong", mine=mine)


def true_value_and_sigma(f: WrittenNumber, free: Hand, ruler_mm: float = 0.0) -> tuple[float, float]:
    """The true value of a number, and its error (1σ) as drawn and read."""
    read = f.read(free.things)
    return value_without_error_columns(read), math.hypot(free.sigma_of_value(read), _ruler_error(f, free, ruler_mm))


def _ruler_error(f: WrittenNumber, free: Hand, ruler_mm: float) -> float:
    """The error of reading the segment itself: in mm for a segment, in SI for a result measured on a plan."""
    if ruler_mm or f.value:
        return ruler_mm
    mu = drawing_value(free, f.plan.mu_name) if f.plan else 0.0
    return free.tool.skill.ruler_mm / mu if mu else 0.0


def _figure_deviation(f: WrittenNumber, true: float) -> float:
    return abs(f.given - true) if f.signed else abs(abs(f.given) - abs(true))


def _name_mistake(own_account: Account, free: Hand, variants: Iterable[Variant], means: Sequence[bool]) -> None:
    """Names the mistake in a plan that gives all the numbers as written, drawn by hand or calculated (``means``).

    Other errors it explains after the first wrong figure follow from it. With a single wrong result, only the digits
    show a construction.
    """
    best: dict[str, tuple[float, Variant, list[float]]] = {}
    for variant in variants:
        things = {**free.things, **variant.givens, **free.redraw_with_variant(variant)}
        values = [value_without_error_columns(s.figure.read(things)) for s in own_account.scored]
        score, fits = max(_log_density_and_fits(own_account.scored, values, by_hand) for by_hand in means)
        score += math.log(variant.weight)
        if score > best.get(variant.mistake, (-math.inf,))[0]:
            best[variant.mistake] = score, variant, fits
    ranked = sorted(best.values(), key=lambda b: -b[0])
    if not ranked:
        return
    score, variant, fits = ranked[0]
    first = own_account.first_wrong_figure
    rest = [one[0] for one in ranked[1:]]
    if not own_account.lengths or (first and first.slip):
        rest.append(_log_density_of_slips(own_account.scored, means))
    odds = score - log_sum(*rest)
    if (
        sum(fits) + math.log(variant.weight) > LEAST_LOG_LIKELIHOOD * len(fits)
        and score - max(rest, default=-math.inf) >= LEAST_LEAD_LOG_ODDS
    ):
        own_account.named = variant
        own_account.cause = logistic(odds)
        for s, fit in zip(own_account.scored, fits, strict=True):
            if s.verdict == "wrong" and s is not first and fit > LEAST_LOG_LIKELIHOOD:
                s.verdict = "follows"
            if s is first:
                s.slip = None
    own_account.runner_up = ranked[1][1].mistake if len(ranked) > 1 and own_account.named else variant.mistake


def _log_density_of_slips(scored: Sequence[Scored], means: Sequence[bool]) -> float:
    """Log density of numbers of which each wrong one is a slip, or anything of its size, and the others as expected."""
    slips = [s for s in scored if s.verdict == "wrong" and s.slip]
    other = [s for s in scored if s.verdict == "wrong" and not s.slip]
    rest = [s for s in scored if s.verdict != "wrong"] + slips
    values = [s.slip.value if s in slips and s.slip else s.true for s in rest]
    anywhere = sum(math.log(max(abs(s.figure.given), s.sigma, 1e-12)) for s in other)
    return (math.log(OTHER_CAUSE_WEIGHT) - anywhere if other else 0.0) + max(
        _log_density_and_fits(rest, values, m)[0] for m in means
    )


def _log_density_and_fits(
    scored: Sequence[Scored], values: Sequence[float], by_hand: bool
) -> tuple[float, list[float]]:
    """The log density of written numbers given these values, and the fit of each."""
    sigmas = [
        max(
            s.sigma if by_hand else 0.0,
            (NUMBER_TOLERANCE_SHARE / 2 if by_hand else ROUNDING_ERROR_SHARE)
            * max(abs(v), LEAST_NUMBER_SHARE * abs(s.true)),
            1e-12,
        )
        for s, v in zip(scored, values, strict=True)
    ]
    fits = [
        _log_fit(_figure_deviation(s.figure, v) / sigma, v) for s, v, sigma in zip(scored, values, sigmas, strict=True)
    ]
    return sum(fits) - sum(map(math.log, sigmas)), fits


def _log_fit(off: float, value: float) -> float:
    return max(-0.5 * off**2, -50.0) if math.isfinite(value) else -50.0
