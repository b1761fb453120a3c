"""Which mark is which on a drawing: by the words beside it, else by where the plan leads from the marks found.

A mark without a word is looked for where its step leads from the person's own earlier marks, rightly or by any
mistake of the catalogue; what is nowhere stays unread.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace

from planes.check.bench import Bench, variants_of
from planes.check.chains import force_chain
from planes.check.handwork import Hand, Taken
from planes.check.paper import Paper, Spot
from planes.check.sizing import sized
from planes.check.strokes import Nodes, Sketch, Words, covered
from planes.drawing import run
from planes.mark_names import Names, tidy
from planes.naming import POLE, at, label_of
from planes.scales import kind_of
from planes.words import Phrase

NEAR_WORD_MM = 12.0  # a word farther from a node names something else
POLE_MM = 2.7  # ends nearer than this to a printed pole are at it
APART_MM = 0.7  # two marks nearer than this are one place
WORDED = 0.6  # the share of marks with words from which on one without was not drawn
USED = 4.0  # how strange it is, in mm from its word, for a mark to be where another one is
HEADED = 0.5  # the share of strokes with arrowheads from which on a mark has one
DENSE = 80  # so many ends near one word leave nothing to choose by
LOOSE = 0.2  # of how far joined ends are apart, the error of where they are
ALONG = 0.7  # the share of a vector that must be drawn for its end to count


def paper_of(sketch: Sketch, bench: Bench, pole: complex | None = None) -> Paper:
    """The marks of a plan found on a sketch; its pole may be known beforehand."""
    paper = Paper(sketch.file, whole=False)
    if pole is not None:
        sketch.strokes = [(_at(pole, a), _at(pole, b)) for a, b in sketch.strokes if _at(pole, a) != _at(pole, b)]
    nodes = Nodes(sketch.strokes)
    sketch.error_mm = max(sketch.error_mm, LOOSE * nodes.near)
    if not nodes.places:
        paper.notes.append(Phrase("check_no_lines"))
        return paper
    labels = [label_of(m) for m in bench.marks]
    near = by_words(sketch.words, nodes, labels)
    bench = sized(bench, sketch, nodes, near)
    if kind_of(bench.asked.plan) == "force":
        return force_chain(sketch, nodes, bench, paper)
    if nodes.crowded and (len(near) < 2 or max(map(len, near.values())) > DENSE):
        paper.notes.append(Phrase("check_crowd", count=len(nodes.places)))
        return paper
    origin = pole if pole is not None else _pole(nodes, bench, near)
    if origin is None:
        return paper
    places = _marks(bench, sketch, nodes, origin, near)
    paper.spots = [Spot(POLE, origin, sketch.error_mm)]
    paper.spots += [Spot(n, places[n], sketch.error_mm) for n in labels if n in places]
    return paper


def _at(pole: complex, z: complex) -> complex:
    """An end so near the pole that it must be there."""
    return pole if abs(z - pole) < POLE_MM else z


Candidates = dict[str, dict[int, float]]


def by_words(words: Iterable[Words], nodes: Nodes, labels: Iterable[str]) -> Candidates:
    """Nodes near the word of every mark, with the distance from the word."""
    names, found = Names(labels), Candidates()
    for word in words:
        name = names.find(word.text)
        if name is None or (tidy(word.text) != tidy(name) and name != POLE):
            continue
        middle = word.place + word.along * complex(word.width or word.height, word.height) / 2
        for node in nodes.within(middle, NEAR_WORD_MM + word.width):
            distance = word.distance(nodes.places[node]) + (2.0 if node >= nodes.corners else 0.0)
            if distance <= NEAR_WORD_MM:
                near = found.setdefault(name, {})
                near[node] = min(distance, near.get(node, distance))
    return found


def _pole(nodes: Nodes, bench: Bench, near: Candidates) -> complex | None:
    """The node from which the true plan would meet most nodes, one beside the word p if there is any."""
    truth = run(bench.program, bench.given)
    ends = [truth[m] for m in bench.marks if abs(truth[m]) > 1]
    beside = near.get(POLE)
    if not ends or (not beside and len(nodes.places) > 600):
        return None
    scores = []
    for i in beside or range(len(nodes.places)):
        z = nodes.places[i]
        hits = sum(nodes.nearest(z + e, 2.5) is not None for e in ends)
        scores.append((hits - (0.5 * beside[i] if beside else 0.0), nodes.weights[i], i))
    best = max(scores)
    return nodes.places[best[2]] if beside or best[0] >= max(2, 0.5 * len(ends)) else None


def _marks(bench: Bench, sketch: Sketch, nodes: Nodes, origin: complex, near: Candidates) -> dict[str, complex]:
    """Every mark in order of drawing, looked for where its word stands and where its step may lead."""
    worded = len(near) >= WORDED * (len(bench.marks) + 1)
    near = {n: dict(nodes_near) for n, nodes_near in near.items()}
    for _ in range(len(bench.marks)):
        desk = _Desk(bench, sketch, nodes, origin, _tips(sketch, nodes), worded)
        for mark in bench.marks:
            desk.look(mark, near.get(label_of(mark)))
        better = desk.exchange()
        if better is None:
            break
        del near[better[0]][better[1]]
    return desk.found


def _tips(sketch: Sketch, nodes: Nodes) -> set[int] | None:
    """Nodes with an arrowhead; None where too few lines have one for that to tell anything."""
    headed = [k for k, way in enumerate(sketch.ways) if way]
    if len(headed) < HEADED * max(len(sketch.strokes), 1):
        return None
    return {nodes.ends[k, 1 if sketch.ways[k] > 0 else 0] for k in headed}


@dataclass
class _Desk:
    """A drawing on which marks are looked for, one after another."""

    bench: Bench
    sketch: Sketch
    nodes: Nodes
    origin: complex
    tips: set[int] | None
    worded: bool  # whether nearly every mark has its word, so that one without was most likely not drawn
    found: dict[str, complex] = field(default_factory=dict)
    costs: dict[str, dict[int, float]] = field(default_factory=dict)  # of every node near its word, by mark

    @property
    def used(self) -> list[complex]:
        """Where marks are already."""
        return [self.origin, *self.found.values()]

    def look(self, mark: str, near: Mapping[int, float] | None) -> None:
        """Find one mark by its word, else by where it should be, or by where a mistake would put it."""
        plan, name = self.bench.asked.plan, label_of(mark)
        taken = {at(plan, n): Taken(z - self.origin, self.sketch.error_mm) for n, z in self.found.items()}
        place = self._place(taken, mark, name, near)
        if place is not None:
            self.found[name] = place

    def exchange(self) -> tuple[str, int] | None:
        """Of two marks at one node (it fits only one), the one that has another place nearly as good, and the node."""
        taken: dict[int, str] = {}
        for name, costs in self.costs.items():
            node = min(costs, key=lambda i: costs[i])
            if node in taken and costs[node] >= USED:
                one, two = self._regret(taken[node], node), self._regret(name, node) + USED
                if one < two:
                    return taken[node], node
            taken.setdefault(node, name)
        return None

    def _regret(self, name: str, node: int) -> float:
        """What it costs a mark to go elsewhere."""
        costs = self.costs[name]
        return min((c for i, c in costs.items() if i != node), default=1e9) - costs[node]

    def _place(
        self, taken: Mapping[str, Taken], mark: str, name: str, near: Mapping[int, float] | None
    ) -> complex | None:
        hand = Hand(self.bench.program, self.bench.given, self.bench.asked.skill, taken)
        miss = hand.miss(hand.things[mark], hand.number(mark))
        reach = min(max(miss.reach(3.0), 1.2), 8.0)
        guesses = [(self.origin + z, share * reach) for z, share in _guesses(self.bench, hand, mark)]
        if near:
            costs = self.costs[name] = {i: far + self._odd(i, guesses) for i, far in near.items()}
            return self.nodes.places[min(costs, key=lambda i: costs[i])]
        step = next(s for s in self.bench.program.steps if s.makes == mark)
        starts = [self.origin, *(taken[n].place + self.origin for n in _starts(step) if n in taken)]
        for guess, far in guesses[:1] if self.worded else guesses:
            for i in self.nodes.within(guess, far):
                z = self.nodes.places[i]
                together = not self.worded and guess == guesses[0][0] and any(abs(u - guess) < far for u in self.used)
                if (self._fresh(i) or together) and any(covered(self.sketch.strokes, s, z) >= ALONG for s in starts):
                    return z
        return None

    def _fresh(self, node: int) -> bool:
        return all(abs(self.nodes.places[node] - u) > APART_MM for u in self.used)

    def _odd(self, node: int, guesses: list[tuple[complex, float]]) -> float:
        """How strange it would be, in mm of distance from its word, for a mark to be at a node."""
        z = self.nodes.places[node]
        fits = [abs(z - guess) <= far for guess, far in guesses]
        odd = 0.0 if fits[0] else 1.5 if any(fits) else 3.0
        together = any(abs(u - guesses[0][0]) < guesses[0][1] for u in self.used)  # as they should be
        odd += 0.0 if self._fresh(node) or (fits[0] and together) else USED
        return odd + (2.0 if self.tips is not None and node not in self.tips else 0.0)


def _guesses(bench: Bench, hand: Hand, mark: str) -> Iterator[tuple[complex, float]]:
    """Where a mark should be, and where each mistake would put it; with how far to look around."""
    yield hand.number(mark), 1.0
    for variant in variants_of(bench, hand, bench.said_mu):
        if variant.blames == label_of(mark):
            made = hand.under(variant).get(mark)
            if made is not None:
                yield complex(hand.tool.spread(made)[0]), 0.6


def _starts(step: object) -> list[str]:
    return [getattr(step, k) for k in ("start", "other", "end") if hasattr(step, k)]


def scaled(
    sketch: Sketch, bench: Bench, pole: complex | None, marks: Mapping[str, complex]
) -> tuple[Sketch, str | None]:
    """The sketch with its scale set by a named pole and a named vector; the vector's name."""
    named = next(iter(marks), None)
    if pole is None or named is None:
        return sketch, None
    name = Names(label_of(m) for m in bench.marks).find(named)
    if name is None or abs(marks[named] - pole) == 0:
        return sketch, None
    truth = run(bench.program, bench.given)
    factor = abs(truth[at(bench.asked.plan, name)]) / abs(marks[named] - pole)
    words = [replace(w, place=(w.place - pole) * factor, height=w.height * factor, width=w.width * factor)
             for w in sketch.words]  # fmt: skip
    words.append(Words("p", 0j, 0.1, 0.1))
    words += [Words(n, (z - pole) * factor, 0.1, 0.1) for n, z in marks.items()]
    strokes = [((a - pole) * factor, (b - pole) * factor) for a, b in sketch.strokes]
    return Sketch(sketch.file, strokes, words, sketch.error_mm, sketch.ways), name
