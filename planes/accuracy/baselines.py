"""Other methods for the same results, for comparison only: Newton's iteration on closed loops, and differences of
positions.

Nothing in the program depends on this module. Unknowns are the pose (x, y, angle) of every link; a hinge requires that
two places coincide, a slider that it is on its guide and does not turn relative to it.
"""

import cmath
import math
from collections.abc import Callable
from functools import cached_property

import numpy as np

from planes.geometry.arithmetic import Point
from planes.geometry.arrays import Array, ArrayPair
from planes.plans import Plans
from planes.plans.assur.groups import Pair
from planes.scene.mechanism import FRAME
from planes.words.frozen import frozen

NEWTON_TOLERANCE = 1e-12
MOST_NEWTON_STEPS = 50
FRAME_POSE = (0.0, 0.0, 0.0)  # the pose of the frame


@frozen
class Loops:
    """The constraints of a mechanism, and of its drive: an angle (rad) or a slider's position along its guide (m). The
    pose of the frame, all zeros, comes after those of the links."""

    plans: Plans

    @property
    def links(self) -> list[str]:
        return list(self.plans.mechanism.links)

    @cached_property
    def pose_column_by_link(self) -> dict[str, int]:
        """The first column of every link's pose."""
        return {link: 3 * k for k, link in enumerate((*self.links, FRAME))}

    def pose_of_link(self, q: Array, link: str) -> tuple[complex, float]:
        """The place and the angle of a link, or their rates."""
        k = self.pose_column_by_link[link]
        return complex(q[k], q[k + 1]), float(q[k + 2])

    def drive_position(self, q: Array) -> float:
        """The drive's position in a pose."""
        pair = self.plans.structure.drive_pair
        if pair.kind == "R":
            return self.pose_of_link(q, pair.link)[1] - self.pose_of_link(q, pair.other)[1]
        return self._slider_place_on_guide(q, pair).real

    def drive_target_in_loop_units(self, q: Array, value: float) -> float:
        """A position of the drive (degrees or m) in the units of the loops, with the pose's count of whole turns."""
        if self.plans.drive.kind == "s":
            return value
        phi = math.radians(value)
        return phi + 2 * math.pi * round((self.drive_position(q) - phi) / (2 * math.pi))

    def constraint_residuals(self, q: Array, value: float) -> Array:
        """The residuals of the constraints, the drive's last."""
        residuals = []
        for pair in self.plans.structure.pairs:
            residuals += self._hinge_residuals(q, pair) if pair.kind == "R" else self._slider_residuals(q, pair)
        return np.array([*residuals, self.drive_position(q) - value])

    def place_of_point(self, q: Array, link: str, point: str) -> complex:
        origin, angle = self.pose_of_link(q, link)
        return origin + self.plans.mechanism.link(link).points[point] * cmath.exp(1j * angle)

    def _hinge_residuals(self, q: Array, pair: Pair) -> list[float]:
        gap = self.place_of_point(q, pair.link, pair.point) - self.place_of_point(q, pair.other, pair.point)
        return [gap.real, gap.imag]

    def _slider_residuals(self, q: Array, pair: Pair) -> list[float]:
        slides = self.plans.mechanism.link(pair.link).slides
        assert slides
        turned = (
            self.pose_of_link(q, pair.link)[1]
            - self._position_along_guide(q, pair)
            - math.radians(slides.angle_deg or 0.0)
        )
        return [self._slider_place_on_guide(q, pair).imag - (slides.offset or 0.0), turned]

    def _position_along_guide(self, q: Array, pair: Pair) -> float:
        return self.pose_of_link(q, pair.other)[1] + math.radians(self.plans.mechanism.guide(pair.guide).angle_deg)

    def _slider_place_on_guide(self, q: Array, pair: Pair) -> complex:
        """The place of the slider's first point, along the guide and to the left of it."""
        mechanism = self.plans.mechanism
        origin, turn = self.pose_of_link(q, pair.other)
        on_guide = origin + mechanism.guide(pair.guide).through * cmath.exp(1j * turn)
        first = self.place_of_point(q, pair.link, mechanism.link(pair.link).first_point)
        return (first - on_guide) * cmath.exp(-1j * self._position_along_guide(q, pair))

    def constraint_jacobian(self, q: Array) -> Array:
        """Derivatives of the constraints."""
        rows = []
        for pair in self.plans.structure.pairs:
            rows += self._hinge_slopes(q, pair) if pair.kind == "R" else self._slider_slopes(q, pair)[1:]
        return np.array([*rows, self._drive_slope(q)])[:, : -len(FRAME_POSE)]

    def _drive_slope(self, q: Array) -> Array:
        pair = self.plans.structure.drive_pair
        if pair.kind == "P":
            return self._slider_slopes(q, pair)[0]
        return self._relative_rotation_derivative(q, pair)

    def _relative_rotation_derivative(self, q: Array, pair: Pair) -> Array:
        """The derivative of the relative rotation of a pair."""
        row = np.zeros(len(q))
        for link, sign in pair.signed_links:
            row[self.pose_column_by_link[link] + 2] = sign
        return row

    def _fill_place_derivatives(
        self, rows: Array, q: Array, link: str, place: complex, unit: complex, sign: float
    ) -> None:
        """Fill in how the components of a link's place, along 1/unit and across it, change with the link's pose."""
        k = self.pose_column_by_link[link]
        arm = place - self.pose_of_link(q, link)[0]
        for column, way in ((k, 1 + 0j), (k + 1, 1j), (k + 2, 1j * arm)):
            part = sign * way * unit
            rows[:, column] += (part.real, part.imag)

    def _hinge_slopes(self, q: Array, pair: Pair) -> list[Array]:
        rows = np.zeros((2, len(q)))
        for link, sign in pair.signed_links:
            self._fill_place_derivatives(rows, q, link, self.place_of_point(q, link, pair.point), 1 + 0j, sign)
        return list(rows)

    def _slider_slopes(self, q: Array, pair: Pair) -> list[Array]:
        """Derivatives of the position along the guide, of that across it, and of the relative rotation."""
        rows = np.zeros((2, len(q)))
        back = cmath.exp(-1j * self._position_along_guide(q, pair))
        first = self.place_of_point(q, pair.link, self.plans.mechanism.link(pair.link).first_point)
        for link, sign in pair.signed_links:  # the guide's line moves as a rigid body
            self._fill_place_derivatives(rows, q, link, first, back, sign)
        return [*rows, self._relative_rotation_derivative(q, pair)]

    def nearest_pose_by_newton(self, q: Array, value: float) -> Array:
        """The nearest pose by iteration; convergence is not checked."""
        for _ in range(MOST_NEWTON_STEPS):
            step = np.linalg.solve(self.constraint_jacobian(q), -self.constraint_residuals(q, value))
            q = q + np.append(step, FRAME_POSE)
            if np.abs(step).max() < NEWTON_TOLERANCE:
                break
        return q

    def pose_rates(self, q: Array, velocity: float, acceleration: float) -> ArrayPair:
        """Velocities and accelerations of the pose, from the linear system of the constraints."""
        slopes = self.constraint_jacobian(q)
        drive = np.zeros(len(slopes))
        drive[-1] = 1.0  # its equation is the last
        v = np.append(np.linalg.solve(slopes, drive * velocity), FRAME_POSE)
        return v, np.append(
            np.linalg.solve(slopes, drive * acceleration - self._constraint_second_derivatives(q, v)), FRAME_POSE
        )

    def _constraint_second_derivatives(self, q: Array, v: Array) -> Array:
        """The second derivatives of the constraints at zero acceleration of the pose: exact, centripetal and Coriolis
        terms."""
        bends = []
        for pair in self.plans.structure.pairs:
            bend = self._pair_second_derivative(q, v, pair)
            bends += [bend.real, bend.imag] if pair.kind == "R" else [bend.imag, 0.0]
        pair = self.plans.structure.drive_pair
        return np.array([*bends, self._pair_second_derivative(q, v, pair).real if pair.kind == "P" else 0.0])

    def _pair_second_derivative(self, q: Array, v: Array, pair: Pair) -> complex:
        """The same for one pair: for a hinge in the frame's axes, for a slider in its guide's."""
        (own, a), (carried, b) = (self._link_motion_at_pair(q, v, link, pair) for link in (pair.link, pair.other))
        if pair.kind == "R":
            return a - b
        coriolis = 2j * self.pose_of_link(v, pair.other)[1] * (own - carried)
        return (a - b - coriolis) * cmath.exp(-1j * self._position_along_guide(q, pair))

    def _link_motion_at_pair(self, q: Array, v: Array, link: str, pair: Pair) -> tuple[complex, complex]:
        """The velocity and centripetal acceleration of a link at a pair (for a slider at its first point)."""
        point = pair.point if pair.kind == "R" else self.plans.mechanism.link(pair.link).first_point
        place = self.place_of_point(q, pair.link, point)
        speed, turns = self.pose_of_link(v, link)
        arm = place - self.pose_of_link(q, link)[0]
        return speed + 1j * turns * arm, -(turns**2) * arm

    def point_motions(self, q: Array, v: Array, a: Array) -> dict[str, tuple[complex, complex, complex]]:
        """Place, velocity and acceleration of every point of the moving links."""
        rates = {}
        for link in self.links:
            (origin, angle), (speed, omega), (quick, epsilon) = (self.pose_of_link(x, link) for x in (q, v, a))
            for name, local in self.plans.mechanism.link(link).points.items():
                arm = local * cmath.exp(1j * angle)
                rates[name] = origin + arm, speed + 1j * omega * arm, quick + (1j * epsilon - omega**2) * arm
        return rates

    def start_pose(self, number: Callable[[str], Point]) -> Array:
        """A start pose, taken from a drawing."""
        q = []
        for link in self.links:
            first = self.plans.mechanism.link(link).first_point
            angle = math.radians(float(number(self.plans.links[link].angle)))
            local = self.plans.mechanism.link(link).points[first]
            place = complex(number(self.plans.points[first].position)) - local * cmath.exp(1j * angle)
            q += [place.real, place.imag, angle]
        return np.array([*q, *FRAME_POSE])


def rates_by_central_differences(
    here: Point, back: Point, on: Point, velocity: float, acceleration: float, step: float
) -> tuple[Point, Point]:
    """Velocities and accelerations by central differences of places a ``step`` of the drive (rad or m) apart."""
    slope = (on - back) / (2 * step)
    bend = (on - 2 * here + back) / step**2
    return slope * velocity, bend * velocity**2 + slope * acceleration
