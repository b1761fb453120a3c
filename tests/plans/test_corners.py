"""Scenes at the corners of the method, each against the independent solver; and what has gone wrong before."""

from __future__ import annotations

import cmath
import json
import math
import random
from typing import Any

import pytest

from planes.drafting.instruments import Pencil
from planes.plans.quantities import quantities_by_name
from planes.scene import load, loads
from planes.solving import plans_and_requested_results, solve
from planes.words.errors import SceneError
from planes.words.names import ACCELERATION_PLAN, VELOCITY_PLAN, scheme_mark
from tests.helpers import ROOT
from tests.helpers.comparing import checked, draw
from tests.helpers.mechanisms import KINDS, make, to_yaml
from tests.solving.test_failures import FOUR_BAR, ROCKER, SLIDER

TWO_SLIDERS = """\
planes: 1
frame: {points: {A: [0, 0], D: [0.5, 0.1]}, guides: {x: {y: -0.3}, y: {x: 0.9}}}
links:
  1: {points: {A: 0, B: 0.1}, mass: 1}
  2: {points: {B: 0, C: 0.45, E: [0.2, 0.1]}, guides: {g: {through: E, angle: 10, mark: L}},
      mass: 2, inertia: 0.2, centre: E}
  3: {points: {D: 0, C: 0.3}, mass: 1}
  4: {points: {H: 0}, slides: g, mass: 1}
  5: {points: {H: 0, Q: [0.1,0.1]}, slides: x, mass: 1}
  6: {points: {K: 0}, slides: g, mass: 1}
  7: {points: {K: 0}, slides: y, mass: 2}
assembly: {C: left}
drive: {link: 1, phi: 70, omega: 10, epsilon: 5}
gravity: 9.81
loads:
  - {link: 5, point: H, force: 100, against: motion}
  - {link: 7, point: K, force: 50, direction: {link: 2, angle: 40}}
friction: {g: 0.1, x: 0.05}
"""
CRANK = """\
planes: 1
frame: {points: {A: [0, 0]}}
links: {1: {points: {A: 0}, mass: 2, inertia: 1}}
drive: {link: 1, phi: 30, omega: 5, epsilon: 3}
gravity: 9.81
loads: [{link: 1, moment: 4, against: motion}, {link: 1, point: A, force: 7, direction: 20}]
"""
CRANK = """\
planes: 1
frame: {points: {A: [0, 0]}}
links: {1: {points: {A: 0, S: 0.1}, mass: 2, inertia: 1, centre: S}}
drive: {link: 1, phi: 30, omega: 5, epsilon: 3}
gravity: 9.81
loads:
  - {link: 1, moment: 4, against: motion}
  - {link: 1, point: S, force: 7, along: motion}
  - {link: 1, point: A, force: 7, direction: 20}
"""
ALONE = """\
planes: 1
frame: {guides: {x: {y: 0.1}}}
links: {1: {points: {A: 0, B: [0.1, 0.2]}, slides: {guide: x, angle: 180, offset: -0.05}, mass: 2, centre: B}}
drive: {link: 1, s: 0.3, velocity: -2, acceleration: 3}
gravity: 9.81
friction: {x: 0.2}
loads: [{link: 1, moment: 4}, {link: 1, point: B, force: 70, direction: 20}]
"""
TANGENT = """\
planes: 1
frame: {points: {O: [0, 0]}, guides: {y-y: {x: 0.3}}}
links:
  1: {points: {O: 0}, guides: {r: {through: O, angle: 0}}}
  2: {points: {B: 0, S2: 0.1}, slides: r, centre: S2, mass: 2}
  3: {points: {B: 0}, slides: y-y, mass: 1}
drive: {link: 1, phi: 30, omega: 10}
"""
OLDHAM = """\
planes: 1
frame: {points: {O: [0, 0], C: [0.05, 0]}}
links:
  1: {points: {O: 0}, guides: {a: {through: O, angle: 0}}}
  2: {points: {M: 0}, slides: a, guides: {b: {through: M, angle: 90}}, mass: 1}
  3: {points: {C: 0}, slides: b}
drive: {link: 1, phi: 40, omega: 10}
"""
SCENES: dict[str, str] = {
    "a driver of one point": TANGENT,
    "a driver of one point with a couple along its motion": TANGENT.replace("phi: 30, omega: 10", "phi: 0, epsilon: 3")
    + "loads: [{link: 1, moment: 4, against: motion}, {link: 2, moment: 3, along: motion}]\n",
    "a driver whose second point is its pivot but for rounding": TANGENT.replace(
        "1: {points: {O: 0}", "1: {points: {O: {r: 0.1, angle: 40}, X: [0.07660444431189781, 0.0642787609686539]}"
    ),
    "a coupling of two sliders": OLDHAM,
    "a slider of a slider of a driver of one point": """\
planes: 1
frame: {points: {O: [0.1, 0], W: [0.6, 0.3]}, guides: {y: {y: 0.4}}}
links:
  2: {points: {Q: 0.1, T: [0, 0.2]}, slides: {guide: r, angle: 30, offset: 0.05}, mass: 2, inertia: 1, centre: T,
      guides: {s: {through: [0.3, 0.1], angle: 70}}}
  3: {points: {H: 0, E: [0.1, 0.1]}, slides: y, mass: 1, centre: E}
  4: {points: {H: 0, P: 0.07}, slides: r, mass: 1, inertia: 2, centre: P}
  1: {points: {O: [0.02, 0.03]}, guides: {r: {through: [0.1, 0.1], angle: 20}}}
  6: {points: {K: 0, Z: [0.05, 0]}, slides: s, mass: 3, centre: Z}
  5: {points: {H: 0, K: 0.9}, mass: 1}
  7: {points: {Q: 0, W: 0.7}, mass: 1, centre: Q}
drive: {link: 1, phi: 65, omega: -4, epsilon: 7}
assembly: {K: ahead, Q: ahead}
gravity: 9.81
loads: [{link: 6, point: Z, force: 100, against: motion}, {link: 4, moment: 5, along: motion}]
""",
    "a crank alone": CRANK,
    "a load against the motion of a fixed point": CRANK.replace("direction: 20", "against: motion"),
    "a sliding driver alone": ALONE,
    "a sliding driver alone at rest": ALONE.replace("velocity: -2", "velocity: 0"),
    "two sliders on one moving guide": TWO_SLIDERS,
    "a guide marked as a point is named": TWO_SLIDERS.replace("mark: L", "mark: C"),
    "a guide marked as the pole": TWO_SLIDERS.replace("mark: L", "mark: p"),
    "a guide marked P": TWO_SLIDERS.replace("mark: L", "mark: P"),
    "a quick return with friction": """\
planes: 1
frame: {points: {A: [0, 0.3], D: [0, 0], E: [0.1,0.9]}, guides: {h: {y: 0.6}}}
links:
  1: {points: {A: 0, B: 0.1}}
  2: {points: {B: 0}, slides: rocker, mass: 1}
  3: {points: {D: 0, C: 0.6}, guides: {rocker: {through: D, angle: 0}}, mass: 3, inertia: 0.2, centre: C}
  4: {points: {C: 0, F: 0.3}, mass: 1}
  5: {points: {F: 0}, slides: h, mass: 5}
assembly: {rocker: ahead, F: ahead}
drive: {link: 1, phi: 0, omega: 10}
loads:
  - {link: 5, point: F, force: 500, against: motion}
  - {link: 3, moment: 3, along: motion}
  - {link: 3, point: D, force: 11, direction: 77}
  - {link: 1, point: A, force: 11, direction: {link: 3, angle: 3}}
gravity: 9.81
friction: {rocker: 0.1, h: 0.1}
""",
    "a guide on the driver, reversed": """\
planes: 1
frame: {points: {A: [0, 0], D: [0.5, 0.1]}}
links:
  1: {points: {A: 0, B: [0.1,0.02]}, guides: {g: {through: [0.05, 0.02], angle: 180}}, mass: 1, inertia: 1}
  2: {points: {E: 0, F: [0.1,0.1]}, slides: {guide: g, angle: 180, offset: 0.1}, mass: 1, inertia: 0.1}
  3: {points: {D: 0, E: 0.4}, mass: 2, inertia: 0.1}
assembly: {E: ahead}
drive: {link: 1, phi: 180, omega: 10, epsilon: -4}
gravity: 9.81
friction: {g: 0.2}
loads: [{link: 2, point: F, force: 100, against: motion}, {link: 2, moment: 3, against: motion}]
""",
    "the driver slides on a moving guide": """\
planes: 1
frame: {points: {A: [0, 0], D: [0.5, 0.1]}}
links:
  1: {points: {A: 0, B: [0.1,0.02]}, slides: {guide: g}, mass: 1, inertia: 1}
  2: {points: {E: 0, F: [0.1,0.1]}, guides: {g: {through: E, angle: 30}}, mass: 1, inertia: 0.1}
  3: {points: {D: 0, E: 0.4}, mass: 2, inertia: 0.1}
assembly: {E: ahead}
drive: {link: 1, phi: 10, omega: 10, epsilon: -4}
gravity: 9.81
friction: {g: 0.2}
loads: [{link: 2, point: F, force: 100, against: motion}, {link: 2, moment: 3, against: motion}]
""",
    "the output at its dead point": """\
planes: 1
frame: {points: {A: [0, 0]}, guides: {x: {y: 0}}}
links:
  1: {points: {A: 0, B: 0.1}}
  2: {points: {B: 0, C: 0.3}}
  3: {points: {C: 0}, slides: x}
assembly: {C: ahead}
drive: {link: 1, phi: 0, omega: 10}
""",
    "the mass centre at the pivot, named otherwise": """\
planes: 1
frame: {points: {A: [0, 0]}, guides: {x: {y: 0}}}
links:
  1: {points: {B: 0.1, A: 0, Z: 0}, centre: Z, mass: 3, inertia: 2}
  2: {points: {B: 0, C: 0.3}}
  3: {points: {C: 0}, slides: x}
assembly: {C: ahead}
drive: {link: 1, phi: 37, omega: 10}
""",
    "a slider hinged on the guide through a hinge": """\
planes: 1
frame: {points: {A: [0, 0], D: [0.1, 0]}}
links:
  1: {points: {A: 0, B: 0.1}}
  2: {points: {B: 0}, slides: g}
  3: {points: {D: 0}, guides: {g: {through: D, angle: 0}}}
assembly: {g: ahead}
drive: {link: 1, phi: 20, omega: 10}
""",
    "a crank of one point": CRANK,
    "a crank of one point at rest": CRANK.replace("omega: 5", "omega: 0"),
    "a crank of one point, loaded against its motion": CRANK.replace("direction: 20", "against: motion"),
    "a crank of no length": """\
planes: 1
frame: {points: {A: [0, 0]}, guides: {x: {y: 0}}}
links:
  1: {points: {A: 0, B: 0}, mass: 1}
  2: {points: {B: 0, C: 0.4}, mass: 1}
  3: {points: {C: 0}, slides: x, mass: 2}
assembly: {C: ahead}
drive: {link: 1, phi: 0, omega: 10}
loads: [{link: 3, point: C, force: 10, direction: 0}]
""",
}


