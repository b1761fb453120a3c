"""The operations of a tape by numpy, and a tape evaluated with arrays."""

from collections.abc import Callable, Iterable, Mapping

import numpy as np

from planes.batch.tape import Number, Op, Tape, compute_places
from planes.geometry.arithmetic import squared_circle_gap
from planes.geometry.arrays import Floats, FloatsByName

ARRAY_OPERATIONS: dict[str, Op] = {  # numpy functions that accept an output array, with three exceptions
    "add": np.add,
    "sub": np.subtract,
    "mul": np.multiply,
    "inv": np.reciprocal,
    "neg": np.negative,
    "abs": np.abs,
    "sqrt": lambda a: np.sqrt(np.maximum(a, 0.0)),
    "hypot": np.hypot,
    "sin": np.sin,
    "cos": np.cos,
    "atan2": np.arctan2,
    "floor": np.floor,
    "gap": squared_circle_gap,
    "max": np.maximum,
    "min": np.minimum,
    "sel": np.where,
    "lt": np.less,
    "le": np.less_equal,
    "eq": np.equal,
    "and": np.logical_and,
    "or": np.logical_or,
    "not": np.logical_not,
}


def numbers_at_places(
    tape: Tape,
    order: Iterable[int],
    given: FloatsByName,
    real: Callable[[Floats], Number] = np.float64,
    ops: Mapping[str, Op] = ARRAY_OPERATIONS,
) -> dict[int, Number]:
    """The numbers at the places of ``order``, as :func:`planes.batch.tape.reckoned`; doubles unless another type is
    given."""
    with np.errstate(all="ignore"):
        return compute_places(tape, order, given, lambda x: np.bool_(x) if isinstance(x, bool) else real(x), ops)
