"""The independent check on its own: residuals, differences, power, closed forms, a worked example."""

from __future__ import annotations

import cmath
import math
import random
from collections import Counter
from collections.abc import Iterator
from typing import Any

import pytest
import yaml
from hypothesis import HealthCheck, given, settings

from tests.helpers.mechanisms import KINDS, Case, make, mechanisms, to_yaml
from tests.helpers.oracle import Solution, follow, power_balance, reaction_key, solve, unbalanced

SIX_LINK: dict[str, Any] = {
    "frame": {"points": {"A": [0, 0], "D": [-0.35, -0.27]}, "guides": {"y-y": {"x": -0.42}}},
    "links": {
        "1": {"points": {"A": 0, "B": 0.1}, "mass": 60, "inertia": 5},
        "2": {
            "points": {"B": 0, "C": 0.3, "S2": 0.2},
            "guides": {"CL": {"through": "C", "angle": -90}},
            "centre": "S2",
            "mass": 40,
            "inertia": 2,
        },
        "3": {"points": {"D": 0, "C": 0.15}, "mass": 70, "inertia": 0.5},
        "4": {"points": {"H": 0}, "slides": "CL"},
        "5": {"points": {"H": 0}, "slides": "y-y", "mass": 50},
    },
    "assembly": {"C": "right"},
    "drive": {"link": "1", "phi": 150, "omega": -20, "epsilon": 80},
    "loads": [{"link": "5", "point": "H", "force": 6000, "against": "motion"}],
    "gravity": 9.81,
}
SIX_GUESS = {
    "1": (0.0, 0.0, math.radians(150)),
    "2": (-0.087, 0.05, math.radians(-145)),
    "3": (-0.35, -0.27, math.radians(83)),
    "4": (-0.42, 0.0, math.radians(125)),
    "5": (-0.42, 0.0, math.radians(90)),
}


def cases(count: int, **options: Any) -> Iterator[Case]:
    """Seeded mechanisms: every chain of one, then random chains of two and three."""
    for seed in range(count):
        rng = random.Random(seed)
        length = 1 if seed < len(KINDS) else rng.randint(1, 3)
        kinds = [KINDS[seed]] if length == 1 and seed < len(KINDS) else rng.choices(KINDS, k=length)
        yield make(rng, kinds, **options)


def near(found: complex, expected: complex, scale: float = 1.0, tolerance: float = 1e-12) -> bool:
    return abs(found - expected) <= tolerance * scale


@pytest.mark.parametrize("size", [1.0, 1e-6, 1e6])
def test_the_pose_chosen_first_is_found(size: float) -> None:
    for case in cases(30, size=size, ill=1e-3):
        sol = case.solution
        assert sol.residual < 1e-13
        for name, (x, y, turn) in case.guess.items():
            error = max(
                abs(sol.pose[name][0] - x) / size, abs(sol.pose[name][1] - y) / size, abs(sol.pose[name][2] - turn)
            )
            assert error < 4e-15 * sol.condition, (name, error, sol.condition)


def test_newton_comes_back_from_a_disturbed_guess() -> None:
    for case in cases(30, limit=100):
        off = {n: (x + 1e-3, y - 1e-3, t + 1e-3) for n, (x, y, t) in case.guess.items()}
        sol = solve(case.scene, off)
        assert all(near(sol.points[k][0], r, 1.0, 1e-11) for k, (r, _, _) in case.solution.points.items())


def moved(case: Case, by: float, *, unit: bool = False) -> Solution:
    """The case with its drive moved by `by` (rad, or m); `unit`: at rate 1 without acceleration."""
    drive = dict(case.scene["drive"])
    if "phi" in drive:
        drive["phi"] += math.degrees(by)
        drive |= {"omega": 1.0, "epsilon": 0.0} if unit else {}
    else:
        drive["s"] += by
        drive |= {"velocity": 1.0, "acceleration": 0.0} if unit else {}
    return solve({**case.scene, "drive": drive}, case.guess)


