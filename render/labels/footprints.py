"""The ink of marks as shapely shapes, and the overlaps of labels and strokes; all in mm of the sheet."""

from collections.abc import Callable, Iterable, Sequence
from functools import cached_property

import numpy as np
import shapely

from planes.geometry.arrays import Array, Booleans, Complexes, Indices
from planes.words.frozen import frozen
from render.labels.nearness import Edges, Shapes, edges_of_shapes
from render.paper.boxes import box_around_lines
from render.paper.ink import arrow_parts, flatten_arc, is_circle, xy_coordinates
from render.paper.marks import Arrow, Hatch, Line, Mark, Polyline, Shape, Text
from render.paper.style import pen_of_style
from render.paper.typeset import text_box_corners

Bounds = tuple[float, float, float, float]
"""x0, y0, x1, y1 in mm."""

BOX_SHRINKAGE_MM = 0.01
CHORDS_PER_PIECE = 10  # chords of a curve in one shape


@frozen
class InkedShapes:
    """Shapes and half the pen width of each: a point within that distance of the shape is inked."""

    shapes: Shapes
    halves: Array

    @cached_property
    def spatial_index(self) -> shapely.STRtree:
        """The shapes in a spatial index."""
        return shapely.STRtree(self.shapes)

    @cached_property
    def shape_edges(self) -> Edges:
        """The edges of the shapes."""
        return edges_of_shapes(self.shapes, self.halves)

    def pairs_within(self, areas: Shapes, clear: float) -> Indices:
        """Pairs (index of the area, index of the shape) with less than ``clear`` mm between them."""
        x0, y0, x1, y1 = shapely.bounds(areas).T
        most = clear + float(self.halves.max(initial=0.0))
        pairs = self.spatial_index.query(shapely.box(x0 - most, y0 - most, x1 + most, y1 + most))
        apart = shapely.distance(areas[pairs[0]], self.shapes[pairs[1]]) - self.halves[pairs[1]]
        close_pairs: Indices = pairs[:, apart <= clear]
        return close_pairs


def inked_shapes(marks: Iterable[Mark]) -> InkedShapes:
    """The ink of marks; texts count as their boxes, hatched regions and filled shapes as areas, curves as short pieces,
    so that neighbours are found sooner."""
    parts = list(map(_pen_lines_and_areas, marks))
    strokes = [
        (line[k : k + CHORDS_PER_PIECE + 1], half)
        for half, lines, _ in parts
        for line in lines
        for k in _piece_starts(line)
    ]
    areas = make_polygons([area for _, _, filled in parts for area in filled])
    shapes = np.concatenate([_make_geometries([line for line, _ in strokes], shapely.linestrings), areas])
    return InkedShapes(shapes, np.array([half for _, half in strokes] + [0.0] * len(areas)))


def _piece_starts(line: Polyline) -> range:
    """Where the pieces of a line begin, each with so many chords."""
    return range(0, max(1, len(line) - 1), CHORDS_PER_PIECE)


def box_around_marks(marks: Iterable[Mark]) -> Bounds:
    """The box around all ink of the marks; of zero size without marks."""
    parts = list(map(_pen_lines_and_areas, marks))
    edges = [(line, half) for half, lines, _ in parts for line in lines]
    return box_around_lines([*edges, *((area, 0.0) for _, _, filled in parts for area in filled)])


def _pen_lines_and_areas(mark: Mark) -> tuple[float, list[Polyline], list[Polyline]]:
    """Half the pen width, the lines and the areas of a mark."""
    if isinstance(mark, Text):
        corners = text_box_corners(mark)
        return 0.0, [], [corners] if corners[0] != corners[2] else []
    if isinstance(mark, (Shape, Hatch)):
        return 0.0, [], [mark.points]
    half = pen_of_style(mark.style).width / 2
    if isinstance(mark, Arrow):
        shaft, head = arrow_parts(mark)
        return half, [shaft], [head] if head else []
    if isinstance(mark, Line):
        return half, [(*mark.points, mark.points[0]) if mark.closed else mark.points], []
    round_ = flatten_arc(mark, 0.02)
    filled = mark.fill != "none" and is_circle(mark)
    return half, [round_], [round_] if filled else []


def _make_geometries(paths: Sequence[Polyline], made: Callable[..., Shapes]) -> Shapes:
    """Lines or rings through complex points."""
    if not paths:
        return np.array([], dtype=object)
    flat = np.array([z for path in paths for z in path])
    owners = np.repeat(np.arange(len(paths)), [len(path) for path in paths])
    return made(xy_coordinates(flat), indices=owners)


