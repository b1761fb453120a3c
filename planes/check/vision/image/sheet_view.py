"""The view of a sheet without our print: by its squares, otherwise its ruling, its edges, or lines of text on it.

Squares determine all of it, including millimetres. Equally spaced lines give the horizon of the sheet's plane; only the
focal length remains open, which is similar for all phones. Edges give a rectangle, with the paper's format as its
shape. Text gives the tilt, but no millimetres.
"""

import cmath
import math

import numpy

from planes.check.vision.image.bend import Bend, apply_homography
from planes.check.vision.image.frame import aspect_ratio_and_obliqueness
from planes.check.vision.image.lens import MOST_TILT_DEG, PHONE_FOCAL_LENGTH, UNKNOWN_TILT, CameraTilt, levelled_view
from planes.check.vision.image.opencv import cv, pairs
from planes.check.vision.image.ruling import LEAST_CLEAR_WINDOWS, LEAST_WAVE_STRENGTH, Wave, count_ruling_lines
from planes.check.vision.image.sheet_edges import sheet_corners_and_lens
from planes.check.vision.image.text_view import tilt_by_text
from planes.geometry.arrays import Array, Complexes, Greys
from planes.words.frozen import frozen, replace

SQUARE_SIDE_MM, LINE_SPACING_MM = 5.0, 8.0
# minimum share of clear windows that agree, to this share of the line spacing
LEAST_AGREEING_SHARE = 0.6
LINE_COUNT_TOLERANCE = 0.12
LENS_DISTORTIONS = numpy.linspace(-0.08, 0.08, 17)
# significance of a tilt from text, σ, and its minimum
LEAST_TILT_SIGNIFICANCE = 4.5
LEAST_TILT_SLOPE = math.tan(math.radians(2.0))
SMALL_TILT_SIGMA = math.tan(math.radians(3.0))  # σ of a tilt that text shows to be small
A_FORMAT_RATIO, A_FORMAT_LOG_TOLERANCE, A4_MM = math.sqrt(2), 0.03, (297.0, 210.0)


@frozen
class SheetView:
    """The mapping from pixels of a picture to its sheet, mm (y down, any origin), and its reference."""

    bend: Bend
    by: str  # "squares", "lines", "edges"; "text" or the "plan" itself, without scale
    tilt_deg: float  # of the camera from straight above
    held: CameraTilt = UNKNOWN_TILT  # of a view without scale: the correction, and the possible remainder


def sheet_view(grey: Greys, px_per_mm: float, scanned: bool, focal: float = PHONE_FOCAL_LENGTH) -> SheetView | None:
    """The view of a sheet by the best reference.

    Pixels per millimetre are only roughly known; the focal length is ``focal`` of the picture's longer side.
    """
    across, down = count_ruling_lines(grey, px_per_mm * SQUARE_SIDE_MM)
    if across and down and (view := _view_by_squares(grey, across, down)):
        return view
    _, down = count_ruling_lines(grey, px_per_mm * LINE_SPACING_MM)
    if down and (view := _view_by_lines(grey, down, focal)):
        return view
    if scanned:
        return None
    return _view_by_edges(grey) or _view_by_text(grey, focal)


def _view_by_squares(grey: Greys, across: Wave, down: Wave) -> SheetView | None:
    """From counted squares; the lens makes their lines straightest."""
    clear = (across.clear > LEAST_WAVE_STRENGTH) & (down.clear > LEAST_WAVE_STRENGTH)
    if clear.sum() < LEAST_CLEAR_WINDOWS:
        return None
    seen, true = across.places[clear], numpy.empty(int(clear.sum()), numpy.complex128)
    true.real = SQUARE_SIDE_MM * across.counts[clear]
    true.imag = SQUARE_SIDE_MM * down.counts[clear]
    warp, agree = cv().findHomography(pairs(seen), pairs(true), cv().RANSAC, LINE_COUNT_TOLERANCE * SQUARE_SIDE_MM)
    good = agree.ravel() > 0
    if warp is None or good.sum() < max(LEAST_CLEAR_WINDOWS, LEAST_AGREEING_SHARE * len(good)):
        return None

    def fitted(lens: float) -> tuple[float, Bend]:
        bend = Bend.lens_centred_on(grey.shape, lens)
        bend.view, _ = cv().findHomography(pairs(bend.remove_lens_distortion(seen[good])), pairs(true[good]))
        return float((abs(bend.to_rectified(seen[good]) - true[good]) ** 2).mean()), bend

    return _view_if_plausible(min((fitted(k) for k in LENS_DISTORTIONS.tolist()), key=lambda one: one[0])[1], "squares")


