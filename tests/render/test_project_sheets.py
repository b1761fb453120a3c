"""Sheets 1 and 2 of a course project: their views, nothing overlapping, and what they say."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
import shapely

from planes.diagrams.turn import unwind_angles
from planes.documents.cycle import finite_or_none
from planes.documents.drawn import draw_sheet
from planes.documents.sheets import project_over_turn, sheet_of
from planes.plans.assur.analysis import analyse_structure
from planes.scene import load, loads
from planes.solving import plans_and_requested_results, solve
from planes.words.errors import PlanesError
from planes.words.naming import Naming
from render.labels import Label
from render.labels.footprints import overprinted_labels
from render.paper.marks import Arrow, Line, Shape, Text
from render.paper.style import BASE_LINE_LENGTH_MM
from render.paper.typeset import plain_text
from render.sheet.composer import Composer
from render.views.curve_pieces import continuous_runs
from render.views.dimensions import Size, draw_dimensions, stroke_dimension
from render.views.many import ManyPositions, Numbered, PlacedMechanism
from render.views.plotted import joint_stroke
from render.views.scheme import Scheme
from render.views.senses import POSITION_NAME_PREFIX, marks_with_labels
from tests.helpers import ROOT, sheets
from tests.helpers.conflicts import conflicts
from tests.helpers.glyphs import missing
from tests.render.test_sheet import clashes

SAMPLES = sorted((ROOT / "samples").glob("*.yaml"))
SCENES = {path.stem: scene for path in SAMPLES if (scene := load(path)).mechanism}
ALL = {path.stem: path for path in [*SAMPLES, *(SAMPLES[0].parent / "assignments").glob("*.yaml")]}
ALL.pop("vectors")
NUMBERED = [(name, number) for name in SCENES for number in (1, 2)]


def sheet(name, number, value=None):
    return sheets.sheet(name, value=value, number=number, positions=12.0)


def words(sheet):
    return {plain_text(m.text) for m in sheet.marks if isinstance(m, Text)}


@pytest.mark.parametrize("turn", [1, 1j, -1])
def test_the_text_of_a_size_keeps_clear_of_lines_that_slant_over_it(turn):
    one = Size((0j, 100 * turn), (-20j * turn, (100 - 20j) * turn), -1j * turn, "1420,6")
    line = Line(((40 - 50j) * turn, (60 + 10j) * turn))
    for ground, free in (((), False), ((line,), True)):
        (text,) = (m for m in draw_dimensions([one], ground) if isinstance(m, Text))
        assert (conflicts([text], [line]) == ()) is free


@pytest.mark.few(1, slow=8)
@pytest.mark.parametrize(("name", "number"), NUMBERED)
def test_nothing_overlaps_and_every_letter_is_known(name, number):
    found = sheet(name, number)
    assert clashes(found) == []
    assert missing("".join(words(found))) == ""


@pytest.mark.few(0, slow=4)
@pytest.mark.parametrize(("name", "number"), NUMBERED)
@pytest.mark.parametrize("value", [45.0, 200.0])
def test_other_positions_do_not_overlap_either(name, number, value):
    if SCENES[name].mechanism.drive.kind == "s":
        return
    try:
        found = sheet(name, number, value)
    except PlanesError as error:
        assert "φ = " in str(error) or "μ" in str(error)
        return
    assert clashes(found) == []


@pytest.mark.few(1, slow=10)
@pytest.mark.parametrize("name", list(SCENES))
def test_sheet_1_shows_structure_plans_and_diagrams(name):
    said = words(sheet(name, 1))
    assert any(text.startswith("W = 3n") for text in said)
    assert any(text.startswith("I(") for text in said)
    assert "Исходные данные" in said
    assert any(text.startswith("Диаграммы") for text in said)


@pytest.mark.few(1, slow=10)
@pytest.mark.parametrize("name", list(SCENES))
def test_sheet_2_shows_every_group_with_its_forces_and_the_lever(name):
    found = sheet(name, 2)
    said = words(found)
    titles = [text for text in said if "с силами" in text]
    m = SCENES[name].mechanism
    assert len([t for t in titles if "Звено" not in t]) == len(analyse_structure(m).groups) + 1
    assert {"Реакции", "Уравновешивание и проверка"} <= said
    assert any(text.startswith("Рычаг Жуковского") for text in said)
    loads = {f"P_{x.link}" for x in m.loads if x.kind == "force"}
    assert loads <= {a.name for a in found.marks if isinstance(a, Arrow)}


def test_twelve_positions_are_numbered_from_an_extreme_one():
    said = words(sheet("kind-2-rrp", 1))
    assert {str(k) for k in range(12)} <= said
    assert "φ0 = 56,69°" in said or any(text.startswith("φ0 = ") for text in said)


@pytest.mark.parametrize(("points", "count"), [([], 1), (["B", "S1", "S2"], 3)])
def test_paths_are_of_hinges_or_of_the_points_chosen(points, count):
    """The slider's hinge moves along a straight guide: the crank's end alone has a path unless others are named."""
    scene = replace(load(ROOT / "samples" / "kind-2-rrp.yaml"), find=None, sheet={"positions": 12.0, "paths": points})
    drawn = [m for m in sheet_of(scene, None, number=1).marks if isinstance(m, Line) and m.style == "dash"]
    assert len(drawn) == count


def test_strokes_of_parallel_guides_are_not_drawn_upon_each_other():
    guides = "{g1: {angle: 0, through: [0, 0.2]}, g2: {angle: 0, through: [0, 0.21]}}"
    scene = loads(f"""\
