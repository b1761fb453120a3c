"""Realistic force polygons, with one mistake or none; forces come from the independent solver."""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from tests.helpers.drawings import NONE, Hand, Mistake, Scheme, meet
from tests.helpers.oracle import Model, Pair, Solution, read


def crossed(a: complex, b: complex) -> float:
    return (a.conjugate() * b).imag


@dataclass
class Force:
    """A force on a link at a point (m), N: the person's and the true one."""

    name: str
    link: str
    vector: complex
    place: complex
    kind: str
    true: complex


@dataclass
class Polygon:
    """A drawn polygon: named vectors in drawing order (mm), and the possible mistakes."""

    vectors: list[tuple[str, complex]] = field(default_factory=list)
    made: list[tuple[str, str]] = field(default_factory=list)
    found: dict[tuple[str, str], complex] = field(default_factory=dict)


@dataclass
class Half:
    """One link of a group: its outer pair, the forces on it, and the reaction there."""

    link: str
    mate: str
    pair: Pair
    forces: list[Force]
    reaction: complex
    split: bool = False
    about: complex = 0j

    @property
    def name(self) -> str:
        return pair_name(self.link, self.mate)


def pair_name(on: str, by: str) -> str:
    return f"F_{on}{by}" if len(on) == len(by) == 1 else f"F_{on}_{by}"


class Forces:
    """The force plans of one scene."""

    def __init__(self, scene: Mapping[str, Any], sol: Solution) -> None:
        self.scene, self.sol, self.model = scene, sol, read(scene)
        self.begin({}, 1.0, {}, 1.0, Hand(NONE, random.Random(0)))

    def begin(self, scheme: Scheme, scheme_mu: float, rates: Mapping[str, complex], mu_a: float, hand: Hand) -> None:
        """Starts with the person's own scheme and acceleration plan, mm by points, and no reactions yet."""
        self.scheme, self.scheme_mu, self.rates, self.mu_a = scheme, scheme_mu, rates, mu_a
        self.measured = {n: z * hand.read(abs(z)) / abs(z) / mu_a if z else z for n, z in rates.items()}
        self.drawn: dict[tuple[str, str], complex] = {}  # reactions as drawn by a person, N

    def seen(self, place: complex) -> complex:
        """The position of a point on the person's own scheme, m."""
        near = min(self.sol.points, key=lambda n: abs(self.sol.points[n][0] - place))
        known = near in self.scheme and abs(self.sol.points[near][0] - place) < 1e-9
        return self.scheme[near] / self.scheme_mu if known else place

    def own_couple(self, link: str, true: float, hand: Hand) -> float:
        """-J·ε, with ε from the tangential component between two points of the link on the person's own plan."""
        names = [n for n in self.scene["links"][link]["points"] if n in self.scheme]
        base = names[0] if names else ""
        far = max(names, key=lambda n: abs(self.scheme[n] - self.scheme[base]), default="")
        epsilon = self.sol.links[link][2]
        if far == base or not epsilon or not self.rates:
            return true
        way = (self.scheme[far] - self.scheme[base]) / self.scheme_mu
        part = (self.rates.get(far, 0j) - self.rates.get(base, 0j)) / (1j * way / abs(way))
        return true * hand.read(part.real) / self.mu_a / abs(way) / epsilon

    def on(self, link: str) -> list[Force]:
        """Weights, inertia and loads of a link."""
        found, count = [], 0
        for a in self.sol.actions:
            if a.link == link and a.kind in ("weight", "inertia", "load") and abs(a.force) > 0:
                letter = {"weight": "G", "inertia": "I", "load": "P"}[a.kind]
                if a.kind == "load":
                    count += 1
                tail = f"_{count}" if letter == "P" and count > 1 else ""
                force = self.inertia(link, a.force) if letter == "I" else a.force
                found.append(Force(f"{letter}_{link}{tail}", link, force, a.place, a.kind, a.force))
        return found

    def inertia(self, link: str, force: complex) -> complex:
        """-m·a with the acceleration as drawn."""
        body = self.scene["links"][link]
        centre = str(body.get("centre", next(iter(body["points"]))))
        return -float(body["mass"]) * self.measured[centre] if centre in self.measured else force

    def reaction(self, on: str, by: str) -> complex:
        """The force on one link from another."""
        for (i, j), force in self.drawn.items():
            if (on, by) in ((i, j), (j, i)):
                return force if (on, by) == (i, j) else -force
        return self.true_reaction(on, by)

    def true_reaction(self, on: str, by: str) -> complex:
        """The same from the solver."""
        for (i, j), r in self.sol.reactions.items():
            force = r[0] if isinstance(r, tuple) else r
            if (i, j) == (on, by):
                return force
            if (i, j) == (by, on):
                return -force
        raise KeyError((on, by))

    def handed(self, link: str, solved: set[str]) -> list[Force]:
        """Reactions from groups balanced before."""
        found = []
        for (i, j), r in self.sol.reactions.items():
            other = j if i == link else i if j == link else None
            if other in solved:
                slide = isinstance(r, tuple)
                place = self.sol.feet[i] if slide else self.hinge(i, j)
                true = self.true_reaction(link, other)
                found.append(Force(pair_name(link, other), link, self.reaction(link, other), place, "handed", true))
        return found

    def hinge(self, i: str, j: str) -> complex:
        return self.sol.hinges.get((i, j), self.sol.hinges.get((j, i), 0j))

    def half(self, link: str, other: str, after: set[str]) -> Half:
        m: Model = self.model
        pairs = [p for p in (*m.hinges, *m.slides) if link in (p.i, p.j) and other not in (p.i, p.j)]
        pair = next(p for p in pairs if (p.j if p.i == link else p.i) not in after)
        mate = pair.j if pair.i == link else pair.i
        return Half(link, mate, pair, self.on(link) + self.handed(link, after), self.reaction(link, mate))

    def inner(self, i: str, j: str) -> Pair:
        return next(p for p in (*self.model.hinges, *self.model.slides) if {p.i, p.j} == {i, j})


