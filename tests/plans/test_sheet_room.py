"""Plans are as large as the formats of their sheets hold, and no μ depends on who asks for it."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest

from planes.documents.sheets import sheet_of
from planes.plans import Plans
from planes.plans.scales import PLAN_FIT_MM, ScaleChoice, plan_scales, plan_sizes
from planes.plans.sheet_room import LARGER_SIZES, SheetRoom
from planes.scene import Scene, load
from planes.solving import plans_and_requested_results, solve
from tests.helpers import ROOT

SAMPLES = ROOT / "samples"
OPEN = [f"assignments/{n:02d}" for n in (1, 5, 9, 15, 19, 27, 33, 35, 39, 51, 53, 55, 57, 59, 61, 65, 67)]
"""Scenes that leave μ open; those of 15, 39 and 65 take a larger format for one of their sheets."""


@cache
def scene_and_plans(name: str) -> tuple[Scene, Plans]:
    scene = replace(load(SAMPLES / f"{name}.yaml"), find=None)
    return scene, plans_and_requested_results(scene)[0]


@pytest.mark.parametrize("name", ["kind-1-rrr", "bntu-2", "assignments/33", "class-three/press", "sliding-driver"])
def test_sizes_are_usual_ones_or_larger_ones(name: str) -> None:
    scene, plans = scene_and_plans(name)
    sizes = plan_sizes(plans, {}, {})
    ratios = {kind: round(sizes[kind] / mm, 6) for kind, mm in PLAN_FIT_MM.items()}
    assert {*ratios.values()} <= {*LARGER_SIZES}
    assert ratios["velocity"] == ratios["acceleration"]
    assert plan_sizes(plans, scene.mu, {"format": "A3"}) == {k: 0.7 * mm for k, mm in PLAN_FIT_MM.items()}


def test_a_roomy_sheet_has_plans_as_large_as_any_and_a_full_one_the_usual() -> None:
    plans = scene_and_plans("bntu-2")[1]
    assert {*plan_sizes(plans, {}, {}).values()} >= {140.0, 210.0, 196.0}  # A2 is not half full
    choice = ScaleChoice.of(plans, {})
    room = SheetRoom(plans, choice.drawing)
    crowded = {kind: 12.0 * mm for kind, mm in PLAN_FIT_MM.items()}
    largest = room.largest_sizes(crowded, choice.scales_at)
    assert choice.scales_at(largest) == choice.scales_at(crowded)  # no format holds more


@pytest.mark.parametrize("name", ["assignments/07", "assignments/33", "kind-1-rrr"])
def test_the_area_of_figures_grows_with_their_scales(name: str) -> None:
    plans = scene_and_plans(name)[1]
    choice = ScaleChoice.of(plans, {})
    room = SheetRoom(plans, choice.drawing)
    usual = choice.scales_at(PLAN_FIT_MM)
    more = {mu: 2.0 * value for mu, value in usual.items()}
    for sheet in (room.first_sheet, room.second_sheet):
        figures = sheet.area_mm2(usual) - sheet.text_mm2
        assert 2.0 < (sheet.area_mm2(more) - sheet.text_mm2) / figures < 4.0  # margins do not grow


@pytest.mark.parametrize("name", ["kind-1-rrr", "assignments/07"])
def test_what_is_asked_alone_has_the_sizes_of_the_whole(name: str) -> None:
    scene, plans = scene_and_plans(name)
    alone = plans_and_requested_results(replace(scene, find=("v_B",)), shown=True)[0]
    assert alone.uncut and {*alone.plan_names} < {*plans.plan_names}
    assert plan_sizes(alone, scene.mu, {}) == plan_sizes(plans, scene.mu, {})
    assert plan_scales(alone, scene.mu)["mu_position"] == plan_scales(plans, scene.mu)["mu_position"]


def test_a_scale_of_the_scene_wins() -> None:
    scene, plans = scene_and_plans("kind-1-rrr")
    said = {**scene.mu, "velocity": 7.0, "force": 0.03}
    scales = plan_scales(plans, said)
    for plan in plans.plan_names:
        if plan.kind in ("velocity", "force"):
            assert scales[plan.mu_name] == said[plan.kind]


def test_every_position_of_the_drive_has_a_choice() -> None:
    scene, plans = scene_and_plans("assignments/07")
    solved = solve(scene, [30.0 * k for k in range(12)])
    for position in solved.positions:
        moved = plans.drive_givens_at(position.at)
        sizes = plan_sizes(plans, scene.mu, scene.sheet, moved)
        assert position.scales == plan_scales(plans, scene.mu, moved) == plan_scales(plans, scene.mu, moved, sizes)


def _papers(name: str) -> list[str]:
    scene = scene_and_plans(name)[0]
    return [sheet_of(scene, None, "ru", number).paper.name for number in (1, 2)]


@pytest.mark.slow
def test_sheets_keep_the_formats_they_have_at_the_usual_sizes(monkeypatch: pytest.MonkeyPatch) -> None:
    """One in ten may need a larger one: nothing is laid out before the scales are chosen."""
    grown = [paper for name in OPEN for paper in _papers(name)]
    monkeypatch.setattr(SheetRoom, "largest_sizes", lambda self, usual, scales_at: usual)
    usual = [paper for name in OPEN for paper in _papers(name)]
    assert sum(a != b for a, b in zip(grown, usual, strict=True)) <= len(grown) // 10
