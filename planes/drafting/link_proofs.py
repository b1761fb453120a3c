"""Conditions on the links of a drawing: rigid bodies, sliders on their guides, equilibrium of every link."""

from collections.abc import Iterator
from functools import reduce
from operator import add

from planes.drafting.proofs import Facts, Proof
from planes.geometry import plane
from planes.geometry.arithmetic import Point as Complex
from planes.geometry.arithmetic import Real
from planes.words.frozen import frozen

ORDER = {"position": 0, "velocity": 1, "acceleration": 2}


@frozen
class Point:
    """A point of a link: its local coordinate and its marks on the scheme and on the velocity and acceleration
    plans."""

    local: complex
    marks: tuple[str, ...]

    @property
    def place(self) -> str:
        """Its mark on the scheme."""
        return self.marks[0]

    def on(self, plan: str) -> str:
        """Its mark on a plan."""
        return self.marks[ORDER[plan]]


@frozen
class LinkMotion:
    """The position and rotation of a link: one of its points, and names of its x axis, ω and ε ("" where it never
    turns)."""

    origin: Point
    axis: str = ""
    omega: str = ""
    epsilon: str = ""

    def off(self, plan: str, shown: Facts, point: Point) -> Complex:
        """The distance of a point, on the plan and in SI, from its place as a point of this link."""
        vector = shown.vector(self.origin.on(plan), point.on(plan))
        if plan == "position":
            return vector - (shown[self.axis] if self.axis else 1.0) * (point.local - self.origin.local)
        return vector - self.spin(plan, shown) * shown.vector(self.origin.place, point.place)

    def spin(self, plan: str, shown: Facts) -> Complex:
        """iω, or iε - ω²: the relative velocity or acceleration of a point divided by its distance."""
        return shown.once((self.omega, self.epsilon, plan), lambda: self._spin(plan, shown))

    def _spin(self, plan: str, shown: Facts) -> Complex:
        omega = shown[self.omega] if self.omega else 0.0
        if plan == "velocity":
            return 1j * omega
        return 1j * (shown[self.epsilon] if self.epsilon else 0.0) - omega**2


@frozen
class Rigid(Proof):
    """The points of a link keep their distances, and their velocities or accelerations are those of one rotating
    body."""

    body: LinkMotion
    points: tuple[Point, ...]
    reason = "link_bent"

    def nothing(self, shown: Facts) -> list[Complex]:
        return [self.body.off(self.plan, shown, p) for p in self.points]

    def sizes(self, shown: Facts) -> Iterator[Real]:
        if self.plan == "position":
            yield sum(abs(p.local) + abs(self.body.origin.local) for p in self.points)
            return
        yield from (shown.size(p.on(self.plan)) for p in self.points)
        reach = sum(shown.size(p.place) + abs(p.local) for p in self.points) + abs(self.body.origin.local)
        yield shown.ar.size(self.body.spin(self.plan, shown)) * reach  # no smaller for a turn about its hinge


@frozen
class Slid(Proof):
    """A point of a slider stays on its guide: its motion relative to the guide's link has no component across the
    guide."""

    slider: Point  # its place as a point of the guide's link, if the guide were where it belongs
    owner: LinkMotion
    turn: complex  # the guide's direction in its link's axes
    offset: float
    reason = "slider_off"

    def nothing(self, shown: Facts) -> list[Complex]:
        along = self.turn * (shown[self.owner.axis] if self.owner.axis else 1.0)
        relative = self.owner.off(self.plan, shown, self.slider)
        if self.plan == "acceleration":
            sliding = self.owner.off("velocity", shown, self.slider)
            relative = relative - self.owner.spin("velocity", shown) * (2 * sliding)
        across = plane.cross(along, relative)
        return [across - self.offset if self.plan == "position" else across]

    def sizes(self, shown: Facts) -> Iterator[Real]:
        reach = shown.size(self.slider.place) + abs(self.slider.local)
        if self.plan == "position":
            yield reach + abs(self.offset)
            return
        yield from map(shown.size, self.slider.marks[1 : ORDER[self.plan] + 1])
        yield shown.ar.size(self.owner.spin(self.plan, shown)) * reach


@frozen
class Balanced(Proof):
    """All forces on a link have zero sum and zero moment: ``forces`` (size, direction, point), sides of ``reactions``
    (start, end, ±1, point, couple), ``couples`` (value, ±1)."""

    forces: tuple[tuple[str, str, str], ...]
    reactions: tuple[tuple[str, str, int, str, str], ...]
    couples: tuple[tuple[str, int], ...]
    reason = "link_unbalanced"

    def nothing(self, shown: Facts) -> list[Complex]:
        """The sum of the forces, and the moments about the pole divided by the largest distance from it."""
        at: dict[str, Complex] = {}
        for force, sign, point in self._acting(shown):
            before = at.get(point, 0.0)
            at[point] = before + force if sign > 0 else before - force
        far = reduce(shown.ar.maximum, map(shown.size, at))
        moments = [plane.cross(shown.mark(point), force) for point, force in at.items()]
        moments += [sign * shown[name] for name, sign in self.couples]
        moments += [sign * shown[couple] for _, _, sign, _, couple in self.reactions if couple]
        return [reduce(add, at.values()), reduce(add, moments) / (far + (far == 0))]

    def sizes(self, shown: Facts) -> Iterator[Real]:
        yield from (shown.ar.size(force) for force, _, _ in self._acting(shown))

    def _acting(self, shown: Facts) -> Iterator[tuple[Complex, int, str]]:
        """The forces, each with its sign and its point of application."""
        yield from ((shown.vector(start, end), sign, point) for start, end, sign, point, _ in self.reactions)
        yield from ((shown.along(size, along), 1, point) for size, along, point in self.forces)
