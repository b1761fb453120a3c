"""Formulas of a lesson with slots for numbers, so that one sentence serves every position of the mechanism.

A slot ⟦how¦name¦mu⟧ stands for a number of the drawing: ``v`` its value, ``b`` the value in brackets where it is
negative, ``mm`` its length on paper, ``s`` its sense of rotation, ``k`` and ``i`` a scale, in mm for a unit and the
inverse; ``a`` its value without a sign; ``join`` and ``lead`` the sign of a product of values (names by ``*``, after a
minus of their own), between terms and before the first; ``n`` a number that is its own name. Names of marks, vectors
and values stand in ⟨…⟩.
"""

import math
import re
from collections.abc import Callable
from typing import TypeVar

from planes.drafting.steps.reckoning import Calculate, Product
from planes.words import Lang, decimal, langs, say
from planes.words.names import kind_of, mu_of, parts_of
from planes.words.units import Convention, mu_number, mu_text, number

One = TypeVar("One")
LANGS = langs("lesson")
SLOT = re.compile(r"⟦(\w+)¦([^¦⟧]+)(?:¦([^⟧]+))?⟧")
SIGNS = ("s", "join", "lead")  # slots that give no number
NOISE = 1e-12  # what is smaller is nothing: an arm that is zero, a force that is not there
SCALES: dict[str, Convention] = {"k": "mm_per_unit", "i": "unit_per_mm"}
_LETTERS = {
    "rad/s": "omega",
    "rad/s²": "epsilon",
    "m/s": "v vq H",
    "m/s²": "a g",
    "m": "l h e r s x y arm rho",
    "kg": "m",
    "kgm2": "J",
    "N": "G I Φ Ф P Q R F N S T FZ Fb",
    "N·m": "M MI MR MP MZ MT",
    "W": "PT",
}
UNITS = {letter: key for key, letters in _LETTERS.items() for letter in letters.split()}


def in_both(say_in: Callable[[Lang], One]) -> dict[Lang, One]:
    """What is told, in every language of lessons."""
    return {lang: say_in(lang) for lang in LANGS}


def unit(name: str, lang: Lang) -> str:
    """The SI unit of a value by its name, as the language writes it."""
    key = UNITS.get(parts_of(name)[0])
    return say(key, lang) if key else ""


def slot(name: str, how: str = "v", mu: str = "") -> str:
    """A slot for a value; of a length in millimetres of paper, with the μ it is drawn at."""
    return f"⟦{how}¦{name}{mu and f'¦{mu}'}⟧"


def fill(text: str, read: Callable[[str], float], lang: Lang) -> str:
    """A sentence with its numbers, as ``read`` gives them by name."""

    def one(match: re.Match[str]) -> str:
        how, name, mu = match.groups()
        if how == "n":
            return decimal(name, lang)
        first, values = -1.0 if name.startswith("−") else 1.0, [*map(read, own(name))]
        if how in ("join", "lead"):  # the sign of a product: what is nothing has none
            values = [math.copysign(1.0, v) for v in values if not abs(v) < NOISE]
        size = math.prod(values, start=first)
        size = 0.0 if abs(size) < NOISE else size
        if how == "mm":
            return decimal(f"{abs(size * read(mu)):.1f}".removesuffix(".0"), lang)
        if how == "s":
            return say("lesson_ccw" if size > 0 else "lesson_cw" if size < 0 else "lesson_still", lang)
        if how == "join":
            return " − " if size < 0 else " + "
        if how == "lead":
            return "−" if size < 0 else ""
        if how in SCALES:
            return decimal(mu_number(size, SCALES[how]), lang)
        shown = number(abs(size) if how == "a" else size, lang)
        return f"({shown})" if how == "b" and shown.startswith("−") else shown

    return SLOT.sub(one, text)


def slots(text: str) -> list[str]:
    """Names of the values a sentence needs, each time it does."""
    return [part for how, name, _ in SLOT.findall(text) if how != "n" for part in own(name)]


def own(name: str) -> list[str]:
    """The values a slot is of: one, or those of a product."""
    return name.removeprefix("−").split("*")


def formula(step: Calculate) -> tuple[str, str]:
    """A sum of products in letters, and with its numbers."""
    letters = _sum([_product(t, lambda n: f"⟨{n}⟩") for t in step.terms])
    return letters, _sum([_product(t, lambda n: slot(n, "b")) for t in step.terms])


def by_sense(
    step: Calculate, size: Callable[[str], str], without: str, arm: str, drop: frozenset[int], sought: str = ""
) -> tuple[str, str]:
    """Both sides of an equation of moments: each term with the sign it has, its arm and sizes without, the
    sizes written as ``size`` says; what is ``sought`` has an ``arm`` too, and is positive the way it acts."""
    letters = numbers = ""
    for i, term in enumerate(step.terms):
        if i not in drop:
            product = _clear(term, without)
            names = [n for n, power in product.factors if power % 2]
            names += [arm, sought] if sought else [arm] * bool(arm and arm == without)
            sense = slot(("−" if term.coefficient < 0 else "") + "*".join(names), "join" if letters else "lead")
            letters += sense + _product(product, size)[1]
            numbers += sense + _product(product, lambda n: slot(n, "a"))[1]
    return letters, numbers


def _clear(term: Product, without: str) -> Product:
    return Product(term.coefficient, tuple(f for f in term.factors if f != (without, -1)))


def _product(term: Product, say: Callable[[str], str]) -> tuple[bool, str]:
    """Whether the product is subtracted, and its text: factors over factors."""
    size = abs(term.coefficient)
    above = ([slot(f"{size:g}", "n")] if size != 1 else []) + [_power(say(n), p) for n, p in term.factors if p > 0]
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


def mu_said(plan: str, lang: Lang, convention: Convention = "mm_per_unit") -> str:
    """The scale of a plan as the language writes it, its number in a slot; the lever is drawn as velocities are."""
    how, kind = "k" if convention == "mm_per_unit" else "i", "velocity" if plan == "lever" else kind_of(plan)
    return f"{slot(mu_of(plan), how)} {mu_text(1.0, kind, lang, convention).partition(' ')[2]}"
