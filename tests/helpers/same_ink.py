"""Whether two drawings of a plan leave the same ink on paper, and so cannot be distinguished on a picture."""

from __future__ import annotations

import cmath
import math
import random
from functools import cache

from tests.confusion import Easel, alike, motion, spread
from tests.helpers import line_drawings, photographs
from tests.helpers.drawings import NONE, Hand, Mistake
from tests.helpers.line_drawings import Stroke

DRAWN_MM, STRAIGHT_DEG = 0.3, 15.0  # shorter vectors leave no ink; vectors that turn less form one line
ALIKE_MM = 1.0  # ink that differs by less looks the same


@cache
def ink(easel: Easel, mistake: Mistake | None, order: tuple[str, ...] = ()) -> list[Stroke]:
    """The ink of a perfect hand; a force polygon's vectors in an order, if they are in it."""
    found, _ = easel.draw(mistake, Hand(NONE, random.Random(0)))
    if not easel.plan.startswith("force"):
        return line_drawings.motion_strokes(motion(easel.sample), found, easel.plan == "acceleration")
    strokes, z = [], 0j
    for name in dict.fromkeys([*(n for n in order if n in found), *found]):
        if abs(found[name]) > 0.3:
            strokes.append((z, z + found[name]))
        z += found[name]
    return strokes


def same_ink(easel: Easel, one: Mistake | None, two: Mistake | None, order: tuple[str, ...] = ()) -> bool:
    """Whether two drawings differ only in their letters, which are not read on a picture."""
    try:
        pairs = [
            (ink(easel, one, way), ink(easel, two, other))
            for way in orders(easel, one, order)
            for other in orders(easel, two, order)
        ]
    except ZeroDivisionError:
        return False
    return any(_same(easel, strokes, lines) for strokes, lines in pairs)


def orders(easel: Easel, mistake: Mistake | None, order: tuple[str, ...]) -> list[tuple[str, ...]]:
    """An order of a polygon's vectors, with the missing ones anywhere, since the order of forces is free."""
    if not order:
        return [()]
    more = tuple(n for n in easel.draw(mistake, Hand(NONE, random.Random(0)))[0] if n not in order)
    return [(*order[:k], *more, *order[k:]) for k in range(len(order) + 1)] if more else [order]


def size_on_paper(easel: Easel, mistake: Mistake, order: tuple[str, ...], reading: float) -> float:
    """The visible displacement in a force polygon by a mistake, in σ of a shaky hand and of reading both ends.

    Where consecutive collinear vectors have no heads, their joint is invisible: they are seen as one.
    """
    wrong = easel.draw(mistake, Hand(NONE, random.Random(0)))[0]
    right, sigma = easel.draw(None, Hand(NONE, random.Random(0)))[0], spread(easel)
    both, sizes = ((wrong, right), (right, wrong)), []
    for way in orders(easel, None, order):
        most, run = 0.0, list[str]()
        for k, name in enumerate(way):
            run.append(name)
            pair = way[k : k + 2]
            if len(pair) < 2 or any(_joint_seen(*(d.get(n) or e.get(n, 0j) for n in pair)) for d, e in both):
                moved = abs(sum(wrong.get(n, 0j) - right.get(n, 0j) for n in run))
                most = max(most, moved / math.hypot(*(sigma.get(n, 0.1) for n in run), math.sqrt(2) * reading))
                run = []
        sizes.append(most)
    return min(sizes)


def _joint_seen(one: complex, two: complex) -> bool:
    """Whether the joint of two consecutive vectors is visible."""
    if abs(one) > photographs.HEADED_MM:
        return True
    return min(abs(one), abs(two)) > DRAWN_MM and abs(cmath.phase(two / one)) > math.radians(STRAIGHT_DEG)


def _same(easel: Easel, strokes: list[Stroke], lines: list[Stroke]) -> bool:
    if easel.plan.startswith("force") and _same_vectors(strokes, lines):
        return True
    return all(_drawn_too(a, b) for a, b in ((strokes, lines), (lines, strokes)))


def _same_vectors(strokes: list[Stroke], lines: list[Stroke]) -> bool:
    """Whether two polygons have the same vectors in some order: the order of forces is free."""
    left = [b - a for a, b in lines]
    for v in sorted((b - a for a, b in strokes), key=abs, reverse=True):
        near = min(left, key=lambda w: abs(w - v), default=0j)
        if abs(near - v) < ALIKE_MM and near in left:
            left.remove(near)
        elif abs(v) >= ALIKE_MM:
            return False
    return all(abs(w) < ALIKE_MM for w in left)


def _drawn_too(strokes: list[Stroke], lines: list[Stroke]) -> bool:
    """Whether all ink of the strokes, and every head, is ink of the lines, too."""
    for a, b in strokes:
        alike_ways = (
            abs(b - d) < ALIKE_MM and ((b - a) / (d - c)).real > 0.95 * abs((b - a) / (d - c))
            for c, d in lines
            if abs(d - c) > photographs.HEADED_MM
        )
        if abs(b - a) > photographs.HEADED_MM and not any(alike_ways):
            return False
    steps = [a + (b - a) * t / 20 for a, b in strokes for t in range(21)]
    return all(any(_beside(z, *s) for s in lines) for z in steps)


def _beside(z: complex, a: complex, b: complex) -> bool:
    local = (z - a) * (b - a).conjugate() / abs(b - a)
    return abs(local.imag) < ALIKE_MM and -ALIKE_MM < local.real < abs(b - a) + ALIKE_MM


@cache
def alike_on_paper(easel: Easel, mistake: Mistake, order: tuple[str, ...]) -> frozenset[tuple[str, str]]:
    """Other mistakes that leave the same ink."""
    _, made = easel.draw(None, Hand(NONE, random.Random(0)))
    others = (Mistake(n, where, k) for n, where in dict.fromkeys(made) for k in (0, 1))
    found = {(m.name.partition(":")[0], m.where) for m in others if same_ink(easel, mistake, m, order)}
    return alike(easel, mistake) | frozenset(found - {(mistake.name.partition(":")[0], mistake.where)})
