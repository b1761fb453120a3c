"""A force polygon on a picture: its vectors told apart by laying every way it may have been drawn on the ink.

Rightly drawn, with each mistake of the catalogue, or with one vector anywhere: what leaves the least ink unexplained
tells the names. Where a mistake explains it nearly as well as the right plan, what differs is told as not seen.
"""

import math
from collections.abc import Sequence
from dataclasses import InitVar, dataclass, field, replace
from itertools import product

from planes.check.grading.paper import ReadMark
from planes.check.grading.polygons import Side, loads_of, sides_of
from planes.check.grading.prepared_plan import PreparedPlan
from planes.check.vision.marks.handwritten import words_on
from planes.check.vision.marks.places import HEADED_MM, Seen, pole_on
from planes.check.vision.marks.print_scale import UNLIKELY, by_ruler, likely_shares
from planes.check.vision.match.match_in_order import read_in_order
from planes.check.vision.search.costs import ANYWHERE
from planes.check.vision.search.ink_cover import COVERED, NO_HEAD, InkCover
from planes.check.vision.search.polygon_cover import (
    Guess,
    LaidChain,
    ReadPolygon,
    guesses,
    polygon_of,
    seen_like,
    spread_of,
)
from planes.check.vision.search.polygon_search import GAP_MM, LOOSE_MM, MANY, OPEN, TINY_MM, SoughtPolygon
from planes.check.vision.strokes.line_places import WOBBLE_MM, Place
from planes.words.names import POLE

MOST_COST = 60.0  # of a chain that explains a picture at all
DEEPER = 26.0, MOST_COST  # a chain is first looked for among the cheapest
POOR, POORLY = 8.0, 2.0  # a polygon that costs more than this, and this for each vector, is not surely one
MOST_CORNERS = 12  # of a polygon, at which it may begin
NAMED = 1.5  # how much more a polygon may cost for each vector by which its name stands
UNSURE = 2.6  # how much more a polygon laid rightly must cost than a mistake
APART = 5.0  # by how much a right polygon is dearer where it is out of the question
# a mistake that costs so little more than the right plan leaves in doubt what it moves so far
RIVAL, APART_MM = 1.0, 0.8
PAST_MM, ASIDE_MM = (4.0, 30.0), 0.9  # how far past the pole a head may stand, and its line aside
# the same where all lie in one line (so far aslant, of a length) and letters alone tell, or what it moves is unseen
IN_LINE, ASLANT = 3.0, 0.1
BETTER = 1.0  # or where its ink, with names, is so much better than the right plan's, however unlikely the mistake is


