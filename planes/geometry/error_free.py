"""Sums, products and differences of squares that lose nothing, or next to nothing, of floats and arrays of them.

What rounding takes away is itself a float (D. E. Knuth; T. J. Dekker, A floating-point technique for extending the
available precision, 1971).
"""

from typing import TypeVar

from planes.geometry.arrays import Array

HALVES = 134217729.0  # 2²⁷ + 1 halves a number of 53 bits (Veltkamp)
SHORT_HALVES = 4097.0  # 2¹² + 1 one of 24
EPS, SHORT_EPS = 2.0**-52, 2.0**-23
N = TypeVar("N", float, Array)


def two_sum(a: N, b: N) -> tuple[N, N]:
    """a + b and what rounding lost of it."""
    s = a + b
    t = s - a
    return s, (a - (s - t)) + (b - t)


def two_product(a: N, b: N) -> tuple[N, N]:
    """a·b and what rounding lost of it."""
    p = a * b
    (a1, a2), (b1, b2) = _halves(a), _halves(b)
    return p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2


def _halves(a: N) -> tuple[N, N]:
    t = a * (SHORT_HALVES if getattr(a, "itemsize", 8) == 4 else HALVES)
    high = t - (t - a)
    return high, a - high


def gap(cx: N, cy: N, dx: N, dy: N, r: N, s: N) -> N:
    """(r + s)² - |d - c|², right to its last place until it is as small as the square of one.

    It says whether circles of radii r and s about c and d meet. The distance itself is never formed: rounded, it would
    leave nothing of a small difference. Nothing is what rounding the six numbers may have made: circles that touch.
    """
    (x, x_lost), (y, y_lost), (t, t_lost) = two_sum(dx, -cx), two_sum(dy, -cy), two_sum(r, s)
    (xx, xx_lost), (yy, yy_lost), (tt, tt_lost) = two_product(x, x), two_product(y, y), two_product(t, t)
    left, one = two_sum(tt, -xx)
    left, two = two_sum(left, -yy)
    left = left + (((one + two) + (tt_lost - xx_lost - yy_lost)) + 2 * (t * t_lost - x * x_lost - y * y_lost))
    return left * (abs(left) > doubt(cx, cy, dx, dy, r, s))


def doubt(cx: N, cy: N, dx: N, dy: N, r: N, s: N) -> N:
    """What may be nothing in such a gap: as much as one unit in the last place of each number makes, all together."""
    size = abs(cx) + abs(cy) + abs(dx) + abs(dy) + abs(r) + abs(s)
    return size * abs(r + s) * (SHORT_EPS if getattr(size, "itemsize", 8) == 4 else EPS)
