"""Reports of pictures: both plans upon the picture itself, and marks named by hand where none could be read."""

from __future__ import annotations

import random
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import confusion
import pytest
from browser import chromium
from test_9_browser import watched

from planes.cli import main

cv2 = pytest.importorskip("cv2")
import numpy as np  # noqa: E402
import photographs  # noqa: E402
import picture_corpus as corpus  # noqa: E402

SIX = str(confusion.SAMPLES / "six-link.yaml")


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    with chromium(tmp_path_factory.mktemp("profile"), viewport={"width": 1200, "height": 1000}) as context:
        yield context


@pytest.fixture(scope="module")
def scan(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, corpus.Drawn, complex]:
    """A right velocity plan on its blank, scanned."""
    easel = next(e for e in confusion.easels() if (e.sample, e.plan) == ("six-link", "velocity"))
    rng, file = random.Random(1), tmp_path_factory.mktemp("scan") / "scan.jpg"
    drawn = corpus.drawn(easel, None, rng)
    assert drawn is not None
    corpus.picture(drawn, corpus.pole_of(easel), photographs.SCAN, rng, file)
    return file, drawn, corpus.pole_of(easel)


def test_the_png_has_the_picture_with_both_plans_upon_it(
    scan: tuple[Path, corpus.Drawn, complex], tmp_path: Path
) -> None:
    file, drawn, pole = scan
    target = tmp_path / "report.png"
    assert main(["check", SIX, str(file), "--plan", "velocity", "-o", str(target)]) == 0
    whole = cv2.imread(str(target)).astype(int)
    sheet_high = round(whole.shape[1] * 210 / 297)
    below = whole[sheet_high:]
    scale = below.shape[1] / 297
    for z in drawn.marks.values():  # blue where the person's own vectors are
        middle = pole + z / 2
        x, y = round(middle.real * scale), below.shape[0] - round(middle.imag * scale)
        blue, _, red = np.moveaxis(below[y - 9 : y + 10, x - 9 : x + 10], 2, 0)
        assert (blue - red).max() > 25
    far = below[40:60, 500:520]
    assert abs(far[..., 0] - far[..., 2]).max() < 12  # and nowhere else


def test_the_page_lays_the_picture_under_the_marks(
    browser: Any, scan: tuple[Path, corpus.Drawn, complex], tmp_path: Path
) -> None:
    file, drawn, pole = scan
    target = tmp_path / "report.html"
    assert main(["check", SIX, str(file), "--plan", "velocity", "-o", str(target)]) == 0
    page = browser.new_page()
    errors = watched(page)
    page.goto(target.as_uri())
    left, low, right, _ = page.evaluate("data.picture.box")
    assert (left, low) == pytest.approx((-pole.real, -pole.imag)) and right - left == pytest.approx(297, abs=0.2)
    box, image = page.evaluate("[data.picture.box, sheet.px([data.picture.box[0], data.picture.box[3]])]")
    shown = page.locator("image").bounding_box()
    home = page.locator("#sheet").bounding_box()
    assert shown["x"] - home["x"] == pytest.approx(image[0], abs=1) and len(box) == 4
    for name, z in drawn.marks.items():
        x, y = page.evaluate(f"(() => {{ const m = marks.find(m => m.name === {name!r}); return [m.x, m.y]; }})()")
        assert abs(complex(x, y) - z) < 0.5
    page.uncheck('input[data-layer="picture"]')
    assert page.locator("image").count() == 0
    page.close()
    assert errors == []


def test_marks_of_a_picture_nobody_could_read_are_named_by_hand(browser: Any, tmp_path: Path) -> None:
    """An empty blank: every mark waits at the edge; put where a plan is, they are judged."""
    easel = next(e for e in confusion.easels() if (e.sample, e.plan) == ("six-link", "velocity"))
    picture, target = tmp_path / "blank.png", tmp_path / "report.html"
    cv2.imwrite(str(picture), photographs.sheet([], [], corpus.pole_of(easel), photographs.SCAN, random.Random(1)))
    assert main(["check", SIX, str(picture), "--plan", "velocity", "--lang", "en", "-o", str(target)]) == 2
    page = browser.new_page()
    errors = watched(page)
    page.goto(target.as_uri())
    assert page.locator(".handle.unread").count() == 5 and page.get_attribute("body", "class") == "unreadable"
    right = corpus.drawn(easel, None, random.Random(1))
    assert right is not None
    for name, z in right.marks.items():
        page.evaluate(f"move({name!r}, {z.real}, {z.imag})")
    assert page.inner_text("#sentence").startswith("The drawing is right")
    page.evaluate("move('c', -20, 40)")
    assert page.get_attribute("body", "class") == "wrong"
    saved = tmp_path / "marks.csv"
    saved.write_text(page.evaluate("csv()"), encoding="utf-8")
    assert main(["check", SIX, str(saved), "--plan", "velocity"]) == 1
    page.close()
    assert errors == []
