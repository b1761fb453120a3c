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
from planes.plans.force.lead_forces import Ends, HeldLead, LeadForces, PairEnds
from planes.plans.force.loads import Force, force_name
from planes.plans.force.reactions import Reaction, Statics
from planes.plans.force.rubbing import settled
from planes.plans.position.bodies import SCHEME, on_scheme
from planes.words.names import POLE, end_of, force_plan, label_of


class BasicLinkForces(LeadForces):
    """Force plans of one basic link, or of several, with their leads."""

    def moments(
        self, basic: str, held: Sequence[HeldLead], special: str, name: str, arm: str, links: tuple[str, ...]
    ) -> str:
        """The only unknown in the moments of a basic link with its leads about its special point, by its ``arm``."""
        forces, couples = list(self.statics.acting.forces[basic]), list(self.couples[basic])
        for lead in held:
            if lead.slider:  # a slider has no rotation: all its loads pass through its hinge
                forces += [replace(f, point=lead.point) for f in (*lead.loads, *lead.known)]
            else:
                forces += [*lead.loads, *lead.known]
                couples += lead.couples
        terms = self.statics.moment_terms(special, forces, couples, -1.0, arm)
        return self.draft.balance(name, special, links, terms, arm)

    def third(self, basic: str, held: Sequence[HeldLead], special: str, links: tuple[str, ...]) -> Force:
        """The reaction of the last of three leads along its line; the others meet in the special point."""
        *_, three = held
        arm = self.draft.arm(three.part, three.point, three.line, special, three.lead.link)
        return three.along_line(self.moments(basic, held, special, three.part, arm, links))

    def closed(self, basic: str, held: Sequence[HeldLead], known: list[Force]) -> PairEnds:
        """Draw the polygon of a basic link: two leads close it, where all forces on the third, or on the link from
        another one, are ``known``. Each reaction is on the first link of its pair."""
        one, two, *others = held
        own = list(self.statics.acting.forces[basic])
        chain, ends = self.laid([[*two.known, *two.loads], known, own, [*one.loads, *one.known]])
        x = end_of(one.part)
        last = Term(one.part, ends[-1], x, None, one.line, one.line)
        back = Term(two.part, POLE, x, None, two.line, two.line, sign=-1)
        self.draft.meet(self.plan, chain, last, back)
        starts = {term.end: term.start for term in chain}
        begins = starts[end_of(one.known[0].name)] if one.known else ends[-1]
        beyond = end_of(two.known[-1].name) if two.known else POLE
        ends_of_pairs = self.reactions(one.lead, (begins, x), (x, ends[3])) | self.reactions(
            two.lead, (x, beyond), (ends[1], x)
        )
        for three in others:
            first = [*three.known, known[-1]][0]  # the force along its line
            ends_of_pairs |= self.reactions(three.lead, (starts[end_of(first.name)], ends[2]), (ends[2], ends[1]))
        return ends_of_pairs

    def reactions(self, lead: Lead, outer: Ends, inner: Ends) -> PairEnds:
        """The reactions on a lead; where the lead is another basic link both are the same, that of the hinge."""
        return {lead.inner: self.on(lead.parts, lead.inner, inner), lead.outer: self.on(lead.parts, lead.outer, outer)}


class TriadForces(BasicLinkForces):
    """The plan of one triad."""

    def __init__(self, statics: Statics, group: Triad) -> None:
        super().__init__(statics, group)
        self.group, self.special = group, "" if group.slid else on_scheme(self.bodies.special(group.basic))

    def draw(self) -> None:
        self.draft.pole(self.plan)
        pairs = self.group.pairs
        rubs = settled(self, lambda s: TriadForces(s, self.group), pairs, pairs)
        ends = self.polygon()
        reactions = [r for held in self.drawn for r in self.read(held, ends, rubs)]
        if self.group.slid:
            lead, basic = self.drawn[2].lead, self.group.basic
            inner = self.seated(reactions[5], basic, reactions[:4])
            outer = self.seated(reactions[4], lead.link, [inner])
            self.handed_on(outer, lead)

    def polygon(self) -> PairEnds:
        """Draw the polygon; each reaction is on the first link of its pair."""
        g = self.group
        self.drawn = tuple(self.held(lead) for lead in self.leads)
        *_, three = self.drawn
        pushed = self.slid(three) if g.slid else self.third(g.basic, self.drawn, self.special, g.balanced)
        return self.closed(g.basic, self.drawn, [*three.loads, *three.known, pushed])

    def slid(self, held: HeldLead) -> Force:
        """The reaction on a lead that slides at both ends, by the forces along its other guide alone."""
        d, name = self.draft, held.part
        along = f"∥{held.lead.inner.guide}"
        over = ((d.step(Cosine(f"cos_{name}_{held.lead.inner.guide}", held.line, along)), -1),)
        products = [self.along(f, along) for f in (*held.loads, *held.known)]
        products += self.rubbed(held.lead, held.lead.inner)
        d.total(name, [replace(p, factors=(*p.factors, *over)) for p in products])
        return held.along_line(name)


