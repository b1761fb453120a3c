"""Planar vector equations: terms with known and unknown parts, the chain check, and the four kinds.

The state of a term is shown by the textbook's underlines: two for a vector known in length and direction, one for a
vector with one of the two known (Chace, 1963; the underline convention of Bauman).
"""

from itertools import pairwise
from typing import Literal

from planes.drafting.steps.reckoning import Product
from planes.words import Phrase
from planes.words.errors import EquationError
from planes.words.frozen import field, frozen
from planes.words.names import Meaning, NamePair, NameTuple, PlanId

EquationKind = Literal["close", "cross", "arc", "arcs"]


@frozen
class Term:
    """One vector of an equation, from mark ``start`` to mark ``end`` of its plan.

    ``length`` and ``direction`` name a value and a direction of the program, or are None where unknown. ``action`` is
    the line of action as written beneath: "⊥BC", "∥y-y", "C→B", "=0", "∠⊥y-y" at an angle to that (friction). ``drawn``
    terms are already on the plan.
    """

    name: str
    start: str
    end: str
    length: str | None = None
    direction: str | None = None
    action: str = ""
    drawn: bool = False
    sign: int = 1
    means: Meaning | None = field(default=None, compare=False, repr=False)  # the meaning of the mark at its end

    @property
    def known_part_count(self) -> int:
        """How many of length and direction are known: the number of underlines."""
        if self.drawn:
            return 2
        return (self.length is not None) + (self.direction is not None)

    @property
    def end_marks(self) -> NamePair:
        """The start and end marks of its vector; reversed in a difference."""
        if self.sign > 0:
            return (self.start, self.end)
        return (self.end, self.start)


SignedTerm = tuple[int, Term]
Chain = tuple[Term, ...]


@frozen
class Equation:
    """Two chains of vectors on one plan with the same start and end, and exactly two unknowns between them.

    ``total`` names the sum of either chain ("v_C"); without it the chains form a closed polygon. ``side`` names the
    given ±1 that selects one of two crossings of arcs.
    """

    plan: PlanId
    chains: tuple[Chain, Chain]
    total: str | None = None
    side: str | None = None

    def __post_init__(self) -> None:
        for before, after in (joint for chain in self.chains for joint in pairwise(chain)):
            if before.end != after.start:
                joined = {"start": after.start, "reached": before.end}
                raise EquationError(Phrase("chain_broken", text=self.equation_text, name=after.name, **joined))
        one, two = self.chains
        if one and two and (one[0].start, one[-1].end) != (two[0].start, two[-1].end):
            ends = {"start": one[0].start, "end": one[-1].end}
            ends |= {"other_start": two[0].start, "other_end": two[-1].end}
            raise EquationError(Phrase("sides_apart", text=self.equation_text, **ends))
        if len(self.unknown_parts) != 2:
            listed = tuple(unknown_in_words(name, part) for name, part in self.unknown_parts) or Phrase("none")
            why = Phrase("unknowns_count", text=self.equation_text, count=len(self.unknown_parts), listed=listed)
            raise EquationError(why)

    @property
    def all_terms(self) -> Chain:
        """All terms, those of the first chain first."""
        return self.chains[0] + self.chains[1]

    @property
    def unknown_parts(self) -> tuple[NamePair, ...]:
        """Pairs (name of the vector, "length" or "direction"), in the order of the terms."""
        unknowns = []
        for term in self.all_terms:
            if not term.drawn:
                unknowns += [(term.name, "length")] * (term.length is None)
                unknowns += [(term.name, "direction")] * (term.direction is None)
        if self.total and not self.chains[1]:
            unknowns += [(self.total, "length"), (self.total, "direction")]
        return tuple(unknowns)

    @property
    def construction_kind(self) -> EquationKind:
        """The construction that solves it: close the polygon, cross two lines, a line and an arc, or two arcs."""
        (name, part), (other, other_part) = self.unknown_parts
        if name == other:
            return "close"
        if part == other_part:
            return "cross" if part == "length" else "arcs"
        return "arc"

    @property
    def is_closed_polygon(self) -> bool:
        """Whether it is written as a closed polygon: the sum of all vectors is zero."""
        return not self.total and all(t.sign < 0 for t in self.chains[1])

    @property
    def sides_as_written(self) -> tuple[tuple[SignedTerm, ...], ...]:
        """The sides as written, each term with its sign; a closed polygon has one side."""
        one, two = self.chains
        if self.is_closed_polygon:
            return (tuple((t.sign, t) for t in one) + tuple((-t.sign, t) for t in two),)
        return tuple(tuple((t.sign, t) for t in chain) for chain in self.chains)

    @property
    def equation_text(self) -> str:
        """The equation as a line of text."""
        sides = [_side_text(side) for side in self.sides_as_written if side]
        return " = ".join([self.total, *sides] if self.total else [*sides, "0"] if self.is_closed_polygon else sides)


def _side_text(side: tuple[SignedTerm, ...]) -> str:
    """A side as text."""
    text = "".join(f" {'+' if sign > 0 else '−'} {t.name}" for sign, t in side)
    return text.removeprefix(" + ").strip()


def unknown_in_words(name: str, part: str) -> Phrase:
    """An unknown in words: "length of v_C"."""
    return Phrase("unknown_length" if part == "length" else "unknown_direction", name=name)


@frozen
class Moments:
    """A moment equation about a point: signed terms (force, arm) or (couple, "") whose sum with the unknown is zero.

    ``unknown`` is the value to solve for and ``arm`` the name of its arm ("" for a couple); ``links`` are the links in
    equilibrium.
    """

    about: str
    links: NameTuple
    terms: tuple[NamePair, ...]
    unknown: str
    arm: str


MomentTerms = list[tuple[str, str, Product]]  # a force or a couple, its arm, and their product
