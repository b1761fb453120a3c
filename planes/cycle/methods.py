"""Speed and accuracy of every way to compute a mechanism: measured on the spot against 50 digits."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any

import numpy as np

from planes.cycle import Cycle, fused
from planes.cycle.contrast import Loops, differences
from planes.cycle.digits import Digits
from planes.cycle.reading import read
from planes.cycle.tracing import given_values
from planes.drawing import Drawing, run
from planes.instruments import Pencil
from planes.mechanism import FRAME
from planes.naming import plan_of
from planes.plans import Plans
from planes.scales import FIT_MM, scales
from planes.wording import PlanFailure

MANY, FEW, STEP = 100_000, 48, 1e-3
SHEETS = {"A4": 0.5**0.5, "A3": 1.0, "A2": 2.0**0.5, "A1": 2.0, "A0": 2.0**1.5}
RULERS = (0.5, 0.1)


@dataclass(frozen=True)
class Method:
    """One mark of the chart: a word of the table with its number, seconds per position, largest relative error."""

    key: str
    number: str
    seconds: float
    error: float


class Bench:
    """A mechanism to try the methods on: places, velocities and accelerations of its moving points."""

    def __init__(self, plans: Plans) -> None:
        self.plans = plans
        moving = dict.fromkeys(p for x in plans.mechanism.links.values() for p in x.points)
        names = [f"{letter}_{p}" for letter in "rva" for p in moving if p not in plans.mechanism.frame.points]
        self.points = [p for p in moving if p not in plans.mechanism.frame.points]
        self.cycle = Cycle(plans, names)
        self.letters = np.array([c.name[0] for c in self.cycle.columns])

    @cached_property
    def working(self) -> Any:
        """Values of the drive, over a turn or around a slider's place, at which everything can be drawn."""
        drive = self.plans.mechanism.drive
        reach = max((abs(v) for k, v in self.plans.given.items() if k.startswith("l_")), default=1.0)
        values = np.arange(360.0) if drive.kind == "phi" else drive.position + np.linspace(-0.1, 0.1, 360) * reach
        codes = np.hstack([b.codes for b in self.cycle.blocks(values, fast=False)])
        good = values[codes == 0]
        return good[np.linspace(0, len(good) - 1, min(FEW, len(good))).astype(int)] if len(good) else good

    def taken(self, drawing: Drawing) -> list[Any]:
        """The columns of one drawing."""
        return [c.take(drawing.things, drawing.hand.ar) for c in self.cycle.columns]

    def one(self, value: float, instrument: Any = None) -> list[Any]:
        """The columns at one value, drawn by itself."""
        return self.taken(run(self.cycle.program, {**self.cycle.given, self.plans.drive_given: value}, instrument))

    def truth(self, values: Any) -> Any:
        """The columns at 50 digits, rounded once."""
        return np.array([[float(x) for x in self.one(float(v), Digits(50))] for v in values]).T

    def error(self, found: Any, truth: Any) -> Any:
        """The largest error at each position, relative to the largest place, velocity or acceleration."""
        worst = np.zeros(truth.shape[1])
        for letter in "rva":
            rows = self.letters == letter
            if rows.any():
                worst = np.maximum(worst, np.abs(found - truth)[rows].max(axis=0) / np.abs(truth[rows]).max())
        return worst

    def many(self, values: Any, fast: bool) -> Any:
        """The columns by arrays or by the compiled loop."""
        return np.hstack([b.table for b in self.cycle.blocks(values, fast=fast)])

    def through(self, values: Any, fast: bool) -> int:
        """The same, each block let go of as soon as it is there; how many blocks."""
        return sum(1 for _ in self.cycle.blocks(values, fast=fast))

    def single(self, values: Any) -> Any:
        """The same in numbers of 24 bits."""
        tape = self.cycle.trace.tape
        order = tape.needed(list(self.cycle.trace.outputs))
        parts = [values[i : i + 4096] for i in range(0, len(values), 4096)]
        return np.hstack([self._single(order, part) for part in parts])

    def _single(self, order: list[int], part: Any) -> Any:
        given = {**given_values(self.cycle.given), self.plans.drive_given: part}
        found = read(self.cycle.trace.tape, order, given, np.float32)
        return np.array([np.broadcast_to(found[o], part.shape) for o in self.cycle.trace.outputs])

    def differences(self, values: Any, step: float = STEP) -> Any:
        """Velocities and accelerations from differences of exact places."""
        drive = self.plans.mechanism.drive
        rows = self.letters == "r"
        places = Cycle(self.plans, [f"r_{p}" for p in self.points])

        def at(phi: Any) -> Any:
            return np.hstack([b.table for b in places.blocks(phi, fast=False)])

        found = np.empty((len(self.letters), len(values)))
        found[rows] = at(values)
        found[self.letters == "v"], found[self.letters == "a"] = differences(
            at, values, drive.velocity, drive.acceleration, step
        )
        return found

    def newton(self, values: Any) -> Any:
        """Closed loops by iteration, each position begun from the one before."""
        drive, loops = self.plans.mechanism.drive, Loops(self.plans)
        begun = run(self.plans.program, {**self.cycle.given, self.plans.drive_given: float(values[0])})
        q, rows = loops.start(begun.__getitem__), []
        for value in values:
            phi = math.radians(value)
            phi += 2 * math.pi * round((loops.pose(q, drive.link)[1] - phi) / (2 * math.pi))
            q = loops.newton(q, phi)
            known = loops.points(q, *loops.rates(q, phi, drive.velocity, drive.acceleration))
            rows.append({f"{letter}_{p}": known[p][k] for k, letter in enumerate("rva") for p in self.points})
        return np.array([[_part(row, c.name) for c in self.cycle.columns] for row in rows]).T


