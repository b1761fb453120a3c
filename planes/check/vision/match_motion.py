"""Which place of a picture is which mark of a motion plan: every way the plan may have been drawn is tried on the ink.

Drawn rightly, or with one mistake of the catalogue, or with one mark anywhere: each time the program is drawn once
more, every mark snapped to the place where the person has it before the next is drawn from it. The way that leaves
the least ink unexplained, with the fewest marks missing, tells the names of the places. It only names them: whether
the drawing is right is judged afterwards, from the places.
"""

import math
from collections.abc import Collection, Container, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import Any, Self

from planes.check.grading.handwork import Hand, Miss, Variant
from planes.check.grading.judging import LEFT_OUT
from planes.check.grading.paper import ReadMark
from planes.check.grading.prepared_plan import PreparedPlan, redrawn, variants_of
from planes.check.vision.ink_cover import (
    ANYWHERE,
    COVERED,
    DOUBTFUL,
    GATE,
    NO_END,
    NO_LINE,
    NO_MARK,
    VAGUE,
    InkCover,
    sigmas_of,
    slip,
)
from planes.check.vision.places import Place, Seen, pole_on
from planes.check.vision.print_scale import UNLIKELY, by_ruler, shares_of
from planes.drafting.steps import Step
from planes.words import Phrase
from planes.words.names import POLE, at, label_of, plan_of

NEARLY, CLOSE = 3.0, 16.0  # how much dearer a place may be, and a whole way, to be looked at again
FAR = 1.5  # a place that costs more may be another mark's, its own not seen
ASTRAY_MM = 10.0  # a mark anywhere is the less likely the farther it is from where it should be
EVEN_MM = 0.9  # marks nearer than this may be one


@dataclass
class LaidPlan:
    """One way the plan may have been drawn, laid on the picture."""

    cost: float
    found: dict[str, Place] = field(default_factory=dict)  # by mark
    variant: Variant | None = None
    vanished: bool = False  # whether a mark that should be elsewhere came to the pole, where it leaves no trace
    others: list[tuple[str, Place | None]] = field(default_factory=list)  # nearly as likely places of marks, or nowhere


