"""Decisions before the search: how a plan's lines are detected, the print scale, the order of a polygon's sides."""

import math

import numpy

from planes.check.evidence.handwritten import HandWords
from planes.check.evidence.sheet_ink import SheetInk
from planes.check.explaining import weights as w
from planes.check.explaining.hypotheses import catalogue_hypotheses
from planes.check.explaining.plan_lines import Hypothesis, PlanLines, lines_to_look_for
from planes.geometry.arrays import Array, Complexes
from planes.words.frozen import replace

IMPOSSIBLE_SCORE = -1e9
Beam = tuple[float, tuple[int, ...], tuple[complex, ...]]
"""What some sides of a polygon lose, their order, and the path along them."""


def score_line_coverage(
    plan: PlanLines,
    ink: SheetInk,
    pole: complex,
    a: Complexes,
    b: Complexes,
    about: int,
    gain: float = w.DRAWN_LINE_GAIN_PER_MM,
) -> tuple[Array, Array]:
    """The score of the lines of each row (on the sheet), drawn or not, felt ``about`` pixels around, and a share.

    The share is that of the needed lines found; the score is :data:`LOST` where some are off the sheet.
    """
    seen = lines_to_look_for(a, b)
    length = numpy.where(seen, abs(b - a), 0.0)
    ends = numpy.where(seen, a, 0j), numpy.where(seen, b, 1 + 0j)
    share = ink.drawn_shares(*ends, w.COARSE_SAMPLES_PER_LINE if about > 1 else w.FINE_SAMPLES_PER_LINE, about)
    value = length * (gain * share - w.MISSING_LINE_COST_PER_MM * (1 - share))
    score = numpy.where(plan.needed, value, numpy.maximum(value, 0.0)).sum(axis=1)
    need = numpy.where(plan.needed, length, 0.0)
    there = numpy.isfinite(b).all(axis=1) & (
        abs(numpy.nan_to_num(b) - pole) < max(w.MOST_MARK_DISTANCE_MM, ink.reach_mm)
    ).all(axis=1)
    cover = (need * share).sum(axis=1) / numpy.maximum(need.sum(axis=1), 1e-6)
    return numpy.where(there, score, IMPOSSIBLE_SCORE), cover


def omitted_lines_log_odds(plan: PlanLines, ink: SheetInk, a: Complexes, b: Complexes) -> float:
    """The log odds that some lines were never drawn, against their ink being lost."""
    seen = lines_to_look_for(a[None], b[None])[0] & plan.needed
    share = ink.drawn_shares(numpy.where(seen, a, 0j), numpy.where(seen, b, 1 + 0j), w.FINE_SAMPLES_PER_LINE)
    gain = numpy.where(seen, w.MISSING_LINE_COST_PER_MM * abs(b - a) * (1 - share) - w.OMITTED_LINE_COST, 0.0)
    return float(numpy.maximum(gain, 0.0).sum())


def candidate_print_scales(plan: PlanLines, ink: SheetInk, pole: complex) -> list[tuple[float, Hypothesis]]:
    """Possible print scales of a sheet, each with its likeliest drawing: the right plan or a mistake of the catalogue.

    A given scale stands alone; otherwise full size and the likeliest others.
    """
    if plan.share != 1 or not plan.to_fit:
        return [(plan.share, Hypothesis())]
    shares = [1.0, *numpy.arange(*w.PRINT_SCALE_RANGE).tolist()]
    best = dict[float, tuple[float, Hypothesis]]()
    for h in (Hypothesis(), *catalogue_hypotheses(plan)):
        if (drawn := plan.mark_positions(h, {}, 1)) is not None:
            a, b = plan.line_ends(numpy.concatenate([drawn / k for k in shares]))
            scores = score_line_coverage(plan, ink, pole, a + pole, b + pole, 2)[0] - h.cost
            for k, score in zip(shares, scores.tolist(), strict=True):
                if score > best.get(k, (-math.inf, h))[0]:
                    best[k] = score, h
    likely = [1.0]
    for k in sorted(best, key=lambda k: -best[k][0]):
        if len(likely) <= w.MOST_OTHER_PRINT_SCALES and all(
            abs(k - other) > w.EQUAL_PRINT_SCALE_DIFFERENCE for other in likely
        ):
            likely.append(k)
    return [(k, best[k][1]) for k in likely]


def side_order_hypotheses(
    plan: PlanLines, ink: SheetInk, pole: complex, words: HandWords | None = None
) -> list[Hypothesis]:
    """The right plan and each mistake of the catalogue, with a force polygon's sides in the order of the ink.

    The ``words`` beside the ink count too, if they were read; the likeliest comes first.
    """
    scored: list[tuple[float, Hypothesis]] = []
    for h in (Hypothesis(), *catalogue_hypotheses(plan)) if plan.sides else ():
        if (drawn := plan.drawn(h)) is not None:
            score, order = _likeliest_order(plan, ink, pole, drawn, words)
            usual = order == tuple(range(len(order)))
            likely = h if usual else replace(h, order=order, cost=h.cost + w.OTHER_ORDER_COST)
            scored.append((score - likely.cost, likely))
    return [h for _, h in sorted(scored, key=lambda one: -one[0])]


