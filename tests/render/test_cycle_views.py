"""Views of the whole cycle on sheets: asked diagrams and hodographs beside the rest, constructions as drawn."""

from __future__ import annotations

from dataclasses import replace

import pytest

from planes import cycle
from planes.diagrams.graphical_text import both_graphical_constructions
from planes.documents.cycle import cycle_page, with_suitable_units
from planes.documents.drawn import page_of_view
from planes.documents.sheets import sheet_of
from planes.scene import load
from planes.words.naming import Naming
from render.files import Page
from render.paper.letters import mu_with_unit, name_with_unit, unit_text
from render.paper.marks import Arc, Line, Text
from render.paper.typeset import plain_text
from render.views.curve_pieces import continuous_runs
from render.views.diagrams import LINE_SAMPLE_LENGTH_MM, DiagramCurve
from render.views.graphical import Graphical, crop_curve, smooth_curve
from tests.helpers import ROOT
from tests.helpers.conflicts import conflicts
from tests.render.test_sheet import clashes

SAMPLES = ROOT / "samples"
ASKED = {
    "assignment-12": {"diagrams": ["u_31", "aq_slide_5", "M_1", "F_21"], "hodographs": ["F_21", "v_D"]},
    "sliding-driver": {"diagrams": "omegaq_3, Fb_1", "hodographs": "F_30"},
}


@pytest.mark.few(0)
@pytest.mark.parametrize("name", ASKED)
def test_asked_diagrams_and_hodographs_stand_on_sheet_1_without_an_overlap(name: str) -> None:
    scene = load(SAMPLES / f"{name}.yaml")
    found = sheet_of(replace(scene, sheet={**scene.sheet, **ASKED[name]}), None, "ru", 1)
    assert clashes(found) == []
    said = {plain_text(m.text) for m in found.marks if isinstance(m, Text)}
    assert "Диаграммы за цикл" in said and any(t.startswith("Годограф F") for t in said)
    asked = ASKED[name]["diagrams"]
    assert sum(", μ" in t and not t.startswith(("Годограф", "Схема", "План")) for t in said) >= len(
        asked if isinstance(asked, list) else asked.split(",")
    )


def test_a_construction_is_drawn_where_its_marks_are() -> None:
    scene = load(SAMPLES / "assignment-12.yaml")
    c = both_graphical_constructions(scene, 12)[0]
    drawing = c.draw_construction()
    marks = Graphical(c, drawing, Naming("ru")).drawn_marks()
    poles = [m for m in marks if isinstance(m, Text) and m.text == "P"]
    assert len(poles) == 2
    rays = [m for m in marks if isinstance(m, Line) and m.style == "construction" and m.points[0].real < -1]
    assert len([r for r in rays if abs(r.points[1].real) < 1e-9]) == 24
    dots = [m for m in marks if isinstance(m, Arc) and m.fill == "ink" and m.layer == "plan"]
    place = drawing["diagram:s:3"]
    assert any(abs(d.centre - place) < 1e-9 for d in dots)
    exact = [m for m in marks if isinstance(m, Line) and m.style == "dash" and m.layer == "plan"]
    assert [len(m.points) for m in exact] == [121, 121, 2]  # two exact curves and the legend's sample


def test_the_french_curve_goes_through_its_points_and_is_cut_at_the_ends() -> None:
    points = [complex(x, (x - 2) ** 3) for x in range(-2, 8)]
    path = smooth_curve(points)
    assert all(min(abs(p - q) for q in path) < 1e-12 for p in points)
    inside = crop_curve(path, 5.0)
    assert (inside[0].real, inside[-1].real) == pytest.approx((0.0, 5.0))
    assert max(abs(z.imag - (z.real - 2) ** 3) for z in inside) < 0.6


def test_a_single_gap_in_a_hodograph_is_a_jump_and_a_wide_one_is_not() -> None:
    path = (0j, 1j, None, 3j, 4j, None, None, 6j, 7j)
    assert continuous_runs(path) == [([0j, 1j], False), ([1j, 3j], True), ([3j, 4j], False), ([6j, 7j], False)]
    assert continuous_runs((0j, 1j, None, 2 + 1j, 3 + 1j), 1.0) == [([0j, 1j], False), ([2 + 1j, 3 + 1j], False)]


TO_READ: dict[str, tuple[list[str] | None, list[str], list[str]]] = {
    "six-link": (None, [], []),
    "sliding-driver": (None, ["F_30"], []),
    "assignment-12": (["s_5", "vq_D+vq_S3", "coriolis_2", "F_21"], ["F_21"], ["D", "S3"]),
}


def page_of(name: str) -> Page:
    return cycle_page(load(SAMPLES / f"{name}.yaml"), None, *TO_READ[name], lang="en")


@pytest.mark.parametrize("name", TO_READ)
def test_nothing_overlaps_in_the_picture_of_a_cycle(name: str) -> None:
    found = page_of(name)
    assert conflicts((), found.marks, (0.0, 0.0, *found.size)) == ()


def numbers_of(found: Page, anchor: str) -> list[tuple[float, complex]]:
    """Numbers lettered small, with their places."""
    small = [m for m in found.marks if isinstance(m, Text) and m.height == 2.5 and m.anchor == anchor]
    return [(float(plain_text(m.text).replace("−", "-")), m.place) for m in small]


