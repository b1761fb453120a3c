"""Numbers of a tape, which replace floats in the steps and in ``plane``: :class:`Num` for a real number, :class:`Vec`
for a complex one, :class:`Test` for a boolean. Values known while recording are folded."""

from __future__ import annotations

from planes.batch.tape import Tape
from planes.geometry.arithmetic import Point, Real, Truth

Operand = Point | Truth


def place_of_number(tape: Tape, x: Real | Truth) -> int:
    """The place of a number; a constant is recorded on its first use."""
    if isinstance(x, Num | Test):
        return x.at
    return tape.record_leaf("const", bool(x) if isinstance(x, bool) else float(x))


def record_number(tape: Tape, op: str, *args: Real | Truth) -> Num:
    """A real number from an operation."""
    return Num(tape, tape.record_operation(op, *(place_of_number(tape, a) for a in args)))


def record_truth(tape: Tape, op: str, *args: Real | Truth) -> Test:
    """A boolean from an operation."""
    return Test(tape, tape.record_operation(op, *(place_of_number(tape, a) for a in args)))


def _is_real_number(x: object) -> bool:
    return isinstance(x, Num | float | int) and not isinstance(x, bool)


class OnTape:
    """What has a place on a tape."""

    __slots__ = ("at", "tape")

    def __init__(self, tape: Tape, at: int) -> None:
        self.tape = tape
        self.at = at


class Num(OnTape):
    """A real number of a tape."""

    __slots__ = ()
    __hash__ = None  # type: ignore[assignment]

    @property
    def operation_name(self) -> str:
        """The operation that made the number."""
        return self.tape.ops[self.at][0]

    def operation_arguments(self) -> Num:
        """The arguments of that operation."""
        return Num(self.tape, self.tape.ops[self.at][1][0])

    @property
    def real(self) -> Num:
        return self

    @property
    def imag(self) -> float:
        return 0.0

    def __neg__(self) -> Num:
        if self.operation_name == "neg":
            return self.operation_arguments()
        return record_number(self.tape, "neg", self)

    def __abs__(self) -> Num:
        if self.operation_name in ("abs", "hypot", "sqrt"):
            return self
        if self.operation_name == "neg":
            return abs(self.operation_arguments())
        return record_number(self.tape, "abs", self)

    def __add__(self, other: Operand) -> Point:
        if isinstance(other, Test):
            other = other.as_zero_or_one()
        if not _is_real_number(other):
            if isinstance(other, Vec | complex):
                return Vec(self, 0.0) + other
            return NotImplemented
        if isinstance(other, Num):
            return _recorded_sum(self, other)
        if other == 0:
            return self
        return record_number(self.tape, "add", self, other)

    __radd__ = __add__

    def __sub__(self, other: Operand) -> Point:
        if isinstance(other, Num) and other.at == self.at:
            return 0.0
        return self + (-other)

    def __rsub__(self, other: Operand) -> Point:
        return (-self) + other

    def __mul__(self, other: Operand) -> Point:
        if not _is_real_number(other):
            if isinstance(other, Vec | complex):
                return Vec(self, 0.0) * other
            return NotImplemented
        if isinstance(other, Num):
            return _recorded_product(self, other)
        if other in (0, 1, -1):
            return {0: 0.0, 1: self, -1: -self}[int(other)]
        if self.operation_name == "neg":
            return -(-self * other)
        return record_number(self.tape, "mul", self, other)

    __rmul__ = __mul__

    def __truediv__(self, other: Operand) -> Point:
        if not _is_real_number(other):
            if isinstance(other, Vec | complex):
                return Vec(self, 0.0) / other
            return NotImplemented
        if not isinstance(other, Num):
            return self * (1 / other)
        return 1.0 if other.at == self.at else self * other.shared_inverse()

    def __rtruediv__(self, other: Operand) -> Point:
        return other * self.shared_inverse()

    def shared_inverse(self) -> Num:
        """1/x, shared by all quotients with this divisor."""
        if self.operation_name == "neg":
            return -self.operation_arguments().shared_inverse()
        return record_number(self.tape, "inv", self)

    def __pow__(self, n: int) -> Real:
        if n < 0:
            return (self**-n).inverse() if n != -1 else self.shared_inverse()
        power: Real = 1.0
        for _ in range(n):
            power = power * self
        return power

    def __lt__(self, other: Real) -> Test:
        return record_truth(self.tape, "lt", self, other)

    def __le__(self, other: Real) -> Test:
        return record_truth(self.tape, "le", self, other)

    def __gt__(self, other: Real) -> Test:
        return record_truth(self.tape, "lt", other, self)

    def __ge__(self, other: Real) -> Test:
        return record_truth(self.tape, "le", other, self)

    def __eq__(self, other: object) -> Test:  # type: ignore[override]
        return record_truth(self.tape, "eq", self, other)


