"""What must not change the answers: turning, mirroring, rescaling, other μ, other numbers and order of links."""

from __future__ import annotations

import cmath
import copy
import random
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tests.helpers.comparing import Drawn, Number, closing_mm, differences, draw, numbers, standing
from tests.helpers.mechanisms import Case, mechanisms
from tests.helpers.oracle_pins import place

FEW = settings(max_examples=40)
CASES = mechanisms(most=3)
RUBBED = mechanisms(most=3, friction=True)


def same(one: Mapping[str, Number], two: Drawn, tolerance: float = 1e-10) -> None:
    """The second drawing has the numbers of the first."""
    for name, error in differences(two, one).items():
        assert error * two.sharpest <= tolerance, (name, error, two.sharpest)


def named(d: Drawn) -> dict[str, Number]:
    return {n.name: n for n in numbers(d)}


def scaled(n: Number, factor: complex) -> Number:
    return replace(n, value=n.value * factor)


def each_force(scene: dict[str, Any], change: Any) -> None:
    for load in scene["loads"]:
        change(load)


@pytest.mark.slow
@FEW
@given(RUBBED, st.floats(-180, 180))
def test_turned_by_any_angle(case: Case, angle: float) -> None:
    """The frame, gravity aside, turned about the origin: vectors turn, scalars stay."""
    assume(not standing(case))
    scene, turn = copy.deepcopy(case.scene), cmath.rect(1.0, cmath.pi * angle / 180)
    scene["gravity"] = 0
    base = draw(scene)
    frame = scene["frame"]
    for name, z in frame.get("points", {}).items():
        w = place(z) * turn
        frame["points"][name] = [w.real, w.imag]
    for spec in frame.get("guides", {}).values():
        if "through" not in spec:
            z, own = (complex(spec.pop("x")), 90) if "x" in spec else (1j * spec.pop("y"), 0)
            spec |= {"through": [z.real, z.imag], "angle": own}
        if not isinstance(spec["through"], str):
            w = place(spec["through"]) * turn
            spec["through"] = [w.real, w.imag]
        spec["angle"] = spec.get("angle", 0) + angle
    if "phi" in scene["drive"]:
        scene["drive"]["phi"] += angle
    for spec in scene["assembly"].values():
        if isinstance(spec, dict):
            w = place(spec["near"]) * turn
            spec["near"] = [w.real, w.imag]
    for load in scene["loads"]:
        if isinstance(load.get("direction"), float):
            load["direction"] += angle
    want = {}
    for n in named(base).values():
        vector = n.sort in ("r", "v", "a", "force") and (n.name[:2] in ("r_", "v_", "a_", "F_") or "cor" in n.name)
        want[n.name] = scaled(n, turn) if vector else replace(n, value=n.value + angle * (n.sort == "angle"))
    same(want, draw(scene))


def shifted(place_of: dict[str, Any], guides: dict[str, dict[str, Any]], by: complex) -> None:
    """Points and guides moved within the axes they are given in."""
    for name, z in place_of.items():
        w = place(z) + by
        place_of[name] = [w.real, w.imag]
    for spec in guides.values():
        if "through" not in spec:
            z, own = (complex(spec.pop("x")), 90) if "x" in spec else (1j * spec.pop("y"), 0)
            spec |= {"through": [z.real, z.imag], "angle": own}
        if not isinstance(spec["through"], str):
            w = place(spec["through"]) + by
            spec["through"] = [w.real, w.imag]


@FEW
@given(RUBBED, st.integers(0, 99))
def test_moved_far_aside_with_other_own_axes(case: Case, seed: int) -> None:
    """Where the frame lies, and where a link's own axes begin, is nobody's affair: all but the places stays."""
    assume(not standing(case))
    scene, rng, far = copy.deepcopy(case.scene), random.Random(seed), 12 - 7j
    shifted(scene["frame"].get("points", {}), scene["frame"].get("guides", {}), far)
    for link in scene["links"].values():
        shifted(link["points"], link.get("guides", {}), complex(rng.uniform(-1, 1), rng.uniform(-1, 1)))
    for spec in scene["assembly"].values():
        if isinstance(spec, dict):
            w = place(spec["near"]) + far
            spec["near"] = [w.real, w.imag]
    base = named(draw(case.scene))
    same({n: replace(x, value=x.value + far) if x.sort == "r" else x for n, x in base.items()}, draw(scene), 1e-9)


