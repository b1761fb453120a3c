"""The force plans of two basic links hinged to each other: one is a lead of the other, along the line from their hinge
to its special point.

The reactions of its own two leads pass that point. So its moments about it give what acts in the hinge across that
line, as those of a rod about its hinge do; what acts along the line is found as of any lead. A polygon for each.
"""

from dataclasses import replace

from planes.plans.assur.groups import Pair
from planes.plans.assur.pairings import Pairing
from planes.plans.force.basic_link_forces import BasicLinkForces
from planes.plans.force.lead_forces import Ends, HeldLead
from planes.plans.force.loads import Force, force_name
from planes.plans.force.reactions import Reaction, Statics
from planes.plans.force.rubbing import settled
from planes.plans.position.bodies import SCHEME
from planes.words.names import at, force_plan, label_of


class PairingForces(BasicLinkForces):
    """The plans of two basic links with their leads."""

    def __init__(self, statics: Statics, group: Pairing) -> None:
        super().__init__(statics, group)
        self.group, self.pin, self.last = group, at(SCHEME, group.hinge.point), self.leads[-1]
        self.special = [at(SCHEME, self.bodies.special(basic)) for basic in group.basics]
        self.plans = [force_plan(*links) for links in group.balances]
        self.led = group.led(self.last)

    def draw(self) -> None:
        for plan in self.plans:
            self.draft.pole(plan)
        pairs, pin, k = self.group.pairs, self.group.hinge, self.led
        rubs = settled(self, lambda s: PairingForces(s, self.group), pairs, pairs)
        ends = self.polygon()
        self.plan = self.plans[k]
        self.statics.react(pin, self.plan, *ends[pin], rubs.grips.get(pin))
        for side in (k, 1 - k):
            self.plan = self.plans[side]
            for held in self.sides[side]:
                self.read(held, ends, rubs)

    def polygon(self) -> dict[Pair, Ends]:
        """Draw both polygons; the reaction of each pair on the pair's own first link."""
        g, k = self.group, self.led
        self.sides = [[self.held(lead) for lead in side] for side in g.sides]
        three = [*self.sides[k], self.joint()]
        held = sorted(three, key=lambda h: h.lead.inner == self.last.inner)
        pushed = self.third(g.basics[k], held, self.special[k], g.side(k))
        self.plan = self.plans[k]
        found = self.closed(g.basics[k], held, [*held[2].loads, *held[2].known, pushed])
        hinge = Reaction(force_name(g.hinge.link, g.hinge.other), self.plan, *found[g.hinge], g.hinge)
        end = g.basics[1 - k]
        self.plan = self.plans[1 - k]
        return found | self.closed(end, self.sides[1 - k], [self.statics.as_force(hinge, end)])

    def joint(self) -> HeldLead:
        """What the other basic link does to the one it leads: across the line to its special point that is known."""
        d, g, special = self.draft, self.group, self.special[1 - self.led]
        basic, end = g.basics[self.led], g.basics[1 - self.led]
        key, name = force_name(basic, end), f"{force_name(basic, end)}^t"
        line = d.ray(SCHEME, g.hinge.point, label_of(special))
        length = d.measure(f"l_{g.hinge.point}{label_of(special)}", self.pin, special)
        self.moments(end, self.sides[1 - self.led], special, name, length, g.side(1 - self.led))
        across = Force(name, basic, name, d.square(line), self.pin, "tangential")
        return HeldLead(replace(g.joint, link=basic), key, [across], line, self.pin, [], [])
