"""A right plan of motion as a program prints it, told by its arrowheads.

The plan is laid on the picture as it should be. Each of its vectors must have its head where it ends, and its ink on
the way there.
"""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy

from planes.check.grading.paper import ReadMark, ReadPaper
from planes.check.grading.polygons import Side, between
from planes.check.grading.prepared_plan import PreparedPlan, redrawn
from planes.check.reading.as_planned import is_right
from planes.check.reading.strokes import Stroke
from planes.check.vision.ink import PENCIL, WHITE, Ink
from planes.check.vision.picture import cv
from planes.check.vision.places import Seen, rounded
from planes.check.vision.printed_heads import BOTH_SIDES, HIDDEN, THICK, TURNED, PrintedHead, heads_along, heads_on
from planes.geometry.arrays import Greys
from planes.words.names import POLE, at, label_of

ALONG_MM = 1.0  # how far a head may be from where it belongs
PLAIN_MM = 9.0  # shorter vectors may be others' heads, or letters, and do not tell where the pole is
APART_MM = 0.5  # heads no nearer than this are two
TRIED = 4  # poles
HIDING_MM = THICK.long  # how near other vectors' ends are that may hide a head
NEAR_MM = 0.3  # how far aside a vector may be
ASIDE_MM = (0.0, -0.1, 0.1, -0.2, 0.2, -0.3, 0.3)  # where its ink is looked for
SURE_MM = 4.0  # a shorter vector may be there unseen: it is put where it should be
DRAWN_MM = 0.3  # a shorter one is not drawn
COVERED, SLIM_MM = 0.9, 0.25
ERROR_MM = 0.15
FAINT, MAINLY = 100, 0.7  # of 255: paler is no print's ink, but its rims; the share of ink that is no darker
WILDEST_MM = 400.0

Tips = Mapping[str, list[complex]]  # where the head of a vector of that name may be


