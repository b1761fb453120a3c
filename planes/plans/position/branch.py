"""One assembly of a triad followed as the drive moves, to both ends of its range, and stored as a series.

Every step is extrapolated from the last ones and corrected by Newton's method. It is halved until the correction is
small and the lines of the three leads keep their sense about each other, which changes only at a dead point. There the
range ends: two assemblies merge, and beyond there is none.
"""

import cmath
import math
from bisect import bisect
from collections.abc import Callable, Sequence

from planes.drafting.steps.tracks import MOST_SETTLED_MOVE_RATIO, chebyshev_sum, settle_pose_on_ties
from planes.geometry.arithmetic import Arithmetic
from planes.geometry.tracks import Pose, Tie
from planes.words.errors import PlanFailure
from planes.words.frozen import frozen

DRIVE_STEP_DEG = 1.0  # of the drive, degrees
FULL_TURN_DEG = 360.0
SLIDING_STEPS_EACH_SIDE = 360  # of a sliding drive to either side, each one ninetieth of the link's size
STEP_HALVINGS = 40
MOST_STEP_CORRECTION = 0.02  # the largest correction of a step, of the link's size and radians
FAR_AWAY_LINK_SIZES = 30.0  # sizes of the link: beyond that it has run away
STEP_FRACTIONS = (1.0, 0.5, 0.25, 0.1)
SERIES_TERM_COUNTS = (32, 64, 128, 256)
# of the range, at its ends, where a series is not tested: two assemblies are too close there
UNTESTED_RANGE_EDGE = 1e-7

Ties = Callable[[float], list[Tie]]  # the leads at a position of the drive


@frozen
class Waypoint:
    """A point of the path: the drive's position, the leads there and the pose of the link on them."""

    value: float
    ties: list[Tie]
    pose: Pose


@frozen
class Branch:
    """The range of the drive where an assembly exists, and its series there (places over the link's size, radians)."""

    low: float
    high: float
    side: float
    places: tuple[complex, ...]
    turns: tuple[tuple[float, ...], ...]  # of each link

    def pose_from_series(self, value: float) -> Pose:
        """The pose from the series, for a link of unit size."""
        part = (value - (self.low + self.high) / 2) / ((self.high - self.low) / 2)
        y = 2 * math.acos(min(1.0, max(-1.0, part))) / math.pi - 1
        axes = (cmath.exp(1j * float(chebyshev_sum(list(terms), y))) for terms in self.turns)
        return complex(chebyshev_sum(list(self.places), y)), *axes


class _Way:
    """The path of one assembly."""

    def __init__(self, ties: Ties, start: float, pose: Pose, size: float, turning: bool) -> None:
        self.ties = ties
        self.size = size
        self.ar = Arithmetic()
        self.turning = turning
        self.home = pose[0]
        self.step = DRIVE_STEP_DEG if turning else size / 90.0
        self.start, sharpness = self.settle_predicted_pose(start, ties(start), pose)
        self.sign = math.copysign(1.0, sharpness)

    def settle_predicted_pose(self, value: float, ties: list[Tie], near: Pose) -> tuple[Waypoint, float]:
        """The pose near a predicted one, and its signed sharpness: 0 where there is none."""
        pose, _, _ = settle_pose_on_ties(ties, near, self.size, self.ar)
        pose, det, moved = settle_pose_on_ties(ties, pose, self.size, self.ar)
        off = _pose_difference(pose, near, self.size)
        good = (
            moved < 0.1 * MOST_SETTLED_MOVE_RATIO
            and off < MOST_STEP_CORRECTION
            and abs(pose[0] - self.home) < FAR_AWAY_LINK_SIZES * self.size
        )
        return Waypoint(value, ties, pose), det if good else 0.0

    def find_pose_at(self, value: float, near: Pose) -> Waypoint | None:
        """The pose at a position of the drive, if the assembly exists there."""
        try:
            spot, det = self.settle_predicted_pose(value, self.ties(value), near)
        except (ArithmeticError, PlanFailure):
            return None
        return spot if det * self.sign > 0 else None

    def poses_on_one_side(self, way: float, reach: float) -> list[Waypoint]:
        """The poses to one side, the start first, as far as the assembly exists or ``reach``."""
        spots = [self.start]
        step = self.step
        while (gone := abs(spots[-1].value - self.start.value)) < reach and step > self.step * 2.0**-STEP_HALVINGS:
            value = spots[-1].value + way * min(step, reach - gone)
            waypoint = self.find_pose_at(value, _extrapolate_pose(spots, value)) if value != spots[-1].value else None
            if waypoint:
                spots.append(waypoint)
            step = min(self.step, 2 * step) if waypoint else step / 2
        return spots

    def poses_on_path(self) -> list[Waypoint]:
        """The whole path, by growing positions of the drive: at most one turn."""
        if not self.turning:
            reach = SLIDING_STEPS_EACH_SIDE * self.step
            return [*reversed(self.poses_on_one_side(-1.0, reach)[1:]), *self.poses_on_one_side(1.0, reach)]
        ahead = self.poses_on_one_side(1.0, FULL_TURN_DEG / 2)
        behind = self.poses_on_one_side(-1.0, FULL_TURN_DEG - (ahead[-1].value - self.start.value))
        left = FULL_TURN_DEG - (self.start.value - behind[-1].value)
        ahead = (
            self.poses_on_one_side(1.0, left)
            if left > FULL_TURN_DEG / 2 and ahead[-1].value == self.start.value + FULL_TURN_DEG / 2
            else ahead
        )
        return [*reversed(behind[1:]), *ahead]


