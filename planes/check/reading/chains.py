"""Force polygons on a drawing: the strokes as one chain of vectors, each named by its word or by its likeness."""

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations, pairwise

from planes.check.grading.paper import ReadMark, ReadPaper
from planes.check.grading.polygons import sides_of
from planes.check.grading.prepared_plan import PreparedPlan
from planes.check.grading.remedies import asking
from planes.check.reading.construction_lines import vectors_of
from planes.check.reading.strokes import Nodes, ReadDrawing
from planes.check.reading.written import Stroke, Words
from planes.words.frozen import frozen
from planes.words.names import POLE
from planes.words.naming import Names, Naming

NEAR_MM = 9.0
NO_WORD, FAR_WORD, UNLIKE, TOO_FAR = 5.0, 9.0, 7.0, 13.0  # what a name may cost, mm of distance from its word
NAMED_UNLIKE = 3.0  # what is written counts for more than what is likely
SURELY_MM = 0.5  # of two vectors there and back a name is that of the one so much nearer
NARROW, WIDE = 0.1, 0.2  # of their length, how far apart the ends of two vectors there and back may be
TIP = 8.0  # of two vectors upon each other a name belongs to the one whose tip is nearer
MIDDLE = 0.21  # unless it stands so near the middle of both, in lengths
LONGEST = 26  # vectors in a polygon
MOST_LINES = 4 * LONGEST
ENOUGH = 0.4  # of how well a polygon may fit, for no line of it to be split
WHOLE = 0.5  # how much a polygon that leaves no line over is to be preferred
MOST_TRAILS, MOST_SEEN = 400, 20000


@frozen
class Edge:
    """A line between two nodes, drawn on either way or, where an arrowhead says so, ``onward`` only; it is ``drawn``
    near its nodes: forces of one line stand side by side."""

    start: int
    end: int
    drawn: Stroke
    onward: bool = False

    def other(self, node: int) -> int:
        """The node at the other end."""
        return self.end if node == self.start else self.start


Trail = list[tuple[Edge, int]]  # lines passed, each with the node it is left at
Beside = dict[str, dict[tuple[Edge, int], float]]  # how far names stand from lines passed to either end


def force_chain(sketch: ReadDrawing, nodes: Nodes, bench: PreparedPlan, paper: ReadPaper) -> ReadPaper:
    """The polygon as rows: the pole, then the end of every vector in the order they were drawn; none where no arrowhead
    tells and a line is left over, or a vector is none of the plan's."""
    truth, best = true_vectors(bench), None  # how well it fits, its rows, whether it is whole, and passes every line
    pole = _pole(sketch.words, nodes)
    for split in (False, True):
        few = not split or len(sketch.strokes) <= MOST_LINES
        edges = _reached(_edges(sketch, nodes, split), pole) if few else []
        if not edges or len(edges) > MOST_LINES:
            continue
        words = beside(sketch.words, nodes, edges, bench.naming.names(truth))
        for start, trail in _trails(edges, pole):
            rows = _rows(start, trail, nodes, words, truth, sketch)
            closed = trail[-1][1] == start and len(trail) == len(edges)
            if rows and (best is None or rows[0] + WHOLE * closed > best[0]):
                best = rows[0] + WHOLE * closed, rows[1], closed, len(trail) == len(edges)
        if best and (best[2] or best[0] > ENOUGH * len(truth)) and not nodes.passed:
            break
    if best and not any(sketch.ways) and not (best[3] and all(row.name in truth for row in best[1][1:])):
        paper.reason = asking("check_force_unsure")
    elif best:
        paper.spots, paper.whole = best[1], best[2]
    return paper


def true_vectors(bench: PreparedPlan) -> dict[str, complex]:
    """Every vector of the right plan by name."""
    places = {**bench.true_marks, POLE: 0j}
    return {s.name: places[s.end] - places[s.start] for s in sides_of(bench.plans, bench.asked.plan)}


