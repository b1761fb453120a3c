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

from planes.words import Lang, table
from planes.words.records import Json
from render.paper import form1
from render.paper.form1 import Cell, Form, Segment, Size, cells_of, lines_of

LEFT, EDGE, BORDER = 20.0, 10.0, 5.0
BLOCK = (180.0, 36.0)
FIELD_MM = 50.0
WITHIN_MM = 5.0  # how far a centring mark, 10 mm long in all, extends into the drawing space
LETTERS = string.ascii_uppercase.replace("I", "").replace("O", "")
ONE_SIDED = 300.0  # sheets up to this length have fields only above and at the right

_FORM: Json = json.loads(Path(__file__).with_name("iso7200.json").read_text("utf-8"))


def lines(size: Size) -> Iterator[Segment]:
    """Every line except the frame itself, on a sheet of that width × height."""
    yield from lines_of(_FORM, _corner(size))
    wide, high = size
    outer = [complex(LEFT - BORDER, BORDER), complex(wide - BORDER, BORDER)]
    outer += [complex(wide - BORDER, high - BORDER), complex(LEFT - BORDER, high - BORDER)]
    for a, b in pairwise((*outer, outer[0])):
        yield a, b, "thin"
    for upright, at, out in _sides(size):
        for place in _bounds(size[upright], *_ends(size, upright))[1:-1]:
            yield _place(upright, place, at), _place(upright, place, at + out * BORDER), "thin"
    for upright, at, out in _sides(size, marks=True):
        middle = size[upright] / 2
        yield _place(upright, middle, at - out * WITHIN_MM), _place(upright, middle, at + out * BORDER), "thick"


def _corner(size: Size) -> Size:
    """The lower left corner of the title block."""
    return size[0] - EDGE - BLOCK[0], EDGE


def _sides(size: Size, marks: bool = False) -> Iterator[tuple[bool, float, int]]:
    """The sides of the frame: whether vertical, where, and the outward direction; the last two not on a small sheet."""
    yield False, size[1] - EDGE, 1
    yield True, size[0] - EDGE, 1
    if marks or max(size) > ONE_SIDED:
        yield False, EDGE, -1
        yield True, LEFT, -1


def _place(upright: bool, along: float, at: float) -> complex:
    return complex(at, along) if upright else complex(along, at)


def _ends(size: Size, upright: bool) -> tuple[float, float]:
    """The ends of a side of the frame."""
    return (EDGE, size[1] - EDGE) if upright else (LEFT, size[0] - EDGE)


def _bounds(side: float, low: float, high: float) -> list[float]:
    """Bounds of the fields along a side of the sheet of that length, from the low end of the frame to the high one."""
    count = round(side / 2 / FIELD_MM)  # in each half
    return [low, *(side / 2 + k * FIELD_MM for k in range(1 - count, count)), high]


def words(size: Size, lang: Lang) -> Iterator[tuple[str, Cell]]:
    """Names of the fields of the title block and of the grid, each with its cell."""
    texts = table(lang, "form1")
    for key, cell in cells_of(_FORM["words"], _corner(size)):
        yield texts[f"iso_{key}"], cell
    for upright, at, out in _sides(size):
        bounds = _bounds(size[upright], *_ends(size, upright))
        names = LETTERS[len(bounds) - 2 :: -1] if upright else map(str, range(1, len(bounds)))
        for name, (a, b) in zip(names, pairwise(bounds), strict=True):
            corner = _place(upright, a, min(at, at + out * BORDER))
            wide, high = (BORDER, b - a) if upright else (b - a, BORDER)
            yield name, Cell(corner.real, corner.imag, wide, high, 3.5)


def cells(size: Size) -> dict[str, Cell]:
    """The cells to fill in, by name, on a sheet of that width × height."""
    return {key: cell for part in ("cells", "cells_beneath") for key, cell in cells_of(_FORM[part], _corner(size))}


FORM = Form("iso", "ISO_7200", LEFT, edge=EDGE, block=BLOCK, top_cell=None, lines=lines, words=words, cells=cells)
FORMS = {form.name: form for form in (form1.FORM, FORM)}
