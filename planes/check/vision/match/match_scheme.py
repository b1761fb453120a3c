"""Which place of a picture is which point of a scheme: as for the plans of motion, with the signs a scheme has.

A point is where a hinge's circle or a dot stands, or where lines end and cross; links are lines between their points,
guides lines through a slider. What is drawn about supports and sliders says nothing.
"""

import cmath
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from itertools import combinations

from planes.check.grading.paper import ReadMark
from planes.check.grading.prepared_plan import PreparedPlan, variants_of
from planes.check.vision.marks.places import Seen, pole_on
from planes.check.vision.marks.print_scale import by_ruler, likely_shares, measured_by, seen_from
from planes.check.vision.match.match_symbols import signs
from planes.check.vision.search.costs import ANYWHERE, NO_MARK, slip
from planes.check.vision.search.ink_cover import COVERED, InkCover
from planes.check.vision.search.laid_plan import LaidPlan
from planes.check.vision.search.plan_search import Search
from planes.check.vision.search.signs_seen import Found
from planes.check.vision.strokes.line_places import SAME_MM, Place
from planes.drafting.steps import Step
from planes.words.names import POLE, at, label_of

SIGN_MM = 5.5  # a place nearer than this to a sign is likely a corner of what is drawn around it
SUPPORT_MM, HINGE_MM = 9.5, 3.0  # ink nearer than this to a support or slider, to another point, is explained
BEYOND_MM = 30.0  # guides are drawn that far past a slider
HIDDEN_MM = 2.6  # of a line, within the signs at its ends
ORIGIN_MM = 1.5
AT_SIGNS = 0.7  # the share of points that must stand at signs for these to tell where the origin is
ALONG = 0.1  # radians, by which two lines along each other part: where they meet cannot be seen
NO_POINT = 16.0  # what it costs that a point of a link is nowhere; a mass centre need not be drawn


