"""What must hold of every drawing: checks of its numbers that share no construction with the steps that made them.
Those of links are in ``link_proofs``.

A proof compares what was drawn with a definition (a rigid link, a sliding pair, a link in equilibrium, a polygon whose
vectors are what was stated) or with another way to the same number (the force plan's balancing load and the lever's).
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, lru_cache, partial
from typing import Any, ClassVar, TypeVar

from planes.drafting.steps.reckoning import Product
from planes.drafting.tools import AskedFor, Thing
from planes.geometry import plane
from planes.geometry.arithmetic import Arithmetic, Real
from planes.geometry.arithmetic import Point as Complex
from planes.words.names import mu_of, plan_of

Made = TypeVar("Made")
TOLD_APART = 1e-9  # relative: nearer than this, two ways to a number agree
VectorRow = tuple[str, str, str, int, str]  # where it starts and ends, its direction, its sign, its length


class Facts:
    """What a drawing shows, as proofs read it: whatever several of them need is worked out once."""

    def __init__(self, things: Mapping[str, Thing], ar: Arithmetic) -> None:
        self.things, self.ar = things, ar
        self.known: dict[tuple[str, ...], Any] = {}

    def __getitem__(self, name: str) -> Thing:
        return self.things[name]

    def once(self, key: tuple[str, ...], make: Callable[[], Made]) -> Made:
        """What is made the first time it is asked for."""
        if key not in self.known:
            self.known[key] = make()
        return self.known[key]  # type: ignore[no-any-return]

    def mark(self, name: str) -> Complex:
        """What a mark shows, in SI."""
        return self.once((name,), lambda: in_si(self.things, name))

    def size(self, mark: str) -> Real:
        """How large that is."""
        return self.once((mark, "size"), lambda: self.ar.size(self.mark(mark)))


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
        self.compared(Facts(asked, Arithmetic()))
        return frozenset(asked)

    def compared(self, shown: Facts) -> tuple[Real, Real]:
        """The gap, and the size it is small beside."""
        return self.gap(shown), self.size(shown)

    def gap(self, shown: Facts) -> Real:
        """How far the two sides are apart, in SI."""
        raise NotImplementedError

    def size(self, shown: Facts) -> Real:
        """How large what they are made of is at least, in SI, but for the speed of their plan."""
        raise NotImplementedError

    def numbers(self, things: Mapping[str, Thing], gap: Real, size: Real) -> dict[str, object]:
        """What a sentence says of its failure."""
        return {"about": self.about, "gap": float(gap), "size": float(size)}


@dataclass(frozen=True)
class Twofold(Proof):
    """The balancing load by the force plans (``one``) and by the lever (``two``): also the balance of powers."""

    one: str
    two: str
    terms: tuple[Product, ...]
    reason: ClassVar[str] = "balance_apart"

    def gap(self, shown: Facts) -> Real:
        return abs(shown[self.one] - shown[self.two])

    def size(self, shown: Facts) -> Real:
        terms = sum(abs(term.value(shown.things, shown.ar)) for term in self.terms)
        return abs(shown[self.one]) + abs(shown[self.two]) + terms

    def numbers(self, things: Mapping[str, Thing], gap: Real, size: Real) -> dict[str, object]:
        return {"about": self.about, "found": float(things[self.one]), "check": float(things[self.two])}


@dataclass(frozen=True)
class VectorProof(Proof):
    """Every vector of an equation is as long as stated, and points where stated: rows of (start, end, direction,
    signed length's sign, length), either "" where it is not stated."""

    rows: tuple[VectorRow, ...]
    reason: ClassVar[str] = "polygon_open"

    def gap(self, shown: Facts) -> Real:
        return sum(self._open(shown.mark(row[1]) - shown.mark(row[0]), row, shown) for row in self.rows)

    @staticmethod
    def _open(vector: Complex, row: VectorRow, shown: Facts) -> Real:
        _, _, along, sign, length = row
        if length and along:
            return shown.ar.size(vector - sign * shown[length] * shown[along])
        return abs(plane.cross(shown[along], vector)) if along else abs(abs(vector) - abs(shown[length]))

    def size(self, shown: Facts) -> Real:
        stated = sum(abs(shown[length]) for length in {row[4] for row in self.rows if row[4]})
        return stated + sum(map(shown.size, {mark for row in self.rows for mark in row[:2]}))


def in_si(things: Mapping[str, Thing], mark: str) -> Complex:
    """What a mark shows, in SI."""
    mu = things[_scale(mark)]
    return things[mark] if isinstance(mu, float) and mu == 1.0 else things[mark] / mu  # many are drawn in SI


@lru_cache(4096)
def _scale(mark: str) -> str:
    return mu_of(plan_of(mark))


def gaps(proofs: Sequence[Proof], things: Mapping[str, Thing], ar: Arithmetic) -> Iterator[tuple[Proof, Real, Real]]:
    """Of every proof, how far apart its sides are, and beside what size (a gap that is not small beside it is looked at
    again): of what they are made of, and of what drives their plan."""
    shown = Facts(things, ar)
    for proof in proofs:
        gap, size = proof.compared(shown)
        yield proof, gap, size + shown.once(("beside", *proof.beside), partial(_driving, proof.beside, shown))


def _driving(marks: Sequence[str], shown: Facts) -> Real:
    return sum(shown.size(mark) for mark in marks if mark in shown.things)
