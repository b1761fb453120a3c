"""What givens lose as doubles, beside the same mechanism stated in numbers of fifty digits."""

import random

import pytest

from planes.plans import Plans, plans_of
from planes.scene import loads
from tests.helpers.as_written import LONG, givens
from tests.helpers.mechanisms import KINDS, make, to_yaml

EXPRESSIONS = """\
planes: 1
parameters: {a: 0.37, b: a/3}
frame: {points: {A: [0, 0], D: [2*b, 0.1]}}
links:
  1: {points: {A: 0, B: b}}
  2: {points: {B: 0, C: 0.41, E: [sqrt(0.02), 0.07]}}
  3: {points: {C: 0, D: {r: a*1.1, angle: 11.3}}}
assembly: {C: left}
drive: {link: 1, phi: 60.1, omega: a}
"""


def stated(text: str) -> Plans:
    mechanism = loads(text).mechanism
    assert mechanism
    return plans_of(mechanism)


@pytest.mark.parametrize("seed", range(4, 14))
def test_what_is_left_out_of_a_given_is_known_to_the_last_digit(seed: int) -> None:
    plans = stated(to_yaml(make(random.Random(seed), [KINDS[seed % 5]], limit=1e4).scene))
    true, counted = givens(plans.mechanism), 0
    for name, (lost, off) in plans.decimal_rounding_errors.items():
        more = LONG.mp.mpmathify(true[name]) - LONG.mp.mpmathify(plans.given[name])
        left = complex(more - 360 * round(float(more.real) / 360))  # half a turn is told from either side
        assert off == 0.0 and abs(lost - left) <= 1e-14 * abs(left) + 1e-36, name
        counted += abs(lost) > 0
    assert counted > 8 and len(plans.decimal_rounding_errors) == len(plans.given) - 1  # the drive is elsewhere


def test_what_is_reckoned_of_expressions_is_off_by_no_more_than_said() -> None:
    plans, mp = stated(EXPRESSIONS), LONG.mp
    a = mp.mpf("0.37")
    d = a * mp.mpf("1.1") * LONG.cis_deg(mp.mpf("11.3"))
    e = mp.mpc(mp.sqrt(mp.mpf("0.02")), mp.mpf("0.07"))
    true = {"l_AB": a / 3, "l_DC": abs(d), "place_D": mp.mpc(2 * a / 3, mp.mpf("0.1")), "ratio_E_2": e / mp.mpf("0.41")}
    for name, exact in true.items():
        lost, off = plans.decimal_rounding_errors[name]
        assert off > 0 and abs(complex(exact - mp.mpmathify(plans.given[name])) - lost) <= off, name
        assert off < 1e-15
    assert plans.decimal_rounding_errors["omega_1"] == (pytest.approx(float(a - mp.mpf(0.37)), rel=1e-12), 0.0)
