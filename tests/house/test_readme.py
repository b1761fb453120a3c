"""What the README shows is what the program does."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

from planes.cli import main
from planes.scene import loads
from planes.solving import solve
from tests.helpers import ROOT

README = (ROOT / "README.md").read_text("utf-8")
RUNS = re.findall(r"<!-- run: (.+?) -->\n```text\n(.*?)```", README, re.S)


@pytest.mark.parametrize(("command", "shown"), RUNS, ids=[c for c, _ in RUNS])
def test_shown_output(
    command: str, shown: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(ROOT)
    assert main(shlex.split(command)[1:]) == 0
    assert capsys.readouterr().out == shown


def test_the_scene_of_the_readme_solves() -> None:
    text = re.search(r"<!-- scene -->\n```yaml\n(.*?)```", README, re.S)
    assert text
    solved = solve(loads(text[1]))
    assert len(solved.positions) == 1
    assert not solved.failed


def test_every_picture_is_there() -> None:
    for picture in re.findall(r"!\[.*?\]\((.*?)\)", README):
        assert (ROOT / picture).is_file(), picture


def test_every_command_of_the_table_exists() -> None:
    for command in re.findall(r"^\| `planes ([\w-]+) ", README, re.M):
        with pytest.raises(SystemExit) as stop:
            main([command, "--help"])
        assert stop.value.code == 0


def test_the_two_commands_make_their_own_environment() -> None:
    for mark in ("draw", "tests"):
        command = re.search(rf"<!-- {mark} -->\n```sh\n(.*?)```", README, re.S)
        assert command and "python3 -m venv .venv" in command[1]


def test_the_python_of_the_readme_runs(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    (tmp_path / "samples").symlink_to(ROOT / "samples")
    monkeypatch.chdir(tmp_path)
    shown = re.search(r"<!-- python -->\n```python\n(.*?)```", README, re.S)
    assert shown
    exec(shown[1], {})
    assert (tmp_path / "six-link.svg").is_file()
