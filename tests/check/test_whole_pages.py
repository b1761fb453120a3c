"""What else stands on a page, a blank printed at another size, files of several pages: only the plan is judged."""

from __future__ import annotations

import json
import random
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

cv2 = pytest.importorskip("cv2")
from PIL import Image  # noqa: E402

from planes.check.grading.paper import Known  # noqa: E402
from planes.check.handed_in import read_paper, sheets_of  # noqa: E402
from planes.check.outcome import check  # noqa: E402
from planes.check.vision.image.decoding import load  # noqa: E402
from planes.check.vision.image.picture import flatten  # noqa: E402
from planes.check.vision.print_scale import print_scale_of_scan  # noqa: E402
from planes.cli import main  # noqa: E402
from planes.words.errors import PlanesError  # noqa: E402
from tests import confusion  # noqa: E402
from tests.helpers.drawings import Mistake  # noqa: E402
from tests.physical import corpus  # noqa: E402
from tests.physical.counting import Tally  # noqa: E402
from tests.physical.factors import FACTORS  # noqa: E402
from tests.physical.setting import Setting, varied  # noqa: E402
from tests.picture_corpus import drawn, mark_errors  # noqa: E402

SIX, PLAN = confusion.easel("six-link", "velocity"), confusion.bench("six-link", "velocity")
WRONG = Mistake("omega1_reversed", "b")


def work(mistake: Mistake | None, seed: int, scale: float = 1.0) -> corpus.Work:
    """A drawing of the six-link mechanism's velocities, perhaps to a wrong scale."""
    one = drawn(SIX, mistake, random.Random(seed))
    assert one is not None
    one = replace(
        one,
        strokes=[(a * scale, b * scale) for a, b in one.strokes],
        words=[(text, z * scale) for text, z in one.words],
        marks={n: z * scale for n, z in one.marks.items()},
    )
    return corpus.Work(SIX, mistake, one)


def shot(of: corpus.Work, factor: str, file: Path, **more: Any) -> corpus.Picture:
    """A picture of one factor."""
    setting = replace(varied(Setting(), FACTORS[factor], random.Random(factor)), **more)
    found = corpus.picture(of, setting, factor, file)
    assert found is not None
    return found


@pytest.mark.slow
@pytest.mark.parametrize("factor", ["second plan", "table, names"])
def test_only_the_plan_is_priced(factor: str, tmp_path: Path) -> None:
    """A title block, another plan, a table and names beside the drawing change neither verdict."""
    whole = Tally()
    whole.add(corpus.counted(shot(work(None, 1), factor, tmp_path / "right.jpg")))
    whole.add(corpus.counted(shot(work(WRONG, 2), factor, tmp_path / "wrong.jpg")))
    assert (whole.accepted, whole.found, whole.named, whole.unread) == (1, 1, 1, 0)


@pytest.mark.slow
@pytest.mark.parametrize("share", [0.985, 0.97, 0.94])
def test_a_blank_printed_to_fit_is_no_mistake(share: float, tmp_path: Path) -> None:
    """The share is never blamed, and told by the scan's resolution. What is drawn wrongly is still found."""
    taken = shot(work(None, 1), "base", tmp_path / "right.jpg", print_scale=share)
    found = check(PLAN.asked, read_paper(str(taken.file), PLAN.asked, Known()))
    told = [float(str(n.parts["share"])) / 100 for n in found.notes if n.key == "check_printed_at"]
    assert found.verdict == "right" and told == [pytest.approx(share, abs=0.004)]
    assert corpus.counted(shot(work(WRONG, 2), "base", tmp_path / "wrong.jpg", print_scale=share)).named == 1


@pytest.mark.slow
@pytest.mark.parametrize("share", [0.985, 0.97])
def test_a_scan_tells_the_share_its_blank_was_printed_at(share: float, tmp_path: Path) -> None:
    """By its resolution, to a scanner's own error: marks are then read to a third of a millimetre."""
    taken = shot(work(None, 1), "base", tmp_path / "right.jpg", print_scale=share)
    picture = load(taken.file)
    flat = flatten(picture.grey)
    assert flat is not None and abs(print_scale_of_scan(flat, picture.grey, picture.scale) - share) < 0.002
    assert (
        print_scale_of_scan(flat, picture.grey, None)
        == print_scale_of_scan(flat, picture.grey, 2 * (picture.scale or 0))
        == 1
    )
    found = check(PLAN.asked, read_paper(str(taken.file), PLAN.asked, Known()))
    assert found.verdict == "right" and sum(n.key == "check_printed_at" for n in found.notes) == 1
    assert max(mark_errors(SIX, taken.work.one, found)) < 0.35


@pytest.mark.slow
def test_a_wrong_scale_is_no_printers_doing(tmp_path: Path) -> None:
    """A drawing farther off than printers and hands together is never accepted."""
    for k in (0.87, 1.16):
        taken = shot(work(None, 1, k), "base", tmp_path / "p.jpg")
        assert check(PLAN.asked, read_paper(str(taken.file), PLAN.asked, Known())).verdict != "right"


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A drawing behind an empty page, as a TIFF; and twice, as a PDF."""
    folder = tmp_path_factory.mktemp("pages")
    sheet = Image.open(shot(work(None, 1), "base", folder / "p.png").file).convert("L")
    empty = Image.new("L", sheet.size, 250)
    empty.save(folder / "two.tif", save_all=True, append_images=[sheet], compression="tiff_lzw")
    sheet.save(folder / "three.pdf", save_all=True, append_images=[empty, sheet], resolution=200)
    return folder


def test_pages_are_counted_and_named(pages: Path, capfd: pytest.CaptureFixture[str]) -> None:
    """A page there is not is refused in a sentence; what is no file of pages has one."""
    assert [len(sheets_of(pages / name)) for name in ("two.tif", "three.pdf", "p.png")] == [2, 3, 1]
    (pages / "broken.pdf").write_bytes(b"%PDF-1.4 nothing")
    assert len(sheets_of(pages / "broken.pdf")) == 1
    for file, page, count in (("two.tif", 3, 2), ("three.pdf", 0, 3), ("p.png", 2, 1)):
        with pytest.raises(PlanesError, match=f"no page {page}; it has {count}"):
            read_paper(str(pages / file), PLAN.asked, Known(page=page - 1))
    (pages / "broken.pdf").unlink()


@pytest.mark.slow
def test_the_page_that_holds_the_plan(pages: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """One page that can be read is the drawing; of several each has its verdict; a page may be named."""
    scene, asked = str(confusion.SAMPLES / "six-link.yaml"), ["--plan", "velocity", "--lang", "en"]
    assert main(["check", scene, str(pages / "two.tif"), *asked]) == 0
    assert "Page 2 of 2 was checked" in capsys.readouterr().out
    command = ["check", scene, str(pages / "three.pdf"), *asked]
    assert main([*command, "--json"]) == 2
    rows = json.loads(capsys.readouterr().out)
    assert [row["verdict"] for row in rows] == ["right", "unreadable", "right"] and rows[2]["file"] == "three-3.pdf"
    assert main([*command, "--page", "3"]) == 0