@dataclass
class Search:
    """The plan's marks looked for on a sheet from a known pole."""

    bench: PreparedPlan
    seen: Seen
    pole: Place
    own: dict[str, Miss]
    true: Mapping[str, complex]
    vectors: list[tuple[str, str]]
    ink: InkCover
    share: float = 1.0  # of its size that the sheet was printed at
    drawn: Container[int] = (0,)  # in which ways the plan may have been drawn there: 0 rightly, then with each mistake

    @classmethod
    def of(
        cls, bench: PreparedPlan, ink: InkCover, pole: Place, vectors: list[tuple[str, str]], share: float = 1.0
    ) -> Self:
        """A search from a pole on a sheet printed at a share of its size, with the errors of a hand at every mark."""
        bench = bench.printed_at(share)
        true = {at(bench.asked.plan, n): z for n, z in bench.true_marks.items()}
        hand = Hand(bench.program, bench.given, bench.asked.skill, {m: ReadMark(m, z) for m, z in true.items()})
        return cls(bench, ink.seen, pole, hand.misses(bench.marks), true, vectors, ink, share)

    def settled(self, variant: Variant | None, cost: float = 0.0, most: float = math.inf) -> LaidPlan | None:
        """The plan drawn so, with marks put to their next likely places as long as that explains the picture better."""
        best, chosen = self.way(variant, None, cost), dict[str, Place | None]()
        tried = set[tuple[str, int]]()
        while best and best.cost < most + CLOSE:
            mark, place = next(((m, p) for m, p in best.others if (m, id(p)) not in tried), ("", None))
            if not mark:
                break
            tried.add((mark, id(place)))
            trial = self.way(variant, None, cost, {**chosen, mark: place})
            if trial and trial.cost < best.cost:
                best, chosen[mark] = trial, place
        return best

    def way(
        self,
        variant: Variant | None,
        fixed: tuple[str, Place] | None = None,
        cost: float = 0.0,
        chosen: Mapping[str, Place | None] = MappingProxyType({}),
    ) -> LaidPlan | None:
        """The plan drawn so, snapped to the picture; ``fixed`` puts one mark where it cannot be expected."""
        flat = self.seen.ink.flat
        out = LaidPlan(cost + UNLIKELY * (self.share != flat.printed and not flat.told), {}, variant)
        places, lost = dict[str, complex](), list[complex]()

        def snap(step: Step, drawn: Any) -> Any:
            if step.makes not in self.own or drawn != drawn or any(abs(drawn - z) < 1e-9 for z in lost):
                return drawn  # the same place is looked for but once
            goal = self.pole.z + complex(drawn)
            if fixed and step.makes == fixed[0]:
                found: Place | None = fixed[1]
            else:
                likely = self._likely(step, goal, places, out.found)
                mine = (one for one in likely if step.makes in chosen and one[1] is chosen[step.makes])
                price, found = next(mine, likely[0])
                out.cost += price
                others = ((p, dear - price < NEARLY if p else price > FAR) for dear, p in likely[1:])
                out.others += [(step.makes, p) for p, worth in others if worth]
            if found is None:
                lost.append(complex(drawn))
                return drawn
            out.found[step.makes] = found
            places[step.makes] = found.z
            out.vanished |= found is self.pole and abs(drawn) > EVEN_MM and abs(self.true[step.makes]) > 3
            return found.z - self.pole.z

        if redrawn(self.bench, variant, snap) is None:
            return None
        out.cost += NO_LINE * out.vanished + self.ink.price(self.routes(out))
        return out

    def _likely(
        self, step: Step, goal: complex, places: Mapping[str, complex], found: Mapping[str, Place]
    ) -> list[tuple[float, Place | None]]:
        """The places that a mark may mean that should be at ``goal``, or none, and what believing it costs."""
        used = {id(p) for p in found.values()}
        likely: list[tuple[float, Place | None]] = []
        for place in [*self.seen.within(goal, 12.0), self.pole, *self._closer(step.makes, goal, places)]:
            sigmas = sigmas_of(place.z - goal, self.own[step.makes], place.sigma)
            if sigmas > GATE:
                continue
            price = sigmas**2 / 2 + self._doubt(place, goal, used)
            price += 0.0 if self._led_to(step, place.z, places) else NO_LINE
            if price <= NO_MARK:
                likely.append((price, place))
        return [*sorted(likely, key=lambda one: one[0]), (self._missing(step.makes), None)]

    def _led_to(self, step: Step, z: complex, places: Mapping[str, complex]) -> bool:
        """Whether a line leads to a place from where its mark is found from, or from the pole."""
        starts = [self.pole.z, *(places.get(n, self.pole.z) for n in _starts(step))]
        return any(self.seen.ink.covered(s, z) >= COVERED for s in starts)

    def _missing(self, mark: str) -> float:
        """What it costs that a mark is nowhere."""
        return NO_MARK

    def _closer(self, mark: str, goal: complex, places: Mapping[str, complex]) -> Iterator[Place]:
        """Heads about a goal that the vectors to a mark may have."""
        for start, end in self.vectors:
            z = self.pole.z if start == POLE else places.get(at(plan_of(mark), start))
            found = self.seen.closer(z, goal) if end == label_of(mark) and z is not None else None
            if found:
                yield found

    def _doubt(self, place: Place, goal: complex, used: Collection[int]) -> float:
        """What it costs to believe that a place is a mark's, however near it is."""
        if id(place) in used or place is self.pole:
            return 0.0 if abs(place.z - goal) < EVEN_MM else NO_END
        price = VAGUE * place.sigma + (DOUBTFUL if place.doubtful else 0.0)
        return price + (0.0 if place.ended or place.tip else NO_END)

    def blind(self, mark: str, way: LaidPlan) -> bool:
        """Whether a mark is found but where lines run out that have no heads."""
        leading = [(a, b) for a, b in self.routes(way) if b == way.found[mark].z]
        return bool(leading) and all(self.ink.runs_out(a, b) for a, b in leading)

    def routes(self, way: LaidPlan) -> list[tuple[complex, complex]]:
        """The vectors of the plan, those whose ends were found."""
        ends = {POLE: self.pole.z, **{label_of(m): p.z for m, p in way.found.items()}}
        return [(ends[a], ends[b]) for a, b in self.vectors if a in ends and b in ends and ends[a] != ends[b]]

    def _ended(self) -> list[Place]:
        """Places where lines surely end."""
        ended = (p for p in self.seen.places if p.ended and p.sigma < 0.6 and not p.doubtful)
        return [p for p in ended if not self.seen.torn(p)]

    def free_ways(self, way: LaidPlan) -> Iterator[LaidPlan | None]:
        """The plan drawn with a mark where nobody expects it."""
        for mark, place in self.free_marks(way):
            astray = abs(place.z - self.pole.z - self.true[mark]) / ASTRAY_MM
            yield self.way(None, (mark, place), ANYWHERE + math.log1p(astray))

    def free_marks(self, way: LaidPlan) -> Iterator[tuple[str, Place]]:
        """Marks that may be elsewhere, with places where lines end that the way does not use."""
        used = {id(p) for p in way.found.values()} | {id(self.pole)}
        free = [p for p in self._ended() if id(p) not in used and abs(p.z - self.pole.z) > 2]
        for mark in self.bench.marks:
            starts = [way.found[n].z for n in _starts(self.bench.program.makers[mark]) if n in way.found]
            for place in free:
                if any(self.seen.ink.covered(z, place.z) > COVERED for z in (*starts, self.pole.z)):
                    yield mark, place


