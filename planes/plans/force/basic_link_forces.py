"""What acts on a basic link on leads: of one of them by moments about the special point of the two others, of these by
a polygon of all that acts on the link and its leads.

The reactions of the two leads that meet in S pass it, so moments of the whole about S have one unknown.
"""

from collections.abc import Sequence
from dataclasses import replace

from planes.drafting.draft import Moments
from planes.drafting.equations import Equation, Term
from planes.drafting.steps.reckoning import Drop
from planes.plans.assur.basic_links import Lead
from planes.plans.assur.groups import Pair
from planes.plans.force.lead_forces import Ends, HeldLead, LeadForces
from planes.plans.force.loads import Force
from planes.plans.force.reactions import chain_of
from planes.plans.position.bodies import SCHEME
from planes.words.names import POLE, Meaning, end_of, label_of, mu_of


class BasicLinkForces(LeadForces):
    """Plans of one basic link, or of each of several, with its leads."""

    def moments(
        self, basic: str, held: Sequence[HeldLead], special: str, name: str, arm: str, links: tuple[str, ...]
    ) -> str:
        """The one unknown of the moments of a basic link with its leads about its special point, by its ``arm``."""
        forces, couples = list(self.statics.acting.forces[basic]), list(self.couples[basic])
        for lead in held:
            if lead.slider:  # a slider turns nowhere: all its loads pass its hinge
                forces += [replace(f, point=lead.point) for f in (*lead.loads, *lead.known)]
            else:
                forces += [*lead.loads, *lead.known]
                couples += lead.couples
        products, shown = self.statics.moment_terms(special, forces, couples, -1.0, arm)
        found = self.draft.total(name, products)
        self.draft.moments.append(Moments(label_of(special), links, shown, found, arm))
        return found

    def third(self, basic: str, held: Sequence[HeldLead], special: str, links: tuple[str, ...]) -> Force:
        """The reaction of the last of three leads along its line, the others meeting in the special point."""
        *_, three = held
        centre = label_of(special)
        means, name = Meaning("arm", three.part, special, three.lead.link), f"h_{three.part}_{centre}"
        arm = self.draft.step(Drop(name, three.point, three.line, special, mu_of(SCHEME), means=means))
        name = self.moments(basic, held, special, three.part, arm, links)
        return Force(name, three.lead.link, name, three.line, three.point, "tangential")

    def closed(self, basic: str, held: Sequence[HeldLead], known: list[Force]) -> dict[Pair, Ends]:
        """Draw the polygon of a basic link: two leads close it, where all is ``known`` that acts on the third, or on
        the link from another one. The reactions of each pair on the pair's own first link.
        """
        one, two, *others = held
        own = list(self.statics.acting.forces[basic])
        runs = [[*two.known, *two.loads], known, own, [*one.loads, *one.known]]
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
        beyond = end_of(two.known[-1].name) if two.known else POLE
        found = self.reactions(one.lead, (begins, x), (x, ends[3])) | self.reactions(
            two.lead, (x, beyond), (ends[1], x)
        )
        for three in others:
            first = [*three.known, known[-1]][0]  # what pushes it along its line
            found |= self.reactions(three.lead, (starts[end_of(first.name)], ends[2]), (ends[2], ends[1]))
        return found

    def reactions(self, lead: Lead, outer: Ends, inner: Ends) -> dict[Pair, Ends]:
        """Those on a lead; where the lead is another basic link both are one, that of the hinge."""
        return {lead.inner: self.on(lead.parts, lead.inner, inner), lead.outer: self.on(lead.parts, lead.outer, outer)}
