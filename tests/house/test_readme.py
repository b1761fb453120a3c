"""What the README shows, in English and in Russian, is what the program does."""

from __future__ import annotations

import re
import shlex
from itertools import pairwise
from pathlib import Path

import pytest

from planes.cli import main
from planes.scene import loads
from planes.solving import solve
from tests.helpers import ROOT

READMES = {lang: (ROOT / name).read_text("utf-8") for lang, name in {"en": "README.md", "ru": "README.ru.md"}.items()}
MARKS = ["draw", "tests", "run", "scene", "python"]
OWN = {"drawing.svg"}  # what an earlier command of the table writes

both = pytest.mark.parametrize("lang", READMES)


def marked(lang: str, mark: str) -> str:
    """The block of code that stands under a mark."""
    found = re.search(rf"<!-- {mark}\b.*? -->\n```\w+\n(.*?)```", READMES[lang], re.S)
    assert found, mark
    return found[1]


def commands(lang: str) -> list[list[str]]:
    """The commands of the table, as words."""
    return [shlex.split(c) for c in re.findall(r"^\| `\.venv/bin/planes (.+?)` \|", READMES[lang], re.M)]


def prose(lang: str) -> list[str]:
    """The lines for people: no blocks, no code, no addresses, no names of languages."""
    text = re.sub(r"<!-- .*? -->|```.*?```|`[^`]*`|\]\(.*?\)|\[?(English|Русский)\]?", "", READMES[lang], flags=re.S)
    return [line for line in text.splitlines() if re.search(r"\w", line)]


def cyrillic(text: str) -> int:
    return len(re.findall("[а-яё]", text, re.I))


@both
def test_shown_output(lang: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    runs = re.findall(r"<!-- run: (.+?) -->\n```text\n(.*?)```", READMES[lang], re.S)
    assert runs
    for command, shown in runs:
        assert command.endswith(f"--lang {lang}")
        assert main(shlex.split(command)[1:]) == 0
        assert capsys.readouterr().out == shown


@both
def test_the_scene_of_the_readme_solves(lang: str) -> None:
    solved = solve(loads(marked(lang, "scene")))
    assert len(solved.positions) == 1
    assert not solved.failed


@both
def test_every_picture_and_page_is_there(lang: str) -> None:
    for address in re.findall(r"\[.*?\]\((.*?)\)", READMES[lang]):
        assert (ROOT / address).exists(), address


@both
def test_every_command_of_the_table_can_be_typed(lang: str) -> None:
    written = set(OWN)
    for command in commands(lang):
        with pytest.raises(SystemExit) as stop:
            main([*command, "--help"])
        assert stop.value.code == 0
        written |= {after for word, after in pairwise(command) if word == "-o"}
        files = [word for word in command if "/" in word or word in written]
        assert files and all(word in written or (ROOT / word).exists() for word in files), command


@both
def test_the_two_commands_make_their_own_environment(lang: str) -> None:
    for mark in ("draw", "tests"):
        assert "python3 -m venv .venv" in marked(lang, mark)


@pytest.mark.few(1)
@both
def test_the_python_of_the_readme_runs(lang: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    (tmp_path / "samples").symlink_to(ROOT / "samples")
    monkeypatch.chdir(tmp_path)
    exec(marked(lang, "python"), {})
    assert (tmp_path / "six-link.svg").is_file()


@both
def test_it_is_short_and_leads_to_the_other(lang: str) -> None:
    lines = READMES[lang].splitlines()
    assert len(lines) < 200
    other = {"en": "(README.ru.md)", "ru": "(README.md)"}[lang]
    assert any(other in line for line in lines[:4])


def test_both_say_the_same_commands() -> None:
    en, ru = commands("en"), commands("ru")
    assert len(en) >= 15
    assert en == ru
    for mark in ("draw", "tests"):
        assert marked("en", mark) == marked("ru", mark)
    for text in READMES.values():
        assert re.findall(r"<!-- (\w+)", text) == MARKS
    tables = [re.sub(r"[^|\n]", "", text) for text in READMES.values()]
    assert re.findall(r"^\|.*", tables[0], re.M) == re.findall(r"^\|.*", tables[1], re.M)


def test_each_is_whole_in_its_own_language() -> None:
    english = " ".join(prose("en"))
    assert cyrillic(english) < 0.02 * len(re.findall(r"[^\W\d_]", english))
    foreign = [line for line in prose("ru") if not cyrillic(line) and len(re.findall("[a-z]{2,}", line, re.I)) > 3]
    assert not foreign
