"""Results as tables for a terminal, in a language: of a mechanism, or of vectors alone."""

import math
from collections.abc import Iterable
from dataclasses import replace

from planes.plans.measuring import scene_lettering
from planes.plans.quantities import Measured
from planes.scene import Scene
from planes.solving import Position, Solved, drive_position_key
from planes.solving.own_equations import own_equation_rows
from planes.solving.text_tables import (
    aligned_table,
    error_cell,
    error_column_head,
    largest_equilibrium_result,
    magnitude_and_direction_cells,
    number_cell,
    plan_title_with_scale,
)
from planes.words import Lang, home_lang, put_decimal_signs, say
from planes.words.lettering import terminal_spelling
from planes.words.names import PlanId, label_of
from planes.words.naming import Naming
from planes.words.records import Json

Row = dict[str, Measured]


def solve_report_text(solved: Solved, lang: Lang = "en") -> str:
    """The whole answer of ``planes solve`` as text."""
    s = solved.plans.structure
    moves = solved.plans.has_mechanism
    naming = Naming(lang, **scene_lettering(solved.scene, solved.plans))
    lines = [solved.scene.title.get(lang, "")]
    if moves:
        lines.append(f"W = {s.W}, q = {s.q}, {s.formula_with_frame_number(naming.frame)}")
    for p in solved.positions:
        lines += position_table_lines(p, lang, naming) + own_equation_lines(p, solved.scene, lang)
    if some := next((p for p in solved.positions if "errors" in p.results), None):
        lines += ["", say("errors_pencil" if some.drawing.tool.doubt_mm > 0 else "errors_bound", lang)]
    return "\n".join(line for i, line in enumerate(lines) if line or i) + "\n"


def own_equation_lines(p: Position, scene: Scene, lang: Lang) -> list[str]:
    """The user's equations, each with its result, or whether it closes and what would close it."""
    rows = own_equation_rows(p, (scene.equations, scene.file), lang)
    return aligned_table(say("own_equations", lang), ["", ""], rows)


def text_of(p: Position) -> str:
    """The tables of one position, in the system language."""
    lang = home_lang()
    return "\n".join(position_table_lines(p, lang, replace(p.plans.default_naming, lang=lang))).strip("\n")


def position_table_lines(p: Position, lang: Lang, naming: Naming) -> list[str]:
    """The lines of one position."""
    r = p.results
    head = f"φ = {p.at:.10g}°" if drive_position_key(p.plans) == "phi_deg" else f"s = {p.at:.10g} {say('m', lang)}"
    lines = ["", f"— {head} —"] * p.plans.depends_on_drive
    if not p.plans.has_mechanism:
        return lines + stated_vector_tables(p, lang, naming)
    e = r.get("errors")
    lines += _points_table(p.rows("points"), lang, e) + _links_table(p.rows("links"), lang, e, p.plans.drive.link)
    lines += _slides_table(p, lang, e) + _derived_values_table(p, lang, naming, "transfers")
    for name, plan in r.get("plans", {}).items():
        if name != "position" and any(s["mm"] > 1e-9 for s in plan["segments"].values()):
            lines += _plan_table(p, name, lang, naming)
        elif name.is_force:
            lines += [
                "",
                say("polygon_empty", lang, plan=plan_title_with_scale(p, name, lang, naming).partition(", μ")[0]),
            ]
    forces = p.of("reactions")
    if not forces or any(any(f.numbers[:2]) or f.moment for f in forces.values()):
        lines += (
            _reactions_table(forces, lang, e, naming)
            + _derived_values_table(p, lang, naming, "loads", "friction", "edges", "bearings")
            + _balancing_load_lines(p, lang, naming)
        )
    return [put_decimal_signs(line, lang) for line in lines] + [f"! {w}" for w in r["warnings"]]


def _largest_magnitude(things: Iterable[Row], key: str) -> float:
    """The largest magnitude of ``key`` among results."""
    sizes = [t[key].numbers for t in things if key in t]
    return max((math.hypot(*(x for x in v if x is not None)) for v in sizes), default=0.0)


def _magnitude_and_direction(measured: Measured | None, beside: float = 0.0) -> tuple[str, str]:
    """Magnitude and direction in degrees of a vector."""
    if measured is None:
        return ("", "")
    return magnitude_and_direction_cells(measured.vector, beside)


