"""A mechanism over its drive and one length: a function that vanishes where two assemblies merge, on a grid and along
curves.

A crossing with two solutions has an opening, which vanishes where they merge. A link on three leads has its assemblies
at the zeros of a trigonometric polynomial of its angle, and two merge where its derivative vanishes too. For several
links in hinges the assemblies are followed over the grid (``sheets``).
"""

import math
from collections.abc import Iterator
from functools import cached_property, partial

import numpy as np

from planes.accuracy.continuation import Curves, Equations, Room
from planes.accuracy.sheets import Sheets
from planes.accuracy.variation import growth_of_givens
from planes.drafting.drawing import Drawing, draw_program
from planes.drafting.program import Program
from planes.drafting.steps import Step
from planes.drafting.steps.crossings import TwoPlaces
from planes.drafting.steps.tracks import TrackStep
from planes.geometry.arithmetic import Arithmetic
from planes.geometry.arrays import Array, Booleans, Indices
from planes.geometry.tracks import CLOSURE_DEGREE_BOUND, Tie, closure_residual
from planes.plans import Plans
from planes.words.names import SCHEME_PLAN

# of the grid: positions of the drive, lengths, angles of a link
GRID_DRIVE_POSITIONS = 181
GRID_LENGTHS = 121
GRID_ANGLES = 96
CHAIN_GRID_COARSENING = 2  # steps with assemblies followed over it
CURVE_STEP = 0.05  # step along a curve: radians, fractions of the mechanism's reach, and of a length's logarithm
UNIT_CIRCLE_TOLERANCE = 1e-5  # distance of a root from the unit circle; rounding moves a double one by less
POLYNOMIAL_SAMPLE_ANGLES = 16  # angles that determine a trigonometric polynomial


