"""A course: its folder read and refused in words, numbers drawn, given out, kept in a ledger."""

from __future__ import annotations

import json
import math
import platform
import re
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path

import numpy
import pytest

from planes.course import ParameterChoice, ledger, workers
from planes.course import random_numbers as numbers
from planes.course.ledger import Ledger, contents_hash
from planes.course.numbers import main_answers, scene_text_with_numbers, settle_numbers, worker_question
from planes.course.papers import clearest_driver_angle, work_sentences
from planes.course.quiz import quiz_items
from planes.course.random_numbers import draw_numbers, parameter_choices, round_numbers_near, seeded_generator
from planes.course.reading import read_course
from planes.course.students import shares_of_course
from planes.documents.course_run import conduct_course
from planes.drafting.drawing import draw_program
from planes.plans import plans_of
from planes.plans.scales import unit_scales_of_plans
from planes.scene import Scene, load, loads
from planes.solving import solve
from planes.words.errors import PlanesError
from tests.helpers import ROOT

SAMPLES = ROOT / "samples"
TWELVE = SAMPLES / "assignments" / "12.yaml"
Make = Callable[..., Path]


@pytest.fixture
def folder(tmp_path: Path) -> Make:
    """A folder of a course."""

    def make(course: str = "", students: str = "Иванов\nПетров\n", scenes: tuple[str, ...] = ("12",)) -> Path:
        for name in scenes:
            text = (SAMPLES / "assignments" / f"{name}.yaml").read_text("utf-8")
            (tmp_path / f"{name}.yaml").write_text(text, "utf-8")
        if students:
            (tmp_path / "students.txt").write_text(students, "utf-8")
        if course:
            (tmp_path / "course.yaml").write_text(course, "utf-8")
        return tmp_path

    return make


# the folder


def test_names_and_scenes_alone_make_a_course(folder: Make) -> None:
    course = read_course(folder(students="# осень\nИванов И. И.\n\nПетров  # староста\n"))
    assert [(s.name, s.line) for s in course.students] == [("Иванов И. И.", 2), ("Петров", 4)]
    assert [a.name for a in course.assignments] == ["12"]
    assert course.documents == ("task", "blank", "key", "sheets", "lesson") and course.sharpness_deg == 15


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "cp1251"])
def test_a_table_of_students(folder: Make, encoding: str) -> None:
    at = folder(students="", scenes=("03", "12"))
    (at / "students.csv").write_text("№;ФИО;Группа;Задание;Вариант\n1;Иванов;М-1;3;Б\n2;Петров;;;\n", encoding)
    first, second = read_course(at).students
    assert (first.name, first.group, first.assignment, first.variant) == ("Иванов", "М-1", "3", "Б")
    assert (second.name, second.group, second.assignment, second.variant) == ("Петров", "", None, None)
    given = shares_of_course(read_course(at))
    assert [(s.assignment.name, s.variant) for s in given] == [("03", "Б"), ("12", "А")]


def test_the_sample_course() -> None:
    course = read_course(SAMPLES / "course")
    given = shares_of_course(course)
    assert [(s.assignment.name, s.variant) for s in given] == [
        ("12", "А"),
        ("26", "А"),
        ("12", "Г"),
        ("12", "Б"),
        ("26", "Б"),
        ("43", "А"),
        ("26", "В"),
    ]
    assert course.draw and course.draw["F_5"].values[0] == "500" and course.draw["l_AB"].percent == 10


