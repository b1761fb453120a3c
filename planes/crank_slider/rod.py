"""The rod (compression, bending by its own inertia, buckling) and the piston pin (bending, shear, pressure)."""

import math

import numpy as np

from planes.crank_slider.forces import CycleForces
from planes.crank_slider.given import PistonPin
from planes.crank_slider.kinematics import EngineCycle, RodMotion, rod_inclination
from planes.crank_slider.parts import Material, Shank
from planes.crank_slider.shaft import MEGAPASCALS_PER_PASCAL, safety_factor
from planes.crank_slider.shape import CrankSliderShape
from planes.geometry.arrays import Array
from planes.words.frozen import frozen


@frozen
class Buckling:
    """One plane: the length factor μ, slenderness, critical stress (MPa), whether by Euler, safety factor."""

    mu: float
    slenderness: float
    critical: float
    euler: bool
    n: float


@frozen
class RodStrength:
    """Forces in N, moments in N·m, stresses in MPa."""

    squeezed: float
    squeezed_deg: float
    pulled: float
    pulled_deg: float
    sigma_c: float
    sigma_p: float
    bending: float
    bending_deg: float
    sigma_b: float
    sigma: float
    sigma_deg: float
    n: float
    limit: float  # slenderness above which Euler's formula holds
    planes: tuple[Buckling, Buckling]


@frozen
class PinStrength:
    """The largest force on the pin (N), moment (N·m), stresses and pressures (MPa), factors."""

    force: float
    force_deg: float
    moment: float
    sigma: float
    tau: float
    equivalent: float
    n: float
    bush: float
    boss: float


def rod_strength(
    shape: CrankSliderShape, m: EngineCycle, way: RodMotion, f: CycleForces, shank: Shank, steel: Material
) -> RodStrength:
    """Stresses of the shank over the cycle; compression positive."""
    beta = rod_inclination(shape, m.phi)
    at_b = f.S
    at_a = -(f.on_pin * np.exp(1j * beta)).real
    large = np.where(np.abs(at_b) >= np.abs(at_a), at_b, at_a)
    moment = _largest_bending_moment(shape, way, beta)
    sigma_b = moment / shank.modulus * MEGAPASCALS_PER_PASCAL
    both = np.abs(large) / shank.area * MEGAPASCALS_PER_PASCAL + sigma_b
    push, pull, bend, worst = (x.argmax() for x in (large, -large, moment, both))
    squeezed = max(float(large[push]), 0.0)
    pulled = max(float(-large[pull]), 0.0)
    stress = squeezed / shank.area * MEGAPASCALS_PER_PASCAL
    limit = math.pi * math.sqrt(2 * steel.elasticity / steel.yields)
    freely, held = (math.sqrt(j / shank.area) for j in (shank.inertia, shank.inertia_across))
    return RodStrength(
        squeezed=squeezed,
        squeezed_deg=float(m.phi_deg[push]),
        pulled=pulled,
        pulled_deg=float(m.phi_deg[pull]),
        sigma_c=stress,
        sigma_p=pulled / shank.area * MEGAPASCALS_PER_PASCAL,
        bending=float(moment[bend]),
        bending_deg=float(m.phi_deg[bend]),
        sigma_b=float(sigma_b[bend]),
        sigma=float(both[worst]),
        sigma_deg=float(m.phi_deg[worst]),
        n=safety_factor(steel.yields, float(both[worst])),
        limit=limit,
        planes=(
            _buckling_in_plane(1.0, shape.l, freely, limit, stress, steel),
            _buckling_in_plane(0.5, shape.l, held, limit, stress, steel),
        ),
    )


def _largest_bending_moment(shape: CrankSliderShape, way: RodMotion, beta: Array) -> Array:
    """The largest moment along a rod of uniform mass, hinged at both ends, under its transverse inertia forces."""
    across = 1j * np.exp(-1j * beta)
    q_a, q_b = ((-(way.a[n] * across.conj()).real * shape.m2 / shape.l) for n in ("A", "B"))
    x = np.linspace(0.0, shape.l, 201)[:, None]
    largest: Array = np.abs(beam_moment_at(q_a, q_b, x, shape.l)).max(axis=0)
    return largest


def beam_moment_at(q_a: Array, q_b: Array, x: Array, length: float) -> Array:
    """M(x) of a hinged beam under a load that varies linearly from q_a to q_b (N/m)."""
    cube = x**3 / (6 * length)
    falling = length * x / 3 - x**2 / 2 + cube
    rising = length * x / 6 - cube
    return q_a * falling + q_b * rising


def _buckling_in_plane(
    mu: float, length: float, radius: float, limit: float, stress: float, steel: Material
) -> Buckling:
    slenderness = mu * length / radius
    euler = slenderness > limit
    if euler:
        critical = math.pi**2 * steel.elasticity / slenderness**2
    else:
        critical = steel.yields * (1 - steel.yields * slenderness**2 / (4 * math.pi**2 * steel.elasticity))
    return Buckling(mu, slenderness, critical, euler, safety_factor(critical, stress))


def pin_strength(m: EngineCycle, f: CycleForces, pin: PistonPin, steel: Material) -> PinStrength:
    """The pin as a beam: a uniform load from the rod's bush, loads from the bosses that fall to zero at its ends."""
    force = np.abs(f.on_rod_at_b)
    at = force.argmax()
    q = float(force[at])
    moment = q * (pin.length + 2 * pin.gap - 1.5 * pin.bush) / 12
    d = pin.section.d
    a = pin.section.bore / pin.section.d
    tau = 4 / 3 * q / 2 / pin.section.area * (1 + a + a**2) / (1 + a**2) * MEGAPASCALS_PER_PASCAL
    sigma = moment / pin.section.modulus * MEGAPASCALS_PER_PASCAL
    worst = max(sigma, 2 * tau)  # not at the same point: bending at the edge, shear at the middle
    bush = q / (d * pin.bush) * MEGAPASCALS_PER_PASCAL
    boss = q / (d * (pin.length - pin.gap)) * MEGAPASCALS_PER_PASCAL
    return PinStrength(
        q, float(m.phi_deg[at]), moment, sigma, tau, worst, safety_factor(steel.yields, worst), bush, boss
    )
