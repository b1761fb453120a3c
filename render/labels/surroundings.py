"""What stands on a board already, and what places among it cost; all in mm of the sheet."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import compress

import numpy as np
import shapely

from planes.geometry.arrays import Array, Complexes, Indices
from render.labels.candidates import CLEAR_MM, Candidates, union
from render.labels.footprints import Bounds, InkedShapes

HARD = 200.0  # cost of one overlap, more than all that is merely disliked together
OUTSIDE = 1000.0  # cost of leaving the field
TIGHT = 1.5  # cost of standing closer than ROOM_MM to ink
CROSSING = 8.0  # cost of a leader's crossing with a stroke
THROUGH = 80.0  # cost of its going through a text
BROKEN = 4.0  # cost of a thin line that is broken for a label
ROOM_MM = 1.3
AHEAD = 2  # candidates looked at first, for each that is wanted
ENOUGH = 8  # crossings, or lines broken: more are hardly worse


@dataclass(frozen=True)
class Surroundings:
    """The ink that no label may touch, thin lines that yield to one, the texts that stand already, and the field."""

    ground: InkedShapes
    yielding: InkedShapes
    standing: InkedShapes
    field: Bounds | None = None

    def judged(self, options: Sequence[Candidates]) -> list[Array]:
        """What every candidate costs before the other labels are looked at."""
        every = union(options)
        cost = every.wish + self._on_ink(every.boxes)
        if self.field is not None:
            x0, y0, x1, y1 = self.field
            boxes = every.boxes
            inside = (boxes[:, 0] >= x0) & (boxes[:, 1] >= y0) & (boxes[:, 2] <= x1) & (boxes[:, 3] <= y1)
            cost += OUTSIDE * ~inside
        return np.split(cost, np.cumsum([len(option.wish) for option in options])[:-1])

    def cheapest(self, options: Sequence[Candidates], counts: Sequence[int]) -> list[Array]:
        """The same, but without end for candidates that are not among so many of the cheapest; those wished for least
        are looked at only where enough of the others are not as cheap as they are wished for."""
        orders = [np.argsort(option.wish, kind="stable") for option in options]
        firsts = [order[: AHEAD * count] for order, count in zip(orders, counts, strict=True)]
        costs = [np.full(len(option.wish), np.inf) for option in options]
        self._fill(costs, options, firsts)
        rests = [order[len(first) :] for order, first in zip(orders, firsts, strict=True)]
        each = zip(costs, options, rests, counts, strict=True)
        open_ = [len(r) > 0 and np.partition(c, n - 1)[n - 1] >= o.wish[r[0]] for c, o, r, n in each]
        self._fill(list(compress(costs, open_)), list(compress(options, open_)), list(compress(rests, open_)))
        return costs

    def _fill(self, costs: Sequence[Array], options: Sequence[Candidates], rows: Sequence[Indices]) -> None:
        """Judge some rows of candidates."""
        if rows:
            judged = self.judged([option.some(some) for option, some in zip(options, rows, strict=True)])
            for cost, some, found in zip(costs, rows, judged, strict=True):
                cost[some] = found

    def _on_ink(self, boxes: Array) -> Array:
        """Cost of the strokes that each box touches or nearly touches."""
        (roomless, struck), (broken,) = (
            self.ground.near(boxes, (ROOM_MM, CLEAR_MM)),
            self.yielding.near(boxes, (CLEAR_MM,)),
        )
        cost: Array = TIGHT * (roomless > 0) + HARD * struck + BROKEN * _bounded(broken)
        return cost

    def crossing(self, leaders: Complexes) -> Array:
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


def _bounded(counts: Array | Indices) -> Array:
    """Numbers of what is disliked: beyond some it hardly gets worse."""
    return np.minimum(counts, ENOUGH) + 0.02 * counts.astype(np.float64)
