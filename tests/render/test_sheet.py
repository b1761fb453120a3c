"""Whole sheets: nothing overlaps, nothing leaves the frame, every name is there, in every format and language."""

from __future__ import annotations

import math
import re

import pytest
import shapely

from planes.cli import main
from planes.documents.drawn import draw_sheet
from planes.documents.sheets import sheet_of
from planes.scene import load, loads
from planes.solving import solve
from planes.words.errors import PlanesError
from render.files import pdf, svg
from render.paper.marks import Arrow, Line, Text
from render.paper.style import pen_of_style
from render.paper.typeset import ink_width, lay_out_text, plain_text
from render.sheet.module import VIEW_GAP_MM
from render.views.table_grid import TableGrid
from tests.helpers import ROOT
from tests.helpers.conflicts import conflicts
from tests.helpers.glyphs import missing
from tests.helpers.scene_texts import SIX_LINK
from tests.helpers.sheets import sheet

SAMPLES = sorted((ROOT / "samples").glob("*.yaml"))
NAMES = [path.stem for path in SAMPLES]


def texts(sheet):
    return [m for m in sheet.marks if isinstance(m, Text)]


def words(sheet):
    return {plain_text(m.text) for m in texts(sheet)}


def clashes(sheet):
    """All but the bars over vectors, which lie within the boxes of their own letters, beside upper indices.

    The form's own columns stand outside the frame, on the paper; everything else inside.
    """
    found = [str(c) for c in conflicts((), sheet.marks, (0.0, 0.0, *sheet.size))]
    found += [str(c) for c in conflicts((), [m for m in sheet.marks if m.layer != "frame"], sheet.paper.field)]
    return [c for c in found if " lies on 'line of text" not in c]


@pytest.mark.few(1, slow=8)
@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("lang", ["ru", "en"])
def test_nothing_overlaps_and_nothing_leaves_the_frame(name, lang):
    assert clashes(sheet(name, lang)) == []


@pytest.mark.few(0, slow=10)
@pytest.mark.parametrize("name", NAMES)
def test_bars_and_underlines_cross_no_letter(name):
    found = sheet(name)
    rules = [m for m in found.marks if isinstance(m, Line) and m.layer == "text"]
    lines = LineTree(rules)
    for text in texts(found):
        for stroke in lay_out_text(text).strokes:
            assert not lines.hit(stroke), text


class LineTree:
    """Straight level lines, and whether a stroke crosses one."""

    def __init__(self, rules):
        self.tree = shapely.STRtree([shapely.LineString([(z.real, z.imag) for z in m.points]) for m in rules])

    def hit(self, stroke):
        shape = shapely.LineString([(z.real, z.imag) for z in stroke]) if len(stroke) > 1 else None
        return shape is not None and len(self.tree.query(shape, predicate="intersects"))


@pytest.mark.few(1)
@pytest.mark.parametrize("name", NAMES)
def test_views_keep_their_distance(name):
    found = sheet(name)
    boxes = [(left, top - v.height, left + v.width, top) for v, left, top in found.views]
    boxes += found.paper.occupied_areas
    for k, a in enumerate(boxes):
        for b in boxes[:k]:
            apart = max(b[0] - a[2], a[0] - b[2], b[1] - a[3], a[1] - b[3])
            assert apart > VIEW_GAP_MM - 1e-6 or {a, b} == set(found.paper.occupied_areas)


@pytest.mark.few(1, slow=10)
@pytest.mark.parametrize("name", NAMES)
def test_every_letter_has_a_glyph(name):
    for lang in ("ru", "en"):
        assert missing("".join(words(sheet(name, lang)))) == ""


@pytest.mark.few(1)
@pytest.mark.parametrize("name", [n for n in NAMES if n != "vectors"])
def test_points_marks_forces_and_results_are_all_named(name):
    scene = load(next(p for p in SAMPLES if p.stem == name))
    position = solve(scene).positions[0]
    said = words(sheet(name))
    joined = " ".join(said)
    every = {name for text in said for name in text.split(", ")}
    for link in scene.mechanism.links.values():
        assert set(link.points) <= every
    moving = [p for p, r in position.results["points"].items() if math.hypot(*r["v"]) > 1e-6]
    for point in moving:
        assert any(point.lower() in text.split(", ") for text in said)
    for force in position.plans.reactions:
        assert force.replace("F_", "F").replace("0", scene.frame_number) in joined
    assert {"Исходные данные", "Реакции"} <= said


@pytest.mark.slow
def test_titles_name_the_plan_and_its_scale():
    said = words(sheet("six-link"))
    assert "План скоростей, μv = 30 мм·с/м" in said
    assert "План ускорений, μa = 2 мм·с²/м" in said
    assert "Схема механизма, μl = 250 мм/м" in said
    assert "Velocity polygon, μv = 30 mm/(m/s)" in words(sheet("six-link", "en"))


