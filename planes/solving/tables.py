"""Results as tables a person reads in a terminal, in Russian or English."""

import cmath
import math
from collections.abc import Iterable

from planes.drafting.drawing import Drawing
from planes.plans.measuring import formula_of, lettering, say_plan
from planes.plans.quantities import Measured
from planes.solving import Position, Solved, key_of
from planes.solving.vectors import VectorResults
from planes.words import Lang, say
from planes.words.lettering import Naming
from planes.words.names import kind_of, mu_of
from planes.words.records import Json
from planes.words.units import UNIT, mu_text, quantity

Row = dict[str, Measured]


def table(title: str, head: Iterable[str], rows: Iterable[Iterable[str]]) -> list[str]:
    """Aligned columns under a title; nothing at all when there are no rows."""
    lines = [list(head), *map(list, rows)]
    if len(lines) == 1:
        return []
    widths = [max(len(row[i]) for row in lines) for i in range(len(lines[0]))]
    text = [
        "  ".join(c.ljust(w) if i == 0 else c.rjust(w) for i, (c, w) in enumerate(zip(row, widths, strict=True)))
        for row in lines
    ]
    return ["", title, *(f"  {line.rstrip()}" for line in text)]


def report(solved: Solved, lang: Lang = "en") -> str:
    """The whole answer of ``planes solve`` as text."""
    s = solved.plans.structure
    naming = Naming(lang, **lettering(solved.scene, solved.plans))
    lines = [solved.scene.title.get(lang, ""), f"W = {s.W}, q = {s.q}, {formula_of(s, naming.frame)}"]
    for p in solved.positions:
        lines += _position(p, key_of(solved.plans), lang, naming)
    if some := next((p for p in solved.positions if "errors" in p.results), None):
        lines += errors_told(True, some.drawing, lang)
    return "\n".join(line for i, line in enumerate(lines) if line or i) + "\n"


def _position(p: Position, key: str, lang: Lang, naming: Naming) -> list[str]:
    r = p.results
    head = f"φ = {p.at:.10g}°" if key == "phi_deg" else f"s = {p.at:.10g} {say('m', lang)}"
    lines = ["", f"— {head} —"]
    e: Json | None = r.get("errors")
    lines += _points(p.rows("points"), lang, e) + _links(p.rows("links"), lang, e, p.plans.mechanism.drive.link)
    lines += _slides(p, lang, e)
    for name, plan in r.get("plans", {}).items():
        if name != "position" and any(s["mm"] for s in plan["segments"].values()):
            lines += _plan(p, name, lang, naming)
    forces = p.of("reactions")
    if not forces or any(any(f.numbers[:2]) or f.moment for f in forces.values()):
        lines += _reactions(forces, lang, e, naming) + _derived(p, lang, naming) + _balance(p, lang)
    return lines + [f"! {w}" for w in r["warnings"]]


def _spelt(lettered: str) -> str:
    """A lettered name as a terminal has it: F_{56}^{t} -> F_56^t."""
    return lettered.replace("{", "").replace("}", "")


def _number(value: float | None, beside: float = 0.0) -> str:
    """A number for people; one that is nothing ``beside`` the largest of its kind is 0."""
    if value is None:
        return "—"
    return quantity(0.0 if abs(value) <= 1e-12 * beside else value)


def _largest(things: Iterable[Row], key: str) -> float:
    """The largest size of ``key`` among results."""
    found = [t[key].numbers for t in things if key in t]
    return max((math.hypot(*(x for x in v if x is not None)) for v in found), default=0.0)


def _vector(found: Measured | None, beside: float = 0.0) -> tuple[str, str]:
    """Size and direction in degrees of a vector."""
    return ("", "") if found is None else _directed(found.vector, beside)


def _directed(z: complex, beside: float) -> tuple[str, str]:
    if abs(z) <= 1e-12 * beside:
        return "0", "—"
    angle = round(math.degrees(cmath.phase(z)), 2)
    return _number(abs(z)), f"{180.0 if angle == -180 else angle + 0.0:.2f}"


def error_of(errors: Json | None, *path: str) -> list[str]:
    """The cell with a result's ± (of a vector: of its end), or no cell when none was asked."""
    if errors is None:
        return []
    found: object = errors
    for key in path:
        found = found.get(key, {}) if isinstance(found, dict) else {}
    numbers = found if isinstance(found, list) else [found]
    if found == {} or None in numbers:
        return ["" if found == {} else "—"]
    size = math.hypot(*numbers)
    return [f"{size:.1e}" if size else "0"]


def _points(points: dict[str, Row], lang: Lang, e: Json | None) -> list[str]:
    far, fast, quick = (_largest(points.values(), key) for key in ("r", "v", "a"))
    rows = []
    for name, p in points.items():
        x, y = (_number(c, far) for c in p["r"].numbers) if "r" in p else ("", "")
        r, v, a = (error_of(e, "points", name, letter) for letter in "rva")
        rows.append([name, x, y, *r, *_vector(p.get("v"), fast), *v, *_vector(p.get("a"), quick), *a])
    m, speed, rate = say("m", lang), say("m/s", lang), say("m/s²", lang)
    o = pm(e)
    head = ["", f"x, {m}", f"y, {m}", *o, f"v, {speed}", "∠°", *o, f"a, {rate}", "∠°", *o]
    return table(say("points", lang), head, rows)


def pm(errors: Json | None) -> list[str]:
    """The head of a column of ±, where there is one."""
    return [] if errors is None else ["±"]


