"""A calculation step in words: its formula, the same with numbers, and the value, as a note writes them."""

from __future__ import annotations

from dataclasses import dataclass

from planes.drawing import Drawing
from planes.reckoning import Calculate, Product
from planes.units import quantity
from planes.words import Lang

_UNITS = (
    ("omega", "rad/s"), ("epsilon", "rad/s²"), ("v", "m/s"), ("vq", "m/s"), ("a", "m/s²"), ("l", "m"), ("h", "m"),
    ("arm", "m"), ("m", "kg"), ("J", "kg·m²"), ("g", "m/s²"), ("G", "N"), ("I", "N"), ("P", "N"), ("F", "N"),
    ("N", "N"), ("T", "N"), ("M", "N·m"), ("MI", "N·m"), ("MR", "N·m"), ("MP", "N·m"), ("MZ", "N·m"), ("Fb", "N"),
)  # fmt: skip


@dataclass(frozen=True)
class Formula:
    """``name`` = ``symbols`` = ``numbers`` = ``value`` ``unit``; names stand in ⟨…⟩."""

    name: str
    symbols: str
    numbers: str
    value: str
    unit: str

    def __str__(self) -> str:
        return f"⟨{self.name}⟩ = {self.symbols} = {self.numbers} = {self.value} {self.unit}"


def unit_of(name: str) -> str:
    """The SI unit of a value by its name."""
    letter = name.strip("|‖").partition("_")[0]
    return dict(_UNITS).get(letter, "")


def number(value: float, lang: Lang, digits: int = 4) -> str:
    """A number as the language writes it."""
    text = quantity(value, digits=digits)
    return text.replace(".", ",") if lang == "ru" else text


def formula(step: Calculate, drawing: Drawing, lang: Lang) -> Formula:
    """The formula of a calculation step, with the numbers of a drawing."""
    symbols = _sum([_product(t, lambda n: f"⟨{n}⟩") for t in step.terms])
    numbers = _sum([_product(t, lambda n: bracketed(number(drawing[n], lang))) for t in step.terms])
    return Formula(step.makes, symbols, numbers, number(drawing[step.makes], lang), unit_of(step.makes))


def bracketed(text: str) -> str:
    """A negative number in brackets, to stand inside a formula."""
    return f"({text})" if text.startswith(("-", "−")) else text


def _product(term: Product, say: object) -> tuple[bool, str]:
    """Whether the product is subtracted, and its text: factors over factors."""
    assert callable(say)
    size = abs(term.coefficient)
    above = ([f"{size:g}"] if size != 1 else []) + [_power(say(n), p) for n, p in term.factors if p > 0]
    below = [_power(say(n), -p) for n, p in term.factors if p < 0]
    text = " · ".join(above) or "1"
    if below:
        text += " / " + (below[0] if len(below) == 1 else f"({' · '.join(below)})")
    return term.coefficient < 0, text


def _power(text: str, power: int) -> str:
    return text + {1: "", 2: "²", 3: "³"}.get(power, f"^{power}")


def _sum(parts: list[tuple[bool, str]]) -> str:
    text = ""
    for minus, part in parts:
        text += (" − " if minus else " + ") + part if text else ("−" if minus else "") + part
    return text or "0"
