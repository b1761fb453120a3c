"""The content of a page: its lettering removed, the rest split into connected parts with the words near them."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy
from shapely import STRtree, buffer, distance, get_parts, length, multilinestrings, points, polygons, union_all

from planes.check.reading.hatching import without_hatching
from planes.check.reading.strokes import ReadDrawing, as_lines
from planes.check.reading.written import Strokes, Words, vector_of
from planes.geometry.arrays import Booleans, Complexes

CONNECTED_STROKES_MM = 2.3  # closer strokes belong together: a force is drawn this far beside another one
MOST_PART_TO_WORD_MM = 12.0  # a word farther off names another part
MOST_PART_TO_CIRCLE_MM = 7.0  # a point beside its link
MOST_STROKES_SPLIT = 4000  # a page with more strokes is not split
SMALLEST_PART_MM = 6.0  # a smaller unnamed part is a sign or a letter
LONGEST_LETTER_STROKE_RATIO = 1.4  # maximum length of a letter's stroke, in heights of its word
# margin of a word's box that its letters may reach, in heights; more of it below
LETTER_MARGIN_RATIO = 0.35
BELOW = 0.35
TOUCHING_STROKES_MM = 0.05
MOST_INDEX_HEIGHT_RATIO = 0.95  # maximum height of an index, in heights of the letter before it
INDEX_FOOT_RANGE = (-0.8, 1.2)  # range of the foot of an index, in heights of its letter
LETTER_WIDTH_RATIO, SIGN_WIDTH_RATIO, NARROW_SIGNS = 0.7, 0.35, " .,:;′'’|()"  # widths of letters and signs, in heights
INDEX_GAP_RANGE = (-0.4, 0.5)  # range of its distance from its letter


def text_width_in_heights(text: str) -> float:
    """The approximate width of a text, in heights of its letters."""
    return sum(SIGN_WIDTH_RATIO if c in NARROW_SIGNS else LETTER_WIDTH_RATIO for c in text.strip())


def merge_word_pieces(words: Sequence[Words]) -> list[Words]:
    """Words written in several pieces, a letter and its indices, merged into one each."""
    out: list[tuple[Words, Words]] = []  # the first piece, and all of it
    for word in words:
        before = next(
            (k for k in range(len(out) - 1, max(len(out) - 3, -1), -1) if _continues_word(*out[k], word)), None
        )
        if before is None:
            out.append((word, word))
        else:
            first, all_of_it = out[before]
            end = ((word.place - first.place) * first.along.conjugate()).real + word.width
            text = all_of_it.text + word.text
            out[before] = first, Words(text, first.place, first.height, max(end, all_of_it.width), first.along)
    return [all_of_it for _, all_of_it in out]


def _continues_word(first: Words, so_far: Words, word: Words) -> bool:
    """Whether a piece of text is an index of the word before it, its second index, or the text after that."""
    local = (word.place - first.place) * first.along.conjugate()
    small = word.height < MOST_INDEX_HEIGHT_RATIO * first.height or word.text[:1] in "'′’,"
    level = INDEX_FOOT_RANGE[0] * first.height < local.imag < INDEX_FOOT_RANGE[1] * first.height
    along = abs(word.along - first.along) < 0.02 and any(
        INDEX_GAP_RANGE[0] * first.height < local.real - end < INDEX_GAP_RANGE[1] * first.height
        for end in (first.width, so_far.width)
    )
    return small and level and along


def remove_letter_strokes(sketch: ReadDrawing) -> None:
    """Removes strokes within the box of a word that touch nothing outside: the letters of that word."""
    if not sketch.strokes or not sketch.words:
        return
    every = sketch.strokes + sketch.short
    strokes = as_lines(every)
    tree = STRtree(strokes)
    long = length(strokes)
    letter = numpy.zeros(len(every), bool)
    for word in sketch.words:
        high = word.height
        over = LETTER_MARGIN_RATIO * word.height
        low = complex(-over, -over - BELOW * high)
        top = complex(word.width + over, high + 2 * over)
        ring = (low, complex(top.real, low.imag), top, complex(low.real, top.imag))
        around = (word.place + word.along * z for z in ring)
        inside = tree.query(polygons([(z.real, z.imag) for z in around]), predicate="covers")
        letter[inside[long[inside] < LONGEST_LETTER_STROKE_RATIO * high]] = True
    kept = (
        _is_touching_others(numpy.array(every), letter, [(h.tip, h.tip - h.way * h.length) for h in sketch.heads])
        | ~letter
    )
    count = len(sketch.strokes)
    sketch.strokes = [s for s, good in zip(sketch.strokes, kept[:count], strict=True) if good]
    sketch.short = [s for s, good in zip(sketch.short, kept[count:], strict=True) if good]


def _is_touching_others(ends: Complexes, inside: Booleans, heads: Strokes) -> Booleans:
    """Which strokes meet one that is no letter, or end within an arrowhead."""
    others = numpy.concatenate([_as_points(ends[~inside].ravel()), as_lines(heads)])
    touched = numpy.zeros(len(ends), bool)
    near = STRtree(others).query(_as_points(ends[inside].ravel()), predicate="dwithin", distance=TOUCHING_STROKES_MM)[0]
    touched[numpy.flatnonzero(inside)[near // 2]] = True
    return touched


def _as_points(places: Complexes) -> Any:  # shapely has no types for many points
    """Positions as points."""
    return points(places.real, places.imag)


def connected_parts(sketch: ReadDrawing, least_mm: float = SMALLEST_PART_MM) -> list[ReadDrawing]:
    """The sketch in connected pieces, those with most strokes first; pieces smaller than a plan are dropped."""
    if len(sketch.strokes) > MOST_STROKES_SPLIT or not (sketch := without_hatching(sketch)).strokes:
        return []
    shapes = [*as_lines(sketch.strokes), *(points(z.real, z.imag).buffer(r) for z, r in sketch.rounds)]
    islands = get_parts(union_all(buffer(shapes, CONNECTED_STROKES_MM / 2)))
    group = STRtree(islands).nearest(shapes)
    group = group[: len(sketch.strokes)]
    groups = [numpy.flatnonzero(group == k) for k in dict.fromkeys(group.tolist())]
    pieces = [_part_of_strokes(sketch, held.tolist(), least_mm) for held in groups if len(held) > 1]
    return sorted((p for p in pieces if p is not None), key=lambda p: -len(p.strokes))


def _part_of_strokes(sketch: ReadDrawing, held: list[int], least_mm: float) -> ReadDrawing | None:
    """Some of the strokes, each once, with the words and circles near them."""
    part = sketch.with_some_strokes({(sketch.strokes[k], sketch.end_with_head(k)): k for k in held}.values())
    strokes = part.strokes
    low, high = part.box
    if max((high - low).real, (high - low).imag) < least_mm or _is_table(strokes, high - low):
        return None
    far = _distances_to_strokes(strokes, [z for z, _ in sketch.rounds], among=True)
    rounds = [r for r, d in zip(sketch.rounds, far, strict=True) if d < MOST_PART_TO_CIRCLE_MM]
    far = _distances_to_strokes([*strokes, *((z, z + r) for z, r in rounds)], [w.middle for w in sketch.words])
    words = [w for w, d in zip(sketch.words, far, strict=True) if d < MOST_PART_TO_WORD_MM + w.width / 2]
    return replace(part, words=words, rounds=rounds)


def _is_table(strokes: Strokes, size: complex) -> bool:
    """Whether three or more strokes span the width, and three the height."""
    spans = [*map(vector_of, strokes)]
    across = sum(
        abs(abs(s.real) - size.real) < TOUCHING_STROKES_MM and abs(s.imag) < TOUCHING_STROKES_MM for s in spans
    )
    up = sum(abs(abs(s.imag) - size.imag) < TOUCHING_STROKES_MM and abs(s.real) < TOUCHING_STROKES_MM for s in spans)
    return across > 2 and up > 2


def _distances_to_strokes(strokes: Strokes, places: Sequence[complex], among: bool = False) -> Sequence[float]:
    """The distances of points from the nearest stroke; zero for those ``among`` them, such as a point of a plate."""
    lines = multilinestrings(as_lines(strokes))
    far: list[float] = distance(
        _as_points(numpy.array(places, complex)), lines.convex_hull if among else lines
    ).tolist()
    return far
