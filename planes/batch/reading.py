"""Read a tape with numbers: floats, numpy arrays, or any numbers an arithmetic knows."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping

import numpy as np

from planes.batch.tape import Tape
from planes.geometry.arithmetic import Real
from planes.geometry.arrays import Floats
from planes.geometry.error_free import gap

Number = Real  # of a tape being read: an array, or a longer number
Op = Callable[..., Number]
OPS: dict[str, Op] = {
    "add": lambda a, b: a + b,
    "sub": lambda a, b: a - b,
    "mul": lambda a, b: a * b,
    "inv": lambda a: 1.0 / a,
    "neg": lambda a: -a,
    "abs": np.abs,
    "sqrt": lambda a: np.sqrt(np.maximum(a, 0.0)),
    "hypot": np.hypot,
    "sin": np.sin,
    "cos": np.cos,
    "atan2": np.arctan2,
    "floor": np.floor,
    "gap": gap,
    "max": np.maximum,
    "min": np.minimum,
    "sel": np.where,
    "lt": lambda a, b: a < b,
    "le": lambda a, b: a <= b,
    "eq": lambda a, b: a == b,
    "and": lambda a, b: a & b,
    "or": lambda a, b: a | b,
    "not": np.logical_not,
}


def read(
    tape: Tape,
    order: Iterable[int],
    given: Mapping[str, Floats],
    real: Callable[[Floats], Number] = np.float64,
    ops: Mapping[str, Op] = OPS,
) -> dict[int, Number]:
    """The numbers at the places of ``order``, of the kind ``real``, by the operations ``ops``; errors of instruments
    are 0."""
    found: dict[int, Number] = {}
    with np.errstate(all="ignore"):
        for place in order:
            op, args = tape.ops[place]
            if op == "given":
                found[place] = real(given[tape.values[place]])
            elif op == "source":
                found[place] = real(0.0)
            elif op == "const":
                value = tape.values[place]
                found[place] = np.bool_(value) if isinstance(value, bool) else real(value)
            else:
                found[place] = ops[op](*(found[a] for a in args))
    return found
