"""One μ for all force plans, and a second one for those that would be under 50 mm at it."""

from __future__ import annotations

from dataclasses import replace

import pytest

from planes.plans.scales import LEAST_FORCE_PLAN_MM, PLAN_FIT_MM, plan_extent, scale_leaders
from planes.scene import load, loads
from planes.solving import solve
from planes.words.names import PlanId
from tests.helpers import ROOT


@pytest.mark.parametrize("number", ["07", "44", "58", "65"])
def test_no_force_plan_is_under_fifty_millimetres(number):
    (position,) = solve(replace(load(ROOT / "samples" / "assignments" / f"{number}.yaml"), find=None)).positions
    plans = [p for p in position.plans.plan_names if p.is_force]
    assert min(plan_extent(position.drawing, p) for p in plans) >= LEAST_FORCE_PLAN_MM
    assert len({position.scales[p.mu_name] for p in plans}) <= 2


def test_a_second_scale_is_that_of_the_largest_of_the_small_ones():
    sizes = {"force:a": 1000.0, "force:b": 900.0, "force:c": 90.0, "force:d": 80.0, "force:e": 0.0, "velocity": 5.0}
    assert scale_leaders({PlanId.read(plan): size for plan, size in sizes.items()}, PLAN_FIT_MM) == {
        "force:a": "force:a",
        "force:b": "force:a",
        "force:c": "force:c",
        "force:d": "force:c",
        "force:e": "force:a",
        "velocity": "velocity",
    }


LIGHT = """\
planes: 1
frame: {points: {A: [0, 0], D: [0.3, 0]}}
links:
  1: {points: {A: 0, B: 0.1}, mass: 1e7}
  2: {points: {B: 0, C: 0.3}}
  3: {points: {D: 0, C: 0.25}}
drive: {link: 1, phi: 60, omega: 1}
assembly: {C: left}
gravity: 9.81
loads: [{point: C, link: 3, force: 1e-3, direction: 0}]
"""


def test_a_small_force_beside_a_heavy_link_has_its_scale() -> None:
    """It is no rounding, though 1e-11 of the weight."""
    (p,) = solve(loads(LIGHT)).positions
    assert plan_extent(p.drawing, PlanId("force", "2", "3")) >= LEAST_FORCE_PLAN_MM
