"""Coincidences that random scenes never meet: arcs that touch, groups that stand still, parallel guides, sums of
nothing, a place midway between two roots."""

from __future__ import annotations

import cmath
import math
import random
import re
from collections.abc import Callable

import numpy as np
import pytest

from planes.batch.cycle import Cycle
from planes.drafting.drawing import draw_program, mask_unproved_drawings
from planes.geometry.assemblies import all_assemblies
from planes.geometry.tracks import Tie
from planes.plans import plans_of
from planes.plans.scales import unit_scales_of_plans
from planes.scene import loads
from planes.solving import Position, solve
from planes.words.errors import SceneError

CHANGE_POINT = """\
planes: 1
frame: {points: {O: [0, 0], D: [0.5, 0]}}
links:
  1: {points: {O: 0, A: 0.25}}
  2: {points: {A: 0, B: 0.5}}
  3: {points: {D: 0, B: 0.25}}
assembly: {B: left}
drive: {link: 1, phi: 0, omega: 3}
find: [r_B]
"""
STANDING = """\
planes: 1
frame:
  points: {A: [0, 0], D: [0.06, -0.39], Y: [0.49, -0.563]}
  guides: {k: {through: [0.073, 0.156], angle: -32}}
links:
  1: {points: {A: 0, B: 0.1}}
  2: {points: {Y: 0, L: 0.75}}
  3: {points: {X: 0, G: [0.6, 0.3], L: [0.2, -0.4]}, mass: 3, centre: X}
  4: {points: {D: 0, G: 0.64}}
  5: {points: {X: 0}, slides: k}
assembly: {X: {near: [0.05, 0.17]}}
drive: {link: 1, phi: 10, omega: 1}
gravity: 9.81
"""
PARALLEL = """\
planes: 1
frame: {points: {O: [0, 0]}, guides: {a-a: {x: 0.4}, b-b: {x: 0.6}}}
links:
  1: {points: {O: 0, A: 0.1}}
  2: {points: {A: 0, B: 0.5}}
  3: {points: {B: 0, C: [0.1, 0.2], D: [0.35, 0.1]}}
  4: {points: {C: 0}, slides: a-a}
  5: {points: {D: 0}, slides: b-b}
drive: {link: 1, phi: 70, omega: 10}
"""


def solved(text: str) -> Position:
    return solve(loads(text, "s.yaml")).positions[0]


def vectors(rows: str, *equations: str) -> str:
    return f"planes: 1\nvectors:\n{rows}equations: [{', '.join(repr(e) for e in equations)}]\n"


def test_arcs_that_touch_are_a_place_with_an_error_of_the_root_of_a_rounding() -> None:
    found = solved(CHANGE_POINT)
    assert found.r["B"] == 0.75
    (segment,) = found.results["plans"]["position"]["segments"].values()
    size = 1000 * 0.75 * 1e3
    assert 1e-9 < segment["error_mm"] < 1e-7 * size
    text = vectors("  P_1: {value: 4, direction: 30}\n  P_2: {value: 2}\n  P_3: {value: 2}\n", "P_1 + P_2 + P_3 = 0")
    assert solved(text).value("P_2") == pytest.approx(-cmath.rect(2.0, math.radians(30)), abs=1e-7)


def test_a_group_that_stands_still_has_its_numbers_at_every_place_of_the_drive() -> None:
    one, cycle = solved(STANDING), Cycle(plans_of(loads(STANDING, "s.yaml").mechanism))
    (block,) = cycle.blocks(np.linspace(0.0, 350.0, 36), fast=False)
    assert not block.codes.any()
    row = dict(zip((c.name for c in cycle.columns), block.table, strict=True))
    for name, value in (("r_X", one.r["X"]), ("F_20", one.value("F_20"))):
        assert np.ptp(row[f"{name}_x"]) == 0
        assert row[f"{name}_x"][7] == pytest.approx(complex(value).real, abs=1e-9)


def test_what_does_not_move_is_drawn_in_the_shape_of_what_does() -> None:
    """Of many drawings every thing is an array of as many, and so is what failed."""
    plans = plans_of(loads(STANDING, "s.yaml").mechanism)
    given = {**plans.given, **unit_scales_of_plans(plans), **plans.drive_givens_at(np.linspace(0.0, 90.0, 5))}
    drawing = draw_program(plans.program, given)
    mask_unproved_drawings(drawing, given)
    assert {np.shape(thing) for thing in drawing.things.values()} == {(5,)}
    drawing.tool.fail_unless(False, plans.program.steps[0], "parallel")
    assert np.asarray(drawing.failed_mask()).tolist() == [True] * 5