planes: 1
frame: {{points: {{O: [0, 0]}}, guides: {guides}}}
links:
  1: {{points: {{O: 0, A: 0.05, D: [0, 0.05]}}}}
  2: {{points: {{A: 0, B: 0.3}}}}
  3: {{points: {{B: 0}}, slides: g1}}
  4: {{points: {{D: 0, E: 0.3}}}}
  5: {{points: {{E: 0}}, slides: g2}}
assembly: {{B: ahead, E: ahead}}
drive: {{link: 1, phi: 40, omega: 10}}
sheet: {{positions: 12}}
""")
    drawn = [m for m in sheet_of(scene, None, number=1).marks if isinstance(m, Text) and m.name == "stroke"]
    assert len(drawn) == 2 and abs(drawn[0].place.imag - drawn[1].place.imag) > 5


def test_a_path_of_no_point_is_an_error():
    scene = replace(load(ROOT / "samples" / "kind-2-rrp.yaml"), sheet={"paths": ["Z"]})
    with pytest.raises(PlanesError, match="Z; valid: A, B, S1, C, S2"):
        sheet_of(scene, None, number=1)


@pytest.mark.slow
def test_the_title_block_numbers_the_sheets():
    for number in (1, 2):
        said = {m.name: m.text for m in sheet("six-link", number).marks if isinstance(m, Text)}
        assert (said["cell sheet"], said["cell sheets"]) == (str(number), "2")


def test_a_sheet_of_a_project_is_written_by_its_number(tmp_path):
    draw_sheet(SCENES["kind-2-rrp"], None, str(tmp_path / "forces.svg"), "en", 2)
    assert "Zhukovsky" in (tmp_path / "forces.svg").read_text(encoding="utf-8")


def test_angles_are_unwound_and_gaps_split_a_curve():
    angles = unwind_angles([170.0, -170.0, math.nan, -150.0])
    assert finite_or_none(angles - np.nanmin(angles)) == (0.0, 20.0, None, 40.0)
    assert continuous_runs((1j, 1 + 2j, None, 3 + 3j, 4 + 4j), 1.0) == [
        ([1j, 1 + 2j], False),
        ([3 + 3j, 4 + 4j], False),
    ]


@pytest.mark.few(8)
@pytest.mark.parametrize("name", sorted(ALL))
def test_a_link_in_a_thin_position_has_the_shape_of_the_scheme(name):
    drawn = solve(replace(load(ALL[name]), find=None)).positions[0]
    scheme = Scheme(drawn, Naming("en"))
    for link in scheme.links:
        scheme.add_link(link)
    thick = [m for m in (*scheme.bars, *scheme.guides) if isinstance(m, Line)]
    lines = [[*m.points, *m.points[: m.closed]] for m in thick]
    inked = shapely.union_all([shapely.LineString([(z.real, z.imag) for z in line]) for line in lines]).buffer(0.05)
    here = PlacedMechanism(drawn.r, {name: f.number for name, f in drawn.of("links", "angle_deg").items()})
    many = ManyPositions(drawn.plans, [Numbered("1", here)], [here], drawn.scales["mu_position"])
    for one in many.marks:
        if one.style == "construction":
            line = [(z.real, z.imag) for z in (*one.points, *one.points[: one.closed])]
            assert inked.covers(shapely.LineString(line)), line


def test_the_path_of_a_rockers_point_is_drawn_once():
    """Dashes of its way back would fill the gaps of its way there; a crank's point goes round."""
    plans, turned = (
        plans_and_requested_results(load(ROOT / "samples" / "kind-1-rrr.yaml"))[0],
        0.4 * np.sin(np.linspace(0, 2 * np.pi, 37)),
    )
    many, pivot = ManyPositions(plans, [], [], 100.0), plans.mechanism.frame.points["D"]
    swing = [100 * (pivot + np.exp(1j * angle)) for angle in turned]
    there = many.one_way_slice("C", swing)
    assert (there.start, there.stop) == (9, 28)
    assert many.one_way_slice("E", swing) == slice(None)  # of a coupler
    assert many.one_way_slice("B", [10 * np.exp(1j * np.radians(k)) for k in range(361)]) == slice(0, 361)


