"""Letters of a picture that are exchanged though its marks are the right plan's, and vectors in doubt."""

import math
from collections.abc import Sequence
from itertools import combinations

import numpy

from planes.check.grading.paper import ReadMark
from planes.check.grading.sign_faults import SignFault
from planes.check.vision.marks.handwritten import HandWord
from planes.check.vision.search.ink_cover import CROSS_MM, STEP_MM, InkCover
from planes.check.vision.search.laid_plan import LaidPlan
from planes.check.vision.search.named_marks import BESIDE_MM, names_on
from planes.check.vision.search.plan_search import Search
from planes.words.names import POLE

Found = tuple[list[ReadMark], float, tuple[str, ...], list[SignFault], list[str]]
"""Marks, the share of the ink they explain, those that but their names tell, wrong signs, and vectors in doubt."""
SURE = 0.95  # how surely such a sign was read rightly
CROSSED = 0.08  # how likely two names together are by each other's marks, at the least
RATHER = 25.0  # and how much rather than by their own
LEAST_MM = 12.0  # of a vector whose heads are told apart
TORN_MM = 3.0  # the longest gap in a vector that is drawn; of 335 on right scans and photographs it was 1.0
AT_MM, GAIN, ASIDE = 1.0, 0.5, 0.1  # how near an end a head is, how well its ink shows it, and the sine of its lean


def signs_seen(search: Search, way: LaidPlan) -> list[SignFault]:
    """Two letters each by the other's mark alone."""
    if way.variant is not None or len(way.found) < len(search.bench.marks):
        return []
    ends, words = way.ends(search.pole.z), names_on(search).words
    for one, two in combinations([n for n in ends if n != POLE], 2):
        a, b = ends[one], ends[two]
        crossed = _by(words, one, b) * _by(words, two, a)
        straight = _by(words, one, a) * _by(words, two, b)
        if abs(a - b) > 2 * BESIDE_MM and crossed > max(CROSSED, RATHER * straight):
            return [SignFault("names_exchanged", one, two, SURE)]
    return []


def in_doubt(search: Search, way: LaidPlan) -> list[str]:
    """Longer vectors of which a piece is not drawn, and those from the pole whose heads seem to be there.

    Two of 141 right pictures seemed to have such a head: too many to call it wrong.
    """
    ends = way.ends(search.pole.z)
    pairs = ((v, ends[v[0]], ends[v[1]]) for v in search.vectors if {*v} <= ends.keys())
    long = [(v, a, b) for v, a, b in pairs if abs(b - a) > LEAST_MM]
    turned = (v for v, a, b in long if v[0] == POLE and _turned(search, a, b))
    torn = (v for v, a, b in long if _gap(search.ink, a, b) > TORN_MM)
    return [search.bench.vectors[v] for v in dict.fromkeys([*turned, *torn])]


def _gap(ink: InkCover, a: complex, b: complex) -> float:
    """The longest piece of the way from a to b without ink, mm, but for what letters and the pole's print hide."""
    at = numpy.arange(STEP_MM / 2, abs(b - a), STEP_MM)
    z = (a + (b - a) / abs(b - a) * at).astype(complex)
    inked = numpy.concatenate([[-math.inf], numpy.sort(ink.far_along(a, b)), [math.inf]])
    after = numpy.searchsorted(inked, at)
    bare = numpy.minimum(at - inked[after - 1], inked[after] - at) > STEP_MM
    bare &= ~ink.on_sign(z) & ~ink.seen.ink.lettered(z) & (abs(z - ink.pole) > CROSS_MM)
    ends = numpy.flatnonzero(~numpy.concatenate([[False], bare, [False]]))
    return STEP_MM * float(numpy.diff(ends).max() - 1)


def _by(words: Sequence[HandWord], name: str, z: complex) -> float:
    """How likely a name stands by a place."""
    return max((w.likely.get(name, 0.0) for w in words if w.off(z, z) < BESIDE_MM), default=0.0)


def _turned(search: Search, a: complex, b: complex) -> bool:
    """Whether a vector seems to have its head at its start."""
    seen = ((h, x.direction(h.s) * h.sign) for x in search.seen.lines for h in x.heads if h.gain > GAIN)
    heads = [(h.z, way * abs(b - a) / (b - a)) for h, way in seen]
    along = [(z, lean.real) for z, lean in heads if abs(lean.imag) < ASIDE]
    at_end = any(abs(z - b) < 2 * AT_MM and way > 0 for z, way in along)
    return not at_end and any(abs(z - a) < AT_MM and way < 0 for z, way in along)
