"""PNG pictures written by this program: they carry their drawing; saved anew they are pictures like any other, of which
only the file's scale is known, no pole, no mark."""

from __future__ import annotations

from io import BytesIO
from pathlib import Path

import pytest
from PIL import Image

pytest.importorskip("cv2")
from planes.check.grading.paper import Known
from planes.check.grading.prepared_plan import Asked, known_plans
from planes.check.handed_in import read_paper
from planes.check.outcome import Outcome, check
from planes.documents.sheets import sheet_of
from planes.scene.carried import drawing_in_png, png_with_drawing
from planes.solving import Position
from planes.words.errors import PlanesError
from render.sheet import Sheet
from render.sheet.single import Page
from tests.check.test_own_sheets import ASSIGNMENTS, SCENES, drawn, made, mistakes, spoiled, view

MB = 1_000_000


def anew(written: Page | Sheet) -> bytes:
    """A page as another program saves it."""
    out = BytesIO()
    Image.open(BytesIO(written.file_contents(".png"))).save(out, "PNG", dpi=(200, 200))
    return out.getvalue()


def looked(sample: str, plan: str, data: bytes, folder: Path) -> Outcome:
    """What the check says of a picture."""
    file = folder / "p.png"
    asked = Asked(drawn(sample)[0], plan)
    file.write_bytes(data)
    return check(asked, read_paper(str(file), asked, Known()))


def judged(sample: str, plan: str, written: Page | Sheet, folder: Path) -> str:
    """The verdict on a page saved anew, or the sentence of a refusal."""
    try:
        found = looked(sample, plan, anew(written), folder)
    except PlanesError as error:
        return str(error)
    return found.sentence.told("en") if found.unreadable else found.verdict


def there(position: Position, plan: str) -> bool:
    """Whether there is something to draw."""
    marks = [m for m in position.drawing.things if m.startswith(f"{plan}:")]
    return plan == "position" or any(abs(position.drawing[m]) > 1e-6 for m in marks)


def with_mistake(sample: str, plan: str, mistake: str, blames: str) -> Position:
    """A sample's position with a mistake in a plan."""
    known = [(v.mistake, v.blames) for v in mistakes(sample, plan)]
    return made(sample, plan, drawn(sample)[1], known.index((mistake, blames)))[0]


FOUND = (
    ("assignments/61", "position", "other_assembly", "S4"),  # where a mass centre should be stands another point
    ("assignments/12", "velocity", "relative_from_pole", "d5"),
    ("bntu-2", "force:1", "force_doubled", "F_12"),
    ("kind-5-rpp", "force:2-3", "force_doubled", "P_2"),
    ("assignments/03", "force:2-3", "force_doubled", "P_3"),
    ("assignments/04", "force:1", "reaction_not_reversed", "F_12"),  # there and back, with each other's names
)


@pytest.mark.few(3)
@pytest.mark.parametrize(("sample", "plan", "mistake", "where"), FOUND)
def test_a_spoiled_picture_is_judged_by_the_drawing_it_carries(
    sample: str, plan: str, mistake: str, where: str, tmp_path: Path
) -> None:
    page = view(sample, plan, with_mistake(sample, plan, mistake, where))
    found = looked(sample, plan, page.file_contents(".png"), tmp_path)
    assert (found.verdict, found.first_wrong) == ("wrong", where), found.sentence.told("en")


def test_a_drawing_is_that_of_its_own_pixels_alone() -> None:
    """A picture painted over by a program that copies what it does not know no longer carries its drawing."""
    page = view("crank-slider", "velocity", drawn("crank-slider")[1])
    data, svg = page.file_contents(".png"), page.file_contents(".svg")
    assert drawing_in_png(data, MB) == svg and drawing_in_png(data, len(svg) - 1) is None
    white = BytesIO()
    Image.new("RGB", Image.open(BytesIO(data)).size, "white").save(white, "PNG")
    start, ours, theirs = data.index(b"plAN") - 4, data.index(b"IDAT") - 4, white.getvalue().index(b"IDAT") - 4
    painted = white.getvalue()[:theirs] + data[start:ours] + white.getvalue()[theirs:]
    assert b"plAN" in painted and drawing_in_png(painted, MB) is None and drawing_in_png(white.getvalue(), MB) is None
    assert Image.open(BytesIO(painted)).convert("L").getextrema() == (255, 255)