def test_velocities_and_accelerations_against_differences() -> None:
    h = 1e-5
    for case in cases(40, limit=200, loads=False):
        back, here, on = (moved(case, k * h, unit=True) for k in (-1, 0, 1))
        fast = max(abs(v) for _, v, _ in here.points.values())
        hard = max(abs(a) for _, _, a in here.points.values()) + fast**2
        for k, (_, v, a) in here.points.items():
            assert near((on.points[k][0] - back.points[k][0]) / (2 * h), v, fast, 1e-6)
            assert near((on.points[k][1] - back.points[k][1]) / (2 * h), a, hard, 1e-6)
        spin = max(abs(w) for _, w, _ in here.links.values()) + fast
        for n, (_, omega, eps) in here.links.items():
            assert near((on.pose[n][2] - back.pose[n][2]) / (2 * h), omega, spin, 1e-6)
            assert near((on.links[n][1] - back.links[n][1]) / (2 * h), eps, spin + hard, 1e-6)
        for n, (v, a, _) in here.slides.items():
            _, _, u = here.guides[n]
            assert near((on.slides[n][0] - back.slides[n][0]) / (2 * h), a, hard + fast * spin, 1e-6)
            along = [(sol.feet[n] - here.feet[n]) * u.conjugate() for sol in (back, on)]
            if here.guides[n][1] == "0":
                assert near((along[1] - along[0]) / (2 * h), v, fast, 1e-6)


def test_relative_acceleration_of_a_slider_is_made_of_three_parts() -> None:
    """a_slider = a of the guide's coincident point + a_r u + Coriolis, with no help from the constraints."""
    for case in cases(30, limit=1e4):
        sol = case.solution
        first = {n: next(iter(link["points"])) for n, link in case.scene["links"].items()}
        for n, (_, a, coriolis) in sol.slides.items():
            _, owner, u = sol.guides[n]
            r, _, found = sol.points[first[n]]
            carried = 0j
            if owner != "0":
                r0, _, a0 = sol.points[first[owner]]
                _, omega, eps = sol.links[owner]
                carried = a0 + (1j * eps - omega**2) * (r - r0)
            terms = [carried, a * u, coriolis]
            assert near(sum(terms), found, max(map(abs, [found, *terms])), 1e-10)


@settings(max_examples=60, suppress_health_check=list(HealthCheck))
@given(mechanisms(limit=1e5))
def test_power_and_equilibrium(case: Case) -> None:
    total, largest = power_balance(case.solution)
    assert abs(total) <= 1e-10 * largest
    assert unbalanced(case.solution) < 1e-10


@pytest.mark.parametrize(
    "options",
    [
        {"friction": True},
        {"rest": True},
        {"size": 1e-6},
        {"size": 1e6},
        {"sliding": True, "friction": True},
        {"ill": 1e-3},
    ],
)
def test_power_and_equilibrium_in_special_cases(options: dict[str, Any]) -> None:
    for case in cases(25, limit=1e5, **options):
        total, largest = power_balance(case.solution)
        assert abs(total) <= 1e-10 * largest
        assert unbalanced(case.solution) < 1e-10


def test_friction_lies_against_the_sliding() -> None:
    seen = 0
    for case in cases(25, friction=True, limit=1e5):
        for n, speed in case.solution.speeds.items():
            guide, owner, u = case.solution.guides[n]
            reaction = case.solution.reactions[n, owner]
            assert isinstance(reaction, tuple)
            part = reaction[0] * u.conjugate()
            f = case.scene["friction"].get(guide, 0.0)
            assert near(part.real, -f * abs(part.imag) * math.copysign(1, speed), abs(part), 1e-9)
            seen += f > 0
    assert seen > 20


