"""Passive constraints: mechanisms that move though they are held too often are solved without what holds twice."""

from __future__ import annotations

import cmath
import math

import numpy as np
import pytest

from planes import solve
from planes.batch.cycle import Cycle
from planes.documents.lesson import note_file_contents
from planes.documents.sheets import sheet_of
from planes.plans.statements.of_scene import scene_plans
from planes.scene import loads
from planes.words.errors import StructureError
from render.paper.marks import Text

TRAMMEL = """\
planes: 1
frame: {{points: {{O: [0, 0]}}, guides: {{x-x: {{y: 0}}, y-y: {{x: 0}}}}}}
links:
  1: {{points: {{O: 0, C: 0.1}}}}
  2: {{points: {{C: 0, A: 0.1, B: {far}}}{more}}}
  3: {{points: {{A: 0}}, slides: x-x}}
  4: {{points: {{B: 0}}, slides: y-y}}
drive: {{link: 1, phi: {phi}, omega: 10, epsilon: 3}}
"""
PARALLELOGRAM = """\
planes: 1
frame: {{points: {{O: [0, 0], D: [0.4, 0], E: [0.8, 0]}}}}
links:
  1: {{points: {{O: 0, A: 0.1}}}}
  2: {{points: {{A: 0, B: 0.4, C: 0.8}}}}
  3: {{points: {{D: 0, B: 0.1}}}}
  4: {{points: {{E: 0, C: {crank}}}{mass}}}
assembly: {{B: left}}
drive: {{link: 1, phi: {phi}, omega: 10}}
"""


def trammel(phi: float = 40, far: float = -0.1, more: str = "") -> str:
    return TRAMMEL.format(phi=phi, far=far, more=more)


def parallelogram(phi: float = 40, crank: float = 0.1, mass: str = "") -> str:
    return PARALLELOGRAM.format(phi=phi, crank=crank, mass=mass)


@pytest.mark.parametrize("phi", [5.0, 40.0, 77.0, 130.0, 251.0, 300.0])
def test_an_ellipsograph_with_its_crank_in_closed_form(phi: float) -> None:
    """A = 2r cos φ on x, B = 2r sin φ on y; their rates are its derivatives."""
    found = solve(loads(trammel(phi)))
    angle, r, w, e = math.radians(phi), 0.1, 10.0, 3.0
    sin, cos = math.sin(angle), math.cos(angle)
    assert found.r["A"] == pytest.approx(2 * r * cos, abs=1e-12) and found.r["B"] == pytest.approx(
        2j * r * sin, abs=1e-12
    )
    assert found.v["A"] == pytest.approx(-2 * r * w * sin, abs=1e-10)
    assert found.v["B"] == pytest.approx(2j * r * w * cos, abs=1e-10)
    assert found.a["A"] == pytest.approx(-2 * r * (w * w * cos + e * sin), abs=1e-8)
    assert found.a["B"] == pytest.approx(-2j * r * (w * w * sin - e * cos), abs=1e-8)
    assert "link 4 is a passive constraint" in " ".join(found.results["warnings"])


@pytest.mark.parametrize("phi", [2.0, 40.0, 120.0, 178.0])
def test_a_double_parallelogram_goes_round_in_a_circle(phi: float) -> None:
    found = solve(loads(parallelogram(phi)))
    arm = 0.1 * cmath.exp(1j * math.radians(phi))
    for point, start in zip("ABC", (0.0, 0.4, 0.8), strict=True):
        assert found.r[point] == pytest.approx(start + arm, abs=1e-11)
        assert found.v[point] == pytest.approx(10j * arm, abs=1e-9)


@pytest.mark.parametrize(
    ("plain", "moved"),
    [
        (parallelogram(), parallelogram().replace("{E: 0, C: 0.1}", "{E: 0.25, C: 0.35}")),
        (parallelogram(), parallelogram().replace("{D: 0, B: 0.1}", "{D: -0.4, B: -0.3}")),
        (trammel(), trammel().replace("{C: 0, A: 0.1, B: -0.1}", "{C: 0.2, A: 0.3, B: 0.1}")),
    ],
)
def test_own_axes_of_a_passive_link_may_begin_anywhere(plain: str, moved: str) -> None:
    assert plain != moved
    one, two = (solve(loads(text)) for text in (plain, moved))
    assert dict(two.omega) == pytest.approx(dict(one.omega)) and dict(two.v) == pytest.approx(dict(one.v))
    assert one.plans.structure.passive == two.plans.structure.passive


def test_a_passive_slider_turned_to_its_guide_stands_turned() -> None:
    found = solve(loads(trammel().replace("{B: 0}, slides: y-y", "{B: 0}, slides: {guide: y-y, angle: 30}")))
    assert found.plans.structure.passive == ("4",) and found.value("phi_4") == pytest.approx(120)


