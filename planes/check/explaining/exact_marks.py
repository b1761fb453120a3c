"""Exact marks of a vector drawing: the search tells which line is which, the line ends in the file give the place."""

import math
from collections.abc import Iterator
from itertools import combinations

import numpy

from planes.check.evidence.line_ink import LineInk
from planes.check.explaining import weights as w
from planes.check.explaining.explained import Explanation
from planes.check.explaining.scorer import Laid
from planes.check.grading.paper import ReadMark
from planes.geometry.arrays import Booleans, Complexes
from planes.geometry.plane import lines, toward
from planes.words.names import POLE

NEAR_MM, JOINED_MM = 1.2, 0.15  # from the settled mark; between ends that coincide
ASKEW, WOBBLE_MM, ASIDE_MM = 0.04, 0.5, 0.8  # of a line drawn to a mark: radians, mm at its end, mm aside
SPREAD_MM = 0.4  # extra distance allowed to an end for each additional line that ends there
ROUND = 3  # a circle counts for this many lines
LEAST_TURN = 0.1  # sine of the angle between crossing lines


def exact_marks(seen: Explanation, ink: LineInk, laid: Laid) -> dict[str, ReadMark]:
    """The marks of a settled drawing, each where its lines end; otherwise at their crossing or at a circle."""
    plan, marks = seen.plan, dict[str, ReadMark]()
    places = plan.row(laid.places) + seen.pole
    for n in (POLE, *plan.labels):
        m = plan.names.index(n)
        own = ink.lines[_drawn_to(seen, ink, places, m)]
        ends = [*own.ravel()[abs(own.ravel() - places[m]) < NEAR_MM]]
        if plan.kind == "position":
            ends += ROUND * [*ink.rounds[abs(ink.rounds - places[m]) < NEAR_MM]]
        if not ends or not (ink.headed or plan.kind == "position"):
            ends += [z for z in _crossings(own) if abs(z - places[m]) < NEAR_MM]
        if ends:
            every = numpy.array(ends)
            votes = (abs(every[:, None] - every) < JOINED_MM).sum(axis=1) - abs(every - places[m]) / SPREAD_MM
            one = every[abs(every - every[votes.argmax()]) < JOINED_MM]
            error = math.hypot(ink.sketch.error_mm, float(abs(one - one.mean()).max()))
            marks[n] = ReadMark(n, seen.undone(complex(one.mean())), error)
    return marks


def _drawn_to(seen: Explanation, ink: LineInk, places: Complexes, m: int) -> Booleans:
    """Which lines run along the plan's lines at a mark and reach it."""
    plan, z = seen.plan, places[m]
    mine = numpy.zeros(len(ink.lines), bool)
    local = (z - ink.lines[:, 0]) * ink.u.conj()
    length = abs(ink.lines[:, 1] - ink.lines[:, 0])
    reached = (abs(local.imag) < ASIDE_MM) & (local.real > -NEAR_MM) & (local.real < length + NEAR_MM)
    for k in numpy.flatnonzero((plan.starts == m) | (plan.ends == m)).tolist():
        v = places[plan.ends[k]] - places[plan.starts[k]]
        if abs(v) > w.SHORT_MM:
            mine |= reached & (abs((ink.u * (v / abs(v)).conjugate()).imag) < ASKEW + WOBBLE_MM / abs(v))
    return mine


def _crossings(every: Complexes) -> Iterator[complex]:
    """The crossings of lines, extended if needed."""
    for (a, b), (c, d) in combinations(every.tolist(), 2):
        place, turn, _ = lines(a, toward(a, b), c, toward(c, d))
        if abs(turn) > LEAST_TURN:
            yield complex(place)
