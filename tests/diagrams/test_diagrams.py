"""The whole cycle: analogues, extremes, strokes and time ratios against closed forms and the independent solver."""

from __future__ import annotations

import json
import math
import random
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
import pytest

from planes.diagrams.extremes import extremes_of_curves
from planes.diagrams.long_run import number_with_five_decimals
from planes.diagrams.motion import dead_point_positions, grid_of_driven_link
from planes.diagrams.summary import Summary, summarise_cycle, summary_of_scene
from planes.diagrams.text import summary_json, summary_report
from planes.diagrams.turn import (
    WholeTurn,
    driver_search_range,
    make_grid,
    unwind_angles,
    whole_turn_of,
    working_range_of,
)
from planes.plans import Plans, plans_of
from planes.plans.curves import UNIT_DRIVE_PREFIX, WorkingRange, curves_by_name
from planes.scene import Scene, load, loads
from planes.solving.nearest import can_be_drawn as works_at
from planes.words.errors import PlanesError
from tests.helpers import ROOT
from tests.helpers.mechanisms import KINDS, make, to_yaml
from tests.helpers.oracle import solve as solve_independently

SAMPLES = ROOT / "samples"
R, L = 0.1, 0.35

CRANK = """\
planes: 1
frame: {{points: {{O: [0, 0]}}, guides: {{x-x: {{y: {e}}}}}}}
links:
  1: {{points: {{O: 0, A: 0.1}}}}
  2: {{points: {{A: 0, B: 0.35, S2: 0.1}}, centre: S2, mass: 2, inertia: 0.03}}
  3: {{points: {{B: 0}}, slides: x-x, mass: 3}}
assembly: {{B: ahead}}
drive: {{link: 1, phi: 60, omega: {omega}, epsilon: {epsilon}}}
gravity: 9.81
"""
ROCKER = """\
planes: 1
frame: {points: {A: [0, 0], D: [0.4, 0]}}
links:
  1: {points: {A: 0, B: 0.1}}
  2: {points: {B: 0, C: 0.35, M: [0.1, 0.05]}}
  3: {points: {D: 0, C: 0.3}}
assembly: {C: left}
drive: {link: 1, phi: 60, omega: 10, epsilon: -30}
"""


def scene_of(text: str) -> Scene:
    return loads(text, "scene.yaml")


def plans_from(text: str) -> Plans:
    mechanism = scene_of(text).mechanism
    assert mechanism
    return plans_of(mechanism)


def crank(e: float = 0.0, omega: float = 20.0, epsilon: float = 0.0) -> str:
    return CRANK.format(e=e, omega=omega, epsilon=epsilon)


def summed(text: str) -> Summary:
    return summarise_cycle(scene_of(text), plans_from(text))


# analogues


def test_analogues_of_a_crank_slider_are_its_closed_forms() -> None:
    phi = np.linspace(-180, 180, 97)
    f = np.radians(phi)
    root = np.sqrt(L**2 - R**2 * np.sin(f) ** 2)
    place = R * np.cos(f) + root
    first = -R * np.sin(f) - R**2 * np.sin(f) * np.cos(f) / root
    second = -R * np.cos(f) - R**2 * np.cos(2 * f) / root - R**4 * (np.sin(f) * np.cos(f)) ** 2 / root**3
    turn = whole_turn_of(
        plans_from(crank(omega=-7.0, epsilon=11.0)), ["s_3", "vq_slide_3", "aq_slide_3", "u_21", "vq_S2_x"]
    )
    found = turn.sample_columns(phi)
    read = {c.name: c.read(found) for c in turn.curves}
    for name, exact in (("s_3", place), ("vq_slide_3", first), ("aq_slide_3", second)):
        assert read[name] == pytest.approx(exact, rel=1e-12, abs=1e-15), name
    assert read["u_21"] == pytest.approx(-R * np.cos(f) / root, rel=1e-12, abs=1e-15)
    along = R * np.cos(f) + 0.1 / L * root  # S2 lies at 0.1 of 0.35 on the rod
    step = 1e-6
    ahead = R * np.cos(f + step) + 0.1 / L * np.sqrt(L**2 - R**2 * np.sin(f + step) ** 2)
    assert read["vq_S2_x"] == pytest.approx((ahead - along) / step, abs=1e-6)


