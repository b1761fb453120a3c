"""Kinematics and forces of the integrated calculation: two closed ways, the general plans, and free bodies."""

from __future__ import annotations

import dataclasses
import math

import mpmath
import numpy as np
import pytest

from planes.crank_slider.forces import classical_forces, equations_as_printed, forces_over_cycle, replacement_masses
from planes.crank_slider.given import monotone_cubic
from planes.crank_slider.kinematics import EngineCycle, motion_by_coordinates, motion_by_instant_centre, rod_inclination
from planes.crank_slider.shape import CrankSliderShape
from tests.helpers.crank_slider_scenes import SAMPLE, calculated, changed, two_stroke

VARYING = ("  flywheel:", "  speed: {unevenness: 0.1, waves: 2, phase: 40}\n  flywheel:")
MASSLESS = CrankSliderShape(
    "1", "2", "3", "O", "A", "B", "C", 0.1, 0.35, 0.105, 0.1, 20 / 9.81, 1e-15, 25 / 9.81, 0.0, 1e-15, 9.81, 0.0, 30.0
)


def still(phi_rad: float, omega: float = 30.0, epsilon: float = 0.0, gas: float = 0.0) -> EngineCycle:
    one = np.ones(1)
    return EngineCycle(np.degrees(phi_rad) * one, omega * one, epsilon * one, gas * one)


@pytest.mark.parametrize(
    "text, variant",
    [
        (SAMPLE, None),
        (SAMPLE, "А"),
        (SAMPLE, "Б"),
        (changed(VARYING), None),
        (two_stroke(), None),
        (changed(("friction: {x-x: 0.08}", "friction: {x-x: 0}")), None),
        (changed(("l: 0.21", "l: 0.0605")), None),  # a rod hardly longer than the crank
        (changed(("0.3*l", "0.85*l"), ("inertia: 0.0145", "inertia: 0.05"), VARYING), None),
        (changed(("step: 1 ", "step: 0.5 ")), None),
    ],
)
def test_the_closed_forms_equal_the_general_plans_over_the_cycle(text, variant):
    c = calculated(text if "0.0605" not in text else text.split("crank_slider:")[0] + _bare(text), variant)
    for part in (c.agreement.velocity, c.agreement.acceleration, c.agreement.omega, c.agreement.epsilon):
        assert max(part.values()) <= 1e-10
    assert c.agreement.forces <= 1e-10
    assert c.agreement.torque <= 1e-10
    assert c.agreement.lever <= 1e-10


def _bare(text: str) -> str:
    """The section without parts, which a mechanism as extreme as this would break."""
    start, end = text.index("crank_slider:"), text.index("  # коленчатый вал на опорах")
    return text[start:end]


@pytest.mark.parametrize("phi", [0.3, 1.9, 3.4, 5.1])
def test_motion_is_the_derivative_of_the_coordinates(phi):
    """φ(t) = φ₀ + 30 t + 100 t²: ω = 30, ε = 200 at t = 0. Coordinates (1) are differentiated in 40 digits."""
    shape, m = MASSLESS, still(phi, 30.0, 200.0)
    mpmath.mp.dps = 40

    def angle(t):
        return phi + 30 * t + 100 * t**2

    def x_b(t):
        return shape.r * mpmath.cos(angle(t)) + mpmath.sqrt(shape.l**2 - (shape.r * mpmath.sin(angle(t))) ** 2)

    def y_c(t):
        return (1 - shape.c / shape.l) * shape.r * mpmath.sin(angle(t))

    def beta(t):
        return mpmath.asin(shape.r * mpmath.sin(angle(t)) / shape.l)

    for way in (motion_by_coordinates(shape, m), motion_by_instant_centre(shape, m)):
        assert way.v["B"][0].real == pytest.approx(float(mpmath.diff(x_b, 0)), rel=1e-12)
        assert way.a["B"][0].real == pytest.approx(float(mpmath.diff(x_b, 0, 2)), rel=1e-12)
        assert way.a["C"][0].imag == pytest.approx(float(mpmath.diff(y_c, 0, 2)), rel=1e-12)
        assert way.omega[0] == pytest.approx(float(-mpmath.diff(beta, 0)), rel=1e-12)
        assert way.epsilon[0] == pytest.approx(float(-mpmath.diff(beta, 0, 2)), rel=1e-12)


def centre_speed(shape, m):
    """|v_C| by (7), the distance to the instant centre times ω_AB, written without dividing by cos φ."""
    beta, c = rod_inclination(shape, m.phi), shape.c
    ap = shape.l * np.cos(beta)  # AP·cos φ
    cos = np.cos(m.phi)
    square = (c * cos) ** 2 + ap**2 - 2 * c * cos * ap * np.cos(beta + m.phi)
    return np.abs(m.omega) * shape.r / ap * np.sqrt(np.maximum(square, 0.0))


