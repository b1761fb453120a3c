"""The difference between the decimals of a scene and their doubles, where the numbers are used as written; givens
computed from such numbers are computed again in decimals."""

import math
from decimal import Context, Decimal, localcontext
from typing import Any

from planes.drafting.dimensions import Dimension
from planes.drafting.tools import Thing
from planes.geometry.arithmetic import Arithmetic, Point, Real
from planes.plans.position.reckoned import SceneDimensions, recompute_dimension
from planes.words.frozen import frozen

COMPUTED_NUMBER_ERROR_RATIO = Decimal(2) ** -52  # relative: error of a number computed from written ones
FORTY_DIGIT_CONTEXT = Context(prec=40)
RADIANS_PER_DEGREE = Decimal("0.01745329251994329576923690768488612713442871888541725")
ANGLE_SERIES_TERMS = 40  # terms of the series of an angle up to an eighth of a turn: the rest is less than 10⁻⁴⁰
Lost = tuple[Thing, float]
"""The rounding error of a double, and the uncertainty of the number beyond that."""


@frozen
class _Place:
    """A place or a vector in decimals."""

    real: Decimal
    imag: Decimal

    def __sub__(self, other: "_Place") -> "_Place":
        return _Place(self.real - other.real, self.imag - other.imag)

    def __mul__(self, z: "_Place") -> "_Place":
        return _Place(self.real * z.real - self.imag * z.imag, self.real * z.imag + self.imag * z.real)

    def __truediv__(self, z: "_Place") -> "_Place":
        up = self * _Place(z.real, -z.imag)
        square = z.real * z.real + z.imag * z.imag
        return _Place(up.real / square, up.imag / square)

    def __abs__(self) -> Decimal:
        return (self.real * self.real + self.imag * self.imag).sqrt()


class _Decimals(Arithmetic):
    """Decimal arithmetic, as far as dimensions need it."""

    def cis_deg(self, angle: Real) -> Point:
        quarter = (angle / 90).to_integral_value()
        x = (angle - 90 * quarter) * RADIANS_PER_DEGREE
        term = Decimal(1)
        parts = [Decimal(0), Decimal(0)]
        for k in range(ANGLE_SERIES_TERMS):
            parts[k % 2] += -term if k % 4 > 1 else term
            term *= x / (k + 1)
        cos, sin = parts
        return _Place(*((cos, sin), (-sin, cos), (-cos, -sin), (sin, -cos))[int(quarter) % 4])

    def angle_deg(self, u: Point) -> Real:
        near = Decimal(super().angle_deg(complex(u.real, u.imag)))
        left = u * self.cis_deg(-near)
        if left.real:
            return near + left.imag / left.real / RADIANS_PER_DEGREE
        return near


class AsWritten(SceneDimensions):
    """The dimensions as written, in decimals; numbers not used as written, as their doubles."""

    def decimal_rounding_error(self, value: Thing, by: Dimension | None) -> Lost | None:
        """The rounding error of a given, computed from others (``by``) or written directly; None for a single number
        whose decimal is unknown."""
        self.unknown: dict[float, None] = {}  # the magnitudes of such numbers
        self.moved = -1.0  # the one that is assumed to be off
        with localcontext(FORTY_DIGIT_CONTEXT):
            lost = self._decimals_less_double(value, by)
            if self.unknown and by is None and not isinstance(value, complex):
                return None
            off = 0.0
            for size in [*self.unknown]:
                self.moved = size
                off += abs(self._decimals_less_double(value, by) - lost)
        return lost, off

    def taken(self, value: Thing) -> Any:
        """A number or a place in decimals."""
        if not isinstance(value, complex):
            return self._decimal_of_number(value)
        if polar := self.mechanism.written.places.get(value):
            radius = self._decimal_of_number(polar[0])
            way = _DECIMAL_ARITHMETIC.cis_deg(self._decimal_of_number(polar[1]))
            return _Place(radius * way.real, radius * way.imag)
        return _Place(self._decimal_of_number(value.real), self._decimal_of_number(value.imag))

    def _decimal_of_number(self, x: float) -> Decimal:
        if text := self.mechanism.written.decimal_of_number(x):
            return Decimal(text)
        self.unknown[abs(x)] = None
        if abs(x) == self.moved:
            return Decimal(x) * (1 + COMPUTED_NUMBER_ERROR_RATIO)
        return Decimal(x)

    def _decimals_less_double(self, value: Thing, by: Dimension | None) -> Thing:
        """The decimals less the double."""
        true = recompute_dimension(by.of, self, _DECIMAL_ARITHMETIC) if by else self.taken(value)
        if isinstance(value, complex):
            return complex(float(true.real - Decimal(value.real)), float(true.imag - Decimal(value.imag)))
        less = float(true - Decimal(value))
        return math.remainder(less, 360.0) if abs(less) > 359.0 and abs(value) <= 360.0 else less  # a full turn apart


_DECIMAL_ARITHMETIC = _Decimals()
