"""Assemblies of several links in hinges, whose number is unknown: searched from many start places, each one proved.

With the cosine and the sine of every link as unknowns, all ties are of the second degree. The test of R. Krawczyk near
a root is then exact, in rationals: Newton's steps from anywhere in a small box stay in it and converge, so the box
contains exactly one root.
"""

from collections.abc import Sequence
from fractions import Fraction

from planes.geometry.sextic import Counted, exact_parts
from planes.geometry.tracks import Pose, Tie, Ties, carrier_links, newton_step
from planes.words.frozen import frozen, replace

# start places; doubled, up to so many rounds, while any pose was found too seldom
FIRST_START_COUNT = 2048
MOST_SEARCH_ROUNDS = 5
NEWTON_STEPS = 60
LEAST_HITS_PER_POSE = 3
SAME_POSE_DISTANCE = 1e-6  # of the size: two poses closer than this are one
PROOF_BOX_SIZE = Fraction(1, 1 << 30)  # of the size, and of a cosine


def search_assemblies(ties: Ties, size: float) -> Counted:
    """All proved poses found from many start places; it is not proved that there are no others."""
    links = len(carrier_links(ties))
    over = [replace(t, local=t.local / size, place=t.place / size, reach=t.reach / size) for t in ties]
    met: list[tuple[Pose, int]] = []
    for k in range(MOST_SEARCH_ROUNDS):
        before = len(met)
        met = _converged_poses(over, links, FIRST_START_COUNT << k)
        if met and (min(count for _, count in met) >= LEAST_HITS_PER_POSE or (len(met) == before > 0 and k > 1)):
            break
    proven = sorted((pose for pose, _ in met if is_proved_assembly(over, pose)), key=lambda pose: pose[1].imag)
    return Counted(tuple((pose[0] * size, *pose[1:]) for pose in proven), len(met), False, whole=False)


def _converged_poses(ties: Ties, links: int, count: int) -> list[tuple[Pose, int]]:
    """Where Newton's steps converge from ``count`` start places, and how often."""
    import numpy as np

    rng = np.random.default_rng(count)
    held = [complex(t.place) for t in ties if t.kind != "hinge"]
    middle = sum(held) / len(held)
    reach = 1.0 + max(abs(z - held[0]) for z in held)
    place = middle + reach * (rng.uniform(-1, 1, count) + 1j * rng.uniform(-1, 1, count))
    pose: Pose = (place, *np.exp(2j * np.pi * rng.random((links, count))))
    with np.errstate(all="ignore"):
        for _ in range(NEWTON_STEPS):
            pose, moved, det = newton_step(ties, pose)
            pose = (pose[0], *(axis / abs(axis) for axis in pose[1:]))
    good = (moved < 1e-12 * (1 + abs(pose[0]))) & (abs(det) > 0)
    rows = np.array(pose)[:, good].T
    places = []
    while len(rows):
        near = abs(rows - rows[0]).max(axis=1) < SAME_POSE_DISTANCE * (1 + abs(rows[0][0]))
        places.append((tuple(map(complex, rows[0])), int(near.sum())))
        rows = rows[~near]
    return places


Affine = list[Fraction]  # the factors of the unknowns, and the constant term
Product = tuple[Affine, Affine]


@frozen
class Quadratic:
    """An equation of the second degree: products of affine forms plus one more affine form, equal to zero."""

    products: tuple[Product, ...]
    rest: Affine

    def residual(self, x: Sequence[Fraction]) -> Fraction:
        """The residual at a place."""
        return sum((_affine_value(a, x) * _affine_value(b, x) for a, b in self.products), _affine_value(self.rest, x))

    def gradient(self, x: Sequence[Fraction]) -> list[Fraction]:
        """The gradient at a place."""
        slopes = self.rest[:-1]
        for a, b in self.products:
            at_a = _affine_value(a, x)
            at_b = _affine_value(b, x)
            slopes = [s + at_a * q + at_b * p for s, p, q in zip(slopes, a[:-1], b[:-1], strict=True)]
        return slopes

    @property
    def second_degree_bound(self) -> Fraction:
        """An upper bound of the second-degree part where no unknown is off by more than 1."""
        return sum((_coefficient_sum(a) * _coefficient_sum(b) for a, b in self.products), Fraction(0))


def _affine_value(form: Affine, x: Sequence[Fraction]) -> Fraction:
    return sum((p * v for p, v in zip(form, x, strict=False)), form[-1])


