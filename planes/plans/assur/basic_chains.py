"""A group of class III whose basic links, each with three pairs, are joined by hinges in a chain or a tree: two are of
order 4 and have two leads each, n are of order n + 2.

With one lead removed, the rest has one freedom; the group assembles where its hinge then crosses the line of that lead.
Two leads of a basic link at an end of the chain turn it into a lead of the next one, from its special point.
"""

from collections.abc import Sequence

from planes.plans.assur.basic_links import Lead, Leads, SolvedByLeads, pairs_of_leads
from planes.plans.assur.groups import Between, Pair
from planes.words import Phrase
from planes.words.frozen import frozen
from planes.words.names import NamePair, NameTuple
from planes.words.records import Json


@frozen
class BasicChain(SolvedByLeads):
    """The ``basics``, each but the first with a hinge on an earlier one (``hinges``), and the leads of each."""

    links: NameTuple
    basics: NameTuple
    hinges: tuple[Pair, ...]
    sides: tuple[Leads, ...]
    level = "III"

    @property
    def basic(self) -> str:
        """The first of its basic links, which names the group."""
        return self.basics[0]

    @property
    def order(self) -> int:
        """The order: the number of leads."""
        return len(self.leads)

    @property
    def leads(self) -> Leads:
        """All its leads."""
        return tuple(lead for side in self.sides for lead in side)

    @property
    def joining_leads(self) -> Leads:
        """The links between basic links: leads, from the special point of one to the common hinge."""
        return tuple(
            Lead(self.basics[k], h, h) for h, (k, _) in zip(self.hinges, self.basic_links_at_hinges, strict=True)
        )

    @property
    def basic_links_at_hinges(self) -> tuple[tuple[int, int], ...]:
        """The two basic links at each hinge, the earlier one first."""
        ends = (sorted(map(self.basics.index, (h.link, h.other))) for h in self.hinges)
        return tuple((one, two) for one, two in ends)

    def root_basic_link(self, last: Lead) -> int:
        """The basic link to which all others lead, chosen so that the ``last`` lead, or joint, is found last."""
        own = (k for k, side in enumerate(self.sides) if last in side)
        return next(own, self.basics.index(last.link) if last in self.joining_leads else 0)

    @property
    def all_links(self) -> NameTuple:
        """All its links."""
        return self.links

    def basic_link_with_leads(self, k: int) -> NameTuple:
        """One basic link with its leads, in the order of the file."""
        own = self.basics[k], *(lead.link for lead in self.sides[k])
        return tuple(link for link in self.links if link in own)

    @property
    def links_by_force_plan(self) -> tuple[NameTuple, ...]:
        """The links of each force plan, which name it."""
        return tuple(map(self.basic_link_with_leads, range(len(self.basics))))

    @property
    def formula_members(self) -> str:
        """Its links as in a structural formula."""
        return ";".join(self.links)

    @property
    def pairs(self) -> tuple[Pair, ...]:
        """Its pairs: for every lead the outer, then the inner one; the hinges of the basic links last."""
        return pairs_of_leads(self.leads) + self.hinges

    @property
    def inner_pairs(self) -> tuple[Pair, ...]:
        """The pairs between its own links."""
        return *(lead.inner for lead in self.leads), *self.hinges

    @property
    def pair_letters(self) -> str:
        """The letters of its leads by basic links, e.g. "RR-RR+RR-PR"."""
        return "+".join("-".join(lead.pair_letters for lead in side) for side in self.sides if side)

    @property
    def group_description(self) -> Phrase:
        """Its class, order, basic links and leads in words."""
        details = {"hinges": tuple(h.point for h in self.hinges), "leads": tuple(lead.link for lead in self.leads)}
        return Phrase("class_three_chain", order=self.order, basics=self.basics, name=self.pair_letters, **details)

    @property
    def short_group_description(self) -> Phrase:
        """The same without letters."""
        return Phrase("class_three_chain_brief", order=self.order)

    def json(self) -> Json:
        """The group as in the JSON output."""
        leads = [[lead.link for lead in side] for side in self.sides]
        own = {"class": 3, "order": self.order, "basic": list(self.basics), "leads": leads}
        return {"links": list(self.links), **own, "name": self.pair_letters}


def chain_of_basic_links(names: Sequence[str], between: Between, outer: dict[str, list[Pair]]) -> BasicChain | None:
    """The links as a chain of basic ones, each with three pairs, if they form one."""
    left = [n for n in names if not outer[n]]
    if len(left) < 2 or len(names) != 2 * len(left) + 2:
        return None
    basics = [left.pop(0)]
    hinges = []
    while left:
        ways = [
            (n, pairs[0]) for n in left for x in basics if len(pairs := between(*_later_link_first(names, n, x))) == 1
        ]
        if not ways or len([n for n, _ in ways if n == ways[0][0]]) > 1 or ways[0][1].kind == "P":
            return None
        basics.append(ways[0][0])
        hinges.append(ways[0][1])
        left.remove(ways[0][0])
    sides: list[list[Lead]] = [[] for _ in basics]
    for lead in (n for n in names if n not in basics):
        held = [(k, pair) for k, basic in enumerate(basics) for pair in between(lead, basic)]
        if len(held) == 1 == len(outer[lead]):
            sides[held[0][0]].append(Lead(lead, held[0][1], outer[lead][0]))
    joined = [sum(h.has_link(basic) for h in hinges) for basic in basics]
    if any(len(side) + count != 3 for side, count in zip(sides, joined, strict=True)):
        return None
    if any(lead.pair_letters == "PP" for side in sides for lead in side):
        return None
    return BasicChain(tuple(names), tuple(basics), tuple(hinges), tuple(map(tuple, sides)))


def _later_link_first(names: Sequence[str], one: str, two: str) -> NamePair:
    return (one, two) if names.index(one) > names.index(two) else (two, one)
