"""Arrowheads of a vector drawing, however a program wrote them: filled or hollow, open, or a line marker.

A head is a tip and a direction. It shows which end of a stroke is the vector's, distinguishes a short vector from a
tick, and is itself no part of the plan.
"""

import cmath
import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import islice, pairwise

from planes.check.reading.strokes import Arrowhead, ReadDrawing, continues_straight
from planes.check.reading.written import Stroke, Strokes, vector_of
from planes.geometry.plane import bounding_corners as box_of
from planes.geometry.plane import direction_between, distance_to_nearest, greatest_distance

LARGEST_HEAD_MM = 8.0  # maximum size of a closed figure as a head
# the same if filled and no polygon, when this narrow between equal sides
LARGEST_FILLED_HEAD_MM = 24.0
LARGE_HEAD_WIDTH_RATIO = 0.7
MOST_TIP_TO_END_MM = 0.7  # a tip is at the end of its stroke, or that end is within the head
HEAD_TURN_WEIGHT_MM_PER_RAD = 10.0  # weight of a head's direction against the distance of its tip, mm per radian
MOST_STROKE_HEAD_PAIRS = 1_000_000  # with more pairs of strokes and heads none is assigned
# heads at both ends make a dimension line, if the second surely belongs to it
HEADS_AT_BOTH_ENDS = 2
MOST_SECOND_HEAD_COST_MM = 1.0
MOST_STROKES_JOINED, SAME_POINT_MM = 500, 0.02
EQUAL_SIDES_TOLERANCE = 0.03  # maximum difference of the sides that meet in a tip, relative to their sum
MOST_SHAFT_OFFSET_RATIO = 0.1  # distance of a shaft's end from a head's centre line, in lengths of the head
MOST_SHAFT_TURN_RAD = 0.02  # radians, maximum turn of a shaft drawn in pieces
# minimum length of a shaft in sides of its open head; a shorter one ends exactly in its tip
LEAST_SHAFT_RATIO, LEAST_EXACT_SHAFT_RATIO, EXACT_TIP_DISTANCE_MM = 1.3, 0.6, 0.3
LEAST_HEAD_ALIGNMENT_COSINE = 0.94  # minimum cosine of the angle between a head and its stroke
EQUILATERAL_HEAD_TURNS = tuple(
    cmath.rect(1, k * math.tau / 3) for k in range(3)
)  # possible directions of an equilateral head
# a head this close to another one in its direction is a duplicate: filled, then outlined
DUPLICATE_HEAD_DISTANCE_MM = 0.1
DUPLICATE_HEAD_TURN = 0.01
MOST_SHAFT_WIDTH_MM = 1.5  # maximum width of a drawn arrow's shaft


def arrowhead_from_figure(points: Sequence[complex], filled: bool = False) -> Arrowhead | None:
    """The head formed by a small closed figure, or a larger one if ``filled``.

    Its tip is the corner farthest from the middle, or the one between equal sides.
    """
    corners = [a for a, b in pairwise([*points, *points[:1]]) if abs(b - a) > 0.02]
    if not 3 <= len(corners) <= 12:
        return None
    middle = sum(corners) / len(corners)
    apexes = _isosceles_apexes(corners)
    tip = apexes[0] if apexes else max(corners, key=lambda z: abs(z - middle))
    size = greatest_distance(corners)
    if len(corners) == 4 and abs(corners[0] - corners[1] + corners[2] - corners[3]) < EQUAL_SIDES_TOLERANCE * size:
        return None  # a dash of a line
    others = [z for z in corners if abs(z - tip) > 0.05 * size]
    largest = LARGEST_FILLED_HEAD_MM if filled and len(apexes) == 1 else LARGEST_HEAD_MM
    if not 0.3 < size <= largest or len(others) < 2:
        return None
    way = tip - sum(others) / len(others)
    u = way / abs(way)
    low, high = box_of((tip - z) * u.conjugate() for z in others)
    widest = LARGE_HEAD_WIDTH_RATIO if size > LARGEST_HEAD_MM else 1.3
    flat = not 0.02 * size < (high - low).imag < widest * size
    return None if flat else Arrowhead(tip, u, high.real, even=len(apexes) == 3)


