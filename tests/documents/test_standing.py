"""A point that stands still is said to, in a lesson and a note, where the crank has it and nowhere else."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest

from planes.lesson.formulas import LESSON_LANGS
from planes.lesson.standing import point_at_rest_sentence
from planes.lesson.told import SceneLesson
from planes.scene import load
from planes.solving import plans_and_requested_results, solve_position
from tests.helpers import ROOT
from tests.helpers.lessons import lesson_opened, lesson_written

STEPHENSON, SLIDER = ROOT / "samples/class-three/stephenson.yaml", ROOT / "samples/kind-2-rrp.yaml"
AT = "go(data.frames.findIndex(f => f.makes[0] === {mark!r}));"


def test_a_point_stands_still_in_its_dead_points_alone(browser: Any, tmp_path: Path) -> None:
    scene = load(str(SLIDER))
    plans, wanted = plans_and_requested_results(scene, shown=True)
    with lesson_opened(browser, lesson_written(tmp_path, SLIDER, "en")) as page:
        page.evaluate(AT.format(mark="velocity:c"))
        told, outer = {}, 60 - math.degrees(math.asin(0.015 / 0.26))  # crank and rod in one line
        for angle in (outer, outer + 0.001, 90, inner := 240 - math.degrees(math.asin(0.015 / 0.14)), 359.9):
            page.evaluate(f"turn({angle}); draw()")
            told[angle] = "C is at rest in this position: c lies at the pole" in page.inner_text("#sentence")
            speed = abs(solve_position(scene, plans, wanted, angle, None, "en").v["C"])
            assert told[angle] == (speed < 1e-9), angle
        assert told[outer] and told[inner]


@pytest.mark.slow
def test_the_special_point_is_the_instantaneous_centre_of_its_link(browser: Any, tmp_path: Path) -> None:
    told = SceneLesson.of(load(str(STEPHENSON)))
    frame = next(f for f in told.frames if f.makes == ("velocity:s",))
    said = {lang: point_at_rest_sentence(frame, told.drawing, lang) for lang in LESSON_LANGS}
    assert all("⟨S⟩" in text and "⟨s⟩" in text and " 3 " in text for text in said.values())
    assert len(set(said.values())) == len(LESSON_LANGS) == 4
    assert not point_at_rest_sentence(next(f for f in told.frames if f.makes == ("velocity:c",)), told.drawing, "en")
    with lesson_opened(browser, lesson_written(tmp_path, STEPHENSON, "ru")) as page:
        page.evaluate(AT.format(mark="velocity:s"))
        assert "Особая точка S неподвижна: s лежит в полюсе" in page.inner_text("#sentence")
