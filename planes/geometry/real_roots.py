"""The real roots of a polynomial in whole numbers, each in a range of its own: none is missed.

By R. Descartes' rule of signs in ranges halved until it is exact, as G. E. Collins and A. G. Akritas do.
"""

from fractions import Fraction
from itertools import pairwise

DEPTH = 400  # ranges are halved so often at most; beyond that two roots are one
NARROW = 8  # and as often beyond whole numbers, to catch a root
Line = list[int]  # a polynomial, from the lowest power


def isolated(poly: Line) -> list[tuple[Fraction, Fraction]] | None:
    """Ranges of u with one real root each; None where two roots are one."""
    lead = poly[-1].bit_length()
    more = [-((lead - 2 - q.bit_length()) // k) for k, q in enumerate(reversed(poly[:-1]), 1)]
    edge = 3 << max(0, *more, 0)  # beyond twice the largest of |a/lead|^(1/k) there is none (M. Fujiwara)
    start = _stretched(_shifted_by(poly, -edge), 2 * edge)
    ranges, left = list[tuple[Fraction, Fraction]](), [(start, Fraction(-edge), Fraction(2 * edge), 0)]
    while left:
        here, low, wide, depth = left.pop()
        changes = _changes(_shifted(here[::-1]))
        if changes == 1:
            ranges.append((low, low + wide))
        if changes < 2:
            continue
        halves = [q << (len(here) - 1 - k) for k, q in enumerate(here)]
        upper = _shifted(halves)
        if depth == DEPTH or not upper[0]:
            return None
        left += [(halves, low, wide / 2, depth + 1), (upper, low + wide / 2, wide / 2, depth + 1)]
    return ranges


def _shifted(poly: Line) -> Line:
    """At one more."""
    shifted = poly[:]
    for k in range(len(shifted) - 1):
        for j in reversed(range(k, len(shifted) - 1)):
            shifted[j] += shifted[j + 1]
    return shifted


def _shifted_by(poly: Line, by: int) -> Line:
    return [q // by**k for k, q in enumerate(_shifted(_stretched(poly, by)))]


def _stretched(poly: Line, by: int) -> Line:
    """With the unknown so many times as large."""
    return [q * by**k for k, q in enumerate(poly)]


def _changes(poly: Line) -> int:
    signs = [q > 0 for q in poly if q]
    return sum(one != two for one, two in pairwise(signs))


def caught(poly: Line, low: Fraction, high: Fraction) -> Fraction:
    """The one root of a range, narrowly."""

    def above(u: Fraction) -> bool:
        total, power = 0, 1
        for q in reversed(poly):
            total, power = total * u.numerator + q * power, power * u.denominator
        return total > 0

    top = above(high)
    for _ in range(NARROW + int(high - low).bit_length()):
        middle = (low + high) / 2
        low, high = (low, middle) if above(middle) == top else (middle, high)
    return (low + high) / 2
