"""Extremes of curves, refined between the positions of a grid, for many curves at once.

Where a curve's derivative is in the program (a position's is its analogue of velocity, a velocity's its analogue of
acceleration) the extreme is at its zero. Where the curve is smooth on the scale of the grid, a polynomial through the
neighbouring nodes gives the place (:mod:`planes.diagrams.smooth`), and the program is evaluated there once. Otherwise a
bracket is narrowed down, by the derivative, or by the value itself, which gives the value to the last digits and the
place to about 10⁻⁶ of a degree.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from planes.diagrams.smooth import smooth_extreme_places
from planes.diagrams.turn import Grid, WholeTurn
from planes.geometry.arrays import Array, ArrayPair, Booleans
from planes.plans.curves import FULL_TURN_DEG, Curve, Sample
from planes.words.frozen import frozen

CELLS_PER_BRACKET = 32  # parts of a bracket in each round
REFINEMENT_ROUNDS = 8
BRACKETS_PER_BATCH = 48  # brackets refined together: limits the memory
LIMIT_APPROACH_FRACTIONS = 1e-3, 1e-7, 0.0  # of the distance from a limit to the position beside it
CONSTANT_CURVE_RATIO = 1e-11  # relative to its size: a curve that varies less is constant
LEAST_UNBOUNDED_GROWTH = 3.0  # growth when ten thousand times nearer to a limit: more is unbounded


@frozen
class Extreme:
    """A least (``sense`` −1) or greatest (+1) value of a curve and its place; ``at`` an "end" of the range or a "limit"
    of assembly, or inside (""). A value of ±inf grows without bound towards the limit."""

    place: float
    value: float
    sense: int
    at: str = ""


@dataclass
class _Bracket:
    curve: int
    sense: int
    index: int  # the node between low and high
    low: float
    high: float
    near: float  # the value at that node
    angular: bool  # needed close to it


@dataclass
class _Limit:
    """A limit of assembly: the position of the grid beside it, its place, and the behaviour of all curves near it."""

    index: int
    limit: float
    near: Sample

    @classmethod
    def sampled_limit(cls, g: Grid, index: int, limit: float) -> "_Limit":
        place = float(g.places[index])
        reach = (place - limit) or (1.0 if place >= limit else -1.0) * 1e-6
        return cls(
            index,
            limit,
            g.turn.sample_columns(np.array([limit + reach * part for part in LIMIT_APPROACH_FRACTIONS]), bare=True),
        )


def extremes_of_curves(g: Grid) -> list[list[Extreme]]:
    """The extremes of every curve of the turn, in the order of the driver's positions; none for a constant curve."""
    of_curves: list[list[Extreme]] = [[] for _ in g.turn.curves]
    brackets = []
    limits = [_Limit.sampled_limit(g, i, limit) for i, limit in g.assembly_limits]
    for k, curve in enumerate(g.turn.curves):
        y = g.curve_values(curve)
        if has_variation(y, g.rounding_variation(curve)):
            brackets += _extreme_brackets(g, k, y)
            of_curves[k] += _edge_values(g, curve, y, limits)
    for bracket, place, value in _extremes_in_brackets(g, brackets) if brackets else ():
        again = g.closed and place >= g.places[-1] - 1e-9
        of_curves[bracket.curve].append(Extreme(place - FULL_TURN_DEG if again else place, value, bracket.sense))
    return [sorted(some, key=lambda e: e.place) for some in of_curves]


def _extremes_in_brackets(g: Grid, brackets: list[_Bracket]) -> list[tuple[_Bracket, float, float]]:
    """The extremes in brackets of the grid: those of smooth curves, then the others, and those without digits there."""
    places, values = np.full((2, len(brackets)), np.nan)
    index, sense = np.array([(b.index, b.sense) for b in brackets]).T
    for curve, mine in _brackets_by_curve(g.turn, brackets):
        places[mine] = smooth_extreme_places(g, curve, index[mine], sense[mine])
    if len(smooth := np.flatnonzero(np.isfinite(places))):
        values[smooth] = _curve_values_at(g.turn, [brackets[i] for i in smooth], places[smooth])
    there = np.isfinite(values)
    extremes_inside = [(brackets[i], float(places[i]), float(values[i])) for i in np.flatnonzero(there)]
    if not (rough := [brackets[i] for i in np.flatnonzero(~there)]):
        return extremes_inside
    batches = [rough[start : start + BRACKETS_PER_BATCH] for start in range(0, len(rough), BRACKETS_PER_BATCH)]
    return extremes_inside + _one_sided_extremes(
        g, rough, np.concatenate([_refine_extreme_places(g.turn, batch) for batch in batches])
    )


