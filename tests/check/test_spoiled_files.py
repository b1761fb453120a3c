"""Files spoiled in every way and files without measure: one sentence, bounded work, no traceback."""

from __future__ import annotations

import json
import random
import struct
from pathlib import Path

import pytest

from planes.check.grading.paper import MOST_ROWS as MOST_ROWS
from planes.check.grading.paper import read_table
from planes.check.reading import strokes, svg
from planes.cli import main
from planes.words.errors import PlanesError
from tests.helpers import ROOT, line_drawings

SAMPLES = ROOT / "samples"
SCENE = str(SAMPLES / "kind-1-rrr.yaml")
HEAD = '<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 100 100">'
PAGE = (
    "%PDF-1.4\n1 0 obj<</Type/Catalog/Pages 2 0 R>>endobj 2 0 obj<</Type/Pages/Kids[3 0 R]/Count 1>>endobj "
    "3 0 obj<</Type/Page/Parent 2 0 R/MediaBox[0 0 144000000 1       ]/UserUnit 1000>>endobj\nxref\n0 4\n"
    "0000000000 65535 f \n0000000009 00000 n \n0000000053 00000 n \n0000000100 00000 n \n"
    "trailer<</Root 1 0 R/Size 4>>\nstartxref\n200\n%%EOF"
)
WITHOUT_GRAVITY = """\
planes: 1
frame: {points: {A: [0, 0], D: [0.4, 0]}}
links:
  1: {points: {A: 0, B: 0.1}, mass: 1, inertia: 0.1}
  2: {points: {B: 0, C: 0.3}, mass: 1, inertia: 0.1}
  3: {points: {D: 0, C: 0.35}, mass: 1, inertia: 0.1}
assembly: {C: left}
drive: {link: 1, phi: 60, omega: 10}
loads: [{link: 3, point: C, force: 100, direction: 0}]
gravity: 0
"""


def refusal(capfd: pytest.CaptureFixture[str], file: Path, plan: str = "velocity") -> str:
    """The one sentence a file is refused in."""
    assert main(["check", SCENE, str(file), "--plan", plan, "--lang", "en"]) == 2
    told = capfd.readouterr()
    assert told.out == "" and told.err.count("\n") == 1 and str(file) in told.err
    return told.err


@pytest.mark.few(2)
@pytest.mark.parametrize(
    "text",
    [
        '<text x="foo" y="1">p</text><line x1="0" y1="0" x2="10" y2="10" stroke="black"/>',
        '<text x="1" y="1" font-size="big">p</text>',
        '<g transform="matrix(1 2"><line x1="a" x2="9"/></g>',
        "<style>" + "a" * 100_000 + "</style>",
        '<g transform="' + "(" * 300_000 + '"/>',
        "<style>" + "g " * 20_000 + "x{fill:none}</style>",
        "<style>" + ":not(" * 20_000 + "a{fill:none} [ b{stroke:" + "(" * 20_000 + "</style>",
    ],
)
def test_words_where_numbers_are_due_are_no_numbers(text: str, tmp_path: Path) -> None:
    file = tmp_path / "t.svg"
    file.write_text(f"{HEAD}{text}</svg>", encoding="utf-8")
    svg.read_svg(file)


