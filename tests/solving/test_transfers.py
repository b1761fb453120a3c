"""Transfer functions as results: against differences of places, and one number for every reader of them."""

from __future__ import annotations

import random
import re
from dataclasses import replace
from math import radians, remainder

import pytest

from planes.diagrams.turn import whole_turn_of
from planes.drafting.instruments import Pencil
from planes.lesson.transfers import TransferFunctions
from planes.plans.measuring import scene_lettering
from planes.plans.statements.of_scene import scene_plans
from planes.plans.transfers import analogue_units, transfer_functions
from planes.scene import Scene, load, loads
from planes.solving import Position, plans_and_requested_results, solve
from planes.solving.tables import solve_report_text
from planes.words.errors import SceneError
from planes.words.naming import Naming
from planes.words.read_off import read_off_text
from tests.helpers import ROOT
from tests.helpers.mechanisms import KINDS, make, to_yaml
from tests.helpers.oracle import solve as solve_independently
from tests.sample_oracle import INSIDE

SIX = ROOT / "samples" / "six-link.yaml"


def position(scene: Scene, **changed: object) -> Position:
    return solve(replace(scene, **changed)).positions[0]


@pytest.mark.parametrize("seed", range(10))
def test_they_are_differences_of_places_by_the_driver_s(seed: int) -> None:
    case = make(random.Random(f"transfers {seed}"), [KINDS[seed % 5]], sliding=seed % 3 == 0, loads=False)
    drive = case.scene["drive"]
    key, step = ("phi", 1e-3) if "phi" in drive else ("s", 1e-5)
    by = 2 * (radians(step) if key == "phi" else step)
    before, after = (
        solve_independently({**case.scene, "drive": {**drive, key: drive[key] + d}}, case.guess) for d in (-step, step)
    )
    found = solve(loads(to_yaml(case.scene), "random.yaml")).positions[0].results["transfers"]
    compared = 0
    for link in before.links:
        turned = radians(remainder(after.links[link][0] - before.links[link][0], 360.0)) / by
        name = f"u_{link}{drive['link']}" if key == "phi" else f"omega_q{link}"
        assert (name in found) or link == drive["link"] or turned == pytest.approx(0.0, abs=1e-6)
        if name in found:
            assert found[name] == pytest.approx(turned, rel=1e-4, abs=1e-4), name
            compared += 1
    for point in before.points:
        if f"v_q{point}" in found:
            moved = abs(after.points[point][0] - before.points[point][0]) / by
            assert found[f"v_q{point}"] == pytest.approx(moved, rel=1e-4, abs=1e-4), point
            compared += 1
    assert compared


@pytest.mark.parametrize("name", ["six-link", "sliding-driver", *INSIDE, "shaper"])
def test_the_sheet_the_note_the_curves_and_solve_tell_the_same(name: str) -> None:
    scene = load(ROOT / "samples" / f"{name}.yaml")
    one = position(scene, find=None)
    naming, text = (
        Naming("en", **scene_lettering(scene, one.plans)),
        solve_report_text(solve(replace(scene, find=None))),
    )
    found = {f"{read_off_text(x, 'en')}" for x in one.results["transfers"].values() if abs(x) > 1e-12}
    rows = [row for row in TransferFunctions(one, naming).transfer_rows() if row[2] != "0"]
    assert rows and {row[2] for row in rows} <= found
    assert "Transfer functions" in text
    names = [n for n in one.results["transfers"] if n[:2] in ("u_", "om")]
    curves = whole_turn_of(one.plans, [f"omegaq_{n.rpartition('q')[2]}" if n[0] == "o" else n for n in names])
    sample = curves.sample_columns([one.at])
    for n, curve in zip(names, curves.curves, strict=True):
        assert one.results["transfers"][n] == pytest.approx(float(curve.read(sample)[0]), rel=1e-9, abs=1e-12)