@dataclass
class LaidPolygon:
    """A plan's polygon on a sheet printed at a share of its size: laid rightly, and the likeliest that was laid."""

    bench: InitVar[PreparedPlan]
    ink: InitVar[InkCover]
    pole: InitVar[Place]
    sides: InitVar[list[Side]]
    share: float
    best: LaidChain | None = None
    slip: float = field(init=False)  # what each mistake costs

    def __post_init__(self, bench: PreparedPlan, ink: InkCover, pole: Place, sides: list[Side]) -> None:
        self.polygon = SoughtPolygon(ink, pole, spread_of(bench, sides))
        self.right, *wrong = guesses(bench, sides, loads_of(bench.plans, bench.asked.plan))
        self.slip = max((g.cost for g in wrong), default=0.0)
        self.wrong = [replace(g, cost=g.cost + g.unwritten(ink.words, self.right)) for g in wrong]
        self.best = self.plain = self.polygon.lay(self.right, MOST_COST)

    @property
    def unlikely(self) -> float:
        """What it costs to believe that the sheet was printed so."""
        return UNLIKELY * (self.share != self.polygon.ink.seen.ink.flat.printed)

    def look(self, most: float) -> None:
        """The likeliest chain that costs less than that, or the right one: that if it fits well, else a mistake's, at
        last one with a vector anywhere."""
        most = min(self.plain.cost if self.plain else MOST_COST, most - self.unlikely)
        if most > min((guess.cost for guess in self.wrong), default=math.inf):
            self.best = self._likeliest(self.wrong, most) or self.best
            most = min(self.best.cost if self.best else most, most)
        if most > ANYWHERE + 4.0 + len(self.polygon.spread):
            free = (Guess(self.right.known, self.right.closing, ANYWHERE, name) for name in self.right.known)
            self.best = self._likeliest([*free], most) or self.best

    def _likeliest(self, ways: Sequence[Guess], most: float) -> LaidChain | None:
        """The cheapest chain of some guesses, if it costs less than that."""
        best = None
        for guess in ways:
            best = self.polygon.lay(guess, best.cost if best else most) or best
        return best

    def cost(self, plainly: bool = False) -> float:
        """What it costs to believe in it, or in the plan rightly drawn on such a sheet, if by a poor hand."""
        chain = self.plain if plainly else self.best
        if chain is None or (plainly and chain.astray(self.right, self.polygon.spread, self.polygon.pole.z) > 1):
            return math.inf
        return chain.cost + self.unlikely

    def untold(self) -> tuple[str, ...]:
        """Vectors that may as well be a mistake's, if the drawing is called right: those its likeliest chain has
        elsewhere for one's sake, or that some mistake would have."""
        if self.best is not self.plain and self.best and self.best.guess:
            found = self.best.guess.moved(self.right, APART_MM)
        else:
            found = self._rivals()
        return tuple(n for n in (*self.right.known, *self.right.closing) if n in found)

    def _rivals(self) -> set[str]:
        """Known vectors, rightly laid, that some mistake has elsewhere and explains the ink nearly as well; those, too,
        that are so long that they have heads, and whose ends nothing shows, where all lie in one line or their lengths
        are hardly known."""
        if self.plain is None:
            return set()
        pole = self.polygon.pole.z
        drawn = self.plain.vectors(pole)
        straight = in_line([*drawn.values()])
        loose = {n for n, miss in self.polygon.spread.items() if straight or miss.worst > LOOSE_MM}
        found = {n for n in self.plain.hidden if n in loose and abs(drawn[n]) > HEADED_MM}
        endless = False
        shows = ((self._shows(guess), guess) for guess in self.wrong)
        for shown, guess in sorted(shows, key=lambda one: one[0]):  # what is looked for longest comes last
            moved = guess.moved(self.right, APART_MM)
            most = self.plain.cost + (max(IN_LINE, self.slip - BETTER) if straight or shown else RIVAL)
            rival = self.polygon.lay(guess, most) if guess.cost < most and moved else None
            endless |= self.polygon.endless and not shown
            others = rival.vectors(pole) if rival else {}
            found |= {n for n, v in others.items() if n in self.right.known and abs(v - drawn[n]) > APART_MM}
        return set(self.right.known) if endless else found

    def _shows(self, guess: Guess) -> bool:
        """Whether a mistake makes longer a vector that, rightly laid, ends unseen: a shorter one is hidden better."""
        hidden = self.plain.hidden if self.plain else ()
        unseen = (n for n in guess.moved(self.right, APART_MM) if n in hidden and n in self.right.known)
        return any(abs(guess.known[n]) >= abs(self.right.known[n]) for n in unseen)


def in_line(vectors: Sequence[complex]) -> bool:
    """Whether vectors lie in one line, but for those too short to show their direction."""
    longest, shown = max(vectors, key=abs), [v for v in vectors if abs(v) > TINY_MM]
    return all(abs((v * longest.conjugate()).imag) <= ASLANT * abs(v * longest) for v in shown)


def vectors_on(bench: PreparedPlan, seen: Seen, near: complex) -> ReadPolygon:
    """The polygon drawn on a sheet about a place."""
    every = sides_of(bench.plans, bench.asked.plan)
    if len(every) >= MANY and (read := read_in_order(bench, every, seen, near)):
        return read
    sides, pole = polygon_of(every, bench.asked.plan), pole_on(seen, near)
    shares = likely_shares(seen.ink.flat, seen_like(bench, sides, seen))
    ink = InkCover(seen, pole.z, [*bench.true_marks.values()], words=words_on(seen, [s.name for s in sides]))
    tried = sorted((LaidPolygon(bench.printed_at(k), ink, pole, sides, k) for k in shares), key=LaidPolygon.cost)
    one = _likeliest(tried)
    if one.polygon.endless:
        return ReadPolygon(explained=1.0)
    if (best := one.best) is None:
        return ReadPolygon()
    dearer = min(other.cost(plainly=True) for other in tried) - one.cost()  # by which a right polygon is
    most = _most(best, one.plain, len(sides), pole.z) + NAMED * best.named(ink.words, pole.z)
    unsure = dearer < (APART if best.shows_nothing(one.right) else UNSURE) if best is not one.plain else False
    if unsure or best.cost > most or _ends_bare(best, ink, pole.z):
        return ReadPolygon(explained=1.0)
    explained = one.polygon.ink.explained(best.routes(pole.z))
    rows = [ReadMark(POLE, pole.z, pole.sigma)]
    rows += [
        ReadMark(n, z, math.hypot(sigma, WOBBLE_MM))
        for n, z, sigma in best.rows
        if not best.left_out(n, one.right, pole.z)
    ]
    spots = by_ruler(seen.ink.flat, near, one.share, rows, explained, {})
    past = _past_pole(best, ink, pole.z) if best is one.plain else ()
    return ReadPolygon(spots, explained > 0.9, explained, best.hidden, (*one.untold(), *past), dearer > APART)


