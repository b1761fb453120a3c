"""What must hold of the links of a drawing: rigid bodies, sliders on their guides, every link in equilibrium."""

from dataclasses import dataclass
from functools import reduce
from typing import ClassVar

from planes.drafting.proofs import Facts, Proof
from planes.geometry import plane
from planes.geometry.arithmetic import Point as Complex
from planes.geometry.arithmetic import Real

ORDER = {"position": 0, "velocity": 1, "acceleration": 2}


@dataclass(frozen=True)
class Point:
    """A point of a link: its own coordinate and its marks on the scheme and on the plans of rates."""

    local: complex
    marks: tuple[str, ...]

    @property
    def place(self) -> str:
        """Its mark on the scheme."""
        return self.marks[0]

    def on(self, plan: str) -> str:
        """Its mark on a plan."""
        return self.marks[ORDER[plan]]


@dataclass(frozen=True)
class LinkMotion:
    """How a link lies and turns: a point of it, and names of its x axis, ω and ε ("" where it never turns)."""

    origin: Point
    axis: str = ""
    omega: str = ""
    epsilon: str = ""

    def at(self, plan: str, shown: Facts, local: complex, place: Complex) -> Complex:
        """What the plan must show, in SI, for the point of this link that lies at ``local`` or at ``place``."""
        start = shown.mark(self.origin.on(plan))
        if plan == "position":
            return start + (shown[self.axis] if self.axis else 1.0) * (local - self.origin.local)
        return start + self.spin(plan, shown) * (place - shown.mark(self.origin.place))

    def spin(self, plan: str, shown: Facts) -> Complex:
        """iω, or iε - ω²: what the rate of a point is beside its distance."""
        return shown.once((self.omega, self.epsilon, plan), lambda: self._spin(plan, shown))

    def _spin(self, plan: str, shown: Facts) -> Complex:
        omega = shown[self.omega] if self.omega else 0.0
        if plan == "velocity":
            return 1j * omega
        return 1j * (shown[self.epsilon] if self.epsilon else 0.0) - omega**2


@dataclass(frozen=True)
class Rigid(Proof):
    """The points of a link keep their distances, and their rates are those of one turning body."""

    body: LinkMotion
    points: tuple[Point, ...]
    reason: ClassVar[str] = "link_bent"

    def gap(self, shown: Facts) -> Real:
        return sum(shown.ar.size(self._bent(p, shown)) for p in self.points)

    def _bent(self, p: Point, shown: Facts) -> Complex:
        return shown.mark(p.on(self.plan)) - self.body.at(self.plan, shown, p.local, shown.mark(p.place))

    def size(self, shown: Facts) -> Real:
        if self.plan == "position":
            return sum(abs(p.local) + abs(self.body.origin.local) for p in self.points)
        reach = sum(shown.size(p.place) + abs(p.local) for p in self.points) + abs(self.body.origin.local)
        turning = shown.ar.size(self.body.spin(self.plan, shown)) * reach  # one about its hinge is no less long
        return turning + sum(shown.size(p.on(self.plan)) for p in self.points)


@dataclass(frozen=True)
class Slid(Proof):
    """A point of a slider stays on its guide: nothing of its motion against the guide's link is across the guide."""

    slider: Point
    owner: LinkMotion
    through: complex
    turn: complex  # the guide's direction in its link's axes
    offset: float
    reason: ClassVar[str] = "slider_off"

    def gap(self, shown: Facts) -> Real:
        owner, place = self.owner, shown.mark(self.slider.place)
        along = self.turn * (shown[owner.axis] if owner.axis else 1.0)
        if self.plan == "position":
            return abs(plane.cross(along, place - owner.at(self.plan, shown, self.through, place)) - self.offset)
        relative = shown.mark(self.slider.on("velocity")) - owner.at("velocity", shown, 0j, place)
        if self.plan == "acceleration":
            coriolis = 2 * owner.spin("velocity", shown) * relative
            relative = shown.mark(self.slider.on("acceleration")) - owner.at(self.plan, shown, 0j, place) - coriolis
        return abs(plane.cross(along, relative))

    def size(self, shown: Facts) -> Real:
        if self.plan == "position":
            return shown.size(self.slider.place) + abs(self.through) + abs(self.offset)
        reach = shown.size(self.slider.place) + abs(self.through)
        turning = shown.ar.size(self.owner.spin(self.plan, shown)) * reach
        return turning + sum(map(shown.size, self.slider.marks[1 : ORDER[self.plan] + 1]))


@dataclass(frozen=True)
class Balanced(Proof):
    """All forces on a link add up to nothing, and so do their moments: ``forces`` (size, direction, point), sides of
    ``reactions`` (start, end, ±1, point, couple), ``couples`` (value, ±1)."""

    forces: tuple[tuple[str, str, str], ...]
    reactions: tuple[tuple[str, str, int, str, str], ...]
    couples: tuple[tuple[str, int], ...]
    reason: ClassVar[str] = "link_unbalanced"

    def gap(self, shown: Facts) -> Real:
        return self.compared(shown)[0]

    def size(self, shown: Facts) -> Real:
        return self.compared(shown)[1]

    def compared(self, shown: Facts) -> tuple[Real, Real]:
        """Of the forces, and of the moments about the pole divided by the largest distance from it."""
        acting = self._acting(shown)
        far = reduce(shown.ar.maximum, (shown.size(point) for _, point in acting))
        moments = [plane.cross(shown.mark(point), force) for force, point in acting]
        moments += [sign * shown[name] for name, sign in self.couples]
        moments += [sign * shown[couple] for _, _, sign, _, couple in self.reactions if couple]
        gap = shown.ar.size(sum(force for force, _ in acting)) + abs(sum(moments)) / (far + (far == 0))
        return gap, sum(shown.ar.size(force) for force, _ in acting)

    def _acting(self, shown: Facts) -> list[tuple[Complex, str]]:
        """The forces and the points they act at."""
        given = [(shown[size] * shown[along], point) for size, along, point in self.forces]
        return given + [
            (sign * (shown.mark(end) - shown.mark(start)), point) for start, end, sign, point, _ in self.reactions
        ]