REFUSED = [
    ("course: 2\n", "", r"course\.yaml:1: .*format \"2\""),
    ("title: x\n", "", r"course\.yaml:1: .*course"),
    ("course: 1\nstudent: [A]\n", "", r"course\.yaml:2: .*student.*students"),
    ("course: 1\ndocuments: [task, sheet]\n", "", r"course\.yaml:2: .*sheet.*sheets"),
    ("course: 1\ndraw: {l_XY: 10 %}\n", "", r"course\.yaml:2: .*l_XY.*l_AB"),
    ("course: 1\ndraw: {omega: 20 %}\n", "", r"course\.yaml:2: .*name the number .*'drive: {omega: omega_1}'; .*\?$"),
    ("course: 1\ndraw: {l_AB: some}\n", "", r"course\.yaml:2: .*some"),
    ("course: 1\ndraw: {l_AB: {from: 1, to: 2, step: 0}}\n", "", r"course\.yaml:2: .*step"),
    ("course: 1\nsharpness: 90\n", "", r"course\.yaml:2: .*90"),
    ("course: 1\neach: 1.5\n", "", r"course\.yaml:2: .*1\.5"),
    ("course: 1\nseed: -1\n", "", r"course\.yaml:2: .*-1"),
    ("course: 1\nassignments: [none.yaml]\n", "", r'yaml:2: entry 1 of assignments: there is no "none\.yaml"; '),
    ("course: 1\nstudents: [{group: М}]\n", "", r"course\.yaml:2: .*name"),
    ("course: 1\nstudents: [{name: A, assignment: 13}]\n", "", r"course\.yaml:2: .*\"13\".*12"),
    ("course: 1\nstudents: [{name: A, variant: Ж}]\n", "", r"course\.yaml:2: .*Ж.*А, Б"),
    ("course: 1\nsheet: {grup: М}\n", "", r"course\.yaml:2: .*grup.*group"),
    ("", "А\nБ\nА\n", r"students\.txt:3: .*\"А\".*line 1"),
    ('course: 1\nstudents: ["A\\u2028B"]\n', "", r'course\.yaml:2: the name "A\\u2028B" contains'),
    ("", "# никого\n", r"students\.txt: nobody"),
]


@pytest.mark.parametrize(("course", "students", "told"), REFUSED)
def test_what_cannot_be_meant_is_one_sentence(folder: Make, course: str, students: str, told: str) -> None:
    with pytest.raises(PlanesError) as caught:
        read_course(folder(course, students or "Иванов\n"))
    english, russian = caught.value.told("en"), caught.value.told("ru")
    assert "\n" not in english and english != russian
    assert re.search(told, english), english


def test_a_scene_that_does_not_read_is_refused_at_once(folder: Make) -> None:
    at = folder()
    (at / "13.yaml").write_text("planes: 1\nframe: {}\n", "utf-8")
    with pytest.raises(PlanesError, match=r"13\.yaml:1: "):
        read_course(at)


# who gets what


def test_variants_go_round_and_then_numbers_are_drawn(folder: Make) -> None:
    names = "\n".join(f"Студент {k}" for k in range(9))
    given = shares_of_course(read_course(folder(students=names)))
    assert [s.variant for s in given] == ["А", "Б", "В", "Г", "Д", "Е", None, None, None]
    assert len({s.place for s in given}) == 9


def test_assignments_go_in_turn_and_several_to_each(folder: Make) -> None:
    at = folder("course: 1\neach: 2\nvariants: drawn\n", "А\nБ\n", ("03", "12", "26"))
    given = shares_of_course(read_course(at))
    assert [(s.place, s.variant) for s in given] == [("А/03", None), ("А/12", None), ("Б/12", None), ("Б/26", None)]


def test_folders_never_fall_together(folder: Make) -> None:
    course = "course: 1\nstudents: [Ли А., 'Ли, А', {name: ли а, group: М-2}, '...', '../..', А/Б, " + "Я" * 90 + "]\n"
    places = [s.place for s in shares_of_course(read_course(folder(course)))]
    assert places == ["Ли-А", "Ли-А-2", "ли-а-М-2", "student-4", "student-5", "А-Б", "Я" * 40]


def test_folders_have_no_names_of_devices(folder: Make) -> None:
    course = "course: 1\nstudents: [CON, con, {name: nul, group: М-2}, LPT1, 'aux.', com¹, Conrad, COM10]\n"
    places = [s.place for s in shares_of_course(read_course(folder(course)))]
    assert places == ["CON-2", "con-3", "nul-М-2", "LPT1-2", "aux-2", "com¹-2", "Conrad", "COM10"]


