"""What the README shows, in English and in Russian, is what the program does."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.helpers import ROOT
from tests.helpers.prose import sentences, words_of

READMES = {lang: (ROOT / name).read_text("utf-8") for lang, name in {"en": "README.md", "ru": "README.ru.md"}.items()}
MARKS = ["draw", "tests", "python", "output", "speed", "end"]
LONGEST = 30  # words of a sentence

both = pytest.mark.parametrize("lang", READMES)


def marked(lang: str, mark: str) -> str:
    """The block of code that stands under a mark."""
    found = re.search(rf"<!-- {mark}\b.*? -->\n```\w+\n(.*?)```", READMES[lang], re.S)
    assert found, mark
    return found[1]


def prose(lang: str) -> list[str]:
    """The lines for people: no blocks, no code, no addresses, no names of languages."""
    text = re.sub(r"<!-- .*? -->|```.*?```|`[^`]*`|\]\(.*?\)|\[?(English|Русский)\]?", "", READMES[lang], flags=re.S)
    return [line for line in text.splitlines() if re.search(r"\w", line)]


def cyrillic(text: str) -> int:
    return len(re.findall("[а-яё]", text, re.I))


@both
def test_every_picture_and_page_is_there(lang: str) -> None:
    for address in re.findall(r"\[.*?\]\((.*?)\)", READMES[lang]):
        assert (ROOT / address).exists(), address


@both
def test_the_two_commands_make_their_own_environment(lang: str) -> None:
    for mark in ("draw", "tests"):
        assert "python3 -m venv .venv" in marked(lang, mark)


@both
def test_the_python_of_the_readme_prints_what_stands_there(
    lang: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    exec(marked(lang, "python"), {})
    assert capsys.readouterr().out == marked(lang, "output")
    assert (tmp_path / "slider-crank.pdf").read_bytes().startswith(b"%PDF")


@both
def test_it_is_short_and_leads_to_the_other(lang: str) -> None:
    lines = READMES[lang].splitlines()
    assert len(lines) <= 120
    other = {"en": "(README.ru.md)", "ru": "(README.md)"}[lang]
    assert any(other in line for line in lines[:4])


def test_both_say_the_same() -> None:
    for mark in ("draw", "tests"):
        assert marked("en", mark) == marked("ru", mark)
    for text in READMES.values():
        assert re.findall(r"<!-- (\w+)", text) == MARKS
    tables = [re.sub(r"[^|\n]", "", text) for text in READMES.values()]
    assert re.findall(r"^\|.*", tables[0], re.M) == re.findall(r"^\|.*", tables[1], re.M)
    words = ("velocity diagram", "acceleration", "force polygon", "kinetostatics", "torque", "планы скоростей")
    assert all(word in " ".join(READMES.values()) for word in words)  # what people search for


@both
def test_its_sentences_are_short(lang: str) -> None:
    assert not [s for s in sentences(READMES[lang]) if words_of(s) > LONGEST]


def test_each_is_whole_in_its_own_language() -> None:
    english = " ".join(prose("en"))
    assert cyrillic(english) < 0.02 * len(re.findall(r"[^\W\d_]", english))
    foreign = [line for line in prose("ru") if not cyrillic(line) and len(re.findall("[a-z]{2,}", line, re.I)) > 3]
    assert not foreign
