"""How the views of a sheet fill a format: the letters, the blocks, the size of the plans, the order."""

from collections.abc import Callable, Iterator, Sequence
from functools import cache
from itertools import accumulate, product, starmap
from typing import NamedTuple

from planes.words.frozen import field, frozen, replace
from render.labels import is_rough_placement, rough_placement
from render.paper.style import NEXT_LARGER_LETTER_MM, using_large_format
from render.sheet.columns import OVERFULL_COLUMN_COST
from render.sheet.composer import Key, Together
from render.sheet.frame import Paper
from render.sheet.module import VIEW_GAP_MM
from render.sheet.packing import group_into_blocks, has_room_for_all, make_columns, stacking_for_paper
from render.sheet.sizes import MOST_PLAN_SIZE_RATIO, Extents, Sizes, grow_plan_sizes
from render.views import View

PLAN_REDUCTIONS = (0.8, 0.63, 0.5, 0.4)
"""The smallest reduction of plans with an open μ, relative to the scene's choice, where no paper holds them; it is
reported."""


class Letters(NamedTuple):
    """Letter heights of tables, in mm, and whether those of figures are a step larger than usual."""

    tables: float
    large: bool = False


LARGE_FORMAT_LETTERS = (Letters(5.0, True), Letters(3.5, True), Letters(3.5))
LETTERS_OF_FORMAT = {
    "A4": (Letters(2.5),),
    "A3": (Letters(3.5), Letters(2.5)),
    "A1": LARGE_FORMAT_LETTERS,
    "A0": LARGE_FORMAT_LETTERS,
}
LETTERS_OF_FORMAT["A2"] = LETTERS_OF_FORMAT["A3"]
"""Letters to try on a format, or on several of it side by side; equations are a step larger than tables."""
NOTE_VIEW_KEY = "note"
PlacedView = tuple[View, float, float]
"""A view, and the left and upper edges of its place."""
Held = tuple[list[View], list[View]]
"""The views that a sheet must hold, and the optional ones."""
Upright = tuple[str, ...]
UPRIGHT_BLOCKS: tuple[Upright, ...] = (("motion", "rates"), ("motion",), ("rates",), ())
"""Blocks of views to be put beneath each other: as many as a format has room for."""


@frozen
class Contents:
    """The contents of a sheet.

    ``views`` are the required and the optional ones, for given sizes of plans, a letter height of tables, and combined
    views; ``extents`` are the parts that can grow, with their size in mm; ``free``: the μ of some plans is open.
    """

    views: Callable[[Sizes, float, Together], Held]
    extents: Extents = lambda sizes: {}
    extras: tuple[str, ...] = ()  # those of the waiting views that have found room
    free: bool = False
    together: Sequence[Together] = tuple(starmap(Together, product((True, False), repeat=2)))
    known: dict[Key, Held] = field(default_factory=dict, repr=False)

    @property
    def size_factors(self) -> tuple[float, ...]:
        """Factors for the size of plans, relative to the scene's choice."""
        return (1.0, *PLAN_REDUCTIONS) if self.free else (1.0,)

    def lettered_views(self, sizes: Sizes, letters: Letters, together: Together, upright: Upright) -> Held:
        """The views with titles as high as their equations, in blocks if those are ``upright``."""
        key = self.extras, sizes, letters, together, upright
        return self.cached_views(key, lambda: self._make_lettered_views(sizes, letters, together, upright))

    def cached_views(self, key: Key, made: Callable[[], Held]) -> Held:
        """Views made before for this key; rough versions are dropped once final ones are made."""
        key = (is_rough_placement(), *key)
        if key not in self.known:
            if not is_rough_placement():
                for other in [k for k in self.known if k[0]]:
                    del self.known[other]
            self.known[key] = made()
        return self.known[key]

    def _make_lettered_views(self, sizes: Sizes, letters: Letters, together: Together, upright: Upright) -> Held:
        wanted, spare = self.all_views(sizes, letters, together)
        wanted = [v for v in wanted if v.key in self.extras or not v.extra]

        def shown(v: View) -> View:
            return replace(
                v, heading=NEXT_LARGER_LETTER_MM[letters.tables], block=v.block if v.block in upright else ""
            )

        return list(map(shown, wanted)), list(map(shown, spare))

    def waiting_views(self, sizes: Sizes, letters: Letters, together: Together, upright: Upright) -> list[View]:
        """The views waiting for room, in all their shapes."""
        held = {key_without_shape(key) for key in self.extras}
        return [
            v for v in self.all_views(sizes, letters, together)[0] if v.extra and key_without_shape(v.key) not in held
        ]

    def all_views(self, sizes: Sizes, letters: Letters, together: Together) -> Held:
        """All views, ignoring the room."""
        with using_large_format(letters.large):
            return self.cached_views((sizes, letters, together), lambda: self.views(sizes, letters.tables, together))


def key_without_shape(key: str) -> str:
    """The contents of a view, whatever its shape: "note" of "note 2"."""
    return key.partition(" ")[0]


Way = tuple[Sizes, Letters, Together, Upright]
"""Sizes of plans, letters, combined views, and the blocks that are upright."""


