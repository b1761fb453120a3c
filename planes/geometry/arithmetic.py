"""Arithmetics an instrument can calculate in, one number at a time or arrays of many; and sines and their kin of angles
in degrees, exact where the answer is a round number.

The geometry of ``plane`` and the steps are written once and given one of these arithmetics.
"""

import cmath
import math
from collections.abc import Callable
from typing import Any

from planes.geometry.error_free import gap


def sin_deg(angle: float) -> float:
    """Sine of an angle in degrees, exact at multiples of 30 where it is rational."""
    r = math.remainder(angle, 360.0)
    r = math.copysign(180.0, r) - r if abs(r) > 90.0 else r
    if abs(r) == 30.0:
        return math.copysign(0.5, r)
    return math.sin(math.radians(r)) if abs(r) <= 45.0 else math.copysign(math.cos(math.radians(90.0 - abs(r))), r)


def cos_deg(angle: float) -> float:
    """Cosine of an angle in degrees, exact at multiples of 30 where it is rational."""
    r = abs(math.remainder(angle, 360.0))
    return sin_deg(90.0 - r) if 45.0 < r < 135.0 else math.cos(math.radians(r))


def tan_deg(angle: float) -> float:
    """Tangent of an angle in degrees, exact at multiples of 45; a ValueError at 90."""
    r = math.remainder(angle, 180.0)
    if abs(r) == 90.0:
        raise ValueError(f"tan({angle:g}) has no value")
    if abs(r) == 45.0:
        return math.copysign(1.0, r)
    return math.tan(math.radians(r)) if abs(r) < 45.0 else math.copysign(1.0, r) / math.tan(math.radians(90.0 - abs(r)))


def asin_deg(value: float) -> float:
    """Angle in degrees of a sine; a ValueError outside -1..1."""
    return math.copysign(30.0, value) if abs(value) == 0.5 else math.degrees(math.asin(value))


def acos_deg(value: float) -> float:
    """Angle in degrees of a cosine; a ValueError outside -1..1."""
    return {0.5: 60.0, -0.5: 120.0}.get(value) or math.degrees(math.acos(value))


def atan_deg(value: float) -> float:
    """Angle in degrees of a tangent."""
    return math.degrees(math.atan(value))


def atan2_deg(y: float, x: float) -> float:
    """Direction in degrees of the vector (x, y)."""
    return math.degrees(math.atan2(y, x))


Real = Any  # float or array of floats, or a longer number
Point = Any  # complex or array of complex: a place, a vector or a direction
Truth = Any  # bool or array of bools


class Arithmetic:
    """The functions constructions need beyond + - * /: of Python's own float and complex, one position at a time."""

    eps: Real = 2.0**-52
    size: Callable[[Point], Real] = staticmethod(abs)

    def sqrt(self, x: Real) -> Real:
        return math.sqrt(x) if x > 0 else 0.0

    def maximum(self, a: Real, b: Real) -> Real:
        return a if a >= b else b

    def minimum(self, a: Real, b: Real) -> Real:
        return a if a <= b else b

    def where(self, ok: Truth, a: Point, b: Point) -> Point:
        return a if ok else b

    def cis_deg(self, angle: Real) -> Point:
        """cos + i sin of an angle in degrees, exact at quarter turns."""
        quarter = math.floor(angle / 90 + 0.5)
        rest = math.radians(angle - 90 * quarter)
        return complex(math.cos(rest), math.sin(rest)) * (1, 1j, -1, -1j)[quarter % 4]

    def angle_deg(self, u: Point) -> Real:
        """Direction of a vector in degrees, in (-180, 180]."""
        angle = math.degrees(cmath.phase(u))
        return 180.0 if angle == -180.0 else angle

    def sign(self, x: Real) -> Real:
        return float((x > 0) - (x < 0))

    def power(self, x: Real, n: int) -> Real:
        if n >= 0:
            return x if n == 1 else float(x**n)
        return 1 / x**-n if x else math.nan

    def gap(self, c: Point, d: Point, r: Real, s: Real) -> Real:
        """(r + s)² - |d - c|², with all its digits."""
        return float(gap(c.real, c.imag, d.real, d.imag, r, s))


class Many(Arithmetic):
    """numpy arrays: many positions at once, the same formulas."""

    def __init__(self) -> None:
        import numpy

        self.np = numpy

    @staticmethod
    def size(z: Point) -> Real:
        """How large a vector is: no less than its length, nor more than √2 of it; quicker than that."""
        return abs(z.real) + abs(z.imag)

    def sqrt(self, x: Real) -> Real:
        return self.np.sqrt(self.np.maximum(x, 0.0))

    def maximum(self, a: Real, b: Real) -> Real:
        return self.np.maximum(a, b)

    def minimum(self, a: Real, b: Real) -> Real:
        return self.np.minimum(a, b)

    def where(self, ok: Truth, a: Point, b: Point) -> Point:
        return self.np.where(ok, a, b)

    def cis_deg(self, angle: Real) -> Point:
        quarter = self.np.floor(self.np.asarray(angle) / 90 + 0.5)
        rest = self.np.radians(angle - 90 * quarter)
        turns = self.np.array([1, 1j, -1, -1j])[quarter.astype(int) % 4]
        return (self.np.cos(rest) + 1j * self.np.sin(rest)) * turns

    def angle_deg(self, u: Point) -> Real:
        angle = self.np.degrees(self.np.angle(u))
        return self.np.where(angle == -180.0, 180.0, angle)

    def sign(self, x: Real) -> Real:
        return self.np.sign(x)

    def power(self, x: Real, n: int) -> Real:
        return x**n if n >= 0 else self.np.divide(1.0, x**-n)

    def gap(self, c: Point, d: Point, r: Real, s: Real) -> Real:
        return gap(c.real, c.imag, d.real, d.imag, r, s)
