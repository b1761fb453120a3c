"""What must hold of every drawing: checks of its numbers that share no construction with the steps that made them.
Those of links are in ``link_proofs``.

A proof compares what was drawn with a definition (a rigid link, a sliding pair, a link in equilibrium, a polygon whose
vectors are what was stated) or with another way to the same number (the force plan's balancing load and the lever's).
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from typing import ClassVar

from planes.drafting.steps.reckoning import Product
from planes.drafting.tools import AskedFor, Thing
from planes.geometry import plane
from planes.geometry.arithmetic import Arithmetic, Real
from planes.geometry.arithmetic import Point as Complex
from planes.words.names import mu_of, plan_of

TOLD_APART = 1e-9  # relative: nearer than this, two ways to a number agree
Things = Mapping[str, Thing]
VectorRow = tuple[str, str, str, int, str]  # where it starts and ends, its direction, its sign, its length


@dataclass(frozen=True)
class Proof:
    """One thing that must hold, shown on ``plan``; ``about`` names what it is of."""

    plan: str
    about: str
    beside: tuple[str, ...] = field(default=(), kw_only=True)  # the marks its plan is driven by: how fast things move
    reason: ClassVar[str]
    makes: ClassVar[str] = ""  # nothing of a position that is refused is to be trusted

    @cached_property
    def reads(self) -> frozenset[str]:
        """Names of the program it looks at."""
        asked = AskedFor()
        self.gap(asked, Arithmetic())
        self.size(asked, Arithmetic())
        return frozenset(asked)

    def gap(self, things: Things, ar: Arithmetic) -> Real:
        """How far the two sides are apart, in SI."""
        raise NotImplementedError

    def size(self, things: Things, ar: Arithmetic) -> Real:
        """How large what they are made of is at least, in SI, but for the speed of their plan."""
        raise NotImplementedError

    def numbers(self, things: Things, gap: Real, size: Real) -> dict[str, object]:
        """What a sentence says of its failure."""
        return {"about": self.about, "gap": float(gap), "size": float(size)}


@dataclass(frozen=True)
class Twofold(Proof):
    """The balancing load by the force plans (``one``) and by the lever (``two``): also the balance of powers."""

    one: str
    two: str
    terms: tuple[Product, ...]
    reason: ClassVar[str] = "balance_apart"

    def gap(self, things: Things, ar: Arithmetic) -> Real:
        return abs(things[self.one] - things[self.two])

    def size(self, things: Things, ar: Arithmetic) -> Real:
        return abs(things[self.one]) + abs(things[self.two]) + sum(abs(t.value(things, ar)) for t in self.terms)

    def numbers(self, things: Things, gap: Real, size: Real) -> dict[str, object]:
        return {"about": self.about, "found": float(things[self.one]), "check": float(things[self.two])}


@dataclass(frozen=True)
class VectorProof(Proof):
    """Every vector of an equation is as long as stated, and points where stated: rows of (start, end, direction,
    signed length's sign, length), either "" where it is not stated."""

    rows: tuple[VectorRow, ...]
    reason: ClassVar[str] = "polygon_open"

    def gap(self, things: Things, ar: Arithmetic) -> Real:
        mu = things[mu_of(self.plan)]
        return sum(self._open((things[row[1]] - things[row[0]]) / mu, row, things, ar) for row in self.rows)

    @staticmethod
    def _open(vector: Complex, row: VectorRow, things: Things, ar: Arithmetic) -> Real:
        _, _, along, sign, length = row
        if length and along:
            return ar.size(vector - sign * things[length] * things[along])
        return abs(plane.cross(things[along], vector)) if along else abs(abs(vector) - abs(things[length]))

    def size(self, things: Things, ar: Arithmetic) -> Real:
        stated = sum(abs(things[length]) for length in {row[4] for row in self.rows if row[4]})
        return stated + sum(ar.size(in_si(things, mark)) for mark in {mark for row in self.rows for mark in row[:2]})


def in_si(things: Things, mark: str) -> Complex:
    """What a mark shows, in SI."""
    mu = things[_scale(mark)]
    return things[mark] if isinstance(mu, float) and mu == 1.0 else things[mark] / mu  # many are drawn in SI


@lru_cache(4096)
def _scale(mark: str) -> str:
    return mu_of(plan_of(mark))


def gaps(proofs: Sequence[Proof], things: Things, ar: Arithmetic) -> Iterator[tuple[Proof, Real, Real]]:
    """Of every proof, how far apart its sides are, and beside what size (a gap that is not small beside it is looked at
    again): of what they are made of, and of what drives their plan."""
    speeds = {
        marks: sum(ar.size(in_si(things, mark)) for mark in marks if mark in things)
        for marks in {proof.beside for proof in proofs}
    }
    return ((proof, proof.gap(things, ar), proof.size(things, ar) + speeds[proof.beside]) for proof in proofs)
