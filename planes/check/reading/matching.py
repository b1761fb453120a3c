"""Finds the marks of a plan on a vector drawing by laying the plan on it."""

import math
from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations
from statistics import median

import numpy

from planes.check.evidence.line_ink import LineInk
from planes.check.explaining import weights as w
from planes.check.explaining.exact_marks import MARK_SEARCH_RADIUS_MM, exact_marks
from planes.check.explaining.explained import Explanation
from planes.check.explaining.plan_lines import PlanLines
from planes.check.explaining.sought_pole import likeliest_pole
from planes.check.grading.evidence import LEAST_UNASKED_PROBABILITY
from planes.check.grading.paper import MarkPlaces, ReadMark, ReadPaper
from planes.check.grading.prepared_plan import PreparedPlan
from planes.check.reading.construction_lines import vector_strokes
from planes.check.reading.force_arrows import read_force_arrows
from planes.check.reading.parts import MOST_PART_TO_WORD_MM
from planes.check.reading.strokes import ReadDrawing, extend_strokes_to_hinges, strokes_with_heads
from planes.check.reading.written import Words
from planes.geometry.arrays import Array, Complexes
from planes.words import Phrase
from planes.words.names import POLE_LABEL

MOST_LINES_AROUND_PLAN = 1200  # lines of a plan with all around it: of 40 sheets of samples the fullest has 907
LEAST_EXPLAINED_SHARE = 0.5  # minimum share of the lines around a plan that it explains
LEAST_SHOWN_POINT_SHARE = 0.5  # minimum share of a scheme's points with a circle or a name
SHORTEST_SCALE_VECTOR_MM = 4.0  # shorter vectors tell little about the scale
# the stated scale, to the accuracy of texts; lengths with a common scale
SAME_SCALE_LOG_RATIO = math.log(1.05)
COMMON_SCALE_LOG_RATIO = math.log(1.15)
MOST_FAR_POLE_COST = 8.0  # maximum cost of a pole away from its name


def read_plan_marks(sketch: ReadDrawing, bench: PreparedPlan) -> ReadPaper:
    """The marks of a plan found on a sketch."""
    paper = ReadPaper(sketch.file, whole=False)
    kind = bench.kind
    if not sketch.strokes:
        paper.reason = Phrase("check_no_lines")
    elif len(sketch.strokes) > MOST_LINES_AROUND_PLAN:
        paper.reason = Phrase("check_crowd", count=len(sketch.strokes))
    if paper.reason:
        return paper
    sketch = replace(sketch, words=[one for text in sketch.words for one in text.split_names()])
    if kind == "position":
        sketch = extend_strokes_to_hinges(sketch)
    elif (vectors := vector_strokes(sketch, kind == "force")) and not strokes_with_heads(sketch):
        sketch = sketch.with_some_strokes(vectors)
    if kind == "force":
        return read_force_arrows(sketch, bench)
    return _read_motion_or_scheme(LineInk(sketch, bench.written_mark_names), bench, paper)


def _read_motion_or_scheme(ink: LineInk, bench: PreparedPlan, paper: ReadPaper) -> ReadPaper:
    """The marks of a plan of motion or a scheme."""
    if bench.kind != "position" and (count := ink.crowded_end_count):  # a scheme stands among other lines
        paper.reason = Phrase("check_crowd", count=count)
        return paper
    plan = PlanLines(_plan_at_named_scale(bench, ink), to_fit=False)
    cells, price = _possible_poles(plan, ink)
    seen = Explanation(plan, ink, likeliest_pole(plan, ink, cells, price))
    if seen.likeliest_drawing.cover < w.LEAST_COVER or not _is_plan_there(seen, ink):
        paper.spots = [*_marks_by_names_only(bench, ink)]
        return paper
    exact = exact_marks(seen, ink, seen.likeliest_drawing)
    paper.spots = [exact.get(s.name, s) for s in seen.seen_marks()]
    read = {s.name for s in paper.spots}  # others, whose lines coincide with theirs, may have names beside them
    paper.spots += [one for n, one in exact.items() if n not in read and seen.named_there(n) > w.LEAST_NAME_CERTAINTY]
    apart = _ambiguous_marks(seen, ink)
    paper.untold = [n for n in plan.labels if n in apart]
    paper.spots = [
        replace(s, doubt=0.0)
        for s in paper.spots
        if s.name not in apart or seen.chance_of_other_drawing < 1 - LEAST_UNASKED_PROBABILITY
    ]
    paper.left, paper.signs = seen.faint_vectors(), seen.transformed_plan_faults()
    paper.named = [n for n in seen.marks_seen_by_name_only() if n not in {s.name for s in paper.spots}]
    if plan.kind != "position":
        paper.signs = paper.signs or seen.swapped_letter_faults()
    paper.pole_told = plan.kind == "position" or ink.headed or bool(_poles(ink))
    return paper


