"""Forces of the independent check: loads, weights, inertia, and the equilibrium of all links at once."""

from __future__ import annotations

import cmath
import itertools
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tests.helpers.oracle_pins import Grip, with_pins

if TYPE_CHECKING:
    from tests.helpers.oracle import Model, Solution

FRAME = "0"
Reaction = complex | tuple[complex, float | None, float]
Vector = NDArray[np.float64]


class NoSolution(ValueError):
    """The position does not converge, or no choice of signs of friction is consistent."""


@dataclass(frozen=True)
class Action:
    """A force at a place, or a couple, on a link; SI. `kind`: load, weight, inertia, friction, balancing."""

    kind: str
    link: str
    place: complex
    force: complex
    moment: float = 0.0


def refined(a: Vector, b: Vector) -> Vector:
    """a x = b with one step of refinement against a residual in extended precision."""
    x = np.linalg.solve(a, b)
    left = (b - a.astype(np.longdouble) @ x).astype(float)
    return np.asarray(x + np.linalg.solve(a, left))


def velocity(sol: Solution, link: str, at: complex) -> complex:
    """Velocity of the place `at` of a link in `sol.motion`."""
    x, y, _ = sol.pose.get(link, (0.0, 0.0, 0.0))
    v, omega = sol.motion[link]
    return v + 1j * omega * (at - complex(x, y))


def worked_out(scene: Mapping[str, Any], sol: Solution, said: Any, link: str) -> float:
    """A number of a load in this position: a number, an expression, a table over one, or one for each stroke."""
    if isinstance(said, Mapping) and "working" in said:
        speed = sol.slides[str(said.get("slider", link))][0] * (-1 if said.get("stroke") == "behind" else 1)
        if abs(speed) <= 1e-12 * max(abs(v) for v in sol.speeds.values()):
            return 0.0
        return worked_out(scene, sol, said["working" if speed > 0 else "idle"], link)
    if isinstance(said, Mapping):
        x, (xs, ys) = worked_out(scene, sol, said["over"], link), zip(*said["table"], strict=True)
        whole = said["over"] == "phi" and abs(xs[-1] - xs[0] - 360) < 1e-9
        return float(np.interp(xs[0] + (x - xs[0]) % 360 if whole else x, xs, ys))
    if not isinstance(said, str):
        return float(said)
    names: dict[str, Any] = {k: float(v) for k, v in scene["drive"].items() if k in ("phi", "s")}
    for n, (angle, omega, epsilon) in sol.links.items():
        names |= {f"phi_{n}": angle, f"omega_{n}": omega, f"epsilon_{n}": epsilon}
    for n, (v, a, _) in sol.slides.items():
        names |= {f"s_{n}": sol.slid[n], f"v_{n}": v, f"a_{n}": a}
    for p, (r, v_p, a_p) in sol.points.items():
        names |= {f"x_{p}": r.real, f"y_{p}": r.imag, f"v_{p}": abs(v_p), f"a_{p}": abs(a_p)}
    names |= {f"{k}_{scene['drive']['link']}": names[k] for k in ("phi", "s") if k in names}
    turned = {f: (lambda x, f=f: getattr(math, f)(math.radians(x))) for f in ("sin", "cos", "tan")}
    others = {"abs": abs, "min": min, "max": max, "sqrt": math.sqrt, "hypot": math.hypot}
    return float(eval(said.replace("^", "**"), {**turned, **others}, names))