@dataclass
class SoughtScheme(Search):
    """A scheme's points looked for on a sheet."""

    mates: dict[str, list[str]] = field(default_factory=dict)  # by mark: marks of the same links
    bases: list[tuple[str, str]] = field(default_factory=list)  # sliders, and the points their guides go through
    fixed_guides: dict[str, complex] = field(default_factory=dict)  # directions of guides, by slider
    supported: set[str] = field(default_factory=set)  # points at supports and in sliders
    centres: set[str] = field(default_factory=set)  # marks of mass centres, which need not be drawn

    def _led_to(self, step: Step, z: complex, places: Mapping[str, complex]) -> bool:
        """Whether a line leads to a place from a point of the same link."""
        near = [places[m] for m in self.mates.get(step.makes, ()) if m in places]
        return not near or any(self._covered(mate, z) >= COVERED for mate in near)

    def _before(self, step: Step) -> list[str]:
        """The points of the same links."""
        return self.mates.get(step.makes, [])

    def _missing(self, mark: str) -> float:
        """What it costs that a point is nowhere."""
        return NO_MARK if mark in self.centres else NO_POINT

    def _likely(
        self, step: Step, goal: complex, places: Mapping[str, complex], found: Mapping[str, Place]
    ) -> list[tuple[float, Place | None]]:
        """The places that a mark may mean; a mass centre's is a dot, not where lines happen to cross near it."""
        likely = super()._likely(step, goal, places, found)
        dots = [one for one in likely if one[1] is None or one[1].tip or step.makes not in self.centres]
        return dots or [(self._missing(step.makes), None)]

    def _closer(self, mark: str, goal: complex, places: Mapping[str, complex]) -> Iterator[Place]:
        """No line of a scheme has a head."""
        return iter(())

    def free_marks(self, way: LaidPlan) -> Iterator[tuple[str, Place]]:
        """Points that may be elsewhere: at places away from those used, led to from their mates; a centre, at a dot."""
        used = [self.pole.z, *(p.z for p in way.found.values())]
        free = [p for p in self._ended() if all(abs(p.z - z) > HINGE_MM for z in used)]
        for mark in self.bench.marks:
            near = [way.found[m].z for m in self.mates.get(mark, ()) if m in way.found]
            for place in free:
                if (place.tip or mark not in self.centres) and any(self._covered(z, place.z) > COVERED for z in near):
                    yield mark, place

    def ways(self) -> Iterator[LaidPlan]:
        """How the scheme may have been drawn: rightly; where points are missing, with a mistake or a point anywhere."""
        right = self.way(None)
        if right:
            yield right
        enough = right and {*self.bench.marks} - {*right.found} <= self.centres
        if right and enough and (right.cost < self.fair or self.at_signs(right)):
            return
        variants = variants_of(self.bench, {}, self.bench.said_mu)
        wrong = [self.way(v, cost=slip(len(variants))) for v in variants]
        yield from (w for w in wrong if w)
        best = min((w for w in (right, *wrong) if w), key=lambda w: w.cost, default=None)
        if best and best.cost > slip(len(variants)) + self.fair:
            free_ones = {(m, p.z): (m, p) for way in (right or best, best) for m, p in self.free_marks(way)}
            yield from (w for w in (self.way(None, f, ANYWHERE) for f in free_ones.values()) if w)

    def at_signs(self, way: LaidPlan) -> bool:
        """Whether every point was found where a sign stands, or so near another that its own is hidden."""
        told = [p.z for p in way.found.values() if p.tip or p is self.pole]
        near = (min((abs(p.z - z) for z in told), default=HINGE_MM) for p in way.found.values())
        return {*self.bench.marks} == {*way.found} and all(off < HINGE_MM for off in near)

    def lost(self, mark: str, way: LaidPlan) -> bool:
        """Whether no sign tells where on its guide a slider is, and all its link's lines run along that guide."""
        place, guide = way.found[mark], self.fixed_guides.get(label_of(mark))
        lines = [place.z - way.found[mate].z for mate in self.mates.get(mark, ()) if mate in way.found]
        if place.tip or guide is None or not lines:
            return False
        return all(abs((line / guide).imag) < ALONG * abs(line) for line in lines)

    @property
    def fair(self) -> float:
        """What a way costs that explains the picture well."""
        return 2.0 + 0.8 * len(self.bench.marks) + NO_MARK * len(self.centres)

    def _covered(self, a: complex, b: complex) -> float:
        """The share of the way that is drawn, what signs hide aside."""
        length = abs(b - a)
        if length < 3 * HIDDEN_MM:
            return 1.0
        u = (b - a) / length * HIDDEN_MM
        return self.seen.ink.covered(a + u, b - u)

    def _lines(self, way: LaidPlan) -> Iterator[tuple[complex, complex]]:
        """Where the lines of a scheme with these points run."""
        ends = way.ends(self.pole.z)
        yield from ((ends[a], ends[b]) for a, b in self.vectors if a in ends and b in ends)
        for slider, base in self.bases:
            if slider in ends and base in ends and abs(ends[slider] - ends[base]) > 1:
                u = (ends[slider] - ends[base]) / abs(ends[slider] - ends[base])
                yield ends[base] - BEYOND_MM * u, ends[slider] + BEYOND_MM * u
        for slider, u in self.fixed_guides.items():
            if slider in ends:
                yield ends[slider] - BEYOND_MM * u, ends[slider] + BEYOND_MM * u

    def routes(self, way: LaidPlan) -> list[tuple[complex, complex]]:
        """Where its lines run, and rows over all of its signs."""
        routes = [(a, b) for a, b in self._lines(way) if a != b]
        for mark, place in way.found.items():
            reach = SUPPORT_MM if label_of(mark) in self.supported else HINGE_MM
            routes += [(place.z + s - reach, place.z + s + reach) for s in _rows(reach)]
        return routes


def _rows(reach: float) -> list[complex]:
    """Lines so near each other that all within ``reach`` lies on one."""
    count = int(reach / 0.8)
    return [1j * reach * k / count for k in range(-count, count + 1)]


