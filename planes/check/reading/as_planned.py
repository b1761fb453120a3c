"""The right plan looked for first: where every mark has its arrowhead and its word and no arrow is over, it is drawn.

Names crowd where marks do, and the word nearest to a mark may be its neighbour's. So before a mark is thought to be
elsewhere, the drawing is held against the plan as it should be.
"""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import combinations
from typing import TypeVar

from planes.check.grading.paper import ReadMark, ReadPaper
from planes.check.grading.polygons import loads_of
from planes.check.grading.prepared_plan import PreparedPlan
from planes.check.reading.chains import MOST_LINES, SURELY_MM, WIDE, back_and_forth
from planes.check.reading.lone_vectors import arrows_of
from planes.check.reading.strokes import SHORT_MM, ReadDrawing, lies_on
from planes.check.reading.weighed import FARTHEST_MM, is_right
from planes.check.reading.words_near import Candidates
from planes.check.reading.written import Stroke
from planes.words.names import POLE, kind_of

REACH_MM = 1.5  # a hand's mark is no farther from where it should be; grading tells whether it is near enough
UPON_MM = 1.0  # of two vectors upon each other no distance tells which name is whose
DRAWN_MM = 0.3  # nobody draws a shorter vector
SHARE = 0.015  # of a vector's length, by which it may be off besides
EXCHANGED_MM, VECTORS_MM = 6.0, 3.0  # two words so much nearer to each other's marks, or vectors, are exchanged


def marks_as_planned(sketch: ReadDrawing, bench: PreparedPlan, near: Candidates, poles: Iterable[complex]) -> ReadPaper:
    """The marks of a motion plan or a scheme; none where it is not drawn whole and rightly."""
    truth = bench.true_marks
    scheme = kind_of(bench.asked.plan) == "position"
    arrows = [] if scheme else arrows_of(sketch) or sketch.strokes[:MOST_LINES]
    tips = [z for z, _ in sketch.rounds] if scheme else [z for arrow in arrows for z in arrow]
    names = bench.names
    words = [(n, w) for w in sketch.words if (n := names.find(w.text)) in truth]

    def far_from(name: str, z: complex) -> float:
        far = min(w.distance(z) for n, w in words if n == name)
        return far if far <= FARTHEST_MM else math.inf

    for pole in poles if tips else ():
        hidden = unshown(sketch, bench, pole)
        shown = {n: z for n, z in truth.items() if n not in hidden}
        places = {n: _nearest(pole + z, [pole, *tips]) for n, z in shown.items()}
        ends = [pole, *places.values()]
        there = all(abs(places[n] - pole - z) <= REACH_MM for n, z in shown.items())
        if there and all(abs(_nearest(z, ends) - z) <= REACH_MM for arrow in arrows for z in arrow):
            spots = [ReadMark(n, z, sketch.error_mm) for n, z in {POLE: pole, **places}.items()]
            paper = ReadPaper(sketch.file, spots, whole=False)
            if named(places, near.keys() & places, far_from) and is_right(bench, paper):
                return paper
    return ReadPaper(sketch.file, whole=False)


def unshown(sketch: ReadDrawing, bench: PreparedPlan, pole: complex) -> set[str]:
    """Marks that may be anywhere along a vector that runs on past its end, and at no other's end."""
    lines, ends = sketch.endless or (), [w for stroke in sketch.strokes for w in stroke]
    places = {n: pole + z for n, z in bench.true_marks.items()}
    along = (n for n, z in places.items() if any(lies_on(z, line, REACH_MM, REACH_MM) for line in lines))
    return {n for n in along if all(abs(w - places[n]) > REACH_MM for w in ends)}


def _nearest(z: complex, places: Sequence[complex]) -> complex:
    return min(places, key=lambda w: abs(w - z))


def vectors_named(
    sketch: ReadDrawing, bench: PreparedPlan, sides: Mapping[str, complex], beside: Iterable[complex]
) -> ReadPaper:
    """Given vectors of a force plan by their arrowheads, their likeness and names, with others ``beside`` them; none
    where one is not drawn, or an arrow is over."""
    nothing, arrows, spelt = ReadPaper(sketch.file, whole=False), arrows_of(sketch), bench.naming.names(sides)
    words, loads = [(spelt.find(w.text), w) for w in sketch.words], loads_of(bench.plans, bench.asked.plan)
    written = {n for n, _ in words}

    def word(name: str, stroke: Stroke) -> float:
        own = [w for n, w in words if n == name]
        far = min((w.beside(stroke) for w in own if w.runs(stroke, sketch.words)), default=math.inf if own else 0.0)
        return far if far <= FARTHEST_MM else math.inf

    def nearer(one: str, two: str) -> float:
        return SURELY_MM if back_and_forth(*rows[one], *rows[two], WIDE) else VECTORS_MM

    def upon(one: str, two: str) -> bool:
        (a, b), (c, d) = rows[one], rows[two]
        return max(abs(a - d), abs(b - c)) < min(UPON_MM, abs(b - a) / 2)

    rows: dict[str, Stroke] = {}
    for name, true in sorted(sides.items(), key=lambda side: (side[0] not in written, -abs(side[1]))):
        like = [s for s in arrows if alike(s[1] - s[0], true) and s not in rows.values()]
        if like:
            rows[name] = min(like, key=lambda s: (round(min(word(name, s), 1e3)), abs(s[1] - s[0] - true)))
        elif abs(true) > SHORT_MM and (name in written or name in loads):  # an inner reaction need not be drawn
            return nothing
    known = [way for t in (*sides.values(), *beside) for way in (t, -t)]
    numbered = {n for n, w in words if n and w.ends}  # which way they go is told
    over = any(not any(alike(b - a, t) for t in known) for a, b in arrows)
    over = over or any(upon(one, two) for one, two in combinations(rows, 2) if not {one, two} & numbered)
    if over or not named(rows, rows, word, nearer):
        return nothing
    spots = [ReadMark(n, z, sketch.error_mm) for name, (a, b) in rows.items() for n, z in ((POLE, a), (name, b))]
    left = {n for n, true in sides.items() if n not in rows and abs(true) > DRAWN_MM}
    return ReadPaper(sketch.file, spots, whole=not left)


def alike(v: complex, true: complex) -> bool:
    """Whether what is drawn may be a vector."""
    return abs(v - true) <= min(REACH_MM + SHARE * abs(true), 0.5 * abs(true) + 0.1)


Place = TypeVar("Place", complex, Stroke)


def named(
    places: Mapping[str, Place],
    words: Iterable[str],
    word: Callable[[str, Place], float],
    nearer: Callable[[str, str], float] = lambda _, __: EXCHANGED_MM,
) -> bool:
    """Whether the word of all that have one is beside it, and no two are exchanged; ``word`` tells how far it is, and
    ``nearer`` by how much two words must be nearer to each other's places for that."""
    own = {n: word(n, places[n]) for n in words}
    return all(map(math.isfinite, own.values())) and not any(
        word(one, places[two]) + word(two, places[one]) + nearer(one, two) < own[one] + own[two]
        for one, two in combinations(own, 2)
    )