def test_what_files_are_made_by_tells_python_and_the_libraries(monkeypatch: pytest.MonkeyPatch) -> None:
    made = ledger.library_versions()
    assert made["python"].split() == [platform.python_implementation(), platform.python_version()]
    assert made["numpy"] == numpy.__version__ and "-" not in made.values()
    whole = {ledger.program_fingerprint.__wrapped__()}
    for name in ("python", "numpy"):
        monkeypatch.setattr(ledger, "library_versions", lambda other=name: made | {other: "0"})
        whole.add(ledger.program_fingerprint.__wrapped__())
    assert len(whole) == 3


# numbers


def test_round_numbers_around_one() -> None:
    assert round_numbers_near(0.1, 10) == ("0.09", "0.095", "0.1", "0.105", "0.11")
    assert round_numbers_near(-0.35, 10) == ("-0.38", "-0.37", "-0.36", "-0.35", "-0.34", "-0.33", "-0.32")
    assert round_numbers_near(2000, 20) == ("1600", "1800", "2000", "2200", "2400")
    for k in range(1, 400):
        values = [float(v) for v in round_numbers_near(k / 37, 10)]
        assert len(values) >= 4 and all(abs(v - k / 37) <= 0.1000001 * k / 37 for v in values)


def test_chance_depends_on_seed_and_names_alone() -> None:
    assert seeded_generator(1, "Иванов", "12").random() == 0.5402874308650616
    assert len({seeded_generator(s, n).random() for s in (1, 2) for n in ("Иванов", "Петров")}) == 4


def test_drawn_numbers_assemble_all_round_and_meet_sharply(folder: Make) -> None:
    """Every plan, every degree, drawn one by one: a check of its own for what the program tries with arrays."""
    at = folder("course: 1\nvariants: drawn\nsharpness: 40\n", scenes=("43",))
    course = read_course(at)
    for share in shares_of_course(course):
        scene = loads(settle_numbers(worker_question(course, share, "en")).scene)
        assert scene.mechanism
        plans = plans_of(scene.mechanism)
        for phi in range(0, 360, 5):
            drawn = draw_program(
                plans.program, {**plans.given, **unit_scales_of_plans(plans), plans.drive_given_name: float(phi)}
            )
            assert min(drawn.crossing_sharpness.values()) >= math.sin(math.radians(40)) - 1e-3
        base = load(at / "43.yaml").parameters
        moved = {k: v for k, v in scene.parameters.items() if v != base[k]}
        assert moved and all(abs(v - base[k]) <= 0.2001 * abs(base[k]) for k, v in moved.items() if k != "phi_1")


@pytest.mark.slow
def test_numbers_are_ones_own_whoever_else_is_there(folder: Make) -> None:
    few = read_course(folder("course: 1\nvariants: drawn\n", "Иванов\nПетров\n"))
    many = read_course(folder("course: 1\nvariants: drawn\n", "Абрамов\nИванов\nКим\nПетров\n"))
    told = [
        {s.student.name: settle_numbers(worker_question(c, s, "en")).scene for s in shares_of_course(c)}
        for c in (few, many)
    ]
    assert told[0].items() <= told[1].items() and len(set(told[1].values())) == 4
    question_again = replace(worker_question(few, shares_of_course(few)[0], "en"), copy=1)
    assert settle_numbers(question_again).scene not in told[1].values()


