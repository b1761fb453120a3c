"""How far a pencil's results scatter: the covariance of its slips of mark, ray and ruler, carried to first order."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np

from planes.batch.columns import Ready
from planes.batch.slopes import SLOPES, STIFF, Carrying
from planes.batch.tape import read
from planes.batch.tracing import Trace, given_values, trace
from planes.drafting.instruments import Pencil
from planes.geometry.arrays import Array, Floats

PIECE = 64  # positions carried at once


class Spread:
    """Standard deviations over draughtsmen with the same pencil, carried to every column by first-order slopes."""

    def __init__(self, cycle: Ready, pencil: Pencil, mus: Mapping[str, float]) -> None:
        errors = pencil.point_mm, math.radians(pencil.ray_deg), pencil.ruler_mm / math.sqrt(12.0)
        self.cycle, given = cycle, {**cycle.given, **mus}
        self.drawn = trace(cycle.program, given, [c.take for c in cycle.columns], mus, errors)

    def bounds(self, values: Sequence[float] | Array) -> Array:
        """A row for each column, of one standard deviation."""
        pieces = []
        for start in range(0, len(values), PIECE):
            part = np.asarray(values[start : start + PIECE], float)
            given = {**given_values(self.cycle.given), **self.cycle.moving(part, slice(start, start + len(part)))}
            pieces.append(_spread(self.drawn, given, len(part)))
        return np.hstack(pieces) if pieces else np.empty((len(self.cycle.columns), 0))


def _spread(drawn: Trace, given: Mapping[str, Floats], count: int) -> Array:
    order = drawn.tape.needed(list(drawn.outputs))
    found = read(drawn.tape, order, given)
    sizes = {s.place: s.size for s in drawn.sources}
    out, squares = np.zeros((len(drawn.outputs), count)), np.empty((len(sizes), 1))
    carrying = Carrying(drawn.tape, order, count)
    with np.errstate(all="ignore"):
        for place, op, args in carrying.moving():
            if op == "source":
                squares[carrying.made] = sizes[place] ** 2
                carrying.carry(place, (), (), own=True)
            elif op not in STIFF:
                carrying.carry(place, args, SLOPES[op](found[place], *(found[a] for a in args)), own=False)
            if place in carrying.rows:
                rows = carrying.rows[place]
                for k in (k for k, p in enumerate(drawn.outputs) if p == place):
                    out[k] = np.sqrt(np.sum(rows * rows * squares[: len(rows)], axis=0))
    return out
