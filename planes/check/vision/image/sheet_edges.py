"""The edges of a sheet of light paper on a darker surface: its four corners, and the lens that bends them."""

import numpy

from planes.check.vision.image.bend import Bend
from planes.check.vision.image.frame import line_along, meetings, ordered
from planes.check.vision.image.opencv import cv, sampled, smaller
from planes.geometry.arrays import Array, Complexes, Greys
from planes.geometry.plane import toward

LOOK_PX = 1000
LEAST_SHARE = 0.25  # minimum share of a picture inside a sheet
PROFILES, REACH = 120, 0.012  # across each edge; distance of their ends (in longer sides of the picture)
STEP = 15.0  # minimum grey step from the table to the paper
SEEN = 0.6  # of an edge
SHARP = (20, 50)  # Canny's thresholds: a shadow's border is softer
STRAIGHT_PX = 3.0  # maximum deviation of an edge (in a picture of LOOK_PX)
LENSES = numpy.linspace(-0.08, 0.08, 33)
FAIRLY = 0.02  # a lens of this distortion is as unlikely as an edge deviating by one σ


def edges_of(grey: Greys) -> tuple[Array, float] | None:
    """Corners of the sheet in pixels, without lens distortion, and the distortion; None if the sheet is cut off.

    The order is lower left, lower right, upper right, upper left.
    """
    quad = _outline(grey)
    sides = [_edge(grey, a, b) for a, b in zip(quad, numpy.roll(quad, -1), strict=True)] if quad is not None else []
    edges = [side for side in sides if side is not None]
    if len(edges) < 4:
        return None
    unbent = Bend.about(grey.shape)
    unit = max(grey.shape) / LOOK_PX

    def crooked(k: float) -> float:
        unbent.lens = (k, 0.0)
        off = [float(_off_line(unbent.straight(z)).clip(0, STRAIGHT_PX * unit).mean()) for z in edges]
        return float(sum(off) / unit + (k / FAIRLY) ** 2 / 4)

    unbent.lens = (min(LENSES.tolist(), key=crooked), 0.0)
    return meetings([line_along(unbent.straight(side)) for side in edges]), unbent.lens[0]


def _outline(grey: Greys) -> Complexes | None:
    """The approximate corners of the sheet: the largest light area or, under a shadow, the largest with sharp edges."""
    cv2 = cv()
    small, factor = smaller(grey, LOOK_PX)
    soft = cv2.GaussianBlur(cv2.morphologyEx(small, cv2.MORPH_CLOSE, numpy.ones((9, 9), numpy.uint8)), (5, 5), 0)
    _, light = cv2.threshold(soft, 0, 255, cv2.THRESH_BINARY + cv2.THRESH_OTSU)
    quad = _quad(light)
    if quad is None:
        quad = _quad(255 - cv2.dilate(cv2.Canny(soft, *SHARP), None))
    if quad is None:
        return None
    x, y = ordered((quad + 0.5) / factor - 0.5).T
    corners: Complexes = x + 1j * y
    return corners


def _quad(inside: Greys) -> Array | None:
    """The corners of the largest area that does not touch the picture's border, if it has four."""
    cv2, rim = cv(), numpy.array(inside.shape[::-1]) - 3
    contours, _ = cv2.findContours(inside, cv2.RETR_LIST, cv2.CHAIN_APPROX_NONE)
    hulls = sorted((cv2.convexHull(c) for c in contours), key=cv2.contourArea)
    within = [h for h in hulls if (h > 1).all() and (h < rim).all()]
    if not within or cv2.contourArea(within[-1]) < LEAST_SHARE * inside.size:
        return None
    quad = cv2.approxPolyDP(within[-1], 0.03 * cv2.arcLength(within[-1], True), True).reshape(-1, 2)
    return quad.astype(float) if len(quad) == 4 else None


def _edge(grey: Greys, a: complex, b: complex) -> Complexes | None:
    """Points of an edge between two corners, where the picture gets lighter inwards; None if too few are visible."""
    reach = REACH * max(grey.shape)
    inwards = toward(a, b) * -1j  # counter-clockwise as seen, y down
    t = numpy.arange(-reach, reach + 0.1, 0.5)
    places = (a + (b - a) * numpy.linspace(0.03, 0.97, PROFILES))[:, None] + inwards * t
    soft = cv().GaussianBlur(sampled(grey, places), (7, 1), 1.5)
    rise = soft[:, 4:] - soft[:, :-4]
    best = rise.argmax(axis=1).clip(1, rise.shape[1] - 2)
    n = numpy.arange(PROFILES)
    left, top, right = rise[n, best - 1], rise[n, best], rise[n, best + 1]
    at = best + (left - right) / (2 * numpy.minimum(left - 2 * top + right, -1e-3)) + 2
    edge = places[:, 0] + inwards * 0.5 * at
    edge = edge[top > STEP]
    if len(edge) < SEEN * PROFILES:
        return None
    off = _off_line(edge)
    near = edge[off < max(STRAIGHT_PX * max(grey.shape) / LOOK_PX, 2.5 * float(numpy.median(off)))]
    return near if len(near) >= SEEN * PROFILES else None


def _off_line(places: Complexes) -> Array:
    """The distances of points from the line along most of them."""
    place, way = line_along(places)
    return abs(((places - place) * way.conjugate()).imag)
