"""How large the plans of a sheet are drawn: all by one factor, then one after another larger while there is room."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

STEPS = (1.25, 1.6, 2.0, 2.5)  # μ of the standard series are no farther apart
RANKS = {"position": 1.5}  # how much larger than the others some plans should be
LARGEST = 0.45  # of the shorter side of the field, which a plan never exceeds by growing
SAME = 1.01  # plans whose sizes differ by less have one μ


@dataclass(frozen=True)
class Sizes:
    """How many times its usual size every plan may be: ``factor``, and ``more`` for some of them."""

    factor: float = 1.0
    more: tuple[tuple[str, float], ...] = ()

    def of(self, plan: str) -> float:
        """The factor of one plan."""
        return self.factor * dict(self.more).get(plan, 1.0)

    def larger(self, plan: str, times: float) -> Sizes:
        """The same with one plan so many times larger."""
        more = dict(self.more)
        more[plan] = more.get(plan, 1.0) * times
        return Sizes(self.factor, tuple(sorted(more.items())))


Extents = Callable[[Sizes], Mapping[str, float]]
"""The size in mm of every plan of the sheet whose μ the scene leaves open."""


def grown(start: Sizes, extents: Extents, most: float, fits: Callable[[Sizes], bool]) -> Sizes:
    """Sizes with every plan as large as the sheet holds: the smallest for its rank first, by one μ at a time."""
    sizes, now = start, dict(extents(start))
    growing = set(now)
    while growing:
        plan = min(sorted(growing), key=lambda p: now[p] / RANKS.get(p, 1.0))
        larger = _next(sizes, plan, extents, now[plan])
        if larger and extents(larger)[plan] <= most and fits(larger):
            sizes, now = larger, dict(extents(larger))
        else:
            growing.discard(plan)
    return sizes


def relieved(
    start: Sizes, extents: Extents, crowded: Callable[[Sizes], set[str]], fits: Callable[[Sizes], bool]
) -> Sizes:
    """Sizes with those plans larger whose labels find no place, as far as the sheet holds them."""
    sizes, stuck = start, set[str]()
    while left := sorted((crowded(sizes) & set(extents(sizes))) - stuck):
        larger = _next(sizes, left[0], extents, extents(sizes)[left[0]])
        if larger and fits(larger):
            sizes = larger
        else:
            stuck.add(left[0])
    return sizes


def _next(sizes: Sizes, plan: str, extents: Extents, now: float) -> Sizes | None:
    """The sizes at which a plan has the next larger μ; None where it is nothing or has no larger one near."""
    tried = (sizes.larger(plan, times) for times in STEPS)
    return next((s for s in tried if now > 0 and extents(s)[plan] > SAME * now), None)
