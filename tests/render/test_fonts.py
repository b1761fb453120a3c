"""Sheets in an installed font or in slanted lettering: measured as drawn, alike in every format, searchable."""

from __future__ import annotations

import math
import shutil
import xml.etree.ElementTree as ElementTree
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from planes.cli import main
from planes.documents.drawn import page_of_view
from planes.documents.sheets import sheet_of
from planes.scene import load
from render.files import pdf, svg
from render.paper import lettering, outlines
from render.paper.marks import BUILT_IN_FACE, Face, Text, current_face, using_face
from render.paper.outlines import dejavu_file
from render.paper.typeset import ink_bounds, lay_out_text, text_box_corners
from tests.helpers import ROOT
from tests.helpers.sheets import sheet
from tests.render.test_backends import pdf_text
from tests.render.test_golden import agree, farthest, letters, of_pdf, of_svg
from tests.render.test_sheet import clashes

SAMPLES = {path.stem: path for path in sorted((ROOT / "samples").glob("*.yaml"))}
SANS = Face(str(dejavu_file()), False, "DejaVu Sans")
FACES = {
    "own": BUILT_IN_FACE,
    "slanted": Face("", True),
    "font": SANS,
    "font slanted": Face(SANS.font, True, SANS.family),
}
WORDS = ["План скоростей, μ_{v} = 30 мм/(м·с⁻¹)", "a_{CB}^{n} ⊥ BC", "Щёлкающий съезд, ў і ї є ґ", "F_{21}^{t}"]


def ink(laid):
    return np.array([z for stroke in laid.strokes for z in stroke])


@pytest.mark.parametrize("face", list(FACES))
@pytest.mark.parametrize("text", WORDS)
@pytest.mark.parametrize("turn", [0.0, 90.0, 200.0])
def test_a_label_measures_what_it_draws(face, text, turn):
    with using_face(FACES[face]):
        mark = Text(text, 40 + 30j, 5.0, "middle", turn)
        x0, y0, x1, y1 = ink_bounds(text, 5.0)
    laid = lay_out_text(mark)
    half = max(laid.pens) / 2
    level = (ink(laid) - laid.origin) * np.exp(-1j * math.radians(turn))
    assert level.real.min() - half - 1e-6 <= x0 <= level.real.min() + 1e-6
    assert level.real.max() - 1e-6 <= x1 <= level.real.max() + half + 1e-6
    assert level.imag.min() - half - 1e-6 <= y0 and y1 <= level.imag.max() + half + 1e-6
    assert laid.width == pytest.approx(x1 - x0)
    middle = sum(text_box_corners(mark)[:2]) / 2
    across = (40 + 30j - middle) * np.exp(-1j * math.radians(turn))
    assert abs(across.real) < 1e-6  # anchored by the middle of its ink


@pytest.mark.parametrize("height", [2.5, 5.0, 10.0])
def test_letters_of_a_font_have_the_height_of_capitals(height):
    low, _, high, _ = text_box_corners(Text("Н", 0j, height, face=SANS))
    assert (low.real, low.imag, high.imag) == pytest.approx((0, 0, height))
    assert outlines.line_ink_width("НН", height, SANS.font) == pytest.approx(
        2 * outlines.line_ink_width("НН", height / 2, SANS.font)
    )


def test_outlines_are_those_of_the_font():
    """Against matplotlib's own text paths, which come from FreeType."""
    from matplotlib.font_manager import FontProperties
    from matplotlib.textpath import TextPath

    for char in "Жбfйωμ8&":
        path = TextPath((0, 0), char, size=1.0, prop=FontProperties(fname=SANS.font))
        whole = np.vstack([p for p in path.to_polygons() if len(p)])
        capitals = 0.729  # of DejaVu Sans
        own = np.array([z for line in outlines.line_contours(char, 1.0, SANS.font) for z in line]) * capitals
        wide, high = np.ptp(whole[:, 0]), np.ptp(whole[:, 1])
        assert np.ptp(own.real) == pytest.approx(wide, abs=0.01) and np.ptp(own.imag) == pytest.approx(high, abs=0.01)
        assert own.imag.min() == pytest.approx(whole[:, 1].min(), abs=0.01)


