"""Plans of rates: every group in its order; those with basic links on crossing leads by Assur's special points.

Of one basic link the third lead's point is found from its special point S. Of two that are hinged to each other the
special point of one is what leads the other: their hinge goes about it as the end of a lead does.
"""

from functools import partial

from planes.drafting.steps.crossings import CrossLeads, CrossPaired
from planes.plans.assur.basic_links import Triad
from planes.plans.assur.groups import Group
from planes.plans.assur.pairings import Pairing
from planes.plans.motion.contour_rates import ContourRates
from planes.plans.motion.kinematics import Rates
from planes.plans.motion.legs import lead_leg
from planes.plans.motion.slid_contour_rates import SlidContourRates
from planes.plans.motion.slid_rates import SlidRates
from planes.plans.motion.special_points import SpecialPoint
from planes.plans.position.bodies import SCHEME, BodyPoint
from planes.words.names import at


def draw_rates(r: Rates) -> None:
    """The plan: the driver, then every group, then every point of every link."""
    for group in r.bodies.structure.groups:
        if isinstance(group, Triad) and not group.slid and any(lead.drive for lead in group.leads):
            _Triad(r, group).meet()  # its special point is found on the scheme before the plan is begun
    r.start()
    for group in r.bodies.structure.groups:
        match group:
            case Group():
                r.dyad(group)
            case Triad():
                (SlidRates if group.slid else _Triad)(r, group).draw()
            case Pairing():
                _draw_pairing(r, group)
            case _:
                (SlidContourRates if group.slid else ContourRates)(r, group).draw()


class _Triad:
    """The rates of one triad."""

    def __init__(self, r: Rates, g: Triad) -> None:
        self.rates, self.group = r, g
        one, two, self.third = (lead_leg(r.bodies, g.basic, lead) for lead in r.bodies.leads[g.basic])
        self.special = SpecialPoint(r, g.basic, (one, two))

    def meet(self) -> None:
        """Its special point on the scheme."""
        third, along = self.special.held(self.third)
        self.special.meet(partial(CrossLeads, third=third, third_along=along))

    def draw(self) -> None:
        self.meet()
        self.special.lead(self.third)
        for link in self.group.whole:
            self.rates.show_points(link)


def _draw_pairing(r: Rates, g: Pairing) -> None:
    """Two basic links: the special point of one, with their hinge, is a lead of the other one."""
    b, pin = r.bodies, BodyPoint(g.hinge.point, g.hinge.point)
    last = b.leads[g.basic][-1]
    legs = {lead: lead_leg(b, g.basics[k], lead) for k in (0, 1) for lead in g.sides[k]}
    sides, k = [[legs[lead] for lead in side] for side in g.sides], g.led(last)
    points = [SpecialPoint(r, basic, (one, two)) for basic, (one, two) in zip(g.basics, sides, strict=True)]
    held = [points[0].held(leg) for leg in legs.values()]
    places, lines = zip(*held, strict=True)
    turn = (*legs, g.joint).index(last)
    crossing = partial(CrossPaired, pin=at(SCHEME, pin.place), points=places, lines=lines, turn=turn)
    end = points[1 - k]
    end.meet(crossing)
    end.solve()
    end.known_by(pin)
    three = {**{lead: legs[lead] for lead in g.sides[k]}, g.joint: end.about(pin)}
    third = three.pop(last)
    one, two = three.values()
    basic = SpecialPoint(r, g.basics[k], (one, two))
    basic.meet(crossing)
    basic.lead(third)
    end.read()
    for link in g.whole:
        r.show_points(link)
