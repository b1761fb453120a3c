"""Rejects pictures without a drawing: no paper (noise, a lawn, a brick wall, any uneven photograph) or only text.

Paper is even almost everywhere, even if squared or written on: the dark part of a small square is a small share of it,
and with thin dark strokes filled up, its light changes only slowly.
"""

import numpy

from planes.check.vision.image.opencv import connected_components, cv, filled_square, reduce_to_longest_side
from planes.geometry.arrays import Booleans, Greys

REDUCED_SIDE_PX, SQUARE_PX = 1000, 20
UNEVEN_GREY_SIGMA = 11.0  # σ of the grey levels of a small square
# percentile of its light; darkness of ink below it; maximum share of ink on paper
PAPER_LIGHT_PERCENTILE = 90
INK_GREY_DIFFERENCE = 12
MOST_INK_SHARE = 0.2
RULED_VARIANCE_SHARE = 0.6  # share of a square's variance in its rows and columns, if ruled
MOST_ROUGH_SHARE = 0.6  # of all small squares
WIDEST_FILLED_STROKE_PX = 13  # the widest stroke that is filled up
SMOOTHING_SIGMA_PX = 2.0  # σ of smoothing the grain
# maximum grey gradient per pixel, and share of pixels below it, in an even small square
MOST_GREY_GRADIENT = 1.5
LEAST_FLAT_PIXEL_SHARE = 0.9
# shares of all small squares: even ones on paper, and connected ones
LEAST_EVEN_SHARE = 0.5
LEAST_CONNECTED_SHARE = 0.15
# range of letter heights, in the reduced picture; more letters are a page of text
LETTER_HEIGHT_RANGE_PX = (5, 30)
MOST_LETTERS_ON_DRAWING = 800
SHORTEST_DRAWN_LINE_PX = 45  # a drawing has a longer line (14 mm of A4); touching letters rarely do
LETTER_DARKNESS_SHARE = 0.35  # darkness of letters relative to the darkest of a picture


def shows_paper(grey: Greys) -> bool:
    """Whether enough of a picture is even for it to contain paper."""
    small = reduce_to_longest_side(grey, REDUCED_SIDE_PX)[0]
    h, w = (n // SQUARE_PX for n in small.shape)
    if not h * w:
        return True
    small = small[: h * SQUARE_PX, : w * SQUARE_PX]
    _, parts = connected_components(_evenly_lit_squares(small), neighbours=4)
    even = max(parts[1:, 4].sum() / LEAST_EVEN_SHARE, parts[1:, 4].max(initial=0) / LEAST_CONNECTED_SHARE)
    return bool(even >= h * w) and float(_rough_squares(small).mean()) < MOST_ROUGH_SHARE


def _evenly_lit_squares(small: Greys) -> Booleans:
    """Small squares with slowly changing light, thin dark strokes filled up."""
    cv2 = cv()
    filled = cv2.morphologyEx(small, cv2.MORPH_CLOSE, filled_square(WIDEST_FILLED_STROKE_PX))
    light = cv2.GaussianBlur(filled, (0, 0), SMOOTHING_SIGMA_PX)
    across, down = (cv2.Sobel(light, cv2.CV_32F, *way, scale=1 / 8) for way in ((1, 0), (0, 1)))
    slow: Booleans = (
        _cut_into_squares(cv2.magnitude(across, down) < MOST_GREY_GRADIENT).mean(axis=(1, 3)) >= LEAST_FLAT_PIXEL_SHARE
    )
    return slow


def _rough_squares(small: Greys) -> Booleans:
    """Small squares with a large dark part that is not in lines."""
    cut = _cut_into_squares(small).astype(numpy.float32)
    light = numpy.percentile(cut, PAPER_LIGHT_PERCENTILE, axis=(1, 3), keepdims=True)
    ink = (cut < light - INK_GREY_DIFFERENCE).mean(axis=(1, 3))
    spread = cut.var(axis=(1, 3))
    ruled = cut.mean(axis=1).var(axis=2) + cut.mean(axis=3).var(axis=1)
    rough: Booleans = (spread > UNEVEN_GREY_SIGMA**2) & (ink > MOST_INK_SHARE) & (ruled < RULED_VARIANCE_SHARE * spread)
    return rough


def _cut_into_squares(small: Greys | Booleans) -> Greys | Booleans:
    """A picture as small squares: row of squares, row within, column of squares, column within."""
    h, w = (n // SQUARE_PX for n in small.shape)
    return small.reshape(h, SQUARE_PX, w, SQUARE_PX)


def shows_text_only(grey: Greys) -> bool:
    """Whether letters cover a picture without a single line, however faint, that may belong to a drawing."""
    cv2 = cv()
    small = reduce_to_longest_side(grey, REDUCED_SIDE_PX)[0]
    paper = cv2.dilate(cv2.blur(small, (3, 3)), filled_square(SQUARE_PX))
    dark = cv2.subtract(cv2.blur(paper, (SQUARE_PX, SQUARE_PX)), small)
    letters, drawn = (
        connected_components(dark > least)[1][1:, 2:5]  # width, height and number of pixels of each
        for least in (LETTER_DARKNESS_SHARE * float(numpy.percentile(dark, 99.5)), INK_GREY_DIFFERENCE)
    )
    low, high = LETTER_HEIGHT_RANGE_PX
    of_letters, words = ((low <= parts[:, 1]) & (parts[:, 1] <= high) for parts in (letters, drawn))
    if (of_letters & (letters[:, 2] > low)).sum() <= MOST_LETTERS_ON_DRAWING:
        return False
    lines = drawn[~words, :2]  # seen this faintly, letters of a word touch
    return bool(max(letters[:, :2].max(), lines.max(initial=0)) <= SHORTEST_DRAWN_LINE_PX)
