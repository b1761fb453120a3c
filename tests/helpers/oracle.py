"""An independent solver of planar lever mechanisms: the check the tests compare `planes` with.

It shares nothing with the package: no groups, no plans. Every moving link has three unknowns
(x, y, theta: place of the origin of its own axes and their turn), every pair gives constraint
equations, Newton's iteration gives the position, linear systems give velocities, accelerations and,
for all links at once, the forces. Lengths are divided by the size of the mechanism, so 1e-6 m and
1e6 m are alike. A scene is the numeric dict of the scene file; points are complex, SI, x right, y up,
counter-clockwise positive; a guess is {link: (x, y, theta in radians)}.
"""

from __future__ import annotations

import cmath
import functools
import itertools
import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.helpers.oracle_forces import (
    FRAME,
    Action,
    NoSolution,
    Reaction,
    Vector,
    applied,
    find_forces,
    power_balance,
    refined,
    unbalanced,
    velocity,
)
from tests.helpers.oracle_pins import place, radius_of, without_circles

__all__ = [
    "FRAME",
    "NoSolution",
    "Solution",
    "follow",
    "power_balance",
    "reaction_key",
    "solve",
    "unbalanced",
    "velocity",
]

Scene = Mapping[str, Any]
Pose = tuple[float, float, float]


@dataclass(frozen=True)
class Pair:
    """Link `i` on link `j`: `p` local in i, `g` local in j; `u` the guide's local direction or None.

    `friction` is the coefficient, in a hinge the radius of the friction circle.
    """

    name: str
    i: str
    j: str
    p: complex
    g: complex
    u: complex | None = None
    turn: float = 0.0
    offset: float = 0.0
    friction: float = 0.0


@dataclass
class Model:
    """The scene as read, lengths in units of `size`; `links` in file order, `order` in order of solving."""

    size: float
    links: list[str]
    points: dict[str, dict[str, complex]]
    order: list[str]
    hinges: list[Pair]
    slides: list[Pair]
    driver: str
    on: str
    value: float
    rate: float
    rate2: float
    revolving: bool
    groups: list[tuple[str, ...]] = field(default_factory=list)


@dataclass
class Solution:
    """What was found, SI and frame axes.

    `points`: name -> (place, velocity, acceleration), complex; `links`: name -> (angle in degrees in
    (-180, 180], omega, epsilon); `slides`: sliding link -> (v, a along the guide, Coriolis part, complex);
    `reactions`: (i, j) -> force on i from j, for a sliding pair (force, arm or None, moment about the
    foot); `balancing`: moment on the driver, or force along its guide; `feet`: sliding link -> foot of
    its first point on the guide; `guides`: sliding link -> (guide, its link, its direction now); `hinges`:
    (i, j) -> place. `motion`: link -> (velocity of the origin, omega) that directs loads and
    friction: the true one, or with the driver at rest that of a unit positive drive; `speeds`: sliding link
    -> its speed along the guide in that motion; `slid`: -> its place along it. `condition`: of the
    scaled Jacobian; `residual`: largest constraint error, scaled; `consistent`: choices of signs of the
    normal forces that fit (1 unless friction is near locking).
    """

    pose: dict[str, Pose]
    points: dict[str, tuple[complex, complex, complex]]
    links: dict[str, tuple[float, float, float]]
    slides: dict[str, tuple[float, float, complex]]
    reactions: dict[tuple[str, str], Reaction]
    balancing: float
    actions: list[Action]
    feet: dict[str, complex]
    motion: dict[str, tuple[complex, float]]
    condition: float
    residual: float
    consistent: int
    groups: list[tuple[str, ...]]
    guides: dict[str, tuple[str, str, complex]]
    hinges: dict[tuple[str, str], complex]
    speeds: dict[str, float]
    slid: dict[str, float]


def guide_line(spec: Mapping[str, Any], points: Mapping[str, complex]) -> tuple[complex, complex]:
    """(through point, unit direction) of a guide in the axes of its link."""
    if "x" in spec:
        return complex(float(spec["x"])), 1j
    if "y" in spec:
        return 1j * float(spec["y"]), 1 + 0j
    through = spec["through"]
    at = points[str(through)] if isinstance(through, str) else place(through)
    return at, cmath.rect(1.0, math.radians(float(spec["angle"])))


