"""Results as tables for a terminal, in a language: of a mechanism, or of vectors alone."""

import math
from collections.abc import Iterable
from dataclasses import replace

from planes.plans.measuring import lettering
from planes.plans.quantities import Measured
from planes.scene import Scene
from planes.solving import Position, Solved, key_of
from planes.solving.own_equations import own_rows
from planes.solving.text_tables import directed, error_of, largest, number_cell, pm, table, titled
from planes.words import Lang, decimals, home_lang, say
from planes.words.lettering import spelt
from planes.words.names import kind_of, label_of, plan_of
from planes.words.naming import Naming
from planes.words.records import Json
from planes.words.units import UNIT

Row = dict[str, Measured]


def report(solved: Solved, lang: Lang = "en") -> str:
    """The whole answer of ``planes solve`` as text."""
    s, moves = solved.plans.structure, solved.plans.moves
    naming = Naming(lang, **lettering(solved.scene, solved.plans))
    lines = [solved.scene.title.get(lang, "")]
    lines += [f"W = {s.W}, q = {s.q}, {s.formula_as(naming.frame)}"] if moves else []
    for p in solved.positions:
        lines += of_position(p, lang, naming) + own_lines(p, solved.scene, lang)
    if some := next((p for p in solved.positions if "errors" in p.results), None):
        lines += ["", say("errors_pencil" if some.drawing.tool.doubt_mm > 0 else "errors_bound", lang)]
    return "\n".join(line for i, line in enumerate(lines) if line or i) + "\n"


def own_lines(p: Position, scene: Scene, lang: Lang) -> list[str]:
    """The user's equations, each with its result, or whether it closes and what would close it."""
    rows = own_rows(p, (scene.equations, scene.file), lang)
    return table(say("own_equations", lang), ["", ""], rows)


def text_of(p: Position) -> str:
    """The tables of one position, in the system language."""
    lang = home_lang()
    return "\n".join(of_position(p, lang, replace(p.plans.naming, lang=lang))).strip("\n")


def of_position(p: Position, lang: Lang, naming: Naming) -> list[str]:
    """The lines of one position."""
    r = p.results
    head = f"φ = {p.at:.10g}°" if key_of(p.plans) == "phi_deg" else f"s = {p.at:.10g} {say('m', lang)}"
    lines = ["", f"— {head} —"] * p.plans.turns
    if not p.plans.moves:
        return lines + stated_tables(p, lang, naming)
    e = r.get("errors")
    lines += _points(p.rows("points"), lang, e) + _links(p.rows("links"), lang, e, p.plans.drive.link)
    lines += _slides(p, lang, e) + _derived(p, lang, naming, "transfers")
    for name, plan in r.get("plans", {}).items():
        if name != "position" and any(s["mm"] > 1e-9 for s in plan["segments"].values()):
            lines += _plan(p, name, lang, naming)
        elif kind_of(name) == "force":
            lines += ["", say("polygon_empty", lang, plan=titled(p, name, lang, naming).partition(", μ")[0])]
    forces = p.of("reactions")
    if not forces or any(any(f.numbers[:2]) or f.moment for f in forces.values()):
        lines += (
            _reactions(forces, lang, e, naming)
            + _derived(p, lang, naming, "loads", "friction", "edges", "bearings")
            + _balance(p, lang, naming)
        )
    return [decimals(line, lang) for line in lines] + [f"! {w}" for w in r["warnings"]]


def _largest(things: Iterable[Row], key: str) -> float:
    """The largest magnitude of ``key`` among results."""
    sizes = [t[key].numbers for t in things if key in t]
    return max((math.hypot(*(x for x in v if x is not None)) for v in sizes), default=0.0)


def _vector(measured: Measured | None, beside: float = 0.0) -> tuple[str, str]:
    """Magnitude and direction in degrees of a vector."""
    return ("", "") if measured is None else directed(measured.vector, beside)


