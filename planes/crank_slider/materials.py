"""Steels: a table of common grades, and the formulas that estimate their fatigue limits.

Strength and yield are the least values of ГОСТ 1050 (carbon steels, normalised) and ГОСТ 4543 (alloy steels, hardened
and tempered). Fatigue limits: σ₋₁ = 0.43 σ_B of carbon and 0.35 σ_B + 120 MPa of alloy steels, τ₋₁ = 0.58 σ₋₁, the
estimates of machine design courses; ψ_σ = 0.02 + 2·10⁻⁴ σ_B, ψ_τ = 0.5 ψ_σ as in ГОСТ 25.504.
"""

from __future__ import annotations

from dataclasses import dataclass

ELASTICITY_MPA = 2.1e5

STEELS: dict[str, tuple[float, float, bool]] = {
    # name: strength, yield (MPa), alloyed
    "20": (410, 245, False),
    "35": (530, 315, False),
    "40": (570, 335, False),
    "45": (600, 355, False),
    "50": (630, 375, False),
    "20Х": (780, 635, True),
    "40Х": (980, 785, True),
    "45Х": (1030, 835, True),
    "40ХН": (980, 785, True),
    "12ХН3А": (930, 685, True),
    "30ХГСА": (1080, 835, True),
    "18Х2Н4МА": (1130, 835, True),
}


@dataclass(frozen=True)
class Material:
    """A steel in MPa: strength, yield, fatigue limits in bending and torsion, ψ's, E."""

    name: str
    strength: float
    yields: float
    fatigue: float
    fatigue_torsion: float
    psi: float
    psi_torsion: float
    elasticity: float = ELASTICITY_MPA
    estimated: bool = True  # whether the fatigue limits are estimates


def made(
    name: str,
    strength: float,
    yields: float,
    alloyed: bool,
    fatigue: float | None = None,
    torsion: float | None = None,
    elasticity: float = ELASTICITY_MPA,
) -> Material:
    """A material; the fatigue limits not given are estimated from the strength."""
    bending = fatigue or (0.35 * strength + 120.0 if alloyed else 0.43 * strength)
    psi = 0.02 + 2e-4 * strength
    return Material(
        name,
        strength,
        yields,
        bending,
        torsion or 0.58 * bending,
        psi,
        0.5 * psi,
        elasticity,
        fatigue is None or torsion is None,
    )


def steel(name: str) -> Material | None:
    """The steel of that name, in Cyrillic or look-alike Latin letters."""
    known = name.strip().upper().translate(str.maketrans("XHACM", "ХНАСМ"))
    return made(known, *STEELS[known]) if known in STEELS else None
