"""The chapter of kinetostatics."""

from __future__ import annotations

import math

import numpy as np

from planes.crank_slider.calculation import Calculation
from planes.crank_slider.kinematics import swing
from planes.crank_slider.misprints import printed
from planes.crank_slider.pages import ChapterWriter, lines
from planes.crank_slider.pages_kinematics import chosen, drawn_at
from planes.solving.document import Chart, DrawnViews, PlottedLine
from planes.words.names import kind_of

KN = 1e-3


def worked(c: Calculation) -> float:
    """The position whose forces are written out: of those asked, the one with the largest T."""
    asked = c.given.positions or (chosen(c),)
    return max((float(c.motion.phi_deg[c.at(p)]) for p in asked), key=lambda p: abs(float(c.forces.T[c.at(p)])))


def write_forces(w: ChapterWriter, c: Calculation) -> None:
    """Gas, masses, equations, the cycle, force plans, torque."""
    w.head("h_forces", 1)
    _gas(w, c)
    _masses(w, c)
    _inertia(w, c)
    _equations(w, c)
    _cycle(w, c)
    w.head("h_fplans")
    for phi in c.given.positions or (chosen(c),):
        scene, solved = drawn_at(w, c, float(c.motion.phi_deg[c.at(phi)]))
        plans = tuple((p,) for p in solved.plans.drawn if kind_of(p) == "force")
        w.figure("f_force", DrawnViews(scene, solved, plans, True), phi=float(solved.at))
    _torque(w, c)


def _gas(w: ChapterWriter, c: Calculation) -> None:
    g, k, t, s = c.given, c.at(worked(c)), w.tex, c.given.shape
    mpa = c.pressure / 1e6
    top = int(np.argmax(mpa))
    w.head("h_gas")
    w.text("s_gas", strokes=float(len(g.indicator.names)), p0=g.ambient / 1e6)
    w.text("s_gas_at", phi=worked(c), p=float(mpa[k]), top=float(mpa[top]), at=float(c.motion.phi_deg[top]))
    w.formula(
        rf"P_§gas§=(p-p_0)\frac{{\pi D^2}}{{4}}=({t(mpa[k])}-{t(g.ambient / 1e6)})\cdot10^6\,"
        rf"\frac{{\pi\cdot{t(g.bore)}^2}}{{4}}={t(c.motion.gas[k])}[N]"
    )
    w.chart("f_gas", "x_phi", "y_p", lines(c.motion.phi_deg, {"": mpa}), ticks=60, height_mm=50)
    path = (s.r + s.l - c.points.r["B"].real) / (2 * s.r)
    w.chart("f_pv", "x_path", "y_p", lines(path, {"": mpa}), height_mm=54)


def _masses(w: ChapterWriter, c: Calculation) -> None:
    s, parts, t = c.given.shape, c.parts, w.tex
    w.head("h_mass")
    w.text("s_two")
    w.formula(
        rf"m_A=m_2\frac{{l-AC}}{{l}}={t(s.m2)}\cdot\frac{{{t(s.l)}-{t(s.c)}}}{{{t(s.l)}}}={t(parts.at_a)}[kg],\quadm_B="
        rf"m_2\frac{{AC}}{{l}}={t(parts.at_b)}[kg]"
    )
    w.formula(rf"\Delta J=m_2\,AC\,(l-AC)-J_C={t(parts.inertia)}-{t(s.j2)}={t(parts.error)}[kgm2]")
    couple = abs(parts.error) * float(np.max(np.abs(c.plane.epsilon)))
    w.text(
        "s_two_err", percent=abs(parts.percent), sign=w.say("s_more" if parts.error > 0 else "s_less"), moment=couple
    )
    w.formula(
        rf"m_A=\frac{{J_C}}{{AC\cdot l}}={t(parts.three[0])}[kg],\quad m_B=\frac{{J_C}}{{(l-AC)\,l}}="
        rf"{t(parts.three[2])}[kg],\quad m_C=m_2-m_A-m_B={t(parts.three[1])}[kg]"
    )
    if parts.three[1] < 0:
        w.text("s_three_neg")

    def off(name: str) -> float:
        true, simple = (float(np.max(np.abs(getattr(f, name)))) for f in (c.forces, c.simple))
        return 100 * abs(simple - true) / true

    w.text("s_simple", t=off("T"), n=off("N"))


