"""Lines really cut under hinges and sliders, for files where a paper-white disc hides nothing (DXF)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Sequence
from dataclasses import replace

import shapely

from render.paper.ink import by_layer, flattened, hatch_strokes, is_circle
from render.paper.marks import Arc, Arrow, Hatch, Line, Mark, Shape, Text

Piece = tuple[complex, ...]
_SAME_MM = 1e-6


def cut(lines: Iterable[Mark], hinges: Sequence[Arc | Shape]) -> tuple[Mark, ...]:
    """The lines, arcs, arrows and hatching without the pieces inside the hinges' discs (or sliders).

    A hatched region becomes lines where it is cut.  An arrow whose tip would be lost stays whole.
    """
    lines = tuple(lines)
    regions = [_region(hinge) for hinge in hinges]
    tree = shapely.STRtree(regions)
    done: list[Mark] = []
    for mark in lines:
        if isinstance(mark, (Shape, Text)):
            done.append(mark)
            continue
        hit = sorted(int(k) for k in tree.query(_line(_track(mark)), predicate="intersects"))
        done.extend(_without(mark, shapely.union_all([regions[k] for k in hit])) if hit else (mark,))
    return tuple(done)


def uncovered(marks: Iterable[Mark]) -> tuple[Mark, ...]:
    """The marks as they are seen: what lies under a later paper-white disc or shape is cut away.

    Paper-white discs come back as open circles; paper-white shapes are left out.
    """
    seen: list[Mark] = []
    for _, held in by_layer(marks):
        for mark in held:
            if isinstance(mark, (Arc, Shape)) and mark.fill == "paper":
                seen = list(cut(seen, [mark]))
                if isinstance(mark, Shape):
                    continue
                mark = replace(mark, fill="none")
            seen.append(mark)
    return tuple(seen)


def _line(points: Sequence[complex]) -> shapely.LineString:
    return shapely.LineString([(z.real, z.imag) for z in points])


def _region(hinge: Arc | Shape) -> shapely.Geometry:
    if isinstance(hinge, Arc):
        return shapely.Point(hinge.centre.real, hinge.centre.imag).buffer(hinge.radius, quad_segs=64)
    return shapely.make_valid(shapely.Polygon([(z.real, z.imag) for z in hinge.points]))


def _track(mark: Line | Arc | Arrow | Hatch) -> Piece:
    """The path that decides whether a mark meets a hinge."""
    if isinstance(mark, Arc):
        return flattened(mark)
    if isinstance(mark, Arrow):
        return (mark.start, mark.end)
    if isinstance(mark, Line) and not mark.closed:
        return mark.points
    if isinstance(mark, Hatch):
        return tuple(z for stroke in hatch_strokes(mark) for z in stroke) or (*mark.points, mark.points[0])
    return (*mark.points, mark.points[0])


def _left(points: Sequence[complex], region: shapely.Geometry) -> list[Piece]:
    """The pieces of a path outside the region, in order along it."""
    path = _line(points)
    parts = [part for part in shapely.get_parts(path.difference(region)) if part.length > _SAME_MM]
    parts.sort(key=lambda part: path.project(part.interpolate(0.5, normalized=True)))
    return [tuple(complex(x, y) for x, y in part.coords) for part in parts]


def _without(mark: Line | Arc | Arrow | Hatch, region: shapely.Geometry) -> list[Mark]:
    if isinstance(mark, Line):
        return [Line(piece, mark.style, mark.layer) for piece in _joined(_left(_track(mark), region), mark.closed)]
    if isinstance(mark, Arc):
        return _arc_pieces(mark, region)
    if isinstance(mark, Arrow):
        return _arrow_pieces(mark, region)
    strokes = [piece for stroke in hatch_strokes(mark) for piece in _left(stroke, region)]
    return [Line(piece, "thin", mark.layer) for piece in strokes]


def _joined(pieces: list[Piece], closed: bool) -> list[Piece]:
    """The pieces of a closed line, the last run together with the first where the line was begun."""
    if closed and len(pieces) > 1 and abs(pieces[-1][-1] - pieces[0][0]) < _SAME_MM:
        return [pieces[-1] + pieces[0][1:], *pieces[1:-1]]
    return pieces


def _arc_pieces(arc: Arc, region: shapely.Geometry) -> list[Mark]:
    pieces = _joined(_left(flattened(arc), region), is_circle(arc))
    found: list[Mark] = []
    for piece in pieces:
        start, end = (math.degrees(cmath.phase(z - arc.centre)) for z in (piece[0], piece[-1]))
        start = arc.start_deg + (start - arc.start_deg + 1e-6) % 360 - 1e-6
        found.append(replace(arc, start_deg=start, end_deg=start + ((end - start) % 360 or 360.0), fill="none"))
    return found


def _arrow_pieces(arrow: Arrow, region: shapely.Geometry) -> list[Mark]:
    *tail, last = _left((arrow.start, arrow.end), region) or [(arrow.start, arrow.start)]
    if abs(last[-1] - arrow.end) > _SAME_MM:
        return [arrow]
    return [*(Line(piece, arrow.style, arrow.layer) for piece in tail), replace(arrow, start=last[0])]
