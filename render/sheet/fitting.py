"""How the views of a sheet fill a format: the letters, the blocks, the size of the plans, the order."""

from collections.abc import Callable, Iterator, Sequence
from functools import cache
from itertools import accumulate, product, starmap
from typing import NamedTuple

from planes.words.frozen import field, frozen, replace
from render.labels import rough, roughly
from render.paper.style import LARGER, lettered_for
from render.sheet.columns import OVER
from render.sheet.composer import Key, Together
from render.sheet.frame import Paper
from render.sheet.module import GAP_MM
from render.sheet.packing import blocks, columns_of, packed, stacking_of
from render.sheet.sizes import LARGEST, Extents, Sizes, grown
from render.views import View

SMALLER = (0.8, 0.63, 0.5, 0.4)
"""The smallest reduction of plans with an open μ, relative to the scene's choice, where no paper holds them; it is
reported."""


class Letters(NamedTuple):
    """Letter heights of tables, in mm, and whether those of figures are a step larger than usual."""

    tables: float
    large: bool = False


LARGE = (Letters(5.0, True), Letters(3.5, True), Letters(3.5))
LETTERS = {"A4": (Letters(2.5),), "A3": (Letters(3.5), Letters(2.5)), "A1": LARGE, "A0": LARGE}
LETTERS["A2"] = LETTERS["A3"]
"""Letters to try on a format, or on several of it side by side; equations are a step larger than tables."""
NOTE = "note"
PlacedView = tuple[View, float, float]
"""A view, and the left and upper edges of its place."""
Held = tuple[list[View], list[View]]
"""The views that a sheet must hold, and the optional ones."""
Upright = tuple[str, ...]
UPRIGHT: tuple[Upright, ...] = (("motion", "rates"), ("motion",), ("rates",), ())
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
    def factors(self) -> tuple[float, ...]:
        """Factors for the size of plans, relative to the scene's choice."""
        return (1.0, *SMALLER) if self.free else (1.0,)

    def lettered(self, sizes: Sizes, letters: Letters, together: Together, upright: Upright) -> Held:
        """The views with titles as high as their equations, in blocks if those are ``upright``."""
        key = self.extras, sizes, letters, together, upright
        return self.once(key, lambda: self._lettered(sizes, letters, together, upright))

    def once(self, key: Key, made: Callable[[], Held]) -> Held:
        """Views made before for this key; rough versions are dropped once final ones are made."""
        key = (rough(), *key)
        if key not in self.known:
            if not rough():
                for other in [k for k in self.known if k[0]]:
                    del self.known[other]
            self.known[key] = made()
        return self.known[key]

    def _lettered(self, sizes: Sizes, letters: Letters, together: Together, upright: Upright) -> Held:
        wanted, spare = self.every(sizes, letters, together)
        wanted = [v for v in wanted if v.key in self.extras or not v.extra]

        def shown(v: View) -> View:
            return replace(v, heading=LARGER[letters.tables], block=v.block if v.block in upright else "")

        return list(map(shown, wanted)), list(map(shown, spare))

    def extra(self, sizes: Sizes, letters: Letters, together: Together, upright: Upright) -> list[View]:
        """The views waiting for room, in all their shapes."""
        held = {shaped(key) for key in self.extras}
        return [v for v in self.every(sizes, letters, together)[0] if v.extra and shaped(v.key) not in held]

    def every(self, sizes: Sizes, letters: Letters, together: Together) -> Held:
        """All views, ignoring the room."""
        with lettered_for(letters.large):
            return self.once((sizes, letters, together), lambda: self.views(sizes, letters.tables, together))


def shaped(key: str) -> str:
    """The contents of a view, whatever its shape: "note" of "note 2"."""
    return key.partition(" ")[0]


Way = tuple[Sizes, Letters, Together, Upright]
"""Sizes of plans, letters, combined views, and the blocks that are upright."""


def ways(
    contents: Contents, sizes: Sizes, name: str, everything: bool, best: Way | None = None, upright: bool = False
) -> Way | None:
    """The best looking way to fill a format, but not better than ``best``, and with no fewer blocks ``upright``; large
    letters only where small ones fit."""

    @cache
    def fit(how: Way) -> bool:
        return bool(everything or contents.lettered(*how)[1]) and packed(shown(contents, how, everything), Paper(name))

    least = len(contents.together)
    levels = [[(sizes, *h, u) for h in product(LETTERS[name[:2]], contents.together)] for u in UPRIGHT]
    if best:
        k = UPRIGHT.index(best[-1])
        levels = [levels[k][levels[k].index(best) :], *([] if upright else levels[k + 1 :])]
    if not any(map(fit, levels[-1][-least:])):
        return None
    return next(filter(fit, next(level for level in levels if any(map(fit, level[-least:])))))