def _edges(sketch: ReadDrawing, nodes: Nodes, split: bool) -> list[Edge]:
    """Nodes joined by strokes; if ``split``, a stroke through a node is two."""
    edges: list[Edge] = []
    for k in vectors_of(sketch, True) or range(len(sketch.strokes)):
        a, b = sketch.strokes[k]
        i, j = nodes.ends[k, 0], nodes.ends[k, 1]
        if (way := sketch.way(k)) < 0:
            (a, b), (i, j) = (b, a), (j, i)
        u = (b - a) / abs(b - a)
        inside = list[tuple[float, int]]()
        for n in {*range(nodes.corners), *nodes.passed} if split else ():
            local = (nodes.places[n] - a) * u.conjugate()
            if n not in (i, j) and abs(local.imag) < 0.5 and 1 < local.real < abs(b - a) - 1:
                inside.append((local.real, n))
        path = [(i, a), *((n, nodes.places[n]) for _, n in sorted(inside)), (j, b)]
        edges += [Edge(one, two, (z, w), way != 0) for (one, z), (two, w) in pairwise(path) if one != two]
    return edges


def _reached(edges: list[Edge], pole: int | None) -> list[Edge]:
    """The lines that hang together with the pole; all of them where it is not known."""
    if pole is None:
        return edges
    seen = {pole}
    while more := {n for e in edges if (e.start in seen) != (e.end in seen) for n in (e.start, e.end)}:
        seen |= more
    return [e for e in edges if e.start in seen]


def beside(words: Sequence[Words], nodes: Nodes, edges: Sequence[Edge], known: Names) -> Beside:
    """How far every vector's name stands from the middle part of every line near it, passed to either end."""
    costs_of: Beside = {}
    for word in words:
        name = known.find(word.text)
        if name is None or name == POLE:
            continue
        for edge in edges:
            for end, (a, b) in ((edge.end, edge.drawn), (edge.start, edge.drawn[::-1])):
                if (far := word.beside((a, b))) <= NEAR_MM and word.runs((a, b), words):
                    middle = abs((a + b) / 2 - word.place) / max(abs(b - a), 5.0)
                    upon = any(_there_and_back(nodes, edge, e) for e in edges)
                    cost = far + 2 * min(middle, 1.0) - upon * TIP * ahead_of(word, (a, b))
                    costs = costs_of.setdefault(name, {})
                    costs[edge, end] = min(cost, costs.get((edge, end), cost))
    return costs_of


def ahead_of(word: Words, stroke: Stroke) -> float:
    """How far ahead of the middle of a vector a word stands, in its lengths; nothing where it is too near to tell."""
    a, b = stroke
    ahead = min(max(((word.middle - a) / (b - a)).real, 0.0), 1.0) - 0.5
    return ahead if abs(ahead) > MIDDLE else 0.0


def _there_and_back(nodes: Nodes, one: Edge, two: Edge) -> bool:
    """Whether two lines lie upon each other, one going where the other comes from."""
    a, b, c, d = (nodes.places[n] for n in (one.start, one.end, two.start, two.end))
    return one is not two and back_and_forth(a, b, c, d)


def back_and_forth(a: complex, b: complex, c: complex, d: complex, share: float = NARROW) -> bool:
    """Whether a vector from c to d goes back where one from a to b came from, or nearly there."""
    return max(abs(a - d), abs(b - c)) < share * abs(b - a)


def alongside(a: complex, b: complex, c: complex, d: complex) -> bool:
    """Whether one vector lies beside another, whichever way it goes."""
    return back_and_forth(a, b, c, d, WIDE) or back_and_forth(a, b, d, c, WIDE)


def _pole(words: Sequence[Words], nodes: Nodes) -> int | None:
    names = Naming().names(())
    for word in words:
        if names.find(word.text) == POLE:
            near = sorted(nodes.within(word.middle, 14.0), key=lambda i: word.distance(nodes.places[i]))
            near = [i for i in near if i < nodes.corners]
            if near and word.distance(nodes.places[near[0]]) < NEAR_MM + 1:
                return near[0]
    return None


