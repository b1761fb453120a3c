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
from planes.check.explaining.plan_lines import LAST_SIDE_END, PlanLines
from planes.check.explaining.scorer import Laid, Scorer
from planes.check.grading.evidence import logistic
from planes.check.grading.paper import ReadMark
from planes.check.grading.sign_faults import DrawnVector, SignFault, arrow_faults
from planes.check.grading.signs import plan_scale_fault
from planes.geometry.arrays import Array, Booleans, Complexes
from planes.words.names import POLE_LABEL


@dataclass
class Explanation:
    """The hypotheses of a plan settled on the ink of a sheet, the likeliest first; its pole is near ``pole``."""

    plan: PlanLines
    ink: SheetInk
    pole: complex

    def __post_init__(self) -> None:
        self.scorer = Scorer(self.plan, self.ink, self.pole)
        self.laid = self.scorer.rank_drawings()
        if self.plan.kind != "force":
            best = self.likeliest_drawing
            fitted = fitted_marks(self.plan, self.ink, self.pole, self.plan.row(best.places), best.sigmas)
            best.places = dict(zip(self.plan.names, fitted.tolist(), strict=True))

    @cached_property
    def right_drawing(self) -> Laid:
        """The right plan, settled on the ink."""
        return next(one for one in self.laid if one.hypothesis.is_right)

    @cached_property
    def wrong_drawing(self) -> Laid | None:
        """The likeliest drawing with a mistake that moves a mark."""
        true = self.plan.true
        mistakes = (one for one in self.laid if not one.hypothesis.is_right)
        moved = (
            one for one in mistakes if any(abs(z - true[n]) > w.LEAST_MISTAKE_SHIFT_MM for n, z in one.places.items())
        )
        return next(moved, None)

    @property
    def chance_wrong(self) -> float:
        """The probability of a mistake, from these two."""
        if self.wrong_drawing is None:
            return 0.0
        return logistic(
            w.MISTAKE_LOG_ODDS[0] + w.MISTAKE_LOG_ODDS[1] * (self.wrong_drawing.score - self.right_drawing.score)
        )

    @property
    def likeliest_drawing(self) -> Laid:
        """The likelier of the two."""
        if self.wrong_drawing and self.chance_wrong > 0.5:
            return self.wrong_drawing
        return self.right_drawing

    @property
    def chance_of_other_drawing(self) -> float:
        """The probability of the other one."""
        return min(self.chance_wrong, 1 - self.chance_wrong)

    @property
    def sheet_scale(self) -> float:
        """The scale of the sheet as seen: its print scale, or that of the mark that determines it."""
        if self.plan.held is None:
            return self.plan.share
        free = replace(self.plan, held=None).mark_positions(self.likeliest_drawing.hypothesis, {}, 1)
        mark, where = self.plan.held
        if free is None:
            return 1.0
        return float(abs(free[0, self.plan.labels.index(mark)] / where))

    @property
    def explained_ink_share(self) -> float:
        """The share of the ink around the likeliest drawing that it explains."""
        box = self.scorer.box
        every = float(self.ink.mm[box.holds(self.ink.points)].sum()) if box else 0.0
        return 1 - self.likeliest_drawing.strange / every if every else 0.0

    def swapped_letter_faults(self) -> list[SignFault]:
        """Pairs of swapped letters in a right plan, detected by the marks beside them."""
        words = self.scorer.words
        right = self.likeliest_drawing
        if not right.hypothesis.is_right or self.chance_of_other_drawing > w.LEAST_SERIOUS_DOUBT:
            return []
        ends = {n: self.pole + right.places[n] for n in self.plan.labels}
        for one, two in combinations(ends, 2):
            crossed = words.name_probability_at(one, ends[two]) * words.name_probability_at(two, ends[one])
            straight = words.name_probability_at(one, ends[one]) * words.name_probability_at(two, ends[two])
            apart = abs(ends[one] - ends[two]) > 2 * w.MOST_NAME_DISTANCE_MM
            if apart and crossed > max(w.LEAST_SWAPPED_NAME_ODDS, w.SWAPPED_OVER_OWN_ODDS * straight):
                return [SignFault("names_exchanged", one, two, w.SWAPPED_NAMES_CERTAINTY)]
        return []

    @property
    def is_at_wrong_scale(self) -> bool:
        """Whether the whole plan is at another scale than the given one; where none is given, the drawer chooses."""
        return self.likeliest_drawing.hypothesis.kind == "scaled" and bool(self.plan.bench.asked.mu)

    def transformed_plan_faults(self) -> list[SignFault]:
        """The fault of a plan mirrored, turned or at a wrong scale as a whole, its marks being right otherwise."""
        h = self.likeliest_drawing.hypothesis
        bench = self.plan.bench
        if self.is_at_wrong_scale:
            return [plan_scale_fault(bench, bench.said_mu * abs(h.turn), 1 - self.chance_of_other_drawing)]
        if h.mirrored:
            return [SignFault("plan_mirrored", self.plan.labels[0], POLE_LABEL, 1 - self.chance_of_other_drawing)]
        angle = math.degrees(math.atan2(h.turn.imag, h.turn.real))
        fault = SignFault("plan_turned", self.plan.labels[0], POLE_LABEL, 1 - self.chance_of_other_drawing, angle)
        return [fault] if h.kind == "turned_whole" else []

    def undo_transformation(self, z: complex) -> complex:
        """A point of a plan that was mirrored or turned as a whole, transformed back."""
        h = self.likeliest_drawing.hypothesis
        pole = self.pole + self.likeliest_drawing.places.get(POLE_LABEL, 0j)
        if h.mirrored:
            return pole + ((z - pole) / h.turn).conjugate()
        return pole + (z - pole) / h.turn if h.kind == "turned_whole" or self.is_at_wrong_scale else z

    def seen_marks(self) -> list[ReadMark]:
        """The marks seen, from the pole; for a force polygon the ends of its sides in the order of laying."""
        best = self.likeliest_drawing
        doubt = self.chance_of_other_drawing if self.chance_of_other_drawing > w.NEGLIGIBLE_DOUBT else 0.0
        pole = ReadMark(POLE_LABEL, self.pole + best.places.get(POLE_LABEL, 0j), w.POLE_SIGMA_MM)
        if self.plan.kind == "force":
            return [pole, *self._force_side_marks(best, doubt)]
        places = ((n, best.places.get(n, 0j)) for n in self.plan.labels)
        shown = (
            (n, z)
            for n, z in places
            if best.sigmas.get(n, math.inf) < w.UNSEEN_MARK_SIGMA_MM and n != self._omitted_mark
        )
        return [
            pole,
            *(
                ReadMark(n, self.undo_transformation(self.pole + z), self._mark_sigma_mm(best, n), doubt)
                for n, z in shown
            ),
        ]

    @property
    def _omitted_mark(self) -> str | None:
        """The mark omitted in the likeliest drawing."""
        variant = self.likeliest_drawing.hypothesis.variant
        return variant.blames if variant and variant.omits else None

    def _force_side_marks(self, best: Laid, doubt: float) -> Iterator[ReadMark]:
        a, b = self.scorer.ends(best)
        for k in best.hypothesis.order or range(len(self.plan.sides)):
            side = self.plan.sides[k]
            if side.end != self._omitted_mark and abs(b[k] - a[k]) > w.SHORTEST_SIDE_MM:
                end = LAST_SIDE_END if self.plan.lines[k][1] == LAST_SIDE_END else side.end
                yield ReadMark(
                    side.name, self.undo_transformation(complex(b[k])), self._mark_sigma_mm(best, end), doubt
                )

    def _mark_sigma_mm(self, best: Laid, name: str) -> float:
        """σ of a mark's position."""
        sigma = min(best.sigmas.get(name, 0.0), w.UNSEEN_MARK_SIGMA_MM)
        return math.hypot(
            w.READING_SIGMA_MM, w.SETTLING_SIGMA_FACTOR * sigma, w.SIGMA_PER_MM_MOVED * best.moved.get(name, 0.0)
        )

    def marks_seen_by_name_only(self) -> list[str]:
        """Marks without ink whose names stand beside their expected positions."""
        if self.plan.kind == "force" or not self.likeliest_drawing.hypothesis.is_right:
            return []
        hidden = (
            n for n in self.plan.labels if self.likeliest_drawing.sigmas.get(n, math.inf) >= w.UNSEEN_MARK_SIGMA_MM
        )
        return [n for n in hidden if self.named_there(n) > w.LEAST_NAME_CERTAINTY]

    def named_there(self, mark: str) -> float:
        """The probability that the name of a mark stands beside it."""
        return self.scorer.words.name_probability_at(mark, self.pole + self.likeliest_drawing.places[mark])

    def unverified_marks(self) -> list[str]:
        """Marks, or sides of a force polygon, that lie elsewhere in the other drawing where the two are in doubt.

        Otherwise, those far off in a drawing that fits the ink as well: that its mistake is rare is no evidence.
        """
        is_scaled = self.likeliest_drawing.hypothesis.kind == "scaled"
        if (is_scaled and not self.is_at_wrong_scale) or not self.right_drawing.places:
            return []
        if self.wrong_drawing and (
            self.likeliest_drawing is self.wrong_drawing or self.chance_of_other_drawing >= w.LEAST_SERIOUS_DOUBT
        ):
            return self._displaced_marks(
                [self.wrong_drawing], w.LEAST_MISTAKE_SHIFT_MM, self.wrong_drawing.hypothesis.mark
            )
        return self._displaced_marks(self.rival_drawings(), w.RIVAL_MARK_DISTANCE_MM)

    def rival_drawings(self) -> list[Laid]:
        """Drawings that fit the ink as well as the best of those with every mark in place."""
        laid = [one for one in self.laid if one.places]
        here = max(
            one.score_without_mistake
            for one in laid
            if (self._distances_from_right_mm(one) <= w.RIVAL_MARK_DISTANCE_MM).all()
        )
        return [one for one in laid if here - one.score_without_mistake < w.LEAST_EVIDENCE_GAP]

    def _displaced_marks(self, drawings: Sequence[Laid], apart_mm: float, blamed: str = "") -> list[str]:
        """Marks or sides farther than ``apart_mm`` from the right plan in any of the drawings, and those blamed."""
        off = numpy.array([self._distances_from_right_mm(one) > apart_mm for one in (self.right_drawing, *drawings)])
        ends = self.plan.labels
        names = self.plan.labels
        if self.plan.sides:
            ends = [side.end for side in self.plan.sides]
            names = [side.name for side in self.plan.sides]
        return [name for name, end, far in zip(names, ends, off.T, strict=True) if far.any() or end == blamed]

    def _distances_from_right_mm(self, one: Laid) -> Array:
        """The distance of each mark, or each side of a force polygon, from that of the right plan."""
        return numpy.asarray(abs(self._drawn_vectors(one) - self._drawn_vectors(self.right_drawing)))

    def _drawn_vectors(self, one: Laid) -> Complexes:
        """The marks of a drawing from the pole; for a force polygon its sides, in any order."""
        places = self.plan.row(one.places)
        count = len(self.plan.sides)
        sides = places[self.plan.ends[:count]] - places[self.plan.starts[:count]]
        return sides if count else places[: len(self.plan.labels)]

    def faint_vectors(self) -> list[str]:
        """Vectors whose lines are hardly visible in the likeliest drawing, or whose heads are not at their ends."""
        return [
            self._line_name(k)
            for k in numpy.flatnonzero(
                self._lines_with_long_gaps | self.scorer.headless_vectors(self.likeliest_drawing)
            ).tolist()
        ]

    def marks_without_clear_lines(self) -> list[str]:
        """Marks with faint lines only: their positions come from the plan, not from the drawing."""
        plan = self.plan
        needed = self.plan.needed
        every = ((n, needed & ((plan.starts == k) | (plan.ends == k))) for k, n in enumerate(plan.names))
        return [n for n, own in every if n in plan.labels and own.any() and self._lines_with_long_gaps[own].all()]

    @cached_property
    def _lines_with_long_gaps(self) -> Booleans:
        """Lines with long gaps."""
        a, b = self.scorer.ends(self.likeliest_drawing)
        gaps = [
            self.ink.longest_gap(p, q) if abs(q - p) > w.VISIBLE_LINE_MM else 0.0 for p, q in zip(a, b, strict=True)
        ]
        return numpy.asarray(self.plan.needed & (numpy.array(gaps) > w.MOST_LINE_GAP_MM))

    def reversed_vector_faults(self) -> list[SignFault]:
        """Vectors of the right plan that have their heads at their starts, where most others have them right."""
        how = {1.0: DrawnVector("end"), -2.0: DrawnVector("start")}
        lines = self.plan.lines
        names = [("", self._line_name(k)) if k < len(self.plan.sides) else line for k, line in enumerate(lines)]
        seen = {
            n: how[h]
            for n, h in zip(names, self.scorer.drawing_head_states(self.likeliest_drawing).tolist(), strict=True)
            if h in how
        }
        if self.likeliest_drawing.hypothesis.is_right:
            return [replace(f, chance_wrong=w.REVERSED_VECTOR_CHANCE) for f in arrow_faults(seen)]
        return []

    def _line_name(self, k: int) -> str:
        plan = self.plan
        line = self.plan.lines[k]
        if k < len(plan.sides):
            return plan.sides[k].name
        return plan.bench.vector_names.get(line) or line[1]
