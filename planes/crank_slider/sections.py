"""Cross-sections of shafts and rods: area and section moduli, SI."""

from __future__ import annotations

import bisect
import math
from dataclasses import dataclass

_SIDES = (1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 10.0, 1e9)
_ALPHA = (0.208, 0.219, 0.231, 0.246, 0.258, 0.267, 0.282, 0.291, 0.312, 0.333)


@dataclass(frozen=True)
class Round:
    """A round section of diameter d with a bore in its middle."""

    d: float
    bore: float = 0.0

    @property
    def area(self) -> float:
        return math.pi / 4 * (self.d**2 - self.bore**2)

    @property
    def modulus(self) -> float:
        """W in bending; in torsion it is twice as much."""
        return math.pi * self.d**3 / 32 * (1 - (self.bore / self.d) ** 4)


@dataclass(frozen=True)
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
    def torsion(self) -> float:
        """α·h·b²: what a torque is divided by for the largest shear (Saint-Venant)."""
        long, short = max(self.width, self.thickness), min(self.width, self.thickness)
        return torsion_factor(long / short) * long * short**2


@dataclass(frozen=True)
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
    k = max(1, min(bisect.bisect_left(_SIDES, ratio), len(_SIDES) - 1))
    share = (ratio - _SIDES[k - 1]) / (_SIDES[k] - _SIDES[k - 1])
    return _ALPHA[k - 1] + share * (_ALPHA[k] - _ALPHA[k - 1])
