"""The vectors of a force plan in a vector drawing, wherever on the plan they lie.

Every arrow is the vector that it resembles and whose name stands beside it, in the right plan or in a mistake's.
"""

import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import compress
from statistics import median

import numpy

from planes.check.evidence.line_words import LineWord, words_among_names
from planes.check.explaining import weights as w
from planes.check.explaining.hypotheses import catalogue_hypotheses
from planes.check.explaining.plan_lines import Hypothesis, PlanLines
from planes.check.grading.paper import MarkPlaces, ReadMark, ReadPaper
from planes.check.grading.polygons import known_force_labels, polygon_sides
from planes.check.grading.prepared_plan import PreparedPlan
from planes.check.grading.remedies import phrase_with_remedy
from planes.check.grading.sign_faults import DrawnVector, SignFault, arrow_faults
from planes.check.reading.construction_lines import covered_share
from planes.check.reading.parts import MOST_PART_TO_WORD_MM
from planes.check.reading.strokes import LEAST_HEADED_STROKES, ReadDrawing, strokes_with_heads
from planes.check.reading.weighed import agreement_score, is_right_paper
from planes.check.reading.written import Stroke, vector_of
from planes.geometry.arrays import Array
from planes.geometry.plane import distance_to_nearest, perpendicular_foot
from planes.words.names import POLE_LABEL, vector_end_label

SHORTEST_VECTOR_WITH_HEAD_MM = 2.0  # a shorter vector may have no head
NO_NAME_COST = 2.0  # cost of having no name
REVERSED_NUMBERS_COST = 4.0  # numbers in reverse
NO_HEAD_COST = 1.0  # no head
MOST_STRAY_ARROW_COSTS = 2.5, 9.0  # maximum cost of an arrow outside the plan, without heads and with them
LEAST_STRAY_ARROW_COSTS = 0.0, 4.0  # the minimum of it
COMPUTED_FORCE_ERROR_SHARE = 0.02  # of its length, the error of a force computed from others
OPPOSITE_NAME_SOFTNESS_MM, OPPOSITE_NAME_MIDDLE_SHARE, TIP_NAME_STEEPNESS = (
    0.5,
    0.15,
    8.0,
)  # for names of opposite vectors
OPPOSITE_VECTORS_GAP_RATIO = 0.2  # maximum distance between opposite vectors, relative to their length
MEETING_ENDS_MM = 1.0  # ends that meet
GAP_ERROR_SHARE = 0.7  # share of their distance that is the error of each
SHORTEST_DRAWN_VECTOR_MM = 0.7  # shorter vectors are not drawn
COINCIDENT_VECTORS_MM = 0.3  # vectors that coincide
HIDDEN_VECTOR_SHARE = 0.7  # share of a vector within the lines of others at which it need not be visible
PROGRAM_ACCURACY_MM = 0.05  # accuracy of a program
MOST_ARROWS = 120  # arrows
# sizes of a plan of unknown scale: the smallest; ratio of equal ones
SMALLEST_PLAN_SIZE = 0.2
EQUAL_SIZE_RATIO = 1.03
OTHER_SIZE_COST = 3.0
IMPOSSIBLE_COST, TINY = 1e6, 1e-9
Rows = Mapping[str, Stroke]
NamedStrokes = Iterator[tuple[str, Stroke]]


@dataclass
class Reading:
    """The assignment of arrows to vectors under a hypothesis, and its cost; the expected vectors, mm."""

    cost: float
    known: MarkPlaces
    taken: dict[str, int]  # index among all directions of arrows, by vector name
    left: list[int]