def _recorded_sum(a: Num, b: Num) -> Real:
    tape = a.tape
    if b.operation_name == "neg":
        a, b = b, a
    if a.operation_name != "neg":
        return record_number(tape, "add", a, b)
    if b.operation_name == "neg":
        return -_recorded_sum(a.operation_arguments(), b.operation_arguments())
    one = a.operation_arguments()
    return 0.0 if one.at == b.at else record_number(tape, "sub", b, one)


def _recorded_product(a: Num, b: Num) -> Num:
    tape = a.tape
    for one, two in ((a, b), (b, a)):
        if one.operation_name == "neg":
            return -_recorded_product(one.operation_arguments(), two)
    return record_number(tape, "mul", a, b)


def _real_and_imaginary(z: Point) -> tuple[Real, Real]:
    return z.real, z.imag


class Vec:
    """A complex number of a tape: a place, a vector or a direction of the drawing."""

    __slots__ = ("imag", "real")

    def __init__(self, real: Real, imag: Real) -> None:
        self.real = real
        self.imag = imag

    def conjugate(self) -> Vec:
        """Mirrored in the x axis."""
        return Vec(self.real, -self.imag)

    def __neg__(self) -> Vec:
        return Vec(-self.real, -self.imag)

    def __add__(self, other: Point) -> Vec:
        x, y = _real_and_imaginary(other)
        return Vec(self.real + x, self.imag + y)

    __radd__ = __add__

    def __sub__(self, other: Point) -> Vec:
        x, y = _real_and_imaginary(other)
        return Vec(self.real - x, self.imag - y)

    def __rsub__(self, other: Point) -> Vec:
        return (-self).__add__(other)

    def __mul__(self, other: Point) -> Vec:
        a, b = _real_and_imaginary(self)
        x, y = _real_and_imaginary(other)
        return Vec(a * x - b * y, a * y + b * x)

    __rmul__ = __mul__

    def __truediv__(self, other: Point) -> Vec:
        a, b = _real_and_imaginary(self)
        x, y = _real_and_imaginary(other)
        if isinstance(y, float | int) and y == 0:
            return Vec(a / x, b / x)
        size = x * x + y * y
        return Vec((a * x + b * y) / size, (b * x - a * y) / size)

    def __rtruediv__(self, other: Point) -> Vec:
        return Vec(*_real_and_imaginary(other)) / self

    def __abs__(self) -> Real:
        for one, other in ((self.real, self.imag), (self.imag, self.real)):
            if isinstance(one, float | int):
                if one == 0:
                    return abs(other)
                return record_number(other.tape, "hypot", other, one)
        return record_number(self.real.tape, "hypot", self.real, self.imag)


class Test(OnTape):
    """A boolean, unknown until the tape is evaluated."""

    __slots__ = ()
    __test__ = False  # not collected by pytest

    def as_zero_or_one(self) -> Num:
        """1 where it is true, otherwise 0."""
        return record_number(self.tape, "sel", self, 1.0, 0.0)

    def __and__(self, other: Operand) -> Point:
        if isinstance(other, bool):
            return self if other else False
        return record_truth(self.tape, "and", self, other)

    __rand__ = __and__

    def __or__(self, other: Operand) -> Point:
        if isinstance(other, bool):
            return True if other else self
        return record_truth(self.tape, "or", self, other)

    __ror__ = __or__

    def __invert__(self) -> Test:
        return record_truth(self.tape, "not", self)

    def __add__(self, other: Operand) -> Point:
        return self.as_zero_or_one() + other

    __radd__ = __add__
