"""The scheme with loads is the largest figure of its sheet, as far as that has room and the scene leaves its μ open."""

from __future__ import annotations

import pytest

from planes.documents.sheets import MOST_SCHEME_ENLARGEMENT, DrawnPosition
from planes.scene import load, loads
from render.sheet.sizes import Sizes
from tests.helpers import ROOT
from tests.helpers.sheet_faults import longest
from tests.helpers.sheets import sheet

RPR = ROOT / "samples" / "kind-3-rpr.yaml"


@pytest.mark.few(1)
@pytest.mark.parametrize("name", ["kind-3-rpr", "bntu-1", "kind-1-rrr", "assignments/12"])
def test_the_scheme_with_loads_is_the_largest_figure(name):
    figures = {v.key: longest(v) for v, _, _ in sheet(name, number=2).views if v.figure and v.key != "apart"}
    assert figures["loaded"] > 0.85 * max(figures.values()), figures  # a force polygon at its μ may be a little larger


@pytest.mark.parametrize("name", ["shaper.yaml", "bntu-1.yaml", "kind-3-rpr.yaml", "assignments/58.yaml"])
def test_the_scheme_with_loads_is_at_most_twice_its_groups(name):
    drawn = DrawnPosition(load(ROOT / "samples" / name), None, "ru")
    assert [
        drawn.loaded_scheme_enlargement(Sizes().with_larger_plan("loaded", k)) <= MOST_SCHEME_ENLARGEMENT
        for k in (1.0, 1.6, 2.5, 6.0)
    ] == [True] * 4


def test_a_scheme_grows_by_scales_of_the_standard_and_not_where_its_scale_is_stated():
    drawn = DrawnPosition(load(RPR), None, "ru")
    usual = drawn.position_at_scene_scales.scales["mu_position"]
    grown = drawn.with_enlarged_scheme(Sizes().with_larger_plan("loaded", 1.42)).scales
    assert (usual, grown["mu_position"]) == (250.0, 500.0)  # 1:4 and 1:2
    assert {k: mu for k, mu in grown.items() if k != "mu_position"} == {
        k: mu for k, mu in drawn.position_at_scene_scales.scales.items() if k != "mu_position"
    }
    stated = loads(RPR.read_text(encoding="utf-8") + "\nplans: {position: 250 mm/m}\n")
    assert DrawnPosition(stated, None, "ru").loaded_scheme_extents(Sizes()) == {}
