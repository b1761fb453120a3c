"""Motion of A, B, C by the two ways of the text: as points (1)–(3), and as plane motion of the rod (4)–(13).

The text's (3) holds for steady rotation only; here it has the terms with ε too. Its (5) and (7) are 0·∞ where the
crank stands across the guide (cos φ = 0); here ω_AB is taken from (5*), which has no such place.
"""

from __future__ import annotations

import numpy as np

from planes.crank_slider.engine import EngineCycle, RodMotion
from planes.crank_slider.shape import CrankSliderShape
from planes.geometry.arrays import Array, Complexes


def swing(shape: CrankSliderShape, phi: Array) -> Array:
    """β: how far the rod leans down from A to B."""
    return np.arcsin(shape.r * np.sin(phi) / shape.l)


def as_points(shape: CrankSliderShape, m: EngineCycle) -> RodMotion:
    """Coordinates (1), differentiated once (2) and twice (3)."""
    r, l, k = shape.r, shape.l, shape.c / shape.l  # noqa: E741
    sin, cos, w, e = np.sin(m.phi), np.cos(m.phi), m.omega, m.epsilon
    root = np.sqrt(l**2 - r**2 * sin**2)
    drop = -(r**2) * sin * cos / root  # d root / dφ
    bend = -(r**2) * (cos**2 - sin**2) / root - (r**2 * sin * cos) ** 2 / root**3
    place = {
        "A": r * (cos + 1j * sin),
        "B": (r * cos + root).astype(complex),
        "C": r * cos + k * root + 1j * (1 - k) * r * sin,
    }
    first = {"A": r * (-sin + 1j * cos), "B": -r * sin + drop + 0j, "C": -r * sin + k * drop + 1j * (1 - k) * r * cos}
    second = {"A": -r * (cos + 1j * sin), "B": -r * cos + bend + 0j, "C": -r * cos + k * bend - 1j * (1 - k) * r * sin}
    turn = -r * cos / root  # dβ/dφ with the sign of the rod's turning
    speed = w * turn
    rate = e * turn + w**2 * (r * sin / root + r * cos * drop / root**2)
    velocities = {n: w * first[n] for n in first}
    return RodMotion(place, velocities, {n: w**2 * second[n] + e * first[n] for n in second}, speed, rate)


def as_plane_motion(shape: CrankSliderShape, m: EngineCycle) -> RodMotion:
    """Instant centre and the theorem on accelerations: (5*)–(7), (9)–(13)."""
    r, l, c = shape.r, shape.l, shape.c  # noqa: E741
    phi, beta, w, e = m.phi, swing(shape, m.phi), m.omega, m.epsilon
    turning = w * r * np.cos(phi) / (l * np.cos(beta))  # (5*), clockwise positive
    normal, tangent = w**2 * r, e * r  # (8)
    normal_b = turning**2 * l  # (9)
    tangent_b = (normal * np.sin(phi) - tangent * np.cos(phi) - normal_b * np.sin(beta)) / np.cos(beta)  # (11)
    left = normal * np.cos(phi) + tangent * np.sin(phi)
    down = normal * np.sin(phi) - tangent * np.cos(phi)
    share = c / l
    a_b = left + normal_b * np.cos(beta) - tangent_b * np.sin(beta)
    a_cx = left + share * (normal_b * np.cos(beta) - tangent_b * np.sin(beta))  # (13)
    a_cy = down - share * (normal_b * np.sin(beta) + tangent_b * np.cos(beta))
    place = r * np.exp(1j * phi)
    reach = l * np.exp(-1j * beta)
    r_of = {"A": place, "B": place + reach, "C": place + share * reach}
    v_a = 1j * w * place
    v_b = (-w * r * np.sin(beta + phi) / np.cos(beta)).astype(complex)  # (6)
    v_c = v_a - 1j * turning * share * reach
    a_of = {"A": -left - 1j * down, "B": -a_b + 0j, "C": -a_cx - 1j * a_cy}
    return RodMotion(r_of, {"A": v_a, "B": v_b, "C": v_c}, a_of, -turning, tangent_b / l)


def text_acceleration(shape: CrankSliderShape, m: EngineCycle) -> Complexes:
    """a_B by the text's (3) as printed, without the terms with ε: how wrong it is when ω varies."""
    still = EngineCycle(m.phi_deg, m.omega, np.zeros_like(m.epsilon), m.gas)
    return as_points(shape, still).a["B"]


def apart(one: dict[str, Complexes], other: dict[str, Complexes], unit: float) -> float:
    """The largest difference of two ways over all points and angles, in parts of ``unit``."""
    return max(float(np.max(np.abs(one[n] - other[n]) / unit)) for n in ("A", "B", "C"))
