"""On the way to a limit no number is wrong without a word: ``solve`` warns, a table leaves it out, or it is refused."""

from __future__ import annotations

import csv
import math
import random
from pathlib import Path

import numpy as np
import pytest

from planes.batch.cycle import Cycle
from planes.cli import main
from planes.scene import load, loads
from planes.solving import plans_and_requested_results, solve
from planes.solving.tables import solve_report_text
from tests.helpers.near_limits import FAMILIES, HIGHER, case, walk

SLOT = """\
planes: 1
parameters: {r: 0.2, d: 0.2}
frame: {points: {O: [0, 0], B: [d, 0]}}
links:
  1: {points: {O: 0, A: r}}
  2: {points: {A: 0}, slides: BC}
  3: {points: {B: 0, C: 0.5}, guides: {BC: {through: B, angle: 0}}}
assembly: {BC: ahead}
drive: {link: 1, phi: 60, omega: 10, epsilon: 3}
"""
FAINT = """\
planes: 1
frame: {points: {C: [-76465.1, -25981.4]}, guides: {g0: {through: [94942.6, -4617.5], angle: -113.9}}}
links:
  3: {points: {D: 0, B: 331866.8}}
  1: {points: {A: 0, B: 76928.2, S1: {r: 77149.7, angle: -168.5}}, slides: g0, mass: 775641, inertia: 2.68e+17,
      centre: S1}
  2: {points: {C: 0, D: 185194.7}}
assembly: {D: right}
drive: {link: 1, s: 208781.2, velocity: 150773240.0, acceleration: -70990062700.0}
loads: [{link: 3, point: B, force: 0.017, direction: 177.7}, {link: 2, point: C, force: 0.03, direction: 169.6}]
"""
EATEN = """\
planes: 1
frame: {points: {O: [0, 0]}, guides: {x-x: {through: O, angle: 0}}}
links:
  1: {points: {O: 0, A: 0.1}}
  2: {points: {A: 0, B: 0.4}}
  3: {points: {B: 0}, slides: x-x}
assembly: {B: ahead}
drive: {link: 1, phi: 60, omega: 10}
loads: [{link: 3, point: B, force: 1e+17, direction: 0}, {link: 3, point: B, force: 0.3, direction: 0},
  {link: 3, point: B, force: 1e+17, direction: 180}]
"""


@pytest.mark.few(0)
@pytest.mark.parametrize("family", FAMILIES)
def test_no_number_near_a_limit_is_wrong_without_a_word(family: str) -> None:
    found = walk(family, 0, 20)
    silent = {k: found[k] for k in ("invented", "unsaid", "arrays wrong", "compiled wrong")}
    assert not any(silent.values()), silent
    assert found["arrays left out"] <= 0.25 * found["arrays numbers"], "a table leaves out more than it must"


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("family", HIGHER)
def test_no_number_near_a_dead_point_of_a_higher_class_is_wrong_without_a_word(family: str) -> None:
    found = walk(family, 0, 12) + walk(family, 21, 12)
    assert found["absent"] and found["positions"] - found["absent"] > found["refused"]
    silent = {k: found[k] for k in ("invented", "unsaid", "arrays wrong", "compiled wrong")}
    assert not any(silent.values()), silent


@pytest.mark.needs("llvmlite")
@pytest.mark.few(1)
@pytest.mark.parametrize("family", FAMILIES)
def test_tables_by_arrays_and_compiled_leave_out_the_same(family: str) -> None:
    text, values = case(family, random.Random(7), 60)
    c = Cycle(plans_and_requested_results(loads(text))[0])
    (one,), (two,) = (list(c.blocks(values, fast=fast)) for fast in (False, True))
    assert (np.isnan(one.table) != np.isnan(two.table)).mean() < 0.02  # bounds on the very edge may fall to either side
    assert ((one.codes != 0) == (two.codes != 0)).mean() > 0.95


@pytest.mark.parametrize("value, warned", [(5.729577951308232e-05, True), (0.003, True), (1.0, False), (60.0, False)])
def test_a_slotted_lever_near_its_pivot_says_what_it_does_not_know(value: float, warned: bool) -> None:
    for lang, words in (("en", "ε_2, ε_3: rounding leaves"), ("ru", "меньше трёх верных цифр")):
        said = solve(loads(SLOT), [value], None, lang).positions[0].results["warnings"]  # type: ignore[arg-type]
        assert any(words in w for w in said) == warned