def test_a_character_the_font_lacks_comes_from_another(tmp_path):
    mathematics = Path(str(dejavu_file())).with_name("STIXSizeOneSym.ttf")
    path = str(mathematics if mathematics.exists() else dejavu_file().with_name("cmr10.ttf"))
    with using_face(Face(path, False, "few letters")):
        box = ink_bounds("Ж⊥漢", 5.0)
    assert box[2] > 5
    own, spare = outlines.open_font(path), outlines.open_font(str(dejavu_file()))
    assert [c for c in "Ж⊥漢" if not own.has_character(c) and not spare.has_character(c)] == ["漢"]


def test_slanted_lettering_is_the_upright_one_sheared_indices_with_it():
    upright, slanted = (lay_out_text(Text("a_{CB}^{n}", 0j, 7.0, face=f)) for f in (BUILT_IN_FACE, FACES["slanted"]))
    a, b = ink(upright) - upright.origin, ink(slanted) - slanted.origin
    assert b.imag == pytest.approx(a.imag)
    assert b.real - a.real == pytest.approx(a.imag * lettering.SLANT_SHEAR, abs=1e-9)


def test_the_face_is_that_of_the_time_a_mark_is_made():
    with using_face(SANS):
        held = Text("A", 0j)
        assert current_face() == SANS
    assert current_face() == BUILT_IN_FACE and Text("A", 0j).face == BUILT_IN_FACE
    assert held.face == SANS and lay_out_text(held).filled


# whole sheets

SETTINGS = [{"lettering": "slanted"}, {"font": "DejaVu Sans"}, {"font": "dejavu serif", "lettering": "slanted"}]


@pytest.mark.slow
@pytest.mark.parametrize("settings", SETTINGS, ids=str)
@pytest.mark.parametrize("name", ["kind-2-rrp", "kind-3-rpr", "vectors"])
def test_nothing_overlaps_in_any_face(name, settings):
    found = sheet(name, **settings)
    faces = {m.face for m in found.marks if isinstance(m, Text)}
    assert len(faces) == 1 and faces != {BUILT_IN_FACE}
    assert clashes(found) == []


@pytest.mark.slow
@pytest.mark.parametrize("settings", SETTINGS, ids=str)
def test_the_formats_draw_the_same_letters_in_the_same_places(settings):
    found = sheet("kind-2-rrp", **settings)
    wanted = letters(found.marks)
    screen, texts = of_svg(svg.write(found.marks, found.size, found.title), found.size[1])
    paper, starts = of_pdf(pdf.write(found.marks, found.size, found.title))
    assert farthest(wanted, screen) < 0.05 and farthest(wanted, paper) < 0.05
    assert agree([z for _, z in texts], starts)


@pytest.mark.slow
@pytest.mark.parametrize("settings", SETTINGS, ids=str)
def test_text_is_found_again(settings):
    found = sheet("kind-1-rrr", **settings)
    word = "План скоростей"
    root = ElementTree.fromstring(svg.write(found.marks, found.size, found.title))
    said = ["".join(t.itertext()) for t in root.iter("{http://www.w3.org/2000/svg}text")]
    assert any(t.startswith(word) for t in said)
    assert word in pdf_text(pdf.write(found.marks, found.size, found.title))


