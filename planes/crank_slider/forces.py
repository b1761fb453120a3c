"""Kinetostatics in closed form: the text's (17)–(26) corrected, the replacement masses, torque and work.

The text's moment equation lacks the crank's torque, and its balance of the rod lacks the vertical force in B; here the
slider's push N follows from moments of rod and slider about A, then all the others by adding up forces.
"""

import math

import numpy as np

from planes.crank_slider.kinematics import EngineCycle, RodMotion, largest_magnitude, rod_inclination
from planes.crank_slider.shape import CrankSliderShape
from planes.geometry.arrays import Array, ArrayPair, Complexes
from planes.geometry.plane import cross
from planes.words.frozen import frozen


@frozen
class CycleForces:
    """All forces over the cycle, N; complex ones in frame axes.

    P: gas, inertia and friction on the slider, towards the crank; N: push of the guide, up;
    S: compression of the rod at B; T: on the crank pin along its motion; K: on the crank pin towards the pivot.
    """

    P: Array
    N: Array
    S: Array
    T: Array
    K: Array
    rubbing: Array
    on_rod_at_b: Complexes
    on_pin: Complexes
    on_crank_from_frame: Complexes
    torque: Array


def forces_over_cycle(shape: CrankSliderShape, m: EngineCycle, way: RodMotion) -> CycleForces:
    """Every force from one moment equation and two sums."""
    beta = rod_inclination(shape, m.phi)
    along = -m.gas - shape.m3 * way.a["B"].real
    inertia = -shape.m2 * way.a["C"] - 1j * shape.m2 * shape.g
    arm = shape.c * np.exp(-1j * beta)
    own = (cross(arm, inertia) - shape.j2 * way.epsilon) / (shape.l * np.cos(beta))
    push, rub = _guide_reaction_and_friction(shape, way, along, own, beta)
    on_rod = along + rub + 1j * (push - shape.m3 * shape.g)
    on_pin = on_rod + inertia
    turned = on_pin * np.exp(-1j * m.phi)
    pull = np.exp(1j * m.phi)
    crank = shape.m1 * (-(shape.s * (1j * m.epsilon - m.omega**2) * pull) - 1j * shape.g)
    spin = shape.s * cross(pull, crank) - shape.j1 * m.epsilon
    return CycleForces(
        P=-along - rub,
        N=push,
        S=-(on_rod * np.exp(1j * beta)).real,
        T=turned.imag,
        K=-turned.real,
        rubbing=rub,
        on_rod_at_b=on_rod,
        on_pin=on_pin,
        on_crank_from_frame=-on_pin - crank,
        torque=turned.imag * shape.r + spin,
    )


def _guide_reaction_and_friction(
    shape: CrankSliderShape, way: RodMotion, along: Array, own: Array, beta: Array
) -> ArrayPair:
    """N and the friction: N(1 − σ·s·f·tan β) = m₃g − P-part·tan β − own, with σ the bearing side, s the sense of
    sliding."""
    speed = way.v["B"].real
    sense = np.where(np.abs(speed) > 1e-12 * largest_magnitude(speed), np.sign(speed), 0.0)
    slope = np.tan(beta)
    still = shape.m3 * shape.g - along * slope - own
    tangent = shape.f * sense * slope
    up = still / (1.0 - tangent)
    push = np.where(up >= 0.0, up, still / (1.0 + tangent))
    return push, -shape.f * sense * np.abs(push)


@frozen
class Replacement:
    """The rod as two point masses (A, B) and as three (A, C, B), kg; the error of the first in kg·m²."""

    at_a: float
    at_b: float
    inertia: float
    error: float
    three: tuple[float, float, float]

    @property
    def percent(self) -> float:
        """The error of the moment of inertia, per cent of the true one."""
        return 100.0 * self.error / (self.inertia - self.error)


def replacement_masses(shape: CrankSliderShape) -> Replacement:
    """Masses with the rod's total and mass centre; the three also have its moment of inertia."""
    b = shape.l - shape.c
    at_a = shape.m2 * b / shape.l
    at_b = shape.m2 * shape.c / shape.l
    two = shape.m2 * shape.c * b
    if shape.c <= 1e-12 or b <= 1e-12:
        three = (at_a, shape.j2 / shape.l**2, at_b)
    else:
        outer = shape.j2 / (shape.c * shape.l), shape.j2 / (b * shape.l)
        three = (outer[0], shape.m2 - sum(outer), outer[1])
    return Replacement(at_a, at_b, two, two - shape.j2, three)