def _one_sided_extremes(g: Grid, brackets: list[_Bracket], places: Array) -> list[tuple[_Bracket, float, float]]:
    """One-sided extremes: at a dead point where a load reverses, the limit from the nearer side instead of the single
    value there, if the curve tends to it; infinity where it grows without bound."""
    beside = 1e-8 * (g.places[-1] - g.places[0])
    around = (places + beside * np.array([[-1], [1], [-1000], [1000]])).ravel()
    values = _curve_values_at(g.turn, brackets, places)
    near, far = _curve_values_at(g.turn, brackets * 4, around).reshape(2, 2, -1)
    size = {k: np.nanmax(np.abs(g.curve_values(g.turn.curves[k]))) for k in {b.curve for b in brackets}}
    alone = np.abs(values - near).min(axis=0) > 1e-3 * np.array([size[b.curve] for b in brackets])
    extremes_there = []
    for i, b in enumerate(brackets):
        value = float(values[i])
        if _grows_without_bound(b, value, near[:, i], far[:, i]):
            extremes_there.append((b, float(places[i]), b.sense * np.inf))
            continue
        if alone[i]:
            value = float(b.sense * (b.sense * near[:, i]).max())
        if np.isfinite(value) and (not alone[i] or b.sense * value >= (b.sense * far[:, i]).max()):
            extremes_there.append((b, float(places[i]), value))
    return extremes_there


def _grows_without_bound(b: _Bracket, value: float, near: Array, far: Array) -> bool:
    """Whether a curve grows towards a place from a thousand times farther, and keeps growing."""
    if b.angular:
        return False
    away, close = (np.nanmax(b.sense * z, initial=0.0) for z in (far, near))
    return bool(close > LEAST_UNBOUNDED_GROWTH * away > 0 and not b.sense * value <= LEAST_UNBOUNDED_GROWTH * close)


def has_variation(y: Array, noise: float) -> bool:
    """Whether a curve varies, by more than the rounding of larger numbers."""
    good = y[np.isfinite(y)]
    return bool(len(good) > 2 and np.ptp(good) > CONSTANT_CURVE_RATIO * (np.abs(good).max() + 1e-300) + noise)


def _extreme_brackets(g: Grid, k: int, y: Array) -> list[_Bracket]:
    """Nodes of the grid above, or below, both their neighbours."""
    x = g.places
    step = g.places[1] - g.places[0]
    if g.closed:
        period = y[-1] - y[0] if g.turn.curves[k].angular else 0.0
        y = np.append(y, y[1] + period)
        x = np.append(x, x[-1] + step)
    before = y[:-2]
    here = y[1:-1]
    after = y[2:]
    noise = 1e-13 * np.nanmax(np.abs(y))
    brackets = []
    for sense in (1, -1):
        up = sense * (here - before) > noise
        down = sense * (here - after) >= -noise
        tops = np.flatnonzero(up & down & (np.abs(here - before) + np.abs(here - after) > 2 * noise))
        brackets += [
            _Bracket(k, sense, int(i) + 1, x[i], x[i + 2], float(y[i + 1]), g.turn.curves[k].angular) for i in tops
        ]
    return brackets


def _edge_values(g: Grid, curve: Curve, y: Array, limits: list[_Limit]) -> list[Extreme]:
    """Values at the ends of the range, and at the limits of assembly, where they may be the largest of all."""
    ends = []
    if not g.closed:
        for i, other in ((0, 1), (-1, -2)):
            if np.isfinite(y[i]) and np.isfinite(y[other]):
                ends.append(Extreme(float(g.places[i]), float(y[i]), 1 if y[i] > y[other] else -1, "end"))
    for limit in limits:
        if np.isfinite(y[limit.index]):
            ends += _extremes_at_limit(curve, float(y[limit.index]), limit)
    return ends