def test_slider_crank_in_closed_form() -> None:
    r, rod, e, phi, omega, eps, f = 0.1, 0.35, 0.04, 50.0, 12.0, -30.0, 0.1
    scene: dict[str, Any] = {
        "frame": {"points": {"O": 0}, "guides": {"x-x": {"y": 0}}},
        "links": {
            "1": {"points": {"O": 0, "A": r}},
            "2": {"points": {"A": 0, "B": rod}},
            "3": {"points": {"B": 0}, "slides": {"guide": "x-x", "offset": e}, "mass": 2},
        },
        "drive": {"link": "1", "phi": phi, "omega": omega, "epsilon": eps},
        "loads": [{"link": "3", "point": "B", "force": 1000, "against": "motion"}],
        "friction": {"x-x": f},
    }
    t = math.radians(phi)
    y = e - r * math.sin(t)
    c = math.sqrt(rod**2 - y**2)
    y1, y2 = -r * math.cos(t), r * math.sin(t)
    x = r * math.cos(t) + c
    x1 = -r * math.sin(t) - y * y1 / c
    x2 = -r * math.cos(t) - (y1**2 + y * y2) / c - (y * y1) ** 2 / c**3
    sol = solve(scene, {"1": (0, 0, t), "2": (0.07, 0.07, 0), "3": (0.4, e, 0)})
    place, v, a = sol.points["B"]
    assert near(place, complex(x, e)) and near(v, x1 * omega) and near(a, x2 * omega**2 + x1 * eps, 10)
    assert x1 < 0 and sol.slides["3"][0] == pytest.approx(x1 * omega, rel=1e-12)
    # the rod pushes the slider with S along (c, y) / rod; friction f |S y / rod| points to +x
    push = 1000.0 - 2 * a.real
    s = -push / (c / rod - f * abs(y) / rod)
    force, arm, moment = sol.reactions["3", "0"]  # type: ignore[misc]
    assert near(force, complex(f * abs(s * y / rod), -s * y / rod), abs(s))
    # the rod and the load meet at B, e above the foot, and leave -T there: the couple holds it
    assert arm is not None and near(arm, -e * force.real / force.imag) and near(moment, arm * force.imag)
    crank = ((cmath.rect(r, t)).conjugate() * complex(c, y) / rod).imag
    assert near(sol.balancing, s * crank, abs(s))
    assert abs(power_balance(sol)[0]) < 1e-9


def test_sliders_on_a_driver_of_one_point_in_closed_form() -> None:
    phi, w, x = math.radians(30), 10.0, 0.3
    scene: dict[str, Any] = {
        "frame": {"points": {"O": 0}, "guides": {"y": {"x": x}}},
        "links": {
            "1": {"points": {"O": 0}, "guides": {"r": {"through": "O", "angle": 0}}},
            "2": {"points": {"B": 0, "S": 0.1}, "slides": "r", "centre": "S", "mass": 2},
            "3": {"points": {"B": 0}, "slides": "y", "mass": 1},
        },
        "drive": {"link": "1", "phi": 30, "omega": w},
    }
    r, tan = x / math.cos(phi), math.tan(phi)
    b = complex(x, x * tan)
    sol = solve(scene, {"1": (0, 0, phi), "2": (b.real, b.imag, phi), "3": (b.real, b.imag, math.pi / 2)})
    u, dr, ddr = cmath.rect(1.0, phi), w * r * tan, w * w * r * (1 / math.cos(phi) ** 2 + tan**2)
    v, a = (dr + 1j * w * (r + 0.1)) * u, (ddr - w**2 * (r + 0.1) + 2j * w * dr) * u
    assert near(sol.points["S"][1], v) and near(sol.points["S"][2], a, 100)
    v3, a3 = w * x / math.cos(phi) ** 2, 2 * w * w * x * tan / math.cos(phi) ** 2
    assert near(sol.points["B"][1], 1j * v3) and near(sol.points["B"][2], 1j * a3, 100)
    moment = (2 * (v.conjugate() * a).real + v3 * a3) / w
    assert near(sol.balancing, moment, 100) and round(moment, 2) == 59.43
    push = sol.reactions["2", "1"]
    assert isinstance(push, tuple) and near(push[0], 1j * u * (2 * a.imag + a3) / math.cos(phi), 100)
    frame = {"points": {"O": 0, "C": 0.05}}
    links = {
        "1": {"points": {"O": 0}, "guides": {"a": {"through": "O", "angle": 0}}},
        "2": {"points": {"M": 0}, "slides": "a", "guides": {"b": {"through": "M", "angle": 90}}},
        "3": {"points": {"C": 0}, "slides": "b"},
    }
    phi, m = math.radians(40), 0.05 * math.cos(math.radians(40)) * cmath.rect(1.0, math.radians(40))
    pose = {"1": (0, 0, phi), "2": (m.real, m.imag, phi), "3": (0.05, 0, phi + math.pi / 2)}
    sol = solve({"frame": frame, "links": links, "drive": {"link": "1", "phi": 40, "omega": w}}, pose)
    assert near(sol.points["M"][1], 2j * w * (m - 0.025)) and near(sol.points["M"][2], -4 * w * w * (m - 0.025), 10)


