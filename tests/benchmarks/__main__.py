"""`python -m tests.benchmarks [--write | --limits]`: the same columns of the same mechanisms by us and by others.

One process; all run once a round, by turns; of the rounds the least and the middle one are told, as processor
time a position. ``--write`` puts the tables into docs/measurements.md, with the processor they were taken on, and the
errors near a limit into the pages on accuracy; ``--limits`` does that alone.
"""

from __future__ import annotations

import csv
import ctypes
import math
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
from conftest import ROOT, SAMPLES, SCENES, angles, plans

import planes
from planes.accuracy.methods import processor_and_core_count
from planes.batch.cycle import Cycle
from tests.benchmarks.pages import put

COUNTS = (360, 10_000, 1_000_000)
ROUNDS, POSITIONS = 15, 300_000  # of a count; gone through a round, at the least
FLAGS = ("-O3", "-march=native", "-fopenmp-simd", "-fno-math-errno", "-fno-trapping-math", "-shared", "-fPIC")
AT = {"en": "relative distance", "ru": "относительное расстояние"}
QUICKER = {
    "slider-crank": ("the slider-crank", "на кривошипно-ползунном механизме"),
    "slotted lever": ("the slotted lever", "на кулисном"),
}
AND = {"en": " and ", "ru": " и "}
SHOWN = {
    "exact, one compiled loop": ("construction, compiled", "построение, скомпилированное"),
    "claimed error": ("its claimed error", "его названная погрешность"),
    "numba by hand": ("closed formulas by hand (numba)", "замкнутые формулы вручную (numba)"),
    "pylinkage 1.3.0": ("pylinkage 1.3.0", "pylinkage 1.3.0"),
    "Newton's iteration": ("Newton's iteration", "итерации Ньютона"),
    "differences of places": ("differences of positions", "разности положений"),
    "24-bit numbers": ("construction in 24-bit numbers", "построение в 24-битных числах"),
}
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
    """Who runs: ours by blocks thrown away, into one table, by the public function; others."""
    cycle, values = Cycle(plans(name), rivals.COLUMNS[name]), angles(name, count)
    kept, scene = np.empty((len(cycle.columns), count)), planes.load(SAMPLES / f"{SCENES[name]}.yaml")

    def blocks() -> None:
        for _ in cycle.blocks(values, fast=True):
            pass

    known: dict[str, Work | None] = {
        "planes, blocks": blocks,
        "planes, one table": lambda: cycle.table(values, True, out=kept),
        "planes.cycle": lambda: planes.cycle(scene, rivals.COLUMNS[name], values),
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


Measured = dict[str, dict[int, dict[str, tuple[float, float]]]]
"""By mechanism, number of positions and who: ns a position, least and middle."""


def measured() -> Measured:
    """Everybody on every mechanism."""
    return {
        mechanism: {count: raced(entrants(mechanism, count), count, time.process_time) for count in COUNTS}
        for mechanism in SCENES
    }


def sentence(measured: Measured, lang: str) -> str:
    """What the README says of it."""
    ours, public, by_hand = "planes, blocks", "planes.cycle", "numba by hand"
    asked = ("four-bar", (by_hand, "pylinkage")), ("six-link", (by_hand,))
    shown = [(mechanism, who) for mechanism, others in asked for who in (ours, *others)] + [("four-bar", public)]
    cells = [f"{measured[m][count][who][0]:.0f}" for m, who in shown for count in (COUNTS[0], COUNTS[-1])]
    least = {mechanism: one[COUNTS[0]] for mechanism, one in measured.items()}
    quicker = [QUICKER[m][lang == "ru"] for m, one in least.items() if one[by_hand][0] < one[ours][0] and m in QUICKER]
    texts = {
        "en": "The compiled loop on one core of an {cpu}, in nanoseconds a position at 360 and at a million. Four-bar: "
        "{} and {} (numba by hand {} and {}, pylinkage {} and {}). Six-link with forces: {} and {} (numba {} and {}). "
        "`planes.cycle`, which makes a table by names, costs {} and {} for the four-bar.",
        "ru": "Скомпилированный цикл на одном ядре {cpu}, наносекунд на положение при 360 и при миллионе. "
        "Четырёхзвенник: {} и {} (numba вручную {} и {}, pylinkage {} и {}). Шестизвенник с силами: {} и {} (numba {} "
        "и {}). Таблица по именам, `planes.cycle`, для четырёхзвенника стоит {} и {}.",
    }
    more = {"en": " At 360, numba by hand is quicker on {}.", "ru": " При 360 numba вручную быстрее {}."}
    text = texts[lang].format(*cells, cpu=processor_and_core_count()[0])
    return text + more[lang].format(AND[lang].join(quicker)) if quicker else text


def tables(measured: Measured) -> str:
    """All of it as Markdown."""
    name, cores = processor_and_core_count()
    busy = f"{name}, {cores} cores, load {os.getloadavg()[0]:.1f}, Python {platform.python_version()}"
    lines = [f"{busy}, numpy {np.__version__}. Processor time in ns a position, least (middle) of {ROUNDS} rounds.", ""]
    for mechanism in SCENES:
        counted = measured[mechanism]
        lines += [f"| {mechanism} | {' | '.join(f'{count:,}'.replace(',', ' ') for count in COUNTS)} |",
                  "|---|" + "---|" * len(COUNTS)]  # fmt: skip
        for who in counted[COUNTS[0]]:
            cells = (counted[count].get(who) for count in COUNTS)
            told = (f"{cell[0]:.1f} ({cell[1]:.1f})" if cell else "–" for cell in cells)
            lines.append(f"| {who} | {' | '.join(told)} |")
        lines.append("")
    ways = ", ".join(
        f"{mechanism} {threads(mechanism, COUNTS[-1]):.2f} times" for mechanism in ("four-bar", "six-link")
    )
    return "\n".join(
        [
            *lines,
            f"Two threads instead of one make a table of {COUNTS[-1]:,} positions faster".replace(",", " ")
            + f": {ways}.",
        ]
    )


def near_the_limit(lang: str) -> str:
    """Errors on the way to a limit, out of a chart's table, as Markdown."""
    rows = list(csv.reader((ROOT / "samples/charts/kind-1-rrr.csv").read_text("utf-8").splitlines()))
    head, *table = (
        row for row in rows[next(k for k, row in enumerate(rows) if "claimed error" in row) :] if len(row) > 3
    )
    names = [head.index(name) for name in SHOWN if name in head]
    kept = {power: min(table, key=lambda row: abs(math.log10(float(row[0] or 1)) + power)) for power in (3, 5, 7, 9)}
    lines = [
        f"| {AT[lang]} | {' | '.join(f'10⁻{chr(0x2070 + power) if power > 3 else chr(0xB3)}' for power in kept)} |"
    ]
    lines.append("|---|" + "---|" * len(kept))
    for k in names:
        cells = (f"{float(row[k]):.0e}" if row[k] and float(row[k]) < 1 else "–" for row in kept.values())
        lines.append(f"| {SHOWN[head[k]][lang == 'ru']} | {' | '.join(cells)} |")
    return "\n".join(lines)


if __name__ == "__main__":
    if "--limits" not in sys.argv:
        speeds = measured()
        print(made := tables(speeds))
        if "--write" in sys.argv:
            put("docs/measurements.md", "speed", made)
            for lang, page in (("en", "README.md"), ("ru", "README.ru.md")):
                put(page, "speed", sentence(speeds, lang), "")
    for lang in ("en", "ru") if {"--write", "--limits"} & {*sys.argv} else ():
        put(f"docs/site/{lang}/accuracy.md", "limits", near_the_limit(lang))
