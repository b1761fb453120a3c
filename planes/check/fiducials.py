"""Corner marks of a blank: four black squares, each with a 5×5 pattern, and their positions on the sheet.

The patterns are this project's own. Printing them needs no library; reading them needs OpenCV's marker detector.
"""

import math
from collections.abc import Sequence
from itertools import product

SIDE_MM = 12.0  # side of the black square, with its border
INSET_MM = (30.0, 15.0)  # distance of the centres from the left edge and from the other edges of the sheet
# rows of 5 bits, 1 is white; any two patterns, in any rotation, differ in at least 10 bits
PATTERNS = (
    (0b11001, 0b11000, 0b01011, 0b00000, 0b11000),
    (0b10110, 0b01110, 0b01110, 0b00100, 0b10100),
    (0b11000, 0b01101, 0b10010, 0b00110, 0b11011),
    (0b00000, 0b10110, 0b00101, 0b11010, 0b01001),
)
Square = tuple[complex, float]  # centre and half side
CELLS = 7  # five bits plus a black border on each side


def centres(size_mm: tuple[float, float]) -> tuple[complex, complex, complex, complex]:
    """The centres, mm on the sheet, y up: lower left, lower right, upper right, upper left."""
    (left, other), (w, h) = INSET_MM, size_mm
    return (complex(left, other), complex(w - other, other), complex(w - other, h - other), complex(left, h - other))


def cells(index: int) -> list[list[bool]]:
    """Black cells of a mark, 7 × 7, top row first."""
    inner = [[True, *(not bits >> (4 - c) & 1 for c in range(5)), True] for bits in PATTERNS[index]]
    return [[True] * CELLS, *inner, [True] * CELLS]


SHEET_MM = (297.0, 210.0)  # A4 landscape
LEFT_MM, OTHER_MM, STEP_MM = 46.0, 13.0, 5.0  # margins without any plan; step by which the pole is moved
CODE_MM, CODE_GAP_MM = 30.0, 4.0  # side of the square code that identifies the sheet; its distance from the corner mark
MOST_STEPS = 12  # maximum number of steps of the pole away from printed marks
RIM_MM = 2.0  # border around printed marks in which no drawing is detected


def code_centre(size_mm: tuple[float, float] = SHEET_MM) -> complex:
    """The centre of the code: left of the upper right corner mark, upper edges aligned."""
    return centres(size_mm)[2] - complex(SIDE_MM / 2 + CODE_GAP_MM + CODE_MM / 2, (CODE_MM - SIDE_MM) / 2)


def squares(size_mm: tuple[float, float] = SHEET_MM) -> list[Square]:
    """Printed squares of a sheet, the code last: centre, and half side of the area in which no drawing is detected."""
    return [*((z, SIDE_MM / 2 + RIM_MM) for z in centres(size_mm)), (code_centre(size_mm), CODE_MM / 2 + RIM_MM)]


def within(z: complex, square: Square, rim: float = 0.0) -> bool:
    """Whether a point lies in a square, or within ``rim`` of it."""
    off = z - square[0]
    return max(abs(off.real), abs(off.imag)) < square[1] + rim


def pole_place(ends: list[complex]) -> complex:
    """The pole of a blank: in the middle, so that a plan has the same room in every direction.

    It is moved only as far as the right plan would otherwise leave the sheet or run under printed marks.
    """
    (w, h), places = SHEET_MM, [0j, *ends]
    across = _moved((LEFT_MM, w - OTHER_MM), [z.real for z in places])
    start = complex(across, _moved((OTHER_MM, h - OTHER_MM), [z.imag for z in places]))
    steps = range(-MOST_STEPS, MOST_STEPS + 1)
    around = [start + STEP_MM * complex(x, y) for x, y in sorted(product(steps, steps), key=lambda xy: math.hypot(*xy))]
    return next((pole for pole in around if _clear(pole, places)), start)


def has_room(ends: list[complex]) -> bool:
    """Whether a plan with these end points fits on a blank."""
    return _clear(pole_place(ends), [0j, *ends])


def _clear(pole: complex, places: Sequence[complex]) -> bool:
    """Whether points relative to a pole lie on the blank and clear of its printed marks."""
    (w, h), printed, e = SHEET_MM, squares(), 1e-6

    def free(z: complex) -> bool:
        inside = LEFT_MM - e <= z.real <= w - OTHER_MM + e and OTHER_MM - e <= z.imag <= h - OTHER_MM + e
        return inside and not any(within(z, square, RIM_MM) for square in printed)

    return all(free(pole + z) for z in places)


def _moved(room: tuple[float, float], places: list[float]) -> float:
    """The middle of a range, shifted as little as needed to fit all points; points too far apart are centred."""
    low, high = room[0] - min(places), room[1] - max(places)
    middle = (room[0] + room[1]) / 2
    if low > high:
        return STEP_MM * round((low + high) / 2 / STEP_MM)
    return middle + STEP_MM * (math.ceil(max(low - middle, 0) / STEP_MM) - math.ceil(max(middle - high, 0) / STEP_MM))
