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
from render.labels.footprints import Bounds, crossed, gaps, meeting
from render.paper.marks import Arc, Line, Text
from render.paper.typeset import extent

Ends = tuple[complex, complex]
Size = tuple[float, float]  # width and height

NEAR = (0.9, 1.8, 3.2, 4.6)
"""Distances in mm from a point or segment to its label's box."""

FAR = (6.0, 8.0, 10.0, 13.0, 16.0, 20.0, 25.0, 32.0, 40.0, 50.0)
"""Distances in mm of labels with a leader line."""

CLEAR_MM = 0.5  # least distance of a label from ink
BETWEEN = 0.6, 0.15  # least distances of labels, horizontally and vertically, over the height of their letters
APART_MM = 4.0  # closer neighbours on a line cost extra
UNDER_MM, BESIDE_MM = 0.9, 0.5  # of an underline: beneath its label, and beyond both its ends
_GROWN = np.array([-1, -1, 1, 1]) * 0.3  # mm between a leader and letters
_ALONG = np.array([0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8])
_SAMPLES = np.linspace(0.0, 1.0, 25)
_DIRECTIONS = np.array([cmath.rect(1, math.radians(22.5 * k)) for k in range(16)])
_ROUND = np.array([cmath.rect(1, math.radians(15.0 * k)) for k in range(24)])
_LESS = 1.5  # cost of a place around another point
_EYE = cmath.rect(1, math.radians(50))  # by default a label goes to the upper right
LED_DOT_MM = 0.45  # radius of the dot at the end of a leader
_LED, _LONGER = 25.0, 1.0  # cost of a leader line, and of each mm of it


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
    def extent(self) -> Bounds:
        """Bounds of its ink in mm from the left end of its base line."""
        x0, y0, x1, y1 = extent(self.text, self.height)
        return (x0 - BESIDE_MM, y0 - UNDER_MM, x1 + BESIDE_MM, y1) if self.underlined else (x0, y0, x1, y1)


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

    def some(self, rows: Indices) -> "Candidates":
        """The candidates in those rows."""
        return Candidates(self.boxes[rows], self.wish[rows], self.leaders[rows], self.heights[rows])

    @property
    def reach(self) -> Array:
        """The box around each candidate and its leader line."""
        x, y = self.leaders.real, self.leaders.imag
        low = np.fmin(self.boxes[:, :2], np.stack([x.min(axis=1), y.min(axis=1)], axis=1))
        return np.hstack([low, np.fmax(self.boxes[:, 2:], np.stack([x.max(axis=1), y.max(axis=1)], axis=1))])


def beside(label: Label, gaps: Sequence[float]) -> Candidates:
    """Places right beside the named object."""
    size = _size(label)
    if isinstance(label.at, tuple):
        parts = [_along(label.at, label, size, np.array(gaps))]
    else:
        parts = [_around(label.at, label, size, np.array(gaps), _DIRECTIONS)]
    others = (_around(z, label, size, np.array(gaps), _DIRECTIONS) for z in label.also)
    boxes, wish = map(np.concatenate, zip(*parts, *((b, w + _LESS) for b, w in others), strict=True))
    return _candidates(label, boxes, wish, np.full((len(boxes), 2), np.nan, dtype=complex))


def _candidates(label: Label, boxes: Array, wish: Array, leaders: Complexes) -> Candidates:
    return Candidates(boxes, wish, leaders, np.full(len(boxes), label.height))


def _size(label: Label) -> Size:
    x0, y0, x1, y1 = label.extent
    return x1 - x0, y1 - y0


def far_off(label: Label, gaps: Sequence[float]) -> Candidates:
    """Places farther away, each with a leader line to the point or to one of three places of the segment."""
    if not isinstance(label.at, tuple):
        return _led(label.at, label, gaps, max(label.clear, 0.6))
    start, end = label.at
    return union([_led(start + t * (end - start), label, gaps, 0.0) for t in (0.5, 0.3, 0.7)])


def _led(at: complex, label: Label, gaps: Sequence[float], free: float) -> Candidates:
    """Places around a point with leader lines that end ``free`` mm before it."""
    boxes, wish = _around(at, label, _size(label), np.array(gaps), _ROUND)
    near = np.clip(at.real, boxes[:, 0], boxes[:, 2]) + 1j * np.clip(at.imag, boxes[:, 1], boxes[:, 3])
    toward = (near - at) / abs(near - at)
    led = _LED + _LONGER * abs(near - at)
    return _candidates(label, boxes, wish + led, np.stack([near - 0.6 * toward, at + free * toward], axis=1))


def nowhere(label: Label) -> Candidates:
    """The place of a label that is left out."""
    return _candidates(label, np.full((1, 4), np.nan), np.zeros(1), np.full((1, 2), np.nan, dtype=complex))


def union(parts: Sequence[Candidates]) -> Candidates:
    """The candidates of all, in order."""
    columns = zip(*((one.boxes, one.wish, one.leaders, one.heights) for one in parts), strict=True)
    return Candidates(*map(np.concatenate, columns))


