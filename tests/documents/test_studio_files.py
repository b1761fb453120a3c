"""Files that a person chooses or drops in the studio: scenes, folders of them, pictures, drawings to check, others."""

from __future__ import annotations

import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

from planes.cli import main
from tests.helpers import ROOT
from tests.helpers.browser import until
from tests.helpers.studios import SEEN, behind_files, served

SIX = ROOT / "samples" / "six-link.yaml"
TEMPLATES = ROOT / "planes" / "templates"
KEPT = "JSON.parse(localStorage.getItem('planes.scenes') ?? '[]')"
STATE = "document.getElementById('state').textContent"
ALERTED = "globalThis.alerted"


@pytest.fixture(scope="module")
def address(browser: Any) -> Iterator[str]:
    pytest.importorskip("uvicorn", reason="install the test extra: pip install -e '.[test]'")
    with served() as found:
        browser.new_page().goto(found)
        yield found.split("?")[0]


@pytest.fixture
def page(browser: Any, address: str) -> Iterator[Any]:
    """The gallery of a person who has opened nothing yet."""
    page = browser.new_page(viewport={"width": 1400, "height": 900})
    page.errors = []
    page.on("pageerror", page.errors.append)
    page.goto(address)
    page.evaluate("localStorage.clear()")
    until(page, "document.querySelectorAll('[data-scene]').length > 5")
    yield page
    assert page.errors == []
    page.close()


def gallery(page: Any) -> None:
    page.locator("#views [data-view=gallery]").click()


def opened_six(page: Any) -> None:
    page.drop_files("#gallery-title", str(SIX))
    until(page, f"{SEEN} && engine.idle() && document.querySelectorAll('#plan option').length > 2")


def picture(path: Path, kind: str = "PNG") -> str:
    Image.new("RGB", (400, 300), "white").save(path, kind)
    return str(path)


def drawing(path: Path) -> str:
    """The sheet of the six-link mechanism, whose plans are right, in the format of a file."""
    assert main(["sheet", str(SIX), "-o", str(path), "--lang", "en"]) == 0
    return str(path)


def test_a_folder_of_scenes_is_chosen_and_saved_again(page: Any, tmp_path: Path) -> None:
    """With its subfolders and other files; what is saved is a folder in an archive, and that is opened elsewhere."""
    texts = {name: (TEMPLATES / f"{name}.yaml").read_text("utf-8") for name in ("four-bar", "crank-slider")}
    (tmp_path / "course" / "week 2").mkdir(parents=True)
    (tmp_path / "course" / "four-bar.yaml").write_text(texts["four-bar"], "utf-8")
    (tmp_path / "course" / "week 2" / "crank-slider.yml").write_text(texts["crank-slider"], "utf-8")
    (tmp_path / "course" / "notes.txt").write_text("no scene", "utf-8")
    picture(tmp_path / "course" / "photo.png")
    page.set_input_files("#folder-in", str(tmp_path / "course"))
    until(page, f"{SEEN} && engine.idle() && {KEPT}.length === 2")
    assert {one["text"] for one in page.evaluate(KEPT)} == {*texts.values()}
    gallery(page)
    assert page.locator("#kept .card").count() == 2
    with page.expect_download() as saving:
        page.locator("#files-out").click()
    saving.value.save_as(str(tmp_path / "out.zip"))
    with zipfile.ZipFile(tmp_path / "out.zip") as saved:
        assert {saved.read(name).decode() for name in saved.namelist()} == {*texts.values()}
        saved.extractall(tmp_path / "again")
    page.evaluate("localStorage.clear()")
    page.set_input_files("#folder-in", str(tmp_path / "again"))
    until(page, f"engine.idle() && {KEPT}.length === 2")
    assert {one["text"] for one in page.evaluate(KEPT)} == {*texts.values()}


def test_a_folder_without_scenes_is_refused_in_words(page: Any, tmp_path: Path) -> None:
    for name in ("one.png", "two.png"):
        picture(tmp_path / name)
    page.set_input_files("#folder-in", str(tmp_path))
    until(page, f"/A scene ends in .yaml/.test({STATE})")
    assert page.evaluate("bench.view") == "gallery"


def test_scenes_are_dropped(page: Any) -> None:
    """One opens; of several the first does, and all are in the history."""
    opened_six(page)
    assert page.evaluate("bench.text") == SIX.read_text("utf-8")
    gallery(page)
    page.drop_files("#gallery-title", *(str(TEMPLATES / f"{name}.yaml") for name in ("four-bar", "crank-slider")))
    until(page, f"engine.idle() && {KEPT}.length === 3")
    assert page.evaluate("bench.text") == (TEMPLATES / "four-bar.yaml").read_text("utf-8")


@pytest.mark.few(1)
@pytest.mark.parametrize("kind", ["PNG", "JPEG", "WEBP"])
def test_a_picture_dropped_in_the_gallery_lies_beneath_a_new_mechanism(page: Any, tmp_path: Path, kind: str) -> None:
    """And the tool that gives it its size is in hand."""
    page.drop_files("#gallery-title", picture(tmp_path / f"photo.{kind.lower()}", kind))
    until(page, "canvas.under?.ratio === 0.75")
    assert page.evaluate("[bench.view, canvas.tool, bench.text]") == ["draw", "measure", ""]
    assert page.locator("#canvas image").count() == 1


