"""Auxiliary figures of inner drives: the link of the drive that is on the frame is drawn in a reference position, and
the drive leads from it to the hinge of the driven link.

A link with a hinge is drawn about that, its axis level; a link that slides on the frame is drawn along its guide,
given.
"""

from planes.drafting.steps import Turn
from planes.drafting.steps.reckoning import Product
from planes.plans.assur.groups import Group, Pair
from planes.plans.position.bodies import SCHEME, Bodies
from planes.plans.position.reckoned import OwnPlace, angle_deg, difference, reckoned
from planes.scene.mechanism import Link
from planes.words.frozen import frozen
from planes.words.names import Meaning, at


@frozen
class Aside:
    """A ``link`` drawn aside: its point ``base`` at the mark ``start``, its x axis along ``axis``; ``tag`` marks its
    labels off from those of the scheme."""

    bodies: Bodies
    link: Link
    base: str
    start: str
    axis: str
    tag: str

    def spot(self, point: str) -> str:
        """The mark of a point of the link."""
        if point == self.base:
            return self.start
        b, ends = self.bodies, (OwnPlace(self.link.name, self.base), OwnPlace(self.link.name, point))
        way = b.draft.turn(f"→{self.base}{point}", self.axis, angle_deg(b.shape, *ends), Meaning("given", self.base))
        return self.lay_off(point, self.start, way, b.length(self.link, self.base, point))

    def lay_off(self, point: str, start: str, along: str, length: str) -> str:
        """A point drawn aside, by a length from a mark."""
        label = f"{point}°{self.tag}"
        return self.bodies.draft.lay_off(SCHEME, label, start, along, length, Meaning("guide", point))


def aside_of(b: Bodies, g: Group, start: str = "") -> Aside:
    """The link of a drive that is on the frame: about its hinge (from ``start``, where that does not exist yet), or by
    its guide."""
    pair, link = g.hung[0][1], b.mechanism.link(g.held)
    if pair.kind == "R":
        axis = b.draft.aim("→", 0.0, Meaning("given", link.name))
        return Aside(b, link, pair.point, start or at(SCHEME, pair.point), axis, pair.point)
    first = link.first_point
    mark, direction = b.line(pair, pair.mate(g.held))
    beside = Meaning("guide", pair.guide, first)
    shifted = b.shifted(f"{first}°{pair.guide}", beside, mark, direction, b.offset(pair, link.name, first))
    return Aside(b, link, first, shifted, b.axis_along(pair, g.held, direction), pair.guide)


def turned(aside: Aside, motor: Pair, hinge: str) -> tuple[str, str]:
    """Marks of a motor and of the hinge of the driven link: the second link is turned by the drive's angle."""
    b, first, second = aside.bodies, aside.link.name, aside.bodies.mechanism.link(motor.mate(aside.link.name))
    d, drive, elbow = b.draft, b.mechanism.drive, aside.spot(motor.point)
    turn = d.give(drive.given, drive.position)
    if drive.link == first:
        turn = d.product(f"-{turn}", -1.0, **{turn: 1})
    axis = d.step(Turn(f"→{second.name}", aside.axis, 0, turn, means=Meaning("given", motor.point)))
    way = angle_deg(b.shape, OwnPlace(second.name, motor.point), OwnPlace(second.name, hinge))
    arm = d.turn(f"→{motor.point}{hinge}", axis, way, Meaning("given", motor.point))
    return elbow, aside.lay_off(hinge, elbow, arm, b.length(second, motor.point, hinge))


def slid(aside: Aside, pair: Pair, hinge: str) -> str:
    """The mark of the hinge of the driven link: a cylinder leads to it by its length."""
    b, d, carries = aside.bodies, aside.bodies.draft, aside.link.name == pair.other
    ends = (aside.base, hinge) if carries else (hinge, aside.base)
    reach, across = reach_of(b, pair, ends)
    line = b.direction_from(pair, aside.link.name, aside.axis)
    line = line if carries else d.reversed(line)
    end = aside.lay_off(hinge, aside.start, line, reach)
    return aside.lay_off(f"{hinge}⊥", end, d.square(line), across) if across else end


def reach_of(b: Bodies, pair: Pair, ends: tuple[str, str]) -> tuple[str, str | None]:
    """The distances between points of a cylinder, of the guide's link and of the slider, along the guide and across it
    (None: zero): names of values, SI."""
    d, carrier, slider = b.draft, b.mechanism.link(pair.other), b.mechanism.link(pair.link)
    guide, origin = carrier.guides[pair.guide], OwnPlace(carrier.name, guide=pair.guide)
    foot, pin = OwnPlace(slider.name, slider.first_point), OwnPlace(slider.name, ends[1])
    more = difference(
        reckoned(b.shape, "along", foot, pin, -reckoned(b.shape, "lean", slider.name)),
        reckoned(b.shape, "along", origin, OwnPlace(carrier.name, ends[0]), reckoned(b.shape, "angle", pair.guide)),
    )
    reach = d.give(b.mechanism.drive.given, b.mechanism.drive.position)
    if ends != (guide.through_point, slider.first_point):
        apart = ends[1] + ends[0]
        assert more
        own = d.reckon(f"s_{apart}_given", more, Meaning("offset", *ends[::-1]))
        reach = d.total(f"s_{apart}", [Product(1.0, ((reach, 1),)), Product(1.0, ((own, 1),))])
    across = difference(b.offset(pair, slider.name, ends[1]), b.offset(pair, carrier.name, ends[0]))
    return reach, across and d.reckon(f"e_{''.join(ends)}", across, Meaning("offset", *ends))
