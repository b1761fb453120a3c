"""Time per position: the compiled loop, arrays and single drawings, beside hand-written kernels and other tools.

Run: pytest tests/benchmarks
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from conftest import plans

from planes.angles import Span
from planes.cycle import Cycle
from planes.drawing import run
from planes.measuring import catalogue

kernels = pytest.importorskip("kernels")
COUNTS = (1, 360, 100_000)
MOTION = ("points", "links", "slides")


def asked(name: str, forces: bool) -> list[str]:
    known = catalogue(plans(name))
    return [n for n, q in known.items() if q.path[0] in MOTION or (forces and q.path[0] != "plans")]


def timed(benchmark, group: str, what: str, positions: int, work) -> None:
    benchmark.group, benchmark.extra_info["what"] = group, what
    benchmark.extra_info["positions"] = positions
    benchmark(work)


def through(cycle: Cycle, span: Span, fast: bool) -> None:
    for _ in cycle.blocks(span, fast=fast):
        pass


@pytest.mark.parametrize("count", COUNTS)
@pytest.mark.parametrize("forces", [False, True], ids=["motion", "forces"])
@pytest.mark.parametrize("name", ["four-bar", "slider-crank", "slotted lever", "six-link"])
@pytest.mark.parametrize("way", ["fused", "arrays", "one by one"])
def bench_ours(benchmark, name: str, forces: bool, count: int, way: str) -> None:
    cycle = Cycle(plans(name), asked(name, forces))
    start = plans(name).mechanism.drive.position - 5
    span = Span(start, 10 / count, count)
    if way == "one by one" and count > 1:
        pytest.skip("the time of one does not depend on how many")
    given = {**cycle.given, plans(name).drive_given: start}
    group = f"{name}, {'with forces' if forces else 'motion'}, {count}"
    if way == "one by one":
        timed(benchmark, group, way, count, lambda: run(cycle.program, given))
    else:
        timed(benchmark, group, way, count, lambda: through(cycle, span, way == "fused"))


def given(name: str, *keys: str) -> list[float]:
    return [plans(name).given[k] for k in keys]


def angles(name: str, count: int) -> np.ndarray:
    start = plans(name).mechanism.drive.position
    return Span(start - 5, 10 / count, count)[0:count]


def same(name: str, names: list[str], phis: np.ndarray, out: np.ndarray) -> None:
    """The hand-written kernel computes the same."""
    (block,) = Cycle(plans(name), names).blocks(phis[:: len(phis) // 300 + 1], fast=False)
    by_hand = out[:, :: len(phis) // 300 + 1]
    size = np.nanmax(np.abs(block.table), axis=1, keepdims=True) + 1e-3
    assert np.nanmax(np.abs(block.table - by_hand) / size) < 1e-9


@pytest.mark.parametrize("count", COUNTS[1:])
def bench_four_bar_by_hand(benchmark, count: int) -> None:
    drive, d = plans("four-bar").mechanism.drive, plans("four-bar").given["place_D"]
    numbers = [*given("four-bar", "l_AB", "l_BC", "l_DC"), d.real, d.imag, plans("four-bar").given["side_C"]]
    phis, out = angles("four-bar", count), np.empty((16, count))
    kernels.four_bar(phis, out, *numbers, drive.velocity, drive.acceleration)
    same("four-bar", kernels.FOUR_BAR_NAMES, phis, out)
    group = f"four-bar, the columns of the kernel, {count}"
    timed(benchmark, group, "hand-written kernel", count,
          lambda: kernels.four_bar(phis, out, *numbers, drive.velocity, drive.acceleration))  # fmt: skip


@pytest.mark.parametrize("count", COUNTS[1:])
def bench_six_link_by_hand(benchmark, count: int) -> None:
    m, d = plans("six-link").mechanism, plans("six-link").given["place_D"]
    numbers = [*given("six-link", "l_AB", "l_BC", "l_DC"), d.real, d.imag, plans("six-link").given["side_C"]]
    numbers += [0.2, -0.42, m.drive.velocity, m.drive.acceleration]
    numbers += [x for k in "123" for x in (m.links[k].mass, m.links[k].inertia)]
    numbers += [m.links["5"].mass, 6000.0, m.gravity]
    phis, out = angles("six-link", count), np.empty((52, count))
    kernels.six_link(phis, out, *numbers)
    same("six-link", kernels.SIX_LINK_NAMES, phis, out)
    group = f"six-link, the columns of the kernel, {count}"
    timed(benchmark, group, "hand-written kernel", count, lambda: kernels.six_link(phis, out, *numbers))


@pytest.mark.parametrize("count", COUNTS[1:])
def bench_slider_crank_by_hand(benchmark, count: int) -> None:
    drive, foot = plans("slider-crank").mechanism.drive, plans("slider-crank").given["place_°q-q"]
    way = math.radians(plans("slider-crank").given["angle_∥q-q"])
    numbers = [*given("slider-crank", "l_AB", "l_BC"), foot.real, foot.imag, math.cos(way), math.sin(way)]
    numbers += [1.0, drive.velocity, drive.acceleration]
    phis, out = angles("slider-crank", count), np.empty((14, count))
    kernels.slider_crank(phis, out, *numbers)
    same("slider-crank", kernels.SLIDER_CRANK_NAMES, phis, out)
    group = f"slider-crank, the columns of the kernel, {count}"
    timed(benchmark, group, "hand-written kernel", count, lambda: kernels.slider_crank(phis, out, *numbers))


@pytest.mark.parametrize("count", COUNTS[1:])
def bench_slotted_lever_by_hand(benchmark, count: int) -> None:
    drive, c = plans("slotted lever").mechanism.drive, plans("slotted lever").given["place_C"]
    numbers = [*given("slotted lever", "l_AB"), c.real, c.imag, drive.velocity, drive.acceleration]
    phis, out = angles("slotted lever", count), np.empty((4, count))
    kernels.slotted_lever(phis, out, *numbers)
    same("slotted lever", kernels.SLOTTED_NAMES, phis, out)
    group = f"slotted lever, the columns of the kernel, {count}"
    timed(benchmark, group, "hand-written kernel", count, lambda: kernels.slotted_lever(phis, out, *numbers))


COLUMNS = {"four-bar": kernels.FOUR_BAR_NAMES, "slider-crank": kernels.SLIDER_CRANK_NAMES,
           "slotted lever": kernels.SLOTTED_NAMES, "six-link": kernels.SIX_LINK_NAMES}  # fmt: skip


@pytest.mark.parametrize("count", COUNTS[1:])
@pytest.mark.parametrize("name", list(COLUMNS))
@pytest.mark.parametrize("way", ["fused", "arrays"])
def bench_kernel_columns(benchmark, name: str, count: int, way: str) -> None:
    cycle = Cycle(plans(name), COLUMNS[name])
    span = Span(plans(name).mechanism.drive.position - 5, 10 / count, count)
    timed(benchmark, f"{name}, the columns of the kernel, {count}", way, count,
          lambda: through(cycle, span, way == "fused"))  # fmt: skip


@pytest.mark.parametrize("count", COUNTS[1:])
def bench_pylinkage(benchmark, count: int) -> None:
    pylinkage = pytest.importorskip("pylinkage")
    from pylinkage.actuators import Crank
    from pylinkage.components import Ground
    from pylinkage.dyads import RRRDyad
    from pylinkage.simulation import Linkage

    p = plans("four-bar")
    d, omega = p.given["place_D"], p.mechanism.drive.velocity
    a, b = Ground(0.0, 0.0, name="A"), Ground(d.real, d.imag, name="D")
    crank = Crank(anchor=a, radius=p.given["l_AB"], angular_velocity=math.tau / count, initial_angle=0.3, name="B")
    dyad = RRRDyad(crank.output, b, p.given["l_BC"], p.given["l_DC"], name="C")
    linkage = Linkage([a, b, crank, dyad], name="four-bar")
    linkage.set_input_velocity(crank, omega=omega, alpha=p.mechanism.drive.acceleration)
    linkage.step_fast_with_kinematics(count, 1.0)
    timed(benchmark, f"four-bar, the columns of the kernel, {count}", f"pylinkage {pylinkage.__version__}", count,
          lambda: linkage.step_fast_with_kinematics(count, 1.0))  # fmt: skip


@pytest.mark.parametrize("count", COUNTS[1:])
def bench_kinepy(benchmark, count: int) -> None:
    kinepy = pytest.importorskip("kinepy")
    p = plans("four-bar")
    r, l2, l3, d = *given("four-bar", "l_AB", "l_BC", "l_DC"), p.given["place_D"]
    system = kinepy.System()
    one, two, three = (system.add_solid(name) for name in ("1", "2", "3"))
    crank = system.add_revolute(0, one, (0, 0), (0, 0))
    system.add_revolute(one, two, (r, 0), (0, 0))
    system.add_revolute(two, three, (l2, 0), (l3, 0))
    system.add_revolute(three, 0, (0, 0), (d.real, d.imag))
    system.pilot(crank)
    system.compile()
    phis = np.radians(angles("four-bar", count))
    timed(benchmark, f"four-bar, the columns of the kernel, {count}", "kinepy (differences)", count,
          lambda: system.solve_kinematics(phis))  # fmt: skip
