"""No number is used before it is found: the missing values of a sentence, and how they are found."""

from planes.drafting.program import Program, StepsByName
from planes.drafting.steps import Step
from planes.drafting.steps.reckoning import Calculate, Drop, Measure, Product
from planes.drafting.steps.settling import Fed, Settle
from planes.lesson.formulas import signed_moment_terms, value_slot
from planes.lesson.frame import Frame
from planes.lesson.rows import Row, calculation_row
from planes.plans import Plans
from planes.plans.force.loads import names_of_loads
from planes.words.names import NamePair
from planes.words.units import Convention


class Reckoning:
    """Records which values have been shown."""

    def __init__(self, plans: Plans, made: StepsByName, convention: Convention) -> None:
        self.plans = plans
        self.made = made
        self.convention = convention
        self.told = {*plans.given, *names_of_loads(plans.mechanism), *(m.unknown for m in plans.moments)}

    def record_frame_values(self, frame: Frame) -> None:
        """Record the values of a frame."""
        self.told |= {*map(displayed_name, frame.shown_values), *(row.name for row in frame.rows)}

    def steps_of_missing_values(self, frame: Frame) -> list[Step]:
        """The steps that find the missing values of a frame, in a possible order; they count as shown from now on."""
        own = {row.name for row in frame.rows}
        steps = dict[str, Step]()
        for name in frame.shown_values:
            if displayed_name(name) not in own:
                self._add_steps_of_value(name, steps)
        return list(steps.values())

    def _add_steps_of_value(self, name: str, steps: dict[str, Step]) -> None:
        step = self.made.get(name)
        if displayed_name(name) in self.told or not isinstance(step, Calculate | Drop | Measure | Fed | Settle):
            return
        self.told.add(displayed_name(name))
        if isinstance(step, Calculate):
            for name_of_factor, _ in (f for term in step.terms for f in term.factors):
                self._add_steps_of_value(name_of_factor, steps)
        steps[name] = step

    def value_row(self, step: Step) -> Row:
        """How a value is found: by its formula, or its length on paper."""
        if isinstance(step, Calculate):
            if step.quantity_represented == "arm":
                return self.combined_arm_row(step)
            return calculation_row(step)
        if isinstance(step, Fed | Settle):
            return self.friction_couple_row(step)
        assert isinstance(step, Drop | Measure)
        value = value_slot(step.makes, "a" if isinstance(step, Drop) else "v")  # an arm has no sign
        return self.measured_length_row(displayed_name(step.makes), step.makes, step.mu, value)

    def measured_length_row(self, name: str, read: str, mu: str, value: str) -> Row:
        """A length on paper and the quantity it represents."""
        divided = f"/ {value_slot(mu, 'k')}" if self.convention == "mm_per_unit" else f"· {value_slot(mu, 'i')}"
        return Row(name, value_slot(read, "mm", mu), divided, value, "measured")

    def combined_arm_row(self, step: Calculate) -> Row:
        """The combined arm of a force and of another force that depends on it, by sense: it has no sign."""
        sums = signed_moment_terms(step, "⟨{}⟩".format, step.makes, step.makes, frozenset())
        return Row(step.makes, *sums, value_slot(step.makes, "a"), "reduced")

    def friction_couple_row(self, step: Fed | Settle) -> Row:
        """The couple of friction in a hinge: the reaction times the radius of the friction circle."""
        fed = step if isinstance(step, Fed) else next(f for f in step.fed if f.makes == step.makes)
        factor = self.made[fed.factor]
        assert isinstance(factor, Calculate)
        circle = factor.terms[0].factors[0][0]
        force = displayed_name(fed.size)
        kind, size = ("couple", value_slot(fed.size)) if isinstance(step, Fed) else ("couple_settled", f"⟨{force}⟩")
        letters = f"⟨{circle}⟩ · ⟨{force}⟩"
        numbers = f"{value_slot(circle)} · {size}"
        return Row(step.makes, letters, numbers, value_slot(step.makes), kind, f"∣⟨{step.makes}⟩∣")


def quotients_by_name(program: Program) -> dict[str, NamePair]:
    """Values of a program that are another one divided by a length: both by name."""
    parts = ((s.makes, value_and_length(s)) for s in program.steps if isinstance(s, Calculate))
    return {name: both for name, both in parts if both}


def value_and_length(step: Calculate) -> NamePair | None:
    """The value and the length, if a step divides one by the other."""
    match step.terms:
        case [Product(factors=((value, 1), (length, -1)))]:
            return value, length
    return None


def displayed_name(name: str) -> str:
    """A value by its displayed name."""
    return name.strip("|‖")
