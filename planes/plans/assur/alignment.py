"""The self-aligning variant: which pairs to loosen so that no constraint is redundant (q = 0).

Somov–Malyshev: W = 6n − 5p₅ − 4p₄ − 3p₃. A planar group of one-freedom pairs holds its n links by 5p constraints where
6n are enough; turning pairs may become cylindrical (2ц) or spherical (3с), sliding ones cylindrical. Counting is not
enough: a rod between two spherical pairs has the right count and still spins. So the out-of-plane constraints are
written down in actual positions of the mechanism, and a variant is accepted only if their matrix has full rank: no
freedom left in the group, and no redundant constraint.
"""

import cmath
import math
from collections.abc import Iterator, Mapping
from contextlib import suppress
from functools import cached_property
from itertools import product
from typing import Literal

from planes.drafting.tools import Things
from planes.geometry.plane import greatest_distance, perpendicular_foot
from planes.plans import Plans
from planes.plans.assur.contours import AnyGroup
from planes.plans.assur.groups import Group, Pair
from planes.plans.scales import drawn_in_si
from planes.scene.mechanism import FRAME
from planes.words import Phrase
from planes.words.errors import PlanFailure, StructureError
from planes.words.frozen import frozen
from planes.words.names import NameTuple
from planes.words.records import Json

Sign = Literal["R", "P", "C", "S"]
PAIR_FREEDOMS: Mapping[Sign, int] = {"R": 1, "P": 1, "C": 2, "S": 3}
"""The motion a pair allows: revolute, prismatic, cylindrical, spherical, with its number of freedoms."""
LOOSER_PAIR_KINDS: Mapping[str, tuple[Sign, ...]] = {"R": ("R", "S", "C"), "P": ("P", "C")}
LEAST_FIRM_DETERMINANT = 1e-6  # a smaller determinant means a loosely held link
EXAMINED_POSITIONS = 24  # positions of the cycle that are examined


@frozen
class Aligned:
    """A variant with q = 0: every pair of the mechanism with its new kind, and the numbers of Somov and Malyshev."""

    n: int
    freedom: int  # the mechanism's planar W
    pairs: tuple[tuple[Pair, Sign], ...]

    @property
    def pair_counts_by_class(self) -> tuple[int, int, int]:
        """The numbers of pairs of the fifth, fourth and third class."""
        return tuple(sum(PAIR_FREEDOMS[sign] == f for _, sign in self.pairs) for f in (1, 2, 3))  # type: ignore[return-value]

    @property
    def degree_of_freedom(self) -> int:
        """The degree of freedom by Somov and Malyshev."""
        p5, p4, p3 = self.pair_counts_by_class
        return 6 * self.n - 5 * p5 - 4 * p4 - 3 * p3

    @property
    def redundant_constraints(self) -> int:
        """Redundant constraints by Malyshev: the mechanism's own freedom less the counted one."""
        return self.freedom - self.degree_of_freedom

    def new_kind_of_pair(self, pair: Pair) -> Sign:
        """The sign of a pair's new kind."""
        return next(sign for p, sign in self.pairs if p == pair)

    def json(self) -> Json:
        """The variant as in ``planes structure --json``."""
        p5, p4, p3 = self.pair_counts_by_class
        kinds = {"R": "revolute", "P": "prismatic", "C": "cylindrical", "S": "spherical"}
        rows = [
            {"pair": p.point or p.guide, "links": [p.other, p.link], "kind": kinds[s], "freedoms": PAIR_FREEDOMS[s]}
            for p, s in self.pairs
        ]
        return {
            "W": self.degree_of_freedom,
            "q": self.redundant_constraints,
            "p5": p5,
            "p4": p4,
            "p3": p3,
            "pairs": rows,
        }


def self_aligning_variant(plans: Plans, file: str = "") -> Aligned:
    """The self-aligning variant of a mechanism; :class:`StructureError` where a group has none or nothing assembles."""
    cycle = _pair_places_in_cycle(plans, file)
    pair_signs: list[tuple[Pair, Sign]] = [(plans.structure.drive_pair, plans.structure.drive_pair.kind)]
    for group in (g for g in plans.structure.groups if not plans.structure.is_driving_cylinder(g)):
        ways = list(_pair_kind_variants(group))
        steady = (w for w in ways if constrains_in_all_positions(group, w, cycle))
        signs = next(steady, None) or next((w for w in ways if constrains_in_all_positions(group, w, cycle[:1])), None)
        if signs is None:
            raise StructureError(Phrase("no_alignment", links=group.links), file)
        pair_signs += zip(group_pairs(group), signs, strict=True)
    return Aligned(len(plans.mechanism.links), plans.structure.W, tuple(pair_signs))


def group_pairs(group: AnyGroup) -> tuple[Pair, ...]:
    """The pairs loosened together: those of a group, and of a cylinder that braces it."""
    if isinstance(group, Group) and group.brace and group.drive:
        return *group.pairs, group.drive, group.brace.near, group.brace.far
    return group.pairs


def bodies_of_pairs(group: AnyGroup) -> tuple[NameTuple, ...]:
    """The bodies that these pairs hold: the links, those rigidly joined by a stopped drive as one."""
    if not isinstance(group, Group):
        mates = {lead.link: lead.lead_links for lead in group.leads}
        return tuple(mates.get(link, (link,)) for link in group.links_in_solving_order)
    if group.brace:
        return *((link,) for link in group.all_links), group.brace.cylinder_links
    return tuple(map(group.links_composing, group.links))


