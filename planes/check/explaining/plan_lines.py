"""The lines of a plan on paper under any hypothesis, many drawings in one run of the program."""

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import combinations

import numpy

from planes.check.explaining.weights import SHORTEST_LINE_MM
from planes.check.grading.polygons import Side, polygon_sides
from planes.check.grading.prepared_plan import PreparedPlan
from planes.check.grading.variants import Variant
from planes.drafting.steps import Step
from planes.drafting.tools import Env, Tool
from planes.geometry.arithmetic import Many, Point
from planes.geometry.arrays import Array, Booleans, Complexes
from planes.words.frozen import frozen
from planes.words.names import POLE_LABEL, NamePair, label_of

LAST_SIDE_END = "end"  # end of a force polygon's last side: at the pole, if the polygon closes
# around a point of a scheme, and a support or slider, ink belongs to symbols
HINGE_SYMBOL_RADIUS_MM = 3.0
SUPPORT_SYMBOL_RADIUS_MM = 9.5
# part of a link's line under symbols at its ends; overrun of guides beyond sliders
HIDDEN_LINE_END_MM = 0.8
GUIDE_OVERRUN_MM = 30.0
COINCIDENT_LINES_MM = 0.6  # coincident lines are no farther apart
Line = NamePair


@frozen
class Hypothesis:
    """A possible drawing: the kind and the mark of its mistake, its prior cost (minus a logarithm), and its effects.

    Effects are steps swapped, marks moved (mm, by label), the transformation of the whole plan, and the order of sides.
    """

    kind: str = "right"
    mark: str = ""
    cost: float = 0.0
    variant: Variant | None = None
    nudges: Mapping[str, complex] = field(default_factory=dict)
    turn: complex = 1 + 0j
    mirrored: bool = False
    order: tuple[int, ...] = ()

    @property
    def is_right(self) -> bool:
        """Whether there is no mistake."""
        return self.kind == "right"


class _Nudging(Tool):
    """Draws many plans at once, with some marks moved."""

    def __init__(self, nudges: Mapping[str, Point], count: int) -> None:
        super().__init__(Many(), True, shape=(count,))
        self.nudges = nudges

    def draw_by_other_steps(self, step: Step, way: Sequence[Step], things: Env) -> Point:
        made = super().draw_by_other_steps(step, way, things)
        if step.makes in self.nudges:
            made = things[step.makes] = made + self.nudges[step.makes]
        return made