def test_nobody_has_the_plans_that_are_asked_as_somebody_else_has_them(folder: Make, tmp_path: Path) -> None:
    """Where the load alone differs, plans of velocities and accelerations are the same."""
    text = "course: 1\nvariants: drawn\nplans: [velocity, acceleration]\ndraw: {F_5: 20 %, omega_1: [14, 15, 16, 17]}\n"
    course = replace(read_course(folder(text, "А\nБ\nВ\n")), documents=())
    made = conduct_course(course, tmp_path / "out", workers._run_without_workers, "en")
    own = [load(file).parameters["omega_1"] for file in (tmp_path / "out").rglob("scene.yaml")]
    assert not made.faults and not made.said and len(set(own)) == len(own) == 3


@pytest.mark.parametrize("plans", [("velocity", "acceleration"), ("velocity",), ("velocity", "acceleration", "force")])
def test_a_task_and_questions_ask_what_is_asked(plans: tuple[str, ...]) -> None:
    scene = load(SAMPLES / "six-link.yaml")
    here = solve(scene).positions[0]
    asked = " ".join(work_sentences(scene, here, "en", plans))
    names = " ".join(one.name for one in quiz_items(scene, "en", plans))
    for plan, words, name in (
        ("velocity", "elocit", "omega_"),
        ("acceleration", "ccelerat", "epsilon_"),
        ("force", "Force polygons", "M_1"),
        ("force", "Zhukovsky", "M_1"),
    ):
        assert (words in asked) == (name in names) == (plan in plans), (plan, asked, names)


