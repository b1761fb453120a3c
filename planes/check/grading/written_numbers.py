"""Written numbers, lengths of segments or results, compared with those of the plans, mistakes and slips."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import partial

from numpy import logaddexp

from planes.check.grading.evidence import chance_off, logistic
from planes.check.grading.figures import WrittenNumber, first_of
from planes.check.grading.handwork import Hand
from planes.check.grading.judging import MARGIN, OTHER_CAUSE
from planes.check.grading.slips import SHARE, NumberSlip, number_mistake, number_of
from planes.check.grading.variants import Variant
from planes.drafting.skill import SIGMAS, too_near
from planes.words import Phrase, Written
from planes.words.names import mu_of
from planes.words.units import number

ROUNDED = 0.005  # of a number calculated with three digits
LEAST = 0.1  # of the true value: smaller numbers are not written more precisely
PRIOR_NUMBERS = 4  # weight of the prior: a careful draughtsman has half of a pupil's errors
LIKELY = -4.5  # log likelihood limit: a number 3σ off


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
        return max(self.sigma, SHARE * abs(self.true) / 3)

    @property
    def tolerance(self) -> float:
        """How far from the true value it may be."""
        return max(3 * self.sigma, SHARE * abs(self.true))

    @property
    def off(self) -> float:
        """Its difference from the true value."""
        return _off(self.figure, self.true)

    @property
    def chance_wrong(self) -> float:
        """The probability that the number is wrong, not only badly measured."""
        return 1.0 if self.slip else chance_off(self.off, self.error_scale * self.error, abs(self.true))


@dataclass
class Account:
    """All figures of a table, judged."""

    scored: list[Scored] = field(default_factory=list)
    lengths: bool = False  # of the drawing, not results
    named: Variant | None = None
    runner_up: str | None = None
    cause: float = 1.0  # the probability of the named cause, once the number is wrong

    @property
    def first(self) -> Scored | None:
        """The first figure that is not right."""
        return next((s for s in self.scored if s.verdict == "wrong"), None)

    @property
    def unsure(self) -> list[str]:
        """The figures too close to a dead point to be judged."""
        return [s.figure.name for s in self.scored if s.verdict == "too_near"]

    @property
    def first_wrong(self) -> str | None:
        """Its name, or the mark of a mistake identified by its lengths."""
        if self.named and self.lengths:
            return self.named.blames
        return self.first.figure.name if self.first else None

    @property
    def fault(self) -> Phrase | None:
        """The first error and its correction."""
        if self.named or not (s := self.first):
            return self.named.sentence if self.named else None
        if s.slip:
            return s.slip.said
        given, true = (Written(partial(number, value)) for value in (s.figure.given, s.true))
        return Phrase("check_number_unclear", mark=s.figure.name, given=given, true=true)


def account(
    figures: Sequence[WrittenNumber], free: Hand, own: Hand | None, variants: Iterable[Variant], ruler_mm: float = 0.0
) -> Account:
    """Judges figures against the true plan; names the mistake of the first wrong one."""
    own_account = Account([_judged(f, free, own, ruler_mm) for f in figures], ruler_mm > 0)
    for s in own_account.scored:
        if s.verdict == "wrong":
            s.slip = number_mistake(s.figure, s.true, s.sigma, free)
            if s.slip is None and own is not None and s.mine:  # a slip made with the person's own segments
                s.slip = number_mistake(s.figure, s.mine, s.sigma, own)
        s.error_scale = error_scale(own_account.scored)
    wrong = sum(s.verdict == "wrong" for s in own_account.scored)
    if own_account.first and (own_account.lengths or len(own_account.scored) > 1):
        _name(own_account, free, variants, (True,) if own_account.lengths else (True, False) if wrong > 1 else (False,))
    return own_account


def error_scale(scored: Iterable[Scored]) -> float:
    """The person's errors relative to a pupil's, estimated from the right numbers of the table.

    So a number far off among exact ones is wrong, rather than badly measured.
    """
    squares = [(s.off / s.error) ** 2 for s in scored if s.verdict == "right" and s.error]
    return math.sqrt((PRIOR_NUMBERS + sum(squares)) / (PRIOR_NUMBERS + len(squares)))


def _judged(f: WrittenNumber, free: Hand, own: Hand | None, ruler_mm: float) -> Scored:
    true, sigma = drawn_by(f, free, ruler_mm)
    off = _off(f, true)
    farthest = free.tool.skill.far * SIGMAS * sigma
    if not ruler_mm and too_near(true, sigma) and SHARE * abs(true) < off <= farthest:
        return _by_own_marks(f, own, true, sigma)
    right = Scored(f, true, sigma, "right", off > max(2 * sigma, SHARE * abs(true)))
    if off <= right.tolerance + 1e-9 * abs(true):
        return right
    if own is None:
        return Scored(f, true, sigma, "wrong")
    mine = first_of(f.read(own.things))
    follows = _off(f, mine) <= max(3 * own.spread_of(f.read(own.things)), SHARE * abs(mine))
    return Scored(f, true, sigma, "follows" if follows else "wrong", mine=mine)


def _by_own_marks(f: WrittenNumber, own: Hand | None, true: float, sigma: float) -> Scored:
    """A number of a plan near a dead point, which the person's own marks may still determine."""
    mine, spread = drawn_by(f, own) if own else (true, sigma)
    if own is None or too_near(mine, spread):
        return Scored(f, true, sigma, "too_near")
    fits = _off(f, mine) <= max(SIGMAS * spread, SHARE * abs(mine))
    verdict = "right" if abs(mine - true) <= SIGMAS * sigma else "follows"
    return Scored(f, true, sigma, verdict if fits else "wrong", mine=mine)


