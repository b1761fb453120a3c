"""A group of class IV that hangs on two guides: how both links that do lie is known, and neither turns by itself.

So the base is drawn aside, anywhere on its guide, and the basic link from that by two leads, as by two links of a dyad;
then the figure is shifted along the base's guide until the basic link is on its own. Of rates likewise: first the base
is supposed not to slide, and what it really does carries the basic link along the base's guide.
"""

from dataclasses import replace

from planes.drafting.equations import Equation, Term
from planes.drafting.steps import Carry
from planes.drafting.steps.crossings import Cross
from planes.plans.basic_links import Lead
from planes.plans.bodies import SCHEME, AssemblyChoice, Bodies
from planes.plans.carrying import carried
from planes.plans.contour_rates import FALSE, ContourRates
from planes.plans.contours import Contour
from planes.plans.positions import chain_to, on_line, place_slider
from planes.plans.reckoned import OwnPlace, angle_deg, difference
from planes.plans.slid_triads import moved_over
from planes.plans.triads import place_lead
from planes.words.names import POLE, Meaning, at, label_of

STILL = Meaning("false", "still")


def place_slid_contour(b: Bodies, g: Contour) -> None:
    """Draw the base aside, the basic link by it, and both where they are."""
    BaseAside(b, g).place()


class BaseAside:
    """The figure with its base at the beginning of its guide."""

    def __init__(self, b: Bodies, g: Contour) -> None:
        self.bodies, self.group, self.draft = b, g, b.draft
        self.base, self.basic = b.mechanism.links[g.base], b.mechanism.links[g.basic]
        self.first = self.base.first_point
        (self.start, self.along), self.way = on_line(b, g.outer[0], g.base, self.first), ""
        self.axes = {g.base: b.axis_along(g.outer[0], g.base, self.along)}
        mate = b.known[g.outer[1].mate(g.basic)]
        self.way = b.direction_from(g.outer[1], mate.link.name, mate.axis)
        self.axes[g.basic] = b.axis_along(g.outer[1], g.basic, self.way)

    def place(self) -> None:
        b, d, g = self.bodies, self.draft, self.group
        hinges = [lead.inner.point for lead in g.leads if lead.inner.kind == "R"]
        key = hinges[0] if hinges else self.basic.first_point
        b.leads[g.basic] = g.leads
        one, two = (self.reaching(lead, key) for lead in g.leads)
        side = None if one[-1].direction and two[-1].direction else d.give(f"side_{key}", 1.0)
        if side:
            b.choices.append(AssemblyChoice(side, key, g))
        aside = f"{key}°{self.first}"
        d.draw(Equation(SCHEME, (one, two), f"r_{aside}", side))
        d.steps[at(SCHEME, aside)] = replace(d.steps[at(SCHEME, aside)], means=Meaning("guide", key))
        start, way = on_line(b, g.outer[1], g.basic, key)
        d.draw(Equation(SCHEME, (chain_to(key, aside, along=self.along), chain_to(key, start, along=way)), f"r_{key}"))
        d.step(Carry(at(SCHEME, self.first), at(SCHEME, key), at(SCHEME, aside), at(SCHEME, self.start)))
        place_slider(b, g.outer[0], g.base, self.first, self.along)
        place_slider(b, g.outer[1], g.basic, key, way)
        for lead in g.leads:
            place_lead(b, g.basic, lead)

    def reaching(self, lead: Lead, key: str) -> tuple[Term, Term]:
        """How a lead from the base reaches a point of the basic link, all of it aside."""
        b, outer, inner = self.bodies, lead.outer, lead.inner
        aside = f"{key}°{self.first}"
        if outer.kind == "P":
            along = b.direction_from(outer, self.base.name, self.axes[self.base.name])
            apart = difference(b.offset(outer, lead.link, inner.point), b.offset(outer, self.base.name, self.first))
            beside = Meaning("guide", outer.guide, inner.point)
            name = f"{inner.point}°{outer.guide}′"
            start = label_of(b.shifted(name, beside, at(SCHEME, self.start), along, apart))
            return chain_to(aside, moved_over(b, self.basic.name, start, inner.point, key, self.axis), along=along)
        start = self.point(outer.point)
        if inner.kind == "P":
            along = b.direction_from(inner, self.basic.name, self.axis)
            apart = difference(b.offset(inner, self.basic.name, key), b.offset(inner, lead.link, outer.point))
            beside = Meaning("guide", inner.guide, key)
            start = label_of(b.shifted(f"{key}°{inner.guide}′", beside, at(SCHEME, start), along, apart))
            return chain_to(aside, start, along=along)
        length = b.length(b.mechanism.links[lead.link], outer.point, inner.point)
        return chain_to(aside, moved_over(b, self.basic.name, start, inner.point, key, self.axis), length)

    @property
    def axis(self) -> str:
        """The basic link's own axis."""
        return self.axes[self.basic.name]

    def point(self, point: str) -> str:
        """The label of a point of the base, aside."""
        b, d, base = self.bodies, self.draft, self.base.name
        if point == self.first:
            return self.start
        turned = angle_deg(b.shape, OwnPlace(base, self.first), OwnPlace(base, point))
        ray = d.turn(f"→{self.first}{point}", self.axes[base], turned, Meaning("given", self.first))
        length, helper = b.length(self.base, self.first, point), Meaning("guide", point)
        return label_of(d.lay_off(SCHEME, f"{point}°{self.first}", at(SCHEME, self.start), ray, length, helper))


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