# parallel lines


def test_a_plate_on_parallel_guides_has_two_assemblies() -> None:
    """By hand: the plate's slope from 0.2 = 0.25 cos θ + 0.1 sin θ, then B on a vertical line and an arc."""
    with pytest.raises(SceneError, match="assembles in 2 places") as caught:
        solved(PARALLEL)
    places = sorted(float(y) for y in re.findall(r"near: \[0\.6, ([-.\d]+)\]", str(caught.value)))
    slopes = [math.atan2(0.1, 0.25) + s * math.acos(0.2 / math.hypot(0.25, 0.1)) for s in (1, -1)]
    wanted, a = [], cmath.rect(0.1, math.radians(70))
    for turn in slopes:
        c, d = ((z * cmath.rect(1.0, turn)) for z in (0.1 + 0.2j, 0.35 + 0.1j))
        x = 0.4 - c.real
        square = 0.25 - (x - a.real) ** 2
        wanted += [a.imag + s * math.sqrt(square) + d.imag for s in (1, -1)] if square > 0 else []
    assert places == pytest.approx(sorted(wanted), abs=1e-4)
    for place in wanted:
        found = solved(PARALLEL + f"assembly: {{D: {{near: [0.6, {place}]}}}}\n")
        assert found.r["D"] == pytest.approx(0.6 + 1j * place, abs=1e-12)
        assert abs(found.r["B"] - found.r["A"]) == pytest.approx(0.5, rel=1e-13)
        assert found.v["C"].real == pytest.approx(0, abs=1e-13)


def _planted(kind: str, beside: str, rng: random.Random) -> tuple[list[Tie], complex, complex]:
    """Two ties of one direction and one beside them, of a pose that is known."""
    spot: Callable[[], complex] = lambda: complex(rng.uniform(-1, 1), rng.uniform(-1, 1))  # noqa: E731
    origin, axis, way = spot(), cmath.rect(1.0, rng.uniform(-3, 3)), cmath.rect(1.0, rng.uniform(-3, 3))
    ties = []
    for k, own in ((kind, way), (kind, way * rng.choice((1, -1))), (beside, cmath.rect(1.0, rng.uniform(-3, 3)))):
        local, place = spot(), spot()
        gap = origin + local * axis - place
        if k == "arc":
            reach = abs(gap)
        elif k == "line":
            reach = (own.conjugate() * gap).imag
        else:
            reach = -((own * axis).conjugate() * gap).imag
        ties.append(Tie(k, local, place, reach, own))  # type: ignore[arg-type]
    rng.shuffle(ties)
    return ties, origin, axis


def _counted(ties: list[Tie]) -> int:
    """How many there are, by sines and square roots: Re(z e^{iθ}) = c has two angles, each with its places."""
    (beside,) = [t for t in ties if sum(t.kind == u.kind and _same(t, u) for u in ties) == 1]
    one, two = (t for t in ties if t is not beside)
    same = 1 if (one.turn.conjugate() * two.turn).real > 0 else -1
    reach = same * two.reach - one.reach
    if one.kind == "line":
        z, c = -1j * one.turn.conjugate() * (two.local - one.local), reach + _left(one.turn, two.place - one.place)
    else:
        z = (-1j * one.turn.conjugate() * (two.place - one.place)).conjugate()
        c = reach + _left(one.turn, two.local - one.local)
    count = 0
    for sign in (1, -1) if abs(c) < abs(z) else ():
        axis = cmath.rect(1.0, sign * math.acos(c / abs(z)) - cmath.phase(z))
        if beside.kind != "arc":
            count += 1
            continue
        way = one.turn * (axis if one.kind == "guide" else 1)
        off = (one.local - beside.local) * axis - (one.place - beside.place)
        miss = _left(way, off) - one.reach if one.kind == "line" else -_left(way, off) - one.reach
        count += 2 * (abs(miss) < beside.reach)
    return count


def _same(t: Tie, u: Tie) -> bool:
    return abs((t.turn.conjugate() * u.turn).imag) < 1e-12


def _left(way: complex, z: complex) -> float:
    return (way.conjugate() * z).imag


