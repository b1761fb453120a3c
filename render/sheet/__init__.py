"""One sheet: views composed, the smallest format that holds them, places, frame and title block."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cache
from itertools import accumulate, product

from planes.scene import Scene
from planes.words import Lang, say
from planes.words.errors import SceneError
from render.files import Page
from render.paper.typeset import plain
from render.sheet.columns import OVER, Columns, Item
from render.sheet.composer import LARGER
from render.sheet.frame import FORMATS, Paper, said_cells
from render.sheet.module import GAP_MM, Module
from render.sheet.sizes import LARGEST, Extents, Sizes, grown
from render.sheet.stacking import Stacking
from render.views import View, plumbed

SMALLER = (0.8, 0.63, 0.5, 0.4)
"""How small, against the scene's choice, plans may become where μ is open and no paper holds them; it is said."""
LETTERS = {"A4": (2.5,), "A3": (3.5, 2.5), "A2": (3.5, 2.5), "A1": (5.0, 3.5), "A0": (5.0, 3.5)}
"""Letter heights of tables to try on a format, or on several of it side by side, in mm; equations are a step larger."""
Upright = tuple[str, ...]
UPRIGHT: tuple[Upright, ...] = (("motion", "rates"), ("motion",), ("rates",), ())
"""Blocks of views that are to stand beneath each other: as many as a format has room for."""


@dataclass(frozen=True)
class Contents:
    """What a sheet shows.

    ``views`` are those it must hold, and those that may be left out, for sizes of plans, a letter height of tables,
    and whether equations stand under their plans; ``extents`` what may grow, with its size in mm; ``free``: the μ of
    some plans is open.
    """

    views: Callable[[Sizes, float, bool], tuple[list[View], list[View]]]
    extents: Extents = lambda sizes: {}
    extras: tuple[str, ...] = ()  # those of the views that wait for room that have found some
    free: bool = False

    @property
    def factors(self) -> tuple[float, ...]:
        """How large plans may be, against the scene's choice."""
        return (1.0, *SMALLER) if self.free else (1.0,)

    def lettered(self, sizes: Sizes, letter: float, together: bool, upright: Upright) -> tuple[list[View], list[View]]:
        """The views with titles as high as their equations, in blocks if those stand ``upright``."""
        wanted, spare = self.views(sizes, letter, together)
        wanted = [v for v in wanted if v.key in self.extras or not v.extra]

        def shown(v: View) -> View:
            return replace(v, heading=LARGER[letter], block=v.block if v.block in upright else "")

        return list(map(shown, wanted)), list(map(shown, spare))

    def extra(self, sizes: Sizes, letter: float, together: bool, upright: Upright) -> list[View]:
        """The views that wait for room."""
        return [v for v in self.views(sizes, letter, together)[0] if v.extra and v.key not in self.extras]


@dataclass(frozen=True, repr=False, kw_only=True)
class Sheet(Page):
    """A composed sheet: its format, its marks, its views with their places (left, top), and what must be said of it."""

    paper: Paper
    views: tuple[tuple[View, float, float], ...]

    def __repr__(self) -> str:
        return f"<Sheet {self.title!r}, {self.size[0]:g} × {self.size[1]:g} mm, {len(self.views)} views>"


def compose(scene: Scene, contents: Contents, lang: Lang, number: int | None = None) -> Sheet:
    """The sheet of a scene: the smallest format, or the one it names, on which all views find room.

    Only where no format holds all of them are those left out that may be; the sheet then says so. A0 is taken where
    nothing less holds even the others.
    """
    chosen = str(scene.sheet.get("format", "auto"))
    *usual, largest = FORMATS
    papers = ([chosen],) if chosen != "auto" else (usual, [largest])
    for factor, formats in product(contents.factors, papers):
        for whole, name in product((True, False), formats):
            how = fitted(contents, name, factor, whole)
            if how:
                contents, how = with_extras(contents, how, name, whole)
                wanted, spare = contents.lettered(*how)
                places = enlarged(contents, *how, whole, Paper(name))
                missing = [*contents.extra(*how), *(() if whole else spare)]
                left_out = (without(missing, wanted, Paper(name), number, lang),) if missing else ()
                smaller = (say("smaller_mu", lang, format=name),) if factor < 1 else ()
                return finished(scene, Paper(name), places, lang, number, left_out + smaller)
    raise no_room(contents, Paper(papers[-1][-1]), lang)