@pytest.mark.parametrize("encoding", ["utf-8", "utf-16"])
def test_entities_are_refused_wherever_they_stand(
    encoding: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "t.svg"
    declared = f'<?xml version="1.0" encoding="{encoding}"?>{" " * 9000}<!DOCTYPE svg [<!ENTITY a "b">]>'
    file.write_bytes(f"{declared}{HEAD}</svg>".encode(encoding))
    assert "declares entities" in refusal(capfd, file)


@pytest.mark.slow
def test_what_no_plan_has_so_many_of_is_counted(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    path = "".join(f"L{k % 90} {k % 77}" for k in range(strokes.MOST_STROKES + 9))
    texts = {
        "strokes": f'<path stroke="black" d="M0 0{path}"/>',
        "elements": "<g/>" * (svg.MOST_ELEMENTS + 1),
        "levels of nesting": "<g>" * 300 + "</g>" * 300,
        "rules for elements": "<style>" + "g * {fill:none}" * 100 + "</style>" + "<g/>" * 50_000,
        "elements ": f'<defs><path id="a" d="M0 0{"C1 1 2 3 4 5 " * 20_000}"/></defs>' + '<use href="#a"/>' * 20_000,
    }
    for what, text in texts.items():
        file = tmp_path / "t.svg"
        file.write_text(f"{HEAD}{text}</svg>", encoding="utf-8")
        assert what.strip() in refusal(capfd, file) and file.stat().st_size < svg.LARGEST_SVG_BYTES
    file.write_bytes(b" " * (svg.LARGEST_SVG_BYTES + 1))
    assert "larger than 12 MB" in refusal(capfd, file)
    for rows in ("mark,x_mm,y_mm\n" + "b,1,2\n", "result,value\n" + "v_B,1\n", "segment,mm\n" + "pb,1\n"):
        head, row = rows.splitlines()
        file = tmp_path / "t.csv"
        every = (f"\n{k}{row}" for k in range(MOST_ROWS + 1))
        file.write_text(head + "".join(every), encoding="utf-8")
        with pytest.raises(PlanesError, match=f"more than {MOST_ROWS} rows"):
            read_table(file)


@pytest.mark.parametrize(
    ("row", "said"),
    [
        ("b,10,5,0", "t.csv:3: the row has 4 cells under 3 columns"),
        ("a,1,2", 't.csv:3: "a" is already in an earlier row'),
    ],
)
def test_rows_that_would_be_read_otherwise_than_meant_are_refused(row: str, said: str, tmp_path: Path) -> None:
    file = tmp_path / "t.csv"
    file.write_text(f"mark,x_mm,y_mm\na,1,1\n{row}\n", encoding="utf-8")
    with pytest.raises(PlanesError) as refused:
        read_table(file)
    assert said in refused.value.told("en")


@pytest.mark.slow
def test_blocks_within_blocks_are_counted(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    import ezdxf

    document = ezdxf.new()
    for k in range(12):
        block = document.blocks.new(f"B{k}")
        for _ in range(10 if k else 0):
            block.add_blockref(f"B{k - 1}", (0, 0))
    document.modelspace().add_blockref("B11", (0, 0))
    document.saveas(file := tmp_path / "t.dxf")
    assert "more than" in refusal(capfd, file)


def test_a_broken_hatch_is_a_sentence(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    import ezdxf

    document = ezdxf.new("R2000")
    hatch = document.modelspace().add_hatch()
    hatch.paths.add_polyline_path([(0, 0), (1, 0), (1, 1)])
    document.saveas(file := tmp_path / "t.dxf")
    file.write_text(file.read_text(encoding="utf-8").replace("AcDbHatch\n", "AcDbWhat\n"), encoding="utf-8")
    assert main(["check", SCENE, str(file), "--plan", "velocity"]) == 2
    assert "Traceback" not in capfd.readouterr().err


def huge(kind: str) -> bytes:
    """A small file whose header promises a picture of 30000 pixels each way, or a page of no height."""
    import io
    import zlib

    from PIL import Image

    if kind == "pdf":
        return PAGE.encode()
    out = io.BytesIO()
    Image.new("L", (400, 300), 255).save(out, kind)
    data = bytearray(out.getvalue())
    if kind == "jpeg":
        at = data.find(b"\xff\xc0") + 5
        data[at : at + 4] = struct.pack(">HH", 30000, 30000)
    elif kind == "png":
        data[16:24] = struct.pack(">II", 30000, 30000)
        data[29:33] = struct.pack(">I", zlib.crc32(data[12:29]))
    else:
        data[18:26] = struct.pack("<ii", 30000, 30000)
    return bytes(data)


@pytest.mark.parametrize("kind", ["jpeg", "png", "bmp", "pdf"])
def test_a_picture_of_any_size_is_refused_by_its_header(
    kind: str, tmp_path: Path, capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    cv2 = pytest.importorskip("cv2")

    decoded: list[object] = []
    monkeypatch.setattr(cv2, "imdecode", lambda *data: decoded.append(data))
    file = tmp_path / f"t.{kind}"
    file.write_bytes(huge(kind))
    assert refusal(capfd, file) and not decoded


def test_arcs_that_do_not_meet_are_no_numbers(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "t.csv"
    file.write_text("mark,x_mm,y_mm\np,0,0\ns3,-16.4,-9.2\nc,2.4,63.1\nb,4.0,-74.3\ns2,-11.6,88.5\n", encoding="utf-8")
    assert main(["check", SCENE, str(file), "--plan", "position", "--json"]) in (1, 2)
    json.loads(capsys.readouterr().out)
    file.write_text("mark,x_mm,y_mm\np,0,0\nb,400,-743\nc,24,631\n", encoding="utf-8")
    for mu in ([], ["--mu", "1000 mm/m"]):
        assert main(["check", SCENE, str(file), "--plan", "position", "--lang", "en", *mu]) in (1, 2)
        assert "nan" not in capsys.readouterr().out


def test_masses_without_gravity(tmp_path: Path) -> None:
    (scene := tmp_path / "s.yaml").write_text(WITHOUT_GRAVITY, encoding="utf-8")
    (table := tmp_path / "t.csv").write_text("mark,x_mm,y_mm\np,0,0\nI_2,1,2\nI_3,3,4\n", encoding="utf-8")
    assert main(["check", str(scene), str(table), "--plan", "force:2-3"]) in (0, 1, 2)
    assert main(["lesson", str(scene), "-o", str(tmp_path / "l.html")]) == 0


def test_a_report_is_whole_or_the_old_one_stays(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    import os

    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    (table := tmp_path / "t.csv").write_text("mark,x_mm,y_mm\np,0,0\nb,30,40\n", encoding="utf-8")
    monkeypatch.setattr(os, "replace", full)
    asked = ["check", SCENE, str(table), "--plan", "velocity", "--lang", "en", "-o"]
    for more in ("r.json", "r.html", "r.svg"):
        (report := tmp_path / more).write_text("old", encoding="utf-8")
        assert main([*asked, str(report)]) == 2 and "No space left" in capsys.readouterr().err
        assert report.read_text(encoding="utf-8") == "old"
    report = tmp_path / "trace.html"
    assert main(["check", SCENE, "--trace", "--plan", "velocity", "-o", str(report)]) == 2 and not report.exists()
    assert not list(tmp_path.glob(".*"))


def test_one_file_never_stops_a_folder(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("Thumbs.db", "desktop.ini", "~$a.docx"):
        (tmp_path / name).write_bytes(b"x")
    for name in ("a.csv", "b.csv", "c.svg", "d.heic"):
        (tmp_path / name).write_text("mark,x_mm,y_mm\np,0,0\nb,30,40\n", encoding="utf-8")
    from planes.cli import class_check as command

    def fails(asked: object, paper: object) -> None:
        if getattr(paper, "file", "").endswith("a.csv"):
            raise ZeroDivisionError("division by zero")
        return kept(asked, paper)

    kept = command.judge
    monkeypatch.setattr(command, "judge", fails)
    assert main(["check", SCENE, str(tmp_path), "--plan", "velocity", "--lang", "en", "--json"]) == 2
    rows = {row["file"]: row["sentence"]["en"] for row in json.loads(capsys.readouterr().out)}
    assert set(rows) == {"a.csv", "b.csv", "c.svg", "d.heic"}
    assert "division by zero" in rows["a.csv"] and "save a picture as .jpg" in rows["d.heic"]


def spoiled(data: bytes, rng: random.Random) -> bytes:
    """Some bytes changed, left out, doubled or cut off."""
    out = bytearray(data)
    for _ in range(rng.choice([1, 3, 10])):
        at, end = sorted(rng.randrange(len(out) + 1) for _ in "ab") if out else (0, 0)
        end = min(end, at + rng.choice([1, 4, 60]))
        match rng.randrange(5):
            case 0:
                out[at:end] = bytes(rng.randrange(256) for _ in range(end - at))
            case 1:
                del out[at:end]
            case 2:
                out[at:at] = out[at:end]
            case 3:
                out[at:end] = rng.choice([b"-1", b"1e999", b"nan", b"", b"foo", b"99999999999", b'"', b"<", b"\n"])
            case _:
                out = out[: max(at, 1)] if rng.random() < 0.2 else out
    return bytes(out)


@pytest.fixture(scope="module")
def wholes(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    """The program's own files in every format."""
    folder = tmp_path_factory.mktemp("whole")
    for suffix in ("svg", "pdf", "png"):
        assert main(["blank", SCENE, "--plan", "velocity", "-o", str(folder / f"t.{suffix}")]) == 0
    strokes = [(0j, 30 + 40j), (0j, 12 - 33j), (30 + 40j, 12 - 33j)]
    words = [("p", 0j), ("b", 31 + 41j), ("c", 12 - 35j)]
    (folder / "t.dxf").write_text(line_drawings.dxf(strokes, words, 100 + 100j), encoding="utf-8")
    found = {f.suffix: f.read_bytes() for f in folder.iterdir()}
    rows = "mark,x_mm,y_mm\np,0,0\nb,30.5,40\nc,12,-33.1\ne,5,5\nsegment,mm\npb,12.5\nresult,value,unit\nv_B,1.5,m/s\n"
    return {**found, ".csv": rows.encode(), ".json": b'{"marks": {"b": [1, 2], "c": [3.5, 4]}, "segments": {"pb": 3}}'}


CASES = 200


@pytest.mark.few(1)
@pytest.mark.parametrize("suffix", [".svg", ".dxf", ".png", ".pdf", ".csv", ".json"])
def test_spoiled_files_never_end_in_a_traceback(
    suffix: str, wholes: dict[str, bytes], tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    if suffix in (".png", ".pdf"):
        pytest.importorskip("cv2")
    rng, file = random.Random(suffix), tmp_path / f"t{suffix}"
    few = {".png": 8, ".pdf": 8, ".dxf": 20, ".svg": 40}
    for _ in range(CASES // 200 * few.get(suffix, 62)):
        file.write_bytes(spoiled(wholes[suffix], rng))
        for plan in ("velocity", "position")[: 1 if suffix in few else 2]:
            assert main(["check", SCENE, str(file), "--plan", plan, "--json"]) in (0, 1, 2)
            told = capfd.readouterr()
            json.loads(told.out or "{}")
            assert told.err.count("\n") <= 1
