"""Many positions: the compiled loop and the arrays say the same, masks carry reasons, tables are whole."""

from __future__ import annotations

import csv
import random
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from planes.accuracy.digits import Digits
from planes.batch.cycle import Cycle
from planes.batch.error_bounds import Claims
from planes.cli import main
from planes.drafting.drawing import draw_program
from planes.plans import Plans, plans_of
from planes.scene import load, loads
from planes.scene.ranges import Span, read_span
from planes.solving import solve
from planes.words.errors import PlanesError
from tests.helpers import ROOT
from tests.helpers.mechanisms import KINDS, make, to_yaml

SAMPLES = ROOT / "samples"
NAMES = ["six-link", "sliding-driver", *(f"kind-{k}" for k in ("1-rrr", "2-rrp", "3-rpr", "4-prp", "5-rpp"))]


def plans(name: str) -> Plans:
    mechanism = load(str(SAMPLES / f"{name}.yaml")).mechanism
    assert mechanism
    return plans_of(mechanism)


def span(p: Plans, count: int = 721) -> Span:
    return Span(-360.0, 720 / (count - 1), count) if p.mechanism.drive.kind == "phi" else Span(-1.0, 0.002, 1001)


def whole(c: Cycle, values: Any, **how: Any) -> tuple[Any, Any]:
    blocks = list(c.blocks(values, **how))
    return np.hstack([b.table for b in blocks]), np.hstack([b.codes for b in blocks])


needs_compiler = pytest.mark.needs("llvmlite")


@pytest.mark.few(1)
@needs_compiler
@pytest.mark.parametrize("name", NAMES)
def test_compiled_loop_and_arrays_agree(name: str) -> None:
    """To 1e-12 of each quantity's own largest value over the sharpness (measured: 1.6e-13), and within the claims."""
    p = plans(name)
    c = Cycle(p)
    (slow, why), (fast, same_why) = whole(c, span(p), fast=False), whole(c, span(p), fast=True)
    assert (why == same_why).all() and (np.isnan(slow) == np.isnan(fast)).all()
    good = why == 0
    assert good.sum() > 100
    apart, size = np.nan_to_num(np.abs(slow - fast)[:, good]), own_sizes(c, slow[:, good])
    assert (apart <= 1e-12 * size / sharpness(c, span(p)[:][good])).all()
    claimed = Claims(c).error_bounds_of_columns(span(p)[:][good])
    sure = np.isfinite(claimed).all(axis=0)
    assert sure.sum() > 100 and (apart[:, sure] <= 2 * claimed[:, sure]).all()


@pytest.mark.few(2)
@pytest.mark.parametrize("name", NAMES)
def test_the_loop_by_arrays_gives_what_drawing_them_gives(name: str) -> None:
    """Blocks of other lengths after one another too: arrays are used again, and made anew for a shorter last block."""
    p = plans(name)
    c, values = Cycle(p), span(p)[:]
    table, codes = whole(c, values, chunk=200, fast=False)
    drawn = draw_program(c.program, {**c.given, p.drive_given_name: values})
    good = (codes == 0) & ~np.broadcast_to(drawn.failed_mask(), values.shape)
    assert good.sum() > 100 and len(values) % 200
    with np.errstate(all="ignore"):
        shown = np.array(
            [np.broadcast_to(x.read_from_drawing(drawn.things, drawn.tool.ar), values.shape) for x in c.columns]
        )
    apart, size = np.nan_to_num(np.abs(table - shown)[:, good]), own_sizes(c, shown[:, good])
    assert (apart <= 1e-12 * size / sharpness(c, values[good])).all()


def own_sizes(c: Cycle, table: Any) -> Any:
    """The largest value of each quantity itself over the cycle, of a vector the larger of its parts."""
    names, largest = [x.name.removesuffix("_x").removesuffix("_y") for x in c.columns], {}
    for name, row in zip(names, np.nan_to_num(np.abs(table)), strict=True):
        largest[name] = max(row.max(), largest.get(name, 0.0))
    return np.array([[largest[name]] for name in names])


def sharpness(c: Cycle, values: Any) -> Any:
    """The sine of the bluntest crossing at each position: a sine or quotient rounded otherwise in its last place, as
    numpy and the loop do, is seen so much enlarged behind that crossing."""
    drawn = draw_program(c.program, {**c.given, c.plans.drive_given_name: values})
    return np.min([np.broadcast_to(s, values.shape) for s in drawn.crossing_sharpness.values()], axis=0)