@pytest.mark.parametrize("scene", SCENES.values(), ids=SCENES.keys())
def test_a_corner_of_the_method(scene: str) -> None:
    drawn, wrong = checked(scene)
    for name, error in wrong.items():
        assert error * drawn.sharpest <= 1e-12, (name, error)


def test_sliders_on_a_driver_of_one_point_in_closed_form() -> None:
    d = draw(TANGENT)
    phi, w, x = math.radians(30), 10.0, 0.3
    u, r = cmath.rect(1.0, phi), x / math.cos(phi)
    dr, ddr = w * r * math.tan(phi), w**2 * r * (1 / math.cos(phi) ** 2 + math.tan(phi) ** 2)
    v, a = (dr + 1j * w * (r + 0.1)) * u, (ddr - w**2 * (r + 0.1) + 2j * w * dr) * u
    assert (
        abs(d.place(VELOCITY_PLAN.mark("s2")) - v) < 1e-13 and abs(d.place(ACCELERATION_PLAN.mark("s2'")) - a) < 1e-12
    )
    v3, a3 = ((dr + 1j * w * r) * u).imag, ((ddr - w**2 * r + 2j * w * dr) * u).imag
    push = (2 * a.imag + a3) / math.cos(phi)
    reaction = d.plans.reactions["F_21"]
    assert abs(d.vector(reaction.start, reaction.end) - 1j * push * u) < 1e-11
    power = 2 * (v.conjugate() * a).real + v3 * a3
    assert d.number(d.plans.balancing) == pytest.approx(power / w, rel=1e-13)
    assert d.number(d.plans.zhukovsky) == pytest.approx(power / w, rel=1e-13)
    d = draw(OLDHAM)  # the middle link's point runs round the circle on the two shafts, twice as fast
    m = d.place(scheme_mark("M"))
    assert abs(d.place(VELOCITY_PLAN.mark("m")) - 20j * (m - 0.025)) < 1e-14
    assert abs(d.place(ACCELERATION_PLAN.mark("m'")) + 400 * (m - 0.025)) < 1e-13


