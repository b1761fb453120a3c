"""The board on which labels find their places: the candidates of each, their costs, and who makes room for whom."""

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from planes.geometry.arrays import Array, Booleans, Indices
from render.labels.candidates import (
    APART_MM,
    BETWEEN,
    FAR,
    NEAR,
    Candidates,
    Label,
    Placed,
    beside,
    distances,
    far_off,
    met,
    nowhere,
    own_distance,
    placed,
    sampled,
    union,
)
from render.labels.nearness import over
from render.labels.surroundings import HARD, Surroundings
from render.paper.style import LARGER

AMBIGUOUS = 8.0  # cost of being nearer to another label's point than to its own
CLOSE = 3.0  # cost of being beside another label, farther away than necessary
PATIENCE = 1000  # how often labels of one board are asked to make room for others
FAR_PLACES = 160, 1000  # of a label that needs a leader line: the nearest free ones; more where those are not enough
AWAY = 150.0  # cost of leaving out a label whose text is elsewhere too: less than an overlap, more than all else
_SWEEPS = 8
REACH_MM = max(APART_MM, BETWEEN[0] * max(LARGER.values()))  # range of interaction between labels
_AROUND = REACH_MM * np.array([-1.0, -0.5, 1.0, 0.5])


class Effect(NamedTuple):
    """The effect of a chosen place on the candidates of other labels: how often it clashes with them, and which it is
    close to."""

    clashing: Indices
    clashes: Indices
    near: Indices


class Everywhere:
    """The candidates of all labels in one list."""

    def __init__(self, every: Candidates) -> None:
        self.every, self.reach = every, np.ascontiguousarray(every.reach.T)

    def effect(self, row: int, own: slice) -> Effect:
        """The effect of the place in a row on all others except its label's ``own``."""
        reached = over(self.reach, self.reach[:, row] + _AROUND)
        reached[own] = False
        at = np.flatnonzero(reached)
        clashes, near = met(self.every.some(at), self.every.some(np.array([row])))
        clashing = np.flatnonzero(clashes[:, 0])
        return Effect(at[clashing], clashes[clashing, 0], at[near[:, 0]])


