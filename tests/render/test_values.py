"""Values beside the vectors of plans, where a sheet asks for them: the right ones, and none on other ink."""

from __future__ import annotations

import re

import pytest

from planes.scene import load
from planes.solving import solve
from planes.words.read_off import read_off_text
from render.paper.marks import Text
from render.paper.typeset import plain_text
from tests.helpers import ROOT
from tests.helpers.sheets import sheet
from tests.sheets_run import clashes


def beside(found) -> list[str]:
    """The names of vectors with their values."""
    return [plain_text(m.text) for m in found.marks if isinstance(m, Text) and m.name.startswith("value")]


@pytest.mark.few(1)
@pytest.mark.parametrize(("number", "unit"), [(1, "м/с²"), (2, "Н")])
def test_vectors_have_their_values(number, unit):
    results = solve(load(ROOT / "samples" / "kind-1-rrr.yaml"), None, None, "ru").positions[0].results
    sizes = {"vC": abs(complex(*results["points"]["C"]["v"])), "F21": abs(complex(*results["reactions"]["F_21"]))}
    found = sheet("kind-1-rrr", number=number, values=True)
    told = beside(found)
    name = "vC" if number == 1 else "F21"
    assert any(re.search(rf"\b{name}\b.* {re.escape(read_off_text(sizes[name], 'ru'))}$", text) for text in told)
    assert len(told) >= 8 and clashes(found) == []
    assert any(unit in plain_text(m.text) and "величины" in m.text for m in found.marks if isinstance(m, Text))
