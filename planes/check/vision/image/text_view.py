"""The camera tilt over a page with text: rows are parallel, slants constant along a row, letters of a block equal.

The convergence of rows shows the tilt along them; the tilt across them follows from the slant of letters on the left
and on the right, and from their height at the top and at the bottom. Handwritten rows are less reliable, their letters
still less. An undetermined tilt remains as an error.
"""

import cmath
import math
from collections.abc import Callable

import numpy

from planes.check.vision.image.bend import apply_homography
from planes.check.vision.image.lens import PHONE_TILT_SIGMA, CameraTilt, levelled_view
from planes.check.vision.image.text_rows import LetterRows, find_text_rows
from planes.geometry.arrays import Array, Complexes, Greys, Indices
from planes.words.frozen import frozen

LEAST_LETTERS, FIT_ROUNDS = 24, 10
# kernel widths of stroke slants, and of logarithms of letter heights
SLANT_KERNEL_RAD = math.radians(7)
LOG_HEIGHT_KERNEL = 0.07
# σ of letter slants: maximum in print, minimum in handwriting
PRINTED_SLANT_SIGMA_RAD = math.radians(0.8)
HANDWRITTEN_SLANT_SIGMA_RAD = math.radians(1.5)
PRINTED_ROW_SIGMA_RAD, HANDWRITTEN_ROW_SIGMA_RAD, HANDWRITTEN_BLOCK_SIGMA_RAD = (
    math.radians(v) for v in (0.12, 0.8, 1.0)
)  # σ of rows of print, handwriting, its blocks
ROW_SIGMA_FACTOR = 2.5  # factor on a row's σ over that of independent letters
LEAST_SLANT_SIGMA_RAD, LEAST_LOG_HEIGHT_SIGMA = math.radians(0.8), 0.015  # minimum σ of a letter's
# factor on the σ of many slants over independent ones; for letters below this height
SLANT_SIGMA_FACTOR = 1.5
FINE_LETTER_HEIGHT_PX = 24.0
SYSTEMATIC_SLOPE_ERRORS = 0.005, 0.018  # systematic error of print, and of handwriting, as a slope
HALF_WEIGHT_SQUARED_SIGMAS = 8.0  # squared deviation, in σ, at which a cue has half the weight
MOST_SHEET_TURN_RAD = math.radians(30)  # of a sheet that is meant to be upright
MOST_ROW_GAP_IN_BLOCK = 4.5  # maximum distance between rows of a block, in letters


@frozen
class _Cue:
    """Quantities that are equal within each group at the right tilt.

    These are values minus their groups' means, their weights, and their derivatives by the tilt.
    """

    left: Array
    weights: Array
    slopes: Array


def tilt_by_text(grey: Greys, focal: float) -> CameraTilt | None:
    """The tilt from a page's text (slopes to the right and down), with this focal length; None if there is little text.

    The focal length is in the picture's longer sides.
    """
    text = find_text_rows(grey)
    if text is None or len(text.places) < LEAST_LETTERS:
        return None
    height, width = grey.shape
    return _TextSight(text, complex(width, height) / 2, focal * max(width, height)).likeliest_tilt()


