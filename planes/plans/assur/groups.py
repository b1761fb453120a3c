"""Kinematic pairs, and the five kinds of Assur groups of class II."""

from collections.abc import Callable, Sequence
from typing import Literal

from planes.words import Phrase
from planes.words.frozen import frozen
from planes.words.names import NamePair, NameTuple
from planes.words.records import Json

Between = Callable[[str, str], Sequence["Pair"]]
"""The pairs of a link with another one."""
DYAD_KIND_NAMES = ("RRR", "RRP", "RPR", "PRP", "RPP")


@frozen
class Pair:
    """A kinematic pair of ``link`` with the previously solved ``other``: a hinge ("R") at ``point``, or the link slides
    ("P") along ``guide`` of the other."""

    kind: Literal["R", "P"]
    link: str
    other: str
    point: str = ""
    guide: str = ""

    def has_link(self, link: str) -> bool:
        """Whether this pair belongs to the link."""
        return link in (self.link, self.other)

    @property
    def signed_links(self) -> tuple[tuple[str, float], tuple[str, float]]:
        """Its links with the signs of their relative motion."""
        return (self.link, 1.0), (self.other, -1.0)

    def other_link_of_pair(self, link: str) -> str:
        """The other link of the pair."""
        return self.other if link == self.link else self.link


@frozen
class Brace:
    """A cylinder across the hinge of two links: its ``slide``, its hinge with the ``near`` link, which is on the frame,
    and with the ``far`` one. While it is stopped the two links are rigidly joined, as if a motor held their hinge."""

    slide: Pair
    near: Pair
    far: Pair

    @property
    def cylinder_links(self) -> NamePair:
        """Its two links, the one at the near hinge first."""
        return self.near.link, self.far.link


@frozen
class Group:
    """An Assur group of class II: two links, their inner pair and one outer pair each.

    ``links`` are in the order of the file, ``first`` and ``last`` are the same two in the order of the method (RRP:
    connecting rod, slider; RPR: slider, guide link; RPP: hinged link, the other). With a ``drive`` inside (a cylinder,
    a motor) one of them consists of two links: ``held`` is the one on the frame, and the other is rigid with it while
    the drive is stopped. Where a cylinder is the ``brace`` of two links, the drive acts like a motor in their hinge.
    """

    links: NamePair
    kind: int
    first: str
    last: str
    inner: Pair
    first_outer: Pair
    last_outer: Pair
    drive: Pair | None = None
    brace: Brace | None = None
    order: NameTuple = ()  # with a drive inside: all its links in the order of the file
    level = "II"

    @property
    def all_links(self) -> NameTuple:
        """All its links, including both links of a drive inside."""
        return tuple(part for link in self.links for part in self.links_composing(link))

    @property
    def balanced_links(self) -> NameTuple:
        """The links whose forces are on its plan; they name the plan."""
        return self.order or self.links

    @property
    def held_link(self) -> str:
        """Of the two links of a drive inside, the one on the frame."""
        return self.held_link_first_with_pairs[0][0]

    @property
    def links_with_outer_pairs(self) -> tuple[tuple[str, Pair], tuple[str, Pair]]:
        """Both links in the order of the method, with their outer pairs."""
        return (self.first, self.first_outer), (self.last, self.last_outer)

    @property
    def held_link_first_with_pairs(self) -> tuple[tuple[str, Pair], tuple[str, Pair]]:
        """The held link and the other, with their outer pairs."""
        if self.drive and self.drive.has_link(self.last):
            return self.links_with_outer_pairs[::-1]
        return self.links_with_outer_pairs

    @property
    def links_by_force_plan(self) -> tuple[NameTuple, ...]:
        """The links of each force plan, which name it."""
        return (self.balanced_links,)

    def links_composing(self, link: str) -> NameTuple:
        """The links that one of the two consists of: itself and, with a drive inside, the other link of the drive."""
        if self.drive and link == self.held_link:
            return (link, self.drive.other_link_of_pair(link))
        return (link,)

    def loaded_links(self, link: str) -> NameTuple:
        """The links whose loads act on one of the two: its parts, and the cylinder that braces them."""
        loaded_parts = (
            *self.links_composing(link),
            *(self.brace.cylinder_links if self.brace and link == self.held_link else ()),
        )
        return tuple(x for x in self.order if x in loaded_parts) or loaded_parts

    def link_holding_pair(self, link: str, pair: Pair) -> str:
        """Which of its parts has the pair."""
        return next(x for x in self.links_composing(link) if pair.has_link(x))

    @property
    def formula_members(self) -> str:
        """Its links as in a structural formula, those of a stopped drive together."""
        return ";".join("-".join(self.loaded_links(x)) for x in self.links)

    @property
    def output_link_candidates(self) -> NameTuple:
        """The links that may be the output of the mechanism, the likeliest first."""
        return self.last, self.first

    @property
    def links_in_solving_order(self) -> NameTuple:
        """Its links in the order of solving."""
        return self.links

    def reached(self, drive: Pair) -> NameTuple:
        """The links solved together with it where the drive is inside."""
        return *(
            (drive.link, drive.other) if self.drive == drive else self.links_composing(self.held_link)
        ), self.held_link_first_with_pairs[1][0]

    @property
    def pairs(self) -> tuple[Pair, Pair, Pair]:
        """Its pairs: outer, inner, outer."""
        return self.first_outer, self.inner, self.last_outer

    @property
    def inner_pairs(self) -> tuple[Pair, ...]:
        """The pairs between its own links."""
        return (self.inner,)

    @property
    def group_description(self) -> Phrase:
        """Its class and kind in words."""
        return Phrase("class_two", kind=self.kind, name=self.pair_letters)

    @property
    def short_group_description(self) -> Phrase:
        """The same without letters."""
        return Phrase("class_two_brief", kind=self.kind)

    def json(self) -> Json:
        """The group as in the JSON output."""
        pair = self.brace.slide if self.brace else self.drive
        own: Json = {"links": list(self.links), "kind": self.kind, "name": self.pair_letters}
        if pair:
            own["drive"] = [pair.other, pair.link]
        return own | ({"across": self.drive.point} if self.brace and self.drive else {})

    @property
    def pair_letters(self) -> str:
        """The letters of its pairs, e.g. "RRP"."""
        return DYAD_KIND_NAMES[self.kind - 1]
