"""The force plans of basic links hinged to each other: every one is a lead of the next, along the line from their hinge
to its special point, till one has three.

The reactions of its own two leads pass that point. So its moments about it give what acts in the hinge across that
line, as those of a rod about its hinge do; what acts along the line is found as of any lead. A polygon for each.
"""

from planes.plans.assur.basic_chains import BasicChain
from planes.plans.assur.basic_links import Lead
from planes.plans.assur.groups import Pair
from planes.plans.force.basic_link_forces import BasicLinkForces
from planes.plans.force.lead_forces import Ends, HeldLead
from planes.plans.force.loads import Force, force_name
from planes.plans.force.reactions import Reaction, Statics
from planes.plans.force.rubbing import settled
from planes.plans.position.bodies import SCHEME
from planes.words.names import at, force_plan, label_of


class ChainForces(BasicLinkForces):
    """The plans of a chain of basic links with their leads."""

    def __init__(self, statics: Statics, group: BasicChain) -> None:
        super().__init__(statics, group)
        self.group, self.last = group, self.leads[-1]
        self.special = [at(SCHEME, self.bodies.special(basic)) for basic in group.basics]
        self.plans = [force_plan(*links) for links in group.balances]
        self.drawn: dict[int, list[HeldLead]] = {}  # of every basic link, those that are links, from the root on

    def draw(self) -> None:
        for plan in self.plans:
            self.draft.pole(plan)
        pairs = self.group.pairs
        rubs = settled(self, lambda s: ChainForces(s, self.group), pairs, pairs)
        ends = self.polygon()
        for hinge, found in self.found.items():
            self.statics.react(hinge, found.plan, *ends[hinge], rubs.grips.get(hinge))
        for k, leads in self.drawn.items():
            self.plan = self.plans[k]
            for held in leads:
                self.read(held, ends, rubs)

    def polygon(self) -> dict[Pair, Ends]:
        """Draw all polygons; the reaction of each pair on the pair's own first link."""
        g, k = self.group, self.group.root(self.last)
        self.found: dict[Pair, Reaction] = {}
        self.held_by: dict[int, list[HeldLead]] = {}
        three = sorted(self.all_held(k), key=lambda h: h.lead.inner == self.last.inner)
        pushed = self.third(g.basics[k], three, self.special[k], g.side(k))
        return self.balanced(k, three, [*three[2].loads, *three[2].known, pushed])

    def all_held(self, k: int, but: Pair | None = None) -> list[HeldLead]:
        """The leads of a basic link, other basic links among them but the one at that hinge."""
        g = self.group
        held = [self.held(lead) for lead in g.sides[k]]
        for hinge, ends in zip(g.hinges, g.joined, strict=True):
            if k in ends and hinge != but:
                held.append(self.joint(hinge, k, sum(ends) - k))
        self.held_by[k] = held
        return held

    def joint(self, hinge: Pair, k: int, end: int) -> HeldLead:
        """What a basic link does to the next one: what is across the line to its special point is known."""
        d, g, special, pin = self.draft, self.group, self.special[end], at(SCHEME, hinge.point)
        key, name = force_name(g.basics[k], g.basics[end]), f"{force_name(g.basics[k], g.basics[end])}^t"
        line = d.ray(SCHEME, hinge.point, label_of(special))
        length = d.measure(f"l_{hinge.point}{label_of(special)}", pin, special)
        self.moments(g.basics[end], self.all_held(end, hinge), special, name, length, g.side(end))
        across = Force(name, g.basics[k], name, d.square(line), pin, "tangential")
        return HeldLead(Lead(g.basics[k], hinge, hinge), key, [across], line, pin, [], [])

    def balanced(self, k: int, held: list[HeldLead], known: list[Force]) -> dict[Pair, Ends]:
        """The polygon of a basic link, then of those that lead to it, what acts in their hinges being known."""
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
