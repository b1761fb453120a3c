"""The command crank-slider: refusals in sentences, the report as HTML and PDF, the object for programs."""

from __future__ import annotations

import io
import json
import re
from pathlib import Path

import pypdfium2
import pytest

from planes.cli import main
from planes.documents import drawn as roof
from tests.helpers import ROOT
from tests.helpers.crank_slider_scenes import SAMPLE, changed, two_stroke

REFUSALS = [
    (("l: 0.21", "l: 0.05"), "longer than the crank"),
    (("mass: 1.8", "mass: -1.8"), "cannot be negative"),
    (("mass: 1.4", ""), "needs the key mass"),
    (("inertia: 0.0145", ""), "needs the key inertia"),
    (
        ("    exhaust: [[1, 0.26], [0.9, 0.15], [0.7, 0.118], [0.3, 0.112], [0, 0.11]]\n", ""),
        "stage exhaust is missing",
    ),
    (("[[0, 0.11], [0.15", "[[0.1, 0.11], [0.15"), "begins at s/S = 0"),
    (("[0.6, 0.162], [0.4", "[0.3, 0.162], [0.4"), "0.4 follows 0.3"),
    (("[0, 2.9]]\n    expansion", "[0, 2.5]]\n    expansion"), "they must meet"),
    (("[0.6, 0.085]", "[0.6, -0.085]"), "absolute pressure"),
    (("[0.6, 0.085]", "0.6"), "a point is two numbers"),
    (("unit: MPa", "unit: psi"), "bar"),
    (("bore: 0.1 ", "bore: 0 "), "must be above zero"),
    (("bore: 0.02}", "bore: 0.06}"), "too thin"),
    (("flange: 0.006", "flange: 0.02"), "too thin"),
    (
        (
            "rod: {height: 0.034, width: 0.024, flange: 0.006, web: 0.006}",
            "rod: {height: 0.008, width: 0.004, flange: 0.001, web: 0.001}",
        ),
        "the rod's shank: the section is too thin",
    ),
    (("journal: {diameter: 0.065}", "journal: {diameter: 0.02}"), "journal A: the section is too thin"),
    (("webs: 0.058", "webs: 0.11"), "find no place"),
    (("masses: {pin: m_a", "masses: {pin: 2*m_a"), "static moment"),
    (("gap: 0.038", "gap: 0.03"), "bush ≤ gap < pin"),
    (("shaft: 45", "shaft: 46"), "not in the table"),
    (("shaft: 45", "shaft: {strength_MPa: 600, yield_MPa: 700}"), "cannot be above the strength"),
    (("shaft: 45, ", ""), "materials.shaft is needed"),
    (("k_sigma: 1.9", "k_sigma: 0.5"), "between 1 and 20"),
    (("step: 1 ", "step: 0.7 "), "whole number of times into 15"),
    (("omega: omega_1", "omega: -omega_1"), "must be positive"),
    (("omega: omega_1", "omega: omega_1, epsilon: 5"), "crank_slider.speed"),
    (("guides: {x-x: {y: 0}}", "guides: {x-x: {y: 0.01}}"), "must be horizontal and pass through"),
    (("assembly: {B: ahead}", "assembly: {B: behind}"), "must stand to the right"),
    (("C: 0.3*l}", "C: [0.05, 0.01]}"), "must lie between its hinges"),
    (("friction: {x-x: 0.08}", "friction: {x-x: 8}"), "locks with friction"),
    (("gravity: 9.81", "gravity: 9.81\nloads: [{link: 3, point: B, force: 5, direction: 0}]"), "remove loads"),
    (("flywheel:", "flywhel:"), "did you mean flywheel"),
]


@pytest.mark.parametrize("pair, words", REFUSALS)
@pytest.mark.parametrize("lang", ["en", "ru"])
def test_what_cannot_be_meant_is_one_sentence(tmp_path, capsys, pair, words, lang):
    path = tmp_path / "scene.yaml"
    path.write_text(changed(pair), encoding="utf-8")
    assert main(["crank-slider", str(path), "--lang", lang, "-o", str(tmp_path / "out.pdf")]) == 2
    out, err = capsys.readouterr()
    doubts = err.count("friction of x-x") + err.count("friction направляющей x-x")  # so much is doubted too
    assert out == "" and "Traceback" not in err and err.count("\n") == 1 + doubts
    assert err.splitlines()[-1].startswith(f"{path}")
    assert words in err if lang == "en" else re.search("[а-я]", err)
    assert not (tmp_path / "out.pdf").exists()


def test_other_scenes_are_told_what_is_missing(tmp_path, capsys):
    samples = ROOT / "samples"
    assert main(["crank-slider", str(samples / "six-link.yaml"), "--lang", "en"]) == 2
    assert "crank_slider" in capsys.readouterr().err
    assert (
        main(["crank-slider", str(samples / "crank-slider.yaml"), "-o", str(tmp_path / "x.doc"), "--lang", "en"]) == 2
    )
    assert ".html, .pdf, .docx or .json" in capsys.readouterr().err


def write(tmp_path: Path, text: str, suffix: str, lang: str = "ru") -> bytes:
    (tmp_path / "scene.yaml").write_text(text, encoding="utf-8")
    out = tmp_path / f"report{suffix}"
    assert main(["crank-slider", str(tmp_path / "scene.yaml"), "-o", str(out), "--lang", lang]) == 0
    return out.read_bytes()


