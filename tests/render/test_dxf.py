"""DXF of whole sheets: no audit errors, millimetres, layers by meaning, blocks, and the same picture as the SVG."""

from __future__ import annotations

import cmath
import io
import math
import os
import subprocess
import sys
from itertools import pairwise

import numpy as np
import pytest
from PIL import Image

from planes.cli import main
from planes.documents.drawn import draw_sheet
from planes.scene import load
from render.files import pdf
from render.files.dxf_entities import LEAST_PROSE_LETTERS
from render.paper import form1, lettering, symbols
from render.paper.ink import arrow_parts, is_circle, visible_marks
from render.paper.marks import Arc, Arrow, Line, Text
from render.paper.style import HINGE_RADIUS_MM, LAYERS_FROM_LOWEST, pen_of_style
from render.paper.typeset import lay_out_text, plain_text
from tests.helpers import ROOT
from tests.helpers.counting import at_most
from tests.helpers.sheets import sheet

ezdxf = pytest.importorskip("ezdxf")
MTextParser = pytest.importorskip("ezdxf.tools.text").MTextParser
aci2rgb = pytest.importorskip("ezdxf.colors").aci2rgb
dxf = pytest.importorskip("render.files.dxf")

SAMPLES = {path.stem: path for path in sorted((ROOT / "samples").glob("*.yaml"))}


def read(sheet, **how):
    return ezdxf.read(io.StringIO(dxf.write(sheet.marks, sheet.size, sheet.title, **how).decode()))


def apart(document):
    """All entities, blocks taken apart."""
    from ezdxf.disassemble import recursive_decompose

    return list(recursive_decompose(document.modelspace()))


@pytest.mark.few(0, slow=4)
@pytest.mark.parametrize("name", ["six-link", "kind-1-rrr", "kind-4-prp", "vectors"])
@pytest.mark.parametrize("text", ["text", "strokes"])
def test_the_file_has_no_errors_and_is_in_millimetres(name, text):
    document = read(sheet(name), text=text)
    audit = document.audit()
    assert not audit.errors
    assert not audit.fixes
    assert document.units == 4
    assert tuple(document.header["$EXTMAX"])[:2] == document.header["$LIMMAX"] == sheet(name).size
    used = {e.dxf.layer for e in document.modelspace()}
    assert used <= {layer.upper() for layer in LAYERS_FROM_LOWEST} and {"FRAME", "TEXT"} <= used


def test_places_agree_with_the_marks():
    found = sheet("kind-1-rrr")
    entities = apart(read(found))
    marks = visible_marks(found.marks)
    lines = [complex(e.dxf.start.x, e.dxf.start.y) for e in entities if e.dxftype() == "LINE"]
    straight = [m.points[0] for m in marks if isinstance(m, Line) and len(m.points) == 2]
    for z in straight:
        assert min(abs(at - z) for at in lines) < 0.05
    circles = [(complex(*e.dxf.center.vec2), e.dxf.radius) for e in entities if e.dxftype() == "CIRCLE"]
    for arc in (m for m in marks if isinstance(m, Arc) and is_circle(m)):
        assert any(abs(c - arc.centre) < 0.05 and abs(r - arc.radius) < 0.05 for c, r in circles)


def test_text_is_text_fitted_to_its_lettering():
    found = sheet("kind-1-rrr")
    space = read(found).modelspace()
    texts = {(e.dxf.text, round(e.dxf.insert.x, 2), round(e.dxf.insert.y, 2)): e for e in space.query("TEXT")}
    title = next(m for m in found.marks if isinstance(m, Text) and m.text.startswith("Исходные данные"))
    run = lay_out_text(title).runs[0]
    place = lay_out_text(title).origin + run.at
    entity = texts[run.text.strip(), round(place.real, 2), round(place.imag, 2)]
    assert entity.dxf.height == run.height
    assert abs(entity.dxf.align_point.x - entity.dxf.insert.x - run.width) < 1e-4
    assert entity.dxf.lineweight == pytest.approx(10 * run.height, abs=3)  # of the pen a single-stroke font is drawn by


