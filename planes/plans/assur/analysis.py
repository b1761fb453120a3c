"""Pairs and the Assur groups of a mechanism, in the order of attachment; and the drives that give lower classes.

Sources: Chebyshev's W = 3n - 2p₁, Reshetov's q = W - 6n + 5p₁ for one-freedom pairs; the five kinds of Artobolevsky.
The class of a mechanism is that of its highest group, and another driver may lower it (Assur).
"""

from dataclasses import replace
from typing import Literal

from planes.plans.assur.basic_chains import chain_of_basic_links
from planes.plans.assur.contours import AnyGroup, Contour, Tracked, contour_group_of_links, triad_of_links
from planes.plans.assur.groups import Pair
from planes.plans.assur.inner_drives import group_moved_by_inner_drive
from planes.plans.assur.reached import Reached
from planes.plans.assur.structure import GROUP_CLASSES, Structure
from planes.plans.assur.unsolvable import Joint, degree_of_freedom_of_links, find_unsolvable_links
from planes.scene.mechanism import FRAME, Drive, Mechanism
from planes.words import Phrase
from planes.words.errors import StructureError
from planes.words.names import NameTuple


def analyse_structure(mechanism: Mechanism, file: str = "") -> Structure:
    """Find W, q and the groups, and other drivers that give lower groups; :class:`StructureError` names the links where
    the method stops, and the drivers with which it does not."""
    try:
        structure = _find_structure(mechanism, file)
    except StructureError as error:
        why = error.phrase
        if (
            not isinstance(why, Phrase)
            or why.key != "higher_class"
            or not (ways := _drivers_lowering_class(mechanism, len(GROUP_CLASSES)))
        ):
            raise
        others = tuple(Phrase("other_driver", link=w.driver, formula=w.structural_formula) for w in ways)
        raise StructureError(Phrase("higher_class_driven", **why.parts, ways=others), error.file, error.line) from None
    return replace(structure, ways=_drivers_lowering_class(mechanism, structure.class_index))


MOST_OTHER_DRIVERS = 8  # other drivers: few mechanisms have more links on the frame, and each costs a new analysis


def _drivers_lowering_class(mechanism: Mechanism, heaviness: int) -> tuple[Structure, ...]:
    """The same mechanism driven by another link on the frame, wherever that lowers its class; the lowest first."""
    finder = _Finder(mechanism, "")
    structures = []
    others = [(x, finder.between(x, FRAME)) for x in mechanism.links if heaviness]
    for link, (pair,) in [(x, pairs) for x, pairs in others if len(pairs) == 1][:MOST_OTHER_DRIVERS]:
        try:
            drive = Drive(link, "phi" if pair.kind == "R" else "s", 0.0)
            structures.append(_find_structure(replace(mechanism, drive=drive), ""))
        except StructureError:
            continue
    return tuple(sorted((s for s in structures if s.class_index < heaviness), key=lambda s: s.class_index))


def _find_structure(mechanism: Mechanism, file: str) -> Structure:
    """W, q and the groups."""
    finder = _Finder(mechanism, file)
    pair_count = finder.pair_count()
    freedom = 3 * len(mechanism.links) - 2 * pair_count
    if freedom != 1:
        hint = Phrase("freedom_more") if freedom > 1 else Phrase("freedom_less", count=1 - freedom)
        counted = {"links": len(mechanism.links), "pairs": pair_count, "freedom": freedom}
        why = Phrase("wrong_freedom", **counted, hint=hint, listed=finder.pairs_in_words())
        raise finder.error(why, "links", finder.suspect_link(freedom > 1))
    drive_pair = finder.drive_pair()
    groups = finder.attach_groups(drive_pair)
    redundant = freedom - 6 * len(mechanism.links) + 5 * pair_count
    return Structure(freedom, redundant, drive_pair, groups, mechanism.drive.link)