class _TextSight:
    """A page's text seen by a tilted camera, with letter slants (radians on the sheet) and heights (logarithms).

    Both are given block by block.
    """

    def __init__(self, text: LetterRows, middle: complex, far: float) -> None:
        self.text = text
        self.middle = middle
        self.far = far
        of_rows = _block_numbers_of_rows(text)
        self.blocks = of_rows[text.row_numbers]
        self.row_count = numpy.bincount(of_rows)[of_rows]
        self.places = numpy.array([r.place for r in text.rows])
        self.ways = numpy.array([r.angle for r in text.rows])
        self.errors = numpy.array([ROW_SIGMA_FACTOR * r.error for r in text.rows])
        self.logs = numpy.log(text.heights)
        each = [self.blocks == b for b in range(of_rows.max() + 1)]
        self.sizes = numpy.array([_approximate_mode(self.logs[mine], LOG_HEIGHT_KERNEL) for mine in each])
        self.slants = numpy.array([_usual_slant(text, mine[text.of]) for mine in each])

    def likeliest_tilt(self) -> CameraTilt:
        """The likeliest tilt (Gauss-Newton, with distant cues weighted less), and its accuracy."""
        tilt = 0j
        held = numpy.eye(2) / PHONE_TILT_SIGMA**2
        for _ in range(FIT_ROUNDS):
            cues, hand = self.tilt_cues(tilt)
            known = sum((c.slopes.T * c.weights) @ c.slopes for c in cues) + held
            pull = sum((c.slopes.T * c.weights) @ c.left for c in cues) + held @ [tilt.real, tilt.imag]
            tilt -= complex(*numpy.linalg.solve(known, pull))
        floor = SYSTEMATIC_SLOPE_ERRORS[0] + (SYSTEMATIC_SLOPE_ERRORS[1] - SYSTEMATIC_SLOPE_ERRORS[0]) * hand
        squares, axes = numpy.linalg.eigh(numpy.linalg.inv(known) + floor**2 * numpy.eye(2))
        turn = self.row_direction(tilt, hand)
        first, second = (math.sqrt(v) * complex(*axes[:, k]) * cmath.rect(1, -turn) for k, v in enumerate(squares))
        return CameraTilt(tilt * cmath.rect(1, -turn), (first, second), turn)

    def row_direction(self, tilt: complex, hand: float) -> float:
        """The direction of rows on the sheet as seen; 0 if it may be due to the writer."""
        ways = _angles_after_view(self.view_from_above(tilt), self.places, self.ways)
        weights = self._row_weights(hand)
        turn = float((ways * weights).sum() / weights.sum())
        if 3 * math.hypot(PRINTED_ROW_SIGMA_RAD, hand * HANDWRITTEN_BLOCK_SIGMA_RAD) < abs(turn) < MOST_SHEET_TURN_RAD:
            return turn
        return 0.0

    def tilt_cues(self, tilt: complex) -> tuple[list[_Cue], float]:
        """The cues of rows, slants and heights for a tilt, and the degree to which they are handwritten (0 to 1)."""
        view, text, near = (
            self.view_from_above(tilt),
            self.text,
            [self.view_from_above(tilt + d) for d in (1e-4, 1e-4j)],
        )
        back = numpy.asarray(numpy.linalg.inv(view), float)
        upright = _angles_after_view(back, apply_homography(view, text.places), self.slants[self.blocks])
        turned, drawn = _stroke_rotations(text, upright)
        strokes = upright + turned
        slants = _angles_after_view(view, text.places, strokes)
        off = self.logs + _log_magnifications(view, text.places, upright) - self.sizes[self.blocks]
        usual = numpy.exp(-0.5 * (off / LOG_HEIGHT_KERNEL) ** 2)
        slant = max(LEAST_SLANT_SIGMA_RAD, _weighted_sigma(slants - self.slants[self.blocks], drawn))
        hand = min(
            max((slant - PRINTED_SLANT_SIGMA_RAD) / (HANDWRITTEN_SLANT_SIGMA_RAD - PRINTED_SLANT_SIGMA_RAD), 0.0), 1.0
        )
        coarse = SLANT_SIGMA_FACTOR * max(1.0, FINE_LETTER_HEIGHT_PX / float(numpy.median(text.heights))) ** 2
        size = max(LEAST_LOG_HEIGHT_SIGMA, _weighted_sigma(off, usual)) * (1 + 2 * hand)
        self.slants = _group_means(slants, drawn, self.blocks)
        self.sizes = self.sizes + _group_means(off, usual, self.blocks)
        one = numpy.zeros(len(self.places), int)
        return [
            _tilt_cue(
                lambda v: _angles_after_view(v, self.places, self.ways), view, near, self._row_weights(hand), one
            ),
            _tilt_cue(
                lambda v: _angles_after_view(v, text.places, strokes),
                view,
                near,
                drawn / (slant * (1 + hand) * coarse) ** 2,
                self.blocks,
            ),
            _tilt_cue(
                lambda v: self.logs + _log_magnifications(v, text.places, upright),
                view,
                near,
                usual / size**2,
                self.blocks,
            ),
        ], hand

    def view_from_above(self, tilt: complex) -> Array:
        """The view from straight above."""
        view = levelled_view(self.middle, self.far, tilt)
        return numpy.eye(3) if view is None else view

    def _row_weights(self, hand: float) -> Array:
        """The weight of each row's direction, by handwriting: its rows in a block are only roughly parallel."""
        alike = PRINTED_ROW_SIGMA_RAD + (HANDWRITTEN_ROW_SIGMA_RAD - PRINTED_ROW_SIGMA_RAD) * hand
        return 1 / (self.errors**2 + alike**2 + self.row_count * (hand * HANDWRITTEN_BLOCK_SIGMA_RAD) ** 2)


