"""Kinematic pairs and the groups of Assur they make: class II of five kinds, class III of a basic link with leads.

Sources: L. V. Assur's groups and their classes by I. I. Artobolevsky; a group of class III and order 3 is the basic
link on three drivers (поводки), each of which hangs on a link that is solved.
"""

from dataclasses import dataclass
from typing import ClassVar, Literal

from planes.words import Phrase
from planes.words.records import Json

KIND_NAMES = ("RRR", "RRP", "RPR", "PRP", "RPP")


@dataclass(frozen=True)
class Pair:
    """A kinematic pair of ``link`` with the earlier solved ``other``; in a sliding pair ``link`` slides.

    ``kind`` "R" meets at ``point``; "P" is along ``guide``, carried by ``other``.
    """

    kind: Literal["R", "P"]
    link: str
    other: str
    point: str = ""
    guide: str = ""

    def joins(self, link: str) -> bool:
        """Whether this pair is one of the link's."""
        return link in (self.link, self.other)

    def mate(self, link: str) -> str:
        """The other link of the pair."""
        return self.other if link == self.link else self.link


@dataclass(frozen=True)
class Group:
    """An Assur group of class II: two links, their inner pair and one outer pair each.

    ``links`` stand in the order of the file. ``first`` and ``last`` are the same two in the order the method
    takes them (RRP: connecting rod, slider; RPR: slider, guide link; RPP: hinged link, the other), with
    outer pairs ``first_outer`` and ``last_outer``. With a ``drive`` inside (a cylinder, a motor in a hinge) ``first``
    is the link of it that hangs on the frame, and with the drive stopped the other is one with it.
    """

    links: tuple[str, str]
    kind: int
    first: str
    last: str
    inner: Pair
    first_outer: Pair
    last_outer: Pair
    drive: Pair | None = None
    level: ClassVar[str] = "II"

    @property
    def whole(self) -> tuple[str, ...]:
        """All its links, both of a drive inside among them, by which its force plan is called."""
        return tuple(part for link in self.links for part in self.parts(link))

    def parts(self, link: str) -> tuple[str, ...]:
        """The links that one of the two is made of: itself and, with a drive inside, the other of that."""
        return (link, self.drive.mate(link)) if self.drive and link == self.first else (link,)

    def holder(self, link: str, pair: Pair) -> str:
        """Which of its parts has a pair."""
        return next(x for x in self.parts(link) if pair.joins(x))

    @property
    def members(self) -> str:
        """Its links as a formula of structure has them, those that are one with the drive stopped together."""
        return ";".join("-".join(self.parts(x)) for x in self.links)

    @property
    def ends(self) -> tuple[str, ...]:
        """The links that may be what the mechanism drives, the likeliest first."""
        return self.last, self.first

    @property
    def solved(self) -> tuple[str, ...]:
        """Its links in the order of solving."""
        return self.links

    @property
    def pairs(self) -> tuple[Pair, Pair, Pair]:
        """Its pairs: outer, inner, outer."""
        return self.first_outer, self.inner, self.last_outer

    @property
    def inner_pairs(self) -> tuple[Pair, ...]:
        """The pairs between its own links."""
        return (self.inner,)

    @property
    def said(self) -> Phrase:
        """Its class and kind in words."""
        return Phrase("class_two", kind=self.kind, name=self.name)

    @property
    def brief(self) -> Phrase:
        """The same without letters."""
        return Phrase("class_two_brief", kind=self.kind)

    def json(self) -> Json:
        """The group as the JSON has it."""
        drive = {"drive": [self.drive.other, self.drive.link]} if self.drive else {}
        return {"links": list(self.links), "kind": self.kind, "name": self.name, **drive}

    @property
    def name(self) -> str:
        """The letters of its pairs, e.g. "RRP"."""
        return KIND_NAMES[self.kind - 1]


@dataclass(frozen=True)
class Lead:
    """A driver (поводок) of a basic link: its ``inner`` pair with that, its ``outer`` one with a solved link."""

    link: str
    inner: Pair
    outer: Pair

    @property
    def name(self) -> str:
        """The letters of its pairs, the outer one first: "RR", "PR", "RP"."""
        return self.outer.kind + self.inner.kind


@dataclass(frozen=True)
class Triad:
    """An Assur group of class III and order 3: the ``basic`` link and its three leads, all in the order of the file."""

    links: tuple[str, ...]
    basic: str
    leads: tuple[Lead, Lead, Lead]
    level: ClassVar[str] = "III"

    @property
    def whole(self) -> tuple[str, ...]:
        """All its links, by which its force plan is called."""
        return self.links

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
        return self.basic, *(lead.link for lead in self.leads)

    @property
    def pairs(self) -> tuple[Pair, ...]:
        """Its pairs: of every lead the outer, then the inner one."""
        return tuple(p for lead in self.leads for p in (lead.outer, lead.inner))

    @property
    def inner_pairs(self) -> tuple[Pair, ...]:
        """The pairs between its own links."""
        return tuple(lead.inner for lead in self.leads)

    @property
    def name(self) -> str:
        """The letters of its leads, e.g. "RR-RR-PR"."""
        return "-".join(lead.name for lead in self.leads)

    @property
    def said(self) -> Phrase:
        """Its class, order, basic link and leads in words."""
        leads = tuple(lead.link for lead in self.leads)
        return Phrase("class_three", basic=self.basic, leads=leads, name=self.name)

    @property
    def brief(self) -> Phrase:
        """The same without letters."""
        return Phrase("class_three_brief")

    def json(self) -> Json:
        """The group as the JSON has it."""
        leads = [lead.link for lead in self.leads]
        own = {"class": 3, "order": 3, "basic": self.basic, "leads": leads}
        return {"links": list(self.links), **own, "name": self.name}
