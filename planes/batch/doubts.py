"""Which results of one drawing rounding has eaten: what is warned of beside the numbers."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from planes.batch import Cycle
from planes.batch.columns import columns_of
from planes.drafting.drawing import Drawing
from planes.plans import Plans
from planes.plans.measuring import Quantity, catalogue


def doubts(
    plans: Plans, wanted: Iterable[Quantity] | None, drawing: Drawing, known: Mapping[str, float], small: Sequence[str]
) -> tuple[list[str], list[str]]:
    """Names of results of which less than three digits are certain, and of those of the ``small`` reactions of which
    none is."""
    asked = {q.path: q for q in (catalogue(plans).values() if wanted is None else wanted) if q.path[0] != "plans"}
    own = {q: columns_of(plans, [q]) for q in asked.values()}
    cycle = Cycle(plans, known=known, columns=[c for columns in own.values() for c in columns])
    table = np.array([[c.take(drawing.things, drawing.tool.ar)] for c in cycle.columns], float)
    bounds = cycle.claims.bounds([cycle.given[plans.drive_given]])
    doubtful, rough, none = iter(cycle.claims.doubtful(table, bounds)[:, 0].tolist()), [], []
    eaten = iter(((np.abs(table) <= bounds) & (bounds > 0))[:, 0].tolist())
    for q, columns in own.items():
        doubt, nothing = ([next(of) for _ in columns] for of in (doubtful, eaten))
        if q.path[-1] in small and all(nothing[:2]):
            none.append(q.path[-1])
        elif any(doubt):
            rough.append(q.name)
    return rough, none
