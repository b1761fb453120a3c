"""Errors of people and computers in drawing: the only place with the errors of a hand, a pencil and CAD."""

import math

from planes.words.frozen import frozen

MOST_SURE_TOLERANCE_RATIO = 1 / 6  # of a value: a difference this small cannot tell right from wrong
ZERO_TO_ERROR_RATIO = 1e-6  # relative to its own error: a number this small is zero, and is judged as zero
TOLERANCE_SIGMAS = 3.0


@frozen
class Skill:
    """Standard deviations of a draughtsman: a mark (each way), a reading, a carried direction.

    Beyond ``far`` tolerances a number is wrong even near a dead point: of 82 500 numbers drawn by pencils where a
    tolerance exceeds a sixth, 0.1 % are beyond one.
    """

    point_mm: float = 0.3
    ruler_mm: float = 0.35
    ray_deg: float = 0.35
    far: float = 1.0


STUDENT_SKILL = Skill()
"""A student with pencil and set squares, whose work is checked and whose answers are graded."""
DRAUGHTSMAN_SKILL = Skill(0.15, 0.15, 0.15)
"""A careful draughtsman, used for ``--pencil``: half of a student's errors."""
RULER_RESOLUTION_MM = 0.5  # resolution of his readings


def cad_skill(extent_mm: float) -> Skill:
    """Work on a computer: 0.2 % of the plan's size. A published v_H near a dead point is off by two tolerances."""
    return Skill(0.002 * extent_mm, 0.002 * extent_mm, math.degrees(0.002), 2.0)


def is_near_dead_point(value: float, sigma: float) -> bool:
    """Whether a number's tolerance exceeds a sixth of it: the drawing is that near a dead point."""
    return abs(value) > ZERO_TO_ERROR_RATIO * sigma and TOLERANCE_SIGMAS * sigma > MOST_SURE_TOLERANCE_RATIO * abs(
        value
    )
