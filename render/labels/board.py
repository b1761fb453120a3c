"""The board on which labels find their places: the candidates of each, what they cost, who makes room for whom."""

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import shapely

from planes.geometry.arrays import Array, Booleans, Complexes, Indices
from render.labels.candidates import (
    APART_MM,
    CLEAR_MM,
    FAR,
    NEAR,
    Candidates,
    Label,
    Placed,
    beside,
    distances,
    far_off,
    met,
    own_distance,
    placed,
    union,
)
from render.labels.footprints import Bounds, InkedShapes, close

HARD = 200.0  # cost of one overlap, more than all that is merely disliked together
OUTSIDE = 1000.0  # cost of leaving the field
TIGHT = 1.5  # cost of standing closer than ROOM_MM to ink
AMBIGUOUS = 8.0  # cost of standing nearer to another label's point than to its own
CROSSING = 8.0  # cost of a leader's crossing with a stroke
THROUGH = 80.0  # cost of its going through a text
BROKEN = 4.0  # cost of a thin line that is broken for a label
ROOM_MM = 1.3
CLOSE = 3.0  # cost of standing beside another label, farther off than it must
PATIENCE = 1000  # how often labels of one board are asked to make room for others
FAR_PLACES = 160  # of a label that needs a leader line: the nearest free ones
ENOUGH = 8  # crossings, or lines broken: more are hardly worse
AT_ONCE = 5000  # candidates looked at together: what lies near them is held for so many
_SWEEPS = 8


class Effect(NamedTuple):
    """What a chosen place does to the candidates of other labels: which it clashes with and how often, and which it
    stands close to."""

    at: Indices
    clashes: Indices
    near: Booleans