Way = tuple[Sizes, float, bool, Upright]
"""Sizes of plans, a letter height, whether equations stand under their plans, and which blocks stand upright."""


def ways(sizes: Sizes, name: str, fits: Callable[[Way], bool], best: Way | None = None) -> Way | None:
    """The best looking way to fill a format, but none better than ``best``; large letters only where small ones fit."""
    fit, how = cache(fits), [*product(LETTERS[name[:2]], (True, False))]
    levels = [[(sizes, *h, upright) for h in how] for upright in UPRIGHT]
    if best:
        k = UPRIGHT.index(best[-1])
        levels = [levels[k][levels[k].index(best) :], *levels[k + 1 :]]
    if not any(map(fit, levels[-1][-2:])):
        return None
    return next(filter(fit, next(level for level in levels if any(map(fit, level[-2:])))))


def fitted(contents: Contents, name: str, factor: float, whole: bool) -> Way | None:
    """The best looking way in which all views (but, unless ``whole``, those that may be left out) fit on a format."""

    def fits(how: Way) -> bool:
        wanted, spare = contents.lettered(*how)
        shown = [*wanted, *spare] if whole else wanted
        # rather is left out what may be than all drawn too small for its letters
        knotted = whole and spare and factor < 1 and any(v.crowded for v in shown)
        return bool(whole or spare) and not knotted and packed(shown, Paper(name))

    return ways(Sizes(factor), name, fits)


def with_extras(contents: Contents, how: Way, name: str, whole: bool) -> tuple[Contents, Way]:
    """The same with as many of the views that wait for room as there is some for, with plans no smaller."""
    for key in [v.key for v in contents.extra(*how)]:
        more = replace(contents, extras=(*contents.extras, key))

        def fits(how: Way, more: Contents = more) -> bool:
            wanted, spare = more.lettered(*how)
            return packed([*wanted, *spare] if whole else wanted, Paper(name))

        other = ways(how[0], name, fits, how)
        contents, how = (more, other) if other else (contents, how)
    return contents, how


def enlarged(
    contents: Contents, sizes: Sizes, letter: float, together: bool, upright: Upright, whole: bool, paper: Paper
) -> list[tuple[View, float, float]]:
    """Places of the views on the paper, its plans as large as there is room for without spoiling their order."""

    def views(sizes: Sizes) -> list[View]:
        found, spare = contents.lettered(sizes, letter, together, upright)
        return [*found, *spare] if whole else found

    x0, y0, x1, y1 = paper.field
    most = LARGEST * min(x1 - x0, y1 - y0)

    stacking = stacking_of(views(sizes), paper)
    order = columns_of(views(sizes), stacking).arranged()[0]

    def fits(sizes: Sizes) -> bool:
        nonlocal order
        columns = columns_of(views(sizes), stacking)
        if columns.ordered(order).cost < OVER:
            return True
        other, found = columns.arranged(order, OVER)
        order = other if found.cost < OVER else order
        return found.cost < OVER

    shown = views(grown(sizes, contents.extents, most, fits))
    order, best = columns_of(shown, stacking).arranged(order)
    found, every = [], blocks(shown)
    for k, spot in zip(order, best.spots, strict=True):
        tops = accumulate((-v.height - GAP_MM for v in every[k]), initial=spot.top)
        found += [(v, spot.x, top) for v, top in zip(every[k], tops, strict=False)]
    return found


