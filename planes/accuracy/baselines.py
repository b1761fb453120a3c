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
from planes.geometry.arrays import Array
from planes.plans import Plans
from planes.plans.assur.groups import Pair
from planes.scene.mechanism import FRAME
from planes.words.frozen import frozen

TOLERANCE, MOST = 1e-12, 50
STILL = (0.0, 0.0, 0.0)  # the pose of the frame


@frozen
class Loops:
    """The constraints of a mechanism, and of its drive: an angle (rad) or a slider's position along its guide (m). The
    pose of the frame, all zeros, comes after those of the links."""

    plans: Plans

    @property
    def links(self) -> list[str]:
        return list(self.plans.mechanism.links)

    @cached_property
    def columns(self) -> dict[str, int]:
        """The first column of every link's pose."""
        return {link: 3 * k for k, link in enumerate((*self.links, FRAME))}

    def pose(self, q: Array, link: str) -> tuple[complex, float]:
        """The place and the angle of a link, or their rates."""
        k = self.columns[link]
        return complex(q[k], q[k + 1]), float(q[k + 2])

    def drive(self, q: Array) -> float:
        """The drive's position in a pose."""
        pair = self.plans.structure.drive_pair
        return (
            self.pose(q, pair.link)[1] - self.pose(q, pair.other)[1] if pair.kind == "R" else self._slid(q, pair).real
        )

    def target(self, q: Array, value: float) -> float:
        """A position of the drive (degrees or m) in the units of the loops, with the pose's count of whole turns."""
        if self.plans.drive.kind == "s":
            return value
        phi = math.radians(value)
        return phi + 2 * math.pi * round((self.drive(q) - phi) / (2 * math.pi))

    def residual(self, q: Array, value: float) -> Array:
        """The residuals of the constraints, the drive's last."""
        residuals: list[float] = []
        for pair in self.plans.structure.pairs:
            residuals += self._hinge(q, pair) if pair.kind == "R" else self._slider(q, pair)
        return np.array([*residuals, self.drive(q) - value])

    def place(self, q: Array, link: str, point: str) -> complex:
        origin, angle = self.pose(q, link)
        return origin + self.plans.mechanism.link(link).points[point] * cmath.exp(1j * angle)

    def _hinge(self, q: Array, pair: Pair) -> list[float]:
        gap = self.place(q, pair.link, pair.point) - self.place(q, pair.other, pair.point)
        return [gap.real, gap.imag]

    def _slider(self, q: Array, pair: Pair) -> list[float]:
        slides = self.plans.mechanism.link(pair.link).slides
        assert slides
        turned = self.pose(q, pair.link)[1] - self._along(q, pair) - math.radians(slides.angle_deg or 0.0)
        return [self._slid(q, pair).imag - (slides.offset or 0.0), turned]

    def _along(self, q: Array, pair: Pair) -> float:
        return self.pose(q, pair.other)[1] + math.radians(self.plans.mechanism.guide(pair.guide).angle_deg)

    def _slid(self, q: Array, pair: Pair) -> complex:
        """The place of the slider's first point, along the guide and to the left of it."""
        mechanism = self.plans.mechanism
        origin, turn = self.pose(q, pair.other)
        on_guide = origin + mechanism.guide(pair.guide).through * cmath.exp(1j * turn)
        first = self.place(q, pair.link, mechanism.link(pair.link).first_point)
        return (first - on_guide) * cmath.exp(-1j * self._along(q, pair))

    def jacobian(self, q: Array) -> Array:
        """Derivatives of the constraints."""
        rows: list[Array] = []
        for pair in self.plans.structure.pairs:
            rows += self._hinge_slopes(q, pair) if pair.kind == "R" else self._slider_slopes(q, pair)[1:]
        return np.array([*rows, self._drive_slope(q)])[:, : -len(STILL)]

    def _drive_slope(self, q: Array) -> Array:
        pair = self.plans.structure.drive_pair
        return self._slider_slopes(q, pair)[0] if pair.kind == "P" else self._turn_slope(q, pair)

    def _turn_slope(self, q: Array, pair: Pair) -> Array:
        """The derivative of the relative rotation of a pair."""
        row = np.zeros(len(q))
        for link, sign in pair.sides:
            row[self.columns[link] + 2] = sign
        return row

    def _fill(self, rows: Array, q: Array, link: str, place: complex, unit: complex, sign: float) -> None:
        """Fill in how the components of a link's place, along 1/unit and across it, change with the link's pose."""
        k = self.columns[link]
        arm = place - self.pose(q, link)[0]
        for column, way in ((k, 1 + 0j), (k + 1, 1j), (k + 2, 1j * arm)):
            part = sign * way * unit
            rows[:, column] += (part.real, part.imag)

    def _hinge_slopes(self, q: Array, pair: Pair) -> list[Array]:
        rows = np.zeros((2, len(q)))
        for link, sign in pair.sides:
            self._fill(rows, q, link, self.place(q, link, pair.point), 1 + 0j, sign)
        return list(rows)

    def _slider_slopes(self, q: Array, pair: Pair) -> list[Array]:
        """Derivatives of the position along the guide, of that across it, and of the relative rotation."""
        rows, back = np.zeros((2, len(q))), cmath.exp(-1j * self._along(q, pair))
        first = self.place(q, pair.link, self.plans.mechanism.link(pair.link).first_point)
        for link, sign in pair.sides:  # the guide's line moves as a rigid body
            self._fill(rows, q, link, first, back, sign)
        return [*rows, self._turn_slope(q, pair)]

    def newton(self, q: Array, value: float) -> Array:
        """The nearest pose by iteration; convergence is not checked."""
        for _ in range(MOST):
            step = np.linalg.solve(self.jacobian(q), -self.residual(q, value))
            q = q + np.append(step, STILL)
            if np.abs(step).max() < TOLERANCE:
                break
        return q

    def rates(self, q: Array, velocity: float, acceleration: float) -> tuple[Array, Array]:
        """Velocities and accelerations of the pose, from the linear system of the constraints."""
        slopes = self.jacobian(q)
        drive = np.zeros(len(slopes))
        drive[-1] = 1.0  # its equation is the last
        v = np.append(np.linalg.solve(slopes, drive * velocity), STILL)
        return v, np.append(np.linalg.solve(slopes, drive * acceleration - self._bends(q, v)), STILL)

    def _bends(self, q: Array, v: Array) -> Array:
        """The second derivatives of the constraints at zero acceleration of the pose: exact, centripetal and Coriolis
        terms."""
        bends: list[float] = []
        for pair in self.plans.structure.pairs:
            bend = self._bend(q, v, pair)
            bends += [bend.real, bend.imag] if pair.kind == "R" else [bend.imag, 0.0]
        pair = self.plans.structure.drive_pair
        return np.array([*bends, self._bend(q, v, pair).real if pair.kind == "P" else 0.0])

    def _bend(self, q: Array, v: Array, pair: Pair) -> complex:
        """The same for one pair: for a hinge in the frame's axes, for a slider in its guide's."""
        (own, a), (carried, b) = (self._moved(q, v, link, pair) for link in (pair.link, pair.other))
        if pair.kind == "R":
            return a - b
        coriolis = 2j * self.pose(v, pair.other)[1] * (own - carried)
        return (a - b - coriolis) * cmath.exp(-1j * self._along(q, pair))

    def _moved(self, q: Array, v: Array, link: str, pair: Pair) -> tuple[complex, complex]:
        """The velocity and centripetal acceleration of a link at a pair (for a slider at its first point)."""
        point = pair.point if pair.kind == "R" else self.plans.mechanism.link(pair.link).first_point
        place = self.place(q, pair.link, point)
        speed, turns = self.pose(v, link)
        arm = place - self.pose(q, link)[0]
        return speed + 1j * turns * arm, -(turns**2) * arm

    def points(self, q: Array, v: Array, a: Array) -> dict[str, tuple[complex, complex, complex]]:
        """Place, velocity and acceleration of every point of the moving links."""
        rates = {}
        for link in self.links:
            (origin, angle), (speed, omega), (quick, epsilon) = (self.pose(x, link) for x in (q, v, a))
            for name, local in self.plans.mechanism.link(link).points.items():
                arm = local * cmath.exp(1j * angle)
                rates[name] = origin + arm, speed + 1j * omega * arm, quick + (1j * epsilon - omega**2) * arm
        return rates

    def start(self, number: Callable[[str], Point]) -> Array:
        """A start pose, taken from a drawing."""
        q: list[float] = []
        for link in self.links:
            first = self.plans.mechanism.link(link).first_point
            angle = math.radians(float(number(self.plans.links[link].angle)))
            local = self.plans.mechanism.link(link).points[first]
            place = complex(number(self.plans.points[first].position)) - local * cmath.exp(1j * angle)
            q += [place.real, place.imag, angle]
        return np.array([*q, *STILL])


def differences(
    here: Point, back: Point, on: Point, velocity: float, acceleration: float, step: float
) -> tuple[Point, Point]:
    """Velocities and accelerations by central differences of places a ``step`` of the drive (rad or m) apart."""
    slope, bend = (on - back) / (2 * step), (on - 2 * here + back) / step**2
    return slope * velocity, bend * velocity**2 + slope * acceleration
