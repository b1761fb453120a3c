"""A mechanism over its drive and one length: what is nothing where two of its places meet, on a grid and along curves.

A crossing with two places has a number that is nothing where they meet (its opening); a link on three leads has its
assemblies where a trigonometric polynomial of its angle is nothing, and two meet where its slope is nothing too. Links
hinged to each other are followed over the grid (``sheets``).
"""

import math
from collections.abc import Callable, Iterator
from functools import cached_property, partial

import numpy as np

from planes.accuracy.continuation import Curves, Room
from planes.accuracy.sheets import Sheets
from planes.accuracy.variation import lengthened
from planes.drafting.drawing import Drawing, run
from planes.drafting.program import Program
from planes.drafting.steps import Step
from planes.drafting.steps.crossings import TwoPlaces
from planes.drafting.steps.tracks import CutTrack
from planes.geometry.arithmetic import Arithmetic
from planes.geometry.arrays import Array, Booleans, Indices
from planes.geometry.tracks import DEGREE, Tie, closure
from planes.plans import Plans
from planes.words.names import mu_of

ACROSS, UP, ROUND = 181, 121, 96  # of the grid: values of the drive, lengths, angles of a link
COARSER = 2  # steps where assemblies are followed over it
STEP = 0.05  # along a curve: radians, parts of the mechanism's reach, and of a length's logarithm
CIRCLE = 1e-5  # a root is on the unit circle; rounding moves a double one by less
SAMPLES = 16  # angles that tell a trigonometric polynomial


