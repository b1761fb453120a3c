"""Corner marks of a blank: four black squares, each with a 5×5 pattern, and their positions on the sheet.

The patterns are this project's own. Printing them needs no library; reading them needs OpenCV's marker detector.
"""

import math
from collections.abc import Sequence
from itertools import product

MARK_SIDE_MM = 12.0  # side of the black square, with its border
MARK_INSETS_MM = (30.0, 15.0)  # distance of the centres from the left edge and from the other edges of the sheet
# rows of 5 bits, 1 is white; any two patterns, in any rotation, differ in at least 10 bits
MARK_PATTERNS = (
    (0b11001, 0b11000, 0b01011, 0b00000, 0b11000),
    (0b10110, 0b01110, 0b01110, 0b00100, 0b10100),
    (0b11000, 0b01101, 0b10010, 0b00110, 0b11011),
    (0b00000, 0b10110, 0b00101, 0b11010, 0b01001),
)
Size = tuple[float, float]  # width and height
SHEET_MM = (297.0, 210.0)  # A4 landscape
Square = tuple[complex, float]  # centre and half side
MARK_CELLS_PER_SIDE = 7  # five bits plus a black border on each side


def corner_mark_centres(size_mm: Size = SHEET_MM) -> tuple[complex, complex, complex, complex]:
    """The centres, mm on the sheet, y up: lower left, lower right, upper right, upper left."""
    left, other = MARK_INSETS_MM
    w, h = size_mm
    return (complex(left, other), complex(w - other, other), complex(w - other, h - other), complex(left, h - other))


def corner_mark_cells(index: int) -> list[list[bool]]:
    """Black cells of a mark, 7 × 7, top row first."""
    inner = [[True, *(not bits >> (4 - c) & 1 for c in range(5)), True] for bits in MARK_PATTERNS[index]]
    return [[True] * MARK_CELLS_PER_SIDE, *inner, [True] * MARK_CELLS_PER_SIDE]


# margins without any plan; step by which the pole is moved
LEFT_MARGIN_MM = 46.0
OTHER_MARGIN_MM = 13.0
POLE_STEP_MM = 5.0
# side of the square code that identifies the sheet; its distance from the corner mark
CODE_SIDE_MM = 30.0
CODE_GAP_MM = 4.0
MOST_POLE_STEPS = 12  # maximum number of steps of the pole away from printed marks
PRINTED_BORDER_MM = 2.0  # border around printed marks in which no drawing is detected


def code_centre(size_mm: Size = SHEET_MM) -> complex:
    """The centre of the code: left of the upper right corner mark, upper edges aligned."""
    return corner_mark_centres(size_mm)[2] - complex(
        MARK_SIDE_MM / 2 + CODE_GAP_MM + CODE_SIDE_MM / 2, (CODE_SIDE_MM - MARK_SIDE_MM) / 2
    )


def mark_and_code_squares(size_mm: Size = SHEET_MM) -> list[Square]:
    """Printed squares of a sheet, the code last: centre, and half side of the area in which no drawing is detected."""
    return [
        *((z, MARK_SIDE_MM / 2 + PRINTED_BORDER_MM) for z in corner_mark_centres(size_mm)),
        (code_centre(size_mm), CODE_SIDE_MM / 2 + PRINTED_BORDER_MM),
    ]


def is_within_square(z: complex, square: Square, rim: float = 0.0) -> bool:
    """Whether a point lies in a square, or within ``rim`` of it."""
    off = z - square[0]
    return max(abs(off.real), abs(off.imag)) < square[1] + rim


def pole_position(ends: list[complex]) -> complex:
    """The pole of a blank: in the middle, so that a plan has the same room in every direction.

    It is moved only as far as the right plan would otherwise leave the sheet or run under printed marks.
    """
    w, h = SHEET_MM
    places = [0j, *ends]
    across = _shifted_middle((LEFT_MARGIN_MM, w - OTHER_MARGIN_MM), [z.real for z in places])
    start = complex(across, _shifted_middle((OTHER_MARGIN_MM, h - OTHER_MARGIN_MM), [z.imag for z in places]))
    steps = range(-MOST_POLE_STEPS, MOST_POLE_STEPS + 1)
    around = [
        start + POLE_STEP_MM * complex(x, y) for x, y in sorted(product(steps, steps), key=lambda xy: math.hypot(*xy))
    ]
    return next((pole for pole in around if _is_clear_of_print(pole, places)), start)


def has_room(ends: list[complex]) -> bool:
    """Whether a plan with these end points fits on a blank."""
    return _is_clear_of_print(pole_position(ends), [0j, *ends])


def _is_clear_of_print(pole: complex, places: Sequence[complex]) -> bool:
    """Whether points relative to a pole lie on the blank and clear of its printed marks."""
    (w, h), printed, e = SHEET_MM, mark_and_code_squares(), 1e-6

    def free(z: complex) -> bool:
        inside = (
            LEFT_MARGIN_MM - e <= z.real <= w - OTHER_MARGIN_MM + e
            and OTHER_MARGIN_MM - e <= z.imag <= h - OTHER_MARGIN_MM + e
        )
        return inside and not any(is_within_square(z, square, PRINTED_BORDER_MM) for square in printed)

    return all(free(pole + z) for z in places)


def _shifted_middle(room: tuple[float, float], places: list[float]) -> float:
    """The middle of a range, shifted as little as needed to fit all points; points too far apart are centred."""
    low = room[0] - min(places)
    high = room[1] - max(places)
    middle = (room[0] + room[1]) / 2
    if low > high:
        return POLE_STEP_MM * round((low + high) / 2 / POLE_STEP_MM)
    return middle + POLE_STEP_MM * (
        math.ceil(max(low - middle, 0) / POLE_STEP_MM) - math.ceil(max(middle - high, 0) / POLE_STEP_MM)
    )
