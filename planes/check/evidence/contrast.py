"""Normalises ink by its line: lines of a hard pencil, a fading stroke and a pen come out equally dark.

The strength of a line through a point is felt, at every angle, as the ink along it minus the paper on both sides. The
level felt over most of a sheet is its paper, with a grid. Clear strokes are followed, at their angle, as far as they
stand out from that; the ink of a line is normalised by that line, all other ink by the usual line of the sheet or, if
darker, by itself.
"""

import math
from collections.abc import Iterator
from functools import cache

import numpy

from planes.check.vision.image.opencv import cv, pieces, shrunk
from planes.geometry.arrays import Array, Booleans, Greys, Indices

PX_PER_MM = 3.0  # of the reduced picture for line detection
FINE = 64  # integer steps per grey level: half the memory and time of floats
ANGLES = 12
ALONG_MM, ACROSS_MM, ASIDE_MM = 3.0, 0.2, 0.85  # of a detected line: length, σ of width, offset of the paper
TILE_MM, COVERED, ABOVE = (20.0, 0.93, 1.6)  # paper: most tiles have less over this share; factor for a line
PLAIN, FIRM, FAINTEST = 0.4, 0.28, 0.06  # relative to a usual line: clear, not faint, and the minimum anywhere
FOREMOST = 0.9  # relative to the response at the best angle
APART, AMONG, AMONG_MM = 0.5, 0.5, 1.5  # stroke: more ink than on its darker side; than around
STROKE_MM, LONG_MM = 5.0, 7.5  # of clear strokes; of lines that determine the usual one
FEW, MAINLY, USUAL = 60, 0.7, 65.0 * FINE  # samples that determine it, quantile above erased lines; a firm pencil
TAIL_MM, ENDS = 7.0, 0.5  # a longer faint line was erased; distance between the strokes that it connects
NEAR_MM, BESIDE_MM = 1.0, 0.5  # continuation of a followed line under other ink; width of its ink to the side
PEAK, SHARPEST, EVEN = 1.35, 2.5, 0.85  # ratio of a line's middle to its response: of a pencil line, of a
# thin one; factor on their median
MOST, BLOT = 1.3, 0.7  # relative to a usual line: maximum normalisation of a line; threshold of other ink
FILLED_MM = 1.2  # along a line, over which gaps of the paper's grain are filled
HELD = 0.4  # relative darkness of ink that surely belongs to a followed line

Place = tuple[slice, slice]


def inked(dark: Greys, scale: float, middle_dark: int, print_mm: float = 0.0) -> tuple[Greys, Booleans]:
    """The darkness of a picture's pixels relative to their lines (``middle_dark``: in the middle), and followed lines.

    The uppermost ``print_mm`` of the sheet are printed, and say nothing about the pencil.
    """
    cv2, size = cv(), dark.shape[::-1]
    even, against, lines = _evened_along(dark, scale, print_mm)
    against = cv2.resize(against, size, interpolation=cv2.INTER_LINEAR)
    shares = numpy.minimum(cv2.divide(even, against, scale=middle_dark), middle_dark)
    near = cv2.resize(lines.view(numpy.uint8), size, interpolation=cv2.INTER_NEAREST).view(bool)
    return shares, near & (shares > HELD * middle_dark)


def _evened_along(dark: Greys, scale: float, print_mm: float) -> tuple[Greys, Greys, Booleans]:
    """The picture with its lines filled; on a reduced one the normalisation of ink, and the followed lines."""
    cv2, felt = cv(), FeltLines(dark, scale, print_mm)
    strength, even, peaks = numpy.zeros_like(felt.most), dark.copy(), [numpy.full(1, PEAK)]
    for k in range(ANGLES):
        for place, response, mine in felt.followed(k):
            near = cv2.dilate(mine.view(numpy.uint8), _disk(NEAR_MM)) > 0
            strength[place] = numpy.maximum(strength[place], numpy.where(near, response, 0))
            middle = _fill(dark, even, place, mine, k, scale)
            ridge = mine & (response == cv2.dilate(response, None))
            peaks.append(middle[ridge] / (response[ridge] / FINE))
    peak = float((EVEN * numpy.median(numpy.concatenate(peaks))).clip(PEAK, SHARPEST))
    against = numpy.minimum(cv2.dilate(strength, _disk(BESIDE_MM)), MOST * felt.usual)
    other = numpy.maximum(BLOT * cv2.dilate(felt.darkest, _disk(BESIDE_MM)), felt.usual)
    against = cv2.GaussianBlur(numpy.where(against > 0, against, other).astype(numpy.float32), (0, 0), 0.7)
    return even, (peak / FINE * against).clip(1, 255).astype(numpy.uint8), strength > 0