def test_the_instant_centre_gives_the_speed_of_c_even_across_the_guide():
    """At φ = 90° the centre is infinitely far, the rod moves without turning: v_C = v_A = ωr."""
    m = EngineCycle(np.linspace(0, 360, 73), np.full(73, 30.0), np.zeros(73), np.zeros(73))
    assert np.abs(centre_speed(MASSLESS, m) - np.abs(motion_by_coordinates(MASSLESS, m).v["C"])).max() < 1e-13
    assert centre_speed(MASSLESS, m)[18] == pytest.approx(30 * 0.1, rel=1e-15)


def test_forces_satisfy_the_equilibrium_of_every_free_body():
    """Without friction the nine sums (three a link) are linear in X_O Y_O X_A Y_A X_B Y_B N and the crank's couple.

    The moment of the slider about B is zero by itself, so eight equations are left. Solved afresh by numpy.
    """
    c = calculated(changed(("friction: {x-x: 0.08}", "friction: {x-x: 0}"), VARYING))
    s, w = c.given.shape, c.points
    for k in range(0, len(c.motion.phi_deg), 37):
        a, b, g = complex(w.r["A"][k]), complex(w.r["B"][k]), complex(w.r["C"][k])
        crank = s.m1 * (-s.s / s.r * complex(w.a["A"][k]) - 1j * s.g)
        rod, gas = s.m2 * (-complex(w.a["C"][k]) - 1j * s.g), float(c.motion.gas[k])
        centre = s.s / s.r * a
        rows, rest = np.zeros((8, 8)), np.zeros(8)
        # unknowns: 0, 1 frame on crank; 2, 3 crank on rod; 4, 5 rod on slider; 6 guide; 7 couple on the crank
        rows[0, [0, 2]], rows[1, [1, 3]] = (1, -1), (1, -1)
        rest[0:2] = crank.real, crank.imag
        rows[2, [2, 3, 7]] = a.imag, -a.real, 1.0
        rest[2] = centre.real * crank.imag - centre.imag * crank.real
        rows[3, [2, 4]], rows[4, [3, 5]] = (1, -1), (1, -1)
        rest[3:5] = rod.real, rod.imag
        rows[5, [4, 5]] = (b - a).imag, -(b - a).real
        rest[5] = (g - a).real * rod.imag - (g - a).imag * rod.real - s.j2 * float(w.epsilon[k])
        rows[6, 4], rows[7, [5, 6]] = 1.0, (1, 1)
        rest[6], rest[7] = -gas - s.m3 * float(w.a["B"][k].real), -s.m3 * s.g
        x = np.linalg.solve(rows, -rest)
        size = np.abs(c.forces.on_pin).max()
        assert abs(complex(x[2], x[3]) + c.forces.on_pin[k]) < 1e-11 * size
        assert abs(x[6] - c.forces.N[k]) < 1e-11 * size
        assert abs(complex(x[0], x[1]) - c.forces.on_crank_from_frame[k]) < 1e-11 * size
        assert abs(-x[7] - c.forces.torque[k]) < 1e-11 * size


def test_the_text_is_wrong_by_hand_worked_numbers():
    """r = 0.1, l = 0.35, ω = 30, φ = 0.7 rad, no mass in the rod, F = 1000 N, G3 = 25 N, G1 = 20 N in A.

    sin β = 0.1·sin 0.7/0.35 = 0.184062, tan β = 0.187262. a_B = −900·(0.1·cos 0.7 + 0.01·cos 1.4/0.344019 +
    1e-4·(sin 0.7·cos 0.7)²/0.344019³) = −73.80, so P = 1000 − 25/9.81·73.80 = 811.9, N_B = P·tan β = 152.03 and
    R_B = N_B + G3 = 177.03. T = P·sin(φ+β)/cos β = 639.3, K = P·cos(φ+β)/cos β = 523.0. The crank's torque is
    T·r − G1·x_A = 63.93 − 1.53 = 62.40. The printed (22), (25), (26) give 28.64, 523.0, 621.0.
    """
    m = still(0.7, gas=1000.0)
    way = motion_by_instant_centre(MASSLESS, m)
    f = forces_over_cycle(MASSLESS, m, way)
    assert f.P[0] * math.tan(math.asin(0.1 * math.sin(0.7) / 0.35)) == pytest.approx(152.03, abs=0.01)
    assert f.N[0] == pytest.approx(177.03, abs=0.01)
    assert (f.T[0], f.K[0]) == (pytest.approx(639.3, abs=0.05), pytest.approx(523.0, abs=0.05))
    assert f.torque[0] == pytest.approx(62.40, abs=0.01)
    wrong = equations_as_printed(MASSLESS, m, way, f, 0)
    assert pytest.approx(28.64, abs=0.01) == wrong.R_B
    assert (pytest.approx(523.0, abs=0.05), pytest.approx(621.0, abs=0.05)) == (wrong.T, wrong.K)