@pytest.mark.few(3)
@pytest.mark.parametrize("beside", ["arc", "line", "guide"])
@pytest.mark.parametrize("kind", ["line", "guide"])
def test_ties_with_parallel_lines_are_all_counted(kind: str, beside: str) -> None:
    for seed in range(60):
        ties, origin, axis = _planted(kind, beside, random.Random(f"{kind}{beside}{seed}"))
        found = all_assemblies(ties, 1.0)
        assert found.is_count_proved
        assert min(abs(o - origin) + abs(a - axis) for o, a in found.poses) < 1e-9
        assert found.count == _counted(ties)
        for o, a in found.poses:
            assert max(abs(t.error_and_wrench(o, a)[0]) for t in ties) < 1e-12


def test_a_line_kept_twice_is_no_assembly_to_be_counted() -> None:
    tie = Tie("line", 0.3 + 0.1j, 0.2j, 0.1)
    assert not all_assemblies([tie, tie, Tie("arc", 0j, 1 + 1j, 0.7)], 1.0).is_count_proved
    three = [Tie("line", z, 0j, 0.1) for z in (0j, 1 + 0j, 0.3 + 0.2j)]
    assert not all_assemblies(three, 1.0).is_count_proved


# places midway, and places that contradict each other

FOUR_BAR = CHANGE_POINT.replace("A: 0.25", "A: 0.1").replace("B: 0.25", "B: 0.3").replace("phi: 0", "phi: 60")
FOUR_BAR = FOUR_BAR.replace("{A: 0, B: 0.5}", "{A: 0, B: 0.5, E: [0.2, 0.1]}")


@pytest.mark.parametrize(
    ("said", "words"),
    [
        ("B: {near: [0.4464, 0.0103]}", "chooses neither"),
        ("B: left, E: {near: [0.26, 0]}", "by B and the other by E"),
        ("B: {near: [0.5, 0.3]}, E: {near: [0.26, 0]}", "by B and the other by E"),
    ],
)
def test_a_place_that_chooses_neither_or_both_is_refused_with_both_places(said: str, words: str) -> None:
    with pytest.raises(SceneError, match=words) as caught:
        solved(FOUR_BAR.replace("B: left", said))
    assert len(re.findall(r"near: \[", str(caught.value))) == 2
    assert solved(FOUR_BAR.replace("B: left", "B: left, E: {near: [0.18, 0.27]}")).r["B"].imag > 0


def test_of_a_group_with_three_ties_too() -> None:
    with pytest.raises(SceneError, match="by B and the other by D"):
        solved(PARALLEL + "assembly: {B: {near: [0.237, 0.551]}, D: {near: [0.6, -0.39]}}\n")


@pytest.mark.parametrize(
    ("one", "two", "words"),
    [("near: 180", "", "of its two directions"), ("near: 130", ", near: 130", "near of P_3 choose different")],
)
def test_a_direction_midway_is_refused_with_both_directions(one: str, two: str, words: str) -> None:
    rows = f"  P_1: {{value: 4, direction: 0}}\n  P_2: {{value: 3, {one}}}\n  P_3: {{value: 3{two}}}\n"
    with pytest.raises(SceneError, match=words) as caught:
        solved(vectors(rows, "P_1 + P_2 + P_3 = 0"))
    assert "near: -131.8 or near: 131.8" in str(caught.value)


# sums of nothing

SUM = "  P_a: {value: 0.1, direction: 10}\n  P_b: {value: 0.2, direction: 10}\n  P_c: {value: %s, direction: 190}\n"


@pytest.mark.parametrize("value", ["0.3", "0.30000000000000004"])
def test_no_direction_is_taken_of_what_rounding_alone_has_made(value: str) -> None:
    rows = SUM % value + "  P_4: {}\n  P_1: {value: 1, direction: P_4}\n  P_3: {}\n"
    with pytest.raises(SceneError, match="no correct digit is left in P_4"):
        solved(vectors(rows, "P_a + P_b + P_c = P_4", "P_1 = P_3"))
    near = solved(vectors(rows.replace(value, "0.2999999"), "P_a + P_b + P_c = P_4", "P_1 = P_3"))
    assert near.value("P_3") == pytest.approx(cmath.rect(1.0, math.radians(10)), abs=1e-7)


