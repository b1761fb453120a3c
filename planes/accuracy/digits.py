"""The instrument of many digits: the same steps with mpmath's long numbers, one position at a time; the reference."""

from functools import lru_cache
from typing import Any

from planes.drafting.tools import Tool
from planes.geometry.arithmetic import Arithmetic, Point, Real
from planes.words import Phrase
from planes.words.errors import PlanesError
from planes.words.frozen import frozen


class Long(Arithmetic):
    """An arithmetic of ``digits`` decimal digits."""

    def __init__(self, digits: int) -> None:
        try:
            import mpmath
        except ImportError:
            raise PlanesError(Phrase("digits_no_mpmath")) from None
        self.mp: Any = mpmath.MPContext()
        self.mp.dps = digits
        self.eps: Real = self.mp.mpf(10) ** -digits

    def exact_in_long_digits(self, x: Point) -> Point:
        """A given number in this arithmetic, without loss of digits."""
        if isinstance(x, complex):
            return self.mp.mpc(x)
        if isinstance(x, float | int) and not isinstance(x, bool):
            return self.mp.mpf(x)
        return x

    def sqrt(self, x: Real) -> Real:
        return self.mp.sqrt(x) if x > 0 else self.mp.zero

    def cis_deg(self, angle: Real) -> Point:
        """cos + i sin of an angle in degrees, exact at quarter turns."""
        angle = self.exact_in_long_digits(angle)
        quarter = int(self.mp.floor(angle / 90 + self.mp.mpf(1) / 2))
        rest = (angle - 90 * quarter) * self.mp.pi / 180
        return self.mp.mpc(self.mp.cos(rest), self.mp.sin(rest)) * (1, 1j, -1, -1j)[quarter % 4]

    def angle_deg(self, u: Point) -> Real:
        u = self.mp.mpc(u)
        angle = self.mp.atan2(u.imag, u.real) * 180 / self.mp.pi
        return -angle if angle == -180 else angle

    def sign(self, x: Real) -> Real:
        return self.mp.sign(x)

    def power(self, x: Real, n: int) -> Real:
        if n < 0 and not x:
            return self.mp.nan
        return x**n

    def gap(self, c: Point, d: Point, r: Real, s: Real) -> Real:
        apart = d - c
        return (r + s) ** 2 - apart.real**2 - apart.imag**2


_arithmetic = lru_cache(maxsize=8)(Long)


class _LongTool(Tool):
    """Draws with long numbers: givens are converted exactly."""

    def given_in_tool_type(self, value: Point) -> Point:
        ar = self.ar
        assert isinstance(ar, Long)
        return ar.exact_in_long_digits(value)


@frozen
class Digits:
    """No error except in the ``digits``-th digit."""

    digits: int = 50

    def tool(self, many: bool) -> Tool:
        if many:
            raise PlanesError(Phrase("digits_one"))
        fine = 10.0 ** (3 - self.digits)
        return _LongTool(_arithmetic(self.digits), slack=fine, flat=fine, still=10 * fine, plans=4 * self.digits)
