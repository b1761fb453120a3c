"""Force polygons on a drawing: the strokes as one chain of vectors, each named by its word or by its likeness."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise

from planes.check.bench import Bench
from planes.check.paper import Paper, Spot
from planes.check.polygons import sides_of
from planes.check.strokes import Nodes, Sketch, Words
from planes.drawing import run
from planes.mark_names import Names
from planes.naming import POLE, at

NEAR_MM = 9.0
NO_WORD, FAR_WORD, UNLIKE, TOO_FAR = 5.0, 9.0, 7.0, 13.0  # what a name may cost, mm of distance from its word
LONGEST = 26  # vectors in a polygon
Edge = tuple[int, int]


def force_chain(sketch: Sketch, nodes: Nodes, bench: Bench, paper: Paper) -> Paper:
    """The polygon as rows: the pole, then the end of every vector in the order they were drawn."""
    truth = true_vectors(bench)
    pole = _pole(sketch.words, nodes)
    for split in (False, True):
        edges = _edges(sketch, nodes, split)
        if not edges or len(edges) > 4 * LONGEST:
            continue
        words = beside(sketch.words, nodes, edges, truth)
        best: tuple[float, list[Spot], bool] | None = None
        for chain in _chains(edges, pole, _twice(sketch, nodes)):
            rows = _rows(chain, nodes, words, truth, sketch.error_mm)
            whole = len(chain) - 1 in (len(edges), len(sketch.strokes)) and chain[0] == chain[-1]
            if rows and (best is None or rows[0] + 0.5 * whole > best[0]):
                best = rows[0] + 0.5 * whole, rows[1], whole
        if best and (best[2] or split or best[0] > 0.4 * len(truth)):
            paper.spots, paper.whole = best[1], best[2]
            return paper
    return paper


def true_vectors(bench: Bench) -> dict[str, complex]:
    """Every vector of the right plan by name."""
    plan = bench.asked.plan
    made = run(bench.program, bench.given)
    found = {}
    for s in sides_of(bench.plans, plan):
        ends = [0j if n == POLE else made[at(plan, n)] for n in (s.start, s.end)]
        found[s.name] = complex(ends[1] - ends[0])
    return found


def _edges(sketch: Sketch, nodes: Nodes, split: bool) -> list[Edge]:
    """Pairs of nodes joined by a stroke; if ``split``, a stroke through a node is two."""
    found: dict[Edge, None] = {}
    for k, (a, b) in enumerate(sketch.strokes):
        i, j = nodes.ends[k, 0], nodes.ends[k, 1]
        if i == j:
            continue
        u = (b - a) / abs(b - a)
        inside = []
        for n in range(nodes.corners if split else 0):
            local = (nodes.places[n] - a) * u.conjugate()
            if n not in (i, j) and abs(local.imag) < 0.5 and 1 < local.real < abs(b - a) - 1:
                inside.append((local.real, n))
        way = [i, *(n for _, n in sorted(inside)), j]
        for one, two in pairwise(way):
            found.setdefault((min(one, two), max(one, two)))
    return list(found)


def beside(
    words: Sequence[Words], nodes: Nodes, edges: Sequence[Edge], truth: Mapping[str, complex]
) -> dict[str, dict[Edge, float]]:
    """How far every vector's name stands from the middle part of every edge near it."""
    known = Names(truth)
    found: dict[str, dict[Edge, float]] = {}
    for word in words:
        name = known.find(word.text)
        if name is None or name == POLE:
            continue
        for edge in edges:
            a, b = nodes.places[edge[0]], nodes.places[edge[1]]
            near = min(word.distance(a + (b - a) * t / 8) for t in range(1, 8))
            if near <= NEAR_MM:
                middle = abs((a + b) / 2 - word.place) / max(abs(b - a), 5.0)
                found.setdefault(name, {})[edge] = near + 2 * min(middle, 1.0)
    return found


def _pole(words: Sequence[Words], nodes: Nodes) -> int | None:
    names = Names([])
    for word in words:
        if names.find(word.text) == POLE:
            middle = word.place + word.along * complex(word.width or word.height, word.height) / 2
            near = sorted(nodes.within(middle, 14.0), key=lambda i: word.distance(nodes.places[i]))
            near = [i for i in near if i < nodes.corners]
            if near and word.distance(nodes.places[near[0]]) < NEAR_MM + 1:
                return near[0]
    return None


def _twice(sketch: Sketch, nodes: Nodes) -> set[Edge]:
    """Edges along which two vectors lie, there and back."""
    ends = [tuple(sorted((nodes.ends[k, 0], nodes.ends[k, 1]))) for k in range(len(sketch.strokes))]
    return {(a, b) for a, b in ends if ends.count((a, b)) > 1}


def _chains(edges: Sequence[Edge], pole: int | None, twice: set[Edge]) -> Iterator[list[int]]:
    """Ways round the polygon, from the pole or from anywhere."""
    next_to: dict[int, list[int]] = {}
    for a, b in edges:
        next_to.setdefault(a, []).append(b)
        next_to.setdefault(b, []).append(a)
    starts = [pole] if pole is not None and pole in next_to else list(next_to)
    count, seen = 0, 0
    for start in starts[:20]:
        stack = [[start]]
        while stack and seen < 20000:
            way = stack.pop()
            seen += 1
            for n in next_to[way[-1]]:
                if n == start and (len(way) > 2 or (min(way), max(way)) in twice):
                    count += 1
                    yield [*way, n]
                elif n not in way and len(way) <= LONGEST:
                    stack.append([*way, n])
            if len(way) > 2 and pole is not None and all(n in way for n in next_to[way[-1]]):
                yield way
            if count > 400:
                return


def _rows(
    chain: list[int], nodes: Nodes, words: Mapping[str, Mapping[Edge, float]], truth: Mapping[str, complex],
    error_mm: float,
) -> tuple[float, list[Spot]] | None:  # fmt: skip
    """The chain's vectors named by the words beside them and by their likeness, with how well all this fits."""
    ends = [nodes.places[i] for i in chain]
    vectors = [b - a for a, b in pairwise(ends)]
    keys = [(min(a, b), max(a, b)) for a, b in pairwise(chain)]
    costs = []
    for i, (v, key) in enumerate(zip(vectors, keys, strict=True)):
        for n, t in truth.items():
            far = NO_WORD if n not in words else words[n].get(key, FAR_WORD)
            costs.append((far + UNLIKE * min(1.0, abs(v - t) / (abs(t) + 3)), i, n))
    names: list[str | None] = [None] * len(vectors)
    score = 0.0
    for cost, i, n in sorted(costs):
        if names[i] is None and n not in names and cost < TOO_FAR:
            names[i] = n
            score += TOO_FAR - cost
    if not any(names):
        return None
    start = Spot(POLE, ends[0], error_mm)
    rows = [Spot(n or f"?{i}", z, error_mm) for i, (n, z) in enumerate(zip(names, ends[1:], strict=True))]
    return (score - 3 * names.count(None)) / TOO_FAR, [start, *rows]
