"""What it costs to believe in a place of a mark, or in a mistake, where ink costs half of one for a millimetre."""

import math

from planes.check.grading.handwork import Miss

GATE = 4.5  # σ of drafting and reading within which a mark is looked for
NO_MARK, NO_END, NO_LINE = 9.0, 3.0, 5.0  # what a mark costs that is nowhere, where nothing ends, where no line leads
WRONG, SLIP, ANYWHERE = 0.5, 2.0, 11.0  # the odds of a mistake; the least one of the catalogue costs; a mark anywhere
VAGUE = 3.0  # what a place costs that is known to a millimetre
DOUBTFUL = 3.0  # what a place costs whose line is better known to end elsewhere


def slip(count: int) -> float:
    """What each of some mistakes of the catalogue costs: that it is just this one that was made."""
    return max(math.log(max(count, 1) / WRONG), SLIP)


def sigmas_of(off: complex, miss: Miss, sigma: float) -> float:
    """How far off a place is, in σ of drawing and of reading."""
    xx, xy, yy = miss.cov
    return Miss(off, (xx + sigma**2, xy, yy + sigma**2)).sigmas
