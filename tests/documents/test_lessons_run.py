"""A sample of what is counted of every page by hand (``python -m tests.lessons_run``), in both browsers."""

from __future__ import annotations

from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import pytest

from planes.lesson.data import lesson_data
from planes.scene import load
from render.page.lesson_page import page as written
from tests.helpers import ROOT
from tests.lessons_run import count, scenes, window

SIX = ROOT / "samples" / "six-link.yaml"


def counted(browser_name: str, file: Path, target: Path) -> tuple[int, int, list[str]]:
    """Positions, vectors that reached their place, and what is wrong on the page of a scene."""
    data = lesson_data(load(str(file)))
    target.write_text(written(data, "ru"), encoding="utf-8")
    with window(browser_name) as one:
        one.goto(target.as_uri())
        found = count(one, file, data, 8, 4)
    return found.positions, found.reached, found.wrong


@pytest.mark.slow
@pytest.mark.parametrize("browser_name", ["chromium", "firefox"])
@pytest.mark.parametrize("file", [SIX, ROOT / "samples" / "kind-3-rpr.yaml"], ids=lambda f: f.stem)
def test_a_page_in_two_browsers(browser_name: str, file: Path, tmp_path: Path) -> None:
    with ProcessPoolExecutor(1, get_context("spawn")) as apart:  # other tests hold a browser open in this process
        positions, reached, wrong = apart.submit(counted, browser_name, file, tmp_path / "lesson.html").result()
    assert positions == 12 and reached and wrong == []


def test_the_run_takes_all_samples_and_twenty_assignments() -> None:
    assert len([f for f in scenes() if "assignments" in f.parts]) == 20 and SIX in scenes()
