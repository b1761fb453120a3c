"""Every task can be solved from its paper: a scene rebuilt from the words and numbers a student has gives the answers
of the key, for every template, sample and assignment; from a platform's question too."""

from __future__ import annotations

import html
import io
import json
import re
import zipfile
from functools import cache
from pathlib import Path
from xml.etree.ElementTree import Element, fromstring

import pypdfium2
import pytest

from planes.course.numbers import main_answers, scene_text_with_numbers, settle_numbers, worker_question
from planes.course.quiz import Pool, Quiz, QuizGiven
from planes.course.reading import read_course
from planes.course.students import shares_of_course
from planes.documents.course import Desk, Order
from planes.documents.packages import prairielearn_files
from planes.documents.platforms import moodle_xml, stack_xml
from planes.lesson.conditions import condition_sentences
from planes.plans.measuring import scene_lettering
from planes.scene import Scene, loads
from planes.solving import Position, solve
from planes.words import available_languages
from planes.words.errors import PlanesError
from planes.words.naming import Naming
from tests.helpers import ROOT
from tests.helpers.from_paper import rebuilt

TEMPLATES = [f for f in sorted((ROOT / "planes" / "templates").glob("*.yaml")) if f.stem not in ("course", "vectors")]
SAMPLES = [f for f in sorted((ROOT / "samples").rglob("*.yaml")) if "links:" in f.read_text("utf-8")]
VECTORS = [ROOT / "planes/templates/vectors.yaml", *sorted((ROOT / "samples" / "vectors").glob("*.yaml"))]
STATICS = sorted((ROOT / "samples" / "statics").glob("*.yaml"))
FAST = [f for f in SAMPLES if f.stem in ("03", "12", "40", "carriage") or f.parts[-2:] == ("class-three", "guide.yaml")]
LAWFUL = [f for f in [*SAMPLES, *TEMPLATES] if re.search("working:|table:", f.read_text("utf-8"))]
PRINTED, DRAWN = 1e-4, 1e-5  # of a value: what a key prints of it; of the largest of its unit: nothing on a plan


def desk(text: str, lang: str = "en", plans: tuple[str, ...] = ()) -> Desk:
    return Desk(Order(text, ("A task", "", "A student"), (), plans, lang, ("a", "", "s")))


def words(data: bytes) -> str:
    with pypdfium2.PdfDocument(data) as document:
        return "\n".join(page.get_textpage().get_text_range() for page in document)


def naming_of(scene: Scene, drawn: Position, lang: str) -> Naming:
    return Naming(lang, **scene_lettering(scene, drawn.plans))


def same(scene: Scene, text: str, lang: str) -> None:
    """A scene and that rebuilt from a text have the same answers."""
    true = solve(scene).positions[0]
    other, missed = rebuilt(scene, text, naming_of(scene, true, lang))
    solved = solve(other)
    assert solved.positions, (solved.failed, missed)
    found = {f.quantity.name: f.numbers for f in solved.positions[0].found}
    largest: dict[str, float] = {}
    for f in true.found:
        for column, x in zip(f.quantity.columns, f.numbers, strict=True):
            largest[column.unit] = max(largest.get(column.unit, 0.0), abs(x or 0.0))
    for f in true.found:
        most = max((abs(x) for x in f.numbers if x is not None), default=0.0)
        off = PRINTED * most + DRAWN * largest[f.quantity.columns[0].unit] + 1e-6
        for x, y in zip(f.numbers, found[f.quantity.name], strict=True):
            assert (x is None) == (y is None), f.quantity.name
            assert x is None or y is None or abs(x - y) <= off, (f.quantity.name, x, y, missed)


@pytest.mark.parametrize("path", TEMPLATES, ids=lambda f: f.stem)
def test_a_template_is_solved_from_its_task(path: Path) -> None:
    one = desk(path.read_text("utf-8"))
    same(one.scene, words(one.task()), "en")


@pytest.mark.parametrize("path", FAST, ids=lambda f: f.stem)
def test_a_task_is_solved_from_its_paper(path: Path) -> None:
    one = desk(path.read_text("utf-8"), "ru")
    same(one.scene, words(one.task()), "ru")


@pytest.mark.parametrize("path", VECTORS, ids=lambda f: f.stem)
def test_stated_vectors_are_found_from_their_task(path: Path) -> None:
    one = desk(path.read_text("utf-8"), "ru")
    same(one.scene, words(one.task()), "ru")


@pytest.mark.few(12)
@pytest.mark.parametrize("path", STATICS, ids=lambda f: f.stem)
def test_bodies_are_held_as_their_task_says(path: Path) -> None:
    lang = available_languages("course")[STATICS.index(path) % 4]
    one = desk(path.read_text("utf-8"), lang)
    same(one.scene, words(one.task()), lang)


