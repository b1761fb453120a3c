"""Rows of letters on a page: adjacent letters with their feet on a line; and the slant of each letter's strokes.

Letters are pieces of ink of similar height. The directions to their neighbours give that of the rows; from there on,
coordinates run along rows (s) and across them (t, downwards).
"""

import math

import numpy

from planes.check.vision.image.opencv import (
    connected_components,
    cv,
    filled_square,
    reduce_to_longest_side,
    resize_by_factor,
)
from planes.geometry.arrays import Array, Booleans, Complexes, Greys, Indices
from planes.words.frozen import frozen

REDUCED_SIDE_PX = 2000  # longer side of the reduced picture
PAPER_LIGHT_WINDOW_PX = 41  # window of the paper's light
# darkness of ink relative to paper in grey levels, and relative to the darkest
LEAST_INK_GREY_DIFFERENCE = 14
LEAST_INK_DARKNESS_SHARE = 0.3
LETTER_HEIGHT_RANGE_PX = (9, 70)  # range of letter heights
LEAST_LETTER_PIXELS = 12  # minimum of pixels
# maximum distance of the next letter, in letters, and ratio of heights
MOST_LETTER_GAP_RATIO = 3.0
MOST_HEIGHT_RATIO = 2.2
LONGEST_LETTER_RATIO = 2.2  # in heights, a longer piece along a row is a dash, no letter
MOST_ROW_SLANT = 0.3  # maximum slant of a row from most others
LEAST_LETTERS_IN_ROW = 7  # minimum number of letters of a row
MOST_LETTERS_ON_PAGE = 1500  # maximum number on a page
BASELINE_TOLERANCE_RATIO = 0.12  # of a letter's height: a foot farther from the line is not on it
MOST_STROKE_SLANT_RAD = math.radians(40)  # a stroke farther from upright is no evidence


@frozen
class TextRow:
    """The baseline of letters: a point and its direction (radians), its accuracy, and the numbers of its letters."""

    place: complex
    angle: float
    error: float
    letters: Indices


@frozen
class LetterRows:
    """Letters in rows: positions (pixels of the picture), heights, stroke edges, and the rows.

    Each stroke edge has its letter, direction in radians and sharpness.
    """

    places: Complexes
    heights: Array
    of: Indices
    angles: Array
    weights: Array
    rows: list[TextRow]
    way: float  # direction of most rows, radians

    @property
    def row_numbers(self) -> Indices:
        """The row number of each letter; -1 for those in none."""
        out = numpy.full(len(self.places), -1)
        for k, row in enumerate(self.rows):
            out[row.letters] = k
        return out


def find_text_rows(grey: Greys) -> LetterRows | None:
    """The rows of letters on a picture; None if there are none."""
    small, factor = reduce_to_longest_side(grey, REDUCED_SIDE_PX)
    labels, boxes = _letter_components(small)
    if len(boxes) < LEAST_LETTERS_IN_ROW:
        return None
    way = _row_direction(boxes)
    if way is None:
        return None
    rows_of_ink, columns = numpy.nonzero(labels)
    label = labels[rows_of_ink, columns] - 1
    z = (columns + 1j * rows_of_ink) * numpy.exp(-1j * way)
    order = numpy.argsort(label, kind="stable")
    starts = numpy.searchsorted(label[order], numpy.arange(len(boxes)))
    (left, right), (low, high) = (
        [f.reduceat(part[order], starts) for f in (numpy.minimum, numpy.maximum)] for part in (z.real, z.imag)
    )
    rows = _chain_rows(left, right, low, high, way)
    if not rows:
        return None
    kept = numpy.unique(numpy.concatenate([row.letters for row in rows]))
    new = numpy.full(len(boxes), -1)
    new[kept] = numpy.arange(len(kept))
    letter_of_edge, angles, weights = _stroke_edges(small, labels, new, way)
    middles = ((left + right) / 2 + 1j * (low + high) / 2) * numpy.exp(1j * way)
    there = (middles[kept] + 0.5 + 0.5j) / factor - 0.5 - 0.5j
    text_rows = [TextRow((r.place + 0.5 + 0.5j) / factor - 0.5 - 0.5j, r.angle, r.error, new[r.letters]) for r in rows]
    return LetterRows(there, (high - low + 1)[kept], letter_of_edge, angles, weights, text_rows, way)


def _letter_components(small: Greys) -> tuple[Indices, Indices]:
    """The pieces of ink as large as letters: the number at each pixel (from 1, 0: none), and their boxes."""
    cv2 = cv()
    wide = PAPER_LIGHT_WINDOW_PX // 4 | 1
    light = cv2.blur(cv2.dilate(resize_by_factor(small, 0.25), filled_square(wide)), (wide, wide))
    dark = cv2.subtract(cv2.resize(light, small.shape[::-1]), cv2.GaussianBlur(small, (3, 3), 0))
    least = max(LEAST_INK_GREY_DIFFERENCE, LEAST_INK_DARKNESS_SHARE * float(numpy.percentile(dark[::4, ::4], 99.7)))
    labels, parts = connected_components(dark > least)
    w, h, area = parts[:, 2:].T
    tall = numpy.maximum(w, h)
    good = (
        (tall >= LETTER_HEIGHT_RANGE_PX[0])
        & (tall <= LETTER_HEIGHT_RANGE_PX[1])
        & (area >= LEAST_LETTER_PIXELS)
        & (numpy.minimum(w, h) > 1)
    )
    good[0] = False
    good[numpy.flatnonzero(good)[MOST_LETTERS_ON_PAGE:]] = False
    return (good.cumsum() * good)[labels], parts[good]


