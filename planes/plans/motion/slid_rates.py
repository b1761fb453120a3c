"""Rates of groups whose basic link turns with the link it slides on.

The leads of a triad reach one point of the basic link, as on the scheme, where the support of one of them was shifted:
the shifted point moves with its original, and relative to it as the basic link turns. In a group of class IV on two
guides the base is first assumed not to slide; its true motion then carries the basic link along the base's guide.
"""

from dataclasses import replace

from planes.drafting.equations import Equation, Term
from planes.drafting.steps import Carry
from planes.drafting.steps.crossings import Cross
from planes.plans.assur.basic_links import Triad
from planes.plans.motion.carrying import carried
from planes.plans.motion.contour_rates import FALSE, ContourRates
from planes.plans.motion.kinematics import Rates
from planes.plans.motion.legs import Leg, lead_leg, outer_leg
from planes.plans.position.bodies import BodyPoint
from planes.scene.mechanism import FRAME
from planes.words.names import POLE, Meaning, label_of

STILL = Meaning("false", "still")


class SlidRates:
    """The rates of one such triad."""

    def __init__(self, r: Rates, g: Triad) -> None:
        self.rates, self.group, self.bodies, self.draft = r, g, r.bodies, r.bodies.draft
        *leads, self.slid = r.bodies.leads[g.basic]
        self.one, self.two = (lead_leg(r.bodies, g.basic, lead) for lead in leads)

    def draw(self) -> None:
        r, b, slid = self.rates, self.bodies, self.slid
        body, first = b.known[self.group.basic], b.mechanism.links[slid.link].first_point
        body.moving = self.one.new
        r.image(self.two.link, self.two.known)
        moved = self.moved(self.two, self.one.new)
        r.solve(self.one.new.name, r.chain(self.one), r.chain(moved), (self.one, moved))
        r.image(self.group.basic, self.two.new)
        legs = [outer_leg(b, pair, slid.link, BodyPoint(first, first)) for pair in (slid.outer, slid.inner)]
        r.solve(first, r.chain(legs[0]), r.chain(legs[1]), legs)
        for link in self.group.whole:
            r.show_points(link)

    def moved(self, leg: Leg, new: BodyPoint) -> Leg:
        """A leg to another point of the basic link, with its start shifted."""
        r, root = self.rates, self.bodies.known[self.bodies.known[self.group.basic].root]
        if root.link.name == FRAME or leg.new == new:
            return replace(leg, new=new)
        name = (leg.known.name if leg.known.name != POLE else leg.new.name) + "°"
        over, start, end = BodyPoint(leg.known.place, name), r.mark(leg.known.name), r.mark(name)
        carried(r, root, start, leg.new, new, end)
        to_known = Term(r.letter + leg.known.name, POLE, label_of(start), drawn=True)
        over_it = Term(f"{r.letter}{new.name}{leg.new.name}", label_of(start), label_of(end), drawn=True)
        self.draft.conclude(Equation(r.plan, ((to_known, over_it), ()), r.letter + name))
        return replace(leg, new=new, known=over)


class SlidContourRates(ContourRates):
    """The rates of one such contour."""

    def draw(self) -> None:
        r, d, g = self.rates, self.draft, self.group
        still, away = self.still()
        for link, spot in ((g.base, self.rod.known), (g.basic, self.rod.new)):
            self.bodies.known[link].moving = spot
        for leg in (self.swing, self.basic):
            r.image(leg.link, leg.known)
        new, name, along = r.label(self.rod.new.name), f"{r.letter}{self.rod.new.name}", self.swing.along
        slid = Term(f"{name}^II", label_of(away), new, None, along, along)
        start = Term(f"{name}^I", POLE, label_of(away), drawn=True)
        r.solve(self.rod.new.name, (start, slid), r.chain(self.basic), (self.basic,))
        d.step(Carry(r.mark(self.rod.known.name), r.mark(self.rod.new.name), away, still))
        self.read(self.swing)
        r.driven.append(r.mark(self.rod.known.name))
        for link in (g.base, g.basic):
            r.show_points(link)
        for leg in (self.rod, self.other):
            self.read(leg)
        for lead in g.leads:
            r.show_points(lead.link)

    def still(self) -> tuple[str, str]:
        """A point of the base, and one of the basic link, for a base that does not slide."""
        r, d = self.rates, self.draft
        r.image(self.swing.link, self.swing.known)
        hinge, base = self.fixed(self.swing), self.bodies.known[self.group.base]
        end = self.mark(self.label(self.other.known, "I"))
        if end != hinge:
            root = self.bodies.known[base.root]
            carried(r, root, hinge, self.rod.known, self.other.known, end, FALSE)
        tied, terms = self.laid(self.rod, hinge, "I")
        back, others = self.laid(self.other, end, "I")
        if self.other.new != self.rod.new:
            over = self.mark(f"{self.label(self.other.new, 'I')}°")
            carried(r, self.body, back, self.other.new, self.rod.new, over, FALSE)
            name = f"{r.letter}{self.rod.new.name}{self.other.new.name}"
            others.append(Term(name, label_of(back), label_of(over), drawn=True))
            back = over
        met = self.mark(self.label(self.rod.new, "I"))
        d.step(Cross(met, tied, self.rod.along, back, self.other.along, means=STILL))
        chains = []
        for leg, begin, known in ((self.rod, hinge, terms), (self.other, end, others)):
            part = ("r" if leg.pair else "t") if r.quick else ""
            first = Term(f"{r.letter}{leg.known.name}^I", POLE, label_of(begin), drawn=True)
            last = (known or [first])[-1].end, label_of(met)
            chains.append((first, *known, Term(f"{r.letter}{leg.symbol}^{part}I", *last, None, leg.along, leg.along)))
        d.conclude(Equation(r.plan, (chains[0], chains[1]), f"{r.letter}{self.rod.new.name}^I"))
        return hinge, met
