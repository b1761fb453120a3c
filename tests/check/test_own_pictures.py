"""PNG pictures written by this program, given to its own check: only the file's scale is known, no pole, no mark."""

from __future__ import annotations

from io import BytesIO
from pathlib import Path

import pytest
from PIL import Image
from PIL.PngImagePlugin import PngInfo

pytest.importorskip("cv2")
from planes.check import Outcome, check
from planes.check.grading.paper import Known, ReadPaper
from planes.check.grading.prepared_plan import Asked, known_plans
from planes.check.handed_in import read_paper
from planes.check.vision.decoding import load
from planes.check.vision.printed_heads import THICK, THIN, shapes
from planes.documents.sheets import sheet_of
from planes.solving import Position
from planes.words.errors import PlanesError
from planes.words.lettering import LETTERING, Naming
from render.paper.marks import Text
from render.paper.style import head_size
from render.sheet import Sheet
from render.sheet.single import Page
from tests.check.test_own_sheets import ASSIGNMENTS, SCENES, drawn, made, mistakes, spoiled, view
from tests.check.test_whole_sheets import spoiled_sheet


def looked(sample: str, plan: str, written: Page | Sheet, folder: Path) -> Outcome:
    """What the check says of a page written as a picture."""
    file = folder / "p.png"
    asked = Asked(drawn(sample)[0], plan, spelt=Naming("ru", drawn(sample)[0].frame_number).vector)
    file.write_bytes(written.rendered(".png"))
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
    ("assignment-12", "velocity", "b", "omega1_reversed"),
    ("kind-1-rrr", "position", "B", "angle_sense"),
    ("bntu-2", "force:1", "F_12", "force_doubled"),  # two vectors, at the scale the title says
    ("bntu-2", "acceleration", "n_BA", "normal_from_pole"),  # one vector; the other marks are where it begins
)


@pytest.mark.few(2)
@pytest.mark.parametrize(("sample", "plan", "where", "mistake"), VIEWS)
def test_a_view_is_right_and_with_one_step_spoiled_wrong_there(
    sample: str, plan: str, where: str, mistake: str, tmp_path: Path
) -> None:
    found = looked(sample, plan, view(sample, plan, drawn(sample)[1]), tmp_path)
    assert found.verdict == "right", found.sentence.told("en")
    found = looked(sample, plan, view(sample, plan, wrongly(sample, plan)), tmp_path)
    assert (found.verdict, found.first_wrong, found.mistake) == ("wrong", where, mistake)


CROWDED = (
    ("bntu-3", "force:2-3"),  # five forces of one line, side by side
    ("assignment-12", "force:2-3"),  # vectors that lie upon each other but for a degree
    ("kind-3-rpr", "force:2-3"),  # heads within other heads
    ("kind-1-rrr", "position"),  # a mass centre's dot touches a line
    ("sliding-driver", "position"),  # the origin is not drawn, and the link is hatched
    ("bntu-4", "velocity"),  # one vector
    ("assignments/10", "force:2-3"),  # a head that fits two places of its own line
    ("assignments/33", "acceleration"),  # a name far from its mark, with a line to it
    ("assignments/08", "force:2-3"),  # names with lines to their vectors, each nearer to the other's
    ("assignments/33", "force:4-5"),  # three short forces of one line, side by side
    ("assignments/35", "force:2-3"),  # names nearer to each other's vectors, which nobody takes for one another
    ("assignments/38", "force:2-3"),  # a head seen but a millimetre off, for its own is hidden
    ("assignments/50", "acceleration"),  # a head hidden at the pole
    ("assignments/02", "force:2-3"),  # what looks like a head upon another vector
    ("assignments/12", "force:2-3"),  # two forces of a millimetre, one after the other
    ("assignments/56", "force:4-5"),  # a head drawn aside and hidden there
    ("assignments/67", "force:2-3"),  # a name at whose edge another vector's line ends
    ("assignments/35", "velocity"),  # a short vector whose head is half hidden
    ("assignments/29", "velocity"),  # a head hidden between two others
    ("assignments/62", "acceleration"),  # a head hidden upon thick lines
    ("assignments/15", "force:4-5"),  # what looks like a head past the end of a vector
    ("assignments/27", "force:2-3"),  # two short forces there and back
    ("assignments/51", "force:4-5"),  # what looks like a head, upon another vector that leads the other way
)


