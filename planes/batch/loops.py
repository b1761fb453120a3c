"""A program as one loop over positions, read from a tape, with the inputs that change from position to position; and
the loop by numpy, one block of positions at a time, in arrays that are reused as soon as their contents are no longer
needed."""

from collections.abc import Callable, Sequence
from itertools import count

import numpy as np

from planes.batch.array_ops import ARRAY_OPERATIONS, numbers_at_places
from planes.batch.tape import TEST_OPERATIONS
from planes.batch.tracing import Trace
from planes.geometry.arithmetic import Real
from planes.geometry.arrays import Array, Booleans, Floats, FloatsByName, Indices
from planes.words.names import NameTuple

MOST_HELD_NUMBERS = 2**22  # numbers in all arrays of a block together
RowsAndCodes = tuple[Array, Indices | None]  # outputs, and the codes of failures (None: nothing failed)


class Loop:
    """A trace ready to run: ``inputs`` are the givens that change from position to position, the others are as
    ``given``; ``row`` positions form a block."""

    row: int

    def __init__(self, trace: Trace, moving: NameTuple, given: FloatsByName) -> None:
        tape = trace.tape
        places = trace.places_of_givens()
        self.trace = trace
        self.inputs = tuple(name for name in moving if name in places)
        self.places = [places[name] for name in self.inputs]  # their places
        self.conditions = [place for _, _, place in trace.requires]
        moved = tape.places_moved_by(frozenset(moving))
        still = frozenset(range(len(tape.ops))) - moved
        order = tape.places_needed([*trace.outputs, *self.conditions], stop=still)
        self.moved = [p for p in order if p in moved]
        fixed = [p for p in order if p in still]
        numbers = numbers_at_places(tape, tape.places_needed(fixed), given)
        self.still = {p: numbers[p] for p in fixed}

    def __call__(self, rows: Sequence[Array], out: Array | None = None) -> RowsAndCodes:
        """Outputs (a row for each) and codes (the number of the first condition that fails, 0 where all hold; None:
        nothing failed), for one block of positions (``rows``: a row for each input)."""
        raise NotImplementedError


class ArrayLoop(Loop):
    """The loop by numpy: one operation after another, each for the whole block."""

    def __init__(self, trace: Trace, moving: NameTuple, given: FloatsByName) -> None:
        super().__init__(trace, moving, given)
        self.shelf = self._assign_result_arrays()
        self.row = max(1, MOST_HELD_NUMBERS // len({*self.shelf.values(), None}))
        self.width = -1
        self.at = dict[int, Real]()
        self.work = list[tuple[Callable[..., object], list[Real], Real]]()

    def _assign_result_arrays(self) -> dict[int, tuple[bool, int]]:
        """The array for the result at a place, by its type (boolean or number) and its index; those of numbers are used
        again."""
        ops = self.trace.tape.ops
        free = list[int]()
        numbers = count()
        last = {a: p for p in self.moved for a in ops[p][1]}
        kept = {*self.trace.outputs, *self.conditions, *self.places}
        shelves = {}
        for place in self.moved:
            op, args = ops[place]
            shelves[place] = (True, place) if op in TEST_OPERATIONS else (False, free.pop() if free else next(numbers))
            done = (shelves[a] for a in {*args} - kept if last[a] == place and a in shelves)
            free += [number for test, number in done if not test]
        return shelves

    def _prepare_arrays(self, width: int) -> None:
        """Arrays for so many positions, and the operations on them."""
        arrays = {key: np.empty(width, bool if key[0] else float) for key in set(self.shelf.values())}
        self.at = {**self.still, **{place: arrays[key] for place, key in self.shelf.items()}}
        listed = [(op, args, place) for place in self.moved for op, args in [self.trace.tape.ops[place]] if args]
        self.work = [
            (IN_PLACE_OPERATIONS[op], [self.at[a] for a in args], self.at[place]) for op, args, place in listed
        ]
        self.width = width

    def __call__(self, rows: Sequence[Array], out: Array | None = None) -> RowsAndCodes:
        if len(rows[0]) != self.width:
            self._prepare_arrays(len(rows[0]))
        for place, row in zip(self.places, rows, strict=True):
            if place in self.shelf:
                self.at[place][:] = row
        with np.errstate(all="ignore"):
            for do, args, made in self.work:
                do(*args, out=made)
        table = np.empty((len(self.trace.outputs), self.width)) if out is None else out
        for row, place in zip(table, self.trace.outputs, strict=True):
            row[:] = self.at[place]
        return table, self._failure_codes()

    def _failure_codes(self) -> Indices | None:
        holds = [self.at[place] for place in self.conditions]
        holds_all = [bool(np.all(ok)) for ok in holds]
        if all(holds_all):
            return None
        codes = np.zeros(self.width)
        for k in range(len(holds), 0, -1):
            codes = codes if holds_all[k - 1] else np.where(holds[k - 1], codes, k)
        return codes.astype(np.int16)


def _root_into(a: Floats, out: Array) -> None:
    np.sqrt(np.maximum(a, 0.0, out=out), out=out)


def _choose_into(ok: Booleans, a: Floats, b: Floats, out: Array) -> None:
    np.copyto(out, b)
    np.copyto(out, a, where=ok)


IN_PLACE_OPERATIONS: dict[str, Callable[..., object]] = {
    **ARRAY_OPERATIONS,
    "sqrt": _root_into,
    "sel": _choose_into,
    "gap": lambda *numbers, out: np.copyto(out, ARRAY_OPERATIONS["gap"](*numbers)),
}