def test_a_narrowed_name_is_as_narrow():
    marks = [Text("Константинопольский", 10 + 50j, 1.8, narrow=0.45)]
    (found,) = ezdxf.read(io.StringIO(dxf.write(marks, (100, 100), "t").decode())).modelspace()
    assert found.dxf.align_point.x - found.dxf.insert.x == pytest.approx(lay_out_text(marks[0]).runs[0].width, abs=1e-4)


@pytest.mark.parametrize("said", ["↓", "B→A", "a_{2}→b"])
def test_signs_that_librecad_has_no_letter_for_are_drawn(said):
    written = dxf.write([Text(said, 10 + 50j), Text("⊥BC", 50 + 50j)], (100, 100), "t").decode()
    drawing = ezdxf.read(io.StringIO(written))
    letters, plain = drawing.modelspace()
    strokes = drawing.blocks[letters.dxf.name]
    assert plain.dxf.text == "⊥BC" and len(strokes) == len(lay_out_text(Text(said, 0j)).strokes)


def test_a_dashed_path_of_short_sides_is_a_block_of_its_dashes():
    """LibreCAD begins a line type anew at every corner: sides shorter than a dash came out as one solid line."""
    path = [50 + 50j + cmath.rect(20, k / 20) for k in range(126)]
    drawing = ezdxf.read(io.StringIO(dxf.write([Line(path, "dash"), Line((1, 90), "dash")], (100, 100), "t").decode()))
    block, straight = drawing.modelspace()
    dashes = [[complex(*z) for z in e.get_points("xy")] for e in drawing.blocks[block.dxf.name]]
    assert (straight.dxftype(), straight.dxf.linetype) == ("LINE", "DASHED2")
    assert {e.dxf.linetype for e in drawing.blocks[block.dxf.name]} == {"Continuous"}
    assert [dashes[0][0], dashes[-1][-1]] == pytest.approx([path[0], path[-1]], abs=1e-5)
    drawn = sum(abs(b - a) for one in dashes for a, b in pairwise(one))
    assert len(dashes) == 23 and drawn == pytest.approx(20 * 125 / 20 * 4 / 5.5, rel=0.02)


def test_a_label_with_indices_is_one_text():
    found = sheet("kind-1-rrr")
    space = read(found).modelspace()
    short = (m for m in found.marks if isinstance(m, Text) and len(plain_text(m.text)) <= LEAST_PROSE_LETTERS)
    wanted = [m for m in short if len(lay_out_text(m).runs) > 1]
    said = {e.text: e for e in space.query("MTEXT")}
    assert len(space.query("MTEXT")) == len(wanted) > 20  # longer ones are lines of prose, in pieces
    assert r"v{\H0.7x;\S^ CB;}" in said and r"a{\H0.7x;\Sn^ CB;}" in said
    label = next(m for m in wanted if m.text == "v_{CB}")
    held = [complex(*e.dxf.insert.vec2) for e in space.query("MTEXT") if e.text == r"v{\H0.7x;\S^ CB;}"]
    part = {"start": 0.0, "middle": 0.5, "end": 1.0}[label.anchor]
    assert min(abs(z - lay_out_text(label).origin - part * lay_out_text(label).width) for z in held) < 1e-4


def test_signs_of_the_format_in_a_text_are_written_so_that_they_stay():
    marks = [Text("{a}\\b_{1/2;}^{#n}", 50 + 50j, 5.0)]
    (found,) = ezdxf.read(io.StringIO(dxf.write(marks, (100, 100), "t").decode())).modelspace()
    tokens = [t.data for t in MTextParser(found.text)]
    assert tokens == ["{a}\\b", ("#n", "1/2;", "^")]


def test_heads_are_blocks_filled_and_outlined():
    """Some programs know no filled figures, and no blocks stretched one way; all know polylines."""
    marks = [Arrow(10 + 10j, 40 + 50j), Arrow(90 + 10j, 60 + 10j, "thin"), Arrow(5j + 5, 5j + 5.5)]
    document = ezdxf.read(io.StringIO(dxf.write(marks, (100, 100), "t").decode()))
    heads = document.modelspace().query("INSERT")
    assert [(e.dxf.name, complex(*e.dxf.insert.vec2)) for e in heads] == [
        ("ARROW_320", 40 + 50j),
        ("ARROW_267", 60 + 10j),
    ]
    for head, mark in zip(heads, marks, strict=False):
        fill, outline = head.virtual_entities()
        assert (fill.dxftype(), outline.dxftype(), outline.closed) == ("SOLID", "LWPOLYLINE", True)
        assert head.dxf.xscale == head.dxf.yscale == head.dxf.zscale
        corners = [complex(*z) for z in outline.get_points("xy")]
        assert np.allclose(corners, arrow_parts(mark)[1], atol=2e-3)
        assert np.allclose(corners, [complex(*z.vec2) for z in list(fill.vertices())[:3]], atol=1e-9)


