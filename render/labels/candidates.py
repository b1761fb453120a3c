"""Candidate places of a label: boxes around a point or along a segment, each with its disadvantages.

Boxes are rows x0, y0, x1, y1 in mm; wishes are costs without a unit, 0 for the best place.
"""

import cmath
import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from planes.geometry.arrays import Array, Booleans, Complexes, Indices
from planes.words.frozen import frozen
from render.labels.footprints import Bounds, box_gaps, segments_cross_boxes, segments_meet
from render.paper.marks import Arc, Line, Text
from render.paper.typeset import ink_bounds

Ends = tuple[complex, complex]
Size = tuple[float, float]  # width and height

NEAR_DISTANCES_MM = (0.9, 1.8, 3.2, 4.6)
"""Distances in mm from a point or segment to its label's box."""

FAR_DISTANCES_MM = (4.5, 6.0, 8.0, 10.0, 13.0, 16.0, 20.0, 25.0, 32.0, 40.0, 50.0)
"""Distances in mm of labels with a leader line."""

LEAST_INK_DISTANCE_MM = 0.5  # least distance of a label from ink
LABEL_GAP_RATIOS = 0.6, 0.15  # least distances of labels, horizontally and vertically, over the height of their letters
CLOSE_NEIGHBOUR_MM = 4.0  # closer neighbours on a line cost extra
UNDERLINE_DROP_MM, UNDERLINE_OVERHANG_MM = 0.9, 0.5  # of an underline: beneath its label, and beyond both its ends
_LEADER_CLEARANCE_BOX_MM = np.array([-1, -1, 1, 1]) * 0.3  # mm between a leader and letters
_SEGMENT_SHARES = np.array([0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8])
_SAMPLES = np.linspace(0.0, 1.0, 25)
_NEAR_DIRECTIONS = np.array([cmath.rect(1, math.radians(22.5 * k)) for k in range(16)])
_LEADER_DIRECTIONS = np.array([cmath.rect(1, math.radians(15.0 * k)) for k in range(24)])
_OTHER_POINT_COST = 1.5  # cost of a place around another point
_DEFAULT_DIRECTION = cmath.rect(1, math.radians(50))  # by default a label goes to the upper right
LEADER_DOT_RADIUS_MM = 0.45  # radius of the dot at the end of a leader
_LEADER_COST, _LEADER_COST_PER_MM = 25.0, 1.0  # cost of a leader line, and of each mm of it


@frozen
class Label:
    """A text and the point or segment it names.

    ``side`` is the preferred direction (0: none), ``clear`` the radius in mm around a point to be kept free (a
    hinge's); higher ``priority`` chooses earlier. A label ``told`` elsewhere too is left out where there is no room for
    it. Around the points ``also`` nothing else is named.
    """

    text: str
    at: complex | Ends
    height: float = 5.0
    side: complex = 0
    clear: float = 0.0
    priority: int = 0
    name: str = ""
    underlined: bool = False
    told: bool = False
    also: tuple[complex, ...] = ()

    @property
    def ink_bounds(self) -> Bounds:
        """Bounds of its ink in mm from the left end of its base line."""
        x0, y0, x1, y1 = ink_bounds(self.text, self.height)
        if self.underlined:
            return (x0 - UNDERLINE_OVERHANG_MM, y0 - UNDERLINE_DROP_MM, x1 + UNDERLINE_OVERHANG_MM, y1)
        return (x0, y0, x1, y1)


class Placed(NamedTuple):
    """The labels that are kept, as texts in the given order, and their leader lines, if any; dots at the ends of
    leaders, and lines under texts."""

    texts: tuple[Text, ...]
    leaders: tuple[Line, ...]
    signs: tuple[Line | Arc, ...] = ()

    @property
    def marks(self) -> tuple[Text | Line | Arc, ...]:
        """Leaders, dots, underlines and texts."""
        return (*self.leaders, *self.signs, *self.texts)


@frozen
class Candidates:
    """Boxes (n, 4), their wishes (n,), leader lines (n, 2) as complex ends, NaN for none, and letters (n,) in mm."""

    boxes: Array
    wish: Array
    leaders: Complexes
    heights: Array

    def select_rows(self, rows: Indices) -> "Candidates":
        """The candidates in those rows."""
        return Candidates(self.boxes[rows], self.wish[rows], self.leaders[rows], self.heights[rows])

    @property
    def outer_boxes(self) -> Array:
        """The box around each candidate and its leader line."""
        x = self.leaders.real
        y = self.leaders.imag
        low = np.fmin(self.boxes[:, :2], np.stack([x.min(axis=1), y.min(axis=1)], axis=1))
        return np.hstack([low, np.fmax(self.boxes[:, 2:], np.stack([x.max(axis=1), y.max(axis=1)], axis=1))])


