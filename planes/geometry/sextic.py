"""All assemblies of a link on three ties: with the place eliminated, a polynomial in the angle remains; none is missed.

Its degree in t = tan θ/2 is six at most, and it is formed from the numbers of the ties in rationals, without rounding.
So J. C. F. Sturm's theorem counts its real roots exactly, and each is bracketed by a change of sign.
"""

from __future__ import annotations

from fractions import Fraction
from functools import reduce

from planes.geometry.sturm import (
    Fractions,
    Polynomial,
    isolate_sturm_roots,
    narrow_down_root,
    primitive_polynomial,
    square_free_part,
    sturm_chain,
)
from planes.geometry.tracks import Pose, Tie, Ties, newton_step
from planes.words.frozen import frozen

NEWTON_STEPS = 12
NOTHING = Fraction(0), Fraction(0)


def exact_parts(z: complex) -> Fractions:
    """Both parts of a complex number, as exact binary fractions."""
    return Fraction(complex(z).real), Fraction(complex(z).imag)


@frozen
class Laurent:
    """A polynomial in e^{iθ} and its conjugate, with complex rational coefficients by powers."""

    terms: dict[int, Fractions]

    @classmethod
    def from_doubles(cls, terms: dict[int, complex]) -> Laurent:
        """From complex doubles, taken as exact."""
        return cls({k: exact_parts(z) for k, z in terms.items()})

    def __add__(self, other: Laurent) -> Laurent:
        terms = dict(self.terms)
        for k, (x, y) in other.terms.items():
            p, q = terms.get(k, NOTHING)
            terms[k] = p + x, q + y
        return Laurent(terms)

    def __sub__(self, other: Laurent) -> Laurent:
        return self + Laurent({k: (-x, -y) for k, (x, y) in other.terms.items()})

    def __mul__(self, other: Laurent) -> Laurent:
        terms: dict[int, Fractions] = {}
        for i, (x, y) in self.terms.items():
            for j, (u, v) in other.terms.items():
                p, q = terms.get(i + j, NOTHING)
                terms[i + j] = p + x * u - y * v, q + x * v + y * u
        return Laurent(terms)

    def conjugate(self) -> Laurent:
        """The conjugate."""
        return Laurent({-k: (x, -y) for k, (x, y) in self.terms.items()})

    def times_i(self) -> Laurent:
        """Times i."""
        return Laurent({k: (-y, x) for k, (x, y) in self.terms.items()})

    def value_at(self, z: complex) -> complex:
        """The value at e^{iθ}, rounded only once."""
        return sum((complex(float(x), float(y)) * z**k for k, (x, y) in self.terms.items()), 0j)


def constant(z: complex) -> Laurent:
    """A complex double as a polynomial of degree zero."""
    return Laurent.from_doubles({0: z})


@frozen
class Counted:
    """The poses found, the number of proved roots (each counted once), whether any is double, and whether these are
    all."""

    poses: tuple[Pose, ...]
    count: int
    double: bool
    whole: bool = True

    @property
    def is_count_proved(self) -> bool:
        """Whether every root gave a pose, and all are single."""
        return len(self.poses) == self.count and not self.double


def three_tie_assemblies(ties: Ties) -> Counted:
    """All poses of a link on three ties, by growing angle from -180°."""
    base, one, two = _ties_arc_first(ties)
    (eliminant, place, divisor) = _eliminant_and_place(base, one, two)
    poly, lost = half_tangent_polynomial(eliminant)
    if not poly:
        return Counted((), 0, True)
    own, double = square_free_part(poly)
    axes = [
        axis_of_half_tangent(float(narrow_down_root(own, low, high)))
        for low, high in isolate_sturm_roots(sturm_chain(own))
    ]
    axes += [-1 + 0j] * bool(lost)  # the highest power vanishes: a root at θ = 180°
    poses = []
    for axis in axes:
        below = divisor.value_at(axis)
        poses.append((base.place - base.local * axis + (place.value_at(axis) / below if below else 0j), axis))
    return Counted(tuple(p for pose in poses for p in refine_pose(ties, pose)), len(poses), double or lost > 1)


