"""Plans of rates: every group in its order; those with basic links on crossing leads by Assur's special points.

Of one basic link the third lead's point is found from its special point S; of two that are hinged to each other their
hinge, about the special points of both.
"""

from planes.plans.assur.basic_links import Triad
from planes.plans.assur.groups import Group
from planes.plans.assur.pairings import Pairing
from planes.plans.motion.contour_rates import ContourRates
from planes.plans.motion.kinematics import Rates
from planes.plans.motion.legs import lead_leg
from planes.plans.motion.slid_contour_rates import SlidContourRates
from planes.plans.motion.slid_rates import SlidRates
from planes.plans.motion.special_points import SpecialPoint
from planes.plans.position.bodies import BodyPoint


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
        self.special.meet(self.third)

    def draw(self) -> None:
        r, three = self.rates, self.third
        self.meet()
        self.special.solve()
        self.special.known_by(three.new)
        turning = self.special.about(three.new)
        r.solve(three.new.name, r.chain(turning), r.chain(three), (turning, three))
        self.special.read()
        for link in self.group.whole:
            r.show_points(link)


def _draw_pairing(r: Rates, g: Pairing) -> None:
    """Two basic links: their special points, then their hinge about both."""
    b, pin = r.bodies, BodyPoint(g.hinge.point, g.hinge.point)
    points = []
    for basic, (one, two) in zip(g.basics, g.sides, strict=True):
        points.append(SpecialPoint(r, basic, (lead_leg(b, basic, one), lead_leg(b, basic, two))))
    for point in points:
        point.meet()
        point.solve()
        point.known_by(pin)
    legs = [point.about(pin) for point in points]
    r.solve(pin.name, r.chain(legs[0]), r.chain(legs[1]), legs)
    for point in points:
        point.read()
    for link in g.whole:
        r.show_points(link)
