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

from planes.words import Lang, table
from planes.words.frozen import frozen, replace
from planes.words.records import Json

LEFT, EDGE = 20.0, 5.0  # margins of the frame: left, all others
BLOCK = (185.0, 55.0)  # the title block
TOP_CELL = (70.0, 14.0)  # graph 26

Segment = tuple[complex, complex, Literal["thick", "thin"]]
Size = tuple[float, float]


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


_FORM: Json = json.loads(Path(__file__).with_name("form1.json").read_text("utf-8"))
"""From the lower left corner of the title block, in mm: lines from x, y to x, y; cells of words and of values, in it
and beneath it. Beside the frame: graphs 19–23 from the lower corner up and 24–25, the last at the upper corner, each
with its height."""
BESIDE: tuple[str, ...] = tuple(key for key, _ in (*_FORM["lower"], *_FORM["upper"]))
"""Graphs 19–25."""
WORD_WIDE, VALUE_WIDE = 5.0, 7.0  # the two columns of graphs 19–25


def prompt(key: str, lang: Lang) -> str:
    """The name of a cell in a prompt, with the number of its graph."""
    words = table(lang, "form1")
    return words.get(f"cell_{key}") or ", ".join(words.get(f"cell_{word}", word) for word in key.split("_"))


def lines(size: Size) -> Iterator[Segment]:
    """Every line of the form except the frame itself, on a sheet of that width × height."""
    yield from lines_of(_FORM, _corner(size))
    for bottom, rows in _strips(size):
        yield from _strip(bottom, [high for _, high in rows])
    top, right = size[1] - EDGE, LEFT + TOP_CELL[0]
    yield complex(LEFT, top - TOP_CELL[1]), complex(right, top - TOP_CELL[1]), "thick"
    yield complex(right, top - TOP_CELL[1]), complex(right, top), "thick"


def lines_of(form: Json, corner: Size) -> Iterator[Segment]:
    """Lines of a title block with its lower left corner there."""
    pens: tuple[Literal["thick", "thin"], ...] = ("thick", "thin")
    for pen in pens:
        for x0, y0, x1, y1 in form[pen]:
            yield complex(*corner) + complex(x0, y0), complex(*corner) + complex(x1, y1), pen


def _corner(size: Size) -> Size:
    """The lower left corner of the title block."""
    return size[0] - EDGE - BLOCK[0], EDGE


def _strips(size: Size) -> tuple[tuple[float, list[tuple[str, float]]], ...]:
    """The start of the lower and the upper column of graphs beside the frame, and their rows."""
    lower, upper = _FORM["lower"], _FORM["upper"]
    return (EDGE, lower), (size[1] - EDGE - sum(high for _, high in upper), upper)


def _strip(bottom: float, heights: list[float]) -> Iterator[Segment]:
    """Lines of a column of graphs beside the frame."""
    left, top = LEFT - WORD_WIDE - VALUE_WIDE, bottom + sum(heights)
    for x in (left, left + WORD_WIDE):
        yield complex(x, bottom), complex(x, top), "thick"
    for k in range(len(heights) + 1):
        y = bottom + sum(heights[:k])
        yield complex(left, y), complex(LEFT, y), "thick"


def words(size: Size, lang: Lang) -> Iterator[tuple[str, Cell]]:
    """The printed words of the form, each with its cell."""
    texts, beside = table(lang, "form1"), _beside(size, LEFT - WORD_WIDE - VALUE_WIDE, WORD_WIDE)
    for key, cell in (
        *cells_of(_FORM["words"], _corner(size)),
        *beside,
        *cells_of(_FORM["words_beneath"], _corner(size)),
    ):
        yield texts[f"form_{key}"], cell


def cells(size: Size) -> dict[str, Cell]:
    """The cells to fill in, by name, on a sheet of that width × height."""
    named_cells = dict(cells_of(_FORM["cells"], _corner(size)))
    for key, cell in _beside(size, LEFT - VALUE_WIDE, VALUE_WIDE):
        named_cells[key] = replace(cell, letter=3.5)
    top = size[1] - EDGE - TOP_CELL[1]
    named_cells["designation_turned"] = Cell(LEFT, top, *TOP_CELL, 7.0, "middle", 180.0)
    return named_cells | dict(cells_of(_FORM["cells_beneath"], _corner(size)))


def cells_of(rows: list[Any], corner: Size) -> Iterator[tuple[str, Cell]]:
    """Cells of a title block with its lower left corner there."""
    for key, x, y, wide, high, *how in rows:
        how_set = dict(zip(("letter", "anchor", "turn_deg"), how, strict=False))
        yield key, Cell(x + corner[0], y + corner[1], wide, high, **how_set)


def _beside(size: Size, x: float, wide: float) -> Iterator[tuple[str, Cell]]:
    """The columns beside the frame: their graphs with cells of one width."""
    for y, rows in _strips(size):
        for key, high in rows:
            yield key, Cell(x, y, wide, height=high, letter=2.5, anchor="middle", turn_deg=90.0)
            y += high


FORM = Form("gost", "FORM_1", LEFT, edge=EDGE, block=BLOCK, top_cell=TOP_CELL, lines=lines, words=words, cells=cells)
