"""Expressions in a scene file: + - * / ** ^ ( ), parameters, pi and a dozen functions, angles in degrees.

Python's own evaluator is never used. Length and depth, and therefore time, are bounded, and all numbers are floats from
the start, so no power can exceed the largest float.
"""

import math
import re
import unicodedata
from collections.abc import Callable, Iterable, Mapping

from planes.geometry.arithmetic import Real, acos_deg, asin_deg, atan2_deg, atan_deg, cos_deg, sin_deg, tan_deg
from planes.scene.unit_words import FACTORS, unit_of
from planes.words import Phrase, Written
from planes.words.errors import ExpressionError, choices, shown

MAX_LENGTH = 1000
MAX_DEPTH = 40

_NUMBER = re.compile(r"[-+−]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?", re.ASCII)
_TOKEN = re.compile(r"\s*(?:((?a:\d+\.?\d*|\.\d+)(?a:[eE][-+]?\d+)?)|([^\W\d][\w'′″]*)|(\*\*|[-+*/^(),]))")
_NAME = re.compile(r"[^\W\d][\w'′″]*")

_FUNCTIONS: dict[str, tuple[Callable[..., float], int, int]] = {
    "sqrt": (math.sqrt, 1, 1),
    "abs": (abs, 1, 1),
    "min": (min, 2, MAX_LENGTH),
    "max": (max, 2, MAX_LENGTH),
    "hypot": (math.hypot, 2, MAX_LENGTH),
    "sin": (sin_deg, 1, 1),
    "cos": (cos_deg, 1, 1),
    "tan": (tan_deg, 1, 1),
    "asin": (asin_deg, 1, 1),
    "acos": (acos_deg, 1, 1),
    "atan": (atan_deg, 1, 1),
    "atan2": (atan2_deg, 2, 2),
}
RESERVED = ("pi", *_FUNCTIONS)  # reserved: no parameter may have these names


def evaluate(text: str, names: Mapping[str, float], valid: Iterable[str] | None = None) -> float:
    """The finite value of an expression over named numbers, or an ExpressionError in words.

    ``valid`` are the names a message offers, where they are more than ``names``.
    """
    value = float(text.replace("−", "-")) if is_plain(text) else ExpressionParser(text, names, valid or names).value()
    if not math.isfinite(value):
        raise _refusal(text, Phrase("value_large"))
    return value


def is_plain(text: str) -> bool:
    """Whether a text is already a number."""
    return len(text) <= 30 and _NUMBER.fullmatch(text) is not None


def is_name(text: str) -> bool:
    """Whether a parameter may have this name: letters of any alphabet, digits, _ and primes, a letter first."""
    return _NAME.fullmatch(text) is not None and (text[0].isalpha() or text[0] == "_")


def names_in(text: str) -> list[str]:
    """The names an expression uses, without functions and pi."""
    return [word for kind, word in tokens_of(text) if kind == "name" and word not in RESERVED]


def _refusal(text: str, why: Phrase) -> ExpressionError:
    return ExpressionError(Phrase("about", what=shown(text), why=why))


def tokens_of(text: str) -> list[tuple[str, str]]:
    """The tokens of a text: each piece with its kind, "number", "name" or "sign"."""
    if len(text) > MAX_LENGTH:
        raise _refusal(text, Phrase("expression_long", most=MAX_LENGTH))
    text = unicodedata.normalize("NFC", text).strip().replace("−", "-")
    if re.fullmatch(r"[-+]?\.?(nan|inf|infinity)", text, re.IGNORECASE):
        raise _refusal(text, Phrase("not_finite"))
    tokens: list[tuple[str, str]] = []
    place = 0
    while place < len(text):
        match = _TOKEN.match(text, place)
        if match is None or (match[2] and not is_name(match[2])):
            raise _refusal(text, _stray(text[place:].lstrip()[0], tokens))
        kind = ("number", "name", "sign")[(match.lastindex or 1) - 1]
        tokens.append((kind, match[match.lastindex or 1]))
        place = match.end()
    return tokens


def _stray(char: str, before: list[tuple[str, str]]) -> Phrase:
    if char == "·" and [kind for kind, _ in before[-2:]] == ["number", "name"]:
        return Phrase("unit_written", word=shown(before[-1][1]), hint="")
    if char == "°":
        return Phrase("degree_sign")
    if char in "×·":
        return Phrase("write_star", char=char)
    return Phrase("stray", char=shown(char))


