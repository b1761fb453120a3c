"""What is reckoned of a scene's numbers before anything is drawn, each with how far off it may be.

A decimal is off by half of the last place of the double that stands for it, and so is every operation.
"""

from __future__ import annotations

import cmath
import math

from planes.arithmetic import One

HALF = 2.0**-53  # of a last place, at most, relative to the number
Off = tuple[float, float]  # a number, and how far off it may be


def distance(p: complex, q: complex) -> Off:
    """The distance of two points."""
    return abs(q - p), HALF * (abs(p) + abs(q) + 4 * abs(q - p))


def angle_deg(p: complex, q: complex) -> Off:
    """The direction from one point to another, degrees."""
    way = q - p
    if not way:
        return 0.0, 0.0
    angle = math.degrees(cmath.phase(way))
    return angle, HALF * (math.degrees((abs(p) + abs(q)) / abs(way) + 1) + 4 * abs(angle))


def ratio(p: complex, q: complex, r: complex) -> tuple[complex, float]:
    """(p - q) / (r - q): how a point stands to two others."""
    found, base = (p - q) / (r - q), abs(r - q)
    above, below = (abs(x) + abs(q) + abs(x - q) for x in (p, r))
    return found, HALF * (above / base + abs(found) * (below / base + 6))


def height(p: complex, q: complex, degrees: float) -> Off:
    """How far ``p`` lies to the left of the line through ``q`` at an angle."""
    way = p - q
    off = abs(p) + abs(q) + abs(way) * (abs(math.radians(degrees)) + 8)
    return (way * One().cis_deg(-degrees)).imag, HALF * off
