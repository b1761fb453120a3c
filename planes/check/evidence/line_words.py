"""The texts of a file as evidence for marks and vectors: each is nearest to its own, or has a leader line to it."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from planes.check.evidence.handwritten import HandWords
from planes.check.reading.strokes import ReadDrawing, headed
from planes.check.reading.written import Stroke, Words
from planes.geometry.plane import off_segment, toward
from planes.words.frozen import frozen
from planes.words.naming import Names

SOFT_MM = 1.5  # margin by which a text is nearer to its own mark than to any other
SURELY = 0.98  # certainty of reading a text
LEADER_MM, INDEX, SHY_MM = 2.5, 0.3, 1.0  # start of a leader: from its text, or under its index; its end
SAME_MM = 0.1
MOST, FAR_MM = 9.0, 9.0  # maximum cost of a text; of 436 on right sheets nine in ten stood within 6 mm


@frozen
class LineWord:
    """A text, its probability for each name, and the end of its leader line."""

    word: Words
    likely: dict[str, float]
    led: complex | None = None

    def off(self, a: complex, b: complex) -> float:
        """The distance from the segment from a to b, or from the point a."""
        if self.led is not None:
            return off_segment(self.led, a, b)
        return self.word.distance(a) if a == b else self.word.beside((a, b))

    def nearest(self, own: float, others: Iterable[float], soft_mm: float = SOFT_MM) -> float:
        """The cost of naming an element at the distance ``own``, with ``others`` nearer or farther."""
        return min(math.log(1 + sum(math.exp(min((own - d) / soft_mm, 50.0)) for d in others)), MOST)


class LineWords(HandWords):
    """The texts of a file."""

    words: Sequence[LineWord] = ()  # type: ignore[assignment]

    def told(self, rows: Iterable[tuple[str, complex, complex]]) -> float:
        """The cost of assuming these marks or vectors, by whether each text is nearest to its own."""
        every, cost = list(rows), 0.0
        places = {(a, b) for _, a, b in every}
        for word in self.words:
            own = [(a, b) for n, a, b in every if n in word.likely]
            if own:
                a, b = min(own, key=lambda ends: word.off(*ends))
                others = [word.off(c, d) for c, d in places if abs(c - a) + abs(d - b) > SAME_MM]
                cost += word.nearest(word.off(a, b), [*others, FAR_MM])
        return cost


def words_of(sketch: ReadDrawing, names: Names, known: Iterable[str]) -> LineWords:
    """The texts of a drawing that are some names."""
    wanted, words, leads = set(known), list[LineWord](), _leads(sketch)
    for w in sketch.words:
        if meant := [n for n in names.meant(w.text) if n in wanted]:
            words.append(LineWord(w, dict.fromkeys(meant, SURELY / len(meant)), leads.get(id(w))))
    return LineWords(words)  # type: ignore[arg-type]


def _leads(sketch: ReadDrawing) -> dict[int, complex]:
    """The ends of leader lines, by text: lines without heads that begin beside it, where no other line ends."""
    ends = [(k, z) for k, s in enumerate(sketch.strokes) for z in s]
    leads, vectors = dict[int, complex](), [s for k, s in enumerate(sketch.strokes) if sketch.way(k)]
    for k, s in enumerate(sketch.strokes if headed(sketch) else ()):
        for a, b in (s, s[::-1]) if not sketch.way(k) else ():
            free = all(abs(a - z) > SHY_MM for i, z in ends if i != k)
            free = free and all(off_segment(a, *v) > SHY_MM for v in vectors)
            if abs(b - a) < LEADER_MM or not free or any(_along((a, b), v) for v in vectors):
                continue
            far = [w.distance(a, below=INDEX * w.height) for w in sketch.words]
            least = min([LEADER_MM, *far])
            leads |= {id(w): b for w, mm in zip(sketch.words, far, strict=True) if mm <= least < LEADER_MM}
    return leads


def _along(line: Stroke, vector: Stroke) -> bool:
    """Whether a line runs along a vector, as construction lines do."""
    p, q = ((z - line[0]) / toward(*line) for z in vector)
    near = max(abs(p.imag), abs(q.imag)) < SHY_MM
    return near and max(p.real, q.real) > 0 and min(p.real, q.real) < abs(line[1] - line[0])
