"""A cylinder across the hinge of two links drives, or one in a lead of a group of class III: against the law of cosines
and the independent solver."""

from __future__ import annotations

import cmath
import math
import random

import numpy as np
import pytest

from planes import cycle, solve
from planes.plans import plans_of, structure_of
from planes.plans.assur.alignment import self_aligning_variant
from planes.scene import loads
from planes.words.errors import PlanesError, SceneError, StructureError
from tests.helpers.comparing import balanced, draw, standing, turned_about
from tests.helpers.mechanisms import KINDS, make

KNEE = """\
planes: 1
frame: {points: {O: [0, 0], D: [1.0, 0.1]}}
links:
  1: {points: {Q: 0}, guides: {cyl: {through: Q, angle: 0}}}
  2: {points: {P: 0}, slides: cyl}
  3: {points: {O: 0, A: 0.5, Q: [0.2, 0.05], S3: 0.25}, centre: S3, mass: 10, inertia: 0.4}
  4: {points: {A: 0, B: 0.8, P: [0.3, -0.1], S4: 0.4}, centre: S4, mass: 12, inertia: 0.9}
  5: {points: {D: 0, B: 0.6}}
assembly: {B: left, P: left}
drive: {link: 2, s: 0.45, velocity: 0.1, acceleration: 0.3}
loads: [{link: 5, point: B, force: 300, direction: 20}]
gravity: 9.81
"""


def test_the_angle_of_the_two_links_by_the_law_of_cosines() -> None:
    """The triangle of the cylinder gives the angle of rocker and coupler, its derivative their relative speed."""
    found = solve(loads(KNEE))
    a_q, a_p = abs(0.5 - complex(0.2, 0.05)), abs(complex(0.3, -0.1))
    cosine = (a_q**2 + a_p**2 - 0.45**2) / (2 * a_q * a_p)
    one, two = found.r["Q"] - found.r["A"], found.r["P"] - found.r["A"]
    assert abs(cmath.phase(two / one)) == pytest.approx(math.acos(cosine), rel=1e-13)
    slope = 0.45 / (a_q * a_p * math.sin(math.acos(cosine)))  # of the angle by the length
    assert abs(found.omega["4"] - found.omega["3"]) == pytest.approx(0.1 * slope, rel=1e-12)
    assert found.value("Fb_2") == pytest.approx(found.value("zhukovsky_force"), rel=1e-11)


def test_a_weightless_cylinder_pushes_along_itself_alone() -> None:
    found = solve(loads(KNEE))
    along = found.r["P"] - found.r["Q"]
    force = found.value("F_42")
    assert abs((force * along.conjugate()).imag) <= 1e-12 * abs(force * along)


def test_its_structure() -> None:
    structure = structure_of(loads(KNEE).mechanism)  # type: ignore[arg-type]
    assert structure.structural_formula == "I(1;2) -> II(1-2-3-4;5)" and structure.q == 6
    assert structure.json()["groups"][0]["drive"] == ["1", "2"] and structure.json()["groups"][0]["across"] == "A"
    found = self_aligning_variant(plans_of(loads(KNEE).mechanism))  # type: ignore[arg-type]
    assert found.redundant_constraints == 0 and len(found.pairs) == 7 == len({p for p, _ in found.pairs})


@pytest.mark.slow
def test_friction_in_its_hinges_takes_its_power() -> None:
    """What friction takes in the three hinges of the brace and in those on the frame, the cylinder gives besides."""
    pin = "{coefficient: 0.15, radius: 0.03}"
    rubbing = (
        KNEE.replace("acceleration: 0.3", "acceleration: 0")
        + f"friction: {{{', '.join(f'{p}: {pin}' for p in 'AQPOBD')}}}\n"
    )
    found = solve(loads(rubbing))
    pairs = ("43", "24", "13", "30", "54", "50")
    taken = sum(found.value(f"P_T{pair}") for pair in pairs)
    assert all(found.value(f"P_T{pair}") < 0 for pair in pairs)
    smooth = solve(loads(rubbing.split("friction")[0]))
    assert (found.value("Fb_2") - smooth.value("Fb_2")) * 0.1 == pytest.approx(-taken, rel=1e-11)
    assert found.value("Fb_2") == pytest.approx(found.value("zhukovsky_force"), rel=1e-11)
    arm = found.value("M_T24") / abs(found.value("F_24"))
    assert abs(arm) == pytest.approx(0.15 * 0.03, rel=1e-12)


