"""The behaviour of every method on the way to a limit: errors, sharpness and claimed bounds against the distance."""

import math
from collections.abc import Iterator, Sequence
from functools import partial
from typing import Any

import numpy as np

from planes.accuracy.comparison import Comparison, OtherProgram, Work
from planes.accuracy.digits import Digits
from planes.accuracy.limits import Limit, MovedGiven, find_nearest_limit, similar_limit_of_path
from planes.accuracy.variation import alterable_given_names, names_of_changed_givens, plans_with_changed_given
from planes.batch import compiled
from planes.batch.error_bounds import Claims
from planes.geometry.arrays import Array
from planes.plans import Plans
from planes.words.frozen import frozen, replace

# points of a curve per decade, and positions, the worst of which gives the point
DISTANCE_DECADES = 14
POINTS_PER_DECADE = 2
POSITIONS_PER_POINT = 8
DISTANCE_BINS = range(1 * POINTS_PER_DECADE, DISTANCE_DECADES * POINTS_PER_DECADE + 1)  # distances 0.1 … 1e-14
PATH_START_INDICES = frozenset(
    range(0, POSITIONS_PER_POINT * len(DISTANCE_BINS), len(DISTANCE_BINS))
)  # start of a path
# from one member of a crowd to the next: the held drive (degrees), or a length (relative)
CROWD_DRIVE_STEP_DEG = 0.37
CROWD_LENGTH_STEP_RATIO = 0.007
MOST_CROWD_LIMIT_DIFFERENCE = 0.3  # largest difference between the limits of a crowd


@frozen
class Approach:
    """A path to a limit: distances (rad, m or relative), sharpness, claim, and errors by method (NaN: refused).

    Each is the worst of a crowd of positions from the given distance to half a decade above it, so that no curve is low
    by a lucky rounding; over the columns that every method gives.
    """

    limit: Limit
    distances: Any
    sharpness: Any
    claim: Any
    errors: dict[str, Array]


def approach_nearest_limit(plans: Plans, others: Sequence[OtherProgram] = ()) -> Approach | None:
    """The path to the limit nearest to the scene, with programs by ``others``; None where neither the drive nor any
    length or guide leads to one."""
    limit = find_nearest_limit(Comparison(plans))
    if limit is None:
        return None
    return _measure_approach(limit, others, *_paths_towards_limit(limit))


def _paths_towards_limit(limit: Limit) -> tuple[Comparison, Array, Array]:
    """A comparison, positions of its drive, and distances: one path after another, each from far to near."""
    spots = [
        (x, 10.0 ** (-(b / POINTS_PER_DECADE) + k / (POINTS_PER_DECADE * POSITIONS_PER_POINT)))
        for k, x in enumerate(_similar_limits(limit))
        for b in DISTANCE_BINS
    ]
    values = [float(x.value + x.side * step * x.distance_unit_value) for x, step in spots]
    variants = []
    drive = []
    distances = []
    for (x, _), value in zip(spots, values, strict=True):
        way = x.way
        plans = x.way.bench.plans
        variants.append(plans if way.held is None else plans_with_changed_given(plans, way.name, value))
        drive.append(value if way.held is None else way.held)
        moved = value if way.held is None else variants[-1].given[way.name]
        distances.append(float(abs((moved - x.value) / x.distance_unit_value)))
    plans = limit.way.bench.plans
    names = dict.fromkeys(name for x in variants for name in names_of_changed_givens(plans.given, x.given))
    known = {name: np.array([x.given[name] for x in variants]) for name in names}
    return Comparison(plans, known, variants, PATH_START_INDICES), np.array(drive), np.array(distances)


