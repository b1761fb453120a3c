"""Lines and words of a drawing, whatever it was read from: straight strokes in mm, y up, and texts with their boxes."""

from __future__ import annotations

import cmath
import math
from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise, product
from typing import NamedTuple

from planes.check.reading.opened import too_many
from planes.check.reading.written import Stroke, Words
from planes.geometry.plane import corners

Round = tuple[complex, float]  # the middle of a small circle, a hinge or a point, and its radius
LONGEST = 200  # letters of a text
ROUND_MM = 3.0  # a larger circle is no sign of a point
SHORT_MM = 0.8  # shorter strokes are ticks, dots and pieces of letters
SNAPPED_MM, LOOSE_MM, FARTHEST_MM = 0.1, 0.6, 2.0  # ends no farther apart are one: joined by a program, by eye, badly
CROSSINGS = 400  # of more strokes than this crossings are not looked for
MOST, MOST_SHORT = 12_000, 120_000  # strokes of a drawing, and pieces of letters: a plan has a few dozen strokes
HEADED, FEWEST_HEADS = 0.25, 2  # of all lines, how many must have heads for that to tell the vectors from the rest
STRAIGHT = 0.005  # radians, by which a polyline that goes straight on may turn at a vertex
CROWD = 0.03  # nodes per mm² beyond which any place would do for a mark


class Arrowhead(NamedTuple):
    """An arrowhead: its tip, its way, how far back it is filled; if its sides are ``even`` any corner may be so."""

    tip: complex
    way: complex
    length: float = 0.0
    even: bool = False


@dataclass
class ReadDrawing:
    """What was found on a drawing. ``error_mm`` is how surely an end of a stroke is where it was found."""

    file: str = ""
    strokes: list[Stroke] = field(default_factory=list)
    words: list[Words] = field(default_factory=list)
    error_mm: float = 0.05
    ways: list[int] = field(default_factory=list)  # which end of each stroke has a head: +1, -1, 0 unknown; or none
    heads: list[Arrowhead] = field(default_factory=list)
    short: list[Stroke] = field(default_factory=list)  # vectors if they have heads, else ticks and pieces of letters
    mm: Callable[[complex], complex] = lambda z: z  # from the file's own units to mm, y up
    rounds: list[Round] = field(default_factory=list)
    passed: list[complex] = field(default_factory=list)  # vertices that polylines go straight on through
    endless: list[Stroke] | None = None  # where vectors run on past their ends: those that nothing shows the ends of

    def way(self, k: int) -> int:
        """Which end of a stroke has a head."""
        return self.ways[k] if self.ways else 0

    def only(self, held: Iterable[int]) -> ReadDrawing:
        """The drawing with some of its strokes."""
        kept = list(held)
        ways = [self.ways[k] for k in kept] if self.ways else []
        return replace(self, strokes=[self.strokes[k] for k in kept], ways=ways)

    def write(self, words: Words) -> None:
        """A text, unless it is empty or a story."""
        if 0 < len(text := words.text.strip()) <= LONGEST:
            self.words.append(replace(words, text=text))

    def add(self, points: Sequence[complex], closed: bool = False) -> None:
        """A polyline's strokes; where it goes straight on, it is one."""
        line = [*points, points[0]] if closed and len(points) > 2 else list(points)
        on = {k for k, (a, b, c) in enumerate(zip(line, line[1:], line[2:], strict=False), 1) if goes_on(a, b, c)}
        self.passed += [line[k] for k in on]
        line = [z for k, z in enumerate(line) if k not in on]
        for a, b in pairwise(line):
            if cmath.isfinite(a) and cmath.isfinite(b) and abs(b - a) > 0.02:
                (self.strokes if abs(b - a) >= SHORT_MM else self.short).append((a, b))
        for count, most in ((len(self.strokes) + len(self.passed), MOST), (len(self.short), MOST_SHORT)):
            if count > most:
                raise too_many(self.file, "strokes", most)


def goes_on(a: complex, b: complex, c: complex, within: float = STRAIGHT) -> bool:
    """Whether the way from a to b goes on to c, turned by no more than ``within``, radians."""
    return a != b != c and abs(cmath.phase((c - b) / (b - a))) < within


def headed(sketch: ReadDrawing) -> list[int]:
    """The strokes with arrowheads, where so many have one that a vector is told from a construction line by it."""
    heads = [k for k, way in enumerate(sketch.ways) if way]
    return heads if len(heads) >= max(FEWEST_HEADS, HEADED * len(sketch.strokes)) else []


def hinged(sketch: ReadDrawing) -> ReadDrawing:
    """The sketch with strokes that end at the circle of a hinge drawn on to its middle."""

    def on(z: complex) -> complex:
        return next((c for c, r in sketch.rounds if abs(z - c) < r + LOOSE_MM / 2), z)

    lines = [(on(a), on(b)) for a, b in sketch.strokes]
    return replace(sketch, strokes=lines).only(k for k, (a, b) in enumerate(lines) if a != b)


