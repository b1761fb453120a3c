"""The objects already on a board, and the costs of places among them; all in mm of the sheet."""

from collections.abc import Sequence

import numpy as np
import shapely

from planes.geometry.arrays import Array, Complexes, Indices
from planes.words.frozen import frozen
from render.labels.candidates import CLEAR_MM, Candidates, union
from render.labels.footprints import Bounds, InkedShapes
from render.paper.ink import coordinates

HARD = 200.0  # cost of one overlap, more than all minor costs together
OUTSIDE = 1000.0  # cost of leaving the field
TIGHT = 1.5  # cost of being closer than ROOM_MM to ink
CROSSING = 8.0  # cost of a leader that crosses a stroke
THROUGH = 80.0  # cost of one that crosses a text
BROKEN = 4.0  # cost of a thin line broken for a label
ROOM_MM = 1.3
TOGETHER = 160  # candidates of a label examined together
ENOUGH = 8  # crossings, or broken lines: more are hardly worse


@frozen
class Surroundings:
    """The ink that no label may touch, thin lines that yield to one, the texts already placed, and the field."""

    ground: InkedShapes
    yielding: InkedShapes
    standing: InkedShapes
    field: Bounds | None = None

    def judged(self, options: Sequence[Candidates]) -> list[Array]:
        """The cost of every candidate without regard to the other labels."""
        every = union(options)
        cost = every.wish + self._on_ink(every.boxes)
        if self.field is not None:
            x0, y0, x1, y1 = self.field
            boxes = every.boxes
            inside = (boxes[:, 0] >= x0) & (boxes[:, 1] >= y0) & (boxes[:, 2] <= x1) & (boxes[:, 3] <= y1)
            cost += OUTSIDE * ~inside
        return np.split(cost, np.cumsum([len(option.wish) for option in options])[:-1])

    def cheapest(self, options: Sequence[Candidates], counts: Sequence[int]) -> list[Array]:
        """The same, but infinite for candidates outside the cheapest ones; the least preferred are evaluated only if
        too few of the others cost less than their preference alone."""
        rests = [np.argsort(option.wish, kind="stable") for option in options]
        costs = [np.full(len(option.wish), np.inf) for option in options]
        ways = list(zip(costs, options, rests, counts, strict=True))
        while ways := [(c, o, r, n) for c, o, r, n in ways if len(r) and (c < o.wish[r[0]]).sum() < n]:
            judged = self.judged([o.some(r[:TOGETHER]) for _, o, r, _ in ways])
            for (cost, _, rest, _), judged_costs in zip(ways, judged, strict=True):
                cost[rest[:TOGETHER]] = judged_costs
            ways = [(c, o, r[TOGETHER:], n) for c, o, r, n in ways]
        return costs

    def _on_ink(self, boxes: Array) -> Array:
        """Cost of the strokes that each box touches or nearly touches."""
        (roomless, struck), (broken,) = (
            self.ground.edges.near(boxes, (ROOM_MM, CLEAR_MM)),
            self.yielding.edges.near(boxes, (CLEAR_MM,)),
        )
        return TIGHT * (roomless > 0) + HARD * struck + BROKEN * _bounded(broken)

    def crossing(self, leaders: Complexes) -> Array:
        """The cost of leaders that cross strokes, thin ones that yield for less, and placed texts."""
        strokes = self._crossings(leaders, (self.ground, 1.0), (self.yielding, 0.25))
        return CROSSING * _bounded(strokes) + THROUGH * self._crossings(leaders, (self.standing, 1.0))

    def _crossings(self, leaders: Complexes, *layers: tuple[InkedShapes, float]) -> Array:
        """The number of shapes each leader crosses, weighted."""
        lines = shapely.linestrings(coordinates(leaders))
        counts = np.zeros(len(leaders))
        for inked, weight in layers:
            if len(inked.shapes) and len(leaders):
                pairs = inked.tree.query(lines, predicate="intersects")
                counts += weight * np.bincount(pairs[0], minlength=len(leaders))
        return counts


def _bounded(counts: Array | Indices) -> Array:
    """Counts of disadvantages, with an upper bound beyond which they hardly matter."""
    return np.minimum(counts, ENOUGH) + 0.02 * counts.astype(np.float64)