def _pair_kind_variants(group: AnyGroup) -> Iterator[tuple[Sign, ...]]:
    """Ways to loosen a group's pairs by the number of redundant constraints: the fewest changes first, bearings kept
    longest."""
    pairs = group_pairs(group)
    excess = 5 * len(pairs) - 6 * len(bodies_of_pairs(group))
    ways = [
        w
        for w in product(*(LOOSER_PAIR_KINDS[p.kind] for p in pairs))
        if sum(PAIR_FREEDOMS[s] - 1 for s in w) == excess
    ]

    def awkward(way: tuple[Sign, ...]) -> tuple[int, int, int]:
        changed = sum(PAIR_FREEDOMS[s] > 1 for s in way)
        grounded = sum(PAIR_FREEDOMS[s] > 1 for p, s in zip(pairs, way, strict=True) if p.has_link(FRAME))
        sphere_inside = sum(s == "S" for p, s in zip(pairs, way, strict=True) if p in group.inner_pairs)
        return changed, grounded, -sphere_inside

    return iter(sorted(ways, key=awkward))


# the out-of-plane constraints of a pair

Line = tuple[complex, complex]  # a point of it, and its direction


@frozen
class PairPlaces:
    """The places of all pairs in one position of the mechanism."""

    lines: Mapping[Pair, Line]

    @cached_property
    def largest_pair_distance(self) -> float:
        """The distance between the two pairs farthest apart."""
        return greatest_distance([point for point, _ in self.lines.values()]) or 1.0


def _pair_places_in_cycle(plans: Plans, file: str) -> list[PairPlaces]:
    """The place of every pair through the cycle (for a hinge the direction means nothing): first in the drive's own
    position, if it assembles there."""
    wanted = [v.angle for v in plans.links.values() if v.angle] + [m.position for m in plans.points.values()]
    program = plans.program.cut_to_names(wanted)
    drive = plans.drive
    turn = (
        [drive.position + 360.0 * k / EXAMINED_POSITIONS for k in range(1, EXAMINED_POSITIONS)] if drive.rotates else []
    )
    cycle = []
    for value in (drive.position, *turn):
        with suppress(PlanFailure):
            things = drawn_in_si(plans, value, program).things
            cycle.append(PairPlaces({p: _pair_place_and_direction(plans, p, things) for p in plans.structure.pairs}))
    if not cycle:
        raise StructureError(Phrase("no_working"), file)
    return cycle


def _pair_place_and_direction(plans: Plans, pair: Pair, things: Things) -> Line:
    if pair.kind == "R":
        return complex(things[plans.points[pair.point].position]), 1 + 0j
    m = plans.mechanism
    guide = m.guide(pair.guide)
    owner = m.link(pair.other)
    turn = 1 + 0j
    base = 0j
    own = 0j
    if owner.name != FRAME:
        turn = cmath.exp(1j * math.radians(things[plans.links[owner.name].angle]))
        base = complex(things[plans.points[owner.first_point].position])
        own = owner.points[owner.first_point]
    along = turn * cmath.exp(1j * math.radians(guide.angle_deg))
    through = base + (guide.through - own) * turn
    slider = complex(things[plans.points[m.link(pair.link).first_point].position])
    return perpendicular_foot(slider, through, along), along


def constrains_in_all_positions(group: AnyGroup, signs: tuple[Sign, ...], cycle: list[PairPlaces]) -> bool:
    """Whether the out-of-plane constraints of the pairs are exact in all positions: no link loose, none held twice."""
    firmness = [constraint_determinant(group, signs, places) for places in cycle]
    return all(f > LEAST_FIRM_DETERMINANT for f in firmness) or all(f < -LEAST_FIRM_DETERMINANT for f in firmness)


def constraint_determinant(group: AnyGroup, signs: tuple[Sign, ...], places: PairPlaces) -> float:
    """The determinant of the out-of-plane constraints, rows and lengths scaled to unity; 0 means a loose link."""
    bodies = bodies_of_pairs(group)
    column = {link: 3 * k for k, body in enumerate(bodies) for link in body}
    rows = []
    for pair, sign in zip(group_pairs(group), signs, strict=True):
        for held in prevented_motions(sign, pair.kind, *places.lines[pair], places.largest_pair_distance):
            row = [0.0] * (3 * len(bodies))
            for link, side in pair.signed_links:
                if link in column:
                    row[column[link] : column[link] + 3] = [side * x for x in held]
            length = math.hypot(*row)
            rows.append([x / length for x in row])
    return matrix_determinant(rows) if len(rows) == 3 * len(bodies) else 0.0


def matrix_determinant(rows: list[list[float]]) -> float:
    """The determinant of a small square matrix, by elimination with the largest pivots."""
    left = [row[:] for row in rows]
    value = 1.0
    for k in range(len(left)):
        best = max(range(k, len(left)), key=lambda i: abs(left[i][k]))
        if left[best][k] == 0.0:
            return 0.0
        if best != k:
            left[k], left[best], value = left[best], left[k], -value
        value *= left[k][k]
        for i in range(k + 1, len(left)):
            part = left[i][k] / left[k][k]
            left[i] = [x - part * y for x, y in zip(left[i], left[k], strict=True)]
    return value


def prevented_motions(
    sign: Sign, kind: str, place: complex, along: complex, size: float
) -> list[tuple[float, float, float]]:
    """The out-of-plane motions that a pair prevents (z, turn about x, turn about y; lengths over ``size``)."""
    z = place / size
    level = (1.0, z.imag, -z.real)  # the pair stays in the plane
    about_x = (0.0, 1.0, 0.0)
    about_y = (0.0, 0.0, 1.0)
    if sign in ("R", "P"):
        return [level, about_x, about_y]
    if sign == "S":
        return [level]
    if kind == "R":  # a pin in a bushing: it may move along its axis
        return [about_x, about_y]
    return [level, (0.0, -along.imag, along.real)]  # a round rod: it may turn about its axis