@pytest.mark.few(2)
@pytest.mark.parametrize(("sample", "plan"), CROWDED)
def test_a_crowded_view_is_right(sample: str, plan: str, tmp_path: Path) -> None:
    assert judged(sample, plan, view(sample, plan, drawn(sample)[1]), tmp_path) == "right"


SPOILED = ("six-link", "kind-2-rrp", "assignment-12", "bntu-3")


@pytest.mark.few(1)
@pytest.mark.parametrize("sample", SPOILED)
def test_a_spoiled_force_is_found(sample: str, tmp_path: Path) -> None:
    plan, k = "force:2-3", spoiled(sample, "force:2-3", 1)
    assert k is not None
    found = looked(sample, plan, view(sample, plan, wrongly(sample, plan)), tmp_path)
    assert (found.verdict, found.first_wrong) == ("wrong", mistakes(sample, plan)[k].blames), found.sentence.told("en")


OTHERWISE = (
    ("assignments/61", "position", "other_assembly", "S4"),  # where a mass centre should be stands another point
    ("assignments/12", "velocity", "relative_from_pole", "d5"),  # vectors that begin together look like a head
    ("assignments/13", "acceleration", "tangential_along_link", "b'"),  # a head hidden by other ink
    ("kind-5-rpp", "force:2-3", "force_doubled", "P_2"),  # all its ends beside others' ink
    ("assignments/03", "force:2-3", "force_doubled", "P_3"),  # a line crossed where the right vector would end
)


@pytest.mark.few(1)
@pytest.mark.parametrize(("sample", "plan", "mistake", "where"), OTHERWISE)
def test_a_mistake_beside_what_misleads_is_found(
    sample: str, plan: str, mistake: str, where: str, tmp_path: Path
) -> None:
    known = [(v.mistake, v.blames) for v in mistakes(sample, plan)]
    wrong = made(sample, plan, drawn(sample)[1], known.index((mistake, where)))[0]
    found = looked(sample, plan, view(sample, plan, wrong), tmp_path)
    assert (found.verdict, found.first_wrong) == ("wrong", where), found.sentence.told("en")


def test_two_forces_with_each_other_s_names_are_not_right(tmp_path: Path) -> None:
    """A vector whose head may be hidden at a knot is not thought to be there while another like it is drawn."""
    sample, plan = "assignments/04", "force:1"
    k = next(k for k, v in enumerate(mistakes(sample, plan)) if v.mistake == "reaction_not_reversed")
    found = looked(sample, plan, view(sample, plan, made(sample, plan, drawn(sample)[1], k)[0]), tmp_path)
    assert found.verdict == "wrong" and found.first_wrong == "F_12", found.sentence.told("en")


def test_a_print_of_another_plan_is_said_not_to_be_made_out(tmp_path: Path) -> None:
    with pytest.raises(PlanesError, match="not made out"):
        looked("six-link", "acceleration", view("six-link", "velocity", drawn("six-link")[1]), tmp_path)


def test_a_picture_tells_what_is_lettered_on_it(tmp_path: Path) -> None:
    """As text goes with a PDF; what is no list of such texts tells nothing."""
    file, page = tmp_path / "p.png", view("six-link", "velocity", drawn("six-link")[1])
    file.write_bytes(page.rendered(".png"))
    said = {w.text: w for w in load(file).words}
    mark = next(m for m in page.marks if isinstance(m, Text) and m.text == "h")
    assert "p, a, d" in said and abs(said["h"].place - mark.place) < mark.height and said["h"].height == mark.height
    for wrong in ("", "[[1]]", '[["p", NaN, 1, 3, 3, 0]]', "[" * 9000, "7"):
        beside = PngInfo()
        beside.add_itxt(LETTERING, wrong)
        Image.open(file).save(tmp_path / "q.png", dpi=(200, 200), pnginfo=beside)
        assert load(tmp_path / "q.png").words == ()


