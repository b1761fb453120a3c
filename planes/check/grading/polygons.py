"""Aligns a paper's marks with a plan: by label, from the pole; a force polygon in the order of the program.

The order of a polygon is free, so each vector is taken by its name, and the marks of the program's polygon are rebuilt
from the person's vectors. The remainder when all of them are laid end to end is the closing error.
"""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise

from planes.check.grading.paper import MarkPlaces, ReadMark, ReadMarks, ReadPaper, TakenMarks
from planes.check.grading.prepared_plan import PreparedPlan, mark_names
from planes.check.grading.remedies import phrase_for_reader, phrase_with_remedy
from planes.drafting.steps import LayOff
from planes.plans import Plans
from planes.words import Phrase
from planes.words.errors import PlanesError
from planes.words.frozen import frozen
from planes.words.names import POLE_LABEL, PlanId, vector_end_label
from planes.words.naming import Naming

# collinear: tangent of the angle; relative length of a vector that hides another
COLLINEAR_TANGENT = 0.05
HIDING_LENGTH_RATIO = 0.9
SHORTEST_SEEN_VECTOR_MM = 3.0  # a shorter vector may be invisible
NO_VECTOR = ReadMark("", 0j, 0.0)


@frozen
class Side:
    """A vector of a force plan: its name, and the labels of the program's marks at its ends."""

    name: str
    start: str
    end: str


@dataclass
class Rebuilt:
    """Marks of the program's polygon by label, and its closing errors."""

    unknown: list[str]
    vectors: list[ReadMark]  # as read
    closers: set[str]  # those of free length
    left: list[Side]  # not read, though they may be there
    polygons: Sequence[Collection[str]]  # the vectors of each
    spots: ReadMarks = field(default_factory=dict)
    gap: ReadMark | None = None
    closing: str = ""
    absent: set[str] = field(default_factory=set)  # known forces that are missing

    def may_be_confused_vectors(self, missing: complex | None) -> bool:
        """Whether vectors identified by likeness, as in a picture, may as well be others.

        That is so where no mistake explains them, or the ``missing`` one may be invisible or hidden in one as long.
        """
        if not any(v.doubt for v in self.vectors):
            return False
        if missing is not None and abs(missing) <= SHORTEST_SEEN_VECTOR_MM:
            return True
        over = (v.place / missing for v in self.vectors if missing and v.name in self.closers)
        return missing is None or any(
            z.real > HIDING_LENGTH_RATIO and abs(z.imag) < COLLINEAR_TANGENT * z.real for z in over
        )

    def unseen_long_vectors(self, places: MarkPlaces) -> list[str]:
        """Unseen vectors that should be long, by the true ``places``.

        A closing vector does not count where only short ones of its polygon are unseen.
        """
        long = {s.name: abs(places[s.end] - places[s.start]) for s in self.left}
        seen = any(sum(long.get(n, 0.0) for n in polygon) <= SHORTEST_SEEN_VECTOR_MM for polygon in self.polygons)
        return [n for n, mm in long.items() if mm > SHORTEST_SEEN_VECTOR_MM and not (seen and n in self.closers)]


def polygon_sides(plans: Plans, plan: PlanId) -> list[Side]:
    """All vectors of a force plan as drawn by the program, the closing ones last."""
    sides: dict[str, Side] = {}
    terms = (t for e in plans.equations if e.plan == plan for t in e.all_terms)
    for t in (t for t in terms if not {*plan.marks(t.start, t.end)} & plans.auxiliary_marks):
        name = vector_end_label(t.name)
        ends = (t.start, t.end) if t.sign > 0 else (t.end, t.start)
        sides.setdefault(name, Side(name, *ends))
    return list(sides.values())


def known_force_labels(plans: Plans, plan: PlanId) -> set[str]:
    """Labels of the marks at the ends of known forces."""
    return {s.label for s in plans.program.steps if isinstance(s, LayOff) and s.plan == plan}


def rebuild_polygon(
    plans: Plans, plan: PlanId, spots: Sequence[ReadMark], naming: Naming, complete: bool = True
) -> Rebuilt:
    """The person's vectors, each from the end of the row before it, laid off in the program's order.

    After the last row of a polygon, one that is not part of it begins another, where that begins.
    In a ``complete`` polygon an unlisted vector is missing; otherwise it may have been overlooked.
    """
    sides = {s.name: s for s in polygon_sides(plans, plan)}
    names = naming.name_finder(sides)
    vectors: ReadMarks = {}
    polygons = [{vector_end_label(t.name): t.end for t in e.all_terms} for e in plans.equations if e.plan == plan]
    seen: ReadMarks = {}
    unknown = [spot.name for spot in spots if names.find_name(spot.name) is None]
    known = [spot for spot in spots if spot.name not in unknown]
    for before, spot in pairwise([*known[:1], *known]):
        name = names.find_name(spot.name)
        last = names.find_name(before.name)
        if name in sides and any(last in p and name not in p and _is_polygon_complete(p, seen) for p in polygons):
            before = seen.get(sides[name].start, before)
        seen[name or ""] = spot
        if name is not None and name != POLE_LABEL:
            old = vectors.get(name, NO_VECTOR)
            error = (before.error_mm**2 + spot.error_mm**2) ** 0.5
            vector = old.place + spot.place - before.place
            doubt = max(spot.doubt, old.doubt)
            vectors[name] = ReadMark(name, vector, max(error, old.error_mm), doubt)
    loads = known_force_labels(plans, plan)
    out = Rebuilt(
        unknown=unknown,
        vectors=[*vectors.values()],
        closers={name for name, side in sides.items() if side.end not in loads},
        left=[] if complete else [side for name, side in sides.items() if name not in vectors],
        polygons=polygons,
    )
    _lay_sides(out, sides, vectors, loads, complete)
    return out