@pytest.mark.slow
@pytest.mark.parametrize(
    "lang, words", [("ru", ("Кинетостатика", "Планы сил", "МПа")), ("en", ("Kinetostatics", "Force polygons", "MPa"))]
)
def test_the_page_stands_alone(tmp_path, lang, words):
    page = write(tmp_path, SAMPLE, ".html", lang).decode()
    assert not re.search(r'(?:src|href)="(?!#)', page) and "@import" not in page and "url(" not in page
    assert all(word in page for word in words)
    if lang == "en":
        shown = re.sub(r'aria-label="[^"]*"', "", page)
        text = re.sub(r"<svg.*?</svg>|<style>.*?</style>|<[^>]+>", " ", shown, flags=re.S)
        assert set(re.findall("[а-яА-Я]+", text)) <= {"Х", "ХН", "А"}  # only names of steels
    for number in (*range(1, 10), 11, 13, 19, 27, 30, 31, 32, 33, 34, 35):
        assert re.search(rf"\((?:\d+, )*{number}(?:, \d+)*\)", page), number
    assert page.count('class="mistake"') == 7
    ids = re.findall(r'\sid="([^"]+)"', page)
    assert len(ids) == len(set(ids))


@pytest.mark.slow
def test_the_pdf_has_pages_with_text(tmp_path):
    data = write(tmp_path, SAMPLE, ".pdf")
    document = pypdfium2.PdfDocument(data)
    assert len(document) >= 10
    text = "".join(page.get_textpage().get_text_range() for page in document)
    assert "Поршневой палец" in text and "Нет" not in text and "None" not in text and "nan" not in text
    document.close()
    assert write(tmp_path, SAMPLE, ".pdf") == data


@pytest.mark.slow
def test_a_scene_without_parts_has_a_shorter_report(tmp_path):
    text = two_stroke()
    text = text[: text.index("  # коленчатый вал на опорах")]
    page = write(tmp_path, text, ".html").decode()
    assert "Кинетостатика" in page and "Прочность" not in page
    assert page.count('class="mistake"') == 5


def test_the_object(tmp_path, capsys):
    (tmp_path / "scene.yaml").write_text(SAMPLE, encoding="utf-8")
    assert main(["crank-slider", str(tmp_path / "scene.yaml"), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["agreement"]["forces"] < 1e-10
    assert len(found["forces"]["T"]) == len(found["kinematics"]["phi_deg"]) == 721
    assert found["balance"]["needed"] == pytest.approx([1.568571, 1.568571], abs=1e-6)
    assert {one["name"]: one["holds"] for one in found["checks"]}["fatigue_shaft"] is True
    assert (
        write(tmp_path, SAMPLE, ".json") and main(["crank-slider", str(tmp_path / "scene.yaml"), "--lang", "en"]) == 0
    )
    assert "shaft, fatigue factor" in capsys.readouterr().out


def test_the_force_plans_stand_on_a_sheet(tmp_path, capsys):
    (tmp_path / "scene.yaml").write_text(SAMPLE, encoding="utf-8")
    scene, sheet = str(tmp_path / "scene.yaml"), tmp_path / "sheet.svg"
    assert main(["crank-slider", scene, "--sheet", str(sheet), "--phi", "380", "--lang", "en"]) == 0
    assert "F_{32}" in sheet.read_text(encoding="utf-8") or "F_32" in sheet.read_text(encoding="utf-8")
    assert main(["crank-slider", scene, "--sheet", str(sheet), "--phi", "900", "--lang", "en"]) == 2
    assert "from 0° to 720°" in capsys.readouterr().err


def test_what_the_sheet_leaves_out_is_said(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(roof, "draw_sheet", lambda *how: roof.DrawnSheet("", ("no room on A4",)))
    (tmp_path / "scene.yaml").write_text(SAMPLE, encoding="utf-8")
    assert main(["crank-slider", str(tmp_path / "scene.yaml"), "--sheet", "sheet.svg", "--lang", "en"]) == 0
    assert capsys.readouterr().err == "warning: no room on A4\n"


@pytest.mark.slow
def test_a_report_is_a_word_document_too(tmp_path):
    docx = pytest.importorskip("docx", reason="python-docx is not installed")
    text = two_stroke()
    data = write(tmp_path, text[: text.index("  # коленчатый вал на опорах")], ".docx", "en")
    paper = docx.Document(io.BytesIO(data))
    heads = [p.text for p in paper.paragraphs if p.style.name.startswith("Heading")]
    page = write(tmp_path, text[: text.index("  # коленчатый вал на опорах")], ".html", "en").decode()
    assert heads == re.findall(r"<h[23][^>]*>([^<]*)</h[23]>", page)
    assert len(paper.tables) == page.count("<table>")
    assert len(paper.inline_shapes) >= page.count("<figure>")
    equations = [*paper.element.body.iter("{http://schemas.openxmlformats.org/officeDocument/2006/math}oMath")]
    assert len(equations) == page.count('<div class="formula">')
    letters = "".join(node.text for one in equations for node in one.iter() if node.text)
    assert not re.search(r"[\\\\{}$&]", letters)  # nothing is left as TeX has it


@pytest.mark.parametrize("lang, words", [("ru", "числ"), ("en", "number")])
def test_a_scale_that_is_no_number_is_refused_in_the_language_asked_for(capsys, lang, words):
    scene = str(ROOT / "samples" / "six-link.yaml")
    drawing = str(ROOT / "samples" / "none.csv")
    assert main(["check", scene, drawing, "--plan", "velocity", "--mu", "abc", "--lang", lang]) == 2
    found = capsys.readouterr().err
    assert re.search(words, found) and bool(re.search("[а-я]", found)) == (lang == "ru")
