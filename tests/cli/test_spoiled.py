"""Files spoiled at random: every command ends in a result or a sentence."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from tests.helpers import ROOT
from tests.helpers.spoiled import fault, made, spoiled

SAMPLES = sorted((ROOT / "samples").glob("*.yaml")) + sorted((ROOT / "samples/vectors").glob("*.yaml"))


@pytest.mark.few(30)
@pytest.mark.parametrize("seed", range(200))
def test_a_spoiled_scene_ends_in_a_result_or_a_sentence(seed: int, tmp_path: Path) -> None:
    rng = random.Random(f"test {seed}")
    text = spoiled(rng.choice(SAMPLES).read_text("utf-8"), rng)
    assert fault(["solve", str(made(tmp_path, text, ".yaml")), "--lang", "en"]) == ""
