"""What the doubles of a scene's numbers leave out of its decimals, where they are written as they stand: of givens that
are reckoned of them, too, which are reckoned again in decimals.
"""

from collections.abc import Collection
from contextlib import suppress
from dataclasses import dataclass
from decimal import Context, Decimal, localcontext
from typing import Any

from planes.drafting.dimensions import Dimension
from planes.drafting.tools import Thing
from planes.geometry.arithmetic import Arithmetic, Point, Real
from planes.plans.position.reckoned import HALF, OwnPlace, SceneDimensions
from planes.scene.mechanism import Link, Mechanism

LONG = Context(prec=40)
RADIAN = Decimal("0.01745329251994329576923690768488612713442871888541725")
TERMS = 40  # of the series of an angle no larger than an eighth of a turn: those left out are less than 10⁻⁴⁰
Lost = tuple[Thing, float]
"""What a double leaves out of a number, and how far off the number may be beside that."""


@dataclass(frozen=True)
class _Place:
    """A place or a vector in decimals."""

    real: Decimal
    imag: Decimal

    def __add__(self, other: "_Place") -> "_Place":
        return _Place(self.real + other.real, self.imag + other.imag)

    def __sub__(self, other: "_Place") -> "_Place":
        return _Place(self.real - other.real, self.imag - other.imag)

    def __mul__(self, z: "_Place") -> "_Place":
        return _Place(self.real * z.real - self.imag * z.imag, self.real * z.imag + self.imag * z.real)

    def __truediv__(self, z: "_Place") -> "_Place":
        up, square = self * _Place(z.real, -z.imag), z.real * z.real + z.imag * z.imag
        return _Place(up.real / square, up.imag / square)

    def __abs__(self) -> Decimal:
        return (self.real * self.real + self.imag * self.imag).sqrt()


class _Decimals(Arithmetic):
    """The arithmetic of decimals, as far as dimensions need it."""

    def cis_deg(self, angle: Real) -> Point:
        quarter = (angle / 90).to_integral_value()
        x = (angle - 90 * quarter) * RADIAN
        term, parts = Decimal(1), [Decimal(0), Decimal(0)]
        for k in range(TERMS):
            parts[k % 2] += -term if k % 4 > 1 else term
            term *= x / (k + 1)
        cos, sin = parts
        return _Place(*((cos, sin), (-sin, cos), (-cos, -sin), (sin, -cos))[int(quarter) % 4])

    def angle_deg(self, u: Point) -> Real:
        near = Decimal(super().angle_deg(complex(u.real, u.imag)))
        left = u * self.cis_deg(-near)
        return near + left.imag / left.real / RADIAN if left.real else near


class _Written(SceneDimensions):
    """The dimensions as they are written; a KeyError where that is not known."""

    def place(self, spot: OwnPlace) -> Any:
        return self.thing(super().place(spot))

    def angle(self, guide: str) -> Any:
        return self.thing(super().angle(guide))

    def lean(self, slider: str) -> Any:
        return self.thing(super().lean(slider))

    def offset(self, slider: str) -> Any:
        return self.thing(super().offset(slider))

    def thing(self, value: Thing) -> Any:
        """A number or a place."""
        written = self.mechanism.written
        if not isinstance(value, complex):
            return Decimal(written.decimal(value))
        if polar := written.places.get(value):
            radius, angle = (Decimal(written.decimal(x)) for x in polar)
            way = _DECIMALS.cis_deg(angle)
            return _Place(radius * way.real, radius * way.imag)
        return _Place(Decimal(written.decimal(value.real)), Decimal(written.decimal(value.imag)))


class LeftOut:
    """What is left out of every given of a mechanism."""

    def __init__(self, mechanism: Mechanism, passive: Collection[Link]) -> None:
        self.written = _Written(mechanism, passive)

    def of(self, value: Thing, off: float, by: Dimension | None) -> Lost | None:
        """Of a given that may be ``off`` for what is reckoned ``by``, or else is written; None: not known, but no more
        than half of its last place."""
        with localcontext(LONG), suppress(KeyError, ArithmeticError):
            lost = _less(by.by(self.written, _DECIMALS) if by else self.written.thing(value), value)
            if abs(lost) <= off + 2 * HALF * abs(value):  # no turn apart
                return lost, 0.0
        return None if not off else (0.0 * value, max(off, HALF * abs(value)))


_DECIMALS = _Decimals()


def _less(true: Any, value: Thing) -> Thing:
    if isinstance(value, complex):
        return complex(float(true.real - Decimal(value.real)), float(true.imag - Decimal(value.imag)))
    return float(true - Decimal(value))