def _links(links: dict[str, Row], lang: Lang, e: Json | None, driver: str) -> list[str]:
    """Rates of the driver are given: beside whatever else, they are no nothing."""
    keys = ("angle_deg", "omega", "epsilon")
    spin = _largest(links.values(), "omega")
    beside = {"angle_deg": 180.0, "omega": spin, "epsilon": max(_largest(links.values(), "epsilon"), spin * spin)}
    rows = []
    for n, v in links.items():
        most = dict.fromkeys(keys, 0.0) if n == driver else beside
        cells = ([_number(v[k].number, most[k]) if k in v else "", *error_of(e, "links", n, k)] for k in keys)
        rows.append([n, *(c for cell in cells for c in cell)])
    head = ["", "φ, °", *pm(e), f"ω, {say('rad/s', lang)}", *pm(e), f"ε, {say('rad/s²', lang)}", *pm(e)]
    return table(say("links", lang), head, rows)


def _slides(p: Position, lang: Lang, e: Json | None) -> list[str]:
    slides, rows = p.rows("slides"), []
    fast, quick = _largest(slides.values(), "v"), _largest(slides.values(), "a")
    for n, v in slides.items():
        numbers: list[str] = []
        for k, most in (("v", fast), ("a", quick)):
            numbers += [_number(v[k].number, most) if k in v else "", *error_of(e, "slides", n, k)]
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
        shown = "".join(_spelt(naming.named(x, name)) for x in (ends.start, ends.end))
        rows.append([_spelt(naming.vector(vector)), shown, f"{s['mm']:.2f}", *mm, _number(s["value"], most), *value])
    unit = say(UNIT[kind_of(name)], lang)
    title = f"{say_plan(name, lang)}, μ = {mu_text(p.scales[mu_of(name)], kind_of(name), lang, naming.convention)}"
    return table(title, ["", say("segment", lang), say("mm", lang), *pm(e), unit, *pm(e)], rows)


def _reactions(reactions: dict[str, Measured], lang: Lang, e: Json | None, naming: Naming) -> list[str]:
    most = max((math.hypot(r.vector.real, r.vector.imag) for r in reactions.values()), default=0.0)
    rows, o = [], [""] * len(pm(e))
    for name, r in reactions.items():
        force = error_of(e, "reactions", name, *(["force"] if r.slides else []))
        more = ["", *o, "", *o]
        if r.slides:
            arm, moment = (error_of(e, "reactions", name, key) for key in ("arm", "moment"))
            more = [_number(r.arm, 1.0), *arm, _number(r.moment, most), *moment]
        rows.append(
            [_spelt(naming.vector(name)), *(_number(c, most) for c in r.numbers[:2]), *_vector(r, most), *force, *more]
        )
    n, reach, couple = say("N", lang), f"{say('arm', lang)}, {say('m', lang)}", f"M, {say('N·m', lang)}"
    o = pm(e)
    head = ["", f"x, {n}", f"y, {n}", f"|F|, {n}", "∠°", *o, reach, *o, couple, *o]
    return table(say("reactions", lang), head, rows)


def _derived(p: Position, lang: Lang, naming: Naming) -> list[str]:
    """Weights and inertia; normal forces, friction and its power: each with its ±."""
    lines: list[str] = []
    for group in ("loads", "friction"):
        rows, e = [], p.results.get("errors")
        for of, f in p.of(group).items():
            name = _spelt(naming.vector(f.quantity.columns[0].value))
            error = error_of(e, group, of)
            rows.append([name, _number(f.number), *error, say(f.quantity.columns[0].unit, lang)])
        lines += table(say(f"of_{group}", lang), ["", say("value", lang), *pm(e), ""], rows)
    return lines


def _balance(p: Position, lang: Lang) -> list[str]:
    lines: list[str] = []
    for what, unit in (("moment", "N·m"), ("force", "N")):
        found, check = p.number(f"balancing_{what}"), p.number(f"zhukovsky_{what}")
        own, other = (error_of(p.results.get("errors"), f"{by}_{what}") for by in ("balancing", "zhukovsky"))
        if found is not None:
            number = " ± ".join([_number(found), *own])
            lines.append(f"{say(f'balancing_{what}', lang)}: {number} {say(unit, lang)}")
        if check is not None:
            lines.append(f"{say('by_lever', lang)}: {' ± '.join([_number(check), *other])} {say(unit, lang)}")
        if found is not None and check is not None:
            lines.append(f"{say('difference', lang)}: {100 * difference(found, check):.2g} %")
    return ["", *lines] if lines else []


def difference(found: float, check: float) -> float:
    """How far two values are apart, relative to the larger."""
    largest = max(abs(found), abs(check))
    return abs(found - check) / largest if largest else 0.0


def vector_report(results: VectorResults, lang: Lang = "en") -> str:
    """The vectors of a scene without a mechanism."""
    e, found = results.errors, results.vectors()
    most = max(map(abs, found.values()))
    rows = []
    for n, v in found.items():
        read, angle = results.segment(n), _directed(v, most)[1]
        mm = [f"{read['mm']:.2f}", *error_of(e, "plans", "vectors", "segments", n, "mm")]
        rows.append([n, _number(read["value"], most), angle, *error_of(e, "vectors", n), *mm])
    head = ["", say(UNIT[results.quantity], lang), "∠°", *pm(e), say("mm", lang), *pm(e)]
    lines = table(f"μ = {mu_text(results.mu, results.quantity, lang, results.scene.mu_convention)}", head, rows)
    lines += [f"! {warning}" for warning in results.warnings(lang)] + errors_told(e, results.drawing, lang)
    return "\n".join([results.scene.title.get(lang, ""), *lines[1:]]).lstrip("\n")


def errors_told(errors: object, drawing: Drawing, lang: Lang) -> list[str]:
    """What the ± are, where there are any."""
    return ["", say("errors_pencil" if drawing.tool.doubt_mm > 0 else "errors_bound", lang)] if errors else []
