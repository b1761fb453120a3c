"""Sizes on a scheme: two arrows that part from the middle, lines that lead to what is measured, the size over them."""

import cmath
import math

from render.paper.marks import Arrow, Line, Mark, Text

PAST_MM = 1.5  # of a leading line beyond the arrow
OVER_MM = 0.9  # of the size over the line of its arrows
LETTER_MM = 3.5


def dimension(one: complex, other: complex, off: complex, text: str) -> list[Mark]:
    """The size between two places, drawn so far off, square to it."""
    aside, middle = off / abs(off), (one + other) / 2 + off
    turn = math.degrees(cmath.phase(other - one))
    turn -= 180 * round(turn / 180 - 1e-9)  # read from below or from the right
    up = 1j * cmath.rect(1, math.radians(turn))
    leading = [Line((z + aside, z + off + PAST_MM * aside), "thin", "dimension") for z in (one, other)]
    arrows = [Arrow(middle, z + off, "thin", "dimension") for z in (one, other)]
    return [*leading, *arrows, Text(text, middle + OVER_MM * up, LETTER_MM, "middle", turn, "dimension", "size")]
