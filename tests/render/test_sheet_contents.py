"""What project sheets hold: given values, links apart, extreme positions, a sliding driver's stroke, room well used."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from planes import solving
from planes.cli import main
from planes.diagrams.turn import working_range_of
from planes.documents import sheets as drawing_sheets
from planes.documents.sheets import project_over_turn, sheet_of
from planes.plans.curves import driven_link_and_sliding
from planes.scene import load, loads
from planes.solving import plans_and_requested_results, solve
from planes.solving.given import GivenTable
from planes.words.names import PlanId
from planes.words.naming import Naming
from render.labels import Label, place_labels
from render.paper.marks import Arrow, Line, Text
from render.paper.style import using_large_format
from render.paper.typeset import plain_text
from render.sheet.composer import Composer
from render.sheet.module import Module
from render.sheet.sizes import MU_STEP_RATIOS, Sizes, grow_plan_sizes
from render.views.curve_pieces import drop_steep_ordinates
from render.views.diagrams import DiagramCurve, Diagrams
from tests.helpers import ROOT, sheets

SAMPLES = ROOT / "samples"
SLIDING, RPR, RRP = (load(SAMPLES / f"{name}.yaml") for name in ("sliding-driver", "kind-3-rpr", "kind-2-rrp"))

KEPT_ANGLE = """\
planes: 1
frame: {points: {O: [0, 0], D: [0.3, 0], E: [0.1, -0.2]}}
links:
  1: {points: {O: 0, A: 0.1}, guides: {g1: {angle: 90, through: A}}}
  2: {points: {A: 0, B: 0.3}}
  3: {points: {D: 0, B: 0.2}}
  4: {points: {F: 0}, slides: g1, guides: {g4: {angle: 90, through: F}}}
  5: {points: {E: 0}, slides: g4}
