"""A tape records a program once; the loop compiled from it does what the tape says."""

from __future__ import annotations

import math
import platform
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from planes.batch import compiled
from planes.batch.array_ops import numbers_at_places
from planes.batch.llvm_ir import module_storing_past_caches
from planes.batch.loops import ArrayLoop, Loop
from planes.batch.symbols import Num, Vec, place_of_number, record_number
from planes.batch.tape import Tape
from planes.batch.tracing import Recording, Trace
from planes.scene import load
from tests.helpers import ROOT

needs_compiler = pytest.mark.needs("llvmlite")
AR = Recording()


def given(tape: Tape, name: str) -> Num:
    return Num(tape, tape.record_leaf("given", name))


def test_what_is_known_is_folded_away_and_nothing_is_recorded_twice() -> None:
    tape = Tape()
    x, y = given(tape, "x"), given(tape, "y")
    assert (x + 0.0).at == x.at and (1 * x).at == x.at and x * 0.0 == 0.0 and x - x == 0.0 and x / x == 1.0
    assert (x + y).at == (y + x).at and (-1 * -x).at == x.at and (x - y).at == (-y + x).at
    before = len(tape.ops)
    assert (x * y + y * x).at == record_number(tape, "add", x * y, x * y).at and len(tape.ops) == before + 2
    turned = Vec(x, y) * 1j
    assert turned.real.at == (-y).at and turned.imag.at == x.at
    assert abs(Vec(x, 0.0)).at == abs(x).at


def looped(tape: Tape, outputs: list[Any], loop: type[Loop] = compiled.CompiledLoop, **inputs: Any) -> Any:
    trace = Trace(tape, tuple(place_of_number(tape, x) for x in outputs), (), (), (), frozenset())
    return loop(trace, tuple(inputs), {})([np.asarray(x, float) for x in inputs.values()])[0]


@needs_compiler
def test_sines_are_right_to_the_last_place() -> None:
    tape, degrees = Tape(), np.linspace(-360, 360, 1441)
    turned = AR.cis_deg(given(tape, "phi"))
    cos, sin = looped(tape, [turned.real, turned.imag], phi=degrees)
    exact = np.array([AR.cis_deg(float(d)) for d in degrees])
    assert np.abs(cos - exact.real).max() <= 2.3e-16 and np.abs(sin - exact.imag).max() <= 2.3e-16
    quarters = degrees % 90 == 0
    assert (cos[quarters] == exact.real[quarters]).all() and (sin[quarters] == exact.imag[quarters]).all()


@needs_compiler
def test_arctangents_are_right_to_the_last_place() -> None:
    tape, angles = Tape(), np.radians(np.linspace(-179.9, 180, 2000))
    x, y = given(tape, "x"), given(tape, "y")
    (found,) = looped(tape, [AR.angle_deg(Vec(x, y))], x=3 * np.cos(angles), y=3 * np.sin(angles))
    exact = np.degrees(np.arctan2(3 * np.sin(angles), 3 * np.cos(angles)))
    assert np.abs(found - exact).max() <= 6e-14
    axes = np.array([1, 0, -1, 0, -1.0]), np.array([0, 1, 0, -1, -0.0])
    (edges,) = looped(tape, [AR.angle_deg(Vec(x, y))], x=axes[0], y=axes[1])
    assert list(edges) == [0, 90, 180, -90, 180]


@pytest.mark.parametrize("loop", [ArrayLoop, pytest.param(compiled.CompiledLoop, marks=needs_compiler)])
def test_a_loop_does_what_the_tape_says(loop: type[Loop]) -> None:
    tape, rng = Tape(), np.random.default_rng(2)
    x, y = given(tape, "x"), given(tape, "y")
    outputs = [
        AR.sqrt(x),
        AR.maximum(x, y),
        AR.minimum(x, y),
        AR.sign(x),
        abs(Vec(x, y)),
        AR.power(x, 2),
        AR.power(y, -1),
        AR.where((x > 0) & ~(y <= 0.5) | (x == y), x, y),
        abs(x),
        x - 2.0 * y,
        AR.where(x < y, math.nan, x),
        x * y + 3.0,
        AR.gap(Vec(x, y), 0.25 + 0j, y, x * 0.5),
    ]
    inputs = {"x": rng.normal(size=1000), "y": rng.normal(size=1000)}
    found = looped(tape, outputs, loop, **inputs)
    places = [place_of_number(tape, o) for o in outputs]
    expected = numbers_at_places(tape, tape.places_needed(places), inputs)
    for row, place in zip(found, places, strict=True):
        op, args = tape.ops[
            place
        ]  # a product fused with its sum is not rounded by itself: half a unit of its last place
        fused = np.maximum(*(np.abs(expected[a]) for a in args)) * 2.0**-53 if op in ("add", "sub") else 0.0
        assert np.allclose(row, expected[place], rtol=1e-15, atol=fused, equal_nan=True), op


@needs_compiler
def test_a_structure_is_compiled_once(monkeypatch: pytest.MonkeyPatch) -> None:
    from planes.batch.cycle import Cycle
    from planes.plans import plans_of
    from planes.scene import load

    texts = []
    for variant in ("160", "150"):
        mechanism = load(str(ROOT / "samples" / "six-link.yaml")).mechanism
        assert mechanism
        c = Cycle(plans_of(mechanism), ["v_C"], {"omega_1": float(variant)})
        texts.append(c.compiled_loop_of_cycle.text)
        (block,) = c.blocks([150.0], fast=True)
        assert abs(block.table[0, 0]) == pytest.approx(2.3885508115275518 * float(variant) / 20, rel=1e-12)
    assert texts[0] == texts[1]