@dataclass
class ForceArrows:
    """The arrows of a drawing in each possible direction, and the evidence of names for them."""

    sketch: ReadDrawing
    bench: PreparedPlan

    def __post_init__(self) -> None:
        sketch = self.sketch
        bench = self.bench
        many = len(sketch.strokes) > MOST_ARROWS and sum(map(bool, sketch.ways)) >= LEAST_HEADED_STROKES
        self.headed = many or bool(strokes_with_heads(sketch))
        self.plan = PlanLines(bench, to_fit=False)
        self.written = self.needed = numpy.zeros(0, bool)  # names on the drawing; vectors that must be there
        self.prices = numpy.zeros((0, 0))  # cost of each name for each direction of an arrow
        self.sides = polygon_sides(bench.plans, bench.plan)
        loads = known_force_labels(bench.plans, bench.plan)
        segments = bench.plans.segments_on(bench.plan)
        own = {s.name: (s.start, s.end) for s in self.sides}
        self.ends = own | {vector_end_label(s.name): (s.start, s.end) for s in segments} | own
        leaning = (f"{letter}_{index}" for *_, index in bench.leaning_reactions for letter in "NT")
        self.names = [*self.ends, *leaning]  # these may be drawn, too
        self.reactions = {s.name for s in self.sides if s.end not in loads}
        self.own = numpy.array([n in own for n in self.names])
        self.arrows: list[tuple[Stroke, ...]] = []
        for k, s in enumerate(sketch.strokes):
            if way := sketch.end_with_head(k):
                self.arrows.append((s if way > 0 else s[::-1],))
            elif not self.headed or abs(vector_of(s)) < SHORTEST_VECTOR_WITH_HEAD_MM:
                self.arrows.append((s, s[::-1]))
        self.flat = [(i, s) for i, one in enumerate(self.arrows) for s in one]
        self.v = numpy.array([vector_of(s) for _, s in self.flat])
        self.of = numpy.array([i for i, _ in self.flat])
        self.bare = numpy.array([self.headed and len(one) > 1 for one in self.arrows])  # without a head as others have

    def vectors_by_name(self, h: Hypothesis) -> MarkPlaces | None:
        """Every vector that may be drawn, by name."""
        if (drawn := self.plan.drawn(h)) is None:
            return None
        places = dict(zip(self.plan.names, drawn[0].tolist(), strict=True))
        vectors = {n: places.get(b, 0j) - places.get(a, 0j) for n, (a, b) in self.ends.items()}
        for a, b, along, index in self.bench.leaning_reactions:
            start = places.get(a, 0j)
            end = places.get(b, 0j)
            corner = perpendicular_foot(start, end, along)
            vectors |= {f"N_{index}": corner - start, f"T_{index}": end - corner}
        return vectors

    def name_costs_of_arrows(self) -> Array:
        """The cost of each name for each direction of an arrow, by its position."""
        every = words_among_names(self.sketch, self.bench.naming.name_finder(self.names), self.names).words
        placed = ((one, [one.distance_to_segment(*s) for _, s in self.flat]) for one in every)
        words = [(one, off) for one, off in placed if min(off) < MOST_PART_TO_WORD_MM]
        written = {n for one, _ in words for n in one.likely}
        self.written = numpy.array([n in written for n in self.names])
        cost = numpy.where(self.written, w.MISPLACED_NAME_WEIGHT * 9.0, NO_NAME_COST) + numpy.zeros((len(self.flat), 1))
        back = [
            next((k for k, (j, o) in enumerate(self.flat) if j != i and _leads_back_beside(s, o)), None)
            for i, s in self.flat
        ]
        for one, off in words:
            for k, (i, s) in enumerate(self.flat):
                price = w.MISPLACED_NAME_WEIGHT * self._naming_cost(one, off, k, i, s, back[k])
                for n in one.likely:
                    at = k, self.names.index(n)
                    cost[at] = min(cost[at], price)
        return cost

    def _naming_cost(self, one: LineWord, off: Sequence[float], k: int, i: int, s: Stroke, back: int | None) -> float:
        """The cost of a text naming this vector, and no other one."""
        pair = i if back is None else self.flat[back][0]
        price = one.naming_cost(off[k], [mm for mm, (j, _) in zip(off, self.flat, strict=True) if j not in (i, pair)])
        if back is not None:  # it is at its own tip, or nearer to its own
            z = one.word.middle if one.led is None else one.led
            ahead = ((z - s[0]) / vector_of(s)).real - 0.5
            by_tip = math.log(1 + math.exp(min(-2 * TIP_NAME_STEEPNESS * ahead, 40.0)))
            price += (
                by_tip
                if abs(ahead) > OPPOSITE_NAME_MIDDLE_SHARE
                else one.naming_cost(off[k], [off[back]], OPPOSITE_NAME_SOFTNESS_MM)
            )
        return price + REVERSED_NUMBERS_COST * (not one.word.agrees_with_end_numbers(s, self.sketch.words))

    def likeliest_readings(self) -> Iterator[Reading]:
        """The likeliest reading of the right plan and of each mistake's."""
        right = self.vectors_by_name(Hypothesis())
        if right is None:
            return
        self.prices = self.name_costs_of_arrows()
        places = [right[n] for n in self.names]
        twins = [
            n in self.reactions and any(min(abs(v - u), abs(v + u)) < PROGRAM_ACCURACY_MM for u in places[:k])
            for k, (n, v) in enumerate(zip(self.names, places, strict=True))
        ]
        self.needed = self.own & ~numpy.array(twins)
        size = min(
            self._possible_plan_sizes(right),
            key=lambda k: self.read_under_hypothesis(0.0, right, k, w.DRAWING_SIGMA_MM).cost,
        )
        for h in (Hypothesis(), *catalogue_hypotheses(self.plan)):
            if (known := self.vectors_by_name(h)) is not None:
                yield min(
                    (
                        self.read_under_hypothesis(h.cost, known, size, s)
                        for s in (w.DRAWING_SIGMA_MM, PROGRAM_ACCURACY_MM)
                    ),
                    key=lambda r: r.cost,
                )

    def _possible_plan_sizes(self, known: MarkPlaces) -> list[float]:
        """Sizes of the plan relative to the stated one: the drawer's choice unless given."""
        sizes = [1.0]
        lengths = [abs(v) for v in known.values() if abs(v) > SHORTEST_VECTOR_WITH_HEAD_MM]
        for ratio in sorted(float(abs(v)) / t for v in self.v for t in lengths) if not self.bench.asked.mu else ():
            if SMALLEST_PLAN_SIZE < ratio < 1 / SMALLEST_PLAN_SIZE and ratio > EQUAL_SIZE_RATIO * (
                sizes[-1] if len(sizes) > 1 else 0.0
            ):
                sizes.append(ratio)
        return sizes

    def read_under_hypothesis(self, prior: float, known: MarkPlaces, size: float, sigma: float) -> Reading:
        """The likeliest reading under a hypothesis of this prior cost."""
        true = numpy.array([known[n] for n in self.names]) * size
        spread = sigma + (COMPUTED_FORCE_ERROR_SHARE * abs(true) if sigma == w.DRAWING_SIGMA_MM else 0.0)
        unlike = w.DRAWING_ERROR_WEIGHT * abs(self.v[:, None] - true) ** 2 / (2 * spread**2)
        missed = self.needed & (self.written | (abs(true) > SHORTEST_VECTOR_WITH_HEAD_MM / 2))
        cost = numpy.minimum(unlike, w.HYPOTHESIS_COSTS["anywhere"]) + self.prices - w.OMITTED_LINE_COST * missed
        cost = cost + NO_HEAD_COST * self.bare[self.of, None]
        first, last = (numpy.searchsorted(self.of, range(len(self.arrows)), side) for side in ("left", "right"))
        last = last - 1  # the other direction of an arrow without a head
        ways = numpy.where(cost[last] < cost[first], last[:, None], first[:, None])
        over = numpy.minimum(
            LEAST_STRAY_ARROW_COSTS[self.headed] + w.UNEXPLAINED_COST_PER_MM * abs(self.v[first]),
            MOST_STRAY_ARROW_COSTS[self.headed],
        )
        beside = numpy.where(numpy.eye(len(over), dtype=bool), numpy.where(self.bare, 0.0, over), IMPOSSIBLE_COST)
        table = numpy.hstack([numpy.minimum(cost[first], cost[last]), beside])
        columns = cheapest_assignment(table)
        taken = {self.names[j]: int(ways[i, j]) for i, j in enumerate(columns) if j < len(self.names)}
        left = [i for i, j in enumerate(columns) if j >= len(self.names)]
        total = float(table[range(len(table)), columns].sum()) + prior + OTHER_SIZE_COST * (size != 1.0)
        total += 4 * w.DRAWING_ERROR_WEIGHT * len(taken) * math.log(sigma / w.DRAWING_SIGMA_MM)
        return Reading(total, dict(zip(self.names, true.tolist(), strict=True)), taken, left)


