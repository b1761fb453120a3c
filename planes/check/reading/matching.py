"""Finds the marks of a plan on a vector drawing by laying the plan on it."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import combinations
from statistics import median

import numpy

from planes.check.evidence.line_ink import LineInk
from planes.check.explaining import weights as w
from planes.check.explaining.exact_marks import NEAR_MM, exact_marks
from planes.check.explaining.explained import Explanation
from planes.check.explaining.plan_lines import PlanLines
from planes.check.explaining.sought_pole import sought_pole
from planes.check.grading.evidence import ASKED
from planes.check.grading.paper import ReadMark, ReadPaper
from planes.check.grading.prepared_plan import PreparedPlan
from planes.check.reading.construction_lines import vectors_of
from planes.check.reading.force_arrows import force_arrows
from planes.check.reading.parts import NEAR_WORD_MM
from planes.check.reading.strokes import ReadDrawing, headed, hinged
from planes.check.reading.written import Words
from planes.geometry.arrays import Array, Complexes
from planes.words import Phrase
from planes.words.names import POLE, kind_of

MOST = 1200  # lines of a plan with all around it: of 40 sheets of samples the fullest has 907
LEAST_EXPLAINED = 0.5  # minimum share of the lines around a plan that it explains
LEAST_SHOWN = 0.5  # minimum share of a scheme's points with a circle or a name
LEAST_MM = 4.0  # shorter vectors tell little about the scale
SAME, ALIKE = math.log(1.05), math.log(1.15)  # the stated scale, to the accuracy of texts; lengths with a common scale
FAR_POLE = 8.0  # maximum cost of a pole away from its name


def paper_of(sketch: ReadDrawing, bench: PreparedPlan) -> ReadPaper:
    """The marks of a plan found on a sketch."""
    paper, kind = ReadPaper(sketch.file, whole=False), kind_of(bench.asked.plan)
    if not sketch.strokes:
        paper.reason = Phrase("check_no_lines")
    elif len(sketch.strokes) > MOST:
        paper.reason = Phrase("check_crowd", count=len(sketch.strokes))
    if paper.reason:
        return paper
    sketch = replace(sketch, words=[one for text in sketch.words for one in text.listed()])
    if kind == "position":
        sketch = hinged(sketch)
    elif (vectors := vectors_of(sketch, kind == "force")) and not headed(sketch):
        sketch = sketch.only(vectors)
    return force_arrows(sketch, bench) if kind == "force" else _of_marks(LineInk(sketch, bench.names), bench, paper)


def _of_marks(ink: LineInk, bench: PreparedPlan, paper: ReadPaper) -> ReadPaper:
    """The marks of a plan of motion or a scheme."""
    if kind_of(bench.asked.plan) != "position" and (count := ink.crowded):  # a scheme stands among other lines
        paper.reason = Phrase("check_crowd", count=count)
        return paper
    plan = PlanLines(_sized(bench, ink), to_fit=False)
    cells, price = _begun(plan, ink)
    seen = Explanation(plan, ink, sought_pole(plan, ink, cells, price))
    if seen.best.cover < w.LEAST_COVER or not _is_there(seen, ink):
        paper.spots = [*_all_by_names(bench, ink)]
        return paper
    exact = exact_marks(seen, ink, seen.best)
    paper.spots = [exact.get(s.name, s) for s in seen.spots()]
    read = {s.name for s in paper.spots}  # others, whose lines coincide with theirs, may have names beside them
    paper.spots += [one for n, one in exact.items() if n not in read and seen.named_there(n) > w.LIKELY]
    apart = _otherwise(seen, ink)
    paper.untold = [n for n in plan.labels if n in apart]
    paper.spots = [replace(s, doubt=0.0) for s in paper.spots if s.name not in apart or seen.doubt < 1 - ASKED]
    paper.left, paper.signs = seen.faint(), seen.whole_fault()
    paper.named = [n for n in seen.named() if n not in {s.name for s in paper.spots}]
    if plan.kind != "position":
        paper.signs = paper.signs or seen.exchanged()
    paper.pole_told = plan.kind == "position" or ink.headed or bool(_poles(ink))
    return paper


def _is_there(seen: Explanation, ink: LineInk) -> bool:
    """Whether the lines around a plan belong to it, or most points of a scheme have circles or names."""
    if seen.plan.kind != "position":
        return seen.best.cover * seen.explained > LEAST_EXPLAINED
    places = {n: seen.pole + seen.best.places[n] for n in seen.plan.labels}
    shown = [n for n, z in places.items() if seen.named_there(n) or (abs(ink.rounds - z) < NEAR_MM).any()]
    return len(shown) >= LEAST_SHOWN * len(places)


def _poles(ink: LineInk) -> list[Words]:
    """The texts that name the pole."""
    return [one for one in ink.sketch.words if ink.names.meant(one.text) == [POLE]]


def _begun(plan: PlanLines, ink: LineInk) -> tuple[Complexes, Array]:
    """Possible poles of a plan, with their costs by the name of the pole.

    These are line ends, or crossings if no line has a head; for a scheme, poles that put a fixed point there.
    """
    ends = numpy.r_[ink.lines.ravel(), ink.rounds, ink.tips]
    if plan.kind == "position":
        fixed = [plan.true[n] for n in plan.bench.plans.mechanism.frame.points if n in plan.true]
        cells = numpy.unique((ends[:, None] - numpy.array(fixed or [0j])).round(1).ravel())
        return cells, numpy.zeros(len(cells))
    _, first = numpy.unique(ends.round(1), return_index=True)
    cells, names = ends[first], _poles(ink)
    off = numpy.array([min((one.distance(z) for one in names), default=0.0) for z in cells.tolist()])
    return cells, numpy.minimum((off - off.min()) / w.SOFT_MM, FAR_POLE)


def _otherwise(seen: Explanation, ink: LineInk) -> set[str]:
    """Marks with separate lines that lie elsewhere in another drawing that is as likely."""
    plan, own = seen.plan, exact_marks(seen, ink, seen.best)
    others = [one for one in (seen.right, seen.wrong) if one and seen.doubt > w.ASKED and one is not seen.best]
    apart = set[str]()
    likely = (one for one in seen.laid if one.places and seen.best.evidence - one.evidence < w.TELLING)
    for other in (*others, *likely):
        there = {n: other.places[n] + seen.pole for n in plan.labels}
        there |= {n: s.place for n, s in exact_marks(seen, ink, other).items()}
        here = {n: own[n].place if n in own else seen.best.places[n] + seen.pole for n in plan.labels}
        apart |= {n for n in plan.labels if abs(there[n] - here[n]) > w.MOVED_MM}
    return {n for n in apart if all(abs(plan.true[n] - plan.true[m]) > NEAR_MM for m in plan.names if m != n)}


def _sized(bench: PreparedPlan, ink: LineInk) -> PreparedPlan:
    """The plan at the scale shown by most of the named marks, unless given: it is the drawer's choice."""
    ratios = [] if bench.asked.mu else [*_ratios(bench, ink)]
    groups = [[r for r in ratios if abs(r - one) < ALIKE] for one in ratios]
    best = max(groups, key=lambda g: (len(g), -abs(median(g))), default=[])
    ratio = median(best) if len(best) >= max(2, len(ratios) / 2) else 0.0
    return bench if abs(ratio) < SAME else bench.at(bench.said_mu * math.exp(ratio))


