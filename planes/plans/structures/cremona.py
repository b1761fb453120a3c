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
from planes.geometry.plane import sine
from planes.plans.force.loads import Force
from planes.plans.position.bodies import SCHEME, on_scheme
from planes.plans.structures.regions import Regions, Side
from planes.scene.structures import Framework
from planes.words.names import CREMONA, Meaning, at

ALIKE = 1e-6  # the sine of the angle below which members are parallel


@dataclass
class CremonaPlan:
    """The plan under construction: external forces around the truss, then every region from two known ones."""

    draft: Draft
    framework: Framework
    regions: Regions
    outer: Mapping[str, Force]  # external forces by name
    drawn: list[str] = field(default_factory=list)
    joints: dict[str, str] = field(default_factory=dict)  # mark -> its joint
    cuts: dict[str, tuple[str, ...]] = field(default_factory=dict)  # members found by a cut -> all members cut

    def draw(self) -> list[str]:
        """The whole plan; returns the members it cannot reach."""
        self.outside()
        left = dict.fromkeys(r for r in self.regions.right.values() if r not in self.drawn)
        while left:
            region = next((r for r in left if self.crossed(r)), None) or next((r for r in left if self.cut(r)), None)
            if region is None:
                break
            self.drawn.append(region)
            left.pop(region)
        if not left:
            self.close()
        return ["".join(m) for m in self.framework.members if {*self.sides(m)} & left.keys()]

    def outside(self) -> None:
        """The external forces head to tail, clockwise around the truss; the last one closes the polygon."""
        self.draft.pole(CREMONA)
        for f in self.regions.ordered:
            force, (start, end) = self.outer[f.name], (self.regions.before[f.name], self.regions.after[f.name])
            if f is not self.regions.ordered[-1]:
                self.draft.lay(CREMONA, Term(f.name, start, end, force.size, force.along, means=force.means))
            self.draft.show(CREMONA, start, end, f.name)
            self.drawn.append(start)
        ordered = [(f.name, self.regions.before[f.name], self.regions.after[f.name]) for f in self.regions.ordered]
        self.state(Term(*one, drawn=True) for one in ordered)

    def state(self, terms: Iterable[Term]) -> None:
        """Record a closed polygon: the last of its forces closes it."""
        *chain, last = terms
        self.draft.equations.append(Equation(CREMONA, ((*chain, replace(last, drawn=False)), ())))

    def sides(self, member: Side) -> tuple[str, str]:
        """The regions on the left and on the right of a member, seen from its first joint."""
        a, b = member
        return self.regions.right[b, a], self.regions.right[a, b]

    def around(self, region: str) -> Iterator[tuple[Side, str]]:
        """The members of a region with drawn regions on their other side, and those regions."""
        for member in self.framework.members:
            left, right = self.sides(member)
            other = right if left == region else left
            if region in (left, right) and other in self.drawn and other != region:
                yield member, other

    def crossed(self, region: str) -> bool:
        """Draw a region where lines along two of its members meet, those of one joint before others."""
        pairs = [p for p in combinations(self.around(region), 2) if self.turned(p[0][0], p[1][0]) > ALIKE]
        pairs.sort(key=lambda p: not {*p[0][0]} & {*p[1][0]})
        for (one, start), (two, other) in pairs[:1]:
            joint = next(iter({*one} & {*two}), "")
            self.joints[at(CREMONA, region)] = joint
            if joint and self.balanced(joint, region):
                continue
            along, across = (self.draft.ray(SCHEME, *m) for m in (one, two))
            self.draft.step(Cross(at(CREMONA, region), at(CREMONA, start), along, at(CREMONA, other), across))
        return bool(pairs)

    def balanced(self, joint: str, region: str) -> bool:
        """The polygon of a joint by which a region is drawn, if that region is its only unknown."""
        terms = self.regions.around_joint(joint)
        if {x for _, *ends in terms for x in ends} - {*self.drawn, region}:
            return False
        first = next(k for k, (_, start, _) in enumerate(terms) if start == region)
        *chain, last = [self.term(*one, open_=region in one[1:]) for one in (*terms[first + 1 :], *terms[: first + 1])]
        back = replace(last, start=last.end, end=last.start, sign=-last.sign)
        self.draft.meet(CREMONA, chain[:-1], chain[-1], back)
        return True

    def term(self, name: str, start: str, end: str, open_: bool) -> Term:
        """A force around a joint from region to region: drawn before, or a member with a known line."""
        member = next((m for m in self.framework.members if f"S_{m[0]}{m[1]}" == name), None)
        sign = 1 if member is None or self.sides(member) == (start, end) else -1
        if member is None or not open_:
            return Term(name, start, end, drawn=True, sign=sign)
        along = self.draft.ray(SCHEME, *member)
        return Term(name, start, end, None, along, f"∥{member[0]}{member[1]}", sign=sign)

    def close(self) -> None:
        """Close the polygons of members without a drawn joint; each is closed by one of them."""
        drawn = {t.name for e in self.draft.equations if e.plan == CREMONA for t in e.terms}
        for a, b in self.framework.members:
            name = f"S_{a}{b}"
            if name not in drawn:
                terms = self.regions.around_joint(a)
                k = next(k for k, one in enumerate(terms) if one[0] == name)
                chain = [self.term(*one, open_=False) for one in (*terms[k + 1 :], *terms[: k + 1])]
                self.state(chain)
                drawn |= {t.name for t in chain}

    def turned(self, one: Side, two: Side) -> float:
        """The sine of the angle between two members."""
        return sine(self.regions.way(*one), self.regions.way(*two))

    def measure(self) -> dict[str, str]:
        """Every member's force by its name, tension positive."""
        forces = {}
        for a, b in self.framework.members:
            name, (left, right) = f"S_{a}{b}", self.sides((a, b))
            self.draft.show(CREMONA, left, right, name)
            along = self.draft.ray(SCHEME, a, b)
            forces[name] = self.draft.measure(name, at(CREMONA, left), at(CREMONA, right), along)
        return forces

    # cuts

    def cut(self, region: str) -> bool:
        """Draw a region from a known one along a member whose force comes from moments about a cut through three."""
        for member, other in self.around(region):
            for two in combinations([m for m in self.framework.members if m != member], 2):
                part = self.part(member, two)
                if part and self.turned(*two) > ALIKE and (about := self.meeting(member, two)):
                    self.reckon(region, member, other, about, part)
                    self.cuts["".join(member)] = tuple("".join(m) for m in (member, *two))
                    return True
        return False

    def part(self, member: Side, two: tuple[Side, ...]) -> set[str]:
        """The joints on the side of the member's first one, if the truss falls apart without these members; else
        empty."""
        left, reached = [m for m in self.framework.members if m not in (member, *two)], {member[0]}
        while more := {p for m in left if {*m} & reached for p in m} - reached:
            reached |= more
        return reached if all(len({*m} & reached) == 1 for m in (member, *two)) else set()

    def meeting(self, member: Side, two: tuple[Side, Side]) -> str:
        """The intersection of the lines of two cut members, if it is off the line of the first."""
        (a, b), (c, d) = two
        u, v = self.regions.way(a, b), self.regions.way(c, d)
        shift = self.regions.way(a, c)
        place = self.framework.points[a] + u * (shift * v.conjugate()).imag / (u * v.conjugate()).imag
        lever, way = place - self.framework.points[member[0]], self.regions.way(*member)
        if abs((lever * way.conjugate()).imag) <= ALIKE * abs(way) ** 2:
            return ""
        if shared := {*two[0]} & {*two[1]}:
            return on_scheme(shared.pop())
        (along, across), label = (self.draft.ray(SCHEME, *m) for m in two), "R"
        while on_scheme(label) in self.draft.steps:
            label += "′"
        return self.draft.step(Cross(on_scheme(label), on_scheme(a), along, on_scheme(c), across))

    def reckon(self, region: str, member: Side, other: str, about: str, part: set[str]) -> None:
        """The force of a member from the moments of a part of the truss, and the region at its end."""
        d, name = self.draft, f"S_{member[0]}{member[1]}"
        along = d.ray(SCHEME, *member)
        lever, terms = d.arm(name, on_scheme(member[0]), along, about), MomentTerms()
        for f in (f for f in self.regions.forces if f.joint in part and on_scheme(f.joint) != about):
            force = self.outer[f.name]
            arm = d.arm(f.name, force.point, force.along, about)
            terms.append((f.name, arm, Product(-1.0, ((force.size, 1), (arm, 1), (lever, -1)))))
        value = d.balance(f"N_{member[0]}{member[1]}", about, tuple(sorted(part)), terms, lever)
        way = along if self.sides(member)[1] == region else d.reversed(along)
        d.lay_off(CREMONA, region, at(CREMONA, other), way, value, Meaning("load", name))
