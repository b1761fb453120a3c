"""Marks at the intersections of their lines: each line fitted to its ink, each mark to its lines (least squares)."""

import numpy

from planes.check.evidence.sheet_ink import SheetInk
from planes.check.explaining import weights as w
from planes.check.explaining.plan_lines import PlanLines, lines_to_look_for
from planes.geometry.arrays import Complexes
from planes.words.names import NumbersByName


def fitted_marks(plan: PlanLines, ink: SheetInk, pole: complex, places: Complexes, own_mm: NumbersByName) -> Complexes:
    """The positions of the marks (in the order of the plan's names, mm from the pole), moved to where their lines meet.

    Along a line that no other line crosses they stay, with the uncertainty ``own_mm``.
    """
    a, b = (z[0] + pole for z in plan.line_ends(places[None]))
    weight = numpy.array([1 / max(own_mm.get(n, 1.0), w.READING_SIGMA_MM) ** 2 for n in plan.names])
    rows = weight[:, None, None] * numpy.eye(2)  # normal matrix of each mark
    right = numpy.zeros((len(plan.names), 2))  # right-hand side: displacements
    for k in numpy.flatnonzero(lines_to_look_for(a[None], b[None])[0]).tolist():
        length = abs(b[k] - a[k])
        u = (b[k] - a[k]) / length
        q = (ink.points - a[k]) * u.conjugate()
        near = (
            (abs(q.imag) < w.FITTED_INK_OFFSET_MM)
            & (q.real > w.UNFITTED_LINE_END_MM)
            & (q.real < length - w.UNFITTED_LINE_END_MM)
        )
        near &= abs((ink.ways * u.conjugate()).imag) < w.SIMILAR_DIRECTIONS_RAD / 2
        if near.sum() < w.LEAST_FITTED_POINTS or numpy.ptp(q.real[near]) < length / 2:
            continue
        slope, offset = numpy.polyfit(q.real[near], q.imag[near], 1)
        normal = numpy.array([-u.imag, u.real])
        sure = near.sum() / w.INK_POINT_SIGMA_MM**2
        for name, along in ((plan.starts[k], 0.0), (plan.ends[k], length)):
            rows[name] += sure * numpy.outer(normal, normal)
            right[name] += sure * (offset + slope * along) * normal
    moved = numpy.linalg.solve(rows, right[..., None])[..., 0] @ [1, 1j]
    return places + numpy.where(abs(moved) < w.FITTED_INK_OFFSET_MM * 2, moved, 0j)
