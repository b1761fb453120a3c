"""Arrowheads along lines of ink: told by how the ink grows wide and narrow again, and fitted to it as triangles."""

from __future__ import annotations

import math
import statistics
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy

from planes.check.vision.strokes.head_ink import hides
from planes.check.vision.strokes.heads import SeenHead, heads_of, one_ink
from planes.check.vision.strokes.ink import LIGHT, Ink
from planes.check.vision.strokes.line_fitting import Fitted, Tip
from planes.check.vision.strokes.meeting import BESIDE_MM, crossing, on
from planes.check.vision.strokes.tip_edges import sharpened
from planes.geometry.arrays import Array, Complexes

USUAL_MM = 3.0  # about how long a head is
STEP_MM, CELL_MM = 0.2, 0.1  # along a line and across
SOFT_MM, OUTSIDE_MM = 0.18, 0.08  # half of how far an edge is blurred; how far outside of a line's ink its edges are
LENGTH_MM, HALF_MM = (1.5, 6.0), (0.2, 1.6)  # of a head, and half of its width
ASKEW, TIE_MM = 0.25, 0.3  # of a head to its line, and beside it
NEEDED, CLEAR = 0.35, 0.75  # of the ink that no line explains, the share a head must, and one that is seen well
END_MM, AT_END_MM = 0.08, 1.5  # σ of where a line is seen to end; how far its head's tip may seem to be from there
ENOUGH, EVEN, UNEVEN = 3, 0.02, 0.08  # heads that tell how alike all are, and how alike they may be; fewer do not
SHAPE_MM = (0.2, 0.03)  # σ of a fitted head's length and half of its width
ERROR = 20.0  # the error of a fit by how much ink it leaves: places of a picture err together
HAND = 0.08  # by how much a hand's heads differ in length, whatever those few that are seen well say
HALF, UNLIKE = 0.2, 0.15  # of a head's length, half of its width; how much one may differ from the others
ABOUT_MM, BACK_MM = 2.0, 1.5  # how far a tip may be from where it should be; how far apart bases back to back may be
SHORT_MM, BROAD_MM, MORE = 6.0, (1.2, 3.6), 0.12  # of a barb; where a head is broad, and how much ink must be there
NUDGES = (0.05, 0.03, 0.02, 0.1, 0.04)
LEAST_MM, SEEMS_MM = 0.1, 0.2  # no tip is surer; a head seems to reach too far: strokes upon each other look broader

Likeness = tuple[Array, Array]  # what heads are like, and how much they differ: length, half of the width


