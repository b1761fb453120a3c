"""What plans of forces of higher groups share: a lead by its own equilibrium, what rubs in it, and how it is read.

Of a lead's outer reaction that part is known beforehand which its own equilibrium gives: of a rod by moments about its
inner hinge, of a link that slides on the basic one along that guide. A slider hands its loads on to its hinge.
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
from planes.plans.force.loads import Couple, Force, force_name
from planes.plans.force.reactions import Reaction, Statics
from planes.plans.force.rubbing import Rubs
from planes.plans.position.bodies import SCHEME
from planes.scene.mechanism import FRAME
from planes.words.names import POLE, Meaning, at, force_plan

Ends = tuple[str, str]  # marks between which a reaction stands


@dataclass
class HeldLead:
    """A lead with what acts on it: the known part of its outer reaction, and the line of the other part."""

    lead: Lead
    key: str  # the outer reaction on the lead
    known: list[Force]
    line: str
    point: str
    loads: list[Force]
    couples: list[Couple]

    @property
    def slider(self) -> bool:
        """Whether it slides on what it hangs on."""
        return self.lead.outer.kind == "P"

    @property
    def part(self) -> str:
        """The name of the other part."""
        return self.key if self.slider else f"{self.key}^n"

    def along_line(self, size: str) -> Force:
        """A force along its line, on it from the base."""
        return Force(size, self.lead.link, size, self.line, self.point, "tangential")


class LeadForces:
    """The plan of a group whose basic link stands on leads."""

    def __init__(self, statics: Statics, group: Tracked) -> None:
        self.statics, self.bodies, self.draft = statics, statics.bodies, statics.bodies.draft
        self.plan = force_plan(*group.balances[0])
        self.leads = self.bodies.leads[group.basic]
        self.couples = {x: list(statics.acting.couples[x]) for x in group.whole}
        self.slips: Mapping[Pair, Slip] = {}

    def rub(self, rubs: Rubs) -> None:
        """Let the links feel the couples of hinges, and the friction of guides."""
        self.slips = rubs.slips
        for link, couples in self.couples.items():
            couples += rubs.couples(link)

    def laid(self, runs: Iterable[list[Force]]) -> tuple[list[Term], list[str]]:
        """Runs of forces laid off one after another from the pole: their terms, and the label each run begins at, with
        that of the end."""
        chain, ends = list[Term](), [POLE]
        for run in runs:
            terms, end = self.statics.laid(self.plan, run, ends[-1])
            chain += terms
            ends.append(end)
        return chain, ends

    def held(self, lead: Lead) -> HeldLead:
        """A lead, and what its own equilibrium gives."""
        d, outer, inner, link = self.draft, lead.outer, lead.inner, lead.link
        loads = [f for part in lead.parts for f in self.statics.acting.forces[part]]
        couples = [c for part in lead.parts for c in self.couples[part]]
        key = force_name(link, outer.mate(link))
        if outer.kind == "P":
            hinge = at(SCHEME, inner.point or self.bodies.mechanism.links[link].first_point)
            return HeldLead(
                lead, key, self.rubbing(outer, link, hinge), d.square(f"∥{outer.guide}"), hinge, loads, couples
            )
        pivot, name = at(SCHEME, outer.point), f"{key}^t"
        if inner.kind == "R":
            line = d.ray(SCHEME, outer.point, inner.point)
            length = f"l_{outer.point}{inner.point}"
            if not lead.drive:
                length = self.bodies.length(self.bodies.mechanism.links[link], outer.point, inner.point)
            about = at(SCHEME, inner.point)
            terms = self.statics.moment_terms(about, loads, couples, 1.0, length)
            d.balance(name, about, lead.parts, terms, length)
            along = d.square(line)
        else:
            along = f"∥{inner.guide}"
            line = d.square(along)
            d.total(name, [self.along(f, along) for f in loads] + self.rubbed(lead, inner))
        return HeldLead(lead, key, [Force(name, link, name, along, pivot, "tangential")], line, pivot, loads, couples)

    def rubbed(self, lead: Lead, pair: Pair) -> list[Product]:
        """What of the friction of a guide a lead has to be held against along it, if it rubs."""
        sign = -1.0 if lead.link == pair.link else 1.0
        return [Product(sign, ((self.slips[pair].force, 1),))] if pair in self.slips else []

    def rubbing(self, pair: Pair, link: str, point: str) -> list[Force]:
        """The friction of a guide on one of its links, if it rubs."""
        if pair not in self.slips:
            return []
        slip, along = self.slips[pair], f"∥{pair.guide}"
        if link != pair.link:
            along = self.draft.step(Turn(f"-{along}", along, 2, means=Meaning("along", pair.guide)))
        return [Force(slip.force, link, slip.force, along, point, "reaction")]

    def along(self, f: Force, along: str) -> Product:
        """What of a force has to be held along a guide."""
        return Product(-1.0, ((f.size, 1), (self.cosine(f, along), 1)))

    def cosine(self, f: Force, along: str) -> str:
        """How much of a force is along a guide."""
        return self.draft.step(Cosine(f"cos_{f.name}_{along.lstrip('∥')}", f.along, along))

    def read(self, held: HeldLead, ends: Mapping[Pair, Ends], rubs: Rubs) -> list[Reaction]:
        """Both reactions on a lead by the ends of their segments, the couples of sliders, and what is handed on."""
        lead, s = held.lead, self.statics
        pairs = lead.outer, lead.inner
        reactions = [s.react(p, self.plan, *ends[p], rubs.grips.get(p)) for p in pairs]
        if lead.name == "PP":  # by what acts on the basic link, too
            return reactions
        for k, pair in enumerate(pairs):
            if pair.kind == "P":
                reactions[k] = s.seat(reactions[k], lead.link, held.point, held.loads, held.couples)
        self.handed_on(reactions[0], lead)
        if lead.drive:
            s.hand_over(next(r for r in reactions if r.pair.joins(lead.drive.link)), lead.drive.link)
        return reactions

    def handed_on(self, outer: Reaction, lead: Lead) -> None:
        """Let what a lead hangs on feel its reaction."""
        if lead.outer.mate(lead.link) != FRAME:
            self.statics.hand_over(outer, lead.outer.mate(lead.link))

    def seated(self, reaction: Reaction, link: str, others: list[Reaction]) -> Reaction:
        """A guide's reaction with its couple, by all that acts on a link; the ``others`` are those found of it."""
        s = self.statics
        own = [r for r in others if r.pair.joins(link)]
        forces = [*s.acting.forces[link], *(s.as_force(r, link) for r in own)]
        slid = ((r.moment, 1 if r.pair.link == link else -1) for r in own if r.pair.kind == "P")
        handed = (Couple(moment, link, moment, sign, True) for moment, sign in slid)
        first = self.bodies.mechanism.links[link].first_point
        return s.seat(reaction, link, at(SCHEME, first), forces, [*self.couples[link], *handed])

    def on(self, links: tuple[str, ...], pair: Pair, ends: Ends) -> Ends:
        """A reaction on one of the links, turned for its pair's own first link."""
        start, end = (at(self.plan, label) for label in ends)
        return (start, end) if pair.link in links else (end, start)
