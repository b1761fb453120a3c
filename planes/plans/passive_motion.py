"""The motion of passive links: they are held by points drawn without them, so their rotation is measured."""

from planes.drafting.steps.reckoning import Protractor
from planes.plans.motion.kinematics import Rates
from planes.plans.position.bodies import Bodies
from planes.plans.position.reckoned import OwnPlace, direction_between_points
from planes.scene.mechanism import Link
from planes.words.frozen import frozen
from planes.words.names import ACCELERATION_PLAN, VELOCITY_PLAN, Meaning


@frozen
class LinkValues:
    """Names of a link's angle, angular velocity and angular acceleration ("" where it never turns)."""

    angle: str
    omega: str
    epsilon: str


def passive_link_values(b: Bodies, link: Link) -> LinkValues:
    """The values of a link held by two hinges, or by a hinge and a guide of the frame; their steps are added to the
    draft."""
    held = [p for p in link.points if p in b.mechanism.point_names]
    if link.slides:
        angle = b.mechanism.guide(link.slides.guide).angle_deg + (link.slides.angle_deg or 0.0)
        axis = b.draft.draw_direction_at_angle(f"x_{link.name}", angle, Meaning("own", link.name))
        return LinkValues(b.draft.add_step(Protractor(f"phi_{link.name}", axis)), "", "")
    one, two = held
    turned = direction_between_points(b.link_dimensions, OwnPlace(link.name, one), OwnPlace(link.name, two))
    ray = b.draft.direction_between_marks(one, two)
    axis = b.draft.draw_turned_direction(f"x_{link.name}", ray, -turned, Meaning("own", link.name))
    across = b.draft.draw_perpendicular(ray)
    length = b.given_distance(link, one, two)
    angle_name = b.draft.add_step(Protractor(f"phi_{link.name}", axis))
    rates = []
    for plan in (Rates(b, VELOCITY_PLAN), Rates(b, ACCELERATION_PLAN)):
        ends = plan.mark(one), plan.mark(two)
        rate = b.draft.measure_segment(f"Δ{plan.letter}{link.name}", *ends, across)
        rates.append(b.draft.add_product(plan.spin(link.name), **{rate: 1, length: -1}))
    return LinkValues(angle_name, *rates)