def test_a_force_that_is_nothing_beside_others_is_warned_of() -> None:
    (position,) = solve(loads(FAINT)).positions
    inertia = 775641 * 70990062700
    assert math.hypot(*position.results["reactions"]["F_10"]["force"]) < 1e-15 * inertia  # to within rounding
    assert any("F_10: zero to within rounding, no digit of it is certain" in w for w in position.results["warnings"])
    assert not solve(loads(FAINT + "find: [F_20]\n")).positions[0].results["warnings"]


@pytest.mark.parametrize("fast", [False, pytest.param(True, marks=pytest.mark.needs("llvmlite"))])
def test_a_table_leaves_out_a_force_that_is_nothing_beside_others(fast: bool) -> None:
    for names in (None, ["F_10"], ["F_20"]):
        c = Cycle(plans_and_requested_results(loads(FAINT))[0], names)
        (block,) = c.blocks([208781.2, 208785.2], fast=fast)
        empty = {x.name for x, row in zip(c.columns, block.table, strict=True) if np.isnan(row).all() and not x.beside}
        faint = {None: ["F_23", "F_10"], "F_10": ["F_10"], "F_20": []}[names and names[0]]  # F_23 is nothing in truth
        assert empty == {f"{force}_{part}" for force in faint for part in "xy"}
        assert block.failed_mask.all() == bool(faint)


@pytest.mark.parametrize("r, value", [(0.8648274175113996, -6.124416584198899e-07), (0.8648274175113996, 1e-6)])
def test_rounding_is_no_contradiction_near_a_pivot(r: float, value: float) -> None:
    scene = SLOT.replace("{r: 0.2, d: 0.2}", f"{{r: {r}, d: {r}}}")
    (position,) = solve(loads(scene), [value]).positions
    assert any("less than three correct digits" in w for w in position.results["warnings"])


def test_the_drivers_own_rates_are_printed_beside_whatever_else(capsys: pytest.CaptureFixture[str]) -> None:
    print(solve_report_text(solve(loads(SLOT), [1e-12])))
    row = next(line for line in capsys.readouterr().out.splitlines() if line.startswith("  1  "))
    assert row.split() == ["1", "1·10⁻¹²", "10", "3"]


def test_a_position_that_does_not_work_names_its_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scene = tmp_path / "slot.yaml"
    scene.write_text(SLOT, encoding="utf-8")
    assert main(["solve", str(scene), "--phi", "0"]) == 2
    assert capsys.readouterr().err.startswith(f"{scene}: at φ = 0°: ")


def test_a_table_file_leaves_out_what_has_no_digits(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scene, out = tmp_path / "slot.yaml", tmp_path / "t.csv"
    scene.write_text(SLOT, encoding="utf-8")
    assert main(["cycle", str(scene), "--phi", "0.003:60.003:20", "-o", str(out)]) == 0
    assert "no correct digit is left in a_C_x, epsilon_2, epsilon_3" in capsys.readouterr().err
    first, *others = csv.DictReader(out.read_text(encoding="utf-8").splitlines())
    assert first["epsilon_3 [rad/s²]"] == "" and first["failed"] == "no_digits"
    assert first["omega_3 [rad/s]"] and all(row["epsilon_3 [rad/s²]"] and not row["failed"] for row in others)


@pytest.mark.parametrize("size", ["1e12", "-3e11"])
def test_sizes_too_different_to_reckon_with_are_warned_of(size: str) -> None:
    far = SLOT.replace("O: [0, 0], B: [d, 0]", f"O: [{size}, 0], B: [{size} + 0.1, 0]")
    (position,) = solve(loads(far)).positions
    assert any("less than three correct digits" in w for w in position.results["warnings"])
    (block,) = Cycle(plans_and_requested_results(loads(far))[0]).blocks([60.0, 70.0], fast=False)
    assert np.isnan(block.table).any(axis=0).all() and block.codes.all()


@pytest.mark.parametrize("fast", [False, pytest.param(True, marks=pytest.mark.needs("llvmlite"))])
def test_a_force_that_rounding_makes_exactly_nothing_is_left_out_of_a_table(fast: bool) -> None:
    c = Cycle(plans_and_requested_results(loads(EATEN))[0], ["F_23"])
    (block,) = c.blocks(np.linspace(50.0, 60.0, 16), fast=fast)
    assert block.failed_mask.all() and np.isnan(block.table).all()


def test_a_force_no_load_reaches_is_exactly_nothing() -> None:
    c = Cycle(
        plans_and_requested_results(load(Path(__file__).parents[2] / "samples" / "assignment-12.yaml"))[0],
        ["F_50", "F_45"],
    )
    (block,) = c.blocks([60.0, 61.0], fast=False)
    row = [x.name for x in c.columns].index("F_50_y")
    assert not block.failed_mask.any() and (block.table[row] == 0).all() and len(c.force_ends) == 1
