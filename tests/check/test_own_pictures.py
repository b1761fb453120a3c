"""PNG pictures written by this program, given to its own check: only the file's scale is known, no pole, no mark."""

from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("cv2")
from planes.check import Outcome, check
from planes.check.grading.prepared_plan import Asked, known_plans
from planes.check.handed_in import Known, read_paper
from planes.documents import rendered, sheet_of
from planes.solving import Position
from planes.words.errors import PlanesError
from planes.words.lettering import Naming
from render.sheet import Sheet
from render.sheet.single import Page
from tests.check.test_own_sheets import ASSIGNMENTS, SCENES, drawn, made, spoiled, view


def looked(sample: str, plan: str, written: Page | Sheet, folder: Path) -> Outcome:
    """What the check says of a page written as a picture."""
    file, asked = (
        folder / "p.png",
        Asked(drawn(sample)[0], plan, spelt=Naming("ru", drawn(sample)[0].frame_number).vector),
    )
    file.write_bytes(rendered(written, ".png", "ru"))
    return check(asked, read_paper(str(file), asked, Known()))


def judged(sample: str, plan: str, written: Page | Sheet, folder: Path) -> str:
    """The verdict, or the sentence of a refusal."""
    try:
        found = looked(sample, plan, written, folder)
    except PlanesError as error:
        return str(error)
    return found.sentence.told("en") if found.unreadable else found.verdict


def there(position: Position, plan: str) -> bool:
    """Whether there is something to draw."""
    marks = [m for m in position.drawing.things if m.startswith(f"{plan}:")]
    return plan == "position" or any(abs(position.drawing[m]) > 1e-6 for m in marks)


def wrongly(sample: str, plan: str) -> Position:
    """A sample's position with a mistake of the catalogue in the plan."""
    k = spoiled(sample, plan, 1)
    assert k is not None
    return made(sample, plan, drawn(sample)[1], k)[0]


VIEWS = (
    ("sliding-driver", "acceleration", "e'", "similarity_mirrored"),
    ("six-link", "velocity", "h", "across_guide"),
    ("kind-1-rrr", "velocity", "s2", "similarity_on_pole_segments"),
)


@pytest.mark.few(1)
@pytest.mark.parametrize(("sample", "plan", "where", "mistake"), VIEWS)
def test_a_view_is_right_and_with_one_step_spoiled_wrong_there(
    sample: str, plan: str, where: str, mistake: str, tmp_path: Path
) -> None:
    found = looked(sample, plan, view(sample, plan, drawn(sample)[1]), tmp_path)
    assert found.verdict == "right", found.sentence.told("en")
    found = looked(sample, plan, view(sample, plan, wrongly(sample, plan)), tmp_path)
    assert (found.verdict, found.first_wrong, found.mistake) == ("wrong", where, mistake)


DOUBTFUL = (
    ("assignment-12", "force:2-3"),
    ("bntu-3", "force:2-3"),  # a short arrow is not told from its neighbour
    ("kind-1-rrr", "position"),  # a mass centre's dot touches a line
    ("kind-3-rpr", "force:2-3"),
)


@pytest.mark.few(1)
@pytest.mark.parametrize(("sample", "plan"), DOUBTFUL)
def test_a_right_view_is_never_wrong(sample: str, plan: str, tmp_path: Path) -> None:
    """Where the reading is unsure, the pole is asked for."""
    said = judged(sample, plan, view(sample, plan, drawn(sample)[1]), tmp_path)
    assert said == "right" or "--pole" in said


BLIND = (
    ("six-link", "force:2-3"),  # a vector of a force plan drawn elsewhere or merely unseen
    ("kind-2-rrp", "force:2-3"),
    ("bntu-2", "velocity"),  # one vector: whose end the second mark shares is not seen
    ("bntu-2", "force:1"),
    ("bntu-2", "acceleration"),
)


@pytest.mark.few(1)
@pytest.mark.parametrize(("sample", "plan"), BLIND)
def test_what_a_picture_alone_cannot_show_is_asked_for(sample: str, plan: str, tmp_path: Path) -> None:
    assert "--pole" in judged(sample, plan, view(sample, plan, wrongly(sample, plan)), tmp_path)


def test_vectors_beside_each_other_and_details_mislead_nobody(tmp_path: Path) -> None:
    found = looked("crank-slider", "force:1", view("crank-slider", "force:1", drawn("crank-slider")[1]), tmp_path)
    assert found.verdict == "right", found.sentence.told("en")


@pytest.mark.slow
@pytest.mark.parametrize("plan", ["position", "velocity", "acceleration", "force:2-3", "force:1"])
def test_a_plan_of_a_whole_sheet_is_right(plan: str, tmp_path: Path) -> None:
    """Frame, title block, tables and the other plans are not its lines, and the sheet has chosen its own scale."""
    found = looked("crank-slider", plan, sheet_of(drawn("crank-slider")[0], None), tmp_path)
    assert found.verdict == "right", found.sentence.told("en")


@pytest.mark.long
@pytest.mark.parametrize("sample", [*SCENES, *ASSIGNMENTS])
def test_no_spoiled_view_is_right(sample: str, tmp_path: Path) -> None:
    for plan in known_plans(drawn(sample)[1].plans):
        if there(drawn(sample)[1], plan) and spoiled(sample, plan, 1) is not None:
            written = view(sample, plan, wrongly(sample, plan))
            assert judged(sample, plan, written, tmp_path) != "right", plan
