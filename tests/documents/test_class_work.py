"""A teacher's hour: a folder of what a course hands back, read in one run; only what has changed is judged anew."""

from __future__ import annotations

import base64
import json
import re
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from planes.check.grading.paper import Known, ReadPaper
from planes.check.handed_in import HandedSheet, open_picture, read_paper
from planes.check.outcome import check
from planes.check.report.class_rows import ClassRow
from planes.check.saved_marks import combine_with_picture
from planes.check.sheet_mark import SheetMark
from planes.cli import class_check as command
from planes.cli import main
from planes.course.handed_out import HandedOut, Task, plan_in_file_name, scenes_handed_out, variant_in_file_name
from planes.documents.class_sorting import Sorter
from planes.documents.class_work import ClassWork
from planes.lesson.handed_practice import fnv_checksum
from planes.lesson.told import SceneLesson
from planes.scene import load
from planes.solving import solve
from planes.words.errors import PlanesError
from tests.helpers import ROOT
from tests.helpers.browser import watched

cv2 = pytest.importorskip("cv2")
import numpy as np  # noqa: E402
import pypdfium2  # noqa: E402

from planes.check.fiducials import SHEET_MM  # noqa: E402
from planes.check.grading.prepared_plan import Asked, prepare  # noqa: E402
from planes.documents.check import blank_marks  # noqa: E402
from render.files import pdf  # noqa: E402
from tests.helpers.class_pictures import DPI, drawn, printed, scanned  # noqa: E402

IMAGE = pypdfium2.raw.FPDF_PAGEOBJ_IMAGE
TWELVE = ROOT / "samples/assignments/12.yaml"
ANNA, BORIS = "Петрова-Анна", "Иванов-Пётр"
Json = dict[str, Any]