def _row_direction(boxes: Indices) -> float | None:
    """The direction from most letters to their neighbours, in radians; None if there is none."""
    x, y, wide, high, _ = boxes.T
    z = x + wide / 2 + 1j * (y + high / 2)
    tall = numpy.maximum(wide, high).astype(float)
    apart = z - z[:, None]
    near = abs(apart) + 1e9 * (abs(apart) < 1)
    near[(tall > MOST_HEIGHT_RATIO * tall[:, None]) | (tall[:, None] > MOST_HEIGHT_RATIO * tall)] = 1e9
    two = numpy.argsort(near, axis=1)[:, :2]
    rows = numpy.arange(len(z))[:, None]
    good = near[rows, two] < 1.8 * tall[:, None]
    ways = numpy.angle(apart[rows, two])[good]
    if len(ways) < LEAST_LETTERS_IN_ROW:
        return None
    doubled = numpy.exp(2j * ways)
    steps = numpy.linspace(0, math.pi, 90, endpoint=False)
    score = [float(numpy.exp(40 * ((doubled * numpy.exp(-2j * k)).real - 1)).sum()) for k in steps]
    way = float(steps[int(numpy.argmax(score))])
    for _ in range(4):
        w = numpy.exp(60 * ((doubled * numpy.exp(-2j * way)).real - 1))
        way = float(numpy.angle((w * doubled).sum()) / 2)
    return way


def _chain_rows(left: Array, right: Array, low: Array, high: Array, way: float) -> list[TextRow]:
    """Letters chained from neighbour to neighbour, and their baselines."""
    tall = high - low + 1
    t = (low + high) / 2
    usual = numpy.maximum(tall, numpy.median(tall))
    gap = left - right[:, None]
    down = t - t[:, None]
    s = (left + right) / 2
    fits = (s > s[:, None]) & (gap > -0.5 * usual[:, None]) & (gap < MOST_LETTER_GAP_RATIO * usual[:, None])
    fits &= abs(down) < 0.55 * usual[:, None] + MOST_ROW_SLANT * numpy.maximum(gap, 0)
    letter = right - left < LONGEST_LETTER_RATIO * tall
    fits &= letter & letter[:, None]
    fits &= (tall < MOST_HEIGHT_RATIO * tall[:, None]) & (tall[:, None] < MOST_HEIGHT_RATIO * tall)
    cost = numpy.where(fits, numpy.maximum(gap, 0) + 2 * abs(down), numpy.inf)
    after = cost.argmin(axis=1)
    before = cost.argmin(axis=0)
    n = numpy.arange(len(s))
    linked = numpy.isfinite(cost[n, after]) & (before[after] == n)
    first = numpy.setdiff1d(n, after[linked])
    rows = []
    for k in first:
        chain = [int(k)]
        while linked[chain[-1]]:
            chain.append(int(after[chain[-1]]))
        if len(chain) >= LEAST_LETTERS_IN_ROW and (row := _fit_baseline(numpy.array(chain), s, high, tall, way)):
            rows.append(row)
    return rows


def _fit_baseline(chain: Indices, s: Array, feet: Array, tall: Array, way: float) -> TextRow | None:
    """The baseline of most letters of a chain; None if too few fit."""
    x = s[chain]
    y = feet[chain]
    height = float(numpy.median(tall[chain]))
    i, j = numpy.triu_indices(len(x), 1)
    far = x[j] - x[i] > 0.4 * numpy.ptp(x)
    i = i[far]
    j = j[far]
    slopes = (y[j] - y[i]) / (x[j] - x[i])
    if len(i) > 400:
        slopes = slopes[:: len(i) // 400]
        i = i[:: len(i) // 400]
    rest = y - slopes[:, None] * (x - x[i][:, None]) - y[i][:, None]
    best = int((abs(rest) < BASELINE_TOLERANCE_RATIO * height).sum(axis=1).argmax())
    near = abs(rest[best]) < BASELINE_TOLERANCE_RATIO * height
    if near.sum() < max(LEAST_LETTERS_IN_ROW - 2, 0.4 * len(x)):
        return None
    for _ in range(3):
        line = numpy.polynomial.polynomial.polyfit(x[near], y[near], 1)
        off = y - line[0] - line[1] * x
        near = abs(off) < BASELINE_TOLERANCE_RATIO * height
    middle = float(x[near].mean())
    error = math.hypot(float(off[near].std()), 0.3) / math.sqrt(float(((x[near] - middle) ** 2).sum()))
    place = complex(middle, line[0] + line[1] * middle) * numpy.exp(1j * way)
    return TextRow(complex(place), way + math.atan(line[1]), error, chain)


def _stroke_edges(small: Greys, labels: Indices, new: Indices, way: float) -> tuple[Indices, Array, Array]:
    """Edges of nearly upright letter strokes: their letters, directions and sharpness."""
    cv2 = cv()
    soft = cv2.GaussianBlur(small, (0, 0), 1.0)
    dx, dy = (cv2.Scharr(soft, cv2.CV_32F, *d) for d in ((1, 0), (0, 1)))
    wide = cv2.dilate(labels.astype(numpy.float32), None)
    there = wide > 0
    letter_of_edge = new[wide[there].astype(int) - 1]
    gradient = dx[there] + 1j * dy[there]
    upright = (numpy.angle(gradient * numpy.exp(-1j * way)) + math.pi / 2) % math.pi - math.pi / 2
    good: Booleans = (letter_of_edge >= 0) & (abs(upright) < MOST_STROKE_SLANT_RAD)
    return letter_of_edge[good], upright[good] + way + math.pi / 2, abs(gradient[good]) ** 2
