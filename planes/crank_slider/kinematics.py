"""Motion of A, B, C over the cycle in three ways, every crank angle at once: by the general plans (one program), and by
the two ways of the text, as points (1)–(3) and as plane motion of the rod (4)–(13).

The text's (3) holds for steady rotation only; here it has the terms with ε too. Its (5) and (7) are 0·∞ where the crank
is perpendicular to the guide (cos φ = 0); here ω_AB is taken from (5*), which has no such position.
"""

from typing import Any

import numpy as np

from planes.crank_slider.shape import CrankSliderShape
from planes.drafting.drawing import Drawing, draw_program
from planes.geometry.arithmetic import Shape
from planes.geometry.arrays import Array, Complexes
from planes.plans import Plans, plans_of
from planes.plans.scales import unit_scales_of_plans
from planes.scene import Scene
from planes.scene.mechanism import Load, Mechanism
from planes.words import Phrase
from planes.words.errors import SceneError
from planes.words.frozen import frozen, replace
from planes.words.names import scheme_mark

ByPoint = dict[str, Complexes]  # A, B, C


@frozen
class EngineCycle:
    """Angle, ω, ε of the crank and the gas force on the piston (N, + towards the crank) at every step of the cycle."""

    phi_deg: Array
    omega: Array
    epsilon: Array
    gas: Array

    @property
    def phi(self) -> Array:
        """φ in radians."""
        return np.radians(self.phi_deg)


@frozen
class RodMotion:
    """Places, velocities, accelerations of A, B, C as complex numbers; ω_AB, ε_AB, counter-clockwise positive."""

    r: ByPoint
    v: ByPoint
    a: ByPoint
    omega: Array
    epsilon: Array


@frozen
class DrawnRodMotion(RodMotion):
    """Results of the plans, SI, places from the crank's pivot; a force acts on the first-named link.

    ``push`` is the normal push of the guide on the slider, up positive; ``torque`` the moment delivered by the crank.
    """

    on_rod_from_crank: Complexes
    on_slider_from_rod: Complexes
    push: Array
    on_crank_from_frame: Complexes
    torque: Array
    lever: Array


def with_gas_force(mechanism: Mechanism, shape: CrankSliderShape, gas: float = 0.0) -> Mechanism:
    """The mechanism with the gas force on its slider, towards the crank."""
    return replace(mechanism, loads=(Load(shape.slider, "force", gas, shape.hinge, 180.0),))


def draw_cycle_plans(scene: Scene, shape: CrankSliderShape, motion: EngineCycle) -> DrawnRodMotion:
    """Draw the plans of every position in the cycle."""
    assert scene.mechanism is not None
    plans = plans_of(with_gas_force(scene.mechanism, shape), scene.file)
    moved = {
        plans.drive_given_name: motion.phi_deg,
        f"omega_{shape.crank}": motion.omega,
        f"epsilon_{shape.crank}": motion.epsilon,
        f"P_{shape.slider}_given": motion.gas,
    }
    drawing = draw_program(plans.program, {**plans.given, **unit_scales_of_plans(plans), **moved})
    drawn = _read_drawn_plans(plans, drawing, shape, np.shape(motion.phi_deg))
    _check_drawn_plans(scene, shape, motion, drawn)
    return drawn


def _read_drawn_plans(plans: Plans, drawing: Drawing, shape: CrankSliderShape, size: Shape) -> DrawnRodMotion:
    def mark(name: str) -> Complexes:
        return np.broadcast_to(np.asarray(drawing[name], complex), size)

    def value(name: str) -> Array:
        return np.broadcast_to(np.asarray(drawing[name], float), size)

    def force(on: str, by: str) -> Complexes:
        r = next(r for r in plans.reactions.values() if {r.pair.link, r.pair.other} == {on, by})
        way = mark(r.end) - mark(r.start)
        return way if r.pair.link == on else -way

    points = {"A": shape.pin, "B": shape.hinge, "C": shape.centre, "S": plans.mechanism.links[shape.crank].mass_centre}
    pivot = mark(scheme_mark(shape.pivot))
    return DrawnRodMotion(
        r={k: mark(plans.points[p].position) - pivot for k, p in points.items()},
        v={k: mark(plans.points[p].velocity) for k, p in points.items()},
        a={k: mark(plans.points[p].acceleration) for k, p in points.items()},
        omega=value(plans.links[shape.rod].omega),
        epsilon=value(plans.links[shape.rod].epsilon),
        on_rod_from_crank=force(shape.rod, shape.crank),
        on_slider_from_rod=force(shape.slider, shape.rod),
        push=force(shape.slider, "0").imag,
        on_crank_from_frame=force(shape.crank, "0"),
        torque=-value(plans.balancing),
        lever=-value(plans.zhukovsky),
    )


