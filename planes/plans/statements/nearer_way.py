"""Which of two solutions of an equation is meant: the one with the vector directions nearer to those named."""

import cmath
import math

from planes.drafting.drawing import draw_program
from planes.drafting.program import Program
from planes.plans.position.tracks import MOST_CLEAR_DISTANCE_RATIO
from planes.plans.statements.stated_vectors import StatedVectors
from planes.scene import Scene
from planes.words import Phrase
from planes.words.errors import PlanFailure, SceneError

SAME_DIRECTION_DEG = 1e-5  # degrees: touching arcs have one direction, found twice, the root of a rounding error apart
Ways = dict[str, float]  # directions by the vectors' names, degrees


def chosen_side(scene: Scene, vectors: StatedVectors, side: str, free: list[str]) -> float:
    """±1, by ``near`` of the vectors whose direction is ``free``; :class:`SceneError` with both directions where none
    is given, or they disagree."""
    near = {n: angle for n in free if (angle := vectors.given_data(n).near_deg) is not None}
    asked = list(near) or free[:1]
    sides = [(sign, ways) for sign in (1.0, -1.0) if (ways := _directions_on_side(vectors, asked, side, sign))]
    if not sides or (
        len(sides) == 2
        and all(_angle_between_directions(sides[0][1][n], sides[1][1][n]) <= SAME_DIRECTION_DEG for n in asked)
    ):
        return 1.0
    chosen = {_side_with_nearer_direction(scene, name, angle, sides) for name, angle in near.items()}
    if len(chosen) != 1:
        raise _near_refusal(scene, "near_apart" if near else "two_directions", asked[0], sides, others=tuple(asked[1:]))
    return chosen.pop()


def _side_with_nearer_direction(scene: Scene, name: str, angle: float, sides: list[tuple[float, Ways]]) -> float:
    """The side on which a vector's direction is nearer to the one named."""
    (off, sign), *more = sorted((_angle_between_directions(ways[name], angle), sign) for sign, ways in sides)
    if more and off > MOST_CLEAR_DISTANCE_RATIO * more[0][0]:
        raise _near_refusal(scene, "near_midway", name, sides, off=off, next=more[0][0])
    return sign


def _near_refusal(scene: Scene, key: str, name: str, sides: list[tuple[float, Ways]], **details: object) -> SceneError:
    offers = tuple(Phrase("near_angle", angle=f"{ways[name]:.4g}") for _, ways in sides)
    return SceneError(Phrase(key, name=name, offers=offers, **details), scene.file, scene.where.get(("vectors", name)))


def _directions_on_side(vectors: StatedVectors, names: list[str], side: str, sign: float) -> Ways | None:
    """The directions of these vectors on one side; None where it cannot be drawn."""
    spans = {n: vectors.end_marks(n) for n in names}
    d = vectors.draft
    program = Program(tuple(d.steps.values())).cut_to_names(m for s in spans.values() for m in s)
    given = {**d.given, **{plan.mu_name: 1.0 for plan in program.mark_steps_by_plan}, side: sign}
    try:
        drawing = draw_program(program, given)
    except PlanFailure:
        return None
    return {n: math.degrees(cmath.phase(drawing[end] - drawing[start])) for n, (start, end) in spans.items()}


def _angle_between_directions(one: float, two: float) -> float:
    """The angle between two directions, degrees."""
    return abs((one - two + 180) % 360 - 180)
