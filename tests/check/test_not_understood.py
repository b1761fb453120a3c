"""What was not understood, not seen, or lies too near a dead point is never told to be right."""

import json
from dataclasses import replace
from pathlib import Path

import pytest

import planes
from planes.check.grading.by_hand import unreliable_rate_names
from planes.check.grading.paper import ReadMark, ReadPaper, read_table
from planes.check.grading.prepared_plan import Asked, prepare
from planes.check.outcome import Outcome, check
from planes.check.report import as_json, certainty_text
from planes.cli import main
from planes.drafting.instruments import Pencil
from planes.drafting.skill import DRAUGHTSMAN_SKILL, STUDENT_SKILL, cad_skill
from planes.drafting.tools import Tool
from planes.geometry.arithmetic import Arithmetic
from planes.solving import solve
from planes.words import say
from tests.helpers import ROOT

SIX = str(ROOT / "samples" / "six-link.yaml")
ASKED = Asked(planes.load(SIX), "velocity")


def of_results(*rows: tuple[str, float, str], skill: object = STUDENT_SKILL) -> Outcome:
    return check(Asked(ASKED.scene, "velocity", skill=skill), ReadPaper("t.csv", results=[*rows]))  # type: ignore[arg-type]


def of_marks(plan: str, *without: str) -> Outcome:
    """A right table of marks that leaves some out."""
    asked = Asked(ASKED.scene, plan)
    places = {"p": 0j, **prepare(asked).true_marks}
    return check(asked, ReadPaper("t.csv", [ReadMark(n, z) for n, z in places.items() if n not in without]))


