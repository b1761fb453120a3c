"""Arrowheads along a pencil's line: where its ink widens suddenly to a side and then narrows evenly to the tip. Two
barbs with paper between them and their line are as wide as a filled head.

A head stands out to both sides of a line by itself; of a line drawn upon another one side is enough. Beyond the tip
the line may end or be another vector's.
"""

from collections.abc import Iterator, Mapping, Sequence
from itertools import product
from statistics import linear_regression
from typing import NamedTuple

import numpy

from planes.check.vision.image.picture import cv
from planes.check.vision.strokes.ink import DARK, Ink
from planes.check.vision.strokes.line_fitting import Fitted, Tip
from planes.geometry.arrays import Array, Booleans

STEP_MM, ASIDE_MM = 0.2, 0.1
BASE_MM = 0.15  # how far before the first row that shows it whole a base is
FAR_MM = 6.0  # past a line's ends a head is looked for
BROAD_MM = 2.0
SLIGHT_MM, JUMP_MM, JUMPS_MM = 0.1, 0.2, 0.35  # by how much a base is wider than its line, to a side: at the least, if
# the other side does not show it, and to both sides together
LENGTH_MM = (1.0, 6.0)  # of the narrowing that is seen
SLOPE = (0.08, 0.5)  # tangents of a head's half angle
ROUGH_MM = 0.06  # how far a head's side is from straight
PENCIL_MM = 0.45  # the width of a pencil's line
DOUBLE_MM, CROWDED_MM = 0.6, 0.36  # a line this wide is two; ink that reaches so far to a side is not one line's
WIDER_MM = 0.12  # by how much a line is wider where another is upon it
FAINT_MM = 0.08
INKED = 0.3  # of a line's darkness, of its own edge
OPEN_MM = 0.6  # of paper between a line and a barb of its head
SHAFT_MM = (9.0, 4.5)  # how far before its end a vector is looked at for where it runs
ASTRAY_MM, BESIDE_MM = 0.6, 0.8  # how far off its vector a head may be, and its vector's ink off where it should run
APART_MM = 1.4  # rows where bases are whole; farther apart they show the line between them
BOTH_MM = 0.8  # how far apart the tips found from both sides may be
SHARED = 0.5  # of a head, that two which point at each other have in common


class SeenHead(NamedTuple):
    """A head: its base and its tip along a line, its way (+1: to the line's high end), how far its tip is off the line
    (to the left), how sudden it is, and how wide the line is behind it."""

    base: float
    tip: float
    sign: int
    aside: float
    jump: float
    width: float


class _LineSide(NamedTuple):
    """A side of a line: how far its ink reaches there, where another line is beside, and the heads it shows."""

    half: Array
    taken: Booleans
    heads: list[SeenHead]
    pairs: list[SeenHead]  # back to back


def heads_of(ink: Ink, line: Fitted) -> list[SeenHead]:
    """Heads along a line, the most distinct first."""
    s = numpy.arange(line.low - FAR_MM, line.high + FAR_MM, STEP_MM)
    t = numpy.arange(ASIDE_MM / 2, BROAD_MM, ASIDE_MM)
    dark = {k: ink.at(line.at(s)[:, None] + k * 1j * line.direction(s)[:, None] * t[None, :]) for k in (1, -1)}
    found: list[SeenHead] = []
    for closed in (False, True):
        rows = {k: barbed(dark[k]) for k in (1, -1)} if closed else dark
        if closed and all(rows[k] is dark[k] for k in rows):
            break  # there are no barbs
        sides = {k: _side(s, rows[k], line.width / 2) for k in rows}
        found += _from_both_sides(sides[1].heads, sides[-1].heads) if closed else _whole(s, sides, line.width)
        found += _from_both_sides(sides[1].pairs, sides[-1].pairs)
    kept: list[SeenHead] = []
    for one in sorted(found, key=lambda o: -o.jump):
        inside = line.low - 1.5 < one.tip < line.high + 1.5
        if inside and all(abs(one.tip - k.tip) > 1 or one.sign != k.sign for k in kept):
            kept.append(one)
    return kept


