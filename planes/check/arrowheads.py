"""Arrowheads of a drawing of lines, however a program wrote them: filled or hollow, open, or a marker of the line.

A head is a tip and the way it points. It tells which end of a stroke is the vector's, keeps a vector too short to be
told from a tick, and is itself no part of the plan.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise

from planes.check.strokes import Head, Sketch, Stroke

LARGEST_MM = 8.0  # a closed figure no larger may be a head
NEAR_MM = 0.7  # a tip is at the end of its stroke
MOST_PAIRS = 1_000_000  # of more strokes and heads none is told whose it is
BOTH = 2
STRAIGHT = 0.94  # the cosine of the angle between a head and its stroke, at the least


def head_of(points: Sequence[complex]) -> Head | None:
    """The head a small closed figure is: its tip is the corner farthest from the middle."""
    corners = [a for a, b in pairwise([*points, points[0]]) if abs(b - a) > 0.02]
    if not 3 <= len(corners) <= 12:
        return None
    middle = sum(corners) / len(corners)
    tip = max(corners, key=lambda z: abs(z - middle))
    size = max(abs(a - b) for a in corners for b in corners)
    others = [z for z in corners if abs(z - tip) > 0.05 * size]
    if not 0.3 < size <= LARGEST_MM or len(others) < 2:
        return None
    way = tip - sum(others) / len(others)
    u = way / abs(way)
    across = [((z - tip) * u.conjugate()).imag for z in others]
    return (tip, u) if 0.02 * size < max(across) - min(across) < 1.3 * size else None


def settle(sketch: Sketch) -> None:
    """Open heads become heads; each goes to its stroke; short strokes that have none, and dimension lines, go."""
    for tip, u, wings in _open(sketch.strokes):
        sketch.strokes = [s for s in sketch.strokes if s not in wings]
        sketch.heads.append((tip, u))
    strokes = sketch.strokes + sketch.short
    owned = given(strokes, sketch.heads)
    kept = [k for k in range(len(strokes)) if owned[k] != BOTH and (k < len(sketch.strokes) or owned[k])]
    sketch.strokes, sketch.ways, sketch.short = [strokes[k] for k in kept], [owned[k] for k in kept], []


def given(strokes: Sequence[Stroke], heads: Sequence[Head]) -> list[int]:
    """Which end of each stroke has a head: +1 the second, -1 the first, 0 neither, 2 both. A head has one stroke."""
    found = [0] * len(strokes)
    if len(strokes) * len(heads) > MOST_PAIRS:
        return found
    wanted = sorted((_candidates(strokes, head) for head in heads), key=len)
    for candidates in wanted:
        free = [(far + 5 * (found[k] != 0), k, way) for far, k, way in candidates if found[k] in (0, -way)]
        if free:
            _, k, way = min(free)
            found[k] = BOTH if found[k] else way
    return found


def _candidates(strokes: Sequence[Stroke], head: Head) -> list[tuple[float, int, int]]:
    """Ends of strokes a head may belong to: how far it is, which stroke, which end."""
    tip, way = head
    found = []
    for k, (a, b) in enumerate(strokes):
        near = min(NEAR_MM, 0.4 * abs(b - a))
        for end, sign in ((b, 1), (a, -1)):
            if abs(tip - end) < near:
                along = sign * (way * (b - a).conjugate()).real / abs(b - a)
                if along > STRAIGHT:
                    found.append((abs(tip - end) + 10 * (1 - along), k, sign))
    return found


def _open(strokes: Sequence[Stroke]) -> list[tuple[complex, complex, tuple[Stroke, Stroke]]]:
    """Pairs of short strokes that spread alike from the end of a longer one."""
    short = [s for s in strokes if abs(s[1] - s[0]) <= LARGEST_MM]
    found = []
    if len(short) > 400:
        return []
    spread = [(head, wings, far) for i, one in enumerate(short) for wings in ((one, two) for two in short[:i])
              for head, far in _spread(*wings)]  # fmt: skip
    if len(strokes) * len(spread) > MOST_PAIRS:
        return []
    for (tip, u), wings, far in spread:
        longer = [s for s in strokes if s not in wings and abs(s[1] - s[0]) > 1.3 * far]
        if _candidates(longer, (tip, u)):
            found.append((tip, u, wings))
    return found


def _spread(one: Stroke, two: Stroke) -> Iterator[tuple[Head, float]]:
    """The open head two strokes make, and how long it is, if they spread alike from where they meet."""
    tip, ends = _corner(one, two)
    if tip is None or abs(abs(ends[0] - tip) - abs(ends[1] - tip)) > 0.15 * abs(ends[0] - tip):
        return
    middle = tip - (ends[0] + ends[1]) / 2
    if 0.12 < abs(ends[0] - ends[1]) / max(abs(ends[0] - tip), 1e-9) < 1.3:
        yield (tip, middle / abs(middle)), abs(ends[0] - tip)


def _corner(one: Stroke, two: Stroke) -> tuple[complex | None, tuple[complex, complex]]:
    """Where two strokes begin together, and their other ends."""
    for a, b in (one, one[::-1]):
        for c, d in (two, two[::-1]):
            if abs(a - c) < 0.15 and abs(b - d) > 0.15:
                return a, (b, d)
    return None, (0j, 0j)


def tapered(points: Sequence[complex], widths: Sequence[tuple[float, float]]) -> tuple[list[complex], list[Head]]:
    """A polyline some of whose segments narrow to nothing: those are heads, the line goes on to their tips."""
    kept, heads = [points[0]], list[Head]()
    for (a, b), (wide, narrow) in zip(pairwise(points), widths, strict=False):
        small = 0 < abs(b - a) <= LARGEST_MM
        if small and wide == 0 < narrow:
            heads.append((a, (a - b) / abs(a - b)))
            continue  # the shaft goes on from the tip
        if small and narrow == 0 < wide:
            heads.append((b, (b - a) / abs(b - a)))
            if len(kept) > 1 and _on(kept[-2], kept[-1], b):
                kept.pop()  # the shaft reaches the tip
        kept.append(b)
    return (kept if len(kept) > 1 else list(points)), heads


def _on(a: complex, b: complex, c: complex) -> bool:
    """Whether the way from a to b goes on to c."""
    return abs(math.remainder(_angle(b - a) - _angle(c - b), 2 * math.pi)) < 0.02 if a != b != c else True


def _angle(z: complex) -> float:
    return math.atan2(z.imag, z.real)
