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

from planes.check.vision.image.opencv import connected_components, cv, resize_by_factor
from planes.geometry.arrays import Array, Booleans, Greys, Indices

PX_PER_MM = 3.0  # of the reduced picture for line detection
STEPS_PER_GREY_LEVEL = 64  # integer steps per grey level: half the memory and time of floats
LINE_ANGLE_COUNT = 12
# of a detected line: length, σ of width, offset of the paper
LINE_FILTER_LENGTH_MM = 3.0
LINE_FILTER_WIDTH_SIGMA_MM = 0.2
PAPER_OFFSET_MM = 0.85
# paper: most tiles have less over this share; factor for a line
PAPER_TILE_MM = 20.0
PAPER_TILE_QUANTILE = 0.93
LINE_OVER_PAPER_RATIO = 1.6
# relative to a usual line: clear, not faint, and the minimum anywhere
CLEAR_LINE_RESPONSE = 0.4
FIRM_LINE_RESPONSE = 0.28
FAINTEST_LINE_RESPONSE = 0.06
STRONGEST_ANGLE_SHARE = 0.9  # relative to the response at the best angle
# stroke: more ink than on its darker side; than around
STROKE_OVER_DARKER_SIDE = 0.5
STROKE_OVER_SURROUNDINGS = 0.5
STROKE_SURROUNDINGS_MM = 1.5
SHORTEST_CLEAR_STROKE_MM = 5.0  # of clear strokes
SHORTEST_USUAL_LINE_MM = 7.5  # of lines that determine the usual one
# samples that determine it, quantile above erased lines; a firm pencil
LEAST_USUAL_LINE_SAMPLES = 60
USUAL_LINE_QUANTILE = 0.7
FIRM_PENCIL_RESPONSE = 65.0 * STEPS_PER_GREY_LEVEL
# a longer faint line was erased; distance between the strokes that it connects
LONGEST_FAINT_PART_MM = 7.0
LEAST_STROKE_GAP_SHARE = 0.5
# continuation of a followed line under other ink; width of its ink to the side
LINE_CONTINUATION_MM = 1.0
LINE_INK_SIDE_MM = 0.5
# ratio of a line's middle to its response: of a pencil line, of a
PENCIL_PEAK_RATIO = 1.35
THIN_LINE_PEAK_TO_RESPONSE = 2.5
MEDIAN_PEAK_FACTOR = 0.85
# thin one; factor on their median
# relative to a usual line: maximum normalisation of a line; threshold of other ink
MOST_LINE_NORMALISATION = 1.3
OTHER_INK_THRESHOLD = 0.7
FILLED_GAP_MM = 1.2  # along a line, over which gaps of the paper's grain are filled
LINE_INK_THRESHOLD = 0.4  # relative darkness of ink that surely belongs to a followed line

Place = tuple[slice, slice]


def relative_line_darkness(
    dark: Greys, scale: float, middle_dark: int, print_mm: float = 0.0
) -> tuple[Greys, Booleans]:
    """The darkness of a picture's pixels relative to their lines (``middle_dark``: in the middle), and followed lines.

    The uppermost ``print_mm`` of the sheet are printed, and say nothing about the pencil.
    """
    cv2 = cv()
    size = dark.shape[::-1]
    even, against, lines = _normalise_along_lines(dark, scale, print_mm)
    against = cv2.resize(against, size, interpolation=cv2.INTER_LINEAR)
    shares = numpy.minimum(cv2.divide(even, against, scale=middle_dark), middle_dark)
    near = cv2.resize(lines.view(numpy.uint8), size, interpolation=cv2.INTER_NEAREST).view(bool)
    return shares, near & (shares > LINE_INK_THRESHOLD * middle_dark)


def _normalise_along_lines(dark: Greys, scale: float, print_mm: float) -> tuple[Greys, Greys, Booleans]:
    """The picture with its lines filled; on a reduced one the normalisation of ink, and the followed lines."""
    cv2 = cv()
    felt = FeltLines(dark, scale, print_mm)
    strength = numpy.zeros_like(felt.most)
    even = dark.copy()
    peaks = [numpy.full(1, PENCIL_PEAK_RATIO)]
    for k in range(LINE_ANGLE_COUNT):
        for place, response, mine in felt.follow_lines_at_angle(k):
            near = cv2.dilate(mine.view(numpy.uint8), _disk(LINE_CONTINUATION_MM)) > 0
            strength[place] = numpy.maximum(strength[place], numpy.where(near, response, 0))
            middle = _fill_line_gaps(dark, even, place, mine, k, scale)
            ridge = mine & (response == cv2.dilate(response, None))
            peaks.append(middle[ridge] / (response[ridge] / STEPS_PER_GREY_LEVEL))
    peak = float(
        (MEDIAN_PEAK_FACTOR * numpy.median(numpy.concatenate(peaks))).clip(
            PENCIL_PEAK_RATIO, THIN_LINE_PEAK_TO_RESPONSE
        )
    )
    against = numpy.minimum(cv2.dilate(strength, _disk(LINE_INK_SIDE_MM)), MOST_LINE_NORMALISATION * felt.usual)
    other = numpy.maximum(OTHER_INK_THRESHOLD * cv2.dilate(felt.darkest, _disk(LINE_INK_SIDE_MM)), felt.usual)
    against = cv2.GaussianBlur(numpy.where(against > 0, against, other).astype(numpy.float32), (0, 0), 0.7)
    return even, (peak / STEPS_PER_GREY_LEVEL * against).clip(1, 255).astype(numpy.uint8), strength > 0


