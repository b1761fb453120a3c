"""The corpus of physically made pictures: its paper, its camera, two of its pictures, and a folder of dropped ones."""

from __future__ import annotations

import random
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest

pytest.importorskip("cv2")
from planes.check.fiducials import SHEET_MM
from planes.plans.sheet_room import SheetRoom
from tests import confusion
from tests.confusion import SAMPLES, easel
from tests.helpers.drawings import Mistake
from tests.physical import camera, corpus, folder
from tests.physical.counting import Tally
from tests.physical.factors import FACTORS
from tests.physical.paper import Paper
from tests.physical.setting import Setting, varied
from tests.picture_corpus import drawn

SIX, RAIL, OVER = easel("six-link", "velocity"), easel("kind-3-rpr", "velocity"), "overshoot 25 mm"


@pytest.fixture
def usual_sizes(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Plans of the usual sizes, at which drawings of counts were looked at."""
    confusion.bench.cache_clear()
    monkeypatch.setattr(SheetRoom, "largest_sizes", lambda self, usual, scales_at: usual)
    yield
    confusion.bench.cache_clear()


def work(mistake: Mistake | None, seed: int) -> corpus.Work:
    one = drawn(SIX, mistake, random.Random(seed))
    assert one is not None
    return corpus.Work(SIX, mistake, one)


def shot(of: corpus.Work, factor: str, file: Path) -> corpus.Picture:
    """A picture of one factor."""
    setting = varied(Setting(), FACTORS[factor], random.Random(factor))
    found = corpus.picture(of, setting, factor, file)
    assert found is not None
    return found


def test_graphite_stays_on_the_heights_of_the_grain() -> None:
    """The lighter the hand, the less paper along a line is covered, and the less evenly."""
    lines = []
    for press in (0.4, 0.7, 1.0):
        paper = Paper((40.0, 10.0), Setting(), random.Random(1))
        paper.lay([5 + 5j, 35 + 5j], [press, press], 0.5, (90, 84, 82))
        lines.append(paper.colour[60, 80:400].mean(axis=1))
    means, spreads = ([f(line) for line in lines] for f in (lambda a: a.mean(), lambda a: a.std()))
    assert 225 > means[0] > means[1] + 25 > means[2] + 40
    assert spreads[0] > 2 * spreads[2]


@pytest.mark.few(1)
@pytest.mark.parametrize("quarter", [0, 1])
def test_a_place_is_seen_where_the_camera_says(quarter: int) -> None:
    """A dot on a tilted sheet behind a bent lens is at the pixel its place is said to have."""
    setting, z = Setting(camera="phone", tilt_deg=15, lens=0.05, width_px=1400, quarter=quarter), 60 + 150j
    paper = Paper(SHEET_MM, setting, random.Random(1))
    for k in range(4):
        paper.lay([z - 1j**k, z + 1j**k], [1.0, 1.0], 2.0, (20, 20, 20), even=1.0)
    seen, view = camera.taken(paper, setting, random.Random(2))
    x, y = round(view.see(z).real), round(view.see(z).imag)
    dark = 255.0 - seen[y - 15 : y + 16, x - 15 : x + 16].mean(axis=2)
    dark = (dark - dark.min() - 60).clip(0)
    middle = complex((dark.sum(axis=0) * range(-15, 16)).sum(), (dark.sum(axis=1) * range(-15, 16)).sum()) / dark.sum()
    assert abs(middle + complex(x, y) - view.see(z)) < 0.3


@pytest.mark.slow
def test_pictures_are_made_checked_and_counted(tmp_path: Path) -> None:
    """A right drawing in pencil, scanned; one with a mistake, taken by a telephone."""
    whole = Tally()
    whole.add(corpus.counted(shot(work(None, 1), "base", tmp_path / "right.jpg")))
    whole.add(corpus.counted(shot(work(Mistake("omega1_reversed", "b"), 2), "phone", tmp_path / "wrong.jpg")))
    assert (whole.right, whole.wrong, whole.unread, whole.false) == (1, 1, 0, 0)
    assert (whole.accepted, whole.found, whole.step, whole.named) == (1, 1, 1, 1)
    assert whole.row()[:5] == ["1/1", "1/1", "1/1", "1/1", "0/2"] and sorted(whole.errors)[len(whole.errors) // 2] < 0.4


@pytest.mark.slow
@pytest.mark.usefixtures("usual_sizes")
def test_lines_drawn_on_past_their_vectors_hide_no_plan(tmp_path: Path) -> None:
    """A missing normal part is named though a fainter construction line runs on past every vector."""
    *_, one = corpus.works(4, 11)
    taken = corpus.picture(
        one, varied(Setting(), FACTORS[OVER], random.Random(f"11 {OVER} 3")), f"11 {OVER} 3", tmp_path / "p.jpg"
    )
    assert taken is not None and one.mistake and one.mistake.name == "normal_missing"
    assert corpus.counted(taken).named == 1


@pytest.mark.slow
@pytest.mark.parametrize(
    ("factor", "seed", "number"),
    [
        ("light .45", 91, 9),  # light lines end before the dark heads they lead to
        ("bow", 91, 10),  # a line bent by 0.8 mm
        ("overshoot 12 mm", 91, 11),  # a polygon that runs on past the pole, and its construction line past its head
        ("no heads", 301, 0),  # a mass centre in the middle of a vector, which its name alone tells
        ("tinted paper", 401, 1),  # a mistake that leaves the ink of the right plan, but other places of names
    ],
)
@pytest.mark.usefixtures("usual_sizes")
def test_what_was_misjudged_once_is_judged_rightly(factor: str, seed: int, number: int, tmp_path: Path) -> None:
    """Drawings of counts that were looked at."""
    drawn_ = f"{seed} {factor} {number}"
    *_, one = corpus.works(number + 1, f"{seed} {factor}", 12 * list(FACTORS).index(factor))
    setting = varied(Setting(), FACTORS[factor], random.Random(drawn_))
    taken = corpus.picture(one, setting, drawn_, tmp_path / "p.jpg")
    assert taken is not None
    found = corpus.counted(taken)
    assert found.named if one.mistake else found.accepted


@pytest.mark.slow
@pytest.mark.usefixtures("usual_sizes")
def test_a_force_that_runs_past_the_pole_to_a_lone_head_is_not_called_right(tmp_path: Path) -> None:
    """The head stands off the line that was fitted to two vectors beside each other."""
    factor = "phone, 1280 px"
    *_, one = corpus.works(8, f"223 {factor}", 12 * list(FACTORS).index(factor))
    drawn_ = f"223 {factor} 7"
    taken = corpus.picture(one, varied(Setting(), FACTORS[factor], random.Random(drawn_)), drawn_, tmp_path / "p.jpg")
    assert taken is not None and one.mistake == Mistake("not_closed", "F_10")
    assert corpus.counted(taken).false == 0


@pytest.mark.slow
def test_a_mark_that_gives_the_scale_may_be_one_a_mistake_moved(tmp_path: Path) -> None:
    """On paper without print: b is built along the link, so that b3, which is pointed to, is a fifth too long."""
    assert named(RAIL, "along_link", "b", shot_as="points", file=tmp_path / "p.jpg") == (1, 1, 1)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("sample", "plan", "mistake", "where"),
    [
        ("kind-3-rpr", "acceleration", "tangential_along_link", "b'"),  # most marks follow from it
        ("kind-4-prp", "acceleration", "coriolis_missing", "k_BB1"),
    ],
)
def test_a_pole_nobody_told_of_is_guessed_though_the_drawing_has_a_mistake(
    sample: str, plan: str, mistake: str, where: str, tmp_path: Path
) -> None:
    """On a sheet with a frame; what was left out is said where all else is as it should be."""
    file = tmp_path / "p.jpg"
    assert named(easel(sample, plan), mistake, where, shot_as="frame, pole guessed", file=file) == (1, 1, 1)


@pytest.mark.slow
def test_a_force_left_out_of_a_polygon_whose_pole_nobody_told_of_is_a_mistake(tmp_path: Path) -> None:
    """Which force is told by the order of the others, and that is not always found."""
    shot_as, file = "frame, pole guessed", tmp_path / "p.jpg"
    assert named(easel("kind-4-prp", "force:2-3"), "weight_missing", "G_3", shot_as=shot_as, file=file)[0] == 1


def named(of: confusion.Easel, mistake: str, where: str, shot_as: str, file: Path) -> tuple[int, int, int]:
    """Whether the mistake of a drawing is found in its picture, at its step, and named."""
    made = next(m for m in confusion.possible(of) if (m.name, m.where) == (mistake, where))
    one = drawn(of, made, random.Random(3))
    assert one is not None
    found = corpus.counted(shot(corpus.Work(of, made, one), shot_as, file))
    return found.found, found.step, found.named


@pytest.mark.slow
def test_a_dropped_picture_with_its_marks_is_counted(tmp_path: Path) -> None:
    """The table begins with the command its report page shows; a table without one takes the folder's."""
    one = work(None, 3)
    shot(one, "pen", tmp_path / "anna.jpg")
    shutil.copy(SAMPLES / "six-link.yaml", tmp_path)
    rows = [f"{name},{z.real:.3f},{z.imag:.3f},0.1" for name, z in {"p": 0j, **one.one.marks}.items()]
    table, command = ["mark,x_mm,y_mm,error_mm", *rows], "planes check work/six-link.yaml marks.csv --plan velocity"
    (tmp_path / "anna.csv").write_text("\n".join([f"# {command}", *table]), "utf-8")
    found = folder.of_folder(tmp_path)
    assert (found.right, found.accepted, found.unread) == (1, 1, 0) and len(found.errors) == len(one.one.marks)
    (tmp_path / "anna.csv").write_text("\n".join(table), "utf-8")
    with pytest.raises(ValueError, match=r"command\.txt"):
        list(folder.pairs(tmp_path))
    (tmp_path / "command.txt").write_text(command, "utf-8")
    (tmp_path / "anna.csv").write_text("\n".join([*table, "# --format A4"]), "utf-8")
    pair = next(folder.pairs(tmp_path))
    assert pair.command == (str(tmp_path / "six-link.yaml"), "--plan", "velocity") and pair.options == (
        "--format",
        "A4",
    )
