"""Drives between two moving links, a cylinder or a motor, against closed forms and the independent solver."""

from __future__ import annotations

import cmath
import math
import random

import numpy as np
import pytest

from planes import cycle, solve
from planes.plans import plans_of, structure_of
from planes.scene import loads
from planes.words.errors import PlanesError, StructureError
from tests.helpers import ROOT
from tests.helpers.comparing import against, balanced, draw, standing, turned_about
from tests.helpers.mechanisms import KINDS, make

LIFT = """\
planes: 1
parameters: {reach: 0.4}
frame: {points: {O: [0, 0], D: [0.5, 0]}}
links:
  1: {points: {D: 0}, guides: {cyl: {through: D, angle: 0}}}
  2: {points: {A: 0}, slides: cyl}
  3: {points: {O: 0, A: 0.4, P: 0.8}, centre: P, mass: 100}
assembly: {A: left}
drive: {link: 2, s: reach, velocity: 0.1, acceleration: 0.3}
gravity: 9.81
"""


@pytest.mark.parametrize("reach", [0.35, 0.5, 0.7])
def test_a_boom_by_the_law_of_cosines(reach: float) -> None:
    """The triangle ODA gives the boom's angle, its derivatives the rates, the power the force."""
    found = solve(loads(LIFT), s=reach)
    cosine = (0.5**2 + 0.4**2 - reach**2) / (2 * 0.5 * 0.4)
    turned = math.acos(cosine)
    assert cmath.phase(found.r["A"]) == pytest.approx(-turned, abs=1e-13)  # on the left from D to O
    slope = reach / (0.5 * 0.4 * math.sin(turned))
    omega = -slope * 0.1
    second = 1 / (0.5 * 0.4 * math.sin(turned)) - slope**2 / math.tan(turned)
    epsilon = -(slope * 0.3 + second * 0.1**2)
    assert found.omega["3"] == pytest.approx(omega, rel=1e-12)
    assert found.epsilon["3"] == pytest.approx(epsilon, rel=1e-11)
    moment = 100 * 0.8**2 * epsilon + 100 * 9.81 * found.r["P"].real
    assert found.value("Fb_2") == pytest.approx(moment * omega / 0.1, rel=1e-11)
    assert found.value("Fb_2") == pytest.approx(found.value("zhukovsky_force"), rel=1e-11)


def test_a_weightless_cylinder_pushes_along_itself_alone() -> None:
    found = solve(loads(LIFT))
    along = found.r["A"] - 0.5
    force = found.value("F_32")
    assert abs((force * along.conjugate()).imag) <= 1e-12 * abs(force * along)
    assert found.value("Fb_2") == pytest.approx((force * along.conjugate()).real / abs(along), rel=1e-12)


def test_a_cylinder_turned_round_does_the_same() -> None:
    """Its rod on the frame and its barrel at the boom: all that is not the cylinder's own is as before."""
    barrel = "1: {points: {A: 0}, guides: {cyl: {through: A, angle: 0}}}\n  2: {points: {D: 0}, slides: cyl}"
    old = "1: {points: {D: 0}, guides: {cyl: {through: D, angle: 0}}}\n  2: {points: {A: 0}, slides: cyl}"
    text = LIFT.replace(", acceleration: 0.3", "")
    turned = text.replace(old, barrel).replace("s: reach, velocity: 0.1", "s: -reach, velocity: -0.1")
    found, other = solve(loads(text)), solve(loads(turned))
    assert abs(found.value("Fb_2")) == pytest.approx(abs(other.value("Fb_2")), rel=1e-12)
    assert other.value("a_P") == pytest.approx(found.value("a_P"), rel=1e-12)
    assert other.value("F_30") == pytest.approx(found.value("F_30"), rel=1e-12)
    assert other.value("Fb_2") == pytest.approx(other.value("zhukovsky_force"), rel=1e-12)


