"""A plan looked for on a sheet: drawn in one way or another, each mark put where the person may have it."""

import math
from collections.abc import Collection, Container, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import accumulate
from types import MappingProxyType
from typing import Any, Self

from planes.check.grading.handwork import Hand, Miss
from planes.check.grading.paper import ReadMark
from planes.check.grading.prepared_plan import GivenUp, PreparedPlan, redrawn
from planes.check.grading.variants import Variant
from planes.check.vision.marks.places import Seen
from planes.check.vision.marks.print_scale import UNLIKELY
from planes.check.vision.search.costs import ANYWHERE, DOUBTFUL, GATE, NO_END, NO_LINE, NO_MARK, VAGUE, sigmas_of
from planes.check.vision.search.ink_cover import COVERED, CROSS_MM, InkCover
from planes.check.vision.search.laid_plan import LaidPlan, Stop
from planes.check.vision.strokes.line_places import Place
from planes.drafting.steps import Step
from planes.words.names import POLE, at, label_of

NEARLY, CLOSE = 3.0, 16.0  # how much dearer a place may be, and a whole way, to be looked at again
FAR = 1.5  # a place that costs more may be another mark's, its own not seen
ASTRAY_MM = 10.0  # a mark anywhere is the less likely the farther it is from where it should be
EVEN_MM = 0.9  # marks nearer than this may be one


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
    closely: bool = True  # whether heads are looked for that no line shows by itself
    near: dict[tuple[object, ...], list[tuple[float, Place]]] = field(default_factory=dict)  # what was looked up before
    plain: LaidPlan | None = None  # the plan drawn rightly, each mark at its likeliest place

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
        begun = self._shared(variant, cost)
        if (begun and begun.laid.cost > most) or not self._at_a_glance(variant, cost):
            return None
        best, chosen = self.way(variant, None, cost, most=most + CLOSE, begun=begun), dict[str, Place | None]()
        self.plain = best if variant is None else self.plain
        tried = set[tuple[str, int]]()
        while best and best.cost < most + CLOSE:
            mark, place = next(((m, p) for m, p in best.others if (m, id(p)) not in tried), ("", None))
            if not mark:
                break
            tried.add((mark, id(place)))
            stop = best.stops[mark].with_mistake(variant, cost)
            trial = self.way(variant, None, cost, {**chosen, mark: place}, best.cost, stop)
            if trial and trial.cost < best.cost:
                best, chosen[mark] = trial, place
        return best

    @cached_property
    def glance(self) -> Self:
        """The same search by those heads alone that lines show by themselves, with the right plan laid so."""
        found = replace(self, closely=False, near={}, plain=None)
        found.plain = found.way(None)
        return found

    def _at_a_glance(self, variant: Variant | None, cost: float) -> bool:
        """Whether a plan drawn so seems, at a glance, hardly dearer than the right one."""
        rough = self.glance.plain if variant else None
        if rough is None:
            return True
        begun = self.glance._shared(variant, cost)
        return self.glance.way(variant, None, cost, most=rough.cost + CLOSE, begun=begun) is not None

    def _at_least(self, cost: float) -> float:
        """What a way costs before any mark is laid."""
        flat = self.seen.ink.flat
        return cost + UNLIKELY * (self.share != flat.printed and not flat.told)

    def _shared(self, variant: Variant | None, cost: float) -> Stop | None:
        """Where the plan drawn so parts from the right one, as that was laid."""
        touched, plain = self.bench.touched(variant), self.plain if variant else None
        stops = [s for s in plain.stops.values() if s.drawing.step <= touched] if plain else []
        return stops[-1].with_mistake(variant, cost) if stops else None

    def way(
        self,
        variant: Variant | None,
        fixed: tuple[str, Place] | None = None,
        cost: float = 0.0,
        chosen: Mapping[str, Place | None] = MappingProxyType({}),
        most: float = math.inf,
        begun: Stop | None = None,
    ) -> LaidPlan | None:
        """The plan drawn so, snapped to the picture; ``fixed`` puts one mark where it cannot be expected. None where it
        cannot be drawn, or would cost more than ``most``. What was ``begun`` so is gone on with."""
        begun = begun or Stop(self.bench.begun(variant), LaidPlan(self._at_least(cost), {}, variant), [])
        out, lost, drawing = begun.laid.copy(), [*begun.lost], begun.drawing.copied()
        places = {m: p.z for m, p in out.found.items()}

        def snap(step: Step, drawn: Any) -> Any:
            if step.makes not in self.own or drawn != drawn or any(abs(drawn - z) < 1e-9 for z in lost):
                return drawn  # the same place is looked for but once
            out.stops[step.makes] = Stop(drawing.copied(self.bench.number[step.makes]), out.copy(), [*lost])
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
            if out.cost > most:
                raise GivenUp
            if found is None:
                lost.append(complex(drawn))
                return drawn
            out.found[step.makes] = found
            places[step.makes] = found.z
            out.vanished |= found is self.pole and abs(drawn) > EVEN_MM and abs(self.true[step.makes]) > CROSS_MM
            return found.z - self.pole.z

        if redrawn(self.bench, variant, snap, drawing) is None:
            return None
        out.cost += NO_LINE * out.vanished + self.ink.price(self.routes(out))
        return out if out.cost <= most else None

    def _likely(
        self, step: Step, goal: complex, places: Mapping[str, complex], found: Mapping[str, Place]
    ) -> list[tuple[float, Place | None]]:
        """The places that a mark may mean that should be at ``goal``, or none, and what believing it costs."""
        used = {id(p) for p in found.values()}
        priced = ((price + self._doubt(p, goal, used), p) for price, p in self._nearby(step, goal, places))
        likely = sorted((one for one in priced if one[0] <= NO_MARK), key=lambda one: one[0])
        return [*likely, (self._missing(step.makes), None)]

    def _nearby(self, step: Step, goal: complex, places: Mapping[str, complex]) -> list[tuple[float, Place]]:
        """Places within the errors of hand and reading, and what they cost however sure they are (remembered)."""
        key = step.makes, goal, *(places.get(m) for m in self._before(step))
        if key not in self.near:
            likely = [*self.seen.within(goal, 12.0), self.pole, *self._closer(step.makes, goal, places)]
            off = ((sigmas_of(p.z - goal, self.own[step.makes], p.sigma), p) for p in likely)
            near = ((k**2 / 2, p) for k, p in off if k <= GATE)
            self.near[key] = [(k + (0.0 if self._led_to(step, p.z, places) else NO_LINE), p) for k, p in near]
        return self.near[key]

    def _before(self, step: Step) -> list[str]:
        """The marks that a line to a step's mark may come from."""
        return [*_starts(step), *self._starts_of.get(step.makes, ())]

    @cached_property
    def _starts_of(self) -> dict[str, list[str]]:
        """By mark those that the vectors to it come from."""
        found, plan = dict[str, list[str]](), self.bench.asked.plan
        for start, end in self.vectors:
            found.setdefault(at(plan, end), []).append(at(plan, start))
        return found

    def _led_to(self, step: Step, z: complex, places: Mapping[str, complex]) -> bool:
        """Whether a line leads to a place from where its mark is found from, or from the pole."""
        starts = [self.pole.z, *(places.get(n, self.pole.z) for n in _starts(step))]
        return any(self.seen.covered(s, z) >= COVERED for s in starts)

    def _missing(self, mark: str) -> float:
        """What it costs that a mark is nowhere."""
        return NO_MARK

    def _closer(self, mark: str, goal: complex, places: Mapping[str, complex]) -> Iterator[Place]:
        """Heads about a goal that the vectors to a mark may have."""
        for start in self._starts_of.get(mark, ()) if self.closely else ():
            z = self.pole.z if label_of(start) == POLE else places.get(start)
            if z is not None and (found := self.seen.closer(z, goal)):
                yield found

    def _doubt(self, place: Place, goal: complex, used: Collection[int]) -> float:
        """What it costs to believe that a place is a mark's, however near it is."""
        if id(place) in used or place is self.pole:
            return 0.0 if abs(place.z - goal) < EVEN_MM else NO_END
        price = VAGUE * place.sigma + (DOUBTFUL if place.doubtful else 0.0)
        return price + (0.0 if place.ended or place.tip else NO_END)

    def error_mm(self, mark: str, way: LaidPlan) -> float:
        """σ of reading a mark that is found; one put at the pole may be anywhere in the cross printed there."""
        place, off = way.found[mark], abs(self.true[mark])
        return off if place is self.pole and EVEN_MM < off <= CROSS_MM else place.error_mm

    def blind(self, mark: str, way: LaidPlan) -> bool:
        """Whether a mark is found but where lines run out that have no heads."""
        leading = [(a, b) for a, b in self.routes(way) if b == way.found[mark].z]
        return bool(leading) and all(self.ink.runs_out(a, b) for a, b in leading)

    def routes(self, way: LaidPlan) -> list[tuple[complex, complex]]:
        """The vectors of the plan, those whose ends were found."""
        ends = way.ends(self.pole.z)
        return [(ends[a], ends[b]) for a, b in self.vectors if a in ends and b in ends and ends[a] != ends[b]]

    def _ended(self) -> list[Place]:
        """Places where lines surely end."""
        return [p for p in self.seen.places if p.ended and p.sigma < 0.6 and not p.doubtful and not self.seen.torn(p)]

    def free_ways(self, way: LaidPlan) -> Iterator[LaidPlan]:
        """The plan drawn with a mark where nobody expects it, each cheaper than those before; looked at closely where
        what shows at a glance is half of its marks, and nearly as good."""
        most = way.cost
        for fixed in self.free_marks(way):
            cost = ANYWHERE + math.log1p(abs(fixed[1].z - self.pole.z - self.true[fixed[0]]) / ASTRAY_MM)
            rough = self.glance.way(None, fixed, cost, most=most + CLOSE)
            if rough and len(rough.found) >= len(self.bench.marks) / 2:
                free = self.way(None, fixed, cost, most=most)
                if free and free.cost < most:
                    most = free.cost
                    yield free

    def free_marks(self, way: LaidPlan) -> Iterator[tuple[str, Place]]:
        """Marks that may be elsewhere, with places where lines end that the way does not use."""
        used = {id(p) for p in way.found.values()} | {id(self.pole)}
        free = [p for p in self._ended() if id(p) not in used and abs(p.z - self.pole.z) > 2]
        for mark in self._worth_freeing(way):
            starts = [way.found[n].z for n in _starts(self.bench.program.makers[mark]) if n in way.found]
            for place in free:
                if any(self.seen.covered(z, place.z) > COVERED for z in (*starts, self.pole.z)):
                    yield mark, place

    def _worth_freeing(self, way: LaidPlan) -> list[str]:
        """Marks but those before which so many are nowhere that the plan could not be read with them in any place."""
        marks = self.bench.marks
        lost = accumulate((m not in way.found for m in marks), initial=0)
        return [m for m, count in zip(marks, lost, strict=False) if count <= len(marks) / 2]


def _starts(step: Step) -> list[str]:
    return [getattr(step, k) for k in ("start", "other", "end") if isinstance(getattr(step, k, None), str)]
