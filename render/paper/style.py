"""The appearance of marks: pens, letter heights and sizes of symbols, in mm of paper (ГОСТ 2.303, 2.304).

Nothing here is ever scaled by a plan's μ.  A mark names its style; this table turns the name into a pen.
"""

from contextlib import AbstractContextManager
from contextvars import ContextVar
from functools import lru_cache
from typing import get_args

from planes.drafting.pens import HEAD_SHAPES, MEDIUM_PEN_HEAD, THICK_PEN_HEAD, THIN_PEN_HEAD
from planes.words.frozen import frozen, replace
from render.paper.marks import Layer, Polyline, using_setting

NEXT_LARGER_LETTER_MM = {2.5: 3.5, 3.5: 5.0, 5.0: 7.0}
"""Letter heights of ГОСТ 2.304, mm, by the next smaller one."""
_large = ContextVar("large", default=False)

BLACK_COLOUR = "#000000"
PAPER_COLOUR = "#ffffff"


@frozen
class Pen:
    """A line type: ``width`` in mm, ``pattern`` of dashes and gaps in mm (none: a solid line), colour."""

    width: float
    pattern: tuple[float, ...] = ()
    colour: str = BLACK_COLOUR


PEN_BY_STYLE = {
    "thick": Pen(THICK_PEN_HEAD.pen),
    "result": Pen(THICK_PEN_HEAD.pen),
    "frame": Pen(THICK_PEN_HEAD.pen),
    "vector": Pen(MEDIUM_PEN_HEAD.pen),  # a force, or a component of a result
    "rule": Pen(MEDIUM_PEN_HEAD.pen),  # under the head of a table
    "thin": Pen(THIN_PEN_HEAD.pen),
    "axis": Pen(THIN_PEN_HEAD.pen, (10.0, 1.4, 0.6, 1.4)),
    "phantom": Pen(THIN_PEN_HEAD.pen, (10.0, 1.4, 0.6, 1.4, 0.6, 1.4)),
    "dash": Pen(THIN_PEN_HEAD.pen, (4.0, 1.5)),
    "construction": Pen(THIN_PEN_HEAD.pen),
}

REPORT_PEN_BY_STYLE = {
    "own": Pen(0.4, (), "#163a70"),
    "truth": Pen(0.3, (3.0, 1.5), "#1f7a3d"),
    "next": Pen(0.25, (0.8, 0.8), "#a35c00"),
    "wrong": Pen(0.5, (), "#b3201a"),
    "follows": Pen(0.3, (), "#a35c00"),
}
"""Lines of the report on a checked drawing, in the colours of its page; each is recognisable without them too."""

LAYERS_FROM_LOWEST: tuple[Layer, ...] = get_args(Layer)
"""The layers from the lowest to the topmost."""

CAPITALS_HEIGHT_RATIO = 0.729  # of the text behind the strokes (DejaVu Sans): height of capitals over the font size

LETTER_GAP_RATIO = 0.2  # clear distance of letters over their height
WORD_GAP_RATIO = 0.6  # clear distance of words over their height
INDEX_HEIGHT_RATIO = 0.7  # height of an index over the letter height: 5 -> 3.5 -> 2.5
LEAST_LETTER_MM = 1.8  # the smallest letters of ГОСТ 2.304: no index is smaller, unless its base is
INDEX_DROP_RATIO = 0.32  # distance of a lower index below the base line, over the letter height
INDEX_RISE_RATIO = 0.6  # distance of an upper index above it, over the letter height
INDEX_GAP_RATIO = 0.12  # clear distance of an index from its base, over the letter height

LEAST_PATTERN_STRETCH = 0.51  # of the usual length: the pattern of a line with two dashes

HINGE_RADIUS_MM = 1.5  # radius of a hinge
DOT_RADIUS_MM = 0.8  # radius of a mass centre or a marked point
SLIDER_BLOCK_SIZE_MM = (11.0, 6.5)  # a slider, along and across its guide
INNER_BLOCK_SIZE_MM = (8.0, 4.6)  # a slider held inside another one
OUTER_BLOCK_SIZE_MM = (14.0, 10.5)  # the one that holds it
HINGE_LEG_LENGTH_MM = 6.5  # from a fixed hinge down to its base line
BASE_LINE_LENGTH_MM = 11.0  # length of that base line
BASE_HATCHING_DEPTH_MM = 2.2  # depth of the hatching under a base line
BASE_HATCH_SPACING_MM = 1.6  # between its strokes
WHEEL_RADIUS_MM = 0.9  # radius of a roller's wheels
CLAMP_WALL_LENGTH_MM = 14.0  # of a clamp
HALF_ROUND_GUIDE_LENGTH_MM = 26.0  # of a circular guide on each side of its slider, along it
ROUND_HATCHING_DEPTH_MM = 3.0  # of its hatching
ROUND_HATCH_SPACING_MM = 2.4


def is_large_format() -> bool:
    """Whether figures are drawn for a large format, to be read from farther away."""
    return _large.get()


def figure_letter_height(mm: float) -> float:
    """The height of letters in figures that have this height on usual formats."""
    return NEXT_LARGER_LETTER_MM[mm] if is_large_format() else mm


def using_large_format(large: bool) -> AbstractContextManager[None]:
    """In this context figures are drawn for a ``large`` format, or a usual one."""
    return using_setting(_large, large)


@lru_cache
def pen_of_style(style: str) -> Pen:
    """The pen of a style, "vector" or coloured "vector #0072B2"; an unknown name is an error that lists the valid
    ones."""
    name, _, colour = style.partition(" ")
    known = PEN_BY_STYLE.get(name) or REPORT_PEN_BY_STYLE.get(name)
    if known is None:
        raise ValueError(f"there is no line style {style!r}; use one of {', '.join(PEN_BY_STYLE)}")
    return replace(known, colour=colour) if colour else known


_DXF_LINE_WEIGHTS = (5, 9, 13, 15, 18, 20, 25, 30, 35, 40, 50, 53, 60, 70, 80, 90, 100, 106, 120, 140, 158, 200, 211)


def dxf_line_weight(width: float) -> int:
    """The DXF line weight nearest to a width in mm: in hundredths of a mm, of the values in the format."""
    return min(_DXF_LINE_WEIGHTS, key=lambda w: abs(w - 100 * width))


def fit_dash_pattern(pattern: tuple[float, ...], length_mm: float, closed: bool = False) -> tuple[float, ...]:
    """The pattern stretched so that a line of that length begins and ends with a whole dash.

    Between two dashes it shrinks to no less than ``SHORTEST``; a line too short for that is solid, as small centre
    lines are drawn (a chain under 12 mm).
    """
    if not pattern:
        return ()
    period = sum(pattern)
    ends = 0.0 if closed else pattern[0]
    stretch = length_mm / (max(1, round((length_mm - ends) / period)) * period + ends)
    if stretch > LEAST_PATTERN_STRETCH:
        return tuple(part * stretch for part in pattern)
    return ()


def arrowhead_size(length_mm: float, width_mm: float) -> tuple[float, float]:
    """Length and width in mm of the head of an arrow of that length, with the pen nearest in width; zeros: none."""
    shape = min(HEAD_SHAPES, key=lambda one: abs(one.pen - width_mm)).head_for_length(length_mm)
    return (shape.long, shape.wide) if shape else (0.0, 0.0)


def arrowhead_corners(tip: complex, direction: complex, long: float, wide: float) -> Polyline:
    """An arrowhead: tip and the two corners behind it, in mm."""
    along = direction / abs(direction)
    back = tip - long * along
    return tip, back + 0.5j * wide * along, back - 0.5j * wide * along
