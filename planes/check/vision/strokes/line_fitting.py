"""A pencil's line fitted to the grey of a picture: the middle of its ink, slightly bent, and where it ends.

Across the line the middle of the ink is found every fifth of a millimetre, wherever nothing else is near, and a
straight (if long: slightly bent) line is laid through these robustly. The ends are where the ink ends.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, TypeVar, overload

import numpy

from planes.check.vision.strokes.ink import DARK, Ink
from planes.geometry.arrays import Array, Booleans, Complexes
from planes.words.frozen import frozen

STEP_MM, CELL_MM = 0.2, 0.1  # along a line, and of a row across it
UPON_MM = 0.15  # lines nearer than this are in the same place
DRIFT_MM = 0.1  # how far off a line the ink of its end may be
ASKEW = 0.25  # lines that run more askew only cross
LEAST_CLEAR = 0.15  # of a line beside others, the share that must be told apart from them
BEYOND_MM = 25.0  # how far past its ends a line is looked for
GAP_MM = 1.2  # of a line's ink that is nothing but a poor stroke
TORN_MM, OWN_MM = 0.3, 0.6  # a longer gap must have so much of plainly the same line beyond it
WHITE = 0.25  # of a pencil's darkness: where nothing is
BEND_MM = 0.3  # σ of how far a long line's middle is off its chord
MOST_BENT_MM = 1.0  # a line that is bent more is two that lie side by side
UNSTEADY_MM = 0.05  # σ of what a hand does beside bending

Number = TypeVar("Number", float, Array)


@frozen
class Tip:
    """An arrowhead's tip: how far along its line, +1 if it points to its high end, the place, its σ along; how long
    the head is, and what share of the ink that no line explains it does."""

    s: float
    sign: int
    z: complex
    sigma: float
    length: float
    gain: float = 1.0


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
    heads: list[Tip] = field(default_factory=list)

    @property
    def length(self) -> float:
        return self.high - self.low

    @overload
    def at(self, s: float) -> complex: ...
    @overload
    def at(self, s: Array) -> Complexes: ...
    def at(self, s: Any) -> Any:
        """The place at s (a number or an array)."""
        return self.origin + self.along * (s + 1j * self.bow(s))

    def bow(self, s: Number) -> Number:
        """How far to the left of its chord the line is at s (a number or an array)."""
        c0, c1, c2 = self.shape
        return c0 + c1 * s + c2 * s * s

    @overload
    def direction(self, s: float) -> complex: ...
    @overload
    def direction(self, s: Array) -> Complexes: ...
    def direction(self, s: Any) -> Any:
        """The unit direction at s (a number or an array)."""
        u = 1 + 1j * (self.shape[1] + 2 * self.shape[2] * s)
        return self.along * u / abs(u)

    def local(self, z: complex) -> tuple[float, float]:
        """How far along the line a place is, and how far to the left of it."""
        p = (z - self.origin) * self.along.conjugate()
        s = min(max(p.real, self.low - 3), self.high + 3)
        _, c1, c2 = self.shape
        return p.real, p.imag - self.bow(s) - (c1 + 2 * c2 * s) * (p.real - s)

    @property
    def ends(self) -> tuple[complex, complex]:
        return self.at(self.low), self.at(self.high)


@dataclass
class Rows:
    """Ink across a line, a row every step: what is nearer to the line than to any beside it."""

    dark: Array
    t: Array
    middle: Array
    others: Array  # how far to the left of the line others are, a row each
    reach: float

    def __post_init__(self) -> None:
        self.left = numpy.where(self.others > 0, self.others, numpy.inf).min(axis=0)  # the nearest other line
        self.right = numpy.where(self.others < 0, -self.others, numpy.inf).min(axis=0)
        self.upon = (numpy.abs(self.others) < UPON_MM).any(axis=0)
        self.off = self.t[None, :] - self.middle[:, None]
        own = (self.off < self.left[:, None] / 2) & (self.off > -self.right[:, None] / 2)
        near, far = numpy.abs(self.off) < self.reach, numpy.abs(self.off) < self.reach + 0.3
        ink = self.dark * (own & near)
        self.mass = ink.sum(axis=1) * CELL_MM
        self.rim = (self.dark * (own & far & ~near)).sum(axis=1) * CELL_MM
        self.centroid = self.middle + (ink * self.off).sum(axis=1) * CELL_MM / numpy.maximum(self.mass, 1e-6)

    def middles(self, width: float) -> tuple[Booleans, Array]:
        """Which rows tell where the line's middle is, and where: by all of its ink, or by its free edge."""
        apart = width + 0.1
        lone = (self.left > apart) & (self.right > apart)
        good = lone & (self.mass > 0.4 * width) & (self.mass < 1.45 * width) & (self.rim < 0.04) & ~self.upon
        found = self.centroid
        for sign, covered, free in ((-1, self.left, self.right), (1, self.right, self.left)):
            edge, seen = self._edge(sign)
            one_sided = (covered <= apart) & (free > apart) & ~self.upon & seen
            found = numpy.where(one_sided, edge - sign * width / 2, found)
            good = good | one_sided
        return good, found

    def _edge(self, sign: int) -> tuple[Array, Booleans]:
        """Where the ink ends to the left (1) or to the right (-1) of the middle, and where that is near."""
        dark, t = self.dark[:, ::sign], self.t[::sign]
        beyond = (dark < 0.5) & (sign * self.off[:, ::sign] > 0)
        k = numpy.argmax(beyond, axis=1)
        i, rows = numpy.maximum(k, 1), numpy.arange(len(dark))
        inner, outer = dark[rows, i - 1], dark[rows, i]
        share = (inner - 0.5) / numpy.maximum(inner - outer, 1e-6)
        edge = t[i - 1] + sign * CELL_MM * share
        far = sign * (edge - self.middle)
        return edge, (k > 0) & (inner >= 0.5) & (far > 0.05) & (far < 0.7)


