"""A command states the mechanism once, however many of its parts ask for the plans."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import planes
from planes.cli import main
from planes.plans import Plans
from planes.plans.statements import of_scene
from tests.helpers import ROOT

RRR = str(ROOT / "samples" / "kind-1-rrr.yaml")
COMMANDS = {
    "solve": ["--phi", "0:120:60", "--errors", "--remedy", "--json"],
    "solve --explain": ["--explain"],
    "solve --pencil": ["--pencil", "--errors", "--remedy"],
    "structure": [],
    "sheet": ["--remedy", "-o", "sheet.svg"],
    "note": ["-o", "note.html"],
    "blank": ["--plan", "velocity", "-o", "blank.svg"],
    "cycle": ["--phi", "0:60:10", "-o", "cycle.csv"],
    "check": ["marks.csv", "--plan", "velocity", "--work", "cad"],
    "check --trace": ["--trace", "--plan", "velocity", "-o", "trace.html"],
}


@pytest.fixture
def stated(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The files whose mechanisms were stated."""
    found: list[str] = []
    state = vars(of_scene)["plans_of"]

    def counted(mechanism: Any, file: str = "") -> Plans:
        found.append(file)
        plans: Plans = state(mechanism, file)
        return plans

    monkeypatch.setattr(of_scene, "plans_of", counted)
    return found


@pytest.mark.few(4)
@pytest.mark.parametrize("command", COMMANDS)
def test_a_command_states_the_mechanism_once(
    command: str, stated: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("marks.csv").write_text("mark,x_mm,y_mm\np,0,0\nb,-34.5,-28.7\nc,-3.2,-27.1\n", encoding="utf-8")
    assert main([command.split()[0], RRR, *COMMANDS[command]]) in (0, 3)
    assert stated == [RRR]


def test_a_scene_solved_again_is_not_stated_again(stated: list[str]) -> None:
    scene = planes.load(RRR)
    for phi in (30.0, 60.0):
        planes.solve(scene, phi)
    planes.solve(scene, [30.0, 60.0])
    planes.cycle(scene, ["v_C"], phi=[30.0, 60.0])
    assert len(stated) == 1
