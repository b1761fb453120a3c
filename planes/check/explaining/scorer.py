"""Scores every hypothesis on the ink of a sheet: ink covered, missing and unexplained, heads, drawing errors.

First all of them roughly, then the best of each kind on all ink, then the best few settled mark by mark: each mark may
be slightly off its constructed point, and the steps after it continue from there.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy

from planes.check.evidence.handwritten import HandWords
from planes.check.evidence.sheet_ink import Box, SheetInk
from planes.check.explaining import weights as w
from planes.check.explaining.beforehand import LOST, covered, omitted, orders, shares_of_print
from planes.check.explaining.hypotheses import catalogue, free_sizes, wholes, with_size
from planes.check.explaining.plan_lines import Hypothesis, PlanLines, to_be_seen
from planes.geometry.arrays import Array, Booleans, Complexes
from planes.words.frozen import replace

Moves = Mapping[str, complex | Array]
"""Displacements of marks, mm."""


def rounded(z: complex) -> complex:
    """A point to a tenth of a millimetre, as a key of the cache."""
    return complex(round(z.real, 1), round(z.imag, 1))


@dataclass
class Laid:
    """A hypothesis settled on the ink: score, share of its lines found, marks by label (mm from the pole), σ (mm)."""

    hypothesis: Hypothesis
    score: float
    cover: float = 0.0
    places: dict[str, complex] = field(default_factory=dict)
    sigmas: dict[str, float] = field(default_factory=dict)
    strange: float = 0.0  # ink explained by none of its lines, mm
    moved: dict[str, float] = field(default_factory=dict)  # distances from the constructed points, mm
    erred: float = 0.0  # the cost of those

    @property
    def evidence(self) -> float:
        """The evidence of the sheet alone, without the prior."""
        return self.score + self.hypothesis.cost


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

    def weighed(self) -> list[Laid]:
        """The likeliest hypotheses, settled, the best first; the right plan is one of them."""
        if plain := self._plainly() if self.ink.exact else []:
            before, named = plain[0].score, self._by_signs(plain)
            if before - named[0].score < w.TELLING:  # no name stands elsewhere
                return named
            self.box = None
        self.plan.share, laid = self._printed_at(), list[Laid]()
        other = next(iter(orders(self.plan, self.ink, self.pole)), Hypothesis()).order
        bases = [Hypothesis(), Hypothesis(order=other, cost=w.ORDER)]
        for base in bases[: 1 + bool(other)]:
            likely = self.likeliest(base)
            laid += [self.settled(h) for h in (likely if any(h.right for h in likely) else [*likely, base])]
        best = max(laid, key=lambda one: one.score)
        if w.AT_ALL < best.cover < w.EXPLAINED:
            single = [one.hypothesis for one in _best_first(laid)]
            for first in [h for h in single if not h.right and h.turn == 1][: w.FIRSTS]:
                pairs = [h for h in self.likeliest(first, alone=True) if h != first]
                laid += [self.settled(h) for h in pairs[: w.SECONDS]]
        return self._by_signs(_best_first(laid))

    def _in_the_order_of_mistakes(self, laid: list[Laid]) -> list[Laid]:
        """The right force polygon in the order in which the likeliest wrong one is laid, if it was not tried."""
        wrong = max((one for one in laid if not one.hypothesis.right), key=lambda one: one.score, default=None)
        tried = [one.hypothesis.order for one in laid if one.hypothesis.right]
        if wrong is None or wrong.hypothesis.order in tried:
            return []
        return [self.settled(Hypothesis(order=wrong.hypothesis.order, cost=w.ORDER))]

    def heads_seen(self, one: Laid) -> Array:
        """The heads of the vectors needed in a drawing: see :meth:`SheetInk.heads_seen`. Of one not drawn, nothing."""
        if not one.places or self.plan.kind == "position":
            return numpy.zeros(len(self.plan.lines))
        a, b = self.ends(one)
        return self.ink.heads_seen(a, b) * (self.plan.needed & (self.ink.along(a, b, w.COARSE, 2) > w.DRAWN))

    def headless(self, one: Laid) -> Booleans:
        """Its vectors without a head at their ends, where more have one."""
        seen = self.heads_seen(one)
        return numpy.asarray((seen < 0) & (numpy.sign(seen).sum() > 0))

    def _plainly(self) -> list[Laid]:
        """The right plan and mistakes of the catalogue, if one leaves no ink unexplained: no other is likelier."""
        rough = self._rough([Hypothesis(), *catalogue(self.plan)])
        if not rough or not rough[0][1].right:
            return []
        self.box = self._room(Hypothesis(), numpy.concatenate([drawn for *_, drawn in rough]))
        laid = [self.settled(rough[0][1])]
        if not self._full(laid[0]):
            laid += [self.settled(h) for _, h, _ in sorted(rough[1:], key=lambda r: -r[0])[: w.FIRSTS]]
        laid = _best_first(laid)
        if self._full(laid[0]):
            return laid
        self.box = None
        return []

    def _full(self, one: Laid) -> bool:
        """Whether all lines and heads, or all points and symbols, of a drawing are found and no ink is left.

        Beside a scheme there may be guides, dimensions and more.
        """
        if not one.places:
            return False
        (a, b), scheme = self.ends(one), self.plan.kind == "position"
        signs = len(self.plan.labels) if scheme else (to_be_seen(a[None], b[None]) & self.plan.needed).sum()
        beside = w.STRANGE * min(one.strange, self._most_strange) if scheme else 0.0
        short = w.HEAD * self.ink.most_head * signs - one.evidence - beside
        return bool(short - one.erred < w.TELLING and not (one.hypothesis.right and short > w.COSTS["length"]))

    def _rough(self, every: list[Hypothesis]) -> list[tuple[float, Hypothesis, Complexes]]:
        """Hypotheses of one order that can be drawn, with rough scores of their lines."""
        could = [(h, drawn) for h, drawn in self.plan.each(every) if drawn is not None]
        if not could:
            return []
        scores = self.covered(*self._lines(every[0], numpy.concatenate([drawn for _, drawn in could])), 2)[0]
        return [(score - h.cost, h, drawn) for score, (h, drawn) in zip(scores.tolist(), could, strict=True)]

    def _printed_at(self) -> float:
        """The print scale of the sheet: the one with the likeliest settled drawing."""
        shares = shares_of_print(self.plan, self.ink, self.pole)
        best, most = shares[0][0], -math.inf
        for share, h in shares if len(shares) > 1 else ():
            self.plan.share = share
            score = self.settled(h).score - w.PRINTED * (share != 1)
            best, most = (share, score) if score > most else (best, most)
        return best

    def _by_signs(self, laid: list[Laid]) -> list[Laid]:
        """The same drawings scored with their heads and the names beside their lines; right force polygons in more
        orders, too."""
        best = laid[0]
        a, b = self.ends(best)
        seen, force = abs(b - a) > w.SHORT_MM, self.plan.kind == "force"
        names = [s.name for s in self.plan.sides] if force else self.plan.labels
        self.words = self.ink.words(a[seen], b[seen], self.plan.kind != "position", names)
        if force and self.words.words:
            named = orders(self.plan, self.ink, self.pole, self.words)[: w.NAMED]
            known = [(one.hypothesis.kind, one.hypothesis.mark, one.hypothesis.order) for one in laid]
            laid += [self.settled(h) for h in named if (h.kind, h.mark, h.order) not in known]
        right = next(one for one in laid if one.hypothesis.right)
        for one in laid:
            self._weigh_signs(one, right, names)
        for one in (more := self._in_the_order_of_mistakes(laid)):
            self._weigh_signs(one, right, names)
        return _best_first([*laid, *more])

    def _weigh_signs(self, one: Laid, right: Laid, names: Sequence[str]) -> None:
        """Score the heads missing from vectors that the right drawing has not, and the names that stand elsewhere."""
        if not one.places:
            return
        bare = self.headless(one)
        if right.places and bare.any():
            rows = map(self.plan.row, (one.places, right.places))
            here, there = (z[self.plan.ends] - z[self.plan.starts] for z in rows)
            one.score -= w.HEADLESS * float((bare & (abs(here - there) > w.MOVED_MM)).sum())
        if self.words.words:
            marks = self.plan.row(one.places) + self.pole
            ways = zip(names, *(self.ends(one) if self.plan.kind == "force" else (marks, marks)), strict=False)
            one.score -= w.LETTERS * self.words.told((n, rounded(a), rounded(b)) for n, a, b in ways)

    def ends(self, one: Laid) -> tuple[Complexes, Complexes]:
        """Starts and ends of the lines of a drawing, on the sheet."""
        a, b = self.plan.ends_of(one.places, one.hypothesis.order)
        return a + self.pole, b + self.pole

    def likeliest(self, base: Hypothesis, alone: bool = False) -> list[Hypothesis]:
        """The best hypotheses of each kind and mark added to one; with ``alone``, only its free sizes."""
        others = [] if alone else [replace(h, order=base.order) for h in (*catalogue(self.plan), *wholes(self.plan))]
        rough = [*self._rough([base, *others]), *self._free(base)]
        rough = sorted((r for r in rough if r[0] > LOST / 2), key=lambda r: -r[0])[: w.WEIGHED]
        if not rough:
            return []
        drawn = numpy.concatenate([drawn for *_, drawn in rough])
        self.box = self.box or self._room(base, drawn)
        scores = self.scored(base, drawn, True)[0] - numpy.array([h.cost for _, h, _ in rough])
        best: dict[tuple[str, str], Hypothesis] = {}
        for k in numpy.argsort(-scores, kind="stable").tolist():
            best.setdefault((rough[k][1].kind, rough[k][1].mark), rough[k][1])
        return [*best.values()][: w.SETTLED]

    def _free(self, base: Hypothesis) -> list[tuple[float, Hypothesis, Complexes]]:
        """The best free sizes added to a hypothesis, no two alike for a kind and mark."""
        sizes = free_sizes(self.plan, base)
        moves = {n: numpy.array([z if mark == n else 0j for _, mark, z in sizes]) for n in self.plan.names}
        drawn = self.plan.draw(base, moves, len(sizes)) if sizes else None
        if drawn is None:
            return []
        scores = self.covered(*self._lines(base, drawn), 2)[0] - numpy.array([w.COSTS[kind] for kind, *_ in sizes])
        kept: dict[tuple[str, str], list[complex]] = {}
        best = []
        for k in numpy.argsort(-scores, kind="stable")[: w.MOST].tolist():
            kind, mark, z = sizes[k]
            near = kept.setdefault((kind, mark), [])
            if len(near) < w.KEPT and all(abs(z - other) > w.APART_MM for other in near):
                near.append(z)
                best.append((float(scores[k]), with_size(self.plan, base, sizes[k]), drawn[k : k + 1]))
        return best

    def covered(self, a: Complexes, b: Complexes, about: int, gain: float = w.GAINED) -> tuple[Array, Array]:
        """The score of the lines of each row, drawn or not, and the share of the needed ones found."""
        return covered(self.plan, self.ink, self.pole, a, b, about, gain)

    def heads(self, a: Complexes, b: Complexes) -> Array:
        """The score of the heads at the ends of the lines of each row, each head once; a line that need not be drawn
        does not miss its own."""
        if self.plan.kind == "position":
            return numpy.zeros(len(a))
        there = to_be_seen(a, b)
        felt = numpy.where(there, self.ink.head(numpy.where(there, a, 0j), numpy.where(there, b, 0j)), 0.0)
        felt = numpy.where(self.plan.needed, felt, numpy.maximum(felt, 0.0))
        said: Array = w.HEAD * numpy.where(_shared(a, b, felt), 0.0, felt).sum(axis=1)
        return said

    def points(self, drawn: Complexes) -> Array:
        """The score of the symbols of points at the marks of each row of a scheme."""
        if self.plan.kind != "position":
            return numpy.zeros(len(drawn))
        said: Array = w.HEAD * self.ink.point(drawn[:, : len(self.plan.labels)] + self.pole).sum(axis=1)
        return said

    def scored(self, h: Hypothesis, drawn: Complexes, roughly: bool = False) -> tuple[Array, Array, Array]:
        """The full score of each row, the share of its needed lines found, and the ink left over, mm."""
        a, b = self._lines(h, drawn)
        score, cover = self.covered(a, b, 1 + roughly, 0.0)
        score = score + self.heads(a, b) + self.points(drawn)
        if self.box is None:
            return score, cover, numpy.zeros(len(a))
        more_a, more_b, signs, reach = self.plan.signs(drawn)
        a, b = (numpy.nan_to_num(numpy.hstack([z, more + self.pole])) for z, more in ((a, more_a), (b, more_b)))
        loose = w.LOOSE_MM if roughly else 0.0
        strange = self.ink.unexplained(a, b, self.box, self.pole, loose, signs + self.pole, reach)
        return score - w.STRANGE * numpy.minimum(strange, self._most_strange), cover, strange

    @property
    def _most_strange(self) -> float:
        """The maximum unexplained ink that is weighed, mm: for a scheme in a file, as much as beside a single view."""
        return w.BESIDE_SCHEME_MM if self.ink.exact and self.plan.kind == "position" else math.inf

    def erred(self, moves: Moves) -> Array:
        """The cost of drawing errors: marks off their constructed points."""
        cost = numpy.zeros(())
        for n, v in moves.items():
            cost = cost + w.HAND * numpy.abs(v) ** 2 / self._spread(n) ** 2
        return cost

    def _spread(self, name: str) -> float:
        """The usual drawing error of a mark, σ in mm."""
        return w.HAND_MM + w.HAND_SHARE * self.far[name]

    def settled(self, h: Hypothesis) -> Laid:
        """A hypothesis with each mark settled on its ink."""
        held, scores = dict.fromkeys(self.plan.names, 0j), numpy.zeros(0)
        if (drawn := self.plan.draw(h, {}, 1)) is None:
            return Laid(h, LOST)
        self.far = dict(zip(self.plan.names, numpy.nan_to_num(abs(drawn[0])).tolist(), strict=True))
        if self.ink.exact:
            self._to_ends(h, held)
        for about, sizes in w.MOVES_MM[self.ink.exact :]:
            scores = self._moved(h, held, about, self._moves(sizes))
            if not scores.size:
                return Laid(h, LOST)
        return self._result(h, held, scores)

    def _moves(self, sizes: Iterable[float]) -> list[tuple[str, complex]]:
        ways = [complex(numpy.exp(0.25j * math.pi * k)) for k in range(8)]
        return [(n, mm * way) for n in self.plan.names for mm in sizes for way in ways]

    def _to_ends(self, h: Hypothesis, held: dict[str, complex]) -> None:
        """Moves each mark to a nearby end of a line; the steps after it continue from there."""
        for m, n in enumerate(self.plan.labels):
            drawn = self.plan.draw(h, held, 1)
            if drawn is not None and self.ink.ends.size:
                off = self.ink.ends - (drawn[0, m] + self.pole)
                nearest = complex(off[abs(off).argmin()])
                about = w.TO_END_MM + w.TO_END_SHARE * abs(drawn[0, m])
                held[n] += nearest if abs(nearest) < about else 0j

    def _moved(self, h: Hypothesis, held: dict[str, complex], about: int, moves: list[tuple[str, complex]]) -> Array:
        """The scores of moving each mark from where it is ``held``, once no move improves the score."""
        best, scores = -math.inf, numpy.zeros(0)
        for _ in range(w.ROUNDS):
            tried = {n: numpy.full(len(moves) + 1, v) for n, v in held.items()}
            for k, (n, z) in enumerate(moves, 1):
                tried[n][k] += z
            if (drawn := self.plan.draw(h, tried, len(moves) + 1)) is None:
                return numpy.zeros(0)
            a, b = self._lines(h, drawn)
            scores = self.covered(a, b, about)[0] + self.heads(a, b) + self.points(drawn) - self.erred(tried)
            k = int(numpy.argmax(scores))
            if k == 0 or scores[k] < best + w.ENOUGH:
                break
            best = float(scores[k])
            held[moves[k - 1][0]] += moves[k - 1][1]
        return scores

    def _result(self, h: Hypothesis, held: Mapping[str, complex], scores: Array) -> Laid:
        drawn = self.plan.draw(h, held, 1)
        if drawn is None:
            return Laid(h, LOST)
        score, cover, strange = (float(row[0]) for row in self.scored(h, drawn))
        erred, places = float(self.erred(held)), dict(zip(self.plan.names, drawn[0].tolist(), strict=True))
        laid = Laid(h, score, cover, places, self._sigmas(scores), strange, {n: abs(z) for n, z in held.items()}, erred)
        laid.score += omitted(self.plan, self.ink, *self.ends(laid)) - erred - h.cost
        return laid

    def _sigmas(self, scores: Array) -> dict[str, float]:
        """How well the ink locates each settled mark, by the drop of the score around it: σ of a parabola."""
        sizes, sigmas = w.MOVES_MM[-1][1], dict[str, float]()
        worse = (scores[0] - scores[1:]).reshape(len(self.plan.names), len(sizes), 8)[:, 0]  # at the largest move
        for name, off in zip(self.plan.names, worse, strict=True):
            own = w.HAND * (sizes[0] / self._spread(name)) ** 2  # the prior against a drawing error alone
            least = float((off[:4] + off[4:]).min()) / 2 - own  # in the least certain direction
            sigmas[name] = min(sizes[0] / math.sqrt(2 * max(least, 1e-3)), w.REACH_MM)
            if self.plan.kind == "position" and any(name in line for line in self.plan.lines):
                sigmas[name] = min(sigmas[name], w.SIGN_MM)  # its symbol hides the end of its line
        return sigmas

    def _lines(self, h: Hypothesis, places: Complexes) -> tuple[Complexes, Complexes]:
        a, b = self.plan.laid(places, h.order)
        return a + self.pole, b + self.pole

    def _room(self, h: Hypothesis, drawn: Complexes) -> Box:
        """The box around all that may have been drawn."""
        z = numpy.concatenate(self._lines(h, drawn))
        z = z[numpy.isfinite(z) & (abs(z - self.pole) < max(w.ROOM_MM, self.ink.reach_mm))]
        rim = w.MARGIN_MM * (1 + 1j)
        return Box(complex(z.real.min(), z.imag.min()) - rim, complex(z.real.max(), z.imag.max()) + rim)


def _shared(a: Complexes, b: Complexes, felt: Array) -> Booleans:
    """Lines of each row whose heads are also at the end of another in the same direction, which shows it more."""
    way = (b - a) / numpy.maximum(abs(b - a), 1e-9)
    near = abs(b[:, :, None] - b[:, None, :]) < w.ONE_HEAD_MM
    near &= (way[:, :, None] * way[:, None, :].conj()).real > w.ONE_WAY
    more = felt[:, None, :] - felt[:, :, None]
    return numpy.asarray((near & ((more > 0) | numpy.tril(more == 0, -1))).any(axis=2))
