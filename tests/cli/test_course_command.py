"""``planes course`` as a process: the same files however many work, cut short and gone on, or on a Dask cluster."""

from __future__ import annotations

import csv
import hashlib
import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from planes.cli import main
from planes.course import random_numbers, workers
from planes.documents import course as documents
from planes.documents import course_run
from planes.scene import load
from planes.solving import solve
from planes.words.errors import PlanesError
from tests.helpers import ROOT
from tests.helpers.counting import PATIENCE_S

SAMPLES = ROOT / "samples"
COMMAND = [sys.executable, "-m", "planes", "course"]
LIGHT = "course: 1\nlang: ru\ntitle: Осень\nsheet: {group: М-31, teacher: Петров}\ndocuments: [task, blank, key]\n"


def folder(path: Path, course: str = LIGHT, count: int = 8, scene: str = "12") -> Path:
    """A course of so many students, six with given variants."""
    path.mkdir(exist_ok=True)
    (path / "course.yaml").write_text(course, "utf-8")
    (path / "students.txt").write_text("".join(f"Студент {k}\n" for k in range(1, count + 1)), "utf-8")
    (path / "scene.yaml").write_bytes((SAMPLES / "assignments" / f"{scene}.yaml").read_bytes())
    return path


def files(out: Path) -> dict[str, str]:
    """Every file with the hash of its contents."""
    found = (f for f in out.rglob("*") if f.is_file())
    return {f.relative_to(out).as_posix(): hashlib.sha256(f.read_bytes()).hexdigest() for f in found}


