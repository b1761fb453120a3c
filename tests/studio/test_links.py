"""A link holds a scene: Python and the page's script read each other's, and a QR code is read back off the paper."""

from __future__ import annotations

import base64
import json
import random
import shutil
import subprocess
import zlib
from pathlib import Path

import pytest

from planes.check.grading.prepared_plan import Asked
from planes.cli import main
from planes.documents.check import write_blank
from planes.documents.sheets import sheet_of
from planes.scene import loads
from planes.studio.links import (
    CODE_RIM_MODULES,
    LEAST_MODULE_MM,
    RAW_DEFLATE_WINDOW_BITS,
    code_module_mm,
    qr_code_cells,
    scene_text,
    studio_link,
    text_in_link_letters,
)
from planes.words.errors import SceneError
from render.sheet.studio_code import studio_code_view
from tests.helpers import ROOT

ADDRESS = "https://planes.example.org/studio/"
TEXT = (ROOT / "samples" / "kind-3-rpr.yaml").read_text("utf-8") + f"sheet: {{studio: '{ADDRESS}', number: '7'}}\n"
SHARE = (ROOT / "render" / "page" / "share.js").as_uri()
NODE = f"""
import {{ pressed, unpressed }} from "{SHARE}";
const texts = JSON.parse(process.argv[1]), found = [];
for (const [text, link] of texts) found.push([await unpressed(link), await pressed(text)]);
process.stdout.write(JSON.stringify(found));
"""


def unpressed(letters: str) -> str:
    """The text of a link, by the standard library."""
    return zlib.decompress(
        base64.urlsafe_b64decode(letters + "=" * (-len(letters) % 4)), RAW_DEFLATE_WINDOW_BITS
    ).decode()


@pytest.mark.skipif(not shutil.which("node"), reason="node is not here")
def test_the_page_reads_what_is_pressed_here_and_the_other_way_round() -> None:
    texts = [TEXT, "", "planes: 1\n# Пример ё 𝛚\n", scene_text(loads(TEXT))]
    argv = [
        "node",
        "--input-type=module",
        "-e",
        NODE,
        json.dumps([[text, text_in_link_letters(text)] for text in texts]),
    ]
    found = json.loads(subprocess.run(argv, capture_output=True, check=True, text=True, encoding="utf-8").stdout)
    for text, (opened, theirs) in zip(texts, found, strict=True):
        assert opened == text and unpressed(theirs) == text


def test_a_link_holds_the_same_mechanism_without_the_address() -> None:
    scene = loads(TEXT)
    address, _, letters = studio_link(scene).partition("#s=")
    text = unpressed(letters)
    again = loads(text)
    assert address == ADDRESS and again.mechanism == scene.mechanism
    assert dict(again.sheet) == {"number": "7"} and "#" not in text
    other = scene.with_parameters(l_AB=0.13)
    assert loads(scene_text(other)).mechanism == other.mechanism
    assert (
        studio_link(loads(TEXT.partition("sheet:")[0])) == ""
        and qr_code_cells(loads(TEXT.partition("sheet:")[0])) == []
    )


@pytest.mark.skipif(not shutil.which("node"), reason="node is not here")
def test_letters_that_are_no_scene_are_refused_by_the_page() -> None:
    asked = f'import {{ unpressed }} from "{SHARE}"; await unpressed(process.argv[1]);'
    for letters in ("*", "abc", "AAAA", "зззз"):
        argv = ["node", "--input-type=module", "-e", asked, letters]
        assert subprocess.run(argv, capture_output=True).returncode, letters


def test_what_no_code_holds_is_refused_in_a_sentence() -> None:
    draw = random.Random(4)
    note = "".join(draw.choices("abcdefghijklmnopqrstuvwxyz0123456789", k=4000))
    with pytest.raises(SceneError, match="177 modules"):
        qr_code_cells(loads(TEXT.replace("'7'", f"'{note}'")))
    count = len(qr_code_cells(loads(TEXT)))
    least = LEAST_MODULE_MM * (count + 2 * CODE_RIM_MODULES)
    assert code_module_mm(loads(TEXT), count, least, 0.4) == pytest.approx(LEAST_MODULE_MM)
    with pytest.raises(SceneError, match=f"{count} modules a side and needs {round(least)} mm"):
        code_module_mm(loads(TEXT), count, least - 0.1, 0.4)
    small = loads(TEXT.replace("'7'", f"'{note[:900]}', format: A3"))
    with pytest.raises(SceneError, match="larger format"):
        studio_code_view(small, "en")


@pytest.mark.parametrize("address", ["ftp://a.b", "https://a b", "https://a.b/#s=", "studio"])
def test_an_address_is_one_of_the_web(address: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "a.yaml"
    file.write_text(TEXT.replace(ADDRESS, address), "utf-8")
    assert main(["sheet", str(file), "-o", str(tmp_path / "a.svg"), "--lang", "en"]) == 2
    said = capsys.readouterr().err
    assert "sheet.studio" in said and "a.yaml:" in said and "https://" in said and said.count("\n") == 1


def read(pdf: Path) -> list[str]:
    """What the codes of a PDF say, page by page."""
    cv2, numpy = pytest.importorskip("cv2"), pytest.importorskip("numpy")
    from pypdfium2 import PdfDocument

    pages = [numpy.asarray(p.render(scale=300 / 72, grayscale=True).to_pil()) for p in PdfDocument(pdf)]
    looks = (cv2.QRCodeDetector(), cv2.QRCodeDetectorAruco())
    return [next(filter(None, (look.detectAndDecode(page)[0] for look in looks)), "") for page in pages]


@pytest.mark.slow
def test_a_sheet_and_a_blank_are_read_back(tmp_path: Path) -> None:
    scene = loads(TEXT)
    sheet_of(scene, None, "ru").write(tmp_path / "sheet.pdf")
    assert read(tmp_path / "sheet.pdf") == [studio_link(scene)]
    write_blank(Asked(scene, "velocity"), str(tmp_path / "blank.pdf"), "ru")
    front, back = read(tmp_path / "blank.pdf")
    assert front.startswith("planes2|") and back == studio_link(scene)


@pytest.mark.slow
def test_a_task_of_a_course_is_read_back(tmp_path: Path) -> None:
    (tmp_path / "scene.yaml").write_text(TEXT.partition("sheet:")[0], "utf-8")
    course = f"course: 1\nsheet: {{studio: '{ADDRESS}'}}\nassignments: [scene.yaml]\nstudents: [Anna Kern]\n"
    course += "documents: [task, blank]\n"
    (tmp_path / "course.yaml").write_text(course, "utf-8")
    assert main(["course", str(tmp_path), "-o", str(tmp_path / "out"), "--lang", "en"]) == 0
    (task,) = (tmp_path / "out").rglob("*task*.pdf")
    (said,) = [text for text in read(task) if text]
    assert said.startswith(f"{ADDRESS}#s=") and "Anna Kern" in unpressed(said.partition("#s=")[2])
