"""Time per position: the compiled loop, arrays and single drawings, beside hand-written kernels and other tools.

Run: pytest tests/benchmarks
"""

from __future__ import annotations

import pytest
from conftest import SAMPLES, SCENES, angles, peak, plans

from planes.batch.cycle import Cycle
from planes.drafting.drawing import draw_program
from planes.drafting.program import Program
from planes.plans.quantities import MOTION_GROUPS, quantities_by_name
from planes.scene import load
from planes.scene.ranges import Span
from planes.solving import plans_and_requested_results, solve

rivals = pytest.importorskip("rivals")
COUNTS = (360, 100_000)
LENGTHS = (10**3, 10**4, 10**5, 10**6, 10**7)


def timed(benchmark, group: str, what: str, positions: int, work) -> None:
    benchmark.group, benchmark.extra_info["what"] = group, what
    benchmark.extra_info["positions"] = positions
    benchmark(work)


def through(cycle: Cycle, values, fast: bool, bare: bool = False) -> None:
    for _ in cycle.blocks(values, fast=fast, bare=bare):
        pass


def asked(name: str, forces: bool) -> list[str]:
    known = quantities_by_name(plans(name))
    return [n for n, q in known.items() if q.group in MOTION_GROUPS or (forces and q.group != "plans")]


@pytest.mark.parametrize("who", ["fused", "hand-written kernel", "arrays", "pylinkage", "kinepy"])
@pytest.mark.parametrize("count", COUNTS)
@pytest.mark.parametrize("name", list(SCENES))
def bench_side_by_side(benchmark, name: str, count: int, who: str) -> None:
    """The columns of the hand-written kernel, from the same array of angles; kinepy gives places only."""
    cycle, values = Cycle(plans(name), rivals.COLUMNS[name]), angles(name, count)
    others = {"hand-written kernel": rivals.by_hand, "pylinkage": rivals.pylinkage, "kinepy": rivals.kinepy}
    work = others[who](name, count) if who in others else lambda: through(cycle, values, who == "fused")
    if work is None:
        pytest.skip(f"{who} is not installed, or has no such group")
    timed(benchmark, f"{name}, the columns of the kernel, {count}", who, count, work)


@pytest.mark.parametrize(
    "name",
    [
        "kind-1-rrr",
        *(f"class-three/{n}" for n in ("guide", "mixtures/pp-rr-rr", "press", "rods", "slider", "stephenson")),
        "class-four/tray",
    ],
)
@pytest.mark.parametrize("bare", [True, False], ids=["bare", "looked at"])
def bench_higher_classes(benchmark, name: str, bare: bool) -> None:
    """Places, velocities and accelerations of one assembly over the whole turn, beside a group of class II; ``bare``,
    or with what rounding leaves no digits looked for."""
    stated, count = plans_and_requested_results(load(str(SAMPLES / f"{name}.yaml")))[0], 100_000
    motion = [n for n, q in quantities_by_name(stated).items() if q.group in MOTION_GROUPS]
    cycle, values = Cycle(stated, motion), Span(0.0, 360.0 / count, count)[0:count]
    group = f"classes III and IV, {'bare' if bare else 'looked at'}"
    timed(benchmark, group, name, count, lambda: through(cycle, values, True, bare))


@pytest.mark.parametrize("way", ["fused", "arrays", "one by one"])
@pytest.mark.parametrize("forces", [False, True], ids=["motion", "forces"])
@pytest.mark.parametrize("count", (1, *COUNTS))
@pytest.mark.parametrize("name", list(SCENES))
def bench_everything(benchmark, name: str, count: int, forces: bool, way: str) -> None:
    """All columns of a scene; "one by one" is the drawing itself with its steps."""
    if way == "one by one" and count > 1:
        pytest.skip("the time of one does not depend on how many")
    cycle, values = Cycle(plans(name), asked(name, forces)), angles(name, count)
    given = {**cycle.given, plans(name).drive_given_name: float(values[0])}
    group = f"{name}, all {'with forces' if forces else 'of motion'}, {count}"
    drawn = {"one by one": lambda: draw_program(cycle.program, given)}
    timed(benchmark, group, way, count, drawn.get(way, lambda: through(cycle, values, way == "fused")))


@pytest.mark.parametrize("way", ["fused", "arrays"])
@pytest.mark.parametrize("proved", [True, False], ids=["proved", "unproved"])
@pytest.mark.parametrize("name", list(SCENES))
def bench_proofs(benchmark, name: str, proved: bool, way: str) -> None:
    """What it costs to prove every position."""
    cycle, values = Cycle(plans(name)), angles(name, 80_000)
    cycle.program = cycle.program if proved else Program(cycle.program.steps)
    what = "proved" if proved else "unproved"
    timed(benchmark, f"{name}, {way}", what, len(values), lambda: through(cycle, values, way == "fused"))


@pytest.mark.parametrize("count", LENGTHS)
@pytest.mark.parametrize("way", ["fused", "arrays"])
def bench_length(benchmark, count: int, way: str) -> None:
    """A six-link with all forces, more and more positions; and the most memory a process of its own takes for them."""
    cycle, values = Cycle(plans("six-link"), asked("six-link", True)), Span(145.0, 10 / count, count)
    benchmark.extra_info["memory"] = memory(way, count)
    benchmark.group = f"six-link, all with forces, {way}, how long"
    benchmark.extra_info |= {"what": f"{count} positions", "positions": count}
    rounds = max(3, min(200, 2 * 10**6 // count))
    benchmark.pedantic(lambda: through(cycle, values, way == "fused"), rounds=rounds, warmup_rounds=1)


def memory(way: str, count: int) -> str:
    """Of a process that goes through so many positions."""
    return peak(
        "from planes.scene.ranges import Span\nfrom planes.batch.cycle import Cycle\n"
        "from planes.plans import plans_of\nfrom planes.scene import load\n"
        f"cycle = Cycle(plans_of(load({str(SAMPLES / 'six-link.yaml')!r}).mechanism))\n"
        f"for _ in cycle.blocks(Span(145.0, {10 / count}, {count}), fast={way == 'fused'}): pass\n"
    )


@pytest.mark.parametrize("what", ["steps drawn", "drawn, measured and told"])
def bench_one_plan(benchmark, what: str) -> None:
    """One position of the six-link with every plan, one step after another; and all that ``planes solve`` does then."""
    scene, p = load(str(SAMPLES / "six-link.yaml")), plans("six-link")
    given = {**p.given, **dict.fromkeys(Cycle(p).mus, 1000.0)}
    works = {"steps drawn": lambda: draw_program(p.program, given), "drawn, measured and told": lambda: solve(scene)}
    timed(benchmark, "six-link, one plan of every sort", what, 1, works[what])
