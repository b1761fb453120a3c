"""A pencil's line fitted to the grey of a picture: the middle of its ink, slightly bent, and where it ends.

Across the line the middle of the ink is found every fifth of a millimetre, wherever nothing else is near, and a
straight (if long: slightly bent) line is laid through these robustly. The ends are where the ink ends.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

from planes.check.ink import DARK, Ink

STEP_MM = 0.2
BEYOND_MM = 25.0  # how far past its ends a line is looked for
GAP_MM = 1.2  # of a line's ink that is nothing but a poor stroke
BEND_MM = 0.3  # σ of how far a long line's middle is off its chord
MOST_BENT_MM = 0.7  # a line that is bent more is two that lie side by side
UNSTEADY_MM = 0.05  # σ of what a hand does beside bending


@dataclass
class Fitted:
    """A line's middle as ``origin + along·s + i·along·(c0 + c1·s + c2·s²)``, s in mm from ``low`` to ``high``."""

    origin: complex
    along: complex
    shape: tuple[float, float, float]
    low: float
    high: float
    sigma: float  # lateral, mm
    width: float
    clear: list[bool] = field(default_factory=lambda: [True, True])  # whether nothing else is where it ends
    tips: list[tuple[float, int]] = field(default_factory=list)  # arrowheads: s, and +1 if it points to high

    @property
    def length(self) -> float:
        return self.high - self.low

    def at(self, s: float) -> complex:
        """The place at s."""
        c0, c1, c2 = self.shape
        return self.origin + self.along * complex(s, c0 + c1 * s + c2 * s * s)

    def direction(self, s: float) -> complex:
        """The unit direction at s."""
        u = complex(1, self.shape[1] + 2 * self.shape[2] * s)
        return self.along * u / abs(u)

    def local(self, z: complex) -> tuple[float, float]:
        """How far along the line a place is, and how far to the left of it."""
        p = (z - self.origin) * self.along.conjugate()
        s = min(max(p.real, self.low - 3), self.high + 3)
        c0, c1, c2 = self.shape
        return p.real, p.imag - (c0 + c1 * s + c2 * s * s) - (c1 + 2 * c2 * s) * (p.real - s)

    @property
    def ends(self) -> tuple[complex, complex]:
        return self.at(self.low), self.at(self.high)


def fitted(ink: Ink, a: complex, b: complex) -> Fitted | None:
    """The line of ink from about ``a`` to about ``b``; None where there is none."""
    import numpy

    length = abs(b - a)
    along = (b - a) / length
    s = numpy.arange(-BEYOND_MM, length + BEYOND_MM, STEP_MM)
    t = numpy.arange(-1.5, 1.51, 0.1)
    dark = ink.at((a + along * s)[:, None] + (1j * along * t)[None, :])
    inside = (s >= 0) & (s <= length)
    shape, sigma, width = numpy.zeros(3), 0.2, 0.5
    for reach in (0.8, 0.55, 0.55):
        middle = shape[0] + shape[1] * s + shape[2] * s * s
        off = t[None, :] - middle[:, None]
        near = dark * (numpy.abs(off) < reach)
        mass = near.sum(axis=1) * 0.1
        rim = (dark * ((numpy.abs(off) >= reach) & (numpy.abs(off) < reach + 0.3))).sum(axis=1) * 0.1
        if (inside & (mass > 0.08)).sum() < 4:
            return None
        width = float(numpy.median(mass[inside & (mass > 0.08)]))
        good = inside & (mass > 0.4 * width) & (mass < 1.45 * width) & (rim < 0.04)
        if good.sum() < 5:
            good = inside & (mass > 0.4 * width)
        found = middle + (near * off).sum(axis=1) * 0.1 / numpy.maximum(mass, 1e-6)
        shape, sigma = _laid(s[good], found[good], length)
    line = Fitted(a, along, (float(shape[0]), float(shape[1]), float(shape[2])), 0.0, length, sigma, width)
    _extend(line, s, t, dark)
    sagitta = abs(line.shape[2]) * line.length**2 / 4
    return line if line.length > 1.0 and sagitta < MOST_BENT_MM else None


