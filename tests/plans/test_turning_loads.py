"""Bodies and trusses whose loads follow laws of an angle: every position against equations of equilibrium."""

from __future__ import annotations

import json
import math
import random
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml

import planes
from planes.cli import main
from planes.lesson.data import lesson_data
from planes.scene import loads
from planes.solving import solve
from tests.helpers.equilibrium import members, reactions
from tests.helpers.page_tape import PageTape
from tests.plans.test_structures import KINDS, arched, beam, chained, clamped, girder, three_rods

ANGLES = [float(k) for k in range(-180, 181, 24)]
ROPE = """planes: 1
points: {A: [0, 0], B: [2, 0], C: [1, 0], E: [2, 2]}
supports: {A: hinge, B: {rope: E}}
drive: {phi: %s}
loads: [{point: C, force: 2000, direction: phi - 90}]
"""


def turned(text: str, r: random.Random) -> tuple[dict[str, Any], list[dict[str, tuple[float, ...]]]]:
    """A scene whose loads are laws, some of them zero at the angle of the file; and the numbers in the laws."""
    scene, numbers = yaml.safe_load("planes: 1\n" + text), []
    scene["drive"] = {"phi": 0}
    scene.pop("method", None)
    for load in scene["loads"]:
        own = {}
        for key in ("force", "moment", "direction"):
            if key in load and not ("from" in load and key == "direction"):  # a distributed load does not turn
                a, b, c = (r.uniform(1, 9), r.uniform(1, 9), r.uniform(-180, 180))
                a, c = (0.0, 0.0) if r.random() < 0.3 and key != "direction" else (a, c)  # zero at φ = 0
                own[key] = (load[key], r.choice([1, 3]) * 30, 0) if key == "direction" else (a, b, c)
                base, swing, start = own[key]
                load[key] = f"{base!r} + {swing!r}*sin(phi + {start!r})"
        numbers.append(own)
    return scene, numbers


def at(scene: dict[str, Any], numbers: list[dict[str, tuple[float, ...]]], phi: float) -> str:
    """The same scene at one angle, with plain numbers."""
    still = {k: v for k, v in scene.items() if k != "drive"}
    still["loads"] = [
        {**load, **{k: a + b * math.sin(math.radians(phi + c)) for k, (a, b, c) in own.items()}}
        for load, own in zip(scene["loads"], numbers, strict=True)
    ]
    return yaml.safe_dump(still)


def agrees(text: str, r: random.Random, truss: bool = False) -> None:
    """A cycle, and some positions alone, against linear equations at each angle, to 1e-12 of the largest force."""
    scene, numbers = turned(text, r)
    made = loads(yaml.safe_dump(scene))
    table = planes.cycle(made, phi=np.array(ANGLES))
    assert not table.failed.any(), table.failed
    for k, phi in enumerate(ANGLES):
        truth: dict[str, complex] = {**reactions(at(scene, numbers, phi))}
        truth |= members(at(scene, numbers, phi)) if truss else {}
        most = max(1.0, *map(abs, truth.values()))
        (alone,) = solve(made, [phi]).positions if k % 5 == 0 else (None,)
        for name, z in truth.items():
            scalar = name in table
            own = table[name][k] if scalar else complex(table[f"{name}_x"][k], table[f"{name}_y"][k])
            assert abs(own - z) <= 3e-12 * most if truss else abs(own - z) <= 1e-12 * most, (phi, name, own, z)
            if alone:
                assert abs(complex(alone.value(name)) - z) <= 3e-12 * most, (phi, name)


MADE = [arched, beam, three_rods, clamped, chained]


@pytest.mark.parametrize("make", MADE)
def test_every_position_is_in_equilibrium(make: Any) -> None:
    r = random.Random(f"turning {make.__name__}")
    for _ in range(3):
        agrees(make(r, "moments"), r)


def test_members_of_a_truss_turn_with_its_loads() -> None:
    """Among them loads that are zero at the angle of the file, where a truss alone leaves them out."""
    r = random.Random("turning girder")
    for _ in range(3):
        agrees(girder(r), r, True)


@pytest.mark.slow
@pytest.mark.parametrize("make", MADE)
def test_sixty_of_each_kind_turn(make: Any) -> None:
    r = random.Random(f"many turning {make.__name__}")
    for _ in range(60):
        agrees(make(r, "moments"), r)


@pytest.mark.slow
def test_sixty_trusses_turn() -> None:
    r = random.Random("many turning girders")
    for _ in range(60):
        agrees(girder(r), r, True)


