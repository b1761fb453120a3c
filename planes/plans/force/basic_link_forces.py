"""Reactions on a basic link: that of one lead by moments about the special point of the two others, those of the others
by a polygon of all forces on the link and its leads.

The reactions of the two leads that meet in S pass through it, so the moments of the whole about S have one unknown. A
triad has one polygon. Of several basic links joined by hinges, each acts as a lead of the next, along the line from
their hinge to its special point, until one has three. The moments about the special point give the hinge force across
that line, as those of a rod about its hinge do; the force along the line is found like that of any lead. Each has its
polygon.
"""

from collections.abc import Sequence
from dataclasses import replace

from planes.drafting.equations import Term
from planes.drafting.steps.reckoning import Cosine
from planes.plans.assur.basic_chains import BasicChain
from planes.plans.assur.basic_links import Lead, Triad
from planes.plans.assur.groups import Pair
from planes.plans.force.lead_forces import HeldLead, LeadForces, PairEnds
from planes.plans.force.loads import Force, name_of_force
from planes.plans.force.reactions import Reaction, Statics
from planes.words.names import NO_MARK, POLE_LABEL, Mark, NamePair, NameTuple, PlanId, scheme_mark, vector_end_label


class BasicLinkForces(LeadForces):
    """Force plans of one basic link, or of several, with their leads."""

    def unknown_by_moments(
        self, basic: str, held: Sequence[HeldLead], special: Mark, name: str, arm: str, links: NameTuple
    ) -> str:
        """The only unknown in the moments of a basic link with its leads about its special point, by its ``arm``."""
        forces = list(self.statics.acting.forces[basic])
        couples = list(self.couples[basic])
        for lead in held:
            if lead.slides_on_carrier:  # a slider has no rotation: all its loads pass through its hinge
                forces += [replace(f, point=lead.point) for f in (*lead.loads, *lead.known)]
            else:
                forces += lead.loads + lead.known
                couples += lead.couples
        terms = self.statics.moments_about_mark(special, forces, couples, -1.0, arm)
        return self.draft.solve_moment_equation(name, special, links, terms, arm)

    def third_lead_reaction(self, basic: str, held: Sequence[HeldLead], special: Mark, links: NameTuple) -> Force:
        """The reaction of the last of three leads along its line; the others meet in the special point."""
        *_, three = held
        arm = self.draft.draw_arm(three.other_component_name, three.point, three.line, special, three.lead.link)
        return three.force_along_lead_line(
            self.unknown_by_moments(basic, held, special, three.other_component_name, arm, links)
        )

    def draw_basic_link_polygon(self, basic: str, held: Sequence[HeldLead], known: list[Force]) -> PairEnds:
        """Draw the polygon of a basic link: two leads close it, where all forces on the third, or on the link from
        another one, are ``known``. Each reaction is on the first link of its pair."""
        one, two, *others = held
        own = list(self.statics.acting.forces[basic])
        chain, ends = self.lay_off_force_sequences([two.known + two.loads, known, own, one.loads + one.known])
        x = vector_end_label(one.other_component_name)
        last = Term(one.other_component_name, ends[-1], x, None, one.line, one.line)
        back = Term(two.other_component_name, POLE_LABEL, x, None, two.line, two.line, sign=-1)
        self.draft.lay_off_until_meeting(self.plan, chain, last, back)
        starts = {term.end: term.start for term in chain}
        begins = starts[vector_end_label(one.known[0].name)] if one.known else ends[-1]
        beyond = vector_end_label(two.known[-1].name) if two.known else POLE_LABEL
        ends_of_pairs = self.reactions_on_lead(one.lead, (begins, x), (x, ends[3])) | self.reactions_on_lead(
            two.lead, (x, beyond), (ends[1], x)
        )
        for three in others:
            first = [*three.known, known[-1]][0]  # the force along its line
            ends_of_pairs |= self.reactions_on_lead(
                three.lead, (starts[vector_end_label(first.name)], ends[2]), (ends[2], ends[1])
            )
        return ends_of_pairs

    def reactions_on_lead(self, lead: Lead, outer: NamePair, inner: NamePair) -> PairEnds:
        """The reactions on a lead; where the lead is another basic link both are the same, that of the hinge."""
        return {
            lead.inner: self.reaction_on_first_link(lead.lead_links, lead.inner, inner),
            lead.outer: self.reaction_on_first_link(lead.lead_links, lead.outer, outer),
        }


