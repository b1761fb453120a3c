"""The classic mechanisms of the gallery: each works and moves, and has the property it is known for.

Places are those of the engine; what they are held against is a closed form, a published number, or the rule of Grashof.
"""

import cmath
import math
import shutil
from collections.abc import Iterable, Mapping, Sequence
from itertools import pairwise
from pathlib import Path

import pytest

from planes import solve
from planes.cli import main
from planes.scene import Scene, load
from planes.solving import plans_and_requested_results
from planes.studio import gallery
from planes.studio.gallery import OWN_SCENE_FOLDERS, motion_of_points, point_places_at
from planes.words import available_languages

CLASSICS = sorted(OWN_SCENE_FOLDERS[0].glob("*.yaml"))
BOUNDED = (  # their drivers do not go round
    *("antiparallelogram-doors", "bicycle-suspension", "chebyshev-line", "dump-truck", "elliptic-trammel"),
    *("evans-grasshopper", "excavator-bucket", "garage-door", "hart-inversor", "landing-gear", "parallelogram-lift"),
    *("peaucellier-lipkin", "portal-crane", "roberts-line", "scissor-lift", "scott-russell", "tilting-window"),
    *("umbrella", "watt-line", "ackermann-steering", "hand-pump", "bonnet-hinge"),
)
PASSIVE = ("elliptic-trammel", "parallelogram-lift")


def scene(name: str) -> Scene:
    return load(OWN_SCENE_FOLDERS[0] / f"{name}.yaml")


def size(name: str, *names: str) -> list[float]:
    """Parameters of a scene, m."""
    found = scene(name).parameters
    return [found[n] for n in names]


def places(name: str, point: str, values: Iterable[float]) -> list[complex]:
    """Where a point is at places of the driver, all of which can be drawn."""
    plans, _ = plans_and_requested_results(scene(name), shown=True)
    asked = [float(x) for x in values]
    found, works = point_places_at(plans, asked)
    assert len(works) == len(asked)
    path = found[point]
    assert isinstance(path, list)
    return path


def spread(values: Sequence[float]) -> float:
    return max(values) - min(values)


def test_there_are_as_many_as_a_gallery_needs() -> None:
    assert len(CLASSICS) >= 52 and {*BOUNDED} < {p.stem for p in CLASSICS}


@pytest.mark.few(24)
@pytest.mark.parametrize("path", CLASSICS, ids=lambda p: p.stem)
def test_a_classic_solves_has_its_titles_and_moves(path: Path) -> None:
    found = load(path)
    assert {*found.title} == {*available_languages("studio")} == {"en", "ru", "uk", "be"} and all(found.title.values())
    here = solve(found)
    assert here.results["reactions"] and found.mechanism is not None
    warned = [w for w in here.results.get("warnings") or [] if "drawing is inaccurate" not in w]
    assert len(warned) == (2 if path.stem in PASSIVE else 0)
    own = motion_of_points(found)
    counts = {len(z) for z in own["motion"].values()}
    assert len(counts) == 1 and counts.pop() >= 8
    assert own["round"] == (path.stem not in BOUNDED)
    moving = [p for x in found.mechanism.links.values() for p in x.points if p not in found.mechanism.frame.points]
    assert {*moving} <= {*own["motion"]}
    if not own["round"]:
        near_and_without_leaps(own["motion"], here.r)


def near_and_without_leaps(motion: dict[str, list[list[float]]], here: Mapping[str, complex]) -> None:
    """A picture that does not go round has its own position in it, and goes from place to place in small steps."""
    seen = [complex(*z) for places in motion.values() for z in places]
    whole = max(abs(z - seen[0]) for z in seen)
    off = [max(abs(complex(*z[k]) - here[p]) for p, z in motion.items()) for k in range(len(motion["A"]))]
    assert min(off) < whole / 8
    assert max(math.dist(a, b) for z in motion.values() for a, b in pairwise(z)) < whole / 2