def test_asked_for_alone_only_what_leads_to_them_is_drawn() -> None:
    scene = load(SIX)
    asked = position(scene, find=("u_31", "v_qC"))
    assert asked.results["transfers"] == pytest.approx({"u_31": 0.8012676, "v_qC": 0.1201901}, rel=1e-6)
    assert set(asked.results) == {"phi_deg", "transfers", "warnings"}
    assert asked.plans.plan_names == ("position", "velocity")
    assert (
        len(asked.plans.program.steps)
        < len(plans_and_requested_results(replace(scene, find=None))[0].program.steps) / 4
    )
    assert asked.value("vq_C") == asked.value("v_qC")
    assert [c.name for c in whole_turn_of(position(scene, find=None).plans, ["v_qC"]).curves] == ["vq_C"]


def test_a_pencil_s_slips_are_in_them_as_its_own_segments_tell() -> None:
    scene = load(SIX)
    drawn = solve(replace(scene, find=None), instrument=Pencil(seed=5)).positions[0]
    exact = position(scene, find=None).results["transfers"]
    things, found = drawn.drawing.things, drawn.results["transfers"]
    pb, pc = (abs(things[f"velocity:{x}"] - things["velocity:p"]) for x in "bc")
    assert found["v_qC"] != pytest.approx(exact["v_qC"], rel=1e-3)
    arm = things["l_AB"] / pb
    assert found["v_qC"] == pytest.approx(pc * arm, rel=2e-5)
    turning = -things["v_CD"] / things["l_DC"]  # the driver goes clockwise
    assert found["u_31"] == pytest.approx(turning * things["mu_velocity"] * arm, rel=2e-5)


def test_a_driver_at_rest_has_none_and_a_wrong_name_is_refused() -> None:
    scene = load(SIX)
    for name, valid in (("u_61", "u_41"), ("v_qX", "v_qL"), ("u_11", "u_41")):
        with pytest.raises(SceneError, match=f"no quantity {name};.*did you mean {valid}"):
            plans_and_requested_results(replace(scene, find=(name,)))
    still = loads(SIX.read_text(encoding="utf-8").replace("omega: -20", "omega: 0"), "still.yaml")
    assert still.mechanism is not None
    assert still.mechanism.drive.velocity == 0
    assert "transfers" not in position(still, find=None).results
    with pytest.raises(SceneError, match="u_31"):
        plans_and_requested_results(replace(still, find=("u_31",)))


@pytest.mark.parametrize(
    ("sample", "units"), [("six-link", {"u_31": "1", "v_qC": "m"}), ("sliding-driver", {"omega_q": "1/m", "v_q": "1"})]
)
def test_they_have_the_units_of_derivatives_by_the_driver_s_place(sample: str, units: dict[str, str]) -> None:
    """By an angle in radians, or by metres; so are those of the accelerations."""
    plans = scene_plans(load(ROOT / f"samples/{sample}.yaml"))
    told = {name: d.unit for d in transfer_functions(plans) for name in d.names}
    for head, unit in units.items():
        named = [u for name, u in told.items() if name.startswith(head)]
        assert named and set(named) == {unit}
    slides = plans.mechanism.drive.kind == "s"
    assert analogue_units(not slides)["epsilon"] == ("1/m²" if slides else "1")
    assert analogue_units(not slides)["a"] == ("1/m" if slides else "m")


@pytest.mark.parametrize("name", ["hinge-motor", "shaper"])
def test_every_link_that_turns_has_one_but_a_driver_that_turns_about_the_frame(name: str) -> None:
    scene = load(ROOT / "samples" / f"{name}.yaml")
    found = position(scene)
    drive = scene.mechanism.drive  # type: ignore[union-attr]
    own = {drive.link} if drive.on == "0" else set()
    told = {match[1] for key in found.results["transfers"] if (match := re.match(r"(?:omega_q|u_)(\d)", key))}
    assert told == {link for link, rate in found.omega.items() if rate} - own and own == set("1" * (name == "shaper"))
