"""Velocity and acceleration plans: groups to vector equations, with Coriolis wherever a guide turns.

Sources: theorem of plane motion v_C = v_B + v_CB and a_C = a_B + a_CB^n + a_CB^t; compound motion a_X = a_Y + a_XY^k +
a_XY^r with a^k = 2ω×v_XY (Coriolis).
"""

from collections.abc import Iterable
from dataclasses import dataclass, field

from planes.drafting.equations import Equation, Term
from planes.drafting.steps import Image, Same
from planes.plans.assur.groups import Group
from planes.plans.motion.driven import draw_point_under_hinge, mark_at_drive_vector_end, terms_of_driven_leg
from planes.plans.motion.legs import Leg, SlideReading, legs_of_group
from planes.plans.position.bodies import SCHEME_PLAN, Bodies, Body, BodyPoint
from planes.plans.position.braces import far_link_relative_rate
from planes.plans.position.reckoned import OwnPlace
from planes.scene.mechanism import DRIVE_RATE_KEYS, FRAME
from planes.words.names import POLE_LABEL, Meaning, full_mark_name


@dataclass
class Rates:
    """One velocity or acceleration plan: ``plan`` "velocity", "motion" (velocities of a unit drive) or
    "acceleration"."""

    bodies: Bodies
    plan: str
    turning: dict[str, tuple[str, str, str]] = field(default_factory=dict)
    slides: dict[str, SlideReading] = field(default_factory=dict)
    driven: list[str] = field(default_factory=list)

    @property
    def is_acceleration_plan(self) -> bool:
        """Whether this is an acceleration plan."""
        return self.plan == "acceleration"

    @property
    def letter(self) -> str:
        """First letter of the vectors' names."""
        return {"velocity": "v_", "motion": "vq_", "acceleration": "a_"}[self.plan]

    def spin(self, link: str) -> str:
        """Name of the angular velocity (or acceleration) of a link."""
        return {"velocity": "omega_", "motion": "omegaq_", "acceleration": "epsilon_"}[self.plan] + link

    @property
    def drive_rate_name(self) -> str:
        """Name of the rate of the drive."""
        drive = self.bodies.mechanism.drive
        return f"{self.letter}drive" if drive.kind == "s" else self.spin(drive.turning)

    @property
    def hinge_rate_name(self) -> str:
        """Name of the rate at which a motor turns the links of its hinge, or a cylinder the links it braces."""
        pair = self.bodies.structure.drive_pairs[-1]
        name = self.drive_rate_name
        if not self.bodies.reach:
            return name
        spun = self.spin(f"{pair.link}_{pair.other}")
        return far_link_relative_rate(self.bodies, self.plan, spun, name, self.relative_spin_name)

    @property
    def relative_spin_name(self) -> str:
        """Name of the relative angular velocity."""
        pair = self.bodies.structure.drive_pairs[-1]
        return f"omega_{pair.link}_{pair.other}" if self.bodies.reach else self.bodies.mechanism.drive.rate_names[0]

    def label(self, name: str) -> str:
        """The label of a point on this plan: small letters, primed for accelerations; the pole if fixed."""
        if name == POLE_LABEL or name in self.bodies.mechanism.frame.points:
            return POLE_LABEL
        small = self.bodies.plan_label_of_point(name)
        return small + "'" if self.is_acceleration_plan else small

    def mark(self, name: str) -> str:
        """The full name of a point's mark."""
        return full_mark_name(self.plan, self.label(name))

    def draw_pole_and_driver(self) -> None:
        """The pole, and the driver."""
        self.bodies.draft.draw_pole(self.plan)
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

    def solve(self, new: str, one: tuple[Term, ...], two: tuple[Term, ...], legs: Iterable[Leg]) -> None:
        """A new point by two chains, and the readings from its legs."""
        self.bodies.draft.draw_equation(Equation(self.plan, (one, two), self.letter + new))
        self.driven.append(self.mark(new))
        for leg in legs:
            self.measure_leg_rates(leg)

    def terms_to_new_point(self, leg: Leg) -> tuple[Term, ...]:
        """The terms from the pole through the known point to the new one."""
        self.image(leg.link, leg.known)
        known = self.label(leg.known.name)
        new = self.label(leg.new.name)
        name = leg.known.name if leg.known.name != POLE_LABEL else leg.symbol.removeprefix(leg.reached.name)
        start = Term(self.letter + name, POLE_LABEL, known, drawn=True, action="=0" if known == POLE_LABEL else "")
        relative = self.letter + leg.symbol
        if known == POLE_LABEL and leg.pair:  # the point of the frame under the slider has no name
            grounded = Meaning("rate", leg.reached.name, link=FRAME)
            self.bodies.draft.means |= dict.fromkeys((self.letter + name, relative), grounded)
        if leg.drive:
            return start, *terms_of_driven_leg(self, leg, leg.drive)
        if not self.is_acceleration_plan or (leg.pair and self.bodies.known[leg.link].root == FRAME):
            return start, Term(relative, known, new, direction=leg.along, action=leg.along)
        first, rest = (self.coriolis_component_term(leg, known), "r") if leg.pair else (self.normal(leg, known), "t")
        return start, first, Term(f"{relative}^{rest}", first.end, new, direction=leg.along, action=leg.along)

    def normal(self, leg: Leg, start: str) -> Term:
        """a^n = v²/l, towards the pivot."""
        name = f"a_{leg.symbol}^n"
        towards = leg.towards or ""
        value = self.bodies.draft.add_product(name, **{f"v_{leg.symbol}": 2, leg.length or "": -1})
        means = Meaning("normal", leg.symbol)
        return Term(name, start, f"n_{leg.symbol}", length=value, direction=towards, action=towards, means=means)

    def coriolis_component_term(self, leg: Leg, start: str) -> Term:
        """a^k, across the guide."""
        value = self.state_coriolis_length(leg)
        means = Meaning("coriolis", leg.symbol)
        name = f"a_{leg.symbol}^k"
        along = self.bodies.draft.draw_perpendicular(leg.along)
        return Term(name, start, f"k_{leg.symbol}", length=value, direction=along, action=along, means=means)

    def state_coriolis_length(self, leg: Leg) -> str:
        """a^k = 2ω v, the relative velocity turned by a right angle in the sense of ω."""
        root = self.bodies.known[leg.link].root
        return self.bodies.draft.add_product(f"a_{leg.symbol}^k", 2.0, **{f"omega_{root}": 1, f"v_{leg.symbol}": 1})

    def measure_leg_rates(self, leg: Leg) -> None:
        """Measure the angular rate of a turning link, or the rate of sliding."""
        d = self.bodies.draft
        if leg.pair is None and leg.turns:
            part = "^t" if self.is_acceleration_plan else ""
            d.add_product(self.spin(leg.turns), **{f"{self.letter}{leg.symbol}{part}": 1, leg.length or "": -1})
            self.turning[leg.turns] = (self.unknown_vector_start(leg), self.mark(leg.new.name), leg.along)
        elif leg.pair:
            self.slides[leg.pair.link] = self.sliding_rate_of_slider(leg)
        if leg.drive:
            draw_point_under_hinge(self, leg, leg.drive)

    def unknown_vector_start(self, leg: Leg) -> str:
        """The start mark of a leg's unknown vector."""
        return mark_at_drive_vector_end(self, leg) if leg.drive else self.mark(leg.known.name)

    def sliding_rate_of_slider(self, leg: Leg) -> SlideReading:
        """The rate of the slider along its guide."""
        pair = leg.pair
        known = self.unknown_vector_start(leg)
        new = self.mark(leg.new.name)
        assert pair is not None
        turns = self.is_acceleration_plan and self.bodies.known[leg.link].root != FRAME
        middle = full_mark_name(self.plan, f"k_{leg.symbol}") if turns else known
        ends = (middle, new) if leg.slider_new else (new, middle)
        value = self.bodies.draft.measure_segment(f"{self.letter}slide_{pair.link}", *ends, leg.along)
        if not self.is_acceleration_plan:
            return SlideReading(pair.guide, value, ends, leg.along)
        coriolis = (known, middle) if leg.slider_new else (middle, known)
        return SlideReading(pair.guide, value, ends, leg.along, coriolis if turns else None)

    def draw_link_point_images(self, link: str) -> None:
        """The image of every point of the link, and its segment from the pole, the velocity or acceleration."""
        for name in self.bodies.mechanism.links[link].points:
            self.image(link, BodyPoint(name, name))

    def image(self, link: str, spot: BodyPoint) -> None:
        """Draw the end of a point's vector, by similarity with the known points of its link."""
        mark = self.mark(spot.name)
        if mark in self.bodies.draft.steps:
            return
        body = self.bodies.known[link]
        root = self.bodies.known[body.root]
        carrier = self.mark(body.first_reached_point.name)
        if body.root == FRAME:
            self.bodies.draft.add_step(Same(mark, carrier))
        elif root is body and body.rigid and body.ref and spot.name in body.link.points:
            one, two = (self.mark(s.name) for s in body.ref)
            self.bodies.mark_by_similarity(mark, body, spot.name, OwnPlace(body.link.name, spot.name), (one, two))
        elif root.ref:
            like = root.ref
            scheme = tuple(full_mark_name(SCHEME_PLAN, s.place) for s in (body.first_reached_point, spot, *like))
            ends = self.mark(like[0].name), self.mark(like[1].name)
            self.bodies.draft.add_step(Image(mark, carrier, (scheme[0], scheme[1]), (scheme[2], scheme[3]), ends))
        else:
            draw_point_turning_with_driver(self, body, spot)
        self.bodies.draft.name_segment(self.plan, POLE_LABEL, self.label(spot.name), self.letter + spot.name)