def _inertia(w: ChapterWriter, c: Calculation) -> None:
    s, k, t, p = c.given.shape, c.at(worked(c)), w.tex, c.plane
    a_c = complex(p.a["C"][k])
    w.head("h_inertia")
    w.text("k_at", phi=worked(c), omega=float(c.motion.omega[k]), eps=float(c.motion.epsilon[k]))
    w.formula(
        rf"\Phi_B=m_3|a_B|={t(s.m3)}\cdot{t(abs(p.a['B'][k]))}={t(s.m3 * abs(p.a['B'][k]))}[N],\quad"
        rf"\Phi_C=m_2a_C={t(s.m2)}\cdot{t(abs(a_c))}={t(s.m2 * abs(a_c))}[N],",
        "17, 18",
    )
    w.formula(
        rf"M_{{AB}}^\Phi=J_C|\varepsilon_{{AB}}|={t(s.j2)}\cdot{t(abs(p.epsilon[k]))}="
        rf"{t(s.j2 * abs(p.epsilon[k]))}[N·m]",
        "19",
    )
    w.mistake("m_20", printed=printed(s, c.motion, p, c.forces, k).J_C, true=s.j2)


def _equations(w: ChapterWriter, c: Calculation) -> None:
    w.head("h_balance")
    w.text("s_balance")
    w.formulas("forces")
    spin = r"-(J_1+m_1\,OS_1^2)\,\varepsilon" if c.given.speed.unevenness else ""
    w.formula(
        rf"T=-X_A\sin\varphi+Y_A\cos\varphi,\quad K=-X_A\cos\varphi-Y_A\sin\varphi,\quad M=T\,r-m_1g\,x_{{S1}}{spin}"
    )
    if c.given.shape.f:
        w.text("s_friction")
    _equation_numbers(w, c)
    k, s, f = c.at(worked(c)), c.given.shape, c.forces
    wrong = printed(s, c.motion, c.plane, f, k)
    w.mistake("m_22", phi=worked(c), printed=wrong.R_B, true=float(f.N[k]))
    w.mistake("m_24", phi=worked(c), t_printed=wrong.T, t_true=float(f.T[k]), k_printed=wrong.K, k_true=float(f.K[k]))


def _equation_numbers(w: ChapterWriter, c: Calculation) -> None:
    s, f, k, p, t, b = c.given.shape, c.forces, c.at(worked(c)), c.plane, w.tex, w.bracketed
    phi, beta = worked(c), math.degrees(float(swing(s, c.motion.phi[k])))
    a_c, arm = complex(p.a["C"][k]), complex(p.r["C"][k] - p.r["A"][k])
    moment = -s.m2 * (arm.real * (a_c.imag + s.g) - arm.imag * a_c.real) - s.j2 * float(p.epsilon[k])
    at_b, at_a = complex(f.on_rod_at_b[k]), complex(f.on_pin[k])
    gas, a_b, push = float(c.motion.gas[k]), float(p.a["B"][k].real), float(f.N[k])
    w.text("k_at", phi=phi, omega=float(c.motion.omega[k]), eps=float(c.motion.epsilon[k]))
    w.formula(
        rf"M_A=-{t(s.m2)}\left[{t(arm.real)}({t(a_c.imag)}+{t(s.g)})-{b(arm.imag)}\cdot"
        rf"{b(a_c.real)}\right]-{t(s.j2)}\cdot{b(p.epsilon[k])}={t(moment)}[N·m]"
    )
    sense = -1 if float(f.rubbing[k]) > 0 else 1
    rub = rf"{'+' if sense > 0 else '-'}{t(s.f)}\cdot{t(abs(push))}" if s.f and float(f.rubbing[k]) else ""
    w.formula(rf"P_§p§={t(gas)}+{t(s.m3)}\cdot{b(a_b)}{rub}={t(f.P[k])}[N]")
    w.formula(
        rf"N={t(s.m3)}\cdot{t(s.g)}+{b(f.P[k])}\tan{b(beta)}\degree-\frac{{{t(moment)}}}{{{t(s.l)}\cos{b(beta)}"
        rf"\degree}}={t(push)}[N]",
        "22, 23",
    )
    w.formula(rf"S={b(-at_b.real)}\cos{b(beta)}\degree+{b(at_b.imag)}\sin{b(beta)}\degree={t(f.S[k])}[N]", "23")
    w.formula(
        rf"X_A={t(at_b.real)}-{t(s.m2)}\cdot{b(a_c.real)}={t(at_a.real)}[N],\quad"
        rf"Y_A={t(at_b.imag)}-{t(s.m2)}({t(a_c.imag)}+{t(s.g)})={t(at_a.imag)}[N]"
    )
    w.formula(rf"T=-{b(at_a.real)}\sin{t(phi)}\degree+{b(at_a.imag)}\cos{t(phi)}\degree={t(f.T[k])}[N]", "24, 25")
    w.formula(rf"K=-{b(at_a.real)}\cos{t(phi)}\degree-{b(at_a.imag)}\sin{t(phi)}\degree={t(f.K[k])}[N]", "24, 26")


