"""What must hold of every drawing: checks of its numbers that share no construction with the steps that made them.

A proof compares what was drawn with a definition (a rigid link, a sliding pair, a link in equilibrium, a polygon whose
vectors are what was stated) or with another way to the same number (the force plan's balancing load and the lever's).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import lru_cache, reduce
from typing import ClassVar, Protocol

from planes.drafting.tools import Thing
from planes.geometry import plane
from planes.geometry.arithmetic import Arithmetic, Real
from planes.geometry.arithmetic import Point as Complex
from planes.words.names import mu_of, plan_of

TOLD_APART = 1e-9  # relative: nearer than this, two ways to a number agree
Things = Mapping[str, Thing]
ORDER = {"position": 0, "velocity": 1, "acceleration": 2}
Gap = tuple[Real, Real]  # how far apart the two sides are, and how large what they are made of is


class StatedProduct(Protocol):
    """A product of named values, each to a power."""

    @property
    def factors(self) -> tuple[tuple[str, int], ...]: ...

    def value(self, env: Things, ar: Arithmetic) -> Real: ...


@dataclass(frozen=True)
class Proof:
    """One thing that must hold, shown on ``plan``; ``about`` names what it is of."""

    plan: str
    about: str
    beside: tuple[str, ...] = field(default=(), kw_only=True)  # the marks its plan is driven by: how fast things move
    reason: ClassVar[str]
    makes: ClassVar[str] = ""  # nothing of a position that is refused is to be trusted

    def reads(self) -> tuple[str, ...]:
        """Names of the program it looks at."""
        raise NotImplementedError

    def gap(self, things: Things, ar: Arithmetic, speed: Real = 0.0) -> Gap:
        """How far the two sides are apart, beside the size of what they are made of (SI), ``speed`` of their plan."""
        raise NotImplementedError

    def numbers(self, things: Things, gap: Gap) -> dict[str, object]:
        """What a sentence says of its failure."""
        return {"about": self.about, "gap": float(gap[0]), "size": float(gap[1])}


@dataclass(frozen=True)
class Twofold(Proof):
    """The balancing load by the force plans (``one``) and by the lever (``two``): also the balance of powers."""

    one: str
    two: str
    terms: tuple[StatedProduct, ...]
    reason: ClassVar[str] = "balance_apart"

    def reads(self) -> tuple[str, ...]:
        return (self.one, self.two, *(name for t in self.terms for name, _ in t.factors))

    def gap(self, things: Things, ar: Arithmetic, speed: Real = 0.0) -> Gap:
        one, two = things[self.one], things[self.two]
        size = abs(one) + abs(two)
        for term in self.terms:
            size = size + abs(term.value(things, ar))
        return abs(one - two), size

    def numbers(self, things: Things, gap: Gap) -> dict[str, object]:
        return {"about": self.about, "found": float(things[self.one]), "check": float(things[self.two])}


@dataclass(frozen=True)
class VectorProof(Proof):
    """Every vector of an equation is as long as stated, and points where stated: rows of (start, end, direction,
    signed length's sign, length), either "" where it is not stated."""

    rows: tuple[tuple[str, str, str, int, str], ...]
    reason: ClassVar[str] = "polygon_open"

    def reads(self) -> tuple[str, ...]:
        return tuple(n for start, end, along, _, length in self.rows for n in (start, end, along, length) if n)

    def gap(self, things: Things, ar: Arithmetic, speed: Real = 0.0) -> Gap:
        mu, open_, size = things[mu_of(self.plan)], 0.0, 0.0
        for start, end, along, sign, length in self.rows:
            vector = (things[end] - things[start]) / mu
            size += (ar.size(things[end]) + ar.size(things[start])) / mu
            if length:
                size += abs(things[length])
            if length and along:
                open_ += ar.size(vector - sign * things[length] * things[along])
            elif along:
                open_ += abs(plane.cross(things[along], vector))
            else:
                open_ += abs(abs(vector) - abs(things[length]))
        return open_, size


@dataclass(frozen=True)
class Point:
    """A point of a link: its own coordinate and its marks on the scheme and on the plans of rates."""

    local: complex
    place: str
    rates: tuple[str, str]

    def names(self, plan: str) -> tuple[str, ...]:
        """Its marks as far as a plan."""
        return (self.place, *self.rates[: ORDER[plan]])

    def on(self, plan: str) -> str:
        """Its mark on a plan."""
        return self.place if plan == "position" else self.rates[plan == "acceleration"]


@dataclass(frozen=True)
class LinkMotion:
    """How a link lies and turns: a point of it, and names of its x axis, ω and ε ("" where it never turns)."""

    origin: Point
    axis: str = ""
    omega: str = ""
    epsilon: str = ""

    def names(self, plan: str) -> tuple[str, ...]:
        """What a plan says of it: how it lies, or how it turns."""
        turns = (self.omega, self.epsilon)[: ORDER[plan]] or (self.axis,)
        return (*self.origin.names(plan), *filter(None, turns))

    def at(self, plan: str, things: Things, local: complex, place: Complex) -> Complex:
        """What the plan must show, in SI, for the point of this link that lies at ``local`` or at ``place``."""
        start = _si(things, self.origin.on(plan))
        if plan == "position":
            return start + (things[self.axis] if self.axis else 1.0) * (local - self.origin.local)
        return start + self.spin(plan, things) * (place - _si(things, self.origin.place))

    def spin(self, plan: str, things: Things) -> Complex:
        """iω, or iε - ω²: what the rate of a point is beside its distance."""
        omega = things[self.omega] if self.omega else 0.0
        if plan == "velocity":
            return 1j * omega
        return 1j * (things[self.epsilon] if self.epsilon else 0.0) - omega**2


def _si(things: Things, mark: str) -> Complex:
    return things[mark] / things[_scale(mark)]


@lru_cache(4096)
def _scale(mark: str) -> str:
    return mu_of(plan_of(mark))


def speeds(proofs: Iterable[Proof], things: Things, ar: Arithmetic) -> dict[tuple[str, ...], Real]:
    """How large the marks are together that plans are driven by."""
    every = {proof.beside for proof in proofs}
    return {marks: sum(ar.size(_si(things, mark)) for mark in marks if mark in things) for marks in every}


@dataclass(frozen=True)
class Rigid(Proof):
    """The points of a link keep their distances, and their rates are those of one turning body."""

    body: LinkMotion
    points: tuple[Point, ...]
    reason: ClassVar[str] = "link_bent"

    def reads(self) -> tuple[str, ...]:
        return (*self.body.names(self.plan), *(n for p in self.points for n in p.names(self.plan)))

    def gap(self, things: Things, ar: Arithmetic, speed: Real = 0.0) -> Gap:
        bent, size = 0.0, speed
        for p in self.points:
            place = _si(things, p.place)
            seen = _si(things, p.on(self.plan))
            due = self.body.at(self.plan, things, p.local, place)
            apart = ar.size(seen - due)
            bent, size = bent + apart, size + ar.size(seen) + ar.size(due) + apart
            reach = ar.size(place) + abs(p.local) + abs(self.body.origin.local)  # one about its hinge is no less long
            size += reach * (ar.size(self.body.spin(self.plan, things)) if self.plan != "position" else 1.0)
        return bent, size


@dataclass(frozen=True)
class Slid(Proof):
    """A point of a slider stays on its guide: nothing of its motion against the guide's link is across the guide."""

    slider: Point
    owner: LinkMotion
    through: complex
    turn: complex  # the guide's direction in its link's axes
    offset: float
    reason: ClassVar[str] = "slider_off"

    def reads(self) -> tuple[str, ...]:
        axis = (self.owner.axis,) if self.owner.axis else ()
        return (*self.owner.names(self.plan), *axis, *self.slider.names(self.plan))

    def gap(self, things: Things, ar: Arithmetic, speed: Real = 0.0) -> Gap:
        owner, place = self.owner, _si(things, self.slider.place)
        along = self.turn * (things[owner.axis] if owner.axis else 1.0)
        if self.plan == "position":
            due = owner.at(self.plan, things, self.through, place)
            size = ar.size(place) + ar.size(due) + ar.size(place - due) + abs(self.through) + abs(self.offset)
            return abs(plane.cross(along, place - due) - self.offset), size
        v = _si(things, self.slider.rates[0])
        relative, size = v - owner.at("velocity", things, 0j, place), ar.size(v)
        if self.plan == "acceleration":
            a, coriolis = _si(things, self.slider.rates[1]), 2 * owner.spin("velocity", things) * relative
            relative, size = a - owner.at(self.plan, things, 0j, place) - coriolis, ar.size(a) + ar.size(coriolis)
        reach = ar.size(place) + abs(self.through)
        size += speed + ar.size(relative) + ar.size(owner.spin(self.plan, things)) * reach
        return abs(plane.cross(along, relative)), size


@dataclass(frozen=True)
class Balanced(Proof):
    """All forces on a link add up to nothing, and so do their moments: ``forces`` (size, direction, point), sides of
    ``reactions`` (start, end, ±1, point, couple), ``couples`` (value, ±1)."""

    forces: tuple[tuple[str, str, str], ...]
    reactions: tuple[tuple[str, str, int, str, str], ...]
    couples: tuple[tuple[str, int], ...]
    reason: ClassVar[str] = "link_unbalanced"

    def reads(self) -> tuple[str, ...]:
        of_reactions = (n for start, end, _, point, couple in self.reactions for n in (start, end, point, couple))
        return (*(n for f in self.forces for n in f), *filter(None, of_reactions), *(n for n, _ in self.couples))

    def gap(self, things: Things, ar: Arithmetic, speed: Real = 0.0) -> Gap:
        """Forces, with the moments about the pole divided by the largest distance from it."""
        acting = [(things[size] * things[along], _si(things, point)) for size, along, point in self.forces]
        couples = [sign * things[name] for name, sign in self.couples]
        for start, end, sign, point, couple in self.reactions:
            acting.append((sign * (_si(things, end) - _si(things, start)), _si(things, point)))
            couples += [sign * things[couple]] if couple else []
        far = reduce(ar.maximum, (ar.size(place) for _, place in acting))
        far = far + (far == 0)
        moments = [*(plane.cross(place, force) for force, place in acting), *couples]
        gap = ar.size(sum(force for force, _ in acting)) + abs(sum(moments)) / far
        return gap, sum(ar.size(force) for force, _ in acting) + sum(abs(m) for m in moments) / far