def test_marks_stand_where_they_were_drawn():
    found = sheet("six-link")
    position = solve(load(SAMPLES[NAMES.index("six-link")])).positions[0]
    drawn = {m.name: m.end - m.start for m in found.marks if isinstance(m, Arrow)}
    for name, start, end in (("v_B", "p", "b"), ("v_CB", "b", "c"), ("v_HL", "l", "h")):
        segment = position.drawing[f"velocity:{end}"] - position.drawing[f"velocity:{start}"]
        assert abs(drawn[name] - segment) < 1e-9


def test_every_width_of_pen_has_its_meaning():
    """Links and results are thick, forces and the vectors of a plan thinner, all that helps thinnest; all is black."""
    found = sheet("six-link")
    styles = {m.name: m.style for m in found.marks if isinstance(m, Arrow)}
    assert styles["v_B"] == styles["F_21"] == "result"
    assert styles["v_CB"] == styles["a_CB^n"] == styles["F_21^t"] == styles["G_2"] == "vector"
    loads = {m.style for m in sheet("six-link", number=2).marks if isinstance(m, Arrow) and m.layer == "force"}
    assert loads == {"vector"} and pen_of_style("vector").width < pen_of_style("thick").width
    lines = {(m.layer, m.style) for m in found.marks if isinstance(m, Line)}
    assert {style for layer, style in lines if layer == "table"} == {"thin", "rule"}
    helping = {style for layer, style in lines if layer in ("construction", "dimension", "hatch", "axis")}
    assert "construction" in helping
    for style in helping:
        assert (pen_of_style(style).width, pen_of_style(style).colour) == (
            pytest.approx(pen_of_style("thick").width / 3),
            "#000000",
        )


def test_numbers_of_a_results_table_stand_comma_under_comma():
    drawn = TableGrid(3.5).drawn_marks(["", "мм"], [["a", "120,0"], ["b", "9,55"], ["c", "0,928"], ["d", "—"]])
    places = {m.text: m.place.real for m in drawn if isinstance(m, Text)}
    ends = [places[n] + ink_width(n.partition(",")[0], 3.5) for n in ("120,0", "9,55", "0,928")]
    assert ends == pytest.approx([ends[0]] * 3) and places["—"] > places["120,0"]
    table = next(v for v, *_ in sheet("kind-3-rpr", number=1).views if v.key == "rates-table")
    numbers = [m.text for m in table.marks if isinstance(m, Text) and re.fullmatch(r"[\d,]+", m.text)]
    assert {"60,0", "12,0", "1,80", "9,55"} <= set(numbers)
    assert all(len(n.replace(",", "").lstrip("0")) in (2, 3, 4) for n in numbers)  # lengths have a tenth


def test_reactions_and_arms_are_told_in_mm_of_their_figures():
    position = solve(load(ROOT / "samples/six-link.yaml")).positions[0]
    views = {v.key: v for v, *_ in sheet("six-link", number=2).views}
    rows = [m.text for m in views["reactions"].marks if isinstance(m, Text)]
    size = abs(position.of("reactions")["F_21"].vector)
    found = rows[rows.index("F_{21}") + 1]
    mu = next(v.title for v, *_ in sheet("six-link", number=2).views if v.key == "force:2-3").rpartition("=")[2]
    assert float(found.replace(",", ".")) == pytest.approx(size * float(mu.split()[0].replace(",", ".")), abs=0.051)
    moments = [v for v, *_ in sheet("six-link", number=2).views if v.key == "group" and "2–3" in v.title]
    said = {plain_text(m.text) for m in moments[0].marks if isinstance(m, Text)}
    arm = next(m for m in moments[0].marks if isinstance(m, Line) and m.layer == "dimension")
    assert "h, мм" in said and f"{abs(arm.points[1] - arm.points[0]):.1f}".replace(".", ",") in said


def test_underlines_count_what_is_known():
    from planes.solving import solve
    from render.sheet.composer import Naming
    from render.views.formulas import Formulas
    from render.views.plotted import plot_position

    (found,) = solve(load(SAMPLES[NAMES.index("vectors")])).positions
    marks = Formulas(plot_position(found), Naming()).drawn_marks(("velocity",))
    at = {plain_text(m.text): m.place.real for m in marks if isinstance(m, Text) and m.name}
    under = [m.points[0].real for m in marks if isinstance(m, Line) and m.points[0].imag < 0]
    assert [sum(abs(x - at[n]) < 1e-9 for x in under) for n in ("vC", "vB", "vCB")] == [1, 2, 1]


