"""Velocity and acceleration plans: groups to vector equations, with Coriolis wherever a guide turns.

Sources: theorem of plane motion v_C = v_B + v_CB and a_C = a_B + a_CB^n + a_CB^t; compound motion a_X = a_Y + a_XY^k +
a_XY^r with a^k = 2ω×v_XY (Coriolis).
"""

from collections.abc import Iterable

from planes.drafting.equations import Chain, Equation, Term
from planes.plans.assur.groups import Group
from planes.plans.motion.driven import draw_point_under_hinge, mark_at_drive_vector_end, terms_of_driven_leg
from planes.plans.motion.legs import Leg, SlideReading, legs_of_group
from planes.plans.motion.rate_plan import RatePlan, draw_point_turning_with_driver
from planes.scene.mechanism import DRIVE_RATE_KEYS, FRAME
from planes.words.names import POLE_LABEL, Mark, Meaning


class Rates(RatePlan):
    """Such a plan as it is drawn: the driver, then every group by the legs that lead to its new points."""

    def draw_pole_and_driver(self) -> None:
        """The pole, and the driver."""
        self.draft.draw_pole(self.plan)
        if self.bodies.structure.has_inner_drive:
            _driver_rate_name(self)
        else:
            _draw_driver_vectors(self)
            self.draw_link_point_images(self.bodies.mechanism.drive.link)

    def dyad(self, group: Group) -> None:
        """The new point of a group of class II by its two legs, then every point of its links."""
        if group.first not in self.bodies.standing:
            legs = legs_of_group(self.bodies, group)
            self.solve(legs[0].new.name, self.terms_to_new_point(legs[0]), self.terms_to_new_point(legs[1]), legs)
        for link in group.all_links:
            self.draw_link_point_images(link)

    def solve(self, new: str, one: Chain, two: Chain, legs: Iterable[Leg]) -> None:
        """A new point by two chains, and the readings from its legs."""
        self.draft.draw_equation(Equation(self.plan, (one, two), self.letter + new))
        self.driven.append(self.mark(new))
        for leg in legs:
            self.measure_leg_rates(leg)

    def terms_to_new_point(self, leg: Leg) -> Chain:
        """The terms from the pole through the known point to the new one."""
        self.image(leg.link, leg.known)
        known = self.label(leg.known.name)
        new = self.label(leg.new.name)
        name = leg.known.name if leg.known.name != POLE_LABEL else leg.symbol.removeprefix(leg.reached.name)
        start = Term(self.letter + name, POLE_LABEL, known, drawn=True, action="=0" if known == POLE_LABEL else "")
        relative = self.letter + leg.symbol
        if known == POLE_LABEL and leg.pair:  # the point of the frame under the slider has no name
            grounded = Meaning("rate", leg.reached.name, link=FRAME)
            self.draft.means |= dict.fromkeys((self.letter + name, relative), grounded)
        if leg.drive:
            return start, *terms_of_driven_leg(self, leg, leg.drive)
        if not self.is_acceleration_plan or (leg.pair and self.bodies.known[leg.link].root == FRAME):
            return start, Term(relative, known, new, direction=leg.along, action=leg.along)
        first, rest = (self.coriolis_component_term(leg, known), "r") if leg.pair else (self.normal(leg, known), "t")
        return start, first, Term(f"{relative}^{rest}", first.end, new, direction=leg.along, action=leg.along)

    def coriolis_component_term(self, leg: Leg, start: str) -> Term:
        """a^k, across the guide."""
        value = self.state_coriolis_length(leg)
        means = Meaning("coriolis", leg.symbol)
        name = f"a_{leg.symbol}^k"
        along = self.draft.draw_perpendicular(leg.along)
        return Term(name, start, f"k_{leg.symbol}", length=value, direction=along, action=along, means=means)

    def state_coriolis_length(self, leg: Leg) -> str:
        """a^k = 2ω v, the relative velocity turned by a right angle in the sense of ω."""
        root = self.bodies.known[leg.link].root
        return self.draft.add_product(f"a_{leg.symbol}^k", 2.0, **{f"omega_{root}": 1, f"v_{leg.symbol}": 1})

    def measure_leg_rates(self, leg: Leg) -> None:
        """Measure the angular rate of a turning link, or the rate of sliding."""
        d = self.draft
        if leg.pair is None and leg.turns:
            part = "^t" if self.is_acceleration_plan else ""
            d.add_product(self.spin(leg.turns), **{f"{self.letter}{leg.symbol}{part}": 1, leg.length or "": -1})
            self.turning[leg.turns] = (self.unknown_vector_start(leg), self.mark(leg.new.name), leg.along)
        elif leg.pair:
            self.slides[leg.pair.link] = self.sliding_rate_of_slider(leg)
        if leg.drive:
            draw_point_under_hinge(self, leg, leg.drive)

    def unknown_vector_start(self, leg: Leg) -> Mark:
        """The start mark of a leg's unknown vector."""
        if leg.drive:
            return mark_at_drive_vector_end(self, leg)
        return self.mark(leg.known.name)

    def sliding_rate_of_slider(self, leg: Leg) -> SlideReading:
        """The rate of the slider along its guide."""
        pair = leg.pair
        known = self.unknown_vector_start(leg)
        new = self.mark(leg.new.name)
        assert pair is not None
        turns = self.is_acceleration_plan and self.bodies.known[leg.link].root != FRAME
        middle = self.plan.mark(f"k_{leg.symbol}") if turns else known
        ends = (middle, new) if leg.slider_new else (new, middle)
        value = self.draft.measure_segment(f"{self.letter}slide_{pair.link}", *ends, leg.along)
        if not self.is_acceleration_plan:
            return SlideReading(pair.guide, value, ends, leg.along)
        coriolis = (known, middle) if leg.slider_new else (middle, known)
        return SlideReading(pair.guide, value, ends, leg.along, coriolis if turns else None)


def _driver_rate_name(r: Rates) -> str:
    """The name of the driver's given rate."""
    d = r.draft
    drive = r.bodies.mechanism.drive
    rate = {"velocity": drive.velocity, "motion": 1.0, "acceleration": drive.acceleration}[r.plan]
    value = d.add_given(r.drive_rate_name, rate)
    d.record_law(
        value,
        None
        if r.plan == "motion"
        else r.bodies.mechanism.laws.get(("drive", DRIVE_RATE_KEYS[drive.kind][r.is_acceleration_plan])),
    )
    return value


def _draw_driver_vectors(r: Rates) -> None:
    """The driver's motion: the first vectors of the plan, fully known."""
    d = r.draft
    drive = r.bodies.mechanism.drive
    value = _driver_rate_name(r)
    body = r.bodies.known[drive.link]
    if drive.kind == "s":
        first = body.base.name
        guide = r.bodies.structure.drive_pair.guide
        ends = r.plan.pole, r.mark(first)
        d.lay_off(r.plan, r.label(first), ends[0], f"∥{guide}", value)
        d.name_segment(r.plan, POLE_LABEL, r.label(first), r.letter + first)
        r.driven.append(ends[1])
        rate_name = d.measure_segment(f"{r.letter}slide_{drive.link}", *ends, f"∥{guide}")
        r.slides[drive.link] = SlideReading(guide, rate_name, ends, f"∥{guide}")
        return
    if body.ref:
        draw_point_turning_with_driver(r, body, body.ref[1])
        d.name_segment(r.plan, POLE_LABEL, r.label(body.ref[1].name), r.letter + body.ref[1].name)
        r.driven.append(r.mark(body.ref[1].name))
