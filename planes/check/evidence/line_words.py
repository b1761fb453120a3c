"""The texts of a file as evidence for marks and vectors: each is nearest to its own, or has a leader line to it."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from planes.check.evidence.handwritten import HandWords
from planes.check.reading.strokes import ReadDrawing, strokes_with_heads
from planes.check.reading.written import Stroke, Words
from planes.geometry.plane import direction_between, off_segment
from planes.words.frozen import frozen
from planes.words.naming import Names

NEARER_NAME_MARGIN_MM = 1.5  # margin by which a text is nearer to its own mark than to any other
TEXT_CERTAINTY = 0.98  # certainty of reading a text
# start of a leader: from its text, or under its index; its end
LEADER_START_MM = 2.5
LEADER_UNDER_INDEX_HEIGHTS = 0.3
LEADER_CLEARANCE_MM = 1.0
SAME_POSITION_MM = 0.1
# maximum cost of a text; of 436 on right sheets nine in ten stood within 6 mm
MOST_TEXT_COST = 9.0
FAR_TEXT_DISTANCE_MM = 9.0


@frozen
class LineWord:
    """A text, its probability for each name, and the end of its leader line."""

    word: Words
    likely: dict[str, float]
    led: complex | None = None

    def distance_to_segment(self, a: complex, b: complex) -> float:
        """The distance from the segment from a to b, or from the point a."""
        if self.led is not None:
            return off_segment(self.led, a, b)
        if a == b:
            return self.word.distance(a)
        return self.word.distance_to_vector((a, b))

    def naming_cost(self, own: float, others: Iterable[float], soft_mm: float = NEARER_NAME_MARGIN_MM) -> float:
        """The cost of naming an element at the distance ``own``, with ``others`` nearer or farther."""
        return min(math.log(1 + sum(math.exp(min((own - d) / soft_mm, 50.0)) for d in others)), MOST_TEXT_COST)


class LineWords(HandWords):
    """The texts of a file."""

    words: Sequence[LineWord] = ()  # type: ignore[assignment]

    def total_name_cost(self, rows: Iterable[tuple[str, complex, complex]]) -> float:
        """The cost of assuming these marks or vectors, by whether each text is nearest to its own."""
        every = list(rows)
        cost = 0.0
        places = {(a, b) for _, a, b in every}
        for word in self.words:
            own = [(a, b) for n, a, b in every if n in word.likely]
            if own:
                a, b = min(own, key=lambda ends: word.distance_to_segment(*ends))
                others = [
                    word.distance_to_segment(c, d) for c, d in places if abs(c - a) + abs(d - b) > SAME_POSITION_MM
                ]
                cost += word.naming_cost(word.distance_to_segment(a, b), [*others, FAR_TEXT_DISTANCE_MM])
        return cost


def words_among_names(sketch: ReadDrawing, names: Names, known: Iterable[str]) -> LineWords:
    """The texts of a drawing that are some names."""
    wanted = set(known)
    words = list[LineWord]()
    leads = _leader_ends(sketch)
    for w in sketch.words:
        if meant := [n for n in names.possible_names(w.text) if n in wanted]:
            words.append(LineWord(w, dict.fromkeys(meant, TEXT_CERTAINTY / len(meant)), leads.get(id(w))))
    return LineWords(words)  # type: ignore[arg-type]


def _leader_ends(sketch: ReadDrawing) -> dict[int, complex]:
    """The ends of leader lines, by text: lines without heads that begin beside it, where no other line ends."""
    ends = [(k, z) for k, s in enumerate(sketch.strokes) for z in s]
    leads = dict[int, complex]()
    vectors = [s for k, s in enumerate(sketch.strokes) if sketch.end_with_head(k)]
    for k, s in enumerate(sketch.strokes if strokes_with_heads(sketch) else ()):
        for a, b in (s, s[::-1]) if not sketch.end_with_head(k) else ():
            free = all(abs(a - z) > LEADER_CLEARANCE_MM for i, z in ends if i != k)
            free = free and all(off_segment(a, *v) > LEADER_CLEARANCE_MM for v in vectors)
            if abs(b - a) < LEADER_START_MM or not free or any(_runs_along((a, b), v) for v in vectors):
                continue
            far = [w.distance(a, below=LEADER_UNDER_INDEX_HEIGHTS * w.height) for w in sketch.words]
            least = min([LEADER_START_MM, *far])
            leads |= {id(w): b for w, mm in zip(sketch.words, far, strict=True) if mm <= least < LEADER_START_MM}
    return leads


def _runs_along(line: Stroke, vector: Stroke) -> bool:
    """Whether a line runs along a vector, as construction lines do."""
    p, q = ((z - line[0]) / direction_between(*line) for z in vector)
    near = max(abs(p.imag), abs(q.imag)) < LEADER_CLEARANCE_MM
    return near and max(p.real, q.real) > 0 and min(p.real, q.real) < abs(line[1] - line[0])