def candidates_beside(label: Label, gaps: Sequence[float]) -> Candidates:
    """Places right beside the named object."""
    size = _label_size(label)
    if isinstance(label.at, tuple):
        parts = [_boxes_along_segment(label.at, label, size, np.array(gaps))]
    else:
        parts = [_boxes_around_point(label.at, label, size, np.array(gaps), _NEAR_DIRECTIONS)]
    others = (_boxes_around_point(z, label, size, np.array(gaps), _NEAR_DIRECTIONS) for z in label.also)
    boxes, wish = map(np.concatenate, zip(*parts, *((b, w + _OTHER_POINT_COST) for b, w in others), strict=True))
    return _make_candidates(label, boxes, wish, np.full((len(boxes), 2), np.nan, dtype=complex))


def _make_candidates(label: Label, boxes: Array, wish: Array, leaders: Complexes) -> Candidates:
    return Candidates(boxes, wish, leaders, np.full(len(boxes), label.height))


def _label_size(label: Label) -> Size:
    x0, y0, x1, y1 = label.ink_bounds
    return x1 - x0, y1 - y0


def candidates_far_off(label: Label, gaps: Sequence[float]) -> Candidates:
    """Places farther away, each with a leader line to the point or to one of three places of the segment."""
    if not isinstance(label.at, tuple):
        return _candidates_with_leaders(label.at, label, gaps, max(label.clear, 0.6))
    start, end = label.at
    return join_candidates(
        [_candidates_with_leaders(start + t * (end - start), label, gaps, 0.0) for t in (0.5, 0.3, 0.7)]
    )


def _candidates_with_leaders(at: complex, label: Label, gaps: Sequence[float], free: float) -> Candidates:
    """Places around a point with leader lines that end ``free`` mm before it."""
    boxes, wish = _boxes_around_point(at, label, _label_size(label), np.array(gaps), _LEADER_DIRECTIONS)
    near = np.clip(at.real, boxes[:, 0], boxes[:, 2]) + 1j * np.clip(at.imag, boxes[:, 1], boxes[:, 3])
    toward = (near - at) / abs(near - at)
    led = _LEADER_COST + _LEADER_COST_PER_MM * abs(near - at)
    return _make_candidates(label, boxes, wish + led, np.stack([near - 0.6 * toward, at + free * toward], axis=1))


def left_out_candidate(label: Label) -> Candidates:
    """The place of a label that is left out."""
    return _make_candidates(label, np.full((1, 4), np.nan), np.zeros(1), np.full((1, 2), np.nan, dtype=complex))


def join_candidates(parts: Sequence[Candidates]) -> Candidates:
    """The candidates of all, in order."""
    columns = zip(*((one.boxes, one.wish, one.leaders, one.heights) for one in parts), strict=True)
    return Candidates(*map(np.concatenate, columns))


def box_point_distances(boxes: Array, points: Complexes) -> Array:
    """The distance of each box (rows) from each point (columns)."""
    x0, y0, x1, y1 = (side[:, None] for side in boxes.T)
    dx = np.maximum(np.maximum(x0 - points.real, points.real - x1), 0)
    away: Array = np.hypot(dx, np.maximum(np.maximum(y0 - points.imag, points.imag - y1), 0))
    return away


def sampled(at: complex | Ends) -> list[complex]:
    """A point, or points along a segment, from end to end."""
    return (at[0] + _SAMPLES * (at[1] - at[0])).tolist() if isinstance(at, tuple) else [at]


def distance_to_own_object(candidates: Candidates, at: complex | Ends, also: Sequence[complex]) -> Array:
    """Distance in mm of each box from the nearest point that its label names, or from its segment."""
    nearest: Array = box_point_distances(candidates.boxes, np.array([*sampled(at), *also])).min(axis=1)
    return nearest


def _segment_direction(ends: Ends) -> complex:
    span = ends[1] - ends[0]
    return span / abs(span) if span else 1 + 0j


def _boxes_about_middles(middles: Complexes, size: Size) -> Array:
    x = middles.real
    y = middles.imag
    return np.stack([x - size[0] / 2, y - size[1] / 2, x + size[0] / 2, y + size[1] / 2], axis=1)