def fitted(ink: Ink, a: complex, b: complex, beside: Sequence[Fitted] = ()) -> Fitted | None:
    """The line of ink from about ``a`` to about ``b``, with others ``beside`` it; None where there is none."""
    length = abs(b - a)
    along = (b - a) / length
    s = numpy.arange(-BEYOND_MM, length + BEYOND_MM, STEP_MM)
    t = numpy.arange(-1.5, 1.51, CELL_MM)
    way = numpy.asarray(a + along * s, complex)
    dark = ink.at(way[:, None] + (1j * along * t)[None, :])
    inside = (s >= 0) & (s <= length)
    others = _others(way, along, beside)
    shape, sigma, width = numpy.zeros(3), 0.2, 0.5
    for reach in (0.8, 0.55, 0.55):
        middle = shape[0] + shape[1] * s + shape[2] * s * s
        rows = Rows(dark, t, middle, others - middle, reach)
        lone = inside & (rows.mass > 0.08) & (rows.left > 1.2) & (rows.right > 1.2)
        if (inside & (rows.mass > 0.08)).sum() < 4:
            return None
        if lone.sum() > 10 or not beside:
            width = float(numpy.median(rows.mass[lone]))
        good, found = rows.middles(width)
        good &= inside
        if good.sum() < (LEAST_CLEAR * inside.sum() if beside else 5):
            if beside:
                return None
            good, found = inside & (rows.mass > 0.4 * width), rows.centroid
        shape, sigma = _laid(s[good], found[good], length)
    first, slope, bend = shape.tolist()
    line = Fitted(a, along, (first, slope, bend), 0.0, length, sigma, width)
    _extend(line, s, t, dark)
    sagitta = abs(line.shape[2]) * line.length**2 / 4
    return line if line.length > 1.0 and sagitta < MOST_BENT_MM else None


def _others(z: Complexes, along: complex, beside: Sequence[Fitted]) -> Array:
    """How far to the left of places on a line the others are that run along it: a row each, nan where there is none."""
    found = numpy.full((len(beside) + 1, len(z)), numpy.nan)
    for k, line in enumerate(beside):
        turn = along * line.along.conjugate()
        if abs(turn.imag) < ASKEW:
            p = (z - line.origin) * line.along.conjugate()
            s = numpy.clip(p.real, line.low, line.high)
            off = -(p.imag - line.bow(s)) / turn.real
            found[k] = numpy.where(abs(p.real - s) < 0.5, off, numpy.nan)
    return found


