"""The chapters of given data, kinematics and kinetostatics."""

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np

from planes.crank_slider.calculation import Calculation
from planes.crank_slider.forces import equations_as_printed
from planes.crank_slider.kinematics import acceleration_as_printed, largest_magnitude, rod_inclination, with_gas_force
from planes.crank_slider.pages import KILONEWTONS_PER_NEWTON, ChapterWriter, plotted_lines
from planes.scene import Scene
from planes.solving import Position, plans_and_requested_results, solve_position
from planes.solving.document import Chart, DrawnViews, PlottedLine

PLAN_SIZES_MM = {"position": 110.0, "velocity": 58.0, "acceleration": 58.0, "force": 78.0, "motion": 58.0}
"""The size of a plan in the report, mm."""


def write_given(w: ChapterWriter, c: Calculation) -> None:
    """The input of the calculation."""
    g = c.given
    s = c.given.shape
    w.write("given", g)
    sizes = w.sizes("sizes", SimpleNamespace(given=g, s=s, p0=g.ambient / 1e6, strokes=float(len(g.indicator.names))))
    if g.speed.unevenness:
        sizes.append((w.say("g_uneven"), "δ; n", f"{w.number(g.speed.unevenness)}; {w.number(g.speed.waves)}"))
    w.table("t_given", w.words("c_what", "c_sign", "c_value"), sizes)
    scene, solved = draw_plans_at_angle(w, c, worked_crank_angle_deg(c))
    w.figure("f_scheme", DrawnViews(scene, solved, (("scheme",),), True), phi=worked_crank_angle_deg(c))


def worked_crank_angle_deg(c: Calculation) -> float:
    """The crank angle of the worked position, degrees."""
    assert c.scene.mechanism is not None
    asked = c.scene.mechanism.drive.position % 360.0
    return c.angle(asked if asked >= c.given.indicator.start_deg else asked + 360.0)


def draw_plans_at_angle(w: ChapterWriter, c: Calculation, phi_deg: float) -> tuple[Scene, Position]:
    """The plans of one position, with the gas force of that moment on the piston."""
    scene = scene_at_angle(c, phi_deg)
    plans, wanted = plans_and_requested_results(scene)
    return scene, solve_position(scene, plans, wanted, phi_deg, None, w.lang, PLAN_SIZES_MM)


def scene_at_angle(c: Calculation, phi_deg: float) -> Scene:
    """The scene in one position of the cycle, with the gas force of that moment as its load."""
    k = c.at(phi_deg)
    assert c.scene.mechanism is not None
    mechanism = with_gas_force(c.scene.mechanism, c.given.shape, float(c.motion.gas[k]))
    omega = float(c.motion.omega[k])
    epsilon = float(c.motion.epsilon[k])
    drive = replace(mechanism.drive, position=phi_deg, velocity=omega, acceleration=epsilon)
    return replace(c.scene, mechanism=replace(mechanism, drive=drive), find=None)


def text_values_at_angle(c: Calculation, phi_deg: float, **more: object) -> SimpleNamespace:
    """Values for the text of one position: the numbers of the calculation at its step, and ``more``."""
    k = c.at(phi_deg)
    s = c.given.shape
    records = {name: record_at_step(getattr(c, name), k) for name in ("motion", "points", "plane", "forces")}
    motion = records["motion"]
    beta = math.degrees(float(rod_inclination(s, np.radians(motion.phi_deg))))
    rates = {"phi": float(motion.phi_deg), "omega": float(motion.omega), "eps": float(motion.epsilon), "beta": beta}
    return SimpleNamespace(s=s, given=c.given, parts=c.parts, work=c.work, **rates, **records, **more)


def record_at_step(record: object, k: int) -> SimpleNamespace:
    """The numbers of a record of arrays at one step of the cycle."""
    named = record if isinstance(record, dict) else vars(record)
    rows = {name: v[k] if isinstance(v, np.ndarray) else v for name, v in named.items()}
    return SimpleNamespace(**{name: record_at_step(v, k) if isinstance(v, dict) else v for name, v in rows.items()})


def write_kinematics(w: ChapterWriter, c: Calculation) -> None:
    """Both methods, the plans, the results over a turn."""
    s = c.given.shape
    phi = worked_crank_angle_deg(c)
    v = text_values_at_angle(c, phi)
    v.k = s.c / s.l
    v.twice = 2 * phi
    v.lean = phi + v.beta
    v.printed_3 = _mistake_3_sentence(w, c)
    v.root = math.sqrt(s.l**2 - (s.r * math.sin(math.radians(phi))) ** 2)
    v.steady = "-" if v.eps else f"={w.tex(v.points.a.B.real)}[m/s²]"
    v.normal = v.plane.omega**2 * s.l
    v.tangent = v.plane.epsilon * s.l
    w.write("points", v)
    w.write("plane", v)
    scene, solved = draw_plans_at_angle(w, c, phi)
    w.figure("f_centre", DrawnViews(scene, solved, (("centre 2",),)), phi=phi)
    w.write("kinplans", v)
    plans = tuple((p, f"equations {p}") for p in ("velocity", "acceleration"))
    w.figure("f_kinplans", DrawnViews(scene, solved, plans, True), phi=phi)
    _write_kinematic_results(w, c)


