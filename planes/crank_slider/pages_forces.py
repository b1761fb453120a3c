"""The chapter of kinetostatics."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np

from planes.crank_slider.calculation import Calculation
from planes.crank_slider.forces import printed
from planes.crank_slider.pages import KN, ChapterWriter, lines
from planes.crank_slider.pages_kinematics import chosen, drawn_at, values_at
from planes.geometry.arrays import Array
from planes.solving.document import Chart, DrawnViews, PlottedLine
from planes.words.names import kind_of


def worked(c: Calculation) -> float:
    """The position whose forces are written out: of those asked, the one with the largest T."""
    asked = c.given.positions or (chosen(c),)
    return max((float(c.motion.phi_deg[c.at(p)]) for p in asked), key=lambda p: abs(float(c.forces.T[c.at(p)])))


def write_forces(w: ChapterWriter, c: Calculation) -> None:
    """Gas, masses, equations, the cycle, force plans, torque."""
    _gas(w, c)
    _equations(w, c)
    _cycle(w, c)
    for phi in c.given.positions or (chosen(c),):
        scene, solved = drawn_at(w, c, float(c.motion.phi_deg[c.at(phi)]))
        plans = tuple((p,) for p in solved.plans.drawn if kind_of(p) == "force")
        w.figure("f_force", DrawnViews(scene, solved, plans, True), phi=float(solved.at))
    _torque(w, c)


def _gas(w: ChapterWriter, c: Calculation) -> None:
    g, s, mpa = c.given, c.given.shape, c.pressure / 1e6
    top = int(np.argmax(mpa))
    highest = {"p": mpa[c.at(worked(c))], "top": mpa[top], "top_deg": c.motion.phi_deg[top]}
    w.write("gas", values_at(c, worked(c), **highest, strokes=float(len(g.indicator.names)), p0=g.ambient / 1e6))
    w.chart("f_gas", "x_phi", "y_p", lines(c.motion.phi_deg, {"": mpa}), ticks=60, height_mm=50)
    path = (s.r + s.l - c.points.r["B"].real) / (2 * s.r)
    w.chart("f_pv", "x_path", "y_p", lines(path, {"": mpa}), height_mm=54)


def _equations(w: ChapterWriter, c: Calculation) -> None:
    s, parts, ways, k = c.given.shape, c.parts, c.agreement, c.at(worked(c))
    v = values_at(c, worked(c), wrong=printed(s, c.motion, c.plane, c.forces, k))
    f, a_c = v.forces, complex(v.plane.a.C)
    v.at_a, v.at_c, v.at_b = parts.three
    v.negative, v.more_or_less = v.at_c < 0, w.say("s_more" if parts.error > 0 else "s_less")
    v.couple = abs(parts.error) * float(np.max(np.abs(c.plane.epsilon)))
    v.off_T, v.off_N = (_off(getattr(c.forces, name), getattr(c.simple, name)) for name in "TN")
    v.inertia_b, v.inertia_c, v.couple_c = s.m3 * abs(v.plane.a.B), s.m2 * abs(a_c), s.j2 * abs(v.plane.epsilon)
    v.spin = r"-(J_1+m_1\,OS_1^2)\,\varepsilon" if c.given.speed.unevenness else ""
    v.arm = complex(v.plane.r.C - v.plane.r.A)
    v.moment = -s.m2 * (v.arm.real * (a_c.imag + s.g) - v.arm.imag * a_c.real) - s.j2 * v.plane.epsilon
    rubs = bool(s.f and f.rubbing)
    v.rub = rf"{'-' if f.rubbing > 0 else '+'}{w.tex(s.f)}\cdot{w.tex(abs(f.N))}" if rubs else ""
    v.count = len(c.motion.phi_deg)
    v.apart_forces, v.apart_torque, v.apart_lever = (w.number(x, 2) for x in (ways.forces, ways.torque, ways.lever))
    w.write("equations", v)


def _off(true: Array, simple: Array) -> float:
    """How far the largest of one is from the largest of the other, per cent."""
    largest, other = (float(np.max(np.abs(x))) for x in (true, simple))
    return 100 * abs(other - largest) / largest


def _cycle(w: ChapterWriter, c: Calculation) -> None:
    f, m = c.forces, c.motion
    inertia, phi = c.given.shape.m3 * c.plane.a["B"].real, m.phi_deg
    gas, whole = f"P_{{{w.say('sub_gas')}}}", f"P_{{{w.say('sub_p')}}}"
    forces = {gas: m.gas, "m_{3}a_{B}": inertia, whole: f.P, "N": f.N, "S": f.S, "T": f.T, "K": f.K}
    kn = {name: force * KN for name, force in forces.items()}
    w.over_cycle("t_forces", c.steps(len(phi)), {"φ, °": phi, "p": c.pressure / 1e6, **kn, "M": f.torque})
    along = (("l_gas", m.gas, 1), ("l_inertia", inertia, 2), ("l_sum", f.P, 0))
    w.chart("f_P", "x_phi", "y_kN", [PlottedLine(phi, y * KN, w.say(key), look) for key, y, look in along], ticks=60)
    w.chart("f_NS", "x_phi", "y_kN", lines(phi, {n: kn[n] for n in "SN"}), ticks=60)
    w.chart("f_TK", "x_phi", "y_kN", lines(phi, {n: kn[n] for n in "TK"}), ticks=60)
    _polar(w, c)
    load, frame = np.abs(f.on_pin) * KN, np.abs(f.on_crank_from_frame) * KN
    i, j = int(np.argmax(frame)), int(np.argmax(load))
    largest = {"force": frame[i], "force_deg": phi[i], "pin": load[j], "pin_deg": phi[j]}
    w.write("bearing", SimpleNamespace(**largest, mean=np.mean(load[:-1])))


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
    work, phi, cycle = c.work, c.motion.phi_deg, str(len(c.given.indicator.names))
    v = values_at(c, worked(c), uneven=c.given.speed.unevenness, cycle=cycle, takes=work.mean < 0)
    v.both, v.power = work.gas + work.friction, work.power * 1e-3
    w.write("torque", v)
    torques = {"M": c.forces.torque, w.say("l_mean"): np.full_like(phi, work.mean)}
    w.chart("f_torque", "x_phi", "y_M", lines(phi, torques), ticks=60)
    w.write("flywheel", v)
    w.chart("f_excess", "x_phi", "y_J", lines(phi, {"": work.curve}), ticks=60, height_mm=50)
