"""Groups whose basic link takes its direction from the link it slides on, and does not turn relative to it.

In a triad with one lead that slides at both ends, the two others position the basic link. The support of one of them is
shifted by the vector from its point of the basic link to the point sought: both leads then reach that one point, like
two links of a dyad.

In a group of class IV on two guides the directions of both links on guides are known. So the base is drawn aside,
anywhere on its guide, and the basic link from it by two leads, like two links of a dyad; then the figure is shifted
along the base's guide until the basic link is on its guide.
"""

from dataclasses import replace

from planes.drafting.equations import Equation, Term
from planes.drafting.steps import Carry
from planes.plans.assur.basic_links import Lead, Triad
from planes.plans.assur.contours import Contour
from planes.plans.assur.groups import Pair
from planes.plans.position.bodies import Bodies, Body, BodyPoint
from planes.plans.position.driven_positions import tie_and_drawer_of_driven_hinge
from planes.plans.position.positions import chain_through_start, draw_meeting_point, line_of_point_in_pair, place_slider
from planes.plans.position.reckoned import OwnPlace, dimension_difference, direction_between_points
from planes.plans.position.triads import first_point_of_basic_link, place_lead
from planes.words.names import SCHEME_PLAN, Meaning, NamePair, scheme_mark


def place_slid_triad(b: Bodies, g: Triad) -> None:
    """Draw the basic link, of known direction, where its other leads reach it, and the leads."""
    *leads, slid = g.leads_sliding_last
    b.leads[g.basic] = (*leads, slid)
    outer = slid.outer
    inner = slid.inner
    link = b.mechanism.links[g.basic]
    mate = b.known[outer.other_link_of_pair(slid.link)]
    along = b.guide_direction_from_axis(outer, mate.link.name, mate.axis)
    way = b.guide_direction_from_axis(inner, slid.link, b.link_axis_from_guide(outer, slid.link, along))
    axis = b.link_axis_from_guide(inner, g.basic, way)
    key = next((lead.inner.point for lead in leads if lead.inner.kind == "R"), link.first_point)
    one, two = (_leg_to_basic_link(b, g.basic, lead, key, axis) for lead in leads)
    draw_meeting_point(b, key, g, (one, two), key)
    b.draw_missing_points(Body(link, BodyPoint(key, key), axis, mate.root))
    for lead in leads:
        place_lead(b, g.basic, lead)
    first = b.mechanism.links[slid.link].first_point
    lines = (line_of_point_in_pair(b, pair, slid.link, first) for pair in (outer, inner))
    chains = [chain_through_start(first, start, along=line) for start, line in lines]
    b.draft.draw_equation(Equation(SCHEME_PLAN, (chains[0], chains[1]), f"r_{first}"))
    place_slider(b, outer, slid.link, first, along)


def _leg_to_basic_link(b: Bodies, basic: str, lead: Lead, key: str, axis: str) -> tuple[Term, Term]:
    """The leg of a lead to a point of the basic link whose axis is ``axis``."""
    outer = lead.outer
    inner = lead.inner
    if inner.kind == "P":
        along = b.guide_direction_from_axis(inner, basic, axis)
        hinge = outer.point
        start = _mark_shifted_across_guide(
            b, inner, (basic, key), (lead.link, hinge), f"{key}°{inner.guide}", hinge, along
        )
        return chain_through_start(key, start, along=along)
    hinge = inner.point
    if lead.drive:
        way, b.placers[lead] = tie_and_drawer_of_driven_hinge(b, lead.as_inner_driven_dyad(basic))
        start = mark_shifted_with_basic_link(b, basic, way.start.label, hinge, key, axis)
        return chain_through_start(key, start, way.length or None, way.along or None)
    if outer.kind == "P":
        start, along = line_of_point_in_pair(b, outer, lead.link, hinge)
        return chain_through_start(key, mark_shifted_with_basic_link(b, basic, start, hinge, key, axis), along=along)
    length = b.given_distance(b.mechanism.links[lead.link], outer.point, hinge)
    return chain_through_start(key, mark_shifted_with_basic_link(b, basic, outer.point, hinge, key, axis), length)


def _mark_shifted_across_guide(
    b: Bodies, pair: Pair, one: NamePair, other: NamePair, label: str, start: str, along: str
) -> str:
    """A mark shifted across a guide by the difference of two offsets from it, each of a link's point."""
    apart = dimension_difference(b.point_offset_from_guide(pair, *one), b.point_offset_from_guide(pair, *other))
    helper = Meaning("guide", pair.guide, one[1])
    return b.shifted_mark(label, helper, scheme_mark(start), along, apart).label


