"""Velocities and accelerations in a group of class IV: by two false plans.

No point of the contour is reached from known ones by two equations. So the base is supposed to turn at two rates: not
at all (plan I) and at a chosen one (plan II). Either gives the basic link by the first rod, and with it by how much the
second rod would have to stretch. All of it is linear, so the ends of the false vectors run along lines as the rate
changes: where the line of that of the second rod meets the perpendicular to the rod, it does not stretch, and in the
same proportion the true rate stands to the false ones. From there the base is known, and the rest is a dyad on it.
"""

from dataclasses import replace

from planes.drafting.equations import Equation, Term
from planes.drafting.steps import Carry, Image
from planes.drafting.steps.crossings import Cross, CrossFalse
from planes.plans.bodies import SCHEME, BodyPoint
from planes.plans.contours import Contour
from planes.plans.kinematics import Rates
from planes.plans.legs import Leg, lead_leg, outer_leg
from planes.words.names import POLE, Meaning, at, label_of

FALSE = Meaning("false")


class ContourRates:
    """The rates of one contour."""

    def __init__(self, r: Rates, g: Contour) -> None:
        self.rates, self.group, self.bodies, self.draft = r, g, r.bodies, r.bodies.draft
        leads = r.bodies.leads[g.basic]
        self.rod, self.other = (lead_leg(r.bodies, g.basic, lead) for lead in leads)
        self.swing = outer_leg(r.bodies, g.outer[0], g.base, self.rod.known)
        self.basic = outer_leg(r.bodies, g.outer[1], g.basic, self.rod.new)
        self.far = outer_leg(r.bodies, g.outer[1], g.basic, self.other.new)

    def draw(self) -> None:
        r, base = self.rates, self.rod.known
        for leg, link in ((self.swing, self.group.base), (self.basic, self.group.basic)):
            self.bodies.known[link].ref = leg.known, leg.new
            r.image(leg.link, leg.known)
        first = self.still()
        second = self.draft.lay_off(r.plan, self.label(base, "II"), first, self.swing.along, self.false_rate(), FALSE)
        self.draft.step(Image(r.mark(base.name), first, *self.proportion(first, second), (first, second)))
        self.read(self.swing)
        r.driven.append(r.mark(base.name))
        r.solve(self.rod.new.name, r.chain(self.rod), r.chain(self.basic), (self.rod, self.basic))
        for link in (self.group.base, self.group.basic):
            r.show_points(link)
        self.read(self.other)
        for lead in self.group.leads:
            r.show_points(lead.link)

    def label(self, spot: BodyPoint, plan: str) -> str:
        """A point's label on a false plan."""
        label = self.rates.label(spot.name)
        return f"{label.removesuffix(chr(39))}_{plan}" + ("'" if label.endswith("'") else "")

    def mark(self, label: str) -> str:
        """A label's mark."""
        return at(self.rates.plan, label)

    def still(self) -> str:
        """The base's hinge when the base does not turn quicker or slower: the outer hinge's end and the normal part."""
        r = self.rates
        if not r.quick:
            return r.mark(self.swing.known.name)
        return self.draft.lay(r.plan, r.normal(self.swing, r.label(self.swing.known.name)))

    def false_rate(self) -> str:
        """The length of the vector that plan II supposes."""
        b, r = self.bodies, self.rates
        drive, ends = b.mechanism.drive, b.known[b.mechanism.drive.link].ref
        rate = {"velocity": drive.velocity, "acceleration": drive.velocity**2}.get(r.plan, 1.0) or 1.0
        named = b.distance(b.known[drive.link].link, *ends) if ends else self.swing.length or ""
        given = b.draft.given
        reach = abs(given[named] if named in given else given[self.swing.length or ""])
        size = abs(rate) * (reach if drive.kind == "phi" else 1.0)
        return self.draft.give(f"{r.letter}{self.swing.symbol}^II", size, means=Meaning("rate", self.swing.new.name))

    def proportion(self, first: str, second: str) -> tuple[tuple[str, str], tuple[str, str]]:
        """How far the true plan lies from I, and II from I, on the line of the second rod's false vectors."""
        d = self.draft
        found = [self.supposed(first, "I"), self.supposed(second, "II")]
        (start, end), (from_, to) = found
        carried = d.step(Carry(self.mark(self.label(self.other.new, "II,I")), start, from_, to, means=FALSE))
        line = d.through(f"{self.other.new.name}^I{self.other.new.name}^II", end, carried, Meaning("guide"))
        foot = self.normal(self.other, start, "I")
        met = self.mark(self.label(self.other.new, "0"))
        d.step(Cross(met, foot, self.other.along, end, line, means=FALSE))
        return (end, met), (end, carried)

    def supposed(self, hinge: str, plan: str) -> tuple[str, str]:
        """The ends of the second rod on a false plan, the base's hinge of the first rod being where it is supposed."""
        r, d = self.rates, self.draft
        pivot, far = self.swing.known, r.mark(self.basic.known.name)
        near = r.mark(pivot.name)
        start = near
        if near != hinge:
            start = self.mark(self.label(self.other.known, plan))
            shape = self.scheme(pivot, self.other.known), self.scheme(pivot, self.rod.known)
            d.step(Image(start, near, *shape, (near, hinge), means=FALSE))
        met, end = (self.mark(self.label(leg.new, plan)) for leg in (self.rod, self.other))
        tied = self.normal(self.rod, hinge, plan)
        back = far
        if r.quick:
            back = d.lay(r.plan, r.normal(self.basic, r.label(self.basic.known.name)))
        instead, basic = (self.other.along, self.far.along), self.group.basic
        crossing = met, tied, self.rod.along, back, self.basic.along
        d.step(CrossFalse(*crossing, instead=instead, means=Meaning("false", basic)))
        self.state(hinge, tied, met, plan)
        shape = self.scheme(self.basic.known, self.other.new), self.scheme(self.basic.known, self.rod.new)
        d.step(Image(end, far, *shape, (far, met), means=FALSE))
        return start, end

    def state(self, hinge: str, tied: str, met: str, plan: str) -> None:
        """The equation that a false plan was drawn by."""
        r, end = self.rates, label_of(met)
        one = [Term(f"{r.letter}{self.rod.known.name}^{plan}", POLE, label_of(hinge), drawn=True)]
        two = list(r.chain(self.basic))
        if r.quick:
            normal = r.normal(self.rod, "")
            one.append(replace(normal, start=label_of(hinge), end=label_of(tied), drawn=True))
        part = "t" if r.quick else ""
        for chain, leg in ((one, self.rod), (two, self.basic)):
            name = f"{r.letter}{leg.symbol}^{part}{plan}"
            last = Term(name, chain[-1].end, end, direction=leg.along, action=leg.along)
            chain[:] = [*(chain if leg is self.rod else chain[:-1]), last]
            chain[-1] = replace(last, start=chain[-2].end)
        self.draft.conclude(Equation(r.plan, (tuple(one), tuple(two)), f"{r.letter}{self.rod.new.name}^{plan}"))

    def scheme(self, *spots: BodyPoint) -> tuple[str, str]:
        """Two spots on the scheme."""
        one, two = spots
        return at(SCHEME, one.place), at(SCHEME, two.place)

    def normal(self, leg: Leg, start: str, plan: str) -> str:
        """The normal part of a rod's acceleration on a false plan, from where its first hinge is supposed."""
        r = self.rates
        if not r.quick:
            return start
        term = r.normal(leg, "")
        label = f"{term.end},{plan}"
        return self.draft.lay_off(r.plan, label, start, term.direction or "", term.length or "", FALSE)

    def read(self, leg: Leg) -> None:
        """What is read off a link both ends of which are found."""
        r, d = self.rates, self.draft
        r.image(leg.link, leg.known)
        r.image(self.group.base if leg is self.swing else self.group.basic, leg.new)
        *known, last = r.chain(leg)
        for term in known:
            d.lay(r.plan, term)
            d.show(r.plan, term.start, term.end, term.name)
        end = r.label(leg.new.name)
        d.measure(last.name, at(r.plan, last.start), at(r.plan, end), last.direction)
        d.show(r.plan, last.start, end, last.name)
        r.conclude(leg)