def find_heads(ink: Ink, lines: Sequence[Fitted]) -> None:
    """Put to every line the arrowheads along it: all are of one hand, so those less well seen are taken to be alike."""
    filled = [sight for line in lines for sight in _sights(ink, line, lines)]
    barbed = [replace(sight, barbs=True) for sight in filled]
    for sight in (*filled, *barbed):
        sight.fit(None)
    sights = max(filled, barbed, key=lambda some: sum(x.gain for x in some if x.good))  # one hand's are of one kind
    clear, like = [x.p for x in sights if x.clear], None
    if clear:
        shapes = numpy.array(clear)[:, 3:]
        usual = numpy.median(shapes, axis=0)
        spread = 1.5 * numpy.median(numpy.abs(shapes - usual), axis=0)
        least = (EVEN if len(clear) >= ENOUGH else UNEVEN) * usual
        like = (usual, numpy.sqrt(numpy.maximum(spread**2 - numpy.square(SHAPE_MM), least**2)))
        for sight in sights:
            sight.fit(like)
    heads = [(x.line, (x.tip, x.sign * x.line.direction(x.tip.s))) for x in sights if x.good]
    for sight in sights:
        end = sight.line.ends[(sight.sign + 1) // 2]
        if sight.end is not None and any(line is not sight.line and hides(head, end) for line, head in heads):
            sight.line.clear[(sight.sign + 1) // 2], sight.end = False, None
            sight.fit(like)
    for line in lines:
        line.heads = []
    for sight in sorted((x for x in sights if x.good), key=lambda x: -x.gain):
        line, head = sight.line, sight.tip if sight.end is not None else sharpened(ink, sight.line, sight.tip)
        if line.low - 1.5 < head.s < line.high + 1.5 and not any(one_ink(head, k) for k in line.heads):
            line.heads.append(head)


def _sights(ink: Ink, line: Fitted, lines: Sequence[Fitted]) -> Iterator[Sight]:
    """Where heads may be along a line."""
    s = numpy.arange(line.low - 8, line.high + 8, STEP_MM)
    t = numpy.arange(-1.5, 1.51, CELL_MM)
    z = line.at(s)[:, None] + 1j * line.along * t[None, :]
    dark = ink.at(z)
    seen = heads_of(ink, line)
    single = statistics.median(one.width for one in lines)  # of two vectors side by side, one has the head
    for found in (*seen, *_supposed(line, lines, seen)):
        tip, sign, thin = found.tip, found.sign, replace(line, width=min(line.width, found.width, single))
        base, others = tip - sign * USUAL_MM, _beside(line, line.at(tip), lines)
        near = (sign * (s - base) > -3.0) & (sign * (s - tip) < 2.5)
        x, y = sign * s[near, None], t[None, :]
        end = sign * (line.high if sign > 0 else line.low)
        free = line.clear[(sign + 1) // 2] and abs(sign * tip - end) < AT_END_MM
        start = numpy.array([end if free else sign * tip, 0.0, 0.0, abs(tip - base), 0.7])
        known = _known(z[near], [thin, *others])
        for back in (k for k in seen if k.sign != sign and abs(k.base - found.base) < BACK_MM):
            shape = numpy.array([-sign * back.tip, 0.0, 0.0, abs(back.tip - back.base), back.jump / 2])
            known = numpy.maximum(known, _head(-x, y, shape, thin.width, False))
        more = (dark[near] - known)[(x < sign * tip - BROAD_MM[0]) & (x > sign * tip - BROAD_MM[1]) & (abs(y) < 1)]
        if found in seen or more.clip(0).mean() > MORE:
            yield Sight(line, thin.width, sign, x, y, dark[near], known, start, end if free else None)


def _supposed(line: Fitted, lines: Sequence[Fitted], seen: Sequence[SeenHead]) -> Iterator[SeenHead]:
    """Heads that may be where a line ends or meets others, though others' ink hides their sides; where both run on, if
    there is room for a head beyond."""
    met = [(s, sign) for s, sign in ((line.low, -1), (line.high, 1))]
    for other in (x for x in lines if x is not line and x.length > SHORT_MM):
        near = [s for s, off in map(line.local, other.ends) if abs(off) < BESIDE_MM]
        crossed = crossing(line, other)
        if crossed is not None and on(other, crossed) and min(abs(z - crossed) for z in line.ends) > USUAL_MM:
            near.append(line.local(crossed)[0])
        met += [(s, sign) for s in near if line.low < s < line.high for sign in (1, -1)]
    kept = [(one.tip, one.sign) for one in seen]
    for s, sign in met if line.length > SHORT_MM else ():
        if all(abs(s - k) > 1 or sign != way for k, way in kept):
            kept.append((s, sign))
            yield SeenHead(s - sign * USUAL_MM, s, sign, 0.0, 0.0, line.width)


def _beside(line: Fitted, tip: complex, lines: Sequence[Fitted]) -> list[Fitted]:
    """The other lines, but those that may be the barbs of a head with its tip at a place of the line."""
    others = (x for x in lines if x is not line)
    return [x for x in others if x.length > SHORT_MM or min(abs(z - tip) for z in x.ends) > ABOUT_MM]


def head_about(ink: Ink, lines: Sequence[Fitted], line: Fitted, goal: float, sign: int, length: float) -> Tip | None:
    """The tip of the head that a vector has about a place of a line that goes on there: told by how much of the ink no
    line explains such a head does, where heads are about so long."""
    usual = numpy.array([length, HALF * length])
    x, y = numpy.arange(goal - length - 3, goal + 2.5, STEP_MM)[:, None], numpy.arange(-1.5, 1.51, CELL_MM)[None, :]
    z = line.at(sign * x) + 1j * line.along * y
    thin = replace(line, width=min(line.width, statistics.median(one.width for one in lines)))
    known = _known(z, [thin, *(one for one in lines if one is not line)])
    sight = Sight(line, thin.width, sign, x, y, ink.at(z), known, numpy.array([goal, 0.0, 0.0, *usual]))
    sight.fit(None)
    sight.fit((usual, UNLIKE * usual))
    return sight.tip if sight.good else None


def _known(z: Complexes, lines: Sequence[Fitted]) -> Array:
    """How dark the lines alone make places."""
    dark = numpy.zeros(z.shape)
    for line in lines:
        p = (z - line.origin) * line.along.conjugate()
        s = numpy.clip(p.real, line.low, line.high)
        far = numpy.hypot(p.real - s, p.imag - line.bow(s))
        dark = numpy.maximum(dark, _shade(far - line.width / 2 - OUTSIDE_MM))
    return dark


def _shade(far: Array) -> Array:
    """Darkness at a distance outside of an edge."""
    return numpy.clip(0.5 - far / (2 * SOFT_MM), 0, 1)


def _head(x: Array, y: Array, p: Array, width: float, barbs: bool) -> Array:
    """Darkness of a head and of the line it ends: tip at p[0], p[1], turned by p[2], p[3] long, p[4] half as wide; of
    two barbs, or filled: by strokes as wide as the line. Of several heads (a column of p each) a picture each."""
    tip, aside, turn, length, half = (numpy.asarray(part)[..., None, None] for part in p)
    dx, dy, cos, sin = x - tip, y - aside, numpy.cos(turn), numpy.sin(turn)
    u, v = dx * cos + dy * sin, numpy.abs(dy * cos - dx * sin)
    shaft = numpy.hypot(numpy.maximum(u, 0), v)
    if barbs:
        along = ((half * v - length * u) / (length**2 + half**2)).clip(0, 1)
        head = numpy.hypot(u + along * length, v - along * half)
    else:
        side = (v + half / length * u) / numpy.hypot(1, half / length)
        head = numpy.where(u > 0, math.inf, numpy.maximum(side, -length - u))
    return _shade(numpy.minimum(head, shaft) - width / 2 - OUTSIDE_MM)


@dataclass
class Sight:
    """A piece of ink along a line that may be an arrowhead, x towards its tip; what the lines alone make of it."""

    line: Fitted
    width: float  # of the line behind the head
    sign: int
    x: Array
    y: Array
    dark: Array
    known: Array
    p: Array  # of the head: where its tip is along and aside, its turn, its length, half of its width
    end: float | None = None  # where the line ends, if nothing else does there
    barbs: bool = False
    sigma: float = 1.0
    gain: float = 0.0  # how much of the ink that no line explains it does
    error: float = 2.0  # of its ink, in which places err together

    def off(self, p: Array, like: Likeness | None) -> Array:
        """What such a head is off the ink, and off what heads are like; of several (a column of p each) a row each."""
        model = numpy.maximum(_head(self.x, self.y, p, self.width, self.barbs), self.known)
        ties = [p[1] / TIE_MM, 2 * p[2] / ASKEW]
        ties += [(p[0] - self.end) / END_MM] if self.end is not None else []
        if like is not None:
            ties += [(p[3 + k] - usual) / sigma for k, (usual, sigma) in enumerate(zip(*like, strict=True))]
        left = (_seen(model) - self.dark).reshape(*p.shape[1:], -1)
        return numpy.concatenate([left, self.error * numpy.stack(ties, axis=-1)], axis=-1)

    def fit(self, like: Likeness | None) -> None:
        """The head that fits best (Levenberg and Marquardt's way)."""
        p, damp, better, left = self.p.copy(), 0.1, True, self.off(self.p, like)
        for _ in range(12):
            if better:
                slope = (self.off(p[:, None] + numpy.diag(NUDGES), like) - left) / numpy.reshape(NUDGES, (5, 1))
                normal = slope @ slope.T + 1e-3 * numpy.eye(5)
            move = numpy.linalg.solve(normal + damp * numpy.diag(numpy.diag(normal)), -slope @ left)
            trial = p + numpy.clip(move, -0.5, 0.5)
            trial[3:] = numpy.clip(trial[3:], (LENGTH_MM[0], HALF_MM[0]), (LENGTH_MM[1], HALF_MM[1]))
            new, step = self.off(trial, like), float(numpy.abs(trial - p).max())
            better = bool(new @ new < left @ left)
            p, left, damp = (trial, new, damp / 3) if better else (p, left, damp * 5)
            if better and step < 0.005:
                break
        self.p = p
        self._weigh(settled=like is not None)
        self.sigma = self.error * math.sqrt(float(numpy.linalg.inv(normal)[0, 0]))

    def _weigh(self, settled: bool) -> None:
        """How much of the ink the head explains, and (but once) how far ink can be believed."""
        p = self.p
        about = (abs(self.x - p[0] + p[3] / 2) < p[3] / 2 + 0.5) & (abs(self.y - p[1]) < p[4] + 0.4)
        if not about.any():  # it has slid off what is looked at
            self.gain = 0.0
            return
        model = numpy.maximum(_head(self.x, self.y, p, self.width, self.barbs), self.known)
        left_over, without = (((_seen(m) - self.dark)[about] ** 2).mean() for m in (model, self.known))
        self.gain = 1 - float(left_over) / max(float(without), 1e-9)
        if not settled:
            self.error = min(max(ERROR * math.sqrt(float(left_over)), 1.0), 6.0)

    @property
    def good(self) -> bool:
        """Whether it is an arrowhead at all."""
        _, aside, turn, length, half = self.p.tolist()
        return self.gain > NEEDED and abs(turn) < ASKEW and abs(aside) < 0.8 and half < 0.6 * length

    @property
    def clear(self) -> bool:
        """Whether it tells what heads are like."""
        inside = LENGTH_MM[0] < self.p[3] < LENGTH_MM[1] and HALF_MM[0] < self.p[4] < HALF_MM[1]
        return self.good and inside and self.gain > CLEAR and self.end is not None

    @property
    def tip(self) -> Tip:
        """Its tip."""
        s = self.sign * (float(self.p[0]) - (SEEMS_MM if self.end is None else 0.0))
        z = complex(self.line.at(s)) + 1j * self.line.along * float(self.p[1])
        length = float(self.p[3])
        alike = 0.0 if self.end is not None else HAND * length  # where a line goes on the length tells the tip
        return Tip(s, self.sign, z, max(math.hypot(self.sigma, alike), LEAST_MM), length, self.gain)


def _seen(dark: Array) -> Array:
    """Darkness as :meth:`Ink.at` tells it, of which the lightest part is taken for paper."""
    return (dark - LIGHT).clip(0) / (1 - LIGHT)
