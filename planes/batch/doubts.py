"""Which results of one drawing rounding has eaten: what is warned of beside the numbers."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import numpy as np

from planes.batch import Cycle
from planes.drafting.drawing import Drawing
from planes.plans import Plans
from planes.plans.quantities import Quantity, results_of


def doubts(
    plans: Plans, wanted: Iterable[Quantity] | None, drawing: Drawing, known: Mapping[str, float]
) -> tuple[list[str], list[str]]:
    """Names of results of which less than three digits are certain, and of forces of which none is."""
    asked = results_of(plans, wanted)
    cycle = Cycle(plans, known=known, columns=[c for q in asked for c in q.columns])
    table = np.array([[c.take(drawing.things, drawing.tool.ar)] for c in cycle.columns], float)
    bounds = cycle.claims.bounds([cycle.given[plans.drive_given]])
    doubtful, faint = (iter(of(table, bounds)[:, 0].tolist()) for of in (cycle.claims.doubtful, cycle.claims.faint))
    told = [(q, [[next(of) for _ in q.columns] for of in (doubtful, faint)]) for q in asked]
    none = [q.of for q, (_, nothing) in told if any(nothing)]
    return [q.name for q, (rough, nothing) in told if any(rough) and not any(nothing)], none
