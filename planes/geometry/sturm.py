"""Polynomials in rationals, without rounding: how many real roots there are by J. C. F. Sturm's theorem, and each
caught between two places where the sign differs."""

from collections.abc import Iterable
from fractions import Fraction
from itertools import pairwise
from math import gcd, lcm

BRACKET_WIDTH = Fraction(1, 1 << 40)  # width of a bracket before Newton's steps
Fractions = tuple[Fraction, Fraction]
Polynomial = list[Fraction]  # coefficients, lowest power first


def primitive_polynomial(poly: Polynomial) -> Polynomial:
    """Without vanishing highest powers, in whole numbers without a common factor."""
    while poly and not poly[-1]:
        poly = poly[:-1]
    if not poly:
        return []
    below = lcm(*(q.denominator for q in poly))
    integers = [int(q * below) for q in poly]
    common = gcd(*integers)
    return [Fraction(q // common) for q in integers]


def polynomial_value(poly: Polynomial, t: Fraction) -> Fraction:
    """The value at t."""
    total = Fraction(0)
    for q in reversed(poly):
        total = total * t + q
    return total


def sturm_chain(poly: Polynomial) -> list[Polynomial]:
    """Sturm's chain: the polynomial, its derivative, and the remainders with reversed signs."""
    chain = [poly, primitive_polynomial([k * q for k, q in enumerate(poly)][1:])]
    while len(chain[-1]) > 1:
        rest = divide_polynomials(chain[-2], chain[-1])[1]
        if not any(rest):
            break
        chain.append([-q for q in primitive_polynomial(rest)])
    return [c for c in chain if c]


def divide_polynomials(poly: Polynomial, by: Polynomial) -> tuple[Polynomial, Polynomial]:
    """The quotient and the remainder of two polynomials."""
    rest = list(poly)
    quotient = []
    while len(rest) >= len(by):
        factor = rest[-1] / by[-1]
        shift = len(rest) - len(by)
        quotient.append(factor)
        rest = [q - factor * by[k - shift] if k >= shift else q for k, q in enumerate(rest)][:-1]
    return quotient[::-1], rest


def count_sign_changes(chain: list[Polynomial], t: Fraction) -> int:
    """The number of sign changes in a chain at t."""
    return sign_changes(polynomial_value(c, t) for c in chain)


def sign_changes(numbers: Iterable[int | Fraction]) -> int:
    """The number of sign changes along some numbers, zeros left out."""
    return sum(one != two for one, two in pairwise([q > 0 for q in numbers if q]))


def isolate_sturm_roots(chain: list[Polynomial]) -> list[Fractions]:
    """Intervals (low, high] with one root each."""
    poly = chain[0]
    bound = 1 + max((abs(q / poly[-1]) for q in poly[:-1]), default=Fraction(0))
    edge = Fraction(1 << (int(bound) + 1).bit_length())
    ranges = []
    left = [(-edge, edge, count_sign_changes(chain, -edge), count_sign_changes(chain, edge))]
    while left:
        low, high, before, after = left.pop()
        if before - after == 1:
            ranges.append((low, high))
        elif before > after:
            middle = (low + high) / 2
            between = count_sign_changes(chain, middle)
            left += [(middle, high, between, after), (low, middle, before, between)]
    return ranges


def narrow_down_root(poly: Polynomial, low: Fraction, high: Fraction) -> Fraction:
    """The only root of an interval, narrowed down; for a double root without a change of sign, the middle."""
    above = polynomial_value(poly, high)
    if not above:
        return high
    if (polynomial_value(poly, low) > 0) == (above > 0):
        return (low + high) / 2
    while high - low > BRACKET_WIDTH * (1 + min(abs(low), abs(high)) ** 2):
        middle = (low + high) / 2
        here = polynomial_value(poly, middle)
        if not here:
            return middle
        low, high = (low, middle) if (here > 0) == (above > 0) else (middle, high)
    return (low + high) / 2


def square_free_part(poly: Polynomial) -> tuple[Polynomial, bool]:
    """A polynomial with every root once, and whether any was multiple: at a multiple root Sturm's whole chain vanishes
    and the count fails."""
    rest = sturm_chain(poly)[-1]
    if len(rest) > 1:
        return (divide_polynomials(poly, rest)[0], True)
    return (poly, False)


def greatest_common_divisor(one: Polynomial, two: Polynomial) -> Polynomial:
    """The greatest common divisor, by Euclid."""
    while two:
        one, two = two, primitive_polynomial(divide_polynomials(one, two)[1])
    return one


def sign_at_root(poly: Polynomial, low: Fraction, high: Fraction, other: Polynomial) -> int:
    """The sign of another polynomial at the only root of this one in (low, high], where it is not zero."""
    chain = sturm_chain(other)
    while count_sign_changes(chain, low) != count_sign_changes(chain, high) or not polynomial_value(other, low):
        middle = (low + high) / 2
        own = sturm_chain(poly)
        low, high = (low, middle) if count_sign_changes(own, low) > count_sign_changes(own, middle) else (middle, high)
    return 1 if polynomial_value(other, low) > 0 else -1
