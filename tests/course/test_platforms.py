"""A course on learning platforms: Moodle XML, STACK, SCORM and PrairieLearn read back as their importers read them."""

from __future__ import annotations

import base64
import importlib.util
import io
import json
import math
import re
import shutil
import subprocess
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache, partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread
from xml.etree.ElementTree import Element, fromstring

import pypdfium2
import pytest
from PIL import Image

from planes.cli import main
from planes.course.quiz import LEAST_TOLERANCE_SHARE, PUPIL_PENCIL, TOLERANCE_SIGMAS, Pool, Quiz
from planes.documents.packages import scorm_manifest
from planes.documents.platforms import stack_seeds
from planes.scene import load
from planes.solving import solve
from tests.helpers import ROOT
from tests.helpers.browser import chromium, until
from tests.helpers.platform_fields import INFO, NEEDED

COURSE = """course: 1
title: "Осень <1>"
lang: en
students: [Anna A., Boris B., Clara C.]
assignments: [12.yaml]
variants: given
documents: [book, scorm, moodle, stack, prairielearn]
"""
SCORM = {"": "http://www.imsproject.org/xsd/imscp_rootv1p1p2", "adlcp": "http://www.adlnet.org/xsd/adlcp_rootv1p2"}
KINDS = {"numerical", "calculated", "stack", "category"}


