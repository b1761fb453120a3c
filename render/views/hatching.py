"""Hatching of the similar triangles of a plan: thin strokes across them, none nearly parallel to a side."""

import cmath
import math
from collections.abc import Iterable, Sequence
from itertools import pairwise

import shapely

from render.paper.ink import hatch_strokes
from render.paper.marks import Hatch, Line
from render.views.plotted import polygon_corners

# triangles: least radius, stroke spacing, distance to sides
LEAST_HATCHED_RADIUS_MM = 6.0
HATCH_SPACING_MM = 3.5
HATCH_SIDE_GAP_MM = 1.0
MOST_PARALLEL_DEG = 12.0  # angle to a side within which strokes look parallel to it


def hatch_triangles(triangles: Iterable[tuple[complex, complex, complex]]) -> list[Line]:
    """Thin strokes in the similar triangles that do not overlap, and are large enough for some."""
    kept = list[shapely.Polygon]()
    for corners in triangles:
        area = shapely.Polygon([(z.real, z.imag) for z in corners])
        if 2 * area.area > LEAST_HATCHED_RADIUS_MM * area.length and all(
            area.intersection(one).area < 0.1 * area.area for one in kept
        ):
            kept.append(area)
    strokes = []
    for area in kept:
        if inner := tuple(polygon_corners(area.buffer(-HATCH_SIDE_GAP_MM, join_style="mitre"))):
            hatch = Hatch(inner, _hatching_angle(polygon_corners(area)), HATCH_SPACING_MM)
            strokes += [Line(z, "thin", "hatch") for z in hatch_strokes(hatch)]
    return [one for one in strokes if abs(one.points[1] - one.points[0]) > HATCH_SPACING_MM]


def _hatching_angle(corners: Sequence[complex]) -> float:
    """The angle of hatching: 45°, or the next that is not nearly parallel to a side of the triangle, degrees."""
    sides = [math.degrees(cmath.phase(b - a)) for a, b in pairwise((*corners, corners[0]))]
    away = {turn: min(abs((turn - side + 90) % 180 - 90) for side in sides) for turn in (45.0, 135.0, 30.0, 60.0)}
    return next((turn for turn, least in away.items() if least > MOST_PARALLEL_DEG), 45.0)