def read_force_arrows(sketch: ReadDrawing, bench: PreparedPlan) -> ReadPaper:
    """The vectors of a force plan, each a row from its start."""
    paper = ReadPaper(sketch.file, whole=False)
    seen = ForceArrows(sketch, bench)
    if not 0 < len(seen.arrows) <= MOST_ARROWS:
        paper.reason = phrase_with_remedy("check_force_unsure") if seen.arrows else None
        return paper
    readings = sorted(seen.likeliest_readings(), key=lambda r: r.cost)
    if not readings:
        return paper
    best = readings[0]
    own = {s.name for s in seen.sides}
    back = dict(_reversed_vectors(seen, best, own))
    rows = {n: s for n, s in (_vectors_with_arrows(seen, best) | back).items() if n in own}
    true = {n: v for n, v in best.known.items() if n in own}
    bare = dict(_headless_vectors(seen, {n: v for n, v in best.known.items() if n not in {*best.taken, *rows}}, rows))
    rows |= {n: s for n, s in bare.items() if n in own}
    rows |= dict(_short_vectors_between(rows, true))
    heads = dict.fromkeys(rows, DrawnVector("end"))
    heads |= dict.fromkeys(back, DrawnVector("start")) | dict.fromkeys(bare, DrawnVector("none"))
    exchanged, elsewhere = _swapped_and_misplaced_names(seen, best)
    paper.signs = [*exchanged, *arrow_faults({("", n): how for n, how in heads.items()})]
    paper.untold = [n for n in elsewhere if n in own]
    ring = {s.name for s in seen.plan.sides} & {*compress(seen.names, seen.needed)}  # vectors inside are optional
    unread = (n for n in true if n in ring and n not in rows and abs(true[n]) > SHORTEST_VECTOR_WITH_HEAD_MM)
    paper.left = [n for n in unread if not _may_end_in_other_head(seen, true[n], rows)]
    gaps = _end_to_start_gaps(rows)
    meeting = [gap for gap in gaps if gap < MEETING_ENDS_MM]
    error = max(sketch.error_mm, GAP_ERROR_SHARE * median(meeting or [0.0]))
    paper.spots = _spots(rows, error)
    paper.whole = seen.headed and all(
        abs(vector_of(seen.arrows[i][0])) < SHORTEST_VECTOR_WITH_HEAD_MM for i in best.left
    )
    room = 2 * max(gaps, default=0.0)  # where all ends meet, no vector is hidden
    paper.whole &= all(
        n in rows or not SHORTEST_DRAWN_VECTOR_MM < abs(true[n]) < min(room, SHORTEST_VECTOR_WITH_HEAD_MM) for n in own
    )
    if _is_only_guessed(seen, rows, bench, paper):
        paper.spots = []
        paper.reason = phrase_with_remedy("check_force_unsure")
    return paper


