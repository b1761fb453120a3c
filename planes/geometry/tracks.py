"""The poses of a link held by three ties. A tie holds a point of the link on an arc or a line, or keeps a guide of the
link at a distance from a place; its wrench is a force along its line, with a moment about the link's origin.

Newton's steps on the three closures are written for any arithmetic; ``sextic`` finds all assemblies of one position.
"""

from collections.abc import Sequence
from typing import Literal

from planes.geometry import plane
from planes.geometry.arithmetic import Point, Real
from planes.words.frozen import frozen

TieKind = Literal["arc", "line", "guide", "hinge"]


@frozen
class Tie:
    """``local`` is the point of the link (for "guide": a place of its guide), ``place`` the fixed reference.

    "arc": the point stays at ``reach`` from the place. "line": it stays ``reach`` to the left of the line through the
    place along ``turn``. "guide": the place stays ``reach`` to the left of the link's line along ``turn``, in the
    link's axes. With several links ``link`` is the index of the one held: 0 and 1 have a hinge at their origins; each
    further one has its origin in a hinge at the place given by a "hinge" tie, one after another.
    """

    kind: TieKind
    local: Point
    place: Point
    reach: Real
    turn: Point = 1 + 0j
    link: int = 0

    @property
    def coordinate_sum(self) -> Real:
        """The sum of the coordinates and the reach: the scale for errors."""
        return abs(self.place) + abs(self.local) + abs(self.reach)

    def error_and_wrench(self, origin: Point, axis: Point) -> tuple[Real, Point, Real]:
        """The error of the tie, the direction of its force, and the moment of that force about the origin."""
        if self.kind == "guide":
            way = self.turn * axis
            off = self.place - origin
            miss = plane.cross(way, off - self.local * axis) - self.reach
            return miss, -1j * way, -plane.dot(way, off)
        arm = self.local * axis
        gap = origin + arm - self.place
        if self.kind == "line":
            pull = 1j * self.turn
            return plane.cross(self.turn, gap) - self.reach, pull, plane.cross(arm, pull)
        length = self.reach + (self.reach == 0)
        miss = (gap.real * gap.real + gap.imag * gap.imag - self.reach * self.reach) / (2 * length)
        return miss, gap / length, plane.cross(arm, gap) / length

    def held_place(self, origin: Point, axis: Point) -> Point:
        """The place at which the link is held."""
        if self.kind == "guide":
            return self.place
        return origin + self.local * axis


Pose = tuple[Point, ...]  # the place of the origin, and the direction of the link's x axis, or of both links'
Ties = Sequence[Tie]


def newton_step(ties: Ties, pose: Pose) -> tuple[Pose, Real, Real]:
    """One step of Newton's method from a pose, the length of the step, and the determinant with its sign.

    A link after the first has two ties and a hinge. One combination of both ties has no moment about the hinge, so it
    holds the link that carries the hinge. Thus the first link has three ties, and all hinges follow from it.
    """
    axes = pose[1:]
    places = link_origins(ties, pose)
    held = [
        [t.error_and_wrench(places[k], axes[k]) for t in ties if t.link == k and t.kind != "hinge"]
        for k in range(len(axes))
    ]
    before = carrier_links(ties)
    for k in reversed(range(1, len(axes))):
        (f, n, m), (g, q, r) = held[k]
        arms = abs(m + 1j * r)
        arms = arms + (arms == 0)
        pull = (n * r - q * m) / arms
        held[before[k]].append(((f * r - g * m) / arms, pull, plane.cross(places[k] - places[before[k]], pull)))
    shift, turn, det = _solve_three_ties(*held[0])
    moved = abs(shift) + abs(turn)
    shifts = [shift]
    turns = [turn]
    for k in range(1, len(axes)):
        (f, n, m), (g, q, r) = held[k]
        last = before[k]
        shift = shifts[last] + 1j * turns[last] * (places[k] - places[last])
        arms = m * m + r * r
        turn = -(m * (f + plane.dot(n, shift)) + r * (g + plane.dot(q, shift))) / (arms + (arms == 0))
        moved = moved + abs(turn)
        shifts.append(shift)
        turns.append(turn)
    turned = (axis * _small_rotation(turn) for axis, turn in zip(axes, turns, strict=True))
    return (pose[0] + shifts[0], *turned), moved, det


def carrier_links(ties: Ties) -> list[int]:
    """The link that carries each one: none for the first, the first for the second, at both origins; ties give the
    others."""
    return [0, 0, *(t.link for t in ties if t.kind == "hinge")]


def link_origins(ties: Ties, pose: Pose) -> list[Point]:
    """The places of the links' origins."""
    origin, *axes = pose
    places = [origin, origin][: len(axes)]
    for t in ties:
        if t.kind == "hinge":
            places.append(places[t.link] + axes[t.link] * t.local)
    return places


Wrench = tuple[Real, Point, Real]


def _solve_three_ties(one: Wrench, two: Wrench, three: Wrench) -> tuple[Point, Real, Real]:
    """The displacement and rotation of a link on three ties, and their determinant."""
    f, n, m = one
    g, k, p = two
    h, w, q = three
    kw = plane.cross(k, w)
    wn = plane.cross(w, n)
    nk = plane.cross(n, k)
    det = m * kw + p * wn + q * nk
    safe = det + (det == 0)
    turn = -(f * kw + g * wn + h * nk) / safe
    return 1j * (f * (k * q - w * p) + g * (w * m - n * q) + h * (n * p - k * m)) / safe, turn, det


def _small_rotation(angle: Real) -> Point:
    """A direction turned by a small angle, radians; of length 1."""
    half = 0.5 * angle
    return (1 + 1j * half) * (1 + 1j * half) / (1 + half * half)


def closure_residual(ties: Ties, axis: Point) -> Real:
    """The residual of three ties for a link along ``axis``, its place eliminated: zero at an assembly.

    It is a trigonometric polynomial of the link's angle, of a degree below ``DEGREE``; not scaled.
    """
    base = next((t for t in ties if t.kind == "arc"), ties[0])
    (a, p), (b, q) = (_tie_coefficients(t, base, axis) for t in ties if t is not base)
    place = 1j * (p * b - q * a)
    divisor = plane.cross(a, b)
    if base.kind == "arc":
        return place.real * place.real + place.imag * place.imag - (base.reach * divisor) ** 2
    c, r = _tie_coefficients(base, base, axis)
    return plane.dot(c, place) - r * divisor


CLOSURE_DEGREE_BOUND = 5


def _tie_coefficients(tie: Tie, base: Tie, axis: Point) -> tuple[Point, Real]:
    """A tie as dot(a, Y) = p, where Y is the base's point relative to the base's place."""
    off = (tie.local - base.local) * axis - (tie.place - base.place)
    if tie.kind == "guide":
        way = tie.turn * axis
        return 1j * way, -plane.cross(way, off) - tie.reach
    if tie.kind == "line":
        return 1j * tie.turn, tie.reach - plane.cross(tie.turn, off)
    return off, (tie.reach * tie.reach - base.reach * base.reach - plane.dot(off, off)) / 2
