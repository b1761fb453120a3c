"""Candidate places of a label: boxes around a point or along a segment, with what is liked less about each.

Boxes are rows x0, y0, x1, y1 in mm; wishes are costs without a unit, 0 for the best place.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce
from typing import Any, Protocol

import numpy as np

from render.paper.marks import Layer

NEAR = (0.9, 1.8, 3.2)
"""Distances in mm from a point or segment to its label's box."""

FAR = (6.0, 9.0, 12.0, 16.0, 20.0, 25.0, 32.0, 40.0, 50.0)
"""Distances in mm of labels that need a leader line."""

_ALONG = (0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8)
_DIRECTIONS = tuple(cmath.rect(1, math.radians(a)) for a in np.arange(0, 360, 22.5).tolist())
_ROUND = tuple(cmath.rect(1, math.radians(a)) for a in np.arange(0, 360, 15.0).tolist())
_EYE = cmath.rect(1, math.radians(50))  # without a wish a label goes to the upper right
_LED = 25.0  # cost of a leader line


class Named(Protocol):
    """What candidates need to know of a label."""

    @property
    def at(self) -> complex | tuple[complex, complex]: ...
    @property
    def side(self) -> complex: ...
    @property
    def clear(self) -> float: ...


class Lettered(Named, Protocol):
    """What a board needs to know of a label."""

    @property
    def text(self) -> str: ...
    @property
    def height(self) -> float: ...
    @property
    def priority(self) -> int: ...
    @property
    def layer(self) -> Layer: ...
    @property
    def name(self) -> str: ...


@dataclass(frozen=True)
class Candidates:
    """Boxes (n, 4), their wishes (n,) and leader lines (n, 2) as complex ends, NaN for none."""

    boxes: Any
    wish: Any
    leaders: Any

    def some(self, rows: slice) -> Candidates:
        """The candidates of those rows."""
        return Candidates(self.boxes[rows], self.wish[rows], self.leaders[rows])


def beside(label: Named, extent: Sequence[float], gaps: Sequence[float]) -> Candidates:
    """Places right beside what the label names."""
    width, height = extent[2] - extent[0], extent[3] - extent[1]
    rows = (
        _along(label.at, label, width, height, gaps)
        if isinstance(label.at, tuple)
        else _around(label.at, label, width, height, gaps, _DIRECTIONS)
    )
    middles, wish = (np.array(column) for column in zip(*rows, strict=True))
    return Candidates(_boxes(middles, width, height), wish, np.full((len(rows), 2), np.nan, dtype=complex))


def far_off(label: Named, extent: Sequence[float], gaps: Sequence[float]) -> Candidates:
    """Places farther away, each with a leader line to the point or to one of three places of the segment."""
    if not isinstance(label.at, tuple):
        return _led(label.at, label, extent, gaps, max(label.clear, 0.6))
    start, end = label.at
    return reduce(union, [_led(start + t * (end - start), label, extent, gaps, 0.0) for t in (0.5, 0.3, 0.7)])


def _led(at: complex, label: Named, extent: Sequence[float], gaps: Sequence[float], free: float) -> Candidates:
    """Places around a point with leader lines that end ``free`` mm before it."""
    width, height = extent[2] - extent[0], extent[3] - extent[1]
    rows = _around(at, label, width, height, gaps, _ROUND)
    middles, wish = (np.array(column) for column in zip(*rows, strict=True))
    boxes = _boxes(middles, width, height)
    near = np.clip(at.real, boxes[:, 0], boxes[:, 2]) + 1j * np.clip(at.imag, boxes[:, 1], boxes[:, 3])
    toward = (near - at) / abs(near - at)
    return Candidates(boxes, wish + _LED, np.stack([near - 0.6 * toward, at + free * toward], axis=1))