def test_in_the_loop_and_at_rest() -> None:
    reaches = np.linspace(0.35, 0.55, 3)
    found = cycle(loads(KNEE), s=reaches)
    for k, reach in enumerate(reaches):
        assert found["Fb_2"][k] == pytest.approx(solve(loads(KNEE), s=float(reach)).value("Fb_2"), rel=1e-11)
    rest = solve(loads(KNEE.replace("velocity: 0.1", "velocity: 0")))
    assert rest.value("Fb_2") == pytest.approx(rest.value("zhukovsky_force"), rel=1e-11)


@pytest.mark.parametrize(
    ("old", "new", "why"),
    [
        ("assembly: {B: left, P: left}", "assembly: {B: left}", "P: left"),
        ("P: left}", "P: {near: [0.6, 0.1]}}", "P: left"),
        ("P: [0.3, -0.1]", "K: [0.3, -0.1]", "W"),
    ],
)
def test_what_cannot_be_drawn_is_one_sentence(old: str, new: str, why: str) -> None:
    with pytest.raises(PlanesError, match=why):
        solve(loads(KNEE.replace(old, new)))


def test_too_long_a_cylinder_is_one_sentence() -> None:
    with pytest.raises(PlanesError, match="arcs"):
        solve(loads(KNEE), s=2.0)


def examined(seed: int, inner: str = "brace") -> float | None:
    """The worst number of one random mechanism; None where something stands still."""
    rng = random.Random(f"{inner} {seed}")
    rubs = {"friction": seed % 5 == 0, "pins": seed % 2 == 0}
    case = make(rng, rng.choices(KINDS, k=seed % 3), inner=inner, rest=seed % 7 == 0, assembly="side", **rubs)
    if standing(case):
        return None
    d = draw(case.scene)
    balanced(d, seed)
    return max(turned_about(d, case).values()) * d.sharpest


def test_random_mechanisms_braced_by_a_cylinder() -> None:
    found = [e for seed in range(5) if (e := examined(seed)) is not None]
    assert len(found) > 2 and max(found) <= 1e-10


@pytest.mark.few(0, slow=3)
@pytest.mark.parametrize("fifth", range(5))
def test_more_random_mechanisms_braced_by_a_cylinder(fifth: int) -> None:
    found = [e for seed in range(1000 + 80 * fifth, 1080 + 80 * fifth) if (e := examined(seed)) is not None]
    assert len(found) > 60 and max(found) <= 1e-9


LEAD = """\
planes: 1
frame: {points: {O: [0, 0], D: [1.0, 0.1], Q: [0.5, -0.3]}}
links:
  1: {points: {Q: 0}, guides: {cyl: {through: Q, angle: 0}}}
  2: {points: {P: 0}, slides: cyl}
  3: {points: {O: 0, A: 0.5}}
  4: {points: {A: 0, B: 0.8, P: [0.3, -0.1], S4: 0.4}, centre: S4, mass: 12, inertia: 0.9}
  5: {points: {D: 0, B: 0.6}}
assembly: {B: {near: [0.8, 0.65]}}
drive: {link: 2, s: 0.7, velocity: 0.1, acceleration: 0.3}
gravity: 9.81
"""


def test_a_cylinder_lifts_a_coupler_as_its_curve_says() -> None:
    """The coupler's point is as far from the cylinder's hinge as that is long, and goes away as fast."""
    found = solve(loads(LEAD))
    along = found.r["P"] - complex(0.5, -0.3)
    assert abs(along) == pytest.approx(0.7, rel=1e-12)
    assert (found.v["P"] * along.conjugate()).real / abs(along) == pytest.approx(0.1, rel=1e-11)
    power = 12 * 9.81 * found.v["S4"].imag + 12 * (found.a["S4"] * found.v["S4"].conjugate()).real
    power += 0.9 * found.epsilon["4"] * found.omega["4"]
    assert found.value("Fb_2") * 0.1 == pytest.approx(power, rel=1e-10)
    structure = structure_of(loads(LEAD).mechanism)  # type: ignore[arg-type]
    assert structure.structural_formula == "I(1;2) -> III(1-2;3;4;5)"
    found_variant = self_aligning_variant(plans_of(loads(LEAD).mechanism))  # type: ignore[arg-type]
    assert found_variant.redundant_constraints == 0 and len(found_variant.pairs) == 7