@dataclass
class PlanLines:
    """The lines of a plan by the labels of their ends, and which of them are needed (a sum beside its parts is not).

    On a sheet printed at a ``share`` of its size all is larger by that factor. ``held`` is a mark that determines the
    scale, with its position, mm from the pole.
    """

    bench: PreparedPlan
    share: float = 1.0
    held: tuple[str, complex] | None = None
    to_fit: bool = True  # whether a printer may have shrunk the sheet
    sides: list[Side] = field(default_factory=list)  # of a force polygon, from the pole round to its end

    def __post_init__(self) -> None:
        self.kind = self.bench.kind
        self.labels = [m.label for m in self.bench.marks]
        self.names = [
            *self.labels,
            *([LAST_SIDE_END] if self.kind == "force" else []),
            POLE_LABEL,
        ]  # the last ones have no steps
        self.lines, needed = self._lines_and_needed()
        self.needed: Booleans = numpy.array(needed)
        self.starts, self.ends = (numpy.array([self.names.index(line[k]) for line in self.lines]) for k in (0, 1))
        self.true = {POLE_LABEL: 0j, LAST_SIDE_END: 0j, **self.bench.true_marks}

    def _lines_and_needed(self) -> tuple[list[Line], list[bool]]:
        known = {POLE_LABEL, *self.labels}
        plan = self.bench.plan
        if self.kind == "position":
            return self._link_sides_and_needed()
        if self.kind == "force":
            every = [s for s in polygon_sides(self.bench.plans, plan) if {s.start, s.end} <= known]
            self.sides = longest_closed_path(every)
            inner = [(s.start, s.end) for s in every if s not in self.sides]
            ring = [(s.start, s.end) for s in self.sides]
            return [*ring[:-1], *((a, LAST_SIDE_END) for a, _ in ring[-1:]), *inner], [True] * len(ring) + [
                False
            ] * len(inner)
        own = [v for v in self.bench.vector_names if {*v} <= known]
        corners = {label_of(m) for m in self.bench.program.component_end_marks}
        sums = [(a, d) for a, b in own for c, d in own if b == c and b in corners and a not in (d, POLE_LABEL)]
        lines = [*dict.fromkeys([*own, *sums])]
        return lines, [not any((a, m) in own and (m, b) in own for m in corners) for a, b in lines]

    def _link_sides_and_needed(self) -> tuple[list[Line], list[bool]]:
        """The sides of links and which are needed: the longest of a straight link, the first of any other."""
        lines: dict[Line, bool] = {}
        for link in self.bench.plans.mechanism.links.values():
            points = [n for n in link.points if n in self.labels and n != link.centre]
            pairs = sorted(combinations(points, 2), key=lambda ab: -abs(link.points[ab[0]] - link.points[ab[1]]))
            off = numpy.array([link.points[n] - link.points[points[0]] for n in points[1:]])
            straight = len(off) > 1 and bool((abs((off / off[0]).imag) < 1e-6).all())
            for pair in pairs[:1] if straight else pairs:
                lines.setdefault(pair, straight or {*pair} == {*points[:2]})
        return [*lines], [*lines.values()]

    def extra_symbols(self, places: Complexes) -> tuple[Complexes, Complexes, Complexes, Array]:
        """What else may be drawn, row by row: the guides of a scheme by their two ends, its other symbols by centre and
        radius, mm; of a force polygon, the normal force and the friction of each leaning reaction."""
        none = numpy.zeros((len(places), 0), complex)
        at_ = {n: places[:, k] for k, n in enumerate(self.names)}
        if self.kind != "position":
            leant = [(at_[a], at_[b], u) for a, b, u, _ in self.bench.leaning_reactions if {a, b} <= at_.keys()]
            corners = [b + ((a - b) * u.conjugate()).real * u for a, b, u in leant]
            starts = [*(a for a, _, _ in leant), *corners]
            ends = [*corners, *(b for _, b, _ in leant)]
            sides = [numpy.stack(z, axis=1) if z else none for z in (starts, ends)]
            return sides[0], sides[1], none, numpy.zeros(0)
        mechanism = self.bench.plans.mechanism
        reach = dict.fromkeys(self.names, HINGE_SYMBOL_RADIUS_MM) | dict.fromkeys(
            (*mechanism.frame.points, POLE_LABEL), SUPPORT_SYMBOL_RADIUS_MM
        )
        ways: list[tuple[Complexes, Complexes]] = []
        for link in mechanism.links.values():
            slider = next(iter(link.points))
            if link.slides is None or slider not in at_:
                continue
            guide = mechanism.guide(link.slides.guide)
            reach[slider] = SUPPORT_SYMBOL_RADIUS_MM
            of_frame = guide.name in mechanism.frame.guides
            if (base := slider if of_frame else str(guide.through_point)) in at_:
                off = numpy.nan_to_num(at_[slider] - at_[base])
                way = cmath.rect(1, math.radians(guide.angle_deg)) if of_frame else off / numpy.maximum(abs(off), 1e-6)
                ways.append((at_[base] - GUIDE_OVERRUN_MM * way, at_[slider] + GUIDE_OVERRUN_MM * way))
        shown = [n for n in reach if n in at_]
        a, b = (numpy.stack([w[k] for w in ways], axis=1) if ways else none for k in (0, 1))
        return a, b, numpy.stack([at_[n] for n in shown], axis=1), numpy.array([reach[n] for n in shown])

    def mark_positions(
        self, hypothesis: Hypothesis, nudges: Mapping[str, complex | Array], count: int
    ) -> Complexes | None:
        """Positions of the marks (count × names, the pole last), mm from the sheet's pole, with extra displacements.

        NaN where they cannot be constructed, None if none can.
        """
        both = {n: hypothesis.nudges.get(n, 0j) + nudges.get(n, 0j) for n in {*hypothesis.nudges, *nudges}}
        moved: dict[str, Point] = {
            self.bench.plan.mark(n): v for n, v in both.items() if n not in (LAST_SIDE_END, POLE_LABEL)
        }
        things = self.bench.draw_program(hypothesis.variant, _Nudging(moved, count))
        if things is None:
            return None
        every = [*(things[m] for m in self.bench.marks), *(both.get(n, 0j) for n in self.names[len(self.labels) :])]
        places = numpy.stack([numpy.broadcast_to(numpy.asarray(z, complex), (count,)) for z in every], axis=1)
        own = places[:, : len(self.labels)]
        own = (own.conj() if hypothesis.mirrored else own) * (hypothesis.turn / self.share)
        if self.held:
            mark, where = self.held
            with numpy.errstate(all="ignore"):
                own *= (where / own[:, self.labels.index(mark)])[:, None]
        places[:, : len(self.labels)] = numpy.where(numpy.isfinite(own), own, complex(numpy.nan, numpy.nan))
        places[:, :-1] += places[:, -1:]  # the pole may be shifted, with the whole drawing
        return places

    def drawn(self, hypothesis: Hypothesis) -> Complexes | None:
        """One drawing without displacements; None if some of its marks cannot be constructed."""
        drawn = self.mark_positions(hypothesis, {}, 1)
        if drawn is not None and numpy.isfinite(drawn).all():
            return drawn
        return None

    def row(self, places: Mapping[str, complex]) -> Complexes:
        """The positions of marks by label as a row in the order of the names."""
        return numpy.array([places[n] for n in self.names])

    def ends_of(self, places: Mapping[str, complex], order: Sequence[int] = ()) -> tuple[Complexes, Complexes]:
        """Starts and ends of the lines of one drawing: see :meth:`lay_out_views`."""
        a, b = self.line_ends(self.row(places)[None], order)
        return a[0], b[0]

    def draw_each_hypothesis(self, every: Sequence[Hypothesis]) -> Iterator[tuple[Hypothesis, Complexes | None]]:
        """Hypotheses with their drawings; those that only turn, mirror or scale a drawing share it."""
        right = None if self.held else self.mark_positions(Hypothesis(), {}, 1)
        for h in every:
            if right is None or h.variant or h.nudges:
                yield h, self.mark_positions(h, {}, 1)
            else:
                yield h, (right.conj() if h.mirrored else right) * h.turn

    def line_ends(self, places: Complexes, order: Sequence[int] = ()) -> tuple[Complexes, Complexes]:
        """Starts and ends of the lines; the sides of a force polygon may be laid in another order."""
        a = places[:, self.starts]
        b = places[:, self.ends]
        if self.kind == "position":
            with numpy.errstate(all="ignore"):
                hidden = (b - a) * numpy.minimum(HIDDEN_LINE_END_MM / numpy.maximum(abs(b - a), 1e-6), 0.25)
            return a + hidden, b - hidden
        if order:
            count = len(order)
            back = numpy.argsort(order)
            sides = (b - a)[:, list(order)]
            tips = places[:, -1:] + numpy.cumsum(sides, axis=1)
            a[:, :count], b[:, :count] = (tips - sides)[:, back], tips[:, back]
            b[:, count:] = a[:, count:]  # the positions of its inner vectors are then unknown
        return a, b