class ChainForces(BasicLinkForces):
    """The plans of a chain of basic links with their leads."""

    def __init__(self, statics: Statics, group: BasicChain) -> None:
        super().__init__(statics, group)
        self.group, self.last = group, self.leads[-1]
        self.special = [on_scheme(self.bodies.special(basic)) for basic in group.basics]
        self.plans = [force_plan(*links) for links in group.balances]
        self.drawn: dict[int, list[HeldLead]] = {}  # basic links that act as leads, from the root on

    def draw(self) -> None:
        for plan in self.plans:
            self.draft.pole(plan)
        pairs = self.group.pairs
        rubs = settled(self, lambda s: ChainForces(s, self.group), pairs, pairs)
        ends = self.polygon()
        for hinge, reaction in self.found.items():
            self.statics.react(hinge, reaction.plan, *ends[hinge], rubs.grips.get(hinge))
        for k, leads in self.drawn.items():
            self.plan = self.plans[k]
            for held in leads:
                self.read(held, ends, rubs)

    def polygon(self) -> PairEnds:
        """Draw all polygons; each reaction is on the first link of its pair."""
        g, k = self.group, self.group.root(self.last)
        self.found: dict[Pair, Reaction] = {}
        self.held_by: dict[int, list[HeldLead]] = {}
        three = sorted(self.all_held(k), key=lambda h: h.lead.inner == self.last.inner)
        pushed = self.third(g.basics[k], three, self.special[k], g.side(k))
        return self.balanced(k, three, [*three[2].loads, *three[2].known, pushed])

    def all_held(self, k: int, but: Pair | None = None) -> list[HeldLead]:
        """The leads of a basic link, including other basic links except the one at that hinge."""
        g = self.group
        held = [self.held(lead) for lead in g.sides[k]]
        for hinge, ends in zip(g.hinges, g.joined, strict=True):
            if k in ends and hinge != but:
                held.append(self.joint(hinge, k, sum(ends) - k))
        self.held_by[k] = held
        return held

    def joint(self, hinge: Pair, k: int, end: int) -> HeldLead:
        """The force of a basic link on the next one: the component across the line to its special point is known."""
        d, g, special, pin = self.draft, self.group, self.special[end], on_scheme(hinge.point)
        key, name = force_name(g.basics[k], g.basics[end]), f"{force_name(g.basics[k], g.basics[end])}^t"
        line = d.ray(SCHEME, hinge.point, label_of(special))
        length = d.measure(f"l_{hinge.point}{label_of(special)}", pin, special)
        self.moments(g.basics[end], self.all_held(end, hinge), special, name, length, g.side(end))
        across = Force(name, g.basics[k], name, d.square(line), pin, "tangential")
        return HeldLead(Lead(g.basics[k], hinge, hinge), key, [across], line, pin, [], [])

    def balanced(self, k: int, held: list[HeldLead], known: list[Force]) -> PairEnds:
        """The polygon of a basic link, then those of the links that lead to it, with the forces in their hinges
        known."""
        g = self.group
        self.plan = self.plans[k]
        ends = self.closed(g.basics[k], held, known)
        self.drawn[k] = [h for h in held if h.lead in g.leads]
        for lead in (h.lead for h in held if h.lead not in g.leads):
            hinge, end = lead.inner, lead.inner.mate(g.basics[k])
            reaction = Reaction(force_name(hinge.link, hinge.other), self.plans[k], *ends[hinge], hinge)
            self.found[hinge] = reaction
            other = g.basics.index(end)
            ends |= self.balanced(other, self.held_by[other], [self.statics.as_force(reaction, end)])
        return ends