MOTOR = """\
planes: 1
parameters: {phi: -80}
frame: {points: {O: [0, 0], C: [0.5, 0]}}
links:
  1: {points: {O: 0, A: 0.3}}
  2: {points: {A: 0, B: 0.35}}
  3: {points: {C: 0, B: 0.3, P: 0.2}, centre: P, mass: 5}
assembly: {B: left}
drive: {link: 2, on: 1, phi: phi, omega: 3}
gravity: 9.81
"""


def test_a_motor_between_a_crank_and_a_rod() -> None:
    """The knee's angle gives the distance OB by the law of cosines; the motor's couple is the gradient of the weight's
    work, with the inertia of what it moves."""
    found = solve(loads(MOTOR), phi=-80)
    reach = abs(0.3 + 0.35 * cmath.exp(1j * math.radians(-80)))
    assert abs(found.r["B"]) == pytest.approx(reach, rel=1e-13)
    assert found.omega["2"] - found.omega["1"] == pytest.approx(3.0, rel=1e-12)
    step = 1e-4
    ahead, behind = (solve(loads(MOTOR), phi=-80 + s) for s in (step, -step))
    still = solve(loads(MOTOR.replace("omega: 3", "omega: 0")))
    slope = (ahead.r["P"].imag - behind.r["P"].imag) / math.radians(2 * step)
    assert still.value("M_2") == pytest.approx(5 * 9.81 * slope, rel=1e-6)
    assert found.value("M_2") == pytest.approx(found.value("zhukovsky_moment"), rel=1e-12)
    rate = (cmath.phase(ahead.r["P"] - 0.5) - cmath.phase(behind.r["P"] - 0.5)) / math.radians(2 * step)
    assert found.omega["3"] == pytest.approx(3 * rate, rel=1e-6)


@pytest.mark.parametrize("drive", ["link: 2, on: 1", "link: 1, on: 2"])
def test_the_motor_turns_from_nought_as_from_anywhere(drive: str) -> None:
    """An angle of the drive that another angle equals by chance is not taken for that."""
    text = MOTOR.replace("phi: phi, omega: 3", "phi: 0").replace("link: 2, on: 1", drive)
    stated = text.replace("phi: 0", "phi: -80")
    for k in (text, stated):
        assert abs(solve(loads(k), phi=-80).r["A"]) == pytest.approx(0.3, rel=1e-13)
    assert solve(loads(text), phi=-80).r == solve(loads(stated)).r
    on_slider = stated.replace(
        "1: {points: {O: 0, A: 0.3}}", "1: {points: {O: 0, A: 0.3}, slides: {guide: x-x, angle: -80}}"
    )
    on_slider = on_slider.replace(
        "O: [0, 0], C: [0.5, 0]}", "C: [0.5, 0]}, guides: {x-x: {angle: 20, through: [0, 0]}}"
    )
    on_slider = on_slider.replace("B: left", "B: ahead")
    moved, there = solve(loads(on_slider), phi=-70), solve(loads(on_slider.replace("phi: -80", "phi: -70")))
    assert moved.r == pytest.approx(there.r, rel=1e-13)


def test_the_motor_told_from_either_side() -> None:
    """What turns on what is a matter of words: angle, rates and couple change their sense, nothing else."""
    other = solve(loads(MOTOR.replace("link: 2, on: 1, phi: phi, omega: 3", "link: 1, on: 2, phi: -phi, omega: -3")))
    found = solve(loads(MOTOR))
    assert other.value("M_1") == pytest.approx(-found.value("M_2"), rel=1e-12)
    assert other.epsilon == pytest.approx(found.epsilon, rel=1e-12)
    assert structure_of(loads(MOTOR).mechanism).structural_formula == "I(1;2) -> II(1-2;3)"  # type: ignore[arg-type]
    assert loads(loads(MOTOR).to_yaml()).mechanism == loads(MOTOR).mechanism


def test_its_structure() -> None:
    structure = structure_of(loads(LIFT).mechanism)  # type: ignore[arg-type]
    assert structure.structural_formula == "I(1;2) -> II(1-2;3)"
    assert structure.json()["groups"] == [{"links": ["1", "3"], "kind": 1, "name": "RRR", "drive": ["1", "2"]}]
    assert structure.q == 1 - 6 * 3 + 5 * 4


