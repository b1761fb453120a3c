"""The behaviour of every method on the way to a limit: errors, sharpness and claimed bounds against the distance."""

import math
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any

import numpy as np

from planes.accuracy.comparison import Comparison, OtherProgram, Work
from planes.accuracy.digits import Digits
from planes.accuracy.limits import Limit, MovedGiven, find, like
from planes.accuracy.variation import alterable, altered, changed
from planes.batch import compiled
from planes.batch.error_bounds import Claims
from planes.geometry.arrays import Array
from planes.plans import Plans
from planes.words.frozen import frozen, replace

DECADES, EACH, CROWD = 14, 2, 8  # points of a curve per decade, and positions, the worst of which gives the point
BINS = range(1 * EACH, DECADES * EACH + 1)  # distances 0.1 … 1e-14
BEGINS = frozenset(range(0, CROWD * len(BINS), len(BINS)))  # start of a path
ASIDE, LONGER = 0.37, 0.007  # from one member of a crowd to the next: the held drive (degrees), or a length (relative)
NEAR = 0.3  # largest difference between the limits of a crowd


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


def approach(plans: Plans, others: Sequence[OtherProgram] = ()) -> Approach | None:
    """The path to the limit nearest to the scene, with programs by ``others``; None where neither the drive nor any
    length or guide leads to one."""
    limit = find(Comparison(plans))
    return None if limit is None else _measured(limit, others, *_path(limit))


def _path(limit: Limit) -> tuple[Comparison, Array, Array]:
    """A comparison, positions of its drive, and distances: one path after another, each from far to near."""
    spots = [(x, 10.0 ** (-(b / EACH) + k / (EACH * CROWD))) for k, x in enumerate(_crowd(limit)) for b in BINS]
    values = [float(x.value + x.side * step * x.unit) for x, step in spots]
    variants, drive, distances = [], [], []
    for (x, _), value in zip(spots, values, strict=True):
        way, plans = x.way, x.way.bench.plans
        variants.append(plans if way.held is None else altered(plans, way.name, value))
        drive.append(value if way.held is None else way.held)
        moved = value if way.held is None else variants[-1].given[way.name]
        distances.append(float(abs((moved - x.value) / x.unit)))
    plans = limit.way.bench.plans
    names = dict.fromkeys(name for x in variants for name in changed(plans.given, x.given))
    known = {name: np.array([x.given[name] for x in variants]) for name in names}
    return Comparison(plans, known, variants, BEGINS), np.array(drive), np.array(distances)


def _crowd(limit: Limit) -> list[Limit]:
    """Limits of the same sort, as many as a crowd has positions: with the held drive, or a length, slightly changed.

    Their roundings differ, while positions close to one limit would all share the same.
    """
    for ways in _beside(limit.way):
        limits = [like(limit, way) for way in ways]
        if all(x and abs((x.value - limit.value) / limit.unit) < NEAR for x in limits):
            return [limit, *(x for x in limits if x)]
    return [limit] * CROWD


def _beside(way: MovedGiven) -> Iterator[Iterator[MovedGiven]]:
    """Crowds of ways to try."""
    if way.held is not None:
        held = way.held
        yield (replace(way, held=held + ASIDE * ((k + 1) // 2) * (-1) ** k) for k in range(1, CROWD))
        return
    plans = way.bench.plans
    for name in alterable(plans, (n for n in way.bench.cycle.program.givens if n in plans.lengths)):
        longer = [plans.given[name] * (1 + LONGER * k) for k in range(1, CROWD)]
        yield (MovedGiven(Comparison(altered(plans, name, length)), way.name) for length in longer)


def ways(bench: Comparison, others: Sequence[OtherProgram]) -> dict[str, Work]:
    """All methods to be tried, ours before others'."""
    works: dict[str, Work] = {"method_scalar": bench.scalar, "method_batch": lambda v: bench.many(v, False)}
    if compiled.available():
        works["method_compiled"] = lambda v: bench.many(v, True)
    works["method_digits"] = lambda v: bench.scalar(v, Digits(30))
    works["method_single"] = bench.single
    works["method_newton"] = bench.newton
    works["method_differences"] = bench.differences
    return works | {o.name: partial(o.work, bench) for o in others if o.can(bench.plans)}


def _measured(
    limit: Limit, others: Sequence[OtherProgram], bench: Comparison, values: Array, distances: Array
) -> Approach:
    drawings = list(bench.drawings(values, Digits(50)))
    truth = bench.read(drawings)
    works = np.isfinite(truth).all(axis=0) & (distances > 0)
    with np.errstate(all="ignore"):
        tables = {key: work(values) for key, work in ways(bench, others).items()}
        known = np.all([~np.isnan(table).all(axis=1) for table in tables.values()], axis=0)
        size = _sizes(bench, np.where(works, truth, 0.0))[known]
        claims = np.max(Claims(bench.cycle).bounds(values)[known] / size, axis=0)
        errors = {key: np.max(np.abs(table - truth)[known] / size, axis=0) for key, table in tables.items()}
        errors = {key: np.where(np.isfinite(row), row, math.nan) for key, row in errors.items()}
    sharp = np.array([float(min(d.sharpness.values(), default=1.0)) if d else math.nan for d in drawings])
    crowds = [k for k in np.arange(len(distances)).reshape(CROWD, -1).T if works[k].any()]

    def worst(row: Array, by: Callable[[Array], Array] = np.max) -> Array:
        return np.array([by(row[k][works[k]]) for k in crowds])  # once refused is refused

    told_errors = {key: worst(row) for key, row in errors.items()}
    return Approach(limit, worst(distances, np.min), worst(sharp, np.min), worst(claims), told_errors)


def _sizes(bench: Comparison, truth: Array) -> Array:
    """For each column and position the largest place, velocity or acceleration of its crowd."""
    size = bench.sizes(truth).reshape(len(truth), CROWD, -1)
    return np.broadcast_to(size.max(axis=1, keepdims=True), size.shape).reshape(truth.shape)
