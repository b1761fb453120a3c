"""A blank: what it says, what is left to be written by hand, and what stands beside its code."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from planes.check.blank import blank_pole, plan_fitting_blank
from planes.check.fiducials import CODE_SIDE_MM, SHEET_MM, code_centre
from planes.check.grading.paper import Known
from planes.check.grading.prepared_plan import Asked, prepare
from planes.check.handed_in import read_paper
from planes.check.outcome import check
from planes.check.sheet_mark import SheetMark
from planes.cli import main
from planes.documents.check import blank_marks
from planes.scene import load
from planes.words import available_languages
from planes.words.errors import PlanesError
from render.paper.marks import Line, Text
from render.paper.typeset import ink_width
from tests.helpers import ROOT

SIX = load(ROOT / "samples/six-link.yaml")
TWELVE = load(ROOT / "samples/assignments/12.yaml", "Г")
STRIP_MM = 23.0  # beneath the upper edge, where nothing that is drawn is looked for


def said(asked: Asked, lang: Any = "ru", **more: Any) -> list[str]:
    return [m.text for m in blank_marks(asked, lang, **more)[0] if isinstance(m, Text)]


@pytest.mark.parametrize("lang", available_languages("check"))
def test_a_blank_of_nobody_has_room_for_a_name(lang: str) -> None:
    """Two lines to write on, beside the title; of a known student the name itself."""
    marks, _ = blank_marks(Asked(SIX, "velocity"), lang)
    rules = [m for m in marks if isinstance(m, Line) and m.layer == "text"]
    assert len(rules) == 2
    for (a, b), y in zip((r.points for r in rules), (SHEET_MM[1] - 15, SHEET_MM[1] - 22.5), strict=True):
        assert (b - a).imag == 0 and (b - a).real > 45 and y < a.imag and a.imag > SHEET_MM[1] - STRIP_MM
        assert b.real < code_centre().real - CODE_SIDE_MM / 2 - 3
    named = blank_marks(Asked(SIX, "velocity"), lang, mark=SheetMark("six-link", "", "Ким", "velocity"))[0]
    assert not [m for m in named if isinstance(m, Line) and m.layer == "text"]
    assert any("Ким" in m.text for m in named if isinstance(m, Text))


def test_what_the_scene_does_not_say_stands_on_the_blank() -> None:
    assert "Вариант Г." in said(Asked(TWELVE, "velocity"))
    assert any(re.search("140", text) for text in said(Asked(SIX, "velocity", 140.0)))
    own = replace(SIX, sheet={"student": "Ким Анна", "group": "М-31"})
    assert "Студент: Ким Анна, группа М-31." in said(Asked(own, "velocity"))


def test_a_pole_is_lettered_as_on_sheets_and_in_reports() -> None:
    poles = {plan: {"p", "π"} & {*said(Asked(SIX, plan))} for plan in ("velocity", "acceleration", "force:2-3")}
    assert poles == {"velocity": {"p"}, "acceleration": {"π"}, "force:2-3": {"p"}}


@pytest.mark.parametrize(("plan", "mu"), [("acceleration", 1.0), ("velocity", None)])
def test_a_pole_in_the_middle_tells_nobody_where_the_plan_goes(plan: str, mu: float | None) -> None:
    """The six-link's acceleration plan, 183 mm at the scene's μ, is drawn on its blank at half of that."""
    bench = plan_fitting_blank(prepare(Asked(SIX, plan)))
    assert bench.asked.mu == mu and SheetMark.from_asked(bench.asked).mu == mu
    middle, ends = complex(165, 105), [*bench.true_marks.values()]
    assert abs(blank_pole(bench) - middle) < 13
    if mu:  # turned any way it stays on the sheet, and away from what is printed above and below
        assert max(map(abs, ends)) < SHEET_MM[1] / 2 - 10
        assert any("= 1" in text for text in said(Asked(SIX, plan)))


@pytest.mark.parametrize(
    "title", ["слово " * 60, "Кулисный механизм поперечно-строгального станка с качающейся кулисой и ползуном"]
)
@pytest.mark.parametrize("student", ["", "Ким"])
def test_a_long_title_keeps_off_the_code_and_the_name(title: str, student: str) -> None:
    scene = replace(SIX, title={"ru": title.strip()})
    marks, _ = blank_marks(Asked(scene, "force:2-3"), "ru", mark=SheetMark("x", "", student, "force:2-3"))
    left = code_centre().real - CODE_SIDE_MM / 2
    rules = [m.points[0] for m in marks if isinstance(m, Line) and m.layer == "text"]
    for text in (m for m in marks if isinstance(m, Text) and m.turn_deg == 0):
        end = text.place.real + ink_width(text.text, text.height)
        if text.place.imag < 20:  # what is given, between the lower marks and off the plan
            assert end < SHEET_MM[0] - 21 - 2 and text.place.imag + text.height < 14
            continue
        assert end < left - 2
        if rules and text.place.real < 60:
            assert end < 162


def test_a_scene_of_forces_has_a_blank_without_being_asked_which(tmp_path: Path) -> None:
    file = tmp_path / "b.svg"
    assert main(["blank", str(ROOT / "samples/vectors/group.yaml"), "-o", str(file), "--lang", "en"]) == 0
    assert main(["blank", str(ROOT / "samples/six-link.yaml"), "-o", str(file), "--lang", "en"]) == 0
    assert "Velocity polygon" in file.read_text("utf-8")


@pytest.mark.slow
def test_a_name_written_on_a_blank_changes_nothing(tmp_path: Path) -> None:
    cv2 = pytest.importorskip("cv2")
    from tests.helpers.class_pictures import drawn, printed, scanned

    assert main(["blank", str(ROOT / "samples/six-link.yaml"), "-o", str(tmp_path / "b.pdf")]) == 0
    seen = drawn(printed(tmp_path / "b.pdf"), SIX, "velocity")
    for text, y in (("Kim A. Petrova", 120), ("M-31", 178)):
        cv2.putText(seen, text, (1460, y), cv2.FONT_HERSHEY_SCRIPT_SIMPLEX, 1.4, 80, 3, cv2.LINE_AA)
    cv2.imwrite(str(tmp_path / "b.png"), scanned(seen))
    asked = Asked(SIX, "velocity")
    assert check(asked, read_paper(str(tmp_path / "b.png"), asked, Known())).verdict == "right"


def test_a_blank_with_half_of_its_marks_says_what_to_do(tmp_path: Path) -> None:
    """Its right side was cut off by a camera or a printer."""
    cv2 = pytest.importorskip("cv2")
    from tests.helpers.class_pictures import printed

    assert main(["blank", str(ROOT / "samples/six-link.yaml"), "-o", str(tmp_path / "b.pdf")]) == 0
    cv2.imwrite(str(tmp_path / "b.png"), printed(tmp_path / "b.pdf")[:, :2150])
    asked = Asked(SIX, "velocity")
    with pytest.raises(PlanesError, match=r"Only 2 of the blank's four corner marks.*photograph the whole sheet"):
        read_paper(str(tmp_path / "b.png"), asked, Known())


@pytest.mark.slow
def test_a_sheet_whose_code_tells_another_plan_says_so(tmp_path: Path) -> None:
    cv2 = pytest.importorskip("cv2")
    from tests.helpers.class_pictures import printed

    assert main(["blank", str(ROOT / "samples/six-link.yaml"), "-o", str(tmp_path / "b.pdf")]) == 0
    cv2.imwrite(str(tmp_path / "b.png"), printed(tmp_path / "b.pdf"))
    notes = {
        plan: [n.told("en") for n in read_paper(str(tmp_path / "b.png"), Asked(SIX, plan), Known()).notes]
        for plan in ("velocity", "acceleration")
    }
    assert notes["acceleration"][0].startswith("The code on the sheet: it is the velocity polygon")
    assert not any("code" in note for note in notes["velocity"])