def test_a_size_between_two_arrows_is_a_dimension_with_its_own_picture():
    middle, along = 50 + 60j, 0.8 + 0.6j
    tips = middle - 25 * along, middle + 15 * along
    leading = [
        Line((z - far * 1j * along, z + 2j * along), "thin", "dimension") for z, far in zip(tips, (20, 9), strict=True)
    ]
    arrows = [Arrow(middle, z, "thin", "dimension") for z in tips]
    axes = [Arrow(5 + 5j, z, "thin", "dimension") for z in (15 + 5j, 5 + 15j)]  # of a diagram
    text = Text("a_{1}", middle + 1j * along, 3.5, "middle", math.degrees(cmath.phase(along)))
    marks = [*leading, *arrows, text, *axes]
    document = ezdxf.read(io.StringIO(dxf.write(marks, (100, 100), "t").decode()))
    assert not document.audit().errors
    (one,) = document.modelspace().query("DIMENSION")
    places = [complex(*one.dxf.get(key).vec2) for key in ("defpoint2", "defpoint3", "defpoint")]
    assert np.allclose(places, [leading[0].points[0], leading[1].points[0], tips[1]], atol=1e-5)
    assert one.get_measurement() == pytest.approx(40)
    assert one.dxf.text == r"a{\H0.7x;\S^ 1;}"
    drawn = [e.dxftype() for e in document.blocks[one.dxf.geometry]]
    assert sorted(drawn) == ["INSERT", "INSERT", "LINE", "LINE", "LINE", "LINE", "MTEXT"]
    left = [e.dxftype() for e in document.modelspace()]
    assert sorted(left) == ["DIMENSION", "INSERT", "INSERT", "LINE", "LINE"]  # the axes


def test_the_layout_is_the_sheet_set_up_for_printing():
    found = sheet("kind-1-rrr")
    layout_ = read(found).layout("Layout1")
    said = layout_.dxf_layout.dxf
    assert (said.paper_width, said.paper_height, said.plot_paper_units) == (*found.size, 1)
    assert (said.scale_numerator, said.scale_denominator, said.left_margin) == (1, 1, 0)
    seen = [v.dxf for v in layout_.viewports() if v.dxf.id > 1]
    middle = (found.size[0] / 2, found.size[1] / 2)
    assert [(v.width, v.height, v.view_height) for v in seen] == [(*found.size, found.size[1])]
    assert tuple(seen[0].view_center_point)[:2] == tuple(seen[0].center)[:2] == middle


def test_no_layer_is_paler_than_it_prints():
    for layer in read(sheet("kind-1-rrr")).layers:
        if layer.dxf.name.lower() in LAYERS_FROM_LOWEST:
            colour = pen_of_style(dxf.STYLE_OF_LAYER[layer.dxf.name.lower()]).colour
            wanted = bytes.fromhex(colour[1:])
            assert tuple(layer.rgb or (0, 0, 0)) == tuple(wanted)
            assert max(aci2rgb(layer.dxf.color)) <= max(wanted) or layer.dxf.color == 7  # which is black on paper


def test_line_types_and_weights_are_those_of_the_layers_or_their_own():
    document = read(sheet("kind-2-rrp"))
    layers = {layer.dxf.name: layer.dxf for layer in document.layers}
    assert (layers["SCHEME"].lineweight, layers["AXIS"].lineweight, layers["CONSTRUCTION"].lineweight) == (60, 20, 20)
    assert layers["AXIS"].linetype == "DASHDOT2"

    def looks(e):
        weight = e.dxf.lineweight if e.dxf.hasattr("lineweight") else layers[e.dxf.layer].lineweight
        return e.dxf.layer, weight, e.dxf.get("linetype", layers[e.dxf.layer].linetype)

    seen = {looks(e) for e in document.modelspace().query("LINE LWPOLYLINE")}
    assert {("CONSTRUCTION", 20, "Continuous"), ("SCHEME", 60, "Continuous"), ("TABLE", 20, "Continuous")} <= seen
    own = [e for e in document.modelspace().query("LINE") if e.dxf.hasattr("lineweight")]
    assert own and all(e.dxf.lineweight != layers[e.dxf.layer].lineweight for e in own)


