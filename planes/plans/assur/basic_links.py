"""A basic link with its leads: the Assur groups of class III.

Sources: L. V. Assur's groups and their classes by I. I. Artobolevsky; a group of class III and order 3 is the basic
link on three leads (поводки), each attached to a solved link.
"""

from collections.abc import Iterable
from typing import Any

from planes.plans.assur.groups import Group, Pair
from planes.words import Phrase
from planes.words.frozen import frozen
from planes.words.names import NameTuple
from planes.words.records import Json


@frozen
class Lead:
    """A lead (поводок) of a basic link: its ``inner`` pair is with the basic link, its ``outer`` one with a solved
    link; with a ``drive`` inside it consists of two links, and ``link`` has the outer pair."""

    link: str
    inner: Pair
    outer: Pair
    drive: Pair | None = None

    @property
    def lead_links(self) -> NameTuple:
        """The links it consists of."""
        if self.drive:
            return (self.link, self.drive.other_link_of_pair(self.link))
        return (self.link,)

    def as_inner_driven_dyad(self, basic: str) -> Group:
        """The lead and the basic link as a dyad driven from inside."""
        return Group((self.link, basic), 1, self.link, basic, self.inner, self.outer, self.outer, self.drive)

    @property
    def pair_letters(self) -> str:
        """The letters of its pairs, the outer one first: "RR", "PR", "RP"."""
        return self.outer.kind + self.inner.kind


Leads = tuple[Lead, ...]


def pairs_of_leads(leads: Iterable[Lead]) -> tuple[Pair, ...]:
    """The pairs of leads: the outer, then the inner one of each."""
    return tuple(p for lead in leads for p in (lead.outer, lead.inner))


class SolvedByLeads:
    """The common part of groups of ``basics``, basic links, on ``leads``."""

    @property
    def output_link_candidates(self: Any) -> NameTuple:
        """The links that may be the output of the mechanism, the likeliest first."""
        return tuple(lead.link for lead in reversed(self.leads))

    @property
    def links_in_solving_order(self: Any) -> NameTuple:
        """Its links in the order of solving."""
        return *(x for x in self.links if x in self.basics), *(lead.link for lead in self.leads)

    def reached(self: Any, drive: Pair) -> NameTuple:
        """The links solved together with it where the drive is inside."""
        return drive.link, drive.other, *(x for x in self.links_in_solving_order if not drive.has_link(x))


class OnLeads(SolvedByLeads):
    """The common part of groups of one ``basic`` link on leads; each lead may have a drive inside."""

    links: NameTuple
    basic: str
    leads: Leads
    order: NameTuple

    @property
    def all_links(self) -> NameTuple:
        """All its links, including both links of a drive inside."""
        return self.order or self.links

    @property
    def balanced_links(self) -> NameTuple:
        """The links whose forces are on its plan; they name the plan."""
        return self.all_links

    @property
    def basics(self) -> NameTuple:
        """Its basic links."""
        return (self.basic,)

    @property
    def links_by_force_plan(self) -> tuple[NameTuple, ...]:
        """The links of each force plan, which name it."""
        return (self.balanced_links,)

    @property
    def formula_members(self) -> str:
        """Its links as in a structural formula."""
        mates = {lead.link: lead.lead_links for lead in self.leads}
        return ";".join("-".join(sorted(mates.get(link, (link,)), key=self.all_links.index)) for link in self.links)


@frozen
class Triad(OnLeads):
    """An Assur group of class III and order 3: the ``basic`` link and its three leads, all in the order of the file."""

    links: NameTuple
    basic: str
    leads: tuple[Lead, Lead, Lead]
    order: NameTuple = ()  # with a drive inside: all its links in the order of the file
    level = "III"

    @property
    def is_on_slides(self) -> bool:
        """Whether a lead slides at both ends, so that the basic link turns with the outer guide of that lead."""
        return any(lead.pair_letters == "PP" for lead in self.leads)

    @property
    def leads_sliding_last(self) -> tuple[Lead, Lead, Lead]:
        """Its leads, with the one that slides at both ends last."""
        one, two, three = sorted(self.leads, key=lambda lead: lead.pair_letters == "PP")
        return one, two, three

    @property
    def kind(self) -> int:
        """Where a lead slides at both ends: the kind of the dyad by which the others position the basic link."""
        return dyad_kind_of_leads(self.leads)

    @property
    def pairs(self) -> tuple[Pair, ...]:
        """Its pairs: for every lead the outer, then the inner one."""
        return pairs_of_leads(self.leads)

    @property
    def inner_pairs(self) -> tuple[Pair, ...]:
        """The pairs between its own links."""
        return tuple(lead.inner for lead in self.leads)

    @property
    def pair_letters(self) -> str:
        """The letters of its leads, e.g. "RR-RR-PR"."""
        return "-".join(lead.pair_letters for lead in self.leads)

    @property
    def group_description(self) -> Phrase:
        """Its class, order, basic link and leads in words."""
        leads = tuple(lead.link for lead in self.leads)
        return Phrase("class_three", basic=self.basic, leads=leads, name=self.pair_letters)

    @property
    def short_group_description(self) -> Phrase:
        """The same without letters."""
        return Phrase("class_three_brief")

    def json(self) -> Json:
        """The group as in the JSON output."""
        leads = [lead.link for lead in self.leads]
        own = {"class": 3, "order": 3, "basic": self.basic, "leads": leads}
        return {"links": list(self.links), **own, "name": self.pair_letters}


def dyad_kind_of_leads(leads: Iterable[Lead]) -> int:
    """The kind of the dyad that positions a point as these leads do."""
    return {2: 1, 1: 2, 0: 4}[sum(lead.pair_letters == "RR" for lead in leads)]
