"""What a drawing claims of its own errors: never less than they are, and seldom far more."""

from __future__ import annotations

import random
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mechanisms import KINDS, make, to_yaml

from planes.cycle import Cycle
from planes.cycle.claims import Claims
from planes.cycle.digits import Digits
from planes.cycle.spread import pencil_spread
from planes.cycle.stability import approach
from planes.drawing import run
from planes.instruments import Pencil
from planes.plans import state
from planes.scales import scales
from planes.scene import load, loads

SAMPLES = Path(__file__).parents[1] / "samples"
KIND_SAMPLES = ["kind-1-rrr", "kind-2-rrp", "kind-3-rpr", "kind-4-prp", "kind-5-rpp", "six-link"]


def cycle_of(name: str) -> Cycle:
    mechanism = load(str(SAMPLES / f"{name}.yaml")).mechanism
    assert mechanism
    return Cycle(state(mechanism))


def true_errors(c: Cycle, values: Any, table: Any) -> Any:
    """How far numbers are from the truth at 50 digits (NaN where a position fails)."""
    errors = np.full(table.shape, np.nan)
    for k, value in enumerate(values):
        drawing = run(c.program, {**c.given, c.plans.drive_given: float(value)}, Digits(50))
        for row, column in enumerate(c.columns):
            truth = column.take(drawing.things, drawing.hand.ar)
            errors[row, k] = abs(float(drawing.hand.given(float(table[row, k])) - truth))
    return errors


def ratios(c: Cycle, values: Any) -> Any:
    (block,) = c.blocks(values, fast=False, chunk=len(values))
    good = block.codes == 0
    errors, claims = true_errors(c, values[good], block.table[:, good]), Claims(c).bounds(values[good])
    assert not (errors > claims).any()
    sure = (errors > 0) & np.isfinite(claims)
    return (claims / np.where(sure, errors, np.nan))[sure]


def test_claims_are_honest_and_close_for_every_kind() -> None:
    found = []
    for name in KIND_SAMPLES:
        c = cycle_of(name)
        position = c.plans.mechanism.drive.position
        found.append(ratios(c, position + np.random.default_rng(5).uniform(-8, 8, 12)))
    together = np.concatenate(found)
    assert together.min() >= 1 and np.median(together) < 10.5


def test_claims_are_honest_for_random_mechanisms() -> None:
    for seed in range(25):
        case = make(random.Random(seed), [KINDS[seed % 5]], limit=1e4)
        mechanism = loads(to_yaml(case.scene)).mechanism
        assert mechanism
        c = Cycle(state(mechanism))
        ratios(c, mechanism.drive.position + np.linspace(-1e-3, 1e-3, 4))


def test_claims_hold_on_the_way_to_a_dead_point() -> None:
    mechanism = load(str(SAMPLES / "six-link.yaml")).mechanism
    assert mechanism
    way = approach(state(mechanism))
    assert way is not None and way.limit_deg == pytest.approx(129.5273973697464) and way.distances.min() < 1.1e-14
    for key in ("method_scalar", "method_batch", "method_fused"):
        errors = way.errors.get(key, way.errors["method_batch"])
        assert (np.isnan(errors) | (errors <= way.claim)).all()
        assert (errors < way.errors["method_newton"]).all()
    assert (way.claim[way.distances > 1e-6] < 1e-8).all()


@pytest.mark.parametrize("name", KIND_SAMPLES)
def test_spread_of_a_pencil_is_that_of_many_draughtsmen(name: str) -> None:
    c = cycle_of(name)
    mus = scales(c.plans, {}, {})
    position = c.plans.mechanism.drive.position
    pencil, many = Pencil(point_mm=0.03, ray_deg=0.03, ruler_mm=0.05), 3000
    carried = pencil_spread(c, pencil, mus, np.array([position]))[:, 0]
    given = {**c.given, **mus, c.plans.drive_given: np.full(many, position)}
    drawing = run(c.program, given, pencil)
    for column, spread in zip(c.columns, carried, strict=True):
        seen = np.std(np.broadcast_to(column.take(drawing.things, drawing.hand.ar), (many,)))
        if np.isfinite(seen) and seen > 1e-12:
            assert spread == pytest.approx(seen, rel=0.25), column.name
