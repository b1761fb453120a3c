"""Random mechanisms that assemble by construction, as numeric dicts in the form of a scene file.

The pose is chosen first: positions and rotations of all links in the frame's axes; local coordinates, guides,
offsets and angles follow from it. So the true configuration is known (`Case.guess`). `make` takes a
`random.Random`; `mechanisms()` is the hypothesis strategy; `to_yaml` writes a scene file's text.
"""

from __future__ import annotations

import cmath
import json
import math
import random
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import numpy as np
from hypothesis import strategies as st

from tests.helpers.oracle import NoSolution, Solution, solve
from tests.helpers.oracle_pins import circle_of

KINDS = ("RRR", "RRP", "RPR", "PRP", "RPP")
NAMES = [c + n for n in ("", *map(str, range(2, 20))) for c in "ABCDEFGHJKLMNQRSTUVW"]


@dataclass(eq=False)
class Body:
    """A link in its pose: `points` in the frame's axes, `guides` and `slides` as written."""

    origin: complex
    turn: float
    points: dict[str, complex] = field(default_factory=dict)
    guides: dict[str, dict[str, Any]] = field(default_factory=dict)
    slides: str | dict[str, Any] | None = None
    name: str = "0"
    bare: bool = False  # it has only the points it needs

    def local(self, z: complex) -> complex:
        """A point in the link's local axes."""
        return (z - self.origin) * cmath.rect(1.0, -self.turn)


@dataclass(frozen=True)
class Dyad:
    """A group: bodies i, j, its outer hinges, its inner hinge, and where its side is written."""

    kind: str
    i: Body
    j: Body
    outer: tuple[str, ...] = ()
    inner: str | None = None
    key: str | None = None
    ahead: bool = False


@dataclass(frozen=True)
class Case:
    """A scene, its original pose, its groups as (kind, link, link) and the oracle's solution."""

    scene: dict[str, Any]
    guess: dict[str, tuple[float, float, float]]
    groups: list[tuple[str, str, str]]
    solution: Solution


def wrapped(angle: float) -> float:
    """An angle in (-pi, pi], zero if it is zero except for rounding."""
    angle = -math.remainder(-angle, math.tau)
    return 0.0 if abs(angle) < 1e-12 else angle