def _cycle(w: ChapterWriter, c: Calculation) -> None:
    f, m, a = c.forces, c.motion, c.agreement
    w.head("h_cycle")
    w.text(
        "s_equal",
        count=len(m.phi_deg),
        forces=w.number(a.forces, 2),
        torque=w.number(a.torque, 2),
        lever=w.number(a.lever, 2),
    )
    inertia = c.given.shape.m3 * c.plane.a["B"].real
    phi, (gas, whole) = m.phi_deg, (w.say("sub_gas"), w.say("sub_p"))
    forces = {
        f"P_{{{gas}}}": m.gas,
        "m_{3}a_{B}": inertia,
        f"P_{{{whole}}}": f.P,
        "N": f.N,
        "S": f.S,
        "T": f.T,
        "K": f.K,
    }
    kn = {name: force * KN for name, force in forces.items()}
    w.over_cycle("t_forces", c.steps(len(phi)), {"φ, °": phi, "p": c.pressure / 1e6, **kn, "M": f.torque})
    along = (("l_gas", m.gas, 1), ("l_inertia", inertia, 2), ("l_sum", f.P, 0))
    w.chart("f_P", "x_phi", "y_kN", [PlottedLine(phi, y * KN, w.say(key), look) for key, y, look in along], ticks=60)
    w.chart("f_NS", "x_phi", "y_kN", lines(phi, {"S": kn["S"], "N": kn["N"]}), ticks=60)
    w.chart("f_TK", "x_phi", "y_kN", lines(phi, {"T": kn["T"], "K": kn["K"]}), ticks=60)
    _polar(w, c)
    whole_load, frame = np.abs(f.on_pin), np.abs(f.on_crank_from_frame)
    i, j = int(np.argmax(frame)), int(np.argmax(whole_load))
    w.text(
        "s_bearing",
        force=float(frame[i]) * KN,
        phi=float(phi[i]),
        pin=float(whole_load[j]) * KN,
        pin_phi=float(phi[j]),
        mean=float(np.mean(whole_load[:-1])) * KN,
    )


def _polar(w: ChapterWriter, c: Calculation) -> None:
    f, phi = c.forces, c.motion.phi_deg
    far = float(np.max(np.abs(f.on_pin))) * KN
    notes: list[tuple[float, float, str]] = []
    kept: list[complex] = []
    for i in c.steps(len(phi) - 1):
        at = complex(-f.K[i] * KN, f.T[i] * KN)
        clear = all(abs(at - other) > 0.1 * far for other in kept)
        kept += [at] if clear else []
        notes.append((at.real, at.imag, f"{phi[i]:g}°" if clear else ""))
    curve = tuple(lines(-f.K * KN, {"": f.T * KN}))
    w.figure("f_polar", Chart(w.say("x_out"), w.say("y_T"), curve, tuple(notes), equal=True, height_mm=95))


def _torque(w: ChapterWriter, c: Calculation) -> None:
    d, t, phi = c.work, w.tex, c.motion.phi_deg
    w.head("h_torque")
    w.text("s_torque_var" if c.given.speed.unevenness else "s_torque")
    w.formula(
        rf"A=\oint\!\,\,M\,d\varphi={t(d.torque)}[J],\quad A_§gas§={t(d.gas)}[J],\quad A_§fr§={t(d.friction)}[J],"
        rf"\quadA_§gas§+A_§fr§={t(d.gas + d.friction)}[J]"
    )
    cycle = len(c.given.indicator.names)
    w.formula(
        rf"M_§m§=\frac{{A}}{{{cycle}\pi}}=\frac{{{t(d.torque)}}}{{{cycle}\pi}}={t(d.mean)}[N·m],\quadM_§max§="
        rf"{t(d.largest)}[N·m],\quad M_§min§={t(d.smallest)}[N·m],\quad N_e=M_§m§\omega={t(d.power * 1e-3)}[kW]"
    )
    if d.mean < 0:
        w.text("s_negative")
    torques = {"M": c.forces.torque, w.say("l_mean"): np.full_like(phi, d.mean)}
    w.chart("f_torque", "x_phi", "y_M", lines(phi, torques), ticks=60)
    w.text("s_uneven", uneven=d.unevenness, allowed=c.given.allowed_unevenness)
    w.formula(
        rf"\Delta A={t(d.excess)}[J],\quad J_§fly§=\frac{{\Delta A}}{{[\delta]\,\omega^2}}="
        rf"\frac{{{t(d.excess)}}}{{{t(c.given.allowed_unevenness)}\cdot{t(c.given.shape.omega)}^2}}="
        rf"{t(d.flywheel)}[kgm2]"
    )
    w.chart("f_excess", "x_phi", "y_J", lines(phi, {"": d.curve}), ticks=60, height_mm=50)
