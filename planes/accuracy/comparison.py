"""A mechanism prepared for comparing all methods at the same positions."""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cached_property

import numpy as np

from planes.accuracy.baselines import Loops, rates_by_central_differences
from planes.accuracy.digits import Digits
from planes.batch.array_ops import numbers_at_places
from planes.batch.cycle import BLOCK_POSITIONS, Cycle
from planes.batch.tracing import given_values_by_name
from planes.drafting.drawing import Drawing, draw_program
from planes.drafting.instruments import Instrument
from planes.geometry.arithmetic import Real
from planes.geometry.arrays import Array, FloatsByName
from planes.plans import Plans
from planes.words.errors import PlanFailure
from planes.words.frozen import frozen

COMPARED_POSITIONS = 48
DIFFERENCE_STEP = 1e-3
Work = Callable[[Array], Array]
Triple = tuple[complex, complex, complex]  # place, velocity, acceleration


class Comparison:
    """Places, velocities and accelerations of a mechanism's moving points, by several methods.

    Every method takes positions of the drive and returns a row for each column, NaN where it refuses. Where lengths or
    angles change with the drive (``known``, as in :class:`Cycle`), ``variants`` are the plans of each position.
    ``begins`` are the indices at which a new path begins.
    """

    def __init__(
        self,
        plans: Plans,
        known: FloatsByName | None = None,
        variants: Sequence[Plans] | None = None,
        begins: frozenset[int] = frozenset({0}),
    ) -> None:
        self.plans = plans
        self.variants = variants
        self.begins = begins
        moving = dict.fromkeys(p for x in plans.mechanism.links.values() for p in x.points)
        self.points = [p for p in moving if p not in plans.mechanism.frame.points]
        self.cycle = Cycle(plans, [f"{letter}_{p}" for letter in "rva" for p in self.points], known)
        self.letters = np.array([c.name[0] for c in self.cycle.columns])

    def plans_at(self, k: int) -> Plans:
        """The plans of a position."""
        return self.variants[k] if self.variants else self.plans

    @cached_property
    def working_positions(self) -> Array:
        """Positions of the drive, over a turn or around a slider's position, at which all steps can be drawn."""
        drive = self.plans.drive
        near = np.linspace(-0.1, 0.1, 360)
        values = np.arange(360.0) if drive.rotates else drive.position + near * self.plans.longest_link_length
        codes = np.hstack([b.codes for b in self.cycle.blocks(values, fast=False)])
        good = np.asarray(values[codes == 0])
        return (
            good[np.linspace(0, len(good) - 1, min(COMPARED_POSITIONS, len(good))).astype(int)] if len(good) else good
        )

    def columns_of_drawing(self, drawing: Drawing) -> list[Real]:
        """The columns of one drawing."""
        return [c.read_from_drawing(drawing.things, drawing.tool.ar) for c in self.cycle.columns]

    def draw_position(self, value: Real, instrument: Instrument | None = None, k: int = 0) -> Drawing:
        """A single drawing of one position; ``k`` is its index in ``known``."""
        beside = {name: v[k].item() for name, v in self.cycle.moved.items()}
        return draw_program(
            self.cycle.program, {**self.cycle.given, **beside, self.plans.drive_given_name: value}, instrument
        )

    def draw_positions(self, values: Array, instrument: Instrument | None = None) -> Iterator[Drawing | None]:
        """One position after another; None where it cannot be drawn."""
        for k, value in enumerate(values):
            try:
                yield self.draw_position(float(value), instrument, k)
            except PlanFailure:
                yield None

    def columns_of_drawings(self, drawings: Iterable[Drawing | None]) -> Array:
        """The columns of drawings."""
        lost = [math.nan] * len(self.letters)
        return np.array([[float(x) for x in self.columns_of_drawing(d)] if d else lost for d in drawings]).T

    def columns_one_by_one(self, values: Array, instrument: Instrument | None = None) -> Array:
        """The columns one position after another."""
        return self.columns_of_drawings(self.draw_positions(values, instrument))

    def true_columns(self, values: Array) -> Array:
        """The columns at 50 digits, rounded only once."""
        return self.columns_one_by_one(values, Digits(50))

    def error(self, measured: Array, truth: Array) -> Array:
        """The largest error in each position, relative to the largest place, velocity or acceleration of all."""
        worst = np.zeros(truth.shape[1])
        known = ~np.isnan(measured).all(axis=1)
        for letter in "rva":
            rows = (self.letters == letter) & known
            if rows.any():
                size = np.abs(truth[rows]).max() or 1.0
                worst = np.maximum(worst, np.abs(measured - truth)[rows].max(axis=0) / size)
        return worst if known.any() else worst * math.nan

    def largest_magnitudes(self, truth: Array) -> Array:
        """For each column and position the largest place, velocity or acceleration there, of the same kind."""
        largest = {letter: np.abs(truth[self.letters == letter]).max(axis=0) for letter in "rva"}
        return np.array([np.where(largest[letter] > 0, largest[letter], 1.0) for letter in self.letters])

    def columns_by_loop(self, values: Array, fast: bool) -> Array:
        """The columns by arrays or by the compiled loop."""
        return self.cycle.table(values, fast=fast)[0]

    def count_blocks_by_loop(self, values: Array, fast: bool) -> int:
        """The same, with each block released at once; returns the number of blocks."""
        return sum(1 for _ in self.cycle.blocks(values, fast=fast, bare=True))

    def columns_in_single_precision(self, values: Array) -> Array:
        """The same in 24-bit floats."""
        trace = self.cycle.trace
        order = trace.tape.places_needed(list(trace.outputs))
        rows = []
        for i in range(0, len(values), BLOCK_POSITIONS):
            part = values[i : i + BLOCK_POSITIONS]
            given = given_values_by_name(
                {**self.cycle.given, **self.cycle.changing_inputs(part, slice(i, i + len(part)))}
            )
            numbers = numbers_at_places(trace.tape, order, given, np.float32)
            rows.append(np.array([np.broadcast_to(numbers[o], part.shape) for o in trace.outputs]))
        return np.hstack(rows)

    def columns_by_differences(self, values: Array, step: float = DIFFERENCE_STEP) -> Array:
        """Velocities and accelerations from differences of exact places over a step (rad, or a fraction of the
        reach)."""
        drive = self.plans.drive
        places = Cycle(self.plans, [f"r_{p}" for p in self.points], self.cycle.moved)
        width, unit = (step, math.degrees(step)) if drive.rotates else (step * self.plans.longest_link_length,) * 2

        table = np.empty((len(self.letters), len(values)))
        here, back, on = (places.table(x, fast=False)[0] for x in (values, values - unit, values + unit))
        table[self.letters == "r"] = here
        table[self.letters == "v"], table[self.letters == "a"] = rates_by_central_differences(
            here, back, on, drive.velocity, drive.acceleration, width
        )
        return table

    def columns_by_newton(self, values: Array) -> Array:
        """Closed loops by iteration; each position of a path starts from the one before."""
        drive = self.plans.drive
        q = np.empty(0)
        poses = []
        for k, value in enumerate(values):
            plans = self.plans_at(k)
            loops = Loops(plans)
            if k in self.begins:
                given = {**plans.given, **self.cycle.mus, plans.drive_given_name: float(value)}
                q = loops.start_pose(draw_program(plans.program, given).__getitem__)
            try:
                q = loops.nearest_pose_by_newton(q, loops.drive_target_in_loop_units(q, float(value)))
                poses.append(loops.point_motions(q, *loops.pose_rates(q, drive.velocity, drive.acceleration)))
            except np.linalg.LinAlgError:
                poses.append({})
        return self.columns_from_point_results(poses)

    def columns_from_point_results(self, poses: Sequence[Mapping[str, Triple]]) -> Array:
        """Columns of positions from the results for their points."""
        return np.array([self._columns_from_triples(triples) for triples in poses]).T

    def _columns_from_triples(self, triples: Mapping[str, Triple]) -> list[float]:
        """Columns from places, velocities and accelerations by point; NaN where one is missing."""
        row = []
        for column in self.cycle.columns:
            letter = column.name[0]
            point = column.name[2:-2]
            part = column.name[-1]
            z = triples[point]["rva".index(letter)] if point in triples else complex("nan+nanj")
            row.append(z.real if part == "x" else z.imag)
        return row


@frozen
class OtherProgram:
    """Another program, for comparison: its name, whether it can solve a mechanism's groups, its columns at positions of
    the drive, and its fastest run over as many as ``most`` positions, for timing."""

    name: str
    can: Callable[[Plans], bool]
    work: Callable[[Comparison, Array], Array]
    quickest: Callable[[Comparison, Array], Callable[[Array], object]]
    most: int
