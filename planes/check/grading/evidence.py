"""The evidence in a drawing, and the certainty of a verdict on it.

The scale, if not given, is estimated. Marks that random ones would match by chance are not judged right. The readings
are explained by a right drawing; by one mistake of the catalogue; by a mark wrong for its individual reason; or, in a
picture, by another point misread as the mark that seems wrong. Priors are shares of marks.
"""

import math
from collections.abc import Iterable, Mapping

import numpy

from planes.check.grading.handwork import Hand, Miss, Misses
from planes.check.grading.paper import TakenMarks
from planes.check.grading.prepared_plan import PreparedPlan
from planes.drafting.steps import LayOff, Same
from planes.geometry.plane import distance_to_nearest
from planes.words.names import Mark

MOST_CHANCE_OF_RANDOM_MARKS = 0.02  # acceptable probability that random marks pass: one vector of 50 mm at a free scale
MOST_CHANCE_OF_RANDOM_LENGTHS = 0.05  # the same for lengths, each of which carries half the evidence of a mark
SMALLEST_DRAWING_SIGMAS = 10.0  # a drawing smaller than this many times the error of a mark shows nothing
SHORTEST_SCALE_VECTOR_MM = 5.0  # shorter vectors tell little about the scale
EQUAL_SCALE_DIFFERENCE = 0.02  # vectors whose scales differ by less have a common scale
MOST_CANDIDATE_SCALES = 8
SLIP_PROBABILITY = 0.02  # share of marks wrong for individual reasons; prior of each mistake of the catalogue
MISREADING_SPREAD_MM = 0.7  # half of the misread points lie within 1.7 times this of the mark
MISREAD_ANYWHERE_SHARE = 0.2  # share of misread points anywhere on the drawing
LEAST_VERDICT_PROBABILITY = 0.5  # minimum probability of a verdict; a drawing called wrong must reach it
SURE_VERDICT_PROBABILITY = 0.98  # a less certain verdict is called likely
LEAST_UNASKED_PROBABILITY = 0.8  # a less certain verdict on a picture becomes a question


def marks_extent_mm(hand: Hand, marks: Iterable[Mark]) -> float:
    """The extent of the person's own marks from the pole, mm."""
    return max((abs(hand.taken[m].place) for m in marks if m in hand.taken), default=0.0)


def chance_of_random_marks(hand: Hand, misses: Misses, limit: float, free: bool, gap_mm: float | None = None) -> float:
    """The probability that random marks on a drawing of this size are as right; ``free``: the scale is free, too.

    A mark that coincides with another (or the pole) is no separate evidence; a polygon that closes within ``gap_mm``
    is as much evidence as a mark.
    """
    size = marks_extent_mm(hand, misses)
    shares = [] if gap_mm is None else [min(gap_mm / size, 1.0) ** 2]
    stand = [0j]
    for mark, miss in misses.items():
        place = hand.taken[mark].place
        reach = limit * miss.mean_sigma_mm
        if not isinstance(hand.program.steps_by_result[mark], Same) and distance_to_nearest(place, stand) > reach:
            shares.append(min(reach / size, 1.0) ** 2)
        stand.append(place)
    if not free or not shares:
        return math.prod(shares)
    surest = min(shares)  # the scale is taken from it, only its direction is left
    return math.prod(shares) / surest * min(math.sqrt(surest) / math.pi, 1.0)


def chance_of_random_lengths(shares: Iterable[float], free: bool) -> float:
    """The same for lengths, from the tolerance of each as a share of the longest."""
    chances = [min(s, 1.0) for s in shares]
    return math.prod(chances) / (min(chances) if free else 1.0)


def candidate_scales(bench: PreparedPlan, taken: TakenMarks) -> list[tuple[float, float]]:
    """Candidate scales (mm per unit) with their relative errors: the stated one first.

    Then the scale on which most vectors agree, taken from the most accurate of them.
    """
    shown = [] if bench.asked.mu else _drawn_to_true_ratios(bench, taken)
    groups = [
        [pair for pair in shown if abs(pair[0] / one - 1) < EQUAL_SCALE_DIFFERENCE + error] for one, error in shown
    ]
    scales = [(1.0, 0.0)]
    for group in sorted(groups, key=lambda g: (-len(g), min(error for _, error in g))):
        ratio, error = min(group, key=lambda pair: pair[1])
        if all(abs(ratio / other - 1) > 0.01 for other, _ in scales):
            scales.append((ratio, error))
    return [(bench.said_mu * ratio, error) for ratio, error in scales[:MOST_CANDIDATE_SCALES]]