class TriadForces(BasicLinkForces):
    """The plan of one triad."""

    group: Triad

    def __init__(self, statics: Statics, group: Triad) -> None:
        super().__init__(statics, group)
        self.special = NO_MARK if group.is_on_slides else scheme_mark(self.bodies.special_point_name(group.basic))

    def draw(self) -> None:
        self.draft.draw_pole(self.plan)
        pairs = self.group.pairs
        rubs = self.settle_friction(pairs, pairs)
        ends = self.polygon()
        reactions = [r for held in self.drawn for r in self.read_lead_reactions(held, ends, rubs)]
        if self.group.is_on_slides:
            lead = self.drawn[2].lead
            basic = self.group.basic
            inner = self.seat_guide_reaction(reactions[5], basic, reactions[:4])
            outer = self.seat_guide_reaction(reactions[4], lead.link, [inner])
            self.pass_reaction_to_carrier(outer, lead)

    def polygon(self) -> PairEnds:
        """Draw the polygon; each reaction is on the first link of its pair."""
        g = self.group
        self.drawn = tuple(map(self.solve_lead_equilibrium, self.leads))
        *_, three = self.drawn
        pushed = (
            self.reaction_of_slid_lead(three)
            if g.is_on_slides
            else self.third_lead_reaction(g.basic, self.drawn, self.special, g.balanced_links)
        )
        return self.draw_basic_link_polygon(g.basic, self.drawn, [*three.loads, *three.known, pushed])

    def reaction_of_slid_lead(self, held: HeldLead) -> Force:
        """The reaction on a lead that slides at both ends, by the forces along its other guide alone."""
        d = self.draft
        name = held.other_component_name
        along = f"∥{held.lead.inner.guide}"
        over = ((d.add_step(Cosine(f"cos_{name}_{held.lead.inner.guide}", held.line, along)), -1),)
        products = [self.force_component_along_guide(f, along) for f in (*held.loads, *held.known)]
        products += self.friction_along_lead(held.lead, held.lead.inner)
        d.add_sum(name, [replace(p, factors=p.factors + over) for p in products])
        return held.force_along_lead_line(name)


class ChainForces(BasicLinkForces):
    """The plans of a chain of basic links with their leads."""

    group: BasicChain

    def __init__(self, statics: Statics, group: BasicChain) -> None:
        super().__init__(statics, group)
        self.last = self.leads[-1]
        self.special = [scheme_mark(self.bodies.special_point_name(basic)) for basic in group.basics]
        self.plans = [PlanId("force", *links) for links in group.links_by_force_plan]
        self.drawn: dict[int, list[HeldLead]] = {}  # basic links that act as leads, from the root on

    def draw(self) -> None:
        for plan in self.plans:
            self.draft.draw_pole(plan)
        pairs = self.group.pairs
        rubs = self.settle_friction(pairs, pairs)
        ends = self.polygon()
        for hinge, reaction in self.found.items():
            self.statics.record_reaction(hinge, reaction.plan, *ends[hinge], rubs.grips.get(hinge))
        for k, leads in self.drawn.items():
            self.plan = self.plans[k]
            for held in leads:
                self.read_lead_reactions(held, ends, rubs)

    def polygon(self) -> PairEnds:
        """Draw all polygons; each reaction is on the first link of its pair."""
        g = self.group
        k = self.group.root_basic_link(self.last)
        self.found: dict[Pair, Reaction] = {}
        self.held_by: dict[int, list[HeldLead]] = {}
        three = sorted(self.leads_of_basic_link(k), key=lambda h: h.lead.inner == self.last.inner)
        pushed = self.third_lead_reaction(g.basics[k], three, self.special[k], g.basic_link_with_leads(k))
        return self.draw_polygons_leading_here(k, three, [*three[2].loads, *three[2].known, pushed])

    def leads_of_basic_link(self, k: int, but: Pair | None = None) -> list[HeldLead]:
        """The leads of a basic link, including other basic links except the one at that hinge."""
        g = self.group
        held = [self.solve_lead_equilibrium(lead) for lead in g.sides[k]]
        for hinge, ends in zip(g.hinges, g.basic_links_at_hinges, strict=True):
            if k in ends and hinge != but:
                held.append(self.force_on_next_basic_link(hinge, k, sum(ends) - k))
        self.held_by[k] = held
        return held

    def force_on_next_basic_link(self, hinge: Pair, k: int, end: int) -> HeldLead:
        """The force of a basic link on the next one: the component across the line to its special point is known."""
        d = self.draft
        g = self.group
        special = self.special[end]
        pin = scheme_mark(hinge.point)
        key = name_of_force(g.basics[k], g.basics[end])
        name = f"{key}^t"
        line = d.direction_between_marks(hinge.point, special.label)
        length = d.measure_segment(f"l_{hinge.point}{special.label}", pin, special)
        self.unknown_by_moments(
            g.basics[end], self.leads_of_basic_link(end, hinge), special, name, length, g.basic_link_with_leads(end)
        )
        across = Force(name, g.basics[k], name, d.draw_perpendicular(line), pin, "tangential")
        return HeldLead(Lead(g.basics[k], hinge, hinge), key, [across], line, pin, [], [])

    def draw_polygons_leading_here(self, k: int, held: list[HeldLead], known: list[Force]) -> PairEnds:
        """The polygon of a basic link, then those of the links that lead to it, with the forces in their hinges
        known."""
        g = self.group
        self.plan = self.plans[k]
        ends = self.draw_basic_link_polygon(g.basics[k], held, known)
        self.drawn[k] = [h for h in held if h.lead in g.leads]
        for lead in (h.lead for h in held if h.lead not in g.leads):
            hinge = lead.inner
            end = hinge.other_link_of_pair(g.basics[k])
            reaction = Reaction(name_of_force(hinge.link, hinge.other), self.plans[k], *ends[hinge], hinge)
            self.found[hinge] = reaction
            other = g.basics.index(end)
            ends |= self.draw_polygons_leading_here(
                other, self.held_by[other], [self.statics.reaction_as_force(reaction, end)]
            )
        return ends