def _starts(step: Step) -> list[str]:
    return [getattr(step, k) for k in ("start", "other", "end") if isinstance(getattr(step, k, None), str)]


def best_way(searches: Sequence[Search]) -> tuple[Search, LaidPlan] | None:
    """The way that explains the picture best, of a sheet that may have been printed at several sizes."""
    bench = searches[0].bench
    ways = [(s, w) for s in searches if 0 in s.drawn for w in (s.settled(None),) if w]
    best, count = min(ways, key=_cost, default=None), len(variants_of(bench, {}, bench.said_mu))
    if best is None or len(best[1].found) < len(bench.marks) or best[1].cost > slip(count):
        for search in searches:
            variants = variants_of(search.bench, {}, search.bench.said_mu)
            for variant in (v for k, v in enumerate(variants) if k + 1 in search.drawn):
                most = min((w.cost for _, w in ways), default=math.inf)
                ways += [(search, w) for w in (search.settled(variant, slip(len(variants)), most),) if w]
        best = min(ways, key=_cost, default=None)
        if best and best[1].cost > ANYWHERE + 4.0 + len(bench.marks):
            ways += [(best[0], w) for w in best[0].free_ways(best[1]) if w]
    return min(ways, key=_cost, default=None)


def _cost(found: tuple[Search, LaidPlan]) -> float:
    return found[1].cost


def marks_on(bench: PreparedPlan, seen: Seen, near: complex) -> tuple[list[ReadMark], float]:
    """The marks of a motion plan with its pole near a place, and the share of the ink they explain."""
    pole, ends = pole_on(seen, near), bench.vectors
    shares = shares_of(bench, seen, pole.z)
    ink = InkCover(seen, pole.z, [*bench.true_marks.values()])
    searches = [replace(Search.of(bench, ink, pole, ends, k), drawn=drawn) for k, drawn in shares.items()]
    search, way = best_way(searches) or (None, None)
    if search is None or way is None or not way.found:
        return [], 0.0
    spots = [ReadMark(POLE, search.pole.z, min(search.pole.sigma, 0.3))]
    left_out = way.variant.blames if way.variant and way.variant.mistake.endswith(LEFT_OUT) else None
    read = {label_of(m): way.found[m] for m in bench.marks if m in way.found and not search.blind(m, way)}
    spots += [ReadMark(n, p.z, p.error_mm) for n, p in read.items() if n != left_out]
    routes = search.routes(way)
    explained, strange = ink.explained(routes), ink.strangers(routes)
    if strange and len(way.found) == len(bench.marks):
        seen.ink.flat.notes.append(Phrase("check_strangers", count=len(strange)))
    return by_ruler(seen.ink.flat, near, search.share, spots, explained, bench.true_marks), explained