def _coefficient_sum(form: Affine) -> Fraction:
    return sum(map(abs, form[:-1]), Fraction(0))


def is_proved_assembly(ties: Ties, pose: Pose) -> bool:
    """Whether exactly one assembly lies in a box about a pose; lengths are divided by the size of the links."""
    import numpy as np

    equations = tie_equations(ties, len(pose) - 1)
    x = [part for z in pose for part in exact_parts(z)]
    slopes = [e.gradient(x) for e in equations]
    try:
        inverse = np.linalg.inv(np.array(slopes, float))
    except np.linalg.LinAlgError:
        return False
    rows = [[Fraction(float(v)) for v in row] for row in inverse]
    values = [e.residual(x) for e in equations]
    bends = [e.second_degree_bound for e in equations]
    for k, row in enumerate(rows):
        step = abs(sum((p * v for p, v in zip(row, values, strict=True)), Fraction(0)))
        off = Fraction(0)
        for j in range(len(x)):
            off += abs((j == k) - sum((p * s[j] for p, s in zip(row, slopes, strict=True)), Fraction(0)))
        bent = sum((abs(p) * q for p, q in zip(row, bends, strict=True)), Fraction(0))
        if step + (off + 2 * bent * PROOF_BOX_SIZE) * PROOF_BOX_SIZE >= PROOF_BOX_SIZE:
            return False
    return True


def tie_equations(ties: Ties, links: int) -> list[Quadratic]:
    """The ties, and unit length of every axis; unknowns are the first origin and both components of every axis."""
    width = 3 + 2 * links
    axes = [(_unknown_form(2 + 2 * k, width), _unknown_form(3 + 2 * k, width)) for k in range(links)]
    places = [(_unknown_form(0, width), _unknown_form(1, width))] * min(links, 2)
    for t in ties:
        if t.kind == "hinge":
            places.append(_add_spots(places[t.link], _rotated_spot(axes[t.link], t.local)))
    held = [_tie_equation(t, places[t.link], axes[t.link]) for t in ties if t.kind != "hinge"]
    one = [Fraction(0)] * (width - 1) + [Fraction(-1)]
    return [*held, *(Quadratic(((c, c), (s, s)), one) for c, s in axes)]


Spot = tuple[Affine, Affine]


def _tie_equation(t: Tie, origin: Spot, axis: Spot) -> Quadratic:
    """A tie, by the definition of ``Tie.wrench``."""
    width = len(origin[0])
    place = exact_parts(t.place)
    turn = exact_parts(t.turn)
    reach = Fraction(t.reach)
    fixed = _constant_form(place[0], width), _constant_form(place[1], width)
    x, y = _subtract_spots(_add_spots(origin, _rotated_spot(axis, t.local)), fixed)
    if t.kind == "arc":
        return Quadratic(((x, x), (y, y)), _constant_form(-reach * reach, width))
    if t.kind == "line":
        height = [turn[0] * q - turn[1] * p for p, q in zip(x, y, strict=True)]
        return Quadratic((), [*height[:-1], height[-1] - reach])
    x, y = _subtract_spots(fixed, origin)
    u, v = _rotated_spot(axis, t.turn)
    local = exact_parts(t.local)
    beside = turn[0] * local[1] - turn[1] * local[0]  # direction of the guide, in the link's axes
    return Quadratic(((u, y), ([-q for q in v], x)), _constant_form(-beside - reach, width))


def _unknown_form(k: int, width: int) -> Affine:
    return [Fraction(j == k) for j in range(width)]


def _constant_form(value: Fraction, width: int) -> Affine:
    return [Fraction(0)] * (width - 1) + [value]


def _add_spots(one: Spot, two: Spot) -> Spot:
    a, b = one
    c, d = two
    return [p + q for p, q in zip(a, c, strict=True)], [p + q for p, q in zip(b, d, strict=True)]


def _subtract_spots(one: Spot, two: Spot) -> Spot:
    return _add_spots(one, ([-q for q in two[0]], [-q for q in two[1]]))


def _rotated_spot(axis: Spot, local: complex) -> Spot:
    """A place of a link relative to its origin, turned with the link."""
    x, y = exact_parts(local)
    c, s = axis
    return [x * p - y * q for p, q in zip(c, s, strict=True)], [x * q + y * p for p, q in zip(c, s, strict=True)]
