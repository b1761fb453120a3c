"""How far off people and computers draw: the one place that holds the errors of a hand, a pencil and CAD."""

import math

from planes.words.frozen import frozen

UNSURE = 1 / 6  # of a value: by so much nobody can tell a right number from a wrong one
ZERO = 1e-6  # beside its own error a number so small is nothing, and is judged as that
SIGMAS = 3.0


@frozen
class Skill:
    """Standard deviations of a draughtsman: a mark (each way), a reading, a carried direction.

    Beyond ``far`` tolerances a number is wrong however near a dead point it is: of 82 500 that pencils drew where a
    tolerance exceeds a sixth, 0.1 % are beyond one.
    """

    point_mm: float = 0.3
    ruler_mm: float = 0.35
    ray_deg: float = 0.35
    far: float = 1.0


HAND = Skill()
"""A pupil with pencil and set squares, whose work is checked and whose answers are asked for."""
PENCIL = Skill(0.15, 0.15, 0.15)
"""A careful draughtsman, by whom ``--pencil`` draws: half of a pupil's errors."""
RULER_MM = 0.5  # to which he reads


def cad(extent_mm: float) -> Skill:
    """Work on a computer: 0.2 % of the plan's size. A published v_H near a dead point is off by two tolerances."""
    return Skill(0.002 * extent_mm, 0.002 * extent_mm, math.degrees(0.002), 2.0)


def too_near(value: float, sigma: float) -> bool:
    """Whether a number's tolerance exceeds a sixth of it, so near a dead point is the drawing."""
    return abs(value) > ZERO * sigma and SIGMAS * sigma > UNSURE * abs(value)
