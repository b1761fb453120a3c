"""Modules of the pages read by node, one at a time: their numbers are Python's, by changed givens and in sentences."""

from __future__ import annotations

import json
import os
import random
import shutil
import subprocess
from functools import partial
from pathlib import Path

import pytest

from planes.drafting.drawing import draw_program
from planes.lesson import slot_value
from planes.lesson.data import lesson_data
from planes.lesson.formulas import LESSON_LANGS, fill_slots
from planes.lesson.told import SceneLesson
from planes.plans import plans_of
from planes.plans.scales import plan_scales, plan_sizes_on_format
from planes.scene import load
from planes.words.records import Json
from planes.words.units import number_text
from render.page import packer
from render.page.lesson_page import whole_lesson_page
from tests.helpers import ROOT
from tests.helpers.lessons import brought
from tests.tapes_run import by_engine

SCENE = ROOT / "samples" / "six-link.yaml"
TESTS = Path(__file__).with_name("page_modules.test.mjs")
NUMBERS = [0.0, -0.0, 1.0, 0.125, -12.345, 99999.5, 1234567.0, 12345678.9, 1e-5, 0.00012345, 2.5e-7, -3.14159, 2.00005]


def said(data: Json) -> list[Json]:
    """What every frame says at other places of the drive."""
    scene, found = load(str(SCENE)), []
    plans, drive = plans_of(scene.mechanism), data["drive"]["given"]
    mus = plan_scales(plans, scene.mu, fit_mm=plan_sizes_on_format(scene.sheet))
    told = SceneLesson.of(scene)
    for value in (150.0, 165.5, 201.7):
        there = draw_program(plans.program, {**plans.given, **mus, drive: value})
        read = partial(slot_value, teller=told.teller, drawing=there)
        for lang in LESSON_LANGS:
            words = [fill_slots(f.words_with_rows[lang], read, lang) for f in told.frames]
            found.append({"given": {drive: value}, "lang": lang, "said": words})
    assert len(told.frames) == len(data["frames"])
    return found


def test_modules_of_the_pages_reckon_as_python_does(tmp_path: Path) -> None:
    node = shutil.which("node")
    if not node:
        pytest.skip("no node here: apt-get install nodejs")
    data = lesson_data(load(str(SCENE)))
    told = {
        "held": brought(whole_lesson_page(data, "en")),
        "drawn": [*by_engine(SCENE, data, 24, random.Random(5))],
        "said": said(data),
        "numbers": NUMBERS,
        "written": {lang: [number_text(v, lang) for v in NUMBERS] for lang in ("ru", "en")},
    }
    for file in Path(packer.__file__).parent.glob("*.js"):
        shutil.copy(file, tmp_path)
    (tmp_path / "package.json").write_text('{"type": "module"}', encoding="utf-8")
    (tmp_path / "told.json").write_text(json.dumps(told), encoding="utf-8")
    how = {**os.environ, "PAGE_MODULES": str(tmp_path)}
    ran = subprocess.run([node, "--test", TESTS], capture_output=True, text=True, encoding="utf-8", env=how)
    assert ran.returncode == 0, ran.stdout + ran.stderr
