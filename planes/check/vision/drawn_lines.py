"""Which lines there are in a sheet's ink: lines that run close beside each other, and short ones, told apart."""

from __future__ import annotations

import statistics
from collections.abc import Iterable, Iterator, Sequence

import numpy

from planes.check.vision.arrow_tips import find_heads
from planes.check.vision.ink import DARK, Ink
from planes.check.vision.line_fitting import Fitted, fitted
from planes.check.vision.residual_ink import MOST_MM, left_over, stroke_of
from planes.geometry.arrays import Array, Booleans

SHORT_MM = 7.0  # of strokes that do not tell how wide lines are
OWN = 0.22  # the share of a line that must be its own and not another's
EDGE_MM = 5.0  # a shorter edge may be an arrowhead's
OUTSIDE_MM = 0.08  # how far outside of a line's ink its edges are seen
AT_EDGE_MM = 0.15
PENCIL_MM = 0.55  # the most that lines usually are wide
TWICE = 1.5  # a line so much wider than usual may be two
OVER_MM = 1.5  # how far a stroke may go on within another's ink
BARE = 0.25  # how much a line counts whose edges are not seen

Edge = tuple[complex, complex]  # the ink is to the right


def lines_on(ink: Ink, rough: Iterable[tuple[complex, complex]], edges: Sequence[Edge]) -> list[Fitted]:
    """Fit the rough lines to the ink, leave out what is another's, and look for what was overlooked."""
    found = [f for f in (fitted(ink, a, b) for a, b in rough if abs(b - a) > 1.2) if f]
    for _ in range(2):  # now that more of each line is known
        found = [f for f in (fitted(ink, *x.ends) for x in found) if f]
    long = [(a, b) for a, b in edges if abs(b - a) > EDGE_MM]
    kept = own(found, long)
    for _ in range(2):
        more = [f for f in (fitted(ink, a, b, kept) for a, b in _unmet(ink, long, kept)) if f]
        kept = own([*kept, *more], long)
        if more:
            kept = own(_apart(ink, kept), long)
    strokes = (stroke_of(part) for part in left_over(ink, kept))
    short = [f for f in (_short(ink, *ends) for ends in strokes if ends) if f]
    kept = own([*kept, *short], long)
    find_heads(ink, kept)
    return kept


def _short(ink: Ink, a: complex, b: complex) -> Fitted | None:
    """The line of a stroke that is left over; of one that goes on within another's ink only what is its own."""
    line = fitted(ink, a, b)
    if line is not None and line.length >= MOST_MM:
        low, high = max(line.low, -OVER_MM), min(line.high, abs(b - a) + OVER_MM)
        line.clear = [line.clear[0] and low == line.low, line.clear[1] and high == line.high]
        line.low, line.high = low, high
    return line


def _apart(ink: Ink, lines: Sequence[Fitted]) -> list[Fitted]:
    """The lines fitted once more, each knowing the others."""
    out = list(lines)
    for k, line in enumerate(lines):
        beside = [x for x in out if x is not out[k]]
        out[k] = fitted(ink, *line.ends, beside) or line
    return out


def _unmet(ink: Ink, edges: Sequence[Edge], lines: Sequence[Fitted]) -> Iterator[tuple[complex, complex]]:
    """Middles of lines that have an edge where no known line has one."""
    usual = _usual(lines)
    half = usual / 2 + OUTSIDE_MM
    met = numpy.zeros(len(edges), bool)
    for line in lines:
        met |= _met(line, edges, usual)[0]
    for (a, b), known in zip(edges, met, strict=True):
        if not known:
            aside = -1j * (b - a) / abs(b - a) * half
            if float((ink.at(numpy.linspace(a + aside, b + aside, 9, dtype=complex)) > DARK).mean()) > 0.7:
                yield a + aside, b + aside


def _usual(lines: Sequence[Fitted]) -> float:
    """How wide lines are; if most are wider than a pencil's, they may all be two."""
    return min(statistics.median([x.width for x in lines if x.length > SHORT_MM] or [PENCIL_MM]), PENCIL_MM)


def _met(line: Fitted, edges: Sequence[Edge], usual: float) -> tuple[Booleans, Array]:
    """Which edges are a line's, and how much of it each is along; one that is too wide is two."""
    if not edges:
        return numpy.zeros(0, bool), numpy.zeros(0)
    a, b = numpy.array(edges, complex).T
    turn = (b - a) / numpy.abs(b - a) * line.along.conjugate()
    p, q = ((z - line.origin) * line.along.conjugate() for z in (a, b))
    s = numpy.clip((p + q).real / 2, line.low, line.high)
    off = ((p + q).imag / 2 - line.bow(s)) * numpy.sign(turn.real)
    low, high = numpy.minimum(p.real, q.real), numpy.maximum(p.real, q.real)
    along = numpy.clip(numpy.minimum(high, line.high) - numpy.maximum(low, line.low), 0, None)
    half = (line.width if line.width < TWICE * usual else usual) / 2 + OUTSIDE_MM
    fits = (numpy.abs(turn.imag) < 0.06) & (numpy.abs(off - half) < AT_EDGE_MM)
    return fits & (along > 0.5 * (high - low)), along


def own(lines: Iterable[Fitted], edges: Sequence[Edge]) -> list[Fitted]:
    """The lines that are not, for the most part, on better ones."""

    lines = list(lines)
    usual = _usual(lines)

    def worth(line: Fitted) -> float:
        met, along = _met(line, edges, usual)
        return line.length * (BARE + min(float((along * met).sum()) / (2 * line.length), 1.0))

    kept: list[Fitted] = []
    for line in sorted(lines, key=worth, reverse=True):
        steps = max(4, int(line.length / 0.4))
        alone = 0
        for k in range(steps):
            z = line.at(line.low + line.length * (k + 0.5) / steps)
            alone += not any(on(other, z) for other in kept)
        if alone > OWN * steps and alone * line.length / steps > 1.0:
            kept.append(line)
    return kept


def on(line: Fitted, z: complex, reach: float = 0.5, beyond: float = 0.5) -> bool:
    """Whether a place is on a line."""
    s, off = line.local(z)
    return abs(off) < reach and line.low - beyond < s < line.high + beyond