def _driver_rate_name(r: Rates) -> str:
    """The name of the driver's given rate."""
    d = r.bodies.draft
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
    d = r.bodies.draft
    drive = r.bodies.mechanism.drive
    value = _driver_rate_name(r)
    body = r.bodies.known[drive.link]
    if drive.kind == "s":
        first = body.base.name
        guide = r.bodies.structure.drive_pair.guide
        ends = full_mark_name(r.plan, POLE_LABEL), r.mark(first)
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


def draw_point_turning_with_driver(r: Rates, body: Body, spot: BodyPoint) -> None:
    """The end of the vector of a point on a link that turns with the driver, by rotation about the link's carrier: the
    driver's pivot on the frame, or the point by which a link that slides on the driver is reached."""
    d = r.bodies.draft
    centre = body.first_reached_point
    ray = d.direction_between_marks(SCHEME_PLAN, centre.place, spot.place)
    across = d.draw_perpendicular(ray)
    length = r.bodies.distance_of_places(body.link, centre, spot)
    start = r.label(centre.name)
    end = r.label(spot.name)
    total = r.letter + spot.name
    own = start == POLE_LABEL
    name = total if own else total + centre.name
    base = () if own else (Term(r.letter + centre.name, POLE_LABEL, start, drawn=True),)
    if not r.is_acceleration_plan:
        value = d.add_product(name, **{r.spin(body.root): 1, length: 1})
        if own:
            d.lay_off(r.plan, end, full_mark_name(r.plan, POLE_LABEL), across, value)
        else:
            d.draw_equation(Equation(r.plan, ((*base, Term(name, start, end, value, across, across)), ()), total))
        return
    normal = d.add_product(f"{name}^n", **{f"omega_{body.root}": 2, length: 1})
    tangential = d.add_product(f"{name}^t", **{f"epsilon_{body.root}": 1, length: 1})
    inwards = d.direction_back_between_marks(SCHEME_PLAN, centre.place, spot.place)
    middle = "n_" + name.removeprefix(r.letter)
    turning = Meaning("normal", spot.name, centre.name)
    chain = (
        *base,
        Term(f"{name}^n", start, middle, length=normal, direction=inwards, action=inwards, means=turning),
        Term(f"{name}^t", middle, end, length=tangential, direction=across, action=across),
    )
    d.draw_equation(Equation(r.plan, (chain, ()), total))
