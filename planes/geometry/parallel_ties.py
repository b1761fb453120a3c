"""All assemblies of a link with two ties along parallel lines, where the general polynomial is a perfect square.

The link can move freely along these lines, so the two ties alone determine its angle: a polynomial of the second degree
in t = tan θ/2. The third tie then fixes its place along them: an arc in two places, a line in one.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from fractions import Fraction

from planes.geometry import plane
from planes.geometry.sextic import Counted, Laurent, axis_at, in_tangent, row, settled
from planes.geometry.sturm import caught, common, each_once, isolated, sign_at, sturm
from planes.geometry.tracks import Pose, Tie
from planes.words.frozen import frozen, replace

FLAT = 2e-15  # the sine of an angle between lines that counts as parallel in a drawing


def parallel(ties: Sequence[Tie]) -> Parallel | None:
    """Two of three ties whose lines are parallel at every angle of the link, and the third; None where there are
    none."""
    for k in range(3):
        one, two = ties[k - 2], ties[k - 1]
        if one.kind == two.kind != "arc" and abs(plane.cross(one.turn, two.turn)) <= FLAT:
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
    def rows(self) -> tuple[Laurent, Laurent]:
        """One of them as 2 Re(ā Y) + b = 0, with Y relative to the third tie."""
        return row(self.one, self.beside)

    @property
    def limit(self) -> Laurent:
        """Positive where an arc beside can be reached, zero where it is just reached; for a line, zero where it is
        parallel to both."""
        a, b = self.rows
        if self.beside.kind == "arc":
            reach, four = Laurent.of({0: self.beside.reach}), Laurent.of({0: 4})
            return reach * reach * four * a * a.bar() - b * b
        e, _ = row(self.beside, self.beside)
        return (e.bar() * a - e * a.bar()).turned()

    def assemblies(self) -> Counted:
        """All poses, by growing angle from -180°."""
        apart, limit = row(self.two, self.beside)[1] - self.rows[1], self.limit
        (poly, lost), (bound, _) = in_tangent(apart), in_tangent(limit)
        if not poly or not bound:  # one line given twice, or three parallel ones
            return Counted((), 0, True)
        (own, double), far = each_once(poly), _at_half_turn(limit)
        if len(common(own, bound)) > 1 or (lost and not far):
            return Counted((), 0, True)
        roots = [(float(caught(own, *r)), sign_at(own, *r, bound)) for r in isolated(sturm(own))]
        axes = [(axis_at(t), sign) for t, sign in roots] + [(-1 + 0j, 1 if far > 0 else -1)] * bool(lost)
        poses = [pose for axis, sign in axes for pose in self._along(axis, sign)]
        return Counted(tuple(p for pose in poses for p in settled(self.ties, pose)), len(poses), double or lost > 1)

    def _along(self, axis: complex, sign: int) -> Iterator[Pose]:
        """The poses at an angle; ``sign`` is that of the limit."""
        one, two = self.rows
        a, b, base = one.at(axis), two.at(axis).real, self.beside
        if base.kind != "arc":
            e, f = (x.at(axis) for x in row(base, base))
            places = [(b * e - f.real * a) / (e.conjugate() * a - e * a.conjugate())]
        elif sign < 0:
            return
        else:
            half = cmath.sqrt(base.reach**2 - (b / (2 * abs(a))) ** 2).real
            places = [a / abs(a) * (-b / (2 * abs(a)) + side * half * 1j) for side in (1.0, -1.0)]
        yield from ((base.place - base.local * axis + place, axis) for place in places)


def _at_half_turn(trigonometric: Laurent) -> Fraction:
    """The value of a real trigonometric polynomial at θ = 180°, exactly."""
    return sum((-x if k % 2 else x for k, (x, _) in trigonometric.terms.items()), Fraction(0))