def _is_plan_there(seen: Explanation, ink: LineInk) -> bool:
    """Whether the lines around a plan belong to it, or most points of a scheme have circles or names."""
    if seen.plan.kind != "position":
        return seen.likeliest_drawing.cover * seen.explained_ink_share > LEAST_EXPLAINED_SHARE
    places = {n: seen.pole + seen.likeliest_drawing.places[n] for n in seen.plan.labels}
    shown = [n for n, z in places.items() if seen.named_there(n) or (abs(ink.rounds - z) < MARK_SEARCH_RADIUS_MM).any()]
    return len(shown) >= LEAST_SHOWN_POINT_SHARE * len(places)


def _poles(ink: LineInk) -> list[Words]:
    """The texts that name the pole."""
    return [one for one in ink.sketch.words if ink.names.possible_names(one.text) == [POLE_LABEL]]


def _possible_poles(plan: PlanLines, ink: LineInk) -> tuple[Complexes, Array]:
    """Possible poles of a plan, with their costs by the name of the pole.

    These are line ends, or crossings if no line has a head; for a scheme, poles that put a fixed point there.
    """
    ends = numpy.r_[ink.lines.ravel(), ink.rounds, ink.tips]
    if plan.kind == "position":
        fixed = [plan.true[n] for n in plan.bench.plans.mechanism.frame.points if n in plan.true]
        cells = numpy.unique((ends[:, None] - numpy.array(fixed or [0j])).round(1).ravel())
        return cells, numpy.zeros(len(cells))
    _, first = numpy.unique(ends.round(1), return_index=True)
    cells = ends[first]
    names = _poles(ink)
    off = numpy.array([min((one.distance(z) for one in names), default=0.0) for z in cells.tolist()])
    return cells, numpy.minimum((off - off.min()) / w.NEARER_NAME_MARGIN_MM, MOST_FAR_POLE_COST)


def _ambiguous_marks(seen: Explanation, ink: LineInk) -> set[str]:
    """Marks with separate lines that lie elsewhere in another drawing that is as likely."""
    plan = seen.plan
    own = exact_marks(seen, ink, seen.likeliest_drawing)
    others = [
        one
        for one in (seen.right_drawing, seen.wrong_drawing)
        if one and seen.chance_of_other_drawing > w.LEAST_SERIOUS_DOUBT and one is not seen.likeliest_drawing
    ]
    apart = set()
    likely = (
        one
        for one in seen.laid
        if one.places
        and seen.likeliest_drawing.score_without_mistake - one.score_without_mistake < w.LEAST_EVIDENCE_GAP
    )
    for other in (*others, *likely):
        there = {n: other.places[n] + seen.pole for n in plan.labels}
        there |= {n: s.place for n, s in exact_marks(seen, ink, other).items()}
        here = {n: own[n].place if n in own else seen.likeliest_drawing.places[n] + seen.pole for n in plan.labels}
        apart |= {n for n in plan.labels if abs(there[n] - here[n]) > w.LEAST_MISTAKE_SHIFT_MM}
    return {
        n for n in apart if all(abs(plan.true[n] - plan.true[m]) > MARK_SEARCH_RADIUS_MM for m in plan.names if m != n)
    }