def _ends_bare(best: LaidChain, ink: InkCover, pole: complex) -> bool:
    """Whether a polygon that does not close has no head where its last vector ends, though others have: where a line
    that runs on by itself ends, no vector need do."""
    start, end = best.routes(pole)[-1]
    return end != pole and ink.bare(start, end) >= NO_HEAD


def _past_pole(best: LaidChain, ink: InkCover, pole: complex) -> tuple[str, ...]:
    """The vector that closes a polygon, if its line runs on past the pole to a head that stands there, or where vectors
    have no heads that would tell where it ends."""
    start, end = best.routes(pole)[-1]
    if end != pole or abs(end - start) < PAST_MM[0]:
        return ()
    way = (end - start) / abs(end - start)
    drawn = ink.seen.all_ink.covered(end, end + PAST_MM[0] * way, ASIDE_MM) > COVERED
    further = ((z - end) / way for z, _ in ink.tips)
    aside = GAP_MM / abs(end - start)  # a line's own ends may be so far aside
    shown = any(PAST_MM[0] < z.real < PAST_MM[1] and abs(z.imag) < GAP_MM + aside * z.real for z in further)
    headed = shown or not ink.headed or ink.seen.lone_heads.past(start, end, *PAST_MM)
    return (best.rows[-1][0],) if drawn and headed else ()


def _likeliest(tried: Sequence[LaidPolygon]) -> LaidPolygon:
    """The likeliest of what was tried at several sizes, the likeliest first: looked for among what fits well, at last
    among all at the first size."""
    for limit, sizes in zip(DEEPER, (tried, tried[:1]), strict=True):
        for one in sizes:
            one.look(min(limit, *map(LaidPolygon.cost, tried)))
            if one.best and one.best is one.plain and not one.unlikely:
                break  # it fits well
        if min(map(LaidPolygon.cost, tried)) < limit:
            break
    return min(tried, key=LaidPolygon.cost)


def start_of(bench: PreparedPlan, seen: Seen) -> complex | None:
    """Where a polygon begins whose pole nobody told: where the cheapest one does, drawn rightly, or with a mistake if
    no right one comes near; None where none fits well."""
    sides = polygon_of(sides_of(bench.plans, bench.asked.plan), bench.asked.plan)
    right, *wrong = guesses(bench, sides, loads_of(bench.plans, bench.asked.plan))
    words, spread = words_on(seen, [s.name for s in sides]), spread_of(bench, sides)
    corners = sorted((p for p in seen.places if p.ended), key=lambda p: -len(p.ended))[:MOST_CORNERS]
    inks = [InkCover(seen, p.z, [*bench.true_marks.values()], words=words) for p in corners]
    sought = [SoughtPolygon(ink, corner, spread) for ink, corner in zip(inks, corners, strict=True)]
    most, start = DEEPER[0], None
    for ways in ([right], wrong):
        for guess, polygon in product(ways, sought):
            if chain := polygon.lay(guess, most):
                most, start = chain.cost, polygon.pole.z
        most -= APART if start is not None else 0.0
    return start


def _most(best: LaidChain, plain: LaidChain | None, count: int, pole: complex) -> float:
    """What the likeliest polygon may cost to be one at all."""
    gapes = bool(best.rows) and best.rows[-1][1] != pole
    return POOR + POORLY * count + (OPEN * gapes if best is plain else ANYWHERE)
