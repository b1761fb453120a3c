"""The number of shapes near each of many boxes; all in mm of the sheet.

Boxes are processed in runs of neighbours, so that most edges are ruled out for a whole run at once. For the others the
distance follows from the axes that can separate a box and an edge: horizontal, vertical, and normal to the edge.
"""

from collections.abc import Sequence
from functools import cached_property

import numpy as np
import shapely
from numpy.typing import NDArray

from planes.geometry.arrays import Array, Booleans, Indices
from planes.words.frozen import frozen

BOXES_PER_RUN = 24  # boxes per run
STRIP_WIDTH_MM = 8.0  # width of the strips in which they are taken
BOXES_PER_BATCH = 4000  # boxes processed together
ROUNDING_MM = 1e-9  # a distance equal to the limit does not count as near
Shapes = NDArray[np.object_]
"""Shapely geometries."""


@frozen
class Edges:
    """The edges of shapes, in their order, each with its two ends: (4, n); a polygon has one more, the corners of its
    bounding box, for boxes inside it. ``owners`` (n,) are the shapes, ``halves`` (n,) half the pen widths, ``inside``
    (n,) marks the edges for interiors, and ``shapes`` are all of them."""

    ends: Array
    owners: Indices
    halves: Array
    inside: Booleans
    shapes: Shapes

    def count_near_shapes(self, boxes: Array, clears: Sequence[float]) -> list[Indices]:
        """The number of shapes within a given distance of each box (n, 4), in mm, for each of ``clears``; the first is
        the greatest."""
        if not len(self.shapes):
            return [np.zeros(len(boxes), np.intp) for _ in clears]
        order = np.lexsort((boxes[:, 1], boxes[:, 0] // STRIP_WIDTH_MM))
        counts = np.zeros((len(clears), len(boxes)), np.intp)
        for part in np.split(order, range(BOXES_PER_BATCH, len(order), BOXES_PER_BATCH)):
            box, edge = self._possibly_near_pairs(boxes[part], clears[0])
            apart = self._box_edge_distances(tuple(boxes[part[box]].T), edge)
            for count, clear in zip(counts, clears, strict=True):
                close = apart <= clear - ROUNDING_MM
                count[part] = self._shapes_per_box(box[close], edge[close], len(part))
        return list(counts)

    def _possibly_near_pairs(self, boxes: Array, clear: float) -> tuple[Indices, Indices]:
        """Pairs of boxes and edges that may be that close."""
        reach = self._edge_neighbourhoods(clear)
        runs = _box_sides_in_runs(boxes)
        run, edge = np.nonzero(boxes_overlap([side[None] for side in reach], _boxes_around_runs(runs)))
        row, at = np.nonzero(boxes_overlap([side[edge, None] for side in reach], [side[run] for side in runs]))
        return run[row] * BOXES_PER_RUN + at, edge[row]

    def _shapes_per_box(self, boxes: Indices, edges: Indices, count: int) -> Indices:
        """The number of shapes for each box, by pairs of boxes and edges; several edges of one shape count once."""
        owners = self.owners[edges]
        many = self._has_several_edges[owners]
        pairs = np.unique(boxes[many] * len(self.shapes) + owners[many]) // len(self.shapes)
        return np.bincount(boxes[~many], minlength=count) + np.bincount(pairs, minlength=count)

    @cached_property
    def _has_several_edges(self) -> Booleans:
        """The shapes with more than one edge."""
        return np.bincount(self.owners, minlength=len(self.shapes)) > 1

    def _edge_neighbourhoods(self, clear: float) -> list[Array]:
        """The boxes around the neighbourhood of each edge."""
        ax, ay, bx, by = self.ends
        most = clear + self.halves
        return [
            np.minimum(ax, bx) - most,
            np.minimum(ay, by) - most,
            np.maximum(ax, bx) + most,
            np.maximum(ay, by) + most,
        ]

    @cached_property
    def _directions_and_lengths(self) -> Array:
        """The direction and length of edges: (3, n); zero for a point."""
        ax, ay, bx, by = self.ends
        long = np.hypot(bx - ax, by - ay)
        safe = np.where(long == 0, 1.0, long)
        return np.array([(bx - ax) / safe, (by - ay) / safe, long])

    def _box_edge_distances(self, boxes: Sequence[Array], edges: Indices) -> Array:
        """The distances between boxes and edges, in pairs."""
        wide = (boxes[2] - boxes[0]) / 2
        high = (boxes[3] - boxes[1]) / 2
        x = boxes[0] + wide
        y = boxes[1] + high
        ax, ay, bx, by = self.ends[:, edges]
        along, up, long = self._directions_and_lengths[:, edges]
        ax = ax - x
        ay = ay - y
        bx = bx - x
        by = by - y
        ends = np.minimum(_distance_from_box(ax, wide, ay, high), _distance_from_box(bx, wide, by, high))
        across = ax * up - ay * along
        past = np.abs(across) - (np.abs(up) * wide + np.abs(along) * high)
        to_x = np.copysign(wide, across * up) - ax
        to_y = np.copysign(high, -across * along) - ay
        corner = to_x * along + to_y * up
        level = (np.minimum(ax, bx) <= wide) & (np.maximum(ax, bx) >= -wide)
        level &= (np.minimum(ay, by) <= high) & (np.maximum(ay, by) >= -high)
        distances = np.where((past > 0) & (corner > 0) & (corner < long), past, ends)
        distances[(past <= 0) & level] = 0.0
        (areas,) = np.nonzero(self.inside[edges])
        held = shapely.contains_xy(self.shapes[self.owners[edges[areas]]], x[areas], y[areas])
        distances[areas] = np.where(held, 0.0, np.inf)
        return distances - self.halves[edges]


def edges_of_shapes(shapes: Shapes, halves: Array) -> Edges:
    """The edges of lines and polygons without holes, drawn with pens of these half widths."""
    areas = shapely.get_type_id(shapes) == shapely.GeometryType.POLYGON
    points, owners = shapely.get_coordinates(shapes, return_index=True)
    (one,) = np.nonzero(np.diff(owners) == 0)
    every = np.concatenate([owners[one], np.flatnonzero(areas)])
    order = np.argsort(every, kind="stable")
    ends = np.concatenate([np.hstack([points[one], points[one + 1]]), shapely.bounds(shapes[areas]).reshape(-1, 4)])
    inside = np.repeat([False, True], [len(one), len(every) - len(one)])[order]
    return Edges(np.ascontiguousarray(ends[order].T), every[order], halves[every[order]], inside, shapes)


def _box_sides_in_runs(boxes: Array) -> list[Array]:
    """The sides of boxes in runs, the last one filled up with boxes at infinity."""
    lacking = np.full((-len(boxes) % BOXES_PER_RUN, 4), np.nan)
    return [side.reshape(-1, BOXES_PER_RUN) for side in np.ascontiguousarray(np.concatenate([boxes, lacking]).T)]


def _boxes_around_runs(runs: Sequence[Array]) -> list[Array]:
    """The box around each run."""
    low = np.fmin.reduce
    high = np.fmax.reduce
    return [lesser(side, axis=1)[:, None] for lesser, side in zip((low, low, high, high), runs, strict=True)]


def boxes_overlap(some: Sequence[Array] | Array, others: Sequence[Array] | Array) -> Booleans:
    """Which boxes overlap, by broadcasting."""
    return (some[0] <= others[2]) & (others[0] <= some[2]) & (some[1] <= others[3]) & (others[1] <= some[3])


def _distance_from_box(x: Array, wide: Array, y: Array, high: Array) -> Array:
    """The distance of points from boxes about 0 with these half sides."""
    return np.hypot(np.maximum(np.abs(x) - wide, 0.0), np.maximum(np.abs(y) - high, 0.0))