def test_a_picture_that_does_not_tell_its_lettering_is_right_or_asked_about(tmp_path: Path) -> None:
    sample, plan, file = "crank-slider", "velocity", tmp_path / "p.png"
    asked = Asked(drawn(sample)[0], plan)

    def bare(position: Position) -> ReadPaper:
        picture = Image.open(BytesIO(view(sample, plan, position).rendered(".png")))
        picture.save(file, dpi=(200, 200), pnginfo=PngInfo())
        return read_paper(str(file), asked, Known())

    assert check(asked, bare(drawn(sample)[1])).verdict == "right" and load(file).words == ()
    with pytest.raises(PlanesError, match="--pole"):
        bare(wrongly(sample, plan))


def test_printed_heads_are_of_the_sizes_the_sheets_have() -> None:
    for length in (0.5, 2.0, 5.0, 50.0):
        drawn_so = [head_size(length, shape.pen) for shape in (THICK, THIN)]
        assert [(s.long, s.wide) for s in shapes(length)] == [size for size in drawn_so if size != (0.0, 0.0)]


def test_vectors_beside_each_other_and_details_mislead_nobody(tmp_path: Path) -> None:
    found = looked("crank-slider", "force:1", view("crank-slider", "force:1", drawn("crank-slider")[1]), tmp_path)
    assert found.verdict == "right", found.sentence.told("en")


@pytest.mark.slow
@pytest.mark.parametrize("number", [None, 1, 2])
@pytest.mark.parametrize("plan", ["position", "velocity", "acceleration", "force:2-3", "force:1"])
def test_a_plan_of_a_whole_sheet_is_right(plan: str, number: int | None, tmp_path: Path) -> None:
    """Frame, title block, tables and the other plans are not its lines, and the sheet has chosen its own scale."""
    if number in (None, 2 if plan.startswith("force") else 1):
        found = looked("crank-slider", plan, sheet_of(drawn("crank-slider")[0], None, number=number), tmp_path)
        assert found.verdict == "right", found.sentence.told("en")


@pytest.mark.slow
@pytest.mark.parametrize(("number", "plan"), [(1, "velocity"), (2, "force:2-3")])
def test_a_spoiled_step_is_found_on_a_whole_sheet(
    number: int, plan: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    k = spoiled("crank-slider", plan, 1)
    assert k is not None
    found = looked("crank-slider", plan, spoiled_sheet("crank-slider", number, {plan: k}, monkeypatch), tmp_path)
    assert (found.verdict, found.first_wrong) == ("wrong", mistakes("crank-slider", plan)[k].blames)


@pytest.mark.slow
@pytest.mark.parametrize("sample", [*SCENES, *(pytest.param(a, marks=pytest.mark.long) for a in ASSIGNMENTS)])
def test_every_view_is_right(sample: str, tmp_path: Path) -> None:
    for plan in known_plans(drawn(sample)[1].plans):
        if there(drawn(sample)[1], plan):
            assert judged(sample, plan, view(sample, plan, drawn(sample)[1]), tmp_path) == "right", plan


@pytest.mark.long
@pytest.mark.parametrize("sample", [*SCENES, *ASSIGNMENTS])
def test_no_spoiled_view_is_right(sample: str, tmp_path: Path) -> None:
    for plan in known_plans(drawn(sample)[1].plans):
        if spoiled(sample, plan, 1) is not None and there(wrong := wrongly(sample, plan), plan):
            assert judged(sample, plan, view(sample, plan, wrong), tmp_path) != "right", plan
