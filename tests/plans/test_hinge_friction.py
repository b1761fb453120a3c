"""Friction in hinges by friction circles, and on circular guides, against closed forms and the independent solver."""

from __future__ import annotations

import cmath
import math
import random
from typing import Any

import numpy as np
import pytest

from planes import cycle, solve
from planes.documents.sheets import sheet_of
from planes.plans import plans_of
from planes.scene import loads
from planes.words.errors import PlanesError, SceneError
from render.paper.marks import Arc
from tests.helpers.comparing import against, balanced, standing
from tests.helpers.mechanisms import KINDS, make

HANGING = """\
planes: 1
frame: {points: {O: [0, 0]}}
links: {1: {points: {O: 0, S: 0.5}, mass: 4, inertia: 0.2, centre: S}}
drive: {link: 1, phi: -30, omega: OMEGA, epsilon: 6}
gravity: 9.81
friction: {O: {coefficient: 0.2, radius: 0.03}}
"""
CRANK = """\
planes: 1
parameters: {phi: 50}
frame: {points: {O: [0, 0]}, guides: {x-x: {y: 0}}}
links:
  1: {points: {O: 0, A: 0.1}}
  2: {points: {A: 0, B: 0.4}}
  3: {points: {B: 0}, slides: x-x}
assembly: {B: ahead}
drive: {link: 1, phi: phi, omega: 10}
loads: [{link: 3, point: B, force: 1000, direction: 180}]
friction: {O: PIN, A: PIN, B: PIN}
""".replace("PIN", "{coefficient: 0.15, radius: 0.04}")
ARC = """\
planes: 1
frame: {points: {O: [0, 0]}, guides: {arc: {centre: [0.3, 0], radius: 0.2}}}
links:
  1: {points: {O: 0, A: 0.1}}
  2: {points: {A: 0, B: 0.3}, mass: 2}
  3: {points: {B: 0}, slides: arc, mass: 1.5}
assembly: {B: left}
drive: {link: 1, phi: 40, omega: 10, epsilon: 4}
loads: [{link: 3, point: B, force: 100, direction: 200}]
friction: {arc: 0.3}
"""


@pytest.mark.parametrize("omega", [3.0, -3.0, 0.0])
def test_a_link_that_hangs_on_one_pin(omega: float) -> None:
    """At rest friction is against the motion a positive drive would give."""
    found = solve(loads(HANGING.replace("OMEGA", str(omega))))
    a = cmath.rect(0.5, math.radians(-30)) * (6j - omega**2)
    force = 4 * (a + 9.81j)
    rub = 0.006 * abs(force) * (-1 if omega < 0 else 1)
    assert found.value("F_10") == pytest.approx(force, rel=1e-13)
    smooth = 0.2 * 6 + 4 * (cmath.rect(0.5, math.radians(30)) * (a + 9.81j)).imag
    assert found.value("M_1") == pytest.approx(smooth + rub, rel=1e-13)
    assert found.value("M_T10") == pytest.approx(-rub, rel=1e-13)
    assert found.value("P_T10") == pytest.approx(-abs(rub) * (abs(omega) or 1.0), rel=1e-13)


@pytest.mark.parametrize("radius", [0.04, 0.5, 1.3])
@pytest.mark.parametrize("phi", [20.0, 50.0, 140.0, 230.0, 300.0])
def test_a_crank_slider_whose_rod_weighs_nothing(phi: float, radius: float) -> None:
    """The rod's force is tangent to both its friction circles, until these are as wide as it is long."""
    found = solve(loads(CRANK.replace("0.04", str(radius))), phi=phi)
    rho, length, turned = 0.15 * radius, 0.4, math.radians(phi)
    rod = found.r["B"] - found.r["A"]
    turning = -0.1 * 10 * math.cos(turned) / (length * math.cos(cmath.phase(rod)))
    at_a, at_b = rho * math.copysign(1, turning - 10), rho * math.copysign(1, turning)
    line = rod / abs(rod) * cmath.exp(-1j * math.asin((at_a + at_b) / length))
    force = line * 1000 / line.real
    assert found.value("F_21") == pytest.approx(force, rel=1e-12)
    arm = (found.r["A"].conjugate() * force).imag
    rub = rho * abs(force)
    assert found.value("M_1") == pytest.approx(arm - at_a * abs(force) + rub, rel=1e-11)


def test_energy_over_a_cycle() -> None:
    """Over a turn with masses, weights and friction the drive gives what friction takes."""
    text = CRANK.replace("B: 0.4}}", "B: 0.4, S: 0.2}, mass: 3, inertia: 0.05, centre: S}")
    text = text.replace("slides: x-x}", "slides: x-x, mass: 5}\ngravity: 9.81").replace("x-x: {y: 0}", "x-x: {y: 0.02}")
    text = text.replace("loads: [{link: 3, point: B, force: 1000, direction: 180}]\n", "")
    text = text.replace("friction: {", "friction: {x-x: 0.1, ")
    found = cycle(loads(text), phi=np.arange(0.0, 360.0, 0.25))
    given = float(np.mean(found["M_1"]) * 10)
    assert given > 1.0
    taken = []
    for phi in np.arange(0.0, 360.0, 7.5):
        one = solve(loads(text), phi=float(phi))
        powers = [one.value(f"P_T{pair}") for pair in ("10", "21", "32", "30")]
        assert max(powers) <= 1e-9
        taken.append(sum(powers))
    assert float(np.mean(taken)) == pytest.approx(-given, rel=2e-2)


