"""The samples of statics against their expected numbers, of an independent solver; their sheets and lessons."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
import yaml

from planes.documents.sheets import sheet_of
from planes.lesson.told import SceneLesson
from planes.scene import load, loads
from planes.solving import solve
from tests.helpers import ROOT
from tests.helpers.equilibrium import expected

SAMPLES = sorted((ROOT / "samples" / "statics").glob("*.yaml"))
DIGITS = 1e-11  # of the largest number: those that are printed


def test_there_are_samples_of_many_kinds() -> None:
    assert len(SAMPLES) >= 25


@pytest.mark.parametrize("sample", SAMPLES, ids=lambda f: f.stem)
def test_a_sample_has_its_expected_numbers(sample: object) -> None:
    path = ROOT / "samples" / "expected" / "statics" / f"{sample.stem}.json"  # type: ignore[attr-defined]
    told = json.loads(path.read_text("utf-8"))
    (position,) = solve(load(sample)).positions  # type: ignore[arg-type]
    again = expected(sample.read_text("utf-8"))  # type: ignore[attr-defined]
    most = max(abs(x) for xy in told["vectors"].values() for x in xy)
    for name, xy in told["vectors"].items():
        assert abs(position.of("vectors")[name].vector - complex(*xy)) <= DIGITS * most, name
        assert complex(*again["vectors"][name]) == pytest.approx(complex(*xy), abs=DIGITS * most)
    for name, value in told["values"].items():
        assert abs(position.of("values")[name].number - value) <= DIGITS * max(most, abs(value)), name


@pytest.mark.parametrize("sample", SAMPLES, ids=lambda f: f.stem)
def test_a_sample_moved_far_aside_has_the_same_vectors(sample: Path) -> None:
    scene = yaml.safe_load(sample.read_text("utf-8"))
    scene["points"] = {n: [f"({x}) + 40", f"({y}) - 25"] for n, (x, y) in scene["points"].items()}
    here, there = (solve(one).positions[0].of("vectors") for one in (load(sample), loads(yaml.safe_dump(scene))))
    most = max(abs(one.vector) for one in here.values())
    assert {n: there[n].vector for n in here} == pytest.approx({n: v.vector for n, v in here.items()}, abs=1e-12 * most)


@pytest.mark.parametrize("sample", SAMPLES, ids=lambda f: f.stem)
def test_strings_and_rays_run_between_marks_that_are_drawn(sample: Path) -> None:
    (position,) = solve(load(sample)).positions
    figure = position.plans.figure
    assert figure and {z for line in figure.strokes for z in (line.start, line.end)} <= {*position.drawing.things}
    assert {*figure.poles, *figure.said} <= {*position.drawing.things}


@pytest.mark.slow
@pytest.mark.parametrize("sample", SAMPLES, ids=lambda f: f.stem)
def test_a_sample_has_a_sheet_and_a_lesson(sample: object) -> None:
    """Both are made whole in both languages, and every label of the sheet finds a place."""
    scene = load(sample)  # type: ignore[arg-type]
    for lang in ("ru", "en"):
        sheet = sheet_of(scene, None, lang)  # type: ignore[arg-type]
        assert not sheet.warnings, sheet.warnings
    frames = SceneLesson.of(scene).frames
    assert len(frames) > 4 and all(f.marked["ru"] and f.why["ru"] for f in frames)


def test_a_scene_of_statics_is_refused_what_only_mechanisms_have(capsys: pytest.CaptureFixture[str]) -> None:
    from planes.cli import main

    assert load(SAMPLES[0]).to_yaml() == SAMPLES[0].read_text("utf-8")
    assert main(["structure", str(ROOT / "samples" / "statics" / "truss-fink.yaml"), "--lang", "en"]) == 0
    assert capsys.readouterr().out == "2j = m + r: 2·15 = 27 + 3\n"
    assert main(["cycle", str(SAMPLES[0]), "--phi", "0:360:30", "-o", "x.csv"]) == 2


@pytest.mark.parametrize("name", ["beam", "truss-king-post", "resultant"])
def test_the_task_of_a_structure_shows_nothing_that_is_found(name: str) -> None:
    from planes.documents.sheets import DrawnPosition
    from render.paper.marks import Text
    from render.sheet.composer import Composer
    from render.sheet.sizes import Sizes

    scene = load(ROOT / "samples" / "statics" / f"{name}.yaml")
    drawn = DrawnPosition(scene, None, "en").position_at_sizes(Sizes())
    composer = Composer(scene, "en", drawn.plans)
    shown, whole = (composer.space_diagram_view(drawn, asked) for asked in (True, False))
    assert shown and whole
    texts, every = ({m.text for m in v.marks if isinstance(m, Text)} for v in (shown, whole))
    assert texts < every and any(t.startswith("P_") for t in texts)
    assert not any(t.startswith(("R", "S_", "z")) or t.isdigit() for t in texts)
