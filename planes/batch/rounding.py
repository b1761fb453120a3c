"""The error of one operation of a tape: its rounding, and the remainder of its linearisation."""

import math
from collections.abc import Callable

import numpy as np

from planes.batch.slopes import SLOPE_FUNCTIONS, Parts, Values
from planes.batch.tape import LEAF_OPERATIONS, TEST_OPERATIONS, Tape
from planes.geometry.arithmetic import Truth, squared_gap_rounding_bound
from planes.geometry.arrays import Array, Booleans, Floats

EXACT_OPERATIONS = TEST_OPERATIONS | LEAF_OPERATIONS | {"neg", "abs", "sel", "max", "min", "floor"}
LARGEST_ROUNDING_HALVES = {
    "gap": 2.0,
    "hypot": 2.0,
    "sin": 2.0,
    "cos": 2.0,
    "atan2": 2.0,
}  # halves of the last place; of others: 1
USUAL_ROUNDING_UNITS = {"hypot": 1.2, "atan2": 1.1}  # root mean square, in units of one rounding
Places = dict[int, int]
UNKNOWN_ERROR = 1e200  # the error of a number is unknown
CONSTANT_ROUNDING_ERRORS = {math.radians(1): 2.9486522708701687e-19, math.degrees(1): -1.9878495670576283e-15}
"""The rounding errors of π/180 and 180/π as doubles."""


def rounding_error_of(tape: Tape, place: int, numbers: Values, integers: frozenset[int]) -> Floats | None:
    """Half of the last place of an operation's result, or the error of a constant; None where it is exact."""
    op, args = tape.ops[place]
    if op == "const":
        x = tape.values[place]
        exact = isinstance(x, bool) or not math.isfinite(x) or (x * 1024).is_integer()
        return None if exact else abs(CONSTANT_ROUNDING_ERRORS.get(x, np.spacing(abs(x)) / 2))
    if op in EXACT_OPERATIONS or place in integers:
        return None
    if op == "gap":  # it has the digits of numbers twice as long; where it is zero, it may be slightly off
        z = numbers[place]
        given = [numbers[a] for a in args]
        return np.where(
            z == 0,
            squared_gap_rounding_bound(*given),
            np.spacing(np.abs(z)) / 2 + 2.0**-100 * sum(map(np.abs, given)) ** 2,
        )
    out = _is_always_exact(op, numbers[place], *(numbers[a] for a in args))
    if np.all(out):
        return None
    return np.where(out, 0.0, np.spacing(np.abs(numbers[place])) / 2)


def _is_always_exact(op: str, z: Array, *args: Array) -> Truth:
    """Whether a sum, product or inverse is always exact: sums with zero, differences of close numbers (Sterbenz),
    powers of two."""
    if op in ("add", "sub"):
        a = np.abs(args[0])
        b = np.abs(args[1])
        near = (2 * np.abs(z) <= np.minimum(a, b)) | (np.abs(z) == np.abs(a - b)) & (a <= 2 * b) & (b <= 2 * a)
        return (a == 0) | (b == 0) | near
    if op == "mul":
        return _is_power_of_two(args[0]) | _is_power_of_two(args[1])
    if op in ("sin", "cos"):  # 0 and 1, from quarter turns
        return args[0] == 0
    return _is_power_of_two(args[0]) if op == "inv" else False


def _is_power_of_two(x: Array) -> Truth:
    part = np.abs(np.frexp(x)[0])
    return (part == 0.5) | (part == 0.0)


def whole_number_places(tape: Tape, order: list[int]) -> frozenset[int]:
    """Places of small integers: quarter turns and all that is computed from them are exact."""
    integers = set[int]()
    for place in order:
        op, args = tape.ops[place]
        counts = op == "floor" or (op == "const" and float(tape.values[place]).is_integer())
        if counts or (op in ("add", "sub", "mul", "neg") and integers.issuperset(args)):
            integers.add(place)
    return frozenset(integers)


