"""Auxiliary figures of inner drives: the link of the drive that is on the frame is drawn in a reference position, and
the drive leads from it to the hinge of the driven link.

A link with a hinge is drawn about that, its axis level; a link that slides on the frame is drawn along its guide,
given.
"""

from planes.drafting.steps import Turn
from planes.drafting.steps.reckoning import Product
from planes.plans.assur.groups import Group, Pair
from planes.plans.position.bodies import Bodies
from planes.plans.position.reckoned import OwnPlace, dimension_by_way, dimension_difference, direction_between_points
from planes.scene.mechanism import Link
from planes.words.frozen import frozen
from planes.words.names import NO_MARK, SCHEME_PLAN, Mark, MarkPair, Meaning, NamePair, scheme_mark


@frozen
class Aside:
    """A ``link`` drawn aside: its point ``base`` at the mark ``start``, its x axis along ``axis``; ``tag`` marks its
    labels off from those of the scheme."""

    bodies: Bodies
    link: Link
    base: str
    start: Mark
    axis: str
    tag: str

    def mark_of_point(self, point: str) -> Mark:
        """The mark of a point of the link."""
        if point == self.base:
            return self.start
        b = self.bodies
        ends = (OwnPlace(self.link.name, self.base), OwnPlace(self.link.name, point))
        way = b.draft.draw_turned_direction(
            f"→{self.base}{point}",
            self.axis,
            direction_between_points(b.link_dimensions, *ends),
            Meaning("given", self.base),
        )
        return self.lay_off_point(point, self.start, way, b.given_distance(self.link, self.base, point))

    def lay_off_point(self, point: str, start: Mark, along: str, length: str) -> Mark:
        """A point drawn aside, by a length from a mark."""
        label = f"{point}°{self.tag}"
        return self.bodies.draft.lay_off(SCHEME_PLAN, label, start, along, length, Meaning("guide", point))


def aside_of_drive(b: Bodies, g: Group, start: Mark = NO_MARK) -> Aside:
    """The link of a drive that is on the frame: about its hinge (from ``start``, where that does not exist yet), or by
    its guide."""
    pair = g.held_link_first_with_pairs[0][1]
    link = b.mechanism.link(g.held_link)
    if pair.kind == "R":
        axis = b.draft.draw_direction_at_angle("→", 0.0, Meaning("given", link.name))
        return Aside(b, link, pair.point, start or scheme_mark(pair.point), axis, pair.point)
    first = link.first_point
    mark, direction = b.guide_mark_and_direction(pair, pair.other_link_of_pair(g.held_link))
    beside = Meaning("guide", pair.guide, first)
    shifted = b.shifted_mark(
        f"{first}°{pair.guide}", beside, mark, direction, b.point_offset_from_guide(pair, link.name, first)
    )
    return Aside(b, link, first, shifted, b.link_axis_from_guide(pair, g.held_link, direction), pair.guide)


def marks_after_motor_turn(aside: Aside, motor: Pair, hinge: str) -> MarkPair:
    """Marks of a motor and of the hinge of the driven link: the second link is turned by the drive's angle."""
    b = aside.bodies
    first = aside.link.name
    second = b.mechanism.link(motor.other_link_of_pair(aside.link.name))
    d = b.draft
    drive = b.mechanism.drive
    elbow = aside.mark_of_point(motor.point)
    turn = d.add_given(drive.coordinate_name, drive.position)
    if drive.link == first:
        turn = d.add_product(f"-{turn}", -1.0, **{turn: 1})
    axis = d.add_step(Turn(f"→{second.name}", aside.axis, 0, turn, means=Meaning("given", motor.point)))
    way = direction_between_points(b.link_dimensions, OwnPlace(second.name, motor.point), OwnPlace(second.name, hinge))
    arm = d.draw_turned_direction(f"→{motor.point}{hinge}", axis, way, Meaning("given", motor.point))
    return elbow, aside.lay_off_point(hinge, elbow, arm, b.given_distance(second, motor.point, hinge))


def hinge_mark_by_cylinder(aside: Aside, pair: Pair, hinge: str) -> Mark:
    """The mark of the hinge of the driven link: a cylinder leads to it by its length."""
    b = aside.bodies
    d = b.draft
    carries = aside.link.name == pair.other
    ends = (aside.base, hinge) if carries else (hinge, aside.base)
    reach, across = cylinder_distance_names(b, pair, ends)
    line = b.guide_direction_from_axis(pair, aside.link.name, aside.axis)
    line = line if carries else d.draw_reversed_direction(line)
    end = aside.lay_off_point(hinge, aside.start, line, reach)
    if across:
        return aside.lay_off_point(f"{hinge}⊥", end, d.draw_perpendicular(line), across)
    return end


def cylinder_distance_names(b: Bodies, pair: Pair, ends: NamePair) -> tuple[str, str | None]:
    """The distances between points of a cylinder, of the guide's link and of the slider, along the guide and across it
    (None: zero): names of values, SI."""
    d = b.draft
    carrier = b.mechanism.link(pair.other)
    slider = b.mechanism.link(pair.link)
    guide = carrier.guides[pair.guide]
    origin = OwnPlace(carrier.name, guide=pair.guide)
    foot = OwnPlace(slider.name, slider.first_point)
    pin = OwnPlace(slider.name, ends[1])
    more = dimension_difference(
        dimension_by_way(
            b.link_dimensions, "along", foot, pin, -dimension_by_way(b.link_dimensions, "lean", slider.name)
        ),
        dimension_by_way(
            b.link_dimensions,
            "along",
            origin,
            OwnPlace(carrier.name, ends[0]),
            dimension_by_way(b.link_dimensions, "angle", pair.guide),
        ),
    )
    reach = d.add_given(b.mechanism.drive.coordinate_name, b.mechanism.drive.position)
    if ends != (guide.through_point, slider.first_point):
        apart = ends[1] + ends[0]
        assert more
        own = d.add_computed_given(f"s_{apart}_given", more, Meaning("offset", *ends[::-1]))
        reach = d.add_sum(f"s_{apart}", [Product(1.0, ((reach, 1),)), Product(1.0, ((own, 1),))])
    across = dimension_difference(
        b.point_offset_from_guide(pair, slider.name, ends[1]), b.point_offset_from_guide(pair, carrier.name, ends[0])
    )
    return reach, across and d.add_computed_given(f"e_{''.join(ends)}", across, Meaning("offset", *ends))
