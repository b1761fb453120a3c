"""One plan of a program, and the elements that a mistake in it may confuse."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

from planes.check.grading.variants import Steps, Variant
from planes.drafting.program import Program
from planes.drafting.steps import LayOff, Step, Turn
from planes.drafting.steps.crossings import Cross
from planes.drafting.steps.reckoning import Calculate, Product
from planes.plans import Plans
from planes.words import Told
from planes.words.names import PlanId, guide_of

Words = Mapping[str, Told]  # names for the sentence about a mistake


@dataclass
class PlanSteps:
    """One plan of a program, and the elements that a mistake in it may confuse."""

    plans: Plans
    program: Program
    plan: PlanId

    def __post_init__(self) -> None:
        self.given = self.plans.given
        self.steps = self.program.steps_by_result
        self.order = {s.makes: i for i, s in enumerate(self.program.steps)}
        self.pole = self.plan.pole
        self.own = self.program.mark_steps_on(self.plan)

    def steps_using(self, name: str) -> list[Step]:
        """The steps that use an element."""
        return self.program.steps_by_name_read.get(name, [])

    def is_made_before(self, name: str, step: Step) -> bool:
        """Whether an element exists when the step is drawn."""
        return name in self.order and self.order[name] < self.order[step.makes]

    def length_formula(self, step: LayOff) -> Calculate | None:
        """The computation of the length that a step lays off, if any."""
        maker = self.steps.get(step.length)
        return maker if isinstance(maker, Calculate) else None

    def base_of_perpendicular(self, direction: str) -> str | None:
        """The direction to which this one is perpendicular, if any."""
        step = self.steps.get(direction)
        if isinstance(step, Turn) and step.quarter == 1 and not step.angle:
            return step.of
        return None

    def perpendiculars(self) -> list[str]:
        """Perpendiculars to links among the program's directions."""
        return [d for d in self.steps if (line := self.base_of_perpendicular(d)) and guide_of(line) is None]

    def scaled_length_steps(self, step: LayOff, factor: float = -1.0) -> Steps:
        """The same length laid off times a number (backwards, double, half)."""
        name = f"{step.makes} ×{factor:g}"
        return Calculate(name, (Product(factor, ((step.length, 1),)),)), replace(step, length=name)

    def perpendicular_step(self, line_name: str, name: str) -> Turn:
        """A perpendicular with another name."""
        return Turn(name, line_name, 1, means=replace(self.plans.means[line_name], quantity="across"))

    def variant_at_step(
        self, mistake: str, step: Step, *swap: Step, weight: float = 1.0, about: Words | None = None
    ) -> Variant:
        """A mistake made at one step."""
        label = step.label
        return Variant(mistake, label, {step.makes: swap}, {}, weight, {"mark": label, **(about or {})})


def with_other_direction(step: Cross, side: str, direction: str) -> Cross:
    """An intersection of two lines, one of them in another direction."""
    if side == "along":
        return replace(step, along=direction)
    return replace(step, across=direction)
