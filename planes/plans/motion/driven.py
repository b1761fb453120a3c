"""The hinge of the driven link on the velocity and acceleration plans: it moves about the pivot with the link of the
drive that is on the frame, and relative to it at the given rate, v_A = v_D + v_AA1 + v_A1D with v_AA1 known: along the
guide of a cylinder, across the arm of a motor in a hinge; in accelerations with Coriolis."""

from collections.abc import Iterator

from planes.drafting.equations import Term
from planes.drafting.steps import Carry, Turn
from planes.drafting.steps.reckoning import Product
from planes.plans.assur.groups import Pair
from planes.plans.motion.legs import Leg, SlideReading
from planes.plans.motion.rate_plan import RatePlan
from planes.plans.position.bodies import BodyPoint
from planes.words.names import POLE_LABEL, Mark, Meaning


def terms_of_driven_leg(r: RatePlan, leg: Leg, drive: Pair) -> Iterator[Term]:
    """The vectors from the pivot's end to the new one: first the given ones, the rotation last."""
    given = [*(_turning_drive_terms if drive.kind == "R" else _sliding_drive_terms)(r, leg, drive)]
    yield from given
    name = r.letter + leg.symbol
    end = given[-1].end
    if r.is_acceleration_plan and leg.turns:
        inward = r.normal(leg, end)
        yield inward
        name = f"{name}^t"
        end = inward.end
    yield Term(name, end, r.label(leg.new.name), direction=leg.along, action=leg.along)


def _sliding_drive_terms(r: RatePlan, leg: Leg, drive: Pair) -> Iterator[Term]:
    """Along the guide, with Coriolis across it."""
    d = r.draft
    along = f"∥{drive.guide}"
    if leg.held == drive.link:  # the guide moves against the slider
        along = d.add_step(Turn(f"-{along}", along, 2, means=Meaning("along", drive.guide)))
    start = r.label(leg.known.name)
    bent = r.is_acceleration_plan and leg.turns
    if bent:
        yield (coriolis := _drive_coriolis_term(r, leg, d.draw_perpendicular(along)))
        start = coriolis.end
    name = r.letter + leg.driven + ("^r" if bent else "")
    yield _relative_vector_term(r, leg, name, start, r.drive_rate_name, along, f"∥{drive.guide}")


def _turning_drive_terms(r: RatePlan, leg: Leg, drive: Pair) -> Iterator[Term]:
    """Across the arm from the motor, with Coriolis and the normal component along it."""
    d = r.draft
    motor = drive.point
    hinge = leg.new.place
    other = r.bodies.mechanism.link(drive.other_link_of_pair(leg.held))
    ends = (motor, hinge) if other.name == drive.link else (hinge, motor)
    ray = d.direction_between_marks(*ends)
    length = r.bodies.given_distance(other, motor, hinge)
    across = d.draw_perpendicular(ray)
    name = r.letter + leg.driven
    start = r.label(leg.known.name)
    if r.is_acceleration_plan:
        back = d.direction_back_between_marks(*ends)
        if leg.turns:
            yield (coriolis := _drive_coriolis_term(r, leg, back))
            start = coriolis.end
        inward = back if ends[0] == motor else ray
        omega = r.relative_spin_name
        means = Meaning("normal", hinge, motor)
        value = d.add_product(f"{name}^n", **{omega: 2, length: 1})
        yield (normal := Term(f"{name}^n", start, f"n_{leg.driven}", value, inward, inward, means=means))
        start = normal.end
        name = f"{name}^t"
    value = d.add_product(name, **{r.hinge_rate_name: 1, length: 1})
    yield _relative_vector_term(r, leg, name, start, value, across, across)


def _relative_vector_term(r: RatePlan, leg: Leg, name: str, start: str, length: str, along: str, action: str) -> Term:
    return Term(name, start, _end_label_of_leg(r, leg), length, along, action, means=Meaning("relative", leg.driven))


def _drive_coriolis_term(r: RatePlan, leg: Leg, across: str) -> Term:
    """Coriolis: 2ω×v of the drive."""
    name = f"a_{leg.driven}^k"
    means = Meaning("coriolis", leg.driven)
    start = r.label(leg.known.name)
    value = r.draft.add_product(name, 2.0, **{f"omega_{leg.turns}": 1, _given_relative_velocity_name(r, leg): 1})
    return Term(name, start, f"k_{leg.driven}", value, across, across, means=means)


def _given_relative_velocity_name(r: RatePlan, leg: Leg) -> str:
    """The name of the given velocity relative to the turning link."""
    if leg.drive and leg.drive.kind == "P":
        return "v_drive"
    return f"v_{leg.driven}"


def _end_label_of_leg(r: RatePlan, leg: Leg) -> str:
    return f"r_{leg.driven}" + ("'" if r.is_acceleration_plan else "")


def mark_at_drive_vector_end(r: RatePlan, leg: Leg) -> Mark:
    """The mark at the end of the drive's known vector."""
    return r.plan.mark(_end_label_of_leg(r, leg))


def draw_point_under_hinge(r: RatePlan, leg: Leg, drive: Pair) -> None:
    """Draw the point of the turning link under the hinge; measure how the other slides on it or turns."""
    assert leg.spot
    d = r.draft
    end = mark_at_drive_vector_end(r, leg)
    known = r.mark(leg.known.name)
    spot = r.mark(leg.spot.name)
    d.add_step(Carry(spot, r.mark(leg.new.name), end, known))
    d.name_segment(r.plan, POLE_LABEL, r.label(leg.spot.name), r.letter + leg.spot.name)
    r.driven.append(end)
    if drive.kind == "R":
        _state_other_link_rate(r, leg, drive)
        return
    bent = r.is_acceleration_plan and leg.turns
    middle = r.plan.mark(f"k_{leg.driven}") if bent else known
    along = f"∥{drive.guide}"
    ends = (middle, end)
    turned = (known, middle)
    under = spot
    if leg.held == drive.link:  # the slider's point is under the hinge
        ends = (end, middle)
        turned = (middle, known)
        under = r.mark(leg.new.name)
    value = d.measure_segment(f"{r.letter}slide_{drive.link}", *ends, along)
    r.slides[drive.link] = SlideReading(drive.guide, value, ends, along, turned if bent else None, under)


def _state_other_link_rate(r: RatePlan, leg: Leg, drive: Pair) -> None:
    """The other link of a motor turns at the rate of the first plus that of the drive."""
    other = drive.other_link_of_pair(leg.held)
    d = r.draft
    sign = 1.0 if other == drive.link else -1.0
    own = [Product(1.0, ((r.spin(leg.turns), 1),))] if leg.turns else []
    d.add_sum(r.spin(other), [*own, Product(sign, ((r.hinge_rate_name, 1),))])
    r.image(leg.held, BodyPoint(drive.point, drive.point))
    ray = d.direction_between_marks(drive.point, leg.new.place)
    r.turning[other] = (r.mark(drive.point), r.mark(leg.new.name), d.draw_perpendicular(ray))
