"""Arrowheads of a drawing of lines, however a program wrote them: filled or hollow, open, or a marker of the line.

A head is a tip and the way it points. It tells which end of a stroke is the vector's, keeps a vector too short to be
told from a tick, and is itself no part of the plan.
"""

from collections.abc import Iterable, Iterator, Sequence
from itertools import islice, pairwise

from planes.check.reading.strokes import Arrowhead, ReadDrawing, Stroke, goes_on

LARGEST_MM = 8.0  # a closed figure no larger may be a head
NEAR_MM = 0.7  # a tip is at the end of its stroke, or that end is within the head
TURNED = 10.0  # how much better it is for a stroke to point as its head does than to end at the tip, mm per radian
MOST_PAIRS = 1_000_000  # of more strokes and heads none is told whose it is
BOTH = 2
MOST_JOINED, SAME_MM = 500, 0.02
EVEN = 0.03  # how unequal sides may be that meet in a tip, of their sum
SLIM = 0.1  # how far from a head's middle line its shaft may end, in lengths of the head
ASKEW = 0.02  # radians, by which a shaft drawn in pieces may turn
STRAIGHT = 0.94  # the cosine of the angle between a head and its stroke, at the least


def head_of(points: Sequence[complex]) -> Arrowhead | None:
    """The head a small closed figure is: its tip is the corner farthest from the middle, or between equal sides."""
    corners = [a for a, b in pairwise([*points, *points[:1]]) if abs(b - a) > 0.02]
    if not 3 <= len(corners) <= 12:
        return None
    middle = sum(corners) / len(corners)
    tip = _apex(corners) or max(corners, key=lambda z: abs(z - middle))
    size = max(abs(a - b) for a in corners for b in corners)
    others = [z for z in corners if abs(z - tip) > 0.05 * size]
    if not 0.3 < size <= LARGEST_MM or len(others) < 2:
        return None
    way = tip - sum(others) / len(others)
    u = way / abs(way)
    across = [((z - tip) * u.conjugate()).imag for z in others]
    long = max(((tip - z) * u.conjugate()).real for z in others)
    return Arrowhead(tip, u, long) if 0.02 * size < max(across) - min(across) < 1.3 * size else None


def _apex(corners: Sequence[complex]) -> complex | None:
    """The corner of a triangle between its equal sides, if there is one such."""
    if len(corners) != 3:
        return None
    sides = [(abs(corners[k - 1] - corners[k]), abs(corners[k - 2] - corners[k])) for k in range(3)]
    even = [k for k, (one, two) in enumerate(sides) if abs(one - two) < EVEN * (one + two)]
    return corners[even[0]] if len(even) == 1 else None


def settle(sketch: ReadDrawing) -> None:
    """Open heads become heads; each goes to its stroke; short strokes that have none, and dimension lines, go."""
    shafts = given(sketch.strokes, sketch.heads)[0] if sketch.heads else []
    free = [s for k, s in enumerate(sketch.strokes) if not (shafts and shafts[k])]
    for head, wings in _open(sketch.strokes, free):
        sketch.strokes = [s for s in sketch.strokes if s not in wings]
        sketch.heads.append(head)
    strokes = sketch.strokes + sketch.short
    owned, tips = given(strokes, sketch.heads)
    kept = [k for k in range(len(strokes)) if owned[k] != BOTH and (k < len(sketch.strokes) or owned[k])]
    for k, tip in tips.items():  # a shaft that ends within its head is drawn up to the tip
        strokes[k] = (strokes[k][0], tip) if owned[k] > 0 else (tip, strokes[k][1])
    sketch.strokes = [strokes[k] for k in kept]
    sketch.ways, sketch.short = [owned[k] for k in kept], []
    _join(sketch)


def _join(sketch: ReadDrawing) -> None:
    """Strokes without heads that a stroke with a head goes straight on from, where nothing else meets, join it."""
    if len(sketch.strokes) > MOST_JOINED:
        return
    gone = set[int]()
    for k, way in enumerate(sketch.ways):
        while way:
            a, b = sketch.strokes[k][::way]
            near = [i for i, s in enumerate(sketch.strokes) if i != k and i not in gone]
            near = [i for i in near if min(abs(a - z) for z in sketch.strokes[i]) < SAME_MM]
            if len(near) != 1 or sketch.ways[near[0]]:
                break
            before = max(sketch.strokes[near[0]], key=lambda z: abs(z - a))
            if not (before == a or goes_on(before, a, b, ASKEW)):
                break
            gone.add(near[0])
            sketch.strokes[k] = (before, b) if way > 0 else (b, before)
    kept = sketch.only(k for k in range(len(sketch.strokes)) if k not in gone)
    sketch.strokes, sketch.ways = kept.strokes, kept.ways