@pytest.mark.slow
def test_where_no_numbers_will_do_it_is_said_why(folder: Make, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(numbers, "MOST_TRIED_SETS", 100)
    course = read_course(folder("course: 1\nvariants: drawn\nsharpness: 89\ndraw: {l_BC: 1 %}\n", scenes=("03",)))
    fault = settle_numbers(worker_question(course, shares_of_course(course)[0], "en")).fault
    assert (
        fault.startswith("none of 100 sets of numbers can be used: 0 do not assemble") and "in 100 lines meet" in fault
    )
    course = read_course(folder("course: 1\nvariants: drawn\ndraw: {l_OA: [50]}\n", scenes=("66",)))
    share = next(s for s in shares_of_course(course) if s.assignment.name == "66")
    assert "100 do not assemble all the way round" in settle_numbers(worker_question(course, share, "en")).fault


@pytest.mark.parametrize("name", ["01", "12", "26", "45", "66"])
def test_the_shown_scheme_is_in_another_position(name: str) -> None:
    """At least 30° away, one that assembles, and no rod in line with its crank."""
    scene = load(SAMPLES / "assignments" / f"{name}.yaml")
    assert scene.mechanism
    for asked in (0.0, 100.0, 200.0):
        shown = clearest_driver_angle(plans_of(scene.mechanism), asked)
        assert abs((shown - asked + 180) % 360 - 180) >= 30
        links = solve(scene, [shown]).positions[0].results["links"]
        assert abs(math.sin(math.radians(links["1"]["angle_deg"] - links["2"]["angle_deg"]))) > 0.2


def test_draw_numbers_takes_the_first_that_works() -> None:
    tried: list[str] = []

    def make(numbers: object) -> Scene:
        assert isinstance(numbers, dict)
        tried.append(numbers.get("l_AB", ""))
        return loads(scene_text_with_numbers(TWELVE.read_text("utf-8"), "12.yaml", None, numbers, {}))

    found = draw_numbers({"l_AB": ("0.9", "0.1")}, make, 15.0, seeded_generator(1, "x"))
    assert found == {"l_AB": "0.1"} == {"l_AB": tried[-1]} and set(tried[:-1]) <= {"", "0.9"}


def test_a_mechanism_that_swings_only_is_drawn_numbers_for_too() -> None:
    """The six-link stands between 129.5° and 305.8° alone: each student's own position must be one that works."""
    text = (SAMPLES / "six-link.yaml").read_text("utf-8")

    def make(numbers: Mapping[str, str]) -> Scene:
        return loads(scene_text_with_numbers(text, "six-link.yaml", None, numbers, {}))

    found = draw_numbers(parameter_choices(text, "six-link.yaml", None), make, 15.0, seeded_generator(1, "x"))
    assert 129 < float(found["phi_1"]) < 306 and len(solve(make(found)).positions) == 1


# scenes


@pytest.mark.few(3)
@pytest.mark.parametrize("path", sorted((SAMPLES / "assignments").glob("*.yaml"))[::4], ids=lambda p: p.stem)
def test_a_scene_written_anew_is_the_same(path: Path) -> None:
    text = path.read_text("utf-8")
    again = loads(scene_text_with_numbers(text, str(path), "В", {}, {}))
    scene = load(path, "В")
    assert again.mechanism == scene.mechanism and again.parameters == scene.parameters
    assert again.title == scene.title and again.note == scene.note and again.missing == scene.missing


@pytest.mark.few(3)
@pytest.mark.parametrize("path", sorted(SAMPLES.glob("*.yaml")), ids=lambda p: p.stem)
def test_every_sample_written_anew_is_the_same(path: Path) -> None:
    text = path.read_text("utf-8")
    scene, again = load(path), loads(scene_text_with_numbers(text, str(path), None, {}, {}), str(path))
    for name in ("mechanism", "parameters", "title", "statement", "mu", "find", "sheet", "frame_number"):
        assert getattr(again, name) == getattr(scene, name), name


def test_parameters_that_are_used() -> None:
    path = SAMPLES / "assignments" / "28.yaml"
    names = load(path).used
    assert "m_5" not in names and {"l_AB", "x_D", "J_S3", "M_3", "phi_1"} <= {*names}


def test_what_is_drawn_when_nothing_is_said() -> None:
    found = parameter_choices(TWELVE.read_text("utf-8"), "12.yaml", None)
    assert len(found["phi_1"]) == 24 and "m_1" not in found and "epsilon_1" not in found
    assert found["omega_1"] == ("13", "14", "15", "16", "17", "18", "19")
    only = parameter_choices(TWELVE.read_text("utf-8"), "12.yaml", {"l_AB": ParameterChoice(("0.1",))})
    assert only == {"l_AB": ("0.1",)}


def test_main_answers_are_those_of_the_solution() -> None:
    scene = load(TWELVE, "Б")
    key = solve(scene).json()
    found = {name: value for (name, _), value in main_answers(scene, key).items()}
    at = key["positions"][0]
    assert list(found) == ["omega_3", "epsilon_3", "v_E", "a_E", "M_1"]
    assert found["omega_3"] == at["links"]["3"]["omega"] and found["M_1"] == at["balancing_moment"]
    assert found["v_E"] == math.hypot(*at["points"]["E"]["v"])


# the ledger


def test_a_ledger_keeps_verifies_and_forgets(tmp_path: Path) -> None:
    first = Ledger(tmp_path)
    first.write_file("a/x.txt", "from 1", b"one")
    first.write_file("b/y.txt", "from 2", b"two")
    first.write_manifest(["a/x.txt", "b/y.txt"])
    assert not list(tmp_path.rglob(".*"))
    second = Ledger(tmp_path)
    assert second.is_up_to_date("a/x.txt", "from 1") and not second.is_up_to_date("a/x.txt", "from 3")
    (tmp_path / "b/y.txt").write_bytes(b"other")
    assert not second.is_up_to_date("b/y.txt", "from 2") and not second.is_up_to_date("c", "")
    second.write_manifest(["b/y.txt"])
    assert not (tmp_path / "a").exists() and (tmp_path / "b/y.txt").read_bytes() == b"other"


def test_a_torn_journal_and_a_begun_file_do_no_harm(tmp_path: Path) -> None:
    cut = Ledger(tmp_path)
    cut.write_file("x.txt", "from", b"whole")
    cut.write_file("y.txt", "from", b"whole too")
    cut.journal.close()
    lines = (tmp_path / ".journal").read_text("utf-8").splitlines()
    (tmp_path / ".journal").write_text("\n".join(lines)[:-9], "utf-8")
    (tmp_path / ".journal.part").write_bytes(b"ha")
    after = Ledger(tmp_path)
    assert after.is_up_to_date("x.txt", "from") and not after.is_up_to_date("y.txt", "from")
    after.write_file("y.txt", "from", b"whole too")
    after.write_manifest()
    assert sorted(p.name for p in tmp_path.iterdir()) == ["manifest.json", "x.txt", "y.txt"]
    files = json.loads((tmp_path / "manifest.json").read_text("utf-8"))["files"]
    assert files["y.txt"] == {"from": "from", "sha256": contents_hash(b"whole too")}


@pytest.mark.parametrize("text", ["", "[]", '{"files": 3}', '{"files": {"x": 1}}', "{", "[" * 100_000])
def test_a_spoilt_manifest_is_no_manifest(tmp_path: Path, text: str) -> None:
    (tmp_path / "manifest.json").write_text(text, "utf-8")
    ledger = Ledger(tmp_path)
    assert not ledger.is_up_to_date("x", "")
    ledger.write_manifest()


def test_a_manifest_that_names_files_elsewhere_harms_none(tmp_path: Path) -> None:
    """Up, from the root, over a link of a folder: what lies outside is not ours, whoever wrote the manifest."""
    out, other = tmp_path / "out", tmp_path / "other"
    for folder in (out, other):
        folder.mkdir()
        (folder / "x.txt").write_bytes(b"mine")
    (out / "linked").symlink_to(other, target_is_directory=True)
    (out / "alone.txt").symlink_to(other / "x.txt")
    ours = {"from": "f", "sha256": contents_hash(b"mine")}
    far = ["../other/x.txt", str(other / "x.txt"), "linked/x.txt", "linked/../x.txt", "", ".", "..", "a\0b"]
    names = [*far, "alone.txt"]
    (out / "manifest.json").write_text(json.dumps({"files": dict.fromkeys([*names, "x.txt"], ours)}), "utf-8")
    (out / ".journal").write_text("".join(json.dumps({"name": n, **ours}) + "\n" for n in names), "utf-8")
    ledger = Ledger(out)
    assert ledger.entries.keys() == {"x.txt", "alone.txt"}
    for name in ("../new.txt", str(other / "new.txt"), "linked/new.txt", "a\0b"):
        with pytest.raises(PlanesError, match="leads out of the folder"):
            ledger.write_file(name, "from", b"new")
    ledger.write_manifest([])
    assert sorted(p.name for p in tmp_path.rglob("*")) == ["linked", "manifest.json", "other", "out", "x.txt"]
    assert (other / "x.txt").read_bytes() == b"mine" and not (out / "x.txt").exists()


def test_what_a_person_keeps_in_the_folder_stays(tmp_path: Path) -> None:
    """Only our own draft is swept; a link of the journal's name is not written through."""
    out, diary = tmp_path / "out", tmp_path / "diary"
    (out / "deep").mkdir(parents=True)
    for name in (".download.part", "deep/.x.txt.part", ".journal.part"):
        (out / name).write_bytes(b"ha")
    Ledger(out).write_manifest()
    assert sorted(p.name for p in out.rglob("*")) == [".download.part", ".x.txt.part", "deep", "manifest.json"]
    diary.write_bytes(b"mine")
    (out / ".journal.part").symlink_to(diary)
    ledger = Ledger(out)
    ledger.write_file("x.txt", "from", b"new")
    ledger.write_manifest()
    (out / ".journal").symlink_to(diary)
    with pytest.raises(PlanesError, match="cannot be written"):
        Ledger(out)
    assert diary.read_bytes() == b"mine"


def test_two_runs_do_not_write_into_one_folder(tmp_path: Path) -> None:
    pytest.importorskip("fcntl")
    first = Ledger(tmp_path)
    with pytest.raises(PlanesError, match="another run is writing"):
        Ledger(tmp_path)
    first.write_manifest()
    Ledger(tmp_path).write_manifest()