def test_dashes_are_stretched_to_whole_ones_as_in_the_other_formats():
    ends = (70 + 10j, 24 + 20j, 18 + 30j)
    marks = [Line((complex(10, z.imag), z), "axis", "axis") for z in ends]
    long, piece, short = ezdxf.read(io.StringIO(dxf.write(marks, (100, 100), "t").decode())).modelspace().query("LINE")
    period = sum(pen_of_style("axis").pattern)
    count = round((60 - 10) / period)
    assert long.dxf.ltscale == pytest.approx(60 / (count * period + 10), abs=1e-5)
    assert not long.dxf.hasattr("linetype")  # its layer's
    assert piece.dxf.ltscale == pytest.approx(14 / (period + 10), abs=1e-5)  # dash, dot, dash: still an axis
    assert not piece.dxf.hasattr("linetype")
    assert short.dxf.linetype == "Continuous"


@pytest.mark.slow
def test_the_same_bytes_twice_and_a_file_by_its_suffix(tmp_path):
    found = sheet("kind-2-rrp")
    one = dxf.write(found.marks, found.size, found.title)
    assert one == dxf.write(found.marks, found.size, found.title)
    draw_sheet(load(SAMPLES["kind-2-rrp"]), None, str(tmp_path / "a.dxf"))
    assert (tmp_path / "a.dxf").read_bytes() == one


@pytest.mark.slow
def test_the_same_bytes_whatever_python_makes_its_sets_of():
    """Of every format that is written from marks; this process has a seed of its own."""
    program = (
        "import sys\nfrom tests.helpers.sheets import sheet\n"
        "found = sheet('kind-1-rrr')\nfor suffix in ('.dxf', '.svg', '.pdf'):\n"
        "    sys.stdout.buffer.write(found.file_contents(suffix))\n"
    )
    run = [sys.executable, "-c", program]
    seeds = ({**os.environ, "PYTHONPATH": str(ROOT), "PYTHONHASHSEED": seed} for seed in "12")
    told = {subprocess.run(run, env=e, capture_output=True, check=True).stdout for e in seeds}
    assert told == {b"".join(sheet("kind-1-rrr").file_contents(suffix) for suffix in (".dxf", ".svg", ".pdf"))}


# blocks


def test_hinges_supports_sliders_and_points_are_blocks():
    found = sheet("six-link")
    inserts = read(found).modelspace().query("INSERT")
    names = [e.dxf.name for e in inserts]
    hinges = [
        m for m in found.marks if isinstance(m, Arc) and m.fill == "paper" and abs(m.radius - HINGE_RADIUS_MM) < 1e-9
    ]
    assert names.count("HINGE") + names.count("SUPPORT") == len(hinges)
    assert names.count("SUPPORT") == 2  # A and D
    assert {"POINT", "FORM_1"} <= set(names)
    slider = next(e for e in inserts if e.dxf.name == "SLIDER_575")  # 8 × 4.6 mm
    assert slider.dxf.xscale == slider.dxf.yscale == pytest.approx(8)


@pytest.mark.parametrize("turn", [0.0, 37.0, 90.0, 270.0])
def test_a_support_is_known_at_any_turn_and_one_that_is_cut_stays_lines(turn):
    marks = symbols.fixed_hinge(50 + 50j, turn)
    (insert,) = ezdxf.read(io.StringIO(dxf.write(marks, (100, 100), "t").decode())).modelspace()
    assert (insert.dxf.name, tuple(insert.dxf.insert)[:2]) == ("SUPPORT", (50.0, 50.0))
    assert (insert.dxf.rotation - turn + 180) % 360 - 180 == pytest.approx(0, abs=1e-6)
    over = (*marks, *symbols.hinge(50 + 50j - 7j * symbols.unit_vector(turn)))
    space = ezdxf.read(io.StringIO(dxf.write(over, (100, 100), "t").decode())).modelspace()
    assert [e.dxf.name for e in space.query("INSERT")] == ["HINGE", "HINGE"]
    assert len(space.query("LINE")) > 5


