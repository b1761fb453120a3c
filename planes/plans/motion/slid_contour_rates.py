"""Plans of rates of a group of class IV that hangs on two guides.

First the base is supposed not to slide; what it really does carries the basic link along the base's guide.
"""

from planes.drafting.equations import Equation, Term
from planes.drafting.steps import Carry
from planes.drafting.steps.crossings import Cross
from planes.plans.motion.carrying import carried
from planes.plans.motion.contour_rates import FALSE, ContourRates
from planes.words.names import POLE, Meaning, label_of

STILL = Meaning("false", "still")


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
        """A point of the base, and one of the basic link, were the base not to slide."""
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
