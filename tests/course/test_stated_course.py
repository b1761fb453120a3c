"""Scenes of stated vectors given out: own numbers, a task that gives nothing away, answers, questions, one sheet."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from planes.course.numbers import draw_student_numbers, main_answers, settle_numbers, worker_question
from planes.course.papers import amount_formulas, stated_equation_blocks
from planes.course.quiz import quiz_items
from planes.course.reading import read_course
from planes.course.students import shares_of_course
from planes.documents.course import Desk, Order, files_of_scene, folders_by_file_name
from planes.scene import load, loads
from planes.solving import solve
from tests.helpers import ROOT

VECTORS = ROOT / "samples" / "vectors"


@pytest.fixture
def share(tmp_path: Path) -> tuple:  # type: ignore[type-arg]
    (tmp_path / "friction.yaml").write_text((VECTORS / "friction.yaml").read_text("utf-8"), "utf-8")
    (tmp_path / "students.txt").write_text("Иванов\nПетров\n", "utf-8")
    course = read_course(tmp_path)
    return course, shares_of_course(course)


def test_everybody_has_other_numbers_and_their_answers(share: tuple) -> None:  # type: ignore[type-arg]
    course, given = share
    asked = [worker_question(course, s, "ru") for s in given]
    one, two = map(draw_student_numbers, asked)
    assert set(one) == {"l_OA", "l_AB", "omega_1"} and one != two
    held = settle_numbers(asked[0])
    scene = loads(held.scene, "scene.yaml")
    found = main_answers(scene, json.loads(held.key))
    l_oa, l_ab, f = (scene.parameters[k] for k in ("l_OA", "l_AB", "f"))
    tangent = (l_oa / l_ab) / (1 - (l_oa / l_ab) ** 2) ** 0.5
    normal = 3000 * tangent / (1 - f * tangent)  # N of P + T + F = 0, the rod at -asin(OA/AB)
    assert found["N_30", "N"] == pytest.approx(normal, rel=1e-12)
    assert found["P_T", "W"] == pytest.approx(-f * normal * scene.parameters["omega_1"] * l_oa, rel=1e-12)
    assert "P_3" not in {name for name, _ in found}


def test_a_task_says_equations_and_amounts_but_no_answer() -> None:
    scene = load(VECTORS / "six-link.yaml")
    here = solve(scene).positions[0]
    told = " ".join(b.text for b in stated_equation_blocks(scene, here, "ru") if hasattr(b, "text"))
    assert "⟨a_CB^n⟩ = ⟨v_CB⟩^2/⟨l_BC⟩" in told and "⟨v_CB⟩ ⊥ ⟨r_BC⟩" in told and "⟨omega_2⟩" in told
    assert scene.statement and "⟨r_AD⟩" not in " ".join(amount_formulas(scene.statement)).split("=")[0]


def test_questions_have_a_tolerance() -> None:
    asked = {q.name: q for q in quiz_items(load(VECTORS / "friction.yaml"), "ru")}
    assert asked["F_21"].value == pytest.approx(3200.352, abs=1e-3)
    assert asked["P_T"].unit == "W" and 0 < asked["P_T"].tolerance < 80  # T_30 is 4.5 mm long


@pytest.mark.slow
def test_every_document_of_stated_vectors_is_made(share: tuple) -> None:  # type: ignore[type-arg]
    course, given = share
    held = settle_numbers(worker_question(course, given[0], "ru"))
    names = folders_by_file_name(course) | {"note.pdf": "teacher", "quiz.json": "teacher", "scorm.zip": "teacher"}
    files = files_of_scene(names, loads(held.scene, "scene.yaml"))
    assert "sheet-1.pdf" in files and "sheet-2.pdf" not in files
    desk = Desk(Order(held.scene, ("a", "", "b"), files, ("force",), "ru", ("friction", "", "Иванов")))
    assert all(desk.file_contents(name)[0] for name in files)