@pytest.fixture(scope="module")
def course(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A course of two students, made: blanks of two plans each."""
    folder = tmp_path_factory.mktemp("course")
    shutil.copy(ROOT / "samples/assignments/12.yaml", folder / "12.yaml")
    (folder / "students.txt").write_text("Иванов Пётр\nПетрова Анна\n", "utf-8")
    (folder / "course.yaml").write_text("course: 1\ndocuments: [blank]\nplans: [velocity, acceleration]\n", "utf-8")
    assert main(["course", str(folder), "--jobs", "1"]) == 0
    return folder


def picture(course: Path, student: str, page: int = 0, wrong: Callable[[Any], Any] = lambda right: right) -> Any:
    """A page of a student's blank with the plan on it, scanned."""
    out = course / "out"
    scene = load(out / "teacher" / student / "scene.yaml")
    sheet = printed(out / "students" / student / "blank.pdf", page)
    return scanned(drawn(sheet, scene, ("velocity", "acceleration")[page], wrong))


def reversed_(right: dict[str, complex]) -> dict[str, complex]:
    return {name: -z for name, z in right.items()}


def without_mark(seen: Any) -> Any:
    """The code cut off, as somebody might crop a picture."""
    seen = seen.copy()
    seen[60:420, 1860:2170] = 245
    return seen


@pytest.fixture(scope="module")
def pictures(course: Path) -> dict[str, Any]:
    return {"right": picture(course, ANNA), "wrong": picture(course, BORIS, 0, reversed_)}


@pytest.fixture
def folder(tmp_path: Path, pictures: dict[str, Any]) -> Path:
    """What came back: named by a telephone, one of them cropped and named by hand, and what lies beside pictures."""
    found = tmp_path / "photos"
    found.mkdir()
    cv2.imwrite(str(found / "IMG_1.jpg"), pictures["right"])
    cv2.imwrite(str(found / "IMG_2.jpg"), pictures["wrong"])
    cv2.imwrite(str(found / "петрова скорости.jpg"), without_mark(pictures["right"]))
    cv2.imwrite(str(found / "IMG_3.png"), np.full((500, 700), 250, np.uint8))
    for name in ("Thumbs.db", "desktop.ini", "._IMG_1.jpg", ".DS_Store", "index.html"):
        (found / name).write_bytes(b"x")
    return found


def rows(capsys: pytest.CaptureFixture[str], *line: str) -> dict[str, Json]:
    """The objects of a run, by file."""
    capsys.readouterr()
    main(["check", *line, "--json", "--lang", "en"])
    return {one["file"]: one for one in json.loads(capsys.readouterr().out)}


@pytest.mark.slow
def test_sheets_say_whose_they_are(course: Path, folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    found = rows(capsys, str(course), str(folder))
    assert set(found) == {"IMG_1.jpg", "IMG_2.jpg", "IMG_3.png", "петрова скорости.jpg"}
    told = {name: (one.get("whose", ""), one.get("plan"), one["verdict"]) for name, one in found.items()}
    assert told["IMG_1.jpg"] == ("Петрова Анна, Б", "velocity", "right")
    assert told["IMG_2.jpg"] == ("Иванов Пётр, А", "velocity", "wrong")
    assert told["петрова скорости.jpg"] == ("Петрова Анна", "velocity", "right")
    assert told["IMG_3.png"] == ("", None, "unreadable") and "whose is it?" in found["IMG_3.png"]["sentence"]["en"]
    assert found["IMG_2.jpg"]["mistake"] == "omega1_reversed"


def test_counts_that_add_up_to_the_files_come_before_what_is_counted_twice() -> None:
    work = ClassWork("photos", "en")
    work.rows = [ClassRow(f"{k}.jpg", *row) for k, row in enumerate([("right", 3), ("wrong", 1), ("unreadable", 0)])]
    counts = re.findall(r"<span>([^<]+) <b>(\d)</b></span>", work.page_html())
    assert sum(int(count) for _, count in counts[:-1]) == 3
    assert counts[-1] == ("of these, to be checked by hand", "1")


@pytest.mark.slow
def test_each_blank_of_a_picture_is_a_sheet(
    course: Path, pictures: dict[str, Any], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """One of them was lost, and the other could be judged by the corner marks of both."""
    folder = tmp_path / "photos"
    folder.mkdir()
    cv2.imwrite(str(folder / "IMG_1.jpg"), np.vstack([pictures["wrong"], pictures["right"]]))
    cv2.imwrite(str(folder / "IMG_2.jpg"), np.hstack([np.rot90(pictures[k]) for k in ("wrong", "right")]))
    true = prepare(Asked(load(course / "out/teacher" / BORIS / "scene.yaml"), "velocity")).true_marks
    marks = "".join(f"{name},{z.real:.3f},{z.imag:.3f}\n" for name, z in {"p": 0j, **true}.items())
    (folder / "IMG_2-1.csv").write_text(f"mark,x_mm,y_mm\n{marks}", "utf-8")
    found = rows(capsys, str(course), str(folder))
    told = {name: (one["whose"], one["verdict"]) for name, one in found.items()}
    boris, anna = "Иванов Пётр, А", "Петрова Анна, Б"
    assert told == {
        "IMG_1-1.jpg": (boris, "wrong"),
        "IMG_1-2.jpg": (anna, "right"),
        "IMG_2-1.jpg": (boris, "right"),  # its marks were put right by hand
        "IMG_2-2.jpg": (anna, "right"),
    }


def test_a_mark_says_what_is_asked() -> None:
    handed = HandedOut((Task(TWELVE, TWELVE.stem),))
    sorter = Sorter(handed, lambda scene, plan, value, mu: Asked(scene, plan, value, mu), plan="acceleration")
    sheet = HandedSheet(Path("IMG_1.jpg"))
    _, asked, whose = sorter.identify_question(sheet, SheetMark("12", "Б", "Ким", "force:2-3", 45.0, 0.5))
    assert (asked.scene.variant, asked.plan, asked.value, asked.mu, whose) == ("Б", "force:2-3", 45.0, 0.5, "Ким, Б")
    _, asked, whose = sorter.identify_question(HandedSheet(Path("Ким вариант А скорости.jpg")), None)
    assert (asked.scene.variant, asked.plan, asked.value, whose) == ("А", "velocity", None, "А")
    assert sorter.identify_question(sheet, None)[1].plan == "acceleration"  # the options are left
    for mark in (SheetMark("13", "А", "", "velocity"), SheetMark("12", "Я", "", "velocity")):
        with pytest.raises(PlanesError):
            sorter.identify_question(sheet, mark)


def test_what_was_judged_before_stands(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scene, folder, out = str(ROOT / "samples/six-link.yaml"), tmp_path / "tables", tmp_path / "out"
    folder.mkdir()
    for name in ("anna", "boris"):
        (folder / f"{name}.csv").write_text("mark,x_mm,y_mm\np,0,0\nb,30,51.96\nc,20,8\n", "utf-8")
    line = (scene, str(folder), "--plan", "velocity", "-o", str(out))
    before = rows(capsys, *line)
    made = {f: f.stat().st_mtime_ns for f in out.rglob("*.html")}
    (folder / "boris.csv").write_text("mark,x_mm,y_mm\np,0,0\nb,31,51.96\nc,20,8\n", "utf-8")
    after = rows(capsys, *line)
    assert after["anna.csv"] == before["anna.csv"] and after["boris.csv"] != before["boris.csv"]
    written = {f.name for f, when in made.items() if f.stat().st_mtime_ns != when}
    assert written == {"boris.csv.html", "index.html"}
    rows(capsys, *line, "--mu", "25 mm/(m/s)")
    assert all(f.stat().st_mtime_ns != when for f, when in made.items())  # the options too


@pytest.mark.slow
def test_only_what_has_changed_is_judged_anew(
    course: Path, folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    judged: list[str] = []

    def watching(asked: Any, paper: Any) -> Any:
        judged.append(Path(paper.file).name)
        return kept(asked, paper)

    kept = command.judge
    monkeypatch.setattr(command, "judge", watching)
    own = tmp_path / "course"
    shutil.copytree(course, own)
    out = tmp_path / "out"

    def run() -> tuple[list[str], dict[str, Json]]:
        judged.clear()
        found = rows(capsys, str(own), str(folder), "-o", str(out))
        return sorted(judged), found

    first, before = run()
    assert first == ["IMG_1.jpg", "IMG_2.jpg", "петрова скорости.jpg"]
    page = (out / "index.html").read_text("utf-8")
    assert run() == ([], before) and (out / "index.html").read_text("utf-8") == page
    marks = "mark,x_mm,y_mm,error_mm\np,0,0,0.2\n"
    scene = load(own / "out/teacher" / BORIS / "scene.yaml")
    right = Asked(scene, "velocity")
    for name, z in prepare(right).true_marks.items():
        marks += f"{name},{z.real:.3f},{z.imag:.3f},0.3\n"
    (folder / "IMG_2.csv").write_text(f"# planes check x\n# box -1 -2 3 4\n{marks}", "utf-8")
    again, after = run()  # marks put right in its report
    assert again == ["IMG_2.jpg"] and after["IMG_2.jpg"]["verdict"] == "right" and "IMG_2.csv" not in after
    assert "corrected by hand" in " ".join(after["IMG_2.jpg"]["warnings"])
    assert "data:image/jpeg" in (out / "IMG_2.jpg.html").read_text("utf-8")  # the picture still lies under them
    seen = cv2.imread(str(folder / "IMG_1.jpg"), cv2.IMREAD_GRAYSCALE)
    look = open_picture(str(folder / "IMG_1.jpg"))
    assert look and f'data-look="{look.pixel_hash}"' in (out / "IMG_1.jpg.html").read_text("utf-8")
    (folder / "IMG_1.csv").write_text(f"# sheet {look.pixel_hash} IMG_1.csv\nmark,x_mm,y_mm\np,0,0\nb,5,5\n", "utf-8")
    shutil.copy(folder / "IMG_1.csv", folder / "IMG_1 (1).csv")  # as a browser calls what is saved twice
    cv2.imwrite(str(folder / "IMG_1.jpg"), seen[:, 20:])
    again, after = run()  # the picture is another one since the marks were saved
    assert again == ["IMG_1.jpg"] and after["IMG_1.jpg"]["verdict"] == "right"
    assert "not used" in " ".join(after["IMG_1.jpg"]["warnings"]) and "IMG_1.csv" not in after
    assert "not used" in (out / "index.html").read_text("utf-8")
    assert "Name the table IMG_1.csv" in after["IMG_1 (1).csv"]["sentence"]["en"]
    file = own / "out/teacher" / BORIS / "scene.yaml"
    file.write_text(f"{file.read_text('utf-8')}\n", "utf-8")
    assert run()[0] == ["IMG_2.jpg"]
    (out / "rows" / "IMG_1.jpg.json").write_text("{}", "utf-8")
    (folder / "петрова скорости.jpg").unlink()
    assert run()[0] == ["IMG_1.jpg"] and not (out / "петрова скорости.jpg.html").exists()


@pytest.mark.slow
def test_the_page_shows_wrong_places_beside_the_right_construction(
    browser: Any, course: Path, folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    assert main(["check", str(course / "course.yaml"), str(folder), "-o", str(out), "--lang", "ru"]) == 2
    assert len((out / "index.html").read_bytes()) < 120_000
    page = browser.new_page()
    errors = watched(page)
    page.goto((out / "index.html").as_uri())
    names = "[...document.querySelectorAll('tbody th')].map(e => e.textContent)"
    assert page.evaluate(names) == ["IMG_3.png", "IMG_2.jpg", "IMG_1.jpg", "петрова скорости.jpg"]
    loaded = "[...document.images].map(e => e.naturalWidth > 60)"
    assert page.evaluate(loaded) == [True] * 4
    place = page.locator("tr.wrong .place")
    assert place.count() >= 1 and place.first.locator("image").count() == 1
    assert place.first.locator("svg svg").nth(1).locator(".true line").count() > 3
    assert page.get_attribute("th a >> text=IMG_3.png", "href").endswith("/photos/IMG_3.png")
    page.set_viewport_size({"width": 390, "height": 800})
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    assert page.evaluate("document.querySelector('tr.wrong .places').clientWidth") > 330
    page.emulate_media(media="print")
    shown = "[...document.querySelectorAll('thead th')].map(e => getComputedStyle(e, '::before').content)"
    assert '"файл"' in page.evaluate(shown) and not page.is_visible("thead button")
    printed_page = pypdfium2.PdfDocument(page.pdf(prefer_css_page_size=True))
    images = [one.get_bounds() for sheet in printed_page for one in sheet.get_objects(max_depth=9) if one.type == IMAGE]
    assert len(images) >= 4 + place.count() and all(right - left > 30 for left, _, right, _ in images)
    page.emulate_media(media="screen")
    page.click("th a >> text=IMG_2")
    assert page.get_attribute("#save", "data-name") == "IMG_2.csv"
    page.close()
    assert errors == []


@pytest.mark.slow
def test_every_page_of_a_scan_is_a_sheet(
    course: Path, tmp_path: Path, pictures: dict[str, Any], capsys: pytest.CaptureFixture[str]
) -> None:
    whole, file = pypdfium2.PdfDocument.new(), tmp_path / "scan.pdf"
    for seen in (pictures["right"], pictures["wrong"]):
        jpeg = tmp_path / "page.jpg"
        cv2.imwrite(str(jpeg), seen)
        image = pypdfium2.PdfImage.new(whole)
        image.load_jpeg(str(jpeg), inline=True)
        w, h = seen.shape[1] * 72 / DPI, seen.shape[0] * 72 / DPI
        image.set_matrix(pypdfium2.PdfMatrix().scale(w, h))
        page = whole.new_page(w, h)
        page.insert_obj(image)
        page.gen_content()
    whole.save(file)
    found = rows(capsys, str(course), str(file))
    told = {name: (one.get("whose"), one["verdict"].removesuffix("_as_seen")) for name, one in found.items()}
    assert told == {"scan-1.pdf": ("Петрова Анна, Б", "right"), "scan-2.pdf": ("Иванов Пётр, А", "wrong")}
    cv2.imwritemulti(str(tmp_path / "scan.tif"), [pictures["right"], pictures["wrong"]])
    again = rows(capsys, str(course), str(tmp_path / "scan.tif"))
    assert [one["verdict"].removesuffix("_as_seen") for one in again.values()] == ["right", "wrong"]


@pytest.mark.few(1)
@pytest.mark.parametrize(
    "mark",
    [
        SheetMark("../../../../etc/passwd", "", "../../secret", "velocity"),
        SheetMark("12", "А", "<img src=x onerror=window.XSS=1>", "velocity"),
        SheetMark("12", "А", "Я" * 500, "velocity"),
        SheetMark("12", "А", BORIS, "../../x"),
        SheetMark("12", "А", BORIS, "force:9-9"),
    ],
)
def test_a_mark_leads_to_no_other_file(
    mark: SheetMark, course: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A code somebody has pasted over the blank's own: whatever it says, it is refused in a sentence."""
    scene = load(course / "out/teacher" / BORIS / "scene.yaml")
    marks, title = blank_marks(Asked(scene, "velocity"), "ru", mark=mark)
    data = pdf.write_png(marks, SHEET_MM, title, dpi=DPI)
    (photos := tmp_path / "photos").mkdir()
    cv2.imwrite(str(photos / "a.png"), scanned(cv2.imdecode(np.frombuffer(data, np.uint8), cv2.IMREAD_GRAYSCALE)))
    opened, read = list[str](), Path.open
    monkeypatch.setattr(Path, "open", lambda self, *a, **k: (opened.append(str(self)), read(self, *a, **k))[1])
    found = rows(capsys, str(course), str(photos))
    assert found["a.png"]["verdict"] == "unreadable" and found["a.png"]["sentence"]["en"].count("\n") == 0
    assert not any("etc" in name or "secret" in name for name in opened)


def test_names_of_files_tell_what_marks_do_not(course: Path) -> None:
    handed = scenes_handed_out(course)
    assert {t.student for t in handed.tasks} == {ANNA, BORIS}
    named = {
        stem: (t.student if (t := handed.task_of_file_name(stem)) else None)
        for stem in ("Петрова", "анна петрова 2", "ИВАНОВ")
    }
    assert named == {"Петрова": ANNA, "анна петрова 2": ANNA, "ИВАНОВ": BORIS}
    assert handed.task_of_file_name("IMG_2026") is None and handed.task_of_file_name("../Петров") is None
    twins = HandedOut(tuple(Task(Path("x"), "", f"Ким-{name}") for name in ("Анна", "Олег")))
    assert twins.task_of_file_name("ким") is None and twins.task_of_file_name("ким олег") == twins.tasks[1]
    scene = handed.tasks[0].scene_in_variant(None)
    assert (
        plan_in_file_name("план скоростей", scene) == "velocity"
        and plan_in_file_name("force 2-3", scene) == "force:2-3"
    )
    assert plan_in_file_name("IMG_3", scene) is None and plan_in_file_name("скорости и ускорения", scene) is None
    assert (
        variant_in_file_name("Ким вариант 2", ("1", "2", "12")) == "2"
        and variant_in_file_name("IMG_2", ("1", "2")) is None
    )


@pytest.mark.slow
def test_variants_of_one_scene_by_their_blanks(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = ROOT / "samples/assignments/12.yaml"
    (photos := tmp_path / "photos").mkdir()
    for name, variant in (("a", "А"), ("b", "Б")):
        blank = tmp_path / f"{variant}.pdf"
        assert main(["blank", str(file), "--variant", variant, "--plan", "velocity", "-o", str(blank)]) == 0
        seen = scanned(drawn(printed(blank), load(file, variant), "velocity"))
        cv2.imwrite(str(photos / f"{name}.png"), seen)
    found = rows(capsys, str(file), str(photos))
    assert {name: (one["whose"], one["verdict"]) for name, one in found.items()} == {
        "a.png": ("А", "right_as_seen"),  # a mark whose ink a mistake would leave, too
        "b.png": ("Б", "right"),
    }
    assert main(["check", str(file), str(photos / "b.png"), "--lang", "en"]) == 0  # one sheet needs no plan either
    elsewhere = rows(capsys, str(ROOT / "samples/six-link.yaml"), str(photos))
    assert "which are not among those asked for" in elsewhere["a.png"]["sentence"]["en"]


REFUSED = {
    "phone.heic": (b"\0\0\0\x18ftypheic" + bytes(99), "save a picture as .jpg (iPhone"),
    "renamed.jpg": (b"\0\0\0\x18ftypmif1" + bytes(99), "save a picture as .jpg (iPhone"),
    "moving.gif": (b"GIF89a" + bytes(99), "save the picture as .jpg or .png"),
    "raw.dng": (b"II*\0" + bytes(99), "export the picture as .jpg"),
    "report.docx": (b"PK\x03\x04" + bytes(99), "unpack it"),
    "empty.jpg": (b"", "the file is empty; send it again"),
    "cut.jpg": (b"\xff\xd8\xff\xe0" + bytes(99), "ends too early"),
    "cut.png": (b"\x89PNG\r\n\x1a\n" + bytes(99), "ends too early"),
    "letters.jpg": (b"hello" * 99, "save it again as JPEG or PNG"),
}


def test_every_refusal_says_what_to_do(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name, (data, _) in REFUSED.items():
        (tmp_path / name).write_bytes(data)
    found = rows(capsys, str(ROOT / "samples/six-link.yaml"), str(tmp_path), "--plan", "velocity")
    for name, (_, remedy) in REFUSED.items():
        assert remedy in found[name]["sentence"]["en"], name


def test_what_came_twice_and_whose_did_not_come(
    course: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (photos := tmp_path / "photos").mkdir()
    for name in ("Петрова скорости.csv", "Петрова скорости 2.csv", "Петрова ускорения.csv"):
        (photos / name).write_text("mark,x_mm,y_mm\np,0,0\nb,30,51.96\nc,20,8\n", "utf-8")
    main(["check", str(course), str(photos), "--lang", "en", "-o", str(tmp_path / "out")])
    told = capsys.readouterr().out.splitlines()
    again = [line.split(".csv")[0].strip() for line in told if "The same plan of the same student: " in line]
    assert again == ["Петрова скорости 2", "Петрова скорости"]
    assert told[-1] == "Nothing received from: Иванов Пётр."
    own = (course / "out" / "teacher" / BORIS / "scene.yaml").read_text("utf-8")
    (tmp_path / "own.yaml").write_text(own.replace("Иванов Пётр", "Иванов П. С."), "utf-8")
    work = ClassWork("", "en", tasks=(Task(tmp_path / "own.yaml", "", BORIS),))
    assert work.students_without_drawing() == "Иванов П. С"  # and the sentence ends with its own full stop
    page = (tmp_path / "out" / "index.html").read_text("utf-8")
    assert told[-1] in page and page.count("The same plan of the same student") == 2
    (photos / "Иванов скорости.csv").write_text("mark,x_mm,y_mm\np,0,0\nb,30,51.96\nc,20,8\n", "utf-8")
    main(["check", str(course), str(photos), "--lang", "en"])
    assert "No drawing has come" not in capsys.readouterr().out


def test_every_page_of_a_file_is_read_once(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whichever of them holds the plan; of several that do a report of one is refused when they have been told."""
    file, table = tmp_path / "scans.tif", tmp_path / "t.csv"
    assert cv2.imwritemulti(str(file), [np.full((60, 60), 250, np.uint8)] * 4)
    six = ROOT / "samples/six-link.yaml"
    marks = prepare(Asked(load(six), "velocity")).true_marks
    rows_ = (f"{name},{z.real},{z.imag}" for name, z in marks.items())
    table.write_text("\n".join(("mark,x_mm,y_mm", "p,0,0", *rows_)), "utf-8")
    pages, drawn_on = list[int | None](), {3}

    def reading(sheet: HandedSheet, asked: Asked, known: Known) -> Any:
        pages.append(sheet.page)
        if sheet.page not in drawn_on:
            raise PlanesError("nothing")
        return read_paper(str(table), asked, known)

    monkeypatch.setattr(command, "read_sheet_marks", reading)
    line = ["check", str(six), str(file), "--plan", "velocity", "--lang", "en"]
    assert main(line) == 0 and pages == [1, 2, 3, 4]
    assert "Page 3 of 4 was checked" in capsys.readouterr().out
    drawn_on.add(1)
    assert main([*line, "-o", str(tmp_path / "report.pdf")]) == 2 and not (tmp_path / "report.pdf").exists()
    told = capsys.readouterr()
    assert told.out.count("scans-") == 4 and "report.pdf" in told.err


def test_a_course_that_was_not_made_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "students.txt").write_text("Anna\n", "utf-8")
    (tmp_path / "photos").mkdir()
    assert main(["check", str(tmp_path), str(tmp_path / "photos"), "--lang", "en"]) == 2
    assert "make it first: planes course" in capsys.readouterr().err


def test_a_table_copied_from_another_student_is_told_to_be(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Whose it is, in place of a cause: though one of nine numbers is a per cent off, and the tasks are much alike."""
    for name in ("course", "six-link"):
        assert main(["new", name, "-o", str(tmp_path / f"{name}.yaml"), "--lang", "en"]) == 0
    text = (tmp_path / "course.yaml").read_text("utf-8").replace("[scene.yaml]", "[six-link.yaml]")
    (tmp_path / "course.yaml").write_text(text.replace("[task, blank, key]", "[blank]"), "utf-8")
    (tmp_path / "students.txt").write_text("\n".join(["Ann Lee", "Bob Ray", "Eve Fox", "Ian Kay", "Joe Orr"]), "utf-8")
    assert main(["course", str(tmp_path / "course.yaml"), "-o", str(tmp_path / "out"), "--jobs", "1"]) == 0
    numbers = "omega_2;3,32 epsilon_2;10,5 omega_3;1,4 epsilon_3;-32,3 omega_4;0,662 epsilon_4;-14 v_F;0,47 a_F;11,1"
    (folder := tmp_path / "in").mkdir()
    for name in ("Bob-Ray", "Joe-Orr"):
        (folder / f"{name}.csv").write_text("\n".join(["result;value", *numbers.split()]), "utf-8")
    found = rows(capsys, str(tmp_path / "out"), str(folder))
    assert found["Bob-Ray.csv"]["verdict"] == "right_as_seen"  # M_1 is missing
    assert found["Joe-Orr.csv"]["verdict"] == "wrong"
    assert "Bob Ray" in str(found["Joe-Orr.csv"])


@pytest.mark.slow
def test_a_vector_astray_is_the_one_it_is_nearest_to(tmp_path: Path) -> None:
    """The end of e and of S5 is drawn twice, once 9 mm off; it is not taken for a mark 80 mm away."""
    assert main(["blank", str(TWELVE), "--variant", "Г", "--plan", "velocity", "-o", str(tmp_path / "b.pdf")]) == 0
    asked = Asked(load(TWELVE, variant="Г"), "velocity")
    sheet = drawn(printed(tmp_path / "b.pdf"), asked.scene, "velocity", lambda right: {**right, "s5": right["s5"] + 9})
    cv2.imwrite(str(tmp_path / "astray.jpg"), scanned(sheet))
    out = check(asked, read_paper(str(tmp_path / "astray.jpg"), asked, Known()))
    assert out.first_wrong in ("e", "s5")


@pytest.mark.slow
def test_a_mark_upon_another_that_a_mistake_hides_is_not_called_seen(tmp_path: Path) -> None:
    """S3 stands at the end of b3; begun from the wrong end it is at the pole, which leaves the same ink."""
    assert main(["blank", str(TWELVE), "--variant", "Г", "--plan", "velocity", "-o", str(tmp_path / "b.pdf")]) == 0
    asked = Asked(load(TWELVE, variant="Г"), "velocity")
    sheet = drawn(printed(tmp_path / "b.pdf"), asked.scene, "velocity", lambda right: {**right, "s3": 0.2j})
    cv2.imwrite(str(tmp_path / "hidden.jpg"), scanned(sheet))
    paper = read_paper(str(tmp_path / "hidden.jpg"), asked, Known())
    out = check(asked, paper)
    assert out.verdict == "right_as_seen" and "s3" in out.unseen
    (table := tmp_path / "hidden.csv").write_text("mark,x_mm,y_mm\n", "utf-8")
    bound = prepare(asked).said_mu  # a blank's own scale is the only one, though it is the scene's
    assert (paper.mu, out.bench.asked.mu, combine_with_picture(ReadPaper(str(table)), paper).mu) == (
        bound,
        bound,
        bound,
    )


def practice(scene: Path, name: str, right: int = 0) -> str:
    """The code of a practice that was given up at once."""
    told = SceneLesson.of(load(scene)).practice
    data = {
        "id": told.practice_id,
        "seed": 0,
        "right": right,
        "name": name,
        "answers": [None] * len(told.practice_items()),
    }
    letters = json.dumps(data, ensure_ascii=False).encode()
    return f"planes-practice.{base64.urlsafe_b64encode(letters).decode()}.{fnv_checksum(letters):08x}"


@pytest.mark.slow
def test_practices_and_drawings_are_one_table(course: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A practice is found by the name in its code, a drawing by that of its file; one table, the worst status."""
    folder, out = tmp_path / "back", tmp_path / "report"
    folder.mkdir()
    own = course / "out" / "teacher" / ANNA / "scene.yaml"
    assert main(["sheet", str(own), "--view", "velocity-plan", "-o", str(folder / "Петрова скорости.svg")]) == 0
    (folder / "1.practice").write_text(practice(own, "Петрова Анна"), "utf-8")
    assert main(["check", str(course), str(folder), "-o", str(out), "--lang", "en"]) == 0
    told = capsys.readouterr().out
    assert told.count("file  ") == 1 and "confirmed" in told and "0 of " in told and "right" in told
    for _ in range(2):  # the second run takes up what the first has kept
        found = rows(capsys, str(course), str(folder), "-o", str(out))
        assert {name: one["verdict"] for name, one in found.items()} == {
            "1.practice": "confirmed",
            "Петрова скорости.svg": "right",
        }
    assert found["1.practice"]["right"] == 0 and found["1.practice"]["name"] == "Петрова Анна"
    assert "1.practice" in (out / "index.html").read_text("utf-8")
    (folder / "2.practice").write_text(practice(own, "Петрова Анна", 5), "utf-8")
    (folder / "3.practice").write_text(practice(own, "Сидоров"), "utf-8")
    (folder / "4.practice").write_text("planes-practice.x.0", "utf-8")
    (folder / "Иванов скорости.svg").write_bytes((folder / "Петрова скорости.svg").read_bytes())
    assert main(["check", str(course), str(folder), "--lang", "en"]) == 2
    said = {line.split()[0]: line for line in capsys.readouterr().out.splitlines() if ".practice" in line}
    assert "altered" in said["2.practice"] and "whose is it" in said["3.practice"] and "damaged" in said["4.practice"]
    for name in ("2.practice", "3.practice", "4.practice"):
        (folder / name).unlink()
    assert main(["check", str(course), str(folder)]) == 1  # the drawing of another's numbers is wrong


@pytest.mark.slow
def test_work_that_is_right_for_another_student_is_said_to_be(course: Path, tmp_path: Path, capsys: Any) -> None:
    """Numbers and a plan of somebody else's variant; of numbers that are merely wrong nobody is named."""
    boris = load(course / "out" / "teacher" / BORIS / "scene.yaml")
    position = solve(boris).positions[0]
    numbers = [
        (f.quantity.name, abs(f.vector))
        for f in position.found
        if f.quantity.json_path[0] == "points" and f.quantity.key == "v"
    ]
    numbers = [(name, size) for name, size in numbers if size > 1e-3]
    assert len(numbers) >= 3
    for name, share in (("петрова", 1.0), ("петрова скорости", 1.31)):
        table = "\n".join(f"{n},{share * x:.4g}" for n, x in numbers)
        (tmp_path / f"{name}.csv").write_text(f"result,value\n{table}\n", "utf-8")
    marks = {"p": 0j, **prepare(Asked(boris, "velocity")).true_marks}
    table = "\n".join(f"{n},{z.real:.2f},{z.imag:.2f}" for n, z in marks.items())
    (tmp_path / "анна петрова velocity.csv").write_text(f"mark,x,y\n{table}\n", "utf-8")
    found = rows(capsys, str(course), str(tmp_path))
    said = {name: "Иванов Пётр" in " ".join(one["warnings"]) for name, one in found.items()}
    assert {one["verdict"] for one in found.values()} <= {"wrong", "unreadable"}
    assert said == {"петрова.csv": True, "петрова скорости.csv": False, "анна петрова velocity.csv": True}
