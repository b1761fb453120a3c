"""Where the two leads that meet in the special point become parallel others meet there: in every reader."""

from __future__ import annotations

import random

import numpy as np
import pytest

from planes.batch import compiled
from planes.batch.cycle import Cycle
from planes.drafting.drawing import draw_program
from planes.geometry import plane
from planes.geometry.arrays import Array
from planes.plans import Plans
from planes.plans.other_leads import plans_with_sharp_leads, steps_with_other_leads
from planes.plans.scales import drawn_in_si, plan_scales
from planes.plans.statements.of_scene import scene_plans
from planes.scene import load, loads
from planes.solving import plans_and_requested_results, solve
from tests.helpers import ROOT
from tests.helpers.comparing import Drawn, balanced, differences, expected, pose
from tests.helpers.mechanisms import make, to_yaml
from tests.helpers.oracle import solve as oracle_solve

FOUND = [
    ("RR-RR-RP", 4),
    ("RR-RR-PR", 2),
    ("RR-RR-RR", 2),
    ("RR-PR-RP", 14),
    ("RR-RP-RP", 3),
    ("RR-RR+RR-RR", 2),
    ("RR-PR+RP-RR", 4),
    ("RR-RR+RR+RR-RR", 4),
]


def parallel_at(plans: Plans, low: float, high: float) -> float | None:
    """Where the two leads that meet are parallel, to the last bit."""
    step, *_ = steps_with_other_leads(plans.program)
    program = plans.program.cut_to_names(step.sharp_directions)

    def crossing(values: Array) -> Array:
        things = drawn_in_si(plans, values, program)
        return np.asarray(plane.cross(things[step.along], things[step.across]))

    values = np.linspace(low, high, 2000)
    for _ in range(8):
        sines = crossing(values)
        changes = np.flatnonzero(sines[1:] * sines[:-1] < 0)
        if not len(changes):
            return None if len(values) == 2000 else float(values[np.nanargmin(abs(sines))])
        values = np.linspace(values[changes[0]], values[changes[0] + 1], 200)
    return float(values[0])


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize(("leads", "seed"), FOUND)
def test_parallel_leads_are_passed_by_another_pair(leads: str, seed: int) -> None:
    case = make(random.Random(f"parallel {leads} {seed}"), [leads], sliding=False)
    scene = loads(to_yaml(case.scene))
    plans, _ = plans_and_requested_results(scene)
    start = plans.mechanism.drive.position
    value = parallel_at(plans, start - 60, start + 60)
    assert value is not None
    step, *_ = steps_with_other_leads(plans.program)
    assert (
        step.crossing_sharpnesses(drawn_in_si(plans, value, plans.program.cut_to_names(step.sharp_directions)).things)[
            0
        ]
        < 1e-12
    )
    fit = plans_with_sharp_leads(plans, value)
    chosen = {**plan_scales(fit, {}, fit.drive_givens_at(value)), **fit.drive_givens_at(value)}
    d = Drawn(scene, fit, chosen, draw_program(fit.program, {**fit.given, **chosen}))
    there = {**case.scene, "drive": {**case.scene["drive"], "phi": value}}
    wanted = {n.name: n for n in expected(oracle_solve(there, pose(d)), True)}
    assert max(differences(d, wanted).values()) * d.sharpest <= 1e-9
    balanced(d)
    (told,) = solve(scene, [value]).positions
    cycle = Cycle(plans)
    values = value + np.linspace(-0.01, 0.01, 41)
    for fast in (False, True) if compiled.is_compiler_available() else (False,):
        (block,) = cycle.blocks(values, fast=fast)
        assert not block.failed_mask.any()
        found, claims = block.table[:, 20], cycle.decimal_error_bounds(values[20:21], np.array([20]))[:, 0]
        here = dict(zip((c.name for c in cycle.columns), found, strict=True))
        assert all(
            abs(told.v[p] - complex(here[f"v_{p}_x"], here[f"v_{p}_y"])) <= 1e-9 * abs(told.v[p]) for p in told.v
        )
        assert (claims <= 1e-6 * abs(block.table[: len(found)]).max(axis=1).max()).all()


@pytest.mark.parametrize("name", ["guide", "rods", "three-basic-links"])
def test_leads_that_cross_well_are_kept(name: str) -> None:
    plans = scene_plans(load(ROOT / "samples" / "class-three" / f"{name}.yaml"))
    assert (
        steps_with_other_leads(plans.program) and plans_with_sharp_leads(plans, plans.mechanism.drive.position) is plans
    )


def test_leads_that_are_parallel_are_not() -> None:
    plans, _ = plans_and_requested_results(
        loads(to_yaml(make(random.Random("parallel RR-RR-RR 2"), ["RR-RR-RR"], sliding=False).scene))
    )
    start = plans.mechanism.drive.position
    where = parallel_at(plans, start - 60.0, start + 60.0)
    assert where is not None and plans_with_sharp_leads(plans, where) is not plans