def _laid(s: Any, found: Any, length: float) -> tuple[Any, float]:
    """Coefficients of the line laid robustly through places across it, and its lateral error."""
    import numpy

    middle, half = length / 2, max(length / 2, 1.0)
    x = (s - middle) / half
    rows = numpy.stack([numpy.ones_like(x), x, x * x - 1], axis=1)
    bend = 0.08 / (BEND_MM if length > 12 else 0.003)  # how much a bend has to be believed in
    ridge = numpy.diag([1e-9, 1e-6, bend**2])
    weight, c = numpy.ones_like(x), numpy.zeros(3)
    for _ in range(6):
        c = numpy.linalg.solve((rows * weight[:, None]).T @ rows + ridge, (rows * weight[:, None]).T @ found)
        left = found - rows @ c
        scale = max(1.5 * float(numpy.median(numpy.abs(left))), 0.02)
        weight = numpy.where(numpy.abs(left) < 4 * scale, (1 - (left / (4 * scale)) ** 2) ** 2, 0.0)
    count = max(len(x) * STEP_MM / 1.0, 1.0)  # places nearer than a millimetre err together
    sigma = math.hypot(2 * scale / math.sqrt(count), UNSTEADY_MM)
    k = float(c[2]) / half**2
    first = c[0] - c[1] * middle / half + k * (middle**2 - half**2)
    return numpy.array([first, c[1] / half - 2 * k * middle, k]), sigma


def _extend(line: Fitted, s: Any, t: Any, dark: Any) -> None:
    """Move the ends to where the ink ends."""
    import numpy

    c0, c1, c2 = line.shape
    off = t[None, :] - (c0 + c1 * s + c2 * s * s)[:, None]
    core = (dark * (numpy.abs(off) < 0.21)).max(axis=1)
    flank = numpy.maximum(*((dark * (k * off > 0.55) * (k * off < 1.1)).max(axis=1) for k in (1, -1)))
    ends = []
    for sign in (-1, 1):
        inner = line.low + (0.5 + 0.2 * sign) * line.length
        i = int(numpy.argmin(numpy.abs(s - inner)))
        last, white = i, 0.0
        while 0 <= i < len(s) and white < GAP_MM:
            if core[i] > 0.5:
                last, white = i, 0.0
            else:
                white += STEP_MM
            i += sign
        end = float(s[last])
        if 0 < last + sign < len(s) and core[last] > core[last + sign]:  # where the ink is half as dark
            end += sign * STEP_MM * float((core[last] - 0.5) / (core[last] - core[last + sign]))
        beyond = slice(last + 2, last + 8) if sign > 0 else slice(max(last - 7, 0), max(last - 1, 0))
        line.clear[(sign + 1) // 2] = bool((flank[beyond] < DARK).all())
        ends.append(end - sign * min(line.width / 2, 0.4))
    line.low, line.high = ends
    line.tips = tips_of(line, s, dark, off)


def tips_of(line: Fitted, s: Any, dark: Any, off: Any) -> list[tuple[float, int]]:
    """Arrowheads along the line: ink that widens to both sides for some millimetres, then is a line again or ends.

    The tip is where the head's narrowing sides would meet.
    """
    import numpy

    found: list[tuple[float, float, int]] = []
    for aside in numpy.arange(-0.45, 0.46, 0.15):  # the head may be of a line drawn a little beside
        half = [(dark * (k * (off - aside) > 0) * (k * (off - aside) < 1.2)).sum(axis=1) * 0.1 for k in (1, -1)]
        outer = numpy.maximum(*((dark * (k * off > 1.2)).max(axis=1) for k in (1, -1)))
        wide = 2 * numpy.minimum(*half) * (outer < DARK)  # another line's ink is wide on one side, or does not end
        high = numpy.flatnonzero((wide > line.width + 0.3) & (s > line.low - 6) & (s < line.high + 6))
        for i in high[(high > 6) & (high < len(s) - 7)]:
            if wide[i] == wide[i - 4 : i + 5].max():
                tips = ((_narrowing(s, wide, int(i), sign, line.width), sign) for sign in (1, -1))
                found += [(-float(wide[i]), tip, sign) for tip, sign in tips if tip is not None]
    kept: list[tuple[float, int]] = []
    for _, tip, sign in sorted(found):
        if line.low - 1.5 < tip < line.high + 1.5 and all(abs(tip - t) > 1 for t, _ in kept):
            kept.append((tip, sign))
    return kept


def _narrowing(s: Any, wide: Any, base: int, sign: int, width: float) -> float | None:
    """Where the sides of a head with its base at a row meet; None where they do not narrow as an arrowhead's do."""
    import numpy

    behind = wide[base - 6 : base] if sign > 0 else wide[base + 1 : base + 7]
    if behind[0 if sign > 0 else -1] > width + 0.5 * (wide[base] - width):
        return None
    rows = [base]
    while 0 < rows[-1] + sign < len(s) and width + 0.08 < wide[rows[-1] + sign] < wide[rows[-1]] + 0.05:
        rows.append(rows[-1] + sign)
    rows = [i for i in rows if wide[i] > 0.5 * wide[base]]  # nearer the tip the line itself is as wide
    if len(rows) < 5:
        return None
    slope, height = numpy.polyfit(s[rows], wide[rows], 1)
    if not 0.12 < -sign * slope < 1.5:
        return None
    tip = -float(height) / float(slope)
    return tip if 2.0 < sign * (tip - float(s[base])) < 7.0 else None
