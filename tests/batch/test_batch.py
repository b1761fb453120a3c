"""One program, one position or an array of them: the same numbers, masks instead of exceptions, no NaN elsewhere."""

from __future__ import annotations

import math
import random
from typing import Any

import numpy as np
import pytest

from planes.drafting.drawing import Drawing, draw_program
from planes.plans import Plans, plans_of
from planes.plans.scales import plan_scales
from planes.scene import loads
from planes.words.errors import PlanFailure
from tests.helpers.comparing import draw
from tests.helpers.mechanisms import KINDS, make, to_yaml
from tests.solving.test_failures import FOUR_BAR, SLIDER

EPS = 2.0**-52
Bench = tuple[Plans, dict[str, float]]


def bench(text: str) -> Bench:
    """Plans and scales of a scene."""
    scene = loads(text)
    assert scene.mechanism
    plans = plans_of(scene.mechanism)
    return plans, plan_scales(plans, scene.mu)


def crowd(b: Bench, values: Any) -> Drawing:
    return draw_program(b[0].program, {**b[0].given, **b[1], b[0].drive_given_name: np.asarray(values, dtype=float)})


def alone(b: Bench, value: float) -> Drawing:
    return draw_program(b[0].program, {**b[0].given, **b[1], b[0].drive_given_name: float(value)})


def element(thing: Any, i: int) -> complex:
    return complex(thing[i] if np.ndim(thing) else thing)


def plan_sizes(b: Bench, one: Drawing) -> dict[str, float]:
    """The largest mark of every plan, the measure of its rounding."""
    sizes: dict[str, float] = {}
    for step in b[0].program.steps:
        if step.kind == "mark":
            plan = step.makes.rpartition(":")[0]
            sizes[plan] = max(sizes.get(plan, 0.0), abs(one[step.makes]))
    return sizes


def first_reason(many: Drawing, i: int) -> str | None:
    """Why the drawing of that index could not go on."""
    for reason, _, ok, _ in many.tool.failures:
        if not np.broadcast_to(ok, many.tool.shape)[i]:
            return reason
    return None


def values_for(rng: random.Random, plans: Plans, reach: float) -> list[float]:
    at = plans.mechanism.drive.position
    return [at, *(at + rng.uniform(-reach, reach) for _ in range(7))]


@pytest.mark.few(4)
@pytest.mark.parametrize("friction", [False, True])
@pytest.mark.parametrize("kind", KINDS)
def test_an_array_draws_what_one_draws(kind: str, friction: bool) -> None:
    """Marks agree to 5e-14 of their plan over the sharpness, 99 of 100 to 24 units in the last place (sines and
    complex division round differently in numpy); failures are the same ones; NaN stands only where there is one."""
    errors = []
    for seed in range(12):
        rng = random.Random(seed)
        case = make(rng, [kind, *rng.choices(KINDS, k=rng.randint(0, 2))], friction=friction)
        b = bench(to_yaml(case.scene))
        values = values_for(rng, b[0], 30.0 if b[0].mechanism.drive.kind == "phi" else 0.2)
        many = crowd(b, values)
        mask = np.broadcast_to(many.failed_mask(), len(values))
        for i, value in enumerate(values):
            try:
                one = alone(b, value)
            except PlanFailure as failure:
                assert mask[i]
                assert first_reason(many, i) == failure.reason
                continue
            assert not mask[i], (seed, value, first_reason(many, i))
            sharp = math.prod(s for name, s in one.crossing_sharpness.items() if name.startswith("position"))
            sharp *= min(one.crossing_sharpness.values(), default=1.0)  # errors of one group are carried into the next
            if sharp < 1e-4:
                continue
            sizes = plan_sizes(b, one)
            for name in (s.makes for s in b[0].program.steps if s.kind == "mark"):
                scale = sizes[name.rpartition(":")[0]] or 1.0
                errors.append(abs(element(many[name], i) - one[name]) / scale * sharp)
        for step in b[0].program.steps:
            thing = np.broadcast_to(many[step.makes], (len(values),))
            if not step.makes.startswith("arm_"):  # an arm of no force is no number
                assert np.isfinite(thing[~mask]).all(), step.makes
    assert max(errors) < 5e-14
    assert sorted(errors)[int(0.99 * len(errors))] < 24 * EPS


def test_a_whole_turn_fails_only_where_one_position_does() -> None:
    b = bench(FOUR_BAR.replace("B: 0.1", "B: 0.35"))
    values = np.arange(0.0, 360.0, 5.0)
    many = crowd(b, values)
    mask, reasons = many.failed_mask(), set()
    assert mask.any() and not mask.all()
    for i, value in enumerate(values):
        if mask[i]:
            with pytest.raises(PlanFailure) as caught:
                alone(b, value)
            assert caught.value.reason == first_reason(many, i)
            reasons.add(caught.value.reason)
            assert np.isnan(many["position:C"][i])
        else:
            assert np.isclose(many["position:C"][i], alone(b, value)["position:C"], rtol=1e-14)
    assert reasons <= {"arcs_apart", "arcs_inside", "parallel", "coincident"} and "arcs_apart" in reasons


def test_a_mask_keeps_what_was_drawn_before_the_failure() -> None:
    text = SLIDER.replace("phi: 30", "phi: 90").replace("y: 0}", "y: -0.2}")
    b = bench(text.replace("phi: 90", "phi: 60"))
    many = crowd(b, [60.0, 90.0, 120.0])
    assert list(many.failed_mask()) == [False, True, False]
    assert first_reason(many, 1) == "coincident"
    assert np.isfinite(many["position:C"]).all()
    assert list(np.isnan(many["velocity:c"])) == [False, True, False]


def test_other_givens_may_be_arrays_too() -> None:
    b = bench(SLIDER)
    lengths = np.array([0.25, 0.3, 0.35])
    many = draw_program(b[0].program, {**b[0].given, **b[1], "l_BC": lengths})
    for i, length in enumerate(lengths):
        one = draw(SLIDER.replace("C: 0.3", f"C: {length}"), mu=b[1])
        assert abs(many["velocity:c"][i] - one.drawing["velocity:c"]) < 1e-11


def test_many_drivers_and_many_lengths_at_once() -> None:
    b = bench(SLIDER)
    many = draw_program(
        b[0].program,
        {**b[0].given, **b[1], b[0].drive_given_name: np.array([[10.0], [50.0]]), "l_BC": np.array([0.25, 0.3, 0.35])},
    )
    assert many["position:C"].shape == (2, 3)
    assert math.isclose(many["position:C"][1, 1].real, alone(b, 50.0)["position:C"].real, rel_tol=1e-14)
