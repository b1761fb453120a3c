"""Vectors as they are printed beside each other: from where they begin, which are one, what runs along them."""

from collections.abc import Iterable, Sequence

import numpy

from planes.check.reading.strokes import Stroke
from planes.check.vision.printed_heads import DOUBTFUL, THICK, TURNED, PrintedHead

ASIDE_MM = 7.0  # how far aside a force may be drawn
ALONG_MM = 1.0  # how far a head may be from where it belongs
PLAIN_MM = 9.0  # shorter vectors may be others' heads, or letters, and do not tell where the pole is
LONG_MM = 20.0  # a longer vector is no part of another's line
APART_MM = 0.5  # heads no nearer than this are two
TRIED = 4  # poles
MET = 0.7  # the least share of the long vectors of a wrong plan that must meet a head
HIDING_MM = THICK.long  # how near other vectors' ends are that may hide a head


def poles_of(heads: Sequence[PrintedHead], vectors: Iterable[Stroke], aside: float, wrong: bool) -> list[complex]:
    """Poles from which most of the vectors would meet heads, the likeliest first; of a wrong plan, nearly all."""
    long = [(b, (b - a) / abs(b - a)) for a, b in vectors if abs(b - a) > PLAIN_MM]
    tips, ways = (numpy.array([getattr(h, k) for h in heads], complex) for k in ("tip", "way"))
    points = [(ways / way).real > TURNED for _, way in long]
    poles = numpy.array([z for (b, _), on in zip(long, points, strict=True) for z in tips[on] - b], complex)
    worth, met = numpy.zeros(len(poles)), numpy.zeros(len(poles))
    for (b, way), on in zip(long, points, strict=True):
        local = (tips[on][None, :] - poles[:, None] - b) / way
        near = (abs(local.real) < ALONG_MM) & (abs(local.imag) < aside)
        met += near.any(axis=1)
        off = abs(local.real) / (2 * ALONG_MM) + abs(local.imag) / (4 * ASIDE_MM)
        worth += numpy.where(near, 1 - off, 0.0).max(axis=1, initial=0.0)
    found: list[complex] = []
    for k in numpy.argsort(-worth, kind="stable"):
        few = wrong and met[k] < MET * len(long)
        if not few and len(found) < TRIED and all(abs(poles[k] - f) > APART_MM for f in found):
            found.append(complex(poles[k]))
    return found


def of_lines(tips: Iterable[complex], end: complex, way: complex) -> list[complex]:
    """Of tips on one line the nearest to where its vector should end."""
    found: list[complex] = []
    for tip in sorted(tips, key=lambda z: abs(z - end)):
        found += [tip] if all(abs(((tip - other) / way).imag) > APART_MM for other in found) else []
    return found


def along(line: Stroke, vector: Stroke) -> bool:
    """Whether a line runs along a vector: it is no line to a name."""
    a, way = line[0], (line[1] - line[0]) / abs(line[1] - line[0])
    return all(abs(((z - a) / way).imag) < APART_MM for z in vector)


def apart(one: Stroke, other: Stroke) -> bool:
    """Whether two vectors are not one and the same."""
    return abs(one[1] - other[1]) > APART_MM or abs(one[0] - other[0]) > ALONG_MM


def hides(z: complex, other: Stroke) -> bool:
    """Whether a head at a place may be within the ink of another vector: at its end, or on its shaft."""
    a, b = other
    share = min(max(((z - a) / (b - a)).real, 0.0), 1.0) if a != b else 0.0
    return abs(z - b) < HIDING_MM or abs(z - a - share * (b - a)) < THICK.wide


def past_end(end: complex, way: complex, heads: Sequence[PrintedHead], tips: Sequence[complex]) -> list[complex]:
    """Tips of heads past the end of a vector on its own line, but for those known."""
    off = [(h.tip, (h.tip - end) / way) for h in heads if (h.way / way).real > TURNED]
    return [
        z for z, w in off if w.real > ALONG_MM and abs(w.imag) < APART_MM and all(abs(z - t) > ALONG_MM for t in tips)
    ]


def untold(vectors: Iterable[Stroke], told: Sequence[Stroke], heads: Sequence[PrintedHead]) -> list[Stroke]:
    """Of vectors those whose head is clear, that end where none of the told ones ends, and do not run along one."""
    clear = [head.tip for head in heads if head.clear >= DOUBTFUL]

    def new(vector: Stroke) -> bool:
        return all(abs(vector[1] - t[1]) > ALONG_MM and not along(t, vector) for t in told)

    surely = [v for v in vectors if abs(v[1] - v[0]) > LONG_MM and any(abs(v[1] - z) < ALONG_MM for z in clear)]
    return [v for v in surely if told and new(v)]
