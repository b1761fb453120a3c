"""The figures of a cycle as a person reads them in a terminal, and as JSON."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from planes.diagrams.curves import Curve
from planes.diagrams.extremes import Extreme
from planes.diagrams.summary import CurveSummary, DrivenStroke, Summary
from planes.diagrams.turn import WholeTurn
from planes.drafting.drawing import run
from planes.plans.scales import unit_scales
from planes.solving import failed, key_of, told
from planes.solving.nearest import nearest
from planes.solving.tables import table
from planes.words import Lang, say
from planes.words.errors import PlanFailure
from planes.words.names import index_of
from planes.words.records import Json
from planes.words.units import RATES, quantity

GROUPS = ("place", "analogue", "rate", "force")
DECIMALS = 5  # of a listing


def report(s: Summary, lang: Lang) -> str:
    """Stroke, dead points, time ratio, then the extremes of every curve, group by group."""
    structure = s.plans.structure
    made = f"W = {structure.W}, q = {structure.q}, {structure.formula}"
    lines = [s.scene.title.get(lang, ""), made, _drive(s, lang), *_assembles(s, lang), *_flips(s, lang)]
    lines += ["", *_stroke(s, lang)]
    name = drive_name(s)
    head = ["", say("column_unit", lang)]
    for side in ("column_least", "column_greatest"):
        head += [say(side, lang), say("column_at", lang, name=name)]
    for group in GROUPS:
        rows = [_cells(s, row, lang) for row in s.rows if row.group == group]
        lines += table(say(f"group_{group}", lang), head, rows)
    lines += [] if s.names else _paths(s, lang)
    return "\n".join(line for k, line in enumerate(lines) if line or k) + "\n"


def drive_name(s: Summary) -> str:
    """The letter of the driver's place: φ1, or s1."""
    drive = s.plans.mechanism.drive
    return ("φ" if drive.kind == "phi" else "s") + drive.link


def _drive(s: Summary, lang: Lang) -> str:
    drive = s.plans.mechanism.drive
    v, a = ("ω", "ε") if drive.kind == "phi" else ("v", "a")
    units = RATES[drive.kind != "phi"][1:]
    shown = [f"{quantity(x)} {say(u, lang)}" for x, u in zip((drive.velocity, drive.acceleration), units, strict=True)]
    first, last = (told(float(x), drive.kind, lang) for x in (s.grid.places[0], s.grid.places[-1]))
    return say(
        "cycle_range",
        lang,
        name=drive_name(s),
        first=first,
        last=last,
        velocity=v + drive.link,
        v=shown[0],
        acceleration=a + drive.link,
        a=shown[1],
    )


def _place(s: Summary, value: float, lang: Lang) -> str:
    kind = s.plans.mechanism.drive.kind
    return told(round(value, 4) + 0.0 if kind == "phi" else float(f"{value:.6g}"), kind, lang)


def _assembles(s: Summary, lang: Lang) -> list[str]:
    if bool(s.grid.works.all()):
        return []
    ranges = ", ".join(f"{_place(s, a, lang)}…{_place(s, b, lang)}" for a, b in s.ranges)
    return [say("cycle_assembles", lang, name=drive_name(s), ranges=ranges)]


def _flips(s: Summary, lang: Lang) -> list[str]:
    """Where links turn over, those of one place together."""
    found: dict[str, list[str]] = {}
    for name, place in s.grid.flips:
        found.setdefault(_place(s, place, lang), []).append(index_of(name))
    return [
        say("cycle_flips", lang, name=drive_name(s), place=place, links=", ".join(links))
        for place, links in found.items()
    ]


def _stroke(s: Summary, lang: Lang) -> list[str]:
    stroke = s.stroke
    if stroke is None:
        return []
    if stroke.rounds:
        return [say("stroke_rounds", lang, link=stroke.link)]
    dead = "; ".join(_dead(s, stroke, e, lang) for e in stroke.dead)
    if math.isinf(stroke.swing):
        return [say("stroke_unbounded", lang, link=stroke.link, dead=dead)]
    key = "stroke_slides" if stroke.slides else "stroke_turns"
    lines = [say(key, lang, link=stroke.link, swing=quantity(stroke.swing, "", 5), dead=dead)]
    if stroke.others:
        lines.append(say("stroke_more", lang, count=stroke.others))
    if stroke.K is not None and stroke.forth and stroke.back:
        lines.append(
            say(
                "time_ratio",
                lang,
                ratio=quantity(stroke.K, "", 5),
                forth=quantity(stroke.forth, "", 6),
                back=quantity(stroke.back, "", 6),
            )
        )
    return lines