@pytest.mark.parametrize("angle, turned", [(180, 180), (-180, 180), (540, -180), (90, -270), (0, 360)])
def test_guides_turned_by_half_and_whole_turns(angle: float, turned: float) -> None:
    text = (
        SLIDER.replace("x-x: {y: 0}", f"x-x: {{through: A, angle: {angle}}}")
        .replace("slides: x-x", f"slides: {{guide: x-x, angle: {turned}}}")
        .replace("C: ahead", "C: {near: [0.3, 0.1]}")
    )
    drawn, wrong = checked(text + "loads: [{link: 3, point: C, force: 70, against: motion}]\n")
    assert max(wrong.values()) * drawn.sharpest < 1e-12


@pytest.mark.parametrize("value", [0.0, 90.0, 180.0, -90.0, 1e-7, 179.9999999, 45.0])
@pytest.mark.parametrize("text", [FOUR_BAR, SLIDER.replace("y: 0}", "y: 0.02}"), ROCKER], ids=["RRR", "RRP", "RPR"])
def test_round_positions(text: str, value: float) -> None:
    drawn, wrong = checked(text + "gravity: 9.81\n", value)
    assert max(wrong.values()) * drawn.sharpest < 1e-11


def test_two_points_at_one_place_are_drawn_alike() -> None:
    for seed in range(25):
        rng = random.Random(seed)
        case = make(rng, rng.choices(KINDS, k=2), friction=True)
        scene: dict[str, Any] = json.loads(json.dumps(case.scene))
        for name, link in scene["links"].items():
            points = list(link["points"].items())
            place = rng.choice(points)[1]
            points.insert(rng.randint(1, len(points)), (f"Z{name}", place))
            link |= {"points": dict(points), "centre": f"Z{name}"}
        results = solve(loads(to_yaml(scene))).positions[0].results
        for name, link in scene["links"].items():
            twins = [p for p, z in link["points"].items() if z == link["points"][f"Z{name}"]]
            for key in "rva":
                values = [complex(*results["points"][p][key]) for p in twins]
                assert max(abs(v - values[0]) for v in values) <= 1e-11 * max(
                    abs(complex(*p[key])) for p in results["points"].values()
                )


