"""Conditions on the links of a drawing: rigid bodies, sliders on their guides, equilibrium of every link."""

from collections.abc import Iterator
from functools import reduce
from operator import add

from planes.drafting.proofs import Facts, Proof
from planes.geometry import plane
from planes.geometry.arithmetic import Point as Complex
from planes.geometry.arithmetic import Real
from planes.words.frozen import frozen
from planes.words.names import VELOCITY_PLAN, Mark, MarkTuple, PlanId

PLAN_DERIVATIVE_ORDER = {"position": 0, "velocity": 1, "acceleration": 2}


@frozen
class Point:
    """A point of a link: its local coordinate and its marks on the scheme and on the velocity and acceleration
    plans."""

    local: complex
    marks: MarkTuple

    @property
    def scheme_mark_of_point(self) -> Mark:
        """Its mark on the scheme."""
        return self.marks[0]

    def mark_on_plan(self, plan: PlanId) -> Mark:
        """Its mark on a plan."""
        return self.marks[PLAN_DERIVATIVE_ORDER[plan]]


@frozen
class LinkMotion:
    """The position and rotation of a link: one of its points, and names of its x axis, ω and ε ("" where it never
    turns)."""

    origin: Point
    axis: str = ""
    omega: str = ""
    epsilon: str = ""

    def distance_from_rigid_place(self, plan: PlanId, shown: Facts, point: Point) -> Complex:
        """The distance of a point, on the plan and in SI, from its place as a point of this link."""
        vector = shown.vector_between_marks(self.origin.mark_on_plan(plan), point.mark_on_plan(plan))
        if plan == "position":
            return vector - (shown[self.axis] if self.axis else 1.0) * (point.local - self.origin.local)
        return vector - self.spin(plan, shown) * shown.vector_between_marks(
            self.origin.scheme_mark_of_point, point.scheme_mark_of_point
        )

    def spin(self, plan: PlanId, shown: Facts) -> Complex:
        """iω, or iε - ω²: the relative velocity or acceleration of a point divided by its distance."""
        return shown.computed_once((self.omega, self.epsilon, plan), lambda: self._compute_rotation_factor(plan, shown))

    def _compute_rotation_factor(self, plan: PlanId, shown: Facts) -> Complex:
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

    def residuals(self, shown: Facts) -> list[Complex]:
        return [self.body.distance_from_rigid_place(self.plan, shown, p) for p in self.points]

    def term_magnitudes(self, shown: Facts) -> Iterator[Real]:
        if self.plan == "position":
            yield sum(abs(p.local) + abs(self.body.origin.local) for p in self.points)
            return
        yield from (shown.mark_magnitude(p.mark_on_plan(self.plan)) for p in self.points)
        reach = sum(shown.mark_magnitude(p.scheme_mark_of_point) + abs(p.local) for p in self.points) + abs(
            self.body.origin.local
        )
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

    def residuals(self, shown: Facts) -> list[Complex]:
        along = self.turn * (shown[self.owner.axis] if self.owner.axis else 1.0)
        relative = self.owner.distance_from_rigid_place(self.plan, shown, self.slider)
        if self.plan == "acceleration":
            sliding = self.owner.distance_from_rigid_place(VELOCITY_PLAN, shown, self.slider)
            relative = relative - self.owner.spin(VELOCITY_PLAN, shown) * (2 * sliding)
        across = plane.cross(along, relative)
        return [across - self.offset if self.plan == "position" else across]

    def term_magnitudes(self, shown: Facts) -> Iterator[Real]:
        reach = shown.mark_magnitude(self.slider.scheme_mark_of_point) + abs(self.slider.local)
        if self.plan == "position":
            yield reach + abs(self.offset)
            return
        yield from map(shown.mark_magnitude, self.slider.marks[1 : PLAN_DERIVATIVE_ORDER[self.plan] + 1])
        yield shown.ar.size(self.owner.spin(self.plan, shown)) * reach


@frozen
class Balanced(Proof):
    """All forces on a link have zero sum and zero moment: ``forces`` (size, direction, point), sides of ``reactions``
    (start, end, ±1, point, couple), ``couples`` (value, ±1)."""

    forces: tuple[tuple[str, str, Mark], ...]
    reactions: tuple[tuple[Mark, Mark, int, Mark, str], ...]
    couples: tuple[tuple[str, int], ...]
    reason = "link_unbalanced"

    def residuals(self, shown: Facts) -> list[Complex]:
        """The sum of the forces, and the moments about the pole divided by the largest distance from it."""
        at: dict[Mark, Complex] = {}
        for force, sign, point in self._acting_forces(shown):
            before = at.get(point, 0.0)
            at[point] = before + force if sign > 0 else before - force
        far = reduce(shown.ar.maximum, map(shown.mark_magnitude, at))
        moments = [plane.cross(shown.mark(point), force) for point, force in at.items()]
        moments += [sign * shown[name] for name, sign in self.couples]
        moments += [sign * shown[couple] for _, _, sign, _, couple in self.reactions if couple]
        return [reduce(add, at.values()), reduce(add, moments) / (far + (far == 0))]

    def term_magnitudes(self, shown: Facts) -> Iterator[Real]:
        yield from (shown.ar.size(force) for force, _, _ in self._acting_forces(shown))

    def _acting_forces(self, shown: Facts) -> Iterator[tuple[Complex, int, Mark]]:
        """The forces, each with its sign and its point of application."""
        yield from (
            (shown.vector_between_marks(start, end), sign, point) for start, end, sign, point, _ in self.reactions
        )
        yield from ((shown.vector_along_direction(size, along), 1, point) for size, along, point in self.forces)
