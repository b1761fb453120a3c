"""Which links keep a mechanism from being solved: those held too often, or those solved only all together.

Every pair takes two freedoms: of a link it holds, or of the hinge itself where no link of it is solved yet (a hinge of
three links is two pairs, whichever two). So constraints are matched with freedoms one after another; where one finds
none left, all it has asked are held too often, and where all find one, links depend on those whose freedoms their own
pairs take. The work grows as the square of the links.
"""

from collections.abc import Iterable, Sequence

from planes.words.frozen import frozen

Freedoms = tuple[str, ...]  # a link, or a joint by its number: whose freedoms they are


@frozen
class Joint:
    """The links not solved yet that a hinge or a guide holds, and whether a solved one is there too."""

    links: tuple[str, ...]
    solved: bool

    def pairs(self, chosen: Iterable[str]) -> int:
        """Its pairs among chosen links and with a solved one."""
        here = sum(link in self.links for link in chosen)
        return here if self.solved else max(0, here - 1)


def freedom(chosen: Sequence[str], joints: Iterable[Joint]) -> int:
    """What is left of the freedom of some links by all the pairs among them and with solved ones."""
    return 3 * len(chosen) - 2 * sum(joint.pairs(chosen) for joint in joints)


def unsolvable(links: Sequence[str], joints: Sequence[Joint]) -> tuple[str, ...]:
    """Links that are over-constrained if there are any; else the smallest group of more than two that can only be
    solved together; else none."""
    room: dict[Freedoms, int] = {(link,): 3 for link in links}
    holds: list[tuple[Freedoms, ...]] = []
    for number, joint in enumerate(joints):
        own = () if joint.solved else ((str(number), "joint"),)
        room |= dict.fromkeys(own, 2)
        holds += [((link,), *own) for link in joint.links for _ in range(2)]
    takers, asked = _matched(holds, room)
    if asked:
        return _least([link for link in links if (link,) in asked], joints)
    groups = [_together(link, links, holds, takers) for link in links]
    return min((group for group in groups if len(group) > 2), key=len, default=())


def _matched(
    holds: list[tuple[Freedoms, ...]], room: dict[Freedoms, int]
) -> tuple[dict[Freedoms, list[int]], set[Freedoms]]:
    """Which constraints take whose freedoms; and all that were asked by the first that found none."""
    takers: dict[Freedoms, list[int]] = {whose: [] for whose in room}
    taken: dict[int, Freedoms] = {}
    for new in range(len(holds)):
        asked: dict[Freedoms, int] = {}
        queue, free = [new], None
        for constraint in queue:  # those in the way are asked for another freedom in their turn
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
            before, taken[constraint] = taken.get(constraint), free
            if before:
                takers[before].remove(constraint)
            free = before
    return takers, set()


def _together(
    link: str, links: Sequence[str], holds: list[tuple[Freedoms, ...]], takers: dict[Freedoms, list[int]]
) -> tuple[str, ...]:
    """The links that one cannot be solved without, itself among them."""
    queue: list[Freedoms] = [(link,)]
    for whose in queue:
        queue += dict.fromkeys(w for c in takers[whose] for w in holds[c] if w not in queue)
    return tuple(x for x in links if (x,) in queue)


def _least(held: list[str], joints: Sequence[Joint]) -> tuple[str, ...]:
    """Of links held too often those that still are so with any one of them away."""
    for link in reversed(held[:]):
        fewer = [x for x in held if x != link]
        held = fewer if freedom(fewer, joints) < 0 else held
    return tuple(held)
