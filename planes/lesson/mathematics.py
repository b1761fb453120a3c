"""A line of reckoning as mathematics (mathtext): fractions as fractions, in pieces that a line may break between."""

import re
from collections.abc import Callable

from planes.lesson.formulas import fill, slot, unit
from planes.lesson.rows import Row, remark
from planes.words import say
from planes.words.naming import Naming
from planes.words.units import RAISED, in_tex

Read = Callable[[str], float]
TOKEN = re.compile(rf"⟨([^⟩]*)⟩|(−?\d[\d.,]*(?:·10[{RAISED}]+)?)|([²³])|([^\W\d_]+)")
INDEX = re.compile(r"[^\W\d_]*[А-яЁёІіЎўЄєЇїҐґ][\w. ]*")


class Typesetter:
    """Sets lines of reckoning of one plan; ``read`` gives a value by its name."""

    def __init__(self, read: Read, naming: Naming, plan: str = "") -> None:
        self.read, self.naming, self.plan = read, naming, plan

    def line(self, row: Row) -> tuple[str, ...]:
        """``head = letters = numbers = value unit`` in pieces, each but the first with the sign it begins with."""
        lang, name = self.naming.lang, f"⟨{row.name}⟩"
        if not row.numbers:
            return self.pieces(f"{name} = 0")
        between = say("mm", lang) if row.kind == "measured" else "="
        shown = list(self.pieces(f"{row.head or name} = {row.letters} {between} {row.numbers}"))
        if row.arm:
            arm = self.pieces(f"⟨{row.arm}⟩ = {slot(row.arm, 'a')}")
            shown.append(rf"\ ({''.join(arm)}\ {upright(say('m', lang))})")
        if row.head:
            words = remark(row.kind, lang)
            shown.append(rf";\ \ {upright(f'{words} ') if words else ''}{self.term(name)}")
        value = f"={self.term(self.filled(row.value))}"
        unit_words = unit(row.name, row.unit_key).told(lang)
        shown.append(rf"{value}\ {upright(unit_words)}" if unit_words else value)
        if row.turns:
            shown.append(rf"\ \ ({upright(self.filled(slot(row.name, 's')))})")
        return tuple(shown)

    def filled(self, text: str) -> str:
        """A text with its numbers."""
        return fill(text, self.read, self.naming.lang)

    def pieces(self, text: str) -> tuple[str, ...]:
        """An equality at its signs."""
        first, *rest = parted(self.filled(text), "=+−")
        signed = (sign.replace("−", "-") + self.term(piece) for sign, piece in zip(rest[::2], rest[1::2], strict=True))
        return self.term(first), *signed

    def term(self, text: str) -> str:
        """A product, or a quotient of two."""
        if text[:1] == "−":  # in braces it is a sign of this term, not between two
            return f"{{-{self.term(text[1:])}}}"
        above, *below = parted(text, "/")
        if not below:
            return r" \cdot ".join(map(self.factor, parted(above, "·")[::2]))
        return rf"\dfrac{{{self.term(bare(above))}}}{{{self.term(bare(below[1]))}}}"

    def factor(self, text: str) -> str:
        """A name, a number, or an expression in brackets."""
        return TOKEN.sub(self.token, text.replace("∣", "|"))

    def token(self, match: re.Match[str]) -> str:
        """A name, a number (in braces with its sign), a power, or a word."""
        name, number, power, word = match.groups()
        if name is not None:
            named = self.naming.named(name, self.plan).replace("−", "-").replace(",", "{,}")
            return INDEX.sub(lambda m: upright(m[0]), named)
        if number:
            return in_tex(f"{{-{number[1:]}}}" if number[0] == "−" else number)
        return f"^{'²³'.index(power) + 2}" if power else rf"\ {upright(word)}"


def upright(text: str) -> str:
    """Words in a formula."""
    return rf"\mathrm{{{text.replace(' ', chr(92) + ' ')}}}"


def bare(text: str) -> str:
    """What is in brackets as a whole, without them."""
    return text[1:-1] if re.fullmatch(r"\([^()]*\)", text) else text


def parted(text: str, signs: str) -> list[str]:
    """A text at those signs that stand in no brackets: pieces and signs in turn."""
    pieces, depth = [""], 0
    for part in re.split(r"( [·+−/=] |[()])", text):
        depth += (part == "(") - (part == ")")
        if len(part) == 3 and part[1] in signs and part[::2] == "  " and not depth:
            pieces += [part[1], ""]
        else:
            pieces[-1] += part
    return pieces