BETWEEN = """\
planes: 1
frame: {points: {O: [0, 0], D: [1.0, 0.1]}}
links:
  1: {points: {Q: 0}, guides: {cyl: {through: Q, angle: 0}}}
  2: {points: {P: 0}, slides: cyl}
  3: {points: {O: 0, A: 0.5, Q: [0.2, 0.1]}}
  4: {points: {A: 0, B: 0.8, S4: 0.4}, centre: S4, mass: 12, inertia: 0.9}
  5: {points: {D: 0, B: 0.6, P: [0.4, 0.15]}}
assembly: {B: {near: [0.85, 0.7]}}
drive: {link: 2, s: 0.8, velocity: 0.1, acceleration: 0.3}
loads: [{link: 5, point: B, force: 300, direction: 20}]
gravity: 9.81
"""


def test_a_cylinder_between_two_rockers_closes_a_contour() -> None:
    structure = structure_of(loads(BETWEEN).mechanism)  # type: ignore[arg-type]
    assert structure.structural_formula == "I(1;2) -> IV(1-2;3;4;5)"
    found = solve(loads(BETWEEN))
    assert abs(found.r["P"] - found.r["Q"]) == pytest.approx(0.8, abs=1e-12)
    assert abs(found.r["A"] - found.r["B"]) == pytest.approx(0.8, abs=1e-12)
    assert found.value("Fb_2") == pytest.approx(found.value("zhukovsky_force"), rel=1e-10)
    found_variant = self_aligning_variant(plans_of(loads(BETWEEN).mechanism))  # type: ignore[arg-type]
    assert found_variant.redundant_constraints == 0 and len(found_variant.pairs) == 7


def test_a_cylinder_that_makes_a_parallelogram_is_at_a_dead_point() -> None:
    with pytest.raises(SceneError, match="two of them coincide"):
        plans_of(loads(BETWEEN.replace("P: [0.4, 0.15]", "P: [0.3, 0.1]")).mechanism)  # type: ignore[arg-type]


def test_a_cylinder_between_two_sliding_links_is_told_what_would_do() -> None:
    text = BETWEEN.replace("D: [1.0, 0.1]}}", "D: [1.0, 0.1]}, guides: {x-x: {y: 0}, y-y: {x: 0}}}")
    text = text.replace("O: 0, A: 0.5, Q: [0.2, 0.1]}", "A: 0, Q: [0.2, 0.1]}, slides: y-y")
    text = text.replace("D: 0, B: 0.6, P: [0.4, 0.15]}", "B: 0.6, P: [0.3, 0.1]}, slides: x-x")
    with pytest.raises(StructureError, match="between links 2 and 1, and with it stopped"):
        plans_of(loads(text).mechanism)  # type: ignore[arg-type]


@pytest.mark.parametrize("inner", ["lead", "rocked"])
def test_random_mechanisms_with_the_drive_in_a_higher_group(inner: str) -> None:
    found = [e for seed in range(3) if (e := examined(seed, inner)) is not None]
    assert len(found) > 1 and max(found) <= 1e-10


@pytest.mark.few(0, slow=5)
@pytest.mark.parametrize("inner", ["lead", "rocked"])
@pytest.mark.parametrize("fifth", range(5))
def test_more_random_mechanisms_with_the_drive_in_a_higher_group(inner: str, fifth: int) -> None:
    found = [e for seed in range(1000 + 40 * fifth, 1040 + 40 * fifth) if (e := examined(seed, inner)) is not None]
    assert len(found) > 30 and max(found) <= 1e-9
