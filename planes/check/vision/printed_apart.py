"""Vectors as they are printed beside each other: which of them are one, and what runs along them."""

from collections.abc import Iterable, Sequence

from planes.check.reading.strokes import Stroke
from planes.check.vision.printed_heads import DOUBTFUL, THICK, PrintedHead

ALONG_MM = 1.0  # how far a head may be from where it belongs
PLAIN_MM = 9.0  # shorter vectors may be others' heads, or letters, and do not tell where the pole is
LONG_MM = 20.0  # a longer vector is no part of another's line
APART_MM = 0.5  # heads no nearer than this are two
HIDING_MM = THICK.long  # how near other vectors' ends are that may hide a head


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


def untold(vectors: Iterable[Stroke], told: Sequence[Stroke], heads: Sequence[PrintedHead]) -> list[Stroke]:
    """Of vectors those whose head is clear, that end where none of the told ones ends, and do not run along one."""
    clear = [head.tip for head in heads if head.clear >= DOUBTFUL]

    def new(vector: Stroke) -> bool:
        return all(abs(vector[1] - t[1]) > ALONG_MM and not along(t, vector) for t in told)

    surely = [v for v in vectors if abs(v[1] - v[0]) > LONG_MM and any(abs(v[1] - z) < ALONG_MM for z in clear)]
    return [v for v in surely if told and new(v)]
