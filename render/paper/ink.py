"""From marks to drawing elements: polylines, polygons, order of layers; mm of the sheet, y up.

Shared by the back-ends and by the label placing, so that all of them see the same ink.  For files without white masks
(DXF) lines are really cut under hinges and sliders.
"""

import cmath
import math
from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import groupby, pairwise

import numpy as np
import shapely

from planes.geometry.arrays import Array, Complexes
from render.paper.marks import Arc, Arrow, Hatch, Layer, Line, Mark, Polyline, Shape, Size, Text
from render.paper.style import LAYERS_FROM_LOWEST, arrowhead_corners, arrowhead_size, fit_dash_pattern, pen_of_style


def require_finite_marks(marks: Iterable[Mark], size_mm: Size) -> tuple[Mark, ...]:
    """The marks, after a check that all their numbers and the size of the sheet in mm are finite."""
    if not all(0 < side < math.inf for side in size_mm):
        sides = f"{size_mm[0]} × {size_mm[1]} mm"
        raise ValueError(f"a sheet of {sides} cannot be drawn: both sides must be above 0")
    marks = tuple(marks)
    for number, mark in enumerate(marks, start=1):
        bad = [value for value in _numbers_of_mark(mark) if not cmath.isfinite(value)]
        if bad:
            name = getattr(mark, "name", "") or getattr(mark, "text", "")
            called = f" {name!r}" if name else ""
            raise ValueError(
                f"mark {number}, {type(mark).__name__}{called} on layer {mark.layer!r}, holds {bad[0]}, "
                "which is not a place on paper; the position it was drawn from has probably failed"
            )
    return marks


def _numbers_of_mark(mark: Mark) -> tuple[complex, ...]:
    if isinstance(mark, Arc):
        return (mark.centre, mark.radius, mark.start_deg, mark.end_deg)
    if isinstance(mark, Arrow):
        return (mark.start, mark.end)
    if isinstance(mark, Text):
        return (mark.place, mark.height, mark.turn_deg)
    if isinstance(mark, Hatch):
        return (*mark.points, mark.angle_deg, mark.gap)
    return mark.points


def group_by_layer(marks: Iterable[Mark]) -> list[tuple[Layer, list[Mark]]]:
    """The marks layer by layer, from the lowest up; within a layer in the order given."""
    order = {layer: k for k, layer in enumerate(LAYERS_FROM_LOWEST)}
    held = sorted(marks, key=lambda mark: order[mark.layer])
    return [(layer, list(own)) for layer, own in groupby(held, key=lambda mark: mark.layer)]


def polyline_length_mm(points: Sequence[complex], closed: bool = False) -> float:
    """Length of a polyline in mm."""
    ends = (*points, points[0]) if closed else points
    return sum(abs(b - a) for a, b in pairwise(ends))


def is_circle(arc: Arc) -> bool:
    """Whether the arc goes all the way round."""
    return arc.end_deg - arc.start_deg >= 360 - 1e-9


def flatten_arc(arc: Arc, error_mm: float = 0.005) -> Polyline:
    """The arc as a polyline through points of it, within ``error_mm``."""
    sweep = math.radians(min(360.0, arc.end_deg - arc.start_deg))
    most = 2 * math.acos(max(0.5, 1 - error_mm / arc.radius)) if arc.radius > error_mm else 1.0
    count = max(2, math.ceil(abs(sweep) / most))
    start = math.radians(arc.start_deg)
    return tuple(arc.centre + cmath.rect(arc.radius, start + sweep * k / count) for k in range(count + 1))


def arc_dashes(arc: Arc) -> tuple[float, ...]:
    """The dash pattern of an arc in mm, fitted to its length."""
    length = arc.radius * math.radians(arc.end_deg - arc.start_deg)
    return fit_dash_pattern(pen_of_style(arc.style).pattern, length, is_circle(arc))


def arrow_parts(arrow: Arrow) -> tuple[Polyline, Polyline]:
    """The shaft (two points, ending inside the head) and the head (three points, or none if too short)."""
    span = arrow.end - arrow.start
    long, wide = arrowhead_size(abs(span), pen_of_style(arrow.style).width)
    if not long:
        return (arrow.start, arrow.end), ()
    return (arrow.start, arrow.end - 0.8 * long * span / abs(span)), arrowhead_corners(arrow.end, span, long, wide)


def hatch_strokes(hatch: Hatch) -> tuple[tuple[complex, complex], ...]:
    """The strokes of a hatched region, in order across it; neighbouring regions continue each other."""
    if hatch.gap <= 0:
        raise ValueError(f"hatching needs a gap above 0 mm between its strokes, not {hatch.gap}")
    turn = cmath.rect(1, -math.radians(hatch.angle_deg))
    level = np.array(hatch.points) * turn
    region = shapely.make_valid(shapely.polygons(xy_coordinates(level)))
    x0, y0, x1, y1 = region.bounds
    rows = hatch.gap * np.arange(math.floor(y0 / hatch.gap) + 1, math.ceil(y1 / hatch.gap))
    rays = shapely.linestrings(xy_coordinates(rows[:, None] * 1j + np.array([x0 - 1, x1 + 1])))
    parts, ray = shapely.get_parts(shapely.intersection(region, rays), return_index=True)
    lines = shapely.get_type_id(parts) == shapely.GeometryType.LINESTRING
    left, low, right, top = shapely.bounds(parts[lines]).T
    ends = np.stack([left + 1j * low, right + 1j * top], axis=1)[np.lexsort((left, ray[lines]))] / turn
    return tuple((a, b) for a, b in ends.tolist())


