"""Which results of one drawing rounding has eaten: what is warned of beside the numbers."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from planes.batch import Cycle
from planes.drafting.drawing import Drawing
from planes.plans import Plans
from planes.plans.quantities import Quantity, results_of


def doubts(
    plans: Plans, wanted: Iterable[Quantity] | None, drawing: Drawing, known: Mapping[str, float], small: Sequence[str]
) -> tuple[list[str], list[str]]:
    """Names of results of which less than three digits are certain, and of those of the ``small`` reactions of which
    none is."""
    asked = results_of(plans, wanted)
    cycle = Cycle(plans, known=known, columns=[c for q in asked for c in q.columns])
    table = np.array([[c.take(drawing.things, drawing.tool.ar)] for c in cycle.columns], float)
    bounds = cycle.claims.bounds([cycle.given[plans.drive_given]])
    doubtful, rough, none = iter(cycle.claims.doubtful(table, bounds)[:, 0].tolist()), [], []
    eaten = iter(((np.abs(table) <= bounds) & (bounds > 0))[:, 0].tolist())
    for q in asked:
        doubt, nothing = ([next(of) for _ in q.columns] for of in (doubtful, eaten))
        if q.of in small and all(nothing[:2]):
            none.append(q.of)
        elif any(doubt):
            rough.append(q.name)
    return rough, none
