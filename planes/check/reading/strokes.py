"""Lines and words of a drawing from any source: straight strokes in mm, y up, and texts with their boxes."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import Any, NamedTuple

import numpy
from shapely import linestrings

from planes.check.reading.opened import too_many_error
from planes.check.reading.written import Stroke, Strokes, Words, vector_of
from planes.geometry.plane import bounding_corners, distance_to_nearest

Round = tuple[complex, float]  # centre and radius of a small circle, a hinge or a point
LONGEST_TEXT = 200  # letters of a text
LARGEST_POINT_RADIUS_MM = 3.0  # a larger circle is no sign of a point
SHORTEST_STROKE_MM = 0.8  # shorter strokes are ticks, dots and pieces of letters
# closer ends coincide: joined by a program, by eye, badly
SNAPPED_ENDS_MM = 0.1
ENDS_JOINED_BY_EYE_MM = 0.6
FARTHEST_JOINED_ENDS_MM = 2.0
MOST_STROKES_FOR_CROSSINGS = 400  # with more strokes, crossings are not searched
# strokes of a drawing, and pieces of letters: a plan has a few dozen strokes
MOST_STROKES = 12_000
MOST_SHORT_STROKES = 120_000
# minimum share and number of lines with heads at which heads distinguish the vectors
LEAST_HEADED_SHARE = 0.25
LEAST_HEADED_STROKES = 2
MOST_STRAIGHT_TURN_RAD = 0.005  # radians, maximum turn at a vertex of a polyline that continues straight on


class Arrowhead(NamedTuple):
    """An arrowhead: tip, direction, filled length; if its sides are ``even`` any corner may be the tip."""

    tip: complex
    way: complex
    length: float = 0.0
    even: bool = False


@dataclass
class ReadDrawing:
    """The content of a drawing. ``error_mm`` is the accuracy of stroke ends."""

    file: str = ""
    strokes: list[Stroke] = field(default_factory=list)
    words: list[Words] = field(default_factory=list)
    error_mm: float = 0.05
    ways: list[int] = field(default_factory=list)  # end of each stroke with a head: +1, -1, 0 unknown; or none
    heads: list[Arrowhead] = field(default_factory=list)
    short: list[Stroke] = field(default_factory=list)  # vectors if they have heads, else ticks and pieces of letters
    mm: Callable[[complex], complex] = lambda z: z  # from the units of the file to mm, y up
    rounds: list[Round] = field(default_factory=list)
    passed: int = 0  # vertices where polylines continue straight on

    @property
    def box(self) -> tuple[complex, complex]:
        """The lower left and the upper right corner of its strokes."""
        return bounding_corners(z for stroke in self.strokes for z in stroke)

    def end_with_head(self, k: int) -> int:
        """The end of a stroke that has a head."""
        return self.ways[k] if self.ways else 0

    def with_some_strokes(self, held: Iterable[int]) -> ReadDrawing:
        """The drawing with some of its strokes."""
        kept = list(held)
        ways = [self.ways[k] for k in kept] if self.ways else []
        return replace(self, strokes=[self.strokes[k] for k in kept], ways=ways)

    def add_text(self, words: Words) -> None:
        """Adds a text, unless it is empty or too long."""
        if 0 < len(text := words.text.strip()) <= LONGEST_TEXT:
            self.words.append(replace(words, text=text))

    def add_polyline(self, points: Sequence[complex], closed: bool = False) -> None:
        """Adds a polyline's strokes; where it continues straight on, they are one."""
        line = [*points, points[0]] if closed and len(points) > 2 else list(points)
        on = {
            k
            for k, (a, b, c) in enumerate(zip(line, line[1:], line[2:], strict=False), 1)
            if continues_straight(a, b, c)
        }
        self.passed += len(on)
        line = [z for k, z in enumerate(line) if k not in on]
        for stroke in pairwise(line):
            length = abs(vector_of(stroke))
            if 0.02 < length < math.inf:
                (self.strokes if length >= SHORTEST_STROKE_MM else self.short).append(stroke)
        for count, most in ((len(self.strokes) + self.passed, MOST_STROKES), (len(self.short), MOST_SHORT_STROKES)):
            if count > most:
                raise too_many_error(self.file, "strokes", most)


def as_lines(strokes: Strokes) -> Any:  # shapely has no types for many lines
    """Strokes as lines."""
    ends = [[(z.real, z.imag) for z in stroke] for stroke in strokes]
    return linestrings(ends) if ends else numpy.array([], object)


def continues_straight(a: complex, b: complex, c: complex, within: float = MOST_STRAIGHT_TURN_RAD) -> bool:
    """Whether the path from a to b continues to c, turning by at most ``within``, radians."""
    return a != b != c and abs(cmath.phase((c - b) / (b - a))) < within


def strokes_with_heads(sketch: ReadDrawing) -> list[int]:
    """The strokes with arrowheads, if enough have one to distinguish vectors from construction lines."""
    heads = [k for k, way in enumerate(sketch.ways) if way]
    if len(heads) >= max(LEAST_HEADED_STROKES, LEAST_HEADED_SHARE * len(sketch.strokes)):
        return heads
    return []


def extend_strokes_to_hinges(sketch: ReadDrawing) -> ReadDrawing:
    """The sketch with strokes that end at the circle of a hinge extended to its centre."""

    def on(z: complex) -> complex:
        return next((c for c, r in sketch.rounds if abs(z - c) < r + ENDS_JOINED_BY_EYE_MM / 2), z)

    lines = [(on(a), on(b)) for a, b in sketch.strokes]
    return replace(sketch, strokes=lines).with_some_strokes(k for k, (a, b) in enumerate(lines) if a != b)


def coincident_ends_distance_mm(strokes: Strokes, vectors: Sequence[int]) -> float:
    """The distance, mm, within which ends of vectors meet others: small if joined by a program, larger if by eye."""
    ends = [(k, z) for k, stroke in enumerate(strokes) for z in stroke]
    if len(ends) > 2 * MOST_STROKES_FOR_CROSSINGS:
        return ENDS_JOINED_BY_EYE_MM
    asked = ((k, z) for k in vectors for z in strokes[k])
    gaps = sorted(distance_to_nearest(z, (w for j, w in ends if j != k)) for k, z in asked)
    joined = [g for g in gaps if g < FARTHEST_JOINED_ENDS_MM]
    if not joined or sum(g < SNAPPED_ENDS_MM for g in joined) > 0.7 * len(joined):
        return SNAPPED_ENDS_MM if joined else ENDS_JOINED_BY_EYE_MM
    return min(max(ENDS_JOINED_BY_EYE_MM, 1.3 * joined[int(0.9 * (len(joined) - 1))]), FARTHEST_JOINED_ENDS_MM)