def drawn_by(f: WrittenNumber, free: Hand, ruler_mm: float = 0.0) -> tuple[float, float]:
    """The true value of a number, and its error (1σ) as drawn and read."""
    read = f.read(free.things)
    return first_of(read), math.hypot(free.spread_of(read), _ruler(f, free, ruler_mm))


def _ruler(f: WrittenNumber, free: Hand, ruler_mm: float) -> float:
    """The error of reading the segment itself: in mm for a segment, in SI for a result measured on a plan."""
    if ruler_mm or f.value:
        return ruler_mm
    mu = number_of(free, mu_of(f.plan)) if f.plan else 0.0
    return free.tool.skill.ruler_mm / mu if mu else 0.0


def _off(f: WrittenNumber, true: float) -> float:
    return abs(f.given - true) if f.signed else abs(abs(f.given) - abs(true))


def _name(own_account: Account, free: Hand, variants: Iterable[Variant], means: Sequence[bool]) -> None:
    """Names the mistake in a plan that gives all the numbers as written, drawn by hand or calculated (``means``).

    Other errors it explains after the first wrong figure follow from it. With a single wrong result, only the digits
    show a construction.
    """
    best: dict[str, tuple[float, Variant, list[float]]] = {}
    for variant in variants:
        things = {**free.things, **variant.givens, **free.under(variant)}
        values = [first_of(s.figure.read(things)) for s in own_account.scored]
        score, fits = max(_explained(own_account.scored, values, by_hand) for by_hand in means)
        score += math.log(variant.weight)
        if score > best.get(variant.mistake, (-math.inf,))[0]:
            best[variant.mistake] = score, variant, fits
    ranked = sorted(best.values(), key=lambda b: -b[0])
    if not ranked:
        return
    (score, variant, fits), first, rest = ranked[0], own_account.first, [one[0] for one in ranked[1:]]
    if not own_account.lengths or (first and first.slip):
        rest.append(_one_by_one(own_account.scored, means))
    odds = score - float(logaddexp.reduce([-math.inf, *rest]))
    if sum(fits) + math.log(variant.weight) > LIKELY * len(fits) and score - max(rest, default=-math.inf) >= MARGIN:
        own_account.named, own_account.cause = variant, logistic(odds)
        for s, fit in zip(own_account.scored, fits, strict=True):
            if s.verdict == "wrong" and s is not first and fit > LIKELY:
                s.verdict = "follows"
            if s is first:
                s.slip = None
    own_account.runner_up = ranked[1][1].mistake if len(ranked) > 1 and own_account.named else variant.mistake


def _one_by_one(scored: Sequence[Scored], means: Sequence[bool]) -> float:
    """Log density of numbers of which each wrong one is a slip, or anything of its size, and the others as expected."""
    slips = [s for s in scored if s.verdict == "wrong" and s.slip]
    other = [s for s in scored if s.verdict == "wrong" and not s.slip]
    rest = [s for s in scored if s.verdict != "wrong"] + slips
    values = [s.slip.value if s in slips and s.slip else s.true for s in rest]
    anywhere = sum(math.log(max(abs(s.figure.given), s.sigma, 1e-12)) for s in other)
    return (math.log(OTHER_CAUSE) - anywhere if other else 0.0) + max(_explained(rest, values, m)[0] for m in means)


def _explained(scored: Sequence[Scored], values: Sequence[float], by_hand: bool) -> tuple[float, list[float]]:
    """The log density of written numbers given these values, and the fit of each."""
    sigmas = [
        max(s.sigma if by_hand else 0.0, (SHARE / 2 if by_hand else ROUNDED) * max(abs(v), LEAST * abs(s.true)), 1e-12)
        for s, v in zip(scored, values, strict=True)
    ]
    fits = [_fit(_off(s.figure, v) / sigma, v) for s, v, sigma in zip(scored, values, sigmas, strict=True)]
    return sum(fits) - sum(map(math.log, sigmas)), fits


def _fit(off: float, value: float) -> float:
    return max(-0.5 * off**2, -50.0) if math.isfinite(value) else -50.0
