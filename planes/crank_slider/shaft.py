"""The crankshaft: its balancing by two counterweights, (27)–(30), and their effect on first-order forces; then as a
cranked bar on two supports, (31)–(34): reactions, moments, stresses, every angle at once.

z runs from the shaft's axis to the crank pin, y along the pin's motion, x along the shaft from bearing A to B; power is
taken off at B. The text's A′, B′ are opposite to z, A″, B″ to y. The rod's rotating mass is already in the pin's load
(the plans give that load in full), so Φ is of the crank's own masses alone. Fatigue, (35): the stress cycle at the
worst point on the edge of a round section.
"""

import math
from collections.abc import Mapping

import numpy as np

from planes.crank_slider.forces import CycleForces, replacement_masses
from planes.crank_slider.given import Concentration, Counterweights, Shaft
from planes.crank_slider.kinematics import DrawnRodMotion, EngineCycle
from planes.crank_slider.parts import Material, RoundPart
from planes.crank_slider.shape import CrankSliderShape
from planes.geometry.arrays import Array, Complexes
from planes.words.frozen import frozen

MEGAPASCALS_PER_PASCAL = 1e-6
Pair = tuple[float, float]  # of the two counterweights, or components


@frozen
class Shaking:
    """Inertia force of the whole machine on its frame with given counterweights, N.

    ``curve`` over one turn; amplitudes of its first harmonic along and across the guide, of the second along it;
    ``expected`` the same three by the formulas m·r·ω².
    """

    name: str
    static_moment: float
    curve: Complexes
    along: float
    across: float
    second: float
    expected: tuple[float, float, float]


@frozen
class Balance:
    """Masses in kg at the crank's radius, counterweights, the remaining unbalance."""

    rotating: float
    of_rod: float
    translating: float
    needed: Pair
    chosen: Pair
    force: float
    residual_force: float
    residual_moment: float
    left: float
    right: float
    cases: tuple[Shaking, ...]


def balance_rotating_masses(
    shape: CrankSliderShape, shaft: Shaft, weights: Counterweights, m: EngineCycle, drawn: DrawnRodMotion
) -> Balance:
    """Counterweights that balance the rotating masses, and those chosen."""
    parts = replacement_masses(shape)
    rotating = shaft.pin_mass + shaft.web_mass * shaft.web_radius / shape.r + parts.at_a  # (27)
    a, b = shaft.left, shaft.right
    turned = rotating * shape.r
    static_sum = turned / weights.radius  # (28): m₁ + m₂
    needed = static_sum * b / (a + b), static_sum * a / (a + b)  # (29)
    chosen = weights.masses or needed
    w2 = shape.omega**2
    force, held = turned * w2, sum(chosen) * weights.radius
    left_over = (held - turned) * w2
    moment = (chosen[1] * b - chosen[0] * a) * weights.radius * w2
    translating = shape.m3 + parts.at_b
    moments = {
        "none": 0.0,
        "rotating": turned,
        "chosen": held,
        "part": (rotating + weights.translating * translating) * shape.r,
    }
    cases = tuple(
        _shaking_force(name, value, shape, shaft, m, drawn, (rotating, translating))
        for name, value in moments.items()
        if name != "chosen" or weights.masses
    )
    return Balance(rotating, parts.at_a, translating, needed, chosen, force, left_over, moment, a, b, cases)


def _shaking_force(
    name: str, moment: float, shape: CrankSliderShape, shaft: Shaft, m: EngineCycle, drawn: DrawnRodMotion, masses: Pair
) -> Shaking:
    turn = (m.phi_deg >= m.phi_deg[0]) & (m.phi_deg < m.phi_deg[0] + 360.0 - 1e-9)
    radial = np.exp(1j * m.phi[turn]) * (m.omega**2 - 1j * m.epsilon)[turn]
    crank = shaft.static_moment(shape.r)
    curve = (crank - moment) * radial - shape.m2 * drawn.a["C"][turn] - shape.m3 * drawn.a["B"][turn]
    first, second = (_harmonic_amplitudes(curve, m.phi[turn], k) for k in (1, 2))
    w2, r = shape.omega**2, shape.r
    rotating, moving = (masses[0] * r - moment) * w2, masses[1] * r * w2
    expected = abs(rotating + moving), abs(rotating), moving * shape.ratio
    return Shaking(name, moment, curve, first[0], first[1], second[0], expected)


def _harmonic_amplitudes(curve: Complexes, phi: Array, order: int) -> Pair:
    """Amplitudes of one harmonic of the components along and across the guide."""
    wave = np.exp(-1j * order * phi)
    return tuple(float(abs(2 * np.mean(part * wave))) for part in (curve.real, curve.imag))  # type: ignore[return-value]


@frozen
class Supports:
    """Reactions (31), (32) and the inertia forces of a web and of each counterweight, N."""

    A1: Array
    A2: Array
    B1: Array
    B2: Array
    web: float
    left_weight: float
    right_weight: float
    out: Array  # N_c on the crank, away from the axis
    T: Array


@frozen
class Section:
    """One section: bending in the crank's plane, across it, torsion (N·m); σ from bending and force, τ, σ_eq (MPa)."""

    name: str
    bending_z: Array
    bending_y: Array
    torsion: Array
    sigma: Array
    tau: Array

    @property
    def equivalent(self) -> Array:
        """σ_eq by the third theory (33)."""
        return np.sqrt(self.sigma**2 + 4 * self.tau**2)


