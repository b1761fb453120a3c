"""Where on its turn the mechanism cannot be drawn, or only bluntly, and why, in words."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

from planes.drafting.drawing import Drawing, run
from planes.lesson import LANGS
from planes.plans import Plans
from planes.plans.measuring import BLUNT, say_plan
from planes.solving import failed
from planes.words import decimal, say
from planes.words.errors import PlanFailure
from planes.words.names import label_of, plan_of


def zones(plans: Plans, cycle: Drawing, values: list[float]) -> list[dict[str, Any]]:
    """Stretches of positions that fail ("bad") or where lines meet at under 15° ("blunt"), with the reason."""
    import numpy

    count = len(values)
    bad = cycle.failed()
    bad = numpy.zeros(count, bool) if bad is None else numpy.broadcast_to(bad, (count,))
    names = [n for n in cycle.sharpness if n not in cycle.program.trials and plan_of(n) != "motion"]
    rows = [numpy.broadcast_to(cycle.sharpness[n], (count,)) for n in names]
    table = numpy.nan_to_num(numpy.array(rows), nan=1.0) if rows else numpy.ones((1, count))
    worst = table.argmin(axis=0)
    least = table.min(axis=0)
    kinds = ["bad" if b else names[w] if s < BLUNT else "" for b, w, s in zip(bad, worst, least, strict=True)]
    found, start = [], 0
    for i in range(1, count + 1):
        if i == count or kinds[i] != kinds[start]:
            if kinds[start]:
                found.append(_zone(plans, start, i - 1, kinds[start], table))
            start = i
    return found


def _zone(plans: Plans, first: int, last: int, kind: str, table: Any) -> dict[str, Any]:
    if kind == "bad":
        said = {lang: say("lesson_zone_bad", lang) for lang in LANGS}
        return {"from": first, "to": last, "kind": "bad", "said": said}
    angle = math.degrees(math.asin(float(table[:, first : last + 1].min())))
    said = {
        lang: say(
            "lesson_zone_blunt",
            lang,
            mark=_mark(kind),
            plan=say_plan(plan_of(kind) or "position", lang),
            angle=decimal(f"{angle:.2g}", lang),
        )
        for lang in LANGS
    }
    return {"from": first, "to": last, "kind": "blunt", "said": said}


def _mark(name: str) -> str:
    return label_of(name).lstrip("°∥")


def reasons(
    plans: Plans,
    given: Mapping[str, Any],
    values: list[float],
    cycle: Drawing,
    progress: Callable[[int, int], None] | None = None,
) -> dict[str, Any]:
    """Why each failed position fails, in both languages."""
    import numpy

    bad = cycle.failed()
    indices = [] if bad is None else numpy.flatnonzero(numpy.broadcast_to(bad, (len(values),))).tolist()
    found = {}
    for k, index in enumerate(indices):
        if progress:
            progress(k + 1, len(indices))
        try:
            run(plans.program, {**given, plans.drive_given: values[index]})
        except PlanFailure as failure:
            kind = plans.mechanism.drive.kind
            found[str(index)] = {lang: failed(failure, values[index], kind).told(lang) for lang in LANGS}
    return found
