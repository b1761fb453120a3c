"""Assur's special point of a basic link on velocity and acceleration plans: where the lines of two of its leads cross.

A lead lets its point move only across its own line, and S moves about that point across the same line: so both leads
give the direction of the relative velocity of S, v_S = v_E + (⊥ of the first) = v_F + (⊥ of the second). Accelerations
have normal and Coriolis components as well.
"""

from collections.abc import Callable
from dataclasses import replace

from planes.drafting.draft import Draft
from planes.drafting.equations import Chain, Term
from planes.drafting.steps import Turn
from planes.drafting.steps.crossings import Cross
from planes.plans.motion.kinematics import Rates
from planes.plans.motion.legs import Leg
from planes.plans.position.bodies import BodyPoint
from planes.words.names import SCHEME_PLAN, Meaning, NamePair, scheme_mark, split_value_name


class SpecialPoint:
    """The rates of a basic link's special point, and of the link by it."""

    def __init__(self, r: Rates, basic: str, legs: tuple[Leg, Leg]) -> None:
        self.rates = r
        self.bodies = r.bodies
        self.draft = r.draft
        self.basic = basic
        self.legs = legs
        name = r.bodies.special_point_name(basic)
        self.spot = BodyPoint(name, name)

    def draw_special_point(self, crossing: Callable[..., Cross]) -> None:
        """The point where the lines of two leads cross, by a step that knows when other leads would cross more
        sharply."""
        (a, along), (b, across) = (point_and_line_of_lead(self.draft, leg) for leg in self.legs)
        means = Meaning("special", self.basic)
        self.draft.add_step(crossing(scheme_mark(self.spot.place), a, along, b, across, means=means))

    def solve(self) -> None:
        """The end of its vector."""
        one, two = self.legs
        self.rates.solve(self.spot.name, self.terms_to_special_point(one), self.terms_to_special_point(two), ())

    def terms_to_special_point(self, leg: Leg) -> Chain:
        """The terms from the pole through the lead's support to S; both tangential components are one."""
        r = self.rates
        s = self.spot.name
        *known, last = r.terms_to_new_point(leg)
        symbol = s + leg.symbol.removeprefix((leg.spot or leg.new).name)
        part = split_value_name(last.name)[2]
        if r.is_acceleration_plan:
            known.append(self.lay_off_normal_acceleration(leg, last.start))
        name = f"{r.letter}{symbol}" + (f"^{part}" if part else "")
        return (*known, replace(last, name=name, start=known[-1].end, end=r.label(s)))

    def lay_off_normal_acceleration(self, leg: Leg, start: str) -> Term:
        """The normal acceleration of S about the lead's point, ω² l, laid off from ``start``."""
        s = self.spot.place
        new = leg.new
        d = self.draft
        length = d.measure_segment(f"l_{s}{new.place}", *SCHEME_PLAN.marks(s, new.place))
        name = f"a_{s}{new.name}"
        value = d.add_product(f"{name}^n", **{f"omega_{self.basic}": 2, length: 1})
        ray = d.direction_between_marks(s, new.place)
        along = d.add_step(Turn(f"{s}→{new.place}", ray, 0, means=Meaning("towards", s, new.place)))
        normal = Meaning("normal", s, new.name)
        return Term(f"{name}^n", start, f"n_{s}{new.name}", length=value, direction=along, action=along, means=normal)

    def leg_about_special_point(self, new: BodyPoint) -> Leg:
        """The motion of another point of the basic link about S."""
        s = self.spot
        d = self.draft
        ray = d.direction_between_marks(s.place, new.place)
        length = d.measure_segment(f"l_{new.place}{s.place}", *SCHEME_PLAN.marks(new.place, s.place))
        towards = d.direction_back_between_marks(s.place, new.place)
        turning = (d.draw_perpendicular(ray), length, towards, self.basic)
        return Leg(new, s, self.basic, new.name + s.name, *turning)

    def define_link_by_points(self, new: BodyPoint) -> None:
        """From now on the basic link is known by S and another point."""
        body = self.bodies.known[self.basic]
        body.ref = (self.spot, new)
        body.moving = new
        body.rigid = False

    def draw_link_by_third_lead(self, third: Leg) -> None:
        """The link's motion, by S and the lead that does not meet there."""
        r = self.rates
        self.solve()
        self.define_link_by_points(third.new)
        turning = self.leg_about_special_point(third.new)
        r.solve(third.new.name, r.terms_to_new_point(turning), r.terms_to_new_point(third), (turning, third))
        self.read_lead_rates()

    def read_lead_rates(self) -> None:
        """The points of the leads that meet in S, by similarity, and the readings from the leads."""
        r = self.rates
        for leg in self.legs:
            r.image(self.basic, leg.new)
            last = r.terms_to_new_point(leg)[-1]
            end = r.label(leg.new.name)
            self.draft.measure_segment(last.name, *r.plan.marks(last.start, end), last.direction)
            self.draft.name_segment(r.plan, last.start, end, last.name)
            r.measure_leg_rates(leg)


def point_and_line_of_lead(d: Draft, leg: Leg) -> NamePair:
    """The point of a lead and its line, across the point's possible motion."""
    line = (
        d.direction_between_marks(leg.known.place, leg.new.place)
        if leg.pair is None
        else d.draw_perpendicular(leg.along)
    )
    return scheme_mark(leg.new.place), line