def _trails(edges: Sequence[Edge], pole: int | None) -> Iterator[tuple[int, Trail]]:
    """Ways along the lines, none passed twice: round from the pole or from anywhere, or from the pole to a dead end."""
    beside_of: dict[int, list[int]] = defaultdict(list)
    for k, edge in enumerate(edges):
        for node in (edge.start,) if edge.onward else (edge.start, edge.end):
            beside_of[node].append(k)
    starts = [pole] if pole is not None and pole in beside_of else list(beside_of)
    count, seen = 0, 0
    for start in starts[:20]:
        stack: list[tuple[int, list[int], Trail]] = [(start, [], [])]
        while stack and seen < MOST_SEEN and count < MOST_TRAILS:
            node, passed, trail = stack.pop()
            seen += 1
            ahead = [k for k in beside_of[node] if k not in passed]
            if trail and (node == start or (pole is not None and not ahead)):
                count += 1
                yield start, trail
            if len(trail) < LONGEST:
                stack += [(z := edges[k].other(node), [*passed, k], [*trail, (edges[k], z)]) for k in ahead]


def _rows(
    pole: int, trail: Trail, nodes: Nodes, words: Beside, truth: Mapping[str, complex], sketch: ReadDrawing
) -> tuple[float, list[ReadMark]] | None:
    """A trail's vectors named by the words beside them and by their likeness, with how well all this fits."""
    ends = [nodes.places[i] for i in (pole, *(node for _, node in trail))]
    vectors = [b - a for a, b in pairwise(ends)]
    costs: list[dict[str, float]] = []
    for v, passed in zip(vectors, trail, strict=True):
        far = {n: words[n].get(passed, FAR_WORD) if n in words else NO_WORD for n in truth}
        unlike = {n: min(1.0, abs(v - t) / (abs(t) + 3)) for n, t in truth.items()}
        costs.append({n: far[n] + (NAMED_UNLIKE if n in words else UNLIKE) * unlike[n] for n in truth})
    names = named_best(costs)
    if not any(names):
        return None
    _by_words(names, trail, ends, words, sketch)
    score = sum(TOO_FAR - cost[n] for n, cost in zip(names, costs, strict=True) if n)
    start = ReadMark(POLE, ends[0], sketch.error_mm)
    rows = [ReadMark(n or f"?{i}", z, sketch.error_mm) for i, (n, z) in enumerate(zip(names, ends[1:], strict=True))]
    return (score - 3 * names.count(None)) / TOO_FAR, [start, *rows]


def _by_words(
    names: list[str | None], trail: Trail, ends: Sequence[complex], words: Beside, sketch: ReadDrawing
) -> None:
    """Of two vectors there and back, and no third beside them, each is what stands nearer to it, were it reversed."""
    for i, j in combinations(range(len(trail)), 2):
        near = [words.get(n or "", {}) for n in (names[i], names[j])]
        a, b, c, d = *ends[i : i + 2], *ends[j : j + 2]
        if all(near) and back_and_forth(a, b, c, d, WIDE) and sum(alongside(a, b, *s) for s in sketch.strokes) == 2:
            as_named = near[0].get(trail[i], FAR_WORD) + near[1].get(trail[j], FAR_WORD)
            if near[1].get(trail[i], FAR_WORD) + near[0].get(trail[j], FAR_WORD) < as_named - SURELY_MM:
                names[i], names[j] = names[j], names[i]


def named_best(costs: Sequence[Mapping[str, float]]) -> list[str | None]:
    """Each vector's name, the cheapest first, then exchanged wherever that is cheaper in all."""
    names: list[str | None] = [None] * len(costs)
    for cost, i, n in sorted((cost, i, n) for i, row in enumerate(costs) for n, cost in row.items()):
        if names[i] is None and n not in names and cost < TOO_FAR:
            names[i] = n

    def price(i: int, name: str | None) -> float:
        return costs[i].get(name, 2 * TOO_FAR) if name else TOO_FAR

    better = True
    while better:
        better = False
        for i, j in combinations(range(len(names)), 2):
            if price(i, names[j]) + price(j, names[i]) < price(i, names[i]) + price(j, names[j]) - 1e-9:
                names[i], names[j], better = names[j], names[i], True
    return [n if n and costs[i].get(n, TOO_FAR) < TOO_FAR else None for i, n in enumerate(names)]
