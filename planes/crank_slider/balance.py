"""Balancing of the crankshaft by two counterweights, (27)–(30), and what they do to first-order forces."""

from dataclasses import dataclass

import numpy as np

from planes.crank_slider.forces import replaced
from planes.crank_slider.given import Counterweights, Shaft
from planes.crank_slider.kinematics import EngineCycle, Found
from planes.crank_slider.shape import CrankSliderShape
from planes.geometry.arrays import Array, Complexes


@dataclass(frozen=True)
class Shaking:
    """Inertia force of the whole machine on its frame with some counterweights, N.

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


@dataclass(frozen=True)
class Balance:
    """Masses in kg at the crank's radius, counterweights, what is left unbalanced."""

    rotating: float
    of_rod: float
    translating: float
    needed: tuple[float, float]
    chosen: tuple[float, float]
    force: float
    residual_force: float
    residual_moment: float
    left: float
    right: float
    cases: tuple[Shaking, ...]


def balanced(shape: CrankSliderShape, shaft: Shaft, weights: Counterweights, m: EngineCycle, found: Found) -> Balance:
    """Counterweights that balance the rotating masses, and those chosen."""
    parts = replaced(shape)
    rotating = shaft.pin_mass + shaft.web_mass * shaft.web_radius / shape.r + parts.at_a  # (27)
    a, b = shaft.left, shaft.right
    whole = rotating * shape.r / weights.radius  # (28): m₁ + m₂
    needed = whole * b / (a + b), whole * a / (a + b)  # (29)
    chosen = weights.masses or needed
    w2 = shape.omega**2
    force = rotating * shape.r * w2
    left_over = (sum(chosen) * weights.radius - rotating * shape.r) * w2
    moment = (chosen[1] * b - chosen[0] * a) * weights.radius * w2
    translating = shape.m3 + parts.at_b
    moments = {
        "none": 0.0,
        "rotating": rotating * shape.r,
        "chosen": sum(chosen) * weights.radius,
        "part": (rotating + weights.translating * translating) * shape.r,
    }
    cases = tuple(
        _shaking(name, value, shape, shaft, m, found, (rotating, translating))
        for name, value in moments.items()
        if name != "chosen" or weights.masses
    )
    return Balance(rotating, parts.at_a, translating, needed, chosen, force, left_over, moment, a, b, cases)


def _shaking(
    name: str,
    moment: float,
    shape: CrankSliderShape,
    shaft: Shaft,
    m: EngineCycle,
    found: Found,
    masses: tuple[float, float],
) -> Shaking:
    turn = (m.phi_deg >= m.phi_deg[0]) & (m.phi_deg < m.phi_deg[0] + 360.0 - 1e-9)
    radial = np.exp(1j * m.phi[turn]) * (m.omega**2 - 1j * m.epsilon)[turn]
    crank = shaft.pin_mass * shape.r + shaft.web_mass * shaft.web_radius
    curve = (crank - moment) * radial - shape.m2 * found.a["C"][turn] - shape.m3 * found.a["B"][turn]
    first, second = (_harmonic(curve, m.phi[turn], k) for k in (1, 2))
    w2, r = shape.omega**2, shape.r
    rotating, moving = (masses[0] * r - moment) * w2, masses[1] * r * w2
    expected = abs(rotating + moving), abs(rotating), moving * shape.ratio
    return Shaking(name, moment, curve, first[0], first[1], second[0], expected)


def _harmonic(curve: Complexes, phi: Array, order: int) -> tuple[float, float]:
    """Amplitudes of one harmonic of the parts along and across the guide."""
    wave = np.exp(-1j * order * phi)
    return tuple(float(abs(2 * np.mean(part * wave))) for part in (curve.real, curve.imag))  # type: ignore[return-value]