assembly: {B: left}
drive: {link: 1, phi: 40, omega: 10}
"""


def sheet(name, number):
    return sheets.sheet(name, number=number, positions=12.0)


def words(sheet):
    return {plain_text(m.text) for m in sheet.marks if isinstance(m, Text)}


def given(scene, value=None):
    position = solve(replace(scene, find=None), None if value is None else [value]).positions[0]
    return {
        name: (number, unit) for name, number, unit in GivenTable(position, Naming(), scene.parameters).given_rows()
    }


def test_given_values_are_those_of_the_scene_each_once():
    found = given(load(SAMPLES / "assignments" / "05.yaml"))
    assert list(found)[:3] == ["φ_{1}", "ω_{1}", "ε_{1}"]
    assert (
        found["φ_{1}"] == ("60", "°")
        and found["J_{S2}"] == ("1,8", "кг·м²")
        and found["y_{E} = y_{E–E}"] == ("0,8", "м")
    )
    assert found["F_{3} = P_{3}"] == ("6000", "Н")
    assert not {"J_{1}", "m_{1} = m_{1}", "P_{3}", "x_{C–C}", "y_{E–E}"} & set(found)


def test_units_that_others_are_written_in_are_not_listed():
    text = (SAMPLES / "assignments" / "05.yaml").read_text("utf-8")
    named = text.replace("l_AB: 0.15", "mm: 0.001, rpm: pi/30, cm: 2, l_AB: 150*mm*rpm/rpm*cm/cm", 1)
    before, after = (given(loads(one, "s.yaml")) for one in (text, named))
    assert after == before | {"cm": ("2", "—")}


def test_numbers_without_a_name_are_listed_too_and_the_drive_is_where_it_stands():
    found = given(RPR, 45.0)
    assert found["φ_{1}"][0] == "45" and found["l_{AC}"][0] == "0,28" and found["l_{CS3}"][0] == "0,25"
    assert found["m_{3}"] == ("12", "кг") and found["P_{3}"] == ("900", "Н") and found["g"][0] == "9,81"
    assert found["y_{C}"] == ("−0,28", "м") and found["x_{A} = y_{A}"][0] == "0"  # whatever equals them


def test_a_place_is_told_by_what_is_shorter():
    assert given(RPR)["x_{BS2}"][0] == "0,02" and "∠BS2" not in given(RPR)
    hanging = given(load(SAMPLES / "assignments" / "44.yaml"))
    assert (hanging["l_{KS5}"][0], hanging["∠KS5"][0]) == ("0,15", "30")


@pytest.mark.slow
def test_the_note_of_a_scene_stands_in_some_shape_or_is_told():
    first, second = (sheet("six-link", number) for number in (1, 2))
    (note,) = (v for v, _, _ in second.views if v.key.startswith("note"))
    lines = [m.text for m in note.marks if isinstance(m, Text)]
    assert "полного оборота он не делает" in " ".join(lines)
    assert first.paper.name == "A2" and not any("Примечание" in said for said in first.warnings)
    assert {"self-aligning", "note"} <= {v.key.partition(" ")[0] for v, _, _ in first.views}
    six = load(SAMPLES / "six-link.yaml")  # a format that is asked for, and too much for it
    told = sheet_of(replace(six, sheet={"format": "A2"}, note={"ru": 60 * six.note["ru"]}), None, "ru", 1)
    assert not any(v.key.startswith("note") for v, _, _ in told.views) and "Примечание" in str(told.warnings)


def test_diagrams_tell_their_extremes_and_one_table_what_is_measured_on_both_plans():
    scene = load(SAMPLES / "kind-2-rrp.yaml")
    position = solve(scene).positions[0]
    composer = Composer(scene, "ru", position.plans)
    drawn = project_over_turn(scene, position.plans, composer, False).diagrams_view(position)
    found = [v for v in (drawn, *composer.make_tables(position, 3.5).rate_tables(True)) if v]
    views = {v.key: [m for m in v.marks if isinstance(m, Text)] for v in found}
    stroke = (0.26**2 - 0.015**2) ** 0.5 - (0.14**2 - 0.015**2) ** 0.5  # of an offset slider-crank
    assert f"{stroke:.3f} м".replace(".", ",") in {m.text for m in views["diagrams"]}
    rows = {m.text: round(m.place.imag, 3) for m in views["rates-table"]}
    assert rows["v_{CB}"] == rows["a_{CB}^{n}"] > rows["a_{CB}^{t}"] and rows["v_{C}"] == rows["a_{C}"]


def test_letters_of_large_formats_are_larger_where_there_is_room():
    fence = [Line((complex(-40, y), complex(40, y)), "thin", "scheme") for y in (-3.3, 3.3)]
    for marks, field, height in (((), None, 7.0), (fence, (-40.0, -3.3, 40.0, 3.3), 5.0)):
        with using_large_format(True):
            (text,) = place_labels([Label("B", 0j, 5.0)], marks, field).texts
        assert text.height == height


@pytest.mark.slow
@pytest.mark.parametrize("name", ["kind-3-rpr", "assignments/12"])
def test_inner_reactions_are_drawn_on_links_apart(name):
    found = sheet(name, 2)
    shown = [v for v, _, _ in found.views if v.key == "apart"]
    plans = plans_and_requested_results(load(SAMPLES / f"{name}.yaml"))[0]
    assert len(shown) == len(plans.structure.groups)
    for group, view in zip(reversed(plans.structure.groups), shown, strict=True):
        arrows = {m.name for m in view.marks if isinstance(m, Arrow)}
        one, other = group.links
        assert {f"F_{one}{other}", f"F_{other}{one}"} <= arrows


def test_both_extreme_positions_are_marked():
    project = project_over_turn(RRP, plans_and_requested_results(RRP)[0], Composer(RRP, "ru"), True)
    extremes = [n.number for n in project.numbered if n.extreme]
    assert extremes[0] == "0" and len(extremes) == 2
    _, slides = driven_link_and_sliding(plans_and_requested_results(RRP)[0])
    assert slides
    path = [r.points["C"] for r in project.turn if r]
    ends = [n.result.points["C"] for n in project.numbered if n.extreme and n.result]
    for end in ends:  # nowhere does it go farther that way
        assert max(abs(z - ends[0]) for z in path) <= abs(ends[1] - ends[0]) * (1 + 1e-9), end


@pytest.mark.slow
def test_a_sliding_driver_has_its_stroke():
    span = working_range_of(plans_and_requested_results(SLIDING)[0])
    assert span.start < 0.15 < span.end and not span.whole
    found = sheet("sliding-driver", 1)
    said = words(found)
    assert {str(k) for k in range(13)} <= said
    assert any(text.startswith("Диаграммы") for text in said) and "s1" in said
    assert any(text.startswith("s0 = ") and "мм/м" in text for text in said)
    scheme = next(v for v, _, _ in found.views if v.key == "scheme")
    assert sum(isinstance(m, Line) and m.layer == "construction" and m.style == "thin" for m in scheme.marks) >= 4


@pytest.mark.slow
def test_the_range_of_a_rocking_driver_ends_where_it_stops():
    span = working_range_of(plans_and_requested_results(load(SAMPLES / "six-link.yaml"))[0])
    assert (span.start, span.end) == pytest.approx((129.5, 305.8), abs=0.1)


def test_ends_of_a_range_are_cut_off_and_peaks_within_are_kept():
    assert drop_steep_ordinates((90.0, 1.0, 2.0, 8.0, 2.0, 1.0, None, 50.0), False) == (
        None,
        1.0,
        2.0,
        8.0,
        2.0,
        1.0,
        None,
        None,
    )


def test_a_turn_through_a_dead_point_loses_only_what_grows_without_bound():
    turn = [math.tan(math.radians(a)) for a in range(720)]
    kept = drop_steep_ordinates(turn, True)
    assert kept[0] == turn[0] and kept[719] == turn[719] and kept[90] is None and kept[270] is None
    assert all(v is None or abs(v) < 100 for v in kept) and kept.count(None) < 20
    calm = [math.cos(math.radians(a)) + 6 * (a == 40) for a in range(360)]
    assert None not in drop_steep_ordinates(calm, True)


def test_a_link_that_turns_fully_has_no_greatest_angle():
    """Its angle ends a whole turn from where it begins; the angle of a rocker is least and greatest within the turn."""
    rows = ([float(a) for a in range(361)], [math.cos(math.radians(a)) for a in range(361)])
    turning, rocking = (DiagramCurve("φ", "°", tuple(row)) for row in rows)
    plans = plans_and_requested_results(RRP)[0]
    drawn = Diagrams(plans, range(361), [[turning]], Naming("en"))
    assert not drawn.extreme_places(turning)
    assert [place for _, (place, _) in drawn.extreme_places(rocking)] == [180, 360]


def test_a_driven_link_turns_by_itself():
    """Both links of the last group keep the driver's angle: the diagrams are of the group before."""
    scene = loads(KEPT_ANGLE)
    assert solve(scene).positions[0].plans.structure.groups[-1].links == ("4", "5")
    assert driven_link_and_sliding(plans_and_requested_results(scene)[0]) == ("3", False)