def _dead(s: Summary, stroke: DrivenStroke, e: Extreme, lang: Lang) -> str:
    unit = f" {say('m', lang)}" if stroke.slides else "°"
    key = {"": "stroke_place", "limit": "stroke_limit", "end": "stroke_end"}[e.at]
    return say(
        key,
        lang,
        name=drive_name(s),
        place=_place(s, e.place, lang),
        curve=stroke.curve,
        value=quantity(e.value, "", 5) + unit,
    )


def _cells(s: Summary, row: CurveSummary, lang: Lang) -> list[str]:
    cells = [", ".join(row.names), say(row.unit, lang)]
    if row.rounds:
        return [*cells, say("all_round", lang), "—", "—", "—"]
    if row.constant:
        return [*cells, quantity(row.least.value), "—", quantity(row.least.value), "—"]
    for e in (row.least, row.greatest):
        value = 0.0 if abs(e.value) < 1e-9 * row.size else e.value
        cells += [("→ " if math.isinf(value) else "") + quantity(value), _place(s, e.place, lang)]
    return cells


def _paths(s: Summary, lang: Lang) -> list[str]:
    rows = []
    for p in s.paths:
        size = max((abs(c) for c in (*p.x, *p.y) if math.isfinite(c)), default=0.0)
        box = ("…".join(quantity(0.0 if abs(c) < 1e-9 * size else c) for c in pair) for pair in (p.x, p.y))
        rows.append([p.point, quantity(p.length), *box])
    m = say("m", lang)
    return table(say("paths", lang), ["", say("path_length", lang), f"x, {m}", f"y, {m}"], rows)


def as_json(s: Summary) -> Json:
    """The whole summary as plain things; every extreme of every curve is there."""
    drive, stroke = s.plans.mechanism.drive, s.stroke
    found: Json = {
        "planes": 1,
        "scene": s.scene.file,
        "variant": s.scene.variant,
        "drive": {"kind": drive.kind, "velocity": drive.velocity, "acceleration": drive.acceleration},
        "range": [float(s.grid.places[0]), float(s.grid.places[-1])],
        "assembles": [list(r) for r in s.ranges],
    }
    if stroke:
        found["driven"] = {
            "link": stroke.link,
            "curve": stroke.curve,
            "rotates": stroke.rounds,
            "stroke": _or_none(stroke.swing),
            "extreme_positions": [_extreme(e) for e in stroke.dead],
            "forth_deg": stroke.forth,
            "back_deg": stroke.back,
            "time_ratio": stroke.K,
        }
    found["curves"] = {c.name: _curve(s, c) for c in s.grid.turn.curves}
    found["paths"] = {
        p.point: {"length": _or_none(p.length), "x": [*map(_or_none, p.x)], "y": [*map(_or_none, p.y)]} for p in s.paths
    }
    return found


def _or_none(value: float) -> float | None:
    """A number for a program: none where it grows without bound."""
    return value if math.isfinite(value) else None


def _curve(s: Summary, c: Curve) -> Json:
    """A curve's extremes; of a link that turns all the way round, that it does."""
    shown = {"unit": c.unit, "group": c.group, "extremes": [_extreme(e) for e in s.extremes[c.name]]}
    return shown | ({"rotates": True} if s.grid.rounds(c) else {})


def _extreme(e: Extreme) -> Json:
    unbounded = math.isinf(e.value)
    kind = "greatest" if e.sense > 0 else "least"
    shown: Json = {"at": e.place, "value": _or_none(e.value), "kind": kind}
    return shown | ({"where": e.at} if e.at else {}) | ({"unbounded": True} if unbounded else {})


# the listing of single positions


def listed(turn: WholeTurn, values: Any) -> dict[str, list[float]]:
    """Every curve at each value of the drive, by its name."""
    sample = turn.sample(values)
    return {c.name: [float(x) for x in c.read(sample) + np.zeros(len(values))] for c in turn.curves}


def listed_json(turn: WholeTurn, values: Any) -> Json:
    """The listing for a program: None where a curve has no value."""
    rows, key = listed(turn, values), key_of(turn.plans)
    positions = [
        {key: float(v), "values": {n: _or_none(row[k]) for n, row in rows.items()}} for k, v in enumerate(values)
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
