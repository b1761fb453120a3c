"""A vector of a link laid off from a given mark: the motion of one of its points about another, as the link turns."""

from planes.drafting.steps import Image, Same
from planes.plans.motion.kinematics import Rates
from planes.plans.position.bodies import Body, BodyPoint
from planes.scene.mechanism import FRAME
from planes.words.names import SCHEME_PLAN, Mark, Meaning


def draw_carried_mark(
    r: Rates, root: Body, start: Mark, one: BodyPoint, two: BodyPoint, end: Mark, means: Meaning | None = None
) -> Mark:
    """The mark ``end`` of ``two``, with ``one`` of the same link at ``start``; the link turns as ``root`` does."""
    d = r.draft
    scheme = SCHEME_PLAN.marks(one.place, two.place)
    if root.link.name == FRAME:
        return d.draw_mark(Same(end, start, means=means))
    if root.ref:
        ends = r.mark(root.ref[0].name), r.mark(root.ref[1].name)
        like = SCHEME_PLAN.marks(root.ref[0].place, root.ref[1].place)
        return d.draw_mark(Image(end, start, scheme, like, ends, means=means))
    name, ray = (two.name + one.name, d.direction_between_marks(one.place, two.place))  # a driver with one point
    length = d.measure_segment(f"l_{name}°", *scheme)
    across = d.draw_perpendicular(ray)
    value = d.add_product(f"{r.letter}{name}°", **{r.spin(root.link.name): 1, length: 1})
    if r.is_acceleration_plan:
        inwards = d.add_product(f"a_{name}°^n", -1.0, **{f"omega_{root.link.name}": 2, length: 1})
        start = d.lay_off(r.plan, f"n_{end.label}", start, ray, inwards, means)
    return d.lay_off(r.plan, end.label, start, across, value, means)
