"""Fatigue of the journal and the crank pin, (35): the cycle of stress at the worst point of the section's edge."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from planes.crank_slider.given import Concentration
from planes.crank_slider.materials import Material
from planes.crank_slider.sections import Round
from planes.crank_slider.shaft import MPA, Section


@dataclass(frozen=True)
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


def checked(section: Section, of: Round, steel: Material, k: Concentration) -> Fatigue:
    """The factors of one round section."""
    theta = np.radians(np.arange(0.0, 360.0))[:, None]
    sigma = (section.bending_z * np.cos(theta) + section.bending_y * np.sin(theta)) / of.modulus * MPA
    top, low = sigma.max(axis=1), sigma.min(axis=1)
    amplitude, mean = (top - low) / 2, (top + low) / 2
    worse = k.k_sigma / k.size_sigma * amplitude + steel.psi * np.maximum(mean, 0.0)
    at = int(np.argmax(worse))
    tau = section.torsion / (2 * of.modulus) * MPA
    tau_a, tau_m = float(tau.max() - tau.min()) / 2, abs(float(tau.max() + tau.min())) / 2
    n_sigma = factor(steel.fatigue, float(worse[at]))
    n_tau = factor(steel.fatigue_torsion, k.k_tau / k.size_tau * tau_a + steel.psi_torsion * tau_m)
    largest = float(section.equivalent.max())
    return Fatigue(
        section.name,
        float(at),
        float(amplitude[at]),
        float(mean[at]),
        tau_a,
        tau_m,
        n_sigma,
        n_tau,
        total(n_sigma, n_tau),
        factor(steel.yields, largest),
    )


def factor(limit: float, stress: float) -> float:
    """A safety factor; infinite where there is no stress."""
    return limit / stress if stress > 0.0 else math.inf


def total(n_sigma: float, n_tau: float) -> float:
    """n = n_σ·n_τ/√(n_σ² + n_τ²)."""
    if math.isinf(n_sigma) or math.isinf(n_tau):
        return min(n_sigma, n_tau)
    return n_sigma * n_tau / math.hypot(n_sigma, n_tau)
