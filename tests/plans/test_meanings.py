"""What a name means is said by whoever makes it: a point may be called anything a scene allows."""

from __future__ import annotations

import pytest

from planes.accuracy.variation import alterable_given_names, plans_with_changed_given
from planes.check.grading.mistakes_force import force_variants
from planes.check.grading.plan_steps import PlanSteps
from planes.check.grading.prepared_plan import Asked, plan_marks, prepare
from planes.drafting.steps.reckoning import Calculate
from planes.lesson.data import lesson_data
from planes.plans import Plans, plans_of
from planes.plans.statements.of_scene import scene_plans
from planes.scene import load, loads
from planes.words.names import label_of, plan_of
from tests.helpers import ROOT

RRP = (ROOT / "samples" / "kind-2-rrp.yaml").read_text(encoding="utf-8")
"""A rod BC and a rubbing piston in C: friction is drawn by trials, beside an offset guide."""


def renamed(old: str, new: str) -> str:
    """The sample with a point called otherwise, where it stands in a list of points or alone."""
    text = RRP
    for before, after in (("{", ":"), (" ", ":"), ("point: ", ",")):
        text = text.replace(f"{before}{old}{after}", f"{before}{new}{after}")
    return text


def plans_from(text: str) -> Plans:
    mechanism = loads(text, "s.yaml").mechanism
    assert mechanism is not None
    return plans_of(mechanism)


def test_a_point_named_with_a_minus_is_a_mark_like_any_other() -> None:
    plain, odd = plans_from(RRP), plans_from(renamed("C", "C-"))
    for plan in plain.plan_names:
        named = [m.label.replace("c-", "c").replace("C-", "C") for m in plan_marks(odd, plan)]
        assert named == [m.label for m in plan_marks(plain, plan)] != []


def test_trials_feet_and_places_of_guides_are_asked_of_nobody() -> None:
    plans = plans_from(RRP)
    helpers = {name.label: plans.means[name].quantity for name in plans.auxiliary_marks}
    assert helpers == {"°q-q": "guide", "F_30+": "trial", "F_30-": "trial"}
    asked = {m.label for plan in plans.plan_names for m in plan_marks(plans, plan)}
    assert not asked & set(helpers)


def test_a_point_named_with_a_minus_has_its_frames_in_the_lesson() -> None:
    plain, odd = lesson_data(loads(RRP, "s")), lesson_data(loads(renamed("C", "C-"), "s"))
    assert [f["key"] for f in odd["frames"]] == [f["key"] for f in plain["frames"]]
    assert len(odd["marks"]) == len(plain["marks"])


RUN_TOGETHER = """\
planes: 1
title: {en: A four-bar linkage}
frame: {points: {A: [0, 0], AB: [0.3, 0]}}
links:
  1: {points: {A: 0, BC: 0.1}}
  2: {points: {BC: 0, C: 0.35}}
  3: {points: {AB: 0, C: 0.32}}
assembly: {C: left}
drive: {link: 1, phi: 60, omega: 1}
"""


@pytest.mark.parametrize("rocker", [0.32, 0.1])
def test_a_length_is_its_links_however_the_letters_run_together(rocker: float) -> None:
    """The crank A, BC and the rocker AB, C: both lengths are l_ABC, and now and then as long."""
    plans = plans_from(RUN_TOGETHER.replace("0.32", str(rocker)).replace("0.3,", "0.33,"))
    names = alterable_given_names(plans, plans.link_lengths)
    assert {plans.means[n].link: plans.given[n] for n in names} == {"1": 0.1, "2": 0.35, "3": rocker}
    for name in names:
        other = plans_with_changed_given(plans, name, 1.01 * plans.given[name]).mechanism
        assert [n for n, x in other.links.items() if x != plans.mechanism.links[n]] == [plans.means[name].link]


def test_a_point_called_as_a_part_of_an_acceleration_is_a_point() -> None:
    """n_1 and k_1 on the plans are the ends of the points N_1 and K_1, not of a normal or a Coriolis part."""
    plain = plans_from(RRP)
    for name in ("N_1", "K_1"):
        odd = plans_from(renamed("C", name))
        corners = [c.replace(f"{name}", "C") for c in map(label_of, sorted(odd.program.component_end_marks))]
        assert corners == [c.label for c in sorted(plain.program.component_end_marks)] != []
        assert not any(odd.points[name].acceleration == c for c in odd.program.component_end_marks)


def test_the_arm_of_one_load_is_not_taken_for_that_of_another() -> None:
    """h_P_2_2_C is the arm of the second load on link 2 about C, not of the first about 2_C."""
    load = "\n  - {{link: 2, point: S2, force: {0}, direction: {0}}}"
    more = load.format(10) + load.format(20) + "\ngravity:"
    plans = plans_from(RRP.replace("\ngravity:", more))
    of = {n: m.of for n, m in plans.means.items() if m.quantity == "arm"}
    assert {name: of[name] for name in of if "P_2" in name} == {"h_P_2_C": "P_2", "h_P_2_2_C": "P_2_2"}
    bench = prepare(Asked(loads(RRP.replace("\ngravity:", more), "s.yaml"), "force:2-3"))
    ways = PlanSteps(bench.plans, bench.program, bench.plan)
    left_out = [v for v in force_variants(ways) if v.mistake == "force_missing" and v.blames == "P_2"]
    for variant in left_out:
        for step in (s for swap in variant.swaps.values() for s in swap if isinstance(s, Calculate)):
            own = ways.steps[step.makes]
            assert isinstance(own, Calculate)
            touched = [a.factors for a, b in zip(own.terms, step.terms, strict=True) if a != b]
            assert [n for factors in touched for n, _ in factors if n in of] == ["h_P_2_C"]
    assert len(left_out) == 2


def test_only_vectors_of_points_of_the_frame_have_its_number() -> None:
    """The block of the press has a place on the frame's guide, and one on the guide of plate 2."""
    press = (ROOT / "samples" / "class-four" / "press.yaml").read_text(encoding="utf-8")
    assert plans_from(press).lettering_basis["grounded"] == ["v_G0", "v_GG0", "a_G0", "a_GG0"]


@pytest.mark.parametrize("name", ["carriage", "excavator", "hinge-motor"])
def test_a_moment_equation_belongs_to_one_force_plan(name: str) -> None:
    """Where one link of a group has a force plan of its own as well."""
    plans = scene_plans(load(ROOT / "samples" / f"{name}.yaml"))
    each = [
        m.unknown for plan in plans.plan_names if plan.is_force for m in plans.moment_equations_on_links(plan.links)
    ]
    assert len(each) == len({*each})


def test_a_stated_tangential_part_is_one_and_no_other_force_is() -> None:
    """The lesson tells why it is laid off; a normal part, and a whole reaction, have no such reason."""
    plans = scene_plans(load(ROOT / "samples" / "vectors" / "group.yaml"))
    kinds = {label_of(n): m.quantity for n, m in plans.means.items() if plan_of(n).is_force}
    assert {n for n, kind in kinds.items() if kind == "tangential"} == {"F_21t", "F_36t"}
    assert kinds["G_2"] == "weight" and "F_21n" not in kinds and "F_24" not in kinds
