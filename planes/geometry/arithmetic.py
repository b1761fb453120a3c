"""Arithmetics for the constructions, with one number at a time or with arrays; trigonometric functions of angles in
degrees, exact where the answer is a round number; sums, products and differences of squares with almost no rounding
loss.

The geometry of ``plane`` and the steps are written once and take one of these arithmetics. A rounding error is itself a
float (D. E. Knuth; T. J. Dekker, A floating-point technique for extending the available precision, 1971).
"""

import cmath
import math
from collections.abc import Callable, Iterable
from contextlib import AbstractContextManager, nullcontext
from typing import Any, TypeVar

from planes.geometry.arrays import Array

VELTKAMP_SPLITTER = 134217729.0  # 2²⁷ + 1 splits a number of 53 bits in half (Veltkamp)
SINGLE_VELTKAMP_SPLITTER = 4097.0  # 2¹² + 1 one of 24
EPS = 2.0**-52
SINGLE_EPS = 2.0**-23
N = TypeVar("N", float, Array)
Shape = tuple[int, ...]  # of arrays


def sin_deg(angle: float) -> float:
    """Sine of an angle in degrees, exact at multiples of 30 where it is rational."""
    r = math.remainder(angle, 360.0)
    r = math.copysign(180.0, r) - r if abs(r) > 90.0 else r
    if abs(r) == 30.0:
        return math.copysign(0.5, r)
    if abs(r) <= 45.0:
        return math.sin(math.radians(r))
    return math.copysign(math.cos(math.radians(90.0 - abs(r))), r)


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
    if abs(r) < 45.0:
        return math.tan(math.radians(r))
    return math.copysign(1.0, r) / math.tan(math.radians(90.0 - abs(r)))


def asin_deg(value: float) -> float:
    """Angle in degrees of a sine; a ValueError outside -1..1."""
    if abs(value) == 0.5:
        return math.copysign(30.0, value)
    return math.degrees(math.asin(value))


def acos_deg(value: float) -> float:
    """Angle in degrees of a cosine; a ValueError outside -1..1."""
    return {0.5: 60.0, -0.5: 120.0}.get(value) or math.degrees(math.acos(value))


def atan_deg(value: float) -> float:
    """Angle in degrees of a tangent."""
    return math.degrees(math.atan(value))


def atan2_deg(y: float, x: float) -> float:
    """Direction in degrees of the vector (x, y)."""
    return math.degrees(math.atan2(y, x))


Real = Any  # float, array of floats, or a number of higher precision
Point = Any  # complex or array of complex: a place, a vector or a direction
Truth = Any  # bool or array of bools


class Arithmetic:
    """The functions that constructions need beyond + - * /, for Python's float and complex: one position at a time."""

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

    def guess(self, x: Real) -> Real:
        """The start value of a search: its error does not affect the result."""
        return x

    def power(self, x: Real, n: int) -> Real:
        if n >= 0:
            return x if n == 1 else float(x**n)
        return 1 / x**-n if x else math.nan

    def gap(self, c: Point, d: Point, r: Real, s: Real) -> Real:
        """(r + s)² - |d - c|², without cancellation."""
        return float(squared_circle_gap(c.real, c.imag, d.real, d.imag, r, s))

    def common_shape(self, shapes: Iterable[Shape]) -> Shape:
        """The common shape of all numbers in a construction."""
        return max(shapes)

    def repeat_for_positions(self, thing: Any, shape: Shape) -> Any:
        """A constant repeated for every position."""
        return thing

    def ignoring_warnings(self) -> AbstractContextManager[None]:
        """A context in which invalid operations give no warnings."""
        return nullcontext()


class Many(Arithmetic):
    """numpy arrays: many positions at once, by the same formulas."""

    def __init__(self) -> None:
        import numpy

        self.np = numpy

    @staticmethod
    def size(z: Point) -> Real:
        """An estimate of a vector's length, from the length itself to √2 times it; quicker to compute."""
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
        return squared_circle_gap(c.real, c.imag, d.real, d.imag, r, s)

    def common_shape(self, shapes: Iterable[Shape]) -> Shape:
        return self.np.broadcast_shapes(*shapes)

    def repeat_for_positions(self, thing: Any, shape: Shape) -> Any:
        return self.np.broadcast_to(thing, shape)

    def ignoring_warnings(self) -> AbstractContextManager[None]:
        return self.np.errstate(all="ignore")


def two_sum(a: N, b: N) -> tuple[N, N]:
    """a + b and its rounding error."""
    s = a + b
    t = s - a
    return s, (a - (s - t)) + (b - t)


def two_product(a: N, b: N) -> tuple[N, N]:
    """a·b and its rounding error."""
    p = a * b
    a1, a2 = _split_in_halves(a)
    b1, b2 = _split_in_halves(b)
    return p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2


def _split_in_halves(a: N) -> tuple[N, N]:
    t = a * (SINGLE_VELTKAMP_SPLITTER if getattr(a, "itemsize", 8) == 4 else VELTKAMP_SPLITTER)
    high = t - (t - a)
    return high, a - high


def squared_circle_gap(cx: N, cy: N, dx: N, dy: N, r: N, s: N) -> N:
    """(r + s)² - |d - c|², correct to the last place until it is as small as the square of one.

    It shows whether circles of radii r and s about c and d meet. The distance is never formed: once rounded, it would
    spoil a small difference. The result is 0 where rounding of the six numbers may account for it: the circles touch.
    """
    x, x_lost = two_sum(dx, -cx)
    y, y_lost = two_sum(dy, -cy)
    t, t_lost = two_sum(r, s)
    xx, xx_lost = two_product(x, x)
    yy, yy_lost = two_product(y, y)
    tt, tt_lost = two_product(t, t)
    left, one = two_sum(tt, -xx)
    left, two = two_sum(left, -yy)
    left = left + (((one + two) + (tt_lost - xx_lost - yy_lost)) + 2 * (t * t_lost - x * x_lost - y * y_lost))
    return left * (abs(left) > squared_gap_rounding_bound(cx, cy, dx, dy, r, s))


def squared_gap_rounding_bound(cx: N, cy: N, dx: N, dy: N, r: N, s: N) -> N:
    """The largest gap that still counts as zero: one unit in the last place of each number, added up."""
    size = abs(cx) + abs(cy) + abs(dx) + abs(dy) + abs(r) + abs(s)
    return size * abs(r + s) * (SINGLE_EPS if getattr(size, "itemsize", 8) == 4 else EPS)