def _points_table(points: dict[str, Row], lang: Lang, e: Json | None) -> list[str]:
    far, fast, quick = (_largest_magnitude(points.values(), key) for key in ("r", "v", "a"))
    rows = []
    for name, p in points.items():
        x, y = (number_cell(c, far) for c in p["r"].numbers) if "r" in p else ("", "")
        r, v, a = (error_cell(e, "points", name, letter) for letter in "rva")
        rows.append(
            [
                name,
                x,
                y,
                *r,
                *_magnitude_and_direction(p.get("v"), fast),
                *v,
                *_magnitude_and_direction(p.get("a"), quick),
                *a,
            ]
        )
    m = say("m", lang)
    o = error_column_head(e)
    rates = [f"v, {say('m/s', lang)}", "∠°", *o, f"a, {say('m/s²', lang)}", "∠°", *o]
    head = ["", f"x, {m}", f"y, {m}", *o, *rates]
    return aligned_table(say("points", lang), head, rows)


def _links_table(links: dict[str, Row], lang: Lang, e: Json | None, driver: str) -> list[str]:
    """The driver's rates are given, so they never count as zero."""
    keys = ("angle_deg", "omega", "epsilon")
    spin = _largest_magnitude(links.values(), "omega")
    beside = {
        "angle_deg": 180.0,
        "omega": spin,
        "epsilon": max(_largest_magnitude(links.values(), "epsilon"), spin * spin),
    }
    rows = []
    for n, v in links.items():
        most = dict.fromkeys(keys, 0.0) if n == driver else beside
        cells = ([number_cell(v[k].number, most[k]) if k in v else "", *error_cell(e, "links", n, k)] for k in keys)
        rows.append([n, *(c for cell in cells for c in cell)])
    head = [
        "",
        "φ, °",
        *error_column_head(e),
        f"ω, {say('rad/s', lang)}",
        *error_column_head(e),
        f"ε, {say('rad/s²', lang)}",
        *error_column_head(e),
    ]
    return aligned_table(say("links", lang), head, rows)


def _slides_table(p: Position, lang: Lang, e: Json | None) -> list[str]:
    slides = p.rows("slides")
    rows = []
    moving = (*slides.values(), *p.rows("points").values())
    fast = _largest_magnitude(moving, "v")
    quick = _largest_magnitude(moving, "a")
    for n, v in slides.items():
        numbers = []
        for k, most in (("v", fast), ("a", quick)):
            numbers += [number_cell(v[k].number, most) if k in v else "", *error_cell(e, "slides", n, k)]
        turn = [_magnitude_and_direction(v.get("coriolis"), quick)[0], *error_cell(e, "slides", n, "coriolis")]
        rows.append([n, p.plans.velocity_slides[n].guide, *numbers, *turn])
    rate = say("m/s²", lang)
    o = error_column_head(e)
    head = ["", say("guide", lang), f"v, {say('m/s', lang)}", *o, f"a, {rate}", *o, f"aᵏ, {rate}", *o]
    return aligned_table(say("slides", lang), head, rows)


def _plan_table(p: Position, name: PlanId, lang: Lang, naming: Naming) -> list[str]:
    plan = p.results["plans"][name]
    e = p.results.get("errors")
    most = max((abs(s["value"]) for s in plan["segments"].values()), default=0.0)
    rows = []
    for vector, ends, s in p.measured_on(name):
        key = ends.start + ends.end
        mm, value = (error_cell(e, "plans", name, "segments", key, what) for what in ("mm", "value"))
        shown = "".join(terminal_spelling(naming.lettered_name(x, name)) for x in (ends.start, ends.end))
        rows.append(
            [
                terminal_spelling(naming.lettered_vector(vector)),
                shown,
                f"{s['mm']:.2f}",
                *mm,
                number_cell(s["value"], most),
                *value,
            ]
        )
    unit = say(name.unit, lang)
    return aligned_table(
        plan_title_with_scale(p, name, lang, naming),
        ["", say("segment", lang), say("mm", lang), *error_column_head(e), unit, *error_column_head(e)],
        rows,
    )


def _reactions_table(reactions: dict[str, Measured], lang: Lang, e: Json | None, naming: Naming) -> list[str]:
    most = max((math.hypot(r.vector.real, r.vector.imag) for r in reactions.values()), default=0.0)
    rows = []
    o = error_column_head(e)
    for name, r in reactions.items():
        force = error_cell(e, "reactions", name, *(["force"] if r.slides else []))
        more = ["", *[""] * len(o)] * 2
        if r.slides:
            arm, moment = (error_cell(e, "reactions", name, key) for key in ("arm", "moment"))
            more = [number_cell(r.arm, 1.0), *arm, number_cell(r.moment, most), *moment]
        rows.append(
            [
                terminal_spelling(naming.lettered_vector(name)),
                *(number_cell(c, most) for c in r.numbers[:2]),
                *_magnitude_and_direction(r, most),
                *force,
                *more,
            ]
        )
    n = say("N", lang)
    reach = f"{say('arm', lang)}, {say('m', lang)}"
    couple = f"M, {say('N·m', lang)}"
    head = ["", f"x, {n}", f"y, {n}", f"|F|, {n}", "∠°", *o, reach, *o, couple, *o]
    return aligned_table(say("reactions", lang), head, rows)