class ExpressionParser:
    """A recursive-descent parser that calculates while it reads the tokens."""

    def __init__(self, text: str, names: Mapping[str, Real], valid: Iterable[str]) -> None:
        self.text, self.names, self.valid = text, names, valid
        self.tokens = [*tokens_of(text), ("end", "")]
        self.at = self.depth = 0

    def fail(self, why: Phrase) -> ExpressionError:
        """An error that quotes the expression."""
        return _refusal(self.text, why)

    def value(self) -> Real:
        """The value of the whole text."""
        if len(self.tokens) == 1:
            raise self.fail(Phrase("number_absent"))
        try:
            value = self.sum()
        except OverflowError:
            raise self.fail(Phrase("value_large")) from None
        except ZeroDivisionError:
            raise self.fail(Phrase("division_by_zero")) from None
        if self.tokens[self.at][0] != "end":
            raise self.fail(self._unexpected())
        return value

    def _unexpected(self) -> Phrase:
        kind, word = self.tokens[self.at]
        near = self.tokens[max(self.at - 1, 0) : self.at + 2]
        kinds = "-".join(kind for kind, _ in near)
        if word == "," and kinds == "number-sign-number":
            return Phrase("decimal_point", number=f"{near[0][1]}.{near[2][1]}")
        if kind == "end":
            return Phrase("end_absent")
        if kinds in ("number-name-end", "number-name-sign"):
            unit = unit_of([w for _, w in self.tokens[self.at :]])
            factor = FACTORS.get(unit.lower())
            for name in (*self.valid, *RESERVED):
                if name == word or FACTORS.get(name.lower(), name) == factor:
                    made = re.sub(rf"{re.escape(near[0][1])}\s*{word}", f"{near[0][1]}*{name}", self.text, count=1)
                    return Phrase("write_times", text=shown(made)[1:-1])
            hint = unit and Phrase("unit_in_si", unit=unit, factor=factor)
            return Phrase("unit_written", word=shown(word), hint=hint)
        return Phrase("unexpected" if kind == "sign" else "unexpected_operand", word=shown(word))

    def sign(self, *signs: str) -> str:
        """Take one of these signs if it comes next; "" otherwise."""
        kind, word = self.tokens[self.at]
        if kind == "sign" and word in signs:
            self.at += 1
            return word
        return ""

    def sum(self) -> Real:
        """Terms joined by + and -."""
        value = self.product()
        while sign := self.sign("+", "-"):
            value = value + self.product() if sign == "+" else value - self.product()
        return value

    def product(self) -> Real:
        """Factors joined by * and /."""
        value = self.signed()
        while sign := self.sign("*", "/"):
            value = value * self.signed() if sign == "*" else self.divided(value, self.signed())
        return value

    def signed(self) -> Real:
        """A power with its leading signs: -2^2 is -4."""
        self.depth += 1
        if self.depth > MAX_DEPTH:
            raise self.fail(Phrase("expression_deep", most=MAX_DEPTH))
        sign = self.sign("+", "-")
        value = (-self.signed() if sign == "-" else self.signed()) if sign else self.power()
        self.depth -= 1
        return value

    def power(self) -> Real:
        """An atom, raised to a power if one follows: 2^3^2 is 2^9."""
        base = self.atom()
        if not self.sign("^", "**"):
            return base
        return self.raised(base, self.signed())

    def divided(self, value: Real, by: Real) -> Real:
        """A quotient."""
        return value / by

    def raised(self, base: Real, exponent: Real) -> Real:
        """A power."""
        try:
            return math.pow(base, exponent)
        except ValueError:
            raise self.fail(Phrase("no_power", base=base, exponent=exponent)) from None

    def atom(self) -> Real:
        """A number, a name, a function call, or a sum in brackets."""
        kind, word = self.tokens[self.at]
        if kind == "number":
            self.at += 1
            return float(word)
        if kind == "name":
            self.at += 1
            return self.call(word) if word in _FUNCTIONS else self.named(word)
        if not self.sign("("):
            raise self.fail(self._unexpected())
        value = self.sum()
        self.close()
        return value

    def close(self) -> None:
        """Take the closing bracket."""
        if not self.sign(")"):
            raise self.fail(Phrase("bracket_absent") if self.tokens[self.at][0] == "end" else self._unexpected())

    def named(self, name: str) -> Real:
        """A parameter or pi."""
        if name in self.names:
            return self.names[name]
        if name == "pi":
            return math.pi
        if self.tokens[self.at] == ("sign", "("):
            raise self.fail(Phrase("no_function", name=shown(name), valid=choices(name, _FUNCTIONS)))
        if factor := FACTORS.get(name.lower()):
            raise self.fail(Phrase("unit_not_defined", name=name, factor=factor))
        valid = choices(name, [*self.valid, *RESERVED])
        raise self.fail(Phrase("not_defined", name=shown(name), valid=valid))

    def call(self, name: str) -> Real:
        """A function with its arguments in brackets."""
        function, least, most = _FUNCTIONS[name]
        if not self.sign("("):
            raise self.fail(Phrase("needs_brackets", name=name))
        given = [self.sum()]
        while self.sign(","):
            given.append(self.sum())
        self.close()
        if not least <= len(given) <= most:
            key = "takes_more" if least < most else ("takes_one" if most == 1 else "takes_count")
            hint = Phrase("hint_point") if len(given) > most else ""
            raise self.fail(Phrase(key, name=name, count=least, hint=hint))
        return self.called(name, function, given)

    def called(self, name: str, function: Callable[..., float], given: list[Real]) -> Real:
        """The value of a function for its arguments."""
        try:
            return function(*given)
        except ValueError:
            raise self.fail(
                Phrase("call_without_value", name=name, given=tuple(Written(f"{x:g}") for x in given))
            ) from None