class Builder:
    """Bodies added one group after another; `size` is the half width of the field in metres."""

    def __init__(self, rng: random.Random, size: float, ill: float, swapped: bool, every: bool = False) -> None:
        self.rng, self.size, self.ill, self.swapped, self.every = rng, size, ill, swapped, every
        self.bare = 0.6 if every else 0.0  # share of bodies with only the points they need
        self.lines: dict[str, tuple[Body, complex, float]] = {}  # guide -> its link, a point on it, its direction
        self.twins: set[str] = set()
        self.frame = Body(0j, 0.0)
        self.bodies = [self.frame]
        self.dyads: list[Dyad] = []
        self.triads: list[tuple[Body, list[Body], dict[str, complex]]] = []  # basic link, leads, its hinges
        self.names = iter(rng.sample(NAMES[:20], 20) + NAMES[20:])

    def spot(self) -> complex:
        """A random point of the field."""
        return self.size * complex(self.rng.uniform(-1, 1), self.rng.uniform(-1, 1))

    def add(self, body: Body, at: complex) -> str:
        """A new named point of a body."""
        name = next(self.names)
        body.points[name] = at
        return name

    def link(self, points: Sequence[tuple[str, complex]], along: float | None = None) -> Body:
        """A new body with these points and perhaps others; its x axis along a guide, two points, or any."""
        items, rng, bare = list(points), self.rng, bool(points) and self.spare()
        rng.shuffle(items)
        for _ in range(0 if bare else 0 if items and rng.random() < 0.6 else 1):
            items.insert(rng.randint(0, len(items)), (next(self.names), self.spot()))
        first, style = items[0][1], rng.random()
        body = Body(first, rng.uniform(-math.pi, math.pi), bare=bare)
        if style < 0.4 and along is not None:
            body.turn = along + rng.choice((0.0, 0.0, math.pi / 2, -math.pi / 2))
        elif style < 0.7 and len(items) > 1:
            body.turn = cmath.phase(items[1][1] - first)
        elif style < 0.85:
            body.origin = first + 0.3 * self.spot()
        body.points = dict(items)
        self.bodies.append(body)
        return body

    def spare(self) -> bool:
        """Whether to omit an optional part."""
        return self.bare > 0 and self.rng.random() < self.bare

    def direction(self, owner: Body) -> float:
        """The direction of a guide: along an axis of its owner, or any; with `every`, also that of its other guide."""
        drawn = [u for body, _, u in self.lines.values() if body is owner]
        if self.every and drawn and self.rng.random() < 0.4:
            return self.rng.choice(drawn)
        return self.rng.choice((owner.turn, owner.turn + math.pi / 2, self.rng.uniform(-math.pi, math.pi)))

    def slide(self, slider: Body, owner: Body, u: float) -> str:
        """Writes a guide of direction `u` on `owner` and lets `slider` slide on it; the guide's name."""
        rng, along, first = self.rng, cmath.rect(1.0, u), next(iter(slider.points.values()))
        for name, (body, place, turn) in self.lines.items() if self.every else ():
            if body is owner and turn == u:  # another slider on an existing guide
                self.write_slide(slider, name, u, ((first - place) * along.conjugate()).imag)
                return name
        angle = wrapped(u - owner.turn)
        offset = rng.choice((0.0, self.size * rng.uniform(-0.3, 0.3)))
        ways = ["place", "new"] + ["point"] * bool(owner.points)
        ways += ["y"] * 4 * (angle == 0) + ["x"] * 4 * (abs(angle - math.pi / 2) < 1e-12)
        way = rng.choice(ways)
        spec: dict[str, Any] = {"angle": math.degrees(angle)}
        if way == "point":
            spec["through"] = rng.choice(list(owner.points))
            offset = ((first - owner.points[spec["through"]]) * along.conjugate()).imag
        foot = first - 1j * along * offset
        on_line = foot + along * self.size * rng.uniform(-1, 1)
        if way == "place":
            at = owner.local(on_line)
            spec["through"] = [at.real, at.imag]
        elif way == "new":
            spec["through"] = self.add(owner, on_line)
        elif way == "x":
            spec = {"x": owner.local(foot).real}
        elif way == "y":
            spec = {"y": owner.local(foot).imag}
        name = f"g{sum(len(b.guides) for b in self.bodies) + 1}"
        if self.every and rng.random() < 0.2:
            spec["mark"] = next(self.names)
        owner.guides[name] = spec
        self.lines[name] = (owner, foot, u)
        self.write_slide(slider, name, u, offset)
        return name

    def write_slide(self, slider: Body, name: str, u: float, offset: float) -> None:
        """Writes the guide of a sliding body."""
        rng, turn = self.rng, wrapped(slider.turn - u)
        extra = {"angle": math.degrees(turn), "offset": offset}
        used = {k: v for k, v in extra.items() if v or rng.random() < 0.1}
        slider.slides = {"guide": name, **used} if used else name

    def twin(self, body: Body) -> None:
        """A second point at a point of the body, or of another one; anywhere in the order except first on a slider."""
        rng = self.rng
        others = [z for b in (body, *self.bodies) for z in b.points.values()]
        items, name = list(body.points.items()), next(self.names)
        items.insert(rng.randint(body.slides is not None, len(items)), (name, rng.choice(others)))
        body.points = dict(items)
        self.twins.add(name)

    def outer_slide(self, new: Body, base: Body, u: float) -> str:
        """An outer sliding pair, sometimes with the guide on the new link and the earlier one sliding."""
        free = base is not self.frame and base.slides is None and self.swapped
        turned = free and (new.slides is not None or self.rng.random() < 0.25)
        return self.slide(base, new, u) if turned else self.slide(new, base, u)

    def hinge(self, base: Body, other: Body) -> tuple[str | None, complex]:
        """An outer hinge on `base`: one of its points, a multiple hinge, or a new one (name None)."""
        fixed = self.frame.points if base is not self.frame else {}
        old = [(k, z) for k, z in base.points.items() if k not in other.points and k not in fixed]
        return self.rng.choice(old) if old and self.rng.random() < 0.35 else (None, self.spot())

    def drive(self, sliding: bool) -> dict[str, Any]:
        """The driver, hinged to the frame or sliding on it; its part of the scene without rates."""
        at = self.spot()
        if not sliding:
            name = self.add(self.frame, at)
            second = [] if self.every and self.rng.random() < 0.8 else [(next(self.names), self.spot())]
            driver = self.link([(name, at), *second])
            return {"phi": math.degrees(wrapped(driver.turn))}
        u = self.direction(self.frame)
        driver = self.link([(next(self.names), at)], u)
        return {"s": self.slid(driver, self.frame, u)}

    def slid(self, driver: Body, owner: Body, u: float) -> float:
        """Lets a driver slide on a body; its position along the guide."""
        spec = owner.guides[self.slide(driver, owner, u)]
        through = complex(spec.get("x", 0), spec.get("y", 0))
        if "through" in spec:
            to = spec["through"]
            through = owner.local(owner.points[to]) if isinstance(to, str) else complex(*to)
        through = owner.origin + through * cmath.rect(1.0, owner.turn)
        first = next(iter(driver.points.values()))
        return float(((first - through) * cmath.rect(1.0, -u)).real)

    def on_boom(self) -> dict[str, Any]:
        """A cylinder on links at rest, or one that moves such a link; its part of the scene."""
        size = self.size
        while True:
            a, b, c = (self.spot() for _ in range(3))
            if abs(self.leaning(a, b, c)) > 0.35 and min(abs(b - a), abs(c - b)) > 0.3 * size:
                break
        name = next(self.names)
        hinges = [(self.add(self.frame, z), z) for z in (a, c)]
        still = [self.link([hinge, (name, b)]) for hinge in hinges]
        self.dyads.append(Dyad("RRR", still[0], still[1], (hinges[0][0], hinges[1][0]), name, name))
        grounds = self.rng.choice(((still[0], still[1]), (still[0], still[0]), (self.frame, still[0])))
        drive = self.cylinder(self.rng.random() < 0.3, self.rng.sample(grounds, 2))
        self.bodies = [self.frame, *self.bodies[3:], *still]
        return drive

    def cylinder(self, motor: bool, grounds: Sequence[Body] = ()) -> dict[str, Any]:
        """A cylinder hinged to the frame that moves a link on the frame; its part of the scene.

        With ``motor``, two links with a motor between them; with ``grounds``, both are on these.
        """
        rng, kind = self.rng, self.rng.choice(("RRR", "RRP"))
        base, ground = grounds or (self.frame, self.frame)
        for _ in range(1000):
            d, a, o = self.spot(), self.spot(), self.spot()
            u, u2 = cmath.phase(a - d), self.direction(ground)
            lean = math.sin(u - cmath.phase(a - o)) if kind == "RRR" else math.cos(u2 - u)
            if min(abs(a - d), abs(a - o)) > 0.3 * self.size and abs(lean) > 0.35:
                break
        u += rng.choice((0.0, 0.0, rng.uniform(-1, 1), math.pi))
        hinge, pivot = next(self.names), self.add(base, d)
        if motor:
            drive, barrel = self.motor(hinge, a, pivot, d)
        elif rng.random() < 0.5:
            rod, barrel = self.link([(hinge, a)], u), self.link([(pivot, d)], u)
            drive = {"s": self.slid(rod, barrel, u)}
        else:  # its barrel moves
            barrel, rod = self.link([(pivot, d)], u), self.link([(hinge, a)], u)
            drive = {"s": self.slid(barrel, rod, u)}
        if kind == "RRR":
            other = self.add(ground, o)
            self.dyads.append(Dyad(kind, barrel, self.link([(hinge, a), (other, o)]), (pivot, other), hinge, hinge))
        else:
            moved = self.link([(hinge, a)], u2)
            self.slide(moved, ground, u2)
            self.dyads.append(Dyad(kind, barrel, moved, (pivot,), hinge, hinge, lean > 0))
        return drive

    def on_slider(self) -> dict[str, Any]:
        """A cylinder or a motor on a link that slides on the frame; its part of the scene."""
        rng, frame, kind = self.rng, self.frame, self.rng.choice(("RRP", "RRP", "PRP"))
        for _ in range(1000):
            (d, a, o), ways = (self.spot() for _ in range(3)), (self.direction(frame), self.direction(frame))
            lean = math.cos(ways[0] - cmath.phase(a - o)) if kind == "RRP" else math.sin(ways[0] - ways[1])
            if min(abs(a - d), abs(a - o)) > 0.3 * self.size and abs(lean) > 0.35:
                break
        hinge, foot = next(self.names), next(self.names)
        if rng.random() < 0.5:
            drive, carrier = self.motor(hinge, a, foot, d, ways[0])
        else:
            u = rng.uniform(-math.pi, math.pi)
            rod, carrier = self.link([(hinge, a)], u), self.link([(foot, d)], ways[0])
            drive = {"s": self.slid(rod, carrier, u)}
        self.outer_slide(carrier, frame, ways[0])
        if kind == "RRP":
            pivot = self.add(frame, o)
            self.dyads.append(
                Dyad(kind, self.link([(pivot, o), (hinge, a)]), carrier, (pivot,), hinge, hinge, lean > 0)
            )
        else:
            moved = self.link([(hinge, a)], ways[1])
            self.outer_slide(moved, frame, ways[1])
            self.dyads.append(Dyad(kind, carrier, moved, (), hinge))
        return drive

    def brace(self) -> dict[str, Any]:
        """A cylinder across the hinge of two links, one of which is on the frame, as is the third link they move.

        Returns its part of the scene.
        """
        rng, least, slides = self.rng, 0.3 * self.size, self.rng.random() < 0.3
        for _ in range(2000):
            o, a, q, p, b, d = (self.spot() for _ in range(6))
            u2, kind = self.direction(self.frame), rng.choice(("RRR", "RRP"))
            knee, lean = self.leaning(a, p, q), self.leaning(o, b, d)
            if slides:
                lean = math.cos(u2 - cmath.phase(b - d))
            elif kind == "RRP":
                lean = math.cos(u2 - cmath.phase(b - o))
            sides = (p - q, a - p, a - q, o - b, o - a, a - b, b - d)
            if min(map(abs, sides)) > least and min(abs(knee), abs(lean)) > 0.35:
                break
        else:
            raise NoSolution("no well conditioned place for a brace was drawn")
        names = [next(self.names) for _ in range(4)]
        pivot = next(self.names) if slides else self.add(self.frame, o)
        first = self.link([(pivot, o), (names[0], a), (names[1], q)], u2 if slides else None)
        second = self.link([(names[0], a), (names[2], p), (names[3], b)])
        u = cmath.phase(p - q) + rng.choice((0.0, 0.0, rng.uniform(-1, 1), math.pi))
        ends = rng.sample([(names[1], q), (names[2], p)], 2)
        rod, barrel = (self.link([end], u) for end in ends)
        self.bodies.remove(rod)
        self.bodies.insert(1, rod)
        drive = {"s": self.slid(rod, barrel, u)}
        far = rod if names[2] in rod.points else barrel
        self.dyads.append(Dyad("RRR", second, far, (names[0], names[1]), names[2], names[2]))
        if slides:
            self.outer_slide(first, self.frame, u2)
            pivot = self.add(self.frame, d)
            third = self.link([(names[3], b), (pivot, d)])
            self.dyads.append(Dyad("RRP", third, first, (pivot,), names[3], names[3], lean > 0))
        elif kind == "RRR":
            other = self.add(self.frame, d)
            third = self.link([(names[3], b), (other, d)])
            self.dyads.append(Dyad(kind, first, third, (pivot, other), names[3], names[3]))
        else:
            third = self.link([(names[3], b)], u2)
            self.slide(third, self.frame, u2)
            self.dyads.append(Dyad(kind, first, third, (pivot,), names[3], names[3], lean > 0))
        return drive

    def lead(self) -> dict[str, Any]:
        """A cylinder or a motor in a lead of a basic link with two more leads on the frame; its part of the scene."""
        rng, pins = self.rng, [next(self.names) for _ in range(3)]
        kinds = ["PR" if rng.random() < 0.3 else "RR", *(rng.choice(("RR", "PR")) for _ in range(2))]
        for _ in range(2000):
            spots, pivots = ([self.spot() for _ in range(3)] for _ in range(2))
            ways = [rng.uniform(-math.pi, math.pi) for _ in range(3)]
            near = min(abs(a - b) for a, b in zip(spots, pivots, strict=True))
            if three_lines(kinds, spots, pivots, ways) > 0.35 * self.size and near > 0.3 * self.size:
                break
        else:
            raise NoSolution("no well conditioned place for a lead was drawn")
        p, a, along = spots[0], pivots[0], ways[0] if kinds[0] == "PR" else None
        pivot = self.add(self.frame, a) if along is None else next(self.names)
        if rng.random() < 0.3:
            drive, held = self.motor(pins[0], p, pivot, a, along)
        else:
            u = cmath.phase(p - a) + rng.choice((0.0, 0.0, rng.uniform(-1, 1), math.pi))
            ends = rng.sample([(pivot, a), (pins[0], p)], 2) if along is None else [(pins[0], p), (pivot, a)]
            rod = self.link([ends[0]], u)
            held = self.link([ends[1]], u if along is None else along)
            drive = {"s": self.slid(rod, held, u)}
        if along is not None:
            self.outer_slide(held, self.frame, along)
        basic, leads = self.link(list(zip(pins, spots, strict=True))), list[Body]()
        for name, at, base, u, kind in zip(pins[1:], spots[1:], pivots[1:], ways[1:], kinds[1:], strict=True):
            if kind == "RR":
                leads.append(self.link([(self.add(self.frame, base), base), (name, at)]))
            else:
                leads.append(self.link([(name, at)], u))
                self.slide(leads[-1], self.frame, u)
        self.triads.append((basic, leads, dict(zip(pins[1:], spots[1:], strict=True))))
        return drive

    def rocked(self) -> dict[str, Any]:
        """A cylinder or a motor between two links on the frame connected by another link; its part of the scene."""
        rng, outer = self.rng, self.rng.choice(("RR", "RP"))
        lead = rng.choice(("RR", "RR", "PR", "RP"))
        while True:
            near, far, _ = spots = self.contour_spots(["RR", lead, "RR" if outer == "RR" else "RP"])
            if abs(near[0] - far[0]) > 0.3 * self.size:
                break
        names = [next(self.names) for _ in range(2)]
        if rng.random() < 0.3:
            drive, _ = self.motor(names[1], far[0], names[0], near[0])
        else:
            u = cmath.phase(far[0] - near[0]) + rng.choice((0.0, 0.0, rng.uniform(-1, 1), math.pi))
            ends = rng.sample([(names[0], near[0]), (names[1], far[0])], 2)
            rod, barrel = (self.link([end], u) for end in ends)
            drive = {"s": self.slid(rod, barrel, u)}
        links, rods = self.contour_links([self.frame, self.frame], outer, ["", lead], spots)
        for link, name, z in zip(links, names, (near[0], far[0]), strict=True):
            link.points[name] = z
        inner = {k: z for k, z in links[1].points.items() if k == names[1] or any(k in r.points for r in rods)}
        self.triads.append((links[1], [links[0], *rods], inner))
        return drive

    def leaning(self, start: complex, inner: complex, end: complex) -> float:
        """The sine of the angle between two sides of a triangle."""
        one, two = inner - start, end - inner
        return (one.conjugate() * two).imag / (abs(one * two) or 1.0)

    def motor(
        self, hinge: str, a: complex, pivot: str, d: complex, along: float | None = None
    ) -> tuple[dict[str, Any], Body]:
        """Two links with a motor in the hinge between them, either of which is the driver; and the one on the frame.

        The latter is hinged to the frame or slides ``along`` it.
        """
        rng, knee, z = self.rng, next(self.names), self.spot()
        ends = [([(hinge, a), (knee, z)], None), ([(pivot, d), (knee, z)], along)]
        one, two = (self.link(*x) for x in rng.choice((ends, ends[::-1])))
        return {"on": two, "phi": math.degrees(wrapped(one.turn - two.turn))}, one if pivot in one.points else two

    def group(self, kind: str, ill: bool) -> None:
        """A group on two different earlier bodies, sharpness over 0.35 or, if `ill`, down to `self.ill`."""
        rng = self.rng
        moving = self.bodies[1:]
        one = rng.choice([moving[-1], *moving])
        two = rng.choice([b for b in self.bodies if b is not one] + [self.frame] * (len(moving) < 3))
        one, two = rng.choice(((one, two), (two, one)))
        small = rng.choice((-1, 1)) * 10 ** rng.uniform(math.log10(self.ill), -1) if ill else 0.0
        for _ in range(1000):
            (a, at), (c, ct), bt = self.hinge(one, two), self.hinge(two, one), self.spot()
            u, u2 = self.direction(one), self.direction(two)
            if kind == "RRR":
                if small:
                    bt = at + (ct - at) * (rng.choice((0.3, 0.5, 1.5, -0.6)) + 1j * small / 4)
                sides = [bt - at, ct - bt, ct - at]
                sharp = (sides[0].conjugate() * sides[1]).imag / abs(sides[0] * sides[1])
            elif kind == "RRP":
                u2 = cmath.phase(bt - at) + math.pi / 2 + small if small else u2
                sides = [bt - at]
                sharp = math.cos(u2 - cmath.phase(bt - at))
            elif kind == "RPR":
                u = cmath.phase(ct - at) + (math.pi / 2 + small if small else rng.uniform(-math.pi, math.pi))
                u = u if small else rng.choice((u, cmath.phase(ct - at)))
                sides = [ct - at]
                sharp = math.cos(u - cmath.phase(ct - at))
            else:
                u = u2 + small if small else u if kind == "PRP" else rng.uniform(-math.pi, math.pi)
                sides, sharp = [], math.sin(u - u2)
            short = min([abs(s) for s in sides], default=self.size)
            if short > 0.3 * self.size and (small or abs(sharp) > 0.35):
                break
        else:
            raise NoSolution("no well conditioned place for a group was drawn")
        a = a or (self.add(one, at) if kind != "PRP" else "")
        c = c or (self.add(two, ct) if kind in ("RRR", "RPR") else "")
        b, ahead = (next(self.names) if kind in ("RRR", "RRP", "PRP") else ""), sharp > 0
        if kind == "RRR":
            i, j = self.link([(a, at), (b, bt)]), self.link([(b, bt), (c, ct)])
            self.dyads.append(Dyad(kind, i, j, (a, c), b, b))
        elif kind == "RRP":
            i, j = self.link([(a, at), (b, bt)]), self.link([(b, bt)], u2)
            self.outer_slide(j, two, u2)
            self.dyads.append(Dyad(kind, i, j, (a,), b, b, ahead))
        elif kind == "RPR":
            i, j = self.link([(a, at)], u), self.link([(c, ct)], u)
            slid = self.slide(j, i, u)  # i owns the guide; which of the two hinges is a, is random already
            self.dyads.append(Dyad(kind, i, j, (a, c), None, slid, ahead))
        elif kind == "PRP":
            i, j = self.link([(b, bt)], u), self.link([(b, bt)], u2)
            self.outer_slide(i, one, u)
            self.outer_slide(j, two, u2)
            self.dyads.append(Dyad(kind, i, j, (), b))
        else:
            i, j = self.link([(a, at)], u), self.link([], u2)
            free = two is not self.frame and two.slides is None and self.swapped
            self.slide(*((j, i) if free and rng.random() < 0.5 else (i, j)), u)
            self.outer_slide(j, two, u2)
            self.dyads.append(Dyad(kind, i, j, (a,)))

    def triad(self, kind: str) -> None:
        """A group of class III, "RR-PR-RP": a basic link and three leads on earlier bodies; its lines well apart."""
        rng, moving = self.rng, self.bodies[1:]
        bases = [rng.choice([moving[-1], *moving]), *rng.choices(self.bodies, k=2)]
        if bases[0] is bases[1] is bases[2]:
            bases[2] = self.frame
        for _ in range(2000):
            spots, pivots = ([self.spot() for _ in range(3)] for _ in range(2))
            ways = [rng.uniform(-math.pi, math.pi) for _ in range(3)]
            if three_lines(kind.split("-"), spots, pivots, ways) > 0.35 * self.size:
                break
        else:
            raise NoSolution("no well conditioned place for a group was drawn")
        self.basic(kind.split("-"), bases, spots, pivots, ways, [])

    def chain(self, kind: str) -> None:
        """Basic links hinged to each other in a chain, "RR-PR+RP-RR": leads on earlier bodies; far from a dead point.

        The distance is that of the lines from the last hinge to the intersections of the leads on either side.
        """
        rng, moving = self.rng, self.bodies[1:]
        sides = [side.split("-") for side in kind.split("+")]
        count = sum(map(len, sides))
        bases = [rng.choice([moving[-1], *moving]), *rng.choices(self.bodies, k=count - 1)]
        if all(base is bases[0] for base in bases):
            bases[-1] = self.frame
        ends = [sum(map(len, sides[:k])) for k in range(len(sides) + 1)]
        own = [slice(*pair) for pair in pairwise(ends)]
        for _ in range(2000):
            pins, spots, pivots = ([self.spot() for _ in range(n)] for n in (len(sides) - 1, count, count))
            ways, firm = [rng.uniform(-math.pi, math.pi) for _ in range(count)], 0j
            lines: list[tuple[complex, complex]] = []
            for k, leads in enumerate(sides[:-1]):
                lines += lines_of(leads, spots[own[k]], pivots[own[k]], ways[own[k]])
                firm = pull_at(pins[k], lines)
                lines = [(firm, pins[k])]
            last = pull_at(pins[-1], lines_of(sides[-1], spots[own[-1]], pivots[own[-1]], ways[own[-1]]))
            if abs((firm.conjugate() * last).imag) > 0.2 * self.size ** len(sides):
                break
        else:
            raise NoSolution("no well conditioned place for a group was drawn")
        hinges = [(next(self.names), pin) for pin in pins]
        for k, leads in enumerate(sides):
            self.basic(leads, bases[own[k]], spots[own[k]], pivots[own[k]], ways[own[k]], hinges[max(k - 1, 0) : k + 1])
        several = [self.triads.pop() for _ in sides]
        self.triads.append((*several[-1][:2], dict(hinges) | {n: z for x in several[::-1] for n, z in x[2].items()}))

    def basic(
        self,
        kinds: list[str],
        bases: list[Body],
        spots: list[complex],
        pivots: list[complex],
        ways: list[float],
        more: list[tuple[str, complex]],
    ) -> None:
        """A basic link, with ``more`` points, and its leads."""
        rng = self.rng
        hinges = [(next(self.names), z) for z, lead in zip(spots, kinds, strict=True) if lead[1] == "R"]
        basic, leads = self.link([*more, *hinges]), []
        names = iter(hinges)
        for lead, base, pivot, u in zip(kinds, bases, pivots, ways, strict=True):
            if lead == "PR":
                leads.append(self.link([next(names)], u))
                self.outer_slide(leads[-1], base, u)
                continue
            if lead == "PP":
                leads.append(self.link([], u))
                own = u + rng.choice((-1, 1)) * rng.uniform(0.5, math.pi / 2)
                carried = base is not self.frame and base.slides is None and (basic.slides or rng.random() < 0.4)
                self.slide(*((leads[-1], basic) if carried else (basic, leads[-1])), own)
                self.outer_slide(leads[-1], base, u)
                continue
            outer = self.add(base, pivot), pivot
            leads.append(self.link([outer, next(names)] if lead == "RR" else [outer], u))
            if lead == "RP":
                turned = basic.slides is None and rng.random() < 0.4
                self.slide(*((basic, leads[-1]) if turned else (leads[-1], basic)), u)
        self.triads.append((basic, leads, dict(hinges)))

    def contour(self, kind: str) -> None:
        """A group of class IV, "IV RP RR PR": its outer pairs, and both pairs of the links between, the base's first.

        "IV" has hinges only; the group is far from a dead point.
        """
        rng, moving = self.rng, self.bodies[1:]
        outer, *leads = kind.split()[1:] or ["RR", "RR", "RR"]
        bases = [rng.choice([moving[-1], *moving]), rng.choice(self.bodies)]
        if bases[0] is bases[1]:
            bases[1] = self.frame
        rng.shuffle(bases)
        spots = self.contour_spots([*leads, {"RR": "RR", "RP": "RP", "PP": "PP"}[outer]])
        links, rods = self.contour_links(bases, outer, leads, spots)
        key = (self.add(links[1], self.spot()),) if outer[1] == "P" or all(x[1] == "P" for x in leads) else ()
        inner = {k: z for k, z in links[1].points.items() if k in key or any(k in r.points for r in rods)}
        self.triads.append((links[1], [links[0], *rods], inner))

    def contour_spots(self, ties: list[str]) -> tuple[list[complex], list[complex], list[float]]:
        """The points where its links are held, on the base and on the basic link; and the directions of guides.

        The last point of each is where it is hinged.
        """
        for _ in range(2000):
            near, far = ([self.spot() for _ in range(3)] for _ in range(2))
            ways = [self.rng.uniform(-math.pi, math.pi) for _ in range(3)]
            if three_lines(ties, far, near, ways) > 0.35 * self.size:
                return near, far, ways
        raise NoSolution("no well conditioned place for a group was drawn")

    def contour_links(
        self, bases: list[Body], outer: str, leads: list[str], spots: tuple[list[complex], list[complex], list[float]]
    ) -> tuple[list[Body], list[Body]]:
        """Its base and basic link, and the two between them."""
        near, far, ways = spots
        rng = self.rng
        links, hinges, rods = list[Body](), list[list[tuple[str, complex]]](), list[Body]()
        for side, (owner, places) in enumerate(zip(bases, (near, far), strict=True)):
            hung = [(self.add(owner, places[2]), places[2])] if outer[side] == "R" else []
            hinges.append([(next(self.names), z) for z in places[:2]])
            held = [h for h, lead in zip(hinges[-1], leads, strict=True) if lead and lead[side] == "R"]
            links.append(self.link([*hung, *held], None if hung else ways[2]))
        if outer[1] == "P":
            self.outer_slide(links[1], bases[1], ways[2])
        if outer == "PP":
            self.outer_slide(links[0], bases[0], ways[2] + rng.choice((-1, 1)) * rng.uniform(0.5, math.pi / 2))
        for ends, lead, u in zip(zip(*hinges, strict=True), leads, ways, strict=False):
            if not lead:  # it exists
                continue
            rods.append(self.link([e for e, kind in zip(ends, lead, strict=True) if kind == "R"], u))
            if "P" in lead:
                mate = links[lead.index("P")]
                turned = mate.slides is None and self.rng.random() < 0.4
                self.slide(*((mate, rods[-1]) if turned else (rods[-1], mate)), u)
        return links, rods

    def assembly(self, way: str | None) -> dict[str, Any]:
        """The assembly by side words or by true positions; call it once the bodies are in file order."""
        out: dict[str, Any] = {}
        rank = {id(b): k for k, b in enumerate(self.bodies)}
        spots = {k: z for b in self.bodies for k, z in b.points.items()}
        for d in (d for d in self.dyads if d.key):
            assert d.key is not None
            mine = {**d.i.points, **d.j.points}
            others = {k for b in self.bodies if b not in (d.i, d.j) for k in b.points}
            marks = [k for k in mine if k not in d.outer and k not in self.twins and (k == d.inner or k not in others)]
            if (way or self.rng.choice(("near", "side"))) == "near" and marks:
                mark = self.rng.choice([*marks, d.inner or marks[0]])
                out[mark] = {"near": [mine[mark].real, mine[mark].imag]}
            elif d.kind == "RRR":
                ends = d.outer if rank[id(d.i)] < rank[id(d.j)] else d.outer[::-1]
                start, end, inner = (spots[k] for k in (*ends, d.key))
                out[d.key] = "left" if ((end - start).conjugate() * (inner - start)).imag > 0 else "right"
            else:
                out[d.key] = "ahead" if d.ahead else "behind"
        for basic, _, hinges in self.triads:
            z = (hinges or basic.points)[key := self.rng.choice(list(hinges or basic.points))]
            out[key] = {"near": [z.real, z.imag]}
        return out

    def bend(self, scene: dict[str, Any]) -> None:
        """Turns most hinges of two links, except the driver's, into guides along a circle about them on one link."""
        rng, bodies = self.rng, {b.name: b for b in self.bodies}
        driver = bodies[scene["drive"]["link"]]
        for point in dict.fromkeys(p for b in self.bodies for p in b.points):
            holders = [b for b in self.bodies if point in b.points]
            if len(holders) != 2 or driver in holders or rng.random() > 0.6:
                continue
            moved, owner = rng.sample(holders, 2)
            used = any(point == g.get("through", g.get("centre")) for g in moved.guides.values())
            if moved is self.frame or moved.slides is not None or len(moved.points) < 2 or used:
                continue
            at, name = moved.local(moved.points.pop(point)), f"c{point}"
            back = (at - moved.local(next(iter(moved.points.values())))) / 1j
            side, radius = rng.choice((1, -1)), abs(back) * rng.uniform(0.4, 2.0)
            turn = -math.degrees(cmath.phase(back * side))
            moved.slides = {"guide": name, "angle": turn, "offset": radius - side * abs(back)}
            owner.guides[name] = {"centre": point, "radius": radius}
            scene["links"][moved.name]["slides"] = moved.slides
            scene["links"][moved.name]["points"].pop(point)
            (scene["frame"] if owner is self.frame else scene["links"][owner.name])["guides"] = owner.guides


