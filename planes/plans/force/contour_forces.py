"""The force plan of a group of class IV: the forces along its two leads by a false assumption, then closed polygons.

Moments of the basic link with its leads about its outer hinge (where it slides: forces along its guide), and of the
base about its own, leave two unknowns, the forces along the leads. First the second lead is assumed to carry no axial
force: the first equation then gives the assumed force in the first lead. With it, the second equation gives the true
force in the second lead; the arm there is the combined one of this force and of the force it causes in the first lead.
Then the first force is found again.
"""

from planes.drafting.equations import Term
from planes.drafting.steps.by_leads import CosineFalse, DropFalse
from planes.drafting.steps.reckoning import Cosine, Drop, Product
from planes.plans.assur.contours import Contour
from planes.plans.assur.groups import Pair
from planes.plans.force.lead_forces import HeldLead, LeadForces, PairEnds
from planes.plans.force.loads import Couple, Force, name_of_force
from planes.plans.force.reactions import Reaction
from planes.scene.mechanism import FRAME
from planes.words.frozen import frozen, replace
from planes.words.names import POLE_LABEL, SCHEME_PLAN, Meaning, NameTuple, scheme_mark, split_value_name


@frozen
class _Equilibrium:
    """The equilibrium on an outer pair: its links, and the forces on them except those along the leads."""

    pair: Pair
    links: NameTuple
    forces: list[Force]
    couples: list[Couple]