def _view_by_lines(grey: Greys, down: Wave, focal: float) -> SheetView | None:
    """From the horizon of equally spaced lines, through the lens that makes them straightest."""
    clear = down.clear > LEAST_WAVE_STRENGTH
    seen, counts, bend = down.places[clear], down.counts[clear], Bend.lens_centred_on(grey.shape)
    unit = max(grey.shape)

    def horizon(lens: float) -> tuple[float, complex, Array]:
        bend.lens = lens, 0.0
        there = (bend.remove_lens_distortion(seen) - bend.middle) / unit
        tilt, off = _fit_horizon(there, counts)
        return float(numpy.minimum(abs(off), LINE_COUNT_TOLERANCE).mean()), tilt, off

    _, tilt, off, bend.lens = min(((*horizon(k), (k, 0.0)) for k in LENS_DISTORTIONS.tolist()), key=lambda one: one[0])
    good = abs(off) < LINE_COUNT_TOLERANCE
    plain = levelled_view(bend.middle, focal * unit, tilt * focal)
    if plain is None or good.sum() < max(LEAST_CLEAR_WINDOWS, LEAST_AGREEING_SHARE * len(good)):
        return None
    there = apply_homography(plain, bend.remove_lens_distortion(seen[good]))
    base = numpy.stack([there.real, there.imag, numpy.ones(len(there))], axis=1)
    gx, gy, _ = numpy.linalg.lstsq(base, counts[good], rcond=None)[0].tolist()
    turn = complex(gx, gy) / 1j * LINE_SPACING_MM  # lines to one of its pixels, downwards
    bend.view = similarity_homography(turn.conjugate()) @ plain
    return _view_if_plausible(bend, "lines", focal)


def _fit_horizon(places: Complexes, counts: Array) -> tuple[complex, Array]:
    """Fits line counts by a fraction whose denominator is zero at the horizon.

    The result is its slopes (with 1 in the picture's middle), and the residual of each count.
    """
    x = places.real
    y = places.imag
    one = numpy.ones(len(places))
    weight = numpy.ones(len(places))
    for _ in range(12):
        rows = numpy.stack([x, y, one, -counts * x, -counts * y], axis=1) * weight[:, None]
        a, b, c, d, e = numpy.linalg.lstsq(rows, counts * weight, rcond=None)[0].tolist()
        off: Array = (a * x + b * y + c) / (d * x + e * y + 1) - counts
        weight = 1 / (1 + (off / (0.5 * LINE_COUNT_TOLERANCE)) ** 2)
    return complex(d, e), off


def _view_by_edges(grey: Greys) -> SheetView | None:
    """From an A4 sheet that is fully visible."""
    corners_and_lens = sheet_corners_and_lens(grey)
    if corners_and_lens is None:
        return None
    corners, lens = corners_and_lens
    ratio = aspect_ratio_and_obliqueness(corners, grey.shape)[0]
    if abs(abs(math.log(ratio)) - math.log(A_FORMAT_RATIO)) > A_FORMAT_LOG_TOLERANCE:
        return None
    w, h = A4_MM if ratio > 1 else A4_MM[::-1]
    goal = numpy.array([(0, h), (w, h), (w, 0), (0, 0)], numpy.float32)
    bend = Bend.lens_centred_on(grey.shape, lens)
    bend.view = cv().getPerspectiveTransform(corners.astype(numpy.float32), goal)
    return _view_if_plausible(bend, "edges")


def similarity_homography(turn: complex, move: complex = 0j) -> Array:
    """Points multiplied by a complex number, then moved, as a homography."""
    return numpy.array([[turn.real, -turn.imag, move.real], [turn.imag, turn.real, move.imag], [0, 0, 1.0]])


def _view_by_text(grey: Greys, focal: float) -> SheetView | None:
    """From lines of text; if these show no certain tilt, the view from straight above, with the possible tilt."""
    held = tilt_by_text(grey, focal)
    if held is None:
        return None
    if held.tilt_significance < LEAST_TILT_SIGNIFICANCE or abs(held.slopes) < LEAST_TILT_SLOPE:
        left = [math.hypot(1, (held.slopes * way.conjugate()).real / abs(way) ** 2) * way for way in held.loose]
        known = max(abs(way) for way in left) < SMALL_TILT_SIGMA
        held = CameraTilt(0j, (left[0], left[1]) if known else UNKNOWN_TILT.loose, held.turn)
    return view_by_tilt(grey, held, focal, "text")


def view_by_tilt(grey: Greys, held: CameraTilt, focal: float, by: str = "plan") -> SheetView | None:
    """The view of a camera with this tilt (slopes to the right and down), without scale, its rotation corrected."""
    bend = Bend.lens_centred_on(grey.shape)
    back = cmath.rect(1, -held.turn)
    plain = levelled_view(bend.middle, focal * max(grey.shape), held.slopes * back.conjugate())
    if plain is None:
        return None
    bend.view = similarity_homography(back) @ plain
    seen = _view_if_plausible(bend, by, focal)
    return seen and replace(seen, held=held)


def _view_if_plausible(bend: Bend, by: str, focal: float = PHONE_FOCAL_LENGTH) -> SheetView | None:
    """The view with the camera tilt; None if no camera is held like that."""
    focal *= 2 * max(bend.middle.real, bend.middle.imag)
    a, b, c = bend.view[2].tolist()
    slope = abs(complex(a, b)) * focal / abs(a * bend.middle.real + b * bend.middle.imag + c)
    tilt = math.degrees(math.atan(slope))
    return SheetView(bend, by, tilt) if tilt < MOST_TILT_DEG else None