def three_lines(leads: Sequence[str], spots: list[complex], pivots: list[complex], ways: list[float]) -> float:
    """The distance of the lines of three leads from a common point, times the sine between the first two."""
    rows = []
    for lead, spot, pivot, u in zip(leads, spots, pivots, ways, strict=True):
        if lead == "PP":  # it only blocks rotation
            rows.append([0.0, 0.0, abs(spots[0])])
            continue
        at = pivot if lead == "RP" else spot
        along = (spot - pivot) / abs(spot - pivot) if lead == "RR" else 1j * cmath.rect(1.0, u)
        rows.append([along.real, along.imag, (at.conjugate() * along).imag])
    return abs(float(np.linalg.det(np.array(rows))))


def lines_of(
    kinds: list[str], spots: list[complex], pivots: list[complex], ways: list[float]
) -> list[tuple[complex, complex]]:
    """The directions in which leads hold their link, and a point on the line of each."""
    lines = []
    for lead, spot, pivot, u in zip(kinds, spots, pivots, ways, strict=True):
        along = (spot - pivot) / abs(spot - pivot) if lead == "RR" else 1j * cmath.rect(1.0, u)
        lines.append((along, pivot if lead == "RP" else spot))
    return lines


def pull_at(pin: complex, lines: list[tuple[complex, complex]]) -> complex:
    """The direction in which two leads hold a point of their link, and how firmly: times the arm of a lead."""
    (n, m), (k, p) = ((along, ((at - pin).conjugate() * along).imag) for along, at in lines)
    return n * p - k * m