def test_the_gallery_shows_every_classic_in_its_own_shape(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    shutil.copy(OWN_SCENE_FOLDERS[0] / "stephenson-gear.yaml", tmp_path)
    monkeypatch.setattr(gallery, "OWN_SCENE_FOLDERS", ())
    (shown,) = gallery.gallery_entries([str(tmp_path)])
    assert shown["name"] == "stephenson-gear" and "III(2;3;4;5)" in shown["formula"]


# --- straight lines


def test_watt_goes_straight_for_two_thirds_of_an_arm() -> None:
    """The published linkage, arms 5 : coupler 4: M within 1/1000 of an arm from x = 5 for 6 units of height."""
    arm, coupler = size("watt-line", "l_AB", "l_BC")
    path = places("watt-line", "M", [k * 0.5 for k in range(-38, 39)])
    straight = [z for z in path if abs(z.imag + coupler / 2) <= 0.3 * arm]
    assert spread([z.imag for z in straight]) > 0.57 * arm
    assert max(abs(z.real - arm) for z in straight) < 1e-3 * arm


def test_chebyshev_goes_straight_from_bearing_to_bearing() -> None:
    """It is exact above both bearings and between them, and 0.0104 of half the frame too high at most elsewhere."""
    (frame,) = size("chebyshev-line", "l_AD")
    angles = [math.degrees(math.atan2(4, 3)), 90.0, 36.8699, 45, 55, 65, 75, 85]
    path = places("chebyshev-line", "M", [angles[0], angles[1], *angles[3:]])
    assert path[0] == pytest.approx(frame / 2 + 1j * frame, abs=1e-12) and path[1] == pytest.approx(1j * frame)
    over = [4 * z.imag / frame - 4 for z in places("chebyshev-line", "M", [k * 0.5 for k in range(78, 181)])]
    assert min(over) > -1e-9 and 0.009 < max(over) < 0.0105


def test_hoeken_goes_straight_and_evenly_for_half_a_turn() -> None:
    """Four cranks long, exact at three places, 0.0104 of a crank too high at most; the speed differs by a quarter."""
    (crank,) = size("hoeken-line", "l_AB")
    path = [z / crank for z in places("hoeken-line", "E", range(90, 271, 2))]
    assert spread([z.real for z in path]) == pytest.approx(4.0)
    assert min(z.imag for z in path) == pytest.approx(4.0) and 4.009 < max(z.imag for z in path) < 4.0105
    steps = [abs(b - a) for a, b in pairwise(path[20:71])]
    assert max(steps) < 1.25 * min(steps)


def test_roberts_goes_along_the_line_of_its_bearings() -> None:
    """P is exactly in A's and D's line at the middle and above a bearing, and 1/140 of AD beside it at most."""
    (frame,) = size("roberts-line", "l_AD")
    arm, coupler = size("roberts-line", "l_AB", "l_BC")
    middle = math.degrees(math.acos((frame - coupler) / 2 / arm))
    assert places("roberts-line", "P", [middle]) == [pytest.approx(frame / 2, abs=1e-12)]
    path = places("roberts-line", "P", [middle + k * 0.5 for k in range(-60, 34)])
    between = [z for z in path if 0.18 * frame < z.real < frame]
    assert spread([z.real for z in between]) > 0.75 * frame
    assert max(abs(z.imag) for z in between) < frame / 140


def test_peaucellier_goes_exactly_straight() -> None:
    """AC·AF = AD² - CD², so F is at x = (AD² - CD²)/(2·AB)."""
    bar, side, radius = size("peaucellier-lipkin", "l_AD", "l_CD", "l_AB")
    for z in places("peaucellier-lipkin", "F", range(-60, 61, 10)):
        assert z.real == pytest.approx((bar**2 - side**2) / (2 * radius), abs=1e-11)


def test_hart_goes_exactly_straight() -> None:
    """AP·AF = (BC² - CD²)/4 to the other side of A, so F is at x = -(BC² - CD²)/(8·AG)."""
    bar, side, radius = size("hart-inversor", "l_BC", "l_CD", "l_AG")
    for z in places("hart-inversor", "F", range(-110, 111, 20)):
        assert z.real == pytest.approx(-(bar**2 - side**2) / (8 * radius), abs=1e-11)


def test_scott_russell_goes_exactly_straight_and_evans_nearly() -> None:
    (crank,) = size("scott-russell", "l_AB")
    for s, z in zip((0.1, 0.2, 0.3), places("scott-russell", "P", [0.1, 0.2, 0.3]), strict=True):
        assert z == pytest.approx(1j * math.sqrt(4 * crank**2 - s**2), abs=1e-12)
    path = places("evans-grasshopper", "P", range(-18, 19))
    assert spread([z.imag for z in path]) > 1.1 and max(abs(z.real) for z in path) < 5e-4


def test_the_piston_rod_of_the_beam_engine_goes_straight() -> None:
    path = places("walking-beam", "P", range(3, 360, 7))
    assert spread([z.imag for z in path]) > 0.79 and spread([z.real for z in path]) < 5e-4


def test_the_crane_carries_its_load_level() -> None:
    path = [z for z in places("portal-crane", "E", range(46, 83)) if 2 < z.real < 11]
    assert spread([z.real for z in path]) > 8.5 and spread([z.imag for z in path]) < 0.05


@pytest.mark.parametrize("name, foot, low", [("jansen-leg", "H", 0.45), ("klann-leg", "G", 0.4)])
def test_a_foot_treads_level_for_nearly_half_a_turn(name: str, foot: str, low: float) -> None:
    path = places(name, foot, range(0, 360, 5))
    ground = min(z.imag for z in path)
    tread = [z for z in path if z.imag < ground + 0.03 * spread([z.real for z in path])]
    assert len(tread) >= low * len(path) and spread([z.real for z in tread]) > 0.8 * spread([z.real for z in path])


# --- curves and ratios


def test_the_trammel_draws_an_ellipse() -> None:
    near, far = size("elliptic-trammel", "l_BE", "l_BD")
    for z in places("elliptic-trammel", "E", [-0.15, -0.05, 0.03, 0.11, 0.19]):
        assert (z.real / (far + near)) ** 2 + (z.imag / near) ** 2 == pytest.approx(1.0, abs=1e-11)


def test_the_pantograph_doubles() -> None:
    tracer, pencil = (places("pantograph", x, range(0, 360, 45)) for x in ("P", "F"))
    for p, f in zip(tracer, pencil, strict=True):
        assert f == pytest.approx(2 * p, abs=1e-11)


def test_shafts_of_an_oldham_coupling_turn_at_one_speed() -> None:
    (apart,) = size("oldham-coupling", "l_AB")
    found = solve(scene("oldham-coupling"), phi=range(5, 360, 50))
    for p in found.positions:
        assert p.omega["3"] == pytest.approx(20.0) and abs(p.r["C"] - apart / 2) == pytest.approx(apart / 2)


def test_the_scissors_stay_level_and_close_as_they_should() -> None:
    (arm,) = size("scissor-lift", "l")
    for s, h, g in zip((0.4, 0.7, 1.0), *(places("scissor-lift", x, [0.4, 0.7, 1.0]) for x in "HG"), strict=True):
        assert h == pytest.approx(2j * math.sqrt(arm**2 - s**2)) and g == pytest.approx(h + s)


def test_leaves_of_a_bus_door_close_together() -> None:
    left, right = (motion_of_points(scene("antiparallelogram-doors"))["motion"][x] for x in ("E", "F"))
    shut = min(range(len(left)), key=lambda k: abs(left[k][1]))
    assert abs(right[shut][1]) < 0.03 and 0.03 < right[shut][0] - left[shut][0] < 0.1


def test_the_lever_with_a_dwell_stands_for_half_a_turn() -> None:
    tips = places("dwell-six-bar", "G", range(0, 360, 5))
    turned = [math.degrees(cmath.phase(-(z - 0.56 - 0.4j))) for z in tips]
    half = turned[18:55]
    assert spread(half) < 0.8 and spread(turned) > 10


# --- Grashof


FOUR_BARS = {
    "drag-link": "double crank",
    "dough-mixer": "crank and rocker",
    "hoeken-line": "crank and rocker",
    "chebyshev-line": "double rocker",
    "watt-line": "double rocker",
    "roberts-line": "double rocker",
    "portal-crane": "double rocker",
    "pumpjack": "crank and rocker",
}


@pytest.mark.parametrize("name", FOUR_BARS)
def test_a_four_bar_is_what_the_rule_of_grashof_says(name: str) -> None:
    """The shortest and the longest together against the other two; and its driver goes round, or does not."""
    here = solve(scene(name)).r
    frame, crank, coupler, rocker = (abs(here[a] - here[b]) for a, b in pairwise("DABCD"))
    kind = FOUR_BARS[name]
    lengths = sorted((frame, crank, coupler, rocker))
    turns = lengths[0] + lengths[3] < lengths[1] + lengths[2]
    said = {frame: "double crank", crank: "crank and rocker", coupler: "double rocker"}[lengths[0]] if turns else ""
    assert (said or "double rocker") == kind
    assert motion_of_points(scene(name))["round"] == (kind != "double rocker")


# --- strokes


STROKES = {  # twice the crank where the guide goes through its axis; of others as their makers publish, m
    ("v-twin", "C"): (0.108, 1e-4),
    ("v-twin", "D"): (0.108, 1e-4),
    ("radial-engine", "C"): (0.12, 1e-4),
    ("sewing-machine", "C"): (0.032, 1e-4),
    ("hacksaw", "C"): (math.sqrt(0.38**2 - 0.12**2) - math.sqrt(0.22**2 - 0.12**2), 1e-4),
    ("walschaerts-gear", "C"): (0.6, 1e-3),
    ("drag-link", "F"): (0.2, 1e-3),
}


@pytest.mark.parametrize("name, point", STROKES)
def test_a_stroke_is_what_its_crank_makes_it(name: str, point: str) -> None:
    stroke, off = STROKES[name, point]
    path = places(name, point, [k + 0.5 for k in range(0, 360, 2)])
    assert max(abs(z - path[0]) for z in path) <= stroke + 1e-9
    far = max(path, key=lambda z: abs(z - path[0]))
    assert max(abs(z - far) for z in path) == pytest.approx(stroke, abs=off)


def test_articulated_rods_make_strokes_of_their_own() -> None:
    strokes = []
    for point in "CFG":
        path = places("radial-engine", point, [k * 3.0 for k in range(120)])
        strokes.append(spread([abs(z) for z in path]))
    assert strokes[1] == pytest.approx(strokes[2], rel=1e-3) and 1.003 < strokes[1] / strokes[0] < 1.1


def test_a_pumpjack_has_the_stroke_of_its_standard() -> None:
    """54 inches, as units are named, along the arc of the horsehead (API Spec 11E, unit C-114D-133-54)."""
    inch = 0.0254
    path = places("pumpjack", "E", range(0, 360, 2))
    hinge = complex(*size("pumpjack", "x_D", "y_D"))
    turned = [cmath.phase((z - hinge) / (path[0] - hinge)) for z in path]
    assert spread(turned) * 72 == pytest.approx(54, abs=2) and abs(path[0] - hinge) == pytest.approx(72 * inch)


def test_an_atkinson_engine_makes_four_strokes_in_a_turn() -> None:
    """The piston is twice as far out as rod and rocker in line reach, 0.5 m; one stroke is twice the other at least."""
    path = [-z.real for z in places("atkinson-engine", "E", range(0, 360, 2))]
    ends = [k for k in range(180) if (path[k] - path[k - 1]) * (path[(k + 1) % 180] - path[k]) < 0]
    far = sorted(path[k] for k in ends)
    assert len(ends) == 4 and far[2:] == [pytest.approx(0.5, abs=2e-4)] * 2
    assert 0.5 - far[0] > 2 * (0.5 - far[1]) > 0.1


def test_a_shaking_conveyor_goes_one_way_faster_than_the_other() -> None:
    path = [z.real for z in places("shaking-conveyor", "E", range(0, 360, 2))]
    right = sum(path[k] > path[k - 1] for k in range(180))
    assert (180 - right) / right == pytest.approx(1.25, abs=0.05)


@pytest.mark.slow
@pytest.mark.parametrize("path", CLASSICS, ids=lambda p: p.stem)
def test_commands_take_a_classic(path: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for command in (["solve", str(path)], ["cycle", str(path)], ["lesson", str(path), "-o", str(tmp_path / "l.html")]):
        assert main([*command, "--lang", "en"]) == 0
        doubts = [line for line in capsys.readouterr().err.splitlines() if " written: " not in line]
        assert not doubts or path.stem in PASSIVE


def test_ackermann_turns_the_inner_wheel_more() -> None:
    """Both knuckles of a trapezium 1.32 wide: turned one way by 20 degrees, the other wheel turns by less."""
    arm, rod, track = size("ackermann-steering", "l_AB", "l_BC", "track")
    straight = math.degrees(math.acos((track - rod) / 2 / arm))
    turned = places("ackermann-steering", "C", [-straight - 20, -straight, -straight + 20])
    angles = [math.degrees(math.atan2(z.imag, z.real - track)) % 360 for z in turned]
    assert angles[1] == pytest.approx(180 + straight, abs=1e-9)
    one, two = angles[1] - angles[0], angles[2] - angles[1]
    assert min(one, two) < 20 < max(one, two) and one != pytest.approx(two, abs=1)


def test_a_levelled_platform_stays_level() -> None:
    b, f = (places("aerial-platform", p, range(20, 80, 10)) for p in ("B", "F"))
    assert max(abs((y - x) - (f[0] - b[0])) for x, y in zip(b, f, strict=True)) < 1e-12


def test_an_offset_cylinder_has_strokes_of_two_lengths_of_time() -> None:
    """The ends of the stroke are where crank and rod are in line: apart by other than half a turn."""
    r, rod, e = size("desaxial-engine", "l_AB", "l_BC", "e")
    top, bottom = (math.degrees(math.asin(e / x)) for x in (rod + r, rod - r))
    ends = places("desaxial-engine", "C", [90 - top, 270 - bottom])
    heights = [math.sqrt((rod + r) ** 2 - e**2), math.sqrt((rod - r) ** 2 - e**2)]
    assert [z.imag for z in ends] == pytest.approx(heights, abs=1e-12) and bottom > 1.5 * top
