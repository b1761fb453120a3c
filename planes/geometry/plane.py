"""Geometry of the drawing plane: intersections of lines and arcs, computed without loss of digits near failure.

Places, vectors and directions are complex numbers, single or arrays. Each function returns the intersection and its
*sharpness*: the sine of the angle at which the two lines meet (for arcs, of the angle between tangents). No error is
raised here: a sharpness of zero or less means that there is no valid answer.
"""

import math
from collections.abc import Collection, Iterable

from planes.geometry.arithmetic import Arithmetic, Point, Real

Met = tuple[Point, Real, Real]  # a place or direction, how sharply it is determined, and by how much it is missed


def cross(a: Point, b: Point) -> Real:
    """Signed area of the parallelogram on ``a`` and ``b``; positive when ``b`` is to the left of ``a``."""
    return a.real * b.imag - a.imag * b.real


def dot(a: Point, b: Point) -> Real:
    """Scalar product of two vectors."""
    return a.real * b.real + a.imag * b.imag


def squared_length(v: Point) -> Real:
    """The square of a vector's length, or of a number."""
    return dot(v, v)


def sine_between(u: complex, v: complex) -> float:
    """The sine of the angle between two lines, 0 where a direction is zero."""
    size = abs(u) * abs(v)
    return abs((u * v.conjugate()).imag) / size if size else 0.0


def unit_direction(v: Point, ar: Arithmetic) -> Point:
    """The direction of ``v``; of a zero vector, the x axis (any direction will do for a vector of zero length)."""
    length = abs(v)
    nothing = length == 0  # an earlier failure (NaN) must remain one
    return ar.where(nothing, 1 + 0j, v / ar.where(nothing, 1.0, length))


def direction_between(start: complex, end: complex) -> complex:
    """The direction from one place to another."""
    return (end - start) / abs(end - start)


def bounding_corners(places: Iterable[complex]) -> tuple[complex, complex]:
    """The lower left and the upper right corner of the bounding box of some places."""
    xs, ys = zip(*((z.real, z.imag) for z in places), strict=True)
    return complex(min(xs), min(ys)), complex(max(xs), max(ys))


def perpendicular_foot(place: complex, through: complex, along: complex) -> complex:
    """The foot of the perpendicular from a place to the line through another along a direction."""
    return through + ((place - through) * along.conjugate()).real * along


def off_segment(z: complex, a: complex, b: complex) -> float:
    """The distance of a place from the segment between two others."""
    t = 0.0 if a == b else min(max(((z - a) / (b - a)).real, 0.0), 1.0)
    return abs(a + t * (b - a) - z)


def distance_to_nearest(z: complex, places: Iterable[complex]) -> float:
    """The distance of a place from the nearest of others; infinite if there are none."""
    return min((abs(z - w) for w in places), default=math.inf)


def greatest_distance(places: Collection[complex]) -> float:
    """The distance between the two places farthest apart."""
    return max(abs(a - b) for a in places for b in places)


def intersect_lines(p: Point, u: Point, q: Point, w: Point) -> Met:
    """Where the line through ``p`` along ``u`` meets the one through ``q`` along ``w`` (unit directions).

    Returns the place, the signed sharpness, and the distance between the lines if they were parallel. The place is
    meaningless where the sharpness is 0; callers check before they use it.
    """
    sharpness = cross(u, w)
    gap = cross(u, q - p)
    safe = sharpness + (sharpness == 0)
    return p + u * (cross(q - p, w) / safe), sharpness, gap


Arm = tuple[Point, Point, Real]  # a place, a direction, a length: how another place was found


def intersect_line_circle(
    p: Point, u: Point, centre: Point, radius: Real, side: Real, ar: Arithmetic, arm: Arm | None = None
) -> Met:
    """Where a line meets a circle, ahead (``side`` +1) or behind (-1) of the foot of the perpendicular from its centre.

    Returns the place, the sharpness and by how much the line misses the circle (negative: it does not). The half chord
    is √((r-h)(r+h)): h is never squared. Where the ``arm`` leads to the centre, r-h is formed from known lengths: a
    crank as long as its rod folds without loss of digits.
    """
    height = cross(u, centre - p)
    miss = abs(height) - radius
    half = ar.sqrt((radius - height) * (radius + height))
    if arm:
        reach, chord = _folded_arm_chord(p, u, radius, arm, ar)
        half = ar.where(abs(reach - centre) <= 4 * ar.eps * (abs(centre) + abs(arm[2])), chord, half)
    return centre + u * (side * half) - 1j * u * height, half / (radius + (radius == 0)), miss


def _folded_arm_chord(p: Point, u: Point, radius: Real, arm: Arm, ar: Arithmetic) -> tuple[Point, Real]:
    """The end of the arm, and the half chord by h = h₀ + l sin ψ, 1 - |sin ψ| = cos²ψ / (1 + |sin ψ|)."""
    hub, ray, length = arm
    rise = cross(u, hub - p)
    sine = cross(u, ray)
    cosine = dot(u, ray)
    above = ar.where(sine < 0, -1.0, 1.0)
    short = (radius - length - above * rise) + length * cosine * (cosine / (1 + abs(sine)))
    return hub + ray * length, ar.sqrt(short * (radius + above * (rise + length * sine)))


def intersect_circles(
    c: Point, r: Real, d: Point, s: Real, side: Real, ar: Arithmetic
) -> tuple[Point, Real, Real, Real]:
    """Where two circles meet, left (``side`` +1) or right (-1) of the way from ``c`` to ``d``.

    Returns the place, the sharpness, the gap between the circles and the depth of one inside the other (negative where
    there is none). The triangle's area is 4K = √(((r + s)² - q²)(q² - (r - s)²)), each difference formed from the
    places without loss. The rounded distance q would spoil a needle-like triangle even with Kahan's formula
    (Miscalculating Area and Angles of a Needle-like Triangle, 1986).
    """
    apart = abs(d - c)
    far = apart - (r + s)
    near = abs(r - s) - apart
    quad = ar.sqrt(ar.gap(c, d, r, s) * -ar.gap(c, d, r, -s))
    square = dot(d - c, d - c)
    part = 0.5 / (square + (square == 0))
    place = c + (d - c) * (0.5 + (r - s) * (r + s) * part) + 1j * (d - c) * (side * quad * part)
    return place, quad / (2 * r * s + (r * s == 0)), far, near


def tangent_direction(c: Point, a: Point, offset: Real, side: Real, ar: Arithmetic) -> Met:
    """Direction u of the line through ``c`` that has ``a`` at ``offset`` to its left, ahead (+1) or behind.

    It is the tangent from ``a`` to the circle of radius ``offset`` about ``c``, √(|a - c|² - offset²) long. Returns u,
    the sharpness and by how much the circle is too large (negative: it is not).
    """
    apart = abs(a - c)
    safe = apart + (apart == 0)
    through = isinstance(offset, float) and offset == 0  # the line through both places
    ahead = side * (apart if through else ar.sqrt(-ar.gap(c, a, offset, 0.0)))
    u = (a - c) * (ahead - 1j * offset) / (safe * safe)
    size = abs(u)
    return u / (size + (size == 0)), abs(ahead) / safe, abs(offset) - apart
