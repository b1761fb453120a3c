"""Results as tables a person reads in a terminal, in Russian or English."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable
from typing import Any

from planes.measuring import say_plan
from planes.solving import Solved, key_of
from planes.structure import Structure
from planes.units import UNIT, mu_text, plan_of_mu, quantity, read_mu
from planes.vectors import VectorResults
from planes.words import Lang, say


def table(title: str, head: Iterable[str], rows: Iterable[Iterable[str]]) -> list[str]:
    """Aligned columns under a title; nothing at all when there are no rows."""
    lines = [list(head), *map(list, rows)]
    if len(lines) == 1:
        return []
    widths = [max(len(row[i]) for row in lines) for i in range(len(lines[0]))]
    text = ["  ".join(c.ljust(w) if i == 0 else c.rjust(w) for i, (c, w) in enumerate(zip(row, widths, strict=True)))
            for row in lines]  # fmt: skip
    return ["", title, *(f"  {line.rstrip()}" for line in text)]


def report(solved: Solved, lang: Lang = "en") -> str:
    """The whole answer of ``planes solve`` as text."""
    s = solved.plans.structure
    lines = [solved.scene.title.get(lang, ""), f"W = {s.W}, q = {s.q}, {s.formula}"]
    for p in solved.positions:
        lines += _position(p.results, key_of(solved.plans), lang)
    return "\n".join(line for i, line in enumerate(lines) if line or i) + "\n"


def _position(r: dict[str, Any], key: str, lang: Lang) -> list[str]:
    head = f"φ = {r[key]:.10g}°" if key == "phi_deg" else f"s = {r[key]:.10g} {say('m', lang)}"
    lines = ["", f"— {head} —"]
    lines += _points(r.get("points", {}), lang) + _links(r.get("links", {}), lang) + _slides(r.get("slides", {}), lang)
    for name, plan in r.get("plans", {}).items():
        if name != "position":
            lines += _plan(name, plan, lang)
    lines += _reactions(r.get("reactions", {}), lang) + _balance(r, lang)
    return lines + [f"! {w}" for w in r["warnings"]]


def _number(value: float | None) -> str:
    return "—" if value is None else quantity(value, true_minus=False)


def _vector(v: list[float] | None) -> tuple[str, str]:
    """Size and direction in degrees of a vector."""
    if v is None:
        return "", ""
    z = complex(*v)
    return _number(abs(z)), f"{math.degrees(cmath.phase(z)):.2f}" if z else "—"


def _points(points: dict[str, Any], lang: Lang) -> list[str]:
    rows = []
    for name, p in points.items():
        x, y = map(_number, p["r"]) if "r" in p else ("", "")
        rows.append([name, x, y, *_vector(p.get("v")), *_vector(p.get("a"))])
    m, speed, rate = say("m", lang), say("m/s", lang), say("m/s²", lang)
    return table(say("points", lang), ["", f"x, {m}", f"y, {m}", f"v, {speed}", "∠°", f"a, {rate}", "∠°"], rows)


def _links(links: dict[str, Any], lang: Lang) -> list[str]:
    keys = ("angle_deg", "omega", "epsilon")
    rows = [[n, *(_number(v[k]) if k in v else "" for k in keys)] for n, v in links.items()]
    return table(say("links", lang), ["", "φ, °", f"ω, {say('rad/s', lang)}", f"ε, {say('rad/s²', lang)}"], rows)


def _slides(slides: dict[str, Any], lang: Lang) -> list[str]:
    rows = []
    for n, v in slides.items():
        numbers = [_number(v[k]) if k in v else "" for k in ("v", "a")]
        rows.append([n, str(v.get("guide", "")), *numbers, _vector(v.get("coriolis"))[0]])
    head = ["", say("guide", lang), f"v, {say('m/s', lang)}", f"a, {say('m/s²', lang)}", f"aᵏ, {say('m/s²', lang)}"]
    return table(say("slides", lang), head, rows)


def _plan(name: str, plan: dict[str, Any], lang: Lang) -> list[str]:
    rows = [[s["name"], key, f"{s['mm']:.2f}", _number(s["value"])] for key, s in plan["segments"].items()]
    kind = name.partition(":")[0]
    unit = say({"velocity": "m/s", "acceleration": "m/s²", "force": "N"}[kind], lang)
    title = f"{say_plan(name, lang)}, μ = {say_mu(plan['mu'], lang)}"
    return table(title, ["", say("segment", lang), say("mm", lang), unit], rows)


def say_mu(text: str, lang: Lang) -> str:
    """μ in the letters of the language."""
    plan = plan_of_mu(text)
    return mu_text(read_mu(text, plan), plan, lang)


def _reactions(reactions: dict[str, Any], lang: Lang) -> list[str]:
    rows = []
    for name, r in reactions.items():
        force, more = (r["force"], [_number(r["arm"]), _number(r["moment"])]) if isinstance(r, dict) else (r, ["", ""])
        rows.append([name, *map(_number, force), *_vector(force), *more])
    n, m = say("N", lang), say("m", lang)
    head = ["", f"x, {n}", f"y, {n}", f"|F|, {n}", "∠°", f"{say('arm', lang)}, {m}", f"M, {say('N·m', lang)}"]
    return table(say("reactions", lang), head, rows)


def _balance(r: dict[str, Any], lang: Lang) -> list[str]:
    lines = []
    for what, unit in (("moment", "N·m"), ("force", "N")):
        found, check = r.get(f"balancing_{what}"), r.get(f"zhukovsky_{what}")
        if found is not None:
            lines.append(f"{say(f'balancing_{what}', lang)}: {_number(found)} {say(unit, lang)}")
        if check is not None:
            lines.append(f"{say('by_lever', lang)}: {_number(check)} {say(unit, lang)}")
        if found is not None and check is not None:
            lines.append(f"{say('difference', lang)}: {difference_percent(found, check):.2g} %")
    return ["", *lines] if lines else []


def difference_percent(found: float, check: float) -> float:
    """How far two values are apart, in per cent of the larger."""
    largest = max(abs(found), abs(check))
    return 100 * abs(found - check) / largest if largest else 0.0


def structure_report(found: Structure, lang: Lang = "en") -> str:
    """W, q, the formula and the groups, one a line."""
    lines = [f"W = {found.W}, q = {found.q}", found.formula]
    for g in found.groups:
        kind = say("class_kind", lang, kind=g.kind, name=g.name)
        lines.append(f"{say('group', lang)} {', '.join(g.links)}: {kind}")
    return "\n".join(lines)


def vector_report(results: VectorResults, lang: Lang = "en") -> str:
    """The vectors of a scene without a mechanism."""
    unit = UNIT[results.scene.quantity or "velocity"]
    rows = [[n, *_vector([v.real, v.imag]), f"{abs(v) * results.mu:.2f}"] for n, v in results.vectors().items()]
    mu = say_mu(mu_text(results.mu, results.scene.quantity or "velocity"), lang)
    lines = table(f"μ = {mu}", ["", say(unit, lang), "∠°", say("mm", lang)], rows)
    return "\n".join([results.scene.title.get(lang, ""), *lines[1:]]).lstrip("\n")