def test_the_usual_formulas_hold_where_the_rod_is_two_points():
    """With J_C = m·AC·CB, no weights and no friction the rod *is* two points, so both calculations agree."""
    c = calculated(changed(("friction: {x-x: 0.08}", ""), ("gravity: 9.81", "")))
    shape = dataclasses.replace(c.given.shape, j2=c.given.shape.m2 * 0.063 * 0.147)
    assert replacement_masses(shape).error == pytest.approx(0.0, abs=1e-15)
    exact, simple = forces_over_cycle(shape, c.motion, c.plane), classical_forces(shape, c.motion, c.plane)
    for name in ("N", "T", "K"):
        assert np.abs(getattr(exact, name) - getattr(simple, name)).max() < 1e-9 * np.abs(exact.K).max()


def test_the_rod_is_replaced_by_two_and_three_points():
    """m = 1.8 at AC = 0.063 of 0.21: m_A = 1.8·0.7 = 1.26, m_B = 0.54; J of two points 1.8·0.063·0.147 = 0.0166698,
    so 0.0021698 too much (14.96 %). Three points: 0.0145/(0.063·0.21) = 1.09599, 0.0145/(0.147·0.21) = 0.46971,
    the rest 0.23429; 1.09599·0.063² + 0.46971·0.147² = 0.0145.
    """
    parts = calculated().parts
    assert (parts.at_a, parts.at_b) == (pytest.approx(1.26), pytest.approx(0.54))
    assert parts.error == pytest.approx(0.0021698)
    assert parts.percent == pytest.approx(14.964, abs=1e-3)
    assert parts.three == (
        pytest.approx(1.09599, abs=1e-5),
        pytest.approx(0.23429, abs=1e-5),
        pytest.approx(0.46971, abs=1e-5),
    )
    assert parts.three[0] * 0.063**2 + parts.three[2] * 0.147**2 == pytest.approx(0.0145)


@pytest.mark.parametrize("text", [SAMPLE, changed(VARYING), two_stroke()])
def test_the_torque_does_the_work_of_gas_and_friction(text):
    """Over a cycle the kinetic energy and the heights come back, so ∮M dφ = ∮F dx_B of gas and friction."""
    w = calculated(text).work
    assert w.torque == pytest.approx(w.gas + w.friction, rel=1e-9)
    assert w.friction < 0 < w.gas
    assert w.flywheel == pytest.approx(w.excess / (0.02 * 188.5**2))


@pytest.mark.needs("scipy")
def test_the_diagram_is_monotone_between_its_points():
    """The same cubic as scipy's PCHIP, and no pressure outside the two neighbouring points."""
    from scipy.interpolate import PchipInterpolator

    x, p = [0, 0.015, 0.04, 0.08, 0.15, 0.25, 0.4, 1], [2.9, 4.3, 4.8, 4.1, 2.75, 1.72, 1.04, 0.26]
    at = np.linspace(0, 1, 2001)
    assert np.abs(monotone_cubic(x, p)(at) - PchipInterpolator(x, p)(at)).max() < 1e-14
    for a, b in zip(range(7), range(1, 8), strict=True):
        inside = monotone_cubic(x, p)(at[(at >= x[a]) & (at <= x[b])])
        assert min(p[a], p[b]) - 1e-12 <= inside.min() <= inside.max() <= max(p[a], p[b]) + 1e-12


def test_the_diagram_follows_its_strokes():
    c = calculated()
    mpa = c.pressure / 1e6
    for phi, p in ((0, 0.11), (180, 0.09), (360, 2.9), (540, 0.26), (720, 0.11)):
        assert mpa[c.at(phi)] == pytest.approx(p)
    assert c.motion.gas[c.at(360)] == pytest.approx((2.9 - 0.1) * 1e6 * math.pi / 4 * 0.01)
    two = calculated(two_stroke())
    assert (two.motion.phi_deg[0], two.motion.phi_deg[-1]) == (180.0, 540.0)
    assert two.pressure[two.at(360)] == pytest.approx(40e5)