@pytest.mark.parametrize("fast", [False, pytest.param(True, marks=needs_compiler)])
def test_other_givens_may_move_with_the_drive(fast: bool) -> None:
    p = plans("kind-1-rrr")
    angles, lengths = np.linspace(0.0, 360.0, 50), np.linspace(0.08, 0.13, 50)
    table, codes = whole(Cycle(p, ["v_C", "a_C"], {"l_AB": lengths}), angles, chunk=16, fast=fast)
    assert not codes.any()
    for k in (0, 17, 49):
        alone, _ = whole(Cycle(p, ["v_C", "a_C"], {"l_AB": float(lengths[k])}), [angles[k]], fast=False)
        assert table[:, k] == pytest.approx(alone[:, 0], rel=1e-13)


@pytest.mark.few(3)
@pytest.mark.parametrize("name", NAMES)
def test_numbers_are_those_of_single_drawings(name: str) -> None:
    p = plans(name)
    scene = load(str(SAMPLES / f"{name}.yaml"))
    value = p.mechanism.drive.position
    c = Cycle(p)
    table, codes = whole(c, [value])
    assert codes[0] == 0
    flat = dict(zip([x.name for x in c.columns], table[:, 0], strict=True))
    results = solve(scene, [value]).positions[0].results
    for point, found in results["points"].items():
        for letter, vector in found.items():
            for axis, number in zip("xy", vector, strict=True):
                assert flat[f"{letter}_{point}_{axis}"] == pytest.approx(number, rel=1e-9, abs=1e-8)
    for key, reaction in results["reactions"].items():
        force = reaction["force"] if isinstance(reaction, dict) else reaction
        assert [flat[f"{key}_x"], flat[f"{key}_y"]] == pytest.approx(force, rel=1e-9, abs=1e-7)
        if isinstance(reaction, dict) and reaction["arm"] is not None:
            assert flat[f"{key}_arm"] == pytest.approx(reaction["arm"], rel=1e-6, abs=1e-9)


def test_asking_for_a_velocity_runs_no_acceleration_and_no_force() -> None:
    c = Cycle(plans("six-link"), ["v_C"])
    assert [x.name for x in c.columns] == ["v_C_x", "v_C_y"]
    assert {s.makes.partition(":")[0] for s in c.program.steps if s.kind == "mark"} == {"position", "velocity"}


def test_a_failed_position_has_its_reason_and_nan_only_after_what_failed() -> None:
    c = Cycle(plans("six-link"))
    table, codes = whole(c, [0.0, 150.0])
    reason = c.reasons[codes[0] - 1]
    assert (reason.key, reason.makes, codes[1]) == ("arcs_apart", "position:C", 0)
    row = dict(zip([x.name for x in c.columns], table[:, 0], strict=True))
    assert np.isnan(row["v_C_x"]) and np.isnan(row["M_1"]) and row["r_B_x"] == 0.1
    assert np.isfinite([x for k, x in enumerate(table[:, 1]) if not c.columns[k].beside]).all()


@pytest.mark.slow
@needs_compiler
def test_random_mechanisms_leave_no_number_without_a_reason() -> None:
    for seed in range(20):
        rng = random.Random(seed)
        case = make(rng, [KINDS[seed % 5]], friction=seed % 4 == 0)
        mechanism = loads(to_yaml(case.scene), "random.yaml").mechanism
        assert mechanism
        p = plans_of(mechanism)
        c = Cycle(p)
        must = np.array([not x.beside for x in c.columns])
        for fast in (False, True) if seed < 5 else (False,):
            table, codes = whole(c, span(p, 181), fast=fast)
            assert np.isfinite(table[must][:, codes == 0]).all()


def test_blocks_are_small_whatever_the_length() -> None:
    blocks = Cycle(plans("six-link"), ["v_C"]).blocks(Span(0.0, 1e-9, 10**9), chunk=64, fast=False)
    assert next(blocks).table.shape == (2, 64)


def test_spans_are_the_ranges_people_write() -> None:
    assert read_span("0:360:0.00001").count == 36_000_001
    assert (read_span("0:1:0.25")[1:3] == [0.25, 0.5]).all()
    assert list(read_span("-90")[:]) == [-90.0]


@pytest.fixture
def asked(tmp_path: Path) -> Path:
    text = (SAMPLES / "six-link.yaml").read_text(encoding="utf-8") + "find: [v_C, M_1]\n"
    (tmp_path / "s.yaml").write_text(text, encoding="utf-8")
    return tmp_path / "s.yaml"


