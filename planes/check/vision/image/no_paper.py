"""Pictures that show no paper: noise, a screen full of something, a photograph of anything else, told at a glance.

Paper is even nearly everywhere, squared or written on though it be: what is darker in a small square is a small part
of it. Of 476 pictures of sheets (millimetre paper, dim light, folds) none is uneven so far; noise is in every square.
"""

import numpy

from planes.check.vision.image.picture import smaller
from planes.geometry.arrays import Greys

LOOK_PX, SQUARE_PX = 1000, 20
UNEVEN = 11.0  # σ of the grey levels of a small square
LIGHT, DARKER, INK = 90, 12, 0.2  # its light is this percentile; what is so much darker is ink; paper has less of it
STRAIGHT = 0.6  # of the variance of a square, what its rows and columns have that are ruled
SHARE = 0.6  # of all small squares


def shows_paper(grey: Greys) -> bool:
    """Whether so much of a picture is even that there may be paper on it."""
    small = smaller(grey, LOOK_PX)[0]
    h, w = (n // SQUARE_PX for n in small.shape)
    cut = small[: h * SQUARE_PX, : w * SQUARE_PX].reshape(h, SQUARE_PX, w, SQUARE_PX).astype(numpy.float32)
    if not cut.size:
        return True
    light = numpy.percentile(cut, LIGHT, axis=(1, 3), keepdims=True)
    ink, spread = (cut < light - DARKER).mean(axis=(1, 3)), cut.var(axis=(1, 3))
    ruled = cut.mean(axis=1).var(axis=2) + cut.mean(axis=3).var(axis=1)
    uneven = (spread > UNEVEN**2) & (ink > INK) & (ruled < STRAIGHT * spread)
    return float(uneven.mean()) < SHARE
