"""What a drawing claims of its own errors: never less than they are, and seldom far more."""

from __future__ import annotations

import math
import random
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import planes
from planes.accuracy.digits import Digits
from planes.accuracy.errors import Spread
from planes.accuracy.stability import approach_nearest_limit
from planes.batch import compiled
from planes.batch.array_ops import ARRAY_OPERATIONS, numbers_at_places
from planes.batch.cycle import Cycle
from planes.batch.error_bounds import Claims
from planes.batch.rounding import (
    EXACT_OPERATIONS,
    LARGEST_ROUNDING_HALVES,
    USUAL_ROUNDING_UNITS,
    linearisation_remainder,
    rounding_error_of,
    whole_number_places,
)
from planes.batch.tracing import given_values_by_name
from planes.cli import main
from planes.diagrams.turn import WholeTurn, whole_turn_of
from planes.drafting.drawing import draw_program
from planes.drafting.instruments import Pencil
from planes.plans import plans_of
from planes.plans.curves import UNIT_DRIVE_PREFIX
from planes.plans.scales import plan_scales
from planes.plans.statements.of_scene import scene_plans
from planes.scene import load, loads
from tests.helpers import ROOT
from tests.helpers.double_double import TWO_OPS, apart
from tests.helpers.mechanisms import KINDS, make, to_yaml
from tests.nightly import beside_text, close_to_limits, errors, mechanism, truth

SAMPLES = ROOT / "samples"
KIND_SAMPLES = ["kind-1-rrr", "kind-2-rrp", "kind-3-rpr", "kind-4-prp", "kind-5-rpp", "six-link"]


def cycle_of(name: str) -> Cycle:
    mechanism = load(str(SAMPLES / f"{name}.yaml")).mechanism
    assert mechanism
    return Cycle(plans_of(mechanism))


def random_cycle(seed: int, **how: Any) -> Cycle:
    found = mechanism(seed, **how)
    assert found
    return found


def ratios(c: Cycle, values: Any, fast: bool = False) -> Any:
    """Claim over error, of every number that is not right to the last place; none may be below 1."""
    (block,) = c.blocks(values, fast=fast, chunk=len(values), bare=True)
    good = block.codes == 0
    assert good.any()
    error, claims = (
        errors(block.table[:, good], truth(c, values[good])),
        Claims(c).error_bounds_of_columns(values[good]),
    )
    assert not (error > claims).any()
    sure = (error > 0) & np.isfinite(claims)
    return claims[sure] / error[sure]


def test_claims_are_honest_and_close_for_every_kind() -> None:
    found = []
    for name in KIND_SAMPLES:
        c = cycle_of(name)
        found.append(ratios(c, c.plans.mechanism.drive.position + np.random.default_rng(5).uniform(-8, 8, 40)))
    assert np.median(np.concatenate(found)) < 10


@pytest.mark.few(0)
@pytest.mark.parametrize("friction", [False, True])
def test_claims_are_honest_and_close_for_random_mechanisms(friction: bool) -> None:
    found = []
    for seed in range(10, 22):
        case = make(random.Random(seed), [KINDS[seed % 5]], limit=1e4, friction=friction)
        scene = loads(to_yaml(case.scene)).mechanism
        assert scene
        found.append(ratios(Cycle(plans_of(scene)), scene.drive.position + np.linspace(-1e-3, 1e-3, 8)))
    assert np.median(np.concatenate(found)) < 10


@pytest.mark.slow
@pytest.mark.parametrize("seed", [500016, 83, 93, 5000004, 69])
def test_claims_are_honest_where_little_is_left_to_know(seed: int) -> None:
    """Beside a limit speeds grow past all bounds: a force's direction is then nothing but error, a slow thing is called
    a standstill, and the sense of a load is not known."""
    c = random_cycle(seed, sliding=False)
    rng = np.random.default_rng(seed)
    near = close_to_limits(c, rng) if seed % 3 == 0 or seed < 100 else rng.uniform(0, 360, 1000)
    assert ratios(c, near[:128] if len(near) else rng.uniform(0, 360, 100)).size


@pytest.mark.slow
def test_nothing_is_claimed_of_what_is_all_error() -> None:
    """An arm is a moment over a force: where the force is less than its own error, there is nothing to claim."""
    c = random_cycle(500016, sliding=False)
    values = 60.82792446 + np.logspace(-9, -6, 128)  # just past the limit
    claims = Claims(c).error_bounds_of_columns(values)
    silent = {column.name for column, row in zip(c.columns, claims, strict=True) if not np.isfinite(row).all()}
    assert silent and all(name.endswith(("_arm", "_moment")) or name.startswith(("F_", "M")) for name in silent)
    assert 0 < (~np.isfinite(claims)).mean() < 0.02