def _derived_values_table(p: Position, lang: Lang, naming: Naming, *groups: str) -> list[str]:
    """Transfer functions; weights and inertia; normal forces, friction and its power: each with its ±."""
    lines = []
    for group in groups:
        rows = []
        e = p.results.get("errors")
        for key, f in p.of(group).items():
            c = f.quantity.columns[0]
            error = error_cell(e, group, key)
            name = terminal_spelling(naming.lettered_curve(key) if c.per else naming.lettered_vector(c.value))
            beside = max(abs(x.number) for x in p.of(group).values()) if c.per else 0.0
            rows.append([name, number_cell(f.number, beside), *error, "" if c.unit == "1" else say(c.unit, lang)])
        lines += aligned_table(say(f"of_{group}", lang), ["", say("value", lang), *error_column_head(e), ""], rows)
    return lines


def _balancing_load_lines(p: Position, lang: Lang, naming: Naming) -> list[str]:
    lines = []
    for what, unit in (("moment", "N·m"), ("force", "N")):
        moment = p.number(f"balancing_{what}")
        check = p.number(f"zhukovsky_{what}")
        own, other = (error_cell(p.results.get("errors"), f"{by}_{what}") for by in ("balancing", "zhukovsky"))
        if moment is not None:
            number = " ± ".join([number_cell(moment), *own])
            sense = (
                f" ({say('lesson_ccw' if moment > 0 else 'lesson_cw', lang)})" if what == "moment" and moment else ""
            )
            letter = terminal_spelling(naming.balancing_letter(what == "moment"))
            lines.append(f"{say(f'balancing_{what}', lang)} {letter}: {number} {say(unit, lang)}{sense}")
        if check is not None:
            lines.append(f"{say('by_lever', lang)}: {' ± '.join([number_cell(check), *other])} {say(unit, lang)}")
        if moment is not None and check is not None:
            lines.append(f"{say('difference', lang)}: {100 * relative_difference(moment, check):.2g} %")
    return ["", *lines] if lines else []


def relative_difference(value: float, check: float) -> float:
    """The relative difference of two values."""
    largest = max(abs(value), abs(check))
    return abs(value - check) / largest if largest else 0.0


def stated_vector_tables(p: Position, lang: Lang, naming: Naming) -> list[str]:
    """The vectors of a scene of vectors, plan by plan, and the values computed from them."""
    lines = []
    e = p.results.get("errors")
    vectors = p.of("vectors")
    for plan in p.plans.plan_names:
        own = [f for f in vectors.values() if f.quantity.columns[0].start.plan == plan]
        most = max((abs(f.vector) for f in own), default=0.0)
        rows = []
        for f in own:
            name = f.quantity.name
            ends = "".join(map(label_of, f.quantity.columns[0].needed_names))
            segments = p.results.get("plans", {}).get(plan, {}).get("segments", {})
            read = segments.get(ends, {"mm": 0.0, "value": 0.0})
            mm = error_cell(e, "plans", plan, "segments", ends, "mm")
            size = number_cell(read["value"], most)
            angle = magnitude_and_direction_cells(f.vector, most)[1]
            rows.append(
                [
                    terminal_spelling(naming.lettered_vector(name)),
                    size,
                    angle,
                    *error_cell(e, "vectors", name),
                    f"{read['mm']:.2f}",
                    *mm,
                ]
            )
        lines += aligned_table(
            plan_title_with_scale(p, plan, lang, naming),
            ["", say(plan.unit, lang), "∠°", *error_column_head(e), say("mm", lang), *error_column_head(e)],
            rows,
        )
    rows = []
    beside = largest_equilibrium_result(p)
    for f in p.of("values").values():
        error = error_cell(e, "values", f.quantity.name)
        rows.append(
            [
                terminal_spelling(naming.lettered_vector(f.quantity.name)),
                number_cell(f.number, beside),
                *error,
                say(f.unit, lang) if f.unit else "",
            ]
        )
    lines += aligned_table(say("values_found", lang), ["", say("value", lang), *error_column_head(e), ""], rows)
    return [put_decimal_signs(line, lang) for line in lines] + [f"! {w}" for w in p.results["warnings"]]
