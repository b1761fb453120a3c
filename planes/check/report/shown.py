"""Both plans as displayed, each in its position; force polygons, whose order is free, both in the person's order."""

import shlex
from collections.abc import Collection, Sequence
from itertools import accumulate, pairwise

from planes.check.grading.judging import WARNING_SIGMAS
from planes.check.grading.paper import MarkPlaces, ReadMark
from planes.check.grading.polygons import Side, polygon_sides
from planes.check.grading.prepared_plan import Asked, PreparedPlan, known_plans, prepare
from planes.check.outcome import Outcome
from planes.plans.measuring import plan_title, scene_lettering
from planes.words import Lang
from planes.words.frozen import frozen, replace
from planes.words.names import POLE_LABEL, NamePair
from planes.words.naming import Naming
from planes.words.records import Json
from planes.words.units import mu_text

Vector = tuple[complex, complex]


def point_coordinates(z: complex, digits: int = 4) -> list[float]:
    """A point as plain data."""
    return [round(z.real, digits), round(z.imag, digits)]


def vector_end_labels(bench: PreparedPlan) -> list[NamePair]:
    """Vectors of the plan by the labels of their ends; of a scheme, its links."""
    plan = bench.plan
    if plan.is_force:
        return [(s.start, s.end) for s in polygon_sides(bench.plans, plan)]
    drawn = {POLE_LABEL, *(m.label for m in bench.marks)}
    if plan == "position":
        return _scheme_lines(bench, drawn)
    return [pair for pair in bench.vector_names if set(pair) <= drawn]


def _scheme_lines(bench: PreparedPlan, drawn: Collection[str]) -> list[NamePair]:
    """Lines of a scheme: from point to point of a link, and along a link's guide to its slider."""
    mechanism = bench.plans.mechanism
    bars = [p for link in mechanism.links.values() for p in pairwise(n for n in link.points if n in drawn)]
    for link in mechanism.links.values():
        if link.slides and link.slides.guide not in mechanism.frame.guides:
            through = mechanism.guide(link.slides.guide).through_point
            bars += [(through, next(iter(link.points)))] if through else []
    return [pair for pair in dict.fromkeys(bars) if set(pair) <= set(drawn)]


def own_marks(outcome: Outcome) -> MarkPlaces:
    """The person's own marks, mm from the pole."""
    if outcome.grading is None:
        return {}
    taken = outcome.grading.hand.taken
    return {m.label: t.place for m, t in taken.items() if m.plan == outcome.bench.plan}


def true_marks(outcome: Outcome) -> MarkPlaces:
    """The right plan's marks at the drawing's scale, mm from the pole."""
    if outcome.grading is None:
        return outcome.bench.true_marks
    return {m.label: complex(outcome.grading.truth[m]) for m in outcome.grading.marks}


@frozen
class Shown:
    """Both plans as displayed, mm from the pole: vectors, the person's marks, names along vectors."""

    own: list[Vector]
    true: list[Vector]
    marks: MarkPlaces
    along: dict[str, Vector]
    next: list[Vector]  # from each wrong mark to its constructed point


def shown_plans(outcome: Outcome) -> Shown:
    """The person's plan in its position and the right one; force polygons both in the person's order."""
    bench = outcome.bench
    own = own_marks(outcome)
    at_own = {POLE_LABEL: 0j, **own}
    at_true = {POLE_LABEL: 0j, **true_marks(outcome)}
    if not bench.plan.is_force:
        pairs = vector_end_labels(bench)
        drawn = [(at_own[a], at_own[b]) for a, b in pairs if a in at_own and b in at_own]
        return Shown(drawn, [(at_true[a], at_true[b]) for a, b in pairs], own, {}, _correction_vectors(outcome, own))
    sides = polygon_sides(bench.plans, bench.plan)
    order = own_side_order(outcome)
    laid = read_sides(sides, outcome.paper.spots, bench.naming) if order else sides_between_marks(sides, at_own)
    right = sides_laid_in_order(order, at_true) if order else sides_between_marks(sides, at_true)
    ends = {s.end: end for s, (_, end) in reversed(laid)}  # each at the end of the first side that leads to it
    marks = {s.end: ends[s.end] for s, _ in laid if s.end in own}
    along = {s.name: v for s, v in laid}
    return Shown([v for _, v in laid], [v for _, v in right], marks, along, _correction_vectors(outcome, marks))


