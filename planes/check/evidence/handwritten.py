"""Handwritten names beside vectors: letters recognised by shape, words by the names of the plan.

A net classifies the shapes. A name far from its assumed vector is evidence against that vector, no more.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy

from planes.check.evidence.ink import Ink
from planes.check.evidence.letter_net import LETTER_SHAPES, letter_features, shape_log_probabilities
from planes.check.vision.image.opencv import connected_components, cv
from planes.geometry.arrays import Array, Greys
from planes.geometry.plane import off_segment
from planes.words.frozen import frozen
from planes.words.names import NumbersByName

SHAPES_OF_LETTER = {
    "I": "|1Ф",
    "1": "1|",
    "F": "FR",
    "0": "0D",
    "O": "0D",
    "p": "P",
    "τ": "t",
    "S": "5",
    "Q": "0",
    "C": "G",
}
SHAPES_OF_LETTER |= {"s": "5", "c": "G", "'": "|_*"}
"""For each letter, the shapes it may have besides its own."""
# smoothing of the paper's grain; neighbourhood of the darkest ink
GRAIN_SMOOTHING_MM = 0.12
DARKEST_INK_WINDOW_MM = 1.5
INK_THRESHOLD, LEAST_INK_THRESHOLD = 0.45, 0.3  # ink threshold relative to the darkest ink around, and to that of lines
SMALLEST_PIECE_MM, LARGEST_PIECE_MM = 0.5, 7.5  # of a piece of a letter
WIDE_PIECE_MM = 2.2  # a wider piece may be two letters
WIDEST_LETTER_MM = 5.0  # no letter is wider
# maximum distance between letters of a word; maximum height of a word
MOST_LETTER_GAP_MM = 2.0
MOST_WORD_HEIGHT_MM = 6.5
# search distance of names from lines; width of a line's ink to the side
NAME_SEARCH_DISTANCE_MM = 15.0
ERASED_LINE_SIDE_MM = 0.35
HEAD_HALF_WIDTH_RATIO = 0.3  # half width of a head, relative to its length
# maximum number of pieces: of a letter, of a word, in all
MOST_PIECES_PER_LETTER = 3
MOST_PIECES_PER_WORD = 16
MOST_PIECES_ON_SHEET = 400
# a stray piece, a missing letter, one more piece
STRAY_PIECE_LOG_PROB = math.log(0.06)
MISSING_LETTER_LOG_PROB = math.log(0.04)
EXTRA_PIECE_LOG_PROB = math.log(0.7)
# minimum probability of a shape; odds that a word is none of the names
LEAST_SHAPE_LOG_PROB = math.log(1e-3)
OTHER_WORD_LOG_ODDS = 0.7
NAME_ASSIGNMENT_ROUNDS = 8  # iterations that assign words to names
LOG_PROB_TEMPERATURE = 1.2  # divisor of logarithms, for calibration: readings at 90 % are right in 90 %
MOST_NAME_TO_POINT_MM = 7.0  # maximum distance of a name from its point
# of a name from its vector; softness; probability of a name elsewhere
NAME_TO_VECTOR_MM = 3.5
NAME_DISTANCE_SOFTNESS_MM = 2.0
DISTANT_NAME_PROBABILITY = 0.08


@frozen
class HandWord:
    """A row of letters: its position, mm, and its probability for each name."""

    low: complex
    high: complex
    likely: NumbersByName

    def distance_to_segment(self, a: complex, b: complex) -> float:
        """The distance of the word's middle line from the segment from a to b."""
        middle = (self.low + self.high) / 2
        spots = (complex(x, middle.imag) for x in (self.low.real, middle.real, self.high.real))
        return min(off_segment(z, a, b) for z in spots)


@dataclass
class HandWords:
    """The words on a sheet as evidence for vectors; answers are cached."""

    words: Sequence[HandWord] = ()
    known: dict[tuple[str, complex, complex], float] = field(default_factory=dict)

    def vector_name_cost(self, name: str, a: complex, b: complex) -> float:
        """The cost of assuming that the vector of a name runs from a to b, from the position of that name."""
        if (key := (name, a, b)) not in self.known:
            read = [(w.likely.get(name, 0.0), w.distance_to_segment(a, b)) for w in self.words]
            near = sum(
                p
                * max(
                    math.exp(-0.5 * max((off - NAME_TO_VECTOR_MM) / NAME_DISTANCE_SOFTNESS_MM, 0.0) ** 2),
                    DISTANT_NAME_PROBABILITY,
                )
                for p, off in read
            )
            total = sum(p for p, _ in read)
            self.known[key] = -math.log(max(1 - total, 0.0) + near / max(total, 1.0))
        return self.known[key]

    def total_name_cost(self, rows: Iterable[tuple[str, complex, complex]]) -> float:
        """The cost of assuming these ends of named vectors."""
        return sum(self.vector_name_cost(n, a, b) for n, a, b in rows)

    def name_probability_at(self, name: str, z: complex) -> float:
        """The probability of a name beside a point."""
        return max(
            (one.likely.get(name, 0.0) for one in self.words if one.distance_to_segment(z, z) < MOST_NAME_TO_POINT_MM),
            default=0.0,
        )


