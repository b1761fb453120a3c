"""Marks through the back-ends: places read back, text found again, the same bytes twice."""

from __future__ import annotations

import ctypes
import io
import math
import re
import xml.etree.ElementTree as ET
import zipfile
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pypdfium2
import pypdfium2.raw as raw
import pytest
from PIL import Image

from planes.drafting.pens import THICK_PEN_HEAD
from planes.scene.files import save_file_or_refuse
from planes.solving.document import DocumentTable, Formula, Heading, Paragraph
from planes.words.naming import Naming
from render import report
from render.files import pdf, svg
from render.paper import style
from render.paper.ink import arrow_parts, flatten_arc, hatch_strokes
from render.paper.marks import Arc, Arrow, Hatch, Line, Mark, Shape, Text
from render.paper.typeset import ink_bounds, lay_out_text, plain_text, text_box_corners

SIZE = (210.0, 297.0)
SVG = "{http://www.w3.org/2000/svg}"
SHEET: tuple[Mark, ...] = (
    Line((20 + 5j, 205 + 5j, 205 + 292j, 20 + 292j), "frame", "frame", True),
    Line((30 + 100j, 130 + 100j), "axis", "axis"),
    Arc(60 + 150j, 20, 30, 250),
    Arc(60 + 150j, 1.5, fill="paper"),
    Arrow(100 + 150j, 160 + 190j, name="v_CB"),
    Shape((150 + 50j, 160 + 50j, 155 + 60j)),
    Hatch((30 + 30j, 60 + 30j, 60 + 50j)),
    Text("План скоростей, μ_{v} = 0,05 (м/с)/мм", 112.5 + 270j, 5, "middle"),
    Text("a_{CB}^{n}", 40 + 200j, 5, name="a_CB_n"),
    Text("Щёлкающий съезд ω_{2} ⊥ φ, π, ε", 40 + 220j, 3.5),
    Text("v_{B}", 150 + 220j, 5, "end", 30),
)
WRITERS: tuple[Callable[..., bytes], ...] = (svg.write, pdf.write, pdf.write_png)


def pdf_text(data: bytes) -> str:
    document = pypdfium2.PdfDocument(data)
    page = document[0]
    text = page.get_textpage()
    found = str(text.get_text_range())
    text.close()
    page.close()
    document.close()
    return found


def ink_box(marks: tuple[Mark, ...], dpi: float = 1016.0) -> tuple[float, float, float, float]:
    """Bounds of what is dark in the PNG, in mm from the lower left corner."""
    picture = Image.open(io.BytesIO(pdf.write_png(marks, (60, 40), "проба", dpi=dpi)))
    dark = np.asarray(picture.convert("L")) < 200
    rows, columns = np.flatnonzero(dark.any(axis=1)), np.flatnonzero(dark.any(axis=0))
    mm = 25.4 / dpi
    return columns[0] * mm, 40 - (rows[-1] + 1) * mm, (columns[-1] + 1) * mm, 40 - rows[0] * mm


@pytest.mark.parametrize("write", WRITERS)
def test_the_same_bytes_twice_and_in_the_file(write: Callable[..., bytes], tmp_path: Path) -> None:
    first = write(SHEET, SIZE, "План скоростей")
    save_file_or_refuse(first, tmp_path / "sheet")
    assert first == write(SHEET, SIZE, "План скоростей")
    assert (tmp_path / "sheet").read_bytes() == first
    assert [path.name for path in tmp_path.iterdir()] == ["sheet"]


@pytest.mark.parametrize("write", WRITERS)
@pytest.mark.parametrize("bad", [complex(math.nan, 0), complex(3, math.inf)])
def test_a_place_that_is_no_number_is_an_error_in_words(write: Callable[..., bytes], bad: complex) -> None:
    with pytest.raises(ValueError, match=r"mark 1, Arrow 'v_CB' on layer 'plan'.*not a place on paper"):
        write([Arrow(0j, bad, name="v_CB")], SIZE, "x")


