"""Where on its turn the mechanism cannot be drawn, or only bluntly, and why, in words."""

import math
from collections.abc import Callable
from functools import partial
from itertools import groupby

import numpy

from planes.drafting.drawing import Drawing, run
from planes.geometry.arrays import Array, Booleans
from planes.lesson import in_both
from planes.plans import Plans
from planes.plans.measuring import BLUNT, say_plan
from planes.solving import failed
from planes.words import Lang, decimal, say
from planes.words.errors import PlanFailure
from planes.words.names import lettered, plan_of
from planes.words.records import Json


def zones(plans: Plans, cycle: Drawing, count: int) -> list[Json]:
    """Stretches of positions that fail ("bad") or where lines meet at under 15° ("blunt"), with the reason."""
    names = [n for n in cycle.sharpness if n not in cycle.program.trials and plan_of(n) != "motion"]
    rows = [numpy.broadcast_to(cycle.sharpness[n], (count,)) for n in names]
    table: Array = numpy.nan_to_num(numpy.array(rows), nan=1.0) if rows else numpy.ones((1, count))
    least, worst = table.min(axis=0), table.argmin(axis=0)
    bad = _bad(cycle, count)
    marks = ["" if b else names[w] if s < BLUNT else None for b, w, s in zip(bad, worst, least, strict=True)]
    found, start = [], 0
    for mark, same in groupby(marks):
        first, start = start, start + len(list(same))
        if mark == "":
            found.append(zone(first, start - 1, "bad", partial(say, "lesson_zone_bad")))
        elif mark:
            found.append(zone(first, start - 1, "blunt", partial(_blunt, mark, least[first:start].min())))
    return found


def zone(first: int, last: int, kind: str, told: Callable[[Lang], str]) -> Json:
    """A stretch of positions, and what is said of it."""
    return {"from": first, "to": last, "kind": kind, "said": in_both(told)}


def _blunt(mark: str, least: float, lang: Lang) -> str:
    named = {"mark": lettered(mark), "plan": say_plan(plan_of(mark) or "position", lang)}
    return say("lesson_zone_blunt", lang, **named, angle=decimal(f"{math.degrees(math.asin(least)):.2g}", lang))


def _bad(cycle: Drawing, count: int) -> Booleans:
    """Which of the positions cannot be drawn."""
    bad = cycle.failed()
    return numpy.broadcast_to(False if bad is None else bad, (count,))


def reasons(
    plans: Plans, given: Json, values: list[float], cycle: Drawing, progress: Callable[[int, int], None] | None = None
) -> dict[str, dict[Lang, str]]:
    """Why each failed position fails, in both languages."""
    indices = numpy.flatnonzero(_bad(cycle, len(values))).tolist()
    found = {}
    for k, index in enumerate(indices):
        if progress:
            progress(k + 1, len(indices))
        try:
            run(plans.program, {**given, plans.drive_given: values[index]})
        except PlanFailure as failure:
            found[str(index)] = in_both(failed(failure, values[index], plans.mechanism.drive.kind).told)
    return found
