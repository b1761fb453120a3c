"""The figures of a cycle as tables for a terminal, and as JSON."""

import math
from collections import defaultdict
from typing import Any

from planes.diagrams.extremes import Extreme
from planes.diagrams.summary import CurveSummary, DrivenStroke, Summary, summary_of_scene
from planes.plans.curves import CHAPTERS_BY_GROUP
from planes.scene import Scene
from planes.solving import drive_position_in_words
from planes.solving.text_tables import aligned_table
from planes.words import Lang, home_lang, put_decimal_signs, say
from planes.words.names import name_index
from planes.words.naming import Naming
from planes.words.records import Json, finite_or_none
from planes.words.units import UNITS_OF_PLACE_AND_RATES, significant_digits_text


def summary_report(s: Summary, lang: Lang) -> str:
    """Stroke, dead points, time ratio, then the extremes of every curve, group by group."""
    title = s.scene.title.get(lang, "")
    lines = [*_structure_lines(s), _drive_line(s, lang), *_assembly_range_lines(s, lang), *_turn_over_lines(s, lang)]
    lines += ["", *stroke_sentences(s, lang)]
    name = driver_coordinate_letter(s)
    head = ["", say("column_unit", lang)]
    for side in ("column_least", "column_greatest"):
        head += [say(side, lang), say("column_at", lang, name=name)]
    for group in CHAPTERS_BY_GROUP:
        rows = [_curve_row_cells(s, row, lang) for row in s.curve_summaries if row.group == group]
        lines += aligned_table(say(f"group_{group}", lang), head, rows)
    lines += [] if s.names else _path_table_lines(s, lang)
    return title + "\n" * bool(title) + put_decimal_signs("\n".join(lines), lang) + "\n"


def _structure_lines(s: Summary) -> list[str]:
    structure = s.plans.structure
    if not s.plans.has_mechanism:
        return []
    return [f"W = {structure.W}, q = {structure.q}, {structure.formula_with_frame_number(s.scene.frame_number)}"]


def driver_coordinate_letter(s: Summary) -> str:
    """The letter of the driver's coordinate: φ1, or s1."""
    return Naming().terminal_vector_name(s.plans.drive.motion_names[0])


def _drive_line(s: Summary, lang: Lang) -> str:
    drive = s.plans.drive
    first, last = (drive_position_in_words(float(x), drive.kind, lang) for x in (s.grid.places[0], s.grid.places[-1]))
    if not s.plans.has_mechanism:
        return f"{driver_coordinate_letter(s)} = {first}…{last}"
    rates = zip((drive.velocity, drive.acceleration), UNITS_OF_PLACE_AND_RATES[not drive.rotates][1:], strict=True)
    v, a = (f"{significant_digits_text(x)} {say(unit, lang)}" for x, unit in rates)
    velocity, acceleration = (Naming().terminal_vector_name(name) for name in drive.motion_names[1:])
    rates_said = {"velocity": velocity, "v": v, "acceleration": acceleration, "a": a}
    return say("cycle_range", lang, name=driver_coordinate_letter(s), first=first, last=last, **rates_said)


def _place_text(s: Summary, value: float, lang: Lang) -> str:
    kind = s.plans.drive.kind
    return drive_position_in_words(round(value, 4) + 0.0 if kind == "phi" else float(f"{value:.6g}"), kind, lang)


def _assembly_range_lines(s: Summary, lang: Lang) -> list[str]:
    if s.grid.assembled_mask.all():
        return []
    ranges = ", ".join(f"{_place_text(s, a, lang)}…{_place_text(s, b, lang)}" for a, b in s.grid.assembly_ranges)
    return [
        say(
            "cycle_assembles" if s.plans.has_mechanism else "cycle_drawn",
            lang,
            name=driver_coordinate_letter(s),
            ranges=ranges,
        )
    ]


def _turn_over_lines(s: Summary, lang: Lang) -> list[str]:
    """Where links turn over, grouped by position."""
    links_at = defaultdict(list)
    for name, place in s.grid.link_turn_overs:
        links_at[_place_text(s, place, lang)].append(name_index(name))
    name = driver_coordinate_letter(s)
    return [
        say("cycle_flips", lang, name=name, place=place, links=", ".join(links)) for place, links in links_at.items()
    ]


