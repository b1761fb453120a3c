"""Extremes of a smooth curve, by polynomials through the neighbouring nodes of a grid.

Central interpolation of equally spaced values (Stirling; Fikhtengolts, vol. II; Abramowitz & Stegun, 25.2). Two
polynomials are used, one with two nodes fewer: where they agree on a place, it is returned. Where the derivative is
known, they interpolate the derivative.
"""

from functools import cache

import numpy as np
from numpy.polynomial import polynomial

from planes.diagrams.turn import Grid
from planes.geometry.arrays import Array, ArrayPair, Indices
from planes.plans.curves import FULL_TURN_DEG, Curve

NODES_EACH_SIDE = 5  # nodes on each side
NEWTON_STEPS = 8  # of Newton's method, from the middle
# of the grid's step: largest difference of the two places, by the derivative, and by the value
MOST_PLACE_DIFFERENCES = (1e-9, 1e-7)
# largest difference of curvature between the two: an outlier changes it by a thirtieth
MOST_CURVATURE_DIFFERENCE_RATIO = 1e-3
SAME_NODE_DISTANCE_RATIO = 1e-10  # of the grid's step: closer to a node than this, it is that node


def smooth_extreme_places(g: Grid, curve: Curve, index: Indices, sense: Indices) -> Array:
    """The driver's positions of extremes (shape of ``index``, the nodes beside them; ``sense`` +1 for a maximum), in
    degrees or metres; NaN where the curve is not smooth enough."""
    rows = _values_around_nodes(g, curve, index)
    step = g.places[1] - g.places[0]
    ways = (
        _root_near_middle(_slope_coefficients(rows, half, bool(curve.slope)))
        for half in (NODES_EACH_SIDE - 1, NODES_EACH_SIDE)
    )
    (coarse, coarse_bend), (fine, bend) = ways
    with np.errstate(invalid="ignore"):
        smooth = np.abs(coarse - fine) <= MOST_PLACE_DIFFERENCES[0 if curve.slope else 1]
        smooth &= (np.abs(coarse_bend - bend) <= MOST_CURVATURE_DIFFERENCE_RATIO * np.abs(bend)) & (sense * bend < 0)
        fine = np.where(np.abs(fine) < SAME_NODE_DISTANCE_RATIO, 0.0, fine)
        return np.where(smooth & (np.abs(fine) <= 1.0), g.places[0] + (index + fine) * step, np.nan)


def _values_around_nodes(g: Grid, curve: Curve, index: Indices) -> Array:
    """The curve's slopes, or failing them its values, at the nodes around each of these; NaN past an end.

    A non-negative curve is squared: a vector's magnitude has a corner where it nearly vanishes.
    """
    count = len(g.places)
    at = index[:, None] + np.arange(-NODES_EACH_SIDE, NODES_EACH_SIDE + 1)
    row = np.where(g.assembled_mask, curve.slope(g.sampled_columns) if curve.slope else g.curve_values(curve), np.nan)
    row = row if curve.slope or np.nanmin(row) < 0 else row * row
    if not g.closed:
        return np.where((at >= 0) & (at < count), row[np.clip(at, 0, count - 1)], np.nan)
    turns, place = np.divmod(at, count - 1)
    slopes: Array = row[place]
    return (
        slopes
        if curve.slope or not curve.angular
        else slopes + turns * FULL_TURN_DEG * np.round((row[-1] - row[0]) / FULL_TURN_DEG)
    )


@cache
def _lagrange_weights(half: int) -> Array:
    """The weights of 2·half + 1 values in each coefficient of their polynomial, the lowest power first."""
    nodes = np.arange(-half, half + 1.0)
    others = [np.delete(nodes, k) for k in range(len(nodes))]
    return np.array(
        [polynomial.polyfromroots(rest) / np.prod(node - rest) for node, rest in zip(nodes, others, strict=True)]
    )


def _slope_coefficients(rows: Array, half: int, slopes: bool) -> Array:
    """The coefficients of the slope, the lowest power first, a column for each row of neighbouring values."""
    middle = rows.shape[1] // 2
    laid: Array = (rows[:, middle - half : middle + half + 1] @ _lagrange_weights(half)).T
    return laid if slopes else np.asarray(polynomial.polyder(laid))


def _root_near_middle(slope: Array) -> ArrayPair:
    """The zero of each polynomial near the middle, and its slope there."""
    place = np.zeros(slope.shape[1])
    bend: Array = np.asarray(polynomial.polyder(slope), float)

    def at_place(coefficients: Array) -> Array:
        return np.asarray(polynomial.polyval(place, coefficients, tensor=False))

    with np.errstate(all="ignore"):
        for _ in range(NEWTON_STEPS):
            place = np.clip(place - at_place(slope) / at_place(bend), -1.5, 1.5)
        return place, at_place(bend)