class Board:
    """The candidates of all labels, the one each has chosen, and what the choices cost.

    The candidates of all labels stand in one list, those of label k at ``rows[k]``.  What a candidate does to the
    others is found out once, when it is first chosen; ``clashes`` and ``near`` count what all chosen ones do.
    """

    def __init__(
        self,
        labels: Sequence[Label],
        ground: InkedShapes,
        field: Bounds | None,
        yielding: InkedShapes,
        standing: InkedShapes,
    ) -> None:
        self.labels, self.ground, self.field = labels, ground, field
        self.yielding, self.standing = yielding, standing
        self.options = [beside(label, NEAR) for label in labels]
        self.costs = self._judged(self.options)
        for k in range(len(labels)):
            self.costs[k] += AMBIGUOUS * self._strays(k)
        self.chosen, self.wide, self.moves = dict[int, int](), set[int](), 0
        self._list()

    def _list(self) -> None:
        """Put the candidates of all labels into one list."""
        self.every = union(self.options)
        self.reach, self.static = self.every.reach, np.concatenate(self.costs)
        ends = np.cumsum([0, *map(len, self.costs)]).tolist()
        self.rows = [slice(*two) for two in pairwise(ends)]
        self.effects: dict[tuple[int, int], Effect] = {}
        self.clashes, self.near = np.zeros(ends[-1], np.intp), np.zeros(ends[-1], np.intp)
        for k in self.chosen:
            self._count(k, 1)

    def _count(self, k: int, sign: int) -> None:
        """Count what the place of label k does to the candidates of all others, or take it away."""
        option = self.chosen[k]
        if (k, option) not in self.effects:
            self.effects[k, option] = self._effect(k, option)
        effect = self.effects[k, option]
        self.clashes[effect.at] += sign * effect.clashes
        self.near[effect.at] += sign * effect.near

    def _effect(self, k: int, option: int) -> Effect:
        row = self.rows[k].start + option
        reached = close(self.reach, self.reach[row : row + 1], APART_MM, APART_MM / 2)[:, 0]
        reached[self.rows[k]] = False
        at = np.flatnonzero(reached)
        clashes, near = met(self.every.some(at), self.every.some(np.array([row])))
        return Effect(at, clashes[:, 0], near[:, 0])

    def _judged(self, options: Sequence[Candidates]) -> list[Array]:
        """What every candidate costs before the other labels are looked at."""
        every = union(options)
        cost = every.wish + self._on_ink(every.boxes)
        if self.field is not None:
            x0, y0, x1, y1 = self.field
            boxes = every.boxes
            inside = (boxes[:, 0] >= x0) & (boxes[:, 1] >= y0) & (boxes[:, 2] <= x1) & (boxes[:, 3] <= y1)
            cost += OUTSIDE * ~inside
        return np.split(cost, np.cumsum([len(option.wish) for option in options])[:-1])

    def _on_ink(self, boxes: Array) -> Array:
        """Cost of the strokes that each box touches or nearly touches."""
        if len(boxes) > AT_ONCE:
            parts = np.split(boxes, range(AT_ONCE, len(boxes), AT_ONCE))
            return np.concatenate([self._on_ink(part) for part in parts])
        cost = np.zeros(len(boxes))
        if len(self.ground.shapes):
            pairs, apart = self.ground.gaps(shapely.box(*boxes.T), ROOM_MM)
            cost += TIGHT * (np.bincount(pairs[0, apart <= ROOM_MM], minlength=len(boxes)) > 0)
            cost += HARD * np.bincount(pairs[0, apart <= CLEAR_MM], minlength=len(boxes))
        if len(self.yielding.shapes):
            broken = self.yielding.within(shapely.box(*boxes.T), CLEAR_MM)[0]
            cost += BROKEN * _bounded(np.bincount(broken, minlength=len(boxes)))
        return cost

    def _crossing(self, leaders: Complexes) -> Array:
        """What it costs that leaders cross strokes, thin ones that yield for less, and texts that stand already."""
        strokes = self._crossings(leaders, (self.ground, 1.0), (self.yielding, 0.25))
        return CROSSING * _bounded(strokes) + THROUGH * self._crossings(leaders, (self.standing, 1.0))

    def _crossings(self, leaders: Complexes, *layers: tuple[InkedShapes, float]) -> Array:
        """How many shapes each leader crosses, each counted by its weight."""
        lines = shapely.linestrings(np.stack([leaders.real, leaders.imag], axis=-1))
        counts = np.zeros(len(leaders))
        for inked, weight in layers:
            if len(inked.shapes) and len(leaders):
                pairs = inked.tree.query(lines, predicate="intersects")
                counts += weight * np.bincount(pairs[0], minlength=len(leaders))
        return counts

    def _strays(self, k: int) -> Booleans:
        """Which candidates of label k stand nearer to the point of another label than to their own."""
        others = [z.at for j, z in enumerate(self.labels) if j != k and not isinstance(z.at, tuple)]
        points = np.array([z for z in others if z != self.labels[k].at], dtype=complex)
        if not len(points):
            return np.zeros(len(self.options[k].wish), dtype=bool)
        away = distances(self.options[k].boxes, points).min(axis=1)
        stray: Booleans = away < own_distance(self.options[k], self.labels[k].at)
        return stray

    def choose(self) -> None:
        """Everybody takes the cheapest place left, the important and the hemmed in first."""
        free = [int((cost < HARD).sum()) for cost in self.costs]
        for k in sorted(range(len(self.labels)), key=lambda k: (-self.labels[k].priority, free[k], k)):
            self._take(k, int(np.argmin(self.cost(self.rows[k]))))

    def cost(self, rows: slice | Indices) -> Array:
        """What candidates cost among the present places of the other labels."""
        return self.static[rows] + HARD * self.clashes[rows] + CLOSE * (self.near[rows] > 0)

    def _take(self, k: int, option: int) -> None:
        if k in self.chosen:
            self._count(k, -1)
        self.chosen[k] = option
        self._count(k, 1)

    def places(self) -> Indices:
        """Where the chosen places of all labels stand in the list of candidates."""
        return np.array([self.rows[k].start + self.chosen[k] for k in range(len(self.labels))])

    def unhappy(self) -> list[int]:
        """The labels that overlap something now."""
        return [int(k) for k in np.flatnonzero(self.cost(self.places()) >= HARD)]

    def repair(self) -> None:
        """Move what overlaps to its cheapest place, or push the labels in the way aside."""
        for _ in range(_SWEEPS):
            before = dict(self.chosen)
            for k in self.unhappy():
                if not self._moves(k):
                    self._push(k)
            if self.chosen == before:
                return

    def _push(self, k: int) -> None:
        """Give label k a place held by others, if every one of them finds another."""
        kept = dict(self.chosen)
        free = np.argsort(self.costs[k], kind="stable")
        free = free[self.costs[k][free] < HARD]
        clashes, _ = met(self.options[k].some(free), self.every.some(self.places()))
        clashes[:, k] = 0
        self._count(k, -1)
        stuck = {j for j in np.flatnonzero(clashes.any(axis=0)).tolist() if not self._can_move(j)}
        self._count(k, 1)
        for option, row in zip(free.tolist(), clashes, strict=True):
            held = np.flatnonzero(row).tolist()
            if self.moves > PATIENCE:
                return
            if held and held[0] in stuck:
                self.moves += 1
                continue
            self._take(k, option)
            if all(map(self._moves, held)) and self.cost(self.places()[k : k + 1])[0] < HARD:
                return
            for j, place in kept.items():
                if self.chosen[j] != place:
                    self._take(j, place)

    def _can_move(self, k: int) -> bool:
        """Whether label k has another place."""
        return bool(np.delete(self.cost(self.rows[k]), self.chosen[k]).min() < HARD)

    def _moves(self, k: int) -> bool:
        """Move label k to its cheapest place; whether it overlaps nothing there."""
        self.moves += 1
        costs = self.cost(self.rows[k])
        self._take(k, int(np.argmin(costs)))
        return bool(costs.min() < HARD)

    def widen(self) -> bool:
        """Give labels that still overlap places farther off, with leader lines; False if none is left to be given."""
        late = [k for k in self.unhappy() if k not in self.wide]
        self.wide |= set(late)
        if not late:
            return False
        far = [far_off(self.labels[k], FAR) for k in late]
        for k, option, cost in zip(late, far, self._judged(far), strict=True):
            best = np.argsort(cost, kind="stable")[:FAR_PLACES]
            free = best[cost[best] < HARD]
            some = option.some(free)
            self.options[k] = union([self.options[k], some])
            self.costs[k] = np.concatenate([self.costs[k], cost[free] + self._crossing(some.leaders)])
        self._list()
        return True

    def placed(self) -> Placed:
        """The labels in the places chosen for them."""
        return placed(self.labels, self.every.some(self.places()))


def _bounded(counts: Array | Indices) -> Array:
    """Numbers of what is disliked: beyond some it hardly gets worse."""
    return np.minimum(counts, ENOUGH) + 0.02 * counts.astype(np.float64)
