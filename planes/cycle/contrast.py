"""How others compute the same, for contrast only: Newton's iteration on closed loops, and differences of positions.

Nothing of the program depends on this. Unknowns are the pose (x, y, angle) of every link; a hinge says that two
places coincide, a slider that it stands on its guide and does not turn against it.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from planes.mechanism import FRAME
from planes.plans import Plans
from planes.structure import Pair

TOLERANCE, MOST = 1e-12, 50


@dataclass(frozen=True)
class Loops:
    """The constraints of a mechanism driven by an angle."""

    plans: Plans

    @property
    def links(self) -> list[str]:
        return list(self.plans.mechanism.links)

    def pose(self, q: Any, link: str) -> tuple[complex, float]:
        if link == FRAME:
            return 0j, 0.0
        k = 3 * self.links.index(link)
        return complex(q[k], q[k + 1]), float(q[k + 2])

    def residual(self, q: Any, phi: float) -> Any:
        """What the constraints lack of holding, the drive's last."""
        found: list[float] = []
        for pair in self.plans.structure.pairs:
            found += self._hinge(q, pair) if pair.kind == "R" else self._slider(q, pair)
        return np.array([*found, self.pose(q, self.plans.mechanism.drive.link)[1] - phi])

    def place(self, q: Any, link: str, point: str) -> complex:
        origin, angle = self.pose(q, link)
        return origin + self.plans.mechanism.link(link).points[point] * cmath.exp(1j * angle)

    def _hinge(self, q: Any, pair: Pair) -> list[float]:
        gap = self.place(q, pair.link, pair.point) - self.place(q, pair.other, pair.point)
        return [gap.real, gap.imag]

    def _slider(self, q: Any, pair: Pair) -> list[float]:
        mechanism = self.plans.mechanism
        guide, slides = mechanism.guide(pair.guide), mechanism.link(pair.link).slides
        assert slides
        origin, turn = self.pose(q, pair.other)
        along = turn + math.radians(guide.angle_deg)
        on_guide = origin + guide.through * cmath.exp(1j * turn)
        first = self.place(q, pair.link, mechanism.link(pair.link).first_point)
        aside = ((first - on_guide) * cmath.exp(-1j * along)).imag - (slides.offset or 0.0)
        return [aside, self.pose(q, pair.link)[1] - along - math.radians(slides.angle_deg or 0.0)]

    def jacobian(self, q: Any, phi: float) -> Any:
        """Slopes of the constraints."""
        rows: list[Any] = []
        for pair in self.plans.structure.pairs:
            rows += self._hinge_slopes(q, pair) if pair.kind == "R" else self._slider_slopes(q, pair)
        drive = np.zeros(len(q))
        drive[3 * self.links.index(self.plans.mechanism.drive.link) + 2] = 1.0
        return np.array([*rows, drive])

    def _fill(self, rows: Any, q: Any, link: str, place: complex, unit: complex, sign: float) -> None:
        """How the parts of a place of a link along 1/unit and across it move with the link's pose."""
        if link == FRAME:
            return
        k = 3 * self.links.index(link)
        arm = place - self.pose(q, link)[0]
        for column, way in ((k, 1 + 0j), (k + 1, 1j), (k + 2, 1j * arm)):
            part = sign * way * unit
            rows[:, column] += (part.real, part.imag)

    def _hinge_slopes(self, q: Any, pair: Pair) -> list[Any]:
        rows = np.zeros((2, len(q)))
        for link, sign in ((pair.link, 1.0), (pair.other, -1.0)):
            self._fill(rows, q, link, self.place(q, link, pair.point), 1 + 0j, sign)
        return list(rows)

    def _slider_slopes(self, q: Any, pair: Pair) -> list[Any]:
        mechanism, rows, turns = self.plans.mechanism, np.zeros((2, len(q))), np.zeros(len(q))
        guide = mechanism.guide(pair.guide)
        _, turn = self.pose(q, pair.other)
        back = cmath.exp(-1j * (turn + math.radians(guide.angle_deg)))
        first = self.place(q, pair.link, mechanism.link(pair.link).first_point)
        self._fill(rows, q, pair.link, first, back, 1.0)
        self._fill(rows, q, pair.other, first, back, -1.0)  # the guide's line carried along as a body
        for link, sign in ((pair.link, 1.0), (pair.other, -1.0)):
            if link != FRAME:
                turns[3 * self.links.index(link) + 2] = sign
        return [rows[1], turns]

    def newton(self, q: Any, phi: float) -> Any:
        """The pose nearest by iteration; no look is taken at whether it came out."""
        for _ in range(MOST):
            step = np.linalg.solve(self.jacobian(q, phi), -self.residual(q, phi))
            q = q + step
            if np.abs(step).max() < TOLERANCE:
                break
        return q

    def rates(self, q: Any, phi: float, omega: float, epsilon: float) -> tuple[Any, Any]:
        """Velocities and accelerations of the pose, from the linear system of the constraints."""
        slopes = self.jacobian(q, phi)
        drive = np.zeros(len(q))
        drive[-1] = 1.0  # its equation is the last
        v = np.linalg.solve(slopes, drive * omega)
        h = 1e-5 / max(1.0, float(np.abs(v).max()))
        turned = (self.jacobian(q + h * v, phi) @ v - self.jacobian(q - h * v, phi) @ v) / (2 * h)
        a = np.linalg.solve(slopes, drive * epsilon - turned)
        return v, a

    def points(self, q: Any, v: Any, a: Any) -> dict[str, tuple[complex, complex, complex]]:
        """Place, velocity and acceleration of every point of the moving links."""
        found = {}
        for link in self.links:
            k = 3 * self.links.index(link)
            turn = cmath.exp(1j * float(q[k + 2]))
            for name, local in self.plans.mechanism.link(link).points.items():
                arm = local * turn
                speed = complex(v[k], v[k + 1]) + 1j * v[k + 2] * arm
                quick = complex(a[k], a[k + 1]) + (1j * a[k + 2] - v[k + 2] ** 2) * arm
                found[name] = complex(q[k], q[k + 1]) + arm, speed, quick
        return found

    def start(self, number: Callable[[str], Any]) -> Any:
        """A pose to begin from, read off a drawing."""
        q: list[float] = []
        for link in self.links:
            first = self.plans.mechanism.link(link).first_point
            angle = math.radians(float(number(self.plans.links[link].angle)))
            local = self.plans.mechanism.link(link).points[first]
            place = complex(number(self.plans.points[first].position)) - local * cmath.exp(1j * angle)
            q += [place.real, place.imag, angle]
        return np.array(q)


def differences(places: Callable[[Any], Any], phi: Any, omega: float, epsilon: float, step: float) -> tuple[Any, Any]:
    """Velocities and accelerations by central differences of places (a row for each) over ``step`` radians."""
    here, on, back = places(phi), places(phi + math.degrees(step)), places(phi - math.degrees(step))
    slope, bend = (on - back) / (2 * step), (on - 2 * here + back) / step**2
    return slope * omega, bend * omega**2 + slope * epsilon