def one_ink(one: Tip, other: Tip) -> bool:
    """Whether two heads along a line are seen of the same ink: their tips are at one place, or they point at each
    other's bases."""
    low, high = zip(*(sorted((k.s, k.s - k.sign * k.length)) for k in (one, other)), strict=True)
    upon = one.sign != other.sign and min(high) - max(low) > SHARED * min(one.length, other.length)
    return upon or abs(one.s - other.s) <= 1


def barbed(dark: Array) -> Array:
    """Rows from a line outwards with what paper there is between it and the barbs of its heads filled; the same, if
    there is none."""
    wide = numpy.ones((1, round(OPEN_MM / ASIDE_MM) + 1), numpy.uint8)
    inked = (dark > INKED).astype(numpy.uint8)
    row = numpy.pad(inked, ((0, 0), (wide.size, wide.size)))
    row = cv().morphologyEx(row, cv().MORPH_CLOSE, wide)[:, wide.size : -wide.size]
    paper = inked < row
    return numpy.where(paper, 1.0, dark) if paper.any() else dark


def _side(s: Array, dark: Array, own_half: float) -> _LineSide:
    """A side of a line so wide to that side, from the ink of rows outwards."""
    own = numpy.cumprod(dark > INKED, axis=1)
    half, taken = (dark * own).sum(axis=1) * ASIDE_MM, (dark * (1 - own)).max(axis=1) > DARK
    back = _sides(-s[::-1], half[::-1], taken[::-1])
    turned = (x._replace(base=-x.base, tip=-x.tip, sign=-1) for x in back)
    return _LineSide(half, taken, [*_sides(s, half, taken), *turned], [*_pairs(s, half, taken, own_half)])


def _whole(s: Array, sides: Mapping[int, _LineSide], width: float) -> Iterator[SeenHead]:
    """Heads seen from both sides, and from one side where the other is another line's."""
    both = list(_from_both_sides(sides[1].heads, sides[-1].heads))
    yield from both
    width = both[-1].width if both else width  # behind such a head the line is by itself
    for k in (1, -1):
        for one in sides[k].heads:
            about = abs(s - one.tip + 2.0 * one.sign) < 1.5
            beside = numpy.where(sides[-k].taken[about], BROAD_MM, sides[-k].half[about])
            far_side = float(numpy.median(beside)) if len(beside) else 0.0
            double = width > DOUBLE_MM or one.width / 2 + far_side > width + WIDER_MM
            if one.jump > JUMP_MM and (double or far_side > CROWDED_MM):
                yield one._replace(aside=k * max(one.aside, 0.0))


def _from_both_sides(left: Sequence[SeenHead], right: Sequence[SeenHead]) -> Iterator[SeenHead]:
    """Heads that both sides of a line show."""
    for one, other in product(left, right):
        jump = one.jump + other.jump
        if other.sign == one.sign and abs(other.tip - one.tip) < BOTH_MM and jump > JUMPS_MM:
            tip = (one.tip * one.jump + other.tip * other.jump) / jump
            base, width = (one.base + other.base) / 2, (one.width + other.width) / 2
            yield SeenHead(base, tip, one.sign, (one.aside - other.aside) / 2, jump, width)


def head_at(ink: Ink, start: complex, end: complex, reach: float, usual: float | None) -> complex | None:
    """The tip of the head a vector from start has about its end: no farther than ``reach`` from it along the vector,
    and not much beside. It is told by the head's sides, or by its base if it is known how long heads usually are."""
    length = abs(end - start)
    along = (end - start) / length
    far, near = max(length - SHAFT_MM[0], 0.3 * length), max(length - SHAFT_MM[1], 0.6 * length)
    shaft = _shaft(ink, start + along * far, start + along * near)
    if shaft is None:
        return None
    beside, width = shaft
    origin, low = start + 1j * along * beside, max(length - reach, 0.0)
    way = Fitted(origin, along, (0.0, 0.0, 0.0), low, length + reach, 0.1, width)
    found = [
        complex(way.at(head.base + usual if usual else head.tip) + 1j * along * head.aside)
        for head in heads_of(ink, way)
        if head.sign > 0 and abs(head.tip - length) < reach and abs(head.aside) < ASTRAY_MM
    ]
    return min(found, key=lambda z: abs(z - end), default=None)


