"""The ± of every result: the accuracy that a solved scene claims for its numbers, in the same shape as the results.

For an exact drawing it is a bound; for a pencil's the scatter: the covariance of its errors of mark, ray and ruler,
carried to first order.
"""

import math
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from planes.batch.cycle import Cycle
from planes.batch.error_bounds import Margins
from planes.batch.slopes import SLOPES, STIFF, Carrying, Values
from planes.batch.table import Ready
from planes.batch.tracing import trace
from planes.drafting.instruments import Instrument, Pencil
from planes.geometry.arrays import Array
from planes.plans import Plans
from planes.plans.columns import Column
from planes.plans.measuring import DrawingReader
from planes.plans.quantities import Measured, Quantity, asked, nested, told_of
from planes.solving import Position, Solved
from planes.words.names import mu_of
from planes.words.records import or_none


class Spread(Margins):
    """Standard deviations over draughtsmen with the same pencil, carried to every column by first-order slopes."""

    def __init__(self, cycle: Ready, pencil: Pencil, mus: Mapping[str, float]) -> None:
        errors = pencil.point_mm, math.radians(pencil.ray_deg), pencil.ruler_mm / math.sqrt(12.0)
        given, takes = {**cycle.given, **mus}, [c.take for c in cycle.columns]
        super().__init__(cycle, trace(cycle.program, given, takes, mus, errors))

    def margins(self, numbers: Values, count: int) -> Array:
        drawn = self.drawn
        sizes = {s.place: s.size for s in drawn.sources}
        out, squares = np.zeros((len(drawn.outputs), count)), np.empty((len(sizes), 1))
        carrying = Carrying(drawn.tape, self.order, count)
        for place, op, args in carrying.moving():
            if op == "source":
                squares[carrying.made] = sizes[place] ** 2
                carrying.carry(place, (), (), own=True)
            elif op not in STIFF:
                carrying.carry(place, args, SLOPES[op](numbers[place], *(numbers[a] for a in args)), own=False)
            if place in carrying.rows:
                rows = carrying.rows[place]
                for k in (k for k, p in enumerate(drawn.outputs) if p == place):
                    out[k] = np.sqrt(np.sum(rows * rows * squares[: len(rows)], axis=0))
        return out


_PARTS = ("x", "y", "size")


class Errors:
    """The ± of results of one mechanism: a bound for an exact drawing, one standard deviation for a pencil's."""

    def __init__(self, plans: Plans, wanted: Iterable[Quantity] | None, position: Position, by: Instrument | None):
        self.quantities = told_of(plans, wanted)
        reader = DrawingReader(plans, position.drawing, position.scales)
        self.segments = {f"{p}:{k}": s for p in plans.drawn for k, s in reader.plan_segments(p).items()}
        columns = {c.name: c for q in self.quantities for c in q.columns}
        columns |= {n: Column(n, "", "", *s.ends, "size") for n, s in self.segments.items()}
        self.cycle = Cycle(plans, known=position.scales, columns=columns.values())
        pencil = by if isinstance(by, Pencil) else None
        self.ruler_mm = pencil.ruler_mm / math.sqrt(12.0) if pencil else 0.0  # reading error of the ruler
        self.claims: Margins = Spread(self.cycle, pencil, {}) if pencil else self.cycle.rough

    def of(self, position: Position) -> dict[str, Any]:
        """The ± of a position's results, in the same nested shape (None: nothing can be claimed)."""
        self.cycle.given.update(position.scales)
        rows = self.claims.bounds([position.at])[:, 0]
        bounds = {c.name: float(x) for c, x in zip(self.cycle.columns, rows, strict=True)}
        out = nested(Measured(q, tuple(or_none(bounds[c.name]) for c in q.columns)) for q in self.quantities)
        if drawn := position.results.get("plans"):
            out["plans"] = {}
            for plan, measured in drawn.items():  # a ruler reading also has its rounding error
                mu, keys = position.scales[mu_of(plan)], measured["segments"]
                errors = {key: _measured(bounds[f"{plan}:{key}"], mu, self.ruler_mm) for key in keys}
                out["plans"][plan] = {"segments": errors}
        return out


def add_errors(solved: Solved, instrument: Instrument | None = None) -> None:
    """Add ``errors`` to the results of every position drawn by this instrument, and to ``error_mm``."""
    drawn = [p for p in solved.positions if "interpolated" not in p.results]
    if not drawn:
        return
    wanted = None if solved.wanted is None else [q.name for q in solved.wanted]
    ready: dict[int, Errors] = {}  # one for each choice of leads, where other leads meet
    for position in drawn:
        plans = position.plans
        if id(plans) not in ready:
            asked_of = None if wanted is None else asked(plans, wanted)
            ready[id(plans)] = Errors(plans, asked_of, position, instrument)
        errors = ready[id(plans)]
        position_errors = position.results["errors"] = errors.of(position)
        for plan, segments in position_errors.get("plans", {}).items():
            for key, error in segments["segments"].items():
                if error["mm"] is not None:
                    position.results["plans"][plan]["segments"][key]["error_mm"] = error["mm"]


def _measured(bound: float, mu: float, ruler_mm: float) -> dict[str, float | None]:
    """± of a segment, in mm and in its unit."""
    mm = math.hypot(bound * mu, ruler_mm)
    return {"mm": or_none(mm), "value": or_none(mm / mu)}
