"""The plan of a truss by Cremona and Maxwell: every region is one mark, and the force of a member the segment between
the marks of the regions on its two sides, drawn once. A member pulls at a joint where its segment, taken clockwise
around the joint, points away from it. Where two members reach no region, a cut gives one force (Ritter)."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from itertools import combinations

from planes.drafting.draft import Draft
from planes.drafting.equations import Equation, MomentTerms, Term
from planes.drafting.steps.crossings import Cross
from planes.drafting.steps.reckoning import Product
from planes.geometry.plane import sine_between
from planes.plans.force.loads import Force
from planes.plans.structures.regions import Regions, Side
from planes.scene.structures import Framework
from planes.words.names import (
    CREMONA_PLAN,
    NO_MARK,
    SCHEME_PLAN,
    Mark,
    Meaning,
    NamePair,
    NamesByName,
    NameTuple,
    scheme_mark,
)

PARALLEL_MEMBERS_SINE = 1e-6  # the sine of the angle below which members are parallel


@dataclass
class CremonaPlan:
    """The plan under construction: external forces around the truss, then every region from two known ones."""

    draft: Draft
    framework: Framework
    regions: Regions
    outer: Mapping[str, Force]  # external forces by name
    drawn: list[str] = field(default_factory=list)
    joints: NamesByName = field(default_factory=dict)  # mark -> its joint
    cuts: dict[str, NameTuple] = field(default_factory=dict)  # members found by a cut -> all members cut

    def draw_cremona_plan(self) -> list[str]:
        """The whole plan; returns the members it cannot reach."""
        self.lay_off_external_forces()
        left = dict.fromkeys(r for r in self.regions.right.values() if r not in self.drawn)
        while left:
            region = next((r for r in left if self.draw_region_by_crossing(r)), None) or next(
                (r for r in left if self.draw_region_by_cut(r)), None
            )
            if region is None:
                break
            self.drawn.append(region)
            left.pop(region)
        if not left:
            self.close_remaining_polygons()
        return ["".join(m) for m in self.framework.members if {*self.regions_beside_member(m)} & left.keys()]

    def lay_off_external_forces(self) -> None:
        """The external forces head to tail, clockwise around the truss; the last one closes the polygon."""
        self.draft.draw_pole(CREMONA_PLAN)
        for f in self.regions.ordered:
            force = self.outer[f.name]
            start = self.regions.before[f.name]
            end = self.regions.after[f.name]
            if f is not self.regions.ordered[-1]:
                self.draft.lay_off_known_vector(
                    CREMONA_PLAN, Term(f.name, start, end, force.size, force.along, means=force.meaning_of_mark)
                )
            self.draft.name_segment(CREMONA_PLAN, start, end, f.name)
            self.drawn.append(start)
        ordered = [(f.name, self.regions.before[f.name], self.regions.after[f.name]) for f in self.regions.ordered]
        self.record_closed_polygon(Term(*one, drawn=True) for one in ordered)

    def record_closed_polygon(self, terms: Iterable[Term]) -> None:
        """Record a closed polygon: the last of its forces closes it."""
        *chain, last = terms
        self.draft.equations.append(Equation(CREMONA_PLAN, ((*chain, replace(last, drawn=False)), ())))

    def regions_beside_member(self, member: Side) -> NamePair:
        """The regions on the left and on the right of a member, seen from its first joint."""
        a, b = member
        return self.regions.right[b, a], self.regions.right[a, b]

    def drawn_neighbour_regions(self, region: str) -> Iterator[tuple[Side, str]]:
        """The members of a region with drawn regions on their other side, and those regions."""
        for member in self.framework.members:
            left, right = self.regions_beside_member(member)
            other = right if left == region else left
            if region in (left, right) and other in self.drawn and other != region:
                yield member, other

    def draw_region_by_crossing(self, region: str) -> bool:
        """Draw a region where lines along two of its members meet, those of one joint before others."""
        pairs = [
            p
            for p in combinations(self.drawn_neighbour_regions(region), 2)
            if self.sine_between_members(p[0][0], p[1][0]) > PARALLEL_MEMBERS_SINE
        ]
        pairs.sort(key=lambda p: not {*p[0][0]} & {*p[1][0]})
        for (one, start), (two, other) in pairs[:1]:
            joint = next(iter({*one} & {*two}), "")
            self.joints[CREMONA_PLAN.mark(region)] = joint
            if joint and self.draw_joint_polygon_for_region(joint, region):
                continue
            along, across = (self.draft.direction_between_marks(*m) for m in (one, two))
            self.draft.add_step(Cross(*CREMONA_PLAN.marks(region, start), along, CREMONA_PLAN.mark(other), across))
        return bool(pairs)

    def draw_joint_polygon_for_region(self, joint: str, region: str) -> bool:
        """The polygon of a joint by which a region is drawn, if that region is its only unknown."""
        terms = self.regions.forces_around_joint(joint)
        if {x for _, *ends in terms for x in ends} - {*self.drawn, region}:
            return False
        first = next(k for k, (_, start, _) in enumerate(terms) if start == region)
        *chain, last = [
            self.force_term_between_regions(*one, open_=region in one[1:])
            for one in (*terms[first + 1 :], *terms[: first + 1])
        ]
        back = replace(last, start=last.end, end=last.start, sign=-last.sign)
        self.draft.lay_off_until_meeting(CREMONA_PLAN, chain[:-1], chain[-1], back)
        return True

    def force_term_between_regions(self, name: str, start: str, end: str, open_: bool) -> Term:
        """A force around a joint from region to region: drawn before, or a member with a known line."""
        member = next((m for m in self.framework.members if f"S_{m[0]}{m[1]}" == name), None)
        sign = 1 if member is None or self.regions_beside_member(member) == (start, end) else -1
        if member is None or not open_:
            return Term(name, start, end, drawn=True, sign=sign)
        along = self.draft.direction_between_marks(*member)
        return Term(name, start, end, None, along, f"∥{member[0]}{member[1]}", sign=sign)

    def close_remaining_polygons(self) -> None:
        """Close the polygons of members without a drawn joint; each is closed by one of them."""
        drawn = {t.name for e in self.draft.equations if e.plan == CREMONA_PLAN for t in e.all_terms}
        for a, b in self.framework.members:
            name = f"S_{a}{b}"
            if name not in drawn:
                terms = self.regions.forces_around_joint(a)
                k = next(k for k, one in enumerate(terms) if one[0] == name)
                chain = [
                    self.force_term_between_regions(*one, open_=False) for one in (*terms[k + 1 :], *terms[: k + 1])
                ]
                self.record_closed_polygon(chain)
                drawn |= {t.name for t in chain}

    def sine_between_members(self, one: Side, two: Side) -> float:
        """The sine of the angle between two members."""
        return sine_between(self.regions.vector_between_joints(*one), self.regions.vector_between_joints(*two))

    def measure_member_forces(self) -> NamesByName:
        """Every member's force by its name, tension positive."""
        forces = {}
        for a, b in self.framework.members:
            name = f"S_{a}{b}"
            left, right = self.regions_beside_member((a, b))
            self.draft.name_segment(CREMONA_PLAN, left, right, name)
            along = self.draft.direction_between_marks(a, b)
            forces[name] = self.draft.measure_segment(name, *CREMONA_PLAN.marks(left, right), along)
        return forces

    # cuts

    def draw_region_by_cut(self, region: str) -> bool:
        """Draw a region from a known one along a member whose force comes from moments about a cut through three."""
        for member, other in self.drawn_neighbour_regions(region):
            for two in combinations([m for m in self.framework.members if m != member], 2):
                part = self.joints_on_one_side_of_cut(member, two)
                if (
                    part
                    and self.sine_between_members(*two) > PARALLEL_MEMBERS_SINE
                    and (about := self.meeting(member, two))
                ):
                    self.lay_off_member_force_by_moments(region, member, other, about, part)
                    self.cuts["".join(member)] = tuple(map("".join, (member, *two)))
                    return True
        return False

    def joints_on_one_side_of_cut(self, member: Side, two: tuple[Side, ...]) -> set[str]:
        """The joints on the side of the member's first one, if the truss falls apart without these members; else
        empty."""
        left = [m for m in self.framework.members if m not in (member, *two)]
        reached = {member[0]}
        while more := {p for m in left if {*m} & reached for p in m} - reached:
            reached |= more
        if all(len({*m} & reached) == 1 for m in (member, *two)):
            return reached
        return set()

    def meeting(self, member: Side, two: tuple[Side, Side]) -> Mark:
        """The intersection of the lines of two cut members, if it is off the line of the first."""
        (a, b), (c, d) = two
        u = self.regions.vector_between_joints(a, b)
        v = self.regions.vector_between_joints(c, d)
        shift = self.regions.vector_between_joints(a, c)
        place = self.framework.points[a] + u * (shift * v.conjugate()).imag / (u * v.conjugate()).imag
        lever = place - self.framework.points[member[0]]
        way = self.regions.vector_between_joints(*member)
        if abs((lever * way.conjugate()).imag) <= PARALLEL_MEMBERS_SINE * abs(way) ** 2:
            return NO_MARK
        if shared := {*two[0]} & {*two[1]}:
            return scheme_mark(shared.pop())
        along, across = (self.draft.direction_between_marks(*m) for m in two)
        label = "R"
        while scheme_mark(label) in self.draft.steps:
            label += "′"
        return self.draft.draw_mark(Cross(*SCHEME_PLAN.marks(label, a), along, scheme_mark(c), across))

    def lay_off_member_force_by_moments(
        self, region: str, member: Side, other: str, about: Mark, part: set[str]
    ) -> None:
        """The force of a member from the moments of a part of the truss, and the region at its end."""
        d = self.draft
        name = f"S_{member[0]}{member[1]}"
        along = d.direction_between_marks(*member)
        lever = d.draw_arm(name, scheme_mark(member[0]), along, about)
        terms = MomentTerms()
        for f in (f for f in self.regions.forces if f.joint in part and scheme_mark(f.joint) != about):
            force = self.outer[f.name]
            arm = d.draw_arm(f.name, force.point, force.along, about)
            terms.append((f.name, arm, Product(-1.0, ((force.size, 1), (arm, 1), (lever, -1)))))
        value = d.solve_moment_equation(f"N_{member[0]}{member[1]}", about, tuple(sorted(part)), terms, lever)
        way = along if self.regions_beside_member(member)[1] == region else d.draw_reversed_direction(along)
        d.lay_off(CREMONA_PLAN, region, CREMONA_PLAN.mark(other), way, value, Meaning("load", name))
