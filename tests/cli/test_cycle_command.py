"""The command ``planes cycle``: summary, listing, tables of chosen curves, pictures, constructions, refusals."""

from __future__ import annotations

import csv
import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from planes.batch import compiled
from planes.batch import cycle as batch_cycle
from planes.cli import main
from planes.diagrams.motion import Runs
from planes.diagrams.turn import whole_turn_of
from planes.documents.cycle import DrawnTurn, diagrams_and_hodographs
from planes.plans import plans_of
from planes.scene import load, loads
from planes.words.naming import Naming
from render.views.curve_pieces import continuous_runs
from render.views.diagrams import DiagramCurve
from tests.diagrams.test_diagrams import ROCKER, crank
from tests.helpers import ROOT

SAMPLES = ROOT / "samples"
TWELVE, SIX = str(SAMPLES / "assignment-12.yaml"), str(SAMPLES / "six-link.yaml")


def out_of(capsys: Any, *argv: str) -> str:
    assert main(["cycle", *argv]) == 0
    found = capsys.readouterr()
    assert found.err == ""
    return str(found.out)


def refused(capsys: Any, *argv: str) -> str:
    assert main(["cycle", *argv, "--lang", "en"]) == 2
    found = capsys.readouterr()
    assert found.out == "" and found.err.count("\n") == 1
    return str(found.err)


@pytest.mark.slow
def test_the_summary_in_both_languages(capsys: Any) -> None:
    said = out_of(capsys, TWELVE, "--lang", "ru")
    assert "ход 0,23077 м" in said and "K = 2,1966" in said and "φ1 = 22,6199°" in said
    assert "Аналоги скоростей и ускорений (передаточные функции)" in said and "Траектории точек" in said
    row = next(line.split() for line in said.splitlines() if line.startswith("  u_21"))
    assert row == ["u_21,", "u_31", "1", "-1,246", "326,3099°", "0,3568", "146,3099°"]
    assert "Time ratio K = 2.1966" in out_of(capsys, TWELVE, "--lang", "en")
    assert "Assembles for φ1 = 129.5274°…305.7678°" in out_of(capsys, SIX, "--lang", "en")
    assert "→ ∞" in out_of(capsys, SIX, "--lang", "en")


def test_the_summary_as_json(capsys: Any) -> None:
    found = json.loads(out_of(capsys, TWELVE, "--json"))
    assert found["driven"]["time_ratio"] == pytest.approx(2.1966, rel=1e-4)
    top = max(found["curves"]["M_1"]["extremes"], key=lambda e: e["value"])
    assert top["at"] == pytest.approx(311.693, abs=1e-3) and top["value"] == pytest.approx(863.101, rel=1e-6)
    assert found["curves"]["u_31"]["unit"] == "1" and found["assembles"] == [[0, 360]]


@pytest.mark.slow
def test_a_sliding_driver_goes_through_its_working_range(capsys: Any) -> None:
    said = out_of(capsys, str(SAMPLES / "sliding-driver.yaml"), "--lang", "en")
    assert "s1 = " in said and "omegaq_3" in said and "1/m" in said


def rows_of(file: Path) -> list[dict[str, str]]:
    with file.open(encoding="utf-8") as lines:
        return list(csv.DictReader(lines))


def test_a_table_of_chosen_curves(tmp_path: Path, capsys: Any) -> None:
    target = tmp_path / "x.csv"
    names = "u_31,vq_D_y,F_12,M_1"
    assert main(["cycle", TWELVE, "--show", names, "--phi", "0:360:30", "-o", str(target), "--lang", "en"]) == 0
    rows = rows_of(target)
    assert list(rows[0]) == ["phi [°]", "u_31 [1]", "vq_D_y [m]", "F_21 [N]", "M_1 [N·m]", "failed"]
    assert len(rows) == 13 and float(rows[9]["u_31 [1]"]) == pytest.approx(0, abs=1e-12)
    assert main(["cycle", SIX, "--show", "u_31", "--phi", "0:150:150", "-o", str(target), "--lang", "en"]) == 0
    first, last = rows_of(target)
    assert (first["u_31 [1]"], first["failed"]) == ("", "arcs_apart: position:C") and float(last["u_31 [1]"])
    archive = tmp_path / "x.npz"
    assert main(["cycle", TWELVE, "--show", "all", "--phi", "0:90:30", "-o", str(archive), "--lang", "en"]) == 0
    with np.load(archive) as found:
        assert {"phi", "u_31", "aq_S3_x", "F_50_moment", "MZ_1"} <= set(found.files)
    capsys.readouterr()