@pytest.fixture(scope="module")
def out(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The course made."""
    at = tmp_path_factory.mktemp("platforms")
    (at / "course.yaml").write_text(COURSE, "utf-8")
    (at / "12.yaml").write_bytes((ROOT / "samples" / "assignments" / "12.yaml").read_bytes())
    assert main(["course", str(at), "-o", str(at / "out"), "--jobs", "1"]) == 0
    return at / "out"


@cache
def quizzes(out: Path) -> list[Quiz]:
    return [Quiz.from_stored_text(f.read_text("utf-8")) for f in sorted(out.glob("teacher/*/quiz.json"))]


def said(node: Element, path: str) -> str:
    found = node.find(path)
    assert found is not None, path
    return found.text or ""


def questions(out: Path, name: str) -> list[Element]:
    """The questions of a file, as Moodle's importer goes through them: each has a name, a text and its pictures."""
    quiz = fromstring((out / "teacher" / f"{name}.xml").read_bytes())
    assert quiz.tag == "quiz" and {q.get("type") for q in quiz} <= KINDS
    found = [q for q in quiz if q.get("type") != "category"]
    for q in found:
        told = q.find("questiontext")
        assert said(q, "name/text") and told is not None and told.get("format") == "html"
        text, files = said(told, "text"), told.findall("file")
        assert set(re.findall(r"@@PLUGINFILE@@/([\w.]+)", text)) == {f.get("name") for f in files}
        assert not [path for path in NEEDED[q.get("type", "")] if q.find(path) is None]
        for file in files:
            assert file.get("encoding") == "base64"
            with Image.open(io.BytesIO(base64.b64decode(file.text or ""))) as picture:
                assert picture.width > 300
        assert "Осень" not in text and "<1>" not in text
    return found


def test_every_student_has_numerical_questions_with_their_own_numbers(out: Path) -> None:
    own = [q for q in questions(out, "moodle") if q.get("type") == "numerical"]
    asked = [item for quiz in quizzes(out) for item in quiz.questions]
    assert len(own) == len(asked) >= 12
    for question, item in zip(own, asked, strict=True):
        answer = question.find("answer")
        assert answer is not None and answer.get("fraction") == "100"
        assert float(said(answer, "text")) == pytest.approx(item.value, rel=1e-9)
        assert float(said(answer, "tolerance")) == pytest.approx(item.tolerance, rel=1e-5)


def test_answers_are_those_of_the_scene_and_what_a_pencil_draws_is_let_pass(out: Path) -> None:
    """Forty pencils, none of them the one the tolerance was claimed by: nineteen answers of twenty pass."""
    quiz = quizzes(out)[0]
    scene = load(out / "teacher" / quiz.place / "scene.yaml")
    exact = solve(scene).positions[0]
    held = tried = 0
    for item in quiz.questions:
        true = exact.value(item.name)
        assert item.value == pytest.approx(abs(true) if item.name[0] in "va" else true, rel=1e-9, abs=1e-9)
        assert item.tolerance >= LEAST_TOLERANCE_SHARE * abs(item.value) * 0.99
    for seed in range(100, 140):
        drawn = solve(
            scene, None, type(PUPIL_PENCIL)(PUPIL_PENCIL.point_mm, PUPIL_PENCIL.ray_deg, PUPIL_PENCIL.ruler_mm, seed)
        ).positions[0]
        for item in quiz.questions:
            got = drawn.value(item.name)
            tried += 1
            held += abs((abs(got) if item.name[0] in "va" else got) - item.value) <= item.tolerance
    assert TOLERANCE_SIGMAS == 2.0 and held >= 0.9 * tried, (held, tried)


def test_a_calculated_question_has_everybodys_numbers(out: Path) -> None:
    made = [q for q in questions(out, "moodle") if q.get("type") == "calculated"]
    assert len(made) == len(quizzes(out)[0].questions)
    for number, question in enumerate(made):
        sets = {said(d, "name/text"): d for d in question.findall("dataset_definitions/dataset_definition")}
        wild = set(re.findall(r"\{(\w+)\}", said(question, "questiontext/text") + said(question, "answer/text")))
        assert wild == set(sets) and len(sets) >= 2
        share = float(said(question, "answer/tolerance"))
        own = [quiz.questions[number] for quiz in quizzes(out)]
        assert said(question, "answer/tolerancetype") == "1" and share >= LEAST_TOLERANCE_SHARE
        assert all(share * abs(one.value) >= one.tolerance * (1 - 1e-5) for one in own)
        for d in sets.values():
            items = d.findall("dataset_items/dataset_item")
            assert [said(i, "number") for i in items] == ["1", "2", "3"] and said(d, "itemcount") == "3"
        key = said(question, "answer/text").strip("{}")
        values = [float(said(i, "value")) for i in sets[key].findall("dataset_items/dataset_item")]
        assert values == pytest.approx([q.questions[number].value for q in quizzes(out)], rel=1e-9)


def test_a_stack_question_is_whole(out: Path) -> None:
    """Every input has its place, its answer and a tree; every variable that is used is made; seeds are deployed."""
    (question,) = questions(out, "stack")
    text, made = said(question, "questiontext/text"), said(question, "questionvariables/text")
    count = len(quizzes(out)[0].questions)
    names = [said(i, "name") for i in question.findall("input")]
    assert names == [f"ans{k}" for k in range(1, count + 1)]
    assert re.findall(r"\[\[input:(\w+)\]\]", text) == re.findall(r"\[\[validation:(\w+)\]\]", text) == names
    variables = set(re.findall(r"^(\w+):", made, re.M))
    assert {said(i, "tans") for i in question.findall("input")} | set(re.findall(r"\{@(\w+)@\}", text)) <= variables
    trees = [said(t, "name") for t in question.findall("prt")]
    assert re.findall(r"\[\[feedback:(\w+)\]\]", said(question, "specificfeedback/text")) == trees
    assert math.isclose(sum(float(said(t, "value")) for t in question.findall("prt")), 1.0, abs_tol=1e-5)
    for line in made.splitlines():
        assert len(re.findall(r"[-\d.e]+(?=[,\]])", line)) in (0, 3) and line.endswith(";")
    assert len({said(seed, ".") for seed in question.findall("deployedseed")}) == 3


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("maxima") is None, reason="maxima is not installed")
def test_maxima_draws_every_student_and_grades_by_the_tolerance(out: Path) -> None:
    """Each deployed seed gives one student's numbers, in their order; an answer passes just within its tolerance."""
    (question,) = questions(out, "stack")
    made, trees = said(question, "questionvariables/text"), question.findall("prt")
    shown, told = re.findall(r"\{@(d_\w+)@\}", said(question, "questiontext/text")), []
    for seed in question.findall("deployedseed"):
        lines = [f"set_random_state(make_random_state({said(seed, '.')}))$ rand(n) := random(n)$", made]
        lines += [f"print(told, {name})$" for name in shown]
        for k, tree in enumerate(trees, 1):
            node = tree.find("node")
            assert node is not None and said(node, "answertest") == "AlgEquiv" and said(node, "tans") == "true"
            lines.append(f"print(told, ta{k})$")
            for off in (0.0, 0.99, -0.99, 1.01, -1.01):
                lines += [f"ans{k}: ta{k} + ({off})*tol{k}$", said(tree, "feedbackvariables/text")]
                lines.append(f"print(told, {said(node, 'sans')})$")
        done = subprocess.run(
            ["maxima", "--very-quiet", "--batch-string", "display2d: false$ fpprintprec: 12$ " + " ".join(lines)],
            capture_output=True,
            text=True,
            check=True,
        )
        told.append(re.findall(r"^told (\S+)\s*$", done.stdout, re.M))
    varied = Pool(quizzes(out), "en").varied_numbers
    for place, (quiz, words) in enumerate(zip(quizzes(out), told, strict=True)):
        given, answers = words[: len(shown)], words[len(shown) :]
        own = [f"{values[place]:.6g}" for values in varied.values()]
        assert [float(word) for word in given] == [float(word) for word in own]
        assert len(answers) == 6 * len(quiz.questions)
        for k, item in enumerate(quiz.questions):
            value, *passed = answers[6 * k : 6 * k + 6]
            assert float(value) == pytest.approx(item.value, rel=1e-9)
            assert passed == ["true", "true", "true", "false", "false"]


