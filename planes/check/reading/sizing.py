"""The size a person drew a plan at, from the words beside its marks or vectors: the scale is the drawer's choice."""

from __future__ import annotations

import math
import statistics
from collections.abc import Mapping
from itertools import combinations

from planes.check.grading.prepared_plan import PreparedPlan
from planes.check.reading.chains import true_vectors
from planes.check.reading.strokes import Nodes, ReadDrawing
from planes.drafting.drawing import run
from planes.words.names import POLE, kind_of, label_of

LEAST_MM = 4.0  # shorter vectors tell little about the scale
SAME = math.log(1.05)  # the stated scale, as far as words can tell
ALIKE = math.log(1.15)  # lengths that speak of one scale
NEAR_MM = 9.0


def sized(
    bench: PreparedPlan, sketch: ReadDrawing, nodes: Nodes, near: Mapping[str, Mapping[int, float]]
) -> PreparedPlan:
    """The plan at the scale most of the named marks or vectors show, unless the scale was told."""
    if bench.asked.mu:
        return bench
    force = kind_of(bench.asked.plan) == "force"
    ratio = _agreed(_of_vectors(bench, sketch) if force else _of_marks(bench, nodes, near))
    if abs(ratio) < SAME:
        return bench
    return bench.at(bench.said_mu * math.exp(ratio))


def _of_marks(bench: PreparedPlan, nodes: Nodes, near: Mapping[str, Mapping[int, float]]) -> list[float]:
    """Logarithms of drawn to stated distances from the pole, of a scheme between its points."""
    truth = {label_of(m): run(bench.program, bench.given)[m] for m in bench.marks} | {POLE: 0j}
    place = {n: nodes.places[min(held, key=lambda i: held[i])] for n, held in near.items() if n in truth}
    pairs = [(POLE, n) for n in place if n != POLE] if POLE in place else list(combinations(place, 2))
    found = []
    for one, two in pairs if POLE in place or bench.asked.plan == "position" else ():
        true, drawn = abs(truth[one] - truth[two]), abs(place[one] - place[two])
        found += [math.log(drawn / true)] if min(true, drawn) > LEAST_MM else []
    return found


def _of_vectors(bench: PreparedPlan, sketch: ReadDrawing) -> list[float]:
    """Logarithms of drawn to stated lengths of the vectors nearest to their words."""
    truth = true_vectors(bench)
    known, found = bench.written(truth), []
    for word in sketch.words:
        name = known.find(word.text)
        if name is None or name == POLE or abs(truth[name]) < LEAST_MM:
            continue
        middles = ((word.distance((a + b) / 2), abs(b - a)) for a, b in sketch.strokes)
        far, length = min(middles, default=(math.inf, 0.0))
        found += [math.log(length / abs(truth[name]))] if far < NEAR_MM and length > LEAST_MM else []
    return found


def _agreed(ratios: list[float]) -> float:
    """The logarithm most of them agree on, nearest to none if several do; 0 where there is no agreement."""
    if len(ratios) < 2:
        return 0.0
    groups = [[r for r in ratios if abs(r - one) < ALIKE] for one in ratios]
    best = max(groups, key=lambda g: (len(g), -abs(statistics.median(g))))
    return statistics.median(best) if len(best) >= max(2, 0.5 * len(ratios)) else 0.0
