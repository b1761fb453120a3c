"""Of many positions too, none that contradicts itself gives a number: wrong formulas are put in for some of them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from planes.cli import main
from planes.course.survey import survey_rows
from planes.drafting.steps import Similar
from planes.drafting.steps.reckoning import Calculate
from planes.scene import load
from planes.solving import solve
from planes.words.errors import Contradiction
from tests.plans.test_proofs import COUPLE, WRONG, Spoil, cycle_of
from tests.solving.test_failures import SLIDER

HIGH = np.arange(20.0, 84.0)
RATES = SLIDER.replace("C: 0.3", "C: 0.3, S: [0.1, 0.1]")


def spoiled(phi: Any) -> Any:
    """Neither the first positions nor the last."""
    return (phi > 50) & (phi < 75)


def bent(m: pytest.MonkeyPatch) -> None:
    """The third point of a link is drawn in a wrong place of the velocity plan, between 50° and 75° alone."""
    similar = Similar.draw

    def wrong(self: Similar, env: Any, tool: Any) -> Any:
        off = tool.ar.where(spoiled(env["angle_x_1"]), 1.001, 1.0) if self.makes == "velocity:s" else 1.0
        return similar(self, env, tool) * off

    m.setattr(Similar, "draw", wrong)


def unbalanced(m: pytest.MonkeyPatch) -> None:
    """A tangential part of a reaction is reckoned wrong, between 50° and 75° alone."""
    value = Calculate.draw

    def wrong(self: Calculate, env: Any, tool: Any) -> Any:
        off = tool.ar.where(spoiled(env["angle_x_1"]), 1.001, 1.0) if self.makes == "F_21^t" else 1.0
        return value(self, env, tool) * off

    m.setattr(Calculate, "draw", wrong)


@pytest.mark.parametrize(
    "fast", [False, pytest.param(True, marks=pytest.mark.needs("llvmlite"))], ids=["arrays", "compiled"]
)
@pytest.mark.parametrize(
    "spoil, scene, names, reason",
    [
        (bent, RATES, ["r_C", "r_S", "v_C", "v_S", "omega_2"], "link_bent"),
        (unbalanced, SLIDER + COUPLE, ["F_21", "F_30"], "link_unbalanced"),
    ],
    ids=["bent", "unbalanced"],
)
def test_a_position_that_fails_a_proof_of_what_is_asked_is_masked(
    spoil: Spoil, scene: str, names: list[str], reason: str, fast: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    scene = scene.replace("phi: 60", "phi: 40")
    (right,) = cycle_of(scene, names).blocks(HIGH, fast=fast)
    assert not right.failed_mask.any() and np.isfinite(right.table).all()
    spoil(monkeypatch)
    c = cycle_of(scene, names)
    (block,) = c.blocks(HIGH, fast=fast)
    assert (block.failed_mask == spoiled(HIGH)).all() and np.isnan(block.table[:, block.failed_mask]).all()
    assert {c.reasons[k - 1].key for k in set(block.codes[block.failed_mask].tolist())} == {reason}
    assert np.allclose(block.table[:, ~block.failed_mask], right.table[:, ~block.failed_mask], rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize(
    "fast", [False, pytest.param(True, marks=pytest.mark.needs("llvmlite"))], ids=["arrays", "compiled"]
)
def test_one_wrong_position_among_thousands_is_masked(fast: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    values, similar = np.linspace(40.0, 60.0, 4001), Similar.draw

    def wrong(self: Similar, env: Any, tool: Any) -> Any:
        return similar(self, env, tool) + tool.ar.where(abs(env["angle_x_1"] - values[2222]) < 1e-9, 1e-6, 0.0)

    monkeypatch.setattr(Similar, "draw", wrong)
    blocks = cycle_of(RATES).blocks(values, fast=fast)
    assert np.flatnonzero(np.concatenate([b.failed_mask for b in blocks])).tolist() == [2222]


def test_a_table_says_of_a_contradiction_what_a_position_says(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    scene, out = tmp_path / "s.yaml", tmp_path / "t.csv"
    scene.write_text(RATES.replace("phi: 60", "phi: 40") + "find: [r_C, r_S, v_C, v_S, omega_2]\n", encoding="utf-8")
    bent(monkeypatch)
    assert main(["cycle", str(scene), "--phi", "40:60:1", "-o", str(out)]) == 2
    assert "the points of link 2 do not move as one body" in capsys.readouterr().err
    rows = out.read_text(encoding="utf-8").splitlines()[1:]
    assert [row.endswith("link_bent") for row in rows] == [k > 10 for k in range(21)]


@pytest.mark.few(1)
@pytest.mark.parametrize("spoil, scene, reason, plan", WRONG.values(), ids=WRONG.keys())
def test_a_folder_refuses_what_a_scene_refuses(
    spoil: Spoil, scene: str, reason: str, plan: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "scene.yaml"
    path.write_text(scene, encoding="utf-8")
    assert all(row.is_right for row in survey_rows((str(path), "en", None)))
    spoil(monkeypatch)
    with pytest.raises(Contradiction) as refused:
        solve(load(str(path)))
    (row,) = survey_rows((str(path), "en", None))
    assert refused.value.reason == reason and not row.is_right and not row.solved
    assert row.balancing is None and any(refused.value.told("en") in remark for remark in row.remarks)