@pytest.mark.few(1)
@pytest.mark.parametrize("suffix", ["png", "svg", "pdf", "dxf"])
def test_pictures(suffix: str, tmp_path: Path) -> None:
    some = [tmp_path / f"{k}.{suffix}" for k in range(2)]
    for target in some:
        argv = ["cycle", TWELVE, "--show", "s_5,vq_D+vq_S3", "--hodograph", "F_21", "--path", "D", "-o", str(target)]
        assert main([*argv, "--lang", "ru"]) == 0
    assert some[0].read_bytes() == some[1].read_bytes() and some[0].stat().st_size > 5000


@pytest.mark.needs("llvmlite")
@pytest.mark.parametrize("scene", [SIX, str(SAMPLES / "kind-1-rrr.yaml")])
def test_a_long_table_of_curves_goes_through_the_compiled_loop(scene: str, tmp_path: Path, monkeypatch: Any) -> None:
    """Its numbers and the positions it refuses are those of arrays; ``--plain`` keeps to arrays."""
    loops: list[int] = []
    run, fill = compiled.CompiledLoop.__call__, compiled.CompiledLoop.fill_rows
    monkeypatch.setattr(batch_cycle, "LEAST_POSITIONS_TO_COMPILE", 700)
    monkeypatch.setattr(compiled.CompiledLoop, "__call__", lambda loop, *rows: loops.append(1) or run(loop, *rows))
    monkeypatch.setattr(compiled.CompiledLoop, "fill_rows", lambda loop, *rows: loops.append(1) or fill(loop, *rows))
    found = []
    for plain, file in (([], tmp_path / "loop.npz"), (["--plain"], tmp_path / "arrays.npz")):
        argv = ["cycle", scene, "--phi", "-90:270:0.5", "--show", "v_C,u_31", "-o", str(file), *plain]
        assert main(argv) == 0 and bool(loops) == (not plain)
        loops.clear()
        with np.load(file) as held:
            found.append(dict(held))
    one, two = found
    assert len(one["v_C"]) == 721 and np.isnan(one["v_C"]).any() == (scene == SIX)
    for name in ("v_C", "u_31"):
        np.testing.assert_allclose(one[name], two[name], rtol=1e-9, atol=1e-13)
    assert (one["failed"] == two["failed"]).all()


def test_what_is_drawn_is_split_at_dead_points_and_marked_at_extremes() -> None:
    scene = loads(crank(0.0, 20.0) + "loads: [{link: 3, point: B, force: 500, against: motion}]\n", "scene.yaml")
    assert scene.mechanism
    plans = plans_of(scene.mechanism)
    turn = whole_turn_of(plans, ["F_21", "v_slide_3"], ["F_21"])
    turned = DrawnTurn(turn, Runs(plans, 0.0, 360.0), Naming("en"))
    force, rate = map(turned.curve, turn.curves)
    assert force.name == "F_{21}" and force.values.count(None) == rate.values.count(None) == 1
    assert [place for place, *_ in jumps(force)] == pytest.approx([180.0], abs=1e-4)
    assert all(abs(before - after) > 300 for _, before, after in jumps(force))  # the load turns about
    assert all(abs(before - after) < 1e-6 for _, before, after in jumps(rate))
    loop = turned.loop(turn.arrows[0])
    assert len(loop.stations) == 13 and all(z is not None and abs(z) > 100 for z in loop.stations)


