"""Which lines there are in a sheet's ink: lines that run close beside each other, and short ones, told apart."""

import math
import statistics
from collections.abc import Iterable, Iterator, Sequence

import numpy

from planes.check.vision.image.picture import Flat, cv
from planes.check.vision.strokes.arrow_tips import find_heads
from planes.check.vision.strokes.head_ink import but_strokes
from planes.check.vision.strokes.ink import DARK, Ink
from planes.check.vision.strokes.line_fitting import Fitted, fitted
from planes.check.vision.strokes.meeting import held
from planes.check.vision.strokes.residual_ink import MOST_MM, STRAIGHT_MM, Edge, left_over, straight_through
from planes.geometry.arrays import Array, Booleans, Greys

SHORT_MM = 7.0  # of strokes that do not tell how wide lines are
OWN = 0.22  # the share of a line that must be its own and not another's
EDGE_MM = 5.0  # a shorter edge may be an arrowhead's
OUTSIDE_MM = 0.08  # how far outside of a line's ink its edges are seen
AT_EDGE_MM = 0.15
PENCIL_MM = 0.55  # the most that lines usually are wide
TWICE = 1.5  # a line so much wider than usual may be two
OVER_MM = 1.5  # how far a stroke may go on within another's ink
BARE = 0.25  # how much a line counts whose edges are not seen
WIDEST_MM = 1.4  # of a stroke
SHORTEST_MM = 1.5
USUAL, COARSE, LARGE_PX = 0.8, 0.5, 10_000_000  # how small edges are sought: it takes 40 bytes a place; beyond A3
MOST = 250  # lines; of more nothing can be told


def lines_of(ink: Ink) -> list[Fitted] | None:
    """All lines of a sheet's ink; None if there are more than a plan can have."""
    edges = _edges(ink.even)
    if len(edges) > 12 * MOST:
        return None
    rims, lines = _in_mm(ink.flat, edges), _in_mm(ink.flat, _centres(edges, ink.flat.scale))
    lines = [(a, b) for a, b in lines if abs(b - a) > SHORTEST_MM]
    if len(lines) > 4 * MOST or len(lines := joined(lines)) > MOST:
        return None
    return lines_on(ink, lines, rims)


def _in_mm(flat: Flat, lines: list[Edge]) -> list[Edge]:
    """Lines in pixels as they lie on the sheet."""
    return [(flat.mm(a.real, a.imag), flat.mm(b.real, b.imag)) for a, b in lines]


def _edges(ink: Greys) -> list[Edge]:
    """Both edges of every stroke, in pixels, the ink to their right as one sees it."""
    found = cv().createLineSegmentDetector(2, scale=USUAL if ink.size < LARGE_PX else COARSE).detect(ink)[0]
    if found is None:
        return []
    return [(complex(x1, y1), complex(x2, y2)) for x1, y1, x2, y2 in found.reshape(-1, 4).tolist()]


def _centres(edges: list[Edge], scale: float) -> list[Edge]:
    """Pairs of opposite edges as centre lines."""
    if not edges:
        return []
    a, b = numpy.array([e[0] for e in edges]), numpy.array([e[1] for e in edges])
    length = numpy.abs(b - a)
    u = (b - a) / numpy.maximum(length, 1e-9)
    found = []
    for i in numpy.argsort(-length):
        if length[i] < 1.0 * scale:
            continue
        turn = u * u[i].conjugate()
        p, q = (a - a[i]) * u[i].conjugate(), (b - a[i]) * u[i].conjugate()
        apart = (p.imag + q.imag) / 2
        low, high = numpy.maximum(q.real, 0), numpy.minimum(p.real, length[i])
        fits = (turn.real < -0.99) & (apart > 0.1 * scale) & (apart < WIDEST_MM * scale)
        fits &= (high - low) > 0.35 * numpy.minimum(length, length[i])
        for j in numpy.flatnonzero(fits):
            if length[j] > length[i] or (length[j] == length[i] and j <= i):
                continue
            start, end = min(float(q[j].real), 0.0), max(float(p[j].real), float(length[i]))
            start, end = max(start, -2 * scale), min(end, float(length[i]) + 2 * scale)
            middle = 0.5j * apart[j]
            lean = u[i] * numpy.exp(0.5j * numpy.angle(-turn[j]))
            centre = a[i] + u[i] * (float(low[j] + high[j]) / 2 + middle)
            half0, half1 = start - float(low[j] + high[j]) / 2, end - float(low[j] + high[j]) / 2
            found.append((complex(centre + lean * half0), complex(centre + lean * half1)))
    return found


def joined(lines: list[Edge]) -> list[Edge]:
    """Lines that continue each other as one; what lies on a longer one is part of it."""
    left = sorted(lines, key=lambda x: -abs(x[1] - x[0]))
    out: list[Edge] = []
    while left:
        line = left.pop(0)
        while other := next((x for x in left if _continues(line, x)), None):
            left.remove(other)
            places = [numpy.linspace(a, b, max(3, int(abs(b - a) * 2))) for a, b in (line, other)]
            line, _ = straight_through(numpy.concatenate(places))
        out.append(line)
    return out


def _continues(line: Edge, other: Edge) -> bool:
    long, short = (abs(b - a) for a, b in (line, other))
    along = (line[1] - line[0]) / long
    turn = (other[1] - other[0]) / short * along.conjugate()
    if abs(math.asin(max(-1.0, min(1.0, turn.imag)))) > math.radians(4.0 if short > 8 else 9.0) or abs(turn.real) < 0.9:
        return False
    p, q = ((z - line[0]) * along.conjugate() for z in other)
    low, high = sorted((p.real, q.real))
    gap = max(low - long, -high, 0.0)
    side = max(abs(p.imag), abs(q.imag))
    return gap < 1.6 and side < 0.55 + 0.012 * min(short, long) and not (gap <= 0 and side > 0.7)


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
    strokes = (straight_through(part) for part in left_over(ink, kept))
    short = [f for f in (_short(ink, *ends) for ends, off in strokes if off <= STRAIGHT_MM) if f]
    kept = own([*kept, *short], long)
    find_heads(ink, kept)
    return but_strokes(kept)


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
        out[k] = fitted(ink, *line.ends, [*out[:k], *out[k + 1 :]]) or line
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
        places, met = line.at(line.low + line.length * (numpy.arange(steps) + 0.5) / steps), numpy.zeros(steps, bool)
        for other in kept:
            met |= held(other, places)
        alone = steps - int(met.sum())
        if alone > OWN * steps and alone * line.length / steps > 1.0:
            kept.append(line)
    return kept
