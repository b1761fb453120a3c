"""Locates the unknown pole of a plan: the point from which its lines cover the most ink."""

import numpy

from planes.check.evidence.sheet_ink import SheetInk
from planes.check.explaining import weights as w
from planes.check.explaining.hypotheses import catalogue_hypotheses
from planes.check.explaining.plan_lines import Hypothesis, PlanLines, lines_to_look_for
from planes.geometry.arrays import Array, Complexes

POLE_GRID_MM = 1.5  # grid of candidates on ink
POLE_REFINEMENT_MM = 1.0  # refinement around the best of them
POLE_REFINEMENT_STEPS_MM = numpy.arange(-POLE_REFINEMENT_MM, POLE_REFINEMENT_MM + 0.1, 0.5)
CLEAR_PLAN_LINE_SHARE = 0.9  # share of its lines at which the right plan is clearly there
MOST_POLES_AT_ONCE = 2000


def likeliest_pole(
    plan: PlanLines, ink: SheetInk, cells: Complexes | None = None, price: Array | float = 0.0
) -> complex:
    """The likeliest pole of the right plan, or of a mistake's if that is not clearly there; there must be ink.

    Candidates may be given, each with its cost.
    """
    known = cells is not None
    cells = numpy.unique(numpy.round(ink.points / POLE_GRID_MM)) * POLE_GRID_MM if cells is None else cells
    best = complex(cells[0])
    most = -numpy.inf
    for h in (Hypothesis(), *catalogue_hypotheses(plan)):
        if (drawn := plan.drawn(h)) is None:
            continue
        scores, shares = _scores_from_poles(plan, ink, drawn, cells)
        scores = scores - price
        place = cells
        if not known:
            place = cells[scores.argmax()] + (POLE_REFINEMENT_STEPS_MM[:, None] + 1j * POLE_REFINEMENT_STEPS_MM).ravel()
            scores, shares = _scores_from_poles(plan, ink, drawn, place)
        k = int(scores.argmax())
        if scores[k] - h.cost > most:
            best = complex(place[k])
            most = float(scores[k]) - h.cost
        if h.is_right and shares[k] > CLEAR_PLAN_LINE_SHARE:
            break
    return best


def _scores_from_poles(plan: PlanLines, ink: SheetInk, drawn: Complexes, poles: Complexes) -> tuple[Array, Array]:
    """The score of a drawing's lines laid from each of some poles, and the share of them found.

    For a force polygon only the sides at the pole count, whatever the order.
    """
    a, b = plan.line_ends(drawn)
    seen = (lines_to_look_for(a, b) & plan.needed)[0]
    a = a[0, seen]
    b = b[0, seen]
    if plan.kind == "force":
        a, b = numpy.zeros(2 * len(a), complex), numpy.r_[b - a, a - b]
    length = abs(b - a)
    parts = numpy.array_split(poles[:, None], len(poles) // MOST_POLES_AT_ONCE + 1)
    shares = numpy.concatenate([ink.drawn_shares(a + p, b + p, w.COARSE_SAMPLES_PER_LINE, 2) for p in parts])
    if plan.kind == "force":
        best, surest = (z.reshape(len(poles), 2, -1).max(axis=2) for z in (shares * length, shares))
        return best.sum(axis=1), surest.min(axis=1)  # of the sides from the pole, and of those back to it
    value = length * (w.DRAWN_LINE_GAIN_PER_MM * shares - w.MISSING_LINE_COST_PER_MM * (1 - shares))
    signs = ink.point_evidence(drawn[0] + poles[:, None]) if plan.kind == "position" else numpy.zeros((len(poles), 1))
    worth = value.sum(axis=1) + w.HEAD_EVIDENCE_WEIGHT * signs.sum(axis=1)
    return worth, (shares * length).sum(axis=1) / max(float(length.sum()), 1e-6)