class _Finder(Reached):
    """Walks the links from the frame outwards; of several possible dyads it takes the first in the file."""

    def pair_count(self) -> int:
        """The number of one-freedom pairs: k - 1 for a hinge of k links, one for each slide."""
        return sum(len(h) - 1 for h in self.holders.values()) + len(self.slides)

    def suspect_link(self, loose: bool) -> str:
        """The link blamed for a wrong W: the one with the fewest pairs, or the most; of equals the last."""
        count = {name: sum(name in h for h in self.holders.values() if len(h) > 1) for name in self.links}
        for slide in self.slides:
            for name in {slide.link, slide.other} - {FRAME}:
                count[name] += 1
        return (min if loose else max)(reversed(self.links), key=lambda name: count[name])

    def pairs_in_words(self) -> tuple[Phrase, ...]:
        """The pairs in words, for the sentence of a wrong W."""
        hinges = [Phrase("hinge_pair", point=p, links=tuple(h)) for p, h in self.holders.items() if len(h) > 1]
        slides = [Phrase("slide_pair", link=s.link, guide=s.guide, owner=s.other) for s in self.slides]
        return (*hinges, *slides) or (Phrase("none"),)

    def drive_pair(self) -> Pair:
        """The pair of the driver with the frame that defines the drive's motion."""
        drive = self.mechanism.drive
        slides = self.mechanism.links[drive.link].slides
        if drive.kind == "s" and slides and self.mechanism.owner_of_guide(slides.guide) != FRAME:
            return next(s for s in self.slides if s.link == drive.link)
        pairs = self.between(drive.link, drive.on)
        wanted: Literal["R", "P"] = "R" if drive.rotates else "P"
        fitting = [p for p in pairs if p.kind == wanted]
        if len(pairs) != 1 or not fitting:
            need = Phrase("need_hinge" if wanted == "R" else "need_guide")
            have = tuple(Phrase("a_hinge" if p.kind == "R" else "a_slide", name=p.point or p.guide) for p in pairs)
            details = {"link": drive.link, "kind": drive.kind, "need": need, "have": have or Phrase("none")}
            key = "driver_pair" if drive.on == FRAME else "motor_pair"
            raise self.error(Phrase(key, on=drive.on, **details), "drive")
        return fitting[0]

    def attach_groups(self, drive: Pair) -> tuple[AnyGroup, ...]:
        """Dyads in the order of attachment, a higher group where no dyad attaches; an error for the rest when nothing
        does."""
        groups = []
        solved: NameTuple = (FRAME, drive.link)
        if drive.other != FRAME:
            self.solve(FRAME)
            still, driven = group_moved_by_inner_drive(self, drive)
            groups += [*still, driven]
            solved = driven.reached(drive)
        while True:
            for link in solved:
                self.solve(link)
            if not self.left:
                return tuple(groups)
            group = next((g for g in map(self.dyad, self.meeting()) if g), None) or self.find_higher_group()
            groups.append(group)
            solved = group.links_in_solving_order

    def find_higher_group(self) -> Tracked:
        """The smallest group of links that can only be solved together, if it is of class III and order 3 or IV and
        2."""
        names, free = self.links_blocking_solution()
        if free >= 0 and (chain := chain_of_basic_links(names, self.unsolved_pairs_between, self.outer)):
            return chain
        if free >= 0 and len(names) == 4:
            group = triad_of_links(names, self.unsolved_pairs_between, self.outer) or contour_group_of_links(
                names, self.unsolved_pairs_between, self.outer
            )
            twice = [lead.link for lead in group.leads if lead.pair_letters == "PP"] if group else []
            if group and (len(twice) > 1 or (twice and isinstance(group, Contour))):
                key = "leads_slide_twice" if len(twice) > 1 else "lead_slides_twice"
                why = Phrase(key, link=twice[0], links=tuple(twice), basic=group.basic, level=group.level)
                raise self.error(why, "links", twice[0])
            if group:
                return group
        raise self.unsolvable_links_error(names, free)

    def links_blocking_solution(self) -> tuple[NameTuple, int]:
        """The links that prevent a solution of the rest, and their degree of freedom."""
        holders = [*self.holders.values(), *([s.link, s.other] for s in self.slides)]
        here = [tuple(x for x in links if x in self.left) for links in holders]
        joints = [Joint(some, len(some) < len(all_)) for some, all_ in zip(here, holders, strict=True)]
        names = find_unsolvable_links(list(self.left), joints)
        return names, degree_of_freedom_of_links(names, joints)

    def unsolvable_links_error(self, names: NameTuple, free: int) -> StructureError:
        """The error for links that form a group of too high a class, or are over- or under-constrained."""
        if free < 0:
            why = Phrase("overconstrained", names=names, count=(1 - free) // 2, freedom=free)
        else:
            why = Phrase("higher_class" if names else "loose_links", names=names or tuple(self.left))
        return self.error(why, "links", (names or tuple(self.left))[0])
