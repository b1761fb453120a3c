"""Evidence for the position of a mark: itself, or marks drawn from it that cannot all stay in place while it moves.

A Coriolis end may slide along its own line without moving any mark drawn from it, so these do not show that end. The
Jacobian of the steps between relates a mark to its followers: it must have full rank.
"""

from collections.abc import Collection, Iterable
from itertools import combinations

import numpy

from planes.drafting.drawing import Drawing, draw_steps
from planes.drafting.program import Program
from planes.drafting.tools import Tool
from planes.geometry.arithmetic import Arithmetic
from planes.geometry.arrays import Array
from planes.words.errors import PlanesError
from planes.words.names import Mark, MarkTuple

JACOBIAN_STEP_MM = 0.01  # step small enough for lines to stay lines
# a follower that moves by a smaller share of a mark's displacement lies within the drawing error
LEAST_FOLLOWER_SHARE = 0.25
Showing = list[MarkTuple]


def source_marks_of_elements(program: Program) -> dict[str, set[str]]:
    """Every element with the marks from which it was drawn, including itself."""
    roots: dict[str, set[str]] = {}
    for step in program.steps:
        marks = (n for n, kind in step.input_names() if kind == "mark")
        roots[step.makes] = {step.makes}.union(*(roots[n] for n in marks))
    return roots


def determining_mark_sets(truth: Drawing, mark: Mark, marks: Iterable[Mark]) -> Showing:
    """The sets of ``marks`` that determine the position of one: itself, then one or two of those drawn from it."""
    moves = _follower_jacobians(truth, mark, [m for m in marks if m != mark])
    alone = [m for m, jacobian in moves.items() if _has_full_rank(jacobian)]
    rest = [m for m in moves if m not in alone]
    pairs = (pair for pair in combinations(rest, 2) if _has_full_rank(numpy.vstack([moves[m] for m in pair])))
    return [(mark,), *((m,) for m in alone), *pairs]


def _follower_jacobians(truth: Drawing, mark: Mark, others: Collection[Mark]) -> dict[Mark, Array]:
    """For each follower the matrix of its displacement with a mark, mm per mm."""
    columns = []
    steps = truth.program.steps_to_redraw([mark])
    for way in (1.0, 1j):
        things = {**truth.things, mark: truth.things[mark] + JACOBIAN_STEP_MM * way}
        try:
            columns.append(draw_steps(steps, things, Tool(Arithmetic())))
        except PlanesError:
            return {}
    shown = [m for m in others if all(m in made for made in columns)]
    rates = {m: [(made[m] - truth.things[m]) / JACOBIAN_STEP_MM for made in columns] for m in shown}
    moves = {m: numpy.stack([numpy.real(row), numpy.imag(row)]) for m, row in rates.items()}
    return {m: jacobian for m, jacobian in moves.items() if numpy.isfinite(jacobian).all() and jacobian.any()}


def _has_full_rank(jacobian: Array) -> bool:
    """Whether every displacement of the mark moves some of these followers."""
    return bool(numpy.linalg.svd(jacobian, compute_uv=False)[-1] >= LEAST_FOLLOWER_SHARE)