def given(strokes: Sequence[Stroke], heads: Sequence[Arrowhead]) -> tuple[list[int], dict[int, complex]]:
    """Which end of each stroke has a head: +1 the second, -1 the first, 0 neither, 2 both; a head has one stroke.

    With them the tips of those strokes that end within their heads.
    """
    import numpy

    found, tips = [0] * len(strokes), dict[int, complex]()
    if len(strokes) * len(heads) > MOST_PAIRS:
        return found, tips
    ends = numpy.array(strokes, complex).reshape(-1, 2)
    reach = [max(NEAR_MM, 2 * head.length) for head in heads]
    near = [numpy.flatnonzero(abs(ends - h.tip).min(axis=1) < far) for h, far in zip(heads, reach, strict=True)]
    wanted = [(_candidates(strokes, head, held), head.tip) for head, held in zip(heads, near, strict=True)]
    wanted.sort(key=lambda w: len(w[0]))
    for candidates, tip in wanted:
        free = [(far + 5 * (found[k] != 0), k, way) for far, k, way in candidates if found[k] in (0, -way)]
        if free:
            far, k, way = min(free)
            found[k] = BOTH if found[k] else way
            tips |= {k: tip} if far < 0 else {}
    return found, tips


def _candidates(strokes: Sequence[Stroke], head: Arrowhead, held: Iterable[int]) -> list[tuple[float, int, int]]:
    """Ends of the strokes ``held`` a head may belong to: how far it is (less than nothing if within it), which stroke,
    which end."""
    tip, way, long = head
    found = []
    for k in map(int, held):
        a, b = strokes[k]
        near = min(NEAR_MM, 0.4 * abs(b - a))
        for end, sign in ((b, 1), (a, -1)):
            off, turn = (end - tip) * way.conjugate(), sign * (b - a) * way.conjugate()
            inside = -long - SAME_MM < off.real < -near and abs(off.imag) < SLIM * long  # only its own shaft ends there
            if (inside or abs(off) < near) and turn.real > STRAIGHT * abs(turn):
                aside = TURNED * abs(turn.imag) / abs(turn)
                found.append((aside - NEAR_MM if inside else abs(off) + aside, k, sign))
    return found


def _open(strokes: Sequence[Stroke], free: Sequence[Stroke]) -> list[tuple[Arrowhead, tuple[Stroke, Stroke]]]:
    """Pairs of short strokes, of those ``free``, that spread alike from the end of a longer one."""
    short = [s for s in free if abs(s[1] - s[0]) <= LARGEST_MM]
    pairs = [(one, two) for i, one in enumerate(short) for two in short[:i]] if len(short) <= 400 else []
    spread = [(head, wings, far) for wings in pairs for head, far in _spread(*wings)]
    found = []
    for head, wings, far in spread if len(strokes) * len(spread) <= MOST_PAIRS else ():
        longer = [s for s in strokes if s not in wings and abs(s[1] - s[0]) > 1.3 * far]
        if _candidates(longer, head, range(len(longer))):
            found.append((head, wings))
    return found


def _spread(one: Stroke, two: Stroke) -> Iterator[tuple[Arrowhead, float]]:
    """The open head two strokes make, and how long it is, if they spread alike from where they meet."""
    ways = ((a, b, d) for a, b in (one, one[::-1]) for c, d in (two, two[::-1]) if abs(a - c) < 0.15 < abs(b - d))
    for tip, b, d in islice(ways, 1):
        far, middle = abs(b - tip), tip - (b + d) / 2
        if abs(far - abs(d - tip)) <= 0.15 * far and 0.12 < abs(b - d) / max(far, 1e-9) < 1.3:
            yield Arrowhead(tip, middle / abs(middle)), far


def tapered(points: Sequence[complex], widths: Sequence[tuple[float, float]]) -> tuple[list[complex], list[Arrowhead]]:
    """A polyline some of whose segments narrow to nothing: those are heads, the line goes on to their tips."""
    kept, heads = [points[0]], list[Arrowhead]()
    for (a, b), (wide, narrow) in zip(pairwise(points), widths, strict=False):
        small = 0 < abs(b - a) <= LARGEST_MM
        if small and wide == 0 < narrow:
            heads.append(Arrowhead(a, (a - b) / abs(a - b)))
            continue  # the shaft goes on from the tip
        if small and narrow == 0 < wide:
            heads.append(Arrowhead(b, (b - a) / abs(b - a)))
            if len(kept) > 1 and (kept[-2] == kept[-1] or goes_on(kept[-2], kept[-1], b, ASKEW)):
                kept.pop()  # the shaft reaches the tip
        kept.append(b)
    return (kept if len(kept) > 1 else list(points)), heads
