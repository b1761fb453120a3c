"""Programs: checked by name and kind before any number, sliced, and the same for every value of a structure."""

from __future__ import annotations

import dataclasses
import math
import random
from typing import Any

import pytest
from hypothesis import given, settings

import planes.drafting.steps
import planes.drafting.steps.reckoning
from planes.drafting.draft import Draft
from planes.drafting.drawing import draw_program
from planes.drafting.program import Program
from planes.drafting.steps import Aim, Carry, LayOff, Put, Step, Through, Turn
from planes.drafting.steps.crossings import Cross
from planes.drafting.steps.reckoning import Calculate, Measure, Product, Protractor
from planes.plans import Plans, plans_cut_to_names, plans_of
from planes.plans.quantities import quantities_asked_for
from planes.scene import loads
from planes.words.errors import ProgramError
from planes.words.names import Meaning
from tests.helpers.mechanisms import KINDS, make, mechanisms, to_yaml
from tests.solving.test_failures import FOUR_BAR, ROCKER, SLIDER

LOADED = (
    FOUR_BAR
    + """\
gravity: 9.81
loads: [{link: 3, point: C, force: 50, against: motion}, {link: 2, moment: 3}]
"""
)


def plans_from(text: str) -> Plans:
    scene = loads(text)
    assert scene.mechanism
    return plans_of(scene.mechanism)


POLE = Put("velocity:p")
AIM = Aim("u", "angle")
LAY = LayOff("velocity:b", "velocity:p", "u", "v_B", "mu")


@pytest.mark.parametrize(
    "steps, says",
    [
        ((AIM, LAY), "LayOff of velocity:b needs the mark velocity:p, but the drawing has not reached it"),
        ((POLE, LAY), "LayOff of velocity:b needs the direction u, but the drawing has not reached it"),
        (
            (POLE, AIM, LAY, Through("w", "velocity:b", "velocity:c")),
            "Through of w needs the mark velocity:c, but the drawing has not reached it; drawn so far: velocity:p, "
            "velocity:b",
        ),
        (
            (POLE, AIM, Carry("velocity:c", "velocity:p", "u", "velocity:p")),
            "Carry of velocity:c takes u for a mark, it is a direction",
        ),
        ((POLE, Protractor("phi", "velocity:p")), "Protractor of phi takes velocity:p for a direction, it is a mark"),
        (
            (POLE, AIM, Calculate("x", (Product(1.0, (("u", 1),)),))),
            "Calculate of x takes u for a value, it is a direction",
        ),
        ((POLE, POLE), "velocity:p is made twice"),
        (
            (POLE, AIM, LAY, Measure("l", "velocity:p", "velocity:b", "velocity:b", "mu")),
            "Measure of l takes velocity:b for a direction, it is a mark",
        ),
        ((POLE, AIM, Cross("velocity:c", "velocity:p", "u", "velocity:p", "w")), "needs the direction w"),
        (
            (POLE, AIM, Turn("w", "v")),
            "Turn of w needs the direction v, but the drawing has not reached it; drawn so far: u",
        ),
    ],
)
def test_kinds_and_chaining_are_refused_by_name(steps: tuple[Step, ...], says: str) -> None:
    with pytest.raises(ProgramError) as caught:
        Program(steps)
    assert says in str(caught.value)


def test_what_no_step_makes_must_be_given() -> None:
    program = Program((POLE, AIM, LAY))
    assert program.given_names == ("angle", "v_B", "mu")
    with pytest.raises(ProgramError, match="to draw this, give v_B, mu"):
        draw_program(program, {"angle": 90.0})
    drawing = draw_program(program, {"angle": 90.0, "v_B": 2.0, "mu": 30.0})
    assert drawing["velocity:b"] == 60j
    with pytest.raises(ProgramError, match="the drawing has no velocity:c"):
        drawing["velocity:c"]


def kinds_drawn(plans: Plans) -> set[str]:
    return {plan.partition(":")[0] for plan in plans.plan_names}