@pytest.mark.few(2)
@pytest.mark.parametrize("name", ["six-link", "kind-3-rpr", "assignments/44", "assignments/22"])
def test_every_force_is_an_arrow_of_its_own(name):
    """None lies along another one, or along a rod, by more than what crossing lines share."""
    along = []
    for held in (one.marks for one, *_ in sheet(name, 2).views if one.key in ("loaded", "group", "apart", "lever")):
        forces = [(m.name, m.start, m.end) for m in held if isinstance(m, Arrow) and m.layer == "force"]
        bars = [m.points for m in held if isinstance(m, Line) and m.style == "thick" and m.layer == "scheme"]
        others = [
            *forces,
            *(("rod", a, b) for points in bars for a, b in pairwise(points) if abs(b - a) > BASE_LINE_LENGTH_MM),
        ]
        for k, (one, *ends) in enumerate(forces):
            shaft = shapely.LineString([(z.real, z.imag) for z in ends]).buffer(0.3)
            for other, *line in others[k + 1 :]:
                shared = shaft.intersection(shapely.LineString([(z.real, z.imag) for z in line])).length
                along += [f"{one} {other}"] * (shared > 4.0)
    assert along == []


def scheme_of(name):
    return next(v for v, _, _ in sheets.sheet(name, number=1).views if v.key == "scheme")


@pytest.mark.few(1)
@pytest.mark.parametrize(
    ("name", "stroke"), [("kind-2-rrp", "120,4"), ("assignments/30", "346,4"), ("crank-slider", "120")]
)
def test_sheet_1_shows_many_positions_and_the_stroke_unless_they_are_not_wanted(name, stroke):
    marks = scheme_of(name).marks
    numbers = {m.text for m in marks if isinstance(m, Text) and m.name.startswith("position ")}
    assert {str(k) for k in range(12)} <= numbers
    (k,) = [k for k, m in enumerate(marks) if isinstance(m, Text) and m.name == "stroke"]
    one, other = marks[k - 2 : k]
    assert marks[k].text == stroke and one.start == other.start
    (title,) = [m.text for m in marks if isinstance(m, Text) and m.name == "title scheme"]
    mu = float(re.search(r"= (\d+) мм/м", title)[1])
    assert f"{round(1000 * abs(one.end - other.end) / mu, 1):g}".replace(".", ",") == stroke
    without = next(v for v, _, _ in sheets.sheet(name, number=1, positions=False).views if v.key == "scheme")
    assert not any(isinstance(m, Text) and m.name.startswith("position ") for m in without.marks)


def test_sliders_are_numbered_in_their_extreme_places():
    marks = scheme_of("crank-slider").marks
    at = {m.name.partition(" of ")[2]: m.text for m in marks if isinstance(m, Text) and " of " in m.name}
    assert set(at) == {"B"}
    stations = [m.text for m in marks if isinstance(m, Text) and m.name.endswith(" of B")]
    assert stations == ["0", "6"]  # its extreme places


def test_a_stroke_that_is_not_drawn_whole_is_not_measured():
    assert not [m for m in scheme_of("six-link").marks if isinstance(m, Text) and m.name == "stroke"]