def draw_group(f: Forces, pair: tuple[str, ...], mu: float, hand: Hand, mistake: Mistake | None = None) -> Polygon:
    """The polygon of one group, after those of the groups that depend on it."""
    later = f.model.groups[f.model.groups.index(pair) + 1 :]
    after = {n for g in later for n in g}
    halves = {n: f.half(n, pair[1 - k], after) for k, n in enumerate(pair)}
    inner = f.inner(*pair)
    first, last = order(halves, inner)
    return Drawer(f, first, last, inner, mu, hand, mistake).draw()


def order(halves: Mapping[str, Half], inner: Pair) -> tuple[Half, Half]:
    """The half whose line is drawn from the pole comes first."""
    one, two = halves.values()
    if inner.u is not None:
        turning = [h for h in (one, two) if h.pair.u is None]
        first = halves[inner.i] if len(turning) == 2 else turning[0]
    else:
        first = two if one.pair.u is not None and two.pair.u is None else one
    return first, two if first is one else one


@dataclass
class Drawer:
    """A group's polygon while it is drawn."""

    f: Forces
    first: Half
    last: Half
    inner: Pair
    mu: float
    hand: Hand
    mistake: Mistake | None
    sheet: Polygon = field(default_factory=Polygon)

    def now(self, name: str, where: str, variants: int = 1) -> bool:
        """Whether the mistake is made here (in any of its variants)."""
        self.sheet.made.append((name, where))
        return self.mistake is not None and (self.mistake.name, self.mistake.where) == (name, where)

    @property
    def variant(self) -> int:
        return self.mistake.variant if self.mistake else 0

    def split(self) -> None:
        """Selects the outer reactions found in two components, and the point about which moments are taken."""
        hinged = [h for h in (self.first, self.last) if h.pair.u is None]
        if self.inner.u is None:
            for half in hinged:
                half.split, half.about = True, self.f.hinge(self.inner.i, self.inner.j)
        elif len(hinged) == 2:
            self.first.split = True
            self.first.about = self.f.hinge(self.last.pair.i, self.last.pair.j)

    def draw(self) -> Polygon:
        self.split()
        known = {h.link: self.known(h) for h in (self.first, self.last)}
        flat = [v for vs in known.values() for v in vs]
        end = sum((v for _, v in flat), 0j)
        if self.inner.u is not None:
            x = self.sliding_inside(sum((v for _, v in known[self.first.link]), 0j), end)
        else:
            x = meet(end, self.line(self.last), 0j, self.line(self.first))
        x = self.hand.mark(x)
        self.hand.rng.shuffle(flat)
        tail = [(self.part(self.last), x - end), (self.part(self.first), -x)]
        if self.now("not_closed", tail[1][0]):
            tail[1] = tail[1][0], tail[1][1] * 1.15 + 3
        self.sheet.vectors = [*((n, v) for n, v in flat if v != 0), *tail]
        for half in (self.first, self.last):
            parts = [v for n, v in self.sheet.vectors if n in (half.name, half.name + "n", half.name + "t")]
            found = sum(parts, 0j)
            read = self.hand.read(abs(found)) / abs(found) if found else 1.0
            self.sheet.found[half.link, half.mate] = found * read / self.mu
        return self.sheet

    def sliding_inside(self, e_a: complex, e_b: complex) -> complex:
        """X, where the inner guide's normal through the end of the first link's forces meets the other known line."""
        u = next(u for g, _, u in self.f.sol.guides.values() if g == self.inner.name)
        normal = self.hand.ray(1j * u)
        where = self.part(self.last)
        if self.now("guide_reaction_not_normal", where) and self.variant == 0:
            normal = normal * 1j
        if self.first.split:
            return meet(e_a, normal, 0j, self.line(self.first))
        return meet(e_a, normal, e_b, self.line(self.last))

    def part(self, half: Half) -> str:
        return half.name + ("n" if half.split else "")

    def line(self, half: Half) -> complex:
        """The known line of an outer reaction."""
        if half.split:
            return self.hand.ray(self.f.seen(half.about) - self.f.seen(self.hinge(half)))
        u = half.reaction
        if half.pair.u is not None and not half.pair.friction:
            u = 1j * next(u for g, _, u in self.f.sol.guides.values() if g == half.pair.name)
        friction = half.pair.friction
        where = self.part(self.last)
        if friction and abs(self.f.sol.speeds[half.pair.i]) > 0 and self.now("friction_along_motion", where):
            guide = next(u for g, _, u in self.f.sol.guides.values() if g == half.pair.name)
            u = (u / guide).conjugate() * guide * -1
        outer = not friction and half is self.last and self.inner.u is None
        if outer and self.now("guide_reaction_not_normal", where):
            u = 1j * u
        return self.hand.ray(u)

    def arm_of(self, half: Half) -> complex:
        return half.about - self.hinge(half)

    def hinge(self, half: Half) -> complex:
        return self.f.hinge(half.pair.i, half.pair.j)

    def known(self, half: Half) -> list[tuple[str, complex]]:
        """The known vectors of one link, mm, with the mistakes possible in each."""
        moments, out = 0.0, []
        turning = [h for h in (self.first, self.last) if h.split]
        for force in half.forces:
            turns = next((h for h in turning if h is half or self.inner.u is not None), None)
            moment = crossed(force.place - turns.about, force.vector) if turns else 0.0
            vector, change = self.force(force, moment, turns)
            if turns:
                self.pending[turns.link] = self.pending.get(turns.link, 0.0) + change
            out.append((force.name, self.laid(force, vector)))
            moments += change
        if half.split:
            if self.inner.u is not None:  # the moments of the whole group count
                for force in self.other(half).forces:
                    moment = crossed(force.place - half.about, force.vector)
                    self.foresee(force, moment, half)
            out.insert(0, (half.name + "t", self.tangential(half)))
        return [(n, v) for n, v in out if v is not None]

    def other(self, half: Half) -> Half:
        return self.last if half is self.first else self.first

    def foresee(self, force: Force, moment: float, half: Half) -> None:
        """Records the effect on the current moments of a mistake in a force of the other link."""
        _, change = self.force(force, moment, half)
        self.pending[half.link] = self.pending.get(half.link, 0.0) + change

    @property
    def pending(self) -> dict[str, float]:
        found: dict[str, float] = self.__dict__.setdefault("_pending", {})
        return found

    def laid(self, force: Force, vector: complex | None) -> Any:
        """A vector as laid off: with the errors of its computation and of the hand."""
        if vector is None:
            return None
        return self.hand.mark(self.hand.ray(vector) * abs(vector) * self.mu) if vector else None

    def force(self, force: Force, moment: float, turns: Half | None) -> tuple[complex | None, float]:
        """The force as laid off, and the error added to the moments."""
        both = turns is not None and self.variant == 0
        name, vector, factor = force.name, force.vector, 1.0
        if force.kind == "weight":
            factor = 0.0 if self.now("weight_missing", name) else factor
            factor = 1 / 9.81 if self.now("mass_for_weight", name) else factor
        elif self.now("force_missing", name):
            factor = 0.0
        factor = 2.0 if self.now("force_doubled", name) else factor
        if force.kind == "inertia" and self.now("inertia_along_acceleration", name):
            factor = -1.0
        if force.kind == "handed" and self.now("reaction_not_reversed", name):
            factor = -1.0
        change = (factor - 1) * moment if both else 0.0
        if turns:
            change += self.in_moments(force, moment, turns)
        return (None if factor == 0 else factor * vector), change

    def in_moments(self, force: Force, moment: float, turns: Half) -> float:
        """Mistakes of the moment equation only; they are blamed at the tangential reaction."""
        where = turns.name + "t"
        self.sheet.made.append((f"moment_sign:{force.name}", where))
        self.sheet.made.append((f"arm_wrong:{force.name}", where))
        if self.mistake and self.mistake.where == where:
            if self.mistake.name == f"moment_sign:{force.name}":
                return -2 * moment
            if self.mistake.name == f"arm_wrong:{force.name}":
                arm = abs(force.place - turns.about) * abs(force.vector)
                return (arm if moment > 0 else -arm) - moment
        return 0.0

    def tangential(self, half: Half) -> Any:
        """F^t from the true one and the error of the moments."""
        along = self.arm_of(half)
        across = 1j * along / abs(along)
        where = half.name + "t"
        wrong = self.pending.get(half.link, 0.0) + sum(self.own_moments(half))
        size = (self.f.true_reaction(half.link, half.mate) / across).real - wrong / crossed(-along, across)
        links = [half.link, *([self.other(half).link] if self.inner.u is not None else [])]
        for link in links:
            couple = sum(a.moment for a in self.f.sol.actions if a.kind == "inertia" and a.link == link)
            if couple and self.now("inertia_moment_reversed", where):
                size += 2 * couple / crossed(-along, across)
                break
        if self.now("tangential_reversed", where):
            size = -size
        if self.now("reaction_along_loaded_link", where):
            return None
        own = self.f.seen(half.about) - self.f.seen(self.hinge(half))
        if self.inner.u is not None:  # the distance changes with the position: it is measured
            size *= abs(along) / (abs(own) + self.hand.read(0.0) / self.f.scheme_mu)
        return self.hand.mark(self.hand.ray(1j * own) * size * self.mu)

    def own_moments(self, half: Half) -> Iterator[float]:
        """The error of each moment due to the person's own drawn forces and measured arms."""
        links = [half, *([self.other(half)] if self.inner.u is not None else [])]
        for force in (f for h in links for f in h.forces):
            true = crossed(force.place - half.about, force.true)
            arm = self.f.seen(force.place) - self.f.seen(half.about)
            read = self.hand.read(0.0) / self.f.scheme_mu * abs(force.vector)
            yield crossed(arm, force.vector) + read - true
        for link in (h.link for h in links):
            for a in self.f.sol.actions:
                if a.kind == "inertia" and a.link == link and a.moment:
                    yield self.f.own_couple(link, a.moment, self.hand) - a.moment


