"""What is reckoned of a scene's numbers before anything is drawn, each with how far off it may be: a decimal is off by
half of the last place of the double that stands for it, and so is every operation.
"""

import math

from planes.geometry.arithmetic import Arithmetic

ARITHMETIC = Arithmetic()
HALF = 2.0**-53  # of a last place, at most, relative to the number
Off = tuple[float, float]  # a number, and how far off it may be


def difference(a: Off | None, b: Off | None) -> Off | None:
    """a - b, where None is a nothing that stays nothing."""
    if a is None and b is None:
        return None
    (one, off), (other, more) = a or (0.0, 0.0), b or (0.0, 0.0)
    return one - other, off + more + (HALF * (abs(one) + 2 * abs(other)) if one and other else 0.0)


def distance(p: complex, q: complex) -> Off:
    """The distance of two points."""
    way = q - p
    return abs(way), _apart(p, q) + (2 * HALF * abs(way) if way.real and way.imag else 0.0)


def angle_deg(p: complex, q: complex) -> Off:
    """The direction from one point to another, degrees."""
    way = q - p
    if not way:
        return 0.0, 0.0
    if not (p.imag or q.imag):  # along the link's own axis
        return (0.0, 0.0) if way.real > 0 else (180.0, 0.0)
    angle = ARITHMETIC.angle_deg(way)
    return angle, math.degrees(_apart(p, q) / abs(way)) + 4 * HALF * abs(angle)


def along(way: complex, degrees: float) -> float:
    """How far a way goes in a direction."""
    return float((way * ARITHMETIC.cis_deg(-degrees)).real)


def ratio(p: complex, q: complex, r: complex) -> tuple[complex, float]:
    """(p - q) / (r - q): how a point stands to two others."""
    found, base = (p - q) / (r - q), abs(r - q)
    rounded = 6 if p.imag or q.imag or r.imag else 1
    return found, (_apart(p, q) + abs(found) * _apart(r, q)) / base + rounded * HALF * abs(found)


def height(p: complex, q: complex, degrees: float) -> Off:
    """How far ``p`` lies to the left of the line through ``q`` at an angle."""
    way = p - q
    off = _apart(p, q) + HALF * abs(way) * ((abs(math.radians(degrees)) + 6) if degrees % 90 else 0.0)
    return (way * ARITHMETIC.cis_deg(-degrees)).imag, off


def _apart(p: complex, q: complex) -> float:
    """How far off a difference of two places is, the decimals of both and its own rounding together."""
    return HALF * (abs(p) + abs(q) + (abs(p - q) if p and q else 0.0))
