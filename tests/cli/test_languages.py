"""Every message of a command in one language: the one asked for by ``--lang``, else the system's."""

from __future__ import annotations

import re

import pytest

from planes.cli import main, requested_lang
from tests.cli.test_options import CRANK, VECTORS

NAMES = """planes solve structure sheet lesson note check blank cycle chart course crank slider phi pencil ru en text
strokes hand cad kN mm position velocity acceleration force abc lang output nothere"""
"""What is written so in any language: commands, options, files and units."""
WRONG = {
    "solve": [
        ["--seed", "q"],
        ["--phi", "x"],
        ["--phi", "0:9"],
        ["--phi"],
        ["--p", "3"],
        ["--json=3"],
        ["--mu", "abc"],
    ],
    "structure": [["--json=3"], ["--phi", "3"]],
    "sheet": [[], ["-o", "a.abc"], ["-o", "a.svg", "--sheet", "3"], ["-o", "a.svg", "--sheet", "1", "--view", "abc"]],
    "lesson": [[], ["-o", "a.abc"], ["-o", "/nothere/a.html"]],
    "note": [[], ["-o", "a.abc"], ["-o", "a.html", "--phi", "0,5"]],
    "cycle": [["--omega", "q"], ["--omega", "nan"], ["--graphical", "q"], ["--pole", "3"], ["--show", ","]],
    "chart": [[], ["-o", "a.abc"]],
    "crank-slider": [["--phi", "q"], ["-o", "a.html"]],
    "check": [[], ["--plan", "abc"], ["a.csv", "--plan", "velocity"], ["--plan", "velocity", "--work", "abc"]],
    "blank": [[], ["-o", "a.pdf", "--mu", "abc"], ["-o", "a.pdf", "--plan", "abc"]],
}
WRONG_COURSE = [[], ["nothere"], ["nothere", "--jobs", "q"], ["nothere", "--jobs", "0"]]
CASES = {
    "nothing": [["nothere"], ["--abc"]],
    "course": [["course", *more] for more in WRONG_COURSE],
    **{
        name: [[name, "nothere.yaml"], [name, VECTORS, *wrong[-1]], *([name, CRANK, *more] for more in wrong)]
        for name, wrong in WRONG.items()
    },
}


def told(argv: list[str], capsys: pytest.CaptureFixture[str]) -> str:
    try:
        assert main(argv) in (0, 2)
    except SystemExit as stop:
        assert stop.code in (0, 2)
    said = capsys.readouterr()
    return said.err + (said.out if "--help" in argv else "")


@pytest.mark.parametrize("command", CASES)
def test_no_message_mixes_languages(command, capsys, monkeypatch, tmp_path) -> None:
    monkeypatch.chdir(tmp_path)
    for argv in CASES[command]:
        monkeypatch.setenv("LC_ALL", "ru_RU.UTF-8")
        english = told([*argv, "--lang", "en"], capsys)
        assert not re.search("[а-яё]", english, re.IGNORECASE)
        monkeypatch.setenv("LC_ALL", "C")
        russian = told([*argv[:1], "--lang=ru", *argv[1:]], capsys)
        own = re.sub(r"[\"'][^\"']*[\"']|\S*[/.]\S*|\{[^}]*\}|[-_]\w+", " ", russian)
        assert not {*re.findall("[A-Za-z]*[a-z]{2,}", own)} - {*NAMES.split()}, russian
        assert bool(english) == bool(re.search("[а-я]", russian))


@pytest.mark.parametrize("command", ["", *WRONG, "course"])
@pytest.mark.parametrize("home", ["C", "ru_RU.UTF-8"])
def test_help_is_in_the_language_asked_for(command, home, capsys, monkeypatch) -> None:
    monkeypatch.setenv("LC_ALL", home)
    argv = [command] if command else []
    if command:
        assert not re.search("[а-яё]", told([*argv, "--lang", "en", "--help"], capsys), re.IGNORECASE)
    said = told([*argv, "--help"], capsys)
    assert ("показать эту справку" in said) == (home != "C") == ("show this help" not in said)


def test_the_last_language_asked_for_counts_wherever_it_stands(monkeypatch) -> None:
    monkeypatch.setenv("LC_ALL", "C")
    assert requested_lang(["solve", "x", "--lang", "ru", "--phi", "q"]) == "ru"
    assert requested_lang(["solve", "--lang=ru", "--lan", "en"]) == "en"
    assert (
        requested_lang(["solve", "--lang", "fr"])
        == requested_lang(["solve", "--language", "ru"])
        == requested_lang([])
        == "en"
    )


def test_what_a_person_wrote_is_not_translated(capsys) -> None:
    said = told(["solve", CRANK, "--seed", "argument options: x", "--lang", "ru"], capsys)
    assert "нужно целое число, а не 'argument options: x'" in said
