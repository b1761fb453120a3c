"""Error bounds of the results, from the drawing itself: a running bound of every rounding on the way.

Givens and drive positions are taken as exact, or with the uncertainty of decimals. Each operation adds its rounding and
the error of its linearisation (``rounding``); each such error is carried to every result by slopes, exactly: f(a + d) =
f(a) + slope · d + the loss of the linearisation. Errors that cancel do cancel (``slopes``). Roundings add up
statistically, losses in the worst case. Where a sharpness, or a divisor force, is as small as its error, the loss is
unbounded and nothing is claimed. ``tests/nightly.py`` measures how reliable and how tight the bounds are.
"""

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from planes.batch.array_ops import numbers_at_places
from planes.batch.rounding import (
    LARGEST_ROUNDING_HALVES,
    UNKNOWN_ERROR,
    USUAL_ROUNDING_UNITS,
    linearisation_remainder,
    rounding_error_of,
    unit_vector_parts,
    whole_number_places,
)
from planes.batch.slopes import UNMOVED_OPERATIONS, Carrying, Parts, Values, slope_times_error
from planes.batch.table import Ready, force_ends_of_columns
from planes.batch.tape import Args, Tape
from planes.batch.tracing import Trace, given_values_by_name, trace_program
from planes.geometry.arrays import Array, Booleans, Floats, Indices
from planes.plans.position.decimals import Lost
from planes.words.names import given_name_of_number, is_scale

ROUNDING_SIGMAS = 6.0  # roundings add up statistically: one sum in five hundred million exceeds this
SMALL_LOSS_RATIO = 0.01  # relative to the rounding: a loss this small needs no better bound
NEGLIGIBLE_LOSS_RATIO = 1e-9  # and one this small can be neglected
BOUND_ROUNDING_FACTOR = 1 + 1e-6  # for neglected losses, and for the rounding of the bound itself
POSITIONS_PER_PIECE = 128  # positions per piece
DOUBTFUL_ERROR_RATIO = 1e-3  # of the largest number of its kind: a number with a larger error is no result
GIVEN_ERRORS_PLACE = -1  # the place of the rounding errors of givens, before all places of a tape
ROUGH_RADIAN_DEG = 60.0  # degrees: roughly a radian


