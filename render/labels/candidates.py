"""Candidate places of a label: boxes around a point or along a segment, with what is liked less about each.

Boxes are rows x0, y0, x1, y1 in mm; wishes are costs without a unit, 0 for the best place.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from planes.geometry.arrays import Array, Booleans, Complexes, Indices
from render.paper.marks import Layer, Line, Text

Ends = tuple[complex, complex]

NEAR = (0.9, 1.8, 3.2)
"""Distances in mm from a point or segment to its label's box."""

FAR = (6.0, 9.0, 12.0, 16.0, 20.0, 25.0, 32.0, 40.0, 50.0)
"""Distances in mm of labels that need a leader line."""

CLEAR_MM = 0.5  # least distance of a label from ink and from labels
APART_MM = 4.0  # labels side by side read as one when they stand closer than this
_GROWN = np.array([-1, -1, 1, 1]) * 0.3  # mm a leader keeps away from letters
_ALONG = np.array([0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8])
_DIRECTIONS = np.array([cmath.rect(1, math.radians(22.5 * k)) for k in range(16)])
_ROUND = np.array([cmath.rect(1, math.radians(15.0 * k)) for k in range(24)])
_EYE = cmath.rect(1, math.radians(50))  # without a wish a label goes to the upper right
_LED = 25.0  # cost of a leader line


@dataclass(frozen=True)
class Label:
    """A text and the point or segment it names.

    ``side`` is the direction from it that is liked best (0: no wish), ``clear`` the radius around a point
    that is to be kept free (a hinge's) in mm; higher ``priority`` chooses earlier.
    """

    text: str
    at: complex | Ends
    height: float = 5.0
    side: complex = 0
    clear: float = 0.0
    priority: int = 0
    layer: Layer = "text"
    name: str = ""


class Placed(NamedTuple):
    """The labels as texts, in the order they were given, and the leader lines some of them need."""

    texts: tuple[Text, ...]
    leaders: tuple[Line, ...]

    @property
    def marks(self) -> tuple[Text | Line, ...]:
        """Leaders and texts."""
        return (*self.leaders, *self.texts)


@dataclass(frozen=True)
class Candidates:
    """Boxes (n, 4), their wishes (n,) and leader lines (n, 2) as complex ends, NaN for none."""

    boxes: Array
    wish: Array
    leaders: Complexes

    def some(self, rows: Indices) -> Candidates:
        """The candidates of those rows."""
        return Candidates(self.boxes[rows], self.wish[rows], self.leaders[rows])

    @property
    def reach(self) -> Array:
        """The box around each and its leader line."""
        x, y = self.leaders.real, self.leaders.imag
        low = np.fmin(self.boxes[:, :2], np.stack([x.min(axis=1), y.min(axis=1)], axis=1))
        return np.hstack([low, np.fmax(self.boxes[:, 2:], np.stack([x.max(axis=1), y.max(axis=1)], axis=1))])


def beside(label: Label, extent: Sequence[float], gaps: Sequence[float]) -> Candidates:
    """Places right beside what the label names."""
    size = extent[2] - extent[0], extent[3] - extent[1]
    if isinstance(label.at, tuple):
        boxes, wish = _along(label.at, label, size, np.array(gaps))
    else:
        boxes, wish = _around(label.at, label, size, np.array(gaps), _DIRECTIONS)
    return Candidates(boxes, wish, np.full((len(boxes), 2), np.nan, dtype=complex))


def far_off(label: Label, extent: Sequence[float], gaps: Sequence[float]) -> Candidates:
    """Places farther away, each with a leader line to the point or to one of three places of the segment."""
    if not isinstance(label.at, tuple):
        return _led(label.at, label, extent, gaps, max(label.clear, 0.6))
    start, end = label.at
    return union([_led(start + t * (end - start), label, extent, gaps, 0.0) for t in (0.5, 0.3, 0.7)])


def _led(at: complex, label: Label, extent: Sequence[float], gaps: Sequence[float], free: float) -> Candidates:
    """Places around a point with leader lines that end ``free`` mm before it."""
    size = extent[2] - extent[0], extent[3] - extent[1]
    boxes, wish = _around(at, label, size, np.array(gaps), _ROUND)
    near = np.clip(at.real, boxes[:, 0], boxes[:, 2]) + 1j * np.clip(at.imag, boxes[:, 1], boxes[:, 3])
    toward = (near - at) / abs(near - at)
    return Candidates(boxes, wish + _LED, np.stack([near - 0.6 * toward, at + free * toward], axis=1))


def union(parts: Sequence[Candidates]) -> Candidates:
    """The candidates of all, in order."""
    columns = zip(*((one.boxes, one.wish, one.leaders) for one in parts), strict=True)
    return Candidates(*map(np.concatenate, columns))


def distances(boxes: Array, points: Complexes) -> Array:
    """How far each box (rows) is from each point (columns)."""
    x0, y0, x1, y1 = (side[:, None] for side in boxes.T)
    dx = np.maximum(np.maximum(x0 - points.real, points.real - x1), 0)
    away: Array = np.hypot(dx, np.maximum(np.maximum(y0 - points.imag, points.imag - y1), 0))
    return away


def own_distance(candidates: Candidates, at: complex | Ends) -> Array:
    """Distance in mm of each box from the point, or from the line of the segment, that it names."""
    if not isinstance(at, tuple):
        return distances(candidates.boxes, np.array([at]))[:, 0]
    x0, y0, x1, y1 = candidates.boxes.T
    along = _direction(at)
    across = (((x0 + x1) + 1j * (y0 + y1)) / 2 - at[0]) * along.conjugate()
    reach = (abs(along.imag) * (x1 - x0) + abs(along.real) * (y1 - y0)) / 2
    away: Array = np.maximum(np.abs(across.imag) - reach, 0)
    return away