def _isosceles_apexes(corners: Sequence[complex]) -> list[complex]:
    """The corners of a triangle between equal sides: one, or all three if it is equilateral."""
    if len(corners) != 3:
        return []
    sides = [(abs(corners[k - 1] - corners[k]), abs(corners[k - 2] - corners[k])) for k in range(3)]
    return [
        z for z, (one, two) in zip(corners, sides, strict=True) if abs(one - two) < EQUAL_SIDES_TOLERANCE * (one + two)
    ]


def arrow_or_head_from_figure(
    points: Sequence[complex], filled: bool = False
) -> tuple[Sequence[complex], Arrowhead] | None:
    """The meaning of a closed figure, if any: a whole arrow (vector and head) or only a head."""
    if arrow := _arrow_from_figure(points):
        return arrow
    head = arrowhead_from_figure(points, filled)
    return ((), head) if head else None


def _arrow_from_figure(points: Sequence[complex]) -> tuple[Stroke, Arrowhead] | None:
    """The vector and the head of a whole arrow drawn as one closed figure: its tip, two wings, its neck and its end."""
    ring = [*points][: -1 if len(points) > 7 and abs(points[0] - points[-1]) < SAME_POINT_MM else None]
    for k in range(7) if len(ring) == 7 else ():
        tip, *others = (*ring[k:], *ring[:k])
        start = (others[2] + others[3]) / 2
        sides = [*zip(others[:3], others[:2:-1], strict=True)]
        along = tip - start
        wings, neck, end = (abs(a - b) for a, b in sides)
        if wings < SAME_POINT_MM or max(neck, end) > min(MOST_SHAFT_WIDTH_MM, wings / 2) or abs(along) < wings:
            continue
        local = [((a - start) / along, (b - start) / along) for a, b in sides]
        if (
            all(abs(a - b.conjugate()) < EQUAL_SIDES_TOLERANCE for a, b in local)
            and min(a.real for a, _ in local[:2]) > 0
        ):
            return (start, tip), Arrowhead(tip, direction_between(start, tip), abs(along) * (1 - local[0][0].real))
    return None


def assign_arrowheads(sketch: ReadDrawing) -> None:
    """Forms open heads; assigns each head to its stroke; removes short strokes without heads, and dimension lines."""
    sketch.heads = _without_duplicates(sketch.heads)
    sketch.strokes = list({tuple((round(z.real, 2), round(z.imag, 2)) for z in s): s for s in sketch.strokes}.values())
    shafts = ends_with_heads(sketch.strokes, sketch.heads)[0] if sketch.heads else []
    free = [s for k, s in enumerate(sketch.strokes) if not (shafts and shafts[k])]
    for head, wings in _open_heads(sketch.strokes, free):
        sketch.strokes = [s for s in sketch.strokes if s not in wings]
        sketch.heads.append(head)
    strokes = sketch.strokes + sketch.short
    owned, tips = ends_with_heads(strokes, sketch.heads)
    kept = [k for k in range(len(strokes)) if owned[k] != HEADS_AT_BOTH_ENDS and (k < len(sketch.strokes) or owned[k])]
    for k, tip in _tips_extending_shafts(strokes, owned, tips).items():
        strokes[k] = (strokes[k][0], tip) if owned[k] > 0 else (tip, strokes[k][1])
    sketch.strokes = [strokes[k] for k in kept]
    sketch.ways = [owned[k] for k in kept]
    sketch.short = []
    _join_to_headed_strokes(sketch)