def _drawn_to_true_ratios(bench: PreparedPlan, taken: TakenMarks) -> list[tuple[float, float]]:
    """Ratios of drawn to true lengths with their errors: of the vectors in a force plan, else from the pole."""
    hand = Hand(bench.program, bench.given, bench.asked.skill, {})
    force = bench.plan.is_force
    pole = bench.plan.pole
    ratios = []
    for mark in bench.marks:
        step = bench.program.steps_by_result[mark]
        start = step.start if force and isinstance(step, LayOff) else pole
        if mark not in taken or (start != pole and start not in taken):
            continue
        true = hand.things[mark] - (0.0 if start == pole else hand.things[start])
        own = abs(taken[mark].place - (0j if start == pole else taken[start].place))
        length = abs(hand.tool.spread_over_drawings(true + 0j))
        if length[0] > SHORTEST_SCALE_VECTOR_MM and own > 0:
            ratios.append((float(own / length[0]), (hand.sigma_of_value(length) + 2 * taken[mark].error_mm) / own))
    return ratios


def log_density_anywhere(extent_mm: float) -> float:
    """Logarithm of the density of a mark anywhere on the drawing."""
    return -2 * math.log(2 * max(extent_mm, 20.0))


def misread_log_density(off: complex, broad: float, doubt: float) -> float:
    """Logarithm of the density of a misread point: mostly near the mark, sometimes anywhere."""
    if not doubt:
        return -math.inf
    near = -math.log(2 * math.pi * MISREADING_SPREAD_MM**2) - 1.5 * math.log1p(abs(off) ** 2 / MISREADING_SPREAD_MM**2)
    return math.log(doubt) + log_sum(near, math.log(MISREAD_ANYWHERE_SHARE) + broad)


def right_mark_log_density(miss: Miss, broad: float, doubt: float) -> float:
    """Logarithm of the density of the miss of a right mark, with drawing and reading errors."""
    if not math.isfinite(miss.sigmas):
        return -math.inf
    return log_sum(miss.log_density + math.log1p(-doubt), misread_log_density(miss.off, broad, doubt))


def any_mark_log_density(miss: Miss, broad: float, doubt: float) -> float:
    """The same for any mark, including occasional slips."""
    right = right_mark_log_density(miss, broad, doubt) + math.log1p(-SLIP_PROBABILITY)
    return log_sum(right, broad + math.log(SLIP_PROBABILITY))


def log_prob_no_slips(misses: Misses, broad: float, doubts: Mapping[Mark, float]) -> float:
    """Logarithm of the probability that none of the marks slipped."""
    return sum(
        right_mark_log_density(m, broad, doubts[n])
        + math.log1p(-SLIP_PROBABILITY)
        - any_mark_log_density(m, broad, doubts[n])
        for n, m in misses.items()
    )


def chance_wrong(right: float, otherwise: float, mistakes: Iterable[float]) -> float:
    """The probability that a drawing is wrong, from the logarithms of the parts of its marks' densities.

    ``right`` is the part without slips, ``otherwise`` another reading under which it is right, ``mistakes`` one each.
    """
    named = math.log(SLIP_PROBABILITY) + log_sum(*mistakes)
    slipped = math.log(-math.expm1(right)) if right < 0 else -math.inf
    return logistic(log_sum(named, slipped) - log_sum(right, otherwise))


def chance_number_wrong(off: float, sigma: float, size: float) -> float:
    """The probability that a number of a known size is wrong, not only measured with an error σ, if it is ``off``."""
    drawn = -0.5 * (off / sigma) ** 2 - math.log(sigma * math.sqrt(2 * math.pi)) if sigma else -math.inf
    slipped = math.log(SLIP_PROBABILITY) - math.log(2 * max(size, off, sigma))
    return logistic(slipped - drawn)


def log_sum(*logarithms: float) -> float:
    """The logarithm of the sum of numbers given by their logarithms."""
    return float(numpy.logaddexp.reduce([-math.inf, *logarithms]))


def logistic(odds: float) -> float:
    """The probability from the logarithm of its odds."""
    return (1 + math.tanh(odds / 2)) / 2
