"""Velocities and accelerations in a group of class IV: by two false plans.

No point of the contour can be reached from known ones by two equations. So the base is assumed to turn at two rates:
zero (plan I) and a chosen one (plan II). Each gives the basic link by the first lead, and with it the rate at which the
second lead would stretch (or leave its guide). All of it is linear, so the ends of the false vectors move along lines
as the rate changes. The second lead does not stretch where its line meets the line of possible motion, and the true
rate divides the false ones in the same proportion. From there the base is known, and the rest is a dyad on it.
"""

from collections.abc import Iterator
from dataclasses import replace

from planes.drafting.equations import Equation, Term
from planes.drafting.steps import Carry, Image
from planes.drafting.steps.by_leads import CrossFalse
from planes.drafting.steps.crossings import Cross
from planes.plans.assur.contours import Contour
from planes.plans.motion.carrying import carried
from planes.plans.motion.driven import driven_terms
from planes.plans.motion.kinematics import Rates
from planes.plans.motion.legs import Leg, lead_leg, outer_leg
from planes.plans.position.bodies import SCHEME, Body, BodyPoint
from planes.plans.position.contour_scheme import largest
from planes.scene.mechanism import FRAME
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

    @property
    def body(self) -> Body:
        """The link whose rotation the basic one has: itself, or the link it slides on."""
        return self.bodies.known[self.bodies.known[self.group.basic].root]

    def draw(self) -> None:
        r, base = self.rates, self.rod.known
        for leg, link in ((self.swing, self.group.base), (self.basic, self.group.basic)):
            body = self.bodies.known[link]
            if body.root == link:
                body.ref = leg.known, leg.new
                body.rigid = all(spot.name in body.link.points for spot in body.ref)
            else:
                body.moving = leg.new
            r.image(leg.link, leg.known)
        first = self.fixed(self.swing)
        second = self.draft.lay_off(r.plan, self.label(base, "II"), first, self.swing.along, self.false_rate(), FALSE)
        self.draft.step(Image(r.mark(base.name), first, *self.proportion(first, second), (first, second)))
        self.read(self.swing)
        r.driven.append(r.mark(base.name))
        r.solve(self.rod.new.name, r.chain(self.rod), r.chain(self.basic), (self.rod, self.basic))
        for link in (self.group.base, self.group.basic):
            r.show_points(link)
        self.read(self.other)
        for link in (part for lead in self.group.leads for part in lead.parts):
            r.show_points(link)

    def label(self, spot: BodyPoint, plan: str) -> str:
        """A point's label on a false plan."""
        label = self.rates.label(spot.name)
        return f"{label.removesuffix(chr(39))}_{plan}" + ("'" if label.endswith("'") else "")

    def mark(self, label: str) -> str:
        """A label's mark."""
        return at(self.rates.plan, label)

    def fixed(self, leg: Leg) -> str:
        """The end of the known part of an outer leg, whatever is assumed: for the base, at zero rate."""
        mark = self.rates.mark(leg.known.name)
        for term in self.known(leg):
            mark = self.draft.lay(self.rates.plan, replace(term, start=label_of(mark)))
        return mark

    def known(self, leg: Leg) -> Iterator[Term]:
        """The known part of a leg beyond its known point: normal and Coriolis components, the given rate of a drive."""
        r = self.rates
        if leg.drive:
            yield from [*driven_terms(r, leg, leg.drive)][:-1]
        elif r.quick and leg.pair is None:
            yield r.normal(leg, "")
        elif r.quick and self.bodies.known[leg.link].root != FRAME:
            yield r.across(leg, "")

    def false_rate(self) -> str:
        """The length of the vector that plan II assumes."""
        b, r = self.bodies, self.rates
        drive, ends = b.mechanism.drive, b.known[b.mechanism.drive.link].ref
        rate = {"velocity": drive.velocity, "acceleration": drive.velocity**2}.get(r.plan, 1.0) or 1.0
        given, named = b.draft.given, b.distance(b.known[drive.link].link, *ends) if ends else ""
        reach = next((abs(given[x]) for x in (named, self.swing.length) if x in given), largest(b, self.group))
        size = abs(rate) * (reach if drive.rotates else 1.0)
        return self.draft.give(f"{r.letter}{self.swing.symbol}^II", size, means=Meaning("rate", self.swing.new.name))

    def proportion(self, first: str, second: str) -> tuple[tuple[str, str], tuple[str, str]]:
        """The distance of the true plan from I, and of II from I, along the line of the second lead's false vectors."""
        d = self.draft
        (start, end), (from_, to) = self.supposed(first, "I"), self.supposed(second, "II")
        carried = d.step(Carry(self.mark(self.label(self.other.new, "II,I")), start, from_, to, means=FALSE))
        self.stretched(start, carried, "II,I")
        line = d.through(f"{self.other.new.name}^I{self.other.new.name}^II", end, carried, Meaning("guide"))
        foot = self.laid(self.other, start, "I")[0]
        met = self.mark(self.label(self.other.new, "0"))
        d.step(Cross(met, foot, self.other.along, end, line, means=FALSE))
        return (end, met), (end, carried)

    def supposed(self, hinge: str, plan: str) -> tuple[str, str]:
        """The ends of the second lead on a false plan, with the base's point of the first lead at its assumed place."""
        r, d = self.rates, self.draft
        pivot = self.swing.known
        near = start = r.mark(pivot.name)
        if near != hinge:
            start = self.mark(self.label(self.other.known, plan))
            if start != hinge:
                shape = self.scheme(pivot, self.other.known), self.scheme(pivot, self.rod.known)
                d.step(Image(start, near, *shape, (near, hinge), means=FALSE))
        met = self.mark(self.label(self.rod.new, plan))
        tied, terms = self.laid(self.rod, hinge, plan)
        back = self.fixed(self.basic)
        crossing = met, tied, self.rod.along, back, self.basic.along
        instead, basic = (self.other.along, self.far.along), self.group.basic
        d.step(CrossFalse(*crossing, instead=instead, means=Meaning("false", basic)))
        self.state(hinge, terms, met, plan)
        end = self.carried(met, plan)
        if start not in (near, hinge):
            d.show(r.plan, POLE, label_of(start), f"{r.letter}{self.other.known.name}^{plan}")
        self.stretched(start, end, plan)
        return start, end

    def stretched(self, start: str, end: str, plan: str) -> None:
        """Name the vector that the second lead would have on a false plan."""
        self.draft.show(
            self.rates.plan, label_of(start), label_of(end), f"{self.rates.letter}{self.other.symbol}^{plan}"
        )

    def laid(self, leg: Leg, start: str, plan: str) -> tuple[str, list[Term]]:
        """The known parts of a lead's rate on a false plan, from the assumed place of its first point; and their
        terms."""
        terms, mark = list[Term](), start
        for term in self.known(leg):
            end = f"{term.end.removesuffix(chr(39))},{plan}" + ("'" if term.end.endswith("'") else "")
            terms.append(replace(term, start=label_of(mark), end=end, drawn=True))
            mark = self.draft.lay_off(self.rates.plan, end, mark, term.direction or "", term.length or "", FALSE)
        return mark, terms

    def carried(self, met: str, plan: str) -> str:
        """The second lead's point of the basic link on a false plan, with the first one given."""
        r, d, end = self.rates, self.draft, self.mark(self.label(self.other.new, plan))
        if end == met:
            return met
        if self.body.link.name == self.group.basic:
            far, pivot = r.mark(self.basic.known.name), self.basic.known
            shape = self.scheme(pivot, self.other.new), self.scheme(pivot, self.rod.new)
            return d.step(Image(end, far, *shape, (far, met), means=FALSE))
        return carried(r, self.body, met, self.rod.new, self.other.new, end, FALSE)

    def state(self, hinge: str, terms: list[Term], met: str, plan: str) -> None:
        """State the equation of a false plan."""
        r, end = self.rates, label_of(met)
        one = [Term(f"{r.letter}{self.rod.known.name}^{plan}", POLE, label_of(hinge), drawn=True), *terms]
        two = [*r.chain(self.basic)][:-1]
        for chain, leg in ((one, self.rod), (two, self.basic)):
            part = ("r" if leg.pair else "t") if r.quick else ""
            name = f"{r.letter}{leg.symbol}^{part}{plan}"
            chain.append(Term(name, chain[-1].end, end, direction=leg.along, action=leg.along))
        self.draft.conclude(Equation(r.plan, (tuple(one), tuple(two)), f"{r.letter}{self.rod.new.name}^{plan}"))

    def scheme(self, *spots: BodyPoint) -> tuple[str, str]:
        """Two points on the scheme."""
        one, two = spots
        return at(SCHEME, one.place), at(SCHEME, two.place)

    def read(self, leg: Leg) -> None:
        """The readings from a link with both ends found."""
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