def test_what_slides_on_a_circle_touches_it_at_one_place() -> None:
    """The reaction meets the circle where its normal and tangential parts are as 1 to f, and holds the link alone."""
    found = solve(loads(ARC))
    force, couple, centre = found.value("F_30"), found.value("M_T30"), 0.3 + 0j
    away = -1j * force / abs(force) * couple / abs(force)  # from the centre to the line of action
    ahead = math.sqrt(0.04 - abs(away) ** 2)
    for place in (centre + away + s * ahead * force / abs(force) for s in (1, -1)):
        normal = (place - centre) / 0.2
        push, rub = (force * normal.conjugate()).real, (force * normal.conjugate()).imag
        assert abs(rub) == pytest.approx(0.3 * abs(push), rel=1e-12)
        assert rub * found.omega["3"] < 0  # against the sliding
    assert found.value("M_1") == pytest.approx(found.value("zhukovsky_moment"), rel=1e-11)


@pytest.mark.parametrize("text", [CRANK, ARC])
def test_loop_arrays_and_one_position_agree(text: str) -> None:
    scene = loads(text)
    values = np.linspace(15.0, 75.0, 7)
    fast = cycle(scene, phi=values)
    for k, phi in enumerate(values):
        one = solve(scene, phi=float(phi))
        assert fast["M_1"][k] == pytest.approx(one.value("M_1"), rel=1e-11)


def test_what_cannot_settle_is_one_sentence() -> None:
    with pytest.raises(PlanesError, match="does not settle: self-locking"):
        solve(loads(CRANK.replace("0.04", "1.34")))


@pytest.mark.parametrize(
    ("said", "why"),
    [
        ("A: 0.1", "in a hinge the radius of the pin matters too; write A: {coefficient: 0.1, radius: 0.02}"),
        ("A: {coefficient: 0.1}", "needs the key radius"),
        ("A: {coefficient: 0.1, radius: -1}", "cannot be negative"),
        ("A: {coefficient: 0.1, radius: 1, f: 2}", "has no key"),
        ("Q: {coefficient: 0.1, radius: 1}", "there is no guide or hinge"),
        ("x-x: {coefficient: 0.1, radius: 1}", "a number"),
    ],
)
def test_what_cannot_be_meant_is_one_sentence(said: str, why: str) -> None:
    with pytest.raises(SceneError, match=why.replace("{", r"\{")) as error:
        loads(CRANK.split("friction")[0] + f"friction: {{{said}}}")
    assert "scene.yaml:11" in str(error.value)


def test_a_scene_is_written_back_and_read_the_same() -> None:
    for text in (CRANK, ARC):
        scene = loads(text)
        assert loads(scene.to_yaml()).mechanism == scene.mechanism


def test_values_change_no_program() -> None:
    other = CRANK.replace("0.15", "0.01").replace("0.04", "0.01")
    mechanisms = [loads(text).mechanism for text in (CRANK, other)]
    assert mechanisms[0] and mechanisms[1]
    assert plans_of(mechanisms[0]).program == plans_of(mechanisms[1]).program


def test_the_sheet_shows_friction_circles_with_the_line_tangent() -> None:
    sheet = sheet_of(loads(CRANK), None, "en", 2)
    circles = [m for m in sheet.marks if isinstance(m, Arc) and m.layer == "construction" and m.style == "thin"]
    assert len(circles) == 5


def examined(seed: int) -> float | None:
    """The worst number of one random mechanism with rubbing pins; None where something stands still."""
    rng = random.Random(f"pins {seed}")
    kinds = rng.choices(KINDS, k=rng.choice((1, 1, 2, 2, 3)))
    how: dict[str, Any] = {"friction": seed % 3 == 0, "sliding": seed % 5 == 0, "rest": seed % 7 == 0}
    case = make(rng, kinds, pins=True, **how)
    if standing(case):
        return None
    drawn, wrong = against(case)
    balanced(drawn, seed)
    return max(wrong.values()) * drawn.sharpest


def test_random_mechanisms_with_rubbing_pins() -> None:
    found = [e for seed in range(40) if (e := examined(seed)) is not None]
    assert len(found) > 30 and max(found) <= 1e-11


@pytest.mark.slow
@pytest.mark.parametrize("fifth", range(5))
def test_more_random_mechanisms_with_rubbing_pins(fifth: int) -> None:
    found = [e for seed in range(1000 + 80 * fifth, 1080 + 80 * fifth) if (e := examined(seed)) is not None]
    assert len(found) > 60 and max(found) <= 1e-9