@pytest.mark.slow
def test_moment_equations_are_never_left_out_silently(tmp_path, capsys):
    scene = replace(RPR, sheet={"format": "A3"})
    found = sheet_of(scene, None)
    assert "Уравнения моментов" not in words(found)
    said, *others = found.warnings  # and that its plans are smaller
    assert "A3" in said and "Уравнения моментов" in said and "A2" in said
    assert "Уравнения моментов" in words(sheet_of(RPR, None))
    path = tmp_path / "scene.yaml"
    text = (SAMPLES / "kind-3-rpr.yaml").read_text(encoding="utf-8")
    path.write_text(text + "sheet: {format: A3}\n", encoding="utf-8")
    assert main(["sheet", str(path), "--lang", "ru", "-o", str(tmp_path / "sheet.svg")]) == 0
    warned = "".join(f"предупреждение: {line}\n" for line in (said, *others))
    assert capsys.readouterr().err.startswith(f"{warned}записан ")


def test_the_smallest_plan_grows_first_and_none_beyond_the_limit():
    steps = []

    def extents(sizes):
        return {"velocity": 40.0 * sizes.factor_of_plan("velocity"), "force:1": 60.0 * sizes.factor_of_plan("force:1")}

    def fits(sizes):
        steps.append(dict(sizes.more))
        return True

    found = grow_plan_sizes(Sizes(), extents, 100.0, fits)
    assert steps[0] == {"velocity": MU_STEP_RATIOS[0]}
    assert 80 < extents(found)["velocity"] <= 100 and 80 < extents(found)["force:1"] <= 100
    assert grow_plan_sizes(Sizes(), extents, 100.0, lambda _: False) == Sizes()