def run(at: Path, out: Path, *more: str) -> subprocess.CompletedProcess[str]:
    """The command, its warnings errors."""
    every = [COMMAND[0], "-W", "error", *COMMAND[1:], str(at), "-o", str(out), "--lang", "ru", *more]
    return subprocess.run(every, capture_output=True, text=True, timeout=PATIENCE_S, check=False)


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A course made by one process without disturbance; its results stand in ``out``."""
    at = folder(tmp_path_factory.mktemp("course"))
    done = run(at, at / "out", "--jobs", "1")
    assert done.returncode == 0 and done.stderr == "", done.stderr
    assert "студентов 8, файлов сделано 40, проверено и оставлено 0, ошибок 0" in done.stdout
    return at


@pytest.mark.slow
def test_what_everybody_gets(whole: Path) -> None:
    out = whole / "out"
    own = {"students": {"task.pdf", "blank.pdf"}, "teacher": {"scene.yaml", "key.json", "key.pdf"}}
    for side, names in own.items():
        for k in range(1, 9):
            assert {f.name for f in (out / side / f"Студент-{k}").iterdir()} == names
    assert {f.name for f in out.iterdir()} == {"students", "teacher", "manifest.json"}
    listed = json.loads((out / "manifest.json").read_text("utf-8"))["files"]
    assert {n: e["sha256"] for n, e in listed.items()} == {n: h for n, h in files(out).items() if n != "manifest.json"}


@pytest.mark.slow
def test_the_summary_holds_everybodys_own_answers(whole: Path) -> None:
    out = whole / "out"
    rows = list(csv.DictReader((out / "teacher/summary.csv").read_text("utf-8-sig").splitlines()))
    assert [r["Вариант"] for r in rows] == ["А", "Б", "В", "Г", "Д", "Е", "свой", "свой"]
    assert len({tuple(r.values())[4:] for r in rows}) == 8
    for row in rows:
        at = out / "teacher" / row["Студент"].replace(" ", "-")
        scene = load(at / "scene.yaml")
        assert row["Группа"] == scene.sheet["group"] == "М-31"
        assert scene.sheet["student"] == row["Студент"] and scene.sheet["teacher"] == "Петров"
        key = json.loads((at / "key.json").read_text("utf-8"))
        assert key == json.loads(json.dumps(solve(scene, lang="ru").json()))
        assert float(row["M_1 [Н·м]"]) == key["positions"][0]["balancing_moment"]
        assert float(row["phi_1 [°]"]) == key["positions"][0]["phi_deg"]
    page = (out / "teacher/summary.html").read_text("utf-8")
    assert all(f"Студент {k}" in page for k in range(1, 9))


@pytest.mark.slow
def test_a_students_scene_is_what_the_other_commands_take(whole: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["solve", str(whole / "out/teacher/Студент-7/scene.yaml"), "--lang", "ru"]) == 0
    assert "Уравновешивающий момент" in capsys.readouterr().out


@pytest.mark.slow
def test_killed_half_way_and_gone_on(whole: Path, tmp_path: Path) -> None:
    """SIGKILL: nothing half-written under its own name, no worker left behind, what was done kept; and two processes,
    twice begun, make the bytes that one made undisturbed."""
    out = tmp_path / "out"
    with subprocess.Popen([*COMMAND, str(whole), "-o", str(out), "--jobs", "2"], start_new_session=True) as process:
        wait(lambda: sum(1 for _ in out.rglob("*.pdf")) >= 5)
        os.kill(process.pid, signal.SIGKILL)
        process.wait()
        wait(lambda: not group(process.pid))
    truth, cut = files(whole / "out"), files(out)
    begun = {n for n in cut if Path(n).name.startswith(".")}
    made = cut.keys() - begun
    assert 5 <= len(made) < len(truth) and ".journal" in begun and "manifest.json" not in made
    assert all(cut[n] == truth[n] for n in made)
    written = {n: (out / n).stat().st_mtime_ns for n in made}
    done = run(whole, out, "--jobs", "2")
    assert done.returncode == 0 and files(out) == truth, done.stderr
    kept = {n for n in made if (out / n).stat().st_mtime_ns == written[n]}
    assert len(made) - len(kept) <= 1  # the very last file may have missed its line in the journal


@pytest.mark.slow
def test_only_what_has_changed_is_made_anew(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    at, out = folder(tmp_path / "course", count=3), tmp_path / "out"

    def again() -> str:
        assert main(["course", str(at), "-o", str(out), "--jobs", "1", "--lang", "ru"]) == 0
        return capsys.readouterr().out

    again()
    before = files(out)
    (out / "students/Студент-2/task.pdf").write_bytes(b"spoilt")
    (out / "teacher/Студент-3/key.pdf").unlink()
    assert "файлов сделано 2, проверено и оставлено 13" in again()
    assert files(out) == before
    (at / "students.txt").write_text("Студент 1\nСтудент 3\n", "utf-8")
    assert "файлов сделано 5, проверено и оставлено 5" in again()  # the third has the second variant now
    assert not (out / "students/Студент-2").exists() and not (out / "teacher/Студент-2").exists()


@pytest.mark.slow
def test_one_students_fault_does_not_stop_the_others(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A crank of 50 m assembles nowhere: who is to get such numbers is told so."""
    monkeypatch.setattr(random_numbers, "MOST_TRIED_SETS", 100)
    course = (
        "course: 1\ndocuments: [task]\nvariants: drawn\ndraw: {l_OA: [50]}\n"
        "students: [{name: Первый, variant: А}, Второй]\n"
    )
    at = folder(tmp_path / "course", course, 1, "66")
    assert main(["course", str(at), "--jobs", "1", "--lang", "ru"]) == 1
    two_lists, said = capsys.readouterr().err.splitlines()
    assert two_lists.startswith("предупреждение: студенты названы в самом")
    assert said.startswith("Второй: из 100 наборов чисел не подошёл ни один: 100 не собираются")
    assert [f.name for f in (at / "out/students").iterdir()] == ["Первый"]
    rows = list(csv.DictReader((at / "out/teacher/summary.csv").read_text("utf-8-sig").splitlines()))
    assert rows[1]["Ошибка"].startswith("из 100 наборов") and not rows[0]["Ошибка"]


