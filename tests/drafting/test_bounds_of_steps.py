"""Where a step draws the line: which trials come true, what stands still, which plans settle."""

from __future__ import annotations

import pytest

from planes.drafting.clearness import has_wide_length_range, is_clear_drawing
from planes.drafting.steps.crossings import CrossArc, CrossArcs, Touch
from planes.drafting.steps.reckoning import Calculate, Choose, Product, Sense, SenseBetween, Trial
from planes.drafting.steps.settling import Fed, Settle
from planes.drafting.tools import Tool
from planes.geometry.arithmetic import Arithmetic
from planes.scene import load
from planes.solving import solve
from planes.words.errors import PlanFailure
from planes.words.names import Meaning
from tests.helpers import ROOT

TRIALS = (Trial("f:+", ("n+",), (1,)), Trial("f:-", ("n-",), (-1,)))
CHOOSE = Choose("f:F", TRIALS, "f:P", "mu_f")


def chosen(plus: float, minus: float, apart: float = 1.0) -> complex:
    """What is kept of two trials with these pushes, a length apart, forces of 100."""
    tool = Tool(Arithmetic())
    tool.sharpness = {"f:+": 1.0, "f:-": 1.0}
    env = {"f:+": 100 + 0j, "f:-": 100 + 1j * apart, "f:P": 100 + 0j, "n+": plus, "n-": minus, "mu_f": 1.0}
    return complex(CHOOSE.draw(env, tool))


def test_of_two_trials_the_one_that_came_true_is_kept() -> None:
    assert chosen(5.0, 5.0) == 100 and chosen(-5.0, -5.0) == 100 + 1j
    assert chosen(5.0, -5.0, apart=1e-9) == 100  # both came true, and are one


def test_none_or_two_different_ones_is_self_locking() -> None:
    for plus, minus, count in ((5.0, -5.0, 2), (-5.0, 5.0, 0)):
        with pytest.raises(PlanFailure) as caught:
            chosen(plus, minus)
        assert caught.value.reason == "self_locking" and caught.value.numbers["solutions"] == count


def test_a_push_of_the_wrong_sign_by_more_than_rounding_came_not_true() -> None:
    assert chosen(-1e-9, 5.0) == 100  # of forces of 100 no more than rounding
    with pytest.raises(PlanFailure):
        chosen(-1e-4, 5.0)


@pytest.mark.parametrize(("speed", "sense"), [(3e-13, 1), (-3e-13, -1), (1e-14, 0), (-1e-14, 0), (0.0, 0)])
def test_a_speed_of_rounding_is_a_standstill_and_said_to_be(speed: float, sense: int) -> None:
    tool = Tool(Arithmetic())
    env = {"v:p": 0j, "v:b": complex(speed), "v:a": 5j, "x": 1 + 0j, "w": 1.0 + speed, "one": 1.0, "turns": 1.0}
    assert Sense("s", "v:p", "v:b", "x", ("v:a", "v:b")).draw(env | {"v:a": 1j}, tool) == sense
    assert SenseBetween("b", "w", "turns", "one", "turns").draw(env, tool) == pytest.approx(sense)
    assert [reason for reason, _, _ in tool.notes] == ["standstill"] * (0 if sense else 2)


def settled(own: float, by: float) -> float:
    """The value of a plan that gives ``own`` and ``by`` times what it is drawn with."""
    size = Calculate("size", (Product(own, ()), Product(by, (("x", 1),))))
    step = Settle("x", (size,), (Fed("x", "one", "size"),))
    return float(step.draw({"one": 1.0}, Tool(Arithmetic())))


def test_plans_settle_where_their_own_result_leads_to_them() -> None:
    assert settled(3.0, 0.25) == pytest.approx(4.0)


@pytest.mark.parametrize("by", [1.0, 1.5, 4.0])
def test_plans_whose_slope_has_turned_over_are_of_another_assembly_of_forces(by: float) -> None:
    """By 2 from 1 there is a value that gives itself again, -1; friction never leads to it."""
    with pytest.raises((PlanFailure, ZeroDivisionError)):
        settled(1.0, by)


@pytest.mark.parametrize("unit", [1e-6, 1.0, 1e6])
def test_lengths_are_far_apart_by_how_many_times_the_shortest_goes_into_the_longest(unit: float) -> None:
    means = {"l": Meaning("length"), "m": Meaning("length"), "e": Meaning("offset")}
    assert not has_wide_length_range({"l": unit, "m": 0.9e6 * unit}, means) and has_wide_length_range(
        {"l": unit, "m": 1.1e6 * unit}, means
    )
    assert not has_wide_length_range({"l": unit, "e": 1e-9 * unit}, means)  # a guide may pass as near as it likes
    assert has_wide_length_range({"l": unit, "e": 1.1e6 * unit}, means) and not has_wide_length_range(
        {"e": unit}, means
    )


def test_only_a_force_of_nothing_makes_an_ordinary_position_doubtful() -> None:
    found = solve(load(ROOT / "samples" / "six-link.yaml")).positions[0]
    drawn, sides = found.drawing, {(r.start, r.end) for r in found.plans.reactions.values()}
    assert len(sides) == 6 and is_clear_drawing(drawn.program, drawn.things, drawn.tool, sides)
    start, _ = sides.pop()
    assert not is_clear_drawing(drawn.program, drawn.things, drawn.tool, {*sides, (start, start)})


@pytest.mark.parametrize("apart", [0.0, 2.0, 3.0, -3.0, 4.0])
def test_how_open_a_line_and_an_arc_are_is_the_square_of_half_their_chord(apart: float) -> None:
    """Of an arc of 3 mm; negative where the line passes it by."""
    env = {"a": 7 + 1j, "x": 1 + 0j, "c": -2 + 1j + 1j * apart, "r": 0.03, "mu": 100.0, "s": 1.0}
    assert CrossArc("p", "a", "x", "c", "r", "mu", "s").opening_measure(env) == pytest.approx(9 - apart**2)


def test_how_open_arcs_are_is_by_heron_and_a_tangent_by_pythagoras() -> None:
    env = {"a": 1 + 1j, "b": 4 + 5j, "r": 0.03, "q": 0.04, "mu": 100.0, "s": 1.0}  # 5 mm apart
    assert CrossArcs("p", "a", "r", "b", "q", "mu", "s").opening_measure(env) == pytest.approx(16 * 6.0**2)
    assert CrossArcs("p", "a", "r", "b", "r", "mu", "s").opening_measure(env) == pytest.approx(16 * 25 * (9 - 6.25) / 4)
    assert Touch("u", "a", "b", "r", "mu", "s").opening_measure(env) == pytest.approx(4.0**2)
    assert Touch("u", "a", "b", None, "mu", "s").opening_measure(env) == pytest.approx(5.0**2)