def mirror(z: Any) -> Any:
    w = place(z).conjugate()
    return [w.real, w.imag]


@pytest.mark.slow
@FEW
@given(RUBBED)
def test_mirrored_in_the_x_axis(case: Case) -> None:
    """x stays, y, angles, senses and couples change their signs."""
    assume(not standing(case))
    scene = copy.deepcopy(case.scene)
    scene["gravity"] = 0
    base = draw(scene)
    for body in (scene["frame"], *scene["links"].values()):
        for name, z in body.get("points", {}).items():
            body["points"][name] = mirror(z)
        for name, spec in body.get("guides", {}).items():
            if "x" in spec:  # (c, 0) towards +y becomes towards -y
                body["guides"][name] = {"through": [spec["x"], 0], "angle": -90}
            elif "y" in spec:
                spec["y"] = -spec["y"]
            else:
                spec["angle"] = -spec.get("angle", 0)
                spec["through"] = spec["through"] if isinstance(spec["through"], str) else mirror(spec["through"])
        if isinstance(body.get("slides"), dict):
            body["slides"] |= {k: -body["slides"][k] for k in ("angle", "offset") if k in body["slides"]}
    drive = scene["drive"]
    drive |= {k: -drive[k] for k in ("phi", "omega", "epsilon") if k in drive}
    swap = {"left": "right", "right": "left"}
    for name, said in scene["assembly"].items():
        scene["assembly"][name] = {"near": mirror(said["near"])} if isinstance(said, dict) else swap.get(said, said)
    for load in scene["loads"]:
        if "moment" in load and not {"along", "against"} & set(load):
            load["moment"] = -load["moment"]
        to = load.get("direction")
        if isinstance(to, dict):
            to["angle"] = -to["angle"]
        elif to is not None:
            load["direction"] = -to
    want = {}
    for n in named(base).values():
        if n.sort in ("omega", "epsilon", "angle", "moment"):
            want[n.name] = scaled(n, -1)
        elif n.sort == "arm":
            want[n.name] = n
        else:
            want[n.name] = replace(n, value=complex(n.value).conjugate())
    if drive["link"] and "phi" not in drive:
        for name in ("balancing", "zhukovsky"):
            want[name] = named(base)[name]
    same(want, draw(scene))


@pytest.mark.slow
@FEW
@given(RUBBED, st.sampled_from([1e-6, 1e-3, 0.37, 1e3, 1e6]), st.sampled_from([1e-3, 1.0, 1e4]))
def test_lengths_and_forces_rescaled(case: Case, k: float, f: float) -> None:
    """Lengths × k, forces × f (masses × f/k, inertia × f·k, gravity × k): every number by its dimension."""
    assume(not standing(case))
    base, scene = draw(case.scene), copy.deepcopy(case.scene)

    def longer(z: Any) -> Any:
        return {**z, "r": z["r"] * k} if isinstance(z, dict) else [x * k for x in z] if isinstance(z, list) else z * k

    for body in (scene["frame"], *scene["links"].values()):
        body["points"] = {name: longer(z) for name, z in body.get("points", {}).items()}
        for spec in body.get("guides", {}).values():
            spec |= {key: spec[key] * k for key in ("x", "y") if key in spec}
            if not isinstance(spec.get("through", ""), str):
                spec["through"] = longer(spec["through"])
        if isinstance(body.get("slides"), dict) and "offset" in body["slides"]:
            body["slides"]["offset"] *= k
        body |= {key: body[key] * f * by for key, by in (("mass", 1 / k), ("inertia", k)) if key in body}
    scene["drive"] |= {
        key: scene["drive"][key] * k for key in ("s", "velocity", "acceleration") if key in scene["drive"]
    }
    for name, said in scene["assembly"].items():
        scene["assembly"][name] = {"near": longer(said["near"])} if isinstance(said, dict) else said
    scene["gravity"] *= k
    for load in scene["loads"]:
        load |= {key: load[key] * by for key, by in (("force", f), ("moment", f * k)) if key in load}
    by = {"r": k, "v": k, "a": k, "arm": k, "force": f, "moment": f * k}
    same({n.name: scaled(n, by.get(n.sort, 1.0)) for n in named(base).values()}, draw(scene))