def make_polygons(areas: Sequence[Polyline]) -> Shapes:
    """Polygons with complex corners."""
    return np.array(shapely.polygons(_make_geometries(areas, shapely.linearrings)), dtype=object)


def box_gaps(boxes: Array, others: Array) -> tuple[Array, Array]:
    """The distances of boxes (rows) from others (columns), horizontally and vertically; negative where they overlap."""
    x0, y0, x1, y1 = (side[:, None] for side in boxes.T)
    left, low, right, top = (side[None, :] for side in others.T)
    return np.maximum(x0 - right, left - x1), np.maximum(y0 - top, low - y1)


def _starts_and_spans(lines: Complexes) -> tuple[Complexes, Complexes]:
    return lines[..., 0], lines[..., 1] - lines[..., 0]


def segments_cross_boxes(boxes: Array, lines: Complexes) -> Booleans:
    """Whether segments (…, 2; complex) pass through boxes (…, 4), by broadcasting; NaN passes through none."""
    start, span = _starts_and_spans(lines)
    enter = np.zeros(np.broadcast_shapes(start.shape, boxes.shape[:-1]))
    leave = enter + 1.0
    with np.errstate(divide="ignore", invalid="ignore"):
        for low, high, origin, step in (
            (boxes[..., 0], boxes[..., 2], start.real, span.real),
            (boxes[..., 1], boxes[..., 3], start.imag, span.imag),
        ):
            safe = np.where(step == 0, 1e-12, step)
            one = (low - origin) / safe
            two = (high - origin) / safe
            enter = np.maximum(enter, np.minimum(one, two))
            leave = np.minimum(leave, np.maximum(one, two))
    return enter < leave


def segments_meet(lines: Complexes, others: Complexes) -> Booleans:
    """Whether segments (…, 2; complex) meet others, by broadcasting; including collinear ones that overlap."""
    start, span = _starts_and_spans(lines)
    began, way = _starts_and_spans(others)
    across = (span.conjugate() * way).imag
    safe = np.where(across == 0, np.inf, across)
    apart = began - start
    on_line = (apart.conjugate() * way).imag / safe
    on_other = (apart.conjugate() * span).imag / safe
    inside = (on_line >= -0.02) & (on_line <= 1.02) & (on_other >= -0.02) & (on_other <= 1.02)
    there: Booleans = (
        (inside & (across != 0))
        | _overlap_on_one_line(start, span, began, way)
        | _overlap_on_one_line(began, way, start, span)
    )
    return there


def _overlap_on_one_line(start: Complexes, span: Complexes, began: Complexes, way: Complexes) -> Booleans:
    """Whether the second segments lie on the line of the first, and beside them."""
    unit = span / np.abs(span)
    one = (began - start) * unit.conjugate()
    two = (began + way - start) * unit.conjugate()
    along = (np.maximum(one.real, two.real) >= -0.3) & (np.minimum(one.real, two.real) <= np.abs(span) + 0.3)
    return (np.abs(one.imag) < 0.3) & (np.abs(two.imag) < 0.3) & along


def _shrink_box(box: Polyline) -> Polyline:
    """The corners of a box minimally smaller than it."""
    along, up = (BOX_SHRINKAGE_MM * (z - box[0]) / abs(z - box[0]) for z in (box[1], box[3]))
    return box[0] + along + up, box[1] - along + up, box[2] - along - up, box[3] + along - up


def overprinted_labels(marks: Sequence[Mark]) -> list[str]:
    """Labels that touch another label, or any stroke except their own bars."""
    held = [m for m in marks if not (isinstance(m, Line) and m.layer == "text" and m.name != "leader")]
    areas = {m: _pen_lines_and_areas(m)[2] for m in held if isinstance(m, Text)}
    texts = [m for m, area in areas.items() if area]
    rest = inked_shapes([m for m in held if not isinstance(m, Text)])
    boxes = make_polygons([_shrink_box(areas[m][0]) for m in texts])
    one, other = shapely.STRtree(boxes).query(boxes, predicate="intersects")
    struck = rest.pairs_within(boxes, 0.0)[0].tolist() if len(rest.shapes) and texts else []
    return [texts[k].text for k in sorted({*one[one != other].tolist(), *struck})]
