"""Loads that are laws of the motion: against the independent solver, in every form, one position or many."""

from __future__ import annotations

import random
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from planes.batch import Cycle
from planes.plans import plans_of
from planes.scene import loads
from tests.helpers.comparing import against
from tests.helpers.mechanisms import KINDS, Case, make, to_yaml
from tests.helpers.oracle import Solution, follow, solve

MOST = 1e-9


def motion(rng: random.Random, scene: dict[str, Any], sol: Solution) -> str:
    """Something that is about 1, by a name of the motion, in many forms."""
    sizes = {f"{x}_{n}": v for n, (v, a, _) in sol.slides.items() for x, v in (("v", v), ("a", a), ("s", sol.slid[n]))}
    for n, (_, omega, epsilon) in sol.links.items():
        sizes |= {f"omega_{n}": omega, f"epsilon_{n}": epsilon}
    for p, (r, v, a) in sol.points.items():
        if any(p in link["points"] for link in scene["links"].values()):
            sizes |= {f"x_{p}": r.real, f"y_{p}": r.imag, f"v_{p}": abs(v), f"a_{p}": abs(a)}
    largest = {x: max(abs(v) for n, v in sizes.items() if n[0] == x) for x in {n[0] for n in sizes}}
    name = rng.choice(sorted(sizes))
    ratio = f"({name}/{largest[name[0]] or 1.0!r})"
    angle = rng.choice([f"phi_{n}" for n in sol.links])
    ways = [ratio, f"{ratio}^2", f"(1 + {ratio}^2)^-1.5", f"sqrt(abs{ratio})", f"hypot({ratio}, 0.5)"]
    ways += [f"max({ratio}, 0.25)", f"min(1/(2 + {ratio}), 0.4)", f"(sin({angle}) - cos(2*{angle})/3)"]
    return rng.choice(ways)


def law(rng: random.Random, scene: dict[str, Any], sol: Solution, link: str, most: float) -> Any:
    """A number of a load as a law of any form."""
    text = f"{most * rng.uniform(-1, 1)!r} + {most!r}*{motion(rng, scene, sol)}*{motion(rng, scene, sol)}"
    if (way := rng.random()) < 0.5:
        return text
    if way < 0.75:
        xs = [-5.0, -0.7, rng.uniform(-0.5, 0.5), 0.8, 5.0]
        return {"over": motion(rng, scene, sol), "table": [[x, most * rng.uniform(-1, 1)] for x in xs]}
    moving = [n for n, v in sol.speeds.items() if abs(v) > 1e-6 * max(map(abs, sol.speeds.values()))]
    if not moving:
        return text
    slider = rng.choice(moving)
    return {"working": text, "idle": most / 10, "slider": slider, "stroke": rng.choice(("ahead", "behind"))}


def lawful(seed: int, kinds: tuple[str, ...], **options: Any) -> Case:
    """A random mechanism, its loads made laws."""
    rng = random.Random(seed)
    case = make(rng, kinds, **options)
    scene = {**case.scene, "loads": [dict(load) for load in case.scene["loads"]]}
    for load in scene["loads"]:
        key = "force" if "force" in load else "moment"
        load[key] = law(rng, scene, case.solution, load["link"], abs(load[key]))
        if isinstance(load.get("direction"), float) and rng.random() < 0.5:
            load["direction"] = f"90 + 40*{motion(rng, scene, case.solution)}"
    return replace(case, scene=scene, solution=solve(scene, case.guess))


@pytest.mark.parametrize("seed", range(24))
def test_laws_of_any_form_agree_with_the_independent_solver(seed) -> None:
    kinds = tuple(random.Random(seed).choices(KINDS, k=1 + seed % 3))
    case = lawful(seed, kinds, friction=seed % 4 == 3, rest=seed % 8 == 5)
    _, apart = against(case)
    assert max(apart.values()) < MOST, sorted(apart.items(), key=lambda x: -x[1])[:3]


def many(case: Case, fast: bool) -> tuple[Any, list[float]]:
    """What a cycle finds at values of the drive near its own, and those values."""
    scene = loads(to_yaml(case.scene))
    assert scene.mechanism
    plans = plans_of(scene.mechanism)
    own = scene.mechanism.drive.position
    step = 2.0 if scene.mechanism.drive.kind == "phi" else 1e-3
    values = [own + step * k for k in range(-8, 9)]
    cycle = Cycle(plans, None)
    return (cycle, next(cycle.blocks(values, fast=fast))), values


@pytest.mark.parametrize("fast", [False, True], ids=["arrays", "compiled"])
@pytest.mark.parametrize("seed", range(8))
def test_many_positions_have_the_numbers_of_each(seed, fast) -> None:
    case = lawful(100 + seed, (KINDS[seed % 5],), friction=seed % 4 == 3)
    (cycle, block), values = many(case, fast)
    units = [c.unit for c in cycle.columns]
    most = {u: np.nanmax(abs(block.table[[k for k, x in enumerate(units) if x == u]])) for u in units}
    for i, value in enumerate(values):
        try:
            sol = follow(case.scene, case.guess, value, 4)
        except ValueError:
            assert block.failed[i]
            continue
        if block.failed[i]:
            continue
        k = next(k for k, c in enumerate(cycle.columns) if c.value == cycle.plans.balancing)
        assert abs(block.table[k, i] - sol.balancing) < MOST * most[units[k]], value
