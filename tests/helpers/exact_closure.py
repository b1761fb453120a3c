"""The closure of a mechanism to 120 digits, by mpmath only: positions and speeds of its links, and its dead points.

Every link is a position and a rotation; hinges and guides are equations between them. At a dead point the equations
allow a motion of the links without the driver: it is solved for together with that motion.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from mpmath import cos, fabs, lu_solve, matrix, mp, mpc, mpf, nint, radians, sin

DIGITS = 120
STEP = mpf(10) ** -28  # of a slope
Vector = list[Any]


def place(spelled: Any) -> Any:
    """A point in a link's axes."""
    if isinstance(spelled, Mapping):
        return mpf(spelled["r"]) * turned(radians(mpf(spelled["angle"])))
    if isinstance(spelled, list | tuple):
        return mpc(*map(mpf, spelled))
    return mpc(mpf(spelled))


def turned(angle: Any) -> Any:
    """The direction at an angle, radians."""
    return mpc(cos(angle), sin(angle))


class Closure:
    """The equations of a scene driven by one link on the frame."""

    def __init__(self, scene: Mapping[str, Any]) -> None:
        mp.dps = DIGITS
        self.links = list(scene["links"])
        self.scene = {"0": scene["frame"], **{str(n): link for n, link in scene["links"].items()}}
        self.points = {n: {k: place(z) for k, z in x.get("points", {}).items()} for n, x in self.scene.items()}
        self.drive, self.gravity = scene["drive"], scene.get("gravity", 0)
        holders: dict[str, list[str]] = {}
        for name, points in self.points.items():
            for k in points:
                holders.setdefault(k, []).append(name)
        self.hinges = [(k, names[0], other) for k, names in holders.items() for other in names[1:]]
        self.guides = {g: (n, spec) for n, x in self.scene.items() for g, spec in x.get("guides", {}).items()}

    def at(self, q: Vector, link: str) -> tuple[Any, Any]:
        """A link's origin and rotation."""
        if link == "0":
            return mpc(0), mpf(0)
        k = 3 * self.links.index(link)
        return mpc(q[k], q[k + 1]), q[k + 2]

    def spot(self, q: Vector, link: str, local: Any) -> Any:
        """The position of a point of a link."""
        origin, turn = self.at(q, link)
        return origin + local * turned(turn)

    def missed(self, q: Vector, phi: Any) -> Vector:
        """The residual of every equation at a rotation of the driver, radians."""
        found: Vector = []
        for k, one, two in self.hinges:
            gap = self.spot(q, one, self.points[one][k]) - self.spot(q, two, self.points[two][k])
            found += [gap.real, gap.imag]
        for name in self.links:
            if slides := self.scene[name].get("slides"):
                said = slides if isinstance(slides, Mapping) else {"guide": slides}
                owner, spec = self.guides[said["guide"]]
                own = radians(mpf(spec.get("angle", 90 if "x" in spec else 0)))
                through = spec.get("through", [spec.get("x", 0), spec.get("y", 0)])
                local = self.points[owner][through] if isinstance(through, str) else place(through)
                turn = self.at(q, owner)[1] + own
                first = next(iter(self.points[name].values()))
                gap = (self.spot(q, name, first) - self.spot(q, owner, local)) * turned(-turn)
                found += [gap.imag - mpf(said.get("offset", 0))]
                found += [sin(self.at(q, name)[1] - turn - radians(mpf(said.get("angle", 0))))]
        off = self.at(q, str(self.drive["link"]))[1] - phi
        return [*found, off - (2 * mp.pi) * nint(off / (2 * mp.pi))]

    def slopes(self, f: Callable[[Vector], Vector], x: Vector) -> Any:
        """The Jacobian matrix."""
        base = f(x)
        found = matrix(len(base), len(x))
        for j in range(len(x)):
            moved = f([v + STEP if k == j else v for k, v in enumerate(x)])
            for i, (a, b) in enumerate(zip(base, moved, strict=True)):
                found[i, j] = (b - a) / STEP
        return found

    def solved(self, f: Callable[[Vector], Vector], x: Vector, tries: int = 60) -> Vector:
        """A root of equations near a guess; ValueError if Newton's iteration does not converge."""
        for _ in range(tries):
            step = lu_solve(self.slopes(f, x), matrix(f(x)))
            x = [a - b for a, b in zip(x, step, strict=True)]
            if max(map(fabs, step)) < mpf(10) ** -40:
                return x
        raise ValueError("Newton's steps do not settle")

    def lies(self, near: Vector, phi_deg: float) -> Vector:
        """The positions of the links."""
        phi = radians(mpf(phi_deg))
        return self.solved(lambda q: self.missed(q, phi), near)

    def turning(self, q: Vector, phi_deg: float) -> Mapping[str, Any]:
        """The angular velocity of every link at the driver's rate."""
        phi = radians(mpf(phi_deg))
        rates = matrix([*[mpf(0)] * (len(q) - 1), mpf(self.drive["omega"])])
        found = lu_solve(self.slopes(lambda x: self.missed(x, phi), q), rates)
        return {name: found[3 * k + 2] for k, name in enumerate(self.links)}

    def moving(self, q: Vector, phi_deg: float) -> tuple[Any, Vector, Vector]:
        """The Jacobian matrix, the velocities of all coordinates, and their accelerations."""
        phi, size = radians(mpf(phi_deg)), len(q)
        own = self.slopes(lambda x: self.missed(x, phi), q)
        way = [*lu_solve(own, matrix([*[mpf(0)] * (size - 1), mpf(1)]))]  # by a unit drive
        ahead, behind = (self.missed([a + s * b for a, b in zip(q, way, strict=True)], phi + s) for s in (STEP, -STEP))
        bent = [*lu_solve(own, matrix([-(a + b) / STEP**2 for a, b in zip(ahead, behind, strict=True)]))]
        omega, epsilon = mpf(self.drive["omega"]), mpf(self.drive["epsilon"])
        return own, [w * omega for w in way], [b * omega**2 + w * epsilon for w, b in zip(way, bent, strict=True)]

    def forces(self, q: Vector, phi_deg: float) -> Mapping[str, Any]:
        """Reactions (magnitudes) in hinges of two links by ``F_ij``, under weight and inertia; the driving moment "M".

        These are the multipliers of the equations.
        """
        own, speeds, quick = self.moving(q, phi_deg)
        total: Vector = []
        for k, name in enumerate(self.links):
            link = self.scene[name]
            mass, inertia = mpf(link.get("mass", 0)), mpf(link.get("inertia", 0))
            local = self.points[name][link.get("centre", next(iter(self.points[name])))]
            here, ahead, behind = (
                self.spot([a + s * b + s * s / 2 * c for a, b, c in zip(q, speeds, quick, strict=True)], name, local)
                for s in (0, STEP, -STEP)
            )
            force = mass * (mpc(0, -mpf(self.gravity)) - (ahead + behind - 2 * here) / STEP**2)
            arm = here - self.at(q, name)[0]
            total += [
                -force.real,
                -force.imag,
                inertia * quick[3 * k + 2] - arm.real * force.imag + arm.imag * force.real,
            ]
        found = [*lu_solve(own.T, matrix(total))]
        told = {"M": fabs(found[-1])}
        for k, (point, one, two) in enumerate(self.hinges):
            if sum(hinge[0] == point for hinge in self.hinges) == 1:
                told |= dict.fromkeys((f"F_{one}_{two}", f"F_{two}_{one}"), fabs(mpc(found[2 * k], found[2 * k + 1])))
        return told

    def stops(self, near: Vector, phi_deg: float) -> Any:
        """The drive's value, degrees, at the dead point near a pose."""
        size = len(near)
        own = self.slopes(lambda x: self.missed(x, radians(mpf(phi_deg))), near)
        idle = lu_solve(own, matrix([*[mpf(0)] * (size - 1), mpf(1)]))  # close to it this is nearly the idle motion
        most = max(range(size), key=lambda k: fabs(idle[k]))
        way = [idle[k] / idle[most] for k in range(size)]

        def equations(x: Vector) -> Vector:
            q, v, phi = x[:size], x[size:-1], x[-1]
            here = self.missed(q, phi)
            moved = self.missed([a + STEP * b for a, b in zip(q, v, strict=True)], phi)
            idle = [(b - a) / STEP for a, b in zip(here, moved, strict=True)]
            return [*here, *idle, v[most] - 1]

        return mp.degrees(self.solved(equations, [*near, *way, radians(mpf(phi_deg))])[-1])
