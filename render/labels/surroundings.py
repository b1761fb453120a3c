"""The objects already on a board, and the costs of places among them; all in mm of the sheet."""

from collections.abc import Sequence

import numpy as np
import shapely

from planes.geometry.arrays import Array, Complexes, Indices
from planes.words.frozen import frozen
from render.labels.candidates import LEAST_INK_DISTANCE_MM, Candidates, join_candidates
from render.labels.footprints import Bounds, InkedShapes
from render.labels.nearness import Shapes
from render.paper.ink import xy_coordinates

OVERLAP_COST = 200.0  # cost of one overlap, more than all minor costs together
OUTSIDE_FIELD_COST = 1000.0  # cost of leaving the field
TIGHTNESS_COST = 1.5  # cost of being closer than ROOM_MM to ink
LEADER_CROSSING_COST = 8.0  # cost of a leader that crosses a stroke
LEADER_THROUGH_TEXT_COST = 80.0  # cost of one that crosses a text
LEADER_TEXT_GAP_MM = 0.3  # between a leader and placed texts
BROKEN_LINE_COST = 4.0  # cost of a thin line broken for a label
COMFORTABLE_GAP_MM = 1.3
CANDIDATES_PER_BATCH = 160  # candidates of a label examined together
MOST_COUNTED_DISADVANTAGES = 8  # crossings, or broken lines: more are hardly worse


@frozen
class Surroundings:
    """The ink that no label may touch, thin lines that yield to one, the texts already placed, and the field."""

    ground: InkedShapes
    yielding: InkedShapes
    standing: InkedShapes
    field: Bounds | None = None

    def candidate_costs(self, options: Sequence[Candidates]) -> list[Array]:
        """The cost of every candidate without regard to the other labels."""
        every = join_candidates(options)
        cost = every.wish + self._ink_costs(every.boxes)
        if self.field is not None:
            x0, y0, x1, y1 = self.field
            boxes = every.boxes
            inside = (boxes[:, 0] >= x0) & (boxes[:, 1] >= y0) & (boxes[:, 2] <= x1) & (boxes[:, 3] <= y1)
            cost += OUTSIDE_FIELD_COST * ~inside
        return np.split(cost, np.cumsum([len(option.wish) for option in options])[:-1])

    def costs_of_cheapest(self, options: Sequence[Candidates], counts: Sequence[int]) -> list[Array]:
        """The same, but infinite for candidates outside the cheapest ones; the least preferred are evaluated only if
        too few of the others cost less than their preference alone."""
        rests = [np.argsort(option.wish, kind="stable") for option in options]
        costs = [np.full(len(option.wish), np.inf) for option in options]
        ways = list(zip(costs, options, rests, counts, strict=True))
        while ways := [(c, o, r, n) for c, o, r, n in ways if len(r) and (c < o.wish[r[0]]).sum() < n]:
            judged = self.candidate_costs([o.select_rows(r[:CANDIDATES_PER_BATCH]) for _, o, r, _ in ways])
            for (cost, _, rest, _), judged_costs in zip(ways, judged, strict=True):
                cost[rest[:CANDIDATES_PER_BATCH]] = judged_costs
            ways = [(c, o, r[CANDIDATES_PER_BATCH:], n) for c, o, r, n in ways]
        return costs

    def _ink_costs(self, boxes: Array) -> Array:
        """Cost of the strokes that each box touches or nearly touches."""
        roomless, struck = self.ground.shape_edges.count_near_shapes(boxes, (COMFORTABLE_GAP_MM, LEAST_INK_DISTANCE_MM))
        (broken,) = self.yielding.shape_edges.count_near_shapes(boxes, (LEAST_INK_DISTANCE_MM,))
        return TIGHTNESS_COST * (roomless > 0) + OVERLAP_COST * struck + BROKEN_LINE_COST * _bounded_count(broken)

    def leader_costs(self, leaders: Complexes) -> Array:
        """The cost of leaders that cross strokes, thin ones that yield for less, and placed texts."""
        lines = shapely.linestrings(xy_coordinates(leaders))
        strokes = _count_crossings(lines, self.ground) + 0.25 * _count_crossings(lines, self.yielding)
        texts = _count_crossings(lines, self.standing, LEADER_TEXT_GAP_MM)
        return LEADER_CROSSING_COST * _bounded_count(strokes) + LEADER_THROUGH_TEXT_COST * texts


def _count_crossings(lines: Shapes, inked: InkedShapes, near: float = 0.0) -> Array:
    """The number of shapes that each line crosses, or comes ``near``, mm."""
    if not len(inked.shapes) or not len(lines):
        return np.zeros(len(lines))
    pairs = inked.spatial_index.query(lines, predicate="dwithin", distance=near)
    counts: Array = np.bincount(pairs[0], minlength=len(lines)).astype(float)
    return counts


def _bounded_count(counts: Array | Indices) -> Array:
    """Counts of disadvantages, with an upper bound beyond which they hardly matter."""
    return np.minimum(counts, MOST_COUNTED_DISADVANTAGES) + 0.02 * counts.astype(np.float64)