def unit_vector_parts(tape: Tape, order: list[int]) -> tuple[Places, Places]:
    """Components of unit vectors, x · 1/√(x² + y²), no larger than 1 for any vector, each with the place of the length;
    and the values taken from them where the length is not zero, each with that length."""
    parts = Places()
    sizes = Places()
    chosen = Places()
    for place in order:
        op, args = tape.ops[place]
        for x, over in (args, args[::-1]) if op == "mul" else ():
            if tape.ops[over][0] == "inv":
                length = tape.ops[over][1][0]
                size = tape.ops[length][1][2] if tape.ops[length][0] == "sel" else length
                if tape.ops[size][0] in ("hypot", "abs") and x in (
                    _place_without_minus(tape, p) for p in tape.ops[size][1]
                ):
                    parts[place] = length
                    sizes[place] = size
        if op == "sel" and _place_without_minus(tape, args[2]) in sizes:
            chosen[place] = sizes[_place_without_minus(tape, args[2])]
    return parts, chosen


def _place_without_minus(tape: Tape, place: int) -> int:
    """The place without its minus."""
    return tape.ops[place][1][0] if tape.ops[place][0] == "neg" else place


Lost = tuple[Array | None, Parts]
Bent = tuple[Array, Booleans | None]


def linearisation_remainder(op: str, z: Array, args: tuple[Array, ...], reach: tuple[Floats, ...]) -> Lost:
    """The remainder of an operation's linearisation, where its arguments may be off by ``reach``; and slopes.

    It is at least |f(a + d) - f(a) - slope·d| for every |d| ≤ reach. Where the arguments are so uncertain that slopes
    are useless, the slope is 0 and the remainder is the whole error of the result.
    """
    parts = SLOPE_FUNCTIONS[op](z, *args)
    if op not in REMAINDER_FUNCTIONS:
        return None, parts
    lost, blunt = REMAINDER_FUNCTIONS[op](z, *args, *reach)
    if blunt is not None and np.any(blunt):
        parts = tuple(np.where(blunt, 0.0, part) for part in parts)
    return np.minimum(lost, UNKNOWN_ERROR), parts


def _inverse_remainder(z: Array, a: Array, da: Array) -> Bent:
    q = da / np.abs(a)
    blunt = ~(q < 1)
    return np.where(blunt, UNKNOWN_ERROR, np.abs(z) * q * q / np.where(blunt, 1.0, 1 - q)), blunt


def _root_remainder(z: Array, a: Array, da: Array) -> Bent:
    blunt = da >= np.abs(a)
    q = da / np.where(blunt, 1.0, np.abs(a))
    return np.where(blunt, np.sqrt(da + np.maximum(-a, 0.0)), z * q * q / 2), blunt


def _length_remainder(z: Array, a: Array, b: Array, da: Array, db: Array) -> Bent:
    d = np.hypot(da, db)
    blunt = 2 * d >= z
    return np.where(blunt, d, d * d / np.where(blunt, 1.0, z)), blunt


def _angle_remainder(z: Array, y: Array, x: Array, dy: Array, dx: Array) -> Bent:
    q = np.hypot(dx, dy) / np.hypot(x, y)
    blunt = ~(2 * q < 1) | ((x < 0) & (np.abs(y) <= dy) & (dy > 0))
    return np.where(blunt, 2 * math.pi, 2 * q * q), blunt


def _gap_remainder(z: Array, *args: Array) -> Bent:
    cx, cy, dx, dy, r, s = args[6:]
    return (cx + dx) ** 2 + (cy + dy) ** 2 + (r + s) ** 2, None


REMAINDER_FUNCTIONS: dict[str, Callable[..., Bent]] = {
    "mul": lambda z, a, b, da, db: (da * db, None),
    "inv": _inverse_remainder,
    "sqrt": _root_remainder,
    "hypot": _length_remainder,
    **dict.fromkeys(("sin", "cos"), lambda z, a, da: (np.minimum(da * da / 2, 2 + da), None)),
    "atan2": _angle_remainder,
    "gap": _gap_remainder,
    "abs": lambda z, a, da: (2 * np.maximum(da - np.abs(a), 0.0), None),
    **dict.fromkeys(("max", "min"), lambda z, a, b, da, db: (np.maximum(da + db - np.abs(a - b), 0.0), None)),
}
