"""How the camera was tilted over a page with text: rows of letters are parallel on paper, strokes of letters slant
alike from end to end of a row, and letters of a block are of one size.

Rows tell the tilt along them by how they run together; the tilt across them is told by how letters slant to the left
and to the right, and how high they are above and beneath. Of a hand's rows little is sure, and less of its letters.
What nothing tells remains as an error.
"""

import cmath
import math
from collections.abc import Callable

import numpy

from planes.check.vision.image.bend import through
from planes.check.vision.image.lens import HELD, CameraTilt, level
from planes.check.vision.image.text_rows import LetterRows, text_on
from planes.geometry.arrays import Array, Complexes, Greys, Indices
from planes.words.frozen import frozen

LEAST_LETTERS, ROUNDS = 24, 10
KERNEL, SIZES = math.radians(7), 0.07  # how far strokes' slants, and the logarithms of letters' heights, are one kind
PRINTED, WRITTEN = math.radians(0.8), math.radians(1.5)  # σ of how letters slant: of print at most, of a hand at least
PARALLEL, BY_HAND, APART = (math.radians(v) for v in (0.12, 0.8, 1.0))  # σ of rows of print, of a hand, of its blocks
WANDER = 2.5  # how much less sure a row's direction is than if its letters were off it each by itself
LEAST_SLANT, LEAST_SIZE = math.radians(0.8), 0.015  # σ of a letter's, at least
TOGETHER, FINE_PX = 1.5, 24.0  # how much less sure many slants are than each by itself; and of letters not so high
SYSTEMATIC = 0.005, 0.018  # what all of print, and of a hand, may be off by together, as a slope
CAUCHY = 8.0  # the square of how many σ off a cue tells half
MOST_TURN = math.radians(30)  # of a sheet that is meant to be upright
BLOCK = 4.5  # rows of a block are no farther apart, in letters


@frozen
class _Cue:
    """What would be alike in each group were the tilt right: values without their groups' means, their weights, and
    how they change with the tilt."""

    left: Array
    weights: Array
    slopes: Array


def tilt_by_text(grey: Greys, focal: float) -> CameraTilt | None:
    """The tilt that a page's text tells (slopes to the right and down), the camera's lens so long (in the picture's
    longer sides); None where there is little text."""
    text = text_on(grey)
    if text is None or len(text.places) < LEAST_LETTERS:
        return None
    height, width = grey.shape
    return _TextSight(text, complex(width, height) / 2, focal * max(width, height)).tilt()


class _TextSight:
    """A page's text seen by a camera of some tilt, and how its letters slant (radians on the sheet) and how high they
    are (logarithms), block by block."""

    def __init__(self, text: LetterRows, middle: complex, far: float) -> None:
        self.text, self.middle, self.far = text, middle, far
        of_rows = _blocks(text)
        self.blocks, self.row_count = of_rows[text.row_of], numpy.bincount(of_rows)[of_rows]
        self.places = numpy.array([r.place for r in text.rows])
        self.ways = numpy.array([r.angle for r in text.rows])
        self.errors = numpy.array([WANDER * r.error for r in text.rows])
        self.logs = numpy.log(text.heights)
        each = [self.blocks == b for b in range(of_rows.max() + 1)]
        self.sizes = numpy.array([_mode(self.logs[mine], SIZES) for mine in each])
        self.slants = numpy.array([_slant(text, mine[text.of]) for mine in each])

    def tilt(self) -> CameraTilt:
        """The likeliest tilt, Gauss and Newton's way, far cues telling less; and how sure it is."""
        tilt, held = 0j, numpy.eye(2) / HELD**2
        for _ in range(ROUNDS):
            cues, hand = self.cues(tilt)
            known = sum((c.slopes.T * c.weights) @ c.slopes for c in cues) + held
            pull = sum((c.slopes.T * c.weights) @ c.left for c in cues) + held @ [tilt.real, tilt.imag]
            tilt -= complex(*numpy.linalg.solve(known, pull))
        floor = SYSTEMATIC[0] + (SYSTEMATIC[1] - SYSTEMATIC[0]) * hand
        squares, axes = numpy.linalg.eigh(numpy.linalg.inv(known) + floor**2 * numpy.eye(2))
        turn = self.turn(tilt, hand)
        first, second = (math.sqrt(v) * complex(*axes[:, k]) * cmath.rect(1, -turn) for k, v in enumerate(squares))
        return CameraTilt(tilt * cmath.rect(1, -turn), (first, second), turn)

    def turn(self, tilt: complex, hand: float) -> float:
        """How rows run on the sheet as it is seen; 0 where that may be no more than a writer's own."""
        ways, weights = _angles(self.level(tilt), self.places, self.ways), self._row_weights(hand)
        turn = float((ways * weights).sum() / weights.sum())
        return turn if 3 * math.hypot(PARALLEL, hand * APART) < abs(turn) < MOST_TURN else 0.0

    def cues(self, tilt: complex) -> tuple[list[_Cue], float]:
        """What rows, slants and heights tell about a tilt, and how much like a hand's they are (0 to 1)."""
        view, text, near = self.level(tilt), self.text, [self.level(tilt + d) for d in (1e-4, 1e-4j)]
        back = numpy.asarray(numpy.linalg.inv(view), float)
        upright = _angles(back, through(view, text.places), self.slants[self.blocks])
        turned, drawn = _strokes(text, upright)
        strokes = upright + turned
        slants = _angles(view, text.places, strokes)
        off = self.logs + _lengths(view, text.places, upright) - self.sizes[self.blocks]
        usual = numpy.exp(-0.5 * (off / SIZES) ** 2)
        slant = max(LEAST_SLANT, _spread(slants - self.slants[self.blocks], drawn))
        hand = min(max((slant - PRINTED) / (WRITTEN - PRINTED), 0.0), 1.0)
        coarse = TOGETHER * max(1.0, FINE_PX / float(numpy.median(text.heights))) ** 2
        size = max(LEAST_SIZE, _spread(off, usual)) * (1 + 2 * hand)
        self.slants = _means(slants, drawn, self.blocks)
        self.sizes = self.sizes + _means(off, usual, self.blocks)
        one, blocks = numpy.zeros(len(self.places), int), self.blocks
        return [
            _cue(lambda v: _angles(v, self.places, self.ways), view, near, self._row_weights(hand), one),
            _cue(
                lambda v: _angles(v, text.places, strokes),
                view,
                near,
                drawn / (slant * (1 + hand) * coarse) ** 2,
                blocks,
            ),
            _cue(lambda v: self.logs + _lengths(v, text.places, upright), view, near, usual / size**2, blocks),
        ], hand

    def level(self, tilt: complex) -> Array:
        """The view as from straight above."""
        view = level(self.middle, self.far, tilt)
        return numpy.eye(3) if view is None else view

    def _row_weights(self, hand: float) -> Array:
        """How much each row's direction tells, by how much it is a hand's: a block of these runs like another but
        roughly."""
        alike = PARALLEL + (BY_HAND - PARALLEL) * hand
        return 1 / (self.errors**2 + alike**2 + self.row_count * (hand * APART) ** 2)


