"""What is done near a dead point when asked: smaller scales, values from neighbours; and always said."""

from __future__ import annotations

from pathlib import Path

import pytest

from planes.cli import main
from planes.scene import load, loads
from planes.solving import solve
from planes.solving.remedies import remedy_positions
from tests.helpers import ROOT

SIX = str(ROOT / "samples" / "six-link.yaml")
PARALLELOGRAM = """
planes: 1
frame: {points: {A: [0, 0], D: [0.3, 0]}}
links:
  1: {points: {A: 0, B: 0.1}}
  2: {points: {B: 0, C: 0.3}, mass: 1}
  3: {points: {D: 0, C: 0.1}, mass: 1}
assembly: {C: left}
drive: {link: 1, phi: 60, omega: 10}
gravity: 9.81
"""


def test_a_plan_that_does_not_fit_gets_a_smaller_scale() -> None:
    solved = solve(load(SIX), [129.6, 150.0])
    assert solved.positions[0].scales["mu_velocity"] == 30
    remedy_positions(solved)
    blunt, sharp = solved.positions
    assert blunt.scales["mu_velocity"] == 2.5 and sharp.scales["mu_velocity"] == 30
    assert any("it is drawn at μ = 2.5 mm/(m/s)" in w for w in blunt.results["warnings"])
    assert "remedied" not in sharp.results


def test_a_change_point_is_carried_on_from_the_side_the_driver_comes() -> None:
    solved = solve(loads(PARALLELOGRAM), [180.0, 90.0])
    assert len(solved.failed) == 1
    remedy_positions(solved)
    p, _ = solved.positions
    assert not solved.failed and p.results["interpolated"] == [170.0, 175.0]
    assert p.results["links"]["3"]["omega"] == pytest.approx(10)
    assert p.results["links"]["1"]["angle_deg"] == pytest.approx(180)
    assert p.results["points"]["C"]["r"] == pytest.approx([0.2, 0], abs=1e-3)
    assert p.value("r_C") == p.r["C"] == complex(*p.results["points"]["C"]["r"])
    assert p.value("phi_1") == p.results["links"]["1"]["angle_deg"]
    assert "extrapolated from 170° and 175°" in p.results["warnings"][0]


@pytest.mark.parametrize("values", [[190.0, 180.0, 170.0], [180.0, 20.0, 0.0, 90.0]])
def test_positions_stay_in_the_order_they_were_asked_in(values: list[float]) -> None:
    solved = solve(loads(PARALLELOGRAM), values)
    failed = [f["phi_deg"] for f in solved.failed]
    assert failed and [p.at for p in solved.positions] == [v for v in values if v not in failed]
    remedy_positions(solved)
    assert [p.at for p in solved.positions] == [p.results["phi_deg"] for p in solved.positions] == values


def test_beyond_a_limit_of_assembly_nothing_is_made_up() -> None:
    solved = solve(load(SIX), [129.0])
    remedy_positions(solved)
    assert len(solved.failed) == 1 and not solved.positions


@pytest.mark.slow
def test_commands_say_what_was_done(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scene = tmp_path / "p.yaml"
    scene.write_text(PARALLELOGRAM, encoding="utf-8")
    assert main(["solve", str(scene), "--phi", "180", "--lang", "ru"]) == 2
    assert main(["solve", str(scene), "--phi", "180", "--remedy", "--errors", "--lang", "ru"]) == 0
    assert "продолжены с 170° и 175°" in capsys.readouterr().out
    out = tmp_path / "o.svg"
    assert main(["sheet", str(scene), "--phi", "180", "--remedy", "-o", str(out), "--lang", "en"]) == 0
    assert "the neighbouring position 175° is drawn instead" in capsys.readouterr().err and out.exists()
    assert main(["sheet", SIX, "--phi", "129.6", "--remedy", "-o", str(out), "--lang", "en"]) == 0
    assert "drawn at μ = 2.5 mm/(m/s)" in capsys.readouterr().err