def union(one: Candidates, other: Candidates) -> Candidates:
    """The candidates of both, in order."""
    return Candidates(
        np.concatenate([one.boxes, other.boxes]),
        np.concatenate([one.wish, other.wish]),
        np.concatenate([one.leaders, other.leaders]),
    )


def own_distance(candidates: Candidates, at: complex | tuple[complex, complex]) -> Any:
    """Distance in mm of each box from the point, or from the line of the segment, that it names."""
    x0, y0, x1, y1 = candidates.boxes.T
    if not isinstance(at, tuple):
        dx = np.maximum(np.maximum(x0 - at.real, at.real - x1), 0)
        return np.hypot(dx, np.maximum(np.maximum(y0 - at.imag, at.imag - y1), 0))
    along = _direction(at)
    across = (((x0 + x1) + 1j * (y0 + y1)) / 2 - at[0]) * along.conjugate()
    reach = (abs(along.imag) * (x1 - x0) + abs(along.real) * (y1 - y0)) / 2
    return np.maximum(np.abs(across.imag) - reach, 0)


def _direction(ends: tuple[complex, complex]) -> complex:
    span = ends[1] - ends[0]
    return span / abs(span) if span else 1 + 0j


def _boxes(middles: Any, width: float, height: float) -> Any:
    x, y = middles.real, middles.imag
    return np.stack([x - width / 2, y - height / 2, x + width / 2, y + height / 2], axis=1)


def _around(
    at: complex, label: Named, width: float, height: float, gaps: Sequence[float], ways: Sequence[complex]
) -> list[tuple[complex, float]]:
    """Middles of boxes around a point and their wishes, the nearest first."""
    liked = label.side / abs(label.side) if label.side else _EYE
    weight = 3.0 if label.side else 1.0
    rows = []
    for gap in gaps:
        for way in ways:
            x, y = (max(-1.0, min(1.0, math.sqrt(2) * part)) for part in (way.real, way.imag))
            middle = at + (label.clear + gap) * way + complex(x * width, y * height) / 2
            turned = 1 - (way * liked.conjugate()).real
            rows.append((middle, weight * turned + 0.8 * (gap - gaps[0])))
    return rows


def _along(
    ends: tuple[complex, complex], label: Named, width: float, height: float, gaps: Sequence[float]
) -> list[tuple[complex, float]]:
    """Middles of boxes on both sides of a segment and their wishes, the middle of the segment first."""
    along = _direction(ends)
    liked = label.side or _EYE
    weight = 3.0 if label.side else 0.7
    rows = []
    for gap in gaps:
        for part in _ALONG:
            for side in (1j, -1j):
                out = side * along
                reach = label.clear + gap + (abs(out.real) * width + abs(out.imag) * height) / 2
                middle = ends[0] + part * (ends[1] - ends[0]) + reach * out
                wrong = (out * liked.conjugate()).real < 0
                rows.append((middle, weight * wrong + 4 * abs(part - 0.5) + 0.8 * (gap - gaps[0])))
    return rows


def crossed(boxes: Any, lines: Any) -> Any:
    """Whether segments (…, 2; complex) pass through boxes (…, 4), by broadcasting; NaN through none."""
    start, span = lines[..., 0], lines[..., 1] - lines[..., 0]
    enter, leave = np.zeros(np.broadcast_shapes(start.shape, boxes.shape[:-1])), 1.0
    with np.errstate(divide="ignore", invalid="ignore"):
        for low, high, origin, step in (
            (boxes[..., 0], boxes[..., 2], start.real, span.real),
            (boxes[..., 1], boxes[..., 3], start.imag, span.imag),
        ):
            safe = np.where(step == 0, 1e-12, step)
            one, two = (low - origin) / safe, (high - origin) / safe
            enter = np.maximum(enter, np.minimum(one, two))
            leave = np.minimum(leave, np.maximum(one, two))
    return enter < leave


def meeting(lines: Any, others: Any) -> Any:
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
    return (inside & (across != 0)) | (level & along)