def _blocks(text: LetterRows) -> Indices:
    """The number of each row's block: rows close beneath one another."""
    place = numpy.array([r.place for r in text.rows]) * numpy.exp(-1j * text.way)
    tall = numpy.array([float(numpy.median(text.heights[r.letters])) for r in text.rows])
    s = (text.places * numpy.exp(-1j * text.way)).real
    left, right = (numpy.array([f(s[r.letters]) for r in text.rows]) for f in (min, max))
    block = numpy.arange(len(place))
    for i in range(len(place)):
        for j in range(i):
            close = abs(place[i].imag - place[j].imag) < BLOCK * max(tall[i], tall[j])
            if close and left[i] < right[j] and left[j] < right[i]:
                block[block == block[i]] = block[j]
    return numpy.asarray(numpy.unique(block, return_inverse=True)[1])


def _cue(what: Callable[[Array], Array], view: Array, near: list[Array], weights: Array, groups: Indices) -> _Cue:
    """What a view makes of something that should be alike in each group, and views a little more tilted."""
    here = what(view)
    left = here - _means(here, weights, groups)[groups]
    moved = [(what(v) - here) / 1e-4 for v in near]
    slopes = numpy.stack([m - _means(m, weights, groups)[groups] for m in moved], axis=1)
    return _Cue(left, weights / (1 + left**2 * weights / CAUCHY), slopes)


def _means(values: Array, weights: Array, groups: Indices) -> Array:
    """Each group's mean."""
    return numpy.bincount(groups, weights * values) / (numpy.bincount(groups, weights) + 1e-12)


def _angles(view: Array, z: Complexes, angle: Array) -> Array:
    """Directions at places as a view has them."""
    step = numpy.exp(1j * angle)
    out: Array = numpy.angle(through(view, z + step) - through(view, z - step))
    return out


def _lengths(view: Array, z: Complexes, angle: Array) -> Array:
    """The logarithm of how much longer a view makes a short way at places."""
    step = numpy.exp(1j * angle)
    out: Array = numpy.log(abs(through(view, z + step) - through(view, z - step)) / 2)
    return out


def _slant(text: LetterRows, mine: Array) -> float:
    """The most usual way of some of the strokes' edges."""
    return _mode(text.angles[mine], KERNEL / 2, text.weights[mine]) if mine.any() else text.way + math.pi / 2


def _mode(values: Array, wide: float, weights: Array | None = None) -> float:
    """About where most of the values are."""
    some = slice(None, None, max(1, len(values) // 3000))
    steps = numpy.linspace(values.min(), values.max(), 60)
    near = numpy.exp(-0.5 * ((values[some][None, :] - steps[:, None]) / wide) ** 2)
    return float(steps[int((near @ (numpy.ones(len(values)) if weights is None else weights)[some]).argmax())])


def _strokes(text: LetterRows, upright: Array) -> tuple[Array, Array]:
    """How much each letter's strokes are turned from how they should run, and what that weighs."""
    off, count = text.angles - upright[text.of], len(text.places)
    near = text.weights * numpy.exp(-0.5 * (off / KERNEL) ** 2)
    total = numpy.bincount(text.of, near, count)
    turned = numpy.bincount(text.of, near * off, count) / (total + 1e-9)
    return turned, numpy.minimum(total / (numpy.median(total) + 1e-9), 2.0)


def _spread(values: Array, weights: Array) -> float:
    """One σ of values."""
    middle = (weights * values).sum() / (weights.sum() + 1e-9)
    return math.sqrt(float((weights * (values - middle) ** 2).sum() / (weights.sum() + 1e-9)))