@pytest.mark.few(1)
@pytest.mark.parametrize("seed", range(8))
def test_analogues_are_what_the_independent_solver_finds_for_a_unit_drive(seed: int) -> None:
    rng = random.Random(seed)
    case = make(rng, [KINDS[seed % 5]], friction=False)
    drive = dict(case.scene["drive"])
    rates = ("omega", "epsilon") if "phi" in drive else ("velocity", "acceleration")
    unit = {**case.scene, "drive": {**drive, rates[0]: 1.0, rates[1]: 0.0}, "loads": []}
    truth = solve_independently(unit, case.guess)
    mechanism = loads(to_yaml(case.scene), "random.yaml").mechanism
    assert mechanism
    plans = plans_of(mechanism)
    turn = whole_turn_of(plans)
    found = {
        c.name: float(np.ravel(c.read(turn.sample_columns([plans.mechanism.drive.position])))[0]) for c in turn.curves
    }
    sizes: dict[str, float] = {}
    pairs: list[tuple[str, float, float]] = []
    for point, (_, v, a) in truth.points.items():
        for letter, vector in (("v", v), ("a", a)):
            if f"{letter}q_{point}_x" in found:
                pairs += [
                    (letter, found[f"{letter}q_{point}_x"], vector.real),
                    (letter, found[f"{letter}q_{point}_y"], vector.imag),
                ]
    for link, (_, omega, epsilon) in truth.links.items():
        name = next((n for n in (f"u_{link}{drive['link']}", f"omegaq_{link}") if n in found), None)
        if name:
            pairs += [("ω", found[name], omega), ("ε", found[f"epsilonq_{link}"], epsilon)]
    for sort, _, exact in pairs:
        sizes[sort] = max(sizes.get(sort, 0.0), abs(exact))
    assert len(pairs) >= 6
    for sort, mine, exact in pairs:
        assert abs(mine - exact) <= 1e-10 * sizes[sort], sort


@pytest.mark.few(2)
@pytest.mark.parametrize("name", ["six-link", "assignment-12", "kind-3-rpr", "kind-5-rpp", "sliding-driver"])
def test_velocities_and_accelerations_follow_from_the_analogues(name: str) -> None:
    """v = v_q·ω₁ and a = a_q·ω₁² + v_q·ε₁, everywhere and for everything that moves."""
    mechanism = load(str(SAMPLES / f"{name}.yaml")).mechanism
    assert mechanism
    plans, drive = plans_of(mechanism), mechanism.drive
    near = drive.position + np.linspace(-10, 10, 41) * (1.0 if drive.kind == "phi" else 0.005)
    turn = whole_turn_of(plans)
    s = turn.sample_columns(near)
    checked = 0
    size = {
        key: max((np.nanmax(np.abs(row)) for n, row in s.items() if n.startswith(key)), default=0.0)
        for key in ("v_", "a_", "omega_", "epsilon_")
    }
    for column in [n for n in s if n.startswith((f"{UNIT_DRIVE_PREFIX}v_", f"{UNIT_DRIVE_PREFIX}omega_"))]:
        own = column.removeprefix(UNIT_DRIVE_PREFIX)
        quick = own.replace("v_", "a_", 1) if own.startswith("v_") else own.replace("omega_", "epsilon_")
        if UNIT_DRIVE_PREFIX + quick not in s:
            continue  # the driver's own, which is given
        vq, aq, v, a = s[column], s[UNIT_DRIVE_PREFIX + quick], s[own], s[quick]
        told = vq * drive.velocity, aq * drive.velocity**2 + vq * drive.acceleration
        for mine, from_analogue, key in ((v, told[0], own), (a, told[1], quick)):
            beside = size[key.partition("_")[0] + "_"]
            assert mine == pytest.approx(from_analogue, rel=0, abs=1e-12 * beside), key
        checked += 1
    assert checked >= 4


