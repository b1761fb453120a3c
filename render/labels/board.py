"""The board on which labels find their places: the candidates of each, their costs, and who makes room for whom."""

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from planes.geometry.arrays import Array, Booleans, Indices
from render.labels.candidates import (
    CLOSE_NEIGHBOUR_MM,
    FAR_DISTANCES_MM,
    LABEL_GAP_RATIOS,
    NEAR_DISTANCES_MM,
    Candidates,
    Label,
    Placed,
    box_point_distances,
    candidates_beside,
    candidates_far_off,
    count_clashes,
    distance_to_own_object,
    join_candidates,
    left_out_candidate,
    place_at_chosen,
    sampled,
)
from render.labels.nearness import boxes_overlap
from render.labels.surroundings import OVERLAP_COST, Surroundings
from render.paper.style import NEXT_LARGER_LETTER_MM

AMBIGUITY_COST = 8.0  # cost of being nearer to what another label names than to its own
STRAY_DISTANCE_MM = 1.5  # a label nearer to what another names, by more than this, is stray
STRAY_COST = 40.0  # added cost of a stray label once all have places: more than a short leader
CLOSENESS_COST = 3.0  # cost of being beside another label, farther away than necessary
MOST_MOVES = 1000  # how often labels of one board are asked to make room for others
# of a label that needs a leader line: the nearest free ones; more where those are not enough
FAR_PLACE_COUNTS = (160, 1000)
# cost of leaving out a label whose text is elsewhere too: less than an overlap, more than all else
LEFT_OUT_COST = 150.0
_MOST_REPAIR_SWEEPS = 8
INTERACTION_RANGE_MM = max(
    CLOSE_NEIGHBOUR_MM, LABEL_GAP_RATIOS[0] * max(NEXT_LARGER_LETTER_MM.values())
)  # range of interaction between labels
_INTERACTION_BOX_MM = INTERACTION_RANGE_MM * np.array([-1.0, -0.5, 1.0, 0.5])


class Effect(NamedTuple):
    """The effect of a chosen place on the candidates of other labels: how often it clashes with them, and which it is
    close to."""

    clashing: Indices
    clashes: Indices
    near: Indices


class Everywhere:
    """The candidates of all labels in one list."""

    def __init__(self, every: Candidates) -> None:
        self.every = every
        self.reach = np.ascontiguousarray(every.outer_boxes.T)

    def effect_on_others(self, row: int, own: slice) -> Effect:
        """The effect of the place in a row on all others except its label's ``own``."""
        reached = boxes_overlap(self.reach, self.reach[:, row] + _INTERACTION_BOX_MM)
        reached[own] = False
        at = np.flatnonzero(reached)
        clashes, near = count_clashes(self.every.select_rows(at), self.every.select_rows(np.array([row])))
        clashing = np.flatnonzero(clashes[:, 0])
        return Effect(at[clashing], clashes[clashing, 0], at[near[:, 0]])


