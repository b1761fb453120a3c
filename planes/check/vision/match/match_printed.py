"""A right plan of motion as a program prints it, told by its arrowheads: filled triangles of known size.

The plan is laid on the picture as it should be. Each of its vectors must have its head where it ends, to 0.1 mm by its
base, and its ink on the way there.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy

from planes.check.grading.paper import ReadMark, ReadPaper
from planes.check.grading.polygons import Side, between
from planes.check.grading.prepared_plan import PreparedPlan
from planes.check.reading.as_planned import is_right
from planes.check.reading.strokes import Stroke
from planes.check.vision.image.picture import cv
from planes.check.vision.marks.places import Seen
from planes.check.vision.strokes.ink import PENCIL, WHITE, Ink
from planes.check.vision.strokes.line_fitting import Fitted
from planes.drafting.pens import MEDIUM, THICK, HeadShape
from planes.geometry.arrays import Array, Complexes, Greys
from planes.words.names import POLE, label_of

STEP_MM = 0.05
INSIDE_MM, OUTSIDE_MM = 0.15, 0.3  # how far from a head's edge its ink is surely seen, and paper is
FULL, BARE = 0.93, 0.8  # the least shares of a head's places that are ink, of those outside of a side that are paper
HEAD, BOTH_SIDES = 0.79, 1.8  # how clear a head is of which one side is seen, or both are
HIDDEN = 0.1  # how clear a head is within other ink
DOUBTFUL = 1.5  # how clear a head is at the most whose tip and shaft are not seen to be narrow
SHAFT_MM = 1.0  # of a shaft, that tells its pen: another line that crosses a thick one looks like a thin head's base
SAME_MM, ALONG = 0.7, 0.98  # heads whose tips, or bases, are nearer than this and that point one way are one
CLEARER = 0.1  # by which another one may be there
TURNED = 0.995  # the least cosine of a head's turn from its vector
ALONG_MM = 1.0  # how far a head may be from where it belongs
PLAIN_MM = 9.0  # shorter vectors may be others' heads, or letters, and do not tell where the pole is
APART_MM = 0.5  # heads no nearer than this are two
TRIED = 4  # poles
NEAR_MM = 0.3  # how far aside a vector may be
ASIDE_MM = (0.0, -0.1, 0.1, -0.2, 0.2, -0.3, 0.3)  # where its ink is looked for
SURE_MM = 4.0  # a shorter vector may be there unseen: it is put where it should be
DRAWN_MM = 0.3  # a shorter one is not drawn
COVERED, SLIM_MM = 0.9, 0.25
ERROR_MM = 0.15
FAINT, MAINLY = 100, 0.7  # of 255: paler is no print's ink, but its rims; the share of ink that is no darker

Strokes = Mapping[str, Stroke]  # vectors by name


class PrintedHead(NamedTuple):
    """A head: its tip, the unit way it points, and how clear it is: near 2 where both of its sides are seen."""

    tip: complex
    way: complex
    clear: float


def shapes(length_mm: float) -> list[HeadShape]:
    """The heads a vector of that length may have."""
    return [shape for one in (THICK, MEDIUM) if (shape := one.on(length_mm))]


def clearness(ink: Ink, tips: Complexes, ways: Complexes, shape: HeadShape) -> Array:
    """How clear a head is at each of some tips: nearly 1 for each of its sides that is seen, 0 where it has no ink."""
    long, wide, pen = shape

    def dark(along: Array, aside: Array) -> Array:
        return ink.at(tips[:, None] + ways[:, None] * (along + 1j * aside)[None, :])

    within = numpy.linspace(INSIDE_MM - long, -0.3 * long, 6)
    half = numpy.maximum(-within * wide / (2 * long) - INSIDE_MM, 0)
    inside = numpy.concatenate([dark(within, k * half) for k in (-1, 0, 1)], axis=1)
    shaft = dark(numpy.array([-long - 0.15, -long - 0.4]), numpy.zeros(2))
    beside = numpy.linspace(0.1 - long, -0.25 * long, 6)
    base = numpy.linspace(pen / 2 + 0.25, max(wide / 2, pen / 2 + 0.3), 3)
    found, narrow = numpy.zeros(len(tips)), numpy.ones(len(tips), bool)
    for k in (-1, 1):
        shaft_side = dark(numpy.linspace(-long - SHAFT_MM, -long - 0.25, 5), numpy.full(5, k * (pen / 2 + 0.075)))
        narrow &= (shaft_side < 0.5).mean(axis=1) > 0.5
        narrow &= dark(numpy.array([-0.1 * long]), numpy.array([k * (0.05 * wide + 0.2)]))[:, 0] < 0.5
        out = dark(beside, k * (OUTSIDE_MM - beside * wide / (2 * long)))
        behind, front = (dark(numpy.full(3, z - long), k * (base - a)) for z, a in ((-0.25, 0.0), (0.25, 0.1)))
        seen = ((out < 0.5).mean(axis=1) > BARE) & (behind < 0.5).all(axis=1)
        found += numpy.where(seen, 0.5 + (front.mean(axis=1) - behind.mean(axis=1)) / 2, 0.0)
    found = numpy.maximum(numpy.where(narrow, found, numpy.minimum(found, DOUBTFUL)), HIDDEN)
    clear: Array = numpy.where(((inside > 0.5).mean(axis=1) > FULL) & (shaft > 0.5).all(axis=1), found, 0.0)
    return clear


def heads_along(
    ink: Ink, a: complex, b: complex, length_mm: float, aside: Sequence[float] = (0.0,), least: float = HEAD
) -> list[PrintedHead]:
    """The heads of vectors of a length whose tips are on the way from a to b, or so far to the left of it."""
    way, found = (b - a) / abs(b - a), list[tuple[PrintedHead, complex]]()
    on = numpy.linspace(a, b, max(2, round(abs(b - a) / STEP_MM)))
    tips = (on[None, :] + 1j * way * numpy.array(aside)[:, None]).ravel()
    for shape in shapes(length_mm):  # the ink of a thick head holds a thin one
        clear = clearness(ink, tips, numpy.full(len(tips), way), shape)
        for k in numpy.argsort(-clear)[: int((clear >= least).sum())]:
            tip = complex(tips[k])
            base = tip - shape.long * way
            better = clear[k] - CLEARER
            if all(min(abs(tip - h.tip), abs(base - z)) > SAME_MM or h.clear < better for h, z in found):
                found.append((PrintedHead(tip, way, float(clear[k])), base))
    return [head for head, _ in found]


def heads_on(ink: Ink, lines: Sequence[Fitted]) -> list[PrintedHead]:
    """The heads of long vectors along lines."""
    found = []
    for a, b in (line.ends for line in lines):
        u = (b - a) / abs(b - a)
        found += [h for way in ((a - u, b + u), (b + u, a - u)) for h in heads_along(ink, *way, math.inf)]
    kept: list[PrintedHead] = []
    for one in sorted(found, key=lambda h: -h.clear):
        if all(abs(one.tip - k.tip) > SAME_MM or (one.way / k.way).real < ALONG for k in kept):
            kept.append(one)
    return kept


@dataclass
class PrintedSheet:
    """What is printed: ink with its clear heads."""

    bench: PreparedPlan
    seen: Seen
    ink: Ink = field(init=False)
    heads: list[PrintedHead] = field(init=False)
    needed: list[Side] = field(init=False)  # the vectors the plan is made of

    def __post_init__(self) -> None:
        even = _as_printed(self.seen.ink.dark)
        self.ink = replace(self.seen.ink, even=even, whole=even, letters=None)
        self.heads, self.needed = heads_on(self.ink, self.seen.lines), between(self.bench)

    def right(self) -> list[ReadMark]:
        """The marks of the right plan; none where it is not what is drawn."""
        true = {POLE: 0j, **self.bench.true_marks}
        vectors = {s.name: (true[s.start], true[s.end]) for s in self.needed}
        read = (self._read(pole, vectors) for pole in _poles_of(self.heads, vectors.values()))
        spots = next((spots for spots in read if spots), [])
        return spots if is_right(self.bench, ReadPaper("", spots)) else []

    def _read(self, pole: complex, vectors: Strokes) -> list[ReadMark]:
        """The marks of a plan with its vectors at a pole; none where one has no head, unless other ink may hide it."""
        found = {n: self._heads(pole + a, pole + b) for n, (a, b) in vectors.items()}
        tips = [z for held in found.values() for z in held]
        drawn = [(pole, pole), *((pole + vectors[n][0], z) for n, held in found.items() for z in held)]
        for a, b in (vectors[n] for n, held in found.items() if not held):
            if abs(b - a) > SURE_MM and not self._hidden(pole + a, pole + b, drawn):
                return []
        clear = [h.tip for h in self.heads if h.clear > BOTH_SIDES]  # each is a vector's
        if not tips or any(min(abs(z - tip) for tip in tips) > ALONG_MM for z in clear):
            return []
        return self._marks(pole, vectors, found)

    def _heads(self, a: complex, b: complex) -> list[complex]:
        """Tips of the heads a vector may have that should lead from a to b."""
        if abs(b - a) < DRAWN_MM or not (inked := self._inked(a, b)):
            return []
        reach = ALONG_MM * (b - a) / abs(b - a)
        return [h.tip for h in heads_along(self.ink, b - reach, b + reach, abs(b - a), inked)]

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

    def _marks(
        self, pole: complex, vectors: Mapping[str, Stroke], found: Mapping[str, list[complex]]
    ) -> list[ReadMark]:
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
    return abs(z - b) < THICK.long or abs(z - a - share * (b - a)) < THICK.wide