class FeltLines:
    """The response of lines at every angle: their ink, and its maximum minus that of the paper beside."""

    def __init__(self, dark: Greys, scale: float, print_mm: float = 0.0) -> None:
        """Detects lines on a picture; if those below its printed top are lighter, they determine the usual line."""
        cv2, factor = cv(), PX_PER_MM / scale
        small = shrunk(dark, factor).astype(numpy.int16) * FINE
        self.most: Array = numpy.zeros_like(small)
        self.darkest = self.most
        self.along = list[Array]()
        self.best: Indices = numpy.zeros(small.shape, numpy.int8)  # the angle of the maximum
        for k in range(ANGLES):
            self.along.append(cv2.filter2D(small, -1, _kernel(k)))
            response = self.at(k)[0]
            self.best[response > self.most] = k
            self.most, self.darkest = numpy.maximum(self.most, response), numpy.maximum(self.darkest, self.along[k])
        self.nearby = cv2.dilate(self.most, numpy.ones((2 * round(AMONG_MM * PX_PER_MM) + 1,) * 2, numpy.uint8))
        self.paper = ABOVE * _usual_on_paper(self.most)
        self.own = [self._strokes(k) for k in range(ANGLES)]  # of single strokes
        self.usual = min(self._usual_below(top) for top in {0, round(print_mm * PX_PER_MM)})

    def _usual_below(self, top: int) -> float:
        """The usual line below a row."""
        drawn = [own[top:] for own in self.own]
        strong = numpy.concatenate([own[_long(own > 2 * self.paper / FINE, LONG_MM)] for own in drawn])
        return float(numpy.quantile(strong, MAINLY)) * FINE if len(strong) > FEW else USUAL

    def at(self, k: int) -> tuple[Array, Array, Array]:
        """The ink of lines at an angle: minus the paper on both sides; minus that of the darker side; and itself."""
        along = self.along[k]
        across = ASIDE_MM * PX_PER_MM * numpy.exp(1j * math.pi * (k / ANGLES + 0.5))
        shift = round(float(across.imag)), round(float(across.real))
        one, other = (numpy.roll(along, (sign * shift[0], sign * shift[1]), (0, 1)) for sign in (1, -1))
        return along - (one + other) // 2, along - numpy.maximum(one, other), along

    def foremost(self, k: int, response: Array) -> Booleans:
        """Where a line runs at an angle; at both angles if between two."""
        turn = (self.best - k + ANGLES + 1) % ANGLES
        return (turn <= 2) | (response > FOREMOST * self.most)

    def _strokes(self, k: int) -> Greys:
        """The response of single strokes: the foot of a row of letters has no paper on both sides."""
        response, alone, along = self.at(k)
        own = self.foremost(k, response) & (alone > APART * along) & (alone > AMONG * self.nearby)
        return numpy.where(own, alone // FINE, 0).astype(numpy.uint8)

    def followed(self, k: int) -> Iterator[tuple[Place, Array, Booleans]]:
        """Lines at an angle, as far as they are connected to clear strokes: box, response, where they are strongest.

        A faint part ends a stroke soon or connects it to another; otherwise it was erased.
        """
        plain = _long(self.own[k] > PLAIN * self.usual / FINE, STROKE_MM)
        if not plain.any():
            return
        response = self.at(k)[0]
        least = max(min(self.paper, 0.5 * PLAIN * self.usual), FAINTEST * self.usual)
        foremost, (labels, boxes) = self.foremost(k, response), pieces(response > least)
        for number in numpy.unique(labels[plain]).tolist():
            place = _box(boxes[number])
            line = labels[place] == number
            faint = line & (response[place] <= FIRM * self.usual)
            _drop_long(line, faint, plain[place])
            yield place, numpy.where(line, response[place], 0), line & foremost[place]


def _drop_long(line: Booleans, faint: Booleans, plain: Booleans) -> None:
    """Removes long faint parts of a line that do not connect strokes."""
    strokes, _ = pieces(line & ~faint)
    drawn = numpy.setdiff1d(strokes[plain & line], 0)
    parts, boxes = pieces(faint)
    for k, box in enumerate(boxes):
        if k and max(box[2:4]) > TAIL_MM * PX_PER_MM:
            place = _box(box, 1)
            about = cv().dilate((parts[place] == k).view(numpy.uint8), None) > 0
            met = about & numpy.isin(strokes[place], drawn)
            ends = numpy.argwhere(met)
            if len(numpy.unique(strokes[place][met])) < 2 or numpy.ptp(ends, axis=0).max() < ENDS * max(box[2:4]):
                line[place] &= parts[place] != k


def _fill(dark: Greys, even: Greys, place: Place, of_it: Booleans, k: int, scale: float) -> Greys:
    """Fills gaps of the paper's grain in a line from the ink along it on both sides; returns its darkness."""
    cv2, up = cv(), scale / PX_PER_MM
    rows, columns = (slice(int(side.start * up), int(side.stop * up)) for side in place)
    part, reach = dark[rows, columns], max(round(FILLED_MM / 2 * scale), 1)
    local = _around(reach, k)
    kernel = numpy.clip(1 - numpy.abs(local.imag), 0, 1) * (numpy.abs(local.real) <= reach)
    ahead = numpy.where(local.real > 0, kernel, 0) + 0.5 * numpy.where(local.real == 0, kernel, 0)
    ahead = (ahead / (2 * ahead.sum())).astype(numpy.float32)
    one, other = cv2.filter2D(part, -1, ahead), cv2.filter2D(part, -1, ahead[::-1, ::-1])
    smooth = numpy.minimum(one, 2 * other) + numpy.minimum(other, 2 * one)  # beyond a line's end one of them is zero
    inside = cv2.resize(of_it.view(numpy.uint8), part.shape[::-1], interpolation=cv2.INTER_NEAREST).view(bool)
    numpy.maximum(even[rows, columns], smooth, out=even[rows, columns], where=inside)
    del inside
    middle = cv2.dilate(smooth, None)
    filled: Greys = cv2.resize(middle, of_it.shape[::-1], interpolation=cv2.INTER_NEAREST)
    return filled


def _usual_on_paper(felt: Array) -> float:
    """The usual response of paper: in most tiles of a sheet only little area exceeds it."""
    side = int(TILE_MM * PX_PER_MM)
    tops, lefts = (range(0, max(n - side // 2, 1), side) for n in felt.shape)
    parts = (felt[top : top + side, left : left + side] for top in tops for left in lefts)
    return float(numpy.median([numpy.quantile(part, COVERED) for part in parts]))


def _long(places: Booleans, least_mm: float) -> Booleans:
    """The connected pixels of at least this length."""
    labels, boxes = pieces(places)
    long = boxes[:, 2:4].max(axis=1) >= least_mm * PX_PER_MM
    long[0] = False
    long_places: Booleans = long[labels]
    return long_places


def _box(box: Indices, rim: int = 0) -> Place:
    x, y, w, h, _ = box.tolist()
    return slice(max(y - rim, 0), y + h + rim), slice(max(x - rim, 0), x + w + rim)


def _disk(reach_mm: float) -> Greys:
    """A disk of this radius."""
    side = 2 * round(reach_mm * PX_PER_MM) + 1
    disk: Greys = cv().getStructuringElement(cv().MORPH_ELLIPSE, (side, side))
    return disk


def _around(reach: int, k: int) -> Array:
    """The pixels around one, along and across an angle."""
    y, x = numpy.mgrid[-reach : reach + 1, -reach : reach + 1]
    around: Array = (x + 1j * y) * numpy.exp(-1j * math.pi * k / ANGLES)
    return around


@cache
def _kernel(k: int) -> Array:
    """The mean of the ink along a line."""
    reach = math.ceil((ALONG_MM / 2 + ACROSS_MM) * PX_PER_MM)
    local = _around(reach, k) / PX_PER_MM
    ends = numpy.clip((ALONG_MM / 2 - numpy.abs(local.real)) * PX_PER_MM + 0.5, 0, 1)
    kernel = ends * numpy.exp(-(local.imag**2) / (2 * ACROSS_MM**2))
    mean: Array = (kernel / kernel.sum()).astype(numpy.float32)
    return mean