def _ratios(bench: PreparedPlan, ink: LineInk) -> Iterator[float]:
    """Logarithms of the ratio of drawn to stated distances: from the pole, in a scheme between its points."""
    truth, places = bench.true_marks | {POLE: 0j}, _by_names(bench, ink)
    if POLE in places or bench.asked.plan == "position":
        for one, two in [(POLE, n) for n in places if n != POLE] if POLE in places else combinations(places, 2):
            true, drawn = abs(truth[one] - truth[two]), abs(places[one] - places[two])
            yield from [math.log(drawn / true)] if min(true, drawn) > LEAST_MM else []


def _by_names(bench: PreparedPlan, ink: LineInk) -> dict[str, complex]:
    """The marks with names beside ends of lines, each at the nearest; where vectors have heads, at a tip."""
    ends, places = numpy.r_[ink.lines.ravel(), ink.rounds], dict[str, complex]()
    for word in ink.words(ink.tips, ink.tips, True, bench.true_marks | {POLE: 0j}).words:
        name = next(iter(word.likely))
        about = ink.tips if ink.headed and name != POLE else ends
        near = min(about.tolist(), key=lambda z: word.off(z, z))
        if word.off(near, near) < NEAR_WORD_MM:
            places.setdefault(name, near)
    return places


def _all_by_names(bench: PreparedPlan, ink: LineInk) -> Iterator[ReadMark]:
    """The marks of a plan that agrees with none of its lines, if vectors lead from its pole to most of their names.

    It may be a plan of other numbers.
    """
    places = _by_names(bench, ink)
    if ink.headed and POLE in places and len(places) > LEAST_SHOWN * len(bench.true_marks) + 1:
        yield from (ReadMark(n, z, ink.sketch.error_mm) for n, z in sorted(places.items(), key=lambda m: m[0] != POLE))


def scaled(
    sketch: ReadDrawing, bench: PreparedPlan, pole: complex | None, marks: Mapping[str, complex]
) -> tuple[ReadDrawing, str | None]:
    """The sketch scaled by a named pole and a named vector; the vector's name."""
    named, place = next(iter(marks.items()), ("", pole))
    name = bench.names.find(named)
    if pole is None or place is None or name is None or place == pole:
        return sketch, None
    factor = abs(bench.true_marks[name]) / abs(place - pole)
    words = [*sketch.words, *(Words(n, z, 0.1 / factor, 0.1 / factor) for n, z in {POLE: pole, **marks}.items())]
    words = [
        replace(one, place=(one.place - pole) * factor, height=one.height * factor, width=one.width * factor)
        for one in words
    ]
    strokes = [((a - pole) * factor, (b - pole) * factor) for a, b in sketch.strokes]
    return ReadDrawing(sketch.file, strokes, words, sketch.error_mm, sketch.ways), name