def read(scene: Scene) -> Model:
    """The numeric scene as a model; the links of a hinge are paired with the one solved first."""
    whole, scene = scene, without_circles(scene)
    links = {str(k): v for k, v in scene["links"].items()}
    bodies: dict[str, Any] = {FRAME: scene["frame"], **links}
    points = {n: {str(k): place(v) for k, v in (b.get("points") or {}).items()} for n, b in bodies.items()}
    lines = {
        str(k): (n, *guide_line(spec, points[n]))
        for n, b in bodies.items()
        for k, spec in (b.get("guides") or {}).items()
    }
    rubbing = {str(k): float(v) for k, v in (scene.get("friction") or {}).items() if not isinstance(v, Mapping)}
    slides = []
    for n, b in links.items():
        if b.get("slides") is None:
            continue
        spec = b["slides"] if isinstance(b["slides"], Mapping) else {"guide": b["slides"]}
        name = str(spec["guide"])
        owner, through, u = lines[name]
        slides.append(
            Pair(
                name,
                n,
                owner,
                next(iter(points[n].values())),
                through,
                u,
                math.radians(float(spec.get("angle", 0))),
                float(spec.get("offset", 0)),
                rubbing.get(name, 0.0),
            )
        )
    size = (
        max([abs(z) for ps in points.values() for z in ps.values()] + [abs(z) for s in slides for z in (s.g, s.offset)])
        or 1.0
    )
    points = {n: {k: z / size for k, z in ps.items()} for n, ps in points.items()}
    slides = [Pair(s.name, s.i, s.j, s.p / size, s.g / size, s.u, s.turn, s.offset / size, s.friction) for s in slides]
    drive = scene["drive"]
    driver, revolving = str(drive["link"]), "phi" in drive
    on = str(drive.get("on", FRAME))
    inner = [s.j for s in slides if s.i == driver and not revolving] if not revolving else [on]
    groups = order_of_groups(list(links), points, slides, driver, [n for n in inner if n != FRAME])
    order = [FRAME, *itertools.chain.from_iterable(groups)]
    if driver not in order:
        on_what = [n for n in inner if n != FRAME]
        still = [n for other in on_what for two in standing(list(links), points, slides, (driver, other)) for n in two]
        order.insert(1 + len(still), driver)
    hinges = []
    for name in dict.fromkeys(k for n in order for k in points[n]):
        base, *others = [n for n in order if name in points[n]]
        both = ((base, n) if (base, n) == (driver, on) else (n, base) for n in others)  # a driver before its base
        hinges += [
            Pair(name, n, m, points[n][name], points[m][name], friction=radius_of(whole, name, n, m) / size)
            for n, m in both
        ]
    if revolving:
        rates = (math.radians(float(drive["phi"])), float(drive.get("omega", 0)), float(drive.get("epsilon", 0)))
    else:
        rates = (
            float(drive["s"]) / size,
            float(drive.get("velocity", 0)) / size,
            float(drive.get("acceleration", 0)) / size,
        )
    return Model(size, list(links), points, order, hinges, slides, driver, on, *rates, revolving, groups)


def order_of_groups(
    links: list[str], points: Mapping[str, Mapping[str, complex]], slides: list[Pair], driver: str, carriers: list[str]
) -> list[tuple[str, ...]]:
    """Groups in order of solving: each time the first two links, in file order, that can be solved.

    With a drive against a moving link (``carriers``), that link and the one moved by the two come first.
    """
    solved: set[str] = {FRAME, driver}
    groups: list[tuple[str, ...]] = []
    for carrier in carriers:
        groups += standing(links, points, slides, (driver, carrier))
        still = [FRAME, *itertools.chain.from_iterable(groups)]
        moving = [n for n in links if n not in still]
        held = {n for n in moving if any(joined(n, m, points, slides) for m in still)}
        if not held & {driver, carrier}:  # a cylinder across a hinge of two links, and the third one they move
            inside = rocked(moving, points, slides, held, driver, carrier)
            groups.append(inside or braced(moving, points, held, driver, carrier))
            solved = {*still, *groups[-1], *([driver] if inside else [])}
            continue
        free = next(n for n in (driver, carrier) if n not in held)
        near = [n for n in moving if n not in (driver, carrier) and points[n].keys() & points[free].keys()]
        moved = next((n for n in near if n in held), "")
        if not moved:  # the two are a lead of a link with two more on the frame
            moved = near[0]
            leads = [n for n in links if n in held - {driver, carrier} and joined(n, moved, points, slides)]
            groups.append((carrier, moved, *leads))
        else:
            groups.append((carrier, moved))
        solved |= {*still, *groups[-1]}
    while len(solved) <= len(links):
        known = {k for n in solved for k in points[n]}
        ends = [n for s in slides for n, other in ((s.i, s.j), (s.j, s.i)) if other in solved]
        outer = {n: sum(k in known for k in points[n]) + ends.count(n) for n in links}
        for i, j in itertools.combinations([n for n in links if n not in solved], 2):
            inner = sum(k not in known for k in points[i].keys() & points[j].keys())
            inner += sum({s.i, s.j} == {i, j} for s in slides)
            if outer[i] == outer[j] == inner == 1:
                groups.append((i, j))
                solved |= {i, j}
                break
        else:
            left = [n for n in links if n not in solved]
            whole = basic_and_leads(left, outer, points, slides, known)
            whole = whole or basics_in_a_chain(left, outer, points, slides, known)
            whole = whole or contour(left, outer, points, slides, known)
            groups.append(whole)
            solved |= set(whole)
    return groups


