"""How each group reaches its new point: by two legs, each a pivot or a sliding pair, whatever the kind of group.

"X = Y + relative": about a pivot Y the relative velocity is perpendicular to YX; along a guide it is parallel to the
guide and Y is the coincident point of the other link. All five kinds of class II are two such legs.
"""

from planes.plans.assur.basic_links import Lead
from planes.plans.assur.groups import Group, Pair
from planes.plans.position.bodies import Bodies, BodyPoint
from planes.plans.position.positions import coincident_point_name
from planes.scene.mechanism import FRAME
from planes.words.frozen import frozen, replace
from planes.words.names import NO_MARK, POLE_LABEL, Mark, MarkPair


@frozen
class Leg:
    """One way to the new point. ``link`` carries ``known``; ``along`` is the direction of the relative velocity.

    About a pivot ``length`` names the radius, ``towards`` the direction from the new point to the pivot and ``turns``
    the link that turns about it; in a sliding pair ``pair`` is that pair, and ``slider_new`` says whether the new point
    is the slider's.
    """

    new: BodyPoint
    known: BodyPoint
    link: str
    symbol: str  # letters of the pair of points: "CB", "HL", "BB0"
    along: str
    length: str | None = None
    towards: str | None = None
    turns: str | None = None
    pair: Pair | None = None
    slider_new: bool = True
    drive: Pair | None = None  # that moves the new point relative to the ``held`` link
    held: str = ""
    spot: BodyPoint | None = None  # of that link, at the new point

    @property
    def driven(self) -> str:
        """Letters of the new point and of the coincident one: "AA1"."""
        return self.new.name + self.spot.name if self.spot else ""

    @property
    def reached(self) -> BodyPoint:
        """The point that the known one leads to: of the held link, where a drive continues from there."""
        return self.spot or self.new


@frozen
class SlideReading:
    """The data of a slider's rate along its guide: ``value`` is the segment ``ends`` ``along`` the guide; ``coriolis``
    are two marks of the acceleration plan, where the guide turns; ``under`` is the mark of the guide's point, if it is
    neither end."""

    guide: str
    value: str
    ends: MarkPair
    along: str
    coriolis: MarkPair | None = None
    under: Mark = NO_MARK


def legs_of_group(b: Bodies, g: Group) -> tuple[Leg, Leg]:
    """The two legs of a group, in the order in which the method writes them."""
    if g.drive:
        link, pair = g.held_link_first_with_pairs[1]
        driven = _leg_to_driven_hinge(b, g, g.drive)
        other = leg_by_outer_pair(b, pair, link, BodyPoint(*[g.inner.point] * 2))
        return (driven, other) if g.held_link == g.first else (other, driven)
    if g.kind in (1, 2, 4):
        new = BodyPoint(g.inner.point, g.inner.point)
        return leg_by_outer_pair(b, g.first_outer, g.first, new), leg_by_outer_pair(b, g.last_outer, g.last, new)
    inner = leg_along_inner_guide(b, g.inner, g.first, g.first_outer.point, g.last)
    return inner, leg_by_outer_pair(b, g.last_outer, g.last, inner.new)


def leg_of_lead(b: Bodies, basic: str, lead: Lead) -> Leg:
    """The leg of a lead to the new point on its basic link."""
    if lead.drive:
        return _leg_to_driven_hinge(b, lead.as_inner_driven_dyad(basic), lead.drive)
    if lead.inner.kind == "P":
        return leg_along_inner_guide(b, lead.inner, lead.link, lead.outer.point, basic)
    return leg_by_outer_pair(b, lead.outer, lead.link, BodyPoint(lead.inner.point, lead.inner.point))


def leg_along_inner_guide(b: Bodies, pair: Pair, link: str, hinge: str, new: str) -> Leg:
    """The leg from the hinge of a link to the coincident point of the ``new`` one, along the guide between them."""
    spot = BodyPoint(hinge, coincident_point_name(b, pair.guide, hinge, new))
    known = BodyPoint(hinge, hinge)
    along = f"∥{pair.guide}"
    return Leg(spot, known, link, spot.name + hinge, along, pair=pair, slider_new=pair.link == new)


def _leg_to_driven_hinge(b: Bodies, g: Group, drive: Pair) -> Leg:
    """The leg to the hinge of the driven link: with the link on the frame about its pivot or along its guide, then by
    the drive."""
    pair = g.held_link_first_with_pairs[0][1]
    mate = pair.other_link_of_pair(g.held_link)
    d = b.draft
    new = BodyPoint(g.inner.point, g.inner.point)
    spot = BodyPoint(new.place, coincident_point_name(b, drive.guide, new.place, g.held_link))
    if pair.kind == "P":
        leg = _sliding_leg(b, pair, g.held_link, mate, spot)
        symbol = f"{spot.name}{new.name}0" if mate == FRAME else leg.symbol
        return replace(leg, new=new, symbol=symbol, drive=drive, held=g.held_link, spot=spot)
    pivot = pair.point
    towards = d.direction_back_between_marks(pivot, new.place)
    turning = (
        d.draw_perpendicular(d.direction_between_marks(pivot, new.place)),
        f"l_{pivot}{new.place}",
        towards,
        g.held_link,
    )
    return Leg(
        new, BodyPoint(pivot, pivot), mate, spot.name + pivot, *turning, drive=drive, held=g.held_link, spot=spot
    )


def leg_by_outer_pair(b: Bodies, pair: Pair, link: str, new: BodyPoint) -> Leg:
    """The leg to a point of ``link`` by its pair with a solved one."""
    if pair.kind == "P":
        return _sliding_leg(b, pair, link, pair.other_link_of_pair(link), new)
    pivot = pair.point
    d = b.draft
    ray = d.direction_between_marks(pivot, new.place)
    known = BodyPoint(pivot, pivot)
    length = b.distance_of_places(b.mechanism.link(link), known, new)
    across = d.draw_perpendicular(ray)
    towards = d.direction_back_between_marks(pivot, new.place)
    return Leg(new, known, pair.other_link_of_pair(link), new.name + pivot, across, length, towards, turns=link)


def _sliding_leg(b: Bodies, pair: Pair, link: str, known: str, new: BodyPoint) -> Leg:
    if known == FRAME:
        spot = BodyPoint(POLE_LABEL, POLE_LABEL)
        symbol = f"{new.name}{new.name}0"
    else:
        spot = BodyPoint(new.place, coincident_point_name(b, pair.guide, new.place, known))
        symbol = f"{new.name}{spot.name}"
    return Leg(new, spot, known, symbol, f"∥{pair.guide}", pair=pair, slider_new=pair.link == link)