def _vectors_with_arrows(seen: ForceArrows, best: Reading) -> dict[str, Stroke]:
    """The vectors with their arrows: a reaction and its only component, or two inner vectors, may share one."""
    rows = {n: seen.flat[k][1] for n, k in best.taken.items()}
    for n in (s.name for s in seen.sides):
        alike = [m for m in rows if abs(best.known[m] - best.known[n]) < COINCIDENT_VECTORS_MM]
        same = [m for m in alike if n in seen.reactions or not seen.own[seen.names.index(m)]]
        if n not in rows and same:
            rows[n] = rows[same[0]]
    return rows


def _reversed_vectors(seen: ForceArrows, best: Reading, own: Collection[str]) -> NamedStrokes:
    """Vectors without an arrow, each at a reversed one; and sums that have one."""
    left = [seen.arrows[i][0] for i in best.left if len(seen.arrows[i]) == 1]
    left = [(a, b) for a, b in left if all(abs(b - a - v) > _vector_tolerance_mm(v) for v in best.known.values())]
    for n, v in best.known.items():
        if abs(v) <= SHORTEST_VECTOR_WITH_HEAD_MM or (n in best.taken and n in own):
            continue
        lying = [seen.flat[best.taken[n]][1]] if n in best.taken else left
        back = next((s for s in lying if abs(vector_of(s) + v) < _vector_tolerance_mm(v)), None)
        if back:
            left = [s for s in left if s != back]
            yield n, back[::-1]