def test_values_change_no_program() -> None:
    other = LIFT.replace("0.4", "0.45").replace("0.5", "0.6")
    one, two = (plans_of(loads(text).mechanism).program for text in (LIFT, other))  # type: ignore[arg-type]
    assert one == two


def test_at_rest_and_in_the_loop() -> None:
    rest = loads(LIFT.replace("velocity: 0.1", "velocity: 0"))
    assert solve(rest).value("Fb_2") == pytest.approx(solve(rest).value("zhukovsky_force"), rel=1e-11)
    reaches = np.linspace(0.3, 0.7, 5)
    found = cycle(loads(LIFT), s=reaches)
    for k, reach in enumerate(reaches):
        assert found["Fb_2"][k] == pytest.approx(solve(loads(LIFT), s=float(reach)).value("Fb_2"), rel=1e-11)


@pytest.mark.parametrize(
    ("old", "new", "why"),
    [
        ("2: {points: {A: 0}, slides: cyl}", "2: {points: {B: 0}, slides: cyl}", "W"),
        ("link: 2, s: reach, velocity: 0.1, acceleration: 0.3", "link: 2, on: 1, s: reach", "leave it out"),
        ("link: 2, s: reach, velocity: 0.1, acceleration: 0.3", "link: 3, on: 1, phi: 3", "exactly one hinge"),
        ("link: 2, s", "link: 3, s", "slides on no straight guide"),
    ],
)
def test_what_cannot_be_drawn_is_one_sentence(old: str, new: str, why: str) -> None:
    with pytest.raises((StructureError, PlanesError), match=why):
        plans_of(loads(LIFT.replace(old, new)).mechanism)  # type: ignore[arg-type]


def test_too_long_a_cylinder_is_one_sentence() -> None:
    with pytest.raises(PlanesError):
        solve(loads(LIFT), s=2.0)


def examined(seed: int) -> float | None:
    """The worst number of one random mechanism driven by a cylinder or a motor between two links; None where something
    stands still."""
    return worst_of(seed, "inner", "motor" if seed % 2 else True)


def worst_of(seed: int, named: str, inner: bool | str) -> float | None:
    """The same of one with a drive of that kind."""
    rng = random.Random(f"{named} {seed}")
    rubs = {"pins": seed % 4 < 2, "friction": seed % 5 == 0}
    case = make(rng, rng.choices(KINDS, k=seed % 3), inner=inner, rest=seed % 7 == 0, **rubs)
    if standing(case):
        return None
    drawn, wrong = against(case)
    balanced(drawn, seed)
    return max(wrong.values()) * drawn.sharpest


def test_random_mechanisms_driven_from_inside() -> None:
    found = [e for seed in range(40) if (e := examined(seed)) is not None]
    assert len(found) > 30 and max(found) <= 1e-11


@pytest.mark.slow
@pytest.mark.parametrize("fifth", range(5))
def test_more_random_mechanisms_driven_from_inside(fifth: int) -> None:
    found = [e for seed in range(1000 + 80 * fifth, 1080 + 80 * fifth) if (e := examined(seed)) is not None]
    assert len(found) > 60 and max(found) <= 1e-9


BOOM = """\
planes: 1
frame: {points: {O: [0, 0], K: [0.6, -0.3]}}
links:
  1: {points: {O: 0, L: 1.2, Q: [1.0, 0.4], D: 2.6, S1: 1.3}, centre: S1, mass: 400, inertia: 200}
  2: {points: {K: 0, L: 1.1}}
  3: {points: {Q: 0}, guides: {cyl: {through: Q, angle: 0}}}
  4: {points: {P: 0}, slides: cyl}
  5: {points: {D: 0, P: [-0.5, 0.2], T: 1.6, S5: 0.7}, centre: S5, mass: 150, inertia: 60}
assembly: {L: left, P: left}
drive: {link: 4, s: 1.3, velocity: 0.1, acceleration: 0.2}
loads: [{link: 5, point: T, force: 5000, direction: 60}]
gravity: 9.81
"""