def applied(scene: Mapping[str, Any], sol: Solution) -> Iterator[Action]:
    """Loads, weights and inertia of the scene as actions, SI."""
    fastest = max([abs(velocity(sol, n, r)) for n in sol.links for r, _, _ in sol.points.values()])
    for name, link in ((str(k), v) for k, v in scene["links"].items()):
        centre = str(link.get("centre", next(iter(link["points"]))))
        r, _, a = sol.points[centre]
        mass, inertia = float(link.get("mass", 0)), float(link.get("inertia", 0))
        yield Action("weight", name, r, -1j * mass * float(scene.get("gravity", 0)))
        yield Action("inertia", name, r, -mass * a, -inertia * sol.links[name][2])
    for load in scene.get("loads") or []:
        name = str(load["link"])
        sign = 1 if load.get("along") == "motion" else -1 if load.get("against") == "motion" else 0
        if "moment" in load:
            omega, value = sol.motion[name][1], worked_out(scene, sol, load["moment"], name)
            quick = max(abs(w) for _, w in sol.motion.values())
            if sign:
                value *= sign * math.copysign(1.0, omega) if abs(omega) > 1e-12 * quick else 0
            yield Action("load", name, 0j, 0j, value)
            continue
        r, value = sol.points[str(load["point"])][0], worked_out(scene, sol, load["force"], name)
        v = velocity(sol, name, r)
        if sign:
            yield Action("load", name, r, value * sign * v / abs(v) if abs(v) > 1e-12 * fastest else 0j)
        else:
            to = load["direction"]
            fixed = isinstance(to, Mapping) and "link" in to
            turned = sol.links[str(to["link"])][0] if fixed else 0.0
            angle = turned + worked_out(scene, sol, to["angle"] if fixed else to, name)
            yield Action("load", name, r, cmath.rect(value, math.radians(angle)))


