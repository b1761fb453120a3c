"""Reports of pictures: both plans upon the picture itself, and marks named by hand where none could be read."""

from __future__ import annotations

import random
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from planes.cli import main
from tests import confusion
from tests.helpers.browser import watched

cv2 = pytest.importorskip("cv2")
import numpy as np  # noqa: E402

from planes.check.fiducials import SHEET_MM  # noqa: E402
from planes.documents.check import _overlay_sheet_contents  # noqa: E402
from render.files import pdf  # noqa: E402
from render.paper.marks import Arrow, Text  # noqa: E402
from render.paper.photo import Photo  # noqa: E402
from render.sheet.check_sheet import compose_check_sheet  # noqa: E402
from tests import picture_corpus as corpus  # noqa: E402
from tests.helpers import photographs  # noqa: E402
from tests.helpers.conflicts import conflicts  # noqa: E402

SIX = str(confusion.SAMPLES / "six-link.yaml")


def corpus_easel(plan: str) -> confusion.Easel:
    return confusion.easel("six-link", plan)


@pytest.fixture(scope="module")
def scan(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, corpus.Drawn, complex]:
    """A right velocity plan on its blank, scanned."""
    easel = confusion.easel("six-link", "velocity")
    rng, file = random.Random(1), tmp_path_factory.mktemp("scan") / "scan.jpg"
    drawn = corpus.drawn(easel, None, rng)
    assert drawn is not None
    corpus.picture(drawn, corpus.pole_of(easel), photographs.SCAN, rng, file)
    return file, drawn, corpus.pole_of(easel)


def darkest(photo: Photo, at: complex, across: complex) -> float:
    """How far off a place the darkest pixel of a picture is, across a line, mm."""
    grey = cv2.imdecode(np.frombuffer(photo.data, np.uint8), cv2.IMREAD_GRAYSCALE)
    x0, y0, x1, y1 = photo.box
    steps = np.arange(-1.5, 1.55, 0.05)
    places = at + steps * across
    x = (places.real - x0) / (x1 - x0) * grey.shape[1] - 0.5
    y = (y1 - places.imag) / (y1 - y0) * grey.shape[0] - 0.5
    seen = cv2.remap(grey, x.astype(np.float32), y.astype(np.float32), cv2.INTER_LINEAR).ravel().astype(float)
    dark = np.maximum(seen.max() - 40 - seen, 0)
    assert dark.sum() > 0, "there is no line here"
    return float((dark * steps).sum() / dark.sum())


@pytest.mark.slow
@pytest.mark.parametrize("plan", ["velocity", "force:2-3"])
def test_the_picture_lies_beneath_the_person_s_own_plan(plan: str, tmp_path: Path) -> None:
    """Each line of the person's own plan is drawn on the pencil's, in whatever order the forces are."""
    one, rng, file = corpus_easel(plan), random.Random(3), tmp_path / "p.jpg"
    drawn = corpus.drawn(one, None, rng)
    assert drawn is not None
    corpus.picture(drawn, corpus.pole_of(one), replace(photographs.PHONE, grid="square"), rng, file)
    marks, photo = compose_check_sheet(SHEET_MM, _overlay_sheet_contents(corpus.looked_at(one, file)[0], "ru"))
    assert photo is not None
    own = [m for m in marks if isinstance(m, Arrow) and m.style == "own" and abs(m.end - m.start) > 12]
    assert len(own) >= 4
    for m in own:
        assert abs(darkest(photo, (m.start + m.end) / 2, 1j * (m.end - m.start) / abs(m.end - m.start))) < 0.4
    grey = cv2.imdecode(np.frombuffer(photo.data, np.uint8), cv2.IMREAD_GRAYSCALE)
    assert np.median(grey) > 245 and 95 < grey.min() < 190  # white paper under any lamp, pale ink
    names = [m for m in marks if isinstance(m, Text) and m.height == 3.5]
    assert conflicts(names, [m for m in marks if not isinstance(m, Text)]) == ()


