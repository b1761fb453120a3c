"""What lies in the ink of an arrowhead: where another line ends there, its ink does not tell; its own strokes are no
lines."""

from collections.abc import Iterable, Sequence
from functools import reduce
from operator import or_

import numpy

from planes.check.vision.strokes.line_fitting import Fitted, Tip
from planes.check.vision.strokes.meeting import held
from planes.geometry.arrays import Booleans, Complexes

FRONT_MM, BEHIND_MM = 1.0, 0.8  # of a head, where its ink is no wider than a line's; how far behind it its corners are
SLOPE, RIM_MM, SIDE_MM = 0.22, 0.4, 0.6  # half of its width to its length; how far its ink, and the middle of what
# seems a line of it, reach outside of that
PLACES = 15  # of a line that are looked at

Head = tuple[Tip, complex]  # with the unit way it points


def heads_on(lines: Iterable[Fitted]) -> list[Head]:
    """The heads of some lines."""
    return [(head, head.sign * line.direction(head.s)) for line in lines for head in line.heads]


def in_head(head: Head, z: Complexes, rim: float) -> Booleans:
    """Which places lie in a head, or so near it."""
    tip, way = head
    off = (tip.z - z) * way.conjugate()
    back = off.real
    found: Booleans = (back < tip.length + BEHIND_MM) & (abs(off.imag) < SLOPE * back.clip(0) + rim)
    return found & (back > -rim)


def hides(head: Head, end: complex) -> bool:
    """Whether a line's end lies in a head, well behind its tip."""
    return abs(end - head[0].z) > FRONT_MM and bool(in_head(head, numpy.array([end]), RIM_MM)[0])


def but_strokes(lines: Sequence[Fitted]) -> list[Fitted]:
    """The lines but those of which all that is not on a line with a head is strokes of heads."""
    headed = [line for line in lines if line.heads]
    heads = heads_on(headed)
    return [line for line in lines if line.heads or not _strokes(line, headed, heads)]


def _strokes(line: Fitted, headed: Sequence[Fitted], heads: Sequence[Head]) -> bool:
    """Whether some of a line is in heads of others, and all else on their lines."""
    z = line.at(numpy.linspace(line.low, line.high, PLACES))
    inside = reduce(or_, (in_head(head, z, SIDE_MM) for head in heads), numpy.zeros(PLACES, bool))
    return bool(inside.any() and (inside | reduce(or_, (held(x, z) for x in headed))).all())