def _swapped_and_misplaced_names(seen: ForceArrows, best: Reading) -> tuple[list[SignFault], list[str]]:
    """Pairs of names at each other's arrows; vectors whose names fit another's place better, and vice versa."""
    names = [*best.taken]
    v = numpy.array([best.known[n] for n in best.taken])
    prices = seen.prices[[*best.taken.values()]][:, [seen.names.index(n) for n in names]] / w.MISPLACED_NAME_WEIGHT
    other = numpy.where(abs(v[:, None] - v) > MEETING_ENDS_MM, prices, math.inf)
    own = prices.diagonal()
    surely = -math.log(w.LEAST_NAME_CERTAINTY)
    rather = own - other > math.log(w.SWAPPED_OVER_OWN_ODDS)  # by row of an arrow and column of a name
    sure = rather & rather.T & (other + other.T < 2 * surely)
    there, theirs = (other.min(axis=k, initial=math.inf) for k in (0, 1))
    elsewhere = rather.any(axis=0) & (numpy.maximum(there, theirs) < surely)
    pairs = [(names[k], names[j]) for k, j in numpy.argwhere(numpy.triu(sure))]
    exchanged = [SignFault("names_exchanged", *pair, w.SWAPPED_NAMES_CERTAINTY) for pair in pairs]
    return exchanged, [*compress(names, elsewhere)]


def _headless_vectors(seen: ForceArrows, unread: MarkPlaces, rows: Rows) -> NamedStrokes:
    """Vectors that are headless lines from the end of one to the start of another, where others have heads."""
    ends = numpy.array([*rows.values()]).ravel()
    lines = [s for k, s in enumerate(seen.sketch.strokes) if seen.headed and not seen.sketch.end_with_head(k)]
    joined = [s for s in lines if all((abs(ends - z) < MEETING_ENDS_MM).any() for z in s)]
    for n, v in unread.items():
        like = [s for one in joined for s in (one, one[::-1]) if abs(vector_of(s) - v) < _vector_tolerance_mm(v)]
        yield from [(n, s) for s in like[:1] if abs(v) > SHORTEST_VECTOR_WITH_HEAD_MM]


def _may_end_in_other_head(seen: ForceArrows, v: complex, rows: Rows) -> bool:
    """Whether a vector may end in the head of another in the same direction, so that it has none."""
    headed = [one[0] for one in seen.arrows if len(one) == 1]
    ends = [b for _, b in rows.values()]
    return any(
        abs(b - z - v) < _vector_tolerance_mm(v) and covered_share(headed, z, b) > HIDDEN_VECTOR_SHARE
        for _, b in headed
        for z in ends
    )