def _shaft(ink: Ink, a: complex, b: complex) -> tuple[float, float] | None:
    """How far to the left of the way from a to b the ink nearest to it runs, and how wide it is."""
    t = numpy.arange(-1.2, 1.21, ASIDE_MM)
    places = numpy.linspace(a, b, 15)[:, None] + 1j * (b - a) / abs(b - a) * t[None, :]
    runs = numpy.split(numpy.arange(len(t)), numpy.flatnonzero(numpy.diff(ink.at(places).mean(axis=0) > 0.5)) + 1)
    inked = [t[run] for run in runs if ink.at(places[:, run]).mean() > 0.5]
    near = min(inked, key=lambda run: float(abs(run).min()), default=None)
    if near is None or float(abs(near).min()) > BESIDE_MM:
        return None
    return float(near.mean()), len(near) * ASIDE_MM


def _sides(s: Array, half: Array, taken: Booleans) -> list[SeenHead]:
    """Heads that point along the line, as one side of it shows them; ``half`` is how far its ink reaches there."""
    behind = numpy.convolve(half, numpy.full(4, 0.25))[: len(half)]  # of each place and the three before it
    behind = numpy.concatenate([numpy.zeros(2), behind[:-2]])
    found: list[SeenHead] = []
    wider = (numpy.flatnonzero(half[6:-6] - behind[6:-6] > SLIGHT_MM) + 6).tolist()
    places, wide, held = (row.tolist() if wider else [] for row in (s, half, taken))
    for i in wider:
        before = float(behind[i])
        top = max(range(i, i + 3), key=lambda k: wide[k])
        jump = wide[top] - max(before, wide[i - 2])
        sudden = jump >= SLIGHT_MM and wide[top] >= max(wide[top - 3 : top])
        if not sudden or before < FAINT_MM or any(held[i - 3 : top + 3]):
            continue
        tip = _tip(places, wide, top, before, jump)
        if tip is not None and all(abs(tip - f.tip) > 0.6 for f in found):
            found.append(SeenHead(places[top] - BASE_MM, tip, 1, before - PENCIL_MM / 2, jump, 2 * before))
    return found


def _pairs(s: Array, half: Array, taken: Booleans, own: float) -> Iterator[SeenHead]:
    """Heads back to back: a line so wide has no width of its own between their bases, from which both narrow to it."""
    broad = numpy.flatnonzero(half[6:-6] > own + JUMP_MM) + 6
    tops = [i for i in broad.tolist() if half[i] == half[i - 3 : i + 4].max() and not taken[i - 3 : i + 4].any()]
    if not tops:
        return
    along, against = (s.tolist(), half.tolist()), ((-s[::-1]).tolist(), half[::-1].tolist())
    for i, k in product(tops, tops):
        if not 0 <= s[k] - s[i] < APART_MM:
            continue
        jump = float(min(half[i], half[k])) - own
        back, tip = _tip(*against, len(s) - 1 - i, own, jump), _tip(*along, k, own, jump)
        if back is not None and tip is not None:
            yield SeenHead(float(s[i]) + BASE_MM, -back, -1, own - PENCIL_MM / 2, jump, 2 * own)
            yield SeenHead(float(s[k]) - BASE_MM, tip, 1, own - PENCIL_MM / 2, jump, 2 * own)


def _tip(s: Sequence[float], half: Sequence[float], top: int, before: float, jump: float) -> float | None:
    """Where the side of a head with its base at a row meets the head's own line; None where it does not narrow so."""
    low, end = before + 0.25 * jump, top
    while end + 1 < len(s) and low < half[end + 1] < half[end] + 0.02:
        end += 1
    x, y = s[top : end + 1], half[top : end + 1]
    if len(x) < 4 or half[min(end + 1, len(s) - 1)] > low:
        return None
    slope, height = linear_regression(x, y)
    rough = max(abs(b - slope * a - height) for a, b in zip(x, y, strict=True))
    if not SLOPE[0] < -slope < SLOPE[1] or rough > ROUGH_MM:
        return None
    tip = (max(before - PENCIL_MM / 2, 0.0) - height) / slope
    return tip if LENGTH_MM[0] < tip - s[top] < LENGTH_MM[1] else None