def test_an_unknown_name_leaves_the_work_right_as_far_as_seen(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    found = of_results(("v_C", 2.404, "m/s"), ("F_99", 5.0, "N"))
    assert (found.verdict, found.unseen) == ("right_as_seen", ["F_99"])
    assert "F_99" in found.sentence.told("ru") and as_json(found)["unseen"] == ["F_99"]
    assert not certainty_text(found, "en")
    file = tmp_path / "t.csv"
    file.write_text("result,value,unit\nv_C,2.404,m/s\nF_99,5,N\n", encoding="utf-8")
    assert main(["check", SIX, str(file), "--plan", "velocity", "--json"]) == 3
    assert json.loads(capsys.readouterr().out)["verdict"] == "right_as_seen"


def test_a_wrong_number_of_the_frame_is_wrong_under_the_sheets_name() -> None:
    found = of_results(("F_36", 9999.0, "N"))
    assert found.verdict == "wrong" and found.first_wrong == "F_30"
    assert as_json(found)["sentence"]["en"].startswith("F_36 = 9999")
    assert found.text_as_typed("F_30 and F_21") == "F_36 and F_21"


def test_a_column_that_nobody_reads_is_told(tmp_path: Path) -> None:
    file = tmp_path / "t.csv"
    file.write_text("result,value,unit,direction\nv_C,2.404,m/s,77\n", encoding="utf-8")
    found = check(ASKED, read_table(file))
    assert (found.verdict, found.unseen) == ("right_as_seen", ["direction"])


@pytest.mark.parametrize(
    ("plan", "without", "unseen"),
    [
        ("velocity", (), []),
        ("velocity", ("c",), []),  # s2 stands on bc as S2 does on BC: it tells where c is
        ("velocity", ("h",), ["h"]),
        ("acceleration", ("n_CB",), ["n_CB"]),  # it may slide across BC, and c' stays
        ("acceleration", ("k_HL",), ["k_HL"]),
    ],
)
def test_a_mark_is_seen_in_its_followers_only_where_they_tell_its_place(
    plan: str, without: tuple[str, ...], unseen: list[str]
) -> None:
    found = of_marks(plan, *without)
    assert found.unseen == unseen, found.sentence.told("en")
    assert found.verdict == ("right_as_seen" if unseen else "right")


@pytest.mark.parametrize("skill", [STUDENT_SKILL, cad_skill(73.0)])
def test_a_number_too_near_a_dead_point_is_not_sure(skill: object) -> None:
    found = of_results(("v_H", 1.38, "m/s"), skill=skill)
    assert found.results and found.results.scored[0].verdict == "too_near"
    assert (found.verdict, found.unseen, found.mistake) == ("right_as_seen", ["v_H"], None)
    assert of_results(("v_H", 3.0, "m/s"), skill=skill).verdict == "wrong"


OFFSET = """
planes: 1
parameters: {mm: 0.001, rpm: pi/30}
frame: {points: {A: [0, 0]}, guides: {x-x: {y: -20*mm}}}
links:
  1: {points: {A: 0, B: 80*mm}}
  2: {points: {B: 0, C: 260*mm}}
  3: {points: {C: 0}, slides: x-x}
assembly: {C: ahead}
drive: {link: 1, phi: 60, omega: 600*rpm}
"""


@pytest.mark.parametrize("share", [0.7, 0.8, 1.25, 1.37])
def test_what_no_hand_errs_by_is_wrong_however_large_its_tolerance(share: float) -> None:
    """An offset slider-crank whose a_C has a tolerance of 16.5 %: lines that cross at 70 degrees."""
    scene = planes.loads(OFFSET)
    true, asked = abs(planes.solve(scene).value("a_C")), Asked(scene, "acceleration")
    assert check(asked, ReadPaper("t", results=[("a_C", share * true, "m/s^2")])).verdict == "wrong"
    assert check(asked, ReadPaper("t", results=[("a_C", 1.1 * true, "m/s^2")])).verdict == "right_as_seen"


def test_sheet_note_and_check_tell_the_same_of_a_number_near_a_dead_point(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    names = list(unreliable_rate_names(solve(ASKED.scene).positions[0]))
    assert "v_H" in names and "v_C" not in names
    assert main(["sheet", SIX, "-o", str(tmp_path / "s.svg"), "--lang", "en"]) == 0
    told = next(line for line in capsys.readouterr().err.splitlines() if "a sixth of their value" in line)
    said = told.split(": ")[1].split(", ")
    assert len(said) == len(names) and {"v_H", "a_C"} <= set(said) and "v_C" not in said
    assert main(["note", SIX, "-o", str(tmp_path / "n.html"), "--lang", "en"]) == 0
    assert "a sixth of their value" in (tmp_path / "n.html").read_text(encoding="utf-8")


def test_one_place_holds_the_errors_of_people() -> None:
    assert (Pencil().point_mm, Pencil().ray_deg) == (DRAUGHTSMAN_SKILL.point_mm, DRAUGHTSMAN_SKILL.ray_deg)
    assert Asked(ASKED.scene, "velocity").skill is STUDENT_SKILL


def test_a_number_in_an_unknown_unit_or_left_empty_is_not_seen(tmp_path: Path) -> None:
    file = tmp_path / "results.csv"
    file.write_text("result,value,unit\nv_C,2.4,furlong\nomega_2,,rad/s\nomega_3,-16.0,1/s\n", "utf-8")
    found = check(ASKED, read_table(file))
    assert found.verdict == "right_as_seen" and set(found.unseen) == {"v_C", "omega_2"}
    assert "furlong" in " ".join(note.told("en") for note in found.notes)
    far = 1e3 * abs(solve(ASKED.scene).positions[0].value("r_C"))
    file.write_text(f"result,value,unit\nomega_3,-153,rpm\nv_C,2404,мм/с\nF_21,9.87,kN\nr_C,{far},мм\n", "utf-8")
    assert check(ASKED, read_table(file)).verdict == "right"


UNITS = ("m/s", "m/s²", "rad/s", "rad/s²", "N", "N·m", "W", "kg")


@pytest.mark.parametrize("name", ["v_C", "a_C", "omega_3", "epsilon_3", "F_21", "M_1", "phi_3"])
def test_a_number_in_the_unit_of_another_quantity_is_not_seen(name: str) -> None:
    position = solve(ASKED.scene).positions[0]
    asked = next(f for f in position.found if f.quantity.name == name)
    true, own = asked.number if name[0] in "oeMp" else abs(asked.vector), asked.quantity.columns[0].unit
    for unit in UNITS:
        found = check(ASKED, ReadPaper("t", results=[("v_B", 2.0, "m/s"), (name, true, unit)]))
        assert found.verdict == ("right" if unit == own else "right_as_seen"), unit
        assert found.unseen == ([] if unit == own else [name])
        assert unit == own or say(own, "en") in " ".join(note.told("en") for note in found.notes)


def test_who_hits_all_other_numbers_within_a_hair_has_no_shaky_hand() -> None:
    """A number 3.06 σ off among five that are exact, and among five that are up to one σ off."""
    scene = planes.loads(OFFSET)
    position, asked = planes.solve(scene), Asked(scene, "acceleration")
    true = {n: position.value(n) for n in ("omega_2", "epsilon_2")}
    true |= {n: abs(position.value(n)) for n in ("v_B", "v_C", "a_B", "a_C")}
    chances = []
    for share in (1.0, 1.01):
        others = [(n, share * x, "") for n, x in true.items() if n != "a_C"]
        found = check(asked, ReadPaper("t", results=[*others, ("a_C", 1.2 * true["a_C"], "")]))
        assert found.verdict == "wrong" and found.first_wrong == "a_C"
        chances.append(found.chance)
    assert chances[0] > 0.9 > chances[1]


CRANK = """
planes: 1
frame: {points: {O: [0, 0]}, guides: {x-x: {y: 0}}}
links:
  1: {points: {O: 0, A: 0.1}}
  2: {points: {A: 0, B: 0.35, C: 0.12}}
  3: {points: {B: 0}, slides: x-x}
assembly: {B: ahead}
drive: {link: 1, phi: 60, omega: 20}
"""


@pytest.mark.parametrize(
    ("rows", "options", "status", "said"),
    [
        ("v_B,1.987", (), 3, "not in the table: omega_2, epsilon_2, a_B, M_1."),
        ("v_B,1.987", ("--plan", "velocity"), 3, "not in the table: omega_2."),
        ("v_B,1.987\nomega_2,-2.95", ("--plan", "velocity"), 0, "The results are right. (Sure.)"),
        ("v_B,1.99\nomega_2,-2.95\nepsilon_2,99.9\na_B,14.3\nM_1,0", (), 0, "The results are right. (Sure.)"),
        ("v_B,1.99\nomega_2,-2.95\nepsilon_2,99.9\na_B,14.3\nM_1,0\nv_D,1", (), 3, "not known: v_D (did you mean v_"),
        ("v_B,1.99\nomega_2,-2.95\nF_99,5", ("--plan", "velocity"), 3, "not known: F_99"),
    ],
)
def test_results_are_right_where_none_is_left_out(
    rows: str, options: tuple[str, ...], status: int, said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """What is not in a table, and what means nothing here, are said apart from what cannot be judged."""
    scene, table = tmp_path / "crank.yaml", tmp_path / "t.csv"
    scene.write_text(CRANK, "utf-8")
    table.write_text(f"result,value\n{rows}\n", "utf-8")
    assert main(["check", str(scene), str(table), *options, "--lang", "en"]) == status
    told = capsys.readouterr().out
    assert said in told and "not judged" not in told


@pytest.mark.parametrize(
    ("results", "mistake", "words"),
    [
        ({"a_B": 11.1, "a_C": 28.4, "epsilon_2": 102.2}, "normal_missing", "n_BA: the normal acceleration is left out"),
        ({"a_B": 3.14, "a_C": 1.08, "epsilon_2": -2.22}, "normal_missing", "n_A: the normal acceleration is left out"),
        ({"a_B": 8.01, "a_C": 27.8, "epsilon_2": 104.0}, "normal_outward", "n_BA: the normal acceleration points away"),
        ({"v_B": 1.03, "v_C": 1.45, "omega_2": 1.41}, "relative_from_pole", "b: the line of the relative velocity"),
        ({"a_B": 20.9, "a_C": 29.05, "epsilon_2": 99.9}, None, "a_B = 20.9, but 14.29 is right; the cause is unclear"),
    ],
)
@pytest.mark.parametrize("plan", ["position", "velocity", "acceleration"])
def test_results_alone_tell_the_mistake_and_its_step_whichever_plan_is_named(
    plan: str, results: dict[str, float], mistake: str | None, words: str
) -> None:
    rows = [(name, value, "") for name, value in results.items()]
    found = check(Asked(planes.loads(CRANK), plan), ReadPaper("t", results=rows))
    assert (found.verdict, found.mistake) == ("wrong", mistake) and found.sentence.told("en").startswith(words)


def test_an_answer_that_is_asked_and_missing_is_not_seen() -> None:
    whole = replace(ASKED, answers=("v_C", "omega_2", "omega_3"))
    rows = [("v_C", 2.404, "m/s"), ("omega_2", 8.12, "")]
    assert check(whole, ReadPaper("t.csv", results=rows)).unseen == ["omega_3"]
    assert check(whole, ReadPaper("t.csv", results=[*rows, ("ω_3", -16.03, "")])).verdict == "right"


def test_tables_of_answers_of_a_class_need_no_plan(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name, value in (("anna", 8.12), ("boris", 24.4)):
        (tmp_path / f"{name}.csv").write_text(f"result,value\nv_C,2.404\nomega_2,{value}\n", "utf-8")
    assert main(["check", str(ROOT / "samples" / "six-link.yaml"), str(tmp_path), "--lang", "en"]) == 1
    said = capsys.readouterr().out
    assert "omega_2" in said and "unreadable" not in said and "velocity" not in said


def test_marks_of_another_plan_are_not_judged_as_of_this_one(tmp_path: Path) -> None:
    scene = planes.loads(CRANK)
    marks = {"p": 0j, **prepare(Asked(scene, "acceleration")).true_marks}
    paper = ReadPaper("t.csv", [ReadMark(n, z) for n, z in marks.items()])
    found = check(Asked(scene, "velocity"), paper)
    assert (found.verdict, found.sentence.key) == ("unreadable", "check_of_another_plan")
    assert found.sentence.told("en").endswith("write --plan acceleration.")
    assert check(Asked(scene, "acceleration"), paper).verdict == "right"


def test_a_mark_that_follows_from_a_mistake_does_not_miss_where_that_puts_it() -> None:
    """The mark at which the mistake is made may not be drawn: what follows is off the right construction."""
    bench = prepare(Asked(planes.loads(CRANK), "acceleration"))
    for variant in bench.mistakes:
        things = bench.draw_program(variant, Tool(Arithmetic()))
        drawn = {n: complex(things[f"acceleration:{n}"]) for n in bench.true_marks if things and n != variant.blames}
        found = check(bench.asked, ReadPaper("t", [ReadMark(n, z) for n, z in {"p": 0j, **drawn}.items()]))
        for row in as_json(found)["marks"] if found.verdict != "unreadable" else []:
            if row["verdict"] == "follows":
                assert row["own_deviation_mm"] <= row["own_tolerance_mm"], (variant.mistake, row)