def spelled(rng: random.Random, z: complex, size: float) -> Any:
    """A local coordinate as a number (on the x axis), [x, y] or {r, angle}."""
    if abs(z.imag) < 1e-14 * size and rng.random() < 0.8:
        return 0 if abs(z) < 1e-14 * size else z.real
    return {"r": abs(z), "angle": math.degrees(cmath.phase(z))} if rng.random() < 0.3 else [z.real, z.imag]


def loads_for(rng: random.Random, scene: Mapping[str, Any], sol: Solution, size: float) -> list[dict[str, Any]]:
    """Up to two forces and a moment on every link, in every notation; `motion` only where it moves."""
    links = list(scene["links"])
    out: list[dict[str, Any]] = []
    fastest = max(abs(v) for v, _ in sol.motion.values()) + size * max(abs(w) for _, w in sol.motion.values())
    for name, link in scene["links"].items():
        for _ in range(rng.randint(1, 2)):
            point, way = rng.choice(list(link["points"])), rng.randrange(4)
            v, omega = sol.motion[name]
            x, y, _turn = sol.pose[name]
            moves = abs(v + 1j * omega * (sol.points[point][0] - complex(x, y))) > 1e-6 * fastest
            to: dict[str, Any] = {"direction": rng.uniform(-180, 180)}
            if way == 0:
                to = {"direction": {"link": rng.choice(links), "angle": rng.uniform(-180, 180)}}
            elif way > 1 and moves:
                to = {("along", "against")[way - 2]: "motion"}
            out.append({"link": name, "point": point, "force": rng.uniform(-1000, 1000), **to})
        turns = abs(sol.motion[name][1]) * size > 1e-6 * fastest and rng.random() < 0.5
        if rng.random() < 0.6:
            out.append({"link": name, "moment": size * rng.uniform(-1000, 1000)})
            out[-1] |= {rng.choice(("along", "against")): "motion"} if turns else {}
    rng.shuffle(out)
    return out


