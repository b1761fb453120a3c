"""Ways a force polygon may have been drawn: rightly, or with a mistake of the catalogue; as vectors by name."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import NamedTuple, Self

from planes.check.grading.handwork import Hand, Miss
from planes.check.grading.paper import ReadMark
from planes.check.grading.polygons import Side
from planes.check.grading.prepared_plan import PreparedPlan, redrawn, variants_of
from planes.check.grading.variants import Variant
from planes.check.vision.marks.handwritten import HandWords
from planes.check.vision.marks.places import Seen, rounded
from planes.check.vision.marks.print_scale import seen_from
from planes.check.vision.search.costs import slip
from planes.check.vision.search.ink_cover import COVERED
from planes.drafting.steps import Step
from planes.drafting.steps.crossings import Cross
from planes.words.frozen import frozen
from planes.words.names import POLE, at, label_of, links_of, plan_of

HAND_MM, SURELY = 1.8, 3.0  # how far astray a hand leads, and of how many σ
NOTHING_MM, NAMED_MM = 0.3, 3.0  # a shorter vector is not drawn; one so long has a name
WILDEST_MM = 400.0  # nobody draws a longer vector on a sheet
TURNED = 0.01  # the sine of the angle by which lines of a reaction differ on paper
ASLANT = 0.1  # of vectors whose heads would lie upon each other

End = tuple[float, complex, float, bool]  # where a vector may end: its price, the place, its σ, whether it is hidden


class PolygonCorner(NamedTuple):
    """Where two vectors meet: the place, how far from it the person likelier has it, and the σ of that (both to a tenth
    of a millimetre, so that what starts there can be remembered), mm."""

    z: complex
    off: complex = 0j
    loose: float = 0.0

    def after(self, goal: complex, end: End, drawn: float) -> PolygonCorner:
        """The end of a vector from here that should be at a goal, which a hand misses by ``drawn`` (σ): as the start of
        the next, so that where it was misread that tells against both vectors but once."""
        _, z, sigma, hidden = end
        drawn = math.hypot(drawn, self.loose)
        if hidden:
            return PolygonCorner(z, goal - z, math.hypot(self.loose, sigma))
        if sigma < drawn:
            return PolygonCorner(z)  # it is where it is read
        share = sigma**2 / (sigma**2 + drawn**2)
        return PolygonCorner(z, rounded(share * (goal - z)), round(math.sqrt(share) * drawn, 1))


@frozen
class Guess:
    """One way the polygon may have been drawn: its known vectors, the closing ones, what believing it costs."""

    known: Mapping[str, complex]
    closing: Mapping[str, complex]  # unit directions
    cost: float = 0.0
    free: str = ""  # a vector that may be anywhere

    def missing(self, right: Self) -> list[str]:
        """The vectors of the right polygon that are none here."""
        return [n for n, v in right.known.items() if abs(v) > 1 and abs(self.known.get(n, v)) < NOTHING_MM]

    def moved(self, right: Self, mm: float) -> set[str]:
        """The vectors it puts elsewhere than the right polygon by more than that, or anywhere, and the closing ones it
        turns: what is less shows on no paper."""
        known = {n for n, v in self.known.items() if n == self.free or abs(v - right.known[n]) > mm}
        return known | {n for n, u in self.closing.items() if abs((u * right.closing[n].conjugate()).imag) > TURNED}

    def unwritten(self, words: HandWords, right: Self) -> float:
        """What it costs to believe that nobody drew these, for where names were read: a short one may have none."""
        found = ((words.unwritten(name), abs(right.known[name])) for name in self.missing(right))
        return sum(cost if length > NAMED_MM else max(cost, 0.0) for cost, length in found)


@dataclass
class LaidChain:
    """A chain of vectors laid on the picture: (name, where it ends, how surely)."""

    cost: float
    rows: list[tuple[str, complex, float]] = field(default_factory=list)
    hidden: tuple[str, ...] = ()
    steps: int = 0  # of ink, and heads, that the vectors account for: bits
    heads: int = 0
    guess: Guess | None = None  # it is laid by

    def routes(self, pole: complex) -> list[tuple[complex, complex]]:
        """Where its vectors run, from a pole."""
        return list(pairwise([pole, *(z for _, z, _ in self.rows)]))

    def upon(self, a: complex, b: complex, pole: complex) -> list[tuple[complex, complex]]:
        """Its vectors that end where one from a to b does, and point as that does."""
        turned = ((way, (way[1] - way[0]) * (b - a).conjugate()) for way in self.routes(pole) if way[1] == b)
        return [way for way, turn in turned if abs(turn.imag) < ASLANT * turn.real]

    def vectors(self, pole: complex) -> dict[str, complex]:
        """Its vectors by name."""
        return {n: b - a for (n, _, _), (a, b) in zip(self.rows, self.routes(pole), strict=True)}

    def named(self, words: HandWords, pole: complex) -> float:
        """By how many of its vectors their names stand, as surely as they were read."""
        return sum(words.told(n, a, b) for (n, _, _), (a, b) in zip(self.rows, self.routes(pole), strict=True))

    def astray(self, right: Guess, spread: Mapping[str, Miss], pole: complex) -> float:
        """By how many times a hand's error the end of a known vector is from where it should be, seen from its start:
        such as it makes at all, or as what the vector is reckoned from may have."""
        known = {n: v for n, v in self.vectors(pole).items() if n in right.known}
        off = (abs(v - right.known[n]) / max(HAND_MM, SURELY * spread[n].worst) for n, v in known.items())
        return max(off, default=0.0)

    def shows_nothing(self, right: Guess) -> bool:
        """Whether a vector that it has elsewhere than the right polygon is one whose end is not seen."""
        return self.guess is not None and not self.guess.moved(right, NOTHING_MM).isdisjoint(self.hidden)

    def left_out(self, name: str, right: Guess, pole: complex) -> bool:
        """Whether a known vector of some length is laid with none: nobody drew it."""
        drawn, true = abs(self.vectors(pole)[name]), abs(right.known.get(name, 0j))
        return true > 1 and drawn < min(0.4 * true, 0.8)


@frozen
class ReadPolygon:
    """Rows of a polygon, none where it cannot surely be told what was drawn; whether nothing can have been overlooked;
    the share of ink explained; ends not seen; vectors that a mistake puts elsewhere and explains the ink as well;
    whether it was drawn with a mistake, and no right one explains the ink nearly as well."""

    spots: list[ReadMark] = field(default_factory=list)
    whole: bool = False
    explained: float = 0.0
    hidden: tuple[str, ...] = ()
    untold: tuple[str, ...] = ()
    apart: bool = False


def polygon_of(sides: Iterable[Side], plan: str) -> list[Side]:
    """The sides of the outer polygon: the longest way round from the pole; reactions within the group are chords."""
    links = links_of(plan)
    inner = {f"F_{a}{mid}{b}" for a in links for b in links for mid in ("", "_")}
    sides = [s for s in sides if s.name.rstrip("nt") not in inner]
    best: list[Side] = []

    def walk(z: str, way: list[Side]) -> None:
        nonlocal best
        for s in sides:
            if s.start == z and s.end not in [w.end for w in way]:
                if s.end == POLE:
                    best = max(best, [*way, s], key=len)
                else:
                    walk(s.end, [*way, s])

    walk(POLE, [])
    return best


def guesses(bench: PreparedPlan, sides: list[Side], loads: set[str]) -> list[Guess]:
    """The right polygon first, then one of every mistake, none twice."""
    found, seen = list[Guess](), set[tuple[complex, ...]]()
    for variant in (None, *variants_of(bench, {}, bench.said_mu)):
        vectors = _vectors(bench, sides, variant)
        if vectors is None:
            continue
        known = {s.name: vectors[s.name] for s in sides if s.end in loads}
        closing = {s.name: vectors[f"|{s.name}"] for s in sides if s.end not in loads}
        key = tuple(complex(round(v.real * 2), round(v.imag * 2)) for v in known.values())
        key += tuple(complex(round((u * u).real * 20), round((u * u).imag * 20)) for u in closing.values())
        if key not in seen and max(map(abs, known.values()), default=0.0) < WILDEST_MM:
            seen.add(key)
            found.append(Guess(known, closing))
    return found[:1] + [replace(guess, cost=slip(len(found) - 1)) for guess in found[1:]]


def _vectors(bench: PreparedPlan, sides: list[Side], variant: Variant | None) -> dict[str, complex] | None:
    """Every vector by name, and the direction of every closing one by |name."""
    things = redrawn(bench, variant, lambda step, made: made)
    if things is None:
        return None
    plan = bench.asked.plan
    ends = {n: 0j if n == POLE else complex(things[at(plan, n)]) for s in sides for n in (s.start, s.end)}
    out = {s.name: ends[s.end] - ends[s.start] for s in sides}
    swaps = variant.swaps if variant else {}
    lines = _lines([one for step in bench.program.steps for one in swaps.get(step.makes, (step,))], plan)
    for s in sides:
        u = out[s.name] if abs(out[s.name]) > 1 else 0j
        for pair in ((s.start, s.end), (s.end, s.start)):
            u = things[lines[pair]] if pair in lines else u
        out[f"|{s.name}"] = complex(u) / abs(u) if u else 1 + 0j
    return out if all(math.isfinite(abs(v)) for v in out.values()) else None


def _lines(steps: Iterable[Step], plan: str) -> dict[tuple[str, str], str]:
    """The directions of crossed lines by the labels of the marks they lead between."""
    found = {}
    for step in steps:
        if isinstance(step, Cross) and plan_of(step.makes) == plan:
            found[label_of(step.start), label_of(step.makes)] = step.along
            found[label_of(step.other), label_of(step.makes)] = step.across
    return found


def spread_of(bench: PreparedPlan, sides: list[Side]) -> dict[str, Miss]:
    """The covariance of every vector as a hand would draw it."""
    hand, plan = Hand(bench.program, bench.given, bench.asked.skill, {}), bench.asked.plan
    ends = {n: 0j if n == POLE else hand.things[at(plan, n)] for s in sides for n in (s.start, s.end)}
    return {s.name: hand.miss(0j, ends[s.end] - ends[s.start]) for s in sides}


def seen_like(bench: PreparedPlan, sides: list[Side], seen: Seen) -> Iterator[tuple[str, complex, complex]]:
    """What may be vectors of the polygon: ink between two places about as far apart in their directions."""
    right = _vectors(bench, sides, None) or {}
    true = {s.name: right[s.name] for s in sides if s.name in right}
    for place in seen.places:
        for name, drawn, v in seen_from(seen, place.z, true) if place.ended else ():
            if seen.ink.covered(place.z, place.z + drawn) > COVERED:
                yield name, drawn, v