def _correction_vectors(outcome: Outcome, shown: MarkPlaces) -> list[Vector]:
    """From each wrong mark, as displayed, to the point constructed from the person's own marks."""
    if outcome.grading is None:
        return []
    verdicts = outcome.grading.verdicts
    judged = outcome.grading.judgement
    off = {m: miss for m, miss in judged.misses.items() if miss.sigmas > WARNING_SIGMAS}
    rows = [(m.label, miss.off) for m, miss in off.items() if verdicts[m] != "right" or miss.sigmas <= judged.limit]
    return [(shown[n], shown[n] - by) for n, by in rows if n in shown]


def own_side_order(outcome: Outcome) -> list[Side]:
    """A force polygon's sides in the person's order, missing ones last; none where the pen was lifted."""
    bench = outcome.bench
    grading = outcome.grading
    if not bench.plan.is_force or grading is None or grading.rebuilt is None:
        return []
    sides = {s.name: s for s in polygon_sides(bench.plans, bench.plan)}
    first, *read = map(bench.naming.name_finder(sides).find_name, (spot.name for spot in outcome.paper.spots))
    if POLE_LABEL in read or first != POLE_LABEL:
        return []
    missing = (s.name for s in sides.values() if s.end in grading.rebuilt.absent)
    return [sides[n] for n in dict.fromkeys([*read, *missing]) if n in sides]


LaidSides = list[tuple[Side, Vector]]  # their positions, mm from the pole


def read_sides(sides: Sequence[Side], spots: Sequence[ReadMark], naming: Naming) -> LaidSides:
    """The vectors as read."""
    by_name = {s.name: s for s in sides}
    names = naming.name_finder(by_name)
    pole = spots[0].place
    rows = [(names.find_name(b.name), (a.place - pole, b.place - pole)) for a, b in pairwise(spots)]
    return [(by_name[name], v) for name, v in rows if name in by_name]


def sides_laid_in_order(order: Sequence[Side], places: MarkPlaces) -> LaidSides:
    """The sides of another drawing of the polygon, by its marks, laid in that order."""
    laid = sides_between_marks(order, places)
    ends = accumulate((b - a for _, (a, b) in laid), initial=0j)
    return [(side, way) for (side, _), way in zip(laid, pairwise(ends), strict=True)]


def sides_between_marks(sides: Sequence[Side], places: MarkPlaces) -> LaidSides:
    """The sides between their marks."""
    return [(s, (places[s.start], places[s.end])) for s in sides if s.start in places and s.end in places]


def tracing_data(asked: Asked, lang: Lang) -> Json:
    """All plans of a scene, the requested one first, mm from their poles."""
    bench = prepare(asked)
    others = [p for p in known_plans(bench.plans) if p != asked.plan]
    benches = [bench, *(prepare(replace(asked, plan=p, mu=None)) for p in others)]
    scene = asked.scene
    return {
        "title": scene.title.get(lang, "") or scene.file,
        "lettering": scene_lettering(scene, bench.plans),
        "plans": [_plan_data(b, lang) for b in benches],
    }


def _plan_data(bench: PreparedPlan, lang: Lang) -> Json:
    plan = bench.plan
    marks = bench.true_marks
    mu = mu_text(bench.said_mu, bench.kind, lang, bench.asked.scene.mu_convention)
    line = shlex.join(bench.asked.command_words("⟦file⟧")).replace("'⟦file⟧'", "⟦file⟧")
    names = [(s.name, s.start, s.end) for s in polygon_sides(bench.plans, plan)] if bench.plan.is_force else []
    return {
        "key": plan,
        "kind": bench.kind,
        "title": f"{plan_title(plan, lang)}, μ = {mu}",
        "marks": {POLE_LABEL: [0.0, 0.0], **{n: point_coordinates(z) for n, z in marks.items()}},
        "far": max(marks, key=lambda n: abs(marks[n])),
        "vectors": vector_end_labels(bench),
        "names": names,
        "command": f"{line} --pole ⟦pole⟧ --mark ⟦mark⟧",  # the page inserts the picture and two points
    }