def test_claims_hold_for_every_way_to_draw() -> None:
    """The compiled loop rounds otherwise than arrays, and a single position otherwise than both."""
    c = cycle_of("six-link")
    values = np.random.default_rng(7).uniform(135, 215, 60)
    if compiled.is_compiler_available():
        assert ratios(c, values, fast=True).size
    bounds, true = Claims(c).error_bounds_of_columns(values[:6]), truth(c, values[:6])
    for k, value in enumerate(values[:6]):
        drawing = draw_program(c.program, {**c.given, c.plans.drive_given_name: float(value)})
        single = np.array([column.read_from_drawing(drawing.things, drawing.tool.ar) for column in c.columns], float)
        assert not (errors(single[:, None], [(x[0][k : k + 1], x[1][k : k + 1]) for x in true]) > bounds[:, [k]]).any()


def test_claims_hold_at_the_scales_of_a_sheet() -> None:
    c = cycle_of("six-link")
    scaled = Cycle(c.plans, known=plan_scales(c.plans, {}, {}))
    assert np.median(ratios(scaled, np.linspace(140, 210, 40))) < 12


def test_arrays_may_round_more_often_than_a_tape() -> None:
    """They divide complex numbers otherwise: of two equal speeds a whole last place is left."""
    assert ratios(random_cycle(8000064, sliding=False), 173.69206220142857 + np.linspace(-1e-9, 1e-9, 101)).size


def test_claims_of_blocks_are_those_of_single_positions() -> None:
    c = cycle_of("kind-1-rrr")
    lengths = c.given["l_BC"] * np.linspace(1, 1.01, 9)
    many, values = Cycle(c.plans, known={"l_BC": lengths}), np.linspace(0, 359, 9)
    results = np.hstack([b.table for b in many.blocks(values, chunk=4, fast=False)])
    claims = np.hstack([many.decimal_error_bounds(values[k : k + 4], np.arange(k, min(k + 4, 9))) for k in (0, 4, 8)])
    for k in range(9):
        one = Cycle(c.plans, known={"l_BC": lengths[k]}).decimal_error_claims.error_bounds_of_columns(
            values[k : k + 1]
        )[:, 0]
        good = ~np.isnan(results[:, k])
        assert claims[good, k] == pytest.approx(one[good], rel=1e-6)


