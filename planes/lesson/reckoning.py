"""No number is used before it is found: what a sentence needs and none before it told, and how that is found."""

import re
from collections.abc import Callable, Iterator, Mapping

from planes.drafting.program import Program
from planes.drafting.steps import Step
from planes.drafting.steps.reckoning import Calculate, Drop, Measure
from planes.drafting.steps.settling import Fed, Settle
from planes.lesson.formulas import SIGNS, SLOT, by_sense, formula, slot, unit
from planes.plans import Plans
from planes.plans.force.loads import load_names
from planes.words import Lang, say

_FOUND = re.compile(r"(?:^|[:;.] )⟨([^⟩]+)⟩ =")  # a sentence, or a part of one, that says what a value is


class Reckoning:
    """Keeps which values have been told; ``divided`` says how a length on paper becomes a value at a scale."""

    def __init__(self, plans: Plans, made: Mapping[str, Step], divided: Callable[[str], str]) -> None:
        self.plans, self.made, self.divided = plans, made, divided
        self.told = {*plans.given, *load_names(plans.mechanism), *(m.unknown for m in plans.moments)}

    def tell(self, text: str) -> None:
        """A sentence has been said."""
        self.told |= {*map(plain, used(text)), *_FOUND.findall(text)}

    def missing(self, text: str) -> list[Step]:
        """The steps that find what the sentence needs, in the order they can be told; they are told now."""
        own, found = set(_FOUND.findall(text)), dict[str, Step]()
        for name in used(text):
            if plain(name) not in own:
                self._find(name, found)
        return list(found.values())

    def _find(self, name: str, found: dict[str, Step]) -> None:
        step = self.made.get(name)
        if plain(name) in self.told or not isinstance(step, Calculate | Drop | Measure | Fed | Settle):
            return
        self.told.add(plain(name))
        if isinstance(step, Calculate):
            for factor in factors(step):
                self._find(factor, found)
        found[name] = step

    def readings(self, steps: list[Step], lang: Lang) -> str:
        """How each is found: its formula, or its length on paper."""
        return "; ".join(self.reading(step, lang) for step in steps)

    def reading(self, step: Step, lang: Lang) -> str:
        """One of them."""
        if isinstance(step, Calculate):
            return self.reduced(step, lang) if step.quantity == "arm" else formula(step, lang)
        if isinstance(step, Fed | Settle):
            return self.rubbing(step, lang)
        assert isinstance(step, Drop | Measure)
        name = plain(step.makes)
        names = {"mm": slot(step.makes, "mm", step.mu), "by": self.divided(step.mu)}
        names["value"] = slot(step.makes, "a" if isinstance(step, Drop) else "v")  # an arm has no sign
        return say("lesson_reading", lang, name=name, unit=unit(name, lang), **names)

    def reduced(self, step: Calculate, lang: Lang) -> str:
        """The arm that a force has together with another that it calls forth, by sense: it has no sign."""
        letters, numbers = by_sense(step, "⟨{}⟩".format, step.makes, step.makes, frozenset())
        names = {"name": step.makes, "letters": letters, "numbers": numbers, "value": slot(step.makes, "a")}
        return say("lesson_reduced", lang, **names, unit=unit(step.makes, lang))

    def rubbing(self, step: Fed | Settle, lang: Lang) -> str:
        """The couple of friction in a hinge: the reaction times the radius of the friction circle."""
        fed = step if isinstance(step, Fed) else next(f for f in step.fed if f.makes == step.makes)
        factor = self.made[fed.factor]
        assert isinstance(factor, Calculate)
        circle, force = factor.terms[0].factors[0][0], plain(fed.size)
        names = {"couple": step.makes, "circle": circle, "force": force, "long": slot(circle), "size": slot(fed.size)}
        key = "lesson_couple" if isinstance(step, Fed) else "lesson_couple_settled"
        return say(key, lang, **names, value=slot(step.makes))


def used(text: str) -> list[str]:
    """The values a sentence gives as numbers, not by their sense alone."""
    return [name for how, name, _ in SLOT.findall(text) if how not in SIGNS]


def factors(step: Calculate) -> Iterator[str]:
    """The values a sum of products is made of."""
    return (name for term in step.terms for name, _ in term.factors)


def products(program: Program, power: int) -> dict[str, tuple[str, str]]:
    """Values of a program that are one other times (1), or through (-1), a length: both by name."""
    plain = (s for s in program.steps if isinstance(s, Calculate) and len(s.terms) == 1)
    factors = ((s.makes, s.terms[0].factors) for s in plain)
    return {name: (f[0][0], f[1][0]) for name, f in factors if [p for _, p in f] == [1, power]}


def plain(name: str) -> str:
    """A value by the name it is told by."""
    return name.strip("|‖")