@pytest.mark.slow
@pytest.mark.parametrize("path", SAMPLES, ids=lambda f: f.stem)
def test_every_task_is_solved_from_its_paper(path: Path) -> None:
    for lang in available_languages("course")[SAMPLES.index(path) % 2 :: 2]:
        one = desk(path.read_text("utf-8"), lang)
        same(one.scene, words(one.task()), lang)


LAWS = {
    "strokes": "{working: 1000, idle: 150}",
    "expression": "1000 + 250*cos(2*phi) - 3*phi",
    "power": "40*(s_5/0.1)**2 + 20",
    "table": "{over: phi, table: [[0, 100], [90, 900], [200, 300.5], [360, 100]]}",
    "working table": "{working: {over: s_5, table: [[-1, 500], [1, 900]]}, idle: 100}",
}


@pytest.mark.parametrize("law", LAWS.values(), ids=LAWS)
def test_a_law_is_told_whole(law: str) -> None:
    """The answers are those of the law as it is told, in the task's position and in others."""
    text = (ROOT / "planes/templates/six-link.yaml").read_text("utf-8")
    changed, count = re.subn(r"force: 1000\b", f"force: {law}", text)
    assert count == 1
    one = desk(changed, "en")
    told = words(one.task())
    same(one.scene, told, "en")
    rewritten, missed = rebuilt(one.scene, told, naming_of(one.scene, solve(one.scene).positions[0], "en"))
    assert rewritten.mechanism and one.scene.mechanism and not [name for name in missed if "law" in name]
    for angle in (20.0, 130.0, 250.0):
        (true,), (again,) = (solve(scene, [angle]).positions for scene in (one.scene, rewritten))
        assert again.value("M_1") == pytest.approx(true.value("M_1"), rel=1e-4)


@pytest.mark.few(7)
@pytest.mark.parametrize("path", LAWFUL, ids=lambda f: f.stem)
def test_samples_with_laws_are_solved_from_their_english_tasks(path: Path) -> None:
    one = desk(path.read_text("utf-8"), "en")
    same(one.scene, words(one.task()), "en")


def test_a_task_says_nothing_that_is_not_asked_for() -> None:
    text = (ROOT / "planes/templates/six-link.yaml").read_text("utf-8") + "find: [v_F, omega_3]\n"
    one = desk(text)
    told = re.sub(r"\s", "", words(one.task()))
    assert (
        "ω1" in told
        and "lEF" in told
        and not {"kg", "9.81", "1000", "ε1"} & {x for x in ("kg", "9.81", "1000", "ε1") if x in told}
    )
    same(one.scene, words(one.task()), "en")


@pytest.mark.parametrize("plan", ["velocity", "force"])
def test_a_blank_has_what_its_plan_is_drawn_by(plan: str) -> None:
    one = desk((ROOT / "planes/templates/six-link.yaml").read_text("utf-8"), plans=(plan,))
    told = re.sub(r"\s", "", words(one.blank()))
    assert "ω1=12rad/s" in told and "lBC=0.35m" in told
    assert ("P5=1000N" in told) == ("m2=3kg" in told) == (plan == "force")


# platforms


@cache
def quizzes(name: str) -> tuple[tuple[Quiz, Scene], ...]:
    """Two students' questions of an assignment, the second with other numbers."""
    path = ROOT / name
    text, found = path.read_text("utf-8"), []
    for numbers in ({}, {"l_AB": "0.105", "phi_1": "70"}):
        own = scene_text_with_numbers(text, path.name, None, numbers, {}, ("plans",) if numbers else ())
        one = desk(own)
        found.append((Quiz.from_stored_text(one.quiz().decode()), one.scene))
    return tuple(found)


ASKED = ["planes/templates/six-link.yaml", "planes/templates/shaper.yaml", "samples/assignments/12.yaml"]


def plain(text: str) -> str:
    return html.unescape(re.sub(r"<p><img.*|<[^>]*>", " ", text.replace("<sub>", "").replace("</sub>", "")))


def inner(node: Element, path: str) -> str:
    found = node.find(path)
    assert found is not None
    return found.text or ""


def items(node: Element) -> dict[str, list[str]]:
    sets = node.findall("dataset_definitions/dataset_definition")
    return {inner(d, "name/text"): [inner(i, "value") for i in d.findall("dataset_items/dataset_item")] for d in sets}


@pytest.mark.parametrize("name", ASKED)
def test_every_question_of_moodle_is_solved_from_its_text(name: str) -> None:
    both = quizzes(name)
    asked = fromstring(moodle_xml([q for q, _ in both], "c", "en"))
    own = [q for q in asked if q.get("type") == "numerical"]
    each = len(both[0][0].questions)
    for k, (_, scene) in enumerate(both):
        same(scene, plain(inner(own[k * each], "questiontext/text")), "en")
    pooled = next(q for q in asked if q.get("type") == "calculated")
    for k, (_, scene) in enumerate(both):
        text = plain(inner(pooled, "questiontext/text"))
        for key, values in items(pooled).items():
            text = text.replace(f"{{{key}}}", values[k])
        same(scene, text, "en")


