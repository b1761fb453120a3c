"""Dead points of groups of class III and IV against a closure of 120 digits that shares no code with the plans."""

from __future__ import annotations

import cmath
import math
import random
from typing import Any

import pytest
import yaml
from mpmath import mpf

from planes.scene import loads
from planes.solving import solve
from tests.helpers.exact_closure import Closure, Vector
from tests.helpers.near_limits import WRONG, dead_point

KINDS = ("RR-RR-RR", "RR-PR-RP", "IV", "IV RP RR PR", "RR-RR+RR-PR")
BESIDE = (1e-2, 1e-4, 1e-6)  # degrees from the dead point


def pose(closure: Closure, results: dict[str, Any]) -> Vector:
    """Where the plans put the links: a place to begin from."""
    found: Vector = []
    for name in closure.links:
        turn = math.radians(results["links"][name]["angle_deg"])
        point, local = next(iter(closure.points[name].items()))
        origin = complex(*results["points"][point]["r"]) - complex(local) * cmath.exp(1j * turn)
        found += [mpf(origin.real), mpf(origin.imag), mpf(turn)]
    return found


def exact(closure: Closure, q: Vector, value: float) -> dict[str, dict[str, float]]:
    """Angular velocities and accelerations, and the sizes of reactions, by the closure alone."""
    _, speeds, quick = closure.moving(q, value)
    omega, epsilon = ({n: float(x[3 * k + 2]) for k, n in enumerate(closure.links)} for x in (speeds, quick))
    forces = {n: float(x) for n, x in closure.forces(q, value).items()}
    return {"omega": omega, "epsilon": epsilon, "force": forces, "moment": {"M": forces.pop("M")}}


def given(results: dict[str, Any]) -> dict[str, dict[str, float]]:
    """The same by the plans."""
    rates = {rate: {n: link[rate] for n, link in results["links"].items()} for rate in ("omega", "epsilon")}
    forces = dict[str, float]()
    for key, reaction in results["reactions"].items():
        if isinstance(reaction, list):
            name = key if key.count("_") == 2 else f"F_{key[2]}_{key[3:]}"
            forces[name] = abs(complex(*reaction))
    return {**rates, "force": forces, "moment": {"M": abs(results["balancing_moment"])}}


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_a_dead_point_is_where_the_closure_has_it_and_no_number_beside_it_is_wrong_unsaid(kind: str) -> None:
    text, end = dead_point(random.Random(f"dead {kind}"), kind)
    scene = yaml.safe_load(text)
    scene.pop("loads")  # weight and inertia, which grows there without bound
    text = yaml.safe_dump(scene, sort_keys=False)
    closure = Closure({**scene, "links": {str(name): link for name, link in scene["links"].items()}})
    inside = next(s for s in (1, -1) if solve(loads(text), [end + s * BESIDE[0]]).positions)
    told = 0
    for off in BESIDE:
        value = end + inside * off
        for position in solve(loads(text), [value]).positions:
            q = closure.lies(pose(closure, position.results), value)
            truth = exact(closure, q, value)
            for kind_, numbers in given(position.results).items():
                largest = max(map(abs, truth[kind_].values()))
                wrong = {n: abs(truth[kind_][n] - x) for n, x in numbers.items() if n in truth[kind_]}
                assert kind_ == "moment" or len(wrong) > 3
                assert max(wrong.values()) <= WRONG * largest or position.results["warnings"], (off, kind_, wrong)
            told += 1
            if off == BESIDE[0]:
                assert abs(closure.stops(q, value) - end) < 1e-7
    assert told >= 2
    assert not solve(loads(text), [end - inside * 1e-6]).positions  # beyond it there is nothing
