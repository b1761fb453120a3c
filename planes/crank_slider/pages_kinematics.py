"""The chapters of given data and kinematics."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np

from planes.crank_slider.calculation import Calculation
from planes.crank_slider.kinematics import loaded, swing, text_acceleration
from planes.crank_slider.pages import ChapterWriter, lines
from planes.scene import Scene
from planes.solving import Position, plans_of, position
from planes.solving.document import DrawnViews

FITS = {"position": 110.0, "velocity": 58.0, "acceleration": 58.0, "force": 78.0, "motion": 58.0}
"""How large a plan may be in the report, mm."""


def write_given(w: ChapterWriter, c: Calculation) -> None:
    """What the calculation starts from."""
    g, s = c.given, c.given.shape
    w.write("given", g)
    rows = (
        ("g_r", "r", s.r, "m"),
        ("g_l", "l", s.l, "m"),
        ("g_c", "AC", s.c, "m"),
        ("g_lambda", "λ", s.ratio, ""),
        ("g_omega", "ω", s.omega, "rad/s"),
        ("g_m1", "m_{1}", s.m1, "kg"),
        ("g_m2", "m_{2}", s.m2, "kg"),
        ("g_m3", "m_{3}", s.m3, "kg"),
        ("g_j2", "J_{C}", s.j2, "kgm2"),
        ("g_f", "f", s.f, ""),
        ("g_d", "D", g.bore, "m"),
        ("g_p0", "p_{0}", g.ambient / 1e6, "MPa"),
        ("g_strokes", "", float(len(g.indicator.names)), ""),
    )
    told = [(w.say(k), sign, f"{w.number(v)} {w.say(u) if u else ''}".strip()) for k, sign, v, u in rows]
    if g.speed.unevenness:
        told.append((w.say("g_uneven"), "δ; n", f"{w.number(g.speed.unevenness)}; {w.number(g.speed.waves)}"))
    w.table("t_given", w.words("c_what", "c_sign", "c_value"), told)
    scene, solved = drawn_at(w, c, chosen(c))
    w.figure("f_scheme", DrawnViews(scene, solved, (("scheme",),), True), phi=chosen(c))


def chosen(c: Calculation) -> float:
    """The crank angle of the worked position, degrees."""
    assert c.scene.mechanism is not None
    asked = c.scene.mechanism.drive.position % 360.0
    turned = asked if asked >= c.given.indicator.start_deg else asked + 360.0
    return float(c.motion.phi_deg[c.at(turned)])


def drawn_at(w: ChapterWriter, c: Calculation, phi_deg: float) -> tuple[Scene, Position]:
    """The plans of one position, the gas force of that moment on the piston."""
    scene = scene_at(c, phi_deg)
    plans, wanted = plans_of(scene)
    return scene, position(scene, plans, wanted, phi_deg, None, w.lang, FITS)


def scene_at(c: Calculation, phi_deg: float) -> Scene:
    """The scene in one position of the cycle, the gas force of that moment as its load."""
    k = c.at(phi_deg)
    assert c.scene.mechanism is not None
    mechanism = loaded(c.scene.mechanism, c.given.shape, float(c.motion.gas[k]))
    drive = replace(
        mechanism.drive, position=phi_deg, velocity=float(c.motion.omega[k]), acceleration=float(c.motion.epsilon[k])
    )
    return replace(c.scene, mechanism=replace(mechanism, drive=drive), find=None)


def values_at(c: Calculation, phi_deg: float, **more: object) -> SimpleNamespace:
    """What the text of one position names: the numbers of the calculation at its step, and ``more``."""
    k, s = c.at(phi_deg), c.given.shape
    found = {name: at_step(getattr(c, name), k) for name in ("motion", "points", "plane", "forces")}
    motion = found["motion"]
    beta = math.degrees(float(swing(s, np.radians(motion.phi_deg))))
    rates = {"phi": float(motion.phi_deg), "omega": float(motion.omega), "eps": float(motion.epsilon), "beta": beta}
    return SimpleNamespace(s=s, given=c.given, parts=c.parts, work=c.work, **rates, **found, **more)


def at_step(of: object, k: int) -> SimpleNamespace:
    """The numbers of a record of arrays at one step of the cycle."""
    named = of if isinstance(of, dict) else vars(of)
    rows = {name: v[k] if isinstance(v, np.ndarray) else v for name, v in named.items()}
    return SimpleNamespace(**{name: at_step(v, k) if isinstance(v, dict) else v for name, v in rows.items()})


def write_kinematics(w: ChapterWriter, c: Calculation) -> None:
    """Both ways, the plans, the results over a turn."""
    s, phi = c.given.shape, chosen(c)
    v = values_at(c, phi)
    v.k, v.twice, v.lean, v.printed_3 = s.c / s.l, 2 * phi, phi + v.beta, _mistake_3(w, c)
    v.root = math.sqrt(s.l**2 - (s.r * math.sin(math.radians(phi))) ** 2)
    v.steady = "-" if v.eps else f"={w.tex(v.points.a.B.real)}[m/s²]"
    v.normal, v.tangent = v.plane.omega**2 * s.l, v.plane.epsilon * s.l
    w.write("points", v)
    w.write("plane", v)
    scene, solved = drawn_at(w, c, phi)
    plans = tuple((p, f"equations {p}") for p in ("velocity", "acceleration"))
    w.figure("f_kinplans", DrawnViews(scene, solved, plans, True), phi=phi)
    _results(w, c)


def _mistake_3(w: ChapterWriter, c: Calculation) -> str:
    """How far off the text's (3) is."""
    if not c.given.speed.unevenness:
        return w.say("m_3_none")
    s = c.given.shape
    off = np.abs(text_acceleration(s, c.motion) - c.points.a["B"]) / (s.omega**2 * s.r)
    return w.say("m_3_size", percent=float(100 * off.max()))


def _results(w: ChapterWriter, c: Calculation) -> None:
    s, ways = c.given.shape, c.agreement
    w.write("results", c)
    compared = (ways.velocity, ways.acceleration, ways.omega, ways.epsilon)
    rows = [(w.say(k), *(w.number(part[k], 2) for part in compared)) for k in ways.velocity]
    w.table("t_agree", [w.say("c_ways"), "v", "a", "ω_{AB}", "ε_{AB}"], rows)
    turn, unit, rate = c.turn, s.omega * s.r, s.omega**2 * s.r
    phi = c.motion.phi_deg[turn]
    p, q = c.points, c.plane
    v, a = ({"A": np.abs(x["A"]), "B": x["B"].real, "C": np.abs(x["C"])} for x in (p.v, p.a))
    rates = {f"{letter}_{{{n}}}": of[n] for letter, of in (("v", v), ("a", a)) for n in "ABC"}
    columns = {"φ, °": phi, "x_{B}": p.r["B"].real, **rates, "ω_{AB}": q.omega, "ε_{AB}": q.epsilon}
    w.over_cycle("t_kin", c.steps(len(phi)), columns)
    turned = {r"$\omega_{AB}/\omega$": q.omega / s.omega, r"$\varepsilon_{AB}/\omega^2$": q.epsilon / s.omega**2}
    sizes = [{n: np.abs(x) / whole for n, x in of.items()} for of, whole in ((v, unit), (a, rate))]
    for key, y, curves in (("f_7a", "y_v", sizes[0]), ("f_7b", "y_a", sizes[1]), ("f_omega", "y_w", turned)):
        w.chart(key, "x_phi", y, lines(phi, {n: x[turn] for n, x in curves.items()}), ticks=30)
