"""Pictures that show no drawing, told at a glance: no paper (noise, a screen full of something, a photograph of
anything else), or nothing but text on it.

Paper is even nearly everywhere, squared or written on though it be: what is darker in a small square is a small part
of it. Of 476 pictures of sheets (millimetre paper, dim light, folds) none is uneven so far; noise is in every square.
"""

import numpy

from planes.check.vision.image.picture import cv, smaller
from planes.geometry.arrays import Greys, Indices

LOOK_PX, SQUARE_PX = 1000, 20
UNEVEN = 11.0  # σ of the grey levels of a small square
LIGHT, DARKER, INK = 90, 12, 0.2  # its light is this percentile; what is so much darker is ink; paper has less of it
STRAIGHT = 0.6  # of the variance of a square, what its rows and columns have that are ruled
SHARE = 0.6  # of all small squares
LETTER_PX, LETTERS = (5, 30), 800  # the height of a letter from and to, on the small picture; more are a page of text
LINE_PX = 45  # a drawing has a longer line (14 mm of A4), letters that touch are seldom so long
PRINT = 0.35  # of how dark the darkest of a picture is, are letters


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


def shows_text_only(grey: Greys) -> bool:
    """Whether there are letters all over a picture and not one line, faint though it be, that a drawing might have."""
    cv2, small = cv(), smaller(grey, LOOK_PX)[0]
    paper = cv2.dilate(cv2.blur(small, (3, 3)), numpy.ones((SQUARE_PX, SQUARE_PX), numpy.uint8))
    dark = cv2.subtract(cv2.blur(paper, (SQUARE_PX, SQUARE_PX)), small)
    letters, drawn = (_parts(dark, least) for least in (PRINT * float(numpy.percentile(dark, 99.5)), DARKER))
    low, high = LETTER_PX
    many = int(((letters[:, 1] >= low) & (letters[:, 1] <= high) & (letters[:, 2] > low)).sum()) > LETTERS
    words = (drawn[:, 1] >= low) & (drawn[:, 1] <= high)  # seen so faintly, letters of a word touch
    return many and max(int(letters[:, :2].max()), int((drawn[:, :2].max(axis=1) * ~words).max())) <= LINE_PX


def _parts(dark: Greys, least: float) -> Indices:
    """What hangs together that is so dark: how wide and high it is, and of how many pixels."""
    _, _, parts, _ = cv().connectedComponentsWithStats((dark > least).astype(numpy.uint8), connectivity=8)
    found: Indices = parts[1:, 2:5]
    return found
