"""The mechanism turned through its cycle: the one batch program, run with the drive's motion and with a unit drive.

Evenly spaced samples show the driver's range, where a link turns over and where the mechanism does not assemble.
"""

from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property

import numpy as np

from planes.batch.cycle import BLOCK_POSITIONS, Block, Cycle, Reason, compiling_pays
from planes.geometry.arrays import Array, Booleans, Indices
from planes.plans import Plans
from planes.plans.curves import (
    FULL_TURN_DEG,
    UNIT_DRIVE_PREFIX,
    Curve,
    CycleVector,
    Sample,
    WorkingRange,
    columns_by_name,
    columns_needed,
    curve_or_vector_by_name,
    curves_by_name,
    vectors_by_name,
)
from planes.scene.ranges import Interval, Span
from planes.words.frozen import frozen
from planes.words.names import NumbersByName, letter_of
from planes.words.units import UNITS_OF_PLACE_AND_RATES

LEAST_FLIP_DEG = 90.0  # degrees: a link cannot turn this far between neighbouring nodes
# rounds of narrowing down a limit, each into so many of 16 parts
LIMIT_NARROWING_ROUNDS = 11
NARROWING_PARTS = (8, 4, 2, 1)
CANCELLATION_ROUNDING_RATIO = 1e-13  # of numbers that cancel: the rest that counts as zero


class WholeTurn:
    """Curves and vectors of a mechanism, ready to be read at any positions of its driver (degrees, or metres)."""

    def __init__(
        self, plans: Plans, curves: Sequence[Curve], arrows: Sequence[CycleVector] = (), slopes: bool = True
    ) -> None:
        self.plans = plans
        self.curves = tuple(curves)
        self.arrows = tuple(arrows)
        self.needs = columns_needed((*self.curves, *self.arrows), slopes)

    @cached_property
    def cycles_by_prefix(self) -> tuple[tuple[str, Cycle], ...]:
        """The runs there are, each with the prefix of its columns: the drive's own motion, and the unit drive's, ω₁ = 1
        and ε₁ = 0 (or v = 1 and a = 0), velocities of which are analogues, dr/dφ₁."""
        columns = columns_by_name(self.plans)
        unit = dict(zip(self.plans.drive.rate_names, (1.0, 0.0), strict=True))
        own = [columns[n] for n in self.needs if not n.startswith(UNIT_DRIVE_PREFIX)]
        one = [columns[n.removeprefix(UNIT_DRIVE_PREFIX)] for n in self.needs if n.startswith(UNIT_DRIVE_PREFIX)]
        runs = ("", None, own), (UNIT_DRIVE_PREFIX, unit, one)
        return tuple((prefix, Cycle(self.plans, known=known, columns=some)) for prefix, known, some in runs if some)

    @property
    def failure_reasons(self) -> tuple[Reason, ...]:
        """The reasons for the codes of a block, of both runs: code k is reason k - 1."""
        return tuple(r for _, c in self.cycles_by_prefix for r in c.reasons)

    def sample_columns(self, values: Sequence[float] | Array, bare: bool = False) -> Sample:
        """Every column needed, at every position; NaN where it cannot be drawn, or, unless ``bare``, has no correct
        digits."""
        return self._run_cycles(np.asarray(values, float), bare)[0]

    def _run_cycles(self, values: Array, bare: bool = False, fast: bool | None = False) -> tuple[Sample, Indices]:
        columns: dict[str, Array] = {}
        codes = np.zeros(len(values), np.intp)
        past = 0
        for prefix, run in self.cycles_by_prefix:
            table, mine = run.table(values, fast, bare=bare)
            if mine.any():
                codes = np.where((codes == 0) & (mine != 0), mine + past, codes)
            past += len(run.reasons)
            columns |= {prefix + c.name: row for c, row in zip(run.columns, table, strict=True)}
        return columns, codes

    def curve_rows(self, values: Array, fast: bool | None = None, errors: bool = False) -> tuple[list[Array], Indices]:
        """Every curve at every position, with ``errors`` then the ± of each; and the codes. ``fast`` says whether to
        compile; by default, where that pays."""
        sample, codes = self._run_cycles(values, fast=fast)
        rows = [c.read(sample) for c in self.curves]
        if errors:
            runs = self.cycles_by_prefix
            every = np.arange(len(values))
            off = {
                p + c.name: x
                for p, r in runs
                for c, x in zip(r.columns, r.decimal_error_bounds(values, every), strict=True)
            }
            rows += [
                c.error_bounds_of_curve(sample, off) + 0 * row for c, row in zip(self.curves, rows, strict=True)
            ]  # NaN stays
        return rows, codes

    def curve_blocks(self, values: Span | Array, fast: bool | None = None, errors: bool = False) -> Iterator[Block]:
        """The same for successive positions, in blocks: for a long table."""
        fast = compiling_pays(len(values)) if fast is None else fast
        for start in range(0, len(values), BLOCK_POSITIONS):
            part = np.asarray(values[start : start + BLOCK_POSITIONS], float)
            rows, codes = self.curve_rows(part, fast, errors)
            yield Block(part, np.array(rows), codes)


