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
from planes.plans.position.bodies import SCHEME, Bodies, Body, BodyPoint, on_scheme
from planes.plans.position.driven_positions import driven_way
from planes.plans.position.positions import chain_to, meet, on_line, place_slider
from planes.plans.position.reckoned import OwnPlace, angle_deg, difference
from planes.plans.position.triads import first_reached, place_lead
from planes.words.names import Meaning, label_of


def place_slid(b: Bodies, g: Triad) -> None:
    """Draw the basic link, of known direction, where its other leads reach it, and the leads."""
    *leads, slid = g.by_slid
    b.leads[g.basic] = (*leads, slid)
    outer, inner, link = slid.outer, slid.inner, b.mechanism.links[g.basic]
    mate = b.known[outer.mate(slid.link)]
    along = b.direction_from(outer, mate.link.name, mate.axis)
    way = b.direction_from(inner, slid.link, b.axis_along(outer, slid.link, along))
    axis = b.axis_along(inner, g.basic, way)
    key = next((lead.inner.point for lead in leads if lead.inner.kind == "R"), link.first_point)
    one, two = (_reaching(b, g.basic, lead, key, axis) for lead in leads)
    meet(b, key, g, (one, two), key)
    b.place_points(Body(link, BodyPoint(key, key), axis, mate.root))
    for lead in leads:
        place_lead(b, g.basic, lead)
    first = b.mechanism.links[slid.link].first_point
    lines = (on_line(b, pair, slid.link, first) for pair in (outer, inner))
    chains = [chain_to(first, start, along=line) for start, line in lines]
    b.draft.draw(Equation(SCHEME, (chains[0], chains[1]), f"r_{first}"))
    place_slider(b, outer, slid.link, first, along)


def _reaching(b: Bodies, basic: str, lead: Lead, key: str, axis: str) -> tuple[Term, Term]:
    """The leg of a lead to a point of the basic link whose axis is ``axis``."""
    outer, inner = lead.outer, lead.inner
    if inner.kind == "P":
        along, hinge = b.direction_from(inner, basic, axis), outer.point
        start = _beside(b, inner, (basic, key), (lead.link, hinge), f"{key}°{inner.guide}", hinge, along)
        return chain_to(key, start, along=along)
    hinge = inner.point
    if lead.drive:
        way, b.placers[lead] = driven_way(b, lead.moving(basic))
        start = moved_over(b, basic, label_of(way.start), hinge, key, axis)
        return chain_to(key, start, way.length or None, way.along or None)
    if outer.kind == "P":
        start, along = on_line(b, outer, lead.link, hinge)
        return chain_to(key, moved_over(b, basic, start, hinge, key, axis), along=along)
    length = b.length(b.mechanism.links[lead.link], outer.point, hinge)
    return chain_to(key, moved_over(b, basic, outer.point, hinge, key, axis), length)


def _beside(
    b: Bodies, pair: Pair, one: tuple[str, str], other: tuple[str, str], label: str, start: str, along: str
) -> str:
    """A mark shifted across a guide by the difference of two offsets from it, each of a link's point."""
    apart, helper = difference(b.offset(pair, *one), b.offset(pair, *other)), Meaning("guide", pair.guide, one[1])
    return label_of(b.shifted(label, helper, on_scheme(start), along, apart))


def moved_over(b: Bodies, basic: str, start: str, hinge: str, key: str, axis: str) -> str:
    """A mark shifted by the vector from one point of the basic link to another."""
    link, d = b.mechanism.links[basic], b.draft
    if link.points[hinge] == link.points[key]:
        return start
    turned = angle_deg(b.shape, OwnPlace(basic, hinge), OwnPlace(basic, key))
    ray = d.turn(f"{hinge}{key}", axis, turned, Meaning("along", hinge, key))
    d.rays[SCHEME, hinge, key] = ray
    label, length = f"{start}°{key}", b.length(link, hinge, key)
    return label_of(d.lay_off(SCHEME, label, on_scheme(start), ray, length, Meaning("moved", start, key)))


class BaseAside:
    """The auxiliary figure with its base at the beginning of its guide."""

    def __init__(self, b: Bodies, g: Contour) -> None:
        self.bodies, self.group, self.draft = b, g, b.draft
        self.base, self.basic = b.mechanism.links[g.base], b.mechanism.links[g.basic]
        self.first = self.base.first_point
        (self.start, self.along), self.way = on_line(b, g.outer[0], g.base, self.first), ""
        self.axes = {g.base: b.axis_along(g.outer[0], g.base, self.along)}
        mate = b.known[g.outer[1].mate(g.basic)]
        self.way = b.direction_from(g.outer[1], mate.link.name, mate.axis)
        self.axes[g.basic] = b.axis_along(g.outer[1], g.basic, self.way)

    def place(self) -> None:
        """Draw the base aside, the basic link by it, and both in place."""
        b, d, g = self.bodies, self.draft, self.group
        key = first_reached(b, g)
        b.leads[g.basic] = g.leads
        one, two = (self.reaching(lead, key) for lead in g.leads)
        aside = f"{key}°{self.first}"
        meet(b, key, g, (one, two), aside)
        d.steps[on_scheme(aside)] = replace(d.steps[on_scheme(aside)], means=Meaning("guide", key))
        start, way = on_line(b, g.outer[1], g.basic, key)
        d.draw(Equation(SCHEME, (chain_to(key, aside, along=self.along), chain_to(key, start, along=way)), f"r_{key}"))
        d.step(Carry(on_scheme(self.first), on_scheme(key), on_scheme(aside), on_scheme(self.start)))
        place_slider(b, g.outer[0], g.base, self.first, self.along)
        place_slider(b, g.outer[1], g.basic, key, way)
        for lead in g.leads:
            place_lead(b, g.basic, lead)

    def reaching(self, lead: Lead, key: str) -> tuple[Term, Term]:
        """The leg of a lead from the base to a point of the basic link, in the auxiliary figure."""
        b, outer, inner = self.bodies, lead.outer, lead.inner
        aside = f"{key}°{self.first}"
        if outer.kind == "P":
            along = b.direction_from(outer, self.base.name, self.axes[self.base.name])
            one, name = (lead.link, inner.point), f"{inner.point}°{outer.guide}′"
            start = _beside(b, outer, one, (self.base.name, self.first), name, self.start, along)
            return chain_to(aside, moved_over(b, self.basic.name, start, inner.point, key, self.axis), along=along)
        start = self.point(outer.point)
        if inner.kind == "P":
            along = b.direction_from(inner, self.basic.name, self.axis)
            one, name = (self.basic.name, key), f"{key}°{inner.guide}′"
            start = _beside(b, inner, one, (lead.link, outer.point), name, start, along)
            return chain_to(aside, start, along=along)
        length = b.length(b.mechanism.links[lead.link], outer.point, inner.point)
        return chain_to(aside, moved_over(b, self.basic.name, start, inner.point, key, self.axis), length)

    @property
    def axis(self) -> str:
        """The basic link's own axis."""
        return self.axes[self.basic.name]

    def point(self, point: str) -> str:
        """The label of a point of the base in the auxiliary figure."""
        b, d, base = self.bodies, self.draft, self.base.name
        if point == self.first:
            return self.start
        turned = angle_deg(b.shape, OwnPlace(base, self.first), OwnPlace(base, point))
        ray = d.turn(f"→{self.first}{point}", self.axes[base], turned, Meaning("given", self.first))
        length, helper = b.length(self.base, self.first, point), Meaning("guide", point)
        return label_of(d.lay_off(SCHEME, f"{point}°{self.first}", on_scheme(self.start), ray, length, helper))
