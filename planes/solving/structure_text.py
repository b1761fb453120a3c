"""The structure of a mechanism as text: mobility, groups, the self-aligning variant."""

from planes.plans.assur.alignment import Aligned, group_pairs
from planes.plans.assur.contours import AnyGroup
from planes.plans.assur.structure import Structure
from planes.plans.measuring import counted_structure_numbers
from planes.scene.mechanism import FRAME
from planes.words import Lang, capitalize_first_letter, say
from planes.words.lettering import without_index_markup


def structure_report_text(structure: Structure, lang: Lang = "en", frame: str = FRAME) -> str:
    """W and q with their numbers, the formula and the groups, one per line; ``frame`` is the number of the frame."""
    numbers = without_index_markup(";  ".join(counted_structure_numbers(structure)))
    lines = [f"W = {structure.W}, q = {structure.q}", f"  {numbers}", structure.formula_with_frame_number(frame)]
    for g in structure.groups:
        lines.append(f"{say('group', lang)} {', '.join(g.all_links)}: {g.group_description.told(lang)}")
    lines += [capitalize_first_letter(way) for way in class_lowering_drivers_text(structure, lang, frame)]
    if structure.passive:
        lines.append(say("passive", lang, links=", ".join(structure.passive)))
    return "\n".join(lines)


def group_equilibrium_sentence(group: AnyGroup, lang: Lang) -> list[str]:
    """The sentence that a group has as many equations of equilibrium as unknown reactions, and its redundant
    constraints; empty for a group with a drive inside."""
    n = len(group.all_links)
    p = len(group_pairs(group))
    if 3 * n == 2 * p:
        return [say("note_group_determinate", lang, n=n, p=p, q=5 * p - 6 * n)]
    return []


def class_lowering_drivers_text(structure: Structure, lang: Lang, frame: str, kinds: bool = False) -> list[str]:
    """The drivers that lower the class of a mechanism of a higher class, or that there are none; empty for class II."""
    if not structure.class_index:
        return []
    ways = (
        {"link": w.driver, "level": w.mechanism_class, "formula": w.formula_with_frame_number(frame, kinds)}
        for w in structure.ways
    )
    return [say("second_way", lang, **way) for way in ways] or [
        say("no_second_way", lang, level=structure.mechanism_class)
    ]


def alignment_report(aligned: Aligned, lang: Lang = "en", frame: str = FRAME) -> str:
    """The self-aligning variant with markup of indices: the count of Somov and Malyshev, and the new kind of every
    pair; ``frame`` is the number of the frame."""
    p1, p2, p3 = aligned.pair_counts_by_class
    lines = [
        say("alignment", lang, n=aligned.n, p1=p1, p2=p2, p3=p3),
        say(
            "alignment_W",
            lang,
            a=6 * aligned.n,
            b=5 * p1,
            c=4 * p2,
            d=3 * p3,
            W=aligned.degree_of_freedom,
            q=aligned.redundant_constraints,
        ),
    ]
    for pair, sign in aligned.pairs:
        name = pair.point or pair.guide
        links = "–".join(frame if x == FRAME else x for x in (pair.other, pair.link))
        lines.append("  " + say("alignment_pair", lang, name=name, links=links, sign=say(f"sign_{sign}", lang)))
    return "\n".join(lines)
