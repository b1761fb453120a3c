"""Where lines and arcs meet, against rationals, 50 digits and shapely, near failure too."""

from __future__ import annotations

import cmath
import math
import random
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from shapely.geometry import LineString

from planes.geometry import plane
from planes.geometry.arithmetic import Arithmetic, Many

EPS = 2.0**-52
ONE, MANY = Arithmetic(), Many()
SETTINGS = settings(max_examples=200)
SPAN = st.floats(-1000, 1000).map(lambda x: round(x, 6) + 0.0)
PLACE = st.builds(complex, SPAN, SPAN)
ANGLE = st.floats(-360, 360)
SIDE = st.sampled_from((1.0, -1.0))


def exact(z: complex) -> tuple[Fraction, Fraction]:
    return Fraction(z.real), Fraction(z.imag)


def crossing(p: complex, u: complex, q: complex, w: complex) -> tuple[Fraction, Fraction]:
    """Where two lines meet, in rationals, by Cramer's rule."""
    (px, py), (ux, uy), (qx, qy), (wx, wy) = map(exact, (p, u, q, w))
    t = ((qx - px) * wy - (qy - py) * wx) / (ux * wy - uy * wx)
    return px + t * ux, py + t * uy


def away(z: complex, true: tuple[Any, Any]) -> float:
    return math.hypot(float(Fraction(z.real) - true[0]), float(Fraction(z.imag) - true[1]))


@SETTINGS
@given(PLACE, ANGLE, PLACE, st.one_of(ANGLE, st.floats(-13, 0).map(lambda e: 10**e)), st.booleans())
def test_lines_meet_where_rationals_say(p: complex, a: float, q: complex, b: float, close: bool) -> None:
    """The error is a few units in the last place of the data, over the sharpness."""
    u = ONE.cis_deg(a)
    w = ONE.cis_deg(a + b) if close else ONE.cis_deg(b)
    place, sharpness, gap = plane.intersect_lines(p, u, q, w)
    assume(abs(sharpness) > 1e-14)
    assert abs(sharpness - plane.cross(u, w)) == 0
    size = abs(p) + abs(q) + abs(place - p)  # a crossing far off the sheet is wrong in proportion
    assert away(place, crossing(p, u, q, w)) <= 4 * EPS * size / abs(sharpness) + 1e-300
    assert abs(gap - plane.cross(u, q - p)) == 0


@SETTINGS
@given(PLACE, ANGLE, PLACE, ANGLE)
def test_lines_meet_where_shapely_says(p: complex, a: float, q: complex, b: float) -> None:
    u, w = ONE.cis_deg(a), ONE.cis_deg(b)
    place, sharpness, _ = plane.intersect_lines(p, u, q, w)
    assume(abs(sharpness) > 1e-3)
    reach = 2 * (abs(p) + abs(q) + 1) / abs(sharpness)
    ends = [
        LineString([((s - d * reach).real, (s - d * reach).imag), ((s + d * reach).real, (s + d * reach).imag)])
        for s, d in ((p, u), (q, w))
    ]
    met = ends[0].intersection(ends[1])
    assert not met.is_empty
    assert abs(complex(met.x, met.y) - place) <= 1e-10 * reach


def mp(z: complex) -> Any:
    return mpmath.mpc(z.real, z.imag)


def angle_between(u: Any, w: Any) -> float:
    return float(abs((mpmath.conj(u) * w).imag / abs(u) / abs(w)))


@SETTINGS
@given(PLACE, ANGLE, PLACE, st.floats(0.001, 1500), SIDE, st.floats(-15, 0))
def test_a_line_and_an_arc_meet_where_50_digits_say(
    p: complex, a: float, c: complex, r: float, side: float, near: float
) -> None:
    """``near`` brings the line within 10^near of touching: the error is over the sharpness, no worse."""
    u = ONE.cis_deg(a)
    if near < -3:
        p = c - 1j * u * r * (1 - 10**near) + u * p.real
    place, sharpness, miss = plane.intersect_line_circle(p, u, c, r, side, ONE)
    with mpmath.workdps(50):
        up = mp(u) / abs(mp(u))
        h = (mpmath.conj(up) * (mp(c) - mp(p))).imag
        half = mpmath.mpf(r) ** 2 - h**2
        assert abs(miss - float(abs(h) - r)) <= 4 * EPS * (abs(p) + abs(c) + r)
        assume(half > (1e-13 * r) ** 2 and miss < 0)
        true = mp(c) - 1j * up * h + up * side * mpmath.sqrt(half)
        truth = float(mpmath.sqrt(half) / r)
        size = abs(p) + abs(c) + r
        bound = 8 * EPS * size
        assert abs(sharpness - truth) <= bound / r / truth
        assert float(abs(mp(place) - true)) <= bound * (1 + 1 / truth)