@pytest.mark.parametrize(
    "wanted, plans",
    [
        (["r_C"], {"position"}),
        (["v_C"], {"position", "velocity"}),
        (["omega_2"], {"position", "velocity"}),
        (["v_CB"], {"position", "velocity"}),
        (["a_C"], {"position", "velocity", "acceleration"}),
        (["epsilon_3"], {"position", "velocity", "acceleration"}),
        (["F_30"], {"position", "velocity", "acceleration", "force"}),
        (["phi_2"], {"position"}),
    ],
)
def test_only_what_leads_to_the_asked_is_drawn(wanted: list[str], plans: set[str]) -> None:
    whole = plans_from(LOADED)
    cut = plans_cut_to_names(whole, [n for q in quantities_asked_for(whole, wanted) for n in q.needed_names])
    assert kinds_drawn(cut) == plans
    assert set(cut.program.steps) < set(whole.program.steps)
    one = draw_program(cut.program, {n: whole.given.get(n, 100.0) for n in cut.program.given_names})
    for name in (n for q in quantities_asked_for(whole, wanted) for n in q.needed_names):
        assert name in one


def test_asking_for_a_place_takes_neither_masses_nor_speeds() -> None:
    whole = plans_from(LOADED)
    cut = whole.program.cut_to_names(["position:C"])
    assert not [g for g in cut.given_names if g.startswith(("m_", "J_", "omega", "epsilon", "P_", "M_", "g", "mu_v"))]
    velocity = whole.program.cut_to_names(["velocity:c"])
    assert not [
        g for g in velocity.given_names if g.startswith(("m_", "J_", "epsilon", "P_", "M_", "g", "mu_a", "mu_f"))
    ]
    assert not [s for s in velocity.steps if s.makes.startswith(("acceleration", "force", "a_", "F_", "h_"))]


def test_the_force_plan_of_one_group_leaves_the_driver_out() -> None:
    whole = plans_from(LOADED)
    r = whole.reactions["F_30"]
    cut = plans_cut_to_names(whole, [r.start, r.end])
    assert "force:2-3" in cut.plan_names and "force:1" not in cut.plan_names and "lever" not in cut.plan_names


def test_a_slice_gives_the_numbers_of_the_whole() -> None:
    for seed in range(20):
        case = make(random.Random(seed), random.Random(seed).choices(KINDS, k=2))
        plans = plans_from(to_yaml(case.scene))
        given = {**plans.given, **{f"mu_{p}": 2.0 for p in plans.plan_names}}
        whole = draw_program(plans.program, given)
        names = [s.makes for s in plans.program.steps]
        for name in random.Random(seed).sample(names, 12):
            cut = plans.program.cut_to_names([name])
            same = draw_program(cut, {n: given[n] for n in cut.given_names})[name]
            assert same == whole[name] or (math.isnan(abs(same)) and math.isnan(abs(whole[name])))
            assert cut.cut_to_names([name]) == cut


@pytest.mark.parametrize(
    "text, changes",
    [
        (
            LOADED,
            {
                "B: 0.1": "B: 0.12",
                "C: 0.3}, mass: 2, inertia: 0.1": "C: 0.37}, mass: 5, inertia: 0.4",
                "phi: 60": "phi: -170",
                "omega: 10": "omega: -3, epsilon: 7",
                "C: left": "C: right",
                "force: 50": "force: 0",
                "9.81": "0",
            },
        ),
        (
            SLIDER,
            {
                "B: 0.1": "B: 0.07",
                "y: 0}": "y: 0.03}",
                "phi: 30": "phi: 0",
                "C: ahead": "C: behind",
                "mass: 2": "mass: 0",
            },
        ),
        (
            ROCKER,
            {"D: [0.2, 0]": "D: [0, 0.2]", "angle: 0": "angle: 90", "phi: 60": "phi: 61", "g: ahead": "g: behind"},
        ),
    ],
)
def test_a_program_depends_on_structure_alone(text: str, changes: dict[str, str]) -> None:
    other = text
    for old, new in changes.items():
        assert old in other
        other = other.replace(old, new)
    one, two = plans_from(text), plans_from(other)
    assert one.program == two.program and hash(one.program) == hash(two.program)
    assert one.equations == two.equations and one.moments == two.moments
    assert set(one.given) == set(two.given) and dict(one.given) != dict(two.given)


@pytest.mark.slow
@settings(max_examples=60)
@given(mechanisms(most=3, friction=True))
def test_changed_numbers_leave_a_random_program_the_same(case: Any) -> None:
    """Every length 10 % longer, other rates, masses, loads and coefficients: the same steps."""
    scene = case.scene
    changed = {
        **scene,
        "drive": {k: v * 1.01 if isinstance(v, float) and v else v for k, v in scene["drive"].items()},
        "gravity": 3.3,
        "friction": {k: f / 2 for k, f in scene["friction"].items()},
        "loads": [{k: v * 1.3 if isinstance(v, float) else v for k, v in x.items()} for x in scene["loads"]],
        "links": {
            n: {k: v * 1.5 if k in ("mass", "inertia") else v for k, v in x.items()} for n, x in scene["links"].items()
        },
    }
    assert plans_from(to_yaml(scene)).program == plans_from(to_yaml(changed)).program


