"""A view: one part of a sheet drawn about its own origin, in mm, with its title and the box of its ink."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from render.labels.footprints import Bounds, bounds, overprinted
from render.paper.marks import Mark, Text, moved
from render.paper.typeset import extent, plain

TITLE_MM = 5.0  # letter height of titles
REMARK_MM = 2.5
TITLE_GAP = 4.0  # from a title to its view


@dataclass(frozen=True)
class View:
    """``key`` names the view for settings ("velocity"), ``title`` is lettered above it ("" for none); ``unseen`` are
    sentences about what should be in it and is not; ``plan`` is whose μ makes it larger ("" for none)."""

    key: str
    title: str
    marks: tuple[Mark, ...]
    box: Bounds
    figure: bool = False  # a scheme or a plan: they are read one after the other
    unseen: tuple[str, ...] = ()
    plan: str = ""

    @cached_property
    def crowded(self) -> tuple[str, ...]:
        """The labels that found no place of their own."""
        return tuple(dict.fromkeys(map(plain, overprinted(self.marks))))

    @property
    def width(self) -> float:
        """Width of the box in mm."""
        return self.box[2] - self.box[0]

    @property
    def height(self) -> float:
        """Height of the box in mm."""
        return self.box[3] - self.box[1]

    def placed(self, left: float, top: float) -> tuple[Mark, ...]:
        """The marks with the upper left corner of the box at a place of the sheet."""
        by = complex(left - self.box[0], top - self.box[3])
        return tuple(moved(mark, by) for mark in self.marks)


def view(
    key: str,
    title: str,
    marks: Iterable[Mark],
    figure: bool = False,
    unseen: Iterable[str] = (),
    plan: str = "",
    height: float = TITLE_MM,
) -> View:
    """A view with its title centred above it."""
    held = tuple(marks)
    box = bounds(held)
    if title:
        x0, y0, x1, y1 = extent(title, height)
        place = complex((box[0] + box[2]) / 2, box[3] + TITLE_GAP - y0)
        held = (*held, Text(title, place, height, "middle", name=f"title {key}"))
        half = (x1 - x0) / 2
        box = (min(box[0], place.real - half), box[1], max(box[2], place.real + half), place.imag + y1)
    return View(key, title, held, box, figure, tuple(unseen), plan)


def remark(text: str, marks: Iterable[Mark]) -> Text:
    """What must be known of the marks, in small letters beneath them."""
    x0, y0, x1, _ = bounds(tuple(marks))
    return Text(text, complex((x0 + x1) / 2, y0 - 5.0), REMARK_MM, "middle", name="remark")


def stacked(key: str, views: Sequence[View], gap: float = 6.0) -> View:
    """Views one beneath the other on one middle line, as one view with the title of the first."""
    marks: list[Mark] = []
    y, boxes = 0.0, []
    for one in views:
        by = complex(-(one.box[0] + one.box[2]) / 2, y - one.box[3])
        marks += (moved(mark, by) for mark in one.marks)
        boxes.append([z + (by.imag if k % 2 else by.real) for k, z in enumerate(one.box)])
        y = boxes[-1][1] - gap
    left, low, right, top = zip(*boxes, strict=True)
    box, unseen = (min(left), min(low), max(right), max(top)), tuple(s for v in views for s in v.unseen)
    return replace(views[0], key=key, marks=tuple(marks), box=box, unseen=unseen)


def beside(views: Sequence[View], gap: float = 8.0, top: float | None = None, left: float = 0.0) -> View:
    """Views one beside the other as one view, their lower edges in one line, or their upper ones at ``top``."""
    marks: list[Mark] = []
    for one in views:
        marks += one.placed(left, one.height if top is None else top)
        left += one.width + gap
    return View("row", "", tuple(marks), (0.0, 0.0, left - gap, max(one.height for one in views)))
