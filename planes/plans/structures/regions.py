"""Bow's notation: the regions into which a truss and its forces divide the plane.

Clockwise around a joint the regions have the same order as the forces in its polygon; so it is around the truss, too.
"""

import cmath
import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import pairwise

from planes.scene.structures import Framework
from planes.words.names import POLE_LABEL, NamePair, NamesByName, NameTriple

REGION_LETTERS = POLE_LABEL + "abcdefghijklmnoqrstuvwxyz"
"""First letter of the regions: that before the first force is the pole of the plan."""
OUTER_LETTER_DISTANCE_RATIO = 0.12  # distance of an outer region's letter from the truss, of the truss's size
Side = NamePair  # a directed member, from one joint to the other: its region is on the right
Visit = NameTriple  # a joint of the contour, with the next one clockwise and the one before


def region_letter(k: int) -> str:
    """The letter of a region: p, a, b, … z, a1, b1, …"""
    turn, own = divmod(k - 1, len(REGION_LETTERS) - 1)
    return REGION_LETTERS[own + 1] + str(turn or "") if k else POLE_LABEL


@dataclass
class Outside:
    """An external force: its name, its joint, and its direction."""

    name: str
    joint: str
    way: complex


@dataclass
class Regions:
    """The regions by the sides of members: ``right`` is that of each side; ``before`` and ``after`` are those of each
    force, which are ``ordered`` clockwise around the truss."""

    framework: Framework
    forces: list[Outside]
    right: dict[Side, str] = field(default_factory=dict)
    before: NamesByName = field(default_factory=dict)
    after: NamesByName = field(default_factory=dict)
    ordered: list[Outside] = field(default_factory=list)
    places: dict[str, complex] = field(default_factory=dict)  # of letters on the scheme, m

    def letter_regions(self) -> str | None:
        """Letter all regions; or return the name of a loaded joint inside the truss, which the notation does not
        allow."""
        faces = self.regions_by_sides()
        outer = max(faces, key=self.enclosed_area)
        border = {a for a, _ in outer}
        if loose := next((f.joint for f in self.forces if f.joint not in border), None):
            return loose
        self.letter_outer_regions(outer)
        inner = sorted(
            (f for f in faces if f is not outer), key=lambda f: (round(self.middle_of_corners(f).real, 6), f)
        )
        for k, face in enumerate(inner, len(self.ordered)):
            self.right |= dict.fromkeys(face, region_letter(k))
            self.places[region_letter(k)] = self.middle_of_corners(face)
        return None

    def vector_between_joints(self, start: str, end: str) -> complex:
        """From joint to joint."""
        return self.framework.points[end] - self.framework.points[start]

    def regions_by_sides(self) -> list[list[Side]]:
        """Every region by its sides, with the region on their right: inner ones clockwise, the outer
        counter-clockwise."""
        left = dict.fromkeys(side for a, b in self.framework.members for side in ((a, b), (b, a)))
        faces = list[list[Side]]()
        while left:
            face = []
            side = next(iter(left))
            while side in left:
                face.append(side)
                left.pop(side)
                side = self.next_side_of_region(side)
            faces.append(face)
        return faces

    def next_side_of_region(self, side: Side) -> Side:
        """The next side with the same region on its right: the first counter-clockwise from the way back."""
        a, b = side
        ends = [y if x == b else x for x, y in self.framework.members if b in (x, y)]
        return b, min(
            ends,
            key=lambda c: counterclockwise_angle(self.vector_between_joints(b, a), self.vector_between_joints(b, c)),
        )

    def enclosed_area(self, face: list[Side]) -> float:
        """The area enclosed by a region's sides, positive counter-clockwise."""
        points = self.framework.points
        return sum((points[a].conjugate() * points[b]).imag for a, b in face) / 2

    def middle_of_corners(self, face: list[Side]) -> complex:
        """The middle of a region's corners."""
        return sum(self.framework.points[a] for a, _ in face) / len(face)

    def forces_around_joint(self, joint: str) -> list[NameTriple]:
        """Every force at a joint clockwise: its name, and the regions before and after it."""
        ordered = [(f.name, self.before[f.name], self.after[f.name]) for f in self.ordered if f.joint == joint]
        left = []
        for a, b in (m for m in self.framework.members if joint in m):
            other = b if a == joint else a
            left.append((f"S_{a}{b}", self.right[other, joint], self.right[joint, other]))
        while left:
            after = next((x for x in left if ordered and x[1] == ordered[-1][2]), left[0])
            ordered.append(after)
            left.remove(after)
        return ordered

    # external ones

    def letter_outer_regions(self, outer: list[Side]) -> None:
        """Letter the outer regions from force to force, clockwise around the truss from its first load."""
        visits = [(b, a, c) for (a, b), (_, c) in pairwise([*outer, outer[0]])][::-1]
        order = list(self.forces_along_contour(visits))
        first = next(k for k, (_, f) in enumerate(order) if f is self.forces[0])
        first = next(k for k, (visit, _) in enumerate(order) if visit == order[first][0])
        order = order[first:] + order[:first]
        self.ordered = [f for _, f in order]
        for k, f in enumerate(self.ordered):
            self.before[f.name], self.after[f.name] = region_letter(k), region_letter((k + 1) % len(order))
        passed = {visit: self.after[f.name] for visit, f in order}
        start = order[0][0]
        now = POLE_LABEL
        runs: dict[str, list[Visit]] = {}
        for k in [*range(start, len(visits)), *range(start)]:
            now = passed.get(k, now)
            joint, onward, _ = visits[k]
            self.right[onward, joint] = now
            runs.setdefault(now, []).append(visits[k])
        self.places |= {region: self.place_of_outer_letter(own) for region, own in runs.items()}

    def forces_along_contour(self, visits: list[Visit]) -> Iterator[tuple[int, Outside]]:
        """The forces in order along the contour, each with the number of the visit."""
        left = list(self.forces)
        for k, (joint, onward, back) in enumerate(visits):
            sector = counterclockwise_angle(
                self.vector_between_joints(joint, onward), self.vector_between_joints(joint, back)
            )
            later = any(v[0] == joint for v in visits[k + 1 :])
            here = [(self.drawn_force_angle(f, onward), f) for f in left if f.joint == joint]
            here = [(angle, f) for angle, f in here if angle <= sector + 1e-9 or not later]
            for _, f in sorted(here, key=lambda one: -one[0]):
                left.remove(f)
                yield k, f

    def drawn_force_angle(self, f: Outside, onward: str) -> float:
        """The angle at which a force is drawn outside the truss, counter-clockwise from the next joint: its arrow comes
        from there or points there, whatever its direction."""
        start = self.vector_between_joints(f.joint, onward)
        return min(counterclockwise_angle(start, f.way), counterclockwise_angle(start, -f.way))

    def place_of_outer_letter(self, run: list[Visit]) -> complex:
        """The place of an outer region's letter: beside the middle member of its stretch of the contour."""
        joint, onward, _ = run[(len(run) - 1) // 2]
        points = self.framework.points
        size = max(abs(a - b) for a in points.values() for b in points.values())
        way = self.vector_between_joints(joint, onward)
        return points[joint] + way / 2 + 1j * way / abs(way) * OUTER_LETTER_DISTANCE_RATIO * size


def counterclockwise_angle(start: complex, way: complex) -> float:
    """The angle counter-clockwise from one direction to another, in (0, 2π]."""
    angle = cmath.phase(way / start) % math.tau
    return angle if angle > 1e-9 else math.tau
