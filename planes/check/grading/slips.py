"""Calculation slips: a number that a right drawing does not give, and the slip that does."""

from collections.abc import Iterable
from functools import partial

from planes.check.grading.figures import WrittenNumber
from planes.check.grading.handwork import Hand
from planes.drafting.steps import LayOff
from planes.drafting.steps.reckoning import Calculate, Measure
from planes.words import Phrase, Written
from planes.words.frozen import frozen
from planes.words.names import SCHEME_PLAN, letter_of
from planes.words.units import number_text
from planes.words.written_units import COMMON_INPUT_UNITS, unit_in_si

NUMBER_TOLERANCE_SHARE = 0.03  # a number within 3 % is right, however steady the hand


@frozen
class NumberSlip:
    """A slip of calculation that leaves the drawing unchanged: its message, and the number it gives (in SI)."""

    said: Phrase
    value: float


def slip_behind_number(f: WrittenNumber, true: float, sigma: float, free: Hand) -> NumberSlip | None:
    """The slip that gives a number; None if none does."""
    if not true or not f.given:
        return None
    near = min(max(NUMBER_TOLERANCE_SHARE, 3 * sigma / abs(true)), 0.25)
    if f.signed and _is_within_share(f.given, -true, near):
        return NumberSlip(Phrase("mistake_sense_wrong", mark=f.name), -true)
    for mistake, value in _possible_slips(f, true, free):
        if value and _is_within_share(abs(f.given), abs(value), near):
            return NumberSlip(Phrase(f"mistake_{mistake}", mark=f.name), abs(value))
    for unit in COMMON_INPUT_UNITS:
        size, key = unit_in_si(unit) or (1.0, "")
        if key == f.unit and _is_within_share(size * abs(f.given), abs(true), near):
            given = Written(partial(number_text, f.given))
            return NumberSlip(Phrase("mistake_unit_missing", mark=f.name, given=given, unit=Phrase(unit)), true / size)
    return None


def _is_within_share(given: float, wanted: float, share: float) -> bool:
    return abs(given - wanted) <= share * abs(wanted)


def _possible_slips(f: WrittenNumber, true: float, free: Hand) -> Iterable[tuple[str, float]]:
    """Each slip with the number it gives."""
    mu = drawing_value(free, f.plan.mu_name) if f.plan else 0.0
    if mu and not f.value:
        yield "mm_for_value", true * mu
        yield "mu_inverted", true * mu * mu
        yield "mu_inverted", true / (mu * mu)
    if letter_of(f.value) in ("omega", "epsilon"):
        scheme = drawing_value(free, SCHEME_PLAN.mu_name)
        for factor in (1 / scheme if scheme else 0.0, mu / scheme if scheme else 0.0, 1e-3):
            yield "omega_without_mu_l", true * factor
        if mu:
            yield "mu_inverted", true * mu * mu
    if letter_of(f.value) == "epsilon":
        yield "epsilon_from_total", _epsilon_from_total(f.value, free)


def drawing_value(free: Hand, name: str) -> float:
    """A value of a drawing; 0 if it has none of that name."""
    if name in free.things:
        return float(free.value_without_errors(name))
    return 0.0


def _epsilon_from_total(name: str, free: Hand) -> float:
    """ε from the total relative acceleration instead of its tangential component."""
    steps = free.program.steps_by_result
    step = steps.get(name)
    for value, power in step.terms[0].factors if isinstance(step, Calculate) else ():
        part = steps.get(value)
        normal = steps.get(part.start) if power == 1 and isinstance(part, Measure) else None
        if isinstance(part, Measure) and isinstance(normal, LayOff) and part.mu in free.things:
            total = abs(free.value_without_errors(part.end) - free.value_without_errors(normal.start)) / abs(
                drawing_value(free, part.mu)
            )
            tangential = abs(drawing_value(free, value))
            if tangential:
                return float(abs(drawing_value(free, name)) * total / tangential)
            return 0.0
    return 0.0
