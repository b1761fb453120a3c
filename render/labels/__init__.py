"""Places for labels where they overlap no line, arrow, hinge or other label; all in mm of the sheet.

A fixed order of candidate places, costs, a greedy choice and then repairs: the same input gives the same
places.  A label that finds no room beside what it names goes farther away, with a leader line.
"""

from collections.abc import Iterable, Sequence

from render.labels.board import Board
from render.labels.candidates import Label, Placed
from render.labels.footprints import Bounds, ink
from render.paper.marks import Mark

__all__ = ["Label", "Placed", "place"]


def place(
    labels: Sequence[Label], marks: Iterable[Mark] = (), field: Bounds | None = None, yielding: Iterable[Mark] = ()
) -> Placed:
    """Find a place for every label among the marks, inside the field (x0, y0, x1, y1) if one is given.

    ``yielding`` are thin lines that whoever asked will break where a label stands on them.
    """
    if not labels:
        return Placed((), ())
    board = Board(labels, ink(marks), field, ink(yielding))
    board.choose()
    board.repair()
    while board.widen():
        board.repair()
    return board.placed()
