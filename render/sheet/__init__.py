"""One sheet: views composed, the smallest format that holds them, their places, frame and title block."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import product

from planes.scene import Scene
from planes.words import Lang, say
from planes.words.errors import SceneError
from planes.words.frozen import frozen
from render.files import Page
from render.paper.typeset import plain_text
from render.sheet.fitting import (
    LETTERS_OF_FORMAT,
    NOTE_VIEW_KEY,
    Contents,
    Held,
    PlacedView,
    Way,
    best_fitting_way,
    fitting_attempts,
    key_without_shape,
    lay_out_views,
)
from render.sheet.frame import FORMATS, Paper, cell_texts
from render.sheet.packing import has_room_for_all, stacking_for_module, stacking_for_paper
from render.sheet.sizes import Sizes
from render.views import View

__all__ = ["Contents", "Held", "Sheet", "compose_sheet", "legibility_warnings", "stacking_for_paper"]

LONG_FORMAT, LONGEST_FORMAT = "A2x3", "A1x3"  # as high as A1 and A0, half as wide again


@dataclass(frozen=True, repr=False, kw_only=True)
class Sheet(Page):
    """A composed sheet: its format, its marks, its views with their places (left, top), and the remarks about it."""

    paper: Paper
    views: tuple[PlacedView, ...]

    def __repr__(self) -> str:
        return f"<Sheet {self.title!r}, {self.size[0]:g} × {self.size[1]:g} mm, {len(self.views)} views>"


def compose_sheet(scene: Scene, contents: Contents, lang: Lang, number: int | None = None) -> Sheet:
    """The sheet of a scene: the smallest format, or the one it names, with room for all views.

    Only if no format holds all of them are the optional ones left out; the sheet then says so. A2×3 is taken where
    nothing smaller holds even the others, then A0, and A1×3 rather than plans whose μ differs from that of the note.
    """
    stacking_for_module.cache_clear()
    chosen = str(scene.sheet.get("format", "auto"))
    *usual, largest = FORMATS
    papers = ([chosen],) if chosen != "auto" else (usual, [LONG_FORMAT], [largest], [LONGEST_FORMAT])
    for factor, formats, everything in product(contents.size_factors, papers, (True, False)):
        if one := fill_first_format(contents, formats, factor, everything):
            wanted, spare = one.contents.lettered_views(*one.how)
            missing = [*one.waiting_views, *(() if everything else spare)]
            left_out = (left_out_views_text(missing, wanted, one.paper, number, lang),) if missing else ()
            smaller = (say("smaller_mu", lang, format=one.paper.name),) if factor < 1 else ()
            return finish_sheet(scene, one.paper, one.places, lang, number, left_out + smaller)
    raise no_room_error(contents, Paper(papers[-1][-1]), lang)


@frozen
class FilledPaper:
    """A paper with views in place, and those still waiting for room."""

    paper: Paper
    contents: Contents
    how: Way
    places: list[PlacedView]

    @cached_property
    def waiting_views(self) -> list[View]:
        """The views waiting for room, each in its preferred shape."""
        shapes = {key_without_shape(v.key): v for v in reversed(self.contents.waiting_views(*self.how))}
        return [*reversed(shapes.values())]


def fill_first_format(
    contents: Contents, formats: Sequence[str], factor: float, everything: bool
) -> FilledPaper | None:
    """The first of some formats that holds the views."""
    for name in formats:
        ways = fitting_attempts(contents, name, factor, everything)
        laid_out = (
            FilledPaper(Paper(name), tried, how, lay_out_views(tried, how, order, everything, Paper(name)))
            for tried, how, order in ways
        )
        one = next((one for one in laid_out if one.places), None)
        if one and (
            name == formats[-1] or NOTE_VIEW_KEY not in (key_without_shape(v.key) for v in one.waiting_views)
        ):  # a larger one holds it
            return one
    return None


def left_out_views_text(
    spare: Sequence[View], views: Sequence[View], paper: Paper, number: int | None, lang: Lang
) -> str:
    """The views left out, and the format that would hold them."""
    fitting = next((n for n in larger_formats(paper) if has_room_for_all([*views, *spare], Paper(n))), "")
    listed = "; ".join(
        f"«{plain_text(v.title or v.key)}» ({v.width:.0f} × {v.height:.0f} {say('mm', lang)})" for v in spare
    )
    key = "left_out_larger" if fitting else "left_out_sheet" if number is None else "left_out"
    return say(key, lang, format=paper.name, views=listed, larger=fitting)


def finish_sheet(
    scene: Scene,
    paper: Paper,
    places: Sequence[PlacedView],
    lang: Lang,
    number: int | None = None,
    warnings: tuple[str, ...] = (),
) -> Sheet:
    """The views in their places within frame and title block."""
    placed = (m for v, left, top in places for m in v.marks_placed_at(left, top))
    marks = (*paper.frame_marks(cell_texts(scene, lang, number), lang), *placed)
    said = (*warnings, *(sentence for v, _, _ in places for sentence in legibility_warnings(v, lang)))
    return Sheet(marks, paper.size, scene.title.get(lang, ""), lang, said, paper=paper, views=tuple(places))


def legibility_warnings(one: View, lang: Lang) -> list[str]:
    """Sentences about what cannot be seen or read in a view."""
    facts = {"view": plain_text(one.title or one.key), "names": one.unreadable_labels}
    return [*one.unseen, *([say("overprinted", lang, **facts)] if one.unreadable_labels else [])]


def no_room_error(contents: Contents, paper: Paper, lang: Lang) -> SceneError:
    """The error that a view is too large, or all of them together; with the format that holds them, if there is one."""
    views = contents.lettered_views(
        Sizes(contents.size_factors[-1]), LETTERS_OF_FORMAT[paper.name[:2]][-1], contents.together[-1], ()
    )[0]
    largest = max(views, key=lambda v: v.width * v.height)
    key = "no_room" if not has_room_for_all([largest], paper) else "no_room_together"
    tried = product(larger_formats(paper), contents.size_factors)
    fitting = next((n for n, factor in tried if best_fitting_way(contents, n, factor, True)), "")
    advice = say("room_on", lang, larger=fitting) if fitting else say("no_room_larger", lang)
    size = {"width": round(largest.width), "height": round(largest.height)}
    named = {"format": paper.name, "view": plain_text(largest.title or largest.key)}
    return SceneError(say(key, lang, count=len(views), advice=advice, **size, **named))


def larger_formats(paper: Paper) -> list[str]:
    """The formats larger than one, without the additional ones."""
    return [name for name in FORMATS if math.prod(FORMATS[name]) > math.prod(paper.size)]
