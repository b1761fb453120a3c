"""The square code of a blank: whose sheet it is, read from pictures, trusted in nothing."""

from __future__ import annotations

import random
from dataclasses import replace
from pathlib import Path

import pytest

from planes.check.fiducials import (
    CODE_SIDE_MM,
    SHEET_MM,
    code_centre,
    has_room,
    is_within_square,
    mark_and_code_squares,
    pole_position,
)
from planes.check.grading.paper import Known
from planes.check.grading.prepared_plan import Asked, prepare
from planes.check.handed_in import read_paper
from planes.check.sheet_mark import LONGEST_FIELDS, SheetMark, parse_mark, qr_code_cells, shortened_name
from planes.documents.check import blank_marks, write_blank
from planes.scene import load
from render.files import pdf
from tests.helpers import ROOT

cv2 = pytest.importorskip("cv2")
import numpy as np  # noqa: E402

from planes.check.blank import blank_pole, plan_fitting_blank  # noqa: E402
from planes.check.evidence.ink import drawing_ink  # noqa: E402
from planes.check.outcome import check  # noqa: E402
from planes.check.sheet_mark import read_mark_on_picture  # noqa: E402
from planes.check.vision.image.decoding import load as picture_of  # noqa: E402
from planes.check.vision.image.picture import flatten  # noqa: E402
from planes.check.vision.photograph import read_picture  # noqa: E402
from tests.helpers.class_pictures import scanned  # noqa: E402
from tests.helpers.line_drawings import head  # noqa: E402
from tests.physical import corpus, page  # noqa: E402
from tests.physical.factors import FACTORS  # noqa: E402
from tests.physical.paper import PX_PER_MM  # noqa: E402
from tests.physical.setting import Setting, varied  # noqa: E402

SIX = load(ROOT / "samples" / "six-link.yaml")
LONG = SheetMark(
    "двенадцатое-задание-курсовое", "Вариант-Б-23", "Константинопольский-Константин-М-31", "velocity", 120.5
)
HOSTILE = [
    "../../etc/passwd",
    "C:\\Windows\\x",
    "<img src=x onerror=1>",
    "a\0b\nc",
    "Ж" * 4000,
    "\u202egpj.exe",
    "$(reboot)",
]


def printed(mark: SheetMark, dpi: float = 200.0) -> np.ndarray:
    """The blank with a mark, as it is printed."""
    marks, title = blank_marks(Asked(SIX, "velocity"), "ru", mark=mark)
    data = pdf.write_png(marks, SHEET_MM, title, dpi=dpi)
    return cv2.imdecode(np.frombuffer(data, np.uint8), cv2.IMREAD_GRAYSCALE)


def test_a_mark_is_read_back_as_it_was_printed() -> None:
    short_one = SheetMark("six-link", "Б", "Иванов-Пётр", "force:2-3", 30.0, 0.05)
    assert short_one.printed_text == "planes1|six-link|Б|Иванов-Пётр|force:2-3|30|0.05"
    assert parse_mark(short_one.printed_text) == short_one and short_one.matches_task_and_student(
        "six-link", "Иванов-Пётр"
    )
    with_pole = replace(short_one, pole=148.5 + 105j)
    assert with_pole.printed_text == "planes2|six-link|Б|Иванов-Пётр|force:2-3|30|0.05|148.5,105"
    assert parse_mark(with_pole.printed_text) == with_pole
    read = parse_mark(LONG.printed_text)
    assert (
        read is not None
        and read.printed_text == LONG.printed_text
        and read.matches_task_and_student(LONG.scene, LONG.student)
    )
    assert not read.matches_task_and_student(
        LONG.scene, "Константинопольский-Константин-М-32"
    ) and read.matches_task_and_student("", "")


@pytest.mark.parametrize("name", HOSTILE)
def test_a_hostile_name_is_a_few_letters(name: str) -> None:
    mark = SheetMark(name, name, name, name)
    assert all(len(part) <= most for part, most in zip(mark.printed_text.split("|")[1:5], LONGEST_FIELDS, strict=True))
    assert mark.printed_text.isprintable() and len(qr_code_cells(mark.printed_text)) <= 57
    assert parse_mark(f"planes1|{name}|||velocity||") is None or shortened_name(name, LONGEST_FIELDS[0]) == name


