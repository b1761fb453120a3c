"""Expressions evaluated in every position: the same grammar, in the arithmetic of the construction.

A missing value (a root of a negative number, a division by zero) is recorded, not raised: other positions may have a
value.
"""

from collections.abc import Callable, Iterable, Mapping
from functools import reduce
from itertools import pairwise

from planes.geometry.arithmetic import Arithmetic, Real, Truth
from planes.scene.expressions import ExpressionParser
from planes.scene.mechanism import Pairs
from planes.words import Phrase

MOST_MULTIPLIED_POWER = 20  # a power of a variable is multiplied out


class LawParser(ExpressionParser):
    """Calculates with single numbers, arrays or a tape; ``ok`` is true where the whole expression has a value."""

    def __init__(self, text: str, names: Mapping[str, Real], ar: Arithmetic, valid: Iterable[str] = ()) -> None:
        super().__init__(text, names, valid or names)
        self.ar = ar
        self.ok: Truth = True
        self.read = 0  # count of names so far

    def value_of_name(self, name: str) -> Real:
        self.read += name in self.names
        return super().value_of_name(name)

    def choose_where(self, ok: Truth, x: Real, instead: float) -> Real:
        """A number where the condition holds, an arbitrary one elsewhere."""
        self.ok = ok & self.ok
        return self.ar.where(ok, x, instead)

    def divide_values(self, value: Real, by: Real) -> Real:
        return value / self.choose_where(abs(by) > 0, by, 1.0)

    def parse_power(self) -> Real:
        """A number to any power; a variable only to a whole power or a multiple of one half."""
        before = self.read
        base = self.parse_atom()
        if not self.take_sign("^", "**"):
            return base
        moves = self.read > before
        before = self.read
        exponent = self.parse_signed_power()
        if not moves and self.read == before:
            return super().raise_to_power(float(base), float(exponent))
        varies = self.read > before
        halves = 0.0 if varies else 2 * float(exponent)
        if varies or not halves.is_integer() or abs(halves) > 2 * MOST_MULTIPLIED_POWER:
            raise self.error_quoting_expression(Phrase("law_power", most=MOST_MULTIPLIED_POWER))
        odd = halves % 2 == 1
        power = self.ar.power(self._square_root(base) if odd else base, int(abs(halves)) // (1 if odd else 2))
        return power if halves >= 0 else self.divide_values(1.0, power)

    def _square_root(self, x: Real) -> Real:
        return self.ar.sqrt(self.choose_where(x >= 0, x, 0.0))

    def _sine_and_cosine(self, x: Real) -> tuple[Real, Real]:
        """A sine and its cosine."""
        x = self.choose_where(abs(x) <= 1, x, 0.0)
        return x, self.ar.sqrt(1 - x * x)

    def value_of_function(self, name: str, function: Callable[..., float], given: list[Real]) -> Real:
        ar = self.ar
        x = given[0]
        match name:
            case "sqrt":
                return self._square_root(x)
            case "min" | "max":
                return reduce(ar.minimum if name == "min" else ar.maximum, given)
            case "hypot":
                return reduce(lambda a, b: abs(a + 1j * b), given)
            case "sin":
                return ar.cis_deg(x).imag
            case "cos":
                return ar.cis_deg(x).real
            case "tan":
                turn = ar.cis_deg(x)
                return self.divide_values(turn.imag, turn.real)
            case "asin" | "acos":
                one, other = self._sine_and_cosine(x)
                return ar.angle_deg(other + 1j * one if name == "asin" else one + 1j * other)
            case "atan" | "atan2":
                return ar.angle_deg(given[1] + 1j * x if name == "atan2" else 1 + 1j * x)
        return abs(x)


def interpolate_table(table: Pairs, x: Real, ar: Arithmetic) -> Real:
    """The value of a table at x, linear between its pairs; beyond the ends, the value at the end."""
    value: Real = table[0][1]
    for (x0, y0), (x1, y1) in pairwise(table):
        share = ar.maximum(ar.minimum((x - x0) * (1 / (x1 - x0)), 1.0), 0.0)
        value = value + share * (y1 - y0)
    return value


def is_within_table(table: Pairs, x: Real, slack: float) -> Truth:
    """Whether x lies within a table, or outside it by at most ``slack`` of its length."""
    beside = slack * (table[-1][0] - table[0][0])
    return (x >= table[0][0] - beside) & (x <= table[-1][0] + beside)


def fold_angle_into_turn(table: Pairs, phi: Real, ar: Arithmetic) -> Real:
    """An angle reduced to the turn that a table covers."""
    start = table[0][0] + 180.0
    return ar.angle_deg(ar.cis_deg(phi - start)) + start