def _mistake_3_sentence(w: ChapterWriter, c: Calculation) -> str:
    """The error of the text's (3)."""
    if not c.given.speed.unevenness:
        return w.say("m_3_none")
    s = c.given.shape
    off = np.abs(acceleration_as_printed(s, c.motion) - c.points.a["B"]) / (s.omega**2 * s.r)
    return w.say("m_3_size", percent=float(100 * off.max()))


def _write_kinematic_results(w: ChapterWriter, c: Calculation) -> None:
    s = c.given.shape
    ways = c.agreement
    w.write("results", c)
    compared = (ways.velocity, ways.acceleration, ways.omega, ways.epsilon)
    rows = [(w.say(k), *(w.number(part[k], 2) for part in compared)) for k in ways.velocity]
    w.table("t_agree", [w.say("c_ways"), "v", "a", "ω_{AB}", "ε_{AB}"], rows)
    turn = c.turn
    unit = s.omega * s.r
    rate = s.omega**2 * s.r
    phi = c.motion.phi_deg[turn]
    p = c.points
    q = c.plane
    v, a = ({"A": np.abs(x["A"]), "B": x["B"].real, "C": np.abs(x["C"])} for x in (p.v, p.a))
    rates = {f"{letter}_{{{n}}}": vectors[n] for letter, vectors in (("v", v), ("a", a)) for n in "ABC"}
    columns = {"φ, °": phi, "x_{B}": p.r["B"].real, **rates, "ω_{AB}": q.omega, "ε_{AB}": q.epsilon}
    w.over_cycle("t_kin", c.steps(len(phi)), columns)
    turned = {r"$\omega_{AB}/\omega$": q.omega / s.omega, r"$\varepsilon_{AB}/\omega^2$": q.epsilon / s.omega**2}
    sizes = [{n: np.abs(x) / unit_size for n, x in vectors.items()} for vectors, unit_size in ((v, unit), (a, rate))]
    for key, y, curves in (("f_7a", "y_v", sizes[0]), ("f_7b", "y_a", sizes[1]), ("f_omega", "y_w", turned)):
        w.chart(key, "x_phi", y, plotted_lines(phi, {n: x[turn] for n, x in curves.items()}), ticks=30)


def worked_force_angle_deg(c: Calculation) -> float:
    """The position whose forces are written out: of those requested, the one with the largest T."""
    asked = c.given.positions or (worked_crank_angle_deg(c),)
    return max(map(c.angle, asked), key=lambda p: abs(float(c.forces.T[c.at(p)])))


def write_forces(w: ChapterWriter, c: Calculation) -> None:
    """Gas, masses, equations, the cycle, force plans, torque."""
    _write_gas_pressure(w, c)
    _write_force_equations(w, c)
    _write_force_cycle(w, c)
    for phi in c.given.positions or (worked_crank_angle_deg(c),):
        scene, solved = draw_plans_at_angle(w, c, c.angle(phi))
        plans = tuple((p,) for p in solved.plans.force_plans)
        w.figure("f_force", DrawnViews(scene, solved, plans, True), phi=float(solved.at))
    _write_torque(w, c)


def _write_gas_pressure(w: ChapterWriter, c: Calculation) -> None:
    g = c.given
    s = c.given.shape
    mpa = c.pressure / 1e6
    top = mpa.argmax()
    highest = {"p": mpa[c.at(worked_force_angle_deg(c))], "top": mpa[top], "top_deg": c.motion.phi_deg[top]}
    w.write(
        "gas",
        text_values_at_angle(
            c, worked_force_angle_deg(c), **highest, strokes=float(len(g.indicator.names)), p0=g.ambient / 1e6
        ),
    )
    w.chart("f_gas", "x_phi", "y_p", plotted_lines(c.motion.phi_deg, {"": mpa}), ticks=60, height_mm=50)
    path = (s.r + s.l - c.points.r["B"].real) / (2 * s.r)
    w.chart("f_pv", "x_path", "y_p", plotted_lines(path, {"": mpa}), height_mm=54)