def _extremes_at_limit(curve: Curve, y: float, at: _Limit) -> list[Extreme]:
    """The behaviour of a curve at a limit of assembly: it ends there, or grows without bound."""
    far, close, last = curve.read(at.near) + np.zeros(len(LIMIT_APPROACH_FRACTIONS))
    limit = at.limit
    if (
        curve.group != "place"
        and np.isfinite(far)
        and np.isfinite(close)
        and abs(close) > LEAST_UNBOUNDED_GROWTH * abs(far)
    ):
        return [Extreme(limit, float(np.copysign(np.inf, close)), 1 if close > 0 else -1, "limit")]
    value = last if np.isfinite(last) else close
    if not np.isfinite(value):
        return []
    if curve.angular:
        value += FULL_TURN_DEG * round((y - value) / FULL_TURN_DEG)
    return [Extreme(limit, float(value), 1 if value > y else -1, "limit")]


def _refine_extreme_places(turn: WholeTurn, brackets: list[_Bracket]) -> Array:
    """Places of the bracketed extremes, all narrowed down together: to the zero of the slope, or, if that is unknown or
    has one sign throughout (a value passes through infinity), by the value itself."""
    low, high, sense = np.array([(b.low, b.high, b.sense) for b in brackets]).T
    parts = np.linspace(0.0, 1.0, CELLS_PER_BRACKET + 1)
    for _ in range(REFINEMENT_ROUNDS):
        x = low[:, None] + (high - low)[:, None] * parts
        sample = turn.sample_columns(x.ravel(), bare=True)
        first = np.zeros(len(x), int)
        last = np.full(len(x), CELLS_PER_BRACKET)
        for curve, mine in _brackets_by_curve(turn, brackets):
            y, slope = (
                (read(sample) + np.zeros(x.size)).reshape(x.shape)[mine] * sense[mine][:, None]
                for read in (curve.read, curve.slope or _unknown_slope)
            )
            by_value = (slope > 0).all(axis=1) | ~(slope > 0).any(axis=1)
            first[mine], last[mine] = np.where(by_value, _cells_around_top(y), _cell_of_slope_crossing(slope))
        rows = np.arange(len(x))
        low = x[rows, first]
        high = x[rows, last]
    middle: Array = (low + high) / 2
    return middle


def _curve_values_at(turn: WholeTurn, brackets: list[_Bracket], place: Array) -> Array:
    sample = turn.sample_columns(place)
    values_there = np.empty(len(place))
    near = np.array([b.near for b in brackets])
    for curve, mine in _brackets_by_curve(turn, brackets):
        value = (curve.read(sample) + np.zeros(len(place)))[mine]
        values_there[mine] = (
            value + FULL_TURN_DEG * np.round((near[mine] - value) / FULL_TURN_DEG) if curve.angular else value
        )
    return values_there


def _brackets_by_curve(turn: WholeTurn, brackets: list[_Bracket]) -> Iterator[tuple[Curve, Booleans]]:
    """Each curve that has brackets, and which of them are its own."""
    owner = np.array([b.curve for b in brackets])
    for k in np.unique(owner):
        yield turn.curves[k], owner == k


def _unknown_slope(sample: Sample) -> float:
    """The slope of a curve without a column for it."""
    return np.nan


def _cell_of_slope_crossing(slope: Array) -> ArrayPair:
    """The first cell in which a slope, positive before a top, is no longer positive."""
    down = ~(slope > 0)
    down[:, 0] = False
    down[:, -1] = True
    last = down.argmax(axis=1)
    return last - 1, last


def _cells_around_top(y: Array) -> ArrayPair:
    """The cells on either side of the highest value."""
    best = np.where(np.isfinite(y), y, -np.inf).argmax(axis=1)
    return np.maximum(best - 1, 0), np.minimum(best + 1, y.shape[1] - 1)
