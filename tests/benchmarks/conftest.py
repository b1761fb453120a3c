"""Mechanisms to time, and a summary of ratios after the timings."""

from __future__ import annotations

import os
import platform
import subprocess
import sys
from collections.abc import Sequence
from functools import cache
from pathlib import Path

import numpy as np

from planes.accuracy.methods import processor_and_core_count
from planes.plans import Plans, plans_of
from planes.scene import load
from planes.scene.ranges import Span

ROOT = Path(__file__).parents[2]
SAMPLES = ROOT / "samples"
SCENES = {"four-bar": "kind-1-rrr", "slider-crank": "kind-2-rrp", "slotted lever": "kind-3-rpr", "six-link": "six-link"}


@cache
def plans(name: str) -> Plans:
    mechanism = load(str(SAMPLES / f"{SCENES[name]}.yaml")).mechanism
    assert mechanism
    return plans_of(mechanism)


def angles(name: str, count: int) -> np.ndarray:
    """Degrees about the scene's own position, where all four mechanisms work."""
    return Span(plans(name).mechanism.drive.position - 5, 10 / count, count)[0:count]


def peak(text: str) -> str:
    """The most memory a process takes that runs ``text``; "" where the system does not tell."""
    if not Path("/proc/self/status").exists():
        return ""
    tell = "print(next(line.split()[1] for line in open('/proc/self/status') if line.startswith('VmHWM')))"
    done = subprocess.run([sys.executable, "-c", text + tell], capture_output=True, text=True, check=True, cwd=ROOT)
    return f"{float(done.stdout.split()[-1]) / 1024:.0f} MB"


def peak_of(words: Sequence[str]) -> str:
    """The most memory a command takes."""
    return peak(f"from planes.cli import main\nmain({list(words)!r})\n")


def pytest_terminal_summary(terminalreporter, config):
    session = getattr(config, "_benchmarksession", None)
    groups: dict[str, list] = {}
    for bench in session.benchmarks if session else ():
        if bench.stats.rounds:
            groups.setdefault(bench.group, []).append(bench)
    if groups:
        name, cores = processor_and_core_count()
        busy = f"{name}, {cores} cores, load {os.getloadavg()[0]:.1f}, Python {platform.python_version()}"
        terminalreporter.write_line(busy + "; processor time of the quickest round, in brackets of the middle one")
    for group, found in sorted(groups.items()):
        terminalreporter.write_line(f"{group}:")
        ours = next((b for b in found if b.extra_info["what"] == "fused"), found[0])
        for b in sorted(found, key=quickest):
            middle = b.stats.median / b.extra_info["positions"]
            terminalreporter.write_line(
                f"  {b.extra_info['what']:26} {quickest(b) * 1e9:12.1f} ({middle * 1e9:.1f}) ns/position"
                f"  x{quickest(b) / quickest(ours):.2f} {b.extra_info.get('memory', '')}"
            )


def quickest(bench) -> float:
    return bench.stats.min / bench.extra_info["positions"]