def test_a_picture_or_a_vector_drawing_is_dropped_on_the_canvas(page: Any, tmp_path: Path) -> None:
    """Beneath the mechanism that is open; scripts in an SVG do not run."""
    opened_six(page)
    page.locator("#views [data-view=draw]").click()
    page.drop_files("#canvas", picture(tmp_path / "scan.png"))
    until(page, "canvas.under?.ratio === 0.75")
    svg = '<svg xmlns="http://www.w3.org/2000/svg" width="200" height="100" onload="parent.alerted = 1">'
    (tmp_path / "drawn.svg").write_text(f"{svg}<script>parent.alerted = 1</script><path d='M0 0h9'/></svg>")
    page.drop_files("#canvas", str(tmp_path / "drawn.svg"))
    until(page, "canvas.under?.ratio === 0.5")
    assert page.evaluate(f"{ALERTED} === undefined") and page.evaluate("bench.text") == SIX.read_text("utf-8")


@pytest.mark.parametrize("name", ["photo.jpg", "photo.heic"])
def test_a_picture_that_is_none_is_refused_in_words(page: Any, tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_bytes(b"\xff\xd8\xff\xe0 no picture")
    gallery(page)
    page.drop_files("#gallery-title", str(tmp_path / name))
    until(page, f"{STATE}.length > 20")
    assert page.evaluate("canvas.under") is None
    assert name in page.inner_text("#state") if name.endswith("jpg") else page.inner_text("#state")


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["svg", "dxf", "csv", "png"])
def test_a_drawing_dropped_beside_its_mechanism_is_checked(page: Any, tmp_path: Path, kind: str) -> None:
    """A vector drawing, a table of marks, a scan: there is a verdict, and another one for another plan."""
    opened_six(page)
    file = tmp_path / f"mine.{kind}"
    if kind == "csv":
        file.write_text("mark,x,y\nb,1,2\nc,3,4\n")
    else:
        drawing(file)
    page.select_option("#plan", "velocity")
    page.drop_files("#see", str(file))
    until(page, f"!document.getElementById('verdict').hidden || {STATE}.length > 20")
    assert page.evaluate(f"!document.getElementById('verdict').hidden || !/Traceback/.test({STATE})")
    if kind in ("svg", "dxf"):
        first = page.get_attribute("#verdict", "src")
        page.select_option("#plan", "acceleration")
        until(page, f"document.getElementById('verdict').getAttribute('src') !== '{first}' && {STATE} === ''")


HOSTILE = {
    "program.exe": b"MZ\x90\x00" + bytes(300),
    "archive.zip": b"PK\5\6" + b"\xff" * 40,
    "page.html": b"<script>parent.alerted = 1</script>",
    "table.csv": b"\x00\xff\xfe" * 200,
    "drawing.dxf": b"no drawing at all",
    "drawing.svg": b"<svg xmlns='http://www.w3.org/2000/svg'><!ENTITY x SYSTEM 'file:///etc/passwd'>&x;",
    "<img src=x onerror=alerted=1>.bin": b"x",
    "empty": b"",
}


@pytest.mark.few(2)
@pytest.mark.parametrize("name", HOSTILE)
def test_a_hostile_file_is_refused_in_words(page: Any, tmp_path: Path, name: str) -> None:
    """Beside an open mechanism, which stays as it was."""
    opened_six(page)
    (tmp_path / name).write_bytes(HOSTILE[name])
    page.drop_files("#see", str(tmp_path / name))
    until(page, f"{STATE}.length > 20")
    said = page.inner_text("#state")
    assert "Traceback" not in said and "Error" not in said
    assert page.evaluate(f"{ALERTED} === undefined") and page.evaluate("bench.text") == SIX.read_text("utf-8")
    assert page.locator("#verdict").count() and page.evaluate("document.getElementById('verdict').hidden")


@pytest.mark.few(1)
@pytest.mark.parametrize("name", ["program.exe", "drawing.dxf", "archive.zip"])
def test_a_hostile_file_in_the_gallery_is_refused_in_words(page: Any, tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_bytes(HOSTILE[name])
    page.drop_files("#gallery-title", str(tmp_path / name))
    until(page, f"/A scene ends in .yaml/.test({STATE})")


def test_a_dropped_folder_is_refused_in_words(page: Any, tmp_path: Path) -> None:
    """A browser hands it over as a file that cannot be read."""
    opened_six(page)
    page.drop_files("#see", str(tmp_path))
    until(page, f"/A scene ends in .yaml/.test({STATE})")


@pytest.mark.few(1)
@pytest.mark.parametrize("text", ["\x00\x01\x02", "a: &a [*a, *a]", "<html>", "[" * 3000, "planes: 1\ntitle: <b>x"])
def test_a_text_that_is_no_scene_has_its_error(page: Any, tmp_path: Path, text: str) -> None:
    (tmp_path / "scene.yaml").write_text(text)
    page.drop_files("#gallery-title", str(tmp_path / "scene.yaml"))
    until(page, "engine.idle() && document.querySelectorAll('#problems li').length > 0")
    assert page.inner_text("#problems") and "Traceback" not in page.inner_text("#problems")


@pytest.mark.slow
def test_a_studio_without_a_server_takes_a_picture_and_refuses_a_table(browser: Any, tmp_path: Path) -> None:
    """It has no checker: a picture goes beneath the drawing from whatever view, others are refused."""
    from planes.documents.studio import write_studio

    write_studio(str(tmp_path / "site"), "ru")
    with behind_files(tmp_path / "site") as where:
        page = browser.new_page(viewport={"width": 390, "height": 844})
        page.goto(where)
        until(page, "document.querySelectorAll('[data-scene]').length > 5")
        page.locator("[data-scene=four-bar]").click()
        until(page, SEEN)
        (tmp_path / "marks.csv").write_text("b,1,2\n")
        page.drop_files("#see", str(tmp_path / "marks.csv"))
        until(page, f"/yaml/.test({STATE})")
        assert "сцены" in page.inner_text("#state")
        page.drop_files("#see", picture(tmp_path / "photo.png"))
        until(page, "canvas.under?.ratio === 0.75")
        assert page.evaluate("bench.view") == "draw"