def longest_closed_path(sides: Sequence[Side], way: tuple[Side, ...] = ()) -> list[Side]:
    """The longest closed path along a polygon's sides, from the pole and back; the other sides lie inside."""
    here = way[-1].end if way else POLE_LABEL
    passed = {s.end for s in way}
    longest = list[Side]()
    for side in (s for s in sides if s.start == here and s.end not in passed):
        rest = [side] if side.end == POLE_LABEL else [side, *longest_closed_path(sides, (*way, side))]
        if rest[-1].end == POLE_LABEL and len(rest) > len(longest):
            longest = rest
    return longest


def coincides_with_earlier(a: Complexes, b: Complexes) -> Booleans:
    """Lines of each row that coincide with an earlier one, in either direction."""
    apart = numpy.maximum(abs(a[:, :, None] - a[:, None, :]), abs(b[:, :, None] - b[:, None, :]))
    return numpy.asarray(numpy.tril(apart < COINCIDENT_LINES_MM, -1).any(axis=2))


def lines_to_look_for(a: Complexes, b: Complexes) -> Booleans:
    """Lines long enough to be looked for, each once."""
    shown = numpy.stack(
        [~coincides_with_earlier(a, b), numpy.isfinite(a), numpy.isfinite(b), abs(b - a) > SHORTEST_LINE_MM]
    )
    return numpy.asarray(shown.all(axis=0))
