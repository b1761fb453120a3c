"""The sections of parts (area and section moduli, SI) and their steels.

Strength and yield are the least values of ГОСТ 1050 (carbon steels, normalised) and ГОСТ 4543 (alloy steels, hardened
and tempered). Fatigue limits: σ₋₁ = 0.43 σ_B of carbon and 0.35 σ_B + 120 MPa of alloy steels, τ₋₁ = 0.58 σ₋₁, the
estimates of machine design courses; ψ_σ = 0.02 + 2·10⁻⁴ σ_B, ψ_τ = 0.5 ψ_σ as in ГОСТ 25.504.
"""

import json
import math
from pathlib import Path

import numpy as np

from planes.words.frozen import frozen

_SIDE_RATIOS = (1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 10.0, 1e9)
_TORSION_FACTORS = (0.208, 0.219, 0.231, 0.246, 0.258, 0.267, 0.282, 0.291, 0.312, 0.333)


@frozen
class RoundPart:
    """A round section of diameter d with a central bore."""

    d: float
    bore: float = 0.0

    @property
    def area(self) -> float:
        return math.pi / 4 * (self.d**2 - self.bore**2)

    @property
    def modulus(self) -> float:
        """W in bending; in torsion it is twice this value."""
        return math.pi * self.d**3 / 32 * (1 - (self.bore / self.d) ** 4)


@frozen
class Web:
    """A web of the crank: width across the crank's plane, thickness along the shaft."""

    width: float
    thickness: float

    @property
    def area(self) -> float:
        return self.width * self.thickness

    @property
    def along(self) -> float:
        """W against bending along the shaft (about the width)."""
        return self.width * self.thickness**2 / 6

    @property
    def across(self) -> float:
        """W against bending in the plane of rotation."""
        return self.thickness * self.width**2 / 6

    @property
    def torsion_modulus(self) -> float:
        """α·h·b²: a torque over this is the largest shear stress (Saint-Venant)."""
        long = max(self.width, self.thickness)
        short = min(self.width, self.thickness)
        return torsion_factor(long / short) * long * short**2


@frozen
class Shank:
    """An I-section of the rod: height in the plane of motion, width across; ``web`` as wide as ``width``: a bar."""

    height: float
    width: float
    flange: float
    web: float

    @property
    def area(self) -> float:
        return self.width * self.height - (self.width - self.web) * self._clear

    @property
    def _clear(self) -> float:
        return self.height - 2 * self.flange

    @property
    def inertia(self) -> float:
        """J against bending in the plane of motion."""
        return (self.width * self.height**3 - (self.width - self.web) * self._clear**3) / 12

    @property
    def inertia_across(self) -> float:
        """J against bending across that plane."""
        return (2 * self.flange * self.width**3 + self._clear * self.web**3) / 12

    @property
    def modulus(self) -> float:
        return 2 * self.inertia / self.height


def torsion_factor(ratio: float) -> float:
    """Saint-Venant's α of a rectangle by the ratio of its sides (≥ 1), linear between the table's values."""
    return float(np.interp(ratio, _SIDE_RATIOS, _TORSION_FACTORS))


ELASTICITY_MPA = 2.1e5

STEEL_PROPERTIES: dict[str, tuple[float, float, bool]] = json.loads(
    Path(__file__).with_name("steels.json").read_text("utf-8")
)
"""For the name of a steel its strength and yield (MPa), and whether it is alloyed."""


@frozen
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


def make_material(
    name: str,
    strength: float,
    yields: float,
    alloyed: bool,
    fatigue: float | None = None,
    torsion: float | None = None,
    elasticity: float = ELASTICITY_MPA,
) -> Material:
    """A material; missing fatigue limits are estimated from the strength."""
    bending = fatigue or (0.35 * strength + 120.0 if alloyed else 0.43 * strength)
    psi = 0.02 + 2e-4 * strength
    return Material(name, strength, yields, bending, torsion or 0.58 * bending, psi, psi / 2, elasticity)


def steel_by_name(name: str) -> Material | None:
    """The steel of that name, in Cyrillic or look-alike Latin letters."""
    known = name.strip().upper().translate(str.maketrans("XHACM", "ХНАСМ"))
    if known in STEEL_PROPERTIES:
        return make_material(known, *STEEL_PROPERTIES[known])
    return None
