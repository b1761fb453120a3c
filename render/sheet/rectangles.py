"""Rectangles put into a field one after the other, each into a corner of a free rectangle; all in mm."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from render.labels.footprints import Bounds


@dataclass
class PlacedRectangle:
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
Rule = Callable[[Bounds, Size], tuple[float, ...]]
"""How much a free rectangle is liked for a size: the least is taken."""


def _by_fit(free: Bounds, size: Size) -> tuple[float, ...]:
    spare = free[2] - free[0] - size[0], free[3] - free[1] - size[1]
    return (min(spare), max(spare))


RULES: tuple[Rule, ...] = (lambda free, _: (-free[3], free[0]), _by_fit, lambda free, _: (free[0], -free[3]))
"""The topmost one, the one that fits best, the leftmost one."""


def filled(
    sizes: Sequence[Size], field: Bounds, blocked: Sequence[Bounds], gap: float, rule: Rule
) -> list[PlacedRectangle] | None:
    """Each rectangle into the upper left corner of a free one; free ones may overlap (maximal rectangles)."""
    least = min(w for w, _ in sizes) + gap - 1e-9, min(h for _, h in sizes) + gap - 1e-9
    free: list[Bounds] = [(field[0] + gap, field[1], field[2], field[3] - gap)]
    for b in blocked:
        free = _without(free, (b[0] - gap, b[1] - gap, b[2] + gap, b[3] + gap), least)
    spots = []
    for width, height in sizes:
        need = (width + gap, height + gap)
        fits = [f for f in free if f[2] - f[0] >= need[0] - 1e-9 and f[3] - f[1] >= need[1] - 1e-9]
        if not fits:
            return None
        best = min(fits, key=lambda f: rule(f, need))
        taken = (best[0], best[3] - need[1], best[0] + need[0], best[3])
        spots.append(PlacedRectangle(taken[0], taken[1] + gap, width, height))
        free = _without(free, taken, least)
    return spots


def _without(free: list[Bounds], taken: Bounds, least: Size) -> list[Bounds]:
    """Maximal free rectangles left when one is taken, but those in which nothing has room."""
    x0, y0, x1, y1 = taken
    kept: list[Bounds] = []
    pieces: list[Bounds] = []
    for f in free:
        a, b, c, d = f
        if x0 >= c or x1 <= a or y0 >= d or y1 <= b:
            kept.append(f)
            continue
        if d - b >= least[1]:
            pieces += [(a, b, x0, d)] * (x0 - a >= least[0]) + [(x1, b, c, d)] * (c - x1 >= least[0])
        if c - a >= least[0]:
            pieces += [(a, b, c, y0)] * (y0 - b >= least[1]) + [(a, y1, c, d)] * (d - y1 >= least[1])
    for a, b, c, d in sorted(pieces, key=lambda f: (f[0] - f[2]) * (f[3] - f[1])):  # the largest first
        for g in kept:
            if g[0] <= a and g[1] <= b and g[2] >= c and g[3] >= d:
                break
        else:
            kept.append((a, b, c, d))
    return kept