def make(
    rng: random.Random,
    kinds: Sequence[str] = ("RRR",),
    *,
    sliding: bool | None = None,
    size: float = 1.0,
    ill: float = 1.0,
    swapped: bool = True,
    friction: bool = False,
    pins: bool = False,
    loads: bool = True,
    assembly: str | None = None,
    rest: bool = False,
    limit: float = 1e9,
    every: bool = False,
    inner: bool | str = False,
    arcs: bool = False,
) -> Case:
    """A random mechanism of these groups in this order; with ``inner`` a cylinder between moving links drives it,
    or a "motor" in their hinge.

    `sliding`: the driver slides (None: one in four); `size`: half width of the field, m; `ill` < 1: one
    group of the chain has a sharpness between that and 0.1; `swapped`: an earlier link may slide on a later
    link's guide; `assembly`: "near", "side" or None for either; `rest`: the driver at rest, `epsilon`
    alone; `limit`: the largest condition number kept; `every`: whatever the format allows, links and drivers of one
    point, several sliders on one guide, coincident points, letters of guides; `arcs`: hinges become
    guides along a circle.
    """
    for _ in range(200):
        try:
            slid = rng.random() < 0.25 if sliding is None else sliding
            case = attempt(
                rng, kinds, slid, size, ill, swapped, friction, pins, loads, assembly, rest, every, inner, arcs
            )
        except (NoSolution, np.linalg.LinAlgError):
            continue
        if case.solution.condition < limit:
            return case
    raise NoSolution(f"no mechanism of {kinds} was drawn")