def test_six_link_worked_example() -> None:
    sol = solve(SIX_LINK, SIX_GUESS)
    assert sol.groups == [("2", "3"), ("4", "5")] and sol.residual < 1e-14
    expected = {
        "B": (1.0 + 1.7320508075688772j, 30.641016151377546 - 26.92820323027551j),
        "C": (2.3885508115275518 - 0.27035698611185915j, 68.29711273634746 - 46.49822710940136j),
        "S2": (1.9257005410183676 + 0.3971122784483863j, 55.74508054135749 - 39.97488581635941j),
        "H": (1.0011519662761537j, -50.07332690697975j),
    }
    for name, (v, a) in expected.items():
        assert near(sol.points[name][1], v, 2) and near(sol.points[name][2], a, 80), name
    assert near(sol.points["C"][0], -0.3331294197700706 - 0.12095174096050126j)
    rates = {"2": (8.122472480981513, 125.13235761686562), "3": (-16.025351969354908, -487.2896809678043)}
    for name, pair in rates.items():
        assert sol.links[name][1:] == pytest.approx(pair, rel=1e-12)
    v, a, coriolis = sol.slides["4"]
    assert near(coriolis, -32.118089427169615 - 22.27198639535533j, 40)
    assert abs(v) == pytest.approx(2.4059601791799547) and abs(a) == pytest.approx(46.038167003819595)
    forces = {
        ("4", "2"): 5749.35156560775 + 3986.8336546510122j,
        ("5", "0"): -5749.35156560775,
        ("2", "1"): 9571.753638401578 + 2408.540610664644j,
        ("3", "0"): -1592.5988511395296 + 1058.3976113319916j,
        ("1", "0"): 9571.753638401578 + 2997.140610664644j,
    }
    for pair2, force in forces.items():
        found = sol.reactions[pair2]
        assert near(found[0] if isinstance(found, tuple) else found, force, 1e4), pair2
    assert abs(sol.reactions["3", "2"]) == pytest.approx(1635.399099584214)  # type: ignore[arg-type]
    assert sol.balancing == pytest.approx(-287.17341740828566, rel=1e-12)
    assert near(sol.reactions["4", "2"][2], 0.0, 1e4) and set(sol.reactions) == {  # type: ignore[index]
        *forces,
        ("3", "2"),
        ("5", "4"),
    }
    total, largest = power_balance(sol)
    assert abs(total) < 1e-12 * largest and unbalanced(sol) < 1e-12
    assert reaction_key("2", "1") == "F_21" and reaction_key("11", "10") == "F_11_10"


