"""The scheme of a group with an inner drive: two links with a cylinder or a motor between them are drawn as one link
whose length, between its two hinges, is given by the drive; or as a slider whose hinge moves along a line shifted by
the drive."""

from collections.abc import Callable

from planes.drafting.equations import Equation
from planes.drafting.steps import Carry, Image
from planes.drafting.steps.crossings import Touch
from planes.drafting.steps.reckoning import SenseOf, SizeOf
from planes.plans.assur.groups import Group, Pair
from planes.plans.position.asides import (
    Aside,
    aside_of_drive,
    cylinder_distance_names,
    hinge_mark_by_cylinder,
    marks_after_motor_turn,
)
from planes.plans.position.bodies import Bodies, Body, BodyPoint
from planes.plans.position.positions import (
    assembly_side_name,
    body_by_two_points,
    chain_through_start,
    chain_to_new_hinge,
    coincident_point_name,
    place_link_by_hinge,
    place_slider,
)
from planes.words.frozen import frozen
from planes.words.names import NO_MARK, SCHEME_PLAN, Mark, Meaning, NamePair, scheme_mark


@frozen
class Way:
    """The tie of the driven hinge: a ``length`` from the mark ``start``, or a line ``along``."""

    start: Mark
    length: str = ""
    along: str = ""


def place_driven_links(b: Bodies, g: Group) -> None:
    """The two links of a drive and the one they move, by the same arcs and lines (засечки) as a dyad with those
    hinges."""
    way, place = tie_and_drawer_of_driven_hinge(b, g)
    place_hinge_on_stopped_drive(b, g, way)
    place()


def tie_and_drawer_of_driven_hinge(b: Bodies, g: Group, start: Mark = NO_MARK) -> tuple[Way, Callable[[], None]]:
    """The drive's tie of the hinge it moves, drawn aside (from ``start``, where the fixed hinge does not exist yet);
    and the function that draws its links once the hinges exist."""
    assert g.drive
    aside = aside_of_drive(b, g, start)
    pair = g.drive
    hinge = g.inner.point
    if pair.kind == "R":
        return tie_and_drawer_by_aside_mark(aside, g, *marks_after_motor_turn(aside, pair, hinge))
    if g.held_link_first_with_pairs[0][1].kind == "P":
        return tie_and_drawer_by_aside_mark(aside, g, NO_MARK, hinge_mark_by_cylinder(aside, pair, hinge))
    pivot = aside.base
    ends = (pivot, hinge) if g.held_link == pair.other else (hinge, pivot)
    reach, offset, length = cylinder_distances_from_aside(aside, pair, ends, pivot)

    def place() -> None:
        means = Meaning("along", pair.guide)
        marks = SCHEME_PLAN.marks(ends[0], ends[1])
        way = b.draft.add_step(SenseOf(f"way_{pair.guide}", reach))
        line = b.draft.add_step(Touch(f"∥{pair.guide}", *marks, offset, "mu_position", way, means=means))
        ref = BodyPoint(pivot, pivot), BodyPoint(hinge, coincident_point_name(b, pair.guide, hinge, g.held_link))
        b.draw_missing_points(
            Body(aside.link, ref[0], b.link_axis_from_guide(pair, g.held_link, line), g.held_link, ref)
        )
        place_slider(b, pair, pair.other_link_of_pair(g.held_link), hinge, line)

    return Way(scheme_mark(pivot), length), place


def tie_and_drawer_by_aside_mark(aside: Aside, g: Group, motor: Mark, end: Mark) -> tuple[Way, Callable[[], None]]:
    """The same for a hinge whose mark aside is ``end``; a ``motor`` leads to it, or none."""
    b = aside.bodies
    _, pair = g.held_link_first_with_pairs[0]
    if pair.kind == "P":
        return Way(
            end, along=b.guide_mark_and_direction(pair, pair.other_link_of_pair(g.held_link))[1]
        ), lambda: place_sliding_drive_links(aside, g, end, motor)
    length = b.draft.measure_segment(f"l_{aside.base}{g.inner.point}", aside.start, end)
    return Way(scheme_mark(aside.base), length), lambda: place_motor_joined_links(aside, g, motor, end)


