"""Which mark is which on a drawing: by the words beside it, else by where the plan leads from the marks found.

A mark without a word is looked for where its step leads from the person's own earlier marks, rightly or by any
mistake of the catalogue; what is nowhere stays unread.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from planes.check.bench import Bench, variants_of
from planes.check.chains import force_chain
from planes.check.handwork import Hand, Taken
from planes.check.paper import Paper, Spot
from planes.check.strokes import Nodes, Sketch, Words, covered
from planes.drawing import run
from planes.mark_names import Names, tidy
from planes.naming import POLE, at, label_of
from planes.scales import kind_of
from planes.words import Phrase

NEAR_WORD_MM = 12.0  # a word farther from a node names something else
POLE_MM = 2.7  # ends nearer than this to a printed pole are at it
ALONG = 0.7  # the share of a vector that must be drawn for its end to count


def paper_of(sketch: Sketch, bench: Bench, pole: complex | None = None) -> Paper:
    """The marks of a plan found on a sketch; its pole may be known beforehand."""
    paper = Paper(sketch.file, whole=False)
    if pole is not None:
        sketch.strokes = [(_at(pole, a), _at(pole, b)) for a, b in sketch.strokes if _at(pole, a) != _at(pole, b)]
    nodes = Nodes(sketch.strokes)
    if not nodes.places:
        paper.notes.append(Phrase("check_no_lines"))
        return paper
    labels = [label_of(m) for m in bench.marks]
    if kind_of(bench.asked.plan) == "force":
        return force_chain(sketch, nodes, bench, paper)
    near = by_words(sketch.words, nodes, labels)
    if nodes.crowded and len(near) < 2:
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
    plan, found = bench.asked.plan, dict[str, complex]()
    used = [origin]
    for mark in bench.marks:
        name = label_of(mark)
        taken = {at(plan, n): Taken(z - origin, sketch.error_mm) for n, z in found.items()}
        place = _look(bench, sketch, nodes, origin, taken, mark, used, near.get(name))
        if place is not None:
            found[name] = place
            used.append(place)
    return found


def _look(
    bench: Bench, sketch: Sketch, nodes: Nodes, origin: complex, taken: Mapping[str, Taken], mark: str,
    used: list[complex], near: Mapping[int, float] | None,
) -> complex | None:  # fmt: skip
    """The node of one mark: where it should be, else where a mistake would put it, else the nearest to its word."""
    hand = Hand(bench.program, bench.given, bench.asked.skill, taken)
    step = next(s for s in bench.program.steps if s.makes == mark)
    miss = hand.miss(hand.things[mark], hand.number(mark))
    reach = min(max(miss.reach(3.0), 1.2), 8.0)
    starts = [origin, *(taken[n].place + origin for n in _starts(step) if n in taken)]
    for guess, share in _guesses(bench, hand, mark, step):
        for i in nodes.within(origin + guess, reach * share):
            z = nodes.places[i]
            fresh = all(abs(z - u) > 0.7 for u in used) or (near is not None and i in near)
            if share == 1.0:  # two marks where one should be
                fresh = fresh or any(abs(u - origin - guess) < reach for u in used)
            drawn = near is not None or any(
                covered(sketch.strokes, s, z) >= ALONG for s in starts)
            if fresh and drawn and (near is None or i in near):
                return z
    fresh_near = {i: d for i, d in (near or {}).items() if all(abs(nodes.places[i] - u) > 0.7 for u in used)}
    return nodes.places[min(fresh_near, key=lambda i: fresh_near[i])] if fresh_near else None


def _guesses(bench: Bench, hand: Hand, mark: str, step: object) -> Iterator[tuple[complex, float]]:
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
    return Sketch(sketch.file, strokes, words, sketch.error_mm, sketch.arrows), name