def standing(
    links: list[str], points: Mapping[str, Mapping[str, complex]], slides: list[Pair], drive: tuple[str, str]
) -> list[tuple[str, str]]:
    """Pairs of links, not of the drive, each hinged to links at rest, with one in common."""
    still, found = [FRAME], list[tuple[str, str]]()

    def outer(n: str) -> int:
        known = {k for m in still for k in points[m]}
        return sum(k in known for k in points[n]) + sum({s.i, s.j} == {n, m} for s in slides for m in still)

    def meet(i: str, j: str) -> int:
        known = {k for m in still for k in points[m]}
        return sum(k not in known for k in points[i].keys() & points[j].keys()) + sum(
            {s.i, s.j} == {i, j} for s in slides
        )

    while pair := next(
        (
            two
            for two in itertools.combinations([n for n in links if n not in (*still, *drive)], 2)
            if outer(two[0]) == outer(two[1]) == meet(*two) == 1
        ),
        None,
    ):
        found.append(pair)
        still += pair
    return found


def joined(n: str, m: str, points: Mapping[str, Mapping[str, complex]], slides: list[Pair]) -> bool:
    """Whether two links form a pair."""
    return bool(points[n].keys() & points[m].keys()) or any({s.i, s.j} == {n, m} for s in slides)


def braced(
    links: list[str], points: Mapping[str, Mapping[str, complex]], held: set[str], driver: str, carrier: str
) -> tuple[str, ...]:
    """The two links with a cylinder across their hinge, the one on the frame first, and the third link they move."""

    def meet(n: str, m: str) -> bool:
        return bool(points[n].keys() & points[m].keys())

    others = [n for n in links if n not in (driver, carrier)]
    for near, far, third in itertools.permutations(others, 3):
        pins = (meet(driver, near) and meet(carrier, far)) or (meet(driver, far) and meet(carrier, near))
        hung = {near, third} <= held and far not in held and not meet(near, third)
        if pins and hung and meet(near, far) and meet(far, third):
            return near, far, third
    raise NoSolution("no links that a cylinder braces")


def rocked(
    links: list[str],
    points: Mapping[str, Mapping[str, complex]],
    slides: list[Pair],
    held: set[str],
    driver: str,
    carrier: str,
) -> tuple[str, ...]:
    """A cylinder between two links on solved ones that are not paired themselves; those, and the link between them."""
    for near, far in itertools.permutations(sorted(held, key=links.index), 2):
        ends = joined(driver, near, points, slides) and joined(carrier, far, points, slides)
        if ends and not joined(near, far, points, slides):
            for rod in (n for n in links if n not in (*held, driver, carrier)):
                if joined(rod, near, points, slides) and joined(rod, far, points, slides):
                    return carrier, near, far, rod
    return ()


def pairs_between(
    n: str, m: str, points: Mapping[str, Mapping[str, complex]], slides: list[Pair], known: set[str]
) -> int:
    """The number of pairs between two links, at unknown points."""
    return len({*points[n]} & {*points[m]} - known) + sum({s.i, s.j} == {n, m} for s in slides)


def basic_and_leads(
    left: list[str],
    outer: Mapping[str, int],
    points: Mapping[str, Mapping[str, complex]],
    slides: list[Pair],
    known: set[str],
) -> tuple[str, ...]:
    """A link and three others, each with one pair on a solved one and another on it."""
    for basic in (n for n in left if not outer[n]):
        joined = {n: pairs_between(basic, n, points, slides, known) for n in left if n != basic}
        leads = [n for n, count in joined.items() if count == outer[n] == 1]
        if len(leads) == 3:
            return basic, *leads
    return ()


