"""Expressions in a scene file: + - * / ** ^ ( ), parameters, pi and a dozen functions, angles in degrees.

Python's own evaluator is never used. Length and depth, and therefore time, are bounded, and all numbers are floats from
the start, so no power can exceed the largest float.
"""

import math
import re
import unicodedata
from collections.abc import Callable, Iterable, Mapping

from planes.geometry.arithmetic import Real, acos_deg, asin_deg, atan2_deg, atan_deg, cos_deg, sin_deg, tan_deg
from planes.scene.unit_words import UNIT_FACTORS, unit_at_start
from planes.words import Phrase, Written
from planes.words.errors import ExpressionError, list_valid_choices, quoted_excerpt
from planes.words.names import NamePair, NumbersByName

MAX_EXPRESSION_LENGTH = 1000
MAX_EXPRESSION_DEPTH = 40

_NUMBER_PATTERN = re.compile(r"[-+−]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?", re.ASCII)
_TOKEN_PATTERN = re.compile(r"\s*(?:((?a:\d+\.?\d*|\.\d+)(?a:[eE][-+]?\d+)?)|([^\W\d][\w'′″]*)|(\*\*|[-+*/^(),]))")
_NAME_PATTERN = re.compile(r"[^\W\d][\w'′″]*")

_FUNCTIONS: dict[str, tuple[Callable[..., float], int, int]] = {
    "sqrt": (math.sqrt, 1, 1),
    "abs": (abs, 1, 1),
    "min": (min, 2, MAX_EXPRESSION_LENGTH),
    "max": (max, 2, MAX_EXPRESSION_LENGTH),
    "hypot": (math.hypot, 2, MAX_EXPRESSION_LENGTH),
    "sin": (sin_deg, 1, 1),
    "cos": (cos_deg, 1, 1),
    "tan": (tan_deg, 1, 1),
    "asin": (asin_deg, 1, 1),
    "acos": (acos_deg, 1, 1),
    "atan": (atan_deg, 1, 1),
    "atan2": (atan2_deg, 2, 2),
}
RESERVED_NAMES = ("pi", *_FUNCTIONS)  # reserved: no parameter may have these names


def evaluate_expression(text: str, names: NumbersByName, valid: Iterable[str] | None = None) -> float:
    """The finite value of an expression over named numbers, or an ExpressionError in words.

    ``valid`` are the names a message offers, where they are more than ``names``.
    """
    value = (
        float(text.replace("−", "-"))
        if is_plain_number(text)
        else ExpressionParser(text, names, valid or names).parse_expression()
    )
    if not math.isfinite(value):
        raise _expression_error(text, Phrase("value_large"))
    return value


def is_plain_number(text: str) -> bool:
    """Whether a text is already a number."""
    return len(text) <= 30 and _NUMBER_PATTERN.fullmatch(text) is not None


def is_parameter_name(text: str) -> bool:
    """Whether a parameter may have this name: letters of any alphabet, digits, _ and primes, a letter first."""
    return _NAME_PATTERN.fullmatch(text) is not None and (text[0].isalpha() or text[0] == "_")


def names_in_expression(text: str) -> list[str]:
    """The names an expression uses, without functions and pi."""
    return [word for kind, word in split_into_tokens(text) if kind == "name" and word not in RESERVED_NAMES]


def _expression_error(text: str, why: Phrase) -> ExpressionError:
    return ExpressionError(Phrase("about", what=quoted_excerpt(text), why=why))