def jumps(curve: DiagramCurve) -> list[tuple[float, float, float]]:
    """Where a curve jumps, the value before and the one after."""
    rows = zip(curve.places, curve.values, strict=True)
    found = continuous_runs([None if v is None else complex(x, v) for x, v in rows], 1e-4)
    return [(ends[0].real, ends[0].imag, ends[1].imag) for ends, jump in found if jump]


def test_the_sheet_draws_what_its_scene_asks_for() -> None:
    text = crank() + "loads: [{link: 3, point: B, force: 500, against: motion}]\n"
    scene = loads(text + "sheet: {diagrams: [vq_slide_3, M_1, F_21], hodographs: 'F_21, v_S2'}\n", "scene.yaml")
    assert scene.mechanism
    angles = [5.0 * k for k in range(73)]
    curves, loops = diagrams_and_hodographs(scene, plans_of(scene.mechanism), angles, True, Naming("ru"))
    assert [(c.name, c.unit) for c in curves] == [("v_{q3}", "m"), ("M_{ур}", "N·m"), ("F_{21}", "N")]
    assert [loop.name for loop in loops] == ["F_{21}", "v_{S2}"]
    assert len(jumps(curves[2])) == 1 and jumps(curves[2])[0][0] == pytest.approx(180, abs=1e-4)
    assert not [a for a, y, z in jumps(curves[0]) if abs(y - z) > 1e-7]
    assert diagrams_and_hodographs(loads(text, "s"), plans_of(scene.mechanism), angles, True, Naming("ru")) == ((), ())


@pytest.mark.parametrize(
    ("name", "lettered"),
    [
        ("vq_C", "v_{qC}"),
        ("u_31", "u_{31}"),
        ("epsilonq_3", "ε_{q3}"),
        ("s_5", "s_{5}"),
        ("r_C_x", "x_{C}"),
        ("aq_slide_5", "a_{q5}"),
        ("F_21", "F_{21}"),
        ("F_21_x", "F_{21x}"),
        ("F_50_arm", "h_{56}"),
        ("M_1", "M_{b}"),
        ("v_S2_y", "v_{S2y}"),
        ("F_11_10", "F_{11,10}"),
        ("F_11_10_y", "F_{11,10y}"),
        ("coriolis_4", "a^{k}_{4}"),
    ],
)
def test_letters_of_curves(name: str, lettered: str) -> None:
    assert Naming("en", "6").lettered_curve(name) == lettered


def test_graphical_constructions_beside_the_exact_values(capsys: Any) -> None:
    said = out_of(capsys, TWELVE, "--graphical", "24", "--pole", "25", "--lang", "ru")
    assert "участков 24" in said and said.count("H = 25 мм") == 4 and "Графическое интегрирование" in said
    rows = [line.split() for line in said.splitlines() if line.startswith("  11½ ")]
    assert len(rows) == 1 and float(rows[0][4].replace(",", ".")) == pytest.approx(0, abs=1.0)


@pytest.mark.slow
def test_another_law_of_motion(capsys: Any) -> None:
    assert "ω1 = 3 rad/s, ε1 = 0 rad/s²" in out_of(capsys, TWELVE, "--omega", "3", "--epsilon", "0", "--lang", "en")


@pytest.mark.parametrize(
    ("argv", "words"),
    [
        (["--show", "vq_Z", "-o", "x.csv"], "has no quantity vq_Z"),
        (["--show", "vq_Z", "-o", "x.png"], "has no quantity vq_Z"),
        (["--hodograph", "s_5", "-o", "x.png"], "has no quantity s_5"),
        (["--path", "Q", "-o", "x.png"], "has no quantity r_Q"),
        (["--listing", "--phi", "0:360:1"], "a listing is for a few positions, but 361 were asked for"),
        (["-o", "x.txt"], "no table can be written"),
        (["--graphical", "3"], "take from 6 to 72"),
        (["--omega", "nan"], "must be finite numbers"),
    ],
)
def test_refusals(argv: list[str], words: str, capsys: Any, tmp_path: Path, monkeypatch: Any) -> None:
    monkeypatch.chdir(tmp_path)
    assert words in refused(capsys, TWELVE, *argv)
    assert not list(tmp_path.iterdir())