def _similar_limits(limit: Limit) -> list[Limit]:
    """Limits of the same sort, as many as a crowd has positions: with the held drive, or a length, slightly changed.

    Their roundings differ, while positions close to one limit would all share the same.
    """
    for ways in _neighbouring_ways(limit.way):
        limits = [similar_limit_of_path(limit, way) for way in ways]
        if all(
            x and abs((x.value - limit.value) / limit.distance_unit_value) < MOST_CROWD_LIMIT_DIFFERENCE for x in limits
        ):
            return [limit, *(x for x in limits if x)]
    return [limit] * POSITIONS_PER_POINT


def _neighbouring_ways(way: MovedGiven) -> Iterator[Iterator[MovedGiven]]:
    """Crowds of ways to try."""
    if way.held is not None:
        held = way.held
        yield (
            replace(way, held=held + CROWD_DRIVE_STEP_DEG * ((k + 1) // 2) * (-1) ** k)
            for k in range(1, POSITIONS_PER_POINT)
        )
        return
    plans = way.bench.plans
    for name in alterable_given_names(
        plans, (n for n in way.bench.cycle.program.given_names if n in plans.link_lengths)
    ):
        longer = [plans.given[name] * (1 + CROWD_LENGTH_STEP_RATIO * k) for k in range(1, POSITIONS_PER_POINT)]
        yield (MovedGiven(Comparison(plans_with_changed_given(plans, name, length)), way.name) for length in longer)


def methods_to_try(bench: Comparison, others: Sequence[OtherProgram]) -> dict[str, Work]:
    """All methods to be tried, ours before others'."""
    works = {"method_scalar": bench.columns_one_by_one, "method_batch": lambda v: bench.columns_by_loop(v, False)}
    if compiled.is_compiler_available():
        works["method_compiled"] = lambda v: bench.columns_by_loop(v, True)
    works["method_digits"] = lambda v: bench.columns_one_by_one(v, Digits(30))
    works["method_single"] = bench.columns_in_single_precision
    works["method_newton"] = bench.columns_by_newton
    works["method_differences"] = bench.columns_by_differences
    return works | {o.name: partial(o.work, bench) for o in others if o.can(bench.plans)}


def _measure_approach(
    limit: Limit, others: Sequence[OtherProgram], bench: Comparison, values: Array, distances: Array
) -> Approach:
    drawings = list(bench.draw_positions(values, Digits(50)))
    truth = bench.columns_of_drawings(drawings)
    works = np.isfinite(truth).all(axis=0) & (distances > 0)
    with np.errstate(all="ignore"):
        tables = {key: work(values) for key, work in methods_to_try(bench, others).items()}
        known = np.all([~np.isnan(table).all(axis=1) for table in tables.values()], axis=0)
        size = _largest_magnitudes_of_crowd(bench, np.where(works, truth, 0.0))[known]
        claims = np.max(Claims(bench.cycle).error_bounds_of_columns(values)[known] / size, axis=0)
        errors = {key: np.max(np.abs(table - truth)[known] / size, axis=0) for key, table in tables.items()}
        errors = {key: np.where(np.isfinite(row), row, math.nan) for key, row in errors.items()}
    sharp = np.array([float(min(d.crossing_sharpness.values(), default=1.0)) if d else math.nan for d in drawings])
    crowds = [k for k in np.arange(len(distances)).reshape(POSITIONS_PER_POINT, -1).T if works[k].any()]

    def worst(row: Array, by: Work = np.max) -> Array:
        return np.array([by(row[k][works[k]]) for k in crowds])  # once refused is refused

    told_errors = {key: worst(row) for key, row in errors.items()}
    return Approach(limit, worst(distances, np.min), worst(sharp, np.min), worst(claims), told_errors)


def _largest_magnitudes_of_crowd(bench: Comparison, truth: Array) -> Array:
    """For each column and position the largest place, velocity or acceleration of its crowd."""
    size = bench.largest_magnitudes(truth).reshape(len(truth), POSITIONS_PER_POINT, -1)
    return np.broadcast_to(size.max(axis=1, keepdims=True), size.shape).reshape(truth.shape)