def test_a_point_cannot_be_the_pole() -> None:
    with pytest.raises(SceneError) as caught:
        loads(FOUR_BAR.replace("B: 0", "p: 0"))
    assert str(caught.value).startswith("scene.yaml:4: ") and " p, which is the pole" in str(caught.value)


@pytest.mark.parametrize(
    "name", ["r_C", "omega_1", "phi_2", "phi_1", "epsilon_1", "v_A", "r_A", "a_slide_3", "M_1", "F_32"]
)
def test_whatever_is_asked_alone_is_answered(name: str) -> None:
    results = solve(loads(SLIDER + f"find: [{name}]\n")).positions[0].results
    whole = solve(loads(SLIDER)).positions[0].results
    asked = {k: v for k, v in results.items() if k in ("points", "links", "slides", "reactions", "balancing_moment")}
    assert asked
    for key, found in asked.items():
        for one, values in found.items() if isinstance(found, dict) else ():
            for part, value in values.items() if isinstance(values, dict) else ():
                assert value == whole[key][one][part]


def test_only_forces_are_reactions() -> None:
    """Also the parts that are calculated without a segment of their own; arms and cosines have such names, too."""
    known = quantities_by_name(plans_and_requested_results(load(ROOT / "samples" / "class-four" / "press.yaml"))[0])
    parts = {n: q for n, q in known.items() if "^" in n and q.group == "reactions"}
    assert parts and all(n.startswith("F_") and q.column_to_write.unit == "N" for n, q in parts.items())


@pytest.mark.slow
def test_every_name_that_may_be_asked_gives_something() -> None:
    scene = TWO_SLIDERS
    plans, _ = plans_and_requested_results(loads(scene))
    for name in quantities_by_name(plans):
        results = solve(loads(scene + f"find: [{json.dumps(name, ensure_ascii=False)}]\n")).positions[0].results
        assert set(results) - {"phi_deg", "warnings"}, name


@pytest.mark.slow
def test_a_pencil_draws_whatever_can_be_drawn_with_friction() -> None:
    for seed in range(25):
        rng = random.Random(seed)
        case = make(rng, rng.choices(KINDS, k=2), friction=True)
        solved = solve(loads(to_yaml(case.scene)), None, Pencil(seed=seed))
        assert solved.positions, solved.failed
        json.dumps(solved.json(), allow_nan=False)
