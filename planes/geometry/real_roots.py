"""The real roots of a polynomial with integer coefficients, each isolated in an interval; none is missed.

By R. Descartes' rule of signs on intervals halved until the count is exact (G. E. Collins and A. G. Akritas).
"""

from fractions import Fraction

from planes.geometry.sturm import Fractions, sign_changes

MOST_HALVINGS = 400  # most halvings of an interval; if two roots are still together, they count as one
EXTRA_HALVINGS = 8  # further halvings below whole numbers, to narrow down a root
Line = list[int]  # a polynomial, lowest power first


def isolate_real_roots(poly: Line) -> list[Fractions] | None:
    """Intervals of u with one real root each; None where two roots coincide."""
    lead = poly[-1].bit_length()
    more = [-((lead - 2 - q.bit_length()) // k) for k, q in enumerate(reversed(poly[:-1]), 1)]
    edge = 3 << max(0, *more, 0)  # no root exceeds twice the largest |a/lead|^(1/k) (M. Fujiwara)
    start = _stretch_unknown(_shift_unknown(poly, -edge), 2 * edge)
    ranges = []
    left = [(start, Fraction(-edge), Fraction(2 * edge), 0)]
    while left:
        here, low, wide, depth = left.pop()
        changes = sign_changes(_shift_unknown_by_one(here[::-1]))
        if changes == 1:
            ranges.append((low, low + wide))
        if changes < 2:
            continue
        halves = [q << (len(here) - 1 - k) for k, q in enumerate(here)]
        upper = _shift_unknown_by_one(halves)
        if depth == MOST_HALVINGS or not upper[0]:
            return None
        left += [(halves, low, wide / 2, depth + 1), (upper, low + wide / 2, wide / 2, depth + 1)]
    return ranges


def _shift_unknown_by_one(poly: Line) -> Line:
    """The polynomial of u + 1."""
    shifted = poly[:]
    for k in range(len(shifted) - 1):
        for j in reversed(range(k, len(shifted) - 1)):
            shifted[j] += shifted[j + 1]
    return shifted


def _shift_unknown(poly: Line, by: int) -> Line:
    return [q // by**k for k, q in enumerate(_shift_unknown_by_one(_stretch_unknown(poly, by)))]


def _stretch_unknown(poly: Line, by: int) -> Line:
    """The polynomial of the unknown times a factor."""
    return [q * by**k for k, q in enumerate(poly)]


def narrow_down_root(poly: Line, low: Fraction, high: Fraction) -> Fraction:
    """The only root in an interval, narrowed down."""

    def above(u: Fraction) -> bool:
        total = 0
        power = 1
        for q in reversed(poly):
            total = total * u.numerator + q * power
            power = power * u.denominator
        return total > 0

    top = above(high)
    for _ in range(EXTRA_HALVINGS + int(high - low).bit_length()):
        middle = (low + high) / 2
        low, high = (low, middle) if above(middle) == top else (middle, high)
    return (low + high) / 2