def best_way(
    contents: Contents, sizes: Sizes, name: str, everything: bool, best: Way | None = None, upright: bool = False
) -> Way | None:
    """The best looking way to fill a format, but not better than ``best``, and with no fewer blocks ``upright``; large
    letters only where small ones fit."""

    @cache
    def fit(how: Way) -> bool:
        return bool(everything or contents.lettered_views(*how)[1]) and has_room_for_all(
            views_to_show(contents, how, everything), Paper(name)
        )

    least = len(contents.together)
    levels = [[(sizes, *h, u) for h in product(LETTERS_OF_FORMAT[name[:2]], contents.together)] for u in UPRIGHT_BLOCKS]
    if best:
        k = UPRIGHT_BLOCKS.index(best[-1])
        levels = [levels[k][levels[k].index(best) :], *([] if upright else levels[k + 1 :])]
    if not any(map(fit, levels[-1][-least:])):
        return None
    return next(filter(fit, next(level for level in levels if any(map(fit, level[-least:])))))


def fitting_attempts(
    contents: Contents, name: str, factor: float, everything: bool
) -> Iterator[tuple[Contents, Way, tuple[int, ...]]]:
    """The attempts on a format, with the order of its views and plans as large as there seems to be room for. Sizes are
    known for views already tried; labels of the others are only placed roughly."""
    tried = set[tuple[tuple[str, ...], Way]]()
    while True:
        with rough_placement():
            how = best_fitting_way(contents, name, factor, everything)
            if not how:
                return
            more, how = with_waiting_views(contents, how, name, everything)
            how, order = enlarge_plans(more, how, everything, Paper(name))
        if (more.extras, how) in tried:
            return
        tried.add((more.extras, how))
        yield more, how, order


def best_fitting_way(contents: Contents, name: str, factor: float, everything: bool) -> Way | None:
    """The best looking way in which all views fit on a format; without the optional ones, unless ``everything`` is
    required."""
    return best_way(contents, Sizes(factor), name, everything)


def with_waiting_views(contents: Contents, how: Way, name: str, everything: bool) -> tuple[Contents, Way]:
    """The same with as many of the waiting views as there is room for, with plans no smaller; for a note blocks are
    broken only if there is no other place."""
    waiting = contents.waiting_views(*how)
    notes = [v for v in waiting if key_without_shape(v.key) == NOTE_VIEW_KEY]
    tried = [
        *((v, False) for v in waiting if v not in notes),
        *((v, upright) for upright in (True, False) for v in notes),
    ]
    for one, upright in tried:
        if key_without_shape(one.key) not in map(key_without_shape, contents.extras):  # not yet in another shape
            more = replace(contents, extras=(*contents.extras, one.key))
            other = best_way(more, how[0], name, everything, how, upright)
            contents, how = (more, other) if other else (contents, how)
    return contents, how


def views_to_show(contents: Contents, how: Way, everything: bool) -> list[View]:
    """The views of a sheet: all of them, or only the required ones."""
    wanted, spare = contents.lettered_views(*how)
    return [*wanted, *spare] if everything else wanted


def enlarge_plans(contents: Contents, how: Way, everything: bool, paper: Paper) -> tuple[Way, tuple[int, ...]]:
    """The same with plans as large as the paper allows, and the order of the views."""
    x0, y0, x1, y1 = paper.field
    views = views_to_show(contents, how, everything)
    stacking = stacking_for_paper(views, paper)
    order = make_columns(views, stacking).best_arrangement(enough=OVERFULL_COLUMN_COST)[0]

    def fits(sizes: Sizes) -> bool:
        nonlocal order
        columns = make_columns(views_to_show(contents, (sizes, *how[1:]), everything), stacking)
        if columns.reordered_columns(order).total_cost < OVERFULL_COLUMN_COST:
            return True
        other, arrangement = columns.best_arrangement(order, OVERFULL_COLUMN_COST)
        order = other if arrangement.total_cost < OVERFULL_COLUMN_COST else order
        return arrangement.total_cost < OVERFULL_COLUMN_COST

    sizes = grow_plan_sizes(how[0], contents.extents, MOST_PLAN_SIZE_RATIO * min(x1 - x0, y1 - y0), fits)
    return (sizes, *how[1:]), tuple(order)


def lay_out_views(
    contents: Contents, how: Way, order: Sequence[int], everything: bool, paper: Paper
) -> list[PlacedView]:
    """Places of the views on the paper; empty if there is no room, or if leaving out optional views is better than
    drawing all too small for its letters."""
    views = views_to_show(contents, how, everything)
    stacking = stacking_for_paper(views, paper)
    begun = (order, ()) if order else ((),)  # the order found roughly may fail
    tried = map(make_columns(views, stacking).best_arrangement, begun)
    order, best = next(
        (one for one in tried if one[1].total_cost < OVERFULL_COLUMN_COST), ((), make_columns(views, stacking))
    )
    knotted = (
        everything
        and how[0].factor < 1
        and contents.lettered_views(*how)[1]
        and any(v.unreadable_labels for v in views)
    )
    placed = list[PlacedView]()
    every = group_into_blocks(views)
    for k, spot in (
        zip(order, best.view_spots, strict=True) if best.total_cost < OVERFULL_COLUMN_COST and not knotted else ()
    ):
        tops = accumulate((-v.height - VIEW_GAP_MM for v in every[k]), initial=spot.top)
        placed += [(v, spot.x, top) for v, top in zip(every[k], tops, strict=False)]
    return placed
