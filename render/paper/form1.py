"""Form 1 of ГОСТ 2.104 as data: lines, words and cells of the title block and of the columns around the frame, in mm.

The title block is in the lower right corner of the frame; graphs 19–23 are outside its left side from the lower corner
up, 24 and 25 from the upper corner down, each a column of words 5 mm wide and one of values 7 mm wide; graph 26, the
designation upside down, is in the upper left corner of the field.  (On an upright sheet above A4 it would be turned by
90° in the upper right corner; the formats here are landscape, except A4.)
"""

import json
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any, Literal

from planes.words import Lang, sentence_table
from planes.words.frozen import frozen, replace
from planes.words.records import Json
from render.paper.marks import Size

LEFT_MARGIN_MM = 20.0  # margin of the frame on the left
EDGE_MARGIN_MM = 5.0  # all its other margins
TITLE_BLOCK_SIZE_MM = (185.0, 55.0)  # the title block
TOP_CELL_SIZE_MM = (70.0, 14.0)  # graph 26

Segment = tuple[complex, complex, Literal["thick", "thin"]]


@frozen
class Cell:
    """A cell from its lower left corner (x, y), with ``letter`` the intended letter height in mm.

    ``anchor`` is the place of its text, ``turn_deg`` its rotation: 0, 90 (read from the right) or 180.
    """

    x: float
    y: float
    width: float
    height: float
    letter: float = 2.5
    anchor: Literal["start", "middle"] = "middle"
    turn_deg: float = 0.0

    @property
    def middle(self) -> complex:
        """Its middle."""
        return complex(self.x + self.width / 2, self.y + self.height / 2)


@frozen
class Form:
    """A frame with a title block: its names in a scene and as a DXF block; margins left and elsewhere, sizes of the
    title block and of the cell in the upper left corner; its lines, words and cells on a sheet of a given size."""

    name: str
    drawn_as: str
    left: float
    edge: float
    block: Size
    top_cell: Size | None
    lines: Callable[[Size], Iterable[Segment]]
    words: Callable[[Size, Lang], Iterable[tuple[str, Cell]]]
    cells: Callable[[Size], dict[str, Cell]]


_FORM_DATA: Json = json.loads(Path(__file__).with_name("form1.json").read_text("utf-8"))
"""From the lower left corner of the title block, in mm: lines from x, y to x, y; cells of words and of values, in it
and beneath it. Beside the frame: graphs 19–23 from the lower corner up and 24–25, the last at the upper corner, each
with its height."""
SIDE_CELL_KEYS: tuple[str, ...] = tuple(key for key, _ in (*_FORM_DATA["lower"], *_FORM_DATA["upper"]))
"""Graphs 19–25."""
WORD_COLUMN_WIDTH_MM = 5.0  # the columns of graphs 19–25: their words
VALUE_COLUMN_WIDTH_MM = 7.0  # and their values


def cell_prompt(key: str, lang: Lang) -> str:
    """The name of a cell in a prompt, with the number of its graph."""
    words = sentence_table(lang, "form1")
    return words.get(f"cell_{key}") or ", ".join(words.get(f"cell_{word}", word) for word in key.split("_"))


def form_lines(size: Size) -> Iterator[Segment]:
    """Every line of the form except the frame itself, on a sheet of that width × height."""
    yield from title_block_lines(_FORM_DATA, _title_block_corner(size))
    for bottom, rows in _side_columns(size):
        yield from _side_column_lines(bottom, [high for _, high in rows])
    top = size[1] - EDGE_MARGIN_MM
    right = LEFT_MARGIN_MM + TOP_CELL_SIZE_MM[0]
    yield complex(LEFT_MARGIN_MM, top - TOP_CELL_SIZE_MM[1]), complex(right, top - TOP_CELL_SIZE_MM[1]), "thick"
    yield complex(right, top - TOP_CELL_SIZE_MM[1]), complex(right, top), "thick"


def title_block_lines(form: Json, corner: Size) -> Iterator[Segment]:
    """Lines of a title block with its lower left corner there."""
    pens: tuple[Literal["thick", "thin"], ...] = ("thick", "thin")
    for pen in pens:
        for x0, y0, x1, y1 in form[pen]:
            yield complex(*corner) + complex(x0, y0), complex(*corner) + complex(x1, y1), pen