@frozen
class LetterPiece:
    """A piece of ink that may be a letter or part of one: its box in pixels and a mask of its ink."""

    left: int
    top: int
    right: int
    bottom: int
    mask: Greys


@frozen
class Erased:
    """A drawn line, not a letter: its path in mm, its width, and its heads (tip, and vector back to the rear)."""

    path: Sequence[complex]
    width_mm: float
    heads: Sequence[tuple[complex, complex]] = ()


def read_words_beside_lines(ink: Ink, lines: Sequence[Erased], names: Iterable[str]) -> HandWords:
    """The words around some lines of a sheet, with their probabilities for some names."""
    known = tuple(names)
    flat = ink.flat
    hand_words = list[HandWord]()
    for row in _rows_of_pieces(_letter_pieces(ink, lines), flat.scale):
        shapes = _shape_log_probabilities(ink.dark, row, WIDEST_LETTER_MM * flat.scale)
        scores = numpy.array([_name_log_probability(len(row), shapes, name) for name in (*known, "")])
        scores[-1] += OTHER_WORD_LOG_ODDS
        odds = numpy.exp((scores - scores.max()) / LOG_PROB_TEMPERATURE)
        low = flat.px_to_mm(row[0].left, max(p.bottom for p in row))
        high = flat.px_to_mm(row[-1].right, min(p.top for p in row))
        hand_words.append(HandWord(low, high, dict(zip(known, (odds / odds.sum()).tolist(), strict=False))))
    return HandWords(_use_each_name_once(hand_words, known))


def _use_each_name_once(words: Sequence[HandWord], names: Sequence[str]) -> list[HandWord]:
    """The words with each name used only once: the more certain a name is for another word, the less for this one."""
    likely = numpy.array([[word.likely[name] for name in names] for word in words]).reshape(len(words), len(names))
    none = 1 - likely.sum(axis=1, keepdims=True)
    for _ in range(NAME_ASSIGNMENT_ROUNDS):
        likely = likely / numpy.maximum(likely.sum(axis=0), 1.0)
        totals = likely.sum(axis=1, keepdims=True) + none
        likely = likely / totals
        none = none / totals
    return [
        replace(w, likely=dict(zip(names, row, strict=True))) for w, row in zip(words, likely.tolist(), strict=True)
    ]


def _letter_pieces(ink: Ink, lines: Sequence[Erased]) -> list[LetterPiece]:
    """Pieces of ink off the lines of a sheet, but not far from them."""
    scale = ink.flat.scale
    labels, stats = connected_components(_ink_off_lines(ink, lines))
    letters: list[LetterPiece] = []
    for k, (x, y, w, h, _) in enumerate(stats.tolist()):
        if k and SMALLEST_PIECE_MM * scale < max(w, h) < LARGEST_PIECE_MM * scale:
            mask = (labels[y : y + h, x : x + w] == k).astype(numpy.uint8)
            letters += _split_wide_piece(LetterPiece(x, y, x + w, y + h, mask), WIDE_PIECE_MM * scale)
    return letters if len(letters) < MOST_PIECES_ON_SHEET else []