@pytest.mark.slow
def test_there_must_be_numbers_for_everybody(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(course_run, "MOST_COINCIDING_DRAWS", 8)
    course = "course: 1\ndocuments: [task]\nvariants: drawn\ndraw: {phi_1: [30, 60]}\n"
    at = folder(tmp_path / "course", course, 3)
    assert main(["course", str(at), "--jobs", "1", "--lang", "en"]) == 1
    said = "there are not enough sets of numbers that give different plans; widen draw"
    assert capsys.readouterr().err == f"Студент-3: {said}\n"
    rows = list(csv.DictReader((at / "out/teacher/summary.csv").read_text("utf-8-sig").splitlines()))
    assert sorted(r["phi_1 [°]"] for r in rows) == ["", "30", "60"]


@pytest.mark.slow
def test_a_slip_of_a_document_is_a_sentence(
    whole: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    at = folder(tmp_path / "course", LIGHT.replace("task, blank, key", "task, lesson"), 1)
    assert main(["course", str(at), "--jobs", "1", "--lang", "en"]) == 0
    assert (at / "out/teacher/Студент-1/lesson.html").is_file() and capsys.readouterr().err == ""
    monkeypatch.setattr(documents, "lesson_data", lambda scene: 1 / 0)
    (at / "scene.yaml").write_text((at / "scene.yaml").read_text("utf-8").replace("l_AB: 0.1", "l_AB: 0.11"), "utf-8")
    assert main(["course", str(at), "--jobs", "1", "--lang", "en"]) == 1
    said = capsys.readouterr()
    slip = "Студент-1/lesson.html: an error in the program (ZeroDivisionError: division by zero, test_course_command"
    assert slip in said.err
    assert (at / "out/students/Студент-1/task.pdf").is_file()
    assert not (at / "out/teacher/Студент-1/lesson.html").exists()


@pytest.mark.slow
def test_what_a_sheet_leaves_out_is_said_and_said_again_of_a_sheet_that_is_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    drawn = documents.sheet_of
    monkeypatch.setattr(documents, "sheet_of", lambda *how: replace(drawn(*how), warnings=("no room on A4",)))
    at = folder(tmp_path / "course", LIGHT.replace("task, blank, key", "task, sheets"), 1)
    for made in ("5 files made, 0 verified", "0 files made, 5 verified"):
        assert main(["course", str(at), "--jobs", "1", "--lang", "en"]) == 0
        told = capsys.readouterr()
        assert told.err == "".join(f"Студент-1/sheet-{n}.pdf: no room on A4\n" for n in (1, 2)) and made in told.out
    listed = json.loads((at / "out/manifest.json").read_text("utf-8"))["files"]
    said = {name: entry["said"] for name, entry in listed.items() if "said" in entry}
    assert said == {f"teacher/Студент-1/sheet-{n}.pdf": ["no room on A4"] for n in (1, 2)}


@pytest.mark.slow
def test_all_documents_in_all_formats(tmp_path: Path) -> None:
    course = "course: 1\nlang: en\ndocuments: [task, blank, key, sheets, lesson, note]\nformats: [pdf, dxf, svg]\n"
    at = folder(tmp_path, course, 1, "26")
    assert run(at, at / "out", "--jobs", "1").returncode == 0
    names = {f.name for f in (at / "out").rglob("*") if f.is_file()}
    sheets = {f"sheet-{n}.{f}" for n in (1, 2) for f in ("pdf", "dxf", "svg")}
    assert names == {
        "task.pdf",
        "blank.pdf",
        "key.pdf",
        "key.json",
        "scene.yaml",
        "lesson.html",
        "note.pdf",
        "summary.csv",
        "summary.html",
        "manifest.json",
        *sheets,
    }
    for pdf in (at / "out").rglob("*.pdf"):
        assert pdf.read_bytes().startswith(b"%PDF") and pdf.stat().st_size > 5000


@pytest.mark.parametrize(
    ("argv", "told"),
    [
        (["course", "nowhere"], "nowhere: there is no such folder\n"),
        (["course", ".", "--jobs", "0"], "--jobs 0: there must be at least one process\n"),
        (["course", ".", "--jobs", "1"], "has no list of students; put students.csv or students.txt into it"),
    ],
)
def test_bad_input_is_one_sentence(
    argv: list[str], told: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "12.yaml").write_bytes((SAMPLES / "assignments/12.yaml").read_bytes())
    assert main([*argv, "--lang", "en"]) == 2
    said = capsys.readouterr()
    assert said.out == "" and told in said.err and said.err.count("\n") == 1
    assert [f.name for f in tmp_path.iterdir()] == ["12.yaml"]


@pytest.mark.slow
def test_doubts_of_a_scene_are_told_once_whoever_gets_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A link of 20 m in the scene itself, and one of 12 m in one of its variants."""
    at = folder(tmp_path / "course", LIGHT.replace("task, blank, key", "task"), 3)
    text = (at / "scene.yaml").read_text("utf-8").replace("l_S5: 0.2", "l_S5: 20")
    (at / "scene.yaml").write_text(text.replace("Б: {phi_1: 120}", "Б: {phi_1: 120, l_CD: 12}"), "utf-8")
    main(["course", str(at), "--jobs", "1", "--lang", "en"])
    said = [line for line in capsys.readouterr().err.splitlines() if "scene.yaml:" in line]
    assert [line.split(": ")[2] for line in said] == ["link 5 is 20 m long", "link 3 is 12.1 m long"], said


def test_of_two_lists_of_students_the_one_that_is_taken_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    seen: list[tuple[str, ...]] = []
    report = course_run.Report()
    monkeypatch.setattr(
        course_run, "conduct_course", lambda c, *_: seen.append(tuple(s.name for s in c.students)) or report
    )
    for students in ("", "students: [Anna]\n"):
        at = folder(tmp_path, f"course: 1\n{students}", 1)
        assert main(["course", str(at), "--jobs", "1", "--lang", "en"]) == 0
    told = f"warning: {at / 'course.yaml'} names the students itself, so {at / 'students.txt'} is not read; "
    assert seen == [("Студент 1",), ("Anna",)] and capsys.readouterr().err.count(told) == 1


@pytest.mark.parametrize("key", ["students: lost.csv", "assignments: lost.yaml", "assignments: [scene.yaml, lost]"])
def test_a_file_the_course_names_must_be_there(key: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    at = folder(tmp_path / "course", f"course: 1\n{key}\n", 1)
    assert main(["course", str(at), "--jobs", "1", "--lang", "en"]) == 2
    said = capsys.readouterr().err
    assert said.startswith(f"{at / 'course.yaml'}:2: ") and "there is no " in said and "lost" in said
    assert said.count("\n") == 1 and not (at / "out").exists()


@pytest.mark.slow
def test_a_process_that_is_stopped_is_a_sentence() -> None:
    with pytest.raises(PlanesError, match="the system stopped one of the processes"), workers.start_workers(2) as each:
        list(each(os._exit, [1]))


# the cluster


@pytest.fixture(scope="module")
def cluster() -> Iterator[str]:
    """The address of a Dask scheduler of this machine with two workers, as processes of their own."""
    pytest.importorskip("distributed", reason="a Dask cluster needs distributed: pip install distributed")
    program = (
        "import sys\nfrom distributed import LocalCluster\nif __name__ == '__main__':\n"
        " with LocalCluster(n_workers=2, threads_per_worker=2, dashboard_address=None) as c:\n"
        "  print(c.scheduler_address, flush=True)\n  sys.stdin.read()\n"
    )
    with subprocess.Popen(
        [sys.executable, "-c", program],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    ) as process:
        assert process.stdout and process.stdin
        yield process.stdout.readline().strip()
        process.stdin.close()


@pytest.mark.slow
def test_a_cluster_makes_the_same_bytes(whole: Path, tmp_path: Path, cluster: str) -> None:
    done = run(whole, tmp_path / "out", "--scheduler", cluster)
    assert done.returncode == 0 and done.stderr == "", done.stderr
    assert files(tmp_path / "out") == files(whole / "out")


@pytest.mark.slow
def test_a_cluster_that_fails_is_a_sentence(cluster: str) -> None:
    program = (
        "import sys\nfrom planes.course.workers import start_workers\nfrom planes.words.errors import PlanesError\n"
        "try:\n with start_workers(scheduler=sys.argv[1]) as each: list(each(int, ['x']))\n"
        "except PlanesError as error: print(error)"
    )
    done = subprocess.run([sys.executable, "-c", program, cluster], capture_output=True, text=True, check=False)
    assert done.stdout.startswith("the cluster failed (ValueError: invalid literal for int()"), done.stderr


@pytest.mark.slow
def test_no_scheduler_is_a_sentence(whole: Path, tmp_path: Path) -> None:
    pytest.importorskip("distributed", reason="a Dask cluster needs distributed: pip install distributed")
    program = (
        "import sys\nfrom planes.cli import main\nfrom planes.course import workers\nworkers.SECONDS = 0.5\n"
        "sys.exit(main(sys.argv[1:]))"
    )
    argv = ["course", str(whole), "-o", str(tmp_path / "out"), "--lang", "ru", "--scheduler", "tcp://127.0.0.1:9"]
    done = subprocess.run([sys.executable, "-c", program, *argv], capture_output=True, text=True, check=False)
    assert done.returncode == 2 and done.stderr.count("\n") == 1, done.stderr
    assert done.stderr.startswith("планировщик Dask по адресу tcp://127.0.0.1:9 не отвечает")
    assert not (tmp_path / "out").exists()


# all scenes of a folder


@pytest.mark.slow
def test_the_table_of_a_folder(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(workers, "usable_core_count", lambda: 1)
    for name in ("28", "66"):
        (tmp_path / f"{name}.yaml").write_bytes((SAMPLES / "assignments" / f"{name}.yaml").read_bytes())
    assert main(["solve", str(tmp_path), "--lang", "en"]) == 0
    said = capsys.readouterr().out
    assert "28 (А, Б, В, Г, Д, Е): links 4 and 5: the table gives them neither lengths" in said
    assert "66 (А, Б, В, Г, Д, Е): the driver 1 makes no full turn: the mechanism does not assemble from 224.4°" in said
    assert "12 positions: 12 solved, 12 with forces; " in said and said.endswith("2 exceptions.\n")
    apart = (tmp_path / "66.yaml").read_text("utf-8").replace("l_AB: 1.05", "l_AB: 1")
    (tmp_path / "66.yaml").write_text(apart, "utf-8")
    assert main(["solve", str(tmp_path), "--json"]) == 1
    found: list[dict[str, Any]] = json.loads(capsys.readouterr().out)
    assert [x["variant"] for x in found if not x["solved"]] == ["Е"]
    assert "does not assemble" in found[-1]["remarks"][0] and found[-1]["difference"] is None
    assert main(["solve", str(tmp_path), "--phi", "30", "--lang", "en"]) == 2
    assert "--phi has no effect on the survey of a folder" in capsys.readouterr().err


def wait(true: Callable[[], bool], seconds: float = PATIENCE_S) -> None:
    """Until something is so."""
    end = time.monotonic() + seconds
    while not true():
        assert time.monotonic() < end
        time.sleep(0.02)


def group(leader: int) -> list[int]:
    """The processes still alive of a session, by its leader."""
    found = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            after = stat.read_text("utf-8", "replace").rpartition(")")[2].split()
        except OSError:
            continue
        if int(after[3]) == leader and after[0] != "Z":
            found.append(int(stat.parent.name))
    return found
