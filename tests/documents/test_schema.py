"""The JSON Schemas: made of the readers' own keys, they take whatever the readers take and refuse misspelt keys."""

from __future__ import annotations

import csv
import json
import re
from pathlib import Path
from typing import Any

import pytest
import yaml
from jsonschema import Draft202012Validator

from planes.course.reading import COURSE_KEYS
from planes.documents.schema import SCHEMA_KINDS, json_schema
from planes.scene import loads
from planes.scene.settings import SHEET_KEYS
from planes.words import sentence_table
from planes.words.errors import PlanesError
from tests.helpers import ROOT
from tests.helpers.scene_texts import SIX_LINK, changed
from tests.scene.test_scene_refusals import BAD

SAMPLES = sorted(f for f in (ROOT / "samples").rglob("*.yaml") if f.name != "course.yaml")
TEMPLATES = sorted(f for f in (ROOT / "planes" / "templates").glob("*.yaml") if f.name != "course.yaml")
UNKNOWN = "no_key"  # the refusal of a key that is none


BOOL = "tag:yaml.org,2002:bool"


class EditorLoader(yaml.SafeLoader):
    """YAML 1.2, as editors read it: ``on`` is a word."""


EditorLoader.yaml_implicit_resolvers = {
    first: [one for one in some if one[0] != BOOL] for first, some in yaml.SafeLoader.yaml_implicit_resolvers.items()
}
EditorLoader.add_implicit_resolver(BOOL, re.compile("true|false"), list("tf"))


def plain(thing: Any) -> Any:
    """What YAML reads, all keys texts, as an editor sees it."""
    if isinstance(thing, dict):
        return {str(key): plain(value) for key, value in thing.items()}
    return [plain(one) for one in thing] if isinstance(thing, list) else thing


def faults(kind: str, text: str) -> list[str]:
    found = Draft202012Validator(json_schema(kind, "en")).iter_errors(plain(yaml.load(text, EditorLoader)))
    return [error.message for error in found]


@pytest.mark.parametrize("kind", SCHEMA_KINDS)
@pytest.mark.parametrize("lang", ["ru", "en"])
def test_each_is_a_schema_whose_every_key_is_described(kind: str, lang: str) -> None:
    made = json_schema(kind, lang)
    Draft202012Validator.check_schema(made)

    def described(part: Any) -> None:
        if isinstance(part, dict):
            for own in part.get("properties", {}).values():
                assert own == {"type": "string"} or own["description"]
            for inner in part.values():
                described(inner)
        elif isinstance(part, list):
            for inner in part:
                described(inner)

    described(made)


@pytest.mark.parametrize("kind", SCHEMA_KINDS)
def test_the_files_of_the_repository_are_what_is_made(kind: str) -> None:
    written = json.loads((ROOT / "docs" / "schema" / f"{kind}.json").read_text("utf-8"))
    assert written == json_schema(kind, "en"), f"planes schema {kind} --lang en -o docs/schema/{kind}.json"


def test_every_sample_and_template_fits() -> None:
    assert len(SAMPLES) > 80 and len(TEMPLATES) > 8
    assert not {f.name: found for f in (*SAMPLES, *TEMPLATES) if (found := faults("scene", f.read_text("utf-8")))}
    for file in (ROOT / "samples" / "course" / "course.yaml", ROOT / "planes" / "templates" / "course.yaml"):
        assert not faults("course", file.read_text("utf-8"))


def test_every_sample_names_its_schema() -> None:
    for file in (*SAMPLES, ROOT / "samples" / "course" / "course.yaml"):
        address = file.read_text("utf-8").splitlines()[0].removeprefix("# yaml-language-server: $schema=")
        assert (file.parent / address).resolve().parent == ROOT / "docs" / "schema", file


def test_a_scene_written_by_the_program_fits() -> None:
    for name in ("six-link", "shaper", "crank-slider"):
        scene = loads((ROOT / "samples" / f"{name}.yaml").read_text("utf-8"))
        assert not faults("scene", scene.to_yaml())


def test_what_the_reader_refuses_as_a_key_the_schema_refuses_too() -> None:
    seen = 0
    for old, new, *_ in BAD:
        text = changed(old, new, SIX_LINK)
        try:
            loads(text)
        except PlanesError as error:
            if getattr(error.phrase, "key", "") == UNKNOWN and not text.startswith("planes: 2"):
                seen += 1
                assert faults("scene", text), (old, new)
    assert seen >= 3


def test_no_description_is_left_over() -> None:
    told = {f"schema_{kind}" for kind in SCHEMA_KINDS}

    def keys(part: Any) -> None:
        if isinstance(part, dict):
            told.update(own["description"] for own in part.get("properties", {}).values() if "description" in own)
            for inner in part.values():
                keys(inner)
        elif isinstance(part, list):
            for inner in part:
                keys(inner)

    for kind in SCHEMA_KINDS:
        keys(json_schema(kind, "en"))
    words = sentence_table("en", "schema")
    assert not {k for k, text in words.items() if k not in told and text not in told}
    assert {f"schema_sheet_{k}" for k in SHEET_KEYS} | {f"schema_course_{k}" for k in COURSE_KEYS} <= words.keys()


def test_tables_fit(tmp_path: Path) -> None:
    for rows in ("mark,x_mm,y_mm\np,0,0\nb,60,-3.5\n", "segment,mm\npb,60\n", "result,value,unit\nomega_2,8.1,rad/s\n"):
        text = json.dumps([{k: _number(v) for k, v in row.items()} for row in csv.DictReader(rows.splitlines())])
        assert not faults("table", text)
    assert faults("table", '[{"mark": "b"}]') and faults("table", '[{"marks": "b", "x_mm": 1, "y_mm": 2}]')


def _number(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text
