"""Velocity and acceleration plans: every group in its order; those of basic links with leads by Assur's special points.

The third lead's point is found from the special point S of the two others. Of several basic links joined by hinges the
special point of one, with their hinge, is a lead of the next, which then has three like any basic link of class III.
"""

from collections.abc import Iterable
from functools import partial

from planes.drafting.steps.by_leads import CrossInChain, CrossLeads
from planes.plans.assur.basic_chains import BasicChain
from planes.plans.assur.basic_links import Triad
from planes.plans.assur.groups import Group, Pair
from planes.plans.motion.contour_rates import ContourRates
from planes.plans.motion.kinematics import Rates
from planes.plans.motion.legs import Leg, leg_of_lead
from planes.plans.motion.slid_rates import SlidContourRates, SlidRates
from planes.plans.motion.special_points import SpecialPoint, point_and_line_of_lead
from planes.plans.position.bodies import BodyPoint
from planes.words.names import scheme_mark


class ChainRates:
    """The rates of one chain of basic links."""

    def __init__(self, r: Rates, g: BasicChain) -> None:
        self.rates = r
        self.group = g
        self.last = r.bodies.leads[g.basic][-1]
        self.own = {lead: leg_of_lead(r.bodies, g.basics[k], lead) for k, side in enumerate(g.sides) for lead in side}
        points, lines = zip(*(point_and_line_of_lead(r.draft, leg) for leg in self.own.values()), strict=True)
        pins = tuple(scheme_mark(hinge.point) for hinge in g.hinges)
        sides = tuple(k for k, side in enumerate(g.sides) for _ in side)
        own = partial(CrossInChain, points=points, lines=lines, sides=sides)
        self.crossing = partial(
            own, pins=pins, joined=g.basic_links_at_hinges, turn=(g.leads + g.joining_leads).index(self.last)
        )
        self.ends: list[SpecialPoint] = []  # links that act as leads, from the ends of the chain on
        for basic in g.basics:
            r.bodies.special_point_name(basic)

    def draw(self) -> None:
        k = self.group.root_basic_link(self.last)
        legs = self.leads_of_basic_link(k)
        third = legs.pop(self.last.inner)
        self.special_point_of_basic_link(k, legs.values()).draw_link_by_third_lead(third)
        for end in reversed(self.ends):
            end.read_lead_rates()
        for link in self.group.all_links:
            self.rates.draw_link_point_images(link)

    def leads_of_basic_link(self, k: int, but: Pair | None = None) -> dict[Pair, Leg]:
        """The leads of a basic link, including other basic links except the one at that hinge."""
        g = self.group
        legs = {lead.inner: self.own[lead] for lead in g.sides[k]}
        others = (
            (h, sum(ends) - k)
            for h, ends in zip(g.hinges, g.basic_links_at_hinges, strict=True)
            if k in ends and h != but
        )
        return legs | {hinge: self.leg_of_previous_basic_link(end, hinge) for hinge, end in others}

    def leg_of_previous_basic_link(self, end: int, hinge: Pair) -> Leg:
        """A basic link as a lead of the next one: its special point is found, and their hinge moves about that."""
        point = self.special_point_of_basic_link(end, self.leads_of_basic_link(end, hinge).values())
        pin = BodyPoint(hinge.point, hinge.point)
        point.solve()
        point.define_link_by_points(pin)
        self.ends.append(point)
        return point.leg_about_special_point(pin)

    def special_point_of_basic_link(self, k: int, legs: Iterable[Leg]) -> SpecialPoint:
        """The special point of a basic link, on the scheme."""
        one, two = legs
        point = SpecialPoint(self.rates, self.group.basics[k], (one, two))
        point.draw_special_point(self.crossing)
        return point


def draw_rates_plan(r: Rates) -> None:
    """The plan: the driver, then every group, then every point of every link."""
    for group in r.bodies.structure.groups:
        if isinstance(group, Triad) and not group.is_on_slides and any(lead.drive for lead in group.leads):
            _Triad(r, group).draw_special_point()  # its special point is found on the scheme before the plan is begun
    r.draw_pole_and_driver()
    for group in r.bodies.structure.groups:
        match group:
            case Group():
                r.dyad(group)
            case Triad():
                (SlidRates if group.is_on_slides else _Triad)(r, group).draw()
            case BasicChain():
                ChainRates(r, group).draw()
            case _:
                (SlidContourRates if group.is_on_slides else ContourRates)(r, group).draw()


class _Triad:
    """The rates of one triad."""

    def __init__(self, r: Rates, g: Triad) -> None:
        self.rates = r
        self.group = g
        one, two, self.third = (leg_of_lead(r.bodies, g.basic, lead) for lead in r.bodies.leads[g.basic])
        self.special = SpecialPoint(r, g.basic, (one, two))

    def draw_special_point(self) -> None:
        """Its special point on the scheme."""
        third, along = point_and_line_of_lead(self.rates.draft, self.third)
        self.special.draw_special_point(partial(CrossLeads, third=third, third_along=along))

    def draw(self) -> None:
        self.draw_special_point()
        self.special.draw_link_by_third_lead(self.third)
        for link in self.group.all_links:
            self.rates.draw_link_point_images(link)
