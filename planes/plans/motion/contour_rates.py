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
from planes.plans.motion.carrying import draw_carried_mark
from planes.plans.motion.driven import terms_of_driven_leg
from planes.plans.motion.kinematics import Rates
from planes.plans.motion.legs import Leg, leg_by_outer_pair, leg_of_lead
from planes.plans.position.bodies import Body, BodyPoint
from planes.plans.position.contour_scheme import largest_link_size
from planes.scene.mechanism import FRAME
from planes.words.names import POLE_LABEL, SCHEME_PLAN, Mark, MarkPair, Meaning

FALSE_PLAN_MEANING = Meaning("false")


class ContourRates:
    """The rates of one contour."""

    def __init__(self, r: Rates, g: Contour) -> None:
        self.rates = r
        self.group = g
        self.bodies = r.bodies
        self.draft = r.draft
        leads = r.bodies.leads[g.basic]
        self.rod, self.other = (leg_of_lead(r.bodies, g.basic, lead) for lead in leads)
        self.swing = leg_by_outer_pair(r.bodies, g.outer[0], g.base, self.rod.known)
        self.basic = leg_by_outer_pair(r.bodies, g.outer[1], g.basic, self.rod.new)
        self.far = leg_by_outer_pair(r.bodies, g.outer[1], g.basic, self.other.new)

    @property
    def rotating_link(self) -> Body:
        """The link whose rotation the basic one has: itself, or the link it slides on."""
        return self.bodies.known[self.bodies.known[self.group.basic].root]

    def draw(self) -> None:
        r = self.rates
        base = self.rod.known
        for leg, link in ((self.swing, self.group.base), (self.basic, self.group.basic)):
            body = self.bodies.known[link]
            if body.root == link:
                body.ref = leg.known, leg.new
                body.rigid = all(spot.name in body.link.points for spot in body.ref)
            else:
                body.moving = leg.new
            r.image(leg.link, leg.known)
        first = self.known_part_end_of_leg(self.swing)
        second = self.draft.lay_off(
            r.plan, self.label(base, "II"), first, self.swing.along, self.assumed_vector_length(), FALSE_PLAN_MEANING
        )
        self.draft.add_step(Image(r.mark(base.name), first, *self.false_plan_distances(first, second), (first, second)))
        self.read_link_rates(self.swing)
        r.driven.append(r.mark(base.name))
        r.solve(
            self.rod.new.name, r.terms_to_new_point(self.rod), r.terms_to_new_point(self.basic), (self.rod, self.basic)
        )
        for link in (self.group.base, self.group.basic):
            r.draw_link_point_images(link)
        self.read_link_rates(self.other)
        for link in (part for lead in self.group.leads for part in lead.lead_links):
            r.draw_link_point_images(link)

    def label(self, spot: BodyPoint, plan: str) -> str:
        """A point's label on a false plan."""
        label = self.rates.label(spot.name)
        return f"{label.removesuffix(chr(39))}_{plan}" + ("'" if label.endswith("'") else "")

    def mark(self, label: str) -> Mark:
        """A label's mark."""
        return self.rates.plan.mark(label)

    def known_part_end_of_leg(self, leg: Leg) -> Mark:
        """The end of the known part of an outer leg, whatever is assumed: for the base, at zero rate."""
        mark = self.rates.mark(leg.known.name)
        for term in self.known_part_of_leg(leg):
            mark = self.draft.lay_off_known_vector(self.rates.plan, replace(term, start=mark.label))
        return mark

    def known_part_of_leg(self, leg: Leg) -> Iterator[Term]:
        """The known part of a leg beyond its known point: normal and Coriolis components, the given rate of a drive."""
        r = self.rates
        if leg.drive:
            yield from [*terms_of_driven_leg(r, leg, leg.drive)][:-1]
        elif r.is_acceleration_plan and leg.pair is None:
            yield r.normal(leg, "")
        elif r.is_acceleration_plan and self.bodies.known[leg.link].root != FRAME:
            yield r.coriolis_component_term(leg, "")

    def assumed_vector_length(self) -> str:
        """The length of the vector that plan II assumes."""
        b = self.bodies
        r = self.rates
        drive = b.mechanism.drive
        ends = b.known[b.mechanism.drive.link].ref
        rate = {"velocity": drive.velocity, "acceleration": drive.velocity**2}.get(r.plan, 1.0) or 1.0
        given = b.draft.given
        named = b.distance_of_places(b.known[drive.link].link, *ends) if ends else ""
        reach = next(
            (abs(given[x]) for x in (named, self.swing.length) if x in given), largest_link_size(b, self.group)
        )
        size = abs(rate) * (reach if drive.rotates else 1.0)
        return self.draft.add_given(
            f"{r.letter}{self.swing.symbol}^II", size, means=Meaning("rate", self.swing.new.name)
        )

    def false_plan_distances(self, first: Mark, second: Mark) -> tuple[MarkPair, MarkPair]:
        """The distance of the true plan from I, and of II from I, along the line of the second lead's false vectors."""
        d = self.draft
        start, end = self.assumed_second_lead_ends(first, "I")
        from_, to = self.assumed_second_lead_ends(second, "II")
        carried = d.draw_mark(
            Carry(self.mark(self.label(self.other.new, "II,I")), start, from_, to, means=FALSE_PLAN_MEANING)
        )
        self.name_assumed_vector(start, carried, "II,I")
        line = d.draw_direction_through_marks(
            f"{self.other.new.name}^I{self.other.new.name}^II", end, carried, Meaning("guide")
        )
        foot = self.lay_off_known_parts(self.other, start, "I")[0]
        met = self.mark(self.label(self.other.new, "0"))
        d.add_step(Cross(met, foot, self.other.along, end, line, means=FALSE_PLAN_MEANING))
        return (end, met), (end, carried)

    def assumed_second_lead_ends(self, hinge: Mark, plan: str) -> MarkPair:
        """The ends of the second lead on a false plan, with the base's point of the first lead at its assumed place."""
        r = self.rates
        d = self.draft
        pivot = self.swing.known
        near = start = r.mark(pivot.name)
        if near != hinge:
            start = self.mark(self.label(self.other.known, plan))
            if start != hinge:
                shape = self.points_on_scheme(pivot, self.other.known), self.points_on_scheme(pivot, self.rod.known)
                d.add_step(Image(start, near, *shape, (near, hinge), means=FALSE_PLAN_MEANING))
        met = self.mark(self.label(self.rod.new, plan))
        tied, terms = self.lay_off_known_parts(self.rod, hinge, plan)
        back = self.known_part_end_of_leg(self.basic)
        crossing = met, tied, self.rod.along, back, self.basic.along
        instead = (self.other.along, self.far.along)
        basic = self.group.basic
        d.add_step(CrossFalse(*crossing, instead=instead, means=Meaning("false", basic)))
        self.state_false_plan_equation(hinge, terms, met, plan)
        end = self.second_lead_point_on_false_plan(met, plan)
        if start not in (near, hinge):
            d.name_segment(r.plan, POLE_LABEL, start.label, f"{r.letter}{self.other.known.name}^{plan}")
        self.name_assumed_vector(start, end, plan)
        return start, end

    def name_assumed_vector(self, start: Mark, end: Mark, plan: str) -> None:
        """Name the vector that the second lead would have on a false plan."""
        self.draft.name_segment(
            self.rates.plan, start.label, end.label, f"{self.rates.letter}{self.other.symbol}^{plan}"
        )

    def lay_off_known_parts(self, leg: Leg, start: Mark, plan: str) -> tuple[Mark, list[Term]]:
        """The known parts of a lead's rate on a false plan, from the assumed place of its first point; and their
        terms."""
        terms = []
        mark = start
        for term in self.known_part_of_leg(leg):
            end = f"{term.end.removesuffix(chr(39))},{plan}" + ("'" if term.end.endswith("'") else "")
            terms.append(replace(term, start=mark.label, end=end, drawn=True))
            mark = self.draft.lay_off(
                self.rates.plan, end, mark, term.direction or "", term.length or "", FALSE_PLAN_MEANING
            )
        return mark, terms

    def second_lead_point_on_false_plan(self, met: Mark, plan: str) -> Mark:
        """The second lead's point of the basic link on a false plan, with the first one given."""
        r = self.rates
        d = self.draft
        end = self.mark(self.label(self.other.new, plan))
        if end == met:
            return met
        if self.rotating_link.link.name == self.group.basic:
            far = r.mark(self.basic.known.name)
            pivot = self.basic.known
            shape = self.points_on_scheme(pivot, self.other.new), self.points_on_scheme(pivot, self.rod.new)
            return d.draw_mark(Image(end, far, *shape, (far, met), means=FALSE_PLAN_MEANING))
        return draw_carried_mark(r, self.rotating_link, met, self.rod.new, self.other.new, end, FALSE_PLAN_MEANING)

    def state_false_plan_equation(self, hinge: Mark, terms: list[Term], met: Mark, plan: str) -> None:
        """State the equation of a false plan."""
        r = self.rates
        end = met.label
        one = [Term(f"{r.letter}{self.rod.known.name}^{plan}", POLE_LABEL, hinge.label, drawn=True), *terms]
        two = [*r.terms_to_new_point(self.basic)][:-1]
        for chain, leg in ((one, self.rod), (two, self.basic)):
            part = ("r" if leg.pair else "t") if r.is_acceleration_plan else ""
            name = f"{r.letter}{leg.symbol}^{part}{plan}"
            chain.append(Term(name, chain[-1].end, end, direction=leg.along, action=leg.along))
        self.draft.measure_equation_results(
            Equation(r.plan, (tuple(one), tuple(two)), f"{r.letter}{self.rod.new.name}^{plan}")
        )

    def points_on_scheme(self, *spots: BodyPoint) -> MarkPair:
        """Two points on the scheme."""
        one, two = spots
        return SCHEME_PLAN.marks(one.place, two.place)

    def read_link_rates(self, leg: Leg) -> None:
        """The readings from a link with both ends found."""
        r = self.rates
        d = self.draft
        r.image(leg.link, leg.known)
        r.image(self.group.base if leg is self.swing else self.group.basic, leg.new)
        *known, last = r.terms_to_new_point(leg)
        for term in known:
            d.lay_off_known_vector(r.plan, term)
            d.name_segment(r.plan, term.start, term.end, term.name)
        end = r.label(leg.new.name)
        d.measure_segment(last.name, *r.plan.marks(last.start, end), last.direction)
        d.name_segment(r.plan, last.start, end, last.name)
        r.measure_leg_rates(leg)