def basics_in_a_chain(
    left: list[str],
    outer: Mapping[str, int],
    points: Mapping[str, Mapping[str, complex]],
    slides: list[Pair],
    known: set[str],
) -> tuple[str, ...]:
    """Links without solved neighbours, with three pairs each, hinged to each other, and the leads on them."""
    pairs = functools.partial(pairs_between, points=points, slides=slides, known=known)
    free = [n for n in left if not outer[n]]
    for count in range(2, len(free) + 1):
        for basics in itertools.combinations(free, count):
            leads = [n for n in left if outer[n] == 1 and sum(pairs(n, m) for m in basics) == 1]
            ends = [sum(pairs(n, m) for m in (*basics, *leads) if m != n) for n in basics]
            if len(leads) == count + 2 and ends == [3] * count:
                return *basics, *leads
    return ()


def contour(
    left: list[str],
    outer: Mapping[str, int],
    points: Mapping[str, Mapping[str, complex]],
    slides: list[Pair],
    known: set[str],
) -> tuple[str, ...]:
    """Two links with one pair each on solved ones, and two others that are paired with both."""

    def joined(n: str, m: str) -> bool:
        here = any(k not in known for k in points[n].keys() & points[m].keys())
        return here or any({s.i, s.j} == {n, m} for s in slides)

    for one, two in itertools.combinations([n for n in left if outer[n] == 1], 2):
        rods = [n for n in left if not outer[n] and joined(n, one) and joined(n, two)]
        if len(rods) == 2:
            return one, two, *rods
    raise NoSolution(f"no dyad, no triad and no contour among {left}")


def gap(m: Model, pair: Pair, q: Vector, w: Vector) -> tuple[complex, NDArray[np.complex128], complex]:
    """The gap Z of a pair, its row dZ/dq and Z's second derivative at zero accelerations.

    For a hinge Z = r_i - r_j; for a sliding pair Z = s + ih in the axes of the guide.
    """
    o, t, vo, omega = [0j, 0j], [0.0, 0.0], [0j, 0j], [0.0, 0.0]
    cols = [3 * m.links.index(n) if n != FRAME else None for n in (pair.i, pair.j)]
    for k, col in enumerate(cols):
        if col is not None:
            o[k], t[k] = complex(q[col], q[col + 1]), q[col + 2]
            vo[k], omega[k] = complex(w[col], w[col + 1]), w[col + 2]
    p, g = pair.p * cmath.rect(1.0, t[0]), pair.g * cmath.rect(1.0, t[1])
    d, second = o[0] + p - o[1] - g, -(omega[0] ** 2) * p + omega[1] ** 2 * g
    c, turning = 1 + 0j, -1j * g
    if pair.u is not None:
        dv = vo[0] + 1j * omega[0] * p - vo[1] - 1j * omega[1] * g
        c = (pair.u * cmath.rect(1.0, t[1])).conjugate()
        turning -= 1j * d
        second += -2j * omega[1] * dv - omega[1] ** 2 * d
    row = np.zeros(len(q), dtype=np.complex128)
    for col, sign, b in zip(cols, (1, -1), (1j * p, turning), strict=True):
        if col is not None:
            row[col : col + 3] = sign * c, sign * 1j * c, c * b
    return c * d, row, c * second


def constraints(m: Model, q: Vector, w: Vector) -> tuple[Vector, Vector, Vector]:
    """Errors C (n,), Jacobian (n, n) and second-derivative terms (n,); the last row is the driver's."""
    error, rows, second = [], [], []

    def turned(i: str, j: str, by: float) -> None:
        row = np.zeros(len(q))
        for n, sign in ((i, 1), (j, -1)):
            if n != FRAME:
                row[3 * m.links.index(n) + 2] = sign
        rows.append(row)
        error.append(math.remainder(float(row @ q) - by, math.tau))
        second.append(0.0)

    for pair in m.hinges:
        z, row, z2 = gap(m, pair, q, w)
        error += [z.real, z.imag]
        rows += [row.real, row.imag]
        second += [z2.real, z2.imag]
    driven = None
    for pair in m.slides:
        z, row, z2 = gap(m, pair, q, w)
        error.append(z.imag - pair.offset)
        rows.append(row.imag)
        second.append(z2.imag)
        assert pair.u is not None
        turned(pair.i, pair.j, cmath.phase(pair.u) + pair.turn)
        driven = (z.real - m.value, row.real, z2.real) if pair.i == m.driver else driven
    if m.revolving:
        turned(m.driver, m.on, m.value)
    else:
        assert driven is not None, "a sliding driver slides on a guide of the frame"
        for to, value in zip((error, rows, second), driven, strict=True):
            to.append(value)  # type: ignore[attr-defined]
    if len(error) != len(q):
        raise NoSolution(f"{len(error)} equations for {len(q)} coordinates")
    return np.array(error), np.array(rows), np.array(second)


