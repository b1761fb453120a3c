"""One runner draws every program: each step once, even where the drawing goes no further."""

from __future__ import annotations

from collections import Counter
from typing import Any

import pytest

from planes.drafting.drawing import draw_until_failure
from planes.drafting.steps import Step
from planes.drafting.tools import Tool
from planes.plans.scales import unit_scales_of_plans
from planes.plans.statements.of_scene import scene_plans
from planes.scene import load
from tests.helpers import ROOT


@pytest.mark.parametrize(("phi", "whole"), [(150.0, True), (30.0, False)])
def test_a_drawing_is_drawn_once_as_far_as_it_goes(monkeypatch: pytest.MonkeyPatch, phi: float, whole: bool) -> None:
    plans = scene_plans(load(str(ROOT / "samples" / "six-link.yaml")))
    drawn, draw = Counter[str](), Tool.draw

    def counted(tool: Tool, step: Step, things: dict[str, Any]) -> Any:
        drawn[step.makes] += 1
        return draw(tool, step, things)

    monkeypatch.setattr(Tool, "draw", counted)
    drawing, failure = draw_until_failure(
        plans.program, {**plans.given, **unit_scales_of_plans(plans), plans.drive_given_name: phi}
    )
    assert (failure is None) == whole == (drawing.program.steps == plans.program.steps)
    assert set(drawn.values()) == {1} and drawing.program.result_names <= set(drawing.things)


def test_what_is_fixed_stays_whatever_leads_to_it() -> None:
    program = scene_plans(load(str(ROOT / "samples" / "six-link.yaml"))).program
    moved = [s.makes for s in program.steps_to_redraw(["l_AB"])]
    assert {"position:B", "position:C"} <= set(moved)
    fixed = [s.makes for s in program.steps_to_redraw(["l_AB"], fixed=["position:B"])]
    assert "position:B" in fixed and "position:C" not in fixed
    redrawn = {s.makes for s in program.steps_to_redraw([], ["position:B"])}
    assert {"position:B", "position:C"} <= redrawn < set(moved)  # l_AB leads to more than B
