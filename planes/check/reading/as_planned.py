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
from planes.check.reading.chains import MOST_LINES, SURELY_MM, alongside
from planes.check.reading.construction_lines import ends_of
from planes.check.reading.lone_vectors import arrows_of
from planes.check.reading.parts import NEAR_WORD_MM
from planes.check.reading.strokes import SHORT_MM, ReadDrawing
from planes.check.reading.weighed import FARTHEST_MM, is_right
from planes.check.reading.words_near import LEADER_MM, Candidates, headless, put
from planes.check.reading.written import Stroke
from planes.words.names import POLE, kind_of

REACH_MM = 1.5  # a hand's mark is no farther from where it should be; grading tells whether it is near enough
DRAWN_MM = 0.3  # nobody draws a shorter vector
SHARE = 0.015  # of a vector's length, by which it may be off besides
UNLIKE = math.log(2)  # of lengths
EXCHANGED_MM, VECTORS_MM = 6.0, 3.0  # two words so much nearer to each other's marks, or vectors, are exchanged
UPON_MM = 1.0  # of two vectors upon each other no distance tells which name is whose


def marks_as_planned(sketch: ReadDrawing, bench: PreparedPlan, near: Candidates, poles: Iterable[complex]) -> ReadPaper:
    """The marks of a motion plan or a scheme; none where it is not drawn whole and rightly."""
    truth = bench.true_marks
    scheme = kind_of(bench.asked.plan) == "position"
    arrows = [] if scheme else arrows_of(sketch) or sketch.strokes[:MOST_LINES]
    tips = [z for z, _ in sketch.rounds] if scheme else [z for arrow in arrows for z in arrow]
    names = bench.names
    words = [(n, w) for w in sketch.words if (n := names.find(w.text)) in truth]
    plain = [(a, b) for a, b in headless(sketch) if all(abs(a - z) > SHORT_MM for z in tips)]  # none begins at a mark
    words += [(n, there) for n, w in words for a, b in plain if w.distance(a) < LEADER_MM for there in put([w], b)]

    def far_from(name: str, z: complex) -> float:
        far = min(w.distance(z) for n, w in words if n == name)
        return far if far <= FARTHEST_MM else math.inf

    starts = [z for z, _ in arrows]
    most = sorted(starts, key=lambda z: -sum(abs(z - w) < SHORT_MM for w in starts))[:1]  # most vectors begin there
    for pole in (*poles, *most) if tips else ():
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
    lines = sketch.endless or ()
    along = {n: pole + z for n, z in bench.true_marks.items() if any(_along(pole + z, line) for line in lines)}
    return {n for n, z in along.items() if all(abs(w - z) > REACH_MM for stroke in sketch.strokes for w in stroke)}


def _along(z: complex, line: Stroke) -> bool:
    """Whether a place is on a vector that runs on past its end."""
    local = (z - line[0]) / (line[1] - line[0]) * abs(line[1] - line[0])
    return abs(local.imag) < REACH_MM and REACH_MM < local.real < abs(line[1] - line[0]) + REACH_MM


def _nearest(z: complex, places: Sequence[complex]) -> complex:
    return min(places, key=lambda w: abs(w - z))


def vectors_named(
    sketch: ReadDrawing, bench: PreparedPlan, sides: Mapping[str, complex], beside: Iterable[complex]
) -> ReadPaper:
    """Given vectors of a force plan by their likeness and names, with others ``beside`` them; none where one is not
    drawn, or an arrow is over."""
    nothing, arrows, spelt = ReadPaper(sketch.file, whole=False), arrows_of(sketch), bench.naming.names(sides)
    words = [(spelt.find(w.text), w) for w in sketch.words]

    def word(name: str, stroke: Stroke) -> float:
        own = [w for n, w in words if n == name]
        far = min((w.beside(stroke) for w in own if w.runs(stroke, sketch.words)), default=math.inf if own else 0.0)
        return far if far <= FARTHEST_MM else math.inf

    free = [s for s in (*sketch.strokes, *sketch.short) if not arrows or abs(s[1] - s[0]) < 2 * REACH_MM]
    if not arrows and (len(free) > MOST_LINES or not _ring(free)):
        return nothing
    bare = [way for s in free for way in (s, s[::-1])]
    rows: dict[str, Stroke] = {}
    undrawn, known_before, written = set[str](), loads_of(bench.plans, bench.asked.plan), {n for n, _ in words}
    for name, true in sorted(sides.items(), key=lambda side: (side[0] not in written, -abs(side[1]))):
        like = [s for s in (*arrows, *bare) if _alike(s, true)]
        like = [s for s in like if not {s, s[::-1] if s in bare else s} & {*rows.values()}] or [
            s for s in like if 0 < word(name, s) <= NEAR_WORD_MM
        ]
        if like:
            rows[name] = min(like, key=lambda s: (round(min(word(name, s), 1e3)), abs(s[1] - s[0] - true)))
        elif abs(true) > SHORT_MM and (name in written or name in known_before):
            return nothing
        elif abs(true) > SHORT_MM or abs(true) < DRAWN_MM:
            undrawn.add(name)  # an inner reaction need not be drawn
    known = [*sides.values(), *beside]
    over = any(not _alike(s, t) and not _alike(s[::-1], t) for s in arrows or free for t in [_like(s, known)])
    numbered = {n for n, w in words if n and w.ends}  # which way they go is told
    over = over or any(_upon(rows[one], rows[two]) for one, two in combinations(rows, 2) if not {one, two} & numbered)

    def nearer(one: str, two: str) -> float:
        third = sum(alongside(*rows[one], *arrow) for arrow in arrows)  # with one words stand where there is room
        if third == 2 and alongside(*rows[one], *rows[two]):
            return SURELY_MM
        a, b = (max(abs(sides[n]), DRAWN_MM) for n in (one, two))
        unlike = abs(math.log(a / b)) > UNLIKE  # nobody takes one for the other
        return EXCHANGED_MM if unlike else VECTORS_MM

    if over or not named(rows, rows, word, nearer):
        return nothing
    spots = [ReadMark(n, z, sketch.error_mm) for name, (a, b) in rows.items() for n, z in ((POLE, a), (name, b))]
    either = not arrows and not written & sides.keys() and len(sides) == 2  # there and back
    untold = [*rows][:1] if either else []
    return ReadPaper(sketch.file, spots, whole=len(rows) + len(undrawn) == len(sides), untold=untold)


def _ring(strokes: Sequence[Stroke]) -> bool:
    """Whether every stroke begins and ends where others do."""
    ends = ends_of(strokes)
    return all(any(abs(z - w) < REACH_MM for j, w in ends if j != k) for k, z in ends)


def _alike(stroke: Stroke, true: complex) -> bool:
    """Whether a stroke may be a vector."""
    return alike(stroke[1] - stroke[0], true)


def alike(v: complex, true: complex) -> bool:
    """Whether what is drawn may be a vector."""
    return abs(v - true) <= min(REACH_MM + SHARE * abs(true), 0.5 * abs(true) + 0.1)


def _upon(one: Stroke, two: Stroke) -> bool:
    """Whether two vectors lie upon each other, there and back."""
    off, long = max(abs(one[0] - two[1]), abs(one[1] - two[0])), min(abs(b - a) for a, b in (one, two))
    return off < min(UPON_MM, long / 2)


def _like(stroke: Stroke, known: Sequence[complex]) -> complex:
    """The vector a stroke is most like, drawn either way."""
    v = stroke[1] - stroke[0]
    return min(known, key=lambda t: min(abs(v - t), abs(v + t)))


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
