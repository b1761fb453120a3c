"""A force polygon on a picture: its vectors told apart by laying every way it may have been drawn on the ink.

Forces known beforehand may stand in any order; the closing reactions come after them, of whatever length. From the
pole each vector that is left is tried: where it would lead there must be a place where something ends, and ink on the
way there. Rightly drawn, with each mistake of the catalogue, or with one vector anywhere: what leaves the least ink
unexplained tells the names. What is hidden (too small, or between two vectors of one direction) is put where it
should be, with an error as large as itself.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from itertools import pairwise, permutations

from planes.check.bench import Bench, variants_of
from planes.check.handwork import Hand, Miss, Variant
from planes.check.motion_seen import (
    ANYWHERE, COVERED, DOUBTFUL, GATE, NO_END, PER_MM, SLIP, VAGUE, pole_on, redrawn, sigmas_of,
)  # fmt: skip
from planes.check.paper import Spot
from planes.check.places import Place, Seen
from planes.check.polygons import Side, loads_of, sides_of
from planes.naming import POLE, at, label_of, plan_of
from planes.steps import Cross, Step

NOTHING_MM = 0.3  # a vector shorter than this is not drawn
TINY_MM = 1.6  # a vector shorter than this may be hidden where two others meet
HIDDEN = 1.5  # what it costs to believe in an end that is not seen, for a vector of a millimetre
OPEN = 6.0  # what a polygon costs that does not close
GAP_MM = 1.2  # ends nearer than this to the pole are at it
NOTHING = 1.0  # what it costs to believe in a closing vector of no length
MOST_STEPS = 4000


@dataclass(frozen=True)
class Guess:
    """One way the polygon may have been drawn: its known vectors, the closing ones, what believing it costs."""

    known: Mapping[str, complex]
    closing: Mapping[str, complex]  # unit directions
    cost: float = 0.0
    free: str = ""  # a vector that may be anywhere


@dataclass
class Laid:
    """A chain of vectors laid on the picture: (name, where it ends, how surely)."""

    cost: float
    rows: list[tuple[str, complex, float]] = field(default_factory=list)
    closed: bool = True


@dataclass
class Polygon:
    """A plan's polygon looked for on a sheet."""

    seen: Seen
    pole: Place
    sides: list[Side]
    loads: set[str]
    spread: dict[str, Miss]
    steps: int = 0
    best: Laid | None = None
    most: float = 0.0
    known: dict[tuple[frozenset[str], complex], float] = field(default_factory=dict)
    ways: dict[tuple[complex, complex], float] = field(default_factory=dict)

    def covered(self, a: complex, b: complex) -> float:
        """The share of the way that is ink (remembered)."""
        key = (a, b)
        if key not in self.ways:
            self.ways[key] = self.seen.ink.covered(a, b)
        return self.ways[key]

    def lay(self, guess: Guess, most: float) -> Laid | None:
        """The best chain of a guess that costs less than ``most``."""
        self.best, self.most, self.steps = None, most, 0
        self.known.clear()
        self._lay_known(guess, dict(guess.known), Laid(guess.cost), self.pole.z, 0.0)
        return self.best

    def _lay_known(self, guess: Guess, left: Mapping[str, complex], chain: Laid, z: complex, loose: float) -> None:
        """Every order of the known vectors that the ink allows, then the closing ones."""
        key = frozenset(left), complex(round(z.real, 1), round(z.imag, 1))
        self.steps += 1
        if chain.cost >= min(self.most, self.known.get(key, math.inf)) or self.steps > MOST_STEPS:
            return
        self.known[key] = chain.cost
        if not left:
            for order in permutations(guess.closing):
                self._lay_closing(guess, order, chain, z)
        for name, v in left.items():
            rest = {n: w for n, w in left.items() if n != name}
            for price, place, sigma, hidden in self._ends(guess, name, v, z, loose):
                rows = [*chain.rows, (name, place, sigma)]
                now = math.hypot(loose, sigma) if hidden else 0.0
                self._lay_known(guess, rest, Laid(chain.cost + price, rows), place, now)

    def _ends(
        self, guess: Guess, name: str, v: complex, z: complex, loose: float
    ) -> list[tuple[float, complex, float, bool]]:  # fmt: skip
        """Where a vector from z may end: its price, the place, its σ, and whether it is hidden; the likeliest first."""
        if name == guess.free:
            return sorted((VAGUE * p.sigma, p.z, p.sigma, False) for p in self._ended()
                          if not p.doubtful and abs(p.z - z) > 2 and self.covered(z, p.z) > COVERED)  # fmt: skip
        if abs(v) < NOTHING_MM:
            return [(0.0, z + v, NOTHING_MM, True)]
        goal = z + v
        found: list[tuple[float, complex, float, bool]] = []
        for p in [*self.seen.within(goal, min(4.0 + 0.08 * abs(v), 12.0)), self.pole]:
            sigmas = sigmas_of(p.z - goal, self.spread[name], math.hypot(p.sigma, loose))
            if sigmas < GATE and (abs(v) < 2 or self.covered(z, p.z) > COVERED):
                price = sigmas**2 / 2 + VAGUE * p.sigma + DOUBTFUL * p.doubtful
                price += 0.0 if p.ended or p.tip or p is self.pole else NO_END
                found.append((price, p.z, p.sigma, False))
        found.sort(key=lambda f: f[0])
        least = found[0][0] if found else math.inf
        if least > 1.0 + HIDDEN * min(abs(v), 2.0) and (abs(v) < TINY_MM or self.covered(z, goal) > 1 - 0.8 / abs(v)):
            price = min(1.0 + HIDDEN * abs(v), 5.0)
            found.append((price, goal, min(0.3 + 0.5 * abs(v), 1.0), True))
        return found

    def _ended(self) -> list[Place]:
        return [p for p in self.seen.places if p.ended]

    def _lay_closing(self, guess: Guess, order: tuple[str, ...], chain: Laid, z: complex) -> None:
        """The closing vectors after the known ones, the last to the pole (or not, which is a mistake)."""
        if not order:
            chain.cost += PER_MM * self.unexplained(chain)
            if chain.cost < self.most:
                self.best, self.most = chain, chain.cost
            return
        name, last = order[0], len(order) == 1
        u = None if len(guess.closing) == 1 and guess.known else guess.closing[name]
        for p in [self.pole, *self._ended()]:
            way, closed = p.z - z, p is self.pole or not last
            price = self._aside(way, u) + (0.0 if closed else OPEN)
            if p is not self.pole:
                price += VAGUE * p.sigma + DOUBTFUL * p.doubtful
                if last and abs(p.z - self.pole.z) < GAP_MM:
                    continue
            elif last and abs(way) > 2 and self._goes_on(way / abs(way), chain):
                price += OPEN
            if price + chain.cost < self.most and price < 12 + OPEN and (abs(way) < 1 or self.covered(z, p.z) > COVERED):
                rows = [*chain.rows, (name, p.z, p.sigma)]
                self._lay_closing(guess, order[1:], Laid(chain.cost + price, rows, closed), p.z)
        if not last:  # a closing vector of no length
            rows = [*chain.rows, (name, z, NOTHING_MM)]
            self._lay_closing(guess, order[1:], Laid(chain.cost + NOTHING, rows), z)

    def _goes_on(self, u: complex, chain: Laid) -> bool:
        """Whether there is ink beyond the pole in a direction in which no vector starts there."""
        first = chain.rows[0][1] - self.pole.z if chain.rows else 0j
        if abs((first * u.conjugate()).imag) < 1 and (first * u.conjugate()).real > 0:
            return False
        return self.covered(self.pole.z + 2.4 * u, self.pole.z + 5 * u) > 0.9

    def _aside(self, way: complex, u: complex | None) -> float:
        """What it costs that a closing vector is not quite in its direction."""
        if u is None:
            return 0.0
        aside = abs((way * u.conjugate()).imag)
        return 0.5 * (aside / (0.35 + 0.012 * abs(way))) ** 2

    def unexplained(self, laid: Laid) -> float:
        """How many mm of ink no vector runs along."""
        ends = [self.pole.z, *(z for _, z, _ in laid.rows)]
        return self.seen.left([(a, b) for a, b in pairwise(ends) if a != b], self.pole.z)


