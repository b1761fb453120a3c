"""What else stands on a page, a blank printed at another size, files of several pages: only the plan is judged."""

from __future__ import annotations

import json
import random
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

cv2 = pytest.importorskip("cv2")
import numpy as np  # noqa: E402
from PIL import Image  # noqa: E402

from planes.check.grading.paper import Known  # noqa: E402
from planes.check.handed_in import read_paper, sheets_of  # noqa: E402
from planes.check.outcome import check  # noqa: E402
from planes.check.vision.image.decoding import load  # noqa: E402
from planes.check.vision.image.picture import Flat, flatten  # noqa: E402
from planes.check.vision.marks.print_scale import by_ruler, likely_shares, printed_share  # noqa: E402
from planes.check.vision.strokes.hanging import hanging, tabled  # noqa: E402
from planes.check.vision.strokes.line_fitting import Fitted  # noqa: E402
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


def line(a: complex, b: complex) -> Fitted:
    return Fitted(a, (b - a) / abs(b - a), (0.0, 0.0, 0.0), 0.0, abs(b - a), 0.05, 0.4)


def test_what_hangs_together_with_the_pole() -> None:
    """Its lines, what meets these, the pieces of one torn line; neither a table nor a plan that stand apart."""
    own = [line(0j, 50 + 0j), line(52 + 0j, 60 + 40j), line(0j, -30j), line(-40j, -70j)]
    table = [line(80 + 50j, 120 + 50j), line(80 + 50j, 80 + 70j)]
    assert hanging([*own, *table, line(-60 + 0j, -60 + 40j)], 0j) == [0, 0, 0, 0, 1, 1, 2]
    assert hanging([], 0j) == [] and hanging(table, 0j) == [1, 1]


def test_a_plan_that_begins_near_the_pole_stands_apart() -> None:
    """Though its lines, run on, would cross those of the first: but what goes on with a line is of it."""
    own, other = [line(0j, 90j - 25), line(-2j, 80j - 2)], [line(-2 - 13j, -95 - 37j), line(-2 - 13j, -42 - 82j)]
    assert hanging([*own, *other], 0j) == [0, 0, 1, 1]
    assert hanging([*own, *other, line(100j - 27.8, 120j - 33.3)], 0j) == [0, 0, 1, 1, 0]


def test_a_table_hangs_together_with_nothing() -> None:
    """However near its lines come, and through whatever they are drawn; three vectors at right angles are no table."""
    rows, columns = [line(28 - 5j * k, 90 - 5j * k) for k in range(6)], [line(x + 0j, x - 25j) for x in (28, 45, 90)]
    assert tabled([*rows, *columns]) == set(range(9))
    assert hanging([line(0j, 30 - 10j), *rows, *columns], 0j) == [0, *9 * [-1]]
    assert tabled([line(0j, 30 + 0j), line(10 + 0j, 10 + 9j), line(20 + 0j, 20 + 9j), line(30 + 0j, 30 + 9j)]) == set()


@pytest.mark.slow
@pytest.mark.parametrize("factor", ["frame, title block", "second plan", "table, names"])
def test_only_the_plan_is_priced(factor: str, tmp_path: Path) -> None:
    """A title block, another plan, a table and names beside the drawing change neither verdict."""
    whole = Tally()
    whole.add(corpus.counted(shot(work(None, 1), factor, tmp_path / "right.jpg")))
    whole.add(corpus.counted(shot(work(WRONG, 2), factor, tmp_path / "wrong.jpg")))
    assert (whole.accepted, whole.found, whole.named, whole.unread) == (1, 1, 1, 0)


def test_the_share_of_print_most_vectors_tell() -> None:
    """Long ones together; a short one alone tells nothing, nor does anything on a sheet without corner marks."""
    true = {"b": 60 + 0j, "c": 20 + 45j, "d": 14j}
    flat = Flat(np.full((1680, 2376), 255, np.uint8), 8.0)
    seen = [(n, z / 0.97, z) for n, z in true.items()]
    one, share = likely_shares(flat, seen)
    assert one == 1 and abs(share - 0.97) < 1e-9
    assert likely_shares(flat, [("b", true["b"], true["b"]), ("d", 14.3j, 14j)]) == [1.0]
    assert likely_shares(flat, [(n, z / 0.8, z) for n, z in true.items()]) == [1.0]
    assert likely_shares(replace(flat, by="points"), seen) == [1.0]
    assert by_ruler(flat, 0j, 0.97, [], 0.2, true) == [] and not flat.notes
    by_ruler(flat, 100 + 50j, 0.97, [], 0.9, true)
    assert (
        abs(flat.mm(800.0, flat.grey.shape[0] - 400.0) - (100 + 50j)) < 1e-9 and abs(flat.size_mm[0] / 0.97 - 297) < 0.1
    )


@pytest.mark.slow
@pytest.mark.parametrize("share", [0.985, 0.97, 0.94])
def test_a_blank_printed_to_fit_is_no_mistake(share: float, tmp_path: Path) -> None:
    """The share is never blamed, and told, within a hand's error, where it shows: this plan has but one vector laid off
    by a ruler, and 1.5 % of 60 mm is no more than a hand's error. What is drawn wrongly is still found."""
    taken = shot(work(None, 1), "base", tmp_path / "right.jpg", print_scale=share)
    found = check(PLAN.asked, read_paper(str(taken.file), PLAN.asked, Known()))
    told = [float(str(n.parts["share"])) / 100 for n in found.notes if n.key == "check_printed_at"]
    assert found.verdict == "right" and all(abs(one - share) < 0.015 for one in told)
    assert told or share > 0.98
    assert corpus.counted(shot(work(WRONG, 2), "base", tmp_path / "wrong.jpg", print_scale=share)).named == 1


@pytest.mark.slow
@pytest.mark.parametrize("share", [0.985, 0.97])
def test_a_scan_tells_the_share_its_blank_was_printed_at(share: float, tmp_path: Path) -> None:
    """By its resolution, to a scanner's own error: marks are then read to a third of a millimetre."""
    taken = shot(work(None, 1), "base", tmp_path / "right.jpg", print_scale=share)
    picture = load(taken.file)
    flat = flatten(picture.grey)
    assert flat is not None and abs(printed_share(flat, picture.grey, picture.scale) - share) < 0.002
    assert printed_share(flat, picture.grey, None) == printed_share(flat, picture.grey, 2 * (picture.scale or 0)) == 1
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
