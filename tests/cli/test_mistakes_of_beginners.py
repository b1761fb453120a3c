"""What beginners write wrong, as a review of the program by a new user found it: nothing is taken in silence, nothing
ends in a traceback, each is answered in one sentence that names the line, wholly in the language asked for."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest
import yaml

from planes.cli import main
from planes.cli.start import TEMPLATE_FOLDER

BASE = (TEMPLATE_FOLDER / "crank-slider.yaml").read_text("utf-8")
TABLE: dict[str, dict[str, dict[str, Any]]] = yaml.safe_load(
    Path(__file__).with_suffix(".yaml").with_stem("mistakes_of_beginners").read_text("utf-8")
)
STATUS = {"refused": (2,), "legitimate": (0,), "doubtful": (0, 2)}
ROWS = [pytest.param(kind, row, id=name) for kind, rows in TABLE.items() for name, row in rows.items()]
ENGLISH = {
    *re.findall(
        "[a-z]+", "the is are not no of for must be there and an or write use here this that it has does cannot"
    )
}


def written(row: dict[str, Any]) -> str:
    """The scene with its mistake."""
    if "whole" in row:
        return str(row["whole"])
    text = BASE
    for old, new in (change for change in ((row.get("for"), row.get("write")), row.get("and")) if change and change[0]):
        assert old in text
        text = text.replace(old, new)
    return text


def answer(row: dict[str, Any], lang: str, capsys: pytest.CaptureFixture[str]) -> tuple[int, str]:
    """How a command ends, and what it says of it."""
    argv = ["s.yaml" if word == "S" else word for word in row.get("command", "solve S").split()]
    try:
        status = main([*argv, "--lang", lang])
    except SystemExit as stop:
        status = int(stop.code or 0)
    return status, capsys.readouterr().err


def test_no_mistake_is_lost() -> None:
    assert sum(map(len, TABLE.values())) >= 160 and len(TABLE["doubtful"]) == 23


@pytest.mark.parametrize(("kind", "row"), ROWS)
def test_a_mistake_is_answered(
    kind: str, row: dict[str, Any], tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    scene, whole = Path("s.yaml"), written(row)
    scene.write_bytes(whole.replace("\n", row.get("newline", "\n")).encode(row.get("encoding", "utf-8")))
    for lang in ("en", "ru"):
        status, said = answer(row, lang, capsys)
        assert status in STATUS[kind], said
        assert row.get(lang, "") in said and bool(said) == (lang in row)
        assert lang == "ru" or said.strip().endswith(row.get("end", "")), said
        assert re.findall(r"s\.yaml:(\d+):", said) == [str(line) for line in row.get("lines", ())]
        assert [p.name for p in tmp_path.iterdir()] == ["s.yaml"]
        told = re.sub(r"[\"'].*?[\"']", "", said)
        typed = r"\{.*?\}|\[.*?\]|--\w+ \S+|\w+ = \S+|точку: \S+|\*0\.001"  # keeps its points
        prose = re.sub(typed, "", told)
        assert not re.search(r"[0-9],[0-9]" if lang == "en" else r"[0-9]\.[0-9]", prose), said
        assert not (set(re.findall("[a-z]+", told)) & ENGLISH if lang == "ru" else re.findall("[а-яё]{2,}", told)), said