def reach_of(strokes: Sequence[Stroke], vectors: Sequence[int] = ()) -> float:
    """How far apart, mm, ends that are one place may be: hardly where a program joined them, more where the eye did;
    where ``vectors`` are known, their ends alone tell."""
    ends = [(k, z) for k, stroke in enumerate(strokes) for z in stroke]
    if len(ends) > 2 * CROSSINGS:
        return LOOSE_MM
    asked = [(k, z) for k in vectors for z in strokes[k]] or ends
    gaps = sorted(min((abs(z - w) for j, w in ends if j != k), default=math.inf) for k, z in asked)
    joined = [g for g in gaps if g < FARTHEST_MM]
    if not joined or sum(g < SNAPPED_MM for g in joined) > 0.7 * len(joined):
        return SNAPPED_MM if joined else LOOSE_MM
    return min(max(LOOSE_MM, 1.3 * joined[int(0.9 * (len(joined) - 1))]), FARTHEST_MM)


class Nodes:
    """Places where strokes end or cross, those nearer than ``near`` (mm) taken for one.

    Ends of vectors come first; of other lines only those that meet something are corners. Nothing but an end of its own
    kind moves a node. Vertices lines go straight on through come late.
    """

    def __init__(
        self,
        strokes: Sequence[Stroke],
        near: float = 0.0,
        vectors: Sequence[int] = (),
        points: Sequence[complex] = (),
        passed: Iterable[complex] = (),
    ) -> None:
        self.near = near or reach_of(strokes, vectors)
        self.places: list[complex] = []
        self.weights: list[int] = []
        self.cells: dict[tuple[int, int], list[int]] = defaultdict(list)
        self.ends: dict[tuple[int, int], int] = {}
        for z in points:
            self._add(z)
        plain = sorted({*range(len(strokes))} - {*vectors}) if vectors else []
        for k in vectors or range(len(strokes)):
            self._stroke(k, strokes[k])
        free = [k for k in plain if not all(self._met(strokes, k, j) for j in (0, 1))]
        for k in plain:
            if k not in free:
                self._stroke(k, strokes[k], fixed=True)
        self.corners = len(self.places)
        for k in free:
            self._stroke(k, strokes[k], fixed=True)
        self.passed = {self._add(z, fixed=True) for z in passed}
        if len(strokes) <= CROSSINGS:
            for z in crossings(strokes):
                self._add(z, fixed=True)

    def _stroke(self, k: int, stroke: Stroke, fixed: bool = False) -> None:
        self.ends[k, 0] = self._add(stroke[0], fixed=fixed)
        self.ends[k, 1] = self._add(stroke[1], but=self.ends[k, 0], fixed=fixed)  # a stroke has two ends

    def _met(self, strokes: Sequence[Stroke], k: int, j: int) -> bool:
        """Whether an end of a stroke meets an end of another one."""
        z = strokes[k][j]
        others = (w for i, other in enumerate(strokes) if i != k for w in other)
        return bool(self.within(z, self.near)) or any(abs(z - w) <= self.near for w in others)

    def _add(self, z: complex, but: int = -1, fixed: bool = False) -> int:
        node = next((i for i in self.within(z, self.near) if i != but), None)
        if node is None:
            self.places.append(z)
            self.weights.append(1)
            self.cells[self._cell(z)].append(len(self.places) - 1)
            return len(self.places) - 1
        weight = self.weights[node]
        if not fixed:
            self.places[node] = (self.places[node] * weight + z) / (weight + 1)
        self.weights[node] += 1
        return node

    def _cell(self, z: complex) -> tuple[int, int]:
        return math.floor(z.real / 4), math.floor(z.imag / 4)

    def within(self, z: complex, reach: float) -> list[int]:
        """Nodes no farther than ``reach``, the nearest first."""
        if not abs(z) <= 1e6:  # nor where it is no place at all
            return []
        cx, cy = self._cell(z)
        steps = math.ceil(reach / 4) + 1
        cells = product(range(cx - steps, cx + steps + 1), range(cy - steps, cy + steps + 1))
        near_nodes = [i for cell in cells for i in self.cells.get(cell, ()) if abs(self.places[i] - z) <= reach]
        return sorted(near_nodes, key=lambda i: abs(self.places[i] - z))

    def nearest(self, z: complex, reach: float) -> int | None:
        """The nearest node, if any is that near."""
        return next(iter(self.within(z, reach)), None)

    @property
    def crowded(self) -> bool:
        """Whether there are so many that anything would match."""
        if len(self.places) < 60:
            return False
        low, high = corners(self.places)
        return len(self.places) > min(CROWD * max((high - low).real * (high - low).imag, 1.0), 3000)


def crossings(strokes: Sequence[Stroke]) -> Iterable[complex]:
    """Places where strokes cross inside each other."""
    for i, (a, b) in enumerate(strokes):
        u = b - a
        for c, d in strokes[:i]:
            w = d - c
            turn = (u.conjugate() * w).imag
            if abs(turn) < 0.05 * abs(u) * abs(w):
                continue
            s, t = ((c - a).conjugate() * w).imag / turn, ((c - a).conjugate() * u).imag / turn
            if -0.01 <= s <= 1.01 and -0.01 <= t <= 1.01:
                yield a + s * u
