"""All assemblies of a link with two ties along parallel lines, where the general polynomial is a perfect square.

The link can move freely along these lines, so the two ties alone determine its angle: a polynomial of the second degree
in t = tan θ/2. The third tie then fixes its place along them: an arc in two places, a line in one.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from fractions import Fraction

from planes.geometry import plane
from planes.geometry.sextic import (
    Counted,
    Laurent,
    axis_of_half_tangent,
    constant,
    half_tangent_polynomial,
    refine_pose,
    tie_coefficients,
)
from planes.geometry.sturm import (
    greatest_common_divisor,
    isolate_sturm_roots,
    narrow_down_root,
    sign_at_root,
    square_free_part,
    sturm_chain,
)
from planes.geometry.tracks import Pose, Tie, Ties
from planes.words.frozen import frozen, replace

MOST_PARALLEL_SINE = 2e-15  # the sine of an angle between lines that counts as parallel in a drawing


def find_parallel_ties(ties: Ties) -> Parallel | None:
    """Two of three ties whose lines are parallel at every angle of the link, and the third; None where there are
    none."""
    for k in range(3):
        one = ties[k - 2]
        two = ties[k - 1]
        if one.kind == two.kind != "arc" and abs(plane.cross(one.turn, two.turn)) <= MOST_PARALLEL_SINE:
            same = math.copysign(1.0, plane.dot(one.turn, two.turn))
            return Parallel(tuple(ties), ties[k], one, replace(two, turn=one.turn, reach=same * two.reach))
    return None


@frozen
class Parallel:
    """Two ties with lines of one direction, and the third one, ``beside`` them."""

    ties: tuple[Tie, ...]
    beside: Tie
    one: Tie
    two: Tie

    @property
    def first_tie_coefficients(self) -> tuple[Laurent, Laurent]:
        """One of them as 2 Re(ā Y) + b = 0, with Y relative to the third tie."""
        return tie_coefficients(self.one, self.beside)

    @property
    def reach_polynomial(self) -> Laurent:
        """Positive where an arc beside can be reached, zero where it is just reached; for a line, zero where it is
        parallel to both."""
        a, b = self.first_tie_coefficients
        if self.beside.kind == "arc":
            reach = constant(self.beside.reach)
            four = constant(4)
            return reach * reach * four * a * a.conjugate() - b * b
        e, _ = tie_coefficients(self.beside, self.beside)
        return (e.conjugate() * a - e * a.conjugate()).times_i()

    def assemblies(self) -> Counted:
        """All poses, by growing angle from -180°."""
        apart = tie_coefficients(self.two, self.beside)[1] - self.first_tie_coefficients[1]
        limit = self.reach_polynomial
        poly, lost = half_tangent_polynomial(apart)
        bound, _ = half_tangent_polynomial(limit)
        if not poly or not bound:  # one line given twice, or three parallel ones
            return Counted((), 0, True)
        own, double = square_free_part(poly)
        far = _value_at_half_turn(limit)
        if len(greatest_common_divisor(own, bound)) > 1 or (lost and not far):
            return Counted((), 0, True)
        roots = [
            (float(narrow_down_root(own, *r)), sign_at_root(own, *r, bound))
            for r in isolate_sturm_roots(sturm_chain(own))
        ]
        axes = [(axis_of_half_tangent(t), sign) for t, sign in roots] + [(-1 + 0j, 1 if far > 0 else -1)] * bool(lost)
        poses = [pose for axis, sign in axes for pose in self._poses_at_angle(axis, sign)]
        return Counted(tuple(p for pose in poses for p in refine_pose(self.ties, pose)), len(poses), double or lost > 1)

    def _poses_at_angle(self, axis: complex, sign: int) -> Iterator[Pose]:
        """The poses at an angle; ``sign`` is that of the limit."""
        one, two = self.first_tie_coefficients
        a = one.value_at(axis)
        b = two.value_at(axis).real
        base = self.beside
        if base.kind != "arc":
            e, f = (x.value_at(axis) for x in tie_coefficients(base, base))
            places = [(b * e - f.real * a) / (e.conjugate() * a - e * a.conjugate())]
        elif sign < 0:
            return
        else:
            half = cmath.sqrt(base.reach**2 - (b / (2 * abs(a))) ** 2).real
            places = [a / abs(a) * (-b / (2 * abs(a)) + side * half * 1j) for side in (1.0, -1.0)]
        yield from ((base.place - base.local * axis + place, axis) for place in places)


def _value_at_half_turn(trigonometric: Laurent) -> Fraction:
    """The value of a real trigonometric polynomial at θ = 180°, exactly."""
    return sum((-x if k % 2 else x for k, (x, _) in trigonometric.terms.items()), Fraction(0))
