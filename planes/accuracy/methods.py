"""Speed and accuracy of all methods on a mechanism: measured here and now against 50 digits."""

import os
import platform
from collections.abc import Callable, Sequence
from contextlib import suppress
from functools import partial
from pathlib import Path
from time import process_time
from timeit import repeat

import numpy as np

from planes.accuracy.comparison import Comparison, OtherProgram, Work
from planes.accuracy.digits import Digits
from planes.batch import compiled
from planes.drafting.drawing import Drawing, draw_program
from planes.drafting.instruments import Pencil
from planes.drafting.tools import Things
from planes.geometry.arrays import Array
from planes.plans import Plans
from planes.plans.columns import Column
from planes.plans.scales import PLAN_FIT_MM, plan_scales
from planes.words import Lang, say, sentence_table
from planes.words.errors import PlanFailure
from planes.words.frozen import frozen
from planes.words.names import NumbersByName

TIMED_POSITIONS = 100_000
SCALE_FACTOR_BY_FORMAT = {"A4": 0.5**0.5, "A3": 1.0, "A2": 2.0**0.5, "A1": 2.0, "A0": 2.0**1.5}
RULER_RESOLUTIONS_MM = (0.5, 0.1)


@frozen
class Method:
    """One mark of the chart: a word of the table with its number, or a name; seconds per position, largest relative
    error."""

    key: str
    number: str
    seconds: float
    error: float

    def name_in_language(self, lang: Lang) -> str:
        """The name of the method."""
        return method_in_words(self.key, self.number, lang)


def method_in_words(key: str, number: str, lang: Lang) -> str:
    """A method in words; other programs have proper names."""
    return say(key, lang, number=number) if key in sentence_table(lang) else key


def processor_and_core_count() -> tuple[str, int]:
    """The processor that times are measured on, and the number of its cores."""
    name = platform.processor() or platform.machine()
    cpuinfo = Path("/proc/cpuinfo")
    if cpuinfo.exists():
        lines = cpuinfo.read_text(encoding="utf-8").splitlines()
        name = next((line.partition(": ")[2] for line in lines if line.startswith("model name")), name)
    return name, os.cpu_count() or 1


def fastest_run_seconds(work: Callable[[], object], times: int = 3) -> float:
    """Seconds of the fastest of several runs, without the first one (which compiles); CPU time, so that other processes
    do not matter."""
    work()
    return min(repeat(work, timer=process_time, repeat=times, number=1))


def measure_methods(plans: Plans, others: Sequence[OtherProgram] = ()) -> list[Method]:
    """All methods on one mechanism, with programs by ``others``. :class:`PlanFailure` where no position of it can be
    drawn."""
    bench = Comparison(plans)
    values = bench.working_positions
    if not len(values):
        raise PlanFailure("no_working")
    truth = bench.true_columns(values)
    long = np.resize(values, TIMED_POSITIONS)
    methods = []

    def add(
        key: str, work: Work, timed: Array, again: Callable[[Array], object] | None = None, number: str = ""
    ) -> None:
        error = float(np.nanmax(bench.error(work(values), truth)))
        seconds = fastest_run_seconds(lambda: (again or work)(timed)) / len(timed)
        methods.append(Method(key, number, seconds, max(error, 2.0**-54)))

    add("method_scalar", bench.columns_one_by_one, values)
    for key, fast in (("method_batch", False), ("method_compiled", True)):
        if not fast or compiled.is_compiler_available():
            blocks = partial(bench.count_blocks_by_loop, fast=fast)
            add(key, partial(bench.columns_by_loop, fast=fast), long, blocks)
    add("method_single", bench.columns_in_single_precision, long)
    for digits in (30, 50):
        exact = partial(bench.columns_one_by_one, instrument=Digits(digits))
        add("method_digits", exact, values[:12], number=str(digits))
    add("method_differences", bench.columns_by_differences, long)
    add("method_newton", bench.columns_by_newton, values)
    for o in (o for o in others if o.can(plans)):
        add(o.name, partial(o.work, bench), long[: o.most], o.quickest(bench, values))
    return methods + _pencil_methods(bench, values, truth)


def _pencil_methods(bench: Comparison, values: Array, truth: Array) -> list[Method]:
    """Pencils on sheets of every format, with a good ruler and a better one."""
    methods = []
    for sheet, factor in SCALE_FACTOR_BY_FORMAT.items():
        fit = {plan: size * factor for plan, size in PLAN_FIT_MM.items()}
        mus = plan_scales(bench.plans, {}, {bench.plans.drive_given_name: float(values[len(values) // 2])}, fit)
        for ruler in RULER_RESOLUTIONS_MM:
            pencil = Pencil(ruler_mm=ruler)
            given = {**bench.cycle.given, **mus, bench.plans.drive_given_name: values}
            drawing = draw_program(bench.cycle.program, given, pencil)
            with np.errstate(all="ignore"):
                ruled = np.array([_column_by_ruler(c, drawing, mus, ruler) for c in bench.cycle.columns])
                error = np.nanmax(bench.error(ruled, truth))
            one = {**given, bench.plans.drive_given_name: float(values[0])}
            seconds = fastest_run_seconds(partial(_try_pencil_drawing, bench, one, pencil), 20)
            methods.append(Method("method_pencil", f"{sheet}, {ruler:g}", seconds, float(error)))
    return methods


def _try_pencil_drawing(bench: Comparison, given: Things, pencil: Pencil) -> None:
    with suppress(PlanFailure):
        draw_program(bench.cycle.program, given, pencil)


def _column_by_ruler(column: Column, drawing: Drawing, mus: NumbersByName, ruler: float) -> Array:
    """A column as read with the ruler."""
    mu = mus["mu_" + column.start.plan]
    size = np.broadcast_to(column.read_from_drawing(drawing.things, drawing.tool.ar), drawing.tool.shape) * mu
    return np.round(size / ruler) * ruler / mu
