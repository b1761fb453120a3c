"""The ink of one sheet, queried by lines: the drawn share from a to b, a head at b, and the ink left unexplained (mm).

Ink is detected by a bank of ridge filters, one for each direction (steerable filters: Freeman and Adelson, IEEE PAMI
13, 1991). Points are complex numbers, mm of the sheet, y up; lines are arrays of their ends, one row per drawing.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from functools import cached_property
from typing import NamedTuple

import numpy
from shapely import LineString, box

from planes.check.evidence.handwritten import Erased, HandWords, read_words_beside_lines
from planes.check.evidence.ink import Ink, drawing_ink
from planes.check.vision.image.opencv import connected_components, cv, resize_by_factor
from planes.check.vision.image.picture import Flat
from planes.geometry.arrays import Array, Booleans, Complexes, Indices

PX_PER_MM = 3.0  # of the reduced picture for ink detection
LINE_DIRECTIONS = 16  # directions of detection over half a turn
# of the filter: σ along, σ across, radius
FILTER_SIGMA_ALONG_PX = 2.6
FILTER_SIGMA_ACROSS_PX = 1.0
FILTER_RADIUS_PX = 7
# responses, relative to a clear line, for a line fully there, and not at all
FULL_LINE_RESPONSE = 0.60
NO_LINE_RESPONSE = 0.15
# quantiles of the strong responses, from clear lines; the minimum
CLEAR_RESPONSE_QUANTILE = 0.6
STRONG_RESPONSE_QUANTILE = 0.99
LEAST_STRONG_RESPONSE = 0.02
LEAST_RIDGE_RESPONSE = 0.45  # share of it that makes a ridge
LEAST_INK_DARKNESS = 0.25  # of full darkness, ink
LARGEST_LETTER_MM = 9.0  # smaller pieces of ink are letters: they explain nothing and need no explanation
CLEAR_LINE_DARKNESS = 180.0  # darkness of a clear line relative to paper, of 255
LINE_INK_OFFSET_MM, LINE_INK_SINE = 0.8, 0.3  # offset and sine of the angle within which ink belongs to a line
LINE_ANGLE_TOLERANCE_RAD = 0.004  # angular tolerance of a drawn line, radians
# extension of construction lines; weight of it as unexplained ink
EXTENSION_BEFORE_START_MM = 10.0
EXTENSION_BEYOND_END_MM = 22.0
EXTENSION_INK_WEIGHT = 0.55
POLE_CROSS_RADIUS_MM = 3.2  # around the pole's printed cross, ink needs no explanation
# from a line's end, where a head is wider than its line; behind it
HEAD_ZONE_MM = (1.6, 4.0)
BEHIND_HEAD_ZONE_MM = (5.5, 7.5)
HEAD_SAMPLE_OFFSETS_MM, STEP_MM = (-0.85, -0.6, 0.6, 0.85), 0.4  # where beside a line its head is felt
SHORTEST_LINE_WITH_HEAD_MM = 9.0  # of a line whose head is felt
# darkness beside a headless line; factor to evidence
LEAST_HEAD_DARKNESS = 0.12
HEAD_EVIDENCE_FACTOR = 6.0
HEAD_EVIDENCE_RANGE = (-1.2, 1.8)
DRAWN_LINE_WIDTH_MM, USUAL_HEAD_LENGTH_MM = 0.8, 4.0  # of a drawn line, as opposed to a letter
WING_OFFSETS_MM, NARROW_WING_OFFSETS_MM = (0.55, 0.7, 0.85, 1.0), (0.35, 0.45)  # off a line, and near it
# of another line's ink, and of its head
OTHER_LINE_HALF_WIDTH_MM = 0.6
OTHER_HEAD_LENGTH_MM = 5.0
OTHER_HEAD_HALF_WIDTH_MM = 1.5
# Beside an end without a head: the most darkness, that over the line behind it, also near the line, and by how much the
# other end is darker. Points that tell, for both ends and for one. Of 419 heads none on a sheet called right is so.
(
    MOST_HEADLESS_DARKNESS,
    MOST_HEADLESS_EXCESS,
    MOST_HEADLESS_NEAR_DARKNESS,
    LEAST_REVERSED_EXCESS,
    LEAST_WING_POINTS_TWO_ENDS,
    LEAST_WING_POINTS_ONE_END,
) = 0.14, 0.08, 0.1, 0.12, 16, 44
# radii of the circles and dots of points; half the width of the ring they are sought on, and darkness that is ink
POINT_RADII_MM = (0.7, 1.0, 1.3, 1.6, 2.0)
POINT_RING_MM = 0.2
POINT_INK_DARKNESS = 0.35
# share of such a ring in ink: at points of schemes (87 by other means) it is larger at 85 %, elsewhere at 6 % of 418
USUAL_POINT_SHARE = 0.6
NEAR_POINT_PX = 3  # from a trial place to a point, half a step of the trials
POINT_EVIDENCE_FACTOR = 8.0
POINT_EVIDENCE_RANGE = (-1.6, 2.8)
# darkness of the palest vectors, relative to the others of a drawing: one of 363 is paler
PALEST_VECTOR_DARKNESS = 0.67
GAP_STEP_MM = 0.5  # step along a line
MISSING_LINE_SHARE = 0.25  # share below which a line is missing
SHORTEST_EXPLAINING_LINE_MM = 1.0  # of a line that explains ink
# of lines that belong to the paper: see below
PAPER_LINE_ANGLES = 720
PAPER_LINE_SINE = 0.2
LEAST_PAPER_LINE_SHARE = 0.6
SHORTEST_PAPER_LINE_MM = 120.0


class Box(NamedTuple):
    """A part of a sheet by two of its corners."""

    low: complex
    high: complex

    def holds(self, z: Complexes) -> Booleans:
        """Which points lie in it."""
        held: Booleans = (z.real > self.low.real) & (z.real < self.high.real)
        return held & (z.imag > self.low.imag) & (z.imag < self.high.imag)


class SheetInk:
    """The ink of one sheet. ``dark``: 0 for paper, 1 for a clear line, ``PX_PER_MM`` pixels per millimetre.

    Its lower left corner is at ``corner``, its upper edge ``high_mm`` above.
    """

    reach_mm = 0.0  # spacing of its lines, where it is known to be all of one drawing
    exact = False  # whether its lines and their heads are exact, not detected
    ends: Complexes = numpy.zeros(0, complex)  # of its lines, where known
    # maximum evidence for a head, and for a point of a scheme
    most_head = HEAD_EVIDENCE_RANGE[1]
    most_point = POINT_EVIDENCE_RANGE[1]
    _usual_darkness = 1.0  # of ink, relative to paper, where pictures show it

    def __init__(self, dark: Array, corner: complex, high_mm: float, source: Ink | None = None) -> None:
        self.source = source  # the ink it was made from, with its letters
        self.top = corner.imag + high_mm
        self.corner = corner
        self.height, self.width = dark.shape
        felt = numpy.stack(
            [cv().filter2D(dark, -1, _ridge_filter(math.pi * k / LINE_DIRECTIONS)) for k in range(LINE_DIRECTIONS)]
        )
        most = felt.max(axis=0)
        way = felt.argmax(axis=0)
        strong = most[most > max(float(numpy.quantile(most, STRONG_RESPONSE_QUANTILE)), LEAST_STRONG_RESPONSE)]
        plain = float(numpy.quantile(strong, CLEAR_RESPONSE_QUANTILE)) if strong.size else 1.0
        share = (
            numpy.clip((felt / plain - NO_LINE_RESPONSE) / (FULL_LINE_RESPONSE - NO_LINE_RESPONSE), 0, 1) * 255
        ).astype(numpy.uint8)
        # drawn share of a line by direction, row and column: exactly there, within a third of a mm, within two thirds
        wider = (numpy.stack([cv().dilate(s, numpy.ones((n, n))) for s in share]).ravel() for n in (3, 5))
        self.shares = (share.ravel(), *wider)
        ridge = (most > LEAST_RIDGE_RESPONSE * plain) & _ridge_pixels(most, way) & _pixels_of_large_pieces(dark)
        rows, columns = numpy.nonzero(ridge)
        turn = math.pi * way[rows, columns] / LINE_DIRECTIONS
        self.points: Complexes = corner.real + (columns + 0.5) / PX_PER_MM + 1j * (self.top - (rows + 0.5) / PX_PER_MM)
        self.ways: Complexes = numpy.exp(-1j * turn)
        self.mm: Array = 1 / numpy.maximum(abs(numpy.cos(turn)), abs(numpy.sin(turn))) / PX_PER_MM  # of line, per point
        self.mm[self._is_on_paper_line()] = 0.0
        self.mm *= self._ink_point_weights()
        usual = float(numpy.quantile(dark[ridge], 0.5)) if ridge.any() else 1.0
        self.even = numpy.minimum(dark / max(usual, 0.05), 1.0).ravel()

    @classmethod
    def of_picture(cls, flat: Flat) -> SheetInk:
        """From a rectified picture."""
        ink = drawing_ink(flat)
        share = PX_PER_MM / flat.scale
        dark = ((255.0 - ink.even) / CLEAR_LINE_DARKNESS).astype(numpy.float32)
        return cls(resize_by_factor(dark, share), flat.corner, flat.size_mm[1], ink)

    def _pixel_indices(self, z: Complexes) -> tuple[Indices, Booleans]:
        """Indices of points in the flattened picture, and which are on it.

        Points of impossible lines are NaN, and nowhere.
        """
        x = (z.real - self.corner.real) * PX_PER_MM
        y = (self.top - z.imag) * PX_PER_MM
        inside = (x > -1) & (y > -1) & (x < self.width) & (y < self.height)
        column, row = (numpy.where(inside, part, 0.0).astype(numpy.int32) for part in (x, y))
        return row * self.width + column, inside

    def _is_on_paper_line(self) -> Booleans:
        """Points on lines from edge to edge of the sheet, such as folds and ruling.

        These are found by their angle and their distance from the middle (Duda and Hart, Comm. ACM 15, 1972).
        """
        half = complex(self.width, self.height) / PX_PER_MM / 2
        z = self.points - (self.corner.real + half.real + 1j * (self.top - half.imag))
        own = self.mm > math.inf
        bins = math.ceil(abs(half)) * 2 + 1
        for k in range(PAPER_LINE_ANGLES):
            u = complex(math.cos(math.pi * k / PAPER_LINE_ANGLES), math.sin(math.pi * k / PAPER_LINE_ANGLES))
            near = numpy.flatnonzero(abs((self.ways * u.conjugate()).imag) < PAPER_LINE_SINE)
            off = (z[near] * u.conjugate()).imag
            at = numpy.rint(off + bins // 2).astype(numpy.int32)
            there = numpy.bincount(at, self.mm[near], bins)
            for line in numpy.flatnonzero(there > SHORTEST_PAPER_LINE_MM).tolist():
                if there[line] > LEAST_PAPER_LINE_SHARE * _chord_mm(half, u, line - bins // 2):
                    own[near[abs(off - (line - bins // 2)) < LINE_INK_OFFSET_MM]] = True
        return own

    def _ink_point_weights(self) -> Array:
        """The weight of each point as ink that needs an explanation: pale lines are construction, or rubbed out."""
        if self.source is None or not self.points.size:
            return numpy.ones(len(self.points))
        dark = self.source.darkest_around(self.points)
        self._usual_darkness = max(float(numpy.median(dark)), 1.0)
        firm: Array = numpy.minimum(dark / (PALEST_VECTOR_DARKNESS * self._usual_darkness), 1.0)
        return firm

    def drawn_shares(self, a: Complexes, b: Complexes, samples: int, about: int = 1) -> Array:
        """The drawn share of each line from a to b, 0 to 1, from ``samples`` points within ``about`` pixels.

        For pixels see :data:`PX_PER_MM`.
        """
        way = b - a
        share = (numpy.arange(samples) + 0.5) / samples
        k = (
            numpy.rint(-numpy.nan_to_num(numpy.angle(way)) / math.pi * LINE_DIRECTIONS).astype(numpy.int32)
            % LINE_DIRECTIONS
        )
        at, inside = self._pixel_indices(a[..., None] + way[..., None] * share)
        felt = self.shares[about][at + (k * (self.height * self.width))[..., None]]
        drawn: Array = numpy.where(inside, felt, 0).mean(axis=-1) / 255.0
        return drawn

    def longest_gap(self, a: complex, b: complex) -> float:
        """The longest gap in a line from a to b, mm."""
        share = numpy.linspace(0.0, 1.0, max(int(abs(b - a) / GAP_STEP_MM), 1) + 1)
        places: Complexes = (a + (b - a) * share).astype(numpy.complex128)
        drawn = numpy.r_[True, self.drawn_shares(places[:-1], places[1:], 2, 2) > MISSING_LINE_SHARE, True]
        return float(numpy.diff(numpy.flatnonzero(drawn)).max() - 1) * GAP_STEP_MM

    def head_evidence(self, a: Complexes, b: Complexes) -> Array:
        """The evidence for a head at b of each line from a, in :data:`HEAD_EVIDENCE_RANGE`; 0 for short ones."""
        length = abs(b - a)
        back = (a - b) / numpy.maximum(length, 1e-9)
        there, behind = (
            self._mean_darkness_beside_lines(b, back, mm, HEAD_SAMPLE_OFFSETS_MM)[1].mean(axis=-1)
            for mm in (HEAD_ZONE_MM, BEHIND_HEAD_ZONE_MM)
        )
        felt = numpy.clip((there - behind - LEAST_HEAD_DARKNESS) * HEAD_EVIDENCE_FACTOR, *HEAD_EVIDENCE_RANGE)
        return numpy.where(length > SHORTEST_LINE_WITH_HEAD_MM, felt, 0.0)

    def head_states(self, a: Complexes, b: Complexes) -> Array:
        """Whether each line of one drawing has a head at b (1), has none there (-1), or has it at a instead (-2).

        Where another line or its head may be, nothing is seen (0).
        """
        here, over, points = self._darkness_beside_ends(a, b)
        start, there, other_points = self._darkness_beside_ends(a, b, back=True)
        _, narrow, _ = self._darkness_beside_ends(a, b, NARROW_WING_OFFSETS_MM)
        turned = (
            (over < MOST_HEADLESS_EXCESS)
            & (there - over > LEAST_REVERSED_EXCESS)
            & (numpy.minimum(points, other_points) >= LEAST_WING_POINTS_TWO_ENDS)
        )
        none = turned | (here < MOST_HEADLESS_DARKNESS) & (narrow < MOST_HEADLESS_NEAR_DARKNESS) & (
            points >= LEAST_WING_POINTS_ONE_END
        )
        shown = ~none & (over > LEAST_REVERSED_EXCESS) & (points >= LEAST_WING_POINTS_TWO_ENDS)
        reversed_ = (
            turned
            & (here < MOST_HEADLESS_DARKNESS)
            & (start - here > LEAST_REVERSED_EXCESS)
            & (there > LEAST_REVERSED_EXCESS)
        )
        return numpy.where(abs(b - a) > SHORTEST_LINE_WITH_HEAD_MM, shown * 1.0 - none - reversed_, 0.0)

    def _darkness_beside_ends(
        self, a: Complexes, b: Complexes, off_mm: Sequence[float] = WING_OFFSETS_MM, back: bool = False
    ) -> tuple[Array, Array, Array]:
        """Darkness beside each line at its end (``back``: start), that over the line behind, and points that tell."""
        length = abs(b - a)
        zones = []
        way = (b - a) / numpy.maximum(length, 1e-9)
        tip, inward = (a, way) if back else (b, -way)
        ends = numpy.stack([a, b]), numpy.stack([b, a])
        upon = (
            numpy.minimum(*(abs(z[..., None] - ends[0][:, None]).sum(axis=0) for z in ends))
            < 2 * OTHER_LINE_HALF_WIDTH_MM
        )
        for mm in (HEAD_ZONE_MM, BEHIND_HEAD_ZONE_MM):
            z, dark = self._mean_darkness_beside_lines(tip, inward, mm, numpy.outer((-1, 1), off_mm))
            q = (z[..., None] - a) * way.conj()  # by line, point and other line
            line = (
                (abs(q.real - length / 2) < length / 2 + SHORTEST_EXPLAINING_LINE_MM)
                & (abs(q.imag) < OTHER_LINE_HALF_WIDTH_MM)
                & ~upon[:, None]
            )
            head = (abs(q.real - length + OTHER_HEAD_LENGTH_MM / 2) < OTHER_HEAD_LENGTH_MM / 2) & (
                abs(q.imag) < OTHER_HEAD_HALF_WIDTH_MM
            )
            free = ~(
                (line | head) & (length > SHORTEST_EXPLAINING_LINE_MM) & ~numpy.eye(len(a), dtype=bool)[:, None]
            ).any(axis=2)
            zones.append(((dark * free).sum(axis=1), free.sum(axis=1)))
        (ink, points), (behind, others) = zones
        ink = ink / numpy.maximum(points, 1)
        return ink, ink - behind / numpy.maximum(others, 1), points

    def point_evidence(self, z: Complexes, roughly: bool = False) -> Array:
        """The evidence for a circle or a dot at positions, or near them, in :data:`POINT_EVIDENCE_RANGE`."""
        at, inside = self._pixel_indices(z)
        share = numpy.where(inside, self._ink_around_points[roughly][at], 0.0)
        return numpy.clip((share - USUAL_POINT_SHARE) * POINT_EVIDENCE_FACTOR, *POINT_EVIDENCE_RANGE)

    @cached_property
    def _ink_around_points(self) -> tuple[Array, Array]:
        """The largest share of a ring about each pixel that is ink, of lines or of small pieces, as letters are; and
        about the pixels near each."""
        dark = self.even.reshape(self.height, self.width)
        if self.source is not None:
            dark = resize_by_factor(self.source.dark, PX_PER_MM / self.source.flat.scale) / self._usual_darkness
        dark = (dark > POINT_INK_DARKNESS).astype(numpy.float32)
        reach = math.ceil(POINT_RADII_MM[-1] * PX_PER_MM) + 2
        y, x = numpy.mgrid[-reach : reach + 1, -reach : reach + 1] / PX_PER_MM
        rings = (numpy.exp(-(((numpy.hypot(x, y) - r) / POINT_RING_MM) ** 2)) for r in POINT_RADII_MM)
        shares = [cv().filter2D(dark, -1, (ring / ring.sum()).astype(numpy.float32)) for ring in rings]
        there = numpy.max(shares, axis=0)
        return there.ravel(), cv().dilate(there, numpy.ones((2 * NEAR_POINT_PX + 1,) * 2)).ravel()

    def _mean_darkness_beside_lines(
        self, tip: Complexes, inward: Complexes, mm: tuple[float, float], off_mm: Sequence[float] | Array
    ) -> tuple[Complexes, Array]:
        """Points beside lines, at distances back from their ends, and their darkness."""
        back, off = (z.ravel() for z in numpy.meshgrid(numpy.arange(*mm, STEP_MM), off_mm))
        z = tip[..., None] + inward[..., None] * (back - 1j * off)
        at, inside = self._pixel_indices(z)
        return z, numpy.where(inside, self.even[at], 0.0)

    def read_words(self, a: Complexes, b: Complexes, headed: bool, names: Iterable[str]) -> HandWords:
        """The words around some lines, with their probabilities for some names; none without letters."""
        if self.source is None or not a.size:
            return HandWords()
        lines = []
        for start, end in zip(a.tolist(), b.tolist(), strict=True):
            way = (end - start) / max(abs(end - start), 1e-9)
            heads = [(end, -USUAL_HEAD_LENGTH_MM * way)] if headed else []
            lines.append(Erased([start, (start + end) / 2, end], DRAWN_LINE_WIDTH_MM, heads))
        return read_words_beside_lines(self.source, lines, names)

    def unexplained_ink_mm(
        self, a: Complexes, b: Complexes, box: Box, pole: complex, loose_mm: float, signs: Complexes, reach: Array
    ) -> Array:
        """mm of ink in a box that no line of each row explains (within ``loose_mm``), nor any sign (centre, radius).

        The continuation of a line counts in part.
        """
        kept = box.holds(self.points) & (abs(self.points - pole) > POLE_CROSS_RADIUS_MM)
        z = self.points[kept]
        ways = self.ways[kept]
        mm = self.mm[kept]
        rows = numpy.round(numpy.stack([a, b], axis=-1), 2).reshape(-1, 2)
        lines, which = numpy.unique(rows, axis=0, return_inverse=True)
        own, near = numpy.zeros((2, len(lines), len(z)), bool)
        for k, (start, end) in enumerate(lines):
            length = abs(end - start)
            if SHORTEST_EXPLAINING_LINE_MM < length < math.inf:
                u = (end - start).conjugate() / length
                q = (z - start) * u
                beside = (abs(q.imag) < LINE_INK_OFFSET_MM + loose_mm + LINE_ANGLE_TOLERANCE_RAD * length) & (
                    abs((ways * u).imag) < LINE_INK_SINE
                )
                own[k] = beside & (q.real > -1) & (q.real < length + 1)
                near[k] = beside & (q.real > -EXTENSION_BEFORE_START_MM) & (q.real < length + EXTENSION_BEYOND_END_MM)
        left = numpy.zeros(len(a))
        for n, ks in enumerate(which.reshape(a.shape)):
            sign = (abs(z[:, None] - signs[n]) < reach).any(axis=1)
            mine = own[ks].any(axis=0) | sign
            running = near[ks].any(axis=0) | sign
            left[n] = self._unexplained_mm(mm, mine, running, kept)
        return left

    def _unexplained_mm(self, mm: Array, mine: Booleans, running: Booleans, kept: Booleans) -> float:
        """The ink left over by lines it is ``mine`` of, and by those it only continues."""
        return float(mm[~running].sum() + EXTENSION_INK_WEIGHT * mm[running & ~mine].sum())


def _ridge_filter(angle: float) -> Array:
    """A filter for a thin line at an angle (of a picture, y down): long along it, a Mexican hat across."""
    x, y = numpy.meshgrid(*[numpy.arange(-FILTER_RADIUS_PX, FILTER_RADIUS_PX + 1)] * 2)
    along = x * math.cos(angle) + y * math.sin(angle)
    across = y * math.cos(angle) - x * math.sin(angle)
    hat = (1 - (across / FILTER_SIGMA_ACROSS_PX) ** 2) * numpy.exp(-0.5 * (across / FILTER_SIGMA_ACROSS_PX) ** 2)
    weight = numpy.exp(-0.5 * (along / FILTER_SIGMA_ALONG_PX) ** 2) * hat
    weight -= weight.mean()
    made: Array = (weight / abs(weight).sum()).astype(numpy.float32)
    return made


def _chord_mm(half: complex, u: complex, off: float) -> float:
    """The chord of a rectangle about its middle, in the direction u, ``off`` to the left."""
    ends = ((off * 1j + sign * abs(half)) * u for sign in (1, -1))
    inside = LineString([(z.real, z.imag) for z in ends]).intersection(
        box(-half.real, -half.imag, half.real, half.imag)
    )
    return float(inside.length) or math.inf


def _ridge_pixels(most: Array, way: Indices) -> Booleans:
    """Pixels with a stronger line response than those on both sides of it."""
    sharpest = numpy.zeros(most.shape, bool)
    for eighth, (x, y) in enumerate(((0, 1), (-1, 1), (-1, 0), (1, 1))):  # across 0, 45, 90 and 135 degrees
        one, two = (numpy.roll(most, (s * y, s * x), (0, 1)) for s in (1, -1))
        sharpest |= ((way + 2) % LINE_DIRECTIONS // 4 == eighth) & (most >= one) & (most > two)
    return sharpest


def _pixels_of_large_pieces(dark: Array) -> Booleans:
    """Pixels of ink, and their neighbours, in pieces too large for letters."""
    labels, stats = connected_components(dark > LEAST_INK_DARKNESS)
    large = numpy.hypot(stats[:, 2], stats[:, 3]) > LARGEST_LETTER_MM * PX_PER_MM
    large[0] = False
    held: Booleans = large[cv().dilate(labels.astype(numpy.float32), None).astype(int)]
    return held