def classical_forces(shape: CrankSliderShape, m: EngineCycle, way: RodMotion) -> CycleForces:
    """The usual engine formulas: the rod as two point masses, no weights; P, N = P·tan β, S = P/cos β, T, K by φ +
    β."""
    beta = rod_inclination(shape, m.phi)
    parts = replacement_masses(shape)
    p = m.gas + (shape.m3 + parts.at_b) * way.a["B"].real
    n = p * np.tan(beta)
    s = p / np.cos(beta)
    t = p * np.sin(m.phi + beta) / np.cos(beta)
    k = p * np.cos(m.phi + beta) / np.cos(beta)
    k = k - parts.at_a * m.omega**2 * shape.r  # the rod's rotating mass pulls the pin outwards
    t = t - parts.at_a * m.epsilon * shape.r
    zero = np.zeros_like(p)
    on_pin = (-k + 1j * t) * np.exp(1j * m.phi)
    return CycleForces(
        p,
        n,
        s,
        T=t,
        K=k,
        rubbing=zero,
        on_rod_at_b=-p + 1j * n,
        on_pin=on_pin,
        on_crank_from_frame=-on_pin,
        torque=t * shape.r,
    )


@frozen
class CycleWork:
    """Mean torque, unevenness of torque, works of a cycle (J), powers (W), the flywheel."""

    mean: float
    largest: float
    smallest: float
    unevenness: float
    gas: float
    friction: float
    torque: float
    excess: float
    flywheel: float
    power: float
    indicated: float
    mean_pressure: float
    curve: Array


def work_over_cycle(
    shape: CrankSliderShape, m: EngineCycle, way: RodMotion, f: CycleForces, bore: float, allowed: float
) -> CycleWork:
    """Works by integrals over the crank's angle; A = ∮M dφ must equal ∮F dx of gas and friction."""
    cycle = float(m.phi[-1] - m.phi[0])
    drop = np.where(m.omega > 0, way.v["B"].real / m.omega, 0.0)  # dx_B/dφ
    gas = float(np.trapezoid(-m.gas * drop, m.phi))
    total = float(np.trapezoid(f.torque, m.phi))
    mean = total / cycle
    rest = f.torque - mean
    steps = np.diff(m.phi) * (rest[1:] + rest[:-1]) / 2
    curve = np.concatenate([[0.0], np.cumsum(steps)])
    excess = float(curve.max() - curve.min())
    high = float(f.torque.max())
    low = float(f.torque.min())
    seconds = cycle / shape.omega
    return CycleWork(
        mean=mean,
        largest=high,
        smallest=low,
        unevenness=(high - low) / abs(mean) if mean else math.inf,
        gas=gas,
        friction=float(np.trapezoid(f.rubbing * drop, m.phi)),
        torque=total,
        excess=excess,
        flywheel=excess / (allowed * shape.omega**2),
        power=total / seconds,
        indicated=gas / seconds,
        mean_pressure=gas / (math.pi / 4 * bore**2 * 2 * shape.r),
        curve=curve,
    )


@frozen
class PrintedEquations:
    """R_B by (22), T by (25), K by (26), J_C by (20), as printed; N and kg·m². Signs of T, K as in ``CycleForces``."""

    R_B: float
    T: float
    K: float
    J_C: float


def equations_as_printed(
    shape: CrankSliderShape, m: EngineCycle, way: RodMotion, f: CycleForces, k: int
) -> PrintedEquations:
    """The text's equations at step ``k``: (22) lacks the crank's torque, (25), (26) the vertical force in B."""
    at_c = complex(way.r["C"][k])
    inertia = -shape.m2 * complex(way.a["C"][k])
    sin = np.sin(m.phi[k])
    cos = np.cos(m.phi[k])
    g1, g2, g3 = (mass * shape.g for mass in (shape.m1, shape.m2, shape.m3))
    weights = -g1 * shape.s * cos - g2 * at_c.real
    p = float(f.P[k])
    moments = weights + at_c.real * inertia.imag - at_c.imag * inertia.real - shape.j2 * float(way.epsilon[k])
    t = -g2 * cos + p * sin - inertia.real * sin + inertia.imag * cos
    out = -g2 * sin + inertia.imag * sin + inertia.real * cos - p * cos
    return PrintedEquations(
        g3 - moments / float(way.r["B"][k].real), float(t), -float(out), 4 / 9 * shape.m2 * shape.l**2
    )
