"""What a place of a label does to the candidates of all others: which it clashes with, and which it stands close to.

Boxes are ruled out by their sides before a leader is held against them.
"""

from __future__ import annotations

from functools import cached_property
from typing import NamedTuple

import numpy as np

from planes.geometry.arrays import Array, Booleans, Complexes, Indices
from render.labels.candidates import APART_MM, BETWEEN, CLEAR_MM, GROWN, Candidates
from render.labels.footprints import crossed, meeting

MEETING = np.array([-1, -1, 1, 1]) * 4.0  # mm; leaders farther apart do not meet, though each counts a little longer


class Effect(NamedTuple):
    """What a chosen place does to the candidates of other labels: which it clashes with and how often, and which it
    stands close to."""

    clashing: Indices
    clashes: Indices
    near: Indices


class Everywhere:
    """The candidates of all labels in one list."""

    def __init__(self, every: Candidates) -> None:
        self.every, self.sides = every, np.ascontiguousarray(every.boxes.T)

    @cached_property
    def led(self) -> Indices:
        """Those with leaders."""
        return np.flatnonzero(~np.isnan(self.every.leaders[:, 0]))

    @cached_property
    def _around(self) -> Array:
        """The sides of the boxes around the leaders."""
        return _sides(self.every.leaders[self.led])

    def effect(self, row: int, own: slice) -> Effect:
        """What the place at a row does to all others but its label's ``own``."""
        every, (x0, y0, x1, y1) = self.every, self.every.boxes[row].tolist()
        left, low, right, top = self.sides
        sideways, apart = np.maximum(left - x1, x0 - right), np.maximum(low - y1, y0 - top)
        letter = np.minimum(every.heights, every.heights[row])
        clashes = ((sideways < BETWEEN[0] * letter) & (apart < BETWEEN[1] * letter)).astype(np.intp)
        clashes += (sideways < 0.0) & (apart < 0.0)
        if len(self.led):
            box = np.array([x0, y0, x1, y1])
            at = self.led[_over(self._around, box + GROWN)]
            clashes[at] += crossed(box + GROWN, every.leaders[at])
            self._led(clashes, every.leaders[row])
        near = (sideways < APART_MM) & (apart < CLEAR_MM)
        clashes[own], near[own] = 0, False
        clashing = np.flatnonzero(clashes)
        return Effect(clashing, clashes[clashing], np.flatnonzero(near))

    def _led(self, clashes: Indices, leader: Complexes) -> None:
        """Count what a leader goes through, if there is one."""
        if np.isnan(leader[0]):
            return
        every, around = self.every, _sides(leader[None])[:, 0]
        at = np.flatnonzero(_over(self.sides, around + GROWN))
        clashes[at] += crossed(every.boxes[at] + GROWN, leader)
        at = self.led[_over(self._around, around + MEETING)]
        clashes[at] += meeting(every.leaders[at], leader)


def _sides(leaders: Complexes) -> Array:
    """The sides (4, n) of the boxes around leaders."""
    x, y = leaders.real, leaders.imag
    return np.array([x.min(axis=1), y.min(axis=1), x.max(axis=1), y.max(axis=1)])


def _over(sides: Array, box: Array) -> Booleans:
    """Which boxes, by their sides, reach another one."""
    (left, low, right, top), (x0, y0, x1, y1) = sides, box.tolist()
    found: Booleans = (left <= x1) & (right >= x0) & (low <= y1) & (top >= y0)
    return found
