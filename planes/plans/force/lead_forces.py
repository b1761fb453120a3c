"""The common part of force plans of higher groups: the equilibrium of a lead, its friction, and the reading of the
plan.

One component of a lead's outer reaction follows from the lead's own equilibrium: for a rod by moments about its inner
hinge, for a link that slides on the basic one along that guide. A slider passes its loads on to its hinge.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from planes.drafting.equations import Term
from planes.drafting.steps import Turn
from planes.drafting.steps.reckoning import Cosine, Product
from planes.plans.assur.basic_links import Lead
from planes.plans.assur.contours import Tracked
from planes.plans.assur.groups import Pair
from planes.plans.force.hinges import Slip
from planes.plans.force.loads import Couple, Force, name_of_force
from planes.plans.force.reactions import Reaction, Statics
from planes.plans.force.rubbing import RubbingPlan, Rubs
from planes.scene.mechanism import FRAME
from planes.words.names import POLE_LABEL, Mark, MarkPair, Meaning, NamePair, NameTuple, PlanId, scheme_mark

Ends = MarkPair  # end marks of a reaction
PairEnds = dict[Pair, Ends]


@dataclass
class HeldLead:
    """A lead with its loads: the known component of its outer reaction, and the line of the other component."""

    lead: Lead
    key: str  # the outer reaction on the lead
    known: list[Force]
    line: str
    point: Mark
    loads: list[Force]
    couples: list[Couple]

    @property
    def slides_on_carrier(self) -> bool:
        """Whether it slides on the link that carries it."""
        return self.lead.outer.kind == "P"

    @property
    def other_component_name(self) -> str:
        """The name of the other component."""
        return self.key if self.slides_on_carrier else f"{self.key}^n"

    def force_along_lead_line(self, size: str) -> Force:
        """A force along its line, on it from the base."""
        return Force(size, self.lead.link, size, self.line, self.point, "tangential")


class LeadForces(RubbingPlan):
    """The force plan of a group whose basic link is supported by leads."""

    def __init__(self, statics: Statics, group: Tracked) -> None:
        super().__init__(statics, group)
        self.plan = PlanId("force", *group.links_by_force_plan[0])
        self.leads = self.bodies.leads[group.basic]
        self.couples = {x: list(statics.acting.couples[x]) for x in group.all_links}
        self.slips: Mapping[Pair, Slip] = {}

    def rub(self, rubs: Rubs) -> None:
        """Apply the friction couples of hinges, and the friction of guides, to the links."""
        self.slips = rubs.slips
        super().rub(rubs)

    def lay_off_force_sequences(self, runs: Iterable[list[Force]]) -> tuple[list[Term], list[str]]:
        """Sequences of forces laid off from the pole: their terms, and the start label of each sequence, with that of
        the end."""
        chain = list[Term]()
        ends = [POLE_LABEL]
        for run in runs:
            terms, end = self.statics.lay_off_forces(self.plan, run, ends[-1])
            chain += terms
            ends.append(end)
        return chain, ends

    def solve_lead_equilibrium(self, lead: Lead) -> HeldLead:
        """A lead with the results of its equilibrium."""
        d = self.draft
        outer = lead.outer
        inner = lead.inner
        link = lead.link
        loads = [f for part in lead.lead_links for f in self.statics.acting.forces[part]]
        couples = [c for part in lead.lead_links for c in self.couples[part]]
        key = name_of_force(link, outer.other_link_of_pair(link))
        if outer.kind == "P":
            hinge = scheme_mark(inner.point or self.bodies.mechanism.links[link].first_point)
            return HeldLead(
                lead,
                key,
                self.guide_friction_on_link(outer, link, hinge),
                d.draw_perpendicular(f"∥{outer.guide}"),
                hinge,
                loads,
                couples,
            )
        pivot = scheme_mark(outer.point)
        name = f"{key}^t"
        if inner.kind == "R":
            line = d.direction_between_marks(outer.point, inner.point)
            length = f"l_{outer.point}{inner.point}"
            if not lead.drive:
                length = self.bodies.given_distance(self.bodies.mechanism.links[link], outer.point, inner.point)
            about = scheme_mark(inner.point)
            terms = self.statics.moments_about_mark(about, loads, couples, 1.0, length)
            d.solve_moment_equation(name, about, lead.lead_links, terms, length)
            along = d.draw_perpendicular(line)
        else:
            along = f"∥{inner.guide}"
            line = d.draw_perpendicular(along)
            d.add_sum(
                name,
                [self.force_component_along_guide(f, along) for f in loads] + self.friction_along_lead(lead, inner),
            )
        return HeldLead(lead, key, [Force(name, link, name, along, pivot, "tangential")], line, pivot, loads, couples)

    def friction_along_lead(self, lead: Lead, pair: Pair) -> list[Product]:
        """The friction of a guide that acts along a lead, if there is any."""
        sign = -1.0 if lead.link == pair.link else 1.0
        if pair in self.slips:
            return [Product(sign, ((self.slips[pair].force, 1),))]
        return []

    def guide_friction_on_link(self, pair: Pair, link: str, point: Mark) -> list[Force]:
        """The friction of a guide on one of its links, if there is any."""
        if pair not in self.slips:
            return []
        slip = self.slips[pair]
        along = f"∥{pair.guide}"
        if link != pair.link:
            along = self.draft.add_step(Turn(f"-{along}", along, 2, means=Meaning("along", pair.guide)))
        return [Force(slip.force, link, slip.force, along, point, "reaction")]

    def force_component_along_guide(self, f: Force, along: str) -> Product:
        """The component of a force along a guide, to be balanced."""
        return Product(-1.0, ((f.size, 1), (self.component_factor_along_guide(f, along), 1)))

    def component_factor_along_guide(self, f: Force, along: str) -> str:
        """The component factor of a force along a guide."""
        return self.draft.add_step(Cosine(f"cos_{f.name}_{along.lstrip('∥')}", f.along, along))

    def read_lead_reactions(self, held: HeldLead, ends: Mapping[Pair, Ends], rubs: Rubs) -> list[Reaction]:
        """Both reactions on a lead by the ends of their segments, the couples of sliders, and the loads passed on."""
        lead = held.lead
        s = self.statics
        pairs = lead.outer, lead.inner
        reactions = [s.record_reaction(p, self.plan, *ends[p], rubs.grips.get(p)) for p in pairs]
        if lead.pair_letters == "PP":  # by the loads on the basic link, too
            return reactions
        for k, pair in enumerate(pairs):
            if pair.kind == "P":
                reactions[k] = s.find_slider_couple_and_arm(
                    reactions[k], lead.link, held.point, held.loads, held.couples
                )
        self.pass_reaction_to_carrier(reactions[0], lead)
        if lead.drive:
            s.pass_reaction_on(next(r for r in reactions if r.pair.has_link(lead.drive.link)), lead.drive.link)
        return reactions

    def pass_reaction_to_carrier(self, outer: Reaction, lead: Lead) -> None:
        """Apply the lead's reaction to the link that carries it."""
        if lead.outer.other_link_of_pair(lead.link) != FRAME:
            self.statics.pass_reaction_on(outer, lead.outer.other_link_of_pair(lead.link))

    def seat_guide_reaction(self, reaction: Reaction, link: str, others: list[Reaction]) -> Reaction:
        """A guide's reaction with its couple, from all loads on a link; the ``others`` are reactions already found."""
        s = self.statics
        own = [r for r in others if r.pair.has_link(link)]
        forces = [*s.acting.forces[link], *(s.reaction_as_force(r, link) for r in own)]
        slid = ((r.moment, 1 if r.pair.link == link else -1) for r in own if r.pair.kind == "P")
        handed = (Couple(moment, link, moment, sign, True) for moment, sign in slid)
        first = self.bodies.mechanism.links[link].first_point
        return s.find_slider_couple_and_arm(reaction, link, scheme_mark(first), forces, [*self.couples[link], *handed])

    def reaction_on_first_link(self, links: NameTuple, pair: Pair, ends: NamePair) -> Ends:
        """A reaction on one of the links, with the sign for the first link of its pair."""
        start, end = self.plan.marks(*ends)
        return (start, end) if pair.link in links else (end, start)