def _ink_off_lines(ink: Ink, lines: Sequence[Erased]) -> Greys:
    """Ink near lines that does not belong to them."""
    cv2 = cv()
    flat = ink.flat
    dark = cv2.GaussianBlur(ink.dark, (0, 0), GRAIN_SMOOTHING_MM * flat.scale)
    about = numpy.ones((round(DARKEST_INK_WINDOW_MM * flat.scale),) * 2, numpy.uint8)
    middles = numpy.array([x.path[len(x.path) // 2] for x in lines])
    least = numpy.maximum(
        INK_THRESHOLD * cv2.dilate(dark, about), LEAST_INK_THRESHOLD * float(numpy.median(ink.darkest_around(middles)))
    )
    near = numpy.zeros_like(dark)
    bent = [numpy.array([flat.mm_to_px(z) for z in x.path]).round().astype(numpy.int32) for x in lines]
    cv2.polylines(near, bent, False, 1, round(2 * NAME_SEARCH_DISTANCE_MM * flat.scale))
    for line, path in zip(lines, bent, strict=True):
        cv2.polylines(near, [path], False, 0, max(1, round((line.width_mm + ERASED_LINE_SIDE_MM) * flat.scale)))
        for tip, back in line.heads:
            sides = [
                flat.mm_to_px(tip + back * off)
                for off in (0.0, 1 + HEAD_HALF_WIDTH_RATIO * 1j, 1 - HEAD_HALF_WIDTH_RATIO * 1j)
            ]
            cv2.fillConvexPoly(near, numpy.array(sides).round().astype(numpy.int32), 0)
    ink_off_lines: Greys = near * (dark > least)
    return ink_off_lines


def _split_wide_piece(piece: LetterPiece, wide: float) -> list[LetterPiece]:
    """A wide piece split (recursively) where it has least ink: touching letters."""
    h, w = piece.mask.shape
    if w < wide or h < w / 4:
        return [piece]
    k = round(w / 4) + int(piece.mask[:, round(w / 4) : round(3 * w / 4)].sum(axis=0).argmin())
    at = piece.left + k
    halves = replace(piece, right=at, mask=piece.mask[:, :k]), replace(piece, left=at, mask=piece.mask[:, k:])
    return [part for half in halves for part in _split_wide_piece(half, wide)]


def _rows_of_pieces(pieces: Iterable[LetterPiece], scale: float) -> list[list[LetterPiece]]:
    """Adjacent pieces, from left to right."""
    rows: list[list[LetterPiece]] = []
    for one in sorted(pieces, key=lambda p: p.left + p.right):
        near = [
            r
            for r in rows
            if len(r) < MOST_PIECES_PER_WORD and one.left - max(p.right for p in r) < MOST_LETTER_GAP_MM * scale
        ]
        near = [
            r
            for r in near
            if max(p.bottom for p in (*r, one)) - min(p.top for p in (*r, one)) < MOST_WORD_HEIGHT_MM * scale
        ]
        row = min(near, key=lambda r: abs(one.top + one.bottom - r[-1].top - r[-1].bottom), default=None)
        if row is None:
            rows.append(row := [])
        row.append(one)
    return rows


def _shape_log_probabilities(dark: Greys, row: Sequence[LetterPiece], widest: float) -> dict[tuple[int, int], Array]:
    """The log probabilities of each shape for consecutive pieces, from one to before another, as one letter."""
    spans = [(i, j) for i in range(len(row)) for j in range(i + 1, min(i + MOST_PIECES_PER_LETTER, len(row)) + 1)]
    spans = [(i, j) for i, j in spans if j == i + 1 or max(p.right for p in row[i:j]) - row[i].left < widest]
    seen = shape_log_probabilities(
        numpy.array([letter_features(_joined_letter_picture(dark, row[i:j])) for i, j in spans])
    )
    return dict(zip(spans, seen.clip(LEAST_SHAPE_LOG_PROB), strict=True))


def _joined_letter_picture(dark: Greys, pieces: Sequence[LetterPiece]) -> Greys:
    """The picture of pieces as one letter."""
    left = min(p.left for p in pieces)
    top = min(p.top for p in pieces)
    page = numpy.zeros((max(p.bottom for p in pieces) - top, max(p.right for p in pieces) - left), numpy.uint8)
    for p in pieces:
        page[p.top - top : p.bottom - top, p.left - left : p.right - left] |= p.mask
    x, y, w, h = cv().boundingRect(page)
    return (dark[top:, left:][: len(page), : page.shape[1]] * page)[y : y + h, x : x + w]


def _name_log_probability(count: int, shapes: Mapping[tuple[int, int], Array], name: str) -> float:
    """The log probability that this many pieces in a row are a name: its letters in order, and stray pieces."""
    ways = [
        [LETTER_SHAPES.index(c) for c in SHAPES_OF_LETTER.get(char, char) if c in LETTER_SHAPES]
        for char in name
        if char not in "_^"
    ]
    best = {(0, k): MISSING_LETTER_LOG_PROB * k for k in range(len(ways) + 1)}
    for j in range(1, count + 1):
        stray = max(float(shapes[j - 1, j][[LETTER_SHAPES.index("_"), -1]].max()), STRAY_PIECE_LOG_PROB)
        for k in range(len(ways) + 1):
            scores = [best[j - 1, k] + stray, *([best[j, k - 1] + MISSING_LETTER_LOG_PROB] if k else [])]
            for i in range(max(0, j - MOST_PIECES_PER_LETTER), j) if k and ways[k - 1] else ():
                if (i, j) in shapes:
                    scores.append(
                        best[i, k - 1] + float(shapes[i, j][ways[k - 1]].max()) + EXTRA_PIECE_LOG_PROB * (j - i - 1)
                    )
            best[j, k] = max(scores)
    return best[count, len(ways)]
