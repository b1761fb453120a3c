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
from planes.plans.force.loads import Couple, Force, force_name
from planes.plans.force.reactions import Reaction, Statics
from planes.plans.force.rubbing import Rubs
from planes.plans.position.bodies import SCHEME, on_scheme
from planes.scene.mechanism import FRAME
from planes.words.names import POLE, Meaning, at, force_plan

Ends = tuple[str, str]  # end marks of a reaction
PairEnds = dict[Pair, Ends]


@dataclass
class HeldLead:
    """A lead with its loads: the known component of its outer reaction, and the line of the other component."""

    lead: Lead
    key: str  # the outer reaction on the lead
    known: list[Force]
    line: str
    point: str
    loads: list[Force]
    couples: list[Couple]

    @property
    def slider(self) -> bool:
        """Whether it slides on the link that carries it."""
        return self.lead.outer.kind == "P"

    @property
    def part(self) -> str:
        """The name of the other component."""
        return self.key if self.slider else f"{self.key}^n"

    def along_line(self, size: str) -> Force:
        """A force along its line, on it from the base."""
        return Force(size, self.lead.link, size, self.line, self.point, "tangential")


class LeadForces:
    """The force plan of a group whose basic link is supported by leads."""

    def __init__(self, statics: Statics, group: Tracked) -> None:
        self.statics, self.bodies, self.draft = statics, statics.bodies, statics.bodies.draft
        self.plan = force_plan(*group.balances[0])
        self.leads = self.bodies.leads[group.basic]
        self.couples = {x: list(statics.acting.couples[x]) for x in group.whole}
        self.slips: Mapping[Pair, Slip] = {}

    def rub(self, rubs: Rubs) -> None:
        """Apply the friction couples of hinges, and the friction of guides, to the links."""
        self.slips = rubs.slips
        for link, couples in self.couples.items():
            couples += rubs.couples(link)

    def laid(self, runs: Iterable[list[Force]]) -> tuple[list[Term], list[str]]:
        """Sequences of forces laid off from the pole: their terms, and the start label of each sequence, with that of
        the end."""
        chain, ends = list[Term](), [POLE]
        for run in runs:
            terms, end = self.statics.laid(self.plan, run, ends[-1])
            chain += terms
            ends.append(end)
        return chain, ends

    def held(self, lead: Lead) -> HeldLead:
        """A lead with the results of its equilibrium."""
        d, outer, inner, link = self.draft, lead.outer, lead.inner, lead.link
        loads = [f for part in lead.parts for f in self.statics.acting.forces[part]]
        couples = [c for part in lead.parts for c in self.couples[part]]
        key = force_name(link, outer.mate(link))
        if outer.kind == "P":
            hinge = on_scheme(inner.point or self.bodies.mechanism.links[link].first_point)
            return HeldLead(
                lead, key, self.rubbing(outer, link, hinge), d.square(f"∥{outer.guide}"), hinge, loads, couples
            )
        pivot, name = on_scheme(outer.point), f"{key}^t"
        if inner.kind == "R":
            line = d.ray(SCHEME, outer.point, inner.point)
            length = f"l_{outer.point}{inner.point}"
            if not lead.drive:
                length = self.bodies.length(self.bodies.mechanism.links[link], outer.point, inner.point)
            about = on_scheme(inner.point)
            terms = self.statics.moment_terms(about, loads, couples, 1.0, length)
            d.balance(name, about, lead.parts, terms, length)
            along = d.square(line)
        else:
            along = f"∥{inner.guide}"
            line = d.square(along)
            d.total(name, [self.along(f, along) for f in loads] + self.rubbed(lead, inner))
        return HeldLead(lead, key, [Force(name, link, name, along, pivot, "tangential")], line, pivot, loads, couples)

    def rubbed(self, lead: Lead, pair: Pair) -> list[Product]:
        """The friction of a guide that acts along a lead, if there is any."""
        sign = -1.0 if lead.link == pair.link else 1.0
        return [Product(sign, ((self.slips[pair].force, 1),))] if pair in self.slips else []

    def rubbing(self, pair: Pair, link: str, point: str) -> list[Force]:
        """The friction of a guide on one of its links, if there is any."""
        if pair not in self.slips:
            return []
        slip, along = self.slips[pair], f"∥{pair.guide}"
        if link != pair.link:
            along = self.draft.step(Turn(f"-{along}", along, 2, means=Meaning("along", pair.guide)))
        return [Force(slip.force, link, slip.force, along, point, "reaction")]

    def along(self, f: Force, along: str) -> Product:
        """The component of a force along a guide, to be balanced."""
        return Product(-1.0, ((f.size, 1), (self.cosine(f, along), 1)))

    def cosine(self, f: Force, along: str) -> str:
        """The component factor of a force along a guide."""
        return self.draft.step(Cosine(f"cos_{f.name}_{along.lstrip('∥')}", f.along, along))

    def read(self, held: HeldLead, ends: Mapping[Pair, Ends], rubs: Rubs) -> list[Reaction]:
        """Both reactions on a lead by the ends of their segments, the couples of sliders, and the loads passed on."""
        lead, s = held.lead, self.statics
        pairs = lead.outer, lead.inner
        reactions = [s.react(p, self.plan, *ends[p], rubs.grips.get(p)) for p in pairs]
        if lead.name == "PP":  # by the loads on the basic link, too
            return reactions
        for k, pair in enumerate(pairs):
            if pair.kind == "P":
                reactions[k] = s.seat(reactions[k], lead.link, held.point, held.loads, held.couples)
        self.handed_on(reactions[0], lead)
        if lead.drive:
            s.hand_over(next(r for r in reactions if r.pair.joins(lead.drive.link)), lead.drive.link)
        return reactions

    def handed_on(self, outer: Reaction, lead: Lead) -> None:
        """Apply the lead's reaction to the link that carries it."""
        if lead.outer.mate(lead.link) != FRAME:
            self.statics.hand_over(outer, lead.outer.mate(lead.link))

    def seated(self, reaction: Reaction, link: str, others: list[Reaction]) -> Reaction:
        """A guide's reaction with its couple, from all loads on a link; the ``others`` are reactions already found."""
        s = self.statics
        own = [r for r in others if r.pair.joins(link)]
        forces = [*s.acting.forces[link], *(s.as_force(r, link) for r in own)]
        slid = ((r.moment, 1 if r.pair.link == link else -1) for r in own if r.pair.kind == "P")
        handed = (Couple(moment, link, moment, sign, True) for moment, sign in slid)
        first = self.bodies.mechanism.links[link].first_point
        return s.seat(reaction, link, on_scheme(first), forces, [*self.couples[link], *handed])

    def on(self, links: tuple[str, ...], pair: Pair, ends: Ends) -> Ends:
        """A reaction on one of the links, with the sign for the first link of its pair."""
        start, end = (at(self.plan, label) for label in ends)
        return (start, end) if pair.link in links else (end, start)
