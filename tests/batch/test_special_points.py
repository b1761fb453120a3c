"""Where a special point passes over a hinge nothing is lost: what is laid off there vanishes with its direction."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from planes.accuracy.comparison import Comparison
from planes.batch.cycle import Cycle
from planes.batch.error_bounds import Claims
from planes.drafting.steps import Through
from planes.geometry.arrays import Array, Indices
from planes.plans import Plans, plans_of
from planes.plans.quantities import MOTION_GROUPS, quantities_by_name
from planes.plans.scales import drawn_in_si
from planes.scene import load
from planes.scene.ranges import Span
from tests.helpers import ROOT

PASSES = ("press", "rods", "slider")


def plans(sample: str) -> Plans:
    mechanism = load(str(ROOT / "samples" / "class-three" / f"{sample}.yaml")).mechanism
    assert mechanism
    return plans_of(mechanism)


def over_a_hinge(stated: Plans) -> float:
    """The crank's angle at which the special point is nearest to a hinge."""
    rays = [
        s for s in stated.program.steps if isinstance(s, Through) and s.makes in stated.program.vanishing_directions
    ]
    values = np.linspace(0.0, 360.0, 3601)
    for _ in range(7):
        things = drawn_in_si(stated, values).things
        apart = np.min([np.abs(things[s.end] - things[s.start]) for s in rays], axis=0)
        best = float(values[np.nanargmin(apart)])
        values = best + np.linspace(-1.0, 1.0, 401) * (values[1] - values[0])
    assert apart.min() < 1e-10
    return best


@pytest.mark.slow
@pytest.mark.parametrize("sample", PASSES)
def test_numbers_there_are_those_of_fifty_digits(sample: str) -> None:
    stated = plans(sample)
    near = over_a_hinge(stated) + np.concatenate([[0.0], *(s * np.logspace(-12, -1, 8) for s in (1, -1))])
    bench = Comparison(stated)
    truth, table = bench.true_columns(near), bench.columns_by_loop(near, False)
    assert np.isfinite(table).all()
    for letter in "rva":
        rows = bench.letters == letter
        assert np.abs(table - truth)[rows].max() <= 1e-12 * np.abs(truth[rows]).max()


@pytest.mark.needs("llvmlite")
@pytest.mark.slow
@pytest.mark.parametrize("sample", PASSES)
def test_no_position_of_the_turn_is_looked_at_by_itself(sample: str, monkeypatch: pytest.MonkeyPatch) -> None:
    looked: list[float] = []
    bounds = Claims.error_bounds_of_columns

    def counted(self: Claims, values: Sequence[float] | Array, at: Indices | None = None) -> Array:
        looked.extend(values)
        return bounds(self, values, at)

    stated, count = plans(sample), 20_000
    cycle = Cycle(stated, [n for n, q in quantities_by_name(stated).items() if q.group in MOTION_GROUPS])
    monkeypatch.setattr(Claims, "error_bounds_of_columns", counted)
    blocks = list(cycle.blocks(Span(0.0, 360.0 / count, count), fast=True))
    assert not looked
    assert all((b.codes == 0).all() and np.isfinite(b.table).all() for b in blocks)
