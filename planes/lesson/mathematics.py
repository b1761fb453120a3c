"""A line of reckoning as mathematics (mathtext): fractions as fractions, in pieces that a line may break between."""

import re
from collections.abc import Callable

from planes.lesson.formulas import fill_slots, unit_of_name, value_slot
from planes.lesson.rows import Row, row_remark
from planes.words import say
from planes.words.frozen import frozen
from planes.words.names import NO_PLAN, PlanId
from planes.words.naming import Naming
from planes.words.units import RAISED_DIGITS, number_in_tex

Read = Callable[[str], float]
TOKEN_PATTERN = re.compile(rf"⟨([^⟩]*)⟩|(−?\d[\d.,]*(?:·10[{RAISED_DIGITS}]+)?)|([²³])|([^\W\d_]+)")
WORD_INDEX_PATTERN = re.compile(r"[^\W\d_]*[А-яЁёІіЎўЄєЇїҐґ][\w. ]*")


@frozen
class Typesetter:
    """Sets lines of reckoning of one plan; ``read`` gives a value by its name."""

    read: Read
    naming: Naming
    plan: PlanId = NO_PLAN

    def typeset_row(self, row: Row) -> tuple[str, ...]:
        """``head = letters = numbers = value unit`` in pieces, each but the first with the sign it begins with."""
        lang = self.naming.lang
        name = f"⟨{row.name}⟩"
        if not row.numbers:
            return self.split_equality(f"{name} = 0")
        between = say("mm", lang) if row.kind == "measured" else "="
        shown = list(self.split_equality(f"{row.head or name} = {row.letters} {between} {row.numbers}"))
        if row.arm:
            arm = self.split_equality(f"⟨{row.arm}⟩ = {value_slot(row.arm, 'a')}")
            shown.append(rf"\ ({''.join(arm)}\ {upright_words(say('m', lang))})")
        if row.head:
            words = row_remark(row.kind, lang)
            shown.append(rf";\ \ {upright_words(f'{words} ') if words else ''}{self.typeset_term(name)}")
        value = f"={self.typeset_term(self.fill_numbers(row.value))}"
        unit_words = unit_of_name(row.name, row.unit_key).told(lang)
        shown.append(rf"{value}\ {upright_words(unit_words)}" if unit_words else value)
        if row.turns:
            shown.append(rf"\ \ ({upright_words(self.fill_numbers(value_slot(row.name, 's')))})")
        return tuple(shown)

    def fill_numbers(self, text: str) -> str:
        """A text with its numbers."""
        return fill_slots(text, self.read, self.naming.lang)

    def split_equality(self, text: str) -> tuple[str, ...]:
        """An equality at its signs."""
        first, *rest = split_at_signs(self.fill_numbers(text), "=+−")
        signed = (
            sign.replace("−", "-") + self.typeset_term(piece) for sign, piece in zip(rest[::2], rest[1::2], strict=True)
        )
        return self.typeset_term(first), *signed

    def typeset_term(self, text: str) -> str:
        """A product, or a quotient of two."""
        if text[:1] == "−":  # in braces it is a sign of this term, not between two
            return f"{{-{self.typeset_term(text[1:])}}}"
        above, *below = split_at_signs(text, "/")
        if not below:
            return r" \cdot ".join(map(self.typeset_factor, split_at_signs(above, "·")[::2]))
        numerator, denominator = (self.typeset_term(without_brackets(part)) for part in (above, below[1]))
        return rf"\dfrac{{{numerator}}}{{{denominator}}}"

    def typeset_factor(self, text: str) -> str:
        """A name, a number, or an expression in brackets."""
        return TOKEN_PATTERN.sub(self.typeset_token, text.replace("∣", "|"))

    def typeset_token(self, match: re.Match[str]) -> str:
        """A name, a number (in braces with its sign), a power, or a word."""
        name, number, power, word = match.groups()
        if name is not None:
            named = self.naming.lettered_name(name, self.plan).replace("−", "-").replace(",", "{,}")
            return WORD_INDEX_PATTERN.sub(lambda m: upright_words(m[0]), named)
        if number:
            return number_in_tex(f"{{-{number[1:]}}}" if number[0] == "−" else number)
        if power:
            return f"^{'²³'.index(power) + 2}"
        return rf"\ {upright_words(word)}"


def upright_words(text: str) -> str:
    """Words in a formula."""
    return rf"\mathrm{{{text.replace(' ', chr(92) + ' ')}}}"


def without_brackets(text: str) -> str:
    """What is in brackets as a whole, without them."""
    return text[1:-1] if re.fullmatch(r"\([^()]*\)", text) else text


def split_at_signs(text: str, signs: str) -> list[str]:
    """A text at those signs that stand in no brackets: pieces and signs in turn."""
    pieces = [""]
    depth = 0
    for part in re.split(r"( [·+−/=] |[()])", text):
        depth += (part == "(") - (part == ")")
        if len(part) == 3 and part[1] in signs and part[::2] == "  " and not depth:
            pieces += [part[1], ""]
        else:
            pieces[-1] += part
    return pieces
