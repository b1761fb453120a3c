"""All assemblies of a link on three ties, none missed: the place eliminated, a polynomial in the angle is left.

It is of degree six at most in t = tan θ/2, and made of the ties' numbers in rationals, without rounding; so J. C. F.
Sturm's theorem counts its real roots exactly, and each is caught between two places where its sign differs.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from itertools import pairwise
from math import gcd

from planes.geometry.tracks import Pose, Tie, advanced

CLOSE = Fraction(1, 1 << 40)  # how narrowly a root is caught before Newton's steps
STEPS = 12
Polynomial = list[Fraction]  # coefficients from the lowest power


@dataclass(frozen=True)
class Laurent:
    """A polynomial in e^{iθ} and its conjugate, with complex rational coefficients by powers."""

    terms: dict[int, tuple[Fraction, Fraction]]

    @classmethod
    def of(cls, terms: dict[int, complex]) -> Laurent:
        """From complex doubles, taken as they are."""
        return cls({k: (Fraction(complex(z).real), Fraction(complex(z).imag)) for k, z in terms.items()})

    def __add__(self, other: Laurent) -> Laurent:
        found = dict(self.terms)
        for k, (x, y) in other.terms.items():
            p, q = found.get(k, (Fraction(0), Fraction(0)))
            found[k] = p + x, q + y
        return Laurent(found)

    def __sub__(self, other: Laurent) -> Laurent:
        return self + Laurent({k: (-x, -y) for k, (x, y) in other.terms.items()})

    def __mul__(self, other: Laurent) -> Laurent:
        found: dict[int, tuple[Fraction, Fraction]] = {}
        for i, (x, y) in self.terms.items():
            for j, (u, v) in other.terms.items():
                p, q = found.get(i + j, (Fraction(0), Fraction(0)))
                found[i + j] = p + x * u - y * v, q + x * v + y * u
        return Laurent(found)

    def bar(self) -> Laurent:
        """The conjugate."""
        return Laurent({-k: (x, -y) for k, (x, y) in self.terms.items()})

    def turned(self) -> Laurent:
        """Times i."""
        return Laurent({k: (-y, x) for k, (x, y) in self.terms.items()})

    def at(self, z: complex) -> complex:
        """Its number at e^{iθ}, rounded once of all."""
        return sum((complex(float(x), float(y)) * z**k for k, (x, y) in self.terms.items()), 0j)


@dataclass(frozen=True)
class Counted:
    """The poses found, how many roots are proved (each once), whether any is double, and whether these are all."""

    poses: tuple[Pose, ...]
    count: int
    double: bool
    whole: bool = True

    @property
    def proved(self) -> bool:
        """Whether every root was found as a pose, each single."""
        return len(self.poses) == self.count and not self.double


def assemblies(ties: Sequence[Tie]) -> Counted:
    """Every pose of a link on three ties, by growing angle from -180°."""
    base, one, two = _order(ties)
    poly, place, divisor = _eliminated(base, one, two)
    if not any(poly):
        return Counted((), 0, True)
    chain = _sturm(poly)
    double = len(chain[-1]) > 1
    if double:  # every root once, as where a multiple one lies the whole chain vanishes and counts nothing
        poly = _divided(poly, chain[-1])[0]
        chain = _sturm(poly)
    found = []
    for low, high in _isolated(chain):
        t = float(_caught(poly, low, high))
        axis = (1 + 1j * t) ** 2 / (1 + t * t)
        below = divisor.at(axis)
        origin = base.place - base.local * axis + (place.at(axis) / below if below else 0j)
        found.append((origin, axis))
    if len(poly) % 2 == 0:  # the highest power is gone: a root at θ = 180°
        below = divisor.at(-1 + 0j)
        found.append((base.place + base.local + (place.at(-1 + 0j) / below if below else 0j), -1 + 0j))
    return Counted(tuple(p for pose in found for p in _settled(ties, pose)), len(found), double)


def _settled(ties: Sequence[Tie], pose: Pose) -> list[Pose]:
    """The pose by Newton's steps; nothing where they do not settle near it."""
    origin, axis = pose
    size = max(abs(t.place) + abs(t.local) + abs(t.reach) for t in ties)
    for _ in range(STEPS):
        (origin, axis), moved, det = advanced(ties, (origin, axis))
        if not det or abs(axis - pose[1]) > 1e-3:
            return []
        if moved < 1e-14 * (1 + size):
            break
    return [(origin, axis)]


def _order(ties: Sequence[Tie]) -> tuple[Tie, Tie, Tie]:
    """An arc first, if there is one: the others are told against it."""
    first = next((t for t in ties if t.kind == "arc"), ties[0])
    one, two = (t for t in ties if t is not first)
    return first, one, two


def _row(t: Tie, base: Tie) -> tuple[Laurent, Laurent]:
    """A tie as 2 Re(ā Y) + b = 0 for Y, where the base's point is against the base's place."""
    r, c = t.local - base.local, t.place - base.place
    if t.kind == "guide":
        iw = 1j * t.turn
        force, arm = Laurent.of({1: iw}), Laurent.of({0: c})
        half = Laurent.of({0: 0.5})
        b = (force.bar() * arm + force * arm.bar()) * half - _cross(t.turn, r) - Laurent.of({0: t.reach})
        return Laurent.of({1: -0.5 * iw}), b
    if t.kind == "line":
        iu = 1j * t.turn
        arm = Laurent.of({1: r}) - Laurent.of({0: c})
        pull, half = Laurent.of({0: iu}), Laurent.of({0: 0.5})
        return Laurent.of({0: 0.5 * iu}), (pull.bar() * arm + pull * arm.bar()) * half - Laurent.of({0: t.reach})
    a = Laurent.of({1: r}) - Laurent.of({0: c})
    lengths = [Laurent.of({0: x}) * Laurent.of({0: x}) for x in (t.reach, base.reach)]
    return a, a * a.bar() - lengths[0] + lengths[1]