def attempt(
    rng: random.Random,
    kinds: Sequence[str],
    sliding: bool,
    size: float,
    ill: float,
    swapped: bool,
    friction: bool,
    pins: bool,
    loads: bool,
    assembly: str | None,
    rest: bool,
    every: bool = False,
    inner: bool | str = False,
    arcs: bool = False,
) -> Case:
    """One try of `make`; raises NoSolution if the result is of no use."""
    build = Builder(rng, size, ill, swapped, every)
    inside: dict[str | bool, Callable[[], dict[str, Any]]] = {
        "brace": build.brace,
        "lead": build.lead,
        "rocked": build.rocked,
        "boom": build.on_boom,
        "slider": build.on_slider,
        "motor": lambda: build.cylinder(True),
        True: lambda: build.cylinder(False),
    }
    drive = inside[inner]() if inner else build.drive(sliding)
    sliding = "s" in drive
    blunt = rng.randrange(len(kinds)) if ill < 1 else -1
    for k, kind in enumerate(kinds):
        if kind.startswith("IV"):
            build.contour(kind)
        else:
            way = build.chain if "+" in kind else build.triad
            way(kind) if "-" in kind else build.group(kind, k == blunt)
    for body in build.bodies[1:]:
        for _ in range(0 if body.bare else rng.randint(0, 2)):
            build.add(body, build.spot())
        if every and rng.random() < 0.25:
            build.twin(body)
    driver, moving = build.bodies[1], build.bodies[1:]
    for body, number in zip(moving, rng.sample(range(1, 3 * len(moving)), len(moving)), strict=True):
        body.name = str(number)
    rng.shuffle(moving)
    build.bodies = [build.frame, *moving]
    scene: dict[str, Any] = {"planes": 1, "frame": {}, "links": {b.name: {} for b in moving}}
    for body, out in zip(build.bodies, [scene["frame"], *scene["links"].values()], strict=True):
        if body.points:
            out["points"] = {k: spelled(rng, body.local(z), size) for k, z in body.points.items()}
        if body.guides:
            out["guides"] = body.guides
        if body.slides is not None:
            out["slides"] = body.slides
    omega = 0.0 if rest else rng.choice((-1, 1)) * rng.uniform(1, 20)
    rates = (omega * size, rng.uniform(-100, 100) * size) if sliding else (omega, rng.uniform(-100, 100))
    scene["assembly"] = build.assembly(assembly)
    words = ("velocity", "acceleration") if sliding else ("omega", "epsilon")
    drive |= {"on": drive["on"].name} if "on" in drive else {}
    scene["drive"] = {"link": driver.name, **drive, **dict(zip(words, rates, strict=True))}
    if arcs:
        build.bend(scene)
    guess = {b.name: (b.origin.real, b.origin.imag, b.turn) for b in moving}
    sol = solve(scene, guess)
    if sol.condition > 1e12:
        raise NoSolution("condition")
    if loads:
        for body in moving:
            out = scene["links"][body.name]
            out |= {"mass": rng.uniform(1, 10) / size} if rng.random() < 0.8 else {}
            out |= {"inertia": rng.uniform(0.1, 1) * size} if rng.random() < 0.8 else {}
            out |= {"centre": rng.choice(list(body.points))} if rng.random() < 0.8 else {}
        scene["gravity"] = rng.choice((0, 9.81 * size))
        scene["loads"] = loads_for(rng, scene, sol, size)
    quick = max([abs(v) for v in sol.speeds.values()], default=0.0)
    if friction:
        rubbing = [sol.guides[i][0] for i, v in sol.speeds.items() if abs(v) > 1e-6 * quick]
        scene["friction"] = {guide: 10 ** rng.uniform(-2.5, -0.8) for guide in rubbing}
    if pins:
        rub_hinges(rng, scene, sol, size)
    sol = solve(scene, guess)
    if sol.consistent != 1:
        raise NoSolution("friction with more than one answer")
    groups = [(d.kind, d.i.name, d.j.name) for d in build.dyads]
    return Case(scene, guess, groups, sol)


