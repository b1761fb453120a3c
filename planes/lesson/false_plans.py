"""The words of false plans: the assumption, its consequence, and the place of the true plan between two of them."""

from collections.abc import Mapping

from planes.drafting import steps as s
from planes.drafting.steps.by_leads import CrossFalse
from planes.drafting.steps.crossings import Cross
from planes.lesson.formulas import slot
from planes.words.names import lettered


def false_words(step: s.Step, made: Mapping[str, s.Step]) -> tuple[str, str, dict[str, str]] | None:
    """The key of the sentence and of its reason, and the names in it; None for a step outside false plans."""
    if isinstance(step, s.Image) and step.image[1] in made and _supposed(made[step.image[1]]):
        carried = made.get(step.like[1])
        if isinstance(carried, s.Carry):
            first, second = (lettered(x) for x in step.image)
            one, met, two = (lettered(x) for x in (step.like[0], step.of[1], step.like[1]))
            return "false_true", "false_true", {"first": first, "second": second, "one": one, "met": met, "two": two}
    if step.quantity != "false":
        return None
    if isinstance(step, s.LayOff) and not isinstance(made.get(step.start), Cross) and step.length.endswith("^II"):
        return "false_supposed", "false", {"mm": slot(step.length, "mm", step.mu)}
    if isinstance(step, s.LayOff):
        return "false_normal", "false_normal", {}
    if isinstance(step, s.Carry):
        return "false_carry", "false_carry", {}
    if isinstance(step, CrossFalse):
        return "false_cross", "false", {}
    if isinstance(step, Cross):
        key = "false_still" if step.means and step.means.of == "still" else "false_met"
        return key, key, {}
    return None


def _supposed(step: s.Step) -> bool:
    return step.quantity == "false"