class ContourForces(LeadForces):
    """The plan of one contour."""

    group: Contour

    def draw(self) -> None:
        self.draft.draw_pole(self.plan)
        pairs = self.group.pairs
        rubs = self.settle_friction(pairs, pairs)
        ends = self.polygon()
        reactions = [r for held in self.drawn for r in self.read_lead_reactions(held, ends, rubs)]
        base, basic = self.group.outer
        felt = self.couples[self.group.base]  # its leads have passed on their loads
        felt += [c for c in self.statics.acting.couples[self.group.base] if c not in felt]
        for pair, link, inner in ((base, self.group.base, []), (basic, self.group.basic, reactions)):
            self.outer_guide_couple(
                pair, link, self.statics.record_reaction(pair, self.plan, *ends[pair], rubs.grips.get(pair)), inner
            )

    def outer_guide_couple(self, pair: Pair, link: str, reaction: Reaction, inner: list[Reaction]) -> None:
        """The couple of an outer guide from the forces on the link, and the loads passed on; the ``inner`` reactions do
        not act on the link yet."""
        if pair.kind == "P":
            reaction = self.seat_guide_reaction(reaction, link, inner)
        if pair.other_link_of_pair(link) != FRAME:
            self.statics.pass_reaction_on(reaction, pair.other_link_of_pair(link))

    def polygon(self) -> PairEnds:
        """Draw the polygons; each reaction is on the first link of its pair."""
        d = self.draft
        g = self.group
        self.drawn = one, two = tuple(map(self.solve_lead_equilibrium, self.leads))
        both = self.forces_along_leads(one, two)
        acting = self.statics.acting.forces
        runs = [one.loads, [*one.known, both[0]], [both[1], *two.known], two.loads, list(acting[g.basic])]
        chain, ends = self.lay_off_force_sequences(runs)
        basic, base = (
            name_of_force(x, pair.other_link_of_pair(x))
            for x, pair in zip((g.basic, g.base), g.outer[::-1], strict=True)
        )
        d.draw_closing_vector(self.plan, chain, basic, ends[-1])
        loads, last = self.statics.lay_off_forces(self.plan, list(acting[g.base]), ends[1])
        back = [
            name_of_force(held.lead.outer.other_link_of_pair(held.lead.link), held.lead.link) for held in (two, one)
        ]
        handed = [Term(name, ends[k], ends[k - 1], drawn=True) for name, k in zip(back, (3, 2), strict=True)]
        d.draw_closing_vector(self.plan, (*handed, *loads), base, last, ends[3])
        sides = (one, (ends[1], ends[2]), (ends[2], POLE_LABEL)), (two, (ends[2], ends[3]), (ends[4], ends[2]))
        pair_ends = {g.outer[0]: self.reaction_on_first_link((g.base,), g.outer[0], (last, ends[3]))}
        pair_ends |= {g.outer[1]: self.reaction_on_first_link((g.basic,), g.outer[1], (ends[-1], POLE_LABEL))}
        for held, outer, inner in sides:
            pair_ends |= {held.lead.outer: self.reaction_on_first_link(held.lead.lead_links, held.lead.outer, outer)}
            pair_ends |= {held.lead.inner: self.reaction_on_first_link(held.lead.lead_links, held.lead.inner, inner)}
        return pair_ends

    def forces_along_leads(self, one: HeldLead, two: HeldLead) -> tuple[Force, Force]:
        """The forces along both leads, on them from the base."""
        g = self.group
        basic = self.basic_link_side(one, two)
        base = self.base_side(one, two)
        arms = [
            self.arm_of_lead_force(one, basic, (one, two)),
            *(self.arm_of_lead_force(*x) for x in ((two, basic), (one, base), (two, base))),
        ]
        supposed = one.force_along_lead_line(self.unknown_by_equilibrium(f"{one.key}^I", basic, [], -1.0, arms[0]))
        reduced = [Product(1.0, ((arms[3], 1),)), Product(-1.0, ((arms[1], 1), (arms[2], 1), (arms[0], -1)))]
        arm = self.draft.add_sum(
            f"h_{two.key}^0", reduced, Meaning("arm", two.key, scheme_mark(g.outer[0].point), g.base)
        )
        second = two.force_along_lead_line(
            self.unknown_by_equilibrium(
                two.other_component_name, base, [self.reversed_force_on_base(supposed, one)], 1.0, arm
            )
        )
        first = self.unknown_by_equilibrium(one.other_component_name, basic, [second], -1.0, arms[0])
        return one.force_along_lead_line(first), second

    def basic_link_side(self, one: HeldLead, two: HeldLead) -> _Equilibrium:
        """The basic link with both leads: loads of a lead that slides on the base pass through its hinge."""
        g = self.group
        s = self.statics
        forces = list(s.acting.forces[g.basic])
        couples = list(self.couples[g.basic])
        for held in (one, two):
            at_hinge = [replace(f, point=held.point) for f in held.loads] if held.slides_on_carrier else held.loads
            forces += at_hinge + held.known
            if not held.slides_on_carrier:
                couples += held.couples
        if g.outer[1].kind == "P":
            forces += self.guide_friction_on_link(
                g.outer[1], g.basic, scheme_mark(self.bodies.mechanism.links[g.basic].first_point)
            )
        return _Equilibrium(g.outer[1], (g.basic, *one.lead.lead_links, *two.lead.lead_links), forces, couples)

    def base_side(self, one: HeldLead, two: HeldLead) -> _Equilibrium:
        """The base: a slider on it presses at its own hinge, with the couple of its loads about that hinge."""
        g = self.group
        s = self.statics
        forces = list(s.acting.forces[g.base])
        couples = list(self.couples[g.base])
        for held in (one, two):
            forces += [self.reversed_force_on_base(f, held) for f in held.known]
            if held.slides_on_carrier:
                couples += self.turning(held)
        if g.outer[0].kind == "P":
            forces += self.guide_friction_on_link(
                g.outer[0], g.base, scheme_mark(self.bodies.mechanism.links[g.base].first_point)
            )
        return _Equilibrium(g.outer[0], (g.base,), forces, couples)

    def turning(self, held: HeldLead) -> list[Couple]:
        """The moment of the loads on a slider about its hinge, which its guide passes on; a force in the hinge has
        none."""
        d = self.draft
        key = name_of_force(self.group.base, held.lead.link)
        terms = self.statics.moments_about_mark(held.point, held.loads, held.couples, 1.0)
        if not terms:
            return []
        name = d.solve_moment_equation(
            f"MR_{key}", held.point, held.lead.lead_links, terms, means=Meaning("couple", key)
        )
        return [Couple(name, self.group.base, name, 1, True)]

    def arm_of_lead_force(
        self, held: HeldLead, side: _Equilibrium, choice: tuple[HeldLead, HeldLead] | None = None
    ) -> str:
        """The arm of a lead's line about an outer hinge; or the component factor of its force along an outer guide."""
        d = self.draft
        pair = side.pair
        about = scheme_mark(pair.point)
        means = Meaning("arm", held.key, about, self.group.basic)
        lines = ("", "", "", "")
        if choice:
            one, two = choice
            lines = one.line, self.line_of_no_effect(one), two.line, self.line_of_no_effect(two)
            means = replace(means, of=self.group.basic)
        if pair.kind == "P":
            along = f"cos_{held.other_component_name}_{pair.guide}", held.line, f"∥{pair.guide}"
            return d.add_step(CosineFalse(*along, lines=lines, means=means) if choice else Cosine(*along))
        own = f"h_{held.key}^n_{about.label}", held.point, held.line, about, SCHEME_PLAN.mu_name
        return d.add_step(DropFalse(*own, lines=lines, means=means) if choice else Drop(*own, means=means))

    def line_of_no_effect(self, held: HeldLead) -> str:
        """The line along which a force on the basic link, at its end of a lead, would not move it."""
        outer = self.group.outer[1]
        inner = held.lead.inner
        if outer.kind == "P":
            return self.draft.draw_perpendicular(f"∥{outer.guide}")
        return self.draft.direction_between_marks(outer.point, inner.point or held.lead.outer.point)

    def unknown_by_equilibrium(self, name: str, side: _Equilibrium, more: list[Force], sign: float, arm: str) -> str:
        """The unknown from an equation of moments about an outer hinge, or of forces along an outer guide."""
        forces = side.forces + more
        if side.pair.kind == "P":
            way = f"∥{side.pair.guide}"
            over = ((arm, -1),)
            return self.draft.add_sum(
                name,
                [Product(sign, ((f.size, 1), (self.component_factor_along_guide(f, way), 1), *over)) for f in forces],
            )
        about = scheme_mark(side.pair.point)
        terms = self.statics.moments_about_mark(about, forces, side.couples, sign, arm)
        return self.draft.solve_moment_equation(name, about, side.links, terms, arm)

    def reversed_force_on_base(self, force: Force, held: HeldLead) -> Force:
        """The force of a lead on the base, reversed."""
        lead = held.lead
        part = split_value_name(force.name)[2]
        back = name_of_force(lead.outer.other_link_of_pair(lead.link), lead.link) + (f"^{part}" if part else "")
        if force.quantity == "reaction":  # of friction
            back = f"{force.name}′"
        return replace(force, name=back, link=self.group.base, along=self.draft.draw_reversed_direction(force.along))
