"""The ± of every result: the accuracy that a solved scene claims for its numbers, in the same shape as the results.

For an exact drawing it is a bound; for a pencil's the scatter: the covariance of its errors of mark, ray and ruler,
carried to first order.
"""

import math
from collections.abc import Iterable
from typing import Any

import numpy as np

from planes.batch.cycle import Cycle
from planes.batch.error_bounds import Margins
from planes.batch.slopes import SLOPE_FUNCTIONS, UNMOVED_OPERATIONS, Carrying, Values
from planes.batch.table import Ready
from planes.batch.tracing import trace_program
from planes.drafting.instruments import Instrument, Pencil
from planes.geometry.arrays import Array
from planes.plans import Plans
from planes.plans.columns import Column
from planes.plans.measuring import DrawingReader
from planes.plans.quantities import Measured, Quantity, nested_json, quantities_asked_for, results_with_intermediates
from planes.solving import Position, Solved
from planes.words.names import NumbersByName
from planes.words.records import finite_or_none


class Spread(Margins):
    """Standard deviations over draughtsmen with the same pencil, carried to every column by first-order slopes."""

    def __init__(self, cycle: Ready, pencil: Pencil, mus: NumbersByName) -> None:
        errors = pencil.point_mm, math.radians(pencil.ray_deg), pencil.ruler_mm / math.sqrt(12.0)
        given = {**cycle.given, **mus}
        takes = [c.read_from_drawing for c in cycle.columns]
        super().__init__(cycle, trace_program(cycle.program, given, takes, mus, errors))

    def piece_error_bounds(self, numbers: Values, count: int) -> Array:
        drawn = self.drawn
        sizes = {s.place: s.size for s in drawn.sources}
        out = np.zeros((len(drawn.outputs), count))
        squares = np.empty((len(sizes), 1))
        carrying = Carrying(drawn.tape, self.order, count)
        for place, op, args in carrying.moving_operations():
            if op == "source":
                squares[carrying.made] = sizes[place] ** 2
                carrying.carry_errors_to(place, (), (), own=True)
            elif op not in UNMOVED_OPERATIONS:
                carrying.carry_errors_to(
                    place, args, SLOPE_FUNCTIONS[op](numbers[place], *(numbers[a] for a in args)), own=False
                )
            if place in carrying.rows:
                rows = carrying.rows[place]
                for k in (k for k, p in enumerate(drawn.outputs) if p == place):
                    out[k] = np.sqrt(np.sum(rows * rows * squares[: len(rows)], axis=0))
        return out


class Errors:
    """The ± of results of one mechanism: a bound for an exact drawing, one standard deviation for a pencil's."""

    def __init__(self, plans: Plans, wanted: Iterable[Quantity] | None, position: Position, by: Instrument | None):
        self.quantities = results_with_intermediates(plans, wanted)
        reader = DrawingReader(plans, position.drawing, position.scales)
        self.segments = {p.mark(k): s for p in plans.plan_names for k, s in reader.measured_segments_of_plan(p).items()}
        columns = {c.name: c for q in self.quantities for c in q.columns}
        columns |= {n: Column(n, "", "", *s.ends, part="size") for n, s in self.segments.items()}
        self.cycle = Cycle(plans, known=position.scales, columns=columns.values())
        pencil = by if isinstance(by, Pencil) else None
        self.ruler_mm = pencil.ruler_mm / math.sqrt(12.0) if pencil else 0.0  # reading error of the ruler
        self.claims: Margins = Spread(self.cycle, pencil, {}) if pencil else self.cycle.decimal_error_claims

    def errors_of_position(self, position: Position) -> dict[str, Any]:
        """The ± of a position's results, in the same nested shape (None: nothing can be claimed)."""
        self.cycle.given.update(position.scales)
        rows = self.claims.error_bounds_of_columns([position.at])[:, 0]
        bounds = {c.name: float(x) for c, x in zip(self.cycle.columns, rows, strict=True)}
        out = nested_json(
            Measured(q, tuple(finite_or_none(bounds[c.name]) for c in q.columns)) for q in self.quantities
        )
        if drawn := position.results.get("plans"):
            out["plans"] = {}
            for plan, measured in drawn.items():  # a ruler reading also has its rounding error
                mu = position.scales[plan.mu_name]
                keys = measured["segments"]
                errors = {key: _measured_segment_errors(bounds[plan.mark(key)], mu, self.ruler_mm) for key in keys}
                out["plans"][plan] = {"segments": errors}
        return out


def add_errors_to_results(solved: Solved, instrument: Instrument | None = None) -> None:
    """Add ``errors`` to the results of every position drawn by this instrument, and to ``error_mm``."""
    drawn = [p for p in solved.positions if "interpolated" not in p.results]
    if not drawn:
        return
    wanted = None if solved.wanted is None else [q.name for q in solved.wanted]
    ready = {}  # one for each choice of leads, where other leads meet
    for position in drawn:
        plans = position.plans
        if id(plans) not in ready:
            asked_of = None if wanted is None else quantities_asked_for(plans, wanted)
            ready[id(plans)] = Errors(plans, asked_of, position, instrument)
        errors = ready[id(plans)]
        position_errors = position.results["errors"] = errors.errors_of_position(position)
        for plan, segments in position_errors.get("plans", {}).items():
            for key, error in segments["segments"].items():
                if error["mm"] is not None:
                    position.results["plans"][plan]["segments"][key]["error_mm"] = error["mm"]


def _measured_segment_errors(bound: float, mu: float, ruler_mm: float) -> dict[str, float | None]:
    """± of a segment, in mm and in its unit."""
    mm = math.hypot(bound * mu, ruler_mm)
    return {"mm": finite_or_none(mm), "value": finite_or_none(mm / mu)}
