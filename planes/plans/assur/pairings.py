"""A group of class III and order 4: two basic links hinged to each other, on two leads each.

With one lead taken off, what is left moves as a four-bar and a dyad on it do; where its hinge then cuts the line of
that lead it assembles.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import ClassVar

from planes.plans.assur.basic_links import Lead
from planes.plans.assur.groups import Pair
from planes.words import Phrase
from planes.words.records import Json


@dataclass(frozen=True)
class Pairing:
    """Two ``basics``, their ``hinge`` (a pair of the second on the first), and the two leads of each."""

    links: tuple[str, ...]
    basics: tuple[str, str]
    hinge: Pair
    sides: tuple[tuple[Lead, Lead], tuple[Lead, Lead]]
    level: ClassVar[str] = "III"

    @property
    def basic(self) -> str:
        """The first of its basic links, by which it is called."""
        return self.basics[0]

    @property
    def leads(self) -> tuple[Lead, ...]:
        """All its leads."""
        return *self.sides[0], *self.sides[1]

    @property
    def joint(self) -> Lead:
        """What one basic link is to the other: a lead, from the special point of that to their hinge."""
        return Lead(self.basics[0], self.hinge, self.hinge)

    def led(self, last: Lead) -> int:
        """Which basic link the other one leads, so that the ``last`` of all is found by the special point of that."""
        return int(last in self.sides[1])

    @property
    def whole(self) -> tuple[str, ...]:
        """All its links."""
        return self.links

    def side(self, k: int) -> tuple[str, ...]:
        """One basic link with its leads, in the order of the file."""
        own = self.basics[k], *(lead.link for lead in self.sides[k])
        return tuple(link for link in self.links if link in own)

    @property
    def balances(self) -> tuple[tuple[str, ...], ...]:
        """The links of each plan of forces, which is called by them."""
        return self.side(0), self.side(1)

    @property
    def members(self) -> str:
        """Its links as a formula of structure has them."""
        return ";".join(self.links)

    @property
    def ends(self) -> tuple[str, ...]:
        """The links that may be what the mechanism drives, the likeliest first."""
        return tuple(lead.link for lead in reversed(self.leads))

    @property
    def solved(self) -> tuple[str, ...]:
        """Its links in the order of solving."""
        return *self.basics, *(lead.link for lead in self.leads)

    def reached(self, drive: Pair) -> tuple[str, ...]:
        """The links that are solved with it where the drive is inside."""
        return drive.link, drive.other, *(x for x in self.solved if not drive.joins(x))

    @property
    def pairs(self) -> tuple[Pair, ...]:
        """Its pairs: of every lead the outer, then the inner one; the hinge of the basic links last."""
        return *(p for lead in self.leads for p in (lead.outer, lead.inner)), self.hinge

    @property
    def inner_pairs(self) -> tuple[Pair, ...]:
        """The pairs between its own links."""
        return *(lead.inner for lead in self.leads), self.hinge

    @property
    def name(self) -> str:
        """The letters of its leads by basic links, e.g. "RR-RR+RR-PR"."""
        return "+".join("-".join(lead.name for lead in side) for side in self.sides)

    @property
    def said(self) -> Phrase:
        """Its class, order, basic links and leads in words."""
        leads = tuple(lead.link for lead in self.leads)
        return Phrase("class_three_two", basics=self.basics, hinge=self.hinge.point, leads=leads, name=self.name)

    @property
    def brief(self) -> Phrase:
        """The same without letters."""
        return Phrase("class_three_two_brief")

    def json(self) -> Json:
        """The group as the JSON has it."""
        leads = [[lead.link for lead in side] for side in self.sides]
        own = {"class": 3, "order": 4, "basic": list(self.basics), "leads": leads}
        return {"links": list(self.links), **own, "name": self.name}


def pairing_of(
    names: Sequence[str], between: Callable[[str, str], Sequence[Pair]], outer: dict[str, list[Pair]]
) -> Pairing | None:
    """Six links as two basic ones on two leads each, if they are that."""
    basics = [n for n in names if not outer[n]]
    if len(names) != 6 or len(basics) != 2:
        return None
    hinges = between(basics[1], basics[0])
    sides: list[list[Lead]] = [[], []]
    for lead in (n for n in names if n not in basics):
        held = [(k, pair) for k, basic in enumerate(basics) for pair in between(lead, basic)]
        if len(held) == 1 == len(outer[lead]):
            sides[held[0][0]].append(Lead(lead, held[0][1], outer[lead][0]))
    if [len(side) for side in sides] != [2, 2] or len(hinges) != 1 or hinges[0].kind == "P":
        return None
    if any(lead.name == "PP" for side in sides for lead in side):
        return None
    one, two = ((side[0], side[1]) for side in sides)
    return Pairing(tuple(names), (basics[0], basics[1]), hinges[0], (one, two))