class Board:
    """The candidates of all labels, the one chosen by each, and the costs of the choices.

    The candidates of all labels are in one list, those of label k at ``rows[k]``.  The effect of a candidate on the
    others is computed once, when it is first chosen; ``clashes`` (labels, candidates) counts the clashes of each
    label's place with every candidate, and ``near`` marks those close to it.
    """

    def __init__(self, labels: Sequence[Label], around: Surroundings) -> None:
        self.labels = labels
        self.around = around
        self.options = [candidates_beside(label, NEAR_DISTANCES_MM) for label in labels]
        self.costs = self.around.candidate_costs(self.options)
        self.nearer_to_others = [self._mm_nearer_to_others(k) for k in range(len(labels))]
        for k, nearer in enumerate(self.nearer_to_others):
            self.costs[k] += AMBIGUITY_COST * (nearer > 0)
        self.chosen = dict[int, int]()
        self.wide = dict[int, int]()
        self._list_candidates()

    def _list_candidates(self) -> None:
        """Put the candidates of all labels into one list."""
        self.everywhere, self.static = Everywhere(join_candidates(self.options)), np.concatenate(self.costs)
        self.moves = 0
        ends = np.cumsum([0, *map(len, self.costs)]).tolist()
        self.rows = [slice(*two) for two in pairwise(ends)]
        self.clashes, self.near = (np.zeros((len(self.labels), ends[-1]), kind) for kind in (np.int16, np.bool_))
        self.effects: dict[tuple[int, int], Effect] = {}
        for k, option in self.chosen.items():
            self._put_label(k, option)

    def _mm_nearer_to_others(self, k: int) -> Array:
        """How much nearer the candidates of label k are to what another label names than to their own, mm."""
        own = self.labels[k]
        box = self.options[k].boxes
        others = [z for j, label in enumerate(self.labels) if j != k and label.at != own.at for z in sampled(label.at)]
        if not others:
            return np.zeros(len(box))
        away = box_point_distances(box, np.array(others)).min(axis=1)
        nearer: Array = distance_to_own_object(self.options[k], own.at, own.also) - away
        return nearer

    def choose_places(self) -> None:
        """Each label takes the cheapest remaining place, the important and the most crowded first."""
        free = [int((cost < OVERLAP_COST).sum()) for cost in self.costs]
        for k in sorted(range(len(self.labels)), key=lambda k: (-self.labels[k].priority, free[k], k)):
            self._put_label(k, int(np.argmin(self.candidate_costs(self.rows[k]))))

    def candidate_costs(self, rows: slice | Indices, but: int | None = None) -> Array:
        """The cost of candidates among the present places of the other labels, with at most one excepted."""
        clashes = self.clashes[:, rows]
        near = self.near[:, rows]
        if but is not None:
            clashes = np.delete(clashes, but, axis=0)
            near = np.delete(near, but, axis=0)
        costs: Array = self.static[rows] + OVERLAP_COST * clashes.sum(axis=0) + CLOSENESS_COST * near.any(axis=0)
        return costs

    def _put_label(self, k: int, option: int) -> None:
        """Put label k in a place."""
        if (k, option) not in self.effects:
            self.effects[k, option] = self.everywhere.effect_on_others(self.rows[k].start + option, self.rows[k])
        effect = self.effects[k, option]
        self.chosen[k] = option
        self.clashes[k] = 0
        self.near[k] = False
        self.clashes[k, effect.clashing] = effect.clashes
        self.near[k, effect.near] = True

    def chosen_indices(self) -> Indices:
        """The indices of all chosen places in the list of candidates."""
        return np.array([self.rows[k].start + self.chosen[k] for k in range(len(self.labels))])

    def overlapping_labels(self) -> list[int]:
        """The labels with an overlap."""
        return [int(k) for k in np.flatnonzero(self.candidate_costs(self.chosen_indices()) >= OVERLAP_COST)]

    def repair_overlaps(self) -> None:
        """Move overlapping labels to their cheapest places, or push the labels in the way aside."""
        for _ in range(_MOST_REPAIR_SWEEPS):
            before = dict(self.chosen)
            for k in self.overlapping_labels():
                if not self._move_to_cheapest(k):
                    self._push_others_aside(k)
            if self.chosen == before:
                return

    def _push_others_aside(self, k: int) -> None:
        """Give label k an occupied place, if every label there finds another."""
        if self.moves > MOST_MOVES:
            return
        kept = dict(self.chosen)
        free = np.argsort(self.costs[k], kind="stable")
        free = free[self.costs[k][free] < OVERLAP_COST]
        places = self.options[k].select_rows(free)
        struck = (self.clashes[:, self.rows[k].start + free] > 0).T
        first = np.where(struck.any(axis=1), struck.argmax(axis=1), -1).tolist()
        ways = dict[int, Booleans]()
        for at, (option, j) in enumerate(zip(free.tolist(), first, strict=True)):
            if self.moves > MOST_MOVES:
                return
            if j >= 0 and j not in ways:
                ways[j] = self._places_that_leave_room(j, k, places)
            if j >= 0 and not ways[j][at]:
                self.moves += 1
                continue
            self._put_label(k, option)
            if (
                all(map(self._move_to_cheapest, np.flatnonzero(struck[at]).tolist()))
                and self.candidate_costs(self.rows[k])[option] < OVERLAP_COST
            ):
                return
            for j, place in kept.items():
                if self.chosen[j] != place:
                    self._put_label(j, place)

    def _places_that_leave_room(self, j: int, k: int, places: Candidates) -> Booleans:
        """Which places of label k leave label j one without an overlap."""
        rows = np.flatnonzero(self.candidate_costs(self.rows[j], k) < OVERLAP_COST) + self.rows[j].start
        near = np.delete(self.near[:, rows], k, axis=0).any(axis=0)
        clashes, close = count_clashes(places, self.everywhere.every.select_rows(rows))
        leaves: Booleans = ((clashes == 0) & (self.static[rows] + CLOSENESS_COST * (close | near) < OVERLAP_COST)).any(
            axis=1
        )
        return leaves

    def _move_to_cheapest(self, k: int) -> bool:
        """Move label k to its cheapest place; returns whether it has no overlap there."""
        self.moves += 1
        costs = self.candidate_costs(self.rows[k])
        self._put_label(k, int(np.argmin(costs)))
        return bool(costs.min() < OVERLAP_COST)

    def offer_farther_places(self) -> bool:
        """Give overlapping labels places farther away, with leader lines; False if none is left to give."""
        late = [k for k in self.overlapping_labels() if self.wide.get(k, 0) < len(FAR_PLACE_COUNTS)]
        self._add_far_places(late)
        return bool(late)

    def lead_stray_labels(self) -> None:
        """Move labels that are by far nearer to what others name, where there is room, to places with leader lines."""
        beside = [k for k in self.chosen if k not in self.wide]
        stray = [k for k in beside if self.nearer_to_others[k][self.chosen[k]] > STRAY_DISTANCE_MM]
        for k in stray:
            self.costs[k] = self.costs[k] + STRAY_COST * (self.nearer_to_others[k] > STRAY_DISTANCE_MM)
        self._add_far_places(stray)
        for k in stray:
            self._move_to_cheapest(k)

    def _add_far_places(self, late: Sequence[int]) -> None:
        """Add the cheapest places farther away to those of some labels."""
        if not late:
            return
        far = [candidates_far_off(self.labels[k], FAR_DISTANCES_MM) for k in late]
        times = [self.wide.get(k, 0) for k in late]
        costs = self.around.costs_of_cheapest(far, [FAR_PLACE_COUNTS[n] for n in times])
        free = list[Indices]()
        for k, n, cost in zip(late, times, costs, strict=True):
            best = np.argsort(cost, kind="stable")[FAR_PLACE_COUNTS[n - 1] if n else 0 : FAR_PLACE_COUNTS[n]]
            free.append(best[cost[best] < OVERLAP_COST])
            self.wide[k] = n + 1
        farther = [option.select_rows(rows) for option, rows in zip(far, free, strict=True)]
        crossing = self.around.leader_costs(np.concatenate([some.leaders for some in farther]))
        crossings = np.split(crossing, np.cumsum(list(map(len, free)))[:-1])
        for k, some, cost, rows, more in zip(late, farther, costs, free, crossings, strict=True):
            self.options[k] = join_candidates([self.options[k], some])
            self.costs[k] = np.concatenate([self.costs[k], cost[rows] + more])
        self._list_candidates()

    def leave_out_repeated_labels(self) -> bool:
        """Leave out labels whose text is elsewhere too, to make room for others; False if none overlaps."""
        late = [k for k, label in enumerate(self.labels) if label.told] if self.overlapping_labels() else []
        if not late:
            return False
        for k in late:
            self.options[k] = join_candidates([self.options[k], left_out_candidate(self.labels[k])])
            self.costs[k] = np.append(self.costs[k], LEFT_OUT_COST)
        self._list_candidates()
        return True

    def placed_labels(self) -> Placed:
        """The labels in their chosen places."""
        return place_at_chosen(self.labels, self.everywhere.every.select_rows(self.chosen_indices()))
