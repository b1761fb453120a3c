"""The group moved by a drive between two moving links: with the drive stopped these links are one body.

One link of a cylinder or a motor is on the frame and the other has a hinge with a third; or a cylinder braces two links
across their hinge and acts like a motor in it. Or the two links of the drive form one of three leads of a basic link. A
link that groups fix to the frame (a boom on a locked cylinder) counts as the frame.
"""

from collections.abc import Iterator
from itertools import combinations, permutations, product

from planes.plans.assur.basic_links import Lead, Triad
from planes.plans.assur.contours import AnyGroup, Contour
from planes.plans.assur.groups import Brace, Group, Pair
from planes.plans.assur.reached import Reached
from planes.words import Phrase

DYAD_KIND_BY_OUTER_PAIRS = {"RR": 1, "RP": 2, "PR": 2, "PP": 4}  # of a dyad with a hinge inside, by its outer pairs


def group_moved_by_inner_drive(f: Reached, drive: Pair) -> tuple[list[Group], AnyGroup]:
    """The group that the drive moves, after the stationary dyads that support it; :class:`StructureError` if it cannot
    be drawn."""
    still = []
    while dyad := next((g for two in f.meeting() if not any(map(drive.has_link, two)) and (g := f.dyad(two))), None):
        still.append(dyad)
        for link in dyad.links_in_solving_order:
            f.solve(link)
    ways = (_group_of_direct_drive, _group_braced_by_cylinder, _group_with_drive_as_lead, _group_of_driven_contour)
    for group in (g for way in ways for g in way(f, drive)):
        return still, group
    raise f.error(Phrase("inner_drive", one=drive.link, two=drive.other), "drive")


def _group_of_direct_drive(f: Reached, drive: Pair) -> Iterator[Group]:
    """One link of the drive has a hinge on the frame, and the other has a hinge with a third link."""
    for held, moved in permutations((drive.other, drive.link)):
        if f.between(moved, held)[1:] or f.outer[moved]:
            continue
        for hung in f.outer[held]:
            yield from _dyad_of_stopped_drive(f, held, moved, hung, drive)


def _group_braced_by_cylinder(f: Reached, drive: Pair) -> Iterator[Group]:
    """The cylinder has a hinge with each of two links that are hinged to each other."""
    if drive.kind == "R" or f.outer[drive.link] or f.outer[drive.other]:
        return
    for pins in product(
        _hinges_with_unsolved_links(f, drive.link, drive), _hinges_with_unsolved_links(f, drive.other, drive)
    ):
        for near, far in permutations(pins):
            between = f.between(far.other, near.other)
            hung = f.outer[near.other]
            if len(between) == 1 == len(hung) and _is_unsolved_hinge(f, between[0]) and not f.outer[far.other]:
                motor = Pair("R", far.other, near.other, point=between[0].point)
                yield from _dyad_of_stopped_drive(f, near.other, far.other, hung[0], motor, Brace(drive, near, far))


def _group_with_drive_as_lead(f: Reached, drive: Pair) -> Iterator[Triad]:
    """The two links of the drive are a lead of a basic link with two more leads on the frame."""
    for held, moved in permutations((drive.other, drive.link)):
        if len(f.outer[held]) != 1 or f.outer[moved] or f.between(moved, held)[1:]:
            continue
        for basic in (x for x in f.left if not drive.has_link(x) and not f.outer[x]):
            inner = [p for p in f.between(moved, basic) if _is_unsolved_hinge(f, p)]
            others = [x for x in f.left if not drive.has_link(x) and x != basic and len(f.outer[x]) == 1]
            joints = [
                (x, [p for p in f.between(x, basic) if p.kind == "P" or _is_unsolved_hinge(f, p)]) for x in others
            ]
            leads = [Lead(x, pairs[0], f.outer[x][0]) for x, pairs in joints if len(pairs) == 1]
            if len(inner) == 1 and len(leads) == 2 and not any(lead.pair_letters == "PP" for lead in leads):
                driven = Lead(held, inner[0], f.outer[held][0], drive)
                names = tuple(x for x in f.links if x in (basic, held, *(lead.link for lead in leads)))
                group_links = tuple(x for x in f.links if x in (*names, moved))
                yield Triad(names, basic, (driven, leads[0], leads[1]), group_links)


def _group_of_driven_contour(f: Reached, drive: Pair) -> Iterator[Contour]:
    """The two links of the drive join two links on the frame that are also joined by another link."""
    if f.outer[drive.link] or f.outer[drive.other]:
        return
    others = [x for x in f.left if not drive.has_link(x)]
    hung = sorted((x for x in others if len(f.outer[x]) == 1), key=lambda x: f.outer[x][0].kind == "P")
    for (base, basic), (near, far) in product(combinations(hung, 2), permutations((drive.link, drive.other))):
        ends = (f.between(far, basic), f.between(near, base))
        wrong = (f.between(near, basic), f.between(far, base))
        if any(wrong) or f.between(base, basic) or not all(len(e) == 1 and _is_unsolved_hinge(f, e[0]) for e in ends):
            continue
        for rod in (x for x in others if not f.outer[x]):
            pairs = [[p for p in f.between(rod, x) if p.kind == "P" or _is_unsolved_hinge(f, p)] for x in (basic, base)]
            if all(len(p) == 1 for p in pairs) and f.outer[base][0].kind == "R":
                own = Lead(rod, pairs[0][0], pairs[1][0])
                driven = Lead(near, ends[0][0], ends[1][0], drive)
                group_links = tuple(x for x in f.links if x in (base, basic, near, far, rod))
                one, two = sorted((own, driven), key=lambda lead: f.links.index(lead.link))
                names = tuple(x for x in group_links if x != far)
                if own.pair_letters != "PP":
                    yield Contour(names, base, basic, (f.outer[base][0], f.outer[basic][0]), (one, two), group_links)


def _hinges_with_unsolved_links(f: Reached, half: str, drive: Pair) -> list[Pair]:
    """The hinges of one half of a cylinder with unsolved links."""
    others = (x for x in f.left if not drive.has_link(x))
    return [p for x in others for p in f.between(half, x) if _is_unsolved_hinge(f, p)]


def _is_unsolved_hinge(f: Reached, pair: Pair) -> bool:
    """Whether it is a hinge that no solved link has."""
    return pair.kind == "R" and pair.point not in f.reached


def _dyad_of_stopped_drive(
    f: Reached, held: str, moved: str, hung: Pair, drive: Pair, brace: Brace | None = None
) -> Iterator[Group]:
    """The dyad of the stopped drive as one link and a link on the frame."""
    taken = {held, moved, *(brace.cylinder_links if brace else ())}
    for link in (x for x in f.left if x not in taken):
        inner = [p for p in f.between(link, moved) if _is_unsolved_hinge(f, p)]
        if len(f.outer[held]) == len(f.outer[link]) == len(inner) == 1 and not f.between(link, held):
            outer = f.outer[link][0]
            one, two = sorted((held, link), key=f.links.index)
            group_links = tuple(x for x in f.links if x in (*taken, link))
            ends = (held, link, inner[0], hung, outer)
            if hung.kind == "P" and outer.kind == "R":  # a dyad of kind 2 begins with its rod
                ends = (link, held, inner[0], outer, hung)
            yield Group((one, two), DYAD_KIND_BY_OUTER_PAIRS[hung.kind + outer.kind], *ends, drive, brace, group_links)