def test_a_sheet_draws_its_position_once_at_each_scale(monkeypatch):
    drawn = []

    def counted(*given):
        drawn.append(solving.solve_position(*given))
        return drawn[-1]

    monkeypatch.setattr(drawing_sheets, "solve_position", counted)
    sheet_of(load(SAMPLES / "six-link.yaml"), None, "ru", 2)
    scales = [tuple(p.scales.items()) for p in drawn]
    assert len(scales) == len(set(scales)) < 15


@pytest.mark.few(1)
@pytest.mark.parametrize(("name", "number"), [("kind-3-rpr", 1), ("kind-3-rpr", 2), ("assignments/12", 1)])
def test_the_field_is_well_filled(name, number):
    from tests.sheets_run import empty, full

    found = sheet(name, number)
    assert full(found) > 0.45  # plans keep the scales of the scene
    assert empty(found) < 0.15


@pytest.mark.few(2)
@pytest.mark.parametrize("name", ["six-link", "kind-3-rpr", "assignments/12", "assignments/30", "assignments/65"])
def test_figures_follow_the_calculation_on_the_module(name):
    found = sheet(name, 2)
    module = Module(found.paper.field, found.paper.occupied_areas)
    units = [(left - module.left(0)) / module.unit_pitch for _, left, _ in found.views]
    assert all(abs(unit - round(unit)) < 1e-6 for unit in units)
    figures = [v for v, _, _ in found.views if v.figure]
    assert figures[0].key == "loaded" and figures[-1].key == "lever"
    steps = [v.step for v in figures[1:-1]]
    assert steps == sorted(steps, key=steps.index)  # each step whole before the next
    for step in dict.fromkeys(steps):
        first, *links = [v.key for v in figures if v.step == step][1:]
        alone = {PlanId("force", link) for link in step.links}
        assert first == step and links[:1] in ([], ["apart"]) and set(links[1:]) <= alone


def test_force_plans_and_groups_apart_have_one_scale():
    said = words(sheet("kind-3-rpr", 2))
    assert len({text.partition("μF = ")[2] for text in said if "μF = " in text}) == 1
    groups = {text.partition("μl = ")[2] for text in said if "с силами" in text or "порознь" in text}
    assert len(groups) == 1


def test_round_scales_only():
    text = (SAMPLES / "assignments" / "61.yaml").read_text(encoding="utf-8")
    for size in (Sizes(), Sizes(1.25), Sizes(1.6)):
        from planes.documents.sheets import DrawnPosition

        mu = DrawnPosition(loads(text), None, "ru").position_at_sizes(size).scales["mu_position"]
        assert f"{mu:.3g}" == f"{mu:g}"


@pytest.mark.parametrize("asked", [["F_21", "M_1"], ["F_30"], ["M_1"]])
def test_a_sheet_of_what_is_asked_draws_a_reaction_that_leans_by_friction(asked: list[str]) -> None:
    scene = load(ROOT / "samples" / "kind-2-rrp.yaml")
    assert scene.mechanism and scene.mechanism.friction
    drawn = sheet_of(replace(scene, find=asked), None, "ru")
    assert any(isinstance(m, Text) and plain_text(m.text).startswith("F30") for m in drawn.marks)
