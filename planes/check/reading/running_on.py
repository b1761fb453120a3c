"""Vectors without arrowheads that run on past their ends, cut off where others cross them or begin and end."""

import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import product

from planes.check.grading.prepared_plan import PreparedPlan
from planes.check.reading.as_planned import REACH_MM, alike
from planes.check.reading.chains import true_vectors
from planes.check.reading.construction_lines import (
    ASKEW,
    PAST,
    PAST_MM,
    UPON_MM,
    crossed,
    ends_of,
    meeting,
    past,
    vectors_alone,
    vectors_of,
)
from planes.check.reading.lone_vectors import others
from planes.check.reading.strokes import CROSSINGS, SNAPPED_MM, ReadDrawing, crossings
from planes.check.reading.written import Stroke
from planes.words.names import POLE, kind_of

JOINED = 0.6  # of the ends of vectors drawn upon construction lines more than so many meet others


def cut_off(sketch: ReadDrawing, bench: PreparedPlan) -> ReadDrawing | None:
    """A drawing whose vectors run on past their ends as if they did not; None of one that has arrowheads, or where they
    end as they should.

    Of the places where a vector may end those are taken that make it one of the plan's, else the outermost. One of a
    plan of motion that may be the plan's, though nothing shows where it ends, is put aside.
    """
    kind = kind_of(bench.asked.plan)
    if kind == "position" or any(sketch.ways) or len(sketch.strokes) > CROSSINGS:
        return None
    alone = vectors_alone(sketch, vectors_of(sketch, kind == "force")).strokes
    if past(sketch.strokes, ends_of(sketch.strokes)) < PAST or meeting(alone, ends_of(alone)) > JOINED:
        return None
    if kind == "force":
        known = [*true_vectors(bench).values(), *others(bench).values()]
        return replace(sketch, strokes=[_like(_ways(sketch, k), known) for k in range(len(sketch.strokes))], endless=[])
    pairs = _placed(bench, _pole(sketch, bench))
    strokes, endless = list[Stroke](), list[Stroke]()
    for k, stroke in enumerate(sketch.strokes):
        held, ways = [pair for pair in pairs if _holds(stroke, pair)], _ways(sketch, k)
        fits = [min((_off(way, pair), i) for i, way in enumerate(ways)) for pair in held]
        off, best = min(fits, default=(0.0, 0))
        strokes += [ways[best]] if off < REACH_MM else []
        endless += [stroke] if any(off > REACH_MM for off, _ in fits) else []
    return replace(sketch, strokes=strokes, endless=endless)


def _placed(bench: PreparedPlan, pole: complex) -> list[Stroke]:
    """The vectors of a plan of motion, drawn from a pole."""
    places = {**bench.true_marks, POLE: 0j}
    ends = dict.fromkeys([*((POLE, n) for n in bench.true_marks), *bench.vectors])
    drawn = [(places[a], places[b]) for a, b in ends if a in places and b in places]  # not from marks nobody asks for
    return [(pole + a, pole + b) for a, b in drawn if abs(a - b) > SNAPPED_MM]


def _pole(sketch: ReadDrawing, bench: PreparedPlan) -> complex:
    """Where most lines cross; of several such places the one that the pole's name is nearest to."""
    words = [w for w in sketch.words if bench.names.find(w.text) == POLE]

    def through(z: complex) -> int:
        return sum(_on(z, s, SNAPPED_MM) for s in sketch.strokes)

    places = [*crossings(sketch.strokes), *(z for stroke in sketch.strokes for z in stroke)]
    return max(places, key=lambda z: (through(z), -min((w.distance(z) for w in words), default=0.0)))


def _on(z: complex, stroke: Stroke, reach: float) -> bool:
    """Whether a place is on a stroke, or no farther from it than ``reach``."""
    local = (z - stroke[0]) / (stroke[1] - stroke[0]) * abs(stroke[1] - stroke[0])
    return abs(local.imag) < reach and -reach < local.real < abs(stroke[1] - stroke[0]) + reach


def _holds(stroke: Stroke, pair: Stroke) -> bool:
    """Whether a stroke may be a vector that runs on."""
    return _off(stroke, pair) < PAST_MM and all(_on(z, stroke, REACH_MM) for z in pair)


def _off(one: Stroke, two: Stroke) -> float:
    """How far apart the ends of two strokes are, drawn either way."""
    return min(max(abs(one[0] - a), abs(one[1] - b)) for a, b in (two, two[::-1]))


def _like(ways: Sequence[Stroke], known: Sequence[complex]) -> Stroke:
    """Of what may be a vector that which is most like one of a plan, drawn either way, else the longest."""

    def unlike(way: Stroke) -> float:
        v = way[1] - way[0]
        off = (min(abs(v - t), abs(v + t)) for t in known if alike(v, t) or alike(-v, t))
        return min(off, default=math.inf)

    return min(ways, key=unlike)


def _ways(sketch: ReadDrawing, k: int) -> list[Stroke]:
    """What of a stroke may be the vector, the longest first."""
    (one, two), (a, b) = (_ends(sketch, k, j) for j in (0, 1)), sketch.strokes[k]
    ways = [(c, d) for c, d in product(one, two) if ((d - c) / (b - a)).real * abs(b - a) > SNAPPED_MM]
    return sorted(ways, key=lambda s: -abs(s[1] - s[0])) or [(a, b)]


def _ends(sketch: ReadDrawing, k: int, j: int) -> list[complex]:
    """Where a stroke may end: where it does, if another one ends there or crosses it, else where others do that before;
    where none does, it must be where it does."""
    z, other = sketch.strokes[k][j], sketch.strokes[k][1 - j]
    strokes = [s for i, s in enumerate(sketch.strokes) if i != k]
    ends = [w for stroke in strokes for w in stroke]
    u = (other - z) / abs(other - z)
    aslant = (s for s in strokes if abs((v := (s[1] - s[0]) / u).imag) > ASKEW * abs(v))
    if any(abs(w - z) < SNAPPED_MM for w in ends) or any(_on(z, s, SNAPPED_MM) for s in aslant):
        return [z]
    upon = (local.real for w in ends if abs((local := (w - z) / u).imag) < UPON_MM)
    before = [at for at in (*crossed(sketch.strokes, k, z), *upon) if SNAPPED_MM < at < PAST_MM]
    return [z + u * at for at in before] or [z]