def _tips_extending_shafts(strokes: Strokes, owned: Sequence[int], tips: dict[int, complex]) -> dict[int, complex]:
    """Tips to which shafts that end within their heads are extended.

    All are, unless heads extend beyond the intended points, where other strokes end as these do.
    """
    if len(strokes) > MOST_STROKES_JOINED:
        return tips
    ends = [(k, z) for k, stroke in enumerate(strokes) for z in stroke]

    def met(k: int, z: complex) -> bool:
        return distance_to_nearest(z, (w for j, w in ends if j != k)) < SAME_POINT_MM

    beyond = sum(met(k, strokes[k][owned[k] > 0]) - met(k, tip) for k, tip in tips.items())
    return {} if beyond > 0 else tips


def _without_duplicates(heads: Sequence[Arrowhead]) -> list[Arrowhead]:
    """The heads without duplicates."""
    by_place: dict[tuple[int, int], list[Arrowhead]] = {}
    for head in heads:
        near = by_place.setdefault((round(head.tip.real), round(head.tip.imag)), [])
        if all(
            abs(head.tip - h.tip) > DUPLICATE_HEAD_DISTANCE_MM or abs(head.way - h.way) > DUPLICATE_HEAD_TURN
            for h in near
        ):
            near.append(head)
    return [head for near in by_place.values() for head in near]


def _join_to_headed_strokes(sketch: ReadDrawing) -> None:
    """Joins strokes without heads to a stroke with a head that continues them straight on, where nothing else meets."""
    if len(sketch.strokes) > MOST_STROKES_JOINED:
        return
    gone = set()
    for k, way in enumerate(sketch.ways):
        while way:
            a, b = sketch.strokes[k][::way]
            near = [i for i, s in enumerate(sketch.strokes) if i != k and i not in gone]
            near = [i for i in near if distance_to_nearest(a, sketch.strokes[i]) < SAME_POINT_MM]
            if len(near) != 1 or sketch.ways[near[0]]:
                break
            before = max(sketch.strokes[near[0]], key=lambda z: abs(z - a))
            if not (before == a or continues_straight(before, a, b, MOST_SHAFT_TURN_RAD)):
                break
            gone.add(near[0])
            sketch.strokes[k] = (before, b) if way > 0 else (b, before)
    kept = sketch.with_some_strokes(k for k in range(len(sketch.strokes)) if k not in gone)
    sketch.strokes = kept.strokes
    sketch.ways = kept.ways


def ends_with_heads(strokes: Strokes, heads: Sequence[Arrowhead]) -> tuple[list[int], dict[int, complex]]:
    """The end with a head of each stroke: +1 the second, -1 the first, 0 neither, 2 both; a head has one stroke.

    Also the tips of those strokes that end within their heads.
    """
    import numpy

    way_of = [0] * len(strokes)
    tips = dict[int, complex]()
    if len(strokes) * len(heads) > MOST_STROKE_HEAD_PAIRS:
        return way_of, tips
    ends = numpy.array(strokes, complex).reshape(-1, 2)
    reach = [max(MOST_TIP_TO_END_MM, 2 * head.length) for head in heads]
    near = [numpy.flatnonzero(abs(ends - h.tip).min(axis=1) < far) for h, far in zip(heads, reach, strict=True)]
    wanted = [
        [(*one, turned.tip) for turned in _possible_turns(head) for one in _candidate_ends(strokes, turned, held)]
        for head, held in zip(heads, near, strict=True)
    ]
    for candidates in sorted(wanted, key=len):
        free = [one for one in candidates if not way_of[one[1]]]
        free = free or [one for one in candidates if way_of[one[1]] == -one[2] and one[0] < MOST_SECOND_HEAD_COST_MM]
        if free:
            far, k, way, tip = min(free, key=lambda one: one[:3])
            way_of[k] = HEADS_AT_BOTH_ENDS if way_of[k] else way
            tips |= {k: tip} if far < 0 else {}
    return way_of, tips


def _possible_turns(head: Arrowhead) -> Iterator[Arrowhead]:
    """A head; an equilateral one in every direction that its stroke may determine."""
    middle = head.tip - head.way * head.length * 2 / 3
    for turn in EQUILATERAL_HEAD_TURNS if head.even else EQUILATERAL_HEAD_TURNS[:1]:
        yield head._replace(tip=middle + (head.tip - middle) * turn, way=head.way * turn) if turn != 1 else head


