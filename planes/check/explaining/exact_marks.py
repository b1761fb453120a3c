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
from planes.geometry.plane import direction_between, intersect_lines
from planes.words.names import POLE_LABEL

MARK_SEARCH_RADIUS_MM = 1.2  # from the settled mark
COINCIDENT_ENDS_MM = 0.15  # between ends that coincide
# of a line drawn to a mark: radians, mm at its end, mm aside
MOST_LINE_TURN_RAD = 0.04
LINE_END_WOBBLE_MM = 0.5
MOST_LINE_OFFSET_MM = 0.8
DISTANCE_PER_EXTRA_LINE_MM = 0.4  # extra distance allowed to an end for each additional line that ends there
CIRCLE_VOTES = 3  # a circle counts for this many lines
LEAST_CROSSING_SINE = 0.1  # sine of the angle between crossing lines


def exact_marks(seen: Explanation, ink: LineInk, laid: Laid) -> dict[str, ReadMark]:
    """The marks of a settled drawing, each where its lines end; otherwise at their crossing or at a circle."""
    plan = seen.plan
    marks = dict[str, ReadMark]()
    places = plan.row(laid.places) + seen.pole
    for n in (POLE_LABEL, *plan.labels):
        m = plan.names.index(n)
        own = ink.lines[_lines_reaching_mark(seen, ink, places, m)]
        ends = [*own.ravel()[abs(own.ravel() - places[m]) < MARK_SEARCH_RADIUS_MM]]
        if plan.kind == "position":
            ends += CIRCLE_VOTES * [*ink.rounds[abs(ink.rounds - places[m]) < MARK_SEARCH_RADIUS_MM]]
        if not ends or not (ink.headed or plan.kind == "position"):
            ends += [z for z in _crossings(own) if abs(z - places[m]) < MARK_SEARCH_RADIUS_MM]
        if ends:
            every = numpy.array(ends)
            votes = (abs(every[:, None] - every) < COINCIDENT_ENDS_MM).sum(axis=1) - abs(
                every - places[m]
            ) / DISTANCE_PER_EXTRA_LINE_MM
            one = every[abs(every - every[votes.argmax()]) < COINCIDENT_ENDS_MM]
            error = math.hypot(ink.sketch.error_mm, float(abs(one - one.mean()).max()))
            marks[n] = ReadMark(n, seen.undo_transformation(complex(one.mean())), error)
    return marks


def _lines_reaching_mark(seen: Explanation, ink: LineInk, places: Complexes, m: int) -> Booleans:
    """Which lines run along the plan's lines at a mark and reach it."""
    plan = seen.plan
    z = places[m]
    mine = numpy.zeros(len(ink.lines), bool)
    local = (z - ink.lines[:, 0]) * ink.u.conj()
    length = abs(ink.lines[:, 1] - ink.lines[:, 0])
    reached = (
        (abs(local.imag) < MOST_LINE_OFFSET_MM)
        & (local.real > -MARK_SEARCH_RADIUS_MM)
        & (local.real < length + MARK_SEARCH_RADIUS_MM)
    )
    for k in numpy.flatnonzero((plan.starts == m) | (plan.ends == m)).tolist():
        v = places[plan.ends[k]] - places[plan.starts[k]]
        if abs(v) > w.SHORTEST_LINE_MM:
            mine |= reached & (
                abs((ink.u * (v / abs(v)).conjugate()).imag) < MOST_LINE_TURN_RAD + LINE_END_WOBBLE_MM / abs(v)
            )
    return mine


def _crossings(every: Complexes) -> Iterator[complex]:
    """The crossings of lines, extended if needed."""
    for (a, b), (c, d) in combinations(every.tolist(), 2):
        place, turn, _ = intersect_lines(a, direction_between(a, b), c, direction_between(c, d))
        if abs(turn) > LEAST_CROSSING_SINE:
            yield complex(place)