def _laid(s: Array, found: Array, length: float) -> tuple[Array, float]:
    """Coefficients of the line laid robustly through places across it, and its lateral error."""
    middle, half = length / 2, max(length / 2, 1.0)
    x = (s - middle) / half
    rows = numpy.stack([numpy.ones_like(x), x, x * x - 1], axis=1)
    bend = 0.08 / (BEND_MM if length > 12 else 0.003)  # how much a bend has to be believed in
    ridge = numpy.diag([1e-9, 1e-6, bend**2])
    weight, c = numpy.ones_like(x), numpy.zeros(3)
    for _ in range(6):
        weighed = (rows * weight[:, None]).T
        c = numpy.linalg.solve(weighed @ rows + ridge, weighed @ found).astype(float)
        left = found - rows @ c
        scale = max(1.5 * float(numpy.median(numpy.abs(left))), 0.02)
        weight = numpy.where(numpy.abs(left) < 4 * scale, (1 - (left / (4 * scale)) ** 2) ** 2, 0.0)
    count = max(len(x) * STEP_MM / 1.0, 1.0)  # places nearer than a millimetre err together
    sigma = math.hypot(2 * scale / math.sqrt(count), UNSTEADY_MM)
    k = float(c[2]) / half**2
    first = c[0] - c[1] * middle / half + k * (middle**2 - half**2)
    return numpy.array([first, c[1] / half - 2 * k * middle, k]), sigma


def _extend(line: Fitted, s: Array, t: Array, dark: Array) -> None:
    """Move the ends to where the ink ends."""
    off = t[None, :] - line.bow(s)[:, None]
    core = (dark * (numpy.abs(off) < 0.21)).max(axis=1)
    flank = numpy.maximum(*((dark * (k * off > 0.55) * (k * off < 1.1)).max(axis=1) for k in (1, -1)))
    ends = []
    for sign in (-1, 1):
        inner = line.low + (0.5 + 0.2 * sign) * line.length
        last = _last(core, flank < DARK, int(numpy.argmin(numpy.abs(s - inner))), sign)
        end = float(s[last])
        if 0 < last + sign < len(s) and core[last] > core[last + sign]:  # where the ink is half as dark
            end += sign * STEP_MM * float((core[last] - 0.5) / (core[last] - core[last + sign]))
        beyond = slice(last + 2, last + 8) if sign > 0 else slice(max(last - 7, 0), max(last - 1, 0))
        white = slice(last + 2, last + 4) if sign > 0 else slice(max(last - 3, 0), max(last - 1, 0))
        within = slice(max(last - 4, 0), last + 1) if sign > 0 else slice(last, last + 5)
        ink = dark[within] * (numpy.abs(off[within]) < 0.55)
        drift = float((ink * off[within]).sum() / max(ink.sum(), 1e-9))  # off the line it is another's, met askew
        lone = (core[white] < WHITE).all() and (flank[within] < DARK).all() and abs(drift) < DRIFT_MM
        line.clear[(sign + 1) // 2] = bool(lone or (flank[beyond] < DARK).all())
        ends.append(end - sign * min(line.width / 2, 0.4))
    line.low, line.high = ends


def _last(core: Array, alone: Booleans, i: int, sign: int) -> int:
    """The last row of a line's ink; beyond a gap that is only what is plainly its own, and not another's it meets."""
    last, white, torn_mm, own, torn = i, 0.0, 0.0, 0, False
    while 0 <= i < len(core) and white < GAP_MM and abs(i - last) * STEP_MM < 2 * GAP_MM:
        if core[i] > 0.5:
            own += bool(alone[i])
            if not torn or own * STEP_MM >= OWN_MM:
                last, white, torn_mm, torn = i, 0.0, 0.0, False
        else:
            white, torn_mm = white + STEP_MM, torn_mm + STEP_MM * bool(core[i] < WHITE)
            if torn_mm > TORN_MM:
                torn, own = True, 0
        i += sign
    return last
