"""The force plan of a triad: the third lead's reaction by moments about S, then one polygon of the whole group.

The reactions of the two leads that meet in S pass it, so moments of the whole group about S have one unknown. Of a
lead's outer reaction that part is known beforehand which its own equilibrium gives: of a rod by moments about its inner
hinge, of a link that slides on the basic one along that guide. A slider hands its loads on to its hinge.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace

from planes.drafting.draft import Moments
from planes.drafting.equations import Equation, Term
from planes.drafting.steps import Turn
from planes.drafting.steps.reckoning import Cosine, Drop, Product
from planes.plans.bodies import SCHEME
from planes.plans.groups import Lead, Pair, Triad
from planes.plans.hinges import Slip
from planes.plans.loads import Couple, Force, force_name
from planes.plans.reactions import Statics, chain_of
from planes.plans.rubbing import Rubs, settled
from planes.scene.mechanism import FRAME
from planes.words.names import POLE, Meaning, at, end_of, force_plan, label_of, mu_of

Ends = tuple[str, str]  # marks between which a reaction stands


@dataclass
class _Held:
    """A lead with what acts on it: the known part of its outer reaction, and the line of the other part."""

    lead: Lead
    key: str  # the outer reaction on the lead
    known: list[Force]
    line: str
    point: str
    loads: list[Force]
    couples: list[Couple]

    @property
    def part(self) -> str:
        """The name of the other part."""
        return self.key if self.lead.outer.kind == "P" else f"{self.key}^n"


class TriadForces:
    """The plan of one triad."""

    def __init__(self, statics: Statics, group: Triad) -> None:
        self.statics, self.group, self.bodies, self.draft = statics, group, statics.bodies, statics.bodies.draft
        self.plan = force_plan(*group.balanced)
        self.special = at(SCHEME, self.bodies.special(group.basic))
        self.leads = self.bodies.leads[group.basic]
        self.couples = {x: list(statics.acting.couples[x]) for x in group.balanced}
        self.slips: Mapping[Pair, Slip] = {}

    def draw(self) -> None:
        self.draft.pole(self.plan)
        pairs = self.group.pairs
        rubs = settled(self, lambda s: TriadForces(s, self.group), pairs, pairs)
        ends = self.polygon()
        for held in self.drawn:
            self.read(held, ends, rubs)

    def rub(self, rubs: Rubs) -> None:
        """Let the links feel the couples of hinges, and the friction of guides."""
        self.slips = rubs.slips
        for link, couples in self.couples.items():
            couples += rubs.couples(link)

    def polygon(self) -> dict[Pair, Ends]:
        """Draw the polygon; the reaction of each pair on the pair's own first link."""
        self.drawn = one, two, three = tuple(self.held(lead) for lead in self.leads)
        pushed = self.third(one, two, three)
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
            found |= {held.lead.outer: self.on(held.lead, held.lead.outer, outer)}
            found |= {held.lead.inner: self.on(held.lead, held.lead.inner, inner)}
        return found

    def held(self, lead: Lead) -> _Held:
        """A lead, and what its own equilibrium gives."""
        d, outer, inner, link = self.draft, lead.outer, lead.inner, lead.link
        loads = [f for part in lead.parts for f in self.statics.acting.forces[part]]
        couples = [c for part in lead.parts for c in self.couples[part]]
        key = force_name(link, outer.mate(link))
        if outer.kind == "P":
            hinge = at(SCHEME, inner.point)
            rubbing = [self.slipping(self.slips[outer], link, hinge)] if outer in self.slips else []
            return _Held(lead, key, rubbing, d.square(f"∥{outer.guide}"), hinge, loads, couples)
        pivot, name = at(SCHEME, outer.point), f"{key}^t"
        if inner.kind == "R":
            line = d.ray(SCHEME, outer.point, inner.point)
            length = f"l_{outer.point}{inner.point}"
            if not lead.drive:
                length = self.bodies.length(self.bodies.mechanism.links[link], outer.point, inner.point)
            products, shown = self.statics.moment_terms(at(SCHEME, inner.point), loads, couples, 1.0, length)
            d.moments.append(Moments(inner.point, lead.parts, shown, name, length))
            along = d.square(line)
        else:
            along = f"∥{inner.guide}"
            line, products = d.square(along), [self.along(f, along) for f in loads]
            if inner in self.slips:
                products.append(Product(-1.0 if link == inner.link else 1.0, ((self.slips[inner].force, 1),)))
        d.total(name, products)
        known = Force(name, link, name, along, pivot, "tangential")
        return _Held(lead, key, [known], line, pivot, loads, couples)

    def slipping(self, slip: Slip, link: str, point: str) -> Force:
        """The friction of a guide on one of its links."""
        along = f"∥{slip.pair.guide}"
        if link != slip.pair.link:
            along = self.draft.step(Turn(f"-{along}", along, 2, means=Meaning("along", slip.pair.guide)))
        return Force(slip.force, link, slip.force, along, point, "reaction")

    def along(self, f: Force, along: str) -> Product:
        """What of a force has to be held along a guide."""
        cosine = self.draft.step(Cosine(f"cos_{f.name}_{along.lstrip('∥')}", f.along, along))
        return Product(-1.0, ((f.size, 1), (cosine, 1)))

    def third(self, one: _Held, two: _Held, three: _Held) -> Force:
        """The reaction of the third lead along its line, by moments of the whole group about S."""
        d, basic = self.draft, self.group.basic
        forces, couples = list(self.statics.acting.forces[basic]), list(self.couples[basic])
        for held in (one, two, three):
            if held.lead.outer.kind == "P":  # a slider turns nowhere: all its loads pass its hinge
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

    def read(self, held: _Held, ends: Mapping[Pair, Ends], rubs: Rubs) -> None:
        """Both reactions on a lead by the ends of their segments, the couples of sliders, and what is handed on."""
        lead, s = held.lead, self.statics
        pairs = lead.outer, lead.inner
        found = [s.react(p, self.plan, *ends[p], rubs.grips.get(p)) for p in pairs]
        for k, pair in enumerate(pairs):
            if pair.kind == "P":
                found[k] = s.seat(found[k], lead.link, held.point, held.loads, held.couples)
        if lead.outer.mate(lead.link) != FRAME:
            s.hand_over(found[0], lead.outer.mate(lead.link))
        if lead.drive:
            s.hand_over(next(r for r in found if r.pair.joins(lead.drive.link)), lead.drive.link)

    def on(self, lead: Lead, pair: Pair, ends: Ends) -> Ends:
        """A reaction on the lead, turned for its pair's own first link."""
        start, end = (at(self.plan, label) for label in ends)
        return (start, end) if pair.link in lead.parts else (end, start)
