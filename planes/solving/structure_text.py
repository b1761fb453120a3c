"""The structure of a mechanism as text: mobility, groups, the self-aligning variant."""

from planes.plans.assur.alignment import Aligned, pairs_of
from planes.plans.assur.contours import AnyGroup
from planes.plans.assur.structure import Structure
from planes.plans.measuring import counted
from planes.scene.mechanism import FRAME
from planes.words import Lang, capital, say
from planes.words.lettering import flat


def structure_report(found: Structure, lang: Lang = "en", frame: str = FRAME) -> str:
    """W and q with their numbers, the formula and the groups, one a line; ``frame`` is the number of the frame."""
    numbers = flat(";  ".join(counted(found)))
    lines = [f"W = {found.W}, q = {found.q}", f"  {numbers}", found.formula_as(frame)]
    for g in found.groups:
        lines.append(f"{say('group', lang)} {', '.join(g.whole)}: {g.said.told(lang)}")
    lines += [capital(way) for way in ways_told(found, lang, frame)]
    lines += [say("passive", lang, links=", ".join(found.passive))] if found.passive else []
    return "\n".join(lines)


def group_counted(group: AnyGroup, lang: Lang) -> list[str]:
    """That a group has as many equations of equilibrium as unknown reactions, and its redundant constraints; nothing of
    one with a drive inside."""
    n, p = len(group.whole), len(pairs_of(group))
    return [say("note_group_determinate", lang, n=n, p=p, q=5 * p - 6 * n)] if 3 * n == 2 * p else []


def ways_told(found: Structure, lang: Lang, frame: str, kinds: bool = False) -> list[str]:
    """The drivers with which a mechanism of a higher class is of a lower one, or that none is; of class II nothing."""
    if not found.heaviness:
        return []
    ways = ({"link": w.driver, "level": w.level, "formula": w.formula_as(frame, kinds)} for w in found.ways)
    return [say("second_way", lang, **way) for way in ways] or [say("no_second_way", lang, level=found.level)]


def alignment_report(found: Aligned, lang: Lang = "en", frame: str = FRAME) -> str:
    """The self-aligning variant: the count of Somov and Malyshev, and what every pair becomes; ``frame`` is the number
    of the frame."""
    p1, p2, p3 = found.counts
    lines = [
        say("alignment", lang, n=found.n, p1=p1, p2=p2, p3=p3),
        say("alignment_W", lang, a=6 * found.n, b=5 * p1, c=4 * p2, d=3 * p3, W=found.W, q=found.q),
    ]
    for pair, sign in found.pairs:
        name, links = pair.point or pair.guide, "–".join(frame if x == FRAME else x for x in (pair.other, pair.link))
        lines.append("  " + say("alignment_pair", lang, name=name, links=links, sign=say(f"sign_{sign}", lang)))
    return "\n".join(lines)