@pytest.mark.parametrize("name", ASKED)
def test_stack_and_prairielearn_tell_everything_too(name: str) -> None:
    both = quizzes(name)
    group = [q for q, _ in both]
    (asked,) = (q for q in fromstring(stack_xml(group, "c", "en")) if q.get("type") == "stack")
    lists = dict(re.findall(r"^(\w+)_all: \[(.*)\];", inner(asked, "questionvariables/text"), re.M))
    files = prairielearn_files("a", group, "en")
    sets = json.loads(files["numbers.json"])
    for k, (_, scene) in enumerate(both):
        text = plain(inner(asked, "questiontext/text"))
        same(scene, re.sub(r"\{@(\w+)@\}", lambda m, k=k: lists[m[1]].split(", ")[k], text), "en")  # type: ignore[misc]
        text = plain(files["question.html"].decode())
        same(scene, re.sub(r"\{\{params\.(\w+)\}\}", lambda m, k=k: str(sets[k]["given"].get(m[1], "")), text), "en")  # type: ignore[misc]


def test_a_lesson_of_a_platform_says_what_is_given() -> None:
    one = desk((ROOT / "planes/templates/four-bar.yaml").read_text("utf-8"))
    with zipfile.ZipFile(io.BytesIO(one.scorm())) as archive:
        page = archive.read("index.html").decode()
    same(one.scene, plain(page[page.index('<section id="given">') : page.index('<div class="panels">')]), "en")


def test_numbers_of_a_law_are_everybodys_own() -> None:
    given = (QuizGiven("l_{AB}", 0.1, "m"),)
    one, two = (
        Quiz("", "", "a", "t", p, given, f"P_{{5}} = {n}·sin(φ_{{1}}).", (), b"")
        for p, n in (("s", "300"), ("r", "2.5"))
    )
    pool = Pool([one, two], "en")
    assert pool.varied_numbers == {"law_0": [300.0, 2.5]} and "P_{5} = [law_0]·sin(φ_{1})." in pool.task_text(
        "[{}]".format
    )


def test_students_who_are_told_different_things_have_no_common_question() -> None:
    def of(place: str, name: str, said: str) -> Quiz:
        return Quiz("", "", "a", "t", place, (QuizGiven(name, 0.1, "m"),), said, (), b"")

    for other in (of("r", "x_{DE}", "no"), of("r", "l_{DE}", "yes")):
        with pytest.raises(PlanesError) as refused:
            Pool([of("s", "l_{DE}", "no"), other], "en").task_text(str)
        assert "the conditions for r differ" in refused.value.told("en")


def test_a_name_of_two_numbers_is_refused(tmp_path: Path) -> None:
    """A parameter called l_BC that is not the length BC, which is told under that name too."""
    text = (ROOT / "planes/templates/six-link.yaml").read_text("utf-8").replace("C: l_BC,", "C: l_BC + 0.01,")
    (tmp_path / "scene.yaml").write_text(text, "utf-8")
    (tmp_path / "students.txt").write_text("Smith J.\n", "utf-8")
    course = read_course(tmp_path)
    (share,) = shares_of_course(course)
    fault = settle_numbers(worker_question(course, share, "en")).fault
    line = next(k for k, row in enumerate(text.splitlines(), 1) if row.startswith("parameters"))
    assert fault.startswith(f"{tmp_path / 'scene.yaml'}:{line}: l_BC is a parameter of ") and "another name" in fault


def test_the_questions_of_a_student_are_those_of_the_scene() -> None:
    quiz, scene = quizzes(ASKED[0])[0]
    answers = main_answers(scene, solve(loads(scene.reading.source)).json())
    assert [q.name for q in quiz.questions] == [name for name, _ in answers]


SIDE = re.compile(r"⟨(\w+)⟩ is to the (left|right) of the line from ⟨(\w+)⟩ to ⟨(\w+)⟩")


@pytest.mark.few(12)
@pytest.mark.parametrize("file", SAMPLES, ids=lambda f: f.stem)
def test_what_is_said_to_be_left_is_left(file: Path) -> None:
    """The side a task tells of a point is that of the solved one: by the turn from the line to the point."""
    solved = solve(loads(file.read_text("utf-8"), str(file)))
    for name, side, one, two in SIDE.findall(" ".join(condition_sentences(solved.plans, "en"))):
        point, start, end = (complex(solved.positions[0].r[n]) for n in (name, one, two))
        assert (((end - start).conjugate() * (point - start)).imag > 0) == (side == "left"), (name, one, two)
