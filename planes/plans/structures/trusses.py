"""A truss: conditions on its joints and members, and its plan from the external forces."""

from collections.abc import Callable, Mapping

from planes.drafting.draft import Draft
from planes.plans.force.loads import Force
from planes.plans.structures.cremona import CremonaPlan
from planes.plans.structures.regions import Outside, Regions
from planes.scene.structures import Framework
from planes.words import Phrase
from planes.words.errors import SceneError
from planes.words.names import NamePair

ZERO_FORCE_RATIO = 1e-9  # of the largest force: below this it is zero
Refusal = Callable[..., SceneError]


def check_truss(f: Framework, error: Refusal) -> None:
    """Check that a truss has as many members and reactions as its joints have equations: 2j = m + r."""
    joints = {p for m in f.members for p in m}
    m = len(f.members)
    r = sum(s.unknown_count for s in f.supports)
    details = {"joints": len(joints), "members": m, "held": r, "count": abs(2 * len(joints) - m - r)}
    if loose := [p for p in f.points if p not in joints and p not in f.fixed]:
        raise error(Phrase("joint_loose", names=tuple(loose)), "points")
    if 2 * len(joints) != m + r:
        raise error(Phrase("truss_loose" if m + r < 2 * len(joints) else "truss_redundant", **details), "members")
    if two := members_crossing_without_joint(f.points, f.members):
        raise error(Phrase("members_cross", one=two[0], two=two[1]), "members")


def truss_plan(
    draft: Draft, f: Framework, outer: Mapping[str, Force], sizes: Mapping[str, complex], least: float, error: Refusal
) -> CremonaPlan:
    """The plan, from ``outer`` forces of known ``sizes``, N, without those not above ``least`` of the largest."""
    most = max(map(abs, sizes.values()), default=0.0)
    forces = [Outside(n, x.point.label, sizes[n]) for n, x in outer.items() if abs(sizes[n]) > least * most]
    if not forces:
        raise error(Phrase("truss_idle"), "loads")
    regions = Regions(f, forces)
    if joint := regions.letter_regions():
        raise error(Phrase("joint_inside", name=joint), "members")
    plan = CremonaPlan(draft, f, regions, outer)
    if left := plan.draw_cremona_plan():
        raise error(Phrase("members_unreached", names=tuple(left)), "members")
    return plan


def members_crossing_without_joint(places: Mapping[str, complex], members: tuple[NamePair, ...]) -> NamePair | None:
    """The names of two members that cross without a joint; None where there are none."""
    lines = [("".join(m), places[m[0]], places[m[1]], {*m}) for m in members]
    for k, (one, a, b, ends) in enumerate(lines):
        for other, c, d, more in lines[k + 1 :]:
            if not ends & more and _segments_cross(a, b, c, d):
                return one, other
    return None


def _segments_cross(a: complex, b: complex, c: complex, d: complex) -> bool:
    """Whether two segments cross between their ends."""
    sides = [((q - p) * (z - p).conjugate()).imag for p, q, z in ((a, b, c), (a, b, d), (c, d, a), (c, d, b))]
    return sides[0] * sides[1] < 0 and sides[2] * sides[3] < 0