class _Running:
    """The errors of one piece of positions so far: a bound for every place reached."""

    def __init__(self, claims: "Claims", numbers: Values, count: int) -> None:
        self.tape = claims.drawn.tape
        self.found = numbers
        self.count = count
        self.claims = claims
        self.carrying = Carrying(self.tape, claims.order, count)
        self.largest = np.zeros((claims.most, count))
        self.lost = np.zeros((claims.most, count))
        self.usual = np.ones(claims.most)
        self.losing = np.zeros(claims.most, bool)
        self.reach: dict[int, Array] = {}  # a rough upper bound for every place, improved where it matters
        self.better: dict[int, Booleans] = {}
        self.unsure: dict[int, Array] = {}  # places of the motion tests
        if self.claims.written:  # the rounding error of a given is a single error, and is carried as one
            self.carrying.carry_errors_to(GIVEN_ERRORS_PLACE, (), (), own=True)
            self.lost[0] = 1.0
            self.losing[0] = True

    def __call__(self, wanted: frozenset[int]) -> dict[int, Array]:
        """Error bounds of the wanted places."""
        bounds = {}
        for place, op, args in self.carrying.moving_operations():
            if place in self.claims.written:
                self._add_error_of_given(place)
            elif place in self.claims.turns:
                self.unsure[place] = self._error_bound_of_sense(args)
            elif op not in UNMOVED_OPERATIONS or op == "const":
                self._add_error_of_operation(place, op, args)
            if place in wanted:
                bounds[place] = self._error_bound(place, slice(None))
        return bounds

    def _add_error_of_given(self, place: int) -> None:
        """The error of a given: the rounding error of its double, if known, and that of its computation."""
        x = self.found[place]
        k = self.carrying.made
        lost, off = self.claims.written[place]
        beside = np.where(x * 1024 == np.floor(x * 1024), 0.0, np.spacing(np.abs(x)) / 2) if off is None else off
        if own := bool(np.any(beside)):
            self.largest[k] = beside
            self.usual[k] = 1 / 3
        if own or lost:
            self.reach[place] = abs(lost) + beside + np.zeros(self.count)
        self.carrying.carry_errors_to(place, (GIVEN_ERRORS_PLACE,) if lost else (), (lost,) if lost else (), own)

    def _add_error_of_operation(self, place: int, op: str, args: Args) -> None:
        slip = rounding_error_of(self.tape, place, self.found, self.claims.whole)
        lost, parts = self._linearisation_loss_and_slopes(place, op, args, slip)
        none = ~np.isfinite(self.found[place])
        if op not in ("neg", "const") and np.any(none):
            slip, lost = (np.where(none, x, 0.0 if y is None else y) for x, y in ((0.0, slip), (UNKNOWN_ERROR, lost)))
            parts = tuple(np.where(none, np.zeros_like(part), part) for part in parts)
        moved = [
            np.abs(slope_times_error(part, self.reach[a]))
            for a, part in zip(args, parts, strict=True)
            if a in self.reach
        ]
        own = slip is not None or lost is not None
        if own:
            k = self.carrying.made
            self.largest[k] = LARGEST_ROUNDING_HALVES.get(op, 1.0) * (0.0 if slip is None else slip)
            self.usual[k] = (USUAL_ROUNDING_UNITS.get(op, 1.0) / LARGEST_ROUNDING_HALVES.get(op, 1.0)) ** 2 / 3
            moved.append(self.largest[k])
        if lost is not None:
            self.lost[k] = lost
            self.losing[k] = True
            moved.append(lost)
        if moved:
            self.reach[place] = np.minimum(sum(moved), UNKNOWN_ERROR) + np.zeros(self.count)
        self.carrying.carry_errors_to(place, args, parts, own)

    def _linearisation_loss_and_slopes(
        self, place: int, op: str, args: Args, slip: Floats | None
    ) -> tuple[Array | None, Parts]:
        """The loss of the linearisation at a place, and its slopes; with better bounds where it matters."""
        z = self.found[place]
        given = tuple(self.found[a] for a in args)
        if args and args[0] in self.unsure:
            return self.unsure[args[0]], linearisation_remainder(op, z, given, ())[1]
        if place in self.claims.chosen:  # a direction of a zero vector that may not be quite zero
            length = self.claims.chosen[place]
            some = np.where((self.found[length] == 0) & (self.reach.get(length, 0.0) > 0), 2.0, 0.0)
            return some, linearisation_remainder(op, z, given, ())[1]
        lost, parts = linearisation_remainder(op, z, given, self._argument_reaches(args))
        if lost is None or not np.any(lost):
            return None, parts
        beside = 0.0 if slip is None else slip
        doubtful = lost > SMALL_LOSS_RATIO * beside
        if not np.any(lost > NEGLIGIBLE_LOSS_RATIO * beside):
            return None, parts
        if np.any(doubtful):
            self._find_better_bounds(args, np.broadcast_to(doubtful, (self.count,)))
            lost, parts = linearisation_remainder(op, z, given, self._argument_reaches(args))
            assert lost is not None
        if place in self.claims.units:
            length = self.claims.units[place]
            reach = self.reach.get(length, 0.0)
            blunt = (2 * reach >= np.abs(self.found[length])) & (reach > 0)
            lost = np.where(blunt, 2.0, lost)
            parts = tuple(np.where(blunt, 0.0, part) for part in parts)
        return lost, parts

    def _argument_reaches(self, args: Args) -> tuple[Floats, ...]:
        return tuple(self.reach.get(a, 0.0) for a in args)

    def _find_better_bounds(self, places: Iterable[int], where: Booleans) -> None:
        """Find better bounds of places, at the positions that need them."""
        for place in set(places) & self.carrying.rows.keys():
            seen = self.better.setdefault(place, np.zeros(self.count, bool))
            new = np.flatnonzero(where & ~seen)
            if len(new):
                seen[new] = True
                self.reach[place][new] = np.fmin(self.reach[place][new], self._error_bound(place, new))

    def _error_bound(self, place: int, where: Indices | slice) -> Array:
        """The error bound of a place: every loss in the worst case, and the roundings statistically.

        The worst-case sum of the roundings is not a bound even where it is smaller: arrays and single positions divide
        complex numbers by other operations than a tape does, with more roundings.
        """
        if place not in self.carrying.rows:
            return np.zeros(self.count)[where]
        rows = self.carrying.rows[place][:, where]
        size = np.abs(rows)
        losing = np.flatnonzero(self.losing[: len(rows)])
        lost = np.einsum("kp,kp->p", size[losing], self.lost[losing][:, where])
        size *= self.largest[: len(rows), where]
        size *= size
        return np.asarray(ROUNDING_SIGMAS * np.sqrt(self.usual[: len(rows)] @ size) + lost)

    def _error_bound_of_sense(self, args: Args) -> Array:
        """The error bound of a sense: an apparent standstill may be a motion, and a motion within its error has no
        certain sense. Only a link that cannot move at all is certainly at rest."""
        self._find_better_bounds(args, np.ones(self.count, bool))
        (still, least), (size, error) = ((np.abs(self.found[a]), self.reach.get(a, 0.0)) for a in args)
        sure = (size - error > still + least) | ((size == 0) & (error == 0))
        return np.where(sure, 0.0, 2.0)


