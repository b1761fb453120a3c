"""The listing of single positions of a cycle: every curve at each, as text and as JSON."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from planes.diagrams.curves import Curve
from planes.diagrams.turn import WholeTurn
from planes.drafting.drawing import run
from planes.plans.scales import unit_scales
from planes.solving import failed, key_of, told
from planes.solving.nearest import nearest
from planes.solving.tables import table
from planes.words import Lang, say
from planes.words.errors import PlanFailure
from planes.words.records import Json

DECIMALS = 5


def or_none(value: float) -> float | None:
    """A number for a program: none where it grows without bound."""
    return value if math.isfinite(value) else None


def listed(turn: WholeTurn, values: Any) -> dict[str, list[float]]:
    """Every curve at each value of the drive, by its name."""
    sample = turn.sample(values)
    return {c.name: [float(x) for x in c.read(sample) + np.zeros(len(values))] for c in turn.curves}


def listed_json(turn: WholeTurn, values: Any) -> Json:
    """The listing for a program: None where a curve has no value."""
    rows, key = listed(turn, values), key_of(turn.plans)
    positions = [
        {key: float(v), "values": {n: or_none(row[k]) for n, row in rows.items()}} for k, v in enumerate(values)
    ]
    return {"planes": 1, "units": {c.name: c.unit for c in turn.curves}, "positions": positions}


def unsolved(turn: WholeTurn, values: Any, lang: Lang) -> list[str]:
    """Why positions cannot be drawn, a sentence for each that cannot."""
    plans, found = turn.plans, []
    given = {**plans.given, **dict.fromkeys(unit_scales(plans), 1000.0)}
    for value in map(float, values):
        try:
            run(plans.program, {**given, plans.drive_given: value})
        except PlanFailure as failure:
            found.append(failed(failure, value, plans.mechanism.drive.kind, nearest(plans, value)).told(lang))
    return found


def listing(turn: WholeTurn, values: Any, lang: Lang) -> str:
    """Every curve in each position, in the order of the analytic method, with five decimals."""
    told_rows, kind = listed(turn, values), turn.plans.mechanism.drive.kind
    lines: list[str] = []
    for key, curves in _chapters(turn.curves):
        rows = [[c.name, say(c.unit, lang), *map(decimals, told_rows[c.name])] for c in curves]
        head = ["", say("column_unit", lang), *(told(float(v), kind, lang) for v in values)]
        lines += table(say(key, lang), head, rows)
    return "\n".join(lines[1:]) + "\n"


def _chapters(curves: tuple[Curve, ...]) -> list[tuple[str, list[Curve]]]:
    def chapter(c: Curve) -> str:
        if c.group not in ("analogue", "rate"):
            return f"group_{c.group}"
        return f"group_{c.group}_" + ("a" if c.name.startswith(("a", "epsilon", "coriolis")) else "v")

    keys = ("place", "analogue_v", "analogue_a", "rate_v", "rate_a", "force")
    return [(f"group_{k}", [c for c in curves if chapter(c) == f"group_{k}"]) for k in keys]


def decimals(value: float) -> str:
    """A number with five decimals, the zeros at its end left out, as a calculating sheet prints it."""
    if not math.isfinite(value):
        return "—"
    text = f"{value:.{DECIMALS}f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text