@needs_compiler
@pytest.mark.parametrize("name", ["six-link", "kind-3-rpr", "class-three/press", "class-four/tray", "lift"])
@pytest.mark.parametrize("threads", [1, 2])
def test_a_table_is_its_blocks(name: str, threads: int) -> None:
    """By one call where all holds, by blocks where something does not: the limits of six-link are among the places."""
    from planes.batch.cycle import Cycle
    from planes.solving import plans_and_requested_results

    stated = plans_and_requested_results(load(str(ROOT / "samples" / f"{name}.yaml")))[0]
    cycle, own = Cycle(stated), stated.mechanism.drive.position
    for reach in (1e-3, 200.0 if stated.mechanism.drive.kind == "phi" else 0.02):
        values = np.linspace(own - reach, own + reach, 5001)
        blocks = list(cycle.blocks(values, fast=True))
        table, codes = cycle.table(values, True, np.full((len(cycle.columns), 5001), 7.0), threads, bare=False)
        assert np.array_equal(table, np.hstack([b.table for b in blocks]), equal_nan=True)
        assert np.array_equal(codes, np.hstack([b.codes for b in blocks]))


@needs_compiler
@pytest.mark.parametrize("threads", [1, 2])
def test_a_table_past_the_caches_is_its_blocks(threads: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Wherever in a cache line its rows begin; a table of odd length is not aligned, and is stored as others are."""
    from planes.batch.cycle import Cycle
    from planes.solving import plans_and_requested_results

    monkeypatch.setattr(compiled, "LEAST_BYTES_PAST_CACHES", 0)
    monkeypatch.setattr(compiled, "POSITIONS_PER_CALL", 512)
    cycle = Cycle(plans_and_requested_results(load(str(ROOT / "samples" / "six-link.yaml")))[0])
    for skip, count in [*((k, 1008) for k in range(8)), (1, 8), (3, 2), (5, 1009)]:
        values = cycle.plans.mechanism.drive.position + np.linspace(-5, 5, count)
        (block,) = cycle.blocks(values, fast=True)
        wide = count + -count % 8 if count < 1009 else count
        memory = np.full(len(cycle.columns) * wide + 16, 7.0)
        begin = -memory.ctypes.data // 8 % 8 + skip
        rows = memory[begin : begin + len(cycle.columns) * wide].reshape(-1, wide)
        table, codes = cycle.table(values, True, rows[:, :count], threads)
        assert np.array_equal(table, block.table) and not codes.any()
        assert (rows[:, count:] == 7).all() and (memory[:begin] == 7).all() and (memory[begin + rows.size :] == 7).all()


def test_only_full_vectors_are_stored_past_the_caches() -> None:
    single, half, full = (f"  store {kind} %1, ptr %2, align 8, !x !0\n" for kind in
                          ("double", "<4 x double>", "<8 x double>"))  # fmt: skip
    made = module_storing_past_caches(single + half + full + full)
    assert made.startswith(single + half) and made.count("align 64, !nontemporal !{i32 1}, !x !0\n") == 2
    assert module_storing_past_caches(single) == single


@needs_compiler
@pytest.mark.skipif(platform.machine() not in ("x86_64", "AMD64"), reason="processors of this family")
@pytest.mark.parametrize("cpu", ["haswell", "x86-64"])  # vectors of four and no more; of two, without fused operations
def test_an_older_processor_reckons_the_same(cpu: str, monkeypatch: pytest.MonkeyPatch) -> None:
    import llvmlite.binding as llvm

    from planes.batch.cycle import Cycle
    from planes.solving import plans_and_requested_results

    stated = plans_and_requested_results(load(str(ROOT / "samples" / "six-link.yaml")))[0]
    values = stated.mechanism.drive.position + np.linspace(-5, 5, 3001)
    here, there = Cycle(stated), Cycle(stated)
    monkeypatch.setattr(llvm, "get_host_cpu_name", lambda: cpu)
    monkeypatch.setattr(llvm, "get_host_cpu_features", lambda: SimpleNamespace(flatten=lambda: ""))
    there.compiled_loop_of_cycle.__dict__["run"] = compiled._compiled_run_function.__wrapped__(
        there.compiled_loop_of_cycle.text
    )
    (table, codes), (older, others) = (c.table(values, True) for c in (here, there))
    assert np.array_equal(codes, others) and not codes.any()
    there.compiled_loop_of_cycle.__dict__["run_past"] = compiled._compiled_run_function.__wrapped__(
        there.compiled_loop_of_cycle.text, past=True
    )
    monkeypatch.setattr(compiled, "LEAST_BYTES_PAST_CACHES", 0)
    for out in (np.full((len(table), 3008), 7.0)[:, k : k + 3001] for k in range(8)):
        assert there.compiled_loop_of_cycle.fill_rows(values, out) and np.array_equal(out, older)
    largest = np.abs(table).max(axis=1)
    assert (np.abs(older - table).max(axis=1) <= 1e-11 * largest + 1e-12).all()
