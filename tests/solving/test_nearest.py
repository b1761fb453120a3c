"""The nearest position that works: nearest by the closed form, and working when it is typed as it is printed."""

from __future__ import annotations

import math
import random
import re
from collections.abc import Callable

import pytest

from planes.scene import loads
from planes.solving import plans_and_requested_results, solve
from planes.solving.nearest import Nearest, _Side, nearest_working_position
from tests.helpers.near_limits import PRP, RPR, RRP, RRR

PLACES = 1.01e-4  # degrees: the last place printed


def four_bar(r: float, rod: float, q: float, d: float) -> tuple[str, Callable[[float], bool], list[float]]:
    """The scene, where it works, and where that ends: arcs rod and q meet while |rod - q| <= BD <= rod + q."""

    def works(phi: float) -> bool:
        square = r * r + d * d - 2 * r * d * math.cos(math.radians(phi))
        return (rod - q) ** 2 <= square <= (rod + q) ** 2

    cosines = [(r * r + d * d - reach * reach) / (2 * r * d) for reach in (rod + q, rod - q)]
    ends = [math.degrees(math.acos(c)) * sign for c in cosines if abs(c) <= 1 for sign in (1, -1)]
    return RRR.format(r=r, rod=rod, q=q, d=d), works, ends


def slider(r: float, rod: float, e: float) -> tuple[str, Callable[[float], bool], list[float]]:
    """The same of a crank-slider: |r sin φ - e| <= rod."""
    sines = [(e + side * rod) / r for side in (1, -1)]
    turns = [math.degrees(math.asin(s)) for s in sines if abs(s) <= 1]
    ends = [*turns, *(180 - a for a in turns)]
    return RRP.format(r=r, rod=rod, e=e), lambda phi: abs(r * math.sin(math.radians(phi)) - e) <= rod, ends


def checked(found: tuple[str, Callable[[float], bool], list[float]], value: float) -> str:
    """What is said of a value at which the mechanism does not work; "" where it works."""
    text, works, ends = found
    if works(value):
        return ""
    near = nearest_working_position(plans_and_requested_results(loads(text))[0], value)
    if near is None:
        assert not ends, (text, value)
        return "none"
    away = min(abs(math.remainder(end - value, 360.0)) for end in ends)
    assert works(near) and abs(abs(near - value) - away) <= PLACES, (text, value, near, away)
    assert round(near, 4) == near or len(repr(near)) < 12
    return "found"


@pytest.mark.slow
def test_the_nearest_is_nearest_and_works_by_the_closed_form() -> None:
    rng, said = random.Random(3), []
    while len(said) < 120:
        r, rod, q, d = (round(rng.uniform(0.1, 0.9), 3) for _ in range(4))
        of = four_bar(r, rod, q, d) if rng.random() < 0.5 else slider(r, rod, q - 0.5)
        if found := checked(of, round(rng.uniform(-180, 180), 2)):
            said.append(found)
    assert said.count("found") > 90


@pytest.mark.parametrize(
    "r, rod, e, value", [(0.691, 0.156, -0.234, 76.0), (0.597, 0.738, -0.345, 101.75), (0.9, 0.0004, 0.3, 100.0)]
)
def test_the_nearest_of_sliders_that_were_told_wrong(r: float, rod: float, e: float, value: float) -> None:
    assert checked(slider(r, rod, e), value) == "found"


def test_a_range_narrower_than_the_last_place_is_found_and_told() -> None:
    """The crank's top is 1e-13 of its length above where the rod begins to reach: a range of some 2e-5 degrees."""
    assert checked(slider(0.5, 0.1, 0.6 - 5e-14), -90.0) == "found"


def test_values_between_two_that_work_are_looked_through_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """As often as the gaps: two, to both sides; in any order, a turn on and back."""
    text, works, ends = slider(0.691, 0.156, -0.234)
    plans, looked = plans_and_requested_results(loads(text))[0], list[float]()
    first = _Side.first_working_position
    monkeypatch.setattr(_Side, "first_working_position", lambda side: (looked.append(side.value), first(side))[1])
    values, many = [v for v in (76.0, 100.0, 30.0, 270.0, 436.0, -284.0, 96.5) if not works(v)], Nearest(plans)
    for value in values:
        near = many.nearest_to_position(value)
        away = min(abs(math.remainder(end - value, 360.0)) for end in ends)
        assert near is not None and works(near) and abs(abs(near - value) - away) <= PLACES, value
    assert len(values) == 7 and len(looked) == 4


@pytest.mark.parametrize(
    "text, value",
    [
        (PRP.format(r=0.3, e=0.7), 180.0),
        (RPR.format(r=0.2, d=0.2), 0.0),
        (RRR.format(r=0.1, rod=0.4, q=0.1, d=0.4), 0.0),
    ],
)
def test_a_place_that_fails_alone_has_a_neighbour_a_little_away(text: str, value: float) -> None:
    (failed,) = solve(loads(text), [value]).failed
    printed = re.search(r"the nearest that works: φ = (.*)°", failed["error"])
    assert printed and 0.005 < abs(float(printed[1]) - value) < 0.02
    assert solve(loads(text), [float(printed[1])]).positions


def test_a_sliding_driver_is_told_in_metres() -> None:
    text = RRP.format(r=0.2, rod=0.5, e=0.0).replace("C: ahead", "B: left")
    text = text[: text.index("drive:")] + "drive: {link: 3, s: 0.9, velocity: 1}\n"
    (failed,) = solve(loads(text), [0.9]).failed
    assert failed["error"].endswith("the nearest that works: s = 0.699999 m")  # at 0.7 m it is stretched
