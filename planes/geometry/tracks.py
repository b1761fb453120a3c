"""A link held by three ties: where it can lie. Each tie holds a point of it on an arc or a line, or keeps its own guide
at a distance from a place; the wrench of a tie is a force along its line, and a moment about the link's origin.

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
    """``local`` is the point of the link (of "guide": a place of its guide), ``place`` what it is held from.

    "arc": it stays ``reach`` from the place. "line": ``reach`` to the left of the line through the place along
    ``turn``. "guide": the place stays ``reach`` to the left of the link's line along ``turn`` in its own axes.
    Of links hinged to each other ``link`` says which it holds: 0 and 1 are hinged at their origins, each further one at
    its own to the place that a "hinge" tells, one after another.
    """

    kind: TieKind
    local: Point
    place: Point
    reach: Real
    turn: Point = 1 + 0j
    link: int = 0

    @property
    def size(self) -> Real:
        """How far its points are and reach, together: what errors are weighed against."""
        return abs(self.place) + abs(self.local) + abs(self.reach)

    def wrench(self, origin: Point, axis: Point) -> tuple[Real, Point, Real]:
        """By how much the tie is missed, the direction it pulls in, and the moment of that about the origin."""
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

    def held(self, origin: Point, axis: Point) -> Point:
        """Where the link is held."""
        return self.place if self.kind == "guide" else origin + self.local * axis


Pose = tuple[Point, ...]  # where the origin is, and the direction of the link's x axis, or of both links'


def advanced(ties: Sequence[Tie], pose: Pose) -> tuple[Pose, Real, Real]:
    """One step of Newton's from a pose, how far it went, and the determinant with its sign.

    Links beyond the first are held by two ties and hang on a hinge: one combination of both has no moment about
    that, and holds the link it hangs on. So the first one has three, and from it on every hinge is known.
    """
    axes, places = pose[1:], origins(ties, pose)
    held = [[t.wrench(places[k], axes[k]) for t in ties if t.link == k and t.kind != "hinge"] for k in range(len(axes))]
    before = hung_on(ties)
    for k in reversed(range(1, len(axes))):
        (f, n, m), (g, q, r) = held[k]
        arms = abs(m + 1j * r)
        arms = arms + (arms == 0)
        pull = (n * r - q * m) / arms
        held[before[k]].append(((f * r - g * m) / arms, pull, plane.cross(places[k] - places[before[k]], pull)))
    shift, turn, det = _solved(*held[0])
    moved, shifts, turns = abs(shift) + abs(turn), [shift], [turn]
    for k in range(1, len(axes)):
        (f, n, m), (g, q, r) = held[k]
        last = before[k]
        shift = shifts[last] + 1j * turns[last] * (places[k] - places[last])
        arms = m * m + r * r
        turn = -(m * (f + plane.dot(n, shift)) + r * (g + plane.dot(q, shift))) / (arms + (arms == 0))
        moved = moved + abs(turn)
        shifts.append(shift)
        turns.append(turn)
    turned = (axis * _turned(turn) for axis, turn in zip(axes, turns, strict=True))
    return (pose[0] + shifts[0], *turned), moved, det


def hung_on(ties: Sequence[Tie]) -> list[int]:
    """Which link every one hangs on: the first on none, the second on that, at both origins, the others as ties say."""
    return [0, 0, *(t.link for t in ties if t.kind == "hinge")]


def origins(ties: Sequence[Tie], pose: Pose) -> list[Point]:
    """Where the origins of the links are."""
    origin, *axes = pose
    places = [origin, origin][: len(axes)]
    for t in ties:
        if t.kind == "hinge":
            places.append(places[t.link] + axes[t.link] * t.local)
    return places


Wrench = tuple[Real, Point, Real]


def _solved(one: Wrench, two: Wrench, three: Wrench) -> tuple[Point, Real, Real]:
    """By how much a link on three ties is to be moved and turned, and their determinant."""
    (f, n, m), (g, k, p), (h, w, q) = one, two, three
    kw, wn, nk = plane.cross(k, w), plane.cross(w, n), plane.cross(n, k)
    det = m * kw + p * wn + q * nk
    safe = det + (det == 0)
    turn = -(f * kw + g * wn + h * nk) / safe
    return 1j * (f * (k * q - w * p) + g * (w * m - n * q) + h * (n * p - k * m)) / safe, turn, det


def _turned(angle: Real) -> Point:
    """About the direction at a small angle, radians; of length 1."""
    half = 0.5 * angle
    return (1 + 1j * half) * (1 + 1j * half) / (1 + half * half)


def closure(ties: Sequence[Tie], axis: Point) -> Real:
    """What is left of three ties when the link lies along ``axis``, its place eliminated: nothing where it can lie so.

    It is a trigonometric polynomial of the link's angle, of a degree below ``DEGREE``; not scaled.
    """
    base = next((t for t in ties if t.kind == "arc"), ties[0])
    (a, p), (b, q) = (_row(t, base, axis) for t in ties if t is not base)
    place, divisor = 1j * (p * b - q * a), plane.cross(a, b)
    if base.kind == "arc":
        return place.real * place.real + place.imag * place.imag - (base.reach * divisor) ** 2
    c, r = _row(base, base, axis)
    return plane.dot(c, place) - r * divisor


DEGREE = 5


def _row(tie: Tie, base: Tie, axis: Point) -> tuple[Point, Real]:
    """A tie as dot(a, Y) = p, where Y is how the base's point lies to the base's place."""
    off = (tie.local - base.local) * axis - (tie.place - base.place)
    if tie.kind == "guide":
        way = tie.turn * axis
        return 1j * way, -plane.cross(way, off) - tie.reach
    if tie.kind == "line":
        return 1j * tie.turn, tie.reach - plane.cross(tie.turn, off)
    return off, (tie.reach * tie.reach - base.reach * base.reach - plane.dot(off, off)) / 2