@pytest.mark.few(1, slow=8)
@pytest.mark.parametrize("name", ALL)
def test_what_holds_a_mechanism_is_measured_on_its_scheme_and_so_is_the_drivers_angle(name):
    """Every size is a distance of the frame's points or guides, none of which is left out that can be drawn."""
    path = ALL[name]
    scene, marks = load(path), scheme_of(str(path.relative_to(ROOT / "samples").with_suffix(""))).marks
    mechanism, (title,) = scene.mechanism, [m.text for m in marks if isinstance(m, Text) and m.name == "title scheme"]
    mu = float(re.search(r"= ([\d,]+) мм/м", title)[1].replace(",", "."))
    base = analyse_structure(mechanism).drive_pair.point
    held = [p for p in mechanism.frame.points if any(p in link.points for link in mechanism.links.values())]
    if base not in held:
        return
    ways = [mechanism.frame.points[p] - mechanism.frame.points[base] for p in held]
    used = {x.slides.guide for x in mechanism.links.values() if x.slides} & set(mechanism.frame.guides)
    rails = [(g.through - mechanism.frame.points[base], g.angle_deg % 180) for g in map(mechanism.guide, used)]
    level = [w.real for w in ways] + [w.real for w, turn in rails if turn == 90]
    upright = [w.imag for w in ways] + [w.imag for w, turn in rails if turn == 0]
    every = {f"{round(1000 * abs(t), 1):.7g}": abs(t) * mu for t in (*level, *upright)}
    sizes = {m.text.replace(",", ".") for m in marks if isinstance(m, Text) and m.name == "size"}
    assert {text for text, mm in every.items() if mm > 16} <= sizes <= {text for text, mm in every.items() if mm > 9}
    turned = mechanism.drive.kind == "phi" and mechanism.drive.position % 360 != 0
    assert (f"φ_{{{mechanism.drive.link}}}" in {m.text for m in marks if isinstance(m, Text)}) == turned


@pytest.mark.parametrize("name", ["six-link", "25", "41", "50", "52", "65"])
def test_two_rods_of_one_link_have_the_sign_of_a_rigid_joint(name):
    scheme = Scheme(solve(replace(load(ALL[name]), find=None)).positions[0], Naming("en"))
    scheme.drawn_marks()
    gussets = [m for m in scheme.bars if isinstance(m, Shape)]
    assert gussets and all(
        min(abs(m.points[0] - scheme.places.point_place(p)) for p in scheme.shared) < 0.1 for m in gussets
    )


@pytest.mark.parametrize("long", [14.0, 40.0])
def test_the_comma_of_a_size_is_clear_of_the_heads_beneath_it(long: float) -> None:
    size = stroke_dimension(0j, long + 0j, -10j, "388,2")
    near = Line((complex(0.2 * long, -12), complex(0.2 * long, -4)), "thin", "scheme")
    *_, one, other, text = size.dimension_marks([near] if long > 20 else [])
    assert isinstance(text, Text) and overprinted_labels([one, other, text]) == []


def test_a_plate_in_another_position_is_one_stroke_through_its_joints_and_numbers_break_no_link():
    stroke = joint_stroke([0j, 10 + 4j, 4 - 3j, 12 + 0j])
    assert stroke in ([0j, 4 - 3j, 12 + 0j, 10 + 4j], [10 + 4j, 12 + 0j, 4 - 3j, 0j])  # without its longest side
    link = Line((-30 + 0j, 30 + 0j), "construction", "construction", name=POSITION_NAME_PREFIX)
    named = [Label("7", 0j, 2.5, name="position 7"), Label("B", 20 + 0j, 5.0, name="B")]
    kept = [m for m in marks_with_labels(named, [link]) if isinstance(m, Line) and m.layer == "construction"]
    assert kept == [link]  # a letter finds room beside it, too


def test_a_slider_that_hardly_moves_has_the_first_and_last_number():
    plans = plans_and_requested_results(load(ROOT / "samples" / "crank-slider.yaml"))[0]
    drawn = solve(replace(load(ROOT / "samples" / "crank-slider.yaml"), find=None)).positions[0]
    here = PlacedMechanism(drawn.r, {name: f.number for name, f in drawn.of("links", "angle_deg").items()})
    numbered = [Numbered(str(k), here, k == 0) for k in range(13)]
    many = ManyPositions(plans, numbered, [here, here], drawn.scales["mu_position"])
    assert [x.text for x in many.position_labels() if " of " in x.name] == ["0–12"]


@pytest.mark.parametrize("name", ["six-link", "shaper"])
def test_a_diagram_rises_where_the_speed_is_positive(name):
    """Positions are numbered as the driver passes them: the six-link's crank turns clockwise."""
    scene = load(ALL[name])
    plans, _ = plans_and_requested_results(scene, shown=True)
    place, rate, _ = project_over_turn(scene, plans, Composer(scene, "en", plans), True).curves
    shift, speed = np.diff(np.array(place.values, float)), np.array(rate.values, float)
    speed = (speed[:-1] + speed[1:]) / 2
    clear = (abs(shift) > 0.02 * np.nanmax(abs(shift))) & (abs(speed) > 0.02 * np.nanmax(abs(speed)))
    assert clear.sum() > 50 and (np.sign(shift[clear]) == np.sign(speed[clear])).all()
