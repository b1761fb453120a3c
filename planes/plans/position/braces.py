"""A cylinder across the hinge of two links: an auxiliary figure gives the distance between their outer hinges, and the
cylinder's speed gives their relative rotation.

Its length L between the hinges Q and P of the links that turn about A has the arm h about A, so L' = ω·h; and as it is
d from the foot of that arm to P, h' = −ω·(d − d²/L), which gives ε from L''.
"""

from planes.drafting.steps import Similar
from planes.drafting.steps.crossings import CrossArcs
from planes.drafting.steps.reckoning import Drop, Product, SenseOf
from planes.plans.assur.groups import Brace, Group, Pair
from planes.plans.position.asides import Aside, aside_of_drive
from planes.plans.position.bodies import AssemblyChoice, Bodies, BraceReach
from planes.plans.position.driven_positions import (
    cylinder_distances_from_aside,
    place_hinge_on_stopped_drive,
    tie_and_drawer_by_aside_mark,
)
from planes.plans.position.positions import link_with_two_hinges
from planes.plans.position.reckoned import OwnPlace, dimension_by_way
from planes.words.names import SCHEME_PLAN, Mark, Meaning, NamePair, PlanId, scheme_mark


def place_braced(b: Bodies, g: Group) -> None:
    """The two links made rigid by the stopped cylinder, and the third."""
    assert g.drive and g.brace
    aside = aside_of_drive(b, g)
    motor, hinge, b.reach = _draw_braced_hinge_aside(aside, g, g.drive, g.brace)
    way, place = tie_and_drawer_by_aside_mark(aside, g, motor, hinge)
    place_hinge_on_stopped_drive(b, g, way)
    place()


def _draw_braced_hinge_aside(aside: Aside, g: Group, drive: Pair, brace: Brace) -> tuple[Mark, Mark, BraceReach]:
    """The braced hinge and that of the driven link, drawn aside: two arcs meet at the cylinder's far hinge."""
    b, second = aside.bodies, link_with_two_hinges(aside.bodies, drive.link, drive.point, brace.far.point)
    d = b.draft
    hinge, motor, near, far = (p.point for p in (g.inner, drive, brace.near, brace.far))
    ends = (near, far) if brace.near.link == brace.slide.other else (far, near)
    elbow = aside.mark_of_point(motor)
    other_end = aside.mark_of_point(near)
    reach, offset, length = cylinder_distances_from_aside(aside, brace.slide, ends, near)
    way = d.add_step(SenseOf(f"way_{brace.slide.guide}", reach))
    one = (second.name, elbow, b.given_distance(second, motor, far))
    other = (brace.far.link, other_end, length)
    one, other = sorted((one, other), key=lambda arc: [*b.mechanism.links].index(arc[0]))
    shape = Group((one[0], other[0]), 1, second.name, brace.far.link, brace.far, drive, brace.near)
    side = d.add_given(f"side_{far}", 1.0)
    b.choices.append(AssemblyChoice(side, far, shape, False))
    helper = Meaning("guide", motor)
    pinned = scheme_mark(f"{far}°{aside.tag}")
    d.add_step(CrossArcs(pinned, one[1], one[2], other[1], other[2], SCHEME_PLAN.mu_name, side, means=helper))
    end = pinned
    if hinge != far:
        stands = dimension_by_way(b.link_dimensions, "ratio", *(OwnPlace(second.name, p) for p in (hinge, motor, far)))
        like = d.add_computed_given(f"ratio_{hinge}_{second.name}", stands)
        end = d.draw_mark(Similar(scheme_mark(f"{hinge}°{aside.tag}"), elbow, pinned, like, means=helper))
    return elbow, end, BraceReach(way, reach, length, offset is not None)


def far_link_relative_rate(b: Bodies, plan: PlanId, name: str, drive: str, omega: str) -> str:
    """The angular velocity of the far link relative to the near one, from the ``drive``'s rate on a plan; for
    accelerations from ``omega`` too."""
    g = next(g for g in b.structure.class_two_groups if g.brace)
    r = b.reach
    d = b.draft
    brace = g.brace
    assert r and brace and g.drive
    outwards = r.offset or brace.far.link == brace.slide.link  # the line of the arm points to the far hinge
    arm, along = _cylinder_arm_and_foot(b, g.drive, brace, r.offset)
    sign = 1.0 if outwards else -1.0
    way = (arm, -1)
    grows = ((r.reach, 1), (r.length, -1)) if r.offset else ()
    if plan != "acceleration":
        return d.add_product(name, sign, **dict([(drive, 1), *grows, way]))
    terms = [Product(sign, ((drive, 1), *grows, way))]
    if r.offset:
        terms += [
            Product(1.0, (("v_drive", 2), (r.length, -1), way)),
            Product(-1.0, (("v_drive", 2), (r.reach, 2), (r.length, -3), way)),
        ]
    length = r.length if r.offset else r.reach
    terms += [Product(1.0, ((omega, 2), (along, 1), way)), Product(-sign, ((omega, 2), (along, 2), (length, -1), way))]
    return d.add_sum(name, terms)


def _cylinder_arm_and_foot(b: Bodies, drive: Pair, brace: Brace, offset: bool) -> NamePair:
    """The arm of the cylinder's line about the braced hinge, and the distance of its foot from the far hinge."""
    d = b.draft
    near = brace.near.point
    far = brace.far.point
    line = d.direction_between_marks(near, far) if offset else f"∥{brace.slide.guide}"
    pin = scheme_mark(far)
    hinge = scheme_mark(drive.point)
    arm = d.add_step(Drop(f"h_{near}{far}", pin, line, hinge, SCHEME_PLAN.mu_name))
    return arm, d.measure_segment(f"d_{near}{far}", hinge, pin, line)