# extremes, strokes, the time ratio


@pytest.mark.parametrize("e", [0.0, 0.05, -0.12])
def test_stroke_and_time_ratio_of_an_offset_crank_slider(e: float) -> None:
    found = summed(crank(e)).driven_stroke
    assert found
    far, near = math.sqrt((L + R) ** 2 - e**2), math.sqrt((L - R) ** 2 - e**2)
    assert found.swing == pytest.approx(far - near, rel=1e-13)
    lag = abs(math.degrees(math.asin(e / (L - R)) - math.asin(e / (L + R))))
    assert pytest.approx((180 + lag) / (180 - lag), rel=1e-9) == found.time_ratio
    first = math.degrees(math.asin(e / (L + R)))
    assert min(abs((x.place - first + 180) % 360 - 180) for x in found.dead) < 1e-7


def test_swing_and_time_ratio_of_a_crank_rocker() -> None:
    a, b, c, d = 0.1, 0.35, 0.3, 0.4
    at = lambda reach: math.degrees(math.acos((reach**2 + d**2 - c**2) / (2 * reach * d)))  # noqa: E731
    rocker = lambda reach: math.degrees(math.acos((c**2 + d**2 - reach**2) / (2 * c * d)))  # noqa: E731
    stretched, folded = at(a + b), at(b - a) + 180
    found = summed(ROCKER).driven_stroke
    assert found and not found.slides
    assert found.swing == pytest.approx(abs(rocker(a + b) - rocker(b - a)), rel=1e-9)
    forth = folded - stretched
    assert pytest.approx(max(forth, 360 - forth) / min(forth, 360 - forth), rel=1e-9) == found.time_ratio
    assert sorted(x.place for x in found.dead) == pytest.approx([stretched, folded], abs=1e-7)


def test_time_ratio_of_the_slotted_lever_of_assignment_12() -> None:
    """The lever is at rest where its line touches the circle of the crank: sin α = r/AC, K = (180 + 2α)/(180 − 2α)."""
    alpha = math.degrees(math.asin(0.1 / math.hypot(0.15, 0.1)))
    text = (SAMPLES / "assignment-12.yaml").read_text(encoding="utf-8")
    found = summed(text)
    assert found.driven_stroke
    assert pytest.approx((180 + 2 * alpha) / (180 - 2 * alpha), rel=1e-9) == found.driven_stroke.time_ratio
    by_name = {n: r for r in found.curve_summaries for n in r.names}
    assert by_name["phi_3"].greatest.value - by_name["phi_3"].least.value == pytest.approx(2 * alpha, rel=1e-9)
    reach = 0.1 / (math.hypot(0.15, 0.1) + 0.1), -0.1 / (math.hypot(0.15, 0.1) - 0.1)
    assert (by_name["u_31"].greatest.value, by_name["u_31"].least.value) == pytest.approx(reach, rel=1e-13)


def golden(f: Callable[[float], float], low: float, high: float) -> float:
    """The place of the least value of a function with one valley, by the golden section, in radians."""
    ratio = (math.sqrt(5) - 1) / 2
    for _ in range(60):
        a, b = high - ratio * (high - low), low + ratio * (high - low)
        low, high = (low, b) if f(a) < f(b) else (a, high)
    return (low + high) / 2


def test_the_largest_velocity_is_that_of_the_closed_form_and_not_of_a_grid() -> None:
    speed = lambda f: -R * math.sin(f) - R**2 * math.sin(f) * math.cos(f) / math.sqrt(L**2 - (R * math.sin(f)) ** 2)  # noqa: E731
    where = golden(speed, 0.0, math.pi)
    row = next(r for r in summed(crank(omega=20.0)).curve_summaries if "v_slide_3" in r.names)
    assert row.least.value == pytest.approx(20 * speed(where), rel=1e-14)
    assert row.least.place == pytest.approx(math.degrees(where), abs=1e-5)
    assert row.least.place % 0.5 > 1e-3


