"""A language is a folder of words: Ukrainian and Belarusian need no code; what one has not is told in Russian."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from planes import words
from planes.cli import main
from planes.scene import loads
from planes.words import available_languages, fallback_languages, home_lang, say, sentence_table
from tests.helpers import ROOT
from tests.words.test_words import places

FOLDER = Path(words.__file__).parent
THIRD = [lang for lang in available_languages() if len(fallback_languages(lang)) > 1]
FOREIGN = {"uk": "[ыэъё]", "be": "[ищъ]"}
"""Letters its alphabet has not."""
Captured = pytest.CaptureFixture[str]
SIX = str(ROOT / "samples" / "six-link.yaml")
FOUR_BAR = str(ROOT / "samples" / "kind-1-rrr.yaml")


def test_there_are_two_of_them_and_they_are_told_last() -> None:
    assert available_languages()[:2] == ("ru", "en") and THIRD == ["be", "uk"]
    assert all(fallback_languages(lang) == (lang, "ru") for lang in THIRD)


@pytest.mark.parametrize("lang", THIRD)
def test_its_words_are_those_of_the_language_it_leans_on(lang: str) -> None:
    """The same keys, names and numbers, as many forms."""
    own, other = sentence_table(lang), sentence_table(fallback_languages(lang)[1])
    assert own.keys() == other.keys()
    for key, text in own.items():
        assert text.count("|") == other[key].count("|"), key
        assert set(places(text)) == set(places(other[key])), key
        assert text.count("%") == other[key].count("%"), key
        assert not re.search(FOREIGN[lang], text, re.I) or key.startswith(("language_", "detail_")), key


@pytest.mark.few(1)
@pytest.mark.parametrize(
    ("lang", "plan", "segment"), [("uk", "План швидкостей", "відрізок"), ("be", "План хуткасцей", "адрэзак")]
)
def test_commands_speak_it_and_say_what_they_borrow(
    lang: str, plan: str, segment: str, tmp_path: Path, capsys: Captured, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert main(["sheet", SIX, "--view", "velocity-plan", "--lang", lang, "-o", str(tmp_path / "v.svg")]) == 0
    assert plan in (tmp_path / "v.svg").read_text("utf-8")
    assert main(["solve", SIX, "--lang", lang]) == 0
    assert segment in capsys.readouterr().out
    assert main(["check", str(tmp_path / "no.csv"), "--plan", "velocity", "--lang", lang, "x"]) == 2
    capsys.readouterr()
    assert main(["cycle", FOUR_BAR, "--lang", lang]) == 0
    assert not capsys.readouterr().err
    monkeypatch.setattr(sentence_table(lang), "borrowed", {"help_cycle"})
    assert main(["cycle", FOUR_BAR, "--lang", lang]) == 0
    assert capsys.readouterr().err.startswith(f"{lang}: ")


def test_nothing_is_borrowed_in_silence_or_without_need(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sentence_table("uk"), "borrowed", set())
    monkeypatch.delitem(sentence_table("uk"), "help_cycle")
    assert say("plan_velocity", "uk") == "план швидкостей" and not sentence_table("uk").borrowed
    assert say("help_cycle", "uk") == say("help_cycle", "ru") and sentence_table("uk").borrowed == {"help_cycle"}
    with pytest.raises(KeyError):
        say("no such key", "uk")


@pytest.mark.parametrize(
    ("home", "lang"),
    [("uk_UA.UTF-8", "uk"), ("be_BY", "be"), ("kk_KZ", "ru"), ("ru_RU", "ru"), ("de_DE", "en"), ("C", "en")],
)
def test_the_language_of_the_system(home: str, lang: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("LC_ALL", home)
    assert home_lang() == lang


def test_a_title_in_a_third_language_is_read_and_written_back() -> None:
    text = "planes: 1\ntitle: {ru: План, uk: План швидкостей}\nvectors: {a: {value: 1, direction: 0}, b: }\n"
    title = loads(text + "equations: [a = b]\n").title
    assert (title["uk"], title["be"], title["en"]) == ("План швидкостей", "План", "План")
