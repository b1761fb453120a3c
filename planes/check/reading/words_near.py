"""Words beside the nodes of a drawing: which marks may be where, and from them where the pole is, and in what size."""

import math
import statistics
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import combinations

from planes.check.grading.prepared_plan import PreparedPlan
from planes.check.reading.chains import NEAR_MM, true_vectors
from planes.check.reading.construction_lines import upon
from planes.check.reading.parts import NEAR_WORD_MM
from planes.check.reading.strokes import CROSSINGS, Nodes, ReadDrawing, headed
from planes.check.reading.written import Stroke, Words
from planes.words.names import POLE, kind_of
from planes.words.naming import Names

LEADER_MM = 2.5  # a line from a word ends so near it
INDEX = 0.3  # how far an index reaches below its letter, in heights of the letter
SHY_MM = 1.0  # and so near what it names: it stops at the sign or the arrow that stands there
ON_MM = 0.3
BUSY_MM = 4.0
HIT_MM = 2.5  # a mark is where the plan leads
NEAR_POINT_MM = 1.5  # a point of a scheme is where it should be
LEAST_MM = 4.0  # shorter vectors tell little about the scale
SAME = math.log(1.05)  # the stated scale, as far as words can tell
ALIKE = math.log(1.15)  # lengths that speak of one scale

Candidates = dict[str, dict[int, float]]


def by_words(words: Iterable[Words], nodes: Nodes, names: Names) -> Candidates:
    """Nodes near the word of every mark, with the distance from the word."""
    candidates = Candidates()
    for word in words:
        name = names.exactly(word.text)
        if name is None:
            continue
        for node in nodes.within(word.middle, NEAR_WORD_MM + word.width):
            distance = word.distance(nodes.places[node]) + (2.0 if node >= nodes.corners else 0.0)
            if distance <= NEAR_WORD_MM:
                near = candidates.setdefault(name, {})
                near[node] = min(distance, near.get(node, distance))
    return candidates


def led(sketch: ReadDrawing, nodes: Nodes) -> Iterator[Words]:
    """Words with a line from them to what they name, as if they stood there."""
    places = nodes.places[: nodes.corners]
    for k, stroke in enumerate(sketch.strokes if len(sketch.strokes) <= CROSSINGS else ()):
        for j in (0, 1):
            z, at_node = stroke[j], next((i for i in nodes.within(stroke[1 - j], SHY_MM) if i < nodes.corners), None)
            if nodes.weights[nodes.ends[k, j]] > 1 or at_node is None or sketch.way(k):
                continue
            through = abs(stroke[1 - j] - places[at_node]) < ON_MM  # a line drawn on; one that stops short points there
            if through and any(_on(w, *stroke, LEADER_MM / 2) for i, w in enumerate(places) if i != at_node):
                continue
            yield from put(begun(sketch.words, z), nodes.places[at_node])


def headless(sketch: ReadDrawing) -> list[Stroke]:
    """The strokes without heads, each both ways: lines that may lead from words."""
    return [way for k, s in enumerate(sketch.strokes) if not sketch.way(k) for way in (s, s[::-1])]


def put(words: Iterable[Words], end: complex) -> list[Words]:
    """Words a line begins at put where the line ends."""
    return [replace(w, place=end, height=0.1, width=0.1) for w in words]


def begun(words: Sequence[Words], begin: complex) -> list[Words]:
    """The words a line begins at, beside them or under their indices: the nearest or all in its row."""
    far = [w.distance(begin, below=INDEX * w.height) for w in words]
    least = min([LEADER_MM, *far])
    return [w for w, mm in zip(words, far, strict=True) if mm <= least < LEADER_MM]


def led_to_vectors(sketch: ReadDrawing, dots: Sequence[complex], known: Names) -> list[Words]:
    """All words, those ``known`` with a line from them to the vector they name as if they stood on it too, and on
    nothing else where the line ends in a dot."""
    if len(sketch.strokes) > CROSSINGS:
        return sketch.words
    led_words, gone, words = list[Words](), list[Words](), [w for w in sketch.words if known.find(w.text)]
    vectors = [s for k, s in enumerate(sketch.strokes) if sketch.way(k)]
    ends = [z for s in vectors for z in s]
    plain = headless(sketch)
    vectors += [s for s in plain if abs(s[1] - s[0]) < LEADER_MM]  # too short for a head
    own = {min((b for _, b in plain), key=lambda b: abs(b - z)) for z in dots if plain}  # a dot is of one line
    for a, b in plain:
        clear = abs(b - a) > LEADER_MM and all(abs(a - z) > SHY_MM for z in ends)
        if clear and any(_on(b, *s, -ON_MM) for s in vectors) and not any(upon(s, (a, b)) for s in vectors):
            dotted = b in own and any(abs(b - z) < ON_MM for z in dots)
            named = begun(words, a)
            led_words += [replace(w, led=dotted) for w in put(named, b)]
            gone += named if dotted else ()
    return [*(w for w in sketch.words if w not in gone), *led_words]


def _on(z: complex, a: complex, b: complex, within: float) -> bool:
    """Whether a place is on the line from a to b, ``within`` mm from its ends at the least."""
    local = (z - a) / (b - a) * abs(b - a)
    return abs(local.imag) < ON_MM and within < local.real < abs(b - a) - within


