"""The moment equations a sheet has: the products beneath add up, with the signs between them, to what is found."""

from __future__ import annotations

from itertools import pairwise

import pytest

from planes.plans.measuring import scene_lettering
from planes.scene import load
from planes.solving import solve
from planes.words.naming import Naming
from render.paper.marks import Text
from render.views.moments import MomentLines
from tests.helpers import ROOT
from tests.helpers.sheets import sheet

SCENES = [*(ROOT / "samples" / "class-three").glob("*.yaml"), ROOT / "samples" / "class-four" / "tray.yaml"]
SCENES += [ROOT / "samples" / f"{name}.yaml" for name in ("six-link", "folding-boom")]


@pytest.mark.few(5)
@pytest.mark.parametrize("path", sorted(SCENES), ids=lambda p: p.stem)
def test_what_is_told_beneath_adds_up(path):
    scene = load(path)
    here = solve(scene).positions[0]
    lines = MomentLines(here, Naming("en", **scene_lettering(scene, here.plans)))
    for equation in here.plans.moments:
        words = lines.equation_words(equation)
        if not words:
            continue
        number = lambda w: float(w.value.replace("−", "-").replace("·10", "e"))  # noqa: E731
        signs = [-1 if a.text == "−" or b.text.startswith("−") else 1 for a, b in pairwise(words[1:]) if b.value]
        terms = [sign * number(w) for sign, w in zip(signs, [w for w in words[2:] if w.value], strict=True)]
        assert number(words[1]) == pytest.approx(sum(terms), abs=0.01 * max(map(abs, terms)))
        if equation.arm:  # a reaction is drawn as it acts: its moment, too, is a size
            assert number(words[1]) >= 0 and "−" not in words[-1].text


def test_the_lever_of_a_driver_at_rest_has_a_scale():
    """3000 N on an arm of 82.8 mm at 1000 mm/m make 248 N·m."""
    texts = {m.text for m in sheet("bntu-1", number=2).marks if isinstance(m, Text)}
    assert "Рычаг Жуковского, μ_{q} = 1000 мм/м" in texts and "82,8" in texts
