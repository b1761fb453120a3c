"""A plan as seen on a sheet, by the likeliest of all its drawings: its marks with their errors, and the odds."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import combinations

import numpy

from planes.check.evidence.sheet_ink import SheetInk
from planes.check.explaining import weights as w
from planes.check.explaining.fitted_marks import fitted_marks
from planes.check.explaining.plan_lines import END, PlanLines
from planes.check.explaining.scorer import Laid, Scorer
from planes.check.grading.evidence import logistic
from planes.check.grading.judging import LEFT_OUT
from planes.check.grading.paper import ReadMark
from planes.check.grading.sign_faults import DrawnVector, SignFault, arrow_faults
from planes.check.grading.signs import plan_scaled
from planes.geometry.arrays import Array, Booleans, Complexes
from planes.words.names import POLE


@dataclass
class Explanation:
    """The hypotheses of a plan settled on the ink of a sheet, the likeliest first; its pole is near ``pole``."""

    plan: PlanLines
    ink: SheetInk
    pole: complex

    def __post_init__(self) -> None:
        self.scorer = Scorer(self.plan, self.ink, self.pole)
        self.laid = self.scorer.weighed()
        if self.plan.kind != "force":
            best = self.best
            fitted = fitted_marks(self.plan, self.ink, self.pole, self.plan.row(best.places), best.sigmas)
            best.places = dict(zip(self.plan.names, fitted.tolist(), strict=True))

    @cached_property
    def right(self) -> Laid:
        """The right plan, settled on the ink."""
        return next(one for one in self.laid if one.hypothesis.right)

    @cached_property
    def wrong(self) -> Laid | None:
        """The likeliest drawing with a mistake that moves a mark."""
        true = self.plan.true
        mistakes = (one for one in self.laid if not one.hypothesis.right)
        moved = (one for one in mistakes if any(abs(z - true[n]) > w.MOVED_MM for n, z in one.places.items()))
        return next(moved, None)

    @property
    def chance_wrong(self) -> float:
        """The probability of a mistake, from these two."""
        if self.wrong is None:
            return 0.0
        return logistic(w.ODDS[0] + w.ODDS[1] * (self.wrong.score - self.right.score))

    @property
    def best(self) -> Laid:
        """The likelier of the two."""
        return self.wrong if self.wrong and self.chance_wrong > 0.5 else self.right

    @property
    def doubt(self) -> float:
        """The probability of the other one."""
        return min(self.chance_wrong, 1 - self.chance_wrong)

    @property
    def share(self) -> float:
        """The scale of the sheet as seen: its print scale, or that of the mark that determines it."""
        if self.plan.held is None:
            return self.plan.share
        free = replace(self.plan, held=None).draw(self.best.hypothesis, {}, 1)
        mark, where = self.plan.held
        return 1.0 if free is None else float(abs(free[0, self.plan.labels.index(mark)] / where))

    @property
    def explained(self) -> float:
        """The share of the ink around the likeliest drawing that it explains."""
        box = self.scorer.box
        every = float(self.ink.mm[box.holds(self.ink.points)].sum()) if box else 0.0
        return 1 - self.best.strange / every if every else 0.0

    def exchanged(self) -> list[SignFault]:
        """Pairs of swapped letters in a right plan, detected by the marks beside them."""
        words, right = self.scorer.words, self.best
        if not right.hypothesis.right or self.doubt > w.ASKED:
            return []
        ends = {n: self.pole + right.places[n] for n in self.plan.labels}
        for one, two in combinations(ends, 2):
            crossed = words.by(one, ends[two]) * words.by(two, ends[one])
            straight = words.by(one, ends[one]) * words.by(two, ends[two])
            apart = abs(ends[one] - ends[two]) > 2 * w.BESIDE_MM
            if apart and crossed > max(w.CROSSED, w.RATHER * straight):
                return [SignFault("names_exchanged", one, two, w.EXCHANGED)]
        return []

    def whole_fault(self) -> list[SignFault]:
        """The fault of a plan mirrored, turned or at a wrong scale as a whole, its marks being right otherwise."""
        h, bench = self.best.hypothesis, self.plan.bench
        if h.kind == "scaled" and bench.asked.mu:
            return [plan_scaled(bench, bench.said_mu * abs(h.turn), 1 - self.doubt)]
        if h.mirrored:
            return [SignFault("plan_mirrored", self.plan.labels[0], POLE, 1 - self.doubt)]
        angle = math.degrees(math.atan2(h.turn.imag, h.turn.real))
        fault = SignFault("plan_turned", self.plan.labels[0], POLE, 1 - self.doubt, angle)
        return [fault] if h.kind == "turned_whole" else []

    def undone(self, z: complex) -> complex:
        """A point of a plan that was mirrored or turned as a whole, transformed back."""
        h, pole = self.best.hypothesis, self.pole + self.best.places.get(POLE, 0j)
        if h.mirrored:
            return pole + ((z - pole) / h.turn).conjugate()
        as_one = h.kind == "turned_whole" or (h.kind == "scaled" and self.plan.bench.asked.mu)
        return pole + (z - pole) / h.turn if as_one else z

    def spots(self) -> list[ReadMark]:
        """The marks seen, from the pole; for a force polygon the ends of its sides in the order of laying."""
        best, doubt = self.best, self.doubt if self.doubt > w.NO_DOUBT else 0.0
        pole = ReadMark(POLE, self.pole + best.places.get(POLE, 0j), w.POLE_MM)
        if self.plan.kind == "force":
            return [pole, *self._sides(best, doubt)]
        places = ((n, best.places.get(n, 0j)) for n in self.plan.labels)
        shown = ((n, z) for n, z in places if best.sigmas.get(n, math.inf) < w.UNSEEN_MM and n != self._left_out)
        return [pole, *(ReadMark(n, self.undone(self.pole + z), self._error_mm(best, n), doubt) for n, z in shown)]

    @property
    def _left_out(self) -> str | None:
        """The mark omitted in the likeliest drawing."""
        hypothesis = self.best.hypothesis
        return hypothesis.mark if hypothesis.kind.endswith(LEFT_OUT) else None

    def _sides(self, best: Laid, doubt: float) -> Iterator[ReadMark]:
        a, b = self.scorer.ends(best)
        for k in best.hypothesis.order or range(len(self.plan.sides)):
            side = self.plan.sides[k]
            if side.end != self._left_out and abs(b[k] - a[k]) > w.POINT_MM:
                end = END if self.plan.lines[k][1] == END else side.end
                yield ReadMark(side.name, self.undone(complex(b[k])), self._error_mm(best, end), doubt)

    def _error_mm(self, best: Laid, name: str) -> float:
        """σ of a mark's position."""
        sigma = min(best.sigmas.get(name, 0.0), w.UNSEEN_MM)
        return math.hypot(w.READ_MM, w.SIGMAS * sigma, w.ASTRAY * best.moved.get(name, 0.0))

    def named(self) -> list[str]:
        """Marks without ink whose names stand beside their expected positions."""
        if self.plan.kind == "force" or not self.best.hypothesis.right:
            return []
        hidden = (n for n in self.plan.labels if self.best.sigmas.get(n, math.inf) >= w.UNSEEN_MM)
        return [n for n in hidden if self.named_there(n) > w.LIKELY]

    def named_there(self, mark: str) -> float:
        """The probability that the name of a mark stands beside it."""
        return self.scorer.words.by(mark, self.pole + self.best.places[mark])

    def untold(self) -> list[str]:
        """Marks, or sides of a force polygon, that lie elsewhere in the other drawing where the two are in doubt.

        Otherwise, those far off in a drawing that fits the ink as well: that its mistake is rare is no evidence.
        """
        if not self.right.places:
            return []
        if self.wrong and (self.best is self.wrong or self.doubt >= w.ASKED):
            return self._elsewhere([self.wrong], w.MOVED_MM, self.wrong.hypothesis.mark)
        return self._elsewhere(self.rivals(), w.FAR_OFF_MM)

    def rivals(self) -> list[Laid]:
        """Drawings that fit the ink as well as the best of those with every mark in place."""
        laid = [one for one in self.laid if one.places]
        here = max(one.evidence for one in laid if (self._off_mm(one) <= w.FAR_OFF_MM).all())
        return [one for one in laid if here - one.evidence < w.TELLING]

    def _elsewhere(self, drawings: Sequence[Laid], apart_mm: float, blamed: str = "") -> list[str]:
        """Marks or sides farther than ``apart_mm`` from the right plan in any of the drawings, and those blamed."""
        off = numpy.array([self._off_mm(one) > apart_mm for one in (self.right, *drawings)])
        ends, names = self.plan.labels, self.plan.labels
        if self.plan.sides:
            ends, names = [side.end for side in self.plan.sides], [side.name for side in self.plan.sides]
        return [name for name, end, far in zip(names, ends, off.T, strict=True) if far.any() or end == blamed]

    def _off_mm(self, one: Laid) -> Array:
        """The distance of each mark, or each side of a force polygon, from that of the right plan."""
        return numpy.asarray(abs(self._drawn(one) - self._drawn(self.right)))

    def _drawn(self, one: Laid) -> Complexes:
        """The marks of a drawing from the pole; for a force polygon its sides, in any order."""
        places, count = self.plan.row(one.places), len(self.plan.sides)
        sides = places[self.plan.ends[:count]] - places[self.plan.starts[:count]]
        return sides if count else places[: len(self.plan.labels)]

    def faint(self) -> list[str]:
        """Vectors whose lines are hardly visible in the likeliest drawing, or whose heads are not at their ends."""
        return [self._name(k) for k in numpy.flatnonzero(self._gone | self.scorer.headless(self.best)).tolist()]

    def unled(self) -> list[str]:
        """Marks with faint lines only: their positions come from the plan, not from the drawing."""
        plan, needed = self.plan, self.plan.needed
        every = ((n, needed & ((plan.starts == k) | (plan.ends == k))) for k, n in enumerate(plan.names))
        return [n for n, own in every if n in plan.labels and own.any() and self._gone[own].all()]

    @cached_property
    def _gone(self) -> Booleans:
        """Lines with long gaps."""
        a, b = self.scorer.ends(self.best)
        gaps = [self.ink.longest_gap(p, q) if abs(q - p) > w.LONG_MM else 0.0 for p, q in zip(a, b, strict=True)]
        return numpy.asarray(self.plan.needed & (numpy.array(gaps) > w.TORN_MM))

    def reversed_vectors(self) -> list[SignFault]:
        """Vectors of the right plan that have their heads at their starts, where most others have them right."""
        how, lines = {1.0: DrawnVector("end"), -2.0: DrawnVector("start")}, self.plan.lines
        names = [("", self._name(k)) if k < len(self.plan.sides) else line for k, line in enumerate(lines)]
        seen = {n: how[h] for n, h in zip(names, self.scorer.heads_seen(self.best).tolist(), strict=True) if h in how}
        return [replace(f, chance_wrong=w.TURNED) for f in arrow_faults(seen)] if self.best.hypothesis.right else []

    def _name(self, k: int) -> str:
        plan, line = self.plan, self.plan.lines[k]
        return plan.sides[k].name if k < len(plan.sides) else plan.bench.vectors.get(line) or line[1]
