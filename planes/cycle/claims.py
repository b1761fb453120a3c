"""How far off a result may be, told by the drawing itself: a running bound of every rounding on the way to it.

Each operation errs by its own rounding and by what its slopes say nothing of (``rounding``); each such error goes on to
every result by slopes, exactly: f(a + d) = f(a) + slope · d + what is lost by taking f to be straight. Errors that
cancel are left to cancel (``slopes``). Roundings add up as chances do, what is lost adds up at its worst. Where a
sharpness is as small as its own error the loss has no end, and nothing is claimed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

import numpy as np

from planes.cycle import Block, Cycle
from planes.cycle.columns import Column
from planes.cycle.reading import read
from planes.cycle.rounding import BLIND, EXACT, LARGEST, USUAL, bent, rounding, unit_parts, whole_numbers
from planes.cycle.slopes import STIFF, Carrying, Values
from planes.cycle.tape import Tape
from planes.cycle.tracing import Take, given_values, trace
from planes.naming import mu_of, plan_of

SIGMAS = 6.0  # of so many roundings beyond this is one sum in five hundred million
SMALL = 0.01  # of the rounding beside it, what is lost by taking an operation to be straight is not worth finding better
PIECE = 64  # positions worked at once


class _Running:
    """The errors on the way, of one piece of positions: how far every place reached may be off."""

    def __init__(self, tape: Tape, order: list[int], found: Values, count: int, kept: Kept) -> None:
        self.tape, self.found, self.count, self.kept = tape, found, count, kept
        self.carrying = Carrying(tape, order, count)
        self.largest, self.squares, self.lost = (np.zeros((kept.most, count)) for _ in range(3))
        self.reach: dict[int, Any] = {}  # no place is further off than this: a rough bound, made better where it matters
        self.better: dict[int, Any] = {}
        self.unsure: dict[int, Any] = {}  # of the tests whether a thing moves

    def __call__(self, wanted: frozenset[int]) -> dict[int, Any]:
        """How far the wanted places may be off."""
        bounds = {}
        for place, op, args in self.carrying.moving():
            if place in self.kept.turns:
                self.unsure[place] = self._turning(args)
            elif op not in STIFF or op == "const":
                self._err(place, op, args)
            if place in wanted:
                bounds[place] = self._bound(place, slice(None))
        return bounds

    def _err(self, place: int, op: str, args: tuple[int, ...]) -> None:
        slip = rounding(self.tape, place, self.found, self.kept.whole)
        lost, parts = self._bent(place, op, args, slip)
        moved = [np.abs(part) * self.reach[a] for a, part in zip(args, parts, strict=True) if a in self.reach]
        own = slip is not None or lost is not None
        if own:
            k = self.carrying.made
            self.largest[k] = LARGEST.get(op, 1.0) * (0.0 if slip is None else slip)
            self.squares[k] = (USUAL.get(op, 1.0) * (0.0 if slip is None else slip)) ** 2 / 3
            self.lost[k] = 0.0 if lost is None else lost
            moved.append(self.largest[k] + self.lost[k])
        if moved:
            self.reach[place] = np.minimum(sum(moved), BLIND) + np.zeros(self.count)
        self.carrying.carry(place, args, parts, own)

    def _bent(self, place: int, op: str, args: tuple[int, ...], slip: Any) -> Any:
        """What is lost at a place by taking it to be straight, and its slopes; with better bounds where it matters."""
        z, given = self.found[place], tuple(self.found[a] for a in args)
        if args and args[0] in self.unsure:
            return self.unsure[args[0]], bent(op, z, given, ())[1]
        lost, parts = bent(op, z, given, self._reaches(args))
        if lost is None or not np.any(lost):
            return None, parts
        doubtful = lost > SMALL * (0.0 if slip is None else slip)
        if np.any(doubtful):
            self._look(args, np.broadcast_to(doubtful, (self.count,)))
            lost, parts = bent(op, z, given, self._reaches(args))
        if place in self.kept.units:
            length = self.kept.units[place]
            blunt = 2 * self.reach.get(length, 0.0) >= np.abs(self.found[length])
            lost, parts = np.where(blunt, 2.0, lost), tuple(np.where(blunt, 0.0, part) for part in parts)
        return lost, parts

    def _reaches(self, args: tuple[int, ...]) -> tuple[Any, ...]:
        return tuple(self.reach.get(a, 0.0) for a in args)

    def _look(self, places: Any, where: Any) -> None:
        """Find better bounds of places, at the positions that need them."""
        for place in set(places) & self.carrying.rows.keys():
            seen = self.better.setdefault(place, np.zeros(self.count, bool))
            new = np.flatnonzero(where & ~seen)
            if len(new):
                seen[new] = True
                self.reach[place][new] = np.fmin(self.reach[place][new], self._bound(place, new))

    def _bound(self, place: int, where: Any) -> Any:
        """How far a place may be off: every loss at its worst, and the roundings at their worst or by chance."""
        if place not in self.carrying.rows:
            return np.zeros(self.count)[where]
        rows = self.carrying.rows[place][:, where]
        largest, squares, lost = (x[: len(rows), where] for x in (self.largest, self.squares, self.lost))
        size = np.abs(rows)
        chance = SIGMAS * np.sqrt(np.einsum("kp,kp,kp->p", rows, rows, squares))
        return np.minimum(np.einsum("kp,kp->p", size, largest), chance) + np.einsum("kp,kp->p", size, lost)

    def _turning(self, args: tuple[int, ...]) -> Any:
        """How far off a sense may be: 2 where it cannot be told which way a thing moves, or whether it does."""
        self._look(args, np.ones(self.count, bool))
        still, size = args
        least, most = self.found[size] - self.reach.get(size, 0.0), self.found[size] + self.reach.get(size, 0.0)
        return np.where((most > self.found[still]) & (least <= self.found[still]), 2.0, 0.0)


class Kept:
    """What is known of a tape beforehand."""

    def __init__(self, tape: Tape, order: list[int], turns: tuple[int, ...]) -> None:
        self.whole, self.units, self.turns = whole_numbers(tape, order), unit_parts(tape, order), frozenset(turns)
        self.most = sum(tape.ops[p][0] not in EXACT or tape.ops[p][0] in ("const", "sel", "abs", "max", "min") for p in order)


class Claims:
    """What a cycle of exact drawings claims of itself: ± of every column, for any values of the drive."""

    def __init__(self, cycle: Cycle) -> None:
        self.cycle, self.count = cycle, len(cycle.columns)
        self.inner = [k for k, c in enumerate(cycle.columns) if c.part]
        ends = [_place(c, end) for c in (cycle.columns[k] for k in self.inner) for end in (c.start, c.end)]
        drawn = trace(cycle.program, cycle.given, [*(c.take for c in cycle.columns), *ends], cycle.folded)
        self.tape, self.outputs, self.ends = drawn.tape, drawn.outputs[: self.count], drawn.outputs[self.count :]
        self.order = self.tape.needed(list(drawn.outputs))
        self.kept = Kept(self.tape, self.order, drawn.turns)

    def bounds(self, values: Any) -> Any:
        """A row for each column: no result is further from the truth; infinite where nothing can be claimed."""
        pieces = [self._piece(np.asarray(values[i : i + PIECE], float)) for i in range(0, len(values), PIECE)]
        return np.hstack(pieces) if pieces else np.empty((self.count, 0))

    def _piece(self, values: Any) -> Any:
        given = {**given_values(self.cycle.given), self.cycle.plans.drive_given: values}
        given |= {k: v[: len(values)] for k, v in given.items() if np.ndim(v)}
        found = read(self.tape, self.order, given)
        with np.errstate(all="ignore"):
            bounds = _Running(self.tape, self.order, found, len(values), self.kept)(frozenset(self.outputs))
            bound = np.array([bounds[p] for p in self.outputs]).reshape(self.count, len(values))
            bound = bound + self._steps(found, len(values))
            last = [np.spacing(np.abs(found[w])) / 2 + np.zeros(len(values)) for w in self.outputs]
            bound = bound + np.array(last).reshape(bound.shape)
            return np.where(bound < BLIND * 1e-50, bound, np.inf)

    def _steps(self, found: Values, count: int) -> Any:
        """What a segment between two marks loses where they were marked, which a tape that sees F in (m + F) - m
        knows nothing of; from a pole nothing is lost."""
        lost = np.zeros((self.count, count))
        for row, start, end in zip(self.inner, self.ends[::2], self.ends[1::2], strict=True):
            one, two = np.abs(found[start]), np.abs(found[end])
            mu = self.cycle.given[mu_of(plan_of(self.cycle.columns[row].start))]
            lost[row] = np.where(one > 0, np.spacing(one) + np.spacing(two), 0.0) / mu
        return lost

    def beside(self, blocks: Iterator[Block]) -> Iterator[Block]:
        """The blocks with a row of ± after the rows of results."""
        for block in blocks:
            claimed = np.where(np.isnan(block.table), np.nan, self.bounds(block.values))
            yield Block(block.values, np.vstack([block.table, claimed]), block.codes)


def _place(column: Column, mark: str) -> Take:
    """Where a mark stands, in the direction the column reads."""
    way: dict[str, Callable[[Any], Any]] = {"x": lambda z: z.real, "y": lambda z: z.imag, "size": abs}
    return lambda things, ar: way[column.part](things[mark])