def bearing_reactions(
    shape: CrankSliderShape, shaft: Shaft, weights: Counterweights | None, b: Balance | None, f: CycleForces
) -> Supports:
    """Reactions of the bearings from the sums of forces and moments."""
    length, n, m, w2 = shaft.span, shaft.pin_from_b, shaft.webs, shape.omega**2
    web = shaft.static_moment(shape.r) * w2 / 2
    left, right = (b.chosen[k] * weights.radius * w2 if b and weights else 0.0 for k in (0, 1))
    out, t = -f.K, f.T
    a1 = ((web - left) * (length - m) + out * n + (web - right) * m) / length
    a2 = t * n / length
    return Supports(
        a1,
        a2,
        out + 2 * web - left - right - a1,
        B2=t - a2,
        web=web,
        left_weight=left,
        right_weight=right,
        out=out,
        T=t,
    )


def dangerous_sections(shape: CrankSliderShape, shaft: Shaft, s: Supports) -> dict[str, Section]:
    """The dangerous sections from A to B."""
    m, r, middle = shaft.webs, shape.r, shaft.span - shaft.pin_from_b
    zero = np.zeros_like(s.T)
    pin_z = s.A1 * middle - (s.web - s.left_weight) * shaft.left
    made = [
        _round_section("journal_A", s.A1 * m, s.A2 * m, zero, shaft.journal),
        _web_section("web_A", s.A1 * m, s.A2 * r, s.A2 * m, s.A1, shaft),
        _round_section("crankpin", pin_z, s.A2 * middle, s.A2 * r, shaft.crankpin),
        _web_section("web_B", s.B1 * m, s.T * r, s.B2 * m, s.B1, shaft),
        _round_section("journal_B", s.B1 * m, s.B2 * m, s.T * r, shaft.journal),
    ]
    return {one.name: one for one in made}


def _round_section(name: str, z: Array, y: Array, torque: Array, round_part: RoundPart) -> Section:
    sigma = np.hypot(z, y) / round_part.modulus * MEGAPASCALS_PER_PASCAL
    return Section(name, z, y, torque, sigma, np.abs(torque) / (2 * round_part.modulus) * MEGAPASCALS_PER_PASCAL)


def _web_section(name: str, z: Array, y: Array, torque: Array, force: Array, shaft: Shaft) -> Section:
    """All stresses of a web added as if they met at one point: always on the safe side."""
    web = shaft.web
    sigma = (np.abs(z) / web.along + np.abs(y) / web.across + np.abs(force) / web.area) * MEGAPASCALS_PER_PASCAL
    return Section(name, z, y, torque, sigma, np.abs(torque) / web.torsion_modulus * MEGAPASCALS_PER_PASCAL)


def moment_diagrams(shaft: Shaft, cut: Mapping[str, Section], k: int) -> tuple[Array, Array, Array, Array]:
    """The moment diagrams in position ``k`` of the cycle along the developed length of the bar: distance from A, M_z,
    M_y, M_x."""
    m, middle, end = shaft.webs, shaft.span - shaft.pin_from_b, shaft.span
    x = np.array([0.0, m, m, middle, end - m, end - m, end])
    bars = [cut[name] for name in ("journal_A", "journal_A", "crankpin", "journal_B", "journal_B")]
    z, y = (np.array([0, *bent, 0]) for bent in ([s.bending_z[k] for s in bars], [s.bending_y[k] for s in bars]))
    pin, journal = (cut[name].torsion[k] for name in ("crankpin", "journal_B"))
    return x, z, y, np.array([0, 0, pin, pin, pin, journal, journal])


@frozen
class Fatigue:
    """Amplitudes and means in MPa, factors n_σ, n_τ, n; ``angle_deg`` from z to the worst point of the edge."""

    section: str
    angle_deg: float
    sigma_a: float
    sigma_m: float
    tau_a: float
    tau_m: float
    n_sigma: float
    n_tau: float
    n: float
    static: float  # yield over the largest σ_eq of the cycle


def fatigue_of_section(section: Section, round_part: RoundPart, steel: Material, k: Concentration) -> Fatigue:
    """The factors of one round section."""
    theta = np.radians(np.arange(0.0, 360.0))[:, None]
    sigma = (
        (section.bending_z * np.cos(theta) + section.bending_y * np.sin(theta))
        / round_part.modulus
        * MEGAPASCALS_PER_PASCAL
    )
    top, low = sigma.max(axis=1), sigma.min(axis=1)
    amplitude, mean = (top - low) / 2, (top + low) / 2
    worse = k.k_sigma / k.size_sigma * amplitude + steel.psi * np.maximum(mean, 0.0)
    at = worse.argmax()
    tau = section.torsion / (2 * round_part.modulus) * MEGAPASCALS_PER_PASCAL
    tau_a, tau_m = float(tau.max() - tau.min()) / 2, abs(float(tau.max() + tau.min())) / 2
    n_sigma = safety_factor(steel.fatigue, float(worse[at]))
    n_tau = safety_factor(steel.fatigue_torsion, k.k_tau / k.size_tau * tau_a + steel.psi_torsion * tau_m)
    n, static = combined_safety_factor(n_sigma, n_tau), safety_factor(steel.yields, float(section.equivalent.max()))
    sigma_a, sigma_m = float(amplitude[at]), float(mean[at])
    return Fatigue(section.name, float(at), sigma_a, sigma_m, tau_a, tau_m, n_sigma, n_tau, n, static)


def safety_factor(limit: float, stress: float) -> float:
    """A safety factor; infinite where there is no stress."""
    return limit / stress if stress > 0.0 else math.inf


def combined_safety_factor(n_sigma: float, n_tau: float) -> float:
    """n = n_σ·n_τ/√(n_σ² + n_τ²)."""
    if math.isinf(n_sigma) or math.isinf(n_tau):
        return min(n_sigma, n_tau)
    return n_sigma * n_tau / math.hypot(n_sigma, n_tau)
