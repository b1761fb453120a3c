"""A blank to draw a plan on: corner marks for the camera, the student's code, frame, pole, μ, title, a line for the
name, a ruler."""

from collections.abc import Iterable, Sequence
from itertools import groupby

from render.paper.marks import Line, Mark, Shape, Text
from render.paper.typeset import ink_width, wrap_text
from render.sheet.check_sheet import EDGE_MARGIN_MM, LEFT_MARGIN_MM, SMALL_LETTER_MM
from render.sheet.frame import frame_line

RULER_LENGTH_MM, RULER_LEFT_MM = 100, 11.0  # its distance from the left edge
# letters: the plan's name, the other lines, the smallest
PLAN_NAME_LETTER_MM = 5.0
LINE_LETTER_MM = 3.5
LEAST_LETTER_MM = 2.5
# left edge of the lines; the first from the upper edge; line spacing
TEXT_LEFT_MM = 38.0
FIRST_LINE_FROM_TOP_MM = 14.0
LINE_SPACING_MM = 7.5
# the data: their last line, the spacing, the right edge
DATA_LAST_LINE_MM = 7.2
DATA_LINE_SPACING_MM = 4.2
DATA_RIGHT_MARGIN_MM = 24.0
# width of a line beside the code; both ends of the line for a name
LINE_WIDTH_MM = 200.0
NAME_LINE_ENDS_MM = (162.0, 236.0)
Square = tuple[complex, Sequence[Sequence[bool]], float]  # its centre, black cells from the top row, its side in mm


def blank_sheet_marks(
    size_mm: tuple[float, float],
    squares: Iterable[Square],
    pole: tuple[str, complex],
    texts: Sequence[str],
    size: str,
    fields: Sequence[str] = (),
    given: Sequence[str] = (),
) -> list[Mark]:
    """The marks of a blank: ``pole`` its letter and place, ``size`` the text of its ruler, ``fields`` to fill in by
    hand, ``given`` the data beneath the plan, between the lower corner marks."""
    w, h = size_mm
    out: list[Mark] = [frame_line((LEFT_MARGIN_MM, EDGE_MARGIN_MM, w - EDGE_MARGIN_MM, h - EDGE_MARGIN_MM), "thin")]
    for centre, cells, side in squares:
        out += corner_mark_boxes(centre, cells, side)
    letter, at = pole
    out += [Line((at - d, at + d), "thin", "plan") for d in (2 + 0j, 2j)]
    out.append(Text(letter, at + complex(-5, -6), PLAN_NAME_LETTER_MM, name=letter))
    room = NAME_LINE_ENDS_MM[0] - 4 - TEXT_LEFT_MM if fields else LINE_WIDTH_MM
    for k, (line, height) in enumerate(_lines_with_heights(texts, room)):
        out.append(Text(line, complex(TEXT_LEFT_MM, h - FIRST_LINE_FROM_TOP_MM - LINE_SPACING_MM * k), height))
    for k, name in enumerate(fields):
        out += _fill_in_field(name, h - FIRST_LINE_FROM_TOP_MM - LINE_SPACING_MM * k)
    lines = wrap_text(given, w - TEXT_LEFT_MM - DATA_RIGHT_MARGIN_MM, LEAST_LETTER_MM)
    for k, line in enumerate(reversed(lines)):
        out.append(Text(line, complex(TEXT_LEFT_MM, DATA_LAST_LINE_MM + DATA_LINE_SPACING_MM * k), LEAST_LETTER_MM))
    return out + _ruler_marks(complex(RULER_LEFT_MM, (h - RULER_LENGTH_MM) / 2), size)


def _lines_with_heights(texts: Sequence[str], room: float) -> list[tuple[str, float]]:
    """Lines of text with their letter heights: the first one smaller if it is long, the others wrapped."""
    first, *more = texts
    letter = next((mm for mm in (PLAN_NAME_LETTER_MM, LINE_LETTER_MM) if ink_width(first, mm) <= room), LEAST_LETTER_MM)
    return [
        (first, letter),
        *((line, LINE_LETTER_MM) for text in more for line in wrap_text(text, room, LINE_LETTER_MM)),
    ]


def _fill_in_field(name: str, y: float) -> list[Mark]:
    """A line to write on, and its label. It is beside the title, outside the searched area."""
    begins = NAME_LINE_ENDS_MM[0] + ink_width(name, LINE_LETTER_MM) + 2
    line = Line((complex(begins, y - 0.6), complex(NAME_LINE_ENDS_MM[1], y - 0.6)), "thin", "text")
    return [Text(name, complex(NAME_LINE_ENDS_MM[0], y), LINE_LETTER_MM), line]


def _ruler_marks(low: complex, size: str) -> list[Mark]:
    """A length to check with a ruler, in the margin, where nobody draws."""
    ticks = [low + 1j * mm for mm in range(0, RULER_LENGTH_MM + 1, 10)]
    lines = [(low, ticks[-1]), *((z, z - 2.5) for z in ticks)]
    text = Text(size, low + complex(-3.4, RULER_LENGTH_MM / 2), SMALL_LETTER_MM, "middle", 90.0)
    return [*(Line(line, "thin", "plan") for line in lines), text]


def corner_mark_boxes(centre: complex, cells: Sequence[Sequence[bool]], side: float) -> list[Mark]:
    """A corner mark as runs of black cells."""
    step = side / len(cells)
    corner = centre + complex(-side, side) / 2
    out = list[Mark]()
    for r, row in enumerate(cells):
        for black, run in groupby(range(len(row)), key=row.__getitem__):
            if black:
                first, *more = run
                out.append(_black_box(corner + complex(first * step, -(r + 1) * step), (1 + len(more)) * step, step))
    return out


def _black_box(z: complex, width: float, height: float) -> Shape:
    over = 0.02  # to avoid a white hairline between two boxes
    return Shape((z - 1j * over, z + width - 1j * over, z + complex(width, height), z + 1j * height), "frame")