def _title_block_corner(size: Size) -> Size:
    """The lower left corner of the title block."""
    return size[0] - EDGE_MARGIN_MM - TITLE_BLOCK_SIZE_MM[0], EDGE_MARGIN_MM


def _side_columns(size: Size) -> tuple[tuple[float, list[tuple[str, float]]], ...]:
    """The start of the lower and the upper column of graphs beside the frame, and their rows."""
    lower = _FORM_DATA["lower"]
    upper = _FORM_DATA["upper"]
    return (EDGE_MARGIN_MM, lower), (size[1] - EDGE_MARGIN_MM - sum(high for _, high in upper), upper)


def _side_column_lines(bottom: float, heights: list[float]) -> Iterator[Segment]:
    """Lines of a column of graphs beside the frame."""
    left = LEFT_MARGIN_MM - WORD_COLUMN_WIDTH_MM - VALUE_COLUMN_WIDTH_MM
    top = bottom + sum(heights)
    for x in (left, left + WORD_COLUMN_WIDTH_MM):
        yield complex(x, bottom), complex(x, top), "thick"
    for k in range(len(heights) + 1):
        y = bottom + sum(heights[:k])
        yield complex(left, y), complex(LEFT_MARGIN_MM, y), "thick"


def printed_words(size: Size, lang: Lang) -> Iterator[tuple[str, Cell]]:
    """The printed words of the form, each with its cell."""
    texts = sentence_table(lang, "form1")
    beside = _side_column_cells(
        size, LEFT_MARGIN_MM - WORD_COLUMN_WIDTH_MM - VALUE_COLUMN_WIDTH_MM, WORD_COLUMN_WIDTH_MM
    )
    for key, cell in (
        *title_block_cells(_FORM_DATA["words"], _title_block_corner(size)),
        *beside,
        *title_block_cells(_FORM_DATA["words_beneath"], _title_block_corner(size)),
    ):
        yield texts[f"form_{key}"], cell


def fill_in_cells(size: Size) -> dict[str, Cell]:
    """The cells to fill in, by name, on a sheet of that width × height."""
    named_cells = dict(title_block_cells(_FORM_DATA["cells"], _title_block_corner(size)))
    for key, cell in _side_column_cells(size, LEFT_MARGIN_MM - VALUE_COLUMN_WIDTH_MM, VALUE_COLUMN_WIDTH_MM):
        named_cells[key] = replace(cell, letter=3.5)
    top = size[1] - EDGE_MARGIN_MM - TOP_CELL_SIZE_MM[1]
    named_cells["designation_turned"] = Cell(LEFT_MARGIN_MM, top, *TOP_CELL_SIZE_MM, 7.0, "middle", 180.0)
    return named_cells | dict(title_block_cells(_FORM_DATA["cells_beneath"], _title_block_corner(size)))


def title_block_cells(rows: list[Any], corner: Size) -> Iterator[tuple[str, Cell]]:
    """Cells of a title block with its lower left corner there."""
    for key, x, y, wide, high, *how in rows:
        how_set = dict(zip(("letter", "anchor", "turn_deg"), how, strict=False))
        yield key, Cell(x + corner[0], y + corner[1], wide, high, **how_set)


def _side_column_cells(size: Size, x: float, wide: float) -> Iterator[tuple[str, Cell]]:
    """The columns beside the frame: their graphs with cells of one width."""
    for y, rows in _side_columns(size):
        for key, high in rows:
            yield key, Cell(x, y, wide, height=high, letter=2.5, anchor="middle", turn_deg=90.0)
            y += high


GOST_FORM = Form(
    "gost",
    "FORM_1",
    LEFT_MARGIN_MM,
    edge=EDGE_MARGIN_MM,
    block=TITLE_BLOCK_SIZE_MM,
    top_cell=TOP_CELL_SIZE_MM,
    lines=form_lines,
    words=printed_words,
    cells=fill_in_cells,
)
