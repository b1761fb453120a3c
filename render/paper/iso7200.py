"""The frame of ISO 5457 and the title block of ISO 7200 as data, in mm.

The frame is 20 mm from the left edge and 10 mm from the others. Around it is a border of 5 mm with the grid reference
system: fields of 50 mm from the axes of symmetry, those at the corners taking up the rest, with numerals from left to
right and letters from the top down without I and O; on A4 only above and at the right. Centring marks cross the frame
on the axes. The title block, 180 × 36 mm, is in the lower right corner of the frame.
"""

import json
import string
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

from planes.words import Lang, sentence_table
from planes.words.records import Json
from render.paper import form1
from render.paper.form1 import Cell, Form, Segment, title_block_cells, title_block_lines
from render.paper.marks import Size

LEFT_MARGIN_MM = 20.0
EDGE_MARGIN_MM = 10.0
BORDER_WIDTH_MM = 5.0
TITLE_BLOCK_SIZE_MM = (180.0, 36.0)
GRID_FIELD_LENGTH_MM = 50.0
CENTRING_MARK_INSIDE_MM = 5.0  # how far a centring mark, 10 mm long in all, extends into the drawing space
GRID_LETTERS = string.ascii_uppercase.replace("I", "").replace("O", "")
MOST_ONE_SIDED_LENGTH_MM = 300.0  # sheets up to this length have fields only above and at the right

_FORM_DATA: Json = json.loads(Path(__file__).with_name("iso7200.json").read_text("utf-8"))


def form_lines(size: Size) -> Iterator[Segment]:
    """Every line except the frame itself, on a sheet of that width × height."""
    yield from title_block_lines(_FORM_DATA, _title_block_corner(size))
    wide, high = size
    outer = [
        complex(LEFT_MARGIN_MM - BORDER_WIDTH_MM, BORDER_WIDTH_MM),
        complex(wide - BORDER_WIDTH_MM, BORDER_WIDTH_MM),
    ]
    outer += [
        complex(wide - BORDER_WIDTH_MM, high - BORDER_WIDTH_MM),
        complex(LEFT_MARGIN_MM - BORDER_WIDTH_MM, high - BORDER_WIDTH_MM),
    ]
    for a, b in pairwise((*outer, outer[0])):
        yield a, b, "thin"
    for upright, at, out in _frame_sides(size):
        for place in _grid_field_bounds(size[upright], *_side_ends(size, upright))[1:-1]:
            yield _point_on_side(upright, place, at), _point_on_side(upright, place, at + out * BORDER_WIDTH_MM), "thin"
    for upright, at, out in _frame_sides(size, marks=True):
        middle = size[upright] / 2
        yield (
            _point_on_side(upright, middle, at - out * CENTRING_MARK_INSIDE_MM),
            _point_on_side(upright, middle, at + out * BORDER_WIDTH_MM),
            "thick",
        )


def _title_block_corner(size: Size) -> Size:
    """The lower left corner of the title block."""
    return size[0] - EDGE_MARGIN_MM - TITLE_BLOCK_SIZE_MM[0], EDGE_MARGIN_MM


def _frame_sides(size: Size, marks: bool = False) -> Iterator[tuple[bool, float, int]]:
    """The sides of the frame: whether vertical, where, and the outward direction; the last two not on a small sheet."""
    yield False, size[1] - EDGE_MARGIN_MM, 1
    yield True, size[0] - EDGE_MARGIN_MM, 1
    if marks or max(size) > MOST_ONE_SIDED_LENGTH_MM:
        yield False, EDGE_MARGIN_MM, -1
        yield True, LEFT_MARGIN_MM, -1


def _point_on_side(upright: bool, along: float, at: float) -> complex:
    return complex(at, along) if upright else complex(along, at)


def _side_ends(size: Size, upright: bool) -> tuple[float, float]:
    """The ends of a side of the frame."""
    if upright:
        return (EDGE_MARGIN_MM, size[1] - EDGE_MARGIN_MM)
    return (LEFT_MARGIN_MM, size[0] - EDGE_MARGIN_MM)


def _grid_field_bounds(side: float, low: float, high: float) -> list[float]:
    """Bounds of the fields along a side of the sheet of that length, from the low end of the frame to the high one."""
    count = round(side / 2 / GRID_FIELD_LENGTH_MM)  # in each half
    return [low, *(side / 2 + k * GRID_FIELD_LENGTH_MM for k in range(1 - count, count)), high]


def printed_words(size: Size, lang: Lang) -> Iterator[tuple[str, Cell]]:
    """Names of the fields of the title block and of the grid, each with its cell."""
    texts = sentence_table(lang, "form1")
    for key, cell in title_block_cells(_FORM_DATA["words"], _title_block_corner(size)):
        yield texts[f"iso_{key}"], cell
    for upright, at, out in _frame_sides(size):
        bounds = _grid_field_bounds(size[upright], *_side_ends(size, upright))
        names = GRID_LETTERS[len(bounds) - 2 :: -1] if upright else map(str, range(1, len(bounds)))
        for name, (a, b) in zip(names, pairwise(bounds), strict=True):
            corner = _point_on_side(upright, a, min(at, at + out * BORDER_WIDTH_MM))
            wide, high = (BORDER_WIDTH_MM, b - a) if upright else (b - a, BORDER_WIDTH_MM)
            yield name, Cell(corner.real, corner.imag, wide, high, 3.5)


def fill_in_cells(size: Size) -> dict[str, Cell]:
    """The cells to fill in, by name, on a sheet of that width × height."""
    return {
        key: cell
        for part in ("cells", "cells_beneath")
        for key, cell in title_block_cells(_FORM_DATA[part], _title_block_corner(size))
    }


ISO_FORM = Form(
    "iso",
    "ISO_7200",
    LEFT_MARGIN_MM,
    edge=EDGE_MARGIN_MM,
    block=TITLE_BLOCK_SIZE_MM,
    top_cell=None,
    lines=form_lines,
    words=printed_words,
    cells=fill_in_cells,
)
FORMS_BY_NAME = {form.name: form for form in (form1.GOST_FORM, ISO_FORM)}