def test_a_damaged_or_swollen_drawing_is_none() -> None:
    plain = BytesIO()
    Image.new("RGB", (60, 60)).save(plain, "PNG")
    swollen = png_with_drawing(plain.getvalue(), bytes(50 * MB))
    assert len(swollen) < MB and drawing_in_png(swollen, MB) is None
    whole = png_with_drawing(plain.getvalue(), b"<svg/>")
    assert drawing_in_png(whole, MB) == b"<svg/>"
    for data in (whole[:90], whole.replace(whole.partition(b"plAN")[2][:14], bytes(14)), b"", plain.getvalue()):
        assert drawing_in_png(data, MB) is None


def test_a_picture_upon_another_carries_no_drawing() -> None:
    """Of a page with a photograph under it the lines alone are not what is seen."""
    from render.paper.photo import Photo

    page = view("crank-slider", "velocity", drawn("crank-slider")[1])
    grey = BytesIO()
    Image.new("L", (80, 80), 200).save(grey, "JPEG")
    under = Page(page.marks, page.size, "x", under=Photo(grey.getvalue(), (0.0, 0.0, 50.0, 50.0)))
    assert drawing_in_png(under.file_contents(".png"), 10 * MB) is None and drawing_in_png(
        page.file_contents(".png"), 10 * MB
    )


ANEW = (
    ("assignments/36", "position", "right"),  # two points nearer to each other than their signs are wide
    ("six-link", "velocity", "right"),
    ("assignments/50", "acceleration", "right"),  # a head hidden at the pole
    ("kind-1-rrr", "position", "right"),
    ("sliding-driver", "acceleration", "right"),
    ("assignments/29", "velocity", "right_as_seen"),  # a head hidden between two others
)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(("sample", "plan", "verdict"), ANEW)
def test_a_right_picture_saved_anew_is_right_by_its_arrowheads(
    sample: str, plan: str, verdict: str, tmp_path: Path
) -> None:
    assert judged(sample, plan, view(sample, plan, drawn(sample)[1]), tmp_path) == verdict


@pytest.mark.slow
def test_a_right_picture_of_crowded_heads_is_right(tmp_path: Path) -> None:
    """Saved anew, without its pole."""
    sample, plan = "assignments/21", "acceleration"
    assert judged(sample, plan, view(sample, plan, drawn(sample)[1]), tmp_path) in ("right", "right_as_seen")


def test_a_wrong_picture_saved_anew_is_wrong(tmp_path: Path) -> None:
    k = spoiled("crank-slider", "velocity", 1)
    assert k is not None
    wrong = made("crank-slider", "velocity", drawn("crank-slider")[1], k)[0]
    assert judged("crank-slider", "velocity", view("crank-slider", "velocity", wrong), tmp_path) == "wrong"


@pytest.mark.slow
def test_forces_saved_anew_are_asked_about(tmp_path: Path) -> None:
    """Printed side by side they are told by their names alone, which letters in a picture do not say."""
    page = view("crank-slider", "force:2-3", drawn("crank-slider")[1])
    assert "--pole" in judged("crank-slider", "force:2-3", page, tmp_path)


@pytest.mark.slow
def test_a_print_of_another_plan_is_not_this_one(tmp_path: Path) -> None:
    assert judged("six-link", "acceleration", view("six-link", "velocity", drawn("six-link")[1]), tmp_path) != "right"


@pytest.mark.slow
def test_a_plan_of_a_whole_sheet_saved_anew_is_right(tmp_path: Path) -> None:
    """Frame, title block, tables and the other plans are not its lines, and the sheet has chosen its own scale."""
    sheet = sheet_of(drawn("crank-slider")[0], None, number=1)
    assert judged("crank-slider", "velocity", sheet, tmp_path) == "right"


@pytest.mark.long
@pytest.mark.parametrize("sample", [*SCENES, *ASSIGNMENTS])
def test_no_spoiled_view_saved_anew_is_right(sample: str, tmp_path: Path) -> None:
    for plan in known_plans(drawn(sample)[1].plans):
        k = spoiled(sample, plan, 1)
        if k is not None and there(wrong := made(sample, plan, drawn(sample)[1], k)[0], plan):
            assert judged(sample, plan, view(sample, plan, wrong), tmp_path) != "right", plan
