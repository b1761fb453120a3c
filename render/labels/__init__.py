"""Places for labels where they overlap no line, arrow, hinge or other label; all in mm of the sheet.

A fixed order of candidate places, costs, a greedy choice and then repairs: the same input gives the same places.  A
label without room beside its object is put farther away, with a leader line.
"""

from collections.abc import Iterable, Sequence
from contextlib import AbstractContextManager
from contextvars import ContextVar
from dataclasses import replace

from render.labels.board import FAR_PLACES, Board
from render.labels.candidates import BETWEEN, CLEAR_MM, Label, Placed, liked
from render.labels.footprints import Bounds, ink
from render.labels.surroundings import Surroundings
from render.paper.marks import Line, Mark, Text, within
from render.paper.style import LARGER, large, tall
from render.paper.typeset import box_of

__all__ = ["Label", "Labelled", "Placed", "place", "rough", "roughly"]

Labelled = tuple[list[Mark], list[Label]]
"""Marks, and labels still to be placed."""
SMALLER = {larger: mm for mm, larger in LARGER.items() if larger <= 5.0}  # 2.5 mm are the smallest readable letters
MOST_WIDE = len(FAR_PLACES)
_rough = ContextVar("rough", default=False)


def rough() -> bool:
    """Whether labels are only put in their preferred places, to estimate the size of a figure."""
    return _rough.get()


def roughly() -> AbstractContextManager[None]:
    """Within this context rough places are enough."""
    return within(_rough, True)


def place(
    labels: Sequence[Label], marks: Iterable[Mark] = (), field: Bounds | None = None, yielding: Iterable[Mark] = ()
) -> Placed:
    """Find a place for every label among the marks, inside the field (x0, y0, x1, y1) if one is given; in letters a
    step smaller where some have none.

    ``yielding`` are thin lines that the caller will break where a label lies on them.
    """
    larger = [replace(x, height=tall(x.height)) for x in labels]
    if not labels or rough():
        return liked(larger)
    marks = list(marks)
    standing = [m for m in marks if isinstance(m, Text)]
    around = Surroundings(ink([*marks, *map(_beside, standing)]), ink(yielding), ink(standing), field)
    if large() and not (board := settled(larger, around, 1)).unhappy():
        return board.placed()
    board = settled(labels, around)
    if board.unhappy():
        smaller = settled([replace(x, height=SMALLER.get(x.height, x.height)) for x in labels], around)
        board = min(board, smaller, key=lambda one: len(one.unhappy()))
    return board.placed()


def settled(labels: Sequence[Label], around: Surroundings, farther: int = MOST_WIDE) -> Board:
    """A board whose labels have places, as far as possible; for those without one nearby the search is extended
    ``farther`` off so many times."""
    board = Board(labels, around)
    board.choose()
    board.repair()
    while farther and board.widen():
        farther -= 1
        board.repair()
    if board.excuse():
        board.repair()
    return board


def _beside(text: Text) -> Line:
    """A line through a placed text, so far beyond it that no label beside it could be read as one word with it."""
    low, right, _, left = box_of(text)
    past, way = max(BETWEEN[0] * text.height - CLEAR_MM, 0.0), (right - low) / (abs(right - low) or 1.0)
    middle = (left - low) / 2
    return Line((low + middle - past * way, right + middle + past * way), "thin")
