"""The rotation of a fixed hinge's base."""

import cmath
import math
from collections.abc import Sequence

from render.labels.footprints import inked_shapes
from render.paper.marks import Line, Mark
from render.paper.symbols import fixed_hinge, unit_vector


def base_angle(z: complex, ways: Sequence[complex], marks: Sequence[Mark]) -> float:
    """The angle of a fixed hinge's base that keeps clear of the hinge's bars, in the directions ``ways``, and then of
    other marks: upright if possible."""
    bars = inked_shapes(marks)

    def hits(turn: int) -> tuple[int, int]:
        leg = -1j * unit_vector(turn)
        room = min((math.degrees(abs(cmath.phase(w / leg))) for w in ways), default=180.0)
        own = 3 if room < 25 else 1 if room < 50 else 0
        feet = [m for m in fixed_hinge(z, turn) if isinstance(m, Line)]
        return own, len(set(bars.pairs_within(inked_shapes(feet).shapes, 0.5)[1])) if len(bars.shapes) else 0

    return float(min((0, 90, 270, 180), key=lambda turn: (sum(hits(turn)), hits(turn))))
