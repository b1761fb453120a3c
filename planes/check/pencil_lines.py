"""Lines drawn by hand on a flat picture of paper: found by their two edges, joined, and met at their common ends."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from planes.check.fiducials import SIDE_MM, centres
from planes.check.ink import ink_of
from planes.check.picture import Flat, cv
from planes.check.places import Seen, seen
from planes.check.strokes import Sketch, Stroke

WIDEST_MM = 1.4  # of a stroke
LETTER_MM = 7.5  # smaller separate marks of ink are letters
SHORTEST_MM = 2.2
HEAD_MM = 6.0  # an arrowhead's length at most
CAP_MM = 0.4  # the round end of a stroke and its blur
JOIN_MM = 2.2  # ends nearer than this meet
MOST = 1500  # lines; of more nothing can be told


@dataclass
class Line:
    """A centre line by its ends, mm."""

    a: complex
    b: complex

    @property
    def along(self) -> complex:
        return (self.b - self.a) / abs(self.b - self.a)

    def off(self, z: complex) -> float:
        """How far a place is to the left of the line."""
        return float(((z - self.a) * self.along.conjugate()).imag)


def lines_of(flat: Flat, printed: Sequence[Stroke] = ()) -> Sketch | None:
    """The strokes of a flat picture; None where there are more than a plan can have."""
    ink = clean(flat, printed)
    edges = _edges(ink)
    if len(edges) > 6 * MOST:
        return None
    lines = [Line(flat.mm(*a), flat.mm(*b)) for a, b in _centres(edges, flat.scale)]
    lines = joined([x for x in lines if abs(x.b - x.a) > SHORTEST_MM])
    if len(lines) > MOST:
        return None
    dark = _dark(ink)
    lines = joined([Line(reached(flat, dark, x.b, x.a), reached(flat, dark, x.a, x.b)) for x in lines])
    sketch = Sketch(error_mm=0.25)
    sketch.strokes = meeting([x for x in lines if abs(x.b - x.a) > SHORTEST_MM])
    return sketch


def sheet_of(flat: Flat) -> Seen | None:
    """What is seen on a flat picture; None where there are more lines than a plan can have."""
    ink = ink_of(flat)
    edges = _edges(ink.even)
    if len(edges) > 6 * MOST:
        return None
    lines = [Line(flat.mm(*a), flat.mm(*b)) for a, b in _centres(edges, flat.scale)]
    lines = joined([x for x in lines if abs(x.b - x.a) > SHORTEST_MM])
    return None if len(lines) > MOST else seen(ink, [(x.a, x.b) for x in lines])


def clean(flat: Flat, printed: Sequence[Stroke]) -> Any:
    """Even light, letters and printed marks painted over."""
    import numpy

    cv2 = cv()
    grey = flat.grey
    paper = cv2.GaussianBlur(cv2.dilate(grey, numpy.ones((15, 15), numpy.uint8)), (0, 0), 2.5 * flat.scale)
    even = numpy.clip(grey.astype(numpy.float32) * 255.0 / numpy.maximum(paper, 1), 0, 255).astype(numpy.uint8)
    even = cv2.GaussianBlur(even, (0, 0), 1.0)
    if flat.by == "marks":
        _whiten_printed(flat, even)
    dark = _dark(even)
    _, labels, stats, _ = cv2.connectedComponentsWithStats(dark, connectivity=8)
    small = numpy.maximum(stats[:, 2], stats[:, 3]) < LETTER_MM * flat.scale
    small[0] = False
    keep = cv2.dilate((~small[labels] & (labels > 0)).astype(numpy.uint8), numpy.ones((7, 7), numpy.uint8))
    even[keep == 0] = 255
    return even


def _dark(even: Any) -> Any:
    """Where there is ink: darker than the middle between paper and the darkest lines."""
    import numpy

    low = float(numpy.percentile(even, 0.3))
    level = min(235.0, max(140.0, (low + 255.0) / 2 + 20))
    return (even < level).astype(numpy.uint8)


def _whiten_printed(flat: Flat, even: Any) -> None:
    """Paint over the corner marks, the frame and what lies outside of it."""
    cv2 = cv()
    size = even.shape[1] / flat.scale, even.shape[0] / flat.scale
    for z in centres((size[0], size[1])):
        x, y = flat.px(z)
        r = (SIDE_MM / 2 + 2) * flat.scale
        cv2.rectangle(even, (int(x - r), int(y - r)), (int(x + r), int(y + r)), 255, -1)
    margin = int(8.5 * flat.scale)
    even[:margin], even[-margin:] = 255, 255
    even[:, :int(21.5 * flat.scale)], even[:, -margin:] = 255, 255


def _edges(ink: Any) -> list[tuple[complex, complex]]:
    """Both edges of every stroke, in pixels, the ink on one and the same side of them."""
    found = cv().createLineSegmentDetector(2, scale=0.8).detect(ink)[0]
    if found is None:
        return []
    return [(complex(x1, y1), complex(x2, y2)) for x1, y1, x2, y2 in found.reshape(-1, 4).tolist()]


Pixel = tuple[float, float]


def _centres(edges: list[tuple[complex, complex]], scale: float) -> list[tuple[Pixel, Pixel]]:
    """Pairs of opposite edges as centre lines."""
    import numpy

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
        fits = (turn.real < -0.99) & (numpy.abs(apart) > 0.1 * scale) & (numpy.abs(apart) < WIDEST_MM * scale)
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
            one, two = centre + lean * half0, centre + lean * half1
            found.append(((one.real, one.imag), (two.real, two.imag)))
    return found


def reached(flat: Flat, dark: Any, start: complex, end: complex) -> complex:
    """The end of a line moved on to where its ink really ends: through the arrowhead."""
    u = (end - start) / abs(end - start)
    step, z, last, white = 0.1, end - 0.5 * u, end, 0.0
    height, width = dark.shape
    while abs(z - end) < HEAD_MM and white < 0.35:
        x, y = flat.px(z)
        i, j = round(y), round(x)
        if not (1 <= i < height - 1 and 1 <= j < width - 1):
            break
        if dark[i - 1 : i + 2, j - 1 : j + 2].any():
            last, white = z, 0.0
        else:
            white += step
        z += step * u
    last -= CAP_MM * u
    return last if abs(last - end) < HEAD_MM - 0.5 and (last - start).real * u.real + (
        last - start).imag * u.imag > 0.5 else end  # fmt: skip


def joined(lines: list[Line]) -> list[Line]:
    """Lines that continue each other as one; what lies on a longer one is part of it."""
    left = sorted(lines, key=lambda x: -abs(x.b - x.a))
    out: list[Line] = []
    while left:
        line = left.pop(0)
        grown = True
        while grown:
            grown = False
            for other in left:
                if _continues(line, other):
                    line = _merged(line, other)
                    left.remove(other)
                    grown = True
                    break
        out.append(line)
    return out


def _continues(line: Line, other: Line) -> bool:
    long, short = abs(line.b - line.a), abs(other.b - other.a)
    turn = abs(math.asin(max(-1.0, min(1.0, float((line.along.conjugate() * other.along).imag)))))
    if turn > math.radians(4.0 if short > 8 else 9.0) or abs((line.along.conjugate() * other.along).real) < 0.9:
        return False
    p, q = ((z - line.a) * line.along.conjugate() for z in (other.a, other.b))
    low, high = sorted((p.real, q.real))
    gap = max(low - long, -high, 0.0)
    side = max(abs(p.imag), abs(q.imag))
    return gap < 1.6 and side < 0.55 + 0.012 * min(short, long) and not (gap <= 0 and side > 0.7)


def _merged(line: Line, other: Line) -> Line:
    """The straight line of both, weighted by their lengths."""
    import numpy

    pairs = [(line.a, line.b), (other.a, other.b)]
    z = numpy.concatenate([numpy.linspace(a, b, max(3, int(abs(b - a) * 2))) for a, b in pairs])
    middle = z.mean()
    u = numpy.exp(0.5j * numpy.angle(((z - middle) ** 2).sum()))
    along = ((z - middle) * u.conjugate()).real
    return Line(complex(middle + u * along.min()), complex(middle + u * along.max()))


def meeting(lines: list[Line]) -> list[Stroke]:
    """Strokes whose ends near each other are moved to where their lines meet."""
    ends = [(i, s, z) for i, x in enumerate(lines) for s, z in enumerate((x.a, x.b))]
    group = list(range(len(ends)))
    for i, (_, _, z) in enumerate(ends):
        for j in range(i):
            if abs(ends[j][2] - z) < JOIN_MM and ends[j][0] != ends[i][0]:
                old, new = group[i], group[j]
                group = [new if g == old else g for g in group]
    placed = {(i, s): z for i, s, z in ends}
    for g in set(group):
        members = [ends[k] for k in range(len(ends)) if group[k] == g]
        place = _common([lines[i] for i, _, _ in members], [z for _, _, z in members])
        for i, s, z in members:
            if abs(place - z) < 2 * JOIN_MM:
                placed[i, s] = place
    placed |= _touching(lines, ends, group, placed)
    return [(placed[i, 0], placed[i, 1]) for i in range(len(lines)) if abs(placed[i, 0] - placed[i, 1]) > 1.0]


def _touching(
    lines: list[Line], ends: list[tuple[int, int, complex]], group: list[int], placed: dict[tuple[int, int], complex]
) -> dict[tuple[int, int], complex]:
    """Lone ends that stop at the middle of another line are moved onto it."""
    found = {}
    for k, (i, s, z) in enumerate(ends):
        if group.count(group[k]) > 1:
            continue
        for j, other in enumerate(lines):
            local = (z - other.a) * other.along.conjugate()
            turn = abs(float((other.along.conjugate() * lines[i].along).imag))
            if j != i and turn > 0.2 and abs(local.imag) < 1.6 and 0 < local.real < abs(other.b - other.a):
                found[i, s] = z - lines[i].along * float(local.imag) / float(
                    (lines[i].along * other.along.conjugate()).imag)  # fmt: skip
    return found


def _common(lines: list[Line], ends: list[complex]) -> complex:
    """The place nearest to all lines, and (weakly) to the ends themselves."""
    import numpy

    rows, right = [], []
    for line in lines:
        n = line.along * 1j
        weight = min(1.0, abs(line.b - line.a) / 15)
        rows.append([weight * n.real, weight * n.imag])
        right.append(weight * (line.a.real * n.real + line.a.imag * n.imag))
    for z in ends:
        for row, value in (((0.08, 0.0), z.real), ((0.0, 0.08), z.imag)):
            rows.append(list(row))
            right.append(0.08 * value)
    x, y = numpy.linalg.lstsq(numpy.array(rows), numpy.array(right), rcond=None)[0]
    return complex(x, y)