def _left_out(name: str, laid: Laid, right: Guess) -> bool:
    """Whether a known vector of some length is laid with none: nobody drew it."""
    ends = [0j, *(z for _, z, _ in laid.rows)]
    k = next(i for i, row in enumerate(laid.rows) if row[0] == name)
    start = ends[k] if k else None
    true = abs(right.known.get(name, 0j))
    return start is not None and true > 1 and abs(ends[k + 1] - start) < 0.4 * true and abs(ends[k + 1] - start) < 0.8


def polygon_of(sides: Iterable[Side], loads: set[str]) -> list[Side]:
    """The sides of the outer polygon: the longest way round from the pole; chords of it are left out."""
    sides = list(sides)
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


def guesses(bench: Bench, sides: list[Side], loads: set[str]) -> list[Guess]:
    """The right polygon first, then one of every mistake, none twice."""
    hand = Hand(bench.program, bench.given, bench.asked.skill, {})
    found: list[Guess] = []
    seen: set[tuple[complex, ...]] = set()
    variants: list[Variant | None] = [None, *variants_of(bench, hand, bench.said_mu)]
    for variant in variants:
        vectors = _vectors(bench, sides, variant)
        if vectors is None:
            continue
        known = {s.name: vectors[s.name] for s in sides if s.end in loads}
        closing = {s.name: vectors[f"|{s.name}"] for s in sides if s.end not in loads}
        key = tuple(complex(round(v.real * 2), round(v.imag * 2)) for v in known.values())
        key += tuple(complex(round((u * u).real * 20), round((u * u).imag * 20)) for u in closing.values())
        if key not in seen and max(map(abs, known.values()), default=0.0) < 400:
            seen.add(key)
            found.append(Guess(known, closing, SLIP if variant else 0.0))
    return found


