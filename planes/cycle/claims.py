"""How far off a result may be, told by the drawing itself: every small error carried to every result at once.

One sweep back along the tape of a program finds how much each result moves with each rounding (``Exact``) or with
each slip of mark, ray and ruler (``Pencil``): to first order exactly, with errors that cancel left to cancel.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from planes.cycle import Block, Cycle
from planes.cycle.columns import Column
from planes.cycle.reading import read
from planes.cycle.tape import LEAVES, TESTS, Tape
from planes.cycle.tracing import Take, Trace, given_values, trace
from planes.drafting import mu_of
from planes.instruments import Pencil

SIGMAS = 5.4  # roundings add up as chances do; further than this none was ever seen
BLIND = 0.25  # where the sharpness itself is so uncertain, relatively, nothing is claimed
ROUNDED = {"hypot": 1.5, "sin": 1.5, "cos": 1.5, "atan2": 2.0}  # halves of the last place; other operations: 1
EXACT = TESTS | {"neg", "abs", "sel", "max", "min", "floor", "given", "source"}
PIECE = 256  # positions swept at once

Values = Mapping[int, Any]
Slope = Callable[..., tuple[Any, ...]]

SLOPES: dict[str, Slope] = {
    "add": lambda z, a, b: (1.0, 1.0),
    "sub": lambda z, a, b: (1.0, -1.0),
    "mul": lambda z, a, b: (b, a),
    "inv": lambda z, a: (-z * z,),
    "neg": lambda z, a: (-1.0,),
    "abs": lambda z, a: (np.sign(a),),
    "sqrt": lambda z, a: (np.where(z > 0, 0.5 / np.where(z > 0, z, 1.0), np.inf),),
    "hypot": lambda z, a, b: (a / np.where(z > 0, z, 1.0), b / np.where(z > 0, z, 1.0)),
    "sin": lambda z, a: (np.cos(a),),
    "cos": lambda z, a: (-np.sin(a),),
    "atan2": lambda z, a, b: (b / (a * a + b * b), -a / (a * a + b * b)),
    "max": lambda z, a, b: (a >= b, a < b),
    "min": lambda z, a, b: (a <= b, a > b),
    "sel": lambda z, t, a, b: (None, t, ~np.asarray(t)),
}  # fmt: skip


def sweep(tape: Tape, order: list[int], found: Values, wanted: list[int], visit: Callable[[int, Any], None]) -> None:
    """Go back along the tape; ``visit`` is told each place and how much each wanted number (a row) moves with it."""
    slopes: dict[int, Any] = {}
    shape = (len(wanted), *np.broadcast_shapes(*(np.shape(found[p]) for p in order)))
    for row, place in enumerate(wanted):
        slopes.setdefault(place, np.zeros(shape))[row] = 1.0
    for place in reversed(order):
        slope = slopes.pop(place, None)
        if slope is None:
            continue
        visit(place, slope)
        op, args = tape.ops[place]
        if op in LEAVES or op in TESTS or op == "floor":
            continue
        for arg, part in zip(args, SLOPES[op](found[place], *(found[a] for a in args)), strict=True):
            if part is not None:
                carried = slope * np.where(slope != 0, part, 0.0)
                slopes[arg] = slopes[arg] + carried if arg in slopes else carried


def rounding(tape: Tape, place: int, found: Values) -> Any:
    """The largest rounding error of an operation; nothing where it comes out exactly."""
    op, args = tape.ops[place]
    if op in EXACT or (op == "const" and _round_number(tape.values[place])):
        return 0.0
    half = np.spacing(np.abs(found[place])) / 2 * ROUNDED.get(op, 1.0)
    return np.where(_comes_out(op, found[place], *(found[a] for a in args)), 0.0, half)


def _comes_out(op: str, z: Any, *args: Any) -> Any:
    """Whether a sum, product or inverse has no digits to lose, however its last digits fall: sums with nothing,
    differences of near numbers (Sterbenz), powers of two."""
    if op in ("add", "sub"):
        a, b = np.abs(args[0]), np.abs(args[1])
        near = (2 * np.abs(z) <= np.minimum(a, b)) | (np.abs(z) == np.abs(a - b)) & (a <= 2 * b) & (b <= 2 * a)
        return (a == 0) | (b == 0) | near
    if op == "mul":
        return _doubling(args[0]) | _doubling(args[1])
    return _doubling(args[0]) if op == "inv" else False


def _round_number(x: Any) -> bool:
    return isinstance(x, bool) or not math.isfinite(x) or (x * 1024).is_integer()


def _doubling(x: Any) -> Any:
    return np.isin(np.abs(np.frexp(x)[0]), (0.0, 0.5))


@dataclass
class _Roundings:
    """Sums of what every rounding does to every wanted number."""

    tape: Tape
    found: Values
    total: Any = 0.0
    squares: Any = 0.0

    def __call__(self, place: int, slope: Any) -> None:
        slip = rounding(self.tape, place, self.found)
        if np.any(slip):
            effect = np.where(slope == 0, 0.0, np.abs(slope) * slip)
            self.total, self.squares = self.total + effect, self.squares + effect * effect

    def bound(self) -> Any:
        return np.minimum(self.total, SIGMAS * np.sqrt(self.squares / 3.0))


class Claims:
    """What a cycle of exact drawings claims of itself: ± of every column, for any values of the drive."""

    def __init__(self, cycle: Cycle) -> None:
        self.cycle, self.count = cycle, len(cycle.columns)
        self.inner = [k for k, c in enumerate(cycle.columns) if c.part]
        ends = [_place(c, end) for c in (cycle.columns[k] for k in self.inner) for end in (c.start, c.end)]
        drawn = trace(cycle.program, cycle.given, [*(c.take for c in cycle.columns), *ends], cycle.folded)
        self.tape, self.pivots, self.ends = drawn.tape, drawn.pivots, drawn.outputs[self.count :]
        self.wanted = [*drawn.outputs[: self.count], *drawn.pivots]
        self.order = self.tape.needed([*self.wanted, *self.ends])

    def bounds(self, values: Any) -> Any:
        """A row for each column: no result is further from the truth; infinite where nothing can be claimed."""
        pieces = [self._piece(np.asarray(values[i : i + PIECE], float)) for i in range(0, len(values), PIECE)]
        return np.hstack(pieces) if pieces else np.empty((self.count, 0))

    def _piece(self, values: Any) -> Any:
        given = {**given_values(self.cycle.given), self.cycle.plans.drive_given: values}
        given |= {k: v[: len(values)] for k, v in given.items() if np.ndim(v)}
        found = read(self.tape, self.order, given)
        with np.errstate(all="ignore"):
            sums = _Roundings(self.tape, found)
            sweep(self.tape, self.order, found, self.wanted, sums)
            bound = np.broadcast_to(sums.bound(), (len(self.wanted), len(values)))
            doubt = self._doubt(found, bound, len(values))
            bound = bound[: self.count] + self._steps(found, len(values))
            last = [np.spacing(np.abs(found[w])) / 2 + np.zeros(len(values)) for w in self.wanted[: self.count]]
            bound = bound + np.array(last).reshape(bound.shape)
            return np.where(doubt < BLIND, bound / (1 - doubt) ** 4, np.inf)

    def _steps(self, found: Values, count: int) -> Any:
        """What a segment between two marks loses where they were marked, which a tape that sees F in (m + F) - m
        knows nothing of; from a pole nothing is lost."""
        lost = np.zeros((self.count, count))
        for row, start, end in zip(self.inner, self.ends[::2], self.ends[1::2], strict=True):
            one, two = np.abs(found[start]), np.abs(found[end])
            mu = self.cycle.given[mu_of(self.cycle.columns[row].start.rpartition(":")[0])]
            lost[row] = np.where(one > 0, np.spacing(one) + np.spacing(two), 0.0) / mu
        return lost

    def _doubt(self, found: Values, bound: Any, count: int) -> Any:
        """How uncertain the least certain sharpness is, relatively."""
        worst = np.zeros(count)
        for row, place in enumerate(self.pivots, self.count):
            doubt = bound[row] / np.abs(found[place])
            worst = np.maximum(worst, np.where(np.isnan(doubt), np.inf, doubt))
        return worst

    def beside(self, blocks: Iterator[Block]) -> Iterator[Block]:
        """The blocks with a row of ± after the rows of results."""
        for block in blocks:
            claimed = np.where(np.isnan(block.table), np.nan, self.bounds(block.values))
            yield Block(block.values, np.vstack([block.table, claimed]), block.codes)


def _place(column: Column, mark: str) -> Take:
    """Where a mark stands, in the direction the column reads."""
    way: dict[str, Callable[[Any], Any]] = {"x": lambda z: z.real, "y": lambda z: z.imag, "size": abs}
    return lambda things, ar: way[column.part](things[mark])


class Spread:
    """Standard deviations over draughtsmen with the same pencil, carried to every column by first-order slopes."""

    def __init__(self, cycle: Cycle, pencil: Pencil, mus: Mapping[str, float]) -> None:
        errors = pencil.point_mm, math.radians(pencil.ray_deg), pencil.ruler_mm / math.sqrt(12.0)
        self.cycle, given = cycle, {**cycle.given, **mus}
        self.drawn = trace(cycle.program, given, [c.take for c in cycle.columns], mus, errors)

    def bounds(self, values: Any) -> Any:
        """A row for each column, of one standard deviation."""
        pieces = []
        for start in range(0, len(values), PIECE):
            part = np.asarray(values[start : start + PIECE], float)
            given = {**given_values(self.cycle.given), self.cycle.plans.drive_given: part}
            pieces.append(_spread(self.drawn, given, len(part)))
        return np.hstack(pieces)


def pencil_spread(cycle: Cycle, pencil: Pencil, mus: Mapping[str, float], values: Any) -> Any:
    """Standard deviations of every column at these scales."""
    return Spread(cycle, pencil, mus).bounds(values)


def _spread(drawn: Trace, given: Mapping[str, Any], count: int) -> Any:
    wanted = list(drawn.outputs)
    order = drawn.tape.needed(wanted)
    found = read(drawn.tape, order, given)
    sizes = {s.place: s.size for s in drawn.sources}
    squares = [np.zeros((len(wanted), count))]

    def visit(place: int, slope: Any) -> None:
        if place in sizes:
            squares[0] = squares[0] + (slope * sizes[place]) ** 2

    with np.errstate(all="ignore"):
        sweep(drawn.tape, order, found, wanted, visit)
    return np.sqrt(squares[0])