def test_a_coarse_grid_gives_the_same_extremes_as_a_fine_one() -> None:
    plans = plans_from(crank(0.05, 20.0, 40.0))
    names = ["s_3", "v_slide_3", "a_slide_3", "F_21", "F_30", "M_1"]
    some = [extremes_of_curves(make_grid(whole_turn_of(plans, names), 0.0, 360.0, count)) for count in (181, 1441)]
    for name, coarse, fine in zip(names, *some, strict=True):
        assert len(coarse) == len(fine) >= 2, name
        for one, two in zip(coarse, fine, strict=True):
            size = max(abs(e.value) for e in fine)
            assert one.value == pytest.approx(two.value, rel=1e-11, abs=1e-10 * size), name
            assert one.place == pytest.approx(two.place, abs=1e-4), name


@pytest.mark.slow
def test_limits_of_assembly_are_found_and_what_grows_there_is_said() -> None:
    text = ROCKER.replace("B: 0.1}", "B: 0.5}")
    found = summed(text)
    reach = (0.5**2 + 0.4**2 - 0.65**2) / (2 * 0.5 * 0.4)  # links 2 and 3 in one line
    end = math.degrees(math.acos(reach))
    assert [x for r in found.grid.assembly_ranges for x in r] == pytest.approx([-end, end], abs=1e-9)
    row = next(r for r in found.curve_summaries if "u_31" in r.names)
    assert math.isinf(row.greatest.value) and math.isinf(row.least.value)
    swing = next(r for r in found.curve_summaries if "phi_3" in r.names)
    assert (swing.least.at, swing.greatest.at) != ("end", "end") and swing.greatest.value - swing.least.value < 360
    plain = summary_json(found)
    assert any(e.get("unbounded") for e in plain["curves"]["u_31"]["extremes"])
    json.dumps(plain, allow_nan=False)


@pytest.mark.few(1, slow=1)
@pytest.mark.parametrize("seed", range(10))
def test_a_driver_can_go_as_far_as_every_step_can_be_drawn(seed: int) -> None:
    rng = random.Random(seed)
    plans = plans_from(to_yaml(make(rng, [KINDS[seed % 5]], friction=False).scene))
    works = partial(works_at, plans)
    span, (low, high), drive = working_range_of(plans), driver_search_range(plans), plans.mechanism.drive
    assert span.start <= drive.position <= span.end
    assert all(map(works, WorkingRange(span.start, span.end).range_without_ends(0.01).evenly_spaced_values(20)))
    assert span.whole or drive.kind == "s" or span.end - span.start < 360
    beside = 1e-5 * (high - low)
    for end, way, far in ((span.start, -1, low), (span.end, 1, high)):
        assert span.whole or (drive.kind == "s" and abs(end - far) < beside) or not works(end + way * beside)


@pytest.mark.slow
def test_nothing_is_told_of_where_the_mechanism_does_not_assemble() -> None:
    found = summed((SAMPLES / "assignments" / "66.yaml").read_text(encoding="utf-8"))
    ((low, high),) = found.grid.assembly_ranges
    row = next(r for r in found.curve_summaries if "phi_5" in r.names)
    assert row.greatest.value - row.least.value == pytest.approx(high - low, abs=1e-6)
    path = next(p for p in found.paths_of_points if p.point == "A")
    assert path.y == pytest.approx((0.5 * math.sin(math.radians(low)), 0.5), abs=1e-6)


@pytest.mark.slow
def test_what_grows_where_a_sliding_driver_stops_is_said(capsys: Any) -> None:
    from planes.cli import main

    assert main(["cycle", str(SAMPLES / "sliding-driver.yaml"), "--lang", "en"]) == 0
    out = capsys.readouterr().out
    assert "Assembles for s1 = -0.137878 m…0.85 m" in out and "→ ∞  -0.137878 m" in out and "·10" not in out


