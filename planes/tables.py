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
        if name != "position" and any(s["mm"] for s in plan["segments"].values()):
            lines += _plan(name, plan, lang)
    lines += _reactions(r.get("reactions", {}), lang) + _balance(r, lang)
    return lines + [f"! {w}" for w in r["warnings"]]


def _number(value: float | None, beside: float = 0.0) -> str:
    """A number for people; one that is nothing ``beside`` the largest of its kind is 0."""
    if value is None:
        return "—"
    return quantity(0.0 if abs(value) <= 1e-12 * beside else value)


def _largest(things: Iterable[Any], key: str) -> float:
    """The largest size of ``key`` among results."""
    found = [t[key] for t in things if key in t]
    return max((math.hypot(*v) if isinstance(v, list) else abs(v) for v in found), default=0.0)


def _vector(v: list[float] | None, beside: float = 0.0) -> tuple[str, str]:
    """Size and direction in degrees of a vector."""
    if v is None:
        return "", ""
    z = complex(*v)
    if abs(z) <= 1e-12 * beside:
        return "0", "—"
    angle = round(math.degrees(cmath.phase(z)), 2)
    return _number(abs(z)), f"{180.0 if angle == -180 else angle + 0.0:.2f}"


def _points(points: dict[str, Any], lang: Lang) -> list[str]:
    far, fast, quick = (_largest(points.values(), key) for key in ("r", "v", "a"))
    rows = []
    for name, p in points.items():
        x, y = (_number(c, far) for c in p["r"]) if "r" in p else ("", "")
        rows.append([name, x, y, *_vector(p.get("v"), fast), *_vector(p.get("a"), quick)])
    m, speed, rate = say("m", lang), say("m/s", lang), say("m/s²", lang)
    return table(say("points", lang), ["", f"x, {m}", f"y, {m}", f"v, {speed}", "∠°", f"a, {rate}", "∠°"], rows)


def _links(links: dict[str, Any], lang: Lang) -> list[str]:
    keys = ("angle_deg", "omega", "epsilon")
    spin = _largest(links.values(), "omega")
    beside = {"angle_deg": 180.0, "omega": spin, "epsilon": max(_largest(links.values(), "epsilon"), spin * spin)}
    rows = [[n, *(_number(v[k], beside[k]) if k in v else "" for k in keys)] for n, v in links.items()]
    return table(say("links", lang), ["", "φ, °", f"ω, {say('rad/s', lang)}", f"ε, {say('rad/s²', lang)}"], rows)


def _slides(slides: dict[str, Any], lang: Lang) -> list[str]:
    rows, fast, quick = [], _largest(slides.values(), "v"), _largest(slides.values(), "a")
    for n, v in slides.items():
        numbers = [_number(v[k], most) if k in v else "" for k, most in (("v", fast), ("a", quick))]
        rows.append([n, str(v.get("guide", "")), *numbers, _vector(v.get("coriolis"), quick)[0]])
    head = ["", say("guide", lang), f"v, {say('m/s', lang)}", f"a, {say('m/s²', lang)}", f"aᵏ, {say('m/s²', lang)}"]
    return table(say("slides", lang), head, rows)


def _plan(name: str, plan: dict[str, Any], lang: Lang) -> list[str]:
    most = _largest(plan["segments"].values(), "value")
    rows = [[s["name"], key, f"{s['mm']:.2f}", _number(s["value"], most)] for key, s in plan["segments"].items()]
    kind = name.partition(":")[0]
    unit = say({"velocity": "m/s", "acceleration": "m/s²", "force": "N"}[kind], lang)
    title = f"{say_plan(name, lang)}, μ = {say_mu(plan['mu'], lang)}"
    return table(title, ["", say("segment", lang), say("mm", lang), unit], rows)


def say_mu(text: str, lang: Lang) -> str:
    """μ in the letters of the language."""
    plan = plan_of_mu(text)
    return mu_text(read_mu(text, plan), plan, lang)


def _reactions(reactions: dict[str, Any], lang: Lang) -> list[str]:
    forces = {name: r["force"] if isinstance(r, dict) else r for name, r in reactions.items()}
    most = max((math.hypot(*f) for f in forces.values()), default=0.0)
    rows = []
    for name, r in reactions.items():
        more = [_number(r["arm"], 1.0), _number(r["moment"], most)] if isinstance(r, dict) else ["", ""]
        rows.append([name, *(_number(c, most) for c in forces[name]), *_vector(forces[name], most), *more])
    if not any(map(_pressed, reactions.values())):
        return []
    n, m = say("N", lang), say("m", lang)
    head = ["", f"x, {n}", f"y, {n}", f"|F|, {n}", "∠°", f"{say('arm', lang)}, {m}", f"M, {say('N·m', lang)}"]
    return table(say("reactions", lang), head, rows)


def _pressed(r: Any) -> bool:
    """Whether there is anything in a reaction."""
    return any(r["force"]) or bool(r["moment"]) if isinstance(r, dict) else any(r)


def _balance(r: dict[str, Any], lang: Lang) -> list[str]:
    lines: list[str] = []
    if "reactions" in r and not any(map(_pressed, r["reactions"].values())):
        return lines
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
