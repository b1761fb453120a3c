"""The driver's places from which curves are drawn: runs between dead points, where forces may jump, and stations."""

from __future__ import annotations

import numpy as np

from planes.diagrams.driven import FULL
from planes.diagrams.motion import dead_points, driven_grid, ends_of
from planes.geometry.arrays import Array
from planes.plans import Plans

BESIDE = 1e-6  # degrees (or metres) on either side of a dead point, where what depends on the sense of motion jumps
STEPS = 720
STATIONS = 12


class Runs:
    """Places of the driver between two ends, split where the driven link stands still."""

    def __init__(self, plans: Plans, start: float, end: float) -> None:
        self.plans, self.start, self.end = plans, start, end
        places = driven_grid(plans, start, end)
        self.dead, self.closed = dead_points(places), places.closed

    @classmethod
    def whole(cls, plans: Plans) -> Runs:
        """Over the working range: a whole turn from the first extreme position, if there is one."""
        return cls(plans, *ends_of(plans)[:2])

    def pieces(self) -> list[Array]:
        """Places in runs between dead points, each run up to the very point."""
        dead = self._dead()
        inside = sorted(d for d in dead if self.start + BESIDE < d < self.end - BESIDE)
        first, last = (BESIDE * any(abs(d - end) <= BESIDE for d in dead) for end in (self.start, self.end))
        edges = [self.start + first, *(e for d in inside for e in (d - BESIDE, d + BESIDE)), self.end - last]
        step = (self.end - self.start) / STEPS
        return [
            np.linspace(a, b, max(2, round((b - a) / step) + 1)) for a, b in zip(edges[::2], edges[1::2], strict=True)
        ]

    def _dead(self) -> set[float]:
        return {d + FULL * k for d in self.dead for k in ((-1, 0, 1) if self.closed else (0,))}

    def stations(self) -> Array:
        """Places of the numbered positions: every twelfth part of the range (of a turn, 30°), from the start."""
        return np.linspace(self.start, self.end, STATIONS + 1)

    def read_stations(self) -> Array:
        """The same, those on a dead point just past it: on the point itself a load that opposes motion is nothing."""
        return np.array([z + BESIDE * any(abs(z - d) < BESIDE for d in self._dead()) for z in self.stations()])