def start_of(sketch: ReadDrawing, nodes: Nodes, bench: PreparedPlan, near: Candidates) -> complex | None:
    """Where the pole of a plan is, or the origin of a scheme's axes; None where nothing shows it."""
    if kind_of(bench.asked.plan) == "position":
        return _origin_of(nodes, bench, near)
    starts = Counter(nodes.ends[k, 0 if sketch.ways[k] > 0 else 1] for k in headed(sketch))
    beside = dict(near.get(POLE, {}))
    for node, count in starts.most_common(1):
        if beside and count > 1:  # where most begin is as good as where the word p is, or not far from it
            beside[node] = min(beside.values()) if node in beside else BUSY_MM
    pole = _pole_of(nodes, bench, near | {POLE: beside})
    if pole is None:
        return None
    return nodes.places[max(nodes.within(pole, HIT_MM), key=lambda i: starts[i])]  # where most vectors begin


def _pole_of(nodes: Nodes, bench: PreparedPlan, near: Candidates) -> complex | None:
    """The node from which the true plan would meet most nodes, one beside the word p if there is any."""
    ends = [z for z in bench.true_marks.values() if abs(z) > 1]
    beside = near.get(POLE)
    if not ends or (not beside and len(nodes.places) > 600):
        return None
    scores = []
    for i in beside or range(len(nodes.places)):
        z = nodes.places[i]
        hits = sum(nodes.nearest(z + e, HIT_MM) is not None for e in ends)
        scores.append((hits - (0.5 * beside[i] if beside else 0.0), nodes.weights[i], i))
    best = max(scores)
    return nodes.places[best[2]] if beside or best[0] >= max(2, 0.5 * len(ends)) else None


def _origin_of(nodes: Nodes, bench: PreparedPlan, near: Candidates) -> complex | None:
    """The origin of a scheme's axes: so that the frame's points, then most others, stand beside their words."""
    truth = bench.true_marks
    places = [(nodes.places[i] - truth[n], far) for n, held in near.items() if n in truth for i, far in held.items()]
    fixed = bench.naming.names(bench.plans.mechanism.frame.points)

    def worth(origin: complex, far: float) -> float:
        off = {n: min(abs(nodes.places[i] - origin - z) for i in near[n]) for n, z in truth.items() if n in near}
        fits = {n: max(1.0 - mm / NEAR_POINT_MM, 0.0) for n, mm in off.items()}
        return sum(fit * (len(off) if fixed.find(n) else 1.0) for n, fit in fits.items()) - 0.05 * far

    if not places:
        return _pole_of(nodes, bench, near)
    return max(places, key=lambda p: worth(*p))[0]


def sized(bench: PreparedPlan, sketch: ReadDrawing, nodes: Nodes, near: Candidates) -> PreparedPlan:
    """The plan at the scale most of the named marks or vectors show, unless it was told: it is the drawer's choice."""
    if bench.asked.mu:
        return bench
    force = kind_of(bench.asked.plan) == "force"
    ratio = _agreed(_of_vectors(bench, sketch) if force else _of_marks(bench, nodes, near))
    return bench if abs(ratio) < SAME else bench.at(bench.said_mu * math.exp(ratio))


def _of_marks(bench: PreparedPlan, nodes: Nodes, near: Candidates) -> list[float]:
    """Logarithms of drawn to stated distances from the pole, of a scheme between its points."""
    truth = bench.true_marks | {POLE: 0j}
    place = {n: nodes.places[min(held, key=lambda i: held[i])] for n, held in near.items() if n in truth}
    pairs = [(POLE, n) for n in place if n != POLE] if POLE in place else list(combinations(place, 2))
    ratios = []
    for one, two in pairs if POLE in place or bench.asked.plan == "position" else ():
        true, drawn = abs(truth[one] - truth[two]), abs(place[one] - place[two])
        ratios += [math.log(drawn / true)] if min(true, drawn) > LEAST_MM else []
    return ratios


def _of_vectors(bench: PreparedPlan, sketch: ReadDrawing) -> list[float]:
    """Logarithms of drawn to stated lengths of the vectors nearest to their words."""
    truth = true_vectors(bench)
    known, ratios = bench.naming.names(truth), []
    for word in sketch.words:
        name = known.find(word.text)
        if name is None or name == POLE or abs(truth[name]) < LEAST_MM:
            continue
        middles = ((word.distance((a + b) / 2), abs(b - a)) for a, b in sketch.strokes)
        far, length = min(middles, default=(math.inf, 0.0))
        ratios += [math.log(length / abs(truth[name]))] if far < NEAR_MM and length > LEAST_MM else []
    return ratios


def _agreed(ratios: list[float]) -> float:
    """The logarithm most of them agree on, nearest to none if several do; 0 where there is no agreement."""
    if len(ratios) < 2:
        return 0.0
    groups = [[r for r in ratios if abs(r - one) < ALIKE] for one in ratios]
    best = max(groups, key=lambda g: (len(g), -abs(statistics.median(g))))
    return statistics.median(best) if len(best) >= max(2, 0.5 * len(ratios)) else 0.0