def _points(points: dict[str, Row], lang: Lang, e: Json | None) -> list[str]:
    far, fast, quick = (_largest(points.values(), key) for key in ("r", "v", "a"))
    rows = []
    for name, p in points.items():
        x, y = (number_cell(c, far) for c in p["r"].numbers) if "r" in p else ("", "")
        r, v, a = (error_of(e, "points", name, letter) for letter in "rva")
        rows.append([name, x, y, *r, *_vector(p.get("v"), fast), *v, *_vector(p.get("a"), quick), *a])
    m, o = say("m", lang), pm(e)
    rates = [f"v, {say('m/s', lang)}", "∠°", *o, f"a, {say('m/s²', lang)}", "∠°", *o]
    head = ["", f"x, {m}", f"y, {m}", *o, *rates]
    return table(say("points", lang), head, rows)


def _links(links: dict[str, Row], lang: Lang, e: Json | None, driver: str) -> list[str]:
    """The driver's rates are given, so they never count as zero."""
    keys = ("angle_deg", "omega", "epsilon")
    spin = _largest(links.values(), "omega")
    beside = {"angle_deg": 180.0, "omega": spin, "epsilon": max(_largest(links.values(), "epsilon"), spin * spin)}
    rows = []
    for n, v in links.items():
        most = dict.fromkeys(keys, 0.0) if n == driver else beside
        cells = ([number_cell(v[k].number, most[k]) if k in v else "", *error_of(e, "links", n, k)] for k in keys)
        rows.append([n, *(c for cell in cells for c in cell)])
    head = ["", "φ, °", *pm(e), f"ω, {say('rad/s', lang)}", *pm(e), f"ε, {say('rad/s²', lang)}", *pm(e)]
    return table(say("links", lang), head, rows)


def _slides(p: Position, lang: Lang, e: Json | None) -> list[str]:
    slides, rows = p.rows("slides"), []
    moving = (*slides.values(), *p.rows("points").values())
    fast, quick = _largest(moving, "v"), _largest(moving, "a")
    for n, v in slides.items():
        numbers: list[str] = []
        for k, most in (("v", fast), ("a", quick)):
            numbers += [number_cell(v[k].number, most) if k in v else "", *error_of(e, "slides", n, k)]
        turn = [_vector(v.get("coriolis"), quick)[0], *error_of(e, "slides", n, "coriolis")]
        rows.append([n, p.plans.velocity_slides[n].guide, *numbers, *turn])
    rate, o = say("m/s²", lang), pm(e)
    head = ["", say("guide", lang), f"v, {say('m/s', lang)}", *o, f"a, {rate}", *o, f"aᵏ, {rate}", *o]
    return table(say("slides", lang), head, rows)


def _plan(p: Position, name: str, lang: Lang, naming: Naming) -> list[str]:
    plan, e = p.results["plans"][name], p.results.get("errors")
    most = max((abs(s["value"]) for s in plan["segments"].values()), default=0.0)
    rows = []
    for vector, ends, s in p.measured_on(name):
        key = ends.start + ends.end
        mm, value = (error_of(e, "plans", name, "segments", key, what) for what in ("mm", "value"))
        shown = "".join(spelt(naming.named(x, name)) for x in (ends.start, ends.end))
        rows.append([spelt(naming.vector(vector)), shown, f"{s['mm']:.2f}", *mm, number_cell(s["value"], most), *value])
    unit = say(UNIT[kind_of(name)], lang)
    return table(titled(p, name, lang, naming), ["", say("segment", lang), say("mm", lang), *pm(e), unit, *pm(e)], rows)


def _reactions(reactions: dict[str, Measured], lang: Lang, e: Json | None, naming: Naming) -> list[str]:
    most = max((math.hypot(r.vector.real, r.vector.imag) for r in reactions.values()), default=0.0)
    rows, o = [], pm(e)
    for name, r in reactions.items():
        force = error_of(e, "reactions", name, *(["force"] if r.slides else []))
        more = ["", *[""] * len(o)] * 2
        if r.slides:
            arm, moment = (error_of(e, "reactions", name, key) for key in ("arm", "moment"))
            more = [number_cell(r.arm, 1.0), *arm, number_cell(r.moment, most), *moment]
        rows.append(
            [
                spelt(naming.vector(name)),
                *(number_cell(c, most) for c in r.numbers[:2]),
                *_vector(r, most),
                *force,
                *more,
            ]
        )
    n, reach, couple = say("N", lang), f"{say('arm', lang)}, {say('m', lang)}", f"M, {say('N·m', lang)}"
    head = ["", f"x, {n}", f"y, {n}", f"|F|, {n}", "∠°", *o, reach, *o, couple, *o]
    return table(say("reactions", lang), head, rows)


