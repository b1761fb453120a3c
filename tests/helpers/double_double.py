"""Double-double arithmetic in arrays: each number is the sum of two floats.

The second is smaller than half the last place of the first (T. J. Dekker, A floating-point technique for extending the
available precision, 1971; 106 bits). A tape computed in them gives the true values of many positions at once, to some
10⁻³¹ of the largest number that entered a result.
"""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from planes.batch.array_ops import ARRAY_OPERATIONS, numbers_at_places
from planes.batch.cycle import Cycle
from planes.batch.rounding import CONSTANT_ROUNDING_ERRORS
from planes.batch.tape import Op
from planes.batch.tracing import trace_program
from planes.geometry.arithmetic import Real, Truth, two_product, two_sum
from planes.geometry.arrays import Array, Floats

Two = tuple[Real, Real]
RIGHT = (math.pi / 2, 6.123233995736766e-17)
TERMS = 14
FINE = 1e-28  # resolution of two floats


def _neat(a: Real, b: Real) -> Two:
    s = a + b
    return s, b - (s - a)


def add(a: Two, b: Two) -> Two:
    s, e = two_sum(a[0], b[0])
    t, f = two_sum(a[1], b[1])
    s, e = _neat(s, e + t)
    return _neat(s, e + f)


def negative(a: Two) -> Two:
    return -a[0], -a[1]


def subtract(a: Two, b: Two) -> Two:
    return add(a, negative(b))


def multiply(a: Two, b: Two) -> Two:
    p, e = two_product(a[0], b[0])
    return _neat(p, e + (a[0] * b[1] + a[1] * b[0]))


def divide(a: Two, b: Two) -> Two:
    first = a[0] / b[0]
    rest = subtract(a, multiply(b, (first, 0.0)))
    second = rest[0] / b[0]
    rest = subtract(rest, multiply(b, (second, 0.0)))
    return add(_neat(first, second), (rest[0] / b[0], 0.0))


def root(a: Two) -> Two:
    """The square root; NaN of a negative number."""
    first = np.sqrt(np.maximum(a[0], 0.0))
    rest = subtract(a, two_product(first, first))[0]
    return _neat(first, np.where(first > 0, rest / (2 * np.where(first > 0, first, 1.0)), 0.0))


def absolute(a: Two) -> Two:
    return where(a[0] < 0, negative(a), a)


def where(ok: Truth, a: Two, b: Two) -> Two:
    return np.where(ok, a[0], b[0]), np.where(ok, a[1], b[1])


def less(a: Two, b: Two) -> Truth:
    return (a[0] < b[0]) | ((a[0] == b[0]) & (a[1] < b[1]))


def equal(a: Two | Truth, b: Two | Truth) -> Truth:
    return (a[0] == b[0]) & (a[1] == b[1]) if isinstance(a, tuple) else a == b


def hypotenuse(a: Two, b: Two) -> Two:
    """Scaled by a power of two, so that no square underflows or overflows."""
    scale = np.exp2(-np.frexp(np.maximum(np.abs(a[0]), np.abs(b[0])))[1].astype(float))
    x, y = (a[0] * scale, a[1] * scale), (b[0] * scale, b[1] * scale)
    size = root(add(multiply(x, x), multiply(y, y)))
    return size[0] / scale, size[1] / scale


def gap(cx: Two, cy: Two, dx: Two, dy: Two, r: Two, s: Two) -> Two:
    """(r + s)² - |d - c|²."""
    t, x, y = add(r, s), subtract(dx, cx), subtract(dy, cy)
    return subtract(subtract(multiply(t, t), multiply(x, x)), multiply(y, y))


def floor(a: Two) -> Two:
    whole = np.floor(a[0])
    return _neat(whole, np.where(whole == a[0], np.floor(a[1]), 0.0))


def sine(x: Two) -> Two:
    """The sine of an angle up to an eighth of a turn, by its series."""
    return multiply(x, _series(multiply(x, x), 1))


def cosine(x: Two) -> Two:
    """The cosine of an angle up to an eighth of a turn."""
    return _series(multiply(x, x), 0)


def _series(square: Two, odd: int) -> Two:
    total: Two = (1.0, 0.0)
    for k in range(TERMS, 0, -1):
        total = subtract((1.0, 0.0), divide(multiply(square, total), (float(2 * k * (2 * k - 1 + 2 * odd)), 0.0)))
    return total


def arctangent(y: Two, x: Two) -> Two:
    """The angle of a vector, in (-π, π]: the double's, corrected by the tangent of the remainder."""
    steep = np.abs(y[0]) > np.abs(x[0])
    high, low = where(steep, y, x), where(steep, x, y)
    nothing = high[0] == 0
    slope = divide(low, where(nothing, (1.0, 0.0), high))
    first = np.arctan(slope[0])
    s, c = sine((first, 0.0)), cosine((first, 0.0))
    angle = add((first, 0.0), divide(subtract(multiply(slope, c), s), add(c, multiply(slope, s))))
    right = np.copysign(RIGHT[0], y[0]), np.copysign(RIGHT[1], y[0])
    turned = add(right, right)
    flat = where(x[0] < 0, add(angle, turned), angle)
    return where(steep, subtract(right, angle), flat)


TWO_OPS: dict[str, Op] = {
    **ARRAY_OPERATIONS,
    "add": add,
    "sub": subtract,
    "mul": multiply,
    "inv": lambda a: divide((1.0, 0.0), a),
    "neg": negative,
    "abs": absolute,
    "sqrt": root,
    "hypot": hypotenuse,
    "sin": sine,
    "cos": cosine,
    "atan2": arctangent,
    "floor": floor,
    "gap": gap,
    "max": lambda a, b: where(less(a, b), b, a),
    "min": lambda a, b: where(less(b, a), b, a),
    "sel": where,
    "lt": less,
    "le": lambda a, b: less(a, b) | equal(a, b),
    "eq": equal,
}


def twofold(x: Floats | Two) -> Two:
    """A number of the tape with the remainder beyond its double; pairs are returned unchanged."""
    return (
        x
        if isinstance(x, tuple)
        else (np.float64(x), np.float64(CONSTANT_ROUNDING_ERRORS.get(x, 0.0) if isinstance(x, float) else 0.0))
    )


def read_long(c: Cycle, given: Mapping[str, Any], shape: tuple[int, ...]) -> list[Two]:
    """The columns of a cycle for given numbers, or pairs of them, including its drive's."""
    drawn = trace_program(c.program, c.given, [x.read_from_drawing for x in c.columns], c.folded, fine=FINE)
    found = numbers_at_places(drawn.tape, drawn.tape.places_needed(list(drawn.outputs)), given, twofold, TWO_OPS)
    return [tuple(np.broadcast_to(part, shape) for part in found[p]) for p in drawn.outputs]  # type: ignore[misc]


def apart(table: Array, true: Two) -> Array:
    """The differences of floats from double-double numbers."""
    return np.asarray(np.abs((table - true[0]) - true[1]))
