"""Formulas of a lesson with slots for numbers, so that one sentence serves every position of the mechanism.

A slot ⟦how¦name¦mu⟧ stands for a number of the drawing: ``v`` its value, ``b`` the value in brackets where it is
negative, ``mm`` its length on paper, ``s`` its sense of rotation, ``k`` and ``i`` a scale, in mm per unit and inverted;
``a`` its absolute value; ``join`` and ``lead`` the sign of a product of values (names joined by ``*``, after a possible
minus), between terms and before the first; ``n`` a number that is written out. Names of marks, vectors and values are
in ⟨…⟩.
"""

import math
import re
from collections.abc import Callable, Iterable
from typing import TypeVar

from planes.drafting.steps.reckoning import Calculate, Product
from planes.words import Lang, Phrase, Written, available_languages, say, with_decimal_sign
from planes.words.names import PlanId, split_value_name
from planes.words.units import Convention, mu_number, mu_text, number_text

One = TypeVar("One")
LESSON_LANGS = available_languages("lesson")
SLOT_PATTERN = re.compile(r"⟦(\w+)¦([^¦⟧]+)(?:¦([^⟧]+))?⟧")
SIGN_SLOT_KINDS = ("s", "join", "lead")  # slots that print no number
LEAST_NONZERO_VALUE = 1e-12  # smaller values are zero: a zero arm, an absent force
SCALE_CONVENTIONS_BY_SLOT: dict[str, Convention] = {"k": "mm_per_unit", "i": "unit_per_mm"}
_LETTERS_BY_UNIT = {
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
UNITS_BY_LETTER = {letter: key for key, letters in _LETTERS_BY_UNIT.items() for letter in letters.split()}


def in_lesson_languages(say_in: Callable[[Lang], One]) -> dict[Lang, One]:
    """The text in every language of lessons."""
    return {lang: say_in(lang) for lang in LESSON_LANGS}


def sentence_in_lesson_languages(key: str, **names: object) -> dict[Lang, str]:
    """A sentence of the table in every language of lessons."""
    return in_lesson_languages(Phrase(key, **names).told)


def in_brackets(names: Iterable[str]) -> str:
    """Names for a sentence, each to be lettered."""
    return ", ".join(f"⟨{name}⟩" for name in names)


def unit_of_name(name: str, key: str = "") -> Phrase | Written:
    """The SI unit of a value by its name, unless its ``key`` is known; empty where it has none."""
    key = key or UNITS_BY_LETTER.get(split_value_name(name)[0], "")
    return Phrase(key) if key else Written("")


def value_slot(name: str, how: str = "v", mu: str = "") -> str:
    """A slot for a value; for a length in millimetres of paper, with the μ of its plan."""
    return f"⟦{how}¦{name}{mu and f'¦{mu}'}⟧"


def fill_slots(text: str, read: Callable[[str], float], lang: Lang) -> str:
    """A sentence with its numbers, which ``read`` gives by name."""

    def one(match: re.Match[str]) -> str:
        how, name, mu = match.groups()
        if how == "n":
            return with_decimal_sign(name, lang)
        first = -1.0 if name.startswith("−") else 1.0
        values = [*map(read, factors_of_slot(name))]
        if how in ("join", "lead"):  # the sign of a product; zero has none
            values = [math.copysign(1.0, v) for v in values if not abs(v) < LEAST_NONZERO_VALUE]
        size = math.prod(values, start=first)
        size = 0.0 if abs(size) < LEAST_NONZERO_VALUE else size
        if how == "mm":
            return with_decimal_sign(f"{abs(size * read(mu)):.1f}".removesuffix(".0"), lang)
        if how == "s":
            return say("lesson_ccw" if size > 0 else "lesson_cw" if size < 0 else "lesson_still", lang)
        if how == "join":
            return " − " if size < 0 else " + "
        if how == "lead":
            return "−" if size < 0 else ""
        if how in SCALE_CONVENTIONS_BY_SLOT:
            return with_decimal_sign(mu_number(size, SCALE_CONVENTIONS_BY_SLOT[how]), lang)
        shown = number_text(abs(size) if how == "a" else size, lang)
        return f"({shown})" if how == "b" and shown.startswith("−") else shown

    return SLOT_PATTERN.sub(one, text)


def slot_value_names(text: str) -> list[str]:
    """Names of the values in a sentence, once for each use."""
    return [part for how, name, _ in SLOT_PATTERN.findall(text) if how != "n" for part in factors_of_slot(name)]


def factors_of_slot(name: str) -> list[str]:
    """The values of a slot: one, or those of a product."""
    return name.removeprefix("−").split("*")


def formula_and_numbers(step: Calculate) -> tuple[str, str]:
    """A sum of products in letters, and with its numbers."""
    letters = _sum_text([_product_text(t, lambda n: f"⟨{n}⟩") for t in step.terms])
    return letters, _sum_text([_product_text(t, lambda n: value_slot(n, "b")) for t in step.terms])


def signed_moment_terms(
    step: Calculate, size: Callable[[str], str], without: str, arm: str, drop: frozenset[int], sought: str = ""
) -> tuple[str, str]:
    """Both sides of an equation of moments: each term with its sign, arms and magnitudes unsigned, the magnitudes in
    the form of ``size``; the unknown ``sought`` has an ``arm`` too, and is positive in its own sense."""
    letters = numbers = ""
    for i, term in enumerate(step.terms):
        if i not in drop:
            product = Product(term.coefficient, tuple(f for f in term.factors if f != (without, -1)))
            names = [n for n, power in product.factors if power % 2]
            names += [arm, sought] if sought else [arm] * bool(arm and arm == without)
            sense = value_slot(("−" if term.coefficient < 0 else "") + "*".join(names), "join" if letters else "lead")
            letters += sense + _product_text(product, size)[1]
            numbers += sense + _product_text(product, lambda n: value_slot(n, "a"))[1]
    return letters, numbers


def _product_text(term: Product, say: Callable[[str], str]) -> tuple[bool, str]:
    """Whether the product is subtracted, and its text: factors over factors."""
    size = abs(term.coefficient)
    above = ([value_slot(f"{size:g}", "n")] if size != 1 else []) + [
        _power_text(say(n), p) for n, p in term.factors if p > 0
    ]
    below = [_power_text(say(n), -p) for n, p in term.factors if p < 0]
    text = " · ".join(above) or "1"
    if below:
        text += " / " + (below[0] if len(below) == 1 else f"({' · '.join(below)})")
    return term.coefficient < 0, text


def _power_text(text: str, power: int) -> str:
    return text + {1: "", 2: "²", 3: "³"}.get(power, f"^{power}")


def _sum_text(parts: list[tuple[bool, str]]) -> str:
    text = ""
    for minus, part in parts:
        text += (" − " if minus else " + ") + part if text else ("−" if minus else "") + part
    return text or "0"


def plan_scale_text(plan: PlanId, lang: Lang, convention: Convention = "mm_per_unit") -> str:
    """The scale of a plan as written in the language, its number in a slot; the lever has the scale of velocities."""
    how = "k" if convention == "mm_per_unit" else "i"
    kind = "velocity" if plan == "lever" else plan.kind
    return f"{value_slot(plan.mu_name, how)} {mu_text(1.0, kind, lang, convention).partition(' ')[2]}"
