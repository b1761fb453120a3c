"""Finds a sheet without corner marks by its printed frame: the four lines, the format, the rectified view.

The frame of ГОСТ 2.301 sheets is 20 mm from the left edge and 5 mm from the others, so the ratio of its sides gives
the orientation of the sheet and, less surely, its format; several formats may have to be tried.
"""

import math
from collections.abc import Iterator, Sequence

import numpy
from numpy.linalg import det, norm

from planes.check.fiducials import Size
from planes.check.vision.image.bend import FRAME_LEFT_MM, FRAME_OTHER_SIDES_MM, PX_PER_MM
from planes.check.vision.image.opencv import cv, pairs, reduce_to_longest_side, sample_greys
from planes.check.vision.image.picture import LARGEST_SIDE_PX, Flat
from planes.geometry.arrays import Array, Complexes, Greys
from planes.geometry.plane import intersect_lines

PAPER_SIZES_MM = {"A4": (297.0, 210.0), "A3": (420.0, 297.0), "A2": (594.0, 420.0), "A1": (841.0, 594.0)}  # landscape
LEAST_FRAME_SHARE = 0.2  # minimum share of the picture inside a frame
# relative difference of frame shapes, straight or oblique, for formats to be tried
FRAME_RATIO_TOLERANCES = (0.004, 0.15)
REDUCED_SIDE_PX = 2000
Line = tuple[complex, complex]  # a point and a direction


def rectify_by_frame(grey: Greys, paper: str | None = None) -> Iterator[Flat]:
    """The sheet rectified by its frame, for every possible format (only ``paper`` if named), the likeliest first.

    Nothing if there is no frame.
    """
    corners = frame_corners(grey)
    if corners is None:
        return
    ratio, askew = aspect_ratio_and_obliqueness(corners, grey.shape)
    fits = sorted(
        (abs(math.log(ratio * (h - 2 * FRAME_OTHER_SIDES_MM) / (w - FRAME_LEFT_MM - FRAME_OTHER_SIDES_MM))), name, w, h)
        for name, sides in PAPER_SIZES_MM.items()
        for w, h in (sides, sides[::-1])
    )
    named = [f for f in fits if f[1] == paper][:1]
    likely = [f for f in fits if f[0] < FRAME_RATIO_TOLERANCES[askew]]
    for _, _, w, h in likely if paper is None else named:
        yield _sheet_from_above(grey, corners, (w, h))


def frame_corners(grey: Greys) -> Array | None:
    """Corners of the frame in pixels: lower left, lower right, upper right, upper left; None if there is none."""
    cv2 = cv()
    small, factor = reduce_to_longest_side(grey, REDUCED_SIDE_PX)
    dark = cv2.adaptiveThreshold(small, 255, cv2.ADAPTIVE_THRESH_MEAN_C, cv2.THRESH_BINARY_INV, 31, 7)
    dark = cv2.morphologyEx(dark, cv2.MORPH_CLOSE, None)
    contours, _ = cv2.findContours(dark, cv2.RETR_LIST, cv2.CHAIN_APPROX_NONE)
    quads = []
    for contour in contours:
        hull = cv2.convexHull(contour)
        area = cv2.contourArea(hull)
        if area > LEAST_FRAME_SHARE * small.size and cv2.contourArea(contour) > 0.9 * area:
            quad = quadrilateral(hull, 0.02)
            if quad is not None:
                quads.append((area, quad))
    quads.sort(key=lambda q: q[0])
    refined = (_refined_corners(grey, ordered_corners((quad + 0.5) / factor - 0.5), 3.0 / factor) for _, quad in quads)
    return next((c for c in refined if c is not None), None)  # the innermost dark line: the paper's edge is none


def quadrilateral(hull: Array, tolerance: float) -> Array | None:
    """The corners of a convex outline that is one, to this share of its length."""
    cv2 = cv()
    quad = cv2.approxPolyDP(hull, tolerance * cv2.arcLength(hull, True), True)
    return quad.reshape(4, 2).astype(float) if len(quad) == 4 else None


def ordered_corners(quad: Array) -> Array:
    """Lower left first, counter-clockwise as seen, for a picture that is nearly upright."""
    x, y = (quad - quad.mean(axis=0)).T
    quad = quad[numpy.argsort(numpy.arctan2(-y, x))]
    return numpy.roll(quad, -int(numpy.argmin(quad[:, 0] - quad[:, 1])), axis=0)


