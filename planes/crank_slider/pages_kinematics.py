"""The chapters of given data and kinematics."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from planes.crank_slider.calculation import Calculation
from planes.crank_slider.engine import loaded
from planes.crank_slider.kinematics import swing, text_acceleration
from planes.crank_slider.pages import ChapterWriter, lines
from planes.scene import Scene
from planes.solving import Position, plans_of, position
from planes.solving.document import DrawnViews

FITS = {"position": 110.0, "velocity": 58.0, "acceleration": 58.0, "force": 78.0, "motion": 58.0}
"""How large a plan may be in the report, mm."""


def write_given(w: ChapterWriter, c: Calculation) -> None:
    """What the calculation starts from."""
    g, s = c.given, c.given.shape
    w.text("lead")
    w.head("h_given", 1)
    rows = [
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
    ]
    told = [(w.say(k), sign, f"{w.number(v)} {w.say(u) if u else ''}".strip()) for k, sign, v, u in rows]
    if g.speed.unevenness:
        told.append((w.say("g_uneven"), "δ; n", f"{w.number(g.speed.unevenness)}; {w.number(g.speed.waves)}"))
    w.table("t_given", [w.say("c_what"), w.say("c_sign"), w.say("c_value")], told)
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


def write_kinematics(w: ChapterWriter, c: Calculation) -> None:
    """Both ways, the plans, the results over a turn."""
    w.head("h_kin", 1)
    _points(w, c)
    _plane(w, c)
    w.head("h_plans")
    scene, solved = drawn_at(w, c, chosen(c))
    plans = tuple((p, f"equations {p}") for p in ("velocity", "acceleration"))
    w.figure("f_kinplans", DrawnViews(scene, solved, plans, True), phi=chosen(c))
    _results(w, c)


def _points(w: ChapterWriter, c: Calculation) -> None:
    s, k = c.given.shape, c.at(chosen(c))
    w.head("h_points")
    w.text("k_points", k=s.c / s.l)
    w.formulas("places")
    w.text("k_derive")
    w.formulas("rates")
    _mistake_3(w, c)
    _numbers(w, c, k)


def _mistake_3(w: ChapterWriter, c: Calculation) -> None:
    if not c.given.speed.unevenness:
        w.mistake("m_3", size=w.say("m_3_none"))
        return
    s = c.given.shape
    off = np.abs(text_acceleration(s, c.motion) - c.points.a["B"]) / (s.omega**2 * s.r)
    w.mistake("m_3", size=w.say("m_3_size", percent=float(100 * off.max())))


def _numbers(w: ChapterWriter, c: Calculation, k: int) -> None:
    s, p, t, b = c.given.shape, c.points, w.tex, w.bracketed
    phi, omega = float(c.motion.phi_deg[k]), float(c.motion.omega[k])
    w.text("k_at", phi=phi, omega=omega, eps=float(c.motion.epsilon[k]))
    root = math.sqrt(s.l**2 - (s.r * math.sin(math.radians(phi))) ** 2)
    angle = f"{t(phi)}\\degree"
    w.formula(
        rf"s=\sqrt{{{t(s.l)}^2-{t(s.r)}^2\sin^2{angle}}}={t(root)}[m],\quad x_B={t(s.r)}\cos{angle}+{t(root)}="
        rf"{t(p.r['B'][k].real)}[m]"
    )
    w.formula(
        rf"v_B=-{t(omega)}\cdot{t(s.r)}\sin{angle}-{t(omega)}\,\frac{{{t(s.r)}^2\sin{angle}\cos{angle}}}{{{t(root)}}}="
        rf"{t(p.v['B'][k].real)}[m/s]"
    )
    e, a_b = float(c.motion.epsilon[k]), t(p.a["B"][k].real)
    w.formula(
        rf"a_B=-{t(omega)}^2\left[{t(s.r)}\cos{angle}+\frac{{{t(s.r)}^2\cos{t(2 * phi)}\degree}}{{{t(root)}}}+"
        rf"\frac{{{t(s.r)}^4\sin^2{angle}\cos^2{angle}}}{{{t(root)}^3}}\right]" + ("-" if e else f"={a_b}[m/s²]")
    )
    if e:
        w.formula(
            rf"-{b(e)}\left[{t(s.r)}\sin{angle}+\frac{{{t(s.r)}^2\sin{angle}\cos{angle}}}{{{t(root)}}}\right]="
            rf"{a_b}[m/s²]"
        )
    w.formula(
        rf"v_C=\sqrt{{v_{{xC}}^2+v_{{yC}}^2}}=\sqrt{{{b(p.v['C'][k].real)}^2+{b(p.v['C'][k].imag)}^2}}="
        rf"{t(abs(p.v['C'][k]))}[m/s],\quada_C=\sqrt{{{b(p.a['C'][k].real)}^2+{b(p.a['C'][k].imag)}^2}}="
        rf"{t(abs(p.a['C'][k]))}[m/s²]"
    )


def _plane(w: ChapterWriter, c: Calculation) -> None:
    s, k, t, b = c.given.shape, c.at(chosen(c)), w.tex, w.bracketed
    phi, omega, eps = (float(v[k]) for v in (c.motion.phi_deg, c.motion.omega, c.motion.epsilon))
    beta = math.degrees(float(swing(s, np.radians(phi))))
    turning = -float(c.plane.omega[k])
    w.head("h_plane")
    w.text("k_plane")
    w.formulas("instant_centre")
    w.mistake("m_5")
    w.text("k_accel")
    w.formulas("accelerations")
    w.text("k_at", phi=phi, omega=omega, eps=eps)
    tangent = float(c.plane.epsilon[k]) * s.l
    w.formula(
        rf"\beta=\arcsin\frac{{{t(s.r)}\sin{t(phi)}\degree}}{{{t(s.l)}}}={t(beta)}\degree,\quad\omega_{{AB}}="
        rf"\frac{{{t(omega)}\cdot{t(s.r)}\cos{t(phi)}\degree}}{{{t(s.l)}\cos{b(beta)}\degree}}={t(turning)}[rad/s]"
    )
    w.formula(
        rf"|v_B|={t(omega)}\cdot{t(s.r)}\,\frac{{|\sin{t(phi + beta)}\degree|}}{{\cos{b(beta)}\degree}}="
        rf"{t(abs(c.plane.v['B'][k]))}[m/s],\quad a_{{BA}}^n={b(turning)}^2\cdot{t(s.l)}={t(turning**2 * s.l)}[m/s²]"
    )
    w.formula(
        rf"a_{{BA}}^\tau={t(tangent)}[m/s²],\quad \varepsilon_{{AB}}=\frac{{a_{{BA}}^\tau}}{{l}}="
        rf"{t(tangent / s.l)}[rad/s²],\quad a_B={t(-c.plane.a['B'][k].real)}[m/s²]"
    )


def _results(w: ChapterWriter, c: Calculation) -> None:
    s, ways = c.given.shape, c.agreement
    w.head("h_kintable")
    w.text("k_agree", step=c.given.step_deg)
    rows = [
        (w.say(k), *(w.number(part[k], 2) for part in (ways.velocity, ways.acceleration, ways.omega, ways.epsilon)))
        for k in ("points_plane", "points_plans", "plane_plans")
    ]
    w.table("t_agree", [w.say("c_ways"), "v", "a", "ω_{AB}", "ε_{AB}"], rows)
    turn, unit, rate = c.turn, s.omega * s.r, s.omega**2 * s.r
    phi = c.motion.phi_deg[turn]
    p, q = c.points, c.plane
    v, a = ({"A": np.abs(x["A"]), "B": x["B"].real, "C": np.abs(x["C"])} for x in (p.v, p.a))
    rates = {f"{letter}_{{{n}}}": of[n] for letter, of in (("v", v), ("a", a)) for n in "ABC"}
    columns = {"φ, °": phi, "x_{B}": p.r["B"].real, **rates, "ω_{AB}": q.omega, "ε_{AB}": q.epsilon}
    w.over_cycle("t_kin", c.steps(len(phi)), columns)
    w.chart("f_7a", "x_phi", "y_v", lines(phi, {n: np.abs(v[n][turn]) / unit for n in v}), ticks=30)
    w.chart("f_7b", "x_phi", "y_a", lines(phi, {n: np.abs(a[n][turn]) / rate for n in a}), ticks=30)
    turned = {r"$\omega_{AB}/\omega$": q.omega / s.omega, r"$\varepsilon_{AB}/\omega^2$": q.epsilon / s.omega**2}
    w.chart("f_omega", "x_phi", "y_w", lines(phi, {name: x[turn] for name, x in turned.items()}), ticks=30)
