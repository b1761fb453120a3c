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
from planes.plans.motion.carrying import draw_carried_mark
from planes.plans.motion.contour_rates import FALSE_PLAN_MEANING, ContourRates
from planes.plans.motion.kinematics import Rates
from planes.plans.motion.legs import Leg, leg_by_outer_pair, leg_of_lead
from planes.plans.position.bodies import BodyPoint
from planes.scene.mechanism import FRAME
from planes.words.names import POLE_LABEL, MarkPair, Meaning

STILL_POINT_MEANING = Meaning("false", "still")


class SlidRates:
    """The rates of one such triad."""

    def __init__(self, r: Rates, g: Triad) -> None:
        self.rates = r
        self.group = g
        self.bodies = r.bodies
        self.draft = r.draft
        *leads, self.slid = r.bodies.leads[g.basic]
        self.one, self.two = (leg_of_lead(r.bodies, g.basic, lead) for lead in leads)

    def draw(self) -> None:
        r = self.rates
        b = self.bodies
        slid = self.slid
        body = b.known[self.group.basic]
        first = b.mechanism.links[slid.link].first_point
        body.moving = self.one.new
        r.image(self.two.link, self.two.known)
        moved = self.leg_to_other_point(self.two, self.one.new)
        r.solve(self.one.new.name, r.terms_to_new_point(self.one), r.terms_to_new_point(moved), (self.one, moved))
        r.image(self.group.basic, self.two.new)
        legs = [leg_by_outer_pair(b, pair, slid.link, BodyPoint(first, first)) for pair in (slid.outer, slid.inner)]
        r.solve(first, r.terms_to_new_point(legs[0]), r.terms_to_new_point(legs[1]), legs)
        for link in self.group.all_links:
            r.draw_link_point_images(link)

    def leg_to_other_point(self, leg: Leg, new: BodyPoint) -> Leg:
        """A leg to another point of the basic link, with its start shifted."""
        r = self.rates
        root = self.bodies.known[self.bodies.known[self.group.basic].root]
        if root.link.name == FRAME or leg.new == new:
            return replace(leg, new=new)
        name = (leg.known.name if leg.known.name != POLE_LABEL else leg.new.name) + "°"
        over = BodyPoint(leg.known.place, name)
        start = r.mark(leg.known.name)
        end = r.mark(name)
        draw_carried_mark(r, root, start, leg.new, new, end)
        to_known = Term(r.letter + leg.known.name, POLE_LABEL, start.label, drawn=True)
        over_it = Term(f"{r.letter}{new.name}{leg.new.name}", start.label, end.label, drawn=True)
        self.draft.measure_equation_results(Equation(r.plan, ((to_known, over_it), ()), r.letter + name))
        return replace(leg, new=new, known=over)


class SlidContourRates(ContourRates):
    """The rates of one such contour."""

    def draw(self) -> None:
        r = self.rates
        d = self.draft
        g = self.group
        still, away = self.draw_nonsliding_base()
        for link, spot in ((g.base, self.rod.known), (g.basic, self.rod.new)):
            self.bodies.known[link].moving = spot
        for leg in (self.swing, self.basic):
            r.image(leg.link, leg.known)
        new = r.label(self.rod.new.name)
        name = f"{r.letter}{self.rod.new.name}"
        along = self.swing.along
        slid = Term(f"{name}^II", away.label, new, None, along, along)
        start = Term(f"{name}^I", POLE_LABEL, away.label, drawn=True)
        r.solve(self.rod.new.name, (start, slid), r.terms_to_new_point(self.basic), (self.basic,))
        d.add_step(Carry(r.mark(self.rod.known.name), r.mark(self.rod.new.name), away, still))
        self.read_link_rates(self.swing)
        r.driven.append(r.mark(self.rod.known.name))
        for link in (g.base, g.basic):
            r.draw_link_point_images(link)
        for leg in (self.rod, self.other):
            self.read_link_rates(leg)
        for lead in g.leads:
            r.draw_link_point_images(lead.link)

    def draw_nonsliding_base(self) -> MarkPair:
        """A point of the base, and one of the basic link, for a base that does not slide."""
        r = self.rates
        d = self.draft
        r.image(self.swing.link, self.swing.known)
        hinge = self.known_part_end_of_leg(self.swing)
        base = self.bodies.known[self.group.base]
        end = self.mark(self.label(self.other.known, "I"))
        if end != hinge:
            root = self.bodies.known[base.root]
            draw_carried_mark(r, root, hinge, self.rod.known, self.other.known, end, FALSE_PLAN_MEANING)
        tied, terms = self.lay_off_known_parts(self.rod, hinge, "I")
        back, others = self.lay_off_known_parts(self.other, end, "I")
        if self.other.new != self.rod.new:
            over = self.mark(f"{self.label(self.other.new, 'I')}°")
            draw_carried_mark(r, self.rotating_link, back, self.other.new, self.rod.new, over, FALSE_PLAN_MEANING)
            name = f"{r.letter}{self.rod.new.name}{self.other.new.name}"
            others.append(Term(name, back.label, over.label, drawn=True))
            back = over
        met = self.mark(self.label(self.rod.new, "I"))
        d.add_step(Cross(met, tied, self.rod.along, back, self.other.along, means=STILL_POINT_MEANING))
        chains = []
        for leg, begin, known in ((self.rod, hinge, terms), (self.other, end, others)):
            part = ("r" if leg.pair else "t") if r.is_acceleration_plan else ""
            first = Term(f"{r.letter}{leg.known.name}^I", POLE_LABEL, begin.label, drawn=True)
            last = (known or [first])[-1].end, met.label
            chains.append((first, *known, Term(f"{r.letter}{leg.symbol}^{part}I", *last, None, leg.along, leg.along)))
        d.measure_equation_results(Equation(r.plan, (chains[0], chains[1]), f"{r.letter}{self.rod.new.name}^I"))
        return hinge, met