def _likeliest_order(
    plan: PlanLines, ink: SheetInk, pole: complex, drawn: Complexes, words: HandWords | None
) -> tuple[float, tuple[int, ...]]:
    """The score and the order of a polygon's sides, laid end to end from the pole, that loses least ink: the better of
    two searches, one of sides drawn by hand and one of sides exactly in their places."""
    a, b = plan.line_ends(drawn)
    sides = (b - a)[0, : len(plan.sides)]
    beams = [_best_beam(plan, ink, pole, sides, words, by_hand) for by_hand in (True, False)]
    loss, order, _ = max(beams, key=lambda beam: beam[0])
    return w.DRAWN_LINE_GAIN_PER_MM * float(abs(sides).sum()) + loss, order


def _best_beam(
    plan: PlanLines, ink: SheetInk, pole: complex, sides: Complexes, words: HandWords | None, by_hand: bool
) -> Beam:
    """The best order found by one search. A side laid ``by_hand`` may end a little beside its place, where the next
    begins; such beams are ranked by what they lose, so that long sides do not drive out short ones. Beams of exact
    sides are ranked by what they gain, long sides first: a beginning that must miss one is dropped early."""
    gain = 0.0 if by_hand else w.DRAWN_LINE_GAIN_PER_MM
    beams: list[Beam] = [(0.0, (), (pole,))]
    for n in range(len(sides)):
        grown = [(score, order, path, k) for score, order, path in beams for k in range(len(sides)) if k not in order]
        paths = numpy.array([path for _, _, path, _ in grown])
        step = sides[[k for *_, k in grown]]
        value, ends = _side_losses(ink, paths, step, by_hand)
        value -= w.SIDE_OUT_OF_TURN_COST * (numpy.array([k for *_, k in grown]) != n)
        if words:
            value -= w.MISPLACED_NAME_WEIGHT * numpy.array(
                [
                    words.vector_name_cost(plan.sides[k].name, path[-1], end)
                    for (_, _, path, k), end in zip(grown, ends.tolist(), strict=True)
                ]
            )
        longer = zip(grown, value.tolist(), ends.tolist(), strict=True)
        beams = [(score + more, (*order, k), (*path, end)) for (score, order, path, k), more, end in longer]
        beams.sort(key=lambda beam: -beam[0] - gain * abs(sides[[*beam[1]]]).sum())
        beams = beams[: w.ORDER_BEAM_WIDTH]
    return beams[0]


def _side_losses(ink: SheetInk, paths: Complexes, sides: Complexes, by_hand: bool) -> tuple[Array, Complexes]:
    """What each next side loses of its score, and its end: where it was most likely drawn, if ``by_hand``."""
    moves = (
        w.SIDE_END_MOVE_MM * numpy.r_[0, numpy.exp(0.25j * math.pi * numpy.arange(8))]
        if by_hand
        else numpy.zeros(1, complex)
    )
    start = paths[:, -1:] + 0 * moves
    step = numpy.where(abs(sides) > 0.1, sides, 1)[:, None]
    share = ink.drawn_shares(start, start + step + moves, w.COARSE_SAMPLES_PER_LINE, 2)
    values = -abs(step) * (w.DRAWN_LINE_GAIN_PER_MM + w.MISSING_LINE_COST_PER_MM) * (1 - share)
    values = values - w.DRAWING_ERROR_WEIGHT * abs(moves / w.DRAWING_SIGMA_MM) ** 2
    best = values.argmax(axis=1)
    rows = numpy.arange(len(paths))
    ends = (start + step + moves)[rows, best]
    value = values[rows, best]
    if by_hand:
        value = value - w.OVERLAP_COST_PER_MM * _length_over_others(paths, ends)
    return value * (abs(step[:, 0]) > w.SHORTEST_LINE_MM), ends


def _length_over_others(paths: Complexes, ends: Complexes) -> Array:
    """The length of a next side, from the end of each path to its end, that lies over the sides of the path."""
    last = paths[:, -1:]
    length = abs(ends[:, None] - last)
    way = (ends[:, None] - last) / numpy.maximum(length, 1e-9)
    corners = (paths - last) * way.conjugate()
    low, high = (f(corners[:, :-1].real, corners[:, 1:].real) for f in (numpy.minimum, numpy.maximum))
    aside = numpy.maximum(abs(corners[:, :-1].imag), abs(corners[:, 1:].imag))
    shared = numpy.clip(numpy.minimum(high, length) - numpy.maximum(low, 0), 0, None) * (aside < w.SIDE_END_MOVE_MM)
    over: Array = numpy.minimum(shared.sum(axis=1), length[:, 0])
    return over
