"""A force polygon sought on a sheet: the chain of its vectors that leaves the least ink unexplained.

Forces known beforehand may stand in any order; the closing reactions come after them, of whatever length. From the
pole each vector that is left is tried: where it would lead there must be a place where something ends, and ink on the
way there. What is hidden (too small, or between two vectors of one direction) is put where it should be, with the
error of drawing it.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from itertools import combinations, permutations

import numpy

from planes.check.grading.handwork import Miss
from planes.check.vision.marks.places import HEADED_MM, TIP_MM
from planes.check.vision.search.costs import DOUBTFUL, GATE, NO_END, VAGUE, sigmas_of
from planes.check.vision.search.ink_cover import COVERED, OTHER_HEAD, PER_MM, STEP_MM, InkCover
from planes.check.vision.search.polygon_cover import NOTHING_MM, End, Guess, LaidChain, PolygonCorner
from planes.check.vision.strokes.line_places import END_MM, Place
from planes.check.vision.strokes.meeting import crossing, on

TINY_MM, MOST_HIDDEN = 1.6, 3.5  # a vector shorter than this may be hidden where two others meet
HIDDEN, NO_INK = 1.5, 5.0  # what an end costs that is not seen, of a vector of a millimetre; if no ink is on its way
# what it costs that so much more of a vector is not drawn than may be; how much more at most
BARE, MOST_BARE = 12.0, 0.3
LOOSE_MM = 1.6  # σ of a vector that may as well end unseen as at a place near by
ON_MM = 3.0  # by which a line goes on at the end of a vector that is not seen on it
OPEN = 6.0  # what a polygon costs that does not close
GAP_MM = 1.2  # ends nearer than this to the pole are at it
CROSSED_MM = 0.5  # σ of where lines cross; what ends nearer is there
ASLANT = 0.1  # of a line to another that is the same
NOTHING = 1.0  # what it costs to believe in a closing vector of no length
MOST_STEPS = 1500
MOST_OF_ALL = 60_000  # steps of all ways together; a polygon of six vectors takes some two thousand
MANY, MOST_OF_MANY = 11, 2_000  # sides of a polygon that is first read in its own order; steps in any other one


@dataclass
class SoughtPolygon:
    """A plan's polygon looked for on a sheet."""

    ink: InkCover
    pole: Place
    spread: dict[str, Miss]
    steps: int = 0
    taken: int = 0  # steps of all that were laid
    best: LaidChain | None = None
    most: float = 0.0
    known: dict[tuple[frozenset[str], complex], list[LaidChain]] = field(default_factory=dict)
    ways: dict[tuple[complex, complex], float] = field(default_factory=dict)
    ends: dict[tuple[str, complex, PolygonCorner], list[End]] = field(default_factory=dict)

    @cached_property
    def ended(self) -> list[Place]:
        """Where something ends."""
        return [p for p in self.ink.seen.places if p.ended]

    @cached_property
    def headed(self) -> list[Place]:
        """Where a vector has its head, though its line runs on."""
        return [p for p in self.ink.seen.places if p.tip and not p.ended]

    @cached_property
    def crossed(self) -> list[Place]:
        """Where lines cross and none of them ends, as that of a closing vector may that runs on."""
        lines, found = [x for x in self.ink.seen.lines if x.length > HEADED_MM], list[Place]()
        for one, two in combinations(lines, 2):
            z = crossing(one, two)
            if z is not None and on(one, z, GAP_MM, END_MM) and on(two, z, GAP_MM, END_MM):
                near = any(abs(p.z - z) < CROSSED_MM for p in self.ended)
                found += [] if near else [Place(z, CROSSED_MM, frozenset())]
        return found

    def covered(self, a: complex, b: complex) -> float:
        """The share of the way that is ink (remembered)."""
        key = (a, b)
        if key not in self.ways:
            self.ways[key] = self.ink.seen.covered(a, b)
        return self.ways[key]

    def lay(self, guess: Guess, most: float) -> LaidChain | None:
        """The best chain of a guess that costs less than ``most``."""
        self.best, self.most, self.steps = None, most, 0
        self.known.clear()
        if not self.endless:
            self._lay_known(guess, dict(guess.known), LaidChain(guess.cost, guess=guess), PolygonCorner(self.pole.z))
        self.taken += self.steps
        return self.best

    @property
    def endless(self) -> bool:
        """Whether there are more ways to lay it than can be tried, so that none is surely the best."""
        return self.taken > (MOST_OF_ALL if len(self.spread) < MANY else MOST_OF_MANY)

    def _lay_known(self, guess: Guess, left: Mapping[str, complex], chain: LaidChain, start: PolygonCorner) -> None:
        """Every order of the known vectors that the ink allows, the likeliest first, then the closing ones."""
        self.steps += 1
        if chain.cost >= self.most or self.steps > MOST_STEPS or self._outdone(frozenset(left), chain, start.z):
            return
        if not left:
            for order in permutations(guess.closing):
                self._lay_closing(guess, order, chain, start.z)
        ways = list[tuple[float, str, LaidChain, PolygonCorner]]()
        for name, v in left.items():
            for end in self._ends(guess, name, v, start):
                price, place, sigma, hidden = end
                if chain.cost + price >= self.most:
                    continue
                unseen = (*chain.hidden, name) if hidden and abs(v) > NOTHING_MM else chain.hidden
                longer = self._longer(chain, start.z, price, (name, place, sigma), unseen)
                gained = PER_MM * STEP_MM * (longer.steps & ~chain.steps).bit_count()
                goal = place if name == guess.free else start.z + start.off + v
                corner = start.after(goal, end, self.spread[name].mean)
                ways.append((longer.cost - gained, name, longer, corner))
        for _, name, longer, corner in sorted(ways, key=lambda way: way[0]):
            rest = {n: w for n, w in left.items() if n != name}
            self._lay_known(guess, rest, longer, corner)

    def _outdone(self, left: frozenset[str], chain: LaidChain, z: complex) -> bool:
        """Whether the same place was come to more cheaply, even with all ink and heads this way alone accounts for."""
        found = self.known.setdefault((left, complex(round(z.real, 1), round(z.imag, 1))), [])
        if any(c.cost + self._further(c, chain) <= chain.cost for c in found):
            return True
        found.append(chain)
        return False

    def _further(self, one: LaidChain, other: LaidChain) -> float:
        """What the ink and heads cost, at the most, that a way does not account for, and another one does."""
        steps, heads = other.steps & ~one.steps, other.heads & ~one.heads
        return PER_MM * STEP_MM * steps.bit_count() + OTHER_HEAD * heads.bit_count()

    def _longer(
        self, chain: LaidChain, z: complex, price: float, row: tuple[str, complex, float], hidden: tuple[str, ...] = ()
    ) -> LaidChain:
        """The chain with one more vector, from z."""
        steps, heads = self.ink.along(z, row[1])
        bare = self.ink.bare(z, row[1])
        if bare:  # heads that would lie upon each other are unseen for one cause
            upon = (self.ink.bare(*way) for way in chain.upon(z, row[1], self.pole.z))
            bare = max(bare - max(upon, default=0.0), 0.0)
        cost = chain.cost + price + bare + self.ink.words.price(row[0], z, row[1])
        rows, hidden = [*chain.rows, row], hidden or chain.hidden
        return LaidChain(cost, rows, hidden, chain.steps | steps, chain.heads | heads, chain.guess)

    def _ends(self, guess: Guess, name: str, v: complex, start: PolygonCorner) -> list[End]:
        """Where a vector from a place may end, the likeliest first (remembered)."""
        z = start.z
        if name == guess.free:
            free = [p for p in self.ended if not p.doubtful and abs(p.z - z) > 2]
            free = [p for p in free if self.covered(z, p.z) > COVERED]
            return [(VAGUE * p.sigma, p.z, p.sigma, False) for p in sorted(free, key=lambda p: p.sigma)]
        if abs(v) < NOTHING_MM:
            return [(0.0, z + v, NOTHING_MM, True)]
        if (key := (name, v, start)) not in self.ends:
            self.ends[key] = self._ends_near(*key)
        return self.ends[key]

    def _ends_near(self, name: str, v: complex, start: PolygonCorner) -> list[End]:
        z, off, loose = start
        goal, found = z + off + v, list[End]()
        near = [*self.ink.seen.within(goal, min(4.0 + 0.08 * abs(v), 12.0)), self.pole, self.ink.seen.closer(z, z + v)]
        for p in filter(None, near):
            sigmas = sigmas_of(p.z - goal, self.spread[name], math.hypot(p.sigma, loose))
            bare = 0.0 if abs(v) < 2 else COVERED - self.covered(z, p.z) if sigmas < GATE else 1.0
            if sigmas < GATE and bare < MOST_BARE:
                price = sigmas**2 / 2 + VAGUE * p.sigma + DOUBTFUL * p.doubtful + BARE * max(bare, 0.0)
                price += 0.0 if p.ended or p is self.pole or (p.tip and self.ink.pointed(z, p.z)) else NO_END
                found.append((price, p.z, p.sigma, False))
        found.sort(key=lambda f: f[0])
        least = found[0][0] if found else math.inf
        unsure = least > 1.0 + HIDDEN * min(abs(v), 2.0) or self.spread[name].worst > LOOSE_MM
        if unsure and (abs(v) < TINY_MM or self.covered(z, goal) > 1 - 0.8 / abs(v)):
            upon = abs(v) < TINY_MM and self.covered(z, goal + ON_MM * v / abs(v)) == 1.0  # nothing shows where it ends
            price = min(1.0 + HIDDEN * abs(v) * (not upon), MOST_HIDDEN) + NO_INK * (1 - self.covered(z, goal))
            found.append((price, goal, self.spread[name].worst, True))
        return found

    def _lay_closing(self, guess: Guess, order: tuple[str, ...], chain: LaidChain, z: complex) -> None:
        """The closing vectors after the known ones, the last to the pole (or not, which is a mistake)."""
        if not order:
            chain.cost += self.ink.over(chain.steps, chain.heads, chain.routes(self.pole.z))
            if chain.cost < self.most:
                self.best, self.most = chain, chain.cost
            return
        name, last = order[0], len(order) == 1
        u = None if len(guess.closing) == 1 and guess.known else guess.closing[name]
        for p in [self.pole, *self.ended, *(self.headed if last else self.crossed)]:
            way, closed = p.z - z, p is self.pole or not last
            shown = p is self.pole or p.ended or (p.tip and self.ink.pointed(z, p.z))
            price = self._aside(way, u) + (0.0 if closed else OPEN) + (0.0 if shown else NO_END)
            if p is not self.pole:
                price += VAGUE * p.sigma + DOUBTFUL * p.doubtful
            if price + chain.cost >= self.most or price > 12 + OPEN:
                continue
            if p is not self.pole and last and (abs(p.z - self.pole.z) < GAP_MM or self._runs_on(z, p.z)):
                continue
            if p is self.pole and last and abs(way) > 2 and self._goes_on(z, chain):
                price += OPEN
            if abs(way) < 1 or self.covered(z, p.z) > COVERED:
                self._lay_closing(guess, order[1:], self._longer(chain, z, price, (name, p.z, p.sigma)), p.z)
        if not last:  # a closing vector of no length
            self._lay_closing(guess, order[1:], self._longer(chain, z, NOTHING, (name, z, NOTHING_MM)), z)

    def _goes_on(self, z: complex, chain: LaidChain) -> bool:
        """Whether the line from z to the pole ends beyond it, where no other vector does."""
        way = self.pole.z - z
        for end in (p.z for p in (*self.ended, *self.headed) if abs(p.z - z) >= abs(way) + 2.4 and self._along(p, way)):
            turned = (end - z) * way.conjugate()
            on = turned.real >= 0 and abs(turned.imag) < 1.2 * abs(end - z)
            apart = on and all(abs(end - other) >= GAP_MM for _, other, _ in chain.rows)
            hidden = self.ink.seen.ink.lettered(end)[0] or self.ink.on_sign(numpy.array([end]))[0]
            drawn = apart and not hidden and self.covered(z, end) > 0.9
            if drawn and not self._runs_on(z, end):
                return True
        return False

    def _runs_on(self, z: complex, end: complex) -> bool:
        """Whether what is drawn from z to an end is a construction line there: it grows faint, or comes by the pole
        and has a head there whose sides are seen, or none at its end where vectors have heads."""
        if self.ink.runs_out(z, end):
            return True
        past = (end - z) / (self.pole.z - z) if z != self.pole.z else 0j
        if past.real <= 1 or abs(past.imag * (self.pole.z - z)) >= GAP_MM:
            return False
        tip = self.ink.seen.closer(z, self.pole.z)
        shown = self.ink.along(z, self.pole.z)[1] or (tip is not None and tip.sigma <= TIP_MM)
        return bool(shown) or (self.ink.headed and not self.ink.pointed(z, end))

    def _along(self, place: Place, way: complex) -> bool:
        """Whether a line that is seen to end at a place runs a way."""
        if place.tip:
            return self.ink.along(self.pole.z, place.z)[1] != 0
        ends = ((x := self.ink.seen.lines[k], x.ends[side]) for k, side in place.ended)
        near = (x for x, end in ends if abs(end - place.z) < GAP_MM)
        return any(abs((x.along * way.conjugate()).imag) < ASLANT * abs(way) for x in near)

    def _aside(self, way: complex, u: complex | None) -> float:
        """What it costs that a closing vector is not quite in its direction."""
        if u is None:
            return 0.0
        aside = abs((way * u.conjugate()).imag)
        return 0.5 * (aside / (0.35 + 0.012 * abs(way))) ** 2
