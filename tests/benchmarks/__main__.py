"""`python -m tests.benchmarks [--write]`: the same columns of the same mechanisms by us and by others, in turns.

One process; everybody runs once a round, and of the rounds the least and the middle one are told, as processor time a
position. ``--write`` puts the tables into docs/measurements.md, with the processor they were taken on.
"""

from __future__ import annotations

import ctypes
import os
import platform
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from shutil import which

sys.path.insert(0, str(Path(__file__).parent))

import numpy as np
import rivals
from conftest import ROOT, SCENES, angles, plans

from planes.accuracy.methods import machine
from planes.batch.cycle import Cycle

COUNTS = (360, 10_000, 1_000_000)
ROUNDS, POSITIONS = 15, 300_000  # of a count; gone through a round, at the least
FLAGS = ("-O3", "-march=native", "-fopenmp-simd", "-fno-math-errno", "-fno-trapping-math", "-shared", "-fPIC")
MARKS = "<!-- speed: python -m tests.benchmarks --write -->", "<!-- end of speed -->"
Work = Callable[[], object]


def in_c(count: int) -> Work | None:
    """The four-bar by hand in C, checked first against the drawing; None where no compiler is."""
    compiler = which("cc") or which("gcc") or which("clang")
    if compiler is None:
        return None
    made = Path(tempfile.mkdtemp()) / "four_bar.so"
    source = Path(__file__).with_name("four_bar.c")
    subprocess.run([compiler, *FLAGS, "-o", str(made), str(source), "-lm"], check=True)
    code = ctypes.CDLL(str(made)).four_bar
    code.argtypes, code.restype = [ctypes.c_void_p] * 3 + [ctypes.c_int64] * 2 + [ctypes.c_void_p], ctypes.c_int64
    phis, given = angles("four-bar", count), np.array(rivals.numbers("four-bar"))
    out, codes, size = np.empty((16, 2048 + 8)), np.empty(2048, np.int64), 2048

    def run() -> None:
        for start in range(0, count, size):
            part = phis[start : start + size]
            code(part.ctypes.data, out.ctypes.data, codes.ctypes.data, len(part), out.shape[1], given.ctypes.data)

    (block,) = Cycle(plans("four-bar"), rivals.COLUMNS["four-bar"]).blocks(phis[:100], fast=False)
    run_once = code(phis.ctypes.data, out.ctypes.data, codes.ctypes.data, 100, out.shape[1], given.ctypes.data)
    assert run_once == 0 and np.abs(block.table - out[:, :100]).max() < 1e-9 * np.abs(block.table).max()
    return run


def entrants(name: str, count: int) -> dict[str, Work]:
    """Who runs: ours by blocks thrown away, into one table, by two threads; others."""
    cycle, values = Cycle(plans(name), rivals.COLUMNS[name]), angles(name, count)
    kept = np.empty((len(cycle.columns), count))

    def blocks() -> None:
        for _ in cycle.blocks(values, fast=True):
            pass

    known: dict[str, Work | None] = {
        "planes, blocks": blocks,
        "planes, one table": lambda: cycle.table(values, True, out=kept),
        "C by hand, with proofs": in_c(count) if name == "four-bar" else None,
        "numba by hand": rivals.by_hand(name, count),
        "pylinkage": rivals.pylinkage(name, count),
        "kinepy, places only": rivals.kinepy(name, count) if count <= COUNTS[1] else None,
    }
    return {who: work for who, work in known.items() if work}


def raced(works: dict[str, Work], count: int, clock: Callable[[], float]) -> dict[str, tuple[float, float]]:
    """ns a position, least and middle, of each."""
    times: dict[str, list[float]] = {who: [] for who in works}
    often = max(1, POSITIONS // count)
    for work in works.values():
        work()
    for _ in range(ROUNDS):
        for who, work in works.items():
            start = clock()
            for _ in range(often):
                work()
            times[who].append((clock() - start) / often / count * 1e9)
    return {who: (min(some), sorted(some)[ROUNDS // 2]) for who, some in times.items()}


def threads(name: str, count: int) -> float:
    """How many times as quick two threads are, by the clock on the wall: halves of one table."""
    cycle, values = Cycle(plans(name), rivals.COLUMNS[name]), np.asarray(angles(name, count))
    kept = np.empty((len(cycle.columns), count))
    works: dict[str, Work] = {
        "one": lambda: cycle.table(values, True, out=kept),
        "two": lambda: cycle.table(values, True, out=kept, threads=2),
    }
    found = raced(works, count, time.perf_counter)
    return found["one"][0] / found["two"][0]


def tables() -> str:
    """All of it as Markdown."""
    name, cores = machine()
    busy = f"{name}, {cores} cores, load {os.getloadavg()[0]:.1f}, Python {platform.python_version()}"
    lines = [f"{busy}, numpy {np.__version__}. Processor time in ns a position, least (middle) of {ROUNDS} rounds.", ""]
    for mechanism in SCENES:
        counted = {count: raced(entrants(mechanism, count), count, time.process_time) for count in COUNTS}
        lines += [f"| {mechanism} | {' | '.join(f'{count:,}'.replace(',', ' ') for count in COUNTS)} |",
                  "|---|" + "---|" * len(COUNTS)]  # fmt: skip
        for who in counted[COUNTS[0]]:
            cells = (counted[count].get(who) for count in COUNTS)
            told = (f"{cell[0]:.1f} ({cell[1]:.1f})" if cell else "–" for cell in cells)
            lines.append(f"| {who} | {' | '.join(told)} |")
        lines.append("")
    ways = ", ".join(f"{mechanism} {threads(mechanism, COUNTS[-1]):.2f}" for mechanism in ("four-bar", "six-link"))
    return "\n".join([*lines, f"Two threads beside one, one table of {COUNTS[-1]:,} positions: {ways} times as quick."])


def write(text: str) -> None:
    """Into the page of measurements, between its marks."""
    page = ROOT / "docs" / "measurements.md"
    before, rest = page.read_text("utf-8").split(MARKS[0])
    page.write_text(f"{before}{MARKS[0]}\n\n{text}\n\n{MARKS[1]}{rest.split(MARKS[1])[1]}", "utf-8")


if __name__ == "__main__":
    made = tables()
    print(made)
    if "--write" in sys.argv:
        write(made)
