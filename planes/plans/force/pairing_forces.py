"""The force plans of two basic links hinged to each other: the reaction of their hinge by moments about both special
points, then a polygon for each basic link with its leads.

The reactions of the two leads of a basic link pass through its special point. So moments of the second one, with its
leads, about that give what acts in the hinge across the line to it; and moments of the first one about its own, in
which nothing else is unknown, what acts along that line.
"""

from collections.abc import Iterable
from dataclasses import replace

from planes.drafting.draft import Moments
from planes.drafting.equations import Equation, Term
from planes.drafting.steps.reckoning import Drop
from planes.plans.assur.groups import Pair
from planes.plans.assur.pairings import Pairing
from planes.plans.force.lead_forces import Ends, HeldLead, LeadForces
from planes.plans.force.loads import Couple, Force, force_name
from planes.plans.force.reactions import Reaction, Statics, chain_of
from planes.plans.force.rubbing import settled
from planes.plans.position.bodies import SCHEME
from planes.words.names import POLE, Meaning, at, end_of, force_plan, label_of, mu_of


class PairingForces(LeadForces):
    """The plans of two basic links with their leads."""

    def __init__(self, statics: Statics, group: Pairing) -> None:
        super().__init__(statics, group)
        self.group, self.pin = group, at(SCHEME, group.hinge.point)
        self.special = [at(SCHEME, self.bodies.special(basic)) for basic in group.basics]
        self.plans = [force_plan(*links) for links in group.balances]

    def draw(self) -> None:
        for plan in self.plans:
            self.draft.pole(plan)
        pairs, pin = self.group.pairs, self.group.hinge
        rubs = settled(self, lambda s: PairingForces(s, self.group), pairs, pairs)
        ends = self.polygon()
        self.plan = self.plans[1]
        self.statics.react(pin, self.plan, *ends[pin], rubs.grips.get(pin))
        for k in (1, 0):
            self.plan = self.plans[k]
            for held in self.sides[k]:
                self.read(held, ends, rubs)

    def polygon(self) -> dict[Pair, Ends]:
        """Draw both polygons; the reaction of each pair on the pair's own first link."""
        self.sides = [[self.held(lead) for lead in self.bodies.leads[basic]] for basic in self.group.basics]
        pin, s = self.group.hinge, self.statics
        across, along = self.joint()
        ends, found = self.closed(1, [across, along])
        plan = self.plans[1]
        start = next(t.start for t in ends if t.end == end_of(across.name))
        found[pin] = self.at_plan(plan, (start, end_of(along.name)))
        reaction = Reaction(force_name(pin.link, pin.other), plan, *found[pin], pin)
        return found | self.closed(0, [s.as_force(reaction, pin.other)])[1]

    def joint(self) -> tuple[Force, Force]:
        """What the hinge does to the second basic link: across the line to its special point, and along it."""
        d, pin, (first, second) = self.draft, self.group.hinge, self.group.basics
        name, back = force_name(second, first), force_name(first, second)
        line = d.ray(SCHEME, label_of(self.pin), label_of(self.special[1]))
        length = d.measure(f"l_{pin.point}{label_of(self.special[1])}", self.pin, self.special[1])
        across = Force(f"{name}^t", second, f"{name}^t", d.square(line), self.pin, "tangential")
        self.moments(1, [], across.name, 1.0, length)
        pushed = replace(across, name=f"{back}^t", link=first, along=d.reversed(across.along))
        means = Meaning("arm", f"{name}^n", self.special[0], second)
        named = f"h_{name}^n_{label_of(self.special[0])}"
        arm = d.step(Drop(named, self.pin, line, self.special[0], mu_of(SCHEME), means=means))
        self.moments(0, [pushed], f"{name}^n", 1.0, arm)
        return across, Force(f"{name}^n", second, f"{name}^n", line, self.pin, "tangential")

    def moments(self, k: int, more: list[Force], name: str, sign: float, arm: str) -> None:
        """A part of the hinge's reaction, by moments of a basic link with its leads about its special point."""
        forces, couples = self.acting(k)
        products, shown = self.statics.moment_terms(self.special[k], [*forces, *more], couples, sign, arm)
        self.draft.total(name, products)
        self.draft.moments.append(Moments(label_of(self.special[k]), self.group.side(k), shown, name, arm))

    def acting(self, k: int) -> tuple[list[Force], list[Couple]]:
        """What acts on a basic link and its leads, but for the forces along these."""
        basic = self.group.basics[k]
        forces, couples = list(self.statics.acting.forces[basic]), list(self.couples[basic])
        for held in self.sides[k]:
            if held.slider:  # a slider turns nowhere: all its loads pass its hinge
                forces += [replace(f, point=held.point) for f in (*held.loads, *held.known)]
            else:
                forces += [*held.loads, *held.known]
                couples += held.couples
        return forces, couples

    def closed(self, k: int, joint: list[Force]) -> tuple[tuple[Term, ...], dict[Pair, Ends]]:
        """The polygon of a basic link with its leads, that of the hinge known; its known terms, and the reactions."""
        plan, (one, two) = self.plans[k], self.sides[k]
        own = [*joint, *self.statics.acting.forces[self.group.basics[k]]]
        runs: Iterable[list[Force]] = ([*two.known, *two.loads], own, [*one.loads, *one.known])
        ends, chain = [POLE], list[Term]()
        for run in runs:
            chain += chain_of(run, ends[-1])
            ends.append(chain[-1].end if chain else POLE)
        for term in chain:
            self.draft.lay(plan, term)
        x = end_of(one.part)
        last = Term(one.part, ends[-1], x, None, one.line, one.line)
        back = Term(two.part, POLE, x, length=None, direction=two.line, action=two.line, drawn=False, sign=-1)
        self.draft.draw(Equation(plan, ((*chain, last), (back,))))
        begins = {term.end: term.start for term in chain}.get(end_of(one.known[0].name) if one.known else "", ends[-1])
        self.plan = plan
        return tuple(chain), self.reactions(one, (begins, x), (x, ends[2])) | self.reactions(
            two, (x, end_of(two.known[-1].name) if two.known else POLE), (ends[1], x)
        )

    def reactions(self, held: HeldLead, outer: Ends, inner: Ends) -> dict[Pair, Ends]:
        """The reactions on a lead."""
        lead = held.lead
        return {lead.outer: self.on(lead.parts, lead.outer, outer), lead.inner: self.on(lead.parts, lead.inner, inner)}

    def at_plan(self, plan: str, ends: Ends) -> Ends:
        """Marks by their labels."""
        return at(plan, ends[0]), at(plan, ends[1])