class LengthField:
    """A mechanism over the drive and the logarithm of how many times longer a length is."""

    def __init__(self, plans: Plans, name: str, times: float) -> None:
        self.plans, self.name = plans, name
        self.base = {**plans.given, mu_of("position"): 1.0}
        self.slopes = lengthened(plans, name)
        drive = plans.mechanism.drive
        self.turns = drive.kind == "phi"
        self.unit = math.degrees(1) if self.turns else plans.reach
        own, reach, by = drive.position / self.unit, math.log(times), COARSER if any(map(_chained, self.steps)) else 1
        ends = (0.0, 2 * math.pi) if self.turns else (own - 1, own + 1)
        self.across, self.up = np.linspace(*ends, ACROSS // by + 1), np.linspace(-reach, reach, UP // by + 1)

    def value(self, x: Array) -> Array:
        """The drive's value."""
        return x * self.unit

    def length(self, y: Array) -> Array:
        """The length, m."""
        return np.asarray(self.plans.lengths[self.name] * np.exp(y))

    @property
    def cut(self) -> list[CutTrack]:
        """All steps that cut the tracks of these."""
        held = {s.holds for s in self.steps if isinstance(s, CutTrack)}
        return [s for s in self.plans.program.steps if isinstance(s, CutTrack) and s.holds in held]

    @cached_property
    def steps(self) -> list[Step]:
        """The steps with several places, those that hang on no track; of one link's track one."""
        steps: dict[object, Step] = {}
        for step in self.plans.program.steps:
            if isinstance(step, TwoPlaces | CutTrack) and not self._tracked(self.program(step)):
                steps.setdefault(step.holds if isinstance(step, CutTrack) else step, step)
        return list(steps.values())

    @cached_property
    def whole(self) -> bool:
        """Whether these are all."""
        several = (s for s in self.plans.program.steps if isinstance(s, TwoPlaces | CutTrack))
        return all(s in self.steps or s in self.cut for s in several)

    @staticmethod
    def _tracked(program: Program) -> bool:
        return any(isinstance(s, CutTrack) for s in program.steps)

    def program(self, step: Step) -> Program:
        """What leads to a step."""
        return self.plans.program.sliced([name for name, _ in step.reads()])

    def drawn(self, program: Program, x: Array, y: Array) -> Drawing:
        """It drawn at many places of the field."""
        longer = np.exp(y) - 1
        given = {name: self.base[name] + slope * longer for name, slope in self.slopes.items()}
        return run(program, {**self.base, **given, self.plans.drive_given: self.value(x)})

    def opening(self, step: TwoPlaces) -> Callable[[Array], Array]:
        """How open a step is at places (drive, length)."""
        program = self.program(step)

        def equations(at: Array) -> Array:
            drawing = self.drawn(program, at[0], at[1])
            openings = step.opening(drawing.things) + np.zeros(len(at[0]))
            return np.array([np.where(drawing.failed(), np.nan, openings)])

        return equations

    def ties(self, step: CutTrack, program: Program, x: Array, y: Array) -> list[Tie]:
        """The leads at many places."""
        drawing = self.drawn(program, x, y)
        return [hold.tie(drawing.things, 1.0, Arithmetic()) for hold in step.holds]

    def terms(self, step: CutTrack, program: Program, x: Array, y: Array) -> Array:
        """The closure of a link as a trigonometric polynomial of its angle: terms -``DEGREE`` … ``DEGREE``."""
        around = np.exp(2j * math.pi * np.arange(SAMPLES) / SAMPLES)[:, None]
        samples = closure(self.ties(step, program, x, y), around) + np.zeros((SAMPLES, len(x)))
        return np.asarray(np.fft.fft(samples, axis=0)[np.arange(-DEGREE, DEGREE + 1)] / SAMPLES)

    def fold(self, step: CutTrack) -> Callable[[Array], Array]:
        """The closure of a link and its slope at places (drive, length, angle of the link)."""
        program, powers = self.program(step), np.arange(-DEGREE, DEGREE + 1)[:, None]

        def equations(at: Array) -> Array:
            parts = self.terms(step, program, at[0], at[1]) * np.exp(1j * powers * at[2])
            return np.array([parts.sum(axis=0).real, (1j * powers * parts).sum(axis=0).real])

        return equations

    @cached_property
    def spots(self) -> Array:
        """The grid, a column each: drive and length."""
        y, x = np.meshgrid(self.up, self.across, indexing="ij")
        return np.array([x.ravel(), y.ravel()])

    @property
    def shape(self) -> tuple[int, int]:
        """Of the grid: lengths and values of the drive."""
        return len(self.up), len(self.across)

    @cached_property
    def sheets(self) -> dict[str, Sheets]:
        """Of every track of links hinged to each other their assemblies on the grid."""
        sheets = dict[str, Sheets]()
        for step in self.steps:
            if isinstance(step, CutTrack) and _chained(step):
                size, ties = self.base[step.guess.size], partial(self.ties, step, self.program(step))
                sheets[step.makes] = Sheets(ties, size, self.across, self.up, self.turns)
        return sheets

    @cached_property
    def grids(self) -> dict[str, Array]:
        """Of every step its opening on the grid, or its closure at angles all round."""
        grids = dict[str, Array]()
        around = np.exp(2j * math.pi * np.arange(ROUND) / ROUND)[:, None]
        for step in (s for s in self.steps if not _chained(s)):
            if isinstance(step, CutTrack):
                grid = closure(self.ties(step, self.program(step), *self.spots), around)
                grids[step.makes] = grid.reshape(ROUND, *self.shape)
            else:
                assert isinstance(step, TwoPlaces)
                grids[step.makes] = self.opening(step)(self.spots).reshape(self.shape)
        return grids

    @cached_property
    def count(self) -> Indices:
        """How many assemblies there are on the grid, the sides of the scene taken for what others hang on."""
        total = np.ones(self.spots.shape[1], int)
        for step in self.steps:
            if step.makes in self.sheets:
                total = total * self.sheets[step.makes].counted.ravel()
            elif isinstance(step, CutTrack):
                total = total * _real(self.terms(step, self.program(step), *self.spots))
            else:
                total = total * 2 * (self.grids[step.makes].ravel() > 0)
        return np.asarray(total.reshape(self.shape))

    @property
    def gone(self) -> float:
        """How far the nearest length is at which there are more or fewer assemblies, of all or of some positions."""
        rows = (self.count != self.count[len(self.up) // 2]).any(axis=1) | (self.count != self.count[:, :1]).any(axis=1)
        return float(abs(self.up[rows]).min(initial=math.inf))

    def curves(self, step: Step) -> list[Array]:
        """The turning curves of one step: places (drive, logarithm, …), a row each."""
        if step.makes in self.sheets:
            return self.sheets[step.makes].curves(STEP)
        grid = self.grids[step.makes]
        scale = np.nanmax(np.abs(grid))
        raw = self.fold(step) if isinstance(step, CutTrack) else self.opening(step)  # type: ignore[arg-type]
        turn = 2 * math.pi
        ends = [(self.across[0], self.across[-1]), (self.up[0], self.up[-1]), (0.0, turn)][: grid.ndim]
        low, high = np.array(ends).T
        periods = np.array([turn if self.turns else 0.0, 0.0, turn][: grid.ndim])
        curves = Curves(lambda at: raw(at) / scale, Room(low, high, periods, STEP))
        for near, reach in self._near(grid):
            curves.add(near, reach)
        return curves.found

    def _near(self, grid: Array) -> Iterator[tuple[Array, float]]:
        """Places on the grid where a curve may be near, and how far off it may be."""
        dx, dy, dt = self.across[1] - self.across[0], self.up[1] - self.up[0], 2 * math.pi / ROUND
        if grid.ndim == 2:
            for j, i in np.argwhere(_mixed(grid > 0, 0, 1)):
                yield np.array([self.across[i] + dx / 2, self.up[j] + dy / 2]), 3 * math.hypot(dx, dy)
            return
        slope = np.roll(grid, -1, axis=0) - np.roll(grid, 1, axis=0)
        both = _mixed(grid > 0, 1, 2) & _mixed(slope > 0, 1, 2)
        for k, j, i in np.argwhere(both):
            place = [self.across[i] + dx / 2, self.up[j] + dy / 2, k * dt]
            yield np.array(place), 3 * math.hypot(dx, dy, dt)


def _real(terms: Array) -> Indices:
    """How many angles there are at which trigonometric polynomials are nothing: their roots on the unit circle."""
    sizes = np.abs(terms).max(axis=1)
    degree = max(k for k in range(DEGREE + 1) if sizes[DEGREE + k] > 1e-12 * sizes.max())
    significant = terms[DEGREE - degree : DEGREE + degree + 1]
    matrix = np.zeros((terms.shape[1], 2 * degree, 2 * degree), complex)
    matrix[:, range(1, 2 * degree), range(2 * degree - 1)] = 1.0
    with np.errstate(all="ignore"):
        matrix[:, :, -1] = -(significant[:-1] / significant[-1]).T
    plain = np.isfinite(matrix).all(axis=(1, 2))
    count = np.zeros(len(matrix), int)
    count[plain] = (abs(abs(np.linalg.eigvals(matrix[plain])) - 1) < CIRCLE).sum(axis=1)
    return count


def _mixed(ahead: Booleans, *axes: int) -> Booleans:
    """Cells of the grid whose corners are not all of one sign."""
    every = some = ahead
    for axis in axes:
        low, high = [slice(None)] * ahead.ndim, [slice(None)] * ahead.ndim
        low[axis], high[axis] = slice(None, -1), slice(1, None)
        every, some = every[tuple(low)] & every[tuple(high)], some[tuple(low)] | some[tuple(high)]
    return np.asarray(some & ~every)


def _chained(step: Step) -> bool:
    """Whether it cuts the track of links hinged to each other."""
    return isinstance(step, CutTrack) and len(step.holds) > 3
