"""Links that prevent a solution: over-constrained ones, or those that can only be solved together.

Every pair takes two freedoms: from a link, or from the hinge itself where none of its links is solved yet (a hinge of
three links is two pairs, whichever two). So constraints are matched with freedoms one after another. Where one finds
none left, all those it has asked are over-constrained; where all find one, links depend on those whose freedoms their
pairs take. The work grows as the square of the number of links.
"""

from collections.abc import Iterable, Sequence

from planes.words.frozen import frozen
from planes.words.names import NameTuple

Freedoms = tuple[str, ...]  # a link, or a joint by its number: the owner of freedoms
Holds = list[tuple[Freedoms, ...]]


@frozen
class Joint:
    """The unsolved links at a hinge or a guide, and whether a solved one is there too."""

    links: NameTuple
    solved: bool

    def pairs_among_links(self, chosen: Iterable[str]) -> int:
        """Its pairs among the chosen links and with a solved one."""
        here = sum(link in self.links for link in chosen)
        return here if self.solved else max(0, here - 1)


def degree_of_freedom_of_links(chosen: Sequence[str], joints: Iterable[Joint]) -> int:
    """The degree of freedom of some links, with all the pairs among them and with solved ones."""
    return 3 * len(chosen) - 2 * sum(joint.pairs_among_links(chosen) for joint in joints)


def find_unsolvable_links(links: Sequence[str], joints: Sequence[Joint]) -> NameTuple:
    """Over-constrained links if there are any; otherwise the smallest group of more than two that must be solved
    together; otherwise empty."""
    room: dict[Freedoms, int] = {(link,): 3 for link in links}
    holds = []
    for number, joint in enumerate(joints):
        own = () if joint.solved else ((str(number), "joint"),)
        room |= dict.fromkeys(own, 2)
        holds += [((link,), *own) for link in joint.links for _ in range(2)]
    takers, asked = _match_constraints_to_freedoms(holds, room)
    if asked:
        return _smallest_overconstrained_subset([link for link in links if (link,) in asked], joints)
    groups = [_links_solved_together(link, links, holds, takers) for link in links]
    return min((group for group in groups if len(group) > 2), key=len, default=())


def _match_constraints_to_freedoms(
    holds: Holds, room: dict[Freedoms, int]
) -> tuple[dict[Freedoms, list[int]], set[Freedoms]]:
    """The freedoms that each constraint takes; and all links asked by the first constraint that found none."""
    takers: dict[Freedoms, list[int]] = {whose: [] for whose in room}
    taken: dict[int, Freedoms] = {}
    for new in range(len(holds)):
        asked = {}
        queue = [new]
        free = None
        for constraint in queue:  # constraints in the way must find another freedom
            for whose in (w for w in holds[constraint] if w not in asked):
                asked[whose] = constraint
                free = whose if len(takers[whose]) < room[whose] else free
                queue += takers[whose]
            if free:
                break
        if free is None:
            return takers, set(asked)
        while free:
            constraint = asked[free]
            takers[free].append(constraint)
            before = taken.get(constraint)
            taken[constraint] = free
            if before:
                takers[before].remove(constraint)
            free = before
    return takers, set()


def _links_solved_together(
    link: str, links: Sequence[str], holds: Holds, takers: dict[Freedoms, list[int]]
) -> NameTuple:
    """The links without which one cannot be solved, including itself."""
    queue: list[Freedoms] = [(link,)]
    for whose in queue:
        queue += dict.fromkeys(w for c in takers[whose] for w in holds[c] if w not in queue)
    return tuple(x for x in links if (x,) in queue)


def _smallest_overconstrained_subset(held: list[str], joints: Sequence[Joint]) -> NameTuple:
    """The smallest over-constrained subset: no link can be left out of it."""
    for link in reversed(held[:]):
        fewer = [x for x in held if x != link]
        held = fewer if degree_of_freedom_of_links(fewer, joints) < 0 else held
    return tuple(held)
