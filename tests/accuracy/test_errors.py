"""Results with their ±: in the shape of the results, never less than the truth, and only when asked."""

from __future__ import annotations

import json
import subprocess
import sys
from typing import Any

import numpy as np
import pytest

from planes.accuracy.digits import Digits
from planes.accuracy.errors import add_errors_to_results
from planes.batch.cycle import Cycle
from planes.cli import main
from planes.drafting.drawing import draw_program
from planes.drafting.instruments import Pencil
from planes.plans.measuring import DrawingReader
from planes.plans.quantities import nested_json, results_with_intermediates
from planes.scene import load
from planes.solving import solve
from tests.helpers import ROOT

SAMPLES = ROOT / "samples"
NAMES = ["six-link", "sliding-driver", *(f"kind-{k}" for k in ("1-rrr", "2-rrp", "3-rpr", "4-prp", "5-rpp"))]


def leaves(thing: Any, way: tuple[str, ...] = ()) -> dict[tuple[str, ...], Any]:
    if isinstance(thing, dict):
        return {k: v for key, x in thing.items() for k, v in leaves(x, (*way, key)).items()}
    if isinstance(thing, list):
        return {k: v for i, x in enumerate(thing) for k, v in leaves(x, (*way, str(i))).items()}
    return {way: thing}


@pytest.mark.parametrize("name", NAMES)
def test_errors_have_the_shape_of_results_and_hold(name: str) -> None:
    scene = load(str(SAMPLES / f"{name}.yaml"))
    solved = solve(scene)
    add_errors_to_results(solved)
    (p,) = solved.positions
    errors = leaves(p.results["errors"])
    found = {k: v for k, v in leaves(p.results).items() if k[0] not in ("phi_deg", "s", "warnings", "errors", "plans")}
    assert {k for k in found if k[-1] != "guide"} == {k for k in errors if k[0] != "plans"}
    given = {**p.plans.given, **p.scales, p.plans.drive_given_name: p.at}
    reader = Exactly(p.plans, draw_program(p.plans.program, given, Digits(50)), p.scales)
    truth = leaves(nested_json(map(reader.read_quantity, results_with_intermediates(p.plans))))
    for way, error in errors.items():
        if way[0] != "plans" and found[way] is not None:
            assert abs(found[way] - truth[way]) <= error <= 1e-9, way
    for plan, drawn in p.results["plans"].items():
        for key, segment in drawn["segments"].items():
            mm = p.results["errors"]["plans"][plan]["segments"][key]["mm"]
            assert segment["error_mm"] == mm < 1e-9


def test_one_position_and_a_table_have_the_same_errors() -> None:
    solved = solve(load(str(SAMPLES / "six-link.yaml")))
    add_errors_to_results(solved)
    (p,) = solved.positions
    cycle = Cycle(solved.plans, known=p.scales)
    rows = cycle.decimal_error_bounds(np.array([p.at, p.at + 1.0]), np.arange(2))
    bounds = dict(zip((c.name for c in cycle.columns), rows[:, 0], strict=True))
    points = p.results["errors"]["points"]
    assert all(max(points[name]["v"]) > 0 for name in "BCH")
    for name, told in points.items():
        for kind, pair in told.items():
            assert pair == pytest.approx([bounds[f"{kind}_{name}_{axis}"] for axis in "xy"], rel=1e-9), (name, kind)


class Exactly(DrawingReader):
    """Reads a drawing of long numbers and loses none of them."""

    def finite_number(self, value: Any, name: str) -> Any:
        return value


def test_a_pencil_says_how_far_apart_draughtsmen_end() -> None:
    scene = load(str(SAMPLES / "six-link.yaml"))
    solved = solve(scene, None, Pencil())
    crowd = {k: s["error_mm"] for k, s in solved.positions[0].results["plans"]["velocity"]["segments"].items()}
    add_errors_to_results(solved, Pencil())
    carried = {k: s["error_mm"] for k, s in solved.positions[0].results["plans"]["velocity"]["segments"].items()}
    for key, seen in crowd.items():
        assert carried[key] ** 2 == pytest.approx(seen**2 + 0.5**2 / 12, rel=0.35), key


def test_errors_are_printed_when_asked(capsys: pytest.CaptureFixture[str]) -> None:
    path = str(SAMPLES / "six-link.yaml")
    assert main(["solve", path, "--json"]) == 0
    plain = json.loads(capsys.readouterr().out)["positions"][0]
    assert main(["solve", path, "--json", "--errors"]) == 0
    told = json.loads(capsys.readouterr().out)["positions"][0]
    assert "errors" not in plain and set(told) - set(plain) == {"errors"}
    assert {k: v for k, v in told.items() if k not in ("errors", "plans")} == {
        k: v for k, v in plain.items() if k != "plans"
    }
    assert main(["solve", path, "--errors", "--lang", "en"]) == 0
    text = capsys.readouterr().out
    assert "v, m/s" in text and "±" in text and "± is a bound" in text
    assert main(["solve", path, "--pencil", "--errors", "--lang", "ru"]) == 0
    assert "среднее квадратическое" in capsys.readouterr().out


def test_results_alone_need_no_arrays() -> None:
    program = "import sys\nfrom planes.cli import main\nmain(['solve', sys.argv[1], '--json'])\n"
    program += "print('numpy' in sys.modules, file=sys.stderr)\n"
    found = subprocess.run(
        [sys.executable, "-c", program, str(SAMPLES / "six-link.yaml")], capture_output=True, text=True, check=True
    )
    assert found.stderr == "False\n"
