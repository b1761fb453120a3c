"""Plans of rates: every group in its order; those with basic links on crossing leads by Assur's special points.

The third lead's point is found from the special point S of the two others.
"""

from functools import partial

from planes.drafting.steps.by_leads import CrossLeads
from planes.plans.assur.basic_chains import BasicChain
from planes.plans.assur.basic_links import Triad
from planes.plans.assur.groups import Group
from planes.plans.motion.chain_rates import ChainRates
from planes.plans.motion.contour_rates import ContourRates
from planes.plans.motion.kinematics import Rates
from planes.plans.motion.legs import lead_leg
from planes.plans.motion.slid_contour_rates import SlidContourRates
from planes.plans.motion.slid_rates import SlidRates
from planes.plans.motion.special_points import SpecialPoint, line_of


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
            case BasicChain():
                ChainRates(r, group).draw()
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
        third, along = line_of(self.rates.bodies.draft, self.third)
        self.special.meet(partial(CrossLeads, third=third, third_along=along))

    def draw(self) -> None:
        self.meet()
        self.special.lead(self.third)
        for link in self.group.whole:
            self.rates.show_points(link)