def split_into_tokens(text: str) -> list[NamePair]:
    """The tokens of a text: each piece with its kind, "number", "name" or "sign"."""
    if len(text) > MAX_EXPRESSION_LENGTH:
        raise _expression_error(text, Phrase("expression_long", most=MAX_EXPRESSION_LENGTH))
    text = unicodedata.normalize("NFC", text).strip().replace("−", "-")
    if re.fullmatch(r"[-+]?\.?(nan|inf|infinity)", text, re.IGNORECASE):
        raise _expression_error(text, Phrase("not_finite"))
    tokens: list[NamePair] = []
    place = 0
    while place < len(text):
        match = _TOKEN_PATTERN.match(text, place)
        if match is None or (match[2] and not is_parameter_name(match[2])):
            raise _expression_error(text, _stray_character_reason(text[place:].lstrip()[0], tokens))
        kind = ("number", "name", "sign")[(match.lastindex or 1) - 1]
        tokens.append((kind, match[match.lastindex or 1]))
        place = match.end()
    return tokens


def _stray_character_reason(char: str, before: list[NamePair]) -> Phrase:
    if char == "·" and [kind for kind, _ in before[-2:]] == ["number", "name"]:
        return Phrase("unit_written", word=quoted_excerpt(before[-1][1]), hint="")
    if char == "°":
        return Phrase("degree_sign")
    if char in "×·":
        return Phrase("write_star", char=char)
    return Phrase("stray", char=quoted_excerpt(char))


