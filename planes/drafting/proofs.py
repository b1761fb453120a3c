"""Conditions on every drawing: checks of its numbers that share no construction with the steps. Those of links are in
``link_proofs``.

A proof compares the drawing with a definition (a rigid link, a sliding pair, a link in equilibrium, a polygon with the
stated vectors) or with a second way to the same number (the balancing load from the force plan and from the lever).
"""

from collections.abc import Callable, Iterator
from functools import cached_property
from typing import Any, ClassVar, TypeVar

from planes.drafting.steps.reckoning import Product
from planes.drafting.tools import AskedFor, Thing, Things
from planes.geometry import plane
from planes.geometry.arithmetic import Arithmetic, Point, Real
from planes.words.frozen import field, frozen
from planes.words.names import Mark, MarkTuple, NameTuple, PlanId

Made = TypeVar("Made")
MOST_AGREEMENT_GAP_RATIO = 1e-9  # relative: within this, two ways to a number agree
VectorRow = tuple[Mark, Mark, str, int, str]  # its start and end, its direction, its sign, its length


@frozen
class Facts:
    """The data of a drawing, as proofs read them: whatever several of them need is computed once."""

    things: Things
    ar: Arithmetic
    known: dict[NameTuple, Any] = field(default_factory=dict)

    def __getitem__(self, name: str) -> Thing:
        return self.things[name]

    def computed_once(self, key: NameTuple, make: Callable[[], Made]) -> Made:
        """A result computed on first request."""
        if key not in self.known:
            self.known[key] = make()
        return self.known[key]  # type: ignore[no-any-return]

    def mark(self, name: Mark) -> Point:
        """The quantity of a mark, in SI."""
        return self.things[name] / self.things[name.plan.mu_name]

    def mark_magnitude(self, mark: Mark) -> Real:
        """Its magnitude."""
        return self.computed_once((mark, "size"), lambda: self.ar.size(self.mark(mark)))

    def vector_between_marks(self, start: Mark, end: Mark) -> Point:
        """The vector from one mark to another, in SI."""
        return self.computed_once((start, end, "vector"), lambda: self.mark(end) - self.mark(start))

    def vector_along_direction(self, length: str, direction: str) -> Point:
        """A vector of a given length along a direction."""
        return self.computed_once((length, direction, "along"), lambda: self.things[length] * self.things[direction])


@frozen
class Proof:
    """A condition that must hold, on ``plan``; ``about`` names its subject."""

    plan: PlanId
    about: str
    beside: MarkTuple = field(default=(), kw_only=True)  # the marks that drive its plan: the scale of speeds
    reason: ClassVar[str]
    makes: ClassVar[str] = ""  # a position that fails it gives no results at all

    @cached_property
    def names_read(self) -> frozenset[str]:
        """Names of the program it reads."""
        asked = AskedFor()
        self.gap_and_comparison_size(Facts(asked, Arithmetic()))
        return frozenset(asked)

    def residuals(self, shown: Facts) -> list[Point]:
        """The residuals, which must be zero: vectors or numbers, in SI."""
        raise NotImplementedError

    def term_magnitudes(self, shown: Facts) -> Iterator[Real]:
        """The magnitudes of their terms, in SI."""
        raise NotImplementedError

    def gap_and_comparison_size(self, shown: Facts) -> tuple[Real, Real]:
        """The gap, and the magnitude it must be small beside: a larger gap is examined again."""
        moving = sum(shown.mark_magnitude(mark) for mark in self.beside if mark in shown.things)
        return sum(map(shown.ar.size, self.residuals(shown))), sum(self.term_magnitudes(shown)) + moving

    def numbers_for_failure(self, things: Things, gap: Real, size: Real) -> dict[str, object]:
        """The numbers for the sentence about its failure."""
        return {"about": self.about, "gap": float(gap), "size": float(size)}


@frozen
class Twofold(Proof):
    """The balancing load by the force plans (``one``) and by the lever (``two``); it is also the balance of powers."""

    one: str
    two: str
    terms: tuple[Product, ...]
    reason = "balance_apart"

    def residuals(self, shown: Facts) -> list[Point]:
        return [shown[self.one] - shown[self.two]]

    def term_magnitudes(self, shown: Facts) -> Iterator[Real]:
        yield from (abs(shown[name]) for name in (self.one, self.two))
        yield from (abs(term.product_value(shown.things, shown.ar)) for term in self.terms)

    def numbers_for_failure(self, things: Things, gap: Real, size: Real) -> dict[str, object]:
        return {"about": self.about, "found": float(things[self.one]), "check": float(things[self.two])}


@frozen
class VectorProof(Proof):
    """Every vector of an equation has its stated length and direction: rows of (start, end, direction, signed length's
    sign, length), with "" for an unstated one."""

    rows: tuple[VectorRow, ...]
    reason = "polygon_open"

    def residuals(self, shown: Facts) -> list[Point]:
        return [self._closing_gap(row, shown) for row in self.rows]

    @staticmethod
    def _closing_gap(row: VectorRow, shown: Facts) -> Point:
        start, end, along, sign, length = row
        vector = shown.vector_between_marks(start, end)
        if length and along:
            stated = shown.vector_along_direction(length, along)
            return vector - stated if sign > 0 else vector + stated
        if along:
            return plane.cross(shown[along], vector)
        stated = abs(shown[length])  # half the difference of the lengths is small beside them, and needs no square root
        return (plane.dot(vector, vector) - stated * stated) / (stated + (stated == 0))

    def term_magnitudes(self, shown: Facts) -> Iterator[Real]:
        yield from map(shown.mark_magnitude, dict.fromkeys(mark for row in self.rows for mark in row[1::-1]))
        yield from (abs(shown[length]) for length in dict.fromkeys(row[4] for row in self.rows if row[4]))
