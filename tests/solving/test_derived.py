"""What is reckoned on the way to the reactions: the numbers the manuals print for it, and closed forms."""

from __future__ import annotations

from dataclasses import replace

import pytest

from planes.scene import load
from planes.solving import Position, solve
from tests.helpers import ROOT

PRINTED = {  # as the manual on force analysis prints them, to three digits
    "bntu-2": {"N_30": 747, "T_30": 112, "P_T30": 235},
    "bntu-4": {"I_3": 113, "M_I2": 28.3},
    "bntu-5": {"I_3": 202, "M_Φ2": 3.54},
}


def position(name: str, **changed: object) -> Position:
    (found,) = solve(replace(load(ROOT / "samples" / f"{name}.yaml"), **changed)).positions
    return found


@pytest.mark.parametrize("name", PRINTED)
def test_printed_numbers_can_be_asked_for(name: str) -> None:
    asked = position(name, find=tuple(PRINTED[name]))
    for quantity, printed in PRINTED[name].items():
        assert abs(asked.value(quantity)) == pytest.approx(printed, rel=2e-3)
    told = {**asked.results.get("loads", {}), **asked.results.get("friction", {})}
    assert len(told) == len(PRINTED[name])


def test_friction_takes_power_and_leans_the_reaction() -> None:
    p = position("bntu-2")
    assert p.value("T_30") / p.value("N_30") == pytest.approx(-0.15)
    assert abs(complex(p.value("T_30"), p.value("N_30")) - p.value("F_30")) < 1e-9 * 3000
    assert p.results["friction"]["P_T30"] == p.value("P_T30") == pytest.approx(p.value("T_30") * p.v["B"].real)


def test_weights_and_inertia_are_those_of_the_motion() -> None:
    p = position("six-link")
    loads, links = p.results["loads"], p.plans.mechanism.links
    assert set(loads) == {"G_1", "MI_1", "G_2", "I_2", "MI_2", "G_3", "MI_3", "G_5", "I_5"}
    assert loads["G_5"] == pytest.approx(50 * 9.81)
    assert loads["I_2"] == pytest.approx(links["2"].mass * abs(p.a["S2"]))
    assert loads["MI_3"] == pytest.approx(-links["3"].inertia * p.epsilon["3"])
    assert p.value("Φ_2") == p.value("I_2") == loads["I_2"]