def distances(boxes: Array, points: Complexes) -> Array:
    """The distance of each box (rows) from each point (columns)."""
    x0, y0, x1, y1 = (side[:, None] for side in boxes.T)
    dx = np.maximum(np.maximum(x0 - points.real, points.real - x1), 0)
    away: Array = np.hypot(dx, np.maximum(np.maximum(y0 - points.imag, points.imag - y1), 0))
    return away


def sampled(at: complex | Ends) -> list[complex]:
    """A point, or points along a segment, from end to end."""
    return [at] if not isinstance(at, tuple) else (at[0] + _SAMPLES * (at[1] - at[0])).tolist()


def own_distance(candidates: Candidates, at: complex | Ends, also: Sequence[complex]) -> Array:
    """Distance in mm of each box from the nearest of its own points, or from its segment."""
    nearest: Array = distances(candidates.boxes, np.array([*sampled(at), *also])).min(axis=1)
    return nearest


def _direction(ends: Ends) -> complex:
    span = ends[1] - ends[0]
    return span / abs(span) if span else 1 + 0j


def _boxes(middles: Complexes, size: Size) -> Array:
    x, y = middles.real, middles.imag
    return np.stack([x - size[0] / 2, y - size[1] / 2, x + size[0] / 2, y + size[1] / 2], axis=1)


def _around(at: complex, label: Label, size: Size, gaps: Array, ways: Complexes) -> tuple[Array, Array]:
    """Boxes around a point and their wishes, the nearest first."""
    liked = label.side / abs(label.side) if label.side else _EYE
    x, y = (np.clip(math.sqrt(2) * part, -1.0, 1.0) for part in (ways.real, ways.imag))
    middles = at + (label.clear + gaps)[:, None] * ways + (x * size[0] + 1j * y * size[1]) / 2
    turned = (3.0 if label.side else 1.0) * (1 - (ways * liked.conjugate()).real)
    return _boxes(middles.ravel(), size), (turned + 0.8 * (gaps - gaps[0])[:, None]).ravel()


def _along(ends: Ends, label: Label, size: Size, gaps: Array) -> tuple[Array, Array]:
    """Boxes on both sides of a segment and their wishes, the middle of the segment first."""
    liked, out = label.side or _EYE, np.array([1j, -1j]) * _direction(ends)
    reach = (label.clear + gaps)[:, None] + (np.abs(out.real) * size[0] + np.abs(out.imag) * size[1]) / 2
    middles = (ends[0] + _ALONG * (ends[1] - ends[0]))[:, None] + (reach * out)[:, None, :]
    wrong = (3.0 if label.side else 0.7) * ((out * liked.conjugate()).real < 0)
    wish = wrong + 4 * np.abs(_ALONG - 0.5)[:, None] + 0.8 * (gaps - gaps[0])[:, None, None]
    return _boxes(middles.ravel(), size), wish.ravel()


def met(some: Candidates, others: Candidates) -> tuple[Indices, Booleans]:
    """How often places (rows) clash with others (columns), letters and leaders; and which letters are close.

    Overlapping letters clash twice, those closer than labels may be once.
    """
    letter = np.minimum(some.heights[:, None], others.heights[None, :])
    sideways, apart = gaps(some.boxes, others.boxes)
    clashes = ((sideways < BETWEEN[0] * letter) & (apart < BETWEEN[1] * letter)).astype(np.intp)
    clashes += (sideways < 0.0) & (apart < 0.0)
    led, leading = (np.flatnonzero(~np.isnan(places.leaders[:, 0])) for places in (some, others))
    own, theirs = some.leaders[led][:, None, :], others.leaders[leading][None, :, :]
    if len(leading):
        clashes[:, leading] += crossed(some.boxes[:, None, :] + _GROWN, theirs)
    if len(led):
        clashes[led] += crossed(others.boxes[None, :, :] + _GROWN, own)
    if len(led) and len(leading):
        clashes[np.ix_(led, leading)] += meeting(own, theirs)
    return clashes, (sideways < APART_MM) & (apart < CLEAR_MM)


def liked(labels: Sequence[Label]) -> Placed:
    """Labels in their preferred places, ignoring everything else."""
    best = [(option := beside(label, NEAR[:1])).some(np.argmin(option.wish, keepdims=True)) for label in labels]
    return placed(labels, union(best)) if best else Placed((), ())


def placed(labels: Sequence[Label], chosen: Candidates) -> Placed:
    """Labels in the chosen places."""
    texts, leaders, signs = list[Text](), list[Line](), list[Line | Arc]()
    there = zip(labels, chosen.boxes, chosen.leaders, strict=True)
    for label, (x0, y0, x1, _), led in (one for one in there if not np.isnan(one[1][0])):
        left, low, *_ = label.extent
        texts.append(Text(label.text, complex(x0 - left, y0 - low), label.height, name=label.name))
        if label.underlined:
            signs.append(Line((complex(x0, y0), complex(x1, y0)), "thin", "text"))
        if not np.isnan(led[0].real):
            leaders.append(Line(tuple(map(complex, led)), "thin", "text", name="leader"))
            signs.append(Arc(complex(led[1]), LED_DOT_MM, style="thin", layer="text", fill="ink"))
    return Placed(tuple(texts), tuple(leaders), tuple(signs))
