"""The links solved so far, the pairs by which others are attached to them, and the dyads these make."""

from collections.abc import Iterator

from planes.plans.assur.groups import DYAD_KIND_NAMES, Group, Pair
from planes.scene.mechanism import Mechanism
from planes.words import Phrase
from planes.words.errors import StructureError
from planes.words.names import NamePair


class Reached:
    """The links of a mechanism, and those of them that are solved."""

    def __init__(self, mechanism: Mechanism, file: str) -> None:
        self.mechanism = mechanism
        self.file = file
        self.links = list(mechanism.links)
        self.holders: dict[str, list[str]] = {}
        for link in mechanism.bodies:
            for point in link.points:
                self.holders.setdefault(point, []).append(link.name)
        self.slides = [
            Pair("P", link.name, mechanism.owner_of_guide(link.slides.guide), guide=link.slides.guide)
            for link in mechanism.links.values()
            if link.slides
        ]
        self.slid: dict[str, list[Pair]] = {}
        for slide in self.slides:
            for name in dict.fromkeys((slide.link, slide.other)):
                self.slid.setdefault(name, []).append(slide)
        self.left = {link: place for place, link in enumerate(self.links)}  # not solved yet, in the order of the file
        self.reached: set[str] = set()  # points of solved links
        self.outer: dict[str, list[Pair]] = {link: [] for link in self.links}  # pairs with solved links

    def error(self, phrase: Phrase, *path: str) -> StructureError:
        """An error at the line of its subject."""
        where = self.mechanism.where
        return StructureError(phrase, self.file, where.get(path, where.get(("links",))))

    def between(self, link: str, other: str) -> list[Pair]:
        """Pairs of a link with another one."""
        points = (p for p in self.mechanism.link(link).points if other in self.holders[p])
        slides = (slide for slide in self.slid.get(link, ()) if slide.other_link_of_pair(link) == other)
        return [*(Pair("R", link, other, point=point) for point in points), *slides]

    def solve(self, link: str) -> None:
        """Record a link as solved: its hinges not reached before, and its slides, become outer pairs of its
        neighbours."""
        self.left.pop(link, None)
        for point in [p for p in self.mechanism.link(link).points if p not in self.reached]:
            self.reached.add(point)
            for other in self.holders[point]:
                if other in self.left:
                    self.outer[other].append(Pair("R", other, link, point=point))
        for slide in self.slid.get(link, ()):
            if slide.other_link_of_pair(link) in self.left:
                self.outer[slide.other_link_of_pair(link)].append(slide)

    def meeting(self) -> Iterator[NamePair]:
        """Two links, each attached to a solved link, with a common hinge or guide, in the order of the file."""
        place = {link: k for link, k in self.left.items() if len(self.outer[link]) == 1}
        for one in place:
            points = (p for p in self.mechanism.link(one).points if p not in self.reached)
            mates = {h for point in points for h in self.holders[point]}
            mates |= {slide.other_link_of_pair(one) for slide in self.slid.get(one, ())}
            yield from ((one, self.links[k]) for k in sorted(place[m] for m in mates if place.get(m, -1) > place[one]))

    def dyad(self, links: NamePair) -> Group | None:
        """The two links as a dyad on the solved links, or None."""
        one, two = links
        inner = self.unsolved_pairs_between(two, one)
        if len(inner) == 1:
            return self.classify_dyad(links, self.outer[one][0], inner[0], self.outer[two][0])
        return None

    def classify_dyad(self, links: NamePair, a: Pair, inner: Pair, b: Pair) -> Group:
        """Kind and working order of a dyad with outer pairs ``a`` of the first link and ``b`` of the second."""
        letters = a.kind + inner.kind + b.kind
        one, two = links
        if letters == "PPP":
            raise self.error(Phrase("three_slides", one=one, two=two), "links", one)
        if letters == "PRP" and a.other_link_of_pair(one) == b.other_link_of_pair(two):
            raise self.error(Phrase("locked_slides", one=one, two=two, owner=a.other_link_of_pair(one)), "links", two)
        swap = letters in ("PRR", "PPR") or (letters == "RPR" and inner.other == one)
        if swap:
            one, two, a, b = two, one, b, a
        kind = DYAD_KIND_NAMES.index(letters[::-1] if letters in ("PRR", "PPR") else letters) + 1
        return Group(links, kind, one, two, inner, a, b)

    def unsolved_pairs_between(self, link: str, other: str) -> list[Pair]:
        """Pairs between two unsolved links."""
        return [p for p in self.between(link, other) if p.kind == "P" or p.point not in self.reached]
