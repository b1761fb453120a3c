"""The edges of a sheet of light paper on a darker surface: its four corners, and the lens that bends them."""

import numpy

from planes.check.vision.image.bend import Bend
from planes.check.vision.image.frame import fit_line, ordered_corners, quadrilateral, side_intersections
from planes.check.vision.image.opencv import cv, filled_square, reduce_to_longest_side, sample_greys
from planes.geometry.arrays import Array, Complexes, Greys
from planes.geometry.plane import direction_between

REDUCED_SIDE_PX = 1000
LEAST_SHEET_SHARE = 0.25  # minimum share of a picture inside a sheet
# across each edge; distance of their ends (in longer sides of the picture)
PROFILES_PER_EDGE = 120
PROFILE_REACH_SHARE = 0.012
LEAST_EDGE_GREY_STEP = 15.0  # minimum grey step from the table to the paper
LEAST_VISIBLE_EDGE_SHARE = 0.6  # of an edge
CANNY_THRESHOLDS = (20, 50)  # Canny's thresholds: a shadow's border is softer
MOST_EDGE_DEVIATION_PX = 3.0  # maximum deviation of an edge (in a picture of LOOK_PX)
LENS_DISTORTIONS = numpy.linspace(-0.08, 0.08, 33)
LENS_DISTORTION_SIGMA = 0.02  # a lens of this distortion is as unlikely as an edge deviating by one σ


def sheet_corners_and_lens(grey: Greys) -> tuple[Array, float] | None:
    """Corners of the sheet in pixels, without lens distortion, and the distortion; None if the sheet is cut off.

    The order is lower left, lower right, upper right, upper left.
    """
    quad = _approximate_corners(grey)
    sides = (
        [_edge_points(grey, a, b) for a, b in zip(quad, numpy.roll(quad, -1), strict=True)] if quad is not None else []
    )
    edges = [side for side in sides if side is not None]
    if len(edges) < 4:
        return None
    unbent = Bend.lens_centred_on(grey.shape)
    unit = max(grey.shape) / REDUCED_SIDE_PX

    def crooked(k: float) -> float:
        unbent.lens = (k, 0.0)
        off = [
            float(
                _distances_from_fitted_line(unbent.remove_lens_distortion(z))
                .clip(0, MOST_EDGE_DEVIATION_PX * unit)
                .mean()
            )
            for z in edges
        ]
        return float(sum(off) / unit + (k / LENS_DISTORTION_SIGMA) ** 2 / 4)

    unbent.lens = (min(LENS_DISTORTIONS.tolist(), key=crooked), 0.0)
    return side_intersections([fit_line(unbent.remove_lens_distortion(side)) for side in edges]), unbent.lens[0]


def _approximate_corners(grey: Greys) -> Complexes | None:
    """The approximate corners of the sheet: the largest light area or, under a shadow, the largest with sharp edges."""
    cv2 = cv()
    small, factor = reduce_to_longest_side(grey, REDUCED_SIDE_PX)
    soft = cv2.GaussianBlur(cv2.morphologyEx(small, cv2.MORPH_CLOSE, filled_square(9)), (5, 5), 0)
    _, light = cv2.threshold(soft, 0, 255, cv2.THRESH_BINARY + cv2.THRESH_OTSU)
    quad = _largest_quadrilateral(light)
    if quad is None:
        quad = _largest_quadrilateral(255 - cv2.dilate(cv2.Canny(soft, *CANNY_THRESHOLDS), None))
    if quad is None:
        return None
    x, y = ordered_corners((quad + 0.5) / factor - 0.5).T
    corners: Complexes = x + 1j * y
    return corners


def _largest_quadrilateral(inside: Greys) -> Array | None:
    """The corners of the largest area that does not touch the picture's border, if it has four."""
    cv2 = cv()
    rim = numpy.array(inside.shape[::-1]) - 3
    contours, _ = cv2.findContours(inside, cv2.RETR_LIST, cv2.CHAIN_APPROX_NONE)
    hulls = sorted((cv2.convexHull(c) for c in contours), key=cv2.contourArea)
    within = [h for h in hulls if (h > 1).all() and (h < rim).all()]
    if not within or cv2.contourArea(within[-1]) < LEAST_SHEET_SHARE * inside.size:
        return None
    return quadrilateral(within[-1], 0.03)


def _edge_points(grey: Greys, a: complex, b: complex) -> Complexes | None:
    """Points of an edge between two corners, where the picture gets lighter inwards; None if too few are visible."""
    reach = PROFILE_REACH_SHARE * max(grey.shape)
    inwards = direction_between(a, b) * -1j  # counter-clockwise as seen, y down
    t = numpy.arange(-reach, reach + 0.1, 0.5)
    places = (a + (b - a) * numpy.linspace(0.03, 0.97, PROFILES_PER_EDGE))[:, None] + inwards * t
    soft = cv().GaussianBlur(sample_greys(grey, places), (7, 1), 1.5)
    rise = soft[:, 4:] - soft[:, :-4]
    best = rise.argmax(axis=1).clip(1, rise.shape[1] - 2)
    n = numpy.arange(PROFILES_PER_EDGE)
    left, top, right = (rise[n, best + k] for k in (-1, 0, 1))
    at = best + (left - right) / (2 * numpy.minimum(left - 2 * top + right, -1e-3)) + 2
    edge = places[:, 0] + inwards * 0.5 * at
    edge = edge[top > LEAST_EDGE_GREY_STEP]
    if len(edge) < LEAST_VISIBLE_EDGE_SHARE * PROFILES_PER_EDGE:
        return None
    off = _distances_from_fitted_line(edge)
    near = edge[off < max(MOST_EDGE_DEVIATION_PX * max(grey.shape) / REDUCED_SIDE_PX, 2.5 * float(numpy.median(off)))]
    return near if len(near) >= LEAST_VISIBLE_EDGE_SHARE * PROFILES_PER_EDGE else None


def _distances_from_fitted_line(places: Complexes) -> Array:
    """The distances of points from the line along most of them."""
    place, way = fit_line(places)
    return abs(((places - place) * way.conjugate()).imag)