def _check_drawn_plans(scene: Scene, shape: CrankSliderShape, motion: EngineCycle, drawn: DrawnRodMotion) -> None:
    bad = ~np.isfinite(drawn.torque) | ~np.isfinite(drawn.r["B"])
    if bad.any():
        phi = float(motion.phi_deg[bad.argmax()])
        words = Phrase("cs_locked", phi=phi, f=shape.f) if shape.f else Phrase("cs_engine", phi=phi)
        raise SceneError(words, scene.file)
    if (drawn.r["B"].real < drawn.r["A"].real).any():
        raise SceneError(Phrase("cs_behind", point=shape.hinge), scene.file)


def rod_inclination(shape: CrankSliderShape, phi: Array) -> Array:
    """β: the inclination of the rod, downwards from A to B."""
    return np.arcsin(shape.r * np.sin(phi) / shape.l)


def motion_by_coordinates(shape: CrankSliderShape, m: EngineCycle) -> RodMotion:
    """Coordinates (1), differentiated once (2) and twice (3)."""
    r, l, k = shape.r, shape.l, shape.c / shape.l  # noqa: E741
    sin = np.sin(m.phi)
    cos = np.cos(m.phi)
    w = m.omega
    e = m.epsilon
    x = r * cos
    y = r * sin
    across = 1j * (1 - k) * r
    root = np.sqrt(l**2 - r**2 * sin**2)
    drop = -(r**2) * sin * cos / root  # d root / dφ
    bend = -(r**2) * (cos**2 - sin**2) / root - (r**2 * sin * cos) ** 2 / root**3
    place = {"A": r * (cos + 1j * sin), "B": (x + root).astype(complex), "C": x + k * root + across * sin}
    first = {"A": r * (-sin + 1j * cos), "B": -y + drop + 0j, "C": -y + k * drop + across * cos}
    second = {"A": -r * (cos + 1j * sin), "B": -x + bend + 0j, "C": -x + k * bend - across * sin}
    turn = -x / root  # dβ/dφ with the sign of the rod's rotation
    speed = w * turn
    rate = e * turn + w**2 * (y / root + x * drop / root**2)
    velocities = {n: w * first[n] for n in first}
    return RodMotion(place, velocities, {n: w**2 * second[n] + e * first[n] for n in second}, speed, rate)


def motion_by_instant_centre(shape: CrankSliderShape, m: EngineCycle) -> RodMotion:
    """Instant centre and the theorem on accelerations: (5*)–(7), (9)–(13)."""
    r, l, c = shape.r, shape.l, shape.c  # noqa: E741
    phi = m.phi
    beta = rod_inclination(shape, m.phi)
    w = m.omega
    e = m.epsilon
    sin_phi = np.sin(phi)
    cos_phi = np.cos(phi)
    sin_beta = np.sin(beta)
    cos_beta = np.cos(beta)
    turning = w * r * cos_phi / (l * cos_beta)  # (5*), clockwise positive
    normal, tangent = w**2 * r, e * r  # (8)
    normal_b = turning**2 * l  # (9)
    left = normal * cos_phi + tangent * sin_phi
    down = normal * sin_phi - tangent * cos_phi
    tangent_b = (down - normal_b * sin_beta) / cos_beta  # (11)
    share = c / l
    a_b = left + normal_b * cos_beta - tangent_b * sin_beta
    a_cx = left + share * (normal_b * cos_beta - tangent_b * sin_beta)  # (13)
    a_cy = down - share * (normal_b * sin_beta + tangent_b * cos_beta)
    place = r * np.exp(1j * phi)
    reach = l * np.exp(-1j * beta)
    r_of = {"A": place, "B": place + reach, "C": place + share * reach}
    v_a = 1j * w * place
    v_b = (-w * r * np.sin(beta + phi) / cos_beta).astype(complex)  # (6)
    v_c = v_a - 1j * turning * share * reach
    a_of = {"A": -left - 1j * down, "B": -a_b + 0j, "C": -a_cx - 1j * a_cy}
    return RodMotion(r_of, {"A": v_a, "B": v_b, "C": v_c}, a_of, -turning, tangent_b / l)


def acceleration_as_printed(shape: CrankSliderShape, m: EngineCycle) -> Complexes:
    """a_B by the text's (3) as printed, without the terms with ε: its error where ω varies."""
    still = EngineCycle(m.phi_deg, m.omega, np.zeros_like(m.epsilon), m.gas)
    return motion_by_coordinates(shape, still).a["B"]


def largest_relative_difference(one: ByPoint, other: ByPoint, unit: float) -> float:
    """The largest difference of two methods over all points and angles, relative to ``unit``."""
    return max(largest_magnitude(one[n] - other[n]) for n in "ABC") / unit


def largest_magnitude(numbers: np.ndarray[Any, Any]) -> float:
    """The largest magnitude over the cycle."""
    return float(np.abs(numbers).max())
