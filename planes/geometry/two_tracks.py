"""All assemblies of two links in a hinge, on two ties each: each link traces a curve with the hinge, and the curves
cross there; none is missed.

With the hinge at (x, y) a tie is linear in the cosine and the sine of its link's angle. So two ties give both, and cos²
+ sin² = 1 is the equation of the curve, of degree six at most. J. J. Sylvester's determinant, which eliminates y, is
formed from the numbers of the ties in whole numbers, without rounding; so its real roots are counted exactly.
"""

import cmath
import math
from collections.abc import Iterator
from fractions import Fraction
from functools import reduce
from itertools import pairwise, product
from math import comb, lcm

from planes.geometry.arithmetic import EPS
from planes.geometry.real_roots import Line, isolate_real_roots, narrow_down_root
from planes.geometry.sextic import Counted, exact_parts
from planes.geometry.sturm import Polynomial, primitive_polynomial
from planes.geometry.tracks import Pose, Tie, Ties, newton_step

SLANT_FACTORS = (53, 31)  # the unknown u = 53x + 31y: no two crossings of a symmetrical figure share it
NEWTON_STEPS = 40
MOST_ROOT_ROUNDS = 200  # rounds; a pair of near roots needs fifty
Coefficients = list[int | Fraction]  # of a polynomial in one unknown, lowest power first
Plane = dict[tuple[int, int], int]  # a polynomial in x and y: integer coefficients by powers


def two_link_assemblies(ties: Ties) -> Counted:
    """All poses of the two links: the place of their hinge and both axes."""
    lengths = [x for t in ties for x in (*exact_parts(t.local), *exact_parts(t.place), Fraction(t.reach))]
    unit = lcm(*(x.denominator for x in lengths))
    tracks = [
        _in_slanted_unknown(_hinge_curve([_cosine_sine_coefficients(t, unit) for t in ties if t.link == k]))
        for k in (0, 1)
    ]
    left = _resultant_in_u(tracks)
    ranges = isolate_real_roots(left) if left else None
    if ranges is None:
        return Counted((), 0, True)
    poses = [
        p for low, high in ranges for p in _poses_at_crossing(ties, tracks, narrow_down_root(left, low, high), unit)
    ]
    return Counted(tuple(sorted(poses, key=lambda pose: cmath.phase(pose[1]))), len(ranges), False)


def _cosine_sine_coefficients(t: Tie, unit: int) -> tuple[Plane, Plane, Plane]:
    """A tie as A cos + B sin = C."""
    turn = exact_parts(t.turn)
    denominator = 1 if t.kind == "arc" else lcm(*(x.denominator for x in turn))
    lx, ly, px, py, reach = (int(z * unit) for z in (*exact_parts(t.local), *exact_parts(t.place), Fraction(t.reach)))
    tx, ty = (int(x * denominator) for x in turn)
    gx: Plane = {(1, 0): 1, (0, 0): -px}
    gy: Plane = {(0, 1): 1, (0, 0): -py}
    if t.kind == "arc":
        size = _weighted_sum(
            (1, _polynomial_product(gx, gx)),
            (1, _polynomial_product(gy, gy)),
            (lx * lx + ly * ly - reach * reach, UNIT_POLYNOMIAL),
        )
        return (
            _weighted_sum((2 * lx, gx), (2 * ly, gy)),
            _weighted_sum((-2 * ly, gx), (2 * lx, gy)),
            _weighted_sum((-1, size)),
        )
    if t.kind == "line":
        cos = {(0, 0): tx * ly - ty * lx}
        sin = {(0, 0): tx * lx + ty * ly}
        return cos, sin, _weighted_sum((-tx, gy), (ty, gx), (reach * denominator, UNIT_POLYNOMIAL))
    return (
        _weighted_sum((-tx, gy), (ty, gx)),
        _weighted_sum((ty, gy), (tx, gx)),
        {(0, 0): tx * ly - ty * lx + reach * denominator},
    )


UNIT_POLYNOMIAL: Plane = {(0, 0): 1}


def _weighted_sum(*terms: tuple[int, Plane]) -> Plane:
    total: Plane = {}
    for factor, poly in terms:
        for k, q in poly.items():
            total[k] = total.get(k, 0) + factor * q
    return {k: q for k, q in total.items() if q}


def _polynomial_product(one: Plane, two: Plane) -> Plane:
    terms: Plane = {}
    for (i, j), p in one.items():
        for (k, m), q in two.items():
            terms[i + k, j + m] = terms.get((i + k, j + m), 0) + p * q
    return terms


def _hinge_curve(rows: list[tuple[Plane, Plane, Plane]]) -> Plane:
    """The curve of the hinge that two ties of a link allow."""
    (a, b, c), (d, e, f) = rows
    cos = _weighted_sum((1, _polynomial_product(c, e)), (-1, _polynomial_product(f, b)))
    sin = _weighted_sum((1, _polynomial_product(a, f)), (-1, _polynomial_product(d, c)))
    both = _weighted_sum((1, _polynomial_product(a, e)), (-1, _polynomial_product(d, b)))
    return _weighted_sum(
        (1, _polynomial_product(cos, cos)), (1, _polynomial_product(sin, sin)), (-1, _polynomial_product(both, both))
    )


def _total_degree(track: Plane) -> int:
    return max((i + j for i, j in track), default=0)


