"""Pens and arrowheads of a drawn plan, mm of paper: used to draw a sheet and to find lines on a print."""

from typing import NamedTuple

LONGEST_HEADLESS_ARROW_MM = 1.2  # an arrow shorter than this has no head
LEAST_HEAD_LENGTH_RATIO = 1.7  # length of the head on a short arrow, over the width of its pen


class HeadShape(NamedTuple):
    """A filled head on a line of a pen, mm."""

    long: float
    wide: float
    pen: float

    def head_for_length(self, length_mm: float) -> "HeadShape | None":
        """The head of an arrow of that length: at most half of it, so that some of the shaft shows; None on a very
        short arrow."""
        if length_mm < LONGEST_HEADLESS_ARROW_MM:
            return None
        shrink = min(1.0, 0.5 * length_mm / self.long)
        return HeadShape(
            self.long * shrink, max(self.wide * shrink, min(self.wide, LEAST_HEAD_LENGTH_RATIO * self.pen)), self.pen
        )


THICK_PEN_HEAD = HeadShape(5.0, 1.6, 0.6)
"""Links and the results of a plan: the main line s of ГОСТ 2.303."""
MEDIUM_PEN_HEAD = HeadShape(4.5, 1.0, 0.35)
"""Forces, and the components of a result."""
THIN_PEN_HEAD = HeadShape(3.0, 0.8, 0.2)
"""Auxiliary lines: construction, arms, leaders, tables, hatching; s/3, the least that ГОСТ 2.303 allows."""
HEAD_SHAPES = (THICK_PEN_HEAD, MEDIUM_PEN_HEAD, THIN_PEN_HEAD)