@pytest.mark.parametrize("count", [1, 2, 7, 31])
def test_no_student_is_left_without_a_seed(count: int) -> None:
    assert len(set(stack_seeds(count))) == count


def test_the_manifest_of_a_lesson_says_what_scorm_asks(out: Path) -> None:
    package = next(out.glob("teacher/*/scorm.zip"))
    with zipfile.ZipFile(package) as archive:
        assert sorted(archive.namelist()) == ["imsmanifest.xml", "index.html"]
        root = fromstring(archive.read("imsmanifest.xml"))
    cp, adl = f"{{{SCORM['']}}}", f"{{{SCORM['adlcp']}}}"
    assert root.tag == f"{cp}manifest" and re.fullmatch(r"[A-Za-z_][\w.-]*", root.get("identifier", ""))
    assert [child.tag.removeprefix(cp) for child in root] == ["metadata", "organizations", "resources"]
    assert said(root, f"{cp}metadata/{cp}schema") == "ADL SCORM"
    assert said(root, f"{cp}metadata/{cp}schemaversion") == "1.2"
    organisations, resource = root.find(f"{cp}organizations"), root.find(f"{cp}resources/{cp}resource")
    assert organisations is not None and resource is not None
    names = {o.get("identifier") for o in organisations}
    assert organisations.get("default") in names
    item = organisations.find(f"{cp}organization/{cp}item")
    assert item is not None and item.get("identifierref") == resource.get("identifier")
    assert resource.get(f"{adl}scormtype") == "sco" and resource.get("href") == "index.html"
    assert scorm_manifest("a", "x") == scorm_manifest("a", "x") != scorm_manifest("b", "x")


@contextmanager
def served(folder: Path) -> Iterator[str]:
    """A folder at an address: two files from a disk may not look at one another."""

    class Quiet(SimpleHTTPRequestHandler):
        def log_message(self, *_: object) -> None:
            pass

    with ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=str(folder))) as server:
        Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}"
        server.shutdown()