@dataclass
class PrintedSheet:
    """What is printed: ink with its clear heads."""

    bench: PreparedPlan
    seen: Seen
    ink: Ink = field(init=False)
    heads: list[PrintedHead] = field(init=False)
    tips: dict[tuple[complex, complex], list[complex]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        even = _as_printed(self.seen.ink.dark)
        self.ink = replace(self.seen.ink, even=even, whole=even, letters=None)
        self.heads = heads_on(self.ink, self.seen.lines)

    def right(self) -> list[ReadMark]:
        """The marks of the right plan; none where it is not what is drawn."""
        vectors = self._vectors()
        if any(s.name not in vectors for s in self.needed):
            return []
        read = (self._read(pole, vectors) for pole in _poles_of(self.heads, vectors.values()))
        spots = next((spots for spots in read if spots), [])
        return spots if is_right(self.bench, ReadPaper("", spots)) else []

    @cached_property
    def needed(self) -> list[Side]:
        """The vectors the plan is made of."""
        return between(self.bench)

    def _vectors(self) -> dict[str, Stroke]:
        """Every vector that may be drawn, from the pole."""
        things, plan = redrawn(self.bench, None, lambda step, made: made) or {}, self.bench.asked.plan

        def end(name: str) -> complex:
            return 0j if name == POLE else complex(things.get(at(plan, name), math.nan))

        found = {s.name: (end(s.start), end(s.end)) for s in self.needed}
        return {n: (a, b) for n, (a, b) in found.items() if abs(a) + abs(b) < WILDEST_MM}

    def _read(self, pole: complex, vectors: Mapping[str, Stroke]) -> list[ReadMark]:
        """The marks of a plan with its vectors at a pole; none where one has no head, unless other ink may hide it."""
        found: dict[str, list[complex]] = {}
        for name, (a, b) in vectors.items():
            found[name] = self._heads(pole + a, pole + b) if abs(b - a) > DRAWN_MM else []
        tips = [z for held in found.values() for z in held]
        drawn = [(pole, pole), *((pole + vectors[n][0], z) for n, held in found.items() for z in held)]
        for a, b in (vectors[s.name] for s in self.needed if not found[s.name]):
            if abs(b - a) > SURE_MM and not self._hidden(pole + a, pole + b, drawn):
                return []
        clear = [h.tip for h in self.heads if h.clear > BOTH_SIDES]  # each is a vector's
        if not tips or any(min(abs(z - tip) for tip in tips) > ALONG_MM for z in clear):
            return []
        return self._marks(pole, vectors, found)

    def _heads(self, a: complex, b: complex) -> list[complex]:
        """Tips of the heads a vector may have that should lead from a to b (remembered)."""
        key = rounded(a), rounded(b)
        if key not in self.tips:
            self.tips[key] = list(self._looked(a, b))
        return self.tips[key]

    def _looked(self, a: complex, b: complex) -> Iterator[complex]:
        if inked := self._inked(a, b):
            way = (b - a) / abs(b - a)
            ends = b - ALONG_MM * way, b + ALONG_MM * way
            yield from (h.tip for h in heads_along(self.ink, *ends, abs(b - a), inked))

    def _inked(self, a: complex, b: complex) -> list[float]:
        """How far to either side of the way from a to b ink leads along it, the nearest first."""
        way = (b - a) / abs(b - a)
        start, end = a + NEAR_MM * way, b - NEAR_MM * way
        return [t for t in ASIDE_MM if self.ink.covered(start + 1j * t * way, end + 1j * t * way, SLIM_MM) > COVERED]

    def _hidden(self, a: complex, b: complex, others: Sequence[Stroke]) -> bool:
        """Whether a vector's head may be within the ink of others that end, or pass, beside it."""
        if not any(_hides(b, other) for other in others) or not (inked := self._inked(a, b)):
            return False
        ends = b - NEAR_MM * (b - a) / abs(b - a), b + NEAR_MM * (b - a) / abs(b - a)
        heads = heads_along(self.ink, *ends, abs(b - a), inked, HIDDEN)
        return any(_hides(h.tip, other) for h in heads for other in others)

    def _marks(self, pole: complex, vectors: Mapping[str, Stroke], found: Tips) -> list[ReadMark]:
        """Marks of a motion plan, where the heads are of the vectors that end in them."""
        ends = {s.end: vectors[s.name][1] for s in self.needed}
        places = {POLE: pole}
        for mark, z in ends.items():
            tips = [tip for s in self.needed if s.end == mark for tip in found[s.name]]
            same = [w for n, w in places.items() if abs(z - ends.get(n, 0j)) < DRAWN_MM]
            places |= {mark: same[0]} if same else {mark: min(tips, key=lambda t: abs(t - pole - z))} if tips else {}
        labels = {label_of(m) for m in self.bench.marks} & places.keys()
        return [ReadMark(n, places[n], ERROR_MM) for n in (POLE, *sorted(labels))]


def _as_printed(dark: Greys) -> Greys:
    """The picture, all of its ink held against what it is mostly: edges are where they were printed."""
    inked = dark[dark > FAINT]
    black = float(numpy.quantile(inked, MAINLY)) if len(inked) else float(WHITE)
    shares: Greys = cv().divide(dark, numpy.full_like(dark, black), scale=255 - PENCIL)
    return 255 - shares


def _poles_of(heads: Sequence[PrintedHead], vectors: Iterable[Stroke]) -> list[complex]:
    """Poles from which most of the vectors would meet heads, the likeliest first."""
    long = [(b, (b - a) / abs(b - a)) for a, b in vectors if abs(b - a) > PLAIN_MM]
    tips, ways = (numpy.array([getattr(h, k) for h in heads], complex) for k in ("tip", "way"))
    points = [(ways / way).real > TURNED for _, way in long]
    poles = numpy.array([z for (b, _), on in zip(long, points, strict=True) for z in tips[on] - b], complex)
    worth = numpy.zeros(len(poles))
    for (b, way), on in zip(long, points, strict=True):
        local = (tips[on][None, :] - poles[:, None] - b) / way
        near = (abs(local.real) < ALONG_MM) & (abs(local.imag) < NEAR_MM)
        off = abs(local.real) / (2 * ALONG_MM)
        worth += numpy.where(near, 1 - off, 0.0).max(axis=1, initial=0.0)
    found: list[complex] = []
    for k in numpy.argsort(-worth, kind="stable"):
        if len(found) < TRIED and all(abs(poles[k] - f) > APART_MM for f in found):
            found.append(complex(poles[k]))
    return found


def _hides(z: complex, other: Stroke) -> bool:
    """Whether a head at a place may be within the ink of another vector: at its end, or on its shaft."""
    a, b = other
    share = min(max(((z - a) / (b - a)).real, 0.0), 1.0) if a != b else 0.0
    return abs(z - b) < HIDING_MM or abs(z - a - share * (b - a)) < THICK.wide