@pytest.mark.slow
@FEW
@given(RUBBED, st.floats(-3, 3))
def test_another_scale_of_the_drawing(case: Case, power: float) -> None:
    """μ is a matter of paper: the numbers stay, the millimetres grow, and the polygons still close."""
    assume(not standing(case))
    base = draw(case.scene)
    mu = {name: mu * 10 ** (power + i % 3) for i, (name, mu) in enumerate(base.mu.items())}
    mu["mu_lever"] = mu["mu_motion" if base.plans.at_rest else "mu_velocity"]  # the lever is that plan, turned
    other = draw(case.scene, mu=mu)
    same(named(base), other)
    largest = max(abs(other.drawing[s.makes]) for s in other.plans.program.steps if s.kind == "mark")
    assert closing_mm(other) <= 1e-14 * max(1.0, largest)


@pytest.mark.slow
@FEW
@given(CASES, st.integers(0, 10**6))
def test_links_reordered(case: Case, seed: int) -> None:
    """The file's order only decides whose assembly is left: with ``near`` nothing changes at all."""
    scene = copy.deepcopy(case.scene)
    solution = case.solution
    for key in scene["assembly"]:
        if key in solution.points:
            r = solution.points[key][0]
            scene["assembly"][key] = {"near": [r.real, r.imag]}
    base = draw(scene)
    names = list(scene["links"])
    random.Random(seed).shuffle(names)
    scene["links"] = {n: scene["links"][n] for n in names}
    other = draw(scene)
    keys = set(base.plans.reactions) ^ set(other.plans.reactions)
    if keys:  # the order decides which of two hinges at one place is whose: other pairs, other names
        shared = [p for p in base.plans.points if sum(p in x["points"] for x in scene["links"].values()) > 1]
        assert shared
    found, want = named(other), named(base)
    together = {n: want[n] for n in want if n in found and want[n].sort not in ("force", "moment", "arm")}
    scale = {s: max([abs(n.value) for n in want.values() if n.sort == s], default=1.0) or 1.0 for s in "rva"}
    for name, n in together.items():
        if n.sort in scale:
            assert abs(found[name].value - n.value) <= 1e-10 * scale[n.sort] / other.sharpest
    if not keys:
        same(want, other)
    else:
        largest = max(abs(n.value) for n in want.values() if n.sort == want["balancing"].sort) or 1.0
        assert abs(found["balancing"].value - want["balancing"].value) <= 1e-9 * largest / other.sharpest


@pytest.mark.slow
@FEW
@given(RUBBED, st.sampled_from(["{}", "L{}", "{}0", "{}_1", "z_{}"]))
def test_links_renumbered(case: Case, form: str) -> None:
    """Names of links are only names, whatever their letters and length."""
    assume(not standing(case))
    base = draw(case.scene)
    to = {n: form.format(n) for n in case.scene["links"]}
    scene = copy.deepcopy(case.scene)
    scene["links"] = {to[n]: link for n, link in scene["links"].items()}
    scene["drive"]["link"] = to[scene["drive"]["link"]]
    for load in scene["loads"]:
        load["link"] = to[load["link"]]
        if isinstance(load.get("direction"), dict):
            load["direction"]["link"] = to[load["direction"]["link"]]
    other = draw(scene)
    assert len(base.plans.reactions) == len(other.plans.reactions)
    worst = max(abs(base.vector(a.start, a.end)) for a in base.plans.reactions.values()) or 1.0
    for a, b in zip(base.plans.reactions.values(), other.plans.reactions.values(), strict=True):
        assert (to.get(a.pair.link, "0"), to.get(a.pair.other, "0")) == (b.pair.link, b.pair.other)
        assert abs(base.vector(a.start, a.end) - other.vector(b.start, b.end)) <= 1e-10 * worst / base.sharpest
    for name, marks in base.plans.points.items():
        for mark in (marks.velocity, marks.acceleration):
            size = max(
                abs(base.place(m.acceleration)) + abs(base.place(m.velocity)) for m in base.plans.points.values()
            )
            twin = other.plans.points[name]
            assert (
                abs(base.place(mark) - other.place(twin.velocity if mark == marks.velocity else twin.acceleration))
                <= 1e-10 * size / base.sharpest
            )


@pytest.mark.parametrize("turns", [360, -360, 3600])
def test_whole_turns_of_the_driver_change_nothing(turns: int) -> None:
    from tests.solving.test_failures import FOUR_BAR

    base, other = draw(FOUR_BAR), draw(FOUR_BAR, 60 + turns)
    for n in numbers(base):
        assert named(other)[n.name].value == n.value or n.value != n.value