def test_a_sum_of_nothing_may_itself_be_told_and_no_quotient_taken_of_it() -> None:
    rows = SUM % "0.3" + "  P_4: {}\n"
    assert abs(complex(solved(vectors(rows, "P_a + P_b + P_c = P_4")).value("P_4"))) < 1e-15
    rows += "  P_1: {value: 1/P_4, direction: 20}\n  P_3: {}\n"
    with pytest.raises(SceneError, match="no correct digit is left in P_4"):
        solved(vectors(rows, "P_a + P_b + P_c = P_4", "P_1 = P_3"))


# stated vectors


def test_a_vector_is_similar_to_one_that_is_given() -> None:
    rows = "  P_1: {value: 0.8, direction: -166}\n  P_2: {similar: P_1, ratio: 0.17, angle: -46}\n  P_3: {}\n"
    p1 = cmath.rect(0.8, math.radians(-166))
    p2 = p1 * cmath.rect(0.17, math.radians(-46))
    assert solved(vectors(rows, "P_3 + P_1 = -1.72*P_2")).value("P_3") == pytest.approx(-1.72 * p2 - p1, rel=1e-13)


CLOSING = "  P_1: {value: 3, direction: 0}\n  P_2: {value: 4, direction: 90}\n"


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ("direction: 233.13010235", ""),
        ("direction: 53.13010235", ""),
        ("value: 5, direction: 233.13010235", ""),
        ("direction: 234", "leave 5 at -126.87° for it, which is 0.0759 off"),
        ("value: 5.1, direction: 233.13010235", "which is 0.1 off"),
    ],
)
def test_a_closing_check_is_verified(given: str, words: str) -> None:
    text = vectors(CLOSING + f"  P_3: {{{given}}}\n", "P_1 + P_2 + P_3 = 0")
    if not words:
        assert solved(text).value("P_3") == pytest.approx(-3 - 4j, rel=1e-9)
        return
    with pytest.raises(SceneError, match=re.escape(words)):
        solved(text)


def test_a_check_of_vectors_that_were_all_drawn() -> None:
    rows = CLOSING + "  P_3: {}\n  P_4: {}\n"
    both = ("P_3 = P_1 + P_2", "P_4 = P_3 + P_1")
    assert solved(vectors(rows, *both, "P_4 = 2*P_1 + P_2")).value("P_4") == 6 + 4j
    with pytest.raises(SceneError, match="it is open by 3"):
        solved(vectors(rows, *both, "P_4 = P_1 + P_2"))


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ("value: 1/P_0, direction: 10", "s.yaml:5: P_2 is divided by P_0, which is zero"),
        ("similar: P_0, as: [P_1, P_0]", "s.yaml:5: P_2 is divided by P_0, which is zero"),
    ],
)
def test_a_quotient_by_a_given_nothing_is_refused_at_its_line(given: str, words: str) -> None:
    rows = f"  P_0: {{value: 0, direction: 30}}\n  P_1: {{value: 3, direction: 0}}\n  P_2: {{{given}}}\n  P_4: {{}}\n"
    with pytest.raises(SceneError, match=re.escape(words)):
        solved(vectors(rows, "P_4 = P_1 + P_2"))


def test_a_given_nothing_has_the_direction_it_is_given() -> None:
    rows = "  P_0: {value: 0, direction: 30}\n  P_1: {value: 3, direction: P_0}\n  P_2: {}\n"
    assert solved(vectors(rows, "P_2 = P_1 + P_0")).value("P_2") == pytest.approx(cmath.rect(3, math.radians(30)))


EQUAL = """\
planes: 1
frame: {points: {A: [0, 0]}, guides: {x-x: {y: 0}}}
links:
  1: {points: {A: 0, B: 0.1}}
  2: {points: {B: 0, C: 0.1}}
  3: {points: {C: 0}, slides: x-x}
drive: {link: 1, phi: 60, omega: 10}
assembly: {C: ahead}
"""


def test_a_crank_as_long_as_its_rod_keeps_its_digits_while_it_folds() -> None:
    """C is at 2 r cos φ: a half chord from rounded places would have lost every digit."""
    for off in (1e-3, 1e-5, 1e-7):
        (p,) = solve(loads(EQUAL), [90.0 - off]).positions
        assert p.r["C"].real == pytest.approx(0.2 * math.sin(math.radians(90.0 - (90.0 - off))), rel=1e-14)


def test_a_place_offered_for_a_choice_is_told_without_its_rounding() -> None:
    with pytest.raises(SceneError, match=r"ahead} for C at \(0\.1, 0\) or .*behind} for C at \(0, 0\)"):
        solve(loads(EQUAL.replace("assembly: {C: ahead}\n", "")))
