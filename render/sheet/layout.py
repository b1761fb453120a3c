"""Places of views on a sheet: packed into the field, then spread so that white space is shared; all in mm."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from render.labels.footprints import Bounds

GAP_MM = 7.0  # least distance of views from each other and from the frame
TRIES = 160
ENOUGH = 60  # arrangements to choose from
ROUNDS = 80


@dataclass
class Spot:
    """A rectangle being placed: lower left corner and size; ``fixed`` ones are in the way and do not move."""

    x: float
    y: float
    width: float
    height: float
    fixed: bool = False

    @property
    def right(self) -> float:
        """The right edge."""
        return self.x + self.width

    @property
    def top(self) -> float:
        """The upper edge."""
        return self.y + self.height


Size = tuple[float, float]


def pack(
    sizes: Sequence[Size], field: Bounds, blocked: Sequence[Bounds], figures: int = 0, gap: float = GAP_MM
) -> list[Spot] | None:
    """Places for rectangles of these sizes, the first ``figures`` in reading order; None if no try fits them all."""
    wide, high = field[2] - field[0], field[3] - field[1]
    area = sum((w + gap) * (h + gap) for w, h in sizes) + sum((b[2] - b[0]) * (b[3] - b[1]) for b in blocked)
    if area > wide * high or any(w + 2 * gap > wide or h + 2 * gap > high for w, h in sizes):
        return None
    best: tuple[float, list[Spot]] | None = None
    found_count = 0
    for order in _orders(sizes):
        for rule in (_by_top, _by_fit):
            found = _filled([sizes[k] for k in order], field, blocked, gap, rule)
            if found:
                spots = [found[order.index(k)] for k in range(len(sizes))]
                best = min(best or (math.inf, spots), (_cost(spots, field, figures), spots), key=lambda b: b[0])
                found_count += 1
        if found_count >= ENOUGH:
            break
    return spread(best[1], field, blocked, gap) if best else None


def _cost(spots: Sequence[Spot], field: Bounds, figures: int) -> float:
    """How far an arrangement is from one that is read easily: in order, from the upper left, in few rows.

    The first ``figures`` are read one after the other; tables may stand anywhere, best near each other.
    """
    cost = 3.0 * (spots[0].x - field[0] + field[3] - spots[0].top)
    for k, later in enumerate(spots):
        for earlier in spots[:k]:
            lower = earlier.top - later.top
            if later.x < earlier.right and (lower < -8 or (abs(lower) <= 8 and later.x < earlier.x)):
                cost += 60.0 if k < figures else 8.0
            elif lower < -8:
                cost += 12.0 if k < figures else 2.0
    cost += 15.0 * len({round(spot.top) for spot in spots}) + 5.0 * len({round(spot.x) for spot in spots})
    near = sum(0.25 * abs(complex(b.x - a.x, b.top - a.top)) for a, b in pairwise(spots))
    return cost + near


def _orders(sizes: Sequence[Size]) -> Iterator[list[int]]:
    """Orders to try: as given, the largest, tallest, widest first, then shuffled ones, always the same."""
    plain = list(range(len(sizes)))
    yield plain
    yield sorted(plain, key=lambda k: -sizes[k][1])
    yield sorted(plain, key=lambda k: -sizes[k][0] * sizes[k][1])
    yield sorted(plain, key=lambda k: -sizes[k][0])
    yield sorted(plain, key=lambda k: -max(sizes[k]))
    shuffler = random.Random(1)
    by_height = sorted(plain, key=lambda k: -sizes[k][1])
    for turn in range(TRIES):
        ranks = plain if turn % 2 else by_height
        loose = (0.2, 0.35, 0.6, 1.0)[turn % 4] * len(sizes)
        yield sorted(plain, key=lambda k: ranks.index(k) + shuffler.uniform(0, loose))


def _by_top(free: Bounds, size: Size) -> tuple[float, ...]:
    return (-free[3], free[0])


def _by_fit(free: Bounds, size: Size) -> tuple[float, ...]:
    spare = free[2] - free[0] - size[0], free[3] - free[1] - size[1]
    return (min(spare), max(spare))


def _filled(
    sizes: Sequence[Size], field: Bounds, blocked: Sequence[Bounds], gap: float, rule: object
) -> list[Spot] | None:
    """Each rectangle into the upper left corner of a free one; free ones may overlap (maximal rectangles)."""
    free: list[Bounds] = [(field[0] + gap, field[1], field[2], field[3] - gap)]
    for b in blocked:
        free = _without(free, (b[0] - gap, b[1] - gap, b[2] + gap, b[3] + gap))
    spots = []
    for width, height in sizes:
        need = (width + gap, height + gap)
        fits = [f for f in free if f[2] - f[0] >= need[0] - 1e-9 and f[3] - f[1] >= need[1] - 1e-9]
        if not fits:
            return None
        best = min(fits, key=lambda f: rule(f, need))  # type: ignore[operator]
        taken = (best[0], best[3] - need[1], best[0] + need[0], best[3])
        spots.append(Spot(taken[0], taken[1] + gap, width, height))
        free = _without(free, taken)
    return spots


def _without(free: list[Bounds], taken: Bounds) -> list[Bounds]:
    """Maximal free rectangles left when one is taken."""
    left: list[Bounds] = []
    for f in free:
        if taken[0] >= f[2] or taken[2] <= f[0] or taken[1] >= f[3] or taken[3] <= f[1]:
            left.append(f)
            continue
        pieces = (
            (f[0], f[1], taken[0], f[3]),
            (taken[2], f[1], f[2], f[3]),
            (f[0], f[1], f[2], taken[1]),
            (f[0], taken[3], f[2], f[3]),
        )
        left += [p for p in pieces if p[2] - p[0] > 1 and p[3] - p[1] > 1]
    return [f for k, f in enumerate(left) if not any(_inside(f, g, k > j) for j, g in enumerate(left) if j != k)]


def _inside(inner: Bounds, outer: Bounds, ties: bool) -> bool:
    if inner == outer:
        return ties
    return inner[0] >= outer[0] and inner[1] >= outer[1] and inner[2] <= outer[2] and inner[3] <= outer[3]


def spread(spots: list[Spot], field: Bounds, blocked: Sequence[Bounds], gap: float) -> list[Spot]:
    """The same arrangement with white space shared: every view comes to stand midway between its neighbours.

    Views that stood side by side with their tops in one line keep doing so.
    """
    fixed = [Spot(b[0], b[1], b[2] - b[0], b[3] - b[1], True) for b in blocked]
    everything = [*spots, *fixed]
    sides = [(i, j) for i in range(len(everything)) for j in range(len(everything)) if _beside(everything, i, j, gap)]
    for _ in range(ROUNDS):
        for k, spot in enumerate(spots):
            low = max([field[0] + gap, *(everything[i].right + gap for i, j in sides if j == k)])
            high = min([field[2] - gap, *(everything[j].x - gap for i, j in sides if i == k)])
            spot.x = (low + high - spot.width) / 2
    above = [(i, j) for i in range(len(everything)) for j in range(len(everything)) if _above(everything, i, j, gap)]
    rows: dict[float, list[int]] = {}
    for k, spot in enumerate(spots):
        rows.setdefault(round(spot.top, 1), []).append(k)
    for _ in range(ROUNDS):
        for row in rows.values():
            ceilings = [[field[3] - gap, *(everything[i].y - gap for i, j in above if j == k)] for k in row]
            floors = [[field[1] + gap, *(everything[j].top + gap for i, j in above if i == k)] for k in row]
            up = min(min(c) - spots[k].top for c, k in zip(ceilings, row, strict=True))
            down = min(spots[k].y - max(f) for f, k in zip(floors, row, strict=True))
            for k in row:
                spots[k].y += (up - down) / 2
    return spots


def _beside(spots: Sequence[Spot], i: int, j: int, gap: float) -> bool:
    """Whether spot i stands to the left of j, within reach of it up and down."""
    a, b = spots[i], spots[j]
    return i != j and a.right <= b.x + 1e-6 and a.y < b.top + gap - 1e-6 and b.y < a.top + gap - 1e-6


def _above(spots: Sequence[Spot], i: int, j: int, gap: float) -> bool:
    """Whether spot i stands above j, within reach of it sideways."""
    a, b = spots[i], spots[j]
    return i != j and a.y >= b.top - 1e-6 and a.x < b.right + gap - 1e-6 and b.x < a.right + gap - 1e-6
