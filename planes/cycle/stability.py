"""How every method behaves on the way to the limit of assembly: errors, sharpness and claims against the distance."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from planes.cycle import fused
from planes.cycle.claims import Claims
from planes.cycle.digits import Digits
from planes.cycle.methods import Bench
from planes.drawing import run
from planes.plans import Plans
from planes.wording import PlanFailure

DISTANCES = [10.0 ** (-k / 2) for k in range(2, 29)]  # rad
HALVINGS = 160


@dataclass(frozen=True)
class Approach:
    """A path to a limit: distances (rad, known at 50 digits), sharpness, claim, and errors by method (NaN: refused)."""

    limit_deg: float
    distances: Any
    sharpness: Any
    claim: Any
    errors: dict[str, Any]


def approach(plans: Plans) -> Approach | None:
    """The way to the limit of assembly nearest to the scene's position; None where a whole turn can be drawn."""
    if plans.mechanism.drive.kind != "phi":
        return None
    bench = Bench(plans)
    edge = _edge(bench)
    if edge is None:
        return None
    limit, side = edge
    values = [float(limit + side * d * 180 / limit.context.pi) for d in DISTANCES]
    distances = [float(abs(v - limit)) * math.pi / 180 for v in values]
    kept = [(v, d) for v, d in zip(values, distances, strict=True) if d > 0 and _works(bench, v, Digits(50))]
    return _measured(bench, float(limit), np.array([v for v, _ in kept]), np.array([d for _, d in kept]))


def _works(bench: Bench, value: Any, instrument: Any = None) -> bool:
    try:
        bench.one(value, instrument)
    except PlanFailure:
        return False
    return True


def _edge(bench: Bench) -> tuple[Any, int] | None:
    """The limit at 50 digits, and on which side of it positions work (+1: above)."""
    here = bench.plans.mechanism.drive.position
    offsets = np.arange(0.0, 181.0, 1.0)
    for offset in offsets:
        for side in (1, -1):
            one, two = here + side * offset, here + side * (offset + 1)
            if _works(bench, one) != _works(bench, two):
                return _halved(bench, one, two)
    return None


def _halved(bench: Bench, one: float, two: float) -> tuple[Any, int]:
    fine = Digits(50)
    long: Callable[[float], Any] = fine.tool(False).given
    good, bad = (long(one), long(two)) if _works(bench, one) else (long(two), long(one))
    for _ in range(HALVINGS):
        middle = (good + bad) / 2
        if _works(bench, middle, fine):
            good = middle
        else:
            bad = middle
    return good, 1 if good > bad else -1


def _measured(bench: Bench, limit: float, values: Any, distances: Any) -> Approach:
    truth = bench.truth(values)
    claims = Claims(bench.cycle).bounds(values)
    size = np.maximum.reduceat(np.abs(truth), _starts(bench), axis=0)
    spread = np.repeat(size, np.diff([*_starts(bench), len(truth)]), axis=0)

    def error(work: Callable[[Any], Any]) -> Any:
        with np.errstate(all="ignore"):
            return np.max(np.abs(work(values) - truth) / spread, axis=0)

    ways: dict[str, Callable[[Any], Any]] = {
        "method_scalar": lambda v: np.array([_one(bench, x) for x in v]).T,
        "method_batch": lambda v: bench.many(v, False),
        "method_single": bench.single,
        "method_newton": bench.newton,
        "method_differences": bench.differences,
    }
    if fused.available():
        ways["method_fused"] = lambda v: bench.many(v, True)
    ways["method_digits"] = lambda v: np.array([[float(x) for x in bench.one(float(x), Digits(30))] for x in v]).T
    sharp = [min(_sharpness(bench, float(v)).values(), default=1.0) for v in values]
    errors = {key: error(work) for key, work in ways.items()}
    return Approach(limit, distances, np.array(sharp), np.max(claims / spread, axis=0), errors)


def _starts(bench: Bench) -> list[int]:
    """Where the rows of places, velocities and accelerations begin, sorted so by point."""
    names = [c.name for c in bench.cycle.columns]
    return [k for k, name in enumerate(names) if k == 0 or name[:-2] != names[k - 1][:-2]]


def _one(bench: Bench, value: float) -> list[Any]:
    try:
        return bench.one(float(value))
    except PlanFailure:
        return [math.nan] * len(bench.cycle.columns)


def _sharpness(bench: Bench, value: float) -> dict[str, float]:
    drawing = run(bench.cycle.program, {**bench.cycle.given, bench.plans.drive_given: value}, Digits(50))
    return {k: float(v) for k, v in drawing.sharpness.items()}