@pytest.mark.slow
@pytest.mark.parametrize("suffix", [".pdf", ".svg", ".png"])
def test_printed_reports_carry_the_picture(
    suffix: str, scan: tuple[Path, corpus.Drawn, complex], tmp_path: Path
) -> None:
    file, _, _ = scan
    target = tmp_path / f"report{suffix}"
    assert main(["check", SIX, str(file), "--plan", "velocity", "-o", str(target)]) == 0
    data = target.read_bytes()
    assert len(data) < 1_500_000
    if suffix == ".svg":
        assert data.count(b"data:image/jpeg;base64,") == 1
        return
    if suffix == ".pdf":
        assert data.count(b"/DCTDecode") == 1
        data = pdf.png_of_pdf(data, 200)
    seen = cv2.imdecode(np.frombuffer(data, np.uint8), cv2.IMREAD_COLOR).astype(int)
    blue, green, red = np.moveaxis(seen, 2, 0)
    assert ((blue - red) > 60).sum() > 500 and ((green - red) > 60).sum() > 500
    grey = (abs(blue - red) < 6) & (blue > 100) & (blue < 200)
    assert grey[300:1500, 200:1600].sum() > 3000  # the pencil


@pytest.mark.slow
def test_what_nobody_could_read_is_printed_whole(tmp_path: Path) -> None:
    """Another plan on the blank: the whole picture, and the right plan from the printed pole."""
    one, other, rng, file = corpus_easel("velocity"), corpus_easel("force:2-3"), random.Random(3), tmp_path / "p.jpg"
    drawn = corpus.drawn(other, None, rng)
    assert drawn is not None
    corpus.picture(drawn, corpus.pole_of(one), photographs.SCAN, rng, file)
    found = corpus.looked_at(one, file)[0]
    assert found.verdict == "unreadable"
    marks, photo = compose_check_sheet(SHEET_MM, _overlay_sheet_contents(found, "ru"))
    assert photo is not None and photo.box[2] - photo.box[0] > 180
    assert not any(isinstance(m, Arrow) and m.style == "own" for m in marks)
    assert any(isinstance(m, Arrow) and m.style == "truth" for m in marks)


@pytest.mark.slow
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


@pytest.mark.slow
def test_marks_of_a_picture_nobody_could_read_are_named_by_hand(browser: Any, tmp_path: Path) -> None:
    """An empty blank: every mark waits at the edge; put where a plan is, they are judged."""
    easel = confusion.easel("six-link", "velocity")
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


@pytest.mark.slow
def test_the_pole_of_a_picture_is_put_where_it_is(browser: Any, tmp_path: Path) -> None:
    """Another plan on a sheet without corner marks: nobody knows the pole, it waits at the corner and is moved."""
    one, picture, target = corpus_easel("acceleration"), tmp_path / "p.png", tmp_path / "report.html"
    rng, camera, pole = random.Random(2), replace(photographs.SCAN, corners=False), 140 + 110j
    drawn = next(d for d in (corpus.drawn(one, None, rng) for _ in range(20)) if d)
    page_of = photographs.Page(camera.dpi)
    page_of.print_blank(None, False)
    for a, b in drawn.strokes:
        page_of.stroke(a * 0.6 + pole, b * 0.6 + pole, 0.1, rng)
    cv2.imwrite(str(picture), photographs.shot(page_of.grey, camera, rng))
    asked = ["check", SIX, str(picture), "--plan", "velocity", "--lang", "en", "--format", "A4"]
    assert main([*asked, "-o", str(target)]) == 2
    page = browser.new_page()
    errors = watched(page)
    page.goto(target.as_uri())
    assert page.evaluate("data.picture.box.slice(0, 2)") == pytest.approx([0, 0])
    page.evaluate("drag('b', 160, 130)")
    before = page.evaluate("[marks[0].x - data.picture.box[0], marks[0].y - data.picture.box[1]]")
    page.evaluate(f"drag('p', {pole.real}, {pole.imag})")
    page.focus('[data-mark="p"]')
    page.keyboard.press("ArrowRight")
    assert page.evaluate("data.picture.box.slice(0, 2)") == pytest.approx([-pole.real - 0.5, -pole.imag])
    assert page.evaluate("[marks[0].x, marks[0].y]") == pytest.approx([19.5, 20])
    after = page.evaluate("[marks[0].x - data.picture.box[0], marks[0].y - data.picture.box[1]]")
    assert after == pytest.approx(before)
    page.click("#reset")
    assert page.evaluate("data.picture.box.slice(0, 2)") == pytest.approx([0, 0], abs=1e-9)
    page.close()
    assert errors == []