TURNING = [
    n
    for n in NAMES
    if not n.startswith("vectors")
    and n not in ("sliding-driver", "lift", "hinge-motor", "carriage", "folding-boom", "excavator")
]
POSITIONS = [(n, 30.0 * k) for n in TURNING for k in range(12) if not n.startswith("bntu") or k % 4 == 1]


@pytest.mark.few(1, slow=12)
@pytest.mark.parametrize(("name", "value"), POSITIONS)
def test_twelve_positions_have_no_clashes(name, value):
    try:
        found = sheet(name, "ru", value)
    except PlanesError as error:
        assert "φ = " in str(error) or "μ" in str(error)
        return
    assert clashes(found) == []


@pytest.mark.slow
@pytest.mark.parametrize("name", ["six-link", "kind-3-rpr", "vectors"])
def test_the_same_bytes_twice(name):
    path = SAMPLES[NAMES.index(name)]
    one, two = sheet(name), sheet_of(load(path), None)
    assert svg.write(one.marks, one.size, one.title) == svg.write(two.marks, two.size, two.title)
    assert pdf.write(one.marks, one.size, one.title) == pdf.write(two.marks, two.size, two.title)


@pytest.mark.slow
def test_three_formats_open(tmp_path):
    import xml.etree.ElementTree as ElementTree

    import pypdfium2
    from PIL import Image

    draw_sheet(load(SAMPLES[NAMES.index("kind-2-rrp")]), None, str(tmp_path / "sheet.svg"))
    for suffix in ("pdf", "png"):
        sheet("kind-2-rrp").write(tmp_path / f"sheet.{suffix}")
    root = ElementTree.parse(tmp_path / "sheet.svg").getroot()
    wide, high = sheet("kind-2-rrp").size
    assert (root.get("width"), root.get("height")) == (f"{wide:g}mm", f"{high:g}mm")
    document = pypdfium2.PdfDocument(tmp_path / "sheet.pdf")
    page = document[0].get_textpage()
    text = page.get_text_range()
    page.close()
    document.close()
    assert "План скоростей" in text
    with Image.open(tmp_path / "sheet.png") as picture:
        assert picture.size == pytest.approx((wide / 25.4 * 200, high / 25.4 * 200), abs=1.5)
    assert sorted(p.name for p in tmp_path.iterdir()) == ["sheet.pdf", "sheet.png", "sheet.svg"]


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["-o", "sheet.bmp"], ".svg"),
        (["-o", "nowhere/sheet.svg"], "nowhere"),
        (["-o", "sheet.svg", "--phi", "0:90:30"], "4"),
    ],
)
def test_failures_are_one_sentence_and_leave_nothing(arguments, said, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(["sheet", str(SAMPLES[NAMES.index("six-link")]), *arguments]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.count("\n") == 1
    assert said in err
    assert list(tmp_path.iterdir()) == []


def test_a_position_that_cannot_be_drawn_leaves_no_file(tmp_path, capsys):
    target = tmp_path / "sheet.svg"
    assert main(["sheet", str(SAMPLES[NAMES.index("six-link")]), "--phi", "0", "-o", str(target)]) == 2
    assert "φ = 0°" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def six_link(**sheet_settings):
    text = SIX_LINK.replace("find:", "# find:").replace("friction:", "# friction:")
    settings = ", ".join(f"{key}: {value}" for key, value in sheet_settings.items())
    return loads(text + f"\nsheet: {{{settings}}}\n")


def test_a_fixed_format_that_is_too_small_names_a_view_and_what_would_do():
    with pytest.raises(PlanesError, match=r"A4.*План ускорений.*A2"):
        sheet_of(six_link(format="A4"), None)
    assert sheet_of(six_link(format="A1"), None).paper.name == "A1"
    with pytest.raises(PlanesError, match="A7"):
        sheet_of(six_link(format="A7"), None)


def test_the_title_block_says_what_the_scene_says():
    scene = six_link(student="Иванов И. И.", teacher="Петров П. П.", designation="ТММ.01.02.000", company="БНТУ")
    said = words(sheet_of(scene, None))
    assert {"Иванов И. И.", "Петров П. П.", "ТММ.01.02.000", "БНТУ", "Разраб.", "Масштаб"} <= said


def test_reactions_and_scales_follow_the_settings():
    said = words(sheet_of(six_link(reactions="from-on", mu_convention="unit_per_mm"), None))
    assert any(text.startswith("План скоростей") and "м/(с·мм)" in text for text in said)
    assert {"R12", "R12τ", "aCBτ"} <= said and not any(re.match(r"F\d", text) for text in said)
