"""The figures of a cycle as tables for a terminal, and as JSON."""

import math
from typing import Any

from planes.diagrams.extremes import Extreme
from planes.diagrams.summary import CurveSummary, DrivenStroke, Summary, of_cycle
from planes.scene import Scene
from planes.solving import told
from planes.solving.text_tables import table
from planes.words import Lang, decimals, home_lang, say
from planes.words.names import index_of
from planes.words.naming import Naming
from planes.words.records import Json, or_none
from planes.words.units import RATES, quantity

GROUPS = ("place", "analogue", "rate", "force")


def report(s: Summary, lang: Lang) -> str:
    """Stroke, dead points, time ratio, then the extremes of every curve, group by group."""
    title = s.scene.title.get(lang, "")
    lines = [*_structure(s), _drive(s, lang), *_assembles(s, lang), *_flips(s, lang)]
    lines += ["", *stroke_said(s, lang)]
    name = drive_name(s)
    head = ["", say("column_unit", lang)]
    for side in ("column_least", "column_greatest"):
        head += [say(side, lang), say("column_at", lang, name=name)]
    for group in GROUPS:
        rows = [_cells(s, row, lang) for row in s.rows if row.group == group]
        lines += table(say(f"group_{group}", lang), head, rows)
    lines += [] if s.names else _paths(s, lang)
    return title + "\n" * bool(title) + decimals("\n".join(lines), lang) + "\n"


def _structure(s: Summary) -> list[str]:
    structure = s.plans.structure
    if not s.plans.moves:
        return []
    return [f"W = {structure.W}, q = {structure.q}, {structure.formula_as(s.scene.frame_number)}"]


def drive_name(s: Summary) -> str:
    """The letter of the driver's coordinate: φ1, or s1."""
    return Naming().plain(s.plans.drive.letters[0])


def _drive(s: Summary, lang: Lang) -> str:
    drive = s.plans.drive
    first, last = (told(float(x), drive.kind, lang) for x in (s.grid.places[0], s.grid.places[-1]))
    if not s.plans.moves:
        return f"{drive_name(s)} = {first}…{last}"
    rates = zip((drive.velocity, drive.acceleration), RATES[not drive.rotates][1:], strict=True)
    v, a = (f"{quantity(x)} {say(unit, lang)}" for x, unit in rates)
    velocity, acceleration = (Naming().plain(name) for name in drive.letters[1:])
    rates_said = {"velocity": velocity, "v": v, "acceleration": acceleration, "a": a}
    return say("cycle_range", lang, name=drive_name(s), first=first, last=last, **rates_said)


def _place(s: Summary, value: float, lang: Lang) -> str:
    kind = s.plans.drive.kind
    return told(round(value, 4) + 0.0 if kind == "phi" else float(f"{value:.6g}"), kind, lang)


def _assembles(s: Summary, lang: Lang) -> list[str]:
    if s.grid.works.all():
        return []
    ranges = ", ".join(f"{_place(s, a, lang)}…{_place(s, b, lang)}" for a, b in s.grid.ranges)
    return [say("cycle_assembles" if s.plans.moves else "cycle_drawn", lang, name=drive_name(s), ranges=ranges)]


def _flips(s: Summary, lang: Lang) -> list[str]:
    """Where links turn over, grouped by position."""
    links_at: dict[str, list[str]] = {}
    for name, place in s.grid.flips:
        links_at.setdefault(_place(s, place, lang), []).append(index_of(name))
    name = drive_name(s)
    return [
        say("cycle_flips", lang, name=name, place=place, links=", ".join(links)) for place, links in links_at.items()
    ]


def stroke_said(s: Summary, lang: Lang) -> list[str]:
    """The driven link's stroke or swing, its extreme positions and the time ratio, in sentences."""
    stroke = s.stroke
    if stroke is None:
        return []
    if stroke.rounds:
        return [say("stroke_rounds", lang, link=stroke.link)]
    dead = "; ".join(_dead(s, stroke, e, lang) for e in stroke.dead)
    if math.isinf(stroke.swing):
        return [say("stroke_unbounded", lang, link=stroke.link, dead=dead)]
    key = "stroke_slides" if stroke.slides else "stroke_turns"
    lines = [say(key, lang, link=stroke.link, swing=quantity(stroke.swing, 5), dead=dead)]
    if stroke.others:
        lines.append(say("stroke_more", lang, count=stroke.others))
    if stroke.K is not None and stroke.forth and stroke.back:
        forth, back = (quantity(x, 6) for x in (stroke.forth, stroke.back))
        lines.append(say("time_ratio", lang, ratio=quantity(stroke.K, 5), forth=forth, back=back))
    return lines


def _dead(s: Summary, stroke: DrivenStroke, e: Extreme, lang: Lang) -> str:
    value = quantity(e.value, 5) + (f" {say('m', lang)}" if stroke.slides else "°")
    place = _place(s, e.place, lang)
    return say(f"stroke_{e.at or 'place'}", lang, name=drive_name(s), place=place, curve=stroke.curve, value=value)


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


class Extremes(Json):
    """A cycle's figures, a dict from :func:`as_json`; printed, the tables of ``planes cycle``."""

    def __init__(self, scene: Scene) -> None:
        self.summary = of_cycle(scene)
        super().__init__(as_json(self.summary))

    def __reduce__(self) -> Any:
        return Extremes, (self.summary.scene,)

    def __str__(self) -> str:
        return report(self.summary, home_lang()).rstrip()

    def __repr__(self) -> str:
        return f"<Extremes of {len(self['curves'])} curves: {', '.join(self)}>"


def as_json(s: Summary) -> Json:
    """The whole summary as plain data, with every extreme of every curve."""
    drive, stroke = s.plans.drive, s.stroke
    report: Json = {
        "planes": 1,
        "scene": s.scene.file,
        "variant": s.scene.variant,
        "drive": {"kind": drive.kind, "velocity": drive.velocity, "acceleration": drive.acceleration},
        "range": [float(s.grid.places[0]), float(s.grid.places[-1])],
        "assembles": [list(r) for r in s.grid.ranges],
    }
    if stroke:
        report["driven"] = {
            "link": stroke.link,
            "curve": stroke.curve,
            "rotates": stroke.rounds,
            "stroke": or_none(stroke.swing),
            "extreme_positions": [_extreme(e) for e in stroke.dead],
            "forth_deg": stroke.forth,
            "back_deg": stroke.back,
            "time_ratio": stroke.K,
        }
    report["curves"] = {}
    for c in s.grid.turn.curves:
        report["curves"][c.name] = {
            "unit": c.unit,
            "group": c.group,
            "extremes": [_extreme(e) for e in s.extremes[c.name]],
            **({"rotates": True} if s.grid.rounds(c) else {}),
        }
    report["paths"] = {
        p.point: {"length": or_none(p.length), "x": [*map(or_none, p.x)], "y": [*map(or_none, p.y)]} for p in s.paths
    }
    return report


def _extreme(e: Extreme) -> Json:
    shown: Json = {"at": e.place, "value": or_none(e.value), "kind": "greatest" if e.sense > 0 else "least"}
    return shown | ({"where": e.at} if e.at else {}) | ({"unbounded": True} if math.isinf(e.value) else {})