@pytest.mark.parametrize(
    "text",
    [
        "",
        "http://localhost",
        "planes1|a|b|c",
        "planes2|a|b|c|velocity||",
        "planes2|a|b|c|velocity||||",
        "planes2|a|b|c|velocity|||1e3,5",
        "planes1|a|b|c|velocity|||10,5",
        "planes1|a|b|c|velocity|nan|",
        "planes1|a|b|c|velocity|1e999|",
        "planes1|a|b|c|velocity||-3",
        "planes1|a|b|c|velocity||0",
        "planes1|a\n|b|c|velocity||",
        f"planes1|{'a' * 25}|b|c|velocity||",
        "planes1|a|b|c|velocity||" + " " * 999,
    ],
)
def test_what_is_not_of_this_form_is_no_mark(text: str) -> None:
    assert parse_mark(text) is None


def test_the_code_is_read_from_a_scan_and_is_no_ink() -> None:
    seen = scanned(printed(LONG), askew_deg=1.5)
    mark, flat = read_mark_on_picture(seen), flatten(seen)
    assert (
        mark is not None
        and mark.matches_task_and_student(LONG.scene, LONG.student)
        and mark.pole
        and mark.mu
        and flat is not None
    )
    even = drawing_ink(flat).even
    (x, y), r = flat.mm_to_px(code_centre()), CODE_SIDE_MM / 2 * flat.scale
    assert (even[int(y - r) : int(y + r), int(x - r) : int(x + r)] == 255).all()
    assert read_mark_on_picture(np.full((400, 600), 255, np.uint8)) is None
    flat.grey[int(y - r) : int(y + r), int(x - r) : int(x)] = 255
    assert read_mark_on_picture(flat.grey) is None  # half a code is none