class ExpressionParser:
    """A recursive-descent parser that calculates while it reads the tokens."""

    def __init__(self, text: str, names: Mapping[str, Real], valid: Iterable[str]) -> None:
        self.text = text
        self.names = names
        self.valid = valid
        self.tokens = [*split_into_tokens(text), ("end", "")]
        self.at = self.depth = 0

    def error_quoting_expression(self, why: Phrase) -> ExpressionError:
        """An error that quotes the expression."""
        return _expression_error(self.text, why)

    def parse_expression(self) -> Real:
        """The value of the whole text."""
        if len(self.tokens) == 1:
            raise self.error_quoting_expression(Phrase("number_absent"))
        try:
            value = self.parse_sum()
        except OverflowError:
            raise self.error_quoting_expression(Phrase("value_large")) from None
        except ZeroDivisionError:
            raise self.error_quoting_expression(Phrase("division_by_zero")) from None
        if self.tokens[self.at][0] != "end":
            raise self.error_quoting_expression(self._unexpected_token_reason())
        return value

    def _unexpected_token_reason(self) -> Phrase:
        kind, word = self.tokens[self.at]
        near = self.tokens[max(self.at - 1, 0) : self.at + 2]
        kinds = "-".join(kind for kind, _ in near)
        if word == "," and kinds == "number-sign-number":
            return Phrase("decimal_point", number=f"{near[0][1]}.{near[2][1]}")
        if kind == "end":
            return Phrase("end_absent")
        if kinds in ("number-name-end", "number-name-sign"):
            unit = unit_at_start([w for _, w in self.tokens[self.at :]])
            factor = UNIT_FACTORS.get(unit.lower())
            for name in (*self.valid, *RESERVED_NAMES):
                if name == word or UNIT_FACTORS.get(name.lower(), name) == factor:
                    made = re.sub(rf"{re.escape(near[0][1])}\s*{word}", f"{near[0][1]}*{name}", self.text, count=1)
                    return Phrase("write_times", text=quoted_excerpt(made)[1:-1])
            hint = unit and Phrase("unit_in_si", unit=unit, factor=factor)
            return Phrase("unit_written", word=quoted_excerpt(word), hint=hint)
        return Phrase("unexpected" if kind == "sign" else "unexpected_operand", word=quoted_excerpt(word))

    def take_sign(self, *signs: str) -> str:
        """Take one of these signs if it comes next; "" otherwise."""
        kind, word = self.tokens[self.at]
        if kind == "sign" and word in signs:
            self.at += 1
            return word
        return ""

    def parse_sum(self) -> Real:
        """Terms joined by + and -."""
        value = self.parse_product()
        while sign := self.take_sign("+", "-"):
            value = value + self.parse_product() if sign == "+" else value - self.parse_product()
        return value

    def parse_product(self) -> Real:
        """Factors joined by * and /."""
        value = self.parse_signed_power()
        while sign := self.take_sign("*", "/"):
            value = (
                value * self.parse_signed_power()
                if sign == "*"
                else self.divide_values(value, self.parse_signed_power())
            )
        return value

    def parse_signed_power(self) -> Real:
        """A power with its leading signs: -2^2 is -4."""
        self.depth += 1
        if self.depth > MAX_EXPRESSION_DEPTH:
            raise self.error_quoting_expression(Phrase("expression_deep", most=MAX_EXPRESSION_DEPTH))
        sign = self.take_sign("+", "-")
        value = (
            (-self.parse_signed_power() if sign == "-" else self.parse_signed_power()) if sign else self.parse_power()
        )
        self.depth -= 1
        return value

    def parse_power(self) -> Real:
        """An atom, raised to a power if one follows: 2^3^2 is 2^9."""
        base = self.parse_atom()
        if not self.take_sign("^", "**"):
            return base
        return self.raise_to_power(base, self.parse_signed_power())

    def divide_values(self, value: Real, by: Real) -> Real:
        """A quotient."""
        return value / by

    def raise_to_power(self, base: Real, exponent: Real) -> Real:
        """A power."""
        try:
            return math.pow(base, exponent)
        except ValueError:
            raise self.error_quoting_expression(Phrase("no_power", base=base, exponent=exponent)) from None

    def parse_atom(self) -> Real:
        """A number, a name, a function call, or a sum in brackets."""
        kind, word = self.tokens[self.at]
        if kind == "number":
            self.at += 1
            return float(word)
        if kind == "name":
            self.at += 1
            if word in _FUNCTIONS:
                return self.parse_function_call(word)
            return self.value_of_name(word)
        if not self.take_sign("("):
            raise self.error_quoting_expression(self._unexpected_token_reason())
        value = self.parse_sum()
        self.take_closing_bracket()
        return value

    def take_closing_bracket(self) -> None:
        """Take the closing bracket."""
        if not self.take_sign(")"):
            raise self.error_quoting_expression(
                Phrase("bracket_absent") if self.tokens[self.at][0] == "end" else self._unexpected_token_reason()
            )

    def value_of_name(self, name: str) -> Real:
        """A parameter or pi."""
        if name in self.names:
            return self.names[name]
        if name == "pi":
            return math.pi
        if self.tokens[self.at] == ("sign", "("):
            raise self.error_quoting_expression(
                Phrase("no_function", name=quoted_excerpt(name), valid=list_valid_choices(name, _FUNCTIONS))
            )
        if factor := UNIT_FACTORS.get(name.lower()):
            raise self.error_quoting_expression(Phrase("unit_not_defined", name=name, factor=factor))
        valid = list_valid_choices(name, [*self.valid, *RESERVED_NAMES])
        raise self.error_quoting_expression(Phrase("not_defined", name=quoted_excerpt(name), valid=valid))

    def parse_function_call(self, name: str) -> Real:
        """A function with its arguments in brackets."""
        function, least, most = _FUNCTIONS[name]
        if not self.take_sign("("):
            raise self.error_quoting_expression(Phrase("needs_brackets", name=name))
        given = [self.parse_sum()]
        while self.take_sign(","):
            given.append(self.parse_sum())
        self.take_closing_bracket()
        if not least <= len(given) <= most:
            key = "takes_more" if least < most else ("takes_one" if most == 1 else "takes_count")
            hint = Phrase("hint_point") if len(given) > most else ""
            raise self.error_quoting_expression(Phrase(key, name=name, count=least, hint=hint))
        return self.value_of_function(name, function, given)

    def value_of_function(self, name: str, function: Callable[..., float], given: list[Real]) -> Real:
        """The value of a function for its arguments."""
        try:
            return function(*given)
        except ValueError:
            raise self.error_quoting_expression(
                Phrase("call_without_value", name=name, given=tuple(Written(f"{x:g}") for x in given))
            ) from None
