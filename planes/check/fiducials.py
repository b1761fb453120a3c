"""Corner marks of a blank: four black squares with a 5×5 pattern each, and where they stand on the sheet.

The patterns are this project's own; they need no library to print, and OpenCV's marker detector to read.
"""

from __future__ import annotations

ARM_MM = 2.0  # of the cross printed at the pole
SIDE_MM = 12.0  # of the black square, its border included
INSET_MM = (30.0, 15.0)  # centres from the left and the other edges of a sheet
# rows of 5 bits, 1 is white; no turn of one is nearer than 10 bits to another or to a turn of itself
PATTERNS = (
    (0b11001, 0b11000, 0b01011, 0b00000, 0b11000),
    (0b10110, 0b01110, 0b01110, 0b00100, 0b10100),
    (0b11000, 0b01101, 0b10010, 0b00110, 0b11011),
    (0b00000, 0b10110, 0b00101, 0b11010, 0b01001),
)
CELLS = 7  # five bits and a black border on each side


def centres(size_mm: tuple[float, float]) -> tuple[complex, complex, complex, complex]:
    """Lower left, lower right, upper right, upper left, mm of the sheet, y up."""
    (left, other), (w, h) = INSET_MM, size_mm
    return (complex(left, other), complex(w - other, other), complex(w - other, h - other), complex(left, h - other))


def cells(index: int) -> list[list[bool]]:
    """Black cells of a mark, 7 × 7, the top row first."""
    inner = [[True, *(not bits >> (4 - c) & 1 for c in range(5)), True] for bits in PATTERNS[index]]
    return [[True] * CELLS, *inner, [True] * CELLS]


SHEET_MM = (297.0, 210.0)  # A4, lying


def pole_place(ends: list[complex], size_mm: tuple[float, float] = SHEET_MM) -> complex:
    """Where a blank has its pole so that the plan has room: the plan's box in the middle, on whole centimetres."""
    xs, ys = [0.0, *(z.real for z in ends)], [0.0, *(z.imag for z in ends)]
    middle = complex(max(xs) + min(xs), max(ys) + min(ys)) / 2
    place = complex(size_mm[0] / 2 + 5, size_mm[1] / 2) - middle
    return complex(10 * round(place.real / 10), 10 * round(place.imag / 10))
