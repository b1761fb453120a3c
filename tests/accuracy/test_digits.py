"""Long numbers: the same program, the truth for all others."""

from __future__ import annotations

import mpmath
import pytest

from planes.accuracy.digits import Digits
from planes.batch.table import columns_of_quantities
from planes.drafting.drawing import Drawing, draw_program
from planes.plans import Plans, plans_of
from planes.plans.scales import unit_scales_of_plans
from planes.scene import load, loads
from planes.words.errors import PlanFailure
from tests.helpers import ROOT

SAMPLES = ROOT / "samples"

SLIDER_CRANK = """\
planes: 1
frame: {{points: {{O: [0, 0]}}, guides: {{x-x: {{y: 0}}}}}}
links:
  1: {{points: {{O: 0, A: {r}}}}}
  2: {{points: {{A: 0, B: {rod}}}}}
  3: {{points: {{B: 0}}, slides: x-x}}
assembly: {{B: ahead}}
drive: {{link: 1, phi: {phi}, omega: 1}}
"""


def plans(name: str) -> Plans:
    mechanism = load(str(SAMPLES / f"{name}.yaml")).mechanism
    assert mechanism
    return plans_of(mechanism)


def drawn(p: Plans, digits: int | None, **moved: float) -> Drawing:
    given = {**p.given, **unit_scales_of_plans(p), **moved}
    return draw_program(p.program, given, Digits(digits) if digits else None)


@pytest.mark.parametrize("name", ["six-link", "kind-1-rrr", "kind-2-rrp", "kind-3-rpr", "kind-4-prp", "kind-5-rpp"])
def test_fifty_digits_agree_with_thirty_and_with_doubles(name: str) -> None:
    p = plans(name)
    double, thirty, fifty = (drawn(p, n) for n in (None, 30, 50))
    for column in columns_of_quantities(p):
        if column.beside or not column.needed_names:
            continue
        short, long, longest = (column.read_from_drawing(d.things, d.tool.ar) for d in (double, thirty, fifty))
        size = abs(longest) + 1e-3
        assert abs(long - longest) < 1e-24 * size, column.name
        assert abs(short - longest) < 1e-10 * size, column.name


def test_digits_are_there() -> None:
    p = plans("six-link")
    found = drawn(p, 50)[p.points["B"].position]
    with mpmath.workdps(50):
        assert abs(found.real + mpmath.mpf(0.1) * mpmath.sqrt(3) / 2) < mpmath.mpf(10) ** -48


def test_failures_are_the_same() -> None:
    p = plans("six-link")
    with pytest.raises(PlanFailure) as failure:
        drawn(p, 50, angle_x_1=0.0)
    assert failure.value.reason == "arcs_apart"


@pytest.mark.parametrize("power", [1, 3, 6, 9, 12])
def test_a_crank_as_long_as_its_rod_keeps_its_digits_near_the_fold(power: int) -> None:
    """There x = 2 r cos φ and a = -x ω²; formulas that square and subtract lose everything.

    Place and velocity keep all their digits; the acceleration is the crossing of lines almost parallel.
    """
    mechanism = loads(SLIDER_CRANK.format(r=0.25, rod=0.25, phi=60)).mechanism
    assert mechanism
    p = plans_of(mechanism)
    phi = 90 - 10.0**-power
    double, truth = (drawn(p, n, angle_x_1=phi) for n in (None, 50))
    for mark in (p.points["B"].position, p.points["B"].velocity):
        assert abs(double[mark] - truth[mark]) <= 2e-15 * abs(truth[mark])
    sharpness = double.crossing_sharpness[p.points["B"].acceleration]
    assert abs(double[p.points["B"].acceleration] - truth[p.points["B"].acceleration]) <= 2e-16 / sharpness
