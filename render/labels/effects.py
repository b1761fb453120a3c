"""What a place of a label does to the candidates of all others: which it clashes with, and which it stands close to."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from planes.geometry.arrays import Indices
from render.labels.candidates import APART_MM, BETWEEN, Candidates, met
from render.labels.nearness import over
from render.paper.style import LARGER

REACH_MM = max(APART_MM, BETWEEN[0] * max(LARGER.values()))  # how far off a label has anything to do with another
_AROUND = REACH_MM * np.array([-1.0, -0.5, 1.0, 0.5])


class Effect(NamedTuple):
    """What a chosen place does to the candidates of other labels: which it clashes with and how often, and which it
    stands close to."""

    clashing: Indices
    clashes: Indices
    near: Indices


class Everywhere:
    """The candidates of all labels in one list."""

    def __init__(self, every: Candidates) -> None:
        self.every, self.reach = every, np.ascontiguousarray(every.reach.T)

    def effect(self, row: int, own: slice) -> Effect:
        """What the place at a row does to all others but its label's ``own``."""
        reached = over(self.reach, self.reach[:, row] + _AROUND)
        reached[own] = False
        at = np.flatnonzero(reached)
        clashes, near = met(self.every.some(at), self.every.some(np.array([row])))
        clashing = np.flatnonzero(clashes[:, 0])
        return Effect(at[clashing], clashes[clashing, 0], at[near[:, 0]])
