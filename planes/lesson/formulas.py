"""Formulas of a lesson with slots for numbers, so that one sentence serves every position of the mechanism.

A slot ⟦how¦name¦mu⟧ stands for a number of the drawing: ``v`` its value, ``b`` the value in brackets where it is
negative, ``mm`` its length on paper, ``s`` its sense of rotation, ``k`` and ``i`` a scale, in mm per unit and inverted;
``a`` its absolute value; ``join`` and ``lead`` the sign of a product of values (names joined by ``*``, after a possible
minus), between terms and before the first; ``n`` a number that is written out. Names of marks, vectors and values are
in ⟨…⟩.
"""

import math
import re
from collections.abc import Callable
from typing import TypeVar

from planes.drafting.steps.reckoning import Calculate, Product
from planes.words import Lang, Phrase, Written, decimal, langs, say
from planes.words.names import kind_of, mu_of, parts_of
from planes.words.units import Convention, mu_number, mu_text, number

One = TypeVar("One")
LANGS = langs("lesson")
SLOT = re.compile(r"⟦(\w+)¦([^¦⟧]+)(?:¦([^⟧]+))?⟧")
SIGNS = ("s", "join", "lead")  # slots that print no number
NOISE = 1e-12  # smaller values are zero: a zero arm, an absent force
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
    """The text in every language of lessons."""
    return {lang: say_in(lang) for lang in LANGS}


def spoken(key: str, **names: object) -> dict[Lang, str]:
    """A sentence of the table in every language of lessons."""
    return in_both(Phrase(key, **names).told)


def unit(name: str, key: str = "") -> Phrase | Written:
    """The SI unit of a value by its name, unless its ``key`` is known; empty where it has none."""
    key = key or UNITS.get(parts_of(name)[0], "")
    return Phrase(key) if key else Written("")


def slot(name: str, how: str = "v", mu: str = "") -> str:
    """A slot for a value; for a length in millimetres of paper, with the μ of its plan."""
    return f"⟦{how}¦{name}{mu and f'¦{mu}'}⟧"


def fill(text: str, read: Callable[[str], float], lang: Lang) -> str:
    """A sentence with its numbers, which ``read`` gives by name."""

    def one(match: re.Match[str]) -> str:
        how, name, mu = match.groups()
        if how == "n":
            return decimal(name, lang)
        first, values = -1.0 if name.startswith("−") else 1.0, [*map(read, own(name))]
        if how in ("join", "lead"):  # the sign of a product; zero has none
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
    """Names of the values in a sentence, once for each use."""
    return [part for how, name, _ in SLOT.findall(text) if how != "n" for part in own(name)]


def own(name: str) -> list[str]:
    """The values of a slot: one, or those of a product."""
    return name.removeprefix("−").split("*")


def formula(step: Calculate) -> tuple[str, str]:
    """A sum of products in letters, and with its numbers."""
    letters = _sum([_product(t, lambda n: f"⟨{n}⟩") for t in step.terms])
    return letters, _sum([_product(t, lambda n: slot(n, "b")) for t in step.terms])


def by_sense(
    step: Calculate, size: Callable[[str], str], without: str, arm: str, drop: frozenset[int], sought: str = ""
) -> tuple[str, str]:
    """Both sides of an equation of moments: each term with its sign, arms and magnitudes unsigned, the magnitudes in
    the form of ``size``; the unknown ``sought`` has an ``arm`` too, and is positive in its own sense."""
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
    """The scale of a plan as written in the language, its number in a slot; the lever has the scale of velocities."""
    how, kind = "k" if convention == "mm_per_unit" else "i", "velocity" if plan == "lever" else kind_of(plan)
    return f"{slot(mu_of(plan), how)} {mu_text(1.0, kind, lang, convention).partition(' ')[2]}"