def _candidate_ends(strokes: Strokes, head: Arrowhead, held: Iterable[int]) -> list[tuple[float, int, int]]:
    """Ends of the strokes ``held`` to which a head may belong: distance (negative within the head), stroke, end."""
    tip, way, long, _ = head
    ends = []
    for k in map(int, held):
        a, b = strokes[k]
        near = min(MOST_TIP_TO_END_MM, 0.4 * abs(b - a))
        for end, sign in ((b, 1), (a, -1)):
            off = (end - tip) * way.conjugate()
            turn = sign * (b - a) * way.conjugate()
            inside = (
                -long - SAME_POINT_MM < off.real < -near and abs(off.imag) < MOST_SHAFT_OFFSET_RATIO * long
            )  # only its own shaft ends there
            if (inside or abs(off) < near) and turn.real > LEAST_HEAD_ALIGNMENT_COSINE * abs(turn):
                aside = HEAD_TURN_WEIGHT_MM_PER_RAD * abs(turn.imag) / abs(turn)
                ends.append((aside - MOST_TIP_TO_END_MM if inside else abs(off) + aside, k, sign))
    return ends


def _open_heads(strokes: Strokes, free: Strokes) -> list[tuple[Arrowhead, tuple[Stroke, Stroke]]]:
    """Pairs of short strokes, among those ``free``, that spread symmetrically from the end of a longer one."""
    short = [s for s in free if abs(vector_of(s)) <= LARGEST_HEAD_MM]
    pairs = [(one, two) for i, one in enumerate(short) for two in short[:i]] if len(short) <= 400 else []
    spread = [(head, wings, far) for wings in pairs for head, far in _open_head_from_wings(*wings)]
    heads = []
    for head, wings, far in spread if len(strokes) * len(spread) <= MOST_STROKE_HEAD_PAIRS else ():
        others = [s for s in strokes if s not in wings]
        ends = _candidate_ends(others, head, range(len(others)))
        lengths = ((off, abs(vector_of(others[k])) / far) for off, k, _ in ends)
        if any(
            long > LEAST_SHAFT_RATIO or (long > LEAST_EXACT_SHAFT_RATIO and off < EXACT_TIP_DISTANCE_MM)
            for off, long in lengths
        ):
            heads.append((head, wings))
    return heads


def _open_head_from_wings(one: Stroke, two: Stroke) -> Iterator[tuple[Arrowhead, float]]:
    """The open head of two strokes that spread symmetrically from their common end, and its length."""
    ways = ((a, b, d) for a, b in (one, one[::-1]) for c, d in (two, two[::-1]) if abs(a - c) < 0.15 < abs(b - d))
    for tip, b, d in islice(ways, 1):
        far = abs(b - tip)
        middle = tip - (b + d) / 2
        if abs(far - abs(d - tip)) <= 0.15 * far and 0.12 < abs(b - d) / max(far, 1e-9) < 1.3:
            yield Arrowhead(tip, middle / abs(middle)), far


def split_off_tapered_heads(
    points: Sequence[complex], widths: Sequence[tuple[float, float]]
) -> tuple[list[complex], list[Arrowhead]]:
    """A polyline with segments that taper to zero: those are heads, and the line continues to their tips."""
    kept = [points[0]]
    heads = []
    for (a, b), (wide, narrow) in zip(pairwise(points), widths, strict=False):
        small = 0 < abs(b - a) <= LARGEST_HEAD_MM
        if small and wide == 0 < narrow:
            heads.append(Arrowhead(a, direction_between(b, a)))
            continue  # the shaft continues from the tip
        if small and narrow == 0 < wide:
            heads.append(Arrowhead(b, direction_between(a, b)))
            if len(kept) > 1 and (
                kept[-2] == kept[-1] or continues_straight(kept[-2], kept[-1], b, MOST_SHAFT_TURN_RAD)
            ):
                kept.pop()  # the shaft reaches the tip
        kept.append(b)
    return (kept if len(kept) > 1 else list(points)), heads