def test_letters_of_a_font_are_filled_and_their_holes_are_open():
    mark = Text("О", 5 + 5j, 20.0, face=SANS)
    from tests.render.test_backends import ink_box

    box = ink_box((mark,))
    wanted = text_box_corners(mark)
    assert box == pytest.approx((wanted[0].real, wanted[0].imag, wanted[2].real, wanted[2].imag), abs=0.05)
    import io

    from PIL import Image

    from render.files import pdf

    with Image.open(io.BytesIO(pdf.write_png([mark], (60, 40), "t", dpi=254))) as picture:
        grey = np.asarray(picture.convert("L"))
    row = grey[-round(10 * (box[1] + box[3]) / 2)] < 128
    edges = np.flatnonzero(np.diff(row.astype(int)))
    assert len(edges) == 4  # a stem, a hole, a stem


def test_one_view_is_lettered_so_too():
    scene = load(SAMPLES["kind-1-rrr"])
    found = page_of_view(replace(scene, sheet={"font": "DejaVu Serif"}), "velocity-plan")
    assert {m.face.family for m in found.marks if isinstance(m, Text)} == {"DejaVu Serif"}
    assert found._repr_svg_().startswith("<svg")


# which font


def scene_with(tmp_path, setting):
    path = tmp_path / "scene.yaml"
    path.write_text(SAMPLES["kind-1-rrr"].read_text(encoding="utf-8") + f"\nsheet: {{{setting}}}\n", encoding="utf-8")
    return path


@pytest.mark.slow
def test_a_font_is_given_by_its_file_beside_the_scene(tmp_path):
    shutil.copy(dejavu_file().with_name("DejaVuSerif.ttf"), tmp_path / "мой.ttf")
    found = sheet_of(load(scene_with(tmp_path, "font: мой.ttf")), None)
    assert {m.face for m in found.marks if isinstance(m, Text)} == {
        Face(str(tmp_path / "мой.ttf"), False, "DejaVu Serif")
    }


@pytest.mark.parametrize(
    ("setting", "said"),
    [
        ("font: DejaVu San", 'шрифт "DejaVu San" не установлен'),
        ("font: DejaVu San", "имелось в виду DejaVu Sans?"),
        ("font: нет/такого.ttf", 'файла "нет/такого.ttf" нет'),
        ("font: scene.otf", '"scene.otf" не читается как шрифт'),
        ("lettering: italic", "upright"),
    ],
)
def test_a_font_that_is_not_there_is_one_sentence_with_its_line(setting, said, tmp_path, capsys):
    path = scene_with(tmp_path, setting)
    (tmp_path / "scene.otf").write_text("not a font", encoding="utf-8")
    before = sorted(tmp_path.iterdir())
    assert main(["sheet", str(path), "-o", str(tmp_path / "out.svg"), "--lang", "ru"]) == 2
    out, err = capsys.readouterr()
    line = path.read_text(encoding="utf-8").splitlines().index(f"sheet: {{{setting}}}") + 1
    assert out == "" and err.count("\n") == 1
    assert err.startswith(f"{path}:{line}: ") and said in err
    assert sorted(tmp_path.iterdir()) == before


@pytest.mark.parametrize("seed", range(8))
def test_a_broken_font_is_one_sentence_or_is_drawn(seed, tmp_path, capsys):
    import random

    chance, data = random.Random(seed), bytearray(dejavu_file().read_bytes())
    if seed % 2:
        del data[chance.randrange(len(data)) :]
    for _ in range(400 if seed % 2 == 0 else 0):
        data[chance.randrange(len(data))] = chance.randrange(256)
    (tmp_path / "broken.ttf").write_bytes(bytes(data))
    path = scene_with(tmp_path, "font: broken.ttf")
    done = main(["sheet", str(path), "--view", "velocity-plan", "-o", str(tmp_path / "x.svg"), "--lang", "ru"])
    error = capsys.readouterr().err
    assert (done, (tmp_path / "x.svg").exists(), error.count("\n")) in ((0, True, 0), (2, False, 1)), error


def test_a_sheet_shows_itself_in_a_notebook():
    shown = sheet("vectors")._repr_svg_()
    root = ElementTree.fromstring(shown)
    assert root.get("width") == "210mm" and shown == sheet("vectors")._repr_svg_()