class FeltLines:
    """The response of lines at every angle: their ink, and its maximum minus that of the paper beside."""

    def __init__(self, dark: Greys, scale: float, print_mm: float = 0.0) -> None:
        """Detects lines on a picture; if those below its printed top are lighter, they determine the usual line."""
        cv2 = cv()
        factor = PX_PER_MM / scale
        small = resize_by_factor(dark, factor).astype(numpy.int16) * STEPS_PER_GREY_LEVEL
        self.most: Array = numpy.zeros_like(small)
        self.darkest = self.most
        self.along = list[Array]()
        self.best: Indices = numpy.zeros(small.shape, numpy.int8)  # the angle of the maximum
        for k in range(LINE_ANGLE_COUNT):
            self.along.append(cv2.filter2D(small, -1, _line_kernel(k)))
            response = self.line_responses_at_angle(k)[0]
            self.best[response > self.most] = k
            self.most = numpy.maximum(self.most, response)
            self.darkest = numpy.maximum(self.darkest, self.along[k])
        self.nearby = cv2.dilate(
            self.most, numpy.ones((2 * round(STROKE_SURROUNDINGS_MM * PX_PER_MM) + 1,) * 2, numpy.uint8)
        )
        self.paper = LINE_OVER_PAPER_RATIO * _usual_paper_response(self.most)
        self.own = [self._single_stroke_response(k) for k in range(LINE_ANGLE_COUNT)]  # of single strokes
        self.usual = min(self._usual_line_below_row(top) for top in {0, round(print_mm * PX_PER_MM)})

    def _usual_line_below_row(self, top: int) -> float:
        """The usual line below a row."""
        drawn = [own[top:] for own in self.own]
        strong = numpy.concatenate(
            [
                own[_long_components(own > 2 * self.paper / STEPS_PER_GREY_LEVEL, SHORTEST_USUAL_LINE_MM)]
                for own in drawn
            ]
        )
        if len(strong) > LEAST_USUAL_LINE_SAMPLES:
            return float(numpy.quantile(strong, USUAL_LINE_QUANTILE)) * STEPS_PER_GREY_LEVEL
        return FIRM_PENCIL_RESPONSE

    def line_responses_at_angle(self, k: int) -> tuple[Array, Array, Array]:
        """The ink of lines at an angle: minus the paper on both sides; minus that of the darker side; and itself."""
        along = self.along[k]
        across = PAPER_OFFSET_MM * PX_PER_MM * numpy.exp(1j * math.pi * (k / LINE_ANGLE_COUNT + 0.5))
        shift = round(float(across.imag)), round(float(across.real))
        one, other = (numpy.roll(along, (sign * shift[0], sign * shift[1]), (0, 1)) for sign in (1, -1))
        return along - (one + other) // 2, along - numpy.maximum(one, other), along

    def is_strongest_angle(self, k: int, response: Array) -> Booleans:
        """Where a line runs at an angle; at both angles if between two."""
        turn = (self.best - k + LINE_ANGLE_COUNT + 1) % LINE_ANGLE_COUNT
        return (turn <= 2) | (response > STRONGEST_ANGLE_SHARE * self.most)

    def _single_stroke_response(self, k: int) -> Greys:
        """The response of single strokes: the foot of a row of letters has no paper on both sides."""
        response, alone, along = self.line_responses_at_angle(k)
        own = (
            self.is_strongest_angle(k, response)
            & (alone > STROKE_OVER_DARKER_SIDE * along)
            & (alone > STROKE_OVER_SURROUNDINGS * self.nearby)
        )
        return numpy.where(own, alone // STEPS_PER_GREY_LEVEL, 0).astype(numpy.uint8)

    def follow_lines_at_angle(self, k: int) -> Iterator[tuple[Place, Array, Booleans]]:
        """Lines at an angle, as far as they are connected to clear strokes: box, response, where they are strongest.

        A faint part ends a stroke soon or connects it to another; otherwise it was erased.
        """
        plain = _long_components(
            self.own[k] > CLEAR_LINE_RESPONSE * self.usual / STEPS_PER_GREY_LEVEL, SHORTEST_CLEAR_STROKE_MM
        )
        if not plain.any():
            return
        response = self.line_responses_at_angle(k)[0]
        least = max(min(self.paper, 0.5 * CLEAR_LINE_RESPONSE * self.usual), FAINTEST_LINE_RESPONSE * self.usual)
        foremost = self.is_strongest_angle(k, response)
        labels, boxes = connected_components(response > least)
        for number in numpy.unique(labels[plain]).tolist():
            place = _box_slices(boxes[number])
            line = labels[place] == number
            faint = line & (response[place] <= FIRM_LINE_RESPONSE * self.usual)
            _drop_long_faint_parts(line, faint, plain[place])
            yield place, numpy.where(line, response[place], 0), line & foremost[place]


def _drop_long_faint_parts(line: Booleans, faint: Booleans, plain: Booleans) -> None:
    """Removes long faint parts of a line that do not connect strokes."""
    strokes, _ = connected_components(line & ~faint)
    drawn = numpy.setdiff1d(strokes[plain & line], 0)
    parts, boxes = connected_components(faint)
    for k, box in enumerate(boxes):
        if k and max(box[2:4]) > LONGEST_FAINT_PART_MM * PX_PER_MM:
            place = _box_slices(box, 1)
            about = cv().dilate((parts[place] == k).view(numpy.uint8), None) > 0
            met = about & numpy.isin(strokes[place], drawn)
            ends = numpy.argwhere(met)
            if len(numpy.unique(strokes[place][met])) < 2 or numpy.ptp(
                ends, axis=0
            ).max() < LEAST_STROKE_GAP_SHARE * max(box[2:4]):
                line[place] &= parts[place] != k


def _fill_line_gaps(dark: Greys, even: Greys, place: Place, of_it: Booleans, k: int, scale: float) -> Greys:
    """Fills gaps of the paper's grain in a line from the ink along it on both sides; returns its darkness."""
    cv2 = cv()
    up = scale / PX_PER_MM
    rows, columns = (slice(int(side.start * up), int(side.stop * up)) for side in place)
    part = dark[rows, columns]
    reach = max(round(FILLED_GAP_MM / 2 * scale), 1)
    local = _around(reach, k)
    kernel = numpy.clip(1 - numpy.abs(local.imag), 0, 1) * (numpy.abs(local.real) <= reach)
    ahead = numpy.where(local.real > 0, kernel, 0) + 0.5 * numpy.where(local.real == 0, kernel, 0)
    ahead = (ahead / (2 * ahead.sum())).astype(numpy.float32)
    one = cv2.filter2D(part, -1, ahead)
    other = cv2.filter2D(part, -1, ahead[::-1, ::-1])
    smooth = numpy.minimum(one, 2 * other) + numpy.minimum(other, 2 * one)  # beyond a line's end one of them is zero
    inside = cv2.resize(of_it.view(numpy.uint8), part.shape[::-1], interpolation=cv2.INTER_NEAREST).view(bool)
    numpy.maximum(even[rows, columns], smooth, out=even[rows, columns], where=inside)
    del inside
    middle = cv2.dilate(smooth, None)
    filled: Greys = cv2.resize(middle, of_it.shape[::-1], interpolation=cv2.INTER_NEAREST)
    return filled


def _usual_paper_response(felt: Array) -> float:
    """The usual response of paper: in most tiles of a sheet only little area exceeds it."""
    side = int(PAPER_TILE_MM * PX_PER_MM)
    tops, lefts = (range(0, max(n - side // 2, 1), side) for n in felt.shape)
    parts = (felt[top : top + side, left : left + side] for top in tops for left in lefts)
    return float(numpy.median([numpy.quantile(part, PAPER_TILE_QUANTILE) for part in parts]))


def _long_components(places: Booleans, least_mm: float) -> Booleans:
    """The connected pixels of at least this length."""
    labels, boxes = connected_components(places)
    long = boxes[:, 2:4].max(axis=1) >= least_mm * PX_PER_MM
    long[0] = False
    long_places: Booleans = long[labels]
    return long_places


def _box_slices(box: Indices, rim: int = 0) -> Place:
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
    around: Array = (x + 1j * y) * numpy.exp(-1j * math.pi * k / LINE_ANGLE_COUNT)
    return around


@cache
def _line_kernel(k: int) -> Array:
    """The mean of the ink along a line."""
    reach = math.ceil((LINE_FILTER_LENGTH_MM / 2 + LINE_FILTER_WIDTH_SIGMA_MM) * PX_PER_MM)
    local = _around(reach, k) / PX_PER_MM
    ends = numpy.clip((LINE_FILTER_LENGTH_MM / 2 - numpy.abs(local.real)) * PX_PER_MM + 0.5, 0, 1)
    kernel = ends * numpy.exp(-(local.imag**2) / (2 * LINE_FILTER_WIDTH_SIGMA_MM**2))
    mean: Array = (kernel / kernel.sum()).astype(numpy.float32)
    return mean