@pytest.mark.slow
def test_the_cells_of_the_form_are_attributes_to_be_edited():
    found = sheet("kind-2-rrp", student="Иванов И. И.", designation="ТММ.01.02.000", title="Длинное название механизма")
    document = read(found)
    (form,) = [e for e in document.modelspace().query("INSERT") if e.dxf.name == "FORM_1"]
    values = {a.dxf.tag: a.dxf.text for a in form.attribs}
    assert (values["STUDENT"], values["DESIGNATION"]) == ("Иванов И. И.", "ТММ.01.02.000")
    assert values["DESIGNATION_TURNED"] == "ТММ.01.02.000" and values["TEACHER"] == ""
    assert f"{values['TITLE']} {values['TITLE_LINE_2']}" == "Длинное название механизма"
    assert {key.upper() for key in form1.fill_in_cells(found.size)} <= set(values)
    defined = {e.dxf.tag: e for e in document.blocks["FORM_1"].query("ATTDEF")}
    assert set(defined) == set(values)
    assert defined["STUDENT"].dxf.prompt == "разработал (11)"
    for value in form.attribs:  # a value stands where its definition stands
        assert value.get_placement()[1].isclose(defined[value.dxf.tag].get_placement()[1])
    assert {tag for tag, text in values.items() if text} == {a.dxf.tag for a in form.attribs if a.is_invisible}
    written = [e.dxf.text for e in document.modelspace().query("TEXT") if e.dxf.layer == "FRAME"]
    assert sorted(written) == sorted(text for text in values.values() if text)  # for programs that show no attributes


# lettering


@pytest.mark.slow
def test_strokes_instead_of_texts_have_the_width_of_their_pen():
    found = sheet("kind-1-rrr")
    entities = apart(read(found, text="strokes"))
    assert not [e for e in entities if e.dxftype() in ("TEXT", "MTEXT", "ATTRIB")]
    word = next(m for m in found.marks if isinstance(m, Text) and m.text.startswith("План скоростей"))
    first = lay_out_text(word).strokes[0]
    drawn = [e for e in entities if e.dxftype() == "LWPOLYLINE" and len(e) == len(first)]
    near = [e for e in drawn if abs(complex(*e[0][:2]) - first[0]) < 1e-5]
    assert [e.dxf.lineweight for e in near] == [50]  # a tenth of 5 mm


@pytest.mark.slow
def test_slanted_lettering_is_oblique():
    document = read(sheet("kind-1-rrr", lettering="slanted"))
    assert document.styles.get("lc_opengost-br").dxf.oblique == 15
    texts = document.modelspace().query("TEXT")
    assert {(e.dxf.oblique, e.dxf.style) for e in texts} == {(15.0, "lc_opengost-br")}
    assert pytest.approx(np.tan(np.radians(15))) == lettering.SLANT_SHEAR


@pytest.mark.slow
def test_a_font_gives_its_own_style():
    document = read(sheet("kind-1-rrr", font="DejaVu Sans"))
    style = document.styles.get("DejaVu Sans")
    assert style.dxf.font == "DejaVuSans.ttf"
    assert style.get_extended_font_data()[0] == "DejaVu Sans"
    assert {e.dxf.style for e in document.modelspace().query("TEXT")} == {"DejaVu Sans"}


@pytest.mark.slow
def test_the_command_takes_strokes(tmp_path):
    path = tmp_path / "a.dxf"
    assert main(["sheet", str(SAMPLES["kind-1-rrr"]), "--text", "strokes", "-o", str(path)]) == 0
    assert not ezdxf.readfile(path).modelspace().query("TEXT")


# the picture

DPI = 127.0  # five pixels in a millimetre