def rub_hinges(rng: random.Random, scene: dict[str, Any], sol: Solution, size: float) -> None:
    """Pins for hinges and coefficients for guides along a circle, except where links are at rest."""
    drawn, apart = dict[str, Any](), set[str]()
    for (i, j), place in sol.hinges.items():
        common = [p for p in build_points(scene, i, j) if abs(sol.points[p][0] - place) < 1e-9 * size]
        circles = (circle_of(scene, x) for x in (i, j))
        name = next(iter(common), "") or next(
            c[0] for c in circles if c and abs(sol.points[c[1]][0] - place) < 1e-9 * size
        )
        pin = {"coefficient": rng.uniform(0.02, 0.2), "radius": rng.uniform(0.02, 0.1) * size}
        drawn.setdefault(name, pin if common else 10 ** rng.uniform(-2.5, -1.0))
        apart |= {name} if unmoved(sol, i, j) else set()
    scene.setdefault("friction", {}).update({k: v for k, v in drawn.items() if k not in apart})


def unmoved(sol: Solution, *links: str) -> bool:
    """Whether all these links are at rest."""
    most = max(abs(omega) for _, omega in sol.motion.values())
    return all(abs(sol.motion[x][1]) <= 1e-12 * most for x in links if x in sol.motion)


def build_points(scene: Mapping[str, Any], *links: str) -> list[str]:
    """The common points of two links."""
    one, two = ((scene["frame"] if x == "0" else scene["links"][x]).get("points", {}) for x in links)
    return [p for p in one if p in two]