_SAME_PLACE_MM = 1e-6


def cut_out_shapes(lines: Iterable[Mark], hinges: Sequence[Arc | Shape]) -> tuple[Mark, ...]:
    """The lines, arcs, arrows and hatching without the pieces inside the discs of hinges (or sliders).

    A hatched region becomes lines where it is cut.  An arrow whose tip would be lost stays whole.
    """
    lines = tuple(lines)
    regions = [_hinge_region(hinge) for hinge in hinges]
    strokes = [(k, mark) for k, mark in enumerate(lines) if not isinstance(mark, (Shape, Text))]
    tracks = np.array([_line_string(_path_of_mark(mark)) for _, mark in strokes], dtype=object)
    hits: dict[int, list[int]] = {}
    for at, region in shapely.STRtree(regions).query(tracks, predicate="intersects").T.tolist():
        hits.setdefault(at, []).append(region)
    pieces = {
        strokes[at][0]: _mark_without_region(strokes[at][1], shapely.union_all([regions[k] for k in sorted(hit)]))
        for at, hit in hits.items()
    }
    return tuple(part for k, mark in enumerate(lines) for part in pieces.get(k, (mark,)))


def visible_marks(marks: Iterable[Mark]) -> tuple[Mark, ...]:
    """The marks as seen: parts under a later paper-white disc or shape are cut away.

    Paper-white discs are returned as open circles; paper-white shapes are left out.
    """
    seen: list[Mark] = []
    for _, held in group_by_layer(marks):
        for mark in held:
            if isinstance(mark, (Arc, Shape)) and mark.fill == "paper":
                seen = list(cut_out_shapes(seen, [mark]))
                if isinstance(mark, Shape):
                    continue
                mark = replace(mark, fill="none")
            seen.append(mark)
    return tuple(seen)


def xy_coordinates(places: Complexes) -> Array:
    """The coordinates of places, along a last axis."""
    return np.stack([places.real, places.imag], axis=-1)


def _line_string(points: Sequence[complex]) -> shapely.LineString:
    return shapely.linestrings(xy_coordinates(np.array(points, dtype=complex)))


def _hinge_region(hinge: Arc | Shape) -> shapely.Geometry:
    if isinstance(hinge, Arc):
        return shapely.Point(hinge.centre.real, hinge.centre.imag).buffer(hinge.radius, quad_segs=64)
    return shapely.make_valid(shapely.polygons(xy_coordinates(np.array(hinge.points))))


def _path_of_mark(mark: Line | Arc | Arrow | Hatch) -> Polyline:
    """The path that decides whether a mark meets a hinge."""
    if isinstance(mark, Arc):
        return flatten_arc(mark)
    if isinstance(mark, Arrow):
        return (mark.start, mark.end)
    strokes = tuple(z for stroke in hatch_strokes(mark) for z in stroke) if isinstance(mark, Hatch) else ()
    around = (*mark.points, mark.points[0]) if isinstance(mark, Hatch) or mark.closed else mark.points
    return strokes or around


def _pieces_outside(points: Sequence[complex], region: shapely.Geometry) -> list[Polyline]:
    """The pieces of a path outside the region, in order along it."""
    path = _line_string(points)
    parts = [part for part in shapely.get_parts(path.difference(region)) if part.length > _SAME_PLACE_MM]
    parts.sort(key=lambda part: path.project(part.interpolate(0.5, normalized=True)))
    return [tuple(complex(x, y) for x, y in part.coords) for part in parts]


def _mark_without_region(mark: Line | Arc | Arrow | Hatch, region: shapely.Geometry) -> list[Mark]:
    if isinstance(mark, Line):
        return [
            Line(piece, mark.style, mark.layer)
            for piece in _join_closed_pieces(_pieces_outside(_path_of_mark(mark), region), mark.closed)
        ]
    if isinstance(mark, Arc):
        return _arc_pieces(mark, region)
    if isinstance(mark, Arrow):
        return _arrow_pieces(mark, region)
    strokes = [piece for stroke in hatch_strokes(mark) for piece in _pieces_outside(stroke, region)]
    return [Line(piece, "thin", mark.layer) for piece in strokes]


def _join_closed_pieces(pieces: list[Polyline], closed: bool) -> list[Polyline]:
    """The pieces of a closed line, the last one joined to the first at the start of the line."""
    if closed and len(pieces) > 1 and abs(pieces[-1][-1] - pieces[0][0]) < _SAME_PLACE_MM:
        return [pieces[-1] + pieces[0][1:], *pieces[1:-1]]
    return pieces


def _arc_pieces(arc: Arc, region: shapely.Geometry) -> list[Mark]:
    pieces = _join_closed_pieces(_pieces_outside(flatten_arc(arc), region), is_circle(arc))
    arcs: list[Mark] = []
    for piece in pieces:
        start, end = (math.degrees(cmath.phase(z - arc.centre)) for z in (piece[0], piece[-1]))
        start = arc.start_deg + (start - arc.start_deg + 1e-6) % 360 - 1e-6
        arcs.append(replace(arc, start_deg=start, end_deg=start + ((end - start) % 360 or 360.0), fill="none"))
    return arcs


def _arrow_pieces(arrow: Arrow, region: shapely.Geometry) -> list[Mark]:
    *tail, last = _pieces_outside((arrow.start, arrow.end), region) or [(arrow.start, arrow.start)]
    if abs(last[-1] - arrow.end) > _SAME_PLACE_MM:
        return [arrow]
    return [*(Line(piece, arrow.style, arrow.layer) for piece in tail), replace(arrow, start=last[0])]