def test_listings_and_constructions_as_json(capsys: Any) -> None:
    found = json.loads(out_of(capsys, TWELVE, "--phi", "245", "--json"))
    assert found["positions"][0]["phi_deg"] == 245 and found["units"]["u_31"] == "1"
    assert found["positions"][0]["values"]["a_D"] == pytest.approx(10.264938945670275, rel=1e-12)
    assert found["positions"][0]["values"]["F_50_arm"] is None
    both = json.loads(out_of(capsys, TWELVE, "--graphical", "--json"))["constructions"]
    assert [c["kind"] for c in both] == ["differentiation", "integration"]
    speeds = both[0]["diagrams"][1]
    assert speeds["unit"] == "m/s" and len(speeds["points"]) == 12 and speeds["points"][0]["point"] == "0½"


def test_what_is_shown_is_told_of_alone(capsys: Any) -> None:
    said = out_of(capsys, TWELVE, "--show", "M_1,r_D_x", "--lang", "en")
    names = [line.split()[0] for line in said.splitlines() if line.startswith("  ") and line.split()[0] != "unit"]
    assert names == ["r_D_x", "M_1"] and "Paths" not in said and "K = 2.1966" in said


def test_a_position_that_does_not_assemble_is_told(capsys: Any) -> None:
    assert main(["cycle", SIX, "--listing", "--phi", "90:150:30", "--show", "u_31", "--lang", "en"]) == 0
    found = capsys.readouterr()
    assert found.err.count("\n") == 2 and "at φ = 90°" in found.err and "the nearest that works" in found.err
    assert [line.split() for line in found.out.splitlines()][-1] == ["u_31", "1", "—", "—", "0.80127"]
    assert refused(capsys, SIX, "--phi", "0", "--json").startswith("at φ = 0°")


def test_a_scene_of_vectors_has_no_cycle(capsys: Any) -> None:
    assert "has no mechanism" in refused(capsys, str(SAMPLES / "vectors.yaml"))


def test_a_mechanism_that_never_assembles_says_so(tmp_path: Path, capsys: Any) -> None:
    file = tmp_path / "never.yaml"
    file.write_text(ROCKER.replace("C: 0.35", "C: 3.5"), encoding="utf-8")
    assert "cannot be assembled in any position" in refused(capsys, str(file))


def test_the_ends_of_a_range_run_backwards_are_the_same() -> None:
    from planes.scene.ranges import read_span

    assert sorted(read_span("90:0:-10").first_and_last) == sorted(read_span("0:90:10").first_and_last) == [0.0, 90.0]
    assert math.isclose(load(TWELVE).mechanism.drive.velocity, 12)  # type: ignore[union-attr]


def test_structure_is_told_even_where_the_variant_is_not(tmp_path: Path, capsys: Any) -> None:
    file = tmp_path / "open.yaml"
    file.write_text(ROCKER.replace("assembly: {C: left}\n", ""), encoding="utf-8")
    assert main(["structure", str(file), "--lang", "en"]) == 0
    found = capsys.readouterr()
    assert "W = 3n − 2p1 = 3·3 − 2·4 = 1" in found.out and "Self-aligning" not in found.out
    assert "two ways" in found.err
    assert main(["structure", str(file), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["self_aligning"] is None
    assert main(["structure", TWELVE, "--lang", "en"]) == 0
    assert "30 − 10 − 16 − 3 = 1, q = 0" in capsys.readouterr().out


def test_one_place_makes_no_diagram(tmp_path: Path, capsys: Any) -> None:
    out = tmp_path / "x.png"
    told = refused(capsys, SIX, "--phi", "240", "-o", str(out))
    assert "diagrams need a range of positions: --phi 0:360:1" in told and not out.exists()