def find_pose(m: Model, q: Vector) -> Vector:
    """Newton's iteration to machine precision, steps limited to half the size of the mechanism."""
    still, before = np.zeros_like(q), math.inf
    for _ in range(100):
        c, a, _ = constraints(m, q, still)
        step = np.linalg.solve(a, -c)
        longest = float(np.max(np.abs(step)))
        q = q + step * min(1.0, 0.5 / max(longest, 1e-300))
        if longest < 1e-12 or before / 2 < longest < 1e-6:  # only rounding is left
            break
        before = longest
    else:
        raise NoSolution(f"Newton's iteration does not converge: last step {longest:.2g}")
    for _ in range(2):
        c, a, _ = constraints(m, q, still)
        q = q + np.linalg.solve(a, -c)
    return q


def solve(scene: Scene, guess: Mapping[str, Pose], *, balancing_at: str = "foot") -> Solution:
    """Position nearest `guess` by Newton, then velocities, accelerations and all forces.

    `balancing_at`: a sliding driver's balancing force acts along the guide line ("foot") or along the
    parallel through the driver's first point ("point"); they differ only in the couple of that pair.
    """
    m = read(scene)
    q = np.array([x for n in m.links for x in (guess[n][0] / m.size, guess[n][1] / m.size, guess[n][2])])
    q = find_pose(m, q)
    _, a, _ = constraints(m, q, np.zeros_like(q))
    last = np.zeros_like(q)
    last[-1] = 1.0
    unit = refined(a, last)
    w = m.rate * unit
    error, a, second = constraints(m, q, w)
    acc = refined(a, m.rate2 * last - second)
    moved = w if m.rate else unit

    def origin(x: Vector, n: str) -> tuple[complex, float]:
        k = 3 * m.links.index(n) if n != FRAME else 0
        return (complex(x[k], x[k + 1]) * m.size, float(x[k + 2])) if n != FRAME else (0j, 0.0)

    bodies = [FRAME, *m.links]
    pos, vel = {n: origin(q, n) for n in bodies}, {n: origin(w, n) for n in bodies}
    eps = {n: origin(acc, n) for n in bodies}
    points = {}
    for n in reversed(m.order):
        for k, z in m.points[n].items():
            e = z * m.size * cmath.rect(1.0, pos[n][1])
            points[k] = (
                pos[n][0] + e,
                vel[n][0] + 1j * vel[n][1] * e,
                eps[n][0] + (1j * eps[n][1] - vel[n][1] ** 2) * e,
            )
    slides, guides, feet, speeds, slid = {}, {}, {}, {}, {}
    for s in m.slides:
        z, row, z2 = gap(m, s, q, w)
        assert s.u is not None
        u = s.u * cmath.rect(1.0, pos[s.j][1])
        v = float((row @ w).real) * m.size
        slides[s.i] = (v, float((row @ acc + z2).real) * m.size, 2j * vel[s.j][1] * v * u)
        guides[s.i] = (s.name, s.j, u)
        first = s.p * m.size * cmath.rect(1.0, pos[s.i][1]) + pos[s.i][0]
        feet[s.i] = first - 1j * u * s.offset * m.size
        speeds[s.i], slid[s.i] = float((row @ moved).real) * m.size, float(z.real) * m.size
    turns = {n: -math.degrees(math.remainder(-pos[n][1], math.tau)) for n in m.links}
    sol = Solution(
        {n: (pos[n][0].real, pos[n][0].imag, pos[n][1]) for n in m.links},
        points,
        {n: (180.0 if turns[n] == -180 else turns[n], vel[n][1], eps[n][1]) for n in m.links},
        slides,
        {},
        0.0,
        [],
        feet,
        {n: origin(moved, n) for n in bodies},
        float(np.linalg.cond(a)),
        float(np.max(np.abs(error))),
        0,
        m.groups,
        guides,
        {(h.i, h.j): points[h.name][0] for h in m.hinges},
        speeds,
        slid,
    )
    sol.actions = list(applied(scene, sol))
    find_forces(m, sol, balancing_at)
    return sol


def follow(scene: Scene, guess: Mapping[str, Pose], value: float, steps: int = 36) -> Solution:
    """The solution at another value of the drive (degrees or m), by small steps from `guess`."""
    key = "phi" if "phi" in scene["drive"] else "s"
    start, pose = float(scene["drive"][key]), dict(guess)
    for k in range(1, steps + 1):
        at = {**scene, "drive": {**scene["drive"], key: start + (value - start) * k / steps}}
        sol = solve(at, pose)
        pose = sol.pose
    return sol


def reaction_key(i: str, j: str) -> str:
    """F_21, and F_11_10 where a name is longer than one character."""
    return f"F_{i}{j}" if len(i) == len(j) == 1 else f"F_{i}_{j}"