def stroke_sentences(s: Summary, lang: Lang) -> list[str]:
    """The driven link's stroke or swing, its extreme positions and the time ratio, in sentences."""
    stroke = s.driven_stroke
    if stroke is None:
        return []
    if stroke.rounds:
        return [say("stroke_rounds", lang, link=stroke.link)]
    dead = "; ".join(_dead_point_sentence(s, stroke, e, lang) for e in stroke.dead)
    if math.isinf(stroke.swing):
        return [say("stroke_unbounded", lang, link=stroke.link, dead=dead)]
    key = "stroke_slides" if stroke.slides else "stroke_turns"
    lines = [say(key, lang, link=stroke.link, swing=significant_digits_text(stroke.swing, 5), dead=dead)]
    if stroke.others:
        lines.append(say("stroke_more", lang, count=stroke.others))
    if stroke.time_ratio is not None and stroke.forth and stroke.back:
        forth, back = (significant_digits_text(x, 6) for x in (stroke.forth, stroke.back))
        lines.append(
            say("time_ratio", lang, ratio=significant_digits_text(stroke.time_ratio, 5), forth=forth, back=back)
        )
    return lines


def _dead_point_sentence(s: Summary, stroke: DrivenStroke, e: Extreme, lang: Lang) -> str:
    value = significant_digits_text(e.value, 5) + (f" {say('m', lang)}" if stroke.slides else "°")
    place = _place_text(s, e.place, lang)
    return say(
        f"stroke_{e.at or 'place'}",
        lang,
        name=driver_coordinate_letter(s),
        place=place,
        curve=stroke.curve,
        value=value,
    )


def _curve_row_cells(s: Summary, row: CurveSummary, lang: Lang) -> list[str]:
    cells = [", ".join(row.names), say(row.unit, lang)]
    if row.rounds:
        return [*cells, say("all_round", lang), "—", "—", "—"]
    if row.constant:
        return [*cells, significant_digits_text(row.least.value), "—", significant_digits_text(row.least.value), "—"]
    for e in (row.least, row.greatest):
        value = 0.0 if abs(e.value) < 1e-9 * row.size else e.value
        cells += [("→ " if math.isinf(value) else "") + significant_digits_text(value), _place_text(s, e.place, lang)]
    return cells


def _path_table_lines(s: Summary, lang: Lang) -> list[str]:
    rows = []
    for p in s.paths_of_points:
        size = max((abs(c) for c in (*p.x, *p.y) if math.isfinite(c)), default=0.0)
        box = (
            "…".join(significant_digits_text(0.0 if abs(c) < 1e-9 * size else c) for c in pair) for pair in (p.x, p.y)
        )
        rows.append([p.point, significant_digits_text(p.length), *box])
    m = say("m", lang)
    return aligned_table(say("paths", lang), ["", say("path_length", lang), f"x, {m}", f"y, {m}"], rows)


class Extremes(Json):
    """A cycle's figures, a dict from :func:`as_json`; printed, the tables of ``planes cycle``."""

    def __init__(self, scene: Scene) -> None:
        self.summary = summary_of_scene(scene)
        super().__init__(summary_json(self.summary))

    def __reduce__(self) -> Any:
        return Extremes, (self.summary.scene,)

    def __str__(self) -> str:
        return summary_report(self.summary, home_lang()).rstrip()

    def __repr__(self) -> str:
        return f"<Extremes of {len(self['curves'])} curves: {', '.join(self)}>"


def summary_json(s: Summary) -> Json:
    """The whole summary as plain data, with every extreme of every curve."""
    drive = s.plans.drive
    stroke = s.driven_stroke
    report: Json = {
        "planes": 1,
        "scene": s.scene.file,
        "variant": s.scene.variant,
        "drive": {"kind": drive.kind, "velocity": drive.velocity, "acceleration": drive.acceleration},
        "range": [float(s.grid.places[0]), float(s.grid.places[-1])],
        "assembles": [list(r) for r in s.grid.assembly_ranges],
    }
    if stroke:
        report["driven"] = {
            "link": stroke.link,
            "curve": stroke.curve,
            "rotates": stroke.rounds,
            "stroke": finite_or_none(stroke.swing),
            "extreme_positions": [_extreme_json(e) for e in stroke.dead],
            "forth_deg": stroke.forth,
            "back_deg": stroke.back,
            "time_ratio": stroke.time_ratio,
        }
    report["curves"] = {}
    for c in s.grid.turn.curves:
        report["curves"][c.name] = {
            "unit": c.unit,
            "group": c.group,
            "extremes": [_extreme_json(e) for e in s.extremes_by_curve[c.name]],
            **({"rotates": True} if s.grid.turns_fully(c) else {}),
        }
    report["paths"] = {
        p.point: {
            "length": finite_or_none(p.length),
            "x": [*map(finite_or_none, p.x)],
            "y": [*map(finite_or_none, p.y)],
        }
        for p in s.paths_of_points
    }
    return report


def _extreme_json(e: Extreme) -> Json:
    shown: Json = {"at": e.place, "value": finite_or_none(e.value), "kind": "greatest" if e.sense > 0 else "least"}
    return shown | ({"where": e.at} if e.at else {}) | ({"unbounded": True} if math.isinf(e.value) else {})