def _plan_at_named_scale(bench: PreparedPlan, ink: LineInk) -> PreparedPlan:
    """The plan at the scale shown by most of the named marks, unless given: it is the drawer's choice."""
    ratios = [] if bench.asked.mu else [*_log_scale_ratios(bench, ink)]
    groups = [[r for r in ratios if abs(r - one) < COMMON_SCALE_LOG_RATIO] for one in ratios]
    best = max(groups, key=lambda g: (len(g), -abs(median(g))), default=[])
    ratio = median(best) if len(best) >= max(2, len(ratios) / 2) else 0.0
    if abs(ratio) < SAME_SCALE_LOG_RATIO:
        return bench
    return bench.at_scale(bench.said_mu * math.exp(ratio), fixed=False)


def _log_scale_ratios(bench: PreparedPlan, ink: LineInk) -> Iterator[float]:
    """Logarithms of the ratio of drawn to stated distances: from the pole, in a scheme between its points."""
    truth = bench.true_marks | {POLE_LABEL: 0j}
    places = _mark_places_by_names(bench, ink)
    if POLE_LABEL in places or bench.plan == "position":
        for one, two in (
            [(POLE_LABEL, n) for n in places if n != POLE_LABEL] if POLE_LABEL in places else combinations(places, 2)
        ):
            true = abs(truth[one] - truth[two])
            drawn = abs(places[one] - places[two])
            yield from [math.log(drawn / true)] if min(true, drawn) > SHORTEST_SCALE_VECTOR_MM else []


def _mark_places_by_names(bench: PreparedPlan, ink: LineInk) -> MarkPlaces:
    """The marks with names beside ends of lines, each at the nearest; where vectors have heads, at a tip."""
    ends = numpy.r_[ink.lines.ravel(), ink.rounds]
    places = MarkPlaces()
    for word in ink.read_words(ink.tips, ink.tips, True, bench.true_marks | {POLE_LABEL: 0j}).words:
        name = next(iter(word.likely))
        about = ink.tips if ink.headed and name != POLE_LABEL else ends
        near = min(about.tolist(), key=lambda z: word.distance_to_segment(z, z))
        if word.distance_to_segment(near, near) < MOST_PART_TO_WORD_MM:
            places.setdefault(name, near)
    return places


def _marks_by_names_only(bench: PreparedPlan, ink: LineInk) -> Iterator[ReadMark]:
    """The marks of a plan that agrees with none of its lines, if vectors lead from its pole to most of their names.

    It may be a plan of other numbers.
    """
    places = _mark_places_by_names(bench, ink)
    if ink.headed and POLE_LABEL in places and len(places) > LEAST_SHOWN_POINT_SHARE * len(bench.true_marks) + 1:
        yield from (
            ReadMark(n, z, ink.sketch.error_mm) for n, z in sorted(places.items(), key=lambda m: m[0] != POLE_LABEL)
        )


def scale_sketch(
    sketch: ReadDrawing, bench: PreparedPlan, pole: complex | None, marks: MarkPlaces
) -> tuple[ReadDrawing, str | None]:
    """The sketch scaled by a named pole and a named vector; the vector's name."""
    named, place = next(iter(marks.items()), ("", pole))
    name = bench.written_mark_names.find_name(named)
    if pole is None or place is None or name is None or place == pole:
        return sketch, None
    factor = abs(bench.true_marks[name]) / abs(place - pole)
    words = [*sketch.words, *(Words(n, z, 0.1 / factor, 0.1 / factor) for n, z in {POLE_LABEL: pole, **marks}.items())]
    words = [
        replace(one, place=(one.place - pole) * factor, height=one.height * factor, width=one.width * factor)
        for one in words
    ]
    strokes = [((a - pole) * factor, (b - pole) * factor) for a, b in sketch.strokes]
    return ReadDrawing(sketch.file, strokes, words, sketch.error_mm, sketch.ways), name
