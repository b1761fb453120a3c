"""Lines drawn by hand on a flat picture of paper, roughly: found by their two edges, and joined where they go on."""

from __future__ import annotations

import math

import numpy

from planes.check.vision.drawn_lines import Edge, lines_on, patches, straight_through
from planes.check.vision.ink import ink_of
from planes.check.vision.picture import Flat, cv
from planes.check.vision.places import Seen, places_of
from planes.geometry.arrays import Greys

WIDEST_MM = 1.4  # of a stroke
SHORTEST_MM = 1.5
MOST = 250  # lines; of more nothing can be told


def sheet_of(flat: Flat, cross: complex | None = None) -> Seen | None:
    """What is seen on a flat picture with a cross printed at a place; None if more lines than a plan can have."""
    ink = ink_of(flat, cross)
    edges = _edges(ink.even)
    if len(edges) > 12 * MOST:
        return None
    rims, lines = _in_mm(flat, edges), _in_mm(flat, _centres(edges, flat.scale))
    lines = [(a, b) for a, b in lines if abs(b - a) > SHORTEST_MM]
    if len(lines) > 4 * MOST or len(lines := joined(lines)) > MOST:
        return None
    found = lines_on(ink, lines, rims)
    return Seen(ink, found, places_of(found), patches(ink, found))


def _in_mm(flat: Flat, lines: list[Edge]) -> list[Edge]:
    """Lines in pixels as they lie on the sheet."""
    return [(flat.mm(a.real, a.imag), flat.mm(b.real, b.imag)) for a, b in lines]


def _edges(ink: Greys) -> list[Edge]:
    """Both edges of every stroke, in pixels, the ink to their right as one sees it."""
    found = cv().createLineSegmentDetector(2, scale=0.8).detect(ink)[0]
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