def test_values_are_read_off_the_picture_of_a_cycle() -> None:
    scene = load(SAMPLES / "six-link.yaml")
    found = cycle_page(scene, None, ["v_slide_5"], None, None, "en")
    across, along = numbers_of(found, "middle"), numbers_of(found, "end")
    assert len(across) == 13 and len(along) > 5
    at, (lowest, foot), (highest, head) = across[8], along[0], along[-1]
    curve = [z for m in found.marks if isinstance(m, Line) and m.style == "thick" for z in m.points]
    height = min(curve, key=lambda z: abs(z.real - at[1].real)).imag - 1.25  # a number's foot is beneath its stroke
    read = lowest + (height - foot.imag) * (highest - lowest) / (head.imag - foot.imag)
    assert read == pytest.approx(float(cycle(scene, ["v_slide_5"], phi=[at[0]])["v_slide_5"][0]), abs=0.2)
    dots = sorted(m.centre.imag for m in found.marks if isinstance(m, Arc) and m.fill == "ink")
    assert dots == pytest.approx([min(z.imag for z in curve), max(z.imag for z in curve)], abs=0.01)
    said = {plain_text(m.text) for m in found.marks if isinstance(m, Text)}
    assert {"−38.01", "31.73", "v5, m/s, μv = 0.5 mm/(m/s)", "φ1, °", "Six-link lever mechanism"} <= said


def test_curves_on_the_same_axes_have_lines_of_their_own_and_jumps_are_dashed() -> None:
    found = page_of("assignment-12")
    long = [m for m in found.marks if isinstance(m, Line) and m.layer == "plan" and len(m.points) > 100]
    assert [m.style for m in long].count("dash") == 2  # of v_qS3, before and after its dead point
    named = [
        m.style for m in found.marks if isinstance(m, Line) and m.layer == "plan" and length(m) == LINE_SAMPLE_LENGTH_MM
    ]
    assert named == ["thick", "dash"]
    turned_about = cycle_page(load(SAMPLES / "assignment-12.yaml"), None, ["F_21"], None, None, "en")
    jumps = [m for m in turned_about.marks if isinstance(m, Line) and m.layer == "plan" and len(m.points) == 2]
    assert {m.style for m in jumps} == {"dash"} and max(map(length, jumps)) > 4.0


def length(line: Line) -> float:
    return round(abs(line.points[-1] - line.points[0]), 9)


def test_a_hodograph_has_a_pole_and_equal_scales_and_a_path_neither_pole_nor_origin() -> None:
    scene = load(SAMPLES / "assignment-12.yaml")
    for loops, paths, title in ((["F_21"], None, "Hodograph of F21"), (None, ["D"], "Path of point D")):
        found = cycle_page(scene, None, None, loops, paths, "en")
        said = [plain_text(m.text) for m in found.marks if isinstance(m, Text)]
        assert any(text.startswith(title) for text in said) and ("p" in said) is bool(loops)
        assert {str(k) for k in range(12)} <= set(said)
        across, along = numbers_of(found, "middle"), numbers_of(found, "end")
        (x, left), (x2, right) = [z for z in across if z[1].imag == min(w.imag for _, w in across)][:2]
        (y, low), (y2, high) = along[:2]
        assert (right - left).real / (x2 - x) == pytest.approx((high - low).imag / (y2 - y))


@pytest.mark.parametrize("lang", ["ru", "en"])
def test_the_self_aligning_variant_names_every_pair(lang: str) -> None:
    found = page_of_view(load(SAMPLES / "six-link.yaml"), "self-aligning", None, lang)  # type: ignore[arg-type]
    said = " ".join(plain_text(m.text) for m in found.marks if isinstance(m, Text))
    short = ("1в", "2ц", "3с") if lang == "ru" else ("1R", "2C", "3S")
    assert all(text in said for text in (*short, "W = 6n", "q = 0", "(5–6)", "(2–4)"))


def test_a_unit_is_said_in_one_way_everywhere():
    assert [unit_text(key, "ru") for key in ("°", "1", "", "kgm2", "1/m")] == ["°", "", "", "кг·м²", "1/м"]
    told = [mu_with_unit(20.0, key, Naming("en")) for key in ("m", "m/s²", "°", "1")]
    assert told == ["20 mm/m", "20 mm/(m/s²)", "20 mm/°", "20 mm"]
    assert (name_with_unit("u", "1", "en"), name_with_unit("v", "m/s", "ru")) == ("u", "v, м/с")


def test_curves_of_one_axis_keep_one_scale():
    """Forces and moments have a multiple of their units; beside a speed, which has none, neither has."""
    force, moment, speed = (
        DiagramCurve("y", unit, (5e4, None, -2e4), ends=((0.0, 5e4),)) for unit in ("N", "N·m", "m/s")
    )
    one, other = with_suitable_units([force, moment])
    assert (one.unit, other.unit) == ("kN", "kN·m")
    assert one.values == (50.0, None, -20.0) and one.ends == ((0.0, 50.0),)
    assert with_suitable_units([force, speed]) == [force, speed]
    assert with_suitable_units([speed, force]) == [speed, force]