@pytest.mark.slow
def test_dead_points_are_those_of_places_and_need_no_motion() -> None:
    moving, resting = (
        dead_point_positions(grid_of_driven_link(plans_from(crank(0.05, w)), 0.0, 360.0)) for w in (20.0, 0.0)
    )
    assert moving == resting and len(moving) == 2
    assert moving[0] == pytest.approx(math.degrees(math.asin(0.05 / (L + R))), abs=1e-9)
    turning_over = plans_from((SAMPLES / "assignments" / "57.yaml").read_text(encoding="utf-8"))
    assert dead_point_positions(grid_of_driven_link(turning_over, 30.0, 390.0)) == pytest.approx(
        [360.0, 370.1618], abs=1e-4
    )


def test_a_double_crank_has_no_extreme_position() -> None:
    text = ROCKER.replace("D: [0.4, 0]", "D: [0.1, 0]").replace("B: 0.1}", "B: 0.3}").replace("C: 0.35", "C: 0.32")
    found = summed(text).driven_stroke
    assert found and found.rounds and found.time_ratio is None and not found.dead
    assert "полный оборот" in summary_report(summed(text), "ru")


@pytest.mark.slow
def test_a_rod_that_passes_through_its_pin_turns_over_and_has_no_time_ratio() -> None:
    text = (SAMPLES / "assignments" / "57.yaml").read_text(encoding="utf-8")
    found = summed(text)
    assert {name for name, _ in found.grid.link_turn_overs} == {"phi_4", "phi_5"}
    assert {round(place, 4) for _, place in found.grid.link_turn_overs} == {352.5772}
    assert found.driven_stroke is None
    assert "звенья 4, 5 перебрасываются" in summary_report(found, "ru")
    assert summed(crank()).grid.link_turn_overs == ()


def test_a_load_against_motion_jumps_and_the_jump_is_no_extreme() -> None:
    """At the very dead point the load is nothing; the least force is what the curve comes down to beside it."""
    text = crank(0.0, 1e-3) + "loads: [{link: 3, point: B, force: 500, against: motion}]\n"
    text = text.replace("mass: 2, inertia: 0.03", "mass: 0").replace("mass: 3", "mass: 0")
    row = next(r for r in summed(text).curve_summaries if "F_21" in r.names)
    assert row.least.value == pytest.approx(500.0, rel=1e-9)


def test_path_lengths() -> None:
    found = {p.point: p for p in summed(crank()).paths_of_points}
    assert found["A"].length == pytest.approx(2 * math.pi * R, rel=1e-9)
    assert found["B"].length == pytest.approx(4 * R, rel=1e-9)
    assert found["A"].x == pytest.approx((-R, R), rel=1e-12)


def test_angles_go_on_past_a_full_turn() -> None:
    raw = np.array([170.0, -170.0, -150.0, np.nan, -130.0])
    assert unwind_angles(raw)[[0, 1, 2, 4]] == pytest.approx([-190, -170, -150, -130])


def test_a_name_that_is_not_there() -> None:
    with pytest.raises(PlanesError, match=r"scene\.yaml: this mechanism has no quantity vq_Z.*vq_"):
        whole_turn_of(plans_from(crank()), ["vq_Z"], file="scene.yaml")
    with pytest.raises(PlanesError, match="no quantity F_99"):
        whole_turn_of(plans_from(crank()), ["s_3"], ["F_99"])


def test_only_the_runs_that_are_needed_are_made() -> None:
    plans = plans_from(crank())
    assert [prefix for prefix, _ in whole_turn_of(plans, ["u_21"]).cycles_by_prefix] == [UNIT_DRIVE_PREFIX]
    assert [prefix for prefix, _ in WholeTurn(plans, [curves_by_name(plans)["M_1"]]).cycles_by_prefix] == [""]
    assert [prefix for prefix, _ in whole_turn_of(plans, ["v_B"], slopes=False).cycles_by_prefix] == [""]


