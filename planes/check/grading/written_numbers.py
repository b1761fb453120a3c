"""Numbers a person wrote down, lengths of segments or results, against what the plans give and what mistakes give."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import permutations

from planes.check.grading.arithmetic_slips import SHARE, Scored, Things, WrittenNumber, first_of, number_mistake
from planes.check.grading.handwork import Hand, Variant
from planes.check.grading.judging import MARGIN
from planes.check.grading.prepared_plan import PreparedPlan
from planes.geometry.arithmetic import One, Real
from planes.plans import Plans
from planes.plans.quantities import Quantity
from planes.words.names import POLE, at, label_of, mu_of, plan_of
from planes.words.spelling import Names


@dataclass
class Account:
    """All figures of a table judged."""

    scored: list[Scored] = field(default_factory=list)
    named: Variant | None = None
    number_mistake: str | None = None
    runner_up: str | None = None

    @property
    def first_wrong(self) -> Scored | None:
        """The first figure that is not right."""
        return next((s for s in self.scored if s.verdict == "wrong"), None)


def result_figures(
    known: Mapping[str, Quantity], written: Iterable[tuple[str, float, str]]
) -> tuple[list[WrittenNumber], list[str]]:
    """Figures of a table of results, and the names that mean nothing here."""
    names, found, unknown = Names(known, poles=False), [], []
    for text, value, unit in written:
        name = names.find(text)
        if name is None:
            unknown.append(text)
            continue
        found.append(_figure(name, known[name], value * unit_factor(unit)))
    return found, unknown


def _figure(name: str, q: Quantity, value: float) -> WrittenNumber:
    """How a quantity of the catalogue is read off a drawing."""
    one = q.whole
    plan = plan_of(one.end) if one.part else {"omega": "velocity", "epsilon": "acceleration"}.get(q.key, "")
    return WrittenNumber(name, value, lambda things: one.take(things, One()), not one.part, plan, one.value)


def segment_figures(bench: PreparedPlan, written: Iterable[tuple[str, float]]) -> tuple[list[WrittenNumber], list[str]]:
    """Figures of a table of segments ("pb", "bc"; of a force plan also "G_2"), and the names that mean nothing."""
    plan, labels = bench.asked.plan, [label_of(m) for m in bench.marks]
    ends = [n for n in (POLE, *labels) if at(plan, n) in bench.program.made]  # a scheme has no pole
    pairs = {one + two: (one, two) for one, two in permutations(ends, 2)}
    for s in bench.plans.segments:
        if s.plan == plan and s.start != s.end and {s.start, s.end} <= set(ends):
            pairs.setdefault(s.name.replace("^", ""), (s.start, s.end))
    spelt = {one + two: bench.names.spelt(one) + bench.names.spelt(two) for one, two in permutations(ends, 2)}
    names, found, unknown = Names(pairs, poles=False, spelt=lambda pair: spelt.get(pair, pair)), [], []
    for text, mm in written:
        name = names.find(text)
        if name is None:
            unknown.append(text)
        else:
            found.append(WrittenNumber(name, mm, _millimetres(plan, *pairs[name]), False, plan))
    return found, unknown


def _millimetres(plan: str, start: str, end: str) -> Callable[[Things], Real]:
    return lambda things: abs(things[at(plan, end)] - things[at(plan, start)])


def unit_factor(unit: str) -> float:
    """SI per unit as written: mm/s, kN, rpm."""
    text = unit.strip().lower().replace(" ", "")
    for starts, factor in ((("мм", "mm"), 1e-3), (("см", "cm"), 1e-2), (("кн", "kn"), 1e3)):
        if text.startswith(starts) and text not in ("мм", "mm"):
            return factor
    return math.pi / 30 if text in ("об/мин", "rpm") else 1.0


def account(
    figures: Sequence[WrittenNumber],
    free: Hand,
    own: Hand | None,
    variants: Iterable[Variant],
    plans: Plans,
    ruler_mm: float = 0.0,
) -> Account:
    """Judge figures against the true plan; name the mistake of the first wrong one."""
    found = Account([_judged(f, free, own, ruler_mm) for f in figures])
    for s in found.scored:
        if s.verdict == "wrong":
            s.slip = number_mistake(s, free, plans)
            if s.slip is None and own is not None and s.mine:  # a slip made with the person's own segments
                s.slip = number_mistake(replace(s, true=s.mine), own, plans)
    first = found.first_wrong
    if first is None:
        return found
    found.number_mistake = first.slip
    if found.number_mistake is None:
        _name(found, free, variants)
    return found


def _judged(f: WrittenNumber, free: Hand, own: Hand | None, ruler_mm: float) -> Scored:
    true = first_of(f.read(free.things))
    sigma = math.hypot(free.spread_of(f.read(free.things)), _ruler(f, free, ruler_mm))
    off = _off(f, true)
    if off <= max(3 * sigma, SHARE * abs(true)) + 1e-9 * abs(true):
        return Scored(f, true, sigma, "right", off > max(2 * sigma, SHARE * abs(true)))
    mine = None
    if own is not None:
        mine = first_of(f.read(own.things))
        if _off(f, mine) <= max(3 * own.spread_of(f.read(own.things)), SHARE * abs(mine)):
            return Scored(f, true, sigma, "follows", mine=mine)
    return Scored(f, true, sigma, "wrong", mine=mine)


def _ruler(f: WrittenNumber, free: Hand, ruler_mm: float) -> float:
    """The error of reading the segment itself: in mm of a segment, in SI of a result measured on a plan."""
    if ruler_mm:
        return ruler_mm
    mu = mu_of(f.plan)
    if f.value or not f.plan or mu not in free.things:
        return 0.0
    return float(free.tool.skill.ruler_mm / free.number(mu))


def _off(f: WrittenNumber, true: float) -> float:
    return abs(f.given - true) if f.signed else abs(abs(f.given) - abs(true))


def _name(found: Account, free: Hand, variants: Iterable[Variant]) -> None:
    """The mistake in a plan that gives all the numbers as they are written."""
    best: dict[str, tuple[float, Variant]] = {}
    for variant in variants:
        things = {**free.things, **variant.givens, **free.under(variant)}
        score = sum(_fit(s, first_of(s.figure.read(things))) for s in found.scored) + math.log(variant.weight)
        if score > best.get(variant.mistake, (-math.inf, variant))[0]:
            best[variant.mistake] = score, variant
    ranked = sorted(best.values(), key=lambda b: -b[0])
    if not ranked:
        return
    second = ranked[1][0] if len(ranked) > 1 else -math.inf
    if ranked[0][0] > -4.5 * len(found.scored) and ranked[0][0] - second >= MARGIN:
        found.named = ranked[0][1]
        _follow(found, free)
    found.runner_up = ranked[1][1].mistake if len(ranked) > 1 and found.named else ranked[0][1].mistake


def _fit(s: Scored, value: float) -> float:
    sigma = max(s.sigma, SHARE / 2 * abs(value), 1e-12)
    return max(-0.5 * (_off(s.figure, value) / sigma) ** 2, -50.0) if math.isfinite(value) else -50.0


def _follow(found: Account, free: Hand) -> None:
    """What the named mistake explains beyond the first wrong figure follows from it."""
    assert found.named
    things = {**free.things, **found.named.givens, **free.under(found.named)}
    first = found.first_wrong
    for s in found.scored:
        value = first_of(s.figure.read(things))
        if s.verdict == "wrong" and s is not first and _fit(s, value) > -4.5:
            s.verdict = "follows"
