"""Which mark is which on a drawing: by the words beside it, else by where the plan leads from the marks found.

A mark without a word is looked for where its step leads from the person's own earlier marks, rightly or by any
mistake of the catalogue; what is nowhere stays unread.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations, pairwise

from planes.check.grading.grading import NAMELESS
from planes.check.grading.handwork import Hand
from planes.check.grading.paper import ReadMark, ReadPaper
from planes.check.grading.prepared_plan import PreparedPlan, variants_of
from planes.check.grading.remedies import asking
from planes.check.reading.as_planned import marks_as_planned, unshown, vectors_named
from planes.check.reading.chains import MOST_LINES, force_chain, true_vectors
from planes.check.reading.construction_lines import covered, vectors_alone, vectors_of
from planes.check.reading.lone_vectors import HEADLESS_MM, lone_vectors, others
from planes.check.reading.running_on import cut_off
from planes.check.reading.strokes import LOOSE_MM, Nodes, ReadDrawing, headed, hinged
from planes.check.reading.weighed import is_right, told_apart, vague, worth
from planes.check.reading.words_near import Candidates, by_words, led, led_to_vectors, sized, start_of
from planes.check.reading.written import Words
from planes.words import Phrase
from planes.words.names import POLE, at, kind_of, label_of

APART_MM = 0.7  # two marks nearer than this are one place
WORDED = 0.6  # the share of marks with words from which on one without was not drawn
USED = 4.0  # how strange it is, in mm from its word, for a mark to be where another one is
DENSE = 80  # so many ends near one word leave nothing to choose by
LOOSE = 0.2  # of how far joined ends are apart, the error of where they are
DOT_MM = 0.8  # a line from a name ends in no larger dot
ALONG = 0.7  # the share of a vector that must be drawn for its end to count


def paper_of(sketch: ReadDrawing, bench: PreparedPlan) -> ReadPaper:
    """The marks of a plan found on a sketch."""
    paper = ReadPaper(sketch.file, whole=False)
    sketch = replace(sketch, words=[one for w in sketch.words for one in w.listed()])
    sketch = cut_off(sketch, bench) or sketch
    kind, vectors, dots = kind_of(bench.asked.plan), list[int](), [z for z, r in sketch.rounds if r < DOT_MM]
    if kind == "position":
        sketch = hinged(sketch)
        nodes = Nodes(sketch.strokes, LOOSE_MM if sketch.rounds else 0.0, points=[z for z, _ in sketch.rounds])
    else:
        sketch.rounds = []
        vectors = vectors_of(sketch, kind == "force")
        nodes = Nodes(sketch.strokes, vectors=vectors, passed=sketch.passed)
    if not nodes.places:
        paper.reason = Phrase("check_no_lines")
        return paper
    near = by_words([*sketch.words, *led(sketch, nodes)], nodes, bench.names)
    first = len(sketch.rounds) if len(sketch.rounds) >= len(bench.marks) else nodes.corners if vectors else None
    if first is not None:  # where marks are told from where lines merely cross or end
        near = {n: {i: far for i, far in held.items() if i < first} or held for n, held in near.items()}
    bench = sized(bench, sketch, nodes, near)
    if kind == "force":
        sides, beside = true_vectors(bench), others(bench)
        known = bench.naming.names({**beside, **sides})
        sketch.words = led_to_vectors(sketch, dots, known) if headed(sketch) else sketch.words
        named_paper = vectors_named(vectors_alone(sketch, vectors), bench, sides, beside.values())
        return named_paper if is_right(bench, named_paper) else _polygon(sketch, nodes, bench, paper)
    sketch = _joined(sketch, nodes)
    if nodes.crowded and (len(near) < 2 or max(map(len, near.values())) > DENSE):
        paper.reason = Phrase("check_crowd", count=len(nodes.places))
        return paper
    return _plan_of_marks(sketch, vectors_alone(sketch, vectors), nodes, bench, near, paper)


def _plan_of_marks(
    sketch: ReadDrawing, drawn: ReadDrawing, nodes: Nodes, bench: PreparedPlan, near: Candidates, paper: ReadPaper
) -> ReadPaper:
    """The marks of a plan of motion or a scheme; ``drawn`` are its vectors alone, where these are told."""
    labels = [label_of(m) for m in bench.marks]
    origin = start_of(sketch, nodes, bench, near)
    if origin is None:
        return paper
    poles = dict.fromkeys([origin, *(nodes.places[i] for i in near.get(POLE, ()))])
    pole_told = kind_of(bench.asked.plan) == "position" or POLE in near or bool(headed(sketch))
    planned = marks_as_planned(drawn, bench, near, poles)
    if planned.spots:
        return replace(planned, pole_told=pole_told)
    paper.pole_told = pole_told
    places, hidden = _marks(bench, sketch, nodes, origin, near), unshown(sketch, bench, origin)
    paper.spots = [ReadMark(POLE, origin, sketch.error_mm)]
    paper.spots += [ReadMark(n, places[n], sketch.error_mm) for n in labels if n in places and n not in hidden]
    tips = [stroke[way > 0] for stroke, way in zip(sketch.strokes, sketch.ways, strict=False) if way]
    if any(all(abs(z - w) > APART_MM for w in (origin, *places.values())) for z in tips):  # one is another mark's
        upon = [pair for pair in combinations(places, 2) if abs(places[pair[0]] - places[pair[1]]) < APART_MM]
        paper.untold = [n for n in labels if n not in near and any(n in pair for pair in upon)]
    return paper


def _joined(sketch: ReadDrawing, nodes: Nodes) -> ReadDrawing:
    """The sketch with its ends no surer than they are joined."""
    return replace(sketch, error_mm=max(sketch.error_mm, LOOSE * nodes.near))


def _polygon(sketch: ReadDrawing, nodes: Nodes, bench: PreparedPlan, paper: ReadPaper) -> ReadPaper:
    """The vectors of a force plan: as the chain they make up, else each by its arrowhead and name."""
    paper = force_chain(_joined(sketch, nodes), nodes, bench, paper)
    heads = headed(sketch)
    loose = (abs(b - a) < HEADLESS_MM for k, (a, b) in enumerate(sketch.strokes) if k not in heads)
    paper.whole = paper.whole and not (heads and any(loose))  # what is so short may be a vector all the same
    if not paper.whole and 0 < len(heads) <= MOST_LINES:
        rows, every = lone_vectors(sketch, bench)
        lone, named = replace(paper, spots=rows, whole=every), sum(not s.name.startswith("?") for s in paper.spots[1:])
        all_chained = named == len(paper.spots) - 1 == len(heads)  # one that no name fits is then no other's
        if every or 2 * named <= len(rows) or (not all_chained and worth(bench, lone) > worth(bench, paper)):
            paper = lone
    if paper.spots and vague(sketch, bench, paper):
        paper.spots = []
        paper.reason = asking("check_force_unsure")
    paper = told_apart(sketch, bench, paper)
    over = (one.name for one, two in pairwise(paper.spots) if two.name.startswith(NAMELESS))  # it may run on as that
    paper.untold += [n for n in over if n != POLE and not n.startswith(NAMELESS)]
    return paper


def _marks(
    bench: PreparedPlan, sketch: ReadDrawing, nodes: Nodes, origin: complex, near: Candidates
) -> dict[str, complex]:
    """Every mark in order of drawing, looked for where its word stands and where its step may lead."""
    worded = len(near) >= WORDED * (len(bench.marks) + 1)
    near = {n: dict(nodes_near) for n, nodes_near in near.items()}
    for _ in range(len(bench.marks)):
        desk = _MarkSearch(bench, sketch, nodes, origin, _tips(sketch, nodes), worded)
        for mark in bench.marks:
            if (place := desk.place(mark, near.get(label_of(mark)))) is not None:
                desk.found[label_of(mark)] = place
        better = desk.exchange()
        if better is None:
            break
        del near[better[0]][better[1]]
    return desk.found


def _tips(sketch: ReadDrawing, nodes: Nodes) -> set[int] | None:
    """Nodes with an arrowhead, or with the circle of a point; None where too few have one for that to tell anything."""
    if sketch.rounds:
        return {i for z, _ in sketch.rounds if (i := nodes.nearest(z, nodes.near)) is not None}
    return {nodes.ends[k, sketch.ways[k] > 0] for k in headed(sketch)} or None


@dataclass
class _MarkSearch:
    """A drawing on which marks are looked for, one after another."""

    bench: PreparedPlan
    sketch: ReadDrawing
    nodes: Nodes
    origin: complex
    tips: set[int] | None
    worded: bool  # whether nearly every mark has its word, so that one without was most likely not drawn
    found: dict[str, complex] = field(default_factory=dict)
    costs: dict[str, dict[int, float]] = field(default_factory=dict)  # of every node near its word, by mark
    odd: dict[str, set[int]] = field(default_factory=dict)  # those of them where another mark is, and should not be

    def used(self, name: str) -> list[complex]:
        """Where marks are already, but for those whose names stand in a row with this one: they are in one place."""
        row = {w.place for w in self.sketch.words if self.bench.names.find(w.text) == name}
        beside = {self.bench.names.find(w.text) for w in self.sketch.words if w.place in row}
        return [self.origin, *(z for n, z in self.found.items() if n not in beside)]

    def exchange(self) -> tuple[str, int] | None:
        """Of two marks at one node (it fits only one), the one that has another place nearly as good, and the node."""
        taken: dict[int, str] = {}
        for name, costs in self.costs.items():
            node = min(costs, key=lambda i: costs[i])
            if node in taken and node in self.odd.get(name, ()):
                one, two = self._regret(taken[node], node), self._regret(name, node) + USED
                if one < two:
                    return taken[node], node
            taken.setdefault(node, name)
        return None

    def _regret(self, name: str, node: int) -> float:
        """What it costs a mark to go elsewhere."""
        costs = self.costs[name]
        return min((c for i, c in costs.items() if i != node), default=1e9) - costs[node]

    def place(self, mark: str, near: Mapping[int, float] | None) -> complex | None:
        """Where a mark is: by its word, else where it should be, or where a mistake would put it."""
        name, plan, error = label_of(mark), self.bench.asked.plan, self.sketch.error_mm
        taken = {at(plan, n): ReadMark(n, z - self.origin, error) for n, z in self.found.items()}
        hand = Hand(self.bench.program, self.bench.given, self.bench.asked.skill, taken)
        miss = hand.miss(hand.things[mark], hand.number(mark))
        reach = min(max(miss.reach(3.0), 1.2), 8.0)
        guesses = [(self.origin + z, share * reach) for z, share in _guesses(self.bench, hand, mark)]
        used = self.used(name)
        if near:
            odd = self.odd[name] = {i for i in near if self._strange(i, guesses, used)}
            costs = self.costs[name] = {i: far + self._odd(i, guesses) + USED * (i in odd) for i, far in near.items()}
            return self.nodes.places[min(costs, key=lambda i: costs[i])]
        step = self.bench.program.makers[mark]
        before = (getattr(step, k, "") for k in ("start", "other", "end"))
        starts = [self.origin, *(taken[n].place + self.origin for n in before if n in taken)]
        for guess, far in guesses[:1] if self.worded else guesses:
            for i in self.nodes.within(guess, far):
                z = self.nodes.places[i]
                together = not self.worded and guess == guesses[0][0] and any(abs(u - guess) < far for u in used)
                drawn = any(covered(self.sketch.strokes, s, z) >= ALONG for s in starts)
                if drawn and (self._fresh(i, used) or together):
                    return z
        return None

    def _fresh(self, node: int, used: Sequence[complex]) -> bool:
        return all(abs(self.nodes.places[node] - u) > APART_MM for u in used)

    def _odd(self, node: int, guesses: list[tuple[complex, float]]) -> float:
        """How strange it would be, in mm of distance from its word, for a mark to be at a node."""
        z = self.nodes.places[node]
        fits = [abs(z - guess) <= far for guess, far in guesses]
        odd = 0.0 if fits[0] else 1.5 if any(fits) else 3.0
        return odd + (2.0 if self.tips is not None and node not in self.tips else 0.0)

    def _strange(self, node: int, guesses: list[tuple[complex, float]], used: Sequence[complex]) -> bool:
        """Whether another mark is at a node already, where the two should not be together."""
        place, reach = guesses[0]
        together = any(abs(u - place) < reach for u in used) and abs(self.nodes.places[node] - place) <= reach
        return not self._fresh(node, used) and not together


def _guesses(bench: PreparedPlan, hand: Hand, mark: str) -> Iterator[tuple[complex, float]]:
    """Where a mark should be, and where each mistake would put it; with how far to look around."""
    yield hand.number(mark), 1.0
    for variant in variants_of(bench, hand.taken, bench.said_mu):
        if variant.blames == label_of(mark):
            made = hand.under(variant).get(mark)
            if made is not None:
                yield complex(hand.tool.spread(made)[0]), 0.6


def scaled(
    sketch: ReadDrawing, bench: PreparedPlan, pole: complex | None, marks: Mapping[str, complex]
) -> tuple[ReadDrawing, str | None]:
    """The sketch with its scale set by a named pole and a named vector; the vector's name."""
    named, place = next(iter(marks.items()), ("", pole))
    name = bench.names.find(named)
    if pole is None or place is None or name is None or place == pole:
        return sketch, None
    factor = abs(bench.true_marks[name]) / abs(place - pole)
    words = [
        Words(w.text, (w.place - pole) * factor, w.height * factor, w.width * factor, w.along) for w in sketch.words
    ]
    words += [Words(n, (z - pole) * factor, 0.1, 0.1) for n, z in {POLE: pole, **marks}.items()]
    strokes = [((a - pole) * factor, (b - pole) * factor) for a, b in sketch.strokes]
    passed = [(z - pole) * factor for z in sketch.passed]
    return ReadDrawing(sketch.file, strokes, words, sketch.error_mm, sketch.ways, passed=passed), name