class Board:
    """The candidates of all labels, the one chosen by each, and the costs of the choices.

    The candidates of all labels are in one list, those of label k at ``rows[k]``.  The effect of a candidate on the
    others is computed once, when it is first chosen; ``clashes`` (labels, candidates) counts the clashes of each
    label's place with every candidate, and ``near`` marks those close to it.
    """

    def __init__(self, labels: Sequence[Label], around: Surroundings) -> None:
        self.labels, self.around = labels, around
        self.options = [beside(label, NEAR) for label in labels]
        self.costs = self.around.judged(self.options)
        for k in range(len(labels)):
            self.costs[k] += AMBIGUOUS * self._strays(k)
        self.chosen, self.wide = dict[int, int](), dict[int, int]()
        self._list()

    def _list(self) -> None:
        """Put the candidates of all labels into one list."""
        self.everywhere, self.static = Everywhere(union(self.options)), np.concatenate(self.costs)
        self.moves = 0
        ends = np.cumsum([0, *map(len, self.costs)]).tolist()
        self.rows = [slice(*two) for two in pairwise(ends)]
        self.clashes, self.near = (np.zeros((len(self.labels), ends[-1]), kind) for kind in (np.int16, np.bool_))
        self.effects: dict[tuple[int, int], Effect] = {}
        for k, option in self.chosen.items():
            self._take(k, option)

    def _strays(self, k: int) -> Booleans:
        """Which candidates of label k are nearer to what another label names than to their own."""
        own, box = self.labels[k], self.options[k].boxes
        others = [z for j, label in enumerate(self.labels) if j != k and label.at != own.at for z in sampled(label.at)]
        if not others:
            return np.zeros(len(box), dtype=bool)
        away = distances(box, np.array(others)).min(axis=1)
        stray: Booleans = away < own_distance(self.options[k], own.at, own.also)
        return stray

    def choose(self) -> None:
        """Each label takes the cheapest remaining place, the important and the most crowded first."""
        free = [int((cost < HARD).sum()) for cost in self.costs]
        for k in sorted(range(len(self.labels)), key=lambda k: (-self.labels[k].priority, free[k], k)):
            self._take(k, int(np.argmin(self.cost(self.rows[k]))))

    def cost(self, rows: slice | Indices, but: int | None = None) -> Array:
        """The cost of candidates among the present places of the other labels, with at most one excepted."""
        clashes, near = self.clashes[:, rows], self.near[:, rows]
        if but is not None:
            clashes, near = np.delete(clashes, but, axis=0), np.delete(near, but, axis=0)
        costs: Array = self.static[rows] + HARD * clashes.sum(axis=0) + CLOSE * near.any(axis=0)
        return costs

    def _take(self, k: int, option: int) -> None:
        """Put label k in a place."""
        if (k, option) not in self.effects:
            self.effects[k, option] = self.everywhere.effect(self.rows[k].start + option, self.rows[k])
        effect, self.chosen[k] = self.effects[k, option], option
        self.clashes[k], self.near[k] = 0, False
        self.clashes[k, effect.clashing], self.near[k, effect.near] = effect.clashes, True

    def places(self) -> Indices:
        """The indices of all chosen places in the list of candidates."""
        return np.array([self.rows[k].start + self.chosen[k] for k in range(len(self.labels))])

    def unhappy(self) -> list[int]:
        """The labels with an overlap."""
        return [int(k) for k in np.flatnonzero(self.cost(self.places()) >= HARD)]

    def repair(self) -> None:
        """Move overlapping labels to their cheapest places, or push the labels in the way aside."""
        for _ in range(_SWEEPS):
            before = dict(self.chosen)
            for k in self.unhappy():
                if not self._moves(k):
                    self._push(k)
            if self.chosen == before:
                return

    def _push(self, k: int) -> None:
        """Give label k an occupied place, if every label there finds another."""
        if self.moves > PATIENCE:
            return
        kept = dict(self.chosen)
        free = np.argsort(self.costs[k], kind="stable")
        free = free[self.costs[k][free] < HARD]
        places = self.options[k].some(free)
        struck = (self.clashes[:, self.rows[k].start + free] > 0).T
        first = np.where(struck.any(axis=1), struck.argmax(axis=1), -1).tolist()
        ways = dict[int, Booleans]()
        for at, (option, j) in enumerate(zip(free.tolist(), first, strict=True)):
            if self.moves > PATIENCE:
                return
            if j >= 0 and j not in ways:
                ways[j] = self._gives_way(j, k, places)
            if j >= 0 and not ways[j][at]:
                self.moves += 1
                continue
            self._take(k, option)
            if all(map(self._moves, np.flatnonzero(struck[at]).tolist())) and self.cost(self.rows[k])[option] < HARD:
                return
            for j, place in kept.items():
                if self.chosen[j] != place:
                    self._take(j, place)

    def _gives_way(self, j: int, k: int, places: Candidates) -> Booleans:
        """Which places of label k leave label j one without an overlap."""
        rows = np.flatnonzero(self.cost(self.rows[j], k) < HARD) + self.rows[j].start
        near = np.delete(self.near[:, rows], k, axis=0).any(axis=0)
        clashes, close = met(places, self.everywhere.every.some(rows))
        leaves: Booleans = ((clashes == 0) & (self.static[rows] + CLOSE * (close | near) < HARD)).any(axis=1)
        return leaves

    def _moves(self, k: int) -> bool:
        """Move label k to its cheapest place; returns whether it has no overlap there."""
        self.moves += 1
        costs = self.cost(self.rows[k])
        self._take(k, int(np.argmin(costs)))
        return bool(costs.min() < HARD)

    def widen(self) -> bool:
        """Give overlapping labels places farther away, with leader lines; False if none is left to give."""
        late = [k for k in self.unhappy() if self.wide.get(k, 0) < len(FAR_PLACES)]
        if not late:
            return False
        far = [far_off(self.labels[k], FAR) for k in late]
        times = [self.wide.get(k, 0) for k in late]
        costs = self.around.cheapest(far, [FAR_PLACES[n] for n in times])
        free = list[Indices]()
        for k, n, cost in zip(late, times, costs, strict=True):
            best = np.argsort(cost, kind="stable")[FAR_PLACES[n - 1] if n else 0 : FAR_PLACES[n]]
            free.append(best[cost[best] < HARD])
            self.wide[k] = n + 1
        farther = [option.some(rows) for option, rows in zip(far, free, strict=True)]
        crossing = self.around.crossing(np.concatenate([some.leaders for some in farther]))
        crossings = np.split(crossing, np.cumsum(list(map(len, free)))[:-1])
        for k, some, cost, rows, more in zip(late, farther, costs, free, crossings, strict=True):
            self.options[k] = union([self.options[k], some])
            self.costs[k] = np.concatenate([self.costs[k], cost[rows] + more])
        self._list()
        return True

    def excuse(self) -> bool:
        """Leave out labels whose text is elsewhere too, to make room for others; False if none overlaps."""
        late = [k for k, label in enumerate(self.labels) if label.told] if self.unhappy() else []
        if not late:
            return False
        for k in late:
            self.options[k] = union([self.options[k], nowhere(self.labels[k])])
            self.costs[k] = np.append(self.costs[k], AWAY)
        self._list()
        return True

    def placed(self) -> Placed:
        """The labels in their chosen places."""
        return placed(self.labels, self.everywhere.every.some(self.places()))