def whole_turn_of(
    plans: Plans, names: Iterable[str] | None = None, arrows: Iterable[str] = (), file: str = "", slopes: bool = True
) -> WholeTurn:
    """A turn with the curves and vectors of those names (None: every curve), read with their ``slopes`` or without."""
    known = curves_by_name(plans)
    vectors = vectors_by_name(plans)
    chosen = known.values() if names is None else [curve_or_vector_by_name(n, known, plans, file) for n in names]
    return WholeTurn(
        plans, list(dict.fromkeys(chosen)), [curve_or_vector_by_name(n, vectors, plans, file) for n in arrows], slopes
    )


def unwind_angles(angles: Array) -> Array:
    """Angles without jumps of a full turn, most of them unchanged; NaN stays, and the angles after it continue from the
    last one before."""
    jumping = np.array(angles, float)
    unwrapped = jumping.copy()
    good = np.flatnonzero(np.isfinite(jumping))
    if len(good):
        unwrapped[good] = np.unwrap(jumping[good], period=FULL_TURN_DEG)
        unwrapped -= FULL_TURN_DEG * np.round(np.median((unwrapped - jumping)[good]) / FULL_TURN_DEG)
    return unwrapped


def _assembled_mask(sample: Sample, places: Array, moves: bool) -> Booleans:
    """Where a mechanism that ``moves`` assembles; where vectors and loads without one can be drawn."""
    assembles = np.ones(len(places), bool)
    for name, row in sample.items():
        if not moves or letter_of(name) in ("r", "phi", "q:v", "q:omega"):
            assembles &= np.isfinite(row)
    return assembles