@SETTINGS
@given(PLACE, st.floats(0.01, 1000), PLACE, st.floats(0.01, 1000), SIDE, st.floats(-15, 0), st.booleans())
def test_arcs_meet_where_50_digits_say(
    c: complex, r: float, d: complex, s: float, side: float, near: float, inside: bool
) -> None:
    apart = abs(d - c)
    assume(apart > 1e-3)
    if near < -3:  # almost touching, from outside or inside
        s = apart - r * (1 - 10**near) if not inside else apart + r * (1 - 10**near)
        assume(s > 0.01)
    place, sharpness, far, inner = plane.intersect_circles(c, r, d, s, side, ONE)
    assert math.isclose(far, apart - (r + s), abs_tol=4 * EPS * (apart + r + s))
    assert math.isclose(inner, abs(r - s) - apart, abs_tol=4 * EPS * (apart + r + s))
    assume(far < 0 and inner < 0)
    with mpmath.workdps(50):
        e = mp(d) - mp(c)
        long = abs(e)
        x = (long**2 + mpmath.mpf(r) ** 2 - mpmath.mpf(s) ** 2) / (2 * long)
        y2 = mpmath.mpf(r) ** 2 - x**2
        assume(y2 > 0)
        true = mp(c) + e / long * (x + side * 1j * mpmath.sqrt(y2))
        truth = angle_between(true - mp(c), true - mp(d))
        assume(truth > 1e-6)
        size = abs(c) + abs(d) + r + s
        error = float(abs(mp(place) - true))
        assert error <= 8 * EPS * size / truth * max(1.0, max(r, s) / apart)
        assert abs(sharpness - truth) <= 16 * EPS * size / min(r, s, apart) / truth


@SETTINGS
@given(PLACE, PLACE, st.floats(0.01, 1000), st.floats(-16, 0), st.sampled_from([1.0, -1.0]))
def test_whether_circles_meet_is_known_to_the_last_digit(
    c: complex, d: complex, r: float, near: float, way: float
) -> None:
    s = abs(d - c) - r + way * 10**near  # almost touching
    x, y = Fraction(d.real) - Fraction(c.real), Fraction(d.imag) - Fraction(c.imag)
    true = (Fraction(r) + Fraction(s)) ** 2 - x * x - y * y
    size = abs(c) + abs(d) + abs(r) + abs(s)
    many = MANY.gap(np.array([c, c]), np.array([d, d]), np.array([r, r]), s)
    touching = EPS * 1.5 * size * abs(r + s)  # what rounding the givens alone may make
    for found in (ONE.gap(c, d, r, s), float(many[1])):
        right = abs(Fraction(found) - true) <= EPS * abs(true) + 2.0**-100 * size**2
        assert right or (not found and abs(true) < touching)


def test_circles_that_touch_in_decimals_touch() -> None:
    rng = random.Random(1)
    for _ in range(200):
        crank, rod = round(rng.uniform(0.05, 0.12), 3), round(rng.uniform(0.2, 0.4), 3)
        far, near = round(crank + 2 * rod, 6) + 0j, round(crank + rod, 6) + 0j
        assert plane.intersect_circles(crank + 0j, rod, far, rod, 1.0, ONE)[1] == 0
        assert plane.intersect_circles(crank + 0j, 2 * rod, near, rod, 1.0, ONE)[1] == 0


@SETTINGS
@given(PLACE, PLACE, st.floats(-1, 1), SIDE, st.floats(-15, 0))
def test_a_tangent_touches_its_circle(c: complex, a: complex, part: float, side: float, near: float) -> None:
    apart = abs(a - c)
    assume(apart > 1e-3)
    offset = apart * part if near > -3 else math.copysign(apart * (1 - 10**near), part)
    u, sharpness, large = plane.tangent_direction(c, a, offset, side, ONE)
    assume(large < 0)
    with mpmath.workdps(50):
        way = mp(a) - mp(c)
        ahead2 = abs(way) ** 2 - mpmath.mpf(offset) ** 2
        assume(ahead2 > 0)
        true = way / (side * mpmath.sqrt(ahead2) + 1j * offset)
        true /= abs(true)
        truth = float(mpmath.sqrt(ahead2) / abs(way))
        assume(truth > 1e-7)
        assert float(abs(mp(u) - true)) <= 8 * EPS * (1 + (abs(a) + abs(c)) / apart) / truth
        assert abs(sharpness - truth) <= 8 * EPS * (1 + (abs(a) + abs(c)) / apart) / truth
    assert abs(abs(u) - 1) <= 4 * EPS


