"""What `--explain` lists: every step of every sample is told, in both languages."""

from __future__ import annotations

import pytest

from planes.plans.statements.of_scene import scene_plans
from planes.scene import load
from planes.solving.explaining import explain_steps
from planes.words import Lang
from tests.helpers import ROOT

SCENES = sorted(p for p in (ROOT / "samples").rglob("*.yaml") if not {"assignments", "course"} & {*p.parts})


@pytest.mark.few(0)
@pytest.mark.parametrize("lang", ["ru", "en"])
def test_every_step_of_every_sample_is_told(lang: Lang) -> None:
    assert len(SCENES) > 20
    for path in SCENES:
        scene = load(str(path))
        listed = [
            line.split(":")[0].strip() for line in explain_steps(scene, lang).splitlines() if line.startswith("  ")
        ]
        assert len(listed) == len(scene_plans(scene).program.steps), path


@pytest.mark.parametrize("lang", ["ru", "en"])
def test_an_assembly_that_is_followed_is_one_thing(lang: Lang) -> None:
    lines = explain_steps(load(str(ROOT / "samples/class-three/press.yaml")), lang).splitlines()
    assert max(map(len, lines)) < 300 and not any("track_" in line or "turning_" in line for line in lines)


def test_vectors_are_called_as_in_every_other_answer() -> None:
    """On a fixed guide v_BB0 is v_B; what a slider does has the number of its link; I is written Φ."""
    text = explain_steps(load(str(ROOT / "samples/crank-slider.yaml")), "en")
    assert "  v_3: " in text and "  Φ_2: " in text and "  v_B: " in text
    assert not any(name in text for name in ("BB0:", "slide_3", "  I_2:"))