def picture(document, size):
    """The ink of a DXF as ezdxf's own renderer draws it."""
    import matplotlib.pyplot as plt
    from ezdxf.addons.drawing import Frontend, RenderContext
    from ezdxf.addons.drawing.config import BackgroundPolicy, Configuration
    from ezdxf.addons.drawing.matplotlib import MatplotlibBackend

    figure = plt.figure(figsize=(size[0] / 25.4, size[1] / 25.4))
    axes = figure.add_axes((0, 0, 1, 1))
    config = Configuration(background_policy=BackgroundPolicy.WHITE, lineweight_scaling=72 / 25.4, min_lineweight=0.01)
    frontend = Frontend(RenderContext(document), MatplotlibBackend(axes), config)
    frontend.draw_layout(document.modelspace(), finalize=False)
    axes.set_axis_off()
    axes.set_aspect("auto")
    axes.set_xlim(0, size[0])
    axes.set_ylim(0, size[1])
    out = io.BytesIO()
    figure.savefig(out, dpi=DPI)
    plt.close(figure)
    return inked(out.getvalue())


def inked(data):
    with Image.open(io.BytesIO(data)) as image:
        return np.asarray(image.convert("L")) < 215


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "settings"),
    [("kind-1-rrr", {}), ("kind-2-rrp", {"lettering": "slanted"}), ("vectors", {"font": "DejaVu Serif"})],
)
def test_the_drawing_looks_as_the_sheet(name, settings):
    """All ink of either within 0.45 mm of ink of the other, but for spikes at corners: the renderer mitres them."""
    import cv2

    found = sheet(name, **settings)
    one = picture(read(found, text="strokes"), found.size)
    other = inked(pdf.write_png(found.marks, found.size, found.title, dpi=DPI))
    high, wide = (min(a, b) for a, b in zip(one.shape, other.shape, strict=True))
    one, other = one[:high, :wide], other[:high, :wide]
    mm = 25.4 / DPI
    for a, b in ((one, other), (other, one)):
        apart_mm = cv2.distanceTransform((~b).astype(np.uint8), cv2.DIST_L2, cv2.DIST_MASK_PRECISE)[a] * mm
        assert np.mean(apart_mm > 0.45) < 0.003
        assert apart_mm.max() < 2.0


# cost


@pytest.mark.slow
@pytest.mark.parametrize("suffix", ["svg", "dxf"])
def test_a_full_a1_sheet_is_drawn_within_so_many_calls(suffix, tmp_path):
    text = SAMPLES["six-link"].read_text(encoding="utf-8")
    (tmp_path / "a1.yaml").write_text(text + "\nsheet: {format: A1, positions: 12, designation: ТММ.01}\n", "utf-8")
    drawn = tmp_path / f"a1.{suffix}"
    with at_most(8_000_000):
        assert main(["sheet", str(tmp_path / "a1.yaml"), "--sheet", "1", "-o", str(drawn)]) == 0
    assert drawn.stat().st_size > 100_000


@pytest.mark.parametrize(
    ("said", "text", "kinds"), [("v_{CB}", "text", ["MTEXT"]), ("v_{CB}", "pieces", ["TEXT", "TEXT"])]
)
def test_an_index_is_a_text_of_its_own_by_choice(said, text, kinds):
    mark = Text(said, 10 + 50j, 5.0)
    found = list(ezdxf.read(io.StringIO(dxf.write([mark], (100, 100), "t", text=text).decode())).modelspace())
    assert [e.dxftype() for e in found] == kinds
    if text == "pieces":
        assert [(e.dxf.text, round(e.dxf.height, 3)) for e in found] == [
            (run.text, round(run.height, 3)) for run in lay_out_text(mark).runs
        ]


def test_a_line_of_prose_is_as_wide_as_drawn():
    mark = Text(
        "значения расходятся с точными на 5 %; вне допуска одно: v_{H} = 1,38 м/с вместо 1,001 м/с", 10 + 50j, 2.5
    )
    found = list(ezdxf.read(io.StringIO(dxf.write([mark], (300, 100), "t").decode())).modelspace())
    assert {e.dxftype() for e in found} == {"TEXT"} and len(found) == len(lay_out_text(mark).runs) == 3
    end = max((e.dxf.align_point if e.dxf.hasattr("align_point") else e.dxf.insert).x for e in found)
    assert end == pytest.approx(10 + lay_out_text(mark).width, abs=0.5)