@pytest.mark.slow
def test_a_lesson_tells_its_score(out: Path, tmp_path: Path) -> None:
    """In a frame of a page that has the platform's API: begun, scored, committed, finished."""
    with zipfile.ZipFile(next(out.glob("teacher/*/scorm.zip"))) as archive:
        archive.extract("index.html", tmp_path)
    calls = "const told = []; const get = { 'cmi.core.lesson_status': 'not attempted' };"
    api = "LMSGetValue: k => get[k] || '', LMSSetValue: (k, v) => { told.push([k, v]); return 'true'; },"
    for name, word in (("Initialize", "begin"), ("Commit", "commit"), ("Finish", "end")):
        api += f"LMS{name}: () => told.push(['{word}']),"
    frame = "<iframe id='lesson' src='index.html' width='1200' height='800'></iframe>"
    (tmp_path / "platform.html").write_text(f"<script>{calls} window.API = {{ {api} }};</script>{frame}", "utf-8")
    with served(tmp_path) as address, chromium() as browser:
        browser_page = browser.new_page()
        browser_page.goto(f"{address}/platform.html")
        until(browser_page, "told.length > 0")
        assert browser_page.evaluate("told[0][0]") == "begin"
        assert browser_page.evaluate("told.some(t => t[1] === 'incomplete')")
        lesson = browser_page.frames[1]
        lesson.evaluate("practice.toggle(); practice.answer(practice.truth(practice.item), ''); practice.answer(0, '')")
        told = browser_page.evaluate("told")
        assert ["cmi.core.score.raw", "50"] in told or ["cmi.core.score.raw", "100"] in told
        assert ["commit"] in told
        browser_page.evaluate("document.getElementById('lesson').remove()")
        until(browser_page, "told.some(t => t[0] === 'end')")


def test_a_prairielearn_question_is_drawn_by_its_own_server(out: Path) -> None:
    folder = out / "teacher" / "prairielearn" / "12"
    info = json.loads((folder / "info.json").read_text("utf-8"))
    assert {"uuid", "title", "topic", "type"} <= info.keys() <= INFO and info["type"] == "v3"
    assert re.fullmatch(r"[0-9a-f]{8}-([0-9a-f]{4}-){3}[0-9a-f]{12}", info["uuid"])
    spec = importlib.util.spec_from_file_location("prairielearn_server", folder / "server.py")
    assert spec and spec.loader
    server = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(server)
    html, drawn = (folder / "question.html").read_text("utf-8"), set()
    for seed in range(12):
        data: dict[str, object] = {"variant_seed": seed, "params": {}, "correct_answers": {}}
        server.generate(data)
        params, answers = data["params"], data["correct_answers"]
        assert isinstance(params, dict) and isinstance(answers, dict)
        assert set(re.findall(r"\{\{params\.(\w+)\}\}", html)) <= params.keys()
        assert set(re.findall(r'answers-name="(\w+)"', html)) == answers.keys()
        drawn.add(json.dumps(answers))
    assert len(drawn) == 3
    assert (folder / "clientFilesQuestion" / "scheme.png").read_bytes().startswith(b"\x89PNG")


def test_the_book_has_every_students_answers(out: Path) -> None:
    with pypdfium2.PdfDocument(out / "teacher" / "book.pdf") as book:
        text = "".join(page.get_textpage().get_text_range() for page in book)
    keys = sorted(out.glob("teacher/*/key.pdf"))
    assert len(keys) == 3 and all(name in text for name in ("Anna A.", "Boris B.", "Clara C."))


def test_a_second_run_keeps_everything(out: Path) -> None:
    before = {f: f.read_bytes() for f in out.rglob("*") if f.is_file()}
    assert main(["course", str(out.parent), "-o", str(out), "--jobs", "1"]) == 0
    assert {f: f.read_bytes() for f in out.rglob("*") if f.is_file()} == before