def _boxes_around_point(at: complex, label: Label, size: Size, gaps: Array, ways: Complexes) -> tuple[Array, Array]:
    """Boxes around a point and their wishes, the nearest first."""
    liked = label.side / abs(label.side) if label.side else _DEFAULT_DIRECTION
    x, y = (np.clip(math.sqrt(2) * part, -1.0, 1.0) for part in (ways.real, ways.imag))
    middles = at + (label.clear + gaps)[:, None] * ways + (x * size[0] + 1j * y * size[1]) / 2
    turned = (3.0 if label.side else 1.0) * (1 - (ways * liked.conjugate()).real)
    return _boxes_about_middles(middles.ravel(), size), (turned + 0.8 * (gaps - gaps[0])[:, None]).ravel()


def _boxes_along_segment(ends: Ends, label: Label, size: Size, gaps: Array) -> tuple[Array, Array]:
    """Boxes on both sides of a segment and their wishes, the middle of the segment first."""
    liked = label.side or _DEFAULT_DIRECTION
    out = np.array([1j, -1j]) * _segment_direction(ends)
    reach = (label.clear + gaps)[:, None] + (np.abs(out.real) * size[0] + np.abs(out.imag) * size[1]) / 2
    middles = (ends[0] + _SEGMENT_SHARES * (ends[1] - ends[0]))[:, None] + (reach * out)[:, None, :]
    wrong = (3.0 if label.side else 0.7) * ((out * liked.conjugate()).real < 0)
    wish = wrong + 4 * np.abs(_SEGMENT_SHARES - 0.5)[:, None] + 0.8 * (gaps - gaps[0])[:, None, None]
    return _boxes_about_middles(middles.ravel(), size), wish.ravel()


def count_clashes(some: Candidates, others: Candidates) -> tuple[Indices, Booleans]:
    """How often places (rows) clash with others (columns), letters and leaders; and which letters are close.

    Overlapping letters clash twice, those closer than labels may be once.
    """
    letter = np.minimum(some.heights[:, None], others.heights[None, :])
    sideways, apart = box_gaps(some.boxes, others.boxes)
    clashes = ((sideways < LABEL_GAP_RATIOS[0] * letter) & (apart < LABEL_GAP_RATIOS[1] * letter)).astype(np.intp)
    clashes += (sideways < 0.0) & (apart < 0.0)
    led, leading = (np.flatnonzero(~np.isnan(places.leaders[:, 0])) for places in (some, others))
    own = some.leaders[led][:, None, :]
    theirs = others.leaders[leading][None, :, :]
    if len(leading):
        clashes[:, leading] += segments_cross_boxes(some.boxes[:, None, :] + _LEADER_CLEARANCE_BOX_MM, theirs)
    if len(led):
        clashes[led] += segments_cross_boxes(others.boxes[None, :, :] + _LEADER_CLEARANCE_BOX_MM, own)
    if len(led) and len(leading):
        clashes[np.ix_(led, leading)] += segments_meet(own, theirs)
    return clashes, (sideways < CLOSE_NEIGHBOUR_MM) & (apart < LEAST_INK_DISTANCE_MM)


def place_at_preferred(labels: Sequence[Label]) -> Placed:
    """Labels in their preferred places, ignoring everything else."""
    best = [
        (option := candidates_beside(label, NEAR_DISTANCES_MM[:1])).select_rows(np.argmin(option.wish, keepdims=True))
        for label in labels
    ]
    if best:
        return place_at_chosen(labels, join_candidates(best))
    return Placed((), ())


def place_at_chosen(labels: Sequence[Label], chosen: Candidates) -> Placed:
    """Labels in the chosen places."""
    texts = list[Text]()
    leaders = list[Line]()
    signs = list[Line | Arc]()
    there = zip(labels, chosen.boxes, chosen.leaders, strict=True)
    for label, (x0, y0, x1, _), led in (one for one in there if not np.isnan(one[1][0])):
        left, low, *_ = label.ink_bounds
        texts.append(Text(label.text, complex(x0 - left, y0 - low), label.height, name=label.name))
        if label.underlined:
            signs.append(Line((complex(x0, y0), complex(x1, y0)), "thin", "text"))
        if not np.isnan(led[0].real):
            leaders.append(Line(tuple(map(complex, led)), "thin", "text", name="leader"))
            signs.append(Arc(complex(led[1]), LEADER_DOT_RADIUS_MM, style="thin", layer="text", fill="ink"))
    return Placed(tuple(texts), tuple(leaders), tuple(signs))
