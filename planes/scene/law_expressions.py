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

STEEPEST = 20  # a power of a variable is multiplied out


class LawParser(ExpressionParser):
    """Calculates with single numbers, arrays or a tape; ``ok`` is true where the whole expression has a value."""

    def __init__(self, text: str, names: Mapping[str, Real], ar: Arithmetic, valid: Iterable[str] = ()) -> None:
        super().__init__(text, names, valid or names)
        self.ar = ar
        self.ok: Truth = True
        self.read = 0  # count of names so far

    def named(self, name: str) -> Real:
        self.read += name in self.names
        return super().named(name)

    def where(self, ok: Truth, x: Real, instead: float) -> Real:
        """A number where the condition holds, an arbitrary one elsewhere."""
        self.ok = ok & self.ok
        return self.ar.where(ok, x, instead)

    def divided(self, value: Real, by: Real) -> Real:
        return value / self.where(abs(by) > 0, by, 1.0)

    def power(self) -> Real:
        """A number to any power; a variable only to a whole power or a multiple of one half."""
        before = self.read
        base = self.atom()
        if not self.sign("^", "**"):
            return base
        moves, before = self.read > before, self.read
        exponent = self.signed()
        if not moves and self.read == before:
            return super().raised(float(base), float(exponent))
        halves = 0.0 if self.read > before else 2 * float(exponent)
        if self.read > before or not halves.is_integer() or abs(halves) > 2 * STEEPEST:
            raise self.fail(Phrase("law_power", most=STEEPEST))
        odd = halves % 2 == 1
        power = self.ar.power(self._root(base) if odd else base, int(abs(halves)) // (1 if odd else 2))
        return power if halves >= 0 else self.divided(1.0, power)

    def _root(self, x: Real) -> Real:
        return self.ar.sqrt(self.where(x >= 0, x, 0.0))

    def _sine(self, x: Real) -> tuple[Real, Real]:
        """A sine and its cosine."""
        x = self.where(abs(x) <= 1, x, 0.0)
        return x, self.ar.sqrt(1 - x * x)

    def called(self, name: str, function: Callable[..., float], given: list[Real]) -> Real:
        ar, x = self.ar, given[0]
        match name:
            case "sqrt":
                return self._root(x)
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
                return self.divided(turn.imag, turn.real)
            case "asin" | "acos":
                one, other = self._sine(x)
                return ar.angle_deg(other + 1j * one if name == "asin" else one + 1j * other)
            case "atan" | "atan2":
                return ar.angle_deg(given[1] + 1j * x if name == "atan2" else 1 + 1j * x)
        return abs(x)


def between(table: Pairs, x: Real, ar: Arithmetic) -> Real:
    """The value of a table at x, linear between its pairs; beyond the ends, the value at the end."""
    value: Real = table[0][1]
    for (x0, y0), (x1, y1) in pairwise(table):
        share = ar.maximum(ar.minimum((x - x0) * (1 / (x1 - x0)), 1.0), 0.0)
        value = value + share * (y1 - y0)
    return value


def within(table: Pairs, x: Real, slack: float) -> Truth:
    """Whether x lies within a table, or outside it by at most ``slack`` of its length."""
    beside = slack * (table[-1][0] - table[0][0])
    return (x >= table[0][0] - beside) & (x <= table[-1][0] + beside)


def folded(table: Pairs, phi: Real, ar: Arithmetic) -> Real:
    """An angle reduced to the turn that a table covers."""
    start = table[0][0] + 180.0
    return ar.angle_deg(ar.cis_deg(phi - start)) + start
