"""Numbers a person wrote down, lengths of segments or results, against what the plans, mistakes and slips give."""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import permutations

from planes.check.grading.evidence import chance_off
from planes.check.grading.handwork import Hand, Variant
from planes.check.grading.judging import MARGIN
from planes.check.grading.prepared_plan import PreparedPlan
from planes.drafting.steps import LayOff
from planes.drafting.steps.reckoning import Calculate, Measure
from planes.geometry.arithmetic import Arithmetic, Real
from planes.plans.quantities import Quantity
from planes.words import Phrase, Written
from planes.words.names import POLE, Names, at, end_of, label_of, letter_of, mu_of, plan_of
from planes.words.units import unit_factor

LIKELY = -4.5  # the logarithm of how unlikely a number 3σ off is
SHARE = 0.03  # a number within 3 % is right, however steady the hand
Things = Mapping[str, Real]


@dataclass(frozen=True)
class WrittenNumber:
    """One number: as written (SI or mm), and how it is read off a drawing (an array over the errors' columns)."""

    name: str
    given: float
    read: Callable[[Things], Real]
    signed: bool = False
    plan: str = ""
    value: str = ""  # the program's name of it, if it has one


@dataclass
class Scored:
    """A figure judged: true value, its standard deviation, right, wrong or follows, and a close call or not."""

    figure: WrittenNumber
    true: float
    sigma: float
    verdict: str
    close: bool = False
    mine: float | None = None  # what the person's own drawing gives
    slip: str | None = None  # the slip of reckoning that gives the number

    @property
    def chance_wrong(self) -> float:
        """How likely it is that the number is wrong, and not only badly measured."""
        sigma = max(self.sigma, SHARE * abs(self.true) / 3)
        return 1.0 if self.slip else chance_off(_off(self.figure, self.true), sigma, abs(self.true))


@dataclass
class Account:
    """All figures of a table judged."""

    scored: list[Scored] = field(default_factory=list)
    lengths: bool = False  # of the drawing, not results
    named: Variant | None = None
    runner_up: str | None = None

    @property
    def first(self) -> Scored | None:
        """The first figure that is not right."""
        return next((s for s in self.scored if s.verdict == "wrong"), None)

    @property
    def first_wrong(self) -> str | None:
        """Its name, or the mark a mistake known by its lengths is made at."""
        if self.named and self.lengths:
            return self.named.blames
        return self.first.figure.name if self.first else None

    @property
    def fault(self) -> Phrase | None:
        """What goes wrong first and how to mend it."""
        if self.named or not (s := self.first):
            return self.named.sentence if self.named else None
        if s.slip:
            return Phrase(f"mistake_{s.slip}", mark=s.figure.name)
        given, true = Written(f"{s.figure.given:.4g}"), Written(f"{s.true:.4g}")
        return Phrase("check_number_unclear", mark=s.figure.name, given=given, true=true)


Figures = tuple[list[WrittenNumber], list[str]]  # those of a table, and the names that mean nothing here


def result_figures(known: Mapping[str, Quantity], written: Iterable[tuple[str, float, str]]) -> Figures:
    """Figures of a table of results."""
    names = Names(known, poles=False)
    read = [(names.find(text), text, value * unit_factor(unit)) for text, value, unit in written]
    return [_figure(n, known[n], value) for n, _, value in read if n], [text for n, text, _ in read if not n]


def _figure(name: str, q: Quantity, value: float) -> WrittenNumber:
    """How a quantity of the catalogue is read off a drawing."""
    one = q.whole
    plan = plan_of(one.end) if one.part else {"omega": "velocity", "epsilon": "acceleration"}.get(q.key, "")
    return WrittenNumber(name, value, lambda things: one.take(things, Arithmetic()), not one.part, plan, one.value)


def segment_figures(bench: PreparedPlan, written: Iterable[tuple[str, float]]) -> Figures:
    """Figures of a table of segments ("pb", "bc"; of a force plan also "G_2")."""
    plan, labels = bench.asked.plan, [label_of(m) for m in bench.marks]
    ends = [n for n in (POLE, *labels) if at(plan, n) in bench.program.made]  # a scheme has no pole
    pairs = {one + two: (one, two) for one, two in permutations(ends, 2)}
    for s in bench.plans.segments:
        if s.plan == plan and s.start != s.end and {s.start, s.end} <= set(ends):
            pairs.setdefault(end_of(s.name), (s.start, s.end))
    spelt = {one + two: bench.names.spelt(one) + bench.names.spelt(two) for one, two in permutations(ends, 2)}
    names = Names(pairs, poles=False, spelt=lambda pair: spelt.get(pair, pair))
    read = [(names.find(text), text, mm) for text, mm in written]
    found = [WrittenNumber(n, mm, _millimetres(plan, *pairs[n]), False, plan) for n, _, mm in read if n]
    return found, [text for n, text, _ in read if not n]


def _millimetres(plan: str, start: str, end: str) -> Callable[[Things], Real]:
    return lambda things: abs(things[at(plan, end)] - things[at(plan, start)])


def account(
    figures: Sequence[WrittenNumber], free: Hand, own: Hand | None, variants: Iterable[Variant], ruler_mm: float = 0.0
) -> Account:
    """Judge figures against the true plan; name the mistake of the first wrong one."""
    found = Account([_judged(f, free, own, ruler_mm) for f in figures], ruler_mm > 0)
    for s in found.scored:
        if s.verdict == "wrong":
            s.slip = number_mistake(s, free)
            if s.slip is None and own is not None and s.mine:  # a slip made with the person's own segments
                s.slip = number_mistake(replace(s, true=s.mine), own)
    if found.first and found.first.slip is None:
        _name(found, free, variants)
    return found