@pytest.mark.parametrize(("make", "method"), [k for k in KINDS if k[1] in ("string", "three-forces", "culmann")])
def test_a_named_method_gives_the_same_or_says_why_not(make: Any, method: str) -> None:
    r = random.Random(f"named {make.__name__} {method}")
    scene, numbers = turned(make(r, method), r)
    solved = solve(loads(yaml.safe_dump(scene | {"method": method, "drive": {"phi": 5}})), ANGLES)
    for p in solved.positions:
        truth = reactions(at(scene, numbers, p.at))
        most = max(map(abs, truth.values()))
        assert all(abs(complex(p.value(n)) - z) <= 1e-9 * most for n, z in truth.items())
    assert all("method: moments" in one["error"] for one in solved.failed)


@pytest.mark.parametrize("here", ["30", "180"])
def test_a_rope_that_would_push_fails_its_positions_alone(here: str) -> None:
    """The load turns by 360°; the rope pulls while it points below the hinge, whatever angle the file gives."""
    scene = loads(ROPE % here)
    solved = solve(scene, [0.0, 60.0, 120.0, 180.0])
    assert [p.at for p in solved.positions] == [0.0, 60.0]
    assert [one["phi_deg"] for one in solved.failed] == [120.0, 180.0]
    assert all("rope BE would have to push" in one["error"] for one in solved.failed)
    table = planes.cycle(scene, phi=np.arange(-180.0, 181.0, 15.0))
    pulls = np.abs(table["phi"]) <= 90
    assert ((table.failed == "") == pulls).all()
    assert all(np.isfinite(table[n][pulls]).all() and np.isnan(table[n][~pulls]).all() for n in table if n != "phi")
    assert planes.extremes(scene)["assembles"] == [[pytest.approx(-90, abs=1e-6), pytest.approx(90, abs=1e-6)]]


def test_a_result_alone_is_refused_where_the_rope_pushes() -> None:
    scene = loads(ROPE % "30" + "find: [P_C]\n")
    assert [one["phi_deg"] for one in solve(scene, [0.0, 120.0]).failed] == [120.0]


def test_the_slider_of_a_lesson_says_where_the_rope_pushes() -> None:
    exported = lesson_data(loads(ROPE % "30"))
    assert exported["drive"]["to"] - exported["drive"]["from"] == 360.0
    rope = next(h for h in exported["holds"] if "rope BE" in h["said"]["en"])
    assert [bool(PageTape(exported, phi).numbers[rope["at"]]) for phi in (0.0, 89.0, 91.0, 200.0)] == [1, 1, 0, 0]


def test_a_beam_with_inclined_loads_states_no_bending_moments() -> None:
    text = "points: {A: [0, 0], B: [4, 0], C: [1, 0]}\nsupports: {A: hinge, B: roller}\nmethod: string\n"
    text = "planes: 1\ndrive: {phi: 0}\n" + text + "loads: [{point: C, force: 5, direction: %s}]\n"
    assert "M_C" not in solve(loads(text % "phi - 90")).positions[0].of("values")
    assert "M_C" in solve(loads(text.replace("force: 5", "force: 5*cos(phi)") % "-90"), [30.0]).positions[0].of(
        "values"
    )


def test_parallel_lines_are_no_matter_for_moments() -> None:
    """Two rollers after the one across: moments are taken about a meeting of two lines that do meet."""
    text = "planes: 1\npoints: {A: [0, 0], B: [4, 0], C: [0, 1]}\nsupports: {C: {roller: 0}, A: roller, B: roller}\n"
    (position,) = solve(loads(text + "loads: [{moment: 8}, {point: C, force: 3, direction: 180}]\n")).positions
    assert position.value("R_C") == pytest.approx(3 + 0j)
    assert position.value("R_B") == pytest.approx(-2j)  # the couple alone: load and R_C are on one line


def test_the_cycle_has_extremes_and_diagrams(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scene = tmp_path / "rope.yaml"
    scene.write_text(ROPE % "30", "utf-8")
    assert main(["cycle", str(scene), "--lang", "en"]) == 0
    told = capsys.readouterr().out
    assert "Can be drawn for φ = -90°…90°" in told and "S_BE" in told and "W =" not in told
    assert main(["cycle", str(scene), "--json"]) == 0
    curves = json.loads(capsys.readouterr().out)["curves"]
    assert max(e["value"] for e in curves["S_BE"]["extremes"]) == pytest.approx(1000, rel=1e-9)
    assert main(["cycle", str(scene), "-o", str(tmp_path / "c.svg"), "--lang", "en"]) == 0
    assert ">BE<" in (tmp_path / "c.svg").read_text("utf-8")
    assert main(["cycle", str(scene), "-o", str(tmp_path / "c.gif"), "--lang", "en"]) == 2
    assert "has no mechanism" in capsys.readouterr().err
