"""What must hold of the links of a drawing: rigid bodies, sliders on their guides, every link in equilibrium."""

from dataclasses import dataclass
from functools import reduce
from typing import ClassVar

from planes.drafting.proofs import Proof, Things, in_si
from planes.geometry import plane
from planes.geometry.arithmetic import Arithmetic, Real
from planes.geometry.arithmetic import Point as Complex

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

    def at(self, plan: str, things: Things, local: complex, place: Complex) -> Complex:
        """What the plan must show, in SI, for the point of this link that lies at ``local`` or at ``place``."""
        start = in_si(things, self.origin.on(plan))
        if plan == "position":
            return start + (things[self.axis] if self.axis else 1.0) * (local - self.origin.local)
        return start + self.spin(plan, things) * (place - in_si(things, self.origin.place))

    def spin(self, plan: str, things: Things) -> Complex:
        """iω, or iε - ω²: what the rate of a point is beside its distance."""
        omega = things[self.omega] if self.omega else 0.0
        if plan == "velocity":
            return 1j * omega
        return 1j * (things[self.epsilon] if self.epsilon else 0.0) - omega**2


@dataclass(frozen=True)
class Rigid(Proof):
    """The points of a link keep their distances, and their rates are those of one turning body."""

    body: LinkMotion
    points: tuple[Point, ...]
    reason: ClassVar[str] = "link_bent"

    def gap(self, things: Things, ar: Arithmetic) -> Real:
        return sum(ar.size(self._bent(p, things)) for p in self.points)

    def _bent(self, p: Point, things: Things) -> Complex:
        return in_si(things, p.on(self.plan)) - self.body.at(self.plan, things, p.local, in_si(things, p.place))

    def size(self, things: Things, ar: Arithmetic) -> Real:
        if self.plan == "position":
            return sum(abs(p.local) + abs(self.body.origin.local) for p in self.points)
        reach = sum(ar.size(in_si(things, p.place)) + abs(p.local) for p in self.points) + abs(self.body.origin.local)
        turning = ar.size(self.body.spin(self.plan, things)) * reach  # one about its hinge is no less long
        return turning + sum(ar.size(in_si(things, p.on(self.plan))) for p in self.points)


@dataclass(frozen=True)
class Slid(Proof):
    """A point of a slider stays on its guide: nothing of its motion against the guide's link is across the guide."""

    slider: Point
    owner: LinkMotion
    through: complex
    turn: complex  # the guide's direction in its link's axes
    offset: float
    reason: ClassVar[str] = "slider_off"

    def gap(self, things: Things, ar: Arithmetic) -> Real:
        owner, place = self.owner, in_si(things, self.slider.place)
        along = self.turn * (things[owner.axis] if owner.axis else 1.0)
        if self.plan == "position":
            return abs(plane.cross(along, place - owner.at(self.plan, things, self.through, place)) - self.offset)
        relative = in_si(things, self.slider.on("velocity")) - owner.at("velocity", things, 0j, place)
        if self.plan == "acceleration":
            coriolis = 2 * owner.spin("velocity", things) * relative
            relative = in_si(things, self.slider.on("acceleration")) - owner.at(self.plan, things, 0j, place) - coriolis
        return abs(plane.cross(along, relative))

    def size(self, things: Things, ar: Arithmetic) -> Real:
        if self.plan == "position":
            return ar.size(in_si(things, self.slider.place)) + abs(self.through) + abs(self.offset)
        reach = ar.size(in_si(things, self.slider.place)) + abs(self.through)
        turning = ar.size(self.owner.spin(self.plan, things)) * reach
        return turning + sum(ar.size(in_si(things, mark)) for mark in self.slider.marks[1 : ORDER[self.plan] + 1])


@dataclass(frozen=True)
class Balanced(Proof):
    """All forces on a link add up to nothing, and so do their moments: ``forces`` (size, direction, point), sides of
    ``reactions`` (start, end, ±1, point, couple), ``couples`` (value, ±1)."""

    forces: tuple[tuple[str, str, str], ...]
    reactions: tuple[tuple[str, str, int, str, str], ...]
    couples: tuple[tuple[str, int], ...]
    reason: ClassVar[str] = "link_unbalanced"

    def gap(self, things: Things, ar: Arithmetic) -> Real:
        """Of the forces, and of the moments about the pole divided by the largest distance from it."""
        acting = self._acting(things)
        far = reduce(ar.maximum, (ar.size(place) for _, place in acting))
        moments = [plane.cross(place, force) for force, place in acting]
        moments += [sign * things[name] for name, sign in self.couples]
        moments += [sign * things[couple] for _, _, sign, _, couple in self.reactions if couple]
        return ar.size(sum(force for force, _ in acting)) + abs(sum(moments)) / (far + (far == 0))

    def size(self, things: Things, ar: Arithmetic) -> Real:
        return sum(ar.size(force) for force, _ in self._acting(things))

    def _acting(self, things: Things) -> list[tuple[Complex, Complex]]:
        """The forces and the places they act at."""
        given = [(things[size] * things[along], in_si(things, point)) for size, along, point in self.forces]
        return given + [
            (sign * (in_si(things, end) - in_si(things, start)), in_si(things, point))
            for start, end, sign, point, _ in self.reactions
        ]