def _refined_corners(grey: Greys, quad: Array, reach: float) -> Array | None:
    """Corners at the intersections of the frame's line centres; None if a side is no line with paper on both sides."""
    sides = []
    t = numpy.arange(-2 * reach, 2 * reach + 0.1, 0.5)
    ends = quad @ [1, 1j]
    for a, b in zip(ends, numpy.roll(ends, -1), strict=True):
        across = 1j * (b - a) / abs(b - a)
        places = a + numpy.linspace(0.03, 0.97, 200) * (b - a)
        seen = 255.0 - sample_greys(grey, places[:, None] + across * t)
        base = numpy.maximum(seen[:, :4].mean(axis=1), seen[:, -4:].mean(axis=1))[:, None]
        depth = seen.max(axis=1)[:, None] - base
        line = numpy.maximum(seen - base - 0.35 * depth, 0)
        good = depth[:, 0] > 15
        if good.mean() < 0.5:
            return None
        middle = (line * t).sum(axis=1) / numpy.maximum(line.sum(axis=1), 1e-6)
        sides.append(fit_line((places + middle * across)[good]))
    return side_intersections(sides)


def fit_line(places: Complexes) -> Line:
    """The line along most of some points: one of the points, and its direction."""
    vx, vy, x, y = cv().fitLine(pairs(places).astype(numpy.float32), cv().DIST_HUBER, 0, 0.01, 0.001).ravel().tolist()
    return complex(x, y), complex(vx, vy)


def side_intersections(sides: Sequence[Line]) -> Array:
    """The intersections of each side of a figure with the one before it."""
    before = zip([sides[-1], *sides[:-1]], sides, strict=True)
    return pairs(numpy.array([intersect_lines(*one, *two)[0] for one, two in before]))


def aspect_ratio_and_obliqueness(corners: Array, size_px: tuple[int, int]) -> tuple[float, bool]:
    """Width over height of a rectangle, and whether it is seen obliquely by a camera aimed at the picture's centre.

    The focal length follows from the two vanishing points; where the view is nearly straight, the sides are compared.
    (Zhang and He, Whiteboard scanning and image enhancement, 2007.)
    """
    middle = numpy.array([size_px[1] / 2, size_px[0] / 2])
    ll, lr, ur, ul = (numpy.append(c - middle, 1.0) for c in corners)
    k2, k3 = (det([ll, ur, one]) / det([two, ur, one]) for one, two in ((ul, lr), (lr, ul)))
    n2 = k2 * lr - ll
    n3 = k3 * ul - ll
    lower, upper, left, right = (norm(a - b) for a, b in ((ll, lr), (ul, ur), (ll, ul), (lr, ur)))
    plain = float((lower + upper) / (left + right))
    if max(abs(k2 - 1), abs(k3 - 1)) < 0.003:
        return plain, False
    lens = -(n2[:2] @ n3[:2]) / (n2[2] * n3[2] or math.nan)
    if not 0.3 < lens / max(size_px) ** 2 < 9:
        return plain, True
    across, up = (n[:2] @ n[:2] / lens + n[2] ** 2 for n in (n2, n3))
    return math.sqrt(across / up), True


def _sheet_from_above(grey: Greys, corners: Array, size_mm: Size) -> Flat:
    """The sheet from above."""
    cv2 = cv()
    w, h = size_mm
    scale = min(PX_PER_MM, LARGEST_SIDE_PX / max(w, h))
    right = w - FRAME_OTHER_SIDES_MM
    top = h - FRAME_OTHER_SIDES_MM
    true = [(FRAME_LEFT_MM, FRAME_OTHER_SIDES_MM), (right, FRAME_OTHER_SIDES_MM), (right, top), (FRAME_LEFT_MM, top)]
    goal = numpy.array([(x * scale, (h - y) * scale) for x, y in true], numpy.float32)
    warp = cv2.getPerspectiveTransform(corners.astype(numpy.float32), goal)
    size = round(w * scale), round(h * scale)
    flat = cv2.warpPerspective(grey, warp, size, flags=cv2.INTER_CUBIC, borderMode=cv2.BORDER_REPLICATE)
    return Flat(flat, scale, 0j, "frame", warp)