def _is_polygon_complete(polygon: Mapping[str, str], seen: Collection[str]) -> bool:
    """Whether all sides of a polygon are seen except one that leads back to the pole."""
    return all(name in seen or end == POLE_LABEL for name, end in polygon.items())


def _lay_sides(out: Rebuilt, sides: dict[str, Side], vectors: ReadMarks, loads: set[str], complete: bool) -> None:
    """Marks from vectors: a side with one known end gives the other; a second path to a mark, the closing error."""
    places: MarkPlaces = {POLE_LABEL: 0j}
    hidden: set[str] = set()  # left out, or hidden in the next vector
    left = dict(sides)
    while left:
        known = [n for n, s in left.items() if _can_be_laid(s, places, n in vectors, loads)]
        if not known:
            return
        name = next((n for n in known if left[n].start in places), known[0])
        side = left.pop(name)
        if name not in vectors:
            places[side.end] = places[side.start]
            hidden.add(side.end)
            if complete:
                out.absent.add(side.end)
                out.spots[side.end] = ReadMark(side.end, places[side.end], 0.0)
            continue
        read = vectors[name]
        if side.start in places and side.end in places:
            gap = places[side.start] + read.place - places[side.end]
            if (complete or not hidden & {side.start, side.end}) and (out.gap is None or abs(gap) > abs(out.gap.place)):
                out.gap = replace(read, place=gap)
                out.closing = name
        else:
            new, place = (
                (side.end, places[side.start] + read.place)
                if side.start in places
                else (side.start, places[side.end] - read.place)
            )
            places[new] = place
            out.spots[new] = replace(read, name=new, place=place)


def _can_be_laid(side: Side, places: MarkPlaces, read: bool, loads: set[str]) -> bool:
    """Whether a side can be laid now: read and reached, or an unread load."""
    load = side.end in loads
    ended = side.end in places
    if side.start in places:
        return read or (load and not ended)
    return read and ended and not load


def align_marks(bench: PreparedPlan, plan: PlanId, paper: ReadPaper) -> tuple[ReadMarks, Rebuilt | None, list[str]]:
    """The paper's marks by label, from the pole; the rebuilt polygon of a force plan; names that are not marks."""
    names = mark_names(bench.plans, plan, bench.naming)
    pole = next((s for s in paper.spots if names.find_name(s.name) == POLE_LABEL), None)
    if plan.is_force:
        if pole is None:
            raise PlanesError(Phrase("check_no_pole"))
        rebuilt = rebuild_polygon(bench.plans, plan, paper.spots, bench.naming, paper.whole)
        if not rebuilt.vectors:
            wanted = ", ".join(s.name for s in polygon_sides(bench.plans, plan))
            raise PlanesError(phrase_for_reader("table", phrase_with_remedy("check_nothing_read", names=wanted)))
        return rebuilt.spots, rebuilt, rebuilt.unknown
    fixed = bench.naming.name_finder(bench.plans.mechanism.frame.points)
    spots: ReadMarks = {}
    unknown = []
    for spot in paper.spots:
        name = names.find_name(spot.name)
        if name is None and fixed.find_name(spot.name) is None:  # it may be at the pole
            unknown.append(spot.name)
        elif name and name != POLE_LABEL:
            spots.setdefault(name, spot)
    origin = pole.place if pole else _unread_pole_position(bench, plan, spots)
    return {n: replace(s, name=n, place=s.place - origin) for n, s in spots.items()}, None, unknown


def _unread_pole_position(bench: PreparedPlan, plan: PlanId, spots: ReadMarks) -> complex:
    """The position of an unread pole, from a fixed point of the scheme."""
    if plan != "position":
        raise PlanesError(Phrase("check_no_pole"))
    for name, place in bench.plans.mechanism.frame.points.items():
        if name in spots:
            return complex(spots[name].place - place * bench.given[plan.mu_name])
    raise PlanesError(Phrase("check_no_fixed", names=", ".join(bench.plans.mechanism.frame.points)))


def marks_of_earlier_plans(bench: PreparedPlan) -> TakenMarks:
    """Marks of earlier plans in the submission."""
    aligned = ((plan, align_marks(bench, plan, paper)[0]) for plan, paper in bench.asked.others.items())
    return {plan.mark(n): replace(s, doubt=0.0) for plan, spots in aligned for n, s in spots.items()}