def _part(row: dict[str, complex], name: str) -> float:
    z = row[name[:-2]]
    return z.real if name.endswith("_x") else z.imag


def clock(work: Callable[[], object], times: int = 3) -> float:
    """Seconds of the quickest of several runs, the first one (which compiles) not counted."""
    work()
    best = math.inf
    for _ in range(times):
        start = time.perf_counter()
        work()
        best = min(best, time.perf_counter() - start)
    return best


def measure(plans: Plans) -> list[Method]:
    """Every method on one mechanism. :class:`PlanFailure` where no position of it can be drawn."""
    bench = Bench(plans)
    values = bench.working
    if not len(values):
        raise PlanFailure("no_working")
    truth = bench.truth(values)
    long = np.resize(values, MANY)
    found = []

    def add(
        key: str, number: str, work: Callable[[Any], Any], timed: Any, again: Callable[[Any], Any] | None = None
    ) -> None:
        error = float(np.max(bench.error(work(values), truth)))
        seconds = clock(lambda: (again or work)(timed)) / len(timed)
        found.append(Method(key, number, seconds, max(error, 2.0**-54)))

    add("method_scalar", "", lambda v: np.array([bench.one(float(x)) for x in v]).T, values)
    add("method_batch", "", lambda v: bench.many(v, False), long, lambda v: bench.through(v, False))
    if fused.available():
        add("method_fused", "", lambda v: bench.many(v, True), long, lambda v: bench.through(v, True))
    add("method_single", "", bench.single, long)
    for digits in (30, 50):
        add("method_digits", str(digits), partial(_long, bench, digits=digits), values[:12])
    if plans.mechanism.drive.kind == "phi":
        add("method_differences", "", bench.differences, long)
        if all(x.points or x.name == FRAME for x in plans.mechanism.links.values()):
            add("method_newton", "", bench.newton, values)
    return found + _pencils(bench, values, truth)


def _long(bench: Bench, values: Any, digits: int) -> Any:
    return np.array([[float(x) for x in bench.one(float(v), Digits(digits))] for v in values]).T


def _pencils(bench: Bench, values: Any, truth: Any) -> list[Method]:
    """Pencils on sheets of every format, with a good ruler and a better one."""
    found = []
    for sheet, factor in SHEETS.items():
        fit = {plan: size * factor for plan, size in FIT_MM.items()}
        mus = scales(bench.plans, {}, {bench.plans.drive_given: float(values[len(values) // 2])}, fit)
        for ruler in RULERS:
            pencil = Pencil(ruler_mm=ruler)
            given = {**bench.cycle.given, **mus, bench.plans.drive_given: values}
            drawing = run(bench.cycle.program, given, pencil)
            with np.errstate(all="ignore"):
                ruled = np.array([_ruled(c, drawing, mus, ruler) for c in bench.cycle.columns])
                error = np.nanmax(bench.error(ruled, truth))
            one = {**given, bench.plans.drive_given: float(values[0])}
            seconds = clock(partial(_try, bench, one, pencil), 20)
            found.append(Method("method_pencil", f"{sheet}, {ruler:g}", seconds, float(error)))
    return found


def _try(bench: Bench, given: dict[str, Any], pencil: Pencil) -> None:
    try:
        run(bench.cycle.program, given, pencil)
    except PlanFailure:
        return


def _ruled(column: Any, drawing: Drawing, mus: dict[str, float], ruler: float) -> Any:
    """A column as read off with the ruler."""
    mu = mus["mu_" + plan_of(column.start)]
    size = np.broadcast_to(column.take(drawing.things, drawing.hand.ar), drawing.hand.shape) * mu
    return np.round(size / ruler) * ruler / mu


def front(methods: list[Method]) -> list[Method]:
    """The methods than which no other is both faster and more exact, the fastest first."""
    best: list[Method] = []
    for m in sorted(methods, key=lambda m: (m.seconds, m.error)):
        if not best or m.error < best[-1].error:
            best.append(m)
    return best