def _direction(ends: Ends) -> complex:
    span = ends[1] - ends[0]
    return span / abs(span) if span else 1 + 0j


def _boxes(middles: Complexes, size: tuple[float, float]) -> Array:
    x, y = middles.real, middles.imag
    return np.stack([x - size[0] / 2, y - size[1] / 2, x + size[0] / 2, y + size[1] / 2], axis=1)


def _around(at: complex, label: Label, size: tuple[float, float], gaps: Array, ways: Complexes) -> tuple[Array, Array]:
    """Boxes around a point and their wishes, the nearest first."""
    liked = label.side / abs(label.side) if label.side else _EYE
    x, y = (np.clip(math.sqrt(2) * part, -1.0, 1.0) for part in (ways.real, ways.imag))
    middles = at + (label.clear + gaps)[:, None] * ways + (x * size[0] + 1j * y * size[1]) / 2
    turned = (3.0 if label.side else 1.0) * (1 - (ways * liked.conjugate()).real)
    return _boxes(middles.ravel(), size), (turned + 0.8 * (gaps - gaps[0])[:, None]).ravel()


def _along(ends: Ends, label: Label, size: tuple[float, float], gaps: Array) -> tuple[Array, Array]:
    """Boxes on both sides of a segment and their wishes, the middle of the segment first."""
    liked, out = label.side or _EYE, np.array([1j, -1j]) * _direction(ends)
    reach = (label.clear + gaps)[:, None] + (np.abs(out.real) * size[0] + np.abs(out.imag) * size[1]) / 2
    middles = (ends[0] + _ALONG * (ends[1] - ends[0]))[:, None] + (reach * out)[:, None, :]
    wrong = (3.0 if label.side else 0.7) * ((out * liked.conjugate()).real < 0)
    wish = wrong + 4 * np.abs(_ALONG - 0.5)[:, None] + 0.8 * (gaps - gaps[0])[:, None, None]
    return _boxes(middles.ravel(), size), wish.ravel()


def close(boxes: Array, others: Array, sideways: float, clear: float) -> Booleans:
    """Which boxes (rows) come near which others (columns): nearer than so many mm sideways and in height.

    Labels without a place yet come near nothing.
    """
    a, b = boxes[:, None, :], others[None, :, :]
    return (
        (a[..., 0] < b[..., 2] + sideways)
        & (b[..., 0] < a[..., 2] + sideways)
        & (a[..., 1] < b[..., 3] + clear)
        & (b[..., 1] < a[..., 3] + clear)
    )


def crossed(boxes: Array, lines: Complexes) -> Booleans:
    """Whether segments (…, 2; complex) pass through boxes (…, 4), by broadcasting; NaN through none."""
    start, span = lines[..., 0], lines[..., 1] - lines[..., 0]
    enter = np.zeros(np.broadcast_shapes(start.shape, boxes.shape[:-1]))
    leave = enter + 1.0
    with np.errstate(divide="ignore", invalid="ignore"):
        for low, high, origin, step in (
            (boxes[..., 0], boxes[..., 2], start.real, span.real),
            (boxes[..., 1], boxes[..., 3], start.imag, span.imag),
        ):
            safe = np.where(step == 0, 1e-12, step)
            one, two = (low - origin) / safe, (high - origin) / safe
            enter = np.maximum(enter, np.minimum(one, two))
            leave = np.minimum(leave, np.maximum(one, two))
    through: Booleans = enter < leave
    return through


def meeting(lines: Complexes, others: Complexes) -> Booleans:
    """Whether segments (…, 2; complex) meet others, by broadcasting; those on one line too, where they overlap."""
    start, span = lines[..., 0], lines[..., 1] - lines[..., 0]
    began, way = others[..., 0], others[..., 1] - others[..., 0]
    across = (span.conjugate() * way).imag
    safe = np.where(across == 0, np.inf, across)
    apart = began - start
    on_line, on_other = (apart.conjugate() * way).imag / safe, (apart.conjugate() * span).imag / safe
    inside = (on_line >= -0.02) & (on_line <= 1.02) & (on_other >= -0.02) & (on_other <= 1.02)
    unit = span / np.abs(span)
    one, two = apart * unit.conjugate(), (apart + way) * unit.conjugate()
    along = (np.maximum(one.real, two.real) >= -0.3) & (np.minimum(one.real, two.real) <= np.abs(span) + 0.3)
    level = (np.abs(one.imag) < 0.3) & (np.abs(two.imag) < 0.3)
    there: Booleans = (inside & (across != 0)) | (level & along)
    return there


def met(some: Candidates, others: Candidates) -> tuple[Indices, Booleans]:
    """How often places (rows) clash with others (columns), letters and leaders; and which letters stand close.

    Labels without a place yet meet nothing.
    """
    clashes = close(some.boxes, others.boxes, CLEAR_MM, CLEAR_MM).astype(np.intp)
    led, leading = (np.flatnonzero(~np.isnan(places.leaders[:, 0])) for places in (some, others))
    own, theirs = some.leaders[led][:, None, :], others.leaders[leading][None, :, :]
    if len(leading):
        clashes[:, leading] += crossed(some.boxes[:, None, :] + _GROWN, theirs)
    if len(led):
        clashes[led] += crossed(others.boxes[None, :, :] + _GROWN, own)
    if len(led) and len(leading):
        clashes[np.ix_(led, leading)] += meeting(own, theirs)
    return clashes, close(some.boxes, others.boxes, APART_MM, CLEAR_MM)
