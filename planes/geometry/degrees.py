"""Sines and their kin of angles in degrees, exact where the answer is a round number."""

import math


def sin_deg(angle: float) -> float:
    """Sine of an angle in degrees, exact at multiples of 30 where it is rational."""
    r = math.remainder(angle, 360.0)
    r = math.copysign(180.0, r) - r if abs(r) > 90.0 else r
    if abs(r) == 30.0:
        return math.copysign(0.5, r)
    return math.sin(math.radians(r)) if abs(r) <= 45.0 else math.copysign(math.cos(math.radians(90.0 - abs(r))), r)


def cos_deg(angle: float) -> float:
    """Cosine of an angle in degrees, exact at multiples of 30 where it is rational."""
    r = abs(math.remainder(angle, 360.0))
    return sin_deg(90.0 - r) if 45.0 < r < 135.0 else math.cos(math.radians(r))


def tan_deg(angle: float) -> float:
    """Tangent of an angle in degrees, exact at multiples of 45; a ValueError at 90."""
    r = math.remainder(angle, 180.0)
    if abs(r) == 90.0:
        raise ValueError(f"tan({angle:g}) has no value")
    if abs(r) == 45.0:
        return math.copysign(1.0, r)
    return math.tan(math.radians(r)) if abs(r) < 45.0 else math.copysign(1.0, r) / math.tan(math.radians(90.0 - abs(r)))


def asin_deg(value: float) -> float:
    """Angle in degrees of a sine; a ValueError outside -1..1."""
    return math.copysign(30.0, value) if abs(value) == 0.5 else math.degrees(math.asin(value))


def acos_deg(value: float) -> float:
    """Angle in degrees of a cosine; a ValueError outside -1..1."""
    return {0.5: 60.0, -0.5: 120.0}.get(value) or math.degrees(math.acos(value))


def atan_deg(value: float) -> float:
    """Angle in degrees of a tangent."""
    return math.degrees(math.atan(value))


def atan2_deg(y: float, x: float) -> float:
    """Direction in degrees of the vector (x, y)."""
    return math.degrees(math.atan2(y, x))