@given(ANGLE)
@SETTINGS
def test_directions_are_unit_and_opposite_across_half_a_turn(a: float) -> None:
    assert abs(abs(ONE.cis_deg(a)) - 1) <= 2 * EPS
    with mpmath.workdps(30):
        turn = mpmath.mpf(a) * mpmath.pi / 180
        assert abs(ONE.cis_deg(a) - complex(mpmath.cos(turn), mpmath.sin(turn))) <= 1.1 * EPS


@pytest.mark.parametrize("turns", [0, 1, -1, 7, 10**6, -(10**9)])
@pytest.mark.parametrize("quarter", range(4))
def test_quarter_turns_are_exact(quarter: int, turns: int) -> None:
    angle = 90.0 * quarter + 360.0 * turns
    assert ONE.cis_deg(angle) == (1, 1j, -1, -1j)[quarter]
    assert MANY.cis_deg(np.array([angle]))[0] == (1, 1j, -1, -1j)[quarter]


@pytest.mark.parametrize(
    "u, angle", [(1 + 0j, 0.0), (1j, 90.0), (-1 + 0j, 180.0), (complex(-1, -0.0), 180.0), (-1j, -90.0), (1 + 1j, 45.0)]
)
def test_angles_lie_in_the_half_open_turn(u: complex, angle: float) -> None:
    assert ONE.angle_deg(u) == angle
    assert MANY.angle_deg(np.array([u]))[0] == angle


def test_powers_of_zero_are_no_numbers_and_no_exceptions() -> None:
    assert math.isnan(ONE.power(0.0, -1))
    assert ONE.power(2.0, -2) == 0.25 and ONE.power(0.0, 0) == 1.0
    assert ONE.sqrt(-1e-30) == 0.0
    with np.errstate(all="ignore"):
        assert not np.isfinite(MANY.power(np.array([0.0]), -1)).any()


def test_arrays_give_the_numbers_of_one() -> None:
    """Lines, arcs and tangents of 500 random data, to a few units in the last place over the sharpness."""
    rng = random.Random(3)
    rows = [
        [complex(rng.uniform(-9, 9), rng.uniform(-9, 9)) for _ in range(2)]
        + [cmath.rect(1, rng.uniform(-4, 4)) for _ in range(2)]
        + [rng.uniform(1, 9), rng.uniform(1, 9), rng.choice((1.0, -1.0))]
        for _ in range(500)
    ]
    p, q, u, w, r, s, side = (np.array(column) for column in zip(*rows, strict=True))
    some = {
        "lines": (
            plane.intersect_lines(p, u, q, w)[:2],
            [plane.intersect_lines(a, c, b, d)[:2] for a, b, c, d, *_ in rows],
        ),
        "line_arc": (
            plane.intersect_line_circle(p, u, q, r, side, MANY)[:2],
            [plane.intersect_line_circle(a, c, b, x, k, ONE)[:2] for a, b, c, _, x, _, k in rows],
        ),
        "arcs": (
            plane.intersect_circles(p, r, q, s, side, MANY)[:2],
            [plane.intersect_circles(a, x, b, y, k, ONE)[:2] for a, b, _, _, x, y, k in rows],
        ),
        "tangent": (
            plane.tangent_direction(p, q, r / 5, side, MANY)[:2],
            [plane.tangent_direction(a, b, x / 5, k, ONE)[:2] for a, b, _, _, x, _, k in rows],
        ),
    }
    for name, ((places, sharps), singles) in some.items():
        for i, (place, sharp) in enumerate(singles):
            if abs(sharp) > 1e-4:
                assert abs(places[i] - place) <= 64 * EPS * max(1, abs(place)) / abs(sharp), (name, i)
                assert abs(sharps[i] - sharp) <= 16 * EPS / abs(sharp), (name, i)


def test_degenerate_data_give_no_exception_and_no_sharpness() -> None:
    assert plane.intersect_lines(0j, 1 + 0j, 1j, 1 + 0j)[1] == 0
    assert plane.intersect_line_circle(0j, 1 + 0j, 1j, 0.0, 1.0, ONE)[1] == 0
    assert plane.intersect_circles(0j, 0.0, 1 + 0j, 1.0, 1.0, ONE)[1] == 0
    assert plane.intersect_circles(1j, 2.0, 1j, 2.0, 1.0, ONE)[1] == 0
    assert plane.tangent_direction(1j, 1j, 0.0, 1.0, ONE)[1] == 0
    assert plane.unit_direction(0j, ONE) == 1 and plane.unit_direction(-3j, ONE) == -1j


def test_scales_of_a_micrometre_and_a_megametre_are_alike() -> None:
    for k in (1e-60, 1e-6, 1.0, 1e6, 1e60):
        place, sharpness, *_ = plane.intersect_circles(0j, 3.0 * k, 5.0 * k + 0j, 4.0 * k, 1.0, ONE)
        assert abs(place / k - (1.8 + 2.4j)) < 4 * EPS and abs(sharpness - 1) < 4 * EPS
