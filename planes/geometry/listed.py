"""Lists of numbers, one per position, in plain Python: lessons draw with them, with or without numpy.

They support + - * /, comparisons and & | ~ element by element, as arrays do; a single number is repeated to match. A
missing value is NaN. They are ten times slower than arrays, but need no import.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Iterable, Iterator
from typing import Any

from planes.geometry.arithmetic import Arithmetic, Point, Real, Truth

NOWHERE = complex(math.nan, math.nan)


def over(a: Any, b: Any) -> Any:
    """a / b; NaN where b is zero, or the quotient overflows."""
    try:
        return a / b
    except (ZeroDivisionError, OverflowError):
        return NOWHERE if isinstance(a, complex) or isinstance(b, complex) else math.nan


def or_nothing(act: Callable[..., Any], nothing: Any = math.nan) -> Callable[..., Any]:
    """The function, with ``nothing`` where it has no value."""

    def tried(*numbers: Any) -> Any:
        try:
            return act(*numbers)
        except (ValueError, OverflowError, ZeroDivisionError):
            return nothing

    return tried


def _both(act: Callable[..., Any]) -> tuple[Callable[[Listed, Any], Listed], Callable[[Listed, Any], Listed]]:
    """A method of a list and another operand, and its reflected version."""
    return (lambda self, other: each(act, self, other)), (lambda self, other: each(act, other, self))


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

    __add__, __radd__ = _both(operator.add)
    __sub__, __rsub__ = _both(operator.sub)
    __mul__, __rmul__ = _both(operator.mul)
    __truediv__, __rtruediv__ = _both(over)
    __pow__, __rpow__ = _both(or_nothing(operator.pow))
    __and__, __rand__ = _both(lambda a, b: bool(a) and bool(b))
    __or__, __ror__ = _both(lambda a, b: bool(a) or bool(b))
    __lt__, __le__, __gt__, __ge__ = (_both(act)[0] for act in (operator.lt, operator.le, operator.gt, operator.ge))
    __eq__, __ne__ = _both(operator.eq)[0], _both(operator.ne)[0]  # type: ignore[assignment]
    __hash__ = None  # type: ignore[assignment]


def each(act: Callable[..., Any], *things: Any) -> Any:
    """The function applied to lists element by element."""
    count = next((len(x) for x in things if isinstance(x, Listed)), None)
    if count is None:
        return act(*things)
    return Listed(map(act, *(x.numbers if isinstance(x, Listed) else [x] * count for x in things)))


class ListArithmetic(Arithmetic):
    """The functions of single numbers, applied to lists."""

    def sqrt(self, x: Real) -> Real:
        return each(super().sqrt, x)

    def maximum(self, a: Real, b: Real) -> Real:
        return each(greater, a, b)

    def minimum(self, a: Real, b: Real) -> Real:
        return each(less, a, b)

    def where(self, ok: Truth, a: Point, b: Point) -> Point:
        return each(super().where, ok, a, b)

    def cis_deg(self, angle: Real) -> Point:
        return each(or_nothing(super().cis_deg, NOWHERE), angle)

    def angle_deg(self, u: Point) -> Real:
        return each(super().angle_deg, u)

    def sign(self, x: Real) -> Real:
        return each(super().sign, x)

    def power(self, x: Real, n: int) -> Real:
        return each(or_nothing(super().power), x, n)

    def gap(self, c: Point, d: Point, r: Real, s: Real) -> Real:
        return each(super().gap, c, d, r, s)

    def spread(self, thing: Any, shape: tuple[int, ...]) -> Any:
        return Listed([thing] * shape[0])


def greater(a: float, b: float) -> float:
    """The greater of two, NaN where one is NaN."""
    return math.nan if a != a or b != b else max(a, b)


def less(a: float, b: float) -> float:
    """The less of two, NaN where one is NaN."""
    return math.nan if a != a or b != b else min(a, b)