def _extrapolate_pose(spots: Sequence[Waypoint], value: float) -> Pose:
    """The extrapolation of the last two poses."""
    if len(spots) > 1:
        return _interpolate_pose(spots[-2], spots[-1], value)
    return spots[-1].pose


def _interpolate_pose(one: Waypoint, two: Waypoint, value: float) -> Pose:
    """The linear interpolation between two poses."""
    part = (value - one.value) / (two.value - one.value)
    p, *before = one.pose
    q, *after = two.pose
    axes = (u * cmath.exp(1j * cmath.phase(w / u) * part) for u, w in zip(before, after, strict=True))
    return p + (q - p) * part, *axes


def _pose_difference(one: Pose, two: Pose, size: float) -> float:
    """The difference of two poses, in sizes of the link and radians."""
    return float(max(abs(one[0] - two[0]) / size, *(abs(u - w) for u, w in zip(one[1:], two[1:], strict=True))))


def follow_branch(ties: Ties, start: float, pose: Pose, size: float, turning: bool) -> Branch | None:
    """The branch of a pose at the drive's ``start``; None where no series represents it."""
    way = _Way(ties, start, pose, size, turning)
    spots = way.poses_on_path()
    for near in STEP_FRACTIONS:  # where no series represents all of it, the poses about the start
        part = [
            s for s in spots if (spots[0].value - start) * near <= s.value - start <= (spots[-1].value - start) * near
        ]
        for count in SERIES_TERM_COUNTS if len(part) > 1 else ():
            branch = _fit_branch_series(way, part, count)
            if branch and _series_reproduces_path(way, branch, part):
                return branch
    return None


def _fit_branch_series(way: _Way, spots: list[Waypoint], count: int) -> Branch | None:
    """The series with so many terms, through as many poses on the path."""
    low = spots[0].value
    high = spots[-1].value
    values = [s.value for s in spots]
    places = []
    turns = [list[float]() for _ in way.start.pose[1:]]
    for j in range(count):  # from the highest position of the drive down
        tau = math.pi * (1 - math.cos(math.pi * (j + 0.5) / count)) / 2
        value = (low + high) / 2 + (high - low) / 2 * math.cos(tau)
        k = min(max(bisect(values, value), 1), len(spots) - 1)
        spot = way.find_pose_at(value, _interpolate_pose(spots[k - 1], spots[k], value))
        if spot is None:
            return None
        places.append(spot.pose[0] / way.size)
        for axis, turned in zip(spot.pose[1:], turns, strict=True):
            last = turned[-1] if turned else 0.0
            turned.append(last + cmath.phase(axis * cmath.exp(-1j * last)))
    terms = (tuple(_chebyshev_coefficient(k, turned[::-1]).real for k in range(count)) for turned in turns)
    return Branch(
        low, high, way.sign, tuple(_chebyshev_coefficient(k, places[::-1]) for k in range(count)), tuple(terms)
    )


def _chebyshev_coefficient(k: int, values: Sequence[complex]) -> complex:
    """A term of Chebyshev's series through values at its nodes."""
    count = len(values)
    cosines = (math.cos(math.pi * k * (j + 0.5) / count) for j in range(count))
    return (2.0 if k else 1.0) / count * sum(x * c for x, c in zip(values, cosines, strict=True))


def _series_reproduces_path(way: _Way, branch: Branch, spots: Sequence[Waypoint]) -> bool:
    """Whether the series leads to every pose of the path, and to no other."""
    edge = UNTESTED_RANGE_EDGE * (branch.high - branch.low)
    for spot in (s for s in spots if branch.low + edge <= s.value <= branch.high - edge):
        place, *axes = branch.pose_from_series(spot.value)
        try:
            pose, det, moved = settle_pose_on_ties(spot.ties, (place * way.size, *axes), way.size, way.ar)
        except ArithmeticError:
            return False
        if not (
            _pose_difference(pose, spot.pose, way.size) < MOST_SETTLED_MOVE_RATIO
            and moved < MOST_SETTLED_MOVE_RATIO
            and det * way.sign > 0
        ):
            return False
    return True