def _written_givens(tape: Tape, order: list[int], lost: Mapping[str, Lost]) -> dict[int, tuple[float, float | None]]:
    """Places of the givens written in a scene, each with the rounding error of its double, and its uncertainty (None:
    that of a decimal); scales belong to the drawing alone."""
    names = {p: str(tape.values[p]) for p in order if tape.ops[p][0] == "given"}
    known = {p: (n, lost.get(given_name_of_number(n), (0.0, None))) for p, n in names.items() if not is_scale(n)}
    return {p: (one.imag if n.endswith(".y") else one.real, off) for p, (n, (one, off)) in known.items()}


class Margins:
    """± of every column, for any positions of the drive, computed piece by piece."""

    def __init__(self, cycle: Ready, drawn: Trace) -> None:
        self.cycle = cycle
        self.drawn = drawn
        self.order = drawn.tape.places_needed(list(drawn.outputs))

    def error_bounds_of_columns(self, values: Sequence[float] | Array, at: Indices | None = None) -> Array:
        """A row for each column. The ``values`` of the drive are those of the positions numbered ``at`` (None: the
        first ones)."""
        values = np.asarray(values, float)
        at = np.arange(len(values)) if at is None else at
        pieces = [np.empty((len(self.cycle.columns), 0))]
        for i in range(0, len(values), POSITIONS_PER_PIECE):
            part = values[i : i + POSITIONS_PER_PIECE]
            given = given_values_by_name(
                {**self.cycle.given, **self.cycle.changing_inputs(part, at[i : i + POSITIONS_PER_PIECE])}
            )
            with np.errstate(all="ignore"):
                pieces.append(self.piece_error_bounds(numbers_at_places(self.drawn.tape, self.order, given), len(part)))
        return np.hstack(pieces)

    def piece_error_bounds(self, numbers: Values, count: int) -> Array:
        """Those of a piece of ``count`` positions, with every number of the tape known."""
        raise NotImplementedError


class Claims(Margins):
    """The accuracy that a cycle of exact drawings claims: no result has a larger error; infinite where nothing can be
    claimed.

    With the rounding errors of givens, ``lost`` (``Plans.lost``), the results are those of the decimals in the scene,
    not of their doubles; a given not named there has half of its last place.
    """

    def __init__(self, cycle: Ready, lost: Mapping[str, Lost] | None = None) -> None:
        drawn = trace_program(cycle.program, cycle.given, [c.read_from_drawing for c in cycle.columns], cycle.folded)
        super().__init__(cycle, drawn)
        tape = drawn.tape
        order = self.order
        self.written = {} if lost is None else _written_givens(tape, order, lost)
        self.whole = whole_number_places(tape, order)
        self.turns = frozenset(drawn.turns)
        self.units, self.chosen = unit_vector_parts(tape, order)
        made = sum(tape.ops[p][0] not in UNMOVED_OPERATIONS or tape.ops[p][0] == "const" for p in order)
        self.most = made + len(self.written) + 1

    def piece_error_bounds(self, numbers: Values, count: int) -> Array:
        outputs = self.drawn.outputs
        bounds = _Running(self, numbers, count)(frozenset(outputs))
        bound = np.array([bounds[p] for p in outputs]).reshape(len(outputs), count) * BOUND_ROUNDING_FACTOR
        return np.where(bound < UNKNOWN_ERROR * 1e-50, bound, np.inf)

    def doubtful_numbers(self, table: Array, bounds: Array) -> Booleans:
        """Which numbers have less than three correct digits, relative to the largest of their kind."""
        kinds = np.array([c.comparison_class for c in self.cycle.columns])
        sizes = np.abs(table) - bounds
        doubtful = np.zeros(table.shape, bool)
        for kind in set(kinds.tolist()):
            rows = kinds == kind
            largest = np.fmax.reduce(sizes[rows], axis=0, initial=ROUGH_RADIAN_DEG if kind == "°" else 0.0)
            doubtful[rows] = ~(bounds[rows] <= DOUBTFUL_ERROR_RATIO * largest) & np.isfinite(table[rows])
        return doubtful

    def numbers_on_faint_forces(self, table: Array, bounds: Array) -> Booleans:
        """Which numbers depend on a force without a correct digit."""
        eaten = (np.abs(table) <= bounds) & (bounds > 0)
        faint = np.zeros(table.shape, bool)
        for side in force_ends_of_columns(self.cycle.columns):
            rows = [k for k, c in enumerate(self.cycle.columns) if (c.start, c.end) == side]
            faint[rows] = eaten[rows].all(axis=0)
        return faint
