"""Files and options of every command stand on its line in any order."""

from __future__ import annotations

import argparse
import random
import shutil
from pathlib import Path

import pytest

from planes.cli import command_line_parser, main
from tests.helpers import ROOT

COMMANDS = next(a for a in command_line_parser("en")._actions if isinstance(a, argparse._SubParsersAction)).choices


def told(action: argparse.Action) -> list[list[str]]:
    """The ways to say an option."""
    name = action.option_strings[-1]
    value = str(next(iter(action.choices))) if action.choices else "30" if action.type else "a=1,2"
    if action.nargs == 0:
        return [[name]]
    return [[name, value], [f"{name}={value}"], *([[name]] if action.nargs == "?" else [])]


@pytest.mark.parametrize("command", [name for name in COMMANDS if name not in ("essay", "new", "schema", "completion")])
def test_options_stand_anywhere(command: str) -> None:
    """Before, between and after the files, thirty lines a command: each is read as with the files in front."""
    parser, rng, reader = COMMANDS[command], random.Random(1), command_line_parser("en")
    files = [f"{a.dest}.file" for a in parser._actions if not a.option_strings]
    apart = {a for group in parser._mutually_exclusive_groups for a in group._group_actions[1:]}
    options = [a for a in parser._actions if a.option_strings and a.dest != "help" and a not in apart]
    assert files and len(options) > 1
    for _ in range(30):
        chosen = [rng.choice(told(a)) for a in options if a.required or rng.random() < 0.5]
        rng.shuffle(chosen)
        line = [[name] for name in files]
        for option in chosen:
            line.insert(rng.randrange(len(line) + 1), option)
        mixed = [word for part in line for word in part]
        in_front = [*files, *(word for part in line if part[0] not in files for word in part)]
        assert vars(reader.parse_args([command, *mixed])) == vars(reader.parse_args([command, *in_front])), mixed


def test_a_drawing_after_the_options_is_checked(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scene, file = str(ROOT / "samples" / "kind-2-rrp.yaml"), str(tmp_path / "v.svg")
    assert main(["sheet", "--view", "velocity-plan", scene, "-o", file]) == 0
    assert main(["check", scene, "--plan", "velocity", file, "--lang", "en"]) == 0
    assert main(["check", "--lang", "en", scene, "--plan=velocity", "--json", file]) == 0
    capsys.readouterr()


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("check s.yaml a.svg b.svg --plan velocity", "unrecognized arguments: b.svg"),
        ("check s.yaml --plan velocity a.svg b.svg", "unrecognized arguments: b.svg"),
        ("solve s.yaml --nothing", "unrecognized arguments: --nothing"),
        ("solve --json", "required: SCENE"),
        ("cycle --graphical", "required: SCENE"),
    ],
)
def test_what_is_over_or_missing_is_named(
    line: str, said: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("LC_ALL", "C")
    with pytest.raises(SystemExit) as stop:
        main(line.split())
    assert stop.value.code == 2 and said in capsys.readouterr().err


def test_a_table_of_marks_without_its_plan_is_answered_with_the_plans(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    marks = tmp_path / "marks.csv"
    marks.write_text("mark,x,y\na,-57.8,48.5\n", encoding="utf-8")
    assert main(["check", "--lang", "en", str(ROOT / "samples" / "kind-2-rrp.yaml"), str(marks)]) == 2
    assert "marks.csv shows: --plan position, velocity, acceleration, force:2-3, force:1." in capsys.readouterr().err


@pytest.mark.parametrize("line", ["--lang ru --help", "--help --lang=ru", "--lang ru solve --help"])
def test_help_is_in_the_language_that_stands_before_it(line: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stop:
        main(line.split())
    assert stop.value.code == 0 and (told := capsys.readouterr().out).startswith("использование: planes")
    assert "show program" not in told


def test_a_file_whose_name_looks_like_an_option(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    shutil.copy(ROOT / "samples" / "kind-2-rrp.yaml", "-s.yaml")
    assert main(["structure", "--json", "--", "-s.yaml"]) == 0
