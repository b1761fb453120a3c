"""Several links in hinges over the drive and one length: every assembly on a grid, and where two of them merge.

No single angle determines such links. So assemblies found at nodes of the grid, from random poses, are followed from
node to node as far as they exist: a sheet over the field. At the edge of a sheet two assemblies merge, in a fold.
"""

from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np

from planes.accuracy.continuation import Curves, Room
from planes.geometry.arrays import Array, Booleans, Indices
from planes.geometry.tracks import Pose, Tie, carrier_links, link_origins, newton_step

START_POSES_PER_NODE = 12  # start poses at every node
STEPS_PER_START_POSE = 30  # steps from each of them
MOST_ASSEMBLIES_PER_NODE = 48  # assemblies of a node
NEWTON_STEPS_PER_NODE = 8  # steps from one node to the next
MOST_STEP_CHANGE = 0.6  # of the links' size, and radians: largest change in a step
MOST_SETTLED_STEP = 1e-9
SAME_POSE_DISTANCE = 1e-6
FARTHEST_HINGE_SIZES = 1e6  # of the links' size: a hinge may lie anywhere
ON_CURVE_DISTANCE_STEPS = 3.0  # steps of the grid: a fold this close to a curve is on it

TiesAt = Callable[[Array, Array], list[Tie]]  # by positions of the drive and logarithms of the length


