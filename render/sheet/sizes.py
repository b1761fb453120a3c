"""The size of figures on a sheet: all by one factor, then those with a separate scale are enlarged while there is
room."""

from collections.abc import Callable, Mapping

from planes.words.frozen import frozen

MU_STEP_RATIOS = (1.12, 1.25, 1.42, 1.6, 1.8, 2.0, 2.24, 2.5)  # μ of the standard series are no farther apart
MOST_PLAN_SIZE_RATIO = 0.55  # of the shorter side of the field: the largest size of an enlarged plan
SAME_MU_RATIO = 1.01  # plans whose sizes differ by less share one μ
# views: the scheme with loads; single links, which together are no figure
LOADED_VIEW_KEY = "loaded"
SINGLE_LINKS_VIEW_KEY = "apart"


@frozen
class Sizes:
    """The factors of the usual sizes: ``factor`` for every plan, and ``more`` for some of them."""

    factor: float = 1.0
    more: tuple[tuple[str, float], ...] = ()

    def factor_of_plan(self, plan: str) -> float:
        """The factor of one plan."""
        return self.factor * dict(self.more).get(plan, 1.0)

    def with_larger_plan(self, plan: str, times: float) -> "Sizes":
        """The same with one plan enlarged by a factor."""
        more = dict(self.more)
        more[plan] = more.get(plan, 1.0) * times
        return Sizes(self.factor, tuple(sorted(more.items())))


Extents = Callable[[Sizes], Mapping[str, float]]
"""The size in mm of every plan of the sheet with an open μ."""


def grow_plan_sizes(start: Sizes, extents: Extents, most: float, fits: Callable[[Sizes], bool]) -> Sizes:
    """Sizes with every plan as large as the sheet allows: the smallest first, one step of μ at a time."""
    sizes = start
    now = dict(extents(start))
    growing = set(now)
    while growing:
        plan = min(sorted(growing), key=now.__getitem__)
        larger = _next_larger_sizes(sizes, plan, extents, now[plan])
        if larger and extents(larger)[plan] <= most and fits(larger):
            sizes = larger
            now = dict(extents(larger))
        else:
            growing.discard(plan)
    return sizes


def _next_larger_sizes(sizes: Sizes, plan: str, extents: Extents, now: float) -> Sizes | None:
    """The sizes at which a plan has the next larger μ; None for an empty plan, or without a larger one nearby."""
    tried = (sizes.with_larger_plan(plan, times) for times in MU_STEP_RATIOS)
    return next((s for s in tried if now > 0 and extents(s)[plan] > SAME_MU_RATIO * now), None)