def _block_numbers_of_rows(text: LetterRows) -> Indices:
    """The block number of each row: rows close below one another."""
    back = numpy.exp(-1j * text.way)
    place = numpy.array([r.place for r in text.rows]) * back
    tall = numpy.array([float(numpy.median(text.heights[r.letters])) for r in text.rows])
    s = (text.places * back).real
    left, right = (numpy.array([f(s[r.letters]) for r in text.rows]) for f in (min, max))
    block = numpy.arange(len(place))
    for i in range(len(place)):
        for j in range(i):
            close = abs(place[i].imag - place[j].imag) < MOST_ROW_GAP_IN_BLOCK * max(tall[i], tall[j])
            if close and left[i] < right[j] and left[j] < right[i]:
                block[block == block[i]] = block[j]
    return numpy.asarray(numpy.unique(block, return_inverse=True)[1])


def _tilt_cue(what: Callable[[Array], Array], view: Array, near: list[Array], weights: Array, groups: Indices) -> _Cue:
    """A quantity that should be equal within each group, for a view and slightly more tilted ones."""
    here = what(view)
    left = here - _group_means(here, weights, groups)[groups]
    moved = [(what(v) - here) / 1e-4 for v in near]
    slopes = numpy.stack([m - _group_means(m, weights, groups)[groups] for m in moved], axis=1)
    return _Cue(left, weights / (1 + left**2 * weights / HALF_WEIGHT_SQUARED_SIGMAS), slopes)


def _group_means(values: Array, weights: Array, groups: Indices) -> Array:
    """The mean of each group."""
    return numpy.bincount(groups, weights * values) / (numpy.bincount(groups, weights) + 1e-12)


def _moved(view: Array, z: Complexes, angle: Array) -> Complexes:
    """Steps of two pixels at points, along directions, after a view."""
    step = numpy.exp(1j * angle)
    moved: Complexes = apply_homography(view, z + step) - apply_homography(view, z - step)
    return moved


def _angles_after_view(view: Array, z: Complexes, angle: Array) -> Array:
    """Directions at points after a view."""
    return numpy.angle(_moved(view, z, angle))


def _log_magnifications(view: Array, z: Complexes, angle: Array) -> Array:
    """The logarithm of the local magnification of a view along directions."""
    return numpy.log(abs(_moved(view, z, angle)) / 2)


def _usual_slant(text: LetterRows, mine: Array) -> float:
    """The most frequent direction of some stroke edges."""
    if mine.any():
        return _approximate_mode(text.angles[mine], SLANT_KERNEL_RAD / 2, text.weights[mine])
    return text.way + math.pi / 2


def _approximate_mode(values: Array, wide: float, weights: Array | None = None) -> float:
    """The approximate mode of values."""
    some = slice(None, None, max(1, len(values) // 3000))
    steps = numpy.linspace(values.min(), values.max(), 60)
    near = numpy.exp(-0.5 * ((values[some] - steps[:, None]) / wide) ** 2)
    return float(steps[int((near @ (numpy.ones(len(values)) if weights is None else weights)[some]).argmax())])


def _stroke_rotations(text: LetterRows, upright: Array) -> tuple[Array, Array]:
    """The rotation of each letter's strokes from their expected direction, and its weight."""
    off = text.angles - upright[text.of]
    count = len(text.places)
    near = text.weights * numpy.exp(-0.5 * (off / SLANT_KERNEL_RAD) ** 2)
    total = numpy.bincount(text.of, near, count)
    turned = numpy.bincount(text.of, near * off, count) / (total + 1e-9)
    return turned, numpy.minimum(total / (numpy.median(total) + 1e-9), 2.0)


def _weighted_sigma(values: Array, weights: Array) -> float:
    """One σ of values."""
    middle = (weights * values).sum() / (weights.sum() + 1e-9)
    return math.sqrt(float((weights * (values - middle) ** 2).sum() / (weights.sum() + 1e-9)))
