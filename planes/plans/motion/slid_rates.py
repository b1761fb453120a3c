"""Plans of rates of a triad one lead of which slides at both ends.

Its other leads reach one point of the basic link, as they did on the scheme, where what one of them hangs on was moved
over: the moved point goes with what it was moved from, and about that as the basic link turns.
"""

from dataclasses import replace

from planes.drafting.equations import Equation, Term
from planes.plans.assur.basic_links import Triad
from planes.plans.motion.carrying import carried
from planes.plans.motion.kinematics import Rates
from planes.plans.motion.legs import Leg, lead_leg, outer_leg
from planes.plans.position.bodies import BodyPoint
from planes.scene.mechanism import FRAME
from planes.words.names import POLE, label_of


class SlidRates:
    """The rates of one such triad."""

    def __init__(self, r: Rates, g: Triad) -> None:
        self.rates, self.group, self.bodies, self.draft = r, g, r.bodies, r.bodies.draft
        *leads, self.slid = r.bodies.leads[g.basic]
        self.one, self.two = (lead_leg(r.bodies, g.basic, lead) for lead in leads)

    def draw(self) -> None:
        r, b, slid = self.rates, self.bodies, self.slid
        body, first = b.known[self.group.basic], b.mechanism.links[slid.link].first_point
        body.moving = self.one.new
        r.image(self.two.link, self.two.known)
        moved = self.moved(self.two, self.one.new)
        r.solve(self.one.new.name, r.chain(self.one), r.chain(moved), (self.one, moved))
        r.image(self.group.basic, self.two.new)
        legs = [outer_leg(b, pair, slid.link, BodyPoint(first, first)) for pair in (slid.outer, slid.inner)]
        r.solve(first, r.chain(legs[0]), r.chain(legs[1]), legs)
        for link in self.group.whole:
            r.show_points(link)

    def moved(self, leg: Leg, new: BodyPoint) -> Leg:
        """A leg to another point of the basic link, what it starts from moved over."""
        r, root = self.rates, self.bodies.known[self.bodies.known[self.group.basic].root]
        if root.link.name == FRAME or leg.new == new:
            return replace(leg, new=new)
        name = (leg.known.name if leg.known.name != POLE else leg.new.name) + "°"
        over, start, end = BodyPoint(leg.known.place, name), r.mark(leg.known.name), r.mark(name)
        carried(r, root, start, leg.new, new, end)
        to_known = Term(r.letter + leg.known.name, POLE, label_of(start), drawn=True)
        over_it = Term(f"{r.letter}{new.name}{leg.new.name}", label_of(start), label_of(end), drawn=True)
        self.draft.conclude(Equation(r.plan, ((to_known, over_it), ()), r.letter + name))
        return replace(leg, new=new, known=over)