def test_a_long_table_is_written_with_its_claims(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scene, to = str(SAMPLES / "kind-1-rrr.yaml"), tmp_path / "table.csv"
    assert main(["cycle", scene, "--phi", "0:20:5", "-o", str(to), "--errors"]) == 0
    head, *rows = to.read_text(encoding="utf-8").splitlines()
    names = head.split(",")
    v, bound = names.index("v_C_x [m/s]"), names.index("± v_C_x [m/s]")
    assert len(rows) == 5 and all(0 < float(r.split(",")[bound]) < 1e-12 < abs(float(r.split(",")[v])) for r in rows)
    capsys.readouterr()
    assert main(["cycle", scene, "--errors", "--lang", "en"]) == 2
    assert "(-o FILE.csv" in capsys.readouterr().err


def test_chosen_columns_have_their_claims_in_python_and_in_a_table(tmp_path: Path) -> None:
    """A length, a position along a guide and an analogue among them: no curve is off by more than its ±."""
    scene, names = planes.load(SAMPLES / "six-link.yaml"), ["a_C", "s_5", "u_31", "phi_3", "F_12"]
    assert scene.mechanism
    plans, values = scene_plans(scene), np.linspace(150, 300, 7)
    turn = whole_turn_of(plans, names, slopes=False)
    rows, _ = turn.curve_rows(values, errors=True)
    shifted = WholeTurn(plans, turn.curves, slopes=False).sample_columns(values)
    for curve, row, off in zip(turn.curves, rows, rows[len(names) :], strict=False):
        assert (off > 0).all() and (off < 1e-9 * np.abs(row).max()).all(), curve.name
        rng = np.random.default_rng(1)
        bounds = {c.name: np.full(7, 1e-7) for _, run in turn.cycles_by_prefix for c in run.columns}
        bounds |= {UNIT_DRIVE_PREFIX + name: row for name, row in bounds.items()}
        spoilt = {name: x + 1e-7 * rng.uniform(-1, 1, 7) for name, x in shifted.items()}
        assert (np.abs(curve.read(spoilt) - row) <= curve.error_bounds_of_curve(shifted, bounds)).all(), curve.name
    table = planes.cycle(scene, ["a_C", "F_12"], phi=values, errors=True)
    assert table["± a_C_x"].max() < 1e-9 and list(table)[-1] == "± F_12_y" and table.plot().axes[0].lines
    to = tmp_path / "table.csv"
    assert main(["cycle", str(SAMPLES / "six-link.yaml"), "--show", "a_C,s_5", "--errors", "-o", str(to)]) == 0
    assert "± a_C [m/s²],± s_5 [m]" in to.read_text("utf-8")


@pytest.mark.slow
@pytest.mark.parametrize("seed", [4, 15, 21, 36])
def test_the_long_truth_is_that_of_fifty_digits(seed: int) -> None:
    """At random, and nearer to a limit than a millionth of a radian."""
    c = random_cycle(seed, sliding=False)
    near = close_to_limits(c, np.random.default_rng(seed)) if seed % 3 == 0 else np.array([10.0, 200.0])
    near = near[np.hstack([b.codes for b in c.blocks(near, fast=False)]) == 0][:3]
    true = truth(c, near)
    assert len(near)
    for k, value in enumerate(near):
        drawing = draw_program(c.program, {**c.given, c.plans.drive_given_name: float(value)}, Digits(50))
        mpf = drawing.tool.ar.mp.mpf  # type: ignore[attr-defined]
        for row, (column, claim) in enumerate(
            zip(c.columns, Claims(c).error_bounds_of_columns(near[k : k + 1])[:, 0], strict=True)
        ):
            exact = column.read_from_drawing(drawing.things, drawing.tool.ar)
            strays = float(abs(exact - mpf(float(true[row][0][k])) - mpf(float(true[row][1][k]))))
            assert strays <= 1e-8 * claim + 1e-28 * abs(float(exact)), column.name


def test_long_numbers_keep_thirty_digits() -> None:
    mp = pytest.importorskip("mpmath")
    rng, worst = np.random.default_rng(3), 0.0
    with mp.workdps(50):
        for op, args in (
            ("add", 2),
            ("sub", 2),
            ("mul", 2),
            ("inv", 1),
            ("sqrt", 1),
            ("hypot", 2),
            ("sin", 1),
            ("cos", 1),
            ("atan2", 2),
        ):
            known: Any = {"add": mp.fadd, "sub": mp.fsub, "mul": mp.fmul, "inv": lambda x: 1 / x}
            for _ in range(40):
                high = rng.uniform(-0.78, 0.78, args) if op != "sqrt" else rng.uniform(0, 2, args)
                pairs = [(np.float64(x), np.float64(x * 2.0**-54 * rng.uniform(-1, 1))) for x in high]
                exact = known.get(op, getattr(mp, op, None))(*(mp.mpf(float(a)) + mp.mpf(float(b)) for a, b in pairs))
                found = TWO_OPS[op](*pairs)
                off = abs(exact - mp.mpf(float(found[0])) - mp.mpf(float(found[1])))
                worst = max(worst, float(off / max(abs(exact), 0.1)))
    assert 0 < worst < 1e-30


def test_no_operation_loses_more_than_it_is_said_to() -> None:
    """Of every operation of a tape: its rounding, told by numbers of twice the digits, and its usual size."""
    squares: dict[str, list[float]] = {}
    for seed in (2, 4, 8, 12):
        c = random_cycle(seed, sliding=False)
        tape, order = c.trace.tape, c.trace.tape.places_needed(list(c.trace.outputs))
        values = np.random.default_rng(seed).uniform(0, 360, 50)
        found = numbers_at_places(tape, order, {**given_values_by_name(c.given), c.plans.drive_given_name: values})
        whole = whole_number_places(tape, order)
        for place in order:
            op, args = tape.ops[place]
            if op not in EXACT_OPERATIONS:
                with np.errstate(all="ignore"):
                    said = rounding_error_of(tape, place, found, whole)
                    half = np.zeros(1) if said is None else np.asarray(said)
                    exact = TWO_OPS[op](*((found[a], np.zeros_like(found[a])) for a in args))
                    off = apart(found[place], exact)
                    assert not (off > LARGEST_ROUNDING_HALVES.get(op, 1.0) * half * (1 + 1e-12)).any(), op
                    part = np.atleast_1d(off / np.where(half > 0, half, np.nan))
                squares.setdefault(op, []).extend(part[np.isfinite(part)] ** 2)
    for op in ("add", "sub", "mul", "inv", "sin", "cos", "hypot", "atan2"):
        assert 0.3 < math.sqrt(3 * np.mean(squares[op])) / USUAL_ROUNDING_UNITS.get(op, 1.0) < 1.06, op


@pytest.mark.few(3)
@pytest.mark.parametrize("op", ["mul", "inv", "sqrt", "hypot", "sin", "cos", "atan2", "abs", "max", "min"])
def test_no_operation_is_more_bent_than_it_is_said_to_be(op: str) -> None:
    """f(a + d) - f(a) - slope·d, wherever within its reach d falls: tried where slopes are good and where they fail."""
    rng, count = np.random.default_rng(11), 4000
    arity = 1 if op in ("inv", "sqrt", "sin", "cos", "abs") else 2
    args = [rng.uniform(-1, 1, count) * 10.0 ** rng.uniform(-3, 0, count) for _ in range(arity)]
    reach = tuple(np.abs(a) * 10.0 ** rng.uniform(-4, 1, count) for a in args)
    args = [np.abs(a) for a in args] if op == "sqrt" else args
    offs = [d * rng.choice([-1, 1, 0.5, -0.7, 0.999], count) for d in reach]
    with np.errstate(all="ignore"):
        z, moved = ARRAY_OPERATIONS[op](*args), ARRAY_OPERATIONS[op](*(a + d for a, d in zip(args, offs, strict=True)))
        lost, parts = linearisation_remainder(op, z, tuple(args), reach)
        straight = z + sum(part * d for part, d in zip(parts, offs, strict=True))
        assert not (np.abs(moved - straight) > lost + 1e-12 * (1 + np.abs(z))).any()
    if op not in ("abs", "max", "min"):
        small = [r < 1e-3 * np.abs(a) for r, a in zip(reach, args, strict=True)]
        assert np.median(lost[np.all(small, axis=0)] / np.abs(z[np.all(small, axis=0)])) < 1e-5


@pytest.mark.slow
def test_claims_hold_on_the_way_to_a_dead_point() -> None:
    mechanism = load(str(SAMPLES / "six-link.yaml")).mechanism
    assert mechanism
    way = approach_nearest_limit(plans_of(mechanism))
    assert way is not None and float(way.limit.value) == pytest.approx(129.5273973697464)
    for key in ("method_scalar", "method_batch", "method_compiled"):
        errors = way.errors.get(key, way.errors["method_batch"])
        assert (np.isnan(errors) | (errors <= way.claim)).all()
        assert np.nanmedian(way.errors["method_newton"] / errors) > 1.5  # with exact derivatives, better now and then
    assert (way.claim[way.distances > 1e-6] < 1e-8).all()


@pytest.mark.few(2)
@pytest.mark.parametrize("name", KIND_SAMPLES)
def test_spread_of_a_pencil_is_that_of_many_draughtsmen(name: str) -> None:
    c = cycle_of(name)
    mus = plan_scales(c.plans, {}, {})
    position = c.plans.mechanism.drive.position
    pencil, many = Pencil(point_mm=0.03, ray_deg=0.03, ruler_mm=0.05), 3000
    carried = Spread(c, pencil, mus).error_bounds_of_columns(np.array([position]))[:, 0]
    given = {**c.given, **mus, c.plans.drive_given_name: np.full(many, position)}
    drawing = draw_program(c.program, given, pencil)
    for column, spread in zip(c.columns, carried, strict=True):
        seen = np.std(np.broadcast_to(column.read_from_drawing(drawing.things, drawing.tool.ar), (many,)))
        if np.isfinite(seen) and seen > 1e-12:
            assert spread == pytest.approx(seen, rel=0.25), column.name


FAR_GUIDE = """\
planes: 1
frame: {{points: {{A: [0, 0], D: [0.3, 0.1]}}}}
links:
  1: {{points: {{A: 0, B: 0.1}}}}
  2: {{points: {{B: 0}}, slides: g}}
  3: {{points: {{D: 0, E: [0.11, 0.13]}}, guides: {{g: {{through: [{x!r}, {y!r}], angle: {angle!r}}}}}}}
assembly: {{g: ahead}}
drive: {{link: 1, phi: 359.976493, omega: 10.1, epsilon: 3.3}}
"""


@pytest.mark.few(1)
@pytest.mark.parametrize("seed", range(31, 37))
def test_claims_hold_and_are_close_for_the_numbers_as_a_scene_writes_them(seed: int) -> None:
    c, rng = random_cycle(seed, sliding=False), np.random.default_rng(seed)
    places = [np.round(rng.uniform(0, 360, 10), 6), close_to_limits(c, rng, 1e-3)[:10]]
    error, claimed = (np.hstack(x) for x in zip(*(beside_text(c, x) for x in places if len(x)), strict=True))
    assert not (error > claimed).any()
    sure = (error > 0) & np.isfinite(claimed)
    assert np.median(claimed[sure] / error[sure]) < 11


@pytest.mark.parametrize("far", [0.1, 10.0, 1e3, 1e6])
def test_claims_hold_for_a_guide_through_a_far_point(far: float) -> None:
    x, y = far * math.cos(0.7), far * math.sin(0.7) + 0.013
    c = Cycle(plans_of(loads(FAR_GUIDE.format(x=x, y=y, angle=math.degrees(0.7))).mechanism))  # type: ignore[arg-type]
    error, claimed = beside_text(c, np.array([359.976493, 12.3, 77.7]))
    assert not (error > claimed).any()
    short = error > Claims(c).error_bounds_of_columns(np.array([359.976493, 12.3, 77.7]))
    assert short.any()  # what is counted from the doubles on alone is too little
