"""A blank to draw a plan on: corner marks for the camera, the student's code, frame, pole, μ, title, a line for the
name, a ruler."""

from collections.abc import Iterable, Sequence
from itertools import groupby

from render.paper.marks import Line, Mark, Shape, Text
from render.paper.typeset import ink_width, wrapped
from render.sheet.check_sheet import EDGE, LEFT, SMALL
from render.sheet.frame import framed

RULER_MM, RULER_X = 100, 11.0  # its distance from the left edge
PLAN_MM, LETTER_MM, LEAST_MM = 5.0, 3.5, 2.5  # letters: the plan's name, the other lines, the smallest
TEXT_X, FIRST_Y, LINE_MM = 38.0, 14.0, 7.5  # left edge of the lines; the first from the upper edge; line spacing
BENEATH_MM, NEXT_MM, BESIDE_MM = 7.2, 4.2, 24.0  # the data: their last line, the spacing, the right edge
ROOM_MM, FIELDS_MM = 200.0, (162.0, 236.0)  # width of a line beside the code; both ends of the line for a name
Square = tuple[complex, Sequence[Sequence[bool]], float]  # its centre, black cells from the top row, its side in mm


def blank(
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
    out: list[Mark] = [framed((LEFT, EDGE, w - EDGE, h - EDGE), "thin")]
    for centre, cells, side in squares:
        out += printed_square(centre, cells, side)
    letter, at = pole
    out += [Line((at - d, at + d), "thin", "plan") for d in (2 + 0j, 2j)]
    out.append(Text(letter, at + complex(-5, -6), PLAN_MM, name=letter))
    room = FIELDS_MM[0] - 4 - TEXT_X if fields else ROOM_MM
    for k, (line, height) in enumerate(_lines(texts, room)):
        out.append(Text(line, complex(TEXT_X, h - FIRST_Y - LINE_MM * k), height))
    for k, name in enumerate(fields):
        out += _field(name, h - FIRST_Y - LINE_MM * k)
    lines = wrapped(given, w - TEXT_X - BESIDE_MM, LEAST_MM)
    for k, line in enumerate(reversed(lines)):
        out.append(Text(line, complex(TEXT_X, BENEATH_MM + NEXT_MM * k), LEAST_MM))
    return out + _ruler(complex(RULER_X, (h - RULER_MM) / 2), size)


def _lines(texts: Sequence[str], room: float) -> list[tuple[str, float]]:
    """Lines of text with their letter heights: the first one smaller if it is long, the others wrapped."""
    first, *more = texts
    letter = next((mm for mm in (PLAN_MM, LETTER_MM) if ink_width(first, mm) <= room), LEAST_MM)
    return [(first, letter), *((line, LETTER_MM) for text in more for line in wrapped(text, room, LETTER_MM))]


def _field(name: str, y: float) -> list[Mark]:
    """A line to write on, and its label. It is beside the title, outside the searched area."""
    begins = FIELDS_MM[0] + ink_width(name, LETTER_MM) + 2
    line = Line((complex(begins, y - 0.6), complex(FIELDS_MM[1], y - 0.6)), "thin", "text")
    return [Text(name, complex(FIELDS_MM[0], y), LETTER_MM), line]


def _ruler(low: complex, size: str) -> list[Mark]:
    """A length to check with a ruler, in the margin, where nobody draws."""
    ticks = [low + 1j * mm for mm in range(0, RULER_MM + 1, 10)]
    lines = [(low, ticks[-1]), *((z, z - 2.5) for z in ticks)]
    text = Text(size, low + complex(-3.4, RULER_MM / 2), SMALL, "middle", 90.0)
    return [*(Line(line, "thin", "plan") for line in lines), text]


def printed_square(centre: complex, cells: Sequence[Sequence[bool]], side: float) -> list[Mark]:
    """A corner mark as runs of black cells."""
    step = side / len(cells)
    corner = centre + complex(-side, side) / 2
    out = list[Mark]()
    for r, row in enumerate(cells):
        for black, run in groupby(range(len(row)), key=row.__getitem__):
            if black:
                first, *more = run
                out.append(_box(corner + complex(first * step, -(r + 1) * step), (1 + len(more)) * step, step))
    return out


def _box(z: complex, width: float, height: float) -> Shape:
    over = 0.02  # to avoid a white hairline between two boxes
    return Shape((z - 1j * over, z + width - 1j * over, z + complex(width, height), z + 1j * height), "frame")