def blocks(views: Sequence[View]) -> list[list[View]]:
    """Views that stand beneath each other, whatever is about them: those of one block."""
    found: list[list[View]] = []
    for v in views:
        if v.block and found and found[-1][-1].block == v.block:
            found[-1].append(v)
        else:
            found.append([v])
    return [plumbed(block) for block in found]


def stacking_of(views: Sequence[View], paper: Paper) -> Stacking:
    """What views may fill."""
    return Stacking(Module(paper.field, paper.taken, max((v.width for b in blocks(views) for v in b), default=0.0)))


def columns_of(views: Sequence[View], stacking: Stacking) -> Columns:
    """The views in columns, in the order given."""
    every = blocks(views)
    high = [sum(v.height + GAP_MM for v in block) - GAP_MM for block in every]
    wide = [max(v.width for v in block) for block in every]
    items = [Item(w, h, b[0].step, not b[0].figure) for w, h, b in zip(wide, high, every, strict=True)]
    return Columns(items, stacking)


def packed(views: Sequence[View], paper: Paper) -> bool:
    """Whether there is room for all views on the paper."""
    return columns_of(views, stacking_of(views, paper)).arranged(enough=OVER)[1].cost < OVER


def without(spare: Sequence[View], views: Sequence[View], paper: Paper, number: int | None, lang: Lang) -> str:
    """What was left out, and which format would hold it."""
    fitting = next((n for n in larger_than(paper) if packed([*views, *spare], Paper(n))), "")
    told = "; ".join(f"«{plain(v.title or v.key)}» ({v.width:.0f} × {v.height:.0f} {say('mm', lang)})" for v in spare)
    key = "left_out_larger" if fitting else "left_out_sheet" if number is None else "left_out"
    return say(key, lang, format=paper.name, views=told, larger=fitting)


def finished(
    scene: Scene,
    paper: Paper,
    places: Sequence[tuple[View, float, float]],
    lang: Lang,
    number: int | None = None,
    warnings: tuple[str, ...] = (),
) -> Sheet:
    """The views in their places within frame and title block."""
    placed = (m for v, left, top in places for m in v.placed(left, top))
    marks = (*paper.marks(said_cells(scene, lang, number), lang), *placed)
    said = (*warnings, *(sentence for v, _, _ in places for sentence in unseen(v, lang)))
    return Sheet(marks, paper.size, scene.title.get(lang, ""), lang, said, paper=paper, views=tuple(places))


def unseen(one: View, lang: Lang) -> list[str]:
    """Sentences about what cannot be seen or read in a view."""
    told = {"view": plain(one.title or one.key), "names": ", ".join(one.crowded)}
    return [*one.unseen, *([say("overprinted", lang, **told)] if one.crowded else [])]


def no_room(contents: Contents, paper: Paper, lang: Lang) -> SceneError:
    """Which view is too large, or that all of them together are; and which format holds them, if one was found to."""
    views = contents.lettered(Sizes(contents.factors[-1]), LETTERS[paper.name[:2]][-1], False, ())[0]
    largest = max(views, key=lambda v: v.width * v.height)
    key = "no_room" if not packed([largest], paper) else "no_room_together"
    tried = product(larger_than(paper), contents.factors)
    fitting = next((n for n, factor in tried if fitted(contents, n, factor, True)), "")
    advice = say("room_on", lang, larger=fitting) if fitting else say("no_room_larger", lang)
    size = {"width": round(largest.width), "height": round(largest.height)}
    named = {"format": paper.name, "view": plain(largest.title or largest.key)}
    return SceneError(say(key, lang, count=len(views), advice=advice, **size, **named))


def larger_than(paper: Paper) -> list[str]:
    """The formats larger than one, but for the additional ones."""
    return [name for name in FORMATS if math.prod(FORMATS[name]) > math.prod(paper.size)]