def axis_of_half_tangent(t: float) -> complex:
    """e^{iθ} of t = tan θ/2."""
    return (1 + 1j * t) ** 2 / (1 + t * t)


def refine_pose(ties: Ties, pose: Pose) -> list[Pose]:
    """The pose refined by Newton's steps; None where they do not converge nearby."""
    origin, axis = pose
    size = max(t.coordinate_sum for t in ties)
    for _ in range(NEWTON_STEPS):
        (origin, axis), moved, det = newton_step(ties, (origin, axis))
        if not det or abs(axis - pose[1]) > 1e-3:
            return []
        if moved < 1e-14 * (1 + size):
            break
    return [(origin, axis)]


def _ties_arc_first(ties: Ties) -> tuple[Tie, Tie, Tie]:
    """The arc first, if there is one: the other ties are written relative to it."""
    first = next((t for t in ties if t.kind == "arc"), ties[0])
    one, two = (t for t in ties if t is not first)
    return first, one, two


def tie_coefficients(t: Tie, base: Tie) -> tuple[Laurent, Laurent]:
    """A tie as 2 Re(ā Y) + b = 0 for Y, the base's point relative to the base's place."""
    r = t.local - base.local
    away = constant(t.place - base.place)
    half = constant(0.5)
    if t.kind == "guide":
        iw = 1j * t.turn
        force = Laurent.from_doubles({1: iw})
        b = (
            (force.conjugate() * away + force * away.conjugate()) * half
            - _exact_cross_product(t.turn, r)
            - constant(t.reach)
        )
        return Laurent.from_doubles({1: -0.5 * iw}), b
    arm = Laurent.from_doubles({1: r}) - away
    if t.kind == "line":
        iu = 1j * t.turn
        pull = constant(iu)
        return constant(0.5 * iu), (pull.conjugate() * arm + pull * arm.conjugate()) * half - constant(t.reach)
    lengths = [constant(x) * constant(x) for x in (t.reach, base.reach)]
    return arm, arm * arm.conjugate() - lengths[0] + lengths[1]


def _exact_cross_product(a: complex, b: complex) -> Laurent:
    """The cross product of two given vectors, exactly."""
    x, y, u, v = map(Fraction, (a.real, a.imag, b.real, b.imag))
    return Laurent({0: (x * v - y * u, Fraction(0))})


def _eliminant_and_place(base: Tie, one: Tie, two: Tie) -> tuple[Laurent, Laurent, Laurent]:
    """The polynomial that vanishes at an assembly, and Y = place / divisor."""
    a, b = tie_coefficients(one, base)
    c, d = tie_coefficients(two, base)
    divisor = a.conjugate() * c - a * c.conjugate()
    place = d * a - b * c
    if base.kind == "arc":
        reach = constant(base.reach)
        eliminant = place * place.conjugate() + reach * reach * divisor * divisor
    else:
        e, f = tie_coefficients(base, base)
        eliminant = (e.conjugate() * place - e * place.conjugate() + f * divisor).times_i()
    return eliminant, place, divisor


def half_tangent_polynomial(trigonometric: Laurent) -> tuple[Polynomial, int]:
    """A real trigonometric polynomial as one in t = tan θ/2, e^{iθ} = (1 + it) / (1 - it), with its sign; and how many
    of its highest powers vanish: the number of roots at θ = 180°."""
    n = max((abs(k) for k, z in trigonometric.terms.items() if any(z)), default=0)
    plus, minus = Laurent.from_doubles({0: 1, 1: 1j}), Laurent.from_doubles({0: 1, 1: -1j})  # in powers of t
    total = Laurent({})
    for k, z in trigonometric.terms.items():
        if any(z):
            factors = [plus] * (n + k) + [minus] * (n - k)
            total = total + reduce(Laurent.__mul__, factors, Laurent({0: z}))
    poly = primitive_polynomial([total.terms.get(k, NOTHING)[0] for k in range(2 * n + 1)])
    return poly, 2 * n + 1 - len(poly)