def test_a_stick_on_a_boom_that_its_cylinder_holds() -> None:
    """The boom stands; the cylinder works alone, and the rod that holds the boom bears what moments about O give."""
    found = solve(loads(BOOM))
    structure = structure_of(loads(BOOM).mechanism)  # type: ignore[arg-type]
    assert structure.structural_formula == "I(3;4) -> II(1;2) -> II(3-4;5)"
    assert found.v["D"] == 0 == found.a["Q"] and abs(found.r["P"] - found.r["Q"]) == pytest.approx(1.3, rel=1e-13)
    push = 5000 * cmath.exp(1j * math.radians(60))
    power = (push * found.v["T"].conjugate()).real + (-150j * 9.81 * found.v["S5"].conjugate()).real
    power -= 150 * (found.a["S5"] * found.v["S5"].conjugate()).real + 60 * found.epsilon["5"] * found.omega["5"]
    assert found.value("Fb_4") * 0.1 == pytest.approx(-power, rel=1e-12)
    of_all = [(push, "T"), (-150j * 9.81, "S5"), (-150 * found.a["S5"], "S5"), (-400j * 9.81, "S1")]
    moment = sum((found.r[at].conjugate() * force).imag for force, at in of_all) - 60 * found.epsilon["5"]
    held = found.value("F_20")
    along = found.r["L"] - found.r["K"]
    assert abs((held * along.conjugate()).imag) <= 1e-12 * abs(held * along)
    assert (found.r["K"].conjugate() * held).imag == pytest.approx(-moment, rel=1e-11)


def on_boom(seed: int) -> float | None:
    """The worst number of one random mechanism driven on links that stand still."""
    rng = random.Random(f"boom {seed}")
    rubs = {"pins": seed % 4 < 2, "friction": seed % 5 == 0}
    case = make(rng, rng.choices(KINDS, k=seed % 3), inner="boom", rest=seed % 7 == 0, **rubs)
    if standing(case):
        return None
    drawn = draw(case.scene)
    balanced(drawn, seed)
    return max(turned_about(drawn, case).values()) * drawn.sharpest


def on_slider(seed: int) -> float | None:
    """The worst number of one random mechanism whose drive stands on a slider."""
    return worst_of(seed, "slider", "slider")


def test_random_mechanisms_driven_on_a_slider() -> None:
    found = [e for seed in range(8) if (e := on_slider(seed)) is not None]
    assert len(found) > 5 and max(found) <= 1e-11


@pytest.mark.slow
@pytest.mark.parametrize("half", range(2))
def test_more_random_mechanisms_driven_on_a_slider(half: int) -> None:
    found = [e for seed in range(1000 + 80 * half, 1080 + 80 * half) if (e := on_slider(seed)) is not None]
    assert len(found) > 60 and max(found) <= 1e-9


def test_random_mechanisms_on_what_stands_still() -> None:
    found = [e for seed in range(8) if (e := on_boom(seed)) is not None]
    assert len(found) > 5 and max(found) <= 1e-11


@pytest.mark.slow
@pytest.mark.parametrize("half", range(2))
def test_more_random_mechanisms_on_what_stands_still(half: int) -> None:
    found = [e for seed in range(1000 + 60 * half, 1060 + 60 * half) if (e := on_boom(seed)) is not None]
    assert len(found) > 40 and max(found) <= 1e-9


@pytest.mark.parametrize("name", ["1", "4"])
def test_the_rod_is_written_before_what_slides_whatever_their_links_are_called(name: str) -> None:
    carriage = (ROOT / "samples" / "carriage.yaml").read_text(encoding="utf-8")
    mechanism = loads(carriage.replace("\n  1: {", f"\n  {name}: {{").replace("on: 1", f"on: {name}")).mechanism
    assert mechanism
    (velocity,) = (e.equation_text for e in plans_of(mechanism).equations if e.plan == "velocity")
    assert velocity == f"v_B = v_C + v_BC = v_B0 + v_BB{name} + v_B{name}B0"
