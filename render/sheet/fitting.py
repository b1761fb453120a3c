"""How the views of a sheet fill a format: which letters, which blocks, how large the plans, in which order."""

from collections.abc import Callable, Iterator, Sequence
from functools import cache
from itertools import accumulate, product, starmap
from typing import NamedTuple

from planes.words.frozen import field, frozen, replace
from render.labels import rough, roughly
from render.paper.style import LARGER, lettered_for
from render.sheet.columns import OVER
from render.sheet.composer import Together
from render.sheet.frame import Paper
from render.sheet.module import GAP_MM
from render.sheet.packing import blocks, columns_of, packed, stacking_of
from render.sheet.sizes import LARGEST, Extents, Sizes, grown
from render.views import View

SMALLER = (0.8, 0.63, 0.5, 0.4)
"""How small, against the scene's choice, plans may become where μ is open and no paper holds them; it is said."""


class Letters(NamedTuple):
    """Letter heights of tables, in mm, and whether those of figures are a step larger than usual."""

    tables: float
    large: bool = False


LARGE = (Letters(5.0, True), Letters(3.5, True), Letters(3.5))
LETTERS = {"A4": (Letters(2.5),), "A3": (Letters(3.5), Letters(2.5)), "A1": LARGE, "A0": LARGE}
LETTERS["A2"] = LETTERS["A3"]
"""What to try on a format, or on several of it side by side; equations are a step larger than tables."""
NOTE = "note"
Held = tuple[list[View], list[View]]
"""The views that a sheet must hold, and those that may be left out."""
Upright = tuple[str, ...]
UPRIGHT: tuple[Upright, ...] = (("motion", "rates"), ("motion",), ("rates",), ())
"""Blocks of views that are to stand beneath each other: as many as a format has room for."""


@frozen
class Contents:
    """What a sheet shows.

    ``views`` are those it must hold, and those that may be left out, for sizes of plans, a letter height of tables,
    and what stands ``together``; ``extents`` what may grow, with its size in mm; ``free``: the μ of some plans is open.
    """

    views: Callable[[Sizes, float, Together], Held]
    extents: Extents = lambda sizes: {}
    extras: tuple[str, ...] = ()  # those of the views that wait for room that have found some
    free: bool = False
    together: Sequence[Together] = tuple(starmap(Together, product((True, False), repeat=2)))
    known: dict[tuple[object, ...], Held] = field(default_factory=dict, repr=False)

    @property
    def factors(self) -> tuple[float, ...]:
        """How large plans may be, against the scene's choice."""
        return (1.0, *SMALLER) if self.free else (1.0,)

    def lettered(self, sizes: Sizes, letters: Letters, together: Together, upright: Upright) -> Held:
        """The views with titles as high as their equations, in blocks if those stand ``upright``."""
        key = self.extras, sizes, letters, together, upright
        return self.once(key, lambda: self._lettered(sizes, letters, together, upright))

    def once(self, key: tuple[object, ...], made: Callable[[], Held]) -> Held:
        """Views as they were made for this key before; those but roughly made are forgotten once others are made
        wholly."""
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
        """The views that wait for room, in every shape they may have."""
        held = {shaped(key) for key in self.extras}
        return [v for v in self.every(sizes, letters, together)[0] if v.extra and shaped(v.key) not in held]

    def every(self, sizes: Sizes, letters: Letters, together: Together) -> Held:
        """All views, whatever room there is."""
        with lettered_for(letters.large):
            return self.once((sizes, letters, together), lambda: self.views(sizes, letters.tables, together))


def shaped(key: str) -> str:
    """What a view shows, whatever its shape: "note" of "note 2"."""
    return key.partition(" ")[0]


Way = tuple[Sizes, Letters, Together, Upright]
"""Sizes of plans, letters, what stands together, and which blocks stand upright."""


def ways(
    contents: Contents, sizes: Sizes, name: str, everything: bool, best: Way | None = None, upright: bool = False
) -> Way | None:
    """The best looking way to fill a format, but none better than ``best``, nor with fewer blocks ``upright``; large
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
    """What is to be tried on a format, with the order of its views: plans as large as there seems to be room for. How
    large a view is, is known where it was tried; labels of the others are put but roughly."""
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
    """The best looking way in which all views fit on a format; unless ``everything`` must, without those that may be
    left out."""
    return ways(contents, Sizes(factor), name, everything)


def with_extras(contents: Contents, how: Way, name: str, everything: bool) -> tuple[Contents, Way]:
    """The same with as many of the views that wait for room as there is some for, with plans no smaller; for a note
    blocks are torn only where it has no place else."""
    waiting = contents.extra(*how)
    notes = [v for v in waiting if shaped(v.key) == NOTE]
    tried = [
        *((v, False) for v in waiting if v not in notes),
        *((v, upright) for upright in (True, False) for v in notes),
    ]
    for one, upright in tried:
        if shaped(one.key) not in map(shaped, contents.extras):  # in no other shape yet
            more = replace(contents, extras=(*contents.extras, one.key))
            other = ways(more, how[0], name, everything, how, upright)
            contents, how = (more, other) if other else (contents, how)
    return contents, how


def shown(contents: Contents, how: Way, everything: bool) -> list[View]:
    """The views of a sheet: all of them, or those only that it must hold."""
    wanted, spare = contents.lettered(*how)
    return [*wanted, *spare] if everything else wanted


def enlarged(contents: Contents, how: Way, everything: bool, paper: Paper) -> tuple[Way, tuple[int, ...]]:
    """The same with plans as large as there is room for on the paper, and the order of the views."""
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


def laid(
    contents: Contents, how: Way, order: Sequence[int], everything: bool, paper: Paper
) -> list[tuple[View, float, float]]:
    """Places of the views on the paper; none, if there is no room, or where rather is left out what may be than all
    drawn too small for its letters."""
    views = shown(contents, how, everything)
    stacking = stacking_of(views, paper)
    begun = (order, ()) if order else ((),)  # the order that was found roughly may lead nowhere
    tried = map(columns_of(views, stacking).arranged, begun)
    order, best = next((one for one in tried if one[1].cost < OVER), ((), columns_of(views, stacking)))
    knotted = everything and how[0].factor < 1 and contents.lettered(*how)[1] and any(v.crowded for v in views)
    placed, every = list[tuple[View, float, float]](), blocks(views)
    for k, spot in zip(order, best.spots, strict=True) if best.cost < OVER and not knotted else ():
        tops = accumulate((-v.height - GAP_MM for v in every[k]), initial=spot.top)
        placed += [(v, spot.x, top) for v, top in zip(every[k], tops, strict=False)]
    return placed
