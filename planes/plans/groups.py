"""Kinematic pairs, and the Assur groups of class II in the five kinds of Artobolevsky."""

from dataclasses import dataclass
from typing import Literal

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
    outer pairs ``first_outer`` and ``last_outer``. With a ``drive`` inside (a cylinder) ``first`` carries its guide,
    and with the drive stopped the slider is one with it.
    """

    links: tuple[str, str]
    kind: int
    first: str
    last: str
    inner: Pair
    first_outer: Pair
    last_outer: Pair
    drive: Pair | None = None

    @property
    def whole(self) -> tuple[str, ...]:
        """All its links, the slider of a drive inside among them, by which its force plan is called."""
        return tuple(part for link in self.links for part in self.parts(link))

    def parts(self, link: str) -> tuple[str, ...]:
        """The links that one of the two is made of: itself and, with a drive inside, the slider of that."""
        return (link, self.drive.link) if self.drive and link == self.first else (link,)

    def holder(self, link: str, pair: Pair) -> str:
        """Which of its parts has a pair."""
        return next(x for x in self.parts(link) if pair.joins(x))

    @property
    def members(self) -> str:
        """Its links as a formula of structure has them, those that are one with the drive stopped together."""
        return ";".join("-".join(self.parts(x)) for x in self.links)

    def json(self) -> Json:
        """The group as the JSON has it."""
        drive = {"drive": [self.drive.other, self.drive.link]} if self.drive else {}
        return {"links": list(self.links), "kind": self.kind, "name": self.name, **drive}

    @property
    def pairs(self) -> tuple[Pair, Pair, Pair]:
        """Its pairs: outer, inner, outer."""
        return self.first_outer, self.inner, self.last_outer

    @property
    def name(self) -> str:
        """The letters of its pairs, e.g. "RRP"."""
        return KIND_NAMES[self.kind - 1]