def _vectors(bench: Bench, sides: list[Side], variant: Variant | None) -> dict[str, complex] | None:
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


def spread_of(bench: Bench, sides: list[Side]) -> dict[str, Miss]:
    """The covariance of every vector as a hand would draw it."""
    hand, plan = Hand(bench.program, bench.given, bench.asked.skill, {}), bench.asked.plan
    def end(name: str) -> object:
        return 0j if name == POLE else hand.things[at(plan, name)]
    return {s.name: hand.miss(0j, end(s.end) - end(s.start)) for s in sides}  # type: ignore[operator]


def vectors_on(bench: Bench, seen: Seen, near: complex) -> tuple[list[Spot], bool, float]:
    """Rows of the polygon, whether nothing of it can have been overlooked, and the share of ink they explain."""
    plan = bench.asked.plan
    loads = loads_of(bench.plans, plan)
    sides = polygon_of(sides_of(bench.plans, plan), loads)
    polygon = Polygon(seen, pole_on(seen, near), sides, loads, spread_of(bench, sides))
    right, *wrong = guesses(bench, sides, loads)
    best = polygon.lay(right, 60.0)
    if best is None or best.cost > 1.0 + 0.6 * len(sides):
        for guess in wrong:
            laid = polygon.lay(guess, best.cost if best else 60.0)
            best = laid or best
    if best is None or best.cost > ANYWHERE + 4.0 + len(sides):
        for name in right.known:
            laid = polygon.lay(Guess(right.known, right.closing, ANYWHERE, name), best.cost if best else 60.0)
            best = laid or best
    if best is None:
        return [], False, 0.0
    explained = 1 - polygon.unexplained(best) / max(seen.ink_mm, 1.0)
    rows = [Spot(POLE, polygon.pole.z, polygon.pole.sigma)]
    rows += [Spot(n, z, sigma) for n, z, sigma in best.rows if not _left_out(n, best, right)]
    return rows, explained > 0.9, explained