def _cross(a: complex, b: complex) -> Laurent:
    """The cross product of two given vectors, exactly."""
    x, y, u, v = (Fraction(q) for q in (a.real, a.imag, b.real, b.imag))
    return Laurent({0: (x * v - y * u, Fraction(0))})


def _eliminated(base: Tie, one: Tie, two: Tie) -> tuple[Polynomial, Laurent, Laurent]:
    """The polynomial in t, and Y = place / divisor."""
    (a, b), (c, d) = _row(one, base), _row(two, base)
    divisor, place = a.bar() * c - a * c.bar(), d * a - b * c
    if base.kind == "arc":
        reach = Laurent.of({0: base.reach})
        whole = place * place.bar() + reach * reach * divisor * divisor
    else:
        e, f = _row(base, base)
        whole = (e.bar() * place - e * place.bar() + f * divisor).turned()
    return _in_tangent(whole), place, divisor


def _in_tangent(whole: Laurent) -> Polynomial:
    """A real trigonometric polynomial as one in t = tan θ/2: e^{iθ} = (1 + it) / (1 - it)."""
    n = max((abs(k) for k, z in whole.terms.items() if any(z)), default=0)
    plus, minus = Laurent.of({0: 1, 1: 1j}), Laurent.of({0: 1, 1: -1j})  # in powers of t
    total = Laurent({})
    for k, z in whole.terms.items():
        if any(z):
            factors = [plus] * (n + k) + [minus] * (n - k)
            total = total + reduce(Laurent.__mul__, factors, Laurent({0: z}))
    poly = [total.terms.get(k, (Fraction(0), Fraction(0)))[0] for k in range(2 * n + 1)]
    return _trimmed(poly)


def _trimmed(poly: Polynomial) -> Polynomial:
    """Without the highest powers that are nothing, in whole numbers without a common factor."""
    while poly and not poly[-1]:
        poly = poly[:-1]
    if not poly:
        return []
    below = reduce(lambda m, q: m * q.denominator // gcd(m, q.denominator), poly, 1)
    whole = [int(q * below) for q in poly]
    common = gcd(*whole)
    return [Fraction(q // common) for q in whole]


def _value(poly: Polynomial, t: Fraction) -> Fraction:
    total = Fraction(0)
    for q in reversed(poly):
        total = total * t + q
    return total


def _sturm(poly: Polynomial) -> list[Polynomial]:
    """Sturm's chain: the polynomial, its slope, and the remainders with their signs turned."""
    chain = [poly, _trimmed([k * q for k, q in enumerate(poly)][1:])]
    while len(chain[-1]) > 1:
        rest = _divided(chain[-2], chain[-1])[1]
        if not any(rest):
            break
        chain.append([-q for q in _trimmed(rest)])
    return [c for c in chain if c]


def _divided(poly: Polynomial, by: Polynomial) -> tuple[Polynomial, Polynomial]:
    """The quotient of two polynomials and what is left."""
    rest, found = list(poly), list[Fraction]()
    while len(rest) >= len(by):
        factor, shift = rest[-1] / by[-1], len(rest) - len(by)
        found.append(factor)
        rest = [q - factor * by[k - shift] if k >= shift else q for k, q in enumerate(rest)][:-1]
    return found[::-1], rest


def _changes(chain: list[Polynomial], t: Fraction) -> int:
    signs = [s for s in (_value(c, t) for c in chain) if s]
    return sum((one > 0) != (two > 0) for one, two in pairwise(signs))


def _isolated(chain: list[Polynomial]) -> list[tuple[Fraction, Fraction]]:
    """Ranges (low, high] with one root each."""
    poly = chain[0]
    bound = 1 + max((abs(q / poly[-1]) for q in poly[:-1]), default=Fraction(0))
    edge = Fraction(1 << (int(bound) + 1).bit_length())
    found, left = [], [(-edge, edge, _changes(chain, -edge), _changes(chain, edge))]
    while left:
        low, high, before, after = left.pop()
        if before - after == 1:
            found.append((low, high))
        elif before > after:
            middle = (low + high) / 2
            between = _changes(chain, middle)
            left += [(middle, high, between, after), (low, middle, before, between)]
    return found


def _caught(poly: Polynomial, low: Fraction, high: Fraction) -> Fraction:
    """The one root of a range, narrowly; where a double root leaves no change of sign, the middle."""
    above = _value(poly, high)
    if not above:
        return high
    if (_value(poly, low) > 0) == (above > 0):
        return (low + high) / 2
    while high - low > CLOSE * (1 + min(abs(low), abs(high)) ** 2):
        middle = (low + high) / 2
        value = _value(poly, middle)
        if not value:
            return middle
        low, high = (low, middle) if (value > 0) == (above > 0) else (middle, high)
    return (low + high) / 2
