"""The pages of docs/ say what the program does: their scenes solve, their names are those of the tables."""

from __future__ import annotations

import json
import re

import pytest

import planes
from planes.scene.outline import ALL_SCENE_KEYS
from planes.words import sentence_table
from tests.helpers import ROOT
from tests.helpers.prose import sentences, words_of

SCENE, JSON, CHECKING = ((ROOT / "docs" / f"{name}.md").read_text("utf-8") for name in ("scene", "json", "checking"))
SCENES = re.findall(r"```yaml\n(.*?)```", SCENE, re.S)


@pytest.mark.parametrize("text", SCENES, ids=["mechanism", "vectors", "statics"])
def test_the_scenes_of_the_format_are_read(text: str) -> None:
    scene = planes.loads(text)
    if scene.mechanism:
        assert planes.solve(scene).omega["2"] == pytest.approx(8.12247, abs=1e-5)
    elif scene.statement and scene.statement.subject:
        assert planes.solve(scene).value("R_B") == pytest.approx(2750j)
    else:
        assert planes.solve(scene).value("omega_2") == pytest.approx(-4.6572, abs=1e-4)


def test_every_part_of_a_scene_is_described() -> None:
    known = {*ALL_SCENE_KEYS} - {"note", "text", "missing", "sheet", "crank_slider"}
    assert not {key for key in known if not re.search(rf"\b{key}\b", SCENE)}


def test_the_object_has_the_keys_that_are_printed() -> None:
    told = json.loads(re.search(r"```json\n(.*?)```", JSON, re.S)[1])  # type: ignore[index]
    solved = planes.solve(planes.load(ROOT / "samples" / "six-link.yaml"), [150.0]).json()
    assert set(told) == set(solved)
    assert set(told["positions"][0]) == set(solved["positions"][0])
    assert set(told["positions"][0]["plans"]["velocity"]) == set(solved["positions"][0]["plans"]["velocity"])


def test_the_map_for_newcomers_names_what_is_there() -> None:
    text = (ROOT / "CONTRIBUTING.md").read_text("utf-8")
    places = re.findall(r"`((?:planes|render|tests|docs|samples|\.ci)/[\w./*-]*)`", text)
    assert len(places) > 25 and not [place for place in places if not list(ROOT.glob(place))]
    modules = re.findall(r"python -m (tests\.\w+)", text)
    files = [ROOT / module.replace(".", "/") for module in modules]
    assert files and all(f.with_suffix(".py").is_file() or (f / "__main__.py").is_file() for f in files)
    for name, place in re.findall(r"`(\w+)`\)? (?:in|\()\s?`?(planes/[\w/]+\.py)", text):
        assert name in (ROOT / place).read_text("utf-8"), name
    for file, name in re.findall(r"`(planes/[\w/]+\.py)` \(`(\w+)`\)", text):
        assert name in (ROOT / file).read_text("utf-8"), name


def test_every_mistake_has_its_name() -> None:
    listed = CHECKING[CHECKING.index("- position:") : CHECKING.index("**Names of marks")]
    told = set(re.findall(r"`([a-z0-9]+(?:_[a-z0-9]+)+)`", listed))
    assert told == {
        key.removeprefix("mistake_") for key in sentence_table("en", "mistakes") if key.startswith("mistake_")
    }


def test_the_newest_version_is_told_alike() -> None:
    newest = re.search(r"^## (\d+\.\d+\.\d+) — (\d{4}-\d\d-\d\d)$", (ROOT / "CHANGELOG.md").read_text("utf-8"), re.M)
    cited = (ROOT / "CITATION.cff").read_text("utf-8")
    assert newest and newest[1] == planes.__version__
    assert f"version: {newest[1]}\n" in cited and f"date-released: {newest[2]}\n" in cited


LONGEST = 40  # words of a sentence


def test_no_sentence_of_the_site_is_too_long() -> None:
    said = [(p.name, s) for p in (ROOT / "docs").rglob("*.md") for s in sentences(p.read_text("utf-8"))]
    assert not [(name, s) for name, s in said if words_of(s) > LONGEST]
