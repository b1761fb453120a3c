"""Places for labels where they overlap no line, arrow, hinge or other label; all in mm of the sheet.

A fixed order of candidate places, costs, a greedy choice and then repairs: the same input gives the same places.  A
label without room beside its object is put farther away, with a leader line.
"""

from collections.abc import Iterable, Sequence
from contextlib import AbstractContextManager
from contextvars import ContextVar
from dataclasses import replace

from render.labels.board import FAR_PLACE_COUNTS, Board
from render.labels.candidates import LABEL_GAP_RATIOS, LEAST_INK_DISTANCE_MM, Label, Placed, place_at_preferred
from render.labels.footprints import Bounds, inked_shapes
from render.labels.surroundings import Surroundings
from render.paper.marks import Line, Mark, Text, using_setting
from render.paper.style import NEXT_LARGER_LETTER_MM, figure_letter_height, is_large_format
from render.paper.typeset import text_box_corners

__all__ = ["Label", "Labelled", "Placed", "is_rough_placement", "place_labels", "rough_placement"]

Labelled = tuple[list[Mark], list[Label]]
"""Marks, and labels still to be placed."""
NEXT_SMALLER_LETTER_MM = {
    larger: mm for mm, larger in NEXT_LARGER_LETTER_MM.items() if larger <= 5.0
}  # 2.5 mm are the smallest readable letters
MOST_WIDENINGS = len(FAR_PLACE_COUNTS)
_rough = ContextVar("rough", default=False)


def is_rough_placement() -> bool:
    """Whether labels are only put in their preferred places, to estimate the size of a figure."""
    return _rough.get()


def rough_placement() -> AbstractContextManager[None]:
    """Within this context rough places are enough."""
    return using_setting(_rough, True)


def place_labels(
    labels: Sequence[Label], marks: Iterable[Mark] = (), field: Bounds | None = None, yielding: Iterable[Mark] = ()
) -> Placed:
    """Find a place for every label among the marks, inside the field (x0, y0, x1, y1) if one is given; in letters a
    step smaller where some have none.

    ``yielding`` are thin lines that the caller will break where a label lies on them.
    """
    larger = [replace(x, height=figure_letter_height(x.height)) for x in labels]
    if not labels or is_rough_placement():
        return place_at_preferred(larger)
    marks = list(marks)
    standing = [m for m in marks if isinstance(m, Text)]
    around = Surroundings(
        inked_shapes([*marks, *map(_keep_clear_line, standing)]), inked_shapes(yielding), inked_shapes(standing), field
    )
    if is_large_format() and not (board := settle_board(larger, around, 1)).overlapping_labels():
        return board.placed_labels()
    board = settle_board(labels, around)
    if board.overlapping_labels():
        smaller = settle_board(
            [replace(x, height=NEXT_SMALLER_LETTER_MM.get(x.height, x.height)) for x in labels], around
        )
        board = min(board, smaller, key=lambda one: len(one.overlapping_labels()))
    return board.placed_labels()


def settle_board(labels: Sequence[Label], around: Surroundings, farther: int = MOST_WIDENINGS) -> Board:
    """A board whose labels have places, as far as possible; for those without one nearby the search is extended
    ``farther`` off so many times."""
    board = Board(labels, around)
    board.choose_places()
    board.repair_overlaps()
    while farther and board.offer_farther_places():
        farther -= 1
        board.repair_overlaps()
    board.lead_stray_labels()
    if board.leave_out_repeated_labels():
        board.repair_overlaps()
    return board


def _keep_clear_line(text: Text) -> Line:
    """A line through a placed text, so far beyond it that no label beside it could be read as one word with it."""
    low, right, _, left = text_box_corners(text)
    past = max(LABEL_GAP_RATIOS[0] * text.height - LEAST_INK_DISTANCE_MM, 0.0)
    way = (right - low) / (abs(right - low) or 1.0)
    middle = (left - low) / 2
    return Line((low + middle - past * way, right + middle + past * way), "thin")
