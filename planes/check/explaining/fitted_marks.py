"""Marks at the intersections of their lines: each line fitted to its ink, each mark to its lines (least squares)."""

from collections.abc import Mapping

import numpy

from planes.check.evidence.sheet_ink import SheetInk
from planes.check.explaining import weights as w
from planes.check.explaining.plan_lines import PlanLines, to_be_seen
from planes.geometry.arrays import Complexes


def fitted_marks(
    plan: PlanLines, ink: SheetInk, pole: complex, places: Complexes, own_mm: Mapping[str, float]
) -> Complexes:
    """The positions of the marks (in the order of the plan's names, mm from the pole), moved to where their lines meet.

    Along a line that no other line crosses they stay, with the uncertainty ``own_mm``.
    """
    a, b = (z[0] + pole for z in plan.laid(places[None]))
    weight = numpy.array([1 / max(own_mm.get(n, 1.0), w.READ_MM) ** 2 for n in plan.names])
    rows = numpy.zeros((len(plan.names), 3))  # normal matrix of each mark: xx, xy, yy
    right = numpy.zeros(len(plan.names), complex)  # right-hand side: displacements
    rows[:, 0] = rows[:, 2] = weight
    for k in numpy.flatnonzero(to_be_seen(a[None], b[None])[0]).tolist():
        length = abs(b[k] - a[k])
        u = (b[k] - a[k]) / length
        q = (ink.points - a[k]) * u.conjugate()
        near = (abs(q.imag) < w.NEAR_MM) & (q.real > w.RIM_MM) & (q.real < length - w.RIM_MM)
        near &= abs((ink.ways * u.conjugate()).imag) < w.NARROW / 2
        if near.sum() < w.FEW or numpy.ptp(q.real[near]) < length / 2:
            continue
        slope, offset = numpy.polyfit(q.real[near], q.imag[near], 1)
        normal, sure = 1j * u, near.sum() / w.PIXEL_MM**2
        for name, along in ((plan.starts[k], 0.0), (plan.ends[k], length)):
            across = float(offset + slope * along)
            rows[name] += sure * numpy.array([normal.real**2, normal.real * normal.imag, normal.imag**2])
            right[name] += sure * across * normal
    determinant = rows[:, 0] * rows[:, 2] - rows[:, 1] ** 2
    x = (rows[:, 2] * right.real - rows[:, 1] * right.imag) / determinant
    y = (rows[:, 0] * right.imag - rows[:, 1] * right.real) / determinant
    moved = x + 1j * y
    return places + numpy.where(abs(moved) < w.NEAR_MM * 2, moved, 0j)
