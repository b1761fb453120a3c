"""Lists of numbers, one per position, in plain Python: lessons draw with them, with or without numpy.

They support + - * /, comparisons and & | ~ element by element, as arrays do; a single number is repeated to match. A
missing value is NaN. They are ten times slower than arrays, but need no import.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Iterable, Iterator
from typing import Any

from planes.geometry.arithmetic import Arithmetic, Point, Real, Shape, Truth

COMPLEX_NAN = complex(math.nan, math.nan)


def quotient_or_nan(a: Any, b: Any) -> Any:
    """a / b; NaN where b is zero, or the quotient overflows."""
    try:
        return a / b
    except (ZeroDivisionError, OverflowError):
        if isinstance(a, complex) or isinstance(b, complex):
            return COMPLEX_NAN
        return math.nan


def with_fallback_value(act: Callable[..., Any], nothing: Any = math.nan) -> Callable[..., Any]:
    """The function, with ``nothing`` where it has no value."""

    def tried(*numbers: Any) -> Any:
        try:
            return act(*numbers)
        except (ValueError, OverflowError, ZeroDivisionError):
            return nothing

    return tried


def _operator_and_reflected(
    act: Callable[..., Any],
) -> tuple[Callable[[Listed, Any], Listed], Callable[[Listed, Any], Listed]]:
    """A method of a list and another operand, and its reflected version."""
    return (lambda self, other: map_elementwise(act, self, other)), (
        lambda self, other: map_elementwise(act, other, self)
    )


class Listed:
    """Numbers in a list: floats, complex numbers or booleans."""

    __slots__ = ("numbers",)

    def __init__(self, numbers: Iterable[Any]) -> None:
        self.numbers = list(numbers)

    @property
    def shape(self) -> tuple[int]:
        """The number of elements."""
        return (len(self.numbers),)

    @property
    def real(self) -> Listed:
        return Listed(z.real for z in self.numbers)

    @property
    def imag(self) -> Listed:
        return Listed(z.imag for z in self.numbers)

    def conjugate(self) -> Listed:
        return Listed(z.conjugate() for z in self.numbers)

    def all(self) -> bool:
        return all(self.numbers)

    def any(self) -> bool:
        return any(self.numbers)

    def __iter__(self) -> Iterator[Any]:
        return iter(self.numbers)

    def __len__(self) -> int:
        return len(self.numbers)

    def __getitem__(self, k: int) -> Any:
        return self.numbers[k]

    def __abs__(self) -> Listed:
        return Listed(map(abs, self.numbers))

    def __neg__(self) -> Listed:
        return Listed(-z for z in self.numbers)

    def __invert__(self) -> Listed:
        return Listed(not z for z in self.numbers)

    __add__, __radd__ = _operator_and_reflected(operator.add)
    __sub__, __rsub__ = _operator_and_reflected(operator.sub)
    __mul__, __rmul__ = _operator_and_reflected(operator.mul)
    __truediv__, __rtruediv__ = _operator_and_reflected(quotient_or_nan)
    __pow__, __rpow__ = _operator_and_reflected(with_fallback_value(operator.pow))
    __and__, __rand__ = _operator_and_reflected(lambda a, b: bool(a) and bool(b))
    __or__, __ror__ = _operator_and_reflected(lambda a, b: bool(a) or bool(b))
    __lt__, __le__, __gt__, __ge__ = (
        _operator_and_reflected(act)[0] for act in (operator.lt, operator.le, operator.gt, operator.ge)
    )
    __eq__, __ne__ = _operator_and_reflected(operator.eq)[0], _operator_and_reflected(operator.ne)[0]  # type: ignore[assignment]
    __hash__ = None  # type: ignore[assignment]


def map_elementwise(act: Callable[..., Any], *things: Any) -> Any:
    """The function applied to lists element by element."""
    count = next((len(x) for x in things if isinstance(x, Listed)), None)
    if count is None:
        return act(*things)
    return Listed(map(act, *(x.numbers if isinstance(x, Listed) else [x] * count for x in things)))


class ListArithmetic(Arithmetic):
    """The functions of single numbers, applied to lists."""

    def sqrt(self, x: Real) -> Real:
        return map_elementwise(super().sqrt, x)

    def maximum(self, a: Real, b: Real) -> Real:
        return map_elementwise(greater_or_nan, a, b)

    def minimum(self, a: Real, b: Real) -> Real:
        return map_elementwise(less_or_nan, a, b)

    def where(self, ok: Truth, a: Point, b: Point) -> Point:
        return map_elementwise(super().where, ok, a, b)

    def cis_deg(self, angle: Real) -> Point:
        return map_elementwise(with_fallback_value(super().cis_deg, COMPLEX_NAN), angle)

    def angle_deg(self, u: Point) -> Real:
        return map_elementwise(super().angle_deg, u)

    def sign(self, x: Real) -> Real:
        return map_elementwise(super().sign, x)

    def power(self, x: Real, n: int) -> Real:
        return map_elementwise(with_fallback_value(super().power), x, n)

    def gap(self, c: Point, d: Point, r: Real, s: Real) -> Real:
        return map_elementwise(super().gap, c, d, r, s)

    def repeat_for_positions(self, thing: Any, shape: Shape) -> Any:
        return Listed([thing] * shape[0])


def greater_or_nan(a: float, b: float) -> float:
    """The greater of two, NaN where one is NaN."""
    return math.nan if a != a or b != b else max(a, b)


def less_or_nan(a: float, b: float) -> float:
    """The less of two, NaN where one is NaN."""
    return math.nan if a != a or b != b else min(a, b)