def test_table_as_text(asked: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = asked.with_name("o.csv")
    assert main(["cycle", str(asked), "--phi", "120:150:10", "-o", str(out), "--lang", "en"]) == 0
    rows = list(csv.reader(out.read_text(encoding="utf-8").splitlines()))
    assert rows[0] == ["phi [°]", "v_C_x [m/s]", "v_C_y [m/s]", "M_1 [N·m]", "failed"]
    assert rows[1][1:4] == ["", "", ""] and rows[1][4] == "arcs_apart: position:C"
    assert float(rows[4][3]) == pytest.approx(-287.17341740828566, rel=1e-12) and rows[4][4] == ""
    assert "φ = 120°…120° (1 positions): the arcs" in capsys.readouterr().err


@pytest.mark.parametrize("suffix", [".npy", ".npz"])
def test_table_as_arrays(asked: Path, suffix: str) -> None:
    out = asked.with_name("o" + suffix)
    assert main(["cycle", str(asked), "--phi", "0:360:1", "-o", str(out)]) == 0
    found = np.load(out)
    moment, failed = found["M_1"], found["failed"]
    assert len(moment) == 361 and (np.isnan(moment) == (failed != 0)).all()
    found.close() if suffix == ".npz" else None
    assert [f.name for f in asked.parent.iterdir() if f.name.startswith(".")] == []


def test_what_cannot_be_written_leaves_nothing(asked: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["cycle", str(asked), "-o", str(asked.with_name("o.xls")), "--lang", "en"]) == 2
    assert "valid: .csv, .npy, .npz, .parquet" in capsys.readouterr().err
    assert main(["cycle", str(asked), "-o", str(asked.parent / "no" / "o.csv"), "--lang", "en"]) == 2
    assert main(["cycle", str(asked), "--phi", "0:90:1", "-o", str(asked.with_name("o.csv"))]) == 2
    assert sorted(f.name for f in asked.parent.iterdir()) == ["o.csv", "s.yaml"]


def test_parquet_says_what_it_needs(asked: Path, monkeypatch: pytest.MonkeyPatch, capsys: Any) -> None:
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    assert main(["cycle", str(asked), "-o", str(asked.with_name("o.parquet")), "--lang", "en"]) == 2
    assert "pip install pyarrow" in capsys.readouterr().err


def test_parquet_tables_hold_numbers_units_and_reasons(asked: Path) -> None:
    why = "pyarrow is large and not among the extra [test]: pip install pyarrow"
    parquet = pytest.importorskip("pyarrow.parquet", reason=why)
    out = asked.with_name("o.parquet")
    assert main(["cycle", str(asked), "--phi", "120:480:0.005", "-o", str(out)]) == 0
    file, span = parquet.ParquetFile(out), Span(120.0, 0.005, 72_001)
    assert file.num_row_groups == 2  # as it is streamed
    found, c = file.read(), Cycle(plans("six-link"), ["v_C", "M_1"])
    assert found.column_names == ["phi", "v_C_x", "v_C_y", "M_1", "failed"]
    assert [found.schema.field(n).metadata[b"unit"].decode() for n in found.column_names[:4]] == [
        "°",
        "m/s",
        "m/s",
        "N·m",
    ]
    table, codes = whole(c, span)
    expected = np.vstack([span[:], table])
    assert np.array_equal([found[n].to_numpy() for n in found.column_names[:4]], expected, equal_nan=True)
    told = ["", *(f"{r.key}: {r.makes}" for r in c.reasons)]
    assert found["failed"].to_pylist() == [told[k] for k in codes]


@pytest.mark.parametrize("phi", ["350:10:-5", "10:350:5"])
def test_tables_keep_the_order_asked(asked: Path, phi: str) -> None:
    out = asked.with_name("o.npz")
    assert main(["cycle", str(asked), "--phi", phi, "-o", str(out)]) == 0
    with np.load(out) as found:
        assert list(found["phi"]) == list(read_span(phi)[:])


def test_explain_lists_steps_kept_and_dropped(asked: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["solve", str(asked), "--explain", "--lang", "en"]) == 0
    text = capsys.readouterr().out
    assert "Steps kept: " in text and "Steps dropped: " in text and "acceleration:n_CB" in text


def test_long_numbers_draw_one_at_a_time() -> None:
    c = Cycle(plans("six-link"), ["v_C"])
    with pytest.raises(PlanesError, match="one position at a time"):
        draw_program(c.program, {**c.given, **c.changing_inputs(np.array([1.0, 2.0]), slice(0, 2))}, Digits(30))
    with pytest.raises(PlanesError):
        draw_program(c.program, c.given | {c.plans.drive_given_name: 0.0}, Digits(30))
