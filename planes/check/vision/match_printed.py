"""A plan as a program prints it, told by its arrowheads and its lettering.

The plan is laid on the picture as it should be, or as one mistake of the catalogue makes it. Each of its vectors must
have its head where it ends, and its ink on the way there; of a force plan some way aside, for forces of one line stand
side by side. No clear head may be left over, and no name may stand beside another's vector.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy

from planes.check.grading.handwork import Variant
from planes.check.grading.paper import ReadMark, ReadPaper
from planes.check.grading.polygons import Side, between, sides_of
from planes.check.grading.prepared_plan import PreparedPlan, redrawn, variants_of
from planes.check.reading.as_planned import is_right, named, nearest_of, vectors_named
from planes.check.reading.strokes import ReadDrawing, Stroke, Words
from planes.check.reading.words_near import led_to_vectors, put
from planes.check.vision.ink import PENCIL, WHITE, Ink
from planes.check.vision.picture import cv
from planes.check.vision.places import Seen, rounded
from planes.check.vision.printed_apart import (
    ALONG_MM,
    APART_MM,
    ASIDE_MM,
    along,
    apart,
    hides,
    of_lines,
    past_end,
    poles_of,
    untold,
)
from planes.check.vision.printed_heads import BOTH_SIDES, HIDDEN, PRESUMED, THICK, PrintedHead, heads_along, heads_on
from planes.geometry.arrays import Greys
from planes.words.names import POLE, at, kind_of, label_of

ACROSS_MM = 0.1  # in which a head is looked for aside
NEAR_MM = 0.3  # aside, of what is not drawn aside
SURE_MM = 4.0  # a shorter vector may be there unseen: it is put where it should be
TOLD_MM = 3.0  # a plan none of whose marks is farther from the right one's is not told from it
LED_MM, AWAY_MM = 1.6, 3.0  # how near to what it names a name's line ends; how far from all marks it begins
DRAWN_MM = 0.3  # a shorter one is not drawn
COVERED, SLIM_MM = 0.9, 0.25
ERROR_MM = 0.15
FAINT, MAINLY = 100, 0.7  # of 255: paler is no print's ink, but its rims; the share of ink that is no darker
WILDEST_MM = 400.0
KNOT_MM = 5.0  # nearer to where vectors begin or end together their ink looks like a head

Tips = Mapping[str, list[complex]]  # where the head of a vector of that name may be


@dataclass
class PrintedSheet:
    """What is printed: ink with its clear heads, and words."""

    bench: PreparedPlan
    seen: Seen
    words: Sequence[Words]
    ink: Ink = field(init=False)
    heads: list[PrintedHead] = field(init=False)
    tips: dict[tuple[complex, complex], list[complex]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        even = _as_printed(self.seen.ink.dark)
        self.ink = replace(self.seen.ink, even=even, whole=even, letters=None)
        self.words = [one for word in self.words for one in word.listed()]
        self.heads = heads_on(self.ink, self.seen.lines)

    @property
    def force(self) -> bool:
        """Whether its vectors may stand aside."""
        return kind_of(self.bench.asked.plan) == "force"

    @property
    def aside(self) -> float:
        """How far aside a vector may be drawn, mm."""
        return ASIDE_MM if self.force else NEAR_MM

    def right(self) -> list[ReadMark]:
        """The marks of the right plan; none where it is not what is drawn."""
        spots = self._laid(None)
        return spots if is_right(self.bench, ReadPaper("", spots)) else []

    def wrong(self) -> list[ReadMark]:
        """The marks of the plan with a mistake of the catalogue; none where no such is drawn."""
        variants = variants_of(self.bench, {}, self.bench.said_mu)
        found = (self._laid(v, hidden) for hidden in (False, True) for v in variants)
        return next((spots for spots in found if spots), [])

    def _laid(self, variant: Variant | None, hidden: bool = True) -> list[ReadMark]:
        """The marks of a plan drawn so, if need be with heads hidden by other ink; none where it is not."""
        vectors, wrong = self._vectors(variant), variant is not None
        if any(s.name not in vectors for s in self.needed) or (wrong and not self._told(vectors)):
            return []
        read = (
            self._read(pole, vectors, wrong, hidden)
            for pole in poles_of(self.heads, vectors.values(), self.aside, wrong)
        )
        return next((spots for spots in read if spots), [])

    @cached_property
    def needed(self) -> list[Side]:
        """The vectors the plan is made of."""
        plan = self.bench.asked.plan
        return sides_of(self.bench.plans, plan) if self.force else between(self.bench)

    def _vectors(self, variant: Variant | None) -> dict[str, Stroke]:
        """Every vector that may be drawn, from the pole."""
        things, plan = redrawn(self.bench, variant, lambda step, made: made) or {}, self.bench.asked.plan

        def end(name: str) -> complex:
            return 0j if name == POLE else complex(things.get(at(plan, name), math.nan))

        found = {s.name: (end(s.start), end(s.end)) for s in [*between(self.bench), *self.needed]}
        return {n: (a, b) for n, (a, b) in found.items() if abs(a) + abs(b) < WILDEST_MM}

    def _told(self, wrong: Mapping[str, Stroke]) -> bool:
        """Whether a plan with a mistake can be told from the right one, and leaves out no vector that is named."""
        right, names = self._vectors(None), self.bench.written(s.name for s in self.needed)
        lettered = {names.find(w.text) for w in self.words} if self.force else set()
        moved = max((abs(wrong[n][1] - b) for n, (_, b) in right.items() if n in wrong), default=0.0)
        sizes = {n: abs(b - a) for n, (a, b) in wrong.items() if n in lettered}
        drawn = {n for n, (a, b) in right.items() if abs(b - a) > DRAWN_MM}
        return moved > TOLD_MM and all(long > DRAWN_MM for n, long in sizes.items() if n in drawn)

    def _read(self, pole: complex, vectors: Mapping[str, Stroke], wrong: bool, hidden: bool) -> list[ReadMark]:
        """The marks of a plan with its vectors at a pole; none where one has no head, or, if it is not the right plan,
        a clear head is no vector's."""
        found: dict[str, list[complex]] = {}
        for name, (a, b) in vectors.items():
            found[name] = self._heads(pole + a, pole + b) if abs(b - a) > DRAWN_MM else []
            if not found[name] and abs(b - a) > SURE_MM and not hidden and any(s.name == name for s in self.needed):
                return []
        tips = [z for held in found.values() for z in held]
        drawn = [(pole, pole), *((pole + vectors[n][0], z) for n, held in found.items() for z in held)]
        for name, (a, b) in ((s.name, vectors[s.name]) for s in self.needed if not found[s.name]):
            if abs(b - a) > SURE_MM:
                if not self._hidden(pole + a, pole + b, drawn, self.aside):
                    return []
                found[name] = [] if self.force else [pole + b]
        if any(
            self._longer(pole + a, pole + b, found[s.name], tips) for s in self.needed for a, b in [vectors[s.name]]
        ):
            return []
        clear = [h.tip for h in self.heads if h.clear > BOTH_SIDES] if wrong else []
        knots = [pole, *(z for stroke in drawn for z in stroke)] if hidden else [pole]
        clear = [z for z in clear if all(abs(z - k) > KNOT_MM for k in knots)]
        if not tips or any(min(abs(z - tip) for tip in tips) > ALONG_MM for z in clear):
            return []
        return (self._rows if self.force else self._marks)(pole, vectors, found)

    def _longer(self, a: complex, b: complex, own: Sequence[complex], tips: Sequence[complex]) -> bool:
        """Whether the line of a vector goes on past where it ends, to a head that is no other's."""
        if abs(b - a) < SURE_MM:
            return False
        way = (b - a) / abs(b - a)
        ends = own or [b + 1j * t * way for t in self._inked(a, b, self.aside)]
        clear = [h for h in self.heads if h.clear > (BOTH_SIDES if own else PRESUMED)]
        past = ((end, z) for end in ends for z in past_end(end, way, clear, tips))
        return any(self.ink.covered(end + NEAR_MM * way, z, SLIM_MM) > COVERED for end, z in past)

    def _heads(self, a: complex, b: complex) -> list[complex]:
        """Tips of the heads a vector may have that should lead from a to b (remembered)."""
        key = rounded(a), rounded(b)
        if key not in self.tips:
            self.tips[key] = list(self._looked(a, b))
        return self.tips[key]

    def _looked(self, a: complex, b: complex) -> Iterator[complex]:
        if inked := self._inked(a, b, self.aside):
            way = (b - a) / abs(b - a)
            ends = b - ALONG_MM * way, b + ALONG_MM * way
            yield from (h.tip for h in heads_along(self.ink, *ends, abs(b - a), inked))

    def _inked(self, a: complex, b: complex, aside: float) -> list[float]:
        """How far to either side of the way from a to b ink leads along it, the nearest first."""
        way, count = (b - a) / abs(b - a), round(aside / ACROSS_MM)
        beside = [ACROSS_MM * k for k in sorted(range(-count, count + 1), key=abs)]
        start, end = a + NEAR_MM * way, b - NEAR_MM * way
        return [t for t in beside if self.ink.covered(start + 1j * t * way, end + 1j * t * way, SLIM_MM) > COVERED]

    def _hidden(self, a: complex, b: complex, others: Sequence[Stroke], aside: float = 0.0) -> bool:
        """Whether a vector's head may be within the ink of others that end, or pass, beside it."""
        if not any(hides(b, other) for other in others) or not (inked := self._inked(a, b, aside)):
            return False
        ends = b - NEAR_MM * (b - a) / abs(b - a), b + NEAR_MM * (b - a) / abs(b - a)
        heads = heads_along(self.ink, *ends, abs(b - a), inked, HIDDEN)
        return any(hides(h.tip, other) for h in heads for other in others)

    def _rows(self, pole: complex, vectors: Mapping[str, Stroke], found: Tips) -> list[ReadMark]:
        """Vectors of a force plan, each a row of its own."""
        strokes: list[Stroke] = []
        for name, (a, b) in vectors.items():
            way = (b - a) / abs(b - a) if a != b else 1
            seen = abs(b - a) > SURE_MM  # what looks like a shorter one's head may be a letter, or another's head
            reach = APART_MM if abs(b - a) < 2 * THICK.long else ALONG_MM  # and on a short shaft, turned, its own
            near = [tip for tip in found[name] if abs(((tip - pole - b) / way).real) < reach]
            tips = of_lines(near, pole + b, way) if seen else []
            drawn = [(tip - way * ((tip - pole - a) / way).real, tip) for tip in tips]
            if all(abs(tip - pole - b) > APART_MM and self._hidden(pole + a, pole + b, [(tip, tip)]) for tip in tips):
                drawn = [(pole + a, pole + b)] if abs(b - a) > DRAWN_MM else []
            strokes += [new for new in drawn if all(apart(new, old) for old in strokes)]
        ways = [1] * len(strokes)
        lines = [line.ends for line in self.seen.lines if not any(along(line.ends, s) for s in strokes)]
        both = ReadDrawing("", [*strokes, *lines], list(self.words), ways=ways + [0] * len(lines))
        led = led_to_vectors(both, LED_MM)
        sketch = ReadDrawing("", strokes, [*self.words, *led], ERROR_MM, ways)
        true = {s.name: b - a for s in self.needed for a, b in [vectors[s.name]]}
        spots = vectors_named(sketch, self.bench, true, [b - a for a, b in vectors.values()], SURE_MM).spots
        ends = {(s.start, s.end) for s in self.needed}
        sums = [b - a for s in between(self.bench) if (s.start, s.end) not in ends for a, b in [vectors[s.name]]]
        told = [(a.place, b.place) for a, b in zip(spots[::2], spots[1::2], strict=True)]
        rest = untold(strokes, told, self.heads)
        return [] if any(all(abs(b - a - v) > 2 * ALONG_MM for v in sums) for a, b in rest) else spots

    def _led(self, places: Sequence[complex]) -> Iterator[Words]:
        """Words with a line from them to one of some places, as if they stood there."""
        for a, b in (way for line in self.seen.lines for way in (line.ends, line.ends[::-1])):
            end = min(places, key=lambda z: abs(z - b))
            if abs(end - b) < LED_MM and all(abs(a - z) > AWAY_MM for z in places):
                yield from put(self.words, a, end)

    def _marks(self, pole: complex, vectors: Mapping[str, Stroke], found: Tips) -> list[ReadMark]:
        """Marks of a motion plan, where the heads are of the vectors that end in them."""
        ends = {s.end: vectors[s.name][1] for s in self.needed}
        places = {POLE: pole}
        for mark, z in ends.items():
            tips = [tip for s in self.needed if s.end == mark for tip in found[s.name]]
            same = [w for n, w in places.items() if abs(z - ends.get(n, 0j)) < DRAWN_MM]
            places |= {mark: same[0]} if same else {mark: min(tips, key=lambda t: abs(t - pole - z))} if tips else {}
        names = self.bench.names
        words = [(names.find(w.text), w) for w in [*self.words, *self._led([*places.values()])]]
        lettered = {n for n, _ in words if n} & places.keys()
        labels = {label_of(m) for m in self.bench.marks} & places.keys()
        told = named(places, lettered, nearest_of(words))
        return [ReadMark(n, places[n], ERROR_MM) for n in (POLE, *sorted(labels))] if told else []


def _as_printed(dark: Greys) -> Greys:
    """The picture, all of its ink held against what it is mostly: edges are where they were printed."""
    inked = dark[dark > FAINT]
    black = float(numpy.quantile(inked, MAINLY)) if len(inked) else float(WHITE)
    shares: Greys = cv().divide(dark, numpy.full_like(dark, black), scale=255 - PENCIL)
    return 255 - shares