def _derived(p: Position, lang: Lang, naming: Naming, *groups: str) -> list[str]:
    """Transfer functions; weights and inertia; normal forces, friction and its power: each with its ±."""
    lines: list[str] = []
    for group in groups:
        rows, e = [], p.results.get("errors")
        for key, f in p.of(group).items():
            c, error = f.quantity.columns[0], error_of(e, group, key)
            name = spelt(naming.curve(key) if c.per else naming.vector(c.value))
            beside = max(abs(x.number) for x in p.of(group).values()) if c.per else 0.0
            rows.append([name, number_cell(f.number, beside), *error, "" if c.unit == "1" else say(c.unit, lang)])
        lines += table(say(f"of_{group}", lang), ["", say("value", lang), *pm(e), ""], rows)
    return lines


def _balance(p: Position, lang: Lang, naming: Naming) -> list[str]:
    lines: list[str] = []
    for what, unit in (("moment", "N·m"), ("force", "N")):
        moment, check = p.number(f"balancing_{what}"), p.number(f"zhukovsky_{what}")
        own, other = (error_of(p.results.get("errors"), f"{by}_{what}") for by in ("balancing", "zhukovsky"))
        if moment is not None:
            number = " ± ".join([number_cell(moment), *own])
            sense = (
                f" ({say('lesson_ccw' if moment > 0 else 'lesson_cw', lang)})" if what == "moment" and moment else ""
            )
            letter = spelt(naming.balancing(what == "moment"))
            lines.append(f"{say(f'balancing_{what}', lang)} {letter}: {number} {say(unit, lang)}{sense}")
        if check is not None:
            lines.append(f"{say('by_lever', lang)}: {' ± '.join([number_cell(check), *other])} {say(unit, lang)}")
        if moment is not None and check is not None:
            lines.append(f"{say('difference', lang)}: {100 * difference(moment, check):.2g} %")
    return ["", *lines] if lines else []


def difference(value: float, check: float) -> float:
    """The relative difference of two values."""
    largest = max(abs(value), abs(check))
    return abs(value - check) / largest if largest else 0.0


def stated_tables(p: Position, lang: Lang, naming: Naming) -> list[str]:
    """The vectors of a scene of vectors, plan by plan, and the values computed from them."""
    lines, e = list[str](), p.results.get("errors")
    vectors = p.of("vectors")
    for plan in p.plans.drawn:
        own = [f for f in vectors.values() if plan_of(f.quantity.columns[0].start) == plan]
        most, rows = max((abs(f.vector) for f in own), default=0.0), []
        for f in own:
            name, ends = f.quantity.name, "".join(map(label_of, f.quantity.columns[0].needs))
            segments = p.results.get("plans", {}).get(plan, {}).get("segments", {})
            read = segments.get(ends, {"mm": 0.0, "value": 0.0})
            mm = error_of(e, "plans", plan, "segments", ends, "mm")
            size, angle = number_cell(read["value"], most), directed(f.vector, most)[1]
            rows.append(
                [spelt(naming.vector(name)), size, angle, *error_of(e, "vectors", name), f"{read['mm']:.2f}", *mm]
            )
        lines += table(
            titled(p, plan, lang, naming),
            ["", say(UNIT[kind_of(plan)], lang), "∠°", *pm(e), say("mm", lang), *pm(e)],
            rows,
        )
    rows, beside = [], largest(p)
    for f in p.of("values").values():
        error = error_of(e, "values", f.quantity.name)
        rows.append(
            [
                spelt(naming.vector(f.quantity.name)),
                number_cell(f.number, beside),
                *error,
                say(f.unit, lang) if f.unit else "",
            ]
        )
    lines += table(say("values_found", lang), ["", say("value", lang), *pm(e), ""], rows)
    return [decimals(line, lang) for line in lines] + [f"! {w}" for w in p.results["warnings"]]