@pytest.mark.parametrize("scene", [trammel(far=-0.1001), trammel(far=-0.1 - 1e-7), parallelogram(crank=0.1002)])
def test_what_is_held_too_often_by_a_little_is_refused(scene: str) -> None:
    with pytest.raises(StructureError, match="W = 3·4 - 2·6 = 0"):
        scene_plans(loads(scene))


@pytest.mark.parametrize("aside", [0.03, -0.05])
def test_a_passive_slider_beside_its_guide_holds_on_its_own_side(aside: float) -> None:
    """B goes along x = 0 by itself; that is as far to the left of a guide that points up as the guide is to the right
    of it. A slider as far to its right holds B where it does not go."""
    beside = trammel().replace("y-y: {x: 0}", f"y-y: {{x: {aside}}}")
    text = beside.replace("slides: y-y", f"slides: {{guide: y-y, offset: {aside}}}")
    assert scene_plans(loads(text)).structure.passive == ("4",)
    assert solve(loads(text)).r["B"] == pytest.approx(0.2j * math.sin(math.radians(40)), abs=1e-12)
    with pytest.raises(StructureError, match="W = 3·4 - 2·6 = 0"):
        scene_plans(loads(beside.replace("slides: y-y", f"slides: {{guide: y-y, offset: {-aside}}}")))


def test_a_link_that_carries_something_is_not_the_one_left_out() -> None:
    assert scene_plans(loads(parallelogram(mass=", mass: 3"))).structure.passive == ("3",)


def test_every_reader_draws_or_tells_the_passive_link() -> None:
    scene = loads(trammel())
    plans = scene_plans(scene)
    assert plans.structure.json()["passive"] == ["4"] and [x.name for x in plans.passive] == ["4"]
    texts = {m.text for m in sheet_of(scene, None, number=1).marks if isinstance(m, Text)}
    assert "4" in texts and any("пассивная связь" in t for t in texts)
    (block,) = Cycle(plans, ["v_B"]).blocks(np.array([20.0, 40.0]))
    assert np.allclose(block.table[:2].ravel(order="F")[:2], [0.0, 2 * math.cos(math.radians(20))], atol=1e-9)


@pytest.mark.parametrize("phi", [5.0, 40.0, 130.0])
def test_passive_links_move_as_what_holds_them(phi: float) -> None:
    """The third crank of a parallelogram turns as the driver does; the slider of an ellipsograph keeps its turn."""
    found = solve(loads(parallelogram(phi)))
    assert scene_plans(loads(parallelogram(phi))).structure.passive == ("4",)
    turned = math.remainder(found.value("phi_4") - phi, 360)
    assert turned == pytest.approx(0.0, abs=1e-9) and found.omega["4"] == pytest.approx(10.0, rel=1e-10)
    assert found.epsilon["4"] == pytest.approx(0.0, abs=1e-7)
    held = solve(loads(trammel(phi)))
    assert held.value("phi_4") == 90.0 and held.omega["4"] == 0.0


def test_a_note_of_a_mechanism_with_a_passive_slider_has_its_self_aligning_variant() -> None:
    assert note_file_contents(loads(trammel()), None, ".html", "en")


def test_forces_that_are_not_determined_are_told_of() -> None:
    """The shares of links that hold the same are not found; what the drive must give is, by the work of the load."""
    text = "planes: 1\nframe: {points: {O: [0, 0], D: [0.4, 0], E: [0.8, 0]}}\nlinks:\n  1: {points: {O: 0, A: 0.1}}\n"
    text += "  2: {points: {A: 0, B: 0.4, C: 0.8, S: 0.3}, centre: S, mass: 5}\n  3: {points: {D: 0, B: 0.1}}\n"
    text += "  4: {points: {E: 0, C: 0.1}}\nassembly: {B: left}\ndrive: {link: 1, phi: 40, omega: 10}\ngravity: 9.81\n"
    found = solve(loads(text))
    told = found.results["warnings"]
    assert any("passive" in one for one in told) and any("there are more reactions" in one for one in told)
    assert found.value("M_1") == pytest.approx(5 * 9.81 * 0.1 * math.cos(math.radians(40)), rel=1e-12)
    still = solve(loads(trammel())).results["warnings"]
    assert not any("there are more reactions" in one for one in still)  # no forces there


@pytest.mark.parametrize("own", [30.0, -77.0])
def test_the_angle_of_a_passive_link_is_that_of_its_own_axis(own: float) -> None:
    """Its two hinges lie along the crank's direction, and its axis is turned back by the angle they have in it."""
    text = parallelogram(phi=40).replace("{E: 0, C: 0.1}", f"{{E: 0, C: {{r: 0.1, angle: {own}}}}}")
    found = solve(loads(text))
    assert found.plans.structure.passive
    assert found.value("phi_4") == pytest.approx(40 - own)
    assert found.omega["4"] == pytest.approx(10)
