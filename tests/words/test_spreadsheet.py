"""CSV that a spreadsheet only shows: somebody else's text is no formula, numbers stay numbers."""

from __future__ import annotations

import csv
import shutil
from pathlib import Path

import pytest

from planes.check.grading.paper import read_table
from planes.cli import main
from planes.words.errors import PlanesError
from planes.words.records import csv_text, decode_table, safe_spreadsheet_cell
from tests.helpers import ROOT

SAMPLES = ROOT / "samples"
FORMULAS = [
    "=1+1",
    "=cmd|'C calc'!A0",
    '=HYPERLINK("http://localhost")',
    "@SUM(1)",
    "+1+cmd",
    "-2+3",
    "-",
    "\t=1",
    " =1",
    "＝1+1",
    "-Иванов",
    "+7 900",
]
PLAIN = ["", "Иванов", "a=b", "1", "-1.5", "+3", "-1e-9", "−5", "M-1", "c: 5 mm", "φ"]


@pytest.mark.parametrize("text", FORMULAS)
def test_a_formula_is_a_text(text: str) -> None:
    assert safe_spreadsheet_cell(text) == f"'{text}" and safe_spreadsheet_cell(
        safe_spreadsheet_cell(text)
    ) == safe_spreadsheet_cell(text)


def test_a_line_of_the_table_is_one_line() -> None:
    assert csv_text([["a\r=1+1\n@b", "\n=1"]]) == "\ufeffa =1+1 @b,' =1\n"


def test_all_else_stays_as_it_is() -> None:
    assert [safe_spreadsheet_cell(text) for text in PLAIN] == PLAIN


def test_a_table_is_read_back() -> None:
    rows = list(csv.reader(decode_table(csv_text([PLAIN, FORMULAS]).encode()).splitlines(keepends=True)))
    assert rows == [PLAIN, [f"'{text}" for text in FORMULAS]]


@pytest.mark.slow
def test_names_that_students_choose_are_no_formulas(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """File names in the table of a class, names and groups in the summary of a course."""
    names = ["=cmd|'C calc'!A0", '=HYPERLINK("x")', "@SUM(1)", "+1", "-2+3"]
    drawings, course = tmp_path / "drawings", tmp_path / "course"
    drawings.mkdir()
    for name in names:
        (drawings / f"{name}.csv").write_text("mark,x_mm,y_mm\np,0,0\nb,1,1\n", "utf-8")
    table = tmp_path / "class.csv"
    six = str(SAMPLES / "six-link.yaml")
    assert main(["check", six, str(drawings), "--plan", "velocity", "-o", str(table), "--lang", "en"]) > 0
    rows = list(csv.reader(table.read_text("utf-8-sig").splitlines()))
    assert sorted(row[0] for row in rows[1:]) == sorted(f"'{name}.csv" for name in names)
    course.mkdir()
    shutil.copy(SAMPLES / "assignments/12.yaml", course)
    listed = csv_text([["name", "group"]]) + "".join('"{0}","{0}"\n'.format(n.replace('"', '""')) for n in names)
    (course / "students.csv").write_text(listed, "utf-8")
    (course / "course.yaml").write_text("course: 1\ndocuments: [task]\nlang: en\n", "utf-8")
    assert main(["course", str(course), "--jobs", "1", "--lang", "en"]) == 0
    summary = (course / "out/teacher/summary.csv").read_text("utf-8-sig")
    found = list(csv.reader(summary.splitlines()))
    assert [row[:2] for row in found[1:]] == [[f"'{n}"] * 2 if n != "+1" else [n] * 2 for n in names]
    assert all(float(row[4]) for row in found[1:])


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16", "cp1251"])
def test_a_table_saved_by_a_spreadsheet_is_read(encoding: str, tmp_path: Path) -> None:
    (table := tmp_path / "ответы.csv").write_text("результат;значение;№\nv_B;1,5;«да»\n", encoding)
    assert [one[:2] for one in read_table(table).results] == [("v_B", 1.5)]


OTHERS = ["Müller".encode("cp1252"), "José".encode("cp1252"), "Иванов".encode("koi8-r"), b"\x98"]


@pytest.mark.parametrize("data", OTHERS)
def test_letters_that_may_be_others_are_refused_with_what_to_do(data: bytes, tmp_path: Path) -> None:
    (table := tmp_path / "t.csv").write_bytes(b"result,value\nv_B,1 # " + data)
    with pytest.raises(PlanesError, match=r"t\.csv: the file is not readable as text; save it as UTF-8$"):
        read_table(table)
