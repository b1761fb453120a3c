"""Curve following: solutions of n equations in n + 1 unknowns, by Newton's steps across the predicted direction."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

import numpy as np

from planes.geometry.arrays import Array, ArrayPair
from planes.words.frozen import frozen

Equations = Callable[[Array], Array]
"""For many points, one per column: the residual of every equation, one per row; NaN where it is undefined."""
DERIVATIVE_STEP = 1e-6  # step for numerical derivatives
MOST_SETTLED_STEP = 1e-11  # largest last step of Newton's method
MOST_NEWTON_STEPS = 12  # steps, at most
# derivatives closer to dependent than this give no direction: there may be solutions, but no single curve
LEAST_INDEPENDENCE_RATIO = 1e-7
LEAST_TURN_COSINE = 0.97  # cosine of the largest turn in a step
SHORTEST_STEP_RATIO = 2.0**-12  # of the step: where a curve needs a shorter one, it ends
MOST_STEPS_EACH_SIDE = 4000  # steps to one side
ON_CURVE_STEP_RATIO = 0.12  # of the step: a place this close to a curve is on it


@frozen
class Room:
    """The region for curves: between ``low`` and ``high``, periodic in unknowns with a period (else 0)."""

    low: Array
    high: Array
    periods: Array
    step: float

    def contains_place(self, place: Array) -> bool:
        """Whether a place lies in the region."""
        ends = self.periods == 0
        return bool(np.all((place >= self.low)[ends]) and np.all((place <= self.high)[ends]))

    def shortest_vector(self, one: Array, two: Array) -> Array:
        """The vector from one place to another, or to many, the shorter way round."""
        gap = two - one
        round_about = np.where(self.periods > 0, self.periods, 1.0)
        return np.where(self.periods > 0, gap - round_about * np.round(gap / round_about), gap)


@dataclass
class Curves:
    """The curves found so far, each with a row for each place along it."""

    equations: Equations
    room: Room
    found: list[Array] = field(default_factory=list)

    def add_curve_near(self, near: Array, reach: float) -> None:
        """Follow the curve near a place, at most ``reach`` away, if it is a new one."""
        start = self.settle_on_curve(near)
        if (
            start is None
            or np.linalg.norm(self.room.shortest_vector(near, start)) > reach
            or not self.room.contains_place(start)
        ):
            return
        if any(self._is_on_curve(curve, start) for curve in self.found):
            return
        way = self.curve_direction(start)
        ahead = [start, *self._places_on_one_side(start, way)]
        closed = len(ahead) > 3 and np.linalg.norm(self.room.shortest_vector(start, ahead[-1])) < 1e-9
        behind = [] if closed else list(self._places_on_one_side(start, -way))
        self.found.append(np.array(behind[::-1] + ahead))

    def settle_on_curve(self, near: Array) -> Array | None:
        """The place on a curve by Newton's steps, each of minimum length."""
        place = near
        for _ in range(MOST_NEWTON_STEPS):
            left, slopes = self._residuals_and_derivatives(place)
            if not (np.isfinite(left).all() and np.isfinite(slopes).all()):
                return None
            step = np.linalg.lstsq(slopes, left, rcond=None)[0]
            place = place - step
            if np.linalg.norm(step) < MOST_SETTLED_STEP:
                sizes = np.linalg.svd(slopes, compute_uv=False)
                if sizes[-1] > LEAST_INDEPENDENCE_RATIO * sizes[0]:
                    return place
                return None
        return None

    def curve_direction(self, place: Array) -> Array:
        """The direction in which no equation changes."""
        return np.asarray(np.linalg.svd(self._residuals_and_derivatives(place)[1])[2][-1])

    def _residuals_and_derivatives(self, place: Array) -> ArrayPair:
        """The residuals at a place, and their derivatives."""
        by = DERIVATIVE_STEP * np.eye(len(place))
        left = self.equations(place[:, None] + np.hstack([np.zeros((len(place), 1)), by, -by]))
        ahead = left[:, 1 : len(place) + 1]
        behind = left[:, len(place) + 1 :]
        return left[:, 0], (ahead - behind) / (2 * DERIVATIVE_STEP)

    def _places_on_one_side(self, start: Array, way: Array) -> Iterator[Array]:
        """Places to one side: to the end of the region or of the curve, or back to the start."""
        place = start
        step = self.room.step / 4
        for gone in range(MOST_STEPS_EACH_SIDE):
            while step > self.room.step * SHORTEST_STEP_RATIO:
                advance = self._next_place_on_curve(place, way, step)
                if advance:
                    break
                step /= 2
            else:
                return
            back = self.room.shortest_vector(place, start)
            if gone > 2 and np.linalg.norm(back) < 1.5 * step and back @ way > 0:
                yield place + back  # back at the start
                return
            place, way = advance
            yield place
            if not self.room.contains_place(place):
                return
            step = min(2 * step, self.room.step)

    def _next_place_on_curve(self, place: Array, way: Array, step: float) -> ArrayPair | None:
        """The next place and direction, if the curve turns little on the way."""
        ahead = self.settle_on_curve(place + step * way)
        if ahead is None or abs(np.linalg.norm(ahead - place) / step - 1) > 0.1:
            return None
        on = self.curve_direction(ahead)
        on = on if on @ way > 0 else -on
        return (ahead, on) if on @ way > LEAST_TURN_COSINE else None

    def _is_on_curve(self, curve: Array, place: Array) -> bool:
        """Whether a place is on a curve."""
        one = self.room.shortest_vector(place, curve[:-1])
        along = self.room.shortest_vector(curve[:-1], curve[1:])
        part = np.clip(-(one * along).sum(axis=1) / np.maximum((along * along).sum(axis=1), 1e-300), 0.0, 1.0)
        return bool((np.linalg.norm(one + part[:, None] * along, axis=1) < ON_CURVE_STEP_RATIO * self.room.step).any())
