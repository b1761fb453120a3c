"""Several links in hinges over the drive and one length: every assembly on a grid, and where two of them merge.

No single angle determines such links. So assemblies found at nodes of the grid, from random poses, are followed from
node to node as far as they exist: a sheet over the field. At the edge of a sheet two assemblies merge, in a fold.
"""

from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np

from planes.accuracy.continuation import Curves, Room
from planes.geometry.arrays import Array, Booleans, Indices
from planes.geometry.tracks import Pose, Tie, advanced, hung_on, origins

SOWN, RIPE = 12, 30  # start poses at every node, and the number of steps from each
MOST = 48  # assemblies of a node
NEWTON = 8  # steps from one node to the next
BEND = 0.6  # of the links' size, and radians: largest change in a step
SETTLED, SAME = 1e-9, 1e-6
WIDE = 1e6  # of the links' size: a hinge may lie anywhere
NEAR = 3.0  # steps of the grid: a fold this close to a curve is on it

TiesAt = Callable[[Array, Array], list[Tie]]  # by positions of the drive and logarithms of the length


class Sheets:
    """The assemblies of links on ties over a grid of drive positions, ``across`` (periodic if it ``turns``), and of
    logarithms of a length."""

    def __init__(self, ties: TiesAt, size: float, across: Array, up: Array, turns: bool) -> None:
        self.ties_at, self.size, self.across, self.up, self.turns = ties, size, across, up, turns
        self.columns = len(across) - turns
        y, x = np.meshgrid(up, across[: self.columns], indexing="ij")
        self.spots = np.array([x.ravel(), y.ravel()])
        self.ties = self.over(*self.spots)
        self.links = len(hung_on(self.ties))
        self.poses = np.full((MOST, len(self.spots[0]), 1 + self.links), np.nan, complex)
        self.count = np.zeros(len(self.spots[0]), int)
        self.ends: list[Array] = []  # drive, logarithm and pose at the edge of a sheet
        self._follow()

    @property
    def counted(self) -> Indices:
        """The number of assemblies on the grid."""
        counts = self.count.reshape(len(self.up), self.columns)
        return np.hstack([counts, counts[:, :1]]) if self.turns else counts

    def over(self, x: Array, y: Array) -> list[Tie]:
        """The ties at many places, lengths divided by the links' size."""
        each = np.ones(len(x)) / self.size
        many = ((t, t.local * each, t.place * each, t.reach * each) for t in self.ties_at(x, y))
        return [replace(t, local=a, place=b, reach=c, turn=t.turn * each * self.size) for t, a, b, c in many]

    def _follow(self) -> None:
        """Search, then follow every new assembly to the four neighbouring nodes."""
        rng = np.random.default_rng(0)
        for _ in range(SOWN):
            at, poses = self._added(*self._sown(rng))
            while len(at):
                beside = [self._beside(at, poses, *way) for way in ((0, 1), (0, -1), (1, 0), (-1, 0))]
                at, poses = self._added(*(np.concatenate(x) for x in zip(*beside, strict=True)))

    def _sown(self, rng: np.random.Generator) -> tuple[Indices, Array]:
        """Assemblies found from one pose at every node."""
        held = np.array([t.place for t in self.ties if t.kind != "hinge"])
        middle, many = held.mean(axis=0), len(self.count)
        reach = 1.0 + abs(held - middle).max(axis=0)
        place = middle + reach * (rng.uniform(-1, 1, many) + 1j * rng.uniform(-1, 1, many))
        poses, lasts = self._settled(self.ties, (place, *np.exp(2j * np.pi * rng.random((self.links, many)))), RIPE)[:2]
        return np.flatnonzero(lasts), poses[lasts]

    def _settled(self, ties: list[Tie], pose: Pose, steps: int) -> tuple[Array, Booleans, Array]:
        """The results of Newton's steps, where they converge, and the determinants."""
        with np.errstate(all="ignore"):
            for _ in range(steps):
                pose, moved, det = advanced(ties, pose)
            poses = np.array(pose).T
            return poses, (moved < SETTLED) & (abs(det) > 0) & (abs(abs(poses[:, 1:]) - 1).max(axis=1) < SETTLED), det

    def _added(self, at: Indices, poses: Array) -> tuple[Indices, Array]:
        """Those of some assemblies that are new; they are recorded."""
        new = np.zeros(len(at), bool)
        while True:
            known = (abs(self.poses[:, at] - poses) < SAME).all(axis=2).any(axis=0)
            left = np.flatnonzero(~known & ~new & (self.count[at] < MOST))
            if not len(left):
                return at[new], poses[new]
            first = left[np.unique(at[left], return_index=True)[1]]
            self.poses[self.count[at[first]], at[first]] = poses[first]
            self.count[at[first]] += 1
            new[first] = True

    def _beside(self, at: Indices, poses: Array, down: int, right: int) -> tuple[Indices, Array]:
        """The same assemblies at the neighbouring nodes, where they exist; otherwise the sheet ends."""
        row, column = np.divmod(at, self.columns)
        row, column = row + down, column + right
        inside = (row >= 0) & (row < len(self.up))
        inside &= self.turns | ((column >= 0) & (column < self.columns))
        at, poses = at[inside], poses[inside]
        next_ = (row * self.columns + column % self.columns)[inside]
        sign = np.sign(advanced(_of(self.ties, at), tuple(poses.T))[2])
        ties = _of(self.ties, next_)
        moved, settled, det = self._settled(ties, tuple(poses.T), NEWTON)
        lasts = settled & (abs(moved - poses).max(axis=1) < BEND) & (det * sign > 0)
        middle = (self.spots[:, at] + self.spots[:, next_]) / 2
        if self.turns and right:
            middle[0] = self.spots[0, at] + right * (self.across[1] - self.across[0]) / 2
        ended = ~lasts & np.isfinite(ties[0].place)
        self.ends += [_laid(middle[:, k], poses[k]) for k in np.flatnonzero(ended)]
        return next_[lasts], moved[lasts]

    def equations(self, at: Array) -> Array:
        """The ties and the determinant at places: drive, logarithm, hinge, angles of the links."""
        ties = self.over(at[0], at[1])
        pose = (at[2] + 1j * at[3], *np.exp(1j * at[4:]))
        places = origins(ties, pose)
        missed = [t.wrench(places[t.link], pose[1 + t.link])[0] for t in ties if t.kind != "hinge"]
        return np.array([*missed, advanced(ties, pose)[2]])

    def curves(self, step: float) -> list[Array]:
        """The folds, one row for each place along them."""
        turn, angles = 2 * np.pi, self.links
        low = np.array([self.across[0], self.up[0], -WIDE, -WIDE, *[0.0] * angles])
        high = np.array([self.across[-1], self.up[-1], WIDE, WIDE, *[turn] * angles])
        periods = np.array([turn * self.turns, 0.0, 0.0, 0.0, *[turn] * angles])
        curves = Curves(self.equations, Room(low, high, periods, step))
        grid = np.hypot(self.across[1] - self.across[0], self.up[1] - self.up[0])
        for near in self._few(curves, NEAR * grid):
            curves.add(near, BEND)
        return curves.found

    def _few(self, curves: Curves, near: float) -> Iterator[Array]:
        """Places at the edge of sheets, without those on a known curve."""
        for end in self.ends:
            gaps = (curves.room.apart(end, curve) for curve in curves.found)
            if not any(
                (np.hypot(gap[:, 0], gap[:, 1]).min() < near and np.linalg.norm(gap, axis=1).min() < BEND)
                for gap in gaps
            ):
                yield end


def _laid(spot: Array, pose: Array) -> Array:
    return np.array([*spot, pose[0].real, pose[0].imag, *np.angle(pose[1:])])


def _of(ties: list[Tie], k: int | Indices) -> list[Tie]:
    """The ties at some of many places."""
    return [replace(t, local=t.local[k], place=t.place[k], reach=t.reach[k], turn=t.turn[k]) for t in ties]
