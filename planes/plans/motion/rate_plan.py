"""A velocity or acceleration plan: how its vectors are named, and the images of a link's points on it."""

from dataclasses import dataclass, field

from planes.drafting.draft import Draft
from planes.drafting.equations import Equation, Term
from planes.drafting.steps import Image, Same
from planes.plans.motion.legs import Leg, SlideReading
from planes.plans.position.bodies import Bodies, Body, BodyPoint
from planes.plans.position.braces import far_link_relative_rate
from planes.plans.position.reckoned import OwnPlace
from planes.scene.mechanism import FRAME
from planes.words.names import POLE_LABEL, Mark, Meaning, PlanId, scheme_mark


@dataclass
class RatePlan:
    """One velocity or acceleration plan: ``plan`` "velocity", "motion" (velocities of a unit drive) or
    "acceleration"."""

    bodies: Bodies
    plan: PlanId
    turning: dict[str, tuple[Mark, Mark, str]] = field(default_factory=dict)
    slides: dict[str, SlideReading] = field(default_factory=dict)
    driven: list[Mark] = field(default_factory=list)

    @property
    def draft(self) -> Draft:
        """The draft of the plan."""
        return self.bodies.draft

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
        if drive.kind == "s":
            return f"{self.letter}drive"
        return self.spin(drive.turning)

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
        if self.bodies.reach:
            return f"omega_{pair.link}_{pair.other}"
        return self.bodies.mechanism.drive.rate_names[0]

    def label(self, name: str) -> str:
        """The label of a point on this plan: small letters, primed for accelerations; the pole if fixed."""
        if name == POLE_LABEL or name in self.bodies.mechanism.frame.points:
            return POLE_LABEL
        small = self.bodies.plan_label_of_point(name)
        return small + "'" if self.is_acceleration_plan else small

    def mark(self, name: str) -> Mark:
        """The full name of a point's mark."""
        return self.plan.mark(self.label(name))

    def normal(self, leg: Leg, start: str) -> Term:
        """a^n = v²/l, towards the pivot."""
        name = f"a_{leg.symbol}^n"
        towards = leg.towards or ""
        value = self.draft.add_product(name, **{f"v_{leg.symbol}": 2, leg.length or "": -1})
        means = Meaning("normal", leg.symbol)
        return Term(name, start, f"n_{leg.symbol}", length=value, direction=towards, action=towards, means=means)

    def draw_link_point_images(self, link: str) -> None:
        """The image of every point of the link, and its segment from the pole, the velocity or acceleration."""
        for name in self.bodies.mechanism.links[link].points:
            self.image(link, BodyPoint(name, name))

    def image(self, link: str, spot: BodyPoint) -> None:
        """Draw the end of a point's vector, by similarity with the known points of its link."""
        mark = self.mark(spot.name)
        if mark in self.draft.steps:
            return
        body = self.bodies.known[link]
        root = self.bodies.known[body.root]
        carrier = self.mark(body.first_reached_point.name)
        if body.root == FRAME:
            self.draft.add_step(Same(mark, carrier))
        elif root is body and body.rigid and body.ref and spot.name in body.link.points:
            one, two = (self.mark(s.name) for s in body.ref)
            self.bodies.mark_by_similarity(mark, body, spot.name, OwnPlace(body.link.name, spot.name), (one, two))
        elif root.ref:
            like = root.ref
            scheme = tuple(scheme_mark(s.place) for s in (body.first_reached_point, spot, *like))
            ends = self.mark(like[0].name), self.mark(like[1].name)
            self.draft.add_step(Image(mark, carrier, (scheme[0], scheme[1]), (scheme[2], scheme[3]), ends))
        else:
            draw_point_turning_with_driver(self, body, spot)
        self.draft.name_segment(self.plan, POLE_LABEL, self.label(spot.name), self.letter + spot.name)


def draw_point_turning_with_driver(r: RatePlan, body: Body, spot: BodyPoint) -> None:
    """The end of the vector of a point on a link that turns with the driver, by rotation about the link's carrier: the
    driver's pivot on the frame, or the point by which a link that slides on the driver is reached."""
    d = r.draft
    centre = body.first_reached_point
    ray = d.direction_between_marks(centre.place, spot.place)
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
            d.lay_off(r.plan, end, r.plan.pole, across, value)
        else:
            d.draw_equation(Equation(r.plan, ((*base, Term(name, start, end, value, across, across)), ()), total))
        return
    normal = d.add_product(f"{name}^n", **{f"omega_{body.root}": 2, length: 1})
    tangential = d.add_product(f"{name}^t", **{f"epsilon_{body.root}": 1, length: 1})
    inwards = d.direction_back_between_marks(centre.place, spot.place)
    middle = "n_" + name.removeprefix(r.letter)
    turning = Meaning("normal", spot.name, centre.name)
    chain = (
        *base,
        Term(f"{name}^n", start, middle, length=normal, direction=inwards, action=inwards, means=turning),
        Term(f"{name}^t", middle, end, length=tangential, direction=across, action=across),
    )
    d.draw_equation(Equation(r.plan, (chain, ()), total))