def place_hinge_on_stopped_drive(b: Bodies, g: Group, way: Way) -> None:
    """The hinge between the stopped drive, as one link, and the link it moves."""
    hinge = g.inner.point
    link, pair = g.held_link_first_with_pairs[1]
    chains = {g.held_link: chain_through_start(hinge, way.start.label, way.length or None, way.along or None)}
    chains[link] = chain_to_new_hinge(b, link, pair, hinge)
    one, two = (chains[x] for x in (g.links if g.kind == 1 else (g.first, g.last)))
    b.draft.draw_equation(
        Equation(SCHEME_PLAN, (one, two), f"r_{hinge}", None if g.kind == 4 else assembly_side_name(b, hinge, g))
    )
    place_link_by_hinge(b, link, pair, hinge, chains[link][-1].direction)


def place_sliding_drive_links(aside: Aside, g: Group, end: Mark, motor: Mark) -> None:
    """The links of a drive that slides on the frame: the auxiliary figure is shifted so that its hinge comes to
    ``end``. A ``motor`` turns the other link; a cylinder turns neither."""
    b = aside.bodies
    pair = g.drive
    hinge = g.inner.point
    assert pair
    mate = pair.other_link_of_pair(g.held_link)
    root = b.known[g.held_link_first_with_pairs[0][1].other_link_of_pair(g.held_link)].root
    b.draft.add_step(Carry(*SCHEME_PLAN.marks(aside.base, hinge), end, aside.start))
    spot = BodyPoint(hinge, coincident_point_name(b, pair.guide, hinge, g.held_link))
    b.draw_missing_points(Body(aside.link, BodyPoint(aside.base, aside.base), aside.axis, root, moving=spot))
    place_link_by_hinge(
        b, mate, pair, hinge, None if motor else b.guide_direction_from_axis(pair, g.held_link, aside.axis)
    )


def place_motor_joined_links(aside: Aside, g: Group, turning: Mark, end: Mark) -> None:
    """Two links with a motor in the hinge between them, by similarity with the auxiliary figure: there the motor is at
    ``turning``, and their other hinge at ``end``."""
    b = aside.bodies
    pivot = aside.base
    hinge = g.inner.point
    assert g.drive
    start = scheme_mark(pivot)
    motor = g.drive.point
    shape = (aside.start, turning), (aside.start, end), (start, scheme_mark(hinge))
    b.draft.add_step(Image(scheme_mark(motor), start, *shape))
    body = body_by_two_points(b, g.held_link, pivot, motor)
    b.draw_missing_points(body)
    under = BodyPoint(hinge, coincident_point_name(b, "", hinge, g.held_link))
    body.ref = (BodyPoint(pivot, pivot), under)
    body.rigid = False
    b.draw_missing_points(body_by_two_points(b, g.drive.other_link_of_pair(g.held_link), motor, hinge))


def cylinder_distances_from_aside(aside: Aside, pair: Pair, ends: NamePair, pivot: str) -> tuple[str, str | None, str]:
    """The distances between a cylinder's hinges, of the guide's link and of the slider, along the guide and across it,
    and directly, from the auxiliary figure (the ``pivot`` is one of them): names of values, SI."""
    b = aside.bodies
    d = b.draft
    reach, offset = cylinder_distance_names(b, pair, ends)
    name = f"l_{pivot}{ends[1 - ends.index(pivot)]}"
    if offset is None:
        return reach, None, d.add_step(SizeOf(name, reach))
    helper = Meaning("guide", pair.guide)
    reached = d.lay_off(SCHEME_PLAN, f"{pivot}°{pair.guide}", aside.start, aside.axis, reach, helper)
    end = d.lay_off(SCHEME_PLAN, f"{pivot}⊥{pair.guide}′", reached, d.draw_perpendicular(aside.axis), offset, helper)
    return reach, offset, d.measure_segment(name, aside.start, end)