class LengthField:
    """A mechanism over the drive and the logarithm of a length's factor."""

    def __init__(self, plans: Plans, name: str, times: float) -> None:
        self.plans = plans
        self.name = name
        self.base = {**plans.given, SCHEME_PLAN.mu_name: 1.0}
        self.slopes = growth_of_givens(plans, name)
        drive = plans.drive
        self.turns = drive.rotates
        self.unit = math.degrees(1) if self.turns else plans.longest_link_length
        own = drive.position / self.unit
        reach = math.log(times)
        by = CHAIN_GRID_COARSENING if any(map(_cuts_chain_track, self.steps_with_several_solutions)) else 1
        ends = (0.0, 2 * math.pi) if self.turns else (own - 1, own + 1)
        self.across = np.linspace(*ends, GRID_DRIVE_POSITIONS // by + 1)
        self.up = np.linspace(-reach, reach, GRID_LENGTHS // by + 1)

    def drive_value(self, x: Array) -> Array:
        """The drive's position."""
        return x * self.unit

    def length_value(self, y: Array) -> Array:
        """The length, m."""
        return np.asarray(self.plans.link_lengths[self.name] * np.exp(y))

    @property
    def track_cutting_steps(self) -> list[TrackStep]:
        """All steps that cut the tracks of these."""
        held = {s.holds for s in self.steps_with_several_solutions if isinstance(s, TrackStep)}
        return [s for s in self.plans.program.steps if isinstance(s, TrackStep) and s.holds in held]

    @cached_property
    def steps_with_several_solutions(self) -> list[Step]:
        """The steps with several solutions, except those attached to a track; for a link with one track, one of
        them."""
        steps: dict[object, Step] = {}
        for step in (s for s in self.plans.program.steps if isinstance(s, TwoPlaces | TrackStep)):
            if not any(isinstance(s, TrackStep) for s in self.program_for_step(step).steps):
                steps.setdefault(step.holds if isinstance(step, TrackStep) else step, step)
        return list(steps.values())

    @cached_property
    def is_complete(self) -> bool:
        """Whether the list is complete."""
        several = (s for s in self.plans.program.steps if isinstance(s, TwoPlaces | TrackStep))
        return all(s in self.steps_with_several_solutions or s in self.track_cutting_steps for s in several)

    def program_for_step(self, step: Step) -> Program:
        """The steps that a given step needs."""
        return self.plans.program.cut_to_names([name for name, _ in step.input_names()])

    def draw_field_places(self, program: Program, x: Array, y: Array) -> Drawing:
        """The drawing at many places of the field."""
        longer = np.exp(y) - 1
        given = {name: self.base[name] + slope * longer for name, slope in self.slopes.items()}
        return draw_program(program, {**self.base, **given, self.plans.drive_given_name: self.drive_value(x)})

    def opening_function(self, step: TwoPlaces) -> Equations:
        """The opening of a step at places (drive, length)."""
        program = self.program_for_step(step)

        def equations(at: Array) -> Array:
            drawing = self.draw_field_places(program, at[0], at[1])
            openings = step.opening_measure(drawing.things) + np.zeros(len(at[0]))
            return np.array([np.where(drawing.failed_mask(), np.nan, openings)])

        return equations

    def lead_ties(self, step: TrackStep, program: Program, x: Array, y: Array) -> list[Tie]:
        """The leads at many places."""
        drawing = self.draw_field_places(program, x, y)
        return [hold.lead_tie(drawing.things, 1.0, Arithmetic()) for hold in step.holds]

    def closure_polynomial_terms(self, step: TrackStep, program: Program, x: Array, y: Array) -> Array:
        """The closure of a link as a trigonometric polynomial of its angle: terms -``DEGREE`` … ``DEGREE``."""
        around = np.exp(2j * math.pi * np.arange(POLYNOMIAL_SAMPLE_ANGLES) / POLYNOMIAL_SAMPLE_ANGLES)[:, None]
        samples = closure_residual(self.lead_ties(step, program, x, y), around) + np.zeros(
            (POLYNOMIAL_SAMPLE_ANGLES, len(x))
        )
        return np.asarray(
            np.fft.fft(samples, axis=0)[np.arange(-CLOSURE_DEGREE_BOUND, CLOSURE_DEGREE_BOUND + 1)]
            / POLYNOMIAL_SAMPLE_ANGLES
        )

    def fold_function(self, step: TrackStep) -> Equations:
        """The closure of a link and its derivative at places (drive, length, angle of the link)."""
        program, powers = (
            self.program_for_step(step),
            np.arange(-CLOSURE_DEGREE_BOUND, CLOSURE_DEGREE_BOUND + 1)[:, None],
        )

        def equations(at: Array) -> Array:
            parts = self.closure_polynomial_terms(step, program, at[0], at[1]) * np.exp(1j * powers * at[2])
            return np.array([parts.sum(axis=0).real, (1j * powers * parts).sum(axis=0).real])

        return equations

    @cached_property
    def grid_nodes(self) -> Array:
        """The grid, one column per node: drive and length."""
        y, x = np.meshgrid(self.up, self.across, indexing="ij")
        return np.array([x.ravel(), y.ravel()])

    @property
    def grid_shape(self) -> tuple[int, int]:
        """The shape of the grid: lengths and positions of the drive."""
        return len(self.up), len(self.across)

    @cached_property
    def assembly_sheets(self) -> dict[str, Sheets]:
        """The assemblies on the grid for every track of several links in hinges."""
        sheets = {}
        for step in self.steps_with_several_solutions:
            if isinstance(step, TrackStep) and _cuts_chain_track(step):
                size = self.base[step.guess.size]
                ties = partial(self.lead_ties, step, self.program_for_step(step))
                sheets[step.makes] = Sheets(ties, size, self.across, self.up, self.turns)
        return sheets

    @cached_property
    def openings_on_grid(self) -> dict[str, Array]:
        """For every step its opening on the grid, or its closure at angles all round."""
        grids = {}
        around = np.exp(2j * math.pi * np.arange(GRID_ANGLES) / GRID_ANGLES)[:, None]
        for step in (s for s in self.steps_with_several_solutions if not _cuts_chain_track(s)):
            if isinstance(step, TrackStep):
                grid = closure_residual(self.lead_ties(step, self.program_for_step(step), *self.grid_nodes), around)
                grids[step.makes] = grid.reshape(GRID_ANGLES, *self.grid_shape)
            else:
                assert isinstance(step, TwoPlaces)
                grids[step.makes] = self.opening_function(step)(self.grid_nodes).reshape(self.grid_shape)
        return grids

    @cached_property
    def assembly_counts(self) -> Indices:
        """The number of assemblies on the grid, with the scene's choice for groups that support others."""
        total = np.ones(self.grid_nodes.shape[1], int)
        for step in self.steps_with_several_solutions:
            if step.makes in self.assembly_sheets:
                total = total * self.assembly_sheets[step.makes].assembly_counts.ravel()
            elif isinstance(step, TrackStep):
                total = total * _unit_circle_root_counts(
                    self.closure_polynomial_terms(step, self.program_for_step(step), *self.grid_nodes)
                )
            else:
                total = total * 2 * (self.openings_on_grid[step.makes].ravel() > 0)
        return np.asarray(total.reshape(self.grid_shape))

    @property
    def distance_to_count_change(self) -> float:
        """The distance to the nearest length at which the number of assemblies changes, for all or for some
        positions."""
        rows = (self.assembly_counts != self.assembly_counts[len(self.up) // 2]).any(axis=1) | (
            self.assembly_counts != self.assembly_counts[:, :1]
        ).any(axis=1)
        return float(abs(self.up[rows]).min(initial=math.inf))

    def turning_curves_of_step(self, step: Step) -> list[Array]:
        """The turning curves of one step: places (drive, logarithm, …), one per row."""
        if step.makes in self.assembly_sheets:
            return self.assembly_sheets[step.makes].fold_curves(CURVE_STEP)
        grid = self.openings_on_grid[step.makes]
        scale = np.nanmax(np.abs(grid))
        raw = self.fold_function(step) if isinstance(step, TrackStep) else self.opening_function(step)  # type: ignore[arg-type]
        turn = 2 * math.pi
        ends = [(self.across[0], self.across[-1]), (self.up[0], self.up[-1]), (0.0, turn)][: grid.ndim]
        low, high = np.array(ends).T
        periods = np.array([turn if self.turns else 0.0, 0.0, turn][: grid.ndim])
        curves = Curves(lambda at: raw(at) / scale, Room(low, high, periods, CURVE_STEP))
        for near, reach in self._nodes_near_curve(grid):
            curves.add_curve_near(near, reach)
        return curves.found

    def _nodes_near_curve(self, grid: Array) -> Iterator[tuple[Array, float]]:
        """Nodes of the grid that may be close to a curve, and the largest distance from it."""
        dx = self.across[1] - self.across[0]
        dy = self.up[1] - self.up[0]
        dt = 2 * math.pi / GRID_ANGLES
        if grid.ndim == 2:
            for j, i in np.argwhere(_cells_of_mixed_sign(grid > 0, 0, 1)):
                yield np.array([self.across[i] + dx / 2, self.up[j] + dy / 2]), 3 * math.hypot(dx, dy)
            return
        slope = np.roll(grid, -1, axis=0) - np.roll(grid, 1, axis=0)
        both = _cells_of_mixed_sign(grid > 0, 1, 2) & _cells_of_mixed_sign(slope > 0, 1, 2)
        for k, j, i in np.argwhere(both):
            place = [self.across[i] + dx / 2, self.up[j] + dy / 2, k * dt]
            yield np.array(place), 3 * math.hypot(dx, dy, dt)


def _unit_circle_root_counts(terms: Array) -> Indices:
    """The number of zeros of trigonometric polynomials: their roots on the unit circle."""
    sizes = np.abs(terms).max(axis=1)
    degree = max(k for k in range(CLOSURE_DEGREE_BOUND + 1) if sizes[CLOSURE_DEGREE_BOUND + k] > 1e-12 * sizes.max())
    significant = terms[CLOSURE_DEGREE_BOUND - degree : CLOSURE_DEGREE_BOUND + degree + 1]
    matrix = np.zeros((terms.shape[1], 2 * degree, 2 * degree), complex)
    matrix[:, range(1, 2 * degree), range(2 * degree - 1)] = 1.0
    with np.errstate(all="ignore"):
        matrix[:, :, -1] = -(significant[:-1] / significant[-1]).T
    plain = np.isfinite(matrix).all(axis=(1, 2))
    count = np.zeros(len(matrix), int)
    count[plain] = (abs(abs(np.linalg.eigvals(matrix[plain])) - 1) < UNIT_CIRCLE_TOLERANCE).sum(axis=1)
    return count


def _cells_of_mixed_sign(ahead: Booleans, *axes: int) -> Booleans:
    """Cells of the grid with corners of different signs."""
    every = some = ahead
    for axis in axes:
        low = [slice(None)] * ahead.ndim
        high = [slice(None)] * ahead.ndim
        low[axis], high[axis] = slice(None, -1), slice(1, None)
        every = every[tuple(low)] & every[tuple(high)]
        some = some[tuple(low)] | some[tuple(high)]
    return np.asarray(some & ~every)


def _cuts_chain_track(step: Step) -> bool:
    """Whether it cuts the track of several links in hinges."""
    return isinstance(step, TrackStep) and len(step.holds) > 3