# the listing of assignment 12


LISTED = {  # names of the printed listing -> those of the program
    "xB": "r_B_x",
    "yB": "r_B_y",
    "phi3_deg": "phi_3",
    "xD": "r_D_x",
    "yD": "r_D_y",
    "xS3": "r_S3_x",
    "yS3": "r_S3_y",
    "wq3": "u_31",
    "eq3": "epsilonq_3",
    "w3": "omega_3",
    "e3": "epsilon_3",
    "vD": "v_D",
    "vS3": "v_S3",
    "aD": "a_D",
    "aS3": "a_S3",
    **{
        f"{letter}{q}{p}{axis}": f"{letter}{q}_{p}_{axis}"
        for letter in "va"
        for q in ("q", "")
        for p in ("D", "S3")
        for axis in "xy"
    },
}


@pytest.mark.parametrize("file", ["assignment-12", "assignments/12"])
def test_every_digit_of_the_printed_listing(file: str, capsys: Any) -> None:
    from planes.cli import main

    scene = str(SAMPLES / f"{file}.yaml")
    assert main(["cycle", scene, "--phi", "245", "--omega", "12", "--epsilon", "7", "--lang", "en"]) == 0
    rows = [line.split() for line in capsys.readouterr().out.splitlines() if line.startswith("  ")]
    told = {row[0]: row[-1] for row in rows if len(row) == 3}
    printed = json.loads((SAMPLES / "expected" / "assignment-12.json").read_text(encoding="utf-8"))["quantities"]
    assert len(printed) == 31 and {q["quantity"] for q in printed} == set(LISTED)
    for q in printed:
        assert (
            told[LISTED[q["quantity"]]]
            == number_with_five_decimals(q["published"])
            == f"{q['published']:.5f}".rstrip("0")
        ), q


def test_the_balancing_moment_does_the_work_of_the_load_over_a_cycle() -> None:
    """Inertia and weight give all back over a uniform turn; a resistance F over the stroke and back takes 2·F·s."""
    phi = np.arange(0.0, 360.0, 0.5) + 0.25  # between the dead points
    step, loss = math.radians(0.5), 500 * 4 * R
    resisted = crank() + "loads: [{link: 3, point: B, force: 500, against: motion}]\n"
    for text, work, near in ((crank(), 0.0, 1e-10), (resisted, loss, 1e-4 * loss)):
        turn = whole_turn_of(plans_from(text), ["M_1"])
        moment = turn.curves[0].read(turn.sample_columns(phi))
        assert float(moment.sum()) * step == pytest.approx(work, abs=near)


def test_extremes_of_smooth_curves_are_where_they_are() -> None:
    """A slider's acceleration has its extremes at the dead points, of which no derivative is in the program; so has a
    size that vanishes, which is a corner there."""
    found = summary_of_scene(load(str(ROOT / "samples" / "crank-slider.yaml"))).extremes_by_curve
    at = [e.place for e in found["a_B_x"] if min(abs(e.place), abs(e.place - 180.0)) < 1.0]
    assert at == pytest.approx([0.0, 180.0], abs=1e-9)
    zeros = [e for e in found["a_B"] if e.value < 1e-3]
    assert len(zeros) == 2 and max(e.value for e in zeros) < 1e-9


def test_a_corner_is_an_extreme_where_it_is() -> None:
    """The moment has a corner at 180° where two loads turn about: it falls to it and rises from it."""
    (corner,) = [
        e
        for e in summary_of_scene(load(str(ROOT / "samples/assignments/09.yaml"))).extremes_by_curve["M_1"]
        if abs(e.place - 180) < 1
    ]
    assert corner.sense == -1 and corner.place == pytest.approx(180.0, abs=1e-6)
    assert corner.value == pytest.approx(2619.936666666, rel=1e-9)