@pytest.mark.slow
@pytest.mark.parametrize("told", [True, False])
def test_a_blank_tells_where_its_own_pole_is(told: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A version that put the pole elsewhere, and whose scene had another scale, printed it: it is read all the same.

    A class has read the scale off the code before it asks.
    """
    bench, pole = prepare(Asked(SIX, "velocity", mu=0.8 * prepare(Asked(SIX, "velocity")).said_mu)), 131.5 + 96j
    with monkeypatch.context() as earlier:
        earlier.setattr("planes.documents.check.blank_pole", lambda _: pole)
        marks, title = blank_marks(bench.asked, "ru")
    data = pdf.write_png(marks, SHEET_MM, title, dpi=PX_PER_MM * 25.4)
    sheet = cv2.imdecode(np.frombuffer(data, np.uint8), cv2.IMREAD_GRAYSCALE)
    at = {"p": 0j, **bench.true_marks}
    for a, b in bench.vector_names:
        ends = [(pole + at[n]) for n in (a, b)]
        cv2.line(sheet, *[(round(z.real * PX_PER_MM), round(len(sheet) - z.imag * PX_PER_MM)) for z in ends], 60, 4)
    cv2.imwrite(str(tmp_path / "old.png"), sheet)
    asked = bench.asked if told else Asked(SIX, "velocity")
    found = check(asked, read_picture(str(tmp_path / "old.png"), prepare(asked), Known()))
    assert found.verdict in ("right", "right_as_seen") and found.grading and not found.grading.judgement.wrong


TAKEN = [
    "phone, 1280 px",
    "scan 150",
    "phone, tilt 17°",
    "phone, motion",
    "phone, shadow",
    "phone, JPEG 40",
    "quarter turns",
]


@pytest.mark.few(0, slow=4)
@pytest.mark.parametrize("factor", [*TAKEN, "printed at 97 %", "together: phone", "together: scan"])
def test_the_code_is_read_from_pictures_by_physics(
    factor: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The longest code there may be, on a sheet with a drawing, however the picture is taken."""
    sheet = printed(LONG, PX_PER_MM * 25.4)
    monkeypatch.setattr(page, "_blank", lambda *_: sheet)
    work = next(corpus.works(1, 1))
    for k in range(3):
        setting = varied(Setting(), FACTORS[factor], random.Random(f"{factor} {k}"))
        assert corpus.picture(work, setting, f"{factor} {k}", tmp_path / "p.jpg")
        mark = read_mark_on_picture(picture_of(tmp_path / "p.jpg").grey)
        assert (
            mark is not None
            and mark.matches_task_and_student(LONG.scene, LONG.student)
            and mark.value == LONG.value
            and mark.pole
        )


@pytest.mark.parametrize("suffix", [".svg", ".dxf", ".pdf", ".png"])
def test_blanks_carry_the_code_in_every_format(suffix: str, tmp_path: Path) -> None:
    file = tmp_path / f"blank{suffix}"
    write_blank(Asked(SIX, "velocity", 140.0), str(file), "en")
    if suffix in (".svg", ".dxf"):
        count = file.read_text("utf-8").count("HATCH" if suffix == ".dxf" else "<p")
        assert count > 100  # a run of black cells each
        assert not read_paper(str(file), Asked(SIX, "velocity"), Known()).spots  # none is taken for a line of a plan
        return
    bench = prepare(Asked(SIX, "velocity", 140.0))
    own = SheetMark("six-link", "", "", "velocity", 140.0, bench.said_mu, blank_pole(bench))
    assert read_mark_on_picture(picture_of(file).grey) == own


@pytest.mark.parametrize("plan", ["velocity", "force:2-3", "force:1"])
def test_the_pole_tells_nothing_of_the_plan(plan: str) -> None:
    """A plan turned about, and one of another mechanism, have their pole in the same place, with room to be drawn."""
    bench = prepare(Asked(SIX, plan))
    ends, pole = [*bench.true_marks.values()], blank_pole(bench)
    assert pole == pole_position([-z for z in ends]) == pole_position([1j * z / 2 for z in ends]) == pole_position([])
    w, h = SHEET_MM
    for z in (z * turn + pole for z in ends for turn in (1, -1)):
        assert 20 < z.real < w - 5 and 5 < z.imag < h - 5


def test_a_plan_too_large_for_the_middle_still_has_room() -> None:
    for ends in ([100j], [-100j], [150 + 0j, 120j], [-9 - 176j, 137 + 0j]):
        pole = pole_position(ends)
        assert all(20 < (z + pole).real < 292 and 5 < (z + pole).imag < 205 for z in (0j, *ends))
    assert abs(pole_position([100j]) - pole_position([])) <= 10


def test_no_mark_of_a_plan_stands_under_what_is_printed() -> None:
    """Neither under a corner mark nor under the code."""
    for ends in ([115 + 90j], [90 + 80j], [50 + 10j, 110 + 85j], [115 - 85j, 20 + 5j]):
        assert (
            any(is_within_square(pole_position([]) + z, square) for z in ends for square in mark_and_code_squares())
            or len(ends) > 1
        )
        pole = pole_position(ends)
        assert not any(is_within_square(pole + z, square) for z in (0j, *ends) for square in mark_and_code_squares())
    assert pole_position([40 + 20j]) == pole_position([])


@pytest.mark.slow
def test_a_picture_of_a_blank_is_read_at_the_scale_its_code_tells(tmp_path: Path) -> None:
    """The right plan drawn on the blank that is printed for half of the scene's μ."""
    asked, file = Asked(SIX, "acceleration"), tmp_path / "p.jpg"
    bench = plan_fitting_blank(prepare(asked))
    marks, title = blank_marks(asked, "ru")
    page = cv2.imdecode(np.frombuffer(pdf.write_png(marks, SHEET_MM, title, dpi=200), np.uint8), cv2.IMREAD_GRAYSCALE)
    places, pole, k = {"p": 0j, **bench.true_marks}, blank_pole(bench), 200 / 25.4
    for a, b in ((places[a] + pole, places[b] + pole) for a, b in bench.vector_names):
        if abs(b - a) > 0.3:
            ends = [(round(z.real * k * 16), round((SHEET_MM[1] - z.imag) * k * 16)) for z in head(a, b)]
            start = round(a.real * k * 16), round((SHEET_MM[1] - a.imag) * k * 16)
            cv2.line(page, start, ends[0], 60, 3, cv2.LINE_AA, 4)
            cv2.fillPoly(page, [np.array(ends, np.int32)], 60, cv2.LINE_AA, 4)
    cv2.imwrite(str(file), cv2.GaussianBlur(page, (0, 0), 0.7))
    assert check(asked, read_paper(str(file), asked, Known())).verdict == "right"
    own = Asked(SIX, "acceleration", mu=2.0)  # told otherwise, that holds
    assert check(own, read_paper(str(file), own, Known())).verdict != "right"


def test_a_scheme_wider_than_its_blank_is_drawn_on_it_at_the_next_scale() -> None:
    wide = prepare(Asked(load(ROOT / "samples" / "class-three" / "three-basic-links.yaml"), "position"))
    assert not has_room([*wide.true_marks.values()])
    assert has_room([*(blank := plan_fitting_blank(wide)).true_marks.values()]) and blank.said_mu == 0.5 * wide.said_mu