def _in_slanted_unknown(track: Plane) -> Plane:
    """The same curve in u and y."""
    along, up = SLANT_FACTORS
    degree = _total_degree(track)
    slanted = Plane()
    for (i, j), q in track.items():
        for k in range(i + 1):  # x = (u − up·y) / along
            term = q * comb(i, k) * (-up) ** (i - k) * along ** (degree - i)
            slanted[k, j + i - k] = slanted.get((k, j + i - k), 0) + term
    return _weighted_sum((1, slanted))


def _polynomial_in_y(track: Plane, u: int | Fraction) -> Coefficients:
    """The polynomial in y of a curve at one u, lowest power first; equally long for every u."""
    coefficients: Coefficients = [0] * (1 + max((j for _, j in track), default=0))
    for (k, j), q in track.items():
        coefficients[j] += q * u**k
    return coefficients


def _resultant_in_u(tracks: list[Plane]) -> Line:
    """The resultant of both curves, with y eliminated: a polynomial in u, by interpolation."""
    degree = _total_degree(tracks[0]) * _total_degree(tracks[1])
    values = [
        _determinant(_sylvester_matrix(*(_polynomial_in_y(track, u) for track in tracks))) for u in range(degree + 1)
    ]
    differences = []
    table = values
    factorial = 1
    for k in range(degree + 1):
        differences.append(Fraction(table[0], factorial))
        table = [b - a for a, b in pairwise(table)]
        factorial = factorial * (k + 1)
    poly: Polynomial = []
    for k in reversed(range(degree + 1)):  # Newton's form, expanded from the inside
        shifted = [Fraction(0), *poly]
        poly = [s - k * p for s, p in zip(shifted, [*poly, Fraction(0)], strict=True)]
        poly[0] += differences[k]
    return [int(q) for q in primitive_polynomial(poly)]


def _sylvester_matrix(one: Coefficients, two: Coefficients) -> list[list[int]]:
    counted = (one, len(two) - 1), (two, len(one) - 1)
    rows = ([0] * k + poly[::-1] + [0] * (n - 1 - k) for poly, n in counted for k in range(n))
    return [[int(q) for q in row] for row in rows]


def _determinant(rows: list[list[int]]) -> int:
    """The determinant without fractions, by E. H. Bareiss."""
    sign = 1
    last = 1
    size = len(rows)
    for k in range(size - 1):
        pivot = next((i for i in range(k, size) if rows[i][k]), None)
        if pivot is None:
            return 0
        if pivot != k:
            rows[k], rows[pivot], sign = rows[pivot], rows[k], -sign
        for i in range(k + 1, size):
            rows[i] = [(rows[i][j] * rows[k][k] - rows[i][k] * rows[k][j]) // last if j > k else 0 for j in range(size)]
        last = rows[k][k]
    return sign * rows[-1][-1] if size else 1


def _poses_at_crossing(ties: Ties, tracks: list[Plane], u: Fraction, unit: int) -> Iterator[Pose]:
    """The pose where both curves have the same u, by Newton's steps; None where they do not converge there."""
    one, two = (_approximate_roots(_polynomial_in_y(track, u), unit) for track in tracks)
    a, b = min(product(one, two), key=lambda pair: abs(pair[0] - pair[1]))
    y = (a + b).real / 2
    at = float(u / unit)
    size = max(t.coordinate_sum for t in ties)
    hinge = complex((at - SLANT_FACTORS[1] * y) / SLANT_FACTORS[0], y)
    pose: Pose = (hinge, *(_axis_from_hinge([t for t in ties if t.link == side], hinge) for side in (0, 1)))
    for _ in range(NEWTON_STEPS):
        pose, moved, det = newton_step(ties, pose)
        if not det:
            return
        if moved < 1e-13 * (1 + size):
            break
    off = SLANT_FACTORS[0] * pose[0].real + SLANT_FACTORS[1] * pose[0].imag - at
    if moved < 1e-9 * (1 + size) and abs(off) < 1e-7 * sum(SLANT_FACTORS) * size:
        yield pose


def _approximate_roots(poly: Coefficients, unit: int) -> list[complex]:
    """All roots, close enough to start Newton's steps (Weierstrass; Durand, Solutions numériques, 1960)."""
    scaled = [Fraction(q) * unit**k for k, q in enumerate(poly)]
    most = max(map(abs, scaled))
    shares = [float(q / most) for q in scaled]
    while shares and not shares[-1]:
        shares.pop()
    size = 1 + max(abs(q / shares[-1]) for q in shares)
    roots = [size * cmath.rect(0.5, 0.4 + 2 * math.pi * k / (len(shares) - 1)) for k in range(len(shares) - 1)]
    for _ in range(MOST_ROOT_ROUNDS):
        most_moved = 0.0
        for k, z in enumerate(roots):
            value = reduce(lambda sum_, q: sum_ * z + q, reversed(shares), 0j)
            apart = math.prod((z - other for j, other in enumerate(roots) if j != k), start=complex(shares[-1]))
            step = value / apart if apart else 0j
            roots[k] = z - step
            most_moved = max(most_moved, abs(step) / size)
        if most_moved < EPS:
            break
    return roots


def _axis_from_hinge(ties: Ties, hinge: complex) -> complex:
    """The axis of a link on two ties, with its hinge given."""
    rows = []
    for t in ties:
        right, up, left, down = (float(t.error_and_wrench(hinge, axis)[0]) for axis in (1 + 0j, 1j, -1 + 0j, -1j))
        rows.append((complex(right - left, up - down), -(right + left)))
    (a, p), (b, q) = rows
    z = 1j * (q * a - p * b) / ((a.conjugate() * b).imag or 1.0)
    return z / (abs(z) or 1.0)
