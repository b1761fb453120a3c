"""Errors propagated forward along a tape: how much every place moves with each earlier error, to first order.

Errors that cancel do cancel: each has its row of slopes, from its origin to the last result.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence

import numpy as np

from planes.batch.tape import LEAF_OPERATIONS, TEST_OPERATIONS, Args, Tape
from planes.geometry.arrays import Array, Floats

Values = Mapping[int, Array]
Parts = Sequence[Floats]
BOOLEAN_TYPE = np.dtype(bool)
UNMOVED_OPERATIONS = TEST_OPERATIONS | LEAF_OPERATIONS | {"floor"}  # operations that do not move with their arguments


def _divide_or_zero(a: Floats, size: Array) -> Array:
    """a / size; zero where the size is zero."""
    return np.where(size > 0, a / np.where(size > 0, size, 1.0), 0.0)


SLOPE_FUNCTIONS: dict[str, Callable[..., Parts]] = {
    "const": lambda z: (),
    "add": lambda z, a, b: (1.0, 1.0),
    "sub": lambda z, a, b: (1.0, -1.0),
    "mul": lambda z, a, b: (b, a),
    "inv": lambda z, a: (-z * z,),
    "neg": lambda z, a: (-1.0,),
    "abs": lambda z, a: (np.sign(a),),
    "sqrt": lambda z, a: (_divide_or_zero(0.5, z),),
    "hypot": lambda z, a, b: (_divide_or_zero(a, z), _divide_or_zero(b, z)),
    "sin": lambda z, a: (np.cos(a),),
    "cos": lambda z, a: (-np.sin(a),),
    "atan2": lambda z, a, b: (_divide_or_zero(b, a * a + b * b), _divide_or_zero(-a, a * a + b * b)),
    "max": lambda z, a, b: (a >= b, a < b),
    "min": lambda z, a, b: (a <= b, a > b),
    "sel": lambda z, t, a, b: (0.0, t, ~np.asarray(t)),
    "gap": lambda z, cx, cy, dx, dy, r, s: (
        2 * (dx - cx),
        2 * (dy - cy),
        2 * (cx - dx),
        2 * (cy - dy),
        2 * (r + s),
        2 * (r + s),
    ),
}


def slope_times_error(part: Floats, x: Array) -> Array:
    """A slope times the error it carries; a choice passes on the chosen argument, whatever the other is."""
    if getattr(part, "dtype", None) is BOOLEAN_TYPE:
        return np.where(part, x, 0.0)
    return part * x


class Carrying:
    """The rows of every place still needed: row k is the slope with respect to the k-th error."""

    def __init__(self, tape: Tape, order: list[int], count: int) -> None:
        self.tape = tape
        self.order = order
        self.count = count
        self.rows: dict[int, Array] = {}
        self.made = 0
        self._last = {a: p for p in order for a in tape.ops[p][1]}

    def moving_operations(self) -> Iterator[tuple[int, str, Args]]:
        """The places in order, each with its operation; places no longer needed are dropped on the way."""
        for place in self.order:
            op, args = self.tape.ops[place]
            yield place, op, args
            for arg in args:
                if self._last.get(arg) == place:
                    self.rows.pop(arg, None)

    def carry_errors_to(self, place: int, args: Args, parts: Parts, own: bool) -> None:
        """Give a place its rows: those of its arguments times their slopes, and one of its ``own`` error."""
        given = [(self.rows[a], part) for a, part in zip(args, parts, strict=True) if a in self.rows]
        given.sort(key=lambda pair: -len(pair[0]))
        if not given and not own:
            return
        longest = len(given[0][0]) if given else 0
        rows = np.empty((self.made + 1 if own else longest, self.count))
        if given:
            first, part = given[0]
            rows[:longest] = slope_times_error(part, first)
        for more, part in given[1:]:
            rows[: len(more)] += slope_times_error(part, more)
        if own:
            rows[longest:-1] = 0.0
            rows[-1] = 1.0
            self.made += 1
        self.rows[place] = rows