def _judged(f: WrittenNumber, free: Hand, own: Hand | None, ruler_mm: float) -> Scored:
    read = f.read(free.things)
    true, sigma = first_of(read), math.hypot(free.spread_of(read), _ruler(f, free, ruler_mm))
    off = _off(f, true)
    if off <= max(3 * sigma, SHARE * abs(true)) + 1e-9 * abs(true):
        return Scored(f, true, sigma, "right", off > max(2 * sigma, SHARE * abs(true)))
    if own is None:
        return Scored(f, true, sigma, "wrong")
    mine = first_of(f.read(own.things))
    follows = _off(f, mine) <= max(3 * own.spread_of(f.read(own.things)), SHARE * abs(mine))
    return Scored(f, true, sigma, "follows" if follows else "wrong", mine=mine)


def _ruler(f: WrittenNumber, free: Hand, ruler_mm: float) -> float:
    """The error of reading the segment itself: in mm of a segment, in SI of a result measured on a plan."""
    if ruler_mm or f.value:
        return ruler_mm
    mu = _number(free, mu_of(f.plan)) if f.plan else 0.0
    return free.tool.skill.ruler_mm / mu if mu else 0.0


def _off(f: WrittenNumber, true: float) -> float:
    return abs(f.given - true) if f.signed else abs(abs(f.given) - abs(true))


def _name(found: Account, free: Hand, variants: Iterable[Variant]) -> None:
    """The mistake in a plan that gives all the numbers as they are written; what it explains beyond the first wrong
    figure follows from it."""
    best: dict[str, tuple[float, Variant, list[float]]] = {}
    for variant in variants:
        things = {**free.things, **variant.givens, **free.under(variant)}
        fits = [_fit(s, first_of(s.figure.read(things))) for s in found.scored]
        score = sum(fits) + math.log(variant.weight)
        if score > best.get(variant.mistake, (-math.inf,))[0]:
            best[variant.mistake] = score, variant, fits
    ranked = sorted(best.values(), key=lambda b: -b[0])
    if not ranked:
        return
    (score, variant, fits), first = ranked[0], found.first
    second = ranked[1][0] if len(ranked) > 1 else -math.inf
    if score > LIKELY * len(found.scored) and score - second >= MARGIN:
        found.named = variant
        for s, fit in zip(found.scored, fits, strict=True):
            if s.verdict == "wrong" and s is not first and fit > LIKELY:
                s.verdict = "follows"
    found.runner_up = ranked[1][1].mistake if len(ranked) > 1 and found.named else variant.mistake


def _fit(s: Scored, value: float) -> float:
    sigma = max(s.sigma, SHARE / 2 * abs(value), 1e-12)
    return max(-0.5 * (_off(s.figure, value) / sigma) ** 2, -50.0) if math.isfinite(value) else -50.0


def number_mistake(s: Scored, free: Hand) -> str | None:
    """Slips of reckoning that leave the drawing as it is."""
    f, true = s.figure, s.true
    if not true or not f.given:
        return None
    if f.signed and _near(f.given, -true, s):
        return "sense_wrong"
    for mistake, value in _slips(f, true, free):
        if value and _near(abs(f.given), abs(value), s):
            return mistake
    return None


def _near(given: float, wanted: float, s: Scored) -> bool:
    share = max(SHARE, 3 * s.sigma / abs(s.true))
    return abs(given - wanted) <= min(share, 0.25) * abs(wanted)


def _slips(f: WrittenNumber, true: float, free: Hand) -> Iterable[tuple[str, float]]:
    """Each slip with the number it gives."""
    mu = _number(free, mu_of(f.plan)) if f.plan else 0.0
    if mu and not f.value:
        yield "mm_for_value", true * mu
        yield "mu_inverted", true * mu * mu
        yield "mu_inverted", true / (mu * mu)
    if letter_of(f.value) in ("omega", "epsilon"):
        scheme = _number(free, mu_of("position"))
        for factor in (1 / scheme if scheme else 0.0, mu / scheme if scheme else 0.0, 1e-3):
            yield "omega_without_mu_l", true * factor
        if mu:
            yield "mu_inverted", true * mu * mu
    if letter_of(f.value) == "epsilon":
        yield "epsilon_from_total", _from_total(f.value, free)


def _number(free: Hand, name: str) -> float:
    """A value of a drawing; 0 where it has none of the name."""
    return float(free.number(name)) if name in free.things else 0.0


def _from_total(name: str, free: Hand) -> float:
    """ε from the whole relative acceleration instead of its tangential part."""
    steps = free.program.makers
    step = steps.get(name)
    for value, power in step.terms[0].factors if isinstance(step, Calculate) else ():
        part = steps.get(value)
        normal = steps.get(part.start) if power == 1 and isinstance(part, Measure) else None
        if isinstance(part, Measure) and isinstance(normal, LayOff) and part.mu in free.things:
            whole = abs(free.number(part.end) - free.number(normal.start)) / abs(_number(free, part.mu))
            tangential = abs(_number(free, value))
            return float(abs(_number(free, name)) * whole / tangential) if tangential else 0.0
    return 0.0


def first_of(value: Real) -> float:
    """A value without the columns of its errors."""
    return float(value[0] if getattr(value, "shape", None) else value)