@st.composite
def mechanisms(draw: st.DrawFn, /, most: int = 3, kinds: Sequence[str] = KINDS, **options: Any) -> Case:
    """Hypothesis: a mechanism of one to `most` groups; `options` as for `make`."""
    chain = draw(st.lists(st.sampled_from(list(kinds)), min_size=1, max_size=most))
    return make(random.Random(draw(st.integers(0, 2**32 - 1))), chain, **options)


def expressed(rng: random.Random, scene: Mapping[str, Any]) -> str:
    """A scene file's text in which every number is an expression, many of parameters."""
    parameters: dict[str, float] = {}

    def written(node: Any, key: str = "") -> Any:
        if isinstance(node, Mapping):
            return {k: written(v, str(k)) for k, v in node.items()}
        if isinstance(node, (list, tuple)):
            return [written(v) for v in node]
        if isinstance(node, str):
            return node
        name = f"k{len(parameters)}"
        parameters[name] = float(node)
        ways = [name, f"({name} + {name}) / 2", f"-(-{name})", f"{node / 4!r} * 2^2", f"min({name}, {name} + 1)"]
        return rng.choice(ways)

    body = {k: v if k in ("planes", "loads") else written(v, k) for k, v in scene.items()}
    if "loads" in scene:
        body["loads"] = [{k: v if k == "link" else written(v) for k, v in load.items()} for load in scene["loads"]]
    return to_yaml({"planes": 1, "parameters": parameters, **{k: v for k, v in body.items() if k != "planes"}})


def any_scene(seed: int) -> tuple[Case, str]:
    """A scene of any shape, and the text of its file, every other time with an expression for every number.

    It covers all of the format except: scenes that are rejected (a class higher than II, W other than 1), stated
    vectors, variants (other numbers of the same scene), and positions nearer to a dead point than 1e-3 of sharpness.
    """
    rng = random.Random(f"any {seed}")
    kinds = rng.choices(KINDS, (1, 2, 1, 2, 2), k=rng.choice((0, 1, 1, 2, 2, 2, 3, 3, 4)))
    rubs = rng.random() < 0.3  # only loaded links can rub
    how: dict[str, Any] = {"friction": rubs, "rest": rng.random() < 0.1, "loads": rubs or rng.random() < 0.9}
    ill = 1e-3 if kinds and rng.random() < 0.15 else 1.0
    case = make(rng, kinds, every=True, ill=ill, size=10.0 ** rng.choice((-3, 0, 0, 0, 2)), **how)
    return case, expressed(rng, case.scene) if rng.random() < 0.5 else to_yaml(case.scene)


def shape_of(scene: Mapping[str, Any]) -> list[str]:
    """The unusual features of a scene, in words."""
    links, drive = scene["links"], scene["drive"]
    driver, slid = links[drive["link"]], [v["slides"] for v in links.values() if "slides" in v]
    guides = [s if isinstance(s, str) else s["guide"] for s in slid]
    places = [[str(z) for z in v["points"].values()] for v in links.values()]
    found = {
        "a driver of one point": len(driver["points"]) == 1 and "phi" in drive,
        "a guide on the driver": "guides" in driver,
        "a driver of one point with a guide": len(driver["points"]) == 1 and "guides" in driver and "phi" in drive,
        "a sliding driver": "s" in drive,
        "a link of one point": any(len(v["points"]) == 1 for v in links.values()),
        "two sliders on one guide": len(guides) > len(set(guides)),
        "a guide on a slider": any("slides" in v and "guides" in v for v in links.values()),
        "coincident points": any(len(p) > len(set(p)) for p in places),
        "an offset": any(not isinstance(s, str) and s.get("offset") for s in slid),
        "no offset": any(isinstance(s, str) or not s.get("offset") for s in slid),
        "friction": bool(scene.get("friction")),
        "no group": len(links) == 1,
        "at rest": drive.get("omega") == 0,
    }
    return [name for name, true in found.items() if true]


def flow(value: Any) -> str:
    """A value in YAML's flow style, numbers with all their digits."""
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{flow(str(k))}: {flow(v)}" for k, v in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(flow(v) for v in value) + "]"
    if isinstance(value, str):
        return value if re.fullmatch(r"[\w-]+", value) else json.dumps(value, ensure_ascii=False)
    return repr(value)


def to_yaml(scene: Mapping[str, Any]) -> str:
    """A scene file's text: one line for each link, load or other key."""
    lines = []
    for key, value in scene.items():
        if key == "links":
            lines += ["links:", *(f"  {flow(str(k))}: {flow(v)}" for k, v in value.items())]
        elif key == "loads" and value:
            lines += ["loads:", *(f"  - {flow(v)}" for v in value)]
        else:
            lines.append(f"{key}: {flow(value)}")
    return "\n".join(lines) + "\n"