def _vector_tolerance_mm(v: complex) -> float:
    """The tolerance of a drawn vector."""
    return max(MEETING_ENDS_MM, COMPUTED_FORCE_ERROR_SHARE * abs(v))


def _is_only_guessed(seen: ForceArrows, rows: Rows, bench: PreparedPlan, paper: ReadPaper) -> bool:
    """Whether the vectors of a wrong polygon are only guessed.

    They have no names; or, as none has a head, they may as well be reversed; or headless lines do not form a chain.
    """
    if not seen.headed:
        begun = [a for a, _ in rows.values()]
        if sum(distance_to_nearest(b, begun) > MEETING_ENDS_MM for _, b in rows.values()) > 1:
            return True
    if is_right_paper(bench, paper):
        return False
    error = next((s.error_mm for s in paper.spots), 0.0)
    back = _spots({n: s[::-1] for n, s in rows.items()}, error)
    turned = not seen.headed and agreement_score(bench, replace(paper, spots=back)) >= agreement_score(bench, paper)
    return turned or not (seen.written & seen.own).any()


def _end_to_start_gaps(rows: Rows) -> list[float]:
    """The distance from the end of each vector to the start of another."""
    return [distance_to_nearest(b, [a for a, _ in rows.values()]) for _, b in rows.values()]


def _spots(rows: Rows, error: float) -> list[ReadMark]:
    """Each vector as its start and its end."""
    return [ReadMark(n, z, error) for name, s in rows.items() for n, z in zip((POLE_LABEL, name), s, strict=True)]


def _short_vectors_between(rows: Rows, known: MarkPlaces) -> NamedStrokes:
    """Short vectors, not drawn separately, between the end of one and the start of another."""
    begun = [a for a, _ in rows.values()]
    ended = [b for _, b in rows.values()]
    begun, ended = (
        [z for z in one if distance_to_nearest(z, other) > PROGRAM_ACCURACY_MM]
        for one, other in ((begun, ended), (ended, begun))
    )
    short = [
        n for n, v in known.items() if n not in rows and PROGRAM_ACCURACY_MM < abs(v) < SHORTEST_VECTOR_WITH_HEAD_MM
    ]
    ways = [(abs(b - a - known[n]), n, (a, b)) for n in short for a in ended for b in begun]
    used = set[object]()
    for off, n, (a, b) in sorted(ways, key=lambda way: way[0]):
        if off < COINCIDENT_VECTORS_MM and not used & {n, a, b}:
            used |= {n, a, b}
            yield n, (a, b)


def _leads_back_beside(s: Stroke, o: Stroke) -> bool:
    """Whether one vector leads back beside another."""
    return abs(o[0] - s[1]) + abs(o[1] - s[0]) < OPPOSITE_VECTORS_GAP_RATIO * abs(vector_of(s))


def cheapest_assignment(table: Array) -> list[int]:
    """The column of each row, each used once, with the lowest total cost: by shortest augmenting paths."""
    rows, columns = table.shape
    row_of = numpy.full(columns, -1)
    for row in range(rows):
        cost = table[row].copy()
        before = numpy.full(columns, -1)
        while True:  # by another column for a row that holds one
            taken = numpy.flatnonzero(row_of >= 0)
            held = table[row_of[taken]]
            ways = cost[taken, None] - held[range(len(taken)), taken, None] + held
            least = ways.min(axis=0, initial=math.inf)
            better = least < cost - TINY
            if not better.any():
                break
            cost[better], before[better] = least[better], taken[ways.argmin(axis=0)[better]]
        here = int(numpy.where(row_of < 0, cost, math.inf).argmin())
        while before[here] >= 0:
            row_of[here], here = row_of[before[here]], int(before[here])
        row_of[here] = row
    return [int(numpy.flatnonzero(row_of == row)[0]) for row in range(rows)]
