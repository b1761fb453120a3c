"""Numbers of a scene of vectors found from earlier plans: v_CB^2/l_BC, sums of products of named numbers."""

import math
import re
from collections.abc import Callable, Iterable, Mapping

from planes.geometry.arithmetic import Real
from planes.scene.expressions import ExpressionParser
from planes.words import Phrase
from planes.words.frozen import frozen
from planes.words.names import NameTuple, NumbersByName

Factors = tuple[tuple[str, int], ...]
MOST_AMOUNT_TERMS = 200
CARET_REPLACEMENT = "ˆ"
"""Replaces ^ in the name of a vector while an expression is read, where ^ is a power."""


@frozen
class VectorAmount:
    """A sum of products, each a number and names to whole powers; the names are of parameters, values and vectors,
    which stand for their lengths."""

    text: str
    terms: tuple[tuple[float, Factors], ...]

    @property
    def names_read(self) -> NameTuple:
        """The names it is computed from."""
        return tuple(dict.fromkeys(name for _, factors in self.terms for name, _ in factors))


class _Sum:
    """A sum of products being built; ``number`` is its value where it has only parameters."""

    def __init__(self, terms: Mapping[Factors, float], number: float | None) -> None:
        self.terms = {f: c for f, c in terms.items() if c}
        self.number = number

    @classmethod
    def as_sum(cls, x: "_Sum | float") -> "_Sum":
        return x if isinstance(x, _Sum) else cls({(): float(x)}, float(x))

    def __add__(self, other: "_Sum | float") -> "_Sum":
        other = _Sum.as_sum(other)
        terms = {f: self.terms.get(f, 0.0) + other.terms.get(f, 0.0) for f in (*self.terms, *other.terms)}
        return _Sum(terms, None if None in (self.number, other.number) else self.number + other.number)  # type: ignore[operator]

    def __neg__(self) -> "_Sum":
        return self * -1.0

    def __sub__(self, other: "_Sum | float") -> "_Sum":
        return self + _Sum.as_sum(other) * -1.0

    def __mul__(self, other: "_Sum | float") -> "_Sum":
        other = _Sum.as_sum(other)
        terms = dict[Factors, float]()
        if len(self.terms) * len(other.terms) > MOST_AMOUNT_TERMS:
            raise OverflowError
        for f, c in self.terms.items():
            for g, d in other.terms.items():
                terms[_product_of_factors(f, g)] = terms.get(_product_of_factors(f, g), 0.0) + c * d
        return _Sum(terms, None if None in (self.number, other.number) else self.number * other.number)  # type: ignore[operator]

    def __rsub__(self, other: float) -> "_Sum":
        return _Sum.as_sum(other) - self

    __radd__ = __add__
    __rmul__ = __mul__


def _product_of_factors(f: Factors, g: Factors) -> Factors:
    powers = dict(f)
    for name, power in g:
        powers[name] = powers.get(name, 0) + power
    return tuple((name, power) for name, power in powers.items() if power)


class AmountParser(ExpressionParser):
    """Parses an amount that has no value yet; ``named`` are the names found on plans."""

    def __init__(self, text: str, parameters: NumbersByName, named: Iterable[str]) -> None:
        names = {n: _Sum({((n, 1),): 1.0}, x) for n, x in parameters.items()}
        names |= {name_without_caret(n): _Sum({((n, 1),): 1.0}, None) for n in named}
        super().__init__(_replace_carets_in_names(text, named), names, [*parameters, *named])

    def divide_values(self, value: Real, by: Real) -> Real:
        """Divided by a single product; by a sum only where that is a number."""
        value = _Sum.as_sum(value)
        by = _Sum.as_sum(by)
        if len(by.terms) > 1 and by.number is not None:
            by = _Sum.as_sum(by.number)
        if len(by.terms) > 1:
            raise self.error_quoting_expression(Phrase("amount_divided"))
        if not by.terms or by.number == 0.0:
            raise self.error_quoting_expression(Phrase("division_by_zero"))
        ((factors, c),) = by.terms.items()
        quotient = value * _Sum({tuple((n, -p) for n, p in factors): 1.0 / c}, None)
        return _Sum(quotient.terms, None if None in (value.number, by.number) else value.number / by.number)

    def raise_to_power(self, base: Real, exponent: Real) -> Real:
        """To a small whole power, or a number to any power."""
        base = _Sum.as_sum(base)
        power = _Sum.as_sum(exponent).number
        if power is None or (base.number is None and not (power.is_integer() and 0 < power <= 9)):
            raise self.error_quoting_expression(Phrase("amount_power"))
        if not (power.is_integer() and 0 < power <= 9):
            return _Sum.as_sum(super().raise_to_power(base.number, power))
        product = base
        for _ in range(int(power) - 1):
            product = product * base
        return product

    def value_of_function(self, name: str, function: Callable[..., float], given: list[Real]) -> Real:
        """A function of numbers."""
        numbers = [_Sum.as_sum(x).number for x in given]
        if None in numbers:
            raise self.error_quoting_expression(Phrase("amount_function", name=name))
        return _Sum.as_sum(super().value_of_function(name, function, numbers))


def name_without_caret(name: str) -> str:
    """The name of a vector as one word of an expression."""
    return name.replace("^", CARET_REPLACEMENT)


def _replace_carets_in_names(text: str, named: Iterable[str]) -> str:
    """The text with the ^ in names replaced, the longest name first."""
    for name in sorted((n for n in named if "^" in n), key=len, reverse=True):
        text = re.sub(rf"(?<![\w{CARET_REPLACEMENT}]){re.escape(name)}(?![\w'′″])", name_without_caret(name), text)
    return text


def read_amount(text: str, parameters: NumbersByName, named: Iterable[str]) -> VectorAmount | float:
    """A number, or the amount that the plans will give; :class:`ExpressionError` in words."""
    total = _Sum.as_sum(AmountParser(text, parameters, tuple(named)).parse_expression())
    if not all(map(math.isfinite, total.terms.values())):
        raise AmountParser(text, parameters, tuple(named)).error_quoting_expression(Phrase("value_large"))
    plain = total.number is not None and sum(abs(p) for f in total.terms for _, p in f) < 2
    if plain and total.number is not None:
        return total.number
    return VectorAmount(text, tuple((c, f) for f, c in total.terms.items()))
