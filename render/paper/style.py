"""The appearance of marks: pens, letter heights and sizes of symbols, in mm of paper (ГОСТ 2.303, 2.304).

Nothing here is ever scaled by a plan's μ.  A mark names its style; this table turns the name into a pen.
"""

from contextlib import AbstractContextManager
from contextvars import ContextVar
from functools import lru_cache
from typing import get_args

from planes.drafting.pens import MEDIUM, SHAPES, THICK, THIN
from planes.words.frozen import frozen, replace
from render.paper.marks import Layer, Polyline, within

LARGER = {2.5: 3.5, 3.5: 5.0, 5.0: 7.0}
"""Letter heights of ГОСТ 2.304, mm, by the next smaller one."""
_large = ContextVar("large", default=False)

BLACK = "#000000"
PAPER = "#ffffff"


@frozen
class Pen:
    """A line type: ``width`` in mm, ``pattern`` of dashes and gaps in mm (none: a solid line), colour."""

    width: float
    pattern: tuple[float, ...] = ()
    colour: str = BLACK


PENS = {
    "thick": Pen(THICK.pen),
    "result": Pen(THICK.pen),
    "frame": Pen(THICK.pen),
    "vector": Pen(MEDIUM.pen),  # a force, or a component of a result
    "rule": Pen(MEDIUM.pen),  # under the head of a table
    "thin": Pen(THIN.pen),
    "axis": Pen(THIN.pen, (10.0, 1.4, 0.6, 1.4)),
    "phantom": Pen(THIN.pen, (10.0, 1.4, 0.6, 1.4, 0.6, 1.4)),
    "dash": Pen(THIN.pen, (4.0, 1.5)),
    "construction": Pen(THIN.pen),
}

REPORT_PENS = {
    "own": Pen(0.4, (), "#163a70"),
    "truth": Pen(0.3, (3.0, 1.5), "#1f7a3d"),
    "next": Pen(0.25, (0.8, 0.8), "#a35c00"),
    "wrong": Pen(0.5, (), "#b3201a"),
    "follows": Pen(0.3, (), "#a35c00"),
}
"""Lines of the report on a checked drawing, in the colours of its page; each is recognisable without them too."""

LAYERS: tuple[Layer, ...] = get_args(Layer)
"""The layers from the lowest to the topmost."""

CAPITALS = 0.729  # of the text behind the strokes (DejaVu Sans): height of capitals over the font size

LETTER_GAP = 0.2  # clear distance of letters over their height
WORD_GAP = 0.6  # clear distance of words over their height
INDEX_SIZE = 0.7  # height of an index over the letter height: 5 -> 3.5 -> 2.5
LEAST_MM = 1.8  # the smallest letters of ГОСТ 2.304: no index is smaller, unless its base is
INDEX_DROP = 0.32  # distance of a lower index below the base line, over the letter height
INDEX_RISE = 0.6  # distance of an upper index above it, over the letter height
INDEX_GAP = 0.12  # clear distance of an index from its base, over the letter height

SHORTEST = 0.51  # of the usual length: the pattern of a line with two dashes

HINGE_MM = 1.5  # radius of a hinge
DOT_MM = 0.8  # radius of a mass centre or a marked point
BLOCK_MM = (11.0, 6.5)  # a slider, along and across its guide
SMALL_MM = (8.0, 4.6)  # a slider held inside another one
LARGE_MM = (14.0, 10.5)  # the one that holds it
LEG_MM = 6.5  # from a fixed hinge down to its base line
BASE_MM = 11.0  # length of that base line
HATCH_MM = 2.2  # depth of the hatching under a base line
HATCH_GAP_MM = 1.6  # between its strokes
WHEEL_MM = 0.9  # radius of a roller's wheels
WALL_MM = 14.0  # of a clamp
ROUND_MM = 26.0  # of a circular guide on each side of its slider, along it
ROUND_HATCH_MM, ROUND_GAP_MM = 3.0, 2.4  # of its hatching


def large() -> bool:
    """Whether figures are drawn for a large format, to be read from farther away."""
    return _large.get()


def tall(mm: float) -> float:
    """The height of letters in figures that have this height on usual formats."""
    return LARGER[mm] if large() else mm


def lettered_for(large: bool) -> AbstractContextManager[None]:
    """In this context figures are drawn for a ``large`` format, or a usual one."""
    return within(_large, large)


@lru_cache
def pen(style: str) -> Pen:
    """The pen of a style, "vector" or coloured "vector #0072B2"; an unknown name is an error that lists the valid
    ones."""
    name, _, colour = style.partition(" ")
    known = PENS.get(name) or REPORT_PENS.get(name)
    if known is None:
        raise ValueError(f"there is no line style {style!r}; use one of {', '.join(PENS)}")
    return replace(known, colour=colour) if colour else known


_WEIGHTS = (5, 9, 13, 15, 18, 20, 25, 30, 35, 40, 50, 53, 60, 70, 80, 90, 100, 106, 120, 140, 158, 200, 211)


def weight(width: float) -> int:
    """The DXF line weight nearest to a width in mm: in hundredths of a mm, of the values in the format."""
    return min(_WEIGHTS, key=lambda w: abs(w - 100 * width))


def fitted(pattern: tuple[float, ...], length_mm: float, closed: bool = False) -> tuple[float, ...]:
    """The pattern stretched so that a line of that length begins and ends with a whole dash.

    Between two dashes it shrinks to no less than ``SHORTEST``; a line too short for that is solid, as small centre
    lines are drawn (a chain under 12 mm).
    """
    if not pattern:
        return ()
    period, ends = sum(pattern), 0.0 if closed else pattern[0]
    stretch = length_mm / (max(1, round((length_mm - ends) / period)) * period + ends)
    return tuple(part * stretch for part in pattern) if stretch > SHORTEST else ()


def head_size(length_mm: float, width_mm: float) -> tuple[float, float]:
    """Length and width in mm of the head of an arrow of that length, with the pen nearest in width; zeros: none."""
    shape = min(SHAPES, key=lambda one: abs(one.pen - width_mm)).on(length_mm)
    return (shape.long, shape.wide) if shape else (0.0, 0.0)


def head(tip: complex, direction: complex, long: float, wide: float) -> Polyline:
    """An arrowhead: tip and the two corners behind it, in mm."""
    along = direction / abs(direction)
    back = tip - long * along
    return tip, back + 0.5j * wide * along, back - 0.5j * wide * along