def find_forces(m: Model, sol: Solution, balancing_at: str) -> None:
    """Equilibrium of all links at once, moments about the origins of their axes and divided by `size`."""
    n = 3 * len(m.links)

    def wrench(link: str, at: complex, force: complex, moment: float = 0.0) -> Vector:
        out = np.zeros(n)
        if link != FRAME:
            k, (x, y, _) = 3 * m.links.index(link), sol.pose[link]
            turning = ((at - complex(x, y)).conjugate() * force).imag + moment
            out[k : k + 3] = force.real, force.imag, turning / m.size
        return out

    def between(i: str, j: str, at: complex, force: complex, moment: float = 0.0) -> Vector:
        return wrench(i, at, force, moment) - wrench(j, at, force, moment)

    cols = [between(h.i, h.j, sol.points[h.name][0], u) for h in m.hinges for u in (1 + 0j, 1j)]
    rubs, normal = {}, {}
    fastest = max([abs(v) for v in sol.speeds.values()], default=0.0)
    for s in m.slides:
        u, foot = sol.guides[s.i][2], sol.feet[s.i]
        normal[s.i] = len(cols)
        cols += [between(s.i, s.j, foot, 1j * u), between(s.i, s.j, foot, 0j, m.size)]
        if s.friction and abs(sol.speeds[s.i]) > 1e-12 * fastest:
            rubs[s.i] = -s.friction * math.copysign(1.0, sol.speeds[s.i]) * between(s.i, s.j, foot, u)
    if m.revolving:
        cols.append(between(m.driver, m.on, 0j, 0j, m.size))
    else:
        at = sol.feet[m.driver] if balancing_at == "foot" else next(sol.points[k][0] for k in m.points[m.driver])
        cols.append(between(m.driver, sol.guides[m.driver][1], at, sol.guides[m.driver][2]))
    grips, quick = [], max(abs(w) for _, w in sol.motion.values())
    for k, h in enumerate(m.hinges):
        turning = sol.motion[h.i][1] - sol.motion[h.j][1]
        if h.friction and abs(turning) > 1e-12 * quick:
            column = -math.copysign(h.friction, turning) * between(h.i, h.j, 0j, 0j, m.size)
            grips.append(Grip(2 * k, column))
    a = np.array(cols).T
    b = -sum((wrench(x.link, x.place, x.force, x.moment) for x in sol.actions), np.zeros(n))
    smooth = refined(a, b)
    likely = tuple(math.copysign(1.0, smooth[normal[i]]) for i in rubs)
    fits = []
    for signs in sorted(
        itertools.product((1.0, -1.0), repeat=len(rubs)),
        key=lambda s: sum(x != y for x, y in zip(s, likely, strict=True)),
    ):
        rough = a.copy()
        for (i, column), sign in zip(rubs.items(), signs, strict=True):
            rough[:, normal[i]] += sign * column
        found = with_pins(rough, b, grips) if grips else refined(rough, b) if rubs else smooth
        if found is None:
            continue
        x = found
        if all(x[normal[i]] * sign >= 0 for i, sign in zip(rubs, signs, strict=True)):
            fits.append(x)
    if not fits:
        raise NoSolution("no choice of signs of the normal forces is consistent: friction locks")
    x, sol.consistent = fits[0], len(fits)
    for k, h in enumerate(m.hinges):
        sol.reactions[h.i, h.j] = complex(x[2 * k], x[2 * k + 1])
    for g in grips:
        h = m.hinges[g.at // 2]
        turning = sol.motion[h.i][1] - sol.motion[h.j][1]
        couple = -math.copysign(h.friction * m.size * math.hypot(*x[g.at : g.at + 2]), turning)
        sol.actions += [Action("pin", link, 0j, 0j, sign * couple) for link, sign in ((h.i, 1), (h.j, -1))]
    largest = float(np.max(np.abs(x)))
    for s in m.slides:
        push, couple, u = float(x[normal[s.i]]), float(x[normal[s.i] + 1]) * m.size, sol.guides[s.i][2]
        rub = -s.friction * abs(push) * math.copysign(1.0, sol.speeds[s.i]) if s.i in rubs else 0.0
        arm = couple / push if abs(push) > 1e-13 * largest else None
        sol.reactions[s.i, s.j] = (1j * push * u + rub * u, arm, couple)
        sol.actions += [
            Action("friction", link, sol.feet[s.i], sign * rub * u) for link, sign in ((s.i, 1), (s.j, -1)) if rub
        ]
    sol.balancing = float(x[-1]) * (m.size if m.revolving else 1.0)
    if m.revolving:
        both = ((m.driver, sol.balancing), (m.on, -sol.balancing))
        sol.actions += [Action("balancing", link, 0j, 0j, couple) for link, couple in both if link != FRAME]
        return
    for link, sign in ((m.driver, 1), (sol.guides[m.driver][1], -1)):
        if link != FRAME:
            sol.actions.append(Action("balancing", link, at, sign * sol.balancing * sol.guides[m.driver][2]))


def power_balance(sol: Solution) -> tuple[float, float]:
    """(sum, largest term) of F.v + M.omega over all actions, in `sol.motion`."""
    terms = [
        (velocity(sol, x.link, x.place).conjugate() * x.force).real + x.moment * sol.motion[x.link][1]
        for x in sol.actions
    ]
    return math.fsum(terms), max(abs(t) for t in terms)


def unbalanced(sol: Solution) -> float:
    """Largest sum of forces or moments on a link, by `reactions` and `actions`, over the largest term.

    Friction is omitted from the actions here: the reactions of sliding pairs contain it already.
    """
    parts: dict[str, list[tuple[complex, complex, float]]] = {n: [] for n in sol.links}
    for x in sol.actions:
        if x.kind != "friction" and x.link in parts:  # the frame bears any
            parts[x.link].append((x.place, x.force, x.moment))
    for (i, j), r in sol.reactions.items():
        if isinstance(r, tuple):
            at, force, moment = sol.feet[i], r[0], r[2]
        else:
            at, force, moment = sol.hinges[i, j], r, 0.0
        for link, sign in ((i, 1), (j, -1)):
            if link != FRAME:
                parts[link].append((at, sign * force, sign * moment))
    worst, places = 0.0, [r for r, _, _ in sol.points.values()]
    for terms in parts.values():
        at = terms[0][0]
        moments = [((p - at).conjugate() * f).imag + m for p, f, m in terms]
        forces = max(abs(f) for _, f, _ in terms) or 1.0
        couples = max([abs(m) for m in moments] + [forces * max(abs(r - at) for r in places)])
        worst = max(worst, abs(sum(f for _, f, _ in terms)) / forces, abs(math.fsum(moments)) / couples)
    return worst
