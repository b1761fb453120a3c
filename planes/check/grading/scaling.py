"""Which scale a person drew a plan at, when it was not told: the stated one, or what the drawing's own vectors show."""

from __future__ import annotations

from collections.abc import Mapping

from planes.check.grading.handwork import Hand, Taken
from planes.check.grading.prepared_plan import PreparedPlan
from planes.drafting.steps import LayOff
from planes.words.names import POLE, at, kind_of

LEAST_MM = 5.0  # shorter vectors tell little about the scale
AGREE = 0.02  # vectors whose scales differ by less speak of one
MOST = 8


def own_scales(bench: PreparedPlan, taken: Mapping[str, Taken]) -> list[tuple[float, float]]:
    """Scales (mm per unit) worth trying with their relative errors, the stated one first.

    Then what most vectors agree on, taken from the one drawn most surely.
    """
    found = [(bench.said_mu, 0.0)]
    if bench.asked.mu:
        return found
    shown = _ratios(bench, taken)
    groups = [[pair for pair in shown if abs(pair[0] / one - 1) < AGREE + error] for one, error in shown]
    tried: list[float] = [1.0]
    for group in sorted(groups, key=lambda g: (-len(g), min(error for _, error in g))):
        ratio, error = min(group, key=lambda pair: pair[1])
        if all(abs(ratio / t - 1) > 0.01 for t in tried):
            tried.append(ratio)
            found.append((bench.said_mu * ratio, error))
    return found[:MOST]


def _ratios(bench: PreparedPlan, taken: Mapping[str, Taken]) -> list[tuple[float, float]]:
    """Drawn to true lengths, with what drafting and reading may have done to them: of the vectors of a force plan,
    of others from the pole."""
    hand = Hand(bench.program, bench.given, bench.asked.skill, {})
    steps = {s.makes: s for s in bench.program.steps}
    force, pole = kind_of(bench.asked.plan) == "force", at(bench.asked.plan, POLE)
    found = []
    for mark in bench.marks:
        step = steps[mark]
        start = step.start if force and isinstance(step, LayOff) else pole
        if mark not in taken or (start != pole and start not in taken):
            continue
        true = hand.things[mark] - (0.0 if start == pole else hand.things[start])
        own = abs(taken[mark].place - (0j if start == pole else taken[start].place))
        length = abs(hand.tool.spread(true + 0j))
        if length[0] > LEAST_MM and own > 0:
            found.append((float(own / length[0]), (hand.spread_of(length) + 2 * taken[mark].error_mm) / own))
    return found
