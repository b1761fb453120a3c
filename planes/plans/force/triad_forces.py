"""The force plan of a triad: the third lead's reaction by moments about S, then one polygon of the whole group.

The reactions of the two leads that meet in S pass it, so moments of the whole group about S have one unknown.
"""

from dataclasses import replace

from planes.drafting.draft import Moments
from planes.drafting.equations import Equation, Term
from planes.drafting.steps.reckoning import Cosine, Drop
from planes.plans.assur.basic_links import Triad
from planes.plans.assur.groups import Pair
from planes.plans.force.lead_forces import Ends, HeldLead, LeadForces
from planes.plans.force.loads import Force
from planes.plans.force.reactions import Statics, chain_of
from planes.plans.force.rubbing import settled
from planes.plans.position.bodies import SCHEME
from planes.words.names import POLE, Meaning, at, end_of, label_of, mu_of


class TriadForces(LeadForces):
    """The plan of one triad."""

    def __init__(self, statics: Statics, group: Triad) -> None:
        super().__init__(statics, group)
        self.group, self.special = group, "" if group.slid else at(SCHEME, self.bodies.special(group.basic))

    def draw(self) -> None:
        self.draft.pole(self.plan)
        pairs = self.group.pairs
        rubs = settled(self, lambda s: TriadForces(s, self.group), pairs, pairs)
        ends = self.polygon()
        found = [r for held in self.drawn for r in self.read(held, ends, rubs)]
        if self.group.slid:
            lead, basic = self.drawn[2].lead, self.group.basic
            inner = self.seated(found[5], basic, found[:4])
            outer = self.seated(found[4], lead.link, [inner])
            self.handed_on(outer, lead)

    def polygon(self) -> dict[Pair, Ends]:
        """Draw the polygon; the reaction of each pair on the pair's own first link."""
        self.drawn = one, two, three = tuple(self.held(lead) for lead in self.leads)
        pushed = self.slid(three) if self.group.slid else self.third(one, two, three)
        own = list(self.statics.acting.forces[self.group.basic])
        runs = [[*two.known, *two.loads], [*three.loads, *three.known, pushed], own, [*one.loads, *one.known]]
        ends, chain = [POLE], list[Term]()
        for run in runs:
            chain += chain_of(run, ends[-1])
            ends.append(chain[-1].end if chain else POLE)
        for term in chain:
            self.draft.lay(self.plan, term)
        x = end_of(one.part)
        last = Term(one.part, ends[-1], x, None, one.line, one.line)
        back = Term(two.part, POLE, x, length=None, direction=two.line, action=two.line, drawn=False, sign=-1)
        self.draft.draw(Equation(self.plan, ((*chain, last), (back,))))
        starts = {term.end: term.start for term in chain}
        begins = starts[end_of(one.known[0].name)] if one.known else ends[-1]
        found = dict[Pair, Ends]()
        for held, outer, inner in (
            (one, (begins, x), (x, ends[3])),
            (two, (x, end_of(two.known[-1].name) if two.known else POLE), (ends[1], x)),
            (three, (starts[end_of((*three.known, pushed)[0].name)], ends[2]), (ends[2], ends[1])),
        ):
            found |= {held.lead.outer: self.on(held.lead.parts, held.lead.outer, outer)}
            found |= {held.lead.inner: self.on(held.lead.parts, held.lead.inner, inner)}
        return found

    def third(self, one: HeldLead, two: HeldLead, three: HeldLead) -> Force:
        """The reaction of the third lead along its line, by moments of the whole group about S."""
        d, basic = self.draft, self.group.basic
        forces, couples = list(self.statics.acting.forces[basic]), list(self.couples[basic])
        for held in (one, two, three):
            if held.slider:  # a slider turns nowhere: all its loads pass its hinge
                forces += [replace(f, point=held.point) for f in (*held.loads, *held.known)]
            else:
                forces += [*held.loads, *held.known]
                couples += held.couples
        centre = label_of(self.special)
        means, name = Meaning("arm", three.part, self.special, three.lead.link), f"h_{three.part}_{centre}"
        arm = d.step(Drop(name, three.point, three.line, self.special, mu_of(SCHEME), means=means))
        products, shown = self.statics.moment_terms(self.special, forces, couples, -1.0, arm)
        name = d.total(three.part, products)
        d.moments.append(Moments(centre, self.group.balanced, shown, name, arm))
        return Force(name, three.lead.link, name, three.line, three.point, "tangential")

    def slid(self, held: HeldLead) -> Force:
        """The reaction on a lead that slides at both ends, by what acts along its other guide: nothing else does."""
        d, name = self.draft, held.part
        along = f"∥{held.lead.inner.guide}"
        over = ((d.step(Cosine(f"cos_{name}_{held.lead.inner.guide}", held.line, along)), -1),)
        products = [self.along(f, along) for f in (*held.loads, *held.known)]
        products += self.rubbed(held.lead, held.lead.inner)
        d.total(name, [replace(p, factors=(*p.factors, *over)) for p in products])
        return Force(name, held.lead.link, name, held.line, held.point, "tangential")