@frozen
class Grid:
    """A turn sampled at evenly spaced positions; ``closed``: the first and the last are one position."""

    turn: WholeTurn
    places: Array
    closed: bool

    @cached_property
    def sampled_columns(self) -> Sample:
        """The columns at every position."""
        return self.turn.sample_columns(self.places)

    @cached_property
    def assembled_mask(self) -> Booleans:
        """Where the mechanism assembles: a mask, by the columns of positions."""
        return _assembled_mask(self.sampled_columns, self.places, self.turn.plans.has_mechanism)

    def curve_values(self, curve: Curve) -> Array:
        """A curve over the grid, NaN where the mechanism does not assemble; angles unwound."""
        row = np.where(self.assembled_mask, curve.read(self.sampled_columns), np.nan)
        return unwind_angles(row) if curve.angular else row

    def turns_fully(self, curve: Curve) -> bool:
        """Whether a link turns fully with the driver: its angle has no extreme."""
        y = self.curve_values(curve)
        return bool(self.closed and curve.angular and abs(y[-1] - y[0]) > FULL_TURN_DEG / 2)

    def rounding_variation(self, curve: Curve) -> float:
        """The variation of a curve by rounding alone, where larger numbers of its unit cancel."""
        return CANCELLATION_ROUNDING_RATIO * self._typical_magnitudes.get(curve.unit, 0.0)

    @cached_property
    def _typical_magnitudes(self) -> NumbersByName:
        """Typical magnitudes in each unit, including those with the driver's given motion."""
        drive = self.turn.plans.drive
        sizes = {"°": FULL_TURN_DEG}
        if drive.rotates:
            sizes |= {"1": 1.0, "rad/s": abs(drive.velocity), "rad/s²": abs(drive.acceleration)}
        for curve in self.turn.curves:
            if not curve.angular:
                y = np.abs(self.curve_values(curve))
                if np.isfinite(y).any():
                    sizes[curve.unit] = max(sizes.get(curve.unit, 0.0), float(np.nanmedian(y)))
        if drive.rotates:
            for _, unit, rate in UNITS_OF_PLACE_AND_RATES.values():
                sizes[rate] = max(sizes.get(rate, 0.0), sizes.get(unit, 0.0) * abs(drive.velocity))
        return sizes

    @cached_property
    def assembly_limits(self) -> tuple[tuple[int, float], ...]:
        """Limits of assembly: the last working node of the grid beside each, and the limit itself (to 10⁻¹²)."""
        inside = np.flatnonzero(self.assembled_mask[1:] != self.assembled_mask[:-1])
        good = np.where(self.assembled_mask[inside], inside, inside + 1)
        every = np.arange(len(inside))
        low = self.places[good]
        high = self.places[np.where(self.assembled_mask[inside], inside + 1, inside)]
        if not len(inside):
            return ()
        for _ in range(LIMIT_NARROWING_ROUNDS):
            places = np.stack([low, high])
            last = np.zeros(len(inside), int)
            for _ in NARROWING_PARTS:
                places = np.insert(places, np.arange(1, len(places)), (places[:-1] + places[1:]) / 2, axis=0)
            sample = self.turn.sample_columns(flat := places[:-1].ravel(), bare=True)
            ok = _assembled_mask(sample, flat, self.turn.plans.has_mechanism).reshape(-1, len(inside))
            for step in NARROWING_PARTS:
                last += step * ok[last + step, every]
            low = places[last, every]
            high = places[last + 1, every]
        return tuple((int(i), float(z)) for i, z in zip(good, low, strict=True))

    @cached_property
    def assembly_ranges(self) -> tuple[Interval, ...]:
        """The ranges in which the mechanism assembles."""
        edges = [z for _, z in self.assembly_limits]
        if self.assembled_mask[0]:
            edges.insert(0, float(self.places[0]))
        if self.assembled_mask[-1]:
            edges.append(float(self.places[-1]))
        return tuple(zip(edges[::2], edges[1::2], strict=True))

    @cached_property
    def link_turn_overs(self) -> tuple[tuple[str, float], ...]:
        """Angles of links that turn over, and where: a slider passes through its hinge, the assembly changes."""
        flips = []
        for curve in self.turn.curves:
            if curve.angular:
                for i in np.flatnonzero(np.abs(np.diff(self.curve_values(curve))) > LEAST_FLIP_DEG):
                    low = float(self.places[i])
                    high = float(self.places[i + 1])
                    for _ in range(24):
                        middle = (low + high) / 2
                        low, high = (
                            (middle, high)
                            if self._turn_between_nodes(curve, low, middle) <= LEAST_FLIP_DEG
                            else (low, middle)
                        )
                    if (
                        not self._turn_between_nodes(curve, low, high) <= LEAST_FLIP_DEG
                    ):  # or it cannot be drawn there at all
                        flips.append((curve.name, high))
        return tuple(flips)

    def _turn_between_nodes(self, curve: Curve, one: float, two: float) -> float:
        a, b = curve.read(self.turn.sample_columns([one, two]))
        return float(abs((b - a + FULL_TURN_DEG / 2) % FULL_TURN_DEG - FULL_TURN_DEG / 2))


def make_grid(turn: WholeTurn, start: float, end: float, least: int = 721) -> Grid:
    """A grid of at least so many positions; closed if it is a whole turn of a crank that works all the way."""
    count = max(least, 2) if end > start else 1
    g = Grid(turn, np.linspace(start, end, count), False)
    return Grid(turn, g.places, bool(_is_exactly_one_turn(g) and g.assembled_mask.all()))


def grid_in_one_piece(g: Grid) -> Grid:
    """A turn in which the mechanism stops somewhere, begun there, so that a working range is one piece."""
    works = g.assembled_mask
    if not _is_exactly_one_turn(g) or works.all() or not (works[0] and works[-1]):
        return g
    stops = np.flatnonzero(~works)
    low = float(g.places[stops[len(stops) // 2]]) - FULL_TURN_DEG
    return make_grid(g.turn, low, low + FULL_TURN_DEG, len(g.places))


def _is_exactly_one_turn(g: Grid) -> bool:
    """Whether a grid covers exactly one turn."""
    return g.turn.plans.drive.rotates and abs(float(g.places[-1] - g.places[0]) - FULL_TURN_DEG) < 1e-9


def driver_search_range(plans: Plans) -> Interval:
    """The range of the driver to search: one turn from the scene's position, or twice the longest link to either side
    of it."""
    drive = plans.drive
    if drive.rotates:
        return drive.position, drive.position + FULL_TURN_DEG
    return drive.position - 2 * plans.longest_link_length, drive.position + 2 * plans.longest_link_length


def working_range_of(plans: Plans) -> WorkingRange:
    """The range in which the mechanism assembles about the drive's position in the scene."""
    turn = WholeTurn(plans, [c for c in curves_by_name(plans).values() if c.group == "place"])
    g = grid_in_one_piece(make_grid(turn, *driver_search_range(plans)))
    here = plans.drive.position
    away = lambda ends: max(ends[0] - here, here - ends[1])  # noqa: E731
    start, end = min(g.assembly_ranges, key=away, default=(here, here))
    return WorkingRange(start, end, g.closed)