def test_svg_places_to_the_micrometre() -> None:
    root = ET.fromstring(svg.write(SHEET, SIZE, "План скоростей"))
    assert (root.get("width"), root.get("height"), root.get("viewBox")) == ("210mm", "297mm", "0 0 210 297")
    assert root.get("role") == "img" and root.get("aria-label") == root.findtext(f"{SVG}title") == "План скоростей"
    groups = {group.get("id"): group for group in root.findall(f"{SVG}g")}
    assert list(groups) == [layer for layer in style.LAYERS_FROM_LOWEST if layer in groups]
    shaft, head = groups["plan"].findall(f".//{SVG}path")
    numbers = [[float(x) for x in re.findall(r"-?[\d.]+", str(path.get("d")))] for path in (shaft, head)]
    assert numbers[0][:2] == [100, 147] and numbers[1][:2] == [160, 107]
    named = [group.get("data-name") for group in root.iter(f"{SVG}g")]
    assert "v_CB" in named and "a_CB_n" in named
    assert not [e.tag for e in root.iter() if e.tag in (f"{SVG}marker", f"{SVG}pattern", f"{SVG}image")]


def test_svg_arcs_pass_through_their_points() -> None:
    root = ET.fromstring(svg.write([Arc(60 + 150j, 20, 30, 250)], SIZE, "x"))
    path = root.find(f"{SVG}g/{SVG}path")
    assert path is not None
    numbers = [float(x) for x in re.findall(r"-?[\d.]+", str(path.get("d")))]
    ends = [complex(x, 297 - y) for x, y in (numbers[:2], numbers[7:9], numbers[14:16])]
    for z, angle in zip(ends, (30, 140, 250), strict=True):
        assert abs(z - (60 + 150j) - 20 * np.exp(1j * math.radians(angle))) < 2e-3
    assert numbers[4:7] == [0, 0, 0]  # no x axis turn, the small arc, counter-clockwise seen with y up


def test_svg_holds_real_text_for_search() -> None:
    root = ET.fromstring(svg.write(SHEET, SIZE, "x"))
    words = ["".join(text.itertext()) for text in root.iter(f"{SVG}text")]
    assert words == ["План скоростей, μv = 0,05 (м/с)/мм", "aCBn", "Щёлкающий съезд ω2 ⊥ φ, π, ε", "vB"]
    assert {text.get("fill-opacity") for text in root.iter(f"{SVG}text")} == {"0"}


def test_pdf_gives_its_text_back_whole() -> None:
    found = pdf_text(pdf.write(SHEET, SIZE, "План"))
    for line in ("План скоростей, μv = 0,05 (м/с)/мм", "aCBn", "Щёлкающий съезд ω2 ⊥ φ, π, ε", "vB"):
        assert line in found


def test_a_reader_of_structure_finds_the_figure_and_its_texts_in_order() -> None:
    """By PDFium: a page is a figure with its title, and each text an element with its own piece of the page."""
    texts = [Text(f"F_{{{k}}}", complex(10, 10 * k), 3.5) for k in range(1, 4)]
    marks = [Line((0j, 5 + 5j), "thin"), texts[0], texts[1], Line((0j, 9 + 5j), "thin"), texts[2]]
    data = pdf.write_pages([(marks, (60.0, 50.0)), (marks[:2], (60.0, 50.0))], "План сил")
    with pypdfium2.PdfDocument(data) as document:
        pages = [structure_of(page) for page in document]
        held = (first := document[0]).get_objects(textpage=first.get_textpage())
        words = {
            raw.FPDFPageObj_GetMarkedContentID(o): o.extract() for o in held if isinstance(o, pypdfium2.PdfTextObj)
        }
    assert [kind for kind, _, _ in pages[0]] == ["Figure", "P", "P", "P"]
    assert [kind for kind, _, _ in pages[1]] == ["Figure", "P"]
    assert {alt for kind, alt, _ in pages[0] + pages[1] if kind == "Figure"} == {"План сил"}
    assert [words[number] for kind, _, (number, *_) in pages[0] if kind == "P"] == ["F1", "F2", "F3"]


def structure_of(page: pypdfium2.PdfPage) -> list[tuple[str, str, tuple[int, ...]]]:
    """The kind, the words and the pieces of each element of a page."""
    tree = raw.FPDF_StructTree_GetForPage(page)
    top = raw.FPDF_StructTree_GetChildAtIndex(tree, 0)
    children = [
        raw.FPDF_StructElement_GetChildAtIndex(top, k) for k in range(raw.FPDF_StructElement_CountChildren(top))
    ]
    said = [
        (
            said_by(raw.FPDF_StructElement_GetType, one),
            said_by(raw.FPDF_StructElement_GetAltText, one),
            tuple(
                raw.FPDF_StructElement_GetMarkedContentIdAtIndex(one, k)
                for k in range(raw.FPDF_StructElement_GetMarkedContentIdCount(one))
            ),
        )
        for one in children
        if one
    ]
    raw.FPDF_StructTree_Close(tree)
    return said


