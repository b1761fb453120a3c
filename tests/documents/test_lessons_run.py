"""A sample of what is counted of every page by hand (``python -m tests.lessons_run``), in both browsers."""

from __future__ import annotations

from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import pytest

from planes.lesson.data import lesson_data
from planes.scene import load
from tests.helpers import ROOT
from tests.helpers.firefox import installed
from tests.helpers.lessons import lesson_written
from tests.lessons_run import COUNTS, count, scenes, window

SIX = ROOT / "samples" / "six-link.yaml"


def counted(browser_name: str, file: Path, folder: Path) -> tuple[int, int, list[str]]:
    """Positions, vectors that reached their place, and what is wrong on the page of a scene."""
    data = lesson_data(load(str(file)))
    with window(browser_name) as one:
        one.goto(lesson_written(folder, file, data=data))
        found = count(one, file, data, 8, 4)
    return found.positions, found.reached, found.wrong


@pytest.mark.slow
@pytest.mark.parametrize("browser_name", ["chromium", "firefox"])
@pytest.mark.parametrize("file", [SIX, ROOT / "samples" / "kind-3-rpr.yaml"], ids=lambda f: f.stem)
def test_a_page_in_two_browsers(browser_name: str, file: Path, tmp_path: Path) -> None:
    if browser_name == "firefox":
        installed()
    with ProcessPoolExecutor(1, get_context("spawn")) as apart:  # other tests hold a browser open in this process
        positions, reached, wrong = apart.submit(counted, browser_name, file, tmp_path).result()
    assert positions == 12 and reached and wrong == []


def dragged(file: Path, folder: Path) -> list[dict[str, object]]:
    """What became of every plan vector of a scene, dragged to some places."""
    with window("chromium") as one:
        one.goto(lesson_written(folder, file))
        one.evaluate(COUNTS)
        return [one.evaluate(f"counts.dragged({seed})") for seed in (1, 77, 1234)]


@pytest.mark.slow
@pytest.mark.parametrize("name", ["lift", "sliding-driver"])
def test_a_plan_vector_whose_drive_ends_says_how_far_it_stays(name: str, tmp_path: Path) -> None:
    """A driver that slides has a last place: what would need it farther is told to be short."""
    with ProcessPoolExecutor(1, get_context("spawn")) as apart:
        found = apart.submit(dragged, ROOT / "samples" / f"{name}.yaml", tmp_path).result()
    assert all(told["silent"] == [] and told["reached"] for told in found)


def test_the_run_takes_all_samples_and_twenty_assignments() -> None:
    assert len([f for f in scenes() if "assignments" in f.parts]) == 20 and SIX in scenes()
