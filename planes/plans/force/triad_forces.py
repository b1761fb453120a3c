"""The force plan of a triad: the third lead's reaction by moments about S, then one polygon of the whole group."""

from dataclasses import replace

from planes.drafting.steps.reckoning import Cosine
from planes.plans.assur.basic_links import Triad
from planes.plans.assur.groups import Pair
from planes.plans.force.basic_link_forces import BasicLinkForces
from planes.plans.force.lead_forces import Ends, HeldLead
from planes.plans.force.loads import Force
from planes.plans.force.reactions import Statics
from planes.plans.force.rubbing import settled
from planes.plans.position.bodies import SCHEME
from planes.words.names import at


class TriadForces(BasicLinkForces):
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
        g = self.group
        self.drawn = tuple(self.held(lead) for lead in self.leads)
        *_, three = self.drawn
        pushed = self.slid(three) if g.slid else self.third(g.basic, self.drawn, self.special, g.balanced)
        return self.closed(g.basic, self.drawn, [*three.loads, *three.known, pushed])

    def slid(self, held: HeldLead) -> Force:
        """The reaction on a lead that slides at both ends, by what acts along its other guide: nothing else does."""
        d, name = self.draft, held.part
        along = f"∥{held.lead.inner.guide}"
        over = ((d.step(Cosine(f"cos_{name}_{held.lead.inner.guide}", held.line, along)), -1),)
        products = [self.along(f, along) for f in (*held.loads, *held.known)]
        products += self.rubbed(held.lead, held.lead.inner)
        d.total(name, [replace(p, factors=(*p.factors, *over)) for p in products])
        return Force(name, held.lead.link, name, held.line, held.point, "tangential")