def scheme_search(bench: PreparedPlan, ink: InkCover, pole: Place, share: float = 1.0) -> SoughtScheme:
    """A search from a pole on a sheet printed at a share of its size."""
    mechanism, labels = bench.plans.mechanism, {label_of(m) for m in bench.marks}
    pairs = [p for link in mechanism.links.values() for p in combinations([n for n in link.points if n in labels], 2)]
    out = SoughtScheme.of(bench, ink, pole, pairs, share)
    out.centres = {at(bench.asked.plan, link.centre) for link in mechanism.links.values() if link.centre}
    out.supported = {n for n in mechanism.frame.points if n in labels}
    for link in mechanism.links.values():
        slider = next(iter(link.points))
        if link.slides and slider in labels:
            out.supported.add(slider)
            guide = mechanism.guide(link.slides.guide)
            if guide.name in mechanism.frame.guides:
                out.fixed_guides[slider] = cmath.rect(1.0, math.radians(guide.angle_deg))
            elif guide.through_point in labels:
                out.bases.append((slider, str(guide.through_point)))
    for a, b in [*pairs, *out.bases]:
        for one, other in ((a, b), (b, a)):
            out.mates.setdefault(at(bench.asked.plan, one), []).append(at(bench.asked.plan, other))
    return out


def with_signs(seen: Seen) -> Seen:
    """What is seen, with the signs among its places; what stands close to one is doubtful."""
    found = [Place(z, sigma, frozenset({(-1 - k, 0)}), True) for k, (z, sigma) in enumerate(signs(seen.ink))]
    for place in seen.places:
        apart = min((abs(place.z - s.z) for s in found), default=SIGN_MM)
        place.doubtful = place.doubtful or apart < SIGN_MM
    places = [p for p in seen.places if all(abs(p.z - s.z) > 2 * SAME_MM for s in found)]
    return Seen(seen.ink, seen.lines, [*found, *places], seen.patches)


def points_on(bench: PreparedPlan, seen: Seen, near: complex) -> Found:
    """The points of a scheme with its origin near a place, the share of the ink they explain, and nothing that is told
    by its name alone."""
    seen = with_signs(seen)
    pole = origin_on(seen, near)
    shares = likely_shares(seen.ink.flat, seen_from(seen, pole.z, bench.true_marks))
    ink = InkCover(seen, pole.z, [*bench.true_marks.values()], arrows=False)
    searches = (scheme_search(bench, ink, pole, share) for share in shares)
    found = ((search, way) for search in searches for way in search.ways())
    search, way = min(found, key=lambda one: one[1].cost, default=(None, None))
    if search is None or way is None or not way.found:
        return [], 0.0, (), [], []
    spots = [ReadMark(POLE, search.pole.z, min(search.pole.sigma, 0.3))]
    spots += [ReadMark(label_of(m), p.z, p.error_mm) for m, p in way.found.items() if not search.lost(m, way)]
    explained = 1.0 if search.at_signs(way) else ink.explained(search.routes(way))
    spots = measured_by(seen.ink.flat, near, spots, search.own)
    return by_ruler(seen.ink.flat, near, search.share, spots, explained, bench.true_marks), explained, (), [], []


def origin_found(bench: PreparedPlan, seen: Seen) -> complex | None:
    """The place from which most points of the right scheme would stand at signs, wherever it is; None if too few do."""
    spots, points = [z for z, _ in signs(seen.ink)], [*bench.true_marks.values()]
    best: list[complex] = []
    for origin in (z - w for z in spots for w in points):
        off = (min((s - w - origin for s in spots), key=abs) for w in points)
        best = max(best, [origin + d for d in off if abs(d) < ORIGIN_MM], key=len)
    return sum(best) / len(best) if len(best) >= max(2, AT_SIGNS * len(points)) else None


def origin_on(seen: Seen, near: complex) -> Place:
    """The origin: the middle of the sign upon it, else where it is printed or the lines drawn from it meet."""
    upon = min(seen.within(near, ORIGIN_MM), key=lambda p: (not p.tip, abs(p.z - near)), default=None)
    return upon if upon and upon.tip else pole_on(seen, near)