def draw_driver(f: Forces, mu: float, hand: Hand, mistake: Mistake | None = None) -> Polygon:
    """The polygon of the driver: the forces on it, and the frame's reaction that closes it."""
    link, sheet = f.model.driver, Polygon()
    after = {n for g in f.model.groups for n in g}
    half = Half(link, "0", f.model.hinges[0], f.on(link) + f.handed(link, after), f.reaction(link, "0"))
    draw = Drawer(f, half, half, f.model.hinges[0], mu, hand, mistake, sheet)
    flat = []
    for force in half.forces:
        vector, _ = draw.force(force, 0.0, None)
        laid = draw.laid(force, vector)
        if laid is not None:
            flat.append((force.name, laid))
    hand.rng.shuffle(flat)
    end = sum((v for _, v in flat), 0j)
    tail = [(half.name, -end)]
    if not f.model.revolving:
        u = next(u for n, (_, _, u) in f.sol.guides.items() if n == link)
        x = hand.mark(meet(end, hand.ray(1j * u), 0j, hand.ray(u)))
        tail = [(half.name, x - end), (f"Fb_{link}", -x)]
    if draw.now("not_closed", tail[-1][0]):
        tail[-1] = tail[-1][0], tail[-1][1] * 1.15 + 3
    sheet.vectors = [*flat, *tail]
    return sheet


def rows(sheet: Polygon, origin: complex) -> list[tuple[str, complex]]:
    """The polygon as rows of a table: p, then every mark named by the force that ends there."""
    out, z = [("p", origin)], origin
    for name, vector in sheet.vectors:
        z += vector
        out.append((name, z))
    return out