def test_a_full_turn_by_continuation_comes_back() -> None:
    scene = {
        "frame": {"points": {"A": 0, "D": [0.3, 0]}},
        "links": {
            "1": {"points": {"A": 0, "B": 0.1}},
            "2": {"points": {"B": 0, "C": 0.3}},
            "3": {"points": {"D": 0, "C": 0.25}},
        },
        "drive": {"link": "1", "phi": 20, "omega": 1},
    }
    start = solve(scene, {"1": (0, 0, 0.35), "2": (0.09, 0.03, 0.6), "3": (0.3, 0, 1.5)})
    end = follow(scene, start.pose, 380.0)
    assert start.points["C"][0].imag > 0 and near(end.points["C"][0], start.points["C"][0])
    half = follow(scene, start.pose, 200.0)
    assert abs(half.points["C"][0] - start.points["C"][0]) > 0.01


def test_side_words_say_what_the_pose_shows() -> None:
    seen: Counter[str] = Counter()
    for case in cases(60, assembly="side"):
        sol, links = case.solution, case.scene["links"]
        for key, word in case.scene["assembly"].items():
            if isinstance(word, dict):  # never asked for here
                raise AssertionError(key)
            on = [n for n in sol.guides if sol.guides[n][0] == key]
            group = next(
                g
                for g in sol.groups
                if (on and on[0] in g and sol.guides[on[0]][1] in g) or all(key in links[n]["points"] for n in g)
            )
            ends = {i: r for (i, j), r in sol.hinges.items() if i in group and j not in group}
            if on:
                _, owner, u = sol.guides[on[0]]
                expected = "ahead" if ((ends[on[0]] - ends[owner]) * u.conjugate()).real > 0 else "behind"
            elif len(ends) == 2:
                a, c, b = ends[group[0]], ends[group[1]], sol.points[key][0]
                expected = "left" if ((c - a).conjugate() * (b - a)).imag > 0 else "right"
            else:
                earlier = {"0", case.scene["drive"]["link"]}
                earlier |= {n for g in sol.groups[: sol.groups.index(group)] for n in g}
                u = next(
                    u for n, (_, owner, u) in sol.guides.items() if {n, owner} & set(group) and {n, owner} & earlier
                )
                (a,), b = ends.values(), sol.points[key][0]
                expected = "ahead" if ((b - a) * u.conjugate()).real > 0 else "behind"
            assert word == expected, (key, case.groups)
            seen[("RPR " if on else "") + word] += 1
    assert len(seen) == 6, seen


def plain(value: Any) -> Any:
    """A value as the YAML base loader gives it: text throughout."""
    if isinstance(value, dict):
        return {str(k): plain(v) for k, v in value.items()}
    return [plain(v) for v in value] if isinstance(value, list) else value if isinstance(value, str) else repr(value)


@pytest.mark.slow
def test_scene_files_and_the_spread_of_what_is_drawn() -> None:
    seen: Counter[str] = Counter()
    for case in cases(60):
        text = to_yaml(case.scene)
        assert yaml.load(text, Loader=yaml.BaseLoader) == plain(case.scene)
        marks = [
            "{x:",
            "{y:",
            "through: [",
            "offset:",
            "near:",
            "left",
            "ahead",
            "{r:",
            "along:",
            "against:",
            "direction: {",
            "moment:",
            "phi:",
            "s:",
            "slides: g",
            "slides: {",
            "centre:",
        ]
        seen.update(mark for mark in marks if mark in text)
        loaded = {load["link"] for load in case.scene["loads"]}
        assert loaded == set(case.scene["links"])
        pairs = [i for i, _ in case.solution.reactions] + [j for _, j in case.solution.reactions]
        seen.update(["multiple hinge"] * (len(case.solution.hinges) > len({*case.solution.hinges.values()})))
        seen.update(["guide on a link"] * any(j != "0" for _, j, _ in case.solution.guides.values()))
        assert len(pairs) == 2 * (3 * len(case.scene["links"]) - 1) / 2
    assert min(seen.values()) >= 3 and len(seen) == 19, seen
