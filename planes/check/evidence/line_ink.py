"""The lines of a file with the interface of a sheet's ink: their ends, heads and texts are exact, not detected."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy

from planes.check.evidence.line_words import LineWords, words_among_names
from planes.check.evidence.sheet_ink import PX_PER_MM, SheetInk
from planes.check.reading.strokes import ReadDrawing, strokes_with_heads
from planes.geometry.arrays import Array, Booleans, Complexes, Indices
from planes.words.naming import Names

PAPER_MARGIN_MM = 30.0  # of paper around the lines
# response to a line turned by this angle (its cosine)
TURNED_LINE_RESPONSES = ((math.cos(0.25), 1.0), (math.cos(0.45), 0.5))
LINE_OFFSETS_MM = 1 / 3, 1 / 2, 5 / 6  # offset of felt lines: exactly there, and within one or two pixels
# pairs of lines; pieces: seven metres of lines at one pixel each
MOST_LINE_PAIRS_AT_ONCE = 1_000_000
MOST_PIECES = 20_000
# line ends and crossings a mm apart; with more of them per mm², any would match a mark
LEAST_CROWDED_PLACES = 60
CROWDED_PLACES_PER_MM2 = 0.03
HEADLESS_LINE_FACTOR = 0.5  # factor of a line without a head as a vector, where vectors have heads
HEAD_EVIDENCE_RANGE = -2.5, 2.5  # evidence against a missing head, and for one present
# maximum distance of a head from the end of its line; cosine of its direction
MOST_HEAD_TO_END_MM = 1.2
LEAST_HEAD_ALIGNMENT_COSINE = 0.97
MOST_LINES_FOR_CROSSINGS = 60  # maximum number of lines for crossings
LEAST_CROSSING_SINE = 0.1  # sine of their angle
MOST_STRAY_VECTOR_MM = 12.0  # limit for a vector outside the plan: there may be others beside it
EXPLAINED_VECTOR_SHARE = 0.9  # share of a vector explained for it to count as a whole
SHORTEST_LINE_WITH_HEAD_MM = 1.5  # of a line whose head is no evidence


class LineInk(SheetInk):
    """The lines of a drawing."""

    most_head = most_point = HEAD_EVIDENCE_RANGE[1]

    def __init__(self, sketch: ReadDrawing, names: Names) -> None:
        self.sketch = sketch
        self.names = names
        self.source = None
        self.lines: Complexes = numpy.array(sketch.strokes, complex).reshape(-1, 2)
        ends = self.lines.ravel()
        self.reach_mm = abs(complex(numpy.ptp(ends.real), numpy.ptp(ends.imag))) + PAPER_MARGIN_MM
        v: Complexes = self.lines[:, 1] - self.lines[:, 0]
        length: Array = numpy.abs(v)
        self.u: Complexes = v / length
        self.way = numpy.array([sketch.end_with_head(k) for k in range(len(v))])
        self.headed = bool(strokes_with_heads(sketch))
        self.plain = numpy.where((self.way == 0) & self.headed, HEADLESS_LINE_FACTOR, 1.0)
        self.points, self.ways, self.mm = self._line_pieces(length)
        ways = numpy.stack([-self.u, self.u], axis=1)
        tips = self.lines
        if self.headed:
            pointed = self.way[:, None] == [-1, 1]
            ways = ways[pointed]
            tips = tips[pointed]
        self.tips: Complexes = tips.ravel()
        self.tip_ways: Complexes = ways.ravel()
        if (
            not self.headed and len(self.lines) < MOST_LINES_FOR_CROSSINGS
        ):  # lines may extend beyond the ends of vectors
            k, j, met = crossings(self.lines)
            ways = numpy.concatenate([ways[k], ways[j]], axis=1).T
            self.tips = numpy.r_[self.tips, numpy.tile(met, 4)]
            self.tip_ways = numpy.r_[self.tip_ways, ways.ravel()]
        self.rounds: Complexes = numpy.array([z for z, _ in sketch.rounds], complex)
        self.exact = self.headed or bool(self.rounds.size)
        every = self.lines.ravel(), self.tips, self.rounds  # short vectors have no heads
        self.ends = numpy.unique(numpy.concatenate(every).round(2))

    @property
    def crowded_end_count(self) -> int:
        """The number of line ends and crossings, if these are so dense that anything would match."""
        _, _, met = crossings(self.lines)
        count = len(numpy.unique(numpy.r_[self.lines.ravel(), met].round(0)))
        area = float(numpy.ptp(self.lines.real) * numpy.ptp(self.lines.imag))
        if count > max(LEAST_CROWDED_PLACES, CROWDED_PLACES_PER_MM2 * area):
            return count
        return 0

    def drawn_shares(self, a: Complexes, b: Complexes, samples: int, about: int = 1) -> Array:
        """The drawn share of each line from a to b, as for a sheet's ink; less for headless lines under vectors."""
        ways, begun = (numpy.nan_to_num(z, posinf=0.0, neginf=0.0).ravel() for z in (b - a, a))
        shares = numpy.zeros(len(ways))
        step = max(MOST_LINE_PAIRS_AT_ONCE // len(self.lines), 1)
        for k in range(0, len(ways), step):
            shares[k : k + step] = self._line_shares_within(
                begun[k : k + step], ways[k : k + step], LINE_OFFSETS_MM[about]
            )
        return shares.reshape(a.shape)

    def _line_shares_within(self, a: Complexes, way: Complexes, aside: float) -> Array:
        """The share of each segment from a with a line within this offset."""
        length = numpy.maximum(abs(way), 1e-9)
        u = way / length
        turned = abs(u.real[:, None] * self.u.real + u.imag[:, None] * self.u.imag)
        asked, line = numpy.nonzero(turned > TURNED_LINE_RESPONSES[-1][0])
        p, q = (
            (self.lines[line, k] + on * aside * self.u[line] - a[asked]) * u[asked].conj()
            for k, on in ((0, -1), (1, 1))
        )
        off = numpy.where(abs(q.imag - p.imag) < 1e-9, 1e-9, q.imag - p.imag)  # where on the line the offset is reached
        one, two = ((side - p.imag) / off for side in (-aside, aside))
        first, last = shares = numpy.sort([one, two], axis=0).clip(0.0, 1.0)
        low, high = numpy.sort(p.real + (q.real - p.real) * shares, axis=0).clip(0.0, length[asked])
        kept = (first < last) & (low < high)
        asked = asked[kept]
        low = low[kept]
        high = high[kept]
        worth = (
            numpy.where(turned[asked, line[kept]] > TURNED_LINE_RESPONSES[0][0], 1.0, TURNED_LINE_RESPONSES[-1][1])
            * self.plain[line[kept]]
        )
        order = numpy.lexsort((low, asked))
        levels = numpy.unique(worth)
        drawn = numpy.zeros(len(a))
        asked = asked[order]
        low = low[order]
        high = high[order]
        worth = worth[order]
        for less, level in zip([0.0, *levels], levels, strict=False):
            drawn += (level - less) * _covered_lengths(asked, low, high, worth >= level, len(a))
        share: Array = drawn / length
        return share

    def _line_pieces(self, length: Array) -> tuple[Complexes, Complexes, Array]:
        """Pieces of the lines: middles, directions and lengths.

        Lines without heads need no explanation where vectors have them.
        """
        fine = min(PX_PER_MM, MOST_PIECES / float(length.sum()))
        counts = numpy.ceil(length * fine).astype(int).clip(1)
        line_of = numpy.repeat(numpy.arange(len(length)), counts)
        at = numpy.concatenate([(numpy.arange(n) + 0.5) / n for n in counts.tolist()])
        mm = numpy.where(self.headed & (self.way == 0), 0.0, length / counts)
        self.line_of = line_of
        return self.lines[line_of, 0] + at * (length * self.u)[line_of], self.u[line_of], mm[line_of]

    def _unexplained_mm(self, mm: Array, mine: Booleans, running: Booleans, kept: Booleans) -> float:
        """A vector is explained from end to end or not at all."""
        if not self.headed:
            return super()._unexplained_mm(mm, mine, running, kept)
        every, own = (numpy.bincount(self.line_of[kept], held, len(self.lines)) for held in (mm, mm * mine))
        return float(every[own < EXPLAINED_VECTOR_SHARE * every].clip(max=MOST_STRAY_VECTOR_MM).sum())

    def head_evidence(self, a: Complexes, b: Complexes) -> Array:
        """The evidence that a line ends at b: a tip there or, if no line has a head, an end."""
        length = abs(b - a)
        u = (b - a) / numpy.maximum(length, 1e-9)
        aside = (u[..., None] * self.tip_ways.conj()).real < LEAST_HEAD_ALIGNMENT_COSINE
        off = (abs(b[..., None] - self.tips) + MOST_HEAD_TO_END_MM * aside).min(axis=-1, initial=MOST_HEAD_TO_END_MM)
        return numpy.where(length > SHORTEST_LINE_WITH_HEAD_MM, _sign_evidence(off), 0.0)

    def head_states(self, a: Complexes, b: Complexes) -> Array:
        """Nothing: heads in files are judged by themselves."""
        return numpy.zeros(a.shape)

    def point_evidence(self, z: Complexes, roughly: bool = False) -> Array:
        """The evidence for a point at each position: a small circle there."""
        if not self.rounds.size:
            return numpy.zeros(z.shape)
        return _sign_evidence(abs(z[..., None] - self.rounds).min(axis=-1))

    def read_words(self, a: Complexes, b: Complexes, with_heads: bool, names: Iterable[str]) -> LineWords:
        """The texts that are some names."""
        return words_among_names(self.sketch, self.names, names)


def _covered_lengths(asked: Indices, low: Array, high: Array, held: Booleans, count: int) -> Array:
    """The total length covered on each line by the pieces held; they are in order."""
    asked = asked[held]
    low = low[held]
    high = high[held]
    if not asked.size:
        return numpy.zeros(count)
    apart = 1.0 + float(high.max())  # offset that keeps the pieces of different lines apart
    before = numpy.r_[-apart, numpy.maximum.accumulate(high + apart * asked)[:-1]] - apart * asked
    return numpy.asarray(numpy.bincount(asked, (high - numpy.maximum(low, before)).clip(min=0.0), count), float)


def crossings(lines: Complexes) -> tuple[Indices, Indices, Complexes]:
    """Pairs of lines that meet well inside both of them, and where."""
    k, j = numpy.triu_indices(len(lines), 1)
    v = (lines[:, 1] - lines[:, 0])[k]
    u = (lines[:, 1] - lines[:, 0])[j]
    off = lines[j, 0] - lines[k, 0]
    turn = (v.conj() * u).imag
    with numpy.errstate(all="ignore"):
        s = (off.conj() * u).imag / turn
        t = (off.conj() * v).imag / turn
        crossed = (abs(turn) > LEAST_CROSSING_SINE * abs(v * u)) & (s > 0) & (s < 1) & (t > 0) & (t < 1)
        places = lines[k, 0] + s * v
    return k[crossed], j[crossed], places[crossed]


def _sign_evidence(off: Array) -> Array:
    """The evidence of a sign at this distance."""
    low, high = HEAD_EVIDENCE_RANGE
    said: Array = high - (high - low) * numpy.minimum(off / MOST_HEAD_TO_END_MM, 1.0)
    return said
