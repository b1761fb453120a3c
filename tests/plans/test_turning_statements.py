"""Stated vectors and loads that go by an angle: every value against its closed form, at one angle and in a table."""

from __future__ import annotations

import csv
import math
from pathlib import Path

import pytest

from planes.cli import main
from planes.lesson.told import SceneLesson
from planes.scene import loads
from planes.solving import solve
from planes.words.errors import SceneError
from tests.helpers.equilibrium import reactions

TURNING = """planes: 1
title: {ru: Поворот, en: Turning}
drive: {phi: 40}
parameters: {l: 0.1, w: 20}
vectors:
  v_B: {value: w*l, direction: phi + 90}
  v_CB: {direction: 100 - 20*sin(phi)}
  v_C: {direction: 0}
equations: ["v_C = v_B + v_CB"]
"""
CRANE = """planes: 1
drive: {phi: 30}
points: {A: [0, 0], B: [4, 0], C: [3, 0], E: [0, 2]}
bodies: {1: [A, C, B]}
supports: {A: hinge, B: {rod: E}}
loads: [{point: C, force: %s, direction: %s}]
"""
LOAD = "{over: phi, table: [[0, 1000], [90, 2000], [180, 1000]]}", "-60 - phi/2"


def velocities(phi: float) -> tuple[complex, complex, complex]:
    """v_B, v_CB, v_C by hand: v_C is along x, so v_CB takes away what v_B has across."""
    v_b = 2.0 * complex(-math.sin(math.radians(phi)), math.cos(math.radians(phi)))
    line = math.radians(100 - 20 * math.sin(math.radians(phi)))
    v_cb = -v_b.imag / math.sin(line) * complex(math.cos(line), math.sin(line))
    return v_b, v_cb, v_b + v_cb


def test_stated_vectors_turn() -> None:
    angles = [0.0, 17.5, 40.0, 133.0, 271.0]
    solved = solve(loads(TURNING), angles)
    assert [p.results["phi_deg"] for p in solved.positions] == angles
    for phi, p in zip(angles, solved.positions, strict=True):
        for name, v in zip(("v_B", "v_CB", "v_C"), velocities(phi), strict=True):
            assert abs(p.of("vectors")[name].vector - v) < 1e-14


def test_loads_turn_and_go_by_a_table() -> None:
    for phi in (0.0, 30.0, 77.0, 100.0):
        (position,) = solve(loads(CRANE % LOAD), [phi]).positions
        force = 1000 + 1000 * (1 - abs(90 - phi) / 90)
        truth = reactions(CRANE % (repr(force), repr(-60 - phi / 2)))
        for name, z in truth.items():
            assert abs(position.of("vectors")[name].vector - z) < 1e-12 * 3000, (phi, name)


def test_a_table_of_them_is_written(tmp_path: Path) -> None:
    scene, table = tmp_path / "turning.yaml", tmp_path / "turning.csv"
    scene.write_text(TURNING, "utf-8")
    assert main(["cycle", str(scene), "--phi", "0:360:45", "-o", str(table)]) == 0
    rows = list(csv.DictReader(table.read_text("utf-8-sig").splitlines()))
    assert len(rows) == 9
    for row in rows:
        v = velocities(float(row["phi [°]"]))[2]
        assert float(row["v_C_x [m/s]"]) == pytest.approx(v.real, abs=1e-13)
    assert main(["sheet", str(scene), "--phi", "60", "-o", str(tmp_path / "s.svg")]) == 0
    assert main(["cycle", str(scene), "--phi", "0:360:45", "-o", str(tmp_path / "c.png")]) == 0


def test_a_lesson_of_them_turns_by_its_slider() -> None:
    drive = SceneLesson.of(loads(CRANE % LOAD)).drive
    assert drive["to"] - drive["from"] == 360.0 and drive["at"] == 30.0
    assert SceneLesson.of(loads(CRANE % ("1000", "-60"))).drive["to"] == 30.0  # nothing goes by it


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("phi + 90", "psi + 90", "is not defined"),
        ("{phi: 40}", "{phi: 40, omega: 3}", "omega"),
        ("drive: {phi: 40}\n", "", "phi"),
        ("w*l", "{over: phi, table: [[0, 1], [360, 2]]}", "turn"),
    ],
)
def test_what_cannot_turn_is_refused(old: str, new: str, said: str) -> None:
    with pytest.raises(SceneError) as refusal:
        solve(loads(TURNING.replace(old, new)))
    assert said in refusal.value.told("en")
