"""The words of false plans: the assumption, its consequence, and the place of the true plan between two of them."""

from planes.drafting.program import StepsByName
from planes.drafting.steps import Carry, Image, LayOff, Step
from planes.drafting.steps.by_leads import CrossFalse
from planes.drafting.steps.crossings import Cross
from planes.lesson.formulas import value_slot
from planes.words.names import NamesByName, name_without_plan


def false_plan_step_words(step: Step, made: StepsByName) -> tuple[str, str, NamesByName] | None:
    """The key of the sentence and of its reason, and the names in it; None for a step outside false plans."""
    if isinstance(step, Image) and isinstance(made.get(step.like[1]), Carry):
        supposed = made.get(step.image[1])
        if supposed and supposed.quantity_represented == "false":
            marks = (*step.image, step.like[0], step.of[1], step.like[1])
            names = dict(zip(("first", "second", "one", "met", "two"), map(name_without_plan, marks), strict=True))
            return "false_true", "false_true", names
    if step.quantity_represented != "false":
        return None
    if isinstance(step, LayOff) and not isinstance(made.get(step.start), Cross) and step.length.endswith("^II"):
        return "false_supposed", "false", {"mm": value_slot(step.length, "mm", step.mu)}
    if isinstance(step, CrossFalse):
        return "false_cross", "false", {}
    still = bool(step.means and step.means.of == "still")
    keys = {LayOff: "false_normal", Carry: "false_carry", Cross: "false_still" if still else "false_met"}
    key = next((key for kind, key in keys.items() if isinstance(step, kind)), None)
    return (key, key, {}) if key else None