def mark_shifted_with_basic_link(b: Bodies, basic: str, start: str, hinge: str, key: str, axis: str) -> str:
    """A mark shifted by the vector from one point of the basic link to another."""
    link = b.mechanism.links[basic]
    d = b.draft
    if link.points[hinge] == link.points[key]:
        return start
    turned = direction_between_points(b.link_dimensions, OwnPlace(basic, hinge), OwnPlace(basic, key))
    ray = d.draw_turned_direction(f"{hinge}{key}", axis, turned, Meaning("along", hinge, key))
    d.rays[hinge, key] = ray
    label = f"{start}°{key}"
    length = b.given_distance(link, hinge, key)
    return d.lay_off(SCHEME_PLAN, label, scheme_mark(start), ray, length, Meaning("moved", start, key)).label


class BaseAside:
    """The auxiliary figure with its base at the beginning of its guide."""

    def __init__(self, b: Bodies, g: Contour) -> None:
        self.bodies = b
        self.group = g
        self.draft = b.draft
        self.base = b.mechanism.links[g.base]
        self.basic = b.mechanism.links[g.basic]
        self.first = self.base.first_point
        self.start, self.along = line_of_point_in_pair(b, g.outer[0], g.base, self.first)
        self.way = ""
        self.axes = {g.base: b.link_axis_from_guide(g.outer[0], g.base, self.along)}
        mate = b.known[g.outer[1].other_link_of_pair(g.basic)]
        self.way = b.guide_direction_from_axis(g.outer[1], mate.link.name, mate.axis)
        self.axes[g.basic] = b.link_axis_from_guide(g.outer[1], g.basic, self.way)

    def draw_base_and_basic_link(self) -> None:
        """Draw the base aside, the basic link by it, and both in place."""
        b = self.bodies
        d = self.draft
        g = self.group
        key = first_point_of_basic_link(b, g)
        b.leads[g.basic] = g.leads
        one, two = (self.leg_from_base_aside(lead, key) for lead in g.leads)
        aside = f"{key}°{self.first}"
        draw_meeting_point(b, key, g, (one, two), aside)
        d.steps[scheme_mark(aside)] = replace(d.steps[scheme_mark(aside)], means=Meaning("guide", key))
        start, way = line_of_point_in_pair(b, g.outer[1], g.basic, key)
        d.draw_equation(
            Equation(
                SCHEME_PLAN,
                (chain_through_start(key, aside, along=self.along), chain_through_start(key, start, along=way)),
                f"r_{key}",
            )
        )
        d.add_step(Carry(*SCHEME_PLAN.marks(self.first, key), *SCHEME_PLAN.marks(aside, self.start)))
        place_slider(b, g.outer[0], g.base, self.first, self.along)
        place_slider(b, g.outer[1], g.basic, key, way)
        for lead in g.leads:
            place_lead(b, g.basic, lead)

    def leg_from_base_aside(self, lead: Lead, key: str) -> tuple[Term, Term]:
        """The leg of a lead from the base to a point of the basic link, in the auxiliary figure."""
        b = self.bodies
        outer = lead.outer
        inner = lead.inner
        aside = f"{key}°{self.first}"
        if outer.kind == "P":
            along = b.guide_direction_from_axis(outer, self.base.name, self.axes[self.base.name])
            one = (lead.link, inner.point)
            name = f"{inner.point}°{outer.guide}′"
            start = _mark_shifted_across_guide(b, outer, one, (self.base.name, self.first), name, self.start, along)
            return chain_through_start(
                aside,
                mark_shifted_with_basic_link(b, self.basic.name, start, inner.point, key, self.basic_link_axis),
                along=along,
            )
        start = self.base_point_label(outer.point)
        if inner.kind == "P":
            along = b.guide_direction_from_axis(inner, self.basic.name, self.basic_link_axis)
            one = (self.basic.name, key)
            name = f"{key}°{inner.guide}′"
            start = _mark_shifted_across_guide(b, inner, one, (lead.link, outer.point), name, start, along)
            return chain_through_start(aside, start, along=along)
        length = b.given_distance(b.mechanism.links[lead.link], outer.point, inner.point)
        return chain_through_start(
            aside,
            mark_shifted_with_basic_link(b, self.basic.name, start, inner.point, key, self.basic_link_axis),
            length,
        )

    @property
    def basic_link_axis(self) -> str:
        """The basic link's own axis."""
        return self.axes[self.basic.name]

    def base_point_label(self, point: str) -> str:
        """The label of a point of the base in the auxiliary figure."""
        b = self.bodies
        d = self.draft
        base = self.base.name
        if point == self.first:
            return self.start
        turned = direction_between_points(b.link_dimensions, OwnPlace(base, self.first), OwnPlace(base, point))
        ray = d.draw_turned_direction(f"→{self.first}{point}", self.axes[base], turned, Meaning("given", self.first))
        length = b.given_distance(self.base, self.first, point)
        helper = Meaning("guide", point)
        return d.lay_off(SCHEME_PLAN, f"{point}°{self.first}", scheme_mark(self.start), ray, length, helper).label