class Sheets:
    """The assemblies of links on ties over a grid of drive positions, ``across`` (periodic if it ``turns``), and of
    logarithms of a length."""

    def __init__(self, ties: TiesAt, size: float, across: Array, up: Array, turns: bool) -> None:
        self.ties_at = ties
        self.size = size
        self.across = across
        self.up = up
        self.turns = turns
        self.columns = len(across) - turns
        y, x = np.meshgrid(up, across[: self.columns], indexing="ij")
        self.spots = np.array([x.ravel(), y.ravel()])
        self.ties = self.ties_at_places(*self.spots)
        self.links = len(carrier_links(self.ties))
        self.poses = np.full((MOST_ASSEMBLIES_PER_NODE, len(self.spots[0]), 1 + self.links), np.nan, complex)
        self.count = np.zeros(len(self.spots[0]), int)
        self.ends: list[Array] = []  # drive, logarithm and pose at the edge of a sheet
        self._follow_assemblies()

    @property
    def assembly_counts(self) -> Indices:
        """The number of assemblies on the grid."""
        counts = self.count.reshape(len(self.up), self.columns)
        return np.hstack([counts, counts[:, :1]]) if self.turns else counts

    def ties_at_places(self, x: Array, y: Array) -> list[Tie]:
        """The ties at many places, lengths divided by the links' size."""
        each = np.ones(len(x)) / self.size
        many = ((t, t.local * each, t.place * each, t.reach * each) for t in self.ties_at(x, y))
        return [replace(t, local=a, place=b, reach=c, turn=t.turn * each * self.size) for t, a, b, c in many]

    def _follow_assemblies(self) -> None:
        """Search, then follow every new assembly to the four neighbouring nodes."""
        rng = np.random.default_rng(0)
        for _ in range(START_POSES_PER_NODE):
            at, poses = self._add_new_assemblies(*self._assemblies_from_random_poses(rng))
            while len(at):
                beside = [self._neighbouring_assemblies(at, poses, *way) for way in ((0, 1), (0, -1), (1, 0), (-1, 0))]
                at, poses = self._add_new_assemblies(*map(np.concatenate, zip(*beside, strict=True)))

    def _assemblies_from_random_poses(self, rng: np.random.Generator) -> tuple[Indices, Array]:
        """Assemblies found from one pose at every node."""
        held = np.array([t.place for t in self.ties if t.kind != "hinge"])
        middle = held.mean(axis=0)
        many = len(self.count)
        reach = 1.0 + abs(held - middle).max(axis=0)
        place = middle + reach * (rng.uniform(-1, 1, many) + 1j * rng.uniform(-1, 1, many))
        poses, lasts = self._settle_poses(
            self.ties, (place, *np.exp(2j * np.pi * rng.random((self.links, many)))), STEPS_PER_START_POSE
        )[:2]
        return np.flatnonzero(lasts), poses[lasts]

    def _settle_poses(self, ties: list[Tie], pose: Pose, steps: int) -> tuple[Array, Booleans, Array]:
        """The results of Newton's steps, where they converge, and the determinants."""
        with np.errstate(all="ignore"):
            for _ in range(steps):
                pose, moved, det = newton_step(ties, pose)
            poses = np.array(pose).T
            return (
                poses,
                (moved < MOST_SETTLED_STEP)
                & (abs(det) > 0)
                & (abs(abs(poses[:, 1:]) - 1).max(axis=1) < MOST_SETTLED_STEP),
                det,
            )

    def _add_new_assemblies(self, at: Indices, poses: Array) -> tuple[Indices, Array]:
        """Those of some assemblies that are new; they are recorded."""
        new = np.zeros(len(at), bool)
        while True:
            known = (abs(self.poses[:, at] - poses) < SAME_POSE_DISTANCE).all(axis=2).any(axis=0)
            left = np.flatnonzero(~known & ~new & (self.count[at] < MOST_ASSEMBLIES_PER_NODE))
            if not len(left):
                return at[new], poses[new]
            first = left[np.unique(at[left], return_index=True)[1]]
            self.poses[self.count[at[first]], at[first]] = poses[first]
            self.count[at[first]] += 1
            new[first] = True

    def _neighbouring_assemblies(self, at: Indices, poses: Array, down: int, right: int) -> tuple[Indices, Array]:
        """The same assemblies at the neighbouring nodes, where they exist; otherwise the sheet ends."""
        row, column = np.divmod(at, self.columns)
        row = row + down
        column = column + right
        inside = (row >= 0) & (row < len(self.up))
        inside &= self.turns | ((column >= 0) & (column < self.columns))
        at = at[inside]
        poses = poses[inside]
        next_ = (row * self.columns + column % self.columns)[inside]
        sign = np.sign(newton_step(_ties_at_some_places(self.ties, at), tuple(poses.T))[2])
        ties = _ties_at_some_places(self.ties, next_)
        moved, settled, det = self._settle_poses(ties, tuple(poses.T), NEWTON_STEPS_PER_NODE)
        lasts = settled & (abs(moved - poses).max(axis=1) < MOST_STEP_CHANGE) & (det * sign > 0)
        middle = (self.spots[:, at] + self.spots[:, next_]) / 2
        if self.turns and right:
            middle[0] = self.spots[0, at] + right * (self.across[1] - self.across[0]) / 2
        ended = ~lasts & np.isfinite(ties[0].place)
        self.ends += [_place_with_angles(middle[:, k], poses[k]) for k in np.flatnonzero(ended)]
        return next_[lasts], moved[lasts]

    def fold_equations(self, at: Array) -> Array:
        """The ties and the determinant at places: drive, logarithm, hinge, angles of the links."""
        ties = self.ties_at_places(at[0], at[1])
        pose = (at[2] + 1j * at[3], *np.exp(1j * at[4:]))
        places = link_origins(ties, pose)
        missed = [t.error_and_wrench(places[t.link], pose[1 + t.link])[0] for t in ties if t.kind != "hinge"]
        return np.array([*missed, newton_step(ties, pose)[2]])

    def fold_curves(self, step: float) -> list[Array]:
        """The folds, one row for each place along them."""
        turn = 2 * np.pi
        angles = self.links
        low = np.array([self.across[0], self.up[0], -FARTHEST_HINGE_SIZES, -FARTHEST_HINGE_SIZES, *[0.0] * angles])
        high = np.array([self.across[-1], self.up[-1], FARTHEST_HINGE_SIZES, FARTHEST_HINGE_SIZES, *[turn] * angles])
        periods = np.array([turn * self.turns, 0.0, 0.0, 0.0, *[turn] * angles])
        curves = Curves(self.fold_equations, Room(low, high, periods, step))
        grid = np.hypot(self.across[1] - self.across[0], self.up[1] - self.up[0])
        for near in self._places_off_known_curves(curves, ON_CURVE_DISTANCE_STEPS * grid):
            curves.add_curve_near(near, MOST_STEP_CHANGE)
        return curves.found

    def _places_off_known_curves(self, curves: Curves, near: float) -> Iterator[Array]:
        """Places at the edge of sheets, without those on a known curve."""
        for end in self.ends:
            gaps = (curves.room.shortest_vector(end, curve) for curve in curves.found)
            if not any(
                (np.hypot(gap[:, 0], gap[:, 1]).min() < near and np.linalg.norm(gap, axis=1).min() < MOST_STEP_CHANGE)
                for gap in gaps
            ):
                yield end


def _place_with_angles(spot: Array, pose: Array) -> Array:
    return np.array([*spot, pose[0].real, pose[0].imag, *np.angle(pose[1:])])


def _ties_at_some_places(ties: list[Tie], k: int | Indices) -> list[Tie]:
    """The ties at some of many places."""
    return [replace(t, local=t.local[k], place=t.place[k], reach=t.reach[k], turn=t.turn[k]) for t in ties]
