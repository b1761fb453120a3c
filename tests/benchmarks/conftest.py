"""Mechanisms to time, and a summary of ratios after the timings."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from planes.plans import Plans, state
from planes.scene import load

SAMPLES = Path(__file__).parents[2] / "samples"
SCENES = {"four-bar": "kind-1-rrr", "slider-crank": "kind-2-rrp", "slotted lever": "kind-3-rpr", "six-link": "six-link"}


@cache
def plans(name: str) -> Plans:
    mechanism = load(str(SAMPLES / f"{SCENES[name]}.yaml")).mechanism
    assert mechanism
    return state(mechanism)


def pytest_terminal_summary(terminalreporter, config):
    session = getattr(config, "_benchmarksession", None)
    groups: dict[str, list] = {}
    for bench in session.benchmarks if session else ():
        if bench.stats.rounds:
            groups.setdefault(bench.group, []).append(bench)
    for group, found in sorted(groups.items()):
        terminalreporter.write_line(f"{group}:")
        ours = next((b for b in found if "fused" in b.name), found[0])
        for b in sorted(found, key=lambda b: b.stats.median / b.extra_info["positions"]):
            each = b.stats.median / b.extra_info["positions"]
            base = ours.stats.median / ours.extra_info["positions"]
            what = b.extra_info["what"]
            terminalreporter.write_line(f"  {what:34} {each * 1e9:12.1f} ns/position  x{each / base:.2f}")