def _write_force_equations(w: ChapterWriter, c: Calculation) -> None:
    s = c.given.shape
    parts = c.parts
    ways = c.agreement
    k = c.at(worked_force_angle_deg(c))
    v = text_values_at_angle(
        c, worked_force_angle_deg(c), wrong=equations_as_printed(s, c.motion, c.plane, c.forces, k)
    )
    f = v.forces
    a_c = complex(v.plane.a.C)
    v.at_a, v.at_c, v.at_b = parts.three
    v.negative, v.more_or_less = v.at_c < 0, w.say("s_more" if parts.error > 0 else "s_less")
    v.couple = abs(parts.error) * largest_magnitude(c.plane.epsilon)
    maxima = [[largest_magnitude(getattr(forces, name)) for forces in (c.forces, c.simple)] for name in "TN"]
    v.off_T, v.off_N = (100 * abs(simple - true) / true for true, simple in maxima)
    v.inertia_b = s.m3 * abs(v.plane.a.B)
    v.inertia_c = s.m2 * abs(a_c)
    v.couple_c = s.j2 * abs(v.plane.epsilon)
    v.spin = r"-(J_1+m_1\,OS_1^2)\,\varepsilon" if c.given.speed.unevenness else ""
    v.arm = complex(v.plane.r.C - v.plane.r.A)
    v.moment = -s.m2 * (v.arm.real * (a_c.imag + s.g) - v.arm.imag * a_c.real) - s.j2 * v.plane.epsilon
    rubs = bool(s.f and f.rubbing)
    v.rub = rf"{'-' if f.rubbing > 0 else '+'}{w.tex(s.f)}\cdot{w.tex(abs(f.N))}" if rubs else ""
    v.count = len(c.motion.phi_deg)
    v.apart_forces, v.apart_torque, v.apart_lever = (w.number(x, 2) for x in (ways.forces, ways.torque, ways.lever))
    scene, solved = draw_plans_at_angle(w, c, worked_force_angle_deg(c))
    shown = ("loaded", "loaded 3", "loaded 2", "loaded 1")
    w.figure("f_loaded", DrawnViews(scene, solved, tuple((x,) for x in shown)), phi=v.phi)
    w.write("equations", v)


def _write_force_cycle(w: ChapterWriter, c: Calculation) -> None:
    f = c.forces
    m = c.motion
    inertia = c.given.shape.m3 * c.plane.a["B"].real
    phi = m.phi_deg
    gas = f"P_{{{w.say('sub_gas')}}}"
    total = f"P_{{{w.say('sub_p')}}}"
    forces = {gas: m.gas, "m_{3}a_{B}": inertia, total: f.P, "N": f.N, "S": f.S, "T": f.T, "K": f.K}
    kn = {name: force * KILONEWTONS_PER_NEWTON for name, force in forces.items()}
    w.over_cycle("t_forces", c.steps(len(phi)), {"φ, °": phi, "p": c.pressure / 1e6, **kn, "M": f.torque})
    along = (("l_gas", m.gas, 1), ("l_inertia", inertia, 2), ("l_sum", f.P, 0))
    w.chart(
        "f_P",
        "x_phi",
        "y_kN",
        [PlottedLine(phi, y * KILONEWTONS_PER_NEWTON, w.say(key), look) for key, y, look in along],
        ticks=60,
    )
    w.chart("f_NS", "x_phi", "y_kN", plotted_lines(phi, {n: kn[n] for n in "SN"}), ticks=60)
    w.chart("f_TK", "x_phi", "y_kN", plotted_lines(phi, {n: kn[n] for n in "TK"}), ticks=60)
    _write_polar_diagram(w, c)
    load = np.abs(f.on_pin) * KILONEWTONS_PER_NEWTON
    frame = np.abs(f.on_crank_from_frame) * KILONEWTONS_PER_NEWTON
    i = frame.argmax()
    j = load.argmax()
    largest = {"force": frame[i], "force_deg": phi[i], "pin": load[j], "pin_deg": phi[j]}
    w.write("bearing", SimpleNamespace(**largest, mean=np.mean(load[:-1])))


def _write_polar_diagram(w: ChapterWriter, c: Calculation) -> None:
    f = c.forces
    phi = c.motion.phi_deg
    far = largest_magnitude(f.on_pin) * KILONEWTONS_PER_NEWTON
    notes = []
    kept = list[complex]()
    for i in c.steps(len(phi) - 1):
        at = complex(-f.K[i] * KILONEWTONS_PER_NEWTON, f.T[i] * KILONEWTONS_PER_NEWTON)
        clear = all(abs(at - other) > 0.1 * far for other in kept)
        if clear:
            kept.append(at)
        notes.append((at.real, at.imag, f"{phi[i]:g}°" if clear else ""))
    curve = tuple(plotted_lines(-f.K * KILONEWTONS_PER_NEWTON, {"": f.T * KILONEWTONS_PER_NEWTON}))
    w.figure("f_polar", Chart(w.say("x_out"), w.say("y_T"), curve, tuple(notes), equal=True, height_mm=95))


def _write_torque(w: ChapterWriter, c: Calculation) -> None:
    work = c.work
    phi = c.motion.phi_deg
    cycle = str(len(c.given.indicator.names))
    v = text_values_at_angle(
        c, worked_force_angle_deg(c), uneven=c.given.speed.unevenness, cycle=cycle, takes=work.mean < 0
    )
    v.both = work.gas + work.friction
    v.power = work.power * 1e-3
    w.write("torque", v)
    torques = {"M": c.forces.torque, w.say("l_mean"): np.full_like(phi, work.mean)}
    w.chart("f_torque", "x_phi", "y_M", plotted_lines(phi, torques), ticks=60)
    w.write("flywheel", v)
    w.chart("f_excess", "x_phi", "y_J", plotted_lines(phi, {"": work.curve}), ticks=60, height_mm=50)
