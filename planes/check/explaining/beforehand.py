"""Decisions before the search: how a plan's lines are detected, the print scale, the order of a polygon's sides."""

import math

import numpy

from planes.check.evidence.handwritten import HandWords
from planes.check.evidence.sheet_ink import SheetInk
from planes.check.explaining import weights as w
from planes.check.explaining.hypotheses import catalogue
from planes.check.explaining.plan_lines import Hypothesis, PlanLines, to_be_seen
from planes.geometry.arrays import Array, Complexes
from planes.words.frozen import replace

LOST = -1e9


def covered(
    plan: PlanLines, ink: SheetInk, pole: complex, a: Complexes, b: Complexes, about: int, gain: float = w.GAINED
) -> tuple[Array, Array]:
    """The score of the lines of each row (on the sheet), drawn or not, felt ``about`` pixels around, and a share.

    The share is that of the needed lines found; the score is :data:`LOST` where some are off the sheet.
    """
    seen = to_be_seen(a, b)
    length = numpy.where(seen, abs(b - a), 0.0)
    ends = numpy.where(seen, a, 0j), numpy.where(seen, b, 1 + 0j)
    share = ink.along(*ends, w.COARSE if about > 1 else w.FINE, about)
    value = length * (gain * share - w.MISSING * (1 - share))
    score = numpy.where(plan.needed, value, numpy.maximum(value, 0.0)).sum(axis=1)
    need = numpy.where(plan.needed, length, 0.0)
    there = numpy.isfinite(b).all(axis=1) & (abs(numpy.nan_to_num(b) - pole) < max(w.FAR_MM, ink.reach_mm)).all(axis=1)
    cover = (need * share).sum(axis=1) / numpy.maximum(need.sum(axis=1), 1e-6)
    return numpy.where(there, score, LOST), cover


def omitted(plan: PlanLines, ink: SheetInk, a: Complexes, b: Complexes) -> float:
    """The log odds that some lines were never drawn, against their ink being lost."""
    seen = to_be_seen(a[None], b[None])[0] & plan.needed
    share = ink.along(numpy.where(seen, a, 0j), numpy.where(seen, b, 1 + 0j), w.FINE)
    gain = numpy.where(seen, w.MISSING * abs(b - a) * (1 - share) - w.OMITTED, 0.0)
    return float(numpy.maximum(gain, 0.0).sum())


def shares_of_print(plan: PlanLines, ink: SheetInk, pole: complex) -> list[tuple[float, Hypothesis]]:
    """Possible print scales of a sheet, each with its likeliest drawing: the right plan or a mistake of the catalogue.

    A given scale stands alone; otherwise full size and the likeliest others.
    """
    if plan.share != 1 or not plan.to_fit:
        return [(plan.share, Hypothesis())]
    shares, best = [1.0, *numpy.arange(*w.SHARES).tolist()], dict[float, tuple[float, Hypothesis]]()
    for h in (Hypothesis(), *catalogue(plan)):
        if (drawn := plan.draw(h, {}, 1)) is not None:
            a, b = plan.laid(numpy.concatenate([drawn / k for k in shares]))
            scores = covered(plan, ink, pole, a + pole, b + pole, 2)[0] - h.cost
            for k, score in zip(shares, scores.tolist(), strict=True):
                if score > best.get(k, (-math.inf, h))[0]:
                    best[k] = score, h
    likely = [1.0]
    for k in sorted(best, key=lambda k: -best[k][0]):
        if len(likely) <= w.PRINTS and all(abs(k - other) > w.ALIKE for other in likely):
            likely.append(k)
    return [(k, best[k][1]) for k in likely]


def orders(plan: PlanLines, ink: SheetInk, pole: complex, words: HandWords | None = None) -> list[Hypothesis]:
    """The right plan and each mistake of the catalogue, with a force polygon's sides in the order of the ink.

    The ``words`` beside the ink count too, if they were read; the likeliest comes first.
    """
    scored: list[tuple[float, Hypothesis]] = []
    for h in (Hypothesis(), *catalogue(plan)) if plan.sides else ():
        if (drawn := plan.drawn(h)) is not None:
            score, order = _likeliest_order(plan, ink, pole, drawn, words)
            usual = order == tuple(range(len(order)))
            likely = h if usual else replace(h, order=order, cost=h.cost + w.ORDER)
            scored.append((score - likely.cost, likely))
    return [h for _, h in sorted(scored, key=lambda one: -one[0])]


def _likeliest_order(
    plan: PlanLines, ink: SheetInk, pole: complex, drawn: Complexes, words: HandWords | None
) -> tuple[float, tuple[int, ...]]:
    """The score and the order of a polygon's sides, laid end to end from the pole, that finds the most ink."""
    a, b = plan.laid(drawn)
    sides = (b - a)[0, : len(plan.sides)]
    beams: list[tuple[float, tuple[int, ...], complex]] = [(0.0, (), pole)]
    for n in range(len(sides)):
        grown = [(score, order, z, k) for score, order, z in beams for k in range(len(sides)) if k not in order]
        start, step = numpy.array([z for _, _, z, _ in grown]), sides[[k for *_, k in grown]]
        share = ink.along(start, start + numpy.where(abs(step) > 0.1, step, 1), w.COARSE, 2)
        value = abs(step) * (w.GAINED * share - w.MISSING * (1 - share)) * (abs(step) > w.SHORT_MM)
        value -= w.STRAY * (numpy.array([k for *_, k in grown]) != n)
        if words:
            ends = zip(grown, (start + step).tolist(), strict=True)
            value -= w.LETTERS * numpy.array([words.price(plan.sides[k].name, z, end) for (_, _, z, k), end in ends])
        longer = zip(grown, value.tolist(), strict=True)
        beams = [(score + more, (*order, k), z + complex(sides[k])) for (score, order, z, k), more in longer]
        beams = sorted(beams, key=lambda beam: -beam[0])[: w.BEAMS]
    return beams[0][:2]
