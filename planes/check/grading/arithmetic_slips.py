"""Slips of reckoning: numbers that are wrong though the drawing is right."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

from planes.check.grading.handwork import Hand
from planes.drafting.steps import LayOff
from planes.drafting.steps.reckoning import Calculate, Measure
from planes.geometry.arithmetic import Real
from planes.plans import Plans
from planes.words.names import letter_of, mu_of

SHARE = 0.03  # a number within 3 % is right, however steady the hand
Things = Mapping[str, Real]


@dataclass(frozen=True)
class WrittenNumber:
    """One number: as written (SI or mm), and how it is read off a drawing (an array over the errors' columns)."""

    name: str
    given: float
    read: Callable[[Things], Real]
    signed: bool = False
    plan: str = ""
    value: str = ""  # the program's name of it, if it has one


@dataclass
class Scored:
    """A figure judged: true value, its standard deviation, right, wrong or follows, and a close call or not."""

    figure: WrittenNumber
    true: float
    sigma: float
    verdict: str
    close: bool = False
    mine: float | None = None  # what the person's own drawing gives
    slip: str | None = None  # the slip of reckoning that gives the number


def number_mistake(s: Scored, free: Hand, plans: Plans) -> str | None:
    """Slips of reckoning that leave the drawing as it is."""
    f, true = s.figure, s.true
    if not true or not f.given:
        return None
    if f.signed and _near(f.given, -true, s):
        return "sense_wrong"
    for mistake, value in _slips(f, true, free, plans):
        if value and _near(abs(f.given), abs(value), s):
            return mistake
    return None


def _near(given: float, wanted: float, s: Scored) -> bool:
    share = max(SHARE, 3 * s.sigma / abs(s.true))
    return abs(given - wanted) <= min(share, 0.25) * abs(wanted)


def _slips(f: WrittenNumber, true: float, free: Hand, plans: Plans) -> Iterable[tuple[str, float]]:
    """Each slip with the number it gives."""
    mu = float(free.number(mu_of(f.plan))) if f.plan and mu_of(f.plan) in free.things else 0.0
    if mu and not f.value:
        yield "mm_for_value", true * mu
        yield "mu_inverted", true * mu * mu
        yield "mu_inverted", true / (mu * mu)
    if letter_of(f.value) in ("omega", "epsilon"):
        scheme = float(free.number(mu_of("position"))) if mu_of("position") in free.things else 0.0
        for factor in (1 / scheme if scheme else 0.0, mu / scheme if scheme else 0.0, 1e-3):
            yield "omega_without_mu_l", true * factor
        if mu:
            yield "mu_inverted", true * mu * mu
    if letter_of(f.value) == "epsilon":
        yield "epsilon_from_total", _from_total(f.value, free, plans)


def _from_total(name: str, free: Hand, plans: Plans) -> float:
    """ε from the whole relative acceleration instead of its tangential part."""
    steps = {s.makes: s for s in plans.program.steps}
    step = steps.get(name)
    if not isinstance(step, Calculate):
        return 0.0
    for value, power in step.terms[0].factors:
        part = steps.get(value)
        if power == 1 and isinstance(part, Measure) and part.start in steps and part.mu in free.things:
            normal, scale = steps[part.start], abs(first_of(free.things[part.mu]))
            if not isinstance(normal, LayOff):
                return 0.0
            whole = abs(free.number(part.end) - free.number(normal.start)) / scale
            tangential = abs(first_of(free.things[value]))
            return float(abs(first_of(free.things[name])) * whole / tangential) if tangential else 0.0
    return 0.0


def first_of(value: Real) -> float:
    """A value without the columns of its errors."""
    shape = getattr(value, "shape", None)
    return float(value[0] if shape else value)