def said_by(ask: Callable[..., int], element: object) -> str:
    long = ask(element, None, 0)
    held = ctypes.create_string_buffer(long)
    ask(element, held, long)
    return held.raw.decode("utf-16-le").rstrip("\0")


def test_pdf_pages_have_their_own_sizes() -> None:
    data = pdf.write_pages([(SHEET, SIZE), (SHEET, (420, 297))], "два листа")
    document = pypdfium2.PdfDocument(data)
    sizes = [tuple(document.get_page_size(k)) for k in range(len(document))]
    document.close()
    assert np.allclose(sizes, np.array([SIZE, (420, 297)]) * 72 / 25.4, atol=1e-3)
    assert b"DejaVuSans" in data and b"Helvetica" not in data  # every font used is in the file


@pytest.mark.parametrize(
    "mark, box",
    [
        (Line((10 + 20j, 30 + 20j)), (9.7, 19.7, 30.3, 20.3)),
        (Arc(30 + 20j, 10), (19.7, 9.7, 40.3, 30.3)),
        (Arc(30 + 20j, 10, 0, 90, "thin"), (29.9, 19.9, 40.1, 30.1)),
        (Shape((10 + 10j, 50 + 10j, 30 + 30j)), (10, 10, 50, 30)),
        (Arrow(20 + 10j, 20 + 35j), (20 - THICK_PEN_HEAD.wide / 2, 9.7, 20 + THICK_PEN_HEAD.wide / 2, 35)),
    ],
)
def test_places_in_the_picture(mark: Mark, box: tuple[float, ...]) -> None:
    assert ink_box((mark,)) == pytest.approx(box, abs=0.05)


@pytest.mark.parametrize("turn", [0, 30, -90])
@pytest.mark.parametrize("anchor", ["start", "middle", "end"])
def test_the_box_of_a_text_is_where_its_ink_is(anchor: str, turn: float) -> None:
    text = Text("a_{CB}^{n}", 30 + 20j, 5, anchor, turn)  # type: ignore[arg-type]
    laid, pens = lay_out_text(text), [0.5, 0.35]
    points = [(z, pen / 2) for pen, stroke in zip(laid.pens, laid.strokes, strict=True) for z in stroke]
    assert sorted(set(laid.pens), reverse=True) == pytest.approx(pens)
    box = (
        min(z.real - half for z, half in points),
        min(z.imag - half for z, half in points),
        max(z.real + half for z, half in points),
        max(z.imag + half for z, half in points),
    )
    assert ink_box((text,)) == pytest.approx(box, abs=0.06)
    corners = text_box_corners(text)
    assert abs(corners[1] - corners[0]) == pytest.approx(laid.width)
    assert min(z.real for z in corners) <= box[0] + 0.01 and max(z.imag for z in corners) >= box[3] - 0.01


def test_both_indices_stand_above_each_other() -> None:
    base, lower, upper = lay_out_text(Text("a_{CB}^{n}", 0j, 5)).runs
    assert lower.at.real == upper.at.real > base.width
    assert lower.at.imag < 0 < lower.at.imag + lower.height < upper.at.imag
    assert lower.height == upper.height == 3.5
    swapped = lay_out_text(Text("a^{n}_{CB}", 0j, 5))
    assert sorted(run.text for run in swapped.runs) == ["CB", "a", "n"]
    assert swapped.width == lay_out_text(Text("a_{CB}^{n}", 0j, 5)).width


def test_text_without_markup_stays_as_it_is() -> None:
    assert plain_text("F_21 = x^2") == "F_21 = x^2"
    assert plain_text("v_{C} = v_{B} + v_{CB}") == "vC = vB + vCB"
    assert ink_bounds("", 5) == (0, 0, 0, 0) and lay_out_text(Text("", 1j)).plain_text == ""
    with pytest.raises(ValueError, match="is not closed"):
        lay_out_text(Text("v_{C", 0j))
    with pytest.raises(ValueError, match="letter height"):
        lay_out_text(Text("v", 0j, 0))