def attempts(
    contents: Contents, name: str, factor: float, everything: bool
) -> Iterator[tuple[Contents, Way, tuple[int, ...]]]:
    """The attempts on a format, with the order of its views and plans as large as there seems to be room for. Sizes are
    known for views already tried; labels of the others are only placed roughly."""
    tried = set[tuple[tuple[str, ...], Way]]()
    while True:
        with roughly():
            how = fitted(contents, name, factor, everything)
            if not how:
                return
            more, how = with_extras(contents, how, name, everything)
            how, order = enlarged(more, how, everything, Paper(name))
        if (more.extras, how) in tried:
            return
        tried.add((more.extras, how))
        yield more, how, order


def fitted(contents: Contents, name: str, factor: float, everything: bool) -> Way | None:
    """The best looking way in which all views fit on a format; without the optional ones, unless ``everything`` is
    required."""
    return ways(contents, Sizes(factor), name, everything)


def with_extras(contents: Contents, how: Way, name: str, everything: bool) -> tuple[Contents, Way]:
    """The same with as many of the waiting views as there is room for, with plans no smaller; for a note blocks are
    broken only if there is no other place."""
    waiting = contents.extra(*how)
    notes = [v for v in waiting if shaped(v.key) == NOTE]
    tried = [
        *((v, False) for v in waiting if v not in notes),
        *((v, upright) for upright in (True, False) for v in notes),
    ]
    for one, upright in tried:
        if shaped(one.key) not in map(shaped, contents.extras):  # not yet in another shape
            more = replace(contents, extras=(*contents.extras, one.key))
            other = ways(more, how[0], name, everything, how, upright)
            contents, how = (more, other) if other else (contents, how)
    return contents, how


def shown(contents: Contents, how: Way, everything: bool) -> list[View]:
    """The views of a sheet: all of them, or only the required ones."""
    wanted, spare = contents.lettered(*how)
    return [*wanted, *spare] if everything else wanted


def enlarged(contents: Contents, how: Way, everything: bool, paper: Paper) -> tuple[Way, tuple[int, ...]]:
    """The same with plans as large as the paper allows, and the order of the views."""
    x0, y0, x1, y1 = paper.field
    views = shown(contents, how, everything)
    stacking = stacking_of(views, paper)
    order = columns_of(views, stacking).arranged(enough=OVER)[0]

    def fits(sizes: Sizes) -> bool:
        nonlocal order
        columns = columns_of(shown(contents, (sizes, *how[1:]), everything), stacking)
        if columns.ordered(order).cost < OVER:
            return True
        other, arrangement = columns.arranged(order, OVER)
        order = other if arrangement.cost < OVER else order
        return arrangement.cost < OVER

    sizes = grown(how[0], contents.extents, LARGEST * min(x1 - x0, y1 - y0), fits)
    return (sizes, *how[1:]), tuple(order)


def laid(contents: Contents, how: Way, order: Sequence[int], everything: bool, paper: Paper) -> list[PlacedView]:
    """Places of the views on the paper; empty if there is no room, or if leaving out optional views is better than
    drawing all too small for its letters."""
    views = shown(contents, how, everything)
    stacking = stacking_of(views, paper)
    begun = (order, ()) if order else ((),)  # the order found roughly may fail
    tried = map(columns_of(views, stacking).arranged, begun)
    order, best = next((one for one in tried if one[1].cost < OVER), ((), columns_of(views, stacking)))
    knotted = everything and how[0].factor < 1 and contents.lettered(*how)[1] and any(v.crowded for v in views)
    placed, every = list[PlacedView](), blocks(views)
    for k, spot in zip(order, best.spots, strict=True) if best.cost < OVER and not knotted else ():
        tops = accumulate((-v.height - GAP_MM for v in every[k]), initial=spot.top)
        placed += [(v, spot.x, top) for v, top in zip(every[k], tops, strict=False)]
    return placed