def all_steps() -> list[type[Step]]:
    rooms = planes.drafting.steps, planes.drafting.steps.reckoning
    found = {v for room in rooms for v in vars(room).values() if isinstance(v, type)}
    return sorted((s for s in found if issubclass(s, Step)), key=lambda s: s.__name__)


@pytest.mark.parametrize("step", all_steps(), ids=lambda s: s.__name__)
def test_steps_are_frozen_records_with_a_sentence_about_them(step: type[Step]) -> None:
    assert dataclasses.is_dataclass(step)
    with pytest.raises(dataclasses.FrozenInstanceError):
        object.__new__(step).makes = "position:X"  # type: ignore[misc]
    assert step.__doc__ and not step.__doc__.startswith(f"{step.__name__}(")


def test_a_made_step_cannot_be_changed() -> None:
    with pytest.raises(dataclasses.FrozenInstanceError):
        POLE.makes = "x"  # type: ignore[misc]
    program = plans_from(LOADED).program
    for step in program.steps:
        hash(step)
    with pytest.raises(dataclasses.FrozenInstanceError):
        program.steps = ()  # type: ignore[misc]


@pytest.mark.parametrize(
    "one, other", [("B", "b"), ("B", "P"), ("C", "P"), ("C", "c'"), ("B", "x_1"), ("D", "AB"), ("C", "BC")]
)
def test_whatever_the_points_are_called_the_numbers_are_the_same(one: str, other: str) -> None:
    """Names that meet on the small letters, the pole, the directions: "b" beside "B", "P" beside the pole p."""
    text = LOADED.replace("inertia: 0.1}", "inertia: 0.1, centre: E}").replace(
        "{B: 0, C: 0.3}", "{B: 0, C: 0.3, E: [0.1, 0.1]}"
    )
    text = (
        text.replace("E", other) if other == "b" else "".join(part if part != one else other for part in _words(text))
    )
    base = plans_from(
        LOADED.replace("inertia: 0.1}", "inertia: 0.1, centre: E}").replace(
            "{B: 0, C: 0.3}", "{B: 0, C: 0.3, E: [0.1, 0.1]}"
        )
    )
    plans = plans_from(text)
    numbers = []
    for p in (base, plans):
        drawing = draw_program(p.program, {**p.given, **{f"mu_{x}": 1.0 for x in p.plan_names}})
        marks = [m for x in p.points.values() for m in (x.position, x.velocity, x.acceleration)]
        numbers.append([*(drawing[m] for m in marks), drawing[p.balancing], drawing[p.zhukovsky]])
    assert numbers[0] == pytest.approx(numbers[1], rel=1e-12)


def _words(text: str) -> list[str]:
    import re

    return re.split(r"(\W+)", text)


@pytest.mark.parametrize(
    ("line", "back"),
    [
        (Meaning("with", "v_C"), Meaning("against", "v_C")),
        (Meaning("towards", "C", "B"), Meaning("towards", "B", "C")),
        (Meaning("across", "B", "C"), Meaning("across", "B", "C")),
    ],
)
def test_a_direction_the_other_way_means_the_opposite(line: Meaning, back: Meaning) -> None:
    draft = Draft()
    turned = draft.draw_reversed_direction(draft.draw_direction_at_angle("u", 30.0, line))
    assert draft.steps[turned].means == back and draft.steps[draft.draw_reversed_direction(turned)].means == line


def test_what_is_found_by_its_name_has_no_namesake_and_other_values_are_marked() -> None:
    draft = Draft()
    for name in ("v_B", "omega_2", "l_B"):
        draft.add_step(Calculate(name, (Product(1.0, ()),)))
        assert draft.add_step(Calculate(name, (Product(1.0, ()),))) == name  # the same again
    assert draft.add_step(Calculate("l_B", (Product(2.0, ()),))) == "l_B′"
    for name in ("v_B", "omega_2"):
        with pytest.raises(ProgramError):
            draft.add_step(Calculate(name, (Product(2.0, ()),)))
