"""Scores every hypothesis on the ink of a sheet: ink covered, missing and unexplained, heads, drawing errors.

First all of them roughly, then the best of each kind on all ink, then the best few settled mark by mark: each mark may
be slightly off its constructed point, and the steps after it continue from there.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy

from planes.check.evidence.handwritten import HandWords
from planes.check.evidence.sheet_ink import Box, SheetInk
from planes.check.explaining import weights as w
from planes.check.explaining.beforehand import (
    IMPOSSIBLE_SCORE,
    candidate_print_scales,
    omitted_lines_log_odds,
    score_line_coverage,
    side_order_hypotheses,
)
from planes.check.explaining.hypotheses import (
    catalogue_hypotheses,
    transformed_plan_hypotheses,
    trial_displacements,
    with_mark_displaced,
)
from planes.check.explaining.plan_lines import Hypothesis, PlanLines, lines_to_look_for
from planes.check.grading.paper import MarkPlaces
from planes.geometry.arrays import Array, Booleans, Complexes
from planes.words.frozen import replace
from planes.words.names import NamePair

Moves = Mapping[str, complex | Array]
"""Displacements of marks, mm."""


def rounded_cache_point(z: complex) -> complex:
    """A point to a tenth of a millimetre, as a key of the cache."""
    return complex(round(z.real, 1), round(z.imag, 1))


@dataclass
class Laid:
    """A hypothesis settled on the ink: score, share of its lines found, marks by label (mm from the pole), σ (mm)."""

    hypothesis: Hypothesis
    score: float
    cover: float = 0.0
    places: MarkPlaces = field(default_factory=dict)
    sigmas: dict[str, float] = field(default_factory=dict)
    strange: float = 0.0  # ink explained by none of its lines, mm
    moved: dict[str, float] = field(default_factory=dict)  # distances from the constructed points, mm
    erred: float = 0.0  # the cost of those

    @property
    def score_without_mistake(self) -> float:
        """The score but for the rarity of a mistake. That it fits at one of many sizes or places, or in another order
        of the sides, counts."""
        return self.score + (0.0 if self.hypothesis.is_right else w.HYPOTHESIS_COSTS["catalogue"])


def _best_first(laid: Iterable[Laid]) -> list[Laid]:
    return sorted(laid, key=lambda one: -one.score)


@dataclass
class Scorer:
    """Scores the hypotheses of one plan on one sheet, with its pole at a given point."""

    plan: PlanLines
    ink: SheetInk
    pole: complex
    words: HandWords = field(default_factory=HandWords)
    far: dict[str, float] = field(default_factory=dict)  # distance of each mark from the pole as it should be drawn, mm
    box: Box | None = None  # where ink must be explained: the same for all, to keep scores comparable
    orders: dict[float, list[Hypothesis]] = field(default_factory=dict)  # likely orders of sides, by print scale

    def rank_drawings(self) -> list[Laid]:
        """The likeliest hypotheses, settled, the best first; the right plan is one of them."""
        if plain := self._rank_if_fully_explained() if self.ink.exact else []:
            before = plain[0].score
            named = self._rank_by_heads_and_names(plain)
            if before - named[0].score < w.LEAST_EVIDENCE_GAP:  # no name stands elsewhere
                return named
            self.box = None
        self.plan.share, laid = self._likeliest_print_scale(), list[Laid]()
        other = next(iter(self._orders_by_ink()), Hypothesis()).order
        bases = [Hypothesis(), Hypothesis(order=other, cost=w.OTHER_ORDER_COST)]
        for base in bases[: 1 + bool(other)]:
            likely = self.likeliest_hypotheses(base)
            laid += [
                self.settle_hypothesis(h) for h in (likely if any(h.is_right for h in likely) else [*likely, base])
            ]
        best = max(laid, key=lambda one: one.score)
        if w.LEAST_COVER_FOR_SECOND < best.cover < w.MOST_COVER_FOR_SECOND:
            single = [one.hypothesis for one in _best_first(laid)]
            for first in [h for h in single if not h.is_right and h.turn == 1][: w.MOST_FIRST_MISTAKES]:
                pairs = [h for h in self.likeliest_hypotheses(first, alone=True) if h != first]
                laid += [self.settle_hypothesis(h) for h in pairs[: w.MOST_SECOND_MISTAKES]]
        return self._rank_by_heads_and_names(_best_first(laid))

    def _right_plan_in_wrong_order(self, laid: list[Laid]) -> list[Laid]:
        """The right force polygon in the order in which the likeliest wrong one is laid, if it was not tried."""
        wrong = max((one for one in laid if not one.hypothesis.is_right), key=lambda one: one.score, default=None)
        tried = [one.hypothesis.order for one in laid if one.hypothesis.is_right]
        if wrong is None or wrong.hypothesis.order in tried:
            return []
        return [self.settle_hypothesis(Hypothesis(order=wrong.hypothesis.order, cost=w.OTHER_ORDER_COST))]

    def drawing_head_states(self, one: Laid) -> Array:
        """The heads of the vectors needed in a drawing: see :meth:`SheetInk.head_states`. Of one not drawn, nothing."""
        if not one.places or self.plan.kind == "position":
            return numpy.zeros(len(self.plan.lines))
        a, b = self.ends(one)
        return self.ink.head_states(a, b) * (
            self.plan.needed & (self.ink.drawn_shares(a, b, w.COARSE_SAMPLES_PER_LINE, 2) > w.DRAWN_LINE_SHARE)
        )

    def headless_vectors(self, one: Laid) -> Booleans:
        """Its vectors without a head at their ends, where more have one."""
        seen = self.drawing_head_states(one)
        return numpy.asarray((seen < 0) & (numpy.sign(seen).sum() > 0))

    def _rank_if_fully_explained(self) -> list[Laid]:
        """The right plan and mistakes of the catalogue, if one leaves no ink unexplained: no other is likelier."""
        rough = self._rough_scores([Hypothesis(), *catalogue_hypotheses(self.plan)])
        if not rough or not rough[0][1].is_right:
            return []
        self.box = self._drawing_box(Hypothesis(), numpy.concatenate([drawn for *_, drawn in rough]))
        laid = [self.settle_hypothesis(rough[0][1])]
        if not self._is_fully_explained(laid[0]):
            laid += [
                self.settle_hypothesis(h) for _, h, _ in sorted(rough[1:], key=lambda r: -r[0])[: w.MOST_FIRST_MISTAKES]
            ]
        laid = _best_first(laid)
        if self._is_fully_explained(laid[0]):
            return laid
        self.box = None
        return []

    def _is_fully_explained(self, one: Laid) -> bool:
        """Whether all lines and heads, or all points and symbols, of a drawing are found and no ink is left.

        Beside a scheme there may be guides, dimensions and more.
        """
        if not one.places:
            return False
        a, b = self.ends(one)
        scheme = self.plan.kind == "position"
        signs = len(self.plan.labels) if scheme else (lines_to_look_for(a[None], b[None]) & self.plan.needed).sum()
        beside = w.UNEXPLAINED_COST_PER_MM * min(one.strange, self._most_unexplained_mm) if scheme else 0.0
        most = self.ink.most_point if scheme else self.ink.most_head
        short = w.HEAD_EVIDENCE_WEIGHT * most * signs - one.score - one.hypothesis.cost - beside
        return bool(
            short - one.erred < w.LEAST_EVIDENCE_GAP
            and not (one.hypothesis.is_right and short > w.HYPOTHESIS_COSTS["length"])
        )

    def _rough_scores(self, every: list[Hypothesis]) -> list[tuple[float, Hypothesis, Complexes]]:
        """Hypotheses of one order that can be drawn, with rough scores of their lines."""
        could = [(h, drawn) for h, drawn in self.plan.draw_each_hypothesis(every) if drawn is not None]
        if not could:
            return []
        scores = self._rough_drawing_scores(every[0], numpy.concatenate([drawn for _, drawn in could]))
        return [(score - h.cost, h, drawn) for score, (h, drawn) in zip(scores.tolist(), could, strict=True)]

    def _rough_drawing_scores(self, h: Hypothesis, drawn: Complexes) -> Array:
        """Rough scores of the lines and the points of drawings with the sides in the order of a hypothesis."""
        lines = self.line_coverage_scores(*self._lines_on_sheet(h, drawn), 2)[0]
        return lines + self.point_symbol_scores(drawn, roughly=True)

    def _likeliest_print_scale(self) -> float:
        """The print scale of the sheet: the one with the likeliest settled drawing."""
        shares = candidate_print_scales(self.plan, self.ink, self.pole)
        best = shares[0][0]
        most = -math.inf
        for share, h in shares if len(shares) > 1 else ():
            self.plan.share = share
            tried = [h, *self._orders_by_ink()[:1]]
            score = max(self.settle_hypothesis(one).score for one in tried) - w.PRINT_SCALE_COST * (share != 1)
            best, most = (share, score) if score > most else (best, most)
        return best

    def _orders_by_ink(self) -> list[Hypothesis]:
        """Hypotheses with a polygon's sides in the order of the ink, at the print scale assumed."""
        if self.plan.share not in self.orders:
            self.orders[self.plan.share] = side_order_hypotheses(self.plan, self.ink, self.pole)
        return self.orders[self.plan.share]

    def _rank_by_heads_and_names(self, laid: list[Laid]) -> list[Laid]:
        """The same drawings scored with their heads and the names beside their lines; right force polygons in more
        orders, too."""
        best = laid[0]
        a, b = self.ends(best)
        seen = abs(b - a) > w.SHORTEST_LINE_MM
        force = self.plan.kind == "force"
        names = [s.name for s in self.plan.sides] if force else self.plan.labels
        self.words = self.ink.read_words(a[seen], b[seen], self.plan.kind != "position", names)
        if force and self.words.words:
            named = side_order_hypotheses(self.plan, self.ink, self.pole, self.words)[: w.MOST_ORDERS_BY_NAMES]
            known = [(one.hypothesis.kind, one.hypothesis.mark, one.hypothesis.order) for one in laid]
            laid += [self.settle_hypothesis(h) for h in named if (h.kind, h.mark, h.order) not in known]
        right = next(one for one in laid if one.hypothesis.is_right)
        for one in laid:
            self._weigh_signs(one, right, names)
        for one in (more := self._right_plan_in_wrong_order(laid)):
            self._weigh_signs(one, right, names)
        return _best_first([*laid, *more])

    def _weigh_signs(self, one: Laid, right: Laid, names: Sequence[str]) -> None:
        """Score the heads missing from vectors that the right drawing has not, and the names that stand elsewhere."""
        if not one.places:
            return
        bare = self.headless_vectors(one)
        if right.places and bare.any():
            rows = map(self.plan.row, (one.places, right.places))
            here, there = (z[self.plan.ends] - z[self.plan.starts] for z in rows)
            one.score -= w.HEADLESS_VECTOR_COST * float((bare & (abs(here - there) > w.LEAST_MISTAKE_SHIFT_MM)).sum())
        if self.words.words:
            marks = self.plan.row(one.places) + self.pole
            ways = zip(names, *(self.ends(one) if self.plan.kind == "force" else (marks, marks)), strict=False)
            one.score -= w.MISPLACED_NAME_WEIGHT * self.words.total_name_cost(
                (n, rounded_cache_point(a), rounded_cache_point(b)) for n, a, b in ways
            )

    def ends(self, one: Laid) -> tuple[Complexes, Complexes]:
        """Starts and ends of the lines of a drawing, on the sheet."""
        a, b = self.plan.ends_of(one.places, one.hypothesis.order)
        return a + self.pole, b + self.pole

    def likeliest_hypotheses(self, base: Hypothesis, alone: bool = False) -> list[Hypothesis]:
        """The best hypotheses of each kind and mark added to one; with ``alone``, only its free sizes."""
        others = (
            []
            if alone
            else [
                replace(h, order=base.order)
                for h in (*catalogue_hypotheses(self.plan), *transformed_plan_hypotheses(self.plan))
            ]
        )
        rough = [*self._rough_scores([base, *others]), *self._best_displacements(base)]
        rough = sorted((r for r in rough if r[0] > IMPOSSIBLE_SCORE / 2), key=lambda r: -r[0])[
            : w.MOST_HYPOTHESES_SCORED
        ]
        if not rough:
            return []
        drawn = numpy.concatenate([drawn for *_, drawn in rough])
        self.box = self.box or self._drawing_box(base, drawn)
        scores = self.full_scores(base, drawn, True)[0] - numpy.array([h.cost for _, h, _ in rough])
        best: dict[NamePair, Hypothesis] = {}
        for k in numpy.argsort(-scores, kind="stable").tolist():
            best.setdefault((rough[k][1].kind, rough[k][1].mark), rough[k][1])
        return [*best.values()][: w.MOST_HYPOTHESES_SETTLED]

    def _best_displacements(self, base: Hypothesis) -> list[tuple[float, Hypothesis, Complexes]]:
        """The best free sizes added to a hypothesis, no two alike for a kind and mark."""
        sizes = trial_displacements(self.plan, base)
        moves = {n: numpy.array([z if mark == n else 0j for _, mark, z in sizes]) for n in self.plan.names}
        drawn = self.plan.mark_positions(base, moves, len(sizes)) if sizes else None
        if drawn is None:
            return []
        scores = self._rough_drawing_scores(base, drawn) - [w.HYPOTHESIS_COSTS[kind] for kind, *_ in sizes]
        kept: dict[NamePair, list[complex]] = {}
        best = []
        for k in numpy.argsort(-scores, kind="stable")[: w.MOST_DISPLACEMENTS].tolist():
            kind, mark, z = sizes[k]
            near = kept.setdefault((kind, mark), [])
            if len(near) < w.MOST_DISPLACEMENTS_PER_MARK and all(
                abs(z - other) > w.DISPLACEMENT_SPACING_MM for other in near
            ):
                near.append(z)
                best.append((float(scores[k]), with_mark_displaced(self.plan, base, sizes[k]), drawn[k : k + 1]))
        return best

    def line_coverage_scores(
        self, a: Complexes, b: Complexes, about: int, gain: float = w.DRAWN_LINE_GAIN_PER_MM
    ) -> tuple[Array, Array]:
        """The score of the lines of each row, drawn or not, and the share of the needed ones found."""
        return score_line_coverage(self.plan, self.ink, self.pole, a, b, about, gain)

    def head_scores(self, a: Complexes, b: Complexes) -> Array:
        """The score of the heads at the ends of the needed lines of each row."""
        if self.plan.kind == "position":
            return numpy.zeros(len(a))
        there = lines_to_look_for(a, b) & self.plan.needed  # of coincident lines one head counts
        felt = self.ink.head_evidence(numpy.where(there, a, 0j), numpy.where(there, b, 0j))
        said: Array = w.HEAD_EVIDENCE_WEIGHT * numpy.where(there, felt, 0.0).sum(axis=1)
        return said

    def point_symbol_scores(self, drawn: Complexes, roughly: bool = False) -> Array:
        """The score of the symbols of points at the marks of each row of a scheme, or near them. A symbol shows one of
        the marks that lie there, unless they coincide in the right plan."""
        if self.plan.kind != "position":
            return numpy.zeros(len(drawn))
        places = drawn[:, : len(self.plan.labels)]
        said = self.ink.point_evidence(places + self.pole, roughly)
        near = abs(places[:, :, None] - places[:, None]) < w.SAME_SYMBOL_MM
        shared = (near & self._separate_points).any(axis=2)
        return numpy.asarray(w.HEAD_EVIDENCE_WEIGHT * numpy.where(shared, numpy.minimum(said, 0.0), said).sum(axis=1))

    @cached_property
    def _separate_points(self) -> Booleans:
        """Which marks before each one lie apart from it in the right plan."""
        true = numpy.array([self.plan.true[n] for n in self.plan.labels])
        return numpy.asarray(numpy.tril(abs(true[:, None] - true) > w.SAME_SYMBOL_MM))

    def full_scores(self, h: Hypothesis, drawn: Complexes, roughly: bool = False) -> tuple[Array, Array, Array]:
        """The full score of each row, the share of its needed lines found, and the ink left over, mm."""
        a, b = self._lines_on_sheet(h, drawn)
        score, cover = self.line_coverage_scores(a, b, 1 + roughly, 0.0)
        score = score + self.head_scores(a, b) + self.point_symbol_scores(drawn, roughly)
        if self.box is None:
            return score, cover, numpy.zeros(len(a))
        more_a, more_b, signs, reach = self.plan.extra_symbols(drawn)
        a, b = (numpy.nan_to_num(numpy.hstack([z, more + self.pole])) for z, more in ((a, more_a), (b, more_b)))
        loose = w.UNSETTLED_LINE_TOLERANCE_MM if roughly else 0.0
        strange = self.ink.unexplained_ink_mm(a, b, self.box, self.pole, loose, signs + self.pole, reach)
        return score - w.UNEXPLAINED_COST_PER_MM * numpy.minimum(strange, self._most_unexplained_mm), cover, strange

    @property
    def _most_unexplained_mm(self) -> float:
        """The maximum unexplained ink that is weighed, mm: for a scheme in a file, as much as beside a single view."""
        if self.ink.exact and self.plan.kind == "position":
            return w.MOST_INK_BESIDE_SCHEME_MM
        return math.inf

    def drawing_error_cost(self, moves: Moves) -> Array:
        """The cost of drawing errors: marks off their constructed points."""
        cost = numpy.zeros(())
        for n, v in moves.items():
            cost = cost + w.DRAWING_ERROR_WEIGHT * numpy.abs(v) ** 2 / self._drawing_sigma_mm(n) ** 2
        return cost

    def _drawing_sigma_mm(self, name: str) -> float:
        """The usual drawing error of a mark, σ in mm."""
        return w.DRAWING_SIGMA_MM + w.DRAWING_SIGMA_PER_MM * self.far[name]

    def settle_hypothesis(self, h: Hypothesis) -> Laid:
        """A hypothesis with each mark settled on its ink."""
        held = dict.fromkeys(self.plan.names, 0j)
        scores = numpy.zeros(0)
        if (drawn := self.plan.mark_positions(h, {}, 1)) is None:
            return Laid(h, IMPOSSIBLE_SCORE)
        self.far = dict(zip(self.plan.names, numpy.nan_to_num(abs(drawn[0])).tolist(), strict=True))
        if self.ink.exact:
            self._move_marks_to_line_ends(h, held)
        for about, sizes in w.SETTLING_MOVES_MM[self.ink.exact :]:
            scores = self._settle_by_moves(h, held, about, self._trial_moves(sizes))
            if not scores.size:
                return Laid(h, IMPOSSIBLE_SCORE)
        return self._settled_drawing(h, held, scores)

    def _trial_moves(self, sizes: Iterable[float]) -> list[tuple[str, complex]]:
        ways = [complex(numpy.exp(0.25j * math.pi * k)) for k in range(8)]
        return [(n, mm * way) for n in self.plan.names for mm in sizes for way in ways]

    def _move_marks_to_line_ends(self, h: Hypothesis, held: MarkPlaces) -> None:
        """Moves each mark to a nearby end of a line; the steps after it continue from there."""
        for m, n in enumerate(self.plan.labels):
            drawn = self.plan.mark_positions(h, held, 1)
            if drawn is not None and self.ink.ends.size:
                off = self.ink.ends - (drawn[0, m] + self.pole)
                nearest = complex(off[abs(off).argmin()])
                about = w.MOVE_TO_END_MM + w.MOVE_TO_END_PER_MM * abs(drawn[0, m])
                held[n] += nearest if abs(nearest) < about else 0j

    def _settle_by_moves(self, h: Hypothesis, held: MarkPlaces, about: int, moves: list[tuple[str, complex]]) -> Array:
        """The scores of moving each mark from where it is ``held``, once no move improves the score."""
        best = -math.inf
        scores = numpy.zeros(0)
        for _ in range(w.MOST_SETTLING_ROUNDS):
            tried = {n: numpy.full(len(moves) + 1, v) for n, v in held.items()}
            for k, (n, z) in enumerate(moves, 1):
                tried[n][k] += z
            if (drawn := self.plan.mark_positions(h, tried, len(moves) + 1)) is None:
                return numpy.zeros(0)
            a, b = self._lines_on_sheet(h, drawn)
            scores = (
                self.line_coverage_scores(a, b, about)[0]
                + self.head_scores(a, b)
                + self.point_symbol_scores(drawn)
                - self.drawing_error_cost(tried)
            )
            k = int(numpy.argmax(scores))
            if k == 0 or scores[k] < best + w.LEAST_SETTLING_GAIN:
                break
            best = float(scores[k])
            held[moves[k - 1][0]] += moves[k - 1][1]
        return scores

    def _settled_drawing(self, h: Hypothesis, held: Mapping[str, complex], scores: Array) -> Laid:
        drawn = self.plan.mark_positions(h, held, 1)
        if drawn is None:
            return Laid(h, IMPOSSIBLE_SCORE)
        score, cover, strange = (float(row[0]) for row in self.full_scores(h, drawn))
        erred = float(self.drawing_error_cost(held))
        places = dict(zip(self.plan.names, drawn[0].tolist(), strict=True))
        laid = Laid(h, score, cover, places, self._sigmas(scores), strange, {n: abs(z) for n, z in held.items()}, erred)
        laid.score += omitted_lines_log_odds(self.plan, self.ink, *self.ends(laid)) - erred - h.cost
        return laid

    def _sigmas(self, scores: Array) -> dict[str, float]:
        """How well the ink locates each settled mark, by the drop of the score around it: σ of a parabola."""
        sizes = w.SETTLING_MOVES_MM[-1][1]
        sigmas = dict[str, float]()
        worse = (scores[0] - scores[1:]).reshape(len(self.plan.names), len(sizes), 8)[:, 0]  # at the largest move
        for name, off in zip(self.plan.names, worse, strict=True):
            own = (
                w.DRAWING_ERROR_WEIGHT * (sizes[0] / self._drawing_sigma_mm(name)) ** 2
            )  # the prior against a drawing error alone
            least = float((off[:4] + off[4:]).min()) / 2 - own  # in the least certain direction
            sigmas[name] = min(sizes[0] / math.sqrt(2 * max(least, 1e-3)), w.MOST_DISPLACEMENT_MM)
            if self.plan.kind == "position" and any(name in line for line in self.plan.lines):
                sigmas[name] = min(sigmas[name], w.SCHEME_POINT_SIGMA_MM)  # its symbol hides the end of its line
        return sigmas

    def _lines_on_sheet(self, h: Hypothesis, places: Complexes) -> tuple[Complexes, Complexes]:
        a, b = self.plan.line_ends(places, h.order)
        return a + self.pole, b + self.pole

    def _drawing_box(self, h: Hypothesis, drawn: Complexes) -> Box:
        """The box around all that may have been drawn."""
        z = numpy.concatenate(self._lines_on_sheet(h, drawn))
        z = z[numpy.isfinite(z) & (abs(z - self.pole) < max(w.DRAWING_AREA_RADIUS_MM, self.ink.reach_mm))]
        rim = w.DRAWING_AREA_MARGIN_MM * (1 + 1j)
        return Box(complex(z.real.min(), z.imag.min()) - rim, complex(z.real.max(), z.imag.max()) + rim)
