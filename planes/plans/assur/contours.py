"""A group of class IV: a closed contour of four links, two of which are attached to solved links.

Source: I. I. Artobolevsky's classes of Assur's groups; the class is the number of links in the closed contour, and the
order the number of outer pairs. One of the two attached links has a hinge outside: it is the ``base``, and the
``basic`` link is found from it as a basic link of class III is from solved links.
"""

from collections.abc import Sequence

from planes.plans.assur.basic_chains import BasicChain
from planes.plans.assur.basic_links import Lead, OnLeads, Triad, dyad_kind_of_leads, pairs_of_leads
from planes.plans.assur.groups import Between, Group, Pair
from planes.words import Phrase
from planes.words.frozen import frozen
from planes.words.names import NameTuple
from planes.words.records import Json


@frozen
class Contour(OnLeads):
    """An Assur group of class IV and order 2: ``base`` and ``basic`` on their outer pairs, the base on a hinge, and the
    two links between them, as leads from the base to the basic link."""

    links: NameTuple
    base: str
    basic: str
    outer: tuple[Pair, Pair]  # of the base and of the basic link
    leads: tuple[Lead, Lead]
    order: NameTuple = ()  # with a drive inside: all its links in the order of the file
    level = "IV"

    @property
    def is_on_slides(self) -> bool:
        """Whether both outer pairs are guides."""
        return all(pair.kind == "P" for pair in self.outer)

    @property
    def kind(self) -> int:
        """Where both outer pairs are guides: the kind of the dyad by which its leads position the basic link from the
        base."""
        return dyad_kind_of_leads(self.leads)

    @property
    def links_around_contour(self) -> tuple[str, str, str, str]:
        """Its links in the order of the closed contour."""
        one, two = self.leads
        return self.base, one.link, self.basic, two.link

    @property
    def output_link_candidates(self) -> NameTuple:
        """The links that may be the output of the mechanism, the likeliest first."""
        return self.basic, self.base

    @property
    def links_in_solving_order(self) -> NameTuple:
        """Its links in the order of solving."""
        return self.base, *super().links_in_solving_order

    @property
    def pairs(self) -> tuple[Pair, ...]:
        """Its pairs: the outer ones, then both of each rod."""
        return self.outer + self.inner_pairs

    @property
    def inner_pairs(self) -> tuple[Pair, ...]:
        """The pairs between its own links."""
        return pairs_of_leads(self.leads)

    @property
    def pair_letters(self) -> str:
        """The letters of its pairs: the outer ones, then those of the contour."""
        return "-".join(("".join(p.kind for p in self.outer), "".join(p.kind for p in self.inner_pairs)))

    @property
    def group_description(self) -> Phrase:
        """Its class, order and contour in words."""
        outer = tuple(p.point or p.guide for p in self.outer)
        return Phrase("class_four", contour=self.links_around_contour, outer=outer, name=self.pair_letters)

    @property
    def short_group_description(self) -> Phrase:
        """The same without letters."""
        return Phrase("class_four_brief")

    def json(self) -> Json:
        """The group as in the JSON output."""
        own = {"class": 4, "order": 2, "contour": list(self.links_around_contour), "outer": [self.base, self.basic]}
        return {"links": list(self.links), **own, "name": self.pair_letters}


Tracked = Triad | Contour | BasicChain
"""A group whose basic link is found by the method of tracks."""
AnyGroup = Group | Tracked


def triad_of_links(names: Sequence[str], between: Between, outer: dict[str, list[Pair]]) -> Triad | None:
    """Four links as a basic link on three leads, if they form one."""
    for basic in (n for n in names if not outer[n]):
        held = [(n, between(n, basic), outer[n]) for n in names if n != basic]
        leads = [Lead(n, inner[0], own[0]) for n, inner, own in held if len(inner) == 1 == len(own)]
        if len(leads) == 3:
            return Triad(tuple(names), basic, (leads[0], leads[1], leads[2]))
    return None


def contour_group_of_links(names: Sequence[str], between: Between, outer: dict[str, list[Pair]]) -> Contour | None:
    """Four links as a closed contour, if they form one that can be drawn."""
    hung = [n for n in names if len(outer[n]) == 1]
    rods = [n for n in names if not outer[n]]
    if len(hung) != 2 or len(rods) != 2 or between(*hung) or between(*rods):
        return None
    base, basic = sorted(hung, key=lambda link: outer[link][0].kind == "P")
    leads = []
    for rod in rods:
        one = between(rod, base)
        two = between(rod, basic)
        if len(one) == len(two) == 1:
            leads.append(Lead(rod, two[0], one[0]))
    if len(leads) < 2:
        return None
    return Contour(tuple(names), base, basic, (outer[base][0], outer[basic][0]), (leads[0], leads[1]))