def test_png_knows_its_size() -> None:
    picture = Image.open(io.BytesIO(pdf.write_png(SHEET, SIZE, "x", dpi=100)))
    assert picture.size == pytest.approx((210 / 25.4 * 100, 297 / 25.4 * 100), abs=1)
    assert picture.info["dpi"] == pytest.approx((100, 100), abs=0.1)


@pytest.mark.parametrize("style_name", ["thick", "vector #0072B2"])
def test_a_png_has_the_pixels_of_its_page(style_name: str) -> None:
    """In grey where the page has no colour, else in colour; as the page is drawn in colours by pdfium."""
    marks: tuple[Mark, ...] = (*SHEET, Arrow(30 + 120j, 90 + 140j, style_name))
    page = pypdfium2.PdfDocument(pdf.write_pages([(marks, SIZE)], "x", words=False))[0]
    colours = page.render(scale=100 / 72, rev_byteorder=True).to_numpy()
    picture = Image.open(io.BytesIO(pdf.write_png(marks, SIZE, "x", dpi=100)))
    assert picture.mode == ("L" if style_name == "thick" else "RGB")
    assert np.array_equal(np.asarray(picture.convert("RGB")), colours)


def test_a_coordinate_is_the_rounded_number_without_zeros() -> None:
    for value in (0.0, -0.0, -0.0004, 0.0005, 2.5, -1.0005, 100.0, 1e5, 123.4567, -7e-9, *np.linspace(-3, 3, 997)):
        assert svg.svg_number(value) == f"{round(value, 3) + 0.0:.3f}".rstrip("0").rstrip(".")


@pytest.mark.parametrize("length", [11, 12, 14, 25, 40, 77.3, 300])
def test_chain_lines_end_with_dashes(length: float) -> None:
    dash, *rest = style.fit_dash_pattern(style.pen_of_style("axis").pattern, length) or (length,)
    periods = (length - dash) / (dash + sum(rest))
    assert periods == pytest.approx(round(periods), abs=1e-9)
    assert 5 <= dash <= 30 and bool(rest) == (length >= 12)


def test_heads_shrink_with_short_arrows() -> None:
    assert arrow_parts(Arrow(0j, 1 + 0j))[1] == ()
    tip, left, right = arrow_parts(Arrow(0j, 5 + 0j))[1]
    assert tip == 5 and left.real == right.real == 2.5
    assert arrow_parts(Arrow(2j, 2j))[1] == ()


def test_an_unknown_style_names_the_known_ones() -> None:
    with pytest.raises(ValueError, match="no line style 'bold'; use one of thick, result"):
        svg.write([Line((0j, 1j), "bold")], SIZE, "x")


def test_hatching_and_arcs_stay_in_their_shapes() -> None:
    square = Hatch((0j, 10 + 0j, 10 + 10j, 10j), 45, 2)
    ends = [z for stroke in hatch_strokes(square) for z in stroke]
    assert all(-1e-9 <= part <= 10 + 1e-9 for z in ends for part in (z.real, z.imag))
    assert len(ends) == 14
    assert all(abs(abs(z - 1j) - 50) < 1e-9 for z in flatten_arc(Arc(1j, 50, 10, 200)))


@pytest.mark.parametrize("suffix", report.MODULE_OF_SUFFIX)
def test_a_document_of_every_kind_of_block_is_written(suffix: str) -> None:
    row = (("точка", "v, м/с"), ("B", "3,14"))
    blocks = [
        Heading("Расчёт", 0),
        Heading("Глава"),
        Paragraph("Скорость ⟨v_B⟩:", 1),
        Paragraph("почему", why=True),
        Formula(("v_B=1",), "2"),
    ]
    data = report.render_document([*blocks, DocumentTable("Таблица 1", row)], suffix, Naming())
    if suffix == ".pdf":
        said = pdf_text(data)
    elif suffix == ".docx":
        said = zipfile.ZipFile(io.BytesIO(data)).read("word/document.xml").decode()
    else:
        said = data.decode()
    assert [word for word in ("Расчёт", "Глава", "Скорость", "почему", "Таблица 1", "3,14") if word not in said] == []
