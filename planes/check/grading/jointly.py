"""Misses of a drawing taken together: each less what the errors that the marks before it show make of it.

Marks share errors: a scheme drawn a little askew is seen in a force of inertia, and again in the reaction reckoned
from that force's moment. What one mark shows of such an error is expected in the next, and is no news there.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy

from planes.check.grading.handwork import LEAST_MM, Miss
from planes.drafting.steps import LayOff, Step
from planes.drafting.steps.reckoning import Calculate


def given_before(misses: Mapping[str, Miss], order: Sequence[str], limit: float) -> dict[str, Miss]:
    """Every miss with those before it known; a mark off by more than ``limit`` σ tells nothing of others."""
    names = [m for m in order if m in misses]
    if not names:
        return {}
    rows = numpy.array([part for m in names for part in (misses[m].change.real, misses[m].change.imag)])
    cov = rows @ rows.T + LEAST_MM**2 * numpy.eye(len(rows))
    off = numpy.array([part for m in names for part in (misses[m].off.real, misses[m].off.imag)])
    found = {}
    for i, name in enumerate(names):
        x, y = 2 * i, 2 * i + 1
        left = float(cov[x, x]), float(cov[x, y]), float(cov[y, y])
        found[name] = Miss(complex(off[x], off[y]), left, misses[name].change)
        if found[name].sigmas <= limit:
            for k in (x, y):
                gain = cov[k] / cov[k, k]
                off, cov = off - gain * off[k], cov - numpy.outer(gain, cov[k])
    return {m: found[m] for m in misses}


def order_of_reckoning(steps: Iterable[Step], marks: Sequence[str]) -> list[str]:
    """Marks in order of drawing, but that a force reckoned from other ones (F^t, from moments) comes after them."""
    made = {s.makes: s for s in steps}
    laid = {m: s.length for m in marks if isinstance(s := made[m], LayOff)}
    late = []
    for k, mark in enumerate(laid):
        formula = made.get(laid[mark])
        parts = {n for n, _ in formula.reads()} if isinstance(formula, Calculate) else set()
        if parts & set(list(laid.values())[k + 1 :]):
            late.append(mark)
    last = marks.index([*laid][-1]) + 1 if laid else 0
    return [*(m for m in marks[:last] if m not in late), *late, *marks[last:]]
