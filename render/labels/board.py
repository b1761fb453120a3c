"""The board on which labels find their places: the candidates of each, what they cost, who makes room for whom."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
import shapely

from render.labels.candidates import (
    FAR,
    NEAR,
    Candidates,
    Lettered,
    beside,
    crossed,
    far_off,
    meeting,
    own_distance,
    union,
)
from render.labels.footprints import Bounds, InkedShapes
from render.paper.marks import Line, Text
from render.paper.typeset import extent

HARD = 200.0  # cost of one overlap, more than all that is merely disliked together
OUTSIDE = 1000.0  # cost of leaving the field
TIGHT = 1.5  # cost of standing closer than ROOM_MM to ink
AMBIGUOUS = 8.0  # cost of standing nearer to another label's point than to its own
CROSSING = 8.0  # cost of a leader's crossing with a stroke
BROKEN = 4.0  # cost of a thin line that is broken for a label
CLEAR_MM = 0.5  # least distance of a label from ink and from labels
ROOM_MM = 1.3
APART_MM = 4.0  # labels side by side read as one when they stand closer than this
READ_AS_ONE = 3.0  # cost of it
PATIENCE = 1000  # how often labels are asked to make room for others, on one board
ENOUGH = 8  # crossings, or lines broken: more are hardly worse
_SWEEPS = 8
_GROWN = np.array([-1, -1, 1, 1]) * 0.3  # mm a leader keeps away from letters


class _Met:
    """Which labels the candidates of one clash with, or stand close to; ``seen``: as of which of their moves."""

    def __init__(self, option: Candidates, count: int) -> None:
        self.clashes = np.zeros((len(option.wish), count), np.int8)
        self.close = np.zeros((len(option.wish), count), bool)
        self.seen = np.zeros(count, int)


class Board:
    """The candidates of all labels, the one each has chosen, and what the choices cost."""

    def __init__(
        self, labels: Sequence[Lettered], ground: InkedShapes, field: Bounds | None, yielding: InkedShapes
    ) -> None:
        self.labels, self.ground, self.field, self.yielding = labels, ground, field, yielding
        self.extents = [extent(label.text, label.height) for label in labels]
        self.options = [beside(label, size, NEAR) for label, size in zip(labels, self.extents, strict=True)]
        self.static = self._judged(self.options)
        self.boxes = np.full((len(labels), 4), np.nan)
        self.leaders = np.full((len(labels), 2), np.nan, dtype=complex)
        self.chosen = [0] * len(labels)
        self.wide: set[int] = set()
        self.moves = 0
        self.taken = np.zeros(len(labels), int)  # how often each label has moved
        self.met = [_Met(option, len(labels)) for option in self.options]

    def _judged(self, options: Sequence[Candidates], leaders: bool = False) -> list[Any]:
        """What every candidate costs before the other labels are looked at."""
        boxes = np.concatenate([option.boxes for option in options])
        cost = np.concatenate([option.wish for option in options]) + self._on_ink(boxes)
        if leaders:
            cost += CROSSING * _bounded(self._crossings(np.concatenate([option.leaders for option in options])))
        if self.field is not None:
            x0, y0, x1, y1 = self.field
            inside = (boxes[:, 0] >= x0) & (boxes[:, 1] >= y0) & (boxes[:, 2] <= x1) & (boxes[:, 3] <= y1)
            cost += OUTSIDE * ~inside
        ends = np.cumsum([len(option.wish) for option in options])[:-1]
        parts = np.split(cost, ends)
        return parts if leaders else [part + AMBIGUOUS * self._strays(k) for k, part in enumerate(parts)]

    def _on_ink(self, boxes: Any) -> Any:
        """Cost of the strokes that each box touches or nearly touches."""
        cost = np.zeros(len(boxes))
        if len(self.ground.shapes):
            areas = shapely.box(*boxes.T)
            pairs, apart = self.ground.gaps(areas, ROOM_MM)
            cost += TIGHT * (np.bincount(pairs[0, apart <= ROOM_MM], minlength=len(boxes)) > 0)
            cost += HARD * np.bincount(pairs[0, apart <= CLEAR_MM], minlength=len(boxes))
        if len(self.yielding.shapes):
            broken = self.yielding.within(shapely.box(*boxes.T), CLEAR_MM)[0]
            cost += BROKEN * _bounded(np.bincount(broken, minlength=len(boxes)))
        return cost

    def _crossings(self, leaders: Any) -> Any:
        """How many strokes each leader crosses, thin ones that yield for less."""
        lines = shapely.linestrings(np.stack([leaders.real, leaders.imag], axis=-1))
        found = np.zeros(len(leaders))
        for inked, weight in ((self.ground, 1.0), (self.yielding, 0.25)):
            if len(inked.shapes):
                pairs = shapely.STRtree(inked.shapes).query(lines, predicate="intersects")
                found += weight * np.bincount(pairs[0], minlength=len(leaders))
        return found

    def _strays(self, k: int) -> Any:
        """Which candidates of label k stand nearer to the point of another label than to their own."""
        others = [z.at for j, z in enumerate(self.labels) if j != k and not isinstance(z.at, tuple)]
        points = np.array([z for z in others if z != self.labels[k].at], dtype=complex)
        if not len(points):
            return np.zeros(len(self.options[k].wish), dtype=bool)
        x0, y0, x1, y1 = (side[:, None] for side in self.options[k].boxes.T)
        dx = np.maximum(np.maximum(x0 - points.real, points.real - x1), 0)
        dy = np.maximum(np.maximum(y0 - points.imag, points.imag - y1), 0)
        return np.hypot(dx, dy).min(axis=1) < own_distance(self.options[k], self.labels[k].at)

    def choose(self) -> None:
        """Everybody takes the cheapest place left, the important and the hemmed in first."""
        free = [int((cost < HARD).sum()) for cost in self.static]
        order = sorted(range(len(self.labels)), key=lambda k: (-self.labels[k].priority, free[k], k))
        for k in order:
            self._take(k, int(np.argmin(self.costs(k))))

    def costs(self, k: int, rows: slice = slice(None)) -> Any:
        """What the candidates of label k (or those ``rows``) cost among the present places of the others."""
        clashes, close = self._meets(k)
        blocked, near = clashes[rows].sum(axis=1), close[rows].any(axis=1)
        return self.static[k][rows] + HARD * blocked + READ_AS_ONE * near

    def _meets(self, k: int) -> tuple[Any, Any]:
        """How often each candidate of label k (rows) clashes with each other label (columns), and where it stands close
        to it: looked at anew for the labels that have moved."""
        met, option = self.met[k], self.options[k]
        moved = np.flatnonzero(met.seen != self.taken)
        moved = moved[moved != k]
        if len(moved):
            met.clashes[:, moved] = self._clashes(option, moved)
            met.close[:, moved] = _overlaps(option.boxes, self.boxes[moved], APART_MM)
            met.seen[moved] = self.taken[moved]
        return met.clashes, met.close

    def _clashes(self, option: Candidates, moved: Any) -> Any:
        """How often each candidate (rows) clashes with each of the labels ``moved`` (columns): letters and leaders."""
        boxes = self.boxes[moved]
        found = _overlaps(option.boxes, boxes).astype(np.int8)
        others = np.flatnonzero(~np.isnan(self.leaders[moved, 0]))
        leaders = self.leaders[moved[others]][None, :, :]
        found[:, others] += crossed(option.boxes[:, None, :] + _GROWN, leaders)
        led = np.flatnonzero(~np.isnan(option.leaders[:, 0]))
        if len(led):
            own = option.leaders[led][:, None, :]
            found[led] += crossed(boxes[None, :, :] + _GROWN, own)
            found[np.ix_(led, others)] += meeting(own, leaders)
        return found

    def _take(self, k: int, option: int) -> None:
        self.taken[k] += 1
        self.chosen[k] = option
        self.boxes[k] = self.options[k].boxes[option]
        self.leaders[k] = self.options[k].leaders[option]

    def unhappy(self) -> list[int]:
        """The labels that overlap something now."""
        rows = [slice(chosen, chosen + 1) for chosen in self.chosen]
        return [k for k in range(len(self.labels)) if self.costs(k, rows[k])[0] >= HARD]

    def repair(self) -> None:
        """Move what overlaps to its cheapest place, or push the labels in the way aside."""
        for _ in range(_SWEEPS):
            before = list(self.chosen)
            for k in self.unhappy():
                costs = self.costs(k)
                self._take(k, int(np.argmin(costs)))
                if costs.min() >= HARD:
                    self._push(k)
            if self.chosen == before:
                return

    def _push(self, k: int) -> None:
        """Give label k a place held by others, if every one of them finds another."""
        kept = list(self.chosen)
        free = [int(c) for c in np.argsort(self.static[k], kind="stable") if self.static[k][c] < HARD]
        for option in free:
            if self.moves > PATIENCE:
                return
            self._take(k, option)
            held = np.flatnonzero(self._meets(k)[0][option])
            if all(self._moves(int(j)) for j in held) and self.costs(k)[option] < HARD:
                return
            for j, place in enumerate(kept):
                if self.chosen[j] != place:
                    self._take(j, place)

    def _moves(self, k: int) -> bool:
        self.moves += 1
        costs = self.costs(k)
        self._take(k, int(np.argmin(costs)))
        return bool(costs.min() < HARD)

    def widen(self) -> bool:
        """Give labels that still overlap places farther off, with leader lines; False if none is left to be given."""
        late = [k for k in self.unhappy() if k not in self.wide]
        self.wide |= set(late)
        if not late:
            return False
        far = [far_off(self.labels[k], self.extents[k], FAR) for k in late]
        for k, option, cost in zip(late, far, self._judged(far, leaders=True), strict=True):
            self.options[k] = union(self.options[k], option)
            self.static[k] = np.concatenate([self.static[k], cost])
            self.met[k] = _Met(self.options[k], len(self.labels))
        return True

    def placed(self) -> tuple[tuple[Text, ...], tuple[Line, ...]]:
        """The chosen places as texts and leader lines."""
        texts, leaders = [], []
        for k, label in enumerate(self.labels):
            base = complex(self.boxes[k, 0], self.boxes[k, 1] - self.extents[k][1])
            texts.append(Text(label.text, base, label.height, layer=label.layer, name=label.name))
            if not math.isnan(self.leaders[k, 0].real):
                leaders.append(Line(tuple(complex(z) for z in self.leaders[k]), "thin", label.layer, name="leader"))
        return tuple(texts), tuple(leaders)


def _bounded(counts: Any) -> Any:
    """Numbers of what is disliked: beyond some it hardly gets worse."""
    return np.minimum(counts, ENOUGH) + 0.02 * counts


def _overlaps(boxes: Any, others: Any, beside: float = CLEAR_MM) -> Any:
    """Which boxes (rows) come near which others (columns): ``beside`` mm sideways and CLEAR_MM in height.

    Labels without a place yet come near nothing.
    """
    a, b = boxes[:, None, :], others[None, :, :]
    return (
        (a[..., 0] < b[..., 2] + beside)
        & (b[..., 0] < a[..., 2] + beside)
        & (a[..., 1] < b[..., 3] + CLEAR_MM)
        & (b[..., 1] < a[..., 3] + CLEAR_MM)
    )
