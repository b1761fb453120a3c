"""Moment equations with their numbers: ΣM about a point, every product force × arm over what it comes to."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

from planes.drafting.draft import Moments
from planes.drafting.steps.reckoning import Calculate, Drop, Product
from planes.solving import Position
from planes.words import say
from planes.words.lettering import Naming, flat
from render.paper.letters import number
from render.paper.marks import Mark
from render.views.formulas import Setter, Word

NOISE = 1e-9  # of the largest moment of the equation: nothing


@dataclass(frozen=True)
class MomentLines:
    """The moment equations of a position, set one beneath the other."""

    position: Position
    naming: Naming
    letter: float = 5.0

    def drawn(self, links: tuple[str, ...] | None = None) -> tuple[Mark, ...]:
        """All equations (those of some links) that say anything, from the top down."""
        setter, y = Setter(self.letter), 0.0
        for equation in self.position.plans.moments:
            wanted = equation.links != ("lever",) if links is None else set(equation.links) <= set(links)
            words = self.words(equation) if wanted else []
            if words:
                y = setter.row(words, y) - 1.9 * self.letter
        return tuple(setter.marks)

    def words(self, equation: Moments) -> list[Word]:
        """ΣM_C: F^t l = ± G h ± … with the value of every product beneath."""
        step = self.position.drawing.program
        made = next((s for s in step.steps if s.makes == equation.unknown), None)
        if not isinstance(made, Calculate) or not made.terms:
            return []
        values = [self.value(term) for term in made.terms]
        biggest = max(map(abs, values))
        shown = [(n, a, v) for (n, a), v in zip(equation.terms, values, strict=False) if abs(v) > NOISE * biggest]
        if not shown:
            return []
        about = flat(self.naming.point(equation.about))
        links = ",".join(self.naming.link(x) for x in equation.links if x != "lever")
        factor = self.common(equation, made)
        by = float(self.position.drawing[factor]) if factor else 1.0
        found = float(self.position.drawing[equation.unknown])
        head = self.unknown(equation) + (self.naming.vector(factor) if factor else "")
        unit = say(self.unit(factor != equation.arm), self.naming.lang)
        words = [Word(f"ΣM_{{{about}}}" + (f"^{{({links})}}:" if links else ":"), vector=False, value=unit)]
        words.append(Word(head, vector=False, value=self.number(found * by)))
        for k, (name, lever, value) in enumerate(shown):
            sign = ("= −" if value * by < 0 else "=") if k == 0 else "−" if value * by < 0 else "+"
            words.append(Word(sign, vector=False))
            words.append(Word(self.product(name, lever), vector=False, value=self.number(abs(value * by))))
        if not equation.arm:
            return words
        result = f";  {self.unknown(equation)} = {self.number(found)} {say('N', self.naming.lang)}"
        return [*words, Word(result, vector=False)]

    def unit(self, of_power: bool) -> str:
        """The unit of every product: of the lever's that of power, or what is left of it where the rates are of a
        unit drive."""
        plans = self.position.plans
        if not of_power or (plans.at_rest and plans.mechanism.drive.kind == "phi"):
            return "N·m"
        return "N" if plans.at_rest else "W"

    def common(self, equation: Moments, made: Calculate) -> str:
        """What every product is divided by: the unknown's arm, or on the lever the driver's rate; "" for nothing."""
        return next((name for name, power in made.terms[0].factors if power < 0), "")

    def unknown(self, equation: Moments) -> str:
        """The letter of what the equation is solved for."""
        drive = self.position.plans.mechanism.drive
        if equation.unknown in (self.position.plans.balancing, self.position.plans.zhukovsky):
            return self.naming.balancing(drive.kind == "phi")
        return self.naming.vector(equation.unknown)

    def product(self, name: str, lever: str) -> str:
        """A force times its arm, a couple, either times its rate."""
        text = self.naming.vector(name)
        if lever in self.arms:
            return text + self.naming.arm(name, lever)
        return text + (self.naming.vector(lever) if lever else "")

    @cached_property
    def arms(self) -> frozenset[str]:
        """The names of all arms."""
        return frozenset(step.makes for step in self.position.drawing.program.steps if isinstance(step, Drop))

    def value(self, term: Product) -> float:
        """One product of the sum."""
        powers = (float(self.position.drawing[name]) ** power for name, power in term.factors)
        return math.prod(powers, start=term.coefficient)

    def number(self, value: float) -> str:
        """A number of the sheet."""
        return number(value, self.naming.lang)
