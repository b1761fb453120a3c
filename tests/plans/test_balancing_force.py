"""A balancing force on the driver beside the moment: its moment is the same, and the frame bears the rest."""

from __future__ import annotations

import cmath
import math

import pytest

from planes.scene import load, loads
from planes.solving import solve
from planes.words.errors import SceneError
from tests.helpers import ROOT

SIX = (ROOT / "samples" / "six-link.yaml").read_text("utf-8")
DRIVE = "epsilon: 80}"


@pytest.mark.parametrize("angle", [90.0, 60.0, -35.0])
@pytest.mark.parametrize("phi", [150.0, 140.0])
def test_a_force_balances_as_the_moment_does(angle: float, phi: float) -> None:
    text = SIX.replace(DRIVE, f"epsilon: 80, balance: {{point: B, angle: {angle}}}}}")
    (p,), (plain,) = solve(loads(text), [phi]).positions, solve(loads(SIX), [phi]).positions
    moment, force = p.number("balancing_moment"), p.number("balancing_force")
    assert moment == plain.number("balancing_moment") and force is not None and moment is not None
    way = cmath.rect(1.0, math.radians(phi + angle))
    lever = p.r["B"] - p.r["A"]
    assert (lever.conjugate() * force * way).imag == pytest.approx(moment, rel=1e-13)
    reactions = p.of("reactions")
    key = next(k for k in reactions if k.endswith("^b"))
    whole = key.removesuffix("^b")
    assert abs(reactions[whole].vector - reactions[key].vector - force * way) < 1e-12 * abs(reactions[whole].vector)


def test_a_scene_keeps_it_when_it_is_written_again() -> None:
    scene = loads(SIX.replace(DRIVE, "epsilon: 80, balance: {point: B, angle: 60}}"))
    again = loads(scene.to_yaml())
    assert again.mechanism and again.mechanism.drive.balance == ("B", 60.0)
    assert solve(again).positions[0].number("balancing_force") == solve(scene).positions[0].number("balancing_force")


@pytest.mark.parametrize(
    ("balance", "said"),
    [
        ("{point: C}", "there is no point of link 1"),
        ("{angle: 90}", "needs the key point"),
        ("{point: B, force: 3}", "force"),
    ],
)
def test_a_balancing_force_that_cannot_be_is_refused(balance: str, said: str) -> None:
    with pytest.raises(SceneError) as refusal:
        loads(SIX.replace(DRIVE, f"epsilon: 80, balance: {balance}}}"))
    assert said in refusal.value.told("en"), refusal.value.told("en")


def test_a_slider_is_balanced_by_its_own_force() -> None:
    text = (ROOT / "samples" / "sliding-driver.yaml").read_text("utf-8")
    line = next(x for x in text.splitlines() if x.startswith("drive:"))
    with pytest.raises(SceneError) as refusal:
        loads(text.replace(line, line.replace("}", ", balance: {point: A}}", 1)))
    assert "a slider is balanced by a force along its guide" in refusal.value.told("en")
    assert load(ROOT / "samples" / "sliding-driver.yaml").mechanism
