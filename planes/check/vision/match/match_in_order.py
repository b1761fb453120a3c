"""A force polygon of many vectors on a picture, read in the order of its equation, as a plan of motion is.

So many vectors can be laid in more orders than can be tried; but a polygon of a group of class III or IV has twelve and
more, most of them short, and is drawn as its equation runs. Vectors within the group are read with it.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from planes.check.grading.paper import ReadMark
from planes.check.grading.polygons import Side
from planes.check.grading.prepared_plan import PreparedPlan, variants_of
from planes.check.vision.marks.places import HEADED_MM, Seen, pole_on
from planes.check.vision.marks.print_scale import by_ruler, likely_shares
from planes.check.vision.search.costs import ANYWHERE, NO_MARK, slip
from planes.check.vision.search.ink_cover import InkCover
from planes.check.vision.search.laid_plan import LaidPlan
from planes.check.vision.search.plan_search import Search
from planes.check.vision.search.polygon_cover import ReadPolygon, seen_like
from planes.check.vision.strokes.line_places import WOBBLE_MM
from planes.words.names import POLE, at

POOR, POORLY = 8.0, 2.0  # a polygon that costs more than this, and this for each vector, is not surely one
UNSURE, APART = 2.6, 5.0  # how much more the right one must cost than a mistake; by which it is out of the question
SHORT = 1.5  # and this for each without a head
RIVAL, APART_MM = 2.0, 0.8  # a mistake that costs so little more leaves in doubt what it moves so far
HIDDEN, HIDDEN_MM = 2.0, 0.5  # what the end of a vector costs a millimetre long that is not seen; its σ


@dataclass
class SoughtInOrder(Search):
    """A polygon's marks looked for one after another."""

    lengths: dict[str, float] = field(default_factory=dict)  # of the vectors to them, mm

    def _missing(self, mark: str) -> float:
        """What it costs that a mark is nowhere: little, if its vector is short."""
        return min(NO_MARK, 0.5 + HIDDEN * self.lengths.get(mark, math.inf))

    def places(self, way: LaidPlan, sides: Sequence[Side]) -> dict[str, tuple[complex, float]]:
        """Where the marks are, by label, and their σ; of those hidden, where they should be."""
        out = {POLE: (self.pole.z, self.pole.sigma)}
        for side in sides:
            if side.end in out or side.start not in out:
                continue
            found = way.found.get(at(self.bench.asked.plan, side.end))
            true = self._true(side.end) - self._true(side.start)
            hidden = out[side.start][0] + true, math.hypot(HIDDEN_MM, out[side.start][1])
            out[side.end] = (found.z, math.hypot(found.sigma, WOBBLE_MM)) if found else hidden
        return out

    def vectors_of(self, way: LaidPlan, sides: Sequence[Side]) -> dict[str, complex]:
        """Its vectors by name."""
        places = {n: z for n, (z, _) in self.places(way, sides).items()}
        return {s.name: places[s.end] - places[s.start] for s in sides if s.start in places and s.end in places}

    def right_vectors(self, sides: Iterable[Side]) -> dict[str, complex]:
        """Those of the right plan by name."""
        return {s.name: self._true(s.end) - self._true(s.start) for s in sides}

    def _true(self, label: str) -> complex:
        return 0j if label == POLE else self.true[at(self.bench.asked.plan, label)]


@dataclass
class Tried:
    """How a polygon may have been drawn on a sheet printed at a share of its size."""

    search: SoughtInOrder
    plain: LaidPlan | None = None
    wrong: list[LaidPlan] = field(default_factory=list)

    @property
    def best(self) -> LaidPlan | None:
        """The cheapest way."""
        return min((w for w in (self.plain, *self.wrong) if w), key=lambda w: w.cost, default=None)

    @property
    def cost(self) -> float:
        """What that costs."""
        return self.best.cost if self.best else math.inf

    def look(self, fair: float) -> None:
        """Try it with each mistake that may explain it, or nearly as well as the right plan does."""
        variants = variants_of(self.search.bench, {}, self.search.bench.said_mu)
        for variant in variants:
            most = min(self.cost + RIVAL, fair + ANYWHERE)
            way = self.search.settled(variant, slip(len(variants)), most)
            self.wrong += [way] if way and way.cost < most else []

    def untold(self, best: LaidPlan, sides: Sequence[Side]) -> tuple[str, ...]:
        """Vectors that some mistake puts elsewhere and explains the ink nearly as well as the way it was read, or that
        this has elsewhere itself."""
        mine = self.search.vectors_of(best, sides) if best is self.plain else self.search.right_vectors(sides)
        found = dict[str, None]()
        for rival in (self.search.vectors_of(w, sides) for w in self.wrong if w.cost < best.cost + RIVAL):
            found |= dict.fromkeys(n for n, v in rival.items() if n in mine and abs(v - mine[n]) > APART_MM)
        return tuple(found)


def read_in_order(bench: PreparedPlan, sides: Sequence[Side], seen: Seen, near: complex) -> ReadPolygon | None:
    """The polygon drawn on a sheet about a place in its own order; None where nothing of the kind is seen."""
    pole = pole_on(seen, near)
    ink = InkCover(seen, pole.z, [*bench.true_marks.values()])
    vectors = [(s.start, s.end) for s in sides]
    shares = likely_shares(seen.ink.flat, seen_like(bench, [*sides], seen))
    tried = [Tried(SoughtInOrder.of(bench, ink, pole, vectors, share)) for share in shares]
    for one in tried:
        true = one.search.right_vectors(sides)
        one.search.lengths = {at(bench.asked.plan, s.end): abs(true[s.name]) for s in sides}
        one.plain = one.search.settled(None)
    short = sum(mm < HEADED_MM for mm in tried[0].search.lengths.values())
    fair = POOR + POORLY * len(sides) + SHORT * short
    tried.sort(key=lambda one: one.cost)
    for one in tried:
        if one is tried[0] or tried[0].cost > fair:
            one.look(fair)
    one = min(tried, key=lambda one: one.cost)
    best, right = one.best, min((t.plain.cost for t in tried if t.plain), default=math.inf)
    if best is None or best.cost > fair + (0.0 if best is one.plain else ANYWHERE):
        return None
    if best is not one.plain and right - best.cost < UNSURE:
        if one.plain is None or one.plain.cost > fair:
            return ReadPolygon(explained=1.0)
        best = one.plain  # what a mistake moves, which explains it as well, is told as not seen
    return _told(one, best, sides, near, right - best.cost > APART)


def _told(one: Tried, best: LaidPlan, sides: Sequence[Side], near: complex, apart: bool) -> ReadPolygon:
    """The rows of a polygon that was read: each vector from where it starts, where the pen is put down anew."""
    search, places = one.search, one.search.places(best, sides)
    explained = search.ink.explained(search.routes(best))
    rows, last = list[ReadMark](), ""
    for side in sides:
        if side.start not in places or side.end not in places:
            continue
        rows += [ReadMark(POLE, *places[side.start])] if side.start != last else []
        rows.append(ReadMark(side.name, *places[side.end]))
        last = side.end
    plan = search.bench.asked.plan
    hidden = [s for s in sides if s.end != POLE and at(plan, s.end) not in best.found]
    names = tuple(s.name for s in hidden if search.lengths[at(plan, s.end)] > HIDDEN_MM)
    spots = by_ruler(search.seen.ink.flat, near, search.share, rows, explained, {})
    return ReadPolygon(spots, explained > 0.9, explained, names, one.untold(best, sides), apart)
